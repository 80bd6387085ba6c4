; Problem anywhere-6-18 of the learned domain camera.
; How it came about: anywhere, drawn with seed 19; draw 1.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem anywhere-6-18)
  (:domain camera)
  (:objects
    item-01 - kind-low-narrow-10
    item-02 - kind-01
    item-03 item-04 - kind-wide-11
    item-05 - kind-01
    item-06 - kind-low-narrow-10
    start-item-01 start-item-02 start-item-03 start-item-04 start-item-05 start-item-06 goal-item-01 goal-item-02 goal-item-03 goal-item-04 goal-item-05 goal-item-06 park-01 park-02 park-03 park-04 park-05 park-06 - spot
    cost7 cost14 cost28 cost86 - price)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 start-item-01) (can-take item-01)
    (stands item-02 start-item-02) (can-take item-02)
    (stands item-03 start-item-03) (can-take item-03)
    (stands item-04 start-item-04) (can-take item-04)
    (stands item-05 start-item-05) (can-take item-05)
    (stands item-06 start-item-06) (can-take item-06)
    ; goal-item-01 lies at (0.7984, -0.2607) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (check item-01 goal-item-01 nowhere)
    ; goal-item-02 lies at (0.5885, -0.0914) m
    (free goal-item-02)
    (goal-place item-02 goal-item-02) (check item-02 goal-item-02 start-item-01) (then item-02 goal-item-02 start-item-01 nowhere)
    ; goal-item-03 lies at (0.7922, -0.1281) m
    (free goal-item-03)
    (goal-place item-03 goal-item-03) (check item-03 goal-item-03 start-item-01) (then item-03 goal-item-03 start-item-01 start-item-02) (then item-03 goal-item-03 start-item-02 start-item-04) (then item-03 goal-item-03 start-item-04 nowhere)
    ; goal-item-04 lies at (0.4533, 0.0265) m
    (free goal-item-04)
    (goal-place item-04 goal-item-04) (check item-04 goal-item-04 start-item-03) (then item-04 goal-item-04 start-item-03 nowhere)
    ; goal-item-05 lies at (0.6579, 0.0132) m
    (free goal-item-05)
    (goal-place item-05 goal-item-05) (check item-05 goal-item-05 start-item-04) (then item-05 goal-item-05 start-item-04 nowhere)
    ; goal-item-06 lies at (0.6034, 0.1899) m
    (free goal-item-06)
    (goal-place item-06 goal-item-06) (check item-06 goal-item-06 start-item-03) (then item-06 goal-item-06 start-item-03 nowhere)
    ; park-01 lies at (0.8664, 0.2141) m
    (free park-01)
    (check item-01 park-01 nowhere)
    (check item-02 park-01 nowhere)
    (check item-03 park-01 nowhere)
    (check item-04 park-01 nowhere)
    (check item-05 park-01 nowhere)
    (check item-06 park-01 nowhere)
    ; park-02 lies at (0.4737, -0.2204) m
    (free park-02)
    (check item-01 park-02 nowhere)
    (check item-02 park-02 nowhere)
    (check item-03 park-02 start-item-06) (then item-03 park-02 start-item-06 nowhere)
    (check item-05 park-02 nowhere)
    (check item-06 park-02 nowhere)
    ; park-03 lies at (0.8639, 0.0221) m
    (free park-03)
    (check item-01 park-03 start-item-04) (then item-01 park-03 start-item-04 nowhere)
    (check item-02 park-03 nowhere)
    (check item-05 park-03 nowhere)
    (check item-06 park-03 nowhere)
    ; park-04 lies at (0.6632, -0.0976) m
    (free park-04)
    (check item-06 park-04 nowhere)
    ; park-05 lies at (0.3982, 0.1871) m
    (free park-05)
    (check item-01 park-05 start-item-03) (then item-01 park-05 start-item-03 nowhere)
    (check item-02 park-05 nowhere)
    (check item-05 park-05 nowhere)
    (check item-06 park-05 nowhere)
    ; park-06 lies at (0.6017, -0.2571) m
    (free park-06)
    (check item-02 park-06 nowhere)
    (check item-05 park-06 nowhere)
    (check item-06 park-06 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 cost7)
    (can-carry item-02 cost86)
    (can-carry item-03 cost7)
    (can-carry item-04 cost14)
    (can-carry item-05 cost86)
    (can-carry item-06 cost28)
    (= (total-cost) 0) (= (cost cost7) 7) (= (cost cost14) 14) (= (cost cost28) 28) (= (cost cost86) 86)
  )
  (:goal (and (done item-01) (done item-02) (done item-03) (done item-04) (done item-05) (done item-06)))
  (:metric minimize (total-cost)))
