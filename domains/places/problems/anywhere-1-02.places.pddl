; Problem anywhere-1-02 of the learned domain tabletop, for its encodings on a grid.
; How it came about: anywhere, drawn with seed 3; draw 1.
; A goal is met within 50 mm. goal-xy and goal-z list the cells from
; which it is met whatever the grid rounds on the way, in plans of at most
; 1 step(s) and cells of 5 mm.
(define (problem anywhere-1-02)
  (:domain tabletop)
  (:objects
    item-01 - solid-low-narrow-01
    start-item-01 goal-item-01 park-01 - place)
  (:init
    (hand-empty) (ready) (= (total-cost) 0)
    (stands item-01 start-item-01)
    ; goal-item-01 lies at (0.4576, 0.0660) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (room item-01 goal-item-01 nowhere)
    ; park-01 lies at (0.4489, -0.2371) m
    (free park-01)
    (room item-01 park-01 nowhere)
    (can a-carry-to-101b-solid-low-narrow-01 item-01) (= (cost-of-carry-to-101b-solid-low-narrow-01 item-01) 4)
    (= (cost-of-carry-to-001b-solid-low-narrow-01 item-01) 4)
    (= (cost-of-carry-to-010b-solid-low-narrow-01 item-01) 4)
    (= (cost-of-carry-to-011b-solid-low-narrow-01 item-01) 4)
    (= (cost-of-carry-to-100b-solid-low-narrow-01 item-01) 4)
    (= (cost-of-carry-to-110-solid-low-narrow-01 item-01) 4)
    (= (cost-of-carry-to-111-solid-low-narrow-01 item-01) 4))
  (:goal (and (done item-01)))
  (:metric minimize (total-cost)))
