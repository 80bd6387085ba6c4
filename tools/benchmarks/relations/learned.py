"""Domains with relations, learned from those with places of the same seeds; and how they are kept."""

import shutil
import time
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import msgspec

from neurosym.data.origin import StrategyName
from neurosym.files import make_folder, write_json
from neurosym.grounding import FORMAT_WITH_RELATIONS, Grounding
from neurosym.pair_operators import RelationOperators
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import (
    GROUNDING,
    MODEL,
    PLACE_OPERATORS,
    PLACES,
    RELATION_CHANCES,
    RELATION_MODEL,
    RELATION_OPERATORS,
    RELATION_STATES,
    WORLD,
)
from neurosym.stages.learning import TO_OBJECTS, distill_stage, explore_stage, train_stage
from tools.benchmarks.jobs import pack
from tools.benchmarks.planning.measures import REHEARSALS
from tools.benchmarks.relations import protocols, symbols
from tools.relearn_places import SEED
from tools.relearn_towers import FOLDER as SHIPPED

REGIME = "default"
NEW_PAIRS = 730_000
"""Added to the seed of a domain, so that it is judged on pairs that it was not learned with."""
KEPT = (RELATION_STATES, RELATION_MODEL, RELATION_CHANCES, RELATION_OPERATORS)
"""What is needed of relations to try a domain; the rest is kept beside the results on places."""


def learn(
    places: Path, folder: Path, seed: int, steps: int, strategy: StrategyName = "disagreement"
) -> dict[str, Any]:
    """Learn relations; what was done is not done again.

    Returns:
        How well its symbols agree with geometry, see `symbols.measure`, how well ends are predicted, see
        `protocols.effect_errors`, and CPU seconds of each stage.
    """
    grounding, seconds = Grounding.load(places / GROUNDING), {}
    copy_start(places, folder)
    if not (folder / RELATION_OPERATORS).exists():
        seconds = _learn(DomainFolder(folder), seed, steps, strategy)
    relations = RelationOperators.load(folder / RELATION_OPERATORS)
    with_relations = msgspec.structs.replace(grounding, relations=relations, format=FORMAT_WITH_RELATIONS)
    with_relations.save(folder / GROUNDING)
    measured = symbols.measure(folder, NEW_PAIRS + seed, workers=1)
    errors = protocols.effect_errors(folder, NEW_PAIRS + seed, workers=1)
    return {**measured, "effect_errors": errors, "cpu_seconds": seconds}


def copy_start(places: Path, folder: Path) -> None:
    """Copy what relations are learned from."""
    make_folder(folder / PLACES)
    for name in (WORLD, MODEL):
        shutil.copy(places / name, folder / name)
    write_json(folder / PLACE_OPERATORS, Grounding.load(places / GROUNDING).places)


def _learn(domain: DomainFolder, seed: int, steps: int, strategy: StrategyName) -> dict[str, float]:
    seconds = {}
    for stage in (
        explore_stage(
            domain, TO_OBJECTS, strategy=strategy, steps=steps, seed=seed, regime=REGIME, workers=1
        ),
        train_stage(domain, TO_OBJECTS, seed=seed, regime=REGIME),
        distill_stage(domain, TO_OBJECTS, objects=REHEARSALS, seed=seed, workers=1),
    ):
        begin = time.process_time()
        domain.perform(stage, again=False)
        seconds[stage.name] = round(time.process_time() - begin, 1)
    return seconds


def keep(work: Path, archive: Path) -> None:
    """Put what it takes to try the learned domains into an archive, but for the one that is shipped."""
    with TemporaryDirectory() as flat:
        for folder in sorted(work.glob("seed-*")):
            is_own = folder.name != f"seed-{SEED}" or not SHIPPED.exists()
            for name in KEPT if is_own and (folder / RELATION_OPERATORS).exists() else ():
                shutil.copy(folder / name, Path(flat) / f"{folder.name}.{Path(name).name}")
        pack(Path(flat), archive, "seed-*")


def take_shipped(work: Path) -> None:
    """Copy what the shipped domain, which is that of its seed, learned of relations, unless it is there."""
    for name in KEPT if SHIPPED.exists() else ():
        target = work / f"seed-{SEED}" / name
        if not target.exists():
            make_folder(target.parent)
            shutil.copy(SHIPPED / name, target)
