; Problem anywhere-2-04 of the learned domain places, for its encoding numeric.
; How it came about: anywhere, drawn with seed 5; draw 1.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem anywhere-2-04)
  (:domain places-numeric)
  (:objects
    item-01 - hollow-wide-00
    item-02 - solid-low-narrow-01)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.7159, 0.1108, 0.0261) m
    (= (x item-01) 3659) (= (y item-01) 4108) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.1461 0.1461 0.0522 2).
    ; Not for item-01:
    ; lift-0000-hollow-wide-00: keeps its promise with such objects in about 6 of 30 only.
    ; lift-0010a-hollow-wide-00: keeps its promise with such objects in about 4 of 30 only.
    ; lift-1101-hollow-wide-00: keeps its promise with such objects in about 3 of 30 only.
    ; pull-right-0110-hollow-wide-00: scatters more than it moves.
    (= (x-of-lift-0000-hollow-wide-00 item-01) 9711) (= (y-of-lift-0000-hollow-wide-00 item-01) 9377) (= (z-of-lift-0000-hollow-wide-00 item-01) 11655) (= (cost-of-lift-0000-hollow-wide-00 item-01) 153)
    (= (x-of-put-down-lift-0000-hollow-wide-00 item-01) 9923) (= (y-of-put-down-lift-0000-hollow-wide-00 item-01) 10116) (= (z-of-put-down-lift-0000-hollow-wide-00 item-01) 8345)
    (can-lift-0001-hollow-wide-00 item-01) (= (x-of-lift-0001-hollow-wide-00 item-01) 9652) (= (y-of-lift-0001-hollow-wide-00 item-01) 9069) (= (z-of-lift-0001-hollow-wide-00 item-01) 12499) (= (cost-of-lift-0001-hollow-wide-00 item-01) 4)
    (= (x-of-put-down-lift-0001-hollow-wide-00 item-01) 10000) (= (y-of-put-down-lift-0001-hollow-wide-00 item-01) 9965) (= (z-of-put-down-lift-0001-hollow-wide-00 item-01) 7501)
    (= (x-of-lift-0010a-hollow-wide-00 item-01) 10038) (= (y-of-lift-0010a-hollow-wide-00 item-01) 9684) (= (z-of-lift-0010a-hollow-wide-00 item-01) 12008) (= (cost-of-lift-0010a-hollow-wide-00 item-01) 187)
    (= (x-of-put-down-lift-0010a-hollow-wide-00 item-01) 9999) (= (y-of-put-down-lift-0010a-hollow-wide-00 item-01) 9964) (= (z-of-put-down-lift-0010a-hollow-wide-00 item-01) 7992)
    (can-lift-0011-hollow-wide-00 item-01) (= (x-of-lift-0011-hollow-wide-00 item-01) 10311) (= (y-of-lift-0011-hollow-wide-00 item-01) 8799) (= (z-of-lift-0011-hollow-wide-00 item-01) 11995) (= (cost-of-lift-0011-hollow-wide-00 item-01) 77)
    (= (x-of-put-down-lift-0011-hollow-wide-00 item-01) 9999) (= (y-of-put-down-lift-0011-hollow-wide-00 item-01) 9970) (= (z-of-put-down-lift-0011-hollow-wide-00 item-01) 8005)
    (can-lift-0011a-hollow-wide-00 item-01) (= (x-of-lift-0011a-hollow-wide-00 item-01) 10499) (= (y-of-lift-0011a-hollow-wide-00 item-01) 9220) (= (z-of-lift-0011a-hollow-wide-00 item-01) 12496) (= (cost-of-lift-0011a-hollow-wide-00 item-01) 4)
    (= (x-of-put-down-lift-0011a-hollow-wide-00 item-01) 9992) (= (y-of-put-down-lift-0011a-hollow-wide-00 item-01) 9961) (= (z-of-put-down-lift-0011a-hollow-wide-00 item-01) 7504)
    (can-lift-1000-hollow-wide-00 item-01) (= (x-of-lift-1000-hollow-wide-00 item-01) 9700) (= (y-of-lift-1000-hollow-wide-00 item-01) 11096) (= (z-of-lift-1000-hollow-wide-00 item-01) 12035) (= (cost-of-lift-1000-hollow-wide-00 item-01) 4)
    (= (x-of-put-down-lift-1000-hollow-wide-00 item-01) 10003) (= (y-of-put-down-lift-1000-hollow-wide-00 item-01) 9973) (= (z-of-put-down-lift-1000-hollow-wide-00 item-01) 7965)
    (can-lift-1000a-hollow-wide-00 item-01) (= (x-of-lift-1000a-hollow-wide-00 item-01) 9585) (= (y-of-lift-1000a-hollow-wide-00 item-01) 10430) (= (z-of-lift-1000a-hollow-wide-00 item-01) 12449) (= (cost-of-lift-1000a-hollow-wide-00 item-01) 4)
    (= (x-of-put-down-lift-1000a-hollow-wide-00 item-01) 9998) (= (y-of-put-down-lift-1000a-hollow-wide-00 item-01) 9965) (= (z-of-put-down-lift-1000a-hollow-wide-00 item-01) 7551)
    (can-lift-1001a-hollow-wide-00 item-01) (= (x-of-lift-1001a-hollow-wide-00 item-01) 10179) (= (y-of-lift-1001a-hollow-wide-00 item-01) 10285) (= (z-of-lift-1001a-hollow-wide-00 item-01) 12157) (= (cost-of-lift-1001a-hollow-wide-00 item-01) 4)
    (= (x-of-put-down-lift-1001a-hollow-wide-00 item-01) 9998) (= (y-of-put-down-lift-1001a-hollow-wide-00 item-01) 9966) (= (z-of-put-down-lift-1001a-hollow-wide-00 item-01) 7843)
    (can-lift-1010a-hollow-wide-00 item-01) (= (x-of-lift-1010a-hollow-wide-00 item-01) 10275) (= (y-of-lift-1010a-hollow-wide-00 item-01) 10994) (= (z-of-lift-1010a-hollow-wide-00 item-01) 11998) (= (cost-of-lift-1010a-hollow-wide-00 item-01) 4)
    (= (x-of-put-down-lift-1010a-hollow-wide-00 item-01) 9999) (= (y-of-put-down-lift-1010a-hollow-wide-00 item-01) 9974) (= (z-of-put-down-lift-1010a-hollow-wide-00 item-01) 8002)
    (= (x-of-lift-1101-hollow-wide-00 item-01) 10314) (= (y-of-lift-1101-hollow-wide-00 item-01) 10157) (= (z-of-lift-1101-hollow-wide-00 item-01) 12004) (= (cost-of-lift-1101-hollow-wide-00 item-01) 209)
    (= (x-of-put-down-lift-1101-hollow-wide-00 item-01) 10012) (= (y-of-put-down-lift-1101-hollow-wide-00 item-01) 10011) (= (z-of-put-down-lift-1101-hollow-wide-00 item-01) 7996)
    (can-place-back-right-0000-hollow-wide-00 item-01) (= (x-of-place-back-right-0000-hollow-wide-00 item-01) 9682) (= (y-of-place-back-right-0000-hollow-wide-00 item-01) 9507) (= (cost-of-place-back-right-0000-hollow-wide-00 item-01) 117)
    (can-place-right-0111-hollow-wide-00 item-01) (= (x-of-place-right-0111-hollow-wide-00 item-01) 9620) (= (y-of-place-right-0111-hollow-wide-00 item-01) 8981) (= (cost-of-place-right-0111-hollow-wide-00 item-01) 7)
    (can-place-right-0111a-hollow-wide-00 item-01) (= (x-of-place-right-0111a-hollow-wide-00 item-01) 10189) (= (y-of-place-right-0111a-hollow-wide-00 item-01) 9011) (= (cost-of-place-right-0111a-hollow-wide-00 item-01) 4)
    (can-pull-0100-hollow-wide-00 item-01) (= (x-of-pull-0100-hollow-wide-00 item-01) 8943) (= (y-of-pull-0100-hollow-wide-00 item-01) 9854) (= (cost-of-pull-0100-hollow-wide-00 item-01) 11)
    (can-pull-left-0110a-hollow-wide-00 item-01) (= (x-of-pull-left-0110a-hollow-wide-00 item-01) 9668) (= (y-of-pull-left-0110a-hollow-wide-00 item-01) 10282) (= (cost-of-pull-left-0110a-hollow-wide-00 item-01) 4)
    (can-pull-right-0100a-hollow-wide-00 item-01) (= (x-of-pull-right-0100a-hollow-wide-00 item-01) 9608) (= (y-of-pull-right-0100a-hollow-wide-00 item-01) 9676) (= (cost-of-pull-right-0100a-hollow-wide-00 item-01) 4)
    (= (x-of-pull-right-0110-hollow-wide-00 item-01) 9891) (= (y-of-pull-right-0110-hollow-wide-00 item-01) 10017) (= (cost-of-pull-right-0110-hollow-wide-00 item-01) 4)
    (can-push-forward-1011a-hollow-wide-00 item-01) (= (x-of-push-forward-1011a-hollow-wide-00 item-01) 11032) (= (y-of-push-forward-1011a-hollow-wide-00 item-01) 9996) (= (cost-of-push-forward-1011a-hollow-wide-00 item-01) 11)
    (can-push-forward-1110a-hollow-wide-00 item-01) (= (x-of-push-forward-1110a-hollow-wide-00 item-01) 10303) (= (y-of-push-forward-1110a-hollow-wide-00 item-01) 9907) (= (cost-of-push-forward-1110a-hollow-wide-00 item-01) 4)
    (can-push-forward-left-1111a-hollow-wide-00 item-01) (= (x-of-push-forward-left-1111a-hollow-wide-00 item-01) 10291) (= (y-of-push-forward-left-1111a-hollow-wide-00 item-01) 10442) (= (cost-of-push-forward-left-1111a-hollow-wide-00 item-01) 4)
    (can-push-forward-right-0101a-hollow-wide-00 item-01) (= (x-of-push-forward-right-0101a-hollow-wide-00 item-01) 10389) (= (y-of-push-forward-right-0101a-hollow-wide-00 item-01) 9691) (= (cost-of-push-forward-right-0101a-hollow-wide-00 item-01) 4)
    (can-push-left-1100a-hollow-wide-00 item-01) (= (x-of-push-left-1100a-hollow-wide-00 item-01) 9713) (= (y-of-push-left-1100a-hollow-wide-00 item-01) 10819) (= (cost-of-push-left-1100a-hollow-wide-00 item-01) 11)
    (can-push-right-0010a-hollow-wide-00 item-01) (= (x-of-push-right-0010a-hollow-wide-00 item-01) 9971) (= (y-of-push-right-0010a-hollow-wide-00 item-01) 9695) (= (cost-of-push-right-0010a-hollow-wide-00 item-01) 38)
    (can-push-right-0011-hollow-wide-00 item-01) (= (x-of-push-right-0011-hollow-wide-00 item-01) 10047) (= (y-of-push-right-0011-hollow-wide-00 item-01) 9578) (= (cost-of-push-right-0011-hollow-wide-00 item-01) 64)
    (can-push-right-1101-hollow-wide-00 item-01) (= (x-of-push-right-1101-hollow-wide-00 item-01) 9997) (= (y-of-push-right-1101-hollow-wide-00 item-01) 9630) (= (cost-of-push-right-1101-hollow-wide-00 item-01) 14)
    ; item-02 starts at (0.4286, -0.0882, 0.0144) m
    (= (x item-02) 786) (= (y item-02) 2118) (= (z item-02) 0)
    ; What each operator promises for item-02 (features 0.1181 0.04941 0.02889 0).
    ; Not for item-02:
    ; lift-0110b-solid-low-narrow-01: keeps its promise with such objects in about 3 of 30 only.
    ; place-back-0000-solid-low-narrow-01: keeps its promise in 2 of 30 rehearsals only.
    ; push-right-1001-solid-low-narrow-01: keeps its promise in 2 of 30 rehearsals only.
    (can-lift-0000-solid-low-narrow-01 item-02) (= (x-of-lift-0000-solid-low-narrow-01 item-02) 9182) (= (y-of-lift-0000-solid-low-narrow-01 item-02) 9926) (= (z-of-lift-0000-solid-low-narrow-01 item-02) 12020) (= (cost-of-lift-0000-solid-low-narrow-01 item-02) 26)
    (= (x-of-put-down-lift-0000-solid-low-narrow-01 item-02) 10011) (= (y-of-put-down-lift-0000-solid-low-narrow-01 item-02) 9982) (= (z-of-put-down-lift-0000-solid-low-narrow-01 item-02) 7980)
    (can-lift-0000a-solid-low-narrow-01 item-02) (= (x-of-lift-0000a-solid-low-narrow-01 item-02) 9496) (= (y-of-lift-0000a-solid-low-narrow-01 item-02) 10248) (= (z-of-lift-0000a-solid-low-narrow-01 item-02) 12448) (= (cost-of-lift-0000a-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-0000a-solid-low-narrow-01 item-02) 10001) (= (y-of-put-down-lift-0000a-solid-low-narrow-01 item-02) 9982) (= (z-of-put-down-lift-0000a-solid-low-narrow-01 item-02) 7552)
    (can-lift-0001-solid-low-narrow-01 item-02) (= (x-of-lift-0001-solid-low-narrow-01 item-02) 9685) (= (y-of-lift-0001-solid-low-narrow-01 item-02) 9757) (= (z-of-lift-0001-solid-low-narrow-01 item-02) 12365) (= (cost-of-lift-0001-solid-low-narrow-01 item-02) 7)
    (= (x-of-put-down-lift-0001-solid-low-narrow-01 item-02) 10002) (= (y-of-put-down-lift-0001-solid-low-narrow-01 item-02) 9975) (= (z-of-put-down-lift-0001-solid-low-narrow-01 item-02) 7635)
    (can-lift-0001a-solid-low-narrow-01 item-02) (= (x-of-lift-0001a-solid-low-narrow-01 item-02) 9861) (= (y-of-lift-0001a-solid-low-narrow-01 item-02) 9782) (= (z-of-lift-0001a-solid-low-narrow-01 item-02) 11976) (= (cost-of-lift-0001a-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-0001a-solid-low-narrow-01 item-02) 10021) (= (y-of-put-down-lift-0001a-solid-low-narrow-01 item-02) 9984) (= (z-of-put-down-lift-0001a-solid-low-narrow-01 item-02) 8024)
    (can-lift-0010-solid-low-narrow-01 item-02) (= (x-of-lift-0010-solid-low-narrow-01 item-02) 10272) (= (y-of-lift-0010-solid-low-narrow-01 item-02) 10217) (= (z-of-lift-0010-solid-low-narrow-01 item-02) 12304) (= (cost-of-lift-0010-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-0010-solid-low-narrow-01 item-02) 10001) (= (y-of-put-down-lift-0010-solid-low-narrow-01 item-02) 9983) (= (z-of-put-down-lift-0010-solid-low-narrow-01 item-02) 7696)
    (can-lift-0011b-solid-low-narrow-01 item-02) (= (x-of-lift-0011b-solid-low-narrow-01 item-02) 10388) (= (y-of-lift-0011b-solid-low-narrow-01 item-02) 9548) (= (z-of-lift-0011b-solid-low-narrow-01 item-02) 12376) (= (cost-of-lift-0011b-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-0011b-solid-low-narrow-01 item-02) 9990) (= (y-of-put-down-lift-0011b-solid-low-narrow-01 item-02) 9985) (= (z-of-put-down-lift-0011b-solid-low-narrow-01 item-02) 7624)
    (= (x-of-lift-0110b-solid-low-narrow-01 item-02) 10546) (= (y-of-lift-0110b-solid-low-narrow-01 item-02) 9917) (= (z-of-lift-0110b-solid-low-narrow-01 item-02) 11997) (= (cost-of-lift-0110b-solid-low-narrow-01 item-02) 209)
    (= (x-of-put-down-lift-0110b-solid-low-narrow-01 item-02) 10000) (= (y-of-put-down-lift-0110b-solid-low-narrow-01 item-02) 9984) (= (z-of-put-down-lift-0110b-solid-low-narrow-01 item-02) 8003)
    (can-lift-1000-solid-low-narrow-01 item-02) (= (x-of-lift-1000-solid-low-narrow-01 item-02) 9625) (= (y-of-lift-1000-solid-low-narrow-01 item-02) 10428) (= (z-of-lift-1000-solid-low-narrow-01 item-02) 11996) (= (cost-of-lift-1000-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-1000-solid-low-narrow-01 item-02) 10004) (= (y-of-put-down-lift-1000-solid-low-narrow-01 item-02) 9981) (= (z-of-put-down-lift-1000-solid-low-narrow-01 item-02) 8004)
    (can-lift-1001-solid-low-narrow-01 item-02) (= (x-of-lift-1001-solid-low-narrow-01 item-02) 9897) (= (y-of-lift-1001-solid-low-narrow-01 item-02) 9467) (= (z-of-lift-1001-solid-low-narrow-01 item-02) 11975) (= (cost-of-lift-1001-solid-low-narrow-01 item-02) 11)
    (= (x-of-put-down-lift-1001-solid-low-narrow-01 item-02) 10020) (= (y-of-put-down-lift-1001-solid-low-narrow-01 item-02) 9983) (= (z-of-put-down-lift-1001-solid-low-narrow-01 item-02) 8025)
    (can-lift-1001b-solid-low-narrow-01 item-02) (= (x-of-lift-1001b-solid-low-narrow-01 item-02) 10394) (= (y-of-lift-1001b-solid-low-narrow-01 item-02) 9478) (= (z-of-lift-1001b-solid-low-narrow-01 item-02) 12006) (= (cost-of-lift-1001b-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-1001b-solid-low-narrow-01 item-02) 9994) (= (y-of-put-down-lift-1001b-solid-low-narrow-01 item-02) 9987) (= (z-of-put-down-lift-1001b-solid-low-narrow-01 item-02) 7994)
    (can-lift-1010-solid-low-narrow-01 item-02) (= (x-of-lift-1010-solid-low-narrow-01 item-02) 10313) (= (y-of-lift-1010-solid-low-narrow-01 item-02) 10442) (= (z-of-lift-1010-solid-low-narrow-01 item-02) 11990) (= (cost-of-lift-1010-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-1010-solid-low-narrow-01 item-02) 10012) (= (y-of-put-down-lift-1010-solid-low-narrow-01 item-02) 9983) (= (z-of-put-down-lift-1010-solid-low-narrow-01 item-02) 8010)
    (= (x-of-place-back-0000-solid-low-narrow-01 item-02) 9039) (= (y-of-place-back-0000-solid-low-narrow-01 item-02) 10130) (= (cost-of-place-back-0000-solid-low-narrow-01 item-02) 238)
    (can-place-right-0111b-solid-low-narrow-01 item-02) (= (x-of-place-right-0111b-solid-low-narrow-01 item-02) 10141) (= (y-of-place-right-0111b-solid-low-narrow-01 item-02) 9457) (= (cost-of-place-right-0111b-solid-low-narrow-01 item-02) 4)
    (can-pull-1100b-solid-low-narrow-01 item-02) (= (x-of-pull-1100b-solid-low-narrow-01 item-02) 9421) (= (y-of-pull-1100b-solid-low-narrow-01 item-02) 10164) (= (cost-of-pull-1100b-solid-low-narrow-01 item-02) 4)
    (can-pull-right-0100b-solid-low-narrow-01 item-02) (= (x-of-pull-right-0100b-solid-low-narrow-01 item-02) 9286) (= (y-of-pull-right-0100b-solid-low-narrow-01 item-02) 9632) (= (cost-of-pull-right-0100b-solid-low-narrow-01 item-02) 4)
    (can-pull-right-0110b-solid-low-narrow-01 item-02) (= (x-of-pull-right-0110b-solid-low-narrow-01 item-02) 9799) (= (y-of-pull-right-0110b-solid-low-narrow-01 item-02) 9899) (= (cost-of-pull-right-0110b-solid-low-narrow-01 item-02) 14)
    (can-pull-right-0111-solid-low-narrow-01 item-02) (= (x-of-pull-right-0111-solid-low-narrow-01 item-02) 9727) (= (y-of-pull-right-0111-solid-low-narrow-01 item-02) 9637) (= (cost-of-pull-right-0111-solid-low-narrow-01 item-02) 4)
    (can-push-forward-1011-solid-low-narrow-01 item-02) (= (x-of-push-forward-1011-solid-low-narrow-01 item-02) 10972) (= (y-of-push-forward-1011-solid-low-narrow-01 item-02) 10239) (= (cost-of-push-forward-1011-solid-low-narrow-01 item-02) 4)
    (can-push-forward-right-1111-solid-low-narrow-01 item-02) (= (x-of-push-forward-right-1111-solid-low-narrow-01 item-02) 10636) (= (y-of-push-forward-right-1111-solid-low-narrow-01 item-02) 9530) (= (cost-of-push-forward-right-1111-solid-low-narrow-01 item-02) 4)
    (can-push-left-0110-solid-low-narrow-01 item-02) (= (x-of-push-left-0110-solid-low-narrow-01 item-02) 9788) (= (y-of-push-left-0110-solid-low-narrow-01 item-02) 10720) (= (cost-of-push-left-0110-solid-low-narrow-01 item-02) 4)
    (can-push-left-1101-solid-low-narrow-01 item-02) (= (x-of-push-left-1101-solid-low-narrow-01 item-02) 9964) (= (y-of-push-left-1101-solid-low-narrow-01 item-02) 10370) (= (cost-of-push-left-1101-solid-low-narrow-01 item-02) 4)
    (can-push-left-1110b-solid-low-narrow-01 item-02) (= (x-of-push-left-1110b-solid-low-narrow-01 item-02) 10386) (= (y-of-push-left-1110b-solid-low-narrow-01 item-02) 11349) (= (cost-of-push-left-1110b-solid-low-narrow-01 item-02) 7)
    (can-push-right-0101b-solid-low-narrow-01 item-02) (= (x-of-push-right-0101b-solid-low-narrow-01 item-02) 9802) (= (y-of-push-right-0101b-solid-low-narrow-01 item-02) 8655) (= (cost-of-push-right-0101b-solid-low-narrow-01 item-02) 7)
    (= (x-of-push-right-1001-solid-low-narrow-01 item-02) 10000) (= (y-of-push-right-1001-solid-low-narrow-01 item-02) 9754) (= (cost-of-push-right-1001-solid-low-narrow-01 item-02) 238))
  (:goal (and
    ; item-01 shall come to (0.8540, 0.1715, 0.0261) m, 151 mm from where it starts
    (<= (x item-01) 5495) (>= (x item-01) 4586)
    (<= (+ (x item-01) (y item-01)) 10399) (>= (+ (x item-01) (y item-01)) 9112)
    (<= (y item-01) 5170) (>= (y item-01) 4260)
    (<= (y item-01) (+ (x item-01) 318)) (<= (x item-01) (+ (y item-01) 969))
    (>= (z item-01) 0) (<= (z item-01) 0)
    ; item-02 shall come to (0.7597, -0.1727, 0.0144) m, 342 mm from where it starts
    (<= (x item-02) 4552) (>= (x item-02) 3642)
    (<= (+ (x item-02) (y item-02)) 6014) (>= (+ (x item-02) (y item-02)) 4727)
    (<= (y item-02) 1728) (>= (y item-02) 819)
    (<= (+ (y item-02) 2180) (x item-02)) (<= (x item-02) (+ (y item-02) 3467))
    (>= (z item-02) 0) (<= (z item-02) 0)))
  (:metric minimize (total-cost)))
