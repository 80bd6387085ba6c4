; Problem swap-3-09 of the learned domain places, with places.
; How it came about: swap, drawn with seed 10; draw 1.
; A place starting with start- is where an object stands at first, goal- one that meets a goal,
; park- one to wait at. room names the places that must be free for an object, one after
; another; look-on notes that one is. can names what carries an object, at which cost.
(define (problem swap-3-09)
  (:domain places-places)
  (:objects
    item-01 - hollow-wide-00
    item-02 - any-tall-narrow-11
    item-03 - solid-low-10
    start-item-01 start-item-02 start-item-03 goal-item-01 goal-item-02 goal-item-03 park-01 park-02 park-03 - place)
  (:init
    (hand-empty) (ready) (= (total-cost) 0)
    (stands item-01 start-item-01)
    (stands item-02 start-item-02)
    (stands item-03 start-item-03)
    ; goal-item-01 lies at (0.5765, 0.0382) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (room item-01 goal-item-01 start-item-02) (look-next item-01 goal-item-01 start-item-02 nowhere)
    ; goal-item-02 lies at (0.7821, -0.2160) m
    (free goal-item-02)
    (goal-place item-02 goal-item-02) (room item-02 goal-item-02 start-item-03) (look-next item-02 goal-item-02 start-item-03 nowhere)
    ; goal-item-03 lies at (0.6303, -0.1358) m
    (free goal-item-03)
    (goal-place item-03 goal-item-03) (room item-03 goal-item-03 start-item-01) (look-next item-03 goal-item-03 start-item-01 nowhere)
    ; park-01 lies at (0.7812, 0.1757) m
    (free park-01)
    (room item-01 park-01 nowhere)
    (room item-02 park-01 nowhere)
    (room item-03 park-01 nowhere)
    ; park-02 lies at (0.8380, -0.0170) m
    (free park-02)
    (room item-01 park-02 nowhere)
    (room item-02 park-02 nowhere)
    (room item-03 park-02 nowhere)
    ; park-03 lies at (0.4578, -0.2058) m
    (free park-03)
    (room item-01 park-03 nowhere)
    (room item-02 park-03 nowhere)
    (room item-03 park-03 nowhere)
    (can a-carry-to-001a-hollow-wide-00 item-01) (= (cost-of-carry-to-001a-hollow-wide-00 item-01) 4)
    (= (cost-of-carry-to-010a-hollow-wide-00 item-01) 26)
    (= (cost-of-carry-to-011a-hollow-wide-00 item-01) 14)
    (= (cost-of-carry-to-100a-hollow-wide-00 item-01) 4)
    (= (cost-of-carry-to-101a-hollow-wide-00 item-01) 11)
    (= (cost-of-carry-to-110a-hollow-wide-00 item-01) 48)
    (= (cost-of-carry-to-111a-hollow-wide-00 item-01) 7)
    (can a-carry-to-011d-any-tall-narrow-11 item-02) (= (cost-of-carry-to-011d-any-tall-narrow-11 item-02) 4)
    (= (cost-of-carry-to-001a-any-tall-narrow-11 item-02) 7)
    (= (cost-of-carry-to-010b-any-tall-narrow-11 item-02) 7)
    (= (cost-of-carry-to-100-any-tall-narrow-11 item-02) 4)
    (= (cost-of-carry-to-101-any-tall-narrow-11 item-02) 7)
    (= (cost-of-carry-to-110b-any-tall-narrow-11 item-02) 7)
    (= (cost-of-carry-to-111c-any-tall-narrow-11 item-02) 4)
    (can a-carry-to-100-solid-low-10 item-03) (= (cost-of-carry-to-100-solid-low-10 item-03) 7)
    (= (cost-of-carry-to-010-solid-low-10 item-03) 281)
    (= (cost-of-carry-to-011c-solid-low-10 item-03) 131)
    (= (cost-of-carry-to-101-solid-low-10 item-03) 190)
    (= (cost-of-carry-to-110-solid-low-10 item-03) 281)
    (= (cost-of-carry-to-111b-solid-low-10 item-03) 11))
  (:goal (and (done item-01) (done item-02) (done item-03)))
  (:metric minimize (total-cost)))
