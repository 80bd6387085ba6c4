; Learned domain tabletop-paper, encoding numeric. Printed by neurosym; do not edit.
; Positions are whole numbers of 0.1 mm: x and y from the table's lowest corner, z from where an object
; rests.
; The table reaches to x = 6000, y = 6000; steps end 6 inside its edges, for what 10 steps with an object
; can err by rounding.
; By how much an operator moves an object stands in the problem, with 10000 added, for no number may be
; negative.
; After a lift the hand is full: only the put-down of that lift applies.
; Cost of a step: 1 + round(-100 ln((k + 1) / (n + 2))), k successes in n rehearsals.
; What a valid plan guarantees: the hand can begin each step; each object stays on the table and meets its
; goal, up to the rounding of positions.
; What is led over cells meets no condition for others: a valid plan may push it through an object, or leave
; it in one. `neurosym validate` replays a plan and finds objects that end in each other.

(define (domain tabletop-paper-numeric)
  (:requirements :strips :typing :numeric-fluents :action-costs)

  (:types
    movable - object
    any-low-narrow-11 hollow-00 hollow-tall-wide-01 solid-narrow-10 - movable)

  (:predicates
    (hand-empty)
    (held-by-lift-000-any-low-narrow-11 ?o - any-low-narrow-11)
    (held-by-lift-000-hollow-00 ?o - hollow-00)
    (held-by-lift-000-hollow-tall-wide-01 ?o - hollow-tall-wide-01)
    (held-by-lift-000a-hollow-00 ?o - hollow-00)
    (held-by-lift-000b-hollow-tall-wide-01 ?o - hollow-tall-wide-01)
    (held-by-lift-000d-any-low-narrow-11 ?o - any-low-narrow-11)
    (held-by-lift-011a-hollow-00 ?o - hollow-00)
    (held-by-lift-100-any-low-narrow-11 ?o - any-low-narrow-11)
    (held-by-lift-100-hollow-tall-wide-01 ?o - hollow-tall-wide-01)
    (held-by-lift-100a-hollow-00 ?o - hollow-00)
    (held-by-lift-100b-hollow-tall-wide-01 ?o - hollow-tall-wide-01)
    (held-by-lift-100c-solid-narrow-10 ?o - solid-narrow-10)
    (held-by-lift-100d-any-low-narrow-11 ?o - any-low-narrow-11)
    (held-by-lift-101-any-low-narrow-11 ?o - any-low-narrow-11)
    (held-by-lift-101-hollow-tall-wide-01 ?o - hollow-tall-wide-01)
    (held-by-lift-101-solid-narrow-10 ?o - solid-narrow-10)
    (held-by-lift-101a-hollow-00 ?o - hollow-00)
    (held-by-lift-101a-hollow-tall-wide-01 ?o - hollow-tall-wide-01)
    (held-by-lift-101b-any-low-narrow-11 ?o - any-low-narrow-11)
    (held-by-lift-110a-hollow-00 ?o - hollow-00)
    (can-lift-000-any-low-narrow-11 ?o - any-low-narrow-11)
    (can-lift-000-hollow-00 ?o - hollow-00)
    (can-lift-000-hollow-tall-wide-01 ?o - hollow-tall-wide-01)
    (can-lift-000a-hollow-00 ?o - hollow-00)
    (can-lift-000b-hollow-tall-wide-01 ?o - hollow-tall-wide-01)
    (can-lift-000d-any-low-narrow-11 ?o - any-low-narrow-11)
    (can-lift-011a-hollow-00 ?o - hollow-00)
    (can-lift-100-any-low-narrow-11 ?o - any-low-narrow-11)
    (can-lift-100-hollow-tall-wide-01 ?o - hollow-tall-wide-01)
    (can-lift-100a-hollow-00 ?o - hollow-00)
    (can-lift-100b-hollow-tall-wide-01 ?o - hollow-tall-wide-01)
    (can-lift-100c-solid-narrow-10 ?o - solid-narrow-10)
    (can-lift-100d-any-low-narrow-11 ?o - any-low-narrow-11)
    (can-lift-101-any-low-narrow-11 ?o - any-low-narrow-11)
    (can-lift-101-hollow-tall-wide-01 ?o - hollow-tall-wide-01)
    (can-lift-101-solid-narrow-10 ?o - solid-narrow-10)
    (can-lift-101a-hollow-00 ?o - hollow-00)
    (can-lift-101a-hollow-tall-wide-01 ?o - hollow-tall-wide-01)
    (can-lift-101b-any-low-narrow-11 ?o - any-low-narrow-11)
    (can-lift-110a-hollow-00 ?o - hollow-00)
    (can-pull-110-solid-narrow-10 ?o - solid-narrow-10)
    (can-pull-110a-hollow-00 ?o - hollow-00)
    (can-pull-left-010b-hollow-tall-wide-01 ?o - hollow-tall-wide-01)
    (can-pull-left-010c-solid-narrow-10 ?o - solid-narrow-10)
    (can-pull-right-100c-solid-narrow-10 ?o - solid-narrow-10)
    (can-pull-right-110c-any-low-narrow-11 ?o - any-low-narrow-11)
    (can-pull-right-111a-hollow-00 ?o - hollow-00)
    (can-push-forward-001-any-low-narrow-11 ?o - any-low-narrow-11)
    (can-push-forward-001-solid-narrow-10 ?o - solid-narrow-10)
    (can-push-forward-001c-any-low-narrow-11 ?o - any-low-narrow-11)
    (can-push-forward-left-000c-solid-narrow-10 ?o - solid-narrow-10)
    (can-push-forward-left-011-any-low-narrow-11 ?o - any-low-narrow-11)
    (can-push-forward-left-011a-hollow-00 ?o - hollow-00)
    (can-push-forward-right-001a-hollow-00 ?o - hollow-00)
    (can-push-forward-right-011d-any-low-narrow-11 ?o - any-low-narrow-11)
    (can-push-forward-right-101-solid-narrow-10 ?o - solid-narrow-10)
    (can-push-forward-right-111-solid-narrow-10 ?o - solid-narrow-10)
    (can-push-forward-right-111b-hollow-tall-wide-01 ?o - hollow-tall-wide-01)
    (can-push-left-000-hollow-00 ?o - hollow-00)
    (can-push-left-010a-hollow-00 ?o - hollow-00)
    (can-push-left-010d-any-low-narrow-11 ?o - any-low-narrow-11)
    (can-push-left-011-hollow-00 ?o - hollow-00)
    (can-push-left-011b-hollow-tall-wide-01 ?o - hollow-tall-wide-01)
    (can-push-left-011c-solid-narrow-10 ?o - solid-narrow-10)
    (can-push-right-001b-hollow-tall-wide-01 ?o - hollow-tall-wide-01)
    (can-push-right-100-hollow-tall-wide-01 ?o - hollow-tall-wide-01)
    (can-push-right-101-hollow-tall-wide-01 ?o - hollow-tall-wide-01)
    (can-push-right-110b-hollow-tall-wide-01 ?o - hollow-tall-wide-01)
    (can-push-right-111-hollow-00 ?o - hollow-00)
    (can-push-right-111c-any-low-narrow-11 ?o - any-low-narrow-11))

  (:functions
    (x ?o - movable) - number
    (y ?o - movable) - number
    (z ?o - movable) - number
    (total-cost) - number
    (x-of-lift-000-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (y-of-lift-000-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (z-of-lift-000-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (cost-of-lift-000-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (x-of-put-down-lift-000-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (y-of-put-down-lift-000-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (z-of-put-down-lift-000-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (x-of-lift-000-hollow-00 ?o - hollow-00) - number
    (y-of-lift-000-hollow-00 ?o - hollow-00) - number
    (z-of-lift-000-hollow-00 ?o - hollow-00) - number
    (cost-of-lift-000-hollow-00 ?o - hollow-00) - number
    (x-of-put-down-lift-000-hollow-00 ?o - hollow-00) - number
    (y-of-put-down-lift-000-hollow-00 ?o - hollow-00) - number
    (z-of-put-down-lift-000-hollow-00 ?o - hollow-00) - number
    (x-of-lift-000-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (y-of-lift-000-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (z-of-lift-000-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (cost-of-lift-000-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (x-of-put-down-lift-000-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (y-of-put-down-lift-000-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (z-of-put-down-lift-000-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (x-of-lift-000a-hollow-00 ?o - hollow-00) - number
    (y-of-lift-000a-hollow-00 ?o - hollow-00) - number
    (z-of-lift-000a-hollow-00 ?o - hollow-00) - number
    (cost-of-lift-000a-hollow-00 ?o - hollow-00) - number
    (x-of-put-down-lift-000a-hollow-00 ?o - hollow-00) - number
    (y-of-put-down-lift-000a-hollow-00 ?o - hollow-00) - number
    (z-of-put-down-lift-000a-hollow-00 ?o - hollow-00) - number
    (x-of-lift-000b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (y-of-lift-000b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (z-of-lift-000b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (cost-of-lift-000b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (x-of-put-down-lift-000b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (y-of-put-down-lift-000b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (z-of-put-down-lift-000b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (x-of-lift-000d-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (y-of-lift-000d-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (z-of-lift-000d-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (cost-of-lift-000d-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (x-of-put-down-lift-000d-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (y-of-put-down-lift-000d-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (z-of-put-down-lift-000d-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (x-of-lift-011a-hollow-00 ?o - hollow-00) - number
    (y-of-lift-011a-hollow-00 ?o - hollow-00) - number
    (z-of-lift-011a-hollow-00 ?o - hollow-00) - number
    (cost-of-lift-011a-hollow-00 ?o - hollow-00) - number
    (x-of-put-down-lift-011a-hollow-00 ?o - hollow-00) - number
    (y-of-put-down-lift-011a-hollow-00 ?o - hollow-00) - number
    (z-of-put-down-lift-011a-hollow-00 ?o - hollow-00) - number
    (x-of-lift-100-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (y-of-lift-100-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (z-of-lift-100-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (cost-of-lift-100-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (x-of-put-down-lift-100-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (y-of-put-down-lift-100-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (z-of-put-down-lift-100-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (x-of-lift-100-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (y-of-lift-100-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (z-of-lift-100-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (cost-of-lift-100-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (x-of-put-down-lift-100-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (y-of-put-down-lift-100-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (z-of-put-down-lift-100-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (x-of-lift-100a-hollow-00 ?o - hollow-00) - number
    (y-of-lift-100a-hollow-00 ?o - hollow-00) - number
    (z-of-lift-100a-hollow-00 ?o - hollow-00) - number
    (cost-of-lift-100a-hollow-00 ?o - hollow-00) - number
    (x-of-put-down-lift-100a-hollow-00 ?o - hollow-00) - number
    (y-of-put-down-lift-100a-hollow-00 ?o - hollow-00) - number
    (z-of-put-down-lift-100a-hollow-00 ?o - hollow-00) - number
    (x-of-lift-100b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (y-of-lift-100b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (z-of-lift-100b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (cost-of-lift-100b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (x-of-put-down-lift-100b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (y-of-put-down-lift-100b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (z-of-put-down-lift-100b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (x-of-lift-100c-solid-narrow-10 ?o - solid-narrow-10) - number
    (y-of-lift-100c-solid-narrow-10 ?o - solid-narrow-10) - number
    (z-of-lift-100c-solid-narrow-10 ?o - solid-narrow-10) - number
    (cost-of-lift-100c-solid-narrow-10 ?o - solid-narrow-10) - number
    (x-of-put-down-lift-100c-solid-narrow-10 ?o - solid-narrow-10) - number
    (y-of-put-down-lift-100c-solid-narrow-10 ?o - solid-narrow-10) - number
    (z-of-put-down-lift-100c-solid-narrow-10 ?o - solid-narrow-10) - number
    (x-of-lift-100d-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (y-of-lift-100d-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (z-of-lift-100d-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (cost-of-lift-100d-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (x-of-put-down-lift-100d-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (y-of-put-down-lift-100d-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (z-of-put-down-lift-100d-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (x-of-lift-101-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (y-of-lift-101-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (z-of-lift-101-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (cost-of-lift-101-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (x-of-put-down-lift-101-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (y-of-put-down-lift-101-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (z-of-put-down-lift-101-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (x-of-lift-101-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (y-of-lift-101-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (z-of-lift-101-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (cost-of-lift-101-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (x-of-put-down-lift-101-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (y-of-put-down-lift-101-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (z-of-put-down-lift-101-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (x-of-lift-101-solid-narrow-10 ?o - solid-narrow-10) - number
    (y-of-lift-101-solid-narrow-10 ?o - solid-narrow-10) - number
    (z-of-lift-101-solid-narrow-10 ?o - solid-narrow-10) - number
    (cost-of-lift-101-solid-narrow-10 ?o - solid-narrow-10) - number
    (x-of-put-down-lift-101-solid-narrow-10 ?o - solid-narrow-10) - number
    (y-of-put-down-lift-101-solid-narrow-10 ?o - solid-narrow-10) - number
    (z-of-put-down-lift-101-solid-narrow-10 ?o - solid-narrow-10) - number
    (x-of-lift-101a-hollow-00 ?o - hollow-00) - number
    (y-of-lift-101a-hollow-00 ?o - hollow-00) - number
    (z-of-lift-101a-hollow-00 ?o - hollow-00) - number
    (cost-of-lift-101a-hollow-00 ?o - hollow-00) - number
    (x-of-put-down-lift-101a-hollow-00 ?o - hollow-00) - number
    (y-of-put-down-lift-101a-hollow-00 ?o - hollow-00) - number
    (z-of-put-down-lift-101a-hollow-00 ?o - hollow-00) - number
    (x-of-lift-101a-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (y-of-lift-101a-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (z-of-lift-101a-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (cost-of-lift-101a-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (x-of-put-down-lift-101a-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (y-of-put-down-lift-101a-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (z-of-put-down-lift-101a-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (x-of-lift-101b-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (y-of-lift-101b-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (z-of-lift-101b-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (cost-of-lift-101b-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (x-of-put-down-lift-101b-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (y-of-put-down-lift-101b-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (z-of-put-down-lift-101b-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (x-of-lift-110a-hollow-00 ?o - hollow-00) - number
    (y-of-lift-110a-hollow-00 ?o - hollow-00) - number
    (z-of-lift-110a-hollow-00 ?o - hollow-00) - number
    (cost-of-lift-110a-hollow-00 ?o - hollow-00) - number
    (x-of-put-down-lift-110a-hollow-00 ?o - hollow-00) - number
    (y-of-put-down-lift-110a-hollow-00 ?o - hollow-00) - number
    (z-of-put-down-lift-110a-hollow-00 ?o - hollow-00) - number
    (x-of-pull-110-solid-narrow-10 ?o - solid-narrow-10) - number
    (y-of-pull-110-solid-narrow-10 ?o - solid-narrow-10) - number
    (cost-of-pull-110-solid-narrow-10 ?o - solid-narrow-10) - number
    (x-of-pull-110a-hollow-00 ?o - hollow-00) - number
    (y-of-pull-110a-hollow-00 ?o - hollow-00) - number
    (cost-of-pull-110a-hollow-00 ?o - hollow-00) - number
    (x-of-pull-left-010b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (y-of-pull-left-010b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (cost-of-pull-left-010b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (x-of-pull-left-010c-solid-narrow-10 ?o - solid-narrow-10) - number
    (y-of-pull-left-010c-solid-narrow-10 ?o - solid-narrow-10) - number
    (cost-of-pull-left-010c-solid-narrow-10 ?o - solid-narrow-10) - number
    (x-of-pull-right-100c-solid-narrow-10 ?o - solid-narrow-10) - number
    (y-of-pull-right-100c-solid-narrow-10 ?o - solid-narrow-10) - number
    (cost-of-pull-right-100c-solid-narrow-10 ?o - solid-narrow-10) - number
    (x-of-pull-right-110c-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (y-of-pull-right-110c-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (cost-of-pull-right-110c-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (x-of-pull-right-111a-hollow-00 ?o - hollow-00) - number
    (y-of-pull-right-111a-hollow-00 ?o - hollow-00) - number
    (cost-of-pull-right-111a-hollow-00 ?o - hollow-00) - number
    (x-of-push-forward-001-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (y-of-push-forward-001-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (cost-of-push-forward-001-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (x-of-push-forward-001-solid-narrow-10 ?o - solid-narrow-10) - number
    (y-of-push-forward-001-solid-narrow-10 ?o - solid-narrow-10) - number
    (cost-of-push-forward-001-solid-narrow-10 ?o - solid-narrow-10) - number
    (x-of-push-forward-001c-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (y-of-push-forward-001c-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (cost-of-push-forward-001c-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (x-of-push-forward-left-000c-solid-narrow-10 ?o - solid-narrow-10) - number
    (y-of-push-forward-left-000c-solid-narrow-10 ?o - solid-narrow-10) - number
    (cost-of-push-forward-left-000c-solid-narrow-10 ?o - solid-narrow-10) - number
    (x-of-push-forward-left-011-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (y-of-push-forward-left-011-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (cost-of-push-forward-left-011-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (x-of-push-forward-left-011a-hollow-00 ?o - hollow-00) - number
    (y-of-push-forward-left-011a-hollow-00 ?o - hollow-00) - number
    (cost-of-push-forward-left-011a-hollow-00 ?o - hollow-00) - number
    (x-of-push-forward-right-001a-hollow-00 ?o - hollow-00) - number
    (y-of-push-forward-right-001a-hollow-00 ?o - hollow-00) - number
    (cost-of-push-forward-right-001a-hollow-00 ?o - hollow-00) - number
    (x-of-push-forward-right-011d-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (y-of-push-forward-right-011d-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (cost-of-push-forward-right-011d-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (x-of-push-forward-right-101-solid-narrow-10 ?o - solid-narrow-10) - number
    (y-of-push-forward-right-101-solid-narrow-10 ?o - solid-narrow-10) - number
    (cost-of-push-forward-right-101-solid-narrow-10 ?o - solid-narrow-10) - number
    (x-of-push-forward-right-111-solid-narrow-10 ?o - solid-narrow-10) - number
    (y-of-push-forward-right-111-solid-narrow-10 ?o - solid-narrow-10) - number
    (cost-of-push-forward-right-111-solid-narrow-10 ?o - solid-narrow-10) - number
    (x-of-push-forward-right-111b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (y-of-push-forward-right-111b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (cost-of-push-forward-right-111b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (x-of-push-left-000-hollow-00 ?o - hollow-00) - number
    (y-of-push-left-000-hollow-00 ?o - hollow-00) - number
    (cost-of-push-left-000-hollow-00 ?o - hollow-00) - number
    (x-of-push-left-010a-hollow-00 ?o - hollow-00) - number
    (y-of-push-left-010a-hollow-00 ?o - hollow-00) - number
    (cost-of-push-left-010a-hollow-00 ?o - hollow-00) - number
    (x-of-push-left-010d-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (y-of-push-left-010d-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (cost-of-push-left-010d-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (x-of-push-left-011-hollow-00 ?o - hollow-00) - number
    (y-of-push-left-011-hollow-00 ?o - hollow-00) - number
    (cost-of-push-left-011-hollow-00 ?o - hollow-00) - number
    (x-of-push-left-011b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (y-of-push-left-011b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (cost-of-push-left-011b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (x-of-push-left-011c-solid-narrow-10 ?o - solid-narrow-10) - number
    (y-of-push-left-011c-solid-narrow-10 ?o - solid-narrow-10) - number
    (cost-of-push-left-011c-solid-narrow-10 ?o - solid-narrow-10) - number
    (x-of-push-right-001b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (y-of-push-right-001b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (cost-of-push-right-001b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (x-of-push-right-100-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (y-of-push-right-100-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (cost-of-push-right-100-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (x-of-push-right-101-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (y-of-push-right-101-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (cost-of-push-right-101-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (x-of-push-right-110b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (y-of-push-right-110b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (cost-of-push-right-110b-hollow-tall-wide-01 ?o - hollow-tall-wide-01) - number
    (x-of-push-right-111-hollow-00 ?o - hollow-00) - number
    (y-of-push-right-111-hollow-00 ?o - hollow-00) - number
    (cost-of-push-right-111-hollow-00 ?o - hollow-00) - number
    (x-of-push-right-111c-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (y-of-push-right-111c-any-low-narrow-11 ?o - any-low-narrow-11) - number
    (cost-of-push-right-111c-any-low-narrow-11 ?o - any-low-narrow-11) - number)

  ; Primitive 000 on category 11 (any-low-narrow-11); ends held in 29 of 30 rehearsals (97%).
  ; Effect (21.5, 26.9, 216.5) mm, spread (2.1, 1.5, 5.7) mm; 29 of 30 rehearsals as promised: cost 7.
  ; Action parameters: -0.0052 -0.0279 -0.0232 0.7913 -0.0181 0.0467 -0.0143 0.8116 0.0024 0.0325 0.0113
  ; 0.4626
  ; It turned the object by over 15 degrees in 2 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-000-any-low-narrow-11
    :parameters (?o - any-low-narrow-11)
    :precondition (and (hand-empty) (can-lift-000-any-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-000-any-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-000-any-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-000-any-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-000-any-low-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-000-any-low-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-000-any-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-000-any-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-000-any-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-000-any-low-narrow-11 ?o))))

  ; Put down what lift-000-any-low-narrow-11 lifted.
  (:action put-down-lift-000-any-low-narrow-11
    :parameters (?o - any-low-narrow-11)
    :precondition (and (held-by-lift-000-any-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-000-any-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-000-any-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-000-any-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-000-any-low-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-000-any-low-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-000-any-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-000-any-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-000-any-low-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 000 on category 00 (hollow-00); ends held in 24 of 30 rehearsals (80%).
  ; Effect (3.3, 75.8, 223) mm, spread (4, 24.7, 15) mm; 23 of 30 rehearsals as promised: cost 30.
  ; Action parameters: -0.0052 -0.0279 -0.0232 0.7913 -0.0181 0.0467 -0.0143 0.8116 0.0024 0.0325 0.0113
  ; 0.4626
  ; It turned the object by over 15 degrees in 7 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-000-hollow-00
    :parameters (?o - hollow-00)
    :precondition (and (hand-empty) (can-lift-000-hollow-00 ?o) (>= (+ (x ?o) (x-of-lift-000-hollow-00 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-000-hollow-00 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-000-hollow-00 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-000-hollow-00 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-000-hollow-00 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-000-hollow-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-000-hollow-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-000-hollow-00 ?o)) 10000)) (increase (total-cost) (cost-of-lift-000-hollow-00 ?o))))

  ; Put down what lift-000-hollow-00 lifted.
  (:action put-down-lift-000-hollow-00
    :parameters (?o - hollow-00)
    :precondition (and (held-by-lift-000-hollow-00 ?o) (>= (+ (x ?o) (x-of-put-down-lift-000-hollow-00 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-000-hollow-00 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-000-hollow-00 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-000-hollow-00 ?o)) 15994))
    :effect (and (not (held-by-lift-000-hollow-00 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-000-hollow-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-000-hollow-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-000-hollow-00 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 000 on category 01 (hollow-tall-wide-01); ends held in 30 of 30 rehearsals (100%).
  ; Effect (2.6, 104.9, 221.3) mm, spread (7, 6.6, 5.1) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0052 -0.0279 -0.0232 0.7913 -0.0181 0.0467 -0.0143 0.8116 0.0024 0.0325 0.0113
  ; 0.4626
  ; What it promises for an object stands in the problem.
  (:action lift-000-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01)
    :precondition (and (hand-empty) (can-lift-000-hollow-tall-wide-01 ?o) (>= (+ (x ?o) (x-of-lift-000-hollow-tall-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-000-hollow-tall-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-000-hollow-tall-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-000-hollow-tall-wide-01 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-000-hollow-tall-wide-01 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-000-hollow-tall-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-000-hollow-tall-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-000-hollow-tall-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-lift-000-hollow-tall-wide-01 ?o))))

  ; Put down what lift-000-hollow-tall-wide-01 lifted.
  (:action put-down-lift-000-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01)
    :precondition (and (held-by-lift-000-hollow-tall-wide-01 ?o) (>= (+ (x ?o) (x-of-put-down-lift-000-hollow-tall-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-000-hollow-tall-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-000-hollow-tall-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-000-hollow-tall-wide-01 ?o)) 15994))
    :effect (and (not (held-by-lift-000-hollow-tall-wide-01 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-000-hollow-tall-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-000-hollow-tall-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-000-hollow-tall-wide-01 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 000 on category 00 (hollow-00); ends held in 30 of 30 rehearsals (100%).
  ; Effect (48.6, 74.9, 252.7) mm, spread (0.7, 7.5, 7.9) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0005 -0.0418 -0.0138 0.7563 0.0286 -0.0129 -0.0188 0.4138 0.0492 0.0209 0.0459
  ; 0.1070
  ; What it promises for an object stands in the problem.
  (:action lift-000a-hollow-00
    :parameters (?o - hollow-00)
    :precondition (and (hand-empty) (can-lift-000a-hollow-00 ?o) (>= (+ (x ?o) (x-of-lift-000a-hollow-00 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-000a-hollow-00 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-000a-hollow-00 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-000a-hollow-00 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-000a-hollow-00 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-000a-hollow-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-000a-hollow-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-000a-hollow-00 ?o)) 10000)) (increase (total-cost) (cost-of-lift-000a-hollow-00 ?o))))

  ; Put down what lift-000a-hollow-00 lifted.
  (:action put-down-lift-000a-hollow-00
    :parameters (?o - hollow-00)
    :precondition (and (held-by-lift-000a-hollow-00 ?o) (>= (+ (x ?o) (x-of-put-down-lift-000a-hollow-00 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-000a-hollow-00 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-000a-hollow-00 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-000a-hollow-00 ?o)) 15994))
    :effect (and (not (held-by-lift-000a-hollow-00 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-000a-hollow-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-000a-hollow-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-000a-hollow-00 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 000 on category 01 (hollow-tall-wide-01); ends held in 30 of 30 rehearsals (100%).
  ; Effect (9.1, 47.7, 250.7) mm, spread (5.8, 6.5, 7.2) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0063 -0.0410 -0.0222 0.8257 -0.0241 -0.0037 0.0016 0.0316 0.0101 -0.0249 0.0384
  ; 0.2424
  ; What it promises for an object stands in the problem.
  (:action lift-000b-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01)
    :precondition (and (hand-empty) (can-lift-000b-hollow-tall-wide-01 ?o) (>= (+ (x ?o) (x-of-lift-000b-hollow-tall-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-000b-hollow-tall-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-000b-hollow-tall-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-000b-hollow-tall-wide-01 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-000b-hollow-tall-wide-01 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-000b-hollow-tall-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-000b-hollow-tall-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-000b-hollow-tall-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-lift-000b-hollow-tall-wide-01 ?o))))

  ; Put down what lift-000b-hollow-tall-wide-01 lifted.
  (:action put-down-lift-000b-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01)
    :precondition (and (held-by-lift-000b-hollow-tall-wide-01 ?o) (>= (+ (x ?o) (x-of-put-down-lift-000b-hollow-tall-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-000b-hollow-tall-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-000b-hollow-tall-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-000b-hollow-tall-wide-01 ?o)) 15994))
    :effect (and (not (held-by-lift-000b-hollow-tall-wide-01 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-000b-hollow-tall-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-000b-hollow-tall-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-000b-hollow-tall-wide-01 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 000 on category 11 (any-low-narrow-11); ends held in 30 of 30 rehearsals (100%).
  ; Effect (47.5, 9.9, 200.1) mm, spread (3.4, 0.8, 0.6) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0009 -0.0098 0.0019 0.6175 -0.0342 0.0114 -0.0133 0.4961 0.0430 0.0128 -0.0187
  ; 0.3613
  ; What it promises for an object stands in the problem.
  (:action lift-000d-any-low-narrow-11
    :parameters (?o - any-low-narrow-11)
    :precondition (and (hand-empty) (can-lift-000d-any-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-000d-any-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-000d-any-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-000d-any-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-000d-any-low-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-000d-any-low-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-000d-any-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-000d-any-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-000d-any-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-000d-any-low-narrow-11 ?o))))

  ; Put down what lift-000d-any-low-narrow-11 lifted.
  (:action put-down-lift-000d-any-low-narrow-11
    :parameters (?o - any-low-narrow-11)
    :precondition (and (held-by-lift-000d-any-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-000d-any-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-000d-any-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-000d-any-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-000d-any-low-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-000d-any-low-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-000d-any-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-000d-any-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-000d-any-low-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 011 on category 00 (hollow-00); ends held in 10 of 30 rehearsals (33%).
  ; Effect (42.5, 28.6, 200.2) mm, spread (2.6, 0.3, 0.5) mm; 10 of 30 rehearsals as promised: cost 108.
  ; Action parameters: -0.0263 0.0025 -0.0229 0.3620 -0.0059 -0.0443 0.0065 0.4889 0.0486 0.0275 -0.0417
  ; 0.9867
  ; It turned the object by over 15 degrees in 1 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-011a-hollow-00
    :parameters (?o - hollow-00)
    :precondition (and (hand-empty) (can-lift-011a-hollow-00 ?o) (>= (+ (x ?o) (x-of-lift-011a-hollow-00 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-011a-hollow-00 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-011a-hollow-00 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-011a-hollow-00 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-011a-hollow-00 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-011a-hollow-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-011a-hollow-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-011a-hollow-00 ?o)) 10000)) (increase (total-cost) (cost-of-lift-011a-hollow-00 ?o))))

  ; Put down what lift-011a-hollow-00 lifted.
  (:action put-down-lift-011a-hollow-00
    :parameters (?o - hollow-00)
    :precondition (and (held-by-lift-011a-hollow-00 ?o) (>= (+ (x ?o) (x-of-put-down-lift-011a-hollow-00 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-011a-hollow-00 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-011a-hollow-00 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-011a-hollow-00 ?o)) 15994))
    :effect (and (not (held-by-lift-011a-hollow-00 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-011a-hollow-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-011a-hollow-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-011a-hollow-00 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 100 on category 11 (any-low-narrow-11); ends held in 29 of 30 rehearsals (97%).
  ; Effect (-67, -25, 201.4) mm, spread (1.2, 1.1, 2.9) mm; 29 of 30 rehearsals as promised: cost 7.
  ; Action parameters: 0.0384 0.0210 0.0226 0.8485 0.0177 -0.0303 -0.0186 0.9698 -0.0492 -0.0223 -0.0102
  ; 0.2028
  ; It turned the object by over 15 degrees in 1 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-100-any-low-narrow-11
    :parameters (?o - any-low-narrow-11)
    :precondition (and (hand-empty) (can-lift-100-any-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-100-any-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-100-any-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-100-any-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-100-any-low-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-100-any-low-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-100-any-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-100-any-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-100-any-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-100-any-low-narrow-11 ?o))))

  ; Put down what lift-100-any-low-narrow-11 lifted.
  (:action put-down-lift-100-any-low-narrow-11
    :parameters (?o - any-low-narrow-11)
    :precondition (and (held-by-lift-100-any-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-100-any-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-100-any-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-100-any-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-100-any-low-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-100-any-low-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-100-any-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-100-any-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-100-any-low-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 100 on category 01 (hollow-tall-wide-01); ends held in 15 of 30 rehearsals (50%).
  ; Effect (-52.7, -101.1, 203.6) mm, spread (20.5, 9.2, 3.8) mm; 14 of 30 rehearsals as promised: cost 77.
  ; Action parameters: 0.0384 0.0210 0.0226 0.8485 0.0177 -0.0303 -0.0186 0.9698 -0.0492 -0.0223 -0.0102
  ; 0.2028
  ; It turned the object by over 15 degrees in 5 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-100-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01)
    :precondition (and (hand-empty) (can-lift-100-hollow-tall-wide-01 ?o) (>= (+ (x ?o) (x-of-lift-100-hollow-tall-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-100-hollow-tall-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-100-hollow-tall-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-100-hollow-tall-wide-01 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-100-hollow-tall-wide-01 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-100-hollow-tall-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-100-hollow-tall-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-100-hollow-tall-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-lift-100-hollow-tall-wide-01 ?o))))

  ; Put down what lift-100-hollow-tall-wide-01 lifted.
  (:action put-down-lift-100-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01)
    :precondition (and (held-by-lift-100-hollow-tall-wide-01 ?o) (>= (+ (x ?o) (x-of-put-down-lift-100-hollow-tall-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-100-hollow-tall-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-100-hollow-tall-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-100-hollow-tall-wide-01 ?o)) 15994))
    :effect (and (not (held-by-lift-100-hollow-tall-wide-01 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-100-hollow-tall-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-100-hollow-tall-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-100-hollow-tall-wide-01 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 100 on category 00 (hollow-00); ends held in 30 of 30 rehearsals (100%).
  ; Effect (-43.5, 61.5, 198.2) mm, spread (3.6, 7.8, 2.4) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0082 -0.0497 -0.0016 0.7537 -0.0044 0.0306 -0.0065 0.7767 -0.0451 0.0065 -0.0117
  ; 0.4167
  ; It turned the object by over 15 degrees in 8 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-100a-hollow-00
    :parameters (?o - hollow-00)
    :precondition (and (hand-empty) (can-lift-100a-hollow-00 ?o) (>= (+ (x ?o) (x-of-lift-100a-hollow-00 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-100a-hollow-00 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-100a-hollow-00 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-100a-hollow-00 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-100a-hollow-00 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-100a-hollow-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-100a-hollow-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-100a-hollow-00 ?o)) 10000)) (increase (total-cost) (cost-of-lift-100a-hollow-00 ?o))))

  ; Put down what lift-100a-hollow-00 lifted.
  (:action put-down-lift-100a-hollow-00
    :parameters (?o - hollow-00)
    :precondition (and (held-by-lift-100a-hollow-00 ?o) (>= (+ (x ?o) (x-of-put-down-lift-100a-hollow-00 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-100a-hollow-00 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-100a-hollow-00 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-100a-hollow-00 ?o)) 15994))
    :effect (and (not (held-by-lift-100a-hollow-00 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-100a-hollow-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-100a-hollow-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-100a-hollow-00 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 100 on category 01 (hollow-tall-wide-01); ends held in 30 of 30 rehearsals (100%).
  ; Effect (-45.5, 79.4, 198) mm, spread (6.5, 6.5, 0.9) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0075 -0.0488 -0.0015 0.7557 -0.0034 0.0305 -0.0066 0.7764 -0.0468 0.0061 -0.0116
  ; 0.4126
  ; It turned the object by over 15 degrees in 1 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-100b-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01)
    :precondition (and (hand-empty) (can-lift-100b-hollow-tall-wide-01 ?o) (>= (+ (x ?o) (x-of-lift-100b-hollow-tall-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-100b-hollow-tall-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-100b-hollow-tall-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-100b-hollow-tall-wide-01 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-100b-hollow-tall-wide-01 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-100b-hollow-tall-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-100b-hollow-tall-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-100b-hollow-tall-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-lift-100b-hollow-tall-wide-01 ?o))))

  ; Put down what lift-100b-hollow-tall-wide-01 lifted.
  (:action put-down-lift-100b-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01)
    :precondition (and (held-by-lift-100b-hollow-tall-wide-01 ?o) (>= (+ (x ?o) (x-of-put-down-lift-100b-hollow-tall-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-100b-hollow-tall-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-100b-hollow-tall-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-100b-hollow-tall-wide-01 ?o)) 15994))
    :effect (and (not (held-by-lift-100b-hollow-tall-wide-01 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-100b-hollow-tall-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-100b-hollow-tall-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-100b-hollow-tall-wide-01 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 100 on category 10 (solid-narrow-10); ends held in 5 of 37 rehearsals (14%).
  ; Effect (-60.7, -26.5, 223.2) mm, spread (2.5, 2.5, 6) mm; 5 of 37 rehearsals as promised: cost 188.
  ; Action parameters: 0.0325 0.0452 0.0169 0.5670 0.0130 -0.0171 0.0093 0.9358 -0.0416 -0.0239 0.0296
  ; 0.4702
  ; It turned the object by over 15 degrees in 1 of 37 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-100c-solid-narrow-10
    :parameters (?o - solid-narrow-10)
    :precondition (and (hand-empty) (can-lift-100c-solid-narrow-10 ?o) (>= (+ (x ?o) (x-of-lift-100c-solid-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-100c-solid-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-100c-solid-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-100c-solid-narrow-10 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-100c-solid-narrow-10 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-100c-solid-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-100c-solid-narrow-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-100c-solid-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-lift-100c-solid-narrow-10 ?o))))

  ; Put down what lift-100c-solid-narrow-10 lifted.
  (:action put-down-lift-100c-solid-narrow-10
    :parameters (?o - solid-narrow-10)
    :precondition (and (held-by-lift-100c-solid-narrow-10 ?o) (>= (+ (x ?o) (x-of-put-down-lift-100c-solid-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-100c-solid-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-100c-solid-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-100c-solid-narrow-10 ?o)) 15994))
    :effect (and (not (held-by-lift-100c-solid-narrow-10 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-100c-solid-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-100c-solid-narrow-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-100c-solid-narrow-10 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 100 on category 11 (any-low-narrow-11); ends held in 30 of 30 rehearsals (100%).
  ; Effect (-23.4, 38.5, 199.7) mm, spread (0.6, 0.5, 0.3) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0092 0.0048 -0.0218 0.7072 -0.0103 0.0236 -0.0133 0.0888 -0.0144 0.0410 -0.0311
  ; 0.4308
  ; What it promises for an object stands in the problem.
  (:action lift-100d-any-low-narrow-11
    :parameters (?o - any-low-narrow-11)
    :precondition (and (hand-empty) (can-lift-100d-any-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-100d-any-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-100d-any-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-100d-any-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-100d-any-low-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-100d-any-low-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-100d-any-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-100d-any-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-100d-any-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-100d-any-low-narrow-11 ?o))))

  ; Put down what lift-100d-any-low-narrow-11 lifted.
  (:action put-down-lift-100d-any-low-narrow-11
    :parameters (?o - any-low-narrow-11)
    :precondition (and (held-by-lift-100d-any-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-100d-any-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-100d-any-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-100d-any-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-100d-any-low-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-100d-any-low-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-100d-any-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-100d-any-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-100d-any-low-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 101 on category 11 (any-low-narrow-11); ends held in 30 of 30 rehearsals (100%).
  ; Effect (-16.7, -52.5, 237.8) mm, spread (0.8, 0.9, 6.5) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0114 0.0179 -0.0178 0.8519 0.0490 -0.0142 0.0217 0.2391 -0.0278 -0.0494 0.0317
  ; 0.4785
  ; What it promises for an object stands in the problem.
  (:action lift-101-any-low-narrow-11
    :parameters (?o - any-low-narrow-11)
    :precondition (and (hand-empty) (can-lift-101-any-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-101-any-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-101-any-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-101-any-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-101-any-low-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-101-any-low-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-101-any-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-101-any-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-101-any-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-101-any-low-narrow-11 ?o))))

  ; Put down what lift-101-any-low-narrow-11 lifted.
  (:action put-down-lift-101-any-low-narrow-11
    :parameters (?o - any-low-narrow-11)
    :precondition (and (held-by-lift-101-any-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-101-any-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-101-any-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-101-any-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-101-any-low-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-101-any-low-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-101-any-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-101-any-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-101-any-low-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 101 on category 01 (hollow-tall-wide-01); ends held in 22 of 30 rehearsals (73%).
  ; Effect (-31, -129.5, 241.6) mm, spread (9.3, 5.3, 10.1) mm; 22 of 30 rehearsals as promised: cost 34.
  ; Action parameters: -0.0114 0.0179 -0.0178 0.8519 0.0490 -0.0142 0.0217 0.2391 -0.0278 -0.0494 0.0317
  ; 0.4785
  ; It turned the object by over 15 degrees in 9 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-101-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01)
    :precondition (and (hand-empty) (can-lift-101-hollow-tall-wide-01 ?o) (>= (+ (x ?o) (x-of-lift-101-hollow-tall-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-101-hollow-tall-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-101-hollow-tall-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-101-hollow-tall-wide-01 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-101-hollow-tall-wide-01 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-101-hollow-tall-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-101-hollow-tall-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-101-hollow-tall-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-lift-101-hollow-tall-wide-01 ?o))))

  ; Put down what lift-101-hollow-tall-wide-01 lifted.
  (:action put-down-lift-101-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01)
    :precondition (and (held-by-lift-101-hollow-tall-wide-01 ?o) (>= (+ (x ?o) (x-of-put-down-lift-101-hollow-tall-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-101-hollow-tall-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-101-hollow-tall-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-101-hollow-tall-wide-01 ?o)) 15994))
    :effect (and (not (held-by-lift-101-hollow-tall-wide-01 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-101-hollow-tall-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-101-hollow-tall-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-101-hollow-tall-wide-01 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 101 on category 10 (solid-narrow-10); ends held in 6 of 37 rehearsals (16%).
  ; Effect (-18.3, -61.1, 237) mm, spread (6.3, 21.4, 13.3) mm; 5 of 37 rehearsals as promised: cost 188.
  ; Action parameters: -0.0114 0.0179 -0.0178 0.8519 0.0490 -0.0142 0.0217 0.2391 -0.0278 -0.0494 0.0317
  ; 0.4785
  ; What it promises for an object stands in the problem.
  (:action lift-101-solid-narrow-10
    :parameters (?o - solid-narrow-10)
    :precondition (and (hand-empty) (can-lift-101-solid-narrow-10 ?o) (>= (+ (x ?o) (x-of-lift-101-solid-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-101-solid-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-101-solid-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-101-solid-narrow-10 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-101-solid-narrow-10 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-101-solid-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-101-solid-narrow-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-101-solid-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-lift-101-solid-narrow-10 ?o))))

  ; Put down what lift-101-solid-narrow-10 lifted.
  (:action put-down-lift-101-solid-narrow-10
    :parameters (?o - solid-narrow-10)
    :precondition (and (held-by-lift-101-solid-narrow-10 ?o) (>= (+ (x ?o) (x-of-put-down-lift-101-solid-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-101-solid-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-101-solid-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-101-solid-narrow-10 ?o)) 15994))
    :effect (and (not (held-by-lift-101-solid-narrow-10 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-101-solid-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-101-solid-narrow-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-101-solid-narrow-10 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 101 on category 00 (hollow-00); ends held in 30 of 30 rehearsals (100%).
  ; Effect (2.1, -62.7, 198.4) mm, spread (0.9, 8.1, 5.6) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0070 0.0483 0.0107 0.7144 -0.0004 0.0070 -0.0205 0.9130 0.0014 -0.0005 -0.0340
  ; 0.3106
  ; What it promises for an object stands in the problem.
  (:action lift-101a-hollow-00
    :parameters (?o - hollow-00)
    :precondition (and (hand-empty) (can-lift-101a-hollow-00 ?o) (>= (+ (x ?o) (x-of-lift-101a-hollow-00 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-101a-hollow-00 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-101a-hollow-00 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-101a-hollow-00 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-101a-hollow-00 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-101a-hollow-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-101a-hollow-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-101a-hollow-00 ?o)) 10000)) (increase (total-cost) (cost-of-lift-101a-hollow-00 ?o))))

  ; Put down what lift-101a-hollow-00 lifted.
  (:action put-down-lift-101a-hollow-00
    :parameters (?o - hollow-00)
    :precondition (and (held-by-lift-101a-hollow-00 ?o) (>= (+ (x ?o) (x-of-put-down-lift-101a-hollow-00 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-101a-hollow-00 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-101a-hollow-00 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-101a-hollow-00 ?o)) 15994))
    :effect (and (not (held-by-lift-101a-hollow-00 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-101a-hollow-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-101a-hollow-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-101a-hollow-00 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 101 on category 01 (hollow-tall-wide-01); ends held in 30 of 30 rehearsals (100%).
  ; Effect (0.7, -80.6, 199.7) mm, spread (1.6, 7, 2.1) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0070 0.0483 0.0107 0.7144 -0.0004 0.0070 -0.0205 0.9130 0.0014 -0.0005 -0.0340
  ; 0.3106
  ; What it promises for an object stands in the problem.
  (:action lift-101a-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01)
    :precondition (and (hand-empty) (can-lift-101a-hollow-tall-wide-01 ?o) (>= (+ (x ?o) (x-of-lift-101a-hollow-tall-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-101a-hollow-tall-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-101a-hollow-tall-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-101a-hollow-tall-wide-01 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-101a-hollow-tall-wide-01 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-101a-hollow-tall-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-101a-hollow-tall-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-101a-hollow-tall-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-lift-101a-hollow-tall-wide-01 ?o))))

  ; Put down what lift-101a-hollow-tall-wide-01 lifted.
  (:action put-down-lift-101a-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01)
    :precondition (and (held-by-lift-101a-hollow-tall-wide-01 ?o) (>= (+ (x ?o) (x-of-put-down-lift-101a-hollow-tall-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-101a-hollow-tall-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-101a-hollow-tall-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-101a-hollow-tall-wide-01 ?o)) 15994))
    :effect (and (not (held-by-lift-101a-hollow-tall-wide-01 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-101a-hollow-tall-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-101a-hollow-tall-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-101a-hollow-tall-wide-01 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 101 on category 11 (any-low-narrow-11); ends held in 30 of 30 rehearsals (100%).
  ; Effect (5, -44.6, 200.1) mm, spread (1.6, 0.9, 0.5) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0093 0.0084 0.0076 0.5326 -0.0135 -0.0277 -0.0141 0.0699 -0.0050 -0.0422 -0.0364
  ; 0.4148
  ; What it promises for an object stands in the problem.
  (:action lift-101b-any-low-narrow-11
    :parameters (?o - any-low-narrow-11)
    :precondition (and (hand-empty) (can-lift-101b-any-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-101b-any-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-101b-any-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-101b-any-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-101b-any-low-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-101b-any-low-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-101b-any-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-101b-any-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-101b-any-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-101b-any-low-narrow-11 ?o))))

  ; Put down what lift-101b-any-low-narrow-11 lifted.
  (:action put-down-lift-101b-any-low-narrow-11
    :parameters (?o - any-low-narrow-11)
    :precondition (and (held-by-lift-101b-any-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-101b-any-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-101b-any-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-101b-any-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-101b-any-low-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-101b-any-low-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-101b-any-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-101b-any-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-101b-any-low-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 110 on category 00 (hollow-00); ends held in 5 of 30 rehearsals (17%).
  ; Effect (-39.6, 12.7, 199.9) mm, spread (1, 0.1, 0.1) mm; 5 of 30 rehearsals as promised: cost 168.
  ; Action parameters: 0.0113 -0.0083 -0.0003 0.1524 -0.0015 -0.0336 -0.0075 0.6522 -0.0419 0.0118 -0.0107
  ; 0.6643
  ; It turned the object by over 15 degrees in 1 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-110a-hollow-00
    :parameters (?o - hollow-00)
    :precondition (and (hand-empty) (can-lift-110a-hollow-00 ?o) (>= (+ (x ?o) (x-of-lift-110a-hollow-00 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-110a-hollow-00 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-110a-hollow-00 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-110a-hollow-00 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-110a-hollow-00 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-110a-hollow-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-110a-hollow-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-110a-hollow-00 ?o)) 10000)) (increase (total-cost) (cost-of-lift-110a-hollow-00 ?o))))

  ; Put down what lift-110a-hollow-00 lifted.
  (:action put-down-lift-110a-hollow-00
    :parameters (?o - hollow-00)
    :precondition (and (held-by-lift-110a-hollow-00 ?o) (>= (+ (x ?o) (x-of-put-down-lift-110a-hollow-00 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-110a-hollow-00 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-110a-hollow-00 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-110a-hollow-00 ?o)) 15994))
    :effect (and (not (held-by-lift-110a-hollow-00 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-110a-hollow-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-110a-hollow-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-110a-hollow-00 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 110 on category 10 (solid-narrow-10); ends at rest in 37 of 37 rehearsals (100%).
  ; Effect (-69.6, -26.2, 0) mm, spread (15.4, 30.9, 0) mm; 32 of 37 rehearsals as promised: cost 18.
  ; Action parameters: 0.0469 0.0292 -0.0161 0.8821 -0.0361 -0.0441 -0.0126 0.4855 -0.0346 -0.0186 0.0158
  ; 0.6283
  ; What it promises for an object stands in the problem.
  (:action pull-110-solid-narrow-10
    :parameters (?o - solid-narrow-10)
    :precondition (and (hand-empty) (can-pull-110-solid-narrow-10 ?o) (>= (+ (x ?o) (x-of-pull-110-solid-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-110-solid-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-110-solid-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-110-solid-narrow-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-110-solid-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-110-solid-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-pull-110-solid-narrow-10 ?o))))

  ; Primitive 110 on category 00 (hollow-00); ends at rest in 25 of 30 rehearsals (83%).
  ; Effect (-34.4, 11.8, 0) mm, spread (5.1, 0.5, 0) mm; 25 of 30 rehearsals as promised: cost 22.
  ; Action parameters: 0.0113 -0.0083 -0.0003 0.1524 -0.0015 -0.0336 -0.0075 0.6522 -0.0419 0.0118 -0.0107
  ; 0.6643
  ; It turned the object by over 15 degrees in 1 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action pull-110a-hollow-00
    :parameters (?o - hollow-00)
    :precondition (and (hand-empty) (can-pull-110a-hollow-00 ?o) (>= (+ (x ?o) (x-of-pull-110a-hollow-00 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-110a-hollow-00 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-110a-hollow-00 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-110a-hollow-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-110a-hollow-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-110a-hollow-00 ?o)) 10000)) (increase (total-cost) (cost-of-pull-110a-hollow-00 ?o))))

  ; Primitive 010 on category 01 (hollow-tall-wide-01); ends at rest in 29 of 30 rehearsals (97%).
  ; Effect (-34.9, 24.5, 0) mm, spread (10, 0.3, 0) mm; 29 of 30 rehearsals as promised: cost 7.
  ; Action parameters: 0.0098 -0.0465 0.0044 0.1564 0.0302 -0.0224 -0.0231 0.5920 -0.0327 0.0239 -0.0176
  ; 0.7969
  ; It turned the object by over 15 degrees in 1 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action pull-left-010b-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01)
    :precondition (and (hand-empty) (can-pull-left-010b-hollow-tall-wide-01 ?o) (>= (+ (x ?o) (x-of-pull-left-010b-hollow-tall-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-left-010b-hollow-tall-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-left-010b-hollow-tall-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-left-010b-hollow-tall-wide-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-left-010b-hollow-tall-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-left-010b-hollow-tall-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-pull-left-010b-hollow-tall-wide-01 ?o))))

  ; Primitive 010 on category 10 (solid-narrow-10); ends at rest in 37 of 37 rehearsals (100%).
  ; Effect (-21.8, 14.5, 0) mm, spread (14.8, 12.7, 0) mm; 37 of 37 rehearsals as promised: cost 4.
  ; Action parameters: 0.0381 -0.0374 -0.0027 0.4432 -0.0087 0.0001 0.0140 0.8059 -0.0165 0.0223 0.0419
  ; 0.6438
  ; It turned the object by over 15 degrees in 7 of 37 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action pull-left-010c-solid-narrow-10
    :parameters (?o - solid-narrow-10)
    :precondition (and (hand-empty) (can-pull-left-010c-solid-narrow-10 ?o) (>= (+ (x ?o) (x-of-pull-left-010c-solid-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-left-010c-solid-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-left-010c-solid-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-left-010c-solid-narrow-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-left-010c-solid-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-left-010c-solid-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-pull-left-010c-solid-narrow-10 ?o))))

  ; Primitive 100 on category 10 (solid-narrow-10); ends at rest in 32 of 37 rehearsals (86%).
  ; Effect (-26.7, -37.9, 0) mm, spread (23.9, 32.1, 0) mm; 26 of 37 rehearsals as promised: cost 38.
  ; Action parameters: 0.0325 0.0452 0.0169 0.5670 0.0130 -0.0171 0.0093 0.9358 -0.0416 -0.0239 0.0296
  ; 0.4702
  ; It turned the object by over 15 degrees in 1 of 37 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action pull-right-100c-solid-narrow-10
    :parameters (?o - solid-narrow-10)
    :precondition (and (hand-empty) (can-pull-right-100c-solid-narrow-10 ?o) (>= (+ (x ?o) (x-of-pull-right-100c-solid-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-right-100c-solid-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-right-100c-solid-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-right-100c-solid-narrow-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-right-100c-solid-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-right-100c-solid-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-pull-right-100c-solid-narrow-10 ?o))))

  ; Primitive 110 on category 11 (any-low-narrow-11); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (-55.3, -39.2, 0) mm, spread (2, 9.1, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0374 -0.0083 -0.0238 0.7869 -0.0176 -0.0409 -0.0186 0.1491 -0.0071 -0.0406 0.0037
  ; 0.6754
  ; What it promises for an object stands in the problem.
  (:action pull-right-110c-any-low-narrow-11
    :parameters (?o - any-low-narrow-11)
    :precondition (and (hand-empty) (can-pull-right-110c-any-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-pull-right-110c-any-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-right-110c-any-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-right-110c-any-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-right-110c-any-low-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-right-110c-any-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-right-110c-any-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-pull-right-110c-any-low-narrow-11 ?o))))

  ; Primitive 111 on category 00 (hollow-00); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (-23.9, -17.9, 0) mm, spread (14.5, 11.2, 0) mm; 29 of 30 rehearsals as promised: cost 7.
  ; Action parameters: 0.0357 0.0500 -0.0106 0.3710 -0.0358 0.0133 -0.0061 0.6109 -0.0381 -0.0488 -0.0372
  ; 0.9128
  ; What it promises for an object stands in the problem.
  (:action pull-right-111a-hollow-00
    :parameters (?o - hollow-00)
    :precondition (and (hand-empty) (can-pull-right-111a-hollow-00 ?o) (>= (+ (x ?o) (x-of-pull-right-111a-hollow-00 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-right-111a-hollow-00 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-right-111a-hollow-00 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-right-111a-hollow-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-right-111a-hollow-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-right-111a-hollow-00 ?o)) 10000)) (increase (total-cost) (cost-of-pull-right-111a-hollow-00 ?o))))

  ; Primitive 001 on category 11 (any-low-narrow-11); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (93.2, -26.4, 0) mm, spread (5, 3.6, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0447 0.0137 -0.0062 0.6854 0.0498 -0.0211 -0.0213 0.0600 0.0456 -0.0117 0.0436
  ; 0.5137
  ; It turned the object by over 15 degrees in 1 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-forward-001-any-low-narrow-11
    :parameters (?o - any-low-narrow-11)
    :precondition (and (hand-empty) (can-push-forward-001-any-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-push-forward-001-any-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-001-any-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-001-any-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-001-any-low-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-001-any-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-001-any-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-001-any-low-narrow-11 ?o))))

  ; Primitive 001 on category 10 (solid-narrow-10); ends at rest in 37 of 37 rehearsals (100%).
  ; Effect (71.6, -20.3, 0) mm, spread (32, 17.5, 0) mm; 28 of 37 rehearsals as promised: cost 31.
  ; Action parameters: -0.0447 0.0137 -0.0062 0.6854 0.0498 -0.0211 -0.0213 0.0600 0.0456 -0.0117 0.0436
  ; 0.5137
  ; What it promises for an object stands in the problem.
  (:action push-forward-001-solid-narrow-10
    :parameters (?o - solid-narrow-10)
    :precondition (and (hand-empty) (can-push-forward-001-solid-narrow-10 ?o) (>= (+ (x ?o) (x-of-push-forward-001-solid-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-001-solid-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-001-solid-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-001-solid-narrow-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-001-solid-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-001-solid-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-001-solid-narrow-10 ?o))))

  ; Primitive 001 on category 11 (any-low-narrow-11); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (84.8, 18, 0) mm, spread (2.1, 1.2, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0376 -0.0001 -0.0233 0.8654 0.0479 0.0203 -0.0103 0.2458 0.0218 -0.0074 -0.0205
  ; 0.5032
  ; What it promises for an object stands in the problem.
  (:action push-forward-001c-any-low-narrow-11
    :parameters (?o - any-low-narrow-11)
    :precondition (and (hand-empty) (can-push-forward-001c-any-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-push-forward-001c-any-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-001c-any-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-001c-any-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-001c-any-low-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-001c-any-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-001c-any-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-001c-any-low-narrow-11 ?o))))

  ; Primitive 000 on category 10 (solid-narrow-10); ends at rest in 33 of 37 rehearsals (89%).
  ; Effect (41.3, 20.8, 0) mm, spread (21.2, 33.6, 0) mm; 28 of 37 rehearsals as promised: cost 31.
  ; Action parameters: -0.0364 -0.0480 0.0114 0.9100 -0.0358 0.0423 -0.0077 0.6890 0.0475 0.0262 0.0297
  ; 0.3498
  ; It turned the object by over 15 degrees in 14 of 37 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-forward-left-000c-solid-narrow-10
    :parameters (?o - solid-narrow-10)
    :precondition (and (hand-empty) (can-push-forward-left-000c-solid-narrow-10 ?o) (>= (+ (x ?o) (x-of-push-forward-left-000c-solid-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-left-000c-solid-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-left-000c-solid-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-left-000c-solid-narrow-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-left-000c-solid-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-left-000c-solid-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-left-000c-solid-narrow-10 ?o))))

  ; Primitive 011 on category 11 (any-low-narrow-11); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (59.4, 40.8, 0) mm, spread (12.3, 22.3, 0) mm; 28 of 30 rehearsals as promised: cost 11.
  ; Action parameters: -0.0230 -0.0192 0.0034 0.7848 0.0407 0.0488 -0.0091 0.1211 -0.0073 0.0300 0.0166
  ; 0.6436
  ; What it promises for an object stands in the problem.
  (:action push-forward-left-011-any-low-narrow-11
    :parameters (?o - any-low-narrow-11)
    :precondition (and (hand-empty) (can-push-forward-left-011-any-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-push-forward-left-011-any-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-left-011-any-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-left-011-any-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-left-011-any-low-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-left-011-any-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-left-011-any-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-left-011-any-low-narrow-11 ?o))))

  ; Primitive 011 on category 00 (hollow-00); ends at rest in 20 of 30 rehearsals (67%).
  ; Effect (38.9, 23.8, 0) mm, spread (16.4, 10.2, 0) mm; 20 of 30 rehearsals as promised: cost 43.
  ; Action parameters: -0.0263 0.0025 -0.0229 0.3620 -0.0059 -0.0443 0.0065 0.4889 0.0486 0.0275 -0.0417
  ; 0.9867
  ; It turned the object by over 15 degrees in 1 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-forward-left-011a-hollow-00
    :parameters (?o - hollow-00)
    :precondition (and (hand-empty) (can-push-forward-left-011a-hollow-00 ?o) (>= (+ (x ?o) (x-of-push-forward-left-011a-hollow-00 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-left-011a-hollow-00 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-left-011a-hollow-00 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-left-011a-hollow-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-left-011a-hollow-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-left-011a-hollow-00 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-left-011a-hollow-00 ?o))))

  ; Primitive 001 on category 00 (hollow-00); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (30.9, -41.1, 0) mm, spread (8.9, 0.7, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0139 0.0260 0.0078 0.0408 0.0287 -0.0246 -0.0141 0.6464 0.0411 -0.0399 0.0087
  ; 0.5594
  ; It turned the object by over 15 degrees in 1 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-forward-right-001a-hollow-00
    :parameters (?o - hollow-00)
    :precondition (and (hand-empty) (can-push-forward-right-001a-hollow-00 ?o) (>= (+ (x ?o) (x-of-push-forward-right-001a-hollow-00 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-right-001a-hollow-00 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-right-001a-hollow-00 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-right-001a-hollow-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-right-001a-hollow-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-right-001a-hollow-00 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-right-001a-hollow-00 ?o))))

  ; Primitive 011 on category 11 (any-low-narrow-11); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (28.6, -41.1, 0) mm, spread (0.6, 1.2, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0037 -0.0312 -0.0041 0.6447 0.0324 -0.0402 0.0053 0.4950 -0.0336 -0.0008 0.0037
  ; 0.7552
  ; What it promises for an object stands in the problem.
  (:action push-forward-right-011d-any-low-narrow-11
    :parameters (?o - any-low-narrow-11)
    :precondition (and (hand-empty) (can-push-forward-right-011d-any-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-push-forward-right-011d-any-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-right-011d-any-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-right-011d-any-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-right-011d-any-low-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-right-011d-any-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-right-011d-any-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-right-011d-any-low-narrow-11 ?o))))

  ; Primitive 101 on category 10 (solid-narrow-10); ends at rest in 31 of 37 rehearsals (84%).
  ; Effect (27, -49.5, 0) mm, spread (23, 32.9, 0) mm; 24 of 37 rehearsals as promised: cost 45.
  ; Action parameters: -0.0114 0.0179 -0.0178 0.8519 0.0490 -0.0142 0.0217 0.2391 -0.0278 -0.0494 0.0317
  ; 0.4785
  ; What it promises for an object stands in the problem.
  (:action push-forward-right-101-solid-narrow-10
    :parameters (?o - solid-narrow-10)
    :precondition (and (hand-empty) (can-push-forward-right-101-solid-narrow-10 ?o) (>= (+ (x ?o) (x-of-push-forward-right-101-solid-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-right-101-solid-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-right-101-solid-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-right-101-solid-narrow-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-right-101-solid-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-right-101-solid-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-right-101-solid-narrow-10 ?o))))

  ; Primitive 111 on category 10 (solid-narrow-10); ends at rest in 37 of 37 rehearsals (100%).
  ; Effect (19.6, -28.6, 0) mm, spread (13.8, 16.9, 0) mm; 37 of 37 rehearsals as promised: cost 4.
  ; Action parameters: -0.0384 0.0500 -0.0169 0.1077 0.0101 -0.0394 -0.0002 0.7312 -0.0145 -0.0157 0.0349
  ; 0.6062
  ; What it promises for an object stands in the problem.
  (:action push-forward-right-111-solid-narrow-10
    :parameters (?o - solid-narrow-10)
    :precondition (and (hand-empty) (can-push-forward-right-111-solid-narrow-10 ?o) (>= (+ (x ?o) (x-of-push-forward-right-111-solid-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-right-111-solid-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-right-111-solid-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-right-111-solid-narrow-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-right-111-solid-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-right-111-solid-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-right-111-solid-narrow-10 ?o))))

  ; Primitive 111 on category 01 (hollow-tall-wide-01); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (41.1, -33.5, 0) mm, spread (5, 1.7, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0018 0.0344 -0.0155 0.1304 -0.0108 0.0252 -0.0125 0.1486 0.0456 -0.0337 0.0208
  ; 0.5394
  ; What it promises for an object stands in the problem.
  (:action push-forward-right-111b-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01)
    :precondition (and (hand-empty) (can-push-forward-right-111b-hollow-tall-wide-01 ?o) (>= (+ (x ?o) (x-of-push-forward-right-111b-hollow-tall-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-right-111b-hollow-tall-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-right-111b-hollow-tall-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-right-111b-hollow-tall-wide-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-right-111b-hollow-tall-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-right-111b-hollow-tall-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-right-111b-hollow-tall-wide-01 ?o))))

  ; Primitive 000 on category 00 (hollow-00); ends at rest in 6 of 30 rehearsals (20%).
  ; Effect (-0.5, 27.1, 0) mm, spread (1.2, 3.9, 0) mm; 6 of 30 rehearsals as promised: cost 153.
  ; Action parameters: -0.0052 -0.0279 -0.0232 0.7913 -0.0181 0.0467 -0.0143 0.8116 0.0024 0.0325 0.0113
  ; 0.4626
  ; It turned the object by over 15 degrees in 7 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-left-000-hollow-00
    :parameters (?o - hollow-00)
    :precondition (and (hand-empty) (can-push-left-000-hollow-00 ?o) (>= (+ (x ?o) (x-of-push-left-000-hollow-00 ?o)) 10006) (<= (+ (x ?o) (x-of-push-left-000-hollow-00 ?o)) 15994) (>= (+ (y ?o) (y-of-push-left-000-hollow-00 ?o)) 10006) (<= (+ (y ?o) (y-of-push-left-000-hollow-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-left-000-hollow-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-left-000-hollow-00 ?o)) 10000)) (increase (total-cost) (cost-of-push-left-000-hollow-00 ?o))))

  ; Primitive 010 on category 00 (hollow-00); ends at rest in 28 of 30 rehearsals (93%).
  ; Effect (-10, 26.5, 0) mm, spread (6.8, 19, 0) mm; 28 of 30 rehearsals as promised: cost 11.
  ; Action parameters: -0.0004 -0.0440 -0.0114 0.1340 -0.0174 0.0453 0.0081 0.8980 -0.0314 0.0405 0.0391
  ; 0.2436
  ; What it promises for an object stands in the problem.
  (:action push-left-010a-hollow-00
    :parameters (?o - hollow-00)
    :precondition (and (hand-empty) (can-push-left-010a-hollow-00 ?o) (>= (+ (x ?o) (x-of-push-left-010a-hollow-00 ?o)) 10006) (<= (+ (x ?o) (x-of-push-left-010a-hollow-00 ?o)) 15994) (>= (+ (y ?o) (y-of-push-left-010a-hollow-00 ?o)) 10006) (<= (+ (y ?o) (y-of-push-left-010a-hollow-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-left-010a-hollow-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-left-010a-hollow-00 ?o)) 10000)) (increase (total-cost) (cost-of-push-left-010a-hollow-00 ?o))))

  ; Primitive 010 on category 11 (any-low-narrow-11); ends at rest in 27 of 30 rehearsals (90%).
  ; Effect (-10.7, 86.4, 0) mm, spread (16.6, 25.3, 0) mm; 24 of 30 rehearsals as promised: cost 26.
  ; Action parameters: 0.0296 -0.0490 -0.0154 0.3754 -0.0456 -0.0028 0.0241 0.6857 0.0139 0.0047 0.0157
  ; 0.9582
  ; It turned the object by over 15 degrees in 4 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-left-010d-any-low-narrow-11
    :parameters (?o - any-low-narrow-11)
    :precondition (and (hand-empty) (can-push-left-010d-any-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-push-left-010d-any-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-push-left-010d-any-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-push-left-010d-any-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-push-left-010d-any-low-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-left-010d-any-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-left-010d-any-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-push-left-010d-any-low-narrow-11 ?o))))

  ; Primitive 011 on category 00 (hollow-00); ends at rest in 29 of 30 rehearsals (97%).
  ; Effect (13.7, 39.8, 0) mm, spread (17.1, 23.8, 0) mm; 27 of 30 rehearsals as promised: cost 14.
  ; Action parameters: -0.0230 -0.0192 0.0034 0.7848 0.0407 0.0488 -0.0091 0.1211 -0.0073 0.0300 0.0166
  ; 0.6436
  ; It turned the object by over 15 degrees in 3 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-left-011-hollow-00
    :parameters (?o - hollow-00)
    :precondition (and (hand-empty) (can-push-left-011-hollow-00 ?o) (>= (+ (x ?o) (x-of-push-left-011-hollow-00 ?o)) 10006) (<= (+ (x ?o) (x-of-push-left-011-hollow-00 ?o)) 15994) (>= (+ (y ?o) (y-of-push-left-011-hollow-00 ?o)) 10006) (<= (+ (y ?o) (y-of-push-left-011-hollow-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-left-011-hollow-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-left-011-hollow-00 ?o)) 10000)) (increase (total-cost) (cost-of-push-left-011-hollow-00 ?o))))

  ; Primitive 011 on category 01 (hollow-tall-wide-01); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (31.9, 75.6, 0) mm, spread (6.1, 6.6, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0048 -0.0341 -0.0130 0.8685 0.0345 0.0003 -0.0043 0.2432 0.0238 -0.0302 0.0176
  ; 0.7753
  ; What it promises for an object stands in the problem.
  (:action push-left-011b-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01)
    :precondition (and (hand-empty) (can-push-left-011b-hollow-tall-wide-01 ?o) (>= (+ (x ?o) (x-of-push-left-011b-hollow-tall-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-push-left-011b-hollow-tall-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-push-left-011b-hollow-tall-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-push-left-011b-hollow-tall-wide-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-left-011b-hollow-tall-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-left-011b-hollow-tall-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-push-left-011b-hollow-tall-wide-01 ?o))))

  ; Primitive 011 on category 10 (solid-narrow-10); ends at rest in 37 of 37 rehearsals (100%).
  ; Effect (10.5, 42.3, 0) mm, spread (8.5, 22, 0) mm; 36 of 37 rehearsals as promised: cost 6.
  ; Action parameters: -0.0125 -0.0423 0.0075 0.7905 0.0169 0.0417 0.0073 0.8065 -0.0113 0.0041 0.0109
  ; 0.8149
  ; What it promises for an object stands in the problem.
  (:action push-left-011c-solid-narrow-10
    :parameters (?o - solid-narrow-10)
    :precondition (and (hand-empty) (can-push-left-011c-solid-narrow-10 ?o) (>= (+ (x ?o) (x-of-push-left-011c-solid-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-push-left-011c-solid-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-push-left-011c-solid-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-push-left-011c-solid-narrow-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-left-011c-solid-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-left-011c-solid-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-push-left-011c-solid-narrow-10 ?o))))

  ; Primitive 001 on category 01 (hollow-tall-wide-01); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (19.5, -96.2, 0) mm, spread (9.7, 6.6, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0115 0.0497 -0.0117 0.7240 0.0206 -0.0201 0.0043 0.0293 0.0318 0.0419 -0.0469
  ; 0.6999
  ; What it promises for an object stands in the problem.
  (:action push-right-001b-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01)
    :precondition (and (hand-empty) (can-push-right-001b-hollow-tall-wide-01 ?o) (>= (+ (x ?o) (x-of-push-right-001b-hollow-tall-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-001b-hollow-tall-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-001b-hollow-tall-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-001b-hollow-tall-wide-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-001b-hollow-tall-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-001b-hollow-tall-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-001b-hollow-tall-wide-01 ?o))))

  ; Primitive 100 on category 01 (hollow-tall-wide-01); ends at rest in 15 of 30 rehearsals (50%).
  ; Effect (-1.1, -36.7, 0) mm, spread (17, 21, 0) mm; 14 of 30 rehearsals as promised: cost 77.
  ; Action parameters: 0.0384 0.0210 0.0226 0.8485 0.0177 -0.0303 -0.0186 0.9698 -0.0492 -0.0223 -0.0102
  ; 0.2028
  ; It turned the object by over 15 degrees in 5 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-right-100-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01)
    :precondition (and (hand-empty) (can-push-right-100-hollow-tall-wide-01 ?o) (>= (+ (x ?o) (x-of-push-right-100-hollow-tall-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-100-hollow-tall-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-100-hollow-tall-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-100-hollow-tall-wide-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-100-hollow-tall-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-100-hollow-tall-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-100-hollow-tall-wide-01 ?o))))

  ; Primitive 101 on category 01 (hollow-tall-wide-01); ends at rest in 8 of 30 rehearsals (27%).
  ; Effect (9.1, -91.5, 0) mm, spread (32, 21.6, 0) mm; 8 of 30 rehearsals as promised: cost 128.
  ; Action parameters: -0.0114 0.0179 -0.0178 0.8519 0.0490 -0.0142 0.0217 0.2391 -0.0278 -0.0494 0.0317
  ; 0.4785
  ; It turned the object by over 15 degrees in 9 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-right-101-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01)
    :precondition (and (hand-empty) (can-push-right-101-hollow-tall-wide-01 ?o) (>= (+ (x ?o) (x-of-push-right-101-hollow-tall-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-101-hollow-tall-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-101-hollow-tall-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-101-hollow-tall-wide-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-101-hollow-tall-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-101-hollow-tall-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-101-hollow-tall-wide-01 ?o))))

  ; Primitive 110 on category 01 (hollow-tall-wide-01); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (-40.6, -84, 0) mm, spread (7.2, 6.5, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0073 0.0359 -0.0025 0.7314 -0.0423 -0.0055 0.0119 0.1075 -0.0192 0.0472 -0.0493
  ; 0.8564
  ; What it promises for an object stands in the problem.
  (:action push-right-110b-hollow-tall-wide-01
    :parameters (?o - hollow-tall-wide-01)
    :precondition (and (hand-empty) (can-push-right-110b-hollow-tall-wide-01 ?o) (>= (+ (x ?o) (x-of-push-right-110b-hollow-tall-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-110b-hollow-tall-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-110b-hollow-tall-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-110b-hollow-tall-wide-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-110b-hollow-tall-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-110b-hollow-tall-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-110b-hollow-tall-wide-01 ?o))))

  ; Primitive 111 on category 00 (hollow-00); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (6.3, -16.2, 0) mm, spread (5.8, 14.7, 0) mm; 29 of 30 rehearsals as promised: cost 7.
  ; Action parameters: -0.0384 0.0500 -0.0169 0.1077 0.0101 -0.0394 -0.0002 0.7312 -0.0145 -0.0157 0.0349
  ; 0.6062
  ; It turned the object by over 15 degrees in 1 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-right-111-hollow-00
    :parameters (?o - hollow-00)
    :precondition (and (hand-empty) (can-push-right-111-hollow-00 ?o) (>= (+ (x ?o) (x-of-push-right-111-hollow-00 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-111-hollow-00 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-111-hollow-00 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-111-hollow-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-111-hollow-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-111-hollow-00 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-111-hollow-00 ?o))))

  ; Primitive 111 on category 11 (any-low-narrow-11); ends at rest in 28 of 30 rehearsals (93%).
  ; Effect (-16.6, -82.6, 0) mm, spread (13, 14.9, 0) mm; 26 of 30 rehearsals as promised: cost 18.
  ; Action parameters: 0.0362 0.0500 -0.0229 0.2246 -0.0358 0.0194 0.0064 0.7535 0.0319 -0.0196 0.0432
  ; 0.1852
  ; It turned the object by over 15 degrees in 3 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-right-111c-any-low-narrow-11
    :parameters (?o - any-low-narrow-11)
    :precondition (and (hand-empty) (can-push-right-111c-any-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-push-right-111c-any-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-111c-any-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-111c-any-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-111c-any-low-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-111c-any-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-111c-any-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-111c-any-low-narrow-11 ?o))))

  ; No operator is left out.
)
