"""The results of `evaluate.py` as a page of Markdown tables."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

from tools.benchmarks.paper_tables import KINDS, kinds_table
from tools.benchmarks.tables import NOT_YET, document, listed, table

BySeed = Mapping[str, Mapping[str, Any]]


def page(results: Mapping[str, Any]) -> str:
    """Write the page."""
    ours, missing = results["default_strategy"], results["missing"]
    rows = next((int(c["test_rows"]) for c in results["table1"][ours].values()), 0)
    return document(
        "# Learning, measured",
        f"By `{results['command']}`, which wrote this page and `learning.json`. "
        f"{results['steps']:,} interactions for each strategy and seed. "
        f"Machine: {listed(results['machine'])}. Mean ± standard deviation over seeds, as many as the column "
        "says; docs/learning.md says what is what."
        + (f" **Not finished**: {missing} jobs to do; the same command goes on." if missing else ""),
        "## What the bits hold",
        "R2 on random interactions of a seed of their own, mean of the three axes; the share is that through "
        "the codes over that of a network without a bottleneck on the same data.",
        _held(results["table1"]),
        f"R2 through the codes by axis, of *{ours}*. *Explained* is the R2 of the mean effect of each "
        "action code, and of each pair of codes, on the test interactions themselves: what the object's bits "
        "add. *Held* says how often objects of each code ended in the hand.",
        _by_axis(results["table1"][ours]),
        "## More bits, and fewer",
        _bits(results, ours),
        "*Clustering* puts the predicted effects of test actions on test objects themselves into as many "
        "kinds, seeing all of them: the share of their variance that is between kinds. It is a "
        "comparison and no bound, for R2 is that of what really happened.",
        "## The paper's choices, one at a time",
        f"Our defaults on the data of *{ours}*, with one thing changed; the last row changes all.",
        _variants(results, ours),
        "## Table I: errors of prediction",
        f"Mean absolute error [mm] on the {rows:,} first test interactions "
        "whose absolute displacements sum to 8 cm or more. *Always mean* and the median are those of the "
        "training data of *random*. *active* learns from such interactions only, which helps here and costs "
        "it below.",
        _table1(results["table1"], "mae"),
        "The same on all test interactions, small effects included:",
        _table1(results["table1"], "mae_unfiltered"),
        "How sure the model is (all test interactions; the baselines predict no distribution):",
        _calibration(results["table1"]),
        "## Table II: primitives",
        "In how many seeds each kind was found, by the rule in docs/learning.md.",
        table(*kinds_table(results["table2"], "seed")),
        "## Primitives, rehearsed",
        "How widely effects spread, of operators (a primitive on objects of one symbol) with 60 % or more of "
        "their rehearsals of one kind. The limit is 1 cm on each axis for grasps and placements, 2.5 cm for "
        "pushes.",
        _rehearsed(results["rehearsals"]),
        "## Choosing among distilled actions",
        _choices(results["choice"]),
        "## Where the strategies went",
        "Shares of their interactions. The hand is open or closed at each of three waypoints: eight "
        "patterns, of which an eighth each would be even.",
        _went(results["went"]),
    )


def _held(found: Mapping[str, BySeed]) -> str:
    def shares(cells: BySeed) -> str:
        """Tell the share of what can be known; where that is nothing, there is none."""
        nothing = any(c["r2_direct"] <= 0 for c in cells.values())
        return "none: R2 below 0" if nothing else _spread([c["share"] for c in cells.values()])

    def rarest(cells: BySeed, codes: str) -> str:
        return _spread([min(c[codes].values()) for c in cells.values()])

    rows = [
        [strategy, *_spread_of(cells, ["r2_through_codes", "r2_direct"]), shares(cells)]
        + [rarest(cells, codes) for codes in ("action_codes", "action_codes_in_training")]
        for strategy, cells in found.items()
    ]
    columns = "data of | seeds | R2 through codes | R2 without bottleneck | share"
    return table(f"{columns} | rarest action code, test | rarest, training data", rows)


def _first_seeds(cells: BySeed, others: Iterable[BySeed]) -> BySeed:
    """Keep the seeds that others were tried with, too."""
    seeds = {seed for other in others for seed in other}
    return {seed: c for seed, c in cells.items() if seed in seeds} or cells


def _by_axis(cells: BySeed) -> str:
    rows = [
        [seed, *(f"{r2:.2f}" for r2 in c["r2_through_codes_by_axis"]), f"{c['share']:.3f}"]
        + [f"{c['object_contrast'][name]:.2f}" for name in ("action_only", "action_and_object")]
        + [", ".join(f"{code} {held:.0%}" for code, held in c["object_contrast"]["held"].items())]
        for seed, c in cells.items()
    ]
    columns = "seed | x | y | z | share | explained by action codes | by action and object codes"
    return table(f"{columns} | held, by object code", rows)


def _bits(results: Mapping[str, Any], ours: str) -> str:
    few = _first_seeds(results["table1"][ours], results["bits"].values())
    rows = [
        [
            bits,
            *_spread_of(cells, ["r2_through_codes", "share"]),
            *_spread_of(results["clustered"], [bits])[1:],
        ]
        for bits, cells in sorted({**results["bits"], "2+3": few}.items())
    ]
    columns = "object + action bits | seeds | R2 through codes | share | share that clustering keeps"
    return table(columns, rows)


def _variants(results: Mapping[str, Any], ours: str) -> str:
    few = _first_seeds(results["table1"][ours], results["variants"].values())
    rows = []
    for name, cells in {"ours": few, **results["variants"]}.items():
        used = [sum(share > 0.03 for share in c["action_codes"].values()) for c in cells.values()]
        rows.append([name, *_spread_of(cells, ["r2_through_codes", "r2_direct"]), _spread(used, 1)])
    return table(" | seeds | R2 through codes | R2 without bottleneck | action codes above 3 %", rows)


def _table1(found: Mapping[str, BySeed], which: str) -> str:
    def row(title: str, cells: BySeed, name: str) -> list[str]:
        axes = [[1000 * c[which][name][axis] for c in cells.values()] for axis in range(3)]
        return [title, str(len(cells)), *(_spread(axis, 1) for axis in axes)]

    known = {name: cells for name, cells in found.items() if cells}
    some, direct = next(iter(known.values()), {}), "without a bottleneck"
    rows = [row(name, cells, "model") for name, cells in found.items()]
    rows += [row(f"{name}, {direct}", cells, direct) for name, cells in known.items()]
    rows += [row(name, some, name) for name in ("always zero", "always mean", "per-axis median")]
    return table(" | seeds | x | y | z", rows)


def _calibration(found: Mapping[str, BySeed]) -> str:
    rows = [
        [strategy, *_spread_of(cells, ["nll", "nll_of_constant_gaussian", "within_90"])]
        for strategy, cells in found.items()
        if cells and all("nll" in c for c in cells.values())
    ]
    return table(" | seeds | NLL | of one Gaussian for all | within 90 % interval", rows)


def _rehearsed(found: Mapping[str, BySeed]) -> str:
    rows = []
    for strategy, cells in found.items():
        for kind in KINDS:
            if of_kind := [row for row in _of_some_kind(cells) if row["kind"] == kind]:
                most = 10 if kind in ("grasp", "pick and place") else 25  # [mm]
                widest = [1000 * max(row["spread"]) for row in of_kind]
                within = f"{sum(spread < most for spread in widest)} of {len(of_kind)}"
                shares = [row["share"] for row in of_kind]
                rows.append([strategy, kind, _spread(shares), _spread(widest, 1), within])
    columns = " | kind | share of rehearsals | spread, worst axis [mm] | operators within the limit"
    return table(columns, rows)


def _of_some_kind(cells: BySeed) -> list[Mapping[str, Any]]:
    """List the operators that mostly did one kind of thing."""
    every = (row for c in cells.values() for row in c["operators"] if row["kind"] in KINDS)
    return [row for row in every if row["share"] >= 0.6 and row["objects"] >= 6]


def _choices(choices: Mapping[str, BySeed]) -> str:
    rows = []
    for name, cells in choices.items():
        kept = [row["share"] for row in _of_some_kind(cells)]
        errors = [max(c["code_errors"].values()) for c in cells.values()]
        seconds = [c["distillation_seconds"] for c in cells.values()]
        row = [_kinds_found(cells), str(len(kept)), _spread(kept), _spread(errors, 4), _spread(seconds, 1)]
        rows.append([name, str(len(cells)), *row])
    columns = "choice | seeds | kinds found | operators of some kind | share that turned out so"
    return table(f"{columns} | worst code error | distillation [s]", rows)


def _kinds_found(cells: BySeed) -> str:
    return _spread([sum(bool(pairs) for pairs in c["kinds"].values()) for c in cells.values()], 1)


def _went(found: Mapping[str, BySeed]) -> str:
    names = list(dict.fromkeys(name for cells in found.values() for c in cells.values() for name in c))
    return table(["", "seeds", *names], [[one, *_spread_of(cells, names)] for one, cells in found.items()])


def _spread_of(cells: BySeed, names: Iterable[str]) -> list[str]:
    """Write how many seeds there are, and mean and spread of figures over them."""
    return [str(len(cells)), *(_spread([c[name] for c in cells.values()]) for name in names)]


def _spread(values: Sequence[float], digits: int = 3) -> str:
    return f"{np.mean(values):.{digits}f} ± {np.std(values):.{digits}f}" if values else NOT_YET
