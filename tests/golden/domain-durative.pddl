; Learned domain toy. Printed by neurosym; do not edit.
; Subtypes of thing are the categories of objects that a network learned from trying actions; they limit no
; action. Bits in names are learned symbols; a letter behind them tells parameters for one symbol apart.
; The hand carries one object at a time, to a free place. The places where other objects stood
; over it at first, up to 3, must be free, too; nowhere always is. What can only be
; pushed is not in it. The duration follows from the waypoints, and from how fast the hand moves in
; the simulator. It counts the way over the table as its diagonal, and not the way to the object.
(define (domain toy-durative)
  (:requirements :strips :typing :durative-actions)
  (:types thing place - object cube slab - thing)
  (:predicates
    (hand-empty)
    (can-carry ?o - thing)
    (stands ?o - thing ?p - place)
    (free ?p - place)
    (room ?o - thing ?p ?over-1 ?over-2 ?over-3 - place))
  (:durative-action carry
    :parameters (?o - thing ?from ?to ?over-1 ?over-2 ?over-3 - place)
    :duration (= ?duration 6.100)
    :condition (and (at start (hand-empty)) (at start (can-carry ?o)) (at start (stands ?o ?from)) (at start (free ?to)) (at start (room ?o ?to ?over-1 ?over-2 ?over-3)) (at start (free ?over-1)) (at start (free ?over-2)) (at start (free ?over-3)))
    :effect (and (at start (not (hand-empty))) (at start (not (stands ?o ?from))) (at start (not (free ?to))) (at end (stands ?o ?to)) (at end (free ?from)) (at end (hand-empty)))))
