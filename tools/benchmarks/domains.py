"""Domains that are measured: learned as by the command line, loaded, and kept beside the results."""

import shutil
import time
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from neurosym.commands.learn import init
from neurosym.data.origin import StrategyName
from neurosym.evaluation.comparison import Bench
from neurosym.pddl.compiler import CELL
from neurosym.stages.compilation import compile_stage
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import WORLD
from neurosym.stages.learning import OBJECTS, Aim, distill_stage, explore_stage, train_stage
from tools.benchmarks.jobs import pack, unpack

REGIME = "default"
REHEARSALS = 100


def explored(
    folder: Path, strategy: StrategyName, seed: int, steps: int, aim: Aim = OBJECTS, workers: int = 1
) -> DomainFolder:
    """Explore, unless that was done."""
    if not (folder / WORLD).exists():
        init(folder)
    domain = DomainFolder(folder)
    stage = explore_stage(
        domain, aim, strategy=strategy, steps=steps, seed=seed, regime=REGIME, workers=workers
    )
    domain.perform(stage, again=False)
    return domain


def learn(
    folder: Path,
    strategy: StrategyName,
    seed: int,
    steps: int,
    aim: Aim = OBJECTS,
    *,
    choice: str = "own",
    **bits: Any,
) -> dict[str, float]:
    """Explore, train and distil, each unless it was done.

    Args:
        folder: The domain folder; it is made if there is none.
        strategy: How interactions are chosen.
        seed: Where all random draws start.
        steps: How many interactions there shall be.
        aim: What they are aimed at.
        choice: Which candidates stand for a symbol.
        bits: Bits of symbols, if not the usual ones.

    Returns:
        What each stage took in this process, by its name [CPU s].
    """
    begin, seconds = time.process_time(), {}
    domain = explored(folder, strategy, seed, steps, aim)
    seconds[aim.stage("explore")] = round(time.process_time() - begin, 1)
    for stage in (
        train_stage(domain, aim, seed=seed, regime=REGIME, **bits),
        distill_stage(domain, aim, objects=REHEARSALS, seed=seed, workers=1, choice=choice),
    ):
        begin = time.process_time()
        domain.perform(stage, again=False)
        seconds[stage.name] = round(time.process_time() - begin, 1)
    return seconds


def compiled(folder: Path) -> None:
    """Print the domain, unless that was done."""
    domain = DomainFolder(folder)
    domain.perform(compile_stage(domain, cell=CELL), again=False)


@cache
def bench_of(folder: Path) -> Bench:
    """Load a domain folder, once in each process."""
    return Bench(DomainFolder(folder))


def keep(work: Path, archive: Path, files: Callable[[Path], Iterator[str]]) -> None:
    """Put what it takes to try the learned domains into an archive.

    Args:
        work: Where a folder for each seed lies.
        archive: The archive.
        files: Says which files of such a folder are kept.
    """
    with TemporaryDirectory() as flat:
        for folder in sorted(work.glob("seed-*")):
            for name in files(folder):
                shutil.copy(folder / name, Path(flat) / f"{folder.name}.{Path(name).name}")
        pack(Path(flat), archive, "seed-*")


def restore(archive: Path, work: Path, inside: str = "") -> None:
    """Take from an archive what `keep` put there, for domains that are not in the working folder yet."""
    with TemporaryDirectory() as flat:
        unpack(archive, Path(flat))
        for path in Path(flat).iterdir():
            folder, name = path.name.split(".", 1)
            target = work / folder / inside / name
            if not target.exists():
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(path, target)
