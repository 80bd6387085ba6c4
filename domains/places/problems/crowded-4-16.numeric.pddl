; Problem crowded-4-16 of the learned domain places, for its encoding numeric.
; How it came about: crowded, drawn with seed 17; draw 1.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem crowded-4-16)
  (:domain places-numeric)
  (:objects
    item-01 - solid-low-10
    item-02 - solid-low-narrow-01
    item-03 - solid-low-10
    item-04 - solid-low-10)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.6813, -0.1821, 0.0203) m
    (= (x item-01) 3313) (= (y item-01) 1179) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.04532 0.09162 0.04062 0).
    ; item-01 is unlike all that were rehearsed: it is promised what its category is.
    ; Not for item-01:
    ; lift-0010-solid-low-10: keeps its promise with such objects in about 6 of 31 only.
    ; lift-1001c-solid-low-10: keeps its promise with such objects in about 5 of 31 only.
    ; push-forward-left-1100c-solid-low-10: scatters more than it moves.
    ; push-forward-right-1111-solid-low-10: scatters more than it moves.
    ; push-right-0010-solid-low-10: scatters more than it moves.
    ; push-right-0011-solid-low-10: scatters more than it moves.
    ; stay-1101-solid-low-10: scatters more than it moves.
    (= (x-of-lift-0010-solid-low-10 item-01) 10274) (= (y-of-lift-0010-solid-low-10 item-01) 10234) (= (z-of-lift-0010-solid-low-10 item-01) 12322) (= (cost-of-lift-0010-solid-low-10 item-01) 156)
    (= (x-of-put-down-lift-0010-solid-low-10 item-01) 10002) (= (y-of-put-down-lift-0010-solid-low-10 item-01) 9993) (= (z-of-put-down-lift-0010-solid-low-10 item-01) 7678)
    (= (x-of-lift-1001c-solid-low-10 item-01) 10257) (= (y-of-lift-1001c-solid-low-10 item-01) 9490) (= (z-of-lift-1001c-solid-low-10 item-01) 12001) (= (cost-of-lift-1001c-solid-low-10 item-01) 171)
    (= (x-of-put-down-lift-1001c-solid-low-10 item-01) 9999) (= (y-of-put-down-lift-1001c-solid-low-10 item-01) 9993) (= (z-of-put-down-lift-1001c-solid-low-10 item-01) 7999)
    (can-pull-0000b-solid-low-10 item-01) (= (x-of-pull-0000b-solid-low-10 item-01) 9564) (= (y-of-pull-0000b-solid-low-10 item-01) 9865) (= (cost-of-pull-0000b-solid-low-10 item-01) 11)
    (can-pull-0100-solid-low-10 item-01) (= (x-of-pull-0100-solid-low-10 item-01) 9309) (= (y-of-pull-0100-solid-low-10 item-01) 9950) (= (cost-of-pull-0100-solid-low-10 item-01) 17)
    (can-pull-0100c-solid-low-10 item-01) (= (x-of-pull-0100c-solid-low-10 item-01) 9363) (= (y-of-pull-0100c-solid-low-10 item-01) 10217) (= (cost-of-pull-0100c-solid-low-10 item-01) 21)
    (can-pull-0110c-solid-low-10 item-01) (= (x-of-pull-0110c-solid-low-10 item-01) 9727) (= (y-of-pull-0110c-solid-low-10 item-01) 9961) (= (cost-of-pull-0110c-solid-low-10 item-01) 14)
    (can-pull-left-1110c-solid-low-10 item-01) (= (x-of-pull-left-1110c-solid-low-10 item-01) 9692) (= (y-of-pull-left-1110c-solid-low-10 item-01) 10221) (= (cost-of-pull-left-1110c-solid-low-10 item-01) 7)
    (can-push-forward-0101c-solid-low-10 item-01) (= (x-of-push-forward-0101c-solid-low-10 item-01) 10345) (= (y-of-push-forward-0101c-solid-low-10 item-01) 9925) (= (cost-of-push-forward-0101c-solid-low-10 item-01) 14)
    (can-push-forward-1011-solid-low-10 item-01) (= (x-of-push-forward-1011-solid-low-10 item-01) 10803) (= (y-of-push-forward-1011-solid-low-10 item-01) 10068) (= (cost-of-push-forward-1011-solid-low-10 item-01) 17)
    (can-push-forward-left-1001c-solid-low-10 item-01) (= (x-of-push-forward-left-1001c-solid-low-10 item-01) 10464) (= (y-of-push-forward-left-1001c-solid-low-10 item-01) 10425) (= (cost-of-push-forward-left-1001c-solid-low-10 item-01) 46)
    (can-push-forward-left-1010-solid-low-10 item-01) (= (x-of-push-forward-left-1010-solid-low-10 item-01) 10151) (= (y-of-push-forward-left-1010-solid-low-10 item-01) 10254) (= (cost-of-push-forward-left-1010-solid-low-10 item-01) 14)
    (= (x-of-push-forward-left-1100c-solid-low-10 item-01) 10131) (= (y-of-push-forward-left-1100c-solid-low-10 item-01) 10077) (= (cost-of-push-forward-left-1100c-solid-low-10 item-01) 14)
    (can-push-forward-right-0111c-solid-low-10 item-01) (= (x-of-push-forward-right-0111c-solid-low-10 item-01) 10366) (= (y-of-push-forward-right-0111c-solid-low-10 item-01) 9583) (= (cost-of-push-forward-right-0111c-solid-low-10 item-01) 67)
    (= (x-of-push-forward-right-1111-solid-low-10 item-01) 10143) (= (y-of-push-forward-right-1111-solid-low-10 item-01) 9781) (= (cost-of-push-forward-right-1111-solid-low-10 item-01) 17)
    (can-push-left-1000-solid-low-10 item-01) (= (x-of-push-left-1000-solid-low-10 item-01) 9924) (= (y-of-push-left-1000-solid-low-10 item-01) 10249) (= (cost-of-push-left-1000-solid-low-10 item-01) 11)
    (can-push-right-0001b-solid-low-10 item-01) (= (x-of-push-right-0001b-solid-low-10 item-01) 9867) (= (y-of-push-right-0001b-solid-low-10 item-01) 9536) (= (cost-of-push-right-0001b-solid-low-10 item-01) 7)
    (= (x-of-push-right-0010-solid-low-10 item-01) 10085) (= (y-of-push-right-0010-solid-low-10 item-01) 9812) (= (cost-of-push-right-0010-solid-low-10 item-01) 29)
    (= (x-of-push-right-0011-solid-low-10 item-01) 10124) (= (y-of-push-right-0011-solid-low-10 item-01) 9681) (= (cost-of-push-right-0011-solid-low-10 item-01) 21)
    (= (x-of-stay-1101-solid-low-10 item-01) 10000) (= (y-of-stay-1101-solid-low-10 item-01) 9942) (= (cost-of-stay-1101-solid-low-10 item-01) 11)
    ; item-02 starts at (0.6821, -0.2562, 0.0315) m
    (= (x item-02) 3321) (= (y item-02) 438) (= (z item-02) 0)
    ; What each operator promises for item-02 (features 0.06564 0.0361 0.06296 0).
    ; Not for item-02:
    ; lift-0000-solid-low-narrow-01: keeps its promise with such objects in about 6 of 30 only.
    ; pull-right-0110b-solid-low-narrow-01: keeps its promise with such objects in about 4 of 30 only.
    (= (x-of-lift-0000-solid-low-narrow-01 item-02) 9156) (= (y-of-lift-0000-solid-low-narrow-01 item-02) 9931) (= (z-of-lift-0000-solid-low-narrow-01 item-02) 12025) (= (cost-of-lift-0000-solid-low-narrow-01 item-02) 153)
    (= (x-of-put-down-lift-0000-solid-low-narrow-01 item-02) 10025) (= (y-of-put-down-lift-0000-solid-low-narrow-01 item-02) 9988) (= (z-of-put-down-lift-0000-solid-low-narrow-01 item-02) 7975)
    (can-lift-0000a-solid-low-narrow-01 item-02) (= (x-of-lift-0000a-solid-low-narrow-01 item-02) 9493) (= (y-of-lift-0000a-solid-low-narrow-01 item-02) 10249) (= (z-of-lift-0000a-solid-low-narrow-01 item-02) 12533) (= (cost-of-lift-0000a-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-0000a-solid-low-narrow-01 item-02) 10001) (= (y-of-put-down-lift-0000a-solid-low-narrow-01 item-02) 9984) (= (z-of-put-down-lift-0000a-solid-low-narrow-01 item-02) 7467)
    (can-lift-0001-solid-low-narrow-01 item-02) (= (x-of-lift-0001-solid-low-narrow-01 item-02) 9712) (= (y-of-lift-0001-solid-low-narrow-01 item-02) 9729) (= (z-of-lift-0001-solid-low-narrow-01 item-02) 12425) (= (cost-of-lift-0001-solid-low-narrow-01 item-02) 7)
    (= (x-of-put-down-lift-0001-solid-low-narrow-01 item-02) 10001) (= (y-of-put-down-lift-0001-solid-low-narrow-01 item-02) 9986) (= (z-of-put-down-lift-0001-solid-low-narrow-01 item-02) 7575)
    (can-lift-0001a-solid-low-narrow-01 item-02) (= (x-of-lift-0001a-solid-low-narrow-01 item-02) 9830) (= (y-of-lift-0001a-solid-low-narrow-01 item-02) 9790) (= (z-of-lift-0001a-solid-low-narrow-01 item-02) 11990) (= (cost-of-lift-0001a-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-0001a-solid-low-narrow-01 item-02) 10005) (= (y-of-put-down-lift-0001a-solid-low-narrow-01 item-02) 9992) (= (z-of-put-down-lift-0001a-solid-low-narrow-01 item-02) 8010)
    (can-lift-0010-solid-low-narrow-01 item-02) (= (x-of-lift-0010-solid-low-narrow-01 item-02) 10273) (= (y-of-lift-0010-solid-low-narrow-01 item-02) 10219) (= (z-of-lift-0010-solid-low-narrow-01 item-02) 12344) (= (cost-of-lift-0010-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-0010-solid-low-narrow-01 item-02) 10010) (= (y-of-put-down-lift-0010-solid-low-narrow-01 item-02) 9982) (= (z-of-put-down-lift-0010-solid-low-narrow-01 item-02) 7656)
    (can-lift-0011b-solid-low-narrow-01 item-02) (= (x-of-lift-0011b-solid-low-narrow-01 item-02) 10403) (= (y-of-lift-0011b-solid-low-narrow-01 item-02) 9561) (= (z-of-lift-0011b-solid-low-narrow-01 item-02) 12398) (= (cost-of-lift-0011b-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-0011b-solid-low-narrow-01 item-02) 9994) (= (y-of-put-down-lift-0011b-solid-low-narrow-01 item-02) 9989) (= (z-of-put-down-lift-0011b-solid-low-narrow-01 item-02) 7602)
    (can-lift-0110b-solid-low-narrow-01 item-02) (= (x-of-lift-0110b-solid-low-narrow-01 item-02) 10562) (= (y-of-lift-0110b-solid-low-narrow-01 item-02) 9925) (= (z-of-lift-0110b-solid-low-narrow-01 item-02) 12093) (= (cost-of-lift-0110b-solid-low-narrow-01 item-02) 18)
    (= (x-of-put-down-lift-0110b-solid-low-narrow-01 item-02) 10002) (= (y-of-put-down-lift-0110b-solid-low-narrow-01 item-02) 9988) (= (z-of-put-down-lift-0110b-solid-low-narrow-01 item-02) 7907)
    (can-lift-1000-solid-low-narrow-01 item-02) (= (x-of-lift-1000-solid-low-narrow-01 item-02) 9643) (= (y-of-lift-1000-solid-low-narrow-01 item-02) 10433) (= (z-of-lift-1000-solid-low-narrow-01 item-02) 11997) (= (cost-of-lift-1000-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-1000-solid-low-narrow-01 item-02) 10004) (= (y-of-put-down-lift-1000-solid-low-narrow-01 item-02) 9984) (= (z-of-put-down-lift-1000-solid-low-narrow-01 item-02) 8003)
    (can-lift-1001-solid-low-narrow-01 item-02) (= (x-of-lift-1001-solid-low-narrow-01 item-02) 9802) (= (y-of-lift-1001-solid-low-narrow-01 item-02) 9490) (= (z-of-lift-1001-solid-low-narrow-01 item-02) 11993) (= (cost-of-lift-1001-solid-low-narrow-01 item-02) 38)
    (= (x-of-put-down-lift-1001-solid-low-narrow-01 item-02) 10014) (= (y-of-put-down-lift-1001-solid-low-narrow-01 item-02) 9983) (= (z-of-put-down-lift-1001-solid-low-narrow-01 item-02) 8007)
    (can-lift-1001b-solid-low-narrow-01 item-02) (= (x-of-lift-1001b-solid-low-narrow-01 item-02) 10389) (= (y-of-lift-1001b-solid-low-narrow-01 item-02) 9490) (= (z-of-lift-1001b-solid-low-narrow-01 item-02) 12001) (= (cost-of-lift-1001b-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-1001b-solid-low-narrow-01 item-02) 9992) (= (y-of-put-down-lift-1001b-solid-low-narrow-01 item-02) 9988) (= (z-of-put-down-lift-1001b-solid-low-narrow-01 item-02) 7999)
    (can-lift-1010-solid-low-narrow-01 item-02) (= (x-of-lift-1010-solid-low-narrow-01 item-02) 10289) (= (y-of-lift-1010-solid-low-narrow-01 item-02) 10436) (= (z-of-lift-1010-solid-low-narrow-01 item-02) 11990) (= (cost-of-lift-1010-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-1010-solid-low-narrow-01 item-02) 10003) (= (y-of-put-down-lift-1010-solid-low-narrow-01 item-02) 9984) (= (z-of-put-down-lift-1010-solid-low-narrow-01 item-02) 8010)
    (can-place-back-0000-solid-low-narrow-01 item-02) (= (x-of-place-back-0000-solid-low-narrow-01 item-02) 9110) (= (y-of-place-back-0000-solid-low-narrow-01 item-02) 10082) (= (cost-of-place-back-0000-solid-low-narrow-01 item-02) 34)
    (can-place-right-0111b-solid-low-narrow-01 item-02) (= (x-of-place-right-0111b-solid-low-narrow-01 item-02) 10130) (= (y-of-place-right-0111b-solid-low-narrow-01 item-02) 9436) (= (cost-of-place-right-0111b-solid-low-narrow-01 item-02) 4)
    (can-pull-1100b-solid-low-narrow-01 item-02) (= (x-of-pull-1100b-solid-low-narrow-01 item-02) 9421) (= (y-of-pull-1100b-solid-low-narrow-01 item-02) 10168) (= (cost-of-pull-1100b-solid-low-narrow-01 item-02) 4)
    (can-pull-right-0100b-solid-low-narrow-01 item-02) (= (x-of-pull-right-0100b-solid-low-narrow-01 item-02) 9334) (= (y-of-pull-right-0100b-solid-low-narrow-01 item-02) 9635) (= (cost-of-pull-right-0100b-solid-low-narrow-01 item-02) 4)
    (= (x-of-pull-right-0110b-solid-low-narrow-01 item-02) 9935) (= (y-of-pull-right-0110b-solid-low-narrow-01 item-02) 9957) (= (cost-of-pull-right-0110b-solid-low-narrow-01 item-02) 187)
    (can-pull-right-0111-solid-low-narrow-01 item-02) (= (x-of-pull-right-0111-solid-low-narrow-01 item-02) 9728) (= (y-of-pull-right-0111-solid-low-narrow-01 item-02) 9641) (= (cost-of-pull-right-0111-solid-low-narrow-01 item-02) 4)
    (can-push-forward-1011-solid-low-narrow-01 item-02) (= (x-of-push-forward-1011-solid-low-narrow-01 item-02) 10989) (= (y-of-push-forward-1011-solid-low-narrow-01 item-02) 10226) (= (cost-of-push-forward-1011-solid-low-narrow-01 item-02) 4)
    (can-push-forward-right-1111-solid-low-narrow-01 item-02) (= (x-of-push-forward-right-1111-solid-low-narrow-01 item-02) 10609) (= (y-of-push-forward-right-1111-solid-low-narrow-01 item-02) 9894) (= (cost-of-push-forward-right-1111-solid-low-narrow-01 item-02) 4)
    (can-push-left-0110-solid-low-narrow-01 item-02) (= (x-of-push-left-0110-solid-low-narrow-01 item-02) 9615) (= (y-of-push-left-0110-solid-low-narrow-01 item-02) 10560) (= (cost-of-push-left-0110-solid-low-narrow-01 item-02) 4)
    (can-push-left-1101-solid-low-narrow-01 item-02) (= (x-of-push-left-1101-solid-low-narrow-01 item-02) 9965) (= (y-of-push-left-1101-solid-low-narrow-01 item-02) 10370) (= (cost-of-push-left-1101-solid-low-narrow-01 item-02) 4)
    (can-push-left-1110b-solid-low-narrow-01 item-02) (= (x-of-push-left-1110b-solid-low-narrow-01 item-02) 10469) (= (y-of-push-left-1110b-solid-low-narrow-01 item-02) 11089) (= (cost-of-push-left-1110b-solid-low-narrow-01 item-02) 11)
    (can-push-right-0101b-solid-low-narrow-01 item-02) (= (x-of-push-right-0101b-solid-low-narrow-01 item-02) 9728) (= (y-of-push-right-0101b-solid-low-narrow-01 item-02) 8665) (= (cost-of-push-right-0101b-solid-low-narrow-01 item-02) 59)
    (can-push-right-1001-solid-low-narrow-01 item-02) (= (x-of-push-right-1001-solid-low-narrow-01 item-02) 9974) (= (y-of-push-right-1001-solid-low-narrow-01 item-02) 9759) (= (cost-of-push-right-1001-solid-low-narrow-01 item-02) 117)
    ; item-03 starts at (0.7367, -0.0071, 0.0162) m
    (= (x item-03) 3867) (= (y item-03) 2929) (= (z item-03) 0)
    ; What each operator promises for item-03 (features 0.04934 0.1782 0.03236 0).
    ; Not for item-03:
    ; lift-0010-solid-low-10: keeps its promise in 1 of 31 rehearsals only.
    ; lift-1001c-solid-low-10: keeps its promise in 1 of 31 rehearsals only.
    ; push-forward-right-1111-solid-low-10: scatters more than it moves.
    ; push-right-0010-solid-low-10: scatters more than it moves.
    ; stay-1101-solid-low-10: scatters more than it moves.
    (= (x-of-lift-0010-solid-low-10 item-03) 10273) (= (y-of-lift-0010-solid-low-10 item-03) 10236) (= (z-of-lift-0010-solid-low-10 item-03) 12331) (= (cost-of-lift-0010-solid-low-10 item-03) 281)
    (= (x-of-put-down-lift-0010-solid-low-10 item-03) 10003) (= (y-of-put-down-lift-0010-solid-low-10 item-03) 9993) (= (z-of-put-down-lift-0010-solid-low-10 item-03) 7669)
    (= (x-of-lift-1001c-solid-low-10 item-03) 10255) (= (y-of-lift-1001c-solid-low-10 item-03) 9506) (= (z-of-lift-1001c-solid-low-10 item-03) 12008) (= (cost-of-lift-1001c-solid-low-10 item-03) 281)
    (= (x-of-put-down-lift-1001c-solid-low-10 item-03) 9994) (= (y-of-put-down-lift-1001c-solid-low-10 item-03) 9988) (= (z-of-put-down-lift-1001c-solid-low-10 item-03) 7992)
    (can-pull-0000b-solid-low-10 item-03) (= (x-of-pull-0000b-solid-low-10 item-03) 9419) (= (y-of-pull-0000b-solid-low-10 item-03) 9915) (= (cost-of-pull-0000b-solid-low-10 item-03) 14)
    (can-pull-0100-solid-low-10 item-03) (= (x-of-pull-0100-solid-low-10 item-03) 9158) (= (y-of-pull-0100-solid-low-10 item-03) 9940) (= (cost-of-pull-0100-solid-low-10 item-03) 7)
    (can-pull-0100c-solid-low-10 item-03) (= (x-of-pull-0100c-solid-low-10 item-03) 9182) (= (y-of-pull-0100c-solid-low-10 item-03) 10382) (= (cost-of-pull-0100c-solid-low-10 item-03) 11)
    (can-pull-0110c-solid-low-10 item-03) (= (x-of-pull-0110c-solid-low-10 item-03) 9682) (= (y-of-pull-0110c-solid-low-10 item-03) 9945) (= (cost-of-pull-0110c-solid-low-10 item-03) 4)
    (can-pull-left-1110c-solid-low-10 item-03) (= (x-of-pull-left-1110c-solid-low-10 item-03) 9425) (= (y-of-pull-left-1110c-solid-low-10 item-03) 10441) (= (cost-of-pull-left-1110c-solid-low-10 item-03) 4)
    (can-push-forward-0101c-solid-low-10 item-03) (= (x-of-push-forward-0101c-solid-low-10 item-03) 10396) (= (y-of-push-forward-0101c-solid-low-10 item-03) 10073) (= (cost-of-push-forward-0101c-solid-low-10 item-03) 14)
    (can-push-forward-1011-solid-low-10 item-03) (= (x-of-push-forward-1011-solid-low-10 item-03) 10872) (= (y-of-push-forward-1011-solid-low-10 item-03) 10118) (= (cost-of-push-forward-1011-solid-low-10 item-03) 4)
    (can-push-forward-left-1001c-solid-low-10 item-03) (= (x-of-push-forward-left-1001c-solid-low-10 item-03) 10688) (= (y-of-push-forward-left-1001c-solid-low-10 item-03) 10537) (= (cost-of-push-forward-left-1001c-solid-low-10 item-03) 11)
    (can-push-forward-left-1010-solid-low-10 item-03) (= (x-of-push-forward-left-1010-solid-low-10 item-03) 10245) (= (y-of-push-forward-left-1010-solid-low-10 item-03) 10265) (= (cost-of-push-forward-left-1010-solid-low-10 item-03) 7)
    (can-push-forward-left-1100c-solid-low-10 item-03) (= (x-of-push-forward-left-1100c-solid-low-10 item-03) 10171) (= (y-of-push-forward-left-1100c-solid-low-10 item-03) 10208) (= (cost-of-push-forward-left-1100c-solid-low-10 item-03) 4)
    (can-push-forward-right-0111c-solid-low-10 item-03) (= (x-of-push-forward-right-0111c-solid-low-10 item-03) 10696) (= (y-of-push-forward-right-0111c-solid-low-10 item-03) 9144) (= (cost-of-push-forward-right-0111c-solid-low-10 item-03) 25)
    (= (x-of-push-forward-right-1111-solid-low-10 item-03) 10130) (= (y-of-push-forward-right-1111-solid-low-10 item-03) 9851) (= (cost-of-push-forward-right-1111-solid-low-10 item-03) 7)
    (can-push-left-1000-solid-low-10 item-03) (= (x-of-push-left-1000-solid-low-10 item-03) 9899) (= (y-of-push-left-1000-solid-low-10 item-03) 10330) (= (cost-of-push-left-1000-solid-low-10 item-03) 7)
    (can-push-right-0001b-solid-low-10 item-03) (= (x-of-push-right-0001b-solid-low-10 item-03) 9819) (= (y-of-push-right-0001b-solid-low-10 item-03) 9591) (= (cost-of-push-right-0001b-solid-low-10 item-03) 11)
    (= (x-of-push-right-0010-solid-low-10 item-03) 10090) (= (y-of-push-right-0010-solid-low-10 item-03) 9878) (= (cost-of-push-right-0010-solid-low-10 item-03) 7)
    (can-push-right-0011-solid-low-10 item-03) (= (x-of-push-right-0011-solid-low-10 item-03) 10098) (= (y-of-push-right-0011-solid-low-10 item-03) 9646) (= (cost-of-push-right-0011-solid-low-10 item-03) 11)
    (= (x-of-stay-1101-solid-low-10 item-03) 10001) (= (y-of-stay-1101-solid-low-10 item-03) 10028) (= (cost-of-stay-1101-solid-low-10 item-03) 11)
    ; item-04 starts at (0.6457, 0.1444, 0.0468) m
    (= (x item-04) 2957) (= (y item-04) 4444) (= (z item-04) 0)
    ; What each operator promises for item-04 (features 0.1051 0.1128 0.09369 0).
    ; Not for item-04:
    ; lift-1001c-solid-low-10: keeps its promise in 3 of 31 rehearsals only.
    ; push-forward-left-1001c-solid-low-10: scatters more than it moves.
    ; push-forward-left-1010-solid-low-10: scatters more than it moves.
    ; push-forward-left-1100c-solid-low-10: scatters more than it moves.
    ; push-forward-right-0111c-solid-low-10: scatters more than it moves.
    ; push-left-1000-solid-low-10: scatters more than it moves.
    ; push-right-0010-solid-low-10: keeps its promise in 2 of 31 rehearsals only.
    ; stay-1101-solid-low-10: scatters more than it moves.
    (can-lift-0010-solid-low-10 item-04) (= (x-of-lift-0010-solid-low-10 item-04) 10270) (= (y-of-lift-0010-solid-low-10 item-04) 10238) (= (z-of-lift-0010-solid-low-10 item-04) 12355) (= (cost-of-lift-0010-solid-low-10 item-04) 11)
    (= (x-of-put-down-lift-0010-solid-low-10 item-04) 10001) (= (y-of-put-down-lift-0010-solid-low-10 item-04) 9992) (= (z-of-put-down-lift-0010-solid-low-10 item-04) 7645)
    (= (x-of-lift-1001c-solid-low-10 item-04) 10219) (= (y-of-lift-1001c-solid-low-10 item-04) 9505) (= (z-of-lift-1001c-solid-low-10 item-04) 11996) (= (cost-of-lift-1001c-solid-low-10 item-04) 212)
    (= (x-of-put-down-lift-1001c-solid-low-10 item-04) 10006) (= (y-of-put-down-lift-1001c-solid-low-10 item-04) 9989) (= (z-of-put-down-lift-1001c-solid-low-10 item-04) 8004)
    (can-pull-0000b-solid-low-10 item-04) (= (x-of-pull-0000b-solid-low-10 item-04) 9564) (= (y-of-pull-0000b-solid-low-10 item-04) 9866) (= (cost-of-pull-0000b-solid-low-10 item-04) 14)
    (can-pull-0100-solid-low-10 item-04) (= (x-of-pull-0100-solid-low-10 item-04) 9375) (= (y-of-pull-0100-solid-low-10 item-04) 9961) (= (cost-of-pull-0100-solid-low-10 item-04) 7)
    (can-pull-0100c-solid-low-10 item-04) (= (x-of-pull-0100c-solid-low-10 item-04) 9340) (= (y-of-pull-0100c-solid-low-10 item-04) 10195) (= (cost-of-pull-0100c-solid-low-10 item-04) 11)
    (can-pull-0110c-solid-low-10 item-04) (= (x-of-pull-0110c-solid-low-10 item-04) 9723) (= (y-of-pull-0110c-solid-low-10 item-04) 9899) (= (cost-of-pull-0110c-solid-low-10 item-04) 7)
    (can-pull-left-1110c-solid-low-10 item-04) (= (x-of-pull-left-1110c-solid-low-10 item-04) 9534) (= (y-of-pull-left-1110c-solid-low-10 item-04) 10336) (= (cost-of-pull-left-1110c-solid-low-10 item-04) 4)
    (can-push-forward-0101c-solid-low-10 item-04) (= (x-of-push-forward-0101c-solid-low-10 item-04) 10354) (= (y-of-push-forward-0101c-solid-low-10 item-04) 9804) (= (cost-of-push-forward-0101c-solid-low-10 item-04) 14)
    (can-push-forward-1011-solid-low-10 item-04) (= (x-of-push-forward-1011-solid-low-10 item-04) 10824) (= (y-of-push-forward-1011-solid-low-10 item-04) 10109) (= (cost-of-push-forward-1011-solid-low-10 item-04) 4)
    (= (x-of-push-forward-left-1001c-solid-low-10 item-04) 10042) (= (y-of-push-forward-left-1001c-solid-low-10 item-04) 9813) (= (cost-of-push-forward-left-1001c-solid-low-10 item-04) 17)
    (= (x-of-push-forward-left-1010-solid-low-10 item-04) 10025) (= (y-of-push-forward-left-1010-solid-low-10 item-04) 10073) (= (cost-of-push-forward-left-1010-solid-low-10 item-04) 7)
    (= (x-of-push-forward-left-1100c-solid-low-10 item-04) 10076) (= (y-of-push-forward-left-1100c-solid-low-10 item-04) 10015) (= (cost-of-push-forward-left-1100c-solid-low-10 item-04) 4)
    (= (x-of-push-forward-right-0111c-solid-low-10 item-04) 10005) (= (y-of-push-forward-right-0111c-solid-low-10 item-04) 10033) (= (cost-of-push-forward-right-0111c-solid-low-10 item-04) 11)
    (can-push-forward-right-1111-solid-low-10 item-04) (= (x-of-push-forward-right-1111-solid-low-10 item-04) 10206) (= (y-of-push-forward-right-1111-solid-low-10 item-04) 9685) (= (cost-of-push-forward-right-1111-solid-low-10 item-04) 29)
    (= (x-of-push-left-1000-solid-low-10 item-04) 9987) (= (y-of-push-left-1000-solid-low-10 item-04) 9921) (= (cost-of-push-left-1000-solid-low-10 item-04) 7)
    (can-push-right-0001b-solid-low-10 item-04) (= (x-of-push-right-0001b-solid-low-10 item-04) 9868) (= (y-of-push-right-0001b-solid-low-10 item-04) 9540) (= (cost-of-push-right-0001b-solid-low-10 item-04) 11)
    (= (x-of-push-right-0010-solid-low-10 item-04) 10079) (= (y-of-push-right-0010-solid-low-10 item-04) 9805) (= (cost-of-push-right-0010-solid-low-10 item-04) 241)
    (can-push-right-0011-solid-low-10 item-04) (= (x-of-push-right-0011-solid-low-10 item-04) 10087) (= (y-of-push-right-0011-solid-low-10 item-04) 9668) (= (cost-of-push-right-0011-solid-low-10 item-04) 87)
    (= (x-of-stay-1101-solid-low-10 item-04) 10000) (= (y-of-stay-1101-solid-low-10 item-04) 9940) (= (cost-of-stay-1101-solid-low-10 item-04) 11))
  (:goal (and
    ; item-01 shall come to (0.4954, 0.0502, 0.0203) m, 298 mm from where it starts
    (<= (x item-01) 1908) (>= (x item-01) 999)
    (<= (+ (x item-01) (y item-01)) 5599) (>= (+ (x item-01) (y item-01)) 4312)
    (<= (y item-01) 3957) (>= (y item-01) 3047)
    (<= (y item-01) (+ (x item-01) 2692)) (<= (+ (x item-01) 1405) (y item-01))
    (>= (z item-01) 0) (<= (z item-01) 0)
    ; item-02 shall come to (0.4481, 0.1339, 0.0315) m, 455 mm from where it starts
    (<= (x item-02) 1436) (>= (x item-02) 526)
    (<= (+ (x item-02) (y item-02)) 5964) (>= (+ (x item-02) (y item-02)) 4677)
    (<= (y item-02) 4794) (>= (y item-02) 3885)
    (<= (y item-02) (+ (x item-02) 4002)) (<= (+ (x item-02) 2715) (y item-02))
    (>= (z item-02) 0) (<= (z item-02) 0)
    ; item-03 shall come to (0.6167, -0.1642, 0.0162) m, 198 mm from where it starts
    (<= (x item-03) 3122) (>= (x item-03) 2212)
    (<= (+ (x item-03) (y item-03)) 4669) (>= (+ (x item-03) (y item-03)) 3382)
    (<= (y item-03) 1813) (>= (y item-03) 903)
    (<= (+ (y item-03) 665) (x item-03)) (<= (x item-03) (+ (y item-03) 1952))
    (>= (z item-03) 0) (<= (z item-03) 0)
    ; item-04 shall come to (0.7696, -0.2278, 0.0468) m, 392 mm from where it starts
    (<= (x item-04) 4651) (>= (x item-04) 3741)
    (<= (+ (x item-04) (y item-04)) 5561) (>= (+ (x item-04) (y item-04)) 4274)
    (<= (y item-04) 1176) (>= (y item-04) 267)
    (<= (+ (y item-04) 2831) (x item-04)) (<= (x item-04) (+ (y item-04) 4118))
    (>= (z item-04) 0) (<= (z item-04) 0)))
  (:metric minimize (total-cost)))
