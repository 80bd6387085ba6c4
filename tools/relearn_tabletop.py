"""Learn the shipped domains again, try their problems with both planners, and describe what was measured.

`python tools/relearn_tabletop.py` learns `domains/tabletop`, and with `--paper` `domains/tabletop-paper`,
whose symbols have as many bits as the paper's. Resumable: start it again after an interruption, and nothing
is done twice. None of the problems is removed.
"""

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Annotated

import tyro

from neurosym.commands.pipeline import run
from neurosym.errors import counted
from neurosym.files import read_json, write_atomically
from neurosym.grounding import Grounding
from neurosym.learning.training_config import DEFAULT_BITS, PAPER_BITS
from neurosym.learning.training_report import TrainingReport
from neurosym.operators import Category, Operator, OperatorTable
from neurosym.pddl.compiler import CELL
from neurosym.stages.compilation import compile_stage
from neurosym.stages.console import say
from neurosym.stages.execution import execute_stage, load_run
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import GROUNDING, PRIMITIVES, TRAINING, plan_files
from neurosym.stages.plan_records import PlanRecord, written_steps
from neurosym.stages.planning import load_problem, plan_stage
from neurosym.stages.problem_making import Asked, problem_stage
from tools.benchmarks.tables import table

TABLETOP = Path("domains/tabletop")
STEPS, SEED = 10_000, 1
RISING = {(1, 1): 4, (1, 2): 2, (2, 1): 4, (2, 2): 2, (3, 2): 2, (4, 3): 2, (6, 4): 2, (8, 6): 2}
"""How many problems there are, by their objects and the random actions that lead to their goals."""
PLANNERS = ("bfs", "fast-downward")
STAGES = ("explore", "train", "distill", "compile-domain")


def main(
    *, paper: Annotated[bool, tyro.conf.arg(help="Learn the one with the paper's bits instead.")] = False
) -> None:
    """Learn, try, describe."""
    path = TABLETOP.with_name("tabletop-paper") if paper else TABLETOP
    bits = PAPER_BITS if paper else DEFAULT_BITS
    run(path, steps=STEPS, seed=SEED, problems=0, object_bits=bits[0], action_bits=bits[1], places=0)
    sizes = enumerate((size for size, problems in RISING.items() for _ in range(problems)), start=1)
    asked = {f"task-{number:02d}": Asked(*size, SEED + number) for number, size in sizes}
    try_and_describe(path, lambda folder: sections(folder, bits), lambda _: asked, PLANNERS)


def try_and_describe(
    path: Path,
    sections: Callable[[DomainFolder], list[str]],
    asked: Callable[[DomainFolder], Mapping[str, Asked]],
    planners: Sequence[str],
) -> None:
    """Try problems in a domain folder that was learned, and describe it; what was done is not done again."""
    folder = DomainFolder(path)
    if Grounding.load(folder / GROUNDING).name != path.name:
        folder.perform(compile_stage(folder, cell=CELL, name=path.name), again=True)
    for name, problem in asked(folder).items():
        folder.perform(problem_stage(folder, name, problem), again=False)
        for planner in planners:
            folder.perform(plan_stage(folder, name, planner=planner), again=False)
            solved = read_json(folder / plan_files(name, planner)[1], PlanRecord).solved
            if solved and (plan_file := written_steps(folder, name, planner)):
                folder.perform(execute_stage(folder, name, folder / plan_file), again=False)
    write_atomically(path / "README.md", "\n\n".join(sections(folder)) + "\n")
    say(f"wrote {path / 'README.md'}")


def sections(folder: DomainFolder, bits: tuple[int, int]) -> list[str]:
    """Write the README, a text for each section."""
    is_paper = bits == PAPER_BITS
    table = OperatorTable.load(folder / PRIMITIVES)
    grounding = Grounding.load(folder / "grounding.json")
    command = f"neurosym run {folder.path} --steps {STEPS} --seed {SEED} --problems 0 --places 0"
    return [
        "# The tabletop domain" + (", with the paper's bits" if is_paper else ""),
        f"Object symbols have {bits[0]} bits, action symbols {bits[1]}"
        + (", as in the paper. " if is_paper else "; `domains/tabletop-paper` has the paper's 2 and 3. ")
        + "Learned by neurosym's own pipeline with the paper's budget: 10,000 interactions of a UR10, each "
        "the one drawn by how much five networks disagreed about it, with boxes, open-topped boxes, planks "
        "and rings of random size. `tools/relearn_tabletop.py` writes this file from what it measured; "
        "nothing in this folder is edited by hand, and no problem was removed.",
        "## How it was made",
        f"`python tools/relearn_tabletop.py{' --paper' * is_paper}`, that is `{command}"
        f"{f' --action-bits {bits[1]}' * is_paper}` and then its problems. Minutes on 2 cores:",
        stages_table(folder),
        "## How well it predicts",
        _training(folder),
        "## Object symbols",
        "Types: 0 solid (boxes, planks), 1 open at the top, 2 open at both ends (rings).",
        categories_table(table.categories),
        "## Action symbols",
        "What each primitive did to the objects of each category when it was rehearsed. Forward is away from "
        "the robot (+x), left is +y. *As promised*: in the promised mode, within 50 mm of its mean. The "
        "page that planners read is [domain.pddl](domain.pddl).",
        operators_table(table.operators, grounding),
        "## Problems",
        f"Problem number i is drawn with seed {SEED} + i, from 1 object and 1 random action up to 8 objects "
        "and 6 actions; each has its PDDL, its PDDL in numbers, and its scene. *Reached*: whether every "
        "object ended within 50 mm of its goal in the simulator; *with new plans*, where it was planned anew "
        "since a step did something else.",
        *problems_table(folder),
    ]


def stages_table(folder: DomainFolder, names: Sequence[str] = STAGES) -> str:
    """Say how long each stage took, and with which versions."""
    stages = folder.manifest().stages
    rows = [[name, f"{stages[name].seconds / 60:.1f}"] for name in names]
    versions = ", ".join(f"{name} {number}" for name, number in stages["explore"].versions.items())
    return f"{table(['stage', 'minutes'], rows)}\n\nVersions: {versions}."


def _training(folder: DomainFolder) -> str:
    report = read_json(folder / TRAINING, TrainingReport)
    rows = [[name, *(f"{1000 * error:.1f}" for error in errors)] for name, errors in report.mae.items()]
    listed = table(["mean absolute error [mm]", "x", "y", "z"], rows)
    return (
        f"On {report.held_out} interactions held out from training, chosen by curiosity. On actions as they "
        "come, to which the decoder is fitted, it does better: see `docs/results/learning.md`.\n\n"
        f"{listed}\n\nR2 of the effect, mean of the axes: "
        f"{report.r2_through_codes:.2f} through the bits, {report.r2_direct:.2f} of a network without a "
        f"bottleneck: a share of {report.share:.2f}."
    )


def categories_table(categories: tuple[Category, ...], besides: Sequence[str] = ("mean type",)) -> str:
    """Say which objects are in which category; features besides sizes have these names."""
    rows = []
    for category in (one for one in categories if one.share):
        means, spreads = category.feature_means, category.feature_spreads
        sizes = [f"{1000 * one:.0f} ± {1000 * by:.0f}" for one, by in zip(means, spreads, strict=True)][:3]
        others = [f"{mean:.1f}" for mean in means[3:]]
        rows.append([category.symbol, category.name, f"{category.share:.0%}", *sizes, *others])
    return table(["bits", "name", "share", "s_x [mm]", "s_y [mm]", "d [mm]", *besides], rows)


def operators_table(operators: tuple[Operator, ...], grounding: Grounding) -> str:
    """Say what each operator did in rehearsal, and whether it is in the domain."""
    columns = ["operator", "ends", "effect [mm]", "spread [mm]", "as promised", "in the domain"]
    rows = []
    for operator in operators:
        told = ["neither held nor upright", "", ""]
        if (promise := operator.promise) is not None:
            told = [f"{promise.kind}, {promise.share:.0%}", *map(_in_mm, (promise.outcome, promise.scatter))]
        kept = f"{operator.successes} of {operator.trials}"
        rows.append([operator.name, *told, kept, grounding.why_left_out(operator) or "yes"])
    return table(columns, rows)


def problems_table(folder: DomainFolder, planners: Sequence[str] = PLANNERS) -> list[str]:
    """Say what came of each problem."""
    rows, found, reached = [], Counter[str](), Counter[str]()
    for name in folder.problem_names():
        rows.append([name, str(len(load_problem(folder, name).objects))])
        for planner in planners:
            record = read_json(folder / plan_files(name, planner)[1], PlanRecord)
            plan_file = written_steps(folder, name, planner)
            if not (record.solved and plan_file):
                rows[-1].append(f"no plan: {record.reason}")
                continue
            run = load_run(folder, name, folder / plan_file)
            found[planner] += 1
            reached[planner] += run.reached
            missed = "" if run.reached else f": {run.reason}"
            steps = counted(record.primitives, "primitive")
            rows[-1].append(f"{steps}, {run.outcome.removeprefix('goal ')}{missed}")
    summary = "; ".join(f"{one}: {found[one]} found, {reached[one]} reached" for one in planners)
    return [table(["problem", "objects", *planners], rows), f"Of {len(rows)} problems, {summary}."]


def _in_mm(vector: Sequence[float]) -> str:
    return ", ".join(f"{1000 * value + 0:.0f}" for value in vector)


if __name__ == "__main__":
    tyro.cli(main)
