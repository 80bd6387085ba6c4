"""What objects of unseen shapes and hidden properties come to: figures, and the page that shows them."""

from collections.abc import Iterable, Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np

from neurosym.stages.verdicts import wilson
from tools.benchmarks.objects.contact import TOLD, VARIANTS
from tools.benchmarks.objects.tasks import SHAPES

TRIES = (0, 1, 3, 5)
PARTS = "parts-"
"""What the names of jobs begin with that choose pushes which stop on their way, for a domain each."""
_KINDS = {"carry": "carried to a point", "push": "pushed to a point", "stack": "put on a box"}
_MOVED = ("carry", "push")
"""Kinds of tasks whose goal is a point."""
_LOOKS = {"carry": "as learned", "pushes": "without places"}
_FEATURES = ("s_x", "s_y", "d")
_NEAR = (0.05, 0.02, 0.005)  # how near to its promise a motion ends that was right [m]


def summarise(found: Mapping[str, Any]) -> dict[str, Any]:
    """Summarise the jobs that are done; shares lie between 0 and 1."""

    def rows(begins: str) -> list[Any]:
        return [row for name, done in sorted(found.items()) if name.startswith(begins) for row in done]

    of_kind = {kind: [row for shape in SHAPES for row in rows(f"{kind}-{shape}-")] for kind in _KINDS}
    shapes = {
        shape: {kind: _by_tries(rows(f"{kind}-{shape}-"), _is_reached) for kind in _KINDS} for shape in SHAPES
    }
    unseen = {kind: _by_tries(done, _is_reached) for kind, done in of_kind.items()}
    looks = {
        f"{said}, {1000 * near:g} mm": _by_tries(rows(f"look-{kind}-"), partial(_is_near, near))
        for kind, said in _LOOKS.items()
        for near in _NEAR
    }
    pushed, edges, in_part = rows("pushed-"), rows("edge-"), rows("in-part-")
    return {
        "lookalikes": {
            name: _by_tries(rows("look-"), partial(_is_near, _NEAR[0]))[TRIES.index(number)]["share"]
            for name, number in (("features", 0), ("effects", 3))
        },
        "unseen": {
            str(number): {kind: one[at]["share"] for kind, one in unseen.items()}
            for at, number in enumerate(TRIES)
        },
        "pushed_20mm": _share(row["reached"] for row in pushed)["share"],
        "edge_brier": _brier(edges),
        "edge_base": _base(edges),
        "unseen_intervals": unseen,
        "away_mm": {kind: _away(of_kind[kind]) for kind in _MOVED},
        "by_shape": shapes,
        "first_motions": looks,
        "pushed": _pushed(pushed),
        "in_part": _pushed(in_part) | {"added": len(rows(PARTS))},
        "contact": _contact(found),
        "edges": {
            f"{feature} {end}": _edge(rows(f"edge-{number}-{end}-"))
            for number, feature in enumerate(_FEATURES)
            for end in ("low", "high")
        },
    }


def _contact(found: Mapping[str, Any]) -> dict[str, dict[str, list[float]]]:
    """Return what bits tell that were learned in each way, a number for each seed."""
    seeds = [found[name] for name in sorted(found) if name.startswith("contact-")]
    return {way: {of: [round(one[way][of], 4) for one in seeds] for of in TOLD} for way in VARIANTS if seeds}


def _pushed(rows: Sequence[Any]) -> dict[str, Any]:
    motions = _mean(row["steps"] for row in rows), _mean(row["steps"] for row in rows if row["reached"])
    return _share(row["reached"] for row in rows) | dict(zip(("motions", "of_reached"), motions, strict=True))


def _is_reached(run: Mapping[str, Any]) -> bool:
    return bool(run["reached"])


def _is_near(near: float, apart: float | None) -> bool:
    return apart is not None and apart <= near


def _by_tries(rows: Sequence[Sequence[Any]], holds: Any) -> list[dict[str, Any]]:
    """Return the share for which something holds, after each number of tries."""
    return [_share(holds(row[at]) for row in rows) for at in range(len(TRIES))]


def _away(rows: Sequence[Sequence[Any]]) -> list[float | None]:
    """Return how far from its goal an object ended, after each number of tries, in the median [mm]."""
    ends = [[row[at].get("away") for row in rows] for at in range(len(TRIES))]
    known = ([one for one in these if one is not None] for these in ends)
    return [round(1000 * float(np.median(these)), 1) if these else None for these in known]


def _edge(rows: Sequence[Any]) -> dict[str, Any]:
    said, kept = _mean(row[0] for row in rows), _mean(row[1] for row in rows)
    return {"motions": len(rows), "said": said, "kept": kept, "brier": _brier(rows), "base": _base(rows)}


def _share(values: Iterable[bool]) -> dict[str, Any]:
    """Return a share, its interval at 95 %, and of how many."""
    rows = [*values]
    if not rows:
        return {"share": None, "low": None, "high": None, "tasks": 0}
    low, high = wilson(sum(rows), len(rows))
    return {"share": sum(rows) / len(rows), "low": low, "high": high, "tasks": len(rows)}


def _mean(values: Iterable[float]) -> float | None:
    rows = [*values]
    return round(float(np.mean(rows)), 4) if rows else None


def _brier(rows: Sequence[Any]) -> float | None:
    """Return the mean squared error of the chances that were said."""
    return _mean((said - kept) ** 2 for said, kept, _ in rows)


def _base(rows: Sequence[Any]) -> float | None:
    """Return the same if the share of all was said of each."""
    kept = _mean(row[1] for row in rows)
    return None if kept is None else round(kept * (1 - kept), 4)


_PAGE = """# Objects that nothing was learned of, measured

By `make evaluate-objects`, which wrote this page and `objects.json`. Five domains were learned by
`neurosym run` with its defaults, and each is tried on a fifth of the tasks; objects are stacked with the
shipped domain `towers`. Each object was tried so many times before (`neurosym meet`), with its goal known;
with 0 tries only its features are known. Shares have intervals at 95 %.

## Shapes never seen

Goals are at least 15 cm away, and to be met within 50 mm, with replanning; what is pushed goes no farther
than 25 cm.

{unseen}

How far objects end from such goals, in the median:

{away}

By shape, after 0, 1, 3 and 5 tries:

{shapes}

## Look-alikes with hidden properties

Whether the first motion of a plan did as was promised of the object, so near. These look like objects that
domains are learned with. Mass, friction, and the floor of a box or else the centre of mass are others. Each
is tried with the domain as it was learned, and without its places. In `objects.json`, `lookalikes` holds the
shares of both, within 50 mm, after 0 and after 3 tries.

{looks}

## Pushed only

Objects that no person finds a grasp for, one at a time, goals anywhere within 20 mm, with replanning:
{pushed}.

With {added} more pushes that stop on their way in the five domains, chosen for what they save on an average
way over the table: {in_part}.

## Contact and force

Bits are learned from 4,000 random interactions: from displacements, from these with touch and the greatest
force between hand and object, or from touch and force first. What the means over bits explain of the variance
in 1,000 new ones: mean and standard deviation over seeds.

{contact}

## Sizes at an edge

Chances that are said of single motions with objects one of whose sizes is in the lowest or highest tenth, and
how often they came. The base is the Brier score if their own share was said of each.

{edges}
"""


def page(summary: Mapping[str, Any]) -> str:
    """Print the page of results."""
    unseen, looks, pushed = summary["unseen_intervals"], summary["first_motions"], summary["pushed"]
    return _PAGE.format(
        unseen=_table(
            ["tries", *_KINDS.values()],
            [[str(n), *(_said(unseen[kind][at]) for kind in _KINDS)] for at, n in enumerate(TRIES)],
        ),
        away=_table(
            ["tries", *(_KINDS[kind] for kind in _MOVED)],
            [
                [str(n), *(_millimetres(summary["away_mm"][kind][at]) for kind in _MOVED)]
                for at, n in enumerate(TRIES)
            ],
        ),
        shapes=_table(
            ["shape", *_KINDS.values()],
            [[name, *(_list(kinds[kind]) for kind in _KINDS)] for name, kinds in summary["by_shape"].items()],
        ),
        looks=_table(
            ["tries", *looks],
            [[str(n), *(_said(shares[at]) for shares in looks.values())] for at, n in enumerate(TRIES)],
        ),
        pushed=_told_of(pushed),
        in_part=_told_of(summary["in_part"]),
        added=summary["in_part"]["added"],
        contact=_table(
            ["bits from", *TOLD],
            [
                [way, *(f"{np.mean(told[of]):.3f} ± {np.std(told[of]):.3f}" for of in TOLD)]
                for way, told in summary["contact"].items()
            ],
        )
        if summary["contact"]
        else "not measured yet",
        edges=_table(
            ["size", "motions", "said", "came", "Brier", "base"],
            [
                [name, *(f"{number:g}" if number is not None else "-" for number in one.values())]
                for name, one in summary["edges"].items()
            ],
        ),
    )


def _table(heads: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    lines = [heads, ["---"] * len(heads), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def _told_of(pushed: Mapping[str, Any]) -> str:
    if not pushed["tasks"] or pushed["of_reached"] is None:
        return _said(pushed)
    motions = f"{pushed['motions']:.1f} motions a task, {pushed['of_reached']:.1f} where it was reached"
    return f"{_said(pushed)}; {motions}"


def _said(one: Mapping[str, Any]) -> str:
    if not one["tasks"]:
        return "-"
    return f"{one['share']:.0%} ({100 * one['low']:.0f} to {100 * one['high']:.0f}) of {one['tasks']}"


def _millimetres(length: float | None) -> str:
    return "-" if length is None else f"{length:g} mm"


def _list(shares: Sequence[Mapping[str, Any]]) -> str:
    return ", ".join("-" if one["share"] is None else f"{100 * one['share']:.0f}" for one in shares) + " %"
