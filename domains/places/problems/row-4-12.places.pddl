; Problem row-4-12 of the learned domain places, with places.
; How it came about: row, drawn with seed 13; draw 1.
; A place starting with start- is where an object stands at first, goal- one that meets a goal,
; park- one to wait at. room names the places that must be free for an object, one after
; another; look-on notes that one is. can names what carries an object, at which cost.
(define (problem row-4-12)
  (:domain places-places)
  (:objects
    item-01 - hollow-wide-00
    item-02 - any-tall-narrow-11
    item-03 - solid-low-narrow-01
    item-04 - hollow-wide-00
    start-item-01 start-item-02 start-item-03 start-item-04 goal-item-01 goal-item-02 goal-item-03 goal-item-04 park-01 park-02 park-03 park-04 - place)
  (:init
    (hand-empty) (ready) (= (total-cost) 0)
    (stands item-01 start-item-01)
    (stands item-02 start-item-02)
    (stands item-03 start-item-03)
    (stands item-04 start-item-04)
    ; goal-item-01 lies at (0.6500, -0.2047) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (room item-01 goal-item-01 start-item-02) (look-next item-01 goal-item-01 start-item-02 nowhere)
    ; goal-item-02 lies at (0.6500, -0.0361) m
    (free goal-item-02)
    (goal-place item-02 goal-item-02) (room item-02 goal-item-02 start-item-03) (look-next item-02 goal-item-02 start-item-03 nowhere)
    ; goal-item-03 lies at (0.6500, 0.0623) m
    (free goal-item-03)
    (goal-place item-03 goal-item-03) (room item-03 goal-item-03 nowhere)
    ; goal-item-04 lies at (0.6500, 0.2105) m
    (free goal-item-04)
    (goal-place item-04 goal-item-04) (room item-04 goal-item-04 nowhere)
    ; park-01 lies at (0.8419, 0.1856) m
    (free park-01)
    (room item-01 park-01 nowhere)
    (room item-02 park-01 nowhere)
    (room item-03 park-01 nowhere)
    (room item-04 park-01 nowhere)
    ; park-02 lies at (0.4703, 0.1879) m
    (free park-02)
    (room item-01 park-02 nowhere)
    (room item-02 park-02 nowhere)
    (room item-03 park-02 nowhere)
    (room item-04 park-02 nowhere)
    ; park-03 lies at (0.8358, -0.1914) m
    (free park-03)
    (room item-01 park-03 nowhere)
    (room item-02 park-03 nowhere)
    (room item-03 park-03 nowhere)
    (room item-04 park-03 nowhere)
    ; park-04 lies at (0.4625, -0.2162) m
    (free park-04)
    (room item-01 park-04 nowhere)
    (room item-02 park-04 nowhere)
    (room item-03 park-04 nowhere)
    (room item-04 park-04 nowhere)
    (can a-carry-to-001a-hollow-wide-00 item-01) (= (cost-of-carry-to-001a-hollow-wide-00 item-01) 4)
    (= (cost-of-carry-to-010a-hollow-wide-00 item-01) 26)
    (= (cost-of-carry-to-011a-hollow-wide-00 item-01) 4)
    (= (cost-of-carry-to-100a-hollow-wide-00 item-01) 4)
    (= (cost-of-carry-to-101a-hollow-wide-00 item-01) 11)
    (= (cost-of-carry-to-110a-hollow-wide-00 item-01) 4)
    (= (cost-of-carry-to-111a-hollow-wide-00 item-01) 238)
    (can a-carry-to-011d-any-tall-narrow-11 item-02) (= (cost-of-carry-to-011d-any-tall-narrow-11 item-02) 4)
    (= (cost-of-carry-to-001a-any-tall-narrow-11 item-02) 7)
    (= (cost-of-carry-to-010b-any-tall-narrow-11 item-02) 53)
    (= (cost-of-carry-to-100-any-tall-narrow-11 item-02) 4)
    (= (cost-of-carry-to-101-any-tall-narrow-11 item-02) 43)
    (= (cost-of-carry-to-110b-any-tall-narrow-11 item-02) 7)
    (= (cost-of-carry-to-111c-any-tall-narrow-11 item-02) 4)
    (can a-carry-to-100-solid-low-narrow-01 item-03) (= (cost-of-carry-to-100-solid-low-narrow-01 item-03) 4)
    (= (cost-of-carry-to-001b-solid-low-narrow-01 item-03) 7)
    (= (cost-of-carry-to-010-solid-low-narrow-01 item-03) 11)
    (= (cost-of-carry-to-011b-solid-low-narrow-01 item-03) 4)
    (= (cost-of-carry-to-101b-solid-low-narrow-01 item-03) 4)
    (= (cost-of-carry-to-110-solid-low-narrow-01 item-03) 4)
    (= (cost-of-carry-to-111-solid-low-narrow-01 item-03) 4)
    (can a-carry-to-001a-hollow-wide-00 item-04) (= (cost-of-carry-to-001a-hollow-wide-00 item-04) 4)
    (= (cost-of-carry-to-010a-hollow-wide-00 item-04) 26)
    (= (cost-of-carry-to-011a-hollow-wide-00 item-04) 4)
    (= (cost-of-carry-to-100a-hollow-wide-00 item-04) 4)
    (= (cost-of-carry-to-101a-hollow-wide-00 item-04) 11)
    (= (cost-of-carry-to-110a-hollow-wide-00 item-04) 38)
    (= (cost-of-carry-to-111a-hollow-wide-00 item-04) 7))
  (:goal (and (done item-01) (done item-02) (done item-03) (done item-04)))
  (:metric minimize (total-cost)))
