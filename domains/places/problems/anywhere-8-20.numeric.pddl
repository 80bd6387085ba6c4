; Problem anywhere-8-20 of the learned domain places, for its encoding numeric.
; How it came about: anywhere, drawn with seed 21; draw 1.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem anywhere-8-20)
  (:domain places-numeric)
  (:objects
    item-01 - solid-low-10
    item-02 - solid-low-10
    item-03 - solid-low-narrow-01
    item-04 - solid-low-10
    item-05 - hollow-wide-00
    item-06 - any-tall-narrow-11
    item-07 - any-tall-narrow-11
    item-08 - solid-low-narrow-01)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.7580, 0.1661, 0.0352) m
    (= (x item-01) 4080) (= (y item-01) 4661) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.06348 0.1348 0.07045 1).
    ; Not for item-01:
    ; lift-0010-solid-low-10: keeps its promise in 1 of 31 rehearsals only.
    ; lift-1001c-solid-low-10: keeps its promise in 2 of 31 rehearsals only.
    ; push-forward-right-0111c-solid-low-10: scatters more than it moves.
    ; push-forward-right-1111-solid-low-10: scatters more than it moves.
    ; push-right-0010-solid-low-10: scatters more than it moves.
    ; push-right-0011-solid-low-10: scatters more than it moves.
    ; stay-1101-solid-low-10: scatters more than it moves.
    (= (x-of-lift-0010-solid-low-10 item-01) 10272) (= (y-of-lift-0010-solid-low-10 item-01) 10235) (= (z-of-lift-0010-solid-low-10 item-01) 12331) (= (cost-of-lift-0010-solid-low-10 item-01) 281)
    (= (x-of-put-down-lift-0010-solid-low-10 item-01) 10003) (= (y-of-put-down-lift-0010-solid-low-10 item-01) 9993) (= (z-of-put-down-lift-0010-solid-low-10 item-01) 7669)
    (= (x-of-lift-1001c-solid-low-10 item-01) 10043) (= (y-of-lift-1001c-solid-low-10 item-01) 9606) (= (z-of-lift-1001c-solid-low-10 item-01) 11994) (= (cost-of-lift-1001c-solid-low-10 item-01) 241)
    (= (x-of-put-down-lift-1001c-solid-low-10 item-01) 10004) (= (y-of-put-down-lift-1001c-solid-low-10 item-01) 9963) (= (z-of-put-down-lift-1001c-solid-low-10 item-01) 8006)
    (can-pull-0000b-solid-low-10 item-01) (= (x-of-pull-0000b-solid-low-10 item-01) 9498) (= (y-of-pull-0000b-solid-low-10 item-01) 9891) (= (cost-of-pull-0000b-solid-low-10 item-01) 14)
    (can-pull-0100-solid-low-10 item-01) (= (x-of-pull-0100-solid-low-10 item-01) 9235) (= (y-of-pull-0100-solid-low-10 item-01) 9976) (= (cost-of-pull-0100-solid-low-10 item-01) 7)
    (can-pull-0100c-solid-low-10 item-01) (= (x-of-pull-0100c-solid-low-10 item-01) 9353) (= (y-of-pull-0100c-solid-low-10 item-01) 10269) (= (cost-of-pull-0100c-solid-low-10 item-01) 11)
    (can-pull-0110c-solid-low-10 item-01) (= (x-of-pull-0110c-solid-low-10 item-01) 9623) (= (y-of-pull-0110c-solid-low-10 item-01) 9906) (= (cost-of-pull-0110c-solid-low-10 item-01) 7)
    (can-pull-left-1110c-solid-low-10 item-01) (= (x-of-pull-left-1110c-solid-low-10 item-01) 9398) (= (y-of-pull-left-1110c-solid-low-10 item-01) 10439) (= (cost-of-pull-left-1110c-solid-low-10 item-01) 4)
    (can-push-forward-0101c-solid-low-10 item-01) (= (x-of-push-forward-0101c-solid-low-10 item-01) 10327) (= (y-of-push-forward-0101c-solid-low-10 item-01) 9861) (= (cost-of-push-forward-0101c-solid-low-10 item-01) 14)
    (can-push-forward-1011-solid-low-10 item-01) (= (x-of-push-forward-1011-solid-low-10 item-01) 10865) (= (y-of-push-forward-1011-solid-low-10 item-01) 10072) (= (cost-of-push-forward-1011-solid-low-10 item-01) 4)
    (can-push-forward-left-1001c-solid-low-10 item-01) (= (x-of-push-forward-left-1001c-solid-low-10 item-01) 10352) (= (y-of-push-forward-left-1001c-solid-low-10 item-01) 10425) (= (cost-of-push-forward-left-1001c-solid-low-10 item-01) 29)
    (can-push-forward-left-1010-solid-low-10 item-01) (= (x-of-push-forward-left-1010-solid-low-10 item-01) 10069) (= (y-of-push-forward-left-1010-solid-low-10 item-01) 10229) (= (cost-of-push-forward-left-1010-solid-low-10 item-01) 7)
    (can-push-forward-left-1100c-solid-low-10 item-01) (= (x-of-push-forward-left-1100c-solid-low-10 item-01) 10320) (= (y-of-push-forward-left-1100c-solid-low-10 item-01) 11038) (= (cost-of-push-forward-left-1100c-solid-low-10 item-01) 33)
    (= (x-of-push-forward-right-0111c-solid-low-10 item-01) 10097) (= (y-of-push-forward-right-0111c-solid-low-10 item-01) 9801) (= (cost-of-push-forward-right-0111c-solid-low-10 item-01) 73)
    (= (x-of-push-forward-right-1111-solid-low-10 item-01) 10160) (= (y-of-push-forward-right-1111-solid-low-10 item-01) 9895) (= (cost-of-push-forward-right-1111-solid-low-10 item-01) 14)
    (can-push-left-1000-solid-low-10 item-01) (= (x-of-push-left-1000-solid-low-10 item-01) 9971) (= (y-of-push-left-1000-solid-low-10 item-01) 10143) (= (cost-of-push-left-1000-solid-low-10 item-01) 7)
    (can-push-right-0001b-solid-low-10 item-01) (= (x-of-push-right-0001b-solid-low-10 item-01) 9934) (= (y-of-push-right-0001b-solid-low-10 item-01) 9532) (= (cost-of-push-right-0001b-solid-low-10 item-01) 11)
    (= (x-of-push-right-0010-solid-low-10 item-01) 10083) (= (y-of-push-right-0010-solid-low-10 item-01) 9794) (= (cost-of-push-right-0010-solid-low-10 item-01) 17)
    (= (x-of-push-right-0011-solid-low-10 item-01) 10091) (= (y-of-push-right-0011-solid-low-10 item-01) 9696) (= (cost-of-push-right-0011-solid-low-10 item-01) 80)
    (= (x-of-stay-1101-solid-low-10 item-01) 10004) (= (y-of-stay-1101-solid-low-10 item-01) 9720) (= (cost-of-stay-1101-solid-low-10 item-01) 11)
    ; item-02 starts at (0.5876, -0.2103, 0.0142) m
    (= (x item-02) 2376) (= (y item-02) 897) (= (z item-02) 0)
    ; What each operator promises for item-02 (features 0.05273 0.14 0.02834 0).
    ; Not for item-02:
    ; lift-0010-solid-low-10: keeps its promise in 1 of 31 rehearsals only.
    ; lift-1001c-solid-low-10: keeps its promise with such objects in about 4 of 31 only.
    ; push-right-0010-solid-low-10: scatters more than it moves.
    ; stay-1101-solid-low-10: moves less than half a cell.
    (= (x-of-lift-0010-solid-low-10 item-02) 10273) (= (y-of-lift-0010-solid-low-10 item-02) 10236) (= (z-of-lift-0010-solid-low-10 item-02) 12316) (= (cost-of-lift-0010-solid-low-10 item-02) 281)
    (= (x-of-put-down-lift-0010-solid-low-10 item-02) 10004) (= (y-of-put-down-lift-0010-solid-low-10 item-02) 9994) (= (z-of-put-down-lift-0010-solid-low-10 item-02) 7684)
    (= (x-of-lift-1001c-solid-low-10 item-02) 10298) (= (y-of-lift-1001c-solid-low-10 item-02) 9492) (= (z-of-lift-1001c-solid-low-10 item-02) 12014) (= (cost-of-lift-1001c-solid-low-10 item-02) 190)
    (= (x-of-put-down-lift-1001c-solid-low-10 item-02) 9995) (= (y-of-put-down-lift-1001c-solid-low-10 item-02) 9994) (= (z-of-put-down-lift-1001c-solid-low-10 item-02) 7986)
    (can-pull-0000b-solid-low-10 item-02) (= (x-of-pull-0000b-solid-low-10 item-02) 9601) (= (y-of-pull-0000b-solid-low-10 item-02) 9864) (= (cost-of-pull-0000b-solid-low-10 item-02) 14)
    (can-pull-0100-solid-low-10 item-02) (= (x-of-pull-0100-solid-low-10 item-02) 9245) (= (y-of-pull-0100-solid-low-10 item-02) 9923) (= (cost-of-pull-0100-solid-low-10 item-02) 7)
    (can-pull-0100c-solid-low-10 item-02) (= (x-of-pull-0100c-solid-low-10 item-02) 9269) (= (y-of-pull-0100c-solid-low-10 item-02) 10261) (= (cost-of-pull-0100c-solid-low-10 item-02) 11)
    (can-pull-0110c-solid-low-10 item-02) (= (x-of-pull-0110c-solid-low-10 item-02) 9880) (= (y-of-pull-0110c-solid-low-10 item-02) 10067) (= (cost-of-pull-0110c-solid-low-10 item-02) 4)
    (can-pull-left-1110c-solid-low-10 item-02) (= (x-of-pull-left-1110c-solid-low-10 item-02) 9713) (= (y-of-pull-left-1110c-solid-low-10 item-02) 10132) (= (cost-of-pull-left-1110c-solid-low-10 item-02) 4)
    (can-push-forward-0101c-solid-low-10 item-02) (= (x-of-push-forward-0101c-solid-low-10 item-02) 10435) (= (y-of-push-forward-0101c-solid-low-10 item-02) 9941) (= (cost-of-push-forward-0101c-solid-low-10 item-02) 14)
    (can-push-forward-1011-solid-low-10 item-02) (= (x-of-push-forward-1011-solid-low-10 item-02) 10921) (= (y-of-push-forward-1011-solid-low-10 item-02) 10143) (= (cost-of-push-forward-1011-solid-low-10 item-02) 4)
    (can-push-forward-left-1001c-solid-low-10 item-02) (= (x-of-push-forward-left-1001c-solid-low-10 item-02) 10532) (= (y-of-push-forward-left-1001c-solid-low-10 item-02) 10399) (= (cost-of-push-forward-left-1001c-solid-low-10 item-02) 33)
    (can-push-forward-left-1010-solid-low-10 item-02) (= (x-of-push-forward-left-1010-solid-low-10 item-02) 10241) (= (y-of-push-forward-left-1010-solid-low-10 item-02) 10375) (= (cost-of-push-forward-left-1010-solid-low-10 item-02) 25)
    (can-push-forward-left-1100c-solid-low-10 item-02) (= (x-of-push-forward-left-1100c-solid-low-10 item-02) 10188) (= (y-of-push-forward-left-1100c-solid-low-10 item-02) 10189) (= (cost-of-push-forward-left-1100c-solid-low-10 item-02) 4)
    (can-push-forward-right-0111c-solid-low-10 item-02) (= (x-of-push-forward-right-0111c-solid-low-10 item-02) 10606) (= (y-of-push-forward-right-0111c-solid-low-10 item-02) 9224) (= (cost-of-push-forward-right-0111c-solid-low-10 item-02) 7)
    (can-push-forward-right-1111-solid-low-10 item-02) (= (x-of-push-forward-right-1111-solid-low-10 item-02) 10241) (= (y-of-push-forward-right-1111-solid-low-10 item-02) 9661) (= (cost-of-push-forward-right-1111-solid-low-10 item-02) 11)
    (can-push-left-1000-solid-low-10 item-02) (= (x-of-push-left-1000-solid-low-10 item-02) 9873) (= (y-of-push-left-1000-solid-low-10 item-02) 10401) (= (cost-of-push-left-1000-solid-low-10 item-02) 7)
    (can-push-right-0001b-solid-low-10 item-02) (= (x-of-push-right-0001b-solid-low-10 item-02) 9788) (= (y-of-push-right-0001b-solid-low-10 item-02) 9583) (= (cost-of-push-right-0001b-solid-low-10 item-02) 11)
    (= (x-of-push-right-0010-solid-low-10 item-02) 10099) (= (y-of-push-right-0010-solid-low-10 item-02) 9776) (= (cost-of-push-right-0010-solid-low-10 item-02) 11)
    (can-push-right-0011-solid-low-10 item-02) (= (x-of-push-right-0011-solid-low-10 item-02) 10148) (= (y-of-push-right-0011-solid-low-10 item-02) 9609) (= (cost-of-push-right-0011-solid-low-10 item-02) 7)
    (= (x-of-stay-1101-solid-low-10 item-02) 10000) (= (y-of-stay-1101-solid-low-10 item-02) 9977) (= (cost-of-stay-1101-solid-low-10 item-02) 11)
    ; item-03 starts at (0.4841, 0.0069, 0.0174) m
    (= (x item-03) 1341) (= (y item-03) 3069) (= (z item-03) 0)
    ; What each operator promises for item-03 (features 0.1287 0.03972 0.03483 1).
    ; Not for item-03:
    ; lift-0110b-solid-low-narrow-01: keeps its promise with such objects in about 3 of 30 only.
    ; place-back-0000-solid-low-narrow-01: keeps its promise in 1 of 30 rehearsals only.
    ; push-right-1001-solid-low-narrow-01: keeps its promise in 1 of 30 rehearsals only.
    (can-lift-0000-solid-low-narrow-01 item-03) (= (x-of-lift-0000-solid-low-narrow-01 item-03) 9184) (= (y-of-lift-0000-solid-low-narrow-01 item-03) 9917) (= (z-of-lift-0000-solid-low-narrow-01 item-03) 12024) (= (cost-of-lift-0000-solid-low-narrow-01 item-03) 14)
    (= (x-of-put-down-lift-0000-solid-low-narrow-01 item-03) 10016) (= (y-of-put-down-lift-0000-solid-low-narrow-01 item-03) 9978) (= (z-of-put-down-lift-0000-solid-low-narrow-01 item-03) 7976)
    (can-lift-0000a-solid-low-narrow-01 item-03) (= (x-of-lift-0000a-solid-low-narrow-01 item-03) 9496) (= (y-of-lift-0000a-solid-low-narrow-01 item-03) 10249) (= (z-of-lift-0000a-solid-low-narrow-01 item-03) 12484) (= (cost-of-lift-0000a-solid-low-narrow-01 item-03) 4)
    (= (x-of-put-down-lift-0000a-solid-low-narrow-01 item-03) 10003) (= (y-of-put-down-lift-0000a-solid-low-narrow-01 item-03) 9981) (= (z-of-put-down-lift-0000a-solid-low-narrow-01 item-03) 7516)
    (can-lift-0001-solid-low-narrow-01 item-03) (= (x-of-lift-0001-solid-low-narrow-01 item-03) 9682) (= (y-of-lift-0001-solid-low-narrow-01 item-03) 9773) (= (z-of-lift-0001-solid-low-narrow-01 item-03) 12418) (= (cost-of-lift-0001-solid-low-narrow-01 item-03) 7)
    (= (x-of-put-down-lift-0001-solid-low-narrow-01 item-03) 9998) (= (y-of-put-down-lift-0001-solid-low-narrow-01 item-03) 9981) (= (z-of-put-down-lift-0001-solid-low-narrow-01 item-03) 7582)
    (can-lift-0001a-solid-low-narrow-01 item-03) (= (x-of-lift-0001a-solid-low-narrow-01 item-03) 9852) (= (y-of-lift-0001a-solid-low-narrow-01 item-03) 9793) (= (z-of-lift-0001a-solid-low-narrow-01 item-03) 11984) (= (cost-of-lift-0001a-solid-low-narrow-01 item-03) 4)
    (= (x-of-put-down-lift-0001a-solid-low-narrow-01 item-03) 10023) (= (y-of-put-down-lift-0001a-solid-low-narrow-01 item-03) 9991) (= (z-of-put-down-lift-0001a-solid-low-narrow-01 item-03) 8016)
    (can-lift-0010-solid-low-narrow-01 item-03) (= (x-of-lift-0010-solid-low-narrow-01 item-03) 10272) (= (y-of-lift-0010-solid-low-narrow-01 item-03) 10218) (= (z-of-lift-0010-solid-low-narrow-01 item-03) 12332) (= (cost-of-lift-0010-solid-low-narrow-01 item-03) 4)
    (= (x-of-put-down-lift-0010-solid-low-narrow-01 item-03) 10002) (= (y-of-put-down-lift-0010-solid-low-narrow-01 item-03) 9983) (= (z-of-put-down-lift-0010-solid-low-narrow-01 item-03) 7668)
    (can-lift-0011b-solid-low-narrow-01 item-03) (= (x-of-lift-0011b-solid-low-narrow-01 item-03) 10410) (= (y-of-lift-0011b-solid-low-narrow-01 item-03) 9560) (= (z-of-lift-0011b-solid-low-narrow-01 item-03) 12407) (= (cost-of-lift-0011b-solid-low-narrow-01 item-03) 4)
    (= (x-of-put-down-lift-0011b-solid-low-narrow-01 item-03) 10000) (= (y-of-put-down-lift-0011b-solid-low-narrow-01 item-03) 9985) (= (z-of-put-down-lift-0011b-solid-low-narrow-01 item-03) 7593)
    (= (x-of-lift-0110b-solid-low-narrow-01 item-03) 10541) (= (y-of-lift-0110b-solid-low-narrow-01 item-03) 9920) (= (z-of-lift-0110b-solid-low-narrow-01 item-03) 12038) (= (cost-of-lift-0110b-solid-low-narrow-01 item-03) 209)
    (= (x-of-put-down-lift-0110b-solid-low-narrow-01 item-03) 9994) (= (y-of-put-down-lift-0110b-solid-low-narrow-01 item-03) 9984) (= (z-of-put-down-lift-0110b-solid-low-narrow-01 item-03) 7962)
    (can-lift-1000-solid-low-narrow-01 item-03) (= (x-of-lift-1000-solid-low-narrow-01 item-03) 9629) (= (y-of-lift-1000-solid-low-narrow-01 item-03) 10430) (= (z-of-lift-1000-solid-low-narrow-01 item-03) 11997) (= (cost-of-lift-1000-solid-low-narrow-01 item-03) 4)
    (= (x-of-put-down-lift-1000-solid-low-narrow-01 item-03) 10000) (= (y-of-put-down-lift-1000-solid-low-narrow-01 item-03) 9982) (= (z-of-put-down-lift-1000-solid-low-narrow-01 item-03) 8003)
    (can-lift-1001-solid-low-narrow-01 item-03) (= (x-of-lift-1001-solid-low-narrow-01 item-03) 9829) (= (y-of-lift-1001-solid-low-narrow-01 item-03) 9477) (= (z-of-lift-1001-solid-low-narrow-01 item-03) 11985) (= (cost-of-lift-1001-solid-low-narrow-01 item-03) 7)
    (= (x-of-put-down-lift-1001-solid-low-narrow-01 item-03) 10022) (= (y-of-put-down-lift-1001-solid-low-narrow-01 item-03) 9984) (= (z-of-put-down-lift-1001-solid-low-narrow-01 item-03) 8015)
    (can-lift-1001b-solid-low-narrow-01 item-03) (= (x-of-lift-1001b-solid-low-narrow-01 item-03) 10387) (= (y-of-lift-1001b-solid-low-narrow-01 item-03) 9482) (= (z-of-lift-1001b-solid-low-narrow-01 item-03) 12004) (= (cost-of-lift-1001b-solid-low-narrow-01 item-03) 4)
    (= (x-of-put-down-lift-1001b-solid-low-narrow-01 item-03) 9998) (= (y-of-put-down-lift-1001b-solid-low-narrow-01 item-03) 9987) (= (z-of-put-down-lift-1001b-solid-low-narrow-01 item-03) 7996)
    (can-lift-1010-solid-low-narrow-01 item-03) (= (x-of-lift-1010-solid-low-narrow-01 item-03) 10331) (= (y-of-lift-1010-solid-low-narrow-01 item-03) 10441) (= (z-of-lift-1010-solid-low-narrow-01 item-03) 11985) (= (cost-of-lift-1010-solid-low-narrow-01 item-03) 4)
    (= (x-of-put-down-lift-1010-solid-low-narrow-01 item-03) 10021) (= (y-of-put-down-lift-1010-solid-low-narrow-01 item-03) 9984) (= (z-of-put-down-lift-1010-solid-low-narrow-01 item-03) 8015)
    (= (x-of-place-back-0000-solid-low-narrow-01 item-03) 9111) (= (y-of-place-back-0000-solid-low-narrow-01 item-03) 9942) (= (cost-of-place-back-0000-solid-low-narrow-01 item-03) 278)
    (can-place-right-0111b-solid-low-narrow-01 item-03) (= (x-of-place-right-0111b-solid-low-narrow-01 item-03) 10145) (= (y-of-place-right-0111b-solid-low-narrow-01 item-03) 9462) (= (cost-of-place-right-0111b-solid-low-narrow-01 item-03) 4)
    (can-pull-1100b-solid-low-narrow-01 item-03) (= (x-of-pull-1100b-solid-low-narrow-01 item-03) 9421) (= (y-of-pull-1100b-solid-low-narrow-01 item-03) 10166) (= (cost-of-pull-1100b-solid-low-narrow-01 item-03) 4)
    (can-pull-right-0100b-solid-low-narrow-01 item-03) (= (x-of-pull-right-0100b-solid-low-narrow-01 item-03) 9314) (= (y-of-pull-right-0100b-solid-low-narrow-01 item-03) 9629) (= (cost-of-pull-right-0100b-solid-low-narrow-01 item-03) 4)
    (can-pull-right-0110b-solid-low-narrow-01 item-03) (= (x-of-pull-right-0110b-solid-low-narrow-01 item-03) 9852) (= (y-of-pull-right-0110b-solid-low-narrow-01 item-03) 9920) (= (cost-of-pull-right-0110b-solid-low-narrow-01 item-03) 14)
    (can-pull-right-0111-solid-low-narrow-01 item-03) (= (x-of-pull-right-0111-solid-low-narrow-01 item-03) 9733) (= (y-of-pull-right-0111-solid-low-narrow-01 item-03) 9643) (= (cost-of-pull-right-0111-solid-low-narrow-01 item-03) 4)
    (can-push-forward-1011-solid-low-narrow-01 item-03) (= (x-of-push-forward-1011-solid-low-narrow-01 item-03) 11000) (= (y-of-push-forward-1011-solid-low-narrow-01 item-03) 10252) (= (cost-of-push-forward-1011-solid-low-narrow-01 item-03) 4)
    (can-push-forward-right-1111-solid-low-narrow-01 item-03) (= (x-of-push-forward-right-1111-solid-low-narrow-01 item-03) 10623) (= (y-of-push-forward-right-1111-solid-low-narrow-01 item-03) 9568) (= (cost-of-push-forward-right-1111-solid-low-narrow-01 item-03) 4)
    (can-push-left-0110-solid-low-narrow-01 item-03) (= (x-of-push-left-0110-solid-low-narrow-01 item-03) 9774) (= (y-of-push-left-0110-solid-low-narrow-01 item-03) 10656) (= (cost-of-push-left-0110-solid-low-narrow-01 item-03) 4)
    (can-push-left-1101-solid-low-narrow-01 item-03) (= (x-of-push-left-1101-solid-low-narrow-01 item-03) 9964) (= (y-of-push-left-1101-solid-low-narrow-01 item-03) 10368) (= (cost-of-push-left-1101-solid-low-narrow-01 item-03) 4)
    (can-push-left-1110b-solid-low-narrow-01 item-03) (= (x-of-push-left-1110b-solid-low-narrow-01 item-03) 10291) (= (y-of-push-left-1110b-solid-low-narrow-01 item-03) 11220) (= (cost-of-push-left-1110b-solid-low-narrow-01 item-03) 7)
    (can-push-right-0101b-solid-low-narrow-01 item-03) (= (x-of-push-right-0101b-solid-low-narrow-01 item-03) 9846) (= (y-of-push-right-0101b-solid-low-narrow-01 item-03) 8686) (= (cost-of-push-right-0101b-solid-low-narrow-01 item-03) 7)
    (= (x-of-push-right-1001-solid-low-narrow-01 item-03) 9986) (= (y-of-push-right-1001-solid-low-narrow-01 item-03) 9754) (= (cost-of-push-right-1001-solid-low-narrow-01 item-03) 278)
    ; item-04 starts at (0.9168, -0.0227, 0.0124) m
    (= (x item-04) 5668) (= (y item-04) 2773) (= (z item-04) 0)
    ; What each operator promises for item-04 (features 0.06152 0.1669 0.0247 0).
    ; Not for item-04:
    ; lift-0010-solid-low-10: keeps its promise in 1 of 31 rehearsals only.
    ; lift-1001c-solid-low-10: keeps its promise in 1 of 31 rehearsals only.
    ; push-right-0010-solid-low-10: scatters more than it moves.
    ; stay-1101-solid-low-10: moves less than half a cell.
    (= (x-of-lift-0010-solid-low-10 item-04) 10273) (= (y-of-lift-0010-solid-low-10 item-04) 10236) (= (z-of-lift-0010-solid-low-10 item-04) 12324) (= (cost-of-lift-0010-solid-low-10 item-04) 281)
    (= (x-of-put-down-lift-0010-solid-low-10 item-04) 10004) (= (y-of-put-down-lift-0010-solid-low-10 item-04) 9993) (= (z-of-put-down-lift-0010-solid-low-10 item-04) 7676)
    (= (x-of-lift-1001c-solid-low-10 item-04) 10286) (= (y-of-lift-1001c-solid-low-10 item-04) 9501) (= (z-of-lift-1001c-solid-low-10 item-04) 12013) (= (cost-of-lift-1001c-solid-low-10 item-04) 281)
    (= (x-of-put-down-lift-1001c-solid-low-10 item-04) 9990) (= (y-of-put-down-lift-1001c-solid-low-10 item-04) 9989) (= (z-of-put-down-lift-1001c-solid-low-10 item-04) 7987)
    (can-pull-0000b-solid-low-10 item-04) (= (x-of-pull-0000b-solid-low-10 item-04) 9656) (= (y-of-pull-0000b-solid-low-10 item-04) 9904) (= (cost-of-pull-0000b-solid-low-10 item-04) 14)
    (can-pull-0100-solid-low-10 item-04) (= (x-of-pull-0100-solid-low-10 item-04) 9221) (= (y-of-pull-0100-solid-low-10 item-04) 9917) (= (cost-of-pull-0100-solid-low-10 item-04) 7)
    (can-pull-0100c-solid-low-10 item-04) (= (x-of-pull-0100c-solid-low-10 item-04) 9214) (= (y-of-pull-0100c-solid-low-10 item-04) 10267) (= (cost-of-pull-0100c-solid-low-10 item-04) 11)
    (can-pull-0110c-solid-low-10 item-04) (= (x-of-pull-0110c-solid-low-10 item-04) 9862) (= (y-of-pull-0110c-solid-low-10 item-04) 10098) (= (cost-of-pull-0110c-solid-low-10 item-04) 4)
    (can-pull-left-1110c-solid-low-10 item-04) (= (x-of-pull-left-1110c-solid-low-10 item-04) 9627) (= (y-of-pull-left-1110c-solid-low-10 item-04) 10227) (= (cost-of-pull-left-1110c-solid-low-10 item-04) 4)
    (can-push-forward-0101c-solid-low-10 item-04) (= (x-of-push-forward-0101c-solid-low-10 item-04) 10335) (= (y-of-push-forward-0101c-solid-low-10 item-04) 10034) (= (cost-of-push-forward-0101c-solid-low-10 item-04) 14)
    (can-push-forward-1011-solid-low-10 item-04) (= (x-of-push-forward-1011-solid-low-10 item-04) 10906) (= (y-of-push-forward-1011-solid-low-10 item-04) 10091) (= (cost-of-push-forward-1011-solid-low-10 item-04) 4)
    (can-push-forward-left-1001c-solid-low-10 item-04) (= (x-of-push-forward-left-1001c-solid-low-10 item-04) 10716) (= (y-of-push-forward-left-1001c-solid-low-10 item-04) 10328) (= (cost-of-push-forward-left-1001c-solid-low-10 item-04) 33)
    (can-push-forward-left-1010-solid-low-10 item-04) (= (x-of-push-forward-left-1010-solid-low-10 item-04) 10270) (= (y-of-push-forward-left-1010-solid-low-10 item-04) 10309) (= (cost-of-push-forward-left-1010-solid-low-10 item-04) 7)
    (can-push-forward-left-1100c-solid-low-10 item-04) (= (x-of-push-forward-left-1100c-solid-low-10 item-04) 10228) (= (y-of-push-forward-left-1100c-solid-low-10 item-04) 10336) (= (cost-of-push-forward-left-1100c-solid-low-10 item-04) 7)
    (can-push-forward-right-0111c-solid-low-10 item-04) (= (x-of-push-forward-right-0111c-solid-low-10 item-04) 10763) (= (y-of-push-forward-right-0111c-solid-low-10 item-04) 8970) (= (cost-of-push-forward-right-0111c-solid-low-10 item-04) 67)
    (can-push-forward-right-1111-solid-low-10 item-04) (= (x-of-push-forward-right-1111-solid-low-10 item-04) 10118) (= (y-of-push-forward-right-1111-solid-low-10 item-04) 9729) (= (cost-of-push-forward-right-1111-solid-low-10 item-04) 7)
    (can-push-left-1000-solid-low-10 item-04) (= (x-of-push-left-1000-solid-low-10 item-04) 9854) (= (y-of-push-left-1000-solid-low-10 item-04) 10434) (= (cost-of-push-left-1000-solid-low-10 item-04) 7)
    (can-push-right-0001b-solid-low-10 item-04) (= (x-of-push-right-0001b-solid-low-10 item-04) 9804) (= (y-of-push-right-0001b-solid-low-10 item-04) 9405) (= (cost-of-push-right-0001b-solid-low-10 item-04) 11)
    (= (x-of-push-right-0010-solid-low-10 item-04) 10101) (= (y-of-push-right-0010-solid-low-10 item-04) 9864) (= (cost-of-push-right-0010-solid-low-10 item-04) 7)
    (can-push-right-0011-solid-low-10 item-04) (= (x-of-push-right-0011-solid-low-10 item-04) 10112) (= (y-of-push-right-0011-solid-low-10 item-04) 9607) (= (cost-of-push-right-0011-solid-low-10 item-04) 17)
    (= (x-of-stay-1101-solid-low-10 item-04) 10009) (= (y-of-stay-1101-solid-low-10 item-04) 10004) (= (cost-of-stay-1101-solid-low-10 item-04) 11)
    ; item-05 starts at (0.5170, 0.1723, 0.0270) m
    (= (x item-05) 1670) (= (y item-05) 4723) (= (z item-05) 0)
    ; What each operator promises for item-05 (features 0.1752 0.1752 0.05405 2).
    ; Not for item-05:
    ; lift-0000-hollow-wide-00: keeps its promise in 1 of 30 rehearsals only.
    ; lift-0011-hollow-wide-00: keeps its promise with such objects in about 3 of 30 only.
    ; lift-1101-hollow-wide-00: keeps its promise with such objects in about 6 of 30 only.
    ; push-forward-1011a-hollow-wide-00: scatters more than it moves.
    (= (x-of-lift-0000-hollow-wide-00 item-05) 9412) (= (y-of-lift-0000-hollow-wide-00 item-05) 9239) (= (z-of-lift-0000-hollow-wide-00 item-05) 11977) (= (cost-of-lift-0000-hollow-wide-00 item-05) 278)
    (= (x-of-put-down-lift-0000-hollow-wide-00 item-05) 9985) (= (y-of-put-down-lift-0000-hollow-wide-00 item-05) 9984) (= (z-of-put-down-lift-0000-hollow-wide-00 item-05) 8023)
    (can-lift-0001-hollow-wide-00 item-05) (= (x-of-lift-0001-hollow-wide-00 item-05) 9644) (= (y-of-lift-0001-hollow-wide-00 item-05) 8928) (= (z-of-lift-0001-hollow-wide-00 item-05) 12500) (= (cost-of-lift-0001-hollow-wide-00 item-05) 4)
    (= (x-of-put-down-lift-0001-hollow-wide-00 item-05) 9999) (= (y-of-put-down-lift-0001-hollow-wide-00 item-05) 9964) (= (z-of-put-down-lift-0001-hollow-wide-00 item-05) 7500)
    (can-lift-0010a-hollow-wide-00 item-05) (= (x-of-lift-0010a-hollow-wide-00 item-05) 10068) (= (y-of-lift-0010a-hollow-wide-00 item-05) 9629) (= (z-of-lift-0010a-hollow-wide-00 item-05) 11970) (= (cost-of-lift-0010a-hollow-wide-00 item-05) 48)
    (= (x-of-put-down-lift-0010a-hollow-wide-00 item-05) 9997) (= (y-of-put-down-lift-0010a-hollow-wide-00 item-05) 9973) (= (z-of-put-down-lift-0010a-hollow-wide-00 item-05) 8030)
    (= (x-of-lift-0011-hollow-wide-00 item-05) 10280) (= (y-of-lift-0011-hollow-wide-00 item-05) 8680) (= (z-of-lift-0011-hollow-wide-00 item-05) 11958) (= (cost-of-lift-0011-hollow-wide-00 item-05) 209)
    (= (x-of-put-down-lift-0011-hollow-wide-00 item-05) 10002) (= (y-of-put-down-lift-0011-hollow-wide-00 item-05) 9964) (= (z-of-put-down-lift-0011-hollow-wide-00 item-05) 8042)
    (can-lift-0011a-hollow-wide-00 item-05) (= (x-of-lift-0011a-hollow-wide-00 item-05) 10523) (= (y-of-lift-0011a-hollow-wide-00 item-05) 9077) (= (z-of-lift-0011a-hollow-wide-00 item-05) 12503) (= (cost-of-lift-0011a-hollow-wide-00 item-05) 4)
    (= (x-of-put-down-lift-0011a-hollow-wide-00 item-05) 9998) (= (y-of-put-down-lift-0011a-hollow-wide-00 item-05) 9961) (= (z-of-put-down-lift-0011a-hollow-wide-00 item-05) 7497)
    (can-lift-1000-hollow-wide-00 item-05) (= (x-of-lift-1000-hollow-wide-00 item-05) 9726) (= (y-of-lift-1000-hollow-wide-00 item-05) 11205) (= (z-of-lift-1000-hollow-wide-00 item-05) 11993) (= (cost-of-lift-1000-hollow-wide-00 item-05) 4)
    (= (x-of-put-down-lift-1000-hollow-wide-00 item-05) 10000) (= (y-of-put-down-lift-1000-hollow-wide-00 item-05) 9972) (= (z-of-put-down-lift-1000-hollow-wide-00 item-05) 8007)
    (can-lift-1000a-hollow-wide-00 item-05) (= (x-of-lift-1000a-hollow-wide-00 item-05) 9585) (= (y-of-lift-1000a-hollow-wide-00 item-05) 10576) (= (z-of-lift-1000a-hollow-wide-00 item-05) 12453) (= (cost-of-lift-1000a-hollow-wide-00 item-05) 4)
    (= (x-of-put-down-lift-1000a-hollow-wide-00 item-05) 9998) (= (y-of-put-down-lift-1000a-hollow-wide-00 item-05) 9966) (= (z-of-put-down-lift-1000a-hollow-wide-00 item-05) 7547)
    (can-lift-1001a-hollow-wide-00 item-05) (= (x-of-lift-1001a-hollow-wide-00 item-05) 10199) (= (y-of-lift-1001a-hollow-wide-00 item-05) 10439) (= (z-of-lift-1001a-hollow-wide-00 item-05) 12168) (= (cost-of-lift-1001a-hollow-wide-00 item-05) 4)
    (= (x-of-put-down-lift-1001a-hollow-wide-00 item-05) 9995) (= (y-of-put-down-lift-1001a-hollow-wide-00 item-05) 9977) (= (z-of-put-down-lift-1001a-hollow-wide-00 item-05) 7832)
    (can-lift-1010a-hollow-wide-00 item-05) (= (x-of-lift-1010a-hollow-wide-00 item-05) 10283) (= (y-of-lift-1010a-hollow-wide-00 item-05) 11080) (= (z-of-lift-1010a-hollow-wide-00 item-05) 11998) (= (cost-of-lift-1010a-hollow-wide-00 item-05) 4)
    (= (x-of-put-down-lift-1010a-hollow-wide-00 item-05) 9999) (= (y-of-put-down-lift-1010a-hollow-wide-00 item-05) 9972) (= (z-of-put-down-lift-1010a-hollow-wide-00 item-05) 8002)
    (= (x-of-lift-1101-hollow-wide-00 item-05) 10263) (= (y-of-lift-1101-hollow-wide-00 item-05) 10152) (= (z-of-lift-1101-hollow-wide-00 item-05) 12000) (= (cost-of-lift-1101-hollow-wide-00 item-05) 153)
    (= (x-of-put-down-lift-1101-hollow-wide-00 item-05) 10001) (= (y-of-put-down-lift-1101-hollow-wide-00 item-05) 10009) (= (z-of-put-down-lift-1101-hollow-wide-00 item-05) 8000)
    (can-place-back-right-0000-hollow-wide-00 item-05) (= (x-of-place-back-right-0000-hollow-wide-00 item-05) 9761) (= (y-of-place-back-right-0000-hollow-wide-00 item-05) 9423) (= (cost-of-place-back-right-0000-hollow-wide-00 item-05) 34)
    (can-place-right-0111-hollow-wide-00 item-05) (= (x-of-place-right-0111-hollow-wide-00 item-05) 9589) (= (y-of-place-right-0111-hollow-wide-00 item-05) 8815) (= (cost-of-place-right-0111-hollow-wide-00 item-05) 4)
    (can-place-right-0111a-hollow-wide-00 item-05) (= (x-of-place-right-0111a-hollow-wide-00 item-05) 10235) (= (y-of-place-right-0111a-hollow-wide-00 item-05) 8872) (= (cost-of-place-right-0111a-hollow-wide-00 item-05) 4)
    (can-pull-0100-hollow-wide-00 item-05) (= (x-of-pull-0100-hollow-wide-00 item-05) 9759) (= (y-of-pull-0100-hollow-wide-00 item-05) 9970) (= (cost-of-pull-0100-hollow-wide-00 item-05) 11)
    (can-pull-left-0110a-hollow-wide-00 item-05) (= (x-of-pull-left-0110a-hollow-wide-00 item-05) 9660) (= (y-of-pull-left-0110a-hollow-wide-00 item-05) 10288) (= (cost-of-pull-left-0110a-hollow-wide-00 item-05) 4)
    (can-pull-right-0100a-hollow-wide-00 item-05) (= (x-of-pull-right-0100a-hollow-wide-00 item-05) 9690) (= (y-of-pull-right-0100a-hollow-wide-00 item-05) 9691) (= (cost-of-pull-right-0100a-hollow-wide-00 item-05) 4)
    (can-pull-right-0110-hollow-wide-00 item-05) (= (x-of-pull-right-0110-hollow-wide-00 item-05) 9952) (= (y-of-pull-right-0110-hollow-wide-00 item-05) 9681) (= (cost-of-pull-right-0110-hollow-wide-00 item-05) 4)
    (= (x-of-push-forward-1011a-hollow-wide-00 item-05) 10222) (= (y-of-push-forward-1011a-hollow-wide-00 item-05) 9958) (= (cost-of-push-forward-1011a-hollow-wide-00 item-05) 11)
    (can-push-forward-1110a-hollow-wide-00 item-05) (= (x-of-push-forward-1110a-hollow-wide-00 item-05) 10303) (= (y-of-push-forward-1110a-hollow-wide-00 item-05) 9907) (= (cost-of-push-forward-1110a-hollow-wide-00 item-05) 4)
    (can-push-forward-left-1111a-hollow-wide-00 item-05) (= (x-of-push-forward-left-1111a-hollow-wide-00 item-05) 10298) (= (y-of-push-forward-left-1111a-hollow-wide-00 item-05) 10446) (= (cost-of-push-forward-left-1111a-hollow-wide-00 item-05) 4)
    (can-push-forward-right-0101a-hollow-wide-00 item-05) (= (x-of-push-forward-right-0101a-hollow-wide-00 item-05) 10426) (= (y-of-push-forward-right-0101a-hollow-wide-00 item-05) 9546) (= (cost-of-push-forward-right-0101a-hollow-wide-00 item-05) 4)
    (can-push-left-1100a-hollow-wide-00 item-05) (= (x-of-push-left-1100a-hollow-wide-00 item-05) 9616) (= (y-of-push-left-1100a-hollow-wide-00 item-05) 10988) (= (cost-of-push-left-1100a-hollow-wide-00 item-05) 7)
    (can-push-right-0010a-hollow-wide-00 item-05) (= (x-of-push-right-0010a-hollow-wide-00 item-05) 9969) (= (y-of-push-right-0010a-hollow-wide-00 item-05) 9408) (= (cost-of-push-right-0010a-hollow-wide-00 item-05) 99)
    (can-push-right-0011-hollow-wide-00 item-05) (= (x-of-push-right-0011-hollow-wide-00 item-05) 10044) (= (y-of-push-right-0011-hollow-wide-00 item-05) 9468) (= (cost-of-push-right-0011-hollow-wide-00 item-05) 14)
    (can-push-right-1101-hollow-wide-00 item-05) (= (x-of-push-right-1101-hollow-wide-00 item-05) 9959) (= (y-of-push-right-1101-hollow-wide-00 item-05) 9359) (= (cost-of-push-right-1101-hollow-wide-00 item-05) 26)
    ; item-06 starts at (0.7660, -0.1534, 0.0323) m
    (= (x item-06) 4160) (= (y item-06) 1466) (= (z item-06) 0)
    ; What each operator promises for item-06 (features 0.08744 0.1137 0.0645 1).
    ; Not for item-06:
    ; lift-1000-any-tall-narrow-11: keeps its promise with such objects in about 6 of 30 only.
    ; lift-1101a-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    ; pull-right-0011c-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    ; push-left-1000-any-tall-narrow-11: scatters more than it moves.
    ; push-right-0001-any-tall-narrow-11: keeps its promise in 2 of 30 rehearsals only.
    ; push-right-0001a-any-tall-narrow-11: scatters more than it moves.
    (can-lift-0000c-any-tall-narrow-11 item-06) (= (x-of-lift-0000c-any-tall-narrow-11 item-06) 9441) (= (y-of-lift-0000c-any-tall-narrow-11 item-06) 10489) (= (z-of-lift-0000c-any-tall-narrow-11 item-06) 12036) (= (cost-of-lift-0000c-any-tall-narrow-11 item-06) 4)
    (= (x-of-put-down-lift-0000c-any-tall-narrow-11 item-06) 10000) (= (y-of-put-down-lift-0000c-any-tall-narrow-11 item-06) 9995) (= (z-of-put-down-lift-0000c-any-tall-narrow-11 item-06) 7964)
    (can-lift-0001-any-tall-narrow-11 item-06) (= (x-of-lift-0001-any-tall-narrow-11 item-06) 9712) (= (y-of-lift-0001-any-tall-narrow-11 item-06) 9232) (= (z-of-lift-0001-any-tall-narrow-11 item-06) 12480) (= (cost-of-lift-0001-any-tall-narrow-11 item-06) 11)
    (= (x-of-put-down-lift-0001-any-tall-narrow-11 item-06) 10005) (= (y-of-put-down-lift-0001-any-tall-narrow-11 item-06) 9979) (= (z-of-put-down-lift-0001-any-tall-narrow-11 item-06) 7520)
    (can-lift-0001a-any-tall-narrow-11 item-06) (= (x-of-lift-0001a-any-tall-narrow-11 item-06) 9845) (= (y-of-lift-0001a-any-tall-narrow-11 item-06) 9560) (= (z-of-lift-0001a-any-tall-narrow-11 item-06) 11998) (= (cost-of-lift-0001a-any-tall-narrow-11 item-06) 53)
    (= (x-of-put-down-lift-0001a-any-tall-narrow-11 item-06) 10002) (= (y-of-put-down-lift-0001a-any-tall-narrow-11 item-06) 9986) (= (z-of-put-down-lift-0001a-any-tall-narrow-11 item-06) 8002)
    (can-lift-0010b-any-tall-narrow-11 item-06) (= (x-of-lift-0010b-any-tall-narrow-11 item-06) 10328) (= (y-of-lift-0010b-any-tall-narrow-11 item-06) 10241) (= (z-of-lift-0010b-any-tall-narrow-11 item-06) 12371) (= (cost-of-lift-0010b-any-tall-narrow-11 item-06) 4)
    (= (x-of-put-down-lift-0010b-any-tall-narrow-11 item-06) 10003) (= (y-of-put-down-lift-0010b-any-tall-narrow-11 item-06) 9994) (= (z-of-put-down-lift-0010b-any-tall-narrow-11 item-06) 7629)
    (can-lift-0011-any-tall-narrow-11 item-06) (= (x-of-lift-0011-any-tall-narrow-11 item-06) 10309) (= (y-of-lift-0011-any-tall-narrow-11 item-06) 9099) (= (z-of-lift-0011-any-tall-narrow-11 item-06) 11996) (= (cost-of-lift-0011-any-tall-narrow-11 item-06) 43)
    (= (x-of-put-down-lift-0011-any-tall-narrow-11 item-06) 10001) (= (y-of-put-down-lift-0011-any-tall-narrow-11 item-06) 9984) (= (z-of-put-down-lift-0011-any-tall-narrow-11 item-06) 8004)
    (can-lift-0011c-any-tall-narrow-11 item-06) (= (x-of-lift-0011c-any-tall-narrow-11 item-06) 9830) (= (y-of-lift-0011c-any-tall-narrow-11 item-06) 9688) (= (z-of-lift-0011c-any-tall-narrow-11 item-06) 12630) (= (cost-of-lift-0011c-any-tall-narrow-11 item-06) 7)
    (= (x-of-put-down-lift-0011c-any-tall-narrow-11 item-06) 10002) (= (y-of-put-down-lift-0011c-any-tall-narrow-11 item-06) 9997) (= (z-of-put-down-lift-0011c-any-tall-narrow-11 item-06) 7370)
    (= (x-of-lift-1000-any-tall-narrow-11 item-06) 9702) (= (y-of-lift-1000-any-tall-narrow-11 item-06) 10692) (= (z-of-lift-1000-any-tall-narrow-11 item-06) 12061) (= (cost-of-lift-1000-any-tall-narrow-11 item-06) 153)
    (= (x-of-put-down-lift-1000-any-tall-narrow-11 item-06) 9999) (= (y-of-put-down-lift-1000-any-tall-narrow-11 item-06) 9982) (= (z-of-put-down-lift-1000-any-tall-narrow-11 item-06) 7939)
    (can-lift-1001d-any-tall-narrow-11 item-06) (= (x-of-lift-1001d-any-tall-narrow-11 item-06) 10563) (= (y-of-lift-1001d-any-tall-narrow-11 item-06) 9553) (= (z-of-lift-1001d-any-tall-narrow-11 item-06) 11994) (= (cost-of-lift-1001d-any-tall-narrow-11 item-06) 4)
    (= (x-of-put-down-lift-1001d-any-tall-narrow-11 item-06) 10005) (= (y-of-put-down-lift-1001d-any-tall-narrow-11 item-06) 9995) (= (z-of-put-down-lift-1001d-any-tall-narrow-11 item-06) 8006)
    (can-lift-1010b-any-tall-narrow-11 item-06) (= (x-of-lift-1010b-any-tall-narrow-11 item-06) 10280) (= (y-of-lift-1010b-any-tall-narrow-11 item-06) 10232) (= (z-of-lift-1010b-any-tall-narrow-11 item-06) 12001) (= (cost-of-lift-1010b-any-tall-narrow-11 item-06) 4)
    (= (x-of-put-down-lift-1010b-any-tall-narrow-11 item-06) 10001) (= (y-of-put-down-lift-1010b-any-tall-narrow-11 item-06) 9995) (= (z-of-put-down-lift-1010b-any-tall-narrow-11 item-06) 7999)
    (= (x-of-lift-1101a-any-tall-narrow-11 item-06) 10286) (= (y-of-lift-1101a-any-tall-narrow-11 item-06) 10264) (= (z-of-lift-1101a-any-tall-narrow-11 item-06) 12039) (= (cost-of-lift-1101a-any-tall-narrow-11 item-06) 278)
    (= (x-of-put-down-lift-1101a-any-tall-narrow-11 item-06) 10042) (= (y-of-put-down-lift-1101a-any-tall-narrow-11 item-06) 10027) (= (z-of-put-down-lift-1101a-any-tall-narrow-11 item-06) 7961)
    (can-place-forward-right-0111d-any-tall-narrow-11 item-06) (= (x-of-place-forward-right-0111d-any-tall-narrow-11 item-06) 10247) (= (y-of-place-forward-right-0111d-any-tall-narrow-11 item-06) 9846) (= (cost-of-place-forward-right-0111d-any-tall-narrow-11 item-06) 4)
    (can-pull-0100-any-tall-narrow-11 item-06) (= (x-of-pull-0100-any-tall-narrow-11 item-06) 8997) (= (y-of-pull-0100-any-tall-narrow-11 item-06) 9577) (= (cost-of-pull-0100-any-tall-narrow-11 item-06) 4)
    (can-pull-0110d-any-tall-narrow-11 item-06) (= (x-of-pull-0110d-any-tall-narrow-11 item-06) 9631) (= (y-of-pull-0110d-any-tall-narrow-11 item-06) 9932) (= (cost-of-pull-0110d-any-tall-narrow-11 item-06) 4)
    (can-pull-left-1110d-any-tall-narrow-11 item-06) (= (x-of-pull-left-1110d-any-tall-narrow-11 item-06) 9784) (= (y-of-pull-left-1110d-any-tall-narrow-11 item-06) 10113) (= (cost-of-pull-left-1110d-any-tall-narrow-11 item-06) 22)
    (= (x-of-pull-right-0011c-any-tall-narrow-11 item-06) 9570) (= (y-of-pull-right-0011c-any-tall-narrow-11 item-06) 9392) (= (cost-of-pull-right-0011c-any-tall-narrow-11 item-06) 278)
    (can-pull-right-0100d-any-tall-narrow-11 item-06) (= (x-of-pull-right-0100d-any-tall-narrow-11 item-06) 9486) (= (y-of-pull-right-0100d-any-tall-narrow-11 item-06) 9700) (= (cost-of-pull-right-0100d-any-tall-narrow-11 item-06) 4)
    (can-push-forward-1011-any-tall-narrow-11 item-06) (= (x-of-push-forward-1011-any-tall-narrow-11 item-06) 11033) (= (y-of-push-forward-1011-any-tall-narrow-11 item-06) 10258) (= (cost-of-push-forward-1011-any-tall-narrow-11 item-06) 11)
    (can-push-forward-1011b-any-tall-narrow-11 item-06) (= (x-of-push-forward-1011b-any-tall-narrow-11 item-06) 10830) (= (y-of-push-forward-1011b-any-tall-narrow-11 item-06) 10003) (= (cost-of-push-forward-1011b-any-tall-narrow-11 item-06) 4)
    (can-push-forward-1111b-any-tall-narrow-11 item-06) (= (x-of-push-forward-1111b-any-tall-narrow-11 item-06) 10393) (= (y-of-push-forward-1111b-any-tall-narrow-11 item-06) 10015) (= (cost-of-push-forward-1111b-any-tall-narrow-11 item-06) 4)
    (can-push-forward-left-1100d-any-tall-narrow-11 item-06) (= (x-of-push-forward-left-1100d-any-tall-narrow-11 item-06) 10129) (= (y-of-push-forward-left-1100d-any-tall-narrow-11 item-06) 10257) (= (cost-of-push-forward-left-1100d-any-tall-narrow-11 item-06) 4)
    (can-push-forward-right-1111-any-tall-narrow-11 item-06) (= (x-of-push-forward-right-1111-any-tall-narrow-11 item-06) 10151) (= (y-of-push-forward-right-1111-any-tall-narrow-11 item-06) 9735) (= (cost-of-push-forward-right-1111-any-tall-narrow-11 item-06) 43)
    (= (x-of-push-left-1000-any-tall-narrow-11 item-06) 9978) (= (y-of-push-left-1000-any-tall-narrow-11 item-06) 10114) (= (cost-of-push-left-1000-any-tall-narrow-11 item-06) 26)
    (can-push-left-1101a-any-tall-narrow-11 item-06) (= (x-of-push-left-1101a-any-tall-narrow-11 item-06) 10118) (= (y-of-push-left-1101a-any-tall-narrow-11 item-06) 10238) (= (cost-of-push-left-1101a-any-tall-narrow-11 item-06) 7)
    (= (x-of-push-right-0001-any-tall-narrow-11 item-06) 9862) (= (y-of-push-right-0001-any-tall-narrow-11 item-06) 9742) (= (cost-of-push-right-0001-any-tall-narrow-11 item-06) 238)
    (= (x-of-push-right-0001a-any-tall-narrow-11 item-06) 9987) (= (y-of-push-right-0001a-any-tall-narrow-11 item-06) 9835) (= (cost-of-push-right-0001a-any-tall-narrow-11 item-06) 108)
    (can-push-right-0011-any-tall-narrow-11 item-06) (= (x-of-push-right-0011-any-tall-narrow-11 item-06) 10044) (= (y-of-push-right-0011-any-tall-narrow-11 item-06) 9803) (= (cost-of-push-right-0011-any-tall-narrow-11 item-06) 117)
    (can-push-right-0101d-any-tall-narrow-11 item-06) (= (x-of-push-right-0101d-any-tall-narrow-11 item-06) 9996) (= (y-of-push-right-0101d-any-tall-narrow-11 item-06) 9561) (= (cost-of-push-right-0101d-any-tall-narrow-11 item-06) 14)
    (can-push-right-0111-any-tall-narrow-11 item-06) (= (x-of-push-right-0111-any-tall-narrow-11 item-06) 9861) (= (y-of-push-right-0111-any-tall-narrow-11 item-06) 9492) (= (cost-of-push-right-0111-any-tall-narrow-11 item-06) 48)
    ; item-07 starts at (0.4498, -0.1875, 0.0457) m
    (= (x item-07) 998) (= (y item-07) 1125) (= (z item-07) 0)
    ; What each operator promises for item-07 (features 0.08772 0.1088 0.09133 1).
    ; Not for item-07:
    ; lift-1000-any-tall-narrow-11: keeps its promise with such objects in about 3 of 30 only.
    ; lift-1101a-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    ; pull-left-1110d-any-tall-narrow-11: moves less than half a cell.
    ; pull-right-0011c-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    ; push-left-1000-any-tall-narrow-11: scatters more than it moves.
    ; push-right-0001a-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    ; push-right-0011-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    (can-lift-0000c-any-tall-narrow-11 item-07) (= (x-of-lift-0000c-any-tall-narrow-11 item-07) 9437) (= (y-of-lift-0000c-any-tall-narrow-11 item-07) 10493) (= (z-of-lift-0000c-any-tall-narrow-11 item-07) 12073) (= (cost-of-lift-0000c-any-tall-narrow-11 item-07) 4)
    (= (x-of-put-down-lift-0000c-any-tall-narrow-11 item-07) 10000) (= (y-of-put-down-lift-0000c-any-tall-narrow-11 item-07) 9992) (= (z-of-put-down-lift-0000c-any-tall-narrow-11 item-07) 7927)
    (can-lift-0001-any-tall-narrow-11 item-07) (= (x-of-lift-0001-any-tall-narrow-11 item-07) 9703) (= (y-of-lift-0001-any-tall-narrow-11 item-07) 9298) (= (z-of-lift-0001-any-tall-narrow-11 item-07) 12472) (= (cost-of-lift-0001-any-tall-narrow-11 item-07) 91)
    (= (x-of-put-down-lift-0001-any-tall-narrow-11 item-07) 10007) (= (y-of-put-down-lift-0001-any-tall-narrow-11 item-07) 9979) (= (z-of-put-down-lift-0001-any-tall-narrow-11 item-07) 7528)
    (can-lift-0001a-any-tall-narrow-11 item-07) (= (x-of-lift-0001a-any-tall-narrow-11 item-07) 9862) (= (y-of-lift-0001a-any-tall-narrow-11 item-07) 9636) (= (z-of-lift-0001a-any-tall-narrow-11 item-07) 11998) (= (cost-of-lift-0001a-any-tall-narrow-11 item-07) 7)
    (= (x-of-put-down-lift-0001a-any-tall-narrow-11 item-07) 10003) (= (y-of-put-down-lift-0001a-any-tall-narrow-11 item-07) 9991) (= (z-of-put-down-lift-0001a-any-tall-narrow-11 item-07) 8002)
    (can-lift-0010b-any-tall-narrow-11 item-07) (= (x-of-lift-0010b-any-tall-narrow-11 item-07) 10334) (= (y-of-lift-0010b-any-tall-narrow-11 item-07) 10241) (= (z-of-lift-0010b-any-tall-narrow-11 item-07) 12363) (= (cost-of-lift-0010b-any-tall-narrow-11 item-07) 4)
    (= (x-of-put-down-lift-0010b-any-tall-narrow-11 item-07) 9995) (= (y-of-put-down-lift-0010b-any-tall-narrow-11 item-07) 9993) (= (z-of-put-down-lift-0010b-any-tall-narrow-11 item-07) 7637)
    (can-lift-0011-any-tall-narrow-11 item-07) (= (x-of-lift-0011-any-tall-narrow-11 item-07) 10289) (= (y-of-lift-0011-any-tall-narrow-11 item-07) 9241) (= (z-of-lift-0011-any-tall-narrow-11 item-07) 11995) (= (cost-of-lift-0011-any-tall-narrow-11 item-07) 7)
    (= (x-of-put-down-lift-0011-any-tall-narrow-11 item-07) 10003) (= (y-of-put-down-lift-0011-any-tall-narrow-11 item-07) 9989) (= (z-of-put-down-lift-0011-any-tall-narrow-11 item-07) 8005)
    (can-lift-0011c-any-tall-narrow-11 item-07) (= (x-of-lift-0011c-any-tall-narrow-11 item-07) 9820) (= (y-of-lift-0011c-any-tall-narrow-11 item-07) 9689) (= (z-of-lift-0011c-any-tall-narrow-11 item-07) 12626) (= (cost-of-lift-0011c-any-tall-narrow-11 item-07) 7)
    (= (x-of-put-down-lift-0011c-any-tall-narrow-11 item-07) 9998) (= (y-of-put-down-lift-0011c-any-tall-narrow-11 item-07) 9995) (= (z-of-put-down-lift-0011c-any-tall-narrow-11 item-07) 7374)
    (= (x-of-lift-1000-any-tall-narrow-11 item-07) 9700) (= (y-of-lift-1000-any-tall-narrow-11 item-07) 10682) (= (z-of-lift-1000-any-tall-narrow-11 item-07) 11991) (= (cost-of-lift-1000-any-tall-narrow-11 item-07) 209)
    (= (x-of-put-down-lift-1000-any-tall-narrow-11 item-07) 10000) (= (y-of-put-down-lift-1000-any-tall-narrow-11 item-07) 9989) (= (z-of-put-down-lift-1000-any-tall-narrow-11 item-07) 8009)
    (can-lift-1001d-any-tall-narrow-11 item-07) (= (x-of-lift-1001d-any-tall-narrow-11 item-07) 10491) (= (y-of-lift-1001d-any-tall-narrow-11 item-07) 9551) (= (z-of-lift-1001d-any-tall-narrow-11 item-07) 11994) (= (cost-of-lift-1001d-any-tall-narrow-11 item-07) 7)
    (= (x-of-put-down-lift-1001d-any-tall-narrow-11 item-07) 10005) (= (y-of-put-down-lift-1001d-any-tall-narrow-11 item-07) 9998) (= (z-of-put-down-lift-1001d-any-tall-narrow-11 item-07) 8006)
    (can-lift-1010b-any-tall-narrow-11 item-07) (= (x-of-lift-1010b-any-tall-narrow-11 item-07) 10279) (= (y-of-lift-1010b-any-tall-narrow-11 item-07) 10232) (= (z-of-lift-1010b-any-tall-narrow-11 item-07) 12000) (= (cost-of-lift-1010b-any-tall-narrow-11 item-07) 4)
    (= (x-of-put-down-lift-1010b-any-tall-narrow-11 item-07) 10000) (= (y-of-put-down-lift-1010b-any-tall-narrow-11 item-07) 9998) (= (z-of-put-down-lift-1010b-any-tall-narrow-11 item-07) 8000)
    (= (x-of-lift-1101a-any-tall-narrow-11 item-07) 10284) (= (y-of-lift-1101a-any-tall-narrow-11 item-07) 10264) (= (z-of-lift-1101a-any-tall-narrow-11 item-07) 12038) (= (cost-of-lift-1101a-any-tall-narrow-11 item-07) 278)
    (= (x-of-put-down-lift-1101a-any-tall-narrow-11 item-07) 10042) (= (y-of-put-down-lift-1101a-any-tall-narrow-11 item-07) 10028) (= (z-of-put-down-lift-1101a-any-tall-narrow-11 item-07) 7962)
    (can-place-forward-right-0111d-any-tall-narrow-11 item-07) (= (x-of-place-forward-right-0111d-any-tall-narrow-11 item-07) 10245) (= (y-of-place-forward-right-0111d-any-tall-narrow-11 item-07) 9846) (= (cost-of-place-forward-right-0111d-any-tall-narrow-11 item-07) 4)
    (can-pull-0100-any-tall-narrow-11 item-07) (= (x-of-pull-0100-any-tall-narrow-11 item-07) 9086) (= (y-of-pull-0100-any-tall-narrow-11 item-07) 9681) (= (cost-of-pull-0100-any-tall-narrow-11 item-07) 38)
    (can-pull-0110d-any-tall-narrow-11 item-07) (= (x-of-pull-0110d-any-tall-narrow-11 item-07) 9624) (= (y-of-pull-0110d-any-tall-narrow-11 item-07) 9909) (= (cost-of-pull-0110d-any-tall-narrow-11 item-07) 4)
    (= (x-of-pull-left-1110d-any-tall-narrow-11 item-07) 10005) (= (y-of-pull-left-1110d-any-tall-narrow-11 item-07) 9998) (= (cost-of-pull-left-1110d-any-tall-narrow-11 item-07) 34)
    (= (x-of-pull-right-0011c-any-tall-narrow-11 item-07) 9570) (= (y-of-pull-right-0011c-any-tall-narrow-11 item-07) 9392) (= (cost-of-pull-right-0011c-any-tall-narrow-11 item-07) 278)
    (can-pull-right-0100d-any-tall-narrow-11 item-07) (= (x-of-pull-right-0100d-any-tall-narrow-11 item-07) 9496) (= (y-of-pull-right-0100d-any-tall-narrow-11 item-07) 9665) (= (cost-of-pull-right-0100d-any-tall-narrow-11 item-07) 4)
    (can-push-forward-1011-any-tall-narrow-11 item-07) (= (x-of-push-forward-1011-any-tall-narrow-11 item-07) 10982) (= (y-of-push-forward-1011-any-tall-narrow-11 item-07) 10204) (= (cost-of-push-forward-1011-any-tall-narrow-11 item-07) 11)
    (can-push-forward-1011b-any-tall-narrow-11 item-07) (= (x-of-push-forward-1011b-any-tall-narrow-11 item-07) 10790) (= (y-of-push-forward-1011b-any-tall-narrow-11 item-07) 10022) (= (cost-of-push-forward-1011b-any-tall-narrow-11 item-07) 4)
    (can-push-forward-1111b-any-tall-narrow-11 item-07) (= (x-of-push-forward-1111b-any-tall-narrow-11 item-07) 10382) (= (y-of-push-forward-1111b-any-tall-narrow-11 item-07) 10019) (= (cost-of-push-forward-1111b-any-tall-narrow-11 item-07) 4)
    (can-push-forward-left-1100d-any-tall-narrow-11 item-07) (= (x-of-push-forward-left-1100d-any-tall-narrow-11 item-07) 10118) (= (y-of-push-forward-left-1100d-any-tall-narrow-11 item-07) 10261) (= (cost-of-push-forward-left-1100d-any-tall-narrow-11 item-07) 4)
    (can-push-forward-right-1111-any-tall-narrow-11 item-07) (= (x-of-push-forward-right-1111-any-tall-narrow-11 item-07) 10283) (= (y-of-push-forward-right-1111-any-tall-narrow-11 item-07) 9668) (= (cost-of-push-forward-right-1111-any-tall-narrow-11 item-07) 14)
    (= (x-of-push-left-1000-any-tall-narrow-11 item-07) 9981) (= (y-of-push-left-1000-any-tall-narrow-11 item-07) 10111) (= (cost-of-push-left-1000-any-tall-narrow-11 item-07) 14)
    (can-push-left-1101a-any-tall-narrow-11 item-07) (= (x-of-push-left-1101a-any-tall-narrow-11 item-07) 10200) (= (y-of-push-left-1101a-any-tall-narrow-11 item-07) 10234) (= (cost-of-push-left-1101a-any-tall-narrow-11 item-07) 7)
    (can-push-right-0001-any-tall-narrow-11 item-07) (= (x-of-push-right-0001-any-tall-narrow-11 item-07) 9779) (= (y-of-push-right-0001-any-tall-narrow-11 item-07) 9590) (= (cost-of-push-right-0001-any-tall-narrow-11 item-07) 53)
    (= (x-of-push-right-0001a-any-tall-narrow-11 item-07) 9979) (= (y-of-push-right-0001a-any-tall-narrow-11 item-07) 9591) (= (cost-of-push-right-0001a-any-tall-narrow-11 item-07) 278)
    (= (x-of-push-right-0011-any-tall-narrow-11 item-07) 10062) (= (y-of-push-right-0011-any-tall-narrow-11 item-07) 9809) (= (cost-of-push-right-0011-any-tall-narrow-11 item-07) 278)
    (can-push-right-0101d-any-tall-narrow-11 item-07) (= (x-of-push-right-0101d-any-tall-narrow-11 item-07) 9992) (= (y-of-push-right-0101d-any-tall-narrow-11 item-07) 9692) (= (cost-of-push-right-0101d-any-tall-narrow-11 item-07) 14)
    (can-push-right-0111-any-tall-narrow-11 item-07) (= (x-of-push-right-0111-any-tall-narrow-11 item-07) 9937) (= (y-of-push-right-0111-any-tall-narrow-11 item-07) 9681) (= (cost-of-push-right-0111-any-tall-narrow-11 item-07) 18)
    ; item-08 starts at (0.7656, -0.2319, 0.0166) m
    (= (x item-08) 4156) (= (y item-08) 681) (= (z item-08) 0)
    ; What each operator promises for item-08 (features 0.1119 0.0399 0.03315 0).
    ; Not for item-08:
    ; lift-0110b-solid-low-narrow-01: keeps its promise with such objects in about 4 of 30 only.
    ; place-back-0000-solid-low-narrow-01: keeps its promise in 2 of 30 rehearsals only.
    ; push-right-1001-solid-low-narrow-01: keeps its promise in 1 of 30 rehearsals only.
    (can-lift-0000-solid-low-narrow-01 item-08) (= (x-of-lift-0000-solid-low-narrow-01 item-08) 9190) (= (y-of-lift-0000-solid-low-narrow-01 item-08) 9916) (= (z-of-lift-0000-solid-low-narrow-01 item-08) 12023) (= (cost-of-lift-0000-solid-low-narrow-01 item-08) 34)
    (= (x-of-put-down-lift-0000-solid-low-narrow-01 item-08) 10012) (= (y-of-put-down-lift-0000-solid-low-narrow-01 item-08) 9981) (= (z-of-put-down-lift-0000-solid-low-narrow-01 item-08) 7977)
    (can-lift-0000a-solid-low-narrow-01 item-08) (= (x-of-lift-0000a-solid-low-narrow-01 item-08) 9496) (= (y-of-lift-0000a-solid-low-narrow-01 item-08) 10245) (= (z-of-lift-0000a-solid-low-narrow-01 item-08) 12456) (= (cost-of-lift-0000a-solid-low-narrow-01 item-08) 4)
    (= (x-of-put-down-lift-0000a-solid-low-narrow-01 item-08) 10001) (= (y-of-put-down-lift-0000a-solid-low-narrow-01 item-08) 9981) (= (z-of-put-down-lift-0000a-solid-low-narrow-01 item-08) 7544)
    (can-lift-0001-solid-low-narrow-01 item-08) (= (x-of-lift-0001-solid-low-narrow-01 item-08) 9681) (= (y-of-lift-0001-solid-low-narrow-01 item-08) 9782) (= (z-of-lift-0001-solid-low-narrow-01 item-08) 12402) (= (cost-of-lift-0001-solid-low-narrow-01 item-08) 7)
    (= (x-of-put-down-lift-0001-solid-low-narrow-01 item-08) 9998) (= (y-of-put-down-lift-0001-solid-low-narrow-01 item-08) 9987) (= (z-of-put-down-lift-0001-solid-low-narrow-01 item-08) 7598)
    (can-lift-0001a-solid-low-narrow-01 item-08) (= (x-of-lift-0001a-solid-low-narrow-01 item-08) 9860) (= (y-of-lift-0001a-solid-low-narrow-01 item-08) 9792) (= (z-of-lift-0001a-solid-low-narrow-01 item-08) 11979) (= (cost-of-lift-0001a-solid-low-narrow-01 item-08) 4)
    (= (x-of-put-down-lift-0001a-solid-low-narrow-01 item-08) 10021) (= (y-of-put-down-lift-0001a-solid-low-narrow-01 item-08) 9988) (= (z-of-put-down-lift-0001a-solid-low-narrow-01 item-08) 8021)
    (can-lift-0010-solid-low-narrow-01 item-08) (= (x-of-lift-0010-solid-low-narrow-01 item-08) 10272) (= (y-of-lift-0010-solid-low-narrow-01 item-08) 10215) (= (z-of-lift-0010-solid-low-narrow-01 item-08) 12306) (= (cost-of-lift-0010-solid-low-narrow-01 item-08) 4)
    (= (x-of-put-down-lift-0010-solid-low-narrow-01 item-08) 10002) (= (y-of-put-down-lift-0010-solid-low-narrow-01 item-08) 9982) (= (z-of-put-down-lift-0010-solid-low-narrow-01 item-08) 7694)
    (can-lift-0011b-solid-low-narrow-01 item-08) (= (x-of-lift-0011b-solid-low-narrow-01 item-08) 10393) (= (y-of-lift-0011b-solid-low-narrow-01 item-08) 9550) (= (z-of-lift-0011b-solid-low-narrow-01 item-08) 12380) (= (cost-of-lift-0011b-solid-low-narrow-01 item-08) 4)
    (= (x-of-put-down-lift-0011b-solid-low-narrow-01 item-08) 9993) (= (y-of-put-down-lift-0011b-solid-low-narrow-01 item-08) 9986) (= (z-of-put-down-lift-0011b-solid-low-narrow-01 item-08) 7620)
    (= (x-of-lift-0110b-solid-low-narrow-01 item-08) 10546) (= (y-of-lift-0110b-solid-low-narrow-01 item-08) 9914) (= (z-of-lift-0110b-solid-low-narrow-01 item-08) 12006) (= (cost-of-lift-0110b-solid-low-narrow-01 item-08) 187)
    (= (x-of-put-down-lift-0110b-solid-low-narrow-01 item-08) 10001) (= (y-of-put-down-lift-0110b-solid-low-narrow-01 item-08) 9985) (= (z-of-put-down-lift-0110b-solid-low-narrow-01 item-08) 7994)
    (can-lift-1000-solid-low-narrow-01 item-08) (= (x-of-lift-1000-solid-low-narrow-01 item-08) 9627) (= (y-of-lift-1000-solid-low-narrow-01 item-08) 10427) (= (z-of-lift-1000-solid-low-narrow-01 item-08) 11995) (= (cost-of-lift-1000-solid-low-narrow-01 item-08) 4)
    (= (x-of-put-down-lift-1000-solid-low-narrow-01 item-08) 10004) (= (y-of-put-down-lift-1000-solid-low-narrow-01 item-08) 9979) (= (z-of-put-down-lift-1000-solid-low-narrow-01 item-08) 8005)
    (can-lift-1001-solid-low-narrow-01 item-08) (= (x-of-lift-1001-solid-low-narrow-01 item-08) 9845) (= (y-of-lift-1001-solid-low-narrow-01 item-08) 9477) (= (z-of-lift-1001-solid-low-narrow-01 item-08) 11969) (= (cost-of-lift-1001-solid-low-narrow-01 item-08) 7)
    (= (x-of-put-down-lift-1001-solid-low-narrow-01 item-08) 10024) (= (y-of-put-down-lift-1001-solid-low-narrow-01 item-08) 9982) (= (z-of-put-down-lift-1001-solid-low-narrow-01 item-08) 8031)
    (can-lift-1001b-solid-low-narrow-01 item-08) (= (x-of-lift-1001b-solid-low-narrow-01 item-08) 10389) (= (y-of-lift-1001b-solid-low-narrow-01 item-08) 9479) (= (z-of-lift-1001b-solid-low-narrow-01 item-08) 12004) (= (cost-of-lift-1001b-solid-low-narrow-01 item-08) 4)
    (= (x-of-put-down-lift-1001b-solid-low-narrow-01 item-08) 9995) (= (y-of-put-down-lift-1001b-solid-low-narrow-01 item-08) 9987) (= (z-of-put-down-lift-1001b-solid-low-narrow-01 item-08) 7996)
    (can-lift-1010-solid-low-narrow-01 item-08) (= (x-of-lift-1010-solid-low-narrow-01 item-08) 10317) (= (y-of-lift-1010-solid-low-narrow-01 item-08) 10441) (= (z-of-lift-1010-solid-low-narrow-01 item-08) 11986) (= (cost-of-lift-1010-solid-low-narrow-01 item-08) 4)
    (= (x-of-put-down-lift-1010-solid-low-narrow-01 item-08) 10013) (= (y-of-put-down-lift-1010-solid-low-narrow-01 item-08) 9983) (= (z-of-put-down-lift-1010-solid-low-narrow-01 item-08) 8014)
    (= (x-of-place-back-0000-solid-low-narrow-01 item-08) 9084) (= (y-of-place-back-0000-solid-low-narrow-01 item-08) 9974) (= (cost-of-place-back-0000-solid-low-narrow-01 item-08) 238)
    (can-place-right-0111b-solid-low-narrow-01 item-08) (= (x-of-place-right-0111b-solid-low-narrow-01 item-08) 10143) (= (y-of-place-right-0111b-solid-low-narrow-01 item-08) 9457) (= (cost-of-place-right-0111b-solid-low-narrow-01 item-08) 4)
    (can-pull-1100b-solid-low-narrow-01 item-08) (= (x-of-pull-1100b-solid-low-narrow-01 item-08) 9421) (= (y-of-pull-1100b-solid-low-narrow-01 item-08) 10164) (= (cost-of-pull-1100b-solid-low-narrow-01 item-08) 4)
    (can-pull-right-0100b-solid-low-narrow-01 item-08) (= (x-of-pull-right-0100b-solid-low-narrow-01 item-08) 9293) (= (y-of-pull-right-0100b-solid-low-narrow-01 item-08) 9631) (= (cost-of-pull-right-0100b-solid-low-narrow-01 item-08) 4)
    (can-pull-right-0110b-solid-low-narrow-01 item-08) (= (x-of-pull-right-0110b-solid-low-narrow-01 item-08) 9811) (= (y-of-pull-right-0110b-solid-low-narrow-01 item-08) 9902) (= (cost-of-pull-right-0110b-solid-low-narrow-01 item-08) 18)
    (can-pull-right-0111-solid-low-narrow-01 item-08) (= (x-of-pull-right-0111-solid-low-narrow-01 item-08) 9726) (= (y-of-pull-right-0111-solid-low-narrow-01 item-08) 9637) (= (cost-of-pull-right-0111-solid-low-narrow-01 item-08) 4)
    (can-push-forward-1011-solid-low-narrow-01 item-08) (= (x-of-push-forward-1011-solid-low-narrow-01 item-08) 10990) (= (y-of-push-forward-1011-solid-low-narrow-01 item-08) 10244) (= (cost-of-push-forward-1011-solid-low-narrow-01 item-08) 4)
    (can-push-forward-right-1111-solid-low-narrow-01 item-08) (= (x-of-push-forward-right-1111-solid-low-narrow-01 item-08) 10627) (= (y-of-push-forward-right-1111-solid-low-narrow-01 item-08) 9521) (= (cost-of-push-forward-right-1111-solid-low-narrow-01 item-08) 4)
    (can-push-left-0110-solid-low-narrow-01 item-08) (= (x-of-push-left-0110-solid-low-narrow-01 item-08) 9828) (= (y-of-push-left-0110-solid-low-narrow-01 item-08) 10666) (= (cost-of-push-left-0110-solid-low-narrow-01 item-08) 4)
    (can-push-left-1101-solid-low-narrow-01 item-08) (= (x-of-push-left-1101-solid-low-narrow-01 item-08) 9964) (= (y-of-push-left-1101-solid-low-narrow-01 item-08) 10369) (= (cost-of-push-left-1101-solid-low-narrow-01 item-08) 4)
    (can-push-left-1110b-solid-low-narrow-01 item-08) (= (x-of-push-left-1110b-solid-low-narrow-01 item-08) 10382) (= (y-of-push-left-1110b-solid-low-narrow-01 item-08) 11242) (= (cost-of-push-left-1110b-solid-low-narrow-01 item-08) 4)
    (can-push-right-0101b-solid-low-narrow-01 item-08) (= (x-of-push-right-0101b-solid-low-narrow-01 item-08) 9829) (= (y-of-push-right-0101b-solid-low-narrow-01 item-08) 8663) (= (cost-of-push-right-0101b-solid-low-narrow-01 item-08) 7)
    (= (x-of-push-right-1001-solid-low-narrow-01 item-08) 9989) (= (y-of-push-right-1001-solid-low-narrow-01 item-08) 9752) (= (cost-of-push-right-1001-solid-low-narrow-01 item-08) 278))
  (:goal (and
    ; item-01 shall come to (0.7756, 0.0077, 0.0352) m, 159 mm from where it starts
    (<= (x item-01) 4712) (>= (x item-01) 3802)
    (<= (+ (x item-01) (y item-01)) 7977) (>= (+ (x item-01) (y item-01)) 6690)
    (<= (y item-01) 3532) (>= (y item-01) 2622)
    (<= (+ (y item-01) 536) (x item-01)) (<= (x item-01) (+ (y item-01) 1823))
    (>= (z item-01) 0) (<= (z item-01) 0)
    ; item-02 shall come to (0.6781, 0.0730, 0.0142) m, 297 mm from where it starts
    (<= (x item-02) 3736) (>= (x item-02) 2826)
    (<= (+ (x item-02) (y item-02)) 7655) (>= (+ (x item-02) (y item-02)) 6368)
    (<= (y item-02) 4185) (>= (y item-02) 3275)
    (<= (y item-02) (+ (x item-02) 1093)) (<= (x item-02) (+ (y item-02) 194))
    (>= (z item-02) 0) (<= (z item-02) 0)
    ; item-03 shall come to (0.5837, -0.2407, 0.0174) m, 267 mm from where it starts
    (<= (x item-03) 2792) (>= (x item-03) 1883)
    (<= (+ (x item-03) (y item-03)) 3574) (>= (+ (x item-03) (y item-03)) 2287)
    (<= (y item-03) 1048) (>= (y item-03) 138)
    (<= (+ (y item-03) 1101) (x item-03)) (<= (x item-03) (+ (y item-03) 2388))
    (>= (z item-03) 0) (<= (z item-03) 0)
    ; item-04 shall come to (0.6615, -0.0870, 0.0124) m, 263 mm from where it starts
    (<= (x item-04) 3570) (>= (x item-04) 2660)
    (<= (+ (x item-04) (y item-04)) 5888) (>= (+ (x item-04) (y item-04)) 4601)
    (<= (y item-04) 2585) (>= (y item-04) 1675)
    (<= (+ (y item-04) 341) (x item-04)) (<= (x item-04) (+ (y item-04) 1628))
    (>= (z item-04) 0) (<= (z item-04) 0)
    ; item-05 shall come to (0.5306, -0.0072, 0.0270) m, 180 mm from where it starts
    (<= (x item-05) 2261) (>= (x item-05) 1351)
    (<= (+ (x item-05) (y item-05)) 5377) (>= (+ (x item-05) (y item-05)) 4090)
    (<= (y item-05) 3383) (>= (y item-05) 2473)
    (<= (y item-05) (+ (x item-05) 1766)) (<= (+ (x item-05) 479) (y item-05))
    (>= (z item-05) 0) (<= (z item-05) 0)
    ; item-06 shall come to (0.5689, 0.1739, 0.0323) m, 382 mm from where it starts
    (<= (x item-06) 2644) (>= (x item-06) 1734)
    (<= (+ (x item-06) (y item-06)) 7572) (>= (+ (x item-06) (y item-06)) 6284)
    (<= (y item-06) 5194) (>= (y item-06) 4284)
    (<= (y item-06) (+ (x item-06) 3193)) (<= (+ (x item-06) 1906) (y item-06))
    (>= (z item-06) 0) (<= (z item-06) 0)
    ; item-07 shall come to (0.7529, -0.1373, 0.0457) m, 307 mm from where it starts
    (<= (x item-07) 4484) (>= (x item-07) 3575)
    (<= (+ (x item-07) (y item-07)) 6299) (>= (+ (x item-07) (y item-07)) 5012)
    (<= (y item-07) 2081) (>= (y item-07) 1172)
    (<= (+ (y item-07) 1759) (x item-07)) (<= (x item-07) (+ (y item-07) 3047))
    (>= (z item-07) 0) (<= (z item-07) 0)
    ; item-08 shall come to (0.8359, 0.1403, 0.0166) m, 379 mm from where it starts
    (<= (x item-08) 5314) (>= (x item-08) 4404)
    (<= (+ (x item-08) (y item-08)) 9906) (>= (+ (x item-08) (y item-08)) 8619)
    (<= (y item-08) 4859) (>= (y item-08) 3949)
    (<= (y item-08) (+ (x item-08) 188)) (<= (x item-08) (+ (y item-08) 1099))
    (>= (z item-08) 0) (<= (z item-08) 0)))
  (:metric minimize (total-cost)))
