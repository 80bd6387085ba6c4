; Problem task-01 of the learned domain tabletop, for its encoding numeric.
; How it came about: drawn with seed 2: one random action on item-01; draw 3, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-01)
  (:domain tabletop)
  (:objects
    item-01 - solid-narrow-10)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.6312, -0.0864, 0.0432) m
    (= (x item-01) 2812) (= (y item-01) 2136) (= (z item-01) 0))
  (:goal (and
    ; item-01 shall come to (0.6877, -0.0637, 0.0432) m, 61 mm from where it starts
    (<= (x item-01) 3832) (>= (x item-01) 2923)
    (<= (+ (x item-01) (y item-01)) 6385) (>= (+ (x item-01) (y item-01)) 5097)
    (<= (y item-01) 2818) (>= (y item-01) 1909)
    (<= (+ (y item-01) 371) (x item-01)) (<= (x item-01) (+ (y item-01) 1658))
    (>= (z item-01) 0) (<= (z item-01) 0)))
  (:metric minimize (total-cost)))
