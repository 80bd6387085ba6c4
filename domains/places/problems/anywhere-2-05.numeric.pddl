; Problem anywhere-2-05 of the learned domain places, for its encoding numeric.
; How it came about: anywhere, drawn with seed 6; draw 1.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem anywhere-2-05)
  (:domain places-numeric)
  (:objects
    item-01 - solid-low-narrow-01
    item-02 - solid-low-10)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.7197, -0.0540, 0.0267) m
    (= (x item-01) 3697) (= (y item-01) 2460) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.1071 0.06564 0.05331 0).
    ; Not for item-01:
    ; lift-0110b-solid-low-narrow-01: keeps its promise with such objects in about 5 of 30 only.
    ; place-back-0000-solid-low-narrow-01: keeps its promise with such objects in about 7 of 30 only.
    ; pull-right-0110b-solid-low-narrow-01: scatters more than it moves.
    (can-lift-0000-solid-low-narrow-01 item-01) (= (x-of-lift-0000-solid-low-narrow-01 item-01) 9149) (= (y-of-lift-0000-solid-low-narrow-01 item-01) 9946) (= (z-of-lift-0000-solid-low-narrow-01 item-01) 12021) (= (cost-of-lift-0000-solid-low-narrow-01 item-01) 38)
    (= (x-of-put-down-lift-0000-solid-low-narrow-01 item-01) 10019) (= (y-of-put-down-lift-0000-solid-low-narrow-01 item-01) 9987) (= (z-of-put-down-lift-0000-solid-low-narrow-01 item-01) 7979)
    (can-lift-0000a-solid-low-narrow-01 item-01) (= (x-of-lift-0000a-solid-low-narrow-01 item-01) 9494) (= (y-of-lift-0000a-solid-low-narrow-01 item-01) 10258) (= (z-of-lift-0000a-solid-low-narrow-01 item-01) 12534) (= (cost-of-lift-0000a-solid-low-narrow-01 item-01) 4)
    (= (x-of-put-down-lift-0000a-solid-low-narrow-01 item-01) 10003) (= (y-of-put-down-lift-0000a-solid-low-narrow-01 item-01) 9985) (= (z-of-put-down-lift-0000a-solid-low-narrow-01 item-01) 7466)
    (can-lift-0001-solid-low-narrow-01 item-01) (= (x-of-lift-0001-solid-low-narrow-01 item-01) 9693) (= (y-of-lift-0001-solid-low-narrow-01 item-01) 9782) (= (z-of-lift-0001-solid-low-narrow-01 item-01) 12470) (= (cost-of-lift-0001-solid-low-narrow-01 item-01) 7)
    (= (x-of-put-down-lift-0001-solid-low-narrow-01 item-01) 10002) (= (y-of-put-down-lift-0001-solid-low-narrow-01 item-01) 9991) (= (z-of-put-down-lift-0001-solid-low-narrow-01 item-01) 7530)
    (can-lift-0001a-solid-low-narrow-01 item-01) (= (x-of-lift-0001a-solid-low-narrow-01 item-01) 9835) (= (y-of-lift-0001a-solid-low-narrow-01 item-01) 9806) (= (z-of-lift-0001a-solid-low-narrow-01 item-01) 11981) (= (cost-of-lift-0001a-solid-low-narrow-01 item-01) 4)
    (= (x-of-put-down-lift-0001a-solid-low-narrow-01 item-01) 10000) (= (y-of-put-down-lift-0001a-solid-low-narrow-01 item-01) 9983) (= (z-of-put-down-lift-0001a-solid-low-narrow-01 item-01) 8019)
    (can-lift-0010-solid-low-narrow-01 item-01) (= (x-of-lift-0010-solid-low-narrow-01 item-01) 10273) (= (y-of-lift-0010-solid-low-narrow-01 item-01) 10225) (= (z-of-lift-0010-solid-low-narrow-01 item-01) 12347) (= (cost-of-lift-0010-solid-low-narrow-01 item-01) 4)
    (= (x-of-put-down-lift-0010-solid-low-narrow-01 item-01) 10002) (= (y-of-put-down-lift-0010-solid-low-narrow-01 item-01) 9987) (= (z-of-put-down-lift-0010-solid-low-narrow-01 item-01) 7653)
    (can-lift-0011b-solid-low-narrow-01 item-01) (= (x-of-lift-0011b-solid-low-narrow-01 item-01) 10411) (= (y-of-lift-0011b-solid-low-narrow-01 item-01) 9566) (= (z-of-lift-0011b-solid-low-narrow-01 item-01) 12400) (= (cost-of-lift-0011b-solid-low-narrow-01 item-01) 4)
    (= (x-of-put-down-lift-0011b-solid-low-narrow-01 item-01) 9995) (= (y-of-put-down-lift-0011b-solid-low-narrow-01 item-01) 9987) (= (z-of-put-down-lift-0011b-solid-low-narrow-01 item-01) 7600)
    (= (x-of-lift-0110b-solid-low-narrow-01 item-01) 10556) (= (y-of-lift-0110b-solid-low-narrow-01 item-01) 9934) (= (z-of-lift-0110b-solid-low-narrow-01 item-01) 12065) (= (cost-of-lift-0110b-solid-low-narrow-01 item-01) 168)
    (= (x-of-put-down-lift-0110b-solid-low-narrow-01 item-01) 9999) (= (y-of-put-down-lift-0110b-solid-low-narrow-01 item-01) 9989) (= (z-of-put-down-lift-0110b-solid-low-narrow-01 item-01) 7935)
    (can-lift-1000-solid-low-narrow-01 item-01) (= (x-of-lift-1000-solid-low-narrow-01 item-01) 9638) (= (y-of-lift-1000-solid-low-narrow-01 item-01) 10438) (= (z-of-lift-1000-solid-low-narrow-01 item-01) 11997) (= (cost-of-lift-1000-solid-low-narrow-01 item-01) 4)
    (= (x-of-put-down-lift-1000-solid-low-narrow-01 item-01) 10001) (= (y-of-put-down-lift-1000-solid-low-narrow-01 item-01) 9988) (= (z-of-put-down-lift-1000-solid-low-narrow-01 item-01) 8003)
    (can-lift-1001-solid-low-narrow-01 item-01) (= (x-of-lift-1001-solid-low-narrow-01 item-01) 10015) (= (y-of-lift-1001-solid-low-narrow-01 item-01) 9538) (= (z-of-lift-1001-solid-low-narrow-01 item-01) 12000) (= (cost-of-lift-1001-solid-low-narrow-01 item-01) 64)
    (= (x-of-put-down-lift-1001-solid-low-narrow-01 item-01) 9999) (= (y-of-put-down-lift-1001-solid-low-narrow-01 item-01) 9986) (= (z-of-put-down-lift-1001-solid-low-narrow-01 item-01) 8000)
    (can-lift-1001b-solid-low-narrow-01 item-01) (= (x-of-lift-1001b-solid-low-narrow-01 item-01) 10396) (= (y-of-lift-1001b-solid-low-narrow-01 item-01) 9492) (= (z-of-lift-1001b-solid-low-narrow-01 item-01) 12002) (= (cost-of-lift-1001b-solid-low-narrow-01 item-01) 4)
    (= (x-of-put-down-lift-1001b-solid-low-narrow-01 item-01) 9998) (= (y-of-put-down-lift-1001b-solid-low-narrow-01 item-01) 9990) (= (z-of-put-down-lift-1001b-solid-low-narrow-01 item-01) 7998)
    (can-lift-1010-solid-low-narrow-01 item-01) (= (x-of-lift-1010-solid-low-narrow-01 item-01) 10279) (= (y-of-lift-1010-solid-low-narrow-01 item-01) 10449) (= (z-of-lift-1010-solid-low-narrow-01 item-01) 11997) (= (cost-of-lift-1010-solid-low-narrow-01 item-01) 4)
    (= (x-of-put-down-lift-1010-solid-low-narrow-01 item-01) 10009) (= (y-of-put-down-lift-1010-solid-low-narrow-01 item-01) 9989) (= (z-of-put-down-lift-1010-solid-low-narrow-01 item-01) 8003)
    (= (x-of-place-back-0000-solid-low-narrow-01 item-01) 9024) (= (y-of-place-back-0000-solid-low-narrow-01 item-01) 9884) (= (cost-of-place-back-0000-solid-low-narrow-01 item-01) 140)
    (can-place-right-0111b-solid-low-narrow-01 item-01) (= (x-of-place-right-0111b-solid-low-narrow-01 item-01) 10123) (= (y-of-place-right-0111b-solid-low-narrow-01 item-01) 9490) (= (cost-of-place-right-0111b-solid-low-narrow-01 item-01) 4)
    (can-pull-1100b-solid-low-narrow-01 item-01) (= (x-of-pull-1100b-solid-low-narrow-01 item-01) 9422) (= (y-of-pull-1100b-solid-low-narrow-01 item-01) 10170) (= (cost-of-pull-1100b-solid-low-narrow-01 item-01) 4)
    (can-pull-right-0100b-solid-low-narrow-01 item-01) (= (x-of-pull-right-0100b-solid-low-narrow-01 item-01) 9326) (= (y-of-pull-right-0100b-solid-low-narrow-01 item-01) 9634) (= (cost-of-pull-right-0100b-solid-low-narrow-01 item-01) 4)
    (= (x-of-pull-right-0110b-solid-low-narrow-01 item-01) 9966) (= (y-of-pull-right-0110b-solid-low-narrow-01 item-01) 9987) (= (cost-of-pull-right-0110b-solid-low-narrow-01 item-01) 22)
    (can-pull-right-0111-solid-low-narrow-01 item-01) (= (x-of-pull-right-0111-solid-low-narrow-01 item-01) 9750) (= (y-of-pull-right-0111-solid-low-narrow-01 item-01) 9720) (= (cost-of-pull-right-0111-solid-low-narrow-01 item-01) 4)
    (can-push-forward-1011-solid-low-narrow-01 item-01) (= (x-of-push-forward-1011-solid-low-narrow-01 item-01) 11063) (= (y-of-push-forward-1011-solid-low-narrow-01 item-01) 10255) (= (cost-of-push-forward-1011-solid-low-narrow-01 item-01) 4)
    (can-push-forward-right-1111-solid-low-narrow-01 item-01) (= (x-of-push-forward-right-1111-solid-low-narrow-01 item-01) 10645) (= (y-of-push-forward-right-1111-solid-low-narrow-01 item-01) 9602) (= (cost-of-push-forward-right-1111-solid-low-narrow-01 item-01) 4)
    (can-push-left-0110-solid-low-narrow-01 item-01) (= (x-of-push-left-0110-solid-low-narrow-01 item-01) 9654) (= (y-of-push-left-0110-solid-low-narrow-01 item-01) 10404) (= (cost-of-push-left-0110-solid-low-narrow-01 item-01) 4)
    (can-push-left-1101-solid-low-narrow-01 item-01) (= (x-of-push-left-1101-solid-low-narrow-01 item-01) 9964) (= (y-of-push-left-1101-solid-low-narrow-01 item-01) 10374) (= (cost-of-push-left-1101-solid-low-narrow-01 item-01) 4)
    (can-push-left-1110b-solid-low-narrow-01 item-01) (= (x-of-push-left-1110b-solid-low-narrow-01 item-01) 10314) (= (y-of-push-left-1110b-solid-low-narrow-01 item-01) 11253) (= (cost-of-push-left-1110b-solid-low-narrow-01 item-01) 30)
    (can-push-right-0101b-solid-low-narrow-01 item-01) (= (x-of-push-right-0101b-solid-low-narrow-01 item-01) 9801) (= (y-of-push-right-0101b-solid-low-narrow-01 item-01) 8957) (= (cost-of-push-right-0101b-solid-low-narrow-01 item-01) 22)
    (can-push-right-1001-solid-low-narrow-01 item-01) (= (x-of-push-right-1001-solid-low-narrow-01 item-01) 10007) (= (y-of-push-right-1001-solid-low-narrow-01 item-01) 9718) (= (cost-of-push-right-1001-solid-low-narrow-01 item-01) 77)
    ; item-02 starts at (0.5876, -0.1809, 0.0175) m
    (= (x item-02) 2376) (= (y item-02) 1191) (= (z item-02) 0)
    ; What each operator promises for item-02 (features 0.04333 0.1228 0.03509 0).
    ; Not for item-02:
    ; push-forward-left-1001c-solid-low-10: keeps its promise in 3 of 31 rehearsals only.
    ; push-forward-left-1100c-solid-low-10: scatters more than it moves.
    ; push-right-0010-solid-low-10: scatters more than it moves.
    ; stay-1101-solid-low-10: scatters more than it moves.
    (can-lift-0010-solid-low-10 item-02) (= (x-of-lift-0010-solid-low-10 item-02) 10273) (= (y-of-lift-0010-solid-low-10 item-02) 10236) (= (z-of-lift-0010-solid-low-10 item-02) 12335) (= (cost-of-lift-0010-solid-low-10 item-02) 29)
    (= (x-of-put-down-lift-0010-solid-low-10 item-02) 10003) (= (y-of-put-down-lift-0010-solid-low-10 item-02) 9994) (= (z-of-put-down-lift-0010-solid-low-10 item-02) 7665)
    (can-lift-1001c-solid-low-10 item-02) (= (x-of-lift-1001c-solid-low-10 item-02) 10260) (= (y-of-lift-1001c-solid-low-10 item-02) 9492) (= (z-of-lift-1001c-solid-low-10 item-02) 12000) (= (cost-of-lift-1001c-solid-low-10 item-02) 17)
    (= (x-of-put-down-lift-1001c-solid-low-10 item-02) 9997) (= (y-of-put-down-lift-1001c-solid-low-10 item-02) 9995) (= (z-of-put-down-lift-1001c-solid-low-10 item-02) 8000)
    (can-pull-0000b-solid-low-10 item-02) (= (x-of-pull-0000b-solid-low-10 item-02) 9478) (= (y-of-pull-0000b-solid-low-10 item-02) 9858) (= (cost-of-pull-0000b-solid-low-10 item-02) 14)
    (can-pull-0100-solid-low-10 item-02) (= (x-of-pull-0100-solid-low-10 item-02) 9202) (= (y-of-pull-0100-solid-low-10 item-02) 9963) (= (cost-of-pull-0100-solid-low-10 item-02) 7)
    (can-pull-0100c-solid-low-10 item-02) (= (x-of-pull-0100c-solid-low-10 item-02) 9410) (= (y-of-pull-0100c-solid-low-10 item-02) 10236) (= (cost-of-pull-0100c-solid-low-10 item-02) 11)
    (can-pull-0110c-solid-low-10 item-02) (= (x-of-pull-0110c-solid-low-10 item-02) 9718) (= (y-of-pull-0110c-solid-low-10 item-02) 9950) (= (cost-of-pull-0110c-solid-low-10 item-02) 4)
    (can-pull-left-1110c-solid-low-10 item-02) (= (x-of-pull-left-1110c-solid-low-10 item-02) 9783) (= (y-of-pull-left-1110c-solid-low-10 item-02) 10192) (= (cost-of-pull-left-1110c-solid-low-10 item-02) 4)
    (can-push-forward-0101c-solid-low-10 item-02) (= (x-of-push-forward-0101c-solid-low-10 item-02) 10437) (= (y-of-push-forward-0101c-solid-low-10 item-02) 9923) (= (cost-of-push-forward-0101c-solid-low-10 item-02) 14)
    (can-push-forward-1011-solid-low-10 item-02) (= (x-of-push-forward-1011-solid-low-10 item-02) 10849) (= (y-of-push-forward-1011-solid-low-10 item-02) 10112) (= (cost-of-push-forward-1011-solid-low-10 item-02) 4)
    (= (x-of-push-forward-left-1001c-solid-low-10 item-02) 10361) (= (y-of-push-forward-left-1001c-solid-low-10 item-02) 10441) (= (cost-of-push-forward-left-1001c-solid-low-10 item-02) 212)
    (can-push-forward-left-1010-solid-low-10 item-02) (= (x-of-push-forward-left-1010-solid-low-10 item-02) 10134) (= (y-of-push-forward-left-1010-solid-low-10 item-02) 10208) (= (cost-of-push-forward-left-1010-solid-low-10 item-02) 14)
    (= (x-of-push-forward-left-1100c-solid-low-10 item-02) 10084) (= (y-of-push-forward-left-1100c-solid-low-10 item-02) 9939) (= (cost-of-push-forward-left-1100c-solid-low-10 item-02) 4)
    (can-push-forward-right-0111c-solid-low-10 item-02) (= (x-of-push-forward-right-0111c-solid-low-10 item-02) 10397) (= (y-of-push-forward-right-0111c-solid-low-10 item-02) 9569) (= (cost-of-push-forward-right-0111c-solid-low-10 item-02) 46)
    (can-push-forward-right-1111-solid-low-10 item-02) (= (x-of-push-forward-right-1111-solid-low-10 item-02) 10399) (= (y-of-push-forward-right-1111-solid-low-10 item-02) 10006) (= (cost-of-push-forward-right-1111-solid-low-10 item-02) 29)
    (can-push-left-1000-solid-low-10 item-02) (= (x-of-push-left-1000-solid-low-10 item-02) 9940) (= (y-of-push-left-1000-solid-low-10 item-02) 10216) (= (cost-of-push-left-1000-solid-low-10 item-02) 46)
    (can-push-right-0001b-solid-low-10 item-02) (= (x-of-push-right-0001b-solid-low-10 item-02) 9913) (= (y-of-push-right-0001b-solid-low-10 item-02) 9686) (= (cost-of-push-right-0001b-solid-low-10 item-02) 11)
    (= (x-of-push-right-0010-solid-low-10 item-02) 10092) (= (y-of-push-right-0010-solid-low-10 item-02) 9800) (= (cost-of-push-right-0010-solid-low-10 item-02) 143)
    (can-push-right-0011-solid-low-10 item-02) (= (x-of-push-right-0011-solid-low-10 item-02) 10157) (= (y-of-push-right-0011-solid-low-10 item-02) 9622) (= (cost-of-push-right-0011-solid-low-10 item-02) 11)
    (= (x-of-stay-1101-solid-low-10 item-02) 10003) (= (y-of-stay-1101-solid-low-10 item-02) 10163) (= (cost-of-stay-1101-solid-low-10 item-02) 11))
  (:goal (and
    ; item-01 shall come to (0.8196, 0.2533, 0.0267) m, 323 mm from where it starts
    (<= (x item-01) 5151) (>= (x item-01) 4242)
    (<= (+ (x item-01) (y item-01)) 10874) (>= (+ (x item-01) (y item-01)) 9587)
    (<= (y item-01) 5989) (>= (y item-01) 5079)
    (<= (y item-01) (+ (x item-01) 1481)) (<= (+ (x item-01) 194) (y item-01))
    (>= (z item-01) 0) (<= (z item-01) 0)
    ; item-02 shall come to (0.7031, 0.0866, 0.0175) m, 291 mm from where it starts
    (<= (x item-02) 3986) (>= (x item-02) 3076)
    (<= (+ (x item-02) (y item-02)) 8041) (>= (+ (x item-02) (y item-02)) 6754)
    (<= (y item-02) 4322) (>= (y item-02) 3412)
    (<= (y item-02) (+ (x item-02) 979)) (<= (x item-02) (+ (y item-02) 308))
    (>= (z item-02) 0) (<= (z item-02) 0)))
  (:metric minimize (total-cost)))
