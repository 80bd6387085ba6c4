; Problem tower-8-09 of the learned domain towers.
; How it came about: tower, drawn with seed 10; draw 1.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem tower-8-09)
  (:domain towers)
  (:objects
    item-01 - solid-low-narrow-01
    item-02 - hollow-wide-00
    item-03 - any-tall-narrow-11
    item-04 - hollow-wide-00
    item-05 - solid-low-10
    item-06 - hollow-wide-00
    item-07 - solid-low-narrow-01
    item-08 - solid-low-10
    start-item-01 start-item-02 start-item-03 start-item-04 start-item-05 start-item-06 start-item-07 start-item-08 park-01 park-02 park-03 park-04 park-05 park-06 park-07 park-08 - spot
    rests-on-item-01 sits-in-item-01 rests-on-item-02 sits-in-item-02 rests-on-item-03 sits-in-item-03 rests-on-item-04 sits-in-item-04 rests-on-item-05 rests-on-item-06 sits-in-item-06 rests-on-item-07 rests-on-item-08 - perch
    n1 n2 - count
    way1 way2 way3 way4 way5 way6 way7 way8 way9 way10 way11 way12 way13 way14 way15 way16 way17 way18 way19 way20 way21 way22 way23 way24 way25 way26 way27 way28 way29 way30 way31 - way
    cost4 cost11 cost12 cost13 cost22 cost23 cost28 cost30 cost31 cost34 cost35 cost37 cost49 cost51 cost53 cost70 cost71 cost74 cost76 cost81 cost109 cost121 cost123 cost131 cost133 cost160 - price)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 start-item-01) (bears item-01 n0) (can-take item-01)
    (stands item-02 start-item-02) (bears item-02 n0) (can-take item-02)
    (stands item-03 start-item-03) (bears item-03 n0) (can-take item-03)
    (stands item-04 start-item-04) (bears item-04 n0) (can-take item-04)
    (stands item-05 start-item-05) (bears item-05 n0) (can-take item-05)
    (stands item-06 start-item-06) (bears item-06 n0) (can-take item-06)
    (stands item-07 start-item-07) (bears item-07 n0) (can-take item-07)
    (stands item-08 start-item-08) (bears item-08 n0) (can-take item-08)
    ; park-01 lies at (0.7710, 0.1723) m
    (free park-01)
    (check item-01 park-01 nowhere)
    (check item-02 park-01 nowhere)
    (check item-03 park-01 nowhere)
    (check item-04 park-01 nowhere)
    (check item-05 park-01 nowhere)
    (check item-06 park-01 nowhere)
    (check item-07 park-01 nowhere)
    ; park-02 lies at (0.5640, -0.0334) m
    (free park-02)
    (check item-01 park-02 nowhere)
    (check item-02 park-02 nowhere)
    (check item-03 park-02 nowhere)
    (check item-04 park-02 nowhere)
    (check item-05 park-02 nowhere)
    (check item-06 park-02 nowhere)
    (check item-07 park-02 nowhere)
    ; park-03 lies at (0.4424, 0.2015) m
    (free park-03)
    (check item-01 park-03 nowhere)
    (check item-02 park-03 nowhere)
    (check item-03 park-03 nowhere)
    (check item-04 park-03 nowhere)
    (check item-05 park-03 nowhere)
    (check item-06 park-03 nowhere)
    (check item-07 park-03 start-item-06) (then item-07 park-03 start-item-06 nowhere)
    ; park-04 lies at (0.6200, 0.2393) m
    (free park-04)
    (check item-01 park-04 nowhere)
    (check item-02 park-04 start-item-06) (then item-02 park-04 start-item-06 nowhere)
    (check item-03 park-04 start-item-06) (then item-03 park-04 start-item-06 nowhere)
    (check item-04 park-04 start-item-06) (then item-04 park-04 start-item-06 nowhere)
    (check item-05 park-04 start-item-06) (then item-05 park-04 start-item-06 nowhere)
    ; park-05 lies at (0.4031, -0.0710) m
    (free park-05)
    (check item-01 park-05 nowhere)
    (check item-02 park-05 nowhere)
    (check item-03 park-05 nowhere)
    (check item-04 park-05 start-item-02) (then item-04 park-05 start-item-02 nowhere)
    (check item-05 park-05 start-item-02) (then item-05 park-05 start-item-02 nowhere)
    (check item-06 park-05 start-item-02) (then item-06 park-05 start-item-02 start-item-05) (then item-06 park-05 start-item-05 nowhere)
    (check item-07 park-05 nowhere)
    ; park-06 lies at (0.7889, -0.1006) m
    (free park-06)
    (check item-01 park-06 nowhere)
    (check item-03 park-06 nowhere)
    (check item-07 park-06 nowhere)
    ; park-07 lies at (0.8928, 0.0376) m
    (free park-07)
    (check item-01 park-07 start-item-04) (then item-01 park-07 start-item-04 nowhere)
    (check item-03 park-07 nowhere)
    (check item-05 park-07 nowhere)
    (check item-07 park-07 start-item-04) (then item-07 park-07 start-item-04 nowhere)
    ; park-08 lies at (0.7369, -0.1605) m
    (free park-08)
    (check item-07 park-08 start-item-01) (then item-07 park-08 start-item-01 start-item-08) (then item-07 park-08 start-item-08 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 from-spot cost4) (can-carry item-01 from-perch cost4)
    (can-carry item-02 from-spot cost4) (can-carry item-02 from-perch cost4)
    (can-carry item-03 from-spot cost4) (can-carry item-03 from-perch cost4)
    (can-carry item-04 from-spot cost4) (can-carry item-04 from-perch cost4)
    (can-carry item-05 from-spot cost11) (can-carry item-05 from-perch cost11)
    (can-carry item-06 from-spot cost4) (can-carry item-06 from-perch cost4)
    (can-carry item-07 from-spot cost4) (can-carry item-07 from-perch cost4)
    ; counting
    (next n0 n1)
    (next n1 n2)
    ; on or in what
    (on rests-on-item-01 item-01)
    (on sits-in-item-01 item-01)
    (on rests-on-item-02 item-02)
    (on sits-in-item-02 item-02)
    (on rests-on-item-03 item-03)
    (on sits-in-item-03 item-03)
    (on rests-on-item-04 item-04)
    (on sits-in-item-04 item-04)
    (on rests-on-item-05 item-05)
    (on rests-on-item-06 item-06)
    (on sits-in-item-06 item-06)
    (on rests-on-item-07 item-07)
    (on rests-on-item-08 item-08)
    ; what puts one thing on or into another
    (can-put item-01 rests-on-item-02 way4) (can-put item-01 rests-on-item-03 way15) (can-put item-01 rests-on-item-04 way4) (can-put item-01 rests-on-item-05 way13) (can-put item-01 rests-on-item-06 way20) (can-put item-01 sits-in-item-06 way24) (can-put item-01 rests-on-item-07 way2) (can-put item-01 rests-on-item-08 way2)
    (can-put item-02 rests-on-item-01 way26) (can-put item-02 sits-in-item-03 way31) (can-put item-02 rests-on-item-04 way11) (can-put item-02 rests-on-item-05 way1) (can-put item-02 rests-on-item-06 way21) (can-put item-02 sits-in-item-06 way5) (can-put item-02 rests-on-item-07 way26) (can-put item-02 rests-on-item-08 way3)
    (can-put item-03 rests-on-item-01 way13) (can-put-loaded item-03 rests-on-item-01 way18) (can-put item-03 sits-in-item-02 way27) (can-put item-03 sits-in-item-04 way29) (can-put item-03 rests-on-item-05 way9) (can-put item-03 sits-in-item-06 way27) (can-put item-03 rests-on-item-07 way10) (can-put item-03 rests-on-item-08 way7)
    (can-put item-04 rests-on-item-01 way26) (can-put item-04 rests-on-item-02 way2) (can-put item-04 rests-on-item-03 way23) (can-put item-04 rests-on-item-05 way1) (can-put item-04 rests-on-item-06 way16) (can-put item-04 sits-in-item-06 way5) (can-put item-04 rests-on-item-07 way26) (can-put item-04 rests-on-item-08 way3)
    (can-put item-05 rests-on-item-01 way6) (can-put item-05 rests-on-item-02 way12) (can-put item-05 rests-on-item-03 way14) (can-put item-05 rests-on-item-04 way17) (can-put item-05 rests-on-item-06 way22) (can-put item-05 sits-in-item-06 way29) (can-put item-05 rests-on-item-07 way6) (can-put item-05 rests-on-item-08 way14)
    (can-put item-06 rests-on-item-01 way28) (can-put item-06 sits-in-item-01 way31) (can-put item-06 rests-on-item-02 way28) (can-put item-06 sits-in-item-02 way30) (can-put item-06 rests-on-item-03 way23) (can-put item-06 sits-in-item-03 way31) (can-put item-06 rests-on-item-04 way28) (can-put item-06 sits-in-item-04 way30) (can-put item-06 rests-on-item-05 way28) (can-put item-06 rests-on-item-07 way19) (can-put item-06 rests-on-item-08 way26)
    (can-put item-07 rests-on-item-01 way15) (can-put item-07 rests-on-item-02 way4) (can-put item-07 rests-on-item-03 way8) (can-put item-07 rests-on-item-04 way4) (can-put item-07 rests-on-item-05 way13) (can-put item-07 rests-on-item-06 way4) (can-put item-07 rests-on-item-08 way8)
    (can-put item-08 rests-on-item-01 way17) (can-put item-08 rests-on-item-02 way2) (can-put item-08 rests-on-item-03 way14) (can-put item-08 rests-on-item-04 way14) (can-put item-08 rests-on-item-05 way14) (can-put item-08 rests-on-item-06 way2) (can-put item-08 rests-on-item-07 way25)
    ; what that costs, by where the one is from, and what the other bears
    (fee way1 from-perch n0 cost12) (fee way1 from-perch n1 cost51) (fee way1 from-spot n0 cost12) (fee way1 from-spot n1 cost51)
    (fee way2 from-perch n0 cost12) (fee way2 from-spot n0 cost12)
    (fee way3 from-perch n0 cost13) (fee way3 from-spot n0 cost12)
    (fee way4 from-perch n0 cost22) (fee way4 from-spot n0 cost12)
    (fee way5 from-perch n0 cost23) (fee way5 from-perch n1 cost23) (fee way5 from-spot n0 cost12) (fee way5 from-spot n1 cost12)
    (fee way6 from-perch n0 cost23) (fee way6 from-spot n0 cost12)
    (fee way7 from-perch n0 cost28) (fee way7 from-spot n0 cost12)
    (fee way8 from-perch n0 cost30) (fee way8 from-spot n0 cost12)
    (fee way9 from-perch n0 cost31) (fee way9 from-spot n0 cost12)
    (fee way10 from-perch n0 cost35) (fee way10 from-spot n0 cost12)
    (fee way11 from-perch n0 cost37) (fee way11 from-perch n1 cost76) (fee way11 from-spot n0 cost37) (fee way11 from-spot n1 cost76)
    (fee way12 from-perch n0 cost37) (fee way12 from-spot n0 cost37)
    (fee way13 from-perch n0 cost49) (fee way13 from-spot n0 cost12)
    (fee way14 from-perch n0 cost49) (fee way14 from-spot n0 cost37)
    (fee way15 from-perch n0 cost53) (fee way15 from-spot n0 cost12)
    (fee way16 from-perch n0 cost70) (fee way16 from-perch n1 cost109) (fee way16 from-spot n0 cost70) (fee way16 from-spot n1 cost109)
    (fee way17 from-perch n0 cost70) (fee way17 from-spot n0 cost70)
    (fee way18 from-perch n0 cost71) (fee way18 from-spot n0 cost34)
    (fee way19 from-perch n0 cost74) (fee way19 from-spot n0 cost70)
    (fee way20 from-perch n0 cost81) (fee way20 from-spot n0 cost70)
    (fee way21 from-perch n0 cost121) (fee way21 from-perch n1 cost160) (fee way21 from-spot n0 cost121) (fee way21 from-spot n1 cost160)
    (fee way22 from-perch n0 cost121) (fee way22 from-spot n0 cost121)
    (fee way23 from-perch n0 cost123) (fee way23 from-spot n0 cost121)
    (fee way24 from-perch n0 cost131) (fee way24 from-perch n1 cost131) (fee way24 from-spot n0 cost70) (fee way24 from-spot n1 cost70)
    (fee way25 from-perch n0 cost133) (fee way25 from-spot n0 cost121)
    (fee way26 from-spot n0 cost12)
    (fee way27 from-spot n0 cost12) (fee way27 from-spot n1 cost12)
    (fee way28 from-spot n0 cost37)
    (fee way29 from-spot n0 cost37) (fee way29 from-spot n1 cost37)
    (fee way30 from-spot n0 cost70) (fee way30 from-spot n1 cost70)
    (fee way31 from-spot n0 cost121) (fee way31 from-spot n1 cost121)
    (= (total-cost) 0) (= (cost cost4) 4) (= (cost cost11) 11) (= (cost cost12) 12) (= (cost cost13) 13) (= (cost cost22) 22) (= (cost cost23) 23) (= (cost cost28) 28) (= (cost cost30) 30) (= (cost cost31) 31) (= (cost cost34) 34) (= (cost cost35) 35) (= (cost cost37) 37) (= (cost cost49) 49) (= (cost cost51) 51) (= (cost cost53) 53) (= (cost cost70) 70) (= (cost cost71) 71) (= (cost cost74) 74) (= (cost cost76) 76) (= (cost cost81) 81) (= (cost cost109) 109) (= (cost cost121) 121) (= (cost cost123) 123) (= (cost cost131) 131) (= (cost cost133) 133) (= (cost cost160) 160)
  )
  (:goal (and (stands item-06 rests-on-item-05) (stands item-05 rests-on-item-07) (stands item-07 rests-on-item-03)))
  (:metric minimize (total-cost)))
