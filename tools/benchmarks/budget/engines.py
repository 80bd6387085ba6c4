"""Two engines side by side: do the same actions the same, and does what one taught hold in the other?"""

import shutil
from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import tomli_w

from neurosym.choices import ENGINES
from neurosym.files import read_toml
from neurosym.sim.config import TabletopConfig
from neurosym.sim.tabletop import Tabletop
from neurosym.stages import layout
from neurosym.world import Outcome
from tools.benchmarks.budget.ways import WAYS
from tools.benchmarks.planning import figures
from tools.benchmarks.tables import figures_table, mean_of, table, with_interval
from tools.benchmarks.world.measures import random_tasks

JOB = "engines"
_INTERACTIONS, _SEED = 500, 4747  # the motors of MuJoCo were chosen on 120 of seed 4545
_BESIDE = np.tile([1e-4, 1e-4, 1e-4, 0.0], 3)  # all waypoints elsewhere by so much [m]


@cache
def moved_over(folder: Path, engine: str) -> Path:
    """Return a copy of a domain folder that another engine simulates."""
    copy = folder.with_name(f"{folder.name}-in-{engine}")
    shutil.copytree(folder, copy, dirs_exist_ok=True)
    document = read_toml(copy / layout.WORLD)
    document["options"]["engine"] = engine
    (copy / layout.WORLD).write_text(tomli_w.dumps(document))
    return copy


def compare() -> dict[str, dict[str, float]]:
    """Perform the same random actions in both engines, and in each once more a little beside."""
    worlds = [Tabletop(TabletopConfig(engine=name)) for name in ENGINES]
    tasks = random_tasks(_INTERACTIONS, _SEED, world=worlds[0])
    done, beside = (
        [[world.interact(one.scene, one.action + shift, 0) for one in tasks] for world in worlds]
        for shift in (0.0, _BESIDE)
    )
    alone = {f"{name}, .1 mm beside": _apart(*of) for name, *of in zip(ENGINES, done, beside, strict=True)}
    return {"both": _apart(*done), **alone}


def _apart(ones: Sequence[Outcome], others: Sequence[Outcome]) -> dict[str, float]:
    """Say how far apart objects end [mm], what the others' effects explain, and how many are of one kind."""
    effects, seen = (np.array([one.resting_effect[:2] for one in of]) for of in (ones, others))
    apart = 1000 * np.linalg.norm(effects - seen, axis=1)
    left = ((effects - seen) ** 2).sum() / ((effects - effects.mean(0)) ** 2).sum()
    return {
        "tasks": len(apart),
        "median": float(np.median(apart)),
        "rms": float(np.sqrt((apart**2).mean())),
        "r2": float(1 - left),
        "kind": float(np.mean([one.kind == two.kind for one, two in zip(ones, others, strict=True)])),
    }


def tables(effects: Mapping[str, Any], shares: Mapping[str, Any]) -> str:
    """Write how effects differ, and what plans reach where they were learned, and in the other engine."""
    tried = list[list[str]]()
    for way in WAYS:
        for total, cells in WAYS[way].points.items():
            known = shares.get(way, {}).get(str(total), {})
            for cell in cells:
                if cell.engine and cell.name in known:
                    tried += _rows(way, cell.engine, cell.name, known)
    heads = (
        "random actions | tasks | median distance [mm] | root mean square [mm] | R2 of x, y | the same kind"
    )
    names = ("tasks", "median:1", "rms:0", "r2:2", "kind:0%")
    found = "learned in | tried in | tasks | seeds | followed blindly | replanned"
    return f"{figures_table(heads, effects, *names)}\n\n{table(found, tried)}"


def _rows(way: str, engine: str, name: str, known: Mapping[str, Any]) -> list[list[str]]:
    """Write what was reached in the engine that taught, and in another one."""
    own, plain = str(WAYS[way].options.get("engine", ENGINES[0])), name.removeprefix(f"{engine}-")
    rows = []
    for where, cell in ((own, plain), (engine, name)):
        told = known[cell]
        ways = [with_interval(mean_of(told[how]), told["tasks"]) for how in figures.WAYS]
        rows.append([own, where, plain, str(len(told["blind"])), *ways])
    return rows
