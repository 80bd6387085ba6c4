"""The page: one lifted domain for all that was learned, as positive STRIPS with types and costs.

What can be done stands in the domain, once. Which motion does what to which object, how far, between which
pairs and how surely, are facts of a problem. Prices are objects: `(= (cost c12) 12)`.

An object that can be carried stands at places, and is taken from one and put at another. One that can only
be pushed is led over cells: the action of its motion says how far, and `move-x` and `move-y` lead it there.
Where relations were learned, objects are also put on and into one another; STRIPS cannot say that nothing
rests on an object, so it counts what does.
"""

import re
from dataclasses import dataclass

from neurosym.grounding import Grounding
from neurosym.pddl.symbol_table import symbol_table
from neurosym.pddl.syntax import OBJECT, Action, Atom, Domain, Predicate, Typed
from neurosym.tasks.carriers import carriers_of
from neurosym.tasks.puts import bearing_states, puts_of

THING, PLACE, PRICE = "thing", "place", "price"
MOTION, RELATION, ORIGIN, COUNT, WAY = "motion", "relation", "origin", "count", "way"
X_CELL, Y_CELL, X_STEP, Y_STEP = "x-cell", "y-cell", "x-step", "y-step"
NOWHERE, NONE, ONE = "nowhere", "none", "one"
FROM_PLACE, FROM_THING = "from-place", "from-thing"
PUSH, LIFT, PUT_DOWN, MOVE_X, MOVE_Y = "push", "lift", "put-down", "move-x", "move-y"
REACH_CELL, REACH_LIFTED, REACH_PLACE = "reach-cell", "reach-lifted", "reach-place"
TAKE, TAKE_OFF, PUT_AT, PUT, PUT_LOADED = "take", "take-off", "put-at", "put", "put-loaded"
LOOK, LEAVE = "look", "leave"
_TYPES = {
    **dict.fromkeys(("?o", "?b"), THING),
    **dict.fromkeys(("?p", "?here", "?next"), PLACE),
    **dict.fromkeys(("?n", "?more", "?load", "?less"), COUNT),
    **dict.fromkeys(("?x", "?to-x"), X_CELL),
    **dict.fromkeys(("?y", "?to-y"), Y_CELL),
    "?c": PRICE,
    "?m": MOTION,
    "?dx": X_STEP,
    "?dy": Y_STEP,
    "?s": RELATION,
    "?from": ORIGIN,
    "?w": WAY,
}
"""Every variable has the same type wherever it stands."""


@dataclass(frozen=True, slots=True)
class _Part:
    """A part of the page, which is there if what it is about was learned.

    Attributes:
        about: What readers must know of it.
        types: Its types, beside things.
        constants: Its constants.
        predicates: Its predicates.
        actions: Its actions.
    """

    about: tuple[str, ...]
    types: tuple[str, ...]
    constants: tuple[Typed, ...] = ()
    predicates: tuple[Predicate, ...] = ()
    actions: tuple[Action, ...] = ()


def page(grounding: Grounding) -> Domain:
    """Return the page of a learned domain.

    Args:
        grounding: The learned domain.
    """
    parts = [_common(grounding), *([_leading()] if grounding.live else [])]
    if puts_of(grounding):
        parts += [_carrying(grounding, "?from"), _relating(grounding)]
    elif carriers_of(grounding):
        parts += [_carrying(grounding)]
    categories = sorted(category.name for category in grounding.operators.categories)
    kinds = [kind for part in parts for kind in part.types]
    return Domain(
        name=grounding.name,
        head=(*(line for part in parts for line in part.about), *symbol_table(grounding)),
        types=(*((kind, OBJECT) for kind in (THING, *kinds)), *((name, THING) for name in categories)),
        constants=tuple(one for part in parts for one in part.constants),
        predicates=tuple(one for part in parts for one in part.predicates),
        functions=(_predicate("(cost ?c)", ""),),
        actions=tuple(one for part in parts for one in part.actions),
    )


def _common(grounding: Grounding) -> _Part:
    cost = (
        "Every step costs 1"
        if grounding.unit_costs
        else "A step that goes as promised with chance p costs 1 + round(-100 ln p)"
    )
    return _Part(
        about=(
            f"Learned domain {grounding.name}. Printed by neurosym; do not edit.",
            "Subtypes of thing are the categories of objects that a network learned from trying actions.",
            f"{cost}; ?c is its price.",
        ),
        types=(PRICE,),
        predicates=(
            _predicate("(hand-empty)", "the hand holds nothing"),
            _predicate("(ready)", "no step is under way"),
            _predicate("(done ?o)", "?o was seen at its goal, and not moved since"),
        ),
    )


def _leading() -> _Part:
    due = "(due-x ?o ?dx) (due-y ?o ?dy)"
    here = "(at-x ?o ?x) (at-y ?o ?y) (goal-cell ?o ?x ?y)"
    return _Part(
        about=(
            "What can only be pushed is led over cells. A motion ?m, named by its learned symbol, leads ?o",
            "by ?dx and ?dy cells: push or lift begin that, and move-x and move-y do it.",
        ),
        types=(MOTION, X_CELL, Y_CELL, X_STEP, Y_STEP),
        predicates=(
            _predicate("(led ?o)", "?o is led over cells, and not carried"),
            _predicate("(at-x ?o ?x)", "the centre of ?o is in that column of cells"),
            _predicate("(at-y ?o ?y)", "and in that row"),
            _predicate("(pushes ?o ?m ?dx ?dy ?c)", "?m pushes ?o so far"),
            _predicate("(lifts ?o ?m ?dx ?dy ?c)", "?m lifts ?o, so far aside"),
            _predicate("(lowers ?o ?m ?dx ?dy)", "to put down what ?m lifted leads it so far"),
            _predicate("(on-table ?o)", "?o is not lifted"),
            _predicate("(lifted ?o ?m)", "?m lifted ?o, and the hand holds it"),
            _predicate("(due-x ?o ?dx)", "?o is on its way, to go so far along x"),
            _predicate("(due-y ?o ?dy)", "and so far along y"),
            _predicate("(went-x ?o)", "?o went along x already"),
            _predicate("(x-sum ?dx ?x ?to-x)", "?dx leads from ?x to ?to-x"),
            _predicate("(y-sum ?dy ?y ?to-y)", "?dy leads from ?y to ?to-y"),
            _predicate("(goal-cell ?o ?x ?y)", "over that cell ?o meets its goal"),
            _predicate("(goal-on-table ?o)", "the goal of ?o is on the table"),
            _predicate("(goal-lifted ?o ?m)", "the goal of ?o is as high as ?m lifts it"),
        ),
        actions=(
            _action(
                PUSH,
                "begin to push ?o",
                "?o ?m ?dx ?dy ?c",
                needs="(ready) (hand-empty) (led ?o) (pushes ?o ?m ?dx ?dy ?c)",
                adds=due,
                deletes="(ready) (done ?o)",
                cost="(cost ?c)",
            ),
            _action(
                LIFT,
                "begin to lift ?o; with a full hand only put-down applies",
                "?o ?m ?dx ?dy ?c",
                needs="(ready) (hand-empty) (led ?o) (on-table ?o) (lifts ?o ?m ?dx ?dy ?c)",
                adds=f"{due} (lifted ?o ?m)",
                deletes="(ready) (hand-empty) (on-table ?o) (done ?o)",
                cost="(cost ?c)",
            ),
            _action(
                PUT_DOWN,
                "begin to put down what ?m lifted",
                "?o ?m ?dx ?dy",
                needs="(ready) (lifted ?o ?m) (lowers ?o ?m ?dx ?dy)",
                adds=f"{due} (hand-empty) (on-table ?o)",
                deletes="(ready) (lifted ?o ?m) (done ?o)",
            ),
            _action(
                MOVE_X,
                "lead ?o along x",
                "?o ?dx ?x ?to-x",
                needs="(due-x ?o ?dx) (at-x ?o ?x) (x-sum ?dx ?x ?to-x)",
                adds="(went-x ?o) (at-x ?o ?to-x)",
                deletes="(due-x ?o ?dx) (at-x ?o ?x)",
            ),
            _action(
                MOVE_Y,
                "and along y, which ends the step",
                "?o ?dy ?y ?to-y",
                needs="(went-x ?o) (due-y ?o ?dy) (at-y ?o ?y) (y-sum ?dy ?y ?to-y)",
                adds="(ready) (at-y ?o ?to-y)",
                deletes="(went-x ?o) (due-y ?o ?dy) (at-y ?o ?y)",
            ),
            _action(
                REACH_CELL,
                "note that ?o lies where its goal is",
                "?o ?x ?y",
                needs=f"(ready) (on-table ?o) (goal-on-table ?o) {here}",
                adds="(done ?o)",
            ),
            _action(
                REACH_LIFTED,
                "note that ?o is held where its goal is",
                "?o ?m ?x ?y",
                needs=f"(ready) (lifted ?o ?m) (goal-lifted ?o ?m) {here}",
                adds="(done ?o)",
            ),
        ),
    )


def _carrying(grounding: Grounding, origin: str = "") -> _Part:
    """Return what takes objects from places and puts them at others.

    Args:
        grounding: The learned domain.
        origin: The variable for where an object in the hand is from, where it can be from another object.
    """
    bare = "(bears ?o none)" * bool(origin)
    leave = _action(
        LEAVE,
        "note that ?o, led to its goal, has left where it stood",
        "?o ?p",
        needs="(ready) (done ?o) (led ?o) (stands ?o ?p)",
        adds="(free ?p)",
        deletes="(stands ?o ?p)",
    )
    return _Part(
        about=(
            "What can be carried stands at places. It is taken from one, and put at another that is free; of",
            "each thing that stood over that place at first, look must note that it has left.",
        ),
        types=(PLACE, *([ORIGIN] if origin else [])),
        constants=(
            (NOWHERE, PLACE),
            *(((FROM_PLACE, ORIGIN), (FROM_THING, ORIGIN)) if origin else ()),
        ),
        predicates=(
            _predicate("(stands ?o ?p)", "?o stands at that place"),
            _predicate("(free ?p)", "nothing stands there"),
            _predicate("(can-take ?o)", "once ?o is taken, something can be done with it"),
            _predicate(
                f"(taken ?o {origin})", "the hand has ?o" + ", from a place or from a thing" * bool(origin)
            ),
            _predicate(f"(can-carry ?o {origin} ?c)", "?o can be put at places, at that price"),
            _predicate("(room ?o ?p ?here)", "?o has room at ?p, but for what stands at ?here"),
            _predicate("(look-next ?o ?p ?here ?next)", "and then for what stands at ?next"),
            _predicate("(goal-place ?o ?p)", "at that place ?o meets its goal"),
        ),
        actions=(
            _action(
                TAKE,
                "take ?o from a place",
                "?o ?p",
                needs=f"(ready) (hand-empty) (can-take ?o) (stands ?o ?p) {_unloaded(grounding)}",
                adds=f"(taken ?o {FROM_PLACE * bool(origin)}) (free ?p)",
                deletes=f"(hand-empty) (stands ?o ?p) {'(led ?o)' * bool(grounding.live)} (done ?o)",
            ),
            _action(
                PUT_AT,
                "put ?o, which was taken, at a place",
                f"?o ?p {origin} ?c",
                needs=f"(taken ?o {origin}) {bare} (can-carry ?o {origin} ?c) (free ?p) "
                f"(room ?o ?p {NOWHERE})",
                adds="(hand-empty) (stands ?o ?p)",
                deletes=f"(taken ?o {origin}) (free ?p)",
                cost="(cost ?c)",
            ),
            _action(
                LOOK,
                "note that a place is free which ?p overlaps",
                "?o ?p ?here ?next",
                needs="(room ?o ?p ?here) (free ?here) (look-next ?o ?p ?here ?next)",
                adds="(room ?o ?p ?next)",
            ),
            _action(
                REACH_PLACE,
                "note that ?o stands where its goal is",
                "?o ?p",
                needs="(stands ?o ?p) (goal-place ?o ?p)",
                adds="(done ?o)",
            ),
            *([leave] if grounding.live else []),
        ),
    )


def _relating(grounding: Grounding) -> _Part:
    states = tuple((state.name, RELATION) for state in bearing_states(grounding))
    put = "(bears ?b ?n) (next ?n ?more) (way-price ?w ?from ?n ?c)"
    put_loaded = _action(
        PUT_LOADED,
        "the same with what rests on ?o",
        "?o ?s ?b ?from ?p ?less ?load ?n ?more ?w ?c",
        needs="(taken ?o ?from) (bears ?o ?load) (next ?less ?load) (stands ?b ?p) "
        f"(can-put-loaded ?o ?s ?b ?w) {put}",
        adds="(hand-empty) (related ?o ?s ?b) (bears ?b ?more)",
        deletes="(taken ?o ?from) (bears ?b ?n)",
        cost="(cost ?c)",
    )
    loads = _takes_loads(grounding)
    return _Part(
        about=(
            "Things also bear each other, in relations ?s that were learned from pairs. A way ?w to put one",
            "on or into another has its price by where it is from, and by how many that bears already.",
        ),
        types=(RELATION, COUNT, WAY),
        constants=(*states, (NONE, COUNT), (ONE, COUNT)),
        predicates=(
            _predicate("(related ?o ?s ?b)", "?b bears ?o, in that relation"),
            _predicate("(bears ?o ?n)", "so many things rest on or in ?o themselves"),
            _predicate("(next ?n ?more)", "?more is one more than ?n"),
            _predicate("(can-put ?o ?s ?b ?w)", "?w puts ?o so on or into ?b"),
            *([_predicate("(can-put-loaded ?o ?s ?b ?w)", "and what rests on ?o with it")] if loads else []),
            _predicate("(way-price ?w ?from ?n ?c)", "what ?w costs from there, onto what bears so many"),
        ),
        actions=(
            _action(
                TAKE_OFF,
                "take ?o from a thing that bears it",
                "?o ?s ?b ?less ?n",
                needs="(ready) (hand-empty) (can-take ?o) (related ?o ?s ?b) (bears ?b ?n) (next ?less ?n) "
                + _unloaded(grounding),
                adds=f"(taken ?o {FROM_THING}) (bears ?b ?less)",
                deletes="(hand-empty) (related ?o ?s ?b) (bears ?b ?n) (done ?o)",
            ),
            _action(
                PUT,
                "put ?o, which was taken, on or into another thing",
                "?o ?s ?b ?from ?n ?more ?w ?c",
                needs=f"(taken ?o ?from) (bears ?o none) (can-put ?o ?s ?b ?w) {put}",
                adds="(hand-empty) (related ?o ?s ?b) (bears ?b ?more)",
                deletes="(taken ?o ?from) (bears ?b ?n)",
                cost="(cost ?c)",
            ),
            *([put_loaded] if loads else []),
        ),
    )


def _takes_loads(grounding: Grounding) -> bool:
    """Say whether something is put elsewhere with what rests on it."""
    return any(put.takes_laden for put in puts_of(grounding))


def _unloaded(grounding: Grounding) -> str:
    """Return what is asked of an object that is taken: nothing rests on it, unless that may go along."""
    return "(bears ?o none)" if puts_of(grounding) and not _takes_loads(grounding) else ""


def _action(
    name: str, about: str, parameters: str, *, needs: str, adds: str, deletes: str = "", cost: str = ""
) -> Action:
    """Return an action, given as PDDL prints it."""
    (price,) = _atoms(cost) or (None,)
    return Action(name, about, _typed(parameters), _atoms(needs), _atoms(adds), _atoms(deletes), price)


def _predicate(text: str, about: str) -> Predicate:
    """Return a predicate, given as PDDL prints it."""
    ((name, *parameters),) = _atoms(text)
    return Predicate(name, _typed(" ".join(parameters)), about)


def _typed(names: str) -> tuple[Typed, ...]:
    return tuple((name, _TYPES[name]) for name in names.split())


def _atoms(text: str) -> tuple[Atom, ...]:
    return tuple(tuple(found.split()) for found in re.findall(r"\(([^()]*)\)", text))
