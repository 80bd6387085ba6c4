; Problem crowded-4-17 of the learned domain camera.
; How it came about: crowded, drawn with seed 18; draw 1.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem crowded-4-17)
  (:domain camera)
  (:objects
    item-01 item-02 - kind-01
    item-03 item-04 - kind-wide-11
    start-item-01 start-item-02 start-item-03 start-item-04 goal-item-01 goal-item-02 goal-item-03 goal-item-04 park-01 park-02 park-03 park-04 - spot
    cost14 cost28 cost86 - price)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 start-item-01) (can-take item-01)
    (stands item-02 start-item-02) (can-take item-02)
    (stands item-03 start-item-03) (can-take item-03)
    (stands item-04 start-item-04) (can-take item-04)
    ; goal-item-01 lies at (0.9112, 0.1576) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (check item-01 goal-item-01 nowhere)
    ; goal-item-02 lies at (0.7537, 0.1251) m
    (free goal-item-02)
    (goal-place item-02 goal-item-02) (check item-02 goal-item-02 nowhere)
    ; goal-item-03 lies at (0.6539, -0.2216) m
    (free goal-item-03)
    (goal-place item-03 goal-item-03) (check item-03 goal-item-03 nowhere)
    ; goal-item-04 lies at (0.5840, -0.0226) m
    (free goal-item-04)
    (goal-place item-04 goal-item-04) (check item-04 goal-item-04 start-item-01) (then item-04 goal-item-04 start-item-01 start-item-03) (then item-04 goal-item-04 start-item-03 nowhere)
    ; park-01 lies at (0.4355, -0.2103) m
    (free park-01)
    (check item-01 park-01 nowhere)
    (check item-02 park-01 nowhere)
    (check item-03 park-01 nowhere)
    (check item-04 park-01 nowhere)
    ; park-02 lies at (0.4556, 0.1447) m
    (free park-02)
    (check item-01 park-02 nowhere)
    (check item-02 park-02 nowhere)
    (check item-03 park-02 start-item-02) (then item-03 park-02 start-item-02 nowhere)
    ; park-03 lies at (0.6221, 0.1978) m
    (free park-03)
    (check item-01 park-03 nowhere)
    (check item-02 park-03 nowhere)
    (check item-03 park-03 nowhere)
    (check item-04 park-03 start-item-01) (then item-04 park-03 start-item-01 start-item-02) (then item-04 park-03 start-item-02 nowhere)
    ; park-04 lies at (0.4210, -0.0587) m
    (free park-04)
    (check item-01 park-04 nowhere)
    (check item-02 park-04 nowhere)
    (check item-03 park-04 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 cost86)
    (can-carry item-02 cost86)
    (can-carry item-03 cost14)
    (can-carry item-04 cost28)
    (= (total-cost) 0) (= (cost cost14) 14) (= (cost cost28) 28) (= (cost cost86) 86)
  )
  (:goal (and (done item-01) (done item-02) (done item-03) (done item-04)))
  (:metric minimize (total-cost)))
