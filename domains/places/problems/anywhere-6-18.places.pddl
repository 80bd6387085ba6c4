; Problem anywhere-6-18 of the learned domain places, with places.
; How it came about: anywhere, drawn with seed 19; draw 1.
; A place starting with start- is where an object stands at first, goal- one that meets a goal,
; park- one to wait at. room names the places that must be free for an object, one after
; another; look-on notes that one is. can names what carries an object, at which cost.
(define (problem anywhere-6-18)
  (:domain places-places)
  (:objects
    item-01 - solid-low-narrow-01
    item-02 - solid-low-10
    item-03 - hollow-wide-00
    item-04 - hollow-wide-00
    item-05 - solid-low-10
    item-06 - solid-low-narrow-01
    start-item-01 start-item-02 start-item-03 start-item-04 start-item-05 start-item-06 goal-item-01 goal-item-02 goal-item-03 goal-item-04 goal-item-05 goal-item-06 park-01 park-02 park-03 park-04 park-05 park-06 - place)
  (:init
    (hand-empty) (ready) (= (total-cost) 0)
    (stands item-01 start-item-01)
    (stands item-02 start-item-02)
    (stands item-03 start-item-03)
    (stands item-04 start-item-04)
    (stands item-05 start-item-05)
    (stands item-06 start-item-06)
    ; goal-item-01 lies at (0.4767, -0.2162) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (room item-01 goal-item-01 nowhere)
    ; goal-item-02 lies at (0.5806, -0.0884) m
    (free goal-item-02)
    (goal-place item-02 goal-item-02) (room item-02 goal-item-02 start-item-01) (look-next item-02 goal-item-02 start-item-01 nowhere)
    ; goal-item-03 lies at (0.8505, -0.0270) m
    (free goal-item-03)
    (goal-place item-03 goal-item-03) (room item-03 goal-item-03 start-item-02) (look-next item-03 goal-item-03 start-item-02 nowhere)
    ; goal-item-04 lies at (0.5068, 0.1711) m
    (free goal-item-04)
    (goal-place item-04 goal-item-04) (room item-04 goal-item-04 start-item-03) (look-next item-04 goal-item-04 start-item-03 nowhere)
    ; goal-item-05 lies at (0.6502, -0.1482) m
    (free goal-item-05)
    (goal-place item-05 goal-item-05) (room item-05 goal-item-05 start-item-01) (look-next item-05 goal-item-05 start-item-01 nowhere)
    ; goal-item-06 lies at (0.8176, -0.1915) m
    (free goal-item-06)
    (goal-place item-06 goal-item-06) (room item-06 goal-item-06 start-item-02) (look-next item-06 goal-item-06 start-item-02 start-item-05) (look-next item-06 goal-item-06 start-item-05 nowhere)
    ; park-01 lies at (0.8403, 0.1840) m
    (free park-01)
    (room item-01 park-01 nowhere)
    (room item-02 park-01 nowhere)
    (room item-03 park-01 nowhere)
    (room item-04 park-01 nowhere)
    (room item-05 park-01 nowhere)
    (room item-06 park-01 nowhere)
    ; park-02 lies at (0.7100, -0.0600) m
    (free park-02)
    (room item-02 park-02 nowhere)
    (room item-05 park-02 nowhere)
    ; park-03 lies at (0.6499, -0.0385) m
    (free park-03)
    ; park-04 lies at (0.7125, 0.2552) m
    (free park-04)
    (room item-02 park-04 start-item-06) (look-next item-02 park-04 start-item-06 nowhere)
    (room item-05 park-04 start-item-06) (look-next item-05 park-04 start-item-06 nowhere)
    ; park-05 lies at (0.7095, -0.2431) m
    (free park-05)
    (room item-01 park-05 nowhere)
    (room item-02 park-05 nowhere)
    (room item-05 park-05 nowhere)
    (room item-06 park-05 nowhere)
    ; park-06 lies at (0.6948, 0.0279) m
    (free park-06)
    (can a-carry-to-100-solid-low-narrow-01 item-01) (= (cost-of-carry-to-100-solid-low-narrow-01 item-01) 4)
    (= (cost-of-carry-to-001b-solid-low-narrow-01 item-01) 7)
    (= (cost-of-carry-to-010-solid-low-narrow-01 item-01) 238)
    (= (cost-of-carry-to-011b-solid-low-narrow-01 item-01) 4)
    (= (cost-of-carry-to-101b-solid-low-narrow-01 item-01) 4)
    (= (cost-of-carry-to-110-solid-low-narrow-01 item-01) 4)
    (= (cost-of-carry-to-111-solid-low-narrow-01 item-01) 4)
    (can a-carry-to-100-solid-low-10 item-02) (= (cost-of-carry-to-100-solid-low-10 item-02) 11)
    (= (cost-of-carry-to-010-solid-low-10 item-02) 281)
    (= (cost-of-carry-to-011c-solid-low-10 item-02) 11)
    (= (cost-of-carry-to-101-solid-low-10 item-02) 190)
    (= (cost-of-carry-to-110-solid-low-10 item-02) 281)
    (= (cost-of-carry-to-111b-solid-low-10 item-02) 11)
    (can a-carry-to-001a-hollow-wide-00 item-03) (= (cost-of-carry-to-001a-hollow-wide-00 item-03) 4)
    (= (cost-of-carry-to-010a-hollow-wide-00 item-03) 26)
    (= (cost-of-carry-to-011a-hollow-wide-00 item-03) 4)
    (= (cost-of-carry-to-100a-hollow-wide-00 item-03) 4)
    (= (cost-of-carry-to-101a-hollow-wide-00 item-03) 11)
    (= (cost-of-carry-to-110a-hollow-wide-00 item-03) 4)
    (= (cost-of-carry-to-111a-hollow-wide-00 item-03) 84)
    (can a-carry-to-001a-hollow-wide-00 item-04) (= (cost-of-carry-to-001a-hollow-wide-00 item-04) 4)
    (= (cost-of-carry-to-010a-hollow-wide-00 item-04) 26)
    (= (cost-of-carry-to-011a-hollow-wide-00 item-04) 4)
    (= (cost-of-carry-to-100a-hollow-wide-00 item-04) 4)
    (= (cost-of-carry-to-101a-hollow-wide-00 item-04) 11)
    (= (cost-of-carry-to-110a-hollow-wide-00 item-04) 59)
    (= (cost-of-carry-to-111a-hollow-wide-00 item-04) 238)
    (can a-carry-to-100-solid-low-10 item-05) (= (cost-of-carry-to-100-solid-low-10 item-05) 7)
    (= (cost-of-carry-to-010-solid-low-10 item-05) 281)
    (= (cost-of-carry-to-011c-solid-low-10 item-05) 11)
    (= (cost-of-carry-to-101-solid-low-10 item-05) 190)
    (= (cost-of-carry-to-110-solid-low-10 item-05) 281)
    (= (cost-of-carry-to-111b-solid-low-10 item-05) 11)
    (can a-carry-to-100-solid-low-narrow-01 item-06) (= (cost-of-carry-to-100-solid-low-narrow-01 item-06) 4)
    (= (cost-of-carry-to-001b-solid-low-narrow-01 item-06) 7)
    (= (cost-of-carry-to-010-solid-low-narrow-01 item-06) 11)
    (= (cost-of-carry-to-011b-solid-low-narrow-01 item-06) 4)
    (= (cost-of-carry-to-101b-solid-low-narrow-01 item-06) 4)
    (= (cost-of-carry-to-110-solid-low-narrow-01 item-06) 4)
    (= (cost-of-carry-to-111-solid-low-narrow-01 item-06) 4))
  (:goal (and (done item-01) (done item-02) (done item-03) (done item-04) (done item-05) (done item-06)))
  (:metric minimize (total-cost)))
