; Problem anywhere-4-13 of the learned domain places, for its encoding numeric.
; How it came about: anywhere, drawn with seed 14; draw 1.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem anywhere-4-13)
  (:domain places-numeric)
  (:objects
    item-01 - hollow-wide-00
    item-02 - solid-low-10
    item-03 - any-tall-narrow-11
    item-04 - hollow-wide-00)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.5780, 0.0153, 0.0273) m
    (= (x item-01) 2280) (= (y item-01) 3153) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.1531 0.1531 0.05461 2).
    ; Not for item-01:
    ; lift-0011-hollow-wide-00: keeps its promise with such objects in about 6 of 30 only.
    ; place-back-right-0000-hollow-wide-00: keeps its promise with such objects in about 6 of 30 only.
    ; pull-right-0110-hollow-wide-00: scatters more than it moves.
    ; push-right-0010a-hollow-wide-00: keeps its promise with such objects in about 3 of 30 only.
    (can-lift-0000-hollow-wide-00 item-01) (= (x-of-lift-0000-hollow-wide-00 item-01) 9717) (= (y-of-lift-0000-hollow-wide-00 item-01) 9298) (= (z-of-lift-0000-hollow-wide-00 item-01) 11637) (= (cost-of-lift-0000-hollow-wide-00 item-01) 84)
    (= (x-of-put-down-lift-0000-hollow-wide-00 item-01) 9942) (= (y-of-put-down-lift-0000-hollow-wide-00 item-01) 10064) (= (z-of-put-down-lift-0000-hollow-wide-00 item-01) 8363)
    (can-lift-0001-hollow-wide-00 item-01) (= (x-of-lift-0001-hollow-wide-00 item-01) 9650) (= (y-of-lift-0001-hollow-wide-00 item-01) 9034) (= (z-of-lift-0001-hollow-wide-00 item-01) 12500) (= (cost-of-lift-0001-hollow-wide-00 item-01) 4)
    (= (x-of-put-down-lift-0001-hollow-wide-00 item-01) 10001) (= (y-of-put-down-lift-0001-hollow-wide-00 item-01) 9966) (= (z-of-put-down-lift-0001-hollow-wide-00 item-01) 7500)
    (can-lift-0010a-hollow-wide-00 item-01) (= (x-of-lift-0010a-hollow-wide-00 item-01) 10048) (= (y-of-lift-0010a-hollow-wide-00 item-01) 9673) (= (z-of-lift-0010a-hollow-wide-00 item-01) 12006) (= (cost-of-lift-0010a-hollow-wide-00 item-01) 14)
    (= (x-of-put-down-lift-0010a-hollow-wide-00 item-01) 9998) (= (y-of-put-down-lift-0010a-hollow-wide-00 item-01) 9966) (= (z-of-put-down-lift-0010a-hollow-wide-00 item-01) 7994)
    (= (x-of-lift-0011-hollow-wide-00 item-01) 10303) (= (y-of-lift-0011-hollow-wide-00 item-01) 8762) (= (z-of-lift-0011-hollow-wide-00 item-01) 11993) (= (cost-of-lift-0011-hollow-wide-00 item-01) 153)
    (= (x-of-put-down-lift-0011-hollow-wide-00 item-01) 9999) (= (y-of-put-down-lift-0011-hollow-wide-00 item-01) 9969) (= (z-of-put-down-lift-0011-hollow-wide-00 item-01) 8007)
    (can-lift-0011a-hollow-wide-00 item-01) (= (x-of-lift-0011a-hollow-wide-00 item-01) 10506) (= (y-of-lift-0011a-hollow-wide-00 item-01) 9185) (= (z-of-lift-0011a-hollow-wide-00 item-01) 12510) (= (cost-of-lift-0011a-hollow-wide-00 item-01) 4)
    (= (x-of-put-down-lift-0011a-hollow-wide-00 item-01) 9992) (= (y-of-put-down-lift-0011a-hollow-wide-00 item-01) 9962) (= (z-of-put-down-lift-0011a-hollow-wide-00 item-01) 7490)
    (can-lift-1000-hollow-wide-00 item-01) (= (x-of-lift-1000-hollow-wide-00 item-01) 9690) (= (y-of-lift-1000-hollow-wide-00 item-01) 11131) (= (z-of-lift-1000-hollow-wide-00 item-01) 12006) (= (cost-of-lift-1000-hollow-wide-00 item-01) 4)
    (= (x-of-put-down-lift-1000-hollow-wide-00 item-01) 10000) (= (y-of-put-down-lift-1000-hollow-wide-00 item-01) 9973) (= (z-of-put-down-lift-1000-hollow-wide-00 item-01) 7994)
    (can-lift-1000a-hollow-wide-00 item-01) (= (x-of-lift-1000a-hollow-wide-00 item-01) 9586) (= (y-of-lift-1000a-hollow-wide-00 item-01) 10467) (= (z-of-lift-1000a-hollow-wide-00 item-01) 12459) (= (cost-of-lift-1000a-hollow-wide-00 item-01) 4)
    (= (x-of-put-down-lift-1000a-hollow-wide-00 item-01) 9998) (= (y-of-put-down-lift-1000a-hollow-wide-00 item-01) 9966) (= (z-of-put-down-lift-1000a-hollow-wide-00 item-01) 7541)
    (can-lift-1001a-hollow-wide-00 item-01) (= (x-of-lift-1001a-hollow-wide-00 item-01) 10172) (= (y-of-lift-1001a-hollow-wide-00 item-01) 10325) (= (z-of-lift-1001a-hollow-wide-00 item-01) 12157) (= (cost-of-lift-1001a-hollow-wide-00 item-01) 4)
    (= (x-of-put-down-lift-1001a-hollow-wide-00 item-01) 9999) (= (y-of-put-down-lift-1001a-hollow-wide-00 item-01) 9970) (= (z-of-put-down-lift-1001a-hollow-wide-00 item-01) 7843)
    (can-lift-1010a-hollow-wide-00 item-01) (= (x-of-lift-1010a-hollow-wide-00 item-01) 10275) (= (y-of-lift-1010a-hollow-wide-00 item-01) 11020) (= (z-of-lift-1010a-hollow-wide-00 item-01) 11998) (= (cost-of-lift-1010a-hollow-wide-00 item-01) 4)
    (= (x-of-put-down-lift-1010a-hollow-wide-00 item-01) 9999) (= (y-of-put-down-lift-1010a-hollow-wide-00 item-01) 9973) (= (z-of-put-down-lift-1010a-hollow-wide-00 item-01) 8002)
    (can-lift-1101-hollow-wide-00 item-01) (= (x-of-lift-1101-hollow-wide-00 item-01) 10313) (= (y-of-lift-1101-hollow-wide-00 item-01) 10156) (= (z-of-lift-1101-hollow-wide-00 item-01) 12001) (= (cost-of-lift-1101-hollow-wide-00 item-01) 128)
    (= (x-of-put-down-lift-1101-hollow-wide-00 item-01) 10004) (= (y-of-put-down-lift-1101-hollow-wide-00 item-01) 10010) (= (z-of-put-down-lift-1101-hollow-wide-00 item-01) 7999)
    (= (x-of-place-back-right-0000-hollow-wide-00 item-01) 9880) (= (y-of-place-back-right-0000-hollow-wide-00 item-01) 9375) (= (cost-of-place-back-right-0000-hollow-wide-00 item-01) 153)
    (can-place-right-0111-hollow-wide-00 item-01) (= (x-of-place-right-0111-hollow-wide-00 item-01) 9603) (= (y-of-place-right-0111-hollow-wide-00 item-01) 8927) (= (cost-of-place-right-0111-hollow-wide-00 item-01) 7)
    (can-place-right-0111a-hollow-wide-00 item-01) (= (x-of-place-right-0111a-hollow-wide-00 item-01) 10197) (= (y-of-place-right-0111a-hollow-wide-00 item-01) 8977) (= (cost-of-place-right-0111a-hollow-wide-00 item-01) 4)
    (can-pull-0100-hollow-wide-00 item-01) (= (x-of-pull-0100-hollow-wide-00 item-01) 9580) (= (y-of-pull-0100-hollow-wide-00 item-01) 9984) (= (cost-of-pull-0100-hollow-wide-00 item-01) 11)
    (can-pull-left-0110a-hollow-wide-00 item-01) (= (x-of-pull-left-0110a-hollow-wide-00 item-01) 9661) (= (y-of-pull-left-0110a-hollow-wide-00 item-01) 10287) (= (cost-of-pull-left-0110a-hollow-wide-00 item-01) 4)
    (can-pull-right-0100a-hollow-wide-00 item-01) (= (x-of-pull-right-0100a-hollow-wide-00 item-01) 9611) (= (y-of-pull-right-0100a-hollow-wide-00 item-01) 9675) (= (cost-of-pull-right-0100a-hollow-wide-00 item-01) 4)
    (= (x-of-pull-right-0110-hollow-wide-00 item-01) 9895) (= (y-of-pull-right-0110-hollow-wide-00 item-01) 10003) (= (cost-of-pull-right-0110-hollow-wide-00 item-01) 4)
    (can-push-forward-1011a-hollow-wide-00 item-01) (= (x-of-push-forward-1011a-hollow-wide-00 item-01) 10810) (= (y-of-push-forward-1011a-hollow-wide-00 item-01) 9931) (= (cost-of-push-forward-1011a-hollow-wide-00 item-01) 11)
    (can-push-forward-1110a-hollow-wide-00 item-01) (= (x-of-push-forward-1110a-hollow-wide-00 item-01) 10301) (= (y-of-push-forward-1110a-hollow-wide-00 item-01) 9907) (= (cost-of-push-forward-1110a-hollow-wide-00 item-01) 4)
    (can-push-forward-left-1111a-hollow-wide-00 item-01) (= (x-of-push-forward-left-1111a-hollow-wide-00 item-01) 10295) (= (y-of-push-forward-left-1111a-hollow-wide-00 item-01) 10445) (= (cost-of-push-forward-left-1111a-hollow-wide-00 item-01) 4)
    (can-push-forward-right-0101a-hollow-wide-00 item-01) (= (x-of-push-forward-right-0101a-hollow-wide-00 item-01) 10396) (= (y-of-push-forward-right-0101a-hollow-wide-00 item-01) 9671) (= (cost-of-push-forward-right-0101a-hollow-wide-00 item-01) 4)
    (can-push-left-1100a-hollow-wide-00 item-01) (= (x-of-push-left-1100a-hollow-wide-00 item-01) 9676) (= (y-of-push-left-1100a-hollow-wide-00 item-01) 10879) (= (cost-of-push-left-1100a-hollow-wide-00 item-01) 7)
    (= (x-of-push-right-0010a-hollow-wide-00 item-01) 9975) (= (y-of-push-right-0010a-hollow-wide-00 item-01) 9648) (= (cost-of-push-right-0010a-hollow-wide-00 item-01) 209)
    (can-push-right-0011-hollow-wide-00 item-01) (= (x-of-push-right-0011-hollow-wide-00 item-01) 10040) (= (y-of-push-right-0011-hollow-wide-00 item-01) 9561) (= (cost-of-push-right-0011-hollow-wide-00 item-01) 26)
    (can-push-right-1101-hollow-wide-00 item-01) (= (x-of-push-right-1101-hollow-wide-00 item-01) 9953) (= (y-of-push-right-1101-hollow-wide-00 item-01) 9561) (= (cost-of-push-right-1101-hollow-wide-00 item-01) 34)
    ; item-02 starts at (0.4136, -0.0395, 0.0182) m
    (= (x item-02) 636) (= (y item-02) 2605) (= (z item-02) 0)
    ; What each operator promises for item-02 (features 0.06409 0.1767 0.03641 0).
    ; Not for item-02:
    ; lift-0010-solid-low-10: keeps its promise in 1 of 31 rehearsals only.
    ; lift-1001c-solid-low-10: keeps its promise in 1 of 31 rehearsals only.
    ; push-forward-right-1111-solid-low-10: scatters more than it moves.
    ; push-right-0010-solid-low-10: scatters more than it moves.
    ; stay-1101-solid-low-10: moves less than half a cell.
    (= (x-of-lift-0010-solid-low-10 item-02) 10273) (= (y-of-lift-0010-solid-low-10 item-02) 10236) (= (z-of-lift-0010-solid-low-10 item-02) 12331) (= (cost-of-lift-0010-solid-low-10 item-02) 281)
    (= (x-of-put-down-lift-0010-solid-low-10 item-02) 10003) (= (y-of-put-down-lift-0010-solid-low-10 item-02) 9993) (= (z-of-put-down-lift-0010-solid-low-10 item-02) 7669)
    (= (x-of-lift-1001c-solid-low-10 item-02) 10256) (= (y-of-lift-1001c-solid-low-10 item-02) 9505) (= (z-of-lift-1001c-solid-low-10 item-02) 12007) (= (cost-of-lift-1001c-solid-low-10 item-02) 281)
    (= (x-of-put-down-lift-1001c-solid-low-10 item-02) 9994) (= (y-of-put-down-lift-1001c-solid-low-10 item-02) 9990) (= (z-of-put-down-lift-1001c-solid-low-10 item-02) 7993)
    (can-pull-0000b-solid-low-10 item-02) (= (x-of-pull-0000b-solid-low-10 item-02) 9514) (= (y-of-pull-0000b-solid-low-10 item-02) 9913) (= (cost-of-pull-0000b-solid-low-10 item-02) 14)
    (can-pull-0100-solid-low-10 item-02) (= (x-of-pull-0100-solid-low-10 item-02) 9195) (= (y-of-pull-0100-solid-low-10 item-02) 9942) (= (cost-of-pull-0100-solid-low-10 item-02) 7)
    (can-pull-0100c-solid-low-10 item-02) (= (x-of-pull-0100c-solid-low-10 item-02) 9226) (= (y-of-pull-0100c-solid-low-10 item-02) 10323) (= (cost-of-pull-0100c-solid-low-10 item-02) 11)
    (can-pull-0110c-solid-low-10 item-02) (= (x-of-pull-0110c-solid-low-10 item-02) 9661) (= (y-of-pull-0110c-solid-low-10 item-02) 9960) (= (cost-of-pull-0110c-solid-low-10 item-02) 4)
    (can-pull-left-1110c-solid-low-10 item-02) (= (x-of-pull-left-1110c-solid-low-10 item-02) 9377) (= (y-of-pull-left-1110c-solid-low-10 item-02) 10447) (= (cost-of-pull-left-1110c-solid-low-10 item-02) 4)
    (can-push-forward-0101c-solid-low-10 item-02) (= (x-of-push-forward-0101c-solid-low-10 item-02) 10482) (= (y-of-push-forward-0101c-solid-low-10 item-02) 10009) (= (cost-of-push-forward-0101c-solid-low-10 item-02) 14)
    (can-push-forward-1011-solid-low-10 item-02) (= (x-of-push-forward-1011-solid-low-10 item-02) 10875) (= (y-of-push-forward-1011-solid-low-10 item-02) 10132) (= (cost-of-push-forward-1011-solid-low-10 item-02) 4)
    (can-push-forward-left-1001c-solid-low-10 item-02) (= (x-of-push-forward-left-1001c-solid-low-10 item-02) 10634) (= (y-of-push-forward-left-1001c-solid-low-10 item-02) 10497) (= (cost-of-push-forward-left-1001c-solid-low-10 item-02) 21)
    (can-push-forward-left-1010-solid-low-10 item-02) (= (x-of-push-forward-left-1010-solid-low-10 item-02) 10216) (= (y-of-push-forward-left-1010-solid-low-10 item-02) 10261) (= (cost-of-push-forward-left-1010-solid-low-10 item-02) 7)
    (can-push-forward-left-1100c-solid-low-10 item-02) (= (x-of-push-forward-left-1100c-solid-low-10 item-02) 10154) (= (y-of-push-forward-left-1100c-solid-low-10 item-02) 10183) (= (cost-of-push-forward-left-1100c-solid-low-10 item-02) 4)
    (can-push-forward-right-0111c-solid-low-10 item-02) (= (x-of-push-forward-right-0111c-solid-low-10 item-02) 10620) (= (y-of-push-forward-right-0111c-solid-low-10 item-02) 9184) (= (cost-of-push-forward-right-0111c-solid-low-10 item-02) 33)
    (= (x-of-push-forward-right-1111-solid-low-10 item-02) 10071) (= (y-of-push-forward-right-1111-solid-low-10 item-02) 9859) (= (cost-of-push-forward-right-1111-solid-low-10 item-02) 7)
    (can-push-left-1000-solid-low-10 item-02) (= (x-of-push-left-1000-solid-low-10 item-02) 9906) (= (y-of-push-left-1000-solid-low-10 item-02) 10362) (= (cost-of-push-left-1000-solid-low-10 item-02) 7)
    (can-push-right-0001b-solid-low-10 item-02) (= (x-of-push-right-0001b-solid-low-10 item-02) 9836) (= (y-of-push-right-0001b-solid-low-10 item-02) 9544) (= (cost-of-push-right-0001b-solid-low-10 item-02) 11)
    (= (x-of-push-right-0010-solid-low-10 item-02) 10098) (= (y-of-push-right-0010-solid-low-10 item-02) 9875) (= (cost-of-push-right-0010-solid-low-10 item-02) 7)
    (can-push-right-0011-solid-low-10 item-02) (= (x-of-push-right-0011-solid-low-10 item-02) 10093) (= (y-of-push-right-0011-solid-low-10 item-02) 9638) (= (cost-of-push-right-0011-solid-low-10 item-02) 11)
    (= (x-of-stay-1101-solid-low-10 item-02) 9999) (= (y-of-stay-1101-solid-low-10 item-02) 10024) (= (cost-of-stay-1101-solid-low-10 item-02) 11)
    ; item-03 starts at (0.7075, 0.1773, 0.0210) m
    (= (x item-03) 3575) (= (y item-03) 4773) (= (z item-03) 0)
    ; What each operator promises for item-03 (features 0.1067 0.1067 0.04194 2).
    ; Not for item-03:
    ; lift-0001-any-tall-narrow-11: keeps its promise with such objects in about 5 of 30 only.
    ; pull-right-0011c-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    ; push-right-0001-any-tall-narrow-11: scatters more than it moves.
    ; push-right-0001a-any-tall-narrow-11: keeps its promise with such objects in about 4 of 30 only.
    ; push-right-0011-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    (can-lift-0000c-any-tall-narrow-11 item-03) (= (x-of-lift-0000c-any-tall-narrow-11 item-03) 9442) (= (y-of-lift-0000c-any-tall-narrow-11 item-03) 10483) (= (z-of-lift-0000c-any-tall-narrow-11 item-03) 11998) (= (cost-of-lift-0000c-any-tall-narrow-11 item-03) 4)
    (= (x-of-put-down-lift-0000c-any-tall-narrow-11 item-03) 10001) (= (y-of-put-down-lift-0000c-any-tall-narrow-11 item-03) 9993) (= (z-of-put-down-lift-0000c-any-tall-narrow-11 item-03) 8002)
    (= (x-of-lift-0001-any-tall-narrow-11 item-03) 9662) (= (y-of-lift-0001-any-tall-narrow-11 item-03) 9294) (= (z-of-lift-0001-any-tall-narrow-11 item-03) 12437) (= (cost-of-lift-0001-any-tall-narrow-11 item-03) 168)
    (= (x-of-put-down-lift-0001-any-tall-narrow-11 item-03) 9991) (= (y-of-put-down-lift-0001-any-tall-narrow-11 item-03) 9958) (= (z-of-put-down-lift-0001-any-tall-narrow-11 item-03) 7563)
    (can-lift-0001a-any-tall-narrow-11 item-03) (= (x-of-lift-0001a-any-tall-narrow-11 item-03) 9831) (= (y-of-lift-0001a-any-tall-narrow-11 item-03) 9755) (= (z-of-lift-0001a-any-tall-narrow-11 item-03) 11999) (= (cost-of-lift-0001a-any-tall-narrow-11 item-03) 26)
    (= (x-of-put-down-lift-0001a-any-tall-narrow-11 item-03) 10001) (= (y-of-put-down-lift-0001a-any-tall-narrow-11 item-03) 9990) (= (z-of-put-down-lift-0001a-any-tall-narrow-11 item-03) 8001)
    (can-lift-0010b-any-tall-narrow-11 item-03) (= (x-of-lift-0010b-any-tall-narrow-11 item-03) 10330) (= (y-of-lift-0010b-any-tall-narrow-11 item-03) 10240) (= (z-of-lift-0010b-any-tall-narrow-11 item-03) 12370) (= (cost-of-lift-0010b-any-tall-narrow-11 item-03) 4)
    (= (x-of-put-down-lift-0010b-any-tall-narrow-11 item-03) 10002) (= (y-of-put-down-lift-0010b-any-tall-narrow-11 item-03) 9995) (= (z-of-put-down-lift-0010b-any-tall-narrow-11 item-03) 7630)
    (can-lift-0011-any-tall-narrow-11 item-03) (= (x-of-lift-0011-any-tall-narrow-11 item-03) 10369) (= (y-of-lift-0011-any-tall-narrow-11 item-03) 9310) (= (z-of-lift-0011-any-tall-narrow-11 item-03) 11997) (= (cost-of-lift-0011-any-tall-narrow-11 item-03) 11)
    (= (x-of-put-down-lift-0011-any-tall-narrow-11 item-03) 10005) (= (y-of-put-down-lift-0011-any-tall-narrow-11 item-03) 9981) (= (z-of-put-down-lift-0011-any-tall-narrow-11 item-03) 8003)
    (can-lift-0011c-any-tall-narrow-11 item-03) (= (x-of-lift-0011c-any-tall-narrow-11 item-03) 9827) (= (y-of-lift-0011c-any-tall-narrow-11 item-03) 9680) (= (z-of-lift-0011c-any-tall-narrow-11 item-03) 12569) (= (cost-of-lift-0011c-any-tall-narrow-11 item-03) 7)
    (= (x-of-put-down-lift-0011c-any-tall-narrow-11 item-03) 9996) (= (y-of-put-down-lift-0011c-any-tall-narrow-11 item-03) 9995) (= (z-of-put-down-lift-0011c-any-tall-narrow-11 item-03) 7431)
    (can-lift-1000-any-tall-narrow-11 item-03) (= (x-of-lift-1000-any-tall-narrow-11 item-03) 9752) (= (y-of-lift-1000-any-tall-narrow-11 item-03) 10739) (= (z-of-lift-1000-any-tall-narrow-11 item-03) 12262) (= (cost-of-lift-1000-any-tall-narrow-11 item-03) 70)
    (= (x-of-put-down-lift-1000-any-tall-narrow-11 item-03) 10013) (= (y-of-put-down-lift-1000-any-tall-narrow-11 item-03) 9970) (= (z-of-put-down-lift-1000-any-tall-narrow-11 item-03) 7738)
    (can-lift-1001d-any-tall-narrow-11 item-03) (= (x-of-lift-1001d-any-tall-narrow-11 item-03) 10646) (= (y-of-lift-1001d-any-tall-narrow-11 item-03) 9548) (= (z-of-lift-1001d-any-tall-narrow-11 item-03) 12004) (= (cost-of-lift-1001d-any-tall-narrow-11 item-03) 4)
    (= (x-of-put-down-lift-1001d-any-tall-narrow-11 item-03) 10002) (= (y-of-put-down-lift-1001d-any-tall-narrow-11 item-03) 9994) (= (z-of-put-down-lift-1001d-any-tall-narrow-11 item-03) 7996)
    (can-lift-1010b-any-tall-narrow-11 item-03) (= (x-of-lift-1010b-any-tall-narrow-11 item-03) 10277) (= (y-of-lift-1010b-any-tall-narrow-11 item-03) 10230) (= (z-of-lift-1010b-any-tall-narrow-11 item-03) 12004) (= (cost-of-lift-1010b-any-tall-narrow-11 item-03) 4)
    (= (x-of-put-down-lift-1010b-any-tall-narrow-11 item-03) 10002) (= (y-of-put-down-lift-1010b-any-tall-narrow-11 item-03) 9995) (= (z-of-put-down-lift-1010b-any-tall-narrow-11 item-03) 7996)
    (can-lift-1101a-any-tall-narrow-11 item-03) (= (x-of-lift-1101a-any-tall-narrow-11 item-03) 10289) (= (y-of-lift-1101a-any-tall-narrow-11 item-03) 10260) (= (z-of-lift-1101a-any-tall-narrow-11 item-03) 12023) (= (cost-of-lift-1101a-any-tall-narrow-11 item-03) 43)
    (= (x-of-put-down-lift-1101a-any-tall-narrow-11 item-03) 10020) (= (y-of-put-down-lift-1101a-any-tall-narrow-11 item-03) 10023) (= (z-of-put-down-lift-1101a-any-tall-narrow-11 item-03) 7977)
    (can-place-forward-right-0111d-any-tall-narrow-11 item-03) (= (x-of-place-forward-right-0111d-any-tall-narrow-11 item-03) 10297) (= (y-of-place-forward-right-0111d-any-tall-narrow-11 item-03) 9667) (= (cost-of-place-forward-right-0111d-any-tall-narrow-11 item-03) 4)
    (can-pull-0100-any-tall-narrow-11 item-03) (= (x-of-pull-0100-any-tall-narrow-11 item-03) 8912) (= (y-of-pull-0100-any-tall-narrow-11 item-03) 9775) (= (cost-of-pull-0100-any-tall-narrow-11 item-03) 4)
    (can-pull-0110d-any-tall-narrow-11 item-03) (= (x-of-pull-0110d-any-tall-narrow-11 item-03) 9744) (= (y-of-pull-0110d-any-tall-narrow-11 item-03) 9925) (= (cost-of-pull-0110d-any-tall-narrow-11 item-03) 4)
    (can-pull-left-1110d-any-tall-narrow-11 item-03) (= (x-of-pull-left-1110d-any-tall-narrow-11 item-03) 9526) (= (y-of-pull-left-1110d-any-tall-narrow-11 item-03) 10417) (= (cost-of-pull-left-1110d-any-tall-narrow-11 item-03) 34)
    (= (x-of-pull-right-0011c-any-tall-narrow-11 item-03) 9570) (= (y-of-pull-right-0011c-any-tall-narrow-11 item-03) 9392) (= (cost-of-pull-right-0011c-any-tall-narrow-11 item-03) 278)
    (can-pull-right-0100d-any-tall-narrow-11 item-03) (= (x-of-pull-right-0100d-any-tall-narrow-11 item-03) 9441) (= (y-of-pull-right-0100d-any-tall-narrow-11 item-03) 9664) (= (cost-of-pull-right-0100d-any-tall-narrow-11 item-03) 4)
    (can-push-forward-1011-any-tall-narrow-11 item-03) (= (x-of-push-forward-1011-any-tall-narrow-11 item-03) 11153) (= (y-of-push-forward-1011-any-tall-narrow-11 item-03) 10205) (= (cost-of-push-forward-1011-any-tall-narrow-11 item-03) 11)
    (can-push-forward-1011b-any-tall-narrow-11 item-03) (= (x-of-push-forward-1011b-any-tall-narrow-11 item-03) 10835) (= (y-of-push-forward-1011b-any-tall-narrow-11 item-03) 10106) (= (cost-of-push-forward-1011b-any-tall-narrow-11 item-03) 4)
    (can-push-forward-1111b-any-tall-narrow-11 item-03) (= (x-of-push-forward-1111b-any-tall-narrow-11 item-03) 10404) (= (y-of-push-forward-1111b-any-tall-narrow-11 item-03) 10014) (= (cost-of-push-forward-1111b-any-tall-narrow-11 item-03) 4)
    (can-push-forward-left-1100d-any-tall-narrow-11 item-03) (= (x-of-push-forward-left-1100d-any-tall-narrow-11 item-03) 10170) (= (y-of-push-forward-left-1100d-any-tall-narrow-11 item-03) 10253) (= (cost-of-push-forward-left-1100d-any-tall-narrow-11 item-03) 4)
    (can-push-forward-right-1111-any-tall-narrow-11 item-03) (= (x-of-push-forward-right-1111-any-tall-narrow-11 item-03) 10742) (= (y-of-push-forward-right-1111-any-tall-narrow-11 item-03) 9571) (= (cost-of-push-forward-right-1111-any-tall-narrow-11 item-03) 7)
    (can-push-left-1000-any-tall-narrow-11 item-03) (= (x-of-push-left-1000-any-tall-narrow-11 item-03) 9982) (= (y-of-push-left-1000-any-tall-narrow-11 item-03) 10134) (= (cost-of-push-left-1000-any-tall-narrow-11 item-03) 70)
    (can-push-left-1101a-any-tall-narrow-11 item-03) (= (x-of-push-left-1101a-any-tall-narrow-11 item-03) 9791) (= (y-of-push-left-1101a-any-tall-narrow-11 item-03) 10204) (= (cost-of-push-left-1101a-any-tall-narrow-11 item-03) 108)
    (= (x-of-push-right-0001-any-tall-narrow-11 item-03) 9857) (= (y-of-push-right-0001-any-tall-narrow-11 item-03) 9743) (= (cost-of-push-right-0001-any-tall-narrow-11 item-03) 22)
    (= (x-of-push-right-0001a-any-tall-narrow-11 item-03) 10053) (= (y-of-push-right-0001a-any-tall-narrow-11 item-03) 10317) (= (cost-of-push-right-0001a-any-tall-narrow-11 item-03) 187)
    (= (x-of-push-right-0011-any-tall-narrow-11 item-03) 10126) (= (y-of-push-right-0011-any-tall-narrow-11 item-03) 9654) (= (cost-of-push-right-0011-any-tall-narrow-11 item-03) 278)
    (can-push-right-0101d-any-tall-narrow-11 item-03) (= (x-of-push-right-0101d-any-tall-narrow-11 item-03) 9914) (= (y-of-push-right-0101d-any-tall-narrow-11 item-03) 9735) (= (cost-of-push-right-0101d-any-tall-narrow-11 item-03) 26)
    (can-push-right-0111-any-tall-narrow-11 item-03) (= (x-of-push-right-0111-any-tall-narrow-11 item-03) 9842) (= (y-of-push-right-0111-any-tall-narrow-11 item-03) 9690) (= (cost-of-push-right-0111-any-tall-narrow-11 item-03) 34)
    ; item-04 starts at (0.8477, 0.0780, 0.0295) m
    (= (x item-04) 4977) (= (y item-04) 3780) (= (z item-04) 0)
    ; What each operator promises for item-04 (features 0.1359 0.1359 0.05901 2).
    ; Not for item-04:
    ; lift-0010a-hollow-wide-00: keeps its promise in 2 of 30 rehearsals only.
    ; lift-1101-hollow-wide-00: keeps its promise with such objects in about 3 of 30 only.
    ; pull-right-0110-hollow-wide-00: scatters more than it moves.
    (can-lift-0000-hollow-wide-00 item-04) (= (x-of-lift-0000-hollow-wide-00 item-04) 9612) (= (y-of-lift-0000-hollow-wide-00 item-04) 9495) (= (z-of-lift-0000-hollow-wide-00 item-04) 11743) (= (cost-of-lift-0000-hollow-wide-00 item-04) 117)
    (= (x-of-put-down-lift-0000-hollow-wide-00 item-04) 9937) (= (y-of-put-down-lift-0000-hollow-wide-00 item-04) 10164) (= (z-of-put-down-lift-0000-hollow-wide-00 item-04) 8257)
    (can-lift-0001-hollow-wide-00 item-04) (= (x-of-lift-0001-hollow-wide-00 item-04) 9655) (= (y-of-lift-0001-hollow-wide-00 item-04) 9118) (= (z-of-lift-0001-hollow-wide-00 item-04) 12500) (= (cost-of-lift-0001-hollow-wide-00 item-04) 4)
    (= (x-of-put-down-lift-0001-hollow-wide-00 item-04) 9998) (= (y-of-put-down-lift-0001-hollow-wide-00 item-04) 9967) (= (z-of-put-down-lift-0001-hollow-wide-00 item-04) 7500)
    (= (x-of-lift-0010a-hollow-wide-00 item-04) 10035) (= (y-of-lift-0010a-hollow-wide-00 item-04) 9716) (= (z-of-lift-0010a-hollow-wide-00 item-04) 12008) (= (cost-of-lift-0010a-hollow-wide-00 item-04) 238)
    (= (x-of-put-down-lift-0010a-hollow-wide-00 item-04) 10000) (= (y-of-put-down-lift-0010a-hollow-wide-00 item-04) 9963) (= (z-of-put-down-lift-0010a-hollow-wide-00 item-04) 7992)
    (can-lift-0011-hollow-wide-00 item-04) (= (x-of-lift-0011-hollow-wide-00 item-04) 10319) (= (y-of-lift-0011-hollow-wide-00 item-04) 8855) (= (z-of-lift-0011-hollow-wide-00 item-04) 12001) (= (cost-of-lift-0011-hollow-wide-00 item-04) 59)
    (= (x-of-put-down-lift-0011-hollow-wide-00 item-04) 9998) (= (y-of-put-down-lift-0011-hollow-wide-00 item-04) 9970) (= (z-of-put-down-lift-0011-hollow-wide-00 item-04) 7999)
    (can-lift-0011a-hollow-wide-00 item-04) (= (x-of-lift-0011a-hollow-wide-00 item-04) 10498) (= (y-of-lift-0011a-hollow-wide-00 item-04) 9268) (= (z-of-lift-0011a-hollow-wide-00 item-04) 12533) (= (cost-of-lift-0011a-hollow-wide-00 item-04) 4)
    (= (x-of-put-down-lift-0011a-hollow-wide-00 item-04) 9989) (= (y-of-put-down-lift-0011a-hollow-wide-00 item-04) 9961) (= (z-of-put-down-lift-0011a-hollow-wide-00 item-04) 7467)
    (can-lift-1000-hollow-wide-00 item-04) (= (x-of-lift-1000-hollow-wide-00 item-04) 9725) (= (y-of-lift-1000-hollow-wide-00 item-04) 11053) (= (z-of-lift-1000-hollow-wide-00 item-04) 12051) (= (cost-of-lift-1000-hollow-wide-00 item-04) 4)
    (= (x-of-put-down-lift-1000-hollow-wide-00 item-04) 10004) (= (y-of-put-down-lift-1000-hollow-wide-00 item-04) 9972) (= (z-of-put-down-lift-1000-hollow-wide-00 item-04) 7949)
    (can-lift-1000a-hollow-wide-00 item-04) (= (x-of-lift-1000a-hollow-wide-00 item-04) 9583) (= (y-of-lift-1000a-hollow-wide-00 item-04) 10381) (= (z-of-lift-1000a-hollow-wide-00 item-04) 12474) (= (cost-of-lift-1000a-hollow-wide-00 item-04) 4)
    (= (x-of-put-down-lift-1000a-hollow-wide-00 item-04) 9998) (= (y-of-put-down-lift-1000a-hollow-wide-00 item-04) 9964) (= (z-of-put-down-lift-1000a-hollow-wide-00 item-04) 7526)
    (can-lift-1001a-hollow-wide-00 item-04) (= (x-of-lift-1001a-hollow-wide-00 item-04) 10211) (= (y-of-lift-1001a-hollow-wide-00 item-04) 10230) (= (z-of-lift-1001a-hollow-wide-00 item-04) 12152) (= (cost-of-lift-1001a-hollow-wide-00 item-04) 4)
    (= (x-of-put-down-lift-1001a-hollow-wide-00 item-04) 9996) (= (y-of-put-down-lift-1001a-hollow-wide-00 item-04) 9962) (= (z-of-put-down-lift-1001a-hollow-wide-00 item-04) 7848)
    (can-lift-1010a-hollow-wide-00 item-04) (= (x-of-lift-1010a-hollow-wide-00 item-04) 10278) (= (y-of-lift-1010a-hollow-wide-00 item-04) 10954) (= (z-of-lift-1010a-hollow-wide-00 item-04) 11998) (= (cost-of-lift-1010a-hollow-wide-00 item-04) 4)
    (= (x-of-put-down-lift-1010a-hollow-wide-00 item-04) 9998) (= (y-of-put-down-lift-1010a-hollow-wide-00 item-04) 9971) (= (z-of-put-down-lift-1010a-hollow-wide-00 item-04) 8002)
    (= (x-of-lift-1101-hollow-wide-00 item-04) 10299) (= (y-of-lift-1101-hollow-wide-00 item-04) 10160) (= (z-of-lift-1101-hollow-wide-00 item-04) 12009) (= (cost-of-lift-1101-hollow-wide-00 item-04) 209)
    (= (x-of-put-down-lift-1101-hollow-wide-00 item-04) 10020) (= (y-of-put-down-lift-1101-hollow-wide-00 item-04) 10011) (= (z-of-put-down-lift-1101-hollow-wide-00 item-04) 7991)
    (can-place-back-right-0000-hollow-wide-00 item-04) (= (x-of-place-back-right-0000-hollow-wide-00 item-04) 9599) (= (y-of-place-back-right-0000-hollow-wide-00 item-04) 9671) (= (cost-of-place-back-right-0000-hollow-wide-00 item-04) 64)
    (can-place-right-0111-hollow-wide-00 item-04) (= (x-of-place-right-0111-hollow-wide-00 item-04) 9653) (= (y-of-place-right-0111-hollow-wide-00 item-04) 9061) (= (cost-of-place-right-0111-hollow-wide-00 item-04) 11)
    (can-place-right-0111a-hollow-wide-00 item-04) (= (x-of-place-right-0111a-hollow-wide-00 item-04) 10171) (= (y-of-place-right-0111a-hollow-wide-00 item-04) 9059) (= (cost-of-place-right-0111a-hollow-wide-00 item-04) 4)
    (can-pull-0100-hollow-wide-00 item-04) (= (x-of-pull-0100-hollow-wide-00 item-04) 8882) (= (y-of-pull-0100-hollow-wide-00 item-04) 9822) (= (cost-of-pull-0100-hollow-wide-00 item-04) 11)
    (can-pull-left-0110a-hollow-wide-00 item-04) (= (x-of-pull-left-0110a-hollow-wide-00 item-04) 9659) (= (y-of-pull-left-0110a-hollow-wide-00 item-04) 10287) (= (cost-of-pull-left-0110a-hollow-wide-00 item-04) 4)
    (can-pull-right-0100a-hollow-wide-00 item-04) (= (x-of-pull-right-0100a-hollow-wide-00 item-04) 9589) (= (y-of-pull-right-0100a-hollow-wide-00 item-04) 9674) (= (cost-of-pull-right-0100a-hollow-wide-00 item-04) 4)
    (= (x-of-pull-right-0110-hollow-wide-00 item-04) 9932) (= (y-of-pull-right-0110-hollow-wide-00 item-04) 9958) (= (cost-of-pull-right-0110-hollow-wide-00 item-04) 4)
    (can-push-forward-1011a-hollow-wide-00 item-04) (= (x-of-push-forward-1011a-hollow-wide-00 item-04) 11070) (= (y-of-push-forward-1011a-hollow-wide-00 item-04) 10017) (= (cost-of-push-forward-1011a-hollow-wide-00 item-04) 11)
    (can-push-forward-1110a-hollow-wide-00 item-04) (= (x-of-push-forward-1110a-hollow-wide-00 item-04) 10300) (= (y-of-push-forward-1110a-hollow-wide-00 item-04) 9902) (= (cost-of-push-forward-1110a-hollow-wide-00 item-04) 4)
    (can-push-forward-left-1111a-hollow-wide-00 item-04) (= (x-of-push-forward-left-1111a-hollow-wide-00 item-04) 10276) (= (y-of-push-forward-left-1111a-hollow-wide-00 item-04) 10431) (= (cost-of-push-forward-left-1111a-hollow-wide-00 item-04) 4)
    (can-push-forward-right-0101a-hollow-wide-00 item-04) (= (x-of-push-forward-right-0101a-hollow-wide-00 item-04) 10363) (= (y-of-push-forward-right-0101a-hollow-wide-00 item-04) 9787) (= (cost-of-push-forward-right-0101a-hollow-wide-00 item-04) 4)
    (can-push-left-1100a-hollow-wide-00 item-04) (= (x-of-push-left-1100a-hollow-wide-00 item-04) 9768) (= (y-of-push-left-1100a-hollow-wide-00 item-04) 10743) (= (cost-of-push-left-1100a-hollow-wide-00 item-04) 11)
    (can-push-right-0010a-hollow-wide-00 item-04) (= (x-of-push-right-0010a-hollow-wide-00 item-04) 9957) (= (y-of-push-right-0010a-hollow-wide-00 item-04) 9591) (= (cost-of-push-right-0010a-hollow-wide-00 item-04) 14)
    (can-push-right-0011-hollow-wide-00 item-04) (= (x-of-push-right-0011-hollow-wide-00 item-04) 10054) (= (y-of-push-right-0011-hollow-wide-00 item-04) 9578) (= (cost-of-push-right-0011-hollow-wide-00 item-04) 84)
    (can-push-right-1101-hollow-wide-00 item-04) (= (x-of-push-right-1101-hollow-wide-00 item-04) 10031) (= (y-of-push-right-1101-hollow-wide-00 item-04) 9560) (= (cost-of-push-right-1101-hollow-wide-00 item-04) 14))
  (:goal (and
    ; item-01 shall come to (0.4873, 0.1700, 0.0273) m, 179 mm from where it starts
    (<= (x item-01) 1828) (>= (x item-01) 918)
    (<= (+ (x item-01) (y item-01)) 6717) (>= (+ (x item-01) (y item-01)) 5430)
    (<= (y item-01) 5156) (>= (y item-01) 4246)
    (<= (y item-01) (+ (x item-01) 3971)) (<= (+ (x item-01) 2684) (y item-01))
    (>= (z item-01) 0) (<= (z item-01) 0)
    ; item-02 shall come to (0.5249, -0.1727, 0.0182) m, 174 mm from where it starts
    (<= (x item-02) 2204) (>= (x item-02) 1294)
    (<= (+ (x item-02) (y item-02)) 3665) (>= (+ (x item-02) (y item-02)) 2378)
    (<= (y item-02) 1728) (>= (y item-02) 818)
    (<= (y item-02) (+ (x item-02) 168)) (<= (x item-02) (+ (y item-02) 1120))
    (>= (z item-02) 0) (<= (z item-02) 0)
    ; item-03 shall come to (0.6480, -0.1608, 0.0210) m, 343 mm from where it starts
    (<= (x item-03) 3435) (>= (x item-03) 2525)
    (<= (+ (x item-03) (y item-03)) 5015) (>= (+ (x item-03) (y item-03)) 3728)
    (<= (y item-03) 1847) (>= (y item-03) 937)
    (<= (+ (y item-03) 944) (x item-03)) (<= (x item-03) (+ (y item-03) 2231))
    (>= (z item-03) 0) (<= (z item-03) 0)
    ; item-04 shall come to (0.6855, 0.1276, 0.0295) m, 170 mm from where it starts
    (<= (x item-04) 3810) (>= (x item-04) 2900)
    (<= (+ (x item-04) (y item-04)) 8274) (>= (+ (x item-04) (y item-04)) 6987)
    (<= (y item-04) 4730) (>= (y item-04) 3820)
    (<= (y item-04) (+ (x item-04) 1564)) (<= (+ (x item-04) 277) (y item-04))
    (>= (z item-04) 0) (<= (z item-04) 0)))
  (:metric minimize (total-cost)))
