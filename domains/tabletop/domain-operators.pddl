; Learned domain tabletop, encoding operators. Printed by neurosym; do not edit.
; One action moves all axes.
; Cells of 5 mm: 121 along x, 121 along y, 51 along z (counted from where an object rests).
; (x-plus-3 ?from ?to): ?to is 3 cells further along x than ?from, and on the table.
; After a lift the hand is full: only the put-down of that lift applies.
; Cost of a step: 1 + round(-100 ln((k + 1) / (n + 2))), k successes in n rehearsals.

(define (domain tabletop)
  (:requirements :strips :typing :action-costs)

  (:types
    movable x-cell y-cell z-cell - object
    any-tall-narrow-01 hollow-wide-10 solid-11 solid-low-narrow-00 - movable)

  (:predicates
    (hand-empty)
    (ready)
    (at-x ?o - movable ?c - x-cell)
    (at-y ?o - movable ?c - y-cell)
    (at-z ?o - movable ?c - z-cell)
    (goal-xy ?o - movable ?x - x-cell ?y - y-cell)
    (goal-z ?o - movable ?z - z-cell)
    (done ?o - movable)
    (held-by-lift-001-hollow-wide-10 ?o - hollow-wide-10)
    (held-by-lift-011-solid-low-narrow-00 ?o - solid-low-narrow-00)
    (held-by-lift-101-hollow-wide-10 ?o - hollow-wide-10)
    (held-by-lift-101-solid-low-narrow-00 ?o - solid-low-narrow-00)
    (x-minus-14 ?from ?to - x-cell)
    (x-minus-11 ?from ?to - x-cell)
    (x-minus-10 ?from ?to - x-cell)
    (x-minus-5 ?from ?to - x-cell)
    (x-minus-4 ?from ?to - x-cell)
    (x-minus-2 ?from ?to - x-cell)
    (x-minus-1 ?from ?to - x-cell)
    (x-plus-2 ?from ?to - x-cell)
    (x-plus-8 ?from ?to - x-cell)
    (x-plus-11 ?from ?to - x-cell)
    (x-plus-12 ?from ?to - x-cell)
    (x-plus-19 ?from ?to - x-cell)
    (y-minus-18 ?from ?to - y-cell)
    (y-minus-14 ?from ?to - y-cell)
    (y-minus-13 ?from ?to - y-cell)
    (y-minus-6 ?from ?to - y-cell)
    (y-minus-5 ?from ?to - y-cell)
    (y-minus-4 ?from ?to - y-cell)
    (y-minus-3 ?from ?to - y-cell)
    (y-minus-2 ?from ?to - y-cell)
    (y-minus-1 ?from ?to - y-cell)
    (y-plus-1 ?from ?to - y-cell)
    (y-plus-3 ?from ?to - y-cell)
    (y-plus-10 ?from ?to - y-cell)
    (z-minus-50 ?from ?to - z-cell)
    (z-minus-43 ?from ?to - z-cell)
    (z-minus-40 ?from ?to - z-cell)
    (z-plus-40 ?from ?to - z-cell)
    (z-plus-43 ?from ?to - z-cell)
    (z-plus-50 ?from ?to - z-cell))

  (:functions (total-cost) - number)

  ; Primitive 001 on category 10 (hollow-wide-10); ends held in 18 of 31 rehearsals (58%).
  ; Effect (57.4, -89.5, 212.9) mm, spread (24, 11.1, 2) mm; 18 of 31 rehearsals as promised: cost 56.
  ; Action parameters: -0.0449 0.0494 0.0217 0.7218 -0.0483 -0.0482 -0.0047 0.0933 0.0408 -0.0157 0.0092
  ; 0.1631
  (:action lift-001-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-11 ?x ?to-x) (at-y ?o ?y) (y-minus-18 ?y ?to-y) (at-z ?o ?z) (z-plus-43 ?z ?to-z))
    :effect (and (not (hand-empty)) (not (done ?o)) (held-by-lift-001-hollow-wide-10 ?o) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 56)))

  ; Put down what lift-001-hollow-wide-10 lifted.
  (:action put-down-lift-001-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-001-hollow-wide-10 ?o) (at-y ?o ?y) (y-minus-1 ?y ?to-y) (at-z ?o ?z) (z-minus-43 ?z ?to-z))
    :effect (and (not (held-by-lift-001-hollow-wide-10 ?o)) (not (done ?o)) (hand-empty) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 011 on category 00 (solid-low-narrow-00); ends held in 20 of 21 rehearsals (95%).
  ; Effect (92.5, -3.9, 201.5) mm, spread (1, 1.9, 1.5) mm; 20 of 21 rehearsals as promised: cost 10.
  ; Action parameters: -0.0438 -0.0234 -0.0121 0.8436 -0.0159 0.0336 0.0003 0.3924 0.0478 0.0006 -0.0112
  ; 0.0739
  (:action lift-011-solid-low-narrow-00
    :parameters (?o - solid-low-narrow-00 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-19 ?x ?to-x) (at-y ?o ?y) (y-minus-1 ?y ?to-y) (at-z ?o ?z) (z-plus-40 ?z ?to-z))
    :effect (and (not (hand-empty)) (not (done ?o)) (held-by-lift-011-solid-low-narrow-00 ?o) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 10)))

  ; Put down what lift-011-solid-low-narrow-00 lifted.
  (:action put-down-lift-011-solid-low-narrow-00
    :parameters (?o - solid-low-narrow-00 ?x ?to-x - x-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-011-solid-low-narrow-00 ?o) (at-x ?o ?x) (x-minus-1 ?x ?to-x) (at-z ?o ?z) (z-minus-40 ?z ?to-z))
    :effect (and (not (held-by-lift-011-solid-low-narrow-00 ?o)) (not (done ?o)) (hand-empty) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 101 on category 10 (hollow-wide-10); ends held in 28 of 31 rehearsals (90%).
  ; Effect (-23.2, -70.2, 250.3) mm, spread (20.3, 10.4, 12.2) mm; 28 of 31 rehearsals as promised: cost 14.
  ; Action parameters: 0.0411 0.0467 0.0091 0.5894 -0.0415 0.0458 -0.0180 0.9954 -0.0352 0.0053 0.0434
  ; 0.1403
  (:action lift-101-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-5 ?x ?to-x) (at-y ?o ?y) (y-minus-14 ?y ?to-y) (at-z ?o ?z) (z-plus-50 ?z ?to-z))
    :effect (and (not (hand-empty)) (not (done ?o)) (held-by-lift-101-hollow-wide-10 ?o) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 14)))

  ; Put down what lift-101-hollow-wide-10 lifted.
  (:action put-down-lift-101-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-101-hollow-wide-10 ?o) (at-y ?o ?y) (y-minus-1 ?y ?to-y) (at-z ?o ?z) (z-minus-50 ?z ?to-z))
    :effect (and (not (held-by-lift-101-hollow-wide-10 ?o)) (not (done ?o)) (hand-empty) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 101 on category 00 (solid-low-narrow-00); ends held in 11 of 21 rehearsals (52%).
  ; Effect (10, -6.4, 248.7) mm, spread (2.9, 5.4, 8.3) mm; 11 of 21 rehearsals as promised: cost 66.
  ; Action parameters: 0.0411 0.0467 0.0091 0.5894 -0.0415 0.0458 -0.0180 0.9954 -0.0352 0.0053 0.0434
  ; 0.1403
  (:action lift-101-solid-low-narrow-00
    :parameters (?o - solid-low-narrow-00 ?x ?to-x - x-cell ?y ?to-y - y-cell ?z ?to-z - z-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-2 ?x ?to-x) (at-y ?o ?y) (y-minus-1 ?y ?to-y) (at-z ?o ?z) (z-plus-50 ?z ?to-z))
    :effect (and (not (hand-empty)) (not (done ?o)) (held-by-lift-101-solid-low-narrow-00 ?o) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 66)))

  ; Put down what lift-101-solid-low-narrow-00 lifted.
  (:action put-down-lift-101-solid-low-narrow-00
    :parameters (?o - solid-low-narrow-00 ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-101-solid-low-narrow-00 ?o) (at-z ?o ?z) (z-minus-50 ?z ?to-z))
    :effect (and (not (held-by-lift-101-solid-low-narrow-00 ?o)) (not (done ?o)) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 101 on category 01 (any-tall-narrow-01); ends at rest in 20 of 21 rehearsals (95%).
  ; Effect (-57.1, -15.4, 0) mm, spread (36.7, 23.4, 0) mm; 16 of 21 rehearsals as promised: cost 31.
  ; Action parameters: 0.0411 0.0467 0.0091 0.5894 -0.0415 0.0458 -0.0180 0.9954 -0.0352 0.0053 0.0434
  ; 0.1403
  (:action pull-101-any-tall-narrow-01
    :parameters (?o - any-tall-narrow-01 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-11 ?x ?to-x) (at-y ?o ?y) (y-minus-3 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 31)))

  ; Primitive 101 on category 11 (solid-11); ends at rest in 26 of 27 rehearsals (96%).
  ; Effect (-70.5, -24.9, 0) mm, spread (43.3, 15.4, 0) mm; 19 of 27 rehearsals as promised: cost 38.
  ; Action parameters: 0.0411 0.0467 0.0091 0.5894 -0.0415 0.0458 -0.0180 0.9954 -0.0352 0.0053 0.0434
  ; 0.1403
  (:action pull-101-solid-11
    :parameters (?o - solid-11 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-14 ?x ?to-x) (at-y ?o ?y) (y-minus-5 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 38)))

  ; Primitive 110 on category 11 (solid-11); ends at rest in 27 of 27 rehearsals (100%).
  ; Effect (-48.7, 15.4, 0) mm, spread (26.5, 12, 0) mm; 27 of 27 rehearsals as promised: cost 5.
  ; Action parameters: 0.0500 -0.0146 -0.0250 0.0000 -0.0500 -0.0073 -0.0207 0.7026 -0.0252 0.0269 -0.0231
  ; 0.5562
  (:action pull-110-solid-11
    :parameters (?o - solid-11 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-10 ?x ?to-x) (at-y ?o ?y) (y-plus-3 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 5)))

  ; Primitive 110 on category 00 (solid-low-narrow-00); ends at rest in 21 of 21 rehearsals (100%).
  ; Effect (-20.6, 5, 0) mm, spread (19.7, 5.2, 0) mm; 21 of 21 rehearsals as promised: cost 5.
  ; Action parameters: 0.0500 -0.0146 -0.0250 0.0000 -0.0500 -0.0073 -0.0207 0.7026 -0.0252 0.0269 -0.0231
  ; 0.5562
  (:action pull-110-solid-low-narrow-00
    :parameters (?o - solid-low-narrow-00 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-4 ?x ?to-x) (at-y ?o ?y) (y-plus-1 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 5)))

  ; Primitive 100 on category 01 (any-tall-narrow-01); ends at rest in 15 of 21 rehearsals (71%).
  ; Effect (-11.6, -17.9, 0) mm, spread (11.2, 17, 0) mm; 15 of 21 rehearsals as promised: cost 37.
  ; Action parameters: 0.0086 0.0175 0.0250 0.3711 -0.0038 -0.0110 0.0052 0.5848 -0.0500 -0.0500 -0.0135
  ; 1.0000
  (:action pull-right-100-any-tall-narrow-01
    :parameters (?o - any-tall-narrow-01 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-2 ?x ?to-x) (at-y ?o ?y) (y-minus-4 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 37)))

  ; Primitive 100 on category 10 (hollow-wide-10); ends at rest in 20 of 31 rehearsals (65%).
  ; Effect (-22, -29.6, 0) mm, spread (12.4, 17.8, 0) mm; 20 of 31 rehearsals as promised: cost 46.
  ; Action parameters: 0.0086 0.0175 0.0250 0.3711 -0.0038 -0.0110 0.0052 0.5848 -0.0500 -0.0500 -0.0135
  ; 1.0000
  (:action pull-right-100-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-4 ?x ?to-x) (at-y ?o ?y) (y-minus-6 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 46)))

  ; Primitive 100 on category 11 (solid-11); ends at rest in 25 of 27 rehearsals (93%).
  ; Effect (-11.2, -10.5, 0) mm, spread (8.1, 10.6, 0) mm; 25 of 27 rehearsals as promised: cost 12.
  ; Action parameters: 0.0086 0.0175 0.0250 0.3711 -0.0038 -0.0110 0.0052 0.5848 -0.0500 -0.0500 -0.0135
  ; 1.0000
  (:action pull-right-100-solid-11
    :parameters (?o - solid-11 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-2 ?x ?to-x) (at-y ?o ?y) (y-minus-2 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 12)))

  ; Primitive 000 on category 11 (solid-11); ends at rest in 26 of 27 rehearsals (96%).
  ; Effect (42.1, -0.2, 0) mm, spread (34.1, 15.2, 0) mm; 23 of 27 rehearsals as promised: cost 20.
  ; Action parameters: -0.0422 0.0440 -0.0246 0.8394 -0.0283 -0.0031 -0.0093 0.1348 0.0387 0.0048 -0.0050
  ; 0.6425
  (:action push-forward-000-solid-11
    :parameters (?o - solid-11 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-8 ?x ?to-x))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 20)))

  ; Primitive 001 on category 11 (solid-11); ends at rest in 26 of 27 rehearsals (96%).
  ; Effect (53, 5.9, 0) mm, spread (29.2, 18.2, 0) mm; 21 of 27 rehearsals as promised: cost 29.
  ; Action parameters: -0.0449 0.0494 0.0217 0.7218 -0.0483 -0.0482 -0.0047 0.0933 0.0408 -0.0157 0.0092
  ; 0.1631
  (:action push-forward-001-solid-11
    :parameters (?o - solid-11 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-11 ?x ?to-x) (at-y ?o ?y) (y-plus-1 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 29)))

  ; Primitive 001 on category 00 (solid-low-narrow-00); ends at rest in 19 of 21 rehearsals (90%).
  ; Effect (39.6, -8.2, 0) mm, spread (30.3, 17.1, 0) mm; 18 of 21 rehearsals as promised: cost 20.
  ; Action parameters: -0.0449 0.0494 0.0217 0.7218 -0.0483 -0.0482 -0.0047 0.0933 0.0408 -0.0157 0.0092
  ; 0.1631
  (:action push-forward-001-solid-low-narrow-00
    :parameters (?o - solid-low-narrow-00 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-8 ?x ?to-x) (at-y ?o ?y) (y-minus-2 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 20)))

  ; Primitive 011 on category 01 (any-tall-narrow-01); ends at rest in 19 of 21 rehearsals (90%).
  ; Effect (58.2, -13.8, 0) mm, spread (40.5, 16.3, 0) mm; 11 of 21 rehearsals as promised: cost 66.
  ; Action parameters: -0.0438 -0.0234 -0.0121 0.8436 -0.0159 0.0336 0.0003 0.3924 0.0478 0.0006 -0.0112
  ; 0.0739
  (:action push-forward-011-any-tall-narrow-01
    :parameters (?o - any-tall-narrow-01 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-12 ?x ?to-x) (at-y ?o ?y) (y-minus-3 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 66)))

  ; Primitive 011 on category 11 (solid-11); ends at rest in 27 of 27 rehearsals (100%).
  ; Effect (57.3, -8.2, 0) mm, spread (38.4, 9.1, 0) mm; 19 of 27 rehearsals as promised: cost 38.
  ; Action parameters: -0.0438 -0.0234 -0.0121 0.8436 -0.0159 0.0336 0.0003 0.3924 0.0478 0.0006 -0.0112
  ; 0.0739
  (:action push-forward-011-solid-11
    :parameters (?o - solid-11 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-11 ?x ?to-x) (at-y ?o ?y) (y-minus-2 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 38)))

  ; Primitive 010 on category 00 (solid-low-narrow-00); ends at rest in 21 of 21 rehearsals (100%).
  ; Effect (10.6, 50.1, 0) mm, spread (6, 32.8, 0) mm; 21 of 21 rehearsals as promised: cost 5.
  ; Action parameters: -0.0359 -0.0423 0.0169 0.1285 -0.0300 0.0438 -0.0118 0.2417 0.0500 0.0362 -0.0119
  ; 0.0852
  (:action push-left-010-solid-low-narrow-00
    :parameters (?o - solid-low-narrow-00 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-2 ?x ?to-x) (at-y ?o ?y) (y-plus-10 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 5)))

  ; Primitive 000 on category 10 (hollow-wide-10); ends at rest in 31 of 31 rehearsals (100%).
  ; Effect (-6, -64.1, 0) mm, spread (15.6, 27.5, 0) mm; 28 of 31 rehearsals as promised: cost 14.
  ; Action parameters: -0.0422 0.0440 -0.0246 0.8394 -0.0283 -0.0031 -0.0093 0.1348 0.0387 0.0048 -0.0050
  ; 0.6425
  (:action push-right-000-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?x ?to-x - x-cell ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-1 ?x ?to-x) (at-y ?o ?y) (y-minus-13 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 14)))

  ; Primitive 100 on category 00 (solid-low-narrow-00); ends at rest in 21 of 21 rehearsals (100%).
  ; Effect (-1.5, -3.4, 0) mm, spread (1.3, 3, 0) mm; 21 of 21 rehearsals as promised: cost 5.
  ; Action parameters: 0.0086 0.0175 0.0250 0.3711 -0.0038 -0.0110 0.0052 0.5848 -0.0500 -0.0500 -0.0135
  ; 1.0000
  (:action stay-100-solid-low-narrow-00
    :parameters (?o - solid-low-narrow-00 ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-y ?o ?y) (y-minus-1 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 5)))

  ; Note that an object is within its goal region.
  (:action reach-goal
    :parameters (?o - movable ?x - x-cell ?y - y-cell ?z - z-cell)
    :precondition (and (ready) (at-x ?o ?x) (at-y ?o ?y) (at-z ?o ?z) (goal-xy ?o ?x ?y) (goal-z ?o ?z))
    :effect (and (done ?o) (increase (total-cost) 0)))

  ; Left out:
  ; pull-left-110-hollow-wide-10: scatters more than it moves.
  ; push-forward-000-solid-low-narrow-00: scatters more than it moves.
  ; push-forward-010-any-tall-narrow-01: scatters more than it moves.
  ; push-forward-010-solid-11: scatters more than it moves.
  ; push-forward-left-001-any-tall-narrow-01: scatters more than it moves.
  ; push-forward-left-111-hollow-wide-10: scatters more than it moves.
  ; push-left-011-hollow-wide-10: scatters more than it moves.
  ; stay-000-any-tall-narrow-01: scatters more than it moves.
  ; stay-010-hollow-wide-10: moves less than half a cell.
  ; stay-110-any-tall-narrow-01: scatters more than it moves.
  ; stay-111-any-tall-narrow-01: scatters more than it moves.
  ; stay-111-solid-11: scatters more than it moves.
  ; stay-111-solid-low-narrow-00: scatters more than it moves.
)
