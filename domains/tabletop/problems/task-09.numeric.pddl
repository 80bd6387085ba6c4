; Problem task-09 of the learned domain tabletop, for its encoding numeric.
; How it came about: drawn with seed 10: one random action on item-02; draw 1, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-09)
  (:domain tabletop-numeric)
  (:objects
    item-01 - solid-low-narrow-11
    item-02 - solid-00)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.5712, 0.0236, 0.0171) m
    (= (x item-01) 2212) (= (y item-01) 3236) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.1509 0.05109 0.03415 0).
    ; Not for item-01:
    ; push-forward-right-1101-solid-low-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    (can-lift-0000d-solid-low-narrow-11 item-01) (= (x-of-lift-0000d-solid-low-narrow-11 item-01) 9694) (= (y-of-lift-0000d-solid-low-narrow-11 item-01) 9632) (= (z-of-lift-0000d-solid-low-narrow-11 item-01) 12513) (= (cost-of-lift-0000d-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-0000d-solid-low-narrow-11 item-01) 9999) (= (y-of-put-down-lift-0000d-solid-low-narrow-11 item-01) 9988) (= (z-of-put-down-lift-0000d-solid-low-narrow-11 item-01) 7487)
    (can-lift-0001d-solid-low-narrow-11 item-01) (= (x-of-lift-0001d-solid-low-narrow-11 item-01) 10058) (= (y-of-lift-0001d-solid-low-narrow-11 item-01) 9496) (= (z-of-lift-0001d-solid-low-narrow-11 item-01) 11996) (= (cost-of-lift-0001d-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-0001d-solid-low-narrow-11 item-01) 10001) (= (y-of-put-down-lift-0001d-solid-low-narrow-11 item-01) 9987) (= (z-of-put-down-lift-0001d-solid-low-narrow-11 item-01) 8004)
    (can-lift-0100-solid-low-narrow-11 item-01) (= (x-of-lift-0100-solid-low-narrow-11 item-01) 9254) (= (y-of-lift-0100-solid-low-narrow-11 item-01) 9606) (= (z-of-lift-0100-solid-low-narrow-11 item-01) 11986) (= (cost-of-lift-0100-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-0100-solid-low-narrow-11 item-01) 10019) (= (y-of-put-down-lift-0100-solid-low-narrow-11 item-01) 9983) (= (z-of-put-down-lift-0100-solid-low-narrow-11 item-01) 8014)
    (can-lift-0100d-solid-low-narrow-11 item-01) (= (x-of-lift-0100d-solid-low-narrow-11 item-01) 9414) (= (y-of-lift-0100d-solid-low-narrow-11 item-01) 10467) (= (z-of-lift-0100d-solid-low-narrow-11 item-01) 12001) (= (cost-of-lift-0100d-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-0100d-solid-low-narrow-11 item-01) 10000) (= (y-of-put-down-lift-0100d-solid-low-narrow-11 item-01) 9985) (= (z-of-put-down-lift-0100d-solid-low-narrow-11 item-01) 7999)
    (can-lift-0101-solid-low-narrow-11 item-01) (= (x-of-lift-0101-solid-low-narrow-11 item-01) 9650) (= (y-of-lift-0101-solid-low-narrow-11 item-01) 10353) (= (z-of-lift-0101-solid-low-narrow-11 item-01) 12516) (= (cost-of-lift-0101-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-0101-solid-low-narrow-11 item-01) 10000) (= (y-of-put-down-lift-0101-solid-low-narrow-11 item-01) 9986) (= (z-of-put-down-lift-0101-solid-low-narrow-11 item-01) 7484)
    (can-lift-0101c-solid-low-narrow-11 item-01) (= (x-of-lift-0101c-solid-low-narrow-11 item-01) 9473) (= (y-of-lift-0101c-solid-low-narrow-11 item-01) 9486) (= (z-of-lift-0101c-solid-low-narrow-11 item-01) 12030) (= (cost-of-lift-0101c-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-0101c-solid-low-narrow-11 item-01) 10002) (= (y-of-put-down-lift-0101c-solid-low-narrow-11 item-01) 9987) (= (z-of-put-down-lift-0101c-solid-low-narrow-11 item-01) 7970)
    (can-lift-1000-solid-low-narrow-11 item-01) (= (x-of-lift-1000-solid-low-narrow-11 item-01) 10669) (= (y-of-lift-1000-solid-low-narrow-11 item-01) 10305) (= (z-of-lift-1000-solid-low-narrow-11 item-01) 11999) (= (cost-of-lift-1000-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-1000-solid-low-narrow-11 item-01) 9994) (= (y-of-put-down-lift-1000-solid-low-narrow-11 item-01) 9983) (= (z-of-put-down-lift-1000-solid-low-narrow-11 item-01) 8001)
    (can-lift-1001-solid-low-narrow-11 item-01) (= (x-of-lift-1001-solid-low-narrow-11 item-01) 10654) (= (y-of-lift-1001-solid-low-narrow-11 item-01) 9850) (= (z-of-lift-1001-solid-low-narrow-11 item-01) 12439) (= (cost-of-lift-1001-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-1001-solid-low-narrow-11 item-01) 9994) (= (y-of-put-down-lift-1001-solid-low-narrow-11 item-01) 9987) (= (z-of-put-down-lift-1001-solid-low-narrow-11 item-01) 7561)
    (can-lift-1001c-solid-low-narrow-11 item-01) (= (x-of-lift-1001c-solid-low-narrow-11 item-01) 10485) (= (y-of-lift-1001c-solid-low-narrow-11 item-01) 9477) (= (z-of-lift-1001c-solid-low-narrow-11 item-01) 12405) (= (cost-of-lift-1001c-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-1001c-solid-low-narrow-11 item-01) 9998) (= (y-of-put-down-lift-1001c-solid-low-narrow-11 item-01) 9988) (= (z-of-put-down-lift-1001c-solid-low-narrow-11 item-01) 7595)
    (can-lift-1100-solid-low-narrow-11 item-01) (= (x-of-lift-1100-solid-low-narrow-11 item-01) 9725) (= (y-of-lift-1100-solid-low-narrow-11 item-01) 10219) (= (z-of-lift-1100-solid-low-narrow-11 item-01) 11999) (= (cost-of-lift-1100-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-1100-solid-low-narrow-11 item-01) 9998) (= (y-of-put-down-lift-1100-solid-low-narrow-11 item-01) 9985) (= (z-of-put-down-lift-1100-solid-low-narrow-11 item-01) 8001)
    (can-lift-1100c-solid-low-narrow-11 item-01) (= (x-of-lift-1100c-solid-low-narrow-11 item-01) 9935) (= (y-of-lift-1100c-solid-low-narrow-11 item-01) 10298) (= (z-of-lift-1100c-solid-low-narrow-11 item-01) 12398) (= (cost-of-lift-1100c-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-1100c-solid-low-narrow-11 item-01) 10000) (= (y-of-put-down-lift-1100c-solid-low-narrow-11 item-01) 9987) (= (z-of-put-down-lift-1100c-solid-low-narrow-11 item-01) 7602)
    (can-lift-1101-solid-low-narrow-11 item-01) (= (x-of-lift-1101-solid-low-narrow-11 item-01) 10396) (= (y-of-lift-1101-solid-low-narrow-11 item-01) 10192) (= (z-of-lift-1101-solid-low-narrow-11 item-01) 12478) (= (cost-of-lift-1101-solid-low-narrow-11 item-01) 7)
    (= (x-of-put-down-lift-1101-solid-low-narrow-11 item-01) 10000) (= (y-of-put-down-lift-1101-solid-low-narrow-11 item-01) 9983) (= (z-of-put-down-lift-1101-solid-low-narrow-11 item-01) 7522)
    (can-lift-1101c-solid-low-narrow-11 item-01) (= (x-of-lift-1101c-solid-low-narrow-11 item-01) 10086) (= (y-of-lift-1101c-solid-low-narrow-11 item-01) 9969) (= (z-of-lift-1101c-solid-low-narrow-11 item-01) 11999) (= (cost-of-lift-1101c-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-1101c-solid-low-narrow-11 item-01) 10000) (= (y-of-put-down-lift-1101c-solid-low-narrow-11 item-01) 9986) (= (z-of-put-down-lift-1101c-solid-low-narrow-11 item-01) 8001)
    (can-place-forward-right-1010-solid-low-narrow-11 item-01) (= (x-of-place-forward-right-1010-solid-low-narrow-11 item-01) 10583) (= (y-of-place-forward-right-1010-solid-low-narrow-11 item-01) 9569) (= (cost-of-place-forward-right-1010-solid-low-narrow-11 item-01) 4)
    (can-pull-0110-solid-low-narrow-11 item-01) (= (x-of-pull-0110-solid-low-narrow-11 item-01) 9573) (= (y-of-pull-0110-solid-low-narrow-11 item-01) 9949) (= (cost-of-pull-0110-solid-low-narrow-11 item-01) 4)
    (can-pull-0111-solid-low-narrow-11 item-01) (= (x-of-pull-0111-solid-low-narrow-11 item-01) 9000) (= (y-of-pull-0111-solid-low-narrow-11 item-01) 10428) (= (cost-of-pull-0111-solid-low-narrow-11 item-01) 4)
    (can-push-forward-1011-solid-low-narrow-11 item-01) (= (x-of-push-forward-1011-solid-low-narrow-11 item-01) 10868) (= (y-of-push-forward-1011-solid-low-narrow-11 item-01) 10445) (= (cost-of-push-forward-1011-solid-low-narrow-11 item-01) 4)
    (= (x-of-push-forward-right-1101-solid-low-narrow-11 item-01) 10299) (= (y-of-push-forward-right-1101-solid-low-narrow-11 item-01) 9845) (= (cost-of-push-forward-right-1101-solid-low-narrow-11 item-01) 278)
    (can-push-left-0011-solid-low-narrow-11 item-01) (= (x-of-push-left-0011-solid-low-narrow-11 item-01) 9844) (= (y-of-push-left-0011-solid-low-narrow-11 item-01) 10404) (= (cost-of-push-left-0011-solid-low-narrow-11 item-01) 4)
    (can-push-left-1111-solid-low-narrow-11 item-01) (= (x-of-push-left-1111-solid-low-narrow-11 item-01) 9916) (= (y-of-push-left-1111-solid-low-narrow-11 item-01) 11581) (= (cost-of-push-left-1111-solid-low-narrow-11 item-01) 11)
    (can-push-right-0010d-solid-low-narrow-11 item-01) (= (x-of-push-right-0010d-solid-low-narrow-11 item-01) 9861) (= (y-of-push-right-0010d-solid-low-narrow-11 item-01) 8825) (= (cost-of-push-right-0010d-solid-low-narrow-11 item-01) 7)
    (can-push-right-1110-solid-low-narrow-11 item-01) (= (x-of-push-right-1110-solid-low-narrow-11 item-01) 9815) (= (y-of-push-right-1110-solid-low-narrow-11 item-01) 9502) (= (cost-of-push-right-1110-solid-low-narrow-11 item-01) 4)
    ; item-02 starts at (0.7285, -0.1595, 0.0123) m
    (= (x item-02) 3785) (= (y item-02) 1405) (= (z item-02) 0)
    ; What each operator promises for item-02 (features 0.03588 0.171 0.02456 0).
    ; Not for item-02:
    ; lift-1100-solid-00: keeps its promise in 1 of 32 rehearsals only.
    ; push-left-1110a-solid-00: scatters more than it moves.
    ; push-right-1100-solid-00: scatters more than it moves.
    (= (x-of-lift-1100-solid-00 item-02) 9742) (= (y-of-lift-1100-solid-00 item-02) 10158) (= (z-of-lift-1100-solid-00 item-02) 12021) (= (cost-of-lift-1100-solid-00 item-02) 284)
    (= (x-of-put-down-lift-1100-solid-00 item-02) 9999) (= (y-of-put-down-lift-1100-solid-00 item-02) 9991) (= (z-of-put-down-lift-1100-solid-00 item-02) 7979)
    (can-pull-0100a-solid-00 item-02) (= (x-of-pull-0100a-solid-00 item-02) 9238) (= (y-of-pull-0100a-solid-00 item-02) 9736) (= (cost-of-pull-0100a-solid-00 item-02) 4)
    (can-pull-0110a-solid-00 item-02) (= (x-of-pull-0110a-solid-00 item-02) 9662) (= (y-of-pull-0110a-solid-00 item-02) 9897) (= (cost-of-pull-0110a-solid-00 item-02) 4)
    (can-pull-0111a-solid-00 item-02) (= (x-of-pull-0111a-solid-00 item-02) 9409) (= (y-of-pull-0111a-solid-00 item-02) 10009) (= (cost-of-pull-0111a-solid-00 item-02) 4)
    (can-pull-left-0101-solid-00 item-02) (= (x-of-pull-left-0101-solid-00 item-02) 9837) (= (y-of-pull-left-0101-solid-00 item-02) 10472) (= (cost-of-pull-left-0101-solid-00 item-02) 10)
    (can-pull-left-1101-solid-00 item-02) (= (x-of-pull-left-1101-solid-00 item-02) 9713) (= (y-of-pull-left-1101-solid-00 item-02) 10584) (= (cost-of-pull-left-1101-solid-00 item-02) 17)
    (can-pull-left-1111a-solid-00 item-02) (= (x-of-pull-left-1111a-solid-00 item-02) 9824) (= (y-of-pull-left-1111a-solid-00 item-02) 10167) (= (cost-of-pull-left-1111a-solid-00 item-02) 4)
    (can-pull-right-0000a-solid-00 item-02) (= (x-of-pull-right-0000a-solid-00 item-02) 9763) (= (y-of-pull-right-0000a-solid-00 item-02) 9678) (= (cost-of-pull-right-0000a-solid-00 item-02) 10)
    (can-pull-right-1010a-solid-00 item-02) (= (x-of-pull-right-1010a-solid-00 item-02) 9853) (= (y-of-pull-right-1010a-solid-00 item-02) 9888) (= (cost-of-pull-right-1010a-solid-00 item-02) 4)
    (can-push-forward-1011-solid-00 item-02) (= (x-of-push-forward-1011-solid-00 item-02) 10809) (= (y-of-push-forward-1011-solid-00 item-02) 10123) (= (cost-of-push-forward-1011-solid-00 item-02) 4)
    (can-push-forward-1011a-solid-00 item-02) (= (x-of-push-forward-1011a-solid-00 item-02) 10893) (= (y-of-push-forward-1011a-solid-00 item-02) 9800) (= (cost-of-push-forward-1011a-solid-00 item-02) 7)
    (can-push-forward-left-0001a-solid-00 item-02) (= (x-of-push-forward-left-0001a-solid-00 item-02) 10175) (= (y-of-push-forward-left-0001a-solid-00 item-02) 10142) (= (cost-of-push-forward-left-0001a-solid-00 item-02) 4)
    (can-push-forward-left-1001-solid-00 item-02) (= (x-of-push-forward-left-1001-solid-00 item-02) 10192) (= (y-of-push-forward-left-1001-solid-00 item-02) 10419) (= (cost-of-push-forward-left-1001-solid-00 item-02) 4)
    (can-push-forward-right-0010a-solid-00 item-02) (= (x-of-push-forward-right-0010a-solid-00 item-02) 10247) (= (y-of-push-forward-right-0010a-solid-00 item-02) 9728) (= (cost-of-push-forward-right-0010a-solid-00 item-02) 4)
    (can-push-left-0011a-solid-00 item-02) (= (x-of-push-left-0011a-solid-00 item-02) 10174) (= (y-of-push-left-0011a-solid-00 item-02) 10753) (= (cost-of-push-left-0011a-solid-00 item-02) 4)
    (= (x-of-push-left-1110a-solid-00 item-02) 9954) (= (y-of-push-left-1110a-solid-00 item-02) 10071) (= (cost-of-push-left-1110a-solid-00 item-02) 4)
    (can-push-right-1000-solid-00 item-02) (= (x-of-push-right-1000-solid-00 item-02) 9990) (= (y-of-push-right-1000-solid-00 item-02) 9535) (= (cost-of-push-right-1000-solid-00 item-02) 4)
    (= (x-of-push-right-1100-solid-00 item-02) 9965) (= (y-of-push-right-1100-solid-00 item-02) 9890) (= (cost-of-push-right-1100-solid-00 item-02) 10))
  (:goal (and
    ; item-01 shall come to (0.5712, 0.0236, 0.0171) m, 0 mm from where it starts
    (<= (x item-01) 2667) (>= (x item-01) 1757)
    (<= (+ (x item-01) (y item-01)) 6091) (>= (+ (x item-01) (y item-01)) 4804)
    (<= (y item-01) 3691) (>= (y item-01) 2781)
    (<= (y item-01) (+ (x item-01) 1667)) (<= (+ (x item-01) 380) (y item-01))
    (>= (z item-01) 0) (<= (z item-01) 0)
    ; item-02 shall come to (0.7522, -0.2468, 0.0123) m, 90 mm from where it starts
    (<= (x item-02) 4477) (>= (x item-02) 3567)
    (<= (+ (x item-02) (y item-02)) 5197) (>= (+ (x item-02) (y item-02)) 3910)
    (<= (y item-02) 987) (>= (y item-02) 77)
    (<= (+ (y item-02) 2846) (x item-02)) (<= (x item-02) (+ (y item-02) 4134))
    (>= (z item-02) 0) (<= (z item-02) 0)))
  (:metric minimize (total-cost)))
