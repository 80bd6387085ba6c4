; Problem row-4-11 of the learned domain places, for its encoding numeric.
; How it came about: row, drawn with seed 12; draw 3.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem row-4-11)
  (:domain places-numeric)
  (:objects
    item-01 - solid-low-narrow-01
    item-02 - any-tall-narrow-11
    item-03 - hollow-wide-00
    item-04 - any-tall-narrow-11)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.7490, -0.0069, 0.0193) m
    (= (x item-01) 3990) (= (y item-01) 2931) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.1163 0.03188 0.03862 0).
    ; Not for item-01:
    ; lift-0110b-solid-low-narrow-01: keeps its promise with such objects in about 4 of 30 only.
    ; place-back-0000-solid-low-narrow-01: keeps its promise in 2 of 30 rehearsals only.
    ; push-right-1001-solid-low-narrow-01: keeps its promise in 1 of 30 rehearsals only.
    (can-lift-0000-solid-low-narrow-01 item-01) (= (x-of-lift-0000-solid-low-narrow-01 item-01) 9187) (= (y-of-lift-0000-solid-low-narrow-01 item-01) 9915) (= (z-of-lift-0000-solid-low-narrow-01 item-01) 12024) (= (cost-of-lift-0000-solid-low-narrow-01 item-01) 30)
    (= (x-of-put-down-lift-0000-solid-low-narrow-01 item-01) 10014) (= (y-of-put-down-lift-0000-solid-low-narrow-01 item-01) 9982) (= (z-of-put-down-lift-0000-solid-low-narrow-01 item-01) 7976)
    (can-lift-0000a-solid-low-narrow-01 item-01) (= (x-of-lift-0000a-solid-low-narrow-01 item-01) 9496) (= (y-of-lift-0000a-solid-low-narrow-01 item-01) 10244) (= (z-of-lift-0000a-solid-low-narrow-01 item-01) 12468) (= (cost-of-lift-0000a-solid-low-narrow-01 item-01) 4)
    (= (x-of-put-down-lift-0000a-solid-low-narrow-01 item-01) 10002) (= (y-of-put-down-lift-0000a-solid-low-narrow-01 item-01) 9981) (= (z-of-put-down-lift-0000a-solid-low-narrow-01 item-01) 7532)
    (can-lift-0001-solid-low-narrow-01 item-01) (= (x-of-lift-0001-solid-low-narrow-01 item-01) 9691) (= (y-of-lift-0001-solid-low-narrow-01 item-01) 9774) (= (z-of-lift-0001-solid-low-narrow-01 item-01) 12396) (= (cost-of-lift-0001-solid-low-narrow-01 item-01) 7)
    (= (x-of-put-down-lift-0001-solid-low-narrow-01 item-01) 9999) (= (y-of-put-down-lift-0001-solid-low-narrow-01 item-01) 9990) (= (z-of-put-down-lift-0001-solid-low-narrow-01 item-01) 7604)
    (can-lift-0001a-solid-low-narrow-01 item-01) (= (x-of-lift-0001a-solid-low-narrow-01 item-01) 9850) (= (y-of-lift-0001a-solid-low-narrow-01 item-01) 9807) (= (z-of-lift-0001a-solid-low-narrow-01 item-01) 11986) (= (cost-of-lift-0001a-solid-low-narrow-01 item-01) 4)
    (= (x-of-put-down-lift-0001a-solid-low-narrow-01 item-01) 10018) (= (y-of-put-down-lift-0001a-solid-low-narrow-01 item-01) 9988) (= (z-of-put-down-lift-0001a-solid-low-narrow-01 item-01) 8014)
    (can-lift-0010-solid-low-narrow-01 item-01) (= (x-of-lift-0010-solid-low-narrow-01 item-01) 10272) (= (y-of-lift-0010-solid-low-narrow-01 item-01) 10214) (= (z-of-lift-0010-solid-low-narrow-01 item-01) 12311) (= (cost-of-lift-0010-solid-low-narrow-01 item-01) 4)
    (= (x-of-put-down-lift-0010-solid-low-narrow-01 item-01) 10003) (= (y-of-put-down-lift-0010-solid-low-narrow-01 item-01) 9981) (= (z-of-put-down-lift-0010-solid-low-narrow-01 item-01) 7689)
    (can-lift-0011b-solid-low-narrow-01 item-01) (= (x-of-lift-0011b-solid-low-narrow-01 item-01) 10404) (= (y-of-lift-0011b-solid-low-narrow-01 item-01) 9560) (= (z-of-lift-0011b-solid-low-narrow-01 item-01) 12383) (= (cost-of-lift-0011b-solid-low-narrow-01 item-01) 4)
    (= (x-of-put-down-lift-0011b-solid-low-narrow-01 item-01) 9999) (= (y-of-put-down-lift-0011b-solid-low-narrow-01 item-01) 9988) (= (z-of-put-down-lift-0011b-solid-low-narrow-01 item-01) 7617)
    (= (x-of-lift-0110b-solid-low-narrow-01 item-01) 10546) (= (y-of-lift-0110b-solid-low-narrow-01 item-01) 9913) (= (z-of-lift-0110b-solid-low-narrow-01 item-01) 12021) (= (cost-of-lift-0110b-solid-low-narrow-01 item-01) 187)
    (= (x-of-put-down-lift-0110b-solid-low-narrow-01 item-01) 10002) (= (y-of-put-down-lift-0110b-solid-low-narrow-01 item-01) 9985) (= (z-of-put-down-lift-0110b-solid-low-narrow-01 item-01) 7979)
    (can-lift-1000-solid-low-narrow-01 item-01) (= (x-of-lift-1000-solid-low-narrow-01 item-01) 9630) (= (y-of-lift-1000-solid-low-narrow-01 item-01) 10427) (= (z-of-lift-1000-solid-low-narrow-01 item-01) 11995) (= (cost-of-lift-1000-solid-low-narrow-01 item-01) 4)
    (= (x-of-put-down-lift-1000-solid-low-narrow-01 item-01) 10003) (= (y-of-put-down-lift-1000-solid-low-narrow-01 item-01) 9979) (= (z-of-put-down-lift-1000-solid-low-narrow-01 item-01) 8005)
    (can-lift-1001-solid-low-narrow-01 item-01) (= (x-of-lift-1001-solid-low-narrow-01 item-01) 9822) (= (y-of-lift-1001-solid-low-narrow-01 item-01) 9505) (= (z-of-lift-1001-solid-low-narrow-01 item-01) 11974) (= (cost-of-lift-1001-solid-low-narrow-01 item-01) 7)
    (= (x-of-put-down-lift-1001-solid-low-narrow-01 item-01) 10021) (= (y-of-put-down-lift-1001-solid-low-narrow-01 item-01) 9983) (= (z-of-put-down-lift-1001-solid-low-narrow-01 item-01) 8026)
    (can-lift-1001b-solid-low-narrow-01 item-01) (= (x-of-lift-1001b-solid-low-narrow-01 item-01) 10387) (= (y-of-lift-1001b-solid-low-narrow-01 item-01) 9483) (= (z-of-lift-1001b-solid-low-narrow-01 item-01) 12002) (= (cost-of-lift-1001b-solid-low-narrow-01 item-01) 4)
    (= (x-of-put-down-lift-1001b-solid-low-narrow-01 item-01) 9996) (= (y-of-put-down-lift-1001b-solid-low-narrow-01 item-01) 9986) (= (z-of-put-down-lift-1001b-solid-low-narrow-01 item-01) 7998)
    (can-lift-1010-solid-low-narrow-01 item-01) (= (x-of-lift-1010-solid-low-narrow-01 item-01) 10312) (= (y-of-lift-1010-solid-low-narrow-01 item-01) 10447) (= (z-of-lift-1010-solid-low-narrow-01 item-01) 11986) (= (cost-of-lift-1010-solid-low-narrow-01 item-01) 4)
    (= (x-of-put-down-lift-1010-solid-low-narrow-01 item-01) 10010) (= (y-of-put-down-lift-1010-solid-low-narrow-01 item-01) 9980) (= (z-of-put-down-lift-1010-solid-low-narrow-01 item-01) 8014)
    (= (x-of-place-back-0000-solid-low-narrow-01 item-01) 9114) (= (y-of-place-back-0000-solid-low-narrow-01 item-01) 9932) (= (cost-of-place-back-0000-solid-low-narrow-01 item-01) 238)
    (can-place-right-0111b-solid-low-narrow-01 item-01) (= (x-of-place-right-0111b-solid-low-narrow-01 item-01) 10140) (= (y-of-place-right-0111b-solid-low-narrow-01 item-01) 9467) (= (cost-of-place-right-0111b-solid-low-narrow-01 item-01) 4)
    (can-pull-1100b-solid-low-narrow-01 item-01) (= (x-of-pull-1100b-solid-low-narrow-01 item-01) 9421) (= (y-of-pull-1100b-solid-low-narrow-01 item-01) 10165) (= (cost-of-pull-1100b-solid-low-narrow-01 item-01) 4)
    (can-pull-right-0100b-solid-low-narrow-01 item-01) (= (x-of-pull-right-0100b-solid-low-narrow-01 item-01) 9302) (= (y-of-pull-right-0100b-solid-low-narrow-01 item-01) 9631) (= (cost-of-pull-right-0100b-solid-low-narrow-01 item-01) 4)
    (can-pull-right-0110b-solid-low-narrow-01 item-01) (= (x-of-pull-right-0110b-solid-low-narrow-01 item-01) 9846) (= (y-of-pull-right-0110b-solid-low-narrow-01 item-01) 9916) (= (cost-of-pull-right-0110b-solid-low-narrow-01 item-01) 18)
    (can-pull-right-0111-solid-low-narrow-01 item-01) (= (x-of-pull-right-0111-solid-low-narrow-01 item-01) 9726) (= (y-of-pull-right-0111-solid-low-narrow-01 item-01) 9637) (= (cost-of-pull-right-0111-solid-low-narrow-01 item-01) 4)
    (can-push-forward-1011-solid-low-narrow-01 item-01) (= (x-of-push-forward-1011-solid-low-narrow-01 item-01) 11009) (= (y-of-push-forward-1011-solid-low-narrow-01 item-01) 10256) (= (cost-of-push-forward-1011-solid-low-narrow-01 item-01) 4)
    (can-push-forward-right-1111-solid-low-narrow-01 item-01) (= (x-of-push-forward-right-1111-solid-low-narrow-01 item-01) 10617) (= (y-of-push-forward-right-1111-solid-low-narrow-01 item-01) 9522) (= (cost-of-push-forward-right-1111-solid-low-narrow-01 item-01) 4)
    (can-push-left-0110-solid-low-narrow-01 item-01) (= (x-of-push-left-0110-solid-low-narrow-01 item-01) 9811) (= (y-of-push-left-0110-solid-low-narrow-01 item-01) 10642) (= (cost-of-push-left-0110-solid-low-narrow-01 item-01) 4)
    (can-push-left-1101-solid-low-narrow-01 item-01) (= (x-of-push-left-1101-solid-low-narrow-01 item-01) 9964) (= (y-of-push-left-1101-solid-low-narrow-01 item-01) 10368) (= (cost-of-push-left-1101-solid-low-narrow-01 item-01) 4)
    (can-push-left-1110b-solid-low-narrow-01 item-01) (= (x-of-push-left-1110b-solid-low-narrow-01 item-01) 10355) (= (y-of-push-left-1110b-solid-low-narrow-01 item-01) 11119) (= (cost-of-push-left-1110b-solid-low-narrow-01 item-01) 7)
    (can-push-right-0101b-solid-low-narrow-01 item-01) (= (x-of-push-right-0101b-solid-low-narrow-01 item-01) 9858) (= (y-of-push-right-0101b-solid-low-narrow-01 item-01) 8713) (= (cost-of-push-right-0101b-solid-low-narrow-01 item-01) 14)
    (= (x-of-push-right-1001-solid-low-narrow-01 item-01) 9988) (= (y-of-push-right-1001-solid-low-narrow-01 item-01) 9749) (= (cost-of-push-right-1001-solid-low-narrow-01 item-01) 278)
    ; item-02 starts at (0.6280, 0.2292, 0.0131) m
    (= (x item-02) 2780) (= (y item-02) 5292) (= (z item-02) 0)
    ; What each operator promises for item-02 (features 0.1677 0.08861 0.0261 1).
    ; Not for item-02:
    ; lift-1101a-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    ; pull-left-1110d-any-tall-narrow-11: scatters more than it moves.
    ; pull-right-0011c-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    ; push-left-1000-any-tall-narrow-11: keeps its promise with such objects in about 4 of 30 only.
    ; push-right-0001-any-tall-narrow-11: scatters more than it moves.
    ; push-right-0001a-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    ; push-right-0011-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    (can-lift-0000c-any-tall-narrow-11 item-02) (= (x-of-lift-0000c-any-tall-narrow-11 item-02) 9444) (= (y-of-lift-0000c-any-tall-narrow-11 item-02) 10478) (= (z-of-lift-0000c-any-tall-narrow-11 item-02) 11994) (= (cost-of-lift-0000c-any-tall-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-0000c-any-tall-narrow-11 item-02) 9999) (= (y-of-put-down-lift-0000c-any-tall-narrow-11 item-02) 9992) (= (z-of-put-down-lift-0000c-any-tall-narrow-11 item-02) 8006)
    (can-lift-0001-any-tall-narrow-11 item-02) (= (x-of-lift-0001-any-tall-narrow-11 item-02) 9752) (= (y-of-lift-0001-any-tall-narrow-11 item-02) 9366) (= (z-of-lift-0001-any-tall-narrow-11 item-02) 12404) (= (cost-of-lift-0001-any-tall-narrow-11 item-02) 34)
    (= (x-of-put-down-lift-0001-any-tall-narrow-11 item-02) 10000) (= (y-of-put-down-lift-0001-any-tall-narrow-11 item-02) 9977) (= (z-of-put-down-lift-0001-any-tall-narrow-11 item-02) 7596)
    (can-lift-0001a-any-tall-narrow-11 item-02) (= (x-of-lift-0001a-any-tall-narrow-11 item-02) 9795) (= (y-of-lift-0001a-any-tall-narrow-11 item-02) 9841) (= (z-of-lift-0001a-any-tall-narrow-11 item-02) 12000) (= (cost-of-lift-0001a-any-tall-narrow-11 item-02) 59)
    (= (x-of-put-down-lift-0001a-any-tall-narrow-11 item-02) 10000) (= (y-of-put-down-lift-0001a-any-tall-narrow-11 item-02) 9996) (= (z-of-put-down-lift-0001a-any-tall-narrow-11 item-02) 8000)
    (can-lift-0010b-any-tall-narrow-11 item-02) (= (x-of-lift-0010b-any-tall-narrow-11 item-02) 10331) (= (y-of-lift-0010b-any-tall-narrow-11 item-02) 10236) (= (z-of-lift-0010b-any-tall-narrow-11 item-02) 12362) (= (cost-of-lift-0010b-any-tall-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-0010b-any-tall-narrow-11 item-02) 10002) (= (y-of-put-down-lift-0010b-any-tall-narrow-11 item-02) 9993) (= (z-of-put-down-lift-0010b-any-tall-narrow-11 item-02) 7638)
    (can-lift-0011-any-tall-narrow-11 item-02) (= (x-of-lift-0011-any-tall-narrow-11 item-02) 10392) (= (y-of-lift-0011-any-tall-narrow-11 item-02) 9524) (= (z-of-lift-0011-any-tall-narrow-11 item-02) 12003) (= (cost-of-lift-0011-any-tall-narrow-11 item-02) 7)
    (= (x-of-put-down-lift-0011-any-tall-narrow-11 item-02) 10002) (= (y-of-put-down-lift-0011-any-tall-narrow-11 item-02) 9998) (= (z-of-put-down-lift-0011-any-tall-narrow-11 item-02) 7997)
    (can-lift-0011c-any-tall-narrow-11 item-02) (= (x-of-lift-0011c-any-tall-narrow-11 item-02) 9839) (= (y-of-lift-0011c-any-tall-narrow-11 item-02) 9680) (= (z-of-lift-0011c-any-tall-narrow-11 item-02) 12574) (= (cost-of-lift-0011c-any-tall-narrow-11 item-02) 7)
    (= (x-of-put-down-lift-0011c-any-tall-narrow-11 item-02) 10005) (= (y-of-put-down-lift-0011c-any-tall-narrow-11 item-02) 9992) (= (z-of-put-down-lift-0011c-any-tall-narrow-11 item-02) 7426)
    (can-lift-1000-any-tall-narrow-11 item-02) (= (x-of-lift-1000-any-tall-narrow-11 item-02) 9683) (= (y-of-lift-1000-any-tall-narrow-11 item-02) 10415) (= (z-of-lift-1000-any-tall-narrow-11 item-02) 12212) (= (cost-of-lift-1000-any-tall-narrow-11 item-02) 18)
    (= (x-of-put-down-lift-1000-any-tall-narrow-11 item-02) 9997) (= (y-of-put-down-lift-1000-any-tall-narrow-11 item-02) 9996) (= (z-of-put-down-lift-1000-any-tall-narrow-11 item-02) 7788)
    (can-lift-1001d-any-tall-narrow-11 item-02) (= (x-of-lift-1001d-any-tall-narrow-11 item-02) 10617) (= (y-of-lift-1001d-any-tall-narrow-11 item-02) 9542) (= (z-of-lift-1001d-any-tall-narrow-11 item-02) 12007) (= (cost-of-lift-1001d-any-tall-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-1001d-any-tall-narrow-11 item-02) 10001) (= (y-of-put-down-lift-1001d-any-tall-narrow-11 item-02) 9992) (= (z-of-put-down-lift-1001d-any-tall-narrow-11 item-02) 7993)
    (can-lift-1010b-any-tall-narrow-11 item-02) (= (x-of-lift-1010b-any-tall-narrow-11 item-02) 10278) (= (y-of-lift-1010b-any-tall-narrow-11 item-02) 10229) (= (z-of-lift-1010b-any-tall-narrow-11 item-02) 12003) (= (cost-of-lift-1010b-any-tall-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-1010b-any-tall-narrow-11 item-02) 10002) (= (y-of-put-down-lift-1010b-any-tall-narrow-11 item-02) 9993) (= (z-of-put-down-lift-1010b-any-tall-narrow-11 item-02) 7997)
    (= (x-of-lift-1101a-any-tall-narrow-11 item-02) 10284) (= (y-of-lift-1101a-any-tall-narrow-11 item-02) 10264) (= (z-of-lift-1101a-any-tall-narrow-11 item-02) 12038) (= (cost-of-lift-1101a-any-tall-narrow-11 item-02) 278)
    (= (x-of-put-down-lift-1101a-any-tall-narrow-11 item-02) 10041) (= (y-of-put-down-lift-1101a-any-tall-narrow-11 item-02) 10027) (= (z-of-put-down-lift-1101a-any-tall-narrow-11 item-02) 7962)
    (can-place-forward-right-0111d-any-tall-narrow-11 item-02) (= (x-of-place-forward-right-0111d-any-tall-narrow-11 item-02) 10322) (= (y-of-place-forward-right-0111d-any-tall-narrow-11 item-02) 9526) (= (cost-of-place-forward-right-0111d-any-tall-narrow-11 item-02) 4)
    (can-pull-0100-any-tall-narrow-11 item-02) (= (x-of-pull-0100-any-tall-narrow-11 item-02) 9125) (= (y-of-pull-0100-any-tall-narrow-11 item-02) 9787) (= (cost-of-pull-0100-any-tall-narrow-11 item-02) 4)
    (can-pull-0110d-any-tall-narrow-11 item-02) (= (x-of-pull-0110d-any-tall-narrow-11 item-02) 9834) (= (y-of-pull-0110d-any-tall-narrow-11 item-02) 9939) (= (cost-of-pull-0110d-any-tall-narrow-11 item-02) 4)
    (= (x-of-pull-left-1110d-any-tall-narrow-11 item-02) 9841) (= (y-of-pull-left-1110d-any-tall-narrow-11 item-02) 10224) (= (cost-of-pull-left-1110d-any-tall-narrow-11 item-02) 11)
    (= (x-of-pull-right-0011c-any-tall-narrow-11 item-02) 9570) (= (y-of-pull-right-0011c-any-tall-narrow-11 item-02) 9392) (= (cost-of-pull-right-0011c-any-tall-narrow-11 item-02) 278)
    (can-pull-right-0100d-any-tall-narrow-11 item-02) (= (x-of-pull-right-0100d-any-tall-narrow-11 item-02) 9425) (= (y-of-pull-right-0100d-any-tall-narrow-11 item-02) 9644) (= (cost-of-pull-right-0100d-any-tall-narrow-11 item-02) 4)
    (can-push-forward-1011-any-tall-narrow-11 item-02) (= (x-of-push-forward-1011-any-tall-narrow-11 item-02) 11024) (= (y-of-push-forward-1011-any-tall-narrow-11 item-02) 10209) (= (cost-of-push-forward-1011-any-tall-narrow-11 item-02) 11)
    (can-push-forward-1011b-any-tall-narrow-11 item-02) (= (x-of-push-forward-1011b-any-tall-narrow-11 item-02) 10775) (= (y-of-push-forward-1011b-any-tall-narrow-11 item-02) 10151) (= (cost-of-push-forward-1011b-any-tall-narrow-11 item-02) 4)
    (can-push-forward-1111b-any-tall-narrow-11 item-02) (= (x-of-push-forward-1111b-any-tall-narrow-11 item-02) 10405) (= (y-of-push-forward-1111b-any-tall-narrow-11 item-02) 10013) (= (cost-of-push-forward-1111b-any-tall-narrow-11 item-02) 4)
    (can-push-forward-left-1100d-any-tall-narrow-11 item-02) (= (x-of-push-forward-left-1100d-any-tall-narrow-11 item-02) 10165) (= (y-of-push-forward-left-1100d-any-tall-narrow-11 item-02) 10281) (= (cost-of-push-forward-left-1100d-any-tall-narrow-11 item-02) 4)
    (can-push-forward-right-1111-any-tall-narrow-11 item-02) (= (x-of-push-forward-right-1111-any-tall-narrow-11 item-02) 10571) (= (y-of-push-forward-right-1111-any-tall-narrow-11 item-02) 9688) (= (cost-of-push-forward-right-1111-any-tall-narrow-11 item-02) 14)
    (= (x-of-push-left-1000-any-tall-narrow-11 item-02) 9983) (= (y-of-push-left-1000-any-tall-narrow-11 item-02) 10114) (= (cost-of-push-left-1000-any-tall-narrow-11 item-02) 187)
    (can-push-left-1101a-any-tall-narrow-11 item-02) (= (x-of-push-left-1101a-any-tall-narrow-11 item-02) 9970) (= (y-of-push-left-1101a-any-tall-narrow-11 item-02) 10215) (= (cost-of-push-left-1101a-any-tall-narrow-11 item-02) 7)
    (= (x-of-push-right-0001-any-tall-narrow-11 item-02) 9877) (= (y-of-push-right-0001-any-tall-narrow-11 item-02) 9770) (= (cost-of-push-right-0001-any-tall-narrow-11 item-02) 128)
    (= (x-of-push-right-0001a-any-tall-narrow-11 item-02) 9940) (= (y-of-push-right-0001a-any-tall-narrow-11 item-02) 9926) (= (cost-of-push-right-0001a-any-tall-narrow-11 item-02) 278)
    (= (x-of-push-right-0011-any-tall-narrow-11 item-02) 10068) (= (y-of-push-right-0011-any-tall-narrow-11 item-02) 9730) (= (cost-of-push-right-0011-any-tall-narrow-11 item-02) 278)
    (can-push-right-0101d-any-tall-narrow-11 item-02) (= (x-of-push-right-0101d-any-tall-narrow-11 item-02) 9898) (= (y-of-push-right-0101d-any-tall-narrow-11 item-02) 9562) (= (cost-of-push-right-0101d-any-tall-narrow-11 item-02) 11)
    (can-push-right-0111-any-tall-narrow-11 item-02) (= (x-of-push-right-0111-any-tall-narrow-11 item-02) 9796) (= (y-of-push-right-0111-any-tall-narrow-11 item-02) 9414) (= (cost-of-push-right-0111-any-tall-narrow-11 item-02) 26)
    ; item-03 starts at (0.4346, 0.1761, 0.0107) m
    (= (x item-03) 846) (= (y item-03) 4761) (= (z item-03) 0)
    ; What each operator promises for item-03 (features 0.1016 0.1649 0.02132 1).
    ; Not for item-03:
    ; lift-0000-hollow-wide-00: keeps its promise in 1 of 30 rehearsals only.
    ; lift-1101-hollow-wide-00: keeps its promise in 0 of 30 rehearsals only.
    ; push-right-0010a-hollow-wide-00: keeps its promise in 1 of 30 rehearsals only.
    ; push-right-0011-hollow-wide-00: keeps its promise with such objects in about 4 of 30 only.
    (= (x-of-lift-0000-hollow-wide-00 item-03) 9314) (= (y-of-lift-0000-hollow-wide-00 item-03) 9329) (= (z-of-lift-0000-hollow-wide-00 item-03) 11994) (= (cost-of-lift-0000-hollow-wide-00 item-03) 278)
    (= (x-of-put-down-lift-0000-hollow-wide-00 item-03) 9980) (= (y-of-put-down-lift-0000-hollow-wide-00 item-03) 10006) (= (z-of-put-down-lift-0000-hollow-wide-00 item-03) 8006)
    (can-lift-0001-hollow-wide-00 item-03) (= (x-of-lift-0001-hollow-wide-00 item-03) 9682) (= (y-of-lift-0001-hollow-wide-00 item-03) 8996) (= (z-of-lift-0001-hollow-wide-00 item-03) 12365) (= (cost-of-lift-0001-hollow-wide-00 item-03) 4)
    (= (x-of-put-down-lift-0001-hollow-wide-00 item-03) 10001) (= (y-of-put-down-lift-0001-hollow-wide-00 item-03) 9968) (= (z-of-put-down-lift-0001-hollow-wide-00 item-03) 7635)
    (can-lift-0010a-hollow-wide-00 item-03) (= (x-of-lift-0010a-hollow-wide-00 item-03) 9913) (= (y-of-lift-0010a-hollow-wide-00 item-03) 9622) (= (z-of-lift-0010a-hollow-wide-00 item-03) 11955) (= (cost-of-lift-0010a-hollow-wide-00 item-03) 7)
    (= (x-of-put-down-lift-0010a-hollow-wide-00 item-03) 9996) (= (y-of-put-down-lift-0010a-hollow-wide-00 item-03) 9962) (= (z-of-put-down-lift-0010a-hollow-wide-00 item-03) 8045)
    (can-lift-0011-hollow-wide-00 item-03) (= (x-of-lift-0011-hollow-wide-00 item-03) 10390) (= (y-of-lift-0011-hollow-wide-00 item-03) 8703) (= (z-of-lift-0011-hollow-wide-00 item-03) 11914) (= (cost-of-lift-0011-hollow-wide-00 item-03) 43)
    (= (x-of-put-down-lift-0011-hollow-wide-00 item-03) 10000) (= (y-of-put-down-lift-0011-hollow-wide-00 item-03) 9956) (= (z-of-put-down-lift-0011-hollow-wide-00 item-03) 8086)
    (can-lift-0011a-hollow-wide-00 item-03) (= (x-of-lift-0011a-hollow-wide-00 item-03) 10346) (= (y-of-lift-0011a-hollow-wide-00 item-03) 9137) (= (z-of-lift-0011a-hollow-wide-00 item-03) 12358) (= (cost-of-lift-0011a-hollow-wide-00 item-03) 4)
    (= (x-of-put-down-lift-0011a-hollow-wide-00 item-03) 10002) (= (y-of-put-down-lift-0011a-hollow-wide-00 item-03) 9966) (= (z-of-put-down-lift-0011a-hollow-wide-00 item-03) 7642)
    (can-lift-1000-hollow-wide-00 item-03) (= (x-of-lift-1000-hollow-wide-00 item-03) 9663) (= (y-of-lift-1000-hollow-wide-00 item-03) 11083) (= (z-of-lift-1000-hollow-wide-00 item-03) 12005) (= (cost-of-lift-1000-hollow-wide-00 item-03) 7)
    (= (x-of-put-down-lift-1000-hollow-wide-00 item-03) 10005) (= (y-of-put-down-lift-1000-hollow-wide-00 item-03) 9973) (= (z-of-put-down-lift-1000-hollow-wide-00 item-03) 7995)
    (can-lift-1000a-hollow-wide-00 item-03) (= (x-of-lift-1000a-hollow-wide-00 item-03) 9579) (= (y-of-lift-1000a-hollow-wide-00 item-03) 10528) (= (z-of-lift-1000a-hollow-wide-00 item-03) 12277) (= (cost-of-lift-1000a-hollow-wide-00 item-03) 4)
    (= (x-of-put-down-lift-1000a-hollow-wide-00 item-03) 10000) (= (y-of-put-down-lift-1000a-hollow-wide-00 item-03) 9974) (= (z-of-put-down-lift-1000a-hollow-wide-00 item-03) 7723)
    (can-lift-1001a-hollow-wide-00 item-03) (= (x-of-lift-1001a-hollow-wide-00 item-03) 10371) (= (y-of-lift-1001a-hollow-wide-00 item-03) 10368) (= (z-of-lift-1001a-hollow-wide-00 item-03) 12100) (= (cost-of-lift-1001a-hollow-wide-00 item-03) 4)
    (= (x-of-put-down-lift-1001a-hollow-wide-00 item-03) 10002) (= (y-of-put-down-lift-1001a-hollow-wide-00 item-03) 9976) (= (z-of-put-down-lift-1001a-hollow-wide-00 item-03) 7900)
    (can-lift-1010a-hollow-wide-00 item-03) (= (x-of-lift-1010a-hollow-wide-00 item-03) 10087) (= (y-of-lift-1010a-hollow-wide-00 item-03) 11118) (= (z-of-lift-1010a-hollow-wide-00 item-03) 11935) (= (cost-of-lift-1010a-hollow-wide-00 item-03) 4)
    (= (x-of-put-down-lift-1010a-hollow-wide-00 item-03) 10001) (= (y-of-put-down-lift-1010a-hollow-wide-00 item-03) 9981) (= (z-of-put-down-lift-1010a-hollow-wide-00 item-03) 8065)
    (= (x-of-lift-1101-hollow-wide-00 item-03) 10241) (= (y-of-lift-1101-hollow-wide-00 item-03) 10145) (= (z-of-lift-1101-hollow-wide-00 item-03) 12001) (= (cost-of-lift-1101-hollow-wide-00 item-03) 348)
    (= (x-of-put-down-lift-1101-hollow-wide-00 item-03) 10001) (= (y-of-put-down-lift-1101-hollow-wide-00 item-03) 10008) (= (z-of-put-down-lift-1101-hollow-wide-00 item-03) 7999)
    (can-place-back-right-0000-hollow-wide-00 item-03) (= (x-of-place-back-right-0000-hollow-wide-00 item-03) 9389) (= (y-of-place-back-right-0000-hollow-wide-00 item-03) 9779) (= (cost-of-place-back-right-0000-hollow-wide-00 item-03) 26)
    (can-place-right-0111-hollow-wide-00 item-03) (= (x-of-place-right-0111-hollow-wide-00 item-03) 9704) (= (y-of-place-right-0111-hollow-wide-00 item-03) 8915) (= (cost-of-place-right-0111-hollow-wide-00 item-03) 7)
    (can-place-right-0111a-hollow-wide-00 item-03) (= (x-of-place-right-0111a-hollow-wide-00 item-03) 10040) (= (y-of-place-right-0111a-hollow-wide-00 item-03) 8908) (= (cost-of-place-right-0111a-hollow-wide-00 item-03) 4)
    (can-pull-0100-hollow-wide-00 item-03) (= (x-of-pull-0100-hollow-wide-00 item-03) 9452) (= (y-of-pull-0100-hollow-wide-00 item-03) 9889) (= (cost-of-pull-0100-hollow-wide-00 item-03) 11)
    (can-pull-left-0110a-hollow-wide-00 item-03) (= (x-of-pull-left-0110a-hollow-wide-00 item-03) 9849) (= (y-of-pull-left-0110a-hollow-wide-00 item-03) 10189) (= (cost-of-pull-left-0110a-hollow-wide-00 item-03) 4)
    (can-pull-right-0100a-hollow-wide-00 item-03) (= (x-of-pull-right-0100a-hollow-wide-00 item-03) 9867) (= (y-of-pull-right-0100a-hollow-wide-00 item-03) 9766) (= (cost-of-pull-right-0100a-hollow-wide-00 item-03) 4)
    (can-pull-right-0110-hollow-wide-00 item-03) (= (x-of-pull-right-0110-hollow-wide-00 item-03) 9944) (= (y-of-pull-right-0110-hollow-wide-00 item-03) 9692) (= (cost-of-pull-right-0110-hollow-wide-00 item-03) 7)
    (can-push-forward-1011a-hollow-wide-00 item-03) (= (x-of-push-forward-1011a-hollow-wide-00 item-03) 10764) (= (y-of-push-forward-1011a-hollow-wide-00 item-03) 9961) (= (cost-of-push-forward-1011a-hollow-wide-00 item-03) 11)
    (can-push-forward-1110a-hollow-wide-00 item-03) (= (x-of-push-forward-1110a-hollow-wide-00 item-03) 10277) (= (y-of-push-forward-1110a-hollow-wide-00 item-03) 9912) (= (cost-of-push-forward-1110a-hollow-wide-00 item-03) 4)
    (can-push-forward-left-1111a-hollow-wide-00 item-03) (= (x-of-push-forward-left-1111a-hollow-wide-00 item-03) 10205) (= (y-of-push-forward-left-1111a-hollow-wide-00 item-03) 10278) (= (cost-of-push-forward-left-1111a-hollow-wide-00 item-03) 4)
    (can-push-forward-right-0101a-hollow-wide-00 item-03) (= (x-of-push-forward-right-0101a-hollow-wide-00 item-03) 10449) (= (y-of-push-forward-right-0101a-hollow-wide-00 item-03) 9504) (= (cost-of-push-forward-right-0101a-hollow-wide-00 item-03) 4)
    (can-push-left-1100a-hollow-wide-00 item-03) (= (x-of-push-left-1100a-hollow-wide-00 item-03) 9818) (= (y-of-push-left-1100a-hollow-wide-00 item-03) 10893) (= (cost-of-push-left-1100a-hollow-wide-00 item-03) 11)
    (= (x-of-push-right-0010a-hollow-wide-00 item-03) 9878) (= (y-of-push-right-0010a-hollow-wide-00 item-03) 9330) (= (cost-of-push-right-0010a-hollow-wide-00 item-03) 278)
    (= (x-of-push-right-0011-hollow-wide-00 item-03) 10045) (= (y-of-push-right-0011-hollow-wide-00 item-03) 9537) (= (cost-of-push-right-0011-hollow-wide-00 item-03) 187)
    (can-push-right-1101-hollow-wide-00 item-03) (= (x-of-push-right-1101-hollow-wide-00 item-03) 10024) (= (y-of-push-right-1101-hollow-wide-00 item-03) 9581) (= (cost-of-push-right-1101-hollow-wide-00 item-03) 4)
    ; item-04 starts at (0.7889, -0.1710, 0.0284) m
    (= (x item-04) 4389) (= (y item-04) 1290) (= (z item-04) 0)
    ; What each operator promises for item-04 (features 0.1212 0.1212 0.05688 2).
    ; Not for item-04:
    ; lift-0011-any-tall-narrow-11: keeps its promise with such objects in about 7 of 30 only.
    ; lift-1000-any-tall-narrow-11: keeps its promise with such objects in about 7 of 30 only.
    ; pull-right-0011c-any-tall-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    ; push-left-1101a-any-tall-narrow-11: keeps its promise in 2 of 30 rehearsals only.
    ; push-right-0001-any-tall-narrow-11: keeps its promise in 2 of 30 rehearsals only.
    (can-lift-0000c-any-tall-narrow-11 item-04) (= (x-of-lift-0000c-any-tall-narrow-11 item-04) 9441) (= (y-of-lift-0000c-any-tall-narrow-11 item-04) 10487) (= (z-of-lift-0000c-any-tall-narrow-11 item-04) 12014) (= (cost-of-lift-0000c-any-tall-narrow-11 item-04) 4)
    (= (x-of-put-down-lift-0000c-any-tall-narrow-11 item-04) 10001) (= (y-of-put-down-lift-0000c-any-tall-narrow-11 item-04) 9995) (= (z-of-put-down-lift-0000c-any-tall-narrow-11 item-04) 7986)
    (can-lift-0001-any-tall-narrow-11 item-04) (= (x-of-lift-0001-any-tall-narrow-11 item-04) 9657) (= (y-of-lift-0001-any-tall-narrow-11 item-04) 9194) (= (z-of-lift-0001-any-tall-narrow-11 item-04) 12495) (= (cost-of-lift-0001-any-tall-narrow-11 item-04) 11)
    (= (x-of-put-down-lift-0001-any-tall-narrow-11 item-04) 10001) (= (y-of-put-down-lift-0001-any-tall-narrow-11 item-04) 9966) (= (z-of-put-down-lift-0001-any-tall-narrow-11 item-04) 7505)
    (can-lift-0001a-any-tall-narrow-11 item-04) (= (x-of-lift-0001a-any-tall-narrow-11 item-04) 9883) (= (y-of-lift-0001a-any-tall-narrow-11 item-04) 9578) (= (z-of-lift-0001a-any-tall-narrow-11 item-04) 11998) (= (cost-of-lift-0001a-any-tall-narrow-11 item-04) 77)
    (= (x-of-put-down-lift-0001a-any-tall-narrow-11 item-04) 10002) (= (y-of-put-down-lift-0001a-any-tall-narrow-11 item-04) 9985) (= (z-of-put-down-lift-0001a-any-tall-narrow-11 item-04) 8002)
    (can-lift-0010b-any-tall-narrow-11 item-04) (= (x-of-lift-0010b-any-tall-narrow-11 item-04) 10331) (= (y-of-lift-0010b-any-tall-narrow-11 item-04) 10239) (= (z-of-lift-0010b-any-tall-narrow-11 item-04) 12376) (= (cost-of-lift-0010b-any-tall-narrow-11 item-04) 4)
    (= (x-of-put-down-lift-0010b-any-tall-narrow-11 item-04) 10003) (= (y-of-put-down-lift-0010b-any-tall-narrow-11 item-04) 9994) (= (z-of-put-down-lift-0010b-any-tall-narrow-11 item-04) 7624)
    (= (x-of-lift-0011-any-tall-narrow-11 item-04) 10358) (= (y-of-lift-0011-any-tall-narrow-11 item-04) 9010) (= (z-of-lift-0011-any-tall-narrow-11 item-04) 11987) (= (cost-of-lift-0011-any-tall-narrow-11 item-04) 140)
    (= (x-of-put-down-lift-0011-any-tall-narrow-11 item-04) 9998) (= (y-of-put-down-lift-0011-any-tall-narrow-11 item-04) 9969) (= (z-of-put-down-lift-0011-any-tall-narrow-11 item-04) 8013)
    (can-lift-0011c-any-tall-narrow-11 item-04) (= (x-of-lift-0011c-any-tall-narrow-11 item-04) 9828) (= (y-of-lift-0011c-any-tall-narrow-11 item-04) 9679) (= (z-of-lift-0011c-any-tall-narrow-11 item-04) 12628) (= (cost-of-lift-0011c-any-tall-narrow-11 item-04) 7)
    (= (x-of-put-down-lift-0011c-any-tall-narrow-11 item-04) 9996) (= (y-of-put-down-lift-0011c-any-tall-narrow-11 item-04) 9995) (= (z-of-put-down-lift-0011c-any-tall-narrow-11 item-04) 7372)
    (= (x-of-lift-1000-any-tall-narrow-11 item-04) 9783) (= (y-of-lift-1000-any-tall-narrow-11 item-04) 10849) (= (z-of-lift-1000-any-tall-narrow-11 item-04) 12211) (= (cost-of-lift-1000-any-tall-narrow-11 item-04) 140)
    (= (x-of-put-down-lift-1000-any-tall-narrow-11 item-04) 10013) (= (y-of-put-down-lift-1000-any-tall-narrow-11 item-04) 9962) (= (z-of-put-down-lift-1000-any-tall-narrow-11 item-04) 7789)
    (can-lift-1001d-any-tall-narrow-11 item-04) (= (x-of-lift-1001d-any-tall-narrow-11 item-04) 10640) (= (y-of-lift-1001d-any-tall-narrow-11 item-04) 9550) (= (z-of-lift-1001d-any-tall-narrow-11 item-04) 11998) (= (cost-of-lift-1001d-any-tall-narrow-11 item-04) 4)
    (= (x-of-put-down-lift-1001d-any-tall-narrow-11 item-04) 10005) (= (y-of-put-down-lift-1001d-any-tall-narrow-11 item-04) 9995) (= (z-of-put-down-lift-1001d-any-tall-narrow-11 item-04) 8002)
    (can-lift-1010b-any-tall-narrow-11 item-04) (= (x-of-lift-1010b-any-tall-narrow-11 item-04) 10280) (= (y-of-lift-1010b-any-tall-narrow-11 item-04) 10228) (= (z-of-lift-1010b-any-tall-narrow-11 item-04) 12004) (= (cost-of-lift-1010b-any-tall-narrow-11 item-04) 4)
    (= (x-of-put-down-lift-1010b-any-tall-narrow-11 item-04) 10001) (= (y-of-put-down-lift-1010b-any-tall-narrow-11 item-04) 9995) (= (z-of-put-down-lift-1010b-any-tall-narrow-11 item-04) 7996)
    (can-lift-1101a-any-tall-narrow-11 item-04) (= (x-of-lift-1101a-any-tall-narrow-11 item-04) 10291) (= (y-of-lift-1101a-any-tall-narrow-11 item-04) 10268) (= (z-of-lift-1101a-any-tall-narrow-11 item-04) 12053) (= (cost-of-lift-1101a-any-tall-narrow-11 item-04) 11)
    (= (x-of-put-down-lift-1101a-any-tall-narrow-11 item-04) 10058) (= (y-of-put-down-lift-1101a-any-tall-narrow-11 item-04) 10030) (= (z-of-put-down-lift-1101a-any-tall-narrow-11 item-04) 7947)
    (can-place-forward-right-0111d-any-tall-narrow-11 item-04) (= (x-of-place-forward-right-0111d-any-tall-narrow-11 item-04) 10254) (= (y-of-place-forward-right-0111d-any-tall-narrow-11 item-04) 9881) (= (cost-of-place-forward-right-0111d-any-tall-narrow-11 item-04) 4)
    (can-pull-0100-any-tall-narrow-11 item-04) (= (x-of-pull-0100-any-tall-narrow-11 item-04) 8882) (= (y-of-pull-0100-any-tall-narrow-11 item-04) 9739) (= (cost-of-pull-0100-any-tall-narrow-11 item-04) 4)
    (can-pull-0110d-any-tall-narrow-11 item-04) (= (x-of-pull-0110d-any-tall-narrow-11 item-04) 9738) (= (y-of-pull-0110d-any-tall-narrow-11 item-04) 9937) (= (cost-of-pull-0110d-any-tall-narrow-11 item-04) 4)
    (can-pull-left-1110d-any-tall-narrow-11 item-04) (= (x-of-pull-left-1110d-any-tall-narrow-11 item-04) 9656) (= (y-of-pull-left-1110d-any-tall-narrow-11 item-04) 10294) (= (cost-of-pull-left-1110d-any-tall-narrow-11 item-04) 14)
    (= (x-of-pull-right-0011c-any-tall-narrow-11 item-04) 9570) (= (y-of-pull-right-0011c-any-tall-narrow-11 item-04) 9392) (= (cost-of-pull-right-0011c-any-tall-narrow-11 item-04) 278)
    (can-pull-right-0100d-any-tall-narrow-11 item-04) (= (x-of-pull-right-0100d-any-tall-narrow-11 item-04) 9471) (= (y-of-pull-right-0100d-any-tall-narrow-11 item-04) 9758) (= (cost-of-pull-right-0100d-any-tall-narrow-11 item-04) 4)
    (can-push-forward-1011-any-tall-narrow-11 item-04) (= (x-of-push-forward-1011-any-tall-narrow-11 item-04) 11177) (= (y-of-push-forward-1011-any-tall-narrow-11 item-04) 10255) (= (cost-of-push-forward-1011-any-tall-narrow-11 item-04) 11)
    (can-push-forward-1011b-any-tall-narrow-11 item-04) (= (x-of-push-forward-1011b-any-tall-narrow-11 item-04) 10838) (= (y-of-push-forward-1011b-any-tall-narrow-11 item-04) 10021) (= (cost-of-push-forward-1011b-any-tall-narrow-11 item-04) 4)
    (can-push-forward-1111b-any-tall-narrow-11 item-04) (= (x-of-push-forward-1111b-any-tall-narrow-11 item-04) 10399) (= (y-of-push-forward-1111b-any-tall-narrow-11 item-04) 10015) (= (cost-of-push-forward-1111b-any-tall-narrow-11 item-04) 4)
    (can-push-forward-left-1100d-any-tall-narrow-11 item-04) (= (x-of-push-forward-left-1100d-any-tall-narrow-11 item-04) 10168) (= (y-of-push-forward-left-1100d-any-tall-narrow-11 item-04) 10259) (= (cost-of-push-forward-left-1100d-any-tall-narrow-11 item-04) 4)
    (can-push-forward-right-1111-any-tall-narrow-11 item-04) (= (x-of-push-forward-right-1111-any-tall-narrow-11 item-04) 10640) (= (y-of-push-forward-right-1111-any-tall-narrow-11 item-04) 9594) (= (cost-of-push-forward-right-1111-any-tall-narrow-11 item-04) 7)
    (can-push-left-1000-any-tall-narrow-11 item-04) (= (x-of-push-left-1000-any-tall-narrow-11 item-04) 9986) (= (y-of-push-left-1000-any-tall-narrow-11 item-04) 10149) (= (cost-of-push-left-1000-any-tall-narrow-11 item-04) 30)
    (= (x-of-push-left-1101a-any-tall-narrow-11 item-04) 9891) (= (y-of-push-left-1101a-any-tall-narrow-11 item-04) 10176) (= (cost-of-push-left-1101a-any-tall-narrow-11 item-04) 238)
    (= (x-of-push-right-0001-any-tall-narrow-11 item-04) 9866) (= (y-of-push-right-0001-any-tall-narrow-11 item-04) 9656) (= (cost-of-push-right-0001-any-tall-narrow-11 item-04) 238)
    (can-push-right-0001a-any-tall-narrow-11 item-04) (= (x-of-push-right-0001a-any-tall-narrow-11 item-04) 9957) (= (y-of-push-right-0001a-any-tall-narrow-11 item-04) 9565) (= (cost-of-push-right-0001a-any-tall-narrow-11 item-04) 77)
    (can-push-right-0011-any-tall-narrow-11 item-04) (= (x-of-push-right-0011-any-tall-narrow-11 item-04) 10034) (= (y-of-push-right-0011-any-tall-narrow-11 item-04) 9635) (= (cost-of-push-right-0011-any-tall-narrow-11 item-04) 30)
    (can-push-right-0101d-any-tall-narrow-11 item-04) (= (x-of-push-right-0101d-any-tall-narrow-11 item-04) 9789) (= (y-of-push-right-0101d-any-tall-narrow-11 item-04) 9539) (= (cost-of-push-right-0101d-any-tall-narrow-11 item-04) 99)
    (can-push-right-0111-any-tall-narrow-11 item-04) (= (x-of-push-right-0111-any-tall-narrow-11 item-04) 9854) (= (y-of-push-right-0111-any-tall-narrow-11 item-04) 9585) (= (cost-of-push-right-0111-any-tall-narrow-11 item-04) 26))
  (:goal (and
    ; item-01 shall come to (0.6500, -0.2474, 0.0193) m, 260 mm from where it starts
    (<= (x item-01) 3455) (>= (x item-01) 2545)
    (<= (+ (x item-01) (y item-01)) 4170) (>= (+ (x item-01) (y item-01)) 2883)
    (<= (y item-01) 981) (>= (y item-01) 72)
    (<= (+ (y item-01) 1830) (x item-01)) (<= (x item-01) (+ (y item-01) 3117))
    (>= (z item-01) 0) (<= (z item-01) 0)
    ; item-02 shall come to (0.6500, -0.1471, 0.0131) m, 377 mm from where it starts
    (<= (x item-02) 3455) (>= (x item-02) 2545)
    (<= (+ (x item-02) (y item-02)) 5173) (>= (+ (x item-02) (y item-02)) 3885)
    (<= (y item-02) 1984) (>= (y item-02) 1074)
    (<= (+ (y item-02) 828) (x item-02)) (<= (x item-02) (+ (y item-02) 2115))
    (>= (z item-02) 0) (<= (z item-02) 0)
    ; item-03 shall come to (0.6500, 0.0196, 0.0107) m, 266 mm from where it starts
    (<= (x item-03) 3455) (>= (x item-03) 2545)
    (<= (+ (x item-03) (y item-03)) 6840) (>= (+ (x item-03) (y item-03)) 5553)
    (<= (y item-03) 3651) (>= (y item-03) 2742)
    (<= (y item-03) (+ (x item-03) 840)) (<= (x item-03) (+ (y item-03) 447))
    (>= (z item-03) 0) (<= (z item-03) 0)
    ; item-04 shall come to (0.6500, 0.2027, 0.0284) m, 399 mm from where it starts
    (<= (x item-04) 3455) (>= (x item-04) 2545)
    (<= (+ (x item-04) (y item-04)) 8670) (>= (+ (x item-04) (y item-04)) 7383)
    (<= (y item-04) 5482) (>= (y item-04) 4572)
    (<= (y item-04) (+ (x item-04) 2671)) (<= (+ (x item-04) 1384) (y item-04))
    (>= (z item-04) 0) (<= (z item-04) 0)))
  (:metric minimize (total-cost)))
