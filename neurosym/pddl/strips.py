"""The page: one lifted domain for all that was learned, as positive STRIPS with types and costs.

What can be done stands in the domain, once. Which motion does what to which object, how far, between which
pairs and how surely, are facts of a problem. Prices are objects: `(= (cost cost12) 12)`.

An object that can be carried stands at places, and is taken from one and put at another. One that can only
be pushed is led over cells: the action of its motion says how far, and `move-x` and `move-y` lead it there.
Where relations were learned, objects are also put on and into one another; STRIPS cannot say that nothing
rests on an object, so it counts what does.
"""

import textwrap
from collections.abc import Iterable, Sequence
from functools import lru_cache
from itertools import groupby
from typing import NamedTuple

from neurosym.grounding import Grounding, is_lift
from neurosym.operators import Operator
from neurosym.pddl.movement import Along, movement_actions, movement_predicates
from neurosym.pddl.syntax import OBJECT, Domain, Typed, actions_in, predicates_in
from neurosym.tasks.options import puts_of

WIDTH = 108
"""So many columns lines of comments have behind their semicolon, at most."""
NOWHERE, FROM_SPOT, FROM_PERCH = "nowhere", "from-spot", "from-perch"
_KINDS = (
    "thing ?o ?b, spot ?p ?here ?next, count ?n ?more ?load ?less, price ?c, motion ?m ?up, zone ?z, "
    "place ?at, perch ?q, origin ?from, way ?w"
)
ALONG = tuple(Along(axis, f"?{axis}", f"?to-{axis}", f"?d{axis}", f"{axis}-shift") for axis in ("x", "y"))
"""What is not carried is led along x and y."""
TYPES = {variable: kind for kind, *every in map(str.split, _KINDS.split(", ")) for variable in every}
TYPES |= {variable: kind for axis in ALONG for variable, kind in axis.types.items()}
"""Every variable has the same type wherever it stands."""
WORDS = (
    "object thing place spot perch price motion zone origin count way x-cell y-cell x-shift y-shift nowhere "
    "n0 from-spot from-perch push lift put-down move-x move-y take take-off put-at put put-loaded note-clear "
    "leave set-upright reach-cell reach-lifted reach-place"
)
"""What every page may call its types, constants and actions."""
_ROW = "  "
"""What rows of a table begin with."""


_HAND_IS_FREE = "(ready) (hand-empty)"
"""What every action needs first that begins something with a thing."""


class _Part(NamedTuple):
    """A part of the page, there if what it is about was learned; its texts are as `actions_in` reads them."""

    about: str  # what readers must know of it, as one paragraph
    types: tuple[str, ...]  # beside things and places
    predicates: str
    actions: str = ""
    constants: tuple[Typed, ...] = ()
    places: tuple[str, ...] = ()  # types of places


@lru_cache(maxsize=8)
def page(grounding: Grounding) -> Domain:
    """Return the page of a learned domain."""
    parts = [_COMMON, *([_LEADING] if grounding.live else [])]
    if puts_of(grounding):
        parts += [_carrying(grounding, "?from"), _relating(grounding)]
    elif grounding.live_on("place"):
        parts += [_carrying(grounding)]
    if grounding.upright:  # what lies on a side waits until it is set upright
        begun = f"needs {_HAND_IS_FREE}"
        parts = [
            part._replace(actions=part.actions.replace(begun, f"{begun} (settled ?o)")) for part in parts
        ]
        parts.append(_RAISING)
    categories = sorted(category.name for category in grounding.objects.categories)
    promise = "A valid plan asks a full hand for nothing but to put down"
    promise += ", and carries only to places that are free." if parts[2:] or not grounding.live else "."
    if grounding.live:
        promise += " What moves by cells may collide on its way and at its end: `neurosym validate` replays "
        promise += "plans and finds that."
    return Domain(
        name=grounding.name,
        head=(
            *common_head(grounding),
            *_wrapped(*(part.about for part in parts), promise),
            *symbol_table(grounding),
        ),
        types=(
            *((kind, OBJECT) for kind in ("thing", *(kind for part in parts for kind in part.types))),
            *((kind, "place") for part in parts for kind in part.places),
            *((name, "thing") for name in categories),
        ),
        constants=tuple(one for part in parts for one in part.constants),
        predicates=tuple(one for part in parts for one in predicates_in(part.predicates, TYPES)),
        costs=predicates_in("(cost ?c)", TYPES),
        actions=tuple(one for part in parts for one in actions_in(part.actions, TYPES)),
    )


def common_head(grounding: Grounding) -> tuple[str, ...]:
    """Return what every printed domain begins with."""
    cost = (
        "Every motion costs 1; the other actions are free."
        if grounding.unit_costs
        else "What goes as promised with chance p costs 1 + round(-100 ln p); the other actions are free."
    )
    data = "Pushes and lifts were not rehearsed: what they do are averages over rows of the data."
    return _wrapped(
        f"Learned domain {grounding.name}. Printed by neurosym; do not edit.",
        "Subtypes of thing are the categories of objects that a network learned from trying actions; they "
        "limit no action. Bits in names are learned symbols; a letter behind them tells parameters for one "
        "symbol apart.",
        cost,
        data * (grounding.objects.measured == "data"),
    )


def _wrapped(*paragraphs: str) -> tuple[str, ...]:
    """Break paragraphs into lines of comments; empty ones are left out."""
    return tuple(line for text in paragraphs for line in textwrap.wrap(text, WIDTH, break_on_hyphens=False))


_COMMON = _Part(
    about="",
    types=("price",),
    predicates="""
        (hand-empty) ; the hand holds nothing
        (ready) ; no motion is under way
        (done ?o) ; ?o was noted at its goal, and not moved since
    """,
)
_LEADING = _Part(
    about="What is not carried is moved cell by cell: push, lift or put-down starts a motion ?m, named "
    "by its symbol, which shifts ?o by ?dx and ?dy cells; move-x and then move-y carry it out.",
    types=("motion", "zone", "x-cell", "y-cell", "x-shift", "y-shift"),
    predicates=f"""
        (by-cells ?o) ; ?o is moved cell by cell, until it is taken
        (at-x ?o ?x) ; the centre of ?o is in that column of cells
        (at-y ?o ?y) ; and in that row
        (pushes ?o ?m ?dx ?dy ?c) ; ?m pushes ?o by ?dx and ?dy
        (lifts ?o ?m ?dx ?dy ?c) ; ?m lifts ?o, and shifts it so
        (lowers ?o ?m ?dx ?dy) ; putting down what ?m lifted shifts it so far
        (on-table ?o) ; ?o, moved by cells, is not lifted
        (lifted ?o ?m) ; ?m lifted ?o, and the hand holds it
        {movement_predicates(ALONG)}
        (goal-cell ?o ?x ?y ?z) ; the cell is in zone ?z around the goal of ?o
        (goal-on-table ?o ?z) ; over zone ?z, ?o meets its goal on the table
        (goal-lifted ?o ?m ?z) ; over zone ?z, ?o meets its goal as high as ?m lifts it
    """,
    actions=f"""
        (push ?o ?m ?dx ?dy ?c) ; begin to push ?o
            needs {_HAND_IS_FREE} (by-cells ?o) (pushes ?o ?m ?dx ?dy ?c)
            adds (due-x ?o ?dx) (due-y ?o ?dy)
            deletes (ready) (done ?o)
            costs (cost ?c)
        (lift ?o ?m ?dx ?dy ?c) ; begin to lift ?o, which stays over cells; put-down sets it down
            needs {_HAND_IS_FREE} (by-cells ?o) (on-table ?o) (lifts ?o ?m ?dx ?dy ?c)
            adds (due-x ?o ?dx) (due-y ?o ?dy) (lifted ?o ?m)
            deletes (ready) (hand-empty) (on-table ?o) (done ?o)
            costs (cost ?c)
        (put-down ?o ?m ?dx ?dy) ; begin to put down what ?m lifted
            needs (ready) (lifted ?o ?m) (lowers ?o ?m ?dx ?dy)
            adds (due-x ?o ?dx) (due-y ?o ?dy) (hand-empty) (on-table ?o)
            deletes (ready) (lifted ?o ?m) (done ?o)
        {movement_actions(ALONG)}
        (reach-cell ?o ?x ?y ?z) ; note that ?o lies where its goal is
            needs (ready) (on-table ?o) (goal-on-table ?o ?z) (at-x ?o ?x) (at-y ?o ?y)
                (goal-cell ?o ?x ?y ?z)
            adds (done ?o)
        (reach-lifted ?o ?m ?x ?y ?z) ; note that ?o is held where its goal is
            needs (ready) (lifted ?o ?m) (goal-lifted ?o ?m ?z) (at-x ?o ?x) (at-y ?o ?y)
                (goal-cell ?o ?x ?y ?z)
            adds (done ?o)
    """,
)


_RAISING = _Part(
    about="What lies on a side, and shall stand, is set upright before it is taken or moved.",
    types=(),
    predicates="""
        (settled ?o) ; ?o lies as it shall, or was set upright
        (rights ?o ?c) ; ?o can be set upright, at that price
    """,
    actions=f"""
        (set-upright ?o ?c) ; set ?o upright
            needs {_HAND_IS_FREE} (rights ?o ?c)
            adds (settled ?o)
            deletes (rights ?o ?c)
            costs (cost ?c)
    """,
)


def _carrying(grounding: Grounding, origin: str = "") -> _Part:
    """Return what carries objects to places; a variable says from where, if it can be from another object."""
    has_origins = bool(origin)
    leave = """
        (leave ?o ?p) ; note that ?o, moved by cells to its goal, has left its spot
            needs (ready) (done ?o) (by-cells ?o) (stands ?o ?p)
            adds (free ?p)
            deletes (stands ?o ?p)
    """
    return _Part(
        about="Things stand at spots. What can be carried is taken from one, and put at another that is "
        "free. Where it would overlap spots of the start there, note-clear goes through them until nowhere "
        "is left.",
        types=("place", *(["origin"] if origin else [])),
        places=("spot", *(["perch"] if origin else [])),
        constants=((NOWHERE, "spot"), *(((FROM_SPOT, "origin"), (FROM_PERCH, "origin")) if origin else ())),
        predicates=f"""
            (stands ?o ?at) ; ?o stands there, or was not noted to have left
            (free ?p) ; nothing stands there
            (can-take ?o) ; ?o can be put somewhere, once it is taken
            (taken ?o {origin}) ; the hand has ?o{", from a spot or from a perch" * has_origins}
            (can-carry ?o {origin} ?c) ; ?o can be put at spots, at that price
            (check ?o ?p ?here) ; for ?o to be put at ?p, ?here must be free
            (then ?o ?p ?here ?next) ; and after that ?next, if it is not nowhere
            (goal-place ?o ?p) ; at that spot ?o meets its goal
        """,
        actions=f"""
            (take ?o ?p) ; take ?o from a spot
                needs {_HAND_IS_FREE} (can-take ?o) (stands ?o ?p) {_unloaded(grounding)}
                adds (taken ?o {FROM_SPOT * has_origins}) (free ?p)
                deletes (hand-empty) (stands ?o ?p) {"(by-cells ?o)" * bool(grounding.live)} (done ?o)
            (put-at ?o ?p {origin} ?c) ; put ?o, which was taken, at a spot
                needs (taken ?o {origin}) {"(bears ?o n0)" * has_origins} (can-carry ?o {origin} ?c) (free ?p)
                    (check ?o ?p {NOWHERE})
                adds (hand-empty) (stands ?o ?p)
                deletes (taken ?o {origin}) (free ?p)
                costs (cost ?c)
            (note-clear ?o ?p ?here ?next) ; note that ?here, which ?o at ?p would overlap, is free
                needs (check ?o ?p ?here) (free ?here) (then ?o ?p ?here ?next)
                adds (check ?o ?p ?next)
            (reach-place ?o ?p) ; note that ?o stands where its goal is
                needs (stands ?o ?p) (goal-place ?o ?p)
                adds (done ?o)
            {leave * bool(grounding.live)}
        """,
    )


def _relating(grounding: Grounding) -> _Part:
    """Return what puts objects on and into one another."""
    put = "(bears ?b ?n) (next ?n ?more) (fee ?w ?from ?n ?c)"
    about = "the same with what rests on it, if ?b stands at a spot"
    put_loaded = f"""
        (put-loaded ?o ?q ?b ?from ?p ?less ?load ?n ?more ?w ?c) ; {about}
            needs (taken ?o ?from) (bears ?o ?load) (next ?less ?load) (stands ?b ?p)
                (can-put-loaded ?o ?q ?w) (on ?q ?b) {put}
            adds (hand-empty) (stands ?o ?q) (bears ?b ?more)
            deletes (taken ?o ?from) (bears ?b ?n)
            costs (cost ?c)
    """
    loads = _takes_loads(grounding)
    relations = ", ".join(state.name for state in grounding.bearing_states)
    return _Part(
        about="Things also bear each other. A perch ?q is room for things on or in a thing ?b, one for each "
        f"relation: {relations}. A way ?w puts something there, at a price by where it is from, and by how "
        "many things ?b bears. Goals by relation are (stands ?o ?q), others (done ?o).",
        types=("count", "way"),
        constants=(("n0", "count"),),
        predicates=f"""
            (on ?q ?b) ; ?q is a perch of ?b; this never changes
            (bears ?o ?n) ; so many things rest directly on or in ?o
            (next ?n ?more) ; ?more is one more than ?n
            (can-put ?o ?q ?w) ; ?w puts ?o there
            {"(can-put-loaded ?o ?q ?w) ; and its load with it" * loads}
            (fee ?w ?from ?n ?c) ; what ?w costs from there, onto what bears so many
        """,
        actions=f"""
            (take-off ?o ?q ?b ?less ?n) ; take ?o from a thing that bears it
                needs {_HAND_IS_FREE} (can-take ?o) (stands ?o ?q) (on ?q ?b) (bears ?b ?n)
                    (next ?less ?n) {_unloaded(grounding)}
                adds (taken ?o {FROM_PERCH}) (bears ?b ?less)
                deletes (hand-empty) (stands ?o ?q) (bears ?b ?n) (done ?o)
            (put ?o ?q ?b ?from ?n ?more ?w ?c) ; put ?o, which was taken, on or into another thing
                needs (taken ?o ?from) (bears ?o n0) (can-put ?o ?q ?w) (on ?q ?b) {put}
                adds (hand-empty) (stands ?o ?q) (bears ?b ?more)
                deletes (taken ?o ?from) (bears ?b ?n)
                costs (cost ?c)
            {put_loaded * loads}
        """,
    )


def _takes_loads(grounding: Grounding) -> bool:
    """Say whether something is put elsewhere with what rests on it."""
    return any(put.operator.takes("laden") for put in puts_of(grounding))


def _unloaded(grounding: Grounding) -> str:
    """Return what is asked of an object that is taken: nothing rests on it, unless that may go along."""
    return "(bears ?o n0)" if puts_of(grounding) and not _takes_loads(grounding) else ""


def symbol_table(grounding: Grounding, *, with_others: bool = True) -> tuple[str, ...]:
    """Print what each action symbol does, a line each; with others, carrying and putting are told, too.

    A symbol has several motions, with parameters of their own; it is told what the surest of them does.
    """
    categories = sorted(grounding.objects.categories, key=lambda one: one.symbol)
    names = {category.symbol: category.name for category in categories}
    lines = [
        "Learned action symbols: what the surest motion of each does to a category, how far in mm, "
        "how often.",
        *_table([["symbol", *names.values()], *_rows(grounding.live, names)]),
    ]
    if with_others and (carriers := _rows(grounding.live_on("place"), names)):
        lines += ["Symbols of carrying: how often each brings these categories, column by column, to places."]
        lines += _table(carriers)
    if with_others and (puts := puts_of(grounding)):
        lines += ["Symbols of putting on or in others: for how many learned kinds of pairs, and how often."]
        chances = dict[tuple[str, str], list[float]]()
        for put in puts:
            if put.operator.subject:
                chances.setdefault((put.operator.primitive, put.state.name), []).append(put.chance)
        least_most = {key: (f"{min(each):.0%}", f"{max(each):.0%}") for key, each in chances.items()}
        spans = {key: " to ".join(dict.fromkeys(shares)) for key, shares in least_most.items()}
        for symbol, row in groupby(sorted(chances), key=lambda one: one[0]):
            told = (f"{key[1]} {len(chances[key])}, {spans[key]}" for key in row)
            lines.append(f"{_ROW}{symbol}  {', '.join(told)}")
    return tuple(lines)


def _table(rows: Sequence[Sequence[str]]) -> list[str]:
    """Print rows with columns as wide as they need."""
    widths = [max(map(len, column)) for column in zip(*rows, strict=True)]
    padded = (zip(row, widths, strict=True) for row in rows)
    return [_ROW + "  ".join(cell.ljust(width) for cell, width in row).rstrip() for row in padded]


def _rows(operators: Sequence[Operator], names: Iterable[str]) -> list[list[str]]:
    """Return a row for each symbol, with what its surest motion does to each category."""
    surest = dict[tuple[str, str], Operator]()
    for one in sorted(operators, key=lambda one: (one.chance, one.name)):
        surest[one.primitive, one.subject] = one
    symbols = sorted({symbol for symbol, _ in surest})
    return [[symbol, *(_told(surest.get((symbol, name))) for name in names)] for symbol in symbols]


def _told(operator: Operator | None) -> str:
    """Say what an operator does to its category, how far in mm, and how surely."""
    if operator is None or operator.promise is None:
        return "-"
    verb, (x, y, z) = operator.name.split(f"-{operator.label}-")[0], operator.promise.outcome
    far = z if is_lift(operator) else (x * x + y * y) ** 0.5
    return f"{verb} {1000 * far:.0f} " * (not verb.startswith("carry")) + f"{operator.chance:.0%}"
