; Learned domain toy, encoding places. Printed by neurosym; do not edit.
; Objects that can be carried stand at places and are carried to others; the others are led over cells: the
; named action begins a move, and move-z, move-x and move-y make it.
; Cells of 20 mm: 31 along x, 31 along y, 1 along z (counted from where an object rests).
; (x-leads x-plus-3 ?from ?to): ?to is 3 cells further along x than ?from, and on the table.
; After a lift the hand is full: only the put-down of that lift applies.
; Cost of a step: 1 + round(-100 ln((k + 1) / (n + 2))), k successes in n rehearsals.
; What a valid plan guarantees: the hand can begin each step; what is carried comes to free places, where it
; overlaps nothing that stands at a place; goals are met, by what is led up to the rounding of cells.
; What is led over cells meets no condition for others: a valid plan may push it through an object, or leave
; it in one. `neurosym validate` replays a plan and finds objects that end in each other.

(define (domain toy-places)
  (:requirements :strips :typing :action-costs)

  (:types
    movable x-cell y-cell z-cell x-step y-step z-step move place - object
    cube slab - movable)

  (:constants
    x-plus-4 - x-step
    y-plus-4 - y-step
    a-push-forward-010-slab a-push-left-001-slab - move
    a-carry-to-01-cube - move
    nowhere - place)

  (:predicates
    (hand-empty)
    (ready)
    (at-x ?o - movable ?c - x-cell)
    (at-y ?o - movable ?c - y-cell)
    (at-z ?o - movable ?c - z-cell)
    (goal-xy ?o - movable ?x - x-cell ?y - y-cell)
    (goal-z ?o - movable ?z - z-cell)
    (done ?o - movable)
    (held ?m - move ?o - movable)
    (moving-z ?m - move ?o - movable)
    (moving-x ?m - move ?o - movable)
    (moving-y ?m - move ?o - movable)
    (x-leads ?s - x-step ?from ?to - x-cell)
    (y-leads ?s - y-step ?from ?to - y-cell)
    (z-leads ?s - z-step ?from ?to - z-cell)
    (can ?m - move ?o - movable)
    (x-of ?m - move ?o - movable ?s - x-step)
    (y-of ?m - move ?o - movable ?s - y-step)
    (z-of ?m - move ?o - movable ?s - z-step)
    (stands ?o - movable ?p - place)
    (free ?p - place)
    (goal-place ?o - movable ?p - place)
    (led ?o - movable)
    (room ?o - movable ?p ?so-far - place)
    (look-next ?o - movable ?p ?here ?next - place))

  (:functions
    (total-cost) - number
    (cost-of-push-forward-010-slab ?o - slab) - number
    (cost-of-push-left-001-slab ?o - slab) - number
    (cost-of-carry-to-01-cube ?o - cube) - number)

  ; Primitive 01 on category 00 (cube): carries to the place in 20 of 20 rehearsals, spread (0, 0) mm.
  ; With another object on the place it stood there in 0 of 10; the place must be free.
  ; Action parameters: 0.0000 0.0000 0.0000 1.0000 0.0100 0.0000 0.0000 0.0000 0.0300 -0.0200 0.0000 0.0000
  (:action carry-to-01-cube
    :parameters (?o - cube ?from ?to - place)
    :precondition (and (ready) (hand-empty) (can a-carry-to-01-cube ?o) (stands ?o ?from) (free ?to) (room ?o ?to nowhere))
    :effect (and (not (stands ?o ?from)) (free ?from) (stands ?o ?to) (not (free ?to)) (not (done ?o)) (increase (total-cost) (cost-of-carry-to-01-cube ?o))))

  ; Note that a place is free that another overlaps.
  (:action look-on
    :parameters (?o - movable ?p ?here ?next - place)
    :precondition (and (ready) (room ?o ?p ?here) (free ?here) (look-next ?o ?p ?here ?next))
    :effect (and (room ?o ?p ?next) (increase (total-cost) 0)))

  ; Note that an object stands where its goal is.
  (:action reach-place
    :parameters (?o - movable ?p - place)
    :precondition (and (ready) (stands ?o ?p) (goal-place ?o ?p))
    :effect (and (done ?o) (increase (total-cost) 0)))

  ; Note that an object that was led to its goal has left where it started.
  (:action leave-start
    :parameters (?o - movable ?p - place)
    :precondition (and (ready) (done ?o) (led ?o) (stands ?o ?p))
    :effect (and (not (stands ?o ?p)) (free ?p) (increase (total-cost) 0)))

  ; Primitive 010 on category 11 (slab); ends at rest in 20 of 20 rehearsals (100%).
  ; Effect (80, 0, 0) mm, spread (0, 0, 0) mm; 20 of 20 rehearsals as promised: cost 6.
  ; Action parameters: -0.0500 0.0000 0.0000 0.1000 0.0000 0.0000 0.0000 0.1000 0.0500 0.0000 0.0000 0.1000
  (:action push-forward-010-slab
    :parameters (?o - slab)
    :precondition (and (ready) (hand-empty) (can a-push-forward-010-slab ?o))
    :effect (and (not (ready)) (moving-x a-push-forward-010-slab ?o) (not (done ?o)) (increase (total-cost) (cost-of-push-forward-010-slab ?o))))

  ; Primitive 001 on category 11 (slab); ends at rest in 20 of 20 rehearsals (100%).
  ; Effect (0, 80, 0) mm, spread (0, 0, 0) mm; 20 of 20 rehearsals as promised: cost 6.
  ; Action parameters: 0.0000 -0.0500 0.0000 0.1000 0.0000 0.0000 0.0000 0.1000 0.0000 0.0500 0.0000 0.1000
  (:action push-left-001-slab
    :parameters (?o - slab)
    :precondition (and (ready) (hand-empty) (can a-push-left-001-slab ?o))
    :effect (and (not (ready)) (moving-x a-push-left-001-slab ?o) (not (done ?o)) (increase (total-cost) (cost-of-push-left-001-slab ?o))))

  ; Lead an object along an axis, by the step that the problem names for its move.
  (:action move-z
    :parameters (?m - move ?o - movable ?s - z-step ?from ?to - z-cell)
    :precondition (and (moving-z ?m ?o) (at-z ?o ?from) (z-of ?m ?o ?s) (z-leads ?s ?from ?to))
    :effect (and (not (moving-z ?m ?o)) (moving-x ?m ?o) (not (at-z ?o ?from)) (at-z ?o ?to) (increase (total-cost) 0)))
  (:action move-x
    :parameters (?m - move ?o - movable ?s - x-step ?from ?to - x-cell)
    :precondition (and (moving-x ?m ?o) (at-x ?o ?from) (x-of ?m ?o ?s) (x-leads ?s ?from ?to))
    :effect (and (not (moving-x ?m ?o)) (moving-y ?m ?o) (not (at-x ?o ?from)) (at-x ?o ?to) (increase (total-cost) 0)))
  (:action move-y
    :parameters (?m - move ?o - movable ?s - y-step ?from ?to - y-cell)
    :precondition (and (moving-y ?m ?o) (at-y ?o ?from) (y-of ?m ?o ?s) (y-leads ?s ?from ?to))
    :effect (and (not (moving-y ?m ?o)) (ready) (not (at-y ?o ?from)) (at-y ?o ?to) (increase (total-cost) 0)))

  ; Note that an object is within its goal region.
  (:action reach-goal
    :parameters (?o - movable ?x - x-cell ?y - y-cell ?z - z-cell)
    :precondition (and (ready) (at-x ?o ?x) (at-y ?o ?y) (at-z ?o ?z) (goal-xy ?o ?x ?y) (goal-z ?o ?z))
    :effect (and (done ?o) (increase (total-cost) 0)))

  ; No operator is left out.
)
