; Learned domain toy, encoding stepwise. Printed by neurosym; do not edit.
; One action moves one axis: the named action the first, finish-... the others.
; Cells of 5 mm: 121 along x, 121 along y, 41 along z (counted from where an object rests).
; (x-plus-3 ?from ?to): ?to is 3 cells further along x than ?from, and on the table.
; After a lift the hand is full: only the put-down of that lift applies.
; Cost of a step: 1 + round(-100 ln((k + 1) / (n + 2))), k successes in n rehearsals.
; What a valid plan guarantees: the hand can begin each step; each object stays on the table and meets its
; goal, up to the rounding of positions.
; What is led over cells meets no condition for others: a valid plan may push it through an object, or leave
; it in one. `neurosym validate` replays a plan and finds objects that end in each other.

(define (domain toy)
  (:requirements :strips :typing :action-costs)

  (:types
    movable x-cell y-cell z-cell - object
    cube - movable)

  (:predicates
    (hand-empty)
    (ready)
    (at-x ?o - movable ?c - x-cell)
    (at-y ?o - movable ?c - y-cell)
    (at-z ?o - movable ?c - z-cell)
    (goal-xy ?o - movable ?x - x-cell ?y - y-cell)
    (goal-z ?o - movable ?z - z-cell)
    (done ?o - movable)
    (held-by-lift-000-cube ?o - cube)
    (x-plus-16 ?from ?to - x-cell)
    (y-plus-16 ?from ?to - y-cell)
    (z-minus-40 ?from ?to - z-cell)
    (z-plus-40 ?from ?to - z-cell))

  (:functions (total-cost) - number)

  ; Primitive 000 on category 00 (cube); ends held in 20 of 20 rehearsals (100%).
  ; Effect (0, 0, 200) mm, spread (0, 0, 0) mm; 20 of 20 rehearsals as promised: cost 6.
  ; Action parameters: 0.0000 0.0000 0.0000 0.9000 0.0000 0.0000 0.0000 0.1000 0.0000 0.0000 0.0000 0.1000
  (:action lift-000-cube
    :parameters (?o - cube ?z ?to-z - z-cell)
    :precondition (and (ready) (hand-empty) (at-z ?o ?z) (z-plus-40 ?z ?to-z))
    :effect (and (not (hand-empty)) (not (done ?o)) (held-by-lift-000-cube ?o) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 6)))

  ; Put down what lift-000-cube lifted.
  (:action put-down-lift-000-cube
    :parameters (?o - cube ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-000-cube ?o) (at-z ?o ?z) (z-minus-40 ?z ?to-z))
    :effect (and (not (held-by-lift-000-cube ?o)) (not (done ?o)) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 010 on category 00 (cube); ends at rest in 20 of 20 rehearsals (100%).
  ; Effect (80, 0, 0) mm, spread (0, 0, 0) mm; 20 of 20 rehearsals as promised: cost 6.
  ; Action parameters: -0.0500 0.0000 0.0000 0.1000 0.0000 0.0000 0.0000 0.1000 0.0500 0.0000 0.0000 0.1000
  (:action push-forward-010-cube
    :parameters (?o - cube ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-16 ?x ?to-x))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 6)))

  ; Primitive 001 on category 00 (cube); ends at rest in 20 of 20 rehearsals (100%).
  ; Effect (0, 80, 0) mm, spread (0, 0, 0) mm; 20 of 20 rehearsals as promised: cost 6.
  ; Action parameters: 0.0000 -0.0500 0.0000 0.1000 0.0000 0.0000 0.0000 0.1000 0.0000 0.0500 0.0000 0.1000
  (:action push-left-001-cube
    :parameters (?o - cube ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-y ?o ?y) (y-plus-16 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 6)))

  ; Note that an object is within its goal region.
  (:action reach-goal
    :parameters (?o - movable ?x - x-cell ?y - y-cell ?z - z-cell)
    :precondition (and (ready) (at-x ?o ?x) (at-y ?o ?y) (at-z ?o ?z) (goal-xy ?o ?x ?y) (goal-z ?o ?z))
    :effect (and (done ?o) (increase (total-cost) 0)))

  ; No operator is left out.
)
