; Problem tower-6-07 of the learned domain towers.
; How it came about: tower, drawn with seed 8; draw 1.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem tower-6-07)
  (:domain towers)
  (:objects
    item-01 - solid-low-narrow-01
    item-02 - solid-low-10
    item-03 - hollow-wide-00
    item-04 item-05 - solid-low-narrow-01
    item-06 - hollow-wide-00
    start-item-01 start-item-02 start-item-03 start-item-04 start-item-05 start-item-06 park-01 park-02 park-03 park-04 park-05 park-06 - spot
    rests-on-item-01 sits-in-item-01 rests-on-item-02 rests-on-item-03 rests-on-item-04 sits-in-item-04 rests-on-item-05 sits-in-item-05 rests-on-item-06 sits-in-item-06 - perch
    n1 n2 - count
    way1 way2 way3 way4 way5 way6 way7 way8 way9 way10 way11 way12 way13 way14 way15 way16 way17 way18 way19 - way
    cost4 cost12 cost13 cost14 cost22 cost27 cost34 cost35 cost36 cost37 cost49 cost50 cost52 cost64 cost70 cost71 cost75 cost86 cost121 cost141 - price)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 start-item-01) (bears item-01 n0) (can-take item-01)
    (stands item-02 start-item-02) (bears item-02 n0) (can-take item-02)
    (stands item-03 start-item-03) (bears item-03 n0) (can-take item-03)
    (stands item-04 start-item-04) (bears item-04 n0) (can-take item-04)
    (stands item-05 start-item-05) (bears item-05 n0) (can-take item-05)
    (stands item-06 start-item-06) (bears item-06 n0) (can-take item-06)
    ; park-01 lies at (0.6941, -0.1818) m
    (free park-01)
    (check item-01 park-01 nowhere)
    (check item-03 park-01 nowhere)
    (check item-04 park-01 nowhere)
    (check item-05 park-01 nowhere)
    (check item-06 park-01 nowhere)
    ; park-02 lies at (0.5200, 0.1898) m
    (free park-02)
    (check item-01 park-02 nowhere)
    (check item-03 park-02 start-item-06) (then item-03 park-02 start-item-06 nowhere)
    (check item-04 park-02 nowhere)
    (check item-05 park-02 nowhere)
    (check item-06 park-02 nowhere)
    ; park-03 lies at (0.6635, 0.1465) m
    (free park-03)
    (check item-03 park-03 start-item-02) (then item-03 park-03 start-item-02 nowhere)
    ; park-04 lies at (0.4223, -0.2485) m
    (free park-04)
    (check item-03 park-04 start-item-01) (then item-03 park-04 start-item-01 nowhere)
    (check item-05 park-04 nowhere)
    ; park-05 lies at (0.8967, 0.2472) m
    (free park-05)
    (check item-01 park-05 start-item-04) (then item-01 park-05 start-item-04 nowhere)
    (check item-03 park-05 nowhere)
    (check item-04 park-05 nowhere)
    (check item-05 park-05 start-item-04) (then item-05 park-05 start-item-04 nowhere)
    (check item-06 park-05 start-item-04) (then item-06 park-05 start-item-04 nowhere)
    ; park-06 lies at (0.5164, -0.2303) m
    (free park-06)
    ; what can be carried, from where, and its price
    (can-carry item-01 from-spot cost4) (can-carry item-01 from-perch cost4)
    (can-carry item-03 from-spot cost4) (can-carry item-03 from-perch cost4)
    (can-carry item-04 from-spot cost4) (can-carry item-04 from-perch cost4)
    (can-carry item-05 from-spot cost14) (can-carry item-05 from-perch cost14)
    (can-carry item-06 from-spot cost4) (can-carry item-06 from-perch cost4)
    ; counting
    (next n0 n1)
    (next n1 n2)
    ; on or in what
    (on rests-on-item-01 item-01)
    (on sits-in-item-01 item-01)
    (on rests-on-item-02 item-02)
    (on rests-on-item-03 item-03)
    (on rests-on-item-04 item-04)
    (on sits-in-item-04 item-04)
    (on rests-on-item-05 item-05)
    (on sits-in-item-05 item-05)
    (on rests-on-item-06 item-06)
    (on sits-in-item-06 item-06)
    ; what puts one thing on or into another
    (can-put item-01 rests-on-item-02 way10) (can-put item-01 rests-on-item-03 way10) (can-put item-01 rests-on-item-04 way6) (can-put item-01 rests-on-item-05 way3) (can-put item-01 sits-in-item-06 way5)
    (can-put item-02 rests-on-item-03 way9) (can-put item-02 rests-on-item-04 way13) (can-put item-02 rests-on-item-05 way13) (can-put item-02 rests-on-item-06 way13) (can-put item-02 sits-in-item-06 way16)
    (can-put item-03 rests-on-item-01 way1) (can-put item-03 rests-on-item-02 way1) (can-put item-03 rests-on-item-04 way1) (can-put item-03 rests-on-item-05 way1) (can-put item-03 rests-on-item-06 way1)
    (can-put item-04 rests-on-item-01 way1) (can-put item-04 rests-on-item-02 way11) (can-put item-04 rests-on-item-03 way10) (can-put item-04 rests-on-item-05 way10) (can-put-loaded item-04 rests-on-item-05 way12) (can-put item-04 sits-in-item-06 way7)
    (can-put item-05 rests-on-item-01 way8) (can-put item-05 rests-on-item-02 way4) (can-put item-05 rests-on-item-03 way4) (can-put item-05 rests-on-item-04 way8) (can-put item-05 sits-in-item-06 way16) (can-put-loaded item-05 sits-in-item-06 way16)
    (can-put item-06 rests-on-item-01 way18) (can-put item-06 sits-in-item-01 way14) (can-put item-06 rests-on-item-02 way2) (can-put item-06 rests-on-item-03 way15) (can-put item-06 rests-on-item-04 way17) (can-put item-06 sits-in-item-04 way14) (can-put item-06 rests-on-item-05 way2) (can-put item-06 sits-in-item-05 way19)
    ; what that costs, by where the one is from, and what the other bears
    (fee way1 from-perch n0 cost12) (fee way1 from-spot n0 cost12)
    (fee way2 from-perch n0 cost13) (fee way2 from-spot n0 cost12)
    (fee way3 from-perch n0 cost22) (fee way3 from-spot n0 cost12)
    (fee way4 from-perch n0 cost27) (fee way4 from-spot n0 cost12)
    (fee way5 from-perch n0 cost34) (fee way5 from-perch n1 cost86) (fee way5 from-spot n0 cost12) (fee way5 from-spot n1 cost64)
    (fee way6 from-perch n0 cost35) (fee way6 from-spot n0 cost12)
    (fee way7 from-perch n0 cost36) (fee way7 from-perch n1 cost75) (fee way7 from-spot n0 cost12) (fee way7 from-spot n1 cost50)
    (fee way8 from-perch n0 cost36) (fee way8 from-spot n0 cost12)
    (fee way9 from-perch n0 cost37) (fee way9 from-spot n0 cost37)
    (fee way10 from-perch n0 cost49) (fee way10 from-spot n0 cost12)
    (fee way11 from-perch n0 cost52) (fee way11 from-spot n0 cost12)
    (fee way12 from-perch n0 cost71) (fee way12 from-spot n0 cost34)
    (fee way13 from-perch n0 cost121) (fee way13 from-spot n0 cost121)
    (fee way14 from-perch n0 cost141) (fee way14 from-perch n1 cost141) (fee way14 from-spot n0 cost121) (fee way14 from-spot n1 cost121)
    (fee way15 from-spot n0 cost12)
    (fee way16 from-spot n0 cost12) (fee way16 from-spot n1 cost12)
    (fee way17 from-spot n0 cost37)
    (fee way18 from-spot n0 cost70)
    (fee way19 from-spot n0 cost121) (fee way19 from-spot n1 cost121)
    (= (total-cost) 0) (= (cost cost4) 4) (= (cost cost12) 12) (= (cost cost13) 13) (= (cost cost14) 14) (= (cost cost22) 22) (= (cost cost27) 27) (= (cost cost34) 34) (= (cost cost35) 35) (= (cost cost36) 36) (= (cost cost37) 37) (= (cost cost49) 49) (= (cost cost50) 50) (= (cost cost52) 52) (= (cost cost64) 64) (= (cost cost70) 70) (= (cost cost71) 71) (= (cost cost75) 75) (= (cost cost86) 86) (= (cost cost121) 121) (= (cost cost141) 141)
  )
  (:goal (and (stands item-06 rests-on-item-01) (stands item-01 rests-on-item-05) (stands item-05 rests-on-item-02)))
  (:metric minimize (total-cost)))
