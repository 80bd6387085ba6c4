; Problem row-3-10 of the learned domain places.
; How it came about: row, drawn with seed 11; draw 1.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem row-3-10)
  (:domain places)
  (:objects
    item-01 item-02 item-03 - solid-low-narrow-01
    start-item-01 start-item-02 start-item-03 goal-item-01 goal-item-02 goal-item-03 park-01 park-02 park-03 - spot
    cost4 cost14 - price)
  (:init
    (hand-empty) (ready)
    ; what lies as it shall, and what is to be set upright
    (settled item-01)
    (settled item-02)
    (settled item-03)
    ; where objects are at first
    (stands item-01 start-item-01) (can-take item-01)
    (stands item-02 start-item-02) (can-take item-02)
    (stands item-03 start-item-03) (can-take item-03)
    ; goal-item-01 lies at (0.6500, -0.0929) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (check item-01 goal-item-01 nowhere)
    ; goal-item-02 lies at (0.6500, -0.0011) m
    (free goal-item-02)
    (goal-place item-02 goal-item-02) (check item-02 goal-item-02 start-item-03) (then item-02 goal-item-02 start-item-03 nowhere)
    ; goal-item-03 lies at (0.6500, 0.0919) m
    (free goal-item-03)
    (goal-place item-03 goal-item-03) (check item-03 goal-item-03 nowhere)
    ; park-01 lies at (0.4582, -0.2444) m
    (free park-01)
    (check item-01 park-01 nowhere)
    (check item-02 park-01 nowhere)
    (check item-03 park-01 nowhere)
    ; park-02 lies at (0.6682, 0.2199) m
    (free park-02)
    (check item-01 park-02 nowhere)
    (check item-02 park-02 nowhere)
    (check item-03 park-02 nowhere)
    ; park-03 lies at (0.7819, -0.2514) m
    (free park-03)
    (check item-01 park-03 nowhere)
    (check item-02 park-03 nowhere)
    (check item-03 park-03 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 cost4)
    (can-carry item-02 cost14)
    (can-carry item-03 cost4)
    (= (total-cost) 0) (= (cost cost4) 4) (= (cost cost14) 14)
  )
  (:goal (and (done item-01) (done item-02) (done item-03)))
  (:metric minimize (total-cost)))
