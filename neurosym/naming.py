"""Names that a person can read, for categories and operators, from what was measured.

Forward is +x (away from the robot), back is -x, left is +y. A name ends with the bits it stands for, so that
it is unique, and matches `[a-z][a-z0-9-]*`, so that it is legal in PDDL.
"""

from collections.abc import Sequence

import numpy as np

from neurosym.arrays import Float
from neurosym.operators import PROMISING, Mode
from neurosym.symbols import Symbol

CARRIED = 0.02
"""Least height on the way of an object that was carried and not pushed [m]."""

NO_EFFECT = 0.01
"""Displacements below this are none [m]."""

_DIAGONAL = 0.5  # least share of the lesser axis in the greater that is worth a word
_CONTRAST = 0.1  # least relative difference to the other categories that is worth a word
_SURE = 0.75  # least share of one type that is worth a word


def name_categories(
    symbols: Sequence[Symbol], means: Float[np.ndarray, "L F"], feature_names: Sequence[str]
) -> tuple[str, ...]:
    """Name categories by what sets each apart from the others: `hollow-low-10`, `solid-wide-01`, `any-11`.

    Args:
        symbols: The object symbols.
        means: Mean features of each category; of t, the share that is hollow.
        feature_names: What the features are; of s_x, s_y, d and t those are used that are there.
    """
    columns = {name: means[:, number] for number, name in enumerate(feature_names)}
    names = []
    for row, symbol in enumerate(symbols):
        words = [_type_word(columns["t"][row]) if "t" in columns else "kind"]
        if "d" in columns:
            words.append(_contrast(columns["d"], row, "low", "tall"))
        if "s_x" in columns and "s_y" in columns:
            words.append(_contrast(columns["s_x"] + columns["s_y"], row, "narrow", "wide"))
        names.append("-".join([*filter(None, words), symbol]))
    return tuple(names)


def names_of_features(count: int, given: Sequence[str] = ()) -> tuple[str, ...]:
    """Return the names of object features: those given, or `f1`, `f2`, ...

    Args:
        count: How many features there are.
        given: Their names, if they have any.
    """
    return tuple(given) or tuple(f"f{number}" for number in range(1, count + 1))


def name_axes(count: int) -> tuple[str, ...]:
    """Name the axes of an effect: x, y and z if there are three, else `e1`, `e2`, ...

    Args:
        count: How many axes there are.
    """
    return ("x", "y", "z") if count == 3 else tuple(f"e{number}" for number in range(1, count + 1))


def counted_axes(count: int) -> str:
    """Say how many axes there are: `1 axis`, `2 axes`."""
    return f"{count} {'axis' if count == 1 else 'axes'}"


def name_operator(primitive: str, category_name: str, modes: Sequence[Mode]) -> str:
    """Name an operator by what it does: `push-left-101b-hollow-low-10`.

    Args:
        primitive: Label of the primitive.
        category_name: Name of the category.
        modes: The outcomes seen, most frequent first.
    """
    promised = next((mode for mode in modes if mode.kind in PROMISING), modes[0])
    return f"{verb(promised)}-{primitive}-{category_name}"


def verb(mode: Mode) -> str:
    """Say in a word or three what happened to the object: `act`, where effects are not along x, y and z."""
    if mode.kind == "held":
        return "lift"
    if mode.kind in ("carried", "missed"):
        return "carry-to" if mode.kind == "carried" else "miss"
    if mode.kind == "lost":
        return "throw-off"
    if mode.kind == "toppled":
        return "topple"
    if len(mode.resting_effect) != 3:
        return "act"
    x, y, z = mode.resting_effect
    if np.hypot(x, y) < NO_EFFECT:
        return "stay" if abs(z) < NO_EFFECT else "raise" if z > 0 else "lower"
    if mode.peak_height > CARRIED:
        return f"place-{_direction(x, y)}"
    return f"push-{_direction(x, y)}".replace("push-back", "pull")


def _direction(x: float, y: float) -> str:
    along_x, along_y = ("forward" if x > 0 else "back"), ("left" if y > 0 else "right")
    if min(abs(x), abs(y)) >= _DIAGONAL * max(abs(x), abs(y)):
        return f"{along_x}-{along_y}"
    return along_x if abs(x) >= abs(y) else along_y


def _type_word(share_hollow: float) -> str:
    if share_hollow >= _SURE:
        return "hollow"
    return "solid" if share_hollow <= 1 - _SURE else "any"


def _contrast(values: np.ndarray, row: int, less: str, more: str) -> str:
    others = np.delete(values, row)
    if not len(others) or others.mean() == 0:
        return ""
    ratio = values[row] / others.mean()
    return less if ratio < 1 - _CONTRAST else more if ratio > 1 + _CONTRAST else ""
