; Learned domain tabletop, encoding numeric. Printed by neurosym; do not edit.
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

(define (domain tabletop-numeric)
  (:requirements :strips :typing :numeric-fluents :action-costs)

  (:types
    movable - object
    any-tall-narrow-10 hollow-wide-01 solid-00 solid-low-narrow-11 - movable)

  (:predicates
    (hand-empty)
    (held-by-lift-0000-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (held-by-lift-0000-hollow-wide-01 ?o - hollow-wide-01)
    (held-by-lift-0000b-hollow-wide-01 ?o - hollow-wide-01)
    (held-by-lift-0000c-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (held-by-lift-0000d-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (held-by-lift-0001b-hollow-wide-01 ?o - hollow-wide-01)
    (held-by-lift-0001d-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (held-by-lift-0100-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (held-by-lift-0100-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (held-by-lift-0100b-hollow-wide-01 ?o - hollow-wide-01)
    (held-by-lift-0100c-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (held-by-lift-0100d-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (held-by-lift-0101-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (held-by-lift-0101a-hollow-wide-01 ?o - hollow-wide-01)
    (held-by-lift-0101b-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (held-by-lift-0101c-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (held-by-lift-1000-hollow-wide-01 ?o - hollow-wide-01)
    (held-by-lift-1000-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (held-by-lift-1000a-hollow-wide-01 ?o - hollow-wide-01)
    (held-by-lift-1000b-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (held-by-lift-1001-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (held-by-lift-1001a-hollow-wide-01 ?o - hollow-wide-01)
    (held-by-lift-1001b-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (held-by-lift-1001c-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (held-by-lift-1100-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (held-by-lift-1100-solid-00 ?o - solid-00)
    (held-by-lift-1100-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (held-by-lift-1100a-hollow-wide-01 ?o - hollow-wide-01)
    (held-by-lift-1100b-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (held-by-lift-1100c-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (held-by-lift-1101-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (held-by-lift-1101a-hollow-wide-01 ?o - hollow-wide-01)
    (held-by-lift-1101b-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (held-by-lift-1101c-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (can-lift-0000-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (can-lift-0000-hollow-wide-01 ?o - hollow-wide-01)
    (can-lift-0000b-hollow-wide-01 ?o - hollow-wide-01)
    (can-lift-0000c-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (can-lift-0000d-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (can-lift-0001b-hollow-wide-01 ?o - hollow-wide-01)
    (can-lift-0001d-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (can-lift-0100-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (can-lift-0100-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (can-lift-0100b-hollow-wide-01 ?o - hollow-wide-01)
    (can-lift-0100c-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (can-lift-0100d-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (can-lift-0101-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (can-lift-0101a-hollow-wide-01 ?o - hollow-wide-01)
    (can-lift-0101b-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (can-lift-0101c-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (can-lift-1000-hollow-wide-01 ?o - hollow-wide-01)
    (can-lift-1000-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (can-lift-1000a-hollow-wide-01 ?o - hollow-wide-01)
    (can-lift-1000b-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (can-lift-1001-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (can-lift-1001a-hollow-wide-01 ?o - hollow-wide-01)
    (can-lift-1001b-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (can-lift-1001c-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (can-lift-1100-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (can-lift-1100-solid-00 ?o - solid-00)
    (can-lift-1100-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (can-lift-1100a-hollow-wide-01 ?o - hollow-wide-01)
    (can-lift-1100b-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (can-lift-1100c-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (can-lift-1101-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (can-lift-1101a-hollow-wide-01 ?o - hollow-wide-01)
    (can-lift-1101b-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (can-lift-1101c-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (can-place-forward-1010c-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (can-place-forward-right-1010-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (can-place-right-0000-hollow-wide-01 ?o - hollow-wide-01)
    (can-pull-0100-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (can-pull-0100a-solid-00 ?o - solid-00)
    (can-pull-0110-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (can-pull-0110a-solid-00 ?o - solid-00)
    (can-pull-0111-hollow-wide-01 ?o - hollow-wide-01)
    (can-pull-0111-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (can-pull-0111a-solid-00 ?o - solid-00)
    (can-pull-0111c-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (can-pull-left-0101-solid-00 ?o - solid-00)
    (can-pull-left-0101b-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (can-pull-left-0111b-hollow-wide-01 ?o - hollow-wide-01)
    (can-pull-left-1101-solid-00 ?o - solid-00)
    (can-pull-left-1111a-solid-00 ?o - solid-00)
    (can-pull-right-0000a-solid-00 ?o - solid-00)
    (can-pull-right-0110-hollow-wide-01 ?o - hollow-wide-01)
    (can-pull-right-0110c-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (can-pull-right-1010a-solid-00 ?o - solid-00)
    (can-pull-right-1110b-hollow-wide-01 ?o - hollow-wide-01)
    (can-push-forward-0001c-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (can-push-forward-1011-solid-00 ?o - solid-00)
    (can-push-forward-1011-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (can-push-forward-1011a-solid-00 ?o - solid-00)
    (can-push-forward-1011c-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (can-push-forward-left-0001a-solid-00 ?o - solid-00)
    (can-push-forward-left-1001-solid-00 ?o - solid-00)
    (can-push-forward-left-1011b-hollow-wide-01 ?o - hollow-wide-01)
    (can-push-forward-left-1111b-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (can-push-forward-right-0010a-solid-00 ?o - solid-00)
    (can-push-forward-right-0010b-hollow-wide-01 ?o - hollow-wide-01)
    (can-push-forward-right-0010c-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (can-push-forward-right-1010-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (can-push-forward-right-1101-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (can-push-left-0011-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (can-push-left-0011a-solid-00 ?o - solid-00)
    (can-push-left-0011b-hollow-wide-01 ?o - hollow-wide-01)
    (can-push-left-0011c-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (can-push-left-1110a-solid-00 ?o - solid-00)
    (can-push-left-1111-hollow-wide-01 ?o - hollow-wide-01)
    (can-push-left-1111-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (can-push-right-0000-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (can-push-right-0000c-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (can-push-right-0010d-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (can-push-right-0100b-hollow-wide-01 ?o - hollow-wide-01)
    (can-push-right-0110b-hollow-wide-01 ?o - hollow-wide-01)
    (can-push-right-1000-hollow-wide-01 ?o - hollow-wide-01)
    (can-push-right-1000-solid-00 ?o - solid-00)
    (can-push-right-1010-hollow-wide-01 ?o - hollow-wide-01)
    (can-push-right-1010b-hollow-wide-01 ?o - hollow-wide-01)
    (can-push-right-1100-solid-00 ?o - solid-00)
    (can-push-right-1100a-hollow-wide-01 ?o - hollow-wide-01)
    (can-push-right-1110-any-tall-narrow-10 ?o - any-tall-narrow-10)
    (can-push-right-1110-solid-low-narrow-11 ?o - solid-low-narrow-11)
    (can-stay-1101b-any-tall-narrow-10 ?o - any-tall-narrow-10))

  (:functions
    (x ?o - movable) - number
    (y ?o - movable) - number
    (z ?o - movable) - number
    (total-cost) - number
    (x-of-lift-0000-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-lift-0000-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (z-of-lift-0000-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (cost-of-lift-0000-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-put-down-lift-0000-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-put-down-lift-0000-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (z-of-put-down-lift-0000-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-lift-0000-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-lift-0000-hollow-wide-01 ?o - hollow-wide-01) - number
    (z-of-lift-0000-hollow-wide-01 ?o - hollow-wide-01) - number
    (cost-of-lift-0000-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-put-down-lift-0000-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-put-down-lift-0000-hollow-wide-01 ?o - hollow-wide-01) - number
    (z-of-put-down-lift-0000-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-lift-0000b-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-lift-0000b-hollow-wide-01 ?o - hollow-wide-01) - number
    (z-of-lift-0000b-hollow-wide-01 ?o - hollow-wide-01) - number
    (cost-of-lift-0000b-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-put-down-lift-0000b-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-put-down-lift-0000b-hollow-wide-01 ?o - hollow-wide-01) - number
    (z-of-put-down-lift-0000b-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-lift-0000c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-lift-0000c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (z-of-lift-0000c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (cost-of-lift-0000c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-put-down-lift-0000c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-put-down-lift-0000c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (z-of-put-down-lift-0000c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-lift-0000d-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-lift-0000d-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (z-of-lift-0000d-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (cost-of-lift-0000d-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-put-down-lift-0000d-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-put-down-lift-0000d-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (z-of-put-down-lift-0000d-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-lift-0001b-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-lift-0001b-hollow-wide-01 ?o - hollow-wide-01) - number
    (z-of-lift-0001b-hollow-wide-01 ?o - hollow-wide-01) - number
    (cost-of-lift-0001b-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-put-down-lift-0001b-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-put-down-lift-0001b-hollow-wide-01 ?o - hollow-wide-01) - number
    (z-of-put-down-lift-0001b-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-lift-0001d-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-lift-0001d-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (z-of-lift-0001d-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (cost-of-lift-0001d-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-put-down-lift-0001d-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-put-down-lift-0001d-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (z-of-put-down-lift-0001d-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-lift-0100-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-lift-0100-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (z-of-lift-0100-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (cost-of-lift-0100-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-put-down-lift-0100-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-put-down-lift-0100-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (z-of-put-down-lift-0100-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-lift-0100-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-lift-0100-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (z-of-lift-0100-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (cost-of-lift-0100-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-put-down-lift-0100-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-put-down-lift-0100-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (z-of-put-down-lift-0100-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-lift-0100b-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-lift-0100b-hollow-wide-01 ?o - hollow-wide-01) - number
    (z-of-lift-0100b-hollow-wide-01 ?o - hollow-wide-01) - number
    (cost-of-lift-0100b-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-put-down-lift-0100b-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-put-down-lift-0100b-hollow-wide-01 ?o - hollow-wide-01) - number
    (z-of-put-down-lift-0100b-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-lift-0100c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-lift-0100c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (z-of-lift-0100c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (cost-of-lift-0100c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-put-down-lift-0100c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-put-down-lift-0100c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (z-of-put-down-lift-0100c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-lift-0100d-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-lift-0100d-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (z-of-lift-0100d-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (cost-of-lift-0100d-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-put-down-lift-0100d-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-put-down-lift-0100d-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (z-of-put-down-lift-0100d-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-lift-0101-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-lift-0101-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (z-of-lift-0101-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (cost-of-lift-0101-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-put-down-lift-0101-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-put-down-lift-0101-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (z-of-put-down-lift-0101-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-lift-0101a-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-lift-0101a-hollow-wide-01 ?o - hollow-wide-01) - number
    (z-of-lift-0101a-hollow-wide-01 ?o - hollow-wide-01) - number
    (cost-of-lift-0101a-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-put-down-lift-0101a-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-put-down-lift-0101a-hollow-wide-01 ?o - hollow-wide-01) - number
    (z-of-put-down-lift-0101a-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-lift-0101b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-lift-0101b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (z-of-lift-0101b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (cost-of-lift-0101b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-put-down-lift-0101b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-put-down-lift-0101b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (z-of-put-down-lift-0101b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-lift-0101c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-lift-0101c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (z-of-lift-0101c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (cost-of-lift-0101c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-put-down-lift-0101c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-put-down-lift-0101c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (z-of-put-down-lift-0101c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-lift-1000-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-lift-1000-hollow-wide-01 ?o - hollow-wide-01) - number
    (z-of-lift-1000-hollow-wide-01 ?o - hollow-wide-01) - number
    (cost-of-lift-1000-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-put-down-lift-1000-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-put-down-lift-1000-hollow-wide-01 ?o - hollow-wide-01) - number
    (z-of-put-down-lift-1000-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-lift-1000-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-lift-1000-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (z-of-lift-1000-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (cost-of-lift-1000-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-put-down-lift-1000-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-put-down-lift-1000-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (z-of-put-down-lift-1000-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-lift-1000a-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-lift-1000a-hollow-wide-01 ?o - hollow-wide-01) - number
    (z-of-lift-1000a-hollow-wide-01 ?o - hollow-wide-01) - number
    (cost-of-lift-1000a-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-put-down-lift-1000a-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-put-down-lift-1000a-hollow-wide-01 ?o - hollow-wide-01) - number
    (z-of-put-down-lift-1000a-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-lift-1000b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-lift-1000b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (z-of-lift-1000b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (cost-of-lift-1000b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-put-down-lift-1000b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-put-down-lift-1000b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (z-of-put-down-lift-1000b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-lift-1001-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-lift-1001-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (z-of-lift-1001-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (cost-of-lift-1001-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-put-down-lift-1001-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-put-down-lift-1001-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (z-of-put-down-lift-1001-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-lift-1001a-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-lift-1001a-hollow-wide-01 ?o - hollow-wide-01) - number
    (z-of-lift-1001a-hollow-wide-01 ?o - hollow-wide-01) - number
    (cost-of-lift-1001a-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-put-down-lift-1001a-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-put-down-lift-1001a-hollow-wide-01 ?o - hollow-wide-01) - number
    (z-of-put-down-lift-1001a-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-lift-1001b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-lift-1001b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (z-of-lift-1001b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (cost-of-lift-1001b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-put-down-lift-1001b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-put-down-lift-1001b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (z-of-put-down-lift-1001b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-lift-1001c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-lift-1001c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (z-of-lift-1001c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (cost-of-lift-1001c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-put-down-lift-1001c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-put-down-lift-1001c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (z-of-put-down-lift-1001c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-lift-1100-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-lift-1100-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (z-of-lift-1100-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (cost-of-lift-1100-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-put-down-lift-1100-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-put-down-lift-1100-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (z-of-put-down-lift-1100-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-lift-1100-solid-00 ?o - solid-00) - number
    (y-of-lift-1100-solid-00 ?o - solid-00) - number
    (z-of-lift-1100-solid-00 ?o - solid-00) - number
    (cost-of-lift-1100-solid-00 ?o - solid-00) - number
    (x-of-put-down-lift-1100-solid-00 ?o - solid-00) - number
    (y-of-put-down-lift-1100-solid-00 ?o - solid-00) - number
    (z-of-put-down-lift-1100-solid-00 ?o - solid-00) - number
    (x-of-lift-1100-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-lift-1100-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (z-of-lift-1100-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (cost-of-lift-1100-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-put-down-lift-1100-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-put-down-lift-1100-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (z-of-put-down-lift-1100-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-lift-1100a-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-lift-1100a-hollow-wide-01 ?o - hollow-wide-01) - number
    (z-of-lift-1100a-hollow-wide-01 ?o - hollow-wide-01) - number
    (cost-of-lift-1100a-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-put-down-lift-1100a-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-put-down-lift-1100a-hollow-wide-01 ?o - hollow-wide-01) - number
    (z-of-put-down-lift-1100a-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-lift-1100b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-lift-1100b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (z-of-lift-1100b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (cost-of-lift-1100b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-put-down-lift-1100b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-put-down-lift-1100b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (z-of-put-down-lift-1100b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-lift-1100c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-lift-1100c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (z-of-lift-1100c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (cost-of-lift-1100c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-put-down-lift-1100c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-put-down-lift-1100c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (z-of-put-down-lift-1100c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-lift-1101-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-lift-1101-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (z-of-lift-1101-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (cost-of-lift-1101-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-put-down-lift-1101-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-put-down-lift-1101-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (z-of-put-down-lift-1101-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-lift-1101a-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-lift-1101a-hollow-wide-01 ?o - hollow-wide-01) - number
    (z-of-lift-1101a-hollow-wide-01 ?o - hollow-wide-01) - number
    (cost-of-lift-1101a-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-put-down-lift-1101a-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-put-down-lift-1101a-hollow-wide-01 ?o - hollow-wide-01) - number
    (z-of-put-down-lift-1101a-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-lift-1101b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-lift-1101b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (z-of-lift-1101b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (cost-of-lift-1101b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-put-down-lift-1101b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-put-down-lift-1101b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (z-of-put-down-lift-1101b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-lift-1101c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-lift-1101c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (z-of-lift-1101c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (cost-of-lift-1101c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-put-down-lift-1101c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-put-down-lift-1101c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (z-of-put-down-lift-1101c-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-place-forward-1010c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-place-forward-1010c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (cost-of-place-forward-1010c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-place-forward-right-1010-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-place-forward-right-1010-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (cost-of-place-forward-right-1010-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-place-right-0000-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-place-right-0000-hollow-wide-01 ?o - hollow-wide-01) - number
    (cost-of-place-right-0000-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-pull-0100-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-pull-0100-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (cost-of-pull-0100-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-pull-0100a-solid-00 ?o - solid-00) - number
    (y-of-pull-0100a-solid-00 ?o - solid-00) - number
    (cost-of-pull-0100a-solid-00 ?o - solid-00) - number
    (x-of-pull-0110-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-pull-0110-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (cost-of-pull-0110-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-pull-0110a-solid-00 ?o - solid-00) - number
    (y-of-pull-0110a-solid-00 ?o - solid-00) - number
    (cost-of-pull-0110a-solid-00 ?o - solid-00) - number
    (x-of-pull-0111-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-pull-0111-hollow-wide-01 ?o - hollow-wide-01) - number
    (cost-of-pull-0111-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-pull-0111-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-pull-0111-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (cost-of-pull-0111-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-pull-0111a-solid-00 ?o - solid-00) - number
    (y-of-pull-0111a-solid-00 ?o - solid-00) - number
    (cost-of-pull-0111a-solid-00 ?o - solid-00) - number
    (x-of-pull-0111c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-pull-0111c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (cost-of-pull-0111c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-pull-left-0101-solid-00 ?o - solid-00) - number
    (y-of-pull-left-0101-solid-00 ?o - solid-00) - number
    (cost-of-pull-left-0101-solid-00 ?o - solid-00) - number
    (x-of-pull-left-0101b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-pull-left-0101b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (cost-of-pull-left-0101b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-pull-left-0111b-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-pull-left-0111b-hollow-wide-01 ?o - hollow-wide-01) - number
    (cost-of-pull-left-0111b-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-pull-left-1101-solid-00 ?o - solid-00) - number
    (y-of-pull-left-1101-solid-00 ?o - solid-00) - number
    (cost-of-pull-left-1101-solid-00 ?o - solid-00) - number
    (x-of-pull-left-1111a-solid-00 ?o - solid-00) - number
    (y-of-pull-left-1111a-solid-00 ?o - solid-00) - number
    (cost-of-pull-left-1111a-solid-00 ?o - solid-00) - number
    (x-of-pull-right-0000a-solid-00 ?o - solid-00) - number
    (y-of-pull-right-0000a-solid-00 ?o - solid-00) - number
    (cost-of-pull-right-0000a-solid-00 ?o - solid-00) - number
    (x-of-pull-right-0110-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-pull-right-0110-hollow-wide-01 ?o - hollow-wide-01) - number
    (cost-of-pull-right-0110-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-pull-right-0110c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-pull-right-0110c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (cost-of-pull-right-0110c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-pull-right-1010a-solid-00 ?o - solid-00) - number
    (y-of-pull-right-1010a-solid-00 ?o - solid-00) - number
    (cost-of-pull-right-1010a-solid-00 ?o - solid-00) - number
    (x-of-pull-right-1110b-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-pull-right-1110b-hollow-wide-01 ?o - hollow-wide-01) - number
    (cost-of-pull-right-1110b-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-push-forward-0001c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-push-forward-0001c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (cost-of-push-forward-0001c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-push-forward-1011-solid-00 ?o - solid-00) - number
    (y-of-push-forward-1011-solid-00 ?o - solid-00) - number
    (cost-of-push-forward-1011-solid-00 ?o - solid-00) - number
    (x-of-push-forward-1011-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-push-forward-1011-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (cost-of-push-forward-1011-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-push-forward-1011a-solid-00 ?o - solid-00) - number
    (y-of-push-forward-1011a-solid-00 ?o - solid-00) - number
    (cost-of-push-forward-1011a-solid-00 ?o - solid-00) - number
    (x-of-push-forward-1011c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-push-forward-1011c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (cost-of-push-forward-1011c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-push-forward-left-0001a-solid-00 ?o - solid-00) - number
    (y-of-push-forward-left-0001a-solid-00 ?o - solid-00) - number
    (cost-of-push-forward-left-0001a-solid-00 ?o - solid-00) - number
    (x-of-push-forward-left-1001-solid-00 ?o - solid-00) - number
    (y-of-push-forward-left-1001-solid-00 ?o - solid-00) - number
    (cost-of-push-forward-left-1001-solid-00 ?o - solid-00) - number
    (x-of-push-forward-left-1011b-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-push-forward-left-1011b-hollow-wide-01 ?o - hollow-wide-01) - number
    (cost-of-push-forward-left-1011b-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-push-forward-left-1111b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-push-forward-left-1111b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (cost-of-push-forward-left-1111b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-push-forward-right-0010a-solid-00 ?o - solid-00) - number
    (y-of-push-forward-right-0010a-solid-00 ?o - solid-00) - number
    (cost-of-push-forward-right-0010a-solid-00 ?o - solid-00) - number
    (x-of-push-forward-right-0010b-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-push-forward-right-0010b-hollow-wide-01 ?o - hollow-wide-01) - number
    (cost-of-push-forward-right-0010b-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-push-forward-right-0010c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-push-forward-right-0010c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (cost-of-push-forward-right-0010c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-push-forward-right-1010-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-push-forward-right-1010-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (cost-of-push-forward-right-1010-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-push-forward-right-1101-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-push-forward-right-1101-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (cost-of-push-forward-right-1101-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-push-left-0011-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-push-left-0011-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (cost-of-push-left-0011-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-push-left-0011a-solid-00 ?o - solid-00) - number
    (y-of-push-left-0011a-solid-00 ?o - solid-00) - number
    (cost-of-push-left-0011a-solid-00 ?o - solid-00) - number
    (x-of-push-left-0011b-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-push-left-0011b-hollow-wide-01 ?o - hollow-wide-01) - number
    (cost-of-push-left-0011b-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-push-left-0011c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-push-left-0011c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (cost-of-push-left-0011c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-push-left-1110a-solid-00 ?o - solid-00) - number
    (y-of-push-left-1110a-solid-00 ?o - solid-00) - number
    (cost-of-push-left-1110a-solid-00 ?o - solid-00) - number
    (x-of-push-left-1111-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-push-left-1111-hollow-wide-01 ?o - hollow-wide-01) - number
    (cost-of-push-left-1111-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-push-left-1111-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-push-left-1111-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (cost-of-push-left-1111-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-push-right-0000-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-push-right-0000-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (cost-of-push-right-0000-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-push-right-0000c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-push-right-0000c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (cost-of-push-right-0000c-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-push-right-0010d-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-push-right-0010d-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (cost-of-push-right-0010d-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-push-right-0100b-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-push-right-0100b-hollow-wide-01 ?o - hollow-wide-01) - number
    (cost-of-push-right-0100b-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-push-right-0110b-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-push-right-0110b-hollow-wide-01 ?o - hollow-wide-01) - number
    (cost-of-push-right-0110b-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-push-right-1000-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-push-right-1000-hollow-wide-01 ?o - hollow-wide-01) - number
    (cost-of-push-right-1000-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-push-right-1000-solid-00 ?o - solid-00) - number
    (y-of-push-right-1000-solid-00 ?o - solid-00) - number
    (cost-of-push-right-1000-solid-00 ?o - solid-00) - number
    (x-of-push-right-1010-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-push-right-1010-hollow-wide-01 ?o - hollow-wide-01) - number
    (cost-of-push-right-1010-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-push-right-1010b-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-push-right-1010b-hollow-wide-01 ?o - hollow-wide-01) - number
    (cost-of-push-right-1010b-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-push-right-1100-solid-00 ?o - solid-00) - number
    (y-of-push-right-1100-solid-00 ?o - solid-00) - number
    (cost-of-push-right-1100-solid-00 ?o - solid-00) - number
    (x-of-push-right-1100a-hollow-wide-01 ?o - hollow-wide-01) - number
    (y-of-push-right-1100a-hollow-wide-01 ?o - hollow-wide-01) - number
    (cost-of-push-right-1100a-hollow-wide-01 ?o - hollow-wide-01) - number
    (x-of-push-right-1110-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-push-right-1110-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (cost-of-push-right-1110-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (x-of-push-right-1110-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (y-of-push-right-1110-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (cost-of-push-right-1110-solid-low-narrow-11 ?o - solid-low-narrow-11) - number
    (x-of-stay-1101b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (y-of-stay-1101b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number
    (cost-of-stay-1101b-any-tall-narrow-10 ?o - any-tall-narrow-10) - number)

  ; Primitive 0000 on category 10 (any-tall-narrow-10); ends held in 17 of 30 rehearsals (57%).
  ; Effect (-10.7, -51.3, 263.6) mm, spread (9.4, 24.2, 15.2) mm; 16 of 30 rehearsals as promised: cost 64.
  ; Action parameters: 0.0137 0.0211 -0.0050 0.7150 0.0201 -0.0295 -0.0140 0.9301 0.0042 -0.0315 0.0415
  ; 0.3624
  ; It turned the object by over 15 degrees in 6 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-0000-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (hand-empty) (can-lift-0000-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-lift-0000-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0000-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0000-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0000-any-tall-narrow-10 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0000-any-tall-narrow-10 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0000-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0000-any-tall-narrow-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0000-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0000-any-tall-narrow-10 ?o))))

  ; Put down what lift-0000-any-tall-narrow-10 lifted.
  (:action put-down-lift-0000-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (held-by-lift-0000-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0000-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0000-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0000-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0000-any-tall-narrow-10 ?o)) 15994))
    :effect (and (not (held-by-lift-0000-any-tall-narrow-10 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0000-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0000-any-tall-narrow-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0000-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0000 on category 01 (hollow-wide-01); ends held in 29 of 35 rehearsals (83%).
  ; Effect (0.7, -101.7, 257.3) mm, spread (8, 20.2, 18) mm; 27 of 35 rehearsals as promised: cost 29.
  ; Action parameters: 0.0137 0.0211 -0.0050 0.7150 0.0201 -0.0295 -0.0140 0.9301 0.0042 -0.0315 0.0415
  ; 0.3624
  ; It turned the object by over 15 degrees in 10 of 35 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-0000-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (hand-empty) (can-lift-0000-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-lift-0000-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0000-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0000-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0000-hollow-wide-01 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0000-hollow-wide-01 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0000-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0000-hollow-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0000-hollow-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0000-hollow-wide-01 ?o))))

  ; Put down what lift-0000-hollow-wide-01 lifted.
  (:action put-down-lift-0000-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (held-by-lift-0000-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0000-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0000-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0000-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0000-hollow-wide-01 ?o)) 15994))
    :effect (and (not (held-by-lift-0000-hollow-wide-01 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0000-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0000-hollow-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0000-hollow-wide-01 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0000 on category 01 (hollow-wide-01); ends held in 35 of 35 rehearsals (100%).
  ; Effect (-32.4, -56, 230) mm, spread (6.4, 10.1, 8.7) mm; 35 of 35 rehearsals as promised: cost 4.
  ; Action parameters: -0.0074 0.0372 -0.0095 0.7199 0.0316 0.0153 0.0112 0.2485 -0.0298 0.0169 0.0262
  ; 0.2191
  ; What it promises for an object stands in the problem.
  (:action lift-0000b-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (hand-empty) (can-lift-0000b-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-lift-0000b-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0000b-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0000b-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0000b-hollow-wide-01 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0000b-hollow-wide-01 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0000b-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0000b-hollow-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0000b-hollow-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0000b-hollow-wide-01 ?o))))

  ; Put down what lift-0000b-hollow-wide-01 lifted.
  (:action put-down-lift-0000b-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (held-by-lift-0000b-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0000b-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0000b-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0000b-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0000b-hollow-wide-01 ?o)) 15994))
    :effect (and (not (held-by-lift-0000b-hollow-wide-01 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0000b-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0000b-hollow-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0000b-hollow-wide-01 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0000 on category 10 (any-tall-narrow-10); ends held in 27 of 30 rehearsals (90%).
  ; Effect (-11.6, -33.5, 230.4) mm, spread (2.2, 0.5, 3.6) mm; 27 of 30 rehearsals as promised: cost 14.
  ; Action parameters: 0.0056 0.0119 -0.0043 0.6260 -0.0376 -0.0077 -0.0113 0.3341 -0.0101 -0.0319 0.0213
  ; 0.3102
  ; What it promises for an object stands in the problem.
  (:action lift-0000c-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (hand-empty) (can-lift-0000c-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-lift-0000c-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0000c-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0000c-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0000c-any-tall-narrow-10 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0000c-any-tall-narrow-10 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0000c-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0000c-any-tall-narrow-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0000c-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0000c-any-tall-narrow-10 ?o))))

  ; Put down what lift-0000c-any-tall-narrow-10 lifted.
  (:action put-down-lift-0000c-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (held-by-lift-0000c-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0000c-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0000c-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0000c-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0000c-any-tall-narrow-10 ?o)) 15994))
    :effect (and (not (held-by-lift-0000c-any-tall-narrow-10 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0000c-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0000c-any-tall-narrow-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0000c-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0000 on category 11 (solid-low-narrow-11); ends held in 30 of 30 rehearsals (100%).
  ; Effect (-31, -36.8, 250.7) mm, spread (1.7, 0.9, 2.9) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0139 0.0245 0.0031 0.6568 0.0319 -0.0325 -0.0060 0.1752 -0.0430 -0.0339 0.0479
  ; 0.1014
  ; What it promises for an object stands in the problem.
  (:action lift-0000d-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (hand-empty) (can-lift-0000d-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-0000d-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0000d-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0000d-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0000d-solid-low-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0000d-solid-low-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0000d-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0000d-solid-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0000d-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0000d-solid-low-narrow-11 ?o))))

  ; Put down what lift-0000d-solid-low-narrow-11 lifted.
  (:action put-down-lift-0000d-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (held-by-lift-0000d-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0000d-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0000d-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0000d-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0000d-solid-low-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-0000d-solid-low-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0000d-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0000d-solid-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0000d-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0001 on category 01 (hollow-wide-01); ends held in 33 of 35 rehearsals (94%).
  ; Effect (-18.5, 17, 197.5) mm, spread (4.2, 9.6, 1) mm; 33 of 35 rehearsals as promised: cost 9.
  ; Action parameters: 0.0085 -0.0445 0.0154 0.6199 -0.0084 -0.0026 -0.0015 0.3864 -0.0212 -0.0484 -0.0294
  ; 0.4646
  ; It turned the object by over 15 degrees in 3 of 35 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-0001b-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (hand-empty) (can-lift-0001b-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-lift-0001b-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0001b-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0001b-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0001b-hollow-wide-01 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0001b-hollow-wide-01 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0001b-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0001b-hollow-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0001b-hollow-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0001b-hollow-wide-01 ?o))))

  ; Put down what lift-0001b-hollow-wide-01 lifted.
  (:action put-down-lift-0001b-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (held-by-lift-0001b-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0001b-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0001b-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0001b-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0001b-hollow-wide-01 ?o)) 15994))
    :effect (and (not (held-by-lift-0001b-hollow-wide-01 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0001b-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0001b-hollow-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0001b-hollow-wide-01 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0001 on category 11 (solid-low-narrow-11); ends held in 30 of 30 rehearsals (100%).
  ; Effect (5.4, -50.5, 199.7) mm, spread (1, 0.9, 0.5) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0260 -0.0295 0.0239 0.6487 0.0025 0.0373 0.0020 0.5872 0.0080 -0.0500 -0.0404
  ; 0.1007
  ; What it promises for an object stands in the problem.
  (:action lift-0001d-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (hand-empty) (can-lift-0001d-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-0001d-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0001d-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0001d-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0001d-solid-low-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0001d-solid-low-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0001d-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0001d-solid-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0001d-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0001d-solid-low-narrow-11 ?o))))

  ; Put down what lift-0001d-solid-low-narrow-11 lifted.
  (:action put-down-lift-0001d-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (held-by-lift-0001d-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0001d-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0001d-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0001d-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0001d-solid-low-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-0001d-solid-low-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0001d-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0001d-solid-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0001d-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0100 on category 10 (any-tall-narrow-10); ends held in 19 of 30 rehearsals (63%).
  ; Effect (-81.7, -33.9, 200.8) mm, spread (2.6, 1.3, 1.2) mm; 19 of 30 rehearsals as promised: cost 48.
  ; Action parameters: 0.0335 0.0131 -0.0084 0.9843 -0.0420 -0.0487 -0.0016 0.2258 -0.0457 -0.0316 -0.0062
  ; 0.4332
  ; It turned the object by over 15 degrees in 5 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-0100-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (hand-empty) (can-lift-0100-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-lift-0100-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0100-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0100-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0100-any-tall-narrow-10 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0100-any-tall-narrow-10 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0100-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0100-any-tall-narrow-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0100-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0100-any-tall-narrow-10 ?o))))

  ; Put down what lift-0100-any-tall-narrow-10 lifted.
  (:action put-down-lift-0100-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (held-by-lift-0100-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0100-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0100-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0100-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0100-any-tall-narrow-10 ?o)) 15994))
    :effect (and (not (held-by-lift-0100-any-tall-narrow-10 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0100-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0100-any-tall-narrow-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0100-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0100 on category 11 (solid-low-narrow-11); ends held in 29 of 30 rehearsals (97%).
  ; Effect (-75.4, -38.5, 199.3) mm, spread (2.2, 2.5, 1.2) mm; 29 of 30 rehearsals as promised: cost 7.
  ; Action parameters: 0.0335 0.0131 -0.0084 0.9843 -0.0420 -0.0487 -0.0016 0.2258 -0.0457 -0.0316 -0.0062
  ; 0.4332
  ; It turned the object by over 15 degrees in 5 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-0100-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (hand-empty) (can-lift-0100-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-0100-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0100-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0100-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0100-solid-low-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0100-solid-low-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0100-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0100-solid-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0100-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0100-solid-low-narrow-11 ?o))))

  ; Put down what lift-0100-solid-low-narrow-11 lifted.
  (:action put-down-lift-0100-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (held-by-lift-0100-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0100-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0100-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0100-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0100-solid-low-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-0100-solid-low-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0100-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0100-solid-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0100-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0100 on category 01 (hollow-wide-01); ends held in 14 of 35 rehearsals (40%).
  ; Effect (-26.2, -53.3, 198.9) mm, spread (10.2, 42.9, 2.9) mm; 10 of 35 rehearsals as promised: cost 122.
  ; Action parameters: -0.0078 0.0113 -0.0202 0.8227 -0.0405 -0.0324 0.0191 0.3138 -0.0233 0.0125 -0.0486
  ; 0.4209
  ; It turned the object by over 15 degrees in 4 of 35 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-0100b-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (hand-empty) (can-lift-0100b-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-lift-0100b-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0100b-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0100b-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0100b-hollow-wide-01 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0100b-hollow-wide-01 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0100b-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0100b-hollow-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0100b-hollow-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0100b-hollow-wide-01 ?o))))

  ; Put down what lift-0100b-hollow-wide-01 lifted.
  (:action put-down-lift-0100b-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (held-by-lift-0100b-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0100b-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0100b-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0100b-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0100b-hollow-wide-01 ?o)) 15994))
    :effect (and (not (held-by-lift-0100b-hollow-wide-01 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0100b-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0100b-hollow-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0100b-hollow-wide-01 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0100 on category 10 (any-tall-narrow-10); ends held in 30 of 30 rehearsals (100%).
  ; Effect (-55.1, -49.4, 200.1) mm, spread (1.6, 0.8, 0.6) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0154 -0.0053 0.0007 0.6099 0.0290 -0.0174 -0.0059 0.0273 -0.0375 -0.0485 -0.0073
  ; 0.1898
  ; What it promises for an object stands in the problem.
  (:action lift-0100c-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (hand-empty) (can-lift-0100c-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-lift-0100c-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0100c-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0100c-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0100c-any-tall-narrow-10 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0100c-any-tall-narrow-10 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0100c-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0100c-any-tall-narrow-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0100c-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0100c-any-tall-narrow-10 ?o))))

  ; Put down what lift-0100c-any-tall-narrow-10 lifted.
  (:action put-down-lift-0100c-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (held-by-lift-0100c-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0100c-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0100c-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0100c-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0100c-any-tall-narrow-10 ?o)) 15994))
    :effect (and (not (held-by-lift-0100c-any-tall-narrow-10 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0100c-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0100c-any-tall-narrow-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0100c-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0100 on category 11 (solid-low-narrow-11); ends held in 30 of 30 rehearsals (100%).
  ; Effect (-58.6, 46.9, 200.8) mm, spread (0.2, 0.8, 2.6) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0118 0.0019 -0.0220 0.6993 0.0430 -0.0026 0.0175 0.4911 -0.0470 0.0497 -0.0143
  ; 0.3505
  ; What it promises for an object stands in the problem.
  (:action lift-0100d-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (hand-empty) (can-lift-0100d-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-0100d-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0100d-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0100d-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0100d-solid-low-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0100d-solid-low-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0100d-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0100d-solid-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0100d-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0100d-solid-low-narrow-11 ?o))))

  ; Put down what lift-0100d-solid-low-narrow-11 lifted.
  (:action put-down-lift-0100d-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (held-by-lift-0100d-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0100d-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0100d-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0100d-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0100d-solid-low-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-0100d-solid-low-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0100d-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0100d-solid-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0100d-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0101 on category 11 (solid-low-narrow-11); ends held in 30 of 30 rehearsals (100%).
  ; Effect (-35, 35.3, 252.5) mm, spread (0.1, 0.6, 4) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0208 -0.0263 -0.0239 0.5342 0.0096 0.0051 -0.0101 0.6098 -0.0256 0.0380 0.0488
  ; 0.1013
  ; What it promises for an object stands in the problem.
  (:action lift-0101-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (hand-empty) (can-lift-0101-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-0101-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0101-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0101-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0101-solid-low-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0101-solid-low-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0101-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0101-solid-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0101-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0101-solid-low-narrow-11 ?o))))

  ; Put down what lift-0101-solid-low-narrow-11 lifted.
  (:action put-down-lift-0101-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (held-by-lift-0101-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0101-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0101-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0101-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0101-solid-low-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-0101-solid-low-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0101-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0101-solid-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0101-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0101 on category 01 (hollow-wide-01); ends held in 35 of 35 rehearsals (100%).
  ; Effect (-24.7, 43.6, 248.4) mm, spread (1.7, 9.8, 7.7) mm; 35 of 35 rehearsals as promised: cost 4.
  ; Action parameters: -0.0018 -0.0426 -0.0197 0.7317 0.0055 -0.0045 0.0210 0.1910 -0.0236 -0.0194 0.0404
  ; 0.4820
  ; What it promises for an object stands in the problem.
  (:action lift-0101a-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (hand-empty) (can-lift-0101a-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-lift-0101a-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0101a-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0101a-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0101a-hollow-wide-01 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0101a-hollow-wide-01 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0101a-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0101a-hollow-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0101a-hollow-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0101a-hollow-wide-01 ?o))))

  ; Put down what lift-0101a-hollow-wide-01 lifted.
  (:action put-down-lift-0101a-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (held-by-lift-0101a-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0101a-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0101a-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0101a-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0101a-hollow-wide-01 ?o)) 15994))
    :effect (and (not (held-by-lift-0101a-hollow-wide-01 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0101a-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0101a-hollow-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0101a-hollow-wide-01 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0101 on category 10 (any-tall-narrow-10); ends held in 27 of 30 rehearsals (90%).
  ; Effect (-41.4, 38.2, 200.1) mm, spread (6, 7.2, 0.3) mm; 27 of 30 rehearsals as promised: cost 14.
  ; Action parameters: 0.0123 -0.0121 -0.0021 0.8612 0.0149 -0.0069 -0.0081 0.2199 -0.0313 0.0424 -0.0212
  ; 0.3369
  ; What it promises for an object stands in the problem.
  (:action lift-0101b-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (hand-empty) (can-lift-0101b-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-lift-0101b-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0101b-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0101b-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0101b-any-tall-narrow-10 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0101b-any-tall-narrow-10 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0101b-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0101b-any-tall-narrow-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0101b-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0101b-any-tall-narrow-10 ?o))))

  ; Put down what lift-0101b-any-tall-narrow-10 lifted.
  (:action put-down-lift-0101b-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (held-by-lift-0101b-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0101b-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0101b-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0101b-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0101b-any-tall-narrow-10 ?o)) 15994))
    :effect (and (not (held-by-lift-0101b-any-tall-narrow-10 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0101b-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0101b-any-tall-narrow-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0101b-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0101 on category 11 (solid-low-narrow-11); ends held in 30 of 30 rehearsals (100%).
  ; Effect (-52.8, -51.3, 202.9) mm, spread (0.4, 0.6, 2.9) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0146 -0.0265 -0.0085 0.5203 -0.0277 -0.0272 -0.0066 0.0797 -0.0382 -0.0485 -0.0010
  ; 0.4181
  ; What it promises for an object stands in the problem.
  (:action lift-0101c-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (hand-empty) (can-lift-0101c-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-0101c-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0101c-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0101c-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0101c-solid-low-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0101c-solid-low-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0101c-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0101c-solid-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0101c-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0101c-solid-low-narrow-11 ?o))))

  ; Put down what lift-0101c-solid-low-narrow-11 lifted.
  (:action put-down-lift-0101c-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (held-by-lift-0101c-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0101c-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0101c-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0101c-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0101c-solid-low-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-0101c-solid-low-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0101c-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0101c-solid-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0101c-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1000 on category 01 (hollow-wide-01); ends held in 31 of 35 rehearsals (89%).
  ; Effect (46.3, -40.5, 198.1) mm, spread (13.7, 8.5, 5.6) mm; 30 of 35 rehearsals as promised: cost 19.
  ; Action parameters: 0.0053 0.0259 -0.0141 0.6662 -0.0193 0.0156 -0.0049 0.5264 0.0491 0.0354 -0.0258
  ; 0.2445
  ; It turned the object by over 15 degrees in 12 of 35 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-1000-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (hand-empty) (can-lift-1000-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-lift-1000-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1000-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1000-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1000-hollow-wide-01 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1000-hollow-wide-01 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1000-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1000-hollow-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1000-hollow-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1000-hollow-wide-01 ?o))))

  ; Put down what lift-1000-hollow-wide-01 lifted.
  (:action put-down-lift-1000-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (held-by-lift-1000-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1000-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1000-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1000-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1000-hollow-wide-01 ?o)) 15994))
    :effect (and (not (held-by-lift-1000-hollow-wide-01 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1000-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1000-hollow-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1000-hollow-wide-01 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1000 on category 11 (solid-low-narrow-11); ends held in 30 of 30 rehearsals (100%).
  ; Effect (65.7, 30.8, 200) mm, spread (4.4, 1.5, 0.8) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0053 0.0259 -0.0141 0.6662 -0.0193 0.0156 -0.0049 0.5264 0.0491 0.0354 -0.0258
  ; 0.2445
  ; What it promises for an object stands in the problem.
  (:action lift-1000-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (hand-empty) (can-lift-1000-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-1000-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1000-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1000-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1000-solid-low-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1000-solid-low-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1000-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1000-solid-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1000-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1000-solid-low-narrow-11 ?o))))

  ; Put down what lift-1000-solid-low-narrow-11 lifted.
  (:action put-down-lift-1000-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (held-by-lift-1000-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1000-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1000-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1000-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1000-solid-low-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-1000-solid-low-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1000-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1000-solid-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1000-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1000 on category 01 (hollow-wide-01); ends held in 35 of 35 rehearsals (100%).
  ; Effect (49.5, -114.5, 215.8) mm, spread (2.9, 10.3, 7.8) mm; 35 of 35 rehearsals as promised: cost 4.
  ; Action parameters: -0.0020 0.0432 -0.0228 0.5912 0.0099 -0.0218 -0.0073 0.7134 0.0497 -0.0410 0.0122
  ; 0.4443
  ; What it promises for an object stands in the problem.
  (:action lift-1000a-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (hand-empty) (can-lift-1000a-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-lift-1000a-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1000a-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1000a-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1000a-hollow-wide-01 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1000a-hollow-wide-01 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1000a-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1000a-hollow-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1000a-hollow-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1000a-hollow-wide-01 ?o))))

  ; Put down what lift-1000a-hollow-wide-01 lifted.
  (:action put-down-lift-1000a-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (held-by-lift-1000a-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1000a-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1000a-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1000a-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1000a-hollow-wide-01 ?o)) 15994))
    :effect (and (not (held-by-lift-1000a-hollow-wide-01 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1000a-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1000a-hollow-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1000a-hollow-wide-01 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1000 on category 10 (any-tall-narrow-10); ends held in 30 of 30 rehearsals (100%).
  ; Effect (33.3, -47, 200.3) mm, spread (7.3, 0.7, 0.5) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0047 0.0026 0.0019 0.9417 -0.0456 -0.0104 -0.0017 0.2352 0.0338 -0.0462 -0.0463
  ; 0.1195
  ; What it promises for an object stands in the problem.
  (:action lift-1000b-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (hand-empty) (can-lift-1000b-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-lift-1000b-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1000b-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1000b-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1000b-any-tall-narrow-10 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1000b-any-tall-narrow-10 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1000b-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1000b-any-tall-narrow-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1000b-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1000b-any-tall-narrow-10 ?o))))

  ; Put down what lift-1000b-any-tall-narrow-10 lifted.
  (:action put-down-lift-1000b-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (held-by-lift-1000b-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1000b-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1000b-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1000b-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1000b-any-tall-narrow-10 ?o)) 15994))
    :effect (and (not (held-by-lift-1000b-any-tall-narrow-10 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1000b-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1000b-any-tall-narrow-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1000b-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1001 on category 11 (solid-low-narrow-11); ends held in 30 of 30 rehearsals (100%).
  ; Effect (65.5, -14.6, 245.6) mm, spread (1, 1, 7.2) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0210 -0.0275 0.0100 0.5873 -0.0147 0.0412 -0.0211 0.8410 0.0500 -0.0100 0.0399
  ; 0.3111
  ; What it promises for an object stands in the problem.
  (:action lift-1001-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (hand-empty) (can-lift-1001-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-1001-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1001-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1001-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1001-solid-low-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1001-solid-low-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1001-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1001-solid-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1001-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1001-solid-low-narrow-11 ?o))))

  ; Put down what lift-1001-solid-low-narrow-11 lifted.
  (:action put-down-lift-1001-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (held-by-lift-1001-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1001-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1001-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1001-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1001-solid-low-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-1001-solid-low-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1001-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1001-solid-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1001-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1001 on category 01 (hollow-wide-01); ends held in 35 of 35 rehearsals (100%).
  ; Effect (46.2, 60.1, 247.2) mm, spread (5.2, 9.9, 9) mm; 35 of 35 rehearsals as promised: cost 4.
  ; Action parameters: -0.0131 -0.0458 0.0099 0.5787 -0.0028 0.0391 -0.0211 0.8419 0.0481 -0.0032 0.0395
  ; 0.2975
  ; It turned the object by over 15 degrees in 8 of 35 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-1001a-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (hand-empty) (can-lift-1001a-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-lift-1001a-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1001a-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1001a-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1001a-hollow-wide-01 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1001a-hollow-wide-01 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1001a-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1001a-hollow-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1001a-hollow-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1001a-hollow-wide-01 ?o))))

  ; Put down what lift-1001a-hollow-wide-01 lifted.
  (:action put-down-lift-1001a-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (held-by-lift-1001a-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1001a-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1001a-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1001a-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1001a-hollow-wide-01 ?o)) 15994))
    :effect (and (not (held-by-lift-1001a-hollow-wide-01 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1001a-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1001a-hollow-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1001a-hollow-wide-01 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1001 on category 10 (any-tall-narrow-10); ends held in 30 of 30 rehearsals (100%).
  ; Effect (61.2, 24.4, 207.6) mm, spread (2.4, 1, 3.6) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0059 0.0102 0.0075 0.9945 -0.0382 0.0466 -0.0059 0.2431 0.0494 0.0264 0.0044
  ; 0.0458
  ; What it promises for an object stands in the problem.
  (:action lift-1001b-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (hand-empty) (can-lift-1001b-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-lift-1001b-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1001b-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1001b-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1001b-any-tall-narrow-10 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1001b-any-tall-narrow-10 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1001b-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1001b-any-tall-narrow-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1001b-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1001b-any-tall-narrow-10 ?o))))

  ; Put down what lift-1001b-any-tall-narrow-10 lifted.
  (:action put-down-lift-1001b-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (held-by-lift-1001b-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1001b-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1001b-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1001b-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1001b-any-tall-narrow-10 ?o)) 15994))
    :effect (and (not (held-by-lift-1001b-any-tall-narrow-10 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1001b-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1001b-any-tall-narrow-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1001b-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1001 on category 11 (solid-low-narrow-11); ends held in 30 of 30 rehearsals (100%).
  ; Effect (48.5, -52.3, 240.5) mm, spread (0.9, 0.9, 1) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0182 -0.0092 -0.0003 0.7236 0.0446 0.0188 0.0155 0.0234 0.0303 -0.0486 0.0398
  ; 0.2726
  ; What it promises for an object stands in the problem.
  (:action lift-1001c-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (hand-empty) (can-lift-1001c-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-1001c-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1001c-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1001c-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1001c-solid-low-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1001c-solid-low-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1001c-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1001c-solid-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1001c-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1001c-solid-low-narrow-11 ?o))))

  ; Put down what lift-1001c-solid-low-narrow-11 lifted.
  (:action put-down-lift-1001c-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (held-by-lift-1001c-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1001c-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1001c-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1001c-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1001c-solid-low-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-1001c-solid-low-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1001c-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1001c-solid-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1001c-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1100 on category 10 (any-tall-narrow-10); ends held in 30 of 30 rehearsals (100%).
  ; Effect (-26.1, 23.4, 201.5) mm, spread (1, 1.3, 1.6) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0096 0.0080 -0.0139 0.7774 -0.0226 -0.0427 -0.0209 0.3157 -0.0369 0.0254 -0.0163
  ; 0.1462
  ; What it promises for an object stands in the problem.
  (:action lift-1100-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (hand-empty) (can-lift-1100-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-lift-1100-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1100-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1100-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1100-any-tall-narrow-10 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1100-any-tall-narrow-10 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1100-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1100-any-tall-narrow-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1100-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1100-any-tall-narrow-10 ?o))))

  ; Put down what lift-1100-any-tall-narrow-10 lifted.
  (:action put-down-lift-1100-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (held-by-lift-1100-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1100-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1100-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1100-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1100-any-tall-narrow-10 ?o)) 15994))
    :effect (and (not (held-by-lift-1100-any-tall-narrow-10 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1100-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1100-any-tall-narrow-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1100-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1100 on category 00 (solid-00); ends held in 8 of 32 rehearsals (25%).
  ; Effect (-26.1, 23.8, 201.7) mm, spread (0.4, 0.5, 1.3) mm; 8 of 32 rehearsals as promised: cost 134.
  ; Action parameters: -0.0096 0.0080 -0.0139 0.7774 -0.0226 -0.0427 -0.0209 0.3157 -0.0369 0.0254 -0.0163
  ; 0.1462
  ; What it promises for an object stands in the problem.
  (:action lift-1100-solid-00
    :parameters (?o - solid-00)
    :precondition (and (hand-empty) (can-lift-1100-solid-00 ?o) (>= (+ (x ?o) (x-of-lift-1100-solid-00 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1100-solid-00 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1100-solid-00 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1100-solid-00 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1100-solid-00 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1100-solid-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1100-solid-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1100-solid-00 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1100-solid-00 ?o))))

  ; Put down what lift-1100-solid-00 lifted.
  (:action put-down-lift-1100-solid-00
    :parameters (?o - solid-00)
    :precondition (and (held-by-lift-1100-solid-00 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1100-solid-00 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1100-solid-00 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1100-solid-00 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1100-solid-00 ?o)) 15994))
    :effect (and (not (held-by-lift-1100-solid-00 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1100-solid-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1100-solid-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1100-solid-00 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1100 on category 11 (solid-low-narrow-11); ends held in 30 of 30 rehearsals (100%).
  ; Effect (-26.7, 21.8, 200.7) mm, spread (1.1, 1.9, 1.5) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0096 0.0080 -0.0139 0.7774 -0.0226 -0.0427 -0.0209 0.3157 -0.0369 0.0254 -0.0163
  ; 0.1462
  ; What it promises for an object stands in the problem.
  (:action lift-1100-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (hand-empty) (can-lift-1100-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-1100-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1100-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1100-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1100-solid-low-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1100-solid-low-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1100-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1100-solid-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1100-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1100-solid-low-narrow-11 ?o))))

  ; Put down what lift-1100-solid-low-narrow-11 lifted.
  (:action put-down-lift-1100-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (held-by-lift-1100-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1100-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1100-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1100-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1100-solid-low-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-1100-solid-low-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1100-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1100-solid-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1100-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1100 on category 01 (hollow-wide-01); ends held in 14 of 35 rehearsals (40%).
  ; Effect (-6.2, -32.5, 202) mm, spread (11.8, 33, 2.9) mm; 10 of 35 rehearsals as promised: cost 122.
  ; Action parameters: 0.0010 0.0111 -0.0226 0.9310 -0.0425 0.0251 -0.0188 0.0663 -0.0122 0.0203 -0.0123
  ; 0.2912
  ; What it promises for an object stands in the problem.
  (:action lift-1100a-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (hand-empty) (can-lift-1100a-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-lift-1100a-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1100a-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1100a-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1100a-hollow-wide-01 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1100a-hollow-wide-01 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1100a-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1100a-hollow-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1100a-hollow-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1100a-hollow-wide-01 ?o))))

  ; Put down what lift-1100a-hollow-wide-01 lifted.
  (:action put-down-lift-1100a-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (held-by-lift-1100a-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1100a-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1100a-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1100a-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1100a-hollow-wide-01 ?o)) 15994))
    :effect (and (not (held-by-lift-1100a-hollow-wide-01 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1100a-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1100a-hollow-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1100a-hollow-wide-01 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1100 on category 10 (any-tall-narrow-10); ends held in 30 of 30 rehearsals (100%).
  ; Effect (12.2, 46.9, 226.4) mm, spread (0.3, 0.5, 7.8) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0019 -0.0009 -0.0231 0.9818 0.0115 -0.0273 0.0229 0.4123 0.0137 0.0480 0.0139
  ; 0.2696
  ; What it promises for an object stands in the problem.
  (:action lift-1100b-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (hand-empty) (can-lift-1100b-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-lift-1100b-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1100b-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1100b-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1100b-any-tall-narrow-10 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1100b-any-tall-narrow-10 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1100b-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1100b-any-tall-narrow-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1100b-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1100b-any-tall-narrow-10 ?o))))

  ; Put down what lift-1100b-any-tall-narrow-10 lifted.
  (:action put-down-lift-1100b-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (held-by-lift-1100b-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1100b-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1100b-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1100b-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1100b-any-tall-narrow-10 ?o)) 15994))
    :effect (and (not (held-by-lift-1100b-any-tall-narrow-10 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1100b-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1100b-any-tall-narrow-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1100b-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1100 on category 11 (solid-low-narrow-11); ends held in 30 of 30 rehearsals (100%).
  ; Effect (-6.6, 29.9, 241.3) mm, spread (0.6, 0.7, 6.2) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0426 0.0233 -0.0236 0.5246 -0.0071 0.0146 -0.0186 0.8117 -0.0141 0.0325 0.0359
  ; 0.1828
  ; What it promises for an object stands in the problem.
  (:action lift-1100c-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (hand-empty) (can-lift-1100c-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-1100c-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1100c-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1100c-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1100c-solid-low-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1100c-solid-low-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1100c-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1100c-solid-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1100c-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1100c-solid-low-narrow-11 ?o))))

  ; Put down what lift-1100c-solid-low-narrow-11 lifted.
  (:action put-down-lift-1100c-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (held-by-lift-1100c-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1100c-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1100c-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1100c-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1100c-solid-low-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-1100c-solid-low-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1100c-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1100c-solid-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1100c-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1101 on category 11 (solid-low-narrow-11); ends held in 27 of 30 rehearsals (90%).
  ; Effect (39.9, 19.1, 248.8) mm, spread (1.3, 1.7, 6.6) mm; 27 of 30 rehearsals as promised: cost 14.
  ; Action parameters: 0.0239 -0.0319 0.0024 0.8310 -0.0384 -0.0241 -0.0197 0.9166 0.0004 0.0230 0.0436
  ; 0.3088
  ; What it promises for an object stands in the problem.
  (:action lift-1101-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (hand-empty) (can-lift-1101-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-1101-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1101-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1101-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1101-solid-low-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1101-solid-low-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1101-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1101-solid-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1101-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1101-solid-low-narrow-11 ?o))))

  ; Put down what lift-1101-solid-low-narrow-11 lifted.
  (:action put-down-lift-1101-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (held-by-lift-1101-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1101-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1101-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1101-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1101-solid-low-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-1101-solid-low-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1101-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1101-solid-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1101-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1101 on category 01 (hollow-wide-01); ends held in 35 of 35 rehearsals (100%).
  ; Effect (40, 43.1, 198.1) mm, spread (3.2, 9.7, 2.3) mm; 35 of 35 rehearsals as promised: cost 4.
  ; Action parameters: 0.0032 -0.0424 -0.0104 0.9633 0.0083 0.0426 -0.0248 0.7965 0.0415 -0.0202 -0.0322
  ; 0.0066
  ; What it promises for an object stands in the problem.
  (:action lift-1101a-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (hand-empty) (can-lift-1101a-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-lift-1101a-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1101a-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1101a-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1101a-hollow-wide-01 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1101a-hollow-wide-01 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1101a-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1101a-hollow-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1101a-hollow-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1101a-hollow-wide-01 ?o))))

  ; Put down what lift-1101a-hollow-wide-01 lifted.
  (:action put-down-lift-1101a-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (held-by-lift-1101a-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1101a-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1101a-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1101a-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1101a-hollow-wide-01 ?o)) 15994))
    :effect (and (not (held-by-lift-1101a-hollow-wide-01 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1101a-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1101a-hollow-wide-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1101a-hollow-wide-01 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1101 on category 10 (any-tall-narrow-10); ends held in 23 of 30 rehearsals (77%).
  ; Effect (13.2, 3.2, 200) mm, spread (3.2, 0.8, 0.5) mm; 23 of 30 rehearsals as promised: cost 30.
  ; Action parameters: 0.0457 -0.0203 -0.0048 0.9672 0.0094 0.0080 -0.0132 0.8279 0.0235 0.0049 -0.0176
  ; 0.0967
  ; It turned the object by over 15 degrees in 1 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-1101b-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (hand-empty) (can-lift-1101b-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-lift-1101b-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1101b-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1101b-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1101b-any-tall-narrow-10 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1101b-any-tall-narrow-10 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1101b-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1101b-any-tall-narrow-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1101b-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1101b-any-tall-narrow-10 ?o))))

  ; Put down what lift-1101b-any-tall-narrow-10 lifted.
  (:action put-down-lift-1101b-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (held-by-lift-1101b-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1101b-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1101b-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1101b-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1101b-any-tall-narrow-10 ?o)) 15994))
    :effect (and (not (held-by-lift-1101b-any-tall-narrow-10 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1101b-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1101b-any-tall-narrow-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1101b-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1101 on category 11 (solid-low-narrow-11); ends held in 30 of 30 rehearsals (100%).
  ; Effect (9.8, -2.8, 199.9) mm, spread (3.2, 1, 0.4) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0076 -0.0219 -0.0067 0.5440 0.0361 0.0425 -0.0004 0.3910 0.0160 -0.0002 -0.0457
  ; 0.0062
  ; What it promises for an object stands in the problem.
  (:action lift-1101c-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (hand-empty) (can-lift-1101c-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-1101c-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1101c-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1101c-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1101c-solid-low-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1101c-solid-low-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1101c-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1101c-solid-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1101c-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1101c-solid-low-narrow-11 ?o))))

  ; Put down what lift-1101c-solid-low-narrow-11 lifted.
  (:action put-down-lift-1101c-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (held-by-lift-1101c-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1101c-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1101c-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1101c-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1101c-solid-low-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-1101c-solid-low-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1101c-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1101c-solid-low-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1101c-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1010 on category 10 (any-tall-narrow-10); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (54.8, -0.3, 0) mm, spread (3.5, 5.1, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0198 0.0081 -0.0162 0.5200 0.0363 0.0043 0.0144 0.1968 -0.0458 -0.0450 -0.0341
  ; 0.6377
  ; What it promises for an object stands in the problem.
  (:action place-forward-1010c-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (hand-empty) (can-place-forward-1010c-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-place-forward-1010c-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-place-forward-1010c-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-place-forward-1010c-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-place-forward-1010c-any-tall-narrow-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-place-forward-1010c-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-place-forward-1010c-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-place-forward-1010c-any-tall-narrow-10 ?o))))

  ; Primitive 1010 on category 11 (solid-low-narrow-11); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (58, -42.5, 0) mm, spread (0.9, 0.9, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0199 0.0277 -0.0218 0.9981 0.0369 -0.0395 0.0148 0.4144 -0.0078 -0.0338 0.0135
  ; 0.8040
  ; What it promises for an object stands in the problem.
  (:action place-forward-right-1010-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (hand-empty) (can-place-forward-right-1010-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-place-forward-right-1010-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-place-forward-right-1010-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-place-forward-right-1010-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-place-forward-right-1010-solid-low-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-place-forward-right-1010-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-place-forward-right-1010-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-place-forward-right-1010-solid-low-narrow-11 ?o))))

  ; Primitive 0000 on category 01 (hollow-wide-01); ends at rest in 6 of 35 rehearsals (17%).
  ; Effect (1.7, -56.1, 0) mm, spread (6.6, 16.7, 0) mm; 6 of 35 rehearsals as promised: cost 168.
  ; Action parameters: 0.0137 0.0211 -0.0050 0.7150 0.0201 -0.0295 -0.0140 0.9301 0.0042 -0.0315 0.0415
  ; 0.3624
  ; It turned the object by over 15 degrees in 10 of 35 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action place-right-0000-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (hand-empty) (can-place-right-0000-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-place-right-0000-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-place-right-0000-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-place-right-0000-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-place-right-0000-hollow-wide-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-place-right-0000-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-place-right-0000-hollow-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-place-right-0000-hollow-wide-01 ?o))))

  ; Primitive 0100 on category 10 (any-tall-narrow-10); ends at rest in 10 of 30 rehearsals (33%).
  ; Effect (-52.7, -8.1, 0) mm, spread (21.3, 31.9, 0) mm; 9 of 30 rehearsals as promised: cost 117.
  ; Action parameters: 0.0335 0.0131 -0.0084 0.9843 -0.0420 -0.0487 -0.0016 0.2258 -0.0457 -0.0316 -0.0062
  ; 0.4332
  ; It turned the object by over 15 degrees in 5 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action pull-0100-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (hand-empty) (can-pull-0100-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-pull-0100-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-0100-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-0100-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-0100-any-tall-narrow-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-0100-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-0100-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-pull-0100-any-tall-narrow-10 ?o))))

  ; Primitive 0100 on category 00 (solid-00); ends at rest in 32 of 32 rehearsals (100%).
  ; Effect (-80.6, -29.1, 0) mm, spread (16.3, 15.9, 0) mm; 29 of 32 rehearsals as promised: cost 14.
  ; Action parameters: 0.0500 0.0500 0.0072 0.5061 -0.0500 -0.0500 0.0079 0.0000 -0.0396 -0.0251 0.0329
  ; 0.2288
  ; What it promises for an object stands in the problem.
  (:action pull-0100a-solid-00
    :parameters (?o - solid-00)
    :precondition (and (hand-empty) (can-pull-0100a-solid-00 ?o) (>= (+ (x ?o) (x-of-pull-0100a-solid-00 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-0100a-solid-00 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-0100a-solid-00 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-0100a-solid-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-0100a-solid-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-0100a-solid-00 ?o)) 10000)) (increase (total-cost) (cost-of-pull-0100a-solid-00 ?o))))

  ; Primitive 0110 on category 11 (solid-low-narrow-11); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (-42.7, -5.1, 0) mm, spread (0.1, 0.3, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0040 0.0162 0.0033 0.9878 -0.0471 -0.0037 0.0209 0.3053 -0.0398 0.0144 0.0108
  ; 0.9263
  ; What it promises for an object stands in the problem.
  (:action pull-0110-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (hand-empty) (can-pull-0110-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-pull-0110-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-0110-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-0110-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-0110-solid-low-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-0110-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-0110-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-pull-0110-solid-low-narrow-11 ?o))))

  ; Primitive 0110 on category 00 (solid-00); ends at rest in 32 of 32 rehearsals (100%).
  ; Effect (-23.3, -4.9, 0) mm, spread (17.9, 8.2, 0) mm; 32 of 32 rehearsals as promised: cost 4.
  ; Action parameters: 0.0318 0.0184 0.0202 0.9013 0.0381 0.0283 -0.0195 0.3824 -0.0444 -0.0105 -0.0082
  ; 0.9149
  ; It turned the object by over 15 degrees in 8 of 32 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action pull-0110a-solid-00
    :parameters (?o - solid-00)
    :precondition (and (hand-empty) (can-pull-0110a-solid-00 ?o) (>= (+ (x ?o) (x-of-pull-0110a-solid-00 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-0110a-solid-00 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-0110a-solid-00 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-0110a-solid-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-0110a-solid-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-0110a-solid-00 ?o)) 10000)) (increase (total-cost) (cost-of-pull-0110a-solid-00 ?o))))

  ; Primitive 0111 on category 01 (hollow-wide-01); ends at rest in 35 of 35 rehearsals (100%).
  ; Effect (-89.3, 17.3, 0) mm, spread (45.8, 17.4, 0) mm; 26 of 35 rehearsals as promised: cost 33.
  ; Action parameters: 0.0500 0.0003 -0.0114 0.6465 -0.0500 0.0450 0.0046 0.1134 -0.0130 0.0129 -0.0135
  ; 0.6990
  ; It turned the object by over 15 degrees in 8 of 35 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action pull-0111-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (hand-empty) (can-pull-0111-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-pull-0111-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-0111-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-0111-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-0111-hollow-wide-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-0111-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-0111-hollow-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-pull-0111-hollow-wide-01 ?o))))

  ; Primitive 0111 on category 11 (solid-low-narrow-11); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (-99.1, 39.4, 0) mm, spread (3, 14.3, 0) mm; 29 of 30 rehearsals as promised: cost 7.
  ; Action parameters: 0.0500 0.0003 -0.0114 0.6465 -0.0500 0.0450 0.0046 0.1134 -0.0130 0.0129 -0.0135
  ; 0.6990
  ; What it promises for an object stands in the problem.
  (:action pull-0111-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (hand-empty) (can-pull-0111-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-pull-0111-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-0111-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-0111-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-0111-solid-low-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-0111-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-0111-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-pull-0111-solid-low-narrow-11 ?o))))

  ; Primitive 0111 on category 00 (solid-00); ends at rest in 32 of 32 rehearsals (100%).
  ; Effect (-60.2, 9.8, 0) mm, spread (17.4, 13.3, 0) mm; 32 of 32 rehearsals as promised: cost 4.
  ; Action parameters: 0.0469 0.0006 -0.0015 0.7962 -0.0007 -0.0328 -0.0107 0.0620 -0.0364 0.0254 0.0209
  ; 0.8375
  ; What it promises for an object stands in the problem.
  (:action pull-0111a-solid-00
    :parameters (?o - solid-00)
    :precondition (and (hand-empty) (can-pull-0111a-solid-00 ?o) (>= (+ (x ?o) (x-of-pull-0111a-solid-00 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-0111a-solid-00 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-0111a-solid-00 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-0111a-solid-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-0111a-solid-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-0111a-solid-00 ?o)) 10000)) (increase (total-cost) (cost-of-pull-0111a-solid-00 ?o))))

  ; Primitive 0111 on category 10 (any-tall-narrow-10); ends at rest in 28 of 30 rehearsals (93%).
  ; Effect (-79.4, 27.3, 0) mm, spread (3.4, 14, 0) mm; 28 of 30 rehearsals as promised: cost 11.
  ; Action parameters: 0.0373 0.0046 -0.0219 0.9015 -0.0410 0.0297 -0.0012 0.3337 0.0011 0.0438 0.0254
  ; 0.9160
  ; It turned the object by over 15 degrees in 2 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action pull-0111c-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (hand-empty) (can-pull-0111c-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-pull-0111c-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-0111c-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-0111c-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-0111c-any-tall-narrow-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-0111c-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-0111c-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-pull-0111c-any-tall-narrow-10 ?o))))

  ; Primitive 0101 on category 00 (solid-00); ends at rest in 32 of 32 rehearsals (100%).
  ; Effect (-10.6, 20, 0) mm, spread (11.3, 29.8, 0) mm; 31 of 32 rehearsals as promised: cost 7.
  ; Action parameters: 0.0208 -0.0263 -0.0239 0.5342 0.0096 0.0051 -0.0101 0.6098 -0.0256 0.0380 0.0488
  ; 0.1013
  ; What it promises for an object stands in the problem.
  (:action pull-left-0101-solid-00
    :parameters (?o - solid-00)
    :precondition (and (hand-empty) (can-pull-left-0101-solid-00 ?o) (>= (+ (x ?o) (x-of-pull-left-0101-solid-00 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-left-0101-solid-00 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-left-0101-solid-00 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-left-0101-solid-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-left-0101-solid-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-left-0101-solid-00 ?o)) 10000)) (increase (total-cost) (cost-of-pull-left-0101-solid-00 ?o))))

  ; Primitive 0101 on category 10 (any-tall-narrow-10); ends at rest in 3 of 30 rehearsals (10%).
  ; Effect (-12.4, 9.8, 0) mm, spread (4.1, 5.5, 0) mm; 3 of 30 rehearsals as promised: cost 209.
  ; Action parameters: 0.0123 -0.0121 -0.0021 0.8612 0.0149 -0.0069 -0.0081 0.2199 -0.0313 0.0424 -0.0212
  ; 0.3369
  ; What it promises for an object stands in the problem.
  (:action pull-left-0101b-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (hand-empty) (can-pull-left-0101b-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-pull-left-0101b-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-left-0101b-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-left-0101b-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-left-0101b-any-tall-narrow-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-left-0101b-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-left-0101b-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-pull-left-0101b-any-tall-narrow-10 ?o))))

  ; Primitive 0111 on category 01 (hollow-wide-01); ends at rest in 35 of 35 rehearsals (100%).
  ; Effect (-47.6, 67.9, 0) mm, spread (6.7, 9.3, 0) mm; 35 of 35 rehearsals as promised: cost 4.
  ; Action parameters: 0.0083 -0.0446 -0.0055 0.9173 -0.0500 0.0008 0.0012 0.0119 -0.0218 0.0137 0.0228
  ; 0.6505
  ; It turned the object by over 15 degrees in 1 of 35 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action pull-left-0111b-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (hand-empty) (can-pull-left-0111b-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-pull-left-0111b-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-left-0111b-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-left-0111b-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-left-0111b-hollow-wide-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-left-0111b-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-left-0111b-hollow-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-pull-left-0111b-hollow-wide-01 ?o))))

  ; Primitive 1101 on category 00 (solid-00); ends at rest in 32 of 32 rehearsals (100%).
  ; Effect (-24.2, 44.1, 0) mm, spread (14.1, 43, 0) mm; 24 of 32 rehearsals as promised: cost 32.
  ; Action parameters: 0.0239 -0.0319 0.0024 0.8310 -0.0384 -0.0241 -0.0197 0.9166 0.0004 0.0230 0.0436
  ; 0.3088
  ; What it promises for an object stands in the problem.
  (:action pull-left-1101-solid-00
    :parameters (?o - solid-00)
    :precondition (and (hand-empty) (can-pull-left-1101-solid-00 ?o) (>= (+ (x ?o) (x-of-pull-left-1101-solid-00 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-left-1101-solid-00 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-left-1101-solid-00 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-left-1101-solid-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-left-1101-solid-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-left-1101-solid-00 ?o)) 10000)) (increase (total-cost) (cost-of-pull-left-1101-solid-00 ?o))))

  ; Primitive 1111 on category 00 (solid-00); ends at rest in 32 of 32 rehearsals (100%).
  ; Effect (-16.5, 15.1, 0) mm, spread (11.5, 13.8, 0) mm; 32 of 32 rehearsals as promised: cost 4.
  ; Action parameters: 0.0314 -0.0479 -0.0026 0.4471 -0.0056 0.0006 0.0140 0.8062 -0.0138 0.0212 0.0410
  ; 0.6473
  ; It turned the object by over 15 degrees in 2 of 32 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action pull-left-1111a-solid-00
    :parameters (?o - solid-00)
    :precondition (and (hand-empty) (can-pull-left-1111a-solid-00 ?o) (>= (+ (x ?o) (x-of-pull-left-1111a-solid-00 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-left-1111a-solid-00 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-left-1111a-solid-00 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-left-1111a-solid-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-left-1111a-solid-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-left-1111a-solid-00 ?o)) 10000)) (increase (total-cost) (cost-of-pull-left-1111a-solid-00 ?o))))

  ; Primitive 0000 on category 00 (solid-00); ends at rest in 30 of 32 rehearsals (94%).
  ; Effect (-24.5, -41.8, 0) mm, spread (12.2, 38.1, 0) mm; 27 of 32 rehearsals as promised: cost 20.
  ; Action parameters: 0.0342 0.0320 0.0209 0.5251 -0.0334 0.0116 -0.0108 0.6250 -0.0327 -0.0469 0.0401
  ; 0.0664
  ; It turned the object by over 15 degrees in 2 of 32 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action pull-right-0000a-solid-00
    :parameters (?o - solid-00)
    :precondition (and (hand-empty) (can-pull-right-0000a-solid-00 ?o) (>= (+ (x ?o) (x-of-pull-right-0000a-solid-00 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-right-0000a-solid-00 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-right-0000a-solid-00 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-right-0000a-solid-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-right-0000a-solid-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-right-0000a-solid-00 ?o)) 10000)) (increase (total-cost) (cost-of-pull-right-0000a-solid-00 ?o))))

  ; Primitive 0110 on category 01 (hollow-wide-01); ends at rest in 35 of 35 rehearsals (100%).
  ; Effect (-35.4, -56.1, 0) mm, spread (18.4, 30.2, 0) mm; 29 of 35 rehearsals as promised: cost 22.
  ; Action parameters: -0.0040 0.0162 0.0033 0.9878 -0.0471 -0.0037 0.0209 0.3053 -0.0398 0.0144 0.0108
  ; 0.9263
  ; It turned the object by over 15 degrees in 1 of 35 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action pull-right-0110-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (hand-empty) (can-pull-right-0110-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-pull-right-0110-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-right-0110-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-right-0110-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-right-0110-hollow-wide-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-right-0110-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-right-0110-hollow-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-pull-right-0110-hollow-wide-01 ?o))))

  ; Primitive 0110 on category 10 (any-tall-narrow-10); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (-39.3, -32.9, 0) mm, spread (2.8, 2.3, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0022 0.0054 0.0090 0.9781 -0.0500 -0.0341 -0.0123 0.2487 -0.0490 -0.0212 0.0059
  ; 0.7406
  ; What it promises for an object stands in the problem.
  (:action pull-right-0110c-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (hand-empty) (can-pull-right-0110c-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-pull-right-0110c-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-right-0110c-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-right-0110c-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-right-0110c-any-tall-narrow-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-right-0110c-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-right-0110c-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-pull-right-0110c-any-tall-narrow-10 ?o))))

  ; Primitive 1010 on category 00 (solid-00); ends at rest in 32 of 32 rehearsals (100%).
  ; Effect (-9.9, -11.6, 0) mm, spread (6.8, 12.2, 0) mm; 32 of 32 rehearsals as promised: cost 4.
  ; Action parameters: 0.0132 0.0362 0.0197 0.8820 -0.0032 -0.0367 0.0026 0.7244 -0.0395 -0.0472 -0.0118
  ; 0.5866
  ; It turned the object by over 15 degrees in 2 of 32 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action pull-right-1010a-solid-00
    :parameters (?o - solid-00)
    :precondition (and (hand-empty) (can-pull-right-1010a-solid-00 ?o) (>= (+ (x ?o) (x-of-pull-right-1010a-solid-00 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-right-1010a-solid-00 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-right-1010a-solid-00 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-right-1010a-solid-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-right-1010a-solid-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-right-1010a-solid-00 ?o)) 10000)) (increase (total-cost) (cost-of-pull-right-1010a-solid-00 ?o))))

  ; Primitive 1110 on category 01 (hollow-wide-01); ends at rest in 35 of 35 rehearsals (100%).
  ; Effect (-33.2, -18.8, 0) mm, spread (3.6, 0.2, 0) mm; 35 of 35 rehearsals as promised: cost 4.
  ; Action parameters: -0.0034 -0.0128 0.0133 0.2975 -0.0091 0.0094 -0.0227 0.2159 -0.0415 -0.0188 -0.0156
  ; 0.6213
  ; What it promises for an object stands in the problem.
  (:action pull-right-1110b-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (hand-empty) (can-pull-right-1110b-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-pull-right-1110b-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-right-1110b-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-right-1110b-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-right-1110b-hollow-wide-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-right-1110b-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-right-1110b-hollow-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-pull-right-1110b-hollow-wide-01 ?o))))

  ; Primitive 0001 on category 10 (any-tall-narrow-10); ends at rest in 28 of 30 rehearsals (93%).
  ; Effect (18.7, -6.7, 0) mm, spread (20.4, 22.7, 0) mm; 26 of 30 rehearsals as promised: cost 18.
  ; Action parameters: -0.0441 -0.0357 0.0111 0.9864 0.0144 0.0184 0.0132 0.3712 -0.0366 -0.0396 0.0480
  ; 0.0110
  ; It turned the object by over 15 degrees in 2 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-forward-0001c-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (hand-empty) (can-push-forward-0001c-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-push-forward-0001c-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-0001c-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-0001c-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-0001c-any-tall-narrow-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-0001c-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-0001c-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-0001c-any-tall-narrow-10 ?o))))

  ; Primitive 1011 on category 00 (solid-00); ends at rest in 31 of 32 rehearsals (97%).
  ; Effect (65.8, 16.5, 0) mm, spread (27.3, 10.4, 0) mm; 26 of 32 rehearsals as promised: cost 24.
  ; Action parameters: -0.0442 -0.0132 -0.0120 0.8369 0.0408 0.0434 0.0072 0.0108 0.0214 0.0374 -0.0139
  ; 0.9783
  ; It turned the object by over 15 degrees in 1 of 32 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-forward-1011-solid-00
    :parameters (?o - solid-00)
    :precondition (and (hand-empty) (can-push-forward-1011-solid-00 ?o) (>= (+ (x ?o) (x-of-push-forward-1011-solid-00 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-1011-solid-00 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-1011-solid-00 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-1011-solid-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-1011-solid-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-1011-solid-00 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-1011-solid-00 ?o))))

  ; Primitive 1011 on category 11 (solid-low-narrow-11); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (85.9, 38.7, 0) mm, spread (2.2, 18.6, 0) mm; 29 of 30 rehearsals as promised: cost 7.
  ; Action parameters: -0.0442 -0.0132 -0.0120 0.8369 0.0408 0.0434 0.0072 0.0108 0.0214 0.0374 -0.0139
  ; 0.9783
  ; What it promises for an object stands in the problem.
  (:action push-forward-1011-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (hand-empty) (can-push-forward-1011-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-push-forward-1011-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-1011-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-1011-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-1011-solid-low-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-1011-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-1011-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-1011-solid-low-narrow-11 ?o))))

  ; Primitive 1011 on category 00 (solid-00); ends at rest in 32 of 32 rehearsals (100%).
  ; Effect (68.4, -21.3, 0) mm, spread (33.1, 16, 0) mm; 24 of 32 rehearsals as promised: cost 32.
  ; Action parameters: -0.0447 0.0137 -0.0062 0.6854 0.0498 -0.0211 -0.0213 0.0600 0.0456 -0.0117 0.0436
  ; 0.5137
  ; What it promises for an object stands in the problem.
  (:action push-forward-1011a-solid-00
    :parameters (?o - solid-00)
    :precondition (and (hand-empty) (can-push-forward-1011a-solid-00 ?o) (>= (+ (x ?o) (x-of-push-forward-1011a-solid-00 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-1011a-solid-00 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-1011a-solid-00 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-1011a-solid-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-1011a-solid-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-1011a-solid-00 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-1011a-solid-00 ?o))))

  ; Primitive 1011 on category 10 (any-tall-narrow-10); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (81.8, 2.5, 0) mm, spread (14.3, 12.5, 0) mm; 29 of 30 rehearsals as promised: cost 7.
  ; Action parameters: -0.0348 -0.0126 0.0060 0.8439 0.0489 0.0074 -0.0135 0.0408 0.0171 -0.0120 0.0209
  ; 0.5940
  ; It turned the object by over 15 degrees in 2 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-forward-1011c-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (hand-empty) (can-push-forward-1011c-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-push-forward-1011c-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-1011c-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-1011c-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-1011c-any-tall-narrow-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-1011c-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-1011c-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-1011c-any-tall-narrow-10 ?o))))

  ; Primitive 0001 on category 00 (solid-00); ends at rest in 32 of 32 rehearsals (100%).
  ; Effect (15.1, 13.1, 0) mm, spread (13.1, 14.2, 0) mm; 31 of 32 rehearsals as promised: cost 7.
  ; Action parameters: 0.0082 -0.0138 -0.0163 0.6848 0.0483 0.0164 0.0170 0.7796 0.0308 -0.0262 0.0437
  ; 0.2789
  ; What it promises for an object stands in the problem.
  (:action push-forward-left-0001a-solid-00
    :parameters (?o - solid-00)
    :precondition (and (hand-empty) (can-push-forward-left-0001a-solid-00 ?o) (>= (+ (x ?o) (x-of-push-forward-left-0001a-solid-00 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-left-0001a-solid-00 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-left-0001a-solid-00 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-left-0001a-solid-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-left-0001a-solid-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-left-0001a-solid-00 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-left-0001a-solid-00 ?o))))

  ; Primitive 1001 on category 00 (solid-00); ends at rest in 32 of 32 rehearsals (100%).
  ; Effect (16.2, 27.1, 0) mm, spread (9.8, 20.3, 0) mm; 32 of 32 rehearsals as promised: cost 4.
  ; Action parameters: -0.0210 -0.0275 0.0100 0.5873 -0.0147 0.0412 -0.0211 0.8410 0.0500 -0.0100 0.0399
  ; 0.3111
  ; What it promises for an object stands in the problem.
  (:action push-forward-left-1001-solid-00
    :parameters (?o - solid-00)
    :precondition (and (hand-empty) (can-push-forward-left-1001-solid-00 ?o) (>= (+ (x ?o) (x-of-push-forward-left-1001-solid-00 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-left-1001-solid-00 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-left-1001-solid-00 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-left-1001-solid-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-left-1001-solid-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-left-1001-solid-00 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-left-1001-solid-00 ?o))))

  ; Primitive 1011 on category 01 (hollow-wide-01); ends at rest in 35 of 35 rehearsals (100%).
  ; Effect (35.8, 21.2, 0) mm, spread (11.1, 3.1, 0) mm; 35 of 35 rehearsals as promised: cost 4.
  ; Action parameters: -0.0255 0.0044 0.0181 0.3847 0.0071 -0.0063 -0.0202 0.3488 0.0477 0.0228 0.0252
  ; 0.8781
  ; What it promises for an object stands in the problem.
  (:action push-forward-left-1011b-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (hand-empty) (can-push-forward-left-1011b-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-push-forward-left-1011b-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-left-1011b-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-left-1011b-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-left-1011b-hollow-wide-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-left-1011b-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-left-1011b-hollow-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-left-1011b-hollow-wide-01 ?o))))

  ; Primitive 1111 on category 10 (any-tall-narrow-10); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (13.6, 19.2, 0) mm, spread (14.5, 19.5, 0) mm; 28 of 30 rehearsals as promised: cost 11.
  ; Action parameters: -0.0462 -0.0491 -0.0005 0.4288 0.0191 0.0391 -0.0053 0.7531 -0.0044 0.0329 0.0324
  ; 0.8031
  ; It turned the object by over 15 degrees in 2 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-forward-left-1111b-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (hand-empty) (can-push-forward-left-1111b-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-push-forward-left-1111b-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-left-1111b-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-left-1111b-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-left-1111b-any-tall-narrow-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-left-1111b-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-left-1111b-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-left-1111b-any-tall-narrow-10 ?o))))

  ; Primitive 0010 on category 00 (solid-00); ends at rest in 32 of 32 rehearsals (100%).
  ; Effect (17.2, -25.6, 0) mm, spread (12.9, 14.4, 0) mm; 32 of 32 rehearsals as promised: cost 4.
  ; Action parameters: -0.0423 0.0368 0.0143 0.2940 -0.0088 -0.0326 0.0081 0.5677 -0.0026 -0.0173 -0.0063
  ; 0.7865
  ; It turned the object by over 15 degrees in 1 of 32 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-forward-right-0010a-solid-00
    :parameters (?o - solid-00)
    :precondition (and (hand-empty) (can-push-forward-right-0010a-solid-00 ?o) (>= (+ (x ?o) (x-of-push-forward-right-0010a-solid-00 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-right-0010a-solid-00 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-right-0010a-solid-00 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-right-0010a-solid-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-right-0010a-solid-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-right-0010a-solid-00 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-right-0010a-solid-00 ?o))))

  ; Primitive 0010 on category 01 (hollow-wide-01); ends at rest in 35 of 35 rehearsals (100%).
  ; Effect (39.5, -31.6, 0) mm, spread (5.7, 5.3, 0) mm; 35 of 35 rehearsals as promised: cost 4.
  ; Action parameters: 0.0018 0.0344 -0.0155 0.1304 -0.0108 0.0252 -0.0125 0.1486 0.0456 -0.0337 0.0208
  ; 0.5394
  ; What it promises for an object stands in the problem.
  (:action push-forward-right-0010b-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (hand-empty) (can-push-forward-right-0010b-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-push-forward-right-0010b-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-right-0010b-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-right-0010b-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-right-0010b-hollow-wide-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-right-0010b-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-right-0010b-hollow-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-right-0010b-hollow-wide-01 ?o))))

  ; Primitive 0010 on category 10 (any-tall-narrow-10); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (15.8, -29.8, 0) mm, spread (16.5, 27.6, 0) mm; 25 of 30 rehearsals as promised: cost 22.
  ; Action parameters: -0.0272 0.0487 -0.0121 0.1509 0.0335 -0.0335 0.0040 0.1324 -0.0117 -0.0191 0.0074
  ; 0.2038
  ; What it promises for an object stands in the problem.
  (:action push-forward-right-0010c-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (hand-empty) (can-push-forward-right-0010c-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-push-forward-right-0010c-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-right-0010c-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-right-0010c-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-right-0010c-any-tall-narrow-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-right-0010c-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-right-0010c-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-right-0010c-any-tall-narrow-10 ?o))))

  ; Primitive 1010 on category 10 (any-tall-narrow-10); ends at rest in 29 of 30 rehearsals (97%).
  ; Effect (27.9, -28, 0) mm, spread (26.5, 48.4, 0) mm; 17 of 30 rehearsals as promised: cost 59.
  ; Action parameters: -0.0199 0.0277 -0.0218 0.9981 0.0369 -0.0395 0.0148 0.4144 -0.0078 -0.0338 0.0135
  ; 0.8040
  ; It turned the object by over 15 degrees in 4 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-forward-right-1010-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (hand-empty) (can-push-forward-right-1010-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-push-forward-right-1010-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-right-1010-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-right-1010-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-right-1010-any-tall-narrow-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-right-1010-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-right-1010-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-right-1010-any-tall-narrow-10 ?o))))

  ; Primitive 1101 on category 11 (solid-low-narrow-11); ends at rest in 3 of 30 rehearsals (10%).
  ; Effect (13.2, -11.3, 0) mm, spread (16.4, 12.4, 0) mm; 3 of 30 rehearsals as promised: cost 209.
  ; Action parameters: 0.0239 -0.0319 0.0024 0.8310 -0.0384 -0.0241 -0.0197 0.9166 0.0004 0.0230 0.0436
  ; 0.3088
  ; What it promises for an object stands in the problem.
  (:action push-forward-right-1101-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (hand-empty) (can-push-forward-right-1101-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-push-forward-right-1101-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-right-1101-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-right-1101-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-right-1101-solid-low-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-right-1101-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-right-1101-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-right-1101-solid-low-narrow-11 ?o))))

  ; Primitive 0011 on category 11 (solid-low-narrow-11); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (-15.4, 40.4, 0) mm, spread (0.8, 0.5, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0134 -0.0188 -0.0142 0.8207 -0.0301 0.0417 -0.0126 0.3759 -0.0112 0.0473 0.0118
  ; 0.8932
  ; What it promises for an object stands in the problem.
  (:action push-left-0011-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (hand-empty) (can-push-left-0011-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-push-left-0011-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-push-left-0011-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-push-left-0011-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-push-left-0011-solid-low-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-left-0011-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-left-0011-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-push-left-0011-solid-low-narrow-11 ?o))))

  ; Primitive 0011 on category 00 (solid-00); ends at rest in 32 of 32 rehearsals (100%).
  ; Effect (10.8, 56.3, 0) mm, spread (6.4, 20.8, 0) mm; 31 of 32 rehearsals as promised: cost 7.
  ; Action parameters: -0.0085 -0.0420 -0.0124 0.6521 -0.0018 0.0336 0.0105 0.7081 0.0495 0.0400 -0.0207
  ; 0.6082
  ; What it promises for an object stands in the problem.
  (:action push-left-0011a-solid-00
    :parameters (?o - solid-00)
    :precondition (and (hand-empty) (can-push-left-0011a-solid-00 ?o) (>= (+ (x ?o) (x-of-push-left-0011a-solid-00 ?o)) 10006) (<= (+ (x ?o) (x-of-push-left-0011a-solid-00 ?o)) 15994) (>= (+ (y ?o) (y-of-push-left-0011a-solid-00 ?o)) 10006) (<= (+ (y ?o) (y-of-push-left-0011a-solid-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-left-0011a-solid-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-left-0011a-solid-00 ?o)) 10000)) (increase (total-cost) (cost-of-push-left-0011a-solid-00 ?o))))

  ; Primitive 0011 on category 01 (hollow-wide-01); ends at rest in 35 of 35 rehearsals (100%).
  ; Effect (28.5, 66.9, 0) mm, spread (5.4, 9.4, 0) mm; 35 of 35 rehearsals as promised: cost 4.
  ; Action parameters: 0.0003 -0.0369 -0.0128 0.8703 0.0313 0.0011 -0.0046 0.2444 0.0231 -0.0295 0.0176
  ; 0.7735
  ; What it promises for an object stands in the problem.
  (:action push-left-0011b-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (hand-empty) (can-push-left-0011b-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-push-left-0011b-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-push-left-0011b-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-push-left-0011b-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-push-left-0011b-hollow-wide-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-left-0011b-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-left-0011b-hollow-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-push-left-0011b-hollow-wide-01 ?o))))

  ; Primitive 0011 on category 10 (any-tall-narrow-10); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (-7.9, 27.4, 0) mm, spread (8.5, 16, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0013 -0.0012 0.0148 0.6726 -0.0266 0.0494 -0.0104 0.2370 0.0129 0.0316 -0.0227
  ; 0.6954
  ; What it promises for an object stands in the problem.
  (:action push-left-0011c-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (hand-empty) (can-push-left-0011c-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-push-left-0011c-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-push-left-0011c-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-push-left-0011c-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-push-left-0011c-any-tall-narrow-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-left-0011c-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-left-0011c-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-push-left-0011c-any-tall-narrow-10 ?o))))

  ; Primitive 1110 on category 00 (solid-00); ends at rest in 32 of 32 rehearsals (100%).
  ; Effect (-2.8, 14.6, 0) mm, spread (13.7, 25.7, 0) mm; 27 of 32 rehearsals as promised: cost 20.
  ; Action parameters: -0.0054 -0.0137 0.0245 0.2490 -0.0359 0.0191 0.0040 0.5593 -0.0474 0.0452 0.0027
  ; 0.4174
  ; It turned the object by over 15 degrees in 5 of 32 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-left-1110a-solid-00
    :parameters (?o - solid-00)
    :precondition (and (hand-empty) (can-push-left-1110a-solid-00 ?o) (>= (+ (x ?o) (x-of-push-left-1110a-solid-00 ?o)) 10006) (<= (+ (x ?o) (x-of-push-left-1110a-solid-00 ?o)) 15994) (>= (+ (y ?o) (y-of-push-left-1110a-solid-00 ?o)) 10006) (<= (+ (y ?o) (y-of-push-left-1110a-solid-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-left-1110a-solid-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-left-1110a-solid-00 ?o)) 10000)) (increase (total-cost) (cost-of-push-left-1110a-solid-00 ?o))))

  ; Primitive 1111 on category 01 (hollow-wide-01); ends at rest in 35 of 35 rehearsals (100%).
  ; Effect (-9.2, 38.2, 0) mm, spread (5.5, 25.4, 0) mm; 35 of 35 rehearsals as promised: cost 4.
  ; Action parameters: 0.0053 -0.0500 -0.0110 0.4640 -0.0050 -0.0079 0.0099 0.7482 -0.0116 0.0500 -0.0137
  ; 0.6575
  ; It turned the object by over 15 degrees in 1 of 35 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-left-1111-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (hand-empty) (can-push-left-1111-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-push-left-1111-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-push-left-1111-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-push-left-1111-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-push-left-1111-hollow-wide-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-left-1111-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-left-1111-hollow-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-push-left-1111-hollow-wide-01 ?o))))

  ; Primitive 1111 on category 11 (solid-low-narrow-11); ends at rest in 23 of 30 rehearsals (77%).
  ; Effect (-9.3, 151.7, 0) mm, spread (2, 27.3, 0) mm; 22 of 30 rehearsals as promised: cost 34.
  ; Action parameters: 0.0053 -0.0500 -0.0110 0.4640 -0.0050 -0.0079 0.0099 0.7482 -0.0116 0.0500 -0.0137
  ; 0.6575
  ; It turned the object by over 15 degrees in 4 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-left-1111-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (hand-empty) (can-push-left-1111-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-push-left-1111-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-push-left-1111-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-push-left-1111-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-push-left-1111-solid-low-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-left-1111-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-left-1111-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-push-left-1111-solid-low-narrow-11 ?o))))

  ; Primitive 0000 on category 10 (any-tall-narrow-10); ends at rest in 12 of 30 rehearsals (40%).
  ; Effect (-19.8, -61.3, 0) mm, spread (14.2, 23.3, 0) mm; 11 of 30 rehearsals as promised: cost 99.
  ; Action parameters: 0.0137 0.0211 -0.0050 0.7150 0.0201 -0.0295 -0.0140 0.9301 0.0042 -0.0315 0.0415
  ; 0.3624
  ; It turned the object by over 15 degrees in 6 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-right-0000-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (hand-empty) (can-push-right-0000-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-push-right-0000-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-0000-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-0000-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-0000-any-tall-narrow-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-0000-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-0000-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-0000-any-tall-narrow-10 ?o))))

  ; Primitive 0000 on category 10 (any-tall-narrow-10); ends at rest in 3 of 30 rehearsals (10%).
  ; Effect (-7.9, -41.2, 0) mm, spread (5.3, 35.6, 0) mm; 3 of 30 rehearsals as promised: cost 209.
  ; Action parameters: 0.0056 0.0119 -0.0043 0.6260 -0.0376 -0.0077 -0.0113 0.3341 -0.0101 -0.0319 0.0213
  ; 0.3102
  ; What it promises for an object stands in the problem.
  (:action push-right-0000c-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (hand-empty) (can-push-right-0000c-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-push-right-0000c-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-0000c-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-0000c-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-0000c-any-tall-narrow-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-0000c-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-0000c-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-0000c-any-tall-narrow-10 ?o))))

  ; Primitive 0010 on category 11 (solid-low-narrow-11); ends at rest in 27 of 30 rehearsals (90%).
  ; Effect (-19.6, -108.3, 0) mm, spread (11.8, 17.3, 0) mm; 25 of 30 rehearsals as promised: cost 22.
  ; Action parameters: 0.0327 0.0500 -0.0090 0.2013 -0.0330 -0.0172 0.0213 0.9771 -0.0026 0.0198 0.0354
  ; 0.8772
  ; It turned the object by over 15 degrees in 5 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-right-0010d-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (hand-empty) (can-push-right-0010d-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-push-right-0010d-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-0010d-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-0010d-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-0010d-solid-low-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-0010d-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-0010d-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-0010d-solid-low-narrow-11 ?o))))

  ; Primitive 0100 on category 01 (hollow-wide-01); ends at rest in 21 of 35 rehearsals (60%).
  ; Effect (-18.2, -58.4, 0) mm, spread (14.2, 30, 0) mm; 16 of 35 rehearsals as promised: cost 79.
  ; Action parameters: -0.0078 0.0113 -0.0202 0.8227 -0.0405 -0.0324 0.0191 0.3138 -0.0233 0.0125 -0.0486
  ; 0.4209
  ; It turned the object by over 15 degrees in 4 of 35 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-right-0100b-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (hand-empty) (can-push-right-0100b-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-push-right-0100b-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-0100b-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-0100b-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-0100b-hollow-wide-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-0100b-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-0100b-hollow-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-0100b-hollow-wide-01 ?o))))

  ; Primitive 0110 on category 01 (hollow-wide-01); ends at rest in 35 of 35 rehearsals (100%).
  ; Effect (-42.7, -87, 0) mm, spread (11.2, 24.7, 0) mm; 31 of 35 rehearsals as promised: cost 16.
  ; Action parameters: -0.0066 0.0239 0.0062 0.8097 -0.0451 -0.0240 0.0068 0.2718 -0.0492 -0.0021 0.0432
  ; 0.5018
  ; It turned the object by over 15 degrees in 1 of 35 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-right-0110b-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (hand-empty) (can-push-right-0110b-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-push-right-0110b-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-0110b-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-0110b-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-0110b-hollow-wide-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-0110b-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-0110b-hollow-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-0110b-hollow-wide-01 ?o))))

  ; Primitive 1000 on category 01 (hollow-wide-01); ends at rest in 4 of 35 rehearsals (11%).
  ; Effect (-0.2, -15.8, 0) mm, spread (1.7, 11.7, 0) mm; 4 of 35 rehearsals as promised: cost 201.
  ; Action parameters: 0.0053 0.0259 -0.0141 0.6662 -0.0193 0.0156 -0.0049 0.5264 0.0491 0.0354 -0.0258
  ; 0.2445
  ; It turned the object by over 15 degrees in 12 of 35 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-right-1000-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (hand-empty) (can-push-right-1000-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-push-right-1000-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-1000-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-1000-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-1000-hollow-wide-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-1000-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-1000-hollow-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-1000-hollow-wide-01 ?o))))

  ; Primitive 1000 on category 00 (solid-00); ends at rest in 32 of 32 rehearsals (100%).
  ; Effect (-0.6, -22, 0) mm, spread (2.4, 25.1, 0) mm; 32 of 32 rehearsals as promised: cost 4.
  ; Action parameters: 0.0053 0.0259 -0.0141 0.6662 -0.0193 0.0156 -0.0049 0.5264 0.0491 0.0354 -0.0258
  ; 0.2445
  ; What it promises for an object stands in the problem.
  (:action push-right-1000-solid-00
    :parameters (?o - solid-00)
    :precondition (and (hand-empty) (can-push-right-1000-solid-00 ?o) (>= (+ (x ?o) (x-of-push-right-1000-solid-00 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-1000-solid-00 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-1000-solid-00 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-1000-solid-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-1000-solid-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-1000-solid-00 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-1000-solid-00 ?o))))

  ; Primitive 1010 on category 01 (hollow-wide-01); ends at rest in 35 of 35 rehearsals (100%).
  ; Effect (35.4, -103.2, 0) mm, spread (11.3, 21.2, 0) mm; 33 of 35 rehearsals as promised: cost 9.
  ; Action parameters: -0.0199 0.0277 -0.0218 0.9981 0.0369 -0.0395 0.0148 0.4144 -0.0078 -0.0338 0.0135
  ; 0.8040
  ; It turned the object by over 15 degrees in 15 of 35 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-right-1010-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (hand-empty) (can-push-right-1010-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-push-right-1010-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-1010-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-1010-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-1010-hollow-wide-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-1010-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-1010-hollow-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-1010-hollow-wide-01 ?o))))

  ; Primitive 1010 on category 01 (hollow-wide-01); ends at rest in 35 of 35 rehearsals (100%).
  ; Effect (8.8, -69.4, 0) mm, spread (2.5, 7.6, 0) mm; 35 of 35 rehearsals as promised: cost 4.
  ; Action parameters: -0.0047 0.0382 0.0084 0.7524 0.0162 -0.0476 -0.0250 0.8375 -0.0271 -0.0365 0.0400
  ; 1.0000
  ; What it promises for an object stands in the problem.
  (:action push-right-1010b-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (hand-empty) (can-push-right-1010b-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-push-right-1010b-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-1010b-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-1010b-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-1010b-hollow-wide-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-1010b-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-1010b-hollow-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-1010b-hollow-wide-01 ?o))))

  ; Primitive 1100 on category 00 (solid-00); ends at rest in 24 of 32 rehearsals (75%).
  ; Effect (-2.4, -38.1, 0) mm, spread (3.4, 31.6, 0) mm; 23 of 32 rehearsals as promised: cost 36.
  ; Action parameters: -0.0096 0.0080 -0.0139 0.7774 -0.0226 -0.0427 -0.0209 0.3157 -0.0369 0.0254 -0.0163
  ; 0.1462
  ; What it promises for an object stands in the problem.
  (:action push-right-1100-solid-00
    :parameters (?o - solid-00)
    :precondition (and (hand-empty) (can-push-right-1100-solid-00 ?o) (>= (+ (x ?o) (x-of-push-right-1100-solid-00 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-1100-solid-00 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-1100-solid-00 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-1100-solid-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-1100-solid-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-1100-solid-00 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-1100-solid-00 ?o))))

  ; Primitive 1100 on category 01 (hollow-wide-01); ends at rest in 21 of 35 rehearsals (60%).
  ; Effect (-4.6, -39.6, 0) mm, spread (5.7, 26.9, 0) mm; 21 of 35 rehearsals as promised: cost 53.
  ; Action parameters: 0.0010 0.0111 -0.0226 0.9310 -0.0425 0.0251 -0.0188 0.0663 -0.0122 0.0203 -0.0123
  ; 0.2912
  ; What it promises for an object stands in the problem.
  (:action push-right-1100a-hollow-wide-01
    :parameters (?o - hollow-wide-01)
    :precondition (and (hand-empty) (can-push-right-1100a-hollow-wide-01 ?o) (>= (+ (x ?o) (x-of-push-right-1100a-hollow-wide-01 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-1100a-hollow-wide-01 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-1100a-hollow-wide-01 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-1100a-hollow-wide-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-1100a-hollow-wide-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-1100a-hollow-wide-01 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-1100a-hollow-wide-01 ?o))))

  ; Primitive 1110 on category 10 (any-tall-narrow-10); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (-16.5, -46.7, 0) mm, spread (3.2, 3.8, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0137 -0.0015 -0.0243 0.9562 -0.0048 -0.0485 -0.0220 0.4708 0.0421 -0.0202 0.0087
  ; 0.8538
  ; What it promises for an object stands in the problem.
  (:action push-right-1110-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (hand-empty) (can-push-right-1110-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-push-right-1110-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-1110-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-1110-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-1110-any-tall-narrow-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-1110-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-1110-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-1110-any-tall-narrow-10 ?o))))

  ; Primitive 1110 on category 11 (solid-low-narrow-11); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (-18.5, -49.8, 0) mm, spread (0, 0.3, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0137 -0.0015 -0.0243 0.9562 -0.0048 -0.0485 -0.0220 0.4708 0.0421 -0.0202 0.0087
  ; 0.8538
  ; What it promises for an object stands in the problem.
  (:action push-right-1110-solid-low-narrow-11
    :parameters (?o - solid-low-narrow-11)
    :precondition (and (hand-empty) (can-push-right-1110-solid-low-narrow-11 ?o) (>= (+ (x ?o) (x-of-push-right-1110-solid-low-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-1110-solid-low-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-1110-solid-low-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-1110-solid-low-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-1110-solid-low-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-1110-solid-low-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-1110-solid-low-narrow-11 ?o))))

  ; Primitive 1101 on category 10 (any-tall-narrow-10); ends at rest in 6 of 30 rehearsals (20%).
  ; Effect (-0.8, 6.6, 0) mm, spread (1.1, 14.6, 0) mm; 6 of 30 rehearsals as promised: cost 153.
  ; Action parameters: 0.0457 -0.0203 -0.0048 0.9672 0.0094 0.0080 -0.0132 0.8279 0.0235 0.0049 -0.0176
  ; 0.0967
  ; It turned the object by over 15 degrees in 1 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action stay-1101b-any-tall-narrow-10
    :parameters (?o - any-tall-narrow-10)
    :precondition (and (hand-empty) (can-stay-1101b-any-tall-narrow-10 ?o) (>= (+ (x ?o) (x-of-stay-1101b-any-tall-narrow-10 ?o)) 10006) (<= (+ (x ?o) (x-of-stay-1101b-any-tall-narrow-10 ?o)) 15994) (>= (+ (y ?o) (y-of-stay-1101b-any-tall-narrow-10 ?o)) 10006) (<= (+ (y ?o) (y-of-stay-1101b-any-tall-narrow-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-stay-1101b-any-tall-narrow-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-stay-1101b-any-tall-narrow-10 ?o)) 10000)) (increase (total-cost) (cost-of-stay-1101b-any-tall-narrow-10 ?o))))

  ; No operator is left out.
)
