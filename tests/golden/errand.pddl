; Problem errand of the learned domain tabletop, for its encodings on a grid.
; How it came about: seed 7.
; A goal is met within 50 mm. goal-xy and goal-z list the cells from
; which it is met whatever the grid rounds on the way, in plans of at most
; 1 step(s) and cells of 20 mm.
(define (problem errand)
  (:domain tabletop)
  (:objects
    item-01 - block
    item-02 - tray
    x00 x01 x02 x03 x04 x05 x06 x07 x08 x09 x10 x11 x12 x13 x14 x15 x16 x17 x18 x19 x20 x21 x22 x23 x24 x25 x26 x27 x28 x29 x30 - x-cell
    y00 y01 y02 y03 y04 y05 y06 y07 y08 y09 y10 y11 y12 y13 y14 y15 y16 y17 y18 y19 y20 y21 y22 y23 y24 y25 y26 y27 y28 y29 y30 - y-cell
    z00 z01 z02 z03 z04 z05 z06 z07 z08 z09 z10 - z-cell)
  (:init
    (hand-empty) (ready) (= (total-cost) 0)
    ; item-01 starts at (0.4512, 0.0133, 0.0250) m
    (at-x item-01 x08) (at-y item-01 y16) (at-z item-01 z00)
    ; item-02 starts at (0.6000, -0.1000, 0.0200) m
    (at-x item-02 x15) (at-y item-02 y10) (at-z item-02 z00)
    ; item-01 shall come to (0.5350, -0.0200, 0.2280) m, 222 mm from where it starts
    (goal-xy item-01 x11 y13) (goal-xy item-01 x11 y14) (goal-xy item-01 x11 y15)
    (goal-xy item-01 x12 y13) (goal-xy item-01 x12 y14) (goal-xy item-01 x12 y15) (goal-xy item-01 x12 y16)
    (goal-xy item-01 x13 y13) (goal-xy item-01 x13 y14) (goal-xy item-01 x13 y15) (goal-xy item-01 x13 y16)
    (goal-xy item-01 x14 y14) (goal-xy item-01 x14 y15)
    (goal-z item-01 z10)
    ; item-02 shall come to (0.5450, -0.0870, 0.0200) m, 57 mm from where it starts
    (goal-xy item-02 x11 y10) (goal-xy item-02 x11 y11) (goal-xy item-02 x11 y12)
    (goal-xy item-02 x12 y09) (goal-xy item-02 x12 y10) (goal-xy item-02 x12 y11) (goal-xy item-02 x12 y12)
    (goal-xy item-02 x13 y09) (goal-xy item-02 x13 y10) (goal-xy item-02 x13 y11) (goal-xy item-02 x13 y12)
    (goal-xy item-02 x14 y10) (goal-xy item-02 x14 y11)
    (goal-z item-02 z00)
    (x-minus-3 x03 x00) (x-minus-3 x04 x01) (x-minus-3 x05 x02) (x-minus-3 x06 x03) (x-minus-3 x07 x04) (x-minus-3 x08 x05) (x-minus-3 x09 x06) (x-minus-3 x10 x07) (x-minus-3 x11 x08) (x-minus-3 x12 x09) (x-minus-3 x13 x10) (x-minus-3 x14 x11) (x-minus-3 x15 x12) (x-minus-3 x16 x13) (x-minus-3 x17 x14) (x-minus-3 x18 x15) (x-minus-3 x19 x16) (x-minus-3 x20 x17) (x-minus-3 x21 x18) (x-minus-3 x22 x19) (x-minus-3 x23 x20) (x-minus-3 x24 x21) (x-minus-3 x25 x22) (x-minus-3 x26 x23) (x-minus-3 x27 x24) (x-minus-3 x28 x25) (x-minus-3 x29 x26) (x-minus-3 x30 x27)
    (x-plus-1 x00 x01) (x-plus-1 x01 x02) (x-plus-1 x02 x03) (x-plus-1 x03 x04) (x-plus-1 x04 x05) (x-plus-1 x05 x06) (x-plus-1 x06 x07) (x-plus-1 x07 x08) (x-plus-1 x08 x09) (x-plus-1 x09 x10) (x-plus-1 x10 x11) (x-plus-1 x11 x12) (x-plus-1 x12 x13) (x-plus-1 x13 x14) (x-plus-1 x14 x15) (x-plus-1 x15 x16) (x-plus-1 x16 x17) (x-plus-1 x17 x18) (x-plus-1 x18 x19) (x-plus-1 x19 x20) (x-plus-1 x20 x21) (x-plus-1 x21 x22) (x-plus-1 x22 x23) (x-plus-1 x23 x24) (x-plus-1 x24 x25) (x-plus-1 x25 x26) (x-plus-1 x26 x27) (x-plus-1 x27 x28) (x-plus-1 x28 x29) (x-plus-1 x29 x30)
    (x-plus-4 x00 x04) (x-plus-4 x01 x05) (x-plus-4 x02 x06) (x-plus-4 x03 x07) (x-plus-4 x04 x08) (x-plus-4 x05 x09) (x-plus-4 x06 x10) (x-plus-4 x07 x11) (x-plus-4 x08 x12) (x-plus-4 x09 x13) (x-plus-4 x10 x14) (x-plus-4 x11 x15) (x-plus-4 x12 x16) (x-plus-4 x13 x17) (x-plus-4 x14 x18) (x-plus-4 x15 x19) (x-plus-4 x16 x20) (x-plus-4 x17 x21) (x-plus-4 x18 x22) (x-plus-4 x19 x23) (x-plus-4 x20 x24) (x-plus-4 x21 x25) (x-plus-4 x22 x26) (x-plus-4 x23 x27) (x-plus-4 x24 x28) (x-plus-4 x25 x29) (x-plus-4 x26 x30)
    (y-minus-2 y02 y00) (y-minus-2 y03 y01) (y-minus-2 y04 y02) (y-minus-2 y05 y03) (y-minus-2 y06 y04) (y-minus-2 y07 y05) (y-minus-2 y08 y06) (y-minus-2 y09 y07) (y-minus-2 y10 y08) (y-minus-2 y11 y09) (y-minus-2 y12 y10) (y-minus-2 y13 y11) (y-minus-2 y14 y12) (y-minus-2 y15 y13) (y-minus-2 y16 y14) (y-minus-2 y17 y15) (y-minus-2 y18 y16) (y-minus-2 y19 y17) (y-minus-2 y20 y18) (y-minus-2 y21 y19) (y-minus-2 y22 y20) (y-minus-2 y23 y21) (y-minus-2 y24 y22) (y-minus-2 y25 y23) (y-minus-2 y26 y24) (y-minus-2 y27 y25) (y-minus-2 y28 y26) (y-minus-2 y29 y27) (y-minus-2 y30 y28)
    (y-minus-1 y01 y00) (y-minus-1 y02 y01) (y-minus-1 y03 y02) (y-minus-1 y04 y03) (y-minus-1 y05 y04) (y-minus-1 y06 y05) (y-minus-1 y07 y06) (y-minus-1 y08 y07) (y-minus-1 y09 y08) (y-minus-1 y10 y09) (y-minus-1 y11 y10) (y-minus-1 y12 y11) (y-minus-1 y13 y12) (y-minus-1 y14 y13) (y-minus-1 y15 y14) (y-minus-1 y16 y15) (y-minus-1 y17 y16) (y-minus-1 y18 y17) (y-minus-1 y19 y18) (y-minus-1 y20 y19) (y-minus-1 y21 y20) (y-minus-1 y22 y21) (y-minus-1 y23 y22) (y-minus-1 y24 y23) (y-minus-1 y25 y24) (y-minus-1 y26 y25) (y-minus-1 y27 y26) (y-minus-1 y28 y27) (y-minus-1 y29 y28) (y-minus-1 y30 y29)
    (y-plus-3 y00 y03) (y-plus-3 y01 y04) (y-plus-3 y02 y05) (y-plus-3 y03 y06) (y-plus-3 y04 y07) (y-plus-3 y05 y08) (y-plus-3 y06 y09) (y-plus-3 y07 y10) (y-plus-3 y08 y11) (y-plus-3 y09 y12) (y-plus-3 y10 y13) (y-plus-3 y11 y14) (y-plus-3 y12 y15) (y-plus-3 y13 y16) (y-plus-3 y14 y17) (y-plus-3 y15 y18) (y-plus-3 y16 y19) (y-plus-3 y17 y20) (y-plus-3 y18 y21) (y-plus-3 y19 y22) (y-plus-3 y20 y23) (y-plus-3 y21 y24) (y-plus-3 y22 y25) (y-plus-3 y23 y26) (y-plus-3 y24 y27) (y-plus-3 y25 y28) (y-plus-3 y26 y29) (y-plus-3 y27 y30)
    (y-plus-4 y00 y04) (y-plus-4 y01 y05) (y-plus-4 y02 y06) (y-plus-4 y03 y07) (y-plus-4 y04 y08) (y-plus-4 y05 y09) (y-plus-4 y06 y10) (y-plus-4 y07 y11) (y-plus-4 y08 y12) (y-plus-4 y09 y13) (y-plus-4 y10 y14) (y-plus-4 y11 y15) (y-plus-4 y12 y16) (y-plus-4 y13 y17) (y-plus-4 y14 y18) (y-plus-4 y15 y19) (y-plus-4 y16 y20) (y-plus-4 y17 y21) (y-plus-4 y18 y22) (y-plus-4 y19 y23) (y-plus-4 y20 y24) (y-plus-4 y21 y25) (y-plus-4 y22 y26) (y-plus-4 y23 y27) (y-plus-4 y24 y28) (y-plus-4 y25 y29) (y-plus-4 y26 y30)
    (z-minus-10 z10 z00)
    (z-plus-10 z00 z10))
  (:goal (and (done item-01) (done item-02)))
  (:metric minimize (total-cost)))
