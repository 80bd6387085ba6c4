; Problem task-10 of the learned domain tabletop-paper, for its encoding numeric.
; How it came about: drawn with seed 11: one random action on item-02; draw 15, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-10)
  (:domain tabletop-paper-numeric)
  (:objects
    item-01 - solid-narrow-10
    item-02 - solid-narrow-10)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.5652, -0.1483, 0.0470) m
    (= (x item-01) 2152) (= (y item-01) 1517) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.04286 0.1237 0.09397 1).
    ; Not for item-01:
    ; lift-101-solid-narrow-10: keeps its promise in 1 of 37 rehearsals only.
    ; push-forward-left-000c-solid-narrow-10: scatters more than it moves.
    ; push-forward-right-101-solid-narrow-10: scatters more than it moves.
    ; push-left-011c-solid-narrow-10: scatters more than it moves.
    (can-lift-100c-solid-narrow-10 item-01) (= (x-of-lift-100c-solid-narrow-10 item-01) 9415) (= (y-of-lift-100c-solid-narrow-10 item-01) 9732) (= (z-of-lift-100c-solid-narrow-10 item-01) 12221) (= (cost-of-lift-100c-solid-narrow-10 item-01) 78)
    (= (x-of-put-down-lift-100c-solid-narrow-10 item-01) 10004) (= (y-of-put-down-lift-100c-solid-narrow-10 item-01) 9987) (= (z-of-put-down-lift-100c-solid-narrow-10 item-01) 7779)
    (= (x-of-lift-101-solid-narrow-10 item-01) 9677) (= (y-of-lift-101-solid-narrow-10 item-01) 8843) (= (z-of-lift-101-solid-narrow-10 item-01) 12091) (= (cost-of-lift-101-solid-narrow-10 item-01) 298)
    (= (x-of-put-down-lift-101-solid-narrow-10 item-01) 10011) (= (y-of-put-down-lift-101-solid-narrow-10 item-01) 9969) (= (z-of-put-down-lift-101-solid-narrow-10 item-01) 7909)
    (can-pull-110-solid-narrow-10 item-01) (= (x-of-pull-110-solid-narrow-10 item-01) 9321) (= (y-of-pull-110-solid-narrow-10 item-01) 9742) (= (cost-of-pull-110-solid-narrow-10 item-01) 4)
    (can-pull-left-010c-solid-narrow-10 item-01) (= (x-of-pull-left-010c-solid-narrow-10 item-01) 9777) (= (y-of-pull-left-010c-solid-narrow-10 item-01) 10152) (= (cost-of-pull-left-010c-solid-narrow-10 item-01) 4)
    (can-pull-right-100c-solid-narrow-10 item-01) (= (x-of-pull-right-100c-solid-narrow-10 item-01) 9459) (= (y-of-pull-right-100c-solid-narrow-10 item-01) 9477) (= (cost-of-pull-right-100c-solid-narrow-10 item-01) 90)
    (can-push-forward-001-solid-narrow-10 item-01) (= (x-of-push-forward-001-solid-narrow-10 item-01) 10818) (= (y-of-push-forward-001-solid-narrow-10 item-01) 9853) (= (cost-of-push-forward-001-solid-narrow-10 item-01) 9)
    (= (x-of-push-forward-left-000c-solid-narrow-10 item-01) 10187) (= (y-of-push-forward-left-000c-solid-narrow-10 item-01) 10025) (= (cost-of-push-forward-left-000c-solid-narrow-10 item-01) 148)
    (= (x-of-push-forward-right-101-solid-narrow-10 item-01) 10075) (= (y-of-push-forward-right-101-solid-narrow-10 item-01) 9746) (= (cost-of-push-forward-right-101-solid-narrow-10 item-01) 50)
    (can-push-forward-right-111-solid-narrow-10 item-01) (= (x-of-push-forward-right-111-solid-narrow-10 item-01) 10149) (= (y-of-push-forward-right-111-solid-narrow-10 item-01) 9770) (= (cost-of-push-forward-right-111-solid-narrow-10 item-01) 4)
    (= (x-of-push-left-011c-solid-narrow-10 item-01) 10014) (= (y-of-push-left-011c-solid-narrow-10 item-01) 10110) (= (cost-of-push-left-011c-solid-narrow-10 item-01) 4)
    ; item-02 starts at (0.7614, 0.1304, 0.0252) m
    (= (x item-02) 4114) (= (y item-02) 4304) (= (z item-02) 0)
    ; What each operator promises for item-02 (features 0.05018 0.07866 0.05032 1).
    ; Not for item-02:
    ; pull-right-100c-solid-narrow-10: scatters more than it moves.
    ; push-forward-left-000c-solid-narrow-10: scatters more than it moves.
    ; push-forward-right-101-solid-narrow-10: keeps its promise in 2 of 37 rehearsals only.
    (can-lift-100c-solid-narrow-10 item-02) (= (x-of-lift-100c-solid-narrow-10 item-02) 9399) (= (y-of-lift-100c-solid-narrow-10 item-02) 9671) (= (z-of-lift-100c-solid-narrow-10 item-02) 12280) (= (cost-of-lift-100c-solid-narrow-10 item-02) 73)
    (= (x-of-put-down-lift-100c-solid-narrow-10 item-02) 9995) (= (y-of-put-down-lift-100c-solid-narrow-10 item-02) 9972) (= (z-of-put-down-lift-100c-solid-narrow-10 item-02) 7720)
    (can-lift-101-solid-narrow-10 item-02) (= (x-of-lift-101-solid-narrow-10 item-02) 9864) (= (y-of-lift-101-solid-narrow-10 item-02) 9496) (= (z-of-lift-101-solid-narrow-10 item-02) 12508) (= (cost-of-lift-101-solid-narrow-10 item-02) 9)
    (= (x-of-put-down-lift-101-solid-narrow-10 item-02) 10020) (= (y-of-put-down-lift-101-solid-narrow-10 item-02) 9998) (= (z-of-put-down-lift-101-solid-narrow-10 item-02) 7492)
    (can-pull-110-solid-narrow-10 item-02) (= (x-of-pull-110-solid-narrow-10 item-02) 9314) (= (y-of-pull-110-solid-narrow-10 item-02) 9656) (= (cost-of-pull-110-solid-narrow-10 item-02) 4)
    (can-pull-left-010c-solid-narrow-10 item-02) (= (x-of-pull-left-010c-solid-narrow-10 item-02) 9782) (= (y-of-pull-left-010c-solid-narrow-10 item-02) 10145) (= (cost-of-pull-left-010c-solid-narrow-10 item-02) 4)
    (= (x-of-pull-right-100c-solid-narrow-10 item-02) 9716) (= (y-of-pull-right-100c-solid-narrow-10 item-02) 9819) (= (cost-of-pull-right-100c-solid-narrow-10 item-02) 84)
    (can-push-forward-001-solid-narrow-10 item-02) (= (x-of-push-forward-001-solid-narrow-10 item-02) 10897) (= (y-of-push-forward-001-solid-narrow-10 item-02) 10186) (= (cost-of-push-forward-001-solid-narrow-10 item-02) 9)
    (= (x-of-push-forward-left-000c-solid-narrow-10 item-02) 10243) (= (y-of-push-forward-left-000c-solid-narrow-10 item-02) 10095) (= (cost-of-push-forward-left-000c-solid-narrow-10 item-02) 24)
    (= (x-of-push-forward-right-101-solid-narrow-10 item-02) 10177) (= (y-of-push-forward-right-101-solid-narrow-10 item-02) 9522) (= (cost-of-push-forward-right-101-solid-narrow-10 item-02) 257)
    (can-push-forward-right-111-solid-narrow-10 item-02) (= (x-of-push-forward-right-111-solid-narrow-10 item-02) 10196) (= (y-of-push-forward-right-111-solid-narrow-10 item-02) 9714) (= (cost-of-push-forward-right-111-solid-narrow-10 item-02) 4)
    (can-push-left-011c-solid-narrow-10 item-02) (= (x-of-push-left-011c-solid-narrow-10 item-02) 10085) (= (y-of-push-left-011c-solid-narrow-10 item-02) 10350) (= (cost-of-push-left-011c-solid-narrow-10 item-02) 4))
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
