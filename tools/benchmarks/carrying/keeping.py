"""Learned domains, kept beside the results so that more tasks can be tried on them later."""

import filecmp
import shutil
from pathlib import Path
from tempfile import TemporaryDirectory

from neurosym.stages.layout import GROUNDING, MODEL, WORLD
from tools.benchmarks.jobs import pack, unpack
from tools.relearn_places import FOLDER as SHIPPED
from tools.relearn_places import SEED

KEPT = (WORLD, MODEL, GROUNDING)
"""What is needed of a learned domain to try it."""


def keep(work: Path, archive: Path) -> None:
    """Put what it takes to try the learned domains into an archive, but for the one that is shipped."""
    with TemporaryDirectory() as flat:
        for path in work.glob("seed-*/*"):
            if path.name in KEPT and is_worth_keeping(path.parent / GROUNDING):
                shutil.copy(path, Path(flat) / f"{path.parent.name}.{path.name}")
        pack(Path(flat), archive, "seed-*")


def is_worth_keeping(grounding: Path) -> bool:
    """Say whether a domain was learned, and is not the shipped one."""
    shipped = SHIPPED / GROUNDING
    return grounding.exists() and not (shipped.exists() and filecmp.cmp(grounding, shipped, shallow=False))


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


def take_shipped(work: Path) -> None:
    """Copy the shipped domain, which is that of its seed, unless it is there."""
    if SHIPPED.exists() and not (work / f"seed-{SEED}").exists():
        shutil.copytree(SHIPPED, work / f"seed-{SEED}")
