"""By how much do the codes differ that were learned in several ways, and how much do they tell?

Random actions are performed once. Each network groups them by its symbols of actions. The adjusted Rand index
of two groupings is 1 where they are the same, and 0 where they agree no more than by chance (Hubert and
Arabie, 1985).
"""

from collections.abc import Mapping
from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np

from neurosym.data.interactions import Interactions
from neurosym.learning.network import EffectModel
from neurosym.learning.training import r_squared
from neurosym.sim.tabletop import Tabletop
from neurosym.stages import layout
from neurosym.worlds.workers import perform_all
from tools.benchmarks.budget.ways import STAGES
from tools.benchmarks.jobs import Found
from tools.benchmarks.tables import mean_of, number, table
from tools.benchmarks.world.measures import random_tasks

PREFIX = "codes-"  # of the names of jobs, before those of domains
COMPARED = ("one-budget", "random", "entropy", STAGES)
_TESTED, _SEED = 1000, 792_000


def test(work: Path) -> int:
    """Perform random actions, keep them, and say how many."""
    drawn = random_tasks(_TESTED, _SEED)
    outcomes = perform_all(Tabletop, drawn, 1)
    seen = Interactions.from_outcomes([*outcomes], np.array([task.action for task in drawn]), {})
    seen.save(work / "codes.npz")
    return len(seen)


def judge(work: Path, folder: Path) -> dict[str, Any]:
    """Say what a network explains of random actions by their codes, and which symbols it gives them."""
    if not (work / "codes.npz").exists():  # on another machine than the job that performed them
        test(work)
    model, seen = EffectModel.load(folder / layout.MODEL), Interactions.load(work / "codes.npz")
    mean, _ = model.predict_from_codes(seen.features, seen.actions)
    explained = r_squared(mean, np.asarray(seen.effects, dtype=float))
    return {"r2": float(explained.mean()), "symbols": " ".join(model.action_symbols(seen.actions))}


def agreement(one: str, other: str) -> float:
    """Return the adjusted Rand index of two groupings, each of which names the group of each item."""
    first, second = (np.unique(groups.split(), return_inverse=True)[1] for groups in (one, other))
    both = np.zeros((first.max() + 1, second.max() + 1))
    np.add.at(both, (first, second), 1)
    together, rows, columns, pairs = (
        (counts * (counts - 1) / 2).sum()
        for counts in (both, both.sum(axis=1), both.sum(axis=0), np.array([len(first)]))
    )
    chance, most = rows * columns / pairs, (rows + columns) / 2
    return float((together - chance) / (most - chance)) if most > chance else 1.0


def summarise(found: Found) -> dict[str, Any]:
    """Gather, by interactions, what codes explain and how alike they are: of two ways, and of two seeds."""
    judged: dict[int, dict[tuple[str, str], Any]] = {}
    for name in [name.removeprefix(PREFIX) for name in found if name.startswith(PREFIX)]:
        way, seed, total = name.rsplit("-", 2)
        if way in COMPARED:
            judged.setdefault(int(total), {})[way, seed] = found[PREFIX + name]
    summary = dict[str, Any]()
    for total, domains in sorted(judged.items()):
        alike: dict[str, list[float]] = {}
        for (way, seed), (other, its_seed) in combinations(sorted(domains), 2):
            if seed == its_seed or way == other:
                ways = " and ".join(sorted({way, other}, key=COMPARED.index))
                symbols = domains[way, seed]["symbols"], domains[other, its_seed]["symbols"]
                alike.setdefault(ways, []).append(agreement(*symbols))
        told = {way: [one["r2"] for (its, _), one in domains.items() if its == way] for way in COMPARED}
        summary[str(total)] = {"r2": told, "alike": alike}
    return summary


def tables(summary: Mapping[str, Any]) -> str:
    """Write how much codes explain, and how alike the groups of actions are."""
    rows = [
        [f"{label}{of}", *(number(mean_of(told[key].get(of, ()))) for told in summary.values())]
        for key, label in (("r2", "R2 through codes of "), ("alike", "groups of "))
        for of in dict.fromkeys(name for told in summary.values() for name in told[key])
    ]
    return table(["", *(f"after {int(total):,}" for total in summary)], rows)
