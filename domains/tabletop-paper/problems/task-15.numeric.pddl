; Problem task-15 of the learned domain tabletop-paper, for its encoding numeric.
; How it came about: drawn with seed 16: 3 random actions on item-04, item-01, item-02; draw 2, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-15)
  (:domain tabletop-paper-numeric)
  (:objects
    item-01 - solid-narrow-10
    item-02 - any-low-narrow-11
    item-03 - solid-narrow-10
    item-04 - any-low-narrow-11)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.4321, 0.0694, 0.0132) m
    (= (x item-01) 821) (= (y item-01) 3694) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.03604 0.149 0.02642 0).
    ; Not for item-01:
    ; lift-100c-solid-narrow-10: keeps its promise in 1 of 37 rehearsals only.
    ; lift-101-solid-narrow-10: keeps its promise in 1 of 37 rehearsals only.
    (= (x-of-lift-100c-solid-narrow-10 item-01) 9402) (= (y-of-lift-100c-solid-narrow-10 item-01) 9739) (= (z-of-lift-100c-solid-narrow-10 item-01) 12213) (= (cost-of-lift-100c-solid-narrow-10 item-01) 298)
    (= (x-of-put-down-lift-100c-solid-narrow-10 item-01) 10006) (= (y-of-put-down-lift-100c-solid-narrow-10 item-01) 9988) (= (z-of-put-down-lift-100c-solid-narrow-10 item-01) 7787)
    (= (x-of-lift-101-solid-narrow-10 item-01) 9844) (= (y-of-lift-101-solid-narrow-10 item-01) 9466) (= (z-of-lift-101-solid-narrow-10 item-01) 12434) (= (cost-of-lift-101-solid-narrow-10 item-01) 298)
    (= (x-of-put-down-lift-101-solid-narrow-10 item-01) 10008) (= (y-of-put-down-lift-101-solid-narrow-10 item-01) 9995) (= (z-of-put-down-lift-101-solid-narrow-10 item-01) 7566)
    (can-pull-110-solid-narrow-10 item-01) (= (x-of-pull-110-solid-narrow-10 item-01) 9283) (= (y-of-pull-110-solid-narrow-10 item-01) 9832) (= (cost-of-pull-110-solid-narrow-10 item-01) 4)
    (can-pull-left-010c-solid-narrow-10 item-01) (= (x-of-pull-left-010c-solid-narrow-10 item-01) 9772) (= (y-of-pull-left-010c-solid-narrow-10 item-01) 10149) (= (cost-of-pull-left-010c-solid-narrow-10 item-01) 4)
    (can-pull-right-100c-solid-narrow-10 item-01) (= (x-of-pull-right-100c-solid-narrow-10 item-01) 9712) (= (y-of-pull-right-100c-solid-narrow-10 item-01) 9533) (= (cost-of-pull-right-100c-solid-narrow-10 item-01) 31)
    (can-push-forward-001-solid-narrow-10 item-01) (= (x-of-push-forward-001-solid-narrow-10 item-01) 10915) (= (y-of-push-forward-001-solid-narrow-10 item-01) 9802) (= (cost-of-push-forward-001-solid-narrow-10 item-01) 9)
    (can-push-forward-left-000c-solid-narrow-10 item-01) (= (x-of-push-forward-left-000c-solid-narrow-10 item-01) 10479) (= (y-of-push-forward-left-000c-solid-narrow-10 item-01) 10127) (= (cost-of-push-forward-left-000c-solid-narrow-10 item-01) 9)
    (can-push-forward-right-101-solid-narrow-10 item-01) (= (x-of-push-forward-right-101-solid-narrow-10 item-01) 10394) (= (y-of-push-forward-right-101-solid-narrow-10 item-01) 9365) (= (cost-of-push-forward-right-101-solid-narrow-10 item-01) 9)
    (can-push-forward-right-111-solid-narrow-10 item-01) (= (x-of-push-forward-right-111-solid-narrow-10 item-01) 10305) (= (y-of-push-forward-right-111-solid-narrow-10 item-01) 9599) (= (cost-of-push-forward-right-111-solid-narrow-10 item-01) 4)
    (can-push-left-011c-solid-narrow-10 item-01) (= (x-of-push-left-011c-solid-narrow-10 item-01) 10104) (= (y-of-push-left-011c-solid-narrow-10 item-01) 10609) (= (cost-of-push-left-011c-solid-narrow-10 item-01) 4)
    ; item-02 starts at (0.6321, -0.1446, 0.0368) m
    (= (x item-02) 2821) (= (y item-02) 1554) (= (z item-02) 0)
    ; What each operator promises for item-02 (features 0.1358 0.03482 0.07371 0).
    ; Not for item-02:
    ; push-left-010d-any-low-narrow-11: keeps its promise with such objects in about 7 of 30 only.
    (can-lift-000-any-low-narrow-11 item-02) (= (x-of-lift-000-any-low-narrow-11 item-02) 10226) (= (y-of-lift-000-any-low-narrow-11 item-02) 10284) (= (z-of-lift-000-any-low-narrow-11 item-02) 12223) (= (cost-of-lift-000-any-low-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-000-any-low-narrow-11 item-02) 10003) (= (y-of-put-down-lift-000-any-low-narrow-11 item-02) 9989) (= (z-of-put-down-lift-000-any-low-narrow-11 item-02) 7777)
    (can-lift-000d-any-low-narrow-11 item-02) (= (x-of-lift-000d-any-low-narrow-11 item-02) 10500) (= (y-of-lift-000d-any-low-narrow-11 item-02) 10103) (= (z-of-lift-000d-any-low-narrow-11 item-02) 11998) (= (cost-of-lift-000d-any-low-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-000d-any-low-narrow-11 item-02) 10000) (= (y-of-put-down-lift-000d-any-low-narrow-11 item-02) 9986) (= (z-of-put-down-lift-000d-any-low-narrow-11 item-02) 8002)
    (can-lift-100-any-low-narrow-11 item-02) (= (x-of-lift-100-any-low-narrow-11 item-02) 9331) (= (y-of-lift-100-any-low-narrow-11 item-02) 9750) (= (z-of-lift-100-any-low-narrow-11 item-02) 12034) (= (cost-of-lift-100-any-low-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-100-any-low-narrow-11 item-02) 10000) (= (y-of-put-down-lift-100-any-low-narrow-11 item-02) 9986) (= (z-of-put-down-lift-100-any-low-narrow-11 item-02) 7966)
    (can-lift-100d-any-low-narrow-11 item-02) (= (x-of-lift-100d-any-low-narrow-11 item-02) 9770) (= (y-of-lift-100d-any-low-narrow-11 item-02) 10384) (= (z-of-lift-100d-any-low-narrow-11 item-02) 11996) (= (cost-of-lift-100d-any-low-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-100d-any-low-narrow-11 item-02) 10001) (= (y-of-put-down-lift-100d-any-low-narrow-11 item-02) 9988) (= (z-of-put-down-lift-100d-any-low-narrow-11 item-02) 8004)
    (can-lift-101-any-low-narrow-11 item-02) (= (x-of-lift-101-any-low-narrow-11 item-02) 9839) (= (y-of-lift-101-any-low-narrow-11 item-02) 9482) (= (z-of-lift-101-any-low-narrow-11 item-02) 12459) (= (cost-of-lift-101-any-low-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-101-any-low-narrow-11 item-02) 9996) (= (y-of-put-down-lift-101-any-low-narrow-11 item-02) 9991) (= (z-of-put-down-lift-101-any-low-narrow-11 item-02) 7541)
    (can-lift-101b-any-low-narrow-11 item-02) (= (x-of-lift-101b-any-low-narrow-11 item-02) 10047) (= (y-of-lift-101b-any-low-narrow-11 item-02) 9559) (= (z-of-lift-101b-any-low-narrow-11 item-02) 11999) (= (cost-of-lift-101b-any-low-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-101b-any-low-narrow-11 item-02) 10003) (= (y-of-put-down-lift-101b-any-low-narrow-11 item-02) 9987) (= (z-of-put-down-lift-101b-any-low-narrow-11 item-02) 8001)
    (can-pull-right-110c-any-low-narrow-11 item-02) (= (x-of-pull-right-110c-any-low-narrow-11 item-02) 9445) (= (y-of-pull-right-110c-any-low-narrow-11 item-02) 9571) (= (cost-of-pull-right-110c-any-low-narrow-11 item-02) 4)
    (can-push-forward-001-any-low-narrow-11 item-02) (= (x-of-push-forward-001-any-low-narrow-11 item-02) 10918) (= (y-of-push-forward-001-any-low-narrow-11 item-02) 9752) (= (cost-of-push-forward-001-any-low-narrow-11 item-02) 4)
    (can-push-forward-001c-any-low-narrow-11 item-02) (= (x-of-push-forward-001c-any-low-narrow-11 item-02) 10849) (= (y-of-push-forward-001c-any-low-narrow-11 item-02) 10181) (= (cost-of-push-forward-001c-any-low-narrow-11 item-02) 4)
    (can-push-forward-left-011-any-low-narrow-11 item-02) (= (x-of-push-forward-left-011-any-low-narrow-11 item-02) 10572) (= (y-of-push-forward-left-011-any-low-narrow-11 item-02) 10431) (= (cost-of-push-forward-left-011-any-low-narrow-11 item-02) 4)
    (can-push-forward-right-011d-any-low-narrow-11 item-02) (= (x-of-push-forward-right-011d-any-low-narrow-11 item-02) 10285) (= (y-of-push-forward-right-011d-any-low-narrow-11 item-02) 9587) (= (cost-of-push-forward-right-011d-any-low-narrow-11 item-02) 4)
    (= (x-of-push-left-010d-any-low-narrow-11 item-02) 9792) (= (y-of-push-left-010d-any-low-narrow-11 item-02) 10878) (= (cost-of-push-left-010d-any-low-narrow-11 item-02) 140)
    (can-push-right-111c-any-low-narrow-11 item-02) (= (x-of-push-right-111c-any-low-narrow-11 item-02) 9795) (= (y-of-push-right-111c-any-low-narrow-11 item-02) 9231) (= (cost-of-push-right-111c-any-low-narrow-11 item-02) 26)
    ; item-03 starts at (0.7617, -0.0541, 0.0164) m
    (= (x item-03) 4117) (= (y item-03) 2459) (= (z item-03) 0)
    ; What each operator promises for item-03 (features 0.03982 0.1263 0.0328 0).
    ; Not for item-03:
    ; lift-101-solid-narrow-10: keeps its promise in 1 of 37 rehearsals only.
    (can-lift-100c-solid-narrow-10 item-03) (= (x-of-lift-100c-solid-narrow-10 item-03) 9381) (= (y-of-lift-100c-solid-narrow-10 item-03) 9754) (= (z-of-lift-100c-solid-narrow-10 item-03) 12205) (= (cost-of-lift-100c-solid-narrow-10 item-03) 90)
    (= (x-of-put-down-lift-100c-solid-narrow-10 item-03) 10008) (= (y-of-put-down-lift-100c-solid-narrow-10 item-03) 9991) (= (z-of-put-down-lift-100c-solid-narrow-10 item-03) 7795)
    (= (x-of-lift-101-solid-narrow-10 item-03) 9851) (= (y-of-lift-101-solid-narrow-10 item-03) 9480) (= (z-of-lift-101-solid-narrow-10 item-03) 12420) (= (cost-of-lift-101-solid-narrow-10 item-03) 298)
    (= (x-of-put-down-lift-101-solid-narrow-10 item-03) 10014) (= (y-of-put-down-lift-101-solid-narrow-10 item-03) 9994) (= (z-of-put-down-lift-101-solid-narrow-10 item-03) 7580)
    (can-pull-110-solid-narrow-10 item-03) (= (x-of-pull-110-solid-narrow-10 item-03) 9262) (= (y-of-pull-110-solid-narrow-10 item-03) 9800) (= (cost-of-pull-110-solid-narrow-10 item-03) 4)
    (can-pull-left-010c-solid-narrow-10 item-03) (= (x-of-pull-left-010c-solid-narrow-10 item-03) 9784) (= (y-of-pull-left-010c-solid-narrow-10 item-03) 10127) (= (cost-of-pull-left-010c-solid-narrow-10 item-03) 4)
    (can-pull-right-100c-solid-narrow-10 item-03) (= (x-of-pull-right-100c-solid-narrow-10 item-03) 9603) (= (y-of-pull-right-100c-solid-narrow-10 item-03) 9459) (= (cost-of-pull-right-100c-solid-narrow-10 item-03) 63)
    (can-push-forward-001-solid-narrow-10 item-03) (= (x-of-push-forward-001-solid-narrow-10 item-03) 10833) (= (y-of-push-forward-001-solid-narrow-10 item-03) 9848) (= (cost-of-push-forward-001-solid-narrow-10 item-03) 9)
    (can-push-forward-left-000c-solid-narrow-10 item-03) (= (x-of-push-forward-left-000c-solid-narrow-10 item-03) 10496) (= (y-of-push-forward-left-000c-solid-narrow-10 item-03) 10133) (= (cost-of-push-forward-left-000c-solid-narrow-10 item-03) 9)
    (can-push-forward-right-101-solid-narrow-10 item-03) (= (x-of-push-forward-right-101-solid-narrow-10 item-03) 10430) (= (y-of-push-forward-right-101-solid-narrow-10 item-03) 9504) (= (cost-of-push-forward-right-101-solid-narrow-10 item-03) 31)
    (can-push-forward-right-111-solid-narrow-10 item-03) (= (x-of-push-forward-right-111-solid-narrow-10 item-03) 10197) (= (y-of-push-forward-right-111-solid-narrow-10 item-03) 9689) (= (cost-of-push-forward-right-111-solid-narrow-10 item-03) 4)
    (can-push-left-011c-solid-narrow-10 item-03) (= (x-of-push-left-011c-solid-narrow-10 item-03) 10168) (= (y-of-push-left-011c-solid-narrow-10 item-03) 10608) (= (cost-of-push-left-011c-solid-narrow-10 item-03) 4)
    ; item-04 starts at (0.7632, 0.1102, 0.0286) m
    (= (x item-04) 4132) (= (y item-04) 4102) (= (z item-04) 0)
    ; What each operator promises for item-04 (features 0.1712 0.06261 0.05729 0).
    (can-lift-000-any-low-narrow-11 item-04) (= (x-of-lift-000-any-low-narrow-11 item-04) 10209) (= (y-of-lift-000-any-low-narrow-11 item-04) 10283) (= (z-of-lift-000-any-low-narrow-11 item-04) 12231) (= (cost-of-lift-000-any-low-narrow-11 item-04) 4)
    (= (x-of-put-down-lift-000-any-low-narrow-11 item-04) 9997) (= (y-of-put-down-lift-000-any-low-narrow-11 item-04) 9989) (= (z-of-put-down-lift-000-any-low-narrow-11 item-04) 7769)
    (can-lift-000d-any-low-narrow-11 item-04) (= (x-of-lift-000d-any-low-narrow-11 item-04) 10490) (= (y-of-lift-000d-any-low-narrow-11 item-04) 10106) (= (z-of-lift-000d-any-low-narrow-11 item-04) 12004) (= (cost-of-lift-000d-any-low-narrow-11 item-04) 4)
    (= (x-of-put-down-lift-000d-any-low-narrow-11 item-04) 10000) (= (y-of-put-down-lift-000d-any-low-narrow-11 item-04) 9991) (= (z-of-put-down-lift-000d-any-low-narrow-11 item-04) 7996)
    (can-lift-100-any-low-narrow-11 item-04) (= (x-of-lift-100-any-low-narrow-11 item-04) 9334) (= (y-of-lift-100-any-low-narrow-11 item-04) 9760) (= (z-of-lift-100-any-low-narrow-11 item-04) 12025) (= (cost-of-lift-100-any-low-narrow-11 item-04) 4)
    (= (x-of-put-down-lift-100-any-low-narrow-11 item-04) 10004) (= (y-of-put-down-lift-100-any-low-narrow-11 item-04) 9992) (= (z-of-put-down-lift-100-any-low-narrow-11 item-04) 7975)
    (can-lift-100d-any-low-narrow-11 item-04) (= (x-of-lift-100d-any-low-narrow-11 item-04) 9769) (= (y-of-lift-100d-any-low-narrow-11 item-04) 10388) (= (z-of-lift-100d-any-low-narrow-11 item-04) 11999) (= (cost-of-lift-100d-any-low-narrow-11 item-04) 4)
    (= (x-of-put-down-lift-100d-any-low-narrow-11 item-04) 10001) (= (y-of-put-down-lift-100d-any-low-narrow-11 item-04) 9991) (= (z-of-put-down-lift-100d-any-low-narrow-11 item-04) 8001)
    (can-lift-101-any-low-narrow-11 item-04) (= (x-of-lift-101-any-low-narrow-11 item-04) 9837) (= (y-of-lift-101-any-low-narrow-11 item-04) 9483) (= (z-of-lift-101-any-low-narrow-11 item-04) 12439) (= (cost-of-lift-101-any-low-narrow-11 item-04) 4)
    (= (x-of-put-down-lift-101-any-low-narrow-11 item-04) 9995) (= (y-of-put-down-lift-101-any-low-narrow-11 item-04) 9991) (= (z-of-put-down-lift-101-any-low-narrow-11 item-04) 7561)
    (can-lift-101b-any-low-narrow-11 item-04) (= (x-of-lift-101b-any-low-narrow-11 item-04) 10053) (= (y-of-lift-101b-any-low-narrow-11 item-04) 9563) (= (z-of-lift-101b-any-low-narrow-11 item-04) 12001) (= (cost-of-lift-101b-any-low-narrow-11 item-04) 4)
    (= (x-of-put-down-lift-101b-any-low-narrow-11 item-04) 10000) (= (y-of-put-down-lift-101b-any-low-narrow-11 item-04) 9994) (= (z-of-put-down-lift-101b-any-low-narrow-11 item-04) 7999)
    (can-pull-right-110c-any-low-narrow-11 item-04) (= (x-of-pull-right-110c-any-low-narrow-11 item-04) 9443) (= (y-of-pull-right-110c-any-low-narrow-11 item-04) 9599) (= (cost-of-pull-right-110c-any-low-narrow-11 item-04) 4)
    (can-push-forward-001-any-low-narrow-11 item-04) (= (x-of-push-forward-001-any-low-narrow-11 item-04) 10940) (= (y-of-push-forward-001-any-low-narrow-11 item-04) 9784) (= (cost-of-push-forward-001-any-low-narrow-11 item-04) 4)
    (can-push-forward-001c-any-low-narrow-11 item-04) (= (x-of-push-forward-001c-any-low-narrow-11 item-04) 10850) (= (y-of-push-forward-001c-any-low-narrow-11 item-04) 10185) (= (cost-of-push-forward-001c-any-low-narrow-11 item-04) 4)
    (can-push-forward-left-011-any-low-narrow-11 item-04) (= (x-of-push-forward-left-011-any-low-narrow-11 item-04) 10635) (= (y-of-push-forward-left-011-any-low-narrow-11 item-04) 10493) (= (cost-of-push-forward-left-011-any-low-narrow-11 item-04) 4)
    (can-push-forward-right-011d-any-low-narrow-11 item-04) (= (x-of-push-forward-right-011d-any-low-narrow-11 item-04) 10283) (= (y-of-push-forward-right-011d-any-low-narrow-11 item-04) 9604) (= (cost-of-push-forward-right-011d-any-low-narrow-11 item-04) 4)
    (can-push-left-010d-any-low-narrow-11 item-04) (= (x-of-push-left-010d-any-low-narrow-11 item-04) 9900) (= (y-of-push-left-010d-any-low-narrow-11 item-04) 11098) (= (cost-of-push-left-010d-any-low-narrow-11 item-04) 14)
    (can-push-right-111c-any-low-narrow-11 item-04) (= (x-of-push-right-111c-any-low-narrow-11 item-04) 9797) (= (y-of-push-right-111c-any-low-narrow-11 item-04) 9198) (= (cost-of-push-right-111c-any-low-narrow-11 item-04) 7))
  (:goal (and
    ; item-01 shall come to (0.4317, 0.0835, 0.0132) m, 14 mm from where it starts
    (<= (x item-01) 1272) (>= (x item-01) 362)
    (<= (+ (x item-01) (y item-01)) 5296) (>= (+ (x item-01) (y item-01)) 4009)
    (<= (y item-01) 4290) (>= (y item-01) 3380)
    (<= (y item-01) (+ (x item-01) 3662)) (<= (+ (x item-01) 2375) (y item-01))
    (>= (z item-01) 0) (<= (z item-01) 0)
    ; item-02 shall come to (0.5906, -0.1934, 0.3084) m, 279 mm from where it starts
    (<= (x item-02) 2795) (>= (x item-02) 2017)
    (<= (+ (x item-02) (y item-02)) 4023) (>= (+ (x item-02) (y item-02)) 2922)
    (<= (y item-02) 1455) (>= (y item-02) 677)
    (<= (+ (y item-02) 790) (x item-02)) (<= (x item-02) (+ (y item-02) 1890))
    (>= (z item-02) 2459) (<= (z item-02) 2459)
    ; item-03 shall come to (0.7617, -0.0540, 0.0164) m, 0 mm from where it starts
    (<= (x item-03) 4572) (>= (x item-03) 3662)
    (<= (+ (x item-03) (y item-03)) 7220) (>= (+ (x item-03) (y item-03)) 5933)
    (<= (y item-03) 2914) (>= (y item-03) 2004)
    (<= (+ (y item-03) 1014) (x item-03)) (<= (x item-03) (+ (y item-03) 2301))
    (>= (z item-03) 0) (<= (z item-03) 0)
    ; item-04 shall come to (0.7387, 0.0935, 0.0286) m, 30 mm from where it starts
    (<= (x item-04) 4341) (>= (x item-04) 3432)
    (<= (+ (x item-04) (y item-04)) 8465) (>= (+ (x item-04) (y item-04)) 7178)
    (<= (y item-04) 4390) (>= (y item-04) 3480)
    (<= (y item-04) (+ (x item-04) 692)) (<= (x item-04) (+ (y item-04) 595))
    (>= (z item-04) 0) (<= (z item-04) 0)))
  (:metric minimize (total-cost)))
