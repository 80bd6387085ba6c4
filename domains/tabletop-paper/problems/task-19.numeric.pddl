; Problem task-19 of the learned domain tabletop-paper, for its encoding numeric.
; How it came about: drawn with seed 20: 6 random actions on item-08, item-05, item-02, item-05, item-04, item-08; draw 1, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-19)
  (:domain tabletop-paper-numeric)
  (:objects
    item-01 - any-low-narrow-11
    item-02 - solid-narrow-10
    item-03 - solid-narrow-10
    item-04 - any-low-narrow-11
    item-05 - hollow-00
    item-06 - hollow-00
    item-07 - hollow-00
    item-08 - hollow-00)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.4361, 0.2412, 0.0156) m
    (= (x item-01) 861) (= (y item-01) 5412) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.1554 0.062 0.03125 0).
    (can-lift-000-any-low-narrow-11 item-01) (= (x-of-lift-000-any-low-narrow-11 item-01) 10199) (= (y-of-lift-000-any-low-narrow-11 item-01) 10268) (= (z-of-lift-000-any-low-narrow-11 item-01) 12150) (= (cost-of-lift-000-any-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-000-any-low-narrow-11 item-01) 9989) (= (y-of-put-down-lift-000-any-low-narrow-11 item-01) 9986) (= (z-of-put-down-lift-000-any-low-narrow-11 item-01) 7850)
    (can-lift-000d-any-low-narrow-11 item-01) (= (x-of-lift-000d-any-low-narrow-11 item-01) 10463) (= (y-of-lift-000d-any-low-narrow-11 item-01) 10100) (= (z-of-lift-000d-any-low-narrow-11 item-01) 12004) (= (cost-of-lift-000d-any-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-000d-any-low-narrow-11 item-01) 10000) (= (y-of-put-down-lift-000d-any-low-narrow-11 item-01) 9990) (= (z-of-put-down-lift-000d-any-low-narrow-11 item-01) 7996)
    (can-lift-100-any-low-narrow-11 item-01) (= (x-of-lift-100-any-low-narrow-11 item-01) 9334) (= (y-of-lift-100-any-low-narrow-11 item-01) 9752) (= (z-of-lift-100-any-low-narrow-11 item-01) 12002) (= (cost-of-lift-100-any-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-100-any-low-narrow-11 item-01) 10005) (= (y-of-put-down-lift-100-any-low-narrow-11 item-01) 9989) (= (z-of-put-down-lift-100-any-low-narrow-11 item-01) 7998)
    (can-lift-100d-any-low-narrow-11 item-01) (= (x-of-lift-100d-any-low-narrow-11 item-01) 9765) (= (y-of-lift-100d-any-low-narrow-11 item-01) 10386) (= (z-of-lift-100d-any-low-narrow-11 item-01) 11999) (= (cost-of-lift-100d-any-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-100d-any-low-narrow-11 item-01) 10001) (= (y-of-put-down-lift-100d-any-low-narrow-11 item-01) 9986) (= (z-of-put-down-lift-100d-any-low-narrow-11 item-01) 8001)
    (can-lift-101-any-low-narrow-11 item-01) (= (x-of-lift-101-any-low-narrow-11 item-01) 9833) (= (y-of-lift-101-any-low-narrow-11 item-01) 9474) (= (z-of-lift-101-any-low-narrow-11 item-01) 12357) (= (cost-of-lift-101-any-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-101-any-low-narrow-11 item-01) 9996) (= (y-of-put-down-lift-101-any-low-narrow-11 item-01) 9989) (= (z-of-put-down-lift-101-any-low-narrow-11 item-01) 7643)
    (can-lift-101b-any-low-narrow-11 item-01) (= (x-of-lift-101b-any-low-narrow-11 item-01) 10058) (= (y-of-lift-101b-any-low-narrow-11 item-01) 9555) (= (z-of-lift-101b-any-low-narrow-11 item-01) 12002) (= (cost-of-lift-101b-any-low-narrow-11 item-01) 4)
    (= (x-of-put-down-lift-101b-any-low-narrow-11 item-01) 9999) (= (y-of-put-down-lift-101b-any-low-narrow-11 item-01) 9990) (= (z-of-put-down-lift-101b-any-low-narrow-11 item-01) 7998)
    (can-pull-right-110c-any-low-narrow-11 item-01) (= (x-of-pull-right-110c-any-low-narrow-11 item-01) 9443) (= (y-of-pull-right-110c-any-low-narrow-11 item-01) 9587) (= (cost-of-pull-right-110c-any-low-narrow-11 item-01) 4)
    (can-push-forward-001-any-low-narrow-11 item-01) (= (x-of-push-forward-001-any-low-narrow-11 item-01) 10963) (= (y-of-push-forward-001-any-low-narrow-11 item-01) 9730) (= (cost-of-push-forward-001-any-low-narrow-11 item-01) 4)
    (can-push-forward-001c-any-low-narrow-11 item-01) (= (x-of-push-forward-001c-any-low-narrow-11 item-01) 10855) (= (y-of-push-forward-001c-any-low-narrow-11 item-01) 10186) (= (cost-of-push-forward-001c-any-low-narrow-11 item-01) 4)
    (can-push-forward-left-011-any-low-narrow-11 item-01) (= (x-of-push-forward-left-011-any-low-narrow-11 item-01) 10647) (= (y-of-push-forward-left-011-any-low-narrow-11 item-01) 10484) (= (cost-of-push-forward-left-011-any-low-narrow-11 item-01) 4)
    (can-push-forward-right-011d-any-low-narrow-11 item-01) (= (x-of-push-forward-right-011d-any-low-narrow-11 item-01) 10284) (= (y-of-push-forward-right-011d-any-low-narrow-11 item-01) 9597) (= (cost-of-push-forward-right-011d-any-low-narrow-11 item-01) 4)
    (can-push-left-010d-any-low-narrow-11 item-01) (= (x-of-push-left-010d-any-low-narrow-11 item-01) 9978) (= (y-of-push-left-010d-any-low-narrow-11 item-01) 10984) (= (cost-of-push-left-010d-any-low-narrow-11 item-01) 7)
    (can-push-right-111c-any-low-narrow-11 item-01) (= (x-of-push-right-111c-any-low-narrow-11 item-01) 9910) (= (y-of-push-right-111c-any-low-narrow-11 item-01) 9080) (= (cost-of-push-right-111c-any-low-narrow-11 item-01) 7)
    ; item-02 starts at (0.8067, 0.1587, 0.0464) m
    (= (x item-02) 4567) (= (y item-02) 4587) (= (z item-02) 0)
    ; What each operator promises for item-02 (features 0.1729 0.1132 0.09286 0).
    ; Not for item-02:
    ; lift-100c-solid-narrow-10: keeps its promise in 1 of 37 rehearsals only.
    ; lift-101-solid-narrow-10: keeps its promise in 1 of 37 rehearsals only.
    ; pull-110-solid-narrow-10: scatters more than it moves.
    (= (x-of-lift-100c-solid-narrow-10 item-02) 9414) (= (y-of-lift-100c-solid-narrow-10 item-02) 9732) (= (z-of-lift-100c-solid-narrow-10 item-02) 12222) (= (cost-of-lift-100c-solid-narrow-10 item-02) 298)
    (= (x-of-put-down-lift-100c-solid-narrow-10 item-02) 10005) (= (y-of-put-down-lift-100c-solid-narrow-10 item-02) 9986) (= (z-of-put-down-lift-100c-solid-narrow-10 item-02) 7778)
    (= (x-of-lift-101-solid-narrow-10 item-02) 9845) (= (y-of-lift-101-solid-narrow-10 item-02) 9496) (= (z-of-lift-101-solid-narrow-10 item-02) 12503) (= (cost-of-lift-101-solid-narrow-10 item-02) 298)
    (= (x-of-put-down-lift-101-solid-narrow-10 item-02) 10004) (= (y-of-put-down-lift-101-solid-narrow-10 item-02) 9998) (= (z-of-put-down-lift-101-solid-narrow-10 item-02) 7497)
    (= (x-of-pull-110-solid-narrow-10 item-02) 9800) (= (y-of-pull-110-solid-narrow-10 item-02) 9930) (= (cost-of-pull-110-solid-narrow-10 item-02) 15)
    (can-pull-left-010c-solid-narrow-10 item-02) (= (x-of-pull-left-010c-solid-narrow-10 item-02) 9784) (= (y-of-pull-left-010c-solid-narrow-10 item-02) 10144) (= (cost-of-pull-left-010c-solid-narrow-10 item-02) 4)
    (can-pull-right-100c-solid-narrow-10 item-02) (= (x-of-pull-right-100c-solid-narrow-10 item-02) 9581) (= (y-of-pull-right-100c-solid-narrow-10 item-02) 9611) (= (cost-of-pull-right-100c-solid-narrow-10 item-02) 12)
    (can-push-forward-001-solid-narrow-10 item-02) (= (x-of-push-forward-001-solid-narrow-10 item-02) 10472) (= (y-of-push-forward-001-solid-narrow-10 item-02) 9632) (= (cost-of-push-forward-001-solid-narrow-10 item-02) 9)
    (can-push-forward-left-000c-solid-narrow-10 item-02) (= (x-of-push-forward-left-000c-solid-narrow-10 item-02) 10338) (= (y-of-push-forward-left-000c-solid-narrow-10 item-02) 10109) (= (cost-of-push-forward-left-000c-solid-narrow-10 item-02) 38)
    (can-push-forward-right-101-solid-narrow-10 item-02) (= (x-of-push-forward-right-101-solid-narrow-10 item-02) 10092) (= (y-of-push-forward-right-101-solid-narrow-10 item-02) 9447) (= (cost-of-push-forward-right-101-solid-narrow-10 item-02) 78)
    (can-push-forward-right-111-solid-narrow-10 item-02) (= (x-of-push-forward-right-111-solid-narrow-10 item-02) 10195) (= (y-of-push-forward-right-111-solid-narrow-10 item-02) 9705) (= (cost-of-push-forward-right-111-solid-narrow-10 item-02) 4)
    (can-push-left-011c-solid-narrow-10 item-02) (= (x-of-push-left-011c-solid-narrow-10 item-02) 10070) (= (y-of-push-left-011c-solid-narrow-10 item-02) 10194) (= (cost-of-push-left-011c-solid-narrow-10 item-02) 4)
    ; item-03 starts at (0.9061, -0.1837, 0.0130) m
    (= (x item-03) 5561) (= (y item-03) 1163) (= (z item-03) 0)
    ; What each operator promises for item-03 (features 0.08189 0.1443 0.02612 0).
    ; Not for item-03:
    ; lift-100c-solid-narrow-10: keeps its promise in 1 of 37 rehearsals only.
    ; lift-101-solid-narrow-10: keeps its promise in 1 of 37 rehearsals only.
    ; pull-right-100c-solid-narrow-10: scatters more than it moves.
    (= (x-of-lift-100c-solid-narrow-10 item-03) 9406) (= (y-of-lift-100c-solid-narrow-10 item-03) 9737) (= (z-of-lift-100c-solid-narrow-10 item-03) 12218) (= (cost-of-lift-100c-solid-narrow-10 item-03) 298)
    (= (x-of-put-down-lift-100c-solid-narrow-10 item-03) 10005) (= (y-of-put-down-lift-100c-solid-narrow-10 item-03) 9987) (= (z-of-put-down-lift-100c-solid-narrow-10 item-03) 7782)
    (= (x-of-lift-101-solid-narrow-10 item-03) 9850) (= (y-of-lift-101-solid-narrow-10 item-03) 9476) (= (z-of-lift-101-solid-narrow-10 item-03) 12440) (= (cost-of-lift-101-solid-narrow-10 item-03) 298)
    (= (x-of-put-down-lift-101-solid-narrow-10 item-03) 9990) (= (y-of-put-down-lift-101-solid-narrow-10 item-03) 9996) (= (z-of-put-down-lift-101-solid-narrow-10 item-03) 7560)
    (can-pull-110-solid-narrow-10 item-03) (= (x-of-pull-110-solid-narrow-10 item-03) 9260) (= (y-of-pull-110-solid-narrow-10 item-03) 9594) (= (cost-of-pull-110-solid-narrow-10 item-03) 63)
    (can-pull-left-010c-solid-narrow-10 item-03) (= (x-of-pull-left-010c-solid-narrow-10 item-03) 9790) (= (y-of-pull-left-010c-solid-narrow-10 item-03) 10138) (= (cost-of-pull-left-010c-solid-narrow-10 item-03) 4)
    (= (x-of-pull-right-100c-solid-narrow-10 item-03) 9898) (= (y-of-pull-right-100c-solid-narrow-10 item-03) 9751) (= (cost-of-pull-right-100c-solid-narrow-10 item-03) 12)
    (can-push-forward-001-solid-narrow-10 item-03) (= (x-of-push-forward-001-solid-narrow-10 item-03) 10469) (= (y-of-push-forward-001-solid-narrow-10 item-03) 9718) (= (cost-of-push-forward-001-solid-narrow-10 item-03) 9)
    (can-push-forward-left-000c-solid-narrow-10 item-03) (= (x-of-push-forward-left-000c-solid-narrow-10 item-03) 10351) (= (y-of-push-forward-left-000c-solid-narrow-10 item-03) 10536) (= (cost-of-push-forward-left-000c-solid-narrow-10 item-03) 31)
    (can-push-forward-right-101-solid-narrow-10 item-03) (= (x-of-push-forward-right-101-solid-narrow-10 item-03) 10204) (= (y-of-push-forward-right-101-solid-narrow-10 item-03) 9389) (= (cost-of-push-forward-right-101-solid-narrow-10 item-03) 9)
    (can-push-forward-right-111-solid-narrow-10 item-03) (= (x-of-push-forward-right-111-solid-narrow-10 item-03) 10161) (= (y-of-push-forward-right-111-solid-narrow-10 item-03) 9750) (= (cost-of-push-forward-right-111-solid-narrow-10 item-03) 4)
    (can-push-left-011c-solid-narrow-10 item-03) (= (x-of-push-left-011c-solid-narrow-10 item-03) 10086) (= (y-of-push-left-011c-solid-narrow-10 item-03) 10569) (= (cost-of-push-left-011c-solid-narrow-10 item-03) 4)
    ; item-04 starts at (0.7269, -0.2736, 0.0196) m
    (= (x item-04) 3769) (= (y item-04) 264) (= (z item-04) 0)
    ; What each operator promises for item-04 (features 0.1502 0.04954 0.03928 0).
    (can-lift-000-any-low-narrow-11 item-04) (= (x-of-lift-000-any-low-narrow-11 item-04) 10215) (= (y-of-lift-000-any-low-narrow-11 item-04) 10265) (= (z-of-lift-000-any-low-narrow-11 item-04) 12176) (= (cost-of-lift-000-any-low-narrow-11 item-04) 4)
    (= (x-of-put-down-lift-000-any-low-narrow-11 item-04) 9999) (= (y-of-put-down-lift-000-any-low-narrow-11 item-04) 9987) (= (z-of-put-down-lift-000-any-low-narrow-11 item-04) 7824)
    (can-lift-000d-any-low-narrow-11 item-04) (= (x-of-lift-000d-any-low-narrow-11 item-04) 10466) (= (y-of-lift-000d-any-low-narrow-11 item-04) 10099) (= (z-of-lift-000d-any-low-narrow-11 item-04) 12002) (= (cost-of-lift-000d-any-low-narrow-11 item-04) 4)
    (= (x-of-put-down-lift-000d-any-low-narrow-11 item-04) 10000) (= (y-of-put-down-lift-000d-any-low-narrow-11 item-04) 9987) (= (z-of-put-down-lift-000d-any-low-narrow-11 item-04) 7998)
    (can-lift-100-any-low-narrow-11 item-04) (= (x-of-lift-100-any-low-narrow-11 item-04) 9339) (= (y-of-lift-100-any-low-narrow-11 item-04) 9746) (= (z-of-lift-100-any-low-narrow-11 item-04) 12002) (= (cost-of-lift-100-any-low-narrow-11 item-04) 4)
    (= (x-of-put-down-lift-100-any-low-narrow-11 item-04) 10000) (= (y-of-put-down-lift-100-any-low-narrow-11 item-04) 9990) (= (z-of-put-down-lift-100-any-low-narrow-11 item-04) 7998)
    (can-lift-100d-any-low-narrow-11 item-04) (= (x-of-lift-100d-any-low-narrow-11 item-04) 9766) (= (y-of-lift-100d-any-low-narrow-11 item-04) 10384) (= (z-of-lift-100d-any-low-narrow-11 item-04) 11997) (= (cost-of-lift-100d-any-low-narrow-11 item-04) 4)
    (= (x-of-put-down-lift-100d-any-low-narrow-11 item-04) 10000) (= (y-of-put-down-lift-100d-any-low-narrow-11 item-04) 9985) (= (z-of-put-down-lift-100d-any-low-narrow-11 item-04) 8003)
    (can-lift-101-any-low-narrow-11 item-04) (= (x-of-lift-101-any-low-narrow-11 item-04) 9831) (= (y-of-lift-101-any-low-narrow-11 item-04) 9473) (= (z-of-lift-101-any-low-narrow-11 item-04) 12376) (= (cost-of-lift-101-any-low-narrow-11 item-04) 4)
    (= (x-of-put-down-lift-101-any-low-narrow-11 item-04) 9997) (= (y-of-put-down-lift-101-any-low-narrow-11 item-04) 9989) (= (z-of-put-down-lift-101-any-low-narrow-11 item-04) 7624)
    (can-lift-101b-any-low-narrow-11 item-04) (= (x-of-lift-101b-any-low-narrow-11 item-04) 10054) (= (y-of-lift-101b-any-low-narrow-11 item-04) 9550) (= (z-of-lift-101b-any-low-narrow-11 item-04) 12005) (= (cost-of-lift-101b-any-low-narrow-11 item-04) 4)
    (= (x-of-put-down-lift-101b-any-low-narrow-11 item-04) 9999) (= (y-of-put-down-lift-101b-any-low-narrow-11 item-04) 9988) (= (z-of-put-down-lift-101b-any-low-narrow-11 item-04) 7995)
    (can-pull-right-110c-any-low-narrow-11 item-04) (= (x-of-pull-right-110c-any-low-narrow-11 item-04) 9447) (= (y-of-pull-right-110c-any-low-narrow-11 item-04) 9578) (= (cost-of-pull-right-110c-any-low-narrow-11 item-04) 4)
    (can-push-forward-001-any-low-narrow-11 item-04) (= (x-of-push-forward-001-any-low-narrow-11 item-04) 10957) (= (y-of-push-forward-001-any-low-narrow-11 item-04) 9721) (= (cost-of-push-forward-001-any-low-narrow-11 item-04) 4)
    (can-push-forward-001c-any-low-narrow-11 item-04) (= (x-of-push-forward-001c-any-low-narrow-11 item-04) 10855) (= (y-of-push-forward-001c-any-low-narrow-11 item-04) 10186) (= (cost-of-push-forward-001c-any-low-narrow-11 item-04) 4)
    (can-push-forward-left-011-any-low-narrow-11 item-04) (= (x-of-push-forward-left-011-any-low-narrow-11 item-04) 10638) (= (y-of-push-forward-left-011-any-low-narrow-11 item-04) 10485) (= (cost-of-push-forward-left-011-any-low-narrow-11 item-04) 4)
    (can-push-forward-right-011d-any-low-narrow-11 item-04) (= (x-of-push-forward-right-011d-any-low-narrow-11 item-04) 10288) (= (y-of-push-forward-right-011d-any-low-narrow-11 item-04) 9586) (= (cost-of-push-forward-right-011d-any-low-narrow-11 item-04) 4)
    (can-push-left-010d-any-low-narrow-11 item-04) (= (x-of-push-left-010d-any-low-narrow-11 item-04) 10060) (= (y-of-push-left-010d-any-low-narrow-11 item-04) 11016) (= (cost-of-push-left-010d-any-low-narrow-11 item-04) 7)
    (can-push-right-111c-any-low-narrow-11 item-04) (= (x-of-push-right-111c-any-low-narrow-11 item-04) 9886) (= (y-of-push-right-111c-any-low-narrow-11 item-04) 9136) (= (cost-of-push-right-111c-any-low-narrow-11 item-04) 7)
    ; item-05 starts at (0.5909, -0.1426, 0.0176) m
    (= (x item-05) 2409) (= (y item-05) 1574) (= (z item-05) 0)
    ; What each operator promises for item-05 (features 0.13 0.13 0.03518 2).
    ; Not for item-05:
    ; lift-110a-hollow-00: keeps its promise in 1 of 30 rehearsals only.
    ; push-left-000-hollow-00: keeps its promise in 1 of 30 rehearsals only.
    (can-lift-000-hollow-00 item-05) (= (x-of-lift-000-hollow-00 item-05) 10022) (= (y-of-lift-000-hollow-00 item-05) 10753) (= (z-of-lift-000-hollow-00 item-05) 12226) (= (cost-of-lift-000-hollow-00 item-05) 7)
    (= (x-of-put-down-lift-000-hollow-00 item-05) 9969) (= (y-of-put-down-lift-000-hollow-00 item-05) 9945) (= (z-of-put-down-lift-000-hollow-00 item-05) 7774)
    (can-lift-000a-hollow-00 item-05) (= (x-of-lift-000a-hollow-00 item-05) 10486) (= (y-of-lift-000a-hollow-00 item-05) 10751) (= (z-of-lift-000a-hollow-00 item-05) 12493) (= (cost-of-lift-000a-hollow-00 item-05) 4)
    (= (x-of-put-down-lift-000a-hollow-00 item-05) 9996) (= (y-of-put-down-lift-000a-hollow-00 item-05) 9961) (= (z-of-put-down-lift-000a-hollow-00 item-05) 7507)
    (can-lift-011a-hollow-00 item-05) (= (x-of-lift-011a-hollow-00 item-05) 10431) (= (y-of-lift-011a-hollow-00 item-05) 10287) (= (z-of-lift-011a-hollow-00 item-05) 11996) (= (cost-of-lift-011a-hollow-00 item-05) 128)
    (= (x-of-put-down-lift-011a-hollow-00 item-05) 10003) (= (y-of-put-down-lift-011a-hollow-00 item-05) 10005) (= (z-of-put-down-lift-011a-hollow-00 item-05) 8004)
    (can-lift-100a-hollow-00 item-05) (= (x-of-lift-100a-hollow-00 item-05) 9533) (= (y-of-lift-100a-hollow-00 item-05) 10622) (= (z-of-lift-100a-hollow-00 item-05) 11988) (= (cost-of-lift-100a-hollow-00 item-05) 4)
    (= (x-of-put-down-lift-100a-hollow-00 item-05) 10000) (= (y-of-put-down-lift-100a-hollow-00 item-05) 9972) (= (z-of-put-down-lift-100a-hollow-00 item-05) 8012)
    (can-lift-101a-hollow-00 item-05) (= (x-of-lift-101a-hollow-00 item-05) 10025) (= (y-of-lift-101a-hollow-00 item-05) 9358) (= (z-of-lift-101a-hollow-00 item-05) 12006) (= (cost-of-lift-101a-hollow-00 item-05) 4)
    (= (x-of-put-down-lift-101a-hollow-00 item-05) 9998) (= (y-of-put-down-lift-101a-hollow-00 item-05) 9960) (= (z-of-put-down-lift-101a-hollow-00 item-05) 7994)
    (= (x-of-lift-110a-hollow-00 item-05) 9593) (= (y-of-lift-110a-hollow-00 item-05) 10125) (= (z-of-lift-110a-hollow-00 item-05) 11998) (= (cost-of-lift-110a-hollow-00 item-05) 278)
    (= (x-of-put-down-lift-110a-hollow-00 item-05) 9998) (= (y-of-put-down-lift-110a-hollow-00 item-05) 10006) (= (z-of-put-down-lift-110a-hollow-00 item-05) 8002)
    (can-pull-110a-hollow-00 item-05) (= (x-of-pull-110a-hollow-00 item-05) 9677) (= (y-of-pull-110a-hollow-00 item-05) 10117) (= (cost-of-pull-110a-hollow-00 item-05) 7)
    (can-pull-right-111a-hollow-00 item-05) (= (x-of-pull-right-111a-hollow-00 item-05) 9738) (= (y-of-pull-right-111a-hollow-00 item-05) 9791) (= (cost-of-pull-right-111a-hollow-00 item-05) 4)
    (can-push-forward-left-011a-hollow-00 item-05) (= (x-of-push-forward-left-011a-hollow-00 item-05) 10472) (= (y-of-push-forward-left-011a-hollow-00 item-05) 10283) (= (cost-of-push-forward-left-011a-hollow-00 item-05) 34)
    (can-push-forward-right-001a-hollow-00 item-05) (= (x-of-push-forward-right-001a-hollow-00 item-05) 10376) (= (y-of-push-forward-right-001a-hollow-00 item-05) 9583) (= (cost-of-push-forward-right-001a-hollow-00 item-05) 4)
    (= (x-of-push-left-000-hollow-00 item-05) 10003) (= (y-of-push-left-000-hollow-00 item-05) 10263) (= (cost-of-push-left-000-hollow-00 item-05) 278)
    (can-push-left-010a-hollow-00 item-05) (= (x-of-push-left-010a-hollow-00 item-05) 9910) (= (y-of-push-left-010a-hollow-00 item-05) 10236) (= (cost-of-push-left-010a-hollow-00 item-05) 18)
    (can-push-left-011-hollow-00 item-05) (= (x-of-push-left-011-hollow-00 item-05) 10115) (= (y-of-push-left-011-hollow-00 item-05) 10335) (= (cost-of-push-left-011-hollow-00 item-05) 4)
    (can-push-right-111-hollow-00 item-05) (= (x-of-push-right-111-hollow-00 item-05) 10052) (= (y-of-push-right-111-hollow-00 item-05) 9816) (= (cost-of-push-right-111-hollow-00 item-05) 7)
    ; item-06 starts at (0.7964, 0.0099, 0.0184) m
    (= (x item-06) 4464) (= (y item-06) 3099) (= (z item-06) 0)
    ; What each operator promises for item-06 (features 0.1468 0.09143 0.03681 1).
    ; Not for item-06:
    ; lift-011a-hollow-00: keeps its promise with such objects in about 7 of 30 only.
    ; lift-110a-hollow-00: keeps its promise with such objects in about 6 of 30 only.
    ; push-left-000-hollow-00: keeps its promise with such objects in about 3 of 30 only.
    ; push-left-010a-hollow-00: scatters more than it moves.
    (can-lift-000-hollow-00 item-06) (= (x-of-lift-000-hollow-00 item-06) 10138) (= (y-of-lift-000-hollow-00 item-06) 10415) (= (z-of-lift-000-hollow-00 item-06) 12223) (= (cost-of-lift-000-hollow-00 item-06) 26)
    (= (x-of-put-down-lift-000-hollow-00 item-06) 9985) (= (y-of-put-down-lift-000-hollow-00 item-06) 9980) (= (z-of-put-down-lift-000-hollow-00 item-06) 7777)
    (can-lift-000a-hollow-00 item-06) (= (x-of-lift-000a-hollow-00 item-06) 10502) (= (y-of-lift-000a-hollow-00 item-06) 10637) (= (z-of-lift-000a-hollow-00 item-06) 12537) (= (cost-of-lift-000a-hollow-00 item-06) 4)
    (= (x-of-put-down-lift-000a-hollow-00 item-06) 10003) (= (y-of-put-down-lift-000a-hollow-00 item-06) 9976) (= (z-of-put-down-lift-000a-hollow-00 item-06) 7463)
    (= (x-of-lift-011a-hollow-00 item-06) 10391) (= (y-of-lift-011a-hollow-00 item-06) 10292) (= (z-of-lift-011a-hollow-00 item-06) 12000) (= (cost-of-lift-011a-hollow-00 item-06) 140)
    (= (x-of-put-down-lift-011a-hollow-00 item-06) 10006) (= (y-of-put-down-lift-011a-hollow-00 item-06) 10008) (= (z-of-put-down-lift-011a-hollow-00 item-06) 8000)
    (can-lift-100a-hollow-00 item-06) (= (x-of-lift-100a-hollow-00 item-06) 9575) (= (y-of-lift-100a-hollow-00 item-06) 10519) (= (z-of-lift-100a-hollow-00 item-06) 11985) (= (cost-of-lift-100a-hollow-00 item-06) 4)
    (= (x-of-put-down-lift-100a-hollow-00 item-06) 9998) (= (y-of-put-down-lift-100a-hollow-00 item-06) 9973) (= (z-of-put-down-lift-100a-hollow-00 item-06) 8015)
    (can-lift-101a-hollow-00 item-06) (= (x-of-lift-101a-hollow-00 item-06) 10038) (= (y-of-lift-101a-hollow-00 item-06) 9477) (= (z-of-lift-101a-hollow-00 item-06) 11996) (= (cost-of-lift-101a-hollow-00 item-06) 4)
    (= (x-of-put-down-lift-101a-hollow-00 item-06) 10000) (= (y-of-put-down-lift-101a-hollow-00 item-06) 9973) (= (z-of-put-down-lift-101a-hollow-00 item-06) 8004)
    (= (x-of-lift-110a-hollow-00 item-06) 9596) (= (y-of-lift-110a-hollow-00 item-06) 10127) (= (z-of-lift-110a-hollow-00 item-06) 11999) (= (cost-of-lift-110a-hollow-00 item-06) 153)
    (= (x-of-put-down-lift-110a-hollow-00 item-06) 9999) (= (y-of-put-down-lift-110a-hollow-00 item-06) 10006) (= (z-of-put-down-lift-110a-hollow-00 item-06) 8001)
    (can-pull-110a-hollow-00 item-06) (= (x-of-pull-110a-hollow-00 item-06) 9549) (= (y-of-pull-110a-hollow-00 item-06) 10125) (= (cost-of-pull-110a-hollow-00 item-06) 26)
    (can-pull-right-111a-hollow-00 item-06) (= (x-of-pull-right-111a-hollow-00 item-06) 9798) (= (y-of-pull-right-111a-hollow-00 item-06) 9797) (= (cost-of-pull-right-111a-hollow-00 item-06) 4)
    (can-push-forward-left-011a-hollow-00 item-06) (= (x-of-push-forward-left-011a-hollow-00 item-06) 10373) (= (y-of-push-forward-left-011a-hollow-00 item-06) 10263) (= (cost-of-push-forward-left-011a-hollow-00 item-06) 30)
    (can-push-forward-right-001a-hollow-00 item-06) (= (x-of-push-forward-right-001a-hollow-00 item-06) 10156) (= (y-of-push-forward-right-001a-hollow-00 item-06) 9598) (= (cost-of-push-forward-right-001a-hollow-00 item-06) 4)
    (= (x-of-push-left-000-hollow-00 item-06) 10001) (= (y-of-push-left-000-hollow-00 item-06) 10205) (= (cost-of-push-left-000-hollow-00 item-06) 209)
    (= (x-of-push-left-010a-hollow-00 item-06) 9979) (= (y-of-push-left-010a-hollow-00 item-06) 10064) (= (cost-of-push-left-010a-hollow-00 item-06) 18)
    (can-push-left-011-hollow-00 item-06) (= (x-of-push-left-011-hollow-00 item-06) 10311) (= (y-of-push-left-011-hollow-00 item-06) 10318) (= (cost-of-push-left-011-hollow-00 item-06) 11)
    (can-push-right-111-hollow-00 item-06) (= (x-of-push-right-111-hollow-00 item-06) 10063) (= (y-of-push-right-111-hollow-00 item-06) 9840) (= (cost-of-push-right-111-hollow-00 item-06) 7)
    ; item-07 starts at (0.6173, 0.1341, 0.0239) m
    (= (x item-07) 2673) (= (y item-07) 4341) (= (z item-07) 0)
    ; What each operator promises for item-07 (features 0.1167 0.1167 0.048 2).
    ; Not for item-07:
    ; lift-011a-hollow-00: keeps its promise with such objects in about 5 of 30 only.
    ; lift-110a-hollow-00: keeps its promise in 2 of 30 rehearsals only.
    ; push-left-000-hollow-00: keeps its promise with such objects in about 6 of 30 only.
    ; push-left-010a-hollow-00: scatters more than it moves.
    (can-lift-000-hollow-00 item-07) (= (x-of-lift-000-hollow-00 item-07) 10024) (= (y-of-lift-000-hollow-00 item-07) 10676) (= (z-of-lift-000-hollow-00 item-07) 12187) (= (cost-of-lift-000-hollow-00 item-07) 26)
    (= (x-of-put-down-lift-000-hollow-00 item-07) 9969) (= (y-of-put-down-lift-000-hollow-00 item-07) 9942) (= (z-of-put-down-lift-000-hollow-00 item-07) 7813)
    (can-lift-000a-hollow-00 item-07) (= (x-of-lift-000a-hollow-00 item-07) 10490) (= (y-of-lift-000a-hollow-00 item-07) 10690) (= (z-of-lift-000a-hollow-00 item-07) 12555) (= (cost-of-lift-000a-hollow-00 item-07) 4)
    (= (x-of-put-down-lift-000a-hollow-00 item-07) 10002) (= (y-of-put-down-lift-000a-hollow-00 item-07) 9963) (= (z-of-put-down-lift-000a-hollow-00 item-07) 7445)
    (= (x-of-lift-011a-hollow-00 item-07) 10444) (= (y-of-lift-011a-hollow-00 item-07) 10284) (= (z-of-lift-011a-hollow-00 item-07) 12000) (= (cost-of-lift-011a-hollow-00 item-07) 168)
    (= (x-of-put-down-lift-011a-hollow-00 item-07) 10014) (= (y-of-put-down-lift-011a-hollow-00 item-07) 10005) (= (z-of-put-down-lift-011a-hollow-00 item-07) 8000)
    (can-lift-100a-hollow-00 item-07) (= (x-of-lift-100a-hollow-00 item-07) 9553) (= (y-of-lift-100a-hollow-00 item-07) 10553) (= (z-of-lift-100a-hollow-00 item-07) 11974) (= (cost-of-lift-100a-hollow-00 item-07) 4)
    (= (x-of-put-down-lift-100a-hollow-00 item-07) 10000) (= (y-of-put-down-lift-100a-hollow-00 item-07) 9964) (= (z-of-put-down-lift-100a-hollow-00 item-07) 8026)
    (can-lift-101a-hollow-00 item-07) (= (x-of-lift-101a-hollow-00 item-07) 10018) (= (y-of-lift-101a-hollow-00 item-07) 9423) (= (z-of-lift-101a-hollow-00 item-07) 12003) (= (cost-of-lift-101a-hollow-00 item-07) 4)
    (= (x-of-put-down-lift-101a-hollow-00 item-07) 9998) (= (y-of-put-down-lift-101a-hollow-00 item-07) 9961) (= (z-of-put-down-lift-101a-hollow-00 item-07) 7997)
    (= (x-of-lift-110a-hollow-00 item-07) 9595) (= (y-of-lift-110a-hollow-00 item-07) 10126) (= (z-of-lift-110a-hollow-00 item-07) 11999) (= (cost-of-lift-110a-hollow-00 item-07) 238)
    (= (x-of-put-down-lift-110a-hollow-00 item-07) 9999) (= (y-of-put-down-lift-110a-hollow-00 item-07) 10006) (= (z-of-put-down-lift-110a-hollow-00 item-07) 8001)
    (can-pull-110a-hollow-00 item-07) (= (x-of-pull-110a-hollow-00 item-07) 9654) (= (y-of-pull-110a-hollow-00 item-07) 10122) (= (cost-of-pull-110a-hollow-00 item-07) 11)
    (can-pull-right-111a-hollow-00 item-07) (= (x-of-pull-right-111a-hollow-00 item-07) 9847) (= (y-of-pull-right-111a-hollow-00 item-07) 9885) (= (cost-of-pull-right-111a-hollow-00 item-07) 4)
    (can-push-forward-left-011a-hollow-00 item-07) (= (x-of-push-forward-left-011a-hollow-00 item-07) 10456) (= (y-of-push-forward-left-011a-hollow-00 item-07) 10278) (= (cost-of-push-forward-left-011a-hollow-00 item-07) 22)
    (can-push-forward-right-001a-hollow-00 item-07) (= (x-of-push-forward-right-001a-hollow-00 item-07) 10358) (= (y-of-push-forward-right-001a-hollow-00 item-07) 9585) (= (cost-of-push-forward-right-001a-hollow-00 item-07) 4)
    (= (x-of-push-left-000-hollow-00 item-07) 10002) (= (y-of-push-left-000-hollow-00 item-07) 10260) (= (cost-of-push-left-000-hollow-00 item-07) 153)
    (= (x-of-push-left-010a-hollow-00 item-07) 9961) (= (y-of-push-left-010a-hollow-00 item-07) 10073) (= (cost-of-push-left-010a-hollow-00 item-07) 43)
    (can-push-left-011-hollow-00 item-07) (= (x-of-push-left-011-hollow-00 item-07) 10031) (= (y-of-push-left-011-hollow-00 item-07) 10286) (= (cost-of-push-left-011-hollow-00 item-07) 7)
    (can-push-right-111-hollow-00 item-07) (= (x-of-push-right-111-hollow-00 item-07) 10055) (= (y-of-push-right-111-hollow-00 item-07) 9865) (= (cost-of-push-right-111-hollow-00 item-07) 7)
    ; item-08 starts at (0.4302, 0.0354, 0.0267) m
    (= (x item-08) 802) (= (y item-08) 3354) (= (z item-08) 0)
    ; What each operator promises for item-08 (features 0.1177 0.1177 0.05344 2).
    ; Not for item-08:
    ; lift-110a-hollow-00: keeps its promise in 2 of 30 rehearsals only.
    (can-lift-000-hollow-00 item-08) (= (x-of-lift-000-hollow-00 item-08) 10022) (= (y-of-lift-000-hollow-00 item-08) 10726) (= (z-of-lift-000-hollow-00 item-08) 12160) (= (cost-of-lift-000-hollow-00 item-08) 53)
    (= (x-of-put-down-lift-000-hollow-00 item-08) 9980) (= (y-of-put-down-lift-000-hollow-00 item-08) 9948) (= (z-of-put-down-lift-000-hollow-00 item-08) 7840)
    (can-lift-000a-hollow-00 item-08) (= (x-of-lift-000a-hollow-00 item-08) 10489) (= (y-of-lift-000a-hollow-00 item-08) 10697) (= (z-of-lift-000a-hollow-00 item-08) 12582) (= (cost-of-lift-000a-hollow-00 item-08) 4)
    (= (x-of-put-down-lift-000a-hollow-00 item-08) 10001) (= (y-of-put-down-lift-000a-hollow-00 item-08) 9964) (= (z-of-put-down-lift-000a-hollow-00 item-08) 7418)
    (can-lift-011a-hollow-00 item-08) (= (x-of-lift-011a-hollow-00 item-08) 10446) (= (y-of-lift-011a-hollow-00 item-08) 10283) (= (z-of-lift-011a-hollow-00 item-08) 12003) (= (cost-of-lift-011a-hollow-00 item-08) 108)
    (= (x-of-put-down-lift-011a-hollow-00 item-08) 10018) (= (y-of-put-down-lift-011a-hollow-00 item-08) 10006) (= (z-of-put-down-lift-011a-hollow-00 item-08) 7997)
    (can-lift-100a-hollow-00 item-08) (= (x-of-lift-100a-hollow-00 item-08) 9555) (= (y-of-lift-100a-hollow-00 item-08) 10562) (= (z-of-lift-100a-hollow-00 item-08) 11972) (= (cost-of-lift-100a-hollow-00 item-08) 4)
    (= (x-of-put-down-lift-100a-hollow-00 item-08) 10003) (= (y-of-put-down-lift-100a-hollow-00 item-08) 9968) (= (z-of-put-down-lift-100a-hollow-00 item-08) 8028)
    (can-lift-101a-hollow-00 item-08) (= (x-of-lift-101a-hollow-00 item-08) 10017) (= (y-of-lift-101a-hollow-00 item-08) 9419) (= (z-of-lift-101a-hollow-00 item-08) 12003) (= (cost-of-lift-101a-hollow-00 item-08) 4)
    (= (x-of-put-down-lift-101a-hollow-00 item-08) 10000) (= (y-of-put-down-lift-101a-hollow-00 item-08) 9961) (= (z-of-put-down-lift-101a-hollow-00 item-08) 7997)
    (= (x-of-lift-110a-hollow-00 item-08) 9598) (= (y-of-lift-110a-hollow-00 item-08) 10126) (= (z-of-lift-110a-hollow-00 item-08) 11999) (= (cost-of-lift-110a-hollow-00 item-08) 238)
    (= (x-of-put-down-lift-110a-hollow-00 item-08) 9999) (= (y-of-put-down-lift-110a-hollow-00 item-08) 10006) (= (z-of-put-down-lift-110a-hollow-00 item-08) 8001)
    (can-pull-110a-hollow-00 item-08) (= (x-of-pull-110a-hollow-00 item-08) 9653) (= (y-of-pull-110a-hollow-00 item-08) 10121) (= (cost-of-pull-110a-hollow-00 item-08) 11)
    (can-pull-right-111a-hollow-00 item-08) (= (x-of-pull-right-111a-hollow-00 item-08) 9860) (= (y-of-pull-right-111a-hollow-00 item-08) 9912) (= (cost-of-pull-right-111a-hollow-00 item-08) 4)
    (can-push-forward-left-011a-hollow-00 item-08) (= (x-of-push-forward-left-011a-hollow-00 item-08) 10454) (= (y-of-push-forward-left-011a-hollow-00 item-08) 10277) (= (cost-of-push-forward-left-011a-hollow-00 item-08) 43)
    (can-push-forward-right-001a-hollow-00 item-08) (= (x-of-push-forward-right-001a-hollow-00 item-08) 10348) (= (y-of-push-forward-right-001a-hollow-00 item-08) 9586) (= (cost-of-push-forward-right-001a-hollow-00 item-08) 4)
    (can-push-left-000-hollow-00 item-08) (= (x-of-push-left-000-hollow-00 item-08) 10002) (= (y-of-push-left-000-hollow-00 item-08) 10259) (= (cost-of-push-left-000-hollow-00 item-08) 91)
    (can-push-left-010a-hollow-00 item-08) (= (x-of-push-left-010a-hollow-00 item-08) 9949) (= (y-of-push-left-010a-hollow-00 item-08) 10101) (= (cost-of-push-left-010a-hollow-00 item-08) 53)
    (can-push-left-011-hollow-00 item-08) (= (x-of-push-left-011-hollow-00 item-08) 9994) (= (y-of-push-left-011-hollow-00 item-08) 10278) (= (cost-of-push-left-011-hollow-00 item-08) 7)
    (can-push-right-111-hollow-00 item-08) (= (x-of-push-right-111-hollow-00 item-08) 10054) (= (y-of-push-right-111-hollow-00 item-08) 9867) (= (cost-of-push-right-111-hollow-00 item-08) 7))
  (:goal (and
    ; item-01 shall come to (0.4360, 0.2412, 0.0156) m, 0 mm from where it starts
    (<= (x item-01) 1315) (>= (x item-01) 406)
    (<= (+ (x item-01) (y item-01)) 6915) (>= (+ (x item-01) (y item-01)) 5628)
    (<= (y item-01) 5866) (>= (y item-01) 4956)
    (<= (y item-01) (+ (x item-01) 5194)) (<= (+ (x item-01) 3907) (y item-01))
    (>= (z item-01) 0) (<= (z item-01) 0)
    ; item-02 shall come to (0.8071, 0.1621, 0.0464) m, 3 mm from where it starts
    (<= (x item-02) 5025) (>= (x item-02) 4116)
    (<= (+ (x item-02) (y item-02)) 9835) (>= (+ (x item-02) (y item-02)) 8548)
    (<= (y item-02) 5076) (>= (y item-02) 4166)
    (<= (y item-02) (+ (x item-02) 694)) (<= (x item-02) (+ (y item-02) 593))
    (>= (z item-02) 0) (<= (z item-02) 0)
    ; item-03 shall come to (0.9061, -0.1837, 0.0130) m, 0 mm from where it starts
    (<= (x item-03) 6016) (>= (x item-03) 5106)
    (<= (+ (x item-03) (y item-03)) 7367) (>= (+ (x item-03) (y item-03)) 6080)
    (<= (y item-03) 1618) (>= (y item-03) 708)
    (<= (+ (y item-03) 3755) (x item-03)) (<= (x item-03) (+ (y item-03) 5042))
    (>= (z item-03) 0) (<= (z item-03) 0)
    ; item-04 shall come to (0.7373, -0.2316, 0.0196) m, 43 mm from where it starts
    (<= (x item-04) 4327) (>= (x item-04) 3417)
    (<= (+ (x item-04) (y item-04)) 5199) (>= (+ (x item-04) (y item-04)) 3912)
    (<= (y item-04) 1138) (>= (y item-04) 229)
    (<= (+ (y item-04) 2545) (x item-04)) (<= (x item-04) (+ (y item-04) 3832))
    (>= (z item-04) 0) (<= (z item-04) 0)
    ; item-05 shall come to (0.6727, -0.1433, 0.0176) m, 82 mm from where it starts
    (<= (x item-05) 3682) (>= (x item-05) 2772)
    (<= (+ (x item-05) (y item-05)) 5438) (>= (+ (x item-05) (y item-05)) 4151)
    (<= (y item-05) 2022) (>= (y item-05) 1113)
    (<= (+ (y item-05) 1016) (x item-05)) (<= (x item-05) (+ (y item-05) 2303))
    (>= (z item-05) 0) (<= (z item-05) 0)
    ; item-06 shall come to (0.7964, 0.0100, 0.0184) m, 0 mm from where it starts
    (<= (x item-06) 4919) (>= (x item-06) 4009)
    (<= (+ (x item-06) (y item-06)) 8207) (>= (+ (x item-06) (y item-06)) 6920)
    (<= (y item-06) 3555) (>= (y item-06) 2645)
    (<= (+ (y item-06) 721) (x item-06)) (<= (x item-06) (+ (y item-06) 2008))
    (>= (z item-06) 0) (<= (z item-06) 0)
    ; item-07 shall come to (0.6173, 0.1341, 0.0240) m, 0 mm from where it starts
    (<= (x item-07) 3128) (>= (x item-07) 2218)
    (<= (+ (x item-07) (y item-07)) 7658) (>= (+ (x item-07) (y item-07)) 6370)
    (<= (y item-07) 4796) (>= (y item-07) 3886)
    (<= (y item-07) (+ (x item-07) 2312)) (<= (+ (x item-07) 1024) (y item-07))
    (>= (z item-07) 0) (<= (z item-07) 0)
    ; item-08 shall come to (0.4130, -0.0407, 0.0267) m, 78 mm from where it starts
    (<= (x item-08) 1085) (>= (x item-08) 175)
    (<= (+ (x item-08) (y item-08)) 3867) (>= (+ (x item-08) (y item-08)) 2580)
    (<= (y item-08) 3048) (>= (y item-08) 2138)
    (<= (y item-08) (+ (x item-08) 2607)) (<= (+ (x item-08) 1320) (y item-08))
    (>= (z item-08) 0) (<= (z item-08) 0)))
  (:metric minimize (total-cost)))
