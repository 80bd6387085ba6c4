; Problem tower-2-01 of the learned domain towers.
; How it came about: tower, drawn with seed 2; draw 1.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem tower-2-01)
  (:domain towers)
  (:objects
    item-01 item-02 - hollow-wide-00
    start-item-01 start-item-02 park-01 park-02 - spot
    sits-in-item-01 rests-on-item-02 sits-in-item-02 - perch
    n1 n2 - count
    way1 way2 way3 - way
    cost4 cost12 cost37 cost121 - price)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 start-item-01) (bears item-01 n0) (can-take item-01)
    (stands item-02 start-item-02) (bears item-02 n0) (can-take item-02)
    ; park-01 lies at (0.7730, -0.1936) m
    (free park-01)
    (check item-01 park-01 nowhere)
    (check item-02 park-01 nowhere)
    ; park-02 lies at (0.8436, 0.1872) m
    (free park-02)
    (check item-01 park-02 nowhere)
    (check item-02 park-02 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 from-spot cost4) (can-carry item-01 from-perch cost4)
    (can-carry item-02 from-spot cost4) (can-carry item-02 from-perch cost4)
    ; counting
    (next n0 n1)
    (next n1 n2)
    ; on or in what
    (on sits-in-item-01 item-01)
    (on rests-on-item-02 item-02)
    (on sits-in-item-02 item-02)
    ; what puts one thing on or into another
    (can-put item-01 rests-on-item-02 way1) (can-put item-01 sits-in-item-02 way3)
    (can-put item-02 sits-in-item-01 way2)
    ; what that costs, by where the one is from, and what the other bears
    (fee way1 from-spot n0 cost12)
    (fee way2 from-spot n0 cost37) (fee way2 from-spot n1 cost37)
    (fee way3 from-spot n0 cost121) (fee way3 from-spot n1 cost121)
    (= (total-cost) 0) (= (cost cost4) 4) (= (cost cost12) 12) (= (cost cost37) 37) (= (cost cost121) 121)
  )
  (:goal (and (stands item-01 rests-on-item-02)))
  (:metric minimize (total-cost)))
