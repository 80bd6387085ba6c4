; Problem exchange-6-18 of the learned domain towers.
; How it came about: exchange, drawn with seed 19; draw 1.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem exchange-6-18)
  (:domain towers)
  (:objects
    item-01 - solid-low-narrow-01
    item-02 - any-tall-narrow-11
    item-03 - hollow-wide-00
    item-04 - any-tall-narrow-11
    item-05 item-06 - solid-low-10
    start-item-02 start-item-04 start-item-05 start-item-06 park-01 park-02 park-03 park-04 park-05 park-06 - spot
    rests-on-item-01 rests-on-item-02 sits-in-item-02 rests-on-item-03 sits-in-item-03 rests-on-item-04 sits-in-item-04 rests-on-item-05 rests-on-item-06 - perch
    n1 n2 - count
    way1 way2 way3 way4 way5 way6 way7 way8 way9 way10 way11 way12 way13 way14 way15 way16 way17 way18 - way
    cost4 cost12 cost22 cost30 cost31 cost32 cost36 cost37 cost49 cost56 cost57 cost64 cost77 cost82 cost102 cost121 cost125 cost144 cost174 cost196 - price)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 rests-on-item-05) (bears item-01 n0) (can-take item-01)
    (stands item-02 start-item-02) (bears item-02 n0) (can-take item-02)
    (stands item-03 rests-on-item-06) (bears item-03 n0) (can-take item-03)
    (stands item-04 start-item-04) (bears item-04 n0) (can-take item-04)
    (stands item-05 start-item-05) (bears item-05 n1) (can-take item-05)
    (stands item-06 start-item-06) (bears item-06 n1) (can-take item-06)
    ; park-01 lies at (0.8430, 0.1854) m
    (free park-01)
    (check item-01 park-01 nowhere)
    (check item-02 park-01 nowhere)
    (check item-03 park-01 nowhere)
    (check item-04 park-01 nowhere)
    ; park-02 lies at (0.4497, -0.2003) m
    (free park-02)
    (check item-01 park-02 nowhere)
    (check item-02 park-02 nowhere)
    (check item-03 park-02 nowhere)
    (check item-04 park-02 nowhere)
    ; park-03 lies at (0.7192, -0.1198) m
    (free park-03)
    (check item-01 park-03 start-item-04) (then item-01 park-03 start-item-04 start-item-05) (then item-01 park-03 start-item-05 nowhere)
    (check item-02 park-03 start-item-04) (then item-02 park-03 start-item-04 start-item-05) (then item-02 park-03 start-item-05 nowhere)
    (check item-03 park-03 start-item-04) (then item-03 park-03 start-item-04 start-item-05) (then item-03 park-03 start-item-05 nowhere)
    (check item-04 park-03 start-item-05) (then item-04 park-03 start-item-05 nowhere)
    ; park-04 lies at (0.6720, 0.2265) m
    (free park-04)
    (check item-01 park-04 nowhere)
    (check item-02 park-04 nowhere)
    (check item-04 park-04 nowhere)
    ; park-05 lies at (0.8096, -0.2589) m
    (free park-05)
    (check item-01 park-05 nowhere)
    ; park-06 lies at (0.8335, 0.0216) m
    (free park-06)
    (check item-01 park-06 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 from-spot cost4) (can-carry item-01 from-perch cost4)
    (can-carry item-02 from-spot cost4) (can-carry item-02 from-perch cost4)
    (can-carry item-03 from-spot cost4) (can-carry item-03 from-perch cost4)
    (can-carry item-04 from-spot cost4) (can-carry item-04 from-perch cost4)
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
    (on sits-in-item-04 item-04)
    (on rests-on-item-05 item-05)
    (on rests-on-item-06 item-06)
    ; what puts one thing on or into another
    (can-put item-01 rests-on-item-02 way2) (can-put item-01 rests-on-item-03 way12) (can-put item-01 sits-in-item-03 way15) (can-put item-01 rests-on-item-04 way2) (can-put item-01 rests-on-item-05 way3) (can-put item-01 rests-on-item-06 way7)
    (can-put item-02 rests-on-item-01 way5) (can-put-loaded item-02 rests-on-item-01 way10) (can-put item-02 sits-in-item-03 way1) (can-put item-02 rests-on-item-04 way9) (can-put item-02 sits-in-item-04 way14) (can-put item-02 rests-on-item-05 way9) (can-put item-02 rests-on-item-06 way9)
    (can-put item-03 rests-on-item-01 way17) (can-put item-03 sits-in-item-02 way4) (can-put item-03 rests-on-item-04 way18) (can-put item-03 sits-in-item-04 way8) (can-put item-03 rests-on-item-05 way16) (can-put item-03 rests-on-item-06 way17)
    (can-put item-04 rests-on-item-01 way5) (can-put-loaded item-04 rests-on-item-01 way10) (can-put item-04 rests-on-item-02 way6) (can-put-loaded item-04 rests-on-item-02 way11) (can-put item-04 sits-in-item-03 way1) (can-put item-04 rests-on-item-05 way9) (can-put item-04 rests-on-item-06 way9)
    (can-put item-05 rests-on-item-03 way13)
    (can-put item-06 rests-on-item-02 way13)
    ; what that costs, by where the one is from, and what the other bears
    (fee way1 from-perch n0 cost12) (fee way1 from-perch n1 cost12) (fee way1 from-spot n0 cost12) (fee way1 from-spot n1 cost12)
    (fee way2 from-perch n0 cost22) (fee way2 from-spot n0 cost12)
    (fee way3 from-perch n0 cost30) (fee way3 from-spot n0 cost12)
    (fee way4 from-perch n0 cost31) (fee way4 from-perch n1 cost31) (fee way4 from-spot n0 cost12) (fee way4 from-spot n1 cost12)
    (fee way5 from-perch n0 cost32) (fee way5 from-spot n0 cost12)
    (fee way6 from-perch n0 cost36) (fee way6 from-spot n0 cost12)
    (fee way7 from-perch n0 cost49) (fee way7 from-spot n0 cost12)
    (fee way8 from-perch n0 cost56) (fee way8 from-perch n1 cost56) (fee way8 from-spot n0 cost12) (fee way8 from-spot n1 cost12)
    (fee way9 from-perch n0 cost64) (fee way9 from-spot n0 cost12)
    (fee way10 from-perch n0 cost77) (fee way10 from-spot n0 cost57)
    (fee way11 from-perch n0 cost102) (fee way11 from-spot n0 cost82)
    (fee way12 from-perch n0 cost121) (fee way12 from-perch n1 cost121) (fee way12 from-spot n0 cost121) (fee way12 from-spot n1 cost121)
    (fee way13 from-perch n0 cost121) (fee way13 from-spot n0 cost121)
    (fee way14 from-perch n0 cost125) (fee way14 from-perch n1 cost125) (fee way14 from-spot n0 cost121) (fee way14 from-spot n1 cost121)
    (fee way15 from-perch n0 cost144) (fee way15 from-perch n1 cost196) (fee way15 from-spot n0 cost121) (fee way15 from-spot n1 cost174)
    (fee way16 from-spot n0 cost12)
    (fee way17 from-spot n0 cost37)
    (fee way18 from-spot n0 cost121)
    (= (total-cost) 0) (= (cost cost4) 4) (= (cost cost12) 12) (= (cost cost22) 22) (= (cost cost30) 30) (= (cost cost31) 31) (= (cost cost32) 32) (= (cost cost36) 36) (= (cost cost37) 37) (= (cost cost49) 49) (= (cost cost56) 56) (= (cost cost57) 57) (= (cost cost64) 64) (= (cost cost77) 77) (= (cost cost82) 82) (= (cost cost102) 102) (= (cost cost121) 121) (= (cost cost125) 125) (= (cost cost144) 144) (= (cost cost174) 174) (= (cost cost196) 196)
  )
  (:goal (and (stands item-03 rests-on-item-05) (stands item-01 rests-on-item-06)))
  (:metric minimize (total-cost)))
