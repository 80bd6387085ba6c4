; Problem task-03 of the learned domain tabletop-paper, in numbers.
; How it came about: drawn with seed 4: one random action on item-01; draw 3, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for lies inside that by as
; much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-03)
  (:domain tabletop-paper-numeric)
  (:objects
    item-01 - hollow-tall-wide-01
    m-000-item-01 m-000-down-item-01 m-000b-item-01 m-000b-down-item-01 m-100b-item-01 m-100b-down-item-01 m-101a-item-01 m-101a-down-item-01 m-010b-item-01 m-111b-item-01 m-011b-item-01 m-001b-item-01 m-100-push-item-01 m-101-push-item-01 m-110b-item-01 - motion)
  (:init
    (hand-empty)
    ; item-01 lies at (0.7832, 0.0401, 0.0239) m at first
    (lifts item-01 m-000-item-01)
    (lowers m-000-down-item-01 m-000-item-01)
    (lifts item-01 m-000b-item-01)
    (lowers m-000b-down-item-01 m-000b-item-01)
    (lifts item-01 m-100b-item-01)
    (lowers m-100b-down-item-01 m-100b-item-01)
    (lifts item-01 m-101a-item-01)
    (lowers m-101a-down-item-01 m-101a-item-01)
    (pushes item-01 m-010b-item-01) (pushes item-01 m-111b-item-01) (pushes item-01 m-011b-item-01) (pushes item-01 m-001b-item-01) (pushes item-01 m-100-push-item-01) (pushes item-01 m-101-push-item-01) (pushes item-01 m-110b-item-01)
    (= (x item-01) 4332) (= (y item-01) 3401) (= (z item-01) 0)
    (= (along-x m-000-item-01) 10016) (= (along-y m-000-item-01) 10950) (= (along-z m-000-item-01) 12207)
    (= (along-x m-000-down-item-01) 9994) (= (along-y m-000-down-item-01) 9963) (= (along-z m-000-down-item-01) 7793)
    (= (along-x m-000b-item-01) 10066) (= (along-y m-000b-item-01) 10382) (= (along-z m-000b-item-01) 12480)
    (= (along-x m-000b-down-item-01) 9999) (= (along-y m-000b-down-item-01) 9968) (= (along-z m-000b-down-item-01) 7520)
    (= (along-x m-100b-item-01) 9614) (= (along-y m-100b-item-01) 10707) (= (along-z m-100b-item-01) 11988)
    (= (along-x m-100b-down-item-01) 9996) (= (along-y m-100b-down-item-01) 9979) (= (along-z m-100b-down-item-01) 8012)
    (= (along-x m-101a-item-01) 10017) (= (along-y m-101a-item-01) 9282) (= (along-z m-101a-item-01) 12010)
    (= (along-x m-101a-down-item-01) 9997) (= (along-y m-101a-down-item-01) 9964) (= (along-z m-101a-down-item-01) 7990)
    (= (along-x m-010b-item-01) 9714) (= (along-y m-010b-item-01) 10245) (= (along-z m-010b-item-01) 10000)
    (= (along-x m-111b-item-01) 10436) (= (along-y m-111b-item-01) 9660) (= (along-z m-111b-item-01) 10000)
    (= (along-x m-011b-item-01) 10306) (= (along-y m-011b-item-01) 10662) (= (along-z m-011b-item-01) 10000)
    (= (along-x m-001b-item-01) 10145) (= (along-y m-001b-item-01) 9141) (= (along-z m-001b-item-01) 10000)
    (= (along-x m-100-push-item-01) 9980) (= (along-y m-100-push-item-01) 9649) (= (along-z m-100-push-item-01) 10000)
    (= (along-x m-101-push-item-01) 10051) (= (along-y m-101-push-item-01) 9253) (= (along-z m-101-push-item-01) 10000)
    (= (along-x m-110b-item-01) 9609) (= (along-y m-110b-item-01) 9248) (= (along-z m-110b-item-01) 10000)
    (= (total-cost) 0) (= (cost m-000-item-01) 4) (= (cost m-000-down-item-01) 0) (= (cost m-000b-item-01) 4) (= (cost m-000b-down-item-01) 0) (= (cost m-100b-item-01) 4) (= (cost m-100b-down-item-01) 0) (= (cost m-101a-item-01) 4) (= (cost m-101a-down-item-01) 0) (= (cost m-010b-item-01) 4) (= (cost m-111b-item-01) 4) (= (cost m-011b-item-01) 4) (= (cost m-001b-item-01) 4) (= (cost m-100-push-item-01) 64) (= (cost m-101-push-item-01) 117) (= (cost m-110b-item-01) 4)
  )
  (:goal (and (<= (x item-01) 4710) (>= (x item-01) 3801) (<= (+ (x item-01) (y item-01)) 8852) (>= (+ (x item-01) (y item-01)) 7565) (<= (y item-01) 4408) (>= (y item-01) 3498) (<= (y item-01) (+ (x item-01) 341)) (<= (x item-01) (+ (y item-01) 946)) (>= (z item-01) 0) (<= (z item-01) 0)))
  (:metric minimize (total-cost)))
