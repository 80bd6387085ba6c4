; Problem task-15 of the learned domain tabletop, for its encoding numeric.
; How it came about: drawn with seed 16: 3 random actions on item-04, item-01, item-02; draw 2, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-15)
  (:domain tabletop)
  (:objects
    item-01 - solid-narrow-10
    item-02 - any-narrow-11
    item-03 - solid-narrow-10
    item-04 - any-narrow-11)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.4321, 0.0694, 0.0132) m
    (= (x item-01) 821) (= (y item-01) 3694) (= (z item-01) 0)
    ; item-02 starts at (0.6321, -0.1446, 0.0368) m
    (= (x item-02) 2821) (= (y item-02) 1554) (= (z item-02) 0)
    ; item-03 starts at (0.7617, -0.0541, 0.0164) m
    (= (x item-03) 4117) (= (y item-03) 2459) (= (z item-03) 0)
    ; item-04 starts at (0.7632, 0.1102, 0.0286) m
    (= (x item-04) 4132) (= (y item-04) 4102) (= (z item-04) 0))
  (:goal (and
    ; item-01 shall come to (0.4317, 0.0835, 0.0132) m, 14 mm from where it starts
    (<= (x item-01) 1272) (>= (x item-01) 362)
    (<= (+ (x item-01) (y item-01)) 5296) (>= (+ (x item-01) (y item-01)) 4009)
    (<= (y item-01) 4290) (>= (y item-01) 3380)
    (<= (y item-01) (+ (x item-01) 3662)) (<= (+ (x item-01) 2375) (y item-01))
    (>= (z item-01) 0) (<= (z item-01) 0)
    ; item-02 shall come to (0.5906, -0.1934, 0.3084) m, 279 mm from where it starts
    (<= (x item-02) 2742) (>= (x item-02) 2071)
    (<= (+ (x item-02) (y item-02)) 3947) (>= (+ (x item-02) (y item-02)) 2998)
    (<= (y item-02) 1402) (>= (y item-02) 731)
    (<= (+ (y item-02) 865) (x item-02)) (<= (x item-02) (+ (y item-02) 1815))
    (>= (z item-02) 2381) (<= (z item-02) 2381)
    ; item-03 shall come to (0.7617, -0.0540, 0.0164) m, 0 mm from where it starts
    (<= (x item-03) 4572) (>= (x item-03) 3662)
    (<= (+ (x item-03) (y item-03)) 7220) (>= (+ (x item-03) (y item-03)) 5933)
    (<= (y item-03) 2914) (>= (y item-03) 2004)
    (<= (+ (y item-03) 1014) (x item-03)) (<= (x item-03) (+ (y item-03) 2301))
    (>= (z item-03) 0) (<= (z item-03) 0)
    ; item-04 shall come to (0.7387, 0.0935, 0.0286) m, 30 mm from where it starts
    (<= (x item-04) 4341) (>= (x item-04) 3432)
    (<= (+ (x item-04) (y item-04)) 8465) (>= (+ (x item-04) (y item-04)) 7178)
    (<= (y item-04) 4390) (>= (y item-04) 3480)
    (<= (y item-04) (+ (x item-04) 692)) (<= (x item-04) (+ (y item-04) 595))
    (>= (z item-04) 0) (<= (z item-04) 0)))
  (:metric minimize (total-cost)))
