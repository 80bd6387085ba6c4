"""The six data sets: where their rows come from, how they are learned, and what people would ask for."""

import csv
from collections.abc import Mapping
from dataclasses import dataclass, field
from importlib import import_module
from pathlib import Path
from typing import Any

import numpy as np
import tomli_w

from neurosym.data.interactions import Interactions

Goals = dict[str, Any]  # what axes shall become: a value, or the least and greatest
Task = tuple[tuple[float, ...] | None, Goals]  # the features at the start, and what is asked for
DRAWN = 10  # tasks, where they are drawn
TURN = 6.283185307


@dataclass(frozen=True)
class DataSet:
    """A data set, and what is done with it.

    Attributes:
        about: What it is, in a sentence.
        bits: Bits of object and action symbols.
        columns: What its TOML file says of columns and axes.
        tasks: What is asked for, in its world.
        within: How near things shall come along some axes, where there is none.
        seeds: The seeds of training.
        world: `module:factory` of its world; empty if there is none.
        rows: How many interactions are made in the world.
    """

    about: str
    bits: tuple[int, int]
    columns: Mapping[str, Any]
    tasks: tuple[Task, ...] = ()
    within: Mapping[str, float] = field(default_factory=dict)
    seeds: tuple[int, ...] = (1, 2, 3)
    world: str = ""
    rows: int = 0

    @property
    def module(self) -> Any:
        """The module of its world."""
        return import_module(self.world.partition(":")[0])

    def make(self) -> Any:
        """Make its world."""
        return getattr(self.module, self.world.partition(":")[2])()


def of_world(name: str, kind: str, about: str, axes: tuple[dict[str, Any], ...], **others: Any) -> DataSet:
    """Describe a data set whose rows are made in a world."""
    names = [axis["name"] for axis in axes]
    columns = {
        "features": names,
        "choices": ["move"],
        "after": {one: f"{one} afterwards" for one in names},
        "axes": [*axes],
    }
    return DataSet(about, columns=columns, world=f"tools.benchmarks.any_data.{name}:{kind}", **others)


def of_deepsym(
    about: str, names: tuple[str, ...], axes: tuple[dict[str, Any], ...], **others: Any
) -> DataSet:
    """Describe a data set of DeepSym: what kind and size things have, and pushes of which one was chosen."""
    columns = {
        "features": ["features"],
        "actions": ["actions"],
        "effects": ["effects"],
        "names": {"features": [*names]},
        "origin": {"choices": [0, 1, 2]},
        "axes": [*axes],
    }
    return DataSet(about, columns=columns, **others)


def around(value: float, within: float) -> tuple[float, float]:
    """Return bounds that are as far on either side."""
    return round(value - within, 4), round(value + within, 4)


PUSH = ("obj1", "obj2", "obj3", "obj4", "obj5", "scale")
PAIRS = ("cube", "cylinder", "cylinderside", "hollow", "sphere", "size")
UP = (-0.5, 0.5)  # an angle that is upright enough [rad]
SETS = {
    "deepsym-push": of_deepsym(
        "pushes of five shapes by another group", PUSH,
        ({"name": "x", "unit": "px"}, {"name": "y", "unit": "px"}, {"name": "force"}),
        bits=(3, 2), within={"x": 15.0, "y": 15.0},
    ),
    "deepsym-pairs": of_deepsym(
        "150 pushes of five shapes by another group", PAIRS,
        ({"name": "x", "unit": "m"}, {"name": "y", "unit": "m"}, {"name": "z", "unit": "m"}),
        bits=(2, 2), within={"x": 0.1, "y": 0.1},
    ),
    "grid": of_world(
        "grid", "Grid", "a grid world with a key and a door",
        ({"name": "x"}, {"name": "y"}, {"name": "key", "kind": "flag"}, {"name": "open", "kind": "flag"}),
        bits=(6, 3), rows=8000,
        tasks=(
            ((0, 0, 0, 0), {"x": 4, "y": 1}), ((2, 3, 0, 0), {"x": 5, "y": 3}), ((1, 1, 0, 0), {"open": 1}),
            ((2, 0, 0, 0), {"x": 5, "y": 0}), ((0, 3, 0, 0), {"key": 1, "x": 2, "y": 3}),
            ((5, 0, 1, 0), {"x": 0, "y": 0}), ((4, 3, 1, 0), {"x": 2, "y": 0, "open": 1}),
            ((0, 0, 0, 0), {"x": 5, "y": 2, "open": 0}), ((5, 3, 0, 1), {"x": 0, "y": 3}),
            ((2, 2, 0, 0), {"x": 3, "y": 1}),
        ),
    ),
    "pendulum": of_world(
        "pendulum", "Pendulum", "Gymnasium's pendulum, a torque held for some steps",
        ({"name": "angle", "kind": "angle", "period": TURN}, {"name": "speed"}),
        bits=(6, 2), rows=10_000,
        tasks=(
            *(((TURN / 2 + off, 0.0), {"angle": UP}) for off in (0.0, 0.3, -0.3, 1.0, -1.0)),
            *((None, {"angle": UP}),) * 3,
            *((None, {"angle": UP, "speed": (-2, 2)}),) * 2,
        ),
    ),
    "pushing": of_world(
        "pushing", "Pushing", "panda-gym's pushing environment, a push from a side",
        ({"name": "x", "unit": "m"}, {"name": "y", "unit": "m"}),
        bits=(2, 3), rows=600,
        tasks=tuple(
            (None, {"x": around(x, 0.025), "y": around(y, 0.025)})
            for x, y in (
                (0.0, 0.0), (0.1, 0.1), (-0.1, 0.1), (-0.1, -0.1), (0.1, -0.1),
                (0.0, 0.12), (0.0, -0.12), (0.12, 0.0), (-0.12, 0.0), (0.05, 0.05),
            )
        ),
    ),
    "thermostat": of_world(
        "thermostat", "Room", "a room with a window and a thermostat",
        ({"name": "temperature"}, {"name": "window", "kind": "flag"}, {"name": "mode", "kind": "value"}),
        bits=(5, 3), rows=4000,
        tasks=(
            *((None, {"temperature": bounds}) for bounds in ((20, 22), (17, 19), (23, 25), (10, 12))),
            *((None, {"temperature": bounds, "window": 0}) for bounds in ((19, 21), (24, 26))),
            *((None, {"temperature": bounds, "mode": 0}) for bounds in ((20, 22), (15, 17))),
            (None, {"temperature": (20, 22), "window": 1, "mode": 0}),
            (None, {"temperature": (12, 14), "window": 0, "mode": 2}),
        ),
    ),
}  # fmt: skip


def tasks_of(one: DataSet, data: Interactions, seed: int) -> list[Task]:
    """Return what is asked for: starts that are not said are drawn in the world.

    Where there is none, a thing is drawn from the rows, and its goal is what two of its rows add up to.
    """
    rng = np.random.default_rng(seed if one.world else [seed, len(data)])
    if one.world:
        world = one.make()
        drawn = [world.reset(rng) for _ in one.tasks]
        return [
            (tuple(map(float, there if start is None else start)), goals)
            for there, (start, goals) in zip(drawn, one.tasks, strict=True)
        ]
    names, found = [axis["name"] for axis in one.columns["axes"]], list[Task]()
    while len(found) < DRAWN:
        thing = data.features[rng.integers(len(data))]
        same = np.flatnonzero((data.features == thing).all(axis=1))
        sums = data.effects[rng.choice(same, 2)].sum(axis=0)
        goals = {
            name: around(float(sums[n]), one.within[name])
            for n, name in enumerate(names)
            if name in one.within
        }
        if not all(low <= 0 <= high for low, high in goals.values()):
            found.append((tuple(map(float, thing)), goals))
    return found


def write_rows(one: DataSet, path: Path, rows: int, seed: int) -> None:
    """Write a table of random moves from random states, each from a reset of its own."""
    world, moves, rng = one.make(), one.module.MOVES, np.random.default_rng(seed)
    names = one.columns["features"]
    with path.open("w", newline="") as file:
        table = csv.writer(file)
        table.writerow([*names, "move", *(f"{name} afterwards" for name in names)])
        for _ in range(rows):
            state, move = world.reset(rng), int(rng.integers(len(moves)))
            after = world.step(state, np.eye(len(moves))[move])
            table.writerow([*state.round(5), moves[move], *after.round(5)])


def write_columns(one: DataSet, path: Path) -> None:
    """Write the TOML file that says which columns are what."""
    path.write_text(tomli_w.dumps(dict(one.columns)))
