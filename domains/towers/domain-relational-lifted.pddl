; Learned domain tabletop, encoding relational-lifted. Printed by neurosym; do not edit.
; Every object stands at a place or is borne by another object. A step has two actions: leave-... takes an
; object from where it is, and the operator puts it elsewhere.
; What an object bears is asked for with `not` and `exists`.
; What spoiled more than half of what goes well otherwise is forbidden. Cost of a step: 1 + round(-100 ln
; p). Here p is (k + 1) / (n + 2) with k successes in n rehearsals, or the share that the grade of a pair
; stands for.
; (can-... ?t ?r ?g): an operator is likely to work with a pair; ?g says how surely. A problem tells that of
; its pairs, as a network foresees it: surely (0.9), mostly (0.7), often (0.5), seldom (0.3); or usual, as
; rehearsals showed.

(define (domain tabletop)
  (:requirements :strips :typing :negative-preconditions :existential-preconditions :action-costs)

  (:types
    movable place origin grade - object
    any-tall-narrow-11 hollow-wide-00 solid-low-10 solid-low-narrow-01 - movable)

  (:constants
    from-place from-object - origin
    nowhere - place)

  (:predicates
    (hand-empty)
    (can-be-taken ?o - movable)
    (taken ?o - movable ?from - origin)
    (stands ?o - movable ?p - place)
    (free ?p - place)
    (goal-place ?o - movable ?p - place)
    (done ?o - movable)
    (may-stand ?o - movable ?p - place)
    (overlaps ?o - movable ?p ?other - place)
    (rests-with ?t ?r - movable)
    (leans-on-001 ?t ?r - movable)
    (rests-on-011 ?t ?r - movable)
    (leans-on-101 ?t ?r - movable)
    (sits-in-111 ?t ?r - movable)
    (hollow-low-wide-to-any-low-wide-00001 ?t ?r - movable)
    (hollow-tall-wide-to-any-tall-00010 ?t ?r - movable)
    (hollow-low-wide-to-any-low-00011 ?t ?r - movable)
    (solid-low-to-any-tall-narrow-00100 ?t ?r - movable)
    (any-tall-narrow-to-hollow-low-wide-00110 ?t ?r - movable)
    (any-low-narrow-to-hollow-low-wide-00111 ?t ?r - movable)
    (hollow-low-wide-to-any-tall-01001 ?t ?r - movable)
    (solid-low-wide-to-any-01010 ?t ?r - movable)
    (hollow-low-wide-to-any-01011 ?t ?r - movable)
    (any-to-any-narrow-01100 ?t ?r - movable)
    (solid-narrow-to-hollow-low-wide-01110 ?t ?r - movable)
    (any-tall-narrow-to-solid-narrow-10001 ?t ?r - movable)
    (hollow-tall-wide-to-hollow-tall-10010 ?t ?r - movable)
    (any-tall-wide-to-solid-low-narrow-10011 ?t ?r - movable)
    (any-narrow-to-any-narrow-10100 ?t ?r - movable)
    (any-to-solid-tall-10101 ?t ?r - movable)
    (solid-low-narrow-to-hollow-low-10110 ?t ?r - movable)
    (any-low-to-any-low-10111 ?t ?r - movable)
    (any-tall-narrow-to-any-narrow-11000 ?t ?r - movable)
    (any-tall-narrow-to-solid-narrow-11001 ?t ?r - movable)
    (solid-tall-to-any-11010 ?t ?r - movable)
    (hollow-tall-wide-to-hollow-low-wide-11011 ?t ?r - movable)
    (solid-low-narrow-to-solid-narrow-11100 ?t ?r - movable)
    (any-to-any-11101 ?t ?r - movable)
    (solid-to-any-low-11110 ?t ?r - movable)
    (any-low-wide-to-hollow-low-wide-11111 ?t ?r - movable)
    (can-leans-on-001-by-000d-any-low-narrow-to-hollow-low-wide-00111 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-001a-hollow-tall-wide-to-any-tall-00010 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-001b-hollow-low-wide-to-any-low-00011 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-001c-any-low-narrow-to-hollow-low-wide-00111 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-001e-hollow-low-wide-to-any-tall-01001 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-001h-any-low-wide-to-hollow-low-wide-11111 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-010b-hollow-low-wide-to-any-tall-01001 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-010b-solid-low-narrow-to-hollow-low-10110 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-010b-solid-tall-to-any-11010 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-010c-hollow-low-wide-to-any-01011 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-010d-any-low-to-any-low-10111 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-010e-any-low-wide-to-hollow-low-wide-11111 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-100a-hollow-low-wide-to-any-low-wide-00001 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-100a-solid-low-wide-to-any-01010 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-100d-any-low-narrow-to-hollow-low-wide-00111 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-100f-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-100g-any-low-narrow-to-hollow-low-wide-00111 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-100l-solid-narrow-to-hollow-low-wide-01110 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-100m-solid-narrow-to-hollow-low-wide-01110 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-100n-solid-narrow-to-hollow-low-wide-01110 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-100o-any-narrow-to-any-narrow-10100 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-100q-solid-tall-to-any-11010 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-100r-solid-tall-to-any-11010 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-101a-solid-tall-to-any-11010 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-101a-solid-to-any-low-11110 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-101b-hollow-tall-wide-to-hollow-low-wide-11011 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-101d-any-to-any-11101 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-110a-hollow-low-wide-to-any-low-wide-00001 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-110b-hollow-tall-wide-to-any-tall-00010 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-110c-hollow-tall-wide-to-any-tall-00010 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-110d-hollow-low-wide-to-any-low-00011 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-110e-hollow-low-wide-to-any-low-00011 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-110h-hollow-low-wide-to-any-01011 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-110i-hollow-low-wide-to-any-01011 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-110j-hollow-low-wide-to-any-01011 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-110k-hollow-low-wide-to-any-01011 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-111a-any-low-to-any-low-10111 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-111a-any-to-any-11101 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-111a-solid-low-to-any-tall-narrow-00100 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-111b-solid-narrow-to-hollow-low-wide-01110 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-111d-hollow-low-wide-to-any-01011 ?t ?r - movable ?g - grade)
    (can-leans-on-001-by-111e-any-to-any-narrow-01100 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-000b-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-000c-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-000d-any-low-narrow-to-hollow-low-wide-00111 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-000g-any-low-to-any-low-10111 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-000h-any-to-any-11101 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-001a-hollow-tall-wide-to-any-tall-00010 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-001b-hollow-low-wide-to-any-low-00011 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-001c-any-low-narrow-to-hollow-low-wide-00111 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-001e-hollow-low-wide-to-any-tall-01001 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-001g-solid-low-narrow-to-hollow-low-10110 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-010a-hollow-tall-wide-to-any-tall-00010 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-010b-hollow-low-wide-to-any-tall-01001 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-010b-solid-low-narrow-to-hollow-low-10110 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-010b-solid-tall-to-any-11010 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-010c-hollow-low-wide-to-any-01011 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-010d-any-low-to-any-low-10111 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-010e-any-low-wide-to-hollow-low-wide-11111 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-100a-any-tall-narrow-to-any-narrow-11000 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-100a-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-100a-hollow-low-wide-to-any-low-wide-00001 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-100a-solid-low-narrow-to-hollow-low-10110 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-100a-solid-low-wide-to-any-01010 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-100b-solid-low-to-any-tall-narrow-00100 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-100b-solid-narrow-to-hollow-low-wide-01110 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-100c-solid-low-to-any-tall-narrow-00100 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-100d-any-low-narrow-to-hollow-low-wide-00111 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-100e-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-100g-any-low-narrow-to-hollow-low-wide-00111 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-100h-any-low-narrow-to-hollow-low-wide-00111 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-100i-hollow-low-wide-to-any-tall-01001 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-100l-any-tall-narrow-to-solid-narrow-11001 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-100l-solid-narrow-to-hollow-low-wide-01110 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-100m-solid-narrow-to-hollow-low-wide-01110 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-100n-solid-narrow-to-hollow-low-wide-01110 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-100o-any-narrow-to-any-narrow-10100 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-100p-any-tall-narrow-to-any-narrow-11000 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-100t-solid-to-any-low-11110 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-101a-solid-tall-to-any-11010 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-101a-solid-to-any-low-11110 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-101b-hollow-tall-wide-to-hollow-low-wide-11011 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-101d-any-to-any-11101 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-110a-hollow-low-wide-to-any-low-wide-00001 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-110b-hollow-tall-wide-to-any-tall-00010 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-110c-hollow-tall-wide-to-any-tall-00010 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-110d-hollow-low-wide-to-any-low-00011 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-110e-hollow-low-wide-to-any-low-00011 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-110f-any-low-narrow-to-hollow-low-wide-00111 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-110f-solid-low-narrow-to-hollow-low-10110 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-110i-hollow-low-wide-to-any-01011 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-110j-hollow-low-wide-to-any-01011 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-110k-hollow-low-wide-to-any-01011 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-110l-any-to-any-11101 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-111a-any-low-to-any-low-10111 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-111a-any-to-any-11101 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-111a-solid-low-to-any-tall-narrow-00100 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-111b-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-111b-solid-narrow-to-hollow-low-wide-01110 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-111c-solid-low-wide-to-any-01010 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-111c-solid-narrow-to-hollow-low-wide-01110 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-111d-hollow-low-wide-to-any-01011 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-111e-any-to-any-narrow-01100 ?t ?r - movable ?g - grade)
    (can-leans-on-101-by-111f-any-tall-wide-to-solid-low-narrow-10011 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-000b-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-000c-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-000d-any-low-narrow-to-hollow-low-wide-00111 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-000f-any-to-solid-tall-10101 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-000g-any-low-to-any-low-10111 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-000h-any-to-any-11101 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-000i-any-low-wide-to-hollow-low-wide-11111 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-001a-hollow-tall-wide-to-any-tall-00010 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-001c-any-low-narrow-to-hollow-low-wide-00111 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-001e-hollow-low-wide-to-any-tall-01001 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-001f-hollow-tall-wide-to-hollow-tall-10010 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-001g-solid-low-narrow-to-hollow-low-10110 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-001h-any-low-wide-to-hollow-low-wide-11111 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-010a-hollow-tall-wide-to-any-tall-00010 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-010b-hollow-low-wide-to-any-tall-01001 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-010b-solid-tall-to-any-11010 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-010d-any-low-to-any-low-10111 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-010e-any-low-wide-to-hollow-low-wide-11111 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-100a-any-tall-narrow-to-any-narrow-11000 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-100a-any-tall-narrow-to-solid-narrow-10001 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-100a-hollow-low-wide-to-any-low-wide-00001 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-100a-solid-low-narrow-to-hollow-low-10110 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-100a-solid-low-wide-to-any-01010 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-100b-solid-low-to-any-tall-narrow-00100 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-100b-solid-narrow-to-hollow-low-wide-01110 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-100c-solid-low-to-any-tall-narrow-00100 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-100d-any-low-narrow-to-hollow-low-wide-00111 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-100g-any-low-narrow-to-hollow-low-wide-00111 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-100h-any-low-narrow-to-hollow-low-wide-00111 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-100i-any-tall-wide-to-solid-low-narrow-10011 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-100i-hollow-low-wide-to-any-tall-01001 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-100j-any-to-any-narrow-01100 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-100k-any-to-any-narrow-01100 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-100l-any-tall-narrow-to-solid-narrow-11001 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-100l-solid-narrow-to-hollow-low-wide-01110 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-100m-solid-narrow-to-hollow-low-wide-01110 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-100n-solid-narrow-to-hollow-low-wide-01110 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-100o-any-narrow-to-any-narrow-10100 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-100p-any-tall-narrow-to-any-narrow-11000 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-100q-hollow-tall-wide-to-hollow-low-wide-11011 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-100q-solid-tall-to-any-11010 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-100r-solid-tall-to-any-11010 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-100s-solid-low-narrow-to-solid-narrow-11100 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-100t-solid-to-any-low-11110 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-101a-solid-tall-to-any-11010 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-101a-solid-to-any-low-11110 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-101c-solid-low-narrow-to-solid-narrow-11100 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-101d-any-to-any-11101 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-110a-hollow-low-wide-to-any-low-wide-00001 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-110b-hollow-tall-wide-to-any-tall-00010 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-110c-hollow-tall-wide-to-any-tall-00010 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-110d-hollow-low-wide-to-any-low-00011 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-110e-hollow-low-wide-to-any-low-00011 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-110f-any-low-narrow-to-hollow-low-wide-00111 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-110f-solid-low-narrow-to-hollow-low-10110 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-110g-any-low-narrow-to-hollow-low-wide-00111 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-110h-hollow-low-wide-to-any-01011 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-110i-hollow-low-wide-to-any-01011 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-110j-hollow-low-wide-to-any-01011 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-110k-hollow-low-wide-to-any-01011 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-110l-any-to-any-11101 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-111a-any-low-to-any-low-10111 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-111a-any-to-any-11101 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-111a-solid-low-to-any-tall-narrow-00100 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-111b-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-111b-solid-narrow-to-hollow-low-wide-01110 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-111c-solid-low-wide-to-any-01010 ?t ?r - movable ?g - grade)
    (can-rests-on-011-by-111c-solid-narrow-to-hollow-low-wide-01110 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-000b-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-000c-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-000d-any-low-narrow-to-hollow-low-wide-00111 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-000f-any-to-solid-tall-10101 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-000g-any-low-to-any-low-10111 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-000h-any-to-any-11101 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-001c-any-low-narrow-to-hollow-low-wide-00111 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-001e-hollow-low-wide-to-any-tall-01001 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-100a-any-tall-narrow-to-any-narrow-11000 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-100a-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-100a-any-tall-narrow-to-solid-narrow-10001 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-100a-hollow-low-wide-to-any-low-wide-00001 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-100a-solid-low-narrow-to-hollow-low-10110 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-100b-solid-low-to-any-tall-narrow-00100 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-100b-solid-narrow-to-hollow-low-wide-01110 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-100c-solid-low-to-any-tall-narrow-00100 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-100d-any-low-narrow-to-hollow-low-wide-00111 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-100e-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-100f-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-100g-any-low-narrow-to-hollow-low-wide-00111 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-100h-any-low-narrow-to-hollow-low-wide-00111 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-100i-hollow-low-wide-to-any-tall-01001 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-100j-any-to-any-narrow-01100 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-100k-any-to-any-narrow-01100 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-100l-solid-narrow-to-hollow-low-wide-01110 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-100m-solid-narrow-to-hollow-low-wide-01110 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-100n-solid-narrow-to-hollow-low-wide-01110 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-100o-any-narrow-to-any-narrow-10100 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-100p-any-tall-narrow-to-any-narrow-11000 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-100q-solid-tall-to-any-11010 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-100r-solid-tall-to-any-11010 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-101a-solid-tall-to-any-11010 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-101d-any-to-any-11101 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-110a-hollow-low-wide-to-any-low-wide-00001 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-110g-any-low-narrow-to-hollow-low-wide-00111 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-110h-hollow-low-wide-to-any-01011 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-110i-hollow-low-wide-to-any-01011 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-110j-hollow-low-wide-to-any-01011 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-110k-hollow-low-wide-to-any-01011 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-111b-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r - movable ?g - grade)
    (can-sits-in-111-by-111c-solid-low-wide-to-any-01010 ?t ?r - movable ?g - grade)
    (can-carry-to-001a-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-carry-to-001a-hollow-wide-00 ?o - hollow-wide-00)
    (can-carry-to-001b-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-carry-to-010-solid-low-10 ?o - solid-low-10)
    (can-carry-to-010-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-carry-to-010a-hollow-wide-00 ?o - hollow-wide-00)
    (can-carry-to-010b-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-carry-to-011a-hollow-wide-00 ?o - hollow-wide-00)
    (can-carry-to-011b-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-carry-to-011c-solid-low-10 ?o - solid-low-10)
    (can-carry-to-011d-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-carry-to-100-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-carry-to-100-solid-low-10 ?o - solid-low-10)
    (can-carry-to-100-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-carry-to-100a-hollow-wide-00 ?o - hollow-wide-00)
    (can-carry-to-101-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-carry-to-101-solid-low-10 ?o - solid-low-10)
    (can-carry-to-101a-hollow-wide-00 ?o - hollow-wide-00)
    (can-carry-to-101b-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-carry-to-110-solid-low-10 ?o - solid-low-10)
    (can-carry-to-110-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-carry-to-110a-hollow-wide-00 ?o - hollow-wide-00)
    (can-carry-to-110b-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-carry-to-111-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-carry-to-111a-hollow-wide-00 ?o - hollow-wide-00)
    (can-carry-to-111b-solid-low-10 ?o - solid-low-10)
    (can-carry-to-111c-any-tall-narrow-11 ?o - any-tall-narrow-11))

  (:functions
    (total-cost) - number
    (cost-of-leans-on-001-by-000d-any-low-narrow-to-hollow-low-wide-00111 ?g - grade) - number
    (cost-of-leans-on-001-by-001a-hollow-tall-wide-to-any-tall-00010 ?g - grade) - number
    (cost-of-leans-on-001-by-001b-hollow-low-wide-to-any-low-00011 ?g - grade ?from - origin) - number
    (cost-of-leans-on-001-by-001c-any-low-narrow-to-hollow-low-wide-00111 ?g - grade) - number
    (cost-of-leans-on-001-by-001e-hollow-low-wide-to-any-tall-01001 ?g - grade) - number
    (cost-of-leans-on-001-by-001h-any-low-wide-to-hollow-low-wide-11111 ?g - grade) - number
    (cost-of-leans-on-001-by-010b-hollow-low-wide-to-any-tall-01001 ?g - grade) - number
    (cost-of-leans-on-001-by-010b-solid-low-narrow-to-hollow-low-10110 ?g - grade) - number
    (cost-of-leans-on-001-by-010b-solid-tall-to-any-11010 ?g - grade ?from - origin) - number
    (cost-of-leans-on-001-by-010c-hollow-low-wide-to-any-01011 ?g - grade) - number
    (cost-of-leans-on-001-by-010d-any-low-to-any-low-10111 ?g - grade ?from - origin) - number
    (cost-of-leans-on-001-by-010e-any-low-wide-to-hollow-low-wide-11111 ?g - grade) - number
    (cost-of-leans-on-001-by-100a-hollow-low-wide-to-any-low-wide-00001 ?g - grade) - number
    (cost-of-leans-on-001-by-100a-solid-low-wide-to-any-01010 ?g - grade ?from - origin) - number
    (cost-of-leans-on-001-by-100d-any-low-narrow-to-hollow-low-wide-00111 ?g - grade) - number
    (cost-of-leans-on-001-by-100f-any-tall-narrow-to-hollow-low-wide-00110 ?g - grade) - number
    (cost-of-leans-on-001-by-100g-any-low-narrow-to-hollow-low-wide-00111 ?g - grade) - number
    (cost-of-leans-on-001-by-100l-solid-narrow-to-hollow-low-wide-01110 ?g - grade) - number
    (cost-of-leans-on-001-by-100m-solid-narrow-to-hollow-low-wide-01110 ?g - grade) - number
    (cost-of-leans-on-001-by-100n-solid-narrow-to-hollow-low-wide-01110 ?g - grade) - number
    (cost-of-leans-on-001-by-100o-any-narrow-to-any-narrow-10100 ?g - grade) - number
    (cost-of-leans-on-001-by-100q-solid-tall-to-any-11010 ?g - grade ?from - origin) - number
    (cost-of-leans-on-001-by-100r-solid-tall-to-any-11010 ?g - grade ?from - origin) - number
    (cost-of-leans-on-001-by-101a-solid-tall-to-any-11010 ?g - grade) - number
    (cost-of-leans-on-001-by-101a-solid-to-any-low-11110 ?g - grade) - number
    (cost-of-leans-on-001-by-101b-hollow-tall-wide-to-hollow-low-wide-11011 ?g - grade) - number
    (cost-of-leans-on-001-by-101d-any-to-any-11101 ?g - grade) - number
    (cost-of-leans-on-001-by-110a-hollow-low-wide-to-any-low-wide-00001 ?g - grade) - number
    (cost-of-leans-on-001-by-110b-hollow-tall-wide-to-any-tall-00010 ?g - grade) - number
    (cost-of-leans-on-001-by-110c-hollow-tall-wide-to-any-tall-00010 ?g - grade) - number
    (cost-of-leans-on-001-by-110d-hollow-low-wide-to-any-low-00011 ?g - grade) - number
    (cost-of-leans-on-001-by-110e-hollow-low-wide-to-any-low-00011 ?g - grade) - number
    (cost-of-leans-on-001-by-110h-hollow-low-wide-to-any-01011 ?g - grade) - number
    (cost-of-leans-on-001-by-110i-hollow-low-wide-to-any-01011 ?g - grade) - number
    (cost-of-leans-on-001-by-110j-hollow-low-wide-to-any-01011 ?g - grade) - number
    (cost-of-leans-on-001-by-110k-hollow-low-wide-to-any-01011 ?g - grade) - number
    (cost-of-leans-on-001-by-111a-any-low-to-any-low-10111 ?g - grade) - number
    (cost-of-leans-on-001-by-111a-any-to-any-11101 ?g - grade ?from - origin) - number
    (cost-of-leans-on-001-by-111a-solid-low-to-any-tall-narrow-00100 ?g - grade ?from - origin) - number
    (cost-of-leans-on-001-by-111b-solid-narrow-to-hollow-low-wide-01110 ?g - grade ?from - origin) - number
    (cost-of-leans-on-001-by-111d-hollow-low-wide-to-any-01011 ?g - grade) - number
    (cost-of-leans-on-001-by-111e-any-to-any-narrow-01100 ?g - grade ?from - origin) - number
    (cost-of-leans-on-101-by-000b-any-tall-narrow-to-hollow-low-wide-00110 ?g - grade ?from - origin) - number
    (cost-of-leans-on-101-by-000c-any-tall-narrow-to-hollow-low-wide-00110 ?g - grade ?from - origin) - number
    (cost-of-leans-on-101-by-000d-any-low-narrow-to-hollow-low-wide-00111 ?g - grade ?from - origin) - number
    (cost-of-leans-on-101-by-000g-any-low-to-any-low-10111 ?g - grade) - number
    (cost-of-leans-on-101-by-000h-any-to-any-11101 ?g - grade) - number
    (cost-of-leans-on-101-by-001a-hollow-tall-wide-to-any-tall-00010 ?g - grade) - number
    (cost-of-leans-on-101-by-001b-hollow-low-wide-to-any-low-00011 ?g - grade) - number
    (cost-of-leans-on-101-by-001c-any-low-narrow-to-hollow-low-wide-00111 ?g - grade ?from - origin) - number
    (cost-of-leans-on-101-by-001e-hollow-low-wide-to-any-tall-01001 ?g - grade ?from - origin) - number
    (cost-of-leans-on-101-by-001g-solid-low-narrow-to-hollow-low-10110 ?g - grade) - number
    (cost-of-leans-on-101-by-010a-hollow-tall-wide-to-any-tall-00010 ?g - grade ?from - origin) - number
    (cost-of-leans-on-101-by-010b-hollow-low-wide-to-any-tall-01001 ?g - grade ?from - origin) - number
    (cost-of-leans-on-101-by-010b-solid-low-narrow-to-hollow-low-10110 ?g - grade ?from - origin) - number
    (cost-of-leans-on-101-by-010b-solid-tall-to-any-11010 ?g - grade) - number
    (cost-of-leans-on-101-by-010c-hollow-low-wide-to-any-01011 ?g - grade) - number
    (cost-of-leans-on-101-by-010d-any-low-to-any-low-10111 ?g - grade) - number
    (cost-of-leans-on-101-by-010e-any-low-wide-to-hollow-low-wide-11111 ?g - grade) - number
    (cost-of-leans-on-101-by-100a-any-tall-narrow-to-any-narrow-11000 ?g - grade) - number
    (cost-of-leans-on-101-by-100a-any-tall-narrow-to-hollow-low-wide-00110 ?g - grade) - number
    (cost-of-leans-on-101-by-100a-hollow-low-wide-to-any-low-wide-00001 ?g - grade ?from - origin) - number
    (cost-of-leans-on-101-by-100a-solid-low-narrow-to-hollow-low-10110 ?g - grade ?from - origin) - number
    (cost-of-leans-on-101-by-100a-solid-low-wide-to-any-01010 ?g - grade) - number
    (cost-of-leans-on-101-by-100b-solid-low-to-any-tall-narrow-00100 ?g - grade) - number
    (cost-of-leans-on-101-by-100b-solid-narrow-to-hollow-low-wide-01110 ?g - grade) - number
    (cost-of-leans-on-101-by-100c-solid-low-to-any-tall-narrow-00100 ?g - grade ?from - origin) - number
    (cost-of-leans-on-101-by-100d-any-low-narrow-to-hollow-low-wide-00111 ?g - grade) - number
    (cost-of-leans-on-101-by-100e-any-tall-narrow-to-hollow-low-wide-00110 ?g - grade) - number
    (cost-of-leans-on-101-by-100g-any-low-narrow-to-hollow-low-wide-00111 ?g - grade ?from - origin) - number
    (cost-of-leans-on-101-by-100h-any-low-narrow-to-hollow-low-wide-00111 ?g - grade ?from - origin) - number
    (cost-of-leans-on-101-by-100i-hollow-low-wide-to-any-tall-01001 ?g - grade ?from - origin) - number
    (cost-of-leans-on-101-by-100l-any-tall-narrow-to-solid-narrow-11001 ?g - grade) - number
    (cost-of-leans-on-101-by-100l-solid-narrow-to-hollow-low-wide-01110 ?g - grade) - number
    (cost-of-leans-on-101-by-100m-solid-narrow-to-hollow-low-wide-01110 ?g - grade) - number
    (cost-of-leans-on-101-by-100n-solid-narrow-to-hollow-low-wide-01110 ?g - grade) - number
    (cost-of-leans-on-101-by-100o-any-narrow-to-any-narrow-10100 ?g - grade) - number
    (cost-of-leans-on-101-by-100p-any-tall-narrow-to-any-narrow-11000 ?g - grade) - number
    (cost-of-leans-on-101-by-100t-solid-to-any-low-11110 ?g - grade) - number
    (cost-of-leans-on-101-by-101a-solid-tall-to-any-11010 ?g - grade) - number
    (cost-of-leans-on-101-by-101a-solid-to-any-low-11110 ?g - grade) - number
    (cost-of-leans-on-101-by-101b-hollow-tall-wide-to-hollow-low-wide-11011 ?g - grade ?from - origin) - number
    (cost-of-leans-on-101-by-101d-any-to-any-11101 ?g - grade) - number
    (cost-of-leans-on-101-by-110a-hollow-low-wide-to-any-low-wide-00001 ?g - grade) - number
    (cost-of-leans-on-101-by-110b-hollow-tall-wide-to-any-tall-00010 ?g - grade ?from - origin) - number
    (cost-of-leans-on-101-by-110c-hollow-tall-wide-to-any-tall-00010 ?g - grade) - number
    (cost-of-leans-on-101-by-110d-hollow-low-wide-to-any-low-00011 ?g - grade) - number
    (cost-of-leans-on-101-by-110e-hollow-low-wide-to-any-low-00011 ?g - grade) - number
    (cost-of-leans-on-101-by-110f-any-low-narrow-to-hollow-low-wide-00111 ?g - grade) - number
    (cost-of-leans-on-101-by-110f-solid-low-narrow-to-hollow-low-10110 ?g - grade ?from - origin) - number
    (cost-of-leans-on-101-by-110i-hollow-low-wide-to-any-01011 ?g - grade) - number
    (cost-of-leans-on-101-by-110j-hollow-low-wide-to-any-01011 ?g - grade) - number
    (cost-of-leans-on-101-by-110k-hollow-low-wide-to-any-01011 ?g - grade) - number
    (cost-of-leans-on-101-by-110l-any-to-any-11101 ?g - grade) - number
    (cost-of-leans-on-101-by-111a-any-low-to-any-low-10111 ?g - grade ?from - origin) - number
    (cost-of-leans-on-101-by-111a-any-to-any-11101 ?g - grade) - number
    (cost-of-leans-on-101-by-111a-solid-low-to-any-tall-narrow-00100 ?g - grade ?from - origin) - number
    (cost-of-leans-on-101-by-111b-any-tall-narrow-to-hollow-low-wide-00110 ?g - grade) - number
    (cost-of-leans-on-101-by-111b-solid-narrow-to-hollow-low-wide-01110 ?g - grade) - number
    (cost-of-leans-on-101-by-111c-solid-low-wide-to-any-01010 ?g - grade) - number
    (cost-of-leans-on-101-by-111c-solid-narrow-to-hollow-low-wide-01110 ?g - grade ?from - origin) - number
    (cost-of-leans-on-101-by-111d-hollow-low-wide-to-any-01011 ?g - grade) - number
    (cost-of-leans-on-101-by-111e-any-to-any-narrow-01100 ?g - grade ?from - origin) - number
    (cost-of-leans-on-101-by-111f-any-tall-wide-to-solid-low-narrow-10011 ?g - grade) - number
    (cost-of-rests-on-011-by-000b-any-tall-narrow-to-hollow-low-wide-00110 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-000c-any-tall-narrow-to-hollow-low-wide-00110 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-000d-any-low-narrow-to-hollow-low-wide-00111 ?g - grade) - number
    (cost-of-rests-on-011-by-000f-any-to-solid-tall-10101 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-000g-any-low-to-any-low-10111 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-000h-any-to-any-11101 ?g - grade) - number
    (cost-of-rests-on-011-by-000i-any-low-wide-to-hollow-low-wide-11111 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-001a-hollow-tall-wide-to-any-tall-00010 ?g - grade) - number
    (cost-of-rests-on-011-by-001c-any-low-narrow-to-hollow-low-wide-00111 ?g - grade) - number
    (cost-of-rests-on-011-by-001e-hollow-low-wide-to-any-tall-01001 ?g - grade) - number
    (cost-of-rests-on-011-by-001f-hollow-tall-wide-to-hollow-tall-10010 ?g - grade) - number
    (cost-of-rests-on-011-by-001g-solid-low-narrow-to-hollow-low-10110 ?g - grade) - number
    (cost-of-rests-on-011-by-001h-any-low-wide-to-hollow-low-wide-11111 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-010a-hollow-tall-wide-to-any-tall-00010 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-010b-hollow-low-wide-to-any-tall-01001 ?g - grade) - number
    (cost-of-rests-on-011-by-010b-solid-tall-to-any-11010 ?g - grade) - number
    (cost-of-rests-on-011-by-010b-solid-tall-to-any-11010-laden ?g - grade) - number
    (cost-of-rests-on-011-by-010d-any-low-to-any-low-10111 ?g - grade) - number
    (cost-of-rests-on-011-by-010e-any-low-wide-to-hollow-low-wide-11111 ?g - grade) - number
    (cost-of-rests-on-011-by-100a-any-tall-narrow-to-any-narrow-11000 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-100a-any-tall-narrow-to-solid-narrow-10001 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-100a-hollow-low-wide-to-any-low-wide-00001 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-100a-hollow-low-wide-to-any-low-wide-00001-laden ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-100a-solid-low-narrow-to-hollow-low-10110 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-100a-solid-low-wide-to-any-01010 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-100b-solid-low-to-any-tall-narrow-00100 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-100b-solid-narrow-to-hollow-low-wide-01110 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-100b-solid-narrow-to-hollow-low-wide-01110-laden ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-100c-solid-low-to-any-tall-narrow-00100 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-100d-any-low-narrow-to-hollow-low-wide-00111 ?g - grade) - number
    (cost-of-rests-on-011-by-100g-any-low-narrow-to-hollow-low-wide-00111 ?g - grade) - number
    (cost-of-rests-on-011-by-100h-any-low-narrow-to-hollow-low-wide-00111 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-100i-any-tall-wide-to-solid-low-narrow-10011 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-100i-hollow-low-wide-to-any-tall-01001 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-100j-any-to-any-narrow-01100 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-100k-any-to-any-narrow-01100 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-100l-any-tall-narrow-to-solid-narrow-11001 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-100l-solid-narrow-to-hollow-low-wide-01110 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-100l-solid-narrow-to-hollow-low-wide-01110-laden ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-100m-solid-narrow-to-hollow-low-wide-01110 ?g - grade) - number
    (cost-of-rests-on-011-by-100m-solid-narrow-to-hollow-low-wide-01110-laden ?g - grade) - number
    (cost-of-rests-on-011-by-100n-solid-narrow-to-hollow-low-wide-01110 ?g - grade) - number
    (cost-of-rests-on-011-by-100n-solid-narrow-to-hollow-low-wide-01110-laden ?g - grade) - number
    (cost-of-rests-on-011-by-100o-any-narrow-to-any-narrow-10100 ?g - grade) - number
    (cost-of-rests-on-011-by-100p-any-tall-narrow-to-any-narrow-11000 ?g - grade) - number
    (cost-of-rests-on-011-by-100q-hollow-tall-wide-to-hollow-low-wide-11011 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-100q-solid-tall-to-any-11010 ?g - grade) - number
    (cost-of-rests-on-011-by-100r-solid-tall-to-any-11010 ?g - grade) - number
    (cost-of-rests-on-011-by-100s-solid-low-narrow-to-solid-narrow-11100 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-100t-solid-to-any-low-11110 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-100t-solid-to-any-low-11110-laden ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-101a-solid-tall-to-any-11010 ?g - grade) - number
    (cost-of-rests-on-011-by-101a-solid-tall-to-any-11010-laden ?g - grade) - number
    (cost-of-rests-on-011-by-101a-solid-to-any-low-11110 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-101c-solid-low-narrow-to-solid-narrow-11100 ?g - grade) - number
    (cost-of-rests-on-011-by-101d-any-to-any-11101 ?g - grade) - number
    (cost-of-rests-on-011-by-110a-hollow-low-wide-to-any-low-wide-00001 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-110b-hollow-tall-wide-to-any-tall-00010 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-110c-hollow-tall-wide-to-any-tall-00010 ?g - grade) - number
    (cost-of-rests-on-011-by-110d-hollow-low-wide-to-any-low-00011 ?g - grade) - number
    (cost-of-rests-on-011-by-110e-hollow-low-wide-to-any-low-00011 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-110f-any-low-narrow-to-hollow-low-wide-00111 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-110f-solid-low-narrow-to-hollow-low-10110 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-110g-any-low-narrow-to-hollow-low-wide-00111 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-110h-hollow-low-wide-to-any-01011 ?g - grade) - number
    (cost-of-rests-on-011-by-110i-hollow-low-wide-to-any-01011 ?g - grade) - number
    (cost-of-rests-on-011-by-110j-hollow-low-wide-to-any-01011 ?g - grade) - number
    (cost-of-rests-on-011-by-110k-hollow-low-wide-to-any-01011 ?g - grade) - number
    (cost-of-rests-on-011-by-110l-any-to-any-11101 ?g - grade) - number
    (cost-of-rests-on-011-by-111a-any-low-to-any-low-10111 ?g - grade) - number
    (cost-of-rests-on-011-by-111a-any-to-any-11101 ?g - grade) - number
    (cost-of-rests-on-011-by-111a-any-to-any-11101-laden ?g - grade) - number
    (cost-of-rests-on-011-by-111a-solid-low-to-any-tall-narrow-00100 ?g - grade) - number
    (cost-of-rests-on-011-by-111b-any-tall-narrow-to-hollow-low-wide-00110 ?g - grade) - number
    (cost-of-rests-on-011-by-111b-solid-narrow-to-hollow-low-wide-01110 ?g - grade) - number
    (cost-of-rests-on-011-by-111c-solid-low-wide-to-any-01010 ?g - grade ?from - origin) - number
    (cost-of-rests-on-011-by-111c-solid-narrow-to-hollow-low-wide-01110 ?g - grade) - number
    (cost-of-sits-in-111-by-000b-any-tall-narrow-to-hollow-low-wide-00110 ?g - grade ?from - origin) - number
    (cost-of-sits-in-111-by-000c-any-tall-narrow-to-hollow-low-wide-00110 ?g - grade ?from - origin) - number
    (cost-of-sits-in-111-by-000d-any-low-narrow-to-hollow-low-wide-00111 ?g - grade) - number
    (cost-of-sits-in-111-by-000f-any-to-solid-tall-10101 ?g - grade) - number
    (cost-of-sits-in-111-by-000g-any-low-to-any-low-10111 ?g - grade) - number
    (cost-of-sits-in-111-by-000h-any-to-any-11101 ?g - grade) - number
    (cost-of-sits-in-111-by-001c-any-low-narrow-to-hollow-low-wide-00111 ?g - grade ?from - origin) - number
    (cost-of-sits-in-111-by-001e-hollow-low-wide-to-any-tall-01001 ?g - grade) - number
    (cost-of-sits-in-111-by-100a-any-tall-narrow-to-any-narrow-11000 ?g - grade) - number
    (cost-of-sits-in-111-by-100a-any-tall-narrow-to-hollow-low-wide-00110 ?g - grade ?from - origin) - number
    (cost-of-sits-in-111-by-100a-any-tall-narrow-to-solid-narrow-10001 ?g - grade) - number
    (cost-of-sits-in-111-by-100a-hollow-low-wide-to-any-low-wide-00001 ?g - grade ?from - origin) - number
    (cost-of-sits-in-111-by-100a-solid-low-narrow-to-hollow-low-10110 ?g - grade) - number
    (cost-of-sits-in-111-by-100b-solid-low-to-any-tall-narrow-00100 ?g - grade) - number
    (cost-of-sits-in-111-by-100b-solid-narrow-to-hollow-low-wide-01110 ?g - grade) - number
    (cost-of-sits-in-111-by-100c-solid-low-to-any-tall-narrow-00100 ?g - grade) - number
    (cost-of-sits-in-111-by-100d-any-low-narrow-to-hollow-low-wide-00111 ?g - grade) - number
    (cost-of-sits-in-111-by-100e-any-tall-narrow-to-hollow-low-wide-00110 ?g - grade) - number
    (cost-of-sits-in-111-by-100f-any-tall-narrow-to-hollow-low-wide-00110 ?g - grade ?from - origin) - number
    (cost-of-sits-in-111-by-100g-any-low-narrow-to-hollow-low-wide-00111 ?g - grade ?from - origin) - number
    (cost-of-sits-in-111-by-100h-any-low-narrow-to-hollow-low-wide-00111 ?g - grade) - number
    (cost-of-sits-in-111-by-100i-hollow-low-wide-to-any-tall-01001 ?g - grade) - number
    (cost-of-sits-in-111-by-100j-any-to-any-narrow-01100 ?g - grade) - number
    (cost-of-sits-in-111-by-100k-any-to-any-narrow-01100 ?g - grade) - number
    (cost-of-sits-in-111-by-100l-solid-narrow-to-hollow-low-wide-01110 ?g - grade) - number
    (cost-of-sits-in-111-by-100m-solid-narrow-to-hollow-low-wide-01110 ?g - grade) - number
    (cost-of-sits-in-111-by-100n-solid-narrow-to-hollow-low-wide-01110 ?g - grade) - number
    (cost-of-sits-in-111-by-100o-any-narrow-to-any-narrow-10100 ?g - grade) - number
    (cost-of-sits-in-111-by-100p-any-tall-narrow-to-any-narrow-11000 ?g - grade) - number
    (cost-of-sits-in-111-by-100q-solid-tall-to-any-11010 ?g - grade) - number
    (cost-of-sits-in-111-by-100r-solid-tall-to-any-11010 ?g - grade) - number
    (cost-of-sits-in-111-by-101a-solid-tall-to-any-11010 ?g - grade) - number
    (cost-of-sits-in-111-by-101d-any-to-any-11101 ?g - grade) - number
    (cost-of-sits-in-111-by-110a-hollow-low-wide-to-any-low-wide-00001 ?g - grade ?from - origin) - number
    (cost-of-sits-in-111-by-110g-any-low-narrow-to-hollow-low-wide-00111 ?g - grade) - number
    (cost-of-sits-in-111-by-110h-hollow-low-wide-to-any-01011 ?g - grade ?from - origin) - number
    (cost-of-sits-in-111-by-110i-hollow-low-wide-to-any-01011 ?g - grade) - number
    (cost-of-sits-in-111-by-110j-hollow-low-wide-to-any-01011 ?g - grade) - number
    (cost-of-sits-in-111-by-110k-hollow-low-wide-to-any-01011 ?g - grade) - number
    (cost-of-sits-in-111-by-111b-any-tall-narrow-to-hollow-low-wide-00110 ?g - grade) - number
    (cost-of-sits-in-111-by-111c-solid-low-wide-to-any-01010 ?g - grade) - number
    (cost-of-carry-to-001a-any-tall-narrow-11 ?o - any-tall-narrow-11 ?from - origin) - number
    (cost-of-carry-to-001a-hollow-wide-00 ?o - hollow-wide-00 ?from - origin) - number
    (cost-of-carry-to-001b-solid-low-narrow-01 ?o - solid-low-narrow-01 ?from - origin) - number
    (cost-of-carry-to-010-solid-low-10 ?o - solid-low-10 ?from - origin) - number
    (cost-of-carry-to-010-solid-low-narrow-01 ?o - solid-low-narrow-01 ?from - origin) - number
    (cost-of-carry-to-010a-hollow-wide-00 ?o - hollow-wide-00 ?from - origin) - number
    (cost-of-carry-to-010b-any-tall-narrow-11 ?o - any-tall-narrow-11 ?from - origin) - number
    (cost-of-carry-to-011a-hollow-wide-00 ?o - hollow-wide-00 ?from - origin) - number
    (cost-of-carry-to-011b-solid-low-narrow-01 ?o - solid-low-narrow-01 ?from - origin) - number
    (cost-of-carry-to-011c-solid-low-10 ?o - solid-low-10 ?from - origin) - number
    (cost-of-carry-to-011d-any-tall-narrow-11 ?o - any-tall-narrow-11 ?from - origin) - number
    (cost-of-carry-to-100-any-tall-narrow-11 ?o - any-tall-narrow-11 ?from - origin) - number
    (cost-of-carry-to-100-solid-low-10 ?o - solid-low-10 ?from - origin) - number
    (cost-of-carry-to-100-solid-low-narrow-01 ?o - solid-low-narrow-01 ?from - origin) - number
    (cost-of-carry-to-100a-hollow-wide-00 ?o - hollow-wide-00 ?from - origin) - number
    (cost-of-carry-to-101-any-tall-narrow-11 ?o - any-tall-narrow-11 ?from - origin) - number
    (cost-of-carry-to-101-solid-low-10 ?o - solid-low-10 ?from - origin) - number
    (cost-of-carry-to-101a-hollow-wide-00 ?o - hollow-wide-00 ?from - origin) - number
    (cost-of-carry-to-101b-solid-low-narrow-01 ?o - solid-low-narrow-01 ?from - origin) - number
    (cost-of-carry-to-110-solid-low-10 ?o - solid-low-10 ?from - origin) - number
    (cost-of-carry-to-110-solid-low-narrow-01 ?o - solid-low-narrow-01 ?from - origin) - number
    (cost-of-carry-to-110a-hollow-wide-00 ?o - hollow-wide-00 ?from - origin) - number
    (cost-of-carry-to-110b-any-tall-narrow-11 ?o - any-tall-narrow-11 ?from - origin) - number
    (cost-of-carry-to-111-solid-low-narrow-01 ?o - solid-low-narrow-01 ?from - origin) - number
    (cost-of-carry-to-111a-hollow-wide-00 ?o - hollow-wide-00 ?from - origin) - number
    (cost-of-carry-to-111b-solid-low-10 ?o - solid-low-10 ?from - origin) - number
    (cost-of-carry-to-111c-any-tall-narrow-11 ?o - any-tall-narrow-11 ?from - origin) - number)

  ; Take an object from the place where it stands; the next action puts it elsewhere.
  (:action leave-place
    :parameters (?o - movable ?p - place)
    :precondition (and (hand-empty) (can-be-taken ?o) (stands ?o ?p))
    :effect (and (not (hand-empty)) (not (done ?o)) (not (stands ?o ?p)) (free ?p) (taken ?o from-place) (increase (total-cost) 0)))

  ; Take an object from another that bears it in the state 001: it is typically 0.48 touching units away
  ; from that, and 0.47 above it.
  (:action leave-leans-on-001
    :parameters (?o ?b - movable)
    :precondition (and (hand-empty) (can-be-taken ?o) (leans-on-001 ?o ?b))
    :effect (and (not (hand-empty)) (not (done ?o)) (not (leans-on-001 ?o ?b)) (not (rests-with ?o ?b)) (taken ?o from-object) (increase (total-cost) 0)))

  ; Take an object from another that bears it in the state 011: it is typically 0.25 touching units away
  ; from that, and 1.01 above it.
  (:action leave-rests-on-011
    :parameters (?o ?b - movable)
    :precondition (and (hand-empty) (can-be-taken ?o) (rests-on-011 ?o ?b))
    :effect (and (not (hand-empty)) (not (done ?o)) (not (rests-on-011 ?o ?b)) (not (rests-with ?o ?b)) (taken ?o from-object) (increase (total-cost) 0)))

  ; Take an object from another that bears it in the state 101: it is typically 0.44 touching units away
  ; from that, and 0.40 above it.
  (:action leave-leans-on-101
    :parameters (?o ?b - movable)
    :precondition (and (hand-empty) (can-be-taken ?o) (leans-on-101 ?o ?b))
    :effect (and (not (hand-empty)) (not (done ?o)) (not (leans-on-101 ?o ?b)) (not (rests-with ?o ?b)) (taken ?o from-object) (increase (total-cost) 0)))

  ; Take an object from another that bears it in the state 111: it is typically 0.12 touching units away
  ; from that, and 0.00 above it.
  (:action leave-sits-in-111
    :parameters (?o ?b - movable)
    :precondition (and (hand-empty) (can-be-taken ?o) (sits-in-111 ?o ?b))
    :effect (and (not (hand-empty)) (not (done ?o)) (not (sits-in-111 ?o ?b)) (not (rests-with ?o ?b)) (taken ?o from-object) (increase (total-cost) 0)))

  ; Primitive 000 on pairs of the kind 00111 (any-low-narrow-to-hollow-low-wide-00111): ends in the state
  ; 001 (leans-on-001) in 7 of 30 rehearsals, at (-0.11, 0.13, 0.43) touching units from the reference: cost
  ; 140.
  ; With a third object on the reference: 4 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 6 went so, and it is forbidden.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: -0.0171 0.0039 -0.0134 0.5509 0.0088 -0.0143 0.0124 0.1473 -0.0373 0.0177 0.0287
  ; 0.8104
  (:action leans-on-001-by-000d-any-low-narrow-to-hollow-low-wide-00111
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-low-narrow-to-hollow-low-wide-00111 ?t ?r) (can-leans-on-001-by-000d-any-low-narrow-to-hollow-low-wide-00111 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-000d-any-low-narrow-to-hollow-low-wide-00111 ?g))))

  ; Primitive 001 on pairs of the kind 00010 (hollow-tall-wide-to-any-tall-00010): ends in the state 001
  ; (leans-on-001) in 2 of 30 rehearsals, at (-0.02, -0.22, 0.67) touching units from the reference: cost
  ; 238.
  ; With a third object on the reference: 1 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0034 0.0357 -0.0044 0.8133 -0.0269 0.0418 -0.0054 0.4819 -0.0000 0.0500 0.0030
  ; 0.9931
  (:action leans-on-001-by-001a-hollow-tall-wide-to-any-tall-00010
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-tall-wide-to-any-tall-00010 ?t ?r) (can-leans-on-001-by-001a-hollow-tall-wide-to-any-tall-00010 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-001a-hollow-tall-wide-to-any-tall-00010 ?g))))

  ; Primitive 001 on pairs of the kind 00011 (hollow-low-wide-to-any-low-00011): ends in the state 001
  ; (leans-on-001) in 13 of 29 rehearsals, at (-0.18, 0.66, 0.45) touching units from the reference: cost
  ; 80.
  ; With a third object on the reference: 2 of 12 went so, and it is forbidden.
  ; With a third object under the target: 3 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0002 -0.0369 -0.0040 0.5476 -0.0078 -0.0486 0.0052 0.0857 -0.0201 0.0367 -0.0104
  ; 0.6737
  (:action leans-on-001-by-001b-hollow-low-wide-to-any-low-00011
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (hollow-low-wide-to-any-low-00011 ?t ?r) (can-leans-on-001-by-001b-hollow-low-wide-to-any-low-00011 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-001b-hollow-low-wide-to-any-low-00011 ?g ?from))))

  ; Primitive 001 on pairs of the kind 00111 (any-low-narrow-to-hollow-low-wide-00111): ends in the state
  ; 001 (leans-on-001) in 5 of 30 rehearsals, at (0.10, 0.10, 0.40) touching units from the reference: cost
  ; 168.
  ; With a third object on the reference: 5 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 6 went so, and it is forbidden.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: 0.0032 0.0299 -0.0049 0.7889 0.0455 -0.0267 0.0152 0.1240 0.0213 0.0140 0.0156 0.2049
  (:action leans-on-001-by-001c-any-low-narrow-to-hollow-low-wide-00111
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-low-narrow-to-hollow-low-wide-00111 ?t ?r) (can-leans-on-001-by-001c-any-low-narrow-to-hollow-low-wide-00111 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-001c-any-low-narrow-to-hollow-low-wide-00111 ?g))))

  ; Primitive 001 on pairs of the kind 01001 (hollow-low-wide-to-any-tall-01001): ends in the state 001
  ; (leans-on-001) in 1 of 30 rehearsals, at (0.03, -0.08, 0.75) touching units from the reference: cost
  ; 278.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0088 0.0326 0.0018 0.6484 0.0156 0.0379 0.0093 0.3897 0.0022 0.0500 -0.0091 0.3859
  (:action leans-on-001-by-001e-hollow-low-wide-to-any-tall-01001
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-tall-01001 ?t ?r) (can-leans-on-001-by-001e-hollow-low-wide-to-any-tall-01001 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-001e-hollow-low-wide-to-any-tall-01001 ?g))))

  ; Primitive 001 on pairs of the kind 11111 (any-low-wide-to-hollow-low-wide-11111): ends in the state 001
  ; (leans-on-001) in 1 of 30 rehearsals, at (0.10, 0.44, 0.72) touching units from the reference: cost 278.
  ; With a third object on the reference: 2 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 9 went so, and it is forbidden.
  ; Action parameters: -0.0057 0.0160 -0.0013 0.5883 -0.0004 -0.0119 0.0002 0.3127 0.0131 0.0499 -0.0444
  ; 0.4169
  (:action leans-on-001-by-001h-any-low-wide-to-hollow-low-wide-11111
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-low-wide-to-hollow-low-wide-11111 ?t ?r) (can-leans-on-001-by-001h-any-low-wide-to-hollow-low-wide-11111 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-001h-any-low-wide-to-hollow-low-wide-11111 ?g))))

  ; Primitive 010 on pairs of the kind 01001 (hollow-low-wide-to-any-tall-01001): ends in the state 001
  ; (leans-on-001) in 3 of 30 rehearsals, at (-0.76, 0.14, 0.38) touching units from the reference: cost
  ; 209.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0329 0.0001 -0.0141 0.9212 0.0034 0.0056 0.0190 0.3138 -0.0492 0.0115 -0.0118
  ; 0.0274
  (:action leans-on-001-by-010b-hollow-low-wide-to-any-tall-01001
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-tall-01001 ?t ?r) (can-leans-on-001-by-010b-hollow-low-wide-to-any-tall-01001 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-010b-hollow-low-wide-to-any-tall-01001 ?g))))

  ; Primitive 010 on pairs of the kind 10110 (solid-low-narrow-to-hollow-low-10110): ends in the state 001
  ; (leans-on-001) in 3 of 19 rehearsals, at (-0.86, 0.10, 0.43) touching units from the reference: cost
  ; 167.
  ; With a third object on the reference: 1 of 8 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: 0.0329 0.0001 -0.0141 0.9212 0.0034 0.0056 0.0190 0.3138 -0.0492 0.0115 -0.0118
  ; 0.0274
  (:action leans-on-001-by-010b-solid-low-narrow-to-hollow-low-10110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-low-narrow-to-hollow-low-10110 ?t ?r) (can-leans-on-001-by-010b-solid-low-narrow-to-hollow-low-10110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-010b-solid-low-narrow-to-hollow-low-10110 ?g))))

  ; Primitive 010 on pairs of the kind 11010 (solid-tall-to-any-11010): ends in the state 001 (leans-on-001)
  ; in 2 of 30 rehearsals, at (-0.89, 0.09, 0.56) touching units from the reference: cost 238.
  ; With a third object on the reference: 1 of 12 went so, and it is allowed.
  ; With a third object under the target: 2 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0329 0.0001 -0.0141 0.9212 0.0034 0.0056 0.0190 0.3138 -0.0492 0.0115 -0.0118
  ; 0.0274
  (:action leans-on-001-by-010b-solid-tall-to-any-11010
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (solid-tall-to-any-11010 ?t ?r) (can-leans-on-001-by-010b-solid-tall-to-any-11010 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-010b-solid-tall-to-any-11010 ?g ?from))))

  ; Primitive 010 on pairs of the kind 01011 (hollow-low-wide-to-any-01011): ends in the state 001 (leans-
  ; on-001) in 11 of 30 rehearsals, at (-0.24, -0.68, 0.39) touching units from the reference: cost 99.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0065 0.0370 -0.0003 0.8975 -0.0015 0.0338 -0.0124 0.2878 -0.0320 -0.0121 -0.0338
  ; 0.3051
  (:action leans-on-001-by-010c-hollow-low-wide-to-any-01011
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-01011 ?t ?r) (can-leans-on-001-by-010c-hollow-low-wide-to-any-01011 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-010c-hollow-low-wide-to-any-01011 ?g))))

  ; Primitive 010 on pairs of the kind 10111 (any-low-to-any-low-10111): ends in the state 001 (leans-
  ; on-001) in 6 of 30 rehearsals, at (-0.82, -0.03, 0.42) touching units from the reference: cost 153.
  ; With a third object on the reference: 1 of 12 went so, and it is forbidden.
  ; With a third object under the target: 2 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0282 -0.0223 -0.0141 0.6094 0.0119 0.0284 0.0177 0.0147 -0.0475 -0.0002 -0.0423
  ; 0.4675
  (:action leans-on-001-by-010d-any-low-to-any-low-10111
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-low-to-any-low-10111 ?t ?r) (can-leans-on-001-by-010d-any-low-to-any-low-10111 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-010d-any-low-to-any-low-10111 ?g ?from))))

  ; Primitive 010 on pairs of the kind 11111 (any-low-wide-to-hollow-low-wide-11111): ends in the state 001
  ; (leans-on-001) in 4 of 30 rehearsals, at (-0.29, -0.15, 0.58) touching units from the reference: cost
  ; 187.
  ; With a third object on the reference: 1 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 9 went so, and it is forbidden.
  ; Action parameters: -0.0003 -0.0066 -0.0082 0.7718 0.0249 -0.0035 -0.0226 0.1445 -0.0500 -0.0155 0.0123
  ; 0.4293
  (:action leans-on-001-by-010e-any-low-wide-to-hollow-low-wide-11111
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-low-wide-to-hollow-low-wide-11111 ?t ?r) (can-leans-on-001-by-010e-any-low-wide-to-hollow-low-wide-11111 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-010e-any-low-wide-to-hollow-low-wide-11111 ?g))))

  ; Primitive 100 on pairs of the kind 00001 (hollow-low-wide-to-any-low-wide-00001): ends in the state 001
  ; (leans-on-001) in 1 of 30 rehearsals, at (0.03, -0.01, 0.41) touching units from the reference: cost
  ; 278.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0102 -0.0030 -0.0044 0.5883 0.0169 0.0130 0.0194 0.0655 -0.0074 -0.0023 -0.0087
  ; 0.0460
  (:action leans-on-001-by-100a-hollow-low-wide-to-any-low-wide-00001
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-low-wide-00001 ?t ?r) (can-leans-on-001-by-100a-hollow-low-wide-to-any-low-wide-00001 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-100a-hollow-low-wide-to-any-low-wide-00001 ?g))))

  ; Primitive 100 on pairs of the kind 01010 (solid-low-wide-to-any-01010): ends in the state 001 (leans-
  ; on-001) in 1 of 30 rehearsals, at (0.05, -0.02, 0.43) touching units from the reference: cost 278.
  ; With a third object on the reference: 1 of 12 went so, and it is allowed.
  ; With a third object under the target: 1 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0102 -0.0030 -0.0044 0.5883 0.0169 0.0130 0.0194 0.0655 -0.0074 -0.0023 -0.0087
  ; 0.0460
  (:action leans-on-001-by-100a-solid-low-wide-to-any-01010
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (solid-low-wide-to-any-01010 ?t ?r) (can-leans-on-001-by-100a-solid-low-wide-to-any-01010 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-100a-solid-low-wide-to-any-01010 ?g ?from))))

  ; Primitive 100 on pairs of the kind 00111 (any-low-narrow-to-hollow-low-wide-00111): ends in the state
  ; 001 (leans-on-001) in 1 of 30 rehearsals, at (-0.00, -0.04, 0.41) touching units from the reference:
  ; cost 278.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 6 went so, and it is forbidden.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: 0.0001 0.0122 0.0080 0.6141 -0.0237 -0.0116 -0.0099 0.2882 -0.0054 -0.0021 -0.0242
  ; 0.4343
  (:action leans-on-001-by-100d-any-low-narrow-to-hollow-low-wide-00111
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-low-narrow-to-hollow-low-wide-00111 ?t ?r) (can-leans-on-001-by-100d-any-low-narrow-to-hollow-low-wide-00111 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-100d-any-low-narrow-to-hollow-low-wide-00111 ?g))))

  ; Primitive 100 on pairs of the kind 00110 (any-tall-narrow-to-hollow-low-wide-00110): ends in the state
  ; 001 (leans-on-001) in 2 of 30 rehearsals, at (-0.00, -0.00, 0.53) touching units from the reference:
  ; cost 238.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0112 0.0067 -0.0144 0.5509 0.0067 -0.0032 0.0052 0.1473 -0.0137 0.0038 0.0271
  ; 0.4250
  (:action leans-on-001-by-100f-any-tall-narrow-to-hollow-low-wide-00110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-tall-narrow-to-hollow-low-wide-00110 ?t ?r) (can-leans-on-001-by-100f-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-100f-any-tall-narrow-to-hollow-low-wide-00110 ?g))))

  ; Primitive 100 on pairs of the kind 00111 (any-low-narrow-to-hollow-low-wide-00111): ends in the state
  ; 001 (leans-on-001) in 7 of 30 rehearsals, at (-0.06, -0.07, 0.41) touching units from the reference:
  ; cost 140.
  ; With a third object on the reference: 4 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 6 went so, and it is forbidden.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: -0.0056 0.0024 -0.0046 0.5883 0.0225 0.0178 0.0238 0.0655 -0.0180 -0.0052 -0.0125
  ; 0.0460
  (:action leans-on-001-by-100g-any-low-narrow-to-hollow-low-wide-00111
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-low-narrow-to-hollow-low-wide-00111 ?t ?r) (can-leans-on-001-by-100g-any-low-narrow-to-hollow-low-wide-00111 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-100g-any-low-narrow-to-hollow-low-wide-00111 ?g))))

  ; Primitive 100 on pairs of the kind 01110 (solid-narrow-to-hollow-low-wide-01110): ends in the state 001
  ; (leans-on-001) in 1 of 30 rehearsals, at (-0.05, -0.02, 0.49) touching units from the reference: cost
  ; 278.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0094 -0.0018 -0.0039 0.5883 0.0171 0.0110 0.0228 0.0655 -0.0146 -0.0042 -0.0114
  ; 0.0460
  (:action leans-on-001-by-100l-solid-narrow-to-hollow-low-wide-01110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-narrow-to-hollow-low-wide-01110 ?t ?r) (can-leans-on-001-by-100l-solid-narrow-to-hollow-low-wide-01110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-100l-solid-narrow-to-hollow-low-wide-01110 ?g))))

  ; Primitive 100 on pairs of the kind 01110 (solid-narrow-to-hollow-low-wide-01110): ends in the state 001
  ; (leans-on-001) in 1 of 30 rehearsals, at (0.00, 0.01, 0.52) touching units from the reference: cost 278.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0015 0.0078 0.0021 0.6141 -0.0214 -0.0075 -0.0097 0.2882 -0.0035 0.0035 -0.0207
  ; 0.4343
  (:action leans-on-001-by-100m-solid-narrow-to-hollow-low-wide-01110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-narrow-to-hollow-low-wide-01110 ?t ?r) (can-leans-on-001-by-100m-solid-narrow-to-hollow-low-wide-01110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-100m-solid-narrow-to-hollow-low-wide-01110 ?g))))

  ; Primitive 100 on pairs of the kind 01110 (solid-narrow-to-hollow-low-wide-01110): ends in the state 001
  ; (leans-on-001) in 1 of 30 rehearsals, at (0.02, -0.00, 0.49) touching units from the reference: cost
  ; 278.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0147 -0.0026 0.0063 0.7068 0.0083 0.0090 0.0033 0.0639 -0.0112 0.0037 0.0345
  ; 0.8890
  (:action leans-on-001-by-100n-solid-narrow-to-hollow-low-wide-01110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-narrow-to-hollow-low-wide-01110 ?t ?r) (can-leans-on-001-by-100n-solid-narrow-to-hollow-low-wide-01110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-100n-solid-narrow-to-hollow-low-wide-01110 ?g))))

  ; Primitive 100 on pairs of the kind 10100 (any-narrow-to-any-narrow-10100): ends in the state 001 (leans-
  ; on-001) in 1 of 30 rehearsals, at (-0.00, -0.02, 0.87) touching units from the reference: cost 278.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0018 -0.0068 -0.0152 0.7216 0.0225 -0.0263 0.0036 0.2601 0.0017 -0.0045 0.0294
  ; 0.8375
  (:action leans-on-001-by-100o-any-narrow-to-any-narrow-10100
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-narrow-to-any-narrow-10100 ?t ?r) (can-leans-on-001-by-100o-any-narrow-to-any-narrow-10100 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-100o-any-narrow-to-any-narrow-10100 ?g))))

  ; Primitive 100 on pairs of the kind 11010 (solid-tall-to-any-11010): ends in the state 001 (leans-on-001)
  ; in 2 of 30 rehearsals, at (0.08, -0.05, 0.59) touching units from the reference: cost 238.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 1 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0118 -0.0019 -0.0182 0.7326 0.0220 -0.0246 0.0072 0.2435 -0.0041 -0.0067 0.0500
  ; 0.5072
  (:action leans-on-001-by-100q-solid-tall-to-any-11010
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (solid-tall-to-any-11010 ?t ?r) (can-leans-on-001-by-100q-solid-tall-to-any-11010 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-100q-solid-tall-to-any-11010 ?g ?from))))

  ; Primitive 100 on pairs of the kind 11010 (solid-tall-to-any-11010): ends in the state 001 (leans-on-001)
  ; in 1 of 30 rehearsals, at (0.04, -0.00, 0.50) touching units from the reference: cost 278.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 1 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0146 0.0079 0.0035 0.7397 0.0063 0.0105 0.0056 0.0623 -0.0071 0.0024 0.0068 0.4147
  (:action leans-on-001-by-100r-solid-tall-to-any-11010
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (solid-tall-to-any-11010 ?t ?r) (can-leans-on-001-by-100r-solid-tall-to-any-11010 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-100r-solid-tall-to-any-11010 ?g ?from))))

  ; Primitive 101 on pairs of the kind 11010 (solid-tall-to-any-11010): ends in the state 001 (leans-on-001)
  ; in 1 of 30 rehearsals, at (0.96, 0.27, 0.92) touching units from the reference: cost 278.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0012 0.0019 -0.0176 0.7216 0.0245 -0.0240 0.0034 0.2601 0.0399 0.0363 -0.0465
  ; 0.0516
  (:action leans-on-001-by-101a-solid-tall-to-any-11010
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-tall-to-any-11010 ?t ?r) (can-leans-on-001-by-101a-solid-tall-to-any-11010 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-101a-solid-tall-to-any-11010 ?g))))

  ; Primitive 101 on pairs of the kind 11110 (solid-to-any-low-11110): ends in the state 001 (leans-on-001)
  ; in 1 of 30 rehearsals, at (0.31, 0.33, 0.95) touching units from the reference: cost 278.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: -0.0012 0.0019 -0.0176 0.7216 0.0245 -0.0240 0.0034 0.2601 0.0399 0.0363 -0.0465
  ; 0.0516
  (:action leans-on-001-by-101a-solid-to-any-low-11110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-to-any-low-11110 ?t ?r) (can-leans-on-001-by-101a-solid-to-any-low-11110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-101a-solid-to-any-low-11110 ?g))))

  ; Primitive 101 on pairs of the kind 11011 (hollow-tall-wide-to-hollow-low-wide-11011): ends in the state
  ; 001 (leans-on-001) in 6 of 20 rehearsals, at (0.53, 0.63, 0.48) touching units from the reference: cost
  ; 116.
  ; With a third object on the reference: 0 of 5 went so, and it is forbidden.
  ; With a third object under the target: 1 of 8 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0318 -0.0348 -0.0051 0.9006 0.0193 0.0128 0.0121 0.0527 0.0434 0.0313 0.0419
  ; 0.5906
  (:action leans-on-001-by-101b-hollow-tall-wide-to-hollow-low-wide-11011
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-tall-wide-to-hollow-low-wide-11011 ?t ?r) (can-leans-on-001-by-101b-hollow-tall-wide-to-hollow-low-wide-11011 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-101b-hollow-tall-wide-to-hollow-low-wide-11011 ?g))))

  ; Primitive 101 on pairs of the kind 11101 (any-to-any-11101): ends in the state 001 (leans-on-001) in 4
  ; of 30 rehearsals, at (0.20, -0.04, 0.52) touching units from the reference: cost 187.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0082 0.0014 -0.0166 0.5689 -0.0372 -0.0045 0.0104 0.3413 0.0232 -0.0004 0.0304
  ; 0.8891
  (:action leans-on-001-by-101d-any-to-any-11101
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-to-any-11101 ?t ?r) (can-leans-on-001-by-101d-any-to-any-11101 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-101d-any-to-any-11101 ?g))))

  ; Primitive 110 on pairs of the kind 00001 (hollow-low-wide-to-any-low-wide-00001): ends in the state 001
  ; (leans-on-001) in 4 of 30 rehearsals, at (-0.03, 0.02, 0.50) touching units from the reference: cost
  ; 187.
  ; With a third object on the reference: 1 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0007 -0.0350 -0.0089 0.5476 -0.0135 -0.0427 0.0069 0.0857 -0.0020 -0.0494 0.0384
  ; 0.1389
  (:action leans-on-001-by-110a-hollow-low-wide-to-any-low-wide-00001
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-low-wide-00001 ?t ?r) (can-leans-on-001-by-110a-hollow-low-wide-to-any-low-wide-00001 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-110a-hollow-low-wide-to-any-low-wide-00001 ?g))))

  ; Primitive 110 on pairs of the kind 00010 (hollow-tall-wide-to-any-tall-00010): ends in the state 001
  ; (leans-on-001) in 3 of 30 rehearsals, at (-0.00, 0.03, 0.56) touching units from the reference: cost
  ; 209.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0013 -0.0363 -0.0053 0.5476 -0.0158 -0.0500 0.0091 0.0857 -0.0024 -0.0500 0.0419
  ; 0.1389
  (:action leans-on-001-by-110b-hollow-tall-wide-to-any-tall-00010
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-tall-wide-to-any-tall-00010 ?t ?r) (can-leans-on-001-by-110b-hollow-tall-wide-to-any-tall-00010 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-110b-hollow-tall-wide-to-any-tall-00010 ?g))))

  ; Primitive 110 on pairs of the kind 00010 (hollow-tall-wide-to-any-tall-00010): ends in the state 001
  ; (leans-on-001) in 2 of 30 rehearsals, at (-0.02, 0.03, 0.62) touching units from the reference: cost
  ; 238.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0054 -0.0165 0.0077 0.5001 0.0289 -0.0082 -0.0178 0.4369 0.0066 -0.0500 -0.0390
  ; 0.7296
  (:action leans-on-001-by-110c-hollow-tall-wide-to-any-tall-00010
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-tall-wide-to-any-tall-00010 ?t ?r) (can-leans-on-001-by-110c-hollow-tall-wide-to-any-tall-00010 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-110c-hollow-tall-wide-to-any-tall-00010 ?g))))

  ; Primitive 110 on pairs of the kind 00011 (hollow-low-wide-to-any-low-00011): ends in the state 001
  ; (leans-on-001) in 12 of 29 rehearsals, at (0.02, 0.12, 0.44) touching units from the reference: cost 88.
  ; With a third object on the reference: 2 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0009 -0.0329 0.0017 0.9875 0.0285 0.0246 -0.0209 0.0635 0.0030 -0.0500 0.0319
  ; 0.2203
  (:action leans-on-001-by-110d-hollow-low-wide-to-any-low-00011
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-low-00011 ?t ?r) (can-leans-on-001-by-110d-hollow-low-wide-to-any-low-00011 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-110d-hollow-low-wide-to-any-low-00011 ?g))))

  ; Primitive 110 on pairs of the kind 00011 (hollow-low-wide-to-any-low-00011): ends in the state 001
  ; (leans-on-001) in 12 of 29 rehearsals, at (0.04, 0.12, 0.43) touching units from the reference: cost 88.
  ; With a third object on the reference: 2 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0070 -0.0303 -0.0099 0.5476 -0.0068 -0.0500 0.0040 0.0857 0.0007 -0.0500 0.0391
  ; 0.1389
  (:action leans-on-001-by-110e-hollow-low-wide-to-any-low-00011
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-low-00011 ?t ?r) (can-leans-on-001-by-110e-hollow-low-wide-to-any-low-00011 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-110e-hollow-low-wide-to-any-low-00011 ?g))))

  ; Primitive 110 on pairs of the kind 01011 (hollow-low-wide-to-any-01011): ends in the state 001 (leans-
  ; on-001) in 6 of 30 rehearsals, at (0.00, 0.15, 0.45) touching units from the reference: cost 153.
  ; With a third object on the reference: 3 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0047 -0.0236 0.0094 0.5001 0.0229 -0.0064 -0.0166 0.4369 0.0034 -0.0500 -0.0402
  ; 0.7296
  (:action leans-on-001-by-110h-hollow-low-wide-to-any-01011
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-01011 ?t ?r) (can-leans-on-001-by-110h-hollow-low-wide-to-any-01011 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-110h-hollow-low-wide-to-any-01011 ?g))))

  ; Primitive 110 on pairs of the kind 01011 (hollow-low-wide-to-any-01011): ends in the state 001 (leans-
  ; on-001) in 6 of 30 rehearsals, at (0.03, 0.14, 0.47) touching units from the reference: cost 153.
  ; With a third object on the reference: 1 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0035 -0.0346 -0.0074 0.5476 -0.0158 -0.0500 0.0053 0.0857 0.0008 -0.0500 0.0473
  ; 0.1389
  (:action leans-on-001-by-110i-hollow-low-wide-to-any-01011
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-01011 ?t ?r) (can-leans-on-001-by-110i-hollow-low-wide-to-any-01011 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-110i-hollow-low-wide-to-any-01011 ?g))))

  ; Primitive 110 on pairs of the kind 01011 (hollow-low-wide-to-any-01011): ends in the state 001 (leans-
  ; on-001) in 6 of 30 rehearsals, at (0.01, 0.14, 0.47) touching units from the reference: cost 153.
  ; With a third object on the reference: 2 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0004 -0.0247 0.0021 0.6460 0.0479 -0.0403 0.0197 0.0099 0.0030 -0.0500 -0.0328
  ; 0.4593
  (:action leans-on-001-by-110j-hollow-low-wide-to-any-01011
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-01011 ?t ?r) (can-leans-on-001-by-110j-hollow-low-wide-to-any-01011 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-110j-hollow-low-wide-to-any-01011 ?g))))

  ; Primitive 110 on pairs of the kind 01011 (hollow-low-wide-to-any-01011): ends in the state 001 (leans-
  ; on-001) in 6 of 30 rehearsals, at (-0.00, 0.14, 0.47) touching units from the reference: cost 153.
  ; With a third object on the reference: 2 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0035 -0.0248 0.0018 0.6460 0.0424 -0.0427 0.0231 0.0099 0.0027 -0.0500 -0.0322
  ; 0.4593
  (:action leans-on-001-by-110k-hollow-low-wide-to-any-01011
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-01011 ?t ?r) (can-leans-on-001-by-110k-hollow-low-wide-to-any-01011 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-110k-hollow-low-wide-to-any-01011 ?g))))

  ; Primitive 111 on pairs of the kind 10111 (any-low-to-any-low-10111): ends in the state 001 (leans-
  ; on-001) in 7 of 30 rehearsals, at (0.84, -0.02, 0.39) touching units from the reference: cost 140.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 1 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0457 -0.0131 -0.0111 0.6263 -0.0299 -0.0323 0.0189 0.1287 0.0412 0.0012 0.0021
  ; 0.0739
  (:action leans-on-001-by-111a-any-low-to-any-low-10111
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-low-to-any-low-10111 ?t ?r) (can-leans-on-001-by-111a-any-low-to-any-low-10111 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-111a-any-low-to-any-low-10111 ?g))))

  ; Primitive 111 on pairs of the kind 11101 (any-to-any-11101): ends in the state 001 (leans-on-001) in 5
  ; of 30 rehearsals, at (0.64, -0.05, 0.46) touching units from the reference: cost 168.
  ; With a third object on the reference: 2 of 12 went so, and it is allowed.
  ; With a third object under the target: 1 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0457 -0.0131 -0.0111 0.6263 -0.0299 -0.0323 0.0189 0.1287 0.0412 0.0012 0.0021
  ; 0.0739
  (:action leans-on-001-by-111a-any-to-any-11101
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-to-any-11101 ?t ?r) (can-leans-on-001-by-111a-any-to-any-11101 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-111a-any-to-any-11101 ?g ?from))))

  ; Primitive 111 on pairs of the kind 00100 (solid-low-to-any-tall-narrow-00100): ends in the state 001
  ; (leans-on-001) in 2 of 27 rehearsals, at (0.81, -0.08, 0.35) touching units from the reference: cost
  ; 228.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 2 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0457 -0.0131 -0.0111 0.6263 -0.0299 -0.0323 0.0189 0.1287 0.0412 0.0012 0.0021
  ; 0.0739
  (:action leans-on-001-by-111a-solid-low-to-any-tall-narrow-00100
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (solid-low-to-any-tall-narrow-00100 ?t ?r) (can-leans-on-001-by-111a-solid-low-to-any-tall-narrow-00100 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-111a-solid-low-to-any-tall-narrow-00100 ?g ?from))))

  ; Primitive 111 on pairs of the kind 01110 (solid-narrow-to-hollow-low-wide-01110): ends in the state 001
  ; (leans-on-001) in 1 of 30 rehearsals, at (0.44, -0.67, 0.40) touching units from the reference: cost
  ; 278.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 3 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: 0.0010 0.0040 -0.0250 1.0000 -0.0204 0.0500 -0.0142 0.1094 0.0500 -0.0500 0.0185
  ; 0.8003
  (:action leans-on-001-by-111b-solid-narrow-to-hollow-low-wide-01110
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (solid-narrow-to-hollow-low-wide-01110 ?t ?r) (can-leans-on-001-by-111b-solid-narrow-to-hollow-low-wide-01110 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-111b-solid-narrow-to-hollow-low-wide-01110 ?g ?from))))

  ; Primitive 111 on pairs of the kind 01011 (hollow-low-wide-to-any-01011): ends in the state 001 (leans-
  ; on-001) in 8 of 30 rehearsals, at (0.13, -0.64, 0.40) touching units from the reference: cost 128.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0105 0.0410 -0.0008 0.8975 -0.0011 0.0407 -0.0086 0.2878 0.0282 -0.0079 0.0342
  ; 0.6094
  (:action leans-on-001-by-111d-hollow-low-wide-to-any-01011
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-01011 ?t ?r) (can-leans-on-001-by-111d-hollow-low-wide-to-any-01011 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-111d-hollow-low-wide-to-any-01011 ?g))))

  ; Primitive 111 on pairs of the kind 01100 (any-to-any-narrow-01100): ends in the state 001 (leans-on-001)
  ; in 3 of 14 rehearsals, at (0.67, -0.09, 0.54) touching units from the reference: cost 140.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 2 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0500 -0.0122 -0.0110 0.5947 -0.0307 -0.0321 0.0188 0.1299 0.0427 -0.0049 0.0021
  ; 0.0740
  (:action leans-on-001-by-111e-any-to-any-narrow-01100
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-to-any-narrow-01100 ?t ?r) (can-leans-on-001-by-111e-any-to-any-narrow-01100 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-001 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-001-by-111e-any-to-any-narrow-01100 ?g ?from))))

  ; Primitive 000 on pairs of the kind 00110 (any-tall-narrow-to-hollow-low-wide-00110): ends in the state
  ; 101 (leans-on-101) in 7 of 30 rehearsals, at (-0.18, 0.23, 0.48) touching units from the reference: cost
  ; 140.
  ; With a third object on the reference: 2 of 12 went so, and it is allowed.
  ; With a third object under the target: 2 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0077 -0.0016 -0.0250 0.5689 -0.0397 -0.0012 0.0142 0.3413 -0.0474 0.0499 0.0247
  ; 0.1703
  (:action leans-on-101-by-000b-any-tall-narrow-to-hollow-low-wide-00110
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-tall-narrow-to-hollow-low-wide-00110 ?t ?r) (can-leans-on-101-by-000b-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-000b-any-tall-narrow-to-hollow-low-wide-00110 ?g ?from))))

  ; Primitive 000 on pairs of the kind 00110 (any-tall-narrow-to-hollow-low-wide-00110): ends in the state
  ; 101 (leans-on-101) in 17 of 30 rehearsals, at (-0.16, 0.19, 0.45) touching units from the reference:
  ; cost 59.
  ; With a third object on the reference: 2 of 12 went so, and it is forbidden.
  ; With a third object under the target: 4 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0095 0.0038 -0.0241 0.5983 0.0369 0.0362 -0.0183 0.3314 -0.0434 0.0384 -0.0224
  ; 0.3272
  (:action leans-on-101-by-000c-any-tall-narrow-to-hollow-low-wide-00110
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-tall-narrow-to-hollow-low-wide-00110 ?t ?r) (can-leans-on-101-by-000c-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-000c-any-tall-narrow-to-hollow-low-wide-00110 ?g ?from))))

  ; Primitive 000 on pairs of the kind 00111 (any-low-narrow-to-hollow-low-wide-00111): ends in the state
  ; 101 (leans-on-101) in 20 of 30 rehearsals, at (-0.10, 0.14, 0.31) touching units from the reference:
  ; cost 43.
  ; With a third object on the reference: 6 of 12 went so, and it is allowed.
  ; With a third object under the target: 5 of 6 went so, and it is allowed.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: -0.0171 0.0039 -0.0134 0.5509 0.0088 -0.0143 0.0124 0.1473 -0.0373 0.0177 0.0287
  ; 0.8104
  (:action leans-on-101-by-000d-any-low-narrow-to-hollow-low-wide-00111
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-low-narrow-to-hollow-low-wide-00111 ?t ?r) (can-leans-on-101-by-000d-any-low-narrow-to-hollow-low-wide-00111 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-000d-any-low-narrow-to-hollow-low-wide-00111 ?g ?from))))

  ; Primitive 000 on pairs of the kind 10111 (any-low-to-any-low-10111): ends in the state 101 (leans-
  ; on-101) in 2 of 30 rehearsals, at (0.01, 0.09, 0.56) touching units from the reference: cost 238.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0109 0.0022 -0.0097 0.5509 0.0065 -0.0034 0.0121 0.1473 -0.0095 0.0421 -0.0188
  ; 0.2281
  (:action leans-on-101-by-000g-any-low-to-any-low-10111
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-low-to-any-low-10111 ?t ?r) (can-leans-on-101-by-000g-any-low-to-any-low-10111 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-000g-any-low-to-any-low-10111 ?g))))

  ; Primitive 000 on pairs of the kind 11101 (any-to-any-11101): ends in the state 101 (leans-on-101) in 2
  ; of 30 rehearsals, at (-0.00, 0.52, 0.56) touching units from the reference: cost 238.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0010 -0.0162 0.0021 0.6622 0.0461 -0.0458 0.0205 0.0098 -0.0006 0.0253 -0.0364
  ; 0.0856
  (:action leans-on-101-by-000h-any-to-any-11101
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-to-any-11101 ?t ?r) (can-leans-on-101-by-000h-any-to-any-11101 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-000h-any-to-any-11101 ?g))))

  ; Primitive 001 on pairs of the kind 00010 (hollow-tall-wide-to-any-tall-00010): ends in the state 101
  ; (leans-on-101) in 5 of 30 rehearsals, at (-0.02, -0.10, 0.54) touching units from the reference: cost
  ; 168.
  ; With a third object on the reference: 2 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0034 0.0357 -0.0044 0.8133 -0.0269 0.0418 -0.0054 0.4819 -0.0000 0.0500 0.0030
  ; 0.9931
  (:action leans-on-101-by-001a-hollow-tall-wide-to-any-tall-00010
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-tall-wide-to-any-tall-00010 ?t ?r) (can-leans-on-101-by-001a-hollow-tall-wide-to-any-tall-00010 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-001a-hollow-tall-wide-to-any-tall-00010 ?g))))

  ; Primitive 001 on pairs of the kind 00011 (hollow-low-wide-to-any-low-00011): ends in the state 101
  ; (leans-on-101) in 11 of 29 rehearsals, at (-0.15, 0.63, 0.46) touching units from the reference: cost
  ; 96.
  ; With a third object on the reference: 3 of 12 went so, and it is allowed.
  ; With a third object under the target: 2 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0002 -0.0369 -0.0040 0.5476 -0.0078 -0.0486 0.0052 0.0857 -0.0201 0.0367 -0.0104
  ; 0.6737
  (:action leans-on-101-by-001b-hollow-low-wide-to-any-low-00011
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-low-00011 ?t ?r) (can-leans-on-101-by-001b-hollow-low-wide-to-any-low-00011 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-001b-hollow-low-wide-to-any-low-00011 ?g))))

  ; Primitive 001 on pairs of the kind 00111 (any-low-narrow-to-hollow-low-wide-00111): ends in the state
  ; 101 (leans-on-101) in 19 of 30 rehearsals, at (0.10, 0.10, 0.31) touching units from the reference: cost
  ; 48.
  ; With a third object on the reference: 5 of 12 went so, and it is allowed.
  ; With a third object under the target: 5 of 6 went so, and it is allowed.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: 0.0032 0.0299 -0.0049 0.7889 0.0455 -0.0267 0.0152 0.1240 0.0213 0.0140 0.0156 0.2049
  (:action leans-on-101-by-001c-any-low-narrow-to-hollow-low-wide-00111
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-low-narrow-to-hollow-low-wide-00111 ?t ?r) (can-leans-on-101-by-001c-any-low-narrow-to-hollow-low-wide-00111 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-001c-any-low-narrow-to-hollow-low-wide-00111 ?g ?from))))

  ; Primitive 001 on pairs of the kind 01001 (hollow-low-wide-to-any-tall-01001): ends in the state 101
  ; (leans-on-101) in 6 of 30 rehearsals, at (0.05, -0.19, 0.24) touching units from the reference: cost
  ; 153.
  ; With a third object on the reference: 4 of 12 went so, and it is allowed.
  ; With a third object under the target: 2 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0088 0.0326 0.0018 0.6484 0.0156 0.0379 0.0093 0.3897 0.0022 0.0500 -0.0091 0.3859
  (:action leans-on-101-by-001e-hollow-low-wide-to-any-tall-01001
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (hollow-low-wide-to-any-tall-01001 ?t ?r) (can-leans-on-101-by-001e-hollow-low-wide-to-any-tall-01001 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-001e-hollow-low-wide-to-any-tall-01001 ?g ?from))))

  ; Primitive 001 on pairs of the kind 10110 (solid-low-narrow-to-hollow-low-10110): ends in the state 101
  ; (leans-on-101) in 6 of 19 rehearsals, at (-0.01, 0.00, 0.48) touching units from the reference: cost
  ; 111.
  ; With a third object on the reference: 2 of 8 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0208 -0.0267 -0.0206 0.8967 -0.0325 -0.0092 0.0052 0.2104 -0.0209 0.0017 0.0413
  ; 0.8142
  (:action leans-on-101-by-001g-solid-low-narrow-to-hollow-low-10110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-low-narrow-to-hollow-low-10110 ?t ?r) (can-leans-on-101-by-001g-solid-low-narrow-to-hollow-low-10110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-001g-solid-low-narrow-to-hollow-low-10110 ?g))))

  ; Primitive 010 on pairs of the kind 00010 (hollow-tall-wide-to-any-tall-00010): ends in the state 101
  ; (leans-on-101) in 2 of 30 rehearsals, at (-0.30, 0.07, 0.61) touching units from the reference: cost
  ; 238.
  ; With a third object on the reference: 2 of 12 went so, and it is allowed.
  ; With a third object under the target: 1 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0005 -0.0388 -0.0062 0.5476 -0.0185 -0.0496 0.0099 0.0857 -0.0370 -0.0424 -0.0225
  ; 0.7123
  (:action leans-on-101-by-010a-hollow-tall-wide-to-any-tall-00010
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (hollow-tall-wide-to-any-tall-00010 ?t ?r) (can-leans-on-101-by-010a-hollow-tall-wide-to-any-tall-00010 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-010a-hollow-tall-wide-to-any-tall-00010 ?g ?from))))

  ; Primitive 010 on pairs of the kind 01001 (hollow-low-wide-to-any-tall-01001): ends in the state 101
  ; (leans-on-101) in 15 of 30 rehearsals, at (-0.74, 0.10, 0.27) touching units from the reference: cost
  ; 70.
  ; With a third object on the reference: 2 of 12 went so, and it is forbidden.
  ; With a third object under the target: 4 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0329 0.0001 -0.0141 0.9212 0.0034 0.0056 0.0190 0.3138 -0.0492 0.0115 -0.0118
  ; 0.0274
  (:action leans-on-101-by-010b-hollow-low-wide-to-any-tall-01001
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (hollow-low-wide-to-any-tall-01001 ?t ?r) (can-leans-on-101-by-010b-hollow-low-wide-to-any-tall-01001 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-010b-hollow-low-wide-to-any-tall-01001 ?g ?from))))

  ; Primitive 010 on pairs of the kind 10110 (solid-low-narrow-to-hollow-low-10110): ends in the state 101
  ; (leans-on-101) in 11 of 19 rehearsals, at (-0.78, 0.09, 0.37) touching units from the reference: cost
  ; 57.
  ; With a third object on the reference: 0 of 8 went so, and it is forbidden.
  ; With a third object under the target: 5 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: 0.0329 0.0001 -0.0141 0.9212 0.0034 0.0056 0.0190 0.3138 -0.0492 0.0115 -0.0118
  ; 0.0274
  (:action leans-on-101-by-010b-solid-low-narrow-to-hollow-low-10110
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (solid-low-narrow-to-hollow-low-10110 ?t ?r) (can-leans-on-101-by-010b-solid-low-narrow-to-hollow-low-10110 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-010b-solid-low-narrow-to-hollow-low-10110 ?g ?from))))

  ; Primitive 010 on pairs of the kind 11010 (solid-tall-to-any-11010): ends in the state 101 (leans-on-101)
  ; in 7 of 30 rehearsals, at (-0.70, 0.10, 0.46) touching units from the reference: cost 140.
  ; With a third object on the reference: 1 of 12 went so, and it is forbidden.
  ; With a third object under the target: 1 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0329 0.0001 -0.0141 0.9212 0.0034 0.0056 0.0190 0.3138 -0.0492 0.0115 -0.0118
  ; 0.0274
  (:action leans-on-101-by-010b-solid-tall-to-any-11010
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-tall-to-any-11010 ?t ?r) (can-leans-on-101-by-010b-solid-tall-to-any-11010 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-010b-solid-tall-to-any-11010 ?g))))

  ; Primitive 010 on pairs of the kind 01011 (hollow-low-wide-to-any-01011): ends in the state 101 (leans-
  ; on-101) in 10 of 30 rehearsals, at (-0.25, -0.62, 0.27) touching units from the reference: cost 108.
  ; With a third object on the reference: 3 of 12 went so, and it is allowed.
  ; With a third object under the target: 1 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0065 0.0370 -0.0003 0.8975 -0.0015 0.0338 -0.0124 0.2878 -0.0320 -0.0121 -0.0338
  ; 0.3051
  (:action leans-on-101-by-010c-hollow-low-wide-to-any-01011
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-01011 ?t ?r) (can-leans-on-101-by-010c-hollow-low-wide-to-any-01011 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-010c-hollow-low-wide-to-any-01011 ?g))))

  ; Primitive 010 on pairs of the kind 10111 (any-low-to-any-low-10111): ends in the state 101 (leans-
  ; on-101) in 17 of 30 rehearsals, at (-0.67, -0.02, 0.39) touching units from the reference: cost 59.
  ; With a third object on the reference: 4 of 12 went so, and it is allowed.
  ; With a third object under the target: 3 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0282 -0.0223 -0.0141 0.6094 0.0119 0.0284 0.0177 0.0147 -0.0475 -0.0002 -0.0423
  ; 0.4675
  (:action leans-on-101-by-010d-any-low-to-any-low-10111
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-low-to-any-low-10111 ?t ?r) (can-leans-on-101-by-010d-any-low-to-any-low-10111 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-010d-any-low-to-any-low-10111 ?g))))

  ; Primitive 010 on pairs of the kind 11111 (any-low-wide-to-hollow-low-wide-11111): ends in the state 101
  ; (leans-on-101) in 17 of 30 rehearsals, at (-0.33, -0.16, 0.47) touching units from the reference: cost
  ; 59.
  ; With a third object on the reference: 2 of 12 went so, and it is forbidden.
  ; With a third object under the target: 3 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 9 went so, and it is forbidden.
  ; Action parameters: -0.0003 -0.0066 -0.0082 0.7718 0.0249 -0.0035 -0.0226 0.1445 -0.0500 -0.0155 0.0123
  ; 0.4293
  (:action leans-on-101-by-010e-any-low-wide-to-hollow-low-wide-11111
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-low-wide-to-hollow-low-wide-11111 ?t ?r) (can-leans-on-101-by-010e-any-low-wide-to-hollow-low-wide-11111 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-010e-any-low-wide-to-hollow-low-wide-11111 ?g))))

  ; Primitive 100 on pairs of the kind 11000 (any-tall-narrow-to-any-narrow-11000): ends in the state 101
  ; (leans-on-101) in 1 of 30 rehearsals, at (0.02, 0.04, 0.59) touching units from the reference: cost 278.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 11 went so, and it is forbidden.
  ; Action parameters: -0.0102 -0.0030 -0.0044 0.5883 0.0169 0.0130 0.0194 0.0655 -0.0074 -0.0023 -0.0087
  ; 0.0460
  (:action leans-on-101-by-100a-any-tall-narrow-to-any-narrow-11000
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-tall-narrow-to-any-narrow-11000 ?t ?r) (can-leans-on-101-by-100a-any-tall-narrow-to-any-narrow-11000 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-100a-any-tall-narrow-to-any-narrow-11000 ?g))))

  ; Primitive 100 on pairs of the kind 00110 (any-tall-narrow-to-hollow-low-wide-00110): ends in the state
  ; 101 (leans-on-101) in 2 of 30 rehearsals, at (0.01, -0.00, 0.41) touching units from the reference: cost
  ; 238.
  ; With a third object on the reference: 2 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0102 -0.0030 -0.0044 0.5883 0.0169 0.0130 0.0194 0.0655 -0.0074 -0.0023 -0.0087
  ; 0.0460
  (:action leans-on-101-by-100a-any-tall-narrow-to-hollow-low-wide-00110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-tall-narrow-to-hollow-low-wide-00110 ?t ?r) (can-leans-on-101-by-100a-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-100a-any-tall-narrow-to-hollow-low-wide-00110 ?g))))

  ; Primitive 100 on pairs of the kind 00001 (hollow-low-wide-to-any-low-wide-00001): ends in the state 101
  ; (leans-on-101) in 3 of 30 rehearsals, at (0.03, -0.03, 0.49) touching units from the reference: cost
  ; 209.
  ; With a third object on the reference: 4 of 12 went so, and it is allowed.
  ; With a third object under the target: 1 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0102 -0.0030 -0.0044 0.5883 0.0169 0.0130 0.0194 0.0655 -0.0074 -0.0023 -0.0087
  ; 0.0460
  (:action leans-on-101-by-100a-hollow-low-wide-to-any-low-wide-00001
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (hollow-low-wide-to-any-low-wide-00001 ?t ?r) (can-leans-on-101-by-100a-hollow-low-wide-to-any-low-wide-00001 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-100a-hollow-low-wide-to-any-low-wide-00001 ?g ?from))))

  ; Primitive 100 on pairs of the kind 10110 (solid-low-narrow-to-hollow-low-10110): ends in the state 101
  ; (leans-on-101) in 3 of 19 rehearsals, at (-0.04, 0.01, 0.46) touching units from the reference: cost
  ; 167.
  ; With a third object on the reference: 1 of 8 went so, and it is allowed.
  ; With a third object under the target: 2 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0102 -0.0030 -0.0044 0.5883 0.0169 0.0130 0.0194 0.0655 -0.0074 -0.0023 -0.0087
  ; 0.0460
  (:action leans-on-101-by-100a-solid-low-narrow-to-hollow-low-10110
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (solid-low-narrow-to-hollow-low-10110 ?t ?r) (can-leans-on-101-by-100a-solid-low-narrow-to-hollow-low-10110 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-100a-solid-low-narrow-to-hollow-low-10110 ?g ?from))))

  ; Primitive 100 on pairs of the kind 01010 (solid-low-wide-to-any-01010): ends in the state 101 (leans-
  ; on-101) in 1 of 30 rehearsals, at (0.03, -0.01, 0.26) touching units from the reference: cost 278.
  ; With a third object on the reference: 2 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0102 -0.0030 -0.0044 0.5883 0.0169 0.0130 0.0194 0.0655 -0.0074 -0.0023 -0.0087
  ; 0.0460
  (:action leans-on-101-by-100a-solid-low-wide-to-any-01010
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-low-wide-to-any-01010 ?t ?r) (can-leans-on-101-by-100a-solid-low-wide-to-any-01010 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-100a-solid-low-wide-to-any-01010 ?g))))

  ; Primitive 100 on pairs of the kind 00100 (solid-low-to-any-tall-narrow-00100): ends in the state 101
  ; (leans-on-101) in 1 of 27 rehearsals, at (0.03, 0.00, 0.67) touching units from the reference: cost 268.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0032 -0.0077 -0.0003 0.8535 0.0035 0.0077 0.0116 0.0931 0.0005 0.0006 0.0094
  ; 0.1738
  (:action leans-on-101-by-100b-solid-low-to-any-tall-narrow-00100
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-low-to-any-tall-narrow-00100 ?t ?r) (can-leans-on-101-by-100b-solid-low-to-any-tall-narrow-00100 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-100b-solid-low-to-any-tall-narrow-00100 ?g))))

  ; Primitive 100 on pairs of the kind 01110 (solid-narrow-to-hollow-low-wide-01110): ends in the state 101
  ; (leans-on-101) in 2 of 30 rehearsals, at (-0.04, -0.01, 0.52) touching units from the reference: cost
  ; 238.
  ; With a third object on the reference: 2 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0032 -0.0077 -0.0003 0.8535 0.0035 0.0077 0.0116 0.0931 0.0005 0.0006 0.0094
  ; 0.1738
  (:action leans-on-101-by-100b-solid-narrow-to-hollow-low-wide-01110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-narrow-to-hollow-low-wide-01110 ?t ?r) (can-leans-on-101-by-100b-solid-narrow-to-hollow-low-wide-01110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-100b-solid-narrow-to-hollow-low-wide-01110 ?g))))

  ; Primitive 100 on pairs of the kind 00100 (solid-low-to-any-tall-narrow-00100): ends in the state 101
  ; (leans-on-101) in 3 of 27 rehearsals, at (0.10, 0.03, 0.30) touching units from the reference: cost 199.
  ; With a third object on the reference: 1 of 12 went so, and it is allowed.
  ; With a third object under the target: 1 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0020 0.0012 -0.0055 0.5883 0.0253 0.0106 0.0250 0.0655 0.0101 -0.0024 -0.0194
  ; 0.7451
  (:action leans-on-101-by-100c-solid-low-to-any-tall-narrow-00100
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (solid-low-to-any-tall-narrow-00100 ?t ?r) (can-leans-on-101-by-100c-solid-low-to-any-tall-narrow-00100 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-100c-solid-low-to-any-tall-narrow-00100 ?g ?from))))

  ; Primitive 100 on pairs of the kind 00111 (any-low-narrow-to-hollow-low-wide-00111): ends in the state
  ; 101 (leans-on-101) in 2 of 30 rehearsals, at (-0.00, -0.01, 0.61) touching units from the reference:
  ; cost 238.
  ; With a third object on the reference: 5 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 6 went so, and it is forbidden.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: 0.0001 0.0122 0.0080 0.6141 -0.0237 -0.0116 -0.0099 0.2882 -0.0054 -0.0021 -0.0242
  ; 0.4343
  (:action leans-on-101-by-100d-any-low-narrow-to-hollow-low-wide-00111
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-low-narrow-to-hollow-low-wide-00111 ?t ?r) (can-leans-on-101-by-100d-any-low-narrow-to-hollow-low-wide-00111 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-100d-any-low-narrow-to-hollow-low-wide-00111 ?g))))

  ; Primitive 100 on pairs of the kind 00110 (any-tall-narrow-to-hollow-low-wide-00110): ends in the state
  ; 101 (leans-on-101) in 5 of 30 rehearsals, at (0.04, 0.13, 0.32) touching units from the reference: cost
  ; 168.
  ; With a third object on the reference: 2 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0025 -0.0179 0.0070 0.5196 0.0311 -0.0089 -0.0192 0.4165 0.0083 -0.0034 -0.0467
  ; 0.3975
  (:action leans-on-101-by-100e-any-tall-narrow-to-hollow-low-wide-00110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-tall-narrow-to-hollow-low-wide-00110 ?t ?r) (can-leans-on-101-by-100e-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-100e-any-tall-narrow-to-hollow-low-wide-00110 ?g))))

  ; Primitive 100 on pairs of the kind 00111 (any-low-narrow-to-hollow-low-wide-00111): ends in the state
  ; 101 (leans-on-101) in 15 of 30 rehearsals, at (-0.05, -0.08, 0.30) touching units from the reference:
  ; cost 70.
  ; With a third object on the reference: 5 of 12 went so, and it is allowed.
  ; With a third object under the target: 5 of 6 went so, and it is allowed.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: -0.0056 0.0024 -0.0046 0.5883 0.0225 0.0178 0.0238 0.0655 -0.0180 -0.0052 -0.0125
  ; 0.0460
  (:action leans-on-101-by-100g-any-low-narrow-to-hollow-low-wide-00111
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-low-narrow-to-hollow-low-wide-00111 ?t ?r) (can-leans-on-101-by-100g-any-low-narrow-to-hollow-low-wide-00111 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-100g-any-low-narrow-to-hollow-low-wide-00111 ?g ?from))))

  ; Primitive 100 on pairs of the kind 00111 (any-low-narrow-to-hollow-low-wide-00111): ends in the state
  ; 101 (leans-on-101) in 4 of 30 rehearsals, at (-0.00, -0.01, 0.40) touching units from the reference:
  ; cost 187.
  ; With a third object on the reference: 2 of 12 went so, and it is allowed.
  ; With a third object under the target: 1 of 6 went so, and it is allowed.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: -0.0054 -0.0102 -0.0020 0.8535 -0.0015 0.0010 0.0152 0.0931 -0.0063 -0.0028 0.0093
  ; 0.1738
  (:action leans-on-101-by-100h-any-low-narrow-to-hollow-low-wide-00111
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-low-narrow-to-hollow-low-wide-00111 ?t ?r) (can-leans-on-101-by-100h-any-low-narrow-to-hollow-low-wide-00111 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-100h-any-low-narrow-to-hollow-low-wide-00111 ?g ?from))))

  ; Primitive 100 on pairs of the kind 01001 (hollow-low-wide-to-any-tall-01001): ends in the state 101
  ; (leans-on-101) in 3 of 30 rehearsals, at (0.15, 0.04, 0.29) touching units from the reference: cost 209.
  ; With a third object on the reference: 3 of 12 went so, and it is allowed.
  ; With a third object under the target: 3 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0219 -0.0008 -0.0206 0.9212 0.0060 0.0044 0.0211 0.3138 0.0313 0.0021 0.0394 0.9677
  (:action leans-on-101-by-100i-hollow-low-wide-to-any-tall-01001
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (hollow-low-wide-to-any-tall-01001 ?t ?r) (can-leans-on-101-by-100i-hollow-low-wide-to-any-tall-01001 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-100i-hollow-low-wide-to-any-tall-01001 ?g ?from))))

  ; Primitive 100 on pairs of the kind 11001 (any-tall-narrow-to-solid-narrow-11001): ends in the state 101
  ; (leans-on-101) in 1 of 30 rehearsals, at (0.02, -0.08, 0.51) touching units from the reference: cost
  ; 278.
  ; With a third object on the reference: 0 of 7 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0094 -0.0018 -0.0039 0.5883 0.0171 0.0110 0.0228 0.0655 -0.0146 -0.0042 -0.0114
  ; 0.0460
  (:action leans-on-101-by-100l-any-tall-narrow-to-solid-narrow-11001
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-tall-narrow-to-solid-narrow-11001 ?t ?r) (can-leans-on-101-by-100l-any-tall-narrow-to-solid-narrow-11001 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-100l-any-tall-narrow-to-solid-narrow-11001 ?g))))

  ; Primitive 100 on pairs of the kind 01110 (solid-narrow-to-hollow-low-wide-01110): ends in the state 101
  ; (leans-on-101) in 3 of 30 rehearsals, at (-0.01, -0.01, 0.45) touching units from the reference: cost
  ; 209.
  ; With a third object on the reference: 2 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0094 -0.0018 -0.0039 0.5883 0.0171 0.0110 0.0228 0.0655 -0.0146 -0.0042 -0.0114
  ; 0.0460
  (:action leans-on-101-by-100l-solid-narrow-to-hollow-low-wide-01110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-narrow-to-hollow-low-wide-01110 ?t ?r) (can-leans-on-101-by-100l-solid-narrow-to-hollow-low-wide-01110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-100l-solid-narrow-to-hollow-low-wide-01110 ?g))))

  ; Primitive 100 on pairs of the kind 01110 (solid-narrow-to-hollow-low-wide-01110): ends in the state 101
  ; (leans-on-101) in 1 of 30 rehearsals, at (-0.10, -0.01, 0.53) touching units from the reference: cost
  ; 278.
  ; With a third object on the reference: 1 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0015 0.0078 0.0021 0.6141 -0.0214 -0.0075 -0.0097 0.2882 -0.0035 0.0035 -0.0207
  ; 0.4343
  (:action leans-on-101-by-100m-solid-narrow-to-hollow-low-wide-01110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-narrow-to-hollow-low-wide-01110 ?t ?r) (can-leans-on-101-by-100m-solid-narrow-to-hollow-low-wide-01110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-100m-solid-narrow-to-hollow-low-wide-01110 ?g))))

  ; Primitive 100 on pairs of the kind 01110 (solid-narrow-to-hollow-low-wide-01110): ends in the state 101
  ; (leans-on-101) in 1 of 30 rehearsals, at (0.02, 0.01, 0.48) touching units from the reference: cost 278.
  ; With a third object on the reference: 2 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0147 -0.0026 0.0063 0.7068 0.0083 0.0090 0.0033 0.0639 -0.0112 0.0037 0.0345
  ; 0.8890
  (:action leans-on-101-by-100n-solid-narrow-to-hollow-low-wide-01110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-narrow-to-hollow-low-wide-01110 ?t ?r) (can-leans-on-101-by-100n-solid-narrow-to-hollow-low-wide-01110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-100n-solid-narrow-to-hollow-low-wide-01110 ?g))))

  ; Primitive 100 on pairs of the kind 10100 (any-narrow-to-any-narrow-10100): ends in the state 101 (leans-
  ; on-101) in 3 of 30 rehearsals, at (-0.00, 0.22, 0.24) touching units from the reference: cost 209.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0018 -0.0068 -0.0152 0.7216 0.0225 -0.0263 0.0036 0.2601 0.0017 -0.0045 0.0294
  ; 0.8375
  (:action leans-on-101-by-100o-any-narrow-to-any-narrow-10100
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-narrow-to-any-narrow-10100 ?t ?r) (can-leans-on-101-by-100o-any-narrow-to-any-narrow-10100 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-100o-any-narrow-to-any-narrow-10100 ?g))))

  ; Primitive 100 on pairs of the kind 11000 (any-tall-narrow-to-any-narrow-11000): ends in the state 101
  ; (leans-on-101) in 1 of 30 rehearsals, at (0.01, -0.04, 0.60) touching units from the reference: cost
  ; 278.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 11 went so, and it is forbidden.
  ; Action parameters: -0.0147 -0.0026 0.0063 0.7068 0.0083 0.0090 0.0033 0.0639 -0.0112 0.0037 0.0345
  ; 0.8890
  (:action leans-on-101-by-100p-any-tall-narrow-to-any-narrow-11000
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-tall-narrow-to-any-narrow-11000 ?t ?r) (can-leans-on-101-by-100p-any-tall-narrow-to-any-narrow-11000 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-100p-any-tall-narrow-to-any-narrow-11000 ?g))))

  ; Primitive 100 on pairs of the kind 11110 (solid-to-any-low-11110): ends in the state 101 (leans-on-101)
  ; in 7 of 30 rehearsals, at (-0.03, -0.04, 0.43) touching units from the reference: cost 140.
  ; With a third object on the reference: 1 of 12 went so, and it is forbidden.
  ; With a third object under the target: 1 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: -0.0110 -0.0027 -0.0021 0.5883 0.0218 0.0117 0.0250 0.0655 -0.0232 -0.0044 -0.0488
  ; 0.0431
  (:action leans-on-101-by-100t-solid-to-any-low-11110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-to-any-low-11110 ?t ?r) (can-leans-on-101-by-100t-solid-to-any-low-11110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-100t-solid-to-any-low-11110 ?g))))

  ; Primitive 101 on pairs of the kind 11010 (solid-tall-to-any-11010): ends in the state 101 (leans-on-101)
  ; in 5 of 30 rehearsals, at (0.47, 0.34, 0.49) touching units from the reference: cost 168.
  ; With a third object on the reference: 3 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0012 0.0019 -0.0176 0.7216 0.0245 -0.0240 0.0034 0.2601 0.0399 0.0363 -0.0465
  ; 0.0516
  (:action leans-on-101-by-101a-solid-tall-to-any-11010
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-tall-to-any-11010 ?t ?r) (can-leans-on-101-by-101a-solid-tall-to-any-11010 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-101a-solid-tall-to-any-11010 ?g))))

  ; Primitive 101 on pairs of the kind 11110 (solid-to-any-low-11110): ends in the state 101 (leans-on-101)
  ; in 9 of 30 rehearsals, at (0.43, 0.49, 0.45) touching units from the reference: cost 117.
  ; With a third object on the reference: 2 of 12 went so, and it is allowed.
  ; With a third object under the target: 1 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: -0.0012 0.0019 -0.0176 0.7216 0.0245 -0.0240 0.0034 0.2601 0.0399 0.0363 -0.0465
  ; 0.0516
  (:action leans-on-101-by-101a-solid-to-any-low-11110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-to-any-low-11110 ?t ?r) (can-leans-on-101-by-101a-solid-to-any-low-11110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-101a-solid-to-any-low-11110 ?g))))

  ; Primitive 101 on pairs of the kind 11011 (hollow-tall-wide-to-hollow-low-wide-11011): ends in the state
  ; 101 (leans-on-101) in 7 of 20 rehearsals, at (0.49, 0.59, 0.49) touching units from the reference: cost
  ; 102.
  ; With a third object on the reference: 1 of 5 went so, and it is allowed.
  ; With a third object under the target: 4 of 8 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0318 -0.0348 -0.0051 0.9006 0.0193 0.0128 0.0121 0.0527 0.0434 0.0313 0.0419
  ; 0.5906
  (:action leans-on-101-by-101b-hollow-tall-wide-to-hollow-low-wide-11011
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (hollow-tall-wide-to-hollow-low-wide-11011 ?t ?r) (can-leans-on-101-by-101b-hollow-tall-wide-to-hollow-low-wide-11011 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-101b-hollow-tall-wide-to-hollow-low-wide-11011 ?g ?from))))

  ; Primitive 101 on pairs of the kind 11101 (any-to-any-11101): ends in the state 101 (leans-on-101) in 2
  ; of 30 rehearsals, at (0.15, -0.03, 0.49) touching units from the reference: cost 238.
  ; With a third object on the reference: 2 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0082 0.0014 -0.0166 0.5689 -0.0372 -0.0045 0.0104 0.3413 0.0232 -0.0004 0.0304
  ; 0.8891
  (:action leans-on-101-by-101d-any-to-any-11101
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-to-any-11101 ?t ?r) (can-leans-on-101-by-101d-any-to-any-11101 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-101d-any-to-any-11101 ?g))))

  ; Primitive 110 on pairs of the kind 00001 (hollow-low-wide-to-any-low-wide-00001): ends in the state 101
  ; (leans-on-101) in 2 of 30 rehearsals, at (-0.01, 0.01, 0.34) touching units from the reference: cost
  ; 238.
  ; With a third object on the reference: 5 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0007 -0.0350 -0.0089 0.5476 -0.0135 -0.0427 0.0069 0.0857 -0.0020 -0.0494 0.0384
  ; 0.1389
  (:action leans-on-101-by-110a-hollow-low-wide-to-any-low-wide-00001
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-low-wide-00001 ?t ?r) (can-leans-on-101-by-110a-hollow-low-wide-to-any-low-wide-00001 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-110a-hollow-low-wide-to-any-low-wide-00001 ?g))))

  ; Primitive 110 on pairs of the kind 00010 (hollow-tall-wide-to-any-tall-00010): ends in the state 101
  ; (leans-on-101) in 1 of 30 rehearsals, at (-0.01, 0.11, 0.40) touching units from the reference: cost
  ; 278.
  ; With a third object on the reference: 3 of 12 went so, and it is allowed.
  ; With a third object under the target: 2 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0013 -0.0363 -0.0053 0.5476 -0.0158 -0.0500 0.0091 0.0857 -0.0024 -0.0500 0.0419
  ; 0.1389
  (:action leans-on-101-by-110b-hollow-tall-wide-to-any-tall-00010
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (hollow-tall-wide-to-any-tall-00010 ?t ?r) (can-leans-on-101-by-110b-hollow-tall-wide-to-any-tall-00010 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-110b-hollow-tall-wide-to-any-tall-00010 ?g ?from))))

  ; Primitive 110 on pairs of the kind 00010 (hollow-tall-wide-to-any-tall-00010): ends in the state 101
  ; (leans-on-101) in 1 of 30 rehearsals, at (-0.02, 0.11, 0.40) touching units from the reference: cost
  ; 278.
  ; With a third object on the reference: 2 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0054 -0.0165 0.0077 0.5001 0.0289 -0.0082 -0.0178 0.4369 0.0066 -0.0500 -0.0390
  ; 0.7296
  (:action leans-on-101-by-110c-hollow-tall-wide-to-any-tall-00010
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-tall-wide-to-any-tall-00010 ?t ?r) (can-leans-on-101-by-110c-hollow-tall-wide-to-any-tall-00010 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-110c-hollow-tall-wide-to-any-tall-00010 ?g))))

  ; Primitive 110 on pairs of the kind 00011 (hollow-low-wide-to-any-low-00011): ends in the state 101
  ; (leans-on-101) in 4 of 29 rehearsals, at (0.01, 0.07, 0.31) touching units from the reference: cost 183.
  ; With a third object on the reference: 3 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0009 -0.0329 0.0017 0.9875 0.0285 0.0246 -0.0209 0.0635 0.0030 -0.0500 0.0319
  ; 0.2203
  (:action leans-on-101-by-110d-hollow-low-wide-to-any-low-00011
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-low-00011 ?t ?r) (can-leans-on-101-by-110d-hollow-low-wide-to-any-low-00011 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-110d-hollow-low-wide-to-any-low-00011 ?g))))

  ; Primitive 110 on pairs of the kind 00011 (hollow-low-wide-to-any-low-00011): ends in the state 101
  ; (leans-on-101) in 5 of 29 rehearsals, at (0.05, 0.09, 0.35) touching units from the reference: cost 165.
  ; With a third object on the reference: 3 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0070 -0.0303 -0.0099 0.5476 -0.0068 -0.0500 0.0040 0.0857 0.0007 -0.0500 0.0391
  ; 0.1389
  (:action leans-on-101-by-110e-hollow-low-wide-to-any-low-00011
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-low-00011 ?t ?r) (can-leans-on-101-by-110e-hollow-low-wide-to-any-low-00011 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-110e-hollow-low-wide-to-any-low-00011 ?g))))

  ; Primitive 110 on pairs of the kind 00111 (any-low-narrow-to-hollow-low-wide-00111): ends in the state
  ; 101 (leans-on-101) in 2 of 30 rehearsals, at (0.12, -0.45, 0.26) touching units from the reference: cost
  ; 238.
  ; With a third object on the reference: 4 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 6 went so, and it is forbidden.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: 0.0023 -0.0002 -0.0157 0.7216 0.0253 -0.0258 -0.0036 0.2601 0.0198 -0.0497 0.0010
  ; 0.4526
  (:action leans-on-101-by-110f-any-low-narrow-to-hollow-low-wide-00111
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-low-narrow-to-hollow-low-wide-00111 ?t ?r) (can-leans-on-101-by-110f-any-low-narrow-to-hollow-low-wide-00111 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-110f-any-low-narrow-to-hollow-low-wide-00111 ?g))))

  ; Primitive 110 on pairs of the kind 10110 (solid-low-narrow-to-hollow-low-10110): ends in the state 101
  ; (leans-on-101) in 1 of 19 rehearsals, at (0.17, -0.44, 0.56) touching units from the reference: cost
  ; 236.
  ; With a third object on the reference: 0 of 8 went so, and it is forbidden.
  ; With a third object under the target: 1 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: 0.0023 -0.0002 -0.0157 0.7216 0.0253 -0.0258 -0.0036 0.2601 0.0198 -0.0497 0.0010
  ; 0.4526
  (:action leans-on-101-by-110f-solid-low-narrow-to-hollow-low-10110
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (solid-low-narrow-to-hollow-low-10110 ?t ?r) (can-leans-on-101-by-110f-solid-low-narrow-to-hollow-low-10110 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-110f-solid-low-narrow-to-hollow-low-10110 ?g ?from))))

  ; Primitive 110 on pairs of the kind 01011 (hollow-low-wide-to-any-01011): ends in the state 101 (leans-
  ; on-101) in 8 of 30 rehearsals, at (0.02, 0.14, 0.41) touching units from the reference: cost 128.
  ; With a third object on the reference: 3 of 12 went so, and it is allowed.
  ; With a third object under the target: 1 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0035 -0.0346 -0.0074 0.5476 -0.0158 -0.0500 0.0053 0.0857 0.0008 -0.0500 0.0473
  ; 0.1389
  (:action leans-on-101-by-110i-hollow-low-wide-to-any-01011
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-01011 ?t ?r) (can-leans-on-101-by-110i-hollow-low-wide-to-any-01011 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-110i-hollow-low-wide-to-any-01011 ?g))))

  ; Primitive 110 on pairs of the kind 01011 (hollow-low-wide-to-any-01011): ends in the state 101 (leans-
  ; on-101) in 8 of 30 rehearsals, at (0.03, 0.14, 0.39) touching units from the reference: cost 128.
  ; With a third object on the reference: 2 of 12 went so, and it is allowed.
  ; With a third object under the target: 1 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0004 -0.0247 0.0021 0.6460 0.0479 -0.0403 0.0197 0.0099 0.0030 -0.0500 -0.0328
  ; 0.4593
  (:action leans-on-101-by-110j-hollow-low-wide-to-any-01011
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-01011 ?t ?r) (can-leans-on-101-by-110j-hollow-low-wide-to-any-01011 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-110j-hollow-low-wide-to-any-01011 ?g))))

  ; Primitive 110 on pairs of the kind 01011 (hollow-low-wide-to-any-01011): ends in the state 101 (leans-
  ; on-101) in 7 of 30 rehearsals, at (0.00, 0.13, 0.41) touching units from the reference: cost 140.
  ; With a third object on the reference: 2 of 12 went so, and it is allowed.
  ; With a third object under the target: 1 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0035 -0.0248 0.0018 0.6460 0.0424 -0.0427 0.0231 0.0099 0.0027 -0.0500 -0.0322
  ; 0.4593
  (:action leans-on-101-by-110k-hollow-low-wide-to-any-01011
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-01011 ?t ?r) (can-leans-on-101-by-110k-hollow-low-wide-to-any-01011 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-110k-hollow-low-wide-to-any-01011 ?g))))

  ; Primitive 110 on pairs of the kind 11101 (any-to-any-11101): ends in the state 101 (leans-on-101) in 2
  ; of 30 rehearsals, at (-0.02, -0.10, 0.56) touching units from the reference: cost 238.
  ; With a third object on the reference: 3 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0343 0.0102 -0.0188 0.9467 0.0215 0.0366 0.0003 0.4680 0.0307 -0.0179 -0.0317
  ; 0.8876
  (:action leans-on-101-by-110l-any-to-any-11101
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-to-any-11101 ?t ?r) (can-leans-on-101-by-110l-any-to-any-11101 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-110l-any-to-any-11101 ?g))))

  ; Primitive 111 on pairs of the kind 10111 (any-low-to-any-low-10111): ends in the state 101 (leans-
  ; on-101) in 15 of 30 rehearsals, at (0.72, -0.04, 0.35) touching units from the reference: cost 70.
  ; With a third object on the reference: 4 of 12 went so, and it is allowed.
  ; With a third object under the target: 4 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0457 -0.0131 -0.0111 0.6263 -0.0299 -0.0323 0.0189 0.1287 0.0412 0.0012 0.0021
  ; 0.0739
  (:action leans-on-101-by-111a-any-low-to-any-low-10111
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-low-to-any-low-10111 ?t ?r) (can-leans-on-101-by-111a-any-low-to-any-low-10111 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-111a-any-low-to-any-low-10111 ?g ?from))))

  ; Primitive 111 on pairs of the kind 11101 (any-to-any-11101): ends in the state 101 (leans-on-101) in 13
  ; of 30 rehearsals, at (0.68, -0.03, 0.39) touching units from the reference: cost 84.
  ; With a third object on the reference: 1 of 12 went so, and it is forbidden.
  ; With a third object under the target: 2 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0457 -0.0131 -0.0111 0.6263 -0.0299 -0.0323 0.0189 0.1287 0.0412 0.0012 0.0021
  ; 0.0739
  (:action leans-on-101-by-111a-any-to-any-11101
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-to-any-11101 ?t ?r) (can-leans-on-101-by-111a-any-to-any-11101 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-111a-any-to-any-11101 ?g))))

  ; Primitive 111 on pairs of the kind 00100 (solid-low-to-any-tall-narrow-00100): ends in the state 101
  ; (leans-on-101) in 16 of 27 rehearsals, at (0.74, -0.06, 0.33) touching units from the reference: cost
  ; 54.
  ; With a third object on the reference: 3 of 12 went so, and it is forbidden.
  ; With a third object under the target: 4 of 12 went so, and it is allowed.
  ; With a third object on the target: 1 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0457 -0.0131 -0.0111 0.6263 -0.0299 -0.0323 0.0189 0.1287 0.0412 0.0012 0.0021
  ; 0.0739
  (:action leans-on-101-by-111a-solid-low-to-any-tall-narrow-00100
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (solid-low-to-any-tall-narrow-00100 ?t ?r) (can-leans-on-101-by-111a-solid-low-to-any-tall-narrow-00100 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-111a-solid-low-to-any-tall-narrow-00100 ?g ?from))))

  ; Primitive 111 on pairs of the kind 00110 (any-tall-narrow-to-hollow-low-wide-00110): ends in the state
  ; 101 (leans-on-101) in 2 of 30 rehearsals, at (0.40, -0.48, 0.40) touching units from the reference: cost
  ; 238.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0010 0.0040 -0.0250 1.0000 -0.0204 0.0500 -0.0142 0.1094 0.0500 -0.0500 0.0185
  ; 0.8003
  (:action leans-on-101-by-111b-any-tall-narrow-to-hollow-low-wide-00110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-tall-narrow-to-hollow-low-wide-00110 ?t ?r) (can-leans-on-101-by-111b-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-111b-any-tall-narrow-to-hollow-low-wide-00110 ?g))))

  ; Primitive 111 on pairs of the kind 01110 (solid-narrow-to-hollow-low-wide-01110): ends in the state 101
  ; (leans-on-101) in 10 of 30 rehearsals, at (0.29, -0.45, 0.44) touching units from the reference: cost
  ; 108.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: 0.0010 0.0040 -0.0250 1.0000 -0.0204 0.0500 -0.0142 0.1094 0.0500 -0.0500 0.0185
  ; 0.8003
  (:action leans-on-101-by-111b-solid-narrow-to-hollow-low-wide-01110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-narrow-to-hollow-low-wide-01110 ?t ?r) (can-leans-on-101-by-111b-solid-narrow-to-hollow-low-wide-01110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-111b-solid-narrow-to-hollow-low-wide-01110 ?g))))

  ; Primitive 111 on pairs of the kind 01010 (solid-low-wide-to-any-01010): ends in the state 101 (leans-
  ; on-101) in 4 of 30 rehearsals, at (0.62, -0.36, 0.43) touching units from the reference: cost 187.
  ; With a third object on the reference: 1 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0141 -0.0014 -0.0134 0.7073 0.0235 -0.0265 -0.0024 0.2704 0.0414 -0.0289 -0.0440
  ; 0.4514
  (:action leans-on-101-by-111c-solid-low-wide-to-any-01010
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-low-wide-to-any-01010 ?t ?r) (can-leans-on-101-by-111c-solid-low-wide-to-any-01010 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-111c-solid-low-wide-to-any-01010 ?g))))

  ; Primitive 111 on pairs of the kind 01110 (solid-narrow-to-hollow-low-wide-01110): ends in the state 101
  ; (leans-on-101) in 6 of 30 rehearsals, at (0.42, -0.37, 0.39) touching units from the reference: cost
  ; 153.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 3 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0141 -0.0014 -0.0134 0.7073 0.0235 -0.0265 -0.0024 0.2704 0.0414 -0.0289 -0.0440
  ; 0.4514
  (:action leans-on-101-by-111c-solid-narrow-to-hollow-low-wide-01110
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (solid-narrow-to-hollow-low-wide-01110 ?t ?r) (can-leans-on-101-by-111c-solid-narrow-to-hollow-low-wide-01110 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-111c-solid-narrow-to-hollow-low-wide-01110 ?g ?from))))

  ; Primitive 111 on pairs of the kind 01011 (hollow-low-wide-to-any-01011): ends in the state 101 (leans-
  ; on-101) in 20 of 30 rehearsals, at (0.17, -0.56, 0.32) touching units from the reference: cost 43.
  ; With a third object on the reference: 3 of 12 went so, and it is forbidden.
  ; With a third object under the target: 1 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0105 0.0410 -0.0008 0.8975 -0.0011 0.0407 -0.0086 0.2878 0.0282 -0.0079 0.0342
  ; 0.6094
  (:action leans-on-101-by-111d-hollow-low-wide-to-any-01011
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-01011 ?t ?r) (can-leans-on-101-by-111d-hollow-low-wide-to-any-01011 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-111d-hollow-low-wide-to-any-01011 ?g))))

  ; Primitive 111 on pairs of the kind 01100 (any-to-any-narrow-01100): ends in the state 101 (leans-on-101)
  ; in 5 of 14 rehearsals, at (0.65, -0.14, 0.44) touching units from the reference: cost 99.
  ; With a third object on the reference: 3 of 12 went so, and it is allowed.
  ; With a third object under the target: 7 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0500 -0.0122 -0.0110 0.5947 -0.0307 -0.0321 0.0188 0.1299 0.0427 -0.0049 0.0021
  ; 0.0740
  (:action leans-on-101-by-111e-any-to-any-narrow-01100
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-to-any-narrow-01100 ?t ?r) (can-leans-on-101-by-111e-any-to-any-narrow-01100 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-111e-any-to-any-narrow-01100 ?g ?from))))

  ; Primitive 111 on pairs of the kind 10011 (any-tall-wide-to-solid-low-narrow-10011): ends in the state
  ; 101 (leans-on-101) in 3 of 8 rehearsals, at (0.58, -0.71, 0.38) touching units from the reference: cost
  ; 93.
  ; With a third object on the reference: 4 of 9 went so, and it is allowed.
  ; With a third object under the target: 0 of 11 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0163 0.0397 0.0052 0.9804 0.0070 0.0019 -0.0150 0.0597 0.0423 -0.0470 -0.0181
  ; 0.8119
  (:action leans-on-101-by-111f-any-tall-wide-to-solid-low-narrow-10011
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-tall-wide-to-solid-low-narrow-10011 ?t ?r) (can-leans-on-101-by-111f-any-tall-wide-to-solid-low-narrow-10011 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-101 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-leans-on-101-by-111f-any-tall-wide-to-solid-low-narrow-10011 ?g))))

  ; Primitive 000 on pairs of the kind 00110 (any-tall-narrow-to-hollow-low-wide-00110): ends in the state
  ; 011 (rests-on-011) in 14 of 30 rehearsals, at (-0.33, 0.44, 1.00) touching units from the reference:
  ; cost 77.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 3 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0077 -0.0016 -0.0250 0.5689 -0.0397 -0.0012 0.0142 0.3413 -0.0474 0.0499 0.0247
  ; 0.1703
  (:action rests-on-011-by-000b-any-tall-narrow-to-hollow-low-wide-00110
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-tall-narrow-to-hollow-low-wide-00110 ?t ?r) (can-rests-on-011-by-000b-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-000b-any-tall-narrow-to-hollow-low-wide-00110 ?g ?from))))

  ; Primitive 000 on pairs of the kind 00110 (any-tall-narrow-to-hollow-low-wide-00110): ends in the state
  ; 011 (rests-on-011) in 8 of 30 rehearsals, at (-0.33, 0.36, 1.00) touching units from the reference: cost
  ; 128.
  ; With a third object on the reference: 2 of 12 went so, and it is allowed.
  ; With a third object under the target: 2 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0095 0.0038 -0.0241 0.5983 0.0369 0.0362 -0.0183 0.3314 -0.0434 0.0384 -0.0224
  ; 0.3272
  (:action rests-on-011-by-000c-any-tall-narrow-to-hollow-low-wide-00110
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-tall-narrow-to-hollow-low-wide-00110 ?t ?r) (can-rests-on-011-by-000c-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-000c-any-tall-narrow-to-hollow-low-wide-00110 ?g ?from))))

  ; Primitive 000 on pairs of the kind 00111 (any-low-narrow-to-hollow-low-wide-00111): ends in the state
  ; 011 (rests-on-011) in 2 of 30 rehearsals, at (-0.14, 0.14, 0.69) touching units from the reference: cost
  ; 238.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 6 went so, and it is forbidden.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: -0.0171 0.0039 -0.0134 0.5509 0.0088 -0.0143 0.0124 0.1473 -0.0373 0.0177 0.0287
  ; 0.8104
  (:action rests-on-011-by-000d-any-low-narrow-to-hollow-low-wide-00111
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-low-narrow-to-hollow-low-wide-00111 ?t ?r) (can-rests-on-011-by-000d-any-low-narrow-to-hollow-low-wide-00111 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-000d-any-low-narrow-to-hollow-low-wide-00111 ?g))))

  ; Primitive 000 on pairs of the kind 10101 (any-to-solid-tall-10101): ends in the state 011 (rests-on-011)
  ; in 24 of 25 rehearsals, at (0.02, 0.42, 1.00) touching units from the reference: cost 9.
  ; With a third object on the reference: 0 of 4 went so, and it is forbidden.
  ; With a third object under the target: 7 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 6 went so, and it is forbidden.
  ; Action parameters: -0.0065 -0.0019 -0.0028 0.5883 0.0198 0.0136 0.0250 0.0655 -0.0044 0.0424 -0.0375
  ; 0.5995
  (:action rests-on-011-by-000f-any-to-solid-tall-10101
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-to-solid-tall-10101 ?t ?r) (can-rests-on-011-by-000f-any-to-solid-tall-10101 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-000f-any-to-solid-tall-10101 ?g ?from))))

  ; Primitive 000 on pairs of the kind 10111 (any-low-to-any-low-10111): ends in the state 011 (rests-
  ; on-011) in 27 of 30 rehearsals, at (0.02, 0.41, 1.00) touching units from the reference: cost 14.
  ; With a third object on the reference: 8 of 12 went so, and it is allowed.
  ; With a third object under the target: 11 of 12 went so, and it is allowed.
  ; With a third object on the target: 1 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0109 0.0022 -0.0097 0.5509 0.0065 -0.0034 0.0121 0.1473 -0.0095 0.0421 -0.0188
  ; 0.2281
  (:action rests-on-011-by-000g-any-low-to-any-low-10111
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-low-to-any-low-10111 ?t ?r) (can-rests-on-011-by-000g-any-low-to-any-low-10111 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-000g-any-low-to-any-low-10111 ?g ?from))))

  ; Primitive 000 on pairs of the kind 11101 (any-to-any-11101): ends in the state 011 (rests-on-011) in 25
  ; of 30 rehearsals, at (-0.01, 0.26, 0.97) touching units from the reference: cost 22.
  ; With a third object on the reference: 3 of 12 went so, and it is forbidden.
  ; With a third object under the target: 4 of 12 went so, and it is forbidden.
  ; With a third object on the target: 1 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0010 -0.0162 0.0021 0.6622 0.0461 -0.0458 0.0205 0.0098 -0.0006 0.0253 -0.0364
  ; 0.0856
  (:action rests-on-011-by-000h-any-to-any-11101
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-to-any-11101 ?t ?r) (can-rests-on-011-by-000h-any-to-any-11101 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-000h-any-to-any-11101 ?g))))

  ; Primitive 000 on pairs of the kind 11111 (any-low-wide-to-hollow-low-wide-11111): ends in the state 011
  ; (rests-on-011) in 30 of 30 rehearsals, at (-0.03, 0.45, 1.00) touching units from the reference: cost 4.
  ; With a third object on the reference: 3 of 12 went so, and it is forbidden.
  ; With a third object under the target: 11 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 9 went so, and it is forbidden.
  ; Action parameters: -0.0144 0.0010 -0.0120 0.5509 0.0028 -0.0072 0.0045 0.1473 -0.0188 0.0477 -0.0226
  ; 0.9613
  (:action rests-on-011-by-000i-any-low-wide-to-hollow-low-wide-11111
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-low-wide-to-hollow-low-wide-11111 ?t ?r) (can-rests-on-011-by-000i-any-low-wide-to-hollow-low-wide-11111 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-000i-any-low-wide-to-hollow-low-wide-11111 ?g ?from))))

  ; Primitive 001 on pairs of the kind 00010 (hollow-tall-wide-to-any-tall-00010): ends in the state 011
  ; (rests-on-011) in 17 of 30 rehearsals, at (-0.02, -0.19, 1.00) touching units from the reference: cost
  ; 59.
  ; With a third object on the reference: 1 of 12 went so, and it is forbidden.
  ; With a third object under the target: 2 of 12 went so, and it is forbidden.
  ; With a third object on the target: 3 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0034 0.0357 -0.0044 0.8133 -0.0269 0.0418 -0.0054 0.4819 -0.0000 0.0500 0.0030
  ; 0.9931
  (:action rests-on-011-by-001a-hollow-tall-wide-to-any-tall-00010
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-tall-wide-to-any-tall-00010 ?t ?r) (can-rests-on-011-by-001a-hollow-tall-wide-to-any-tall-00010 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-001a-hollow-tall-wide-to-any-tall-00010 ?g))))

  ; Primitive 001 on pairs of the kind 00111 (any-low-narrow-to-hollow-low-wide-00111): ends in the state
  ; 011 (rests-on-011) in 2 of 30 rehearsals, at (0.12, -0.06, 0.69) touching units from the reference: cost
  ; 238.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 6 went so, and it is forbidden.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: 0.0032 0.0299 -0.0049 0.7889 0.0455 -0.0267 0.0152 0.1240 0.0213 0.0140 0.0156 0.2049
  (:action rests-on-011-by-001c-any-low-narrow-to-hollow-low-wide-00111
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-low-narrow-to-hollow-low-wide-00111 ?t ?r) (can-rests-on-011-by-001c-any-low-narrow-to-hollow-low-wide-00111 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-001c-any-low-narrow-to-hollow-low-wide-00111 ?g))))

  ; Primitive 001 on pairs of the kind 01001 (hollow-low-wide-to-any-tall-01001): ends in the state 011
  ; (rests-on-011) in 21 of 30 rehearsals, at (0.03, -0.08, 1.00) touching units from the reference: cost
  ; 38.
  ; With a third object on the reference: 1 of 12 went so, and it is forbidden.
  ; With a third object under the target: 4 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0088 0.0326 0.0018 0.6484 0.0156 0.0379 0.0093 0.3897 0.0022 0.0500 -0.0091 0.3859
  (:action rests-on-011-by-001e-hollow-low-wide-to-any-tall-01001
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-tall-01001 ?t ?r) (can-rests-on-011-by-001e-hollow-low-wide-to-any-tall-01001 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-001e-hollow-low-wide-to-any-tall-01001 ?g))))

  ; Primitive 001 on pairs of the kind 10010 (hollow-tall-wide-to-hollow-tall-10010): ends in the state 011
  ; (rests-on-011) in 5 of 5 rehearsals, at (0.19, -0.21, 1.00) touching units from the reference: cost 16.
  ; With a third object on the reference: 5 of 6 went so, and it is allowed.
  ; With a third object under the target: 2 of 6 went so, and it is forbidden.
  ; With a third object on the target: never rehearsed, and forbidden.
  ; Action parameters: 0.0059 0.0295 -0.0030 0.6484 0.0199 0.0345 0.0027 0.3897 0.0243 0.0363 0.0357 0.4864
  (:action rests-on-011-by-001f-hollow-tall-wide-to-hollow-tall-10010
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-tall-wide-to-hollow-tall-10010 ?t ?r) (can-rests-on-011-by-001f-hollow-tall-wide-to-hollow-tall-10010 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-001f-hollow-tall-wide-to-hollow-tall-10010 ?g))))

  ; Primitive 001 on pairs of the kind 10110 (solid-low-narrow-to-hollow-low-10110): ends in the state 011
  ; (rests-on-011) in 13 of 19 rehearsals, at (0.02, -0.00, 0.93) touching units from the reference: cost
  ; 42.
  ; With a third object on the reference: 0 of 8 went so, and it is forbidden.
  ; With a third object under the target: 4 of 12 went so, and it is forbidden.
  ; With a third object on the target: 1 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0208 -0.0267 -0.0206 0.8967 -0.0325 -0.0092 0.0052 0.2104 -0.0209 0.0017 0.0413
  ; 0.8142
  (:action rests-on-011-by-001g-solid-low-narrow-to-hollow-low-10110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-low-narrow-to-hollow-low-10110 ?t ?r) (can-rests-on-011-by-001g-solid-low-narrow-to-hollow-low-10110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-001g-solid-low-narrow-to-hollow-low-10110 ?g))))

  ; Primitive 001 on pairs of the kind 11111 (any-low-wide-to-hollow-low-wide-11111): ends in the state 011
  ; (rests-on-011) in 29 of 30 rehearsals, at (0.13, 0.46, 1.00) touching units from the reference: cost 7.
  ; With a third object on the reference: 4 of 12 went so, and it is forbidden.
  ; With a third object under the target: 6 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 9 went so, and it is forbidden.
  ; Action parameters: -0.0057 0.0160 -0.0013 0.5883 -0.0004 -0.0119 0.0002 0.3127 0.0131 0.0499 -0.0444
  ; 0.4169
  (:action rests-on-011-by-001h-any-low-wide-to-hollow-low-wide-11111
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-low-wide-to-hollow-low-wide-11111 ?t ?r) (can-rests-on-011-by-001h-any-low-wide-to-hollow-low-wide-11111 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-001h-any-low-wide-to-hollow-low-wide-11111 ?g ?from))))

  ; Primitive 010 on pairs of the kind 00010 (hollow-tall-wide-to-any-tall-00010): ends in the state 011
  ; (rests-on-011) in 20 of 30 rehearsals, at (-0.33, 0.19, 1.00) touching units from the reference: cost
  ; 43.
  ; With a third object on the reference: 1 of 12 went so, and it is forbidden.
  ; With a third object under the target: 8 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0005 -0.0388 -0.0062 0.5476 -0.0185 -0.0496 0.0099 0.0857 -0.0370 -0.0424 -0.0225
  ; 0.7123
  (:action rests-on-011-by-010a-hollow-tall-wide-to-any-tall-00010
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (hollow-tall-wide-to-any-tall-00010 ?t ?r) (can-rests-on-011-by-010a-hollow-tall-wide-to-any-tall-00010 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-010a-hollow-tall-wide-to-any-tall-00010 ?g ?from))))

  ; Primitive 010 on pairs of the kind 01001 (hollow-low-wide-to-any-tall-01001): ends in the state 011
  ; (rests-on-011) in 4 of 30 rehearsals, at (-0.54, 0.07, 1.00) touching units from the reference: cost
  ; 187.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0329 0.0001 -0.0141 0.9212 0.0034 0.0056 0.0190 0.3138 -0.0492 0.0115 -0.0118
  ; 0.0274
  (:action rests-on-011-by-010b-hollow-low-wide-to-any-tall-01001
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-tall-01001 ?t ?r) (can-rests-on-011-by-010b-hollow-low-wide-to-any-tall-01001 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-010b-hollow-low-wide-to-any-tall-01001 ?g))))

  ; Primitive 010 on pairs of the kind 11010 (solid-tall-to-any-11010): ends in the state 011 (rests-on-011)
  ; in 3 of 30 rehearsals, at (-0.60, 0.08, 1.00) touching units from the reference: cost 209.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 1 of 12 went so, and it is allowed.
  ; Action parameters: 0.0329 0.0001 -0.0141 0.9212 0.0034 0.0056 0.0190 0.3138 -0.0492 0.0115 -0.0118
  ; 0.0274
  (:action rests-on-011-by-010b-solid-tall-to-any-11010
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-tall-to-any-11010 ?t ?r) (can-rests-on-011-by-010b-solid-tall-to-any-11010 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-010b-solid-tall-to-any-11010 ?g))))
  (:action rests-on-011-by-010b-solid-tall-to-any-11010-laden
    :parameters (?t ?r - movable ?p - place ?g - grade)
    :precondition (and (solid-tall-to-any-11010 ?t ?r) (can-rests-on-011-by-010b-solid-tall-to-any-11010 ?t ?r ?g) (taken ?t from-place) (stands ?r ?p) (exists (?x - movable) (rests-with ?x ?t)) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-010b-solid-tall-to-any-11010-laden ?g))))

  ; Primitive 010 on pairs of the kind 10111 (any-low-to-any-low-10111): ends in the state 011 (rests-
  ; on-011) in 2 of 30 rehearsals, at (-0.47, -0.05, 1.00) touching units from the reference: cost 238.
  ; With a third object on the reference: 1 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0282 -0.0223 -0.0141 0.6094 0.0119 0.0284 0.0177 0.0147 -0.0475 -0.0002 -0.0423
  ; 0.4675
  (:action rests-on-011-by-010d-any-low-to-any-low-10111
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-low-to-any-low-10111 ?t ?r) (can-rests-on-011-by-010d-any-low-to-any-low-10111 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-010d-any-low-to-any-low-10111 ?g))))

  ; Primitive 010 on pairs of the kind 11111 (any-low-wide-to-hollow-low-wide-11111): ends in the state 011
  ; (rests-on-011) in 8 of 30 rehearsals, at (-0.38, -0.19, 1.00) touching units from the reference: cost
  ; 128.
  ; With a third object on the reference: 2 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 9 went so, and it is forbidden.
  ; Action parameters: -0.0003 -0.0066 -0.0082 0.7718 0.0249 -0.0035 -0.0226 0.1445 -0.0500 -0.0155 0.0123
  ; 0.4293
  (:action rests-on-011-by-010e-any-low-wide-to-hollow-low-wide-11111
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-low-wide-to-hollow-low-wide-11111 ?t ?r) (can-rests-on-011-by-010e-any-low-wide-to-hollow-low-wide-11111 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-010e-any-low-wide-to-hollow-low-wide-11111 ?g))))

  ; Primitive 100 on pairs of the kind 11000 (any-tall-narrow-to-any-narrow-11000): ends in the state 011
  ; (rests-on-011) in 25 of 30 rehearsals, at (0.05, -0.05, 0.98) touching units from the reference: cost
  ; 22.
  ; With a third object on the reference: 4 of 12 went so, and it is forbidden.
  ; With a third object under the target: 7 of 12 went so, and it is allowed.
  ; With a third object on the target: 1 of 11 went so, and it is forbidden.
  ; Action parameters: -0.0102 -0.0030 -0.0044 0.5883 0.0169 0.0130 0.0194 0.0655 -0.0074 -0.0023 -0.0087
  ; 0.0460
  (:action rests-on-011-by-100a-any-tall-narrow-to-any-narrow-11000
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-tall-narrow-to-any-narrow-11000 ?t ?r) (can-rests-on-011-by-100a-any-tall-narrow-to-any-narrow-11000 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100a-any-tall-narrow-to-any-narrow-11000 ?g ?from))))

  ; Primitive 100 on pairs of the kind 10001 (any-tall-narrow-to-solid-narrow-10001): ends in the state 011
  ; (rests-on-011) in 25 of 26 rehearsals, at (0.05, -0.05, 1.00) touching units from the reference: cost 8.
  ; With a third object on the reference: 1 of 12 went so, and it is forbidden.
  ; With a third object under the target: 8 of 12 went so, and it is allowed.
  ; With a third object on the target: 1 of 9 went so, and it is forbidden.
  ; Action parameters: -0.0102 -0.0030 -0.0044 0.5883 0.0169 0.0130 0.0194 0.0655 -0.0074 -0.0023 -0.0087
  ; 0.0460
  (:action rests-on-011-by-100a-any-tall-narrow-to-solid-narrow-10001
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-tall-narrow-to-solid-narrow-10001 ?t ?r) (can-rests-on-011-by-100a-any-tall-narrow-to-solid-narrow-10001 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100a-any-tall-narrow-to-solid-narrow-10001 ?g ?from))))

  ; Primitive 100 on pairs of the kind 00001 (hollow-low-wide-to-any-low-wide-00001): ends in the state 011
  ; (rests-on-011) in 10 of 30 rehearsals, at (0.04, -0.03, 1.00) touching units from the reference: cost
  ; 108.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 2 of 12 went so, and it is allowed.
  ; With a third object on the target: 4 of 12 went so, and it is allowed.
  ; Action parameters: -0.0102 -0.0030 -0.0044 0.5883 0.0169 0.0130 0.0194 0.0655 -0.0074 -0.0023 -0.0087
  ; 0.0460
  (:action rests-on-011-by-100a-hollow-low-wide-to-any-low-wide-00001
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (hollow-low-wide-to-any-low-wide-00001 ?t ?r) (can-rests-on-011-by-100a-hollow-low-wide-to-any-low-wide-00001 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100a-hollow-low-wide-to-any-low-wide-00001 ?g ?from))))
  (:action rests-on-011-by-100a-hollow-low-wide-to-any-low-wide-00001-laden
    :parameters (?t ?r - movable ?p - place ?from - origin ?g - grade)
    :precondition (and (hollow-low-wide-to-any-low-wide-00001 ?t ?r) (can-rests-on-011-by-100a-hollow-low-wide-to-any-low-wide-00001 ?t ?r ?g) (taken ?t ?from) (stands ?r ?p) (exists (?x - movable) (rests-with ?x ?t)) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100a-hollow-low-wide-to-any-low-wide-00001-laden ?g ?from))))

  ; Primitive 100 on pairs of the kind 10110 (solid-low-narrow-to-hollow-low-10110): ends in the state 011
  ; (rests-on-011) in 15 of 19 rehearsals, at (0.03, -0.06, 0.94) touching units from the reference: cost
  ; 28.
  ; With a third object on the reference: 1 of 8 went so, and it is forbidden.
  ; With a third object under the target: 6 of 12 went so, and it is allowed.
  ; With a third object on the target: 1 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0102 -0.0030 -0.0044 0.5883 0.0169 0.0130 0.0194 0.0655 -0.0074 -0.0023 -0.0087
  ; 0.0460
  (:action rests-on-011-by-100a-solid-low-narrow-to-hollow-low-10110
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (solid-low-narrow-to-hollow-low-10110 ?t ?r) (can-rests-on-011-by-100a-solid-low-narrow-to-hollow-low-10110 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100a-solid-low-narrow-to-hollow-low-10110 ?g ?from))))

  ; Primitive 100 on pairs of the kind 01010 (solid-low-wide-to-any-01010): ends in the state 011 (rests-
  ; on-011) in 11 of 30 rehearsals, at (0.05, -0.03, 1.00) touching units from the reference: cost 99.
  ; With a third object on the reference: 1 of 12 went so, and it is forbidden.
  ; With a third object under the target: 4 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0102 -0.0030 -0.0044 0.5883 0.0169 0.0130 0.0194 0.0655 -0.0074 -0.0023 -0.0087
  ; 0.0460
  (:action rests-on-011-by-100a-solid-low-wide-to-any-01010
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (solid-low-wide-to-any-01010 ?t ?r) (can-rests-on-011-by-100a-solid-low-wide-to-any-01010 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100a-solid-low-wide-to-any-01010 ?g ?from))))

  ; Primitive 100 on pairs of the kind 00100 (solid-low-to-any-tall-narrow-00100): ends in the state 011
  ; (rests-on-011) in 23 of 27 rehearsals, at (0.03, -0.05, 1.00) touching units from the reference: cost
  ; 20.
  ; With a third object on the reference: 2 of 12 went so, and it is forbidden.
  ; With a third object under the target: 12 of 12 went so, and it is allowed.
  ; With a third object on the target: 2 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0032 -0.0077 -0.0003 0.8535 0.0035 0.0077 0.0116 0.0931 0.0005 0.0006 0.0094
  ; 0.1738
  (:action rests-on-011-by-100b-solid-low-to-any-tall-narrow-00100
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (solid-low-to-any-tall-narrow-00100 ?t ?r) (can-rests-on-011-by-100b-solid-low-to-any-tall-narrow-00100 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100b-solid-low-to-any-tall-narrow-00100 ?g ?from))))

  ; Primitive 100 on pairs of the kind 01110 (solid-narrow-to-hollow-low-wide-01110): ends in the state 011
  ; (rests-on-011) in 5 of 30 rehearsals, at (0.04, -0.01, 0.90) touching units from the reference: cost
  ; 168.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 5 of 12 went so, and it is allowed.
  ; With a third object on the target: 2 of 8 went so, and it is allowed.
  ; Action parameters: -0.0032 -0.0077 -0.0003 0.8535 0.0035 0.0077 0.0116 0.0931 0.0005 0.0006 0.0094
  ; 0.1738
  (:action rests-on-011-by-100b-solid-narrow-to-hollow-low-wide-01110
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (solid-narrow-to-hollow-low-wide-01110 ?t ?r) (can-rests-on-011-by-100b-solid-narrow-to-hollow-low-wide-01110 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100b-solid-narrow-to-hollow-low-wide-01110 ?g ?from))))
  (:action rests-on-011-by-100b-solid-narrow-to-hollow-low-wide-01110-laden
    :parameters (?t ?r - movable ?p - place ?from - origin ?g - grade)
    :precondition (and (solid-narrow-to-hollow-low-wide-01110 ?t ?r) (can-rests-on-011-by-100b-solid-narrow-to-hollow-low-wide-01110 ?t ?r ?g) (taken ?t ?from) (stands ?r ?p) (exists (?x - movable) (rests-with ?x ?t)) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100b-solid-narrow-to-hollow-low-wide-01110-laden ?g ?from))))

  ; Primitive 100 on pairs of the kind 00100 (solid-low-to-any-tall-narrow-00100): ends in the state 011
  ; (rests-on-011) in 22 of 27 rehearsals, at (0.10, -0.11, 1.00) touching units from the reference: cost
  ; 24.
  ; With a third object on the reference: 2 of 12 went so, and it is forbidden.
  ; With a third object under the target: 11 of 12 went so, and it is allowed.
  ; With a third object on the target: 2 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0020 0.0012 -0.0055 0.5883 0.0253 0.0106 0.0250 0.0655 0.0101 -0.0024 -0.0194
  ; 0.7451
  (:action rests-on-011-by-100c-solid-low-to-any-tall-narrow-00100
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (solid-low-to-any-tall-narrow-00100 ?t ?r) (can-rests-on-011-by-100c-solid-low-to-any-tall-narrow-00100 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100c-solid-low-to-any-tall-narrow-00100 ?g ?from))))

  ; Primitive 100 on pairs of the kind 00111 (any-low-narrow-to-hollow-low-wide-00111): ends in the state
  ; 011 (rests-on-011) in 3 of 30 rehearsals, at (-0.00, -0.04, 0.79) touching units from the reference:
  ; cost 209.
  ; With a third object on the reference: 4 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 6 went so, and it is forbidden.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: 0.0001 0.0122 0.0080 0.6141 -0.0237 -0.0116 -0.0099 0.2882 -0.0054 -0.0021 -0.0242
  ; 0.4343
  (:action rests-on-011-by-100d-any-low-narrow-to-hollow-low-wide-00111
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-low-narrow-to-hollow-low-wide-00111 ?t ?r) (can-rests-on-011-by-100d-any-low-narrow-to-hollow-low-wide-00111 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100d-any-low-narrow-to-hollow-low-wide-00111 ?g))))

  ; Primitive 100 on pairs of the kind 00111 (any-low-narrow-to-hollow-low-wide-00111): ends in the state
  ; 011 (rests-on-011) in 1 of 30 rehearsals, at (-0.09, -0.09, 0.39) touching units from the reference:
  ; cost 278.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 6 went so, and it is forbidden.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: -0.0056 0.0024 -0.0046 0.5883 0.0225 0.0178 0.0238 0.0655 -0.0180 -0.0052 -0.0125
  ; 0.0460
  (:action rests-on-011-by-100g-any-low-narrow-to-hollow-low-wide-00111
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-low-narrow-to-hollow-low-wide-00111 ?t ?r) (can-rests-on-011-by-100g-any-low-narrow-to-hollow-low-wide-00111 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100g-any-low-narrow-to-hollow-low-wide-00111 ?g))))

  ; Primitive 100 on pairs of the kind 00111 (any-low-narrow-to-hollow-low-wide-00111): ends in the state
  ; 011 (rests-on-011) in 3 of 30 rehearsals, at (-0.00, -0.05, 0.79) touching units from the reference:
  ; cost 209.
  ; With a third object on the reference: 3 of 12 went so, and it is allowed.
  ; With a third object under the target: 3 of 6 went so, and it is allowed.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: -0.0054 -0.0102 -0.0020 0.8535 -0.0015 0.0010 0.0152 0.0931 -0.0063 -0.0028 0.0093
  ; 0.1738
  (:action rests-on-011-by-100h-any-low-narrow-to-hollow-low-wide-00111
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-low-narrow-to-hollow-low-wide-00111 ?t ?r) (can-rests-on-011-by-100h-any-low-narrow-to-hollow-low-wide-00111 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100h-any-low-narrow-to-hollow-low-wide-00111 ?g ?from))))

  ; Primitive 100 on pairs of the kind 10011 (any-tall-wide-to-solid-low-narrow-10011): ends in the state
  ; 011 (rests-on-011) in 8 of 8 rehearsals, at (0.11, -0.00, 1.00) touching units from the reference: cost
  ; 12.
  ; With a third object on the reference: 0 of 9 went so, and it is forbidden.
  ; With a third object under the target: 7 of 11 went so, and it is allowed.
  ; With a third object on the target: 4 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0219 -0.0008 -0.0206 0.9212 0.0060 0.0044 0.0211 0.3138 0.0313 0.0021 0.0394 0.9677
  (:action rests-on-011-by-100i-any-tall-wide-to-solid-low-narrow-10011
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-tall-wide-to-solid-low-narrow-10011 ?t ?r) (can-rests-on-011-by-100i-any-tall-wide-to-solid-low-narrow-10011 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100i-any-tall-wide-to-solid-low-narrow-10011 ?g ?from))))

  ; Primitive 100 on pairs of the kind 01001 (hollow-low-wide-to-any-tall-01001): ends in the state 011
  ; (rests-on-011) in 24 of 30 rehearsals, at (0.08, 0.01, 1.00) touching units from the reference: cost 26.
  ; With a third object on the reference: 1 of 12 went so, and it is forbidden.
  ; With a third object under the target: 6 of 12 went so, and it is allowed.
  ; With a third object on the target: 2 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0219 -0.0008 -0.0206 0.9212 0.0060 0.0044 0.0211 0.3138 0.0313 0.0021 0.0394 0.9677
  (:action rests-on-011-by-100i-hollow-low-wide-to-any-tall-01001
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (hollow-low-wide-to-any-tall-01001 ?t ?r) (can-rests-on-011-by-100i-hollow-low-wide-to-any-tall-01001 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100i-hollow-low-wide-to-any-tall-01001 ?g ?from))))

  ; Primitive 100 on pairs of the kind 01100 (any-to-any-narrow-01100): ends in the state 011 (rests-on-011)
  ; in 12 of 14 rehearsals, at (0.00, 0.01, 0.99) touching units from the reference: cost 22.
  ; With a third object on the reference: 1 of 12 went so, and it is forbidden.
  ; With a third object under the target: 11 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0306 -0.0013 -0.0139 0.9212 0.0061 0.0145 0.0204 0.3138 0.0310 0.0030 0.0411 0.9677
  (:action rests-on-011-by-100j-any-to-any-narrow-01100
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-to-any-narrow-01100 ?t ?r) (can-rests-on-011-by-100j-any-to-any-narrow-01100 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100j-any-to-any-narrow-01100 ?g ?from))))

  ; Primitive 100 on pairs of the kind 01100 (any-to-any-narrow-01100): ends in the state 011 (rests-on-011)
  ; in 12 of 14 rehearsals, at (-0.08, -0.11, 1.00) touching units from the reference: cost 22.
  ; With a third object on the reference: 1 of 12 went so, and it is forbidden.
  ; With a third object under the target: 12 of 12 went so, and it is allowed.
  ; With a third object on the target: 2 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0110 -0.0027 -0.0021 0.5883 0.0218 0.0117 0.0250 0.0655 -0.0232 -0.0044 -0.0488
  ; 0.0431
  (:action rests-on-011-by-100k-any-to-any-narrow-01100
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-to-any-narrow-01100 ?t ?r) (can-rests-on-011-by-100k-any-to-any-narrow-01100 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100k-any-to-any-narrow-01100 ?g ?from))))

  ; Primitive 100 on pairs of the kind 11001 (any-tall-narrow-to-solid-narrow-11001): ends in the state 011
  ; (rests-on-011) in 29 of 30 rehearsals, at (-0.08, -0.06, 1.00) touching units from the reference: cost
  ; 7.
  ; With a third object on the reference: 0 of 7 went so, and it is forbidden.
  ; With a third object under the target: 10 of 12 went so, and it is allowed.
  ; With a third object on the target: 3 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0094 -0.0018 -0.0039 0.5883 0.0171 0.0110 0.0228 0.0655 -0.0146 -0.0042 -0.0114
  ; 0.0460
  (:action rests-on-011-by-100l-any-tall-narrow-to-solid-narrow-11001
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-tall-narrow-to-solid-narrow-11001 ?t ?r) (can-rests-on-011-by-100l-any-tall-narrow-to-solid-narrow-11001 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100l-any-tall-narrow-to-solid-narrow-11001 ?g ?from))))

  ; Primitive 100 on pairs of the kind 01110 (solid-narrow-to-hollow-low-wide-01110): ends in the state 011
  ; (rests-on-011) in 6 of 30 rehearsals, at (-0.04, -0.07, 0.92) touching units from the reference: cost
  ; 153.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 5 of 12 went so, and it is allowed.
  ; With a third object on the target: 4 of 8 went so, and it is allowed.
  ; Action parameters: -0.0094 -0.0018 -0.0039 0.5883 0.0171 0.0110 0.0228 0.0655 -0.0146 -0.0042 -0.0114
  ; 0.0460
  (:action rests-on-011-by-100l-solid-narrow-to-hollow-low-wide-01110
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (solid-narrow-to-hollow-low-wide-01110 ?t ?r) (can-rests-on-011-by-100l-solid-narrow-to-hollow-low-wide-01110 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100l-solid-narrow-to-hollow-low-wide-01110 ?g ?from))))
  (:action rests-on-011-by-100l-solid-narrow-to-hollow-low-wide-01110-laden
    :parameters (?t ?r - movable ?p - place ?from - origin ?g - grade)
    :precondition (and (solid-narrow-to-hollow-low-wide-01110 ?t ?r) (can-rests-on-011-by-100l-solid-narrow-to-hollow-low-wide-01110 ?t ?r ?g) (taken ?t ?from) (stands ?r ?p) (exists (?x - movable) (rests-with ?x ?t)) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100l-solid-narrow-to-hollow-low-wide-01110-laden ?g ?from))))

  ; Primitive 100 on pairs of the kind 01110 (solid-narrow-to-hollow-low-wide-01110): ends in the state 011
  ; (rests-on-011) in 5 of 30 rehearsals, at (0.02, 0.02, 0.90) touching units from the reference: cost 168.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 4 of 8 went so, and it is allowed.
  ; Action parameters: -0.0015 0.0078 0.0021 0.6141 -0.0214 -0.0075 -0.0097 0.2882 -0.0035 0.0035 -0.0207
  ; 0.4343
  (:action rests-on-011-by-100m-solid-narrow-to-hollow-low-wide-01110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-narrow-to-hollow-low-wide-01110 ?t ?r) (can-rests-on-011-by-100m-solid-narrow-to-hollow-low-wide-01110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100m-solid-narrow-to-hollow-low-wide-01110 ?g))))
  (:action rests-on-011-by-100m-solid-narrow-to-hollow-low-wide-01110-laden
    :parameters (?t ?r - movable ?p - place ?g - grade)
    :precondition (and (solid-narrow-to-hollow-low-wide-01110 ?t ?r) (can-rests-on-011-by-100m-solid-narrow-to-hollow-low-wide-01110 ?t ?r ?g) (taken ?t from-place) (stands ?r ?p) (exists (?x - movable) (rests-with ?x ?t)) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100m-solid-narrow-to-hollow-low-wide-01110-laden ?g))))

  ; Primitive 100 on pairs of the kind 01110 (solid-narrow-to-hollow-low-wide-01110): ends in the state 011
  ; (rests-on-011) in 6 of 30 rehearsals, at (0.03, 0.02, 0.92) touching units from the reference: cost 153.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 4 of 8 went so, and it is allowed.
  ; Action parameters: -0.0147 -0.0026 0.0063 0.7068 0.0083 0.0090 0.0033 0.0639 -0.0112 0.0037 0.0345
  ; 0.8890
  (:action rests-on-011-by-100n-solid-narrow-to-hollow-low-wide-01110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-narrow-to-hollow-low-wide-01110 ?t ?r) (can-rests-on-011-by-100n-solid-narrow-to-hollow-low-wide-01110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100n-solid-narrow-to-hollow-low-wide-01110 ?g))))
  (:action rests-on-011-by-100n-solid-narrow-to-hollow-low-wide-01110-laden
    :parameters (?t ?r - movable ?p - place ?g - grade)
    :precondition (and (solid-narrow-to-hollow-low-wide-01110 ?t ?r) (can-rests-on-011-by-100n-solid-narrow-to-hollow-low-wide-01110 ?t ?r ?g) (taken ?t from-place) (stands ?r ?p) (exists (?x - movable) (rests-with ?x ?t)) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100n-solid-narrow-to-hollow-low-wide-01110-laden ?g))))

  ; Primitive 100 on pairs of the kind 10100 (any-narrow-to-any-narrow-10100): ends in the state 011 (rests-
  ; on-011) in 22 of 30 rehearsals, at (0.00, -0.14, 0.97) touching units from the reference: cost 34.
  ; With a third object on the reference: 1 of 12 went so, and it is forbidden.
  ; With a third object under the target: 4 of 12 went so, and it is forbidden.
  ; With a third object on the target: 2 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0018 -0.0068 -0.0152 0.7216 0.0225 -0.0263 0.0036 0.2601 0.0017 -0.0045 0.0294
  ; 0.8375
  (:action rests-on-011-by-100o-any-narrow-to-any-narrow-10100
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-narrow-to-any-narrow-10100 ?t ?r) (can-rests-on-011-by-100o-any-narrow-to-any-narrow-10100 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100o-any-narrow-to-any-narrow-10100 ?g))))

  ; Primitive 100 on pairs of the kind 11000 (any-tall-narrow-to-any-narrow-11000): ends in the state 011
  ; (rests-on-011) in 25 of 30 rehearsals, at (0.03, 0.02, 0.98) touching units from the reference: cost 22.
  ; With a third object on the reference: 5 of 12 went so, and it is allowed.
  ; With a third object under the target: 2 of 12 went so, and it is forbidden.
  ; With a third object on the target: 1 of 11 went so, and it is forbidden.
  ; Action parameters: -0.0147 -0.0026 0.0063 0.7068 0.0083 0.0090 0.0033 0.0639 -0.0112 0.0037 0.0345
  ; 0.8890
  (:action rests-on-011-by-100p-any-tall-narrow-to-any-narrow-11000
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-tall-narrow-to-any-narrow-11000 ?t ?r) (can-rests-on-011-by-100p-any-tall-narrow-to-any-narrow-11000 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100p-any-tall-narrow-to-any-narrow-11000 ?g))))

  ; Primitive 100 on pairs of the kind 11011 (hollow-tall-wide-to-hollow-low-wide-11011): ends in the state
  ; 011 (rests-on-011) in 14 of 20 rehearsals, at (0.06, -0.06, 1.00) touching units from the reference:
  ; cost 39.
  ; With a third object on the reference: 0 of 5 went so, and it is forbidden.
  ; With a third object under the target: 4 of 8 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0118 -0.0019 -0.0182 0.7326 0.0220 -0.0246 0.0072 0.2435 -0.0041 -0.0067 0.0500
  ; 0.5072
  (:action rests-on-011-by-100q-hollow-tall-wide-to-hollow-low-wide-11011
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (hollow-tall-wide-to-hollow-low-wide-11011 ?t ?r) (can-rests-on-011-by-100q-hollow-tall-wide-to-hollow-low-wide-11011 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100q-hollow-tall-wide-to-hollow-low-wide-11011 ?g ?from))))

  ; Primitive 100 on pairs of the kind 11010 (solid-tall-to-any-11010): ends in the state 011 (rests-on-011)
  ; in 27 of 30 rehearsals, at (0.09, -0.07, 0.96) touching units from the reference: cost 14.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 4 of 12 went so, and it is forbidden.
  ; With a third object on the target: 4 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0118 -0.0019 -0.0182 0.7326 0.0220 -0.0246 0.0072 0.2435 -0.0041 -0.0067 0.0500
  ; 0.5072
  (:action rests-on-011-by-100q-solid-tall-to-any-11010
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-tall-to-any-11010 ?t ?r) (can-rests-on-011-by-100q-solid-tall-to-any-11010 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100q-solid-tall-to-any-11010 ?g))))

  ; Primitive 100 on pairs of the kind 11010 (solid-tall-to-any-11010): ends in the state 011 (rests-on-011)
  ; in 21 of 30 rehearsals, at (0.09, 0.00, 0.95) touching units from the reference: cost 38.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 4 of 12 went so, and it is forbidden.
  ; With a third object on the target: 4 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0146 0.0079 0.0035 0.7397 0.0063 0.0105 0.0056 0.0623 -0.0071 0.0024 0.0068 0.4147
  (:action rests-on-011-by-100r-solid-tall-to-any-11010
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-tall-to-any-11010 ?t ?r) (can-rests-on-011-by-100r-solid-tall-to-any-11010 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100r-solid-tall-to-any-11010 ?g))))

  ; Primitive 100 on pairs of the kind 11100 (solid-low-narrow-to-solid-narrow-11100): ends in the state 011
  ; (rests-on-011) in 30 of 30 rehearsals, at (-0.12, 0.02, 1.00) touching units from the reference: cost 4.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 10 of 12 went so, and it is allowed.
  ; With a third object on the target: 1 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0110 -0.0049 -0.0201 0.5737 -0.0402 0.0025 0.0142 0.3388 -0.0244 0.0033 0.0458
  ; 0.5451
  (:action rests-on-011-by-100s-solid-low-narrow-to-solid-narrow-11100
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (solid-low-narrow-to-solid-narrow-11100 ?t ?r) (can-rests-on-011-by-100s-solid-low-narrow-to-solid-narrow-11100 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100s-solid-low-narrow-to-solid-narrow-11100 ?g ?from))))

  ; Primitive 100 on pairs of the kind 11110 (solid-to-any-low-11110): ends in the state 011 (rests-on-011)
  ; in 22 of 30 rehearsals, at (-0.10, -0.08, 1.00) touching units from the reference: cost 34.
  ; With a third object on the reference: 2 of 12 went so, and it is forbidden.
  ; With a third object under the target: 8 of 12 went so, and it is allowed.
  ; With a third object on the target: 3 of 5 went so, and it is allowed.
  ; Action parameters: -0.0110 -0.0027 -0.0021 0.5883 0.0218 0.0117 0.0250 0.0655 -0.0232 -0.0044 -0.0488
  ; 0.0431
  (:action rests-on-011-by-100t-solid-to-any-low-11110
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (solid-to-any-low-11110 ?t ?r) (can-rests-on-011-by-100t-solid-to-any-low-11110 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100t-solid-to-any-low-11110 ?g ?from))))
  (:action rests-on-011-by-100t-solid-to-any-low-11110-laden
    :parameters (?t ?r - movable ?p - place ?from - origin ?g - grade)
    :precondition (and (solid-to-any-low-11110 ?t ?r) (can-rests-on-011-by-100t-solid-to-any-low-11110 ?t ?r ?g) (taken ?t ?from) (stands ?r ?p) (exists (?x - movable) (rests-with ?x ?t)) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-100t-solid-to-any-low-11110-laden ?g ?from))))

  ; Primitive 101 on pairs of the kind 11010 (solid-tall-to-any-11010): ends in the state 011 (rests-on-011)
  ; in 18 of 30 rehearsals, at (0.40, 0.31, 1.00) touching units from the reference: cost 53.
  ; With a third object on the reference: 1 of 12 went so, and it is forbidden.
  ; With a third object under the target: 3 of 12 went so, and it is forbidden.
  ; With a third object on the target: 4 of 12 went so, and it is allowed.
  ; Action parameters: -0.0012 0.0019 -0.0176 0.7216 0.0245 -0.0240 0.0034 0.2601 0.0399 0.0363 -0.0465
  ; 0.0516
  (:action rests-on-011-by-101a-solid-tall-to-any-11010
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-tall-to-any-11010 ?t ?r) (can-rests-on-011-by-101a-solid-tall-to-any-11010 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-101a-solid-tall-to-any-11010 ?g))))
  (:action rests-on-011-by-101a-solid-tall-to-any-11010-laden
    :parameters (?t ?r - movable ?p - place ?g - grade)
    :precondition (and (solid-tall-to-any-11010 ?t ?r) (can-rests-on-011-by-101a-solid-tall-to-any-11010 ?t ?r ?g) (taken ?t from-place) (stands ?r ?p) (exists (?x - movable) (rests-with ?x ?t)) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-101a-solid-tall-to-any-11010-laden ?g))))

  ; Primitive 101 on pairs of the kind 11110 (solid-to-any-low-11110): ends in the state 011 (rests-on-011)
  ; in 17 of 30 rehearsals, at (0.34, 0.34, 1.00) touching units from the reference: cost 59.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 6 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: -0.0012 0.0019 -0.0176 0.7216 0.0245 -0.0240 0.0034 0.2601 0.0399 0.0363 -0.0465
  ; 0.0516
  (:action rests-on-011-by-101a-solid-to-any-low-11110
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (solid-to-any-low-11110 ?t ?r) (can-rests-on-011-by-101a-solid-to-any-low-11110 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-101a-solid-to-any-low-11110 ?g ?from))))

  ; Primitive 101 on pairs of the kind 11100 (solid-low-narrow-to-solid-narrow-11100): ends in the state 011
  ; (rests-on-011) in 25 of 30 rehearsals, at (0.30, 0.36, 1.00) touching units from the reference: cost 22.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 3 of 12 went so, and it is forbidden.
  ; With a third object on the target: 1 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0002 -0.0022 -0.0215 0.7216 0.0205 -0.0268 0.0050 0.2601 0.0361 0.0234 -0.0195
  ; 0.2363
  (:action rests-on-011-by-101c-solid-low-narrow-to-solid-narrow-11100
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-low-narrow-to-solid-narrow-11100 ?t ?r) (can-rests-on-011-by-101c-solid-low-narrow-to-solid-narrow-11100 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-101c-solid-low-narrow-to-solid-narrow-11100 ?g))))

  ; Primitive 101 on pairs of the kind 11101 (any-to-any-11101): ends in the state 011 (rests-on-011) in 23
  ; of 30 rehearsals, at (0.24, -0.03, 1.00) touching units from the reference: cost 30.
  ; With a third object on the reference: 1 of 12 went so, and it is forbidden.
  ; With a third object under the target: 4 of 12 went so, and it is forbidden.
  ; With a third object on the target: 1 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0082 0.0014 -0.0166 0.5689 -0.0372 -0.0045 0.0104 0.3413 0.0232 -0.0004 0.0304
  ; 0.8891
  (:action rests-on-011-by-101d-any-to-any-11101
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-to-any-11101 ?t ?r) (can-rests-on-011-by-101d-any-to-any-11101 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-101d-any-to-any-11101 ?g))))

  ; Primitive 110 on pairs of the kind 00001 (hollow-low-wide-to-any-low-wide-00001): ends in the state 011
  ; (rests-on-011) in 12 of 30 rehearsals, at (-0.03, -0.00, 1.00) touching units from the reference: cost
  ; 91.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 3 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0007 -0.0350 -0.0089 0.5476 -0.0135 -0.0427 0.0069 0.0857 -0.0020 -0.0494 0.0384
  ; 0.1389
  (:action rests-on-011-by-110a-hollow-low-wide-to-any-low-wide-00001
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (hollow-low-wide-to-any-low-wide-00001 ?t ?r) (can-rests-on-011-by-110a-hollow-low-wide-to-any-low-wide-00001 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-110a-hollow-low-wide-to-any-low-wide-00001 ?g ?from))))

  ; Primitive 110 on pairs of the kind 00010 (hollow-tall-wide-to-any-tall-00010): ends in the state 011
  ; (rests-on-011) in 20 of 30 rehearsals, at (0.00, 0.14, 1.00) touching units from the reference: cost 43.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 8 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0013 -0.0363 -0.0053 0.5476 -0.0158 -0.0500 0.0091 0.0857 -0.0024 -0.0500 0.0419
  ; 0.1389
  (:action rests-on-011-by-110b-hollow-tall-wide-to-any-tall-00010
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (hollow-tall-wide-to-any-tall-00010 ?t ?r) (can-rests-on-011-by-110b-hollow-tall-wide-to-any-tall-00010 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-110b-hollow-tall-wide-to-any-tall-00010 ?g ?from))))

  ; Primitive 110 on pairs of the kind 00010 (hollow-tall-wide-to-any-tall-00010): ends in the state 011
  ; (rests-on-011) in 17 of 30 rehearsals, at (-0.01, 0.13, 1.00) touching units from the reference: cost
  ; 59.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0054 -0.0165 0.0077 0.5001 0.0289 -0.0082 -0.0178 0.4369 0.0066 -0.0500 -0.0390
  ; 0.7296
  (:action rests-on-011-by-110c-hollow-tall-wide-to-any-tall-00010
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-tall-wide-to-any-tall-00010 ?t ?r) (can-rests-on-011-by-110c-hollow-tall-wide-to-any-tall-00010 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-110c-hollow-tall-wide-to-any-tall-00010 ?g))))

  ; Primitive 110 on pairs of the kind 00011 (hollow-low-wide-to-any-low-00011): ends in the state 011
  ; (rests-on-011) in 10 of 29 rehearsals, at (0.01, 0.11, 1.00) touching units from the reference: cost
  ; 105.
  ; With a third object on the reference: 2 of 12 went so, and it is forbidden.
  ; With a third object under the target: 1 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0009 -0.0329 0.0017 0.9875 0.0285 0.0246 -0.0209 0.0635 0.0030 -0.0500 0.0319
  ; 0.2203
  (:action rests-on-011-by-110d-hollow-low-wide-to-any-low-00011
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-low-00011 ?t ?r) (can-rests-on-011-by-110d-hollow-low-wide-to-any-low-00011 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-110d-hollow-low-wide-to-any-low-00011 ?g))))

  ; Primitive 110 on pairs of the kind 00011 (hollow-low-wide-to-any-low-00011): ends in the state 011
  ; (rests-on-011) in 12 of 29 rehearsals, at (-0.04, 0.11, 1.00) touching units from the reference: cost
  ; 88.
  ; With a third object on the reference: 1 of 12 went so, and it is forbidden.
  ; With a third object under the target: 10 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0070 -0.0303 -0.0099 0.5476 -0.0068 -0.0500 0.0040 0.0857 0.0007 -0.0500 0.0391
  ; 0.1389
  (:action rests-on-011-by-110e-hollow-low-wide-to-any-low-00011
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (hollow-low-wide-to-any-low-00011 ?t ?r) (can-rests-on-011-by-110e-hollow-low-wide-to-any-low-00011 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-110e-hollow-low-wide-to-any-low-00011 ?g ?from))))

  ; Primitive 110 on pairs of the kind 00111 (any-low-narrow-to-hollow-low-wide-00111): ends in the state
  ; 011 (rests-on-011) in 27 of 30 rehearsals, at (0.13, -0.50, 1.00) touching units from the reference:
  ; cost 14.
  ; With a third object on the reference: 6 of 12 went so, and it is allowed.
  ; With a third object under the target: 3 of 6 went so, and it is allowed.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: 0.0023 -0.0002 -0.0157 0.7216 0.0253 -0.0258 -0.0036 0.2601 0.0198 -0.0497 0.0010
  ; 0.4526
  (:action rests-on-011-by-110f-any-low-narrow-to-hollow-low-wide-00111
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-low-narrow-to-hollow-low-wide-00111 ?t ?r) (can-rests-on-011-by-110f-any-low-narrow-to-hollow-low-wide-00111 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-110f-any-low-narrow-to-hollow-low-wide-00111 ?g ?from))))

  ; Primitive 110 on pairs of the kind 10110 (solid-low-narrow-to-hollow-low-10110): ends in the state 011
  ; (rests-on-011) in 13 of 19 rehearsals, at (0.16, -0.52, 1.00) touching units from the reference: cost
  ; 42.
  ; With a third object on the reference: 2 of 8 went so, and it is forbidden.
  ; With a third object under the target: 5 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: 0.0023 -0.0002 -0.0157 0.7216 0.0253 -0.0258 -0.0036 0.2601 0.0198 -0.0497 0.0010
  ; 0.4526
  (:action rests-on-011-by-110f-solid-low-narrow-to-hollow-low-10110
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (solid-low-narrow-to-hollow-low-10110 ?t ?r) (can-rests-on-011-by-110f-solid-low-narrow-to-hollow-low-10110 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-110f-solid-low-narrow-to-hollow-low-10110 ?g ?from))))

  ; Primitive 110 on pairs of the kind 00111 (any-low-narrow-to-hollow-low-wide-00111): ends in the state
  ; 011 (rests-on-011) in 25 of 30 rehearsals, at (-0.06, -0.51, 1.00) touching units from the reference:
  ; cost 22.
  ; With a third object on the reference: 4 of 12 went so, and it is forbidden.
  ; With a third object under the target: 3 of 6 went so, and it is allowed.
  ; With a third object on the target: 1 of 5 went so, and it is forbidden.
  ; Action parameters: 0.0428 0.0105 -0.0250 1.0000 -0.0500 0.0464 0.0230 0.0000 0.0325 -0.0500 -0.0500
  ; 0.1327
  (:action rests-on-011-by-110g-any-low-narrow-to-hollow-low-wide-00111
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-low-narrow-to-hollow-low-wide-00111 ?t ?r) (can-rests-on-011-by-110g-any-low-narrow-to-hollow-low-wide-00111 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-110g-any-low-narrow-to-hollow-low-wide-00111 ?g ?from))))

  ; Primitive 110 on pairs of the kind 01011 (hollow-low-wide-to-any-01011): ends in the state 011 (rests-
  ; on-011) in 11 of 30 rehearsals, at (0.01, 0.11, 1.00) touching units from the reference: cost 99.
  ; With a third object on the reference: 2 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0047 -0.0236 0.0094 0.5001 0.0229 -0.0064 -0.0166 0.4369 0.0034 -0.0500 -0.0402
  ; 0.7296
  (:action rests-on-011-by-110h-hollow-low-wide-to-any-01011
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-01011 ?t ?r) (can-rests-on-011-by-110h-hollow-low-wide-to-any-01011 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-110h-hollow-low-wide-to-any-01011 ?g))))

  ; Primitive 110 on pairs of the kind 01011 (hollow-low-wide-to-any-01011): ends in the state 011 (rests-
  ; on-011) in 11 of 30 rehearsals, at (0.01, 0.12, 1.00) touching units from the reference: cost 99.
  ; With a third object on the reference: 2 of 12 went so, and it is forbidden.
  ; With a third object under the target: 2 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0035 -0.0346 -0.0074 0.5476 -0.0158 -0.0500 0.0053 0.0857 0.0008 -0.0500 0.0473
  ; 0.1389
  (:action rests-on-011-by-110i-hollow-low-wide-to-any-01011
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-01011 ?t ?r) (can-rests-on-011-by-110i-hollow-low-wide-to-any-01011 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-110i-hollow-low-wide-to-any-01011 ?g))))

  ; Primitive 110 on pairs of the kind 01011 (hollow-low-wide-to-any-01011): ends in the state 011 (rests-
  ; on-011) in 11 of 30 rehearsals, at (0.02, 0.12, 1.00) touching units from the reference: cost 99.
  ; With a third object on the reference: 2 of 12 went so, and it is forbidden.
  ; With a third object under the target: 2 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0004 -0.0247 0.0021 0.6460 0.0479 -0.0403 0.0197 0.0099 0.0030 -0.0500 -0.0328
  ; 0.4593
  (:action rests-on-011-by-110j-hollow-low-wide-to-any-01011
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-01011 ?t ?r) (can-rests-on-011-by-110j-hollow-low-wide-to-any-01011 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-110j-hollow-low-wide-to-any-01011 ?g))))

  ; Primitive 110 on pairs of the kind 01011 (hollow-low-wide-to-any-01011): ends in the state 011 (rests-
  ; on-011) in 12 of 30 rehearsals, at (0.01, 0.11, 1.00) touching units from the reference: cost 91.
  ; With a third object on the reference: 2 of 12 went so, and it is forbidden.
  ; With a third object under the target: 2 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0035 -0.0248 0.0018 0.6460 0.0424 -0.0427 0.0231 0.0099 0.0027 -0.0500 -0.0322
  ; 0.4593
  (:action rests-on-011-by-110k-hollow-low-wide-to-any-01011
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-01011 ?t ?r) (can-rests-on-011-by-110k-hollow-low-wide-to-any-01011 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-110k-hollow-low-wide-to-any-01011 ?g))))

  ; Primitive 110 on pairs of the kind 11101 (any-to-any-11101): ends in the state 011 (rests-on-011) in 26
  ; of 30 rehearsals, at (-0.01, -0.26, 0.98) touching units from the reference: cost 18.
  ; With a third object on the reference: 2 of 12 went so, and it is forbidden.
  ; With a third object under the target: 5 of 12 went so, and it is forbidden.
  ; With a third object on the target: 2 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0343 0.0102 -0.0188 0.9467 0.0215 0.0366 0.0003 0.4680 0.0307 -0.0179 -0.0317
  ; 0.8876
  (:action rests-on-011-by-110l-any-to-any-11101
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-to-any-11101 ?t ?r) (can-rests-on-011-by-110l-any-to-any-11101 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-110l-any-to-any-11101 ?g))))

  ; Primitive 111 on pairs of the kind 10111 (any-low-to-any-low-10111): ends in the state 011 (rests-
  ; on-011) in 1 of 30 rehearsals, at (0.70, -0.04, 0.96) touching units from the reference: cost 278.
  ; With a third object on the reference: 1 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0457 -0.0131 -0.0111 0.6263 -0.0299 -0.0323 0.0189 0.1287 0.0412 0.0012 0.0021
  ; 0.0739
  (:action rests-on-011-by-111a-any-low-to-any-low-10111
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-low-to-any-low-10111 ?t ?r) (can-rests-on-011-by-111a-any-low-to-any-low-10111 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-111a-any-low-to-any-low-10111 ?g))))

  ; Primitive 111 on pairs of the kind 11101 (any-to-any-11101): ends in the state 011 (rests-on-011) in 1
  ; of 30 rehearsals, at (1.01, -0.08, 0.18) touching units from the reference: cost 278.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 1 of 12 went so, and it is allowed.
  ; Action parameters: -0.0457 -0.0131 -0.0111 0.6263 -0.0299 -0.0323 0.0189 0.1287 0.0412 0.0012 0.0021
  ; 0.0739
  (:action rests-on-011-by-111a-any-to-any-11101
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-to-any-11101 ?t ?r) (can-rests-on-011-by-111a-any-to-any-11101 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-111a-any-to-any-11101 ?g))))
  (:action rests-on-011-by-111a-any-to-any-11101-laden
    :parameters (?t ?r - movable ?p - place ?g - grade)
    :precondition (and (any-to-any-11101 ?t ?r) (can-rests-on-011-by-111a-any-to-any-11101 ?t ?r ?g) (taken ?t from-place) (stands ?r ?p) (exists (?x - movable) (rests-with ?x ?t)) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-111a-any-to-any-11101-laden ?g))))

  ; Primitive 111 on pairs of the kind 00100 (solid-low-to-any-tall-narrow-00100): ends in the state 011
  ; (rests-on-011) in 1 of 27 rehearsals, at (0.63, -0.07, 0.99) touching units from the reference: cost
  ; 268.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0457 -0.0131 -0.0111 0.6263 -0.0299 -0.0323 0.0189 0.1287 0.0412 0.0012 0.0021
  ; 0.0739
  (:action rests-on-011-by-111a-solid-low-to-any-tall-narrow-00100
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-low-to-any-tall-narrow-00100 ?t ?r) (can-rests-on-011-by-111a-solid-low-to-any-tall-narrow-00100 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-111a-solid-low-to-any-tall-narrow-00100 ?g))))

  ; Primitive 111 on pairs of the kind 00110 (any-tall-narrow-to-hollow-low-wide-00110): ends in the state
  ; 011 (rests-on-011) in 17 of 30 rehearsals, at (0.40, -0.45, 1.00) touching units from the reference:
  ; cost 59.
  ; With a third object on the reference: 5 of 12 went so, and it is allowed.
  ; With a third object under the target: 3 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0010 0.0040 -0.0250 1.0000 -0.0204 0.0500 -0.0142 0.1094 0.0500 -0.0500 0.0185
  ; 0.8003
  (:action rests-on-011-by-111b-any-tall-narrow-to-hollow-low-wide-00110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-tall-narrow-to-hollow-low-wide-00110 ?t ?r) (can-rests-on-011-by-111b-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-111b-any-tall-narrow-to-hollow-low-wide-00110 ?g))))

  ; Primitive 111 on pairs of the kind 01110 (solid-narrow-to-hollow-low-wide-01110): ends in the state 011
  ; (rests-on-011) in 9 of 30 rehearsals, at (0.49, -0.43, 1.00) touching units from the reference: cost
  ; 117.
  ; With a third object on the reference: 2 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: 0.0010 0.0040 -0.0250 1.0000 -0.0204 0.0500 -0.0142 0.1094 0.0500 -0.0500 0.0185
  ; 0.8003
  (:action rests-on-011-by-111b-solid-narrow-to-hollow-low-wide-01110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-narrow-to-hollow-low-wide-01110 ?t ?r) (can-rests-on-011-by-111b-solid-narrow-to-hollow-low-wide-01110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-111b-solid-narrow-to-hollow-low-wide-01110 ?g))))

  ; Primitive 111 on pairs of the kind 01010 (solid-low-wide-to-any-01010): ends in the state 011 (rests-
  ; on-011) in 2 of 30 rehearsals, at (0.46, -0.20, 1.00) touching units from the reference: cost 238.
  ; With a third object on the reference: 2 of 12 went so, and it is allowed.
  ; With a third object under the target: 3 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0141 -0.0014 -0.0134 0.7073 0.0235 -0.0265 -0.0024 0.2704 0.0414 -0.0289 -0.0440
  ; 0.4514
  (:action rests-on-011-by-111c-solid-low-wide-to-any-01010
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (solid-low-wide-to-any-01010 ?t ?r) (can-rests-on-011-by-111c-solid-low-wide-to-any-01010 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-111c-solid-low-wide-to-any-01010 ?g ?from))))

  ; Primitive 111 on pairs of the kind 01110 (solid-narrow-to-hollow-low-wide-01110): ends in the state 011
  ; (rests-on-011) in 16 of 30 rehearsals, at (0.53, -0.24, 0.96) touching units from the reference: cost
  ; 64.
  ; With a third object on the reference: 3 of 12 went so, and it is forbidden.
  ; With a third object under the target: 1 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0141 -0.0014 -0.0134 0.7073 0.0235 -0.0265 -0.0024 0.2704 0.0414 -0.0289 -0.0440
  ; 0.4514
  (:action rests-on-011-by-111c-solid-narrow-to-hollow-low-wide-01110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-narrow-to-hollow-low-wide-01110 ?t ?r) (can-rests-on-011-by-111c-solid-narrow-to-hollow-low-wide-01110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-011 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-rests-on-011-by-111c-solid-narrow-to-hollow-low-wide-01110 ?g))))

  ; Primitive 000 on pairs of the kind 00110 (any-tall-narrow-to-hollow-low-wide-00110): ends in the state
  ; 111 (sits-in-111) in 5 of 30 rehearsals, at (-0.13, 0.05, -0.01) touching units from the reference: cost
  ; 168.
  ; With a third object on the reference: 1 of 12 went so, and it is allowed.
  ; With a third object under the target: 3 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0077 -0.0016 -0.0250 0.5689 -0.0397 -0.0012 0.0142 0.3413 -0.0474 0.0499 0.0247
  ; 0.1703
  (:action sits-in-111-by-000b-any-tall-narrow-to-hollow-low-wide-00110
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-tall-narrow-to-hollow-low-wide-00110 ?t ?r) (can-sits-in-111-by-000b-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-000b-any-tall-narrow-to-hollow-low-wide-00110 ?g ?from))))

  ; Primitive 000 on pairs of the kind 00110 (any-tall-narrow-to-hollow-low-wide-00110): ends in the state
  ; 111 (sits-in-111) in 4 of 30 rehearsals, at (-0.07, 0.26, 0.08) touching units from the reference: cost
  ; 187.
  ; With a third object on the reference: 1 of 12 went so, and it is allowed.
  ; With a third object under the target: 2 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0095 0.0038 -0.0241 0.5983 0.0369 0.0362 -0.0183 0.3314 -0.0434 0.0384 -0.0224
  ; 0.3272
  (:action sits-in-111-by-000c-any-tall-narrow-to-hollow-low-wide-00110
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-tall-narrow-to-hollow-low-wide-00110 ?t ?r) (can-sits-in-111-by-000c-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-000c-any-tall-narrow-to-hollow-low-wide-00110 ?g ?from))))

  ; Primitive 000 on pairs of the kind 00111 (any-low-narrow-to-hollow-low-wide-00111): ends in the state
  ; 111 (sits-in-111) in 1 of 30 rehearsals, at (-0.11, 0.15, -0.26) touching units from the reference: cost
  ; 278.
  ; With a third object on the reference: 2 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 6 went so, and it is forbidden.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: -0.0171 0.0039 -0.0134 0.5509 0.0088 -0.0143 0.0124 0.1473 -0.0373 0.0177 0.0287
  ; 0.8104
  (:action sits-in-111-by-000d-any-low-narrow-to-hollow-low-wide-00111
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-low-narrow-to-hollow-low-wide-00111 ?t ?r) (can-sits-in-111-by-000d-any-low-narrow-to-hollow-low-wide-00111 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-000d-any-low-narrow-to-hollow-low-wide-00111 ?g))))

  ; Primitive 000 on pairs of the kind 10101 (any-to-solid-tall-10101): ends in the state 111 (sits-in-111)
  ; in 1 of 25 rehearsals, at (0.02, 0.05, -0.36) touching units from the reference: cost 261.
  ; With a third object on the reference: 2 of 4 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 6 went so, and it is forbidden.
  ; Action parameters: -0.0065 -0.0019 -0.0028 0.5883 0.0198 0.0136 0.0250 0.0655 -0.0044 0.0424 -0.0375
  ; 0.5995
  (:action sits-in-111-by-000f-any-to-solid-tall-10101
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-to-solid-tall-10101 ?t ?r) (can-sits-in-111-by-000f-any-to-solid-tall-10101 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-000f-any-to-solid-tall-10101 ?g))))

  ; Primitive 000 on pairs of the kind 10111 (any-low-to-any-low-10111): ends in the state 111 (sits-in-111)
  ; in 1 of 30 rehearsals, at (0.03, 0.02, 0.47) touching units from the reference: cost 278.
  ; With a third object on the reference: 2 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0109 0.0022 -0.0097 0.5509 0.0065 -0.0034 0.0121 0.1473 -0.0095 0.0421 -0.0188
  ; 0.2281
  (:action sits-in-111-by-000g-any-low-to-any-low-10111
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-low-to-any-low-10111 ?t ?r) (can-sits-in-111-by-000g-any-low-to-any-low-10111 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-000g-any-low-to-any-low-10111 ?g))))

  ; Primitive 000 on pairs of the kind 11101 (any-to-any-11101): ends in the state 111 (sits-in-111) in 1 of
  ; 30 rehearsals, at (-0.02, 0.28, 0.06) touching units from the reference: cost 278.
  ; With a third object on the reference: 3 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0010 -0.0162 0.0021 0.6622 0.0461 -0.0458 0.0205 0.0098 -0.0006 0.0253 -0.0364
  ; 0.0856
  (:action sits-in-111-by-000h-any-to-any-11101
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-to-any-11101 ?t ?r) (can-sits-in-111-by-000h-any-to-any-11101 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-000h-any-to-any-11101 ?g))))

  ; Primitive 001 on pairs of the kind 00111 (any-low-narrow-to-hollow-low-wide-00111): ends in the state
  ; 111 (sits-in-111) in 1 of 30 rehearsals, at (0.13, 0.11, -0.19) touching units from the reference: cost
  ; 278.
  ; With a third object on the reference: 2 of 12 went so, and it is allowed.
  ; With a third object under the target: 1 of 6 went so, and it is allowed.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: 0.0032 0.0299 -0.0049 0.7889 0.0455 -0.0267 0.0152 0.1240 0.0213 0.0140 0.0156 0.2049
  (:action sits-in-111-by-001c-any-low-narrow-to-hollow-low-wide-00111
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-low-narrow-to-hollow-low-wide-00111 ?t ?r) (can-sits-in-111-by-001c-any-low-narrow-to-hollow-low-wide-00111 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-001c-any-low-narrow-to-hollow-low-wide-00111 ?g ?from))))

  ; Primitive 001 on pairs of the kind 01001 (hollow-low-wide-to-any-tall-01001): ends in the state 111
  ; (sits-in-111) in 1 of 30 rehearsals, at (0.03, -0.05, -0.04) touching units from the reference: cost
  ; 278.
  ; With a third object on the reference: 6 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0088 0.0326 0.0018 0.6484 0.0156 0.0379 0.0093 0.3897 0.0022 0.0500 -0.0091 0.3859
  (:action sits-in-111-by-001e-hollow-low-wide-to-any-tall-01001
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-tall-01001 ?t ?r) (can-sits-in-111-by-001e-hollow-low-wide-to-any-tall-01001 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-001e-hollow-low-wide-to-any-tall-01001 ?g))))

  ; Primitive 100 on pairs of the kind 11000 (any-tall-narrow-to-any-narrow-11000): ends in the state 111
  ; (sits-in-111) in 4 of 30 rehearsals, at (0.05, -0.05, 0.07) touching units from the reference: cost 187.
  ; With a third object on the reference: 6 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 11 went so, and it is forbidden.
  ; Action parameters: -0.0102 -0.0030 -0.0044 0.5883 0.0169 0.0130 0.0194 0.0655 -0.0074 -0.0023 -0.0087
  ; 0.0460
  (:action sits-in-111-by-100a-any-tall-narrow-to-any-narrow-11000
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-tall-narrow-to-any-narrow-11000 ?t ?r) (can-sits-in-111-by-100a-any-tall-narrow-to-any-narrow-11000 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-100a-any-tall-narrow-to-any-narrow-11000 ?g))))

  ; Primitive 100 on pairs of the kind 00110 (any-tall-narrow-to-hollow-low-wide-00110): ends in the state
  ; 111 (sits-in-111) in 28 of 30 rehearsals, at (0.03, -0.04, 0.12) touching units from the reference: cost
  ; 11.
  ; With a third object on the reference: 5 of 12 went so, and it is forbidden.
  ; With a third object under the target: 9 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0102 -0.0030 -0.0044 0.5883 0.0169 0.0130 0.0194 0.0655 -0.0074 -0.0023 -0.0087
  ; 0.0460
  (:action sits-in-111-by-100a-any-tall-narrow-to-hollow-low-wide-00110
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-tall-narrow-to-hollow-low-wide-00110 ?t ?r) (can-sits-in-111-by-100a-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-100a-any-tall-narrow-to-hollow-low-wide-00110 ?g ?from))))

  ; Primitive 100 on pairs of the kind 10001 (any-tall-narrow-to-solid-narrow-10001): ends in the state 111
  ; (sits-in-111) in 1 of 26 rehearsals, at (0.01, -0.04, 0.23) touching units from the reference: cost 265.
  ; With a third object on the reference: 9 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 9 went so, and it is forbidden.
  ; Action parameters: -0.0102 -0.0030 -0.0044 0.5883 0.0169 0.0130 0.0194 0.0655 -0.0074 -0.0023 -0.0087
  ; 0.0460
  (:action sits-in-111-by-100a-any-tall-narrow-to-solid-narrow-10001
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-tall-narrow-to-solid-narrow-10001 ?t ?r) (can-sits-in-111-by-100a-any-tall-narrow-to-solid-narrow-10001 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-100a-any-tall-narrow-to-solid-narrow-10001 ?g))))

  ; Primitive 100 on pairs of the kind 00001 (hollow-low-wide-to-any-low-wide-00001): ends in the state 111
  ; (sits-in-111) in 12 of 30 rehearsals, at (0.02, -0.03, -0.05) touching units from the reference: cost
  ; 91.
  ; With a third object on the reference: 3 of 12 went so, and it is allowed.
  ; With a third object under the target: 3 of 12 went so, and it is allowed.
  ; With a third object on the target: 1 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0102 -0.0030 -0.0044 0.5883 0.0169 0.0130 0.0194 0.0655 -0.0074 -0.0023 -0.0087
  ; 0.0460
  (:action sits-in-111-by-100a-hollow-low-wide-to-any-low-wide-00001
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (hollow-low-wide-to-any-low-wide-00001 ?t ?r) (can-sits-in-111-by-100a-hollow-low-wide-to-any-low-wide-00001 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-100a-hollow-low-wide-to-any-low-wide-00001 ?g ?from))))

  ; Primitive 100 on pairs of the kind 10110 (solid-low-narrow-to-hollow-low-10110): ends in the state 111
  ; (sits-in-111) in 1 of 19 rehearsals, at (0.04, -0.04, 0.35) touching units from the reference: cost 236.
  ; With a third object on the reference: 5 of 8 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0102 -0.0030 -0.0044 0.5883 0.0169 0.0130 0.0194 0.0655 -0.0074 -0.0023 -0.0087
  ; 0.0460
  (:action sits-in-111-by-100a-solid-low-narrow-to-hollow-low-10110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-low-narrow-to-hollow-low-10110 ?t ?r) (can-sits-in-111-by-100a-solid-low-narrow-to-hollow-low-10110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-100a-solid-low-narrow-to-hollow-low-10110 ?g))))

  ; Primitive 100 on pairs of the kind 00100 (solid-low-to-any-tall-narrow-00100): ends in the state 111
  ; (sits-in-111) in 2 of 27 rehearsals, at (0.03, -0.06, -0.15) touching units from the reference: cost
  ; 228.
  ; With a third object on the reference: 7 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0032 -0.0077 -0.0003 0.8535 0.0035 0.0077 0.0116 0.0931 0.0005 0.0006 0.0094
  ; 0.1738
  (:action sits-in-111-by-100b-solid-low-to-any-tall-narrow-00100
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-low-to-any-tall-narrow-00100 ?t ?r) (can-sits-in-111-by-100b-solid-low-to-any-tall-narrow-00100 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-100b-solid-low-to-any-tall-narrow-00100 ?g))))

  ; Primitive 100 on pairs of the kind 01110 (solid-narrow-to-hollow-low-wide-01110): ends in the state 111
  ; (sits-in-111) in 14 of 30 rehearsals, at (0.05, -0.01, 0.07) touching units from the reference: cost 77.
  ; With a third object on the reference: 8 of 12 went so, and it is allowed.
  ; With a third object under the target: 1 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0032 -0.0077 -0.0003 0.8535 0.0035 0.0077 0.0116 0.0931 0.0005 0.0006 0.0094
  ; 0.1738
  (:action sits-in-111-by-100b-solid-narrow-to-hollow-low-wide-01110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-narrow-to-hollow-low-wide-01110 ?t ?r) (can-sits-in-111-by-100b-solid-narrow-to-hollow-low-wide-01110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-100b-solid-narrow-to-hollow-low-wide-01110 ?g))))

  ; Primitive 100 on pairs of the kind 00100 (solid-low-to-any-tall-narrow-00100): ends in the state 111
  ; (sits-in-111) in 1 of 27 rehearsals, at (0.11, -0.12, -0.29) touching units from the reference: cost
  ; 268.
  ; With a third object on the reference: 6 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0020 0.0012 -0.0055 0.5883 0.0253 0.0106 0.0250 0.0655 0.0101 -0.0024 -0.0194
  ; 0.7451
  (:action sits-in-111-by-100c-solid-low-to-any-tall-narrow-00100
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-low-to-any-tall-narrow-00100 ?t ?r) (can-sits-in-111-by-100c-solid-low-to-any-tall-narrow-00100 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-100c-solid-low-to-any-tall-narrow-00100 ?g))))

  ; Primitive 100 on pairs of the kind 00111 (any-low-narrow-to-hollow-low-wide-00111): ends in the state
  ; 111 (sits-in-111) in 23 of 30 rehearsals, at (0.00, -0.04, -0.03) touching units from the reference:
  ; cost 30.
  ; With a third object on the reference: 3 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 6 went so, and it is forbidden.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: 0.0001 0.0122 0.0080 0.6141 -0.0237 -0.0116 -0.0099 0.2882 -0.0054 -0.0021 -0.0242
  ; 0.4343
  (:action sits-in-111-by-100d-any-low-narrow-to-hollow-low-wide-00111
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-low-narrow-to-hollow-low-wide-00111 ?t ?r) (can-sits-in-111-by-100d-any-low-narrow-to-hollow-low-wide-00111 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-100d-any-low-narrow-to-hollow-low-wide-00111 ?g))))

  ; Primitive 100 on pairs of the kind 00110 (any-tall-narrow-to-hollow-low-wide-00110): ends in the state
  ; 111 (sits-in-111) in 24 of 30 rehearsals, at (-0.04, -0.05, 0.15) touching units from the reference:
  ; cost 26.
  ; With a third object on the reference: 5 of 12 went so, and it is allowed.
  ; With a third object under the target: 1 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0025 -0.0179 0.0070 0.5196 0.0311 -0.0089 -0.0192 0.4165 0.0083 -0.0034 -0.0467
  ; 0.3975
  (:action sits-in-111-by-100e-any-tall-narrow-to-hollow-low-wide-00110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-tall-narrow-to-hollow-low-wide-00110 ?t ?r) (can-sits-in-111-by-100e-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-100e-any-tall-narrow-to-hollow-low-wide-00110 ?g))))

  ; Primitive 100 on pairs of the kind 00110 (any-tall-narrow-to-hollow-low-wide-00110): ends in the state
  ; 111 (sits-in-111) in 27 of 30 rehearsals, at (-0.01, 0.01, 0.12) touching units from the reference: cost
  ; 14.
  ; With a third object on the reference: 5 of 12 went so, and it is forbidden.
  ; With a third object under the target: 8 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0112 0.0067 -0.0144 0.5509 0.0067 -0.0032 0.0052 0.1473 -0.0137 0.0038 0.0271
  ; 0.4250
  (:action sits-in-111-by-100f-any-tall-narrow-to-hollow-low-wide-00110
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-tall-narrow-to-hollow-low-wide-00110 ?t ?r) (can-sits-in-111-by-100f-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-100f-any-tall-narrow-to-hollow-low-wide-00110 ?g ?from))))

  ; Primitive 100 on pairs of the kind 00111 (any-low-narrow-to-hollow-low-wide-00111): ends in the state
  ; 111 (sits-in-111) in 7 of 30 rehearsals, at (-0.07, -0.07, -0.20) touching units from the reference:
  ; cost 140.
  ; With a third object on the reference: 3 of 12 went so, and it is allowed.
  ; With a third object under the target: 1 of 6 went so, and it is allowed.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: -0.0056 0.0024 -0.0046 0.5883 0.0225 0.0178 0.0238 0.0655 -0.0180 -0.0052 -0.0125
  ; 0.0460
  (:action sits-in-111-by-100g-any-low-narrow-to-hollow-low-wide-00111
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (any-low-narrow-to-hollow-low-wide-00111 ?t ?r) (can-sits-in-111-by-100g-any-low-narrow-to-hollow-low-wide-00111 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-100g-any-low-narrow-to-hollow-low-wide-00111 ?g ?from))))

  ; Primitive 100 on pairs of the kind 00111 (any-low-narrow-to-hollow-low-wide-00111): ends in the state
  ; 111 (sits-in-111) in 22 of 30 rehearsals, at (-0.00, -0.05, -0.03) touching units from the reference:
  ; cost 34.
  ; With a third object on the reference: 2 of 12 went so, and it is forbidden.
  ; With a third object under the target: 2 of 6 went so, and it is forbidden.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: -0.0054 -0.0102 -0.0020 0.8535 -0.0015 0.0010 0.0152 0.0931 -0.0063 -0.0028 0.0093
  ; 0.1738
  (:action sits-in-111-by-100h-any-low-narrow-to-hollow-low-wide-00111
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-low-narrow-to-hollow-low-wide-00111 ?t ?r) (can-sits-in-111-by-100h-any-low-narrow-to-hollow-low-wide-00111 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-100h-any-low-narrow-to-hollow-low-wide-00111 ?g))))

  ; Primitive 100 on pairs of the kind 01001 (hollow-low-wide-to-any-tall-01001): ends in the state 111
  ; (sits-in-111) in 2 of 30 rehearsals, at (0.11, 0.01, -0.23) touching units from the reference: cost 238.
  ; With a third object on the reference: 7 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0219 -0.0008 -0.0206 0.9212 0.0060 0.0044 0.0211 0.3138 0.0313 0.0021 0.0394 0.9677
  (:action sits-in-111-by-100i-hollow-low-wide-to-any-tall-01001
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-tall-01001 ?t ?r) (can-sits-in-111-by-100i-hollow-low-wide-to-any-tall-01001 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-100i-hollow-low-wide-to-any-tall-01001 ?g))))

  ; Primitive 100 on pairs of the kind 01100 (any-to-any-narrow-01100): ends in the state 111 (sits-in-111)
  ; in 2 of 14 rehearsals, at (0.01, -0.00, -0.01) touching units from the reference: cost 168.
  ; With a third object on the reference: 5 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0306 -0.0013 -0.0139 0.9212 0.0061 0.0145 0.0204 0.3138 0.0310 0.0030 0.0411 0.9677
  (:action sits-in-111-by-100j-any-to-any-narrow-01100
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-to-any-narrow-01100 ?t ?r) (can-sits-in-111-by-100j-any-to-any-narrow-01100 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-100j-any-to-any-narrow-01100 ?g))))

  ; Primitive 100 on pairs of the kind 01100 (any-to-any-narrow-01100): ends in the state 111 (sits-in-111)
  ; in 1 of 14 rehearsals, at (-0.13, -0.06, 0.00) touching units from the reference: cost 209.
  ; With a third object on the reference: 5 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0110 -0.0027 -0.0021 0.5883 0.0218 0.0117 0.0250 0.0655 -0.0232 -0.0044 -0.0488
  ; 0.0431
  (:action sits-in-111-by-100k-any-to-any-narrow-01100
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-to-any-narrow-01100 ?t ?r) (can-sits-in-111-by-100k-any-to-any-narrow-01100 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-100k-any-to-any-narrow-01100 ?g))))

  ; Primitive 100 on pairs of the kind 01110 (solid-narrow-to-hollow-low-wide-01110): ends in the state 111
  ; (sits-in-111) in 13 of 30 rehearsals, at (-0.05, -0.06, 0.05) touching units from the reference: cost
  ; 84.
  ; With a third object on the reference: 8 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0094 -0.0018 -0.0039 0.5883 0.0171 0.0110 0.0228 0.0655 -0.0146 -0.0042 -0.0114
  ; 0.0460
  (:action sits-in-111-by-100l-solid-narrow-to-hollow-low-wide-01110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-narrow-to-hollow-low-wide-01110 ?t ?r) (can-sits-in-111-by-100l-solid-narrow-to-hollow-low-wide-01110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-100l-solid-narrow-to-hollow-low-wide-01110 ?g))))

  ; Primitive 100 on pairs of the kind 01110 (solid-narrow-to-hollow-low-wide-01110): ends in the state 111
  ; (sits-in-111) in 14 of 30 rehearsals, at (0.02, 0.01, 0.07) touching units from the reference: cost 77.
  ; With a third object on the reference: 9 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0015 0.0078 0.0021 0.6141 -0.0214 -0.0075 -0.0097 0.2882 -0.0035 0.0035 -0.0207
  ; 0.4343
  (:action sits-in-111-by-100m-solid-narrow-to-hollow-low-wide-01110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-narrow-to-hollow-low-wide-01110 ?t ?r) (can-sits-in-111-by-100m-solid-narrow-to-hollow-low-wide-01110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-100m-solid-narrow-to-hollow-low-wide-01110 ?g))))

  ; Primitive 100 on pairs of the kind 01110 (solid-narrow-to-hollow-low-wide-01110): ends in the state 111
  ; (sits-in-111) in 21 of 30 rehearsals, at (0.03, 0.01, 0.09) touching units from the reference: cost 38.
  ; With a third object on the reference: 9 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0147 -0.0026 0.0063 0.7068 0.0083 0.0090 0.0033 0.0639 -0.0112 0.0037 0.0345
  ; 0.8890
  (:action sits-in-111-by-100n-solid-narrow-to-hollow-low-wide-01110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-narrow-to-hollow-low-wide-01110 ?t ?r) (can-sits-in-111-by-100n-solid-narrow-to-hollow-low-wide-01110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-100n-solid-narrow-to-hollow-low-wide-01110 ?g))))

  ; Primitive 100 on pairs of the kind 10100 (any-narrow-to-any-narrow-10100): ends in the state 111 (sits-
  ; in-111) in 3 of 30 rehearsals, at (-0.00, -0.10, 0.05) touching units from the reference: cost 209.
  ; With a third object on the reference: 7 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0018 -0.0068 -0.0152 0.7216 0.0225 -0.0263 0.0036 0.2601 0.0017 -0.0045 0.0294
  ; 0.8375
  (:action sits-in-111-by-100o-any-narrow-to-any-narrow-10100
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-narrow-to-any-narrow-10100 ?t ?r) (can-sits-in-111-by-100o-any-narrow-to-any-narrow-10100 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-100o-any-narrow-to-any-narrow-10100 ?g))))

  ; Primitive 100 on pairs of the kind 11000 (any-tall-narrow-to-any-narrow-11000): ends in the state 111
  ; (sits-in-111) in 4 of 30 rehearsals, at (0.03, 0.01, 0.07) touching units from the reference: cost 187.
  ; With a third object on the reference: 6 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 11 went so, and it is forbidden.
  ; Action parameters: -0.0147 -0.0026 0.0063 0.7068 0.0083 0.0090 0.0033 0.0639 -0.0112 0.0037 0.0345
  ; 0.8890
  (:action sits-in-111-by-100p-any-tall-narrow-to-any-narrow-11000
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-tall-narrow-to-any-narrow-11000 ?t ?r) (can-sits-in-111-by-100p-any-tall-narrow-to-any-narrow-11000 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-100p-any-tall-narrow-to-any-narrow-11000 ?g))))

  ; Primitive 100 on pairs of the kind 11010 (solid-tall-to-any-11010): ends in the state 111 (sits-in-111)
  ; in 1 of 30 rehearsals, at (0.13, -0.08, -0.01) touching units from the reference: cost 278.
  ; With a third object on the reference: 6 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0118 -0.0019 -0.0182 0.7326 0.0220 -0.0246 0.0072 0.2435 -0.0041 -0.0067 0.0500
  ; 0.5072
  (:action sits-in-111-by-100q-solid-tall-to-any-11010
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-tall-to-any-11010 ?t ?r) (can-sits-in-111-by-100q-solid-tall-to-any-11010 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-100q-solid-tall-to-any-11010 ?g))))

  ; Primitive 100 on pairs of the kind 11010 (solid-tall-to-any-11010): ends in the state 111 (sits-in-111)
  ; in 1 of 30 rehearsals, at (0.14, 0.00, -0.01) touching units from the reference: cost 278.
  ; With a third object on the reference: 6 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0146 0.0079 0.0035 0.7397 0.0063 0.0105 0.0056 0.0623 -0.0071 0.0024 0.0068 0.4147
  (:action sits-in-111-by-100r-solid-tall-to-any-11010
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-tall-to-any-11010 ?t ?r) (can-sits-in-111-by-100r-solid-tall-to-any-11010 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-100r-solid-tall-to-any-11010 ?g))))

  ; Primitive 101 on pairs of the kind 11010 (solid-tall-to-any-11010): ends in the state 111 (sits-in-111)
  ; in 1 of 30 rehearsals, at (0.40, 0.99, -0.02) touching units from the reference: cost 278.
  ; With a third object on the reference: 5 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0012 0.0019 -0.0176 0.7216 0.0245 -0.0240 0.0034 0.2601 0.0399 0.0363 -0.0465
  ; 0.0516
  (:action sits-in-111-by-101a-solid-tall-to-any-11010
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-tall-to-any-11010 ?t ?r) (can-sits-in-111-by-101a-solid-tall-to-any-11010 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-101a-solid-tall-to-any-11010 ?g))))

  ; Primitive 101 on pairs of the kind 11101 (any-to-any-11101): ends in the state 111 (sits-in-111) in 1 of
  ; 30 rehearsals, at (-0.19, 0.03, 0.17) touching units from the reference: cost 278.
  ; With a third object on the reference: 4 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0082 0.0014 -0.0166 0.5689 -0.0372 -0.0045 0.0104 0.3413 0.0232 -0.0004 0.0304
  ; 0.8891
  (:action sits-in-111-by-101d-any-to-any-11101
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-to-any-11101 ?t ?r) (can-sits-in-111-by-101d-any-to-any-11101 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-101d-any-to-any-11101 ?g))))

  ; Primitive 110 on pairs of the kind 00001 (hollow-low-wide-to-any-low-wide-00001): ends in the state 111
  ; (sits-in-111) in 10 of 30 rehearsals, at (-0.01, -0.01, -0.07) touching units from the reference: cost
  ; 108.
  ; With a third object on the reference: 2 of 12 went so, and it is allowed.
  ; With a third object under the target: 2 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0007 -0.0350 -0.0089 0.5476 -0.0135 -0.0427 0.0069 0.0857 -0.0020 -0.0494 0.0384
  ; 0.1389
  (:action sits-in-111-by-110a-hollow-low-wide-to-any-low-wide-00001
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (hollow-low-wide-to-any-low-wide-00001 ?t ?r) (can-sits-in-111-by-110a-hollow-low-wide-to-any-low-wide-00001 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-110a-hollow-low-wide-to-any-low-wide-00001 ?g ?from))))

  ; Primitive 110 on pairs of the kind 00111 (any-low-narrow-to-hollow-low-wide-00111): ends in the state
  ; 111 (sits-in-111) in 1 of 30 rehearsals, at (-0.05, -0.09, -0.26) touching units from the reference:
  ; cost 278.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 6 went so, and it is forbidden.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: 0.0428 0.0105 -0.0250 1.0000 -0.0500 0.0464 0.0230 0.0000 0.0325 -0.0500 -0.0500
  ; 0.1327
  (:action sits-in-111-by-110g-any-low-narrow-to-hollow-low-wide-00111
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-low-narrow-to-hollow-low-wide-00111 ?t ?r) (can-sits-in-111-by-110g-any-low-narrow-to-hollow-low-wide-00111 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-110g-any-low-narrow-to-hollow-low-wide-00111 ?g))))

  ; Primitive 110 on pairs of the kind 01011 (hollow-low-wide-to-any-01011): ends in the state 111 (sits-
  ; in-111) in 4 of 30 rehearsals, at (0.02, 0.16, -0.02) touching units from the reference: cost 187.
  ; With a third object on the reference: 4 of 12 went so, and it is allowed.
  ; With a third object under the target: 1 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0047 -0.0236 0.0094 0.5001 0.0229 -0.0064 -0.0166 0.4369 0.0034 -0.0500 -0.0402
  ; 0.7296
  (:action sits-in-111-by-110h-hollow-low-wide-to-any-01011
    :parameters (?t ?r - movable ?from - origin ?g - grade)
    :precondition (and (hollow-low-wide-to-any-01011 ?t ?r) (can-sits-in-111-by-110h-hollow-low-wide-to-any-01011 ?t ?r ?g) (taken ?t ?from) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t ?from)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-110h-hollow-low-wide-to-any-01011 ?g ?from))))

  ; Primitive 110 on pairs of the kind 01011 (hollow-low-wide-to-any-01011): ends in the state 111 (sits-
  ; in-111) in 5 of 30 rehearsals, at (0.02, 0.11, -0.04) touching units from the reference: cost 168.
  ; With a third object on the reference: 5 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0035 -0.0346 -0.0074 0.5476 -0.0158 -0.0500 0.0053 0.0857 0.0008 -0.0500 0.0473
  ; 0.1389
  (:action sits-in-111-by-110i-hollow-low-wide-to-any-01011
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-01011 ?t ?r) (can-sits-in-111-by-110i-hollow-low-wide-to-any-01011 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-110i-hollow-low-wide-to-any-01011 ?g))))

  ; Primitive 110 on pairs of the kind 01011 (hollow-low-wide-to-any-01011): ends in the state 111 (sits-
  ; in-111) in 5 of 30 rehearsals, at (0.03, 0.11, -0.04) touching units from the reference: cost 168.
  ; With a third object on the reference: 5 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0004 -0.0247 0.0021 0.6460 0.0479 -0.0403 0.0197 0.0099 0.0030 -0.0500 -0.0328
  ; 0.4593
  (:action sits-in-111-by-110j-hollow-low-wide-to-any-01011
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-01011 ?t ?r) (can-sits-in-111-by-110j-hollow-low-wide-to-any-01011 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-110j-hollow-low-wide-to-any-01011 ?g))))

  ; Primitive 110 on pairs of the kind 01011 (hollow-low-wide-to-any-01011): ends in the state 111 (sits-
  ; in-111) in 5 of 30 rehearsals, at (0.01, 0.11, -0.04) touching units from the reference: cost 168.
  ; With a third object on the reference: 4 of 12 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0035 -0.0248 0.0018 0.6460 0.0424 -0.0427 0.0231 0.0099 0.0027 -0.0500 -0.0322
  ; 0.4593
  (:action sits-in-111-by-110k-hollow-low-wide-to-any-01011
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (hollow-low-wide-to-any-01011 ?t ?r) (can-sits-in-111-by-110k-hollow-low-wide-to-any-01011 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-110k-hollow-low-wide-to-any-01011 ?g))))

  ; Primitive 111 on pairs of the kind 00110 (any-tall-narrow-to-hollow-low-wide-00110): ends in the state
  ; 111 (sits-in-111) in 2 of 30 rehearsals, at (0.59, -0.26, 0.08) touching units from the reference: cost
  ; 238.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0010 0.0040 -0.0250 1.0000 -0.0204 0.0500 -0.0142 0.1094 0.0500 -0.0500 0.0185
  ; 0.8003
  (:action sits-in-111-by-111b-any-tall-narrow-to-hollow-low-wide-00110
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (any-tall-narrow-to-hollow-low-wide-00110 ?t ?r) (can-sits-in-111-by-111b-any-tall-narrow-to-hollow-low-wide-00110 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-111b-any-tall-narrow-to-hollow-low-wide-00110 ?g))))

  ; Primitive 111 on pairs of the kind 01010 (solid-low-wide-to-any-01010): ends in the state 111 (sits-
  ; in-111) in 1 of 30 rehearsals, at (1.00, -0.26, 0.11) touching units from the reference: cost 278.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0141 -0.0014 -0.0134 0.7073 0.0235 -0.0265 -0.0024 0.2704 0.0414 -0.0289 -0.0440
  ; 0.4514
  (:action sits-in-111-by-111c-solid-low-wide-to-any-01010
    :parameters (?t ?r - movable ?g - grade)
    :precondition (and (solid-low-wide-to-any-01010 ?t ?r) (can-sits-in-111-by-111c-solid-low-wide-to-any-01010 ?t ?r ?g) (taken ?t from-place) (not (exists (?x - movable) (rests-with ?x ?t))) (not (exists (?x - movable) (rests-with ?x ?r))))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-111 ?t ?r) (rests-with ?t ?r) (increase (total-cost) (cost-of-sits-in-111-by-111c-solid-low-wide-to-any-01010 ?g))))

  ; Primitive 001 on category 11 (any-tall-narrow-11): carries to the place in 23 of 30 rehearsals, spread
  ; (1, 11.6) mm.
  ; With others close beside the object, 11 of 20 went so, and moved none.
  ; With another object on the place it stood there in 0 of 18; the place must be free.
  ; Action parameters: 0.0021 -0.0357 -0.0060 0.5476 -0.0130 -0.0494 0.0072 0.0857 -0.0268 -0.0247 0.0411
  ; 0.1389
  ; With a third object under the object: never rehearsed, and allowed.
  ; With a third object on the object: never rehearsed, and forbidden.
  (:action carry-to-001a-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11 ?to - place ?from - origin)
    :precondition (and (can-carry-to-001a-any-tall-narrow-11 ?o) (taken ?o ?from) (free ?to) (may-stand ?o ?to) (not (exists (?x - movable) (rests-with ?x ?o))) (not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p)))))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-001a-any-tall-narrow-11 ?o ?from))))

  ; Primitive 001 on category 00 (hollow-wide-00): carries to the place in 30 of 30 rehearsals, spread (1.2,
  ; 8.2) mm.
  ; With others close beside the object, 15 of 20 went so, and moved none.
  ; With another object on the place it stood there in 0 of 12; the place must be free.
  ; Action parameters: 0.0021 -0.0357 -0.0060 0.5476 -0.0130 -0.0494 0.0072 0.0857 -0.0268 -0.0247 0.0411
  ; 0.1389
  ; With a third object under the object: never rehearsed, and allowed.
  ; With a third object on the object: never rehearsed, and forbidden.
  (:action carry-to-001a-hollow-wide-00
    :parameters (?o - hollow-wide-00 ?to - place ?from - origin)
    :precondition (and (can-carry-to-001a-hollow-wide-00 ?o) (taken ?o ?from) (free ?to) (may-stand ?o ?to) (not (exists (?x - movable) (rests-with ?x ?o))) (not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p)))))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-001a-hollow-wide-00 ?o ?from))))

  ; Primitive 001 on category 01 (solid-low-narrow-01): carries to the place in 28 of 30 rehearsals, spread
  ; (1.4, 1.2) mm.
  ; With others close beside the object, 13 of 20 went so, and moved none.
  ; With another object on the place it stood there in 0 of 15; the place must be free.
  ; Action parameters: -0.0186 -0.0270 -0.0178 0.8967 -0.0360 -0.0090 0.0076 0.2104 -0.0466 0.0227 0.0432
  ; 0.8142
  ; With a third object under the object: never rehearsed, and allowed.
  ; With a third object on the object: never rehearsed, and forbidden.
  (:action carry-to-001b-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01 ?to - place ?from - origin)
    :precondition (and (can-carry-to-001b-solid-low-narrow-01 ?o) (taken ?o ?from) (free ?to) (may-stand ?o ?to) (not (exists (?x - movable) (rests-with ?x ?o))) (not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p)))))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-001b-solid-low-narrow-01 ?o ?from))))

  ; Primitive 010 on category 10 (solid-low-10): carries to the place in 1 of 31 rehearsals, spread (0, 0)
  ; mm.
  ; With others close beside the object, 0 of 20 went so, and moved none.
  ; With another object on the place it stood there in 0 of 13; the place must be free.
  ; Action parameters: -0.0042 0.0139 0.0109 0.6856 0.0391 0.0347 -0.0103 0.2368 -0.0324 -0.0439 0.0072
  ; 0.8542
  ; With a third object under the object: never rehearsed, and allowed.
  ; With a third object on the object: never rehearsed, and forbidden.
  (:action carry-to-010-solid-low-10
    :parameters (?o - solid-low-10 ?to - place ?from - origin)
    :precondition (and (can-carry-to-010-solid-low-10 ?o) (taken ?o ?from) (free ?to) (may-stand ?o ?to) (not (exists (?x - movable) (rests-with ?x ?o))) (not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p)))))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-010-solid-low-10 ?o ?from))))

  ; Primitive 010 on category 01 (solid-low-narrow-01): carries to the place in 28 of 30 rehearsals, spread
  ; (4.4, 1) mm.
  ; With others close beside the object, 5 of 20 went so, and moved none.
  ; With another object on the place it stood there in 0 of 15; the place must be free.
  ; Action parameters: -0.0042 0.0139 0.0109 0.6856 0.0391 0.0347 -0.0103 0.2368 -0.0324 -0.0439 0.0072
  ; 0.8542
  ; With a third object under the object: never rehearsed, and allowed.
  ; With a third object on the object: never rehearsed, and forbidden.
  (:action carry-to-010-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01 ?to - place ?from - origin)
    :precondition (and (can-carry-to-010-solid-low-narrow-01 ?o) (taken ?o ?from) (free ?to) (may-stand ?o ?to) (not (exists (?x - movable) (rests-with ?x ?o))) (not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p)))))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-010-solid-low-narrow-01 ?o ?from))))

  ; Primitive 010 on category 00 (hollow-wide-00): carries to the place in 25 of 30 rehearsals, spread (6.1,
  ; 7.8) mm.
  ; With others close beside the object, 13 of 20 went so, and moved none.
  ; With another object on the place it stood there in 3 of 12; the place must be free.
  ; Action parameters: -0.0108 0.0379 -0.0008 0.8975 -0.0019 0.0372 -0.0113 0.2878 -0.0193 -0.0254 0.0393
  ; 0.1989
  ; With a third object under the object: never rehearsed, and allowed.
  ; With a third object on the object: never rehearsed, and forbidden.
  (:action carry-to-010a-hollow-wide-00
    :parameters (?o - hollow-wide-00 ?to - place ?from - origin)
    :precondition (and (can-carry-to-010a-hollow-wide-00 ?o) (taken ?o ?from) (free ?to) (may-stand ?o ?to) (not (exists (?x - movable) (rests-with ?x ?o))) (not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p)))))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-010a-hollow-wide-00 ?o ?from))))

  ; Primitive 010 on category 11 (any-tall-narrow-11): carries to the place in 23 of 30 rehearsals, spread
  ; (4.1, 16.3) mm.
  ; With others close beside the object, 8 of 20 went so, and moved none.
  ; With another object on the place it stood there in 2 of 18; the place must be free.
  ; Action parameters: 0.0076 0.0337 -0.0020 0.6484 0.0160 0.0346 0.0063 0.3896 -0.0470 -0.0254 -0.0099
  ; 0.3859
  ; With a third object under the object: never rehearsed, and allowed.
  ; With a third object on the object: never rehearsed, and forbidden.
  (:action carry-to-010b-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11 ?to - place ?from - origin)
    :precondition (and (can-carry-to-010b-any-tall-narrow-11 ?o) (taken ?o ?from) (free ?to) (may-stand ?o ?to) (not (exists (?x - movable) (rests-with ?x ?o))) (not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p)))))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-010b-any-tall-narrow-11 ?o ?from))))

  ; Primitive 011 on category 00 (hollow-wide-00): carries to the place in 29 of 30 rehearsals, spread (3,
  ; 7.3) mm.
  ; With others close beside the object, 12 of 20 went so, and moved none.
  ; With another object on the place it stood there in 1 of 12; the place must be free.
  ; Action parameters: -0.0041 -0.0213 0.0065 0.5001 0.0289 -0.0064 -0.0195 0.4369 -0.0289 -0.0487 -0.0355
  ; 0.7296
  ; With a third object under the object: never rehearsed, and allowed.
  ; With a third object on the object: never rehearsed, and forbidden.
  (:action carry-to-011a-hollow-wide-00
    :parameters (?o - hollow-wide-00 ?to - place ?from - origin)
    :precondition (and (can-carry-to-011a-hollow-wide-00 ?o) (taken ?o ?from) (free ?to) (may-stand ?o ?to) (not (exists (?x - movable) (rests-with ?x ?o))) (not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p)))))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-011a-hollow-wide-00 ?o ?from))))

  ; Primitive 011 on category 01 (solid-low-narrow-01): carries to the place in 30 of 30 rehearsals, spread
  ; (0.3, 1) mm.
  ; With others close beside the object, 14 of 20 went so, and moved none.
  ; With another object on the place it stood there in 0 of 15; the place must be free.
  ; Action parameters: -0.0110 -0.0042 -0.0219 0.5689 -0.0366 -0.0031 0.0115 0.3413 -0.0358 -0.0268 0.0289
  ; 0.0626
  ; With a third object under the object: never rehearsed, and allowed.
  ; With a third object on the object: never rehearsed, and forbidden.
  (:action carry-to-011b-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01 ?to - place ?from - origin)
    :precondition (and (can-carry-to-011b-solid-low-narrow-01 ?o) (taken ?o ?from) (free ?to) (may-stand ?o ?to) (not (exists (?x - movable) (rests-with ?x ?o))) (not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p)))))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-011b-solid-low-narrow-01 ?o ?from))))

  ; Primitive 011 on category 10 (solid-low-10): carries to the place in 10 of 31 rehearsals, spread (0.2,
  ; 0.4) mm.
  ; With others close beside the object, 5 of 20 went so, and moved none.
  ; With another object on the place it stood there in 1 of 13; the place must be free.
  ; Action parameters: 0.0275 0.0013 -0.0216 0.6902 0.0308 0.0280 -0.0172 0.0684 -0.0473 -0.0112 0.0444
  ; 0.9532
  ; With a third object under the object: never rehearsed, and allowed.
  ; With a third object on the object: never rehearsed, and forbidden.
  (:action carry-to-011c-solid-low-10
    :parameters (?o - solid-low-10 ?to - place ?from - origin)
    :precondition (and (can-carry-to-011c-solid-low-10 ?o) (taken ?o ?from) (free ?to) (may-stand ?o ?to) (not (exists (?x - movable) (rests-with ?x ?o))) (not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p)))))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-011c-solid-low-10 ?o ?from))))

  ; Primitive 011 on category 11 (any-tall-narrow-11): carries to the place in 30 of 30 rehearsals, spread
  ; (0.3, 0.5) mm.
  ; With others close beside the object, 19 of 20 went so, and moved none.
  ; With another object on the place it stood there in 0 of 18; the place must be free.
  ; Action parameters: -0.0099 0.0002 -0.0058 0.5883 0.0207 0.0125 0.0240 0.0655 -0.0500 -0.0435 -0.0115
  ; 0.0460
  ; With a third object under the object: never rehearsed, and allowed.
  ; With a third object on the object: never rehearsed, and forbidden.
  (:action carry-to-011d-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11 ?to - place ?from - origin)
    :precondition (and (can-carry-to-011d-any-tall-narrow-11 ?o) (taken ?o ?from) (free ?to) (may-stand ?o ?to) (not (exists (?x - movable) (rests-with ?x ?o))) (not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p)))))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-011d-any-tall-narrow-11 ?o ?from))))

  ; Primitive 100 on category 11 (any-tall-narrow-11): carries to the place in 30 of 30 rehearsals, spread
  ; (0.4, 0.6) mm.
  ; With others close beside the object, 18 of 20 went so, and moved none.
  ; With another object on the place it stood there in 1 of 18; the place must be free.
  ; Action parameters: -0.0148 0.0027 -0.0122 0.5509 0.0072 -0.0078 0.0074 0.1473 0.0266 -0.0250 0.0279
  ; 0.4250
  ; With a third object under the object: never rehearsed, and allowed.
  ; With a third object on the object: never rehearsed, and forbidden.
  (:action carry-to-100-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11 ?to - place ?from - origin)
    :precondition (and (can-carry-to-100-any-tall-narrow-11 ?o) (taken ?o ?from) (free ?to) (may-stand ?o ?to) (not (exists (?x - movable) (rests-with ?x ?o))) (not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p)))))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-100-any-tall-narrow-11 ?o ?from))))

  ; Primitive 100 on category 10 (solid-low-10): carries to the place in 9 of 31 rehearsals, spread (0.3,
  ; 0.4) mm.
  ; With others close beside the object, 6 of 20 went so, and moved none.
  ; With another object on the place it stood there in 1 of 13; the place must be free.
  ; Action parameters: -0.0148 0.0027 -0.0122 0.5509 0.0072 -0.0078 0.0074 0.1473 0.0266 -0.0250 0.0279
  ; 0.4250
  ; With a third object under the object: never rehearsed, and allowed.
  ; With a third object on the object: never rehearsed, and forbidden.
  (:action carry-to-100-solid-low-10
    :parameters (?o - solid-low-10 ?to - place ?from - origin)
    :precondition (and (can-carry-to-100-solid-low-10 ?o) (taken ?o ?from) (free ?to) (may-stand ?o ?to) (not (exists (?x - movable) (rests-with ?x ?o))) (not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p)))))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-100-solid-low-10 ?o ?from))))

  ; Primitive 100 on category 01 (solid-low-narrow-01): carries to the place in 30 of 30 rehearsals, spread
  ; (0.3, 0.9) mm.
  ; With others close beside the object, 18 of 20 went so, and moved none.
  ; With another object on the place it stood there in 0 of 15; the place must be free.
  ; Action parameters: -0.0148 0.0027 -0.0122 0.5509 0.0072 -0.0078 0.0074 0.1473 0.0266 -0.0250 0.0279
  ; 0.4250
  ; With a third object under the object: never rehearsed, and allowed.
  ; With a third object on the object: never rehearsed, and forbidden.
  (:action carry-to-100-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01 ?to - place ?from - origin)
    :precondition (and (can-carry-to-100-solid-low-narrow-01 ?o) (taken ?o ?from) (free ?to) (may-stand ?o ?to) (not (exists (?x - movable) (rests-with ?x ?o))) (not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p)))))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-100-solid-low-narrow-01 ?o ?from))))

  ; Primitive 100 on category 00 (hollow-wide-00): carries to the place in 30 of 30 rehearsals, spread (3.2,
  ; 8) mm.
  ; With others close beside the object, 11 of 20 went so, and moved none.
  ; With another object on the place it stood there in 0 of 12; the place must be free.
  ; Action parameters: -0.0037 -0.0235 0.0009 0.6460 0.0430 -0.0426 0.0163 0.0099 0.0462 -0.0498 -0.0312
  ; 0.4593
  ; With a third object under the object: never rehearsed, and allowed.
  ; With a third object on the object: never rehearsed, and forbidden.
  (:action carry-to-100a-hollow-wide-00
    :parameters (?o - hollow-wide-00 ?to - place ?from - origin)
    :precondition (and (can-carry-to-100a-hollow-wide-00 ?o) (taken ?o ?from) (free ?to) (may-stand ?o ?to) (not (exists (?x - movable) (rests-with ?x ?o))) (not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p)))))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-100a-hollow-wide-00 ?o ?from))))

  ; Primitive 101 on category 11 (any-tall-narrow-11): carries to the place in 26 of 30 rehearsals, spread
  ; (0.8, 0.5) mm.
  ; With others close beside the object, 15 of 20 went so, and moved none.
  ; With another object on the place it stood there in 0 of 18; the place must be free.
  ; Action parameters: 0.0288 -0.0036 -0.0176 0.9212 0.0083 0.0081 0.0208 0.3138 0.0413 0.0357 0.0344 0.9677
  ; With a third object under the object: never rehearsed, and allowed.
  ; With a third object on the object: never rehearsed, and forbidden.
  (:action carry-to-101-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11 ?to - place ?from - origin)
    :precondition (and (can-carry-to-101-any-tall-narrow-11 ?o) (taken ?o ?from) (free ?to) (may-stand ?o ?to) (not (exists (?x - movable) (rests-with ?x ?o))) (not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p)))))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-101-any-tall-narrow-11 ?o ?from))))

  ; Primitive 101 on category 10 (solid-low-10): carries to the place in 4 of 31 rehearsals, spread (0.5,
  ; 0.2) mm.
  ; With others close beside the object, 6 of 20 went so, and moved none.
  ; With another object on the place it stood there in 0 of 13; the place must be free.
  ; Action parameters: 0.0288 -0.0036 -0.0176 0.9212 0.0083 0.0081 0.0208 0.3138 0.0413 0.0357 0.0344 0.9677
  ; With a third object under the object: never rehearsed, and allowed.
  ; With a third object on the object: never rehearsed, and forbidden.
  (:action carry-to-101-solid-low-10
    :parameters (?o - solid-low-10 ?to - place ?from - origin)
    :precondition (and (can-carry-to-101-solid-low-10 ?o) (taken ?o ?from) (free ?to) (may-stand ?o ?to) (not (exists (?x - movable) (rests-with ?x ?o))) (not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p)))))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-101-solid-low-10 ?o ?from))))

  ; Primitive 101 on category 00 (hollow-wide-00): carries to the place in 28 of 30 rehearsals, spread (1.6,
  ; 7.4) mm.
  ; With others close beside the object, 13 of 20 went so, and moved none.
  ; With another object on the place it stood there in 0 of 12; the place must be free.
  ; Action parameters: 0.0004 -0.0327 -0.0002 0.9875 0.0283 0.0245 -0.0164 0.0635 0.0496 0.0076 0.0388
  ; 0.2203
  ; With a third object under the object: never rehearsed, and allowed.
  ; With a third object on the object: never rehearsed, and forbidden.
  (:action carry-to-101a-hollow-wide-00
    :parameters (?o - hollow-wide-00 ?to - place ?from - origin)
    :precondition (and (can-carry-to-101a-hollow-wide-00 ?o) (taken ?o ?from) (free ?to) (may-stand ?o ?to) (not (exists (?x - movable) (rests-with ?x ?o))) (not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p)))))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-101a-hollow-wide-00 ?o ?from))))

  ; Primitive 101 on category 01 (solid-low-narrow-01): carries to the place in 30 of 30 rehearsals, spread
  ; (0.3, 0.9) mm.
  ; With others close beside the object, 17 of 20 went so, and moved none.
  ; With another object on the place it stood there in 0 of 15; the place must be free.
  ; Action parameters: -0.0022 -0.0118 -0.0005 0.8535 0.0001 0.0065 0.0120 0.0931 0.0163 0.0135 0.0084
  ; 0.1738
  ; With a third object under the object: never rehearsed, and allowed.
  ; With a third object on the object: never rehearsed, and forbidden.
  (:action carry-to-101b-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01 ?to - place ?from - origin)
    :precondition (and (can-carry-to-101b-solid-low-narrow-01 ?o) (taken ?o ?from) (free ?to) (may-stand ?o ?to) (not (exists (?x - movable) (rests-with ?x ?o))) (not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p)))))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-101b-solid-low-narrow-01 ?o ?from))))

  ; Primitive 110 on category 10 (solid-low-10): carries to the place in 1 of 31 rehearsals, spread (0, 0)
  ; mm.
  ; With others close beside the object, 0 of 20 went so, and moved none.
  ; With another object on the place it stood there in 0 of 13; the place must be free.
  ; Action parameters: -0.0021 0.0113 0.0029 0.6141 -0.0204 -0.0088 -0.0096 0.2882 0.0082 -0.0375 -0.0252
  ; 0.4343
  ; With a third object under the object: never rehearsed, and allowed.
  ; With a third object on the object: never rehearsed, and forbidden.
  (:action carry-to-110-solid-low-10
    :parameters (?o - solid-low-10 ?to - place ?from - origin)
    :precondition (and (can-carry-to-110-solid-low-10 ?o) (taken ?o ?from) (free ?to) (may-stand ?o ?to) (not (exists (?x - movable) (rests-with ?x ?o))) (not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p)))))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-110-solid-low-10 ?o ?from))))

  ; Primitive 110 on category 01 (solid-low-narrow-01): carries to the place in 30 of 30 rehearsals, spread
  ; (2.5, 0.9) mm.
  ; With others close beside the object, 10 of 20 went so, and moved none.
  ; With another object on the place it stood there in 0 of 15; the place must be free.
  ; Action parameters: -0.0021 0.0113 0.0029 0.6141 -0.0204 -0.0088 -0.0096 0.2882 0.0082 -0.0375 -0.0252
  ; 0.4343
  ; With a third object under the object: never rehearsed, and allowed.
  ; With a third object on the object: never rehearsed, and forbidden.
  (:action carry-to-110-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01 ?to - place ?from - origin)
    :precondition (and (can-carry-to-110-solid-low-narrow-01 ?o) (taken ?o ?from) (free ?to) (may-stand ?o ?to) (not (exists (?x - movable) (rests-with ?x ?o))) (not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p)))))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-110-solid-low-narrow-01 ?o ?from))))

  ; Primitive 110 on category 00 (hollow-wide-00): carries to the place in 28 of 30 rehearsals, spread (7.9,
  ; 8.3) mm.
  ; With others close beside the object, 13 of 20 went so, and moved none.
  ; With another object on the place it stood there in 0 of 12; the place must be free.
  ; Action parameters: -0.0135 0.0307 0.0065 0.5413 -0.0023 0.0495 -0.0102 0.1790 0.0093 -0.0116 0.0320
  ; 0.3067
  ; With a third object under the object: never rehearsed, and allowed.
  ; With a third object on the object: never rehearsed, and forbidden.
  (:action carry-to-110a-hollow-wide-00
    :parameters (?o - hollow-wide-00 ?to - place ?from - origin)
    :precondition (and (can-carry-to-110a-hollow-wide-00 ?o) (taken ?o ?from) (free ?to) (may-stand ?o ?to) (not (exists (?x - movable) (rests-with ?x ?o))) (not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p)))))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-110a-hollow-wide-00 ?o ?from))))

  ; Primitive 110 on category 11 (any-tall-narrow-11): carries to the place in 23 of 30 rehearsals, spread
  ; (0.6, 12.8) mm.
  ; With others close beside the object, 10 of 20 went so, and moved none.
  ; With another object on the place it stood there in 4 of 18; the place must be free.
  ; Action parameters: 0.0011 0.0355 -0.0017 0.8133 -0.0298 0.0400 -0.0034 0.4819 0.0411 -0.0227 0.0040
  ; 0.9931
  ; With a third object under the object: never rehearsed, and allowed.
  ; With a third object on the object: never rehearsed, and forbidden.
  (:action carry-to-110b-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11 ?to - place ?from - origin)
    :precondition (and (can-carry-to-110b-any-tall-narrow-11 ?o) (taken ?o ?from) (free ?to) (may-stand ?o ?to) (not (exists (?x - movable) (rests-with ?x ?o))) (not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p)))))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-110b-any-tall-narrow-11 ?o ?from))))

  ; Primitive 111 on category 01 (solid-low-narrow-01): carries to the place in 30 of 30 rehearsals, spread
  ; (0.2, 0.9) mm.
  ; With others close beside the object, 14 of 20 went so, and moved none.
  ; With another object on the place it stood there in 1 of 15; the place must be free.
  ; Action parameters: 0.0011 -0.0041 -0.0180 0.7216 0.0209 -0.0243 0.0021 0.2601 0.0100 0.0023 0.0238
  ; 0.8375
  ; With a third object under the object: never rehearsed, and allowed.
  ; With a third object on the object: never rehearsed, and forbidden.
  (:action carry-to-111-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01 ?to - place ?from - origin)
    :precondition (and (can-carry-to-111-solid-low-narrow-01 ?o) (taken ?o ?from) (free ?to) (may-stand ?o ?to) (not (exists (?x - movable) (rests-with ?x ?o))) (not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p)))))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-111-solid-low-narrow-01 ?o ?from))))

  ; Primitive 111 on category 00 (hollow-wide-00): carries to the place in 24 of 30 rehearsals, spread (2.8,
  ; 5.8) mm.
  ; With others close beside the object, 7 of 20 went so, and moved none.
  ; With another object on the place it stood there in 0 of 12; the place must be free.
  ; Action parameters: -0.0072 -0.0148 0.0111 0.5887 0.0224 0.0141 -0.0033 0.3245 -0.0147 -0.0255 -0.0293
  ; 0.4550
  ; With a third object under the object: never rehearsed, and allowed.
  ; With a third object on the object: never rehearsed, and forbidden.
  (:action carry-to-111a-hollow-wide-00
    :parameters (?o - hollow-wide-00 ?to - place ?from - origin)
    :precondition (and (can-carry-to-111a-hollow-wide-00 ?o) (taken ?o ?from) (free ?to) (may-stand ?o ?to) (not (exists (?x - movable) (rests-with ?x ?o))) (not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p)))))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-111a-hollow-wide-00 ?o ?from))))

  ; Primitive 111 on category 10 (solid-low-10): carries to the place in 11 of 31 rehearsals, spread (0.3,
  ; 0.3) mm.
  ; With others close beside the object, 5 of 20 went so, and moved none.
  ; With another object on the place it stood there in 0 of 13; the place must be free.
  ; Action parameters: -0.0066 -0.0007 -0.0150 0.5982 -0.0104 0.0296 -0.0184 0.1197 -0.0061 0.0108 0.0309
  ; 0.4985
  ; With a third object under the object: never rehearsed, and allowed.
  ; With a third object on the object: never rehearsed, and forbidden.
  (:action carry-to-111b-solid-low-10
    :parameters (?o - solid-low-10 ?to - place ?from - origin)
    :precondition (and (can-carry-to-111b-solid-low-10 ?o) (taken ?o ?from) (free ?to) (may-stand ?o ?to) (not (exists (?x - movable) (rests-with ?x ?o))) (not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p)))))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-111b-solid-low-10 ?o ?from))))

  ; Primitive 111 on category 11 (any-tall-narrow-11): carries to the place in 30 of 30 rehearsals, spread
  ; (1.3, 0.6) mm.
  ; With others close beside the object, 18 of 20 went so, and moved none.
  ; With another object on the place it stood there in 0 of 18; the place must be free.
  ; Action parameters: -0.0138 -0.0018 0.0081 0.7068 0.0043 0.0092 0.0032 0.0639 -0.0258 0.0223 0.0294
  ; 0.8890
  ; With a third object under the object: never rehearsed, and allowed.
  ; With a third object on the object: never rehearsed, and forbidden.
  (:action carry-to-111c-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11 ?to - place ?from - origin)
    :precondition (and (can-carry-to-111c-any-tall-narrow-11 ?o) (taken ?o ?from) (free ?to) (may-stand ?o ?to) (not (exists (?x - movable) (rests-with ?x ?o))) (not (exists (?x - movable ?p - place) (and (overlaps ?o ?to ?p) (stands ?x ?p)))))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-111c-any-tall-narrow-11 ?o ?from))))

  ; Note that an object stands where its goal is.
  (:action reach-place
    :parameters (?o - movable ?p - place)
    :precondition (and (stands ?o ?p) (goal-place ?o ?p))
    :effect (and (done ?o) (increase (total-cost) 0)))

  ; Left out:
  ; beside-100-by-010b-solid-tall-to-any-11010: ends in a state in which the reference bears nothing.
  ; beside-100-by-111c-solid-low-wide-to-any-01010: ends in a state in which the reference bears nothing.
  ; leans-on-101-by-000a-hollow-tall-to-hollow-tall-wide-00101: fewer than 5 rehearsals.
  ; leans-on-101-by-000e-hollow-low-to-hollow-tall-wide-01101: fewer than 5 rehearsals.
  ; leans-on-101-by-100k-hollow-low-to-hollow-tall-wide-01101: fewer than 5 rehearsals.
  ; leans-on-101-by-110h-hollow-low-wide-to-any-01011: does less surely what leans-on-101-by-010c-hollow-
  ; low-wide-to-any-01011 does.
  ; rests-on-011-by-000a-hollow-tall-to-hollow-tall-wide-00101: fewer than 5 rehearsals.
  ; rests-on-011-by-001d-hollow-narrow-to-any-tall-narrow-01000: fewer than 5 rehearsals.
  ; rests-on-011-by-100a-any-tall-narrow-to-hollow-narrow-10000: fewer than 5 rehearsals.
  ; sits-in-111-by-000a-hollow-tall-to-hollow-tall-wide-00101: fewer than 5 rehearsals.
  ; sits-in-111-by-001d-hollow-narrow-to-any-tall-narrow-01000: fewer than 5 rehearsals.
  ; sits-in-111-by-100d-hollow-tall-to-hollow-tall-wide-00101: fewer than 5 rehearsals.
  ; sits-in-111-by-111b-solid-narrow-to-hollow-low-wide-01110: does less surely what sits-
  ; in-111-by-100n-solid-narrow-to-hollow-low-wide-01110 does.
  ; sits-in-111-by-111c-solid-narrow-to-hollow-low-wide-01110: does less surely what sits-
  ; in-111-by-100n-solid-narrow-to-hollow-low-wide-01110 does.
)
