"""Random tables whose operators move wider objects farther, with rehearsals that say so.

What each of their objects is moved by is read from the printed problem, by docs/pddl.md alone.
"""

import re
from decimal import Decimal

import msgspec
import numpy as np
from independent.ground_pddl import Task, read_task
from independent.random_tables import Drawn, anywhere, draw, walk
from independent.replay import PUT_DOWN, Json, Point, Step, lifts, promise_of, read_text, replay
from msgspec.structs import replace

from neurosym.grounding import Grounding
from neurosym.operators import Category, Operator, Rehearsal
from neurosym.pddl.compiler import domain_text, problem_text

_ROWS = 20
_STREAM = 0x73697A65  # keeps this randomness apart from any other
_UNIT = Decimal("0.0001")
_SHIFT = re.compile(r"\(assign \([xyz] \?o\) \(- \(\+ \([xyz] \?o\) \([^)]*\)\) (\d+)\)\)")
_LABEL = re.compile(r"m-([01]+[a-z]*)")
_BEGUN = ("pushes", "lifts")


def draw_sizes(number: int) -> Drawn | None:
    """Draw a domain with rehearsals and a problem; None if an object stands off the table."""
    drawn, rng = draw(number), np.random.default_rng([_STREAM, number])
    table = drawn.grounding.table
    spots = np.array([item.position[:2] for item in drawn.problem.objects])
    if np.any(spots < (table.x[0], table.y[0])) or np.any(spots > (table.x[1], table.y[1])):
        return None
    grounding = _with_rehearsals(drawn.grounding, rng)
    if not any(operator.rehearsals for operator in grounding.live):
        return None
    problem = replace(drawn.problem, goals={})
    domain_json = read_text(msgspec.json.encode(grounding).decode())
    texts = domain_text(grounding, "numeric"), problem_text(problem, grounding, "numeric")
    own = moves_in_numbers(*texts, domain_json)
    walked, goals = walk(drawn.kind, problem, domain_json, rng, own)
    if drawn.kind == "random" or not goals:
        walked, goals = (), anywhere(problem, grounding, rng)
    problem = replace(problem, goals=goals)
    scene_json = read_text(msgspec.json.encode(problem).decode())
    known = walked if walked and not replay(domain_json, scene_json, walked, own)[0] else None
    return Drawn(number, drawn.kind, False, grounding, problem, domain_json, scene_json, known, own)


def _with_rehearsals(grounding: Grounding, rng: np.random.Generator) -> Grounding:
    """Rehearse on objects like those that are drawn, in some categories only on narrow ones."""
    sizes = {
        one.symbol: rng.uniform((0.03, 0.03, 0.02), (rng.choice([0.05, 0.11, 0.11]), 0.11, 0.08), (_ROWS, 3))
        for one in grounding.operators.categories
    }

    def with_objects(category: Category) -> Category:
        rows = ((*map(float, size), 0.0) for size in sizes[category.symbol])
        return replace(category, objects=tuple(rows))

    def with_rows(operator: Operator) -> Operator:
        if operator.promise is None or operator.trials != _ROWS:
            return operator
        rows = tuple(_row(operator, float(size[0])) for size in sizes[operator.category])
        return replace(operator, rehearsals=rows)

    table = grounding.operators
    categories, operators = map(with_objects, table.categories), map(with_rows, table.operators)
    return replace(
        grounding, operators=replace(table, categories=tuple(categories), operators=tuple(operators))
    )


def _row(operator: Operator, width: float) -> Rehearsal:
    promise = operator.promise
    assert promise is not None
    times = 0.4 + width / 0.1
    x, y, z = promise.effect
    rests = (promise.resting_effect[0] * times, promise.resting_effect[1] * times, 0.0)
    held = (x * times, y * times, z * (0.9 + width))
    return Rehearsal(promise.kind, held if promise.kind == "held" else rests, rests, max(z, 0.0), 0.0)


def moves_in_numbers(domain: str, problem: str, grounding: Json) -> dict[Step, Point]:
    """Return by how much each operator moves each object it is for, from the encoding `numeric` [m]."""
    shifts = set(map(int, _SHIFT.findall(domain)))
    if not shifts:
        return {}
    (shift,), task, names = shifts, read_task(domain, problem), _operators(grounding)
    motions = {
        fact[2]: (names[task.types[fact[1]], _label(fact[2]), fact[0] == "lifts"], fact[1])
        for fact in task.facts
        if fact[0] in _BEGUN
    }
    motions |= {
        fact[1]: (PUT_DOWN + motions[fact[2]][0], motions[fact[2]][1])
        for fact in task.facts
        if fact[0] == "lowers"
    }
    declared = {name for name, kind in task.types.items() if kind == "motion"}
    assert motions.keys() == declared, "every motion has a role"
    return {step: _along(motion, shift, task) for motion, step in motions.items()}


def _along(motion: str, shift: int, task: Task) -> Point:
    x, y, z = (_UNIT * (task.numbers[f"along-{axis}", motion] - shift) for axis in "xyz")
    return x, y, z


def _label(motion: str) -> str:
    (label,) = _LABEL.match(motion).groups()
    return label


def _operators(grounding: Json) -> dict[tuple[str, str, bool], str]:
    """Name the operators by their category, by their symbol, as motions are called, and whether they lift."""
    table = grounding["operators"]
    categories = {one["symbol"]: one["name"] for one in table["categories"]}
    return {
        (categories[one["category"]], one["primitive"] + one.get("variant", ""), lifts(one)): one["name"]
        for one in table["operators"]
        if promise_of(one) is not None
    }
