; Problem swap-2-07 of the learned domain places, for its encoding numeric.
; How it came about: swap, drawn with seed 8; draw 1.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem swap-2-07)
  (:domain places-numeric)
  (:objects
    item-01 - solid-low-narrow-01
    item-02 - solid-low-narrow-01)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.6246, -0.0402, 0.0131) m
    (= (x item-01) 2746) (= (y item-01) 2598) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.1077 0.03911 0.0262 0).
    ; Not for item-01:
    ; lift-0110b-solid-low-narrow-01: keeps its promise with such objects in about 5 of 30 only.
    ; place-back-0000-solid-low-narrow-01: keeps its promise with such objects in about 4 of 30 only.
    ; push-right-1001-solid-low-narrow-01: keeps its promise in 2 of 30 rehearsals only.
    (can-lift-0000-solid-low-narrow-01 item-01) (= (x-of-lift-0000-solid-low-narrow-01 item-01) 9191) (= (y-of-lift-0000-solid-low-narrow-01 item-01) 9915) (= (z-of-lift-0000-solid-low-narrow-01 item-01) 12023) (= (cost-of-lift-0000-solid-low-narrow-01 item-01) 38)
    (= (x-of-put-down-lift-0000-solid-low-narrow-01 item-01) 10013) (= (y-of-put-down-lift-0000-solid-low-narrow-01 item-01) 9981) (= (z-of-put-down-lift-0000-solid-low-narrow-01 item-01) 7977)
    (can-lift-0000a-solid-low-narrow-01 item-01) (= (x-of-lift-0000a-solid-low-narrow-01 item-01) 9496) (= (y-of-lift-0000a-solid-low-narrow-01 item-01) 10243) (= (z-of-lift-0000a-solid-low-narrow-01 item-01) 12438) (= (cost-of-lift-0000a-solid-low-narrow-01 item-01) 4)
    (= (x-of-put-down-lift-0000a-solid-low-narrow-01 item-01) 10001) (= (y-of-put-down-lift-0000a-solid-low-narrow-01 item-01) 9982) (= (z-of-put-down-lift-0000a-solid-low-narrow-01 item-01) 7562)
    (can-lift-0001-solid-low-narrow-01 item-01) (= (x-of-lift-0001-solid-low-narrow-01 item-01) 9678) (= (y-of-lift-0001-solid-low-narrow-01 item-01) 9790) (= (z-of-lift-0001-solid-low-narrow-01 item-01) 12381) (= (cost-of-lift-0001-solid-low-narrow-01 item-01) 7)
    (= (x-of-put-down-lift-0001-solid-low-narrow-01 item-01) 9998) (= (y-of-put-down-lift-0001-solid-low-narrow-01 item-01) 9987) (= (z-of-put-down-lift-0001-solid-low-narrow-01 item-01) 7619)
    (can-lift-0001a-solid-low-narrow-01 item-01) (= (x-of-lift-0001a-solid-low-narrow-01 item-01) 9862) (= (y-of-lift-0001a-solid-low-narrow-01 item-01) 9792) (= (z-of-lift-0001a-solid-low-narrow-01 item-01) 11978) (= (cost-of-lift-0001a-solid-low-narrow-01 item-01) 4)
    (= (x-of-put-down-lift-0001a-solid-low-narrow-01 item-01) 10024) (= (y-of-put-down-lift-0001a-solid-low-narrow-01 item-01) 9989) (= (z-of-put-down-lift-0001a-solid-low-narrow-01 item-01) 8022)
    (can-lift-0010-solid-low-narrow-01 item-01) (= (x-of-lift-0010-solid-low-narrow-01 item-01) 10272) (= (y-of-lift-0010-solid-low-narrow-01 item-01) 10214) (= (z-of-lift-0010-solid-low-narrow-01 item-01) 12297) (= (cost-of-lift-0010-solid-low-narrow-01 item-01) 4)
    (= (x-of-put-down-lift-0010-solid-low-narrow-01 item-01) 10002) (= (y-of-put-down-lift-0010-solid-low-narrow-01 item-01) 9981) (= (z-of-put-down-lift-0010-solid-low-narrow-01 item-01) 7703)
    (can-lift-0011b-solid-low-narrow-01 item-01) (= (x-of-lift-0011b-solid-low-narrow-01 item-01) 10392) (= (y-of-lift-0011b-solid-low-narrow-01 item-01) 9550) (= (z-of-lift-0011b-solid-low-narrow-01 item-01) 12372) (= (cost-of-lift-0011b-solid-low-narrow-01 item-01) 4)
    (= (x-of-put-down-lift-0011b-solid-low-narrow-01 item-01) 9993) (= (y-of-put-down-lift-0011b-solid-low-narrow-01 item-01) 9987) (= (z-of-put-down-lift-0011b-solid-low-narrow-01 item-01) 7628)
    (= (x-of-lift-0110b-solid-low-narrow-01 item-01) 10545) (= (y-of-lift-0110b-solid-low-narrow-01 item-01) 9912) (= (z-of-lift-0110b-solid-low-narrow-01 item-01) 11996) (= (cost-of-lift-0110b-solid-low-narrow-01 item-01) 168)
    (= (x-of-put-down-lift-0110b-solid-low-narrow-01 item-01) 10002) (= (y-of-put-down-lift-0110b-solid-low-narrow-01 item-01) 9983) (= (z-of-put-down-lift-0110b-solid-low-narrow-01 item-01) 8004)
    (can-lift-1000-solid-low-narrow-01 item-01) (= (x-of-lift-1000-solid-low-narrow-01 item-01) 9624) (= (y-of-lift-1000-solid-low-narrow-01 item-01) 10425) (= (z-of-lift-1000-solid-low-narrow-01 item-01) 11995) (= (cost-of-lift-1000-solid-low-narrow-01 item-01) 4)
    (= (x-of-put-down-lift-1000-solid-low-narrow-01 item-01) 10004) (= (y-of-put-down-lift-1000-solid-low-narrow-01 item-01) 9979) (= (z-of-put-down-lift-1000-solid-low-narrow-01 item-01) 8005)
    (can-lift-1001-solid-low-narrow-01 item-01) (= (x-of-lift-1001-solid-low-narrow-01 item-01) 9858) (= (y-of-lift-1001-solid-low-narrow-01 item-01) 9476) (= (z-of-lift-1001-solid-low-narrow-01 item-01) 11965) (= (cost-of-lift-1001-solid-low-narrow-01 item-01) 11)
    (= (x-of-put-down-lift-1001-solid-low-narrow-01 item-01) 10026) (= (y-of-put-down-lift-1001-solid-low-narrow-01 item-01) 9980) (= (z-of-put-down-lift-1001-solid-low-narrow-01 item-01) 8035)
    (can-lift-1001b-solid-low-narrow-01 item-01) (= (x-of-lift-1001b-solid-low-narrow-01 item-01) 10389) (= (y-of-lift-1001b-solid-low-narrow-01 item-01) 9476) (= (z-of-lift-1001b-solid-low-narrow-01 item-01) 12005) (= (cost-of-lift-1001b-solid-low-narrow-01 item-01) 4)
    (= (x-of-put-down-lift-1001b-solid-low-narrow-01 item-01) 9995) (= (y-of-put-down-lift-1001b-solid-low-narrow-01 item-01) 9987) (= (z-of-put-down-lift-1001b-solid-low-narrow-01 item-01) 7995)
    (can-lift-1010-solid-low-narrow-01 item-01) (= (x-of-lift-1010-solid-low-narrow-01 item-01) 10320) (= (y-of-lift-1010-solid-low-narrow-01 item-01) 10441) (= (z-of-lift-1010-solid-low-narrow-01 item-01) 11985) (= (cost-of-lift-1010-solid-low-narrow-01 item-01) 4)
    (= (x-of-put-down-lift-1010-solid-low-narrow-01 item-01) 10015) (= (y-of-put-down-lift-1010-solid-low-narrow-01 item-01) 9980) (= (z-of-put-down-lift-1010-solid-low-narrow-01 item-01) 8015)
    (= (x-of-place-back-0000-solid-low-narrow-01 item-01) 9104) (= (y-of-place-back-0000-solid-low-narrow-01 item-01) 9975) (= (cost-of-place-back-0000-solid-low-narrow-01 item-01) 187)
    (can-place-right-0111b-solid-low-narrow-01 item-01) (= (x-of-place-right-0111b-solid-low-narrow-01 item-01) 10143) (= (y-of-place-right-0111b-solid-low-narrow-01 item-01) 9463) (= (cost-of-place-right-0111b-solid-low-narrow-01 item-01) 4)
    (can-pull-1100b-solid-low-narrow-01 item-01) (= (x-of-pull-1100b-solid-low-narrow-01 item-01) 9421) (= (y-of-pull-1100b-solid-low-narrow-01 item-01) 10163) (= (cost-of-pull-1100b-solid-low-narrow-01 item-01) 4)
    (can-pull-right-0100b-solid-low-narrow-01 item-01) (= (x-of-pull-right-0100b-solid-low-narrow-01 item-01) 9283) (= (y-of-pull-right-0100b-solid-low-narrow-01 item-01) 9631) (= (cost-of-pull-right-0100b-solid-low-narrow-01 item-01) 4)
    (can-pull-right-0110b-solid-low-narrow-01 item-01) (= (x-of-pull-right-0110b-solid-low-narrow-01 item-01) 9751) (= (y-of-pull-right-0110b-solid-low-narrow-01 item-01) 9872) (= (cost-of-pull-right-0110b-solid-low-narrow-01 item-01) 22)
    (can-pull-right-0111-solid-low-narrow-01 item-01) (= (x-of-pull-right-0111-solid-low-narrow-01 item-01) 9726) (= (y-of-pull-right-0111-solid-low-narrow-01 item-01) 9640) (= (cost-of-pull-right-0111-solid-low-narrow-01 item-01) 4)
    (can-push-forward-1011-solid-low-narrow-01 item-01) (= (x-of-push-forward-1011-solid-low-narrow-01 item-01) 10979) (= (y-of-push-forward-1011-solid-low-narrow-01 item-01) 10243) (= (cost-of-push-forward-1011-solid-low-narrow-01 item-01) 4)
    (can-push-forward-right-1111-solid-low-narrow-01 item-01) (= (x-of-push-forward-right-1111-solid-low-narrow-01 item-01) 10629) (= (y-of-push-forward-right-1111-solid-low-narrow-01 item-01) 9544) (= (cost-of-push-forward-right-1111-solid-low-narrow-01 item-01) 4)
    (can-push-left-0110-solid-low-narrow-01 item-01) (= (x-of-push-left-0110-solid-low-narrow-01 item-01) 9863) (= (y-of-push-left-0110-solid-low-narrow-01 item-01) 10650) (= (cost-of-push-left-0110-solid-low-narrow-01 item-01) 4)
    (can-push-left-1101-solid-low-narrow-01 item-01) (= (x-of-push-left-1101-solid-low-narrow-01 item-01) 9964) (= (y-of-push-left-1101-solid-low-narrow-01 item-01) 10369) (= (cost-of-push-left-1101-solid-low-narrow-01 item-01) 4)
    (can-push-left-1110b-solid-low-narrow-01 item-01) (= (x-of-push-left-1110b-solid-low-narrow-01 item-01) 10394) (= (y-of-push-left-1110b-solid-low-narrow-01 item-01) 11207) (= (cost-of-push-left-1110b-solid-low-narrow-01 item-01) 4)
    (can-push-right-0101b-solid-low-narrow-01 item-01) (= (x-of-push-right-0101b-solid-low-narrow-01 item-01) 9827) (= (y-of-push-right-0101b-solid-low-narrow-01 item-01) 8710) (= (cost-of-push-right-0101b-solid-low-narrow-01 item-01) 7)
    (= (x-of-push-right-1001-solid-low-narrow-01 item-01) 9988) (= (y-of-push-right-1001-solid-low-narrow-01 item-01) 9754) (= (cost-of-push-right-1001-solid-low-narrow-01 item-01) 238)
    ; item-02 starts at (0.7783, -0.2010, 0.0239) m
    (= (x item-02) 4283) (= (y item-02) 990) (= (z item-02) 0)
    ; What each operator promises for item-02 (features 0.1312 0.0587 0.0478 1).
    ; Not for item-02:
    ; lift-0110b-solid-low-narrow-01: keeps its promise with such objects in about 3 of 30 only.
    ; place-back-0000-solid-low-narrow-01: keeps its promise in 2 of 30 rehearsals only.
    ; push-right-1001-solid-low-narrow-01: keeps its promise with such objects in about 4 of 30 only.
    (can-lift-0000-solid-low-narrow-01 item-02) (= (x-of-lift-0000-solid-low-narrow-01 item-02) 9150) (= (y-of-lift-0000-solid-low-narrow-01 item-02) 9944) (= (z-of-lift-0000-solid-low-narrow-01 item-02) 12026) (= (cost-of-lift-0000-solid-low-narrow-01 item-02) 11)
    (= (x-of-put-down-lift-0000-solid-low-narrow-01 item-02) 10018) (= (y-of-put-down-lift-0000-solid-low-narrow-01 item-02) 9986) (= (z-of-put-down-lift-0000-solid-low-narrow-01 item-02) 7974)
    (can-lift-0000a-solid-low-narrow-01 item-02) (= (x-of-lift-0000a-solid-low-narrow-01 item-02) 9495) (= (y-of-lift-0000a-solid-low-narrow-01 item-02) 10259) (= (z-of-lift-0000a-solid-low-narrow-01 item-02) 12521) (= (cost-of-lift-0000a-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-0000a-solid-low-narrow-01 item-02) 10002) (= (y-of-put-down-lift-0000a-solid-low-narrow-01 item-02) 9984) (= (z-of-put-down-lift-0000a-solid-low-narrow-01 item-02) 7479)
    (can-lift-0001-solid-low-narrow-01 item-02) (= (x-of-lift-0001-solid-low-narrow-01 item-02) 9704) (= (y-of-lift-0001-solid-low-narrow-01 item-02) 9749) (= (z-of-lift-0001-solid-low-narrow-01 item-02) 12434) (= (cost-of-lift-0001-solid-low-narrow-01 item-02) 7)
    (= (x-of-put-down-lift-0001-solid-low-narrow-01 item-02) 10004) (= (y-of-put-down-lift-0001-solid-low-narrow-01 item-02) 9989) (= (z-of-put-down-lift-0001-solid-low-narrow-01 item-02) 7566)
    (can-lift-0001a-solid-low-narrow-01 item-02) (= (x-of-lift-0001a-solid-low-narrow-01 item-02) 9853) (= (y-of-lift-0001a-solid-low-narrow-01 item-02) 9804) (= (z-of-lift-0001a-solid-low-narrow-01 item-02) 11988) (= (cost-of-lift-0001a-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-0001a-solid-low-narrow-01 item-02) 10015) (= (y-of-put-down-lift-0001a-solid-low-narrow-01 item-02) 9988) (= (z-of-put-down-lift-0001a-solid-low-narrow-01 item-02) 8012)
    (can-lift-0010-solid-low-narrow-01 item-02) (= (x-of-lift-0010-solid-low-narrow-01 item-02) 10273) (= (y-of-lift-0010-solid-low-narrow-01 item-02) 10224) (= (z-of-lift-0010-solid-low-narrow-01 item-02) 12350) (= (cost-of-lift-0010-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-0010-solid-low-narrow-01 item-02) 9999) (= (y-of-put-down-lift-0010-solid-low-narrow-01 item-02) 9987) (= (z-of-put-down-lift-0010-solid-low-narrow-01 item-02) 7650)
    (can-lift-0011b-solid-low-narrow-01 item-02) (= (x-of-lift-0011b-solid-low-narrow-01 item-02) 10404) (= (y-of-lift-0011b-solid-low-narrow-01 item-02) 9561) (= (z-of-lift-0011b-solid-low-narrow-01 item-02) 12398) (= (cost-of-lift-0011b-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-0011b-solid-low-narrow-01 item-02) 9997) (= (y-of-put-down-lift-0011b-solid-low-narrow-01 item-02) 9988) (= (z-of-put-down-lift-0011b-solid-low-narrow-01 item-02) 7602)
    (= (x-of-lift-0110b-solid-low-narrow-01 item-02) 10552) (= (y-of-lift-0110b-solid-low-narrow-01 item-02) 9933) (= (z-of-lift-0110b-solid-low-narrow-01 item-02) 12069) (= (cost-of-lift-0110b-solid-low-narrow-01 item-02) 209)
    (= (x-of-put-down-lift-0110b-solid-low-narrow-01 item-02) 9994) (= (y-of-put-down-lift-0110b-solid-low-narrow-01 item-02) 9986) (= (z-of-put-down-lift-0110b-solid-low-narrow-01 item-02) 7931)
    (can-lift-1000-solid-low-narrow-01 item-02) (= (x-of-lift-1000-solid-low-narrow-01 item-02) 9648) (= (y-of-lift-1000-solid-low-narrow-01 item-02) 10436) (= (z-of-lift-1000-solid-low-narrow-01 item-02) 11998) (= (cost-of-lift-1000-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-1000-solid-low-narrow-01 item-02) 10000) (= (y-of-put-down-lift-1000-solid-low-narrow-01 item-02) 9989) (= (z-of-put-down-lift-1000-solid-low-narrow-01 item-02) 8002)
    (can-lift-1001-solid-low-narrow-01 item-02) (= (x-of-lift-1001-solid-low-narrow-01 item-02) 9998) (= (y-of-lift-1001-solid-low-narrow-01 item-02) 9510) (= (z-of-lift-1001-solid-low-narrow-01 item-02) 11993) (= (cost-of-lift-1001-solid-low-narrow-01 item-02) 18)
    (= (x-of-put-down-lift-1001-solid-low-narrow-01 item-02) 10009) (= (y-of-put-down-lift-1001-solid-low-narrow-01 item-02) 9985) (= (z-of-put-down-lift-1001-solid-low-narrow-01 item-02) 8007)
    (can-lift-1001b-solid-low-narrow-01 item-02) (= (x-of-lift-1001b-solid-low-narrow-01 item-02) 10392) (= (y-of-lift-1001b-solid-low-narrow-01 item-02) 9489) (= (z-of-lift-1001b-solid-low-narrow-01 item-02) 12003) (= (cost-of-lift-1001b-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-1001b-solid-low-narrow-01 item-02) 9998) (= (y-of-put-down-lift-1001b-solid-low-narrow-01 item-02) 9990) (= (z-of-put-down-lift-1001b-solid-low-narrow-01 item-02) 7997)
    (can-lift-1010-solid-low-narrow-01 item-02) (= (x-of-lift-1010-solid-low-narrow-01 item-02) 10305) (= (y-of-lift-1010-solid-low-narrow-01 item-02) 10449) (= (z-of-lift-1010-solid-low-narrow-01 item-02) 11991) (= (cost-of-lift-1010-solid-low-narrow-01 item-02) 4)
    (= (x-of-put-down-lift-1010-solid-low-narrow-01 item-02) 10011) (= (y-of-put-down-lift-1010-solid-low-narrow-01 item-02) 9988) (= (z-of-put-down-lift-1010-solid-low-narrow-01 item-02) 8009)
    (= (x-of-place-back-0000-solid-low-narrow-01 item-02) 9110) (= (y-of-place-back-0000-solid-low-narrow-01 item-02) 9948) (= (cost-of-place-back-0000-solid-low-narrow-01 item-02) 238)
    (can-place-right-0111b-solid-low-narrow-01 item-02) (= (x-of-place-right-0111b-solid-low-narrow-01 item-02) 10136) (= (y-of-place-right-0111b-solid-low-narrow-01 item-02) 9494) (= (cost-of-place-right-0111b-solid-low-narrow-01 item-02) 4)
    (can-pull-1100b-solid-low-narrow-01 item-02) (= (x-of-pull-1100b-solid-low-narrow-01 item-02) 9421) (= (y-of-pull-1100b-solid-low-narrow-01 item-02) 10169) (= (cost-of-pull-1100b-solid-low-narrow-01 item-02) 4)
    (can-pull-right-0100b-solid-low-narrow-01 item-02) (= (x-of-pull-right-0100b-solid-low-narrow-01 item-02) 9324) (= (y-of-pull-right-0100b-solid-low-narrow-01 item-02) 9632) (= (cost-of-pull-right-0100b-solid-low-narrow-01 item-02) 4)
    (can-pull-right-0110b-solid-low-narrow-01 item-02) (= (x-of-pull-right-0110b-solid-low-narrow-01 item-02) 9888) (= (y-of-pull-right-0110b-solid-low-narrow-01 item-02) 9903) (= (cost-of-pull-right-0110b-solid-low-narrow-01 item-02) 14)
    (can-pull-right-0111-solid-low-narrow-01 item-02) (= (x-of-pull-right-0111-solid-low-narrow-01 item-02) 9732) (= (y-of-pull-right-0111-solid-low-narrow-01 item-02) 9651) (= (cost-of-pull-right-0111-solid-low-narrow-01 item-02) 4)
    (can-push-forward-1011-solid-low-narrow-01 item-02) (= (x-of-push-forward-1011-solid-low-narrow-01 item-02) 11004) (= (y-of-push-forward-1011-solid-low-narrow-01 item-02) 10255) (= (cost-of-push-forward-1011-solid-low-narrow-01 item-02) 4)
    (can-push-forward-right-1111-solid-low-narrow-01 item-02) (= (x-of-push-forward-right-1111-solid-low-narrow-01 item-02) 10634) (= (y-of-push-forward-right-1111-solid-low-narrow-01 item-02) 9568) (= (cost-of-push-forward-right-1111-solid-low-narrow-01 item-02) 4)
    (can-push-left-0110-solid-low-narrow-01 item-02) (= (x-of-push-left-0110-solid-low-narrow-01 item-02) 9657) (= (y-of-push-left-0110-solid-low-narrow-01 item-02) 10749) (= (cost-of-push-left-0110-solid-low-narrow-01 item-02) 4)
    (can-push-left-1101-solid-low-narrow-01 item-02) (= (x-of-push-left-1101-solid-low-narrow-01 item-02) 9964) (= (y-of-push-left-1101-solid-low-narrow-01 item-02) 10371) (= (cost-of-push-left-1101-solid-low-narrow-01 item-02) 4)
    (can-push-left-1110b-solid-low-narrow-01 item-02) (= (x-of-push-left-1110b-solid-low-narrow-01 item-02) 10235) (= (y-of-push-left-1110b-solid-low-narrow-01 item-02) 11133) (= (cost-of-push-left-1110b-solid-low-narrow-01 item-02) 14)
    (can-push-right-0101b-solid-low-narrow-01 item-02) (= (x-of-push-right-0101b-solid-low-narrow-01 item-02) 9732) (= (y-of-push-right-0101b-solid-low-narrow-01 item-02) 8687) (= (cost-of-push-right-0101b-solid-low-narrow-01 item-02) 11)
    (= (x-of-push-right-1001-solid-low-narrow-01 item-02) 10023) (= (y-of-push-right-1001-solid-low-narrow-01 item-02) 9738) (= (cost-of-push-right-1001-solid-low-narrow-01 item-02) 187))
  (:goal (and
    ; item-01 shall come to (0.7783, -0.2010, 0.0131) m, 222 mm from where it starts
    (<= (x item-01) 4738) (>= (x item-01) 3828)
    (<= (+ (x item-01) (y item-01)) 5917) (>= (+ (x item-01) (y item-01)) 4630)
    (<= (y item-01) 1445) (>= (y item-01) 535)
    (<= (+ (y item-01) 2650) (x item-01)) (<= (x item-01) (+ (y item-01) 3937))
    (>= (z item-01) 0) (<= (z item-01) 0)
    ; item-02 shall come to (0.6246, -0.0402, 0.0239) m, 222 mm from where it starts
    (<= (x item-02) 3201) (>= (x item-02) 2291)
    (<= (+ (x item-02) (y item-02)) 5987) (>= (+ (x item-02) (y item-02)) 4700)
    (<= (y item-02) 3053) (>= (y item-02) 2143)
    (<= (y item-02) (+ (x item-02) 496)) (<= (x item-02) (+ (y item-02) 791))
    (>= (z item-02) 0) (<= (z item-02) 0)))
  (:metric minimize (total-cost)))
