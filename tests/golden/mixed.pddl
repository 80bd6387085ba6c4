; Problem mixed of the learned domain toy.
; How it came about: by hand.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
; Cells of 20 mm. A goal is met within 20 mm; goal cells keep inside by what the rounding of 1 motion may take.
(define (problem mixed)
  (:domain toy)
  (:objects
    item-01 - cube
    item-02 - slab
    start-item-01 start-item-02 goal-item-01 goal-item-02 park-01 park-02 - spot
    m-001 m-010 - motion
    zone1 - zone
    dx0 dx4 - x-shift
    x00 x01 x02 x03 x04 x05 x06 x07 x08 x09 x10 x11 x12 x13 x14 x15 x16 x17 x18 x19 x20 x21 x22 x23 x24 x25 x26 x27 x28 x29 x30 - x-cell
    dy0 dy4 - y-shift
    y00 y01 y02 y03 y04 y05 y06 y07 y08 y09 y10 y11 y12 y13 y14 y15 y16 y17 y18 y19 y20 y21 y22 y23 y24 y25 y26 y27 y28 y29 y30 - y-cell
    cost6 - price)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 start-item-01) (can-take item-01)
    (stands item-02 start-item-02)
    ; goal-item-01 lies at (0.7000, 0.0000) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (check item-01 goal-item-01 start-item-02) (then item-01 goal-item-01 start-item-02 nowhere)
    ; goal-item-02 lies at (0.7000, 0.1600) m
    (free goal-item-02)
    ; park-01 lies at (0.8598, 0.1816) m
    (free park-01)
    (check item-01 park-01 nowhere)
    ; park-02 lies at (0.8611, -0.2188) m
    (free park-02)
    (check item-01 park-02 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 cost6)
    ; item-02 lies at (0.7000, 0.0000, 0.0250) m at first
    (by-cells item-02) (on-table item-02) (at-x item-02 x15) (at-y item-02 y15) (pushes item-02 m-010 dx4 dy0 cost6) (pushes item-02 m-001 dx0 dy4 cost6)
    ; and shall come to (0.7000, 0.1600, 0.0250) m
    (goal-on-table item-02 zone1) (goal-cell item-02 x14 y23 zone1) (goal-cell item-02 x15 y22 zone1) (goal-cell item-02 x15 y23 zone1) (goal-cell item-02 x15 y24 zone1) (goal-cell item-02 x16 y23 zone1)
    ; where steps lead
    (x-sum dx0 x00 x00) (x-sum dx0 x01 x01) (x-sum dx0 x02 x02) (x-sum dx0 x03 x03) (x-sum dx0 x04 x04) (x-sum dx0 x05 x05) (x-sum dx0 x06 x06) (x-sum dx0 x07 x07) (x-sum dx0 x08 x08) (x-sum dx0 x09 x09) (x-sum dx0 x10 x10) (x-sum dx0 x11 x11) (x-sum dx0 x12 x12) (x-sum dx0 x13 x13) (x-sum dx0 x14 x14) (x-sum dx0 x15 x15) (x-sum dx0 x16 x16) (x-sum dx0 x17 x17) (x-sum dx0 x18 x18) (x-sum dx0 x19 x19) (x-sum dx0 x20 x20) (x-sum dx0 x21 x21) (x-sum dx0 x22 x22) (x-sum dx0 x23 x23) (x-sum dx0 x24 x24) (x-sum dx0 x25 x25) (x-sum dx0 x26 x26) (x-sum dx0 x27 x27) (x-sum dx0 x28 x28) (x-sum dx0 x29 x29) (x-sum dx0 x30 x30)
    (x-sum dx4 x00 x04) (x-sum dx4 x01 x05) (x-sum dx4 x02 x06) (x-sum dx4 x03 x07) (x-sum dx4 x04 x08) (x-sum dx4 x05 x09) (x-sum dx4 x06 x10) (x-sum dx4 x07 x11) (x-sum dx4 x08 x12) (x-sum dx4 x09 x13) (x-sum dx4 x10 x14) (x-sum dx4 x11 x15) (x-sum dx4 x12 x16) (x-sum dx4 x13 x17) (x-sum dx4 x14 x18) (x-sum dx4 x15 x19) (x-sum dx4 x16 x20) (x-sum dx4 x17 x21) (x-sum dx4 x18 x22) (x-sum dx4 x19 x23) (x-sum dx4 x20 x24) (x-sum dx4 x21 x25) (x-sum dx4 x22 x26) (x-sum dx4 x23 x27) (x-sum dx4 x24 x28) (x-sum dx4 x25 x29) (x-sum dx4 x26 x30)
    (y-sum dy0 y00 y00) (y-sum dy0 y01 y01) (y-sum dy0 y02 y02) (y-sum dy0 y03 y03) (y-sum dy0 y04 y04) (y-sum dy0 y05 y05) (y-sum dy0 y06 y06) (y-sum dy0 y07 y07) (y-sum dy0 y08 y08) (y-sum dy0 y09 y09) (y-sum dy0 y10 y10) (y-sum dy0 y11 y11) (y-sum dy0 y12 y12) (y-sum dy0 y13 y13) (y-sum dy0 y14 y14) (y-sum dy0 y15 y15) (y-sum dy0 y16 y16) (y-sum dy0 y17 y17) (y-sum dy0 y18 y18) (y-sum dy0 y19 y19) (y-sum dy0 y20 y20) (y-sum dy0 y21 y21) (y-sum dy0 y22 y22) (y-sum dy0 y23 y23) (y-sum dy0 y24 y24) (y-sum dy0 y25 y25) (y-sum dy0 y26 y26) (y-sum dy0 y27 y27) (y-sum dy0 y28 y28) (y-sum dy0 y29 y29) (y-sum dy0 y30 y30)
    (y-sum dy4 y00 y04) (y-sum dy4 y01 y05) (y-sum dy4 y02 y06) (y-sum dy4 y03 y07) (y-sum dy4 y04 y08) (y-sum dy4 y05 y09) (y-sum dy4 y06 y10) (y-sum dy4 y07 y11) (y-sum dy4 y08 y12) (y-sum dy4 y09 y13) (y-sum dy4 y10 y14) (y-sum dy4 y11 y15) (y-sum dy4 y12 y16) (y-sum dy4 y13 y17) (y-sum dy4 y14 y18) (y-sum dy4 y15 y19) (y-sum dy4 y16 y20) (y-sum dy4 y17 y21) (y-sum dy4 y18 y22) (y-sum dy4 y19 y23) (y-sum dy4 y20 y24) (y-sum dy4 y21 y25) (y-sum dy4 y22 y26) (y-sum dy4 y23 y27) (y-sum dy4 y24 y28) (y-sum dy4 y25 y29) (y-sum dy4 y26 y30)
    (= (total-cost) 0) (= (cost cost6) 6)
  )
  (:goal (and (done item-01) (done item-02)))
  (:metric minimize (total-cost)))
