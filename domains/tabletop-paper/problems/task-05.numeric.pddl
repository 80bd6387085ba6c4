; Problem task-05 of the learned domain tabletop-paper, in numbers.
; How it came about: drawn with seed 6: 2 random actions on item-01, item-01; draw 3, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for lies inside that by as
; much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-05)
  (:domain tabletop-paper-numeric)
  (:objects
    item-01 - solid-narrow-10
    m-110-item-01 m-010c-item-01 m-100c-item-01 m-001-item-01 m-000c-item-01 m-101-item-01 m-111-item-01 m-011c-item-01 - motion)
  (:init
    (hand-empty)
    ; item-01 lies at (0.6269, 0.1197, 0.0113) m at first
    (pushes item-01 m-110-item-01) (pushes item-01 m-010c-item-01) (pushes item-01 m-100c-item-01) (pushes item-01 m-001-item-01) (pushes item-01 m-000c-item-01) (pushes item-01 m-101-item-01) (pushes item-01 m-111-item-01) (pushes item-01 m-011c-item-01)
    (= (x item-01) 2769) (= (y item-01) 4197) (= (z item-01) 0)
    (= (along-x m-110-item-01) 9267) (= (along-y m-110-item-01) 9740) (= (along-z m-110-item-01) 10000)
    (= (along-x m-010c-item-01) 9794) (= (along-y m-010c-item-01) 10126) (= (along-z m-010c-item-01) 10000)
    (= (along-x m-100c-item-01) 9756) (= (along-y m-100c-item-01) 9626) (= (along-z m-100c-item-01) 10000)
    (= (along-x m-001-item-01) 10868) (= (along-y m-001-item-01) 9817) (= (along-z m-001-item-01) 10000)
    (= (along-x m-000c-item-01) 10372) (= (along-y m-000c-item-01) 10282) (= (along-z m-000c-item-01) 10000)
    (= (along-x m-101-item-01) 10261) (= (along-y m-101-item-01) 9627) (= (along-z m-101-item-01) 10000)
    (= (along-x m-111-item-01) 10210) (= (along-y m-111-item-01) 9668) (= (along-z m-111-item-01) 10000)
    (= (along-x m-011c-item-01) 10145) (= (along-y m-011c-item-01) 10601) (= (along-z m-011c-item-01) 10000)
    (= (total-cost) 0) (= (cost m-110-item-01) 4) (= (cost m-010c-item-01) 4) (= (cost m-100c-item-01) 12) (= (cost m-001-item-01) 9) (= (cost m-000c-item-01) 63) (= (cost m-101-item-01) 63) (= (cost m-111-item-01) 4) (= (cost m-011c-item-01) 4)
  )
  (:goal (and (<= (x item-01) 3163) (>= (x item-01) 3164) (<= (+ (x item-01) (y item-01)) 6912) (>= (+ (x item-01) (y item-01)) 6913) (<= (y item-01) 3748) (>= (y item-01) 3749) (<= (y item-01) (+ (x item-01) 585)) (<= (+ (x item-01) 586) (y item-01)) (>= (z item-01) 1) (<= (z item-01) 1)))
  (:metric minimize (total-cost)))
