; Problem unstack-5-15 of the learned domain towers.
; How it came about: unstack, drawn with seed 16; draw 2.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem unstack-5-15)
  (:domain towers)
  (:objects
    item-01 - hollow-wide-00
    item-02 - solid-low-narrow-01
    item-03 - solid-low-10
    item-04 - solid-low-narrow-01
    item-05 - solid-low-10
    start-item-02 start-item-03 start-item-05 park-01 park-02 park-03 park-04 park-05 - spot
    rests-on-item-01 sits-in-item-01 rests-on-item-02 rests-on-item-03 rests-on-item-04 rests-on-item-05 - perch
    n1 n2 - count
    way1 way2 way3 way4 way5 way6 way7 way8 way9 - way
    cost4 cost12 cost22 cost35 cost37 cost49 cost70 cost121 - price)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 rests-on-item-04) (bears item-01 n0) (can-take item-01)
    (stands item-02 start-item-02) (bears item-02 n1) (can-take item-02)
    (stands item-03 start-item-03) (bears item-03 n0) (can-take item-03)
    (stands item-04 rests-on-item-02) (bears item-04 n1) (can-take item-04)
    (stands item-05 start-item-05) (bears item-05 n0) (can-take item-05)
    ; park-01 lies at (0.6669, 0.1668) m
    (free park-01)
    (check item-01 park-01 nowhere)
    (check item-02 park-01 nowhere)
    (check item-04 park-01 nowhere)
    ; park-02 lies at (0.7721, -0.1906) m
    (free park-02)
    (check item-01 park-02 nowhere)
    (check item-02 park-02 nowhere)
    (check item-04 park-02 nowhere)
    ; park-03 lies at (0.5866, -0.1341) m
    (free park-03)
    (check item-01 park-03 nowhere)
    (check item-02 park-03 nowhere)
    (check item-04 park-03 nowhere)
    ; park-04 lies at (0.5176, 0.0504) m
    (free park-04)
    (check item-02 park-04 nowhere)
    (check item-04 park-04 nowhere)
    ; park-05 lies at (0.7523, -0.0162) m
    (free park-05)
    (check item-02 park-05 nowhere)
    (check item-04 park-05 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 from-spot cost4) (can-carry item-01 from-perch cost4)
    (can-carry item-02 from-spot cost4) (can-carry item-02 from-perch cost4)
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
    (on rests-on-item-05 item-05)
    ; what puts one thing on or into another
    (can-put item-01 rests-on-item-02 way1) (can-put item-01 rests-on-item-03 way1) (can-put item-01 rests-on-item-04 way4) (can-put item-01 rests-on-item-05 way1)
    (can-put item-02 sits-in-item-01 way9) (can-put item-02 rests-on-item-03 way2) (can-put item-02 rests-on-item-04 way3) (can-put item-02 rests-on-item-05 way2)
    (can-put item-03 rests-on-item-01 way8) (can-put item-03 rests-on-item-02 way8) (can-put item-03 rests-on-item-04 way8)
    (can-put item-04 rests-on-item-01 way7) (can-put item-04 rests-on-item-02 way1) (can-put item-04 rests-on-item-03 way5) (can-put item-04 rests-on-item-05 way5)
    (can-put item-05 rests-on-item-01 way6) (can-put item-05 rests-on-item-04 way8)
    ; what that costs, by where the one is from, and what the other bears
    (fee way1 from-perch n0 cost12) (fee way1 from-spot n0 cost12)
    (fee way2 from-perch n0 cost22) (fee way2 from-spot n0 cost12)
    (fee way3 from-perch n0 cost35) (fee way3 from-spot n0 cost12)
    (fee way4 from-perch n0 cost37) (fee way4 from-spot n0 cost37)
    (fee way5 from-perch n0 cost49) (fee way5 from-spot n0 cost12)
    (fee way6 from-perch n0 cost70) (fee way6 from-spot n0 cost70)
    (fee way7 from-perch n0 cost121) (fee way7 from-perch n1 cost121) (fee way7 from-spot n0 cost121) (fee way7 from-spot n1 cost121)
    (fee way8 from-perch n0 cost121) (fee way8 from-spot n0 cost121)
    (fee way9 from-spot n0 cost12) (fee way9 from-spot n1 cost12)
    (= (total-cost) 0) (= (cost cost4) 4) (= (cost cost12) 12) (= (cost cost22) 22) (= (cost cost35) 35) (= (cost cost37) 37) (= (cost cost49) 49) (= (cost cost70) 70) (= (cost cost121) 121)
  )
  (:goal (and (stands item-01 rests-on-item-03) (stands item-04 rests-on-item-05)))
  (:metric minimize (total-cost)))
