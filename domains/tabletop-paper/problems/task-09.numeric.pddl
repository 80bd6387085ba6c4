; Problem task-09 of the learned domain tabletop-paper, for its encoding numeric.
; How it came about: drawn with seed 10: one random action on item-02; draw 1, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-09)
  (:domain tabletop-paper-numeric)
  (:objects
    item-01 - any-low-narrow-11
    item-02 - solid-narrow-10)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.5712, 0.0236, 0.0171) m
    (= (x item-01) 2212) (= (y item-01) 3236) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.1509 0.05109 0.03415 0).
    (can-lift-000-any-low-narrow-11 item-01) (= (x-of-lift-000-any-low-narrow-11 item-01) 10210) (= (y-of-lift-000-any-low-narrow-11 item-01) 10262) (= (z-of-lift-000-any-low-narrow-11 item-01) 12155) (= (cost-of-lift-000-any-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-000-any-low-narrow-11 item-01) 9996) (= (y-of-put-down-lift-000-any-low-narrow-11 item-01) 9987) (= (z-of-put-down-lift-000-any-low-narrow-11 item-01) 7845)
    (can-lift-000d-any-low-narrow-11 item-01) (= (x-of-lift-000d-any-low-narrow-11 item-01) 10461) (= (y-of-lift-000d-any-low-narrow-11 item-01) 10098) (= (z-of-lift-000d-any-low-narrow-11 item-01) 12002) (= (cost-of-lift-000d-any-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-000d-any-low-narrow-11 item-01) 10000) (= (y-of-put-down-lift-000d-any-low-narrow-11 item-01) 9987) (= (z-of-put-down-lift-000d-any-low-narrow-11 item-01) 7998)
    (can-lift-100-any-low-narrow-11 item-01) (= (x-of-lift-100-any-low-narrow-11 item-01) 9339) (= (y-of-lift-100-any-low-narrow-11 item-01) 9746) (= (z-of-lift-100-any-low-narrow-11 item-01) 12000) (= (cost-of-lift-100-any-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-100-any-low-narrow-11 item-01) 10001) (= (y-of-put-down-lift-100-any-low-narrow-11 item-01) 9990) (= (z-of-put-down-lift-100-any-low-narrow-11 item-01) 8000)
    (can-lift-100d-any-low-narrow-11 item-01) (= (x-of-lift-100d-any-low-narrow-11 item-01) 9765) (= (y-of-lift-100d-any-low-narrow-11 item-01) 10384) (= (z-of-lift-100d-any-low-narrow-11 item-01) 11997) (= (cost-of-lift-100d-any-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-100d-any-low-narrow-11 item-01) 10000) (= (y-of-put-down-lift-100d-any-low-narrow-11 item-01) 9984) (= (z-of-put-down-lift-100d-any-low-narrow-11 item-01) 8003)
    (can-lift-101-any-low-narrow-11 item-01) (= (x-of-lift-101-any-low-narrow-11 item-01) 9831) (= (y-of-lift-101-any-low-narrow-11 item-01) 9472) (= (z-of-lift-101-any-low-narrow-11 item-01) 12359) (= (cost-of-lift-101-any-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-101-any-low-narrow-11 item-01) 9996) (= (y-of-put-down-lift-101-any-low-narrow-11 item-01) 9988) (= (z-of-put-down-lift-101-any-low-narrow-11 item-01) 7641)
    (can-lift-101b-any-low-narrow-11 item-01) (= (x-of-lift-101b-any-low-narrow-11 item-01) 10053) (= (y-of-lift-101b-any-low-narrow-11 item-01) 9549) (= (z-of-lift-101b-any-low-narrow-11 item-01) 12005) (= (cost-of-lift-101b-any-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-101b-any-low-narrow-11 item-01) 9998) (= (y-of-put-down-lift-101b-any-low-narrow-11 item-01) 9988) (= (z-of-put-down-lift-101b-any-low-narrow-11 item-01) 7995)
    (can-pull-right-110c-any-low-narrow-11 item-01) (= (x-of-pull-right-110c-any-low-narrow-11 item-01) 9447) (= (y-of-pull-right-110c-any-low-narrow-11 item-01) 9579) (= (cost-of-pull-right-110c-any-low-narrow-11 item-01) 4)
    (can-push-forward-001-any-low-narrow-11 item-01) (= (x-of-push-forward-001-any-low-narrow-11 item-01) 10958) (= (y-of-push-forward-001-any-low-narrow-11 item-01) 9714) (= (cost-of-push-forward-001-any-low-narrow-11 item-01) 4)
    (can-push-forward-001c-any-low-narrow-11 item-01) (= (x-of-push-forward-001c-any-low-narrow-11 item-01) 10855) (= (y-of-push-forward-001c-any-low-narrow-11 item-01) 10185) (= (cost-of-push-forward-001c-any-low-narrow-11 item-01) 4)
    (can-push-forward-left-011-any-low-narrow-11 item-01) (= (x-of-push-forward-left-011-any-low-narrow-11 item-01) 10643) (= (y-of-push-forward-left-011-any-low-narrow-11 item-01) 10485) (= (cost-of-push-forward-left-011-any-low-narrow-11 item-01) 4)
    (can-push-forward-right-011d-any-low-narrow-11 item-01) (= (x-of-push-forward-right-011d-any-low-narrow-11 item-01) 10288) (= (y-of-push-forward-right-011d-any-low-narrow-11 item-01) 9585) (= (cost-of-push-forward-right-011d-any-low-narrow-11 item-01) 4)
    (can-push-left-010d-any-low-narrow-11 item-01) (= (x-of-push-left-010d-any-low-narrow-11 item-01) 9984) (= (y-of-push-left-010d-any-low-narrow-11 item-01) 10978) (= (cost-of-push-left-010d-any-low-narrow-11 item-01) 7)
    (can-push-right-111c-any-low-narrow-11 item-01) (= (x-of-push-right-111c-any-low-narrow-11 item-01) 9899) (= (y-of-push-right-111c-any-low-narrow-11 item-01) 9128) (= (cost-of-push-right-111c-any-low-narrow-11 item-01) 7)
    ; item-02 starts at (0.7285, -0.1595, 0.0123) m
    (= (x item-02) 3785) (= (y item-02) 1405) (= (z item-02) 0)
    ; What each operator promises for item-02 (features 0.03588 0.171 0.02456 0).
    ; Not for item-02:
    ; lift-100c-solid-narrow-10: keeps its promise in 1 of 37 rehearsals only.
    ; lift-101-solid-narrow-10: keeps its promise in 1 of 37 rehearsals only.
    (= (x-of-lift-100c-solid-narrow-10 item-02) 9413) (= (y-of-lift-100c-solid-narrow-10 item-02) 9733) (= (z-of-lift-100c-solid-narrow-10 item-02) 12220) (= (cost-of-lift-100c-solid-narrow-10 item-02) 298)
    (= (x-of-put-down-lift-100c-solid-narrow-10 item-02) 10004) (= (y-of-put-down-lift-100c-solid-narrow-10 item-02) 9986) (= (z-of-put-down-lift-100c-solid-narrow-10 item-02) 7780)
    (= (x-of-lift-101-solid-narrow-10 item-02) 9842) (= (y-of-lift-101-solid-narrow-10 item-02) 9451) (= (z-of-lift-101-solid-narrow-10 item-02) 12437) (= (cost-of-lift-101-solid-narrow-10 item-02) 298)
    (= (x-of-put-down-lift-101-solid-narrow-10 item-02) 10004) (= (y-of-put-down-lift-101-solid-narrow-10 item-02) 9993) (= (z-of-put-down-lift-101-solid-narrow-10 item-02) 7563)
    (can-pull-110-solid-narrow-10 item-02) (= (x-of-pull-110-solid-narrow-10 item-02) 9297) (= (y-of-pull-110-solid-narrow-10 item-02) 9844) (= (cost-of-pull-110-solid-narrow-10 item-02) 4)
    (can-pull-left-010c-solid-narrow-10 item-02) (= (x-of-pull-left-010c-solid-narrow-10 item-02) 9751) (= (y-of-pull-left-010c-solid-narrow-10 item-02) 10168) (= (cost-of-pull-left-010c-solid-narrow-10 item-02) 4)
    (can-pull-right-100c-solid-narrow-10 item-02) (= (x-of-pull-right-100c-solid-narrow-10 item-02) 9772) (= (y-of-pull-right-100c-solid-narrow-10 item-02) 9589) (= (cost-of-pull-right-100c-solid-narrow-10 item-02) 18)
    (can-push-forward-001-solid-narrow-10 item-02) (= (x-of-push-forward-001-solid-narrow-10 item-02) 11023) (= (y-of-push-forward-001-solid-narrow-10 item-02) 9813) (= (cost-of-push-forward-001-solid-narrow-10 item-02) 9)
    (can-push-forward-left-000c-solid-narrow-10 item-02) (= (x-of-push-forward-left-000c-solid-narrow-10 item-02) 10489) (= (y-of-push-forward-left-000c-solid-narrow-10 item-02) 10147) (= (cost-of-push-forward-left-000c-solid-narrow-10 item-02) 9)
    (can-push-forward-right-101-solid-narrow-10 item-02) (= (x-of-push-forward-right-101-solid-narrow-10 item-02) 10234) (= (y-of-push-forward-right-101-solid-narrow-10 item-02) 9502) (= (cost-of-push-forward-right-101-solid-narrow-10 item-02) 9)
    (can-push-forward-right-111-solid-narrow-10 item-02) (= (x-of-push-forward-right-111-solid-narrow-10 item-02) 10341) (= (y-of-push-forward-right-111-solid-narrow-10 item-02) 9560) (= (cost-of-push-forward-right-111-solid-narrow-10 item-02) 4)
    (can-push-left-011c-solid-narrow-10 item-02) (= (x-of-push-left-011c-solid-narrow-10 item-02) 10082) (= (y-of-push-left-011c-solid-narrow-10 item-02) 10552) (= (cost-of-push-left-011c-solid-narrow-10 item-02) 4))
  (:goal (and
    ; item-01 shall come to (0.5712, 0.0236, 0.0171) m, 0 mm from where it starts
    (<= (x item-01) 2667) (>= (x item-01) 1757)
    (<= (+ (x item-01) (y item-01)) 6091) (>= (+ (x item-01) (y item-01)) 4804)
    (<= (y item-01) 3691) (>= (y item-01) 2781)
    (<= (y item-01) (+ (x item-01) 1667)) (<= (+ (x item-01) 380) (y item-01))
    (>= (z item-01) 0) (<= (z item-01) 0)
    ; item-02 shall come to (0.7522, -0.2468, 0.0123) m, 90 mm from where it starts
    (<= (x item-02) 4477) (>= (x item-02) 3567)
    (<= (+ (x item-02) (y item-02)) 5197) (>= (+ (x item-02) (y item-02)) 3910)
    (<= (y item-02) 987) (>= (y item-02) 77)
    (<= (+ (y item-02) 2846) (x item-02)) (<= (x item-02) (+ (y item-02) 4134))
    (>= (z item-02) 0) (<= (z item-02) 0)))
  (:metric minimize (total-cost)))
