; Problem task-07 of the learned domain tabletop, for its encoding numeric.
; How it came about: drawn with seed 8: one random action on item-02; draw 5, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-07)
  (:domain tabletop)
  (:objects
    item-01 - any-narrow-11
    item-02 - hollow-wide-00)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.6189, -0.0203, 0.0491) m
    (= (x item-01) 2689) (= (y item-01) 2797) (= (z item-01) 0)
    ; item-02 starts at (0.6145, 0.1177, 0.0189) m
    (= (x item-02) 2645) (= (y item-02) 4177) (= (z item-02) 0))
  (:goal (and
    ; item-01 shall come to (0.6189, -0.0203, 0.0491) m, 0 mm from where it starts
    (<= (x item-01) 3144) (>= (x item-01) 2234)
    (<= (+ (x item-01) (y item-01)) 6129) (>= (+ (x item-01) (y item-01)) 4842)
    (<= (y item-01) 3252) (>= (y item-01) 2342)
    (<= (y item-01) (+ (x item-01) 752)) (<= (x item-01) (+ (y item-01) 535))
    (>= (z item-01) 0) (<= (z item-01) 0)
    ; item-02 shall come to (0.6065, 0.1674, 0.0189) m, 50 mm from where it starts
    (<= (x item-02) 3020) (>= (x item-02) 2110)
    (<= (+ (x item-02) (y item-02)) 7883) (>= (+ (x item-02) (y item-02)) 6595)
    (<= (y item-02) 5129) (>= (y item-02) 4219)
    (<= (y item-02) (+ (x item-02) 2752)) (<= (+ (x item-02) 1465) (y item-02))
    (>= (z item-02) 0) (<= (z item-02) 0)))
  (:metric minimize (total-cost)))
