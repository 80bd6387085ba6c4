; Problem anywhere-2-05 of the learned domain places.
; How it came about: anywhere, drawn with seed 6; draw 1.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem anywhere-2-05)
  (:domain places)
  (:objects
    item-01 - solid-low-narrow-01
    item-02 - solid-low-10
    start-item-01 start-item-02 goal-item-01 goal-item-02 park-01 park-02 - spot
    cost4 cost7 - price)
  (:init
    (hand-empty) (ready)
    ; what lies as it shall, and what is to be set upright
    (settled item-01)
    (settled item-02)
    ; where objects are at first
    (stands item-01 start-item-01) (can-take item-01)
    (stands item-02 start-item-02) (can-take item-02)
    ; goal-item-01 lies at (0.8196, 0.2533) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (check item-01 goal-item-01 nowhere)
    ; goal-item-02 lies at (0.7031, 0.0866) m
    (free goal-item-02)
    (goal-place item-02 goal-item-02) (check item-02 goal-item-02 nowhere)
    ; park-01 lies at (0.4421, -0.2114) m
    (free park-01)
    (check item-01 park-01 nowhere)
    (check item-02 park-01 nowhere)
    ; park-02 lies at (0.7930, -0.2174) m
    (free park-02)
    (check item-01 park-02 nowhere)
    (check item-02 park-02 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 cost4)
    (can-carry item-02 cost7)
    (= (total-cost) 0) (= (cost cost4) 4) (= (cost cost7) 7)
  )
  (:goal (and (done item-01) (done item-02)))
  (:metric minimize (total-cost)))
