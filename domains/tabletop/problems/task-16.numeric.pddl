; Problem task-16 of the learned domain tabletop, for its encoding numeric.
; How it came about: drawn with seed 17: 3 random actions on item-02, item-02, item-02; draw 2, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-16)
  (:domain tabletop)
  (:objects
    item-01 - any-narrow-11
    item-02 - solid-narrow-10
    item-03 - hollow-tall-wide-01
    item-04 - solid-narrow-10)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.5438, -0.1485, 0.0352) m
    (= (x item-01) 1938) (= (y item-01) 1515) (= (z item-01) 0)
    ; item-02 starts at (0.9150, -0.1374, 0.0320) m
    (= (x item-02) 5650) (= (y item-02) 1626) (= (z item-02) 0)
    ; item-03 starts at (0.6233, 0.1590, 0.0266) m
    (= (x item-03) 2733) (= (y item-03) 4590) (= (z item-03) 0)
    ; item-04 starts at (0.8022, 0.0325, 0.0114) m
    (= (x item-04) 4522) (= (y item-04) 3325) (= (z item-04) 0))
  (:goal (and
    ; item-01 shall come to (0.5438, -0.1485, 0.0352) m, 0 mm from where it starts
    (<= (x item-01) 2393) (>= (x item-01) 1483)
    (<= (+ (x item-01) (y item-01)) 4097) (>= (+ (x item-01) (y item-01)) 2809)
    (<= (y item-01) 1970) (>= (y item-01) 1060)
    (<= (y item-01) (+ (x item-01) 221)) (<= (x item-01) (+ (y item-01) 1066))
    (>= (z item-01) 0) (<= (z item-01) 0)
    ; item-02 shall come to (0.8750, -0.2052, 0.0320) m, 79 mm from where it starts
    (<= (x item-02) 5705) (>= (x item-02) 4795)
    (<= (+ (x item-02) (y item-02)) 6841) (>= (+ (x item-02) (y item-02)) 5553)
    (<= (y item-02) 1402) (>= (y item-02) 492)
    (<= (+ (y item-02) 3659) (x item-02)) (<= (x item-02) (+ (y item-02) 4946))
    (>= (z item-02) 0) (<= (z item-02) 0)
    ; item-03 shall come to (0.6233, 0.1590, 0.0267) m, 0 mm from where it starts
    (<= (x item-03) 3188) (>= (x item-03) 2278)
    (<= (+ (x item-03) (y item-03)) 7967) (>= (+ (x item-03) (y item-03)) 6679)
    (<= (y item-03) 5045) (>= (y item-03) 4135)
    (<= (y item-03) (+ (x item-03) 2501)) (<= (+ (x item-03) 1213) (y item-03))
    (>= (z item-03) 0) (<= (z item-03) 0)
    ; item-04 shall come to (0.8022, 0.0325, 0.0114) m, 0 mm from where it starts
    (<= (x item-04) 4977) (>= (x item-04) 4067)
    (<= (+ (x item-04) (y item-04)) 8491) (>= (+ (x item-04) (y item-04)) 7204)
    (<= (y item-04) 3780) (>= (y item-04) 2871)
    (<= (+ (y item-04) 553) (x item-04)) (<= (x item-04) (+ (y item-04) 1840))
    (>= (z item-04) 0) (<= (z item-04) 0)))
  (:metric minimize (total-cost)))
