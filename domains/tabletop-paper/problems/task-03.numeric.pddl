; Problem task-03 of the learned domain tabletop-paper, for its encoding numeric.
; How it came about: drawn with seed 4: one random action on item-01; draw 3, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-03)
  (:domain tabletop-paper-numeric)
  (:objects
    item-01 - hollow-tall-wide-01)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.7832, 0.0401, 0.0239) m
    (= (x item-01) 4332) (= (y item-01) 3401) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.1456 0.1456 0.04781 2).
    ; Not for item-01:
    ; lift-100-hollow-tall-wide-01: keeps its promise with such objects in about 4 of 30 only.
    ; lift-101-hollow-tall-wide-01: keeps its promise with such objects in about 3 of 30 only.
    (can-lift-000-hollow-tall-wide-01 item-01) (= (x-of-lift-000-hollow-tall-wide-01 item-01) 10016) (= (y-of-lift-000-hollow-tall-wide-01 item-01) 10950) (= (z-of-lift-000-hollow-tall-wide-01 item-01) 12207) (= (cost-of-lift-000-hollow-tall-wide-01 item-01) 4)
    (= (x-of-put-down-lift-000-hollow-tall-wide-01 item-01) 9994) (= (y-of-put-down-lift-000-hollow-tall-wide-01 item-01) 9963) (= (z-of-put-down-lift-000-hollow-tall-wide-01 item-01) 7793)
    (can-lift-000b-hollow-tall-wide-01 item-01) (= (x-of-lift-000b-hollow-tall-wide-01 item-01) 10066) (= (y-of-lift-000b-hollow-tall-wide-01 item-01) 10382) (= (z-of-lift-000b-hollow-tall-wide-01 item-01) 12480) (= (cost-of-lift-000b-hollow-tall-wide-01 item-01) 4)
    (= (x-of-put-down-lift-000b-hollow-tall-wide-01 item-01) 9999) (= (y-of-put-down-lift-000b-hollow-tall-wide-01 item-01) 9968) (= (z-of-put-down-lift-000b-hollow-tall-wide-01 item-01) 7520)
    (= (x-of-lift-100-hollow-tall-wide-01 item-01) 9752) (= (y-of-lift-100-hollow-tall-wide-01 item-01) 9129) (= (z-of-lift-100-hollow-tall-wide-01 item-01) 11988) (= (cost-of-lift-100-hollow-tall-wide-01 item-01) 187)
    (= (x-of-put-down-lift-100-hollow-tall-wide-01 item-01) 9994) (= (y-of-put-down-lift-100-hollow-tall-wide-01 item-01) 9963) (= (z-of-put-down-lift-100-hollow-tall-wide-01 item-01) 8012)
    (can-lift-100b-hollow-tall-wide-01 item-01) (= (x-of-lift-100b-hollow-tall-wide-01 item-01) 9614) (= (y-of-lift-100b-hollow-tall-wide-01 item-01) 10707) (= (z-of-lift-100b-hollow-tall-wide-01 item-01) 11988) (= (cost-of-lift-100b-hollow-tall-wide-01 item-01) 4)
    (= (x-of-put-down-lift-100b-hollow-tall-wide-01 item-01) 9996) (= (y-of-put-down-lift-100b-hollow-tall-wide-01 item-01) 9979) (= (z-of-put-down-lift-100b-hollow-tall-wide-01 item-01) 8012)
    (= (x-of-lift-101-hollow-tall-wide-01 item-01) 9656) (= (y-of-lift-101-hollow-tall-wide-01 item-01) 8800) (= (z-of-lift-101-hollow-tall-wide-01 item-01) 12364) (= (cost-of-lift-101-hollow-tall-wide-01 item-01) 209)
    (= (x-of-put-down-lift-101-hollow-tall-wide-01 item-01) 10006) (= (y-of-put-down-lift-101-hollow-tall-wide-01 item-01) 9970) (= (z-of-put-down-lift-101-hollow-tall-wide-01 item-01) 7636)
    (can-lift-101a-hollow-tall-wide-01 item-01) (= (x-of-lift-101a-hollow-tall-wide-01 item-01) 10017) (= (y-of-lift-101a-hollow-tall-wide-01 item-01) 9282) (= (z-of-lift-101a-hollow-tall-wide-01 item-01) 12010) (= (cost-of-lift-101a-hollow-tall-wide-01 item-01) 4)
    (= (x-of-put-down-lift-101a-hollow-tall-wide-01 item-01) 9997) (= (y-of-put-down-lift-101a-hollow-tall-wide-01 item-01) 9964) (= (z-of-put-down-lift-101a-hollow-tall-wide-01 item-01) 7990)
    (can-pull-left-010b-hollow-tall-wide-01 item-01) (= (x-of-pull-left-010b-hollow-tall-wide-01 item-01) 9714) (= (y-of-pull-left-010b-hollow-tall-wide-01 item-01) 10245) (= (cost-of-pull-left-010b-hollow-tall-wide-01 item-01) 4)
    (can-push-forward-right-111b-hollow-tall-wide-01 item-01) (= (x-of-push-forward-right-111b-hollow-tall-wide-01 item-01) 10436) (= (y-of-push-forward-right-111b-hollow-tall-wide-01 item-01) 9660) (= (cost-of-push-forward-right-111b-hollow-tall-wide-01 item-01) 4)
    (can-push-left-011b-hollow-tall-wide-01 item-01) (= (x-of-push-left-011b-hollow-tall-wide-01 item-01) 10306) (= (y-of-push-left-011b-hollow-tall-wide-01 item-01) 10662) (= (cost-of-push-left-011b-hollow-tall-wide-01 item-01) 4)
    (can-push-right-001b-hollow-tall-wide-01 item-01) (= (x-of-push-right-001b-hollow-tall-wide-01 item-01) 10145) (= (y-of-push-right-001b-hollow-tall-wide-01 item-01) 9141) (= (cost-of-push-right-001b-hollow-tall-wide-01 item-01) 4)
    (can-push-right-100-hollow-tall-wide-01 item-01) (= (x-of-push-right-100-hollow-tall-wide-01 item-01) 9980) (= (y-of-push-right-100-hollow-tall-wide-01 item-01) 9649) (= (cost-of-push-right-100-hollow-tall-wide-01 item-01) 64)
    (can-push-right-101-hollow-tall-wide-01 item-01) (= (x-of-push-right-101-hollow-tall-wide-01 item-01) 10051) (= (y-of-push-right-101-hollow-tall-wide-01 item-01) 9253) (= (cost-of-push-right-101-hollow-tall-wide-01 item-01) 117)
    (can-push-right-110b-hollow-tall-wide-01 item-01) (= (x-of-push-right-110b-hollow-tall-wide-01 item-01) 9609) (= (y-of-push-right-110b-hollow-tall-wide-01 item-01) 9248) (= (cost-of-push-right-110b-hollow-tall-wide-01 item-01) 4))
  (:goal (and
    ; item-01 shall come to (0.7755, 0.0952, 0.0239) m, 56 mm from where it starts
    (<= (x item-01) 4711) (>= (x item-01) 3801)
    (<= (+ (x item-01) (y item-01)) 8852) (>= (+ (x item-01) (y item-01)) 7565)
    (<= (y item-01) 4408) (>= (y item-01) 3498)
    (<= (y item-01) (+ (x item-01) 341)) (<= (x item-01) (+ (y item-01) 946))
    (>= (z item-01) 0) (<= (z item-01) 0)))
  (:metric minimize (total-cost)))
