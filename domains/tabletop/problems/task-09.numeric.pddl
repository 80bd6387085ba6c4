; Problem task-09 of the learned domain tabletop, for its encoding numeric.
; How it came about: drawn with seed 10: one random action on item-02; draw 1, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-09)
  (:domain tabletop)
  (:objects
    item-01 - any-narrow-11
    item-02 - solid-narrow-10)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.5712, 0.0236, 0.0171) m
    (= (x item-01) 2212) (= (y item-01) 3236) (= (z item-01) 0)
    ; item-02 starts at (0.7285, -0.1595, 0.0123) m
    (= (x item-02) 3785) (= (y item-02) 1405) (= (z item-02) 0))
  (:goal (and
    ; item-01 shall come to (0.5712, 0.0236, 0.0171) m, 0 mm from where it starts
    (<= (x item-01) 2667) (>= (x item-01) 1757)
    (<= (+ (x item-01) (y item-01)) 6091) (>= (+ (x item-01) (y item-01)) 4804)
    (<= (y item-01) 3691) (>= (y item-01) 2781)
    (<= (y item-01) (+ (x item-01) 1667)) (<= (+ (x item-01) 380) (y item-01))
    (>= (z item-01) 0) (<= (z item-01) 0)
    ; item-02 shall come to (0.7522, -0.2468, 0.0123) m, 90 mm from where it starts
    (<= (x item-02) 4477) (>= (x item-02) 3567)
    (<= (+ (x item-02) (y item-02)) 5197) (>= (+ (x item-02) (y item-02)) 3910)
    (<= (y item-02) 987) (>= (y item-02) 77)
    (<= (+ (y item-02) 2846) (x item-02)) (<= (x item-02) (+ (y item-02) 4134))
    (>= (z item-02) 0) (<= (z item-02) 0)))
  (:metric minimize (total-cost)))
