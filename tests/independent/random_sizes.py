"""Random tables whose operators move wider objects farther, with rehearsals that say so."""

import msgspec
import numpy as np
from independent.random_tables import Drawn, anywhere, draw, walk
from independent.replay import PUT_DOWN, Point, Step, displacement, lifts, read_text, replay, settled
from msgspec.structs import replace

from neurosym.grounding import Grounding
from neurosym.operators import Category, Operator, Rehearsal
from neurosym.problems import Problem
from neurosym.tasks.promises import usable

_ROWS = 20
_STREAM = 0x73697A65  # keeps this randomness apart from any other


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
    own = own_moves(problem, grounding)
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


def own_moves(problem: Problem, grounding: Grounding) -> dict[Step, Point]:
    """Return by how much each operator moves each object it is for [m]."""
    moves = dict[Step, Point]()
    for item in problem.objects:
        for operator in usable(grounding, item, problem.tolerance):
            told = read_text(msgspec.json.encode(operator).decode())
            by = displacement(told)
            moves[operator.name, item.name] = by
            if lifts(told):
                down = (end - up for end, up in zip(settled(told), by, strict=True))
                moves[PUT_DOWN + operator.name, item.name] = tuple(down)
    return moves
