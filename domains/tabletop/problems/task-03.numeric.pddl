; Problem task-03 of the learned domain tabletop, for its encoding numeric.
; How it came about: drawn with seed 4: one random action on item-01; draw 3, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-03)
  (:domain tabletop-numeric)
  (:objects
    item-01 - hollow-wide-01)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.7832, 0.0401, 0.0239) m
    (= (x item-01) 4332) (= (y item-01) 3401) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.1456 0.1456 0.04781 2).
    ; Not for item-01:
    ; lift-1100a-hollow-wide-01: keeps its promise with such objects in about 7 of 35 only.
    ; push-right-1000-hollow-wide-01: keeps its promise in 1 of 35 rehearsals only.
    (can-lift-0000-hollow-wide-01 item-01) (= (x-of-lift-0000-hollow-wide-01 item-01) 10040) (= (y-of-lift-0000-hollow-wide-01 item-01) 8960) (= (z-of-lift-0000-hollow-wide-01 item-01) 12628) (= (cost-of-lift-0000-hollow-wide-01 item-01) 22)
    (= (x-of-put-down-lift-0000-hollow-wide-01 item-01) 10005) (= (y-of-put-down-lift-0000-hollow-wide-01 item-01) 9954) (= (z-of-put-down-lift-0000-hollow-wide-01 item-01) 7372)
    (can-lift-0000b-hollow-wide-01 item-01) (= (x-of-lift-0000b-hollow-wide-01 item-01) 9635) (= (y-of-lift-0000b-hollow-wide-01 item-01) 9441) (= (z-of-lift-0000b-hollow-wide-01 item-01) 12332) (= (cost-of-lift-0000b-hollow-wide-01 item-01) 4)
    (= (x-of-put-down-lift-0000b-hollow-wide-01 item-01) 10007) (= (y-of-put-down-lift-0000b-hollow-wide-01 item-01) 9963) (= (z-of-put-down-lift-0000b-hollow-wide-01 item-01) 7668)
    (can-lift-0001b-hollow-wide-01 item-01) (= (x-of-lift-0001b-hollow-wide-01 item-01) 9835) (= (y-of-lift-0001b-hollow-wide-01 item-01) 10162) (= (z-of-lift-0001b-hollow-wide-01 item-01) 11976) (= (cost-of-lift-0001b-hollow-wide-01 item-01) 7)
    (= (x-of-put-down-lift-0001b-hollow-wide-01 item-01) 9997) (= (y-of-put-down-lift-0001b-hollow-wide-01 item-01) 9973) (= (z-of-put-down-lift-0001b-hollow-wide-01 item-01) 8024)
    (can-lift-0100b-hollow-wide-01 item-01) (= (x-of-lift-0100b-hollow-wide-01 item-01) 9631) (= (y-of-lift-0100b-hollow-wide-01 item-01) 9232) (= (z-of-lift-0100b-hollow-wide-01 item-01) 11968) (= (cost-of-lift-0100b-hollow-wide-01 item-01) 122)
    (= (x-of-put-down-lift-0100b-hollow-wide-01 item-01) 10012) (= (y-of-put-down-lift-0100b-hollow-wide-01 item-01) 9969) (= (z-of-put-down-lift-0100b-hollow-wide-01 item-01) 8032)
    (can-lift-0101a-hollow-wide-01 item-01) (= (x-of-lift-0101a-hollow-wide-01 item-01) 9744) (= (y-of-lift-0101a-hollow-wide-01 item-01) 10430) (= (z-of-lift-0101a-hollow-wide-01 item-01) 12505) (= (cost-of-lift-0101a-hollow-wide-01 item-01) 4)
    (= (x-of-put-down-lift-0101a-hollow-wide-01 item-01) 9999) (= (y-of-put-down-lift-0101a-hollow-wide-01 item-01) 9962) (= (z-of-put-down-lift-0101a-hollow-wide-01 item-01) 7495)
    (can-lift-1000-hollow-wide-01 item-01) (= (x-of-lift-1000-hollow-wide-01 item-01) 10469) (= (y-of-lift-1000-hollow-wide-01 item-01) 9622) (= (z-of-lift-1000-hollow-wide-01 item-01) 11996) (= (cost-of-lift-1000-hollow-wide-01 item-01) 7)
    (= (x-of-put-down-lift-1000-hollow-wide-01 item-01) 9999) (= (y-of-put-down-lift-1000-hollow-wide-01 item-01) 9972) (= (z-of-put-down-lift-1000-hollow-wide-01 item-01) 8004)
    (can-lift-1000a-hollow-wide-01 item-01) (= (x-of-lift-1000a-hollow-wide-01 item-01) 10507) (= (y-of-lift-1000a-hollow-wide-01 item-01) 8851) (= (z-of-lift-1000a-hollow-wide-01 item-01) 12196) (= (cost-of-lift-1000a-hollow-wide-01 item-01) 4)
    (= (x-of-put-down-lift-1000a-hollow-wide-01 item-01) 9999) (= (y-of-put-down-lift-1000a-hollow-wide-01 item-01) 9964) (= (z-of-put-down-lift-1000a-hollow-wide-01 item-01) 7804)
    (can-lift-1001a-hollow-wide-01 item-01) (= (x-of-lift-1001a-hollow-wide-01 item-01) 10446) (= (y-of-lift-1001a-hollow-wide-01 item-01) 10601) (= (z-of-lift-1001a-hollow-wide-01 item-01) 12499) (= (cost-of-lift-1001a-hollow-wide-01 item-01) 4)
    (= (x-of-put-down-lift-1001a-hollow-wide-01 item-01) 10006) (= (y-of-put-down-lift-1001a-hollow-wide-01 item-01) 9975) (= (z-of-put-down-lift-1001a-hollow-wide-01 item-01) 7501)
    (= (x-of-lift-1100a-hollow-wide-01 item-01) 9853) (= (y-of-lift-1100a-hollow-wide-01 item-01) 9433) (= (z-of-lift-1100a-hollow-wide-01 item-01) 11997) (= (cost-of-lift-1100a-hollow-wide-01 item-01) 154)
    (= (x-of-put-down-lift-1100a-hollow-wide-01 item-01) 9992) (= (y-of-put-down-lift-1100a-hollow-wide-01 item-01) 9964) (= (z-of-put-down-lift-1100a-hollow-wide-01 item-01) 8003)
    (can-lift-1101a-hollow-wide-01 item-01) (= (x-of-lift-1101a-hollow-wide-01 item-01) 10401) (= (y-of-lift-1101a-hollow-wide-01 item-01) 10426) (= (z-of-lift-1101a-hollow-wide-01 item-01) 11989) (= (cost-of-lift-1101a-hollow-wide-01 item-01) 4)
    (= (x-of-put-down-lift-1101a-hollow-wide-01 item-01) 9998) (= (y-of-put-down-lift-1101a-hollow-wide-01 item-01) 9965) (= (z-of-put-down-lift-1101a-hollow-wide-01 item-01) 8011)
    (can-place-right-0000-hollow-wide-01 item-01) (= (x-of-place-right-0000-hollow-wide-01 item-01) 9961) (= (y-of-place-right-0000-hollow-wide-01 item-01) 9302) (= (cost-of-place-right-0000-hollow-wide-01 item-01) 132)
    (can-pull-0111-hollow-wide-01 item-01) (= (x-of-pull-0111-hollow-wide-01 item-01) 8698) (= (y-of-pull-0111-hollow-wide-01 item-01) 10244) (= (cost-of-pull-0111-hollow-wide-01 item-01) 9)
    (can-pull-left-0111b-hollow-wide-01 item-01) (= (x-of-pull-left-0111b-hollow-wide-01 item-01) 9548) (= (y-of-pull-left-0111b-hollow-wide-01 item-01) 10664) (= (cost-of-pull-left-0111b-hollow-wide-01 item-01) 4)
    (can-pull-right-0110-hollow-wide-01 item-01) (= (x-of-pull-right-0110-hollow-wide-01 item-01) 9651) (= (y-of-pull-right-0110-hollow-wide-01 item-01) 9490) (= (cost-of-pull-right-0110-hollow-wide-01 item-01) 40)
    (can-pull-right-1110b-hollow-wide-01 item-01) (= (x-of-pull-right-1110b-hollow-wide-01 item-01) 9644) (= (y-of-pull-right-1110b-hollow-wide-01 item-01) 9812) (= (cost-of-pull-right-1110b-hollow-wide-01 item-01) 4)
    (can-push-forward-left-1011b-hollow-wide-01 item-01) (= (x-of-push-forward-left-1011b-hollow-wide-01 item-01) 10421) (= (y-of-push-forward-left-1011b-hollow-wide-01 item-01) 10231) (= (cost-of-push-forward-left-1011b-hollow-wide-01 item-01) 4)
    (can-push-forward-right-0010b-hollow-wide-01 item-01) (= (x-of-push-forward-right-0010b-hollow-wide-01 item-01) 10431) (= (y-of-push-forward-right-0010b-hollow-wide-01 item-01) 9656) (= (cost-of-push-forward-right-0010b-hollow-wide-01 item-01) 4)
    (can-push-left-0011b-hollow-wide-01 item-01) (= (x-of-push-left-0011b-hollow-wide-01 item-01) 10295) (= (y-of-push-left-0011b-hollow-wide-01 item-01) 10668) (= (cost-of-push-left-0011b-hollow-wide-01 item-01) 4)
    (can-push-left-1111-hollow-wide-01 item-01) (= (x-of-push-left-1111-hollow-wide-01 item-01) 9928) (= (y-of-push-left-1111-hollow-wide-01 item-01) 10295) (= (cost-of-push-left-1111-hollow-wide-01 item-01) 9)
    (can-push-right-0100b-hollow-wide-01 item-01) (= (x-of-push-right-0100b-hollow-wide-01 item-01) 9833) (= (y-of-push-right-0100b-hollow-wide-01 item-01) 9468) (= (cost-of-push-right-0100b-hollow-wide-01 item-01) 98)
    (can-push-right-0110b-hollow-wide-01 item-01) (= (x-of-push-right-0110b-hollow-wide-01 item-01) 9558) (= (y-of-push-right-0110b-hollow-wide-01 item-01) 9153) (= (cost-of-push-right-0110b-hollow-wide-01 item-01) 9)
    (= (x-of-push-right-1000-hollow-wide-01 item-01) 10020) (= (y-of-push-right-1000-hollow-wide-01 item-01) 9839) (= (cost-of-push-right-1000-hollow-wide-01 item-01) 293)
    (can-push-right-1010-hollow-wide-01 item-01) (= (x-of-push-right-1010-hollow-wide-01 item-01) 10384) (= (y-of-push-right-1010-hollow-wide-01 item-01) 8941) (= (cost-of-push-right-1010-hollow-wide-01 item-01) 7)
    (can-push-right-1010b-hollow-wide-01 item-01) (= (x-of-push-right-1010b-hollow-wide-01 item-01) 10101) (= (y-of-push-right-1010b-hollow-wide-01 item-01) 9322) (= (cost-of-push-right-1010b-hollow-wide-01 item-01) 4)
    (can-push-right-1100a-hollow-wide-01 item-01) (= (x-of-push-right-1100a-hollow-wide-01 item-01) 9979) (= (y-of-push-right-1100a-hollow-wide-01 item-01) 9693) (= (cost-of-push-right-1100a-hollow-wide-01 item-01) 36))
  (:goal (and
    ; item-01 shall come to (0.7755, 0.0952, 0.0239) m, 56 mm from where it starts
    (<= (x item-01) 4711) (>= (x item-01) 3801)
    (<= (+ (x item-01) (y item-01)) 8852) (>= (+ (x item-01) (y item-01)) 7565)
    (<= (y item-01) 4408) (>= (y item-01) 3498)
    (<= (y item-01) (+ (x item-01) 341)) (<= (x item-01) (+ (y item-01) 946))
    (>= (z item-01) 0) (<= (z item-01) 0)))
  (:metric minimize (total-cost)))
