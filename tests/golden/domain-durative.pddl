; Learned domain toy, encoding durative. Printed by neurosym; do not edit.
; An action carries an object from a place to another, which must be free. So must be the places where other
; objects stood over it at first, up to 3; nowhere is always free.
; What can only be pushed is not in it.
; What a valid plan guarantees: the hand carries one object at a time, to a free place, where no object
; stands in another.
; Durations follow from the waypoints, and from how fast the hand moves in the simulator. They count the way
; over the table as its diagonal, and leave out the way to the object.

(define (domain toy-durative)
  (:requirements :strips :typing :durative-actions)

  (:types
    movable place - object
    cube slab - movable)

  (:predicates
    (hand-empty)
    (stands ?o - movable ?p - place)
    (free ?p - place)
    (room ?o - movable ?p ?over-1 ?over-2 ?over-3 - place)
    (can-carry-to-01-cube ?o - cube))

  ; Primitive 01 on category 00 (cube): carries to the place in 20 of 20 rehearsals, spread (0, 0) mm.
  ; With another object on the place it stood there in 0 of 10; the place must be free.
  ; Action parameters: 0.0000 0.0000 0.0000 1.0000 0.0100 0.0000 0.0000 0.0000 0.0300 -0.0200 0.0000 0.0000
  (:durative-action carry-to-01-cube
    :parameters (?o - cube ?from ?to ?over-1 ?over-2 ?over-3 - place)
    :duration (= ?duration 6.100)
    :condition (and (at start (hand-empty)) (at start (can-carry-to-01-cube ?o)) (at start (stands ?o ?from)) (at start (free ?to)) (at start (room ?o ?to ?over-1 ?over-2 ?over-3)) (at start (free ?over-1)) (at start (free ?over-2)) (at start (free ?over-3)))
    :effect (and (at start (not (hand-empty))) (at start (not (stands ?o ?from))) (at start (not (free ?to))) (at end (stands ?o ?to)) (at end (free ?from)) (at end (hand-empty)))))
