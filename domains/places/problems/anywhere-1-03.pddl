; Problem anywhere-1-03 of the learned domain places.
; How it came about: anywhere, drawn with seed 4; draw 1.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem anywhere-1-03)
  (:domain places)
  (:objects
    item-01 - any-tall-narrow-11
    start-item-01 goal-item-01 park-01 - spot
    cost4 - price)
  (:init
    (hand-empty) (ready)
    ; what lies as it shall, and what is to be set upright
    (settled item-01)
    ; where objects are at first
    (stands item-01 start-item-01) (can-take item-01)
    ; goal-item-01 lies at (0.7956, 0.0695) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (check item-01 goal-item-01 nowhere)
    ; park-01 lies at (0.7061, -0.1040) m
    (free park-01)
    (check item-01 park-01 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 cost4)
    (= (total-cost) 0) (= (cost cost4) 4)
  )
  (:goal (and (done item-01)))
  (:metric minimize (total-cost)))
