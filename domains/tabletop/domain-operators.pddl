; Learned domain tabletop, encoding operators. Printed by neurosym; do not edit.
; One action moves all axes.
; Cells of 5 mm: 121 along x, 121 along y, 49 along z (counted from where an object rests).
; (x-plus-3 ?from ?to): ?to is 3 cells further along x than ?from, and on the table.
; After a lift the hand is full: only the put-down of that lift applies.
; Cost of a step: 1 + round(-100 ln((k + 1) / (n + 2))), k successes in n rehearsals.

(define (domain tabletop)
  (:requirements :strips :typing :action-costs)

  (:types
    movable x-cell y-cell z-cell - object
    any-narrow-11 hollow-tall-wide-01 hollow-wide-00 solid-narrow-10 - movable)

  (:predicates
    (hand-empty)
    (ready)
    (at-x ?o - movable ?c - x-cell)
    (at-y ?o - movable ?c - y-cell)
    (at-z ?o - movable ?c - z-cell)
    (goal-xy ?o - movable ?x - x-cell ?y - y-cell)
    (goal-z ?o - movable ?z - z-cell)
    (done ?o - movable)
    (held-by-lift-000-any-narrow-11 ?o - any-narrow-11)
    (held-by-lift-000-hollow-tall-wide-01 ?o - hollow-tall-wide-01)
    (held-by-lift-000-hollow-wide-00 ?o - hollow-wide-00)
    (held-by-lift-000-solid-narrow-10 ?o - solid-narrow-10)
    (held-by-lift-100-any-narrow-11 ?o - any-narrow-11)
    (held-by-lift-100-hollow-tall-wide-01 ?o - hollow-tall-wide-01)
    (held-by-lift-100-hollow-wide-00 ?o - hollow-wide-00)
    (held-by-lift-100-solid-narrow-10 ?o - solid-narrow-10)
    (held-by-lift-101-any-narrow-11 ?o - any-narrow-11)
    (held-by-lift-101-hollow-tall-wide-01 ?o - hollow-tall-wide-01)
    (held-by-lift-101-hollow-wide-00 ?o - hollow-wide-00)
    (held-by-lift-101-solid-narrow-10 ?o - solid-narrow-10)
    (x-minus-17 ?from ?to - x-cell)
    (x-minus-15 ?from ?to - x-cell)
    (x-minus-14 ?from ?to - x-cell)
    (x-minus-13 ?from ?to - x-cell)
    (x-minus-11 ?from ?to - x-cell)
    (x-minus-9 ?from ?to - x-cell)
    (x-minus-8 ?from ?to - x-cell)
    (x-minus-7 ?from ?to - x-cell)
    (x-minus-6 ?from ?to - x-cell)
    (x-minus-5 ?from ?to - x-cell)
    (x-minus-4 ?from ?to - x-cell)
    (x-minus-3 ?from ?to - x-cell)
    (x-minus-1 ?from ?to - x-cell)
    (x-plus-1 ?from ?to - x-cell)
    (x-plus-2 ?from ?to - x-cell)
    (x-plus-4 ?from ?to - x-cell)
    (x-plus-5 ?from ?to - x-cell)
    (x-plus-8 ?from ?to - x-cell)
    (x-plus-12 ?from ?to - x-cell)
    (x-plus-14 ?from ?to - x-cell)
    (x-plus-19 ?from ?to - x-cell)
    (y-minus-26 ?from ?to - y-cell)
    (y-minus-23 ?from ?to - y-cell)
    (y-minus-22 ?from ?to - y-cell)
    (y-minus-20 ?from ?to - y-cell)
    (y-minus-18 ?from ?to - y-cell)
    (y-minus-17 ?from ?to - y-cell)
    (y-minus-15 ?from ?to - y-cell)
    (y-minus-12 ?from ?to - y-cell)
    (y-minus-10 ?from ?to - y-cell)
    (y-minus-9 ?from ?to - y-cell)
    (y-minus-7 ?from ?to - y-cell)
    (y-minus-6 ?from ?to - y-cell)
    (y-minus-5 ?from ?to - y-cell)
    (y-minus-4 ?from ?to - y-cell)
    (y-minus-3 ?from ?to - y-cell)
    (y-minus-1 ?from ?to - y-cell)
    (y-plus-5 ?from ?to - y-cell)
    (y-plus-6 ?from ?to - y-cell)
    (y-plus-7 ?from ?to - y-cell)
    (y-plus-9 ?from ?to - y-cell)
    (y-plus-16 ?from ?to - y-cell)
    (y-plus-19 ?from ?to - y-cell)
    (y-plus-21 ?from ?to - y-cell)
    (y-plus-22 ?from ?to - y-cell)
    (z-minus-48 ?from ?to - z-cell)
    (z-minus-47 ?from ?to - z-cell)
    (z-minus-44 ?from ?to - z-cell)
    (z-minus-43 ?from ?to - z-cell)
    (z-minus-41 ?from ?to - z-cell)
    (z-minus-40 ?from ?to - z-cell)
    (z-plus-40 ?from ?to - z-cell)
    (z-plus-41 ?from ?to - z-cell)
    (z-plus-43 ?from ?to - z-cell)
    (z-plus-44 ?from ?to - z-cell)
    (z-plus-47 ?from ?to - z-cell)
    (z-plus-48 ?from ?to - z-cell))

  (:functions (total-cost) - number)

  ; Primitive 000 on category 11 (any-narrow-11); ends held in 24 of 24 rehearsals (100%).
  ; Effect (21.8, 26.9, 216.9) mm, spread (2.2, 1.5, 5.9) mm; 24 of 24 rehearsals as promised: cost 5.
  ; Action parameters: -0.0052 -0.0279 -0.0232 0.7913 -0.0181 0.0467 -0.0143 0.8116 0.0024 0.0325 0.0113
  ; 0.4626
  (:action lift-000-any-narrow-11
    :parameters (?o - any-narrow-11 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-4 ?x ?to-x) (at-y ?o ?y) (y-plus-5 ?y ?to-y) (at-z ?o ?z) (z-plus-43 ?z ?to-z))
    :effect (and (not (hand-empty)) (not (done ?o)) (held-by-lift-000-any-narrow-11 ?o) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 5)))

  ; Put down what lift-000-any-narrow-11 lifted.
  (:action put-down-lift-000-any-narrow-11
    :parameters (?o - any-narrow-11 ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-000-any-narrow-11 ?o) (at-z ?o ?z) (z-minus-43 ?z ?to-z))
    :effect (and (not (held-by-lift-000-any-narrow-11 ?o)) (not (done ?o)) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 000 on category 01 (hollow-tall-wide-01); ends held in 17 of 17 rehearsals (100%).
  ; Effect (2.5, 102.6, 220.3) mm, spread (6.8, 6.6, 5.9) mm; 17 of 17 rehearsals as promised: cost 6.
  ; Action parameters: -0.0052 -0.0279 -0.0232 0.7913 -0.0181 0.0467 -0.0143 0.8116 0.0024 0.0325 0.0113
  ; 0.4626
  (:action lift-000-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-1 ?x ?to-x) (at-y ?o ?y) (y-plus-21 ?y ?to-y) (at-z ?o ?z) (z-plus-44 ?z ?to-z))
    :effect (and (not (hand-empty)) (not (done ?o)) (held-by-lift-000-hollow-tall-wide-01 ?o) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 6)))

  ; Put down what lift-000-hollow-tall-wide-01 lifted.
  (:action put-down-lift-000-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-000-hollow-tall-wide-01 ?o) (at-x ?o ?x) (x-minus-1 ?x ?to-x) (at-y ?o ?y) (y-minus-1 ?y ?to-y) (at-z ?o ?z) (z-minus-44 ?z ?to-z))
    :effect (and (not (held-by-lift-000-hollow-tall-wide-01 ?o)) (not (done ?o)) (hand-empty) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 000 on category 00 (hollow-wide-00); ends held in 19 of 22 rehearsals (86%).
  ; Effect (3, 79.9, 220.7) mm, spread (4.1, 22.1, 14.5) mm; 17 of 22 rehearsals as promised: cost 30.
  ; Action parameters: -0.0052 -0.0279 -0.0232 0.7913 -0.0181 0.0467 -0.0143 0.8116 0.0024 0.0325 0.0113
  ; 0.4626
  (:action lift-000-hollow-wide-00
    :parameters (?o - hollow-wide-00 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-1 ?x ?to-x) (at-y ?o ?y) (y-plus-16 ?y ?to-y) (at-z ?o ?z) (z-plus-44 ?z ?to-z))
    :effect (and (not (hand-empty)) (not (done ?o)) (held-by-lift-000-hollow-wide-00 ?o) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 30)))

  ; Put down what lift-000-hollow-wide-00 lifted.
  (:action put-down-lift-000-hollow-wide-00
    :parameters (?o - hollow-wide-00 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-000-hollow-wide-00 ?o) (at-x ?o ?x) (x-minus-1 ?x ?to-x) (at-y ?o ?y) (y-minus-1 ?y ?to-y) (at-z ?o ?z) (z-minus-44 ?z ?to-z))
    :effect (and (not (held-by-lift-000-hollow-wide-00 ?o)) (not (done ?o)) (hand-empty) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 000 on category 10 (solid-narrow-10); ends held in 4 of 37 rehearsals (11%).
  ; Effect (18.7, 28.3, 221.1) mm, spread (7.6, 1.3, 4.1) mm; 4 of 37 rehearsals as promised: cost 206.
  ; Action parameters: -0.0052 -0.0279 -0.0232 0.7913 -0.0181 0.0467 -0.0143 0.8116 0.0024 0.0325 0.0113
  ; 0.4626
  (:action lift-000-solid-narrow-10
    :parameters (?o - solid-narrow-10 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-4 ?x ?to-x) (at-y ?o ?y) (y-plus-6 ?y ?to-y) (at-z ?o ?z) (z-plus-44 ?z ?to-z))
    :effect (and (not (hand-empty)) (not (done ?o)) (held-by-lift-000-solid-narrow-10 ?o) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 206)))

  ; Put down what lift-000-solid-narrow-10 lifted.
  (:action put-down-lift-000-solid-narrow-10
    :parameters (?o - solid-narrow-10 ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-000-solid-narrow-10 ?o) (at-y ?o ?y) (y-minus-1 ?y ?to-y) (at-z ?o ?z) (z-minus-44 ?z ?to-z))
    :effect (and (not (held-by-lift-000-solid-narrow-10 ?o)) (not (done ?o)) (hand-empty) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 100 on category 11 (any-narrow-11); ends held in 24 of 24 rehearsals (100%).
  ; Effect (-67.2, -24.9, 201.6) mm, spread (1.3, 1.2, 3.1) mm; 24 of 24 rehearsals as promised: cost 5.
  ; Action parameters: 0.0384 0.0210 0.0226 0.8485 0.0177 -0.0303 -0.0186 0.9698 -0.0492 -0.0223 -0.0102
  ; 0.2028
  (:action lift-100-any-narrow-11
    :parameters (?o - any-narrow-11 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-13 ?x ?to-x) (at-y ?o ?y) (y-minus-5 ?y ?to-y) (at-z ?o ?z) (z-plus-40 ?z ?to-z))
    :effect (and (not (hand-empty)) (not (done ?o)) (held-by-lift-100-any-narrow-11 ?o) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 5)))

  ; Put down what lift-100-any-narrow-11 lifted.
  (:action put-down-lift-100-any-narrow-11
    :parameters (?o - any-narrow-11 ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-100-any-narrow-11 ?o) (at-z ?o ?z) (z-minus-40 ?z ?to-z))
    :effect (and (not (held-by-lift-100-any-narrow-11 ?o)) (not (done ?o)) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 100 on category 01 (hollow-tall-wide-01); ends held in 9 of 17 rehearsals (53%).
  ; Effect (-53.2, -99, 204) mm, spread (12.7, 7.6, 4.2) mm; 9 of 17 rehearsals as promised: cost 65.
  ; Action parameters: 0.0384 0.0210 0.0226 0.8485 0.0177 -0.0303 -0.0186 0.9698 -0.0492 -0.0223 -0.0102
  ; 0.2028
  (:action lift-100-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-11 ?x ?to-x) (at-y ?o ?y) (y-minus-20 ?y ?to-y) (at-z ?o ?z) (z-plus-41 ?z ?to-z))
    :effect (and (not (hand-empty)) (not (done ?o)) (held-by-lift-100-hollow-tall-wide-01 ?o) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 65)))

  ; Put down what lift-100-hollow-tall-wide-01 lifted.
  (:action put-down-lift-100-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01 ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-100-hollow-tall-wide-01 ?o) (at-z ?o ?z) (z-minus-41 ?z ?to-z))
    :effect (and (not (held-by-lift-100-hollow-tall-wide-01 ?o)) (not (done ?o)) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 100 on category 00 (hollow-wide-00); ends held in 9 of 22 rehearsals (41%).
  ; Effect (-66, -36.7, 200.2) mm, spread (13.1, 25.4, 2.4) mm; 7 of 22 rehearsals as promised: cost 111.
  ; Action parameters: 0.0384 0.0210 0.0226 0.8485 0.0177 -0.0303 -0.0186 0.9698 -0.0492 -0.0223 -0.0102
  ; 0.2028
  (:action lift-100-hollow-wide-00
    :parameters (?o - hollow-wide-00 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-13 ?x ?to-x) (at-y ?o ?y) (y-minus-7 ?y ?to-y) (at-z ?o ?z) (z-plus-40 ?z ?to-z))
    :effect (and (not (hand-empty)) (not (done ?o)) (held-by-lift-100-hollow-wide-00 ?o) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 111)))

  ; Put down what lift-100-hollow-wide-00 lifted.
  (:action put-down-lift-100-hollow-wide-00
    :parameters (?o - hollow-wide-00 ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-100-hollow-wide-00 ?o) (at-y ?o ?y) (y-minus-1 ?y ?to-y) (at-z ?o ?z) (z-minus-40 ?z ?to-z))
    :effect (and (not (held-by-lift-100-hollow-wide-00 ?o)) (not (done ?o)) (hand-empty) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 100 on category 10 (solid-narrow-10); ends held in 11 of 37 rehearsals (30%).
  ; Effect (-72.8, -23, 202) mm, spread (3, 0.9, 3.5) mm; 11 of 37 rehearsals as promised: cost 119.
  ; Action parameters: 0.0384 0.0210 0.0226 0.8485 0.0177 -0.0303 -0.0186 0.9698 -0.0492 -0.0223 -0.0102
  ; 0.2028
  (:action lift-100-solid-narrow-10
    :parameters (?o - solid-narrow-10 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-15 ?x ?to-x) (at-y ?o ?y) (y-minus-5 ?y ?to-y) (at-z ?o ?z) (z-plus-40 ?z ?to-z))
    :effect (and (not (hand-empty)) (not (done ?o)) (held-by-lift-100-solid-narrow-10 ?o) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 119)))

  ; Put down what lift-100-solid-narrow-10 lifted.
  (:action put-down-lift-100-solid-narrow-10
    :parameters (?o - solid-narrow-10 ?x ?to-x - x-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-100-solid-narrow-10 ?o) (at-x ?o ?x) (x-plus-1 ?x ?to-x) (at-z ?o ?z) (z-minus-40 ?z ?to-z))
    :effect (and (not (held-by-lift-100-solid-narrow-10 ?o)) (not (done ?o)) (hand-empty) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 101 on category 11 (any-narrow-11); ends held in 24 of 24 rehearsals (100%).
  ; Effect (-16.7, -52.5, 238.1) mm, spread (0.8, 0.9, 6.8) mm; 24 of 24 rehearsals as promised: cost 5.
  ; Action parameters: -0.0114 0.0179 -0.0178 0.8519 0.0490 -0.0142 0.0217 0.2391 -0.0278 -0.0494 0.0317
  ; 0.4785
  (:action lift-101-any-narrow-11
    :parameters (?o - any-narrow-11 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-3 ?x ?to-x) (at-y ?o ?y) (y-minus-10 ?y ?to-y) (at-z ?o ?z) (z-plus-48 ?z ?to-z))
    :effect (and (not (hand-empty)) (not (done ?o)) (held-by-lift-101-any-narrow-11 ?o) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 5)))

  ; Put down what lift-101-any-narrow-11 lifted.
  (:action put-down-lift-101-any-narrow-11
    :parameters (?o - any-narrow-11 ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-101-any-narrow-11 ?o) (at-y ?o ?y) (y-minus-1 ?y ?to-y) (at-z ?o ?z) (z-minus-48 ?z ?to-z))
    :effect (and (not (held-by-lift-101-any-narrow-11 ?o)) (not (done ?o)) (hand-empty) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 101 on category 01 (hollow-tall-wide-01); ends held in 12 of 17 rehearsals (71%).
  ; Effect (-31, -128.2, 238.3) mm, spread (9, 5.7, 12.1) mm; 12 of 17 rehearsals as promised: cost 39.
  ; Action parameters: -0.0114 0.0179 -0.0178 0.8519 0.0490 -0.0142 0.0217 0.2391 -0.0278 -0.0494 0.0317
  ; 0.4785
  (:action lift-101-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-6 ?x ?to-x) (at-y ?o ?y) (y-minus-26 ?y ?to-y) (at-z ?o ?z) (z-plus-48 ?z ?to-z))
    :effect (and (not (hand-empty)) (not (done ?o)) (held-by-lift-101-hollow-tall-wide-01 ?o) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 39)))

  ; Put down what lift-101-hollow-tall-wide-01 lifted.
  (:action put-down-lift-101-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01 ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-101-hollow-tall-wide-01 ?o) (at-z ?o ?z) (z-minus-48 ?z ?to-z))
    :effect (and (not (held-by-lift-101-hollow-tall-wide-01 ?o)) (not (done ?o)) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 101 on category 00 (hollow-wide-00); ends held in 4 of 22 rehearsals (18%).
  ; Effect (-21.1, -88.4, 236.6) mm, spread (9.7, 37.2, 14.8) mm; 3 of 22 rehearsals as promised: cost 180.
  ; Action parameters: -0.0114 0.0179 -0.0178 0.8519 0.0490 -0.0142 0.0217 0.2391 -0.0278 -0.0494 0.0317
  ; 0.4785
  (:action lift-101-hollow-wide-00
    :parameters (?o - hollow-wide-00 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-4 ?x ?to-x) (at-y ?o ?y) (y-minus-18 ?y ?to-y) (at-z ?o ?z) (z-plus-47 ?z ?to-z))
    :effect (and (not (hand-empty)) (not (done ?o)) (held-by-lift-101-hollow-wide-00 ?o) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 180)))

  ; Put down what lift-101-hollow-wide-00 lifted.
  (:action put-down-lift-101-hollow-wide-00
    :parameters (?o - hollow-wide-00 ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-101-hollow-wide-00 ?o) (at-z ?o ?z) (z-minus-47 ?z ?to-z))
    :effect (and (not (held-by-lift-101-hollow-wide-00 ?o)) (not (done ?o)) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 101 on category 10 (solid-narrow-10); ends held in 6 of 37 rehearsals (16%).
  ; Effect (-18.3, -61.1, 237) mm, spread (6.3, 21.4, 13.3) mm; 5 of 37 rehearsals as promised: cost 188.
  ; Action parameters: -0.0114 0.0179 -0.0178 0.8519 0.0490 -0.0142 0.0217 0.2391 -0.0278 -0.0494 0.0317
  ; 0.4785
  (:action lift-101-solid-narrow-10
    :parameters (?o - solid-narrow-10 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-4 ?x ?to-x) (at-y ?o ?y) (y-minus-12 ?y ?to-y) (at-z ?o ?z) (z-plus-47 ?z ?to-z))
    :effect (and (not (hand-empty)) (not (done ?o)) (held-by-lift-101-solid-narrow-10 ?o) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 188)))

  ; Put down what lift-101-solid-narrow-10 lifted.
  (:action put-down-lift-101-solid-narrow-10
    :parameters (?o - solid-narrow-10 ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-101-solid-narrow-10 ?o) (at-z ?o ?z) (z-minus-47 ?z ?to-z))
    :effect (and (not (held-by-lift-101-solid-narrow-10 ?o)) (not (done ?o)) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 110 on category 10 (solid-narrow-10); ends at rest in 37 of 37 rehearsals (100%).
  ; Effect (-69.9, -27.2, 0) mm, spread (15.6, 26.9, 0) mm; 32 of 37 rehearsals as promised: cost 18.
  ; Action parameters: 0.0469 0.0292 -0.0161 0.8821 -0.0361 -0.0441 -0.0126 0.4855 -0.0346 -0.0186 0.0158
  ; 0.6283
  (:action pull-110-solid-narrow-10
    :parameters (?o - solid-narrow-10 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-14 ?x ?to-x) (at-y ?o ?y) (y-minus-5 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 18)))

  ; Primitive 010 on category 01 (hollow-tall-wide-01); ends at rest in 17 of 17 rehearsals (100%).
  ; Effect (-23.3, 36.1, 0) mm, spread (19.4, 15.7, 0) mm; 16 of 17 rehearsals as promised: cost 12.
  ; Action parameters: 0.0408 -0.0469 -0.0166 0.2379 -0.0406 0.0352 0.0208 0.8142 0.0055 0.0480 0.0086
  ; 0.9706
  (:action pull-left-010-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-5 ?x ?to-x) (at-y ?o ?y) (y-plus-7 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 12)))

  ; Primitive 010 on category 10 (solid-narrow-10); ends at rest in 37 of 37 rehearsals (100%).
  ; Effect (-34.1, 30.1, 0) mm, spread (27.1, 22.4, 0) mm; 34 of 37 rehearsals as promised: cost 12.
  ; Action parameters: 0.0408 -0.0469 -0.0166 0.2379 -0.0406 0.0352 0.0208 0.8142 0.0055 0.0480 0.0086
  ; 0.9706
  (:action pull-left-010-solid-narrow-10
    :parameters (?o - solid-narrow-10 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-7 ?x ?to-x) (at-y ?o ?y) (y-plus-6 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 12)))

  ; Primitive 110 on category 11 (any-narrow-11); ends at rest in 24 of 24 rehearsals (100%).
  ; Effect (-84.1, -47.4, 0) mm, spread (3.9, 25.2, 0) mm; 23 of 24 rehearsals as promised: cost 9.
  ; Action parameters: 0.0469 0.0292 -0.0161 0.8821 -0.0361 -0.0441 -0.0126 0.4855 -0.0346 -0.0186 0.0158
  ; 0.6283
  (:action pull-right-110-any-narrow-11
    :parameters (?o - any-narrow-11 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-17 ?x ?to-x) (at-y ?o ?y) (y-minus-9 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 9)))

  ; Primitive 110 on category 00 (hollow-wide-00); ends at rest in 22 of 22 rehearsals (100%).
  ; Effect (-45.3, -48.8, 0) mm, spread (25.5, 34.8, 0) mm; 14 of 22 rehearsals as promised: cost 48.
  ; Action parameters: 0.0469 0.0292 -0.0161 0.8821 -0.0361 -0.0441 -0.0126 0.4855 -0.0346 -0.0186 0.0158
  ; 0.6283
  (:action pull-right-110-hollow-wide-00
    :parameters (?o - hollow-wide-00 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-9 ?x ?to-x) (at-y ?o ?y) (y-minus-10 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 48)))

  ; Primitive 001 on category 11 (any-narrow-11); ends at rest in 24 of 24 rehearsals (100%).
  ; Effect (93.4, -26.7, 0) mm, spread (4.2, 3.6, 0) mm; 24 of 24 rehearsals as promised: cost 5.
  ; Action parameters: -0.0447 0.0137 -0.0062 0.6854 0.0498 -0.0211 -0.0213 0.0600 0.0456 -0.0117 0.0436
  ; 0.5137
  (:action push-forward-001-any-narrow-11
    :parameters (?o - any-narrow-11 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-19 ?x ?to-x) (at-y ?o ?y) (y-minus-5 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 5)))

  ; Primitive 001 on category 10 (solid-narrow-10); ends at rest in 37 of 37 rehearsals (100%).
  ; Effect (71.6, -20.3, 0) mm, spread (32, 17.4, 0) mm; 28 of 37 rehearsals as promised: cost 31.
  ; Action parameters: -0.0447 0.0137 -0.0062 0.6854 0.0498 -0.0211 -0.0213 0.0600 0.0456 -0.0117 0.0436
  ; 0.5137
  (:action push-forward-001-solid-narrow-10
    :parameters (?o - solid-narrow-10 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-14 ?x ?to-x) (at-y ?o ?y) (y-minus-4 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 31)))

  ; Primitive 011 on category 11 (any-narrow-11); ends at rest in 24 of 24 rehearsals (100%).
  ; Effect (60.5, 44.1, 0) mm, spread (9.6, 10.7, 0) mm; 23 of 24 rehearsals as promised: cost 9.
  ; Action parameters: -0.0230 -0.0192 0.0034 0.7848 0.0407 0.0488 -0.0091 0.1211 -0.0073 0.0300 0.0166
  ; 0.6436
  (:action push-forward-left-011-any-narrow-11
    :parameters (?o - any-narrow-11 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-12 ?x ?to-x) (at-y ?o ?y) (y-plus-9 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 9)))

  ; Primitive 101 on category 10 (solid-narrow-10); ends at rest in 31 of 37 rehearsals (84%).
  ; Effect (27.1, -49.5, 0) mm, spread (23, 32.9, 0) mm; 24 of 37 rehearsals as promised: cost 45.
  ; Action parameters: -0.0114 0.0179 -0.0178 0.8519 0.0490 -0.0142 0.0217 0.2391 -0.0278 -0.0494 0.0317
  ; 0.4785
  (:action push-forward-right-101-solid-narrow-10
    :parameters (?o - solid-narrow-10 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-5 ?x ?to-x) (at-y ?o ?y) (y-minus-10 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 45)))

  ; Primitive 111 on category 10 (solid-narrow-10); ends at rest in 37 of 37 rehearsals (100%).
  ; Effect (19.8, -29.1, 0) mm, spread (14.1, 17.7, 0) mm; 37 of 37 rehearsals as promised: cost 4.
  ; Action parameters: -0.0384 0.0500 -0.0169 0.1077 0.0101 -0.0394 -0.0002 0.7312 -0.0145 -0.0157 0.0349
  ; 0.6062
  (:action push-forward-right-111-solid-narrow-10
    :parameters (?o - solid-narrow-10 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-4 ?x ?to-x) (at-y ?o ?y) (y-minus-6 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 4)))

  ; Primitive 000 on category 00 (hollow-wide-00); ends at rest in 3 of 22 rehearsals (14%).
  ; Effect (-0.6, 26.2, 0) mm, spread (1.1, 5, 0) mm; 3 of 22 rehearsals as promised: cost 180.
  ; Action parameters: -0.0052 -0.0279 -0.0232 0.7913 -0.0181 0.0467 -0.0143 0.8116 0.0024 0.0325 0.0113
  ; 0.4626
  (:action push-left-000-hollow-wide-00
    :parameters (?o - hollow-wide-00 ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-y ?o ?y) (y-plus-5 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 180)))

  ; Primitive 000 on category 10 (solid-narrow-10); ends at rest in 33 of 37 rehearsals (89%).
  ; Effect (3.2, 32.6, 0) mm, spread (5.6, 24.1, 0) mm; 33 of 37 rehearsals as promised: cost 15.
  ; Action parameters: -0.0052 -0.0279 -0.0232 0.7913 -0.0181 0.0467 -0.0143 0.8116 0.0024 0.0325 0.0113
  ; 0.4626
  (:action push-left-000-solid-narrow-10
    :parameters (?o - solid-narrow-10 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-1 ?x ?to-x) (at-y ?o ?y) (y-plus-7 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 15)))

  ; Primitive 010 on category 11 (any-narrow-11); ends at rest in 21 of 24 rehearsals (88%).
  ; Effect (-37.5, 112.3, 0) mm, spread (21.3, 39.7, 0) mm; 19 of 24 rehearsals as promised: cost 27.
  ; Action parameters: 0.0408 -0.0469 -0.0166 0.2379 -0.0406 0.0352 0.0208 0.8142 0.0055 0.0480 0.0086
  ; 0.9706
  (:action push-left-010-any-narrow-11
    :parameters (?o - any-narrow-11 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-8 ?x ?to-x) (at-y ?o ?y) (y-plus-22 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 27)))

  ; Primitive 011 on category 01 (hollow-tall-wide-01); ends at rest in 17 of 17 rehearsals (100%).
  ; Effect (11.8, 95.4, 0) mm, spread (12.5, 16.6, 0) mm; 17 of 17 rehearsals as promised: cost 6.
  ; Action parameters: -0.0230 -0.0192 0.0034 0.7848 0.0407 0.0488 -0.0091 0.1211 -0.0073 0.0300 0.0166
  ; 0.6436
  (:action push-left-011-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-2 ?x ?to-x) (at-y ?o ?y) (y-plus-19 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 6)))

  ; Primitive 011 on category 00 (hollow-wide-00); ends at rest in 21 of 22 rehearsals (95%).
  ; Effect (12.3, 42.8, 0) mm, spread (16.2, 25.2, 0) mm; 20 of 22 rehearsals as promised: cost 14.
  ; Action parameters: -0.0230 -0.0192 0.0034 0.7848 0.0407 0.0488 -0.0091 0.1211 -0.0073 0.0300 0.0166
  ; 0.6436
  (:action push-left-011-hollow-wide-00
    :parameters (?o - hollow-wide-00 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-2 ?x ?to-x) (at-y ?o ?y) (y-plus-9 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 14)))

  ; Primitive 001 on category 01 (hollow-tall-wide-01); ends at rest in 17 of 17 rehearsals (100%).
  ; Effect (23, -77.1, 0) mm, spread (38.8, 26.2, 0) mm; 12 of 17 rehearsals as promised: cost 39.
  ; Action parameters: -0.0447 0.0137 -0.0062 0.6854 0.0498 -0.0211 -0.0213 0.0600 0.0456 -0.0117 0.0436
  ; 0.5137
  (:action push-right-001-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-5 ?x ?to-x) (at-y ?o ?y) (y-minus-15 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 39)))

  ; Primitive 100 on category 01 (hollow-tall-wide-01); ends at rest in 8 of 17 rehearsals (47%).
  ; Effect (-0.1, -35.3, 0) mm, spread (15.7, 25.5, 0) mm; 8 of 17 rehearsals as promised: cost 76.
  ; Action parameters: 0.0384 0.0210 0.0226 0.8485 0.0177 -0.0303 -0.0186 0.9698 -0.0492 -0.0223 -0.0102
  ; 0.2028
  (:action push-right-100-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01 ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-y ?o ?y) (y-minus-7 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 76)))

  ; Primitive 101 on category 01 (hollow-tall-wide-01); ends at rest in 5 of 17 rehearsals (29%).
  ; Effect (0.9, -84.4, 0) mm, spread (30.5, 18, 0) mm; 4 of 17 rehearsals as promised: cost 135.
  ; Action parameters: -0.0114 0.0179 -0.0178 0.8519 0.0490 -0.0142 0.0217 0.2391 -0.0278 -0.0494 0.0317
  ; 0.4785
  (:action push-right-101-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01 ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-y ?o ?y) (y-minus-17 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 135)))

  ; Primitive 101 on category 00 (hollow-wide-00); ends at rest in 18 of 22 rehearsals (82%).
  ; Effect (2.9, -59.4, 0) mm, spread (31, 37, 0) mm; 9 of 22 rehearsals as promised: cost 89.
  ; Action parameters: -0.0114 0.0179 -0.0178 0.8519 0.0490 -0.0142 0.0217 0.2391 -0.0278 -0.0494 0.0317
  ; 0.4785
  (:action push-right-101-hollow-wide-00
    :parameters (?o - hollow-wide-00 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-1 ?x ?to-x) (at-y ?o ?y) (y-minus-12 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 89)))

  ; Primitive 110 on category 01 (hollow-tall-wide-01); ends at rest in 17 of 17 rehearsals (100%).
  ; Effect (-45.3, -113.9, 0) mm, spread (22.3, 19.7, 0) mm; 16 of 17 rehearsals as promised: cost 12.
  ; Action parameters: 0.0469 0.0292 -0.0161 0.8821 -0.0361 -0.0441 -0.0126 0.4855 -0.0346 -0.0186 0.0158
  ; 0.6283
  (:action push-right-110-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-9 ?x ?to-x) (at-y ?o ?y) (y-minus-23 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 12)))

  ; Primitive 111 on category 11 (any-narrow-11); ends at rest in 23 of 24 rehearsals (96%).
  ; Effect (41.3, -112.3, 0) mm, spread (16.3, 43.9, 0) mm; 20 of 24 rehearsals as promised: cost 22.
  ; Action parameters: -0.0384 0.0500 -0.0169 0.1077 0.0101 -0.0394 -0.0002 0.7312 -0.0145 -0.0157 0.0349
  ; 0.6062
  (:action push-right-111-any-narrow-11
    :parameters (?o - any-narrow-11 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-8 ?x ?to-x) (at-y ?o ?y) (y-minus-22 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 22)))

  ; Primitive 111 on category 01 (hollow-tall-wide-01); ends at rest in 17 of 17 rehearsals (100%).
  ; Effect (-1.8, -20.5, 0) mm, spread (9.5, 16, 0) mm; 17 of 17 rehearsals as promised: cost 6.
  ; Action parameters: -0.0384 0.0500 -0.0169 0.1077 0.0101 -0.0394 -0.0002 0.7312 -0.0145 -0.0157 0.0349
  ; 0.6062
  (:action push-right-111-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01 ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-y ?o ?y) (y-minus-4 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 6)))

  ; Primitive 111 on category 00 (hollow-wide-00); ends at rest in 22 of 22 rehearsals (100%).
  ; Effect (6.3, -17.5, 0) mm, spread (6.3, 16.5, 0) mm; 21 of 22 rehearsals as promised: cost 10.
  ; Action parameters: -0.0384 0.0500 -0.0169 0.1077 0.0101 -0.0394 -0.0002 0.7312 -0.0145 -0.0157 0.0349
  ; 0.6062
  (:action push-right-111-hollow-wide-00
    :parameters (?o - hollow-wide-00 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-1 ?x ?to-x) (at-y ?o ?y) (y-minus-3 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 10)))

  ; Note that an object is within its goal region.
  (:action reach-goal
    :parameters (?o - movable ?x - x-cell ?y - y-cell ?z - z-cell)
    :precondition (and (ready) (at-x ?o ?x) (at-y ?o ?y) (at-z ?o ?z) (goal-xy ?o ?x ?y) (goal-z ?o ?z))
    :effect (and (done ?o) (increase (total-cost) 0)))

  ; Left out:
  ; pull-100-solid-narrow-10: scatters more than it moves.
  ; pull-left-010-hollow-wide-00: scatters more than it moves.
  ; push-forward-left-011-solid-narrow-10: scatters more than it moves.
  ; push-forward-right-001-hollow-wide-00: scatters more than it moves.
  ; push-right-100-hollow-wide-00: scatters more than it moves.
)
