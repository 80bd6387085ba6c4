"""What came of budgets, as plain values and as a page of Markdown tables."""

from collections.abc import Mapping
from typing import Any, NamedTuple

from neurosym.exploration.loop import ExplorationConfig
from tools.benchmarks.budget import codes, engines, heights
from tools.benchmarks.budget.ways import STAGES, TOWERS, WAYS
from tools.benchmarks.jobs import Found, machine
from tools.benchmarks.planning import figures
from tools.benchmarks.planning.trials import trials_of
from tools.benchmarks.tables import document, mean_of, percent, share_of, table, with_interval

SIX = 6  # kinds of primitive that the paper has


class Must(NamedTuple):
    """What must be reached, in the mean of the seeds, by the domain of a way within so many interactions."""

    way: str
    how: str
    shares: Mapping[str, float]
    within: int


MUST = {
    "drawn": Must("one-budget", "blind", {"single": 0.95, "double": 0.85}, 6000),
    "places": Must("with-places", "replanned", {"far-1": 1.0, "far-2": 0.96, "far-4": 0.96}, 10_000),
    "relations": Must("with-relations", "replanned", {TOWERS: 0.95, "on": 0.85, "in": 0.85}, 15_000),
}
_MUST_GAIN, _MUST_RATIO = 0.2, 0.75
_WITHIN_20_MM = 0.9, 0.85  # of single and double tasks
_MUST_SIX, _SIX_WITHIN = 4, 4000
_MUST_TAKE = {"default": 8, "without_places": 5}  # [minutes]


def summarise(found: Found) -> dict[str, Any]:
    """Gather the shares of reached goals, for each seed and in the mean."""
    learned = {name.removeprefix("learn-"): found[name] for name in found if name.startswith("learn-")}
    shares: dict[str, dict[str, Any]] = {}
    for way in WAYS:
        for total in WAYS[way].points:
            names = [name for name in learned if name.rsplit("-", 2)[::2] == [way, str(total)]]
            if told := _told(found, way, total, sorted(names)):
                shares.setdefault(way, {})[str(total)] = told
    timed = {name.removeprefix("time-"): found[name] for name in found if name.startswith("time-")}
    return {
        "command": "make evaluate-budget",
        "machine": machine("mujoco-core", "numpy", "pybullet", "torch", "up-fast-downward"),
        "interactions_for": {what: _first(shares, must) for what, must in MUST.items()},
        "run_minutes": {name: timed[name]["minutes"] for name in timed},
        "cpu_ratio": found.get("ratio", {}).get("ratio"),
        "blind_at_2000": {
            way.replace("-", "_"): _mean(shares, way, "2000", "single", "blind")
            for way in ("one-budget", STAGES, "random", "entropy")
        },
        "seeds": len({name.split("-")[-2] for name in learned}),
        "six_kinds": _six(learned),
        "codes": codes.summarise(found),
        "curiosity": heights.summarise(found),
        "timed": timed,
        "interaction": found.get("ratio"),
        "engines": found.get(engines.JOB, {}),
        "learned": learned,
        "shares": shares,
    }


def _told(found: Found, way: str, total: int, names: list[str]) -> dict[str, Any]:
    """Tell for each cell the shares of each seed, as far as they are known."""
    told = dict[str, Any]()
    for cell in WAYS[way].points[total]:
        jobs = [[job for job in found if job.startswith(f"try-{name}-{cell.name}-")] for name in names]
        jobs = [some for some in jobs if some]
        if not jobs:
            continue
        if cell.name == TOWERS:
            trials = [[trial for job in some for trial in found[job]] for some in jobs]
            shares: dict[str, Any] = {
                how: [share_of(sum(bool(one.get(key)) for one in of), len(of)) for of in trials]
                for how, key in (("blind", "blind"), ("replanned", "reached"))
            }
        else:
            trials = [trials_of(found, some) for some in jobs]
            shares = {how: [figures.share(of, how) for of in trials] for how in figures.WAYS}
        told[cell.name] = {**shares, "tasks": sum(map(len, trials))}
    for word in ("on", "in"):
        if judged := [pairs for name in names if (pairs := found[f"learn-{name}"].get("pairs"))]:
            right = [(one["operators"][word] or {}).get("right", 0.0) for one in judged]
            told[word] = {"blind": right, "replanned": right, "tasks": 0}
    return told


def _mean(shares: Mapping[str, Any], way: str, total: str, cell: str, how: str) -> float | None:
    return mean_of(shares.get(way, {}).get(total, {}).get(cell, {}).get(how, ()))


def _first(shares: Mapping[str, Any], must: Must) -> int | None:
    """Return the fewest interactions that are enough in the mean of the seeds; None if none of them are."""
    for total in sorted(map(int, shares.get(must.way, {}))):
        means = {cell: _mean(shares, must.way, str(total), cell, must.how) for cell in must.shares}
        if all(mean is not None and mean >= must.shares[cell] for cell, mean in means.items()):
            return total
    return None


def _six(learned: Mapping[str, Any]) -> dict[str, list[int]]:
    """Say for each way after how many interactions each seed had operators of all six kinds, if it had."""
    six = dict[str, dict[str, int]]()
    for name, one in sorted(learned.items(), key=lambda item: item[1]["interactions"]):
        way, seed, _ = name.rsplit("-", 2)
        if len(one["kinds"]) >= SIX:
            six.setdefault(way, {}).setdefault(seed, one["interactions"])
    return {way: sorted(six[way].values()) for way in WAYS if way in six}


def _aims(summary: Mapping[str, Any]) -> list[list[str]]:
    """Tell beside each figure that was aimed at what was found."""
    rows = []
    for what, must in MUST.items():
        goals = ", ".join(f"{cell} {percent(share)}" for cell, share in must.shares.items())
        found = summary["interactions_for"][what]
        said = f"{found:,}" if found else "more than were tried"
        rows.append([f"interactions for {what} ({must.how}: {goals})", f"{must.within:,}", said])
    for name, most in _MUST_TAKE.items():
        if found := summary["run_minutes"].get(name):
            rows.append([f"minutes of one run, {name.replace('_', ' ')}", str(most), f"{found:.1f}"])
    if ratio := summary["cpu_ratio"]:
        rows.append(["CPU of an interaction beside before", f"{_MUST_RATIO}", f"{ratio:.2f}"])
    one, stages = (summary["blind_at_2000"][name] for name in ("one_budget", STAGES))
    if one is not None and stages is not None:
        gain = "single tasks followed blindly after 2,000, beside stages"
        rows.append([gain, f"+{100 * _MUST_GAIN:.0f} points", f"{100 * (one - stages):+.0f} points"])
    found = [
        _mean(summary["shares"], "one-budget", "8000", f"20mm-{n}", "blind") for n in ("single", "double")
    ]
    if None not in found:
        goals = " and ".join(map(percent, _WITHIN_20_MM))
        rows.append(["20mm tasks followed blindly after 8,000", goals, " and ".join(map(percent, found))])
    soon = sum(count <= _SIX_WITHIN for count in summary["six_kinds"].get("one-budget", ()))
    looked = sum(
        name.startswith("one-budget-") and name.endswith(f"-{_SIX_WITHIN}") for name in summary["learned"]
    )
    seeds = f"{soon} of {summary['seeds']} seeds; {looked} were looked at then"
    rows.append([f"all six kinds of primitive once within {_SIX_WITHIN:,}", f"{_MUST_SIX} of 5 seeds", seeds])
    return rows


def _cpu(compared: Mapping[str, Any] | None) -> str:
    ratio = (compared or {}).get("mujoco")
    return f"An interaction in MuJoCo takes {ratio:.2f} of the CPU of one in PyBullet." if ratio else ""


def page(summary: Mapping[str, Any]) -> str:
    """Write the page."""
    rows = []
    for way, by_total in summary["shares"].items():
        for total, cells in sorted(by_total.items(), key=lambda item: int(item[0])):
            foreign = [cell.name for cell in WAYS[way].points[int(total)] if cell.engine]
            for name, told in cells.items():
                if name in foreign:
                    continue
                if told["tasks"]:
                    ways = [with_interval(mean_of(told[how]), told["tasks"]) for how in figures.WAYS]
                else:
                    ways = ["-", percent(mean_of(told["replanned"]))]
                rows.append([way, f"{int(total):,}", name, str(len(told["blind"])), *ways])
    taken = [
        [
            name,
            f"{one['interactions']:,}",
            f"{one['cpu'] / 60:.1f}",
            percent(one["moved"]),
            str(len(one["kinds"])),
            f"{one['r2']:.2f}",
        ]
        for name, one in summary["learned"].items()
    ]
    timed = [
        [name, f"{one['minutes']:.1f}", f"{one['cpu_minutes']:.1f}", f"{one['unit']:.2f}"]
        for name, one in summary["timed"].items()
    ]
    return document(
        "# Budgets, measured",
        "By `make evaluate-budget`, which wrote this page, `budget.json`, `budget.png` and `curiosity.png`. "
        "Interactions are all that were performed, whatever for. Goals within 50 mm, or 20 mm where it is "
        "said; in *far* tasks they lie anywhere on the table, for objects that can be grasped. *On* and "
        "*in*: how often the surest operator brings that about where it is foreseen. Shares are means over "
        "seeds, with the interval at 95 % of so many tasks.",
        "![Goals reached blindly by interactions](budget.png)",
        table("way | interactions | tasks | seeds | followed blindly | replanned", rows),
        *(f"*{name}*: {way.about}." for name, way in WAYS.items()),
        "## What was aimed at",
        "Each was to be reached, or stayed below. Interactions are the fewest after which the mean of the "
        "seeds reaches all of these shares. Not all is of one machine, and bytes differ between them: "
        "[docs/learning.md](../learning.md#one-budget) says what is not.",
        table("figure | aimed at | found", _aims(summary)),
        "## What the codes tell",
        "Nothing was learned from these 1,000 random actions. R2 is of their effects, in the mean of the "
        "seeds. Symbols sort the actions into groups. These are compared between two ways with one seed, "
        "and between two seeds of one way. The adjusted Rand index is 1 for the same groups, 0 for chance.",
        codes.tables(summary["codes"]),
        "## When curiosity pays",
        "In an action box so many times as high, more random actions move nothing. From what was explored a "
        "network without a bottleneck learned; R2 is of what it foresees of random actions that do move "
        "their target, with the standard deviation over seeds. The networks that are curious are updated "
        f"each {ExplorationConfig().block} interactions, if nothing else is said.",
        "![What is explained, by how many random actions move something](curiosity.png)",
        heights.tables(summary["curiosity"]),
        "## Two engines",
        "The same random actions in PyBullet and in MuJoCo (`--engine mujoco`), and in each once more, with "
        "all waypoints .1 mm beside. Then plans with what was learned in one from 6,000 interactions, "
        f"executed in both. {_cpu(summary['interaction'])}",
        engines.tables(summary["engines"], summary["shares"]),
        "## What it took",
        "CPU minutes are those since the point before, on machines of several speeds. They are fewer where "
        "an interrupted run went on. *Moved* is the share of what explored that moved its target by 1 cm or "
        "picked it up. Kinds are of the paper's six primitives; R2 is through the codes.",
        table("way, seed, at most | interactions | CPU minutes | moved | kinds | R2", taken),
        "## One run, with two processes and nothing beside it",
        "The last column says how fast the machine is: CPU seconds of importing numpy.",
        table("run | minutes | CPU minutes | unit", timed),
    )
