; Learned domain places. Printed by neurosym; do not edit.
; Subtypes of thing are the categories of objects that a network learned from trying actions; they limit no
; action. Bits in names are learned symbols; a letter behind them tells parameters for one symbol apart.
; What goes as promised with chance p costs 1 + round(-100 ln p); the other actions are free.
; What is not carried is moved cell by cell: push, lift or put-down starts a motion ?m, named by its symbol,
; which shifts ?o by ?dx and ?dy cells; move-x and then move-y carry it out.
; Things stand at spots. What can be carried is taken from one, and put at another that is free. Where it
; would overlap spots of the start there, note-clear goes through them until nowhere is left.
; What lies on a side, and shall stand, is set upright before it is taken or moved.
; A valid plan asks a full hand for nothing but to put down, and carries only to places that are free. What
; moves by cells may collide on its way and at its end: `neurosym validate` replays plans and finds that.
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
; Symbols of carrying: how often each brings these categories, column by column, to places.
;   001  97%  91%  -    75%
;   010  81%  91%  6%   69%
;   011  94%  97%  33%  97%
;   100  97%  97%  30%  97%
;   101  91%  97%  15%  84%
;   110  91%  97%  6%   72%
;   111  78%  97%  36%  97%
(define (domain places)
  (:requirements :strips :typing :action-costs)
  (:types
    thing price motion zone x-cell y-cell x-shift y-shift place - object
    spot - place
    any-tall-narrow-11 hollow-wide-00 solid-low-10 solid-low-narrow-01 - thing)
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
    (settled ?o - thing) ; ?o lies as it shall, or was set upright
    (rights ?o - thing ?c - price) ; ?o can be set upright, at that price
  )
  (:functions (total-cost) - number (cost ?c - price) - number)
  (:action push ; begin to push ?o
    :parameters (?o - thing ?m - motion ?dx - x-shift ?dy - y-shift ?c - price)
    :precondition (and (ready) (hand-empty) (settled ?o) (by-cells ?o) (pushes ?o ?m ?dx ?dy ?c))
    :effect (and (not (ready)) (not (done ?o)) (due-x ?o ?dx) (due-y ?o ?dy) (increase (total-cost) (cost ?c))))
  (:action lift ; begin to lift ?o, which stays over cells; put-down sets it down
    :parameters (?o - thing ?m - motion ?dx - x-shift ?dy - y-shift ?c - price)
    :precondition (and (ready) (hand-empty) (settled ?o) (by-cells ?o) (on-table ?o) (lifts ?o ?m ?dx ?dy ?c))
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
    :precondition (and (ready) (hand-empty) (settled ?o) (can-take ?o) (stands ?o ?p))
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
    :effect (and (not (stands ?o ?p)) (free ?p)))
  (:action set-upright ; set ?o upright
    :parameters (?o - thing ?c - price)
    :precondition (and (ready) (hand-empty) (rights ?o ?c))
    :effect (and (not (rights ?o ?c)) (settled ?o) (increase (total-cost) (cost ?c)))))
