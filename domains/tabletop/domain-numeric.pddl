; Learned domain tabletop. Printed by neurosym; do not edit.
; Subtypes of thing are the categories of objects that a network learned from trying actions; they limit no
; action. Bits in names are learned symbols; a letter behind them tells parameters for one symbol apart.
; What goes as promised with chance p costs 1 + round(-100 ln p); the other actions are free.
; Positions are whole numbers of 0.1 mm: x and y from the table's lowest corner, z from where an
; object rests. A motion ?m adds its way along each axis, which is printed with 10000 added.
; Steps end 6 inside the edges of the table, since 10 steps may err by that.
; Learned action symbols: what the surest motion of each does to a category, how far in mm, how often.
;   symbol  solid-00                   hollow-wide-01             any-tall-narrow-10         solid-low-narrow-11
;   0000    pull-right 48 82%          lift 230 97%               lift 230 88%               lift 251 97%
;   0001    push-forward-left 20 94%   lift 198 92%               push-forward 20 84%        lift 200 97%
;   0010    push-forward-right 31 97%  push-forward-right 51 97%  push-forward-right 34 81%  push-right 110 81%
;   0011    push-left 57 94%           push-left 73 97%           push-left 28 97%           push-left 43 97%
;   0100    pull 86 88%                push-right 61 46%          lift 200 97%               lift 201 97%
;   0101    pull-left 23 94%           lift 248 97%               lift 200 88%               lift 203 97%
;   0110    pull 24 97%                push-right 97 86%          pull-right 51 97%          pull 43 97%
;   0111    pull 61 97%                pull-left 83 97%           pull 84 91%                pull 107 94%
;   1000    push-right 22 97%          lift 216 97%               lift 200 97%               lift 200 97%
;   1001    push-forward-left 32 97%   lift 247 97%               lift 208 97%               lift 241 97%
;   1010    pull-right 15 97%          push-right 70 97%          place-forward 55 97%       place-forward-right 72 97%
;   1011    push-forward 68 79%        push-forward-left 42 97%   push-forward 82 94%        push-forward 94 94%
;   1100    push-right 38 71%          push-right 40 59%          lift 226 97%               lift 241 97%
;   1101    pull-left 50 74%           lift 198 97%               lift 200 75%               lift 200 97%
;   1110    push-left 15 82%           pull-right 38 97%          push-right 49 97%          push-right 53 97%
;   1111    pull-left 22 97%           push-left 39 97%           push-forward-left 24 91%   push-left 152 72%
(define (domain tabletop-numeric)
  (:requirements :strips :typing :numeric-fluents :action-costs)
  (:types
    thing motion - object
    any-tall-narrow-10 hollow-wide-01 solid-00 solid-low-narrow-11 - thing)
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
