; Problem task-06 of the learned domain tabletop-paper, for its encoding numeric.
; How it came about: drawn with seed 7: 2 random actions on item-01, item-01; draw 1, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-06)
  (:domain tabletop-paper-numeric)
  (:objects
    item-01 - hollow-tall-wide-01)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.7202, -0.0966, 0.0284) m
    (= (x item-01) 3702) (= (y item-01) 2034) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.1698 0.1698 0.0569 2).
    ; Not for item-01:
    ; push-right-101-hollow-tall-wide-01: keeps its promise in 1 of 30 rehearsals only.
    (can-lift-000-hollow-tall-wide-01 item-01) (= (x-of-lift-000-hollow-tall-wide-01 item-01) 9969) (= (y-of-lift-000-hollow-tall-wide-01 item-01) 11076) (= (z-of-lift-000-hollow-tall-wide-01 item-01) 12244) (= (cost-of-lift-000-hollow-tall-wide-01 item-01) 4)
    (= (x-of-put-down-lift-000-hollow-tall-wide-01 item-01) 9999) (= (y-of-put-down-lift-000-hollow-tall-wide-01 item-01) 9969) (= (z-of-put-down-lift-000-hollow-tall-wide-01 item-01) 7756)
    (can-lift-000b-hollow-tall-wide-01 item-01) (= (x-of-lift-000b-hollow-tall-wide-01 item-01) 10047) (= (y-of-lift-000b-hollow-tall-wide-01 item-01) 10502) (= (z-of-lift-000b-hollow-tall-wide-01 item-01) 12522) (= (cost-of-lift-000b-hollow-tall-wide-01 item-01) 4)
    (= (x-of-put-down-lift-000b-hollow-tall-wide-01 item-01) 10001) (= (y-of-put-down-lift-000b-hollow-tall-wide-01 item-01) 9970) (= (z-of-put-down-lift-000b-hollow-tall-wide-01 item-01) 7478)
    (can-lift-100-hollow-tall-wide-01 item-01) (= (x-of-lift-100-hollow-tall-wide-01 item-01) 9550) (= (y-of-lift-100-hollow-tall-wide-01 item-01) 8966) (= (z-of-lift-100-hollow-tall-wide-01 item-01) 12029) (= (cost-of-lift-100-hollow-tall-wide-01 item-01) 70)
    (= (x-of-put-down-lift-100-hollow-tall-wide-01 item-01) 9999) (= (y-of-put-down-lift-100-hollow-tall-wide-01 item-01) 9972) (= (z-of-put-down-lift-100-hollow-tall-wide-01 item-01) 7971)
    (can-lift-100b-hollow-tall-wide-01 item-01) (= (x-of-lift-100b-hollow-tall-wide-01 item-01) 9499) (= (y-of-lift-100b-hollow-tall-wide-01 item-01) 10825) (= (z-of-lift-100b-hollow-tall-wide-01 item-01) 11976) (= (cost-of-lift-100b-hollow-tall-wide-01 item-01) 4)
    (= (x-of-put-down-lift-100b-hollow-tall-wide-01 item-01) 10002) (= (y-of-put-down-lift-100b-hollow-tall-wide-01 item-01) 9972) (= (z-of-put-down-lift-100b-hollow-tall-wide-01 item-01) 8024)
    (can-lift-101-hollow-tall-wide-01 item-01) (= (x-of-lift-101-hollow-tall-wide-01 item-01) 9627) (= (y-of-lift-101-hollow-tall-wide-01 item-01) 8675) (= (z-of-lift-101-hollow-tall-wide-01 item-01) 12488) (= (cost-of-lift-101-hollow-tall-wide-01 item-01) 11)
    (= (x-of-put-down-lift-101-hollow-tall-wide-01 item-01) 10007) (= (y-of-put-down-lift-101-hollow-tall-wide-01 item-01) 9975) (= (z-of-put-down-lift-101-hollow-tall-wide-01 item-01) 7512)
    (can-lift-101a-hollow-tall-wide-01 item-01) (= (x-of-lift-101a-hollow-tall-wide-01 item-01) 10003) (= (y-of-lift-101a-hollow-tall-wide-01 item-01) 9159) (= (z-of-lift-101a-hollow-tall-wide-01 item-01) 12010) (= (cost-of-lift-101a-hollow-tall-wide-01 item-01) 4)
    (= (x-of-put-down-lift-101a-hollow-tall-wide-01 item-01) 9999) (= (y-of-put-down-lift-101a-hollow-tall-wide-01 item-01) 9962) (= (z-of-put-down-lift-101a-hollow-tall-wide-01 item-01) 7990)
    (can-pull-left-010b-hollow-tall-wide-01 item-01) (= (x-of-pull-left-010b-hollow-tall-wide-01 item-01) 9686) (= (y-of-pull-left-010b-hollow-tall-wide-01 item-01) 10244) (= (cost-of-pull-left-010b-hollow-tall-wide-01 item-01) 4)
    (can-push-forward-right-111b-hollow-tall-wide-01 item-01) (= (x-of-push-forward-right-111b-hollow-tall-wide-01 item-01) 10426) (= (y-of-push-forward-right-111b-hollow-tall-wide-01 item-01) 9662) (= (cost-of-push-forward-right-111b-hollow-tall-wide-01 item-01) 4)
    (can-push-left-011b-hollow-tall-wide-01 item-01) (= (x-of-push-left-011b-hollow-tall-wide-01 item-01) 10288) (= (y-of-push-left-011b-hollow-tall-wide-01 item-01) 10784) (= (cost-of-push-left-011b-hollow-tall-wide-01 item-01) 4)
    (can-push-right-001b-hollow-tall-wide-01 item-01) (= (x-of-push-right-001b-hollow-tall-wide-01 item-01) 10115) (= (y-of-push-right-001b-hollow-tall-wide-01 item-01) 9023) (= (cost-of-push-right-001b-hollow-tall-wide-01 item-01) 4)
    (can-push-right-100-hollow-tall-wide-01 item-01) (= (x-of-push-right-100-hollow-tall-wide-01 item-01) 9962) (= (y-of-push-right-100-hollow-tall-wide-01 item-01) 9667) (= (cost-of-push-right-100-hollow-tall-wide-01 item-01) 70)
    (= (x-of-push-right-101-hollow-tall-wide-01 item-01) 10224) (= (y-of-push-right-101-hollow-tall-wide-01 item-01) 9217) (= (cost-of-push-right-101-hollow-tall-wide-01 item-01) 278)
    (can-push-right-110b-hollow-tall-wide-01 item-01) (= (x-of-push-right-110b-hollow-tall-wide-01 item-01) 9662) (= (y-of-push-right-110b-hollow-tall-wide-01 item-01) 9133) (= (cost-of-push-right-110b-hollow-tall-wide-01 item-01) 4))
  (:goal (and
    ; item-01 shall come to (0.7098, -0.1422, 0.2290) m, 206 mm from where it starts
    (<= (x item-01) 3997) (>= (x item-01) 3199)
    (<= (+ (x item-01) (y item-01)) 5740) (>= (+ (x item-01) (y item-01)) 4611)
    (<= (y item-01) 1977) (>= (y item-01) 1179)
    (<= (+ (y item-01) 1455) (x item-01)) (<= (x item-01) (+ (y item-01) 2585))
    (>= (z item-01) 1976) (<= (z item-01) 2244)))
  (:metric minimize (total-cost)))
