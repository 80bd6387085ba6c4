; Problem sorting of the learned domain toy-relations, for its encoding relational.
; How it came about: by hand.
; States in which one object bears another: rests-on-001, lies-in-010.
; Objects stand at start-... at first, and none goes back there; park-... are places to wait at.
(define (problem sorting)
  (:domain toy-relations-relational)
  (:objects
    item-01 - cube
    item-02 - cube
    item-03 - block
    item-04 - tray
    item-05 - tray
    start-item-03 start-item-04 start-item-05 park-01 park-02 park-03 park-04 park-05 - place
    usual - grade
    count-2 - count)
  (:init
    (hand-empty) (= (total-cost) 0)
    (rests-on-001 item-01 item-02) (bears item-01 none)
    (rests-on-001 item-02 item-03) (bears item-02 one)
    (stands item-03 start-item-03) (bears item-03 one)
    (stands item-04 start-item-04) (bears item-04 none)
    (stands item-05 start-item-05) (bears item-05 none)
    ; park-01 lies at (0.5256, -0.1837) m
    (free park-01)
    (room item-01 park-01 nowhere)
    (room item-02 park-01 nowhere)
    (room item-03 park-01 nowhere)
    (room item-04 park-01 nowhere)
    (room item-05 park-01 nowhere)
    ; park-02 lies at (0.5231, 0.1851) m
    (free park-02)
    (room item-01 park-02 nowhere)
    (room item-02 park-02 nowhere)
    (room item-03 park-02 nowhere)
    (room item-04 park-02 nowhere)
    (room item-05 park-02 nowhere)
    ; park-03 lies at (0.6039, -0.0371) m
    (free park-03)
    (room item-01 park-03 nowhere)
    (room item-02 park-03 nowhere)
    (room item-03 park-03 nowhere)
    ; park-04 lies at (0.8237, -0.0012) m
    (free park-04)
    (room item-01 park-04 nowhere)
    (room item-02 park-04 nowhere)
    (room item-03 park-04 nowhere)
    ; park-05 lies at (0.7309, -0.0074) m
    (free park-05)
    (room item-01 park-05 nowhere)
    (room item-02 park-05 nowhere)
    (room item-03 park-05 nowhere)
    (can-be-taken item-01)
    (can-be-taken item-02)
    (can-be-taken item-03)
    (can-be-taken item-04)
    (can-be-taken item-05)
    (solid-01 item-01 item-02) (solid-01 item-01 item-03) (hollow-11 item-01 item-04) (hollow-11 item-01 item-05)
    (solid-01 item-02 item-01) (solid-01 item-02 item-03) (hollow-11 item-02 item-04) (hollow-11 item-02 item-05)
    (solid-01 item-03 item-01) (solid-01 item-03 item-02) (hollow-11 item-03 item-04) (hollow-11 item-03 item-05)
    (next none one) (next one count-2)
    (can-put-on-01-solid-01 item-01 item-02 usual)
    (can-put-on-01-solid-01 item-01 item-03 usual)
    (can-put-in-01-hollow-11 item-01 item-04 usual)
    (can-put-in-01-hollow-11 item-01 item-05 usual)
    (can-put-on-01-solid-01 item-02 item-01 usual)
    (can-put-on-01-solid-01 item-02 item-03 usual)
    (can-put-in-01-hollow-11 item-02 item-04 usual)
    (can-put-in-01-hollow-11 item-02 item-05 usual)
    (can-put-on-01-solid-01 item-03 item-01 usual)
    (can-put-on-01-solid-01 item-03 item-02 usual)
    (can-put-in-01-hollow-11 item-03 item-04 usual)
    (can-put-in-01-hollow-11 item-03 item-05 usual)
    (= (cost-of-lies-in-010-by-01-any-pair usual none from-place) 6) (= (cost-of-lies-in-010-by-01-any-pair usual none from-object) 10) (= (cost-of-lies-in-010-by-01-any-pair usual one from-place) 30) (= (cost-of-lies-in-010-by-01-any-pair usual one from-object) 34) (= (cost-of-lies-in-010-by-01-any-pair usual count-2 from-place) 30) (= (cost-of-lies-in-010-by-01-any-pair usual count-2 from-object) 34)
    (= (cost-of-put-in-01-hollow-11 usual none from-place) 6) (= (cost-of-put-in-01-hollow-11 usual none from-object) 10) (= (cost-of-put-in-01-hollow-11 usual one from-place) 30) (= (cost-of-put-in-01-hollow-11 usual one from-object) 34) (= (cost-of-put-in-01-hollow-11 usual count-2 from-place) 30) (= (cost-of-put-in-01-hollow-11 usual count-2 from-object) 34)
    (= (cost-of-put-in-01-hollow-11-laden usual none from-place) 19) (= (cost-of-put-in-01-hollow-11-laden usual none from-object) 23) (= (cost-of-put-in-01-hollow-11-laden usual one from-place) 43) (= (cost-of-put-in-01-hollow-11-laden usual one from-object) 47) (= (cost-of-put-in-01-hollow-11-laden usual count-2 from-place) 43) (= (cost-of-put-in-01-hollow-11-laden usual count-2 from-object) 47)
    (= (cost-of-put-on-01-solid-01 usual from-place) 11) (= (cost-of-put-on-01-solid-01 usual from-object) 11)
    (= (cost-of-put-on-01-solid-01-laden usual from-place) 19) (= (cost-of-put-on-01-solid-01-laden usual from-object) 19)
    (= (cost-of-rests-on-001-by-01-any-pair usual from-place) 11) (= (cost-of-rests-on-001-by-01-any-pair usual from-object) 11)
    (can-carry-to-01-cube item-01) (= (cost-of-carry-to-01-cube item-01 from-place) 6) (= (cost-of-carry-to-01-cube item-01 from-object) 20)
    (can-carry-to-01-cube item-02) (= (cost-of-carry-to-01-cube item-02 from-place) 6) (= (cost-of-carry-to-01-cube item-02 from-object) 20)
    (can-carry-to-01-block item-03) (= (cost-of-carry-to-01-block item-03 from-place) 6) (= (cost-of-carry-to-01-block item-03 from-object) 20)
    (can-carry-to-01-tray item-04) (= (cost-of-carry-to-01-tray item-04 from-place) 6) (= (cost-of-carry-to-01-tray item-04 from-object) 20)
    (can-carry-to-01-tray item-05) (= (cost-of-carry-to-01-tray item-05 from-place) 6) (= (cost-of-carry-to-01-tray item-05 from-object) 20))
  (:goal (and (lies-in-010 item-01 item-04) (lies-in-010 item-02 item-05)))
  (:metric minimize (total-cost)))
