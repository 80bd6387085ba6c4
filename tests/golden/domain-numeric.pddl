; Learned domain tabletop. Printed by neurosym; do not edit.
; Subtypes of thing are the categories of objects that a network learned from trying actions; they limit no
; action. Bits in names are learned symbols; a letter behind them tells parameters for one symbol apart.
; What goes as promised with chance p costs 1 + round(-100 ln p); the other actions are free.
; Positions are whole numbers of 0.1 mm: x and y from the table's lowest corner, z from where an
; object rests. A motion ?m adds its way along each axis, which is printed with 10000 added.
; Steps end 6 inside the edges of the table, since 10 steps may err by that.
; Learned action symbols: what the surest motion of each does to a category, how far in mm, how often.
;   symbol  block             tray
;   000     push-left 83 86%  push-left 61 59%
;   001     push-away 72 86%  -
;   010     lift 203 73%      pull 71 86%
(define (domain tabletop-numeric)
  (:requirements :strips :typing :numeric-fluents :action-costs)
  (:types
    thing motion - object
    block tray - thing)
  (:predicates
    (hand-empty) ; the hand holds nothing
    (pushes ?o - thing ?m - motion) ; ?m pushes ?o
    (lifts ?o - thing ?m - motion) ; ?m lifts ?o
    (lowers ?m ?up - motion) ; ?m puts down what ?up lifted
    (lifted ?o - thing ?m - motion) ; ?m lifted ?o, and the hand holds it
  )
  (:functions (total-cost) - number (x ?o - thing) - number (y ?o - thing) - number (z ?o - thing) - number (along-x ?m - motion) - number (along-y ?m - motion) - number (along-z ?m - motion) - number (cost ?m - motion) - number)
  (:action push ; push ?o
    :parameters (?o - thing ?m - motion)
    :precondition (and (hand-empty) (pushes ?o ?m) (>= (+ (x ?o) (along-x ?m)) 10006) (<= (+ (x ?o) (along-x ?m)) 15994) (>= (+ (y ?o) (along-y ?m)) 10006) (<= (+ (y ?o) (along-y ?m)) 15994))
    :effect (and (assign (x ?o) (- (+ (x ?o) (along-x ?m)) 10000)) (assign (y ?o) (- (+ (y ?o) (along-y ?m)) 10000)) (assign (z ?o) (- (+ (z ?o) (along-z ?m)) 10000)) (increase (total-cost) (cost ?m))))
  (:action lift ; lift ?o; with a full hand only put-down applies
    :parameters (?o - thing ?m - motion)
    :precondition (and (hand-empty) (lifts ?o ?m) (>= (+ (x ?o) (along-x ?m)) 10006) (<= (+ (x ?o) (along-x ?m)) 15994) (>= (+ (y ?o) (along-y ?m)) 10006) (<= (+ (y ?o) (along-y ?m)) 15994))
    :effect (and (not (hand-empty)) (lifted ?o ?m) (assign (x ?o) (- (+ (x ?o) (along-x ?m)) 10000)) (assign (y ?o) (- (+ (y ?o) (along-y ?m)) 10000)) (assign (z ?o) (- (+ (z ?o) (along-z ?m)) 10000)) (increase (total-cost) (cost ?m))))
  (:action put-down ; put down what ?up lifted
    :parameters (?o - thing ?m ?up - motion)
    :precondition (and (lifted ?o ?up) (lowers ?m ?up) (>= (+ (x ?o) (along-x ?m)) 10006) (<= (+ (x ?o) (along-x ?m)) 15994) (>= (+ (y ?o) (along-y ?m)) 10006) (<= (+ (y ?o) (along-y ?m)) 15994))
    :effect (and (not (lifted ?o ?up)) (hand-empty) (assign (x ?o) (- (+ (x ?o) (along-x ?m)) 10000)) (assign (y ?o) (- (+ (y ?o) (along-y ?m)) 10000)) (assign (z ?o) (- (+ (z ?o) (along-z ?m)) 10000)))))
