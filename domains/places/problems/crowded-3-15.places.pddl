; Problem crowded-3-15 of the learned domain places, with places.
; How it came about: crowded, drawn with seed 16; draw 1.
; A place starting with start- is where an object stands at first, goal- one that meets a goal,
; park- one to wait at. room names the places that must be free for an object, one after
; another; look-on notes that one is. can names what carries an object, at which cost.
(define (problem crowded-3-15)
  (:domain places-places)
  (:objects
    item-01 - any-tall-narrow-11
    item-02 - solid-low-narrow-01
    item-03 - any-tall-narrow-11
    start-item-01 start-item-02 start-item-03 goal-item-01 goal-item-02 goal-item-03 park-01 park-02 park-03 - place)
  (:init
    (hand-empty) (ready) (= (total-cost) 0)
    (stands item-01 start-item-01)
    (stands item-02 start-item-02)
    (stands item-03 start-item-03)
    ; goal-item-01 lies at (0.7035, -0.1680) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (room item-01 goal-item-01 nowhere)
    ; goal-item-02 lies at (0.4335, -0.1094) m
    (free goal-item-02)
    (goal-place item-02 goal-item-02) (room item-02 goal-item-02 nowhere)
    ; goal-item-03 lies at (0.4585, 0.0880) m
    (free goal-item-03)
    (goal-place item-03 goal-item-03) (room item-03 goal-item-03 nowhere)
    ; park-01 lies at (0.4608, -0.2153) m
    (free park-01)
    (room item-01 park-01 nowhere)
    (room item-02 park-01 nowhere)
    (room item-03 park-01 nowhere)
    ; park-02 lies at (0.6053, 0.1738) m
    (free park-02)
    (room item-01 park-02 nowhere)
    (room item-02 park-02 nowhere)
    (room item-03 park-02 nowhere)
    ; park-03 lies at (0.6500, -0.0333) m
    (free park-03)
    (room item-01 park-03 nowhere)
    (room item-02 park-03 nowhere)
    (room item-03 park-03 nowhere)
    (can a-carry-to-011d-any-tall-narrow-11 item-01) (= (cost-of-carry-to-011d-any-tall-narrow-11 item-01) 4)
    (= (cost-of-carry-to-001a-any-tall-narrow-11 item-01) 7)
    (= (cost-of-carry-to-010b-any-tall-narrow-11 item-01) 7)
    (= (cost-of-carry-to-100-any-tall-narrow-11 item-01) 4)
    (= (cost-of-carry-to-101-any-tall-narrow-11 item-01) 7)
    (= (cost-of-carry-to-110b-any-tall-narrow-11 item-01) 7)
    (= (cost-of-carry-to-111c-any-tall-narrow-11 item-01) 4)
    (can a-carry-to-100-solid-low-narrow-01 item-02) (= (cost-of-carry-to-100-solid-low-narrow-01 item-02) 4)
    (= (cost-of-carry-to-001b-solid-low-narrow-01 item-02) 7)
    (= (cost-of-carry-to-010-solid-low-narrow-01 item-02) 7)
    (= (cost-of-carry-to-011b-solid-low-narrow-01 item-02) 4)
    (= (cost-of-carry-to-101b-solid-low-narrow-01 item-02) 4)
    (= (cost-of-carry-to-110-solid-low-narrow-01 item-02) 4)
    (= (cost-of-carry-to-111-solid-low-narrow-01 item-02) 4)
    (can a-carry-to-011d-any-tall-narrow-11 item-03) (= (cost-of-carry-to-011d-any-tall-narrow-11 item-03) 4)
    (= (cost-of-carry-to-001a-any-tall-narrow-11 item-03) 187)
    (= (cost-of-carry-to-010b-any-tall-narrow-11 item-03) 209)
    (= (cost-of-carry-to-100-any-tall-narrow-11 item-03) 4)
    (= (cost-of-carry-to-101-any-tall-narrow-11 item-03) 26)
    (= (cost-of-carry-to-110b-any-tall-narrow-11 item-03) 187)
    (= (cost-of-carry-to-111c-any-tall-narrow-11 item-03) 4))
  (:goal (and (done item-01) (done item-02) (done item-03)))
  (:metric minimize (total-cost)))
