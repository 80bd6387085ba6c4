; Problem unstack-5-14 of the learned domain towers.
; How it came about: unstack, drawn with seed 15; draw 1.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem unstack-5-14)
  (:domain towers)
  (:objects
    item-01 - any-tall-narrow-11
    item-02 - solid-low-narrow-01
    item-03 - solid-low-10
    item-04 item-05 - solid-low-narrow-01
    start-item-01 start-item-02 start-item-03 park-01 park-02 park-03 park-04 park-05 - spot
    rests-on-item-01 sits-in-item-01 rests-on-item-02 sits-in-item-02 rests-on-item-03 sits-in-item-03 rests-on-item-04 sits-in-item-04 rests-on-item-05 sits-in-item-05 - perch
    n1 n2 - count
    way1 way2 way3 way4 way5 way6 way7 way8 way9 way10 way11 way12 way13 way14 way15 way16 way17 way18 way19 way20 - way
    cost4 cost12 cost17 cost32 cost37 cost42 cost48 cost54 cost56 cost58 cost64 cost70 cost77 cost81 cost85 cost121 cost142 cost148 cost149 cost167 cost174 cost193 cost227 - price)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 start-item-01) (bears item-01 n0) (can-take item-01)
    (stands item-02 start-item-02) (bears item-02 n1) (can-take item-02)
    (stands item-03 start-item-03) (bears item-03 n0)
    (stands item-04 rests-on-item-05) (bears item-04 n0) (can-take item-04)
    (stands item-05 rests-on-item-02) (bears item-05 n1) (can-take item-05)
    ; park-01 lies at (0.5109, 0.1947) m
    (free park-01)
    (check item-01 park-01 nowhere)
    (check item-02 park-01 nowhere)
    (check item-04 park-01 nowhere)
    (check item-05 park-01 nowhere)
    ; park-02 lies at (0.4681, -0.1992) m
    (free park-02)
    (check item-01 park-02 nowhere)
    (check item-02 park-02 nowhere)
    (check item-04 park-02 nowhere)
    (check item-05 park-02 nowhere)
    ; park-03 lies at (0.6976, 0.2039) m
    (free park-03)
    (check item-01 park-03 nowhere)
    (check item-02 park-03 nowhere)
    (check item-04 park-03 nowhere)
    (check item-05 park-03 nowhere)
    ; park-04 lies at (0.7128, -0.1147) m
    (free park-04)
    (check item-01 park-04 start-item-02) (then item-01 park-04 start-item-02 nowhere)
    (check item-02 park-04 nowhere)
    (check item-04 park-04 nowhere)
    (check item-05 park-04 nowhere)
    ; park-05 lies at (0.8780, 0.2395) m
    (free park-05)
    (check item-01 park-05 nowhere)
    (check item-02 park-05 nowhere)
    (check item-04 park-05 nowhere)
    (check item-05 park-05 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 from-spot cost4) (can-carry item-01 from-perch cost4)
    (can-carry item-02 from-spot cost4) (can-carry item-02 from-perch cost4)
    (can-carry item-04 from-spot cost4) (can-carry item-04 from-perch cost4)
    (can-carry item-05 from-spot cost4) (can-carry item-05 from-perch cost4)
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
    (on sits-in-item-05 item-05)
    ; what puts one thing on or into another
    (can-put item-01 rests-on-item-02 way9) (can-put item-01 rests-on-item-03 way1) (can-put item-01 rests-on-item-04 way14) (can-put item-01 sits-in-item-04 way20) (can-put item-01 rests-on-item-05 way18) (can-put item-01 sits-in-item-05 way19)
    (can-put item-02 rests-on-item-01 way11) (can-put item-02 rests-on-item-03 way7) (can-put item-02 rests-on-item-04 way5) (can-put item-02 sits-in-item-04 way20) (can-put item-02 rests-on-item-05 way6)
    (can-put item-04 rests-on-item-01 way13) (can-put item-04 sits-in-item-01 way15) (can-put item-04 rests-on-item-02 way4) (can-put item-04 rests-on-item-03 way8) (can-put item-04 rests-on-item-05 way10) (can-put item-04 sits-in-item-05 way16)
    (can-put item-05 rests-on-item-01 way17) (can-put item-05 sits-in-item-01 way3) (can-put item-05 rests-on-item-02 way12) (can-put item-05 sits-in-item-02 way20) (can-put item-05 rests-on-item-03 way2) (can-put item-05 sits-in-item-03 way20) (can-put item-05 rests-on-item-04 way12)
    ; what that costs, by where the one is from, and what the other bears
    (fee way1 from-perch n0 cost12) (fee way1 from-spot n0 cost12)
    (fee way2 from-perch n0 cost17) (fee way2 from-spot n0 cost12)
    (fee way3 from-perch n0 cost32) (fee way3 from-perch n1 cost70) (fee way3 from-spot n0 cost12) (fee way3 from-spot n1 cost56)
    (fee way4 from-perch n0 cost32) (fee way4 from-spot n0 cost12)
    (fee way5 from-perch n0 cost37) (fee way5 from-spot n0 cost12)
    (fee way6 from-perch n0 cost37) (fee way6 from-spot n0 cost37)
    (fee way7 from-perch n0 cost42) (fee way7 from-perch n1 cost85) (fee way7 from-spot n0 cost12) (fee way7 from-spot n1 cost54)
    (fee way8 from-perch n0 cost48) (fee way8 from-spot n0 cost12)
    (fee way9 from-perch n0 cost56) (fee way9 from-spot n0 cost12)
    (fee way10 from-perch n0 cost58) (fee way10 from-spot n0 cost37)
    (fee way11 from-perch n0 cost64) (fee way11 from-spot n0 cost12)
    (fee way12 from-perch n0 cost77) (fee way12 from-spot n0 cost37)
    (fee way13 from-perch n0 cost81) (fee way13 from-spot n0 cost12)
    (fee way14 from-perch n0 cost81) (fee way14 from-spot n0 cost37)
    (fee way15 from-perch n0 cost142) (fee way15 from-perch n1 cost193) (fee way15 from-spot n0 cost121) (fee way15 from-spot n1 cost121)
    (fee way16 from-perch n0 cost148) (fee way16 from-perch n1 cost148) (fee way16 from-spot n0 cost121) (fee way16 from-spot n1 cost121)
    (fee way17 from-perch n0 cost149) (fee way17 from-spot n0 cost70) (fee way17 from-spot n1 cost167)
    (fee way18 from-perch n0 cost174) (fee way18 from-perch n1 cost227) (fee way18 from-spot n0 cost121) (fee way18 from-spot n1 cost174)
    (fee way19 from-spot n0 cost12) (fee way19 from-spot n1 cost12)
    (fee way20 from-spot n0 cost121) (fee way20 from-spot n1 cost121)
    (= (total-cost) 0) (= (cost cost4) 4) (= (cost cost12) 12) (= (cost cost17) 17) (= (cost cost32) 32) (= (cost cost37) 37) (= (cost cost42) 42) (= (cost cost48) 48) (= (cost cost54) 54) (= (cost cost56) 56) (= (cost cost58) 58) (= (cost cost64) 64) (= (cost cost70) 70) (= (cost cost77) 77) (= (cost cost81) 81) (= (cost cost85) 85) (= (cost cost121) 121) (= (cost cost142) 142) (= (cost cost148) 148) (= (cost cost149) 149) (= (cost cost167) 167) (= (cost cost174) 174) (= (cost cost193) 193) (= (cost cost227) 227)
  )
  (:goal (and (stands item-04 rests-on-item-03) (stands item-05 rests-on-item-01)))
  (:metric minimize (total-cost)))
