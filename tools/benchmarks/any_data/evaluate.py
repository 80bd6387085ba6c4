"""Take six data sets from rows to plans that are performed, into docs/results/any-data.json and any-data.md.

Finished parts are kept and not measured again, so that the run can be interrupted.
"""

import sys
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from importlib.util import find_spec
from pathlib import Path
from typing import Annotated, Any

from tyro.conf import arg

from tools.benchmarks.any_data import learners, way
from tools.benchmarks.any_data.sets import SETS
from tools.benchmarks.jobs import Evaluation, Job, Jobs, machine
from tools.benchmarks.options import RESULTS, Results, Work, begin
from tools.benchmarks.tables import counts, document, listed, mean_of, number, over_seeds, table, tally

DISCS = {"discs": (), "discs-quick": ("--regime", "quick")}  # what is typed after `train`, by name
_HOWS = ("blind", "replanned")
Columns = Mapping[str, Callable[[Any], str]]  # what stands in the columns of a table, by their heads
WHY = (
    "**What an action is.** In the worlds it is a choice. The pendulum has its greatest torque to the left, "
    "none, or to the right, held for 4 steps of the environment (0.2 s). The cube is pushed from one of four "
    "sides, by about 3 or 9 cm, and lies square to the table before each push.",
    "**Key and door.** The bits tell where a move leads, and hold the key and the door, as the "
    "operators say. But the decoder says nothing of these two axes, and R2 is a mean over all four: "
    "few rows of a thousand take the key or turn it, and likelihood (eq. 7) takes these for scatter. "
    "A domain is told from the rows.",
    "**The pendulum.** A category is a range of angles and speeds, so an outcome scatters by more "
    "than a cell, and is held to twice that. Ten steps add it up: blind plans miss, and new ones are "
    "needed all the time.",
)


def jobs_of(work: Path, deepsym: Path | None) -> tuple[Jobs, list[str]]:
    """List what is measured, by name, and say what is missing for the rest."""
    known, missing = list[tuple[int, str, Job]](), list[str]()
    for name, one in SETS.items():
        given = None if one.world else (deepsym or Path()) / name / "interactions.npz"
        if given and not (deepsym and given.is_file()):
            missing.append(f"{name}: name the folder that holds {name}/interactions.npz by --deepsym")
        elif name == "pushing" and not find_spec("panda_gym"):
            missing.append(f"{name}: needs panda-gym (pip install --no-deps panda-gym)")
        else:
            for seed in one.seeds:
                job = partial(way.measured, name, work / "domains" / f"{name}-{seed}", seed, given)
                known.append((seed, name, job))
    for name, options in DISCS.items():
        for seed in (1, 2, 3):
            folder = work / "domains" / f"{name}-{seed}"
            known.append((seed, name, partial(way.discs, folder, seed, *options)))
    in_turn = sorted(known, key=lambda one: one[0])
    others = dict[str, Job]()
    if all(map(find_spec, learners.NEEDS)):
        others = learners.jobs(work / "traces")
    else:
        needed = ", ".join(learners.NEEDS)
        missing.append(f"{learners.PREFIX}: needs {needed} (make evaluate-any-data has them)")
    return {f"{name}-{seed}": job for seed, name, job in in_turn} | others, missing


def summary(found: Mapping[str, Any]) -> dict[str, Any]:
    """Sum up what was found, by data set."""
    told = dict[str, Any]()
    for name in (*SETS, *DISCS):
        runs = {job: run for job, run in sorted(found.items()) if job.rpartition("-")[0] == name}
        if runs:
            told[name] = summed(runs) if name in SETS else of_discs([*runs.values()])
    if others := learners.summarise(found):
        told[learners.PREFIX] = others
    return told


def summed(runs: Mapping[str, Any]) -> dict[str, Any]:
    """Sum up the runs of one data set over the seeds of training; shares are of all tasks of all seeds."""
    each = [*runs.values()]
    every = [task for run in each for task in run["tasks"]]
    tasks = [task for task in every if task["steps"] or not task["valid"]]  # not met at the start
    found: dict[str, Any] = {
        "seeds": [int(job.rpartition("-")[2]) for job in runs],
        "rows": each[0]["rows"],
        **{key: mean_of(run[key] for run in each) for key in ("r2_bits", "r2_direct", "r2_trivial")},
        "r2_bits_by_seed": [run["r2_bits"] for run in each],
        "error": [run["mae"]["model"] / run["mae"]["always zero"] for run in each],
        **{key: [run[key] for run in each] for key in ("operators", "judged", "kept")},
        "tasks": len(tasks),
        "planned": sum(task["valid"] for task in tasks),
        "not_planned": tally(task["reason"] for task in tasks if not task["valid"]),
    }
    if any("blind" in task for task in tasks):
        ran = [task for task in tasks if "blind" in task]
        for how in _HOWS:
            found[f"executed_{how}"] = sum(task[how]["reached"] for task in ran)
        found["executed"] = found["executed_replanned"]
        found["steps"] = sum(task["replanned"]["steps"] for task in ran)
        found["steps_as_promised"] = sum(task["replanned"]["as_promised"] for task in ran)
        found["missed"] = {how: tally(_why(task[how]) for task in ran) for how in _HOWS}
        for how in _HOWS:
            found[f"exactly_{how}"] = sum(task[how]["reached"] and task[how]["exactly"] for task in ran)
    return found


def _why(run: Mapping[str, Any]) -> str:
    """Say in a few words why a run missed its goal; nothing if it did not."""
    rules = (
        (run["reached"], ""),
        ("nothing is known" in run["reason"], "left the bounds"),
        ("no plan" in run["reason"], "no plan from where it came to"),
        (run["replans"] > 0, "new plans were used up"),
        (True, "ended elsewhere"),
    )
    return next(words for applies, words in rules if applies)


def of_discs(runs: Sequence[Any]) -> dict[str, Any]:
    """Sum up the runs with discs over the seeds of training."""
    kept = {key: [run[key] for run in runs] for key in ("r2_bits", "pairs", "pairs_kept", "judged", "kept")}
    return {"error": [run["mae"]["model"] / run["mae"]["always zero"] for run in runs], **kept}


def page(told: Mapping[str, Any]) -> str:
    """Write the page."""
    missing, sets = (
        told["missing"],
        {name: {"name": name, **one} for name, one in told.items() if name in SETS},
    )
    trained = {" ".join(("train", *DISCS[name])): told[name] for name in DISCS if name in told}
    return document(
        "# Data of any kind, from rows to plans that are performed",
        "By `make evaluate-any-data`, which wrote this page and `any-data.json`. Each data set goes the "
        "whole way by the commands of [data of your own](../data.md): `init --data`, `train`, `distill`, "
        "`compile-domain`, and for each task `new-problem`, `plan`, `validate` and `execute`. "
        f"Machine: {listed(told['machine'])}.",
        _table(_SETS, sets),
        "## Symbols",
        "R2 of effects on held-out rows, the mean over axes: through the bits, by a network without bits, "
        "and by the best predictor that looks at nothing. Operators are those of the domain. They "
        "are counted as the verdict of `compile-domain` does: a promise is kept where the likeliest outcome "
        "came in half of the rows, of five or more. Figures of several seeds of training stand side by side.",
        _table(_SYMBOLS, sets),
        "## Tasks",
        "Ten for each data set and seed of training, without those that are met at the start. "
        f"{way.PLANNER} plans. Starts that are not fixed are drawn with seed {way.TASKS_SEED}. A plan "
        "counts if `validate` takes it: unified-planning's validator, and the replay with mean changes, too. "
        f"It is performed blindly (`--replans 0`), and with up to {way.REPLANS} new plans where it would "
        "miss. A goal is reached where values meet it. They may be off by the tolerance of the axis, or by "
        "half a cell. *To the letter* counts those with new plans that are not off at all.",
        _table(_TASKS, sets),
        "## What did not come out",
        _table(_MISSED, sets),
        *WHY,
        *([f"Not measured here: {'; '.join(missing)}."] if missing else []),
        "## The discs of the guide",
        "The script and the commands of [data of your own](../data.md#the-same-with-numpy), over "
        "seeds of training. Errors are summed over both axes. What each symbol does to each category "
        "counts as kept if it mostly turns out in one way, standing still included; *of these move* "
        "is as the verdict counts.",
        _table(_DISCS, trained, "training"),
        *(
            [learners.TITLE, learners.ABOUT, learners.tables(told[learners.PREFIX])]
            if learners.PREFIX in told
            else []
        ),
    )


def _table(columns: Columns, sets: Mapping[str, Any], head: str = "data set") -> str:
    """Write a table: a row for each data set, with what each column says of it."""
    rows = [[name, *(told(one) for told in columns.values())] for name, one in sets.items()]
    return table(" | ".join((head, *columns)), rows)


_SETS: Columns = {
    "what it is": lambda one: SETS[one["name"]].about,
    "rows": lambda one: f"{one['rows']:,}",
    "bits of things, of actions": lambda one: "{}, {}".format(*SETS[one["name"]].bits),
    "seeds of training": lambda one: _beside(one["seeds"]),
}
_SYMBOLS: Columns = {
    "through the bits": lambda one: over_seeds(one["r2_bits_by_seed"], "{:.2f}", 2),
    "without bits": lambda one: number(one["r2_direct"]),
    "trivial": lambda one: number(one["r2_trivial"]),
    "operators": lambda one: _beside(one["operators"]),
    "keep their promise": lambda one: _of(one["kept"], one["judged"]),
}
_TASKS: Columns = {
    "tasks": lambda one: str(one["tasks"]),
    "valid plans": lambda one: str(one["planned"]),
    "reached blindly": lambda one: str(one.get("executed_blind", "no world")),
    "with new plans": lambda one: str(one.get("executed_replanned", "no world")),
    "to the letter": lambda one: str(one.get("exactly_replanned", "-")),
    "steps kept": lambda one: f"{one['steps_as_promised']} of {one['steps']}" if "steps" in one else "-",
}
_MISSED: Columns = {
    "no plan": lambda one: counts(one["not_planned"]),
    "missed blindly": lambda one: counts(one.get("missed", {}).get("blind", {})),
    "missed with new plans": lambda one: counts(one.get("missed", {}).get("replanned", {})),
}
_DISCS: Columns = {
    "errors, as a share of those of always zero": lambda one: _beside(
        f"{100 * share:.0f} %" for share in one["error"]
    ),
    "keep their promise": lambda one: _of(one["pairs_kept"], one["pairs"]),
    "of these move": lambda one: _of(one["kept"], one["judged"]),
}


def _beside(values: Any) -> str:
    return ", ".join(map(str, values))


def _of(some: Sequence[int], every: Sequence[int]) -> str:
    return _beside(map("{} of {}".format, some, every))


def main(
    deepsym: Annotated[
        Path | None,
        arg(help="Folder with deepsym-push/interactions.npz and deepsym-pairs/interactions.npz."),
    ] = None,
    work: Work = Path("evaluation/any-data"),
    results: Results = RESULTS,
) -> None:
    """Measure data set after data set, and write the results."""
    evaluation = Evaluation("any-data", work, results)
    jobs, missing = jobs_of(work.resolve(), deepsym and deepsym.resolve())
    done = evaluation.found()
    missing = [
        said for said in missing if not any(job.startswith(f"{said.partition(':')[0]}-") for job in done)
    ]
    for said in missing:
        print(said, file=sys.stderr)
    besides = {"missing": missing, "machine": machine("torch", "gymnasium", "panda-gym", "up-fast-downward")}

    def write() -> None:
        told = summary(evaluation.found()) | besides
        evaluation.write(told, page(told))

    evaluation.perform(jobs, "data sets", write, fresh=True)
    write()


if __name__ == "__main__":
    begin(main)
