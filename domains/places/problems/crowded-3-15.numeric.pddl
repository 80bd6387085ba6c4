; Problem crowded-3-15 of the learned domain places, for its encoding numeric.
; How it came about: crowded, drawn with seed 16; draw 1.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem crowded-3-15)
  (:domain places-numeric)
  (:objects
    item-01 - any-tall-narrow-11
    item-02 - solid-low-narrow-01
    item-03 - any-tall-narrow-11)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.8508, 0.1526, 0.0288) m
    (= (x item-01) 5008) (= (y item-01) 4526) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.1147 0.1147 0.05752 2).
    ; Not for item-01:
    ; lift-1000-any-tall-narrow-11: keeps its promise with such objects in about 6 of 30 only.
    ; pull-right-0011c-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    ; push-left-1101a-any-tall-narrow-11: keeps its promise in 2 of 30 rehearsals only.
    ; push-right-0001a-any-tall-narrow-11: keeps its promise in 2 of 30 rehearsals only.
    (can-lift-0000c-any-tall-narrow-11 item-01) (= (x-of-lift-0000c-any-tall-narrow-11 item-01) 9441) (= (y-of-lift-0000c-any-tall-narrow-11 item-01) 10487) (= (z-of-lift-0000c-any-tall-narrow-11 item-01) 12014) (= (cost-of-lift-0000c-any-tall-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-0000c-any-tall-narrow-11 item-01) 10001) (= (y-of-put-down-lift-0000c-any-tall-narrow-11 item-01) 9994) (= (z-of-put-down-lift-0000c-any-tall-narrow-11 item-01) 7986)
    (can-lift-0001-any-tall-narrow-11 item-01) (= (x-of-lift-0001-any-tall-narrow-11 item-01) 9660) (= (y-of-lift-0001-any-tall-narrow-11 item-01) 9232) (= (z-of-lift-0001-any-tall-narrow-11 item-01) 12495) (= (cost-of-lift-0001-any-tall-narrow-11 item-01) 43)
    (= (x-of-put-down-lift-0001-any-tall-narrow-11 item-01) 9999) (= (y-of-put-down-lift-0001-any-tall-narrow-11 item-01) 9962) (= (z-of-put-down-lift-0001-any-tall-narrow-11 item-01) 7505)
    (can-lift-0001a-any-tall-narrow-11 item-01) (= (x-of-lift-0001a-any-tall-narrow-11 item-01) 9867) (= (y-of-lift-0001a-any-tall-narrow-11 item-01) 9632) (= (z-of-lift-0001a-any-tall-narrow-11 item-01) 11998) (= (cost-of-lift-0001a-any-tall-narrow-11 item-01) 14)
    (= (x-of-put-down-lift-0001a-any-tall-narrow-11 item-01) 10003) (= (y-of-put-down-lift-0001a-any-tall-narrow-11 item-01) 9988) (= (z-of-put-down-lift-0001a-any-tall-narrow-11 item-01) 8002)
    (can-lift-0010b-any-tall-narrow-11 item-01) (= (x-of-lift-0010b-any-tall-narrow-11 item-01) 10331) (= (y-of-lift-0010b-any-tall-narrow-11 item-01) 10239) (= (z-of-lift-0010b-any-tall-narrow-11 item-01) 12378) (= (cost-of-lift-0010b-any-tall-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-0010b-any-tall-narrow-11 item-01) 10002) (= (y-of-put-down-lift-0010b-any-tall-narrow-11 item-01) 9994) (= (z-of-put-down-lift-0010b-any-tall-narrow-11 item-01) 7622)
    (can-lift-0011-any-tall-narrow-11 item-01) (= (x-of-lift-0011-any-tall-narrow-11 item-01) 10370) (= (y-of-lift-0011-any-tall-narrow-11 item-01) 9151) (= (z-of-lift-0011-any-tall-narrow-11 item-01) 11992) (= (cost-of-lift-0011-any-tall-narrow-11 item-01) 84)
    (= (x-of-put-down-lift-0011-any-tall-narrow-11 item-01) 9999) (= (y-of-put-down-lift-0011-any-tall-narrow-11 item-01) 9977) (= (z-of-put-down-lift-0011-any-tall-narrow-11 item-01) 8008)
    (can-lift-0011c-any-tall-narrow-11 item-01) (= (x-of-lift-0011c-any-tall-narrow-11 item-01) 9831) (= (y-of-lift-0011c-any-tall-narrow-11 item-01) 9679) (= (z-of-lift-0011c-any-tall-narrow-11 item-01) 12636) (= (cost-of-lift-0011c-any-tall-narrow-11 item-01) 7)
    (= (x-of-put-down-lift-0011c-any-tall-narrow-11 item-01) 9999) (= (y-of-put-down-lift-0011c-any-tall-narrow-11 item-01) 9996) (= (z-of-put-down-lift-0011c-any-tall-narrow-11 item-01) 7364)
    (= (x-of-lift-1000-any-tall-narrow-11 item-01) 9776) (= (y-of-lift-1000-any-tall-narrow-11 item-01) 10835) (= (z-of-lift-1000-any-tall-narrow-11 item-01) 12202) (= (cost-of-lift-1000-any-tall-narrow-11 item-01) 153)
    (= (x-of-put-down-lift-1000-any-tall-narrow-11 item-01) 10010) (= (y-of-put-down-lift-1000-any-tall-narrow-11 item-01) 9964) (= (z-of-put-down-lift-1000-any-tall-narrow-11 item-01) 7798)
    (can-lift-1001d-any-tall-narrow-11 item-01) (= (x-of-lift-1001d-any-tall-narrow-11 item-01) 10640) (= (y-of-lift-1001d-any-tall-narrow-11 item-01) 9551) (= (z-of-lift-1001d-any-tall-narrow-11 item-01) 11998) (= (cost-of-lift-1001d-any-tall-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-1001d-any-tall-narrow-11 item-01) 10006) (= (y-of-put-down-lift-1001d-any-tall-narrow-11 item-01) 9995) (= (z-of-put-down-lift-1001d-any-tall-narrow-11 item-01) 8002)
    (can-lift-1010b-any-tall-narrow-11 item-01) (= (x-of-lift-1010b-any-tall-narrow-11 item-01) 10279) (= (y-of-lift-1010b-any-tall-narrow-11 item-01) 10229) (= (z-of-lift-1010b-any-tall-narrow-11 item-01) 12004) (= (cost-of-lift-1010b-any-tall-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-1010b-any-tall-narrow-11 item-01) 10002) (= (y-of-put-down-lift-1010b-any-tall-narrow-11 item-01) 9995) (= (z-of-put-down-lift-1010b-any-tall-narrow-11 item-01) 7996)
    (can-lift-1101a-any-tall-narrow-11 item-01) (= (x-of-lift-1101a-any-tall-narrow-11 item-01) 10298) (= (y-of-lift-1101a-any-tall-narrow-11 item-01) 10266) (= (z-of-lift-1101a-any-tall-narrow-11 item-01) 12045) (= (cost-of-lift-1101a-any-tall-narrow-11 item-01) 11)
    (= (x-of-put-down-lift-1101a-any-tall-narrow-11 item-01) 10047) (= (y-of-put-down-lift-1101a-any-tall-narrow-11 item-01) 10027) (= (z-of-put-down-lift-1101a-any-tall-narrow-11 item-01) 7955)
    (can-place-forward-right-0111d-any-tall-narrow-11 item-01) (= (x-of-place-forward-right-0111d-any-tall-narrow-11 item-01) 10258) (= (y-of-place-forward-right-0111d-any-tall-narrow-11 item-01) 9872) (= (cost-of-place-forward-right-0111d-any-tall-narrow-11 item-01) 4)
    (can-pull-0100-any-tall-narrow-11 item-01) (= (x-of-pull-0100-any-tall-narrow-11 item-01) 8885) (= (y-of-pull-0100-any-tall-narrow-11 item-01) 9729) (= (cost-of-pull-0100-any-tall-narrow-11 item-01) 4)
    (can-pull-0110d-any-tall-narrow-11 item-01) (= (x-of-pull-0110d-any-tall-narrow-11 item-01) 9746) (= (y-of-pull-0110d-any-tall-narrow-11 item-01) 9937) (= (cost-of-pull-0110d-any-tall-narrow-11 item-01) 4)
    (can-pull-left-1110d-any-tall-narrow-11 item-01) (= (x-of-pull-left-1110d-any-tall-narrow-11 item-01) 9620) (= (y-of-pull-left-1110d-any-tall-narrow-11 item-01) 10297) (= (cost-of-pull-left-1110d-any-tall-narrow-11 item-01) 14)
    (= (x-of-pull-right-0011c-any-tall-narrow-11 item-01) 9570) (= (y-of-pull-right-0011c-any-tall-narrow-11 item-01) 9392) (= (cost-of-pull-right-0011c-any-tall-narrow-11 item-01) 278)
    (can-pull-right-0100d-any-tall-narrow-11 item-01) (= (x-of-pull-right-0100d-any-tall-narrow-11 item-01) 9470) (= (y-of-pull-right-0100d-any-tall-narrow-11 item-01) 9710) (= (cost-of-pull-right-0100d-any-tall-narrow-11 item-01) 4)
    (can-push-forward-1011-any-tall-narrow-11 item-01) (= (x-of-push-forward-1011-any-tall-narrow-11 item-01) 11161) (= (y-of-push-forward-1011-any-tall-narrow-11 item-01) 10238) (= (cost-of-push-forward-1011-any-tall-narrow-11 item-01) 11)
    (can-push-forward-1011b-any-tall-narrow-11 item-01) (= (x-of-push-forward-1011b-any-tall-narrow-11 item-01) 10838) (= (y-of-push-forward-1011b-any-tall-narrow-11 item-01) 10048) (= (cost-of-push-forward-1011b-any-tall-narrow-11 item-01) 4)
    (can-push-forward-1111b-any-tall-narrow-11 item-01) (= (x-of-push-forward-1111b-any-tall-narrow-11 item-01) 10399) (= (y-of-push-forward-1111b-any-tall-narrow-11 item-01) 10015) (= (cost-of-push-forward-1111b-any-tall-narrow-11 item-01) 4)
    (can-push-forward-left-1100d-any-tall-narrow-11 item-01) (= (x-of-push-forward-left-1100d-any-tall-narrow-11 item-01) 10165) (= (y-of-push-forward-left-1100d-any-tall-narrow-11 item-01) 10258) (= (cost-of-push-forward-left-1100d-any-tall-narrow-11 item-01) 4)
    (can-push-forward-right-1111-any-tall-narrow-11 item-01) (= (x-of-push-forward-right-1111-any-tall-narrow-11 item-01) 10647) (= (y-of-push-forward-right-1111-any-tall-narrow-11 item-01) 9597) (= (cost-of-push-forward-right-1111-any-tall-narrow-11 item-01) 7)
    (can-push-left-1000-any-tall-narrow-11 item-01) (= (x-of-push-left-1000-any-tall-narrow-11 item-01) 9984) (= (y-of-push-left-1000-any-tall-narrow-11 item-01) 10148) (= (cost-of-push-left-1000-any-tall-narrow-11 item-01) 26)
    (= (x-of-push-left-1101a-any-tall-narrow-11 item-01) 9869) (= (y-of-push-left-1101a-any-tall-narrow-11 item-01) 10186) (= (cost-of-push-left-1101a-any-tall-narrow-11 item-01) 238)
    (can-push-right-0001-any-tall-narrow-11 item-01) (= (x-of-push-right-0001-any-tall-narrow-11 item-01) 9853) (= (y-of-push-right-0001-any-tall-narrow-11 item-01) 9620) (= (cost-of-push-right-0001-any-tall-narrow-11 item-01) 108)
    (= (x-of-push-right-0001a-any-tall-narrow-11 item-01) 9970) (= (y-of-push-right-0001a-any-tall-narrow-11 item-01) 9708) (= (cost-of-push-right-0001a-any-tall-narrow-11 item-01) 238)
    (can-push-right-0011-any-tall-narrow-11 item-01) (= (x-of-push-right-0011-any-tall-narrow-11 item-01) 10031) (= (y-of-push-right-0011-any-tall-narrow-11 item-01) 9661) (= (cost-of-push-right-0011-any-tall-narrow-11 item-01) 64)
    (can-push-right-0101d-any-tall-narrow-11 item-01) (= (x-of-push-right-0101d-any-tall-narrow-11 item-01) 9873) (= (y-of-push-right-0101d-any-tall-narrow-11 item-01) 9709) (= (cost-of-push-right-0101d-any-tall-narrow-11 item-01) 48)
    (can-push-right-0111-any-tall-narrow-11 item-01) (= (x-of-push-right-0111-any-tall-narrow-11 item-01) 9862) (= (y-of-push-right-0111-any-tall-narrow-11 item-01) 9639) (= (cost-of-push-right-0111-any-tall-narrow-11 item-01) 38)
    ; item-02 starts at (0.8065, 0.2684, 0.0123) m
    (= (x item-02) 4565) (= (y item-02) 5684) (= (z item-02) 0)
    ; What each operator promises for item-02 (features 0.1478 0.05477 0.02454 0).
    ; Not for item-02:
    ; lift-0110b-solid-low-narrow-01: keeps its promise with such objects in about 5 of 30 only.
    ; place-back-0000-solid-low-narrow-01: keeps its promise in 2 of 30 rehearsals only.
    ; push-right-1001-solid-low-narrow-01: keeps its promise in 1 of 30 rehearsals only.
    (can-lift-0000-solid-low-narrow-01 item-02) (= (x-of-lift-0000-solid-low-narrow-01 item-02) 9172) (= (y-of-lift-0000-solid-low-narrow-01 item-02) 9938) (= (z-of-lift-0000-solid-low-narrow-01 item-02) 12017) (= (cost-of-lift-0000-solid-low-narrow-01 item-02) 7)
    (= (x-of-put-down-lift-0000-solid-low-narrow-01 item-02) 10009) (= (y-of-put-down-lift-0000-solid-low-narrow-01 item-02) 9983) (= (z-of-put-down-lift-0000-solid-low-narrow-01 item-02) 7983)
    (can-lift-0000a-solid-low-narrow-01 item-02) (= (x-of-lift-0000a-solid-low-narrow-01 item-02) 9496) (= (y-of-lift-0000a-solid-low-narrow-01 item-02) 10251) (= (z-of-lift-0000a-solid-low-narrow-01 item-02) 12439) (= (cost-of-lift-0000a-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-0000a-solid-low-narrow-01 item-02) 10001) (= (y-of-put-down-lift-0000a-solid-low-narrow-01 item-02) 9985) (= (z-of-put-down-lift-0000a-solid-low-narrow-01 item-02) 7561)
    (can-lift-0001-solid-low-narrow-01 item-02) (= (x-of-lift-0001-solid-low-narrow-01 item-02) 9685) (= (y-of-lift-0001-solid-low-narrow-01 item-02) 9788) (= (z-of-lift-0001-solid-low-narrow-01 item-02) 12370) (= (cost-of-lift-0001-solid-low-narrow-01 item-02) 7)
    (= (x-of-put-down-lift-0001-solid-low-narrow-01 item-02) 9993) (= (y-of-put-down-lift-0001-solid-low-narrow-01 item-02) 9995) (= (z-of-put-down-lift-0001-solid-low-narrow-01 item-02) 7630)
    (can-lift-0001a-solid-low-narrow-01 item-02) (= (x-of-lift-0001a-solid-low-narrow-01 item-02) 9848) (= (y-of-lift-0001a-solid-low-narrow-01 item-02) 9790) (= (z-of-lift-0001a-solid-low-narrow-01 item-02) 11985) (= (cost-of-lift-0001a-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-0001a-solid-low-narrow-01 item-02) 10017) (= (y-of-put-down-lift-0001a-solid-low-narrow-01 item-02) 9982) (= (z-of-put-down-lift-0001a-solid-low-narrow-01 item-02) 8015)
    (can-lift-0010-solid-low-narrow-01 item-02) (= (x-of-lift-0010-solid-low-narrow-01 item-02) 10273) (= (y-of-lift-0010-solid-low-narrow-01 item-02) 10219) (= (z-of-lift-0010-solid-low-narrow-01 item-02) 12303) (= (cost-of-lift-0010-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-0010-solid-low-narrow-01 item-02) 10000) (= (y-of-put-down-lift-0010-solid-low-narrow-01 item-02) 9985) (= (z-of-put-down-lift-0010-solid-low-narrow-01 item-02) 7697)
    (can-lift-0011b-solid-low-narrow-01 item-02) (= (x-of-lift-0011b-solid-low-narrow-01 item-02) 10395) (= (y-of-lift-0011b-solid-low-narrow-01 item-02) 9554) (= (z-of-lift-0011b-solid-low-narrow-01 item-02) 12390) (= (cost-of-lift-0011b-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-0011b-solid-low-narrow-01 item-02) 9992) (= (y-of-put-down-lift-0011b-solid-low-narrow-01 item-02) 9986) (= (z-of-put-down-lift-0011b-solid-low-narrow-01 item-02) 7610)
    (= (x-of-lift-0110b-solid-low-narrow-01 item-02) 10546) (= (y-of-lift-0110b-solid-low-narrow-01 item-02) 9919) (= (z-of-lift-0110b-solid-low-narrow-01 item-02) 12002) (= (cost-of-lift-0110b-solid-low-narrow-01 item-02) 168)
    (= (x-of-put-down-lift-0110b-solid-low-narrow-01 item-02) 9999) (= (y-of-put-down-lift-0110b-solid-low-narrow-01 item-02) 9983) (= (z-of-put-down-lift-0110b-solid-low-narrow-01 item-02) 7998)
    (can-lift-1000-solid-low-narrow-01 item-02) (= (x-of-lift-1000-solid-low-narrow-01 item-02) 9624) (= (y-of-lift-1000-solid-low-narrow-01 item-02) 10430) (= (z-of-lift-1000-solid-low-narrow-01 item-02) 12000) (= (cost-of-lift-1000-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-1000-solid-low-narrow-01 item-02) 10002) (= (y-of-put-down-lift-1000-solid-low-narrow-01 item-02) 9984) (= (z-of-put-down-lift-1000-solid-low-narrow-01 item-02) 8000)
    (can-lift-1001-solid-low-narrow-01 item-02) (= (x-of-lift-1001-solid-low-narrow-01 item-02) 9927) (= (y-of-lift-1001-solid-low-narrow-01 item-02) 9476) (= (z-of-lift-1001-solid-low-narrow-01 item-02) 11988) (= (cost-of-lift-1001-solid-low-narrow-01 item-02) 7)
    (= (x-of-put-down-lift-1001-solid-low-narrow-01 item-02) 10017) (= (y-of-put-down-lift-1001-solid-low-narrow-01 item-02) 9984) (= (z-of-put-down-lift-1001-solid-low-narrow-01 item-02) 8012)
    (can-lift-1001b-solid-low-narrow-01 item-02) (= (x-of-lift-1001b-solid-low-narrow-01 item-02) 10398) (= (y-of-lift-1001b-solid-low-narrow-01 item-02) 9478) (= (z-of-lift-1001b-solid-low-narrow-01 item-02) 12007) (= (cost-of-lift-1001b-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-1001b-solid-low-narrow-01 item-02) 9997) (= (y-of-put-down-lift-1001b-solid-low-narrow-01 item-02) 9988) (= (z-of-put-down-lift-1001b-solid-low-narrow-01 item-02) 7993)
    (can-lift-1010-solid-low-narrow-01 item-02) (= (x-of-lift-1010-solid-low-narrow-01 item-02) 10298) (= (y-of-lift-1010-solid-low-narrow-01 item-02) 10457) (= (z-of-lift-1010-solid-low-narrow-01 item-02) 11996) (= (cost-of-lift-1010-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-1010-solid-low-narrow-01 item-02) 10002) (= (y-of-put-down-lift-1010-solid-low-narrow-01 item-02) 9982) (= (z-of-put-down-lift-1010-solid-low-narrow-01 item-02) 8004)
    (= (x-of-place-back-0000-solid-low-narrow-01 item-02) 9102) (= (y-of-place-back-0000-solid-low-narrow-01 item-02) 9982) (= (cost-of-place-back-0000-solid-low-narrow-01 item-02) 238)
    (can-place-right-0111b-solid-low-narrow-01 item-02) (= (x-of-place-right-0111b-solid-low-narrow-01 item-02) 10144) (= (y-of-place-right-0111b-solid-low-narrow-01 item-02) 9470) (= (cost-of-place-right-0111b-solid-low-narrow-01 item-02) 4)
    (can-pull-1100b-solid-low-narrow-01 item-02) (= (x-of-pull-1100b-solid-low-narrow-01 item-02) 9421) (= (y-of-pull-1100b-solid-low-narrow-01 item-02) 10164) (= (cost-of-pull-1100b-solid-low-narrow-01 item-02) 4)
    (can-pull-right-0100b-solid-low-narrow-01 item-02) (= (x-of-pull-right-0100b-solid-low-narrow-01 item-02) 9282) (= (y-of-pull-right-0100b-solid-low-narrow-01 item-02) 9633) (= (cost-of-pull-right-0100b-solid-low-narrow-01 item-02) 4)
    (can-pull-right-0110b-solid-low-narrow-01 item-02) (= (x-of-pull-right-0110b-solid-low-narrow-01 item-02) 9807) (= (y-of-pull-right-0110b-solid-low-narrow-01 item-02) 9898) (= (cost-of-pull-right-0110b-solid-low-narrow-01 item-02) 22)
    (can-pull-right-0111-solid-low-narrow-01 item-02) (= (x-of-pull-right-0111-solid-low-narrow-01 item-02) 9728) (= (y-of-pull-right-0111-solid-low-narrow-01 item-02) 9637) (= (cost-of-pull-right-0111-solid-low-narrow-01 item-02) 4)
    (can-push-forward-1011-solid-low-narrow-01 item-02) (= (x-of-push-forward-1011-solid-low-narrow-01 item-02) 10984) (= (y-of-push-forward-1011-solid-low-narrow-01 item-02) 10263) (= (cost-of-push-forward-1011-solid-low-narrow-01 item-02) 4)
    (can-push-forward-right-1111-solid-low-narrow-01 item-02) (= (x-of-push-forward-right-1111-solid-low-narrow-01 item-02) 10625) (= (y-of-push-forward-right-1111-solid-low-narrow-01 item-02) 9576) (= (cost-of-push-forward-right-1111-solid-low-narrow-01 item-02) 4)
    (can-push-left-0110-solid-low-narrow-01 item-02) (= (x-of-push-left-0110-solid-low-narrow-01 item-02) 9848) (= (y-of-push-left-0110-solid-low-narrow-01 item-02) 10754) (= (cost-of-push-left-0110-solid-low-narrow-01 item-02) 4)
    (can-push-left-1101-solid-low-narrow-01 item-02) (= (x-of-push-left-1101-solid-low-narrow-01 item-02) 9964) (= (y-of-push-left-1101-solid-low-narrow-01 item-02) 10372) (= (cost-of-push-left-1101-solid-low-narrow-01 item-02) 4)
    (can-push-left-1110b-solid-low-narrow-01 item-02) (= (x-of-push-left-1110b-solid-low-narrow-01 item-02) 10342) (= (y-of-push-left-1110b-solid-low-narrow-01 item-02) 11303) (= (cost-of-push-left-1110b-solid-low-narrow-01 item-02) 4)
    (can-push-right-0101b-solid-low-narrow-01 item-02) (= (x-of-push-right-0101b-solid-low-narrow-01 item-02) 9814) (= (y-of-push-right-0101b-solid-low-narrow-01 item-02) 8665) (= (cost-of-push-right-0101b-solid-low-narrow-01 item-02) 11)
    (= (x-of-push-right-1001-solid-low-narrow-01 item-02) 10009) (= (y-of-push-right-1001-solid-low-narrow-01 item-02) 9756) (= (cost-of-push-right-1001-solid-low-narrow-01 item-02) 278)
    ; item-03 starts at (0.7424, 0.0921, 0.0126) m
    (= (x item-03) 3924) (= (y item-03) 3921) (= (z item-03) 0)
    ; What each operator promises for item-03 (features 0.06223 0.06642 0.0252 0).
    ; Not for item-03:
    ; lift-1101a-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    ; pull-0110d-any-tall-narrow-11: scatters more than it moves.
    ; pull-right-0011c-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    ; push-left-1000-any-tall-narrow-11: keeps its promise in 2 of 30 rehearsals only.
    ; push-left-1101a-any-tall-narrow-11: scatters more than it moves.
    ; push-right-0001-any-tall-narrow-11: scatters more than it moves.
    ; push-right-0001a-any-tall-narrow-11: scatters more than it moves.
    ; push-right-0011-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    (can-lift-0000c-any-tall-narrow-11 item-03) (= (x-of-lift-0000c-any-tall-narrow-11 item-03) 9445) (= (y-of-lift-0000c-any-tall-narrow-11 item-03) 10469) (= (z-of-lift-0000c-any-tall-narrow-11 item-03) 11994) (= (cost-of-lift-0000c-any-tall-narrow-11 item-03) 4)
    (= (x-of-put-down-lift-0000c-any-tall-narrow-11 item-03) 10000) (= (y-of-put-down-lift-0000c-any-tall-narrow-11 item-03) 9989) (= (z-of-put-down-lift-0000c-any-tall-narrow-11 item-03) 8006)
    (can-lift-0001-any-tall-narrow-11 item-03) (= (x-of-lift-0001-any-tall-narrow-11 item-03) 9694) (= (y-of-lift-0001-any-tall-narrow-11 item-03) 9649) (= (z-of-lift-0001-any-tall-narrow-11 item-03) 12411) (= (cost-of-lift-0001-any-tall-narrow-11 item-03) 22)
    (= (x-of-put-down-lift-0001-any-tall-narrow-11 item-03) 9989) (= (y-of-put-down-lift-0001-any-tall-narrow-11 item-03) 9987) (= (z-of-put-down-lift-0001-any-tall-narrow-11 item-03) 7589)
    (can-lift-0001a-any-tall-narrow-11 item-03) (= (x-of-lift-0001a-any-tall-narrow-11 item-03) 9791) (= (y-of-lift-0001a-any-tall-narrow-11 item-03) 9796) (= (z-of-lift-0001a-any-tall-narrow-11 item-03) 11993) (= (cost-of-lift-0001a-any-tall-narrow-11 item-03) 84)
    (= (x-of-put-down-lift-0001a-any-tall-narrow-11 item-03) 9999) (= (y-of-put-down-lift-0001a-any-tall-narrow-11 item-03) 9986) (= (z-of-put-down-lift-0001a-any-tall-narrow-11 item-03) 8007)
    (can-lift-0010b-any-tall-narrow-11 item-03) (= (x-of-lift-0010b-any-tall-narrow-11 item-03) 10331) (= (y-of-lift-0010b-any-tall-narrow-11 item-03) 10228) (= (z-of-lift-0010b-any-tall-narrow-11 item-03) 12344) (= (cost-of-lift-0010b-any-tall-narrow-11 item-03) 4)
    (= (x-of-put-down-lift-0010b-any-tall-narrow-11 item-03) 10002) (= (y-of-put-down-lift-0010b-any-tall-narrow-11 item-03) 9989) (= (z-of-put-down-lift-0010b-any-tall-narrow-11 item-03) 7656)
    (can-lift-0011-any-tall-narrow-11 item-03) (= (x-of-lift-0011-any-tall-narrow-11 item-03) 10390) (= (y-of-lift-0011-any-tall-narrow-11 item-03) 9506) (= (z-of-lift-0011-any-tall-narrow-11 item-03) 12003) (= (cost-of-lift-0011-any-tall-narrow-11 item-03) 7)
    (= (x-of-put-down-lift-0011-any-tall-narrow-11 item-03) 9996) (= (y-of-put-down-lift-0011-any-tall-narrow-11 item-03) 9988) (= (z-of-put-down-lift-0011-any-tall-narrow-11 item-03) 7997)
    (can-lift-0011c-any-tall-narrow-11 item-03) (= (x-of-lift-0011c-any-tall-narrow-11 item-03) 9827) (= (y-of-lift-0011c-any-tall-narrow-11 item-03) 9674) (= (z-of-lift-0011c-any-tall-narrow-11 item-03) 12542) (= (cost-of-lift-0011c-any-tall-narrow-11 item-03) 7)
    (= (x-of-put-down-lift-0011c-any-tall-narrow-11 item-03) 10001) (= (y-of-put-down-lift-0011c-any-tall-narrow-11 item-03) 9985) (= (z-of-put-down-lift-0011c-any-tall-narrow-11 item-03) 7458)
    (can-lift-1000-any-tall-narrow-11 item-03) (= (x-of-lift-1000-any-tall-narrow-11 item-03) 9638) (= (y-of-lift-1000-any-tall-narrow-11 item-03) 10428) (= (z-of-lift-1000-any-tall-narrow-11 item-03) 12059) (= (cost-of-lift-1000-any-tall-narrow-11 item-03) 11)
    (= (x-of-put-down-lift-1000-any-tall-narrow-11 item-03) 10003) (= (y-of-put-down-lift-1000-any-tall-narrow-11 item-03) 9989) (= (z-of-put-down-lift-1000-any-tall-narrow-11 item-03) 7941)
    (can-lift-1001d-any-tall-narrow-11 item-03) (= (x-of-lift-1001d-any-tall-narrow-11 item-03) 10614) (= (y-of-lift-1001d-any-tall-narrow-11 item-03) 9530) (= (z-of-lift-1001d-any-tall-narrow-11 item-03) 12014) (= (cost-of-lift-1001d-any-tall-narrow-11 item-03) 7)
    (= (x-of-put-down-lift-1001d-any-tall-narrow-11 item-03) 9999) (= (y-of-put-down-lift-1001d-any-tall-narrow-11 item-03) 9981) (= (z-of-put-down-lift-1001d-any-tall-narrow-11 item-03) 7986)
    (can-lift-1010b-any-tall-narrow-11 item-03) (= (x-of-lift-1010b-any-tall-narrow-11 item-03) 10278) (= (y-of-lift-1010b-any-tall-narrow-11 item-03) 10222) (= (z-of-lift-1010b-any-tall-narrow-11 item-03) 12002) (= (cost-of-lift-1010b-any-tall-narrow-11 item-03) 4)
    (= (x-of-put-down-lift-1010b-any-tall-narrow-11 item-03) 10002) (= (y-of-put-down-lift-1010b-any-tall-narrow-11 item-03) 9990) (= (z-of-put-down-lift-1010b-any-tall-narrow-11 item-03) 7998)
    (= (x-of-lift-1101a-any-tall-narrow-11 item-03) 10284) (= (y-of-lift-1101a-any-tall-narrow-11 item-03) 10264) (= (z-of-lift-1101a-any-tall-narrow-11 item-03) 12038) (= (cost-of-lift-1101a-any-tall-narrow-11 item-03) 278)
    (= (x-of-put-down-lift-1101a-any-tall-narrow-11 item-03) 10041) (= (y-of-put-down-lift-1101a-any-tall-narrow-11 item-03) 10028) (= (z-of-put-down-lift-1101a-any-tall-narrow-11 item-03) 7962)
    (can-place-forward-right-0111d-any-tall-narrow-11 item-03) (= (x-of-place-forward-right-0111d-any-tall-narrow-11 item-03) 10319) (= (y-of-place-forward-right-0111d-any-tall-narrow-11 item-03) 9540) (= (cost-of-place-forward-right-0111d-any-tall-narrow-11 item-03) 4)
    (can-pull-0100-any-tall-narrow-11 item-03) (= (x-of-pull-0100-any-tall-narrow-11 item-03) 9235) (= (y-of-pull-0100-any-tall-narrow-11 item-03) 9939) (= (cost-of-pull-0100-any-tall-narrow-11 item-03) 4)
    (= (x-of-pull-0110d-any-tall-narrow-11 item-03) 9972) (= (y-of-pull-0110d-any-tall-narrow-11 item-03) 9921) (= (cost-of-pull-0110d-any-tall-narrow-11 item-03) 4)
    (can-pull-left-1110d-any-tall-narrow-11 item-03) (= (x-of-pull-left-1110d-any-tall-narrow-11 item-03) 9560) (= (y-of-pull-left-1110d-any-tall-narrow-11 item-03) 10640) (= (cost-of-pull-left-1110d-any-tall-narrow-11 item-03) 11)
    (= (x-of-pull-right-0011c-any-tall-narrow-11 item-03) 9570) (= (y-of-pull-right-0011c-any-tall-narrow-11 item-03) 9392) (= (cost-of-pull-right-0011c-any-tall-narrow-11 item-03) 278)
    (can-pull-right-0100d-any-tall-narrow-11 item-03) (= (x-of-pull-right-0100d-any-tall-narrow-11 item-03) 9431) (= (y-of-pull-right-0100d-any-tall-narrow-11 item-03) 9644) (= (cost-of-pull-right-0100d-any-tall-narrow-11 item-03) 4)
    (can-push-forward-1011-any-tall-narrow-11 item-03) (= (x-of-push-forward-1011-any-tall-narrow-11 item-03) 10897) (= (y-of-push-forward-1011-any-tall-narrow-11 item-03) 10099) (= (cost-of-push-forward-1011-any-tall-narrow-11 item-03) 11)
    (can-push-forward-1011b-any-tall-narrow-11 item-03) (= (x-of-push-forward-1011b-any-tall-narrow-11 item-03) 10762) (= (y-of-push-forward-1011b-any-tall-narrow-11 item-03) 10285) (= (cost-of-push-forward-1011b-any-tall-narrow-11 item-03) 4)
    (can-push-forward-1111b-any-tall-narrow-11 item-03) (= (x-of-push-forward-1111b-any-tall-narrow-11 item-03) 10412) (= (y-of-push-forward-1111b-any-tall-narrow-11 item-03) 10003) (= (cost-of-push-forward-1111b-any-tall-narrow-11 item-03) 4)
    (can-push-forward-left-1100d-any-tall-narrow-11 item-03) (= (x-of-push-forward-left-1100d-any-tall-narrow-11 item-03) 10147) (= (y-of-push-forward-left-1100d-any-tall-narrow-11 item-03) 10256) (= (cost-of-push-forward-left-1100d-any-tall-narrow-11 item-03) 4)
    (can-push-forward-right-1111-any-tall-narrow-11 item-03) (= (x-of-push-forward-right-1111-any-tall-narrow-11 item-03) 10675) (= (y-of-push-forward-right-1111-any-tall-narrow-11 item-03) 9777) (= (cost-of-push-forward-right-1111-any-tall-narrow-11 item-03) 22)
    (= (x-of-push-left-1000-any-tall-narrow-11 item-03) 9983) (= (y-of-push-left-1000-any-tall-narrow-11 item-03) 10111) (= (cost-of-push-left-1000-any-tall-narrow-11 item-03) 238)
    (= (x-of-push-left-1101a-any-tall-narrow-11 item-03) 9979) (= (y-of-push-left-1101a-any-tall-narrow-11 item-03) 10048) (= (cost-of-push-left-1101a-any-tall-narrow-11 item-03) 7)
    (= (x-of-push-right-0001-any-tall-narrow-11 item-03) 9891) (= (y-of-push-right-0001-any-tall-narrow-11 item-03) 9863) (= (cost-of-push-right-0001-any-tall-narrow-11 item-03) 187)
    (= (x-of-push-right-0001a-any-tall-narrow-11 item-03) 9847) (= (y-of-push-right-0001a-any-tall-narrow-11 item-03) 10123) (= (cost-of-push-right-0001a-any-tall-narrow-11 item-03) 59)
    (= (x-of-push-right-0011-any-tall-narrow-11 item-03) 10067) (= (y-of-push-right-0011-any-tall-narrow-11 item-03) 9731) (= (cost-of-push-right-0011-any-tall-narrow-11 item-03) 278)
    (can-push-right-0101d-any-tall-narrow-11 item-03) (= (x-of-push-right-0101d-any-tall-narrow-11 item-03) 9976) (= (y-of-push-right-0101d-any-tall-narrow-11 item-03) 9784) (= (cost-of-push-right-0101d-any-tall-narrow-11 item-03) 11)
    (can-push-right-0111-any-tall-narrow-11 item-03) (= (x-of-push-right-0111-any-tall-narrow-11 item-03) 9769) (= (y-of-push-right-0111-any-tall-narrow-11 item-03) 9630) (= (cost-of-push-right-0111-any-tall-narrow-11 item-03) 7))
  (:goal (and
    ; item-01 shall come to (0.7035, -0.1680, 0.0288) m, 353 mm from where it starts
    (<= (x item-01) 3990) (>= (x item-01) 3080)
    (<= (+ (x item-01) (y item-01)) 5498) (>= (+ (x item-01) (y item-01)) 4211)
    (<= (y item-01) 1775) (>= (y item-01) 865)
    (<= (+ (y item-01) 1571) (x item-01)) (<= (x item-01) (+ (y item-01) 2858))
    (>= (z item-01) 0) (<= (z item-01) 0)
    ; item-02 shall come to (0.4335, -0.1094, 0.0123) m, 531 mm from where it starts
    (<= (x item-02) 1290) (>= (x item-02) 380)
    (<= (+ (x item-02) (y item-02)) 3385) (>= (+ (x item-02) (y item-02)) 2098)
    (<= (y item-02) 2361) (>= (y item-02) 1451)
    (<= (y item-02) (+ (x item-02) 1714)) (<= (+ (x item-02) 427) (y item-02))
    (>= (z item-02) 0) (<= (z item-02) 0)
    ; item-03 shall come to (0.4585, 0.0880, 0.0126) m, 284 mm from where it starts
    (<= (x item-03) 1540) (>= (x item-03) 631)
    (<= (+ (x item-03) (y item-03)) 5609) (>= (+ (x item-03) (y item-03)) 4322)
    (<= (y item-03) 4335) (>= (y item-03) 3425)
    (<= (y item-03) (+ (x item-03) 3438)) (<= (+ (x item-03) 2151) (y item-03))
    (>= (z item-03) 0) (<= (z item-03) 0)))
  (:metric minimize (total-cost)))
