; Problem task-02 of the learned domain tabletop, for its encoding numeric.
; How it came about: drawn with seed 3: one random action on item-01; draw 3, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-02)
  (:domain tabletop-numeric)
  (:objects
    item-01 - hollow-wide-01)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.5286, 0.0250, 0.0435) m
    (= (x item-01) 1786) (= (y item-01) 3250) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.09307 0.1357 0.08707 1).
    ; Not for item-01:
    ; place-right-0000-hollow-wide-01: keeps its promise in 1 of 35 rehearsals only.
    ; push-right-1000-hollow-wide-01: keeps its promise in 1 of 35 rehearsals only.
    ; push-right-1100a-hollow-wide-01: keeps its promise with such objects in about 6 of 35 only.
    (can-lift-0000-hollow-wide-01 item-01) (= (x-of-lift-0000-hollow-wide-01 item-01) 9921) (= (y-of-lift-0000-hollow-wide-01 item-01) 8971) (= (z-of-lift-0000-hollow-wide-01 item-01) 12554) (= (cost-of-lift-0000-hollow-wide-01 item-01) 22)
    (= (x-of-put-down-lift-0000-hollow-wide-01 item-01) 10001) (= (y-of-put-down-lift-0000-hollow-wide-01 item-01) 9991) (= (z-of-put-down-lift-0000-hollow-wide-01 item-01) 7446)
    (can-lift-0000b-hollow-wide-01 item-01) (= (x-of-lift-0000b-hollow-wide-01 item-01) 9776) (= (y-of-lift-0000b-hollow-wide-01 item-01) 9483) (= (z-of-lift-0000b-hollow-wide-01 item-01) 12356) (= (cost-of-lift-0000b-hollow-wide-01 item-01) 4)
    (= (x-of-put-down-lift-0000b-hollow-wide-01 item-01) 10002) (= (y-of-put-down-lift-0000b-hollow-wide-01 item-01) 9981) (= (z-of-put-down-lift-0000b-hollow-wide-01 item-01) 7644)
    (can-lift-0001b-hollow-wide-01 item-01) (= (x-of-lift-0001b-hollow-wide-01 item-01) 9766) (= (y-of-lift-0001b-hollow-wide-01 item-01) 10160) (= (z-of-lift-0001b-hollow-wide-01 item-01) 11988) (= (cost-of-lift-0001b-hollow-wide-01 item-01) 7)
    (= (x-of-put-down-lift-0001b-hollow-wide-01 item-01) 9988) (= (y-of-put-down-lift-0001b-hollow-wide-01 item-01) 9967) (= (z-of-put-down-lift-0001b-hollow-wide-01 item-01) 8012)
    (can-lift-0100b-hollow-wide-01 item-01) (= (x-of-lift-0100b-hollow-wide-01 item-01) 9779) (= (y-of-lift-0100b-hollow-wide-01 item-01) 9252) (= (z-of-lift-0100b-hollow-wide-01 item-01) 11934) (= (cost-of-lift-0100b-hollow-wide-01 item-01) 36)
    (= (x-of-put-down-lift-0100b-hollow-wide-01 item-01) 10000) (= (y-of-put-down-lift-0100b-hollow-wide-01 item-01) 9975) (= (z-of-put-down-lift-0100b-hollow-wide-01 item-01) 8066)
    (can-lift-0101a-hollow-wide-01 item-01) (= (x-of-lift-0101a-hollow-wide-01 item-01) 9775) (= (y-of-lift-0101a-hollow-wide-01 item-01) 10418) (= (z-of-lift-0101a-hollow-wide-01 item-01) 12578) (= (cost-of-lift-0101a-hollow-wide-01 item-01) 4)
    (= (x-of-put-down-lift-0101a-hollow-wide-01 item-01) 10010) (= (y-of-put-down-lift-0101a-hollow-wide-01 item-01) 9982) (= (z-of-put-down-lift-0101a-hollow-wide-01 item-01) 7422)
    (can-lift-1000-hollow-wide-01 item-01) (= (x-of-lift-1000-hollow-wide-01 item-01) 10517) (= (y-of-lift-1000-hollow-wide-01 item-01) 9665) (= (z-of-lift-1000-hollow-wide-01 item-01) 12007) (= (cost-of-lift-1000-hollow-wide-01 item-01) 7)
    (= (x-of-put-down-lift-1000-hollow-wide-01 item-01) 9997) (= (y-of-put-down-lift-1000-hollow-wide-01 item-01) 9983) (= (z-of-put-down-lift-1000-hollow-wide-01 item-01) 7993)
    (can-lift-1000a-hollow-wide-01 item-01) (= (x-of-lift-1000a-hollow-wide-01 item-01) 10434) (= (y-of-lift-1000a-hollow-wide-01 item-01) 8917) (= (z-of-lift-1000a-hollow-wide-01 item-01) 12131) (= (cost-of-lift-1000a-hollow-wide-01 item-01) 4)
    (= (x-of-put-down-lift-1000a-hollow-wide-01 item-01) 10000) (= (y-of-put-down-lift-1000a-hollow-wide-01 item-01) 9965) (= (z-of-put-down-lift-1000a-hollow-wide-01 item-01) 7869)
    (can-lift-1001a-hollow-wide-01 item-01) (= (x-of-lift-1001a-hollow-wide-01 item-01) 10513) (= (y-of-lift-1001a-hollow-wide-01 item-01) 10575) (= (z-of-lift-1001a-hollow-wide-01 item-01) 12576) (= (cost-of-lift-1001a-hollow-wide-01 item-01) 4)
    (= (x-of-put-down-lift-1001a-hollow-wide-01 item-01) 9994) (= (y-of-put-down-lift-1001a-hollow-wide-01 item-01) 9984) (= (z-of-put-down-lift-1001a-hollow-wide-01 item-01) 7424)
    (can-lift-1100a-hollow-wide-01 item-01) (= (x-of-lift-1100a-hollow-wide-01 item-01) 10030) (= (y-of-lift-1100a-hollow-wide-01 item-01) 9516) (= (z-of-lift-1100a-hollow-wide-01 item-01) 12015) (= (cost-of-lift-1100a-hollow-wide-01 item-01) 29)
    (= (x-of-put-down-lift-1100a-hollow-wide-01 item-01) 9997) (= (y-of-put-down-lift-1100a-hollow-wide-01 item-01) 9977) (= (z-of-put-down-lift-1100a-hollow-wide-01 item-01) 7985)
    (can-lift-1101a-hollow-wide-01 item-01) (= (x-of-lift-1101a-hollow-wide-01 item-01) 10368) (= (y-of-lift-1101a-hollow-wide-01 item-01) 10427) (= (z-of-lift-1101a-hollow-wide-01 item-01) 11961) (= (cost-of-lift-1101a-hollow-wide-01 item-01) 4)
    (= (x-of-put-down-lift-1101a-hollow-wide-01 item-01) 10001) (= (y-of-put-down-lift-1101a-hollow-wide-01 item-01) 9985) (= (z-of-put-down-lift-1101a-hollow-wide-01 item-01) 8039)
    (= (x-of-place-right-0000-hollow-wide-01 item-01) 9950) (= (y-of-place-right-0000-hollow-wide-01 item-01) 9329) (= (cost-of-place-right-0000-hollow-wide-01 item-01) 293)
    (can-pull-0111-hollow-wide-01 item-01) (= (x-of-pull-0111-hollow-wide-01 item-01) 9447) (= (y-of-pull-0111-hollow-wide-01 item-01) 10138) (= (cost-of-pull-0111-hollow-wide-01 item-01) 9)
    (can-pull-left-0111b-hollow-wide-01 item-01) (= (x-of-pull-left-0111b-hollow-wide-01 item-01) 9526) (= (y-of-pull-left-0111b-hollow-wide-01 item-01) 10683) (= (cost-of-pull-left-0111b-hollow-wide-01 item-01) 4)
    (can-pull-right-0110-hollow-wide-01 item-01) (= (x-of-pull-right-0110-hollow-wide-01 item-01) 9647) (= (y-of-pull-right-0110-hollow-wide-01 item-01) 9463) (= (cost-of-pull-right-0110-hollow-wide-01 item-01) 16)
    (can-pull-right-1110b-hollow-wide-01 item-01) (= (x-of-pull-right-1110b-hollow-wide-01 item-01) 9727) (= (y-of-pull-right-1110b-hollow-wide-01 item-01) 9811) (= (cost-of-pull-right-1110b-hollow-wide-01 item-01) 4)
    (can-push-forward-left-1011b-hollow-wide-01 item-01) (= (x-of-push-forward-left-1011b-hollow-wide-01 item-01) 10338) (= (y-of-push-forward-left-1011b-hollow-wide-01 item-01) 10181) (= (cost-of-push-forward-left-1011b-hollow-wide-01 item-01) 4)
    (can-push-forward-right-0010b-hollow-wide-01 item-01) (= (x-of-push-forward-right-0010b-hollow-wide-01 item-01) 10419) (= (y-of-push-forward-right-0010b-hollow-wide-01 item-01) 9672) (= (cost-of-push-forward-right-0010b-hollow-wide-01 item-01) 4)
    (can-push-left-0011b-hollow-wide-01 item-01) (= (x-of-push-left-0011b-hollow-wide-01 item-01) 10297) (= (y-of-push-left-0011b-hollow-wide-01 item-01) 10652) (= (cost-of-push-left-0011b-hollow-wide-01 item-01) 4)
    (can-push-left-1111-hollow-wide-01 item-01) (= (x-of-push-left-1111-hollow-wide-01 item-01) 9923) (= (y-of-push-left-1111-hollow-wide-01 item-01) 10318) (= (cost-of-push-left-1111-hollow-wide-01 item-01) 7)
    (can-push-right-0100b-hollow-wide-01 item-01) (= (x-of-push-right-0100b-hollow-wide-01 item-01) 9851) (= (y-of-push-right-0100b-hollow-wide-01 item-01) 9436) (= (cost-of-push-right-0100b-hollow-wide-01 item-01) 106)
    (can-push-right-0110b-hollow-wide-01 item-01) (= (x-of-push-right-0110b-hollow-wide-01 item-01) 9653) (= (y-of-push-right-0110b-hollow-wide-01 item-01) 9215) (= (cost-of-push-right-0110b-hollow-wide-01 item-01) 16)
    (= (x-of-push-right-1000-hollow-wide-01 item-01) 10010) (= (y-of-push-right-1000-hollow-wide-01 item-01) 9826) (= (cost-of-push-right-1000-hollow-wide-01 item-01) 293)
    (can-push-right-1010-hollow-wide-01 item-01) (= (x-of-push-right-1010-hollow-wide-01 item-01) 10158) (= (y-of-push-right-1010-hollow-wide-01 item-01) 8994) (= (cost-of-push-right-1010-hollow-wide-01 item-01) 7)
    (can-push-right-1010b-hollow-wide-01 item-01) (= (x-of-push-right-1010b-hollow-wide-01 item-01) 10067) (= (y-of-push-right-1010b-hollow-wide-01 item-01) 9308) (= (cost-of-push-right-1010b-hollow-wide-01 item-01) 4)
    (= (x-of-push-right-1100a-hollow-wide-01 item-01) 9956) (= (y-of-push-right-1100a-hollow-wide-01 item-01) 9622) (= (cost-of-push-right-1100a-hollow-wide-01 item-01) 168))
  (:goal (and
    ; item-01 shall come to (0.4756, 0.0588, 0.2666) m, 232 mm from where it starts
    (<= (x item-01) 1580) (>= (x item-01) 930)
    (<= (+ (x item-01) (y item-01)) 5303) (>= (+ (x item-01) (y item-01)) 4383)
    (<= (y item-01) 3913) (>= (y item-01) 3263)
    (<= (y item-01) (+ (x item-01) 2792)) (<= (+ (x item-01) 1873) (y item-01))
    (>= (z item-01) 1934) (<= (z item-01) 2578)))
  (:metric minimize (total-cost)))
