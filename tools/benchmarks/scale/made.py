"""Data sets, domains and problems of any size, made up."""

import json
import math
from pathlib import Path

import numpy as np

from neurosym.grounding import Grounding, is_lift
from neurosym.operators import Category, Mode, Operator, OperatorTable, Primitive, Vector, all_symbols
from neurosym.pddl import compile_domain
from neurosym.problems import Problem, SceneObject
from neurosym.world import Table

PITCH = 0.12  # how far from one another the objects of a made problem stand [m]
_MARGIN = 0.35  # between the objects and the edges of the table [m]
_CATEGORIES = 4
_PUSHED, _LIFTED = 0.08, 0.2


def write_data(path: Path, rows: int) -> None:
    """Write a data set that looks like the toy world's: lifts, pushes, and a little noise."""
    rng = np.random.default_rng(0)
    features = rng.uniform((0.03, 0.03, 0.02, 0), (0.18, 0.18, 0.1, 1), (rows, 4))
    features[:, 3] = features[:, 3] > 0.5
    low, high = [-0.1, -0.1, 0.0, 0.0] * 3, [0.1, 0.1, 0.1, 1.0] * 3
    actions = rng.uniform(low, high, (rows, 12)).astype(np.float32)
    travel = actions[:, 8:10] - actions[:, :2]
    axis = np.abs(travel).argmax(1)
    effects, every = np.zeros((rows, 3)), np.arange(rows)
    effects[every, axis] = _PUSHED * np.sign(travel[every, axis]) * (features[:, 0] < 0.12)
    held = (
        (actions[:, 3] >= 0.5) & (actions[:, 11] < 0.5) & ((features[:, 3] > 0.5) | (features[:, 1] < 0.08))
    )
    effects[held] = (0, 0, _LIFTED)
    effects += rng.normal(0, 0.003, effects.shape)
    resting = np.where(held[:, None], 0.0, effects)
    origin = {"robot": "made up", "gripper_columns": [3, 7, 11], "action_low": low, "action_high": high}
    columns = {"features": features, "actions": actions, "effects": effects, "resting_effects": resting}
    plain = {name: column.astype(np.float32) for name, column in columns.items()}
    np.savez(path, **plain, held=held, origin=json.dumps(origin))


def made_table(action_bits: int) -> OperatorTable:
    """Make a table of operators: of eight primitives one lifts, the others push, each category elsewhere."""
    rng = np.random.default_rng(action_bits)
    codes, features = [f"{number:02b}" for number in range(_CATEGORIES)], (0.03, 0.03, 0.05, 0.0)
    categories = [Category(code, f"kind-{code}", 1 / _CATEGORIES, features, (0.0,) * 4) for code in codes]
    symbols = all_symbols(action_bits)
    primitives = tuple(Primitive(symbol, (0.0,) * 12, 0.0) for symbol in symbols)
    operators = [
        _operator(symbol, category, rng, held=number % 8 == 0)
        for number, symbol in enumerate(symbols)
        for category in categories
    ]
    return OperatorTable(tuple(categories), primitives, tuple(operators))


def _operator(symbol: str, category: Category, rng: np.random.Generator, *, held: bool) -> Operator:
    angle, length = rng.uniform(0, 2 * math.pi), rng.uniform(0.08, 0.15)
    pushed: Vector = (length * math.cos(angle), length * math.sin(angle), 0.0)
    nothing, scatter = (0.0, 0.0, 0.0), (0.001, 0.001, 0.001)
    effect, resting = ((0.0, 0.0, _LIFTED), nothing) if held else (pushed, pushed)
    kind = "held" if held else "resting"
    mode = Mode(kind, 20, 1.0, effect, scatter, resting, scatter, effect[2], 20)
    name = f"{'lift' if held else 'push'}-{symbol}-{category.name}"
    return Operator(name, category.symbol, symbol, 20, (mode,))


def made_domain(action_bits: int, objects: int) -> Grounding:
    """Compile a made table of operators for a table with room for so many objects."""
    side = 2 * _MARGIN + PITCH * math.ceil(math.sqrt(objects))
    bounds = Table((0.0, side), (0.0, side))
    table = made_table(action_bits)
    return compile_domain(table, name="made", cell=0.005, table_bounds=bounds, lift_height=_LIFTED)


def made_problem(grounding: Grounding, objects: int) -> Problem:
    """Make a problem: objects in rows and columns, and for each the goal that a push leads to, done twice."""
    columns = math.ceil(math.sqrt(objects))
    pushes = {
        category.symbol: [op for op in grounding.live if op.subject == category.symbol and not is_lift(op)]
        for category in grounding.objects.categories
    }
    items, goals = [], {}
    for number in range(objects):
        x, y = (_MARGIN + PITCH * (place + 0.5) for place in (number % columns, number // columns))
        category = grounding.objects.categories[number % _CATEGORIES]
        name = f"item-{number + 1:04d}"
        items.append(SceneObject(name, category.symbol, (0.03, 0.03, 0.05, 0.0), (x, y, 0.025)))
        by = grounding.displacement(pushes[category.symbol][0])
        goals[name] = (x + 2 * by[0], y + 2 * by[1], 0.025)
    return Problem("crowd", tuple(items), goals)
