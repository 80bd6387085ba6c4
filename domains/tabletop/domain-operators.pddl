; Learned domain tabletop, encoding operators. Printed by neurosym; do not edit.
; One action moves all axes.
; Cells of 5 mm: 121 along x, 121 along y, 50 along z (counted from where an object rests).
; (x-plus-3 ?from ?to): ?to is 3 cells further along x than ?from, and on the table.
; After a lift the hand is full: only the put-down of that lift applies.
; Cost of a step: 1 + round(-100 ln((k + 1) / (n + 2))), k successes in n rehearsals.

(define (domain tabletop)
  (:requirements :strips :typing :action-costs)

  (:types
    movable x-cell y-cell z-cell - object
    any-tall-narrow-01 hollow-wide-10 solid-low-00 solid-low-narrow-11 - movable)

  (:predicates
    (hand-empty)
    (ready)
    (at-x ?o - movable ?c - x-cell)
    (at-y ?o - movable ?c - y-cell)
    (at-z ?o - movable ?c - z-cell)
    (goal-xy ?o - movable ?x - x-cell ?y - y-cell)
    (goal-z ?o - movable ?z - z-cell)
    (done ?o - movable)
    (held-by-lift-001-any-tall-narrow-01 ?o - any-tall-narrow-01)
    (held-by-lift-001-hollow-wide-10 ?o - hollow-wide-10)
    (held-by-lift-001-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (held-by-lift-011-any-tall-narrow-01 ?o - any-tall-narrow-01)
    (held-by-lift-011-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (held-by-lift-101-any-tall-narrow-01 ?o - any-tall-narrow-01)
    (held-by-lift-101-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (held-by-lift-111-any-tall-narrow-01 ?o - any-tall-narrow-01)
    (held-by-lift-111-hollow-wide-10 ?o - hollow-wide-10)
    (held-by-lift-111-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (x-minus-19 ?from ?to - x-cell)
    (x-minus-18 ?from ?to - x-cell)
    (x-minus-14 ?from ?to - x-cell)
    (x-minus-12 ?from ?to - x-cell)
    (x-minus-11 ?from ?to - x-cell)
    (x-minus-9 ?from ?to - x-cell)
    (x-minus-8 ?from ?to - x-cell)
    (x-minus-3 ?from ?to - x-cell)
    (x-plus-1 ?from ?to - x-cell)
    (x-plus-2 ?from ?to - x-cell)
    (x-plus-5 ?from ?to - x-cell)
    (x-plus-6 ?from ?to - x-cell)
    (x-plus-7 ?from ?to - x-cell)
    (x-plus-10 ?from ?to - x-cell)
    (x-plus-11 ?from ?to - x-cell)
    (x-plus-13 ?from ?to - x-cell)
    (x-plus-14 ?from ?to - x-cell)
    (x-plus-16 ?from ?to - x-cell)
    (x-plus-18 ?from ?to - x-cell)
    (x-plus-19 ?from ?to - x-cell)
    (y-minus-28 ?from ?to - y-cell)
    (y-minus-25 ?from ?to - y-cell)
    (y-minus-14 ?from ?to - y-cell)
    (y-minus-13 ?from ?to - y-cell)
    (y-minus-10 ?from ?to - y-cell)
    (y-minus-8 ?from ?to - y-cell)
    (y-minus-7 ?from ?to - y-cell)
    (y-minus-5 ?from ?to - y-cell)
    (y-minus-3 ?from ?to - y-cell)
    (y-minus-1 ?from ?to - y-cell)
    (y-plus-1 ?from ?to - y-cell)
    (y-plus-4 ?from ?to - y-cell)
    (y-plus-6 ?from ?to - y-cell)
    (y-plus-7 ?from ?to - y-cell)
    (y-plus-9 ?from ?to - y-cell)
    (y-plus-10 ?from ?to - y-cell)
    (y-plus-11 ?from ?to - y-cell)
    (y-plus-18 ?from ?to - y-cell)
    (y-plus-21 ?from ?to - y-cell)
    (z-minus-49 ?from ?to - z-cell)
    (z-minus-47 ?from ?to - z-cell)
    (z-minus-43 ?from ?to - z-cell)
    (z-minus-42 ?from ?to - z-cell)
    (z-minus-40 ?from ?to - z-cell)
    (z-plus-40 ?from ?to - z-cell)
    (z-plus-42 ?from ?to - z-cell)
    (z-plus-43 ?from ?to - z-cell)
    (z-plus-47 ?from ?to - z-cell)
    (z-plus-49 ?from ?to - z-cell))

  (:functions (total-cost) - number)

  ; Primitive 001 on category 01 (any-tall-narrow-01); ends held in 10 of 16 rehearsals (62%).
  ; Effect (-37.7, -66.5, 200.4) mm, spread (4.9, 27.2, 1.2) mm; 10 of 16 rehearsals as promised: cost 50.
  ; Action parameters: 0.0057 0.0226 0.0052 0.6198 -0.0177 0.0443 -0.0233 0.4998 -0.0414 -0.0478 -0.0177
  ; 0.0664
  (:action lift-001-any-tall-narrow-01
    :parameters (?o - any-tall-narrow-01 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-8 ?x ?to-x) (at-y ?o ?y) (y-minus-13 ?y ?to-y) (at-z ?o ?z) (z-plus-40 ?z ?to-z))
    :effect (and (not (hand-empty)) (not (done ?o)) (held-by-lift-001-any-tall-narrow-01 ?o) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 50)))

  ; Put down what lift-001-any-tall-narrow-01 lifted.
  (:action put-down-lift-001-any-tall-narrow-01
    :parameters (?o - any-tall-narrow-01 ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-001-any-tall-narrow-01 ?o) (at-y ?o ?y) (y-minus-1 ?y ?to-y) (at-z ?o ?z) (z-minus-40 ?z ?to-z))
    :effect (and (not (held-by-lift-001-any-tall-narrow-01 ?o)) (not (done ?o)) (hand-empty) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 001 on category 10 (hollow-wide-10); ends held in 26 of 30 rehearsals (87%).
  ; Effect (-38.5, -123, 197.8) mm, spread (2.6, 9.5, 5.5) mm; 26 of 30 rehearsals as promised: cost 18.
  ; Action parameters: 0.0057 0.0226 0.0052 0.6198 -0.0177 0.0443 -0.0233 0.4998 -0.0414 -0.0478 -0.0177
  ; 0.0664
  (:action lift-001-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-8 ?x ?to-x) (at-y ?o ?y) (y-minus-25 ?y ?to-y) (at-z ?o ?z) (z-plus-40 ?z ?to-z))
    :effect (and (not (hand-empty)) (not (done ?o)) (held-by-lift-001-hollow-wide-10 ?o) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 18)))

  ; Put down what lift-001-hollow-wide-10 lifted.
  (:action put-down-lift-001-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-001-hollow-wide-10 ?o) (at-z ?o ?z) (z-minus-40 ?z ?to-z))
    :effect (and (not (held-by-lift-001-hollow-wide-10 ?o)) (not (done ?o)) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 001 on category 11 (solid-low-narrow-11); ends held in 22 of 22 rehearsals (100%).
  ; Effect (-41, -49.9, 201.1) mm, spread (5.2, 0.6, 2.2) mm; 22 of 22 rehearsals as promised: cost 5.
  ; Action parameters: 0.0057 0.0226 0.0052 0.6198 -0.0177 0.0443 -0.0233 0.4998 -0.0414 -0.0478 -0.0177
  ; 0.0664
  (:action lift-001-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-8 ?x ?to-x) (at-y ?o ?y) (y-minus-10 ?y ?to-y) (at-z ?o ?z) (z-plus-40 ?z ?to-z))
    :effect (and (not (hand-empty)) (not (done ?o)) (held-by-lift-001-solid-low-narrow-11 ?o) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 5)))

  ; Put down what lift-001-solid-low-narrow-11 lifted.
  (:action put-down-lift-001-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11 ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-001-solid-low-narrow-11 ?o) (at-z ?o ?z) (z-minus-40 ?z ?to-z))
    :effect (and (not (held-by-lift-001-solid-low-narrow-11 ?o)) (not (done ?o)) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 011 on category 01 (any-tall-narrow-01); ends held in 15 of 16 rehearsals (94%).
  ; Effect (-45.6, 47.4, 216.8) mm, spread (1.1, 0.5, 0.9) mm; 15 of 16 rehearsals as promised: cost 13.
  ; Action parameters: 0.0457 -0.0079 0.0205 0.6842 -0.0016 -0.0096 -0.0035 0.7806 -0.0472 0.0489 0.0132
  ; 0.1249
  (:action lift-011-any-tall-narrow-01
    :parameters (?o - any-tall-narrow-01 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-9 ?x ?to-x) (at-y ?o ?y) (y-plus-9 ?y ?to-y) (at-z ?o ?z) (z-plus-43 ?z ?to-z))
    :effect (and (not (hand-empty)) (not (done ?o)) (held-by-lift-011-any-tall-narrow-01 ?o) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 13)))

  ; Put down what lift-011-any-tall-narrow-01 lifted.
  (:action put-down-lift-011-any-tall-narrow-01
    :parameters (?o - any-tall-narrow-01 ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-011-any-tall-narrow-01 ?o) (at-z ?o ?z) (z-minus-43 ?z ?to-z))
    :effect (and (not (held-by-lift-011-any-tall-narrow-01 ?o)) (not (done ?o)) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 011 on category 11 (solid-low-narrow-11); ends held in 22 of 22 rehearsals (100%).
  ; Effect (-45.5, 46.3, 215.2) mm, spread (0.2, 0.6, 1.9) mm; 22 of 22 rehearsals as promised: cost 5.
  ; Action parameters: 0.0457 -0.0079 0.0205 0.6842 -0.0016 -0.0096 -0.0035 0.7806 -0.0472 0.0489 0.0132
  ; 0.1249
  (:action lift-011-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-9 ?x ?to-x) (at-y ?o ?y) (y-plus-9 ?y ?to-y) (at-z ?o ?z) (z-plus-43 ?z ?to-z))
    :effect (and (not (hand-empty)) (not (done ?o)) (held-by-lift-011-solid-low-narrow-11 ?o) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 5)))

  ; Put down what lift-011-solid-low-narrow-11 lifted.
  (:action put-down-lift-011-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11 ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-011-solid-low-narrow-11 ?o) (at-z ?o ?z) (z-minus-43 ?z ?to-z))
    :effect (and (not (held-by-lift-011-solid-low-narrow-11 ?o)) (not (done ?o)) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 101 on category 01 (any-tall-narrow-01); ends held in 15 of 16 rehearsals (94%).
  ; Effect (53.1, -22.7, 243.5) mm, spread (0.3, 0.9, 4.9) mm; 15 of 16 rehearsals as promised: cost 13.
  ; Action parameters: -0.0149 0.0040 -0.0156 0.8222 -0.0171 0.0051 -0.0085 0.4734 0.0374 -0.0209 0.0321
  ; 0.4315
  (:action lift-101-any-tall-narrow-01
    :parameters (?o - any-tall-narrow-01 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-11 ?x ?to-x) (at-y ?o ?y) (y-minus-5 ?y ?to-y) (at-z ?o ?z) (z-plus-49 ?z ?to-z))
    :effect (and (not (hand-empty)) (not (done ?o)) (held-by-lift-101-any-tall-narrow-01 ?o) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 13)))

  ; Put down what lift-101-any-tall-narrow-01 lifted.
  (:action put-down-lift-101-any-tall-narrow-01
    :parameters (?o - any-tall-narrow-01 ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-101-any-tall-narrow-01 ?o) (at-z ?o ?z) (z-minus-49 ?z ?to-z))
    :effect (and (not (held-by-lift-101-any-tall-narrow-01 ?o)) (not (done ?o)) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 101 on category 11 (solid-low-narrow-11); ends held in 22 of 22 rehearsals (100%).
  ; Effect (52.2, -24.3, 237.4) mm, spread (1, 0.9, 5.8) mm; 22 of 22 rehearsals as promised: cost 5.
  ; Action parameters: -0.0149 0.0040 -0.0156 0.8222 -0.0171 0.0051 -0.0085 0.4734 0.0374 -0.0209 0.0321
  ; 0.4315
  (:action lift-101-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-10 ?x ?to-x) (at-y ?o ?y) (y-minus-5 ?y ?to-y) (at-z ?o ?z) (z-plus-47 ?z ?to-z))
    :effect (and (not (hand-empty)) (not (done ?o)) (held-by-lift-101-solid-low-narrow-11 ?o) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 5)))

  ; Put down what lift-101-solid-low-narrow-11 lifted.
  (:action put-down-lift-101-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11 ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-101-solid-low-narrow-11 ?o) (at-z ?o ?z) (z-minus-47 ?z ?to-z))
    :effect (and (not (held-by-lift-101-solid-low-narrow-11 ?o)) (not (done ?o)) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 111 on category 01 (any-tall-narrow-01); ends held in 12 of 16 rehearsals (75%).
  ; Effect (29.4, 57.1, 209.3) mm, spread (7.4, 21.4, 14.8) mm; 11 of 16 rehearsals as promised: cost 42.
  ; Action parameters: -0.0245 -0.0271 -0.0225 0.8688 0.0044 0.0433 0.0075 0.8195 0.0421 0.0492 -0.0464
  ; 0.4137
  (:action lift-111-any-tall-narrow-01
    :parameters (?o - any-tall-narrow-01 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-6 ?x ?to-x) (at-y ?o ?y) (y-plus-11 ?y ?to-y) (at-z ?o ?z) (z-plus-42 ?z ?to-z))
    :effect (and (not (hand-empty)) (not (done ?o)) (held-by-lift-111-any-tall-narrow-01 ?o) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 42)))

  ; Put down what lift-111-any-tall-narrow-01 lifted.
  (:action put-down-lift-111-any-tall-narrow-01
    :parameters (?o - any-tall-narrow-01 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-111-any-tall-narrow-01 ?o) (at-x ?o ?x) (x-plus-1 ?x ?to-x) (at-y ?o ?y) (y-minus-1 ?y ?to-y) (at-z ?o ?z) (z-minus-42 ?z ?to-z))
    :effect (and (not (held-by-lift-111-any-tall-narrow-01 ?o)) (not (done ?o)) (hand-empty) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 111 on category 10 (hollow-wide-10); ends held in 30 of 30 rehearsals (100%).
  ; Effect (32.9, 107.2, 202.3) mm, spread (12.4, 22, 12.9) mm; 27 of 30 rehearsals as promised: cost 14.
  ; Action parameters: -0.0245 -0.0271 -0.0225 0.8688 0.0044 0.0433 0.0075 0.8195 0.0421 0.0492 -0.0464
  ; 0.4137
  (:action lift-111-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-7 ?x ?to-x) (at-y ?o ?y) (y-plus-21 ?y ?to-y) (at-z ?o ?z) (z-plus-40 ?z ?to-z))
    :effect (and (not (hand-empty)) (not (done ?o)) (held-by-lift-111-hollow-wide-10 ?o) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 14)))

  ; Put down what lift-111-hollow-wide-10 lifted.
  (:action put-down-lift-111-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-111-hollow-wide-10 ?o) (at-z ?o ?z) (z-minus-40 ?z ?to-z))
    :effect (and (not (held-by-lift-111-hollow-wide-10 ?o)) (not (done ?o)) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 111 on category 11 (solid-low-narrow-11); ends held in 22 of 22 rehearsals (100%).
  ; Effect (29.7, 45.7, 199.6) mm, spread (9.1, 0.9, 0.4) mm; 22 of 22 rehearsals as promised: cost 5.
  ; Action parameters: -0.0245 -0.0271 -0.0225 0.8688 0.0044 0.0433 0.0075 0.8195 0.0421 0.0492 -0.0464
  ; 0.4137
  (:action lift-111-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-6 ?x ?to-x) (at-y ?o ?y) (y-plus-9 ?y ?to-y) (at-z ?o ?z) (z-plus-40 ?z ?to-z))
    :effect (and (not (hand-empty)) (not (done ?o)) (held-by-lift-111-solid-low-narrow-11 ?o) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 5)))

  ; Put down what lift-111-solid-low-narrow-11 lifted.
  (:action put-down-lift-111-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11 ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-111-solid-low-narrow-11 ?o) (at-z ?o ?z) (z-minus-40 ?z ?to-z))
    :effect (and (not (held-by-lift-111-solid-low-narrow-11 ?o)) (not (done ?o)) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 110 on category 00 (solid-low-00); ends at rest in 22 of 32 rehearsals (69%).
  ; Effect (78.4, 48, 0) mm, spread (48.9, 29.7, 0) mm; 15 of 32 rehearsals as promised: cost 76.
  ; Action parameters: -0.0494 -0.0490 -0.0126 0.3523 0.0326 0.0354 -0.0201 0.7248 0.0086 0.0427 0.0384
  ; 0.0307
  (:action place-forward-left-110-solid-low-00
    :parameters (?o - solid-low-00 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-16 ?x ?to-x) (at-y ?o ?y) (y-plus-10 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 76)))

  ; Primitive 010 on category 01 (any-tall-narrow-01); ends at rest in 16 of 16 rehearsals (100%).
  ; Effect (-92.6, -13.9, 0) mm, spread (14.9, 21.4, 0) mm; 15 of 16 rehearsals as promised: cost 13.
  ; Action parameters: 0.0489 -0.0062 -0.0193 0.8713 -0.0412 -0.0133 -0.0215 0.1075 0.0086 0.0406 0.0203
  ; 0.8652
  (:action pull-010-any-tall-narrow-01
    :parameters (?o - any-tall-narrow-01 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-19 ?x ?to-x) (at-y ?o ?y) (y-minus-3 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 13)))

  ; Primitive 010 on category 10 (hollow-wide-10); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (-57.6, 19.1, 0) mm, spread (53, 21.7, 0) mm; 10 of 30 rehearsals as promised: cost 108.
  ; Action parameters: 0.0489 -0.0062 -0.0193 0.8713 -0.0412 -0.0133 -0.0215 0.1075 0.0086 0.0406 0.0203
  ; 0.8652
  (:action pull-010-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-12 ?x ?to-x) (at-y ?o ?y) (y-plus-4 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 108)))

  ; Primitive 010 on category 00 (solid-low-00); ends at rest in 32 of 32 rehearsals (100%).
  ; Effect (-68.8, -0.3, 0) mm, spread (24.3, 16.3, 0) mm; 27 of 32 rehearsals as promised: cost 20.
  ; Action parameters: 0.0489 -0.0062 -0.0193 0.8713 -0.0412 -0.0133 -0.0215 0.1075 0.0086 0.0406 0.0203
  ; 0.8652
  (:action pull-010-solid-low-00
    :parameters (?o - solid-low-00 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-14 ?x ?to-x))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 20)))

  ; Primitive 010 on category 11 (solid-low-narrow-11); ends at rest in 22 of 22 rehearsals (100%).
  ; Effect (-90.1, -14, 0) mm, spread (1, 2.3, 0) mm; 22 of 22 rehearsals as promised: cost 5.
  ; Action parameters: 0.0489 -0.0062 -0.0193 0.8713 -0.0412 -0.0133 -0.0215 0.1075 0.0086 0.0406 0.0203
  ; 0.8652
  (:action pull-010-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-18 ?x ?to-x) (at-y ?o ?y) (y-minus-3 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 5)))

  ; Primitive 011 on category 00 (solid-low-00); ends at rest in 23 of 32 rehearsals (72%).
  ; Effect (-54.5, 30.1, 0) mm, spread (36.3, 30.2, 0) mm; 18 of 32 rehearsals as promised: cost 59.
  ; Action parameters: 0.0457 -0.0079 0.0205 0.6842 -0.0016 -0.0096 -0.0035 0.7806 -0.0472 0.0489 0.0132
  ; 0.1249
  (:action pull-left-011-solid-low-00
    :parameters (?o - solid-low-00 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-11 ?x ?to-x) (at-y ?o ?y) (y-plus-6 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 59)))

  ; Primitive 000 on category 10 (hollow-wide-10); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (-47.1, -37.8, 0) mm, spread (30.7, 20, 0) mm; 25 of 30 rehearsals as promised: cost 22.
  ; Action parameters: 0.0466 0.0448 0.0058 0.0993 -0.0497 -0.0410 0.0084 0.7961 -0.0117 0.0022 0.0032
  ; 0.3919
  (:action pull-right-000-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-9 ?x ?to-x) (at-y ?o ?y) (y-minus-8 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 22)))

  ; Primitive 000 on category 00 (solid-low-00); ends at rest in 24 of 32 rehearsals (75%).
  ; Effect (-90.5, -67.8, 0) mm, spread (48.5, 31.2, 0) mm; 15 of 32 rehearsals as promised: cost 76.
  ; Action parameters: 0.0466 0.0448 0.0058 0.0993 -0.0497 -0.0410 0.0084 0.7961 -0.0117 0.0022 0.0032
  ; 0.3919
  (:action pull-right-000-solid-low-00
    :parameters (?o - solid-low-00 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-18 ?x ?to-x) (at-y ?o ?y) (y-minus-14 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 76)))

  ; Primitive 100 on category 01 (any-tall-narrow-01); ends at rest in 15 of 16 rehearsals (94%).
  ; Effect (94.9, 5.5, 0) mm, spread (14.6, 3, 0) mm; 15 of 16 rehearsals as promised: cost 13.
  ; Action parameters: -0.0444 -0.0058 -0.0209 0.6716 0.0441 0.0086 0.0113 0.1143 -0.0442 -0.0419 0.0269
  ; 0.5838
  (:action push-forward-100-any-tall-narrow-01
    :parameters (?o - any-tall-narrow-01 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-19 ?x ?to-x) (at-y ?o ?y) (y-plus-1 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 13)))

  ; Primitive 100 on category 00 (solid-low-00); ends at rest in 31 of 32 rehearsals (97%).
  ; Effect (67, 3.2, 0) mm, spread (28.5, 7.9, 0) mm; 27 of 32 rehearsals as promised: cost 20.
  ; Action parameters: -0.0444 -0.0058 -0.0209 0.6716 0.0441 0.0086 0.0113 0.1143 -0.0442 -0.0419 0.0269
  ; 0.5838
  (:action push-forward-100-solid-low-00
    :parameters (?o - solid-low-00 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-13 ?x ?to-x) (at-y ?o ?y) (y-plus-1 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 20)))

  ; Primitive 100 on category 11 (solid-low-narrow-11); ends at rest in 22 of 22 rehearsals (100%).
  ; Effect (88.5, 6.6, 0) mm, spread (0.5, 0.8, 0) mm; 22 of 22 rehearsals as promised: cost 5.
  ; Action parameters: -0.0444 -0.0058 -0.0209 0.6716 0.0441 0.0086 0.0113 0.1143 -0.0442 -0.0419 0.0269
  ; 0.5838
  (:action push-forward-100-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-18 ?x ?to-x) (at-y ?o ?y) (y-plus-1 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 5)))

  ; Primitive 110 on category 11 (solid-low-narrow-11); ends at rest in 21 of 22 rehearsals (95%).
  ; Effect (70.6, 92.4, 0) mm, spread (15, 22.2, 0) mm; 20 of 22 rehearsals as promised: cost 14.
  ; Action parameters: -0.0494 -0.0490 -0.0126 0.3523 0.0326 0.0354 -0.0201 0.7248 0.0086 0.0427 0.0384
  ; 0.0307
  (:action push-forward-left-110-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-14 ?x ?to-x) (at-y ?o ?y) (y-plus-18 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 14)))

  ; Primitive 111 on category 00 (solid-low-00); ends at rest in 32 of 32 rehearsals (100%).
  ; Effect (24.7, 46.4, 0) mm, spread (18.8, 29.7, 0) mm; 26 of 32 rehearsals as promised: cost 24.
  ; Action parameters: -0.0245 -0.0271 -0.0225 0.8688 0.0044 0.0433 0.0075 0.8195 0.0421 0.0492 -0.0464
  ; 0.4137
  (:action push-forward-left-111-solid-low-00
    :parameters (?o - solid-low-00 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-5 ?x ?to-x) (at-y ?o ?y) (y-plus-9 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 24)))

  ; Primitive 110 on category 01 (any-tall-narrow-01); ends at rest in 15 of 16 rehearsals (94%).
  ; Effect (11.3, 36.9, 0) mm, spread (32.3, 19.1, 0) mm; 13 of 16 rehearsals as promised: cost 26.
  ; Action parameters: -0.0494 -0.0490 -0.0126 0.3523 0.0326 0.0354 -0.0201 0.7248 0.0086 0.0427 0.0384
  ; 0.0307
  (:action push-left-110-any-tall-narrow-01
    :parameters (?o - any-tall-narrow-01 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-2 ?x ?to-x) (at-y ?o ?y) (y-plus-7 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 26)))

  ; Primitive 000 on category 11 (solid-low-narrow-11); ends at rest in 20 of 22 rehearsals (91%).
  ; Effect (-59.4, -138.2, 0) mm, spread (17.2, 25.3, 0) mm; 19 of 22 rehearsals as promised: cost 19.
  ; Action parameters: 0.0466 0.0448 0.0058 0.0993 -0.0497 -0.0410 0.0084 0.7961 -0.0117 0.0022 0.0032
  ; 0.3919
  (:action push-right-000-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-12 ?x ?to-x) (at-y ?o ?y) (y-minus-28 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 19)))

  ; Primitive 001 on category 00 (solid-low-00); ends at rest in 31 of 32 rehearsals (97%).
  ; Effect (-12.8, -33, 0) mm, spread (12.3, 25.3, 0) mm; 31 of 32 rehearsals as promised: cost 7.
  ; Action parameters: 0.0057 0.0226 0.0052 0.6198 -0.0177 0.0443 -0.0233 0.4998 -0.0414 -0.0478 -0.0177
  ; 0.0664
  (:action push-right-001-solid-low-00
    :parameters (?o - solid-low-00 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-3 ?x ?to-x) (at-y ?o ?y) (y-minus-7 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 7)))

  ; Note that an object is within its goal region.
  (:action reach-goal
    :parameters (?o - movable ?x - x-cell ?y - y-cell ?z - z-cell)
    :precondition (and (ready) (at-x ?o ?x) (at-y ?o ?y) (at-z ?o ?z) (goal-xy ?o ?x ?y) (goal-z ?o ?z))
    :effect (and (done ?o) (increase (total-cost) 0)))

  ; Left out:
  ; pull-left-011-hollow-wide-10: scatters more than it moves.
  ; pull-right-000-any-tall-narrow-01: scatters more than it moves.
  ; push-forward-100-hollow-wide-10: scatters more than it moves.
  ; push-forward-left-110-hollow-wide-10: scatters more than it moves.
  ; push-right-101-hollow-wide-10: scatters more than it moves.
  ; push-right-101-solid-low-00: scatters more than it moves.
)
