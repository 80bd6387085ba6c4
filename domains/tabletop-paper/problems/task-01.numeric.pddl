; Problem task-01 of the learned domain tabletop-paper, for its encoding numeric.
; How it came about: drawn with seed 2: one random action on item-01; draw 3, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-01)
  (:domain tabletop-paper-numeric)
  (:objects
    item-01 - solid-narrow-10)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.6312, -0.0864, 0.0432) m
    (= (x item-01) 2812) (= (y item-01) 2136) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.06355 0.1761 0.08649 0).
    ; Not for item-01:
    ; lift-100c-solid-narrow-10: keeps its promise in 1 of 37 rehearsals only.
    ; lift-101-solid-narrow-10: keeps its promise in 1 of 37 rehearsals only.
    ; push-forward-left-000c-solid-narrow-10: scatters more than it moves.
    ; push-forward-right-101-solid-narrow-10: scatters more than it moves.
    (= (x-of-lift-100c-solid-narrow-10 item-01) 9413) (= (y-of-lift-100c-solid-narrow-10 item-01) 9733) (= (z-of-lift-100c-solid-narrow-10 item-01) 12222) (= (cost-of-lift-100c-solid-narrow-10 item-01) 298)
    (= (x-of-put-down-lift-100c-solid-narrow-10 item-01) 10005) (= (y-of-put-down-lift-100c-solid-narrow-10 item-01) 9986) (= (z-of-put-down-lift-100c-solid-narrow-10 item-01) 7778)
    (= (x-of-lift-101-solid-narrow-10 item-01) 9848) (= (y-of-lift-101-solid-narrow-10 item-01) 9445) (= (z-of-lift-101-solid-narrow-10 item-01) 12442) (= (cost-of-lift-101-solid-narrow-10 item-01) 298)
    (= (x-of-put-down-lift-101-solid-narrow-10 item-01) 10000) (= (y-of-put-down-lift-101-solid-narrow-10 item-01) 9989) (= (z-of-put-down-lift-101-solid-narrow-10 item-01) 7558)
    (can-pull-110-solid-narrow-10 item-01) (= (x-of-pull-110-solid-narrow-10 item-01) 9436) (= (y-of-pull-110-solid-narrow-10 item-01) 9678) (= (cost-of-pull-110-solid-narrow-10 item-01) 12)
    (can-pull-left-010c-solid-narrow-10 item-01) (= (x-of-pull-left-010c-solid-narrow-10 item-01) 9779) (= (y-of-pull-left-010c-solid-narrow-10 item-01) 10151) (= (cost-of-pull-left-010c-solid-narrow-10 item-01) 4)
    (can-pull-right-100c-solid-narrow-10 item-01) (= (x-of-pull-right-100c-solid-narrow-10 item-01) 9486) (= (y-of-pull-right-100c-solid-narrow-10 item-01) 9366) (= (cost-of-pull-right-100c-solid-narrow-10 item-01) 9)
    (can-push-forward-001-solid-narrow-10 item-01) (= (x-of-push-forward-001-solid-narrow-10 item-01) 10677) (= (y-of-push-forward-001-solid-narrow-10 item-01) 9856) (= (cost-of-push-forward-001-solid-narrow-10 item-01) 9)
    (= (x-of-push-forward-left-000c-solid-narrow-10 item-01) 10178) (= (y-of-push-forward-left-000c-solid-narrow-10 item-01) 10073) (= (cost-of-push-forward-left-000c-solid-narrow-10 item-01) 42)
    (= (x-of-push-forward-right-101-solid-narrow-10 item-01) 10068) (= (y-of-push-forward-right-101-solid-narrow-10 item-01) 9719) (= (cost-of-push-forward-right-101-solid-narrow-10 item-01) 63)
    (can-push-forward-right-111-solid-narrow-10 item-01) (= (x-of-push-forward-right-111-solid-narrow-10 item-01) 10224) (= (y-of-push-forward-right-111-solid-narrow-10 item-01) 9688) (= (cost-of-push-forward-right-111-solid-narrow-10 item-01) 4)
    (can-push-left-011c-solid-narrow-10 item-01) (= (x-of-push-left-011c-solid-narrow-10 item-01) 10105) (= (y-of-push-left-011c-solid-narrow-10 item-01) 10252) (= (cost-of-push-left-011c-solid-narrow-10 item-01) 4))
  (:goal (and
    ; item-01 shall come to (0.6877, -0.0637, 0.0432) m, 61 mm from where it starts
    (<= (x item-01) 3832) (>= (x item-01) 2923)
    (<= (+ (x item-01) (y item-01)) 6385) (>= (+ (x item-01) (y item-01)) 5097)
    (<= (y item-01) 2818) (>= (y item-01) 1909)
    (<= (+ (y item-01) 371) (x item-01)) (<= (x item-01) (+ (y item-01) 1658))
    (>= (z item-01) 0) (<= (z item-01) 0)))
  (:metric minimize (total-cost)))
