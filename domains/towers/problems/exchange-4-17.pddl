; Problem exchange-4-17 of the learned domain towers.
; How it came about: exchange, drawn with seed 18; draw 1.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem exchange-4-17)
  (:domain towers)
  (:objects
    item-01 - hollow-wide-00
    item-02 item-03 - solid-low-10
    item-04 - hollow-wide-00
    start-item-02 start-item-03 park-01 park-02 park-03 - spot
    rests-on-item-01 rests-on-item-02 rests-on-item-03 rests-on-item-04 - perch
    n1 n2 - count
    way1 way2 way3 way4 way5 way6 way7 way8 way9 - way
    cost4 cost12 cost39 cost59 cost61 cost64 cost70 cost98 cost117 cost120 cost121 cost124 cost177 - price)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 rests-on-item-03) (bears item-01 n0) (can-take item-01)
    (stands item-02 start-item-02) (bears item-02 n1)
    (stands item-03 start-item-03) (bears item-03 n1) (can-take item-03)
    (stands item-04 rests-on-item-02) (bears item-04 n0) (can-take item-04)
    ; park-01 lies at (0.4753, -0.1845) m
    (free park-01)
    (check item-01 park-01 nowhere)
    (check item-03 park-01 nowhere)
    (check item-04 park-01 nowhere)
    ; park-02 lies at (0.7693, 0.1575) m
    (free park-02)
    (check item-01 park-02 nowhere)
    (check item-03 park-02 nowhere)
    (check item-04 park-02 nowhere)
    ; park-03 lies at (0.4541, -0.0070) m
    (free park-03)
    (check item-01 park-03 nowhere)
    (check item-03 park-03 nowhere)
    (check item-04 park-03 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 from-spot cost4) (can-carry item-01 from-perch cost4)
    (can-carry item-03 from-spot cost120) (can-carry item-03 from-perch cost120)
    (can-carry item-04 from-spot cost4) (can-carry item-04 from-perch cost4)
    ; counting
    (next n0 n1)
    (next n1 n2)
    ; on or in what
    (on rests-on-item-01 item-01)
    (on rests-on-item-02 item-02)
    (on rests-on-item-03 item-03)
    (on rests-on-item-04 item-04)
    ; what puts one thing on or into another
    (can-put item-01 rests-on-item-02 way7) (can-put item-01 rests-on-item-03 way8) (can-put item-01 rests-on-item-04 way9)
    (can-put item-03 rests-on-item-01 way5) (can-put item-03 rests-on-item-02 way4) (can-put item-03 rests-on-item-04 way6)
    (can-put item-04 rests-on-item-01 way3) (can-put item-04 rests-on-item-02 way2) (can-put item-04 rests-on-item-03 way1)
    ; what that costs, by where the one is from, and what the other bears
    (fee way1 from-perch n0 cost12) (fee way1 from-spot n0 cost12)
    (fee way2 from-perch n0 cost39) (fee way2 from-perch n1 cost117) (fee way2 from-spot n0 cost12) (fee way2 from-spot n1 cost64)
    (fee way3 from-perch n0 cost39) (fee way3 from-perch n1 cost124) (fee way3 from-spot n0 cost12) (fee way3 from-spot n1 cost61)
    (fee way4 from-perch n0 cost121) (fee way4 from-perch n1 cost121) (fee way4 from-spot n0 cost121) (fee way4 from-spot n1 cost121)
    (fee way5 from-perch n0 cost121) (fee way5 from-spot n0 cost121)
    (fee way6 from-perch n0 cost177) (fee way6 from-spot n0 cost121) (fee way6 from-spot n1 cost121)
    (fee way7 from-spot n0 cost12) (fee way7 from-spot n1 cost39)
    (fee way8 from-spot n0 cost12) (fee way8 from-spot n1 cost59)
    (fee way9 from-spot n0 cost70) (fee way9 from-spot n1 cost98)
    (= (total-cost) 0) (= (cost cost4) 4) (= (cost cost12) 12) (= (cost cost39) 39) (= (cost cost59) 59) (= (cost cost61) 61) (= (cost cost64) 64) (= (cost cost70) 70) (= (cost cost98) 98) (= (cost cost117) 117) (= (cost cost120) 120) (= (cost cost121) 121) (= (cost cost124) 124) (= (cost cost177) 177)
  )
  (:goal (and (stands item-01 rests-on-item-02) (stands item-04 rests-on-item-03)))
  (:metric minimize (total-cost)))
