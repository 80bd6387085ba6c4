"""From rows of data to a domain of values: what each action does to each category, in cells.

What actions do is told from rows: those of the data, or rehearsals. Where an action turns out in several
ways on one category, each that is seen often enough is an operator of its own.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import msgspec
import numpy as np

from neurosym.checks import Bool, Float
from neurosym.data.axes import Axis, axes_in
from neurosym.data.cells import Cells, Step
from neurosym.data.interactions import Interactions
from neurosym.data.origin import chosen
from neurosym.errors import InvalidValue
from neurosym.operators import (
    MIN_CHANCE,
    MIN_TRIALS,
    Categorise,
    Category,
    OperatorTable,
    Primitive,
    name_axes,
    names_of_features,
)
from neurosym.values.domain import FORMAT, Outcome, ValueDomain, ValueOperator, shown_by

MOST_OUTCOMES = 4
"""So many outcomes of one action on one category are told apart at most."""


def compile_values(
    interactions: Interactions,
    table: OperatorTable,
    *,
    name: str,
    object_symbols: Categorise,
    action_symbols: Categorise,
    axes: Sequence[Axis] = (),
) -> ValueDomain:
    """Turn data and learned symbols into everything that planning with values needs.

    Args:
        interactions: The data.
        table: The parameters of action symbols, and the categories.
        name: Name of the domain.
        object_symbols: Gives the object symbols of features.
        action_symbols: Gives the action symbols of actions.
        axes: What effects are along; as the data say, if not given.

    Raises:
        InvalidValue: If there are other axes than effects have, or nothing can be planned with.
    """
    width, origin = interactions.effects.shape[1], interactions.origin
    names = names_of_features(interactions.features.shape[1], origin.get("feature_names", ()))
    given = axes or axes_in(origin.get("axes", [{"name": one} for one in name_axes(width)]), width)
    if len(given) != width:
        raise InvalidValue(f"There are {len(given)} axes, and effects have {width} columns; name each.")
    shown = shown_by(given, names)
    hidden = np.full(len(interactions), np.nan)
    before = [hidden if by is None else interactions.features[:, by].astype(float) for by in shown]
    rows = Rows(np.stack(before, axis=1), interactions.effects.astype(float))
    objects = np.array(object_symbols(interactions.features))
    actions = np.array(action_symbols(interactions.actions))
    groups = {
        (primitive, category): found
        for primitive in table.primitives
        for category in table.categories
        if len(found := rows[(objects == category.symbol) & (actions == primitive.symbol)])
    }
    axes = completed(given, [*groups.values()], shown=shown)
    return ValueDomain(
        format=FORMAT,
        name=name,
        features=names,
        axes=tuple(axes),
        categories=table.categories,
        primitives=table.primitives,
        operators=_operators(groups, axes, origin),
    )


def _operators(
    groups: "Mapping[tuple[Primitive, Category], Rows]", axes: Sequence[Axis], origin: Mapping[str, Any]
) -> tuple[ValueOperator, ...]:
    """Return an operator for each outcome that is planned with, by its name.

    A name begins with the choice that is made, or else with what the outcome does.
    """
    outcomes = {
        key: [one for one in outcomes_of(found, axes) if is_worth(one, len(found))]
        for key, found in groups.items()
    }
    steps = [one.steps for found in outcomes.values() for one in found]
    along = [[step.by for step in one] for one in zip(*steps, strict=True)]
    drifts = [int(np.clip(0, min(one), max(one))) for one in along]
    operators = dict[str, ValueOperator]()
    for (primitive, category), told in outcomes.items():
        trials = len(groups[primitive, category])
        for outcome in told:
            verb = chosen(primitive.action, origin) or name_of(outcome, axes, drifts)
            plain = f"{verb}-{primitive.label}-{category.name}"
            others = (f"{plain}-or-{letter}" for letter in "abcdefgh")
            name = next(one for one in (plain, *others) if one not in operators)
            operators[name] = ValueOperator(
                name, category.symbol, primitive.symbol, trials, outcome, primitive.variant
            )
    if not operators:
        sizes = ", ".join(f"{axis.name} {axis.cell or 1:g}" for axis in axes)
        raise InvalidValue(
            f"No action mostly changes anything by more than half a cell, so nothing can be planned; cells "
            f"are of {sizes}. Give smaller ones, or another kind of axis, in world.toml."
        )
    return tuple(operators[one] for one in sorted(operators))


@dataclass(frozen=True)
class Rows:
    """What one action did to things of one category, a row each.

    Attributes:
        before: What each axis was; NaN where no feature shows it.
        effects: Changes; where nothing shows a set axis, what it is afterwards.
    """

    before: Float[np.ndarray, "N E"]
    effects: Float[np.ndarray, "N E"]

    def __len__(self) -> int:
        return len(self.effects)

    def __getitem__(self, rows: np.ndarray) -> "Rows":
        return Rows(self.before[rows], self.effects[rows])

    @cached_property
    def after(self) -> Float[np.ndarray, "N E"]:
        """What each axis is afterwards, where that is known."""
        return np.where(np.isnan(self.before), self.effects, self.before + self.effects)


def outcomes_of(rows: Rows, axes: Sequence[Axis]) -> tuple[Outcome, ...]:
    """Tell apart how an action turned out, the likeliest first.

    An outcome is what most rows have in common within the tolerance of each axis. What is left then has
    another one, as long as that is seen often enough.
    """
    found, left, total = list[Outcome](), rows, len(rows)
    while len(found) < MOST_OUTCOMES and len(left) >= max(1, MIN_CHANCE * total):
        members, outcome = _commonest(left, axes, total)
        if len(found) and members.sum() < MIN_CHANCE * total:
            break
        found.append(outcome)
        left = left[~members]
    return tuple(sorted(found, key=lambda one: -one.count))


_MEDOIDS = 200  # rows that are tried as the middle of an outcome


def _commonest(rows: Rows, axes: Sequence[Axis], total: int) -> tuple[Bool[np.ndarray, " N"], Outcome]:
    """Return which rows turned out in the commonest way, and that way."""
    near = np.ones((min(len(rows), _MEDOIDS), len(rows)), dtype=bool)
    for number, axis in enumerate(axes):
        if not axis.is_set:
            values = rows.effects[:, number]
            near &= axis.are_near(values[None, :], values[: len(near), None])
    members = near[near.sum(axis=1).argmax()]
    steps, means = list[Step](), list[float]()
    for number, axis in enumerate(axes):
        values, cells, mean = rows.effects[:, number], Cells(axis), 0.0
        if axis.is_set:
            after = np.array([cells.clipped(value) for value in rows.after[:, number]])
            to = int(np.bincount(after[members], minlength=cells.count).argmax())
            is_to = after == to
            stays = ~np.isnan(rows.before[:, number]) & (np.abs(values) < cells.size / 2)
            is_still = stays[members].sum() >= is_to[members].sum()
            members = members & (stays if is_still else is_to)
            steps.append(Step() if is_still else Step(to=to))
        else:
            around = values[members][:1]
            mean = float(around[0] + axis.difference(values[members], around).mean())
            members = members & axis.are_near(values, np.array([mean]))
            steps.append(Step(cells.shift(mean)))
        means.append(round(mean, 9))
    count = int(members.sum())
    return members, Outcome(tuple(steps), count, count / total, tuple(means))


def is_worth(outcome: Outcome, trials: int) -> bool:
    """Say whether an outcome is planned with: it was seen often enough, and something changes."""
    enough = trials >= MIN_TRIALS and outcome.count >= MIN_CHANCE * trials
    return enough and not all(step.stays for step in outcome.steps)


def name_of(outcome: Outcome, axes: Sequence[Axis], drifts: Sequence[int]) -> str:
    """Say in a word or two what an outcome does most of: `raise-angle`, `set-open-yes`.

    What all outcomes do at least, as to sink by a cell, tells none from another: a drift.
    """
    far = [
        (not one.stays, one.to is not None, abs(one.by - drift))
        for one, drift in zip(outcome.steps, drifts, strict=True)
    ]
    number = max(range(len(far)), key=lambda number: far[number])
    step, axis = outcome.steps[number], axes[number]
    if step.to is not None:
        return f"set-{Cells(axis).name(step.to)}"
    return f"{'raise' if step.by > 0 else 'lower'}-{axis.name}"


# What is not said of axes is measured on the data

_ROUND = (1.0, 2.0, 2.5, 5.0, 10.0)
_FINE = 8
"""So many cells a usual change is at least, if it is not as sure as that."""
_WIDE = 6.0
"""How many of the largest changes bounds are apart, where nothing shows what values there are."""
_MOST = 60  # cells of an axis, unless its user says how large they are
_MOST_HIDDEN = 300  # the same where no feature shows it, so that no state of a thing is in one of these


def completed(
    axes: Sequence[Axis], groups: Sequence[Rows], *, shown: Sequence[int | None]
) -> tuple[Axis, ...]:
    """Fill in what is not said of axes from what each action did to each category.

    Cells are as large as outcomes scatter, or as the least of sure changes. Bounds hold all values that were
    seen. What comes within two thirds of a cell and twice what is usual counts as promised; where no feature
    shows an axis and cells are finer, within a quarter of a usual change.
    """
    return tuple(
        _completed(axis, [rows.before[:, n] for rows in groups], [rows.effects[:, n] for rows in groups], by)
        for n, (axis, by) in enumerate(zip(axes, shown, strict=True))
    )


def _completed(
    axis: Axis, befores: Sequence[np.ndarray], changes: Sequence[np.ndarray], by: int | None
) -> Axis:
    if axis.kind == "flag":
        return axis
    every, before = np.concatenate(changes), np.concatenate(befores)
    known = every if by is None else np.concatenate([before, before + every])
    if axis.is_set:
        values = np.unique(np.round(known, 6))
        gaps = np.diff(values)
        cell = axis.cell or float(gaps.min() if len(gaps) else 1.0)
        low, high = float(values[0]), float(max(values[-1], values[0] + cell))
        return _filled(axis, cell, low, high, cell / 2)
    middles = np.array([float(np.median(one)) for one in changes])
    off = [np.abs(axis.difference(*pair)) for pair in zip(changes, middles[:, None], strict=True)]
    spread = float(np.median([np.median(one) for one in off])) * 1.5
    moved = np.abs(middles)[np.abs(middles) > max(2 * spread, 1e-9)]  # by how much what moves it does
    usual = float(np.median(moved)) if len(moved) else max(spread, 1e-3)
    cell = axis.cell or _whole(every) or _fitting(moved, round_down(max(spread, usual / _FINE)), axis.period)
    if axis.period is not None:
        if axis.cell is None and axis.period / cell > _MOST:
            cell = _fitting(moved, axis.period / _MOST, axis.period)
        first = 0.0 if by is None else math.floor(before.min() / cell + 1e-6) * cell
        return _filled(axis, cell, first or None, None, max(cell * 2 / 3, 2 * spread))
    reach, most = _WIDE * float(np.abs(every).max()) or 1.0, _MOST_HIDDEN if by is None else _MOST
    low, high = (-reach, reach) if by is None else (float(known.min()), float(known.max()))
    if axis.cell is None and (high - low) / cell > most:
        cell = _fitting(moved, round_down((high - low) / most * 2), None)
    least = 2 * usual / _FINE if by is None else 0.0
    low, high = math.floor(low / cell + 1e-6) * cell, math.ceil(high / cell - 1e-6) * cell
    return _filled(axis, cell, low, max(high, low + cell), max(cell * 2 / 3, 2 * spread, least))


def _fitting(steps: np.ndarray, cell: float, period: float | None) -> float:
    """Return a cell about as large as one of which steps are nearly whole multiples, lest rounding adds up.

    Of an angle, the period is a whole multiple, too.
    """
    few, many = 0.6 * cell, 1.5 * cell
    if period:
        others = [period / count for count in range(max(2, math.ceil(period / many)), int(period / few) + 1)]
    else:
        others = [step / count for step in steps.tolist() for count in range(1, int(step / few) + 1)]
    sizes = np.array([cell, *(one for one in others if few <= one <= many)])
    if not len(steps):
        return cell
    lost = [float(np.mean(np.abs(steps - np.round(steps / size) * size) / steps)) for size in sizes]
    best = min(range(len(sizes)), key=lambda n: (round(lost[n], 2), abs(math.log(sizes[n] / cell))))
    return float(sizes[best]) if period else float(f"{sizes[best]:.3g}")


def _whole(changes: np.ndarray) -> float:
    """Return what all changes are whole multiples of, if they are few different ones; else 0."""
    sizes = np.unique(np.round(np.abs(changes), 4))
    sizes = sizes[sizes > 0]
    multiples = sizes / sizes[0] if 0 < len(sizes) <= _MOST else np.array([0.5])
    return float(sizes[0]) if np.allclose(multiples, np.round(multiples), atol=0.01) else 0.0


def _filled(axis: Axis, cell: float, low: float | None, high: float | None, tolerance: float) -> Axis:
    """Fill in what is not said of an axis."""
    digits = {"cell": cell, "low": low, "high": high, "tolerance": max(tolerance, cell / 2)}
    said = {key: value if value is None else round(float(value), 9) for key, value in digits.items()}
    return msgspec.structs.replace(
        axis, **{key: value for key, value in said.items() if getattr(axis, key) is None}
    )


def round_down(number: float) -> float:
    """Return the greatest of 1, 2, 2.5, 5 times a power of ten that is not above a number."""
    power = 10.0 ** math.floor(math.log10(number))
    return max(part * power for part in _ROUND if part * power <= number * (1 + 1e-9))
