"""Learn `domains/camera` again, try its problems, and describe what was measured.

The command is `python -m tools.relearn_camera`. Resumable: start it again after an interruption, and nothing
is done twice. None of the problems is removed.
"""

from pathlib import Path

from neurosym.commands.pipeline import run
from neurosym.operators import OperatorTable
from neurosym.sim.camera_world import SIZES, CameraWorld
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import PRIMITIVES
from neurosym.stages.rounds import budget_of
from tools.relearn_places import PLANNER, SEED, asked_for
from tools.relearn_tabletop import categories_table, problems_table, try_and_describe

FOLDER = Path("domains/camera")
SEEN = CameraWorld.feature_names[len(SIZES) :]


def main() -> None:
    """Learn, try, describe."""
    run(FOLDER, world=CameraWorld.name, seed=SEED, problems=0)
    try_and_describe(FOLDER, sections, asked_for, (PLANNER,))


def sections(folder: DomainFolder) -> list[str]:
    """Write the README, a text for each section."""
    command = f"neurosym run {folder.path} --world {CameraWorld.name} --seed {SEED} --problems 0"
    return [
        "# The tabletop, from a camera",
        f"Objects are known by what a depth camera sees. {budget_of(folder).total:,} interactions were "
        "performed in all; those that taught the eye are among them. [From a camera](../../docs/camera.md) "
        "says what each part is shown. `tools/relearn_camera.py` writes this file from what it measured. "
        "Nothing in this folder is edited by hand, and no problem was removed.",
        "## How it was made",
        f"`python -m tools.relearn_camera`, that is `{command}` and then its problems.",
        "## Object symbols",
        "The bits of a category tell of five numbers, in which the eye tells a crop. Sizes are as they are "
        "seen; no network is shown them.",
        categories_table(OperatorTable.load(folder / PRIMITIVES).categories, SEEN),
        "## Problems",
        f"Problem number i is drawn with seed {SEED} + i, and is of a kind as in "
        "[places](../places/README.md). *Reached*: whether every object was seen within 50 mm of its goal in "
        "the end, planned anew where a step did something else.",
        *problems_table(folder, (PLANNER,)),
    ]


if __name__ == "__main__":
    main()
