; Problem anywhere-6-18 of the learned domain places.
; How it came about: anywhere, drawn with seed 19; draw 1.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem anywhere-6-18)
  (:domain places)
  (:objects
    item-01 - solid-low-narrow-01
    item-02 - solid-low-10
    item-03 item-04 - hollow-wide-00
    item-05 - solid-low-10
    item-06 - solid-low-narrow-01
    start-item-01 start-item-02 start-item-03 start-item-04 start-item-05 start-item-06 goal-item-01 goal-item-02 goal-item-03 goal-item-04 goal-item-05 goal-item-06 park-01 park-02 park-03 park-04 park-05 park-06 - spot
    cost4 cost7 cost11 - price)
  (:init
    (hand-empty) (ready)
    ; what lies as it shall, and what is to be set upright
    (settled item-01)
    (settled item-02)
    (settled item-03)
    (settled item-04)
    (settled item-05)
    (settled item-06)
    ; where objects are at first
    (stands item-01 start-item-01) (can-take item-01)
    (stands item-02 start-item-02) (can-take item-02)
    (stands item-03 start-item-03) (can-take item-03)
    (stands item-04 start-item-04) (can-take item-04)
    (stands item-05 start-item-05) (can-take item-05)
    (stands item-06 start-item-06) (can-take item-06)
    ; goal-item-01 lies at (0.4767, -0.2162) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (check item-01 goal-item-01 nowhere)
    ; goal-item-02 lies at (0.5806, -0.0884) m
    (free goal-item-02)
    (goal-place item-02 goal-item-02) (check item-02 goal-item-02 start-item-01) (then item-02 goal-item-02 start-item-01 nowhere)
    ; goal-item-03 lies at (0.8505, -0.0270) m
    (free goal-item-03)
    (goal-place item-03 goal-item-03) (check item-03 goal-item-03 start-item-02) (then item-03 goal-item-03 start-item-02 nowhere)
    ; goal-item-04 lies at (0.5068, 0.1711) m
    (free goal-item-04)
    (goal-place item-04 goal-item-04) (check item-04 goal-item-04 start-item-03) (then item-04 goal-item-04 start-item-03 nowhere)
    ; goal-item-05 lies at (0.6502, -0.1482) m
    (free goal-item-05)
    (goal-place item-05 goal-item-05) (check item-05 goal-item-05 start-item-01) (then item-05 goal-item-05 start-item-01 nowhere)
    ; goal-item-06 lies at (0.8176, -0.1915) m
    (free goal-item-06)
    (goal-place item-06 goal-item-06) (check item-06 goal-item-06 start-item-02) (then item-06 goal-item-06 start-item-02 start-item-05) (then item-06 goal-item-06 start-item-05 nowhere)
    ; park-01 lies at (0.8403, 0.1840) m
    (free park-01)
    (check item-01 park-01 nowhere)
    (check item-02 park-01 nowhere)
    (check item-03 park-01 nowhere)
    (check item-04 park-01 nowhere)
    (check item-05 park-01 nowhere)
    (check item-06 park-01 nowhere)
    ; park-02 lies at (0.7100, -0.0600) m
    (free park-02)
    (check item-02 park-02 nowhere)
    (check item-05 park-02 nowhere)
    ; park-03 lies at (0.6499, -0.0385) m
    (free park-03)
    ; park-04 lies at (0.7125, 0.2552) m
    (free park-04)
    (check item-02 park-04 start-item-06) (then item-02 park-04 start-item-06 nowhere)
    (check item-05 park-04 start-item-06) (then item-05 park-04 start-item-06 nowhere)
    ; park-05 lies at (0.7095, -0.2431) m
    (free park-05)
    (check item-01 park-05 nowhere)
    (check item-02 park-05 nowhere)
    (check item-05 park-05 nowhere)
    (check item-06 park-05 nowhere)
    ; park-06 lies at (0.6948, 0.0279) m
    (free park-06)
    ; what can be carried, from where, and its price
    (can-carry item-01 cost4)
    (can-carry item-02 cost11)
    (can-carry item-03 cost4)
    (can-carry item-04 cost4)
    (can-carry item-05 cost7)
    (can-carry item-06 cost4)
    (= (total-cost) 0) (= (cost cost4) 4) (= (cost cost7) 7) (= (cost cost11) 11)
  )
  (:goal (and (done item-01) (done item-02) (done item-03) (done item-04) (done item-05) (done item-06)))
  (:metric minimize (total-cost)))
