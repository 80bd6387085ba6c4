"""Domains with places: how each is learned, and how surely it carries."""

import math
import shutil
from pathlib import Path
from typing import Any

import numpy as np

from neurosym.commands.learn import init
from neurosym.data.origin import StrategyName
from neurosym.grounding import Grounding
from neurosym.operators import OperatorTable
from neurosym.pair_operators import PlaceOperators
from neurosym.pddl.compiler import CELL
from neurosym.stages.compilation import compile_stage
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import GROUNDING, MODEL, PLACE_OPERATORS, WORLD
from neurosym.stages.learning import TO_PLACES, distill_stage, explore_stage, train_stage
from tools.benchmarks.carrying import tasks
from tools.benchmarks.planning.measures import REHEARSALS

STRATEGY: StrategyName = "disagreement"
REGIME = "default"
WITHIN = 0.015
"""So near to what an operator does on average does a rehearsal end right [m]."""


def learn(folder: Path, seed: int, steps: int, places: int) -> dict[str, Any]:
    """Learn a domain with places; what was done is not done again.

    Returns:
        How well it carries graspable objects; see `carries`.
    """
    if (folder / GROUNDING).exists():
        return carries(_carriers(folder))
    if not (folder / WORLD).exists():
        init(folder)
    domain = DomainFolder(folder)
    for stage in (
        explore_stage(domain, strategy=STRATEGY, steps=steps, seed=seed, regime=REGIME, workers=1),
        train_stage(domain, seed=seed, regime=REGIME),
        distill_stage(domain, objects=REHEARSALS, seed=seed, workers=1),
    ):
        domain.perform(stage, again=False)
    _learn_places(domain, STRATEGY, seed, places)
    domain.perform(compile_stage(domain, cell=CELL), again=False)
    return carries(_carriers(folder))


def learn_at_random(learned: Path, folder: Path, seed: int, places: int) -> dict[str, Any]:
    """Learn once more what carries, from as many actions at random; what was done is not done again.

    Returns:
        How well it carries graspable objects; see `carries`.
    """
    folder.mkdir(exist_ok=True)
    for name in (WORLD, MODEL):
        shutil.copy(learned / name, folder / name)
    _learn_places(DomainFolder(folder), "random", seed, places)
    return carries(PlaceOperators.load(folder / PLACE_OPERATORS).operators)


def _learn_places(domain: DomainFolder, strategy: StrategyName, seed: int, places: int) -> None:
    for stage in (
        explore_stage(
            domain, TO_PLACES, strategy=strategy, steps=places, seed=seed, regime=REGIME, workers=1
        ),
        train_stage(domain, TO_PLACES, seed=seed, regime=REGIME),
        distill_stage(domain, TO_PLACES, objects=REHEARSALS, seed=seed, workers=1),
    ):
        domain.perform(stage, again=False)


def _carriers(folder: Path) -> OperatorTable:
    places = Grounding.load(folder / GROUNDING).places
    assert places is not None, "places were learned"
    return places.operators


def carries(table: OperatorTable) -> dict[str, Any]:
    """Say how often the best action symbol carries graspable objects, and how nearly alike.

    Returns:
        Of that symbol: the share of rehearsals on graspable objects, drawn as the world draws them, that end
        within 15 mm of what the operator does on average; and the median distance from it [mm].
    """
    best: dict[str, Any] = {"symbol": "", "right": 0.0, "median_mm": math.nan}
    objects = {category.symbol: category.objects for category in table.categories}
    for symbol in table.symbols:
        away = []
        for one in (one for one in table.operators if one.primitive == symbol):
            rows = zip(one.rehearsals[: one.trials], one.objects or objects[one.category], strict=False)
            ends = [row for row, features in rows if tasks.is_graspable(np.array(features))]
            centre = one.promise.outcome if one.promise and one.promise.kind == "carried" else None
            away += [
                math.dist(row.outcome, centre) if centre and row.kind == "carried" else math.inf
                for row in ends
            ]
        right = float(np.mean([distance <= WITHIN for distance in away])) if away else 0.0
        if right > best["right"]:
            best = {"symbol": symbol, "right": right, "median_mm": 1000 * float(np.median(away))}
    return best
