; Learned domain camera. Printed by neurosym; do not edit.
; Subtypes of thing are the categories of objects that a network learned from trying actions; they limit no
; action. Bits in names are learned symbols; a letter behind them tells parameters for one symbol apart.
; What goes as promised with chance p costs 1 + round(-100 ln p); the other actions are free.
; Positions are whole numbers of 0.1 mm: x and y from the table's lowest corner, z from where an
; object rests. A motion ?m adds its way along each axis, which is printed with 10000 added.
; Steps end 6 inside the edges of the table, since 10 steps may err by that.
; Learned action symbols: what the surest motion of each does to a category, how far in mm, how often.
;   symbol  kind-tall-narrow-00         kind-01                    kind-low-narrow-10         kind-wide-11
;   0000    push-forward 50 88%         push-forward 43 88%        push-forward-right 88 96%  push-forward-left 54 96%
;   0001    push-right 16 68%           push-forward-left 13 80%   lift 248 60%               push-forward-right 48 96%
;   0010    push-left 16 52%            stay 3 92%                 lift 200 96%               lift 236 92%
;   0011    push-left 49 56%            push-forward-left 15 96%   push-left 160 84%          pull-left 40 92%
;   0100    push-left 42 88%            push-left 37 92%           push-left 42 96%           push-left 70 96%
;   0101    pull 32 88%                 pull 69 96%                pull-left 13 68%           pull-right 39 96%
;   0110    lift 209 72%                pull 52 52%                lift 200 96%               lift 198 96%
;   0111    pull 87 92%                 pull 60 80%                pull 91 96%                pull-right 78 96%
;   1000    push-forward 82 80%         push-forward 72 72%        push-forward 101 96%       push-forward-right 72 84%
;   1001    place-forward-right 53 96%  push-forward 37 88%        push-forward-left 54 96%   push-right 112 96%
;   1010    lift 200 80%                pull-right 23 48%          lift 225 96%               lift 198 96%
;   1011    lift 199 64%                push-right 76 68%          lift 200 96%               lift 207 96%
;   1100    push-right 48 72%           pull-right 18 92%          push-right 135 92%         push-right 49 88%
;   1101    place-right 50 96%          push-forward-right 17 84%  pull-right 52 96%          lift 200 84%
;   1110    lift 220 92%                pull 48 68%                lift 228 96%               push-right 38 56%
;   1111    lift 200 96%                pull-right 66 64%          lift 199 96%               push-right 114 88%
(define (domain camera-numeric)
  (:requirements :strips :typing :numeric-fluents :action-costs)
  (:types
    thing motion - object
    kind-01 kind-low-narrow-10 kind-tall-narrow-00 kind-wide-11 - thing)
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
