"""The page about data of a user's own: which things have which symbol, and what each action does to them."""

from collections import Counter
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from neurosym.checks import Float
from neurosym.data.category_names import Trait, traits_of
from neurosym.data.interactions import Interactions
from neurosym.files import read_json, read_text
from neurosym.learning.training_report import TrainingReport, error_table
from neurosym.report.charts import Axis, chart
from neurosym.stages import layout
from neurosym.stages.folder import DomainFolder, versions
from neurosym.stages.plan_records import PlanRecord
from neurosym.stages.value_stages import domain_of, symbols_of
from neurosym.values.domain import ValueDomain
from neurosym.values.value_execution import ValueRun
from neurosym.world import Palette

_DOTS = 600  # rows of the data that are drawn
_SEED = 7


def gather_values(folder: DomainFolder) -> dict[str, Any]:
    """Read what the template `values.html` shows, by name; what is missing is empty or None."""
    domain, data = domain_of(folder), Interactions.load(folder.require(layout.INTERACTIONS))
    symbols = symbols_of(folder).object_symbols(data.features)
    seen, traits = Counter(symbols), traits_of(domain.categories, domain.features)
    palette = Palette(symbol for symbol, _ in seen.most_common())
    axes = _telling(traits, domain.features)
    report = folder.found(layout.TRAINING, lambda path: read_json(path, TrainingReport))
    names = [axis.name for axis in domain.axes]
    return {
        "name": folder.path.resolve().name,
        "path": str(folder.path),
        "rows": len(data),
        "axes": [[cells.axis.name, cells.axis.kind, str(cells)] for cells in domain.cells],
        "kinds": [
            (
                one,
                palette.hex(one.symbol),
                seen[one.symbol] / len(data),
                ", ".join(map(str, traits[one.symbol])),
            )
            for one in sorted(domain.categories, key=lambda one: -seen[one.symbol])
            if seen[one.symbol]
        ],
        "dots": _dots(data.features, symbols, domain.features, axes, palette),
        "does": _does(domain),
        "verbs": _verbs(domain),
        "learned": report,
        "errors": error_table(report, names) if report else None,
        "plans": [read_json(path, PlanRecord) for path in sorted((folder / layout.PLANS).glob("*.json"))],
        "runs": {
            path.name.removesuffix(layout.RECORD): read_json(path, ValueRun)
            for path in sorted((folder / layout.RUNS).glob(f"*{layout.RECORD}"))
        },
        "text": read_text(folder.require(layout.DOMAIN)),
        "versions": versions(),
    }


def _telling(traits: Mapping[str, Sequence[Trait]], features: Sequence[str]) -> list[int]:
    """Return the two features that set most categories apart, or the first ones."""
    counts = Counter(trait.feature for found in traits.values() for trait in found)
    chosen = [*dict.fromkeys((*(name for name, _ in counts.most_common()), *features))][:2]
    return sorted(map(features.index, chosen))


def _dots(
    features: Float[np.ndarray, "N F"],
    symbols: Sequence[str],
    names: Sequence[str],
    by: Sequence[int],
    palette: Palette,
) -> dict[str, Any]:
    """Draw some rows by two features, or one; few values are strewn a little, lest dots lie on each other."""
    rng = np.random.default_rng(_SEED)
    rows = np.sort(rng.permutation(len(features))[:_DOTS])
    points, codes = features[rows][:, [by[0], by[-1]]].astype(float), np.array(symbols)[rows]
    room = np.ptp(points, axis=0) * 0.08 + 1e-6
    few = np.array([len(np.unique(column)) < 12 for column in points.T])
    points += few * room * rng.uniform(-0.5, 0.5, points.shape)
    low, high = points.min(0) - room / 4, points.max(0) + room / 4
    told, seen = [names[by[0]], names[by[-1]]], dict.fromkeys(codes.tolist())
    return chart(
        "dots",
        "Which things have which symbol",
        f"{len(rows):,} rows by {' and '.join(dict.fromkeys(told))}, in the colours of their symbols.",
        (Axis(told[0], low[0], high[0]), Axis(told[1], low[1], high[1])),
        {symbol: points[codes == symbol] for symbol in seen},
        [palette.hex(symbol) for symbol in seen],
    )


def _does(domain: ValueDomain) -> dict[str, list[tuple[str, str, float, str]]]:
    """List by the label of its action what each operator does to which category, and how often."""
    does: dict[str, list[tuple[str, str, float, str]]] = {}
    for one in domain.operators:
        share = one.outcome.count / one.trials
        told = domain.in_words(one), domain.category(one.category).name, share, one.name
        does.setdefault(one.label, []).append(told)
    return does


def _verbs(domain: ValueDomain) -> dict[str, str]:
    """Say by the label of an action what operators with it are called, like `push`, if all begin so."""
    verbs: dict[str, set[str]] = {}
    for one in domain.operators:
        verbs.setdefault(one.label, set()).add(one.name.partition(f"-{one.label}-")[0])
    return {label: found.pop() for label, found in verbs.items() if len(found) == 1}
