; Problem anywhere-1-03 of the learned domain camera.
; How it came about: anywhere, drawn with seed 4; draw 1.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem anywhere-1-03)
  (:domain camera)
  (:objects
    item-01 - kind-wide-11
    start-item-01 goal-item-01 park-01 - spot
    cost28 - price)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 start-item-01) (can-take item-01)
    ; goal-item-01 lies at (0.7957, 0.0696) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (check item-01 goal-item-01 nowhere)
    ; park-01 lies at (0.7061, -0.1041) m
    (free park-01)
    (check item-01 park-01 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 cost28)
    (= (total-cost) 0) (= (cost cost28) 28)
  )
  (:goal (and (done item-01)))
  (:metric minimize (total-cost)))
