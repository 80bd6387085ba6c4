; Problem task-04 of the learned domain tabletop, for its encoding numeric.
; How it came about: drawn with seed 5: one random action on item-01; draw 6, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-04)
  (:domain tabletop)
  (:objects
    item-01 - hollow-tall-wide-01)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.5941, -0.0363, 0.0220) m
    (= (x item-01) 2441) (= (y item-01) 2637) (= (z item-01) 0))
  (:goal (and
    ; item-01 shall come to (0.5828, -0.0295, 0.2220) m, 200 mm from where it starts
    (<= (x item-01) 2743) (>= (x item-01) 1913)
    (<= (+ (x item-01) (y item-01)) 5620) (>= (+ (x item-01) (y item-01)) 4446)
    (<= (y item-01) 3120) (>= (y item-01) 2290)
    (<= (y item-01) (+ (x item-01) 963)) (<= (x item-01) (+ (y item-01) 210))
    (>= (z item-01) 2040) (<= (z item-01) 2203)))
  (:metric minimize (total-cost)))
