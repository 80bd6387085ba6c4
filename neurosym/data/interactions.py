"""The data set of interactions, one row each, and its file.

Axes, here and everywhere in the package:

    N  interactions          F  object features (4)     K  bits of a symbol
    B  samples in a batch    A  action parameters (12)  P  primitives
    M  objects in a scene    E  effect axes (3)         C  candidate actions
    O  effect axes, and the peak height on the way if it is predicted, too
"""

import io
import json
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any

import numpy as np

from neurosym.checks import Bool, Float, as_path, check_array, check_kind
from neurosym.data.archives import read_arrays
from neurosym.data.origin import FLAGS, file_problems
from neurosym.errors import InvalidFile
from neurosym.files import write_atomically
from neurosym.pair_operators import FARTHEST, describe_pair, touching_units
from neurosym.world import OtherObject, Outcome

FORMAT = "neurosym-interactions-1"


@dataclass(frozen=True, slots=True, eq=False)
class Interactions:
    """Interactions in the order they were made; lengths in metres.

    Raises:
        InvalidValue: If the columns do not fit together, or hold what is not finite.
    """

    features: Float[np.ndarray, "N F"]  #: Features of the target object
    actions: Float[np.ndarray, "N A"]  #: Action parameters
    #: Displacement of the target at the end of the rise [m]. Of actions that are aimed at a reference: where
    #: the target ends relative to it, and 1, if it is carried there; else zeros
    effects: Float[np.ndarray, "N E"]
    resting_effects: Float[np.ndarray, "N E"]  #: Displacement of the target once everything is put down [m]
    held: Bool[np.ndarray, "N"]  #: Whether the target hung from the gripper at the end of the rise
    toppled: Bool[np.ndarray, "N"]  #: Whether the target ended on another face
    lost: Bool[np.ndarray, "N"]  #: Whether the target ended off the table
    peak_heights: Float[np.ndarray, "N"]  #: Greatest height of the target above its start on the way [m]
    #: How the data came about (strategy, seed, world, ...), as plain JSON values
    origin: dict[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        check_array("features", self.features, (None, None))
        rows = len(self.features)
        for name in ("actions", "effects"):
            check_array(name, getattr(self, name), (rows, None))
        check_array("resting_effects", self.resting_effects, self.effects.shape)
        check_array("peak_heights", self.peak_heights, (rows,))
        for name in FLAGS:
            check_array(name, getattr(self, name), (rows,), kinds="b")
        check_kind("origin", self.origin, dict, "a dict of plain JSON values")

    def __len__(self) -> int:
        return len(self.features)

    def __getitem__(self, rows: slice | np.ndarray) -> "Interactions":
        """Take some of the rows."""
        return type(self)(**{name: column[rows] for name, column in self.columns.items()}, origin=self.origin)

    @classmethod
    def from_outcomes(
        cls, outcomes: Sequence[Outcome], actions: Float[np.ndarray, "N A"], origin: dict[str, Any]
    ) -> "Interactions":
        """Gather outcomes and the actions that led to them."""
        lengths = {
            "features": [_described(one) for one in outcomes],
            "actions": actions,
            "effects": [_axes(one, one.effect) for one in outcomes],
            "resting_effects": [_axes(one, one.resting_effect) for one in outcomes],
            "peak_heights": [one.peak_height for one in outcomes],
        }
        flags = {name: np.array([getattr(one, name) for one in outcomes]) for name in FLAGS}
        columns = {name: np.array(rows).astype(np.float32) for name, rows in lengths.items()}
        return cls(**columns, **flags, origin=origin)

    @classmethod
    def filled(cls, columns: Mapping[str, np.ndarray], origin: dict[str, Any]) -> "Interactions":
        """Make a data set of columns without problems; what is missing is filled in, see `load`."""
        rows = len(columns["features"])
        nothing = {"resting_effects": columns["effects"], "peak_heights": np.zeros(rows)}
        every = {**nothing, **dict.fromkeys(FLAGS, np.zeros(rows, dtype=bool)), **columns}
        kinds = {name: bool if name in FLAGS else np.float32 for name in _ARRAYS}
        return cls(**{name: every[name].astype(kind) for name, kind in kinds.items()}, origin=origin)

    def join(self, more: "Interactions") -> "Interactions":
        """Append the rows of another data set, keeping this one's origin."""
        joined = {name: np.concatenate([rows, getattr(more, name)]) for name, rows in self.columns.items()}
        return Interactions(**joined, origin=self.origin)

    def save(self, path: Path) -> None:
        """Write the data set as an .npz file whose bytes depend on nothing but the data."""
        buffer = io.BytesIO()
        origin = np.array(json.dumps({"format": FORMAT, **self.origin}, sort_keys=True))
        np.savez_compressed(buffer, allow_pickle=False, **self.columns, origin=origin)
        write_atomically(as_path(path), buffer.getvalue())

    @property
    def columns(self) -> dict[str, np.ndarray]:
        """The arrays by name."""
        return {name: getattr(self, name) for name in _ARRAYS}

    @classmethod
    def load(cls, path: Path) -> "Interactions":
        """Read a data set; only `features`, `actions` and `effects` must be there.

        Missing columns are filled in from what the effects say: nothing held, resting effect equal to effect.

        Raises:
            InvalidFile: If the file is not such an .npz file, or its columns do not fit together.
        """
        examination = examine(as_path(path))
        if examination.interactions is None:
            raise InvalidFile(path, examination.problems[0])
        return examination.interactions


@dataclass(frozen=True, slots=True, eq=False)
class Examination:
    """What was found in a file that should hold a data set."""

    columns: dict[str, np.ndarray]  # the arrays that could be read, with their names
    origin: dict[str, Any]  # what it says of how they came about
    given: tuple[str, ...]  # the names of all arrays in the file
    problems: tuple[str, ...]  # what keeps the arrays from being a data set, a sentence's end each
    interactions: Interactions | None  # the data set, if there are no problems


def examine(path: Path) -> Examination:
    """Read what can be read of a data set, and list what is wrong with it; nothing is ever unpickled.

    Raises:
        InvalidFile: If it is no .npz file at all.
    """
    columns, given, problems = read_arrays(path, (*_ARRAYS, "origin"))
    origin, problem = _read_origin(columns.pop("origin", np.array("{}")))
    problems += [problem] if problem else []
    unread = [name for name in given if name in _ARRAYS and name not in columns]
    problems += file_problems(columns, origin, unread=unread)
    interactions = None if problems else Interactions.filled(columns, origin)
    return Examination(columns, origin, given, tuple(problems), interactions)


def _described(outcome: Outcome) -> Float[np.ndarray, "F"]:
    """Return the features of what was acted upon: of the target, and of an object that it was aimed at."""
    features = outcome.start.features
    if isinstance(outcome.reference, OtherObject):
        return np.concatenate([features[outcome.target], features[outcome.reference.index]])
    return np.asarray(features[outcome.target])


def _axes(outcome: Outcome, effect: Float[np.ndarray, "3"]) -> Float[np.ndarray, "E"]:
    """Return an effect as data have it.

    With a reference, the last axis says whether the target was carried there; all is zero if not. Relative to
    another object it is also told how the target stands to it in the end.
    """
    if outcome.reference is None:
        return effect
    row = np.array([*effect, 1.0])
    if isinstance(outcome.reference, OtherObject):
        pair = outcome.end, outcome.target, outcome.reference.index
        *_, touching, tilted, _ = describe_pair(*pair, outcome.contacts)
        row = np.array([*np.clip(touching_units(*pair), -FARTHEST, FARTHEST), touching, tilted, 1.0])
    return row if outcome.carried else np.zeros_like(row)


_ARRAYS = tuple(f.name for f in fields(Interactions) if f.name != "origin")


def _read_origin(array: np.ndarray) -> tuple[dict[str, Any], str | None]:
    """Read the JSON object in an array of one text, and say what is wrong with it."""
    try:
        origin = json.loads(array.item()) if array.shape == () and array.dtype.kind == "U" else None
    except (ValueError, RecursionError):
        origin = None
    if not isinstance(origin, dict):
        return {}, "'origin' cannot be read; valid: a JSON object as text, like '{\"robot\": \"mine\"}'"
    if (found := origin.pop("format", FORMAT)) != FORMAT:
        return {}, f"it is of the format {found!r}; valid: {FORMAT!r}, or no format in its origin"
    return origin, None
