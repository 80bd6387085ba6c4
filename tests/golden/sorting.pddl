; Problem sorting of the learned domain toy-relations.
; How it came about: by hand.
; start-: where an object stands at first; goal-: meets a goal; park-: to wait at.
(define (problem sorting)
  (:domain toy-relations)
  (:objects
    item-01 item-02 - cube
    item-03 - block
    item-04 item-05 - tray
    start-item-03 start-item-04 start-item-05 park-01 park-02 park-03 park-04 park-05 - spot
    rests-on-item-01 rests-on-item-02 rests-on-item-03 lies-in-item-04 lies-in-item-05 - perch
    n1 n2 - count
    way1 way2 way3 way4 - way
    cost6 cost10 cost11 cost19 cost20 cost23 cost30 cost34 cost43 cost47 - price)
  (:init
    (hand-empty) (ready)
    ; where objects are at first
    (stands item-01 rests-on-item-02) (bears item-01 n0) (can-take item-01)
    (stands item-02 rests-on-item-03) (bears item-02 n1) (can-take item-02)
    (stands item-03 start-item-03) (bears item-03 n1) (can-take item-03)
    (stands item-04 start-item-04) (bears item-04 n0) (can-take item-04)
    (stands item-05 start-item-05) (bears item-05 n0) (can-take item-05)
    ; park-01 lies at (0.5256, -0.1837) m
    (free park-01)
    (check item-01 park-01 nowhere)
    (check item-02 park-01 nowhere)
    (check item-03 park-01 nowhere)
    (check item-04 park-01 nowhere)
    (check item-05 park-01 nowhere)
    ; park-02 lies at (0.5231, 0.1851) m
    (free park-02)
    (check item-01 park-02 nowhere)
    (check item-02 park-02 nowhere)
    (check item-03 park-02 nowhere)
    (check item-04 park-02 nowhere)
    (check item-05 park-02 nowhere)
    ; park-03 lies at (0.6039, -0.0371) m
    (free park-03)
    (check item-01 park-03 nowhere)
    (check item-02 park-03 nowhere)
    (check item-03 park-03 nowhere)
    ; park-04 lies at (0.8237, -0.0012) m
    (free park-04)
    (check item-01 park-04 nowhere)
    (check item-02 park-04 nowhere)
    (check item-03 park-04 nowhere)
    ; park-05 lies at (0.7309, -0.0074) m
    (free park-05)
    (check item-01 park-05 nowhere)
    (check item-02 park-05 nowhere)
    (check item-03 park-05 nowhere)
    ; what can be carried, from where, and its price
    (can-carry item-01 from-spot cost6) (can-carry item-01 from-perch cost20)
    (can-carry item-02 from-spot cost6) (can-carry item-02 from-perch cost20)
    (can-carry item-03 from-spot cost6) (can-carry item-03 from-perch cost20)
    (can-carry item-04 from-spot cost6) (can-carry item-04 from-perch cost20)
    (can-carry item-05 from-spot cost6) (can-carry item-05 from-perch cost20)
    ; counting
    (next n0 n1)
    (next n1 n2)
    ; on or in what
    (on rests-on-item-01 item-01)
    (on rests-on-item-02 item-02)
    (on rests-on-item-03 item-03)
    (on lies-in-item-04 item-04)
    (on lies-in-item-05 item-05)
    ; what puts one thing on or into another
    (can-put item-01 rests-on-item-02 way2) (can-put-loaded item-01 rests-on-item-02 way3) (can-put item-01 rests-on-item-03 way2) (can-put-loaded item-01 rests-on-item-03 way3) (can-put item-01 lies-in-item-04 way1) (can-put-loaded item-01 lies-in-item-04 way4) (can-put item-01 lies-in-item-05 way1) (can-put-loaded item-01 lies-in-item-05 way4)
    (can-put item-02 rests-on-item-01 way2) (can-put-loaded item-02 rests-on-item-01 way3) (can-put item-02 rests-on-item-03 way2) (can-put-loaded item-02 rests-on-item-03 way3) (can-put item-02 lies-in-item-04 way1) (can-put-loaded item-02 lies-in-item-04 way4) (can-put item-02 lies-in-item-05 way1) (can-put-loaded item-02 lies-in-item-05 way4)
    (can-put item-03 rests-on-item-01 way2) (can-put-loaded item-03 rests-on-item-01 way3) (can-put item-03 rests-on-item-02 way2) (can-put-loaded item-03 rests-on-item-02 way3) (can-put item-03 lies-in-item-04 way1) (can-put-loaded item-03 lies-in-item-04 way4) (can-put item-03 lies-in-item-05 way1) (can-put-loaded item-03 lies-in-item-05 way4)
    ; what that costs, by where the one is from, and what the other bears
    (fee way1 from-perch n0 cost10) (fee way1 from-perch n1 cost34) (fee way1 from-spot n0 cost6) (fee way1 from-spot n1 cost30)
    (fee way2 from-perch n0 cost11) (fee way2 from-spot n0 cost11)
    (fee way3 from-perch n0 cost19) (fee way3 from-spot n0 cost19)
    (fee way4 from-perch n0 cost23) (fee way4 from-perch n1 cost47) (fee way4 from-spot n0 cost19) (fee way4 from-spot n1 cost43)
    (= (total-cost) 0) (= (cost cost6) 6) (= (cost cost10) 10) (= (cost cost11) 11) (= (cost cost19) 19) (= (cost cost20) 20) (= (cost cost23) 23) (= (cost cost30) 30) (= (cost cost34) 34) (= (cost cost43) 43) (= (cost cost47) 47)
  )
  (:goal (and (stands item-01 lies-in-item-04) (stands item-02 lies-in-item-05)))
  (:metric minimize (total-cost)))
