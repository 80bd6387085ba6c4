"""What objects of unseen shapes and hidden properties come to: figures, and the page that shows them."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from neurosym.stages.verdicts import wilson
from tools.benchmarks.objects.tasks import LOOKALIKES, SHAPES

TRIES = (0, 1, 3, 5)
_KINDS = {"carry": "carried to a point", "push": "pushed to a point", "stack": "put on a box"}
_FEATURES = ("s_x", "s_y", "d")


def _rows(found: Mapping[str, Any], begins: str) -> list[Any]:
    """List what the jobs found whose names begin so."""
    return [row for name, rows in sorted(found.items()) if name.startswith(begins) for row in rows]


def summarise(found: Mapping[str, Any]) -> dict[str, Any]:
    """Summarise the jobs that are done; shares lie between 0 and 1."""
    unseen = {
        str(number): {
            kind: _share(runs[at]["reached"] for shape in SHAPES for runs in _rows(found, f"{kind}-{shape}-"))
            for kind in _KINDS
        }
        for at, number in enumerate(TRIES)
    }
    shapes = {
        shape: {
            kind: [
                _share(runs[at]["reached"] for runs in _rows(found, f"{kind}-{shape}-")) for at in range(4)
            ]
            for kind in _KINDS
        }
        for shape in SHAPES
    }
    looks = {
        kind: {
            hidden: [
                _share(row[at] is True for row in _rows(found, f"look-{kind}-{_file(hidden)}-"))
                for at in range(4)
            ]
            for hidden in LOOKALIKES
        }
        for kind in ("carry", "pushes")
    }
    every = {
        kind: [_share(row[at] is True for row in _rows(found, f"look-{kind}-")) for at in range(4)]
        for kind in ("carry", "pushes")
    }
    pushed = _rows(found, "pushed-")
    edges = _rows(found, "edge-")
    return {
        "lookalikes": {"features": every["pushes"][0]["share"], "effects": every["pushes"][2]["share"]},
        "unseen": {
            number: {kind: one["share"] for kind, one in kinds.items()} for number, kinds in unseen.items()
        },
        "pushed_20mm": _share(row["reached"] for row in pushed)["share"],
        "edge_brier": _brier(edges),
        "edge_base": _base(edges),
        "intervals": unseen,
        "by_shape": shapes,
        "by_lookalike": looks,
        "all_lookalikes": every,
        "pushed": {
            "tasks": len(pushed),
            "reached": sum(row["reached"] for row in pushed),
            "motions": float(np.mean([row["steps"] for row in pushed if row["reached"]])) if pushed else None,
        },
        "edges": {
            f"{_FEATURES[feature]} {end}": {
                "motions": len(rows),
                "said": _mean(row[0] for row in rows),
                "kept": _mean(row[1] for row in rows),
                "brier": _brier(rows),
                "base": _base(rows),
            }
            for feature in range(3)
            for end in ("low", "high")
            if (rows := _rows(found, f"edge-{feature}-{end}-"))
        },
    }


def _file(name: str) -> str:
    return name.replace(" ", "-")


def _share(values: Iterable[bool]) -> dict[str, Any]:
    """Return a share, its interval at 95 %, and of how many."""
    rows = [bool(value) for value in values]
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


def page(summary: Mapping[str, Any]) -> str:
    """Print the page of results."""
    return f"""# Objects that nothing was learned of, measured

By `make evaluate-objects`, which wrote this page and `objects.json`. The shipped domains are tried as they
are: `places` on carrying and pushing, `towers` on stacking, `tabletop` on look-alikes that cannot be carried.
Each object was tried so many times before (`neurosym meet`), with its goal known; with 0 tries only its
features are known. Shares have intervals at 95 %.

## Shapes never seen

With replanning, goals within 50 mm and at least 15 cm away; what is pushed goes no farther than 25 cm.

{
        _table(
            ["tries", *_KINDS.values()],
            [
                [number, *(_said(kinds[kind]) for kind in _KINDS)]
                for number, kinds in summary["intervals"].items()
            ],
        )
    }

| shape | {" | ".join(f"{said}, after 0, 1, 3, 5 tries" for said in _KINDS.values())} |
| --- | --- | --- | --- |
{
        chr(10).join(
            f"| {shape} | " + " | ".join(_list(kinds[kind]) for kind in _KINDS) + " |"
            for shape, kinds in summary["by_shape"].items()
        )
    }

## Look-alikes with hidden properties

Whether the first motion of a plan did as was promised of the object.

{
        _table(
            ["hidden", "tries", "domain with places", "domain without"],
            [
                *(
                    [
                        "all",
                        str(number),
                        *(_said(summary["all_lookalikes"][kind][at]) for kind in ("carry", "pushes")),
                    ]
                    for at, number in enumerate(TRIES)
                ),
                *(
                    [
                        hidden,
                        "0, 1, 3, 5",
                        *(_list(summary["by_lookalike"][kind][hidden]) for kind in ("carry", "pushes")),
                    ]
                    for hidden in LOOKALIKES
                ),
            ],
        )
    }

## Pushed only

Objects that no person finds a grasp for, one at a time, goals anywhere within 20 mm, with replanning:
{summary["pushed"]["reached"]} of {summary["pushed"]["tasks"]} reached, in {
        summary["pushed"]["motions"] or 0:.1f} motions on average.

## Sizes at an edge

Chances that are said of single motions with objects one of whose sizes is in the lowest or highest tenth, and
how often they came. The base is the Brier score if their own share was said of each.

{
        _table(
            ["size", "motions", "said", "came", "Brier", "base"],
            [
                [
                    name,
                    str(one["motions"]),
                    f"{one['said']:.2f}",
                    f"{one['kept']:.2f}",
                    f"{one['brier']:.3f}",
                    f"{one['base']:.3f}",
                ]
                for name, one in summary["edges"].items()
            ],
        )
    }
"""


def _table(heads: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    lines = [heads, ["---"] * len(heads), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def _said(one: Mapping[str, Any]) -> str:
    if not one["tasks"]:
        return "-"
    return f"{one['share']:.0%} ({100 * one['low']:.0f} to {100 * one['high']:.0f}) of {one['tasks']}"


def _list(shares: Sequence[Mapping[str, Any]]) -> str:
    return ", ".join("-" if one["share"] is None else f"{100 * one['share']:.0f}" for one in shares) + " %"
