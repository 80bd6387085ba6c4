; Problem swap-2-07 of the learned domain camera.
; How it came about: swap, drawn with seed 8; draw 1.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem swap-2-07)
  (:domain camera)
  (:objects
    item-01 item-02 - kind-low-narrow-10
    start-item-01 start-item-02 goal-item-01 goal-item-02 park-01 park-02 - spot
    cost7 cost14 - price)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 start-item-01) (can-take item-01)
    (stands item-02 start-item-02) (can-take item-02)
    ; goal-item-01 lies at (0.7784, -0.2005) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (check item-01 goal-item-01 start-item-02) (then item-01 goal-item-01 start-item-02 nowhere)
    ; goal-item-02 lies at (0.6246, -0.0401) m
    (free goal-item-02)
    (goal-place item-02 goal-item-02) (check item-02 goal-item-02 start-item-01) (then item-02 goal-item-02 start-item-01 nowhere)
    ; park-01 lies at (0.4530, -0.2417) m
    (free park-01)
    (check item-01 park-01 nowhere)
    (check item-02 park-01 nowhere)
    ; park-02 lies at (0.7845, 0.2064) m
    (free park-02)
    (check item-01 park-02 nowhere)
    (check item-02 park-02 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 cost7)
    (can-carry item-02 cost14)
    (= (total-cost) 0) (= (cost cost7) 7) (= (cost cost14) 14)
  )
  (:goal (and (done item-01) (done item-02)))
  (:metric minimize (total-cost)))
