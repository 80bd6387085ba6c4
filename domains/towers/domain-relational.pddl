; Learned domain tabletop, encoding relational. Printed by neurosym; do not edit.
; Every object stands at a place or is borne by another object. A step has two actions: leave-... takes an
; object from where it is, and the operator puts it elsewhere.
; (bears ?r ?n): so many objects rest on or in ?r themselves; (next ?n ?more) counts on.
; What spoiled more than half of the rehearsals is forbidden. Cost of a step: 1 + round(-100 ln((k + 1) / (n
; + 2))), k successes in n rehearsals.

(define (domain tabletop)
  (:requirements :strips :typing :action-costs)

  (:types
    movable place count origin - object
    any-tall-narrow-11 hollow-wide-00 solid-low-10 solid-low-narrow-01 - movable)

  (:constants
    none one - count
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
    (room ?o - movable ?p ?so-far - place)
    (look-next ?o - movable ?p ?here ?next - place)
    (bears ?r - movable ?n - count)
    (next ?n ?more - count)
    (rests-on-000 ?t ?r - movable)
    (leans-on-010 ?t ?r - movable)
    (sits-in-100 ?t ?r - movable)
    (sits-in-101 ?t ?r - movable)
    (solid-low-to-hollow-low-00001 ?t ?r - movable)
    (solid-tall-narrow-to-hollow-low-wide-00010 ?t ?r - movable)
    (solid-tall-to-any-low-wide-00011 ?t ?r - movable)
    (any-tall-narrow-to-any-tall-narrow-00101 ?t ?r - movable)
    (any-tall-narrow-to-hollow-wide-00110 ?t ?r - movable)
    (any-tall-narrow-to-any-tall-00111 ?t ?r - movable)
    (solid-low-narrow-to-hollow-low-wide-01000 ?t ?r - movable)
    (any-low-to-any-low-wide-01001 ?t ?r - movable)
    (any-tall-narrow-to-hollow-low-wide-01010 ?t ?r - movable)
    (hollow-tall-wide-to-any-wide-01011 ?t ?r - movable)
    (any-tall-to-any-low-01101 ?t ?r - movable)
    (any-narrow-to-any-tall-wide-01110 ?t ?r - movable)
    (any-tall-to-any-tall-wide-01111 ?t ?r - movable)
    (solid-low-to-any-10010 ?t ?r - movable)
    (solid-tall-to-solid-10011 ?t ?r - movable)
    (any-tall-narrow-to-any-narrow-10101 ?t ?r - movable)
    (any-low-narrow-to-any-tall-narrow-10110 ?t ?r - movable)
    (any-tall-narrow-to-any-tall-narrow-10111 ?t ?r - movable)
    (hollow-low-wide-to-any-low-narrow-11000 ?t ?r - movable)
    (hollow-wide-to-hollow-low-wide-11001 ?t ?r - movable)
    (hollow-low-wide-to-any-narrow-11010 ?t ?r - movable)
    (hollow-wide-to-hollow-low-wide-11011 ?t ?r - movable)
    (any-narrow-to-solid-low-narrow-11110 ?t ?r - movable)
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
    (cost-of-leans-on-010-by-000g-hollow-low-wide-to-any-low-narrow-11000 ?n - count) - number
    (cost-of-leans-on-010-by-000h-hollow-wide-to-hollow-low-wide-11011 ?n - count) - number
    (cost-of-leans-on-010-by-011c-any-tall-narrow-to-hollow-low-wide-01010 ?n - count) - number
    (cost-of-leans-on-010-by-111b-hollow-low-wide-to-any-narrow-11010 ?n - count) - number
    (cost-of-rests-on-000-by-000b-any-tall-narrow-to-any-tall-narrow-00101 ?from - origin) - number
    (cost-of-rests-on-000-by-000b-any-tall-narrow-to-any-tall-narrow-00101-laden ?from - origin) - number
    (cost-of-rests-on-000-by-000c-any-tall-narrow-to-any-tall-00111 ?from - origin) - number
    (cost-of-rests-on-000-by-010a-any-narrow-to-any-tall-wide-01110 ?from - origin) - number
    (cost-of-rests-on-000-by-010c-any-low-narrow-to-any-tall-narrow-10110 ?from - origin) - number
    (cost-of-rests-on-000-by-011a-solid-tall-to-any-low-wide-00011 ?from - origin) - number
    (cost-of-rests-on-000-by-011b-any-low-to-any-low-wide-01001 ?from - origin) - number
    (cost-of-rests-on-000-by-011d-any-tall-to-any-low-01101 ?from - origin) - number
    (cost-of-rests-on-000-by-011e-any-tall-to-any-tall-wide-01111 ?from - origin) - number
    (cost-of-rests-on-000-by-011g-any-tall-narrow-to-any-narrow-10101 ?from - origin) - number
    (cost-of-rests-on-000-by-011h-any-tall-narrow-to-any-tall-narrow-10111 ?from - origin) - number
    (cost-of-rests-on-000-by-011i-any-narrow-to-solid-low-narrow-11110 ?from - origin) - number
    (cost-of-rests-on-000-by-110a-hollow-tall-wide-to-any-wide-01011 ?from - origin) - number
    (cost-of-sits-in-101-by-001b-any-tall-narrow-to-hollow-wide-00110 ?n - count) - number
    (cost-of-sits-in-101-by-111a-hollow-wide-to-hollow-low-wide-11001 ?n - count) - number
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

  ; Take an object from another that bears it in the state 000: it is typically 0.33 touching units away
  ; from that, and 1.01 above it.
  (:action leave-rests-on-000
    :parameters (?o ?b - movable ?less ?n - count)
    :precondition (and (hand-empty) (can-be-taken ?o) (rests-on-000 ?o ?b) (bears ?b ?n) (next ?less ?n))
    :effect (and (not (hand-empty)) (not (done ?o)) (not (rests-on-000 ?o ?b)) (not (bears ?b ?n)) (bears ?b ?less) (taken ?o from-object) (increase (total-cost) 0)))

  ; Take an object from another that bears it in the state 010: it is typically 0.46 touching units away
  ; from that, and 0.42 above it.
  (:action leave-leans-on-010
    :parameters (?o ?b - movable ?less ?n - count)
    :precondition (and (hand-empty) (can-be-taken ?o) (leans-on-010 ?o ?b) (bears ?b ?n) (next ?less ?n))
    :effect (and (not (hand-empty)) (not (done ?o)) (not (leans-on-010 ?o ?b)) (not (bears ?b ?n)) (bears ?b ?less) (taken ?o from-object) (increase (total-cost) 0)))

  ; Take an object from another that bears it in the state 100: it is typically 0.45 touching units away
  ; from that, and 0.01 above it.
  (:action leave-sits-in-100
    :parameters (?o ?b - movable ?less ?n - count)
    :precondition (and (hand-empty) (can-be-taken ?o) (sits-in-100 ?o ?b) (bears ?b ?n) (next ?less ?n))
    :effect (and (not (hand-empty)) (not (done ?o)) (not (sits-in-100 ?o ?b)) (not (bears ?b ?n)) (bears ?b ?less) (taken ?o from-object) (increase (total-cost) 0)))

  ; Take an object from another that bears it in the state 101: it is typically 0.21 touching units away
  ; from that, and -0.22 above it.
  (:action leave-sits-in-101
    :parameters (?o ?b - movable ?less ?n - count)
    :precondition (and (hand-empty) (can-be-taken ?o) (sits-in-101 ?o ?b) (bears ?b ?n) (next ?less ?n))
    :effect (and (not (hand-empty)) (not (done ?o)) (not (sits-in-101 ?o ?b)) (not (bears ?b ?n)) (bears ?b ?less) (taken ?o from-object) (increase (total-cost) 0)))

  ; Primitive 000 on pairs of the kind 11000 (hollow-low-wide-to-any-low-narrow-11000): ends in the state
  ; 010 (leans-on-010) in 18 of 30 rehearsals, at (-0.09, 0.24, 0.37) touching units from the reference:
  ; cost 53.
  ; With a third object on the reference: 6 of 12 went so, and it is allowed.
  ; With a third object under the target: 4 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0020 -0.0161 0.0027 0.8536 -0.0054 0.0020 0.0069 0.0930 -0.0080 -0.0251 0.0481
  ; 0.9075
  (:action leans-on-010-by-000g-hollow-low-wide-to-any-low-narrow-11000
    :parameters (?t ?r - movable ?n ?more - count)
    :precondition (and (hollow-low-wide-to-any-low-narrow-11000 ?t ?r) (taken ?t from-place) (bears ?t none) (bears ?r ?n) (next ?n ?more))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-010 ?t ?r) (not (bears ?r ?n)) (bears ?r ?more) (increase (total-cost) (cost-of-leans-on-010-by-000g-hollow-low-wide-to-any-low-narrow-11000 ?n))))

  ; Primitive 000 on pairs of the kind 11011 (hollow-wide-to-hollow-low-wide-11011): ends in the state 010
  ; (leans-on-010) in 14 of 30 rehearsals, at (0.09, 0.15, 0.47) touching units from the reference: cost 77.
  ; With a third object on the reference: 7 of 12 went so, and it is allowed.
  ; With a third object under the target: 2 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0023 -0.0191 0.0067 0.5008 0.0281 -0.0022 -0.0215 0.4359 0.0159 -0.0390 -0.0322
  ; 0.7128
  (:action leans-on-010-by-000h-hollow-wide-to-hollow-low-wide-11011
    :parameters (?t ?r - movable ?n ?more - count)
    :precondition (and (hollow-wide-to-hollow-low-wide-11011 ?t ?r) (taken ?t from-place) (bears ?t none) (bears ?r ?n) (next ?n ?more))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-010 ?t ?r) (not (bears ?r ?n)) (bears ?r ?more) (increase (total-cost) (cost-of-leans-on-010-by-000h-hollow-wide-to-hollow-low-wide-11011 ?n))))

  ; Primitive 011 on pairs of the kind 01010 (any-tall-narrow-to-hollow-low-wide-01010): ends in the state
  ; 010 (leans-on-010) in 16 of 30 rehearsals, at (-0.11, 0.29, 0.50) touching units from the reference:
  ; cost 64.
  ; With a third object on the reference: 3 of 5 went so, and it is allowed.
  ; With a third object under the target: 0 of 5 went so, and it is forbidden.
  ; With a third object on the target: 0 of 1 went so, and it is forbidden.
  ; Action parameters: -0.0078 0.0013 -0.0151 1.0000 0.0002 -0.0314 -0.0250 0.0000 -0.0286 0.0500 0.0062
  ; 0.0841
  (:action leans-on-010-by-011c-any-tall-narrow-to-hollow-low-wide-01010
    :parameters (?t ?r - movable ?n ?more - count)
    :precondition (and (any-tall-narrow-to-hollow-low-wide-01010 ?t ?r) (taken ?t from-place) (bears ?t none) (bears ?r ?n) (next ?n ?more))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-010 ?t ?r) (not (bears ?r ?n)) (bears ?r ?more) (increase (total-cost) (cost-of-leans-on-010-by-011c-any-tall-narrow-to-hollow-low-wide-01010 ?n))))

  ; Primitive 111 on pairs of the kind 11001 (hollow-wide-to-hollow-low-wide-11001): ends in the state 010
  ; (leans-on-010) in 14 of 30 rehearsals, at (-0.03, -0.06, 0.38) touching units from the reference: cost
  ; 77.
  ; With a third object on the reference: 2 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 6 went so, and it is forbidden.
  ; Action parameters: -0.0089 0.0337 -0.0195 0.9910 -0.0468 -0.0043 -0.0097 0.2028 -0.0021 0.0472 0.0455
  ; 0.4117
  (:action leans-on-010-by-111a-hollow-wide-to-hollow-low-wide-11001
    :parameters (?t ?r - movable)
    :precondition (and (hollow-wide-to-hollow-low-wide-11001 ?t ?r) (taken ?t from-place) (bears ?t none) (bears ?r none))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-010 ?t ?r) (not (bears ?r none)) (bears ?r one) (increase (total-cost) 77)))

  ; Primitive 111 on pairs of the kind 11010 (hollow-low-wide-to-any-narrow-11010): ends in the state 010
  ; (leans-on-010) in 15 of 30 rehearsals, at (-0.11, -0.25, 0.40) touching units from the reference: cost
  ; 70.
  ; With a third object on the reference: 6 of 12 went so, and it is allowed.
  ; With a third object under the target: 2 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0008 0.0349 -0.0025 0.6572 0.0129 0.0349 0.0056 0.3941 -0.0140 0.0500 0.0225
  ; 0.8199
  (:action leans-on-010-by-111b-hollow-low-wide-to-any-narrow-11010
    :parameters (?t ?r - movable ?n ?more - count)
    :precondition (and (hollow-low-wide-to-any-narrow-11010 ?t ?r) (taken ?t from-place) (bears ?t none) (bears ?r ?n) (next ?n ?more))
    :effect (and (hand-empty) (not (taken ?t from-place)) (leans-on-010 ?t ?r) (not (bears ?r ?n)) (bears ?r ?more) (increase (total-cost) (cost-of-leans-on-010-by-111b-hollow-low-wide-to-any-narrow-11010 ?n))))

  ; Primitive 000 on pairs of the kind 00001 (solid-low-to-hollow-low-00001): ends in the state 000 (rests-
  ; on-000) in 14 of 15 rehearsals, at (-0.02, -0.38, 1.00) touching units from the reference: cost 14.
  ; With a third object on the reference: 1 of 5 went so, and it is forbidden.
  ; With a third object under the target: 0 of 6 went so, and it is forbidden.
  ; With a third object on the target: 1 of 3 went so, and it is forbidden.
  ; Action parameters: 0.0067 0.0039 -0.0027 0.6294 -0.0206 -0.0111 -0.0082 0.2830 0.0026 -0.0365 -0.0231
  ; 0.9340
  (:action rests-on-000-by-000a-solid-low-to-hollow-low-00001
    :parameters (?t ?r - movable)
    :precondition (and (solid-low-to-hollow-low-00001 ?t ?r) (taken ?t from-place) (bears ?t none) (bears ?r none))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-000 ?t ?r) (not (bears ?r none)) (bears ?r one) (increase (total-cost) 14)))

  ; Primitive 000 on pairs of the kind 00101 (any-tall-narrow-to-any-tall-narrow-00101): ends in the state
  ; 000 (rests-on-000) in 26 of 30 rehearsals, at (-0.11, -0.34, 1.00) touching units from the reference:
  ; cost 18.
  ; With a third object on the reference: 1 of 9 went so, and it is forbidden.
  ; With a third object under the target: 8 of 12 went so, and it is allowed.
  ; With a third object on the target: never rehearsed, and allowed.
  ; Action parameters: 0.0011 -0.0050 -0.0228 0.7216 0.0176 -0.0197 0.0006 0.2601 -0.0068 -0.0323 -0.0205
  ; 0.6538
  (:action rests-on-000-by-000b-any-tall-narrow-to-any-tall-narrow-00101
    :parameters (?t ?r - movable ?from - origin)
    :precondition (and (any-tall-narrow-to-any-tall-narrow-00101 ?t ?r) (taken ?t ?from) (bears ?t none) (bears ?r none))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-000 ?t ?r) (not (bears ?r none)) (bears ?r one) (increase (total-cost) (cost-of-rests-on-000-by-000b-any-tall-narrow-to-any-tall-narrow-00101 ?from))))
  (:action rests-on-000-by-000b-any-tall-narrow-to-any-tall-narrow-00101-laden
    :parameters (?t ?r - movable ?p - place ?less ?load - count ?from - origin)
    :precondition (and (any-tall-narrow-to-any-tall-narrow-00101 ?t ?r) (taken ?t ?from) (stands ?r ?p) (bears ?t ?load) (next ?less ?load) (bears ?r none))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-000 ?t ?r) (not (bears ?r none)) (bears ?r one) (increase (total-cost) (cost-of-rests-on-000-by-000b-any-tall-narrow-to-any-tall-narrow-00101-laden ?from))))

  ; Primitive 000 on pairs of the kind 00111 (any-tall-narrow-to-any-tall-00111): ends in the state 000
  ; (rests-on-000) in 25 of 30 rehearsals, at (0.14, -0.28, 1.00) touching units from the reference: cost
  ; 22.
  ; With a third object on the reference: 1 of 7 went so, and it is forbidden.
  ; With a third object under the target: 7 of 12 went so, and it is allowed.
  ; With a third object on the target: 2 of 11 went so, and it is forbidden.
  ; Action parameters: -0.0068 -0.0083 -0.0213 0.5690 -0.0368 -0.0013 0.0103 0.3417 0.0053 -0.0259 -0.0410
  ; 0.0910
  (:action rests-on-000-by-000c-any-tall-narrow-to-any-tall-00111
    :parameters (?t ?r - movable ?from - origin)
    :precondition (and (any-tall-narrow-to-any-tall-00111 ?t ?r) (taken ?t ?from) (bears ?t none) (bears ?r none))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-000 ?t ?r) (not (bears ?r none)) (bears ?r one) (increase (total-cost) (cost-of-rests-on-000-by-000c-any-tall-narrow-to-any-tall-00111 ?from))))

  ; Primitive 000 on pairs of the kind 01000 (solid-low-narrow-to-hollow-low-wide-01000): ends in the state
  ; 000 (rests-on-000) in 23 of 30 rehearsals, at (0.05, -0.50, 1.00) touching units from the reference:
  ; cost 30.
  ; With a third object on the reference: 2 of 10 went so, and it is forbidden.
  ; With a third object under the target: 0 of 4 went so, and it is forbidden.
  ; With a third object on the target: 0 of 1 went so, and it is forbidden.
  ; Action parameters: 0.0016 -0.0083 -0.0170 0.7216 0.0179 -0.0246 0.0056 0.2601 0.0078 -0.0487 0.0194
  ; 0.2100
  (:action rests-on-000-by-000d-solid-low-narrow-to-hollow-low-wide-01000
    :parameters (?t ?r - movable)
    :precondition (and (solid-low-narrow-to-hollow-low-wide-01000 ?t ?r) (taken ?t from-place) (bears ?t none) (bears ?r none))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-000 ?t ?r) (not (bears ?r none)) (bears ?r one) (increase (total-cost) 30)))

  ; Primitive 000 on pairs of the kind 11000 (hollow-low-wide-to-any-low-narrow-11000): ends in the state
  ; 000 (rests-on-000) in 13 of 30 rehearsals, at (-0.05, 0.09, 1.00) touching units from the reference:
  ; cost 84.
  ; With a third object on the reference: 1 of 12 went so, and it is forbidden.
  ; With a third object under the target: 1 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: 0.0010 -0.0142 -0.0018 0.8535 -0.0002 0.0072 0.0107 0.0931 -0.0039 -0.0402 -0.0211
  ; 0.4627
  (:action rests-on-000-by-000f-hollow-low-wide-to-any-low-narrow-11000
    :parameters (?t ?r - movable)
    :precondition (and (hollow-low-wide-to-any-low-narrow-11000 ?t ?r) (taken ?t from-place) (bears ?t none) (bears ?r none))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-000 ?t ?r) (not (bears ?r none)) (bears ?r one) (increase (total-cost) 84)))

  ; Primitive 000 on pairs of the kind 11011 (hollow-wide-to-hollow-low-wide-11011): ends in the state 000
  ; (rests-on-000) in 14 of 30 rehearsals, at (0.08, 0.18, 1.00) touching units from the reference: cost 77.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0023 -0.0191 0.0067 0.5008 0.0281 -0.0022 -0.0215 0.4359 0.0159 -0.0390 -0.0322
  ; 0.7128
  (:action rests-on-000-by-000h-hollow-wide-to-hollow-low-wide-11011
    :parameters (?t ?r - movable)
    :precondition (and (hollow-wide-to-hollow-low-wide-11011 ?t ?r) (taken ?t from-place) (bears ?t none) (bears ?r none))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-000 ?t ?r) (not (bears ?r none)) (bears ?r one) (increase (total-cost) 77)))

  ; Primitive 001 on pairs of the kind 00010 (solid-tall-narrow-to-hollow-low-wide-00010): ends in the state
  ; 000 (rests-on-000) in 13 of 30 rehearsals, at (-0.58, -0.03, 1.00) touching units from the reference:
  ; cost 84.
  ; With a third object on the reference: 3 of 10 went so, and it is forbidden.
  ; With a third object under the target: 1 of 6 went so, and it is forbidden.
  ; With a third object on the target: 1 of 4 went so, and it is forbidden.
  ; Action parameters: -0.0018 0.0023 0.0070 0.7350 0.0289 -0.0064 -0.0150 0.2442 -0.0500 -0.0024 0.0146
  ; 0.4335
  (:action rests-on-000-by-001a-solid-tall-narrow-to-hollow-low-wide-00010
    :parameters (?t ?r - movable)
    :precondition (and (solid-tall-narrow-to-hollow-low-wide-00010 ?t ?r) (taken ?t from-place) (bears ?t none) (bears ?r none))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-000 ?t ?r) (not (bears ?r none)) (bears ?r one) (increase (total-cost) 84)))

  ; Primitive 010 on pairs of the kind 01110 (any-narrow-to-any-tall-wide-01110): ends in the state 000
  ; (rests-on-000) in 18 of 30 rehearsals, at (0.37, -0.51, 1.00) touching units from the reference: cost
  ; 53.
  ; With a third object on the reference: 0 of 9 went so, and it is forbidden.
  ; With a third object under the target: 3 of 5 went so, and it is allowed.
  ; With a third object on the target: 0 of 2 went so, and it is forbidden.
  ; Action parameters: -0.0167 -0.0054 -0.0249 0.5745 -0.0375 -0.0028 0.0148 0.3392 0.0332 -0.0419 0.0464
  ; 0.4553
  (:action rests-on-000-by-010a-any-narrow-to-any-tall-wide-01110
    :parameters (?t ?r - movable ?from - origin)
    :precondition (and (any-narrow-to-any-tall-wide-01110 ?t ?r) (taken ?t ?from) (bears ?t none) (bears ?r none))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-000 ?t ?r) (not (bears ?r none)) (bears ?r one) (increase (total-cost) (cost-of-rests-on-000-by-010a-any-narrow-to-any-tall-wide-01110 ?from))))

  ; Primitive 010 on pairs of the kind 10010 (solid-low-to-any-10010): ends in the state 000 (rests-on-000)
  ; in 8 of 30 rehearsals, at (0.41, -0.02, 1.00) touching units from the reference: cost 128.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 4 of 10 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0107 0.0007 -0.0179 0.5509 0.0109 -0.0061 0.0143 0.1473 0.0237 -0.0004 0.0098
  ; 0.4254
  (:action rests-on-000-by-010b-solid-low-to-any-10010
    :parameters (?t ?r - movable)
    :precondition (and (solid-low-to-any-10010 ?t ?r) (taken ?t from-place) (bears ?t none) (bears ?r none))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-000 ?t ?r) (not (bears ?r none)) (bears ?r one) (increase (total-cost) 128)))

  ; Primitive 010 on pairs of the kind 10110 (any-low-narrow-to-any-tall-narrow-10110): ends in the state
  ; 000 (rests-on-000) in 19 of 30 rehearsals, at (0.36, 0.15, 1.00) touching units from the reference: cost
  ; 48.
  ; With a third object on the reference: 1 of 5 went so, and it is forbidden.
  ; With a third object under the target: 9 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 8 went so, and it is forbidden.
  ; Action parameters: -0.0109 -0.0060 -0.0217 0.5689 -0.0417 -0.0030 0.0142 0.3413 0.0277 0.0119 -0.0097
  ; 0.3919
  (:action rests-on-000-by-010c-any-low-narrow-to-any-tall-narrow-10110
    :parameters (?t ?r - movable ?from - origin)
    :precondition (and (any-low-narrow-to-any-tall-narrow-10110 ?t ?r) (taken ?t ?from) (bears ?t none) (bears ?r none))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-000 ?t ?r) (not (bears ?r none)) (bears ?r one) (increase (total-cost) (cost-of-rests-on-000-by-010c-any-low-narrow-to-any-tall-narrow-10110 ?from))))

  ; Primitive 011 on pairs of the kind 00011 (solid-tall-to-any-low-wide-00011): ends in the state 000
  ; (rests-on-000) in 26 of 30 rehearsals, at (-0.13, 0.26, 1.00) touching units from the reference: cost
  ; 18.
  ; With a third object on the reference: 0 of 6 went so, and it is forbidden.
  ; With a third object under the target: 10 of 12 went so, and it is allowed.
  ; With a third object on the target: 1 of 6 went so, and it is forbidden.
  ; Action parameters: -0.0143 -0.0006 -0.0109 0.5509 0.0096 -0.0057 0.0107 0.1473 -0.0313 0.0320 -0.0274
  ; 0.3233
  (:action rests-on-000-by-011a-solid-tall-to-any-low-wide-00011
    :parameters (?t ?r - movable ?from - origin)
    :precondition (and (solid-tall-to-any-low-wide-00011 ?t ?r) (taken ?t ?from) (bears ?t none) (bears ?r none))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-000 ?t ?r) (not (bears ?r none)) (bears ?r one) (increase (total-cost) (cost-of-rests-on-000-by-011a-solid-tall-to-any-low-wide-00011 ?from))))

  ; Primitive 011 on pairs of the kind 01001 (any-low-to-any-low-wide-01001): ends in the state 000 (rests-
  ; on-000) in 30 of 30 rehearsals, at (0.07, 0.45, 1.00) touching units from the reference: cost 4.
  ; With a third object on the reference: 5 of 12 went so, and it is forbidden.
  ; With a third object under the target: 12 of 12 went so, and it is allowed.
  ; With a third object on the target: 2 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0086 -0.0045 -0.0080 0.5883 0.0228 0.0092 0.0238 0.0655 0.0003 0.0491 -0.0098
  ; 0.1509
  (:action rests-on-000-by-011b-any-low-to-any-low-wide-01001
    :parameters (?t ?r - movable ?from - origin)
    :precondition (and (any-low-to-any-low-wide-01001 ?t ?r) (taken ?t ?from) (bears ?t none) (bears ?r none))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-000 ?t ?r) (not (bears ?r none)) (bears ?r one) (increase (total-cost) (cost-of-rests-on-000-by-011b-any-low-to-any-low-wide-01001 ?from))))

  ; Primitive 011 on pairs of the kind 01010 (any-tall-narrow-to-hollow-low-wide-01010): ends in the state
  ; 000 (rests-on-000) in 8 of 30 rehearsals, at (-0.17, 0.46, 1.00) touching units from the reference: cost
  ; 128.
  ; With a third object on the reference: 0 of 5 went so, and it is forbidden.
  ; With a third object under the target: 0 of 5 went so, and it is forbidden.
  ; With a third object on the target: 0 of 1 went so, and it is forbidden.
  ; Action parameters: -0.0078 0.0013 -0.0151 1.0000 0.0002 -0.0314 -0.0250 0.0000 -0.0286 0.0500 0.0062
  ; 0.0841
  (:action rests-on-000-by-011c-any-tall-narrow-to-hollow-low-wide-01010
    :parameters (?t ?r - movable)
    :precondition (and (any-tall-narrow-to-hollow-low-wide-01010 ?t ?r) (taken ?t from-place) (bears ?t none) (bears ?r none))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-000 ?t ?r) (not (bears ?r none)) (bears ?r one) (increase (total-cost) 128)))

  ; Primitive 011 on pairs of the kind 01101 (any-tall-to-any-low-01101): ends in the state 000 (rests-
  ; on-000) in 29 of 30 rehearsals, at (-0.11, 0.31, 1.00) touching units from the reference: cost 7.
  ; With a third object on the reference: 2 of 12 went so, and it is forbidden.
  ; With a third object under the target: 12 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 1 went so, and it is forbidden.
  ; Action parameters: -0.0111 0.0065 -0.0003 0.5883 0.0250 0.0104 0.0204 0.0655 -0.0253 0.0310 -0.0414
  ; 0.9916
  (:action rests-on-000-by-011d-any-tall-to-any-low-01101
    :parameters (?t ?r - movable ?from - origin)
    :precondition (and (any-tall-to-any-low-01101 ?t ?r) (taken ?t ?from) (bears ?t none) (bears ?r none))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-000 ?t ?r) (not (bears ?r none)) (bears ?r one) (increase (total-cost) (cost-of-rests-on-000-by-011d-any-tall-to-any-low-01101 ?from))))

  ; Primitive 011 on pairs of the kind 01111 (any-tall-to-any-tall-wide-01111): ends in the state 000
  ; (rests-on-000) in 26 of 30 rehearsals, at (0.07, 0.12, 0.99) touching units from the reference: cost 18.
  ; With a third object on the reference: 0 of 5 went so, and it is forbidden.
  ; With a third object under the target: 6 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 4 went so, and it is forbidden.
  ; Action parameters: -0.0156 0.0023 -0.0154 0.5509 0.0020 -0.0110 0.0060 0.1473 -0.0077 0.0138 0.0185
  ; 0.0047
  (:action rests-on-000-by-011e-any-tall-to-any-tall-wide-01111
    :parameters (?t ?r - movable ?from - origin)
    :precondition (and (any-tall-to-any-tall-wide-01111 ?t ?r) (taken ?t ?from) (bears ?t none) (bears ?r none))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-000 ?t ?r) (not (bears ?r none)) (bears ?r one) (increase (total-cost) (cost-of-rests-on-000-by-011e-any-tall-to-any-tall-wide-01111 ?from))))

  ; Primitive 011 on pairs of the kind 10011 (solid-tall-to-solid-10011): ends in the state 000 (rests-
  ; on-000) in 27 of 30 rehearsals, at (-0.09, 0.11, 1.00) touching units from the reference: cost 14.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 1 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0168 -0.0010 0.0028 0.7139 0.0079 0.0050 -0.0020 0.0637 -0.0214 0.0147 0.0493
  ; 0.8912
  (:action rests-on-000-by-011f-solid-tall-to-solid-10011
    :parameters (?t ?r - movable)
    :precondition (and (solid-tall-to-solid-10011 ?t ?r) (taken ?t from-place) (bears ?t none) (bears ?r none))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-000 ?t ?r) (not (bears ?r none)) (bears ?r one) (increase (total-cost) 14)))

  ; Primitive 011 on pairs of the kind 10101 (any-tall-narrow-to-any-narrow-10101): ends in the state 000
  ; (rests-on-000) in 26 of 27 rehearsals, at (0.05, 0.18, 0.98) touching units from the reference: cost 8.
  ; With a third object on the reference: 0 of 3 went so, and it is forbidden.
  ; With a third object under the target: 11 of 12 went so, and it is allowed.
  ; With a third object on the target: 0 of 3 went so, and it is forbidden.
  ; Action parameters: -0.0006 -0.0100 0.0004 0.8535 -0.0024 -0.0002 0.0172 0.0931 0.0014 0.0206 -0.0357
  ; 0.4124
  (:action rests-on-000-by-011g-any-tall-narrow-to-any-narrow-10101
    :parameters (?t ?r - movable ?from - origin)
    :precondition (and (any-tall-narrow-to-any-narrow-10101 ?t ?r) (taken ?t ?from) (bears ?t none) (bears ?r none))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-000 ?t ?r) (not (bears ?r none)) (bears ?r one) (increase (total-cost) (cost-of-rests-on-000-by-011g-any-tall-narrow-to-any-narrow-10101 ?from))))

  ; Primitive 011 on pairs of the kind 10111 (any-tall-narrow-to-any-tall-narrow-10111): ends in the state
  ; 000 (rests-on-000) in 25 of 30 rehearsals, at (-0.02, 0.21, 1.00) touching units from the reference:
  ; cost 22.
  ; With a third object on the reference: 1 of 12 went so, and it is forbidden.
  ; With a third object under the target: 8 of 12 went so, and it is allowed.
  ; With a third object on the target: 3 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0119 -0.0007 -0.0074 0.5883 0.0188 0.0121 0.0232 0.0655 -0.0142 0.0157 -0.0211
  ; 0.9811
  (:action rests-on-000-by-011h-any-tall-narrow-to-any-tall-narrow-10111
    :parameters (?t ?r - movable ?from - origin)
    :precondition (and (any-tall-narrow-to-any-tall-narrow-10111 ?t ?r) (taken ?t ?from) (bears ?t none) (bears ?r none))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-000 ?t ?r) (not (bears ?r none)) (bears ?r one) (increase (total-cost) (cost-of-rests-on-000-by-011h-any-tall-narrow-to-any-tall-narrow-10111 ?from))))

  ; Primitive 011 on pairs of the kind 11110 (any-narrow-to-solid-low-narrow-11110): ends in the state 000
  ; (rests-on-000) in 26 of 30 rehearsals, at (0.02, 0.22, 1.00) touching units from the reference: cost 18.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 8 of 12 went so, and it is allowed.
  ; With a third object on the target: 2 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0063 -0.0102 -0.0246 0.5689 -0.0379 -0.0052 0.0080 0.3413 -0.0040 0.0133 -0.0343
  ; 0.9716
  (:action rests-on-000-by-011i-any-narrow-to-solid-low-narrow-11110
    :parameters (?t ?r - movable ?from - origin)
    :precondition (and (any-narrow-to-solid-low-narrow-11110 ?t ?r) (taken ?t ?from) (bears ?t none) (bears ?r none))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-000 ?t ?r) (not (bears ?r none)) (bears ?r one) (increase (total-cost) (cost-of-rests-on-000-by-011i-any-narrow-to-solid-low-narrow-11110 ?from))))

  ; Primitive 110 on pairs of the kind 01011 (hollow-tall-wide-to-any-wide-01011): ends in the state 000
  ; (rests-on-000) in 23 of 27 rehearsals, at (0.21, 0.28, 1.00) touching units from the reference: cost 20.
  ; With a third object on the reference: 2 of 11 went so, and it is forbidden.
  ; With a third object under the target: 6 of 6 went so, and it is allowed.
  ; With a third object on the target: 0 of 3 went so, and it is forbidden.
  ; Action parameters: -0.0043 -0.0212 0.0040 0.6460 0.0466 -0.0424 0.0138 0.0099 0.0237 -0.0131 0.0252
  ; 0.9375
  (:action rests-on-000-by-110a-hollow-tall-wide-to-any-wide-01011
    :parameters (?t ?r - movable ?from - origin)
    :precondition (and (hollow-tall-wide-to-any-wide-01011 ?t ?r) (taken ?t ?from) (bears ?t none) (bears ?r none))
    :effect (and (hand-empty) (not (taken ?t ?from)) (rests-on-000 ?t ?r) (not (bears ?r none)) (bears ?r one) (increase (total-cost) (cost-of-rests-on-000-by-110a-hollow-tall-wide-to-any-wide-01011 ?from))))

  ; Primitive 111 on pairs of the kind 11010 (hollow-low-wide-to-any-narrow-11010): ends in the state 000
  ; (rests-on-000) in 10 of 30 rehearsals, at (-0.10, -0.16, 1.00) touching units from the reference: cost
  ; 108.
  ; With a third object on the reference: 0 of 12 went so, and it is forbidden.
  ; With a third object under the target: 5 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 12 went so, and it is forbidden.
  ; Action parameters: -0.0008 0.0349 -0.0025 0.6572 0.0129 0.0349 0.0056 0.3941 -0.0140 0.0500 0.0225
  ; 0.8199
  (:action rests-on-000-by-111b-hollow-low-wide-to-any-narrow-11010
    :parameters (?t ?r - movable)
    :precondition (and (hollow-low-wide-to-any-narrow-11010 ?t ?r) (taken ?t from-place) (bears ?t none) (bears ?r none))
    :effect (and (hand-empty) (not (taken ?t from-place)) (rests-on-000 ?t ?r) (not (bears ?r none)) (bears ?r one) (increase (total-cost) 108)))

  ; Primitive 001 on pairs of the kind 00110 (any-tall-narrow-to-hollow-wide-00110): ends in the state 100
  ; (sits-in-100) in 9 of 30 rehearsals, at (-0.20, -0.05, 0.13) touching units from the reference: cost
  ; 117.
  ; With a third object on the reference: 0 of 6 went so, and it is forbidden.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: -0.0034 0.0099 -0.0029 0.6141 -0.0196 -0.0087 -0.0076 0.2882 -0.0274 -0.0026 0.0074
  ; 0.2073
  (:action sits-in-100-by-001b-any-tall-narrow-to-hollow-wide-00110
    :parameters (?t ?r - movable)
    :precondition (and (any-tall-narrow-to-hollow-wide-00110 ?t ?r) (taken ?t from-place) (bears ?t none) (bears ?r none))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-100 ?t ?r) (not (bears ?r none)) (bears ?r one) (increase (total-cost) 117)))

  ; Primitive 001 on pairs of the kind 00010 (solid-tall-narrow-to-hollow-low-wide-00010): ends in the state
  ; 101 (sits-in-101) in 10 of 30 rehearsals, at (-0.17, -0.03, 0.19) touching units from the reference:
  ; cost 108.
  ; With a third object on the reference: 0 of 10 went so, and it is forbidden.
  ; With a third object under the target: 1 of 6 went so, and it is forbidden.
  ; With a third object on the target: 0 of 4 went so, and it is forbidden.
  ; Action parameters: -0.0018 0.0023 0.0070 0.7350 0.0289 -0.0064 -0.0150 0.2442 -0.0500 -0.0024 0.0146
  ; 0.4335
  (:action sits-in-101-by-001a-solid-tall-narrow-to-hollow-low-wide-00010
    :parameters (?t ?r - movable)
    :precondition (and (solid-tall-narrow-to-hollow-low-wide-00010 ?t ?r) (taken ?t from-place) (bears ?t none) (bears ?r none))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-101 ?t ?r) (not (bears ?r none)) (bears ?r one) (increase (total-cost) 108)))

  ; Primitive 001 on pairs of the kind 00110 (any-tall-narrow-to-hollow-wide-00110): ends in the state 101
  ; (sits-in-101) in 12 of 30 rehearsals, at (-0.19, -0.05, 0.04) touching units from the reference: cost
  ; 91.
  ; With a third object on the reference: 4 of 6 went so, and it is allowed.
  ; With a third object under the target: 0 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 5 went so, and it is forbidden.
  ; Action parameters: -0.0034 0.0099 -0.0029 0.6141 -0.0196 -0.0087 -0.0076 0.2882 -0.0274 -0.0026 0.0074
  ; 0.2073
  (:action sits-in-101-by-001b-any-tall-narrow-to-hollow-wide-00110
    :parameters (?t ?r - movable ?n ?more - count)
    :precondition (and (any-tall-narrow-to-hollow-wide-00110 ?t ?r) (taken ?t from-place) (bears ?t none) (bears ?r ?n) (next ?n ?more))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-101 ?t ?r) (not (bears ?r ?n)) (bears ?r ?more) (increase (total-cost) (cost-of-sits-in-101-by-001b-any-tall-narrow-to-hollow-wide-00110 ?n))))

  ; Primitive 111 on pairs of the kind 11001 (hollow-wide-to-hollow-low-wide-11001): ends in the state 101
  ; (sits-in-101) in 8 of 30 rehearsals, at (-0.03, -0.06, 0.07) touching units from the reference: cost
  ; 128.
  ; With a third object on the reference: 8 of 12 went so, and it is allowed.
  ; With a third object under the target: 1 of 12 went so, and it is forbidden.
  ; With a third object on the target: 0 of 6 went so, and it is forbidden.
  ; Action parameters: -0.0089 0.0337 -0.0195 0.9910 -0.0468 -0.0043 -0.0097 0.2028 -0.0021 0.0472 0.0455
  ; 0.4117
  (:action sits-in-101-by-111a-hollow-wide-to-hollow-low-wide-11001
    :parameters (?t ?r - movable ?n ?more - count)
    :precondition (and (hollow-wide-to-hollow-low-wide-11001 ?t ?r) (taken ?t from-place) (bears ?t none) (bears ?r ?n) (next ?n ?more))
    :effect (and (hand-empty) (not (taken ?t from-place)) (sits-in-101 ?t ?r) (not (bears ?r ?n)) (bears ?r ?more) (increase (total-cost) (cost-of-sits-in-101-by-111a-hollow-wide-to-hollow-low-wide-11001 ?n))))

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
    :precondition (and (can-carry-to-001a-any-tall-narrow-11 ?o) (taken ?o ?from) (free ?to) (bears ?o none) (room ?o ?to nowhere))
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
    :precondition (and (can-carry-to-001a-hollow-wide-00 ?o) (taken ?o ?from) (free ?to) (bears ?o none) (room ?o ?to nowhere))
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
    :precondition (and (can-carry-to-001b-solid-low-narrow-01 ?o) (taken ?o ?from) (free ?to) (bears ?o none) (room ?o ?to nowhere))
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
    :precondition (and (can-carry-to-010-solid-low-10 ?o) (taken ?o ?from) (free ?to) (bears ?o none) (room ?o ?to nowhere))
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
    :precondition (and (can-carry-to-010-solid-low-narrow-01 ?o) (taken ?o ?from) (free ?to) (bears ?o none) (room ?o ?to nowhere))
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
    :precondition (and (can-carry-to-010a-hollow-wide-00 ?o) (taken ?o ?from) (free ?to) (bears ?o none) (room ?o ?to nowhere))
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
    :precondition (and (can-carry-to-010b-any-tall-narrow-11 ?o) (taken ?o ?from) (free ?to) (bears ?o none) (room ?o ?to nowhere))
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
    :precondition (and (can-carry-to-011a-hollow-wide-00 ?o) (taken ?o ?from) (free ?to) (bears ?o none) (room ?o ?to nowhere))
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
    :precondition (and (can-carry-to-011b-solid-low-narrow-01 ?o) (taken ?o ?from) (free ?to) (bears ?o none) (room ?o ?to nowhere))
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
    :precondition (and (can-carry-to-011c-solid-low-10 ?o) (taken ?o ?from) (free ?to) (bears ?o none) (room ?o ?to nowhere))
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
    :precondition (and (can-carry-to-011d-any-tall-narrow-11 ?o) (taken ?o ?from) (free ?to) (bears ?o none) (room ?o ?to nowhere))
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
    :precondition (and (can-carry-to-100-any-tall-narrow-11 ?o) (taken ?o ?from) (free ?to) (bears ?o none) (room ?o ?to nowhere))
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
    :precondition (and (can-carry-to-100-solid-low-10 ?o) (taken ?o ?from) (free ?to) (bears ?o none) (room ?o ?to nowhere))
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
    :precondition (and (can-carry-to-100-solid-low-narrow-01 ?o) (taken ?o ?from) (free ?to) (bears ?o none) (room ?o ?to nowhere))
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
    :precondition (and (can-carry-to-100a-hollow-wide-00 ?o) (taken ?o ?from) (free ?to) (bears ?o none) (room ?o ?to nowhere))
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
    :precondition (and (can-carry-to-101-any-tall-narrow-11 ?o) (taken ?o ?from) (free ?to) (bears ?o none) (room ?o ?to nowhere))
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
    :precondition (and (can-carry-to-101-solid-low-10 ?o) (taken ?o ?from) (free ?to) (bears ?o none) (room ?o ?to nowhere))
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
    :precondition (and (can-carry-to-101a-hollow-wide-00 ?o) (taken ?o ?from) (free ?to) (bears ?o none) (room ?o ?to nowhere))
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
    :precondition (and (can-carry-to-101b-solid-low-narrow-01 ?o) (taken ?o ?from) (free ?to) (bears ?o none) (room ?o ?to nowhere))
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
    :precondition (and (can-carry-to-110-solid-low-10 ?o) (taken ?o ?from) (free ?to) (bears ?o none) (room ?o ?to nowhere))
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
    :precondition (and (can-carry-to-110-solid-low-narrow-01 ?o) (taken ?o ?from) (free ?to) (bears ?o none) (room ?o ?to nowhere))
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
    :precondition (and (can-carry-to-110a-hollow-wide-00 ?o) (taken ?o ?from) (free ?to) (bears ?o none) (room ?o ?to nowhere))
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
    :precondition (and (can-carry-to-110b-any-tall-narrow-11 ?o) (taken ?o ?from) (free ?to) (bears ?o none) (room ?o ?to nowhere))
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
    :precondition (and (can-carry-to-111-solid-low-narrow-01 ?o) (taken ?o ?from) (free ?to) (bears ?o none) (room ?o ?to nowhere))
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
    :precondition (and (can-carry-to-111a-hollow-wide-00 ?o) (taken ?o ?from) (free ?to) (bears ?o none) (room ?o ?to nowhere))
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
    :precondition (and (can-carry-to-111b-solid-low-10 ?o) (taken ?o ?from) (free ?to) (bears ?o none) (room ?o ?to nowhere))
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
    :precondition (and (can-carry-to-111c-any-tall-narrow-11 ?o) (taken ?o ?from) (free ?to) (bears ?o none) (room ?o ?to nowhere))
    :effect (and (hand-empty) (not (taken ?o ?from)) (stands ?o ?to) (not (free ?to)) (increase (total-cost) (cost-of-carry-to-111c-any-tall-narrow-11 ?o ?from))))

  ; Note that a place is free that another overlaps.
  (:action look-on
    :parameters (?o - movable ?p ?here ?next - place)
    :precondition (and (room ?o ?p ?here) (free ?here) (look-next ?o ?p ?here ?next))
    :effect (and (room ?o ?p ?next) (increase (total-cost) 0)))

  ; Note that an object stands where its goal is.
  (:action reach-place
    :parameters (?o - movable ?p - place)
    :precondition (and (stands ?o ?p) (goal-place ?o ?p))
    :effect (and (done ?o) (increase (total-cost) 0)))

  ; Left out:
  ; beside-001-by-000-solid-low-to-any-narrow-11111: fewer than 5 rehearsals.
  ; beside-001-by-010-solid-low-to-any-narrow-11111: fewer than 5 rehearsals.
  ; beside-001-by-110-solid-low-to-any-narrow-11111: fewer than 5 rehearsals.
  ; beside-001-by-111-solid-low-to-any-narrow-11111: fewer than 5 rehearsals.
  ; leans-on-010-by-000-solid-low-to-any-narrow-11111: fewer than 5 rehearsals.
  ; leans-on-010-by-000f-hollow-low-wide-to-any-low-narrow-11000: does less surely what leans-
  ; on-010-by-000g-hollow-low-wide-to-any-low-narrow-11000 does.
  ; leans-on-010-by-001-solid-low-to-any-narrow-11111: fewer than 5 rehearsals.
  ; leans-on-010-by-101-solid-low-to-any-narrow-11111: fewer than 5 rehearsals.
  ; miss-by-100-solid-low-to-any-narrow-11111: fewer than 5 rehearsals.
  ; rests-on-000-by-000e-solid-low-to-hollow-wide-01100: fewer than 5 rehearsals.
  ; rests-on-000-by-000g-hollow-low-wide-to-any-low-narrow-11000: does less surely what rests-
  ; on-000-by-000f-hollow-low-wide-to-any-low-narrow-11000 does.
  ; rests-on-000-by-000i-hollow-low-to-solid-tall-narrow-11101: fewer than 5 rehearsals.
  ; rests-on-000-by-011-solid-low-to-any-narrow-11111: fewer than 5 rehearsals.
  ; rests-on-000-by-101-solid-low-to-any-narrow-11111: fewer than 5 rehearsals.
  ; sits-in-100-by-000e-solid-low-to-hollow-wide-01100: fewer than 5 rehearsals.
)
