; Problem swap-3-09 of the learned domain places, for its encoding numeric.
; How it came about: swap, drawn with seed 10; draw 1.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem swap-3-09)
  (:domain places-numeric)
  (:objects
    item-01 - hollow-wide-00
    item-02 - any-tall-narrow-11
    item-03 - solid-low-10)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.6303, -0.1300, 0.0123) m
    (= (x item-01) 2803) (= (y item-01) 1700) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.1413 0.1344 0.02455 1).
    ; Not for item-01:
    ; lift-1101-hollow-wide-00: keeps its promise in 0 of 30 rehearsals only.
    ; place-back-right-0000-hollow-wide-00: keeps its promise with such objects in about 3 of 30 only.
    ; push-right-0010a-hollow-wide-00: keeps its promise in 1 of 30 rehearsals only.
    ; push-right-0011-hollow-wide-00: keeps its promise with such objects in about 4 of 30 only.
    ; push-right-1101-hollow-wide-00: scatters more than it moves.
    (can-lift-0000-hollow-wide-00 item-01) (= (x-of-lift-0000-hollow-wide-00 item-01) 9235) (= (y-of-lift-0000-hollow-wide-00 item-01) 9566) (= (z-of-lift-0000-hollow-wide-00 item-01) 12130) (= (cost-of-lift-0000-hollow-wide-00 item-01) 26)
    (= (x-of-put-down-lift-0000-hollow-wide-00 item-01) 10010) (= (y-of-put-down-lift-0000-hollow-wide-00 item-01) 9946) (= (z-of-put-down-lift-0000-hollow-wide-00 item-01) 7870)
    (can-lift-0001-hollow-wide-00 item-01) (= (x-of-lift-0001-hollow-wide-00 item-01) 9684) (= (y-of-lift-0001-hollow-wide-00 item-01) 9145) (= (z-of-lift-0001-hollow-wide-00 item-01) 12286) (= (cost-of-lift-0001-hollow-wide-00 item-01) 4)
    (= (x-of-put-down-lift-0001-hollow-wide-00 item-01) 10000) (= (y-of-put-down-lift-0001-hollow-wide-00 item-01) 9950) (= (z-of-put-down-lift-0001-hollow-wide-00 item-01) 7714)
    (can-lift-0010a-hollow-wide-00 item-01) (= (x-of-lift-0010a-hollow-wide-00 item-01) 9935) (= (y-of-lift-0010a-hollow-wide-00 item-01) 9739) (= (z-of-lift-0010a-hollow-wide-00 item-01) 11971) (= (cost-of-lift-0010a-hollow-wide-00 item-01) 7)
    (= (x-of-put-down-lift-0010a-hollow-wide-00 item-01) 10001) (= (y-of-put-down-lift-0010a-hollow-wide-00 item-01) 9964) (= (z-of-put-down-lift-0010a-hollow-wide-00 item-01) 8029)
    (can-lift-0011-hollow-wide-00 item-01) (= (x-of-lift-0011-hollow-wide-00 item-01) 10372) (= (y-of-lift-0011-hollow-wide-00 item-01) 8854) (= (z-of-lift-0011-hollow-wide-00 item-01) 11923) (= (cost-of-lift-0011-hollow-wide-00 item-01) 18)
    (= (x-of-put-down-lift-0011-hollow-wide-00 item-01) 10000) (= (y-of-put-down-lift-0011-hollow-wide-00 item-01) 9950) (= (z-of-put-down-lift-0011-hollow-wide-00 item-01) 8077)
    (can-lift-0011a-hollow-wide-00 item-01) (= (x-of-lift-0011a-hollow-wide-00 item-01) 10346) (= (y-of-lift-0011a-hollow-wide-00 item-01) 9285) (= (z-of-lift-0011a-hollow-wide-00 item-01) 12278) (= (cost-of-lift-0011a-hollow-wide-00 item-01) 4)
    (= (x-of-put-down-lift-0011a-hollow-wide-00 item-01) 10002) (= (y-of-put-down-lift-0011a-hollow-wide-00 item-01) 9944) (= (z-of-put-down-lift-0011a-hollow-wide-00 item-01) 7722)
    (can-lift-1000-hollow-wide-00 item-01) (= (x-of-lift-1000-hollow-wide-00 item-01) 9639) (= (y-of-lift-1000-hollow-wide-00 item-01) 10862) (= (z-of-lift-1000-hollow-wide-00 item-01) 12035) (= (cost-of-lift-1000-hollow-wide-00 item-01) 11)
    (= (x-of-put-down-lift-1000-hollow-wide-00 item-01) 10011) (= (y-of-put-down-lift-1000-hollow-wide-00 item-01) 9970) (= (z-of-put-down-lift-1000-hollow-wide-00 item-01) 7965)
    (can-lift-1000a-hollow-wide-00 item-01) (= (x-of-lift-1000a-hollow-wide-00 item-01) 9571) (= (y-of-lift-1000a-hollow-wide-00 item-01) 10376) (= (z-of-lift-1000a-hollow-wide-00 item-01) 12264) (= (cost-of-lift-1000a-hollow-wide-00 item-01) 4)
    (= (x-of-put-down-lift-1000a-hollow-wide-00 item-01) 9999) (= (y-of-put-down-lift-1000a-hollow-wide-00 item-01) 9985) (= (z-of-put-down-lift-1000a-hollow-wide-00 item-01) 7736)
    (can-lift-1001a-hollow-wide-00 item-01) (= (x-of-lift-1001a-hollow-wide-00 item-01) 10378) (= (y-of-lift-1001a-hollow-wide-00 item-01) 10217) (= (z-of-lift-1001a-hollow-wide-00 item-01) 12016) (= (cost-of-lift-1001a-hollow-wide-00 item-01) 4)
    (= (x-of-put-down-lift-1001a-hollow-wide-00 item-01) 10000) (= (y-of-put-down-lift-1001a-hollow-wide-00 item-01) 9993) (= (z-of-put-down-lift-1001a-hollow-wide-00 item-01) 7984)
    (can-lift-1010a-hollow-wide-00 item-01) (= (x-of-lift-1010a-hollow-wide-00 item-01) 10093) (= (y-of-lift-1010a-hollow-wide-00 item-01) 10952) (= (z-of-lift-1010a-hollow-wide-00 item-01) 11893) (= (cost-of-lift-1010a-hollow-wide-00 item-01) 4)
    (= (x-of-put-down-lift-1010a-hollow-wide-00 item-01) 10000) (= (y-of-put-down-lift-1010a-hollow-wide-00 item-01) 9992) (= (z-of-put-down-lift-1010a-hollow-wide-00 item-01) 8107)
    (= (x-of-lift-1101-hollow-wide-00 item-01) 10237) (= (y-of-lift-1101-hollow-wide-00 item-01) 10145) (= (z-of-lift-1101-hollow-wide-00 item-01) 12000) (= (cost-of-lift-1101-hollow-wide-00 item-01) 348)
    (= (x-of-put-down-lift-1101-hollow-wide-00 item-01) 10002) (= (y-of-put-down-lift-1101-hollow-wide-00 item-01) 10008) (= (z-of-put-down-lift-1101-hollow-wide-00 item-01) 8000)
    (= (x-of-place-back-right-0000-hollow-wide-00 item-01) 9254) (= (y-of-place-back-right-0000-hollow-wide-00 item-01) 9595) (= (cost-of-place-back-right-0000-hollow-wide-00 item-01) 209)
    (can-place-right-0111-hollow-wide-00 item-01) (= (x-of-place-right-0111-hollow-wide-00 item-01) 9759) (= (y-of-place-right-0111-hollow-wide-00 item-01) 9046) (= (cost-of-place-right-0111-hollow-wide-00 item-01) 7)
    (can-place-right-0111a-hollow-wide-00 item-01) (= (x-of-place-right-0111a-hollow-wide-00 item-01) 10040) (= (y-of-place-right-0111a-hollow-wide-00 item-01) 9060) (= (cost-of-place-right-0111a-hollow-wide-00 item-01) 4)
    (can-pull-0100-hollow-wide-00 item-01) (= (x-of-pull-0100-hollow-wide-00 item-01) 9367) (= (y-of-pull-0100-hollow-wide-00 item-01) 9969) (= (cost-of-pull-0100-hollow-wide-00 item-01) 11)
    (can-pull-left-0110a-hollow-wide-00 item-01) (= (x-of-pull-left-0110a-hollow-wide-00 item-01) 9926) (= (y-of-pull-left-0110a-hollow-wide-00 item-01) 10143) (= (cost-of-pull-left-0110a-hollow-wide-00 item-01) 4)
    (can-pull-right-0100a-hollow-wide-00 item-01) (= (x-of-pull-right-0100a-hollow-wide-00 item-01) 9891) (= (y-of-pull-right-0100a-hollow-wide-00 item-01) 9679) (= (cost-of-pull-right-0100a-hollow-wide-00 item-01) 4)
    (can-pull-right-0110-hollow-wide-00 item-01) (= (x-of-pull-right-0110-hollow-wide-00 item-01) 9907) (= (y-of-pull-right-0110-hollow-wide-00 item-01) 9559) (= (cost-of-pull-right-0110-hollow-wide-00 item-01) 7)
    (can-push-forward-1011a-hollow-wide-00 item-01) (= (x-of-push-forward-1011a-hollow-wide-00 item-01) 10820) (= (y-of-push-forward-1011a-hollow-wide-00 item-01) 10034) (= (cost-of-push-forward-1011a-hollow-wide-00 item-01) 11)
    (can-push-forward-1110a-hollow-wide-00 item-01) (= (x-of-push-forward-1110a-hollow-wide-00 item-01) 10139) (= (y-of-push-forward-1110a-hollow-wide-00 item-01) 9966) (= (cost-of-push-forward-1110a-hollow-wide-00 item-01) 4)
    (can-push-forward-left-1111a-hollow-wide-00 item-01) (= (x-of-push-forward-left-1111a-hollow-wide-00 item-01) 10040) (= (y-of-push-forward-left-1111a-hollow-wide-00 item-01) 10340) (= (cost-of-push-forward-left-1111a-hollow-wide-00 item-01) 4)
    (can-push-forward-right-0101a-hollow-wide-00 item-01) (= (x-of-push-forward-right-0101a-hollow-wide-00 item-01) 10321) (= (y-of-push-forward-right-0101a-hollow-wide-00 item-01) 9547) (= (cost-of-push-forward-right-0101a-hollow-wide-00 item-01) 4)
    (can-push-left-1100a-hollow-wide-00 item-01) (= (x-of-push-left-1100a-hollow-wide-00 item-01) 9776) (= (y-of-push-left-1100a-hollow-wide-00 item-01) 10708) (= (cost-of-push-left-1100a-hollow-wide-00 item-01) 14)
    (= (x-of-push-right-0010a-hollow-wide-00 item-01) 9853) (= (y-of-push-right-0010a-hollow-wide-00 item-01) 9595) (= (cost-of-push-right-0010a-hollow-wide-00 item-01) 278)
    (= (x-of-push-right-0011-hollow-wide-00 item-01) 10045) (= (y-of-push-right-0011-hollow-wide-00 item-01) 9545) (= (cost-of-push-right-0011-hollow-wide-00 item-01) 187)
    (= (x-of-push-right-1101-hollow-wide-00 item-01) 10003) (= (y-of-push-right-1101-hollow-wide-00 item-01) 10102) (= (cost-of-push-right-1101-hollow-wide-00 item-01) 4)
    ; item-02 starts at (0.5765, 0.0324, 0.0142) m
    (= (x item-02) 2265) (= (y item-02) 3324) (= (z item-02) 0)
    ; What each operator promises for item-02 (features 0.1063 0.1063 0.02848 2).
    ; Not for item-02:
    ; lift-0001-any-tall-narrow-11: keeps its promise with such objects in about 5 of 30 only.
    ; lift-1101a-any-tall-narrow-11: keeps its promise with such objects in about 3 of 30 only.
    ; pull-right-0011c-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    ; push-left-1000-any-tall-narrow-11: keeps its promise in 2 of 30 rehearsals only.
    ; push-right-0001-any-tall-narrow-11: scatters more than it moves.
    ; push-right-0001a-any-tall-narrow-11: scatters more than it moves.
    ; push-right-0011-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    (can-lift-0000c-any-tall-narrow-11 item-02) (= (x-of-lift-0000c-any-tall-narrow-11 item-02) 9443) (= (y-of-lift-0000c-any-tall-narrow-11 item-02) 10479) (= (z-of-lift-0000c-any-tall-narrow-11 item-02) 11994) (= (cost-of-lift-0000c-any-tall-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-0000c-any-tall-narrow-11 item-02) 10000) (= (y-of-put-down-lift-0000c-any-tall-narrow-11 item-02) 9992) (= (z-of-put-down-lift-0000c-any-tall-narrow-11 item-02) 8006)
    (= (x-of-lift-0001-any-tall-narrow-11 item-02) 9645) (= (y-of-lift-0001-any-tall-narrow-11 item-02) 9289) (= (z-of-lift-0001-any-tall-narrow-11 item-02) 12355) (= (cost-of-lift-0001-any-tall-narrow-11 item-02) 168)
    (= (x-of-put-down-lift-0001-any-tall-narrow-11 item-02) 9983) (= (y-of-put-down-lift-0001-any-tall-narrow-11 item-02) 9967) (= (z-of-put-down-lift-0001-any-tall-narrow-11 item-02) 7645)
    (can-lift-0001a-any-tall-narrow-11 item-02) (= (x-of-lift-0001a-any-tall-narrow-11 item-02) 9817) (= (y-of-lift-0001a-any-tall-narrow-11 item-02) 9802) (= (z-of-lift-0001a-any-tall-narrow-11 item-02) 11999) (= (cost-of-lift-0001a-any-tall-narrow-11 item-02) 26)
    (= (x-of-put-down-lift-0001a-any-tall-narrow-11 item-02) 10000) (= (y-of-put-down-lift-0001a-any-tall-narrow-11 item-02) 9990) (= (z-of-put-down-lift-0001a-any-tall-narrow-11 item-02) 8001)
    (can-lift-0010b-any-tall-narrow-11 item-02) (= (x-of-lift-0010b-any-tall-narrow-11 item-02) 10329) (= (y-of-lift-0010b-any-tall-narrow-11 item-02) 10235) (= (z-of-lift-0010b-any-tall-narrow-11 item-02) 12330) (= (cost-of-lift-0010b-any-tall-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-0010b-any-tall-narrow-11 item-02) 10004) (= (y-of-put-down-lift-0010b-any-tall-narrow-11 item-02) 9991) (= (z-of-put-down-lift-0010b-any-tall-narrow-11 item-02) 7670)
    (can-lift-0011-any-tall-narrow-11 item-02) (= (x-of-lift-0011-any-tall-narrow-11 item-02) 10356) (= (y-of-lift-0011-any-tall-narrow-11 item-02) 9322) (= (z-of-lift-0011-any-tall-narrow-11 item-02) 11996) (= (cost-of-lift-0011-any-tall-narrow-11 item-02) 11)
    (= (x-of-put-down-lift-0011-any-tall-narrow-11 item-02) 10005) (= (y-of-put-down-lift-0011-any-tall-narrow-11 item-02) 9980) (= (z-of-put-down-lift-0011-any-tall-narrow-11 item-02) 8004)
    (can-lift-0011c-any-tall-narrow-11 item-02) (= (x-of-lift-0011c-any-tall-narrow-11 item-02) 9829) (= (y-of-lift-0011c-any-tall-narrow-11 item-02) 9673) (= (z-of-lift-0011c-any-tall-narrow-11 item-02) 12528) (= (cost-of-lift-0011c-any-tall-narrow-11 item-02) 7)
    (= (x-of-put-down-lift-0011c-any-tall-narrow-11 item-02) 10001) (= (y-of-put-down-lift-0011c-any-tall-narrow-11 item-02) 9992) (= (z-of-put-down-lift-0011c-any-tall-narrow-11 item-02) 7472)
    (can-lift-1000-any-tall-narrow-11 item-02) (= (x-of-lift-1000-any-tall-narrow-11 item-02) 9722) (= (y-of-lift-1000-any-tall-narrow-11 item-02) 10645) (= (z-of-lift-1000-any-tall-narrow-11 item-02) 12290) (= (cost-of-lift-1000-any-tall-narrow-11 item-02) 11)
    (= (x-of-put-down-lift-1000-any-tall-narrow-11 item-02) 10017) (= (y-of-put-down-lift-1000-any-tall-narrow-11 item-02) 9979) (= (z-of-put-down-lift-1000-any-tall-narrow-11 item-02) 7710)
    (can-lift-1001d-any-tall-narrow-11 item-02) (= (x-of-lift-1001d-any-tall-narrow-11 item-02) 10631) (= (y-of-lift-1001d-any-tall-narrow-11 item-02) 9542) (= (z-of-lift-1001d-any-tall-narrow-11 item-02) 12008) (= (cost-of-lift-1001d-any-tall-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-1001d-any-tall-narrow-11 item-02) 9999) (= (y-of-put-down-lift-1001d-any-tall-narrow-11 item-02) 9993) (= (z-of-put-down-lift-1001d-any-tall-narrow-11 item-02) 7992)
    (can-lift-1010b-any-tall-narrow-11 item-02) (= (x-of-lift-1010b-any-tall-narrow-11 item-02) 10277) (= (y-of-lift-1010b-any-tall-narrow-11 item-02) 10227) (= (z-of-lift-1010b-any-tall-narrow-11 item-02) 12003) (= (cost-of-lift-1010b-any-tall-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-1010b-any-tall-narrow-11 item-02) 10003) (= (y-of-put-down-lift-1010b-any-tall-narrow-11 item-02) 9993) (= (z-of-put-down-lift-1010b-any-tall-narrow-11 item-02) 7997)
    (= (x-of-lift-1101a-any-tall-narrow-11 item-02) 10284) (= (y-of-lift-1101a-any-tall-narrow-11 item-02) 10261) (= (z-of-lift-1101a-any-tall-narrow-11 item-02) 12028) (= (cost-of-lift-1101a-any-tall-narrow-11 item-02) 209)
    (= (x-of-put-down-lift-1101a-any-tall-narrow-11 item-02) 10027) (= (y-of-put-down-lift-1101a-any-tall-narrow-11 item-02) 10026) (= (z-of-put-down-lift-1101a-any-tall-narrow-11 item-02) 7972)
    (can-place-forward-right-0111d-any-tall-narrow-11 item-02) (= (x-of-place-forward-right-0111d-any-tall-narrow-11 item-02) 10322) (= (y-of-place-forward-right-0111d-any-tall-narrow-11 item-02) 9526) (= (cost-of-place-forward-right-0111d-any-tall-narrow-11 item-02) 4)
    (can-pull-0100-any-tall-narrow-11 item-02) (= (x-of-pull-0100-any-tall-narrow-11 item-02) 8961) (= (y-of-pull-0100-any-tall-narrow-11 item-02) 9822) (= (cost-of-pull-0100-any-tall-narrow-11 item-02) 4)
    (can-pull-0110d-any-tall-narrow-11 item-02) (= (x-of-pull-0110d-any-tall-narrow-11 item-02) 9759) (= (y-of-pull-0110d-any-tall-narrow-11 item-02) 9940) (= (cost-of-pull-0110d-any-tall-narrow-11 item-02) 4)
    (can-pull-left-1110d-any-tall-narrow-11 item-02) (= (x-of-pull-left-1110d-any-tall-narrow-11 item-02) 9685) (= (y-of-pull-left-1110d-any-tall-narrow-11 item-02) 10310) (= (cost-of-pull-left-1110d-any-tall-narrow-11 item-02) 26)
    (= (x-of-pull-right-0011c-any-tall-narrow-11 item-02) 9570) (= (y-of-pull-right-0011c-any-tall-narrow-11 item-02) 9392) (= (cost-of-pull-right-0011c-any-tall-narrow-11 item-02) 278)
    (can-pull-right-0100d-any-tall-narrow-11 item-02) (= (x-of-pull-right-0100d-any-tall-narrow-11 item-02) 9412) (= (y-of-pull-right-0100d-any-tall-narrow-11 item-02) 9668) (= (cost-of-pull-right-0100d-any-tall-narrow-11 item-02) 4)
    (can-push-forward-1011-any-tall-narrow-11 item-02) (= (x-of-push-forward-1011-any-tall-narrow-11 item-02) 11153) (= (y-of-push-forward-1011-any-tall-narrow-11 item-02) 10192) (= (cost-of-push-forward-1011-any-tall-narrow-11 item-02) 11)
    (can-push-forward-1011b-any-tall-narrow-11 item-02) (= (x-of-push-forward-1011b-any-tall-narrow-11 item-02) 10827) (= (y-of-push-forward-1011b-any-tall-narrow-11 item-02) 10136) (= (cost-of-push-forward-1011b-any-tall-narrow-11 item-02) 4)
    (can-push-forward-1111b-any-tall-narrow-11 item-02) (= (x-of-push-forward-1111b-any-tall-narrow-11 item-02) 10408) (= (y-of-push-forward-1111b-any-tall-narrow-11 item-02) 10013) (= (cost-of-push-forward-1111b-any-tall-narrow-11 item-02) 4)
    (can-push-forward-left-1100d-any-tall-narrow-11 item-02) (= (x-of-push-forward-left-1100d-any-tall-narrow-11 item-02) 10173) (= (y-of-push-forward-left-1100d-any-tall-narrow-11 item-02) 10251) (= (cost-of-push-forward-left-1100d-any-tall-narrow-11 item-02) 4)
    (can-push-forward-right-1111-any-tall-narrow-11 item-02) (= (x-of-push-forward-right-1111-any-tall-narrow-11 item-02) 10699) (= (y-of-push-forward-right-1111-any-tall-narrow-11 item-02) 9612) (= (cost-of-push-forward-right-1111-any-tall-narrow-11 item-02) 7)
    (= (x-of-push-left-1000-any-tall-narrow-11 item-02) 9983) (= (y-of-push-left-1000-any-tall-narrow-11 item-02) 10120) (= (cost-of-push-left-1000-any-tall-narrow-11 item-02) 238)
    (can-push-left-1101a-any-tall-narrow-11 item-02) (= (x-of-push-left-1101a-any-tall-narrow-11 item-02) 9827) (= (y-of-push-left-1101a-any-tall-narrow-11 item-02) 10170) (= (cost-of-push-left-1101a-any-tall-narrow-11 item-02) 14)
    (= (x-of-push-right-0001-any-tall-narrow-11 item-02) 9901) (= (y-of-push-right-0001-any-tall-narrow-11 item-02) 9922) (= (cost-of-push-right-0001-any-tall-narrow-11 item-02) 22)
    (= (x-of-push-right-0001a-any-tall-narrow-11 item-02) 10093) (= (y-of-push-right-0001a-any-tall-narrow-11 item-02) 10071) (= (cost-of-push-right-0001a-any-tall-narrow-11 item-02) 187)
    (= (x-of-push-right-0011-any-tall-narrow-11 item-02) 10139) (= (y-of-push-right-0011-any-tall-narrow-11 item-02) 9646) (= (cost-of-push-right-0011-any-tall-narrow-11 item-02) 278)
    (can-push-right-0101d-any-tall-narrow-11 item-02) (= (x-of-push-right-0101d-any-tall-narrow-11 item-02) 9880) (= (y-of-push-right-0101d-any-tall-narrow-11 item-02) 9643) (= (cost-of-push-right-0101d-any-tall-narrow-11 item-02) 18)
    (can-push-right-0111-any-tall-narrow-11 item-02) (= (x-of-push-right-0111-any-tall-narrow-11 item-02) 9831) (= (y-of-push-right-0111-any-tall-narrow-11 item-02) 9660) (= (cost-of-push-right-0111-any-tall-narrow-11 item-02) 38)
    ; item-03 starts at (0.7821, -0.2160, 0.0229) m
    (= (x item-03) 4321) (= (y item-03) 840) (= (z item-03) 0)
    ; What each operator promises for item-03 (features 0.03962 0.1137 0.04573 1).
    ; Not for item-03:
    ; push-right-0010-solid-low-10: keeps its promise in 2 of 31 rehearsals only.
    ; stay-1101-solid-low-10: scatters more than it moves.
    (can-lift-0010-solid-low-10 item-03) (= (x-of-lift-0010-solid-low-10 item-03) 10269) (= (y-of-lift-0010-solid-low-10 item-03) 10234) (= (z-of-lift-0010-solid-low-10 item-03) 12326) (= (cost-of-lift-0010-solid-low-10 item-03) 11)
    (= (x-of-put-down-lift-0010-solid-low-10 item-03) 10005) (= (y-of-put-down-lift-0010-solid-low-10 item-03) 9993) (= (z-of-put-down-lift-0010-solid-low-10 item-03) 7674)
    (can-lift-1001c-solid-low-10 item-03) (= (x-of-lift-1001c-solid-low-10 item-03) 10236) (= (y-of-lift-1001c-solid-low-10 item-03) 9494) (= (z-of-lift-1001c-solid-low-10 item-03) 11998) (= (cost-of-lift-1001c-solid-low-10 item-03) 37)
    (= (x-of-put-down-lift-1001c-solid-low-10 item-03) 9998) (= (y-of-put-down-lift-1001c-solid-low-10 item-03) 9991) (= (z-of-put-down-lift-1001c-solid-low-10 item-03) 8002)
    (can-pull-0000b-solid-low-10 item-03) (= (x-of-pull-0000b-solid-low-10 item-03) 9561) (= (y-of-pull-0000b-solid-low-10 item-03) 9866) (= (cost-of-pull-0000b-solid-low-10 item-03) 14)
    (can-pull-0100-solid-low-10 item-03) (= (x-of-pull-0100-solid-low-10 item-03) 9272) (= (y-of-pull-0100-solid-low-10 item-03) 9963) (= (cost-of-pull-0100-solid-low-10 item-03) 7)
    (can-pull-0100c-solid-low-10 item-03) (= (x-of-pull-0100c-solid-low-10 item-03) 9429) (= (y-of-pull-0100c-solid-low-10 item-03) 10210) (= (cost-of-pull-0100c-solid-low-10 item-03) 11)
    (can-pull-0110c-solid-low-10 item-03) (= (x-of-pull-0110c-solid-low-10 item-03) 9676) (= (y-of-pull-0110c-solid-low-10 item-03) 9933) (= (cost-of-pull-0110c-solid-low-10 item-03) 7)
    (can-pull-left-1110c-solid-low-10 item-03) (= (x-of-pull-left-1110c-solid-low-10 item-03) 9544) (= (y-of-pull-left-1110c-solid-low-10 item-03) 10331) (= (cost-of-pull-left-1110c-solid-low-10 item-03) 4)
    (can-push-forward-0101c-solid-low-10 item-03) (= (x-of-push-forward-0101c-solid-low-10 item-03) 10394) (= (y-of-push-forward-0101c-solid-low-10 item-03) 9791) (= (cost-of-push-forward-0101c-solid-low-10 item-03) 14)
    (can-push-forward-1011-solid-low-10 item-03) (= (x-of-push-forward-1011-solid-low-10 item-03) 10834) (= (y-of-push-forward-1011-solid-low-10 item-03) 10070) (= (cost-of-push-forward-1011-solid-low-10 item-03) 4)
    (can-push-forward-left-1001c-solid-low-10 item-03) (= (x-of-push-forward-left-1001c-solid-low-10 item-03) 10376) (= (y-of-push-forward-left-1001c-solid-low-10 item-03) 10348) (= (cost-of-push-forward-left-1001c-solid-low-10 item-03) 120)
    (can-push-forward-left-1010-solid-low-10 item-03) (= (x-of-push-forward-left-1010-solid-low-10 item-03) 10116) (= (y-of-push-forward-left-1010-solid-low-10 item-03) 10231) (= (cost-of-push-forward-left-1010-solid-low-10 item-03) 11)
    (can-push-forward-left-1100c-solid-low-10 item-03) (= (x-of-push-forward-left-1100c-solid-low-10 item-03) 10155) (= (y-of-push-forward-left-1100c-solid-low-10 item-03) 10284) (= (cost-of-push-forward-left-1100c-solid-low-10 item-03) 21)
    (can-push-forward-right-0111c-solid-low-10 item-03) (= (x-of-push-forward-right-0111c-solid-low-10 item-03) 10310) (= (y-of-push-forward-right-0111c-solid-low-10 item-03) 9827) (= (cost-of-push-forward-right-0111c-solid-low-10 item-03) 33)
    (can-push-forward-right-1111-solid-low-10 item-03) (= (x-of-push-forward-right-1111-solid-low-10 item-03) 10408) (= (y-of-push-forward-right-1111-solid-low-10 item-03) 9866) (= (cost-of-push-forward-right-1111-solid-low-10 item-03) 7)
    (can-push-left-1000-solid-low-10 item-03) (= (x-of-push-left-1000-solid-low-10 item-03) 9952) (= (y-of-push-left-1000-solid-low-10 item-03) 10217) (= (cost-of-push-left-1000-solid-low-10 item-03) 17)
    (can-push-right-0001b-solid-low-10 item-03) (= (x-of-push-right-0001b-solid-low-10 item-03) 9870) (= (y-of-push-right-0001b-solid-low-10 item-03) 9536) (= (cost-of-push-right-0001b-solid-low-10 item-03) 11)
    (= (x-of-push-right-0010-solid-low-10 item-03) 10084) (= (y-of-push-right-0010-solid-low-10 item-03) 9804) (= (cost-of-push-right-0010-solid-low-10 item-03) 241)
    (can-push-right-0011-solid-low-10 item-03) (= (x-of-push-right-0011-solid-low-10 item-03) 10114) (= (y-of-push-right-0011-solid-low-10 item-03) 9627) (= (cost-of-push-right-0011-solid-low-10 item-03) 56)
    (= (x-of-stay-1101-solid-low-10 item-03) 10000) (= (y-of-stay-1101-solid-low-10 item-03) 9932) (= (cost-of-stay-1101-solid-low-10 item-03) 11))
  (:goal (and
    ; item-01 shall come to (0.5765, 0.0324, 0.0123) m, 171 mm from where it starts
    (<= (x item-01) 2720) (>= (x item-01) 1811)
    (<= (+ (x item-01) (y item-01)) 6234) (>= (+ (x item-01) (y item-01)) 4947)
    (<= (y item-01) 3780) (>= (y item-01) 2870)
    (<= (y item-01) (+ (x item-01) 1703)) (<= (+ (x item-01) 416) (y item-01))
    (>= (z item-01) 0) (<= (z item-01) 0)
    ; item-02 shall come to (0.7821, -0.2160, 0.0142) m, 323 mm from where it starts
    (<= (x item-02) 4776) (>= (x item-02) 3866)
    (<= (+ (x item-02) (y item-02)) 5804) (>= (+ (x item-02) (y item-02)) 4517)
    (<= (y item-02) 1294) (>= (y item-02) 384)
    (<= (+ (y item-02) 2838) (x item-02)) (<= (x item-02) (+ (y item-02) 4125))
    (>= (z item-02) 0) (<= (z item-02) 0)
    ; item-03 shall come to (0.6303, -0.1300, 0.0229) m, 175 mm from where it starts
    (<= (x item-03) 3257) (>= (x item-03) 2348)
    (<= (+ (x item-03) (y item-03)) 5146) (>= (+ (x item-03) (y item-03)) 3859)
    (<= (y item-03) 2155) (>= (y item-03) 1245)
    (<= (+ (y item-03) 459) (x item-03)) (<= (x item-03) (+ (y item-03) 1746))
    (>= (z item-03) 0) (<= (z item-03) 0)))
  (:metric minimize (total-cost)))
