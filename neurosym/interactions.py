"""The data set of interactions, one row each, and its file.

Axes, here and everywhere in the package:

    N  interactions          F  object features (4)     K  bits of a symbol
    B  samples in a batch    A  action parameters (12)  P  primitives
    M  objects in a scene    E  effect axes (3)         C  candidate actions
"""

import io
import json
import zipfile
from collections.abc import Sequence
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import Any

import numpy as np
from jaxtyping import Bool, Float

from neurosym.errors import InvalidFile
from neurosym.files import write_atomically
from neurosym.world import Outcome

FORMAT = "neurosym-interactions-1"
REQUIRED = ("features", "actions", "effects")


@dataclass(frozen=True, slots=True, eq=False)
class Interactions:
    """Interactions in the order they were made; lengths in metres.

    Attributes:
        features: Features of the target object.
        actions: Action parameters.
        effects: Displacement of the target at the end of the rise [m].
        resting_effects: Displacement of the target once everything is put down [m].
        held: Whether the target hung from the gripper at the end of the rise.
        toppled: Whether the target ended on another face.
        lost: Whether the target ended off the table.
        peak_heights: Greatest height of the target above its start on the way [m].
        origin: How the data came about (strategy, seed, world, ...), as plain JSON values.
    """

    features: Float[np.ndarray, "N F"]
    actions: Float[np.ndarray, "N A"]
    effects: Float[np.ndarray, "N E"]
    resting_effects: Float[np.ndarray, "N E"]
    held: Bool[np.ndarray, "N"]
    toppled: Bool[np.ndarray, "N"]
    lost: Bool[np.ndarray, "N"]
    peak_heights: Float[np.ndarray, "N"]
    origin: dict[str, Any] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for name in _ARRAYS:
            assert len(getattr(self, name)) == len(self.features), name

    def __len__(self) -> int:
        return len(self.features)

    def __getitem__(self, rows: slice | np.ndarray) -> "Interactions":
        """Take some of the rows."""
        return type(self)(**{name: getattr(self, name)[rows] for name in _ARRAYS}, origin=self.origin)

    @classmethod
    def from_outcomes(
        cls, outcomes: Sequence[Outcome], actions: Float[np.ndarray, "N A"], origin: dict[str, Any]
    ) -> "Interactions":
        """Gather outcomes and the actions that led to them.

        Args:
            outcomes: One for each row.
            actions: The action performed in each.
            origin: How the data came about.
        """
        return cls(
            features=np.stack([o.start.features[o.target] for o in outcomes]).astype(np.float32),
            actions=actions.astype(np.float32),
            effects=np.stack([o.effect for o in outcomes]).astype(np.float32),
            resting_effects=np.stack([o.resting_effect for o in outcomes]).astype(np.float32),
            held=np.array([o.held for o in outcomes]),
            toppled=np.array([o.toppled for o in outcomes]),
            lost=np.array([o.lost for o in outcomes]),
            peak_heights=np.array([o.peak_height for o in outcomes], dtype=np.float32),
            origin=origin,
        )

    def join(self, more: "Interactions") -> "Interactions":
        """Append the rows of another data set, keeping this one's origin."""
        columns = {name: np.concatenate([getattr(self, name), getattr(more, name)]) for name in _ARRAYS}
        return Interactions(**columns, origin=self.origin)

    def save(self, path: Path) -> None:
        """Write the data set as an .npz file whose bytes depend on nothing but the data."""
        buffer = io.BytesIO()
        columns = {name: getattr(self, name) for name in _ARRAYS}
        origin = np.array(json.dumps({"format": FORMAT, **self.origin}, sort_keys=True))
        np.savez_compressed(buffer, allow_pickle=False, **columns, origin=origin)
        write_atomically(path, buffer.getvalue())

    @classmethod
    def load(cls, path: Path) -> "Interactions":
        """Read a data set; only `features`, `actions` and `effects` must be there.

        Missing columns are filled in from what the effects say: nothing held, resting effect equal to effect.

        Raises:
            InvalidFile: If the file is not such an .npz file, or its columns do not fit together.
        """
        columns, origin = _read_columns(path)
        if missing := [name for name in REQUIRED if name not in columns]:
            raise InvalidFile(path, f"it has no array {missing[0]!r} (needed: {', '.join(REQUIRED)})")
        rows = len(columns["features"]) if columns["features"].ndim else 0
        if rows == 0:
            raise InvalidFile(path, "it holds no interactions")
        for name in REQUIRED:
            if columns[name].ndim != 2 or columns[name].dtype.kind not in "fiu":
                raise InvalidFile(path, f"{name!r} must be a two-dimensional array of numbers")
        columns = _filled(columns)
        for name, column in columns.items():
            if len(column) != rows or column.shape[1:] != columns[_LIKE.get(name, name)].shape[1:]:
                raise InvalidFile(
                    path, f"{name!r} has shape {column.shape}, which does not fit {rows} interactions"
                )
            if not np.all(np.isfinite(column)):
                row = int(np.argwhere(~np.isfinite(column))[0][0])
                raise InvalidFile(path, f"{name!r} holds a value that is not finite in row {row}")
        return cls(**columns, origin=origin)


_ARRAYS = tuple(f.name for f in fields(Interactions) if f.name != "origin")
_FLAGS = ("held", "toppled", "lost")
_LIKE = {"resting_effects": "effects", "toppled": "held", "lost": "held", "peak_heights": "held"}


def _read_columns(path: Path) -> tuple[dict[str, np.ndarray], dict[str, Any]]:
    try:
        with np.load(path, allow_pickle=False) as archive:
            arrays = {name: archive[name] for name in archive.files}
        origin = json.loads(str(arrays.pop("origin", "{}")))
    except (OSError, ValueError, EOFError, zipfile.BadZipFile, KeyError, AttributeError, TypeError) as error:
        raise InvalidFile(path, "it is not an .npz file of plain arrays") from error
    if origin.pop("format", FORMAT) != FORMAT:
        raise InvalidFile(path, f"it is not of the format {FORMAT}")
    return {name: array for name, array in arrays.items() if name in _ARRAYS}, origin


def _filled(columns: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    rows = len(columns["features"])
    defaults = {
        "resting_effects": columns["effects"],
        "peak_heights": np.zeros(rows),
        **{name: np.zeros(rows, dtype=bool) for name in _FLAGS},
    }
    full = {**defaults, **columns}
    return {name: full[name].astype(bool if name in _FLAGS else np.float32) for name in _ARRAYS}
