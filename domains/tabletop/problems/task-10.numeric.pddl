; Problem task-10 of the learned domain tabletop, for its encoding numeric.
; How it came about: drawn with seed 11: one random action on item-02; draw 15, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-10)
  (:domain tabletop)
  (:objects
    item-01 - solid-narrow-10
    item-02 - solid-narrow-10)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.5652, -0.1483, 0.0470) m
    (= (x item-01) 2152) (= (y item-01) 1517) (= (z item-01) 0)
    ; item-02 starts at (0.7614, 0.1304, 0.0252) m
    (= (x item-02) 4114) (= (y item-02) 4304) (= (z item-02) 0))
  (:goal (and
    ; item-01 shall come to (0.5652, -0.1483, 0.0470) m, 0 mm from where it starts
    (<= (x item-01) 2607) (>= (x item-01) 1697)
    (<= (+ (x item-01) (y item-01)) 4313) (>= (+ (x item-01) (y item-01)) 3026)
    (<= (y item-01) 1972) (>= (y item-01) 1062)
    (<= (y item-01) (+ (x item-01) 9)) (<= (x item-01) (+ (y item-01) 1279))
    (>= (z item-01) 0) (<= (z item-01) 0)
    ; item-02 shall come to (0.7434, 0.0777, 0.0251) m, 56 mm from where it starts
    (<= (x item-02) 4388) (>= (x item-02) 3479)
    (<= (+ (x item-02) (y item-02)) 8354) (>= (+ (x item-02) (y item-02)) 7067)
    (<= (y item-02) 4232) (>= (y item-02) 3322)
    (<= (y item-02) (+ (x item-02) 487)) (<= (x item-02) (+ (y item-02) 800))
    (>= (z item-02) 0) (<= (z item-02) 0)))
  (:metric minimize (total-cost)))
