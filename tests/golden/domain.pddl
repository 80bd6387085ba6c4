; Learned domain tabletop. Printed by neurosym; do not edit.
; Subtypes of thing are the categories of objects that a network learned from trying actions; they limit no
; action. Bits in names are learned symbols; a letter behind them tells parameters for one symbol apart.
; What goes as promised with chance p costs 1 + round(-100 ln p); the other actions are free.
; What is not carried is moved cell by cell: push, lift or put-down starts a motion ?m, named by its symbol,
; which shifts ?o by ?dx and ?dy cells; move-x and then move-y carry it out.
; A valid plan asks a full hand for nothing but to put down. What moves by cells may collide on its way and at
; its end: `neurosym validate` replays plans and finds that.
; Learned action symbols: what the surest motion of each does to a category, how far in mm, how often.
;   symbol  block             tray
;   000     push-left 83 86%  push-left 61 59%
;   001     push-away 72 86%  -
;   010     lift 203 73%      pull 71 86%
(define (domain tabletop)
  (:requirements :strips :typing :action-costs)
  (:types
    thing price motion zone x-cell y-cell x-shift y-shift - object
    block tray - thing)
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
    :effect (and (done ?o))))
