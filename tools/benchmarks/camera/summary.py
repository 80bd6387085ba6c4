"""What objects that are seen come to beside objects that are known: figures, and the page that shows them."""

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any

from tools.benchmarks.budget.codes import agreement
from tools.benchmarks.tables import (
    NOT_YET,
    document,
    mean_of,
    number,
    over_seeds,
    share_of,
    table,
    with_interval,
)

KINDS = ("features", "images")
"""What networks are shown: true features, or what an eye tells of crops."""
_CELLS = {
    "single": "drawn tasks, one object, 50 mm",
    "far-1": "goals anywhere, 1 graspable object",
    "far-4": "goals anywhere, 4 graspable objects",
}
_NOISY = "noisy"
_SAID = {"blind": "followed blindly", "replanned": "replanned"}


def summarise(found: Mapping[str, Any]) -> dict[str, Any]:
    """Summarise the jobs that are done; shares lie between 0 and 1."""
    same = [one for name, one in sorted(found.items()) if name.startswith("same-")]
    tasks = {kind: {cell: _tried(found, kind, cell) for cell in _CELLS} for kind in (*KINDS, _NOISY)}
    images, learned = tasks["images"], {kind: _learned(found, kind) for kind in KINDS}
    seen = {name.removeprefix("seen-"): one for name, one in found.items() if name.startswith("seen-")}
    still, towers = seen.get("still", {}), {kind: _towers(found, kind) for kind in KINDS}
    cpus = [mean_of(learned[kind]["cpu"]) for kind in KINDS]
    return {
        "share": mean_of(one["images"]["share"] for one in same),
        "direct_r2": mean_of(one["images"]["direct_r2"] for one in same),
        "drawn": {how: images["single"][how] for how in _SAID},
        "anywhere": {"1": images["far-1"]["replanned"], "4": images["far-4"]["replanned"]},
        "towers_3": towers["images"]["reached"],
        "seen_mm": {name: still[name][0] for name in ("position", "size") if still},
        "noisy_replanned": tasks[_NOISY]["single"]["replanned"],
        "kinds_by_seed": [len(kinds) for kinds in learned["images"]["kinds"]],
        "cpu_ratio": share_of(cpus[1], cpus[0]) if cpus[0] and cpus[1] else None,
        "seen": seen,
        "same": {kind: [one[kind] for one in same] for kind in KINDS},
        "tasks": tasks,
        "towers": towers,
        "learned": learned,
        "shapes": {kind: _shapes(found, kind) for kind in KINDS},
        "agree": [_agreement(one) for name, one in sorted(found.items()) if name.startswith("agree-")],
    }


def _towers(found: Mapping[str, Any], kind: str) -> dict[str, Any]:
    """Count towers that stand, and say how many interactions taught what they are built with."""
    names = [name for name in sorted(found) if name.startswith(f"tower-{kind}-")]
    trials = [trial for name in names for trial in found[name]]
    reached = {
        how: share_of(sum(trial.get(how, False) for trial in trials), len(trials))
        for how in ("blind", "reached")
    }
    took = [one for name, one in sorted(found.items()) if name.startswith(f"relate-{kind}-")]
    return {**reached, "tasks": len(trials), "interactions": mean_of(one["interactions"] for one in took)}


def _shapes(found: Mapping[str, Any], kind: str) -> dict[str, list[int]]:
    """Count the tasks with each shape never seen that were reached, and all."""
    begins = f"shape-{kind}-"
    names = [name for name in sorted(found) if name.startswith(begins)]
    return {name.removeprefix(begins): [sum(found[name]), len(found[name])] for name in names}


def _agreement(symbols: Sequence[Sequence[str]]) -> dict[str, Any]:
    """Say how alike two groupings are, and how many objects are of which category in each."""
    counts = Counter(zip(*symbols, strict=True))
    index = agreement(*(" ".join(groups) for groups in symbols))
    return {"index": index, "counts": [[*pair, count] for pair, count in sorted(counts.items())]}


def _tried(found: Mapping[str, Any], kind: str, cell: str) -> dict[str, Any]:
    """Count tasks that were reached, over seeds."""
    names = [name for name in found if name.startswith(f"try-{kind}-") and f"-{cell}-" in name]
    trials = [trial for name in sorted(names) for trial in found[name]]
    reached = {
        how: share_of(sum(bool((trial.get(how) or {}).get("reached")) for trial in trials), len(trials))
        for how in _SAID
    }
    unplanned = sum(trial.get("replanned") is None for trial in trials)
    return {**reached, "tasks": len(trials), "unplanned": unplanned}


def _learned(found: Mapping[str, Any], kind: str) -> dict[str, Any]:
    runs = [one for name, one in sorted(found.items()) if name.startswith(f"learn-{kind}-")]
    return {name: [one[name] for one in runs] for name in ("cpu", "interactions", "kinds", "r2", "direct_r2")}


def page(summary: Mapping[str, Any]) -> str:
    """Write the page."""
    return document(
        "# Objects that are seen",
        "By `make evaluate-camera`, which wrote this page and `camera.json`. *Features* are the true "
        "sizes and type of an object, as only a simulator knows them. *Images* are its crop in a "
        "depth image, which an eye tells in five numbers; see [from a camera](../camera.md). Shares "
        "are of tasks of all seeds, with the interval at 95 %.",
        "## Seeing",
        "Scenes of one and of four objects that lie turned by any angle. How far off they are seen: "
        "their middles, their three sizes in the mean, and their headings; the median, and what nine "
        "of ten keep within. *Miscounted* are scenes in which more or fewer objects are seen than "
        "there are. *Noisy* is as a depth sensor: steps of 1 mm, 30 % of the pixels at edges lost, a "
        "picture 1 mm too deep or too high in the standard deviation.",
        _seeing(summary["seen"]),
        "## Learning from the same interactions",
        "The interactions that `domains/tabletop` was learned from, over seeds of training, in the quick "
        "regime. R2 is of effects that were held out of all learning, that of the eye, too. It is told "
        "without bits, through 2 + 4 bits, and the second as a share of the first.",
        _same(summary["same"]),
        "## Learning and doing",
        "`neurosym run`, in either world, over seeds. Whether a goal is reached is "
        "told as objects are seen there. With noise, what was learned without noise is tried in a "
        "world with noise.",
        _doing(summary["tasks"]),
        _learning(summary["learned"]),
        "## Towers",
        "Pairs were learned beside what the first seed had learned (`--relations 1024`). Three solid objects "
        "of six shall stand on one another, the widest below, such that a person can build it. Geometry says "
        "of things as they are whether they do.",
        _building(summary["towers"]),
        "## Shapes never seen",
        "Carried to a point at least 15 cm away, replanned, by the domains of the first seed. A T and an L "
        "block have the same sizes and other crops. Look-alikes have sizes and crops as usual, and another "
        "mass, friction, centre of mass or floor.",
        _of_shapes(summary["shapes"]),
        "## Where they disagree",
        "500 objects, with the category that each has by features (a row each) and by images. Bits of two "
        "domains mean different things, so what counts is which objects are together. The adjusted Rand "
        "index is 1 where the same are, and 0 where it is chance. The table is of the first seed.",
        _disagreeing(summary["agree"]),
    )


def _seeing(seen: Mapping[str, Any]) -> str:
    def row(name: str, one: Mapping[str, Any]) -> list[str]:
        pairs = [
            f"{number(one[of][0], 1)}, {number(one[of][1], 1)}" for of in ("position", "size", "heading")
        ]
        spent = f"{number(one['look_ms'], 1)} of {number(one['interaction_ms'], 0)}"
        return [name, *pairs, f"{one['miscounted']} of {one['scenes']}", spent]

    columns = (
        "camera | middle [mm] | sizes [mm] | heading [degrees] | miscounted | CPU of a look and an "
        "interaction [ms]"
    )
    return table(columns, [row(name, seen[name]) for name in ("still", _NOISY) if name in seen])


def _same(same: Mapping[str, Sequence[Mapping[str, float]]]) -> str:
    columns = "shown | seeds | R2 without bits | R2 through bits | share"
    rows = [
        [
            kind,
            str(len(runs)),
            *(over_seeds([one[of] for one in runs], "{:.3f}", 3) for of in ("direct_r2", "r2", "share")),
        ]
        for kind, runs in same.items()
        if runs
    ]
    return table(columns, rows)


def _doing(tasks: Mapping[str, Mapping[str, Mapping[str, Any]]]) -> str:
    rows = [
        [said, kind, str(one["tasks"]), *(with_interval(one[how], one["tasks"]) for how in _SAID)]
        for cell, said in _CELLS.items()
        for kind, cells in tasks.items()
        if (one := cells[cell])["tasks"]
    ]
    return table(["tasks", "objects by", "tasks in all", *_SAID.values()], rows)


def _building(towers: Mapping[str, Mapping[str, Any]]) -> str:
    rows = [
        [
            kind,
            str(one["tasks"]),
            *(with_interval(one[how], one["tasks"]) for how in ("blind", "reached")),
            f"{one['interactions']:,.0f}",
        ]
        for kind, one in towers.items()
        if one["tasks"]
    ]
    columns = "objects by | towers | followed blindly | replanned | interactions in all"
    return table(columns, rows) if rows else NOT_YET


def _of_shapes(shapes: Mapping[str, Mapping[str, Sequence[int]]]) -> str:
    features, images = (shapes[kind] for kind in KINDS)
    rows = [
        [shape, *("{} of {}".format(*one[shape]) if shape in one else "-" for one in (features, images))]
        for shape in sorted({*features, *images})
    ]
    return table("shape | by features | by images", rows)


def _disagreeing(agree: Sequence[Mapping[str, Any]]) -> str:
    if not agree:
        return NOT_YET
    counts = {(one, other): count for one, other, count in agree[0]["counts"]}
    ours, theirs = (sorted({pair[at] for pair in counts}) for at in (0, 1))
    rows = [[one, *(str(counts.get((one, other), 0)) for other in theirs)] for one in ours]
    indices = ", ".join(number(one["index"]) for one in agree)
    return f"{table(['by features', *theirs], rows)}\n\nAdjusted Rand index by seed: {indices}."


def _learning(learned: Mapping[str, Mapping[str, Sequence[Any]]]) -> str:
    rows = [
        [
            kind,
            str(len(one["cpu"])),
            over_seeds(one["interactions"], "{:,.0f}", 0),
            over_seeds([cpu / 60 for cpu in one["cpu"]]),
            ", ".join(str(len(kinds)) for kinds in one["kinds"]),
        ]
        for kind, one in learned.items()
        if one["cpu"]
    ]
    return table("objects by | seeds | interactions | CPU minutes | kinds of primitive, of six", rows)
