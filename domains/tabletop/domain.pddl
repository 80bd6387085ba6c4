; Learned domain tabletop, encoding stepwise. Printed by neurosym; do not edit.
; One action moves one axis: the named action the first, finish-... the others.
; Cells of 5 mm: 121 along x, 121 along y, 54 along z (counted from where an object rests).
; (x-plus-3 ?from ?to): ?to is 3 cells further along x than ?from, and on the table.
; After a lift the hand is full: only the put-down of that lift applies.
; Cost of a step: 1 + round(-100 ln((k + 1) / (n + 2))), k successes in n rehearsals.

(define (domain tabletop)
  (:requirements :strips :typing :action-costs)

  (:types
    movable x-cell y-cell z-cell - object
    any-low-11 any-narrow-00 any-narrow-01 hollow-wide-10 - movable)

  (:predicates
    (hand-empty)
    (ready)
    (at-x ?o - movable ?c - x-cell)
    (at-y ?o - movable ?c - y-cell)
    (at-z ?o - movable ?c - z-cell)
    (goal-xy ?o - movable ?x - x-cell ?y - y-cell)
    (goal-z ?o - movable ?z - z-cell)
    (done ?o - movable)
    (held-by-lift-000-hollow-wide-10 ?o - hollow-wide-10)
    (held-by-lift-001-hollow-wide-10 ?o - hollow-wide-10)
    (held-by-lift-011-any-narrow-00 ?o - any-narrow-00)
    (held-by-lift-011-any-narrow-01 ?o - any-narrow-01)
    (held-by-lift-110-any-narrow-00 ?o - any-narrow-00)
    (held-by-lift-110-hollow-wide-10 ?o - hollow-wide-10)
    (held-by-lift-111-hollow-wide-10 ?o - hollow-wide-10)
    (moving-lift-000-hollow-wide-10-y ?o - hollow-wide-10)
    (moving-lift-000-hollow-wide-10-z ?o - hollow-wide-10)
    (moving-lift-001-hollow-wide-10-y ?o - hollow-wide-10)
    (moving-lift-001-hollow-wide-10-z ?o - hollow-wide-10)
    (moving-put-down-lift-001-hollow-wide-10-z ?o - hollow-wide-10)
    (moving-lift-011-any-narrow-00-y ?o - any-narrow-00)
    (moving-lift-011-any-narrow-00-z ?o - any-narrow-00)
    (moving-put-down-lift-011-any-narrow-00-z ?o - any-narrow-00)
    (moving-lift-011-any-narrow-01-y ?o - any-narrow-01)
    (moving-lift-011-any-narrow-01-z ?o - any-narrow-01)
    (moving-lift-110-any-narrow-00-y ?o - any-narrow-00)
    (moving-lift-110-any-narrow-00-z ?o - any-narrow-00)
    (moving-put-down-lift-110-any-narrow-00-z ?o - any-narrow-00)
    (moving-lift-110-hollow-wide-10-y ?o - hollow-wide-10)
    (moving-lift-110-hollow-wide-10-z ?o - hollow-wide-10)
    (moving-lift-111-hollow-wide-10-y ?o - hollow-wide-10)
    (moving-lift-111-hollow-wide-10-z ?o - hollow-wide-10)
    (moving-put-down-lift-111-hollow-wide-10-z ?o - hollow-wide-10)
    (moving-pull-right-101-any-low-11-y ?o - any-low-11)
    (moving-pull-right-101-any-narrow-00-y ?o - any-narrow-00)
    (moving-pull-right-101-any-narrow-01-y ?o - any-narrow-01)
    (moving-push-right-000-any-narrow-00-y ?o - any-narrow-00)
    (moving-push-right-011-hollow-wide-10-y ?o - hollow-wide-10)
    (x-minus-16 ?from ?to - x-cell)
    (x-minus-13 ?from ?to - x-cell)
    (x-minus-12 ?from ?to - x-cell)
    (x-minus-8 ?from ?to - x-cell)
    (x-minus-7 ?from ?to - x-cell)
    (x-minus-6 ?from ?to - x-cell)
    (x-plus-1 ?from ?to - x-cell)
    (x-plus-2 ?from ?to - x-cell)
    (x-plus-9 ?from ?to - x-cell)
    (x-plus-10 ?from ?to - x-cell)
    (x-plus-12 ?from ?to - x-cell)
    (x-plus-18 ?from ?to - x-cell)
    (y-minus-25 ?from ?to - y-cell)
    (y-minus-16 ?from ?to - y-cell)
    (y-minus-11 ?from ?to - y-cell)
    (y-minus-8 ?from ?to - y-cell)
    (y-minus-7 ?from ?to - y-cell)
    (y-minus-4 ?from ?to - y-cell)
    (y-minus-1 ?from ?to - y-cell)
    (y-plus-9 ?from ?to - y-cell)
    (y-plus-12 ?from ?to - y-cell)
    (y-plus-22 ?from ?to - y-cell)
    (z-minus-53 ?from ?to - z-cell)
    (z-minus-51 ?from ?to - z-cell)
    (z-minus-46 ?from ?to - z-cell)
    (z-minus-42 ?from ?to - z-cell)
    (z-minus-41 ?from ?to - z-cell)
    (z-minus-40 ?from ?to - z-cell)
    (z-plus-40 ?from ?to - z-cell)
    (z-plus-41 ?from ?to - z-cell)
    (z-plus-42 ?from ?to - z-cell)
    (z-plus-46 ?from ?to - z-cell)
    (z-plus-51 ?from ?to - z-cell)
    (z-plus-53 ?from ?to - z-cell))

  (:functions (total-cost) - number)

  ; Primitive 000 on category 10 (hollow-wide-10); ends held in 17 of 26 rehearsals (65%).
  ; Effect (91.4, 45.6, 203.8) mm, spread (8.1, 13, 8.7) mm; 17 of 26 rehearsals as promised: cost 45.
  ; Action parameters: -0.0411 -0.0500 -0.0069 0.7231 -0.0500 -0.0094 -0.0209 0.8384 0.0500 -0.0187 -0.0119
  ; 0.0000
  (:action lift-000-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-18 ?x ?to-x))
    :effect (and (not (ready)) (moving-lift-000-hollow-wide-10-y ?o) (not (hand-empty)) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 45)))
  (:action finish-lift-000-hollow-wide-10-y
    :parameters (?o - hollow-wide-10 ?y ?to-y - y-cell)
    :precondition (and (moving-lift-000-hollow-wide-10-y ?o) (at-y ?o ?y) (y-plus-9 ?y ?to-y))
    :effect (and (not (moving-lift-000-hollow-wide-10-y ?o)) (moving-lift-000-hollow-wide-10-z ?o) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))
  (:action finish-lift-000-hollow-wide-10-z
    :parameters (?o - hollow-wide-10 ?z ?to-z - z-cell)
    :precondition (and (moving-lift-000-hollow-wide-10-z ?o) (at-z ?o ?z) (z-plus-41 ?z ?to-z))
    :effect (and (not (moving-lift-000-hollow-wide-10-z ?o)) (ready) (held-by-lift-000-hollow-wide-10 ?o) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Put down what lift-000-hollow-wide-10 lifted.
  (:action put-down-lift-000-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-000-hollow-wide-10 ?o) (at-z ?o ?z) (z-minus-41 ?z ?to-z))
    :effect (and (not (held-by-lift-000-hollow-wide-10 ?o)) (not (done ?o)) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 001 on category 10 (hollow-wide-10); ends held in 22 of 26 rehearsals (85%).
  ; Effect (61.3, -80.1, 255.8) mm, spread (3.4, 12.5, 10) mm; 22 of 26 rehearsals as promised: cost 21.
  ; Action parameters: -0.0278 0.0500 -0.0101 0.7273 -0.0206 0.0151 -0.0203 0.5440 0.0428 -0.0067 0.0407
  ; 0.2254
  (:action lift-001-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-12 ?x ?to-x))
    :effect (and (not (ready)) (moving-lift-001-hollow-wide-10-y ?o) (not (hand-empty)) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 21)))
  (:action finish-lift-001-hollow-wide-10-y
    :parameters (?o - hollow-wide-10 ?y ?to-y - y-cell)
    :precondition (and (moving-lift-001-hollow-wide-10-y ?o) (at-y ?o ?y) (y-minus-16 ?y ?to-y))
    :effect (and (not (moving-lift-001-hollow-wide-10-y ?o)) (moving-lift-001-hollow-wide-10-z ?o) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))
  (:action finish-lift-001-hollow-wide-10-z
    :parameters (?o - hollow-wide-10 ?z ?to-z - z-cell)
    :precondition (and (moving-lift-001-hollow-wide-10-z ?o) (at-z ?o ?z) (z-plus-51 ?z ?to-z))
    :effect (and (not (moving-lift-001-hollow-wide-10-z ?o)) (ready) (held-by-lift-001-hollow-wide-10 ?o) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Put down what lift-001-hollow-wide-10 lifted.
  (:action put-down-lift-001-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?y ?to-y - y-cell)
    :precondition (and (ready) (held-by-lift-001-hollow-wide-10 ?o) (at-y ?o ?y) (y-minus-1 ?y ?to-y))
    :effect (and (not (ready)) (moving-put-down-lift-001-hollow-wide-10-z ?o) (not (held-by-lift-001-hollow-wide-10 ?o)) (not (done ?o)) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))
  (:action finish-put-down-lift-001-hollow-wide-10-z
    :parameters (?o - hollow-wide-10 ?z ?to-z - z-cell)
    :precondition (and (moving-put-down-lift-001-hollow-wide-10-z ?o) (at-z ?o ?z) (z-minus-51 ?z ?to-z))
    :effect (and (not (moving-put-down-lift-001-hollow-wide-10-z ?o)) (ready) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 011 on category 00 (any-narrow-00); ends held in 27 of 27 rehearsals (100%).
  ; Effect (47.2, -42, 263.2) mm, spread (1.1, 1.1, 9.2) mm; 27 of 27 rehearsals as promised: cost 5.
  ; Action parameters: -0.0182 0.0028 -0.0152 0.8818 -0.0214 -0.0142 -0.0239 0.8664 0.0250 -0.0406 0.0472
  ; 0.1141
  (:action lift-011-any-narrow-00
    :parameters (?o - any-narrow-00 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-9 ?x ?to-x))
    :effect (and (not (ready)) (moving-lift-011-any-narrow-00-y ?o) (not (hand-empty)) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 5)))
  (:action finish-lift-011-any-narrow-00-y
    :parameters (?o - any-narrow-00 ?y ?to-y - y-cell)
    :precondition (and (moving-lift-011-any-narrow-00-y ?o) (at-y ?o ?y) (y-minus-8 ?y ?to-y))
    :effect (and (not (moving-lift-011-any-narrow-00-y ?o)) (moving-lift-011-any-narrow-00-z ?o) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))
  (:action finish-lift-011-any-narrow-00-z
    :parameters (?o - any-narrow-00 ?z ?to-z - z-cell)
    :precondition (and (moving-lift-011-any-narrow-00-z ?o) (at-z ?o ?z) (z-plus-53 ?z ?to-z))
    :effect (and (not (moving-lift-011-any-narrow-00-z ?o)) (ready) (held-by-lift-011-any-narrow-00 ?o) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Put down what lift-011-any-narrow-00 lifted.
  (:action put-down-lift-011-any-narrow-00
    :parameters (?o - any-narrow-00 ?y ?to-y - y-cell)
    :precondition (and (ready) (held-by-lift-011-any-narrow-00 ?o) (at-y ?o ?y) (y-minus-1 ?y ?to-y))
    :effect (and (not (ready)) (moving-put-down-lift-011-any-narrow-00-z ?o) (not (held-by-lift-011-any-narrow-00 ?o)) (not (done ?o)) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))
  (:action finish-put-down-lift-011-any-narrow-00-z
    :parameters (?o - any-narrow-00 ?z ?to-z - z-cell)
    :precondition (and (moving-put-down-lift-011-any-narrow-00-z ?o) (at-z ?o ?z) (z-minus-53 ?z ?to-z))
    :effect (and (not (moving-put-down-lift-011-any-narrow-00-z ?o)) (ready) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 011 on category 01 (any-narrow-01); ends held in 19 of 23 rehearsals (83%).
  ; Effect (48.5, -41, 264.8) mm, spread (0.8, 0.9, 8.4) mm; 19 of 23 rehearsals as promised: cost 23.
  ; Action parameters: -0.0182 0.0028 -0.0152 0.8818 -0.0214 -0.0142 -0.0239 0.8664 0.0250 -0.0406 0.0472
  ; 0.1141
  (:action lift-011-any-narrow-01
    :parameters (?o - any-narrow-01 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-10 ?x ?to-x))
    :effect (and (not (ready)) (moving-lift-011-any-narrow-01-y ?o) (not (hand-empty)) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 23)))
  (:action finish-lift-011-any-narrow-01-y
    :parameters (?o - any-narrow-01 ?y ?to-y - y-cell)
    :precondition (and (moving-lift-011-any-narrow-01-y ?o) (at-y ?o ?y) (y-minus-8 ?y ?to-y))
    :effect (and (not (moving-lift-011-any-narrow-01-y ?o)) (moving-lift-011-any-narrow-01-z ?o) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))
  (:action finish-lift-011-any-narrow-01-z
    :parameters (?o - any-narrow-01 ?z ?to-z - z-cell)
    :precondition (and (moving-lift-011-any-narrow-01-z ?o) (at-z ?o ?z) (z-plus-53 ?z ?to-z))
    :effect (and (not (moving-lift-011-any-narrow-01-z ?o)) (ready) (held-by-lift-011-any-narrow-01 ?o) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Put down what lift-011-any-narrow-01 lifted.
  (:action put-down-lift-011-any-narrow-01
    :parameters (?o - any-narrow-01 ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-011-any-narrow-01 ?o) (at-z ?o ?z) (z-minus-53 ?z ?to-z))
    :effect (and (not (held-by-lift-011-any-narrow-01 ?o)) (not (done ?o)) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 110 on category 00 (any-narrow-00); ends held in 14 of 27 rehearsals (52%).
  ; Effect (-61.6, 61.6, 211.9) mm, spread (10.2, 18.3, 8.3) mm; 14 of 27 rehearsals as promised: cost 67.
  ; Action parameters: 0.0040 -0.0482 -0.0039 0.7113 0.0303 0.0034 0.0075 0.6789 -0.0448 0.0488 0.0180
  ; 0.0196
  (:action lift-110-any-narrow-00
    :parameters (?o - any-narrow-00 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-12 ?x ?to-x))
    :effect (and (not (ready)) (moving-lift-110-any-narrow-00-y ?o) (not (hand-empty)) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 67)))
  (:action finish-lift-110-any-narrow-00-y
    :parameters (?o - any-narrow-00 ?y ?to-y - y-cell)
    :precondition (and (moving-lift-110-any-narrow-00-y ?o) (at-y ?o ?y) (y-plus-12 ?y ?to-y))
    :effect (and (not (moving-lift-110-any-narrow-00-y ?o)) (moving-lift-110-any-narrow-00-z ?o) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))
  (:action finish-lift-110-any-narrow-00-z
    :parameters (?o - any-narrow-00 ?z ?to-z - z-cell)
    :precondition (and (moving-lift-110-any-narrow-00-z ?o) (at-z ?o ?z) (z-plus-42 ?z ?to-z))
    :effect (and (not (moving-lift-110-any-narrow-00-z ?o)) (ready) (held-by-lift-110-any-narrow-00 ?o) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Put down what lift-110-any-narrow-00 lifted.
  (:action put-down-lift-110-any-narrow-00
    :parameters (?o - any-narrow-00 ?y ?to-y - y-cell)
    :precondition (and (ready) (held-by-lift-110-any-narrow-00 ?o) (at-y ?o ?y) (y-minus-1 ?y ?to-y))
    :effect (and (not (ready)) (moving-put-down-lift-110-any-narrow-00-z ?o) (not (held-by-lift-110-any-narrow-00 ?o)) (not (done ?o)) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))
  (:action finish-put-down-lift-110-any-narrow-00-z
    :parameters (?o - any-narrow-00 ?z ?to-z - z-cell)
    :precondition (and (moving-put-down-lift-110-any-narrow-00-z ?o) (at-z ?o ?z) (z-minus-42 ?z ?to-z))
    :effect (and (not (moving-put-down-lift-110-any-narrow-00-z ?o)) (ready) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 110 on category 10 (hollow-wide-10); ends held in 25 of 26 rehearsals (96%).
  ; Effect (-65.5, 112.4, 200.2) mm, spread (3.1, 13.4, 33) mm; 24 of 26 rehearsals as promised: cost 12.
  ; Action parameters: 0.0040 -0.0482 -0.0039 0.7113 0.0303 0.0034 0.0075 0.6789 -0.0448 0.0488 0.0180
  ; 0.0196
  (:action lift-110-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-13 ?x ?to-x))
    :effect (and (not (ready)) (moving-lift-110-hollow-wide-10-y ?o) (not (hand-empty)) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 12)))
  (:action finish-lift-110-hollow-wide-10-y
    :parameters (?o - hollow-wide-10 ?y ?to-y - y-cell)
    :precondition (and (moving-lift-110-hollow-wide-10-y ?o) (at-y ?o ?y) (y-plus-22 ?y ?to-y))
    :effect (and (not (moving-lift-110-hollow-wide-10-y ?o)) (moving-lift-110-hollow-wide-10-z ?o) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))
  (:action finish-lift-110-hollow-wide-10-z
    :parameters (?o - hollow-wide-10 ?z ?to-z - z-cell)
    :precondition (and (moving-lift-110-hollow-wide-10-z ?o) (at-z ?o ?z) (z-plus-40 ?z ?to-z))
    :effect (and (not (moving-lift-110-hollow-wide-10-z ?o)) (ready) (held-by-lift-110-hollow-wide-10 ?o) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Put down what lift-110-hollow-wide-10 lifted.
  (:action put-down-lift-110-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-110-hollow-wide-10 ?o) (at-z ?o ?z) (z-minus-40 ?z ?to-z))
    :effect (and (not (held-by-lift-110-hollow-wide-10 ?o)) (not (done ?o)) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 111 on category 10 (hollow-wide-10); ends held in 25 of 26 rehearsals (96%).
  ; Effect (-79.4, -122.9, 230.8) mm, spread (22.9, 11.5, 12.3) mm; 24 of 26 rehearsals as promised: cost
  ; 12.
  ; Action parameters: 0.0164 0.0500 -0.0250 1.0000 0.0500 0.0302 0.0040 0.7233 -0.0480 -0.0500 0.0424
  ; 0.0249
  (:action lift-111-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-16 ?x ?to-x))
    :effect (and (not (ready)) (moving-lift-111-hollow-wide-10-y ?o) (not (hand-empty)) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 12)))
  (:action finish-lift-111-hollow-wide-10-y
    :parameters (?o - hollow-wide-10 ?y ?to-y - y-cell)
    :precondition (and (moving-lift-111-hollow-wide-10-y ?o) (at-y ?o ?y) (y-minus-25 ?y ?to-y))
    :effect (and (not (moving-lift-111-hollow-wide-10-y ?o)) (moving-lift-111-hollow-wide-10-z ?o) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))
  (:action finish-lift-111-hollow-wide-10-z
    :parameters (?o - hollow-wide-10 ?z ?to-z - z-cell)
    :precondition (and (moving-lift-111-hollow-wide-10-z ?o) (at-z ?o ?z) (z-plus-46 ?z ?to-z))
    :effect (and (not (moving-lift-111-hollow-wide-10-z ?o)) (ready) (held-by-lift-111-hollow-wide-10 ?o) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Put down what lift-111-hollow-wide-10 lifted.
  (:action put-down-lift-111-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?x ?to-x - x-cell)
    :precondition (and (ready) (held-by-lift-111-hollow-wide-10 ?o) (at-x ?o ?x) (x-plus-1 ?x ?to-x))
    :effect (and (not (ready)) (moving-put-down-lift-111-hollow-wide-10-z ?o) (not (held-by-lift-111-hollow-wide-10 ?o)) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 0)))
  (:action finish-put-down-lift-111-hollow-wide-10-z
    :parameters (?o - hollow-wide-10 ?z ?to-z - z-cell)
    :precondition (and (moving-put-down-lift-111-hollow-wide-10-z ?o) (at-z ?o ?z) (z-minus-46 ?z ?to-z))
    :effect (and (not (moving-put-down-lift-111-hollow-wide-10-z ?o)) (ready) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 101 on category 11 (any-low-11); ends at rest in 24 of 24 rehearsals (100%).
  ; Effect (-35.3, -21.2, 0) mm, spread (17.1, 9.3, 0) mm; 24 of 24 rehearsals as promised: cost 5.
  ; Action parameters: 0.0454 0.0309 -0.0151 0.1322 -0.0177 -0.0345 0.0019 0.1759 -0.0073 -0.0360 0.0333
  ; 0.0320
  (:action pull-right-101-any-low-11
    :parameters (?o - any-low-11 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-7 ?x ?to-x))
    :effect (and (not (ready)) (moving-pull-right-101-any-low-11-y ?o) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 5)))
  (:action finish-pull-right-101-any-low-11-y
    :parameters (?o - any-low-11 ?y ?to-y - y-cell)
    :precondition (and (moving-pull-right-101-any-low-11-y ?o) (at-y ?o ?y) (y-minus-4 ?y ?to-y))
    :effect (and (not (moving-pull-right-101-any-low-11-y ?o)) (ready) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))

  ; Primitive 101 on category 00 (any-narrow-00); ends at rest in 27 of 27 rehearsals (100%).
  ; Effect (-29.4, -34.8, 0) mm, spread (17.7, 19.9, 0) mm; 27 of 27 rehearsals as promised: cost 5.
  ; Action parameters: 0.0454 0.0309 -0.0151 0.1322 -0.0177 -0.0345 0.0019 0.1759 -0.0073 -0.0360 0.0333
  ; 0.0320
  (:action pull-right-101-any-narrow-00
    :parameters (?o - any-narrow-00 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-6 ?x ?to-x))
    :effect (and (not (ready)) (moving-pull-right-101-any-narrow-00-y ?o) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 5)))
  (:action finish-pull-right-101-any-narrow-00-y
    :parameters (?o - any-narrow-00 ?y ?to-y - y-cell)
    :precondition (and (moving-pull-right-101-any-narrow-00-y ?o) (at-y ?o ?y) (y-minus-7 ?y ?to-y))
    :effect (and (not (moving-pull-right-101-any-narrow-00-y ?o)) (ready) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))

  ; Primitive 101 on category 01 (any-narrow-01); ends at rest in 23 of 23 rehearsals (100%).
  ; Effect (-40.4, -33, 0) mm, spread (15.4, 16, 0) mm; 23 of 23 rehearsals as promised: cost 5.
  ; Action parameters: 0.0454 0.0309 -0.0151 0.1322 -0.0177 -0.0345 0.0019 0.1759 -0.0073 -0.0360 0.0333
  ; 0.0320
  (:action pull-right-101-any-narrow-01
    :parameters (?o - any-narrow-01 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-8 ?x ?to-x))
    :effect (and (not (ready)) (moving-pull-right-101-any-narrow-01-y ?o) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 5)))
  (:action finish-pull-right-101-any-narrow-01-y
    :parameters (?o - any-narrow-01 ?y ?to-y - y-cell)
    :precondition (and (moving-pull-right-101-any-narrow-01-y ?o) (at-y ?o ?y) (y-minus-7 ?y ?to-y))
    :effect (and (not (moving-pull-right-101-any-narrow-01-y ?o)) (ready) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))

  ; Primitive 000 on category 00 (any-narrow-00); ends at rest in 16 of 27 rehearsals (59%).
  ; Effect (5.6, -37, 0) mm, spread (19.3, 14.9, 0) mm; 15 of 27 rehearsals as promised: cost 60.
  ; Action parameters: -0.0411 -0.0500 -0.0069 0.7231 -0.0500 -0.0094 -0.0209 0.8384 0.0500 -0.0187 -0.0119
  ; 0.0000
  (:action push-right-000-any-narrow-00
    :parameters (?o - any-narrow-00 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-1 ?x ?to-x))
    :effect (and (not (ready)) (moving-push-right-000-any-narrow-00-y ?o) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 60)))
  (:action finish-push-right-000-any-narrow-00-y
    :parameters (?o - any-narrow-00 ?y ?to-y - y-cell)
    :precondition (and (moving-push-right-000-any-narrow-00-y ?o) (at-y ?o ?y) (y-minus-7 ?y ?to-y))
    :effect (and (not (moving-push-right-000-any-narrow-00-y ?o)) (ready) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))

  ; Primitive 011 on category 10 (hollow-wide-10); ends at rest in 15 of 26 rehearsals (58%).
  ; Effect (8.4, -55.9, 0) mm, spread (16.6, 33.1, 0) mm; 10 of 26 rehearsals as promised: cost 94.
  ; Action parameters: -0.0182 0.0028 -0.0152 0.8818 -0.0214 -0.0142 -0.0239 0.8664 0.0250 -0.0406 0.0472
  ; 0.1141
  (:action push-right-011-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-2 ?x ?to-x))
    :effect (and (not (ready)) (moving-push-right-011-hollow-wide-10-y ?o) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 94)))
  (:action finish-push-right-011-hollow-wide-10-y
    :parameters (?o - hollow-wide-10 ?y ?to-y - y-cell)
    :precondition (and (moving-push-right-011-hollow-wide-10-y ?o) (at-y ?o ?y) (y-minus-11 ?y ?to-y))
    :effect (and (not (moving-push-right-011-hollow-wide-10-y ?o)) (ready) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))

  ; Note that an object is within its goal region.
  (:action reach-goal
    :parameters (?o - movable ?x - x-cell ?y - y-cell ?z - z-cell)
    :precondition (and (ready) (at-x ?o ?x) (at-y ?o ?y) (at-z ?o ?z) (goal-xy ?o ?x ?y) (goal-z ?o ?z))
    :effect (and (done ?o) (increase (total-cost) 0)))

  ; Left out:
  ; pull-111-any-narrow-00: scatters more than it moves.
  ; pull-111-any-narrow-01: scatters more than it moves.
  ; pull-right-101-hollow-wide-10: scatters more than it moves.
  ; pull-right-111-any-low-11: scatters more than it moves.
  ; push-forward-000-any-low-11: scatters more than it moves.
  ; push-forward-001-any-narrow-00: scatters more than it moves.
  ; push-forward-001-any-narrow-01: scatters more than it moves.
  ; push-forward-010-hollow-wide-10: scatters more than it moves.
  ; push-forward-100-any-low-11: scatters more than it moves.
  ; push-forward-100-any-narrow-01: scatters more than it moves.
  ; push-forward-left-010-any-low-11: keeps its promise in 3 of 24 rehearsals only.
  ; push-forward-left-100-any-narrow-00: scatters more than it moves.
  ; push-forward-right-000-any-narrow-01: scatters more than it moves.
  ; push-forward-right-001-any-low-11: scatters more than it moves.
  ; push-forward-right-010-any-narrow-01: scatters more than it moves.
  ; push-right-010-any-narrow-00: scatters more than it moves.
  ; push-right-011-any-low-11: scatters more than it moves.
  ; push-right-100-hollow-wide-10: scatters more than it moves.
  ; stay-110-any-low-11: scatters more than it moves.
  ; stay-110-any-narrow-01: scatters more than it moves.
)
