"""Towers from a camera: relations are learned where single objects were, and geometry says what stands."""

import shutil
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any
from unittest.mock import patch

from neurosym.commands.pipeline import run
from neurosym.sim.camera_world import CameraWorld
from neurosym.stages.folder import DomainFolder
from neurosym.stages.rounds import budget_of
from neurosym.world import World
from tools.benchmarks.budget.ways import TOWERS
from tools.benchmarks.relations import symbols
from tools.benchmarks.relations.tasks import Asked, cells
from tools.benchmarks.relations.trying import try_all

RELATIONS = 1024  # interactions that explore pairs at most
FIRST_TOWER, NEW_PAIRS = 856_000, 858_000  # seeds of the first task, and of pairs that tell what states mean
_PAIRS = 3000  # so many new pairs are drawn for that
_NEXT = 1_000_000  # from the seed of a task whose objects are not told apart to the one in its place


def relate(learned: Path, folder: Path, seed: int) -> dict[str, Any]:
    """Learn pairs beside what a folder has learned of single objects; say what states mean.

    Args:
        learned: The folder that `run` learned in.
        folder: Where what comes of it goes.
        seed: Where all draws start.
    """
    if not folder.exists():
        draft = folder.with_name(f"{folder.name}-draft")
        shutil.rmtree(draft, ignore_errors=True)
        shutil.copytree(learned, draft).rename(folder)
    run(folder, seed=seed, relations=RELATIONS, workers=1, problems=0)
    with patch.object(symbols, "PAIRS", _PAIRS):
        words = symbols.words_of(folder, NEW_PAIRS + seed, workers=1)
    return {"interactions": budget_of(DomainFolder(folder)).total, "words": words}


def build(folder: Path, words: dict[str, list[str]], seeds: Sequence[int]) -> list[Any]:
    """Try to build towers of three."""
    return try_all(folder, words, _draw, seeds)


def _draw(world: World, seed: int) -> Asked:
    """Draw a tower that a person can build, as it is seen where there is a camera."""
    (draw,) = (draw for name, draw, _ in cells(1) if name == TOWERS)
    if not isinstance(world, CameraWorld):
        return draw(world, seed)
    asked = draw(world.table_world, seed)
    if (start := world.seen(asked.start)) is None:
        return _draw(world, seed + _NEXT)
    return replace(asked, start=start)
