; Problem task-05 of the learned domain tabletop, for its encoding numeric.
; How it came about: drawn with seed 6: 2 random actions on item-01, item-01; draw 3, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-05)
  (:domain tabletop-numeric)
  (:objects
    item-01 - solid-00)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.6269, 0.1197, 0.0113) m
    (= (x item-01) 2769) (= (y item-01) 4197) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.05625 0.1067 0.02264 0).
    ; Not for item-01:
    ; push-left-1110a-solid-00: scatters more than it moves.
    ; push-right-1000-solid-00: scatters more than it moves.
    ; push-right-1100-solid-00: keeps its promise with such objects in about 6 of 32 only.
    (can-lift-1100-solid-00 item-01) (= (x-of-lift-1100-solid-00 item-01) 9737) (= (y-of-lift-1100-solid-00 item-01) 10240) (= (z-of-lift-1100-solid-00 item-01) 12010) (= (cost-of-lift-1100-solid-00 item-01) 14)
    (= (x-of-put-down-lift-1100-solid-00 item-01) 9998) (= (y-of-put-down-lift-1100-solid-00 item-01) 9993) (= (z-of-put-down-lift-1100-solid-00 item-01) 7990)
    (can-pull-0100a-solid-00 item-01) (= (x-of-pull-0100a-solid-00 item-01) 9225) (= (y-of-pull-0100a-solid-00 item-01) 9667) (= (cost-of-pull-0100a-solid-00 item-01) 7)
    (can-pull-0110a-solid-00 item-01) (= (x-of-pull-0110a-solid-00 item-01) 9654) (= (y-of-pull-0110a-solid-00 item-01) 9922) (= (cost-of-pull-0110a-solid-00 item-01) 4)
    (can-pull-0111a-solid-00 item-01) (= (x-of-pull-0111a-solid-00 item-01) 9522) (= (y-of-pull-0111a-solid-00 item-01) 9958) (= (cost-of-pull-0111a-solid-00 item-01) 4)
    (can-pull-left-0101-solid-00 item-01) (= (x-of-pull-left-0101-solid-00 item-01) 9747) (= (y-of-pull-left-0101-solid-00 item-01) 10464) (= (cost-of-pull-left-0101-solid-00 item-01) 10)
    (can-pull-left-1101-solid-00 item-01) (= (x-of-pull-left-1101-solid-00 item-01) 9639) (= (y-of-pull-left-1101-solid-00 item-01) 10553) (= (cost-of-pull-left-1101-solid-00 item-01) 17)
    (can-pull-left-1111a-solid-00 item-01) (= (x-of-pull-left-1111a-solid-00 item-01) 9839) (= (y-of-pull-left-1111a-solid-00 item-01) 10139) (= (cost-of-pull-left-1111a-solid-00 item-01) 4)
    (can-pull-right-0000a-solid-00 item-01) (= (x-of-pull-right-0000a-solid-00 item-01) 9768) (= (y-of-pull-right-0000a-solid-00 item-01) 9526) (= (cost-of-pull-right-0000a-solid-00 item-01) 45)
    (can-pull-right-1010a-solid-00 item-01) (= (x-of-pull-right-1010a-solid-00 item-01) 9868) (= (y-of-pull-right-1010a-solid-00 item-01) 9741) (= (cost-of-pull-right-1010a-solid-00 item-01) 4)
    (can-push-forward-1011-solid-00 item-01) (= (x-of-push-forward-1011-solid-00 item-01) 10786) (= (y-of-push-forward-1011-solid-00 item-01) 10216) (= (cost-of-push-forward-1011-solid-00 item-01) 7)
    (can-push-forward-1011a-solid-00 item-01) (= (x-of-push-forward-1011a-solid-00 item-01) 10806) (= (y-of-push-forward-1011a-solid-00 item-01) 9788) (= (cost-of-push-forward-1011a-solid-00 item-01) 4)
    (can-push-forward-left-0001a-solid-00 item-01) (= (x-of-push-forward-left-0001a-solid-00 item-01) 10132) (= (y-of-push-forward-left-0001a-solid-00 item-01) 10129) (= (cost-of-push-forward-left-0001a-solid-00 item-01) 10)
    (can-push-forward-left-1001-solid-00 item-01) (= (x-of-push-forward-left-1001-solid-00 item-01) 10165) (= (y-of-push-forward-left-1001-solid-00 item-01) 10428) (= (cost-of-push-forward-left-1001-solid-00 item-01) 4)
    (can-push-forward-right-0010a-solid-00 item-01) (= (x-of-push-forward-right-0010a-solid-00 item-01) 9950) (= (y-of-push-forward-right-0010a-solid-00 item-01) 9774) (= (cost-of-push-forward-right-0010a-solid-00 item-01) 4)
    (can-push-left-0011a-solid-00 item-01) (= (x-of-push-left-0011a-solid-00 item-01) 10057) (= (y-of-push-left-0011a-solid-00 item-01) 10290) (= (cost-of-push-left-0011a-solid-00 item-01) 4)
    (= (x-of-push-left-1110a-solid-00 item-01) 10072) (= (y-of-push-left-1110a-solid-00 item-01) 10282) (= (cost-of-push-left-1110a-solid-00 item-01) 10)
    (= (x-of-push-right-1000-solid-00 item-01) 10017) (= (y-of-push-right-1000-solid-00 item-01) 9865) (= (cost-of-push-right-1000-solid-00 item-01) 4)
    (= (x-of-push-right-1100-solid-00 item-01) 9963) (= (y-of-push-right-1100-solid-00 item-01) 9633) (= (cost-of-push-right-1100-solid-00 item-01) 159))
  (:goal (and
    ; item-01 shall come to (0.6664, 0.0750, 0.2117) m, 209 mm from where it starts
    (<= (x item-01) 3619) (>= (x item-01) 2709)
    (<= (+ (x item-01) (y item-01)) 7557) (>= (+ (x item-01) (y item-01)) 6270)
    (<= (y item-01) 4204) (>= (y item-01) 3294)
    (<= (y item-01) (+ (x item-01) 1228)) (<= (x item-01) (+ (y item-01) 59))
    (>= (z item-01) 2010) (<= (z item-01) 2010)))
  (:metric minimize (total-cost)))
