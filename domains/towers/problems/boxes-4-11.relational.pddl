; Problem boxes-4-11 of the learned domain tabletop, for its encoding relational.
; How it came about: boxes, drawn with seed 12; draw 2.
; States in which one object bears another: rests-on-000, leans-on-010, sits-in-100, sits-in-101.
; Objects stand at start-... at first, and none goes back there; park-... are places to wait at.
(define (problem boxes-4-11)
  (:domain tabletop)
  (:objects
    item-01 - any-tall-narrow-11
    item-02 - solid-low-10
    item-03 - solid-low-10
    item-04 - any-tall-narrow-11
    start-item-01 start-item-02 start-item-03 start-item-04 park-01 park-02 park-03 park-04 - place
    count-2 - count)
  (:init
    (hand-empty) (= (total-cost) 0)
    (stands item-01 start-item-01) (bears item-01 none)
    (stands item-02 start-item-02) (bears item-02 none)
    (stands item-03 start-item-03) (bears item-03 none)
    (stands item-04 start-item-04) (bears item-04 none)
    ; park-01 lies at (0.8475, 0.1867) m
    (free park-01)
    (room item-01 park-01 nowhere)
    (room item-03 park-01 nowhere)
    (room item-04 park-01 nowhere)
    ; park-02 lies at (0.4434, 0.0635) m
    (free park-02)
    (room item-01 park-02 nowhere)
    (room item-03 park-02 nowhere)
    (room item-04 park-02 nowhere)
    ; park-03 lies at (0.6208, 0.0052) m
    (free park-03)
    (room item-01 park-03 nowhere)
    (room item-03 park-03 nowhere)
    (room item-04 park-03 nowhere)
    ; park-04 lies at (0.8627, -0.1985) m
    (free park-04)
    (room item-01 park-04 nowhere)
    (room item-03 park-04 nowhere)
    (room item-04 park-04 nowhere)
    (can-be-taken item-01)
    (can-be-taken item-02)
    (can-be-taken item-03)
    (can-be-taken item-04)
    (any-tall-to-any-tall-wide-01111 item-01 item-02) (any-tall-to-any-tall-wide-01111 item-01 item-03) (any-tall-to-any-low-01101 item-01 item-04)
    (solid-low-to-any-10010 item-02 item-01) (solid-low-to-any-10010 item-02 item-03) (solid-low-to-any-10010 item-02 item-04)
    (solid-low-to-any-10010 item-03 item-01) (solid-tall-to-solid-10011 item-03 item-02) (solid-low-to-any-10010 item-03 item-04)
    (hollow-low-wide-to-any-narrow-11010 item-04 item-01) (hollow-wide-to-hollow-low-wide-11001 item-04 item-02) (hollow-wide-to-hollow-low-wide-11001 item-04 item-03)
    (next none one) (next one count-2)
    (= (cost-of-leans-on-010-by-000g-hollow-low-wide-to-any-low-narrow-11000 none) 53) (= (cost-of-leans-on-010-by-000g-hollow-low-wide-to-any-low-narrow-11000 one) 70) (= (cost-of-leans-on-010-by-000g-hollow-low-wide-to-any-low-narrow-11000 count-2) 70)
    (= (cost-of-leans-on-010-by-000h-hollow-wide-to-hollow-low-wide-11011 none) 77) (= (cost-of-leans-on-010-by-000h-hollow-wide-to-hollow-low-wide-11011 one) 77) (= (cost-of-leans-on-010-by-000h-hollow-wide-to-hollow-low-wide-11011 count-2) 77)
    (= (cost-of-leans-on-010-by-011c-any-tall-narrow-to-hollow-low-wide-01010 none) 64) (= (cost-of-leans-on-010-by-011c-any-tall-narrow-to-hollow-low-wide-01010 one) 64) (= (cost-of-leans-on-010-by-011c-any-tall-narrow-to-hollow-low-wide-01010 count-2) 64)
    (= (cost-of-leans-on-010-by-111b-hollow-low-wide-to-any-narrow-11010 none) 70) (= (cost-of-leans-on-010-by-111b-hollow-low-wide-to-any-narrow-11010 one) 70) (= (cost-of-leans-on-010-by-111b-hollow-low-wide-to-any-narrow-11010 count-2) 70)
    (= (cost-of-rests-on-000-by-000b-any-tall-narrow-to-any-tall-narrow-00101 from-place) 18) (= (cost-of-rests-on-000-by-000b-any-tall-narrow-to-any-tall-narrow-00101 from-object) 45)
    (= (cost-of-rests-on-000-by-000b-any-tall-narrow-to-any-tall-narrow-00101-laden from-place) 18) (= (cost-of-rests-on-000-by-000b-any-tall-narrow-to-any-tall-narrow-00101-laden from-object) 45)
    (= (cost-of-rests-on-000-by-000c-any-tall-narrow-to-any-tall-00111 from-place) 22) (= (cost-of-rests-on-000-by-000c-any-tall-narrow-to-any-tall-00111 from-object) 57)
    (= (cost-of-rests-on-000-by-010a-any-narrow-to-any-tall-wide-01110 from-place) 53) (= (cost-of-rests-on-000-by-010a-any-narrow-to-any-tall-wide-01110 from-object) 57)
    (= (cost-of-rests-on-000-by-010c-any-low-narrow-to-any-tall-narrow-10110 from-place) 48) (= (cost-of-rests-on-000-by-010c-any-low-narrow-to-any-tall-narrow-10110 from-object) 48)
    (= (cost-of-rests-on-000-by-011a-solid-tall-to-any-low-wide-00011 from-place) 18) (= (cost-of-rests-on-000-by-011a-solid-tall-to-any-low-wide-00011 from-object) 25)
    (= (cost-of-rests-on-000-by-011b-any-low-to-any-low-wide-01001 from-place) 4) (= (cost-of-rests-on-000-by-011b-any-low-to-any-low-wide-01001 from-object) 8)
    (= (cost-of-rests-on-000-by-011d-any-tall-to-any-low-01101 from-place) 7) (= (cost-of-rests-on-000-by-011d-any-tall-to-any-low-01101 from-object) 8)
    (= (cost-of-rests-on-000-by-011e-any-tall-to-any-tall-wide-01111 from-place) 18) (= (cost-of-rests-on-000-by-011e-any-tall-to-any-tall-wide-01111 from-object) 70)
    (= (cost-of-rests-on-000-by-011g-any-tall-narrow-to-any-narrow-10101 from-place) 8) (= (cost-of-rests-on-000-by-011g-any-tall-narrow-to-any-narrow-10101 from-object) 16)
    (= (cost-of-rests-on-000-by-011h-any-tall-narrow-to-any-tall-narrow-10111 from-place) 22) (= (cost-of-rests-on-000-by-011h-any-tall-narrow-to-any-tall-narrow-10111 from-object) 45)
    (= (cost-of-rests-on-000-by-011i-any-narrow-to-solid-low-narrow-11110 from-place) 18) (= (cost-of-rests-on-000-by-011i-any-narrow-to-solid-low-narrow-11110 from-object) 45)
    (= (cost-of-rests-on-000-by-110a-hollow-tall-wide-to-any-wide-01011 from-place) 20) (= (cost-of-rests-on-000-by-110a-hollow-tall-wide-to-any-wide-01011 from-object) 20)
    (= (cost-of-sits-in-101-by-001b-any-tall-narrow-to-hollow-wide-00110 none) 91) (= (cost-of-sits-in-101-by-001b-any-tall-narrow-to-hollow-wide-00110 one) 91) (= (cost-of-sits-in-101-by-001b-any-tall-narrow-to-hollow-wide-00110 count-2) 91)
    (= (cost-of-sits-in-101-by-111a-hollow-wide-to-hollow-low-wide-11001 none) 128) (= (cost-of-sits-in-101-by-111a-hollow-wide-to-hollow-low-wide-11001 one) 128) (= (cost-of-sits-in-101-by-111a-hollow-wide-to-hollow-low-wide-11001 count-2) 128)
    (can-carry-to-011d-any-tall-narrow-11 item-01) (= (cost-of-carry-to-001a-any-tall-narrow-11 item-01 from-place) 7) (= (cost-of-carry-to-001a-any-tall-narrow-11 item-01 from-object) 7) (= (cost-of-carry-to-010b-any-tall-narrow-11 item-01 from-place) 7) (= (cost-of-carry-to-010b-any-tall-narrow-11 item-01 from-object) 7) (= (cost-of-carry-to-011d-any-tall-narrow-11 item-01 from-place) 4) (= (cost-of-carry-to-011d-any-tall-narrow-11 item-01 from-object) 4) (= (cost-of-carry-to-100-any-tall-narrow-11 item-01 from-place) 4) (= (cost-of-carry-to-100-any-tall-narrow-11 item-01 from-object) 4) (= (cost-of-carry-to-101-any-tall-narrow-11 item-01 from-place) 7) (= (cost-of-carry-to-101-any-tall-narrow-11 item-01 from-object) 7) (= (cost-of-carry-to-110b-any-tall-narrow-11 item-01 from-place) 7) (= (cost-of-carry-to-110b-any-tall-narrow-11 item-01 from-object) 7) (= (cost-of-carry-to-111c-any-tall-narrow-11 item-01 from-place) 4) (= (cost-of-carry-to-111c-any-tall-narrow-11 item-01 from-object) 4)
    (= (cost-of-carry-to-010-solid-low-10 item-02 from-place) 281) (= (cost-of-carry-to-010-solid-low-10 item-02 from-object) 281) (= (cost-of-carry-to-011c-solid-low-10 item-02 from-place) 241) (= (cost-of-carry-to-011c-solid-low-10 item-02 from-object) 241) (= (cost-of-carry-to-100-solid-low-10 item-02 from-place) 241) (= (cost-of-carry-to-100-solid-low-10 item-02 from-object) 241) (= (cost-of-carry-to-101-solid-low-10 item-02 from-place) 190) (= (cost-of-carry-to-101-solid-low-10 item-02 from-object) 190) (= (cost-of-carry-to-110-solid-low-10 item-02 from-place) 281) (= (cost-of-carry-to-110-solid-low-10 item-02 from-object) 281) (= (cost-of-carry-to-111b-solid-low-10 item-02 from-place) 241) (= (cost-of-carry-to-111b-solid-low-10 item-02 from-object) 241)
    (can-carry-to-111b-solid-low-10 item-03) (= (cost-of-carry-to-010-solid-low-10 item-03 from-place) 281) (= (cost-of-carry-to-010-solid-low-10 item-03 from-object) 281) (= (cost-of-carry-to-011c-solid-low-10 item-03 from-place) 42) (= (cost-of-carry-to-011c-solid-low-10 item-03 from-object) 42) (= (cost-of-carry-to-100-solid-low-10 item-03 from-place) 94) (= (cost-of-carry-to-100-solid-low-10 item-03 from-object) 94) (= (cost-of-carry-to-101-solid-low-10 item-03 from-place) 190) (= (cost-of-carry-to-101-solid-low-10 item-03 from-object) 190) (= (cost-of-carry-to-110-solid-low-10 item-03 from-place) 281) (= (cost-of-carry-to-110-solid-low-10 item-03 from-object) 281) (= (cost-of-carry-to-111b-solid-low-10 item-03 from-place) 11) (= (cost-of-carry-to-111b-solid-low-10 item-03 from-object) 11)
    (can-carry-to-011d-any-tall-narrow-11 item-04) (= (cost-of-carry-to-001a-any-tall-narrow-11 item-04 from-place) 7) (= (cost-of-carry-to-001a-any-tall-narrow-11 item-04 from-object) 7) (= (cost-of-carry-to-010b-any-tall-narrow-11 item-04 from-place) 7) (= (cost-of-carry-to-010b-any-tall-narrow-11 item-04 from-object) 7) (= (cost-of-carry-to-011d-any-tall-narrow-11 item-04 from-place) 4) (= (cost-of-carry-to-011d-any-tall-narrow-11 item-04 from-object) 4) (= (cost-of-carry-to-100-any-tall-narrow-11 item-04 from-place) 4) (= (cost-of-carry-to-100-any-tall-narrow-11 item-04 from-object) 4) (= (cost-of-carry-to-101-any-tall-narrow-11 item-04 from-place) 7) (= (cost-of-carry-to-101-any-tall-narrow-11 item-04 from-object) 7) (= (cost-of-carry-to-110b-any-tall-narrow-11 item-04 from-place) 7) (= (cost-of-carry-to-110b-any-tall-narrow-11 item-04 from-object) 7) (= (cost-of-carry-to-111c-any-tall-narrow-11 item-04 from-place) 4) (= (cost-of-carry-to-111c-any-tall-narrow-11 item-04 from-object) 4))
  (:goal (and (rests-on-000 item-03 item-02) (rests-on-000 item-01 item-04)))
  (:metric minimize (total-cost)))
