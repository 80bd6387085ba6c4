; Problem task-14 of the learned domain tabletop, for its encoding numeric.
; How it came about: drawn with seed 15: 2 random actions on item-03, item-01; draw 1, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-14)
  (:domain tabletop)
  (:objects
    item-01 - hollow-00
    item-02 - hollow-00
    item-03 - solid-narrow-10)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.5667, -0.2254, 0.0149) m
    (= (x item-01) 2167) (= (y item-01) 746) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.1109 0.1109 0.02989 2).
    ; Not for item-01:
    ; push-left-010a-hollow-00: moves less than half a cell.
    (can-lift-000-hollow-00 item-01) (= (x-of-lift-000-hollow-00 item-01) 10045) (= (y-of-lift-000-hollow-00 item-01) 10469) (= (z-of-lift-000-hollow-00 item-01) 12382) (= (cost-of-lift-000-hollow-00 item-01) 7)
    (= (x-of-put-down-lift-000-hollow-00 item-01) 9888) (= (y-of-put-down-lift-000-hollow-00 item-01) 9889) (= (z-of-put-down-lift-000-hollow-00 item-01) 7618)
    (can-lift-000a-hollow-00 item-01) (= (x-of-lift-000a-hollow-00 item-01) 10492) (= (y-of-lift-000a-hollow-00 item-01) 10657) (= (z-of-lift-000a-hollow-00 item-01) 12467) (= (cost-of-lift-000a-hollow-00 item-01) 4)
    (= (x-of-put-down-lift-000a-hollow-00 item-01) 10008) (= (y-of-put-down-lift-000a-hollow-00 item-01) 9956) (= (z-of-put-down-lift-000a-hollow-00 item-01) 7533)
    (can-lift-011a-hollow-00 item-01) (= (x-of-lift-011a-hollow-00 item-01) 10427) (= (y-of-lift-011a-hollow-00 item-01) 10286) (= (z-of-lift-011a-hollow-00 item-01) 12002) (= (cost-of-lift-011a-hollow-00 item-01) 168)
    (= (x-of-put-down-lift-011a-hollow-00 item-01) 10011) (= (y-of-put-down-lift-011a-hollow-00 item-01) 10008) (= (z-of-put-down-lift-011a-hollow-00 item-01) 7998)
    (can-lift-100a-hollow-00 item-01) (= (x-of-lift-100a-hollow-00 item-01) 9562) (= (y-of-lift-100a-hollow-00 item-01) 10520) (= (z-of-lift-100a-hollow-00 item-01) 11995) (= (cost-of-lift-100a-hollow-00 item-01) 4)
    (= (x-of-put-down-lift-100a-hollow-00 item-01) 9995) (= (y-of-put-down-lift-100a-hollow-00 item-01) 9951) (= (z-of-put-down-lift-100a-hollow-00 item-01) 8005)
    (can-lift-101a-hollow-00 item-01) (= (x-of-lift-101a-hollow-00 item-01) 10021) (= (y-of-lift-101a-hollow-00 item-01) 9436) (= (z-of-lift-101a-hollow-00 item-01) 12006) (= (cost-of-lift-101a-hollow-00 item-01) 4)
    (= (x-of-put-down-lift-101a-hollow-00 item-01) 9998) (= (y-of-put-down-lift-101a-hollow-00 item-01) 9961) (= (z-of-put-down-lift-101a-hollow-00 item-01) 7994)
    (can-lift-110a-hollow-00 item-01) (= (x-of-lift-110a-hollow-00 item-01) 9604) (= (y-of-lift-110a-hollow-00 item-01) 10127) (= (z-of-lift-110a-hollow-00 item-01) 11999) (= (cost-of-lift-110a-hollow-00 item-01) 168)
    (= (x-of-put-down-lift-110a-hollow-00 item-01) 10000) (= (y-of-put-down-lift-110a-hollow-00 item-01) 10006) (= (z-of-put-down-lift-110a-hollow-00 item-01) 8001)
    (can-pull-110a-hollow-00 item-01) (= (x-of-pull-110a-hollow-00 item-01) 9650) (= (y-of-pull-110a-hollow-00 item-01) 10122) (= (cost-of-pull-110a-hollow-00 item-01) 7)
    (can-pull-right-111a-hollow-00 item-01) (= (x-of-pull-right-111a-hollow-00 item-01) 9774) (= (y-of-pull-right-111a-hollow-00 item-01) 9787) (= (cost-of-pull-right-111a-hollow-00 item-01) 4)
    (can-push-forward-left-011a-hollow-00 item-01) (= (x-of-push-forward-left-011a-hollow-00 item-01) 10474) (= (y-of-push-forward-left-011a-hollow-00 item-01) 10283) (= (cost-of-push-forward-left-011a-hollow-00 item-01) 22)
    (can-push-forward-right-001a-hollow-00 item-01) (= (x-of-push-forward-right-001a-hollow-00 item-01) 10393) (= (y-of-push-forward-right-001a-hollow-00 item-01) 9580) (= (cost-of-push-forward-right-001a-hollow-00 item-01) 4)
    (can-push-left-000-hollow-00 item-01) (= (x-of-push-left-000-hollow-00 item-01) 9995) (= (y-of-push-left-000-hollow-00 item-01) 10271) (= (cost-of-push-left-000-hollow-00 item-01) 153)
    (= (x-of-push-left-010a-hollow-00 item-01) 9995) (= (y-of-push-left-010a-hollow-00 item-01) 10006) (= (cost-of-push-left-010a-hollow-00 item-01) 22)
    (can-push-left-011-hollow-00 item-01) (= (x-of-push-left-011-hollow-00 item-01) 10165) (= (y-of-push-left-011-hollow-00 item-01) 10429) (= (cost-of-push-left-011-hollow-00 item-01) 7)
    (can-push-right-111-hollow-00 item-01) (= (x-of-push-right-111-hollow-00 item-01) 10065) (= (y-of-push-right-111-hollow-00 item-01) 9846) (= (cost-of-push-right-111-hollow-00 item-01) 7)
    ; item-02 starts at (0.5744, 0.1284, 0.0162) m
    (= (x item-02) 2244) (= (y item-02) 4284) (= (z item-02) 0)
    ; What each operator promises for item-02 (features 0.151 0.151 0.0325 2).
    (can-lift-000-hollow-00 item-02) (= (x-of-lift-000-hollow-00 item-02) 10012) (= (y-of-lift-000-hollow-00 item-02) 10985) (= (z-of-lift-000-hollow-00 item-02) 12106) (= (cost-of-lift-000-hollow-00 item-02) 7)
    (= (x-of-put-down-lift-000-hollow-00 item-02) 9998) (= (y-of-put-down-lift-000-hollow-00 item-02) 9962) (= (z-of-put-down-lift-000-hollow-00 item-02) 7894)
    (can-lift-000a-hollow-00 item-02) (= (x-of-lift-000a-hollow-00 item-02) 10481) (= (y-of-lift-000a-hollow-00 item-02) 10855) (= (z-of-lift-000a-hollow-00 item-02) 12476) (= (cost-of-lift-000a-hollow-00 item-02) 4)
    (= (x-of-put-down-lift-000a-hollow-00 item-02) 9998) (= (y-of-put-down-lift-000a-hollow-00 item-02) 9957) (= (z-of-put-down-lift-000a-hollow-00 item-02) 7524)
    (can-lift-011a-hollow-00 item-02) (= (x-of-lift-011a-hollow-00 item-02) 10422) (= (y-of-lift-011a-hollow-00 item-02) 10284) (= (z-of-lift-011a-hollow-00 item-02) 12000) (= (cost-of-lift-011a-hollow-00 item-02) 70)
    (= (x-of-put-down-lift-011a-hollow-00 item-02) 10003) (= (y-of-put-down-lift-011a-hollow-00 item-02) 10009) (= (z-of-put-down-lift-011a-hollow-00 item-02) 8000)
    (can-lift-100a-hollow-00 item-02) (= (x-of-lift-100a-hollow-00 item-02) 9585) (= (y-of-lift-100a-hollow-00 item-02) 10722) (= (z-of-lift-100a-hollow-00 item-02) 11989) (= (cost-of-lift-100a-hollow-00 item-02) 4)
    (= (x-of-put-down-lift-100a-hollow-00 item-02) 10001) (= (y-of-put-down-lift-100a-hollow-00 item-02) 9969) (= (z-of-put-down-lift-100a-hollow-00 item-02) 8011)
    (can-lift-101a-hollow-00 item-02) (= (x-of-lift-101a-hollow-00 item-02) 10021) (= (y-of-lift-101a-hollow-00 item-02) 9248) (= (z-of-lift-101a-hollow-00 item-02) 11995) (= (cost-of-lift-101a-hollow-00 item-02) 4)
    (= (x-of-put-down-lift-101a-hollow-00 item-02) 9995) (= (y-of-put-down-lift-101a-hollow-00 item-02) 9962) (= (z-of-put-down-lift-101a-hollow-00 item-02) 8005)
    (can-lift-110a-hollow-00 item-02) (= (x-of-lift-110a-hollow-00 item-02) 9604) (= (y-of-lift-110a-hollow-00 item-02) 10127) (= (z-of-lift-110a-hollow-00 item-02) 11999) (= (cost-of-lift-110a-hollow-00 item-02) 168)
    (= (x-of-put-down-lift-110a-hollow-00 item-02) 10000) (= (y-of-put-down-lift-110a-hollow-00 item-02) 10006) (= (z-of-put-down-lift-110a-hollow-00 item-02) 8001)
    (can-pull-110a-hollow-00 item-02) (= (x-of-pull-110a-hollow-00 item-02) 9703) (= (y-of-pull-110a-hollow-00 item-02) 10112) (= (cost-of-pull-110a-hollow-00 item-02) 7)
    (can-pull-right-111a-hollow-00 item-02) (= (x-of-pull-right-111a-hollow-00 item-02) 9681) (= (y-of-pull-right-111a-hollow-00 item-02) 9735) (= (cost-of-pull-right-111a-hollow-00 item-02) 4)
    (can-push-forward-left-011a-hollow-00 item-02) (= (x-of-push-forward-left-011a-hollow-00 item-02) 10399) (= (y-of-push-forward-left-011a-hollow-00 item-02) 10283) (= (cost-of-push-forward-left-011a-hollow-00 item-02) 70)
    (can-push-forward-right-001a-hollow-00 item-02) (= (x-of-push-forward-right-001a-hollow-00 item-02) 10365) (= (y-of-push-forward-right-001a-hollow-00 item-02) 9586) (= (cost-of-push-forward-right-001a-hollow-00 item-02) 4)
    (can-push-left-000-hollow-00 item-02) (= (x-of-push-left-000-hollow-00 item-02) 9995) (= (y-of-push-left-000-hollow-00 item-02) 10271) (= (cost-of-push-left-000-hollow-00 item-02) 153)
    (can-push-left-010a-hollow-00 item-02) (= (x-of-push-left-010a-hollow-00 item-02) 9821) (= (y-of-push-left-010a-hollow-00 item-02) 10457) (= (cost-of-push-left-010a-hollow-00 item-02) 7)
    (can-push-left-011-hollow-00 item-02) (= (x-of-push-left-011-hollow-00 item-02) 10152) (= (y-of-push-left-011-hollow-00 item-02) 10456) (= (cost-of-push-left-011-hollow-00 item-02) 11)
    (can-push-right-111-hollow-00 item-02) (= (x-of-push-right-111-hollow-00 item-02) 10070) (= (y-of-push-right-111-hollow-00 item-02) 9835) (= (cost-of-push-right-111-hollow-00 item-02) 7)
    ; item-03 starts at (0.8893, 0.1208, 0.0172) m
    (= (x item-03) 5393) (= (y item-03) 4208) (= (z item-03) 0)
    ; What each operator promises for item-03 (features 0.03763 0.1606 0.03444 0).
    (can-lift-100c-solid-narrow-10 item-03) (= (x-of-lift-100c-solid-narrow-10 item-03) 9393) (= (y-of-lift-100c-solid-narrow-10 item-03) 9735) (= (z-of-lift-100c-solid-narrow-10 item-03) 12232) (= (cost-of-lift-100c-solid-narrow-10 item-03) 188)
    (= (x-of-put-down-lift-100c-solid-narrow-10 item-03) 10009) (= (y-of-put-down-lift-100c-solid-narrow-10 item-03) 9987) (= (z-of-put-down-lift-100c-solid-narrow-10 item-03) 7768)
    (can-lift-101-solid-narrow-10 item-03) (= (x-of-lift-101-solid-narrow-10 item-03) 9817) (= (y-of-lift-101-solid-narrow-10 item-03) 9389) (= (z-of-lift-101-solid-narrow-10 item-03) 12370) (= (cost-of-lift-101-solid-narrow-10 item-03) 188)
    (= (x-of-put-down-lift-101-solid-narrow-10 item-03) 10001) (= (y-of-put-down-lift-101-solid-narrow-10 item-03) 9987) (= (z-of-put-down-lift-101-solid-narrow-10 item-03) 7630)
    (can-pull-110-solid-narrow-10 item-03) (= (x-of-pull-110-solid-narrow-10 item-03) 9327) (= (y-of-pull-110-solid-narrow-10 item-03) 9853) (= (cost-of-pull-110-solid-narrow-10 item-03) 6)
    (can-pull-left-010c-solid-narrow-10 item-03) (= (x-of-pull-left-010c-solid-narrow-10 item-03) 9737) (= (y-of-pull-left-010c-solid-narrow-10 item-03) 10184) (= (cost-of-pull-left-010c-solid-narrow-10 item-03) 4)
    (can-pull-right-100c-solid-narrow-10 item-03) (= (x-of-pull-right-100c-solid-narrow-10 item-03) 9729) (= (y-of-pull-right-100c-solid-narrow-10 item-03) 9565) (= (cost-of-pull-right-100c-solid-narrow-10 item-03) 54)
    (can-push-forward-001-solid-narrow-10 item-03) (= (x-of-push-forward-001-solid-narrow-10 item-03) 10834) (= (y-of-push-forward-001-solid-narrow-10 item-03) 9860) (= (cost-of-push-forward-001-solid-narrow-10 item-03) 6)
    (can-push-forward-left-000c-solid-narrow-10 item-03) (= (x-of-push-forward-left-000c-solid-narrow-10 item-03) 10582) (= (y-of-push-forward-left-000c-solid-narrow-10 item-03) 10089) (= (cost-of-push-forward-left-000c-solid-narrow-10 item-03) 21)
    (can-push-forward-right-101-solid-narrow-10 item-03) (= (x-of-push-forward-right-101-solid-narrow-10 item-03) 10377) (= (y-of-push-forward-right-101-solid-narrow-10 item-03) 9462) (= (cost-of-push-forward-right-101-solid-narrow-10 item-03) 12)
    (can-push-forward-right-111-solid-narrow-10 item-03) (= (x-of-push-forward-right-111-solid-narrow-10 item-03) 10369) (= (y-of-push-forward-right-111-solid-narrow-10 item-03) 9545) (= (cost-of-push-forward-right-111-solid-narrow-10 item-03) 4)
    (can-push-left-011c-solid-narrow-10 item-03) (= (x-of-push-left-011c-solid-narrow-10 item-03) 10180) (= (y-of-push-left-011c-solid-narrow-10 item-03) 10596) (= (cost-of-push-left-011c-solid-narrow-10 item-03) 4))
  (:goal (and
    ; item-01 shall come to (0.5892, -0.2636, 0.2150) m, 205 mm from where it starts
    (<= (x item-01) 2847) (>= (x item-01) 1938)
    (<= (+ (x item-01) (y item-01)) 3400) (>= (+ (x item-01) (y item-01)) 2113)
    (<= (y item-01) 819) (>= (+ (y item-01) 91) 0)
    (<= (+ (y item-01) 1385) (x item-01)) (<= (x item-01) (+ (y item-01) 2672))
    (>= (z item-01) 1995) (<= (z item-01) 2006)
    ; item-02 shall come to (0.5744, 0.1284, 0.0162) m, 0 mm from where it starts
    (<= (x item-02) 2699) (>= (x item-02) 1789)
    (<= (+ (x item-02) (y item-02)) 7172) (>= (+ (x item-02) (y item-02)) 5884)
    (<= (y item-02) 4739) (>= (y item-02) 3829)
    (<= (y item-02) (+ (x item-02) 2684)) (<= (+ (x item-02) 1396) (y item-02))
    (>= (z item-02) 0) (<= (z item-02) 0)
    ; item-03 shall come to (0.8808, 0.1055, 0.0172) m, 18 mm from where it starts
    (<= (x item-03) 5763) (>= (x item-03) 4853)
    (<= (+ (x item-03) (y item-03)) 10007) (>= (+ (x item-03) (y item-03)) 8719)
    (<= (y item-03) 4510) (>= (y item-03) 3600)
    (<= (+ (y item-03) 610) (x item-03)) (<= (x item-03) (+ (y item-03) 1897))
    (>= (z item-03) 0) (<= (z item-03) 0)))
  (:metric minimize (total-cost)))
