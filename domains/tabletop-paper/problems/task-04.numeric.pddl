; Problem task-04 of the learned domain tabletop-paper, for its encoding numeric.
; How it came about: drawn with seed 5: one random action on item-01; draw 6, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-04)
  (:domain tabletop-paper-numeric)
  (:objects
    item-01 - hollow-tall-wide-01)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.5941, -0.0363, 0.0220) m
    (= (x item-01) 2441) (= (y item-01) 2637) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.1698 0.1698 0.04403 2).
    ; Not for item-01:
    ; push-right-101-hollow-tall-wide-01: keeps its promise in 1 of 30 rehearsals only.
    (can-lift-000-hollow-tall-wide-01 item-01) (= (x-of-lift-000-hollow-tall-wide-01 item-01) 9965) (= (y-of-lift-000-hollow-tall-wide-01 item-01) 11073) (= (z-of-lift-000-hollow-tall-wide-01 item-01) 12190) (= (cost-of-lift-000-hollow-tall-wide-01 item-01) 4)
    (= (x-of-put-down-lift-000-hollow-tall-wide-01 item-01) 9999) (= (y-of-put-down-lift-000-hollow-tall-wide-01 item-01) 9967) (= (z-of-put-down-lift-000-hollow-tall-wide-01 item-01) 7810)
    (can-lift-000b-hollow-tall-wide-01 item-01) (= (x-of-lift-000b-hollow-tall-wide-01 item-01) 10042) (= (y-of-lift-000b-hollow-tall-wide-01 item-01) 10498) (= (z-of-lift-000b-hollow-tall-wide-01 item-01) 12460) (= (cost-of-lift-000b-hollow-tall-wide-01 item-01) 4)
    (= (x-of-put-down-lift-000b-hollow-tall-wide-01 item-01) 10003) (= (y-of-put-down-lift-000b-hollow-tall-wide-01 item-01) 9968) (= (z-of-put-down-lift-000b-hollow-tall-wide-01 item-01) 7540)
    (can-lift-100-hollow-tall-wide-01 item-01) (= (x-of-lift-100-hollow-tall-wide-01 item-01) 9519) (= (y-of-lift-100-hollow-tall-wide-01 item-01) 8960) (= (z-of-lift-100-hollow-tall-wide-01 item-01) 11996) (= (cost-of-lift-100-hollow-tall-wide-01 item-01) 84)
    (= (x-of-put-down-lift-100-hollow-tall-wide-01 item-01) 9998) (= (y-of-put-down-lift-100-hollow-tall-wide-01 item-01) 9973) (= (z-of-put-down-lift-100-hollow-tall-wide-01 item-01) 8004)
    (can-lift-100b-hollow-tall-wide-01 item-01) (= (x-of-lift-100b-hollow-tall-wide-01 item-01) 9492) (= (y-of-lift-100b-hollow-tall-wide-01 item-01) 10818) (= (z-of-lift-100b-hollow-tall-wide-01 item-01) 11978) (= (cost-of-lift-100b-hollow-tall-wide-01 item-01) 4)
    (= (x-of-put-down-lift-100b-hollow-tall-wide-01 item-01) 9998) (= (y-of-put-down-lift-100b-hollow-tall-wide-01 item-01) 9968) (= (z-of-put-down-lift-100b-hollow-tall-wide-01 item-01) 8022)
    (can-lift-101-hollow-tall-wide-01 item-01) (= (x-of-lift-101-hollow-tall-wide-01 item-01) 9619) (= (y-of-lift-101-hollow-tall-wide-01 item-01) 8675) (= (z-of-lift-101-hollow-tall-wide-01 item-01) 12412) (= (cost-of-lift-101-hollow-tall-wide-01 item-01) 11)
    (= (x-of-put-down-lift-101-hollow-tall-wide-01 item-01) 10003) (= (y-of-put-down-lift-101-hollow-tall-wide-01 item-01) 9972) (= (z-of-put-down-lift-101-hollow-tall-wide-01 item-01) 7588)
    (can-lift-101a-hollow-tall-wide-01 item-01) (= (x-of-lift-101a-hollow-tall-wide-01 item-01) 9998) (= (y-of-lift-101a-hollow-tall-wide-01 item-01) 9159) (= (z-of-lift-101a-hollow-tall-wide-01 item-01) 11994) (= (cost-of-lift-101a-hollow-tall-wide-01 item-01) 4)
    (= (x-of-put-down-lift-101a-hollow-tall-wide-01 item-01) 9999) (= (y-of-put-down-lift-101a-hollow-tall-wide-01 item-01) 9962) (= (z-of-put-down-lift-101a-hollow-tall-wide-01 item-01) 8006)
    (can-pull-left-010b-hollow-tall-wide-01 item-01) (= (x-of-pull-left-010b-hollow-tall-wide-01 item-01) 9713) (= (y-of-pull-left-010b-hollow-tall-wide-01 item-01) 10248) (= (cost-of-pull-left-010b-hollow-tall-wide-01 item-01) 4)
    (can-push-forward-right-111b-hollow-tall-wide-01 item-01) (= (x-of-push-forward-right-111b-hollow-tall-wide-01 item-01) 10407) (= (y-of-push-forward-right-111b-hollow-tall-wide-01 item-01) 9663) (= (cost-of-push-forward-right-111b-hollow-tall-wide-01 item-01) 4)
    (can-push-left-011b-hollow-tall-wide-01 item-01) (= (x-of-push-left-011b-hollow-tall-wide-01 item-01) 10267) (= (y-of-push-left-011b-hollow-tall-wide-01 item-01) 10779) (= (cost-of-push-left-011b-hollow-tall-wide-01 item-01) 4)
    (can-push-right-001b-hollow-tall-wide-01 item-01) (= (x-of-push-right-001b-hollow-tall-wide-01 item-01) 10116) (= (y-of-push-right-001b-hollow-tall-wide-01 item-01) 9022) (= (cost-of-push-right-001b-hollow-tall-wide-01 item-01) 4)
    (can-push-right-100-hollow-tall-wide-01 item-01) (= (x-of-push-right-100-hollow-tall-wide-01 item-01) 9945) (= (y-of-push-right-100-hollow-tall-wide-01 item-01) 9662) (= (cost-of-push-right-100-hollow-tall-wide-01 item-01) 64)
    (= (x-of-push-right-101-hollow-tall-wide-01 item-01) 10213) (= (y-of-push-right-101-hollow-tall-wide-01 item-01) 9154) (= (cost-of-push-right-101-hollow-tall-wide-01 item-01) 278)
    (can-push-right-110b-hollow-tall-wide-01 item-01) (= (x-of-push-right-110b-hollow-tall-wide-01 item-01) 9644) (= (y-of-push-right-110b-hollow-tall-wide-01 item-01) 9130) (= (cost-of-push-right-110b-hollow-tall-wide-01 item-01) 4))
  (:goal (and
    ; item-01 shall come to (0.5828, -0.0295, 0.2220) m, 200 mm from where it starts
    (<= (x item-01) 2748) (>= (x item-01) 1908)
    (<= (+ (x item-01) (y item-01)) 5627) (>= (+ (x item-01) (y item-01)) 4439)
    (<= (y item-01) 3125) (>= (y item-01) 2285)
    (<= (y item-01) (+ (x item-01) 971)) (<= (x item-01) (+ (y item-01) 218))
    (>= (z item-01) 1978) (<= (z item-01) 2190)))
  (:metric minimize (total-cost)))
