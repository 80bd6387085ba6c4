"""The page in numbers: PDDL 2.1 with numeric fluents, for planners that take these.

Where an object is, is three whole numbers of 0.1 mm: x and y count from the table's lowest corner, so none is
negative, and z from where the object rests. A motion adds its displacement. So nothing has to be grounded
cell by cell, and hardly anything is rounded.

An object's goal is a prism inside the ball around it: an interval of z, as on a grid, and for x and y an
octagon in the disc that is left of the ball. All conditions are linear with whole coefficients. Each step
errs by at most half a unit on each axis, so the disc is shrunk by sqrt(1/2) units a step, and the table by
half a unit a step: plans of no more than `STEPS` steps an object are true.

PDDL of most readers has no negative numbers, so a displacement is printed with a shift, which the domain
takes off again. Positions are assigned, not increased, for LPG takes it that what is increased becomes more.
Every function of a motion has a value, for readers ask for it; so each object has motions of its own.
"""

import math
from collections.abc import Iterator, Sequence
from functools import lru_cache, reduce

import msgspec

from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.pddl.grid import AXES, levels, within
from neurosym.pddl.strips import TYPES, common_head, symbol_table
from neurosym.pddl.strips_problem import in_metres, motion_name
from neurosym.pddl.syntax import (
    NUMERIC,
    OBJECT,
    Atom,
    Domain,
    Facts,
    PddlProblem,
    Typed,
    actions_in,
    domain_name,
    predicates_in,
)
from neurosym.problems import SceneObject
from neurosym.tasks.options import Move
from neurosym.tasks.task import Task
from neurosym.tasks.transition import PlanStep

UNIT = 0.0001
"""What positions are counted in [m]."""
STEPS = 10
"""How many steps with an object the rounding of is reckoned with."""
_MARGIN = math.ceil((STEPS + 1) / 2)  # what so many steps and the start can err on an axis, in units
_NORMALS = ((1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1))
_WIDEST = math.pi / 8  # half the widest angle between neighbouring normals
_EPSILON = 1e-6
_LEAST_SHIFT = 10_000
_ALONG = ("along-x", "along-y", "along-z")
_OFFERS = {"push": "pushes", "lift": "lifts"}


def numeric_domain(grounding: Grounding) -> Domain:
    """Return the page in numbers; cells do not matter, but for which operators are in the domain."""
    shift, table = _shift_of(grounding), grounding.table
    sizes = [high - low for low, high in (table.x, table.y)]
    most = [math.floor(size / UNIT + _EPSILON) - _MARGIN + shift for size in sizes]
    ends = [f"(+ ({axis} ?o) ({along} ?m))" for axis, along in zip(AXES, _ALONG, strict=True)]
    stays = [f"(>= {end} {_MARGIN + shift}) (<= {end} {last})" for end, last in zip(ends, most, strict=False)]
    moved = [f"(assign ({axis} ?o) (- {end} {shift}))" for axis, end in zip(AXES, ends, strict=True)]
    moves = f"tests {' '.join(stays)}\n changes {' '.join(moved)}"
    categories = sorted(category.name for category in grounding.objects.categories)
    return Domain(
        name=domain_name(grounding, NUMERIC),
        head=(
            *common_head(grounding),
            "Positions are whole numbers of 0.1 mm: x and y from the table's lowest corner, z from where an",
            f"object rests. A motion ?m adds its way along each axis, which is printed with {shift} added.",
            f"Steps end {_MARGIN} inside the edges of the table, since {STEPS} steps may err by that.",
            *symbol_table(grounding, with_others=False),
        ),
        types=(("thing", OBJECT), ("motion", OBJECT), *((name, "thing") for name in categories)),
        constants=(),
        predicates=predicates_in(
            """
            (hand-empty) ; the hand holds nothing
            (pushes ?o ?m) ; ?m pushes ?o
            (lifts ?o ?m) ; ?m lifts ?o
            (lowers ?m ?up) ; ?m puts down what ?up lifted
            (lifted ?o ?m) ; ?m lifted ?o, and the hand holds it
        """,
            TYPES,
        ),
        costs=predicates_in("(cost ?m)", TYPES),
        actions=actions_in(
            f"""
            (push ?o ?m) ; push ?o
                needs (hand-empty) (pushes ?o ?m)
                costs (cost ?m)
                {moves}
            (lift ?o ?m) ; lift ?o; with a full hand only put-down applies
                needs (hand-empty) (lifts ?o ?m)
                adds (lifted ?o ?m)
                deletes (hand-empty)
                costs (cost ?m)
                {moves}
            (put-down ?o ?m ?up) ; put down what ?up lifted
                needs (lifted ?o ?up) (lowers ?m ?up)
                adds (hand-empty)
                deletes (lifted ?o ?up)
                {moves}
        """,
            TYPES,
        ),
        functions=predicates_in("(x ?o)\n(y ?o)\n(z ?o)\n(along-x ?m)\n(along-y ?m)\n(along-z ?m)", TYPES),
    )


def numeric_problem(task: Task, *, steps: int = STEPS) -> PddlProblem:
    """Return the problem of a task without relations in numbers.

    The rounding of so many steps with an object is taken off its goal region.
    """
    problem, grounding = task.problem, task.grounding
    if task.relates:
        raise InvalidValue(
            f"The problem {problem.name} is one of relations, which the encoding numeric lacks."
        )
    if task.lying:
        said = f"{problem.name} sets things upright, which the encoding numeric lacks."
        raise InvalidValue(f"The problem {said}")
    facts, values, costs = [Facts("", (("hand-empty",),))], dict[Atom, int](), dict[Atom, int]()
    shift, motions = _shift_of(grounding), list[Typed]()
    for item in problem.objects:
        atoms, where = list[Atom](), (*_anchor(item, grounding), 0)
        values |= {(axis, item.name): value for axis, value in zip(AXES, where, strict=True)}
        for (verb, thing, motion, *up), move in _offered(task, item.name).items():
            motions.append((motion, "motion"))
            atoms.append(("lowers", motion, *up) if up else (_OFFERS[verb], thing, motion))
            values |= {(along, motion): by + shift for along, by in zip(_ALONG, move.cells, strict=True)}
            costs[("cost", motion)] = move.cost
        facts.append(Facts(f"{item.name} lies at {in_metres(item.position)} m at first", tuple(atoms)))
    things = [(item.name, grounding.category(item.category).name) for item in problem.objects]
    return PddlProblem(
        name=problem.name,
        domain=domain_name(grounding, NUMERIC),
        head=(
            f"Problem {problem.name} of the learned domain {grounding.name}, in numbers.",
            f"How it came about: {' '.join(problem.provenance.split())}.",
            f"A goal is met within {1000 * problem.tolerance:g} mm; what is asked for lies inside that by as",
            f"much as {steps} step(s) with an object can err by rounding to 0.1 mm.",
        ),
        objects=(*things, *motions),
        facts=tuple(facts),
        costs=costs,
        goals=(),
        values=values,
        tests=tuple(test for name in sorted(problem.goals) for test in _goal(task, name, steps)),
    )


def write_numeric(steps: Sequence[PlanStep], task: Task) -> list[Atom]:
    """Write a plan as ground actions of the page in numbers, or refuse a step that is not offered."""
    found = list[Atom]()
    for step in steps:
        offered = {move.name: words for words, move in _offered(task, step.object).items()}
        if step.place or step.operator not in offered:
            raise InvalidValue(f"{step.operator} is not in the domain in numbers for {step.object}.")
        found.append(offered[step.operator])
    return found


def read_numeric(actions: Sequence[Atom], task: Task) -> Iterator[PlanStep]:
    """Read ground actions of the page in numbers as steps; what they do is for the exact replay to judge."""
    for words in actions:
        thing = next((one for one in words[1:2] if one in task.names), "")
        move = _offered(task, thing).get(words) if thing else None
        if move is None:
            raise InvalidValue(f"({' '.join(words)}) is nothing that the problem offers")
        yield PlanStep(move.name, thing)


def _offered(task: Task, thing: str) -> dict[Atom, Move]:
    """List what is done to an object, in units, by the ground action that does it.

    A motion is named by its symbol, and by what it promises if that is not what it mostly does.
    """
    live, found = {operator.name for operator in task.grounding.live}, dict[Atom, Move]()
    for move in task.moves_on(_in_units(task.grounding), thing):
        if move.operator.name in live:
            less = {"resting": "-push", "held": "-lift"}.get(move.operator.promised or "", "")
            name = motion_name(move) + less
            if move.kind == "put-down":
                found["put-down", thing, f"{name}-down-{thing}", f"{name}-{thing}"] = move
            else:
                found["lift" if move.kind == "lift" else "push", thing, f"{name}-{thing}"] = move
    return found


def _shift_of(grounding: Grounding) -> int:
    """Return what is added to all displacements: a power of ten, and more than any that was seen."""
    farthest = 0.0
    for operator in grounding.live:
        seen = [(one.effect, one.resting_effect) for one in operator.rehearsals]
        seen += [(one.effect, one.resting_effect) for one in operator.outcomes]
        farthest = max([farthest, *(abs(part) for effects in seen for effect in effects for part in effect)])
    shift = _LEAST_SHIFT
    while shift <= 2 * farthest / UNIT:  # putting down can take back what a lift did
        shift *= 10
    return shift


@lru_cache(maxsize=8)
def _in_units(grounding: Grounding) -> Grounding:
    return msgspec.structs.replace(grounding, cell=UNIT)


def _anchor(item: SceneObject, grounding: Grounding) -> tuple[int, int]:
    """Return what stands for exactly where an object starts on x and y."""
    lows = (grounding.table.x[0], grounding.table.y[0])
    x, y = (round((value - low) / UNIT) for value, low in zip(item.position[:2], lows, strict=True))
    return x, y


def _goal(task: Task, name: str, steps: int) -> Iterator[str]:
    """List the conditions for an object to be at its goal.

    Its interval of z has those heights, nearest first, that leave the largest region: their number times the
    disc that the farthest leaves. If all are too far from the goal, it is one that no object comes to.
    """
    item, goal = task.problem.object_named(name), task.problem.goals[name]
    dx, dy, height = ((end - start) / UNIT for end, start in zip(goal, item.position, strict=True))
    tolerance, possible = task.problem.tolerance / UNIT, levels(item, _in_units(task.grounding))
    misses = {z: abs(z - height) + (0.5 if z else 0.0) for z in possible}
    near = within(misses, tolerance)
    choices = [near[: count + 1] for count in range(len(near))]
    chosen = max(choices, key=lambda some: len(some) * (tolerance**2 - misses[some[-1]] ** 2), default=())
    off = misses[chosen[-1]] if chosen else tolerance
    radius = math.sqrt(max(tolerance**2 - off**2, 0.0)) - steps * math.sqrt(0.5)
    start_x, start_y = _anchor(item, task.grounding)
    yield from _polygon(name, (start_x + dx, start_y + dy), max(radius, 0.0))
    chosen = chosen or (max(possible) + 1,)
    yield f"(>= (z {name}) {min(chosen)}) (<= (z {name}) {max(chosen)})"


def _polygon(name: str, centre: tuple[float, float], radius: float) -> Iterator[str]:
    """List the conditions for being in the polygon in a disc, all in units; opposite edges share a line."""
    edges = []
    for normal in _NORMALS:
        along = math.fsum(part * value for part, value in zip(normal, centre, strict=True))
        limit = math.floor(along + radius * math.cos(_WIDEST) * math.hypot(*normal) + _EPSILON)
        by_axis = list(zip(AXES, normal, strict=False))
        plus = [f"({axis} {name})" for axis, part in by_axis if part > 0]
        minus = [f"({axis} {name})" for axis, part in by_axis if part < 0]
        # the sum of some is at most the limit and the sum of others, with no negative number
        left = _sum(plus + [str(-limit)] * (limit < 0))
        right = _sum(minus + [str(limit)] * (limit > 0))
        edges.append(f"(<= {left} {right})" if plus else f"(>= {right} {left})")
    for one, other in zip(edges, edges[len(edges) // 2 :], strict=False):
        yield f"{one} {other}"


def _sum(terms: Sequence[str]) -> str:
    return reduce(lambda one, other: f"(+ {one} {other})", terms) if terms else "0"
