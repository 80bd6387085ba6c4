; Learned domain toy-relations. Printed by neurosym; do not edit.
; Subtypes of thing are the categories of objects that a network learned from trying actions; they limit no
; action. Bits in names are learned symbols; a letter behind them tells parameters for one symbol apart.
; What goes as promised with chance p costs 1 + round(-100 ln p); the other actions are free.
; Things stand at spots. What can be carried is taken from one, and put at another that is free. Where it
; would overlap spots of the start there, note-clear goes through them until nowhere is left.
; Things also bear each other. A perch ?q is room for things on or in a thing ?b, one for each relation:
; rests-on-001, lies-in-010. A way ?w puts something there, at a price by where it is from, and by how many
; things ?b bears. Goals by relation are (stands ?o ?q), others (done ?o).
; A valid plan asks a full hand for nothing but to put down, and carries only to places that are free.
; Learned action symbols: what the surest motion of each does to a category, how far in mm, how often.
;   symbol  cube  block  tray
; Symbols of carrying: how often each brings these categories, column by column, to places.
;   01  95%  95%  95%
; Symbols of putting on or in others: for how many learned kinds of pairs, and how often.
;   01  lies-in-010 1, 95%, rests-on-001 1, 91%
(define (domain toy-relations)
  (:requirements :strips :typing :action-costs)
  (:types
    thing price place origin count way - object
    spot perch - place
    block cube tray - thing)
  (:constants nowhere - spot from-spot from-perch - origin n0 - count)
  (:predicates
    (hand-empty) ; the hand holds nothing
    (ready) ; no motion is under way
    (done ?o - thing) ; ?o was noted at its goal, and not moved since
    (stands ?o - thing ?at - place) ; ?o stands there, or was not noted to have left
    (free ?p - spot) ; nothing stands there
    (can-take ?o - thing) ; ?o can be put somewhere, once it is taken
    (taken ?o - thing ?from - origin) ; the hand has ?o, from a spot or from a perch
    (can-carry ?o - thing ?from - origin ?c - price) ; ?o can be put at spots, at that price
    (check ?o - thing ?p ?here - spot) ; for ?o to be put at ?p, ?here must be free
    (then ?o - thing ?p ?here ?next - spot) ; and after that ?next, if it is not nowhere
    (goal-place ?o - thing ?p - spot) ; at that spot ?o meets its goal
    (on ?q - perch ?b - thing) ; ?q is a perch of ?b; this never changes
    (bears ?o - thing ?n - count) ; so many things rest directly on or in ?o
    (next ?n ?more - count) ; ?more is one more than ?n
    (can-put ?o - thing ?q - perch ?w - way) ; ?w puts ?o there
    (can-put-loaded ?o - thing ?q - perch ?w - way) ; and its load with it
    (fee ?w - way ?from - origin ?n - count ?c - price) ; what ?w costs from there, onto what bears so many
  )
  (:functions (total-cost) - number (cost ?c - price) - number)
  (:action take ; take ?o from a spot
    :parameters (?o - thing ?p - spot)
    :precondition (and (ready) (hand-empty) (can-take ?o) (stands ?o ?p))
    :effect (and (not (hand-empty)) (not (stands ?o ?p)) (not (done ?o)) (taken ?o from-spot) (free ?p)))
  (:action put-at ; put ?o, which was taken, at a spot
    :parameters (?o - thing ?p - spot ?from - origin ?c - price)
    :precondition (and (taken ?o ?from) (bears ?o n0) (can-carry ?o ?from ?c) (free ?p) (check ?o ?p nowhere))
    :effect (and (not (taken ?o ?from)) (not (free ?p)) (hand-empty) (stands ?o ?p) (increase (total-cost) (cost ?c))))
  (:action note-clear ; note that ?here, which ?o at ?p would overlap, is free
    :parameters (?o - thing ?p ?here ?next - spot)
    :precondition (and (check ?o ?p ?here) (free ?here) (then ?o ?p ?here ?next))
    :effect (and (check ?o ?p ?next)))
  (:action reach-place ; note that ?o stands where its goal is
    :parameters (?o - thing ?p - spot)
    :precondition (and (stands ?o ?p) (goal-place ?o ?p))
    :effect (and (done ?o)))
  (:action take-off ; take ?o from a thing that bears it
    :parameters (?o - thing ?q - perch ?b - thing ?less ?n - count)
    :precondition (and (ready) (hand-empty) (can-take ?o) (stands ?o ?q) (on ?q ?b) (bears ?b ?n) (next ?less ?n))
    :effect (and (not (hand-empty)) (not (stands ?o ?q)) (not (bears ?b ?n)) (not (done ?o)) (taken ?o from-perch) (bears ?b ?less)))
  (:action put ; put ?o, which was taken, on or into another thing
    :parameters (?o - thing ?q - perch ?b - thing ?from - origin ?n ?more - count ?w - way ?c - price)
    :precondition (and (taken ?o ?from) (bears ?o n0) (can-put ?o ?q ?w) (on ?q ?b) (bears ?b ?n) (next ?n ?more) (fee ?w ?from ?n ?c))
    :effect (and (not (taken ?o ?from)) (not (bears ?b ?n)) (hand-empty) (stands ?o ?q) (bears ?b ?more) (increase (total-cost) (cost ?c))))
  (:action put-loaded ; the same with what rests on it, if ?b stands at a spot
    :parameters (?o - thing ?q - perch ?b - thing ?from - origin ?p - spot ?less ?load ?n ?more - count ?w - way ?c - price)
    :precondition (and (taken ?o ?from) (bears ?o ?load) (next ?less ?load) (stands ?b ?p) (can-put-loaded ?o ?q ?w) (on ?q ?b) (bears ?b ?n) (next ?n ?more) (fee ?w ?from ?n ?c))
    :effect (and (not (taken ?o ?from)) (not (bears ?b ?n)) (hand-empty) (stands ?o ?q) (bears ?b ?more) (increase (total-cost) (cost ?c)))))
