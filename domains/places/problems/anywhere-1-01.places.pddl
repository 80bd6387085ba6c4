; Problem anywhere-1-01 of the learned domain places, with places.
; How it came about: anywhere, drawn with seed 2; draw 1.
; A place starting with start- is where an object stands at first, goal- one that meets a goal,
; park- one to wait at. room names the places that must be free for an object, one after
; another; look-on notes that one is. can names what carries an object, at which cost.
(define (problem anywhere-1-01)
  (:domain places-places)
  (:objects
    item-01 - solid-low-10
    start-item-01 goal-item-01 park-01 - place)
  (:init
    (hand-empty) (ready) (= (total-cost) 0)
    (stands item-01 start-item-01)
    ; goal-item-01 lies at (0.6343, -0.1112) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (room item-01 goal-item-01 nowhere)
    ; park-01 lies at (0.4179, -0.2144) m
    (free park-01)
    (room item-01 park-01 nowhere)
    (can a-carry-to-100-solid-low-10 item-01) (= (cost-of-carry-to-100-solid-low-10 item-01) 7)
    (= (cost-of-carry-to-010-solid-low-10 item-01) 281)
    (= (cost-of-carry-to-011c-solid-low-10 item-01) 11)
    (= (cost-of-carry-to-101-solid-low-10 item-01) 190)
    (= (cost-of-carry-to-110-solid-low-10 item-01) 281)
    (= (cost-of-carry-to-111b-solid-low-10 item-01) 11))
  (:goal (and (done item-01)))
  (:metric minimize (total-cost)))
