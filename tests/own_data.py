"""A data set of other dimensions than any of our worlds, and files that are no data sets."""

import json
from pathlib import Path
from typing import Any

import numpy as np


def own_columns(rows: int = 60) -> dict[str, Any]:
    """Arrays of 7 features, 5 action parameters (the last from 0 to 1) and 2 effect axes."""
    rng = np.random.default_rng(0)
    actions = rng.uniform(-1, 1, size=(rows, 5)) * [1, 1, 1, 1, 0.5] + [0, 0, 0, 0, 0.5]
    effects = 0.1 * np.sign(actions[:, :2])
    return {"features": rng.uniform(size=(rows, 7)), "actions": actions, "effects": effects}


def write_data(folder: Path, columns: dict[str, Any], origin: object = None) -> Path:
    """Write arrays as a user's script would."""
    path = folder / "interactions.npz"
    extra = {} if origin is None else {"origin": json.dumps(origin)}
    np.savez(path, **columns, **extra)
    return path
