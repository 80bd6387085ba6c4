; Problem task-02 of the learned domain tabletop-paper, for its encoding numeric.
; How it came about: drawn with seed 3: one random action on item-01; draw 3, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-02)
  (:domain tabletop-paper-numeric)
  (:objects
    item-01 - hollow-00)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.5286, 0.0250, 0.0435) m
    (= (x item-01) 1786) (= (y item-01) 3250) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.09307 0.1357 0.08707 1).
    ; Not for item-01:
    ; pull-110a-hollow-00: keeps its promise in 2 of 30 rehearsals only.
    ; push-forward-left-011a-hollow-00: scatters more than it moves.
    ; push-left-000-hollow-00: keeps its promise with such objects in about 5 of 30 only.
    (can-lift-000-hollow-00 item-01) (= (x-of-lift-000-hollow-00 item-01) 10096) (= (y-of-lift-000-hollow-00 item-01) 10992) (= (z-of-lift-000-hollow-00 item-01) 12203) (= (cost-of-lift-000-hollow-00 item-01) 22)
    (= (x-of-put-down-lift-000-hollow-00 item-01) 10015) (= (y-of-put-down-lift-000-hollow-00 item-01) 9991) (= (z-of-put-down-lift-000-hollow-00 item-01) 7797)
    (can-lift-000a-hollow-00 item-01) (= (x-of-lift-000a-hollow-00 item-01) 10475) (= (y-of-lift-000a-hollow-00 item-01) 10819) (= (z-of-lift-000a-hollow-00 item-01) 12643) (= (cost-of-lift-000a-hollow-00 item-01) 4)
    (= (x-of-put-down-lift-000a-hollow-00 item-01) 10005) (= (y-of-put-down-lift-000a-hollow-00 item-01) 9975) (= (z-of-put-down-lift-000a-hollow-00 item-01) 7357)
    (can-lift-011a-hollow-00 item-01) (= (x-of-lift-011a-hollow-00 item-01) 10380) (= (y-of-lift-011a-hollow-00 item-01) 10294) (= (z-of-lift-011a-hollow-00 item-01) 12001) (= (cost-of-lift-011a-hollow-00 item-01) 99)
    (= (x-of-put-down-lift-011a-hollow-00 item-01) 10007) (= (y-of-put-down-lift-011a-hollow-00 item-01) 10008) (= (z-of-put-down-lift-011a-hollow-00 item-01) 7999)
    (can-lift-100a-hollow-00 item-01) (= (x-of-lift-100a-hollow-00 item-01) 9588) (= (y-of-lift-100a-hollow-00 item-01) 10649) (= (z-of-lift-100a-hollow-00 item-01) 11992) (= (cost-of-lift-100a-hollow-00 item-01) 4)
    (= (x-of-put-down-lift-100a-hollow-00 item-01) 10001) (= (y-of-put-down-lift-100a-hollow-00 item-01) 9979) (= (z-of-put-down-lift-100a-hollow-00 item-01) 8008)
    (can-lift-101a-hollow-00 item-01) (= (x-of-lift-101a-hollow-00 item-01) 10010) (= (y-of-lift-101a-hollow-00 item-01) 9370) (= (z-of-lift-101a-hollow-00 item-01) 12001) (= (cost-of-lift-101a-hollow-00 item-01) 4)
    (= (x-of-put-down-lift-101a-hollow-00 item-01) 9998) (= (y-of-put-down-lift-101a-hollow-00 item-01) 9981) (= (z-of-put-down-lift-101a-hollow-00 item-01) 7999)
    (can-lift-110a-hollow-00 item-01) (= (x-of-lift-110a-hollow-00 item-01) 9613) (= (y-of-lift-110a-hollow-00 item-01) 10127) (= (z-of-lift-110a-hollow-00 item-01) 11999) (= (cost-of-lift-110a-hollow-00 item-01) 11)
    (= (x-of-put-down-lift-110a-hollow-00 item-01) 10000) (= (y-of-put-down-lift-110a-hollow-00 item-01) 10006) (= (z-of-put-down-lift-110a-hollow-00 item-01) 8001)
    (= (x-of-pull-110a-hollow-00 item-01) 9598) (= (y-of-pull-110a-hollow-00 item-01) 10118) (= (cost-of-pull-110a-hollow-00 item-01) 238)
    (can-pull-right-111a-hollow-00 item-01) (= (x-of-pull-right-111a-hollow-00 item-01) 9871) (= (y-of-pull-right-111a-hollow-00 item-01) 9964) (= (cost-of-pull-right-111a-hollow-00 item-01) 4)
    (= (x-of-push-forward-left-011a-hollow-00 item-01) 10083) (= (y-of-push-forward-left-011a-hollow-00 item-01) 10098) (= (cost-of-push-forward-left-011a-hollow-00 item-01) 48)
    (can-push-forward-right-001a-hollow-00 item-01) (= (x-of-push-forward-right-001a-hollow-00 item-01) 10188) (= (y-of-push-forward-right-001a-hollow-00 item-01) 9600) (= (cost-of-push-forward-right-001a-hollow-00 item-01) 4)
    (= (x-of-push-left-000-hollow-00 item-01) 9991) (= (y-of-push-left-000-hollow-00 item-01) 10256) (= (cost-of-push-left-000-hollow-00 item-01) 168)
    (can-push-left-010a-hollow-00 item-01) (= (x-of-push-left-010a-hollow-00 item-01) 9859) (= (y-of-push-left-010a-hollow-00 item-01) 10436) (= (cost-of-push-left-010a-hollow-00 item-01) 11)
    (can-push-left-011-hollow-00 item-01) (= (x-of-push-left-011-hollow-00 item-01) 10047) (= (y-of-push-left-011-hollow-00 item-01) 10837) (= (cost-of-push-left-011-hollow-00 item-01) 11)
    (can-push-right-111-hollow-00 item-01) (= (x-of-push-right-111-hollow-00 item-01) 10063) (= (y-of-push-right-111-hollow-00 item-01) 9839) (= (cost-of-push-right-111-hollow-00 item-01) 7))
  (:goal (and
    ; item-01 shall come to (0.4756, 0.0588, 0.2666) m, 232 mm from where it starts
    (<= (x item-01) 1654) (>= (x item-01) 857)
    (<= (+ (x item-01) (y item-01)) 5407) (>= (+ (x item-01) (y item-01)) 4279)
    (<= (y item-01) 3987) (>= (y item-01) 3189)
    (<= (y item-01) (+ (x item-01) 2897)) (<= (+ (x item-01) 1769) (y item-01))
    (>= (z item-01) 1992) (<= (z item-01) 2203)))
  (:metric minimize (total-cost)))
