"""What a data set says of how it came about: `origin`, and what can be wrong with it."""

import reprlib
from collections.abc import Mapping
from difflib import get_close_matches
from typing import Any

import numpy as np

from neurosym.actions import Mirror, column_problem
from neurosym.arrays import Bool, Float
from neurosym.strategies import STRATEGIES, Strategy

GREATEST = 1e9
"""Greatest number that is taken for data; far below where sums of squares overflow 32 bits."""

READ = ("gripper_columns", "action_low", "action_high", "mirrors", "feature_names", "format")
"""Entries that are read of the origin of data of a user's own."""


_OF_EXPLORATION = {"world", "strategy", "seed", "candidates", "block", "learning", "model"}
"""Entries that `neurosym explore` always writes."""


def is_explored(origin: Mapping[str, Any]) -> bool:
    """Say whether `neurosym explore` made a data set."""
    return origin.keys() >= _OF_EXPLORATION


def strategy_of(origin: Mapping[str, Any]) -> Strategy | None:
    """Return the strategy by which `neurosym explore` made a data set; None if it did not."""
    return STRATEGIES.get(str(origin["strategy"])) if is_explored(origin) else None


def misspelt_entries(origin: Mapping[str, Any]) -> list[str]:
    """List the entries that are not read, but are nearly called like one that is."""
    near = {name: get_close_matches(name, READ, n=1, cutoff=0.8) for name in origin if name not in READ}
    return [
        f"the entry {name!r} of the origin is not read, but {found[0]!r} is"
        for name, found in near.items()
        if found
    ]


def name_problems(origin: Mapping[str, Any], features: int | None) -> list[str]:
    """List what is wrong with the names of the features.

    Args:
        origin: May hold `feature_names`.
        features: How many features there are, if that is known.
    """
    if "feature_names" not in origin:
        return []
    names = origin["feature_names"]
    is_list = _is_list_of(names, str) and len(set(names)) == len(names)
    if not is_list or not all(name and name.isprintable() for name in names):
        return [f"its origin has feature_names = {reprlib.repr(names)}; valid: a list of different names"]
    if features is not None and len(names) != features:
        return [f"its origin has {len(names)} feature_names; valid: {features}, one for each"]
    return []


def action_problems(actions: np.ndarray, origin: Mapping[str, Any]) -> list[str]:
    """List what is wrong with the gripper columns and the action box, and the first action outside of it.

    Args:
        actions: The actions, N rows of A numbers.
        origin: May hold `gripper_columns`, `action_low` and `action_high`.
    """
    width = actions.shape[1]
    problems = _gripper_problems(origin, width)
    bounds = [name for name in ("action_low", "action_high") if name in origin]
    wrong = [
        f"its origin has {name} = {reprlib.repr(origin[name])}; valid: a list of {width} finite numbers"
        for name in bounds
        if not _is_list_of(origin[name], int | float)
        or len(origin[name]) != width
        or not all(abs(number) <= GREATEST for number in origin[name])
    ]
    if wrong or not bounds:
        return problems + wrong
    return problems + _box_problems(actions, origin)


def mirror_problems(origin: Mapping[str, Any], actions: int, effects: int) -> list[str]:
    """List what is wrong with the mirrors.

    Args:
        origin: May hold `mirrors`, and `gripper_columns`.
        actions: How many action parameters there are.
        effects: How many effect axes there are.
    """
    mirrors = origin.get("mirrors", [])
    if not _is_list_of(mirrors, dict) or not all(_is_mirror(mirror) for mirror in mirrors):
        return [
            f"its origin has mirrors = {reprlib.repr(mirrors)}; "
            'valid: a list of {"actions": [numbers], "effects": [numbers]}'
        ]
    columns = origin.get("gripper_columns", [])
    grippers = columns if _is_list_of(columns, int) else []
    return [
        f"its origin has the mirror {reprlib.repr(given)}; {problem}"
        for given, mirror in zip(mirrors, mirrors_of(origin), strict=True)
        if (problem := column_problem(mirror, actions, effects, grippers))
    ]


def mirrors_of(origin: Mapping[str, Any]) -> tuple[Mirror, ...]:
    """Return the mirrors in which what a data set tells of looks the same; none where it names none.

    Args:
        origin: May hold `mirrors`, with nothing wrong.
    """
    return tuple(Mirror(tuple(m["actions"]), tuple(m["effects"])) for m in origin.get("mirrors", ()))


def _is_mirror(value: Mapping[str, Any]) -> bool:
    return value.keys() == {"actions", "effects"} and all(_is_list_of(part, int) for part in value.values())


def _gripper_problems(origin: Mapping[str, Any], width: int) -> list[str]:
    columns = origin.get("gripper_columns", [])
    if _is_list_of(columns, int) and len(set(columns) & set(range(width))) == len(columns):
        return []
    return [
        f"its origin has gripper_columns = {reprlib.repr(columns)}; "
        f"valid: a list of different whole numbers from 0 to {width - 1}"
    ]


def _box_problems(actions: np.ndarray, origin: Mapping[str, Any]) -> list[str]:
    """Check the box and that actions lie in it, both rounded as actions are stored."""
    given = {name: origin[name] for name in ("action_low", "action_high") if name in origin}
    low, high, _ = box_of(actions, given)
    if len(given) == 2:
        empty = low > high if is_explored(origin) else low >= high
        if empty.any():
            number = int(np.argmax(empty))
            pair = f"action_low[{number}] = {low[number]:g} and action_high[{number}] = {high[number]:g}"
            return [f"its origin has {pair}; valid: the first below the second"]
    with np.errstate(all="ignore"):
        stored, low, high = (part.astype(np.float32) for part in (actions, low, high))
        outside = (stored < low) | (stored > high)
    if not outside.any():
        return []
    row, number = np.argwhere(outside)[0].tolist()
    return [
        f"actions[{row}, {number}] is {stored[row, number]:g}{and_more(outside)}, outside of the action box "
        f"of its origin; valid: {low[number]:g} to {high[number]:g}"
    ]


def box_of(
    actions: Float[np.ndarray, "N A"], origin: Mapping[str, Any]
) -> tuple[Float[np.ndarray, "A"], Float[np.ndarray, "A"], Bool[np.ndarray, "A"]]:
    """Return the least and greatest value of each action parameter, and which are gripper values.

    Args:
        actions: The actions, whose own bounds are taken where the origin names none.
        origin: May hold `action_low`, `action_high` and `gripper_columns`.
    """
    low = np.asarray(origin.get("action_low", actions.min(0)), dtype=np.float64)
    high = np.asarray(origin.get("action_high", actions.max(0)), dtype=np.float64)
    is_gripper = np.isin(np.arange(actions.shape[1]), origin.get("gripper_columns", ()))
    return low, high, is_gripper


def and_more(bad: np.ndarray) -> str:
    """Say how many entries more than the first are bad."""
    count = int(bad.sum()) - 1
    return f" (and {count} more like it)" if count else ""


def _is_list_of(value: object, kind: Any) -> bool:
    """Say whether a JSON value is a list of such entries; true and false are no numbers."""
    return isinstance(value, list) and all(isinstance(v, kind) and not isinstance(v, bool) for v in value)
