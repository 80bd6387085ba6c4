; Problem task-02 of the learned domain tabletop, for its encoding numeric.
; How it came about: drawn with seed 3: one random action on item-01; draw 3, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-02)
  (:domain tabletop)
  (:objects
    item-01 - hollow-wide-00)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.5286, 0.0250, 0.0435) m
    (= (x item-01) 1786) (= (y item-01) 3250) (= (z item-01) 0))
  (:goal (and
    ; item-01 shall come to (0.4756, 0.0588, 0.2666) m, 232 mm from where it starts
    (<= (x item-01) 1659) (>= (x item-01) 852)
    (<= (+ (x item-01) (y item-01)) 5414) (>= (+ (x item-01) (y item-01)) 4272)
    (<= (y item-01) 3991) (>= (y item-01) 3184)
    (<= (y item-01) (+ (x item-01) 2904)) (<= (+ (x item-01) 1762) (y item-01))
    (>= (z item-01) 2002) (<= (z item-01) 2366)))
  (:metric minimize (total-cost)))
