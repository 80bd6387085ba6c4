"""Learn `domains/places` again, try its problems, and describe what was measured.

The command is `python -m tools.relearn_places`. Resumable: start it again after an interruption, and nothing
is done twice. None of the problems is removed.
"""

from pathlib import Path

from neurosym.choices import CELL, TaskKind
from neurosym.commands.arguments import CPUS
from neurosym.commands.pipeline import run
from neurosym.grounding import Grounding
from neurosym.operators import Mode, OperatorTable
from neurosym.stages.compilation import compile_stage
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import PRIMITIVES
from neurosym.stages.learning import upright_stage
from neurosym.stages.problem_making import Asked
from tools import relearn_tabletop as described
from tools.benchmarks.tables import table
from tools.relearn_tabletop import STAGES, try_and_describe

FOLDER = Path("domains/places")
STEPS, PLACES, UPRIGHT, SEED = 8000, 2000, 500, 1
PLANNER = "fast-downward"
TASKS: tuple[tuple[TaskKind, int, int], ...] = (
    *(("anywhere", 1, 3), ("anywhere", 2, 2), ("swap", 2, 2), ("anywhere", 3, 1), ("swap", 3, 1)),
    *(("row", 3, 1), ("row", 4, 2), ("anywhere", 4, 2), ("crowded", 3, 1), ("crowded", 4, 2)),
    *(("anywhere", 6, 1), ("anywhere", 8, 2)),
)  # what problems ask for, with how many objects, and how many of them there are


def main() -> None:
    """Learn, try, describe."""
    run(FOLDER, steps=STEPS, places=PLACES, seed=SEED, problems=0)
    folder = DomainFolder(FOLDER)
    folder.perform(upright_stage(folder, tries=UPRIGHT, objects=100, seed=SEED, workers=CPUS), again=False)
    folder.perform(compile_stage(folder, cell=CELL, name=FOLDER.name), again=False)
    try_and_describe(FOLDER, sections, asked_for, (PLANNER,))


def asked_for(_: DomainFolder) -> dict[str, Asked]:
    """Say what is asked for in each problem."""
    every = enumerate(((kind, objects) for kind, objects, count in TASKS for _ in range(count)), start=1)
    return {f"{kind}-{n}-{i:02d}": Asked(n, task=kind, seed=SEED + i) for i, (kind, n) in every}


def sections(folder: DomainFolder) -> list[str]:
    """Write the README, a text for each section."""
    grounding = Grounding.load(folder / "grounding.json")
    assert grounding.places is not None, "places were learned"
    assert grounding.upright is not None, "what sets upright was learned"
    command = f"neurosym run {folder.path} --steps {STEPS} --places {PLACES} --seed {SEED} --problems 0"
    upright = f"neurosym distill {folder.path} --upright {UPRIGHT} --seed {SEED}"
    return [
        "# The tabletop domain, with places",
        "Objects that the hand can grasp are carried to their goals in one motion, wherever on the table "
        f"these are. The robot learned with the paper's budget. {STEPS:,} interactions are as in "
        f"[domains/tabletop](../tabletop/README.md). {PLACES:,} more were each aimed at a place drawn "
        "from the whole table. That is one in five: one action is to be found that carries, and the others "
        "have many things to tell. `tools/relearn_places.py` writes this file from what it measured. Nothing "
        "in this folder is edited by hand, and no problem was removed.",
        "## How it was made",
        f"`python -m tools.relearn_places`, that is `{command}`, `{upright}`, `neurosym compile-domain "
        f"{folder.path}` and then its problems. Minutes on 2 cores:",
        described.stages_table(
            folder, (*STAGES[:3], *(f"{name}-places" for name in STAGES[:3]), "distill-upright", STAGES[3])
        ),
        "## Object symbols",
        "Types: 0 solid (boxes, planks), 1 open at the top, 2 open at both ends (rings).",
        described.categories_table(OperatorTable.load(folder / PRIMITIVES).categories),
        "## What carries",
        "What each action that is aimed at a place did to the objects of each category when it was "
        "rehearsed. The effect is where the object stands, seen from the place; the hand aims beside it by "
        "as much. *As promised*: within 50 mm of that. "
        "`neurosym explain` tells in words what pushes and lifts.",
        described.operators_table(grounding.places.operators, grounding),
        "## What sets things upright",
        f"Of {UPRIGHT} random actions on things that lay on a side, the best for each side. It was performed "
        "on 100 others that were laid so; what did not stay on that side by itself is not counted.",
        table(
            ["operator", "set upright", "moves it by [mm]"],
            [
                [one.name, f"{one.promise.count} of {one.trials}", _moved_by(one.promise)]
                for one in grounding.upright.operators
                if one.promise
            ],
        ),
        "## Problems",
        f"Problem number i is drawn with seed {SEED} + i. In *anywhere*, goals lie all over the table, at "
        "least 15 cm away. In *swap*, two or three objects change places. A *row* goes across the table, "
        "and in a *crowd* objects stand within 5 cm of the next. Objects are of all shapes; some can only be "
        "pushed. *Reached*: whether every object ended within 50 mm of its goal in the simulator, planned "
        "anew where a step did something else. Breadth-first search knows no places, and is not asked.",
        *described.problems_table(folder, (PLANNER,)),
    ]


def _moved_by(promise: Mode) -> str:
    return ", ".join(f"{1000 * part:.0f}" for part in promise.resting_effect[:2])


if __name__ == "__main__":
    main()
