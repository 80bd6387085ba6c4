"""Learn `domains/camera` again, try its problems, and describe what was measured.

The command is `python -m tools.relearn_camera`. Resumable: start it again after an interruption, and nothing
is done twice. None of the problems is removed.
"""

from pathlib import Path

from neurosym.commands.pipeline import run
from neurosym.grounding import Grounding
from neurosym.operators import Category, OperatorTable
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import PRIMITIVES
from neurosym.stages.problem_making import Asked
from tools import relearn_tabletop as described
from tools.benchmarks.tables import table
from tools.relearn_places import PLANNER, TASKS
from tools.relearn_tabletop import try_and_describe

FOLDER = Path("domains/camera")
INTERACTIONS, SEED = 6000, 1
SIZES = 3  # so many of the features are lengths


def main() -> None:
    """Learn, try, describe."""
    run(FOLDER, world="camera", interactions=INTERACTIONS, seed=SEED, problems=0)
    every = enumerate(((kind, objects) for kind, objects, count in TASKS for _ in range(count)), start=1)
    asked = {f"{kind}-{n}-{i:02d}": Asked(n, task=kind, seed=SEED + i) for i, (kind, n) in every}
    try_and_describe(FOLDER, sections, lambda _: asked, (PLANNER,))


def sections(folder: DomainFolder) -> list[str]:
    """Write the README, a text for each section."""
    grounding = Grounding.load(folder / "grounding.json")
    assert grounding.places is not None, "places were learned"
    command = (
        f"neurosym run {folder.path} --world camera --interactions {INTERACTIONS} --seed {SEED} --problems 0"
    )
    return [
        "# The tabletop, as a camera sees it",
        "Objects are known by their crops in a depth image, which an eye tells in five numbers; see "
        "[from a camera](../../docs/camera.md). Networks are shown nothing else of them. The eye "
        f"learned from 2,000 random actions, and all else from {INTERACTIONS:,} interactions at most. "
        "`tools/relearn_camera.py` writes this file from what it measured. Nothing in this folder is "
        "edited by hand, and no problem was removed.",
        "## How it was made",
        f"`python -m tools.relearn_camera`, that is `{command}`, `neurosym compile-domain {folder.path}` and "
        "then its problems.",
        "## Object symbols",
        "Sizes are as they are seen, and no network was shown them.",
        _categories(OperatorTable.load(folder / PRIMITIVES).categories),
        "## What carries",
        "What each action that is aimed at a place did to the objects of each category when it was "
        "rehearsed. *As promised*: within 50 mm of the mean, as it is seen.",
        described.operators_table(grounding.places.operators, grounding),
        "## Problems",
        f"Problem number i is drawn with seed {SEED} + i, as in [domains/places](../places/README.md), and "
        "*reached* is told as objects are seen.",
        *described.problems_table(folder, (PLANNER,)),
    ]


def _categories(categories: tuple[Category, ...]) -> str:
    """Say which objects are in which category."""
    rows = []
    for one in (one for one in categories if one.share):
        pairs = zip(one.feature_means, one.feature_spreads, strict=True)
        told = [
            f"{1000 * mean:.0f} ± {1000 * spread:.0f}" if number < SIZES else f"{mean:.1f} ± {spread:.1f}"
            for number, (mean, spread) in enumerate(pairs)
        ]
        rows.append([one.symbol, one.name, f"{one.share:.0%}", *told])
    columns = ["bits", "name", "share", "s_x [mm]", "s_y [mm]", "d [mm]", "v1", "v2", "v3", "v4", "v5"]
    return table(columns, rows)


if __name__ == "__main__":
    main()
