"""The page: one lifted domain for all that was learned, as positive STRIPS with types and costs.

What can be done stands in the domain, once. Which motion does what to which object, how far, between which
pairs and how surely, are facts of a problem. Prices are objects: `(= (cost cost12) 12)`.

An object that can be carried stands at places, and is taken from one and put at another. One that can only
be pushed is led over cells: the action of its motion says how far, and `move-x` and `move-y` lead it there.
Where relations were learned, objects are also put on and into one another; STRIPS cannot say that nothing
rests on an object, so it counts what does.
"""

import re
import textwrap
from collections.abc import Iterable
from dataclasses import dataclass
from functools import lru_cache

from neurosym.grounding import Grounding
from neurosym.pddl.symbol_table import symbol_table
from neurosym.pddl.syntax import OBJECT, Action, Atom, Domain, Predicate, Typed
from neurosym.tasks.carriers import carriers_of
from neurosym.tasks.puts import bearing_states, puts_of

WIDTH = 108
"""So many columns lines of comments have behind their semicolon, at most."""
THING, PLACE, SPOT, PERCH, PRICE = "thing", "place", "spot", "perch", "price"
MOTION, ORIGIN, COUNT, WAY = "motion", "origin", "count", "way"
X_CELL, Y_CELL, X_SHIFT, Y_SHIFT = "x-cell", "y-cell", "x-shift", "y-shift"
NOWHERE, NONE = "nowhere", "n0"
FROM_SPOT, FROM_PERCH = "from-spot", "from-perch"
PUSH, LIFT, PUT_DOWN, MOVE_X, MOVE_Y = "push", "lift", "put-down", "move-x", "move-y"
REACH_CELL, REACH_LIFTED, REACH_PLACE = "reach-cell", "reach-lifted", "reach-place"
TAKE, TAKE_OFF, PUT_AT, PUT, PUT_LOADED = "take", "take-off", "put-at", "put", "put-loaded"
NOTE_CLEAR, LEAVE = "note-clear", "leave"
_TYPES = {
    **dict.fromkeys(("?o", "?b"), THING),
    **dict.fromkeys(("?p", "?here", "?next"), SPOT),
    **dict.fromkeys(("?n", "?more", "?load", "?less"), COUNT),
    **dict.fromkeys(("?x", "?to-x"), X_CELL),
    **dict.fromkeys(("?y", "?to-y"), Y_CELL),
    "?c": PRICE,
    "?m": MOTION,
    "?up": MOTION,
    "?dx": X_SHIFT,
    "?dy": Y_SHIFT,
    "?at": PLACE,
    "?q": PERCH,
    "?from": ORIGIN,
    "?w": WAY,
}
"""Every variable has the same type wherever it stands."""
WORDS = (
    *("object", THING, PLACE, SPOT, PERCH, PRICE, MOTION, ORIGIN, COUNT, WAY),
    *(X_CELL, Y_CELL, X_SHIFT, Y_SHIFT, NOWHERE, NONE, FROM_SPOT, FROM_PERCH),
    *(PUSH, LIFT, PUT_DOWN, MOVE_X, MOVE_Y, TAKE, TAKE_OFF, PUT_AT, PUT, PUT_LOADED),
    *(NOTE_CLEAR, LEAVE, REACH_CELL, REACH_LIFTED, REACH_PLACE),
)
"""What every page may call its types, constants and actions."""


@dataclass(frozen=True, slots=True)
class _Part:
    """A part of the page, which is there if what it is about was learned.

    Attributes:
        about: What readers must know of it, as one paragraph.
        types: Its types, beside things.
        constants: Its constants.
        predicates: Its predicates.
        actions: Its actions.
        places: Its types of places.
    """

    about: str
    types: tuple[str, ...]
    constants: tuple[Typed, ...] = ()
    predicates: tuple[Predicate, ...] = ()
    actions: tuple[Action, ...] = ()
    places: tuple[str, ...] = ()


@lru_cache(maxsize=8)
def page(grounding: Grounding) -> Domain:
    """Return the page of a learned domain.

    Args:
        grounding: The learned domain.
    """
    parts = [_common(), *([_leading()] if grounding.live else [])]
    if puts_of(grounding):
        parts += [_carrying(grounding, "?from"), _relating(grounding)]
    elif carriers_of(grounding):
        parts += [_carrying(grounding)]
    categories = sorted(category.name for category in grounding.operators.categories)
    kinds = [kind for part in parts for kind in part.types]
    return Domain(
        name=grounding.name,
        head=(
            *common_head(grounding),
            *wrapped(part.about for part in parts),
            *_guarantees(has_cells=bool(grounding.live), has_places=len(parts) > 2 or not grounding.live),
            *symbol_table(grounding),
        ),
        types=(
            *((kind, OBJECT) for kind in (THING, *kinds)),
            *((kind, PLACE) for part in parts for kind in part.places),
            *((name, THING) for name in categories),
        ),
        constants=tuple(one for part in parts for one in part.constants),
        predicates=tuple(one for part in parts for one in part.predicates),
        costs=(predicate("(cost ?c)", ""),),
        actions=tuple(one for part in parts for one in part.actions),
    )


def _common() -> _Part:
    return _Part(
        about="",
        types=(PRICE,),
        predicates=(
            predicate("(hand-empty)", "the hand holds nothing"),
            predicate("(ready)", "no motion is under way"),
            predicate("(done ?o)", "?o was noted at its goal, and not moved since"),
        ),
    )


def common_head(grounding: Grounding) -> tuple[str, ...]:
    """Return what every printed domain begins with.

    Args:
        grounding: The learned domain.
    """
    cost = (
        "Every motion costs 1; the other actions are free."
        if grounding.unit_costs
        else "What goes as promised with chance p costs 1 + round(-100 ln p); the other actions are free."
    )
    data = "Pushes and lifts were not rehearsed: what they do are averages over rows of the data."
    paragraphs = (
        f"Learned domain {grounding.name}. Printed by neurosym; do not edit.",
        "Subtypes of thing are the categories of objects that a network learned from trying actions; they "
        "limit no action. Bits in names are learned symbols; a letter behind them tells parameters for one "
        "symbol apart.",
        cost,
        data * (grounding.operators.measured == "data"),
    )
    return wrapped(paragraphs)


def wrapped(paragraphs: Iterable[str]) -> tuple[str, ...]:
    """Break paragraphs into lines of comments.

    Args:
        paragraphs: The paragraphs; empty ones are left out.
    """
    return tuple(line for text in paragraphs for line in textwrap.wrap(text, WIDTH, break_on_hyphens=False))


def _guarantees(*, has_cells: bool, has_places: bool) -> tuple[str, ...]:
    """Say what a valid plan guarantees, and what only its replay sees."""
    carried = ", and carries only to places that are free" * has_places
    collide = (
        " What moves by cells may collide on its way and at its end: `neurosym validate` replays plans and "
        "finds that."
    )
    valid = f"A valid plan asks a full hand for nothing but to put down{carried}."
    return wrapped([valid + collide * has_cells])


def _leading() -> _Part:
    due = "(due-x ?o ?dx) (due-y ?o ?dy)"
    here = "(at-x ?o ?x) (at-y ?o ?y) (goal-cell ?o ?x ?y)"
    return _Part(
        about="What is not carried is moved cell by cell: push, lift or put-down starts a motion ?m, named "
        "by its symbol, which shifts ?o by ?dx and ?dy cells; move-x and then move-y carry it out.",
        types=(MOTION, X_CELL, Y_CELL, X_SHIFT, Y_SHIFT),
        predicates=(
            predicate("(by-cells ?o)", "?o is moved cell by cell, until it is taken"),
            predicate("(at-x ?o ?x)", "the centre of ?o is in that column of cells"),
            predicate("(at-y ?o ?y)", "and in that row"),
            predicate("(pushes ?o ?m ?dx ?dy ?c)", "?m pushes ?o by ?dx and ?dy"),
            predicate("(lifts ?o ?m ?dx ?dy ?c)", "?m lifts ?o, and shifts it so"),
            predicate("(lowers ?o ?m ?dx ?dy)", "putting down what ?m lifted shifts it so far"),
            predicate("(on-table ?o)", "?o, moved by cells, is not lifted"),
            predicate("(lifted ?o ?m)", "?m lifted ?o, and the hand holds it"),
            predicate("(due-x ?o ?dx)", "?o is under way, and has to go so far along x"),
            predicate("(due-y ?o ?dy)", "and so far along y"),
            predicate("(went-x ?o)", "?o went along x already"),
            predicate("(x-sum ?dx ?x ?to-x)", "from ?x, ?dx leads to ?to-x"),
            predicate("(y-sum ?dy ?y ?to-y)", "from ?y, ?dy leads to ?to-y"),
            predicate("(goal-cell ?o ?x ?y)", "over that cell ?o meets its goal"),
            predicate("(goal-on-table ?o)", "the goal of ?o is on the table"),
            predicate("(goal-lifted ?o ?m)", "the goal of ?o is as high as ?m lifts it"),
        ),
        actions=(
            action(
                PUSH,
                "begin to push ?o",
                "?o ?m ?dx ?dy ?c",
                needs="(ready) (hand-empty) (by-cells ?o) (pushes ?o ?m ?dx ?dy ?c)",
                adds=due,
                deletes="(ready) (done ?o)",
                cost="(cost ?c)",
            ),
            action(
                LIFT,
                "begin to lift ?o, which stays over cells; put-down sets it down",
                "?o ?m ?dx ?dy ?c",
                needs="(ready) (hand-empty) (by-cells ?o) (on-table ?o) (lifts ?o ?m ?dx ?dy ?c)",
                adds=f"{due} (lifted ?o ?m)",
                deletes="(ready) (hand-empty) (on-table ?o) (done ?o)",
                cost="(cost ?c)",
            ),
            action(
                PUT_DOWN,
                "begin to put down what ?m lifted",
                "?o ?m ?dx ?dy",
                needs="(ready) (lifted ?o ?m) (lowers ?o ?m ?dx ?dy)",
                adds=f"{due} (hand-empty) (on-table ?o)",
                deletes="(ready) (lifted ?o ?m) (done ?o)",
            ),
            action(
                MOVE_X,
                "shift ?o along x",
                "?o ?dx ?x ?to-x",
                needs="(due-x ?o ?dx) (at-x ?o ?x) (x-sum ?dx ?x ?to-x)",
                adds="(went-x ?o) (at-x ?o ?to-x)",
                deletes="(due-x ?o ?dx) (at-x ?o ?x)",
            ),
            action(
                MOVE_Y,
                "and along y, which ends the motion",
                "?o ?dy ?y ?to-y",
                needs="(went-x ?o) (due-y ?o ?dy) (at-y ?o ?y) (y-sum ?dy ?y ?to-y)",
                adds="(ready) (at-y ?o ?to-y)",
                deletes="(went-x ?o) (due-y ?o ?dy) (at-y ?o ?y)",
            ),
            action(
                REACH_CELL,
                "note that ?o lies where its goal is",
                "?o ?x ?y",
                needs=f"(ready) (on-table ?o) (goal-on-table ?o) {here}",
                adds="(done ?o)",
            ),
            action(
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
    bare = "(bears ?o n0)" * bool(origin)
    leave = action(
        LEAVE,
        "note that ?o, moved by cells to its goal, has left its spot",
        "?o ?p",
        needs="(ready) (done ?o) (by-cells ?o) (stands ?o ?p)",
        adds="(free ?p)",
        deletes="(stands ?o ?p)",
    )
    return _Part(
        about="Things stand at spots. What can be carried is taken from one, and put at another that is "
        "free. Where it would overlap spots of the start there, note-clear goes through them until nowhere "
        "is left.",
        types=(PLACE, *([ORIGIN] if origin else [])),
        places=(SPOT, *([PERCH] if origin else [])),
        constants=(
            (NOWHERE, SPOT),
            *(((FROM_SPOT, ORIGIN), (FROM_PERCH, ORIGIN)) if origin else ()),
        ),
        predicates=(
            predicate("(stands ?o ?at)", "?o stands there, or was not noted to have left"),
            predicate("(free ?p)", "nothing stands there"),
            predicate("(can-take ?o)", "?o can be put somewhere, once it is taken"),
            predicate(
                f"(taken ?o {origin})", "the hand has ?o" + ", from a spot or from a perch" * bool(origin)
            ),
            predicate(f"(can-carry ?o {origin} ?c)", "?o can be put at spots, at that price"),
            predicate("(check ?o ?p ?here)", "for ?o to be put at ?p, ?here must be free"),
            predicate("(then ?o ?p ?here ?next)", "and after that ?next, if it is not nowhere"),
            predicate("(goal-place ?o ?p)", "at that spot ?o meets its goal"),
        ),
        actions=(
            action(
                TAKE,
                "take ?o from a spot",
                "?o ?p",
                needs=f"(ready) (hand-empty) (can-take ?o) (stands ?o ?p) {_unloaded(grounding)}",
                adds=f"(taken ?o {FROM_SPOT * bool(origin)}) (free ?p)",
                deletes=f"(hand-empty) (stands ?o ?p) {'(by-cells ?o)' * bool(grounding.live)} (done ?o)",
            ),
            action(
                PUT_AT,
                "put ?o, which was taken, at a spot",
                f"?o ?p {origin} ?c",
                needs=f"(taken ?o {origin}) {bare} (can-carry ?o {origin} ?c) (free ?p) "
                f"(check ?o ?p {NOWHERE})",
                adds="(hand-empty) (stands ?o ?p)",
                deletes=f"(taken ?o {origin}) (free ?p)",
                cost="(cost ?c)",
            ),
            action(
                NOTE_CLEAR,
                "note that ?here, which ?o at ?p would overlap, is free",
                "?o ?p ?here ?next",
                needs="(check ?o ?p ?here) (free ?here) (then ?o ?p ?here ?next)",
                adds="(check ?o ?p ?next)",
            ),
            action(
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
    put = "(bears ?b ?n) (next ?n ?more) (fee ?w ?from ?n ?c)"
    put_loaded = action(
        PUT_LOADED,
        "the same with what rests on it, if ?b stands at a spot",
        "?o ?q ?b ?from ?p ?less ?load ?n ?more ?w ?c",
        needs="(taken ?o ?from) (bears ?o ?load) (next ?less ?load) (stands ?b ?p) "
        f"(can-put-loaded ?o ?q ?w) (on ?q ?b) {put}",
        adds="(hand-empty) (stands ?o ?q) (bears ?b ?more)",
        deletes="(taken ?o ?from) (bears ?b ?n)",
        cost="(cost ?c)",
    )
    loads = _takes_loads(grounding)
    relations = ", ".join(state.name for state in bearing_states(grounding))
    return _Part(
        about="Things also bear each other. A perch ?q is room for things on or in a thing ?b, one for each "
        f"relation: {relations}. A way ?w puts something there, at a price by where it is from, and by how "
        "many things ?b bears. Goals by relation are (stands ?o ?q), others (done ?o).",
        types=(COUNT, WAY),
        constants=((NONE, COUNT),),
        predicates=(
            predicate("(on ?q ?b)", "?q is a perch of ?b; this never changes"),
            predicate("(bears ?o ?n)", "so many things rest directly on or in ?o"),
            predicate("(next ?n ?more)", "?more is one more than ?n"),
            predicate("(can-put ?o ?q ?w)", "?w puts ?o there"),
            *([predicate("(can-put-loaded ?o ?q ?w)", "and its load with it")] if loads else []),
            predicate("(fee ?w ?from ?n ?c)", "what ?w costs from there, onto what bears so many"),
        ),
        actions=(
            action(
                TAKE_OFF,
                "take ?o from a thing that bears it",
                "?o ?q ?b ?less ?n",
                needs="(ready) (hand-empty) (can-take ?o) (stands ?o ?q) (on ?q ?b) (bears ?b ?n) "
                f"(next ?less ?n) {_unloaded(grounding)}",
                adds=f"(taken ?o {FROM_PERCH}) (bears ?b ?less)",
                deletes="(hand-empty) (stands ?o ?q) (bears ?b ?n) (done ?o)",
            ),
            action(
                PUT,
                "put ?o, which was taken, on or into another thing",
                "?o ?q ?b ?from ?n ?more ?w ?c",
                needs=f"(taken ?o ?from) (bears ?o n0) (can-put ?o ?q ?w) (on ?q ?b) {put}",
                adds="(hand-empty) (stands ?o ?q) (bears ?b ?more)",
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
    return "(bears ?o n0)" if puts_of(grounding) and not _takes_loads(grounding) else ""


def action(
    name: str,
    about: str,
    parameters: str,
    *,
    needs: str,
    adds: str,
    deletes: str = "",
    cost: str = "",
    tests: tuple[str, ...] = (),
    changes: tuple[str, ...] = (),
) -> Action:
    """Return an action, given as PDDL prints it; see `Action`."""
    (price,) = _atoms(cost) or (None,)
    atoms = (_atoms(needs), _atoms(adds), _atoms(deletes))
    return Action(name, about, _typed(parameters), *atoms, price, tests, changes)


def predicate(text: str, about: str) -> Predicate:
    """Return a predicate, given as PDDL prints it."""
    ((name, *parameters),) = _atoms(text)
    return Predicate(name, _typed(" ".join(parameters)), about)


def _typed(names: str) -> tuple[Typed, ...]:
    return tuple((name, _TYPES[name]) for name in names.split())


def _atoms(text: str) -> tuple[Atom, ...]:
    return tuple(tuple(found.split()) for found in re.findall(r"\(([^()]*)\)", text))
