; Problem errand of the learned domain tabletop, for its encoding numeric.
; How it came about: seed 7.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem errand)
  (:domain tabletop-numeric)
  (:objects
    item-01 - block
    item-02 - tray)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.4512, 0.0133, 0.0250) m
    (= (x item-01) 1512) (= (y item-01) 3133) (= (z item-01) 0)
    ; item-02 starts at (0.6000, -0.1000, 0.0200) m
    (= (x item-02) 3000) (= (y item-02) 2000) (= (z item-02) 0))
  (:goal (and
    ; item-01 shall come to (0.5350, -0.0200, 0.2280) m, 222 mm from where it starts
    (<= (x item-01) 2805) (>= (x item-01) 1895)
    (<= (+ (x item-01) (y item-01)) 5794) (>= (+ (x item-01) (y item-01)) 4506)
    (<= (y item-01) 3255) (>= (y item-01) 2345)
    (<= (y item-01) (+ (x item-01) 1094)) (<= (x item-01) (+ (y item-01) 194))
    (>= (z item-01) 2030) (<= (z item-01) 2030)
    ; item-02 shall come to (0.5450, -0.0870, 0.0200) m, 57 mm from where it starts
    (<= (x item-02) 2905) (>= (x item-02) 1995)
    (<= (+ (x item-02) (y item-02)) 5224) (>= (+ (x item-02) (y item-02)) 3936)
    (<= (y item-02) 2585) (>= (y item-02) 1675)
    (<= (y item-02) (+ (x item-02) 324)) (<= (x item-02) (+ (y item-02) 964))
    (>= (z item-02) 0) (<= (z item-02) 0)))
  (:metric minimize (total-cost)))
