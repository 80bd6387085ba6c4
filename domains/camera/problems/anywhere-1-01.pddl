; Problem anywhere-1-01 of the learned domain camera.
; How it came about: anywhere, drawn with seed 2; draw 1.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem anywhere-1-01)
  (:domain camera)
  (:objects
    item-01 - kind-01
    start-item-01 goal-item-01 park-01 - spot
    cost86 - price)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 start-item-01) (can-take item-01)
    ; goal-item-01 lies at (0.6343, -0.1112) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (check item-01 goal-item-01 nowhere)
    ; park-01 lies at (0.4184, -0.2144) m
    (free park-01)
    (check item-01 park-01 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 cost86)
    (= (total-cost) 0) (= (cost cost86) 86)
  )
  (:goal (and (done item-01)))
  (:metric minimize (total-cost)))
