; Problem anywhere-4-19 of the learned domain towers.
; How it came about: anywhere, drawn with seed 20; draw 1.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem anywhere-4-19)
  (:domain towers)
  (:objects
    item-01 - solid-low-narrow-01
    item-02 - hollow-wide-00
    item-03 - solid-low-narrow-01
    item-04 - hollow-wide-00
    start-item-01 start-item-02 start-item-03 start-item-04 goal-item-01 goal-item-02 goal-item-03 goal-item-04 park-01 park-02 park-03 park-04 - spot
    cost4 cost12 cost35 cost37 cost56 cost59 cost70 cost74 cost82 cost89 cost112 cost121 cost144 cost174 cost196 - price)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 start-item-01) (bears item-01 n0) (can-take item-01)
    (stands item-02 start-item-02) (bears item-02 n0) (can-take item-02)
    (stands item-03 start-item-03) (bears item-03 n0) (can-take item-03)
    (stands item-04 start-item-04) (bears item-04 n0) (can-take item-04)
    ; goal-item-01 lies at (0.4826, -0.0687) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (check item-01 goal-item-01 nowhere)
    ; goal-item-02 lies at (0.7535, 0.1984) m
    (free goal-item-02)
    (goal-place item-02 goal-item-02) (check item-02 goal-item-02 nowhere)
    ; goal-item-03 lies at (0.4570, 0.0197) m
    (free goal-item-03)
    (goal-place item-03 goal-item-03) (check item-03 goal-item-03 start-item-02) (then item-03 goal-item-03 start-item-02 nowhere)
    ; goal-item-04 lies at (0.4853, -0.2216) m
    (free goal-item-04)
    (goal-place item-04 goal-item-04) (check item-04 goal-item-04 start-item-01) (then item-04 goal-item-04 start-item-01 nowhere)
    ; park-01 lies at (0.8327, 0.0280) m
    (free park-01)
    (check item-01 park-01 nowhere)
    (check item-03 park-01 nowhere)
    ; park-02 lies at (0.7796, -0.2615) m
    (free park-02)
    (check item-01 park-02 nowhere)
    (check item-02 park-02 start-item-04) (then item-02 park-02 start-item-04 nowhere)
    (check item-03 park-02 nowhere)
    (check item-04 park-02 nowhere)
    ; park-03 lies at (0.5059, 0.2486) m
    (free park-03)
    (check item-01 park-03 nowhere)
    (check item-02 park-03 nowhere)
    (check item-03 park-03 nowhere)
    (check item-04 park-03 start-item-02) (then item-04 park-03 start-item-02 nowhere)
    ; park-04 lies at (0.6445, -0.0127) m
    (free park-04)
    (check item-01 park-04 nowhere)
    (check item-03 park-04 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 from-spot cost4)
    (can-carry item-02 from-spot cost4)
    (can-carry item-03 from-spot cost4)
    (can-carry item-04 from-spot cost4)
    (= (total-cost) 0) (= (cost cost4) 4) (= (cost cost12) 12) (= (cost cost35) 35) (= (cost cost37) 37) (= (cost cost56) 56) (= (cost cost59) 59) (= (cost cost70) 70) (= (cost cost74) 74) (= (cost cost82) 82) (= (cost cost89) 89) (= (cost cost112) 112) (= (cost cost121) 121) (= (cost cost144) 144) (= (cost cost174) 174) (= (cost cost196) 196)
  )
  (:goal (and (done item-01) (done item-02) (done item-03) (done item-04)))
  (:metric minimize (total-cost)))
