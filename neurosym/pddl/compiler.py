"""The compiler: from the table of operators to a grounding and to PDDL, and from plans to ground actions.

A problem is printed before anybody plans. Goal regions leave out the edge of what the tolerance allows, since
grids round, and only some places are drawn. So the exact replay may take a plan that ends a cell beside the
region, or that uses a spot of the table that has no name yet. Such a plan says which facts it needs; the
problem beside it is then printed with them, and any validator takes the two together.
"""

import math
import re
from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache

import msgspec

from neurosym.checks import check_kind, check_length
from neurosym.choices import CELL as CELL
from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.grounding import (
    FORMAT,
    FORMAT_WITH_PLACES,
    FORMAT_WITH_RELATIONS,
    FORMAT_WITH_UPRIGHT,
    Grounding,
)
from neurosym.operators import MIN_CHANCE, OperatorTable, counted_axes, name_operator
from neurosym.pair_operators import RelationOperators
from neurosym.pddl.numeric import STEPS as NUMERIC_STEPS
from neurosym.pddl.numeric import numeric_domain, numeric_problem, write_numeric
from neurosym.pddl.strips import WORDS, page
from neurosym.pddl.strips_plan import GroundPlan as GroundPlan
from neurosym.pddl.strips_plan import write
from neurosym.pddl.strips_problem import STEPS, StripsProblem
from neurosym.pddl.syntax import ENCODINGS, NUMERIC, STRIPS, EncodingName
from neurosym.problems import LEGAL_NAME, SPOT, Problem, SceneObject, check_on_table
from neurosym.tasks.task import understand
from neurosym.tasks.transition import PlanStep
from neurosym.world import Table

MAX_CELLS = 5000


def compile_domain(
    table: OperatorTable,
    *,
    name: str,
    table_bounds: Table,
    lift_height: float,
    cell: float = CELL,
    places: OperatorTable | None = None,
    relations: RelationOperators | None = None,
    upright: OperatorTable | None = None,
    turned: bool = False,
) -> Grounding:
    """Turn a table of operators into everything that planning needs, an operator for each outcome.

    Args:
        table: What each primitive does to each category.
        name: Name of the domain, that of the world.
        table_bounds: Where objects may stand.
        lift_height: How far the hand rises after the last waypoint [m].
        cell: Edge of a grid cell [m].
        places: What carries objects of the same categories to places, if that was learned.
        relations: What puts objects in relations to one another, if that was learned.
        upright: What sets objects upright that lie on a side, if that was learned.
        turned: Whether motions are performed turned as objects lie.

    Raises:
        InvalidValue: If effects are not along x, y and z, the cell is no sensible size, or a name is not
            legal, or taken.
    """
    check_kind("table", table, OperatorTable, "an OperatorTable, as tabulate returns it")
    check_kind("name", name, str, "a PDDL name")
    check_kind("table_bounds", table_bounds, Table, "a Table")
    check_length("lift_height", lift_height)
    check_length("cell", cell)
    check_axes(table)
    widest = max(high - low for low, high in (table_bounds.x, table_bounds.y))
    if not (math.isfinite(cell) and widest / MAX_CELLS <= cell <= widest):
        raise InvalidValue(f"A cell of {cell} m will not do; valid: {widest / MAX_CELLS:g} to {widest:g} m.")
    expanded = with_every_outcome(table)
    names = [name, *WORDS.split(), *(one.name for one in table.categories)]
    names += [one.name for one in (*expanded.operators, *(places.operators if places else ()))]
    if relations:
        names += [one.name for one in relations.states] + [one.name for one in relations.operators]
    for one, count in Counter(names).items():
        if not LEGAL_NAME.fullmatch(one):
            raise InvalidValue(
                f"{one!r} is not a legal PDDL name; valid: a lower-case letter, then a-z, 0-9 and hyphens."
            )
        if count > 1:
            raise InvalidValue(f"Two parts of the domain are called {one}; each needs a name of its own.")
    upright = upright if upright and upright.operators else None
    usual = FORMAT_WITH_RELATIONS if relations else FORMAT_WITH_PLACES if places else FORMAT
    return Grounding(
        format=FORMAT_WITH_UPRIGHT if upright else usual,
        name=name,
        cell=cell,
        table=table_bounds,
        lift_height=lift_height,
        objects=expanded,
        places=_with_objects(places) if places else None,
        relations=relations,
        upright=upright,
        turned=turned,
    )


def with_every_outcome(table: OperatorTable) -> OperatorTable:
    """Add to each operator those that promise its other outcomes, at rest or held.

    A primitive that lifts two objects of a category out of three leaves the third where it is, and a planner
    may want either. So each outcome that is seen often enough becomes an operator of its own, at a cost that
    says how rare it is: the all-outcomes determinisation of FF-Replan (Yoon, Fern and Givan, 2007). Execution
    sees what really happens, and replans if it was another.
    """
    names = {category.symbol: category.name for category in table.categories}
    operators = [
        msgspec.structs.replace(
            operator, name=name_operator(operator.label, names[operator.subject], [mode]), promised=mode.kind
        )
        for operator in table.operators
        for mode in operator.outcomes
        if mode is not operator.promise and mode.kind in ("resting", "held") and mode.share >= MIN_CHANCE
    ]
    return msgspec.structs.replace(table, operators=(*table.operators, *operators))


def _with_objects(places: OperatorTable) -> OperatorTable:
    """Keep with each operator the objects that it was rehearsed on: its category may have had others."""
    rehearsed = {one.symbol: one.objects for one in places.categories}
    operators = tuple(
        msgspec.structs.replace(one, objects=one.objects or rehearsed.get(one.subject, ()))
        for one in places.operators
    )
    return msgspec.structs.replace(places, operators=operators)


def check_axes(table: OperatorTable) -> None:
    """Raise `InvalidValue` unless effects are displacements along x, y and z."""
    if table.axes != 3:
        raise InvalidValue(
            f"The table of operators has effects of {counted_axes(table.axes)}; "
            "a PDDL domain needs 3: x, y and z [m]."
        )


def domain_text(grounding: Grounding, encoding: EncodingName = STRIPS, *, costs: bool = True) -> str:
    """Print the domain, as a page or in numbers, with costs or without; equal groundings give equal bytes."""
    return (numeric_domain if _is_numeric(encoding) else page)(grounding).text(costs=costs)


def _is_numeric(encoding: str) -> bool:
    if encoding not in ENCODINGS:
        raise UnknownChoice("encoding", encoding, ENCODINGS)
    return encoding == NUMERIC


def ground_plan(
    steps: Iterable[PlanStep], problem: Problem, grounding: Grounding, encoding: EncodingName = STRIPS
) -> GroundPlan:
    """Turn a plan into ground actions of the domain, cells and all, such that plan validators take it.

    `InvalidValue` if an operator is not in the domain, or not for its object, or leads off the grid.
    """
    steps, task = tuple(steps), understand(problem, grounding)
    if encoding == NUMERIC:
        return GroundPlan(NUMERIC, tuple(write_numeric(steps, task)))
    led = {*task.led, *(one.object for one in steps if grounding.operator_named(one.base).frame == "object")}
    return write(steps, StripsProblem(task, led=[name for name in task.names if name in led]))


def problem_text(
    problem: Problem,
    grounding: Grounding,
    encoding: EncodingName = STRIPS,
    *,
    steps: int = STEPS,
    plans: Sequence[GroundPlan] = (),
    costs: bool = True,
) -> str:
    """Print a problem for the domain in an encoding, with costs or without, or refuse one that it cannot say.

    The rounding of so many steps is taken off the goal regions; in numbers of ten times as many. Plans that
    the replay takes may stand beside the problem: it is printed such that they are its plans. In numbers they
    need nothing, since regions leave out no more than is rounded.
    """
    is_numeric = _is_numeric(encoding)
    for item in problem.objects:
        check_object(item, grounding)
    task = understand(problem, grounding)
    if is_numeric:
        return numeric_problem(task, steps=steps * NUMERIC_STEPS).text(costs=costs)
    led = {*task.led, *(name for plan in plans for name in plan.led)}
    printed = StripsProblem(
        task,
        led=[name for name in task.names if name in led],
        kept=[move for plan in plans for move in plan.moves],
        steps=steps,
    )
    facts = sorted(fact for plan in plans for fact in plan.facts)
    return printed.data(facts, sorted({spot for plan in plans for spot in plan.spots})).text(costs=costs)


# Which names the objects of a problem may have

_PARTICULAR = r"[xy]\d*|d[xy](-?\d+)?|cost\d+|way\d+|zone\d+|m-[01]+[a-z]*(-.*)?"
"""What problems call cells, steps, prices, ways, zones and motions."""
_OF_PLACES = rf"(start|goal|park)-.*|n\d+|{SPOT.pattern}"


def check_object(item: SceneObject, grounding: Grounding) -> None:
    """Raise `InvalidValue` unless an object stands on the table and its name is free in the domain."""
    grounding.category(item.category)
    check_on_table(item, grounding.table)
    by_name = grounding.places or grounding.relations
    if is_taken(item.name, grounding) or (by_name and re.fullmatch(_OF_PLACES, item.name)):
        raise InvalidValue(f"No object can be called {item.name}, the domain uses that; try item-01.")


def is_taken(name: str, grounding: Grounding) -> bool:
    """Say whether the domain itself uses a name, so that no object or place of a problem can have it."""
    return name in _known_words(grounding) or bool(re.fullmatch(_PARTICULAR, name))


@lru_cache(maxsize=8)
def _known_words(grounding: Grounding) -> frozenset[str]:
    """List what the page calls its types, actions and constants."""
    domain = page(grounding)
    names = [name for name, _ in (*domain.types, *domain.constants)]
    return frozenset(["object", *names, *(action.name for action in domain.actions)])


# What of a printed domain and problem a plan touches

Action = tuple[str, ...]
"""A ground action: its name, and its arguments."""
_WORD = re.compile(r"[^\s()]+")
_ACTION = re.compile(r"\(:action\s+(\S+)(?:\s*:parameters\s*\(([^()]*)\))?")
_PROBLEM = re.compile(r"(.*\(:objects)([^()]*)\)(\s*\(:init)(.*)\)(\s*\(:goal.*)", re.DOTALL)
_TYPED = re.compile(r"((?:\s+(?!-\s)[^\s()]+)+)\s+-\s+(\S+)")
_FACT = re.compile(r"(?:\(=\s*)?\(([^()]*)\)(?:\s*[^\s()]+\s*\))?")
"""A fact, or a value that is given to a function."""


def excerpt_for(domain: str, problem: str, actions: Sequence[Action]) -> tuple[str, str]:
    """Leave out of a domain and a problem what cannot matter to a plan.

    Other people's validators read PDDL slowly: a grid with its thousands of facts takes them many seconds.
    But whether a plan is valid depends on its own actions alone, and on facts whose words occur in these, in
    the domain or in the goal. Where conditions speak of all objects, every fact is kept.
    """
    start, *blocks = _bare(domain).strip().removesuffix(")").split("(:action")
    used = {action[0] for action in actions}
    kept = [block for block in blocks if used & {*block.split()[:1]}] or blocks[:1]  # readers trip over none
    domain = "(:action".join([start, *kept]) + ")"
    parts = _PROBLEM.fullmatch(_bare(problem).strip())
    words = {word for action in actions for word in action} | {*_WORD.findall(domain)}
    if parts is None or not words.isdisjoint(("exists", "forall")):
        return domain, problem
    head, objects, init, facts, goal = parts.groups()
    words |= {*_WORD.findall(goal)}
    typed = [
        (" ".join(name for name in names.split() if name in words), kind)
        for names, kind in _TYPED.findall(objects)
    ]
    declared = " ".join(f"{names} - {kind}" for names, kind in typed if names)
    told = " ".join(fact[0] for fact in _FACT.finditer(facts) if words.issuperset(fact[1].split()))
    return domain, f"{head} {declared}){init} {told}){goal}"


def parameters_of(domain: str) -> Mapping[str, int]:
    """Return how many parameters each action has in the text of a domain, or refuse what is no PDDL."""
    return {name: parameters.count("?") for name, parameters in _ACTION.findall(_bare(domain))}


def _bare(text: str) -> str:
    """Return a text in lower case, without comments, or refuse one that is no PDDL."""
    bare = re.sub(r";.*", "", text).lower()
    if not 0 < bare.count("(") == bare.count(")"):
        raise InvalidValue("The text is no PDDL: its parentheses do not fit together.")
    return bare
