; Problem anywhere-1-03 of the learned domain places, with places.
; How it came about: anywhere, drawn with seed 4; draw 1.
; A place starting with start- is where an object stands at first, goal- one that meets a goal,
; park- one to wait at. room names the places that must be free for an object, one after
; another; look-on notes that one is. can names what carries an object, at which cost.
(define (problem anywhere-1-03)
  (:domain places-places)
  (:objects
    item-01 - any-tall-narrow-11
    start-item-01 goal-item-01 park-01 - place)
  (:init
    (hand-empty) (ready) (= (total-cost) 0)
    (stands item-01 start-item-01)
    ; goal-item-01 lies at (0.7956, 0.0695) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (room item-01 goal-item-01 nowhere)
    ; park-01 lies at (0.7061, -0.1040) m
    (free park-01)
    (room item-01 park-01 nowhere)
    (can a-carry-to-011d-any-tall-narrow-11 item-01) (= (cost-of-carry-to-011d-any-tall-narrow-11 item-01) 4)
    (= (cost-of-carry-to-001a-any-tall-narrow-11 item-01) 11)
    (= (cost-of-carry-to-010b-any-tall-narrow-11 item-01) 11)
    (= (cost-of-carry-to-100-any-tall-narrow-11 item-01) 4)
    (= (cost-of-carry-to-101-any-tall-narrow-11 item-01) 7)
    (= (cost-of-carry-to-110b-any-tall-narrow-11 item-01) 11)
    (= (cost-of-carry-to-111c-any-tall-narrow-11 item-01) 4))
  (:goal (and (done item-01)))
  (:metric minimize (total-cost)))
