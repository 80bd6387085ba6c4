; Problem exchange-6-18 of the learned domain tabletop, for its encoding relational-lifted.
; How it came about: exchange, drawn with seed 19; draw 2.
; States in which one object bears another: rests-on-000, leans-on-010, sits-in-100, sits-in-101.
; Objects stand at start-... at first, and none goes back there; park-... are places to wait at.
(define (problem exchange-6-18)
  (:domain tabletop)
  (:objects
    item-01 - any-tall-narrow-11
    item-02 - solid-low-10
    item-03 - solid-low-10
    item-04 - solid-low-10
    item-05 - any-tall-narrow-11
    item-06 - solid-low-narrow-01
    start-item-02 start-item-03 start-item-04 start-item-06 park-01 park-02 park-03 park-04 park-05 park-06 - place)
  (:init
    (hand-empty) (= (total-cost) 0)
    (rests-on-000 item-01 item-04) (rests-with item-01 item-04)
    (stands item-02 start-item-02)
    (stands item-03 start-item-03)
    (stands item-04 start-item-04)
    (rests-on-000 item-05 item-06) (rests-with item-05 item-06)
    (stands item-06 start-item-06)
    ; park-01 lies at (0.4740, -0.1868) m
    (free park-01)
    (may-stand item-01 park-01)
    (may-stand item-03 park-01)
    (may-stand item-05 park-01)
    (may-stand item-06 park-01)
    ; park-02 lies at (0.7711, -0.1921) m
    (free park-02)
    (may-stand item-01 park-02)
    (may-stand item-03 park-02)
    (may-stand item-05 park-02)
    (may-stand item-06 park-02)
    ; park-03 lies at (0.5101, 0.0856) m
    (free park-03)
    (may-stand item-01 park-03)
    (may-stand item-03 park-03)
    (may-stand item-05 park-03)
    (may-stand item-06 park-03)
    ; park-04 lies at (0.8731, 0.2154) m
    (free park-04)
    (may-stand item-01 park-04)
    (may-stand item-03 park-04)
    (may-stand item-05 park-04)
    (may-stand item-06 park-04)
    ; park-05 lies at (0.5449, -0.0401) m
    (free park-05)
    (may-stand item-01 park-05)
    (may-stand item-03 park-05)
    (may-stand item-05 park-05)
    (may-stand item-06 park-05)
    ; park-06 lies at (0.5999, -0.1565) m
    (free park-06)
    (can-be-taken item-01)
    (can-be-taken item-02)
    (can-be-taken item-03)
    (can-be-taken item-04)
    (can-be-taken item-05)
    (can-be-taken item-06)
    (hollow-low-wide-to-any-low-narrow-11000 item-01 item-02) (hollow-low-wide-to-any-narrow-11010 item-01 item-03) (hollow-tall-wide-to-any-wide-01011 item-01 item-04) (hollow-low-wide-to-any-low-narrow-11000 item-01 item-05) (any-narrow-to-solid-low-narrow-11110 item-01 item-06)
    (hollow-low-wide-to-any-narrow-11010 item-02 item-01) (solid-low-to-any-10010 item-02 item-03) (solid-low-to-any-10010 item-02 item-04) (solid-low-to-any-10010 item-02 item-05) (solid-low-to-any-10010 item-02 item-06)
    (solid-tall-to-solid-10011 item-03 item-01) (solid-tall-to-solid-10011 item-03 item-02) (solid-tall-to-solid-10011 item-03 item-04) (solid-tall-to-solid-10011 item-03 item-05) (solid-low-to-any-10010 item-03 item-06)
    (solid-low-to-any-10010 item-04 item-01) (solid-low-to-any-10010 item-04 item-02) (solid-low-to-any-10010 item-04 item-03) (solid-low-to-any-10010 item-04 item-05) (solid-low-to-any-10010 item-04 item-06)
    (hollow-wide-to-hollow-low-wide-11001 item-05 item-01) (hollow-low-wide-to-any-low-narrow-11000 item-05 item-02) (any-tall-narrow-to-any-tall-narrow-10111 item-05 item-03) (any-tall-to-any-tall-wide-01111 item-05 item-04) (any-narrow-to-solid-low-narrow-11110 item-05 item-06)
    (any-tall-to-any-low-01101 item-06 item-01) (any-low-to-any-low-wide-01001 item-06 item-02) (any-tall-to-any-tall-wide-01111 item-06 item-03) (any-tall-to-any-tall-wide-01111 item-06 item-04) (any-tall-to-any-low-01101 item-06 item-05)
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
    (can-carry-to-011d-any-tall-narrow-11 item-01) (= (cost-of-carry-to-001a-any-tall-narrow-11 item-01 from-place) 7) (= (cost-of-carry-to-001a-any-tall-narrow-11 item-01 from-object) 7) (= (cost-of-carry-to-010b-any-tall-narrow-11 item-01 from-place) 7) (= (cost-of-carry-to-010b-any-tall-narrow-11 item-01 from-object) 7) (= (cost-of-carry-to-011d-any-tall-narrow-11 item-01 from-place) 4) (= (cost-of-carry-to-011d-any-tall-narrow-11 item-01 from-object) 4) (= (cost-of-carry-to-100-any-tall-narrow-11 item-01 from-place) 4) (= (cost-of-carry-to-100-any-tall-narrow-11 item-01 from-object) 4) (= (cost-of-carry-to-101-any-tall-narrow-11 item-01 from-place) 7) (= (cost-of-carry-to-101-any-tall-narrow-11 item-01 from-object) 7) (= (cost-of-carry-to-110b-any-tall-narrow-11 item-01 from-place) 7) (= (cost-of-carry-to-110b-any-tall-narrow-11 item-01 from-object) 7) (= (cost-of-carry-to-111c-any-tall-narrow-11 item-01 from-place) 4) (= (cost-of-carry-to-111c-any-tall-narrow-11 item-01 from-object) 4)
    (= (cost-of-carry-to-010-solid-low-10 item-02 from-place) 281) (= (cost-of-carry-to-010-solid-low-10 item-02 from-object) 281) (= (cost-of-carry-to-011c-solid-low-10 item-02 from-place) 212) (= (cost-of-carry-to-011c-solid-low-10 item-02 from-object) 212) (= (cost-of-carry-to-100-solid-low-10 item-02 from-place) 281) (= (cost-of-carry-to-100-solid-low-10 item-02 from-object) 281) (= (cost-of-carry-to-101-solid-low-10 item-02 from-place) 190) (= (cost-of-carry-to-101-solid-low-10 item-02 from-object) 190) (= (cost-of-carry-to-110-solid-low-10 item-02 from-place) 281) (= (cost-of-carry-to-110-solid-low-10 item-02 from-object) 281) (= (cost-of-carry-to-111b-solid-low-10 item-02 from-place) 241) (= (cost-of-carry-to-111b-solid-low-10 item-02 from-object) 241)
    (can-carry-to-100-solid-low-10 item-03) (= (cost-of-carry-to-010-solid-low-10 item-03 from-place) 281) (= (cost-of-carry-to-010-solid-low-10 item-03 from-object) 281) (= (cost-of-carry-to-011c-solid-low-10 item-03 from-place) 11) (= (cost-of-carry-to-011c-solid-low-10 item-03 from-object) 11) (= (cost-of-carry-to-100-solid-low-10 item-03 from-place) 11) (= (cost-of-carry-to-100-solid-low-10 item-03 from-object) 11) (= (cost-of-carry-to-101-solid-low-10 item-03 from-place) 190) (= (cost-of-carry-to-101-solid-low-10 item-03 from-object) 190) (= (cost-of-carry-to-110-solid-low-10 item-03 from-place) 281) (= (cost-of-carry-to-110-solid-low-10 item-03 from-object) 281) (= (cost-of-carry-to-111b-solid-low-10 item-03 from-place) 11) (= (cost-of-carry-to-111b-solid-low-10 item-03 from-object) 11)
    (= (cost-of-carry-to-010-solid-low-10 item-04 from-place) 281) (= (cost-of-carry-to-010-solid-low-10 item-04 from-object) 281) (= (cost-of-carry-to-011c-solid-low-10 item-04 from-place) 241) (= (cost-of-carry-to-011c-solid-low-10 item-04 from-object) 241) (= (cost-of-carry-to-100-solid-low-10 item-04 from-place) 281) (= (cost-of-carry-to-100-solid-low-10 item-04 from-object) 281) (= (cost-of-carry-to-101-solid-low-10 item-04 from-place) 190) (= (cost-of-carry-to-101-solid-low-10 item-04 from-object) 190) (= (cost-of-carry-to-110-solid-low-10 item-04 from-place) 281) (= (cost-of-carry-to-110-solid-low-10 item-04 from-object) 281) (= (cost-of-carry-to-111b-solid-low-10 item-04 from-place) 241) (= (cost-of-carry-to-111b-solid-low-10 item-04 from-object) 241)
    (can-carry-to-011d-any-tall-narrow-11 item-05) (= (cost-of-carry-to-001a-any-tall-narrow-11 item-05 from-place) 7) (= (cost-of-carry-to-001a-any-tall-narrow-11 item-05 from-object) 7) (= (cost-of-carry-to-010b-any-tall-narrow-11 item-05 from-place) 7) (= (cost-of-carry-to-010b-any-tall-narrow-11 item-05 from-object) 7) (= (cost-of-carry-to-011d-any-tall-narrow-11 item-05 from-place) 4) (= (cost-of-carry-to-011d-any-tall-narrow-11 item-05 from-object) 4) (= (cost-of-carry-to-100-any-tall-narrow-11 item-05 from-place) 4) (= (cost-of-carry-to-100-any-tall-narrow-11 item-05 from-object) 4) (= (cost-of-carry-to-101-any-tall-narrow-11 item-05 from-place) 7) (= (cost-of-carry-to-101-any-tall-narrow-11 item-05 from-object) 7) (= (cost-of-carry-to-110b-any-tall-narrow-11 item-05 from-place) 7) (= (cost-of-carry-to-110b-any-tall-narrow-11 item-05 from-object) 7) (= (cost-of-carry-to-111c-any-tall-narrow-11 item-05 from-place) 4) (= (cost-of-carry-to-111c-any-tall-narrow-11 item-05 from-object) 4)
    (can-carry-to-100-solid-low-narrow-01 item-06) (= (cost-of-carry-to-001b-solid-low-narrow-01 item-06 from-place) 7) (= (cost-of-carry-to-001b-solid-low-narrow-01 item-06 from-object) 7) (= (cost-of-carry-to-010-solid-low-narrow-01 item-06 from-place) 11) (= (cost-of-carry-to-010-solid-low-narrow-01 item-06 from-object) 11) (= (cost-of-carry-to-011b-solid-low-narrow-01 item-06 from-place) 4) (= (cost-of-carry-to-011b-solid-low-narrow-01 item-06 from-object) 4) (= (cost-of-carry-to-100-solid-low-narrow-01 item-06 from-place) 4) (= (cost-of-carry-to-100-solid-low-narrow-01 item-06 from-object) 4) (= (cost-of-carry-to-101b-solid-low-narrow-01 item-06 from-place) 4) (= (cost-of-carry-to-101b-solid-low-narrow-01 item-06 from-object) 4) (= (cost-of-carry-to-110-solid-low-narrow-01 item-06 from-place) 4) (= (cost-of-carry-to-110-solid-low-narrow-01 item-06 from-object) 4) (= (cost-of-carry-to-111-solid-low-narrow-01 item-06 from-place) 4) (= (cost-of-carry-to-111-solid-low-narrow-01 item-06 from-object) 4))
  (:goal (and (rests-on-000 item-05 item-04) (rests-on-000 item-01 item-06)))
  (:metric minimize (total-cost)))
