; Problem crowded-3-15 of the learned domain camera.
; How it came about: crowded, drawn with seed 16; draw 1.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem crowded-3-15)
  (:domain camera)
  (:objects
    item-01 - kind-tall-narrow-00
    item-02 - kind-low-narrow-10
    item-03 - kind-tall-narrow-00
    start-item-01 start-item-02 start-item-03 goal-item-01 goal-item-02 goal-item-03 park-01 park-02 park-03 - spot
    cost7 cost14 - price)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 start-item-01) (can-take item-01)
    (stands item-02 start-item-02) (can-take item-02)
    (stands item-03 start-item-03) (can-take item-03)
    ; goal-item-01 lies at (0.7041, -0.1697) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (check item-01 goal-item-01 nowhere)
    ; goal-item-02 lies at (0.4338, -0.1094) m
    (free goal-item-02)
    (goal-place item-02 goal-item-02) (check item-02 goal-item-02 nowhere)
    ; goal-item-03 lies at (0.4580, 0.0882) m
    (free goal-item-03)
    (goal-place item-03 goal-item-03) (check item-03 goal-item-03 nowhere)
    ; park-01 lies at (0.4610, -0.2177) m
    (free park-01)
    (check item-01 park-01 nowhere)
    (check item-02 park-01 nowhere)
    (check item-03 park-01 nowhere)
    ; park-02 lies at (0.6054, 0.1757) m
    (free park-02)
    (check item-01 park-02 nowhere)
    (check item-02 park-02 nowhere)
    (check item-03 park-02 nowhere)
    ; park-03 lies at (0.6500, -0.0337) m
    (free park-03)
    (check item-01 park-03 nowhere)
    (check item-02 park-03 nowhere)
    (check item-03 park-03 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 cost14)
    (can-carry item-02 cost7)
    (can-carry item-03 cost14)
    (= (total-cost) 0) (= (cost cost7) 7) (= (cost cost14) 14)
  )
  (:goal (and (done item-01) (done item-02) (done item-03)))
  (:metric minimize (total-cost)))
