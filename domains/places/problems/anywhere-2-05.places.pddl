; Problem anywhere-2-05 of the learned domain places, with places.
; How it came about: anywhere, drawn with seed 6; draw 1.
; A place starting with start- is where an object stands at first, goal- one that meets a goal,
; park- one to wait at. room names the places that must be free for an object, one after
; another; look-on notes that one is. can names what carries an object, at which cost.
(define (problem anywhere-2-05)
  (:domain places-places)
  (:objects
    item-01 - solid-low-narrow-01
    item-02 - solid-low-10
    start-item-01 start-item-02 goal-item-01 goal-item-02 park-01 park-02 - place)
  (:init
    (hand-empty) (ready) (= (total-cost) 0)
    (stands item-01 start-item-01)
    (stands item-02 start-item-02)
    ; goal-item-01 lies at (0.8196, 0.2533) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (room item-01 goal-item-01 nowhere)
    ; goal-item-02 lies at (0.7031, 0.0866) m
    (free goal-item-02)
    (goal-place item-02 goal-item-02) (room item-02 goal-item-02 nowhere)
    ; park-01 lies at (0.4421, -0.2114) m
    (free park-01)
    (room item-01 park-01 nowhere)
    (room item-02 park-01 nowhere)
    ; park-02 lies at (0.7930, -0.2174) m
    (free park-02)
    (room item-01 park-02 nowhere)
    (room item-02 park-02 nowhere)
    (can a-carry-to-100-solid-low-narrow-01 item-01) (= (cost-of-carry-to-100-solid-low-narrow-01 item-01) 4)
    (= (cost-of-carry-to-001b-solid-low-narrow-01 item-01) 7)
    (= (cost-of-carry-to-010-solid-low-narrow-01 item-01) 11)
    (= (cost-of-carry-to-011b-solid-low-narrow-01 item-01) 4)
    (= (cost-of-carry-to-101b-solid-low-narrow-01 item-01) 4)
    (= (cost-of-carry-to-110-solid-low-narrow-01 item-01) 4)
    (= (cost-of-carry-to-111-solid-low-narrow-01 item-01) 4)
    (can a-carry-to-100-solid-low-10 item-02) (= (cost-of-carry-to-100-solid-low-10 item-02) 7)
    (= (cost-of-carry-to-010-solid-low-10 item-02) 281)
    (= (cost-of-carry-to-011c-solid-low-10 item-02) 14)
    (= (cost-of-carry-to-101-solid-low-10 item-02) 190)
    (= (cost-of-carry-to-110-solid-low-10 item-02) 281)
    (= (cost-of-carry-to-111b-solid-low-10 item-02) 11))
  (:goal (and (done item-01) (done item-02)))
  (:metric minimize (total-cost)))
