; Problem row-3-10 of the learned domain camera.
; How it came about: row, drawn with seed 11; draw 1.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem row-3-10)
  (:domain camera)
  (:objects
    item-01 - kind-tall-narrow-00
    item-02 item-03 - kind-low-narrow-10
    start-item-01 start-item-02 start-item-03 goal-item-01 goal-item-02 goal-item-03 park-01 park-02 park-03 - spot
    cost7 cost45 - price)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 start-item-01) (can-take item-01)
    (stands item-02 start-item-02) (can-take item-02)
    (stands item-03 start-item-03) (can-take item-03)
    ; goal-item-01 lies at (0.6500, -0.0930) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (check item-01 goal-item-01 nowhere)
    ; goal-item-02 lies at (0.6500, -0.0009) m
    (free goal-item-02)
    (goal-place item-02 goal-item-02) (check item-02 goal-item-02 start-item-03) (then item-02 goal-item-02 start-item-03 nowhere)
    ; goal-item-03 lies at (0.6500, 0.0921) m
    (free goal-item-03)
    (goal-place item-03 goal-item-03) (check item-03 goal-item-03 nowhere)
    ; park-01 lies at (0.4593, -0.2445) m
    (free park-01)
    (check item-01 park-01 nowhere)
    (check item-02 park-01 nowhere)
    (check item-03 park-01 nowhere)
    ; park-02 lies at (0.6681, 0.2200) m
    (free park-02)
    (check item-01 park-02 nowhere)
    (check item-02 park-02 nowhere)
    (check item-03 park-02 nowhere)
    ; park-03 lies at (0.7812, -0.2515) m
    (free park-03)
    (check item-01 park-03 nowhere)
    (check item-02 park-03 nowhere)
    (check item-03 park-03 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 cost7)
    (can-carry item-02 cost45)
    (can-carry item-03 cost7)
    (= (total-cost) 0) (= (cost cost7) 7) (= (cost cost45) 45)
  )
  (:goal (and (done item-01) (done item-02) (done item-03)))
  (:metric minimize (total-cost)))
