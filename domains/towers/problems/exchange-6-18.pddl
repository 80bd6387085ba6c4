; Problem exchange-6-18 of the learned domain towers.
; How it came about: exchange, drawn with seed 19; draw 2.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem exchange-6-18)
  (:domain towers)
  (:objects
    item-01 - any-tall-narrow-11
    item-02 item-03 item-04 - solid-low-10
    item-05 - any-tall-narrow-11
    item-06 - solid-low-narrow-01
    start-item-03 start-item-04 start-item-05 start-item-06 park-01 park-02 park-03 park-04 park-05 park-06 - spot
    rests-on-item-01 sits-in-item-01 rests-on-item-02 rests-on-item-03 rests-on-item-04 rests-on-item-05 rests-on-item-06 - perch
    n1 n2 - count
    way1 way2 way3 way4 way5 way6 way7 way8 way9 way10 way11 way12 way13 way14 way15 way16 way17 way18 - way
    cost4 cost11 cost12 cost37 cost42 cost54 cost56 cost59 cost64 cost70 cost79 cost81 cost85 cost121 cost146 cost149 cost157 cost160 cost161 cost167 cost184 cost234 - price)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 rests-on-item-03) (bears item-01 n0) (can-take item-01)
    (stands item-02 rests-on-item-05) (bears item-02 n0) (can-take item-02)
    (stands item-03 start-item-03) (bears item-03 n1) (can-take item-03)
    (stands item-04 start-item-04) (bears item-04 n0) (can-take item-04)
    (stands item-05 start-item-05) (bears item-05 n1) (can-take item-05)
    (stands item-06 start-item-06) (bears item-06 n0) (can-take item-06)
    ; park-01 lies at (0.4740, -0.1868) m
    (free park-01)
    (check item-01 park-01 nowhere)
    (check item-03 park-01 nowhere)
    (check item-05 park-01 nowhere)
    (check item-06 park-01 nowhere)
    ; park-02 lies at (0.4593, 0.0392) m
    (free park-02)
    (check item-01 park-02 nowhere)
    (check item-03 park-02 nowhere)
    (check item-05 park-02 nowhere)
    (check item-06 park-02 nowhere)
    ; park-03 lies at (0.6939, -0.1822) m
    (free park-03)
    (check item-01 park-03 nowhere)
    (check item-03 park-03 nowhere)
    (check item-05 park-03 nowhere)
    (check item-06 park-03 nowhere)
    ; park-04 lies at (0.8731, 0.2154) m
    (free park-04)
    (check item-01 park-04 nowhere)
    (check item-03 park-04 nowhere)
    (check item-05 park-04 nowhere)
    (check item-06 park-04 nowhere)
    ; park-05 lies at (0.8617, 0.0767) m
    (free park-05)
    (check item-01 park-05 nowhere)
    (check item-03 park-05 nowhere)
    (check item-05 park-05 nowhere)
    (check item-06 park-05 nowhere)
    ; park-06 lies at (0.6729, 0.2259) m
    (free park-06)
    (check item-01 park-06 start-item-04) (then item-01 park-06 start-item-04 nowhere)
    (check item-03 park-06 start-item-04) (then item-03 park-06 start-item-04 nowhere)
    (check item-05 park-06 start-item-04) (then item-05 park-06 start-item-04 nowhere)
    (check item-06 park-06 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 from-spot cost4) (can-carry item-01 from-perch cost4)
    (can-carry item-03 from-spot cost11) (can-carry item-03 from-perch cost11)
    (can-carry item-05 from-spot cost4) (can-carry item-05 from-perch cost4)
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
    (on rests-on-item-05 item-05)
    (on rests-on-item-06 item-06)
    ; what puts one thing on or into another
    (can-put item-01 rests-on-item-02 way1) (can-put item-01 rests-on-item-03 way6) (can-put item-01 rests-on-item-04 way6) (can-put item-01 rests-on-item-05 way10) (can-put item-01 rests-on-item-06 way6)
    (can-put item-02 rests-on-item-01 way13) (can-put-loaded item-02 rests-on-item-01 way16) (can-put item-02 rests-on-item-03 way12) (can-put item-02 rests-on-item-04 way17) (can-put item-02 rests-on-item-05 way12) (can-put-loaded item-02 rests-on-item-05 way16) (can-put item-02 rests-on-item-06 way11)
    (can-put item-03 rests-on-item-01 way5) (can-put item-03 rests-on-item-02 way9) (can-put item-03 rests-on-item-04 way5) (can-put item-03 rests-on-item-05 way5) (can-put item-03 rests-on-item-06 way2) (can-put-loaded item-03 rests-on-item-06 way1)
    (can-put item-04 rests-on-item-01 way13) (can-put item-04 rests-on-item-05 way14) (can-put item-04 rests-on-item-06 way18)
    (can-put item-05 rests-on-item-01 way3) (can-put item-05 sits-in-item-01 way15) (can-put item-05 rests-on-item-02 way1) (can-put item-05 rests-on-item-03 way7) (can-put item-05 rests-on-item-04 way6) (can-put item-05 rests-on-item-06 way6)
    (can-put item-06 rests-on-item-01 way8) (can-put item-06 rests-on-item-02 way4) (can-put item-06 rests-on-item-03 way8) (can-put item-06 rests-on-item-04 way8) (can-put item-06 rests-on-item-05 way8)
    ; what that costs, by where the one is from, and what the other bears
    (fee way1 from-perch n0 cost12) (fee way1 from-spot n0 cost12)
    (fee way2 from-perch n0 cost12) (fee way2 from-spot n0 cost12) (fee way2 from-spot n1 cost161)
    (fee way3 from-perch n0 cost37) (fee way3 from-spot n0 cost37)
    (fee way4 from-perch n0 cost42) (fee way4 from-perch n1 cost85) (fee way4 from-spot n0 cost12) (fee way4 from-spot n1 cost54)
    (fee way5 from-perch n0 cost54) (fee way5 from-spot n0 cost12)
    (fee way6 from-perch n0 cost56) (fee way6 from-spot n0 cost12)
    (fee way7 from-perch n0 cost59) (fee way7 from-spot n0 cost12)
    (fee way8 from-perch n0 cost64) (fee way8 from-spot n0 cost12)
    (fee way9 from-perch n0 cost79) (fee way9 from-spot n0 cost37)
    (fee way10 from-perch n0 cost81) (fee way10 from-spot n0 cost37)
    (fee way11 from-perch n0 cost121) (fee way11 from-perch n1 cost160) (fee way11 from-spot n0 cost121) (fee way11 from-spot n1 cost149)
    (fee way12 from-perch n0 cost121) (fee way12 from-spot n0 cost70)
    (fee way13 from-perch n0 cost121) (fee way13 from-spot n0 cost121)
    (fee way14 from-perch n0 cost146) (fee way14 from-spot n0 cost121)
    (fee way15 from-perch n0 cost157) (fee way15 from-perch n1 cost157) (fee way15 from-spot n0 cost121) (fee way15 from-spot n1 cost121)
    (fee way16 from-perch n0 cost167) (fee way16 from-spot n0 cost167)
    (fee way17 from-perch n0 cost184) (fee way17 from-perch n1 cost234) (fee way17 from-spot n0 cost121) (fee way17 from-spot n1 cost149)
    (fee way18 from-spot n0 cost121)
    (= (total-cost) 0) (= (cost cost4) 4) (= (cost cost11) 11) (= (cost cost12) 12) (= (cost cost37) 37) (= (cost cost42) 42) (= (cost cost54) 54) (= (cost cost56) 56) (= (cost cost59) 59) (= (cost cost64) 64) (= (cost cost70) 70) (= (cost cost79) 79) (= (cost cost81) 81) (= (cost cost85) 85) (= (cost cost121) 121) (= (cost cost146) 146) (= (cost cost149) 149) (= (cost cost157) 157) (= (cost cost160) 160) (= (cost cost161) 161) (= (cost cost167) 167) (= (cost cost184) 184) (= (cost cost234) 234)
  )
  (:goal (and (stands item-02 rests-on-item-03) (stands item-01 rests-on-item-05)))
  (:metric minimize (total-cost)))
