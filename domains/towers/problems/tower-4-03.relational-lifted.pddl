; Problem tower-4-03 of the learned domain tabletop, for its encoding relational-lifted.
; How it came about: tower, drawn with seed 4; draw 1.
; States in which one object bears another: rests-on-000, leans-on-010, sits-in-100, sits-in-101.
; Objects stand at start-... at first, and none goes back there; park-... are places to wait at.
(define (problem tower-4-03)
  (:domain tabletop)
  (:objects
    item-01 - solid-low-narrow-01
    item-02 - solid-low-10
    item-03 - solid-low-narrow-01
    item-04 - hollow-wide-00
    start-item-01 start-item-02 start-item-03 start-item-04 park-01 park-02 park-03 park-04 - place)
  (:init
    (hand-empty) (= (total-cost) 0)
    (stands item-01 start-item-01)
    (stands item-02 start-item-02)
    (stands item-03 start-item-03)
    (stands item-04 start-item-04)
    ; park-01 lies at (0.4926, -0.0401) m
    (free park-01)
    (may-stand item-01 park-01)
    (may-stand item-02 park-01)
    (may-stand item-03 park-01)
    (may-stand item-04 park-01)
    ; park-02 lies at (0.8618, 0.2221) m
    (free park-02)
    (may-stand item-01 park-02)
    (may-stand item-02 park-02)
    (may-stand item-03 park-02)
    (may-stand item-04 park-02)
    ; park-03 lies at (0.8553, 0.0330) m
    (free park-03)
    (may-stand item-01 park-03)
    (may-stand item-02 park-03)
    (may-stand item-03 park-03)
    (may-stand item-04 park-03)
    ; park-04 lies at (0.6728, 0.2217) m
    (free park-04)
    (may-stand item-01 park-04) (overlaps item-01 park-04 start-item-02)
    (may-stand item-02 park-04)
    (may-stand item-03 park-04) (overlaps item-03 park-04 start-item-02)
    (may-stand item-04 park-04) (overlaps item-04 park-04 start-item-02) (overlaps item-04 park-04 start-item-03)
    (can-be-taken item-01)
    (can-be-taken item-02)
    (can-be-taken item-03)
    (can-be-taken item-04)
    (any-low-to-any-low-wide-01001 item-01 item-02) (any-low-narrow-to-any-tall-narrow-10110 item-01 item-03) (solid-low-narrow-to-hollow-low-wide-01000 item-01 item-04)
    (solid-low-to-any-10010 item-02 item-01) (solid-low-to-any-10010 item-02 item-03) (solid-low-to-any-10010 item-02 item-04)
    (any-narrow-to-solid-low-narrow-11110 item-03 item-01) (any-low-to-any-low-wide-01001 item-03 item-02) (any-low-to-any-low-wide-01001 item-03 item-04)
    (hollow-low-wide-to-any-narrow-11010 item-04 item-01) (hollow-low-wide-to-any-low-narrow-11000 item-04 item-02) (hollow-low-wide-to-any-narrow-11010 item-04 item-03)
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
    (can-carry-to-100-solid-low-narrow-01 item-01) (= (cost-of-carry-to-001b-solid-low-narrow-01 item-01 from-place) 7) (= (cost-of-carry-to-001b-solid-low-narrow-01 item-01 from-object) 7) (= (cost-of-carry-to-010-solid-low-narrow-01 item-01 from-place) 7) (= (cost-of-carry-to-010-solid-low-narrow-01 item-01 from-object) 7) (= (cost-of-carry-to-011b-solid-low-narrow-01 item-01 from-place) 4) (= (cost-of-carry-to-011b-solid-low-narrow-01 item-01 from-object) 4) (= (cost-of-carry-to-100-solid-low-narrow-01 item-01 from-place) 4) (= (cost-of-carry-to-100-solid-low-narrow-01 item-01 from-object) 4) (= (cost-of-carry-to-101b-solid-low-narrow-01 item-01 from-place) 4) (= (cost-of-carry-to-101b-solid-low-narrow-01 item-01 from-object) 4) (= (cost-of-carry-to-110-solid-low-narrow-01 item-01 from-place) 4) (= (cost-of-carry-to-110-solid-low-narrow-01 item-01 from-object) 4) (= (cost-of-carry-to-111-solid-low-narrow-01 item-01 from-place) 4) (= (cost-of-carry-to-111-solid-low-narrow-01 item-01 from-object) 4)
    (can-carry-to-111b-solid-low-10 item-02) (= (cost-of-carry-to-010-solid-low-10 item-02 from-place) 281) (= (cost-of-carry-to-010-solid-low-10 item-02 from-object) 281) (= (cost-of-carry-to-011c-solid-low-10 item-02 from-place) 120) (= (cost-of-carry-to-011c-solid-low-10 item-02 from-object) 120) (= (cost-of-carry-to-100-solid-low-10 item-02 from-place) 156) (= (cost-of-carry-to-100-solid-low-10 item-02 from-object) 156) (= (cost-of-carry-to-101-solid-low-10 item-02 from-place) 190) (= (cost-of-carry-to-101-solid-low-10 item-02 from-object) 190) (= (cost-of-carry-to-110-solid-low-10 item-02 from-place) 281) (= (cost-of-carry-to-110-solid-low-10 item-02 from-object) 281) (= (cost-of-carry-to-111b-solid-low-10 item-02 from-place) 11) (= (cost-of-carry-to-111b-solid-low-10 item-02 from-object) 11)
    (can-carry-to-100-solid-low-narrow-01 item-03) (= (cost-of-carry-to-001b-solid-low-narrow-01 item-03 from-place) 7) (= (cost-of-carry-to-001b-solid-low-narrow-01 item-03 from-object) 7) (= (cost-of-carry-to-010-solid-low-narrow-01 item-03 from-place) 7) (= (cost-of-carry-to-010-solid-low-narrow-01 item-03 from-object) 7) (= (cost-of-carry-to-011b-solid-low-narrow-01 item-03 from-place) 4) (= (cost-of-carry-to-011b-solid-low-narrow-01 item-03 from-object) 4) (= (cost-of-carry-to-100-solid-low-narrow-01 item-03 from-place) 4) (= (cost-of-carry-to-100-solid-low-narrow-01 item-03 from-object) 4) (= (cost-of-carry-to-101b-solid-low-narrow-01 item-03 from-place) 4) (= (cost-of-carry-to-101b-solid-low-narrow-01 item-03 from-object) 4) (= (cost-of-carry-to-110-solid-low-narrow-01 item-03 from-place) 4) (= (cost-of-carry-to-110-solid-low-narrow-01 item-03 from-object) 4) (= (cost-of-carry-to-111-solid-low-narrow-01 item-03 from-place) 4) (= (cost-of-carry-to-111-solid-low-narrow-01 item-03 from-object) 4)
    (can-carry-to-001a-hollow-wide-00 item-04) (= (cost-of-carry-to-001a-hollow-wide-00 item-04 from-place) 4) (= (cost-of-carry-to-001a-hollow-wide-00 item-04 from-object) 4) (= (cost-of-carry-to-010a-hollow-wide-00 item-04 from-place) 26) (= (cost-of-carry-to-010a-hollow-wide-00 item-04 from-object) 26) (= (cost-of-carry-to-011a-hollow-wide-00 item-04 from-place) 4) (= (cost-of-carry-to-011a-hollow-wide-00 item-04 from-object) 4) (= (cost-of-carry-to-100a-hollow-wide-00 item-04 from-place) 4) (= (cost-of-carry-to-100a-hollow-wide-00 item-04 from-object) 4) (= (cost-of-carry-to-101a-hollow-wide-00 item-04 from-place) 11) (= (cost-of-carry-to-101a-hollow-wide-00 item-04 from-object) 11) (= (cost-of-carry-to-110a-hollow-wide-00 item-04 from-place) 11) (= (cost-of-carry-to-110a-hollow-wide-00 item-04 from-object) 11) (= (cost-of-carry-to-111a-hollow-wide-00 item-04 from-place) 278) (= (cost-of-carry-to-111a-hollow-wide-00 item-04 from-object) 278))
  (:goal (and (rests-on-000 item-01 item-03) (rests-on-000 item-03 item-02)))
  (:metric minimize (total-cost)))
