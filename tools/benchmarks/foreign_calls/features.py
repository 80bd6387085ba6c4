"""Small tasks that each try one thing of PDDL: which planners take it, and which refuse it.

All are changes of one task, in which a cup is moved from here to there. A planner that solves that one and
not another does not take what the other tries.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field

DOMAIN = """{before}(define (domain table)
  (:requirements :strips :typing{costs})
  (:types {types}){constants}
  (:predicates (at ?o - thing ?p - place) (free ?p - place){predicates}){functions}{actions}
  (:action move
    :parameters (?o - thing ?from ?to{parameters} - place{priced})
    :precondition (and (at ?o ?from) (free ?to){needs})
    :effect (and (at ?o ?to) (not (at ?o ?from)) (free ?from) (not (free ?to)){does})))
"""
PROBLEM = """{before}(define (problem p)
  (:domain table){objects}
  (:init {init}(at cup here) (free there))
  (:goal {goal}){metric})
"""
PLAIN = {
    "before": "",
    "costs": "",
    "types": "thing place - object",
    "constants": "",
    "predicates": "",
    "functions": "",
    "actions": "",
    "parameters": "",
    "priced": "",
    "needs": "",
    "does": "",
    "objects": "\n  (:objects cup - thing here there - place)",
    "init": "",
    "goal": "(and (at cup there))",
    "metric": "",
}
"""What stands in the parts of the task that is changed."""


@dataclass(frozen=True, slots=True)
class Feature:
    """A thing of PDDL that a planner may refuse.

    Attributes:
        parts: What stands in place of what `PLAIN` says.
        names: What is called otherwise.
    """

    parts: Mapping[str, str] = field(default_factory=dict)
    names: Mapping[str, str] = field(default_factory=dict)

    def task(self) -> tuple[str, str]:
        """Return the texts of a domain and of a problem that try it."""
        return self._named(DOMAIN), self._named(PROBLEM)

    def _named(self, text: str) -> str:
        text = text.format_map({**PLAIN, **self.parts})
        return re.sub(r"(?<![\w?:-])[\w-]+", lambda word: self.names.get(word[0], word[0]), text)


COSTS = {
    "costs": " :action-costs",
    "functions": "\n  (:functions (total-cost))",
    "does": " (increase (total-cost) 3)",
    "init": "(= (total-cost) 0) ",
    "metric": "\n  (:metric minimize (total-cost))",
}
"""What makes a move cost 3."""
PRICED = COSTS | {
    "types": "thing place price - object",
    "predicates": " (priced ?o - thing ?c - price)",
    "functions": "\n  (:functions (total-cost) (cost ?c - price))",
    "priced": " ?c - price",
    "needs": " (priced ?o ?c)",
    "does": " (increase (total-cost) (cost ?c))",
    "objects": "\n  (:objects cup - thing here there - place c15 - price)",
    "init": "(= (total-cost) 0) (= (cost c15) 15) (priced cup c15) ",
}
"""What makes it cost what a function says of an object that a static fact names."""
CONSTANTS = "\n  (:constants cup - thing here there - place)"
LEADS = {
    "predicates": " (leads ?a ?b ?c ?d ?e ?f - place)",
    "init": "(leads here there here there here there) ",
}


def _clear(condition: str) -> Feature:
    action = f"\n  (:action clear\n    :parameters (?p - place){condition}\n    :effect (free ?p))"
    return Feature({"actions": action})


def _raise(kind: str, types: str) -> Feature:
    action = (
        f"\n  (:action raise\n    :parameters (?m - {kind} ?o - thing ?p - place)\n"
        "    :precondition (and (can ?m) (at ?o ?p))\n    :effect (free ?p))"
    )
    return Feature({"types": types, "predicates": f" (can ?m - {kind})", "actions": action})


FEATURES: Mapping[str, Feature] = {
    "types": Feature(),
    "types without `- object`": Feature({"types": "thing place"}),
    "subtypes, before what they belong to": Feature(
        {"types": "solid-00 hollow-01 - thing thing place - object"}
        | {"objects": "\n  (:objects cup - solid-00 here there - place)"}
    ),
    "subtypes, after what they belong to": Feature(
        {"types": "thing place - object solid-00 hollow-01 - thing"}
        | {"objects": "\n  (:objects cup - solid-00 here there - place)"}
    ),
    "type without objects": Feature({"types": "thing place lift - object"}),
    "type without objects, told in `:objects`": Feature(
        {
            "types": "thing place lift - object",
            "objects": "\n  (:objects cup - thing here there - place - lift)",
        }
    ),
    "action whose type has no objects": _raise("lift", "thing place lift - object"),
    "action that no fact allows": _raise("place", "thing place - object"),
    "parameter of type `object`": Feature({"predicates": " (seen ?o - object)"}),
    "predicate that no problem uses": Feature({"predicates": " (held ?o - thing)"}),
    "predicate without arguments": Feature(
        {"predicates": " (hand-empty)", "needs": " (hand-empty)", "init": "(hand-empty) "}
    ),
    "predicate with 6 arguments": Feature(LEADS | {"needs": " (leads ?from ?to ?from ?to ?from ?to)"}),
    "action with 8 parameters": Feature(
        LEADS | {"parameters": " ?c ?d ?e ?f ?g", "needs": " (leads ?from ?to ?c ?d ?e ?f) (free ?g)"}
    ),
    "action without parameters": Feature(
        {"actions": "\n  (:action pass\n    :parameters ()\n    :effect (done))", "predicates": " (done)"}
        | {"goal": "(and (at cup there) (done))"}
    ),
    "fact that names an object twice": Feature(
        {"predicates": " (next ?p ?q - place)", "needs": " (next ?to ?to)", "init": "(next there there) "}
    ),
    "fact twice at the start": Feature({"init": "(free there) "}),
    "fact added and deleted": Feature({"does": " (free ?to)"}),
    "constants": Feature(
        {"constants": "\n  (:constants here - place)", "objects": "\n  (:objects cup - thing there - place)"}
    ),
    "constant in an action": Feature(
        {"constants": "\n  (:constants none - place)", "needs": " (free none)", "init": "(free none) "}
    ),
    "constants only, and `(:objects)`": Feature({"constants": CONSTANTS, "objects": "\n  (:objects)"}),
    "constants only, and no `:objects`": Feature({"constants": CONSTANTS, "objects": ""}),
    "goal without `and`": Feature({"goal": "(at cup there)"}),
    "condition `()`": _clear("\n    :precondition ()"),
    "condition `(and)`": _clear("\n    :precondition (and)"),
    "condition left out": _clear(""),
    "comments with parentheses and `≤`": Feature({"before": '; (a comment) of µ = 3 ≤ 4 "\n; (x\n'}),
    "objects `item-01`, `x056`, `dx-3`": Feature(names={"cup": "item-01", "here": "x056", "there": "dx-3"}),
    "object `x-minus-20-of-any-tall-narrow-10-b`": Feature(
        names={"here": "x-minus-20-of-any-tall-narrow-10-b"}
    ),
    "predicate `rests-on-011`": Feature(names={"free": "rests-on-011"}),
    "action `put-at-0000b`": Feature(names={"move": "put-at-0000b"}),
    "type `solid-00`": Feature(names={"thing": "solid-00"}),
    "names with `_`": Feature(names={"cup": "item_01", "here": "x_056", "free": "is_free", "move": "put_at"}),
    "predicate named as a type": Feature(names={"free": "place"}),
    "action named as a predicate": Feature(names={"move": "free"}),
    "object named as a type": Feature(names={"here": "place"}),
    "object named as a predicate": Feature(names={"here": "free"}),
    "objects named `start`, `end`, `all`, predicate `over`": Feature(
        names={"here": "start", "there": "end", "cup": "all", "free": "over"}
    ),
    "type named `count`, predicate `next`": Feature(names={"place": "count", "free": "next"}),
    "object with a name of 100 letters": Feature(names={"there": "t" * 100}),
    "action with a name of 100 letters": Feature(names={"move": "m" * 100}),
    "60 types": Feature(
        {
            "types": " ".join(f"kind-{number:02}" for number in range(60)) + " - thing thing place - object",
            "objects": "\n  (:objects cup - kind-07 here there - place)",
        }
    ),
    "60 predicates of one argument": Feature(
        {
            "predicates": "".join(f" (is-{number:02} ?o - thing)" for number in range(60)),
            "init": "".join(f"(is-{number:02} cup) " for number in range(60)),
            "needs": " (is-07 ?o)",
        }
    ),
    "action with 14 parameters": Feature(
        {
            "predicates": " (only ?p - place)",
            "parameters": "".join(f" ?p{number}" for number in range(11)),
            "needs": "".join(f" (only ?p{number})" for number in range(11)),
            "init": "(only here) ",
        }
    ),
    "costs: a number": Feature(COSTS),
    "costs: `(total-cost) - number`": Feature(
        COSTS | {"functions": "\n  (:functions (total-cost) - number)"}
    ),
    "costs: 0": Feature(COSTS | {"does": " (increase (total-cost) 0)"}),
    "costs: 123456": Feature(COSTS | {"does": " (increase (total-cost) 123456)"}),
    "costs: none in an action": Feature(COSTS | {"does": ""}),
    "costs: no `(= (total-cost) 0)`": Feature(COSTS | {"init": ""}),
    "costs: no metric": Feature(COSTS | {"metric": ""}),
    "costs: not in `:requirements`": Feature(COSTS | {"costs": ""}),
    "costs: of an object that a fact names": Feature(PRICED),
    "costs: the same, `- number`": Feature(
        PRICED | {"functions": "\n  (:functions (total-cost) - number (cost ?c - price) - number)"}
    ),
    "costs: the same, function named as its type": Feature(PRICED, {"price": "cost"}),
    "costs: the same, one object without a value": Feature(
        PRICED | {"objects": "\n  (:objects cup - thing here there - place c15 c16 - price)"}
    ),
    "costs: the same, type without objects": Feature(
        PRICED
        | {"priced": "", "needs": "", "does": " (increase (total-cost) 3)", "init": "(= (total-cost) 0) "}
        | {"objects": PLAIN["objects"]}
    ),
    "costs: 60 functions": Feature(
        COSTS
        | {
            "functions": "\n  (:functions (total-cost)"
            + "".join(f" (effort-{number:02} ?o - thing)" for number in range(60))
            + ")",
            "does": " (increase (total-cost) (effort-07 ?o))",
            "init": "(= (total-cost) 0) "
            + "".join(f"(= (effort-{number:02} cup) 7) " for number in range(60)),
        }
    ),
    "costs: of two objects": Feature(
        COSTS
        | {"functions": "\n  (:functions (total-cost) (effort ?o - thing ?p - place))"}
        | {"does": " (increase (total-cost) (effort ?o ?to))"}
        | {"init": "(= (total-cost) 0) (= (effort cup there) 7) (= (effort cup here) 7) "}
    ),
}
"""By what each is called; the first is what all others change."""
