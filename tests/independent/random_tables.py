"""Random domains and problems: small and large tables, 1 to 16 objects, with a plan that is known or without.

All lengths are whole numbers of micrometres, so that `brute_force` can count them.
"""

import copy
import itertools
from dataclasses import dataclass
from typing import Literal

import msgspec
import numpy as np
from independent.replay import Json, Step, Tabletop, domain_operators, lifts, read_text, replay
from msgspec.structs import replace

from neurosym.grounding import Grounding
from neurosym.operators import Category, Mode, Operator, OperatorTable, Primitive, Vector
from neurosym.pddl import compile_domain
from neurosym.problems import Problem, SceneObject
from neurosym.world import Table

Kind = Literal["walk", "random", "bystander", "tiny"]
PUT_DOWN = "put-down-"
STONE = "stone"
"""The category that nothing can be done to."""
_STREAM = 0x7461626C  # keeps this randomness apart from any other
_CODES = ("00", "01", "10", "11")
_TRIES = 200


@dataclass(frozen=True, eq=False)
class Drawn:
    """A domain and a problem, as neurosym has them and as its files say them."""

    number: int  # of the draw
    kind: Kind  # how the goals came about
    is_whole: bool  # whether cells lose nothing: all displacements and places are whole numbers of them
    grounding: Grounding
    problem: Problem
    domain_json: Json  # what `grounding.json` says
    scene_json: Json  # what the scene's file says
    known: tuple[Step, ...] | None  # a plan that is known to be valid, if one is


def draw(number: int, kind: Kind | None = None, objects: int | None = None) -> Drawn:
    """Draw a domain and a problem; the same number, the same draw."""
    rng = np.random.default_rng([_STREAM, number])
    kind = kind or rng.choice(["walk", "walk", "random", "bystander", "tiny"])
    is_whole = kind == "tiny" or rng.random() < 0.3
    count = objects or _count(kind, rng)
    grounding = _domain(kind, count, is_whole, rng)
    domain_json = read_text(msgspec.json.encode(grounding).decode())
    items = _items(kind, count, is_whole, grounding, rng)
    tolerance = float(rng.choice([0.05, 0.05, 0.03])) if kind != "tiny" else 0.03
    problem = Problem(f"drawn-{number}", items, {}, tolerance)
    walked, goals = walk(kind, problem, domain_json, rng)
    if kind == "random" or (kind == "tiny" and rng.random() < 0.5) or not goals:
        walked, goals = (), anywhere(problem, grounding, rng)
    if kind == "bystander":
        problem = _with_stone(problem, goals, grounding.objects.categories[-1].symbol, rng)
    problem = replace(problem, goals=goals)
    scene_json = read_text(msgspec.json.encode(problem).decode())
    known = walked if walked and not replay(domain_json, scene_json, walked)[0] else None
    return Drawn(number, kind, is_whole, grounding, problem, domain_json, scene_json, known)


def _count(kind: Kind, rng: np.random.Generator) -> int:
    if kind == "tiny":
        return int(rng.integers(1, 4))
    if kind == "bystander":
        return 1
    low, high = [(1, 2), (1, 2), (3, 4), (3, 4), (5, 8), (9, 16)][rng.integers(6)]
    return int(rng.integers(low, high + 1))


def _domain(kind: Kind, count: int, is_whole: bool, rng: np.random.Generator) -> Grounding:
    cell = 0.04 if kind == "tiny" else float(rng.choice([0.005, 0.01, 0.02]))
    width, depth = (0.02 * rng.integers(20 + count, 40 + count, 2)).tolist()
    if kind == "tiny":
        most = {1: 16, 2: 12, 3: 8}[count]
        width, depth = (cell * rng.integers(most // 2, most, 2)).tolist()
    low_x, low_y = (0.02 * rng.integers(-10, 10, 2)).tolist()
    bounds = Table(x=(round(low_x, 6), round(low_x + width, 6)), y=(round(low_y, 6), round(low_y + depth, 6)))
    names = ["block", "tray", "ring"][: rng.integers(1, 4)]
    categories = tuple(
        Category(code, name, 0.25, (0.05, 0.05, 0.05, 0.0), (0.0, 0.0, 0.0, 0.0))
        for code, name in zip(_CODES, [*names, STONE], strict=False)
    )
    symbols = [f"{n:03b}" for n in range(rng.integers(2, 8))]
    primitives = tuple(Primitive(symbol, (0.0,) * 12, 0.0) for symbol in symbols)
    operators = tuple(
        _operator(symbol, category, cell if is_whole else None, rng)
        for symbol, category in itertools.product(symbols, categories[:-1])
        if rng.random() < 0.85
    )
    table = OperatorTable(categories, primitives, operators)
    return compile_domain(table, name="drawn", cell=cell, table_bounds=bounds, lift_height=0.2)


def _operator(symbol: str, category: Category, cell: float | None, rng: np.random.Generator) -> Operator:
    trials = int(rng.choice([3, 5, 10, 20, 20, 20, 20, 20, 20, 20]))
    first = max(1, round(trials * rng.uniform(0.5, 1.0)))
    kinds = [str(kind) for kind in rng.permutation(["resting", "resting", "held", "toppled"])]
    modes = [_mode(kinds[0], first, trials, cell, rng)]
    if trials - first >= 1 and kinds[1] != kinds[0]:
        modes.append(_mode(kinds[1], trials - first, trials, cell, rng))
    modes.sort(key=lambda mode: -mode.count)
    return Operator(f"act-{symbol}-{category.name}", category.symbol, symbol, trials, tuple(modes))


def _mode(kind: str, count: int, trials: int, cell: float | None, rng: np.random.Generator) -> Mode:
    x, y = _push(cell, rng)
    spread = (0.2, 0.0, 0.0) if rng.random() < 0.05 else (0.004, 0.003, 0.0)
    effect, resting = (x, y, 0.0), (x, y, 0.0)
    if kind == "held":
        height = float(rng.integers(3, 26)) * 0.01
        height = height if cell is None else cell * max(1, round(height / cell))
        resting = (*_push(cell, rng), 0.0) if rng.random() < 0.5 else (x, y, 0.0003)
        effect = (x, y, round(height, 6))
    near = 0 if rng.random() < 0.05 else round(count * rng.uniform(0.3, 1.0))
    return Mode(kind, count, count / trials, effect, spread, resting, spread, 0.0, near)


def _push(cell: float | None, rng: np.random.Generator) -> tuple[float, float]:
    """Draw a displacement of 2 to 13 cm, along one axis or two."""
    length, angle = rng.uniform(0.02, 0.13), rng.uniform(0, 2 * np.pi)
    x, y = float(length * np.cos(angle)), float(length * np.sin(angle))
    if rng.random() < 0.4:
        x, y = (x, 0.0) if abs(x) > abs(y) else (0.0, y)
    if cell is not None:
        return round(cell * round(x / cell), 6), round(cell * round(y / cell), 6)
    return round(x, 4), round(y, 4)


def _items(
    kind: Kind, count: int, is_whole: bool, grounding: Grounding, rng: np.random.Generator
) -> tuple[SceneObject, ...]:
    """Draw objects that stand beside each other; fewer than asked for if there is no room."""
    table, cell = grounding.table, grounding.cell
    largest = 0.06 if count > 4 else 0.11
    found: list[SceneObject] = []
    for _ in range(_TRIES * count):
        if len(found) == count:
            break
        size = [round(side, 3) + 0.000013 for side in rng.uniform(0.03, largest, 2).tolist()]
        x, y = (round(float(rng.uniform(*axis)), 4) for axis in (table.x, table.y))
        if is_whole:
            size = [2 * cell * max(1, round(side / cell / 2)) for side in size]  # they may touch exactly
            x, y = (
                round(low + cell * min(round((at - low) / cell), int((high - low) / cell + 1e-6)), 6)
                for at, (low, high) in ((x, table.x), (y, table.y))
            )
        elif rng.random() < 0.04:
            x = round(table.x[1] + float(rng.uniform(0.0, 0.09)), 4)
        categories = grounding.objects.categories
        stone = rng.random() < 0.1 and found
        category = categories[-1] if stone else categories[rng.integers(len(categories) - 1)]
        height = round(float(rng.uniform(0.02, 0.08)), 3)
        features = (*(round(side, 6) for side in size), height, 0.0)
        name = f"item-{len(found) + 1}"
        item = SceneObject(name, category.symbol, features, (x, y, round(height / 2, 6)))
        if rng.random() < 0.03 or not any(_overlap(item, other) for other in found):
            found.append(item)
    return tuple(found)


def _overlap(one: SceneObject, other: SceneObject) -> bool:
    away, sizes = np.subtract(one.position, other.position)[:2], np.add(one.features, other.features)[:2]
    return bool(np.all(2 * np.abs(away) < sizes))


def walk(
    kind: Kind, problem: Problem, domain_json: Json, rng: np.random.Generator
) -> tuple[tuple[Step, ...], dict[str, Vector]]:
    """Do possible steps at random, and take where objects end, roughly, for goals."""
    top = Tabletop(domain_json, read_text(msgspec.json.encode(problem).decode()))
    live = domain_operators(domain_json)
    steps: list[Step] = []
    wanted = int(rng.integers(1, 5 if kind == "tiny" else 2 + 3 * min(len(problem.objects), 8)))
    may_end_held = rng.random() < 0.3
    for _ in range(4 * wanted):
        if top.primitives >= wanted or not live or top.held:
            break
        item = problem.objects[rng.integers(len(problem.objects))]
        fitting = [one for one in live if one["category"] == item.category]
        if not fitting:
            continue
        operator = fitting[rng.integers(len(fitting))]
        more: list[Step] = [(operator["name"], item.name)]
        if lifts(operator) and not (may_end_held and top.primitives + 1 == wanted):
            more.append((PUT_DOWN + operator["name"], item.name))
        tried = copy.copy(top)
        tried.places = dict(top.places)
        if not any(tried.do(step) for step in more):
            top, steps = tried, [*steps, *more]
    moved = {name for _, name in steps}
    goals = {
        name: _near(top.places[name], problem.tolerance, rng)
        for name in problem.object_names
        if name in moved or rng.random() < 0.1
    }
    return tuple(steps), goals if steps else {}


def _near(place: tuple, tolerance: float, rng: np.random.Generator) -> Vector:
    """Draw a point within the tolerance of a place."""
    away = rng.normal(size=3)
    away *= tolerance * rng.uniform(0.0, 0.95) / np.linalg.norm(away)
    x, y, z = (round(float(at) + float(by), 5) for at, by in zip(place, away, strict=True))
    return x, y, max(z, 0.0)


def anywhere(problem: Problem, grounding: Grounding, rng: np.random.Generator) -> dict[str, Vector]:
    """Draw goals for one object or more anywhere on the table, now and then in the air."""
    goals: dict[str, Vector] = {}
    for item in problem.objects:
        if goals and rng.random() < 0.3:
            continue
        x, y = (round(float(rng.uniform(*axis)), 4) for axis in (grounding.table.x, grounding.table.y))
        z = round(float(rng.uniform(0.1, 0.3)), 4) if rng.random() < 0.1 else item.position[2]
        goals[item.name] = (x, y, z)
    return goals


def _with_stone(problem: Problem, goals: dict[str, Vector], stone: str, rng: np.random.Generator) -> Problem:
    """Put something immovable where the goal is, or beside it."""
    goal = next(iter(goals.values()))
    size = tuple(round(side, 3) + 0.000013 for side in rng.uniform(0.03, 0.11, 2).tolist())
    for _ in range(_TRIES):
        x, y = (round(at + float(rng.uniform(-0.1, 0.1)), 4) for at in goal[:2])
        there = SceneObject("item-10", stone, (*(round(side, 6) for side in size), 0.05, 0.0), (x, y, 0.025))
        if not any(_overlap(there, item) for item in problem.objects):
            return replace(problem, objects=(*problem.objects, there))
    return problem
