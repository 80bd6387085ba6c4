; Learned domain camera. Printed by neurosym; do not edit.
; Subtypes of thing are the categories of objects that a network learned from trying actions; they limit no
; action. Bits in names are learned symbols; a letter behind them tells parameters for one symbol apart.
; What goes as promised with chance p costs 1 + round(-100 ln p); the other actions are free.
; What is not carried is moved cell by cell: push, lift or put-down starts a motion ?m, named by its symbol,
; which shifts ?o by ?dx and ?dy cells; move-x and then move-y carry it out.
; Things stand at spots. What can be carried is taken from one, and put at another that is free. Where it
; would overlap spots of the start there, note-clear goes through them until nowhere is left.
; A valid plan asks a full hand for nothing but to put down, and carries only to places that are free. What
; moves by cells may collide on its way and at its end: `neurosym validate` replays plans and finds that.
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
; Symbols of carrying: how often each brings these categories, column by column, to places.
;   000  94%  24%  94%  94%
;   001  82%  43%  94%  59%
;   010  65%  29%  47%  71%
;   011  53%  29%  59%  29%
;   100  59%  29%  94%  94%
;   101  59%  29%  94%  94%
;   110  82%  29%  94%  71%
;   111  82%  29%  94%  94%
(define (domain camera)
  (:requirements :strips :typing :action-costs)
  (:types
    thing price motion zone x-cell y-cell x-shift y-shift place - object
    spot - place
    kind-01 kind-low-narrow-10 kind-tall-narrow-00 kind-wide-11 - thing)
  (:constants nowhere - spot)
  (:predicates
    (hand-empty) ; the hand holds nothing
    (ready) ; no motion is under way
    (done ?o - thing) ; ?o was noted at its goal, and not moved since
    (by-cells ?o - thing) ; ?o is moved cell by cell, until it is taken
    (at-x ?o - thing ?x - x-cell) ; the centre of ?o is in that column of cells
    (at-y ?o - thing ?y - y-cell) ; and in that row
    (pushes ?o - thing ?m - motion ?dx - x-shift ?dy - y-shift ?c - price) ; ?m pushes ?o by ?dx and ?dy
    (lifts ?o - thing ?m - motion ?dx - x-shift ?dy - y-shift ?c - price) ; ?m lifts ?o, and shifts it so
    (lowers ?o - thing ?m - motion ?dx - x-shift ?dy - y-shift) ; putting down what ?m lifted shifts it so far
    (on-table ?o - thing) ; ?o, moved by cells, is not lifted
    (lifted ?o - thing ?m - motion) ; ?m lifted ?o, and the hand holds it
    (due-x ?o - thing ?dx - x-shift) ; ?o is under way, and has to go so far along x
    (due-y ?o - thing ?dy - y-shift) ; and so far along y
    (went-x ?o - thing) ; ?o went along x already
    (x-sum ?dx - x-shift ?x ?to-x - x-cell) ; from ?x, ?dx leads to ?to-x
    (y-sum ?dy - y-shift ?y ?to-y - y-cell) ; from ?y, ?dy leads to ?to-y
    (goal-cell ?o - thing ?x - x-cell ?y - y-cell ?z - zone) ; the cell is in zone ?z around the goal of ?o
    (goal-on-table ?o - thing ?z - zone) ; over zone ?z, ?o meets its goal on the table
    (goal-lifted ?o - thing ?m - motion ?z - zone) ; over zone ?z, ?o meets its goal as high as ?m lifts it
    (stands ?o - thing ?at - place) ; ?o stands there, or was not noted to have left
    (free ?p - spot) ; nothing stands there
    (can-take ?o - thing) ; ?o can be put somewhere, once it is taken
    (taken ?o - thing) ; the hand has ?o
    (can-carry ?o - thing ?c - price) ; ?o can be put at spots, at that price
    (check ?o - thing ?p ?here - spot) ; for ?o to be put at ?p, ?here must be free
    (then ?o - thing ?p ?here ?next - spot) ; and after that ?next, if it is not nowhere
    (goal-place ?o - thing ?p - spot) ; at that spot ?o meets its goal
  )
  (:functions (total-cost) - number (cost ?c - price) - number)
  (:action push ; begin to push ?o
    :parameters (?o - thing ?m - motion ?dx - x-shift ?dy - y-shift ?c - price)
    :precondition (and (ready) (hand-empty) (by-cells ?o) (pushes ?o ?m ?dx ?dy ?c))
    :effect (and (not (ready)) (not (done ?o)) (due-x ?o ?dx) (due-y ?o ?dy) (increase (total-cost) (cost ?c))))
  (:action lift ; begin to lift ?o, which stays over cells; put-down sets it down
    :parameters (?o - thing ?m - motion ?dx - x-shift ?dy - y-shift ?c - price)
    :precondition (and (ready) (hand-empty) (by-cells ?o) (on-table ?o) (lifts ?o ?m ?dx ?dy ?c))
    :effect (and (not (ready)) (not (hand-empty)) (not (on-table ?o)) (not (done ?o)) (due-x ?o ?dx) (due-y ?o ?dy) (lifted ?o ?m) (increase (total-cost) (cost ?c))))
  (:action put-down ; begin to put down what ?m lifted
    :parameters (?o - thing ?m - motion ?dx - x-shift ?dy - y-shift)
    :precondition (and (ready) (lifted ?o ?m) (lowers ?o ?m ?dx ?dy))
    :effect (and (not (ready)) (not (lifted ?o ?m)) (not (done ?o)) (due-x ?o ?dx) (due-y ?o ?dy) (hand-empty) (on-table ?o)))
  (:action move-x ; shift ?o along x
    :parameters (?o - thing ?dx - x-shift ?x ?to-x - x-cell)
    :precondition (and (due-x ?o ?dx) (at-x ?o ?x) (x-sum ?dx ?x ?to-x))
    :effect (and (not (due-x ?o ?dx)) (not (at-x ?o ?x)) (went-x ?o) (at-x ?o ?to-x)))
  (:action move-y ; and along y, which ends the motion
    :parameters (?o - thing ?dy - y-shift ?y ?to-y - y-cell)
    :precondition (and (went-x ?o) (due-y ?o ?dy) (at-y ?o ?y) (y-sum ?dy ?y ?to-y))
    :effect (and (not (went-x ?o)) (not (due-y ?o ?dy)) (not (at-y ?o ?y)) (ready) (at-y ?o ?to-y)))
  (:action reach-cell ; note that ?o lies where its goal is
    :parameters (?o - thing ?x - x-cell ?y - y-cell ?z - zone)
    :precondition (and (ready) (on-table ?o) (goal-on-table ?o ?z) (at-x ?o ?x) (at-y ?o ?y) (goal-cell ?o ?x ?y ?z))
    :effect (and (done ?o)))
  (:action reach-lifted ; note that ?o is held where its goal is
    :parameters (?o - thing ?m - motion ?x - x-cell ?y - y-cell ?z - zone)
    :precondition (and (ready) (lifted ?o ?m) (goal-lifted ?o ?m ?z) (at-x ?o ?x) (at-y ?o ?y) (goal-cell ?o ?x ?y ?z))
    :effect (and (done ?o)))
  (:action take ; take ?o from a spot
    :parameters (?o - thing ?p - spot)
    :precondition (and (ready) (hand-empty) (can-take ?o) (stands ?o ?p))
    :effect (and (not (hand-empty)) (not (stands ?o ?p)) (not (by-cells ?o)) (not (done ?o)) (taken ?o) (free ?p)))
  (:action put-at ; put ?o, which was taken, at a spot
    :parameters (?o - thing ?p - spot ?c - price)
    :precondition (and (taken ?o) (can-carry ?o ?c) (free ?p) (check ?o ?p nowhere))
    :effect (and (not (taken ?o)) (not (free ?p)) (hand-empty) (stands ?o ?p) (increase (total-cost) (cost ?c))))
  (:action note-clear ; note that ?here, which ?o at ?p would overlap, is free
    :parameters (?o - thing ?p ?here ?next - spot)
    :precondition (and (check ?o ?p ?here) (free ?here) (then ?o ?p ?here ?next))
    :effect (and (check ?o ?p ?next)))
  (:action reach-place ; note that ?o stands where its goal is
    :parameters (?o - thing ?p - spot)
    :precondition (and (stands ?o ?p) (goal-place ?o ?p))
    :effect (and (done ?o)))
  (:action leave ; note that ?o, moved by cells to its goal, has left its spot
    :parameters (?o - thing ?p - spot)
    :precondition (and (ready) (done ?o) (by-cells ?o) (stands ?o ?p))
    :effect (and (not (stands ?o ?p)) (free ?p))))
