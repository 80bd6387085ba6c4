; Problem task-05 of the learned domain tabletop-paper, for its encoding numeric.
; How it came about: drawn with seed 6: 2 random actions on item-01, item-01; draw 3, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-05)
  (:domain tabletop-paper-numeric)
  (:objects
    item-01 - solid-narrow-10)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.6269, 0.1197, 0.0113) m
    (= (x item-01) 2769) (= (y item-01) 4197) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.05625 0.1067 0.02264 0).
    ; Not for item-01:
    ; lift-100c-solid-narrow-10: keeps its promise in 2 of 37 rehearsals only.
    ; lift-101-solid-narrow-10: keeps its promise with such objects in about 6 of 37 only.
    (= (x-of-lift-100c-solid-narrow-10 item-01) 9433) (= (y-of-lift-100c-solid-narrow-10 item-01) 9751) (= (z-of-lift-100c-solid-narrow-10 item-01) 12200) (= (cost-of-lift-100c-solid-narrow-10 item-01) 257)
    (= (x-of-put-down-lift-100c-solid-narrow-10 item-01) 10007) (= (y-of-put-down-lift-100c-solid-narrow-10 item-01) 9992) (= (z-of-put-down-lift-100c-solid-narrow-10 item-01) 7800)
    (= (x-of-lift-101-solid-narrow-10 item-01) 9850) (= (y-of-lift-101-solid-narrow-10 item-01) 9494) (= (z-of-lift-101-solid-narrow-10 item-01) 12341) (= (cost-of-lift-101-solid-narrow-10 item-01) 173)
    (= (x-of-put-down-lift-101-solid-narrow-10 item-01) 9998) (= (y-of-put-down-lift-101-solid-narrow-10 item-01) 9998) (= (z-of-put-down-lift-101-solid-narrow-10 item-01) 7659)
    (can-pull-110-solid-narrow-10 item-01) (= (x-of-pull-110-solid-narrow-10 item-01) 9267) (= (y-of-pull-110-solid-narrow-10 item-01) 9740) (= (cost-of-pull-110-solid-narrow-10 item-01) 4)
    (can-pull-left-010c-solid-narrow-10 item-01) (= (x-of-pull-left-010c-solid-narrow-10 item-01) 9794) (= (y-of-pull-left-010c-solid-narrow-10 item-01) 10126) (= (cost-of-pull-left-010c-solid-narrow-10 item-01) 4)
    (can-pull-right-100c-solid-narrow-10 item-01) (= (x-of-pull-right-100c-solid-narrow-10 item-01) 9756) (= (y-of-pull-right-100c-solid-narrow-10 item-01) 9626) (= (cost-of-pull-right-100c-solid-narrow-10 item-01) 12)
    (can-push-forward-001-solid-narrow-10 item-01) (= (x-of-push-forward-001-solid-narrow-10 item-01) 10868) (= (y-of-push-forward-001-solid-narrow-10 item-01) 9817) (= (cost-of-push-forward-001-solid-narrow-10 item-01) 9)
    (can-push-forward-left-000c-solid-narrow-10 item-01) (= (x-of-push-forward-left-000c-solid-narrow-10 item-01) 10372) (= (y-of-push-forward-left-000c-solid-narrow-10 item-01) 10282) (= (cost-of-push-forward-left-000c-solid-narrow-10 item-01) 63)
    (can-push-forward-right-101-solid-narrow-10 item-01) (= (x-of-push-forward-right-101-solid-narrow-10 item-01) 10261) (= (y-of-push-forward-right-101-solid-narrow-10 item-01) 9627) (= (cost-of-push-forward-right-101-solid-narrow-10 item-01) 63)
    (can-push-forward-right-111-solid-narrow-10 item-01) (= (x-of-push-forward-right-111-solid-narrow-10 item-01) 10210) (= (y-of-push-forward-right-111-solid-narrow-10 item-01) 9668) (= (cost-of-push-forward-right-111-solid-narrow-10 item-01) 4)
    (can-push-left-011c-solid-narrow-10 item-01) (= (x-of-push-left-011c-solid-narrow-10 item-01) 10145) (= (y-of-push-left-011c-solid-narrow-10 item-01) 10601) (= (cost-of-push-left-011c-solid-narrow-10 item-01) 4))
  (:goal (and
    ; item-01 shall come to (0.6664, 0.0750, 0.2117) m, 209 mm from where it starts
    (<= (x item-01) 3164) (>= (x item-01) 3165)
    (<= (+ (x item-01) (y item-01)) 6913) (>= (+ (x item-01) (y item-01)) 6914)
    (<= (y item-01) 3749) (>= (y item-01) 3750)
    (<= (y item-01) (+ (x item-01) 584)) (<= (+ (x item-01) 585) (y item-01))
    (>= (z item-01) 1) (<= (z item-01) 1)))
  (:metric minimize (total-cost)))
