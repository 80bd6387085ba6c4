; Problem task-07 of the learned domain tabletop, for its encoding numeric.
; How it came about: drawn with seed 8: one random action on item-02; draw 5, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-07)
  (:domain tabletop-numeric)
  (:objects
    item-01 - solid-low-narrow-11
    item-02 - hollow-wide-01)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.6189, -0.0203, 0.0491) m
    (= (x item-01) 2689) (= (y item-01) 2797) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.1613 0.06352 0.09828 0).
    ; Not for item-01:
    ; push-forward-right-1101-solid-low-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    (can-lift-0000d-solid-low-narrow-11 item-01) (= (x-of-lift-0000d-solid-low-narrow-11 item-01) 9672) (= (y-of-lift-0000d-solid-low-narrow-11 item-01) 9639) (= (z-of-lift-0000d-solid-low-narrow-11 item-01) 12523) (= (cost-of-lift-0000d-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-0000d-solid-low-narrow-11 item-01) 10002) (= (y-of-put-down-lift-0000d-solid-low-narrow-11 item-01) 9987) (= (z-of-put-down-lift-0000d-solid-low-narrow-11 item-01) 7477)
    (can-lift-0001d-solid-low-narrow-11 item-01) (= (x-of-lift-0001d-solid-low-narrow-11 item-01) 10036) (= (y-of-lift-0001d-solid-low-narrow-11 item-01) 9500) (= (z-of-lift-0001d-solid-low-narrow-11 item-01) 12001) (= (cost-of-lift-0001d-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-0001d-solid-low-narrow-11 item-01) 10001) (= (y-of-put-down-lift-0001d-solid-low-narrow-11 item-01) 9995) (= (z-of-put-down-lift-0001d-solid-low-narrow-11 item-01) 7999)
    (can-lift-0100-solid-low-narrow-11 item-01) (= (x-of-lift-0100-solid-low-narrow-11 item-01) 9235) (= (y-of-lift-0100-solid-low-narrow-11 item-01) 9620) (= (z-of-lift-0100-solid-low-narrow-11 item-01) 12006) (= (cost-of-lift-0100-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-0100-solid-low-narrow-11 item-01) 10009) (= (y-of-put-down-lift-0100-solid-low-narrow-11 item-01) 9984) (= (z-of-put-down-lift-0100-solid-low-narrow-11 item-01) 7994)
    (can-lift-0100d-solid-low-narrow-11 item-01) (= (x-of-lift-0100d-solid-low-narrow-11 item-01) 9414) (= (y-of-lift-0100d-solid-low-narrow-11 item-01) 10484) (= (z-of-lift-0100d-solid-low-narrow-11 item-01) 12070) (= (cost-of-lift-0100d-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-0100d-solid-low-narrow-11 item-01) 10002) (= (y-of-put-down-lift-0100d-solid-low-narrow-11 item-01) 9993) (= (z-of-put-down-lift-0100d-solid-low-narrow-11 item-01) 7930)
    (can-lift-0101-solid-low-narrow-11 item-01) (= (x-of-lift-0101-solid-low-narrow-11 item-01) 9651) (= (y-of-lift-0101-solid-low-narrow-11 item-01) 10362) (= (z-of-lift-0101-solid-low-narrow-11 item-01) 12590) (= (cost-of-lift-0101-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-0101-solid-low-narrow-11 item-01) 10002) (= (y-of-put-down-lift-0101-solid-low-narrow-11 item-01) 9990) (= (z-of-put-down-lift-0101-solid-low-narrow-11 item-01) 7410)
    (can-lift-0101c-solid-low-narrow-11 item-01) (= (x-of-lift-0101c-solid-low-narrow-11 item-01) 9473) (= (y-of-lift-0101c-solid-low-narrow-11 item-01) 9492) (= (z-of-lift-0101c-solid-low-narrow-11 item-01) 12056) (= (cost-of-lift-0101c-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-0101c-solid-low-narrow-11 item-01) 10001) (= (y-of-put-down-lift-0101c-solid-low-narrow-11 item-01) 9991) (= (z-of-put-down-lift-0101c-solid-low-narrow-11 item-01) 7944)
    (can-lift-1000-solid-low-narrow-11 item-01) (= (x-of-lift-1000-solid-low-narrow-11 item-01) 10566) (= (y-of-lift-1000-solid-low-narrow-11 item-01) 10337) (= (z-of-lift-1000-solid-low-narrow-11 item-01) 12000) (= (cost-of-lift-1000-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-1000-solid-low-narrow-11 item-01) 10002) (= (y-of-put-down-lift-1000-solid-low-narrow-11 item-01) 9994) (= (z-of-put-down-lift-1000-solid-low-narrow-11 item-01) 8000)
    (can-lift-1001-solid-low-narrow-11 item-01) (= (x-of-lift-1001-solid-low-narrow-11 item-01) 10672) (= (y-of-lift-1001-solid-low-narrow-11 item-01) 9869) (= (z-of-lift-1001-solid-low-narrow-11 item-01) 12612) (= (cost-of-lift-1001-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-1001-solid-low-narrow-11 item-01) 9992) (= (y-of-put-down-lift-1001-solid-low-narrow-11 item-01) 9994) (= (z-of-put-down-lift-1001-solid-low-narrow-11 item-01) 7388)
    (can-lift-1001c-solid-low-narrow-11 item-01) (= (x-of-lift-1001c-solid-low-narrow-11 item-01) 10486) (= (y-of-lift-1001c-solid-low-narrow-11 item-01) 9478) (= (z-of-lift-1001c-solid-low-narrow-11 item-01) 12405) (= (cost-of-lift-1001c-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-1001c-solid-low-narrow-11 item-01) 10000) (= (y-of-put-down-lift-1001c-solid-low-narrow-11 item-01) 9988) (= (z-of-put-down-lift-1001c-solid-low-narrow-11 item-01) 7595)
    (can-lift-1100-solid-low-narrow-11 item-01) (= (x-of-lift-1100-solid-low-narrow-11 item-01) 9749) (= (y-of-lift-1100-solid-low-narrow-11 item-01) 10233) (= (z-of-lift-1100-solid-low-narrow-11 item-01) 12030) (= (cost-of-lift-1100-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-1100-solid-low-narrow-11 item-01) 9999) (= (y-of-put-down-lift-1100-solid-low-narrow-11 item-01) 9989) (= (z-of-put-down-lift-1100-solid-low-narrow-11 item-01) 7970)
    (can-lift-1100c-solid-low-narrow-11 item-01) (= (x-of-lift-1100c-solid-low-narrow-11 item-01) 9939) (= (y-of-lift-1100c-solid-low-narrow-11 item-01) 10312) (= (z-of-lift-1100c-solid-low-narrow-11 item-01) 12546) (= (cost-of-lift-1100c-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-1100c-solid-low-narrow-11 item-01) 10003) (= (y-of-put-down-lift-1100c-solid-low-narrow-11 item-01) 9993) (= (z-of-put-down-lift-1100c-solid-low-narrow-11 item-01) 7454)
    (can-lift-1101-solid-low-narrow-11 item-01) (= (x-of-lift-1101-solid-low-narrow-11 item-01) 10418) (= (y-of-lift-1101-solid-low-narrow-11 item-01) 10222) (= (z-of-lift-1101-solid-low-narrow-11 item-01) 12643) (= (cost-of-lift-1101-solid-low-narrow-11 item-01) 7)
    (= (x-of-put-down-lift-1101-solid-low-narrow-11 item-01) 9997) (= (y-of-put-down-lift-1101-solid-low-narrow-11 item-01) 9980) (= (z-of-put-down-lift-1101-solid-low-narrow-11 item-01) 7357)
    (can-lift-1101c-solid-low-narrow-11 item-01) (= (x-of-lift-1101c-solid-low-narrow-11 item-01) 10163) (= (y-of-lift-1101c-solid-low-narrow-11 item-01) 9994) (= (z-of-lift-1101c-solid-low-narrow-11 item-01) 11999) (= (cost-of-lift-1101c-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-1101c-solid-low-narrow-11 item-01) 10000) (= (y-of-put-down-lift-1101c-solid-low-narrow-11 item-01) 9995) (= (z-of-put-down-lift-1101c-solid-low-narrow-11 item-01) 8001)
    (can-place-forward-right-1010-solid-low-narrow-11 item-01) (= (x-of-place-forward-right-1010-solid-low-narrow-11 item-01) 10580) (= (y-of-place-forward-right-1010-solid-low-narrow-11 item-01) 9577) (= (cost-of-place-forward-right-1010-solid-low-narrow-11 item-01) 4)
    (can-pull-0110-solid-low-narrow-11 item-01) (= (x-of-pull-0110-solid-low-narrow-11 item-01) 9573) (= (y-of-pull-0110-solid-low-narrow-11 item-01) 9949) (= (cost-of-pull-0110-solid-low-narrow-11 item-01) 4)
    (can-pull-0111-solid-low-narrow-11 item-01) (= (x-of-pull-0111-solid-low-narrow-11 item-01) 9004) (= (y-of-pull-0111-solid-low-narrow-11 item-01) 10413) (= (cost-of-pull-0111-solid-low-narrow-11 item-01) 4)
    (can-push-forward-1011-solid-low-narrow-11 item-01) (= (x-of-push-forward-1011-solid-low-narrow-11 item-01) 10873) (= (y-of-push-forward-1011-solid-low-narrow-11 item-01) 10346) (= (cost-of-push-forward-1011-solid-low-narrow-11 item-01) 4)
    (= (x-of-push-forward-right-1101-solid-low-narrow-11 item-01) 10252) (= (y-of-push-forward-right-1101-solid-low-narrow-11 item-01) 9755) (= (cost-of-push-forward-right-1101-solid-low-narrow-11 item-01) 278)
    (can-push-left-0011-solid-low-narrow-11 item-01) (= (x-of-push-left-0011-solid-low-narrow-11 item-01) 9845) (= (y-of-push-left-0011-solid-low-narrow-11 item-01) 10408) (= (cost-of-push-left-0011-solid-low-narrow-11 item-01) 4)
    (can-push-left-1111-solid-low-narrow-11 item-01) (= (x-of-push-left-1111-solid-low-narrow-11 item-01) 9900) (= (y-of-push-left-1111-solid-low-narrow-11 item-01) 11582) (= (cost-of-push-left-1111-solid-low-narrow-11 item-01) 38)
    (can-push-right-0010d-solid-low-narrow-11 item-01) (= (x-of-push-right-0010d-solid-low-narrow-11 item-01) 9673) (= (y-of-push-right-0010d-solid-low-narrow-11 item-01) 8619) (= (cost-of-push-right-0010d-solid-low-narrow-11 item-01) 18)
    (can-push-right-1110-solid-low-narrow-11 item-01) (= (x-of-push-right-1110-solid-low-narrow-11 item-01) 9815) (= (y-of-push-right-1110-solid-low-narrow-11 item-01) 9506) (= (cost-of-push-right-1110-solid-low-narrow-11 item-01) 4)
    ; item-02 starts at (0.6145, 0.1177, 0.0189) m
    (= (x item-02) 2645) (= (y item-02) 4177) (= (z item-02) 0)
    ; What each operator promises for item-02 (features 0.1206 0.1206 0.03786 2).
    ; Not for item-02:
    ; lift-1100a-hollow-wide-01: keeps its promise with such objects in about 6 of 35 only.
    ; place-right-0000-hollow-wide-01: keeps its promise with such objects in about 7 of 35 only.
    ; push-left-1111-hollow-wide-01: scatters more than it moves.
    ; push-right-1000-hollow-wide-01: scatters more than it moves.
    ; push-right-1100a-hollow-wide-01: scatters more than it moves.
    (can-lift-0000-hollow-wide-01 item-02) (= (x-of-lift-0000-hollow-wide-01 item-02) 9999) (= (y-of-lift-0000-hollow-wide-01 item-02) 9187) (= (z-of-lift-0000-hollow-wide-01 item-02) 12825) (= (cost-of-lift-0000-hollow-wide-01 item-02) 19)
    (= (x-of-put-down-lift-0000-hollow-wide-01 item-02) 10026) (= (y-of-put-down-lift-0000-hollow-wide-01 item-02) 9965) (= (z-of-put-down-lift-0000-hollow-wide-01 item-02) 7175)
    (can-lift-0000b-hollow-wide-01 item-02) (= (x-of-lift-0000b-hollow-wide-01 item-02) 9667) (= (y-of-lift-0000b-hollow-wide-01 item-02) 9558) (= (z-of-lift-0000b-hollow-wide-01 item-02) 12322) (= (cost-of-lift-0000b-hollow-wide-01 item-02) 4)
    (= (x-of-put-down-lift-0000b-hollow-wide-01 item-02) 10003) (= (y-of-put-down-lift-0000b-hollow-wide-01 item-02) 9959) (= (z-of-put-down-lift-0000b-hollow-wide-01 item-02) 7678)
    (can-lift-0001b-hollow-wide-01 item-02) (= (x-of-lift-0001b-hollow-wide-01 item-02) 9806) (= (y-of-lift-0001b-hollow-wide-01 item-02) 10038) (= (z-of-lift-0001b-hollow-wide-01 item-02) 11988) (= (cost-of-lift-0001b-hollow-wide-01 item-02) 7)
    (= (x-of-put-down-lift-0001b-hollow-wide-01 item-02) 9997) (= (y-of-put-down-lift-0001b-hollow-wide-01 item-02) 9965) (= (z-of-put-down-lift-0001b-hollow-wide-01 item-02) 8012)
    (can-lift-0100b-hollow-wide-01 item-02) (= (x-of-lift-0100b-hollow-wide-01 item-02) 9711) (= (y-of-lift-0100b-hollow-wide-01 item-02) 9503) (= (z-of-lift-0100b-hollow-wide-01 item-02) 11977) (= (cost-of-lift-0100b-hollow-wide-01 item-02) 114)
    (= (x-of-put-down-lift-0100b-hollow-wide-01 item-02) 10006) (= (y-of-put-down-lift-0100b-hollow-wide-01 item-02) 9972) (= (z-of-put-down-lift-0100b-hollow-wide-01 item-02) 8023)
    (can-lift-0101a-hollow-wide-01 item-02) (= (x-of-lift-0101a-hollow-wide-01 item-02) 9753) (= (y-of-lift-0101a-hollow-wide-01 item-02) 10300) (= (z-of-lift-0101a-hollow-wide-01 item-02) 12461) (= (cost-of-lift-0101a-hollow-wide-01 item-02) 4)
    (= (x-of-put-down-lift-0101a-hollow-wide-01 item-02) 9998) (= (y-of-put-down-lift-0101a-hollow-wide-01 item-02) 9960) (= (z-of-put-down-lift-0101a-hollow-wide-01 item-02) 7539)
    (can-lift-1000-hollow-wide-01 item-02) (= (x-of-lift-1000-hollow-wide-01 item-02) 10335) (= (y-of-lift-1000-hollow-wide-01 item-02) 9690) (= (z-of-lift-1000-hollow-wide-01 item-02) 11969) (= (cost-of-lift-1000-hollow-wide-01 item-02) 91)
    (= (x-of-put-down-lift-1000-hollow-wide-01 item-02) 10001) (= (y-of-put-down-lift-1000-hollow-wide-01 item-02) 9987) (= (z-of-put-down-lift-1000-hollow-wide-01 item-02) 8031)
    (can-lift-1000a-hollow-wide-01 item-02) (= (x-of-lift-1000a-hollow-wide-01 item-02) 10509) (= (y-of-lift-1000a-hollow-wide-01 item-02) 8973) (= (z-of-lift-1000a-hollow-wide-01 item-02) 12186) (= (cost-of-lift-1000a-hollow-wide-01 item-02) 4)
    (= (x-of-put-down-lift-1000a-hollow-wide-01 item-02) 9997) (= (y-of-put-down-lift-1000a-hollow-wide-01 item-02) 9959) (= (z-of-put-down-lift-1000a-hollow-wide-01 item-02) 7814)
    (can-lift-1001a-hollow-wide-01 item-02) (= (x-of-lift-1001a-hollow-wide-01 item-02) 10491) (= (y-of-lift-1001a-hollow-wide-01 item-02) 10470) (= (z-of-lift-1001a-hollow-wide-01 item-02) 12451) (= (cost-of-lift-1001a-hollow-wide-01 item-02) 4)
    (= (x-of-put-down-lift-1001a-hollow-wide-01 item-02) 10000) (= (y-of-put-down-lift-1001a-hollow-wide-01 item-02) 9964) (= (z-of-put-down-lift-1001a-hollow-wide-01 item-02) 7549)
    (= (x-of-lift-1100a-hollow-wide-01 item-02) 9866) (= (y-of-lift-1100a-hollow-wide-01 item-02) 9782) (= (z-of-lift-1100a-hollow-wide-01 item-02) 12003) (= (cost-of-lift-1100a-hollow-wide-01 item-02) 168)
    (= (x-of-put-down-lift-1100a-hollow-wide-01 item-02) 9999) (= (y-of-put-down-lift-1100a-hollow-wide-01 item-02) 9972) (= (z-of-put-down-lift-1100a-hollow-wide-01 item-02) 7997)
    (can-lift-1101a-hollow-wide-01 item-02) (= (x-of-lift-1101a-hollow-wide-01 item-02) 10402) (= (y-of-lift-1101a-hollow-wide-01 item-02) 10296) (= (z-of-lift-1101a-hollow-wide-01 item-02) 11983) (= (cost-of-lift-1101a-hollow-wide-01 item-02) 4)
    (= (x-of-put-down-lift-1101a-hollow-wide-01 item-02) 10002) (= (y-of-put-down-lift-1101a-hollow-wide-01 item-02) 9963) (= (z-of-put-down-lift-1101a-hollow-wide-01 item-02) 8017)
    (= (x-of-place-right-0000-hollow-wide-01 item-02) 9952) (= (y-of-place-right-0000-hollow-wide-01 item-02) 9324) (= (cost-of-place-right-0000-hollow-wide-01 item-02) 154)
    (can-pull-0111-hollow-wide-01 item-02) (= (x-of-pull-0111-hollow-wide-01 item-02) 8846) (= (y-of-pull-0111-hollow-wide-01 item-02) 10224) (= (cost-of-pull-0111-hollow-wide-01 item-02) 9)
    (can-pull-left-0111b-hollow-wide-01 item-02) (= (x-of-pull-left-0111b-hollow-wide-01 item-02) 9532) (= (y-of-pull-left-0111b-hollow-wide-01 item-02) 10555) (= (cost-of-pull-left-0111b-hollow-wide-01 item-02) 4)
    (can-pull-right-0110-hollow-wide-01 item-02) (= (x-of-pull-right-0110-hollow-wide-01 item-02) 9647) (= (y-of-pull-right-0110-hollow-wide-01 item-02) 9505) (= (cost-of-pull-right-0110-hollow-wide-01 item-02) 12)
    (can-pull-right-1110b-hollow-wide-01 item-02) (= (x-of-pull-right-1110b-hollow-wide-01 item-02) 9647) (= (y-of-pull-right-1110b-hollow-wide-01 item-02) 9811) (= (cost-of-pull-right-1110b-hollow-wide-01 item-02) 4)
    (can-push-forward-left-1011b-hollow-wide-01 item-02) (= (x-of-push-forward-left-1011b-hollow-wide-01 item-02) 10425) (= (y-of-push-forward-left-1011b-hollow-wide-01 item-02) 10217) (= (cost-of-push-forward-left-1011b-hollow-wide-01 item-02) 4)
    (can-push-forward-right-0010b-hollow-wide-01 item-02) (= (x-of-push-forward-right-0010b-hollow-wide-01 item-02) 10407) (= (y-of-push-forward-right-0010b-hollow-wide-01 item-02) 9684) (= (cost-of-push-forward-right-0010b-hollow-wide-01 item-02) 4)
    (can-push-left-0011b-hollow-wide-01 item-02) (= (x-of-push-left-0011b-hollow-wide-01 item-02) 10316) (= (y-of-push-left-0011b-hollow-wide-01 item-02) 10556) (= (cost-of-push-left-0011b-hollow-wide-01 item-02) 4)
    (= (x-of-push-left-1111-hollow-wide-01 item-02) 9963) (= (y-of-push-left-1111-hollow-wide-01 item-02) 10132) (= (cost-of-push-left-1111-hollow-wide-01 item-02) 16)
    (can-push-right-0100b-hollow-wide-01 item-02) (= (x-of-push-right-0100b-hollow-wide-01 item-02) 9796) (= (y-of-push-right-0100b-hollow-wide-01 item-02) 9444) (= (cost-of-push-right-0100b-hollow-wide-01 item-02) 63)
    (can-push-right-0110b-hollow-wide-01 item-02) (= (x-of-push-right-0110b-hollow-wide-01 item-02) 9664) (= (y-of-push-right-0110b-hollow-wide-01 item-02) 9465) (= (cost-of-push-right-0110b-hollow-wide-01 item-02) 29)
    (= (x-of-push-right-1000-hollow-wide-01 item-02) 10028) (= (y-of-push-right-1000-hollow-wide-01 item-02) 9840) (= (cost-of-push-right-1000-hollow-wide-01 item-02) 53)
    (can-push-right-1010-hollow-wide-01 item-02) (= (x-of-push-right-1010-hollow-wide-01 item-02) 10244) (= (y-of-push-right-1010-hollow-wide-01 item-02) 9246) (= (cost-of-push-right-1010-hollow-wide-01 item-02) 7)
    (can-push-right-1010b-hollow-wide-01 item-02) (= (x-of-push-right-1010b-hollow-wide-01 item-02) 10092) (= (y-of-push-right-1010b-hollow-wide-01 item-02) 9183) (= (cost-of-push-right-1010b-hollow-wide-01 item-02) 4)
    (= (x-of-push-right-1100a-hollow-wide-01 item-02) 9952) (= (y-of-push-right-1100a-hollow-wide-01 item-02) 9832) (= (cost-of-push-right-1100a-hollow-wide-01 item-02) 40))
  (:goal (and
    ; item-01 shall come to (0.6189, -0.0203, 0.0491) m, 0 mm from where it starts
    (<= (x item-01) 3144) (>= (x item-01) 2234)
    (<= (+ (x item-01) (y item-01)) 6129) (>= (+ (x item-01) (y item-01)) 4842)
    (<= (y item-01) 3252) (>= (y item-01) 2342)
    (<= (y item-01) (+ (x item-01) 752)) (<= (x item-01) (+ (y item-01) 535))
    (>= (z item-01) 0) (<= (z item-01) 0)
    ; item-02 shall come to (0.6065, 0.1674, 0.0189) m, 50 mm from where it starts
    (<= (x item-02) 3020) (>= (x item-02) 2110)
    (<= (+ (x item-02) (y item-02)) 7883) (>= (+ (x item-02) (y item-02)) 6595)
    (<= (y item-02) 5129) (>= (y item-02) 4219)
    (<= (y item-02) (+ (x item-02) 2752)) (<= (+ (x item-02) 1465) (y item-02))
    (>= (z item-02) 0) (<= (z item-02) 0)))
  (:metric minimize (total-cost)))
