; Problem anywhere-8-19 of the learned domain places, for its encoding numeric.
; How it came about: anywhere, drawn with seed 20; draw 1.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem anywhere-8-19)
  (:domain places-numeric)
  (:objects
    item-01 - any-tall-narrow-11
    item-02 - solid-low-10
    item-03 - hollow-wide-00
    item-04 - solid-low-10
    item-05 - solid-low-narrow-01
    item-06 - solid-low-10
    item-07 - solid-low-narrow-01
    item-08 - any-tall-narrow-11)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.5936, 0.2409, 0.0180) m
    (= (x item-01) 2436) (= (y item-01) 5409) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.049 0.08653 0.03604 0).
    ; Not for item-01:
    ; lift-0001-any-tall-narrow-11: keeps its promise in 2 of 30 rehearsals only.
    ; lift-1101a-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    ; pull-0110d-any-tall-narrow-11: scatters more than it moves.
    ; push-left-1000-any-tall-narrow-11: scatters more than it moves.
    ; push-left-1101a-any-tall-narrow-11: scatters more than it moves.
    ; push-right-0001-any-tall-narrow-11: scatters more than it moves.
    ; push-right-0001a-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    ; push-right-0011-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    ; push-right-0101d-any-tall-narrow-11: scatters more than it moves.
    (can-lift-0000c-any-tall-narrow-11 item-01) (= (x-of-lift-0000c-any-tall-narrow-11 item-01) 9444) (= (y-of-lift-0000c-any-tall-narrow-11 item-01) 10476) (= (z-of-lift-0000c-any-tall-narrow-11 item-01) 12000) (= (cost-of-lift-0000c-any-tall-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-0000c-any-tall-narrow-11 item-01) 10001) (= (y-of-put-down-lift-0000c-any-tall-narrow-11 item-01) 9991) (= (z-of-put-down-lift-0000c-any-tall-narrow-11 item-01) 8000)
    (= (x-of-lift-0001-any-tall-narrow-11 item-01) 9705) (= (y-of-lift-0001-any-tall-narrow-11 item-01) 9544) (= (z-of-lift-0001-any-tall-narrow-11 item-01) 12429) (= (cost-of-lift-0001-any-tall-narrow-11 item-01) 238)
    (= (x-of-put-down-lift-0001-any-tall-narrow-11 item-01) 9975) (= (y-of-put-down-lift-0001-any-tall-narrow-11 item-01) 9986) (= (z-of-put-down-lift-0001-any-tall-narrow-11 item-01) 7571)
    (can-lift-0001a-any-tall-narrow-11 item-01) (= (x-of-lift-0001a-any-tall-narrow-11 item-01) 9785) (= (y-of-lift-0001a-any-tall-narrow-11 item-01) 9811) (= (z-of-lift-0001a-any-tall-narrow-11 item-01) 11994) (= (cost-of-lift-0001a-any-tall-narrow-11 item-01) 7)
    (= (x-of-put-down-lift-0001a-any-tall-narrow-11 item-01) 9997) (= (y-of-put-down-lift-0001a-any-tall-narrow-11 item-01) 9988) (= (z-of-put-down-lift-0001a-any-tall-narrow-11 item-01) 8006)
    (can-lift-0010b-any-tall-narrow-11 item-01) (= (x-of-lift-0010b-any-tall-narrow-11 item-01) 10331) (= (y-of-lift-0010b-any-tall-narrow-11 item-01) 10234) (= (z-of-lift-0010b-any-tall-narrow-11 item-01) 12366) (= (cost-of-lift-0010b-any-tall-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-0010b-any-tall-narrow-11 item-01) 10004) (= (y-of-put-down-lift-0010b-any-tall-narrow-11 item-01) 9993) (= (z-of-put-down-lift-0010b-any-tall-narrow-11 item-01) 7634)
    (can-lift-0011-any-tall-narrow-11 item-01) (= (x-of-lift-0011-any-tall-narrow-11 item-01) 10387) (= (y-of-lift-0011-any-tall-narrow-11 item-01) 9445) (= (z-of-lift-0011-any-tall-narrow-11 item-01) 12005) (= (cost-of-lift-0011-any-tall-narrow-11 item-01) 7)
    (= (x-of-put-down-lift-0011-any-tall-narrow-11 item-01) 9993) (= (y-of-put-down-lift-0011-any-tall-narrow-11 item-01) 9990) (= (z-of-put-down-lift-0011-any-tall-narrow-11 item-01) 7995)
    (can-lift-0011c-any-tall-narrow-11 item-01) (= (x-of-lift-0011c-any-tall-narrow-11 item-01) 9823) (= (y-of-lift-0011c-any-tall-narrow-11 item-01) 9681) (= (z-of-lift-0011c-any-tall-narrow-11 item-01) 12551) (= (cost-of-lift-0011c-any-tall-narrow-11 item-01) 117)
    (= (x-of-put-down-lift-0011c-any-tall-narrow-11 item-01) 9998) (= (y-of-put-down-lift-0011c-any-tall-narrow-11 item-01) 9983) (= (z-of-put-down-lift-0011c-any-tall-narrow-11 item-01) 7449)
    (can-lift-1000-any-tall-narrow-11 item-01) (= (x-of-lift-1000-any-tall-narrow-11 item-01) 9630) (= (y-of-lift-1000-any-tall-narrow-11 item-01) 10400) (= (z-of-lift-1000-any-tall-narrow-11 item-01) 12084) (= (cost-of-lift-1000-any-tall-narrow-11 item-01) 22)
    (= (x-of-put-down-lift-1000-any-tall-narrow-11 item-01) 9999) (= (y-of-put-down-lift-1000-any-tall-narrow-11 item-01) 9991) (= (z-of-put-down-lift-1000-any-tall-narrow-11 item-01) 7916)
    (can-lift-1001d-any-tall-narrow-11 item-01) (= (x-of-lift-1001d-any-tall-narrow-11 item-01) 10620) (= (y-of-lift-1001d-any-tall-narrow-11 item-01) 9546) (= (z-of-lift-1001d-any-tall-narrow-11 item-01) 12019) (= (cost-of-lift-1001d-any-tall-narrow-11 item-01) 7)
    (= (x-of-put-down-lift-1001d-any-tall-narrow-11 item-01) 10001) (= (y-of-put-down-lift-1001d-any-tall-narrow-11 item-01) 9982) (= (z-of-put-down-lift-1001d-any-tall-narrow-11 item-01) 7981)
    (can-lift-1010b-any-tall-narrow-11 item-01) (= (x-of-lift-1010b-any-tall-narrow-11 item-01) 10277) (= (y-of-lift-1010b-any-tall-narrow-11 item-01) 10227) (= (z-of-lift-1010b-any-tall-narrow-11 item-01) 12002) (= (cost-of-lift-1010b-any-tall-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-1010b-any-tall-narrow-11 item-01) 10002) (= (y-of-put-down-lift-1010b-any-tall-narrow-11 item-01) 9992) (= (z-of-put-down-lift-1010b-any-tall-narrow-11 item-01) 7998)
    (= (x-of-lift-1101a-any-tall-narrow-11 item-01) 10284) (= (y-of-lift-1101a-any-tall-narrow-11 item-01) 10264) (= (z-of-lift-1101a-any-tall-narrow-11 item-01) 12038) (= (cost-of-lift-1101a-any-tall-narrow-11 item-01) 278)
    (= (x-of-put-down-lift-1101a-any-tall-narrow-11 item-01) 10041) (= (y-of-put-down-lift-1101a-any-tall-narrow-11 item-01) 10028) (= (z-of-put-down-lift-1101a-any-tall-narrow-11 item-01) 7962)
    (can-place-forward-right-0111d-any-tall-narrow-11 item-01) (= (x-of-place-forward-right-0111d-any-tall-narrow-11 item-01) 10315) (= (y-of-place-forward-right-0111d-any-tall-narrow-11 item-01) 9557) (= (cost-of-place-forward-right-0111d-any-tall-narrow-11 item-01) 4)
    (can-pull-0100-any-tall-narrow-11 item-01) (= (x-of-pull-0100-any-tall-narrow-11 item-01) 9181) (= (y-of-pull-0100-any-tall-narrow-11 item-01) 9882) (= (cost-of-pull-0100-any-tall-narrow-11 item-01) 4)
    (= (x-of-pull-0110d-any-tall-narrow-11 item-01) 9929) (= (y-of-pull-0110d-any-tall-narrow-11 item-01) 9998) (= (cost-of-pull-0110d-any-tall-narrow-11 item-01) 4)
    (can-pull-left-1110d-any-tall-narrow-11 item-01) (= (x-of-pull-left-1110d-any-tall-narrow-11 item-01) 9369) (= (y-of-pull-left-1110d-any-tall-narrow-11 item-01) 10316) (= (cost-of-pull-left-1110d-any-tall-narrow-11 item-01) 84)
    (can-pull-right-0011c-any-tall-narrow-11 item-01) (= (x-of-pull-right-0011c-any-tall-narrow-11 item-01) 9654) (= (y-of-pull-right-0011c-any-tall-narrow-11 item-01) 9394) (= (cost-of-pull-right-0011c-any-tall-narrow-11 item-01) 38)
    (can-pull-right-0100d-any-tall-narrow-11 item-01) (= (x-of-pull-right-0100d-any-tall-narrow-11 item-01) 9459) (= (y-of-pull-right-0100d-any-tall-narrow-11 item-01) 9663) (= (cost-of-pull-right-0100d-any-tall-narrow-11 item-01) 4)
    (can-push-forward-1011-any-tall-narrow-11 item-01) (= (x-of-push-forward-1011-any-tall-narrow-11 item-01) 10908) (= (y-of-push-forward-1011-any-tall-narrow-11 item-01) 10149) (= (cost-of-push-forward-1011-any-tall-narrow-11 item-01) 11)
    (can-push-forward-1011b-any-tall-narrow-11 item-01) (= (x-of-push-forward-1011b-any-tall-narrow-11 item-01) 10851) (= (y-of-push-forward-1011b-any-tall-narrow-11 item-01) 10161) (= (cost-of-push-forward-1011b-any-tall-narrow-11 item-01) 4)
    (can-push-forward-1111b-any-tall-narrow-11 item-01) (= (x-of-push-forward-1111b-any-tall-narrow-11 item-01) 10402) (= (y-of-push-forward-1111b-any-tall-narrow-11 item-01) 10009) (= (cost-of-push-forward-1111b-any-tall-narrow-11 item-01) 4)
    (can-push-forward-left-1100d-any-tall-narrow-11 item-01) (= (x-of-push-forward-left-1100d-any-tall-narrow-11 item-01) 10140) (= (y-of-push-forward-left-1100d-any-tall-narrow-11 item-01) 10259) (= (cost-of-push-forward-left-1100d-any-tall-narrow-11 item-01) 4)
    (can-push-forward-right-1111-any-tall-narrow-11 item-01) (= (x-of-push-forward-right-1111-any-tall-narrow-11 item-01) 10657) (= (y-of-push-forward-right-1111-any-tall-narrow-11 item-01) 9913) (= (cost-of-push-forward-right-1111-any-tall-narrow-11 item-01) 38)
    (= (x-of-push-left-1000-any-tall-narrow-11 item-01) 9983) (= (y-of-push-left-1000-any-tall-narrow-11 item-01) 10110) (= (cost-of-push-left-1000-any-tall-narrow-11 item-01) 168)
    (= (x-of-push-left-1101a-any-tall-narrow-11 item-01) 9952) (= (y-of-push-left-1101a-any-tall-narrow-11 item-01) 10066) (= (cost-of-push-left-1101a-any-tall-narrow-11 item-01) 7)
    (= (x-of-push-right-0001-any-tall-narrow-11 item-01) 9885) (= (y-of-push-right-0001-any-tall-narrow-11 item-01) 9890) (= (cost-of-push-right-0001-any-tall-narrow-11 item-01) 70)
    (= (x-of-push-right-0001a-any-tall-narrow-11 item-01) 9867) (= (y-of-push-right-0001a-any-tall-narrow-11 item-01) 10048) (= (cost-of-push-right-0001a-any-tall-narrow-11 item-01) 278)
    (= (x-of-push-right-0011-any-tall-narrow-11 item-01) 10068) (= (y-of-push-right-0011-any-tall-narrow-11 item-01) 9732) (= (cost-of-push-right-0011-any-tall-narrow-11 item-01) 278)
    (= (x-of-push-right-0101d-any-tall-narrow-11 item-01) 9981) (= (y-of-push-right-0101d-any-tall-narrow-11 item-01) 9862) (= (cost-of-push-right-0101d-any-tall-narrow-11 item-01) 11)
    (can-push-right-0111-any-tall-narrow-11 item-01) (= (x-of-push-right-0111-any-tall-narrow-11 item-01) 9798) (= (y-of-push-right-0111-any-tall-narrow-11 item-01) 9629) (= (cost-of-push-right-0111-any-tall-narrow-11 item-01) 7)
    ; item-02 starts at (0.4878, 0.1407, 0.0140) m
    (= (x item-02) 1378) (= (y item-02) 4407) (= (z item-02) 0)
    ; What each operator promises for item-02 (features 0.03701 0.1548 0.02803 0).
    ; Not for item-02:
    ; lift-0010-solid-low-10: keeps its promise in 1 of 31 rehearsals only.
    ; lift-1001c-solid-low-10: keeps its promise in 1 of 31 rehearsals only.
    ; push-right-0010-solid-low-10: scatters more than it moves.
    (= (x-of-lift-0010-solid-low-10 item-02) 10272) (= (y-of-lift-0010-solid-low-10 item-02) 10237) (= (z-of-lift-0010-solid-low-10 item-02) 12324) (= (cost-of-lift-0010-solid-low-10 item-02) 281)
    (= (x-of-put-down-lift-0010-solid-low-10 item-02) 10005) (= (y-of-put-down-lift-0010-solid-low-10 item-02) 9994) (= (z-of-put-down-lift-0010-solid-low-10 item-02) 7676)
    (= (x-of-lift-1001c-solid-low-10 item-02) 10298) (= (y-of-lift-1001c-solid-low-10 item-02) 9500) (= (z-of-lift-1001c-solid-low-10 item-02) 12013) (= (cost-of-lift-1001c-solid-low-10 item-02) 281)
    (= (x-of-put-down-lift-1001c-solid-low-10 item-02) 9994) (= (y-of-put-down-lift-1001c-solid-low-10 item-02) 9990) (= (z-of-put-down-lift-1001c-solid-low-10 item-02) 7987)
    (can-pull-0000b-solid-low-10 item-02) (= (x-of-pull-0000b-solid-low-10 item-02) 9462) (= (y-of-pull-0000b-solid-low-10 item-02) 9912) (= (cost-of-pull-0000b-solid-low-10 item-02) 14)
    (can-pull-0100-solid-low-10 item-02) (= (x-of-pull-0100-solid-low-10 item-02) 9198) (= (y-of-pull-0100-solid-low-10 item-02) 9929) (= (cost-of-pull-0100-solid-low-10 item-02) 7)
    (can-pull-0100c-solid-low-10 item-02) (= (x-of-pull-0100c-solid-low-10 item-02) 9239) (= (y-of-pull-0100c-solid-low-10 item-02) 10370) (= (cost-of-pull-0100c-solid-low-10 item-02) 11)
    (can-pull-0110c-solid-low-10 item-02) (= (x-of-pull-0110c-solid-low-10 item-02) 9848) (= (y-of-pull-0110c-solid-low-10 item-02) 10015) (= (cost-of-pull-0110c-solid-low-10 item-02) 4)
    (can-pull-left-1110c-solid-low-10 item-02) (= (x-of-pull-left-1110c-solid-low-10 item-02) 9604) (= (y-of-pull-left-1110c-solid-low-10 item-02) 10250) (= (cost-of-pull-left-1110c-solid-low-10 item-02) 4)
    (can-push-forward-0101c-solid-low-10 item-02) (= (x-of-push-forward-0101c-solid-low-10 item-02) 10252) (= (y-of-push-forward-0101c-solid-low-10 item-02) 10092) (= (cost-of-push-forward-0101c-solid-low-10 item-02) 14)
    (can-push-forward-1011-solid-low-10 item-02) (= (x-of-push-forward-1011-solid-low-10 item-02) 10841) (= (y-of-push-forward-1011-solid-low-10 item-02) 10103) (= (cost-of-push-forward-1011-solid-low-10 item-02) 4)
    (can-push-forward-left-1001c-solid-low-10 item-02) (= (x-of-push-forward-left-1001c-solid-low-10 item-02) 10704) (= (y-of-push-forward-left-1001c-solid-low-10 item-02) 10485) (= (cost-of-push-forward-left-1001c-solid-low-10 item-02) 25)
    (can-push-forward-left-1010-solid-low-10 item-02) (= (x-of-push-forward-left-1010-solid-low-10 item-02) 10272) (= (y-of-push-forward-left-1010-solid-low-10 item-02) 10353) (= (cost-of-push-forward-left-1010-solid-low-10 item-02) 7)
    (can-push-forward-left-1100c-solid-low-10 item-02) (= (x-of-push-forward-left-1100c-solid-low-10 item-02) 10193) (= (y-of-push-forward-left-1100c-solid-low-10 item-02) 10248) (= (cost-of-push-forward-left-1100c-solid-low-10 item-02) 4)
    (can-push-forward-right-0111c-solid-low-10 item-02) (= (x-of-push-forward-right-0111c-solid-low-10 item-02) 10670) (= (y-of-push-forward-right-0111c-solid-low-10 item-02) 9168) (= (cost-of-push-forward-right-0111c-solid-low-10 item-02) 17)
    (can-push-forward-right-1111-solid-low-10 item-02) (= (x-of-push-forward-right-1111-solid-low-10 item-02) 10328) (= (y-of-push-forward-right-1111-solid-low-10 item-02) 9663) (= (cost-of-push-forward-right-1111-solid-low-10 item-02) 7)
    (can-push-left-1000-solid-low-10 item-02) (= (x-of-push-left-1000-solid-low-10 item-02) 9856) (= (y-of-push-left-1000-solid-low-10 item-02) 10392) (= (cost-of-push-left-1000-solid-low-10 item-02) 7)
    (can-push-right-0001b-solid-low-10 item-02) (= (x-of-push-right-0001b-solid-low-10 item-02) 9759) (= (y-of-push-right-0001b-solid-low-10 item-02) 9466) (= (cost-of-push-right-0001b-solid-low-10 item-02) 11)
    (= (x-of-push-right-0010-solid-low-10 item-02) 10085) (= (y-of-push-right-0010-solid-low-10 item-02) 9822) (= (cost-of-push-right-0010-solid-low-10 item-02) 7)
    (can-push-right-0011-solid-low-10 item-02) (= (x-of-push-right-0011-solid-low-10 item-02) 10135) (= (y-of-push-right-0011-solid-low-10 item-02) 9618) (= (cost-of-push-right-0011-solid-low-10 item-02) 37)
    (can-stay-1101-solid-low-10 item-02) (= (x-of-stay-1101-solid-low-10 item-02) 10001) (= (y-of-stay-1101-solid-low-10 item-02) 9672) (= (cost-of-stay-1101-solid-low-10 item-02) 11)
    ; item-03 starts at (0.7654, -0.1680, 0.0105) m
    (= (x item-03) 4154) (= (y item-03) 1320) (= (z item-03) 0)
    ; What each operator promises for item-03 (features 0.1589 0.1589 0.02104 2).
    ; Not for item-03:
    ; lift-1101-hollow-wide-00: keeps its promise in 0 of 30 rehearsals only.
    ; place-back-right-0000-hollow-wide-00: keeps its promise with such objects in about 6 of 30 only.
    ; push-right-0010a-hollow-wide-00: keeps its promise with such objects in about 4 of 30 only.
    ; push-right-1101-hollow-wide-00: scatters more than it moves.
    (can-lift-0000-hollow-wide-00 item-03) (= (x-of-lift-0000-hollow-wide-00 item-03) 9416) (= (y-of-lift-0000-hollow-wide-00 item-03) 9219) (= (z-of-lift-0000-hollow-wide-00 item-03) 12017) (= (cost-of-lift-0000-hollow-wide-00 item-03) 84)
    (= (x-of-put-down-lift-0000-hollow-wide-00 item-03) 9975) (= (y-of-put-down-lift-0000-hollow-wide-00 item-03) 9969) (= (z-of-put-down-lift-0000-hollow-wide-00 item-03) 7983)
    (can-lift-0001-hollow-wide-00 item-03) (= (x-of-lift-0001-hollow-wide-00 item-03) 9649) (= (y-of-lift-0001-hollow-wide-00 item-03) 9010) (= (z-of-lift-0001-hollow-wide-00 item-03) 12294) (= (cost-of-lift-0001-hollow-wide-00 item-03) 4)
    (= (x-of-put-down-lift-0001-hollow-wide-00 item-03) 10000) (= (y-of-put-down-lift-0001-hollow-wide-00 item-03) 9957) (= (z-of-put-down-lift-0001-hollow-wide-00 item-03) 7706)
    (can-lift-0010a-hollow-wide-00 item-03) (= (x-of-lift-0010a-hollow-wide-00 item-03) 10038) (= (y-of-lift-0010a-hollow-wide-00 item-03) 9642) (= (z-of-lift-0010a-hollow-wide-00 item-03) 11862) (= (cost-of-lift-0010a-hollow-wide-00 item-03) 18)
    (= (x-of-put-down-lift-0010a-hollow-wide-00 item-03) 9997) (= (y-of-put-down-lift-0010a-hollow-wide-00 item-03) 9971) (= (z-of-put-down-lift-0010a-hollow-wide-00 item-03) 8138)
    (can-lift-0011-hollow-wide-00 item-03) (= (x-of-lift-0011-hollow-wide-00 item-03) 10296) (= (y-of-lift-0011-hollow-wide-00 item-03) 8734) (= (z-of-lift-0011-hollow-wide-00 item-03) 11891) (= (cost-of-lift-0011-hollow-wide-00 item-03) 53)
    (= (x-of-put-down-lift-0011-hollow-wide-00 item-03) 10001) (= (y-of-put-down-lift-0011-hollow-wide-00 item-03) 9968) (= (z-of-put-down-lift-0011-hollow-wide-00 item-03) 8109)
    (can-lift-0011a-hollow-wide-00 item-03) (= (x-of-lift-0011a-hollow-wide-00 item-03) 10468) (= (y-of-lift-0011a-hollow-wide-00 item-03) 9168) (= (z-of-lift-0011a-hollow-wide-00 item-03) 12235) (= (cost-of-lift-0011a-hollow-wide-00 item-03) 4)
    (= (x-of-put-down-lift-0011a-hollow-wide-00 item-03) 10004) (= (y-of-put-down-lift-0011a-hollow-wide-00 item-03) 9964) (= (z-of-put-down-lift-0011a-hollow-wide-00 item-03) 7765)
    (can-lift-1000-hollow-wide-00 item-03) (= (x-of-lift-1000-hollow-wide-00 item-03) 9690) (= (y-of-lift-1000-hollow-wide-00 item-03) 11134) (= (z-of-lift-1000-hollow-wide-00 item-03) 11920) (= (cost-of-lift-1000-hollow-wide-00 item-03) 4)
    (= (x-of-put-down-lift-1000-hollow-wide-00 item-03) 9999) (= (y-of-put-down-lift-1000-hollow-wide-00 item-03) 9980) (= (z-of-put-down-lift-1000-hollow-wide-00 item-03) 8080)
    (can-lift-1000a-hollow-wide-00 item-03) (= (x-of-lift-1000a-hollow-wide-00 item-03) 9585) (= (y-of-lift-1000a-hollow-wide-00 item-03) 10482) (= (z-of-lift-1000a-hollow-wide-00 item-03) 12278) (= (cost-of-lift-1000a-hollow-wide-00 item-03) 4)
    (= (x-of-put-down-lift-1000a-hollow-wide-00 item-03) 9995) (= (y-of-put-down-lift-1000a-hollow-wide-00 item-03) 9959) (= (z-of-put-down-lift-1000a-hollow-wide-00 item-03) 7722)
    (can-lift-1001a-hollow-wide-00 item-03) (= (x-of-lift-1001a-hollow-wide-00 item-03) 10177) (= (y-of-lift-1001a-hollow-wide-00 item-03) 10335) (= (z-of-lift-1001a-hollow-wide-00 item-03) 12039) (= (cost-of-lift-1001a-hollow-wide-00 item-03) 4)
    (= (x-of-put-down-lift-1001a-hollow-wide-00 item-03) 10003) (= (y-of-put-down-lift-1001a-hollow-wide-00 item-03) 9971) (= (z-of-put-down-lift-1001a-hollow-wide-00 item-03) 7961)
    (can-lift-1010a-hollow-wide-00 item-03) (= (x-of-lift-1010a-hollow-wide-00 item-03) 10270) (= (y-of-lift-1010a-hollow-wide-00 item-03) 11058) (= (z-of-lift-1010a-hollow-wide-00 item-03) 11930) (= (cost-of-lift-1010a-hollow-wide-00 item-03) 4)
    (= (x-of-put-down-lift-1010a-hollow-wide-00 item-03) 10002) (= (y-of-put-down-lift-1010a-hollow-wide-00 item-03) 9979) (= (z-of-put-down-lift-1010a-hollow-wide-00 item-03) 8070)
    (= (x-of-lift-1101-hollow-wide-00 item-03) 10271) (= (y-of-lift-1101-hollow-wide-00 item-03) 10147) (= (z-of-lift-1101-hollow-wide-00 item-03) 11998) (= (cost-of-lift-1101-hollow-wide-00 item-03) 348)
    (= (x-of-put-down-lift-1101-hollow-wide-00 item-03) 9997) (= (y-of-put-down-lift-1101-hollow-wide-00 item-03) 10008) (= (z-of-put-down-lift-1101-hollow-wide-00 item-03) 8002)
    (= (x-of-place-back-right-0000-hollow-wide-00 item-03) 9273) (= (y-of-place-back-right-0000-hollow-wide-00 item-03) 9530) (= (cost-of-place-back-right-0000-hollow-wide-00 item-03) 153)
    (can-place-right-0111-hollow-wide-00 item-03) (= (x-of-place-right-0111-hollow-wide-00 item-03) 9600) (= (y-of-place-right-0111-hollow-wide-00 item-03) 8885) (= (cost-of-place-right-0111-hollow-wide-00 item-03) 7)
    (can-place-right-0111a-hollow-wide-00 item-03) (= (x-of-place-right-0111a-hollow-wide-00 item-03) 10210) (= (y-of-place-right-0111a-hollow-wide-00 item-03) 8951) (= (cost-of-place-right-0111a-hollow-wide-00 item-03) 4)
    (can-pull-0100-hollow-wide-00 item-03) (= (x-of-pull-0100-hollow-wide-00 item-03) 9656) (= (y-of-pull-0100-hollow-wide-00 item-03) 9958) (= (cost-of-pull-0100-hollow-wide-00 item-03) 11)
    (can-pull-left-0110a-hollow-wide-00 item-03) (= (x-of-pull-left-0110a-hollow-wide-00 item-03) 9813) (= (y-of-pull-left-0110a-hollow-wide-00 item-03) 10162) (= (cost-of-pull-left-0110a-hollow-wide-00 item-03) 4)
    (can-pull-right-0100a-hollow-wide-00 item-03) (= (x-of-pull-right-0100a-hollow-wide-00 item-03) 9690) (= (y-of-pull-right-0100a-hollow-wide-00 item-03) 9693) (= (cost-of-pull-right-0100a-hollow-wide-00 item-03) 4)
    (can-pull-right-0110-hollow-wide-00 item-03) (= (x-of-pull-right-0110-hollow-wide-00 item-03) 9463) (= (y-of-pull-right-0110-hollow-wide-00 item-03) 9952) (= (cost-of-pull-right-0110-hollow-wide-00 item-03) 4)
    (can-push-forward-1011a-hollow-wide-00 item-03) (= (x-of-push-forward-1011a-hollow-wide-00 item-03) 10813) (= (y-of-push-forward-1011a-hollow-wide-00 item-03) 10013) (= (cost-of-push-forward-1011a-hollow-wide-00 item-03) 11)
    (can-push-forward-1110a-hollow-wide-00 item-03) (= (x-of-push-forward-1110a-hollow-wide-00 item-03) 10316) (= (y-of-push-forward-1110a-hollow-wide-00 item-03) 9906) (= (cost-of-push-forward-1110a-hollow-wide-00 item-03) 4)
    (can-push-forward-left-1111a-hollow-wide-00 item-03) (= (x-of-push-forward-left-1111a-hollow-wide-00 item-03) 10277) (= (y-of-push-forward-left-1111a-hollow-wide-00 item-03) 10474) (= (cost-of-push-forward-left-1111a-hollow-wide-00 item-03) 4)
    (can-push-forward-right-0101a-hollow-wide-00 item-03) (= (x-of-push-forward-right-0101a-hollow-wide-00 item-03) 10443) (= (y-of-push-forward-right-0101a-hollow-wide-00 item-03) 9504) (= (cost-of-push-forward-right-0101a-hollow-wide-00 item-03) 4)
    (can-push-left-1100a-hollow-wide-00 item-03) (= (x-of-push-left-1100a-hollow-wide-00 item-03) 9669) (= (y-of-push-left-1100a-hollow-wide-00 item-03) 10892) (= (cost-of-push-left-1100a-hollow-wide-00 item-03) 7)
    (= (x-of-push-right-0010a-hollow-wide-00 item-03) 9929) (= (y-of-push-right-0010a-hollow-wide-00 item-03) 9642) (= (cost-of-push-right-0010a-hollow-wide-00 item-03) 187)
    (can-push-right-0011-hollow-wide-00 item-03) (= (x-of-push-right-0011-hollow-wide-00 item-03) 10036) (= (y-of-push-right-0011-hollow-wide-00 item-03) 9565) (= (cost-of-push-right-0011-hollow-wide-00 item-03) 91)
    (= (x-of-push-right-1101-hollow-wide-00 item-03) 10005) (= (y-of-push-right-1101-hollow-wide-00 item-03) 9892) (= (cost-of-push-right-1101-hollow-wide-00 item-03) 4)
    ; item-04 starts at (0.4858, -0.1436, 0.0390) m
    (= (x item-04) 1358) (= (y item-04) 1564) (= (z item-04) 0)
    ; What each operator promises for item-04 (features 0.06077 0.1566 0.07798 0).
    ; Not for item-04:
    ; lift-0010-solid-low-10: keeps its promise in 1 of 31 rehearsals only.
    ; lift-1001c-solid-low-10: keeps its promise in 1 of 31 rehearsals only.
    ; push-forward-left-1010-solid-low-10: scatters more than it moves.
    ; push-forward-right-0111c-solid-low-10: scatters more than it moves.
    ; push-left-1000-solid-low-10: moves less than half a cell.
    ; push-right-0010-solid-low-10: scatters more than it moves.
    ; push-right-0011-solid-low-10: scatters more than it moves.
    ; stay-1101-solid-low-10: moves less than half a cell.
    (= (x-of-lift-0010-solid-low-10 item-04) 10272) (= (y-of-lift-0010-solid-low-10 item-04) 10237) (= (z-of-lift-0010-solid-low-10 item-04) 12341) (= (cost-of-lift-0010-solid-low-10 item-04) 281)
    (= (x-of-put-down-lift-0010-solid-low-10 item-04) 10001) (= (y-of-put-down-lift-0010-solid-low-10 item-04) 9993) (= (z-of-put-down-lift-0010-solid-low-10 item-04) 7659)
    (= (x-of-lift-1001c-solid-low-10 item-04) 10274) (= (y-of-lift-1001c-solid-low-10 item-04) 9498) (= (z-of-lift-1001c-solid-low-10 item-04) 12001) (= (cost-of-lift-1001c-solid-low-10 item-04) 281)
    (= (x-of-put-down-lift-1001c-solid-low-10 item-04) 10002) (= (y-of-put-down-lift-1001c-solid-low-10 item-04) 9990) (= (z-of-put-down-lift-1001c-solid-low-10 item-04) 7999)
    (can-pull-0000b-solid-low-10 item-04) (= (x-of-pull-0000b-solid-low-10 item-04) 9479) (= (y-of-pull-0000b-solid-low-10 item-04) 9895) (= (cost-of-pull-0000b-solid-low-10 item-04) 14)
    (can-pull-0100-solid-low-10 item-04) (= (x-of-pull-0100-solid-low-10 item-04) 9209) (= (y-of-pull-0100-solid-low-10 item-04) 10004) (= (cost-of-pull-0100-solid-low-10 item-04) 7)
    (can-pull-0100c-solid-low-10 item-04) (= (x-of-pull-0100c-solid-low-10 item-04) 9400) (= (y-of-pull-0100c-solid-low-10 item-04) 10284) (= (cost-of-pull-0100c-solid-low-10 item-04) 11)
    (can-pull-0110c-solid-low-10 item-04) (= (x-of-pull-0110c-solid-low-10 item-04) 9759) (= (y-of-pull-0110c-solid-low-10 item-04) 9907) (= (cost-of-pull-0110c-solid-low-10 item-04) 11)
    (can-pull-left-1110c-solid-low-10 item-04) (= (x-of-pull-left-1110c-solid-low-10 item-04) 9356) (= (y-of-pull-left-1110c-solid-low-10 item-04) 10505) (= (cost-of-pull-left-1110c-solid-low-10 item-04) 4)
    (can-push-forward-0101c-solid-low-10 item-04) (= (x-of-push-forward-0101c-solid-low-10 item-04) 10503) (= (y-of-push-forward-0101c-solid-low-10 item-04) 9902) (= (cost-of-push-forward-0101c-solid-low-10 item-04) 14)
    (can-push-forward-1011-solid-low-10 item-04) (= (x-of-push-forward-1011-solid-low-10 item-04) 10792) (= (y-of-push-forward-1011-solid-low-10 item-04) 10102) (= (cost-of-push-forward-1011-solid-low-10 item-04) 4)
    (can-push-forward-left-1001c-solid-low-10 item-04) (= (x-of-push-forward-left-1001c-solid-low-10 item-04) 10400) (= (y-of-push-forward-left-1001c-solid-low-10 item-04) 10489) (= (cost-of-push-forward-left-1001c-solid-low-10 item-04) 56)
    (= (x-of-push-forward-left-1010-solid-low-10 item-04) 10032) (= (y-of-push-forward-left-1010-solid-low-10 item-04) 10054) (= (cost-of-push-forward-left-1010-solid-low-10 item-04) 7)
    (can-push-forward-left-1100c-solid-low-10 item-04) (= (x-of-push-forward-left-1100c-solid-low-10 item-04) 10026) (= (y-of-push-forward-left-1100c-solid-low-10 item-04) 9801) (= (cost-of-push-forward-left-1100c-solid-low-10 item-04) 4)
    (= (x-of-push-forward-right-0111c-solid-low-10 item-04) 10040) (= (y-of-push-forward-right-0111c-solid-low-10 item-04) 9898) (= (cost-of-push-forward-right-0111c-solid-low-10 item-04) 102)
    (can-push-forward-right-1111-solid-low-10 item-04) (= (x-of-push-forward-right-1111-solid-low-10 item-04) 10031) (= (y-of-push-forward-right-1111-solid-low-10 item-04) 9646) (= (cost-of-push-forward-right-1111-solid-low-10 item-04) 29)
    (= (x-of-push-left-1000-solid-low-10 item-04) 10005) (= (y-of-push-left-1000-solid-low-10 item-04) 9982) (= (cost-of-push-left-1000-solid-low-10 item-04) 7)
    (can-push-right-0001b-solid-low-10 item-04) (= (x-of-push-right-0001b-solid-low-10 item-04) 9919) (= (y-of-push-right-0001b-solid-low-10 item-04) 9443) (= (cost-of-push-right-0001b-solid-low-10 item-04) 11)
    (= (x-of-push-right-0010-solid-low-10 item-04) 10082) (= (y-of-push-right-0010-solid-low-10 item-04) 9830) (= (cost-of-push-right-0010-solid-low-10 item-04) 7)
    (= (x-of-push-right-0011-solid-low-10 item-04) 10064) (= (y-of-push-right-0011-solid-low-10 item-04) 9677) (= (cost-of-push-right-0011-solid-low-10 item-04) 7)
    (= (x-of-stay-1101-solid-low-10 item-04) 10003) (= (y-of-stay-1101-solid-low-10 item-04) 9978) (= (cost-of-stay-1101-solid-low-10 item-04) 11)
    ; item-05 starts at (0.4693, -0.0135, 0.0395) m
    (= (x item-05) 1193) (= (y item-05) 2865) (= (z item-05) 0)
    ; What each operator promises for item-05 (features 0.113 0.05184 0.07909 1).
    ; Not for item-05:
    ; lift-0110b-solid-low-narrow-01: keeps its promise with such objects in about 4 of 30 only.
    ; place-back-0000-solid-low-narrow-01: keeps its promise with such objects in about 4 of 30 only.
    ; push-right-1001-solid-low-narrow-01: keeps its promise with such objects in about 4 of 30 only.
    (can-lift-0000-solid-low-narrow-01 item-05) (= (x-of-lift-0000-solid-low-narrow-01 item-05) 9132) (= (y-of-lift-0000-solid-low-narrow-01 item-05) 9947) (= (z-of-lift-0000-solid-low-narrow-01 item-05) 12030) (= (cost-of-lift-0000-solid-low-narrow-01 item-05) 34)
    (= (x-of-put-down-lift-0000-solid-low-narrow-01 item-05) 10037) (= (y-of-put-down-lift-0000-solid-low-narrow-01 item-05) 9999) (= (z-of-put-down-lift-0000-solid-low-narrow-01 item-05) 7970)
    (can-lift-0000a-solid-low-narrow-01 item-05) (= (x-of-lift-0000a-solid-low-narrow-01 item-05) 9491) (= (y-of-lift-0000a-solid-low-narrow-01 item-05) 10264) (= (z-of-lift-0000a-solid-low-narrow-01 item-05) 12569) (= (cost-of-lift-0000a-solid-low-narrow-01 item-05) 4)
    (= (x-of-put-down-lift-0000a-solid-low-narrow-01 item-05) 10003) (= (y-of-put-down-lift-0000a-solid-low-narrow-01 item-05) 9988) (= (z-of-put-down-lift-0000a-solid-low-narrow-01 item-05) 7431)
    (can-lift-0001-solid-low-narrow-01 item-05) (= (x-of-lift-0001-solid-low-narrow-01 item-05) 9698) (= (y-of-lift-0001-solid-low-narrow-01 item-05) 9759) (= (z-of-lift-0001-solid-low-narrow-01 item-05) 12450) (= (cost-of-lift-0001-solid-low-narrow-01 item-05) 7)
    (= (x-of-put-down-lift-0001-solid-low-narrow-01 item-05) 10003) (= (y-of-put-down-lift-0001-solid-low-narrow-01 item-05) 9988) (= (z-of-put-down-lift-0001-solid-low-narrow-01 item-05) 7550)
    (can-lift-0001a-solid-low-narrow-01 item-05) (= (x-of-lift-0001a-solid-low-narrow-01 item-05) 9866) (= (y-of-lift-0001a-solid-low-narrow-01 item-05) 9816) (= (z-of-lift-0001a-solid-low-narrow-01 item-05) 11995) (= (cost-of-lift-0001a-solid-low-narrow-01 item-05) 4)
    (= (x-of-put-down-lift-0001a-solid-low-narrow-01 item-05) 10005) (= (y-of-put-down-lift-0001a-solid-low-narrow-01 item-05) 9991) (= (z-of-put-down-lift-0001a-solid-low-narrow-01 item-05) 8005)
    (can-lift-0010-solid-low-narrow-01 item-05) (= (x-of-lift-0010-solid-low-narrow-01 item-05) 10273) (= (y-of-lift-0010-solid-low-narrow-01 item-05) 10227) (= (z-of-lift-0010-solid-low-narrow-01 item-05) 12361) (= (cost-of-lift-0010-solid-low-narrow-01 item-05) 4)
    (= (x-of-put-down-lift-0010-solid-low-narrow-01 item-05) 10004) (= (y-of-put-down-lift-0010-solid-low-narrow-01 item-05) 9988) (= (z-of-put-down-lift-0010-solid-low-narrow-01 item-05) 7639)
    (can-lift-0011b-solid-low-narrow-01 item-05) (= (x-of-lift-0011b-solid-low-narrow-01 item-05) 10404) (= (y-of-lift-0011b-solid-low-narrow-01 item-05) 9563) (= (z-of-lift-0011b-solid-low-narrow-01 item-05) 12403) (= (cost-of-lift-0011b-solid-low-narrow-01 item-05) 4)
    (= (x-of-put-down-lift-0011b-solid-low-narrow-01 item-05) 9996) (= (y-of-put-down-lift-0011b-solid-low-narrow-01 item-05) 9992) (= (z-of-put-down-lift-0011b-solid-low-narrow-01 item-05) 7597)
    (= (x-of-lift-0110b-solid-low-narrow-01 item-05) 10555) (= (y-of-lift-0110b-solid-low-narrow-01 item-05) 9938) (= (z-of-lift-0110b-solid-low-narrow-01 item-05) 12151) (= (cost-of-lift-0110b-solid-low-narrow-01 item-05) 187)
    (= (x-of-put-down-lift-0110b-solid-low-narrow-01 item-05) 9998) (= (y-of-put-down-lift-0110b-solid-low-narrow-01 item-05) 9989) (= (z-of-put-down-lift-0110b-solid-low-narrow-01 item-05) 7849)
    (can-lift-1000-solid-low-narrow-01 item-05) (= (x-of-lift-1000-solid-low-narrow-01 item-05) 9689) (= (y-of-lift-1000-solid-low-narrow-01 item-05) 10442) (= (z-of-lift-1000-solid-low-narrow-01 item-05) 11999) (= (cost-of-lift-1000-solid-low-narrow-01 item-05) 4)
    (= (x-of-put-down-lift-1000-solid-low-narrow-01 item-05) 10001) (= (y-of-put-down-lift-1000-solid-low-narrow-01 item-05) 9995) (= (z-of-put-down-lift-1000-solid-low-narrow-01 item-05) 8001)
    (can-lift-1001-solid-low-narrow-01 item-05) (= (x-of-lift-1001-solid-low-narrow-01 item-05) 9875) (= (y-of-lift-1001-solid-low-narrow-01 item-05) 9520) (= (z-of-lift-1001-solid-low-narrow-01 item-05) 11992) (= (cost-of-lift-1001-solid-low-narrow-01 item-05) 18)
    (= (x-of-put-down-lift-1001-solid-low-narrow-01 item-05) 10004) (= (y-of-put-down-lift-1001-solid-low-narrow-01 item-05) 9991) (= (z-of-put-down-lift-1001-solid-low-narrow-01 item-05) 8008)
    (can-lift-1001b-solid-low-narrow-01 item-05) (= (x-of-lift-1001b-solid-low-narrow-01 item-05) 10389) (= (y-of-lift-1001b-solid-low-narrow-01 item-05) 9503) (= (z-of-lift-1001b-solid-low-narrow-01 item-05) 11999) (= (cost-of-lift-1001b-solid-low-narrow-01 item-05) 4)
    (= (x-of-put-down-lift-1001b-solid-low-narrow-01 item-05) 10000) (= (y-of-put-down-lift-1001b-solid-low-narrow-01 item-05) 9992) (= (z-of-put-down-lift-1001b-solid-low-narrow-01 item-05) 8001)
    (can-lift-1010-solid-low-narrow-01 item-05) (= (x-of-lift-1010-solid-low-narrow-01 item-05) 10263) (= (y-of-lift-1010-solid-low-narrow-01 item-05) 10453) (= (z-of-lift-1010-solid-low-narrow-01 item-05) 11999) (= (cost-of-lift-1010-solid-low-narrow-01 item-05) 4)
    (= (x-of-put-down-lift-1010-solid-low-narrow-01 item-05) 10002) (= (y-of-put-down-lift-1010-solid-low-narrow-01 item-05) 9988) (= (z-of-put-down-lift-1010-solid-low-narrow-01 item-05) 8001)
    (= (x-of-place-back-0000-solid-low-narrow-01 item-05) 9079) (= (y-of-place-back-0000-solid-low-narrow-01 item-05) 9944) (= (cost-of-place-back-0000-solid-low-narrow-01 item-05) 187)
    (can-place-right-0111b-solid-low-narrow-01 item-05) (= (x-of-place-right-0111b-solid-low-narrow-01 item-05) 10133) (= (y-of-place-right-0111b-solid-low-narrow-01 item-05) 9489) (= (cost-of-place-right-0111b-solid-low-narrow-01 item-05) 4)
    (can-pull-1100b-solid-low-narrow-01 item-05) (= (x-of-pull-1100b-solid-low-narrow-01 item-05) 9422) (= (y-of-pull-1100b-solid-low-narrow-01 item-05) 10171) (= (cost-of-pull-1100b-solid-low-narrow-01 item-05) 4)
    (can-pull-right-0100b-solid-low-narrow-01 item-05) (= (x-of-pull-right-0100b-solid-low-narrow-01 item-05) 9352) (= (y-of-pull-right-0100b-solid-low-narrow-01 item-05) 9637) (= (cost-of-pull-right-0100b-solid-low-narrow-01 item-05) 4)
    (can-pull-right-0110b-solid-low-narrow-01 item-05) (= (x-of-pull-right-0110b-solid-low-narrow-01 item-05) 9930) (= (y-of-pull-right-0110b-solid-low-narrow-01 item-05) 9948) (= (cost-of-pull-right-0110b-solid-low-narrow-01 item-05) 18)
    (can-pull-right-0111-solid-low-narrow-01 item-05) (= (x-of-pull-right-0111-solid-low-narrow-01 item-05) 9730) (= (y-of-pull-right-0111-solid-low-narrow-01 item-05) 9649) (= (cost-of-pull-right-0111-solid-low-narrow-01 item-05) 4)
    (can-push-forward-1011-solid-low-narrow-01 item-05) (= (x-of-push-forward-1011-solid-low-narrow-01 item-05) 10975) (= (y-of-push-forward-1011-solid-low-narrow-01 item-05) 10248) (= (cost-of-push-forward-1011-solid-low-narrow-01 item-05) 4)
    (can-push-forward-right-1111-solid-low-narrow-01 item-05) (= (x-of-push-forward-right-1111-solid-low-narrow-01 item-05) 10639) (= (y-of-push-forward-right-1111-solid-low-narrow-01 item-05) 9507) (= (cost-of-push-forward-right-1111-solid-low-narrow-01 item-05) 4)
    (can-push-left-0110-solid-low-narrow-01 item-05) (= (x-of-push-left-0110-solid-low-narrow-01 item-05) 9748) (= (y-of-push-left-0110-solid-low-narrow-01 item-05) 10607) (= (cost-of-push-left-0110-solid-low-narrow-01 item-05) 4)
    (can-push-left-1101-solid-low-narrow-01 item-05) (= (x-of-push-left-1101-solid-low-narrow-01 item-05) 9965) (= (y-of-push-left-1101-solid-low-narrow-01 item-05) 10372) (= (cost-of-push-left-1101-solid-low-narrow-01 item-05) 4)
    (can-push-left-1110b-solid-low-narrow-01 item-05) (= (x-of-push-left-1110b-solid-low-narrow-01 item-05) 10261) (= (y-of-push-left-1110b-solid-low-narrow-01 item-05) 11139) (= (cost-of-push-left-1110b-solid-low-narrow-01 item-05) 11)
    (can-push-right-0101b-solid-low-narrow-01 item-05) (= (x-of-push-right-0101b-solid-low-narrow-01 item-05) 9845) (= (y-of-push-right-0101b-solid-low-narrow-01 item-05) 8597) (= (cost-of-push-right-0101b-solid-low-narrow-01 item-05) 84)
    (= (x-of-push-right-1001-solid-low-narrow-01 item-05) 9999) (= (y-of-push-right-1001-solid-low-narrow-01 item-05) 9614) (= (cost-of-push-right-1001-solid-low-narrow-01 item-05) 187)
    ; item-06 starts at (0.8959, 0.1877, 0.0215) m
    (= (x item-06) 5459) (= (y item-06) 4877) (= (z item-06) 0)
    ; What each operator promises for item-06 (features 0.05643 0.176 0.04307 1).
    ; Not for item-06:
    ; lift-0010-solid-low-10: keeps its promise in 1 of 31 rehearsals only.
    ; lift-1001c-solid-low-10: keeps its promise in 1 of 31 rehearsals only.
    ; push-forward-left-1010-solid-low-10: scatters more than it moves.
    ; push-right-0010-solid-low-10: scatters more than it moves.
    ; stay-1101-solid-low-10: scatters more than it moves.
    (= (x-of-lift-0010-solid-low-10 item-06) 10273) (= (y-of-lift-0010-solid-low-10 item-06) 10235) (= (z-of-lift-0010-solid-low-10 item-06) 12332) (= (cost-of-lift-0010-solid-low-10 item-06) 281)
    (= (x-of-put-down-lift-0010-solid-low-10 item-06) 10002) (= (y-of-put-down-lift-0010-solid-low-10 item-06) 9993) (= (z-of-put-down-lift-0010-solid-low-10 item-06) 7668)
    (= (x-of-lift-1001c-solid-low-10 item-06) 10182) (= (y-of-lift-1001c-solid-low-10 item-06) 9536) (= (z-of-lift-1001c-solid-low-10 item-06) 11998) (= (cost-of-lift-1001c-solid-low-10 item-06) 281)
    (= (x-of-put-down-lift-1001c-solid-low-10 item-06) 10000) (= (y-of-put-down-lift-1001c-solid-low-10 item-06) 9986) (= (z-of-put-down-lift-1001c-solid-low-10 item-06) 8002)
    (can-pull-0000b-solid-low-10 item-06) (= (x-of-pull-0000b-solid-low-10 item-06) 9564) (= (y-of-pull-0000b-solid-low-10 item-06) 9865) (= (cost-of-pull-0000b-solid-low-10 item-06) 14)
    (can-pull-0100-solid-low-10 item-06) (= (x-of-pull-0100-solid-low-10 item-06) 9291) (= (y-of-pull-0100-solid-low-10 item-06) 9956) (= (cost-of-pull-0100-solid-low-10 item-06) 7)
    (can-pull-0100c-solid-low-10 item-06) (= (x-of-pull-0100c-solid-low-10 item-06) 9428) (= (y-of-pull-0100c-solid-low-10 item-06) 10206) (= (cost-of-pull-0100c-solid-low-10 item-06) 11)
    (can-pull-0110c-solid-low-10 item-06) (= (x-of-pull-0110c-solid-low-10 item-06) 9704) (= (y-of-pull-0110c-solid-low-10 item-06) 9948) (= (cost-of-pull-0110c-solid-low-10 item-06) 7)
    (can-pull-left-1110c-solid-low-10 item-06) (= (x-of-pull-left-1110c-solid-low-10 item-06) 9621) (= (y-of-pull-left-1110c-solid-low-10 item-06) 10274) (= (cost-of-pull-left-1110c-solid-low-10 item-06) 4)
    (can-push-forward-0101c-solid-low-10 item-06) (= (x-of-push-forward-0101c-solid-low-10 item-06) 10397) (= (y-of-push-forward-0101c-solid-low-10 item-06) 9787) (= (cost-of-push-forward-0101c-solid-low-10 item-06) 14)
    (can-push-forward-1011-solid-low-10 item-06) (= (x-of-push-forward-1011-solid-low-10 item-06) 10818) (= (y-of-push-forward-1011-solid-low-10 item-06) 10069) (= (cost-of-push-forward-1011-solid-low-10 item-06) 4)
    (can-push-forward-left-1001c-solid-low-10 item-06) (= (x-of-push-forward-left-1001c-solid-low-10 item-06) 10644) (= (y-of-push-forward-left-1001c-solid-low-10 item-06) 10680) (= (cost-of-push-forward-left-1001c-solid-low-10 item-06) 14)
    (= (x-of-push-forward-left-1010-solid-low-10 item-06) 10136) (= (y-of-push-forward-left-1010-solid-low-10 item-06) 10151) (= (cost-of-push-forward-left-1010-solid-low-10 item-06) 7)
    (can-push-forward-left-1100c-solid-low-10 item-06) (= (x-of-push-forward-left-1100c-solid-low-10 item-06) 10350) (= (y-of-push-forward-left-1100c-solid-low-10 item-06) 11194) (= (cost-of-push-forward-left-1100c-solid-low-10 item-06) 21)
    (can-push-forward-right-0111c-solid-low-10 item-06) (= (x-of-push-forward-right-0111c-solid-low-10 item-06) 10489) (= (y-of-push-forward-right-0111c-solid-low-10 item-06) 9257) (= (cost-of-push-forward-right-0111c-solid-low-10 item-06) 62)
    (can-push-forward-right-1111-solid-low-10 item-06) (= (x-of-push-forward-right-1111-solid-low-10 item-06) 10315) (= (y-of-push-forward-right-1111-solid-low-10 item-06) 9845) (= (cost-of-push-forward-right-1111-solid-low-10 item-06) 17)
    (can-push-left-1000-solid-low-10 item-06) (= (x-of-push-left-1000-solid-low-10 item-06) 9948) (= (y-of-push-left-1000-solid-low-10 item-06) 10179) (= (cost-of-push-left-1000-solid-low-10 item-06) 7)
    (can-push-right-0001b-solid-low-10 item-06) (= (x-of-push-right-0001b-solid-low-10 item-06) 9867) (= (y-of-push-right-0001b-solid-low-10 item-06) 9536) (= (cost-of-push-right-0001b-solid-low-10 item-06) 11)
    (= (x-of-push-right-0010-solid-low-10 item-06) 10084) (= (y-of-push-right-0010-solid-low-10 item-06) 9810) (= (cost-of-push-right-0010-solid-low-10 item-06) 7)
    (can-push-right-0011-solid-low-10 item-06) (= (x-of-push-right-0011-solid-low-10 item-06) 10107) (= (y-of-push-right-0011-solid-low-10 item-06) 9615) (= (cost-of-push-right-0011-solid-low-10 item-06) 87)
    (= (x-of-stay-1101-solid-low-10 item-06) 10000) (= (y-of-stay-1101-solid-low-10 item-06) 9941) (= (cost-of-stay-1101-solid-low-10 item-06) 11)
    ; item-07 starts at (0.7546, -0.0196, 0.0162) m
    (= (x item-07) 4046) (= (y item-07) 2804) (= (z item-07) 0)
    ; What each operator promises for item-07 (features 0.1744 0.04544 0.03239 0).
    ; Not for item-07:
    ; lift-0110b-solid-low-narrow-01: keeps its promise with such objects in about 5 of 30 only.
    ; place-back-0000-solid-low-narrow-01: keeps its promise in 1 of 30 rehearsals only.
    ; push-right-1001-solid-low-narrow-01: keeps its promise in 1 of 30 rehearsals only.
    (can-lift-0000-solid-low-narrow-01 item-07) (= (x-of-lift-0000-solid-low-narrow-01 item-07) 9170) (= (y-of-lift-0000-solid-low-narrow-01 item-07) 9937) (= (z-of-lift-0000-solid-low-narrow-01 item-07) 12020) (= (cost-of-lift-0000-solid-low-narrow-01 item-07) 7)
    (= (x-of-put-down-lift-0000-solid-low-narrow-01 item-07) 10010) (= (y-of-put-down-lift-0000-solid-low-narrow-01 item-07) 9984) (= (z-of-put-down-lift-0000-solid-low-narrow-01 item-07) 7980)
    (can-lift-0000a-solid-low-narrow-01 item-07) (= (x-of-lift-0000a-solid-low-narrow-01 item-07) 9495) (= (y-of-lift-0000a-solid-low-narrow-01 item-07) 10251) (= (z-of-lift-0000a-solid-low-narrow-01 item-07) 12464) (= (cost-of-lift-0000a-solid-low-narrow-01 item-07) 4)
    (= (x-of-put-down-lift-0000a-solid-low-narrow-01 item-07) 10004) (= (y-of-put-down-lift-0000a-solid-low-narrow-01 item-07) 9985) (= (z-of-put-down-lift-0000a-solid-low-narrow-01 item-07) 7536)
    (can-lift-0001-solid-low-narrow-01 item-07) (= (x-of-lift-0001-solid-low-narrow-01 item-07) 9692) (= (y-of-lift-0001-solid-low-narrow-01 item-07) 9785) (= (z-of-lift-0001-solid-low-narrow-01 item-07) 12421) (= (cost-of-lift-0001-solid-low-narrow-01 item-07) 7)
    (= (x-of-put-down-lift-0001-solid-low-narrow-01 item-07) 9998) (= (y-of-put-down-lift-0001-solid-low-narrow-01 item-07) 9986) (= (z-of-put-down-lift-0001-solid-low-narrow-01 item-07) 7579)
    (can-lift-0001a-solid-low-narrow-01 item-07) (= (x-of-lift-0001a-solid-low-narrow-01 item-07) 9836) (= (y-of-lift-0001a-solid-low-narrow-01 item-07) 9801) (= (z-of-lift-0001a-solid-low-narrow-01 item-07) 11992) (= (cost-of-lift-0001a-solid-low-narrow-01 item-07) 4)
    (= (x-of-put-down-lift-0001a-solid-low-narrow-01 item-07) 10007) (= (y-of-put-down-lift-0001a-solid-low-narrow-01 item-07) 9984) (= (z-of-put-down-lift-0001a-solid-low-narrow-01 item-07) 8008)
    (can-lift-0010-solid-low-narrow-01 item-07) (= (x-of-lift-0010-solid-low-narrow-01 item-07) 10273) (= (y-of-lift-0010-solid-low-narrow-01 item-07) 10219) (= (z-of-lift-0010-solid-low-narrow-01 item-07) 12316) (= (cost-of-lift-0010-solid-low-narrow-01 item-07) 4)
    (= (x-of-put-down-lift-0010-solid-low-narrow-01 item-07) 9999) (= (y-of-put-down-lift-0010-solid-low-narrow-01 item-07) 9984) (= (z-of-put-down-lift-0010-solid-low-narrow-01 item-07) 7684)
    (can-lift-0011b-solid-low-narrow-01 item-07) (= (x-of-lift-0011b-solid-low-narrow-01 item-07) 10405) (= (y-of-lift-0011b-solid-low-narrow-01 item-07) 9559) (= (z-of-lift-0011b-solid-low-narrow-01 item-07) 12401) (= (cost-of-lift-0011b-solid-low-narrow-01 item-07) 4)
    (= (x-of-put-down-lift-0011b-solid-low-narrow-01 item-07) 10001) (= (y-of-put-down-lift-0011b-solid-low-narrow-01 item-07) 9987) (= (z-of-put-down-lift-0011b-solid-low-narrow-01 item-07) 7599)
    (= (x-of-lift-0110b-solid-low-narrow-01 item-07) 10544) (= (y-of-lift-0110b-solid-low-narrow-01 item-07) 9919) (= (z-of-lift-0110b-solid-low-narrow-01 item-07) 12027) (= (cost-of-lift-0110b-solid-low-narrow-01 item-07) 168)
    (= (x-of-put-down-lift-0110b-solid-low-narrow-01 item-07) 10001) (= (y-of-put-down-lift-0110b-solid-low-narrow-01 item-07) 9983) (= (z-of-put-down-lift-0110b-solid-low-narrow-01 item-07) 7973)
    (can-lift-1000-solid-low-narrow-01 item-07) (= (x-of-lift-1000-solid-low-narrow-01 item-07) 9630) (= (y-of-lift-1000-solid-low-narrow-01 item-07) 10431) (= (z-of-lift-1000-solid-low-narrow-01 item-07) 12001) (= (cost-of-lift-1000-solid-low-narrow-01 item-07) 4)
    (= (x-of-put-down-lift-1000-solid-low-narrow-01 item-07) 9998) (= (y-of-put-down-lift-1000-solid-low-narrow-01 item-07) 9985) (= (z-of-put-down-lift-1000-solid-low-narrow-01 item-07) 7999)
    (can-lift-1001-solid-low-narrow-01 item-07) (= (x-of-lift-1001-solid-low-narrow-01 item-07) 9835) (= (y-of-lift-1001-solid-low-narrow-01 item-07) 9472) (= (z-of-lift-1001-solid-low-narrow-01 item-07) 11987) (= (cost-of-lift-1001-solid-low-narrow-01 item-07) 7)
    (= (x-of-put-down-lift-1001-solid-low-narrow-01 item-07) 10017) (= (y-of-put-down-lift-1001-solid-low-narrow-01 item-07) 9987) (= (z-of-put-down-lift-1001-solid-low-narrow-01 item-07) 8013)
    (can-lift-1001b-solid-low-narrow-01 item-07) (= (x-of-lift-1001b-solid-low-narrow-01 item-07) 10396) (= (y-of-lift-1001b-solid-low-narrow-01 item-07) 9483) (= (z-of-lift-1001b-solid-low-narrow-01 item-07) 12004) (= (cost-of-lift-1001b-solid-low-narrow-01 item-07) 4)
    (= (x-of-put-down-lift-1001b-solid-low-narrow-01 item-07) 9998) (= (y-of-put-down-lift-1001b-solid-low-narrow-01 item-07) 9988) (= (z-of-put-down-lift-1001b-solid-low-narrow-01 item-07) 7996)
    (can-lift-1010-solid-low-narrow-01 item-07) (= (x-of-lift-1010-solid-low-narrow-01 item-07) 10288) (= (y-of-lift-1010-solid-low-narrow-01 item-07) 10459) (= (z-of-lift-1010-solid-low-narrow-01 item-07) 11998) (= (cost-of-lift-1010-solid-low-narrow-01 item-07) 4)
    (= (x-of-put-down-lift-1010-solid-low-narrow-01 item-07) 9998) (= (y-of-put-down-lift-1010-solid-low-narrow-01 item-07) 9983) (= (z-of-put-down-lift-1010-solid-low-narrow-01 item-07) 8002)
    (= (x-of-place-back-0000-solid-low-narrow-01 item-07) 9125) (= (y-of-place-back-0000-solid-low-narrow-01 item-07) 9932) (= (cost-of-place-back-0000-solid-low-narrow-01 item-07) 278)
    (can-place-right-0111b-solid-low-narrow-01 item-07) (= (x-of-place-right-0111b-solid-low-narrow-01 item-07) 10147) (= (y-of-place-right-0111b-solid-low-narrow-01 item-07) 9476) (= (cost-of-place-right-0111b-solid-low-narrow-01 item-07) 4)
    (can-pull-1100b-solid-low-narrow-01 item-07) (= (x-of-pull-1100b-solid-low-narrow-01 item-07) 9421) (= (y-of-pull-1100b-solid-low-narrow-01 item-07) 10166) (= (cost-of-pull-1100b-solid-low-narrow-01 item-07) 4)
    (can-pull-right-0100b-solid-low-narrow-01 item-07) (= (x-of-pull-right-0100b-solid-low-narrow-01 item-07) 9298) (= (y-of-pull-right-0100b-solid-low-narrow-01 item-07) 9633) (= (cost-of-pull-right-0100b-solid-low-narrow-01 item-07) 4)
    (can-pull-right-0110b-solid-low-narrow-01 item-07) (= (x-of-pull-right-0110b-solid-low-narrow-01 item-07) 9851) (= (y-of-pull-right-0110b-solid-low-narrow-01 item-07) 9922) (= (cost-of-pull-right-0110b-solid-low-narrow-01 item-07) 22)
    (can-pull-right-0111-solid-low-narrow-01 item-07) (= (x-of-pull-right-0111-solid-low-narrow-01 item-07) 9729) (= (y-of-pull-right-0111-solid-low-narrow-01 item-07) 9643) (= (cost-of-pull-right-0111-solid-low-narrow-01 item-07) 4)
    (can-push-forward-1011-solid-low-narrow-01 item-07) (= (x-of-push-forward-1011-solid-low-narrow-01 item-07) 10985) (= (y-of-push-forward-1011-solid-low-narrow-01 item-07) 10266) (= (cost-of-push-forward-1011-solid-low-narrow-01 item-07) 4)
    (can-push-forward-right-1111-solid-low-narrow-01 item-07) (= (x-of-push-forward-right-1111-solid-low-narrow-01 item-07) 10621) (= (y-of-push-forward-right-1111-solid-low-narrow-01 item-07) 9608) (= (cost-of-push-forward-right-1111-solid-low-narrow-01 item-07) 4)
    (can-push-left-0110-solid-low-narrow-01 item-07) (= (x-of-push-left-0110-solid-low-narrow-01 item-07) 9919) (= (y-of-push-left-0110-solid-low-narrow-01 item-07) 10678) (= (cost-of-push-left-0110-solid-low-narrow-01 item-07) 4)
    (can-push-left-1101-solid-low-narrow-01 item-07) (= (x-of-push-left-1101-solid-low-narrow-01 item-07) 9964) (= (y-of-push-left-1101-solid-low-narrow-01 item-07) 10370) (= (cost-of-push-left-1101-solid-low-narrow-01 item-07) 4)
    (can-push-left-1110b-solid-low-narrow-01 item-07) (= (x-of-push-left-1110b-solid-low-narrow-01 item-07) 10301) (= (y-of-push-left-1110b-solid-low-narrow-01 item-07) 11269) (= (cost-of-push-left-1110b-solid-low-narrow-01 item-07) 4)
    (can-push-right-0101b-solid-low-narrow-01 item-07) (= (x-of-push-right-0101b-solid-low-narrow-01 item-07) 9853) (= (y-of-push-right-0101b-solid-low-narrow-01 item-07) 8688) (= (cost-of-push-right-0101b-solid-low-narrow-01 item-07) 11)
    (= (x-of-push-right-1001-solid-low-narrow-01 item-07) 10001) (= (y-of-push-right-1001-solid-low-narrow-01 item-07) 9737) (= (cost-of-push-right-1001-solid-low-narrow-01 item-07) 278)
    ; item-08 starts at (0.7367, 0.1114, 0.0117) m
    (= (x item-08) 3867) (= (y item-08) 4114) (= (z item-08) 0)
    ; What each operator promises for item-08 (features 0.1632 0.09574 0.02336 0).
    ; Not for item-08:
    ; lift-0001-any-tall-narrow-11: keeps its promise in 2 of 30 rehearsals only.
    ; lift-1101a-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    ; pull-right-0011c-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    ; push-left-1000-any-tall-narrow-11: keeps its promise in 2 of 30 rehearsals only.
    ; push-right-0001a-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    ; push-right-0011-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    (can-lift-0000c-any-tall-narrow-11 item-08) (= (x-of-lift-0000c-any-tall-narrow-11 item-08) 9444) (= (y-of-lift-0000c-any-tall-narrow-11 item-08) 10479) (= (z-of-lift-0000c-any-tall-narrow-11 item-08) 11994) (= (cost-of-lift-0000c-any-tall-narrow-11 item-08) 4)
    (= (x-of-put-down-lift-0000c-any-tall-narrow-11 item-08) 9999) (= (y-of-put-down-lift-0000c-any-tall-narrow-11 item-08) 9994) (= (z-of-put-down-lift-0000c-any-tall-narrow-11 item-08) 8006)
    (= (x-of-lift-0001-any-tall-narrow-11 item-08) 9708) (= (y-of-lift-0001-any-tall-narrow-11 item-08) 9396) (= (z-of-lift-0001-any-tall-narrow-11 item-08) 12427) (= (cost-of-lift-0001-any-tall-narrow-11 item-08) 238)
    (= (x-of-put-down-lift-0001-any-tall-narrow-11 item-08) 9995) (= (y-of-put-down-lift-0001-any-tall-narrow-11 item-08) 9975) (= (z-of-put-down-lift-0001-any-tall-narrow-11 item-08) 7573)
    (can-lift-0001a-any-tall-narrow-11 item-08) (= (x-of-lift-0001a-any-tall-narrow-11 item-08) 9796) (= (y-of-lift-0001a-any-tall-narrow-11 item-08) 9833) (= (z-of-lift-0001a-any-tall-narrow-11 item-08) 12000) (= (cost-of-lift-0001a-any-tall-narrow-11 item-08) 7)
    (= (x-of-put-down-lift-0001a-any-tall-narrow-11 item-08) 10000) (= (y-of-put-down-lift-0001a-any-tall-narrow-11 item-08) 9993) (= (z-of-put-down-lift-0001a-any-tall-narrow-11 item-08) 8000)
    (can-lift-0010b-any-tall-narrow-11 item-08) (= (x-of-lift-0010b-any-tall-narrow-11 item-08) 10330) (= (y-of-lift-0010b-any-tall-narrow-11 item-08) 10237) (= (z-of-lift-0010b-any-tall-narrow-11 item-08) 12363) (= (cost-of-lift-0010b-any-tall-narrow-11 item-08) 4)
    (= (x-of-put-down-lift-0010b-any-tall-narrow-11 item-08) 10002) (= (y-of-put-down-lift-0010b-any-tall-narrow-11 item-08) 9993) (= (z-of-put-down-lift-0010b-any-tall-narrow-11 item-08) 7637)
    (can-lift-0011-any-tall-narrow-11 item-08) (= (x-of-lift-0011-any-tall-narrow-11 item-08) 10387) (= (y-of-lift-0011-any-tall-narrow-11 item-08) 9504) (= (z-of-lift-0011-any-tall-narrow-11 item-08) 12001) (= (cost-of-lift-0011-any-tall-narrow-11 item-08) 7)
    (= (x-of-put-down-lift-0011-any-tall-narrow-11 item-08) 10001) (= (y-of-put-down-lift-0011-any-tall-narrow-11 item-08) 9990) (= (z-of-put-down-lift-0011-any-tall-narrow-11 item-08) 7999)
    (can-lift-0011c-any-tall-narrow-11 item-08) (= (x-of-lift-0011c-any-tall-narrow-11 item-08) 9837) (= (y-of-lift-0011c-any-tall-narrow-11 item-08) 9682) (= (z-of-lift-0011c-any-tall-narrow-11 item-08) 12579) (= (cost-of-lift-0011c-any-tall-narrow-11 item-08) 7)
    (= (x-of-put-down-lift-0011c-any-tall-narrow-11 item-08) 10004) (= (y-of-put-down-lift-0011c-any-tall-narrow-11 item-08) 9992) (= (z-of-put-down-lift-0011c-any-tall-narrow-11 item-08) 7421)
    (can-lift-1000-any-tall-narrow-11 item-08) (= (x-of-lift-1000-any-tall-narrow-11 item-08) 9735) (= (y-of-lift-1000-any-tall-narrow-11 item-08) 10381) (= (z-of-lift-1000-any-tall-narrow-11 item-08) 12233) (= (cost-of-lift-1000-any-tall-narrow-11 item-08) 11)
    (= (x-of-put-down-lift-1000-any-tall-narrow-11 item-08) 9998) (= (y-of-put-down-lift-1000-any-tall-narrow-11 item-08) 9996) (= (z-of-put-down-lift-1000-any-tall-narrow-11 item-08) 7767)
    (can-lift-1001d-any-tall-narrow-11 item-08) (= (x-of-lift-1001d-any-tall-narrow-11 item-08) 10615) (= (y-of-lift-1001d-any-tall-narrow-11 item-08) 9545) (= (z-of-lift-1001d-any-tall-narrow-11 item-08) 12007) (= (cost-of-lift-1001d-any-tall-narrow-11 item-08) 4)
    (= (x-of-put-down-lift-1001d-any-tall-narrow-11 item-08) 10002) (= (y-of-put-down-lift-1001d-any-tall-narrow-11 item-08) 9994) (= (z-of-put-down-lift-1001d-any-tall-narrow-11 item-08) 7993)
    (can-lift-1010b-any-tall-narrow-11 item-08) (= (x-of-lift-1010b-any-tall-narrow-11 item-08) 10278) (= (y-of-lift-1010b-any-tall-narrow-11 item-08) 10230) (= (z-of-lift-1010b-any-tall-narrow-11 item-08) 12002) (= (cost-of-lift-1010b-any-tall-narrow-11 item-08) 4)
    (= (x-of-put-down-lift-1010b-any-tall-narrow-11 item-08) 10002) (= (y-of-put-down-lift-1010b-any-tall-narrow-11 item-08) 9993) (= (z-of-put-down-lift-1010b-any-tall-narrow-11 item-08) 7998)
    (= (x-of-lift-1101a-any-tall-narrow-11 item-08) 10284) (= (y-of-lift-1101a-any-tall-narrow-11 item-08) 10264) (= (z-of-lift-1101a-any-tall-narrow-11 item-08) 12038) (= (cost-of-lift-1101a-any-tall-narrow-11 item-08) 278)
    (= (x-of-put-down-lift-1101a-any-tall-narrow-11 item-08) 10041) (= (y-of-put-down-lift-1101a-any-tall-narrow-11 item-08) 10028) (= (z-of-put-down-lift-1101a-any-tall-narrow-11 item-08) 7962)
    (can-place-forward-right-0111d-any-tall-narrow-11 item-08) (= (x-of-place-forward-right-0111d-any-tall-narrow-11 item-08) 10322) (= (y-of-place-forward-right-0111d-any-tall-narrow-11 item-08) 9526) (= (cost-of-place-forward-right-0111d-any-tall-narrow-11 item-08) 4)
    (can-pull-0100-any-tall-narrow-11 item-08) (= (x-of-pull-0100-any-tall-narrow-11 item-08) 9133) (= (y-of-pull-0100-any-tall-narrow-11 item-08) 9761) (= (cost-of-pull-0100-any-tall-narrow-11 item-08) 4)
    (can-pull-0110d-any-tall-narrow-11 item-08) (= (x-of-pull-0110d-any-tall-narrow-11 item-08) 9853) (= (y-of-pull-0110d-any-tall-narrow-11 item-08) 9954) (= (cost-of-pull-0110d-any-tall-narrow-11 item-08) 4)
    (can-pull-left-1110d-any-tall-narrow-11 item-08) (= (x-of-pull-left-1110d-any-tall-narrow-11 item-08) 9636) (= (y-of-pull-left-1110d-any-tall-narrow-11 item-08) 10350) (= (cost-of-pull-left-1110d-any-tall-narrow-11 item-08) 11)
    (= (x-of-pull-right-0011c-any-tall-narrow-11 item-08) 9570) (= (y-of-pull-right-0011c-any-tall-narrow-11 item-08) 9392) (= (cost-of-pull-right-0011c-any-tall-narrow-11 item-08) 278)
    (can-pull-right-0100d-any-tall-narrow-11 item-08) (= (x-of-pull-right-0100d-any-tall-narrow-11 item-08) 9434) (= (y-of-pull-right-0100d-any-tall-narrow-11 item-08) 9644) (= (cost-of-pull-right-0100d-any-tall-narrow-11 item-08) 4)
    (can-push-forward-1011-any-tall-narrow-11 item-08) (= (x-of-push-forward-1011-any-tall-narrow-11 item-08) 10972) (= (y-of-push-forward-1011-any-tall-narrow-11 item-08) 10241) (= (cost-of-push-forward-1011-any-tall-narrow-11 item-08) 11)
    (can-push-forward-1011b-any-tall-narrow-11 item-08) (= (x-of-push-forward-1011b-any-tall-narrow-11 item-08) 10796) (= (y-of-push-forward-1011b-any-tall-narrow-11 item-08) 10117) (= (cost-of-push-forward-1011b-any-tall-narrow-11 item-08) 4)
    (can-push-forward-1111b-any-tall-narrow-11 item-08) (= (x-of-push-forward-1111b-any-tall-narrow-11 item-08) 10402) (= (y-of-push-forward-1111b-any-tall-narrow-11 item-08) 10015) (= (cost-of-push-forward-1111b-any-tall-narrow-11 item-08) 4)
    (can-push-forward-left-1100d-any-tall-narrow-11 item-08) (= (x-of-push-forward-left-1100d-any-tall-narrow-11 item-08) 10159) (= (y-of-push-forward-left-1100d-any-tall-narrow-11 item-08) 10286) (= (cost-of-push-forward-left-1100d-any-tall-narrow-11 item-08) 4)
    (can-push-forward-right-1111-any-tall-narrow-11 item-08) (= (x-of-push-forward-right-1111-any-tall-narrow-11 item-08) 10561) (= (y-of-push-forward-right-1111-any-tall-narrow-11 item-08) 9702) (= (cost-of-push-forward-right-1111-any-tall-narrow-11 item-08) 14)
    (= (x-of-push-left-1000-any-tall-narrow-11 item-08) 9983) (= (y-of-push-left-1000-any-tall-narrow-11 item-08) 10112) (= (cost-of-push-left-1000-any-tall-narrow-11 item-08) 238)
    (can-push-left-1101a-any-tall-narrow-11 item-08) (= (x-of-push-left-1101a-any-tall-narrow-11 item-08) 9956) (= (y-of-push-left-1101a-any-tall-narrow-11 item-08) 10127) (= (cost-of-push-left-1101a-any-tall-narrow-11 item-08) 7)
    (can-push-right-0001-any-tall-narrow-11 item-08) (= (x-of-push-right-0001-any-tall-narrow-11 item-08) 9853) (= (y-of-push-right-0001-any-tall-narrow-11 item-08) 9578) (= (cost-of-push-right-0001-any-tall-narrow-11 item-08) 14)
    (= (x-of-push-right-0001a-any-tall-narrow-11 item-08) 9943) (= (y-of-push-right-0001a-any-tall-narrow-11 item-08) 9925) (= (cost-of-push-right-0001a-any-tall-narrow-11 item-08) 278)
    (= (x-of-push-right-0011-any-tall-narrow-11 item-08) 10067) (= (y-of-push-right-0011-any-tall-narrow-11 item-08) 9732) (= (cost-of-push-right-0011-any-tall-narrow-11 item-08) 278)
    (can-push-right-0101d-any-tall-narrow-11 item-08) (= (x-of-push-right-0101d-any-tall-narrow-11 item-08) 9966) (= (y-of-push-right-0101d-any-tall-narrow-11 item-08) 9771) (= (cost-of-push-right-0101d-any-tall-narrow-11 item-08) 11)
    (can-push-right-0111-any-tall-narrow-11 item-08) (= (x-of-push-right-0111-any-tall-narrow-11 item-08) 9789) (= (y-of-push-right-0111-any-tall-narrow-11 item-08) 9418) (= (cost-of-push-right-0111-any-tall-narrow-11 item-08) 22))
  (:goal (and
    ; item-01 shall come to (0.6427, -0.0849, 0.0180) m, 329 mm from where it starts
    (<= (x item-01) 3381) (>= (x item-01) 2471)
    (<= (+ (x item-01) (y item-01)) 5721) (>= (+ (x item-01) (y item-01)) 4434)
    (<= (y item-01) 2606) (>= (y item-01) 1696)
    (<= (+ (y item-01) 132) (x item-01)) (<= (x item-01) (+ (y item-01) 1419))
    (>= (z item-01) 0) (<= (z item-01) 0)
    ; item-02 shall come to (0.9061, -0.1016, 0.0140) m, 483 mm from where it starts
    (<= (x item-02) 6016) (>= (x item-02) 5106)
    (<= (+ (x item-02) (y item-02)) 8188) (>= (+ (x item-02) (y item-02)) 6901)
    (<= (y item-02) 2438) (>= (y item-02) 1529)
    (<= (+ (y item-02) 2934) (x item-02)) (<= (x item-02) (+ (y item-02) 4221))
    (>= (z item-02) 0) (<= (z item-02) 0)
    ; item-03 shall come to (0.5613, 0.1870, 0.0105) m, 409 mm from where it starts
    (<= (x item-03) 2568) (>= (x item-03) 1658)
    (<= (+ (x item-03) (y item-03)) 7626) (>= (+ (x item-03) (y item-03)) 6339)
    (<= (y item-03) 5325) (>= (y item-03) 4415)
    (<= (y item-03) (+ (x item-03) 3400)) (<= (+ (x item-03) 2113) (y item-03))
    (>= (z item-03) 0) (<= (z item-03) 0)
    ; item-04 shall come to (0.3883, 0.1438, 0.0390) m, 304 mm from where it starts
    (<= (x item-04) 838) (>= (+ (x item-04) 72) 0)
    (<= (+ (x item-04) (y item-04)) 5464) (>= (+ (x item-04) (y item-04)) 4177)
    (<= (y item-04) 4893) (>= (y item-04) 3983)
    (<= (y item-04) (+ (x item-04) 4699)) (<= (+ (x item-04) 3412) (y item-04))
    (>= (z item-04) 0) (<= (z item-04) 0)
    ; item-05 shall come to (0.6183, -0.1620, 0.0395) m, 210 mm from where it starts
    (<= (x item-05) 3138) (>= (x item-05) 2228)
    (<= (+ (x item-05) (y item-05)) 4707) (>= (+ (x item-05) (y item-05)) 3420)
    (<= (y item-05) 1835) (>= (y item-05) 925)
    (<= (+ (y item-05) 660) (x item-05)) (<= (x item-05) (+ (y item-05) 1947))
    (>= (z item-05) 0) (<= (z item-05) 0)
    ; item-06 shall come to (0.4092, -0.1962, 0.0215) m, 620 mm from where it starts
    (<= (x item-06) 1047) (>= (x item-06) 137)
    (<= (+ (x item-06) (y item-06)) 2273) (>= (+ (x item-06) (y item-06)) 986)
    (<= (y item-06) 1492) (>= (y item-06) 582)
    (<= (y item-06) (+ (x item-06) 1089)) (<= (x item-06) (+ (y item-06) 198))
    (>= (z item-06) 0) (<= (z item-06) 0)
    ; item-07 shall come to (0.7864, -0.2741, 0.0162) m, 256 mm from where it starts
    (<= (x item-07) 4820) (>= (x item-07) 3910)
    (<= (+ (x item-07) (y item-07)) 5267) (>= (+ (x item-07) (y item-07)) 3980)
    (<= (y item-07) 714) (>= (+ (y item-07) 196) 0)
    (<= (+ (y item-07) 3462) (x item-07)) (<= (x item-07) (+ (y item-07) 4749))
    (>= (z item-07) 0) (<= (z item-07) 0)
    ; item-08 shall come to (0.5054, -0.0352, 0.0117) m, 274 mm from where it starts
    (<= (x item-08) 2009) (>= (x item-08) 1099)
    (<= (+ (x item-08) (y item-08)) 4846) (>= (+ (x item-08) (y item-08)) 3559)
    (<= (y item-08) 3103) (>= (y item-08) 2194)
    (<= (y item-08) (+ (x item-08) 1738)) (<= (+ (x item-08) 451) (y item-08))
    (>= (z item-08) 0) (<= (z item-08) 0)))
  (:metric minimize (total-cost)))
