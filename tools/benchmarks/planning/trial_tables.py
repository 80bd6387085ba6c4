"""What came of trials in the shipped domain, as sections of `planning.md`."""

from collections.abc import Mapping, Sequence
from typing import Any

from neurosym.stages.plan_records import MORE_MOTIONS
from neurosym.stages.verdicts import wilson
from tools.benchmarks.planning.tables import NOT_YET, markdown


def trial_sections(results: Mapping[str, Any]) -> list[str]:
    """Write the sections; none for results of earlier versions, which have no such figures."""
    if "precision" not in results:
        return []
    return [
        "## How near plans come",
        "The shipped domain, Fast Downward, tasks drawn as above; shares of all tasks with Wilson intervals "
        "at 95 %. *Blindly* and *replanning* start from the same plan.",
        _precision(results["precision"]),
        "## Goals anywhere",
        "Objects of all shapes, starts and goals uniform over the table, footprints on the table and apart, "
        "each goal at least 15 cm from the start; 50 mm, with replanning. A task without a plan is a miss. "
        "*Motions* are primitives that were performed.",
        _far(results["far_goals"], results["far_details"]),
        "## Promises, step by step",
        "Distances between what the operator of a step promised for the object at hand and what came, at "
        "50 mm. *Worst* is the worst category. A grasp that fails outweighs many other steps, so intervals "
        "(bootstrap over runs, 95 %) are wide. *First step* is that of each run.",
        _promises(results["promises"]),
        "Motions a task, replanned: "
        + ", ".join(f"{kind} {_number(value)}" for kind, value in results["motions"].items())
        + ". Kinds of primitive, by seed: "
        + (", ".join(f"{seed}: {len(kinds)}" for seed, kinds in results["kinds_by_seed"].items()) or NOT_YET)
        + ".",
        "## The chance that is printed",
        _calibration(
            "Chance that `neurosym plan` prints, beside how often the plan came true, followed blindly to "
            "50 mm",
            results["calibration"],
        ),
        _calibration(
            f"Chance that it prints of being there within {MORE_MOTIONS} motions more than the plan has, "
            "beside how often that was so, with replanning",
            results["calibration_replanned"],
        ),
    ]


def _precision(table: Mapping[str, Any]) -> str:
    rows = [
        [f"{mm} mm", kind, str(cell["tasks"]), *(with_interval(cell[way], cell["tasks"]) for way in _WAYS)]
        for mm, kinds in table.items()
        for kind, cell in kinds.items()
        if cell["tasks"]
    ]
    return markdown(["within", "objects", "tasks", "followed blindly", "with replanning"], rows)


_WAYS = ("blind", "replanned")


def _far(shares: Mapping[str, float | None], details: Mapping[str, Any]) -> str:
    rows = [
        [
            objects,
            str(told["tasks"]),
            with_interval(shares[objects], told["tasks"]),
            str(told["without_plan"]),
            *(_number(told[name]) for name in ("primitives", "motions")),
            ", ".join(f"{how} ({count})" for how, count in told["missed"].items()) or "-",
        ]
        for objects, told in details.items()
        if told["tasks"]
    ]
    columns = ["objects", "tasks", "reached", "without a plan", "primitives of the plan", "motions"]
    return markdown([*columns, "what ended the others"], rows)


def _promises(table: Mapping[str, Any]) -> str:
    rows = [
        [name, str(told["steps"])]
        + [f"{_number(told['all'])} ({' to '.join(map(_number, told['interval']))})"]
        + [_number(told[key]) for key in ("median", "first", "worst", "worst_median")]
        + ["-" if told["kinds_kept"] is None else f"{told['kinds_kept']:.0%}".replace("%", " %")]
        for name, told in table.items()
        if told["steps"]
    ]
    columns = ["runs", "steps", "RMS [mm]", "median [mm]", "first step, RMS [mm]"]
    columns += ["worst RMS [mm]", "its median [mm]"]
    return markdown([*columns, "ended in the way promised"], rows)


def _calibration(what: str, told: Mapping[str, Any]) -> str:
    if not told["plans"]:
        return NOT_YET
    rows: Sequence[Sequence[str]] = [
        [
            str(part["plans"]),
            f"{100 * part['chance']:.0f} %",
            with_interval(part["reached"], int(part["plans"])),
        ]
        for part in told["bins"]
    ]
    return (
        f"{what} ({told['plans']} plans). Brier score {told['brier']:.3f}; of the base rate "
        f"{told['brier_of_base_rate']:.3f}.\n\n{markdown(['plans', 'mean chance', 'came true'], rows)}"
    )


def with_interval(share: float | None, of: int) -> str:
    """Print a share with its Wilson interval."""
    if share is None:
        return "-"
    low, high = wilson(round(share * of), of)
    return f"{100 * share:.0f} % ({100 * low:.0f} to {100 * high:.0f})"


def _number(value: float | None) -> str:
    return "-" if value is None else f"{value:.1f}"
