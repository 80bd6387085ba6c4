; Learned domain towers, encoding numeric. Printed by neurosym; do not edit.
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

(define (domain towers-numeric)
  (:requirements :strips :typing :numeric-fluents :action-costs)

  (:types
    movable - object
    any-tall-narrow-11 hollow-wide-00 solid-low-10 solid-low-narrow-01 - movable)

  (:predicates
    (hand-empty)
    (held-by-lift-0000-hollow-wide-00 ?o - hollow-wide-00)
    (held-by-lift-0000-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (held-by-lift-0000a-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (held-by-lift-0000c-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (held-by-lift-0001-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (held-by-lift-0001-hollow-wide-00 ?o - hollow-wide-00)
    (held-by-lift-0001-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (held-by-lift-0001a-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (held-by-lift-0001a-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (held-by-lift-0010-solid-low-10 ?o - solid-low-10)
    (held-by-lift-0010-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (held-by-lift-0010a-hollow-wide-00 ?o - hollow-wide-00)
    (held-by-lift-0010b-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (held-by-lift-0011-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (held-by-lift-0011-hollow-wide-00 ?o - hollow-wide-00)
    (held-by-lift-0011a-hollow-wide-00 ?o - hollow-wide-00)
    (held-by-lift-0011b-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (held-by-lift-0011c-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (held-by-lift-0110b-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (held-by-lift-1000-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (held-by-lift-1000-hollow-wide-00 ?o - hollow-wide-00)
    (held-by-lift-1000-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (held-by-lift-1000a-hollow-wide-00 ?o - hollow-wide-00)
    (held-by-lift-1001-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (held-by-lift-1001a-hollow-wide-00 ?o - hollow-wide-00)
    (held-by-lift-1001b-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (held-by-lift-1001c-solid-low-10 ?o - solid-low-10)
    (held-by-lift-1001d-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (held-by-lift-1010-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (held-by-lift-1010a-hollow-wide-00 ?o - hollow-wide-00)
    (held-by-lift-1010b-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (held-by-lift-1101-hollow-wide-00 ?o - hollow-wide-00)
    (held-by-lift-1101a-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-lift-0000-hollow-wide-00 ?o - hollow-wide-00)
    (can-lift-0000-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-lift-0000a-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-lift-0000c-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-lift-0001-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-lift-0001-hollow-wide-00 ?o - hollow-wide-00)
    (can-lift-0001-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-lift-0001a-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-lift-0001a-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-lift-0010-solid-low-10 ?o - solid-low-10)
    (can-lift-0010-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-lift-0010a-hollow-wide-00 ?o - hollow-wide-00)
    (can-lift-0010b-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-lift-0011-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-lift-0011-hollow-wide-00 ?o - hollow-wide-00)
    (can-lift-0011a-hollow-wide-00 ?o - hollow-wide-00)
    (can-lift-0011b-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-lift-0011c-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-lift-0110b-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-lift-1000-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-lift-1000-hollow-wide-00 ?o - hollow-wide-00)
    (can-lift-1000-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-lift-1000a-hollow-wide-00 ?o - hollow-wide-00)
    (can-lift-1001-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-lift-1001a-hollow-wide-00 ?o - hollow-wide-00)
    (can-lift-1001b-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-lift-1001c-solid-low-10 ?o - solid-low-10)
    (can-lift-1001d-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-lift-1010-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-lift-1010a-hollow-wide-00 ?o - hollow-wide-00)
    (can-lift-1010b-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-lift-1101-hollow-wide-00 ?o - hollow-wide-00)
    (can-lift-1101a-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-place-back-0000-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-place-back-right-0000-hollow-wide-00 ?o - hollow-wide-00)
    (can-place-forward-right-0111d-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-place-right-0111-hollow-wide-00 ?o - hollow-wide-00)
    (can-place-right-0111a-hollow-wide-00 ?o - hollow-wide-00)
    (can-place-right-0111b-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-pull-0000b-solid-low-10 ?o - solid-low-10)
    (can-pull-0100-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-pull-0100-hollow-wide-00 ?o - hollow-wide-00)
    (can-pull-0100-solid-low-10 ?o - solid-low-10)
    (can-pull-0100c-solid-low-10 ?o - solid-low-10)
    (can-pull-0110c-solid-low-10 ?o - solid-low-10)
    (can-pull-0110d-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-pull-1100b-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-pull-left-0110a-hollow-wide-00 ?o - hollow-wide-00)
    (can-pull-left-1110c-solid-low-10 ?o - solid-low-10)
    (can-pull-left-1110d-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-pull-right-0011c-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-pull-right-0100a-hollow-wide-00 ?o - hollow-wide-00)
    (can-pull-right-0100b-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-pull-right-0100d-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-pull-right-0110-hollow-wide-00 ?o - hollow-wide-00)
    (can-pull-right-0110b-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-pull-right-0111-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-push-forward-0101c-solid-low-10 ?o - solid-low-10)
    (can-push-forward-1011-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-push-forward-1011-solid-low-10 ?o - solid-low-10)
    (can-push-forward-1011-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-push-forward-1011a-hollow-wide-00 ?o - hollow-wide-00)
    (can-push-forward-1011b-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-push-forward-1110a-hollow-wide-00 ?o - hollow-wide-00)
    (can-push-forward-1111b-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-push-forward-left-1001c-solid-low-10 ?o - solid-low-10)
    (can-push-forward-left-1010-solid-low-10 ?o - solid-low-10)
    (can-push-forward-left-1100c-solid-low-10 ?o - solid-low-10)
    (can-push-forward-left-1100d-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-push-forward-left-1111a-hollow-wide-00 ?o - hollow-wide-00)
    (can-push-forward-right-0101a-hollow-wide-00 ?o - hollow-wide-00)
    (can-push-forward-right-0111c-solid-low-10 ?o - solid-low-10)
    (can-push-forward-right-1111-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-push-forward-right-1111-solid-low-10 ?o - solid-low-10)
    (can-push-forward-right-1111-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-push-left-0110-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-push-left-1000-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-push-left-1000-solid-low-10 ?o - solid-low-10)
    (can-push-left-1100a-hollow-wide-00 ?o - hollow-wide-00)
    (can-push-left-1101-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-push-left-1101a-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-push-left-1110b-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-push-right-0001-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-push-right-0001a-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-push-right-0001b-solid-low-10 ?o - solid-low-10)
    (can-push-right-0010-solid-low-10 ?o - solid-low-10)
    (can-push-right-0010a-hollow-wide-00 ?o - hollow-wide-00)
    (can-push-right-0011-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-push-right-0011-hollow-wide-00 ?o - hollow-wide-00)
    (can-push-right-0011-solid-low-10 ?o - solid-low-10)
    (can-push-right-0101b-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-push-right-0101d-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-push-right-0111-any-tall-narrow-11 ?o - any-tall-narrow-11)
    (can-push-right-1001-solid-low-narrow-01 ?o - solid-low-narrow-01)
    (can-push-right-1101-hollow-wide-00 ?o - hollow-wide-00)
    (can-stay-1101-solid-low-10 ?o - solid-low-10))

  (:functions
    (x ?o - movable) - number
    (y ?o - movable) - number
    (z ?o - movable) - number
    (total-cost) - number
    (x-of-lift-0000-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-lift-0000-hollow-wide-00 ?o - hollow-wide-00) - number
    (z-of-lift-0000-hollow-wide-00 ?o - hollow-wide-00) - number
    (cost-of-lift-0000-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-put-down-lift-0000-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-put-down-lift-0000-hollow-wide-00 ?o - hollow-wide-00) - number
    (z-of-put-down-lift-0000-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-lift-0000-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-lift-0000-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (z-of-lift-0000-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (cost-of-lift-0000-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-put-down-lift-0000-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-put-down-lift-0000-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (z-of-put-down-lift-0000-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-lift-0000a-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-lift-0000a-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (z-of-lift-0000a-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (cost-of-lift-0000a-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-put-down-lift-0000a-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-put-down-lift-0000a-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (z-of-put-down-lift-0000a-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-lift-0000c-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-lift-0000c-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (z-of-lift-0000c-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-lift-0000c-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-put-down-lift-0000c-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-put-down-lift-0000c-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (z-of-put-down-lift-0000c-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-lift-0001-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-lift-0001-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (z-of-lift-0001-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-lift-0001-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-put-down-lift-0001-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-put-down-lift-0001-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (z-of-put-down-lift-0001-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-lift-0001-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-lift-0001-hollow-wide-00 ?o - hollow-wide-00) - number
    (z-of-lift-0001-hollow-wide-00 ?o - hollow-wide-00) - number
    (cost-of-lift-0001-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-put-down-lift-0001-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-put-down-lift-0001-hollow-wide-00 ?o - hollow-wide-00) - number
    (z-of-put-down-lift-0001-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-lift-0001-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-lift-0001-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (z-of-lift-0001-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (cost-of-lift-0001-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-put-down-lift-0001-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-put-down-lift-0001-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (z-of-put-down-lift-0001-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-lift-0001a-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-lift-0001a-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (z-of-lift-0001a-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-lift-0001a-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-put-down-lift-0001a-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-put-down-lift-0001a-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (z-of-put-down-lift-0001a-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-lift-0001a-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-lift-0001a-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (z-of-lift-0001a-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (cost-of-lift-0001a-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-put-down-lift-0001a-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-put-down-lift-0001a-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (z-of-put-down-lift-0001a-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-lift-0010-solid-low-10 ?o - solid-low-10) - number
    (y-of-lift-0010-solid-low-10 ?o - solid-low-10) - number
    (z-of-lift-0010-solid-low-10 ?o - solid-low-10) - number
    (cost-of-lift-0010-solid-low-10 ?o - solid-low-10) - number
    (x-of-put-down-lift-0010-solid-low-10 ?o - solid-low-10) - number
    (y-of-put-down-lift-0010-solid-low-10 ?o - solid-low-10) - number
    (z-of-put-down-lift-0010-solid-low-10 ?o - solid-low-10) - number
    (x-of-lift-0010-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-lift-0010-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (z-of-lift-0010-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (cost-of-lift-0010-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-put-down-lift-0010-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-put-down-lift-0010-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (z-of-put-down-lift-0010-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-lift-0010a-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-lift-0010a-hollow-wide-00 ?o - hollow-wide-00) - number
    (z-of-lift-0010a-hollow-wide-00 ?o - hollow-wide-00) - number
    (cost-of-lift-0010a-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-put-down-lift-0010a-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-put-down-lift-0010a-hollow-wide-00 ?o - hollow-wide-00) - number
    (z-of-put-down-lift-0010a-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-lift-0010b-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-lift-0010b-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (z-of-lift-0010b-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-lift-0010b-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-put-down-lift-0010b-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-put-down-lift-0010b-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (z-of-put-down-lift-0010b-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-lift-0011-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-lift-0011-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (z-of-lift-0011-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-lift-0011-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-put-down-lift-0011-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-put-down-lift-0011-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (z-of-put-down-lift-0011-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-lift-0011-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-lift-0011-hollow-wide-00 ?o - hollow-wide-00) - number
    (z-of-lift-0011-hollow-wide-00 ?o - hollow-wide-00) - number
    (cost-of-lift-0011-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-put-down-lift-0011-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-put-down-lift-0011-hollow-wide-00 ?o - hollow-wide-00) - number
    (z-of-put-down-lift-0011-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-lift-0011a-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-lift-0011a-hollow-wide-00 ?o - hollow-wide-00) - number
    (z-of-lift-0011a-hollow-wide-00 ?o - hollow-wide-00) - number
    (cost-of-lift-0011a-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-put-down-lift-0011a-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-put-down-lift-0011a-hollow-wide-00 ?o - hollow-wide-00) - number
    (z-of-put-down-lift-0011a-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-lift-0011b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-lift-0011b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (z-of-lift-0011b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (cost-of-lift-0011b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-put-down-lift-0011b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-put-down-lift-0011b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (z-of-put-down-lift-0011b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-lift-0011c-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-lift-0011c-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (z-of-lift-0011c-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-lift-0011c-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-put-down-lift-0011c-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-put-down-lift-0011c-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (z-of-put-down-lift-0011c-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-lift-0110b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-lift-0110b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (z-of-lift-0110b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (cost-of-lift-0110b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-put-down-lift-0110b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-put-down-lift-0110b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (z-of-put-down-lift-0110b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-lift-1000-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-lift-1000-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (z-of-lift-1000-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-lift-1000-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-put-down-lift-1000-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-put-down-lift-1000-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (z-of-put-down-lift-1000-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-lift-1000-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-lift-1000-hollow-wide-00 ?o - hollow-wide-00) - number
    (z-of-lift-1000-hollow-wide-00 ?o - hollow-wide-00) - number
    (cost-of-lift-1000-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-put-down-lift-1000-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-put-down-lift-1000-hollow-wide-00 ?o - hollow-wide-00) - number
    (z-of-put-down-lift-1000-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-lift-1000-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-lift-1000-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (z-of-lift-1000-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (cost-of-lift-1000-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-put-down-lift-1000-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-put-down-lift-1000-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (z-of-put-down-lift-1000-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-lift-1000a-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-lift-1000a-hollow-wide-00 ?o - hollow-wide-00) - number
    (z-of-lift-1000a-hollow-wide-00 ?o - hollow-wide-00) - number
    (cost-of-lift-1000a-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-put-down-lift-1000a-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-put-down-lift-1000a-hollow-wide-00 ?o - hollow-wide-00) - number
    (z-of-put-down-lift-1000a-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-lift-1001-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-lift-1001-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (z-of-lift-1001-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (cost-of-lift-1001-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-put-down-lift-1001-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-put-down-lift-1001-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (z-of-put-down-lift-1001-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-lift-1001a-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-lift-1001a-hollow-wide-00 ?o - hollow-wide-00) - number
    (z-of-lift-1001a-hollow-wide-00 ?o - hollow-wide-00) - number
    (cost-of-lift-1001a-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-put-down-lift-1001a-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-put-down-lift-1001a-hollow-wide-00 ?o - hollow-wide-00) - number
    (z-of-put-down-lift-1001a-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-lift-1001b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-lift-1001b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (z-of-lift-1001b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (cost-of-lift-1001b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-put-down-lift-1001b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-put-down-lift-1001b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (z-of-put-down-lift-1001b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-lift-1001c-solid-low-10 ?o - solid-low-10) - number
    (y-of-lift-1001c-solid-low-10 ?o - solid-low-10) - number
    (z-of-lift-1001c-solid-low-10 ?o - solid-low-10) - number
    (cost-of-lift-1001c-solid-low-10 ?o - solid-low-10) - number
    (x-of-put-down-lift-1001c-solid-low-10 ?o - solid-low-10) - number
    (y-of-put-down-lift-1001c-solid-low-10 ?o - solid-low-10) - number
    (z-of-put-down-lift-1001c-solid-low-10 ?o - solid-low-10) - number
    (x-of-lift-1001d-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-lift-1001d-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (z-of-lift-1001d-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-lift-1001d-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-put-down-lift-1001d-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-put-down-lift-1001d-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (z-of-put-down-lift-1001d-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-lift-1010-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-lift-1010-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (z-of-lift-1010-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (cost-of-lift-1010-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-put-down-lift-1010-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-put-down-lift-1010-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (z-of-put-down-lift-1010-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-lift-1010a-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-lift-1010a-hollow-wide-00 ?o - hollow-wide-00) - number
    (z-of-lift-1010a-hollow-wide-00 ?o - hollow-wide-00) - number
    (cost-of-lift-1010a-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-put-down-lift-1010a-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-put-down-lift-1010a-hollow-wide-00 ?o - hollow-wide-00) - number
    (z-of-put-down-lift-1010a-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-lift-1010b-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-lift-1010b-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (z-of-lift-1010b-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-lift-1010b-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-put-down-lift-1010b-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-put-down-lift-1010b-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (z-of-put-down-lift-1010b-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-lift-1101-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-lift-1101-hollow-wide-00 ?o - hollow-wide-00) - number
    (z-of-lift-1101-hollow-wide-00 ?o - hollow-wide-00) - number
    (cost-of-lift-1101-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-put-down-lift-1101-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-put-down-lift-1101-hollow-wide-00 ?o - hollow-wide-00) - number
    (z-of-put-down-lift-1101-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-lift-1101a-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-lift-1101a-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (z-of-lift-1101a-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-lift-1101a-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-put-down-lift-1101a-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-put-down-lift-1101a-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (z-of-put-down-lift-1101a-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-place-back-0000-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-place-back-0000-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (cost-of-place-back-0000-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-place-back-right-0000-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-place-back-right-0000-hollow-wide-00 ?o - hollow-wide-00) - number
    (cost-of-place-back-right-0000-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-place-forward-right-0111d-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-place-forward-right-0111d-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-place-forward-right-0111d-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-place-right-0111-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-place-right-0111-hollow-wide-00 ?o - hollow-wide-00) - number
    (cost-of-place-right-0111-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-place-right-0111a-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-place-right-0111a-hollow-wide-00 ?o - hollow-wide-00) - number
    (cost-of-place-right-0111a-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-place-right-0111b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-place-right-0111b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (cost-of-place-right-0111b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-pull-0000b-solid-low-10 ?o - solid-low-10) - number
    (y-of-pull-0000b-solid-low-10 ?o - solid-low-10) - number
    (cost-of-pull-0000b-solid-low-10 ?o - solid-low-10) - number
    (x-of-pull-0100-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-pull-0100-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-pull-0100-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-pull-0100-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-pull-0100-hollow-wide-00 ?o - hollow-wide-00) - number
    (cost-of-pull-0100-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-pull-0100-solid-low-10 ?o - solid-low-10) - number
    (y-of-pull-0100-solid-low-10 ?o - solid-low-10) - number
    (cost-of-pull-0100-solid-low-10 ?o - solid-low-10) - number
    (x-of-pull-0100c-solid-low-10 ?o - solid-low-10) - number
    (y-of-pull-0100c-solid-low-10 ?o - solid-low-10) - number
    (cost-of-pull-0100c-solid-low-10 ?o - solid-low-10) - number
    (x-of-pull-0110c-solid-low-10 ?o - solid-low-10) - number
    (y-of-pull-0110c-solid-low-10 ?o - solid-low-10) - number
    (cost-of-pull-0110c-solid-low-10 ?o - solid-low-10) - number
    (x-of-pull-0110d-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-pull-0110d-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-pull-0110d-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-pull-1100b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-pull-1100b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (cost-of-pull-1100b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-pull-left-0110a-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-pull-left-0110a-hollow-wide-00 ?o - hollow-wide-00) - number
    (cost-of-pull-left-0110a-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-pull-left-1110c-solid-low-10 ?o - solid-low-10) - number
    (y-of-pull-left-1110c-solid-low-10 ?o - solid-low-10) - number
    (cost-of-pull-left-1110c-solid-low-10 ?o - solid-low-10) - number
    (x-of-pull-left-1110d-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-pull-left-1110d-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-pull-left-1110d-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-pull-right-0011c-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-pull-right-0011c-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-pull-right-0011c-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-pull-right-0100a-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-pull-right-0100a-hollow-wide-00 ?o - hollow-wide-00) - number
    (cost-of-pull-right-0100a-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-pull-right-0100b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-pull-right-0100b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (cost-of-pull-right-0100b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-pull-right-0100d-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-pull-right-0100d-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-pull-right-0100d-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-pull-right-0110-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-pull-right-0110-hollow-wide-00 ?o - hollow-wide-00) - number
    (cost-of-pull-right-0110-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-pull-right-0110b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-pull-right-0110b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (cost-of-pull-right-0110b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-pull-right-0111-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-pull-right-0111-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (cost-of-pull-right-0111-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-push-forward-0101c-solid-low-10 ?o - solid-low-10) - number
    (y-of-push-forward-0101c-solid-low-10 ?o - solid-low-10) - number
    (cost-of-push-forward-0101c-solid-low-10 ?o - solid-low-10) - number
    (x-of-push-forward-1011-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-push-forward-1011-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-push-forward-1011-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-push-forward-1011-solid-low-10 ?o - solid-low-10) - number
    (y-of-push-forward-1011-solid-low-10 ?o - solid-low-10) - number
    (cost-of-push-forward-1011-solid-low-10 ?o - solid-low-10) - number
    (x-of-push-forward-1011-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-push-forward-1011-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (cost-of-push-forward-1011-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-push-forward-1011a-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-push-forward-1011a-hollow-wide-00 ?o - hollow-wide-00) - number
    (cost-of-push-forward-1011a-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-push-forward-1011b-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-push-forward-1011b-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-push-forward-1011b-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-push-forward-1110a-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-push-forward-1110a-hollow-wide-00 ?o - hollow-wide-00) - number
    (cost-of-push-forward-1110a-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-push-forward-1111b-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-push-forward-1111b-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-push-forward-1111b-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-push-forward-left-1001c-solid-low-10 ?o - solid-low-10) - number
    (y-of-push-forward-left-1001c-solid-low-10 ?o - solid-low-10) - number
    (cost-of-push-forward-left-1001c-solid-low-10 ?o - solid-low-10) - number
    (x-of-push-forward-left-1010-solid-low-10 ?o - solid-low-10) - number
    (y-of-push-forward-left-1010-solid-low-10 ?o - solid-low-10) - number
    (cost-of-push-forward-left-1010-solid-low-10 ?o - solid-low-10) - number
    (x-of-push-forward-left-1100c-solid-low-10 ?o - solid-low-10) - number
    (y-of-push-forward-left-1100c-solid-low-10 ?o - solid-low-10) - number
    (cost-of-push-forward-left-1100c-solid-low-10 ?o - solid-low-10) - number
    (x-of-push-forward-left-1100d-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-push-forward-left-1100d-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-push-forward-left-1100d-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-push-forward-left-1111a-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-push-forward-left-1111a-hollow-wide-00 ?o - hollow-wide-00) - number
    (cost-of-push-forward-left-1111a-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-push-forward-right-0101a-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-push-forward-right-0101a-hollow-wide-00 ?o - hollow-wide-00) - number
    (cost-of-push-forward-right-0101a-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-push-forward-right-0111c-solid-low-10 ?o - solid-low-10) - number
    (y-of-push-forward-right-0111c-solid-low-10 ?o - solid-low-10) - number
    (cost-of-push-forward-right-0111c-solid-low-10 ?o - solid-low-10) - number
    (x-of-push-forward-right-1111-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-push-forward-right-1111-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-push-forward-right-1111-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-push-forward-right-1111-solid-low-10 ?o - solid-low-10) - number
    (y-of-push-forward-right-1111-solid-low-10 ?o - solid-low-10) - number
    (cost-of-push-forward-right-1111-solid-low-10 ?o - solid-low-10) - number
    (x-of-push-forward-right-1111-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-push-forward-right-1111-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (cost-of-push-forward-right-1111-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-push-left-0110-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-push-left-0110-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (cost-of-push-left-0110-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-push-left-1000-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-push-left-1000-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-push-left-1000-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-push-left-1000-solid-low-10 ?o - solid-low-10) - number
    (y-of-push-left-1000-solid-low-10 ?o - solid-low-10) - number
    (cost-of-push-left-1000-solid-low-10 ?o - solid-low-10) - number
    (x-of-push-left-1100a-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-push-left-1100a-hollow-wide-00 ?o - hollow-wide-00) - number
    (cost-of-push-left-1100a-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-push-left-1101-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-push-left-1101-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (cost-of-push-left-1101-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-push-left-1101a-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-push-left-1101a-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-push-left-1101a-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-push-left-1110b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-push-left-1110b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (cost-of-push-left-1110b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-push-right-0001-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-push-right-0001-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-push-right-0001-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-push-right-0001a-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-push-right-0001a-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-push-right-0001a-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-push-right-0001b-solid-low-10 ?o - solid-low-10) - number
    (y-of-push-right-0001b-solid-low-10 ?o - solid-low-10) - number
    (cost-of-push-right-0001b-solid-low-10 ?o - solid-low-10) - number
    (x-of-push-right-0010-solid-low-10 ?o - solid-low-10) - number
    (y-of-push-right-0010-solid-low-10 ?o - solid-low-10) - number
    (cost-of-push-right-0010-solid-low-10 ?o - solid-low-10) - number
    (x-of-push-right-0010a-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-push-right-0010a-hollow-wide-00 ?o - hollow-wide-00) - number
    (cost-of-push-right-0010a-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-push-right-0011-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-push-right-0011-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-push-right-0011-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-push-right-0011-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-push-right-0011-hollow-wide-00 ?o - hollow-wide-00) - number
    (cost-of-push-right-0011-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-push-right-0011-solid-low-10 ?o - solid-low-10) - number
    (y-of-push-right-0011-solid-low-10 ?o - solid-low-10) - number
    (cost-of-push-right-0011-solid-low-10 ?o - solid-low-10) - number
    (x-of-push-right-0101b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-push-right-0101b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (cost-of-push-right-0101b-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-push-right-0101d-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-push-right-0101d-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-push-right-0101d-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-push-right-0111-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (y-of-push-right-0111-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (cost-of-push-right-0111-any-tall-narrow-11 ?o - any-tall-narrow-11) - number
    (x-of-push-right-1001-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (y-of-push-right-1001-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (cost-of-push-right-1001-solid-low-narrow-01 ?o - solid-low-narrow-01) - number
    (x-of-push-right-1101-hollow-wide-00 ?o - hollow-wide-00) - number
    (y-of-push-right-1101-hollow-wide-00 ?o - hollow-wide-00) - number
    (cost-of-push-right-1101-hollow-wide-00 ?o - hollow-wide-00) - number
    (x-of-stay-1101-solid-low-10 ?o - solid-low-10) - number
    (y-of-stay-1101-solid-low-10 ?o - solid-low-10) - number
    (cost-of-stay-1101-solid-low-10 ?o - solid-low-10) - number)

  ; Primitive 0000 on category 00 (hollow-wide-00); ends held in 10 of 30 rehearsals (33%).
  ; Effect (-48.8, -65, 185) mm, spread (29.7, 21.2, 39) mm; 8 of 30 rehearsals as promised: cost 128.
  ; Action parameters: 0.0484 0.0193 0.0055 0.7430 0.0332 -0.0492 0.0074 0.7183 -0.0492 -0.0007 0.0086
  ; 0.2191
  ; It turned the object by over 15 degrees in 11 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-0000-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (hand-empty) (can-lift-0000-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-lift-0000-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0000-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0000-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0000-hollow-wide-00 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0000-hollow-wide-00 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0000-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0000-hollow-wide-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0000-hollow-wide-00 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0000-hollow-wide-00 ?o))))

  ; Put down what lift-0000-hollow-wide-00 lifted.
  (:action put-down-lift-0000-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (held-by-lift-0000-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0000-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0000-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0000-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0000-hollow-wide-00 ?o)) 15994))
    :effect (and (not (held-by-lift-0000-hollow-wide-00 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0000-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0000-hollow-wide-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0000-hollow-wide-00 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0000 on category 01 (solid-low-narrow-01); ends held in 25 of 30 rehearsals (83%).
  ; Effect (-81.4, -6.7, 201.5) mm, spread (12.7, 8.5, 1.2) mm; 24 of 30 rehearsals as promised: cost 26.
  ; Action parameters: 0.0484 0.0193 0.0055 0.7430 0.0332 -0.0492 0.0074 0.7183 -0.0492 -0.0007 0.0086
  ; 0.2191
  ; It turned the object by over 15 degrees in 2 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-0000-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (hand-empty) (can-lift-0000-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-lift-0000-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0000-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0000-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0000-solid-low-narrow-01 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0000-solid-low-narrow-01 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0000-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0000-solid-low-narrow-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0000-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0000-solid-low-narrow-01 ?o))))

  ; Put down what lift-0000-solid-low-narrow-01 lifted.
  (:action put-down-lift-0000-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (held-by-lift-0000-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0000-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0000-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0000-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0000-solid-low-narrow-01 ?o)) 15994))
    :effect (and (not (held-by-lift-0000-solid-low-narrow-01 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0000-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0000-solid-low-narrow-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0000-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0000 on category 01 (solid-low-narrow-01); ends held in 30 of 30 rehearsals (100%).
  ; Effect (-50.5, 25.2, 248.4) mm, spread (0.4, 0.7, 5.3) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0022 0.0004 -0.0129 0.9010 0.0142 -0.0232 -0.0131 0.7599 -0.0363 0.0279 0.0437
  ; 0.1615
  ; What it promises for an object stands in the problem.
  (:action lift-0000a-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (hand-empty) (can-lift-0000a-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-lift-0000a-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0000a-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0000a-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0000a-solid-low-narrow-01 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0000a-solid-low-narrow-01 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0000a-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0000a-solid-low-narrow-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0000a-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0000a-solid-low-narrow-01 ?o))))

  ; Put down what lift-0000a-solid-low-narrow-01 lifted.
  (:action put-down-lift-0000a-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (held-by-lift-0000a-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0000a-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0000a-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0000a-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0000a-solid-low-narrow-01 ?o)) 15994))
    :effect (and (not (held-by-lift-0000a-solid-low-narrow-01 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0000a-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0000a-solid-low-narrow-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0000a-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0000 on category 11 (any-tall-narrow-11); ends held in 30 of 30 rehearsals (100%).
  ; Effect (-55.9, 48.4, 202.3) mm, spread (0.3, 0.7, 3) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0103 0.0032 -0.0220 0.6951 0.0433 -0.0027 0.0178 0.4789 -0.0459 0.0498 -0.0142
  ; 0.3510
  ; What it promises for an object stands in the problem.
  (:action lift-0000c-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-lift-0000c-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-0000c-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0000c-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0000c-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0000c-any-tall-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0000c-any-tall-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0000c-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0000c-any-tall-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0000c-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0000c-any-tall-narrow-11 ?o))))

  ; Put down what lift-0000c-any-tall-narrow-11 lifted.
  (:action put-down-lift-0000c-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (held-by-lift-0000c-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0000c-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0000c-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0000c-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0000c-any-tall-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-0000c-any-tall-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0000c-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0000c-any-tall-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0000c-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0001 on category 11 (any-tall-narrow-11); ends held in 22 of 30 rehearsals (73%).
  ; Effect (-31.1, -65.1, 245.2) mm, spread (5.8, 24.2, 4) mm; 22 of 30 rehearsals as promised: cost 34.
  ; Action parameters: -0.0016 0.0334 -0.0112 0.6225 -0.0371 0.0340 -0.0032 0.3549 -0.0335 -0.0187 0.0376
  ; 0.4440
  ; What it promises for an object stands in the problem.
  (:action lift-0001-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-lift-0001-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-0001-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0001-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0001-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0001-any-tall-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0001-any-tall-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0001-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0001-any-tall-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0001-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0001-any-tall-narrow-11 ?o))))

  ; Put down what lift-0001-any-tall-narrow-11 lifted.
  (:action put-down-lift-0001-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (held-by-lift-0001-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0001-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0001-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0001-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0001-any-tall-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-0001-any-tall-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0001-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0001-any-tall-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0001-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0001 on category 00 (hollow-wide-00); ends held in 30 of 30 rehearsals (100%).
  ; Effect (-34.2, -95.3, 243.6) mm, spread (1.5, 8.2, 9) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0016 0.0334 -0.0112 0.6225 -0.0371 0.0340 -0.0032 0.3549 -0.0335 -0.0187 0.0376
  ; 0.4440
  ; What it promises for an object stands in the problem.
  (:action lift-0001-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (hand-empty) (can-lift-0001-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-lift-0001-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0001-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0001-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0001-hollow-wide-00 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0001-hollow-wide-00 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0001-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0001-hollow-wide-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0001-hollow-wide-00 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0001-hollow-wide-00 ?o))))

  ; Put down what lift-0001-hollow-wide-00 lifted.
  (:action put-down-lift-0001-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (held-by-lift-0001-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0001-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0001-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0001-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0001-hollow-wide-00 ?o)) 15994))
    :effect (and (not (held-by-lift-0001-hollow-wide-00 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0001-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0001-hollow-wide-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0001-hollow-wide-00 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0001 on category 01 (solid-low-narrow-01); ends held in 28 of 30 rehearsals (93%).
  ; Effect (-31.6, -21.5, 241.5) mm, spread (0.2, 0.7, 4.7) mm; 28 of 30 rehearsals as promised: cost 11.
  ; Action parameters: -0.0016 0.0334 -0.0112 0.6225 -0.0371 0.0340 -0.0032 0.3549 -0.0335 -0.0187 0.0376
  ; 0.4440
  ; What it promises for an object stands in the problem.
  (:action lift-0001-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (hand-empty) (can-lift-0001-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-lift-0001-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0001-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0001-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0001-solid-low-narrow-01 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0001-solid-low-narrow-01 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0001-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0001-solid-low-narrow-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0001-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0001-solid-low-narrow-01 ?o))))

  ; Put down what lift-0001-solid-low-narrow-01 lifted.
  (:action put-down-lift-0001-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (held-by-lift-0001-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0001-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0001-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0001-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0001-solid-low-narrow-01 ?o)) 15994))
    :effect (and (not (held-by-lift-0001-solid-low-narrow-01 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0001-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0001-solid-low-narrow-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0001-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0001 on category 11 (any-tall-narrow-11); ends held in 19 of 30 rehearsals (63%).
  ; Effect (-16.3, -23.6, 199.8) mm, spread (7.7, 17.6, 0.6) mm; 17 of 30 rehearsals as promised: cost 59.
  ; Action parameters: 0.0233 0.0146 -0.0115 0.9002 0.0329 -0.0478 0.0099 0.2202 0.0040 -0.0149 -0.0295
  ; 0.4225
  ; It turned the object by over 15 degrees in 4 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-0001a-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-lift-0001a-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-0001a-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0001a-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0001a-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0001a-any-tall-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0001a-any-tall-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0001a-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0001a-any-tall-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0001a-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0001a-any-tall-narrow-11 ?o))))

  ; Put down what lift-0001a-any-tall-narrow-11 lifted.
  (:action put-down-lift-0001a-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (held-by-lift-0001a-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0001a-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0001a-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0001a-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0001a-any-tall-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-0001a-any-tall-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0001a-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0001a-any-tall-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0001a-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0001 on category 01 (solid-low-narrow-01); ends held in 30 of 30 rehearsals (100%).
  ; Effect (-15.5, -19.9, 198.8) mm, spread (2.9, 1.8, 1.1) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0233 0.0146 -0.0115 0.9002 0.0329 -0.0478 0.0099 0.2202 0.0040 -0.0149 -0.0295
  ; 0.4225
  ; It turned the object by over 15 degrees in 1 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-0001a-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (hand-empty) (can-lift-0001a-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-lift-0001a-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0001a-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0001a-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0001a-solid-low-narrow-01 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0001a-solid-low-narrow-01 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0001a-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0001a-solid-low-narrow-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0001a-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0001a-solid-low-narrow-01 ?o))))

  ; Put down what lift-0001a-solid-low-narrow-01 lifted.
  (:action put-down-lift-0001a-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (held-by-lift-0001a-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0001a-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0001a-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0001a-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0001a-solid-low-narrow-01 ?o)) 15994))
    :effect (and (not (held-by-lift-0001a-solid-low-narrow-01 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0001a-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0001a-solid-low-narrow-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0001a-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0010 on category 10 (solid-low-10); ends held in 6 of 31 rehearsals (19%).
  ; Effect (27.4, 23.4, 232.2) mm, spread (0.1, 0.2, 3.7) mm; 6 of 31 rehearsals as promised: cost 156.
  ; Action parameters: 0.0086 0.0086 -0.0069 0.7599 0.0389 0.0416 0.0117 0.3659 0.0358 0.0251 0.0290 0.0250
  ; What it promises for an object stands in the problem.
  (:action lift-0010-solid-low-10
    :parameters (?o - solid-low-10)
    :precondition (and (hand-empty) (can-lift-0010-solid-low-10 ?o) (>= (+ (x ?o) (x-of-lift-0010-solid-low-10 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0010-solid-low-10 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0010-solid-low-10 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0010-solid-low-10 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0010-solid-low-10 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0010-solid-low-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0010-solid-low-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0010-solid-low-10 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0010-solid-low-10 ?o))))

  ; Put down what lift-0010-solid-low-10 lifted.
  (:action put-down-lift-0010-solid-low-10
    :parameters (?o - solid-low-10)
    :precondition (and (held-by-lift-0010-solid-low-10 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0010-solid-low-10 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0010-solid-low-10 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0010-solid-low-10 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0010-solid-low-10 ?o)) 15994))
    :effect (and (not (held-by-lift-0010-solid-low-10 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0010-solid-low-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0010-solid-low-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0010-solid-low-10 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0010 on category 01 (solid-low-narrow-01); ends held in 30 of 30 rehearsals (100%).
  ; Effect (27.3, 22, 232.3) mm, spread (0.1, 0.6, 3.2) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0086 0.0086 -0.0069 0.7599 0.0389 0.0416 0.0117 0.3659 0.0358 0.0251 0.0290 0.0250
  ; What it promises for an object stands in the problem.
  (:action lift-0010-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (hand-empty) (can-lift-0010-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-lift-0010-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0010-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0010-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0010-solid-low-narrow-01 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0010-solid-low-narrow-01 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0010-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0010-solid-low-narrow-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0010-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0010-solid-low-narrow-01 ?o))))

  ; Put down what lift-0010-solid-low-narrow-01 lifted.
  (:action put-down-lift-0010-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (held-by-lift-0010-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0010-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0010-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0010-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0010-solid-low-narrow-01 ?o)) 15994))
    :effect (and (not (held-by-lift-0010-solid-low-narrow-01 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0010-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0010-solid-low-narrow-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0010-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0010 on category 00 (hollow-wide-00); ends held in 17 of 30 rehearsals (57%).
  ; Effect (1.4, -34.4, 197.6) mm, spread (7.7, 13.3, 4.9) mm; 16 of 30 rehearsals as promised: cost 64.
  ; Action parameters: 0.0093 0.0175 -0.0088 0.6535 -0.0281 -0.0231 -0.0013 0.2667 0.0007 0.0472 -0.0095
  ; 0.2417
  ; What it promises for an object stands in the problem.
  (:action lift-0010a-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (hand-empty) (can-lift-0010a-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-lift-0010a-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0010a-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0010a-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0010a-hollow-wide-00 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0010a-hollow-wide-00 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0010a-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0010a-hollow-wide-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0010a-hollow-wide-00 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0010a-hollow-wide-00 ?o))))

  ; Put down what lift-0010a-hollow-wide-00 lifted.
  (:action put-down-lift-0010a-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (held-by-lift-0010a-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0010a-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0010a-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0010a-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0010a-hollow-wide-00 ?o)) 15994))
    :effect (and (not (held-by-lift-0010a-hollow-wide-00 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0010a-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0010a-hollow-wide-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0010a-hollow-wide-00 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0010 on category 11 (any-tall-narrow-11); ends held in 30 of 30 rehearsals (100%).
  ; Effect (33, 23.6, 236) mm, spread (0.2, 0.4, 2.1) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0051 -0.0004 -0.0073 0.7554 0.0394 0.0425 0.0119 0.3602 0.0379 0.0253 0.0292 0.0252
  ; What it promises for an object stands in the problem.
  (:action lift-0010b-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-lift-0010b-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-0010b-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0010b-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0010b-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0010b-any-tall-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0010b-any-tall-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0010b-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0010b-any-tall-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0010b-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0010b-any-tall-narrow-11 ?o))))

  ; Put down what lift-0010b-any-tall-narrow-11 lifted.
  (:action put-down-lift-0010b-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (held-by-lift-0010b-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0010b-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0010b-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0010b-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0010b-any-tall-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-0010b-any-tall-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0010b-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0010b-any-tall-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0010b-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0011 on category 11 (any-tall-narrow-11); ends held in 23 of 30 rehearsals (77%).
  ; Effect (35.9, -66.5, 199.7) mm, spread (4.6, 26.7, 0.9) mm; 23 of 30 rehearsals as promised: cost 30.
  ; Action parameters: -0.0053 0.0137 -0.0146 0.8551 0.0139 -0.0012 0.0184 0.3505 0.0333 -0.0478 -0.0361
  ; 0.2665
  ; What it promises for an object stands in the problem.
  (:action lift-0011-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-lift-0011-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-0011-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0011-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0011-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0011-any-tall-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0011-any-tall-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0011-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0011-any-tall-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0011-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0011-any-tall-narrow-11 ?o))))

  ; Put down what lift-0011-any-tall-narrow-11 lifted.
  (:action put-down-lift-0011-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (held-by-lift-0011-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0011-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0011-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0011-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0011-any-tall-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-0011-any-tall-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0011-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0011-any-tall-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0011-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0011 on category 00 (hollow-wide-00); ends held in 14 of 30 rehearsals (47%).
  ; Effect (30.3, -121.8, 197.8) mm, spread (5.7, 6, 4.2) mm; 14 of 30 rehearsals as promised: cost 77.
  ; Action parameters: -0.0053 0.0137 -0.0146 0.8551 0.0139 -0.0012 0.0184 0.3505 0.0333 -0.0478 -0.0361
  ; 0.2665
  ; It turned the object by over 15 degrees in 1 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-0011-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (hand-empty) (can-lift-0011-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-lift-0011-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0011-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0011-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0011-hollow-wide-00 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0011-hollow-wide-00 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0011-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0011-hollow-wide-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0011-hollow-wide-00 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0011-hollow-wide-00 ?o))))

  ; Put down what lift-0011-hollow-wide-00 lifted.
  (:action put-down-lift-0011-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (held-by-lift-0011-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0011-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0011-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0011-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0011-hollow-wide-00 ?o)) 15994))
    :effect (and (not (held-by-lift-0011-hollow-wide-00 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0011-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0011-hollow-wide-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0011-hollow-wide-00 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0011 on category 00 (hollow-wide-00); ends held in 30 of 30 rehearsals (100%).
  ; Effect (46, -80.4, 242.8) mm, spread (6, 8, 11.5) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0077 0.0447 -0.0000 0.8112 -0.0087 -0.0027 -0.0164 0.2402 0.0423 -0.0050 0.0384
  ; 0.2575
  ; It turned the object by over 15 degrees in 1 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-0011a-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (hand-empty) (can-lift-0011a-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-lift-0011a-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0011a-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0011a-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0011a-hollow-wide-00 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0011a-hollow-wide-00 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0011a-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0011a-hollow-wide-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0011a-hollow-wide-00 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0011a-hollow-wide-00 ?o))))

  ; Put down what lift-0011a-hollow-wide-00 lifted.
  (:action put-down-lift-0011a-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (held-by-lift-0011a-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0011a-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0011a-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0011a-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0011a-hollow-wide-00 ?o)) 15994))
    :effect (and (not (held-by-lift-0011a-hollow-wide-00 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0011a-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0011a-hollow-wide-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0011a-hollow-wide-00 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0011 on category 01 (solid-low-narrow-01); ends held in 30 of 30 rehearsals (100%).
  ; Effect (40.6, -43.8, 239.6) mm, spread (1.4, 1, 2.5) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0169 0.0095 0.0118 0.6253 -0.0160 0.0177 -0.0043 0.5409 0.0249 -0.0393 0.0367
  ; 0.3535
  ; What it promises for an object stands in the problem.
  (:action lift-0011b-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (hand-empty) (can-lift-0011b-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-lift-0011b-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0011b-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0011b-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0011b-solid-low-narrow-01 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0011b-solid-low-narrow-01 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0011b-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0011b-solid-low-narrow-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0011b-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0011b-solid-low-narrow-01 ?o))))

  ; Put down what lift-0011b-solid-low-narrow-01 lifted.
  (:action put-down-lift-0011b-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (held-by-lift-0011b-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0011b-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0011b-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0011b-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0011b-solid-low-narrow-01 ?o)) 15994))
    :effect (and (not (held-by-lift-0011b-solid-low-narrow-01 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0011b-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0011b-solid-low-narrow-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0011b-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0011 on category 11 (any-tall-narrow-11); ends held in 26 of 30 rehearsals (87%).
  ; Effect (-16.7, -32, 258.7) mm, spread (1, 0.5, 5) mm; 26 of 30 rehearsals as promised: cost 18.
  ; Action parameters: -0.0500 0.0039 0.0144 0.8999 0.0291 -0.0115 -0.0152 0.6832 0.0140 -0.0312 0.0480
  ; 0.1553
  ; It turned the object by over 15 degrees in 2 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-0011c-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-lift-0011c-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-0011c-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0011c-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0011c-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0011c-any-tall-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0011c-any-tall-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0011c-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0011c-any-tall-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0011c-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0011c-any-tall-narrow-11 ?o))))

  ; Put down what lift-0011c-any-tall-narrow-11 lifted.
  (:action put-down-lift-0011c-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (held-by-lift-0011c-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0011c-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0011c-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0011c-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0011c-any-tall-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-0011c-any-tall-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0011c-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0011c-any-tall-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0011c-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0110 on category 01 (solid-low-narrow-01); ends held in 7 of 30 rehearsals (23%).
  ; Effect (54.7, -8.4, 202.5) mm, spread (0.6, 0.7, 3.6) mm; 7 of 30 rehearsals as promised: cost 140.
  ; Action parameters: 0.0491 0.0022 -0.0164 0.4728 -0.0159 -0.0304 -0.0245 0.6100 0.0372 -0.0053 -0.0080
  ; 0.3281
  ; What it promises for an object stands in the problem.
  (:action lift-0110b-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (hand-empty) (can-lift-0110b-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-lift-0110b-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-0110b-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-0110b-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-0110b-solid-low-narrow-01 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-0110b-solid-low-narrow-01 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-0110b-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-0110b-solid-low-narrow-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-0110b-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) (cost-of-lift-0110b-solid-low-narrow-01 ?o))))

  ; Put down what lift-0110b-solid-low-narrow-01 lifted.
  (:action put-down-lift-0110b-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (held-by-lift-0110b-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-put-down-lift-0110b-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-0110b-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-0110b-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-0110b-solid-low-narrow-01 ?o)) 15994))
    :effect (and (not (held-by-lift-0110b-solid-low-narrow-01 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-0110b-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-0110b-solid-low-narrow-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-0110b-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1000 on category 11 (any-tall-narrow-11); ends held in 15 of 30 rehearsals (50%).
  ; Effect (-28.5, 53.6, 213.2) mm, spread (14.5, 22, 18.1) mm; 14 of 30 rehearsals as promised: cost 77.
  ; Action parameters: 0.0179 -0.0221 0.0057 0.6970 0.0085 0.0306 -0.0186 0.7946 -0.0286 0.0459 -0.0433
  ; 0.4459
  ; It turned the object by over 15 degrees in 6 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-1000-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-lift-1000-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-1000-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1000-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1000-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1000-any-tall-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1000-any-tall-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1000-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1000-any-tall-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1000-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1000-any-tall-narrow-11 ?o))))

  ; Put down what lift-1000-any-tall-narrow-11 lifted.
  (:action put-down-lift-1000-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (held-by-lift-1000-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1000-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1000-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1000-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1000-any-tall-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-1000-any-tall-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1000-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1000-any-tall-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1000-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1000 on category 00 (hollow-wide-00); ends held in 30 of 30 rehearsals (100%).
  ; Effect (-31.1, 110.1, 201.2) mm, spread (6.1, 13.9, 10.8) mm; 29 of 30 rehearsals as promised: cost 7.
  ; Action parameters: 0.0179 -0.0221 0.0057 0.6970 0.0085 0.0306 -0.0186 0.7946 -0.0286 0.0459 -0.0433
  ; 0.4459
  ; It turned the object by over 15 degrees in 11 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-1000-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (hand-empty) (can-lift-1000-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-lift-1000-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1000-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1000-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1000-hollow-wide-00 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1000-hollow-wide-00 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1000-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1000-hollow-wide-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1000-hollow-wide-00 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1000-hollow-wide-00 ?o))))

  ; Put down what lift-1000-hollow-wide-00 lifted.
  (:action put-down-lift-1000-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (held-by-lift-1000-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1000-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1000-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1000-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1000-hollow-wide-00 ?o)) 15994))
    :effect (and (not (held-by-lift-1000-hollow-wide-00 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1000-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1000-hollow-wide-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1000-hollow-wide-00 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1000 on category 01 (solid-low-narrow-01); ends held in 30 of 30 rehearsals (100%).
  ; Effect (-36.1, 43.2, 199.8) mm, spread (3.3, 0.7, 0.4) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0179 -0.0221 0.0057 0.6970 0.0085 0.0306 -0.0186 0.7946 -0.0286 0.0459 -0.0433
  ; 0.4459
  ; What it promises for an object stands in the problem.
  (:action lift-1000-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (hand-empty) (can-lift-1000-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-lift-1000-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1000-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1000-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1000-solid-low-narrow-01 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1000-solid-low-narrow-01 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1000-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1000-solid-low-narrow-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1000-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1000-solid-low-narrow-01 ?o))))

  ; Put down what lift-1000-solid-low-narrow-01 lifted.
  (:action put-down-lift-1000-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (held-by-lift-1000-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1000-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1000-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1000-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1000-solid-low-narrow-01 ?o)) 15994))
    :effect (and (not (held-by-lift-1000-solid-low-narrow-01 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1000-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1000-solid-low-narrow-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1000-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1000 on category 00 (hollow-wide-00); ends held in 30 of 30 rehearsals (100%).
  ; Effect (-41.8, 46, 240.8) mm, spread (0.6, 7.7, 8.5) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0010 -0.0456 -0.0219 0.8168 -0.0161 0.0332 0.0127 0.3042 -0.0413 -0.0196 0.0328
  ; 0.4515
  ; What it promises for an object stands in the problem.
  (:action lift-1000a-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (hand-empty) (can-lift-1000a-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-lift-1000a-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1000a-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1000a-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1000a-hollow-wide-00 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1000a-hollow-wide-00 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1000a-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1000a-hollow-wide-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1000a-hollow-wide-00 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1000a-hollow-wide-00 ?o))))

  ; Put down what lift-1000a-hollow-wide-00 lifted.
  (:action put-down-lift-1000a-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (held-by-lift-1000a-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1000a-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1000a-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1000a-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1000a-hollow-wide-00 ?o)) 15994))
    :effect (and (not (held-by-lift-1000a-hollow-wide-00 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1000a-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1000a-hollow-wide-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1000a-hollow-wide-00 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1001 on category 01 (solid-low-narrow-01); ends held in 26 of 30 rehearsals (87%).
  ; Effect (-12.3, -51, 198.5) mm, spread (8.1, 3.5, 1.5) mm; 26 of 30 rehearsals as promised: cost 18.
  ; Action parameters: -0.0359 -0.0408 -0.0143 0.7496 0.0346 0.0082 -0.0226 0.5834 0.0141 -0.0450 -0.0317
  ; 0.1350
  ; It turned the object by over 15 degrees in 5 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-1001-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (hand-empty) (can-lift-1001-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-lift-1001-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1001-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1001-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1001-solid-low-narrow-01 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1001-solid-low-narrow-01 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1001-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1001-solid-low-narrow-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1001-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1001-solid-low-narrow-01 ?o))))

  ; Put down what lift-1001-solid-low-narrow-01 lifted.
  (:action put-down-lift-1001-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (held-by-lift-1001-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1001-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1001-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1001-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1001-solid-low-narrow-01 ?o)) 15994))
    :effect (and (not (held-by-lift-1001-solid-low-narrow-01 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1001-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1001-solid-low-narrow-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1001-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1001 on category 00 (hollow-wide-00); ends held in 30 of 30 rehearsals (100%).
  ; Effect (23.9, 31.6, 213.1) mm, spread (8.8, 7.9, 5.2) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0105 -0.0498 -0.0239 0.8557 -0.0276 0.0304 -0.0049 0.9500 0.0210 -0.0340 0.0121
  ; 0.4896
  ; It turned the object by over 15 degrees in 7 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-1001a-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (hand-empty) (can-lift-1001a-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-lift-1001a-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1001a-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1001a-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1001a-hollow-wide-00 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1001a-hollow-wide-00 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1001a-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1001a-hollow-wide-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1001a-hollow-wide-00 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1001a-hollow-wide-00 ?o))))

  ; Put down what lift-1001a-hollow-wide-00 lifted.
  (:action put-down-lift-1001a-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (held-by-lift-1001a-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1001a-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1001a-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1001a-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1001a-hollow-wide-00 ?o)) 15994))
    :effect (and (not (held-by-lift-1001a-hollow-wide-00 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1001a-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1001a-hollow-wide-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1001a-hollow-wide-00 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1001 on category 01 (solid-low-narrow-01); ends held in 30 of 30 rehearsals (100%).
  ; Effect (39.4, -51.4, 200.4) mm, spread (0.9, 1.2, 0.6) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0034 -0.0169 0.0052 0.8132 -0.0097 0.0342 -0.0179 0.8576 0.0299 -0.0486 -0.0223
  ; 0.3984
  ; What it promises for an object stands in the problem.
  (:action lift-1001b-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (hand-empty) (can-lift-1001b-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-lift-1001b-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1001b-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1001b-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1001b-solid-low-narrow-01 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1001b-solid-low-narrow-01 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1001b-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1001b-solid-low-narrow-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1001b-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1001b-solid-low-narrow-01 ?o))))

  ; Put down what lift-1001b-solid-low-narrow-01 lifted.
  (:action put-down-lift-1001b-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (held-by-lift-1001b-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1001b-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1001b-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1001b-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1001b-solid-low-narrow-01 ?o)) 15994))
    :effect (and (not (held-by-lift-1001b-solid-low-narrow-01 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1001b-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1001b-solid-low-narrow-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1001b-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1001 on category 10 (solid-low-10); ends held in 5 of 31 rehearsals (16%).
  ; Effect (25.7, -51, 200.1) mm, spread (2.6, 0.6, 1.1) mm; 5 of 31 rehearsals as promised: cost 171.
  ; Action parameters: -0.0410 -0.0445 0.0025 0.6468 -0.0038 0.0172 0.0093 0.7095 0.0105 -0.0500 -0.0059
  ; 0.4198
  ; It turned the object by over 15 degrees in 13 of 31 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-1001c-solid-low-10
    :parameters (?o - solid-low-10)
    :precondition (and (hand-empty) (can-lift-1001c-solid-low-10 ?o) (>= (+ (x ?o) (x-of-lift-1001c-solid-low-10 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1001c-solid-low-10 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1001c-solid-low-10 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1001c-solid-low-10 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1001c-solid-low-10 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1001c-solid-low-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1001c-solid-low-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1001c-solid-low-10 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1001c-solid-low-10 ?o))))

  ; Put down what lift-1001c-solid-low-10 lifted.
  (:action put-down-lift-1001c-solid-low-10
    :parameters (?o - solid-low-10)
    :precondition (and (held-by-lift-1001c-solid-low-10 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1001c-solid-low-10 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1001c-solid-low-10 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1001c-solid-low-10 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1001c-solid-low-10 ?o)) 15994))
    :effect (and (not (held-by-lift-1001c-solid-low-10 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1001c-solid-low-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1001c-solid-low-10 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1001c-solid-low-10 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1001 on category 11 (any-tall-narrow-11); ends held in 29 of 30 rehearsals (97%).
  ; Effect (59.2, -45.3, 200.3) mm, spread (5.3, 1, 0.9) mm; 29 of 30 rehearsals as promised: cost 7.
  ; Action parameters: -0.0219 -0.0078 0.0012 0.6096 -0.0286 0.0076 -0.0048 0.0351 0.0367 -0.0448 -0.0398
  ; 0.3518
  ; It turned the object by over 15 degrees in 1 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-1001d-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-lift-1001d-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-1001d-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1001d-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1001d-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1001d-any-tall-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1001d-any-tall-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1001d-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1001d-any-tall-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1001d-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1001d-any-tall-narrow-11 ?o))))

  ; Put down what lift-1001d-any-tall-narrow-11 lifted.
  (:action put-down-lift-1001d-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (held-by-lift-1001d-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1001d-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1001d-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1001d-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1001d-any-tall-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-1001d-any-tall-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1001d-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1001d-any-tall-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1001d-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1010 on category 01 (solid-low-narrow-01); ends held in 30 of 30 rehearsals (100%).
  ; Effect (29, 45, 199.5) mm, spread (3, 1.7, 0.9) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0231 -0.0250 0.0148 0.7943 0.0185 0.0262 -0.0057 0.8054 0.0479 0.0490 -0.0099
  ; 0.1165
  ; It turned the object by over 15 degrees in 1 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-1010-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (hand-empty) (can-lift-1010-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-lift-1010-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1010-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1010-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1010-solid-low-narrow-01 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1010-solid-low-narrow-01 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1010-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1010-solid-low-narrow-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1010-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1010-solid-low-narrow-01 ?o))))

  ; Put down what lift-1010-solid-low-narrow-01 lifted.
  (:action put-down-lift-1010-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (held-by-lift-1010-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1010-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1010-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1010-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1010-solid-low-narrow-01 ?o)) 15994))
    :effect (and (not (held-by-lift-1010-solid-low-narrow-01 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1010-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1010-solid-low-narrow-01 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1010-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1010 on category 00 (hollow-wide-00); ends held in 30 of 30 rehearsals (100%).
  ; Effect (22.8, 101.8, 197.6) mm, spread (8.3, 7.7, 4.6) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0081 -0.0489 -0.0124 0.5433 0.0162 -0.0203 -0.0176 0.5317 0.0251 0.0373 -0.0198
  ; 0.2788
  ; It turned the object by over 15 degrees in 9 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action lift-1010a-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (hand-empty) (can-lift-1010a-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-lift-1010a-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1010a-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1010a-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1010a-hollow-wide-00 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1010a-hollow-wide-00 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1010a-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1010a-hollow-wide-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1010a-hollow-wide-00 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1010a-hollow-wide-00 ?o))))

  ; Put down what lift-1010a-hollow-wide-00 lifted.
  (:action put-down-lift-1010a-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (held-by-lift-1010a-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1010a-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1010a-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1010a-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1010a-hollow-wide-00 ?o)) 15994))
    :effect (and (not (held-by-lift-1010a-hollow-wide-00 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1010a-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1010a-hollow-wide-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1010a-hollow-wide-00 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1010 on category 11 (any-tall-narrow-11); ends held in 30 of 30 rehearsals (100%).
  ; Effect (27.8, 22.8, 200.2) mm, spread (0.2, 0.5, 0.3) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0076 -0.0029 -0.0097 0.5977 -0.0004 0.0001 -0.0116 0.9681 0.0277 0.0245 -0.0121
  ; 0.0858
  ; What it promises for an object stands in the problem.
  (:action lift-1010b-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-lift-1010b-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-1010b-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1010b-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1010b-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1010b-any-tall-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1010b-any-tall-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1010b-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1010b-any-tall-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1010b-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1010b-any-tall-narrow-11 ?o))))

  ; Put down what lift-1010b-any-tall-narrow-11 lifted.
  (:action put-down-lift-1010b-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (held-by-lift-1010b-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1010b-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1010b-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1010b-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1010b-any-tall-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-1010b-any-tall-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1010b-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1010b-any-tall-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1010b-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1101 on category 00 (hollow-wide-00); ends held in 5 of 30 rehearsals (17%).
  ; Effect (24.3, 14.7, 200.2) mm, spread (5.6, 1, 0.4) mm; 5 of 30 rehearsals as promised: cost 168.
  ; Action parameters: 0.0019 0.0106 0.0073 0.5114 -0.0018 0.0390 0.0247 0.4637 0.0367 0.0143 0.0097 0.6628
  ; What it promises for an object stands in the problem.
  (:action lift-1101-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (hand-empty) (can-lift-1101-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-lift-1101-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1101-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1101-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1101-hollow-wide-00 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1101-hollow-wide-00 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1101-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1101-hollow-wide-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1101-hollow-wide-00 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1101-hollow-wide-00 ?o))))

  ; Put down what lift-1101-hollow-wide-00 lifted.
  (:action put-down-lift-1101-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (held-by-lift-1101-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1101-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1101-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1101-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1101-hollow-wide-00 ?o)) 15994))
    :effect (and (not (held-by-lift-1101-hollow-wide-00 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1101-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1101-hollow-wide-00 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1101-hollow-wide-00 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 1101 on category 11 (any-tall-narrow-11); ends held in 6 of 30 rehearsals (20%).
  ; Effect (28.5, 26.7, 203.9) mm, spread (1.8, 0.5, 2.3) mm; 6 of 30 rehearsals as promised: cost 153.
  ; Action parameters: -0.0093 -0.0145 -0.0074 0.3785 -0.0241 0.0194 0.0233 0.7310 0.0393 0.0235 -0.0453
  ; 0.6039
  ; What it promises for an object stands in the problem.
  (:action lift-1101a-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-lift-1101a-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-lift-1101a-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-lift-1101a-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-lift-1101a-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-lift-1101a-any-tall-narrow-11 ?o)) 15994))
    :effect (and (not (hand-empty)) (held-by-lift-1101a-any-tall-narrow-11 ?o) (assign (x ?o) (- (+ (x ?o) (x-of-lift-1101a-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-lift-1101a-any-tall-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-lift-1101a-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-lift-1101a-any-tall-narrow-11 ?o))))

  ; Put down what lift-1101a-any-tall-narrow-11 lifted.
  (:action put-down-lift-1101a-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (held-by-lift-1101a-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-put-down-lift-1101a-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-put-down-lift-1101a-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-put-down-lift-1101a-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-put-down-lift-1101a-any-tall-narrow-11 ?o)) 15994))
    :effect (and (not (held-by-lift-1101a-any-tall-narrow-11 ?o)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (x-of-put-down-lift-1101a-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-put-down-lift-1101a-any-tall-narrow-11 ?o)) 10000)) (assign (z ?o) (- (+ (z ?o) (z-of-put-down-lift-1101a-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) 0)))

  ; Primitive 0000 on category 01 (solid-low-narrow-01); ends at rest in 5 of 30 rehearsals (17%).
  ; Effect (-93.5, -14.6, 0) mm, spread (7.5, 20.5, 0) mm; 5 of 30 rehearsals as promised: cost 168.
  ; Action parameters: 0.0484 0.0193 0.0055 0.7430 0.0332 -0.0492 0.0074 0.7183 -0.0492 -0.0007 0.0086
  ; 0.2191
  ; It turned the object by over 15 degrees in 2 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action place-back-0000-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (hand-empty) (can-place-back-0000-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-place-back-0000-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-place-back-0000-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-place-back-0000-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-place-back-0000-solid-low-narrow-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-place-back-0000-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-place-back-0000-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) (cost-of-place-back-0000-solid-low-narrow-01 ?o))))

  ; Primitive 0000 on category 00 (hollow-wide-00); ends at rest in 20 of 30 rehearsals (67%).
  ; Effect (-45, -45.1, 0) mm, spread (48.8, 34.3, 0) mm; 12 of 30 rehearsals as promised: cost 91.
  ; Action parameters: 0.0484 0.0193 0.0055 0.7430 0.0332 -0.0492 0.0074 0.7183 -0.0492 -0.0007 0.0086
  ; 0.2191
  ; It turned the object by over 15 degrees in 11 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action place-back-right-0000-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (hand-empty) (can-place-back-right-0000-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-place-back-right-0000-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-place-back-right-0000-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-place-back-right-0000-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-place-back-right-0000-hollow-wide-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-place-back-right-0000-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-place-back-right-0000-hollow-wide-00 ?o)) 10000)) (increase (total-cost) (cost-of-place-back-right-0000-hollow-wide-00 ?o))))

  ; Primitive 0111 on category 11 (any-tall-narrow-11); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (28.8, -31.2, 0) mm, spread (3.2, 15.3, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0164 0.0022 -0.0234 0.5350 0.0486 -0.0461 0.0139 0.1150 0.0379 -0.0030 0.0392
  ; 0.9774
  ; What it promises for an object stands in the problem.
  (:action place-forward-right-0111d-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-place-forward-right-0111d-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-place-forward-right-0111d-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-place-forward-right-0111d-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-place-forward-right-0111d-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-place-forward-right-0111d-any-tall-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-place-forward-right-0111d-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-place-forward-right-0111d-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-place-forward-right-0111d-any-tall-narrow-11 ?o))))

  ; Primitive 0111 on category 00 (hollow-wide-00); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (-35.4, -105.5, 0) mm, spread (7.8, 12.7, 0) mm; 29 of 30 rehearsals as promised: cost 7.
  ; Action parameters: -0.0074 0.0264 -0.0138 0.9402 -0.0350 -0.0346 0.0136 0.3594 -0.0142 0.0059 0.0180
  ; 0.8726
  ; What it promises for an object stands in the problem.
  (:action place-right-0111-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (hand-empty) (can-place-right-0111-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-place-right-0111-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-place-right-0111-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-place-right-0111-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-place-right-0111-hollow-wide-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-place-right-0111-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-place-right-0111-hollow-wide-00 ?o)) 10000)) (increase (total-cost) (cost-of-place-right-0111-hollow-wide-00 ?o))))

  ; Primitive 0111 on category 00 (hollow-wide-00); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (16.3, -101.6, 0) mm, spread (7.6, 7.6, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0098 0.0456 -0.0142 0.8802 0.0140 -0.0297 0.0118 0.3647 -0.0404 -0.0245 0.0496
  ; 0.7736
  ; What it promises for an object stands in the problem.
  (:action place-right-0111a-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (hand-empty) (can-place-right-0111a-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-place-right-0111a-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-place-right-0111a-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-place-right-0111a-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-place-right-0111a-hollow-wide-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-place-right-0111a-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-place-right-0111a-hollow-wide-00 ?o)) 10000)) (increase (total-cost) (cost-of-place-right-0111a-hollow-wide-00 ?o))))

  ; Primitive 0111 on category 01 (solid-low-narrow-01); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (14, -53, 0) mm, spread (0.9, 3.1, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0271 0.0206 -0.0232 0.5279 0.0418 -0.0496 0.0139 0.1152 0.0364 -0.0077 0.0393
  ; 0.9773
  ; It turned the object by over 15 degrees in 1 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action place-right-0111b-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (hand-empty) (can-place-right-0111b-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-place-right-0111b-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-place-right-0111b-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-place-right-0111b-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-place-right-0111b-solid-low-narrow-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-place-right-0111b-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-place-right-0111b-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) (cost-of-place-right-0111b-solid-low-narrow-01 ?o))))

  ; Primitive 0000 on category 10 (solid-low-10); ends at rest in 31 of 31 rehearsals (100%).
  ; Effect (-43.6, -13.5, 0) mm, spread (25.8, 15.6, 0) mm; 29 of 31 rehearsals as promised: cost 11.
  ; Action parameters: 0.0412 0.0172 0.0184 0.9864 -0.0277 -0.0230 -0.0217 0.1692 -0.0465 0.0011 0.0453
  ; 0.2951
  ; What it promises for an object stands in the problem.
  (:action pull-0000b-solid-low-10
    :parameters (?o - solid-low-10)
    :precondition (and (hand-empty) (can-pull-0000b-solid-low-10 ?o) (>= (+ (x ?o) (x-of-pull-0000b-solid-low-10 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-0000b-solid-low-10 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-0000b-solid-low-10 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-0000b-solid-low-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-0000b-solid-low-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-0000b-solid-low-10 ?o)) 10000)) (increase (total-cost) (cost-of-pull-0000b-solid-low-10 ?o))))

  ; Primitive 0100 on category 11 (any-tall-narrow-11); ends at rest in 28 of 30 rehearsals (93%).
  ; Effect (-98.8, -20, 0) mm, spread (13.8, 15.9, 0) mm; 27 of 30 rehearsals as promised: cost 14.
  ; Action parameters: 0.0492 -0.0078 0.0122 0.9578 -0.0457 -0.0328 0.0023 0.1346 -0.0152 0.0005 -0.0119
  ; 0.9925
  ; It turned the object by over 15 degrees in 3 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action pull-0100-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-pull-0100-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-pull-0100-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-0100-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-0100-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-0100-any-tall-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-0100-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-0100-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-pull-0100-any-tall-narrow-11 ?o))))

  ; Primitive 0100 on category 00 (hollow-wide-00); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (-64.9, -1.9, 0) mm, spread (46.9, 20.5, 0) mm; 15 of 30 rehearsals as promised: cost 70.
  ; Action parameters: 0.0492 -0.0078 0.0122 0.9578 -0.0457 -0.0328 0.0023 0.1346 -0.0152 0.0005 -0.0119
  ; 0.9925
  ; What it promises for an object stands in the problem.
  (:action pull-0100-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (hand-empty) (can-pull-0100-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-pull-0100-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-0100-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-0100-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-0100-hollow-wide-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-0100-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-0100-hollow-wide-00 ?o)) 10000)) (increase (total-cost) (cost-of-pull-0100-hollow-wide-00 ?o))))

  ; Primitive 0100 on category 10 (solid-low-10); ends at rest in 30 of 31 rehearsals (97%).
  ; Effect (-69.1, -5, 0) mm, spread (27.4, 5.9, 0) mm; 27 of 31 rehearsals as promised: cost 17.
  ; Action parameters: 0.0492 -0.0078 0.0122 0.9578 -0.0457 -0.0328 0.0023 0.1346 -0.0152 0.0005 -0.0119
  ; 0.9925
  ; It turned the object by over 15 degrees in 1 of 31 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action pull-0100-solid-low-10
    :parameters (?o - solid-low-10)
    :precondition (and (hand-empty) (can-pull-0100-solid-low-10 ?o) (>= (+ (x ?o) (x-of-pull-0100-solid-low-10 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-0100-solid-low-10 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-0100-solid-low-10 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-0100-solid-low-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-0100-solid-low-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-0100-solid-low-10 ?o)) 10000)) (increase (total-cost) (cost-of-pull-0100-solid-low-10 ?o))))

  ; Primitive 0100 on category 10 (solid-low-10); ends at rest in 31 of 31 rehearsals (100%).
  ; Effect (-63.7, 21.7, 0) mm, spread (25.6, 23.1, 0) mm; 26 of 31 rehearsals as promised: cost 21.
  ; Action parameters: 0.0500 0.0014 0.0042 0.6975 0.0024 -0.0349 -0.0111 0.1735 -0.0389 0.0312 -0.0235
  ; 0.6523
  ; What it promises for an object stands in the problem.
  (:action pull-0100c-solid-low-10
    :parameters (?o - solid-low-10)
    :precondition (and (hand-empty) (can-pull-0100c-solid-low-10 ?o) (>= (+ (x ?o) (x-of-pull-0100c-solid-low-10 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-0100c-solid-low-10 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-0100c-solid-low-10 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-0100c-solid-low-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-0100c-solid-low-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-0100c-solid-low-10 ?o)) 10000)) (increase (total-cost) (cost-of-pull-0100c-solid-low-10 ?o))))

  ; Primitive 0110 on category 10 (solid-low-10); ends at rest in 30 of 31 rehearsals (97%).
  ; Effect (-27.3, -3.9, 0) mm, spread (20.5, 13, 0) mm; 28 of 31 rehearsals as promised: cost 14.
  ; Action parameters: 0.0340 0.0219 -0.0218 0.7200 0.0261 0.0457 0.0106 0.5018 -0.0371 -0.0095 0.0243
  ; 0.6066
  ; It turned the object by over 15 degrees in 4 of 31 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action pull-0110c-solid-low-10
    :parameters (?o - solid-low-10)
    :precondition (and (hand-empty) (can-pull-0110c-solid-low-10 ?o) (>= (+ (x ?o) (x-of-pull-0110c-solid-low-10 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-0110c-solid-low-10 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-0110c-solid-low-10 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-0110c-solid-low-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-0110c-solid-low-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-0110c-solid-low-10 ?o)) 10000)) (increase (total-cost) (cost-of-pull-0110c-solid-low-10 ?o))))

  ; Primitive 0110 on category 11 (any-tall-narrow-11); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (-17.7, -5.3, 0) mm, spread (13.2, 2.9, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0193 0.0011 0.0024 0.1026 0.0156 -0.0188 0.0073 0.9641 -0.0434 -0.0074 -0.0068
  ; 0.9806
  ; What it promises for an object stands in the problem.
  (:action pull-0110d-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-pull-0110d-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-pull-0110d-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-0110d-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-0110d-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-0110d-any-tall-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-0110d-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-0110d-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-pull-0110d-any-tall-narrow-11 ?o))))

  ; Primitive 1100 on category 01 (solid-low-narrow-01); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (-57.9, 16.7, 0) mm, spread (0.1, 0.4, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0108 -0.0231 -0.0247 0.8018 -0.0470 0.0179 -0.0040 0.4497 0.0236 0.0062 0.0057
  ; 0.7364
  ; What it promises for an object stands in the problem.
  (:action pull-1100b-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (hand-empty) (can-pull-1100b-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-pull-1100b-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-1100b-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-1100b-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-1100b-solid-low-narrow-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-1100b-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-1100b-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) (cost-of-pull-1100b-solid-low-narrow-01 ?o))))

  ; Primitive 0110 on category 00 (hollow-wide-00); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (-24.6, 24.8, 0) mm, spread (8.8, 4.7, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0166 0.0234 -0.0216 0.1124 -0.0106 0.0017 -0.0015 0.0057 -0.0460 0.0303 0.0380
  ; 0.8147
  ; What it promises for an object stands in the problem.
  (:action pull-left-0110a-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (hand-empty) (can-pull-left-0110a-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-pull-left-0110a-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-left-0110a-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-left-0110a-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-left-0110a-hollow-wide-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-left-0110a-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-left-0110a-hollow-wide-00 ?o)) 10000)) (increase (total-cost) (cost-of-pull-left-0110a-hollow-wide-00 ?o))))

  ; Primitive 1110 on category 10 (solid-low-10); ends at rest in 31 of 31 rehearsals (100%).
  ; Effect (-30.8, 22.1, 0) mm, spread (24.1, 17.4, 0) mm; 30 of 31 rehearsals as promised: cost 7.
  ; Action parameters: 0.0448 -0.0479 0.0209 0.2730 0.0492 -0.0347 -0.0174 0.0270 -0.0438 0.0487 0.0290
  ; 0.9723
  ; It turned the object by over 15 degrees in 2 of 31 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action pull-left-1110c-solid-low-10
    :parameters (?o - solid-low-10)
    :precondition (and (hand-empty) (can-pull-left-1110c-solid-low-10 ?o) (>= (+ (x ?o) (x-of-pull-left-1110c-solid-low-10 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-left-1110c-solid-low-10 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-left-1110c-solid-low-10 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-left-1110c-solid-low-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-left-1110c-solid-low-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-left-1110c-solid-low-10 ?o)) 10000)) (increase (total-cost) (cost-of-pull-left-1110c-solid-low-10 ?o))))

  ; Primitive 1110 on category 11 (any-tall-narrow-11); ends at rest in 29 of 30 rehearsals (97%).
  ; Effect (-32.8, 36.9, 0) mm, spread (27, 39.6, 0) mm; 22 of 30 rehearsals as promised: cost 34.
  ; Action parameters: 0.0341 -0.0486 -0.0031 0.1799 -0.0482 0.0261 0.0175 0.2515 0.0038 0.0412 -0.0425
  ; 0.9612
  ; It turned the object by over 15 degrees in 1 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action pull-left-1110d-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-pull-left-1110d-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-pull-left-1110d-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-left-1110d-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-left-1110d-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-left-1110d-any-tall-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-left-1110d-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-left-1110d-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-pull-left-1110d-any-tall-narrow-11 ?o))))

  ; Primitive 0011 on category 11 (any-tall-narrow-11); ends at rest in 4 of 30 rehearsals (13%).
  ; Effect (-16.7, -31, 0) mm, spread (9.4, 19.5, 0) mm; 4 of 30 rehearsals as promised: cost 187.
  ; Action parameters: -0.0500 0.0039 0.0144 0.8999 0.0291 -0.0115 -0.0152 0.6832 0.0140 -0.0312 0.0480
  ; 0.1553
  ; It turned the object by over 15 degrees in 2 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action pull-right-0011c-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-pull-right-0011c-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-pull-right-0011c-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-right-0011c-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-right-0011c-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-right-0011c-any-tall-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-right-0011c-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-right-0011c-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-pull-right-0011c-any-tall-narrow-11 ?o))))

  ; Primitive 0100 on category 00 (hollow-wide-00); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (-29.4, -30.7, 0) mm, spread (8.9, 3.9, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0250 0.0269 -0.0208 0.2563 -0.0441 -0.0491 -0.0093 0.0800 -0.0404 -0.0346 -0.0258
  ; 0.9761
  ; It turned the object by over 15 degrees in 7 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action pull-right-0100a-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (hand-empty) (can-pull-right-0100a-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-pull-right-0100a-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-right-0100a-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-right-0100a-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-right-0100a-hollow-wide-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-right-0100a-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-right-0100a-hollow-wide-00 ?o)) 10000)) (increase (total-cost) (cost-of-pull-right-0100a-hollow-wide-00 ?o))))

  ; Primitive 0100 on category 01 (solid-low-narrow-01); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (-69.3, -36.7, 0) mm, spread (2.8, 0.5, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0226 -0.0080 0.0025 0.9776 -0.0500 -0.0354 -0.0091 0.2216 -0.0500 -0.0199 0.0068
  ; 0.6903
  ; What it promises for an object stands in the problem.
  (:action pull-right-0100b-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (hand-empty) (can-pull-right-0100b-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-pull-right-0100b-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-right-0100b-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-right-0100b-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-right-0100b-solid-low-narrow-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-right-0100b-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-right-0100b-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) (cost-of-pull-right-0100b-solid-low-narrow-01 ?o))))

  ; Primitive 0100 on category 11 (any-tall-narrow-11); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (-53.3, -30.3, 0) mm, spread (2.9, 5.9, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0109 -0.0016 0.0056 0.9778 -0.0500 -0.0348 -0.0106 0.2344 -0.0500 -0.0205 0.0064
  ; 0.7141
  ; What it promises for an object stands in the problem.
  (:action pull-right-0100d-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-pull-right-0100d-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-pull-right-0100d-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-right-0100d-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-right-0100d-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-right-0100d-any-tall-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-right-0100d-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-right-0100d-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-pull-right-0100d-any-tall-narrow-11 ?o))))

  ; Primitive 0110 on category 00 (hollow-wide-00); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (-16.6, -17.2, 0) mm, spread (22, 24, 0) mm; 28 of 30 rehearsals as promised: cost 11.
  ; Action parameters: 0.0419 -0.0446 -0.0057 0.4221 -0.0148 -0.0380 0.0098 0.7770 -0.0286 -0.0447 -0.0217
  ; 0.9215
  ; What it promises for an object stands in the problem.
  (:action pull-right-0110-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (hand-empty) (can-pull-right-0110-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-pull-right-0110-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-right-0110-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-right-0110-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-right-0110-hollow-wide-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-right-0110-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-right-0110-hollow-wide-00 ?o)) 10000)) (increase (total-cost) (cost-of-pull-right-0110-hollow-wide-00 ?o))))

  ; Primitive 0110 on category 01 (solid-low-narrow-01); ends at rest in 23 of 30 rehearsals (77%).
  ; Effect (-13.7, -7.3, 0) mm, spread (9.4, 4.4, 0) mm; 23 of 30 rehearsals as promised: cost 30.
  ; Action parameters: 0.0491 0.0022 -0.0164 0.4728 -0.0159 -0.0304 -0.0245 0.6100 0.0372 -0.0053 -0.0080
  ; 0.3281
  ; What it promises for an object stands in the problem.
  (:action pull-right-0110b-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (hand-empty) (can-pull-right-0110b-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-pull-right-0110b-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-right-0110b-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-right-0110b-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-right-0110b-solid-low-narrow-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-right-0110b-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-right-0110b-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) (cost-of-pull-right-0110b-solid-low-narrow-01 ?o))))

  ; Primitive 0111 on category 01 (solid-low-narrow-01); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (-26.7, -34.7, 0) mm, spread (1.1, 3.8, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0074 0.0264 -0.0138 0.9402 -0.0350 -0.0346 0.0136 0.3594 -0.0142 0.0059 0.0180
  ; 0.8726
  ; What it promises for an object stands in the problem.
  (:action pull-right-0111-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (hand-empty) (can-pull-right-0111-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-pull-right-0111-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-pull-right-0111-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-pull-right-0111-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-pull-right-0111-solid-low-narrow-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-pull-right-0111-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-pull-right-0111-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) (cost-of-pull-right-0111-solid-low-narrow-01 ?o))))

  ; Primitive 0101 on category 10 (solid-low-10); ends at rest in 30 of 31 rehearsals (97%).
  ; Effect (34.5, -7.5, 0) mm, spread (19.7, 23.7, 0) mm; 28 of 31 rehearsals as promised: cost 14.
  ; Action parameters: -0.0500 0.0497 -0.0069 0.0245 0.0167 -0.0366 0.0237 0.4788 0.0037 0.0137 0.0066
  ; 0.6419
  ; It turned the object by over 15 degrees in 1 of 31 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-forward-0101c-solid-low-10
    :parameters (?o - solid-low-10)
    :precondition (and (hand-empty) (can-push-forward-0101c-solid-low-10 ?o) (>= (+ (x ?o) (x-of-push-forward-0101c-solid-low-10 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-0101c-solid-low-10 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-0101c-solid-low-10 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-0101c-solid-low-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-0101c-solid-low-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-0101c-solid-low-10 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-0101c-solid-low-10 ?o))))

  ; Primitive 1011 on category 11 (any-tall-narrow-11); ends at rest in 29 of 30 rehearsals (97%).
  ; Effect (104.7, 20.4, 0) mm, spread (13, 13.9, 0) mm; 29 of 30 rehearsals as promised: cost 7.
  ; Action parameters: -0.0500 0.0037 0.0051 1.0000 0.0500 0.0286 0.0010 0.1718 0.0311 0.0036 0.0114 0.8945
  ; It turned the object by over 15 degrees in 3 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-forward-1011-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-push-forward-1011-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-push-forward-1011-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-1011-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-1011-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-1011-any-tall-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-1011-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-1011-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-1011-any-tall-narrow-11 ?o))))

  ; Primitive 1011 on category 10 (solid-low-10); ends at rest in 31 of 31 rehearsals (100%).
  ; Effect (80.3, 6.8, 0) mm, spread (26.2, 16.6, 0) mm; 27 of 31 rehearsals as promised: cost 17.
  ; Action parameters: -0.0500 0.0037 0.0051 1.0000 0.0500 0.0286 0.0010 0.1718 0.0311 0.0036 0.0114 0.8945
  ; What it promises for an object stands in the problem.
  (:action push-forward-1011-solid-low-10
    :parameters (?o - solid-low-10)
    :precondition (and (hand-empty) (can-push-forward-1011-solid-low-10 ?o) (>= (+ (x ?o) (x-of-push-forward-1011-solid-low-10 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-1011-solid-low-10 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-1011-solid-low-10 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-1011-solid-low-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-1011-solid-low-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-1011-solid-low-10 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-1011-solid-low-10 ?o))))

  ; Primitive 1011 on category 01 (solid-low-narrow-01); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (98.4, 25.3, 0) mm, spread (5.2, 2.4, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0500 0.0037 0.0051 1.0000 0.0500 0.0286 0.0010 0.1718 0.0311 0.0036 0.0114 0.8945
  ; It turned the object by over 15 degrees in 1 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-forward-1011-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (hand-empty) (can-push-forward-1011-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-push-forward-1011-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-1011-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-1011-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-1011-solid-low-narrow-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-1011-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-1011-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-1011-solid-low-narrow-01 ?o))))

  ; Primitive 1011 on category 00 (hollow-wide-00); ends at rest in 29 of 30 rehearsals (97%).
  ; Effect (71.8, -2.3, 0) mm, spread (43.8, 14.1, 0) mm; 18 of 30 rehearsals as promised: cost 53.
  ; Action parameters: -0.0500 -0.0056 -0.0209 0.6996 0.0375 0.0096 0.0105 0.0889 0.0317 -0.0300 0.0285
  ; 1.0000
  ; What it promises for an object stands in the problem.
  (:action push-forward-1011a-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (hand-empty) (can-push-forward-1011a-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-push-forward-1011a-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-1011a-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-1011a-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-1011a-hollow-wide-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-1011a-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-1011a-hollow-wide-00 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-1011a-hollow-wide-00 ?o))))

  ; Primitive 1011 on category 11 (any-tall-narrow-11); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (79.6, 8.1, 0) mm, spread (5.4, 9.1, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0360 -0.0005 -0.0108 0.7153 0.0354 0.0455 -0.0157 0.1132 0.0437 -0.0160 0.0230
  ; 0.5880
  ; What it promises for an object stands in the problem.
  (:action push-forward-1011b-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-push-forward-1011b-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-push-forward-1011b-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-1011b-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-1011b-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-1011b-any-tall-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-1011b-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-1011b-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-1011b-any-tall-narrow-11 ?o))))

  ; Primitive 1110 on category 00 (hollow-wide-00); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (29.1, -8.9, 0) mm, spread (5.6, 2, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0033 -0.0422 -0.0220 0.0902 0.0324 -0.0099 0.0153 0.8539 0.0260 0.0049 0.0144
  ; 0.0351
  ; What it promises for an object stands in the problem.
  (:action push-forward-1110a-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (hand-empty) (can-push-forward-1110a-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-push-forward-1110a-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-1110a-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-1110a-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-1110a-hollow-wide-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-1110a-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-1110a-hollow-wide-00 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-1110a-hollow-wide-00 ?o))))

  ; Primitive 1111 on category 11 (any-tall-narrow-11); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (39.6, 1.3, 0) mm, spread (1.4, 0.5, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0166 0.0060 -0.0065 0.9313 0.0233 0.0023 -0.0087 0.2541 0.0155 0.0024 -0.0394
  ; 0.8781
  ; What it promises for an object stands in the problem.
  (:action push-forward-1111b-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-push-forward-1111b-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-push-forward-1111b-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-1111b-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-1111b-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-1111b-any-tall-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-1111b-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-1111b-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-1111b-any-tall-narrow-11 ?o))))

  ; Primitive 1001 on category 10 (solid-low-10); ends at rest in 26 of 31 rehearsals (84%).
  ; Effect (46.4, 42.5, 0) mm, spread (27.2, 34.6, 0) mm; 20 of 31 rehearsals as promised: cost 46.
  ; Action parameters: -0.0410 -0.0445 0.0025 0.6468 -0.0038 0.0172 0.0093 0.7095 0.0105 -0.0500 -0.0059
  ; 0.4198
  ; It turned the object by over 15 degrees in 13 of 31 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-forward-left-1001c-solid-low-10
    :parameters (?o - solid-low-10)
    :precondition (and (hand-empty) (can-push-forward-left-1001c-solid-low-10 ?o) (>= (+ (x ?o) (x-of-push-forward-left-1001c-solid-low-10 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-left-1001c-solid-low-10 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-left-1001c-solid-low-10 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-left-1001c-solid-low-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-left-1001c-solid-low-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-left-1001c-solid-low-10 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-left-1001c-solid-low-10 ?o))))

  ; Primitive 1010 on category 10 (solid-low-10); ends at rest in 28 of 31 rehearsals (90%).
  ; Effect (15.1, 25.4, 0) mm, spread (13.7, 18, 0) mm; 28 of 31 rehearsals as promised: cost 14.
  ; Action parameters: -0.0231 -0.0250 0.0148 0.7943 0.0185 0.0262 -0.0057 0.8054 0.0479 0.0490 -0.0099
  ; 0.1165
  ; What it promises for an object stands in the problem.
  (:action push-forward-left-1010-solid-low-10
    :parameters (?o - solid-low-10)
    :precondition (and (hand-empty) (can-push-forward-left-1010-solid-low-10 ?o) (>= (+ (x ?o) (x-of-push-forward-left-1010-solid-low-10 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-left-1010-solid-low-10 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-left-1010-solid-low-10 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-left-1010-solid-low-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-left-1010-solid-low-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-left-1010-solid-low-10 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-left-1010-solid-low-10 ?o))))

  ; Primitive 1100 on category 10 (solid-low-10); ends at rest in 31 of 31 rehearsals (100%).
  ; Effect (13.1, 7.7, 0) mm, spread (11.1, 30.5, 0) mm; 28 of 31 rehearsals as promised: cost 14.
  ; Action parameters: 0.0042 -0.0310 -0.0066 0.5941 0.0419 0.0448 -0.0090 0.0343 0.0377 0.0474 -0.0399
  ; 0.9002
  ; What it promises for an object stands in the problem.
  (:action push-forward-left-1100c-solid-low-10
    :parameters (?o - solid-low-10)
    :precondition (and (hand-empty) (can-push-forward-left-1100c-solid-low-10 ?o) (>= (+ (x ?o) (x-of-push-forward-left-1100c-solid-low-10 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-left-1100c-solid-low-10 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-left-1100c-solid-low-10 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-left-1100c-solid-low-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-left-1100c-solid-low-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-left-1100c-solid-low-10 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-left-1100c-solid-low-10 ?o))))

  ; Primitive 1100 on category 11 (any-tall-narrow-11); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (14.7, 27.1, 0) mm, spread (10.8, 15.8, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0142 -0.0149 0.0003 0.8710 0.0372 0.0392 -0.0227 0.0238 0.0358 0.0175 0.0283 0.6097
  ; It turned the object by over 15 degrees in 2 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-forward-left-1100d-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-push-forward-left-1100d-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-push-forward-left-1100d-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-left-1100d-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-left-1100d-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-left-1100d-any-tall-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-left-1100d-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-left-1100d-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-left-1100d-any-tall-narrow-11 ?o))))

  ; Primitive 1111 on category 00 (hollow-wide-00); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (25, 43.8, 0) mm, spread (9.8, 5.6, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0363 0.0026 -0.0165 0.1685 0.0169 0.0271 0.0064 0.3703 0.0375 0.0433 0.0258 0.9173
  ; What it promises for an object stands in the problem.
  (:action push-forward-left-1111a-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (hand-empty) (can-push-forward-left-1111a-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-push-forward-left-1111a-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-left-1111a-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-left-1111a-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-left-1111a-hollow-wide-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-left-1111a-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-left-1111a-hollow-wide-00 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-left-1111a-hollow-wide-00 ?o))))

  ; Primitive 0101 on category 00 (hollow-wide-00); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (39.9, -38.5, 0) mm, spread (5.2, 13, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: -0.0023 0.0438 -0.0231 0.4280 0.0453 -0.0491 -0.0073 0.7993 0.0288 0.0323 0.0404
  ; 0.1736
  ; What it promises for an object stands in the problem.
  (:action push-forward-right-0101a-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (hand-empty) (can-push-forward-right-0101a-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-push-forward-right-0101a-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-right-0101a-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-right-0101a-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-right-0101a-hollow-wide-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-right-0101a-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-right-0101a-hollow-wide-00 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-right-0101a-hollow-wide-00 ?o))))

  ; Primitive 0111 on category 10 (solid-low-10); ends at rest in 25 of 31 rehearsals (81%).
  ; Effect (36.6, -41.7, 0) mm, spread (30.5, 41.2, 0) mm; 16 of 31 rehearsals as promised: cost 67.
  ; Action parameters: -0.0226 0.0376 0.0137 0.5389 0.0500 -0.0468 0.0133 0.1215 0.0012 -0.0500 -0.0304
  ; 0.8897
  ; It turned the object by over 15 degrees in 6 of 31 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-forward-right-0111c-solid-low-10
    :parameters (?o - solid-low-10)
    :precondition (and (hand-empty) (can-push-forward-right-0111c-solid-low-10 ?o) (>= (+ (x ?o) (x-of-push-forward-right-0111c-solid-low-10 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-right-0111c-solid-low-10 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-right-0111c-solid-low-10 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-right-0111c-solid-low-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-right-0111c-solid-low-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-right-0111c-solid-low-10 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-right-0111c-solid-low-10 ?o))))

  ; Primitive 1111 on category 11 (any-tall-narrow-11); ends at rest in 29 of 30 rehearsals (97%).
  ; Effect (51.7, -30.2, 0) mm, spread (25.9, 31.3, 0) mm; 20 of 30 rehearsals as promised: cost 43.
  ; Action parameters: -0.0297 0.0137 -0.0165 0.7050 0.0319 -0.0393 -0.0060 0.0401 -0.0239 -0.0468 -0.0449
  ; 0.9145
  ; It turned the object by over 15 degrees in 3 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-forward-right-1111-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-push-forward-right-1111-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-push-forward-right-1111-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-right-1111-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-right-1111-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-right-1111-any-tall-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-right-1111-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-right-1111-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-right-1111-any-tall-narrow-11 ?o))))

  ; Primitive 1111 on category 10 (solid-low-10); ends at rest in 31 of 31 rehearsals (100%).
  ; Effect (14.3, -21.9, 0) mm, spread (21.2, 42.4, 0) mm; 27 of 31 rehearsals as promised: cost 17.
  ; Action parameters: -0.0297 0.0137 -0.0165 0.7050 0.0319 -0.0393 -0.0060 0.0401 -0.0239 -0.0468 -0.0449
  ; 0.9145
  ; What it promises for an object stands in the problem.
  (:action push-forward-right-1111-solid-low-10
    :parameters (?o - solid-low-10)
    :precondition (and (hand-empty) (can-push-forward-right-1111-solid-low-10 ?o) (>= (+ (x ?o) (x-of-push-forward-right-1111-solid-low-10 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-right-1111-solid-low-10 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-right-1111-solid-low-10 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-right-1111-solid-low-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-right-1111-solid-low-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-right-1111-solid-low-10 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-right-1111-solid-low-10 ?o))))

  ; Primitive 1111 on category 01 (solid-low-narrow-01); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (62.4, -39.4, 0) mm, spread (2, 19.8, 0) mm; 29 of 30 rehearsals as promised: cost 7.
  ; Action parameters: -0.0297 0.0137 -0.0165 0.7050 0.0319 -0.0393 -0.0060 0.0401 -0.0239 -0.0468 -0.0449
  ; 0.9145
  ; It turned the object by over 15 degrees in 1 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-forward-right-1111-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (hand-empty) (can-push-forward-right-1111-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-push-forward-right-1111-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-push-forward-right-1111-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-push-forward-right-1111-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-push-forward-right-1111-solid-low-narrow-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-forward-right-1111-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-forward-right-1111-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) (cost-of-push-forward-right-1111-solid-low-narrow-01 ?o))))

  ; Primitive 0110 on category 01 (solid-low-narrow-01); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (-16.5, 60.8, 0) mm, spread (9.3, 23.9, 0) mm; 26 of 30 rehearsals as promised: cost 18.
  ; Action parameters: 0.0419 -0.0446 -0.0057 0.4221 -0.0148 -0.0380 0.0098 0.7770 -0.0286 -0.0447 -0.0217
  ; 0.9215
  ; It turned the object by over 15 degrees in 10 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-left-0110-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (hand-empty) (can-push-left-0110-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-push-left-0110-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-push-left-0110-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-push-left-0110-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-push-left-0110-solid-low-narrow-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-left-0110-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-left-0110-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) (cost-of-push-left-0110-solid-low-narrow-01 ?o))))

  ; Primitive 1000 on category 11 (any-tall-narrow-11); ends at rest in 15 of 30 rehearsals (50%).
  ; Effect (-2.3, 16.5, 0) mm, spread (2.2, 11.7, 0) mm; 15 of 30 rehearsals as promised: cost 70.
  ; Action parameters: 0.0179 -0.0221 0.0057 0.6970 0.0085 0.0306 -0.0186 0.7946 -0.0286 0.0459 -0.0433
  ; 0.4459
  ; It turned the object by over 15 degrees in 6 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-left-1000-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-push-left-1000-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-push-left-1000-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-push-left-1000-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-push-left-1000-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-push-left-1000-any-tall-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-left-1000-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-left-1000-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-push-left-1000-any-tall-narrow-11 ?o))))

  ; Primitive 1000 on category 10 (solid-low-10); ends at rest in 29 of 31 rehearsals (94%).
  ; Effect (-7.6, 24.9, 0) mm, spread (6.8, 22.1, 0) mm; 29 of 31 rehearsals as promised: cost 11.
  ; Action parameters: 0.0179 -0.0221 0.0057 0.6970 0.0085 0.0306 -0.0186 0.7946 -0.0286 0.0459 -0.0433
  ; 0.4459
  ; It turned the object by over 15 degrees in 1 of 31 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-left-1000-solid-low-10
    :parameters (?o - solid-low-10)
    :precondition (and (hand-empty) (can-push-left-1000-solid-low-10 ?o) (>= (+ (x ?o) (x-of-push-left-1000-solid-low-10 ?o)) 10006) (<= (+ (x ?o) (x-of-push-left-1000-solid-low-10 ?o)) 15994) (>= (+ (y ?o) (y-of-push-left-1000-solid-low-10 ?o)) 10006) (<= (+ (y ?o) (y-of-push-left-1000-solid-low-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-left-1000-solid-low-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-left-1000-solid-low-10 ?o)) 10000)) (increase (total-cost) (cost-of-push-left-1000-solid-low-10 ?o))))

  ; Primitive 1100 on category 00 (hollow-wide-00); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (-27.7, 83.1, 0) mm, spread (12.5, 20.1, 0) mm; 28 of 30 rehearsals as promised: cost 11.
  ; Action parameters: 0.0075 -0.0253 -0.0248 0.8026 -0.0456 0.0184 -0.0043 0.4619 0.0242 0.0068 0.0057
  ; 0.7378
  ; What it promises for an object stands in the problem.
  (:action push-left-1100a-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (hand-empty) (can-push-left-1100a-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-push-left-1100a-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-push-left-1100a-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-push-left-1100a-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-push-left-1100a-hollow-wide-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-left-1100a-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-left-1100a-hollow-wide-00 ?o)) 10000)) (increase (total-cost) (cost-of-push-left-1100a-hollow-wide-00 ?o))))

  ; Primitive 1101 on category 01 (solid-low-narrow-01); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (-3.6, 37.1, 0) mm, spread (0.1, 0.3, 0) mm; 30 of 30 rehearsals as promised: cost 4.
  ; Action parameters: 0.0019 0.0106 0.0073 0.5114 -0.0018 0.0390 0.0247 0.4637 0.0367 0.0143 0.0097 0.6628
  ; What it promises for an object stands in the problem.
  (:action push-left-1101-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (hand-empty) (can-push-left-1101-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-push-left-1101-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-push-left-1101-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-push-left-1101-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-push-left-1101-solid-low-narrow-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-left-1101-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-left-1101-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) (cost-of-push-left-1101-solid-low-narrow-01 ?o))))

  ; Primitive 1101 on category 11 (any-tall-narrow-11); ends at rest in 24 of 30 rehearsals (80%).
  ; Effect (-3.3, 13.6, 0) mm, spread (10.8, 10.3, 0) mm; 24 of 30 rehearsals as promised: cost 26.
  ; Action parameters: -0.0093 -0.0145 -0.0074 0.3785 -0.0241 0.0194 0.0233 0.7310 0.0393 0.0235 -0.0453
  ; 0.6039
  ; What it promises for an object stands in the problem.
  (:action push-left-1101a-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-push-left-1101a-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-push-left-1101a-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-push-left-1101a-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-push-left-1101a-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-push-left-1101a-any-tall-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-left-1101a-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-left-1101a-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-push-left-1101a-any-tall-narrow-11 ?o))))

  ; Primitive 1110 on category 01 (solid-low-narrow-01); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (32.1, 114.5, 0) mm, spread (10.1, 29, 0) mm; 27 of 30 rehearsals as promised: cost 14.
  ; Action parameters: -0.0242 -0.0500 0.0005 0.0844 0.0179 0.0182 -0.0250 0.8456 0.0170 0.0500 0.0118
  ; 0.1557
  ; It turned the object by over 15 degrees in 3 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-left-1110b-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (hand-empty) (can-push-left-1110b-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-push-left-1110b-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-push-left-1110b-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-push-left-1110b-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-push-left-1110b-solid-low-narrow-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-left-1110b-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-left-1110b-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) (cost-of-push-left-1110b-solid-low-narrow-01 ?o))))

  ; Primitive 0001 on category 11 (any-tall-narrow-11); ends at rest in 8 of 30 rehearsals (27%).
  ; Effect (-16.6, -35, 0) mm, spread (10.8, 29.2, 0) mm; 7 of 30 rehearsals as promised: cost 140.
  ; Action parameters: -0.0016 0.0334 -0.0112 0.6225 -0.0371 0.0340 -0.0032 0.3549 -0.0335 -0.0187 0.0376
  ; 0.4440
  ; What it promises for an object stands in the problem.
  (:action push-right-0001-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-push-right-0001-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-push-right-0001-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-0001-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-0001-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-0001-any-tall-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-0001-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-0001-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-0001-any-tall-narrow-11 ?o))))

  ; Primitive 0001 on category 11 (any-tall-narrow-11); ends at rest in 11 of 30 rehearsals (37%).
  ; Effect (-1.3, -17.5, 0) mm, spread (7.7, 34.1, 0) mm; 9 of 30 rehearsals as promised: cost 117.
  ; Action parameters: 0.0233 0.0146 -0.0115 0.9002 0.0329 -0.0478 0.0099 0.2202 0.0040 -0.0149 -0.0295
  ; 0.4225
  ; It turned the object by over 15 degrees in 4 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-right-0001a-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-push-right-0001a-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-push-right-0001a-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-0001a-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-0001a-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-0001a-any-tall-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-0001a-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-0001a-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-0001a-any-tall-narrow-11 ?o))))

  ; Primitive 0001 on category 10 (solid-low-10); ends at rest in 31 of 31 rehearsals (100%).
  ; Effect (-13.3, -46.4, 0) mm, spread (8.8, 20.7, 0) mm; 30 of 31 rehearsals as promised: cost 7.
  ; Action parameters: 0.0261 0.0230 0.0142 0.5423 -0.0178 -0.0029 -0.0039 0.4129 0.0146 -0.0447 0.0046
  ; 0.0590
  ; What it promises for an object stands in the problem.
  (:action push-right-0001b-solid-low-10
    :parameters (?o - solid-low-10)
    :precondition (and (hand-empty) (can-push-right-0001b-solid-low-10 ?o) (>= (+ (x ?o) (x-of-push-right-0001b-solid-low-10 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-0001b-solid-low-10 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-0001b-solid-low-10 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-0001b-solid-low-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-0001b-solid-low-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-0001b-solid-low-10 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-0001b-solid-low-10 ?o))))

  ; Primitive 0010 on category 10 (solid-low-10); ends at rest in 25 of 31 rehearsals (81%).
  ; Effect (8.5, -18.8, 0) mm, spread (9.2, 26.9, 0) mm; 24 of 31 rehearsals as promised: cost 29.
  ; Action parameters: 0.0086 0.0086 -0.0069 0.7599 0.0389 0.0416 0.0117 0.3659 0.0358 0.0251 0.0290 0.0250
  ; What it promises for an object stands in the problem.
  (:action push-right-0010-solid-low-10
    :parameters (?o - solid-low-10)
    :precondition (and (hand-empty) (can-push-right-0010-solid-low-10 ?o) (>= (+ (x ?o) (x-of-push-right-0010-solid-low-10 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-0010-solid-low-10 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-0010-solid-low-10 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-0010-solid-low-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-0010-solid-low-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-0010-solid-low-10 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-0010-solid-low-10 ?o))))

  ; Primitive 0010 on category 00 (hollow-wide-00); ends at rest in 13 of 30 rehearsals (43%).
  ; Effect (-6.8, -34.4, 0) mm, spread (8.4, 25, 0) mm; 13 of 30 rehearsals as promised: cost 84.
  ; Action parameters: 0.0093 0.0175 -0.0088 0.6535 -0.0281 -0.0231 -0.0013 0.2667 0.0007 0.0472 -0.0095
  ; 0.2417
  ; What it promises for an object stands in the problem.
  (:action push-right-0010a-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (hand-empty) (can-push-right-0010a-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-push-right-0010a-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-0010a-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-0010a-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-0010a-hollow-wide-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-0010a-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-0010a-hollow-wide-00 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-0010a-hollow-wide-00 ?o))))

  ; Primitive 0011 on category 11 (any-tall-narrow-11); ends at rest in 7 of 30 rehearsals (23%).
  ; Effect (9, -19.6, 0) mm, spread (7.4, 14.9, 0) mm; 7 of 30 rehearsals as promised: cost 140.
  ; Action parameters: -0.0053 0.0137 -0.0146 0.8551 0.0139 -0.0012 0.0184 0.3505 0.0333 -0.0478 -0.0361
  ; 0.2665
  ; What it promises for an object stands in the problem.
  (:action push-right-0011-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-push-right-0011-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-push-right-0011-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-0011-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-0011-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-0011-any-tall-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-0011-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-0011-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-0011-any-tall-narrow-11 ?o))))

  ; Primitive 0011 on category 00 (hollow-wide-00); ends at rest in 16 of 30 rehearsals (53%).
  ; Effect (6.3, -52, 0) mm, spread (9.8, 21.3, 0) mm; 16 of 30 rehearsals as promised: cost 64.
  ; Action parameters: -0.0053 0.0137 -0.0146 0.8551 0.0139 -0.0012 0.0184 0.3505 0.0333 -0.0478 -0.0361
  ; 0.2665
  ; It turned the object by over 15 degrees in 1 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-right-0011-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (hand-empty) (can-push-right-0011-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-push-right-0011-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-0011-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-0011-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-0011-hollow-wide-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-0011-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-0011-hollow-wide-00 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-0011-hollow-wide-00 ?o))))

  ; Primitive 0011 on category 10 (solid-low-10); ends at rest in 28 of 31 rehearsals (90%).
  ; Effect (12.4, -31.9, 0) mm, spread (13.4, 32.4, 0) mm; 26 of 31 rehearsals as promised: cost 21.
  ; Action parameters: -0.0053 0.0137 -0.0146 0.8551 0.0139 -0.0012 0.0184 0.3505 0.0333 -0.0478 -0.0361
  ; 0.2665
  ; What it promises for an object stands in the problem.
  (:action push-right-0011-solid-low-10
    :parameters (?o - solid-low-10)
    :precondition (and (hand-empty) (can-push-right-0011-solid-low-10 ?o) (>= (+ (x ?o) (x-of-push-right-0011-solid-low-10 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-0011-solid-low-10 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-0011-solid-low-10 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-0011-solid-low-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-0011-solid-low-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-0011-solid-low-10 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-0011-solid-low-10 ?o))))

  ; Primitive 0101 on category 01 (solid-low-narrow-01); ends at rest in 25 of 30 rehearsals (83%).
  ; Effect (-19.4, -127.1, 0) mm, spread (6.4, 25.3, 0) mm; 23 of 30 rehearsals as promised: cost 30.
  ; Action parameters: 0.0168 0.0500 -0.0068 0.0555 -0.0298 -0.0310 0.0154 0.9939 0.0393 0.0211 0.0286
  ; 0.3981
  ; It turned the object by over 15 degrees in 5 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-right-0101b-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (hand-empty) (can-push-right-0101b-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-push-right-0101b-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-0101b-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-0101b-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-0101b-solid-low-narrow-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-0101b-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-0101b-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-0101b-solid-low-narrow-01 ?o))))

  ; Primitive 0101 on category 11 (any-tall-narrow-11); ends at rest in 26 of 30 rehearsals (87%).
  ; Effect (-5.7, -31.4, 0) mm, spread (13.7, 20.3, 0) mm; 26 of 30 rehearsals as promised: cost 18.
  ; Action parameters: 0.0068 0.0344 -0.0036 0.4587 0.0441 -0.0426 -0.0002 0.9124 -0.0273 -0.0483 -0.0043
  ; 0.7735
  ; It turned the object by over 15 degrees in 2 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-right-0101d-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-push-right-0101d-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-push-right-0101d-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-0101d-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-0101d-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-0101d-any-tall-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-0101d-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-0101d-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-0101d-any-tall-narrow-11 ?o))))

  ; Primitive 0111 on category 11 (any-tall-narrow-11); ends at rest in 30 of 30 rehearsals (100%).
  ; Effect (-15.3, -39.2, 0) mm, spread (11.8, 33.7, 0) mm; 24 of 30 rehearsals as promised: cost 26.
  ; Action parameters: -0.0074 0.0264 -0.0138 0.9402 -0.0350 -0.0346 0.0136 0.3594 -0.0142 0.0059 0.0180
  ; 0.8726
  ; What it promises for an object stands in the problem.
  (:action push-right-0111-any-tall-narrow-11
    :parameters (?o - any-tall-narrow-11)
    :precondition (and (hand-empty) (can-push-right-0111-any-tall-narrow-11 ?o) (>= (+ (x ?o) (x-of-push-right-0111-any-tall-narrow-11 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-0111-any-tall-narrow-11 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-0111-any-tall-narrow-11 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-0111-any-tall-narrow-11 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-0111-any-tall-narrow-11 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-0111-any-tall-narrow-11 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-0111-any-tall-narrow-11 ?o))))

  ; Primitive 1001 on category 01 (solid-low-narrow-01); ends at rest in 4 of 30 rehearsals (13%).
  ; Effect (-6.7, -18.8, 0) mm, spread (7.2, 16.1, 0) mm; 4 of 30 rehearsals as promised: cost 187.
  ; Action parameters: -0.0359 -0.0408 -0.0143 0.7496 0.0346 0.0082 -0.0226 0.5834 0.0141 -0.0450 -0.0317
  ; 0.1350
  ; It turned the object by over 15 degrees in 5 of 30 rehearsals.
  ; What it promises for an object stands in the problem.
  (:action push-right-1001-solid-low-narrow-01
    :parameters (?o - solid-low-narrow-01)
    :precondition (and (hand-empty) (can-push-right-1001-solid-low-narrow-01 ?o) (>= (+ (x ?o) (x-of-push-right-1001-solid-low-narrow-01 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-1001-solid-low-narrow-01 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-1001-solid-low-narrow-01 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-1001-solid-low-narrow-01 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-1001-solid-low-narrow-01 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-1001-solid-low-narrow-01 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-1001-solid-low-narrow-01 ?o))))

  ; Primitive 1101 on category 00 (hollow-wide-00); ends at rest in 25 of 30 rehearsals (83%).
  ; Effect (1.4, -30, 0) mm, spread (6, 26.1, 0) mm; 24 of 30 rehearsals as promised: cost 26.
  ; Action parameters: 0.0019 0.0106 0.0073 0.5114 -0.0018 0.0390 0.0247 0.4637 0.0367 0.0143 0.0097 0.6628
  ; What it promises for an object stands in the problem.
  (:action push-right-1101-hollow-wide-00
    :parameters (?o - hollow-wide-00)
    :precondition (and (hand-empty) (can-push-right-1101-hollow-wide-00 ?o) (>= (+ (x ?o) (x-of-push-right-1101-hollow-wide-00 ?o)) 10006) (<= (+ (x ?o) (x-of-push-right-1101-hollow-wide-00 ?o)) 15994) (>= (+ (y ?o) (y-of-push-right-1101-hollow-wide-00 ?o)) 10006) (<= (+ (y ?o) (y-of-push-right-1101-hollow-wide-00 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-push-right-1101-hollow-wide-00 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-push-right-1101-hollow-wide-00 ?o)) 10000)) (increase (total-cost) (cost-of-push-right-1101-hollow-wide-00 ?o))))

  ; Primitive 1101 on category 10 (solid-low-10); ends at rest in 31 of 31 rehearsals (100%).
  ; Effect (0, -5.8, 0) mm, spread (1.1, 26.9, 0) mm; 29 of 31 rehearsals as promised: cost 11.
  ; Action parameters: 0.0019 0.0106 0.0073 0.5114 -0.0018 0.0390 0.0247 0.4637 0.0367 0.0143 0.0097 0.6628
  ; What it promises for an object stands in the problem.
  (:action stay-1101-solid-low-10
    :parameters (?o - solid-low-10)
    :precondition (and (hand-empty) (can-stay-1101-solid-low-10 ?o) (>= (+ (x ?o) (x-of-stay-1101-solid-low-10 ?o)) 10006) (<= (+ (x ?o) (x-of-stay-1101-solid-low-10 ?o)) 15994) (>= (+ (y ?o) (y-of-stay-1101-solid-low-10 ?o)) 10006) (<= (+ (y ?o) (y-of-stay-1101-solid-low-10 ?o)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (x-of-stay-1101-solid-low-10 ?o)) 10000)) (assign (y ?o) (- (+ (y ?o) (y-of-stay-1101-solid-low-10 ?o)) 10000)) (increase (total-cost) (cost-of-stay-1101-solid-low-10 ?o))))

  ; No operator is left out.
)
