; Problem crowded-4-17 of the learned domain places, with places.
; How it came about: crowded, drawn with seed 18; draw 1.
; A place starting with start- is where an object stands at first, goal- one that meets a goal,
; park- one to wait at. room names the places that must be free for an object, one after
; another; look-on notes that one is. can names what carries an object, at which cost.
(define (problem crowded-4-17)
  (:domain places-places)
  (:objects
    item-01 - solid-low-10
    item-02 - solid-low-10
    item-03 - hollow-wide-00
    item-04 - hollow-wide-00
    start-item-01 start-item-02 start-item-03 start-item-04 goal-item-01 goal-item-02 goal-item-03 goal-item-04 park-01 park-02 park-03 park-04 - place)
  (:init
    (hand-empty) (ready) (= (total-cost) 0)
    (stands item-01 start-item-01)
    (stands item-02 start-item-02)
    (stands item-03 start-item-03)
    (stands item-04 start-item-04)
    ; goal-item-01 lies at (0.9112, 0.1574) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (room item-01 goal-item-01 nowhere)
    ; goal-item-02 lies at (0.7536, 0.1250) m
    (free goal-item-02)
    (goal-place item-02 goal-item-02) (room item-02 goal-item-02 nowhere)
    ; goal-item-03 lies at (0.6539, -0.2229) m
    (free goal-item-03)
    (goal-place item-03 goal-item-03) (room item-03 goal-item-03 nowhere)
    ; goal-item-04 lies at (0.5849, -0.0183) m
    (free goal-item-04)
    (goal-place item-04 goal-item-04) (room item-04 goal-item-04 start-item-01) (look-next item-04 goal-item-04 start-item-01 start-item-03) (look-next item-04 goal-item-04 start-item-03 nowhere)
    ; park-01 lies at (0.4367, -0.2088) m
    (free park-01)
    (room item-01 park-01 nowhere)
    (room item-02 park-01 nowhere)
    (room item-03 park-01 nowhere)
    (room item-04 park-01 nowhere)
    ; park-02 lies at (0.6223, 0.1964) m
    (free park-02)
    (room item-01 park-02 nowhere)
    (room item-02 park-02 nowhere)
    (room item-03 park-02 nowhere)
    (room item-04 park-02 start-item-01) (look-next item-04 park-02 start-item-01 start-item-02) (look-next item-04 park-02 start-item-02 nowhere)
    ; park-03 lies at (0.4245, 0.1571) m
    (free park-03)
    (room item-01 park-03 nowhere)
    (room item-02 park-03 nowhere)
    (room item-03 park-03 nowhere)
    ; park-04 lies at (0.4223, -0.0583) m
    (free park-04)
    (room item-01 park-04 nowhere)
    (can a-carry-to-111b-solid-low-10 item-01) (= (cost-of-carry-to-111b-solid-low-10 item-01) 11)
    (= (cost-of-carry-to-010-solid-low-10 item-01) 281)
    (= (cost-of-carry-to-011c-solid-low-10 item-01) 14)
    (= (cost-of-carry-to-100-solid-low-10 item-01) 14)
    (= (cost-of-carry-to-101-solid-low-10 item-01) 190)
    (= (cost-of-carry-to-110-solid-low-10 item-01) 281)
    (can a-carry-to-100-solid-low-10 item-02) (= (cost-of-carry-to-100-solid-low-10 item-02) 11)
    (= (cost-of-carry-to-010-solid-low-10 item-02) 281)
    (= (cost-of-carry-to-011c-solid-low-10 item-02) 14)
    (= (cost-of-carry-to-101-solid-low-10 item-02) 190)
    (= (cost-of-carry-to-110-solid-low-10 item-02) 281)
    (= (cost-of-carry-to-111b-solid-low-10 item-02) 11)
    (can a-carry-to-001a-hollow-wide-00 item-03) (= (cost-of-carry-to-001a-hollow-wide-00 item-03) 4)
    (= (cost-of-carry-to-010a-hollow-wide-00 item-03) 26)
    (= (cost-of-carry-to-011a-hollow-wide-00 item-03) 4)
    (= (cost-of-carry-to-100a-hollow-wide-00 item-03) 4)
    (= (cost-of-carry-to-101a-hollow-wide-00 item-03) 11)
    (= (cost-of-carry-to-110a-hollow-wide-00 item-03) 14)
    (= (cost-of-carry-to-111a-hollow-wide-00 item-03) 7)
    (can a-carry-to-001a-hollow-wide-00 item-04) (= (cost-of-carry-to-001a-hollow-wide-00 item-04) 4)
    (= (cost-of-carry-to-010a-hollow-wide-00 item-04) 26)
    (= (cost-of-carry-to-011a-hollow-wide-00 item-04) 4)
    (= (cost-of-carry-to-100a-hollow-wide-00 item-04) 4)
    (= (cost-of-carry-to-101a-hollow-wide-00 item-04) 11)
    (= (cost-of-carry-to-110a-hollow-wide-00 item-04) 34)
    (= (cost-of-carry-to-111a-hollow-wide-00 item-04) 278))
  (:goal (and (done item-01) (done item-02) (done item-03) (done item-04)))
  (:metric minimize (total-cost)))
