; Problem tower-4-04 of the learned domain towers.
; How it came about: tower, drawn with seed 5; draw 1.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem tower-4-04)
  (:domain towers)
  (:objects
    item-01 - hollow-wide-00
    item-02 - solid-low-10
    item-03 - hollow-wide-00
    item-04 - solid-low-narrow-01
    start-item-01 start-item-02 start-item-03 start-item-04 park-01 park-02 park-03 park-04 - spot
    rests-on-item-01 sits-in-item-01 rests-on-item-02 rests-on-item-03 sits-in-item-03 rests-on-item-04 sits-in-item-04 - perch
    n1 n2 - count
    way1 way2 way3 way4 way5 way6 way7 way8 way9 - way
    cost4 cost12 cost37 cost50 cost51 cost70 cost121 cost133 cost182 - price)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 start-item-01) (bears item-01 n0) (can-take item-01)
    (stands item-02 start-item-02) (bears item-02 n0) (can-take item-02)
    (stands item-03 start-item-03) (bears item-03 n0) (can-take item-03)
    (stands item-04 start-item-04) (bears item-04 n0) (can-take item-04)
    ; park-01 lies at (0.6441, 0.1504) m
    (free park-01)
    (check item-01 park-01 nowhere)
    (check item-03 park-01 nowhere)
    (check item-04 park-01 nowhere)
    ; park-02 lies at (0.4934, -0.0817) m
    (free park-02)
    (check item-01 park-02 nowhere)
    (check item-03 park-02 nowhere)
    (check item-04 park-02 nowhere)
    ; park-03 lies at (0.6500, -0.0301) m
    (free park-03)
    (check item-01 park-03 nowhere)
    (check item-03 park-03 nowhere)
    (check item-04 park-03 nowhere)
    ; park-04 lies at (0.4136, -0.2335) m
    (free park-04)
    (check item-04 park-04 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 from-spot cost4) (can-carry item-01 from-perch cost4)
    (can-carry item-03 from-spot cost4) (can-carry item-03 from-perch cost4)
    (can-carry item-04 from-spot cost4) (can-carry item-04 from-perch cost4)
    ; counting
    (next n0 n1)
    (next n1 n2)
    ; on or in what
    (on rests-on-item-01 item-01)
    (on sits-in-item-01 item-01)
    (on rests-on-item-02 item-02)
    (on rests-on-item-03 item-03)
    (on sits-in-item-03 item-03)
    (on rests-on-item-04 item-04)
    (on sits-in-item-04 item-04)
    ; what puts one thing on or into another
    (can-put item-01 rests-on-item-02 way1) (can-put item-01 rests-on-item-03 way4) (can-put item-01 sits-in-item-03 way9) (can-put item-01 rests-on-item-04 way8) (can-put item-01 sits-in-item-04 way9)
    (can-put item-02 rests-on-item-01 way5) (can-put item-02 rests-on-item-03 way5)
    (can-put item-03 rests-on-item-01 way2) (can-put item-03 rests-on-item-02 way2) (can-put item-03 rests-on-item-04 way2)
    (can-put item-04 rests-on-item-01 way3) (can-put item-04 sits-in-item-01 way6) (can-put item-04 rests-on-item-02 way2) (can-put item-04 sits-in-item-03 way7)
    ; what that costs, by where the one is from, and what the other bears
    (fee way1 from-perch n0 cost12) (fee way1 from-perch n1 cost51) (fee way1 from-spot n0 cost12) (fee way1 from-spot n1 cost51)
    (fee way2 from-perch n0 cost12) (fee way2 from-spot n0 cost12)
    (fee way3 from-perch n0 cost50) (fee way3 from-spot n0 cost37)
    (fee way4 from-perch n0 cost70) (fee way4 from-spot n0 cost70)
    (fee way5 from-perch n0 cost133) (fee way5 from-spot n0 cost121)
    (fee way6 from-perch n0 cost182) (fee way6 from-perch n1 cost182) (fee way6 from-spot n0 cost121) (fee way6 from-spot n1 cost121)
    (fee way7 from-spot n0 cost37) (fee way7 from-spot n1 cost37)
    (fee way8 from-spot n0 cost70)
    (fee way9 from-spot n0 cost121) (fee way9 from-spot n1 cost121)
    (= (total-cost) 0) (= (cost cost4) 4) (= (cost cost12) 12) (= (cost cost37) 37) (= (cost cost50) 50) (= (cost cost51) 51) (= (cost cost70) 70) (= (cost cost121) 121) (= (cost cost133) 133) (= (cost cost182) 182)
  )
  (:goal (and (stands item-03 rests-on-item-01) (stands item-01 rests-on-item-02)))
  (:metric minimize (total-cost)))
