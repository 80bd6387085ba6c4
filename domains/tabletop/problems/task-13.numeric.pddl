; Problem task-13 of the learned domain tabletop, for its encoding numeric.
; How it came about: drawn with seed 14: 2 random actions on item-02, item-01; draw 1, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-13)
  (:domain tabletop-numeric)
  (:objects
    item-01 - solid-low-narrow-11
    item-02 - solid-low-narrow-11
    item-03 - solid-00)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.8613, 0.2806, 0.0159) m
    (= (x item-01) 5113) (= (y item-01) 5806) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.145 0.03629 0.0319 0).
    ; Not for item-01:
    ; push-forward-right-1101-solid-low-narrow-11: keeps its promise in 1 of 30 rehearsals only.
    (can-lift-0000d-solid-low-narrow-11 item-01) (= (x-of-lift-0000d-solid-low-narrow-11 item-01) 9694) (= (y-of-lift-0000d-solid-low-narrow-11 item-01) 9629) (= (z-of-lift-0000d-solid-low-narrow-11 item-01) 12490) (= (cost-of-lift-0000d-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-0000d-solid-low-narrow-11 item-01) 10003) (= (y-of-put-down-lift-0000d-solid-low-narrow-11 item-01) 9986) (= (z-of-put-down-lift-0000d-solid-low-narrow-11 item-01) 7510)
    (can-lift-0001d-solid-low-narrow-11 item-01) (= (x-of-lift-0001d-solid-low-narrow-11 item-01) 10058) (= (y-of-lift-0001d-solid-low-narrow-11 item-01) 9493) (= (z-of-lift-0001d-solid-low-narrow-11 item-01) 11995) (= (cost-of-lift-0001d-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-0001d-solid-low-narrow-11 item-01) 10001) (= (y-of-put-down-lift-0001d-solid-low-narrow-11 item-01) 9984) (= (z-of-put-down-lift-0001d-solid-low-narrow-11 item-01) 8005)
    (can-lift-0100-solid-low-narrow-11 item-01) (= (x-of-lift-0100-solid-low-narrow-11 item-01) 9243) (= (y-of-lift-0100-solid-low-narrow-11 item-01) 9637) (= (z-of-lift-0100-solid-low-narrow-11 item-01) 11992) (= (cost-of-lift-0100-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-0100-solid-low-narrow-11 item-01) 10013) (= (y-of-put-down-lift-0100-solid-low-narrow-11 item-01) 9985) (= (z-of-put-down-lift-0100-solid-low-narrow-11 item-01) 8008)
    (can-lift-0100d-solid-low-narrow-11 item-01) (= (x-of-lift-0100d-solid-low-narrow-11 item-01) 9414) (= (y-of-lift-0100d-solid-low-narrow-11 item-01) 10464) (= (z-of-lift-0100d-solid-low-narrow-11 item-01) 11999) (= (cost-of-lift-0100d-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-0100d-solid-low-narrow-11 item-01) 10000) (= (y-of-put-down-lift-0100d-solid-low-narrow-11 item-01) 9982) (= (z-of-put-down-lift-0100d-solid-low-narrow-11 item-01) 8001)
    (can-lift-0101-solid-low-narrow-11 item-01) (= (x-of-lift-0101-solid-low-narrow-11 item-01) 9649) (= (y-of-lift-0101-solid-low-narrow-11 item-01) 10349) (= (z-of-lift-0101-solid-low-narrow-11 item-01) 12505) (= (cost-of-lift-0101-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-0101-solid-low-narrow-11 item-01) 9998) (= (y-of-put-down-lift-0101-solid-low-narrow-11 item-01) 9983) (= (z-of-put-down-lift-0101-solid-low-narrow-11 item-01) 7495)
    (can-lift-0101c-solid-low-narrow-11 item-01) (= (x-of-lift-0101c-solid-low-narrow-11 item-01) 9472) (= (y-of-lift-0101c-solid-low-narrow-11 item-01) 9484) (= (z-of-lift-0101c-solid-low-narrow-11 item-01) 12014) (= (cost-of-lift-0101c-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-0101c-solid-low-narrow-11 item-01) 10000) (= (y-of-put-down-lift-0101c-solid-low-narrow-11 item-01) 9984) (= (z-of-put-down-lift-0101c-solid-low-narrow-11 item-01) 7986)
    (can-lift-1000-solid-low-narrow-11 item-01) (= (x-of-lift-1000-solid-low-narrow-11 item-01) 10676) (= (y-of-lift-1000-solid-low-narrow-11 item-01) 10312) (= (z-of-lift-1000-solid-low-narrow-11 item-01) 11993) (= (cost-of-lift-1000-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-1000-solid-low-narrow-11 item-01) 9999) (= (y-of-put-down-lift-1000-solid-low-narrow-11 item-01) 9982) (= (z-of-put-down-lift-1000-solid-low-narrow-11 item-01) 8007)
    (can-lift-1001-solid-low-narrow-11 item-01) (= (x-of-lift-1001-solid-low-narrow-11 item-01) 10655) (= (y-of-lift-1001-solid-low-narrow-11 item-01) 9858) (= (z-of-lift-1001-solid-low-narrow-11 item-01) 12421) (= (cost-of-lift-1001-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-1001-solid-low-narrow-11 item-01) 9998) (= (y-of-put-down-lift-1001-solid-low-narrow-11 item-01) 9986) (= (z-of-put-down-lift-1001-solid-low-narrow-11 item-01) 7579)
    (can-lift-1001c-solid-low-narrow-11 item-01) (= (x-of-lift-1001c-solid-low-narrow-11 item-01) 10487) (= (y-of-lift-1001c-solid-low-narrow-11 item-01) 9477) (= (z-of-lift-1001c-solid-low-narrow-11 item-01) 12405) (= (cost-of-lift-1001c-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-1001c-solid-low-narrow-11 item-01) 10001) (= (y-of-put-down-lift-1001c-solid-low-narrow-11 item-01) 9990) (= (z-of-put-down-lift-1001c-solid-low-narrow-11 item-01) 7595)
    (can-lift-1100-solid-low-narrow-11 item-01) (= (x-of-lift-1100-solid-low-narrow-11 item-01) 9727) (= (y-of-lift-1100-solid-low-narrow-11 item-01) 10221) (= (z-of-lift-1100-solid-low-narrow-11 item-01) 11999) (= (cost-of-lift-1100-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-1100-solid-low-narrow-11 item-01) 10000) (= (y-of-put-down-lift-1100-solid-low-narrow-11 item-01) 9982) (= (z-of-put-down-lift-1100-solid-low-narrow-11 item-01) 8001)
    (can-lift-1100c-solid-low-narrow-11 item-01) (= (x-of-lift-1100c-solid-low-narrow-11 item-01) 9934) (= (y-of-lift-1100c-solid-low-narrow-11 item-01) 10295) (= (z-of-lift-1100c-solid-low-narrow-11 item-01) 12385) (= (cost-of-lift-1100c-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-1100c-solid-low-narrow-11 item-01) 10002) (= (y-of-put-down-lift-1100c-solid-low-narrow-11 item-01) 9985) (= (z-of-put-down-lift-1100c-solid-low-narrow-11 item-01) 7615)
    (can-lift-1101-solid-low-narrow-11 item-01) (= (x-of-lift-1101-solid-low-narrow-11 item-01) 10402) (= (y-of-lift-1101-solid-low-narrow-11 item-01) 10179) (= (z-of-lift-1101-solid-low-narrow-11 item-01) 12469) (= (cost-of-lift-1101-solid-low-narrow-11 item-01) 7)
    (= (x-of-put-down-lift-1101-solid-low-narrow-11 item-01) 9997) (= (y-of-put-down-lift-1101-solid-low-narrow-11 item-01) 9977) (= (z-of-put-down-lift-1101-solid-low-narrow-11 item-01) 7531)
    (can-lift-1101c-solid-low-narrow-11 item-01) (= (x-of-lift-1101c-solid-low-narrow-11 item-01) 10084) (= (y-of-lift-1101c-solid-low-narrow-11 item-01) 9965) (= (z-of-lift-1101c-solid-low-narrow-11 item-01) 11998) (= (cost-of-lift-1101c-solid-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-1101c-solid-low-narrow-11 item-01) 10000) (= (y-of-put-down-lift-1101c-solid-low-narrow-11 item-01) 9983) (= (z-of-put-down-lift-1101c-solid-low-narrow-11 item-01) 8002)
    (can-place-forward-right-1010-solid-low-narrow-11 item-01) (= (x-of-place-forward-right-1010-solid-low-narrow-11 item-01) 10571) (= (y-of-place-forward-right-1010-solid-low-narrow-11 item-01) 9581) (= (cost-of-place-forward-right-1010-solid-low-narrow-11 item-01) 4)
    (can-pull-0110-solid-low-narrow-11 item-01) (= (x-of-pull-0110-solid-low-narrow-11 item-01) 9573) (= (y-of-pull-0110-solid-low-narrow-11 item-01) 9948) (= (cost-of-pull-0110-solid-low-narrow-11 item-01) 4)
    (can-pull-0111-solid-low-narrow-11 item-01) (= (x-of-pull-0111-solid-low-narrow-11 item-01) 9001) (= (y-of-pull-0111-solid-low-narrow-11 item-01) 10423) (= (cost-of-pull-0111-solid-low-narrow-11 item-01) 4)
    (can-push-forward-1011-solid-low-narrow-11 item-01) (= (x-of-push-forward-1011-solid-low-narrow-11 item-01) 10865) (= (y-of-push-forward-1011-solid-low-narrow-11 item-01) 10456) (= (cost-of-push-forward-1011-solid-low-narrow-11 item-01) 4)
    (= (x-of-push-forward-right-1101-solid-low-narrow-11 item-01) 10379) (= (y-of-push-forward-right-1101-solid-low-narrow-11 item-01) 9883) (= (cost-of-push-forward-right-1101-solid-low-narrow-11 item-01) 278)
    (can-push-left-0011-solid-low-narrow-11 item-01) (= (x-of-push-left-0011-solid-low-narrow-11 item-01) 9852) (= (y-of-push-left-0011-solid-low-narrow-11 item-01) 10399) (= (cost-of-push-left-0011-solid-low-narrow-11 item-01) 4)
    (can-push-left-1111-solid-low-narrow-11 item-01) (= (x-of-push-left-1111-solid-low-narrow-11 item-01) 9918) (= (y-of-push-left-1111-solid-low-narrow-11 item-01) 11521) (= (cost-of-push-left-1111-solid-low-narrow-11 item-01) 22)
    (can-push-right-0010d-solid-low-narrow-11 item-01) (= (x-of-push-right-0010d-solid-low-narrow-11 item-01) 9882) (= (y-of-push-right-0010d-solid-low-narrow-11 item-01) 8937) (= (cost-of-push-right-0010d-solid-low-narrow-11 item-01) 7)
    (can-push-right-1110-solid-low-narrow-11 item-01) (= (x-of-push-right-1110-solid-low-narrow-11 item-01) 9815) (= (y-of-push-right-1110-solid-low-narrow-11 item-01) 9500) (= (cost-of-push-right-1110-solid-low-narrow-11 item-01) 4)
    ; item-02 starts at (0.6544, 0.2163, 0.0455) m
    (= (x item-02) 3044) (= (y item-02) 5163) (= (z item-02) 0)
    ; What each operator promises for item-02 (features 0.09476 0.07655 0.09093 1).
    ; Not for item-02:
    ; push-forward-right-1101-solid-low-narrow-11: keeps its promise with such objects in about 6 of 30
    ; only.
    ; push-left-1111-solid-low-narrow-11: scatters more than it moves.
    (can-lift-0000d-solid-low-narrow-11 item-02) (= (x-of-lift-0000d-solid-low-narrow-11 item-02) 9687) (= (y-of-lift-0000d-solid-low-narrow-11 item-02) 9634) (= (z-of-lift-0000d-solid-low-narrow-11 item-02) 12511) (= (cost-of-lift-0000d-solid-low-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-0000d-solid-low-narrow-11 item-02) 10000) (= (y-of-put-down-lift-0000d-solid-low-narrow-11 item-02) 9987) (= (z-of-put-down-lift-0000d-solid-low-narrow-11 item-02) 7489)
    (can-lift-0001d-solid-low-narrow-11 item-02) (= (x-of-lift-0001d-solid-low-narrow-11 item-02) 10039) (= (y-of-lift-0001d-solid-low-narrow-11 item-02) 9498) (= (z-of-lift-0001d-solid-low-narrow-11 item-02) 11999) (= (cost-of-lift-0001d-solid-low-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-0001d-solid-low-narrow-11 item-02) 10002) (= (y-of-put-down-lift-0001d-solid-low-narrow-11 item-02) 9993) (= (z-of-put-down-lift-0001d-solid-low-narrow-11 item-02) 8001)
    (can-lift-0100-solid-low-narrow-11 item-02) (= (x-of-lift-0100-solid-low-narrow-11 item-02) 9224) (= (y-of-lift-0100-solid-low-narrow-11 item-02) 9621) (= (z-of-lift-0100-solid-low-narrow-11 item-02) 12009) (= (cost-of-lift-0100-solid-low-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-0100-solid-low-narrow-11 item-02) 10010) (= (y-of-put-down-lift-0100-solid-low-narrow-11 item-02) 9982) (= (z-of-put-down-lift-0100-solid-low-narrow-11 item-02) 7991)
    (can-lift-0100d-solid-low-narrow-11 item-02) (= (x-of-lift-0100d-solid-low-narrow-11 item-02) 9416) (= (y-of-lift-0100d-solid-low-narrow-11 item-02) 10481) (= (z-of-lift-0100d-solid-low-narrow-11 item-02) 12047) (= (cost-of-lift-0100d-solid-low-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-0100d-solid-low-narrow-11 item-02) 10001) (= (y-of-put-down-lift-0100d-solid-low-narrow-11 item-02) 9993) (= (z-of-put-down-lift-0100d-solid-low-narrow-11 item-02) 7953)
    (can-lift-0101-solid-low-narrow-11 item-02) (= (x-of-lift-0101-solid-low-narrow-11 item-02) 9651) (= (y-of-lift-0101-solid-low-narrow-11 item-02) 10361) (= (z-of-lift-0101-solid-low-narrow-11 item-02) 12580) (= (cost-of-lift-0101-solid-low-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-0101-solid-low-narrow-11 item-02) 10004) (= (y-of-put-down-lift-0101-solid-low-narrow-11 item-02) 9990) (= (z-of-put-down-lift-0101-solid-low-narrow-11 item-02) 7420)
    (can-lift-0101c-solid-low-narrow-11 item-02) (= (x-of-lift-0101c-solid-low-narrow-11 item-02) 9472) (= (y-of-lift-0101c-solid-low-narrow-11 item-02) 9488) (= (z-of-lift-0101c-solid-low-narrow-11 item-02) 12036) (= (cost-of-lift-0101c-solid-low-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-0101c-solid-low-narrow-11 item-02) 10001) (= (y-of-put-down-lift-0101c-solid-low-narrow-11 item-02) 9988) (= (z-of-put-down-lift-0101c-solid-low-narrow-11 item-02) 7964)
    (can-lift-1000-solid-low-narrow-11 item-02) (= (x-of-lift-1000-solid-low-narrow-11 item-02) 10590) (= (y-of-lift-1000-solid-low-narrow-11 item-02) 10327) (= (z-of-lift-1000-solid-low-narrow-11 item-02) 12002) (= (cost-of-lift-1000-solid-low-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-1000-solid-low-narrow-11 item-02) 10000) (= (y-of-put-down-lift-1000-solid-low-narrow-11 item-02) 9993) (= (z-of-put-down-lift-1000-solid-low-narrow-11 item-02) 7998)
    (can-lift-1001-solid-low-narrow-11 item-02) (= (x-of-lift-1001-solid-low-narrow-11 item-02) 10661) (= (y-of-lift-1001-solid-low-narrow-11 item-02) 9865) (= (z-of-lift-1001-solid-low-narrow-11 item-02) 12567) (= (cost-of-lift-1001-solid-low-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-1001-solid-low-narrow-11 item-02) 9992) (= (y-of-put-down-lift-1001-solid-low-narrow-11 item-02) 9995) (= (z-of-put-down-lift-1001-solid-low-narrow-11 item-02) 7433)
    (can-lift-1001c-solid-low-narrow-11 item-02) (= (x-of-lift-1001c-solid-low-narrow-11 item-02) 10485) (= (y-of-lift-1001c-solid-low-narrow-11 item-02) 9477) (= (z-of-lift-1001c-solid-low-narrow-11 item-02) 12405) (= (cost-of-lift-1001c-solid-low-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-1001c-solid-low-narrow-11 item-02) 10000) (= (y-of-put-down-lift-1001c-solid-low-narrow-11 item-02) 9988) (= (z-of-put-down-lift-1001c-solid-low-narrow-11 item-02) 7595)
    (can-lift-1100-solid-low-narrow-11 item-02) (= (x-of-lift-1100-solid-low-narrow-11 item-02) 9735) (= (y-of-lift-1100-solid-low-narrow-11 item-02) 10221) (= (z-of-lift-1100-solid-low-narrow-11 item-02) 12011) (= (cost-of-lift-1100-solid-low-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-1100-solid-low-narrow-11 item-02) 9998) (= (y-of-put-down-lift-1100-solid-low-narrow-11 item-02) 9986) (= (z-of-put-down-lift-1100-solid-low-narrow-11 item-02) 7989)
    (can-lift-1100c-solid-low-narrow-11 item-02) (= (x-of-lift-1100c-solid-low-narrow-11 item-02) 9940) (= (y-of-lift-1100c-solid-low-narrow-11 item-02) 10308) (= (z-of-lift-1100c-solid-low-narrow-11 item-02) 12507) (= (cost-of-lift-1100c-solid-low-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-1100c-solid-low-narrow-11 item-02) 9998) (= (y-of-put-down-lift-1100c-solid-low-narrow-11 item-02) 9992) (= (z-of-put-down-lift-1100c-solid-low-narrow-11 item-02) 7493)
    (can-lift-1101-solid-low-narrow-11 item-02) (= (x-of-lift-1101-solid-low-narrow-11 item-02) 10451) (= (y-of-lift-1101-solid-low-narrow-11 item-02) 10250) (= (z-of-lift-1101-solid-low-narrow-11 item-02) 12653) (= (cost-of-lift-1101-solid-low-narrow-11 item-02) 26)
    (= (x-of-put-down-lift-1101-solid-low-narrow-11 item-02) 9990) (= (y-of-put-down-lift-1101-solid-low-narrow-11 item-02) 9965) (= (z-of-put-down-lift-1101-solid-low-narrow-11 item-02) 7347)
    (can-lift-1101c-solid-low-narrow-11 item-02) (= (x-of-lift-1101c-solid-low-narrow-11 item-02) 10144) (= (y-of-lift-1101c-solid-low-narrow-11 item-02) 9992) (= (z-of-lift-1101c-solid-low-narrow-11 item-02) 12002) (= (cost-of-lift-1101c-solid-low-narrow-11 item-02) 4)
    (= (x-of-put-down-lift-1101c-solid-low-narrow-11 item-02) 9998) (= (y-of-put-down-lift-1101c-solid-low-narrow-11 item-02) 9996) (= (z-of-put-down-lift-1101c-solid-low-narrow-11 item-02) 7998)
    (can-place-forward-right-1010-solid-low-narrow-11 item-02) (= (x-of-place-forward-right-1010-solid-low-narrow-11 item-02) 10580) (= (y-of-place-forward-right-1010-solid-low-narrow-11 item-02) 9575) (= (cost-of-place-forward-right-1010-solid-low-narrow-11 item-02) 4)
    (can-pull-0110-solid-low-narrow-11 item-02) (= (x-of-pull-0110-solid-low-narrow-11 item-02) 9573) (= (y-of-pull-0110-solid-low-narrow-11 item-02) 9949) (= (cost-of-pull-0110-solid-low-narrow-11 item-02) 4)
    (can-pull-0111-solid-low-narrow-11 item-02) (= (x-of-pull-0111-solid-low-narrow-11 item-02) 9012) (= (y-of-pull-0111-solid-low-narrow-11 item-02) 10380) (= (cost-of-pull-0111-solid-low-narrow-11 item-02) 4)
    (can-push-forward-1011-solid-low-narrow-11 item-02) (= (x-of-push-forward-1011-solid-low-narrow-11 item-02) 10866) (= (y-of-push-forward-1011-solid-low-narrow-11 item-02) 9826) (= (cost-of-push-forward-1011-solid-low-narrow-11 item-02) 7)
    (= (x-of-push-forward-right-1101-solid-low-narrow-11 item-02) 10164) (= (y-of-push-forward-right-1101-solid-low-narrow-11 item-02) 9850) (= (cost-of-push-forward-right-1101-solid-low-narrow-11 item-02) 153)
    (can-push-left-0011-solid-low-narrow-11 item-02) (= (x-of-push-left-0011-solid-low-narrow-11 item-02) 9846) (= (y-of-push-left-0011-solid-low-narrow-11 item-02) 10405) (= (cost-of-push-left-0011-solid-low-narrow-11 item-02) 4)
    (= (x-of-push-left-1111-solid-low-narrow-11 item-02) 9968) (= (y-of-push-left-1111-solid-low-narrow-11 item-02) 10254) (= (cost-of-push-left-1111-solid-low-narrow-11 item-02) 53)
    (can-push-right-0010d-solid-low-narrow-11 item-02) (= (x-of-push-right-0010d-solid-low-narrow-11 item-02) 9700) (= (y-of-push-right-0010d-solid-low-narrow-11 item-02) 9422) (= (cost-of-push-right-0010d-solid-low-narrow-11 item-02) 14)
    (can-push-right-1110-solid-low-narrow-11 item-02) (= (x-of-push-right-1110-solid-low-narrow-11 item-02) 9815) (= (y-of-push-right-1110-solid-low-narrow-11 item-02) 9505) (= (cost-of-push-right-1110-solid-low-narrow-11 item-02) 4)
    ; item-03 starts at (0.6568, 0.0420, 0.0460) m
    (= (x item-03) 3068) (= (y item-03) 3420) (= (z item-03) 0)
    ; What each operator promises for item-03 (features 0.1591 0.1298 0.09207 0).
    ; Not for item-03:
    ; lift-1100-solid-00: keeps its promise in 1 of 32 rehearsals only.
    ; pull-left-0101-solid-00: scatters more than it moves.
    ; pull-left-1101-solid-00: scatters more than it moves.
    ; pull-right-1010a-solid-00: scatters more than it moves.
    ; push-forward-left-1001-solid-00: scatters more than it moves.
    ; push-left-1110a-solid-00: scatters more than it moves.
    ; push-right-1100-solid-00: scatters more than it moves.
    (= (x-of-lift-1100-solid-00 item-03) 9745) (= (y-of-lift-1100-solid-00 item-03) 10171) (= (z-of-lift-1100-solid-00 item-03) 12022) (= (cost-of-lift-1100-solid-00 item-03) 284)
    (= (x-of-put-down-lift-1100-solid-00 item-03) 9998) (= (y-of-put-down-lift-1100-solid-00 item-03) 9994) (= (z-of-put-down-lift-1100-solid-00 item-03) 7978)
    (can-pull-0100a-solid-00 item-03) (= (x-of-pull-0100a-solid-00 item-03) 9452) (= (y-of-pull-0100a-solid-00 item-03) 9664) (= (cost-of-pull-0100a-solid-00 item-03) 14)
    (can-pull-0110a-solid-00 item-03) (= (x-of-pull-0110a-solid-00 item-03) 9791) (= (y-of-pull-0110a-solid-00 item-03) 9959) (= (cost-of-pull-0110a-solid-00 item-03) 4)
    (can-pull-0111a-solid-00 item-03) (= (x-of-pull-0111a-solid-00 item-03) 9480) (= (y-of-pull-0111a-solid-00 item-03) 10080) (= (cost-of-pull-0111a-solid-00 item-03) 4)
    (= (x-of-pull-left-0101-solid-00 item-03) 9916) (= (y-of-pull-left-0101-solid-00 item-03) 10117) (= (cost-of-pull-left-0101-solid-00 item-03) 10)
    (= (x-of-pull-left-1101-solid-00 item-03) 9973) (= (y-of-pull-left-1101-solid-00 item-03) 9847) (= (cost-of-pull-left-1101-solid-00 item-03) 10)
    (can-pull-left-1111a-solid-00 item-03) (= (x-of-pull-left-1111a-solid-00 item-03) 9837) (= (y-of-pull-left-1111a-solid-00 item-03) 10149) (= (cost-of-pull-left-1111a-solid-00 item-03) 4)
    (can-pull-right-0000a-solid-00 item-03) (= (x-of-pull-right-0000a-solid-00 item-03) 9712) (= (y-of-pull-right-0000a-solid-00 item-03) 9488) (= (cost-of-pull-right-0000a-solid-00 item-03) 32)
    (= (x-of-pull-right-1010a-solid-00 item-03) 9973) (= (y-of-pull-right-1010a-solid-00 item-03) 9968) (= (cost-of-pull-right-1010a-solid-00 item-03) 4)
    (can-push-forward-1011-solid-00 item-03) (= (x-of-push-forward-1011-solid-00 item-03) 10300) (= (y-of-push-forward-1011-solid-00 item-03) 10066) (= (cost-of-push-forward-1011-solid-00 item-03) 7)
    (can-push-forward-1011a-solid-00 item-03) (= (x-of-push-forward-1011a-solid-00 item-03) 10506) (= (y-of-push-forward-1011a-solid-00 item-03) 9690) (= (cost-of-push-forward-1011a-solid-00 item-03) 24)
    (can-push-forward-left-0001a-solid-00 item-03) (= (x-of-push-forward-left-0001a-solid-00 item-03) 10149) (= (y-of-push-forward-left-0001a-solid-00 item-03) 10129) (= (cost-of-push-forward-left-0001a-solid-00 item-03) 7)
    (= (x-of-push-forward-left-1001-solid-00 item-03) 10059) (= (y-of-push-forward-left-1001-solid-00 item-03) 10106) (= (cost-of-push-forward-left-1001-solid-00 item-03) 4)
    (can-push-forward-right-0010a-solid-00 item-03) (= (x-of-push-forward-right-0010a-solid-00 item-03) 10144) (= (y-of-push-forward-right-0010a-solid-00 item-03) 9783) (= (cost-of-push-forward-right-0010a-solid-00 item-03) 4)
    (can-push-left-0011a-solid-00 item-03) (= (x-of-push-left-0011a-solid-00 item-03) 10098) (= (y-of-push-left-0011a-solid-00 item-03) 10492) (= (cost-of-push-left-0011a-solid-00 item-03) 4)
    (= (x-of-push-left-1110a-solid-00 item-03) 9976) (= (y-of-push-left-1110a-solid-00 item-03) 10123) (= (cost-of-push-left-1110a-solid-00 item-03) 7)
    (can-push-right-1000-solid-00 item-03) (= (x-of-push-right-1000-solid-00 item-03) 9995) (= (y-of-push-right-1000-solid-00 item-03) 9752) (= (cost-of-push-right-1000-solid-00 item-03) 4)
    (= (x-of-push-right-1100-solid-00 item-03) 9997) (= (y-of-push-right-1100-solid-00 item-03) 9785) (= (cost-of-push-right-1100-solid-00 item-03) 7))
  (:goal (and
    ; item-01 shall come to (0.8636, 0.2712, 0.2156) m, 200 mm from where it starts
    (<= (x item-01) 5591) (>= (x item-01) 4681)
    (<= (+ (x item-01) (y item-01)) 11491) (>= (+ (x item-01) (y item-01)) 10205)
    (<= (y item-01) 6166) (>= (y item-01) 5257)
    (<= (y item-01) (+ (x item-01) 1219)) (<= (x item-01) (+ (y item-01) 67))
    (>= (z item-01) 1992) (<= (z item-01) 2014)
    ; item-02 shall come to (0.6658, 0.1734, 0.0455) m, 44 mm from where it starts
    (<= (x item-02) 3613) (>= (x item-02) 2704)
    (<= (+ (x item-02) (y item-02)) 8535) (>= (+ (x item-02) (y item-02)) 7248)
    (<= (y item-02) 5188) (>= (y item-02) 4278)
    (<= (y item-02) (+ (x item-02) 2218)) (<= (+ (x item-02) 931) (y item-02))
    (>= (z item-02) 0) (<= (z item-02) 0)
    ; item-03 shall come to (0.6568, 0.0420, 0.0460) m, 0 mm from where it starts
    (<= (x item-03) 3523) (>= (x item-03) 2613)
    (<= (+ (x item-03) (y item-03)) 7132) (>= (+ (x item-03) (y item-03)) 5845)
    (<= (y item-03) 3875) (>= (y item-03) 2965)
    (<= (y item-03) (+ (x item-03) 996)) (<= (x item-03) (+ (y item-03) 291))
    (>= (z item-03) 0) (<= (z item-03) 0)))
  (:metric minimize (total-cost)))
