; Problem anywhere-8-20 of the learned domain tabletop, for its encoding relational.
; How it came about: anywhere, drawn with seed 21; draw 1.
; States in which one object bears another: rests-on-000, leans-on-010, sits-in-100, sits-in-101.
; Objects stand at start-... at first, and none goes back there; park-... are places to wait at.
(define (problem anywhere-8-20)
  (:domain tabletop)
  (:objects
    item-01 - solid-low-10
    item-02 - solid-low-10
    item-03 - solid-low-narrow-01
    item-04 - solid-low-10
    item-05 - hollow-wide-00
    item-06 - any-tall-narrow-11
    item-07 - any-tall-narrow-11
    item-08 - solid-low-narrow-01
    start-item-01 start-item-02 start-item-03 start-item-04 start-item-05 start-item-07 start-item-08 goal-item-01 goal-item-02 goal-item-03 goal-item-04 goal-item-05 goal-item-06 goal-item-07 goal-item-08 park-01 park-02 park-03 park-04 park-05 park-06 park-07 park-08 - place
    count-2 - count)
  (:init
    (hand-empty) (= (total-cost) 0)
    (stands item-01 start-item-01) (bears item-01 none)
    (stands item-02 start-item-02) (bears item-02 none)
    (stands item-03 start-item-03) (bears item-03 none)
    (stands item-04 start-item-04) (bears item-04 none)
    (stands item-05 start-item-05) (bears item-05 none)
    (sits-in-100 item-06 item-08) (bears item-06 none)
    (stands item-07 start-item-07) (bears item-07 none)
    (stands item-08 start-item-08) (bears item-08 one)
    ; goal-item-01 lies at (0.7756, 0.0151) m
    (free goal-item-01)
    (goal-place item-01 goal-item-01) (room item-01 goal-item-01 nowhere)
    ; goal-item-02 lies at (0.6781, 0.0980) m
    (free goal-item-02)
    (goal-place item-02 goal-item-02) (room item-02 goal-item-02 nowhere)
    ; goal-item-03 lies at (0.5837, -0.2588) m
    (free goal-item-03)
    (goal-place item-03 goal-item-03) (room item-03 goal-item-03 start-item-02) (look-next item-03 goal-item-03 start-item-02 nowhere)
    ; goal-item-04 lies at (0.6629, -0.1054) m
    (free goal-item-04)
    ; goal-item-05 lies at (0.5246, -0.0139) m
    (free goal-item-05)
    (goal-place item-05 goal-item-05) (room item-05 goal-item-05 start-item-03) (look-next item-05 goal-item-05 start-item-03 nowhere)
    ; goal-item-06 lies at (0.5689, 0.1806) m
    (free goal-item-06)
    (goal-place item-06 goal-item-06) (room item-06 goal-item-06 start-item-05) (look-next item-06 goal-item-06 start-item-05 nowhere)
    ; goal-item-07 lies at (0.7576, -0.1568) m
    (free goal-item-07)
    (goal-place item-07 goal-item-07) (room item-07 goal-item-07 nowhere)
    ; goal-item-08 lies at (0.8359, 0.1524) m
    (free goal-item-08)
    (goal-place item-08 goal-item-08) (room item-08 goal-item-08 start-item-01) (look-next item-08 goal-item-08 start-item-01 nowhere)
    ; park-01 lies at (0.8825, -0.2110) m
    (free park-01)
    (room item-01 park-01 nowhere)
    (room item-02 park-01 nowhere)
    (room item-03 park-01 start-item-08) (look-next item-03 park-01 start-item-08 nowhere)
    (room item-06 park-01 nowhere)
    (room item-07 park-01 nowhere)
    (room item-08 park-01 nowhere)
    ; park-02 lies at (0.6721, 0.2264) m
    (free park-02)
    (room item-06 park-02 nowhere)
    (room item-07 park-02 nowhere)
    (room item-08 park-02 start-item-01) (look-next item-08 park-02 start-item-01 nowhere)
    ; park-03 lies at (0.9022, 0.2502) m
    (free park-03)
    (room item-01 park-03 nowhere)
    (room item-02 park-03 nowhere)
    (room item-03 park-03 nowhere)
    (room item-06 park-03 nowhere)
    (room item-07 park-03 nowhere)
    (room item-08 park-03 nowhere)
    ; park-04 lies at (0.8283, 0.2024) m
    (free park-04)
    ; park-05 lies at (0.8480, 0.0052) m
    (free park-05)
    (room item-01 park-05 nowhere)
    ; park-06 lies at (0.8478, -0.0860) m
    (free park-06)
    ; park-07 lies at (0.3988, -0.0473) m
    (free park-07)
    (room item-01 park-07 start-item-03) (look-next item-01 park-07 start-item-03 nowhere)
    (room item-02 park-07 start-item-03) (look-next item-02 park-07 start-item-03 nowhere)
    ; park-08 lies at (0.8650, 0.0939) m
    (free park-08)
    (room item-08 park-08 nowhere)
    (can-be-taken item-01)
    (can-be-taken item-02)
    (can-be-taken item-03)
    (can-be-taken item-04)
    (can-be-taken item-05)
    (can-be-taken item-06)
    (can-be-taken item-07)
    (can-be-taken item-08)
    (hollow-wide-to-hollow-low-wide-11001 item-01 item-02) (solid-low-to-any-10010 item-01 item-03) (hollow-wide-to-hollow-low-wide-11011 item-01 item-04) (hollow-low-wide-to-any-narrow-11010 item-01 item-05) (any-low-narrow-to-any-tall-narrow-10110 item-01 item-06) (any-low-narrow-to-any-tall-narrow-10110 item-01 item-07) (hollow-low-wide-to-any-narrow-11010 item-01 item-08)
    (solid-low-to-any-10010 item-02 item-01) (solid-low-to-any-10010 item-02 item-03) (solid-low-to-any-10010 item-02 item-04) (solid-low-to-any-10010 item-02 item-05) (solid-low-to-any-10010 item-02 item-06) (solid-low-to-any-10010 item-02 item-07) (solid-low-to-any-10010 item-02 item-08)
    (any-tall-to-any-low-01101 item-03 item-01) (any-low-to-any-low-wide-01001 item-03 item-02) (any-low-to-any-low-wide-01001 item-03 item-04) (solid-low-narrow-to-hollow-low-wide-01000 item-03 item-05) (any-tall-to-any-low-01101 item-03 item-06) (any-tall-narrow-to-any-tall-narrow-00101 item-03 item-07) (any-narrow-to-solid-low-narrow-11110 item-03 item-08)
    (solid-low-to-any-10010 item-04 item-01) (solid-low-to-any-10010 item-04 item-02) (solid-low-to-any-10010 item-04 item-03) (solid-low-to-any-10010 item-04 item-05) (solid-low-to-any-10010 item-04 item-06) (solid-low-to-any-10010 item-04 item-07) (solid-low-to-any-10010 item-04 item-08)
    (hollow-low-wide-to-any-narrow-11010 item-05 item-01) (hollow-low-wide-to-any-low-narrow-11000 item-05 item-02) (hollow-low-wide-to-any-narrow-11010 item-05 item-03) (hollow-low-wide-to-any-narrow-11010 item-05 item-04) (hollow-low-wide-to-any-narrow-11010 item-05 item-06) (hollow-low-wide-to-any-narrow-11010 item-05 item-07) (hollow-low-wide-to-any-narrow-11010 item-05 item-08)
    (any-tall-narrow-to-any-tall-narrow-10111 item-06 item-01) (hollow-wide-to-hollow-low-wide-11001 item-06 item-02) (any-narrow-to-solid-low-narrow-11110 item-06 item-03) (any-low-to-any-low-wide-01001 item-06 item-04) (any-tall-narrow-to-hollow-low-wide-01010 item-06 item-05) (any-tall-narrow-to-any-tall-narrow-10111 item-06 item-07) (any-narrow-to-solid-low-narrow-11110 item-06 item-08)
    (any-tall-narrow-to-any-tall-narrow-10111 item-07 item-01) (any-tall-to-any-low-01101 item-07 item-02) (any-narrow-to-solid-low-narrow-11110 item-07 item-03) (any-tall-to-any-low-01101 item-07 item-04) (any-tall-narrow-to-hollow-low-wide-01010 item-07 item-05) (any-tall-narrow-to-any-tall-narrow-10111 item-07 item-06) (any-narrow-to-solid-low-narrow-11110 item-07 item-08)
    (any-tall-narrow-to-any-tall-narrow-00101 item-08 item-01) (any-low-to-any-low-wide-01001 item-08 item-02) (any-narrow-to-solid-low-narrow-11110 item-08 item-03) (any-low-to-any-low-wide-01001 item-08 item-04) (solid-low-narrow-to-hollow-low-wide-01000 item-08 item-05) (any-tall-to-any-low-01101 item-08 item-06) (any-tall-narrow-to-any-tall-narrow-00101 item-08 item-07)
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
    (can-carry-to-111b-solid-low-10 item-01) (= (cost-of-carry-to-010-solid-low-10 item-01 from-place) 281) (= (cost-of-carry-to-010-solid-low-10 item-01 from-object) 281) (= (cost-of-carry-to-011c-solid-low-10 item-01 from-place) 67) (= (cost-of-carry-to-011c-solid-low-10 item-01 from-object) 67) (= (cost-of-carry-to-100-solid-low-10 item-01 from-place) 25) (= (cost-of-carry-to-100-solid-low-10 item-01 from-object) 25) (= (cost-of-carry-to-101-solid-low-10 item-01 from-place) 190) (= (cost-of-carry-to-101-solid-low-10 item-01 from-object) 190) (= (cost-of-carry-to-110-solid-low-10 item-01 from-place) 281) (= (cost-of-carry-to-110-solid-low-10 item-01 from-object) 281) (= (cost-of-carry-to-111b-solid-low-10 item-01 from-place) 11) (= (cost-of-carry-to-111b-solid-low-10 item-01 from-object) 11)
    (can-carry-to-111b-solid-low-10 item-02) (= (cost-of-carry-to-010-solid-low-10 item-02 from-place) 281) (= (cost-of-carry-to-010-solid-low-10 item-02 from-object) 281) (= (cost-of-carry-to-011c-solid-low-10 item-02 from-place) 171) (= (cost-of-carry-to-011c-solid-low-10 item-02 from-object) 171) (= (cost-of-carry-to-100-solid-low-10 item-02 from-place) 212) (= (cost-of-carry-to-100-solid-low-10 item-02 from-object) 212) (= (cost-of-carry-to-101-solid-low-10 item-02 from-place) 190) (= (cost-of-carry-to-101-solid-low-10 item-02 from-object) 190) (= (cost-of-carry-to-110-solid-low-10 item-02 from-place) 281) (= (cost-of-carry-to-110-solid-low-10 item-02 from-object) 281) (= (cost-of-carry-to-111b-solid-low-10 item-02 from-place) 111) (= (cost-of-carry-to-111b-solid-low-10 item-02 from-object) 111)
    (can-carry-to-100-solid-low-narrow-01 item-03) (= (cost-of-carry-to-001b-solid-low-narrow-01 item-03 from-place) 7) (= (cost-of-carry-to-001b-solid-low-narrow-01 item-03 from-object) 7) (= (cost-of-carry-to-010-solid-low-narrow-01 item-03 from-place) 7) (= (cost-of-carry-to-010-solid-low-narrow-01 item-03 from-object) 7) (= (cost-of-carry-to-011b-solid-low-narrow-01 item-03 from-place) 4) (= (cost-of-carry-to-011b-solid-low-narrow-01 item-03 from-object) 4) (= (cost-of-carry-to-100-solid-low-narrow-01 item-03 from-place) 4) (= (cost-of-carry-to-100-solid-low-narrow-01 item-03 from-object) 4) (= (cost-of-carry-to-101b-solid-low-narrow-01 item-03 from-place) 4) (= (cost-of-carry-to-101b-solid-low-narrow-01 item-03 from-object) 4) (= (cost-of-carry-to-110-solid-low-narrow-01 item-03 from-place) 4) (= (cost-of-carry-to-110-solid-low-narrow-01 item-03 from-object) 4) (= (cost-of-carry-to-111-solid-low-narrow-01 item-03 from-place) 4) (= (cost-of-carry-to-111-solid-low-narrow-01 item-03 from-object) 4)
    (= (cost-of-carry-to-010-solid-low-10 item-04 from-place) 281) (= (cost-of-carry-to-010-solid-low-10 item-04 from-object) 281) (= (cost-of-carry-to-011c-solid-low-10 item-04 from-place) 281) (= (cost-of-carry-to-011c-solid-low-10 item-04 from-object) 281) (= (cost-of-carry-to-100-solid-low-10 item-04 from-place) 281) (= (cost-of-carry-to-100-solid-low-10 item-04 from-object) 281) (= (cost-of-carry-to-101-solid-low-10 item-04 from-place) 190) (= (cost-of-carry-to-101-solid-low-10 item-04 from-object) 190) (= (cost-of-carry-to-110-solid-low-10 item-04 from-place) 281) (= (cost-of-carry-to-110-solid-low-10 item-04 from-object) 281) (= (cost-of-carry-to-111b-solid-low-10 item-04 from-place) 281) (= (cost-of-carry-to-111b-solid-low-10 item-04 from-object) 281)
    (can-carry-to-001a-hollow-wide-00 item-05) (= (cost-of-carry-to-001a-hollow-wide-00 item-05 from-place) 4) (= (cost-of-carry-to-001a-hollow-wide-00 item-05 from-object) 4) (= (cost-of-carry-to-010a-hollow-wide-00 item-05 from-place) 26) (= (cost-of-carry-to-010a-hollow-wide-00 item-05 from-object) 26) (= (cost-of-carry-to-011a-hollow-wide-00 item-05 from-place) 4) (= (cost-of-carry-to-011a-hollow-wide-00 item-05 from-object) 4) (= (cost-of-carry-to-100a-hollow-wide-00 item-05 from-place) 4) (= (cost-of-carry-to-100a-hollow-wide-00 item-05 from-object) 4) (= (cost-of-carry-to-101a-hollow-wide-00 item-05 from-place) 11) (= (cost-of-carry-to-101a-hollow-wide-00 item-05 from-object) 11) (= (cost-of-carry-to-110a-hollow-wide-00 item-05 from-place) 4) (= (cost-of-carry-to-110a-hollow-wide-00 item-05 from-object) 4) (= (cost-of-carry-to-111a-hollow-wide-00 item-05 from-place) 238) (= (cost-of-carry-to-111a-hollow-wide-00 item-05 from-object) 238)
    (can-carry-to-011d-any-tall-narrow-11 item-06) (= (cost-of-carry-to-001a-any-tall-narrow-11 item-06 from-place) 7) (= (cost-of-carry-to-001a-any-tall-narrow-11 item-06 from-object) 7) (= (cost-of-carry-to-010b-any-tall-narrow-11 item-06 from-place) 7) (= (cost-of-carry-to-010b-any-tall-narrow-11 item-06 from-object) 7) (= (cost-of-carry-to-011d-any-tall-narrow-11 item-06 from-place) 4) (= (cost-of-carry-to-011d-any-tall-narrow-11 item-06 from-object) 4) (= (cost-of-carry-to-100-any-tall-narrow-11 item-06 from-place) 4) (= (cost-of-carry-to-100-any-tall-narrow-11 item-06 from-object) 4) (= (cost-of-carry-to-101-any-tall-narrow-11 item-06 from-place) 18) (= (cost-of-carry-to-101-any-tall-narrow-11 item-06 from-object) 18) (= (cost-of-carry-to-110b-any-tall-narrow-11 item-06 from-place) 7) (= (cost-of-carry-to-110b-any-tall-narrow-11 item-06 from-object) 7) (= (cost-of-carry-to-111c-any-tall-narrow-11 item-06 from-place) 4) (= (cost-of-carry-to-111c-any-tall-narrow-11 item-06 from-object) 4)
    (can-carry-to-011d-any-tall-narrow-11 item-07) (= (cost-of-carry-to-001a-any-tall-narrow-11 item-07 from-place) 7) (= (cost-of-carry-to-001a-any-tall-narrow-11 item-07 from-object) 7) (= (cost-of-carry-to-010b-any-tall-narrow-11 item-07 from-place) 7) (= (cost-of-carry-to-010b-any-tall-narrow-11 item-07 from-object) 7) (= (cost-of-carry-to-011d-any-tall-narrow-11 item-07 from-place) 4) (= (cost-of-carry-to-011d-any-tall-narrow-11 item-07 from-object) 4) (= (cost-of-carry-to-100-any-tall-narrow-11 item-07 from-place) 4) (= (cost-of-carry-to-100-any-tall-narrow-11 item-07 from-object) 4) (= (cost-of-carry-to-101-any-tall-narrow-11 item-07 from-place) 7) (= (cost-of-carry-to-101-any-tall-narrow-11 item-07 from-object) 7) (= (cost-of-carry-to-110b-any-tall-narrow-11 item-07 from-place) 7) (= (cost-of-carry-to-110b-any-tall-narrow-11 item-07 from-object) 7) (= (cost-of-carry-to-111c-any-tall-narrow-11 item-07 from-place) 4) (= (cost-of-carry-to-111c-any-tall-narrow-11 item-07 from-object) 4)
    (can-carry-to-100-solid-low-narrow-01 item-08) (= (cost-of-carry-to-001b-solid-low-narrow-01 item-08 from-place) 7) (= (cost-of-carry-to-001b-solid-low-narrow-01 item-08 from-object) 7) (= (cost-of-carry-to-010-solid-low-narrow-01 item-08 from-place) 7) (= (cost-of-carry-to-010-solid-low-narrow-01 item-08 from-object) 7) (= (cost-of-carry-to-011b-solid-low-narrow-01 item-08 from-place) 4) (= (cost-of-carry-to-011b-solid-low-narrow-01 item-08 from-object) 4) (= (cost-of-carry-to-100-solid-low-narrow-01 item-08 from-place) 4) (= (cost-of-carry-to-100-solid-low-narrow-01 item-08 from-object) 4) (= (cost-of-carry-to-101b-solid-low-narrow-01 item-08 from-place) 4) (= (cost-of-carry-to-101b-solid-low-narrow-01 item-08 from-object) 4) (= (cost-of-carry-to-110-solid-low-narrow-01 item-08 from-place) 4) (= (cost-of-carry-to-110-solid-low-narrow-01 item-08 from-object) 4) (= (cost-of-carry-to-111-solid-low-narrow-01 item-08 from-place) 4) (= (cost-of-carry-to-111-solid-low-narrow-01 item-08 from-object) 4))
  (:goal (and (done item-01) (done item-02) (done item-03) (done item-04) (done item-05) (done item-06) (done item-07) (done item-08)))
  (:metric minimize (total-cost)))
