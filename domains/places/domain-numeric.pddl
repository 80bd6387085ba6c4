; Learned domain places. Printed by neurosym; do not edit.
; Subtypes of thing are the categories of objects that a network learned from trying actions; they limit no
; action. Bits in names are learned symbols; a letter behind them tells parameters for one symbol apart.
; What goes as promised with chance p costs 1 + round(-100 ln p); the other actions are free.
; Positions are whole numbers of 0.1 mm: x and y from the table's lowest corner, z from where an
; object rests. A motion ?m adds its way along each axis, which is printed with 10000 added.
; Steps end 6 inside the edges of the table, since 10 steps may err by that.
; Learned action symbols: what the surest motion of each does to a category, how far in mm, how often.
;   symbol  hollow-wide-00             solid-low-narrow-01        solid-low-10               any-tall-narrow-11
;   0000    place-back-right 64 41%    lift 248 97%               pull 46 91%                lift 202 97%
;   0001    lift 244 97%               lift 199 97%               push-right 48 94%          lift 245 72%
;   0010    lift 198 53%               lift 232 97%               push-right 21 76%          lift 236 97%
;   0011    lift 243 97%               lift 240 97%               push-right 34 82%          lift 259 84%
;   0100    pull-right 43 97%          pull-right 78 97%          pull 69 85%                pull-right 61 97%
;   0101    push-forward-right 55 97%  push-right 129 75%         push-forward 35 88%        push-right 32 84%
;   0110    pull-left 35 97%           push-left 63 84%           pull 28 88%                pull 19 97%
;   0111    place-right 103 97%        pull-right 44 97%          push-forward-right 56 52%  place-forward-right 42 97%
;   1000    lift 241 97%               lift 200 97%               push-left 26 91%           push-left 17 50%
;   1001    lift 213 97%               lift 200 97%               push-forward-left 63 64%   lift 200 94%
;   1010    lift 198 97%               lift 199 97%               push-forward-left 30 88%   lift 200 97%
;   1011    push-forward 72 59%        push-forward 102 97%       push-forward 81 85%        push-forward 80 97%
;   1100    push-left 88 91%           pull 60 97%                push-forward-left 15 88%   push-forward-left 31 97%
;   1101    push-right 30 78%          push-left 37 97%           stay 6 91%                 push-left 14 78%
;   1110    push-forward 30 97%        push-left 119 88%          pull-left 38 94%           pull-left 49 72%
;   1111    push-forward-left 50 97%   push-forward-right 74 94%  push-forward-right 26 85%  push-forward 40 97%
(define (domain places-numeric)
  (:requirements :strips :typing :numeric-fluents :action-costs)
  (:types
    thing motion - object
    any-tall-narrow-11 hollow-wide-00 solid-low-10 solid-low-narrow-01 - thing)
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
