"""Names of categories, by what sets each apart from the others: `hollow-low-10`, `heavy-red-10`, `any-11`.

Sizes and types of our worlds have words of their own. Else it is the features of a user's that stand
furthest from those of other categories, measured in their usual spread within one.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from neurosym.checks import Float
from neurosym.data.axes import legal_name
from neurosym.operators import Category, Symbol

_CONTRAST = 0.1  # least relative difference of sizes to the other categories that is worth a word
_SURE = 0.75  # least share of one type that is worth a word
_APART = 1.0  # least difference of any other feature that is, in spreads within a category
_MOST_WORDS = 2
_WORDS = {
    **dict.fromkeys(("mass", "weight"), ("light", "heavy")),
    "length": ("short", "long"),
    "width": ("narrow", "wide"),
    "height": ("low", "tall"),
    "size": ("small", "large"),
    "temperature": ("cold", "warm"),
    "speed": ("slow", "fast"),
}


class Trait(NamedTuple):
    """A feature that sets a category apart: it lies over a threshold, or under it."""

    feature: str
    is_over: bool
    threshold: float
    word: str

    def __str__(self) -> str:
        return f"{self.feature} {'over' if self.is_over else 'under'} {self.threshold:.3g}"


def name_categories(
    symbols: Sequence[Symbol], members: Sequence[Float[np.ndarray, "_ F"]], feature_names: Sequence[str]
) -> tuple[str, ...]:
    """Name categories, each of which has some members; names are legal in PDDL, and end with the symbols."""
    types = np.array(feature_names) == "t"  # a type counts as hollow or not, however it is open
    means = np.array([np.where(types, rows >= 0.5, rows).mean(0) for rows in members])
    if {"t", "d", "s_x", "s_y"} & {*feature_names}:
        words = [_sizes(row, means, feature_names) for row in range(len(means))]
    else:
        spreads = np.array([rows.std(0) for rows in members])
        words = [
            [trait.word for trait in found] or ["kind"] for found in _traits(means, spreads, feature_names)
        ]
    return tuple("-".join([*said, symbol]) for said, symbol in zip(words, symbols, strict=True))


def traits_of(categories: Sequence[Category], feature_names: Sequence[str]) -> dict[Symbol, list[Trait]]:
    """Say what sets each category apart that was ever seen, see `name_categories`."""
    seen = [one for one in categories if one.feature_means]
    means, spreads = (
        np.array([getattr(one, f"feature_{of}") for one in seen]) for of in ("means", "spreads")
    )
    found = _traits(means, spreads, feature_names) if seen else []
    return {one.symbol: traits for one, traits in zip(seen, found, strict=True)}


def _sizes(row: int, means: Float[np.ndarray, "L F"], feature_names: Sequence[str]) -> list[str]:
    """Return words for the features s_x, s_y, d and t of one category; of t, how many are hollow."""
    columns = {name: means[:, number] for number, name in enumerate(feature_names)}
    words = ["kind"]
    if "t" in columns:
        share = columns["t"][row]
        words = ["hollow" if share >= _SURE else "solid" if share <= 1 - _SURE else "any"]
    for parts, less, more in ((("d",), "low", "tall"), (("s_x", "s_y"), "narrow", "wide")):
        if all(part in columns for part in parts):
            values = np.sum([columns[part] for part in parts], axis=0)
            usual = np.delete(values, row).mean() if len(values) > 1 else 0.0
            ratio = values[row] / usual if usual else 1.0
            words.append(less if ratio < 1 - _CONTRAST else more if ratio > 1 + _CONTRAST else "")
    return [*filter(None, words)]


def _traits(
    means: Float[np.ndarray, "L F"], spreads: Float[np.ndarray, "L F"], feature_names: Sequence[str]
) -> list[list[Trait]]:
    """Return what sets each category apart, the most telling first."""
    if len(means) < 2:
        return [[] for _ in means]
    usual = np.maximum(np.sqrt((spreads**2).mean(0)), 1e-9)
    others = (means.sum(0) - means) / (len(means) - 1)
    apart, thresholds = (means - others) / usual, (means + others) / 2
    flags = np.all(np.abs(spreads**2 - means * (1 - means)) < 1e-3, axis=0)  # 0 and 1 scatter like this

    def trait(row: int, column: int) -> Trait:
        name, is_over = feature_names[column], bool(apart[row, column] > 0)
        plain = legal_name(name)
        ways = (f"no-{plain}", plain) if flags[column] else (f"low-{plain}", f"high-{plain}")
        threshold = 0.5 if flags[column] else float(thresholds[row, column])
        return Trait(name, is_over, threshold, _WORDS.get(plain, ways)[is_over])

    return [
        [trait(row, column) for column in np.argsort(-np.abs(far), kind="stable")[:_MOST_WORDS].tolist()
         if abs(far[column]) >= _APART]
        for row, far in enumerate(apart)
    ]  # fmt: skip
