"""What keeps a data set from being read or learned from: sentences that loading, training and `check` share.

The functions look at the arrays of an .npz file by name, before they are known to fit together. Rows and
columns are written like numpy's indices, `features[17, 2]`, and count from 0.
"""

from collections.abc import Collection, Mapping
from typing import Any

import numpy as np

from neurosym.data.dimensions import Dimensions
from neurosym.data.origin import (
    GREATEST,
    action_problems,
    and_more,
    is_explored,
    mirror_problems,
    misspelt_entries,
    name_problems,
    strategy_of,
)
from neurosym.operators import TOLERANCE

Columns = Mapping[str, np.ndarray]
"""Arrays of a data set, by name."""

REQUIRED = ("features", "actions", "effects")
FLAGS = ("held", "toppled", "lost")
LEAST_INTERACTIONS = 20
"""Fewest rows that some can be held out of."""

_NARROW = 3e-3
"""A standard deviation below this is damped by batch normalisation, which adds 1e-5 to the variance."""
_FAR = 100
"""Effects of more tolerances than this are hardly meant to be foretold so precisely."""


def file_problems(columns: Columns, origin: Mapping[str, Any], *, unread: Collection[str] = ()) -> list[str]:
    """List what keeps arrays from being a data set: their types, shapes and values, and the origin's.

    Args:
        columns: The arrays.
        origin: What the file says of how they came about.
        unread: Arrays that the file has, but that could not be read.
    """
    needed = ", ".join(REQUIRED)
    missing = [name for name in REQUIRED if name not in columns and name not in unread]
    problems = [f"it has no array {name!r} (needed: {needed})" for name in missing]
    sizes = {name: columns[name].shape for name in REQUIRED if _is_matrix(columns.get(name))}
    if any(shape[0] == 0 for shape in sizes.values()):
        return [*problems, "it holds no interactions"]
    for name, column in columns.items():
        problem = (
            _type_problem(name, column)
            or _shape_problem(name, column, columns)
            or _value_problem(name, column)
        )
        problems += [problem] if problem else []
    problems += name_problems(origin, sizes.get("features", (0, None))[1])
    if "actions" in sizes and columns["actions"].dtype.kind in "fiub":
        problems += action_problems(columns["actions"], origin)
    if "actions" in sizes and "effects" in sizes:
        problems += mirror_problems(origin, sizes["actions"][1], sizes["effects"][1])
    return problems


def training_problems(columns: Columns, origin: Mapping[str, Any]) -> list[str]:
    """List what keeps a data set from being learned from.

    What the world of an exploration holds fixed is no problem: the user asked for such a world.

    Args:
        columns: The arrays; those that are broken are passed over.
        origin: How they came about.
    """
    usable = {name: columns[name] for name in REQUIRED if _is_numeric(columns.get(name))}
    rows = min((len(column) for column in usable.values()), default=0)
    problems = [problem] if rows and (problem := too_few(rows) or _too_few_of(usable, origin)) else []
    if rows < 2 or is_explored(origin):
        return problems
    for name in ("features", "actions"):
        if name in usable:
            problems += [
                f"{_column_name(name, number, origin)} is {usable[name][0, number]:g} in every row, so that "
                "nothing can be learned from it; leave the column out, or let it vary"
                for number in _constant_columns(usable[name])
            ]
    if "effects" in usable and len(_constant_columns(usable["effects"])) == usable["effects"].shape[1]:
        problems.append("'effects' are the same in every row, so that there is nothing to predict")
    return problems


def warnings_about(columns: Columns, origin: Mapping[str, Any], given: tuple[str, ...]) -> list[str]:
    """List what a data set can be learned from with, but its maker may not have meant.

    Args:
        columns: The arrays of a data set without problems, missing ones filled in.
        origin: How they came about.
        given: Names of the arrays that stand in the file.
    """
    ignored = [name for name in given if name not in (*columns, "origin")]
    warnings = [f"the array {name!r} is not read (read are: {', '.join(columns)})" for name in ignored]
    for name in REQUIRED:
        constant = _constant_columns(columns[name])
        warnings += [f"{_column_name(name, number, origin)} never changes" for number in constant]
        if name != "effects":
            narrow = np.flatnonzero(columns[name].std(0) < _NARROW)
            warnings += [
                f"{_column_name(name, number, origin)} varies by less than {_NARROW:g}, which is hard "
                "to learn from; give it in a smaller unit"
                for number in narrow.tolist()
                if number not in constant
            ]
    for number in origin.get("gripper_columns", ()):
        values = columns["actions"][:, number]
        if values.min() < 0 or values.max() > 1:
            warnings.append(
                f"the gripper value actions[:, {number}] leaves the range from 0 (closed) to 1 (open)"
            )
        is_open = values >= 0.5
        if is_open.all() or not is_open.any():
            warnings.append(
                f"the gripper value actions[:, {number}] never crosses 0.5, between open and closed"
            )
    if columns["held"].any() and "resting_effects" not in given:
        warnings.append("without 'resting_effects', a held object is taken to rest where it was held")
    if columns["lost"].all():
        warnings.append("'lost' is true in every row, so that no effect counts as reached")
    greatest = float(np.abs(columns["effects"]).max())
    if greatest <= TOLERANCE:
        warnings.append(
            f"effects reach {greatest:g} only, and every outcome counts as promised within {TOLERANCE:g} of "
            "the mean, in their unit; give them in a smaller unit"
        )
    if greatest > _FAR * TOLERANCE:
        warnings.append(
            f"effects reach {greatest:g}, but an outcome counts as promised within {TOLERANCE:g} of the "
            "mean, in their unit; give them in a larger unit"
        )
    return warnings + misspelt_entries(origin)


def too_few(rows: int) -> str | None:
    """Say that there are too few interactions to train on, or return None.

    Args:
        rows: How many there are.
    """
    if rows >= LEAST_INTERACTIONS:
        return None
    return f"{rows} interactions are too few to train on; at least {LEAST_INTERACTIONS} are needed"


def _too_few_of(usable: Columns, origin: Mapping[str, Any]) -> str | None:
    """Say that too few interactions are such that the strategy which explored learns from them."""
    strategy = strategy_of(origin)
    if strategy is None or "effects" not in usable:
        return None
    learned = strategy.learns_from(usable["effects"])
    problem = too_few(int(learned.sum()))
    return (
        problem and f"of its {len(learned)} interactions, {origin['strategy']!r} learns from few: {problem}"
    )


def model_misfit(dimensions: Dimensions, columns: Columns, origin: Mapping[str, Any]) -> str | None:
    """Say that a model was trained on data of other dimensions, or return None.

    Args:
        dimensions: Those of the model.
        columns: The data.
        origin: What they say of how they came about.
    """
    takes = (dimensions.features, dimensions.actions, dimensions.effects)
    has = _widths(columns)
    if takes == has:
        return _gripper_misfit(dimensions, origin)
    return f"it was trained on {_counted(takes)}, and the data have {_counted(has)}; train it again"


def _gripper_misfit(dimensions: Dimensions, origin: Mapping[str, Any]) -> str | None:
    takes, has = list(dimensions.gripper_columns), list(origin.get("gripper_columns", ()))
    if sorted(takes) == sorted(has):
        return None
    return f"its gripper columns are {takes}, and those of the data {has}; train it again"


def world_misfit(name: str, takes: tuple[int, int, int], columns: Columns) -> str | None:
    """Say that data cannot come from a world, or return None.

    Args:
        name: Name of the world.
        takes: How many object features it has, action parameters it takes, and axes of effects.
        columns: The data.
    """
    if takes == (has := _widths(columns)):
        return None
    return (
        f"its rows have {_counted(has)}, and the {name} world has {_counted(takes)}; "
        "take world.toml away to average effects from the data"
    )


def _type_problem(name: str, column: np.ndarray) -> str | None:
    valid = "true and false" if name in FLAGS else "numbers"
    return None if column.dtype.kind in "fiub" else f"{name!r} holds {column.dtype}; valid: {valid}"


def _shape_problem(name: str, column: np.ndarray, columns: Columns) -> str | None:
    """Compare a shape with that of `features`, and with that of `effects` where it must be the same."""
    leader = columns.get("features")
    rows = len(leader) if leader is not None and _is_matrix(leader) else None
    if name in REQUIRED:
        fits = column.ndim == 2 and column.shape[1] > 0
        valid = f"({rows if rows is not None else 'rows'}, columns), with at least one column"
    else:
        like: tuple[int, ...] = ()
        if name == "resting_effects":
            if "effects" not in columns:
                return None  # there is nothing to compare with, which is told
            like = columns["effects"].shape[1:]
        fits = column.ndim == 1 + len(like) and column.shape[1:] == like
        valid = f"({', '.join(map(str, (rows if rows is not None else 'rows', *like)))}{'' if like else ','})"
    if fits and rows in (None, len(column)):
        return None
    return f"{name!r} has shape {column.shape}; valid: {valid}"


def _value_problem(name: str, column: np.ndarray) -> str | None:
    with np.errstate(all="ignore"):
        numbers = column.astype(np.float64)
    valid = "true and false (1 and 0)" if name in FLAGS else f"finite numbers up to {GREATEST:.2g}"
    bad = ~np.isin(numbers, (0, 1)) if name in FLAGS else ~(np.abs(numbers) <= GREATEST)
    if not bad.any():
        return None
    place = np.argwhere(bad)[0].tolist()
    return f"{name}{place} is {numbers[tuple(place)]:g}{and_more(bad)}; valid: {valid}"


def _is_matrix(column: np.ndarray | None) -> bool:
    return column is not None and column.ndim == 2


def _is_numeric(column: np.ndarray | None) -> bool:
    return column is not None and column.ndim == 2 and column.dtype.kind in "fiub"


def _constant_columns(column: np.ndarray) -> list[int]:
    with np.errstate(all="ignore"):
        stored = column.astype(np.float32)
    return [int(number) for number in np.flatnonzero((stored == stored[0]).all(0))]


def _column_name(name: str, number: int, origin: Mapping[str, Any]) -> str:
    names = origin.get("feature_names", ()) if name == "features" else ()
    known = not name_problems({"feature_names": names}, None) and number < len(names)
    return f"{name}[:, {number}]" + (f" ({names[number]})" if known else "")


def _widths(columns: Columns) -> tuple[int, int, int]:
    features, actions, effects = (columns[name].shape[1] for name in REQUIRED)
    return features, actions, effects


def _counted(widths: tuple[int, int, int]) -> str:
    kinds = ("object feature", "action parameter", "effect axis")
    words = [
        f"{n} {kind if n == 1 else kind.replace('axis', 'axe') + 's'}"
        for n, kind in zip(widths, kinds, strict=True)
    ]
    return f"{words[0]}, {words[1]} and {words[2]}"
