; Problem anywhere-1-02 of the learned domain camera.
; How it came about: anywhere, drawn with seed 3; draw 1.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem anywhere-1-02)
  (:domain camera)
  (:objects
    item-01 - kind-tall-narrow-00
    start-item-01 goal-item-01 park-01 - spot
    cost45 - price)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 start-item-01) (can-take item-01)
    ; goal-item-01 lies at (0.4582, 0.0659) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (check item-01 goal-item-01 nowhere)
    ; park-01 lies at (0.4496, -0.2366) m
    (free park-01)
    (check item-01 park-01 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 cost45)
    (= (total-cost) 0) (= (cost cost45) 45)
  )
  (:goal (and (done item-01)))
  (:metric minimize (total-cost)))
