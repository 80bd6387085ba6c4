"""Do pushes that stop on their way help? Some are added to a domain, and objects are pushed with them.

The authors' next paper executes actions in part for precision. Here every push of a domain is stopped at some
shares of its way and rehearsed on the objects of its category. Those are added for each category that most
cheapen an average way over the table: each motion costs as often as it must be tried, and the least cost of
every displacement is found by dynamic programming (Bellman, 1957).
"""

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

import msgspec
import numpy as np

from neurosym.grounding import Grounding
from neurosym.operators import Category, Operator, Primitive, Rehearsal, labelled, name_operator
from neurosym.primitives.rehearsal import modes_of, rehearsal_of
from neurosym.primitives.sampling import next_variant
from neurosym.tasks.promises import chances_of
from neurosym.world import Scene, World
from tools.benchmarks.domains import bench_of

STOPS = (0.4, 0.6, 0.8)
"""Shares of the way between the waypoints after which a push is stopped."""
MOST, SAVES, LEAST_CHANCE = 3, 0.02, 0.7
"""How many are added for a category at most, which share of the average cost each saves at least, and how
surely it keeps its promise."""
PRECISE = 0.01  # what ends so near to its promise kept it [m]
CELL, REACH = 0.01, 30
"""Edge of the cells that displacements are counted in [m]; how many cells far ways lead along an axis."""
SPOT = (0.65, 0.0)  # where objects stand [m]
_WORST = 99.0  # cost of what no motions lead to


class Move(NamedTuple):
    """How far a motion displaces an object [m], and how often it must be tried."""

    x: float
    y: float
    cost: float


class _Part(NamedTuple):
    whole: str  # label of the push
    stop: float
    operator: Operator
    move: Move


def find(domain: Path) -> list[dict[str, Any]]:
    """Choose pushes that stop on their way, for each category: of what push, where, and what they did."""
    bench = bench_of(domain)
    grounding, found = bench.setting.grounding, list[dict[str, Any]]()
    for category in (one for one in grounding.objects.categories if one.objects):
        own = [one for one in grounding.operators_on(category.symbol) if one.frame == "object"]
        whole = [one for one in own if one.promise and grounding.why_left_out(one) is None]
        moves = [move for one in whole if (move := _move(one, category))]
        for part in _cheapest(moves, [*_parts(bench.setting.world, grounding, whole, category)]):
            told = {"subject": category.symbol, "whole": part.whole, "stop": part.stop}
            found.append(told | {"rehearsals": msgspec.to_builtins(part.operator.rehearsals)})
    return found


def with_parts(grounding: Grounding, found: Sequence[Mapping[str, Any]]) -> Grounding:
    """Add to a domain what was found."""
    primitives, operators = [*grounding.objects.primitives], [*grounding.objects.operators]
    for one in found:
        whole, category = labelled(primitives, one["whole"]), grounding.category(one["subject"])
        action, variant = stopped(whole.action, one["stop"]), next_variant(primitives, whole.symbol)
        primitives.append(Primitive(whole.symbol, action, whole.code_error, variant))
        rows = msgspec.convert(one["rehearsals"], tuple[Rehearsal, ...])
        operators.append(_operator(primitives[-1], category, rows))
    table = msgspec.structs.replace(
        grounding.objects, primitives=tuple(primitives), operators=tuple(operators)
    )
    return msgspec.structs.replace(grounding, objects=table)


def stopped(action: Sequence[float], stop: float) -> tuple[float, ...]:
    """Return an action of three waypoints (x, y, z, gripper) that ends at a share of the way between them."""
    points = np.array(action, dtype=float).reshape(3, 4)
    first, second = np.linalg.norm(np.diff(points[:, :3], axis=0), axis=1).tolist()
    gone = stop * (first + second)
    if gone <= first:
        points[1, :3] = points[0, :3] + (gone / first if first else 0.0) * (points[1, :3] - points[0, :3])
        points[2] = points[1]
    else:
        points[2, :3] = points[1, :3] + (gone - first) / second * (points[2, :3] - points[1, :3])
    return tuple(points.ravel().tolist())


def average_cost(moves: Sequence[Move]) -> float:
    """Return the mean over displacements of the least cost of motions that lead to it within a cell."""
    size = 2 * REACH + 1
    away = np.hypot(*np.meshgrid(*[np.arange(-REACH, REACH + 1)] * 2))
    cost = np.where(away <= 1, 0.0, _WORST)
    while True:
        least = cost
        for move in moves:
            x, y = round(move.x / CELL), round(move.y / CELL)
            from_x, from_y = slice(max(0, -x), min(size, size - x)), slice(max(0, -y), min(size, size - y))
            to_x, to_y = slice(max(0, x), min(size, size + x)), slice(max(0, y), min(size, size + y))
            after = np.full_like(cost, _WORST)
            after[to_x, to_y] = cost[from_x, from_y]
            least = np.minimum(least, move.cost + after)
        if np.array_equal(least, cost):
            return float(cost[away <= REACH].mean())
        cost = least


def _parts(
    world: World, grounding: Grounding, own: Sequence[Operator], category: Category
) -> Iterator[_Part]:
    """Rehearse pushes of a category that stop on their way; those that push surely are given."""
    for whole in own:
        if whole.promise is None or whole.promise.kind != "resting":
            continue
        primitive = grounding.primitive_of(whole)
        for stop in STOPS:
            action = np.array(stopped(primitive.action, stop))
            ended = (world.interact(_standing(row), action, 0) for row in category.objects)
            operator = _operator(primitive, category, tuple(map(rehearsal_of, ended)))
            move = _move(operator, category)
            if move and 1 / move.cost >= LEAST_CHANCE and operator.outcomes[0].kind == "resting":
                yield _Part(whole.label, stop, operator, move)


def _cheapest(moves: Sequence[Move], parts: Sequence[_Part]) -> list[_Part]:
    """Choose those that save most on an average way, one after another."""
    known, left, chosen, cost = [*moves], [*parts], list[_Part](), average_cost(moves)
    while left and len(chosen) < MOST:
        costs = [average_cost([*known, one.move]) for one in left]
        best = int(np.argmin(costs))
        if costs[best] > (1 - SAVES) * cost:
            break
        cost = costs[best]
        chosen.append(left.pop(best))
        known.append(chosen[-1].move)
    return chosen


def _operator(primitive: Primitive, category: Category, rows: tuple[Rehearsal, ...]) -> Operator:
    modes = modes_of(rows)
    name = name_operator(primitive.label, category.name, modes)
    return Operator(
        name, category.symbol, primitive.symbol, len(rows), modes, variant=primitive.variant, rehearsals=rows
    )


def _standing(features: Sequence[float]) -> Scene:
    centre = np.array([[*SPOT, features[2] / 2]])
    return Scene(np.array([features]), centre, np.array([[0.0, 0.0, 0.0, 1.0]]))


def _move(operator: Operator, category: Category) -> Move | None:
    """Return how far an operator moves objects of a category, and how surely; None if it hardly does.

    It is judged by rehearsals on the same objects as others are, and not by those that were chosen for it.
    """
    count = len(category.objects)
    usual = msgspec.structs.replace(operator, objects=(), rehearsals=operator.rehearsals[:count])
    chances = chances_of(usual, category, np.array(category.objects), PRECISE)
    if chances is None or usual.promise is None:
        return None
    chance, (x, y) = float(chances.mean()), usual.promise.resting_effect[:2]
    return Move(x, y, 1 / chance) if chance > 0 and max(abs(x), abs(y)) >= CELL / 2 else None
