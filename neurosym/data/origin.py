"""What a data set says of how it came about: `origin`, and what can be wrong with it."""

import reprlib
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from typing import Any, Literal

import numpy as np

from neurosym.checks import Bool, Float
from neurosym.choices import DEFAULT_STRATEGY as DEFAULT_STRATEGY
from neurosym.choices import StrategyName as StrategyName
from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.operators import TOLERANCE
from neurosym.world import Mirror, column_problem

# What a network reads and writes, which is what a row of data holds


@dataclass(frozen=True, slots=True)
class Dimensions:
    """What the network reads and writes.

    Attributes:
        features: How many object features.
        actions: How many action parameters.
        effects: How many effect axes.
        gripper_columns: Which action parameters are gripper values.
    """

    features: int = 4
    actions: int = 12
    effects: int = 3
    gripper_columns: tuple[int, ...] = (3, 7, 11)

    def __post_init__(self) -> None:
        if min(self.features, self.actions, self.effects) < 1:
            raise InvalidValue(f"{self} must have at least one feature, action parameter and effect axis.")
        if not all(0 <= column < self.actions for column in self.gripper_columns):
            raise InvalidValue(f"gripper_columns = {self.gripper_columns} must be below {self.actions}.")


# Strategies of exploration: which candidate action to try next, and what the model learns from.
#
# `entropy`, also called `curiosity`, is the paper's (Algorithm 1): try what a Gaussian is least certain of.
# It is caught by what cannot be learned, such as whether a grasp will hold by a hair. `disagreement` asks
# several networks, and the more they disagree about an action, the likelier it is tried (Pathak, Gandhi and
# Gupta, 2019): they come to agree about noise. `random` and `active` are the paper's baselines, which
# predict the effect itself and not a distribution over it.

MIN_EFFECT = 0.08
"""Least sum of absolute displacements of a high effect [m]."""


@dataclass(frozen=True, slots=True)
class Strategy:
    """A way to explore, and to learn from it.

    Attributes:
        curious_about: What it looks for in the candidate actions; None takes a random one.
        head: What the final model predicts.
        learns_from: Says which interactions a model is trained on, from their effects (N, E) [m].
    """

    curious_about: Literal["entropy", "disagreement"] | None
    head: Literal["gaussian", "mean"]
    learns_from: Callable[[np.ndarray], np.ndarray]


def has_high_effect(effects: Float[np.ndarray, "N E"]) -> Bool[np.ndarray, "N"]:
    """Say which effects have a sum of absolute displacements of at least `MIN_EFFECT`."""
    return np.asarray(np.abs(effects).sum(1) >= MIN_EFFECT)


def is_any(effects: Float[np.ndarray, "N E"]) -> Bool[np.ndarray, "N"]:
    """Say yes to every effect."""
    return np.ones(len(effects), dtype=bool)


_ALIASES = {"curiosity": "entropy"}
STRATEGIES = {
    "disagreement": Strategy("disagreement", "gaussian", is_any),
    "entropy": Strategy("entropy", "gaussian", is_any),
    "random": Strategy(None, "mean", is_any),
    "active": Strategy(None, "mean", has_high_effect),
}


def own_name(name: str) -> str:
    """Return what a strategy is called, if it was called by another name.

    Args:
        name: One of `STRATEGIES`, or another name of one; any other is returned as it is.
    """
    return _ALIASES.get(name, name)


def strategy_named(name: str, min_predicted_effect: float = 0.0) -> Strategy:
    """Return a strategy.

    Args:
        name: One of `STRATEGIES`.
        min_predicted_effect: What it shall filter its candidates by [m]; 0 for no filter.

    Raises:
        UnknownChoice: If there is no such strategy.
        InvalidValue: If candidates cannot be filtered so.
    """
    name = own_name(name)
    if name not in STRATEGIES:
        raise UnknownChoice("strategy", name, STRATEGIES)
    if not 0 <= min_predicted_effect < np.inf:
        raise InvalidValue(f"min-predicted-effect = {min_predicted_effect} m must be at least 0.")
    if min_predicted_effect > 0 and not STRATEGIES[name].curious_about:
        curious = ", ".join(sorted(known for known in STRATEGIES if STRATEGIES[known].curious_about))
        raise InvalidValue(
            f"The strategy {name} predicts no effect that min-predicted-effect could compare; "
            f"valid with it: {curious}."
        )
    return STRATEGIES[name]


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


# What keeps a data set from being read or learned from: sentences that loading, training and `check` share.
#
# The functions look at the arrays of an .npz file by name, before they are known to fit together. Rows and
# columns are written like numpy's indices, `features[17, 2]`, and count from 0.

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
