; Problem boxes-4-10 of the learned domain towers.
; How it came about: boxes, drawn with seed 11; draw 1.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem boxes-4-10)
  (:domain towers)
  (:objects
    item-01 - solid-low-narrow-01
    item-02 item-03 - solid-low-10
    item-04 - any-tall-narrow-11
    start-item-01 start-item-02 start-item-03 start-item-04 park-01 park-02 park-03 park-04 - spot
    rests-on-item-01 sits-in-item-01 rests-on-item-02 rests-on-item-03 rests-on-item-04 - perch
    n1 n2 - count
    way1 way2 way3 way4 way5 way6 way7 way8 way9 way10 way11 way12 way13 - way
    cost4 cost7 cost11 cost12 cost22 cost27 cost32 cost36 cost37 cost49 cost57 cost64 cost70 cost77 cost82 cost102 cost121 cost133 - price)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 start-item-01) (bears item-01 n0) (can-take item-01)
    (stands item-02 start-item-02) (bears item-02 n0) (can-take item-02)
    (stands item-03 start-item-03) (bears item-03 n0) (can-take item-03)
    (stands item-04 start-item-04) (bears item-04 n0) (can-take item-04)
    ; park-01 lies at (0.7119, -0.0921) m
    (free park-01)
    (check item-01 park-01 nowhere)
    (check item-03 park-01 nowhere)
    (check item-04 park-01 nowhere)
    ; park-02 lies at (0.6697, 0.1740) m
    (free park-02)
    (check item-01 park-02 nowhere)
    (check item-03 park-02 nowhere)
    (check item-04 park-02 nowhere)
    ; park-03 lies at (0.8746, -0.0598) m
    (free park-03)
    (check item-01 park-03 nowhere)
    (check item-03 park-03 nowhere)
    (check item-04 park-03 nowhere)
    ; park-04 lies at (0.5401, -0.1999) m
    (free park-04)
    (check item-01 park-04 nowhere)
    (check item-03 park-04 nowhere)
    (check item-04 park-04 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 from-spot cost7) (can-carry item-01 from-perch cost7)
    (can-carry item-03 from-spot cost11) (can-carry item-03 from-perch cost11)
    (can-carry item-04 from-spot cost4) (can-carry item-04 from-perch cost4)
    ; counting
    (next n0 n1)
    (next n1 n2)
    ; on or in what
    (on rests-on-item-01 item-01)
    (on sits-in-item-01 item-01)
    (on rests-on-item-02 item-02)
    (on rests-on-item-03 item-03)
    (on rests-on-item-04 item-04)
    ; what puts one thing on or into another
    (can-put item-01 rests-on-item-02 way2) (can-put item-01 rests-on-item-03 way1) (can-put item-01 rests-on-item-04 way6)
    (can-put item-02 rests-on-item-03 way12)
    (can-put item-03 rests-on-item-01 way5) (can-put item-03 rests-on-item-02 way8) (can-put item-03 rests-on-item-04 way11)
    (can-put item-04 rests-on-item-01 way4) (can-put-loaded item-04 rests-on-item-01 way10) (can-put item-04 sits-in-item-01 way13) (can-put item-04 rests-on-item-02 way7) (can-put item-04 rests-on-item-03 way3) (can-put-loaded item-04 rests-on-item-03 way9)
    ; what that costs, by where the one is from, and what the other bears
    (fee way1 from-perch n0 cost22) (fee way1 from-spot n0 cost12)
    (fee way2 from-perch n0 cost27) (fee way2 from-spot n0 cost12)
    (fee way3 from-perch n0 cost32) (fee way3 from-spot n0 cost12)
    (fee way4 from-perch n0 cost36) (fee way4 from-spot n0 cost12)
    (fee way5 from-perch n0 cost37) (fee way5 from-spot n0 cost37)
    (fee way6 from-perch n0 cost49) (fee way6 from-spot n0 cost12)
    (fee way7 from-perch n0 cost64) (fee way7 from-spot n0 cost12)
    (fee way8 from-perch n0 cost70) (fee way8 from-spot n0 cost70)
    (fee way9 from-perch n0 cost77) (fee way9 from-spot n0 cost57)
    (fee way10 from-perch n0 cost102) (fee way10 from-spot n0 cost82)
    (fee way11 from-perch n0 cost133) (fee way11 from-spot n0 cost70)
    (fee way12 from-perch n0 cost133) (fee way12 from-spot n0 cost121)
    (fee way13 from-spot n0 cost121) (fee way13 from-spot n1 cost121)
    (= (total-cost) 0) (= (cost cost4) 4) (= (cost cost7) 7) (= (cost cost11) 11) (= (cost cost12) 12) (= (cost cost22) 22) (= (cost cost27) 27) (= (cost cost32) 32) (= (cost cost36) 36) (= (cost cost37) 37) (= (cost cost49) 49) (= (cost cost57) 57) (= (cost cost64) 64) (= (cost cost70) 70) (= (cost cost77) 77) (= (cost cost82) 82) (= (cost cost102) 102) (= (cost cost121) 121) (= (cost cost133) 133)
  )
  (:goal (and (stands item-04 rests-on-item-03) (stands item-01 rests-on-item-02)))
  (:metric minimize (total-cost)))
