; Problem task-10 of the learned domain tabletop-paper, in numbers.
; How it came about: drawn with seed 11: one random action on item-02; draw 15, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for lies inside that by as
; much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-10)
  (:domain tabletop-paper-numeric)
  (:objects
    item-01 item-02 - solid-narrow-10
    m-100c-lift-item-01 m-100c-lift-down-item-01 m-110-item-01 m-010c-item-01 m-100c-item-01 m-001-item-01 m-111-item-01 m-100c-lift-item-02 m-100c-lift-down-item-02 m-101-lift-item-02 m-101-lift-down-item-02 m-110-item-02 m-010c-item-02 m-001-item-02 m-111-item-02 m-011c-item-02 - motion)
  (:init
    (hand-empty)
    ; item-01 lies at (0.5652, -0.1483, 0.0470) m at first
    (lifts item-01 m-100c-lift-item-01)
    (lowers m-100c-lift-down-item-01 m-100c-lift-item-01)
    (pushes item-01 m-110-item-01) (pushes item-01 m-010c-item-01) (pushes item-01 m-100c-item-01) (pushes item-01 m-001-item-01) (pushes item-01 m-111-item-01)
    ; item-02 lies at (0.7614, 0.1304, 0.0252) m at first
    (lifts item-02 m-100c-lift-item-02)
    (lowers m-100c-lift-down-item-02 m-100c-lift-item-02)
    (lifts item-02 m-101-lift-item-02)
    (lowers m-101-lift-down-item-02 m-101-lift-item-02)
    (pushes item-02 m-110-item-02) (pushes item-02 m-010c-item-02) (pushes item-02 m-001-item-02) (pushes item-02 m-111-item-02) (pushes item-02 m-011c-item-02)
    (= (x item-01) 2152) (= (y item-01) 1517) (= (z item-01) 0)
    (= (along-x m-100c-lift-item-01) 9415) (= (along-y m-100c-lift-item-01) 9732) (= (along-z m-100c-lift-item-01) 12221)
    (= (along-x m-100c-lift-down-item-01) 10004) (= (along-y m-100c-lift-down-item-01) 9987) (= (along-z m-100c-lift-down-item-01) 7779)
    (= (along-x m-110-item-01) 9321) (= (along-y m-110-item-01) 9742) (= (along-z m-110-item-01) 10000)
    (= (along-x m-010c-item-01) 9777) (= (along-y m-010c-item-01) 10152) (= (along-z m-010c-item-01) 10000)
    (= (along-x m-100c-item-01) 9459) (= (along-y m-100c-item-01) 9477) (= (along-z m-100c-item-01) 10000)
    (= (along-x m-001-item-01) 10818) (= (along-y m-001-item-01) 9853) (= (along-z m-001-item-01) 10000)
    (= (along-x m-111-item-01) 10149) (= (along-y m-111-item-01) 9770) (= (along-z m-111-item-01) 10000)
    (= (x item-02) 4114) (= (y item-02) 4304) (= (z item-02) 0)
    (= (along-x m-100c-lift-item-02) 9399) (= (along-y m-100c-lift-item-02) 9671) (= (along-z m-100c-lift-item-02) 12280)
    (= (along-x m-100c-lift-down-item-02) 9995) (= (along-y m-100c-lift-down-item-02) 9972) (= (along-z m-100c-lift-down-item-02) 7720)
    (= (along-x m-101-lift-item-02) 9864) (= (along-y m-101-lift-item-02) 9496) (= (along-z m-101-lift-item-02) 12508)
    (= (along-x m-101-lift-down-item-02) 10020) (= (along-y m-101-lift-down-item-02) 9998) (= (along-z m-101-lift-down-item-02) 7492)
    (= (along-x m-110-item-02) 9314) (= (along-y m-110-item-02) 9656) (= (along-z m-110-item-02) 10000)
    (= (along-x m-010c-item-02) 9782) (= (along-y m-010c-item-02) 10145) (= (along-z m-010c-item-02) 10000)
    (= (along-x m-001-item-02) 10897) (= (along-y m-001-item-02) 10186) (= (along-z m-001-item-02) 10000)
    (= (along-x m-111-item-02) 10196) (= (along-y m-111-item-02) 9714) (= (along-z m-111-item-02) 10000)
    (= (along-x m-011c-item-02) 10085) (= (along-y m-011c-item-02) 10350) (= (along-z m-011c-item-02) 10000)
    (= (total-cost) 0) (= (cost m-100c-lift-item-01) 78) (= (cost m-100c-lift-down-item-01) 0) (= (cost m-110-item-01) 4) (= (cost m-010c-item-01) 4) (= (cost m-100c-item-01) 90) (= (cost m-001-item-01) 9) (= (cost m-111-item-01) 4) (= (cost m-100c-lift-item-02) 73) (= (cost m-100c-lift-down-item-02) 0) (= (cost m-101-lift-item-02) 9) (= (cost m-101-lift-down-item-02) 0) (= (cost m-110-item-02) 4) (= (cost m-010c-item-02) 4) (= (cost m-001-item-02) 9) (= (cost m-111-item-02) 4) (= (cost m-011c-item-02) 4)
  )
  (:goal (and (<= (x item-01) 2607) (>= (x item-01) 1697) (<= (+ (x item-01) (y item-01)) 4313) (>= (+ (x item-01) (y item-01)) 3026) (<= (y item-01) 1972) (>= (y item-01) 1062) (<= (y item-01) (+ (x item-01) 9)) (<= (x item-01) (+ (y item-01) 1279)) (>= (z item-01) 0) (<= (z item-01) 0) (<= (x item-02) 4388) (>= (x item-02) 3479) (<= (+ (x item-02) (y item-02)) 8354) (>= (+ (x item-02) (y item-02)) 7067) (<= (y item-02) 4232) (>= (y item-02) 3322) (<= (y item-02) (+ (x item-02) 487)) (<= (x item-02) (+ (y item-02) 800)) (>= (z item-02) 0) (<= (z item-02) 0)))
  (:metric minimize (total-cost)))
