; Problem anywhere-4-14 of the learned domain places, for its encoding numeric.
; How it came about: anywhere, drawn with seed 15; draw 1.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem anywhere-4-14)
  (:domain places-numeric)
  (:objects
    item-01 - solid-low-10
    item-02 - any-tall-narrow-11
    item-03 - solid-low-10
    item-04 - solid-low-10)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.8298, -0.0260, 0.0161) m
    (= (x item-01) 4798) (= (y item-01) 2740) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.03754 0.1786 0.0322 0).
    ; Not for item-01:
    ; lift-0010-solid-low-10: keeps its promise in 1 of 31 rehearsals only.
    ; lift-1001c-solid-low-10: keeps its promise in 1 of 31 rehearsals only.
    ; push-forward-right-1111-solid-low-10: scatters more than it moves.
    ; push-right-0010-solid-low-10: scatters more than it moves.
    ; push-right-0011-solid-low-10: scatters more than it moves.
    ; stay-1101-solid-low-10: moves less than half a cell.
    (= (x-of-lift-0010-solid-low-10 item-01) 10273) (= (y-of-lift-0010-solid-low-10 item-01) 10236) (= (z-of-lift-0010-solid-low-10 item-01) 12331) (= (cost-of-lift-0010-solid-low-10 item-01) 281)
    (= (x-of-put-down-lift-0010-solid-low-10 item-01) 10003) (= (y-of-put-down-lift-0010-solid-low-10 item-01) 9994) (= (z-of-put-down-lift-0010-solid-low-10 item-01) 7669)
    (= (x-of-lift-1001c-solid-low-10 item-01) 10252) (= (y-of-lift-1001c-solid-low-10 item-01) 9506) (= (z-of-lift-1001c-solid-low-10 item-01) 12007) (= (cost-of-lift-1001c-solid-low-10 item-01) 281)
    (= (x-of-put-down-lift-1001c-solid-low-10 item-01) 9995) (= (y-of-put-down-lift-1001c-solid-low-10 item-01) 9989) (= (z-of-put-down-lift-1001c-solid-low-10 item-01) 7993)
    (can-pull-0000b-solid-low-10 item-01) (= (x-of-pull-0000b-solid-low-10 item-01) 9395) (= (y-of-pull-0000b-solid-low-10 item-01) 9905) (= (cost-of-pull-0000b-solid-low-10 item-01) 14)
    (can-pull-0100-solid-low-10 item-01) (= (x-of-pull-0100-solid-low-10 item-01) 9154) (= (y-of-pull-0100-solid-low-10 item-01) 9943) (= (cost-of-pull-0100-solid-low-10 item-01) 7)
    (can-pull-0100c-solid-low-10 item-01) (= (x-of-pull-0100c-solid-low-10 item-01) 9190) (= (y-of-pull-0100c-solid-low-10 item-01) 10411) (= (cost-of-pull-0100c-solid-low-10 item-01) 11)
    (can-pull-0110c-solid-low-10 item-01) (= (x-of-pull-0110c-solid-low-10 item-01) 9661) (= (y-of-pull-0110c-solid-low-10 item-01) 9907) (= (cost-of-pull-0110c-solid-low-10 item-01) 4)
    (can-pull-left-1110c-solid-low-10 item-01) (= (x-of-pull-left-1110c-solid-low-10 item-01) 9506) (= (y-of-pull-left-1110c-solid-low-10 item-01) 10421) (= (cost-of-pull-left-1110c-solid-low-10 item-01) 4)
    (can-push-forward-0101c-solid-low-10 item-01) (= (x-of-push-forward-0101c-solid-low-10 item-01) 10373) (= (y-of-push-forward-0101c-solid-low-10 item-01) 10114) (= (cost-of-push-forward-0101c-solid-low-10 item-01) 14)
    (can-push-forward-1011-solid-low-10 item-01) (= (x-of-push-forward-1011-solid-low-10 item-01) 10812) (= (y-of-push-forward-1011-solid-low-10 item-01) 10095) (= (cost-of-push-forward-1011-solid-low-10 item-01) 4)
    (can-push-forward-left-1001c-solid-low-10 item-01) (= (x-of-push-forward-left-1001c-solid-low-10 item-01) 10685) (= (y-of-push-forward-left-1001c-solid-low-10 item-01) 10588) (= (cost-of-push-forward-left-1001c-solid-low-10 item-01) 25)
    (can-push-forward-left-1010-solid-low-10 item-01) (= (x-of-push-forward-left-1010-solid-low-10 item-01) 10249) (= (y-of-push-forward-left-1010-solid-low-10 item-01) 10268) (= (cost-of-push-forward-left-1010-solid-low-10 item-01) 7)
    (can-push-forward-left-1100c-solid-low-10 item-01) (= (x-of-push-forward-left-1100c-solid-low-10 item-01) 10164) (= (y-of-push-forward-left-1100c-solid-low-10 item-01) 10188) (= (cost-of-push-forward-left-1100c-solid-low-10 item-01) 4)
    (can-push-forward-right-0111c-solid-low-10 item-01) (= (x-of-push-forward-right-0111c-solid-low-10 item-01) 10705) (= (y-of-push-forward-right-0111c-solid-low-10 item-01) 9185) (= (cost-of-push-forward-right-0111c-solid-low-10 item-01) 14)
    (= (x-of-push-forward-right-1111-solid-low-10 item-01) 10186) (= (y-of-push-forward-right-1111-solid-low-10 item-01) 9849) (= (cost-of-push-forward-right-1111-solid-low-10 item-01) 7)
    (can-push-left-1000-solid-low-10 item-01) (= (x-of-push-left-1000-solid-low-10 item-01) 9906) (= (y-of-push-left-1000-solid-low-10 item-01) 10291) (= (cost-of-push-left-1000-solid-low-10 item-01) 7)
    (can-push-right-0001b-solid-low-10 item-01) (= (x-of-push-right-0001b-solid-low-10 item-01) 9834) (= (y-of-push-right-0001b-solid-low-10 item-01) 9581) (= (cost-of-push-right-0001b-solid-low-10 item-01) 11)
    (= (x-of-push-right-0010-solid-low-10 item-01) 10084) (= (y-of-push-right-0010-solid-low-10 item-01) 9861) (= (cost-of-push-right-0010-solid-low-10 item-01) 7)
    (= (x-of-push-right-0011-solid-low-10 item-01) 10100) (= (y-of-push-right-0011-solid-low-10 item-01) 9655) (= (cost-of-push-right-0011-solid-low-10 item-01) 11)
    (= (x-of-stay-1101-solid-low-10 item-01) 10001) (= (y-of-stay-1101-solid-low-10 item-01) 9994) (= (cost-of-stay-1101-solid-low-10 item-01) 11)
    ; item-02 starts at (0.6046, 0.2146, 0.0107) m
    (= (x item-02) 2546) (= (y item-02) 5146) (= (z item-02) 0)
    ; What each operator promises for item-02 (features 0.1137 0.1137 0.02148 2).
    ; Not for item-02:
    ; lift-1101a-any-tall-narrow-11: keeps its promise with such objects in about 3 of 30 only.
    ; pull-right-0011c-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    ; push-left-1000-any-tall-narrow-11: keeps its promise in 2 of 30 rehearsals only.
    ; push-right-0001-any-tall-narrow-11: scatters more than it moves.
    ; push-right-0001a-any-tall-narrow-11: keeps its promise in 2 of 30 rehearsals only.
    (can-lift-0000c-any-tall-narrow-11 item-02) (= (x-of-lift-0000c-any-tall-narrow-11 item-02) 9444) (= (y-of-lift-0000c-any-tall-narrow-11 item-02) 10479) (= (z-of-lift-0000c-any-tall-narrow-11 item-02) 11994) (= (cost-of-lift-0000c-any-tall-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-0000c-any-tall-narrow-11 item-02) 9999) (= (y-of-put-down-lift-0000c-any-tall-narrow-11 item-02) 9992) (= (z-of-put-down-lift-0000c-any-tall-narrow-11 item-02) 8006)
    (can-lift-0001-any-tall-narrow-11 item-02) (= (x-of-lift-0001-any-tall-narrow-11 item-02) 9645) (= (y-of-lift-0001-any-tall-narrow-11 item-02) 9234) (= (z-of-lift-0001-any-tall-narrow-11 item-02) 12340) (= (cost-of-lift-0001-any-tall-narrow-11 item-02) 70)
    (= (x-of-put-down-lift-0001-any-tall-narrow-11 item-02) 10001) (= (y-of-put-down-lift-0001-any-tall-narrow-11 item-02) 9959) (= (z-of-put-down-lift-0001-any-tall-narrow-11 item-02) 7660)
    (can-lift-0001a-any-tall-narrow-11 item-02) (= (x-of-lift-0001a-any-tall-narrow-11 item-02) 9824) (= (y-of-lift-0001a-any-tall-narrow-11 item-02) 9782) (= (z-of-lift-0001a-any-tall-narrow-11 item-02) 11998) (= (cost-of-lift-0001a-any-tall-narrow-11 item-02) 18)
    (= (x-of-put-down-lift-0001a-any-tall-narrow-11 item-02) 10000) (= (y-of-put-down-lift-0001a-any-tall-narrow-11 item-02) 9989) (= (z-of-put-down-lift-0001a-any-tall-narrow-11 item-02) 8002)
    (can-lift-0010b-any-tall-narrow-11 item-02) (= (x-of-lift-0010b-any-tall-narrow-11 item-02) 10330) (= (y-of-lift-0010b-any-tall-narrow-11 item-02) 10233) (= (z-of-lift-0010b-any-tall-narrow-11 item-02) 12303) (= (cost-of-lift-0010b-any-tall-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-0010b-any-tall-narrow-11 item-02) 10005) (= (y-of-put-down-lift-0010b-any-tall-narrow-11 item-02) 9989) (= (z-of-put-down-lift-0010b-any-tall-narrow-11 item-02) 7697)
    (can-lift-0011-any-tall-narrow-11 item-02) (= (x-of-lift-0011-any-tall-narrow-11 item-02) 10335) (= (y-of-lift-0011-any-tall-narrow-11 item-02) 9185) (= (z-of-lift-0011-any-tall-narrow-11 item-02) 11987) (= (cost-of-lift-0011-any-tall-narrow-11 item-02) 43)
    (= (x-of-put-down-lift-0011-any-tall-narrow-11 item-02) 10004) (= (y-of-put-down-lift-0011-any-tall-narrow-11 item-02) 9971) (= (z-of-put-down-lift-0011-any-tall-narrow-11 item-02) 8013)
    (can-lift-0011c-any-tall-narrow-11 item-02) (= (x-of-lift-0011c-any-tall-narrow-11 item-02) 9837) (= (y-of-lift-0011c-any-tall-narrow-11 item-02) 9672) (= (z-of-lift-0011c-any-tall-narrow-11 item-02) 12496) (= (cost-of-lift-0011c-any-tall-narrow-11 item-02) 7)
    (= (x-of-put-down-lift-0011c-any-tall-narrow-11 item-02) 10002) (= (y-of-put-down-lift-0011c-any-tall-narrow-11 item-02) 9987) (= (z-of-put-down-lift-0011c-any-tall-narrow-11 item-02) 7504)
    (can-lift-1000-any-tall-narrow-11 item-02) (= (x-of-lift-1000-any-tall-narrow-11 item-02) 9701) (= (y-of-lift-1000-any-tall-narrow-11 item-02) 10606) (= (z-of-lift-1000-any-tall-narrow-11 item-02) 12293) (= (cost-of-lift-1000-any-tall-narrow-11 item-02) 11)
    (= (x-of-put-down-lift-1000-any-tall-narrow-11 item-02) 10029) (= (y-of-put-down-lift-1000-any-tall-narrow-11 item-02) 9983) (= (z-of-put-down-lift-1000-any-tall-narrow-11 item-02) 7707)
    (can-lift-1001d-any-tall-narrow-11 item-02) (= (x-of-lift-1001d-any-tall-narrow-11 item-02) 10618) (= (y-of-lift-1001d-any-tall-narrow-11 item-02) 9537) (= (z-of-lift-1001d-any-tall-narrow-11 item-02) 12008) (= (cost-of-lift-1001d-any-tall-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-1001d-any-tall-narrow-11 item-02) 9997) (= (y-of-put-down-lift-1001d-any-tall-narrow-11 item-02) 9992) (= (z-of-put-down-lift-1001d-any-tall-narrow-11 item-02) 7992)
    (can-lift-1010b-any-tall-narrow-11 item-02) (= (x-of-lift-1010b-any-tall-narrow-11 item-02) 10278) (= (y-of-lift-1010b-any-tall-narrow-11 item-02) 10225) (= (z-of-lift-1010b-any-tall-narrow-11 item-02) 12003) (= (cost-of-lift-1010b-any-tall-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-1010b-any-tall-narrow-11 item-02) 10003) (= (y-of-put-down-lift-1010b-any-tall-narrow-11 item-02) 9992) (= (z-of-put-down-lift-1010b-any-tall-narrow-11 item-02) 7997)
    (= (x-of-lift-1101a-any-tall-narrow-11 item-02) 10281) (= (y-of-lift-1101a-any-tall-narrow-11 item-02) 10262) (= (z-of-lift-1101a-any-tall-narrow-11 item-02) 12031) (= (cost-of-lift-1101a-any-tall-narrow-11 item-02) 209)
    (= (x-of-put-down-lift-1101a-any-tall-narrow-11 item-02) 10032) (= (y-of-put-down-lift-1101a-any-tall-narrow-11 item-02) 10026) (= (z-of-put-down-lift-1101a-any-tall-narrow-11 item-02) 7969)
    (can-place-forward-right-0111d-any-tall-narrow-11 item-02) (= (x-of-place-forward-right-0111d-any-tall-narrow-11 item-02) 10322) (= (y-of-place-forward-right-0111d-any-tall-narrow-11 item-02) 9526) (= (cost-of-place-forward-right-0111d-any-tall-narrow-11 item-02) 4)
    (can-pull-0100-any-tall-narrow-11 item-02) (= (x-of-pull-0100-any-tall-narrow-11 item-02) 8952) (= (y-of-pull-0100-any-tall-narrow-11 item-02) 9833) (= (cost-of-pull-0100-any-tall-narrow-11 item-02) 4)
    (can-pull-0110d-any-tall-narrow-11 item-02) (= (x-of-pull-0110d-any-tall-narrow-11 item-02) 9750) (= (y-of-pull-0110d-any-tall-narrow-11 item-02) 9947) (= (cost-of-pull-0110d-any-tall-narrow-11 item-02) 4)
    (can-pull-left-1110d-any-tall-narrow-11 item-02) (= (x-of-pull-left-1110d-any-tall-narrow-11 item-02) 9829) (= (y-of-pull-left-1110d-any-tall-narrow-11 item-02) 10209) (= (cost-of-pull-left-1110d-any-tall-narrow-11 item-02) 11)
    (= (x-of-pull-right-0011c-any-tall-narrow-11 item-02) 9570) (= (y-of-pull-right-0011c-any-tall-narrow-11 item-02) 9392) (= (cost-of-pull-right-0011c-any-tall-narrow-11 item-02) 278)
    (can-pull-right-0100d-any-tall-narrow-11 item-02) (= (x-of-pull-right-0100d-any-tall-narrow-11 item-02) 9412) (= (y-of-pull-right-0100d-any-tall-narrow-11 item-02) 9733) (= (cost-of-pull-right-0100d-any-tall-narrow-11 item-02) 4)
    (can-push-forward-1011-any-tall-narrow-11 item-02) (= (x-of-push-forward-1011-any-tall-narrow-11 item-02) 11170) (= (y-of-push-forward-1011-any-tall-narrow-11 item-02) 10201) (= (cost-of-push-forward-1011-any-tall-narrow-11 item-02) 11)
    (can-push-forward-1011b-any-tall-narrow-11 item-02) (= (x-of-push-forward-1011b-any-tall-narrow-11 item-02) 10822) (= (y-of-push-forward-1011b-any-tall-narrow-11 item-02) 10119) (= (cost-of-push-forward-1011b-any-tall-narrow-11 item-02) 4)
    (can-push-forward-1111b-any-tall-narrow-11 item-02) (= (x-of-push-forward-1111b-any-tall-narrow-11 item-02) 10409) (= (y-of-push-forward-1111b-any-tall-narrow-11 item-02) 10012) (= (cost-of-push-forward-1111b-any-tall-narrow-11 item-02) 4)
    (can-push-forward-left-1100d-any-tall-narrow-11 item-02) (= (x-of-push-forward-left-1100d-any-tall-narrow-11 item-02) 10176) (= (y-of-push-forward-left-1100d-any-tall-narrow-11 item-02) 10250) (= (cost-of-push-forward-left-1100d-any-tall-narrow-11 item-02) 4)
    (can-push-forward-right-1111-any-tall-narrow-11 item-02) (= (x-of-push-forward-right-1111-any-tall-narrow-11 item-02) 10514) (= (y-of-push-forward-right-1111-any-tall-narrow-11 item-02) 9706) (= (cost-of-push-forward-right-1111-any-tall-narrow-11 item-02) 7)
    (= (x-of-push-left-1000-any-tall-narrow-11 item-02) 9983) (= (y-of-push-left-1000-any-tall-narrow-11 item-02) 10116) (= (cost-of-push-left-1000-any-tall-narrow-11 item-02) 238)
    (can-push-left-1101a-any-tall-narrow-11 item-02) (= (x-of-push-left-1101a-any-tall-narrow-11 item-02) 9826) (= (y-of-push-left-1101a-any-tall-narrow-11 item-02) 10147) (= (cost-of-push-left-1101a-any-tall-narrow-11 item-02) 14)
    (= (x-of-push-right-0001-any-tall-narrow-11 item-02) 9908) (= (y-of-push-right-0001-any-tall-narrow-11 item-02) 9930) (= (cost-of-push-right-0001-any-tall-narrow-11 item-02) 70)
    (= (x-of-push-right-0001a-any-tall-narrow-11 item-02) 10116) (= (y-of-push-right-0001a-any-tall-narrow-11 item-02) 9392) (= (cost-of-push-right-0001a-any-tall-narrow-11 item-02) 238)
    (can-push-right-0011-any-tall-narrow-11 item-02) (= (x-of-push-right-0011-any-tall-narrow-11 item-02) 10107) (= (y-of-push-right-0011-any-tall-narrow-11 item-02) 9658) (= (cost-of-push-right-0011-any-tall-narrow-11 item-02) 117)
    (can-push-right-0101d-any-tall-narrow-11 item-02) (= (x-of-push-right-0101d-any-tall-narrow-11 item-02) 9831) (= (y-of-push-right-0101d-any-tall-narrow-11 item-02) 9592) (= (cost-of-push-right-0101d-any-tall-narrow-11 item-02) 14)
    (can-push-right-0111-any-tall-narrow-11 item-02) (= (x-of-push-right-0111-any-tall-narrow-11 item-02) 9820) (= (y-of-push-right-0111-any-tall-narrow-11 item-02) 9596) (= (cost-of-push-right-0111-any-tall-narrow-11 item-02) 26)
    ; item-03 starts at (0.4275, 0.0288, 0.0461) m
    (= (x item-03) 775) (= (y item-03) 3288) (= (z item-03) 0)
    ; What each operator promises for item-03 (features 0.03652 0.122 0.09221 1).
    ; Not for item-03:
    ; push-forward-left-1001c-solid-low-10: keeps its promise in 3 of 31 rehearsals only.
    ; push-forward-left-1100c-solid-low-10: scatters more than it moves.
    ; push-forward-right-0111c-solid-low-10: scatters more than it moves.
    ; push-forward-right-1111-solid-low-10: scatters more than it moves.
    ; push-left-1000-solid-low-10: scatters more than it moves.
    ; push-right-0010-solid-low-10: scatters more than it moves.
    ; push-right-0011-solid-low-10: scatters more than it moves.
    ; stay-1101-solid-low-10: scatters more than it moves.
    (can-lift-0010-solid-low-10 item-03) (= (x-of-lift-0010-solid-low-10 item-03) 10273) (= (y-of-lift-0010-solid-low-10 item-03) 10235) (= (z-of-lift-0010-solid-low-10 item-03) 12332) (= (cost-of-lift-0010-solid-low-10 item-03) 25)
    (= (x-of-put-down-lift-0010-solid-low-10 item-03) 10002) (= (y-of-put-down-lift-0010-solid-low-10 item-03) 9993) (= (z-of-put-down-lift-0010-solid-low-10 item-03) 7668)
    (can-lift-1001c-solid-low-10 item-03) (= (x-of-lift-1001c-solid-low-10 item-03) 10236) (= (y-of-lift-1001c-solid-low-10 item-03) 9498) (= (z-of-lift-1001c-solid-low-10 item-03) 11994) (= (cost-of-lift-1001c-solid-low-10 item-03) 14)
    (= (x-of-put-down-lift-1001c-solid-low-10 item-03) 10002) (= (y-of-put-down-lift-1001c-solid-low-10 item-03) 9990) (= (z-of-put-down-lift-1001c-solid-low-10 item-03) 8006)
    (can-pull-0000b-solid-low-10 item-03) (= (x-of-pull-0000b-solid-low-10 item-03) 9548) (= (y-of-pull-0000b-solid-low-10 item-03) 9872) (= (cost-of-pull-0000b-solid-low-10 item-03) 14)
    (can-pull-0100-solid-low-10 item-03) (= (x-of-pull-0100-solid-low-10 item-03) 9254) (= (y-of-pull-0100-solid-low-10 item-03) 9969) (= (cost-of-pull-0100-solid-low-10 item-03) 7)
    (can-pull-0100c-solid-low-10 item-03) (= (x-of-pull-0100c-solid-low-10 item-03) 9374) (= (y-of-pull-0100c-solid-low-10 item-03) 10238) (= (cost-of-pull-0100c-solid-low-10 item-03) 11)
    (can-pull-0110c-solid-low-10 item-03) (= (x-of-pull-0110c-solid-low-10 item-03) 9651) (= (y-of-pull-0110c-solid-low-10 item-03) 9921) (= (cost-of-pull-0110c-solid-low-10 item-03) 7)
    (can-pull-left-1110c-solid-low-10 item-03) (= (x-of-pull-left-1110c-solid-low-10 item-03) 9475) (= (y-of-pull-left-1110c-solid-low-10 item-03) 10382) (= (cost-of-pull-left-1110c-solid-low-10 item-03) 4)
    (can-push-forward-0101c-solid-low-10 item-03) (= (x-of-push-forward-0101c-solid-low-10 item-03) 10380) (= (y-of-push-forward-0101c-solid-low-10 item-03) 9806) (= (cost-of-push-forward-0101c-solid-low-10 item-03) 14)
    (can-push-forward-1011-solid-low-10 item-03) (= (x-of-push-forward-1011-solid-low-10 item-03) 10849) (= (y-of-push-forward-1011-solid-low-10 item-03) 10071) (= (cost-of-push-forward-1011-solid-low-10 item-03) 4)
    (= (x-of-push-forward-left-1001c-solid-low-10 item-03) 10478) (= (y-of-push-forward-left-1001c-solid-low-10 item-03) 10457) (= (cost-of-push-forward-left-1001c-solid-low-10 item-03) 212)
    (can-push-forward-left-1010-solid-low-10 item-03) (= (x-of-push-forward-left-1010-solid-low-10 item-03) 10050) (= (y-of-push-forward-left-1010-solid-low-10 item-03) 10213) (= (cost-of-push-forward-left-1010-solid-low-10 item-03) 7)
    (= (x-of-push-forward-left-1100c-solid-low-10 item-03) 10115) (= (y-of-push-forward-left-1100c-solid-low-10 item-03) 10163) (= (cost-of-push-forward-left-1100c-solid-low-10 item-03) 94)
    (= (x-of-push-forward-right-0111c-solid-low-10 item-03) 10030) (= (y-of-push-forward-right-0111c-solid-low-10 item-03) 9942) (= (cost-of-push-forward-right-0111c-solid-low-10 item-03) 62)
    (= (x-of-push-forward-right-1111-solid-low-10 item-03) 10149) (= (y-of-push-forward-right-1111-solid-low-10 item-03) 9867) (= (cost-of-push-forward-right-1111-solid-low-10 item-03) 21)
    (= (x-of-push-left-1000-solid-low-10 item-03) 9988) (= (y-of-push-left-1000-solid-low-10 item-03) 9926) (= (cost-of-push-left-1000-solid-low-10 item-03) 7)
    (can-push-right-0001b-solid-low-10 item-03) (= (x-of-push-right-0001b-solid-low-10 item-03) 9883) (= (y-of-push-right-0001b-solid-low-10 item-03) 9535) (= (cost-of-push-right-0001b-solid-low-10 item-03) 11)
    (= (x-of-push-right-0010-solid-low-10 item-03) 10077) (= (y-of-push-right-0010-solid-low-10 item-03) 9774) (= (cost-of-push-right-0010-solid-low-10 item-03) 156)
    (= (x-of-push-right-0011-solid-low-10 item-03) 10083) (= (y-of-push-right-0011-solid-low-10 item-03) 9733) (= (cost-of-push-right-0011-solid-low-10 item-03) 80)
    (= (x-of-stay-1101-solid-low-10 item-03) 10001) (= (y-of-stay-1101-solid-low-10 item-03) 9887) (= (cost-of-stay-1101-solid-low-10 item-03) 11)
    ; item-04 starts at (0.5204, 0.0258, 0.0158) m
    (= (x item-04) 1704) (= (y item-04) 3258) (= (z item-04) 0)
    ; What each operator promises for item-04 (features 0.05731 0.114 0.03155 0).
    ; Not for item-04:
    ; push-forward-left-1100c-solid-low-10: scatters more than it moves.
    ; push-left-1000-solid-low-10: keeps its promise with such objects in about 5 of 31 only.
    ; push-right-0010-solid-low-10: keeps its promise in 2 of 31 rehearsals only.
    (can-lift-0010-solid-low-10 item-04) (= (x-of-lift-0010-solid-low-10 item-04) 10274) (= (y-of-lift-0010-solid-low-10 item-04) 10234) (= (z-of-lift-0010-solid-low-10 item-04) 12318) (= (cost-of-lift-0010-solid-low-10 item-04) 11)
    (= (x-of-put-down-lift-0010-solid-low-10 item-04) 10002) (= (y-of-put-down-lift-0010-solid-low-10 item-04) 9993) (= (z-of-put-down-lift-0010-solid-low-10 item-04) 7682)
    (can-lift-1001c-solid-low-10 item-04) (= (x-of-lift-1001c-solid-low-10 item-04) 10278) (= (y-of-lift-1001c-solid-low-10 item-04) 9484) (= (z-of-lift-1001c-solid-low-10 item-04) 12005) (= (cost-of-lift-1001c-solid-low-10 item-04) 67)
    (= (x-of-put-down-lift-1001c-solid-low-10 item-04) 9998) (= (y-of-put-down-lift-1001c-solid-low-10 item-04) 9993) (= (z-of-put-down-lift-1001c-solid-low-10 item-04) 7995)
    (can-pull-0000b-solid-low-10 item-04) (= (x-of-pull-0000b-solid-low-10 item-04) 9506) (= (y-of-pull-0000b-solid-low-10 item-04) 9814) (= (cost-of-pull-0000b-solid-low-10 item-04) 14)
    (can-pull-0100-solid-low-10 item-04) (= (x-of-pull-0100-solid-low-10 item-04) 9249) (= (y-of-pull-0100-solid-low-10 item-04) 9944) (= (cost-of-pull-0100-solid-low-10 item-04) 7)
    (can-pull-0100c-solid-low-10 item-04) (= (x-of-pull-0100c-solid-low-10 item-04) 9385) (= (y-of-pull-0100c-solid-low-10 item-04) 10211) (= (cost-of-pull-0100c-solid-low-10 item-04) 11)
    (can-pull-0110c-solid-low-10 item-04) (= (x-of-pull-0110c-solid-low-10 item-04) 9757) (= (y-of-pull-0110c-solid-low-10 item-04) 9983) (= (cost-of-pull-0110c-solid-low-10 item-04) 4)
    (can-pull-left-1110c-solid-low-10 item-04) (= (x-of-pull-left-1110c-solid-low-10 item-04) 9825) (= (y-of-pull-left-1110c-solid-low-10 item-04) 10119) (= (cost-of-pull-left-1110c-solid-low-10 item-04) 4)
    (can-push-forward-0101c-solid-low-10 item-04) (= (x-of-push-forward-0101c-solid-low-10 item-04) 10314) (= (y-of-push-forward-0101c-solid-low-10 item-04) 9900) (= (cost-of-push-forward-0101c-solid-low-10 item-04) 14)
    (can-push-forward-1011-solid-low-10 item-04) (= (x-of-push-forward-1011-solid-low-10 item-04) 10902) (= (y-of-push-forward-1011-solid-low-10 item-04) 10154) (= (cost-of-push-forward-1011-solid-low-10 item-04) 4)
    (can-push-forward-left-1001c-solid-low-10 item-04) (= (x-of-push-forward-left-1001c-solid-low-10 item-04) 10286) (= (y-of-push-forward-left-1001c-solid-low-10 item-04) 10373) (= (cost-of-push-forward-left-1001c-solid-low-10 item-04) 80)
    (can-push-forward-left-1010-solid-low-10 item-04) (= (x-of-push-forward-left-1010-solid-low-10 item-04) 10111) (= (y-of-push-forward-left-1010-solid-low-10 item-04) 10150) (= (cost-of-push-forward-left-1010-solid-low-10 item-04) 25)
    (= (x-of-push-forward-left-1100c-solid-low-10 item-04) 10113) (= (y-of-push-forward-left-1100c-solid-low-10 item-04) 9955) (= (cost-of-push-forward-left-1100c-solid-low-10 item-04) 4)
    (can-push-forward-right-0111c-solid-low-10 item-04) (= (x-of-push-forward-right-0111c-solid-low-10 item-04) 10466) (= (y-of-push-forward-right-0111c-solid-low-10 item-04) 9490) (= (cost-of-push-forward-right-0111c-solid-low-10 item-04) 94)
    (can-push-forward-right-1111-solid-low-10 item-04) (= (x-of-push-forward-right-1111-solid-low-10 item-04) 10468) (= (y-of-push-forward-right-1111-solid-low-10 item-04) 9994) (= (cost-of-push-forward-right-1111-solid-low-10 item-04) 73)
    (= (x-of-push-left-1000-solid-low-10 item-04) 9945) (= (y-of-push-left-1000-solid-low-10 item-04) 10261) (= (cost-of-push-left-1000-solid-low-10 item-04) 171)
    (can-push-right-0001b-solid-low-10 item-04) (= (x-of-push-right-0001b-solid-low-10 item-04) 9904) (= (y-of-push-right-0001b-solid-low-10 item-04) 9677) (= (cost-of-push-right-0001b-solid-low-10 item-04) 11)
    (= (x-of-push-right-0010-solid-low-10 item-04) 10091) (= (y-of-push-right-0010-solid-low-10 item-04) 9811) (= (cost-of-push-right-0010-solid-low-10 item-04) 241)
    (can-push-right-0011-solid-low-10 item-04) (= (x-of-push-right-0011-solid-low-10 item-04) 10150) (= (y-of-push-right-0011-solid-low-10 item-04) 9629) (= (cost-of-push-right-0011-solid-low-10 item-04) 51)
    (can-stay-1101-solid-low-10 item-04) (= (x-of-stay-1101-solid-low-10 item-04) 9994) (= (y-of-stay-1101-solid-low-10 item-04) 10332) (= (cost-of-stay-1101-solid-low-10 item-04) 11))
  (:goal (and
    ; item-01 shall come to (0.6008, -0.0046, 0.0161) m, 230 mm from where it starts
    (<= (x item-01) 2962) (>= (x item-01) 2053)
    (<= (+ (x item-01) (y item-01)) 6104) (>= (+ (x item-01) (y item-01)) 4817)
    (<= (y item-01) 3408) (>= (y item-01) 2499)
    (<= (y item-01) (+ (x item-01) 1090)) (<= (x item-01) (+ (y item-01) 198))
    (>= (z item-01) 0) (<= (z item-01) 0)
    ; item-02 shall come to (0.4423, -0.1431, 0.0107) m, 393 mm from where it starts
    (<= (x item-02) 1378) (>= (x item-02) 468)
    (<= (+ (x item-02) (y item-02)) 3136) (>= (+ (x item-02) (y item-02)) 1849)
    (<= (y item-02) 2024) (>= (y item-02) 1114)
    (<= (y item-02) (+ (x item-02) 1289)) (<= (+ (x item-02) 2) (y item-02))
    (>= (z item-02) 0) (<= (z item-02) 0)
    ; item-03 shall come to (0.8365, -0.2325, 0.0461) m, 485 mm from where it starts
    (<= (x item-03) 5320) (>= (x item-03) 4410)
    (<= (+ (x item-03) (y item-03)) 6184) (>= (+ (x item-03) (y item-03)) 4897)
    (<= (y item-03) 1130) (>= (y item-03) 220)
    (<= (+ (y item-03) 3547) (x item-03)) (<= (x item-03) (+ (y item-03) 4834))
    (>= (z item-03) 0) (<= (z item-03) 0)
    ; item-04 shall come to (0.3801, 0.2299, 0.0158) m, 248 mm from where it starts
    (<= (x item-04) 756) (>= (+ (x item-04) 154) 0)
    (<= (+ (x item-04) (y item-04)) 6243) (>= (+ (x item-04) (y item-04)) 4956)
    (<= (y item-04) 5754) (>= (y item-04) 4844)
    (<= (y item-04) (+ (x item-04) 5642)) (<= (+ (x item-04) 4355) (y item-04))
    (>= (z item-04) 0) (<= (z item-04) 0)))
  (:metric minimize (total-cost)))
