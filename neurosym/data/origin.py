"""What a data set says of how it came about: `origin`, and what can be wrong with it."""

import reprlib
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from typing import Annotated, Any, Literal

import msgspec
import numpy as np

from neurosym.checks import Bool, Float
from neurosym.choices import DEFAULT_STRATEGY as DEFAULT_STRATEGY
from neurosym.choices import StrategyName as StrategyName
from neurosym.data.axes import axes_in, check_flags, legal_name
from neurosym.errors import InvalidValue, UnknownChoice, counted
from neurosym.operators import TOLERANCE
from neurosym.world import Mirror, column_problem

# What a network reads and writes, which is what a row of data holds


@dataclass(frozen=True, slots=True)
class Dimensions:
    """What the network reads and writes."""

    features: int = 4  # how many object features
    actions: int = 12  # how many action parameters
    effects: int = 3  # how many effect axes
    gripper_columns: tuple[int, ...] = (3, 7, 11)  # which action parameters are gripper values
    unshown: tuple[int, ...] = ()  # which object features it is not shown

    def __post_init__(self) -> None:
        if min(self.features, self.actions, self.effects) < 1:
            raise InvalidValue(f"{self} must have at least one feature, action parameter and effect axis.")
        if not all(0 <= column < self.actions for column in self.gripper_columns):
            raise InvalidValue(f"gripper_columns = {self.gripper_columns} must be below {self.actions}.")
        if not all(0 <= column < self.features for column in self.unshown):
            raise InvalidValue(f"unshown = {self.unshown} must be below {self.features}.")


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
    """A way to explore, and to learn from it."""

    # what it looks for in the candidate actions; None takes a random one
    curious_about: Literal["entropy", "disagreement"] | None
    head: Literal["gaussian", "mean"]  # what the final model predicts
    is_picky: bool = False  # whether the final model learns from high effects only

    def learns_from(self, effects: Float[np.ndarray, "N E"]) -> Bool[np.ndarray, "N"]:
        """Say which interactions a model is trained on, from their effects [m]."""
        return has_high_effect(effects) if self.is_picky else np.ones(len(effects), dtype=bool)


def has_high_effect(effects: Float[np.ndarray, "N E"]) -> Bool[np.ndarray, "N"]:
    """Say which effects have a sum of absolute displacements of at least `MIN_EFFECT`."""
    return np.asarray(np.abs(effects).sum(1) >= MIN_EFFECT)


STRATEGIES = {
    "disagreement": Strategy("disagreement", "gaussian"),
    "entropy": Strategy("entropy", "gaussian"),
    "random": Strategy(None, "mean"),
    "active": Strategy(None, "mean", is_picky=True),
}


def own_name(name: str) -> str:
    """Return what a strategy is called that may have been called by another name."""
    return "entropy" if name == "curiosity" else name


def strategy_named(name: str) -> Strategy:
    """Return a strategy, or raise `UnknownChoice`."""
    name = own_name(name)
    if name not in STRATEGIES:
        raise UnknownChoice("strategy", name, STRATEGIES)
    return STRATEGIES[name]


_OF_EXPLORATION = {"world", "strategy", "seed", "candidates", "block", "learning", "model"}
"""Entries that `neurosym explore` always writes."""


def is_explored(origin: Mapping[str, Any]) -> bool:
    """Say whether `neurosym explore` made a data set."""
    return origin.keys() >= _OF_EXPLORATION


def strategy_of(origin: Mapping[str, Any]) -> Strategy | None:
    """Return the strategy by which `neurosym explore` made a data set; None if it did not."""
    return STRATEGIES.get(str(origin["strategy"])) if is_explored(origin) else None


def chosen(action: Sequence[float], origin: Mapping[str, Any]) -> str:
    """Name what an action chooses, if all of it is one choice, like `gear=2` or `move=left`; else nothing."""
    names, choices = origin.get("action_names", ()), origin.get("choices", ())
    if len({name.partition("=")[0] for name in names}) != 1 or [*choices] != [*range(len(action))]:
        return ""
    what, _, value = names[int(np.argmax(action))].partition("=")
    return legal_name(value if value[:1].isalpha() else f"{what} {value}")


def mirrors_of(origin: Mapping[str, Any]) -> tuple[Mirror, ...]:
    """Return the mirrors in which what a data set tells of looks the same; none where it names none.

    Args:
        origin: May hold `mirrors`, with nothing wrong.
    """
    return tuple(Mirror(tuple(m["actions"]), tuple(m["effects"])) for m in origin.get("mirrors", ()))


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

_GREATEST = 1e9
"""Greatest number that is taken for data; far below where sums of squares overflow 32 bits."""
_FEW = 12  # whole numbers in all that an action parameter holds, and that may be choices
_NARROW = 3e-3
"""A standard deviation below this is damped by batch normalisation, which adds 1e-5 to the variance."""
_FAR = 100
"""Effects of more tolerances than this are hardly meant to be foretold so precisely."""
_Bound = Annotated[float, msgspec.Meta(ge=-_GREATEST, le=_GREATEST)]


class _Mirror(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    actions: tuple[int, ...]
    effects: tuple[int, ...]


class _Read(msgspec.Struct, frozen=True):
    """The entries that are read of the origin of data of a user's own, besides `format`."""

    gripper_columns: tuple[int, ...] = ()
    action_low: tuple[_Bound, ...] = ()
    action_high: tuple[_Bound, ...] = ()
    mirrors: tuple[_Mirror, ...] = ()
    feature_names: tuple[str, ...] = ()
    unshown: tuple[int, ...] = ()
    action_names: tuple[str, ...] = ()
    choices: tuple[int, ...] = ()
    axes: tuple[dict[str, Any], ...] = ()


def file_problems(columns: Columns, origin: Mapping[str, Any], *, unread: Collection[str] = ()) -> list[str]:
    """List what keeps arrays from being a data set: their types, shapes and values, and the origin's."""
    needed = ", ".join(REQUIRED)
    missing = [name for name in REQUIRED if name not in columns and name not in unread]
    problems = [f"it has no array {name!r} (needed: {needed})" for name in missing]
    if any(columns[name].ndim == 2 and not len(columns[name]) for name in REQUIRED if name in columns):
        return [*problems, "it holds no interactions"]
    told = (_column_problem(name, column, columns) for name, column in columns.items())
    return [*problems, *(problem for problem in told if problem), *_origin_problems(origin, columns)]


def _column_problem(name: str, column: np.ndarray, columns: Columns) -> str | None:
    """Say what is wrong with an array: its type, its shape, or the first of its values; or return None."""
    is_flag, leader = name in FLAGS, columns.get("features")
    if column.dtype.kind not in "fiub":
        return f"{name!r} holds {column.dtype}; valid: {'true and false' if is_flag else 'numbers'}"
    rows = len(leader) if leader is not None and leader.ndim == 2 else None
    like = columns.get("effects", column).shape[1:] if name == "resting_effects" else ()
    fits = column.shape[1:] == like
    valid = f"({', '.join(map(str, ('rows' if rows is None else rows, *like)))}{'' if like else ','})"
    if name in REQUIRED:
        fits = column.ndim == 2 and column.shape[1] > 0
        valid = f"({'rows' if rows is None else rows}, columns), with at least one column"
    if not fits or (rows is not None and column.shape[:1] != (rows,)):
        return f"{name!r} has shape {column.shape}; valid: {valid}"
    with np.errstate(all="ignore"):
        numbers = column.astype(np.float64)
    bad = ~np.isin(numbers, (0, 1)) if is_flag else ~(np.abs(numbers) <= _GREATEST)
    if not bad.any():
        return None
    valid = "true and false (1 and 0)" if is_flag else f"finite numbers up to {_GREATEST:.2g}"
    place = np.argwhere(bad)[0].tolist()
    return f"{name}{place} is {numbers[tuple(place)]:g}{_and_more(bad)}; valid: {valid}"


def _origin_problems(origin: Mapping[str, Any], columns: Columns) -> list[str]:
    """List what is wrong with the entries of an origin that are read."""
    try:
        read = msgspec.convert(origin, _Read)
    except msgspec.ValidationError as error:
        return [f"its origin cannot be used: {error}"]
    usable, problems = _usable(columns), []
    names, grippers = list(read.feature_names), list(read.gripper_columns)
    if len(set(names)) < len(names) or not all(name and name.isprintable() for name in names):
        given = f"its origin has feature_names = {reprlib.repr(names)}"
        problems.append(f"{given}; valid: a list of different names")
    elif (count := _widths(usable).get("features", len(names))) != len(names) and "feature_names" in origin:
        problems.append(f"its origin has {len(names)} feature_names; valid: {count}, one for each")
    features = _widths(usable).get("features", 0)
    if len(set(read.unshown) & set(range(features))) < len(read.unshown):
        problems.append(
            f"its origin has unshown = {reprlib.repr(list(read.unshown))}; valid: different whole numbers "
            f"from 0 to {features - 1}"
        )
    problems += _axis_problems(origin, usable)
    if "actions" not in usable:
        return problems
    width = usable["actions"].shape[1]
    if wrong := next((one for one in read.choices if not 0 <= one < width), None):
        problems.append(f"its origin has {wrong} among choices; valid: columns from 0 to {width - 1}")
    if len(set(grippers) & set(range(width))) < len(grippers):
        problems.append(
            f"its origin has gripper_columns = {reprlib.repr(grippers)}; valid: different whole numbers "
            f"from 0 to {width - 1}"
        )
    problems += _box_problems(usable["actions"], origin, read)
    for given, one in zip(origin.get("mirrors", ()), read.mirrors, strict=True):
        axes = usable["effects"].shape[1] if "effects" in usable else 0
        if axes and (problem := column_problem(Mirror(one.actions, one.effects), width, axes, grippers)):
            problems.append(f"its origin has the mirror {reprlib.repr(given)}; {problem}")
    return problems


def _axis_problems(origin: Mapping[str, Any], usable: Columns) -> list[str]:
    """List what is wrong with the axes that an origin describes, or with effects along them."""
    if "axes" not in origin or "effects" not in usable:
        return []
    try:
        axes = axes_in(origin["axes"], usable["effects"].shape[1])
    except InvalidValue as error:
        return [str(error).rstrip(".")]
    names = origin.get("feature_names", ())
    return check_flags(axes, usable["effects"], [legal_name(str(name)) for name in names])


def _box_problems(actions: np.ndarray, origin: Mapping[str, Any], read: _Read) -> list[str]:
    """Check the box and that actions lie in it, both rounded as actions are stored."""
    width = actions.shape[1]
    given = {name: getattr(read, name) for name in ("action_low", "action_high") if name in origin}
    problems = [
        f"its origin has an {name} of {counted(len(bound), 'number')}; valid: {width}"
        for name, bound in given.items()
        if len(bound) != width
    ]
    if problems or not given:
        return problems
    low, high, _ = box_of(actions, given)
    empty = low > high if is_explored(origin) else low >= high
    if len(given) == 2 and empty.any():
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
        f"actions[{row}, {number}] is {stored[row, number]:g}{_and_more(outside)}, outside of the action box "
        f"of its origin; valid: {low[number]:g} to {high[number]:g}"
    ]


def training_problems(columns: Columns, origin: Mapping[str, Any]) -> list[str]:
    """List what keeps a data set from being learned from.

    What the world of an exploration holds fixed is no problem: the user asked for such a world.

    Args:
        columns: The arrays; those that are broken are passed over.
        origin: How they came about.
    """
    usable, strategy = _usable(columns), strategy_of(origin)
    rows = learned = min(map(len, usable.values()), default=0)
    if strategy and "effects" in usable:
        learned = int(strategy.learns_from(usable["effects"]).sum())
    problem = too_few(learned) if rows else None
    if problem and learned < rows:
        problem = f"of its {rows} interactions, {origin['strategy']!r} learns from few: {problem}"
    problems = [problem] if problem else []
    if rows < 2 or is_explored(origin):
        return problems
    for name in ("features", "actions"):
        is_one = name == "actions" and name in usable and len(np.unique(usable[name], axis=0)) == 1
        if name in usable and not is_one:  # with one action alone, the symbols of objects are learned
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
        narrow = np.flatnonzero(columns[name].std(0) < (0 if name == "effects" else _NARROW)).tolist()
        warnings += [
            f"{_column_name(name, number, origin)} varies by less than {_NARROW:g}, which is hard "
            "to learn from; give it in a smaller unit"
            for number in narrow
            if number not in constant
        ]
    for number in origin.get("gripper_columns", ()):
        values = columns["actions"][:, number]
        if values.min() < 0 or values.max() > 1 or len({*(values >= 0.5).tolist()}) == 1:
            warnings.append(
                f"the gripper value actions[:, {number}] leaves the range from 0 (closed) to 1 (open), or "
                "never crosses 0.5 between them"
            )
    if columns["held"].any() and "resting_effects" not in given:
        warnings.append("without 'resting_effects', a held object is taken to rest where it was held")
    if columns["lost"].all():
        warnings.append("'lost' is true in every row, so that no effect counts as reached")
    greatest = float(np.abs(columns["effects"]).max())
    if "axes" not in origin and not TOLERANCE < greatest <= _FAR * TOLERANCE:
        only, unit = ("only ", "smaller") if greatest <= TOLERANCE else ("", "larger")
        warnings.append(
            f"effects reach {only}{greatest:g}, but in a world every outcome counts as promised within "
            f"{TOLERANCE:g} of the mean, in their unit; give them in a {unit} unit, or name axes"
        )
    warnings += _turning(columns, origin)
    warnings += _choosing(columns, origin)
    read = (*_Read.__struct_fields__, "format")
    near = {name: get_close_matches(name, read, n=1, cutoff=0.8) for name in origin if name not in read}
    return warnings + [
        f"the entry {name!r} of the origin is not read, but {found[0]!r} is"
        for name, found in near.items()
        if found
    ]


def _turning(columns: Columns, origin: Mapping[str, Any]) -> Iterator[str]:
    """Note lengths that look like angles: they change a little, and seldom by all of their range."""
    names = [legal_name(name) for name in origin.get("feature_names", ())]
    for number, axis in enumerate(axes_in(origin.get("axes", ()))):
        if axis.kind == "length" and axis.name in names:
            effects, values = columns["effects"][:, number], columns["features"][:, names.index(axis.name)]
            room = 0.8 * float(np.ptp(values))
            if effects.min() < -room and effects.max() > room and np.mean(abs(effects) > room / 2) < 0.25:
                yield f"{axis.name} sometimes changes by nearly all of its range; is it an angle?"


def _choosing(columns: Columns, origin: Mapping[str, Any]) -> Iterator[str]:
    """Note action parameters that look like choices: they hold few whole numbers, and more than two."""
    names = origin.get("action_names", ())
    for number, column in enumerate(columns["actions"].T):
        values = np.unique(column)
        if 2 < len(values) <= _FEW and np.all(values % 1 == 0) and not is_explored(origin):
            name = names[number] if number < len(names) else f"actions[:, {number}]"
            yield (
                f"{name} holds only {len(values)} whole numbers; if each is a choice of its own, name it "
                f"choice.{name}, or list it as one of the choices"
            )


def too_few(rows: int) -> str | None:
    """Say that there are too few interactions to train on, or return None."""
    if rows >= LEAST_INTERACTIONS:
        return None
    return f"{rows} interactions are too few to train on; at least {LEAST_INTERACTIONS} are needed"


def model_misfit(dimensions: Dimensions, columns: Columns, origin: Mapping[str, Any]) -> str | None:
    """Say that a model was trained on data of other dimensions, or return None.

    Args:
        dimensions: Those of the model.
        columns: The data.
        origin: What they say of how they came about.
    """
    takes = {name: getattr(dimensions, name) for name in REQUIRED}
    if takes != (has := _widths(columns)):
        return f"it was trained on {_counted(takes)}, and the data have {_counted(has)}; train it again"
    if list(dimensions.unshown) != list(origin.get("unshown", ())):
        return "it was shown other features than the data show; train it again"
    grippers, theirs = list(dimensions.gripper_columns), list(origin.get("gripper_columns", ()))
    if sorted(grippers) == sorted(theirs):
        return None
    return f"its gripper columns are {grippers}, and those of the data {theirs}; train it again"


def world_misfit(name: str, takes: tuple[int, int, int], columns: Columns) -> str | None:
    """Say that data cannot come from a world, or return None.

    Args:
        name: Name of the world.
        takes: How many object features it has, action parameters it takes, and axes of effects.
        columns: The data.
    """
    known, has = dict(zip(REQUIRED, takes, strict=True)), _widths(columns)
    if known == has:
        return None
    return (
        f"its rows have {_counted(has)}, and the {name} world has {_counted(known)}; "
        "take world.toml away to average effects from the data"
    )


def _and_more(bad: np.ndarray) -> str:
    """Say how many entries more than the first are bad."""
    count = int(bad.sum()) - 1
    return f" (and {count} more like it)" if count else ""


def _usable(columns: Columns) -> dict[str, np.ndarray]:
    """Return the matrices of numbers among the arrays that a data set must have."""
    there = {name: columns[name] for name in REQUIRED if name in columns}
    return {name: one for name, one in there.items() if one.ndim == 2 and one.dtype.kind in "fiub"}


def _constant_columns(column: np.ndarray) -> list[int]:
    with np.errstate(all="ignore"):
        stored = column.astype(np.float32)
    return [int(number) for number in np.flatnonzero((stored == stored[0]).all(0))]


def _column_name(name: str, number: int, origin: Mapping[str, Any]) -> str:
    """Call a column by its place, and a feature by its name, too, if a data set tells it."""
    names = origin.get("feature_names") if name == "features" else None
    known = isinstance(names, list) and number < len(names)
    return f"{name}[:, {number}]" + (f" ({names[number]})" if known and names else "")


def _widths(columns: Columns) -> dict[str, int]:
    return {name: columns[name].shape[1] for name in REQUIRED if name in columns}


def _counted(widths: Mapping[str, int]) -> str:
    known = (
        f"{counted(widths['features'], 'object feature')}, {counted(widths['actions'], 'action parameter')}"
    )
    return f"{known} and {widths['effects']} effect {'axis' if widths['effects'] == 1 else 'axes'}"
