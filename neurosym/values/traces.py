"""Bits out, bits in: traces of (bits, action symbol, bits), for learners of action models and from others.

A trace is a text table as macq reads it: columns of 0 and 1, `action`, and `plan_id`; the next row of a plan
says what an action led to. Where data are such bits already, they are the symbols, and no network is needed.
"""

import csv
import io
from collections.abc import Sequence

import numpy as np

from neurosym.checks import Float
from neurosym.data.axes import Axis
from neurosym.data.interactions import Interactions
from neurosym.data.origin import chosen
from neurosym.errors import InvalidValue
from neurosym.operators import Categorise, Category, OperatorTable, Primitive, Symbol
from neurosym.values.domain import shown_by

_MOST_BITS = 64


class GivenSymbols:
    """Symbols that data bring: the bits of a thing are its features, and an action is the number of a choice.

    Raises:
        InvalidValue: If features are no bits, or actions are not one choice.
    """

    def __init__(self, interactions: Interactions):
        self._data, actions = interactions, interactions.actions
        width, chosen = actions.shape[1], interactions.origin.get("choices", [])
        is_one = [*chosen] == [*range(width)] and np.all(actions.sum(1) == 1)
        is_bits = (
            np.isin(interactions.features, (0, 1)).all() and interactions.features.shape[1] <= _MOST_BITS
        )
        if not (is_one and is_bits):
            raise InvalidValue(
                "Features are no bits, or actions are not one choice, so symbols must be learned."
            )
        self._bits = max(1, (width - 1).bit_length())

    def object_symbols(self, features: Float[np.ndarray, "N F"]) -> tuple[Symbol, ...]:
        """Return the bits of things."""
        return tuple("".join("01"[int(value >= 0.5)] for value in row) for row in features.tolist())

    def action_symbols(self, actions: Float[np.ndarray, "N A"]) -> tuple[Symbol, ...]:
        """Return the numbers of choices, in bits."""
        return tuple(f"{number:0{self._bits}b}" for number in np.argmax(actions, axis=1).tolist())

    def table(self) -> OperatorTable:
        """Return all states that were seen as categories, and each choice as what an action is done with."""
        states, rows = np.unique(self._data.features, axis=0, return_inverse=True)
        shares = np.bincount(rows.ravel()) / len(rows)
        still, choices = (0.0,) * states.shape[1], np.eye(self._data.actions.shape[1])
        categories = [
            Category(symbol, f"state-{symbol}", float(share), tuple(map(float, state)), still)
            for symbol, share, state in zip(self.object_symbols(states), shares, states, strict=True)
        ]
        primitives = [
            Primitive(symbol, tuple(row), 0.0)
            for symbol, row in zip(self.action_symbols(choices), choices.tolist(), strict=True)
        ]
        return OperatorTable(tuple(categories), tuple(primitives), (), "data")


def traces_text(
    interactions: Interactions,
    axes: Sequence[Axis],
    *,
    object_symbols: Categorise,
    action_symbols: Categorise,
) -> str:
    """Write each interaction as a trace of one action, by the names that the data have, where these are bits.

    Raises:
        InvalidValue: If no feature shows what actions change, so that bits stay as they are.
    """
    names = tuple(interactions.origin.get("feature_names", ()))
    shown = [(n, by) for n, by in enumerate(shown_by(axes, names)) if by is not None]
    if not shown:
        raise InvalidValue(
            "No feature shows what actions change, so that bits stay as they are in all traces."
        )
    after = interactions.features.copy()
    for number, by in shown:
        after[:, by] += interactions.effects[:, number]
        if period := axes[number].period:  # an angle begins where its data begin
            first = interactions.features[:, by].min()
            after[:, by] = first + (after[:, by] - first) % period
    before, then = object_symbols(interactions.features), object_symbols(after)
    is_given = np.array_equal([[*map(int, one)] for one in before], interactions.features)
    bits = names if is_given else [f"bit-{number}" for number in range(1, len(before[0]) + 1)]
    actions = _named(action_symbols(interactions.actions), interactions)
    text = io.StringIO()
    table = csv.writer(text, lineterminator="\n")
    table.writerow([*bits, "action", "plan_id"])
    for row, (begins, action, ends) in enumerate(zip(before, actions, then, strict=True)):
        table.writerows([[*begins, action, row], [*ends, "", row]])
    return text.getvalue()


def _named(symbols: Sequence[Symbol], interactions: Interactions) -> list[str]:
    """Name action symbols after the choices that actions make, as far as each is of one."""
    words = [chosen(action, interactions.origin) or "act" for action in interactions.actions.tolist()]
    pairs = {*zip(symbols, words, strict=True)}
    if len(pairs) == len({*words}) == len({*symbols}) > 1:
        return words
    is_one = len(pairs) == len({*symbols})
    return [f"{word if is_one else 'act'}-{symbol}" for symbol, word in zip(symbols, words, strict=True)]
