; Learned domain tabletop, encoding stepwise. Printed by neurosym; do not edit.
; One action moves one axis: the named action the first, finish-... the others.
; Cells of 5 mm: 121 along x, 121 along y, 52 along z (counted from where an object rests).
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
    (held-by-lift-011-any-tall-narrow-01 ?o - any-tall-narrow-01)
    (held-by-lift-011-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (held-by-lift-101-hollow-wide-10 ?o - hollow-wide-10)
    (held-by-lift-101-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (held-by-lift-111-hollow-wide-10 ?o - hollow-wide-10)
    (held-by-lift-111-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (moving-lift-011-any-tall-narrow-01-y ?o - any-tall-narrow-01)
    (moving-lift-011-any-tall-narrow-01-z ?o - any-tall-narrow-01)
    (moving-lift-011-solid-low-narrow-11-y ?o - solid-low-narrow-11)
    (moving-lift-011-solid-low-narrow-11-z ?o - solid-low-narrow-11)
    (moving-lift-101-hollow-wide-10-z ?o - hollow-wide-10)
    (moving-put-down-lift-101-hollow-wide-10-z ?o - hollow-wide-10)
    (moving-lift-101-solid-low-narrow-11-y ?o - solid-low-narrow-11)
    (moving-lift-101-solid-low-narrow-11-z ?o - solid-low-narrow-11)
    (moving-lift-111-hollow-wide-10-y ?o - hollow-wide-10)
    (moving-lift-111-hollow-wide-10-z ?o - hollow-wide-10)
    (moving-put-down-lift-111-hollow-wide-10-z ?o - hollow-wide-10)
    (moving-lift-111-solid-low-narrow-11-y ?o - solid-low-narrow-11)
    (moving-lift-111-solid-low-narrow-11-z ?o - solid-low-narrow-11)
    (moving-put-down-lift-111-solid-low-narrow-11-z ?o - solid-low-narrow-11)
    (moving-place-forward-100-solid-low-narrow-11-y ?o - solid-low-narrow-11)
    (moving-pull-010-any-tall-narrow-01-y ?o - any-tall-narrow-01)
    (moving-pull-010-hollow-wide-10-y ?o - hollow-wide-10)
    (moving-pull-010-solid-low-00-y ?o - solid-low-00)
    (moving-pull-010-solid-low-narrow-11-y ?o - solid-low-narrow-11)
    (moving-push-forward-100-any-tall-narrow-01-y ?o - any-tall-narrow-01)
    (moving-push-forward-100-hollow-wide-10-y ?o - hollow-wide-10)
    (moving-push-forward-110-solid-low-00-y ?o - solid-low-00)
    (moving-push-left-110-any-tall-narrow-01-y ?o - any-tall-narrow-01)
    (moving-push-left-110-solid-low-narrow-11-y ?o - solid-low-narrow-11)
    (moving-push-right-000-solid-low-narrow-11-y ?o - solid-low-narrow-11)
    (moving-push-right-101-any-tall-narrow-01-y ?o - any-tall-narrow-01)
    (moving-push-right-101-solid-low-00-y ?o - solid-low-00)
    (x-minus-17 ?from ?to - x-cell)
    (x-minus-16 ?from ?to - x-cell)
    (x-minus-15 ?from ?to - x-cell)
    (x-minus-13 ?from ?to - x-cell)
    (x-minus-8 ?from ?to - x-cell)
    (x-minus-5 ?from ?to - x-cell)
    (x-minus-2 ?from ?to - x-cell)
    (x-plus-1 ?from ?to - x-cell)
    (x-plus-3 ?from ?to - x-cell)
    (x-plus-4 ?from ?to - x-cell)
    (x-plus-6 ?from ?to - x-cell)
    (x-plus-7 ?from ?to - x-cell)
    (x-plus-8 ?from ?to - x-cell)
    (x-plus-9 ?from ?to - x-cell)
    (x-plus-11 ?from ?to - x-cell)
    (x-plus-12 ?from ?to - x-cell)
    (x-plus-15 ?from ?to - x-cell)
    (x-plus-19 ?from ?to - x-cell)
    (y-minus-30 ?from ?to - y-cell)
    (y-minus-23 ?from ?to - y-cell)
    (y-minus-10 ?from ?to - y-cell)
    (y-minus-9 ?from ?to - y-cell)
    (y-minus-8 ?from ?to - y-cell)
    (y-minus-7 ?from ?to - y-cell)
    (y-minus-5 ?from ?to - y-cell)
    (y-minus-3 ?from ?to - y-cell)
    (y-minus-2 ?from ?to - y-cell)
    (y-minus-1 ?from ?to - y-cell)
    (y-plus-3 ?from ?to - y-cell)
    (y-plus-6 ?from ?to - y-cell)
    (y-plus-9 ?from ?to - y-cell)
    (y-plus-15 ?from ?to - y-cell)
    (y-plus-22 ?from ?to - y-cell)
    (y-plus-25 ?from ?to - y-cell)
    (z-minus-51 ?from ?to - z-cell)
    (z-minus-50 ?from ?to - z-cell)
    (z-minus-49 ?from ?to - z-cell)
    (z-minus-42 ?from ?to - z-cell)
    (z-plus-42 ?from ?to - z-cell)
    (z-plus-49 ?from ?to - z-cell)
    (z-plus-50 ?from ?to - z-cell)
    (z-plus-51 ?from ?to - z-cell))

  (:functions (total-cost) - number)

  ; Primitive 011 on category 01 (any-tall-narrow-01); ends held in 11 of 11 rehearsals (100%).
  ; Effect (-40.7, 31, 248) mm, spread (0.4, 0.8, 0.4) mm; 11 of 11 rehearsals as promised: cost 9.
  ; Action parameters: -0.0065 -0.0108 -0.0016 0.5936 0.0099 -0.0198 0.0154 0.3704 -0.0472 0.0328 0.0461
  ; 0.4541
  (:action lift-011-any-tall-narrow-01
    :parameters (?o - any-tall-narrow-01 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-8 ?x ?to-x))
    :effect (and (not (ready)) (moving-lift-011-any-tall-narrow-01-y ?o) (not (hand-empty)) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 9)))
  (:action finish-lift-011-any-tall-narrow-01-y
    :parameters (?o - any-tall-narrow-01 ?y ?to-y - y-cell)
    :precondition (and (moving-lift-011-any-tall-narrow-01-y ?o) (at-y ?o ?y) (y-plus-6 ?y ?to-y))
    :effect (and (not (moving-lift-011-any-tall-narrow-01-y ?o)) (moving-lift-011-any-tall-narrow-01-z ?o) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))
  (:action finish-lift-011-any-tall-narrow-01-z
    :parameters (?o - any-tall-narrow-01 ?z ?to-z - z-cell)
    :precondition (and (moving-lift-011-any-tall-narrow-01-z ?o) (at-z ?o ?z) (z-plus-50 ?z ?to-z))
    :effect (and (not (moving-lift-011-any-tall-narrow-01-z ?o)) (ready) (held-by-lift-011-any-tall-narrow-01 ?o) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Put down what lift-011-any-tall-narrow-01 lifted.
  (:action put-down-lift-011-any-tall-narrow-01
    :parameters (?o - any-tall-narrow-01 ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-011-any-tall-narrow-01 ?o) (at-z ?o ?z) (z-minus-50 ?z ?to-z))
    :effect (and (not (held-by-lift-011-any-tall-narrow-01 ?o)) (not (done ?o)) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 011 on category 11 (solid-low-narrow-11); ends held in 22 of 22 rehearsals (100%).
  ; Effect (-40.7, 30.1, 247.2) mm, spread (0.4, 0.6, 1.1) mm; 22 of 22 rehearsals as promised: cost 5.
  ; Action parameters: -0.0065 -0.0108 -0.0016 0.5936 0.0099 -0.0198 0.0154 0.3704 -0.0472 0.0328 0.0461
  ; 0.4541
  (:action lift-011-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-8 ?x ?to-x))
    :effect (and (not (ready)) (moving-lift-011-solid-low-narrow-11-y ?o) (not (hand-empty)) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 5)))
  (:action finish-lift-011-solid-low-narrow-11-y
    :parameters (?o - solid-low-narrow-11 ?y ?to-y - y-cell)
    :precondition (and (moving-lift-011-solid-low-narrow-11-y ?o) (at-y ?o ?y) (y-plus-6 ?y ?to-y))
    :effect (and (not (moving-lift-011-solid-low-narrow-11-y ?o)) (moving-lift-011-solid-low-narrow-11-z ?o) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))
  (:action finish-lift-011-solid-low-narrow-11-z
    :parameters (?o - solid-low-narrow-11 ?z ?to-z - z-cell)
    :precondition (and (moving-lift-011-solid-low-narrow-11-z ?o) (at-z ?o ?z) (z-plus-49 ?z ?to-z))
    :effect (and (not (moving-lift-011-solid-low-narrow-11-z ?o)) (ready) (held-by-lift-011-solid-low-narrow-11 ?o) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Put down what lift-011-solid-low-narrow-11 lifted.
  (:action put-down-lift-011-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11 ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-011-solid-low-narrow-11 ?o) (at-z ?o ?z) (z-minus-49 ?z ?to-z))
    :effect (and (not (held-by-lift-011-solid-low-narrow-11 ?o)) (not (done ?o)) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 101 on category 10 (hollow-wide-10); ends held in 32 of 36 rehearsals (89%).
  ; Effect (0.8, -116.5, 256.7) mm, spread (9, 9.1, 11.7) mm; 32 of 36 rehearsals as promised: cost 15.
  ; Action parameters: -0.0032 0.0312 -0.0161 0.5028 0.0314 -0.0388 -0.0210 0.5840 0.0058 -0.0426 0.0490
  ; 0.2363
  (:action lift-101-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-y ?o ?y) (y-minus-23 ?y ?to-y))
    :effect (and (not (ready)) (moving-lift-101-hollow-wide-10-z ?o) (not (hand-empty)) (not (done ?o)) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 15)))
  (:action finish-lift-101-hollow-wide-10-z
    :parameters (?o - hollow-wide-10 ?z ?to-z - z-cell)
    :precondition (and (moving-lift-101-hollow-wide-10-z ?o) (at-z ?o ?z) (z-plus-51 ?z ?to-z))
    :effect (and (not (moving-lift-101-hollow-wide-10-z ?o)) (ready) (held-by-lift-101-hollow-wide-10 ?o) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Put down what lift-101-hollow-wide-10 lifted.
  (:action put-down-lift-101-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?y ?to-y - y-cell)
    :precondition (and (ready) (held-by-lift-101-hollow-wide-10 ?o) (at-y ?o ?y) (y-minus-1 ?y ?to-y))
    :effect (and (not (ready)) (moving-put-down-lift-101-hollow-wide-10-z ?o) (not (held-by-lift-101-hollow-wide-10 ?o)) (not (done ?o)) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))
  (:action finish-put-down-lift-101-hollow-wide-10-z
    :parameters (?o - hollow-wide-10 ?z ?to-z - z-cell)
    :precondition (and (moving-put-down-lift-101-hollow-wide-10-z ?o) (at-z ?o ?z) (z-minus-51 ?z ?to-z))
    :effect (and (not (moving-put-down-lift-101-hollow-wide-10-z ?o)) (ready) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 101 on category 11 (solid-low-narrow-11); ends held in 21 of 22 rehearsals (95%).
  ; Effect (-26.6, -45.9, 254.3) mm, spread (1.6, 1.3, 7.2) mm; 21 of 22 rehearsals as promised: cost 10.
  ; Action parameters: -0.0032 0.0312 -0.0161 0.5028 0.0314 -0.0388 -0.0210 0.5840 0.0058 -0.0426 0.0490
  ; 0.2363
  (:action lift-101-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-5 ?x ?to-x))
    :effect (and (not (ready)) (moving-lift-101-solid-low-narrow-11-y ?o) (not (hand-empty)) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 10)))
  (:action finish-lift-101-solid-low-narrow-11-y
    :parameters (?o - solid-low-narrow-11 ?y ?to-y - y-cell)
    :precondition (and (moving-lift-101-solid-low-narrow-11-y ?o) (at-y ?o ?y) (y-minus-9 ?y ?to-y))
    :effect (and (not (moving-lift-101-solid-low-narrow-11-y ?o)) (moving-lift-101-solid-low-narrow-11-z ?o) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))
  (:action finish-lift-101-solid-low-narrow-11-z
    :parameters (?o - solid-low-narrow-11 ?z ?to-z - z-cell)
    :precondition (and (moving-lift-101-solid-low-narrow-11-z ?o) (at-z ?o ?z) (z-plus-51 ?z ?to-z))
    :effect (and (not (moving-lift-101-solid-low-narrow-11-z ?o)) (ready) (held-by-lift-101-solid-low-narrow-11 ?o) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Put down what lift-101-solid-low-narrow-11 lifted.
  (:action put-down-lift-101-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11 ?z ?to-z - z-cell)
    :precondition (and (ready) (held-by-lift-101-solid-low-narrow-11 ?o) (at-z ?o ?z) (z-minus-51 ?z ?to-z))
    :effect (and (not (held-by-lift-101-solid-low-narrow-11 ?o)) (not (done ?o)) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 111 on category 10 (hollow-wide-10); ends held in 36 of 36 rehearsals (100%).
  ; Effect (44.9, 109.6, 211.1) mm, spread (8.2, 9.7, 9.5) mm; 36 of 36 rehearsals as promised: cost 4.
  ; Action parameters: 0.0136 -0.0421 -0.0198 0.9035 0.0292 -0.0456 -0.0007 0.0647 0.0457 0.0462 0.0037
  ; 0.3260
  (:action lift-111-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-9 ?x ?to-x))
    :effect (and (not (ready)) (moving-lift-111-hollow-wide-10-y ?o) (not (hand-empty)) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 4)))
  (:action finish-lift-111-hollow-wide-10-y
    :parameters (?o - hollow-wide-10 ?y ?to-y - y-cell)
    :precondition (and (moving-lift-111-hollow-wide-10-y ?o) (at-y ?o ?y) (y-plus-22 ?y ?to-y))
    :effect (and (not (moving-lift-111-hollow-wide-10-y ?o)) (moving-lift-111-hollow-wide-10-z ?o) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))
  (:action finish-lift-111-hollow-wide-10-z
    :parameters (?o - hollow-wide-10 ?z ?to-z - z-cell)
    :precondition (and (moving-lift-111-hollow-wide-10-z ?o) (at-z ?o ?z) (z-plus-42 ?z ?to-z))
    :effect (and (not (moving-lift-111-hollow-wide-10-z ?o)) (ready) (held-by-lift-111-hollow-wide-10 ?o) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Put down what lift-111-hollow-wide-10 lifted.
  (:action put-down-lift-111-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?y ?to-y - y-cell)
    :precondition (and (ready) (held-by-lift-111-hollow-wide-10 ?o) (at-y ?o ?y) (y-minus-1 ?y ?to-y))
    :effect (and (not (ready)) (moving-put-down-lift-111-hollow-wide-10-z ?o) (not (held-by-lift-111-hollow-wide-10 ?o)) (not (done ?o)) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))
  (:action finish-put-down-lift-111-hollow-wide-10-z
    :parameters (?o - hollow-wide-10 ?z ?to-z - z-cell)
    :precondition (and (moving-put-down-lift-111-hollow-wide-10-z ?o) (at-z ?o ?z) (z-minus-42 ?z ?to-z))
    :effect (and (not (moving-put-down-lift-111-hollow-wide-10-z ?o)) (ready) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 111 on category 11 (solid-low-narrow-11); ends held in 15 of 22 rehearsals (68%).
  ; Effect (32.1, 43.5, 208.9) mm, spread (0.9, 0.8, 7.7) mm; 15 of 22 rehearsals as promised: cost 42.
  ; Action parameters: 0.0136 -0.0421 -0.0198 0.9035 0.0292 -0.0456 -0.0007 0.0647 0.0457 0.0462 0.0037
  ; 0.3260
  (:action lift-111-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-6 ?x ?to-x))
    :effect (and (not (ready)) (moving-lift-111-solid-low-narrow-11-y ?o) (not (hand-empty)) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 42)))
  (:action finish-lift-111-solid-low-narrow-11-y
    :parameters (?o - solid-low-narrow-11 ?y ?to-y - y-cell)
    :precondition (and (moving-lift-111-solid-low-narrow-11-y ?o) (at-y ?o ?y) (y-plus-9 ?y ?to-y))
    :effect (and (not (moving-lift-111-solid-low-narrow-11-y ?o)) (moving-lift-111-solid-low-narrow-11-z ?o) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))
  (:action finish-lift-111-solid-low-narrow-11-z
    :parameters (?o - solid-low-narrow-11 ?z ?to-z - z-cell)
    :precondition (and (moving-lift-111-solid-low-narrow-11-z ?o) (at-z ?o ?z) (z-plus-42 ?z ?to-z))
    :effect (and (not (moving-lift-111-solid-low-narrow-11-z ?o)) (ready) (held-by-lift-111-solid-low-narrow-11 ?o) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Put down what lift-111-solid-low-narrow-11 lifted.
  (:action put-down-lift-111-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11 ?y ?to-y - y-cell)
    :precondition (and (ready) (held-by-lift-111-solid-low-narrow-11 ?o) (at-y ?o ?y) (y-minus-1 ?y ?to-y))
    :effect (and (not (ready)) (moving-put-down-lift-111-solid-low-narrow-11-z ?o) (not (held-by-lift-111-solid-low-narrow-11 ?o)) (not (done ?o)) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))
  (:action finish-put-down-lift-111-solid-low-narrow-11-z
    :parameters (?o - solid-low-narrow-11 ?z ?to-z - z-cell)
    :precondition (and (moving-put-down-lift-111-solid-low-narrow-11-z ?o) (at-z ?o ?z) (z-minus-42 ?z ?to-z))
    :effect (and (not (moving-put-down-lift-111-solid-low-narrow-11-z ?o)) (ready) (hand-empty) (not (at-z ?o ?z)) (at-z ?o ?to-z) (increase (total-cost) 0)))

  ; Primitive 100 on category 11 (solid-low-narrow-11); ends at rest in 22 of 22 rehearsals (100%).
  ; Effect (93.6, 30.2, 0) mm, spread (5.7, 12.8, 0) mm; 22 of 22 rehearsals as promised: cost 5.
  ; Action parameters: -0.0498 0.0152 -0.0024 0.5735 0.0464 0.0472 0.0204 0.3391 0.0103 -0.0458 0.0189
  ; 0.5775
  (:action place-forward-100-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-19 ?x ?to-x))
    :effect (and (not (ready)) (moving-place-forward-100-solid-low-narrow-11-y ?o) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 5)))
  (:action finish-place-forward-100-solid-low-narrow-11-y
    :parameters (?o - solid-low-narrow-11 ?y ?to-y - y-cell)
    :precondition (and (moving-place-forward-100-solid-low-narrow-11-y ?o) (at-y ?o ?y) (y-plus-6 ?y ?to-y))
    :effect (and (not (moving-place-forward-100-solid-low-narrow-11-y ?o)) (ready) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))

  ; Primitive 010 on category 01 (any-tall-narrow-01); ends at rest in 11 of 11 rehearsals (100%).
  ; Effect (-80.8, -17.4, 0) mm, spread (9.6, 5.1, 0) mm; 11 of 11 rehearsals as promised: cost 9.
  ; Action parameters: 0.0488 -0.0030 -0.0084 0.5869 -0.0345 -0.0236 -0.0057 0.0137 -0.0390 -0.0028 -0.0268
  ; 0.9408
  (:action pull-010-any-tall-narrow-01
    :parameters (?o - any-tall-narrow-01 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-16 ?x ?to-x))
    :effect (and (not (ready)) (moving-pull-010-any-tall-narrow-01-y ?o) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 9)))
  (:action finish-pull-010-any-tall-narrow-01-y
    :parameters (?o - any-tall-narrow-01 ?y ?to-y - y-cell)
    :precondition (and (moving-pull-010-any-tall-narrow-01-y ?o) (at-y ?o ?y) (y-minus-3 ?y ?to-y))
    :effect (and (not (moving-pull-010-any-tall-narrow-01-y ?o)) (ready) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))

  ; Primitive 010 on category 10 (hollow-wide-10); ends at rest in 36 of 36 rehearsals (100%).
  ; Effect (-72.5, -6.7, 0) mm, spread (45.1, 8.3, 0) mm; 23 of 36 rehearsals as promised: cost 47.
  ; Action parameters: 0.0488 -0.0030 -0.0084 0.5869 -0.0345 -0.0236 -0.0057 0.0137 -0.0390 -0.0028 -0.0268
  ; 0.9408
  (:action pull-010-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-15 ?x ?to-x))
    :effect (and (not (ready)) (moving-pull-010-hollow-wide-10-y ?o) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 47)))
  (:action finish-pull-010-hollow-wide-10-y
    :parameters (?o - hollow-wide-10 ?y ?to-y - y-cell)
    :precondition (and (moving-pull-010-hollow-wide-10-y ?o) (at-y ?o ?y) (y-minus-1 ?y ?to-y))
    :effect (and (not (moving-pull-010-hollow-wide-10-y ?o)) (ready) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))

  ; Primitive 010 on category 00 (solid-low-00); ends at rest in 31 of 31 rehearsals (100%).
  ; Effect (-66.9, -7.2, 0) mm, spread (24.4, 4.3, 0) mm; 28 of 31 rehearsals as promised: cost 14.
  ; Action parameters: 0.0488 -0.0030 -0.0084 0.5869 -0.0345 -0.0236 -0.0057 0.0137 -0.0390 -0.0028 -0.0268
  ; 0.9408
  (:action pull-010-solid-low-00
    :parameters (?o - solid-low-00 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-13 ?x ?to-x))
    :effect (and (not (ready)) (moving-pull-010-solid-low-00-y ?o) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 14)))
  (:action finish-pull-010-solid-low-00-y
    :parameters (?o - solid-low-00 ?y ?to-y - y-cell)
    :precondition (and (moving-pull-010-solid-low-00-y ?o) (at-y ?o ?y) (y-minus-1 ?y ?to-y))
    :effect (and (not (moving-pull-010-solid-low-00-y ?o)) (ready) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))

  ; Primitive 010 on category 11 (solid-low-narrow-11); ends at rest in 22 of 22 rehearsals (100%).
  ; Effect (-83.3, -25.2, 0) mm, spread (0.2, 1.2, 0) mm; 22 of 22 rehearsals as promised: cost 5.
  ; Action parameters: 0.0488 -0.0030 -0.0084 0.5869 -0.0345 -0.0236 -0.0057 0.0137 -0.0390 -0.0028 -0.0268
  ; 0.9408
  (:action pull-010-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-17 ?x ?to-x))
    :effect (and (not (ready)) (moving-pull-010-solid-low-narrow-11-y ?o) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 5)))
  (:action finish-pull-010-solid-low-narrow-11-y
    :parameters (?o - solid-low-narrow-11 ?y ?to-y - y-cell)
    :precondition (and (moving-pull-010-solid-low-narrow-11-y ?o) (at-y ?o ?y) (y-minus-5 ?y ?to-y))
    :effect (and (not (moving-pull-010-solid-low-narrow-11-y ?o)) (ready) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))

  ; Primitive 100 on category 01 (any-tall-narrow-01); ends at rest in 10 of 11 rehearsals (91%).
  ; Effect (74.7, -8, 0) mm, spread (31.6, 32.2, 0) mm; 7 of 11 rehearsals as promised: cost 50.
  ; Action parameters: -0.0498 0.0152 -0.0024 0.5735 0.0464 0.0472 0.0204 0.3391 0.0103 -0.0458 0.0189
  ; 0.5775
  (:action push-forward-100-any-tall-narrow-01
    :parameters (?o - any-tall-narrow-01 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-15 ?x ?to-x))
    :effect (and (not (ready)) (moving-push-forward-100-any-tall-narrow-01-y ?o) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 50)))
  (:action finish-push-forward-100-any-tall-narrow-01-y
    :parameters (?o - any-tall-narrow-01 ?y ?to-y - y-cell)
    :precondition (and (moving-push-forward-100-any-tall-narrow-01-y ?o) (at-y ?o ?y) (y-minus-2 ?y ?to-y))
    :effect (and (not (moving-push-forward-100-any-tall-narrow-01-y ?o)) (ready) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))

  ; Primitive 100 on category 10 (hollow-wide-10); ends at rest in 36 of 36 rehearsals (100%).
  ; Effect (54, -24.7, 0) mm, spread (40.6, 35.6, 0) mm; 21 of 36 rehearsals as promised: cost 56.
  ; Action parameters: -0.0498 0.0152 -0.0024 0.5735 0.0464 0.0472 0.0204 0.3391 0.0103 -0.0458 0.0189
  ; 0.5775
  (:action push-forward-100-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-11 ?x ?to-x))
    :effect (and (not (ready)) (moving-push-forward-100-hollow-wide-10-y ?o) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 56)))
  (:action finish-push-forward-100-hollow-wide-10-y
    :parameters (?o - hollow-wide-10 ?y ?to-y - y-cell)
    :precondition (and (moving-push-forward-100-hollow-wide-10-y ?o) (at-y ?o ?y) (y-minus-5 ?y ?to-y))
    :effect (and (not (moving-push-forward-100-hollow-wide-10-y ?o)) (ready) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))

  ; Primitive 100 on category 00 (solid-low-00); ends at rest in 28 of 31 rehearsals (90%).
  ; Effect (61.2, -2.3, 0) mm, spread (20.7, 24.2, 0) mm; 23 of 31 rehearsals as promised: cost 33.
  ; Action parameters: -0.0498 0.0152 -0.0024 0.5735 0.0464 0.0472 0.0204 0.3391 0.0103 -0.0458 0.0189
  ; 0.5775
  (:action push-forward-100-solid-low-00
    :parameters (?o - solid-low-00 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-12 ?x ?to-x))
    :effect (and (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 33)))

  ; Primitive 110 on category 00 (solid-low-00); ends at rest in 31 of 31 rehearsals (100%).
  ; Effect (40, 14.4, 0) mm, spread (29.6, 8.2, 0) mm; 31 of 31 rehearsals as promised: cost 4.
  ; Action parameters: -0.0394 -0.0500 -0.0122 0.0180 0.0297 0.0205 -0.0145 0.0265 -0.0090 0.0258 0.0327
  ; 0.6021
  (:action push-forward-110-solid-low-00
    :parameters (?o - solid-low-00 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-8 ?x ?to-x))
    :effect (and (not (ready)) (moving-push-forward-110-solid-low-00-y ?o) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 4)))
  (:action finish-push-forward-110-solid-low-00-y
    :parameters (?o - solid-low-00 ?y ?to-y - y-cell)
    :precondition (and (moving-push-forward-110-solid-low-00-y ?o) (at-y ?o ?y) (y-plus-3 ?y ?to-y))
    :effect (and (not (moving-push-forward-110-solid-low-00-y ?o)) (ready) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))

  ; Primitive 110 on category 01 (any-tall-narrow-01); ends at rest in 11 of 11 rehearsals (100%).
  ; Effect (34.2, 73.2, 0) mm, spread (20.3, 44.3, 0) mm; 5 of 11 rehearsals as promised: cost 78.
  ; Action parameters: -0.0394 -0.0500 -0.0122 0.0180 0.0297 0.0205 -0.0145 0.0265 -0.0090 0.0258 0.0327
  ; 0.6021
  (:action push-left-110-any-tall-narrow-01
    :parameters (?o - any-tall-narrow-01 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-7 ?x ?to-x))
    :effect (and (not (ready)) (moving-push-left-110-any-tall-narrow-01-y ?o) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 78)))
  (:action finish-push-left-110-any-tall-narrow-01-y
    :parameters (?o - any-tall-narrow-01 ?y ?to-y - y-cell)
    :precondition (and (moving-push-left-110-any-tall-narrow-01-y ?o) (at-y ?o ?y) (y-plus-15 ?y ?to-y))
    :effect (and (not (moving-push-left-110-any-tall-narrow-01-y ?o)) (ready) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))

  ; Primitive 110 on category 11 (solid-low-narrow-11); ends at rest in 22 of 22 rehearsals (100%).
  ; Effect (15.4, 123.9, 0) mm, spread (4.2, 24.8, 0) mm; 21 of 22 rehearsals as promised: cost 10.
  ; Action parameters: -0.0394 -0.0500 -0.0122 0.0180 0.0297 0.0205 -0.0145 0.0265 -0.0090 0.0258 0.0327
  ; 0.6021
  (:action push-left-110-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-3 ?x ?to-x))
    :effect (and (not (ready)) (moving-push-left-110-solid-low-narrow-11-y ?o) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 10)))
  (:action finish-push-left-110-solid-low-narrow-11-y
    :parameters (?o - solid-low-narrow-11 ?y ?to-y - y-cell)
    :precondition (and (moving-push-left-110-solid-low-narrow-11-y ?o) (at-y ?o ?y) (y-plus-25 ?y ?to-y))
    :effect (and (not (moving-push-left-110-solid-low-narrow-11-y ?o)) (ready) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))

  ; Primitive 000 on category 10 (hollow-wide-10); ends at rest in 36 of 36 rehearsals (100%).
  ; Effect (-0.8, -39.4, 0) mm, spread (9.9, 19.1, 0) mm; 36 of 36 rehearsals as promised: cost 4.
  ; Action parameters: -0.0030 0.0495 -0.0243 0.3450 0.0205 -0.0486 -0.0193 0.6735 -0.0189 -0.0462 0.0411
  ; 0.7939
  (:action push-right-000-hollow-wide-10
    :parameters (?o - hollow-wide-10 ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-y ?o ?y) (y-minus-8 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 4)))

  ; Primitive 000 on category 00 (solid-low-00); ends at rest in 31 of 31 rehearsals (100%).
  ; Effect (0.8, -12, 0) mm, spread (4.1, 11, 0) mm; 31 of 31 rehearsals as promised: cost 4.
  ; Action parameters: -0.0030 0.0495 -0.0243 0.3450 0.0205 -0.0486 -0.0193 0.6735 -0.0189 -0.0462 0.0411
  ; 0.7939
  (:action push-right-000-solid-low-00
    :parameters (?o - solid-low-00 ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-y ?o ?y) (y-minus-2 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 4)))

  ; Primitive 000 on category 11 (solid-low-narrow-11); ends at rest in 21 of 22 rehearsals (95%).
  ; Effect (17.5, -147.6, 0) mm, spread (4.5, 31, 0) mm; 20 of 22 rehearsals as promised: cost 14.
  ; Action parameters: -0.0030 0.0495 -0.0243 0.3450 0.0205 -0.0486 -0.0193 0.6735 -0.0189 -0.0462 0.0411
  ; 0.7939
  (:action push-right-000-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-4 ?x ?to-x))
    :effect (and (not (ready)) (moving-push-right-000-solid-low-narrow-11-y ?o) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 14)))
  (:action finish-push-right-000-solid-low-narrow-11-y
    :parameters (?o - solid-low-narrow-11 ?y ?to-y - y-cell)
    :precondition (and (moving-push-right-000-solid-low-narrow-11-y ?o) (at-y ?o ?y) (y-minus-30 ?y ?to-y))
    :effect (and (not (moving-push-right-000-solid-low-narrow-11-y ?o)) (ready) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))

  ; Primitive 101 on category 01 (any-tall-narrow-01); ends at rest in 9 of 11 rehearsals (82%).
  ; Effect (-11.7, -51.8, 0) mm, spread (18.5, 28.5, 0) mm; 8 of 11 rehearsals as promised: cost 38.
  ; Action parameters: -0.0032 0.0312 -0.0161 0.5028 0.0314 -0.0388 -0.0210 0.5840 0.0058 -0.0426 0.0490
  ; 0.2363
  (:action push-right-101-any-tall-narrow-01
    :parameters (?o - any-tall-narrow-01 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-minus-2 ?x ?to-x))
    :effect (and (not (ready)) (moving-push-right-101-any-tall-narrow-01-y ?o) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 38)))
  (:action finish-push-right-101-any-tall-narrow-01-y
    :parameters (?o - any-tall-narrow-01 ?y ?to-y - y-cell)
    :precondition (and (moving-push-right-101-any-tall-narrow-01-y ?o) (at-y ?o ?y) (y-minus-10 ?y ?to-y))
    :effect (and (not (moving-push-right-101-any-tall-narrow-01-y ?o)) (ready) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))

  ; Primitive 101 on category 00 (solid-low-00); ends at rest in 30 of 31 rehearsals (97%).
  ; Effect (3.8, -47.2, 0) mm, spread (3.4, 44.1, 0) mm; 21 of 31 rehearsals as promised: cost 42.
  ; Action parameters: -0.0032 0.0312 -0.0161 0.5028 0.0314 -0.0388 -0.0210 0.5840 0.0058 -0.0426 0.0490
  ; 0.2363
  (:action push-right-101-solid-low-00
    :parameters (?o - solid-low-00 ?x ?to-x - x-cell)
    :precondition (and (ready) (hand-empty) (at-x ?o ?x) (x-plus-1 ?x ?to-x))
    :effect (and (not (ready)) (moving-push-right-101-solid-low-00-y ?o) (not (done ?o)) (not (at-x ?o ?x)) (at-x ?o ?to-x) (increase (total-cost) 42)))
  (:action finish-push-right-101-solid-low-00-y
    :parameters (?o - solid-low-00 ?y ?to-y - y-cell)
    :precondition (and (moving-push-right-101-solid-low-00-y ?o) (at-y ?o ?y) (y-minus-9 ?y ?to-y))
    :effect (and (not (moving-push-right-101-solid-low-00-y ?o)) (ready) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 0)))

  ; Primitive 111 on category 01 (any-tall-narrow-01); ends at rest in 6 of 11 rehearsals (55%).
  ; Effect (0.3, -34, 0) mm, spread (0.5, 9.7, 0) mm; 6 of 11 rehearsals as promised: cost 63.
  ; Action parameters: 0.0136 -0.0421 -0.0198 0.9035 0.0292 -0.0456 -0.0007 0.0647 0.0457 0.0462 0.0037
  ; 0.3260
  (:action push-right-111-any-tall-narrow-01
    :parameters (?o - any-tall-narrow-01 ?y ?to-y - y-cell)
    :precondition (and (ready) (hand-empty) (at-y ?o ?y) (y-minus-7 ?y ?to-y))
    :effect (and (not (done ?o)) (not (at-y ?o ?y)) (at-y ?o ?to-y) (increase (total-cost) 63)))

  ; Note that an object is within its goal region.
  (:action reach-goal
    :parameters (?o - movable ?x - x-cell ?y - y-cell ?z - z-cell)
    :precondition (and (ready) (at-x ?o ?x) (at-y ?o ?y) (at-z ?o ?z) (goal-xy ?o ?x ?y) (goal-z ?o ?z))
    :effect (and (done ?o) (increase (total-cost) 0)))

  ; Left out:
  ; place-right-001-hollow-wide-10: scatters more than it moves.
  ; pull-right-001-any-tall-narrow-01: scatters more than it moves.
  ; pull-right-001-solid-low-00: scatters more than it moves.
  ; pull-right-001-solid-low-narrow-11: scatters more than it moves.
  ; push-left-011-hollow-wide-10: scatters more than it moves.
  ; push-left-110-hollow-wide-10: scatters more than it moves.
  ; push-right-000-any-tall-narrow-01: keeps its promise in 3 of 11 rehearsals only.
  ; push-right-111-solid-low-00: scatters more than it moves.
  ; stay-011-solid-low-00: scatters more than it moves.
)
