; Problem task-14 of the learned domain tabletop, for its encoding numeric.
; How it came about: drawn with seed 15: 2 random actions on item-03, item-01; draw 1, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-14)
  (:domain tabletop-numeric)
  (:objects
    item-01 - any-tall-narrow-10
    item-02 - hollow-wide-01
    item-03 - solid-00)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.5667, -0.2254, 0.0149) m
    (= (x item-01) 2167) (= (y item-01) 746) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.1109 0.1109 0.02989 2).
    ; Not for item-01:
    ; pull-0100-any-tall-narrow-10: keeps its promise in 1 of 30 rehearsals only.
    ; pull-left-0101b-any-tall-narrow-10: keeps its promise in 1 of 30 rehearsals only.
    ; push-right-0000-any-tall-narrow-10: keeps its promise in 1 of 30 rehearsals only.
    ; push-right-0000c-any-tall-narrow-10: keeps its promise with such objects in about 3 of 30 only.
    ; stay-1101b-any-tall-narrow-10: keeps its promise in 1 of 30 rehearsals only.
    (can-lift-0000-any-tall-narrow-10 item-01) (= (x-of-lift-0000-any-tall-narrow-10 item-01) 9952) (= (y-of-lift-0000-any-tall-narrow-10 item-01) 9339) (= (z-of-lift-0000-any-tall-narrow-10 item-01) 12764) (= (cost-of-lift-0000-any-tall-narrow-10 item-01) 11)
    (= (x-of-put-down-lift-0000-any-tall-narrow-10 item-01) 10021) (= (y-of-put-down-lift-0000-any-tall-narrow-10 item-01) 10148) (= (z-of-put-down-lift-0000-any-tall-narrow-10 item-01) 7236)
    (can-lift-0000c-any-tall-narrow-10 item-01) (= (x-of-lift-0000c-any-tall-narrow-10 item-01) 9877) (= (y-of-lift-0000c-any-tall-narrow-10 item-01) 9441) (= (z-of-lift-0000c-any-tall-narrow-10 item-01) 12243) (= (cost-of-lift-0000c-any-tall-narrow-10 item-01) 11)
    (= (x-of-put-down-lift-0000c-any-tall-narrow-10 item-01) 9999) (= (y-of-put-down-lift-0000c-any-tall-narrow-10 item-01) 9979) (= (z-of-put-down-lift-0000c-any-tall-narrow-10 item-01) 7757)
    (can-lift-0100-any-tall-narrow-10 item-01) (= (x-of-lift-0100-any-tall-narrow-10 item-01) 9170) (= (y-of-lift-0100-any-tall-narrow-10 item-01) 9662) (= (z-of-lift-0100-any-tall-narrow-10 item-01) 12002) (= (cost-of-lift-0100-any-tall-narrow-10 item-01) 7)
    (= (x-of-put-down-lift-0100-any-tall-narrow-10 item-01) 10003) (= (y-of-put-down-lift-0100-any-tall-narrow-10 item-01) 9991) (= (z-of-put-down-lift-0100-any-tall-narrow-10 item-01) 7998)
    (can-lift-0100c-any-tall-narrow-10 item-01) (= (x-of-lift-0100c-any-tall-narrow-10 item-01) 9442) (= (y-of-lift-0100c-any-tall-narrow-10 item-01) 9500) (= (z-of-lift-0100c-any-tall-narrow-10 item-01) 12000) (= (cost-of-lift-0100c-any-tall-narrow-10 item-01) 4)
    (= (x-of-put-down-lift-0100c-any-tall-narrow-10 item-01) 10002) (= (y-of-put-down-lift-0100c-any-tall-narrow-10 item-01) 9991) (= (z-of-put-down-lift-0100c-any-tall-narrow-10 item-01) 8000)
    (can-lift-0101b-any-tall-narrow-10 item-01) (= (x-of-lift-0101b-any-tall-narrow-10 item-01) 9557) (= (y-of-lift-0101b-any-tall-narrow-10 item-01) 10409) (= (z-of-lift-0101b-any-tall-narrow-10 item-01) 12005) (= (cost-of-lift-0101b-any-tall-narrow-10 item-01) 7)
    (= (x-of-put-down-lift-0101b-any-tall-narrow-10 item-01) 10002) (= (y-of-put-down-lift-0101b-any-tall-narrow-10 item-01) 9988) (= (z-of-put-down-lift-0101b-any-tall-narrow-10 item-01) 7995)
    (can-lift-1000b-any-tall-narrow-10 item-01) (= (x-of-lift-1000b-any-tall-narrow-10 item-01) 10401) (= (y-of-lift-1000b-any-tall-narrow-10 item-01) 9524) (= (z-of-lift-1000b-any-tall-narrow-10 item-01) 12009) (= (cost-of-lift-1000b-any-tall-narrow-10 item-01) 4)
    (= (x-of-put-down-lift-1000b-any-tall-narrow-10 item-01) 10002) (= (y-of-put-down-lift-1000b-any-tall-narrow-10 item-01) 9992) (= (z-of-put-down-lift-1000b-any-tall-narrow-10 item-01) 7991)
    (can-lift-1001b-any-tall-narrow-10 item-01) (= (x-of-lift-1001b-any-tall-narrow-10 item-01) 10612) (= (y-of-lift-1001b-any-tall-narrow-10 item-01) 10249) (= (z-of-lift-1001b-any-tall-narrow-10 item-01) 12069) (= (cost-of-lift-1001b-any-tall-narrow-10 item-01) 4)
    (= (x-of-put-down-lift-1001b-any-tall-narrow-10 item-01) 10001) (= (y-of-put-down-lift-1001b-any-tall-narrow-10 item-01) 9990) (= (z-of-put-down-lift-1001b-any-tall-narrow-10 item-01) 7931)
    (can-lift-1100-any-tall-narrow-10 item-01) (= (x-of-lift-1100-any-tall-narrow-10 item-01) 9731) (= (y-of-lift-1100-any-tall-narrow-10 item-01) 10234) (= (z-of-lift-1100-any-tall-narrow-10 item-01) 12004) (= (cost-of-lift-1100-any-tall-narrow-10 item-01) 4)
    (= (x-of-put-down-lift-1100-any-tall-narrow-10 item-01) 10003) (= (y-of-put-down-lift-1100-any-tall-narrow-10 item-01) 9992) (= (z-of-put-down-lift-1100-any-tall-narrow-10 item-01) 7996)
    (can-lift-1100b-any-tall-narrow-10 item-01) (= (x-of-lift-1100b-any-tall-narrow-10 item-01) 10123) (= (y-of-lift-1100b-any-tall-narrow-10 item-01) 10468) (= (z-of-lift-1100b-any-tall-narrow-10 item-01) 12176) (= (cost-of-lift-1100b-any-tall-narrow-10 item-01) 4)
    (= (x-of-put-down-lift-1100b-any-tall-narrow-10 item-01) 10002) (= (y-of-put-down-lift-1100b-any-tall-narrow-10 item-01) 9992) (= (z-of-put-down-lift-1100b-any-tall-narrow-10 item-01) 7824)
    (can-lift-1101b-any-tall-narrow-10 item-01) (= (x-of-lift-1101b-any-tall-narrow-10 item-01) 10150) (= (y-of-lift-1101b-any-tall-narrow-10 item-01) 10033) (= (z-of-lift-1101b-any-tall-narrow-10 item-01) 12005) (= (cost-of-lift-1101b-any-tall-narrow-10 item-01) 7)
    (= (x-of-put-down-lift-1101b-any-tall-narrow-10 item-01) 9999) (= (y-of-put-down-lift-1101b-any-tall-narrow-10 item-01) 9991) (= (z-of-put-down-lift-1101b-any-tall-narrow-10 item-01) 7995)
    (can-place-forward-1010c-any-tall-narrow-10 item-01) (= (x-of-place-forward-1010c-any-tall-narrow-10 item-01) 10564) (= (y-of-place-forward-1010c-any-tall-narrow-10 item-01) 10030) (= (cost-of-place-forward-1010c-any-tall-narrow-10 item-01) 4)
    (= (x-of-pull-0100-any-tall-narrow-10 item-01) 9409) (= (y-of-pull-0100-any-tall-narrow-10 item-01) 9926) (= (cost-of-pull-0100-any-tall-narrow-10 item-01) 278)
    (can-pull-0111c-any-tall-narrow-10 item-01) (= (x-of-pull-0111c-any-tall-narrow-10 item-01) 9193) (= (y-of-pull-0111c-any-tall-narrow-10 item-01) 10284) (= (cost-of-pull-0111c-any-tall-narrow-10 item-01) 4)
    (= (x-of-pull-left-0101b-any-tall-narrow-10 item-01) 9919) (= (y-of-pull-left-0101b-any-tall-narrow-10 item-01) 10157) (= (cost-of-pull-left-0101b-any-tall-narrow-10 item-01) 278)
    (can-pull-right-0110c-any-tall-narrow-10 item-01) (= (x-of-pull-right-0110c-any-tall-narrow-10 item-01) 9570) (= (y-of-pull-right-0110c-any-tall-narrow-10 item-01) 9688) (= (cost-of-pull-right-0110c-any-tall-narrow-10 item-01) 4)
    (can-push-forward-0001c-any-tall-narrow-10 item-01) (= (x-of-push-forward-0001c-any-tall-narrow-10 item-01) 10130) (= (y-of-push-forward-0001c-any-tall-narrow-10 item-01) 9837) (= (cost-of-push-forward-0001c-any-tall-narrow-10 item-01) 4)
    (can-push-forward-1011c-any-tall-narrow-10 item-01) (= (x-of-push-forward-1011c-any-tall-narrow-10 item-01) 10903) (= (y-of-push-forward-1011c-any-tall-narrow-10 item-01) 10046) (= (cost-of-push-forward-1011c-any-tall-narrow-10 item-01) 7)
    (can-push-forward-left-1111b-any-tall-narrow-10 item-01) (= (x-of-push-forward-left-1111b-any-tall-narrow-10 item-01) 10010) (= (y-of-push-forward-left-1111b-any-tall-narrow-10 item-01) 10083) (= (cost-of-push-forward-left-1111b-any-tall-narrow-10 item-01) 11)
    (can-push-forward-right-0010c-any-tall-narrow-10 item-01) (= (x-of-push-forward-right-0010c-any-tall-narrow-10 item-01) 10136) (= (y-of-push-forward-right-0010c-any-tall-narrow-10 item-01) 9694) (= (cost-of-push-forward-right-0010c-any-tall-narrow-10 item-01) 4)
    (can-push-forward-right-1010-any-tall-narrow-10 item-01) (= (x-of-push-forward-right-1010-any-tall-narrow-10 item-01) 10205) (= (y-of-push-forward-right-1010-any-tall-narrow-10 item-01) 9360) (= (cost-of-push-forward-right-1010-any-tall-narrow-10 item-01) 22)
    (can-push-left-0011c-any-tall-narrow-10 item-01) (= (x-of-push-left-0011c-any-tall-narrow-10 item-01) 10018) (= (y-of-push-left-0011c-any-tall-narrow-10 item-01) 10253) (= (cost-of-push-left-0011c-any-tall-narrow-10 item-01) 4)
    (= (x-of-push-right-0000-any-tall-narrow-10 item-01) 9856) (= (y-of-push-right-0000-any-tall-narrow-10 item-01) 9281) (= (cost-of-push-right-0000-any-tall-narrow-10 item-01) 278)
    (= (x-of-push-right-0000c-any-tall-narrow-10 item-01) 9921) (= (y-of-push-right-0000c-any-tall-narrow-10 item-01) 9588) (= (cost-of-push-right-0000c-any-tall-narrow-10 item-01) 209)
    (can-push-right-1110-any-tall-narrow-10 item-01) (= (x-of-push-right-1110-any-tall-narrow-10 item-01) 9814) (= (y-of-push-right-1110-any-tall-narrow-10 item-01) 9506) (= (cost-of-push-right-1110-any-tall-narrow-10 item-01) 4)
    (= (x-of-stay-1101b-any-tall-narrow-10 item-01) 9966) (= (y-of-stay-1101b-any-tall-narrow-10 item-01) 9978) (= (cost-of-stay-1101b-any-tall-narrow-10 item-01) 278)
    ; item-02 starts at (0.5744, 0.1284, 0.0162) m
    (= (x item-02) 2244) (= (y item-02) 4284) (= (z item-02) 0)
    ; What each operator promises for item-02 (features 0.151 0.151 0.0325 2).
    ; Not for item-02:
    ; lift-1100a-hollow-wide-01: keeps its promise with such objects in about 6 of 35 only.
    ; place-right-0000-hollow-wide-01: keeps its promise in 2 of 35 rehearsals only.
    ; push-right-1000-hollow-wide-01: keeps its promise in 1 of 35 rehearsals only.
    (can-lift-0000-hollow-wide-01 item-02) (= (x-of-lift-0000-hollow-wide-01 item-02) 10038) (= (y-of-lift-0000-hollow-wide-01 item-02) 8952) (= (z-of-lift-0000-hollow-wide-01 item-02) 12554) (= (cost-of-lift-0000-hollow-wide-01 item-02) 19)
    (= (x-of-put-down-lift-0000-hollow-wide-01 item-02) 10002) (= (y-of-put-down-lift-0000-hollow-wide-01 item-02) 9956) (= (z-of-put-down-lift-0000-hollow-wide-01 item-02) 7446)
    (can-lift-0000b-hollow-wide-01 item-02) (= (x-of-lift-0000b-hollow-wide-01 item-02) 9641) (= (y-of-lift-0000b-hollow-wide-01 item-02) 9414) (= (z-of-lift-0000b-hollow-wide-01 item-02) 12252) (= (cost-of-lift-0000b-hollow-wide-01 item-02) 4)
    (= (x-of-put-down-lift-0000b-hollow-wide-01 item-02) 10003) (= (y-of-put-down-lift-0000b-hollow-wide-01 item-02) 9963) (= (z-of-put-down-lift-0000b-hollow-wide-01 item-02) 7748)
    (can-lift-0001b-hollow-wide-01 item-02) (= (x-of-lift-0001b-hollow-wide-01 item-02) 9837) (= (y-of-lift-0001b-hollow-wide-01 item-02) 10182) (= (z-of-lift-0001b-hollow-wide-01 item-02) 11966) (= (cost-of-lift-0001b-hollow-wide-01 item-02) 7)
    (= (x-of-put-down-lift-0001b-hollow-wide-01 item-02) 9996) (= (y-of-put-down-lift-0001b-hollow-wide-01 item-02) 9969) (= (z-of-put-down-lift-0001b-hollow-wide-01 item-02) 8034)
    (can-lift-0100b-hollow-wide-01 item-02) (= (x-of-lift-0100b-hollow-wide-01 item-02) 9667) (= (y-of-lift-0100b-hollow-wide-01 item-02) 9304) (= (z-of-lift-0100b-hollow-wide-01 item-02) 11923) (= (cost-of-lift-0100b-hollow-wide-01 item-02) 98)
    (= (x-of-put-down-lift-0100b-hollow-wide-01 item-02) 10005) (= (y-of-put-down-lift-0100b-hollow-wide-01 item-02) 9958) (= (z-of-put-down-lift-0100b-hollow-wide-01 item-02) 8077)
    (can-lift-0101a-hollow-wide-01 item-02) (= (x-of-lift-0101a-hollow-wide-01 item-02) 9742) (= (y-of-lift-0101a-hollow-wide-01 item-02) 10453) (= (z-of-lift-0101a-hollow-wide-01 item-02) 12426) (= (cost-of-lift-0101a-hollow-wide-01 item-02) 4)
    (= (x-of-put-down-lift-0101a-hollow-wide-01 item-02) 9995) (= (y-of-put-down-lift-0101a-hollow-wide-01 item-02) 9960) (= (z-of-put-down-lift-0101a-hollow-wide-01 item-02) 7574)
    (can-lift-1000-hollow-wide-01 item-02) (= (x-of-lift-1000-hollow-wide-01 item-02) 10507) (= (y-of-lift-1000-hollow-wide-01 item-02) 9616) (= (z-of-lift-1000-hollow-wide-01 item-02) 11950) (= (cost-of-lift-1000-hollow-wide-01 item-02) 7)
    (= (x-of-put-down-lift-1000-hollow-wide-01 item-02) 10000) (= (y-of-put-down-lift-1000-hollow-wide-01 item-02) 9963) (= (z-of-put-down-lift-1000-hollow-wide-01 item-02) 8050)
    (can-lift-1000a-hollow-wide-01 item-02) (= (x-of-lift-1000a-hollow-wide-01 item-02) 10512) (= (y-of-lift-1000a-hollow-wide-01 item-02) 8825) (= (z-of-lift-1000a-hollow-wide-01 item-02) 12123) (= (cost-of-lift-1000a-hollow-wide-01 item-02) 4)
    (= (x-of-put-down-lift-1000a-hollow-wide-01 item-02) 9996) (= (y-of-put-down-lift-1000a-hollow-wide-01 item-02) 9963) (= (z-of-put-down-lift-1000a-hollow-wide-01 item-02) 7877)
    (can-lift-1001a-hollow-wide-01 item-02) (= (x-of-lift-1001a-hollow-wide-01 item-02) 10432) (= (y-of-lift-1001a-hollow-wide-01 item-02) 10622) (= (z-of-lift-1001a-hollow-wide-01 item-02) 12407) (= (cost-of-lift-1001a-hollow-wide-01 item-02) 4)
    (= (x-of-put-down-lift-1001a-hollow-wide-01 item-02) 10002) (= (y-of-put-down-lift-1001a-hollow-wide-01 item-02) 9971) (= (z-of-put-down-lift-1001a-hollow-wide-01 item-02) 7593)
    (= (x-of-lift-1100a-hollow-wide-01 item-02) 9864) (= (y-of-lift-1100a-hollow-wide-01 item-02) 9410) (= (z-of-lift-1100a-hollow-wide-01 item-02) 11982) (= (cost-of-lift-1100a-hollow-wide-01 item-02) 168)
    (= (x-of-put-down-lift-1100a-hollow-wide-01 item-02) 9991) (= (y-of-put-down-lift-1100a-hollow-wide-01 item-02) 9959) (= (z-of-put-down-lift-1100a-hollow-wide-01 item-02) 8018)
    (can-lift-1101a-hollow-wide-01 item-02) (= (x-of-lift-1101a-hollow-wide-01 item-02) 10401) (= (y-of-lift-1101a-hollow-wide-01 item-02) 10447) (= (z-of-lift-1101a-hollow-wide-01 item-02) 11984) (= (cost-of-lift-1101a-hollow-wide-01 item-02) 4)
    (= (x-of-put-down-lift-1101a-hollow-wide-01 item-02) 10000) (= (y-of-put-down-lift-1101a-hollow-wide-01 item-02) 9962) (= (z-of-put-down-lift-1101a-hollow-wide-01 item-02) 8016)
    (= (x-of-place-right-0000-hollow-wide-01 item-02) 9965) (= (y-of-place-right-0000-hollow-wide-01 item-02) 9327) (= (cost-of-place-right-0000-hollow-wide-01 item-02) 252)
    (can-pull-0111-hollow-wide-01 item-02) (= (x-of-pull-0111-hollow-wide-01 item-02) 8746) (= (y-of-pull-0111-hollow-wide-01 item-02) 10096) (= (cost-of-pull-0111-hollow-wide-01 item-02) 9)
    (can-pull-left-0111b-hollow-wide-01 item-02) (= (x-of-pull-left-0111b-hollow-wide-01 item-02) 9550) (= (y-of-pull-left-0111b-hollow-wide-01 item-02) 10694) (= (cost-of-pull-left-0111b-hollow-wide-01 item-02) 4)
    (can-pull-right-0110-hollow-wide-01 item-02) (= (x-of-pull-right-0110-hollow-wide-01 item-02) 9655) (= (y-of-pull-right-0110-hollow-wide-01 item-02) 9447) (= (cost-of-pull-right-0110-hollow-wide-01 item-02) 25)
    (can-pull-right-1110b-hollow-wide-01 item-02) (= (x-of-pull-right-1110b-hollow-wide-01 item-02) 9647) (= (y-of-pull-right-1110b-hollow-wide-01 item-02) 9814) (= (cost-of-pull-right-1110b-hollow-wide-01 item-02) 4)
    (can-push-forward-left-1011b-hollow-wide-01 item-02) (= (x-of-push-forward-left-1011b-hollow-wide-01 item-02) 10382) (= (y-of-push-forward-left-1011b-hollow-wide-01 item-02) 10207) (= (cost-of-push-forward-left-1011b-hollow-wide-01 item-02) 4)
    (can-push-forward-right-0010b-hollow-wide-01 item-02) (= (x-of-push-forward-right-0010b-hollow-wide-01 item-02) 10374) (= (y-of-push-forward-right-0010b-hollow-wide-01 item-02) 9708) (= (cost-of-push-forward-right-0010b-hollow-wide-01 item-02) 4)
    (can-push-left-0011b-hollow-wide-01 item-02) (= (x-of-push-left-0011b-hollow-wide-01 item-02) 10253) (= (y-of-push-left-0011b-hollow-wide-01 item-02) 10677) (= (cost-of-push-left-0011b-hollow-wide-01 item-02) 4)
    (can-push-left-1111-hollow-wide-01 item-02) (= (x-of-push-left-1111-hollow-wide-01 item-02) 9878) (= (y-of-push-left-1111-hollow-wide-01 item-02) 10489) (= (cost-of-push-left-1111-hollow-wide-01 item-02) 9)
    (can-push-right-0100b-hollow-wide-01 item-02) (= (x-of-push-right-0100b-hollow-wide-01 item-02) 9850) (= (y-of-push-right-0100b-hollow-wide-01 item-02) 9444) (= (cost-of-push-right-0100b-hollow-wide-01 item-02) 73)
    (can-push-right-0110b-hollow-wide-01 item-02) (= (x-of-push-right-0110b-hollow-wide-01 item-02) 9530) (= (y-of-push-right-0110b-hollow-wide-01 item-02) 9090) (= (cost-of-push-right-0110b-hollow-wide-01 item-02) 7)
    (= (x-of-push-right-1000-hollow-wide-01 item-02) 10022) (= (y-of-push-right-1000-hollow-wide-01 item-02) 9843) (= (cost-of-push-right-1000-hollow-wide-01 item-02) 293)
    (can-push-right-1010-hollow-wide-01 item-02) (= (x-of-push-right-1010-hollow-wide-01 item-02) 10408) (= (y-of-push-right-1010-hollow-wide-01 item-02) 8871) (= (cost-of-push-right-1010-hollow-wide-01 item-02) 7)
    (can-push-right-1010b-hollow-wide-01 item-02) (= (x-of-push-right-1010b-hollow-wide-01 item-02) 10101) (= (y-of-push-right-1010b-hollow-wide-01 item-02) 9353) (= (cost-of-push-right-1010b-hollow-wide-01 item-02) 4)
    (can-push-right-1100a-hollow-wide-01 item-02) (= (x-of-push-right-1100a-hollow-wide-01 item-02) 9960) (= (y-of-push-right-1100a-hollow-wide-01 item-02) 9633) (= (cost-of-push-right-1100a-hollow-wide-01 item-02) 19)
    ; item-03 starts at (0.8893, 0.1208, 0.0172) m
    (= (x item-03) 5393) (= (y item-03) 4208) (= (z item-03) 0)
    ; What each operator promises for item-03 (features 0.03763 0.1606 0.03444 0).
    ; Not for item-03:
    ; lift-1100-solid-00: keeps its promise in 2 of 32 rehearsals only.
    ; push-left-1110a-solid-00: scatters more than it moves.
    (= (x-of-lift-1100-solid-00 item-03) 9740) (= (y-of-lift-1100-solid-00 item-03) 10173) (= (z-of-lift-1100-solid-00 item-03) 12020) (= (cost-of-lift-1100-solid-00 item-03) 244)
    (= (x-of-put-down-lift-1100-solid-00 item-03) 10000) (= (y-of-put-down-lift-1100-solid-00 item-03) 9991) (= (z-of-put-down-lift-1100-solid-00 item-03) 7980)
    (can-pull-0100a-solid-00 item-03) (= (x-of-pull-0100a-solid-00 item-03) 9224) (= (y-of-pull-0100a-solid-00 item-03) 9775) (= (cost-of-pull-0100a-solid-00 item-03) 4)
    (can-pull-0110a-solid-00 item-03) (= (x-of-pull-0110a-solid-00 item-03) 9673) (= (y-of-pull-0110a-solid-00 item-03) 9898) (= (cost-of-pull-0110a-solid-00 item-03) 4)
    (can-pull-0111a-solid-00 item-03) (= (x-of-pull-0111a-solid-00 item-03) 9314) (= (y-of-pull-0111a-solid-00 item-03) 10201) (= (cost-of-pull-0111a-solid-00 item-03) 4)
    (can-pull-left-0101-solid-00 item-03) (= (x-of-pull-left-0101-solid-00 item-03) 9820) (= (y-of-pull-left-0101-solid-00 item-03) 10534) (= (cost-of-pull-left-0101-solid-00 item-03) 10)
    (can-pull-left-1101-solid-00 item-03) (= (x-of-pull-left-1101-solid-00 item-03) 9741) (= (y-of-pull-left-1101-solid-00 item-03) 10487) (= (cost-of-pull-left-1101-solid-00 item-03) 20)
    (can-pull-left-1111a-solid-00 item-03) (= (x-of-pull-left-1111a-solid-00 item-03) 9817) (= (y-of-pull-left-1111a-solid-00 item-03) 10176) (= (cost-of-pull-left-1111a-solid-00 item-03) 4)
    (can-pull-right-0000a-solid-00 item-03) (= (x-of-pull-right-0000a-solid-00 item-03) 9756) (= (y-of-pull-right-0000a-solid-00 item-03) 9645) (= (cost-of-pull-right-0000a-solid-00 item-03) 17)
    (can-pull-right-1010a-solid-00 item-03) (= (x-of-pull-right-1010a-solid-00 item-03) 9870) (= (y-of-pull-right-1010a-solid-00 item-03) 9895) (= (cost-of-pull-right-1010a-solid-00 item-03) 4)
    (can-push-forward-1011-solid-00 item-03) (= (x-of-push-forward-1011-solid-00 item-03) 10799) (= (y-of-push-forward-1011-solid-00 item-03) 10132) (= (cost-of-push-forward-1011-solid-00 item-03) 7)
    (can-push-forward-1011a-solid-00 item-03) (= (x-of-push-forward-1011a-solid-00 item-03) 10877) (= (y-of-push-forward-1011a-solid-00 item-03) 9832) (= (cost-of-push-forward-1011a-solid-00 item-03) 4)
    (can-push-forward-left-0001a-solid-00 item-03) (= (x-of-push-forward-left-0001a-solid-00 item-03) 10183) (= (y-of-push-forward-left-0001a-solid-00 item-03) 10147) (= (cost-of-push-forward-left-0001a-solid-00 item-03) 4)
    (can-push-forward-left-1001-solid-00 item-03) (= (x-of-push-forward-left-1001-solid-00 item-03) 10190) (= (y-of-push-forward-left-1001-solid-00 item-03) 10307) (= (cost-of-push-forward-left-1001-solid-00 item-03) 4)
    (can-push-forward-right-0010a-solid-00 item-03) (= (x-of-push-forward-right-0010a-solid-00 item-03) 10251) (= (y-of-push-forward-right-0010a-solid-00 item-03) 9779) (= (cost-of-push-forward-right-0010a-solid-00 item-03) 4)
    (can-push-left-0011a-solid-00 item-03) (= (x-of-push-left-0011a-solid-00 item-03) 10109) (= (y-of-push-left-0011a-solid-00 item-03) 10775) (= (cost-of-push-left-0011a-solid-00 item-03) 4)
    (= (x-of-push-left-1110a-solid-00 item-03) 9910) (= (y-of-push-left-1110a-solid-00 item-03) 10105) (= (cost-of-push-left-1110a-solid-00 item-03) 4)
    (can-push-right-1000-solid-00 item-03) (= (x-of-push-right-1000-solid-00 item-03) 9979) (= (y-of-push-right-1000-solid-00 item-03) 9654) (= (cost-of-push-right-1000-solid-00 item-03) 4)
    (can-push-right-1100-solid-00 item-03) (= (x-of-push-right-1100-solid-00 item-03) 9969) (= (y-of-push-right-1100-solid-00 item-03) 9760) (= (cost-of-push-right-1100-solid-00 item-03) 14))
  (:goal (and
    ; item-01 shall come to (0.5892, -0.2636, 0.2150) m, 205 mm from where it starts
    (<= (x item-01) 2818) (>= (x item-01) 1967)
    (<= (+ (x item-01) (y item-01)) 3358) (>= (+ (x item-01) (y item-01)) 2154)
    (<= (y item-01) 789) (>= (+ (y item-01) 62) 0)
    (<= (+ (y item-01) 1427) (x item-01)) (<= (x item-01) (+ (y item-01) 2631))
    (>= (z item-01) 2000) (<= (z item-01) 2176)
    ; item-02 shall come to (0.5744, 0.1284, 0.0162) m, 0 mm from where it starts
    (<= (x item-02) 2699) (>= (x item-02) 1789)
    (<= (+ (x item-02) (y item-02)) 7172) (>= (+ (x item-02) (y item-02)) 5884)
    (<= (y item-02) 4739) (>= (y item-02) 3829)
    (<= (y item-02) (+ (x item-02) 2684)) (<= (+ (x item-02) 1396) (y item-02))
    (>= (z item-02) 0) (<= (z item-02) 0)
    ; item-03 shall come to (0.8808, 0.1055, 0.0172) m, 18 mm from where it starts
    (<= (x item-03) 5763) (>= (x item-03) 4853)
    (<= (+ (x item-03) (y item-03)) 10007) (>= (+ (x item-03) (y item-03)) 8719)
    (<= (y item-03) 4510) (>= (y item-03) 3600)
    (<= (+ (y item-03) 610) (x item-03)) (<= (x item-03) (+ (y item-03) 1897))
    (>= (z item-03) 0) (<= (z item-03) 0)))
  (:metric minimize (total-cost)))
