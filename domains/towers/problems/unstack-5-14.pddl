; Problem unstack-5-14 of the learned domain towers.
; How it came about: unstack, drawn with seed 15; draw 4.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem unstack-5-14)
  (:domain towers)
  (:objects
    item-01 - solid-low-narrow-01
    item-02 - hollow-wide-00
    item-03 - solid-low-narrow-01
    item-04 - any-tall-narrow-11
    item-05 - solid-low-10
    start-item-01 start-item-02 start-item-04 park-01 park-02 park-03 park-04 park-05 - spot
    rests-on-item-01 sits-in-item-01 rests-on-item-02 sits-in-item-02 rests-on-item-03 sits-in-item-03 rests-on-item-04 sits-in-item-04 rests-on-item-05 - perch
    n1 n2 - count
    way1 way2 way3 way4 way5 way6 way7 way8 way9 way10 way11 way12 way13 way14 way15 way16 - way
    cost4 cost7 cost12 cost13 cost14 cost17 cost22 cost23 cost29 cost35 cost37 cost49 cost53 cost61 cost70 cost76 cost82 cost116 cost121 cost133 cost136 cost141 - price)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 start-item-01) (bears item-01 n0) (can-take item-01)
    (stands item-02 start-item-02) (bears item-02 n1) (can-take item-02)
    (stands item-03 rests-on-item-05) (bears item-03 n0) (can-take item-03)
    (stands item-04 start-item-04) (bears item-04 n0) (can-take item-04)
    (stands item-05 rests-on-item-02) (bears item-05 n1) (can-take item-05)
    ; park-01 lies at (0.8399, 0.1831) m
    (free park-01)
    (check item-01 park-01 nowhere)
    (check item-02 park-01 nowhere)
    (check item-03 park-01 nowhere)
    (check item-04 park-01 nowhere)
    (check item-05 park-01 nowhere)
    ; park-02 lies at (0.8158, -0.0541) m
    (free park-02)
    (check item-01 park-02 nowhere)
    (check item-02 park-02 nowhere)
    (check item-03 park-02 nowhere)
    (check item-04 park-02 nowhere)
    (check item-05 park-02 nowhere)
    ; park-03 lies at (0.6703, 0.1960) m
    (free park-03)
    (check item-01 park-03 nowhere)
    (check item-02 park-03 start-item-04) (then item-02 park-03 start-item-04 nowhere)
    (check item-03 park-03 nowhere)
    (check item-05 park-03 nowhere)
    ; park-04 lies at (0.5103, 0.1992) m
    (free park-04)
    (check item-01 park-04 nowhere)
    (check item-02 park-04 start-item-04) (then item-02 park-04 start-item-04 nowhere)
    (check item-03 park-04 nowhere)
    (check item-05 park-04 nowhere)
    ; park-05 lies at (0.8593, -0.2115) m
    (free park-05)
    (check item-01 park-05 nowhere)
    (check item-03 park-05 nowhere)
    (check item-04 park-05 start-item-01) (then item-04 park-05 start-item-01 nowhere)
    (check item-05 park-05 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 from-spot cost14) (can-carry item-01 from-perch cost14)
    (can-carry item-02 from-spot cost4) (can-carry item-02 from-perch cost4)
    (can-carry item-03 from-spot cost4) (can-carry item-03 from-perch cost4)
    (can-carry item-04 from-spot cost14) (can-carry item-04 from-perch cost14)
    (can-carry item-05 from-spot cost7) (can-carry item-05 from-perch cost7)
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
    ; what puts one thing on or into another
    (can-put item-01 rests-on-item-02 way5) (can-put item-01 rests-on-item-03 way8) (can-put item-01 sits-in-item-04 way3) (can-put item-01 rests-on-item-05 way1)
    (can-put item-02 rests-on-item-01 way1) (can-put item-02 rests-on-item-03 way1) (can-put item-02 rests-on-item-04 way1) (can-put item-02 rests-on-item-05 way1)
    (can-put item-03 rests-on-item-01 way6) (can-put item-03 sits-in-item-02 way15) (can-put item-03 sits-in-item-04 way13) (can-put item-03 rests-on-item-05 way1)
    (can-put item-04 rests-on-item-01 way9) (can-put-loaded item-04 rests-on-item-01 way11) (can-put item-04 sits-in-item-01 way16) (can-put item-04 rests-on-item-02 way1) (can-put item-04 rests-on-item-03 way14) (can-put item-04 sits-in-item-03 way12) (can-put item-04 rests-on-item-05 way2)
    (can-put item-05 rests-on-item-01 way7) (can-put item-05 rests-on-item-02 way4) (can-put item-05 rests-on-item-03 way10) (can-put item-05 rests-on-item-04 way7)
    ; what that costs, by where the one is from, and what the other bears
    (fee way1 from-perch n0 cost12) (fee way1 from-spot n0 cost12)
    (fee way2 from-perch n0 cost17) (fee way2 from-perch n1 cost82) (fee way2 from-spot n0 cost12) (fee way2 from-spot n1 cost76)
    (fee way3 from-perch n0 cost22) (fee way3 from-perch n1 cost23) (fee way3 from-spot n0 cost12) (fee way3 from-spot n1 cost13)
    (fee way4 from-perch n0 cost23) (fee way4 from-spot n0 cost12)
    (fee way5 from-perch n0 cost29) (fee way5 from-spot n0 cost12)
    (fee way6 from-perch n0 cost35) (fee way6 from-spot n0 cost12)
    (fee way7 from-perch n0 cost49) (fee way7 from-spot n0 cost37)
    (fee way8 from-perch n0 cost53) (fee way8 from-spot n0 cost12)
    (fee way9 from-perch n0 cost61) (fee way9 from-spot n0 cost37)
    (fee way10 from-perch n0 cost133) (fee way10 from-spot n0 cost121)
    (fee way11 from-perch n0 cost136) (fee way11 from-spot n0 cost116)
    (fee way12 from-perch n0 cost141) (fee way12 from-perch n1 cost141) (fee way12 from-spot n0 cost121) (fee way12 from-spot n1 cost121)
    (fee way13 from-spot n0 cost12) (fee way13 from-spot n1 cost12)
    (fee way14 from-spot n0 cost70)
    (fee way15 from-spot n0 cost70) (fee way15 from-spot n1 cost70)
    (fee way16 from-spot n0 cost121) (fee way16 from-spot n1 cost121)
    (= (total-cost) 0) (= (cost cost4) 4) (= (cost cost7) 7) (= (cost cost12) 12) (= (cost cost13) 13) (= (cost cost14) 14) (= (cost cost17) 17) (= (cost cost22) 22) (= (cost cost23) 23) (= (cost cost29) 29) (= (cost cost35) 35) (= (cost cost37) 37) (= (cost cost49) 49) (= (cost cost53) 53) (= (cost cost61) 61) (= (cost cost70) 70) (= (cost cost76) 76) (= (cost cost82) 82) (= (cost cost116) 116) (= (cost cost121) 121) (= (cost cost133) 133) (= (cost cost136) 136) (= (cost cost141) 141)
  )
  (:goal (and (stands item-03 rests-on-item-01) (stands item-05 rests-on-item-04)))
  (:metric minimize (total-cost)))
