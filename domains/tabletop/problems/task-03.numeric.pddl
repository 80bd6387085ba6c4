; Problem task-03 of the learned domain tabletop, for its encoding numeric.
; How it came about: drawn with seed 4: one random action on item-01; draw 3, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-03)
  (:domain tabletop)
  (:objects
    item-01 - hollow-tall-wide-01)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.7832, 0.0401, 0.0239) m
    (= (x item-01) 4332) (= (y item-01) 3401) (= (z item-01) 0))
  (:goal (and
    ; item-01 shall come to (0.7755, 0.0952, 0.0239) m, 56 mm from where it starts
    (<= (x item-01) 4711) (>= (x item-01) 3801)
    (<= (+ (x item-01) (y item-01)) 8852) (>= (+ (x item-01) (y item-01)) 7565)
    (<= (y item-01) 4408) (>= (y item-01) 3498)
    (<= (y item-01) (+ (x item-01) 341)) (<= (x item-01) (+ (y item-01) 946))
    (>= (z item-01) 0) (<= (z item-01) 0)))
  (:metric minimize (total-cost)))
