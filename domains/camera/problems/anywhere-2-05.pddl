; Problem anywhere-2-05 of the learned domain camera.
; How it came about: anywhere, drawn with seed 6; draw 1.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem anywhere-2-05)
  (:domain camera)
  (:objects
    item-01 - kind-low-narrow-10
    item-02 - kind-01
    start-item-01 start-item-02 goal-item-01 goal-item-02 park-01 park-02 - spot
    cost20 cost86 - price)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 start-item-01) (can-take item-01)
    (stands item-02 start-item-02) (can-take item-02)
    ; goal-item-01 lies at (0.8195, 0.2530) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (check item-01 goal-item-01 nowhere)
    ; goal-item-02 lies at (0.7030, 0.0869) m
    (free goal-item-02)
    (goal-place item-02 goal-item-02) (check item-02 goal-item-02 nowhere)
    ; park-01 lies at (0.4423, -0.2122) m
    (free park-01)
    (check item-01 park-01 nowhere)
    (check item-02 park-01 nowhere)
    ; park-02 lies at (0.7929, -0.2182) m
    (free park-02)
    (check item-01 park-02 nowhere)
    (check item-02 park-02 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 cost20)
    (can-carry item-02 cost86)
    (= (total-cost) 0) (= (cost cost20) 20) (= (cost cost86) 86)
  )
  (:goal (and (done item-01) (done item-02)))
  (:metric minimize (total-cost)))
