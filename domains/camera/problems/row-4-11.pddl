; Problem row-4-11 of the learned domain camera.
; How it came about: row, drawn with seed 12; draw 3.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem row-4-11)
  (:domain camera)
  (:objects
    item-01 - kind-low-narrow-10
    item-02 - kind-tall-narrow-00
    item-03 item-04 - kind-wide-11
    start-item-01 start-item-02 start-item-03 start-item-04 goal-item-01 goal-item-02 goal-item-03 goal-item-04 park-01 park-02 park-03 park-04 - spot
    cost14 cost28 - price)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 start-item-01) (can-take item-01)
    (stands item-02 start-item-02) (can-take item-02)
    (stands item-03 start-item-03) (can-take item-03)
    (stands item-04 start-item-04) (can-take item-04)
    ; goal-item-01 lies at (0.6500, -0.2599) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (check item-01 goal-item-01 nowhere)
    ; goal-item-02 lies at (0.6500, -0.1499) m
    (free goal-item-02)
    (goal-place item-02 goal-item-02) (check item-02 goal-item-02 start-item-04) (then item-02 goal-item-02 start-item-04 nowhere)
    ; goal-item-03 lies at (0.6500, 0.0265) m
    (free goal-item-03)
    (goal-place item-03 goal-item-03) (check item-03 goal-item-03 start-item-01) (then item-03 goal-item-03 start-item-01 nowhere)
    ; goal-item-04 lies at (0.6500, 0.2168) m
    (free goal-item-04)
    (goal-place item-04 goal-item-04) (check item-04 goal-item-04 start-item-02) (then item-04 goal-item-04 start-item-02 nowhere)
    ; park-01 lies at (0.8459, 0.1519) m
    (free park-01)
    (check item-01 park-01 nowhere)
    (check item-02 park-01 nowhere)
    (check item-03 park-01 nowhere)
    (check item-04 park-01 nowhere)
    ; park-02 lies at (0.4698, -0.1916) m
    (free park-02)
    (check item-01 park-02 nowhere)
    (check item-02 park-02 nowhere)
    (check item-03 park-02 nowhere)
    (check item-04 park-02 nowhere)
    ; park-03 lies at (0.4585, -0.0067) m
    (free park-03)
    (check item-01 park-03 nowhere)
    (check item-02 park-03 nowhere)
    (check item-03 park-03 nowhere)
    (check item-04 park-03 nowhere)
    ; park-04 lies at (0.7948, -0.2632) m
    (free park-04)
    (check item-01 park-04 nowhere)
    (check item-02 park-04 start-item-04) (then item-02 park-04 start-item-04 nowhere)
    (check item-03 park-04 start-item-04) (then item-03 park-04 start-item-04 nowhere)
    (check item-04 park-04 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 cost14)
    (can-carry item-02 cost14)
    (can-carry item-03 cost14)
    (can-carry item-04 cost28)
    (= (total-cost) 0) (= (cost cost14) 14) (= (cost cost28) 28)
  )
  (:goal (and (done item-01) (done item-02) (done item-03) (done item-04)))
  (:metric minimize (total-cost)))
