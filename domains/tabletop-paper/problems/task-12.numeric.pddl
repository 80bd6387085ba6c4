; Problem task-12 of the learned domain tabletop-paper, for its encoding numeric.
; How it came about: drawn with seed 13: 2 random actions on item-01, item-01; draw 1, earlier ones met at the start or off the table.
; A goal is met within 50 mm; what is asked for here lies inside that
; by as much as 10 step(s) with an object can err by rounding to 0.1 mm.
(define (problem task-12)
  (:domain tabletop-paper-numeric)
  (:objects
    item-01 - hollow-00
    item-02 - solid-narrow-10)
  (:init
    (hand-empty) (= (total-cost) 0)
    ; item-01 starts at (0.7962, -0.0742, 0.0137) m
    (= (x item-01) 4462) (= (y item-01) 2258) (= (z item-01) 0)
    ; What each operator promises for item-01 (features 0.06942 0.09691 0.02735 1).
    ; Not for item-01:
    ; lift-110a-hollow-00: keeps its promise with such objects in about 6 of 30 only.
    ; push-left-000-hollow-00: keeps its promise in 1 of 30 rehearsals only.
    (can-lift-000-hollow-00 item-01) (= (x-of-lift-000-hollow-00 item-01) 10104) (= (y-of-lift-000-hollow-00 item-01) 10369) (= (z-of-lift-000-hollow-00 item-01) 12339) (= (cost-of-lift-000-hollow-00 item-01) 14)
    (= (x-of-put-down-lift-000-hollow-00 item-01) 9941) (= (y-of-put-down-lift-000-hollow-00 item-01) 9964) (= (z-of-put-down-lift-000-hollow-00 item-01) 7661)
    (can-lift-000a-hollow-00 item-01) (= (x-of-lift-000a-hollow-00 item-01) 10494) (= (y-of-lift-000a-hollow-00 item-01) 10649) (= (z-of-lift-000a-hollow-00 item-01) 12551) (= (cost-of-lift-000a-hollow-00 item-01) 4)
    (= (x-of-put-down-lift-000a-hollow-00 item-01) 10011) (= (y-of-put-down-lift-000a-hollow-00 item-01) 9964) (= (z-of-put-down-lift-000a-hollow-00 item-01) 7449)
    (can-lift-011a-hollow-00 item-01) (= (x-of-lift-011a-hollow-00 item-01) 10398) (= (y-of-lift-011a-hollow-00 item-01) 10291) (= (z-of-lift-011a-hollow-00 item-01) 12001) (= (cost-of-lift-011a-hollow-00 item-01) 108)
    (= (x-of-put-down-lift-011a-hollow-00 item-01) 10007) (= (y-of-put-down-lift-011a-hollow-00 item-01) 10008) (= (z-of-put-down-lift-011a-hollow-00 item-01) 7999)
    (can-lift-100a-hollow-00 item-01) (= (x-of-lift-100a-hollow-00 item-01) 9613) (= (y-of-lift-100a-hollow-00 item-01) 10549) (= (z-of-lift-100a-hollow-00 item-01) 11995) (= (cost-of-lift-100a-hollow-00 item-01) 4)
    (= (x-of-put-down-lift-100a-hollow-00 item-01) 9996) (= (y-of-put-down-lift-100a-hollow-00 item-01) 9962) (= (z-of-put-down-lift-100a-hollow-00 item-01) 8005)
    (can-lift-101a-hollow-00 item-01) (= (x-of-lift-101a-hollow-00 item-01) 10024) (= (y-of-lift-101a-hollow-00 item-01) 9432) (= (z-of-lift-101a-hollow-00 item-01) 12006) (= (cost-of-lift-101a-hollow-00 item-01) 4)
    (= (x-of-put-down-lift-101a-hollow-00 item-01) 10003) (= (y-of-put-down-lift-101a-hollow-00 item-01) 9978) (= (z-of-put-down-lift-101a-hollow-00 item-01) 7994)
    (= (x-of-lift-110a-hollow-00 item-01) 9578) (= (y-of-lift-110a-hollow-00 item-01) 10126) (= (z-of-lift-110a-hollow-00 item-01) 11999) (= (cost-of-lift-110a-hollow-00 item-01) 153)
    (= (x-of-put-down-lift-110a-hollow-00 item-01) 9999) (= (y-of-put-down-lift-110a-hollow-00 item-01) 10007) (= (z-of-put-down-lift-110a-hollow-00 item-01) 8001)
    (can-pull-110a-hollow-00 item-01) (= (x-of-pull-110a-hollow-00 item-01) 9526) (= (y-of-pull-110a-hollow-00 item-01) 10122) (= (cost-of-pull-110a-hollow-00 item-01) 26)
    (can-pull-right-111a-hollow-00 item-01) (= (x-of-pull-right-111a-hollow-00 item-01) 9825) (= (y-of-pull-right-111a-hollow-00 item-01) 9815) (= (cost-of-pull-right-111a-hollow-00 item-01) 4)
    (can-push-forward-left-011a-hollow-00 item-01) (= (x-of-push-forward-left-011a-hollow-00 item-01) 10392) (= (y-of-push-forward-left-011a-hollow-00 item-01) 10263) (= (cost-of-push-forward-left-011a-hollow-00 item-01) 43)
    (can-push-forward-right-001a-hollow-00 item-01) (= (x-of-push-forward-right-001a-hollow-00 item-01) 10222) (= (y-of-push-forward-right-001a-hollow-00 item-01) 9594) (= (cost-of-push-forward-right-001a-hollow-00 item-01) 4)
    (= (x-of-push-left-000-hollow-00 item-01) 9996) (= (y-of-push-left-000-hollow-00 item-01) 10234) (= (cost-of-push-left-000-hollow-00 item-01) 278)
    (can-push-left-010a-hollow-00 item-01) (= (x-of-push-left-010a-hollow-00 item-01) 9921) (= (y-of-push-left-010a-hollow-00 item-01) 10208) (= (cost-of-push-left-010a-hollow-00 item-01) 22)
    (can-push-left-011-hollow-00 item-01) (= (x-of-push-left-011-hollow-00 item-01) 10283) (= (y-of-push-left-011-hollow-00 item-01) 10390) (= (cost-of-push-left-011-hollow-00 item-01) 11)
    (can-push-right-111-hollow-00 item-01) (= (x-of-push-right-111-hollow-00 item-01) 10064) (= (y-of-push-right-111-hollow-00 item-01) 9837) (= (cost-of-push-right-111-hollow-00 item-01) 7)
    ; item-02 starts at (0.5515, -0.0293, 0.0493) m
    (= (x item-02) 2015) (= (y item-02) 2707) (= (z item-02) 0)
    ; What each operator promises for item-02 (features 0.07653 0.1363 0.09872 0).
    ; Not for item-02:
    ; lift-100c-solid-narrow-10: keeps its promise in 1 of 37 rehearsals only.
    ; lift-101-solid-narrow-10: keeps its promise in 1 of 37 rehearsals only.
    ; push-forward-left-000c-solid-narrow-10: scatters more than it moves.
    ; push-forward-right-101-solid-narrow-10: scatters more than it moves.
    ; push-left-011c-solid-narrow-10: scatters more than it moves.
    (= (x-of-lift-100c-solid-narrow-10 item-02) 9408) (= (y-of-lift-100c-solid-narrow-10 item-02) 9735) (= (z-of-lift-100c-solid-narrow-10 item-02) 12219) (= (cost-of-lift-100c-solid-narrow-10 item-02) 298)
    (= (x-of-put-down-lift-100c-solid-narrow-10 item-02) 10005) (= (y-of-put-down-lift-100c-solid-narrow-10 item-02) 9987) (= (z-of-put-down-lift-100c-solid-narrow-10 item-02) 7781)
    (= (x-of-lift-101-solid-narrow-10 item-02) 9858) (= (y-of-lift-101-solid-narrow-10 item-02) 9473) (= (z-of-lift-101-solid-narrow-10 item-02) 12485) (= (cost-of-lift-101-solid-narrow-10 item-02) 298)
    (= (x-of-put-down-lift-101-solid-narrow-10 item-02) 9999) (= (y-of-put-down-lift-101-solid-narrow-10 item-02) 9986) (= (z-of-put-down-lift-101-solid-narrow-10 item-02) 7515)
    (can-pull-110-solid-narrow-10 item-02) (= (x-of-pull-110-solid-narrow-10 item-02) 9619) (= (y-of-pull-110-solid-narrow-10 item-02) 9878) (= (cost-of-pull-110-solid-narrow-10 item-02) 50)
    (can-pull-left-010c-solid-narrow-10 item-02) (= (x-of-pull-left-010c-solid-narrow-10 item-02) 9787) (= (y-of-pull-left-010c-solid-narrow-10 item-02) 10142) (= (cost-of-pull-left-010c-solid-narrow-10 item-02) 4)
    (can-pull-right-100c-solid-narrow-10 item-02) (= (x-of-pull-right-100c-solid-narrow-10 item-02) 9607) (= (y-of-pull-right-100c-solid-narrow-10 item-02) 9585) (= (cost-of-pull-right-100c-solid-narrow-10 item-02) 18)
    (can-push-forward-001-solid-narrow-10 item-02) (= (x-of-push-forward-001-solid-narrow-10 item-02) 10644) (= (y-of-push-forward-001-solid-narrow-10 item-02) 9779) (= (cost-of-push-forward-001-solid-narrow-10 item-02) 9)
    (= (x-of-push-forward-left-000c-solid-narrow-10 item-02) 10096) (= (y-of-push-forward-left-000c-solid-narrow-10 item-02) 9922) (= (cost-of-push-forward-left-000c-solid-narrow-10 item-02) 12)
    (= (x-of-push-forward-right-101-solid-narrow-10 item-02) 10054) (= (y-of-push-forward-right-101-solid-narrow-10 item-02) 9762) (= (cost-of-push-forward-right-101-solid-narrow-10 item-02) 42)
    (can-push-forward-right-111-solid-narrow-10 item-02) (= (x-of-push-forward-right-111-solid-narrow-10 item-02) 10151) (= (y-of-push-forward-right-111-solid-narrow-10 item-02) 9772) (= (cost-of-push-forward-right-111-solid-narrow-10 item-02) 4)
    (= (x-of-push-left-011c-solid-narrow-10 item-02) 10004) (= (y-of-push-left-011c-solid-narrow-10 item-02) 10060) (= (cost-of-push-left-011c-solid-narrow-10 item-02) 4))
  (:goal (and
    ; item-01 shall come to (0.8159, -0.0493, 0.2147) m, 203 mm from where it starts
    (<= (x item-01) 5114) (>= (x item-01) 4205)
    (<= (+ (x item-01) (y item-01)) 7810) (>= (+ (x item-01) (y item-01)) 6523)
    (<= (y item-01) 2961) (>= (y item-01) 2052)
    (<= (+ (y item-01) 1510) (x item-01)) (<= (x item-01) (+ (y item-01) 2796))
    (>= (z item-01) 1995) (<= (z item-01) 2006)
    ; item-02 shall come to (0.5516, -0.0293, 0.0493) m, 0 mm from where it starts
    (<= (x item-02) 2470) (>= (x item-02) 1560)
    (<= (+ (x item-02) (y item-02)) 5366) (>= (+ (x item-02) (y item-02)) 4079)
    (<= (y item-02) 3162) (>= (y item-02) 2253)
    (<= (y item-02) (+ (x item-02) 1336)) (<= (+ (x item-02) 49) (y item-02))
    (>= (z item-02) 0) (<= (z item-02) 0)))
  (:metric minimize (total-cost)))
