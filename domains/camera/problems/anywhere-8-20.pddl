; Problem anywhere-8-20 of the learned domain camera.
; How it came about: anywhere, drawn with seed 21; draw 1.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem anywhere-8-20)
  (:domain camera)
  (:objects
    item-01 item-02 - kind-01
    item-03 - kind-low-narrow-10
    item-04 - kind-01
    item-05 - kind-wide-11
    item-06 item-07 - kind-tall-narrow-00
    item-08 - kind-low-narrow-10
    start-item-01 start-item-02 start-item-03 start-item-04 start-item-05 start-item-06 start-item-07 start-item-08 goal-item-01 goal-item-02 goal-item-03 goal-item-04 goal-item-05 goal-item-06 goal-item-07 goal-item-08 park-01 park-02 park-03 park-04 park-05 park-06 park-07 park-08 - spot
    cost7 cost14 cost36 cost86 - price)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 start-item-01) (can-take item-01)
    (stands item-02 start-item-02) (can-take item-02)
    (stands item-03 start-item-03) (can-take item-03)
    (stands item-04 start-item-04) (can-take item-04)
    (stands item-05 start-item-05) (can-take item-05)
    (stands item-06 start-item-06) (can-take item-06)
    (stands item-07 start-item-07) (can-take item-07)
    (stands item-08 start-item-08) (can-take item-08)
    ; goal-item-01 lies at (0.7756, 0.0146) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (check item-01 goal-item-01 nowhere)
    ; goal-item-02 lies at (0.6781, 0.0981) m
    (free goal-item-02)
    (goal-place item-02 goal-item-02) (check item-02 goal-item-02 nowhere)
    ; goal-item-03 lies at (0.5838, -0.2595) m
    (free goal-item-03)
    (goal-place item-03 goal-item-03) (check item-03 goal-item-03 start-item-02) (then item-03 goal-item-03 start-item-02 nowhere)
    ; goal-item-04 lies at (0.6611, -0.1053) m
    (free goal-item-04)
    (goal-place item-04 goal-item-04) (check item-04 goal-item-04 nowhere)
    ; goal-item-05 lies at (0.5261, -0.0124) m
    (free goal-item-05)
    (goal-place item-05 goal-item-05) (check item-05 goal-item-05 start-item-03) (then item-05 goal-item-05 start-item-03 nowhere)
    ; goal-item-06 lies at (0.5689, 0.1791) m
    (free goal-item-06)
    (goal-place item-06 goal-item-06) (check item-06 goal-item-06 start-item-05) (then item-06 goal-item-06 start-item-05 nowhere)
    ; goal-item-07 lies at (0.7558, -0.1564) m
    (free goal-item-07)
    (goal-place item-07 goal-item-07) (check item-07 goal-item-07 start-item-06) (then item-07 goal-item-07 start-item-06 nowhere)
    ; goal-item-08 lies at (0.8359, 0.1520) m
    (free goal-item-08)
    (goal-place item-08 goal-item-08) (check item-08 goal-item-08 start-item-01) (then item-08 goal-item-08 start-item-01 nowhere)
    ; park-01 lies at (0.8827, -0.2110) m
    (free park-01)
    (check item-01 park-01 nowhere)
    (check item-02 park-01 nowhere)
    (check item-03 park-01 start-item-08) (then item-03 park-01 start-item-08 nowhere)
    (check item-04 park-01 nowhere)
    (check item-06 park-01 nowhere)
    (check item-07 park-01 nowhere)
    (check item-08 park-01 nowhere)
    ; park-02 lies at (0.6721, 0.2262) m
    (free park-02)
    (check item-06 park-02 nowhere)
    (check item-07 park-02 nowhere)
    (check item-08 park-02 start-item-01) (then item-08 park-02 start-item-01 nowhere)
    ; park-03 lies at (0.9015, 0.2500) m
    (free park-03)
    (check item-01 park-03 nowhere)
    (check item-02 park-03 nowhere)
    (check item-03 park-03 nowhere)
    (check item-06 park-03 nowhere)
    (check item-07 park-03 nowhere)
    (check item-08 park-03 nowhere)
    ; park-04 lies at (0.4021, -0.0702) m
    (free park-04)
    (check item-01 park-04 start-item-03) (then item-01 park-04 start-item-03 start-item-07) (then item-01 park-04 start-item-07 nowhere)
    (check item-02 park-04 start-item-03) (then item-02 park-04 start-item-03 start-item-07) (then item-02 park-04 start-item-07 nowhere)
    (check item-04 park-04 start-item-03) (then item-04 park-04 start-item-03 start-item-07) (then item-04 park-04 start-item-07 nowhere)
    ; park-05 lies at (0.8278, 0.2023) m
    (free park-05)
    ; park-06 lies at (0.8475, 0.0052) m
    (free park-06)
    (check item-01 park-06 nowhere)
    ; park-07 lies at (0.8473, -0.0859) m
    (free park-07)
    ; park-08 lies at (0.8644, 0.0938) m
    (free park-08)
    (check item-08 park-08 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 cost86)
    (can-carry item-02 cost86)
    (can-carry item-03 cost14)
    (can-carry item-04 cost86)
    (can-carry item-05 cost7)
    (can-carry item-06 cost7)
    (can-carry item-07 cost36)
    (can-carry item-08 cost7)
    (= (total-cost) 0) (= (cost cost7) 7) (= (cost cost14) 14) (= (cost cost36) 36) (= (cost cost86) 86)
  )
  (:goal (and (done item-01) (done item-02) (done item-03) (done item-04) (done item-05) (done item-06) (done item-07) (done item-08)))
  (:metric minimize (total-cost)))
