; Problem task-08 of the learned domain tabletop, for its encoding numeric.
; How it came about: drawn with seed 9: one random action on item-02; draw 6, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-08)
  (:domain tabletop)
  (:objects
    item-01 - hollow-wide-00
    item-02 - hollow-wide-00)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.6815, -0.0945, 0.0145) m
    (= (x item-01) 3315) (= (y item-01) 2055) (= (z item-01) 0)
    ; item-02 starts at (0.8090, 0.1030, 0.0159) m
    (= (x item-02) 4590) (= (y item-02) 4030) (= (z item-02) 0))
  (:goal (and
    ; item-01 shall come to (0.6531, -0.1119, 0.0145) m, 33 mm from where it starts
    (<= (x item-01) 3485) (>= (x item-01) 2575)
    (<= (+ (x item-01) (y item-01)) 5555) (>= (+ (x item-01) (y item-01)) 4268)
    (<= (y item-01) 2336) (>= (y item-01) 1426)
    (<= (+ (y item-01) 505) (x item-01)) (<= (x item-01) (+ (y item-01) 1792))
    (>= (z item-01) 0) (<= (z item-01) 0)
    ; item-02 shall come to (0.7643, 0.0120, 0.0159) m, 101 mm from where it starts
    (<= (x item-02) 4598) (>= (x item-02) 3688)
    (<= (+ (x item-02) (y item-02)) 7907) (>= (+ (x item-02) (y item-02)) 6620)
    (<= (y item-02) 3576) (>= (y item-02) 2666)
    (<= (+ (y item-02) 378) (x item-02)) (<= (x item-02) (+ (y item-02) 1666))
    (>= (z item-02) 0) (<= (z item-02) 0)))
  (:metric minimize (total-cost)))
