; Problem swap-2-06 of the learned domain camera.
; How it came about: swap, drawn with seed 7; draw 1.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem swap-2-06)
  (:domain camera)
  (:objects
    item-01 - kind-01
    item-02 - kind-low-narrow-10
    start-item-01 start-item-02 goal-item-01 goal-item-02 park-01 park-02 - spot
    cost7 cost86 - price)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 start-item-01) (can-take item-01)
    (stands item-02 start-item-02) (can-take item-02)
    ; goal-item-01 lies at (0.8610, 0.1629) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (check item-01 goal-item-01 start-item-02) (then item-01 goal-item-01 start-item-02 nowhere)
    ; goal-item-02 lies at (0.6448, 0.2138) m
    (free goal-item-02)
    (goal-place item-02 goal-item-02) (check item-02 goal-item-02 start-item-01) (then item-02 goal-item-02 start-item-01 nowhere)
    ; park-01 lies at (0.7024, -0.0958) m
    (free park-01)
    (check item-01 park-01 nowhere)
    (check item-02 park-01 nowhere)
    ; park-02 lies at (0.4744, -0.2011) m
    (free park-02)
    (check item-01 park-02 nowhere)
    (check item-02 park-02 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 cost86)
    (can-carry item-02 cost7)
    (= (total-cost) 0) (= (cost cost7) 7) (= (cost cost86) 86)
  )
  (:goal (and (done item-01) (done item-02)))
  (:metric minimize (total-cost)))
