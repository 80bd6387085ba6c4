; Problem task-04 of the learned domain tabletop, for its encoding numeric.
; How it came about: drawn with seed 5: one random action on item-01; draw 6, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-04)
  (:domain tabletop-numeric)
  (:objects
    item-01 - hollow-wide-01)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.5941, -0.0363, 0.0220) m
    (= (x item-01) 2441) (= (y item-01) 2637) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.1698 0.1698 0.04403 2).
    ; Not for item-01:
    ; lift-0100b-hollow-wide-01: keeps its promise with such objects in about 8 of 35 only.
    ; lift-1100a-hollow-wide-01: keeps its promise with such objects in about 6 of 35 only.
    ; place-right-0000-hollow-wide-01: keeps its promise in 1 of 35 rehearsals only.
    ; push-right-1000-hollow-wide-01: keeps its promise in 1 of 35 rehearsals only.
    (can-lift-0000-hollow-wide-01 item-01) (= (x-of-lift-0000-hollow-wide-01 item-01) 10074) (= (y-of-lift-0000-hollow-wide-01 item-01) 8835) (= (z-of-lift-0000-hollow-wide-01 item-01) 12477) (= (cost-of-lift-0000-hollow-wide-01 item-01) 7)
    (= (x-of-put-down-lift-0000-hollow-wide-01 item-01) 9998) (= (y-of-put-down-lift-0000-hollow-wide-01 item-01) 9965) (= (z-of-put-down-lift-0000-hollow-wide-01 item-01) 7523)
    (can-lift-0000b-hollow-wide-01 item-01) (= (x-of-lift-0000b-hollow-wide-01 item-01) 9618) (= (y-of-lift-0000b-hollow-wide-01 item-01) 9320) (= (z-of-lift-0000b-hollow-wide-01 item-01) 12307) (= (cost-of-lift-0000b-hollow-wide-01 item-01) 4)
    (= (x-of-put-down-lift-0000b-hollow-wide-01 item-01) 10008) (= (y-of-put-down-lift-0000b-hollow-wide-01 item-01) 9966) (= (z-of-put-down-lift-0000b-hollow-wide-01 item-01) 7693)
    (can-lift-0001b-hollow-wide-01 item-01) (= (x-of-lift-0001b-hollow-wide-01 item-01) 9863) (= (y-of-lift-0001b-hollow-wide-01 item-01) 10283) (= (z-of-lift-0001b-hollow-wide-01 item-01) 11976) (= (cost-of-lift-0001b-hollow-wide-01 item-01) 7)
    (= (x-of-put-down-lift-0001b-hollow-wide-01 item-01) 9996) (= (y-of-put-down-lift-0001b-hollow-wide-01 item-01) 9971) (= (z-of-put-down-lift-0001b-hollow-wide-01 item-01) 8024)
    (= (x-of-lift-0100b-hollow-wide-01 item-01) 9681) (= (y-of-lift-0100b-hollow-wide-01 item-01) 9295) (= (z-of-lift-0100b-hollow-wide-01 item-01) 11949) (= (cost-of-lift-0100b-hollow-wide-01 item-01) 142)
    (= (x-of-put-down-lift-0100b-hollow-wide-01 item-01) 10007) (= (y-of-put-down-lift-0100b-hollow-wide-01 item-01) 9962) (= (z-of-put-down-lift-0100b-hollow-wide-01 item-01) 8051)
    (can-lift-0101a-hollow-wide-01 item-01) (= (x-of-lift-0101a-hollow-wide-01 item-01) 9737) (= (y-of-lift-0101a-hollow-wide-01 item-01) 10552) (= (z-of-lift-0101a-hollow-wide-01 item-01) 12483) (= (cost-of-lift-0101a-hollow-wide-01 item-01) 4)
    (= (x-of-put-down-lift-0101a-hollow-wide-01 item-01) 9996) (= (y-of-put-down-lift-0101a-hollow-wide-01 item-01) 9962) (= (z-of-put-down-lift-0101a-hollow-wide-01 item-01) 7517)
    (can-lift-1000-hollow-wide-01 item-01) (= (x-of-lift-1000-hollow-wide-01 item-01) 10410) (= (y-of-lift-1000-hollow-wide-01 item-01) 9497) (= (z-of-lift-1000-hollow-wide-01 item-01) 11988) (= (cost-of-lift-1000-hollow-wide-01 item-01) 7)
    (= (x-of-put-down-lift-1000-hollow-wide-01 item-01) 10001) (= (y-of-put-down-lift-1000-hollow-wide-01 item-01) 9969) (= (z-of-put-down-lift-1000-hollow-wide-01 item-01) 8012)
    (can-lift-1000a-hollow-wide-01 item-01) (= (x-of-lift-1000a-hollow-wide-01 item-01) 10515) (= (y-of-lift-1000a-hollow-wide-01 item-01) 8729) (= (z-of-lift-1000a-hollow-wide-01 item-01) 12178) (= (cost-of-lift-1000a-hollow-wide-01 item-01) 4)
    (= (x-of-put-down-lift-1000a-hollow-wide-01 item-01) 9999) (= (y-of-put-down-lift-1000a-hollow-wide-01 item-01) 9966) (= (z-of-put-down-lift-1000a-hollow-wide-01 item-01) 7822)
    (can-lift-1001a-hollow-wide-01 item-01) (= (x-of-lift-1001a-hollow-wide-01 item-01) 10411) (= (y-of-lift-1001a-hollow-wide-01 item-01) 10721) (= (z-of-lift-1001a-hollow-wide-01 item-01) 12480) (= (cost-of-lift-1001a-hollow-wide-01 item-01) 4)
    (= (x-of-put-down-lift-1001a-hollow-wide-01 item-01) 10002) (= (y-of-put-down-lift-1001a-hollow-wide-01 item-01) 9972) (= (z-of-put-down-lift-1001a-hollow-wide-01 item-01) 7520)
    (= (x-of-lift-1100a-hollow-wide-01 item-01) 9880) (= (y-of-lift-1100a-hollow-wide-01 item-01) 9466) (= (z-of-lift-1100a-hollow-wide-01 item-01) 12008) (= (cost-of-lift-1100a-hollow-wide-01 item-01) 168)
    (= (x-of-put-down-lift-1100a-hollow-wide-01 item-01) 9998) (= (y-of-put-down-lift-1100a-hollow-wide-01 item-01) 9967) (= (z-of-put-down-lift-1100a-hollow-wide-01 item-01) 7992)
    (can-lift-1101a-hollow-wide-01 item-01) (= (x-of-lift-1101a-hollow-wide-01 item-01) 10436) (= (y-of-lift-1101a-hollow-wide-01 item-01) 10546) (= (z-of-lift-1101a-hollow-wide-01 item-01) 11990) (= (cost-of-lift-1101a-hollow-wide-01 item-01) 4)
    (= (x-of-put-down-lift-1101a-hollow-wide-01 item-01) 9997) (= (y-of-put-down-lift-1101a-hollow-wide-01 item-01) 9961) (= (z-of-put-down-lift-1101a-hollow-wide-01 item-01) 8010)
    (= (x-of-place-right-0000-hollow-wide-01 item-01) 9951) (= (y-of-place-right-0000-hollow-wide-01 item-01) 9325) (= (cost-of-place-right-0000-hollow-wide-01 item-01) 293)
    (can-pull-0111-hollow-wide-01 item-01) (= (x-of-pull-0111-hollow-wide-01 item-01) 9544) (= (y-of-pull-0111-hollow-wide-01 item-01) 10096) (= (cost-of-pull-0111-hollow-wide-01 item-01) 9)
    (can-pull-left-0111b-hollow-wide-01 item-01) (= (x-of-pull-left-0111b-hollow-wide-01 item-01) 9577) (= (y-of-pull-left-0111b-hollow-wide-01 item-01) 10791) (= (cost-of-pull-left-0111b-hollow-wide-01 item-01) 4)
    (can-pull-right-0110-hollow-wide-01 item-01) (= (x-of-pull-right-0110-hollow-wide-01 item-01) 9644) (= (y-of-pull-right-0110-hollow-wide-01 item-01) 9367) (= (cost-of-pull-right-0110-hollow-wide-01 item-01) 7)
    (can-pull-right-1110b-hollow-wide-01 item-01) (= (x-of-pull-right-1110b-hollow-wide-01 item-01) 9652) (= (y-of-pull-right-1110b-hollow-wide-01 item-01) 9813) (= (cost-of-pull-right-1110b-hollow-wide-01 item-01) 4)
    (can-push-forward-left-1011b-hollow-wide-01 item-01) (= (x-of-push-forward-left-1011b-hollow-wide-01 item-01) 10417) (= (y-of-push-forward-left-1011b-hollow-wide-01 item-01) 10224) (= (cost-of-push-forward-left-1011b-hollow-wide-01 item-01) 4)
    (can-push-forward-right-0010b-hollow-wide-01 item-01) (= (x-of-push-forward-right-0010b-hollow-wide-01 item-01) 10415) (= (y-of-push-forward-right-0010b-hollow-wide-01 item-01) 9664) (= (cost-of-push-forward-right-0010b-hollow-wide-01 item-01) 4)
    (can-push-left-0011b-hollow-wide-01 item-01) (= (x-of-push-left-0011b-hollow-wide-01 item-01) 10262) (= (y-of-push-left-0011b-hollow-wide-01 item-01) 10778) (= (cost-of-push-left-0011b-hollow-wide-01 item-01) 4)
    (can-push-left-1111-hollow-wide-01 item-01) (= (x-of-push-left-1111-hollow-wide-01 item-01) 9882) (= (y-of-push-left-1111-hollow-wide-01 item-01) 10494) (= (cost-of-push-left-1111-hollow-wide-01 item-01) 7)
    (can-push-right-0100b-hollow-wide-01 item-01) (= (x-of-push-right-0100b-hollow-wide-01 item-01) 9847) (= (y-of-push-right-0100b-hollow-wide-01 item-01) 9435) (= (cost-of-push-right-0100b-hollow-wide-01 item-01) 22)
    (can-push-right-0110b-hollow-wide-01 item-01) (= (x-of-push-right-0110b-hollow-wide-01 item-01) 9486) (= (y-of-push-right-0110b-hollow-wide-01 item-01) 8931) (= (cost-of-push-right-0110b-hollow-wide-01 item-01) 4)
    (= (x-of-push-right-1000-hollow-wide-01 item-01) 10015) (= (y-of-push-right-1000-hollow-wide-01 item-01) 9837) (= (cost-of-push-right-1000-hollow-wide-01 item-01) 293)
    (can-push-right-1010-hollow-wide-01 item-01) (= (x-of-push-right-1010-hollow-wide-01 item-01) 10395) (= (y-of-push-right-1010-hollow-wide-01 item-01) 8775) (= (cost-of-push-right-1010-hollow-wide-01 item-01) 7)
    (can-push-right-1010b-hollow-wide-01 item-01) (= (x-of-push-right-1010b-hollow-wide-01 item-01) 10073) (= (y-of-push-right-1010b-hollow-wide-01 item-01) 9372) (= (cost-of-push-right-1010b-hollow-wide-01 item-01) 4)
    (can-push-right-1100a-hollow-wide-01 item-01) (= (x-of-push-right-1100a-hollow-wide-01 item-01) 9983) (= (y-of-push-right-1100a-hollow-wide-01 item-01) 9488) (= (cost-of-push-right-1100a-hollow-wide-01 item-01) 12))
  (:goal (and
    ; item-01 shall come to (0.5828, -0.0295, 0.2220) m, 200 mm from where it starts
    (<= (x item-01) 2753) (>= (x item-01) 1904)
    (<= (+ (x item-01) (y item-01)) 5634) (>= (+ (x item-01) (y item-01)) 4433)
    (<= (y item-01) 3129) (>= (y item-01) 2280)
    (<= (y item-01) (+ (x item-01) 977)) (<= (x item-01) (+ (y item-01) 224))
    (>= (z item-01) 1976) (<= (z item-01) 2178)))
  (:metric minimize (total-cost)))
