"""Learn `domains/towers` again, try its problems, and describe what was measured.

The command is `python -m tools.relearn_towers`. Resumable: start it again after an interruption, and nothing
is done twice. What `domains/places` learned is taken from there, since the same seed gives the same bytes.
None of the problems is removed.
"""

import shutil
from pathlib import Path

from neurosym.choices import AnyTask
from neurosym.commands.pipeline import run
from neurosym.files import make_folder, write_json
from neurosym.grounding import Grounding
from neurosym.pair_operators import OF_PAIRS, RelationOperators
from neurosym.stages.folder import DomainFolder, Manifest
from neurosym.stages.layout import GROUNDING, MANIFEST
from neurosym.stages.problem_making import Asked
from tools.benchmarks.tables import table
from tools.relearn_places import FOLDER as LEARNED
from tools.relearn_places import PLACES, PLANNER, SEED, STEPS
from tools.relearn_tabletop import STAGES, problems_table, stages_table, try_and_describe

FOLDER = Path("domains/towers")
RELATIONS = 10_240  # interactions that are aimed at other objects
TASKS: dict[AnyTask, tuple[tuple[int, int, int], ...]] = {
    "tower": ((2, 2, 2), (4, 3, 2), (6, 3, 2), (6, 4, 2), (8, 4, 1)),
    "boxes": ((4, 3, 2), (6, 3, 2)),
    "unstack": ((5, 3, 2), (6, 3, 1)),
    "exchange": ((4, 3, 1), (6, 3, 1)),
    "anywhere": ((4, 3, 1), (8, 3, 1)),
}  # what problems ask for, with how many objects, how high towers are, and how many of them there are
RESTING: tuple[AnyTask, ...] = ("tower", "unstack", "exchange")
"""These ask for the state in which targets rest on their references, and not for any."""
_MOST_OPERATORS = 40


def main() -> None:
    """Learn, try, describe."""
    take_places(LEARNED, FOLDER)
    run(FOLDER, steps=STEPS, places=PLACES, relations=RELATIONS, seed=SEED, problems=0)
    try_and_describe(FOLDER, sections, asked_for, (PLANNER,))


def asked_for(folder: DomainFolder) -> dict[str, Asked]:
    """Say what is asked for in each problem."""
    resting = state_called("rests-on", folder)
    every = [(kind, *size) for kind, rows in TASKS.items() for *size, count in rows for _ in range(count)]
    found = {}
    for number, (kind, objects, height) in enumerate(every, start=1):
        asked = Asked(
            objects, seed=SEED + number, task=kind, height=height, state=resting * (kind in RESTING)
        )
        found[f"{kind}-{objects}-{number:02d}"] = asked
    return found


def take_places(learned: Path, folder: Path) -> None:
    """Begin a domain folder with what another one learned of single objects, unless there is one."""
    if not folder.exists():
        before = DomainFolder(learned).manifest().stages
        stages = {name: one for name, one in before.items() if name.split("-")[0] in STAGES[:3]}
        for name in [name for one in stages.values() for name in (*one.inputs, *one.outputs)]:
            make_folder((folder / name).parent)
            shutil.copy(learned / name, folder / name)
        write_json(folder / MANIFEST, Manifest(stages=stages))


def state_called(word: str, folder: DomainFolder) -> str:
    """Return the first state whose name begins so."""
    relations = Grounding.load(folder / GROUNDING).relations
    assert relations is not None, "relations were learned"
    return next(state.name for state in relations.states if state.bears and state.name.startswith(word))


def sections(folder: DomainFolder) -> list[str]:
    """Write the README, a text for each section."""
    grounding = Grounding.load(folder / GROUNDING)
    relations = grounding.relations
    assert relations is not None, "relations were learned"
    sizes = f"--steps {STEPS} --places {PLACES} --relations {RELATIONS}"
    command = f"neurosym run {folder.path} {sizes} --seed {SEED} --problems 0"
    names = [f"{name}{of}" for of in ("", "-places", "-relations") for name in STAGES[:3]]
    return [
        "# The tabletop domain, with places and relations",
        "Objects are put on and into one another, and carried to their goals on the table. The robot learned "
        f"the former from {RELATIONS:,} interactions, each aimed at another object. It began with what "
        "[domains/places](../places/README.md) had learned. Nobody told it a relation: states of pairs are "
        "codes of learned bits, and their names are made from numbers that were measured. "
        "`tools/relearn_towers.py` writes this file. Nothing in this folder is edited by hand, and no "
        "problem was removed.",
        "## How it was made",
        f"`python -m tools.relearn_towers`, that is `{command}` and then its problems. Minutes on 2 cores, "
        "without what a run that was interrupted had performed before:",
        stages_table(folder, (*names, STAGES[3])),
        "## States of pairs",
        "How a target stands to a reference. *Away* and *above* are distances in sums of half sizes: at 1 "
        "the two touch. *Tilted* is a share of 20 degrees.",
        _states(relations),
        "## What can be done with pairs",
        "What each action did to pairs of a kind when it was rehearsed; those that do it most often. "
        "A third object may stand in the way: *borne*, the target rests on one; *occupied*, one rests on the "
        "reference; *laden*, one rests on the target.",
        _operators(relations),
        "## Problems",
        f"Problem number i is drawn with seed {SEED} + i. A *tower* shall be built of some of the objects, "
        "and in *boxes* half of them shall each be on or in one of its own. *Unstack* begins with a stack "
        "to be sorted so; in *exchange*, two things that others bear change places. These three ask "
        "for the state in which things rest on others. In *anywhere*, goals lie all over the table. "
        "*Reached*: whether the learned states say so at the end, with replanning.",
        *problems_table(folder, (PLANNER,)),
    ]


def _states(relations: RelationOperators) -> str:
    rows = [
        [state.symbol, state.name, *(f"{value:.2f}" for value in state.centre), "yes" if state.bears else ""]
        for state in relations.states
    ]
    return table(["bits", "name", "away", "above", "touching", "tilted", "bears"], rows)


def _operators(relations: RelationOperators) -> str:
    out = relations.left_out
    kept = [(one, one.promise) for one in relations.operators if one.name not in out and one.promise]
    kept.sort(key=lambda pair: -pair[1].share)
    rows = [
        [one.name, f"{promise.count} of {one.trials}"]
        + [f"{case.kept} of {case.trials}" for case in map(one.among, OF_PAIRS)]
        for one, promise in kept[:_MOST_OPERATORS]
    ]
    return table(["operator", "as promised", "borne", "occupied", "laden"], rows)


if __name__ == "__main__":
    main()
