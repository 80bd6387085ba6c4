; Problem mixed of the learned domain toy, with places.
; How it came about: by hand.
; A place starting with start- is where an object stands at first, goal- one that meets a goal,
; park- one to wait at. room names the places that must be free for an object, one after
; another; look-on notes that one is. can names what carries an object, at which cost.
; A goal is met within 20 mm. goal-xy and goal-z list the cells from
; which it is met whatever the grid rounds on the way, in plans of at most
; 1 step(s) and cells of 20 mm.
(define (problem mixed)
  (:domain toy-places)
  (:objects
    item-01 - cube
    item-02 - slab
    start-item-01 start-item-02 goal-item-01 goal-item-02 park-01 park-02 - place
    x00 x01 x02 x03 x04 x05 x06 x07 x08 x09 x10 x11 x12 x13 x14 x15 x16 x17 x18 x19 x20 x21 x22 x23 x24 x25 x26 x27 x28 x29 x30 - x-cell
    y00 y01 y02 y03 y04 y05 y06 y07 y08 y09 y10 y11 y12 y13 y14 y15 y16 y17 y18 y19 y20 y21 y22 y23 y24 y25 y26 y27 y28 y29 y30 - y-cell
    z00 - z-cell
    x-plus-0 - x-step
    y-plus-0 - y-step)
  (:init
    (hand-empty) (ready) (= (total-cost) 0)
    (stands item-01 start-item-01)
    (stands item-02 start-item-02) (led item-02)
    ; goal-item-01 lies at (0.7000, 0.0000) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (room item-01 goal-item-01 start-item-02) (look-next item-01 goal-item-01 start-item-02 nowhere)
    ; goal-item-02 lies at (0.7000, 0.1600) m
    (free goal-item-02)
    ; park-01 lies at (0.8598, 0.1816) m
    (free park-01)
    (room item-01 park-01 nowhere)
    ; park-02 lies at (0.8611, -0.2188) m
    (free park-02)
    (room item-01 park-02 nowhere)
    (can a-carry-to-01-cube item-01) (= (cost-of-carry-to-01-cube item-01) 6)
    ; item-02 starts at (0.7000, 0.0000, 0.0250) m
    (at-x item-02 x15) (at-y item-02 y15) (at-z item-02 z00)
    ; item-02 shall come to (0.7000, 0.1600, 0.0250) m, 160 mm from where it starts
    (goal-xy item-02 x14 y23)
    (goal-xy item-02 x15 y22) (goal-xy item-02 x15 y23) (goal-xy item-02 x15 y24)
    (goal-xy item-02 x16 y23)
    (goal-z item-02 z00)
    ; What each operator promises for item-02 (features 0.05 0.12 0.05 0).
    (can a-push-forward-010-slab item-02) (= (cost-of-push-forward-010-slab item-02) 6) (x-of a-push-forward-010-slab item-02 x-plus-4) (y-of a-push-forward-010-slab item-02 y-plus-0)
    (can a-push-left-001-slab item-02) (= (cost-of-push-left-001-slab item-02) 6) (x-of a-push-left-001-slab item-02 x-plus-0) (y-of a-push-left-001-slab item-02 y-plus-4)
    (x-leads x-plus-0 x00 x00) (x-leads x-plus-0 x01 x01) (x-leads x-plus-0 x02 x02) (x-leads x-plus-0 x03 x03) (x-leads x-plus-0 x04 x04) (x-leads x-plus-0 x05 x05) (x-leads x-plus-0 x06 x06) (x-leads x-plus-0 x07 x07) (x-leads x-plus-0 x08 x08) (x-leads x-plus-0 x09 x09) (x-leads x-plus-0 x10 x10) (x-leads x-plus-0 x11 x11) (x-leads x-plus-0 x12 x12) (x-leads x-plus-0 x13 x13) (x-leads x-plus-0 x14 x14) (x-leads x-plus-0 x15 x15) (x-leads x-plus-0 x16 x16) (x-leads x-plus-0 x17 x17) (x-leads x-plus-0 x18 x18) (x-leads x-plus-0 x19 x19) (x-leads x-plus-0 x20 x20) (x-leads x-plus-0 x21 x21) (x-leads x-plus-0 x22 x22) (x-leads x-plus-0 x23 x23) (x-leads x-plus-0 x24 x24) (x-leads x-plus-0 x25 x25) (x-leads x-plus-0 x26 x26) (x-leads x-plus-0 x27 x27) (x-leads x-plus-0 x28 x28) (x-leads x-plus-0 x29 x29) (x-leads x-plus-0 x30 x30)
    (x-leads x-plus-4 x00 x04) (x-leads x-plus-4 x01 x05) (x-leads x-plus-4 x02 x06) (x-leads x-plus-4 x03 x07) (x-leads x-plus-4 x04 x08) (x-leads x-plus-4 x05 x09) (x-leads x-plus-4 x06 x10) (x-leads x-plus-4 x07 x11) (x-leads x-plus-4 x08 x12) (x-leads x-plus-4 x09 x13) (x-leads x-plus-4 x10 x14) (x-leads x-plus-4 x11 x15) (x-leads x-plus-4 x12 x16) (x-leads x-plus-4 x13 x17) (x-leads x-plus-4 x14 x18) (x-leads x-plus-4 x15 x19) (x-leads x-plus-4 x16 x20) (x-leads x-plus-4 x17 x21) (x-leads x-plus-4 x18 x22) (x-leads x-plus-4 x19 x23) (x-leads x-plus-4 x20 x24) (x-leads x-plus-4 x21 x25) (x-leads x-plus-4 x22 x26) (x-leads x-plus-4 x23 x27) (x-leads x-plus-4 x24 x28) (x-leads x-plus-4 x25 x29) (x-leads x-plus-4 x26 x30)
    (y-leads y-plus-0 y00 y00) (y-leads y-plus-0 y01 y01) (y-leads y-plus-0 y02 y02) (y-leads y-plus-0 y03 y03) (y-leads y-plus-0 y04 y04) (y-leads y-plus-0 y05 y05) (y-leads y-plus-0 y06 y06) (y-leads y-plus-0 y07 y07) (y-leads y-plus-0 y08 y08) (y-leads y-plus-0 y09 y09) (y-leads y-plus-0 y10 y10) (y-leads y-plus-0 y11 y11) (y-leads y-plus-0 y12 y12) (y-leads y-plus-0 y13 y13) (y-leads y-plus-0 y14 y14) (y-leads y-plus-0 y15 y15) (y-leads y-plus-0 y16 y16) (y-leads y-plus-0 y17 y17) (y-leads y-plus-0 y18 y18) (y-leads y-plus-0 y19 y19) (y-leads y-plus-0 y20 y20) (y-leads y-plus-0 y21 y21) (y-leads y-plus-0 y22 y22) (y-leads y-plus-0 y23 y23) (y-leads y-plus-0 y24 y24) (y-leads y-plus-0 y25 y25) (y-leads y-plus-0 y26 y26) (y-leads y-plus-0 y27 y27) (y-leads y-plus-0 y28 y28) (y-leads y-plus-0 y29 y29) (y-leads y-plus-0 y30 y30)
    (y-leads y-plus-4 y00 y04) (y-leads y-plus-4 y01 y05) (y-leads y-plus-4 y02 y06) (y-leads y-plus-4 y03 y07) (y-leads y-plus-4 y04 y08) (y-leads y-plus-4 y05 y09) (y-leads y-plus-4 y06 y10) (y-leads y-plus-4 y07 y11) (y-leads y-plus-4 y08 y12) (y-leads y-plus-4 y09 y13) (y-leads y-plus-4 y10 y14) (y-leads y-plus-4 y11 y15) (y-leads y-plus-4 y12 y16) (y-leads y-plus-4 y13 y17) (y-leads y-plus-4 y14 y18) (y-leads y-plus-4 y15 y19) (y-leads y-plus-4 y16 y20) (y-leads y-plus-4 y17 y21) (y-leads y-plus-4 y18 y22) (y-leads y-plus-4 y19 y23) (y-leads y-plus-4 y20 y24) (y-leads y-plus-4 y21 y25) (y-leads y-plus-4 y22 y26) (y-leads y-plus-4 y23 y27) (y-leads y-plus-4 y24 y28) (y-leads y-plus-4 y25 y29) (y-leads y-plus-4 y26 y30))
  (:goal (and (done item-01) (done item-02)))
  (:metric minimize (total-cost)))
