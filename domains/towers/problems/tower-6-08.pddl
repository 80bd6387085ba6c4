; Problem tower-6-08 of the learned domain towers.
; How it came about: tower, drawn with seed 9; draw 1.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem tower-6-08)
  (:domain towers)
  (:objects
    item-01 - solid-low-narrow-01
    item-02 item-03 - hollow-wide-00
    item-04 - solid-low-10
    item-05 - any-tall-narrow-11
    item-06 - hollow-wide-00
    start-item-01 start-item-02 start-item-03 start-item-04 start-item-05 start-item-06 park-01 park-02 park-03 park-04 park-05 park-06 - spot
    rests-on-item-01 rests-on-item-02 sits-in-item-02 rests-on-item-03 sits-in-item-03 rests-on-item-04 rests-on-item-05 sits-in-item-05 sits-in-item-06 - perch
    n1 n2 - count
    way1 way2 way3 way4 way5 way6 way7 way8 way9 way10 way11 way12 way13 way14 way15 way16 way17 way18 way19 way20 way21 way22 way23 way24 way25 way26 - way
    cost4 cost11 cost12 cost14 cost15 cost22 cost23 cost30 cost36 cost37 cost48 cost49 cost50 cost51 cost56 cost64 cost70 cost74 cost75 cost82 cost84 cost90 cost102 cost121 cost141 cost174 - price)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 start-item-01) (bears item-01 n0) (can-take item-01)
    (stands item-02 start-item-02) (bears item-02 n0) (can-take item-02)
    (stands item-03 start-item-03) (bears item-03 n0) (can-take item-03)
    (stands item-04 start-item-04) (bears item-04 n0) (can-take item-04)
    (stands item-05 start-item-05) (bears item-05 n0) (can-take item-05)
    (stands item-06 start-item-06) (bears item-06 n0) (can-take item-06)
    ; park-01 lies at (0.7494, -0.0010) m
    (free park-01)
    (check item-01 park-01 nowhere)
    (check item-02 park-01 nowhere)
    (check item-03 park-01 nowhere)
    (check item-04 park-01 nowhere)
    (check item-05 park-01 nowhere)
    (check item-06 park-01 nowhere)
    ; park-02 lies at (0.7055, 0.1816) m
    (free park-02)
    (check item-01 park-02 nowhere)
    (check item-02 park-02 nowhere)
    (check item-03 park-02 nowhere)
    (check item-04 park-02 nowhere)
    (check item-05 park-02 nowhere)
    (check item-06 park-02 start-item-01) (then item-06 park-02 start-item-01 nowhere)
    ; park-03 lies at (0.8435, -0.1996) m
    (free park-03)
    (check item-01 park-03 nowhere)
    (check item-02 park-03 nowhere)
    (check item-03 park-03 nowhere)
    (check item-04 park-03 nowhere)
    (check item-05 park-03 nowhere)
    (check item-06 park-03 start-item-03) (then item-06 park-03 start-item-03 start-item-04) (then item-06 park-03 start-item-04 nowhere)
    ; park-04 lies at (0.4456, 0.1752) m
    (free park-04)
    (check item-01 park-04 nowhere)
    ; park-05 lies at (0.5695, -0.1842) m
    (free park-05)
    (check item-01 park-05 start-item-05) (then item-01 park-05 start-item-05 nowhere)
    (check item-02 park-05 start-item-03) (then item-02 park-05 start-item-03 start-item-05) (then item-02 park-05 start-item-05 nowhere)
    (check item-03 park-05 start-item-05) (then item-03 park-05 start-item-05 nowhere)
    (check item-04 park-05 nowhere)
    (check item-05 park-05 nowhere)
    (check item-06 park-05 start-item-03) (then item-06 park-05 start-item-03 start-item-05) (then item-06 park-05 start-item-05 nowhere)
    ; park-06 lies at (0.5024, 0.2329) m
    (free park-06)
    (check item-01 park-06 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 from-spot cost14) (can-carry item-01 from-perch cost14)
    (can-carry item-02 from-spot cost4) (can-carry item-02 from-perch cost4)
    (can-carry item-03 from-spot cost4) (can-carry item-03 from-perch cost4)
    (can-carry item-04 from-spot cost11) (can-carry item-04 from-perch cost11)
    (can-carry item-05 from-spot cost4) (can-carry item-05 from-perch cost4)
    (can-carry item-06 from-spot cost4) (can-carry item-06 from-perch cost4)
    ; counting
    (next n0 n1)
    (next n1 n2)
    ; on or in what
    (on rests-on-item-01 item-01)
    (on rests-on-item-02 item-02)
    (on sits-in-item-02 item-02)
    (on rests-on-item-03 item-03)
    (on sits-in-item-03 item-03)
    (on rests-on-item-04 item-04)
    (on rests-on-item-05 item-05)
    (on sits-in-item-05 item-05)
    (on sits-in-item-06 item-06)
    ; what puts one thing on or into another
    (can-put item-01 rests-on-item-02 way17) (can-put item-01 rests-on-item-03 way5) (can-put item-01 rests-on-item-04 way8) (can-put item-01 rests-on-item-05 way5) (can-put item-01 sits-in-item-06 way9)
    (can-put item-02 rests-on-item-01 way23) (can-put item-02 rests-on-item-03 way23) (can-put item-02 rests-on-item-04 way2) (can-put item-02 rests-on-item-05 way26) (can-put item-02 sits-in-item-05 way18) (can-put item-02 sits-in-item-06 way6)
    (can-put item-03 rests-on-item-01 way23) (can-put item-03 rests-on-item-02 way3) (can-put item-03 rests-on-item-04 way2) (can-put item-03 rests-on-item-05 way25) (can-put item-03 sits-in-item-05 way20) (can-put item-03 sits-in-item-06 way6)
    (can-put item-04 rests-on-item-01 way12) (can-put item-04 rests-on-item-02 way15) (can-put item-04 rests-on-item-03 way7) (can-put item-04 rests-on-item-05 way7) (can-put item-04 sits-in-item-06 way22)
    (can-put item-05 rests-on-item-01 way10) (can-put-loaded item-05 rests-on-item-01 way19) (can-put item-05 rests-on-item-02 way21) (can-put item-05 sits-in-item-02 way11) (can-put item-05 rests-on-item-03 way21) (can-put item-05 sits-in-item-03 way4) (can-put item-05 rests-on-item-04 way14) (can-put item-05 sits-in-item-06 way1)
    (can-put item-06 rests-on-item-01 way16) (can-put item-06 rests-on-item-02 way23) (can-put item-06 sits-in-item-02 way24) (can-put item-06 rests-on-item-03 way23) (can-put item-06 sits-in-item-03 way20) (can-put item-06 rests-on-item-04 way23) (can-put item-06 sits-in-item-05 way13)
    ; what that costs, by where the one is from, and what the other bears
    (fee way1 from-perch n0 cost12) (fee way1 from-perch n1 cost12) (fee way1 from-spot n0 cost12) (fee way1 from-spot n1 cost12)
    (fee way2 from-perch n0 cost12) (fee way2 from-perch n1 cost51) (fee way2 from-spot n0 cost12) (fee way2 from-spot n1 cost51)
    (fee way3 from-perch n0 cost12) (fee way3 from-spot n0 cost12)
    (fee way4 from-perch n0 cost15) (fee way4 from-perch n1 cost15) (fee way4 from-spot n0 cost12) (fee way4 from-spot n1 cost12)
    (fee way5 from-perch n0 cost22) (fee way5 from-spot n0 cost12)
    (fee way6 from-perch n0 cost23) (fee way6 from-perch n1 cost23) (fee way6 from-spot n0 cost12) (fee way6 from-spot n1 cost12)
    (fee way7 from-perch n0 cost23) (fee way7 from-spot n0 cost12)
    (fee way8 from-perch n0 cost30) (fee way8 from-spot n0 cost12)
    (fee way9 from-perch n0 cost36) (fee way9 from-perch n1 cost75) (fee way9 from-spot n0 cost12) (fee way9 from-spot n1 cost50)
    (fee way10 from-perch n0 cost36) (fee way10 from-spot n0 cost12)
    (fee way11 from-perch n0 cost48) (fee way11 from-perch n1 cost48) (fee way11 from-spot n0 cost37) (fee way11 from-spot n1 cost37)
    (fee way12 from-perch n0 cost49) (fee way12 from-spot n0 cost37)
    (fee way13 from-perch n0 cost56) (fee way13 from-perch n1 cost56) (fee way13 from-spot n0 cost12) (fee way13 from-spot n1 cost12)
    (fee way14 from-perch n0 cost64) (fee way14 from-spot n0 cost12)
    (fee way15 from-perch n0 cost70) (fee way15 from-spot n0 cost70)
    (fee way16 from-perch n0 cost74) (fee way16 from-spot n0 cost70)
    (fee way17 from-perch n0 cost84) (fee way17 from-spot n0 cost70)
    (fee way18 from-perch n0 cost90) (fee way18 from-perch n1 cost90) (fee way18 from-spot n0 cost37) (fee way18 from-spot n1 cost37)
    (fee way19 from-perch n0 cost102) (fee way19 from-spot n0 cost82)
    (fee way20 from-perch n0 cost141) (fee way20 from-perch n1 cost141) (fee way20 from-spot n0 cost37) (fee way20 from-spot n1 cost37)
    (fee way21 from-perch n0 cost174) (fee way21 from-spot n0 cost121)
    (fee way22 from-spot n0 cost12) (fee way22 from-spot n1 cost12)
    (fee way23 from-spot n0 cost37)
    (fee way24 from-spot n0 cost37) (fee way24 from-spot n1 cost37)
    (fee way25 from-spot n0 cost70)
    (fee way26 from-spot n0 cost121)
    (= (total-cost) 0) (= (cost cost4) 4) (= (cost cost11) 11) (= (cost cost12) 12) (= (cost cost14) 14) (= (cost cost15) 15) (= (cost cost22) 22) (= (cost cost23) 23) (= (cost cost30) 30) (= (cost cost36) 36) (= (cost cost37) 37) (= (cost cost48) 48) (= (cost cost49) 49) (= (cost cost50) 50) (= (cost cost51) 51) (= (cost cost56) 56) (= (cost cost64) 64) (= (cost cost70) 70) (= (cost cost74) 74) (= (cost cost75) 75) (= (cost cost82) 82) (= (cost cost84) 84) (= (cost cost90) 90) (= (cost cost102) 102) (= (cost cost121) 121) (= (cost cost141) 141) (= (cost cost174) 174)
  )
  (:goal (and (stands item-02 rests-on-item-01) (stands item-01 rests-on-item-04) (stands item-04 rests-on-item-03)))
  (:metric minimize (total-cost)))
