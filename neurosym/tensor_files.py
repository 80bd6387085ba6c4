"""Named arrays with a description beside them, in the safetensors format: nothing is ever unpickled."""

import json
from pathlib import Path
from typing import Any

import numpy as np
from safetensors import SafetensorError, safe_open
from safetensors.numpy import save

from neurosym.errors import InvalidFile
from neurosym.files import write_atomically

_METADATA = "neurosym"


def write_tensors(
    path: Path, file_format: str, tensors: dict[str, np.ndarray], description: dict[str, Any]
) -> None:
    """Write arrays and their description whole or not at all; equal contents give equal bytes.

    Args:
        path: Where the file shall stand.
        file_format: What the file calls itself.
        tensors: The arrays by name.
        description: Plain JSON values.
    """
    text = json.dumps({"format": file_format, **description}, sort_keys=True)
    ordered = {name: np.ascontiguousarray(tensors[name]) for name in sorted(tensors)}
    write_atomically(path, save(ordered, {_METADATA: text}))  # one key, whose order cannot vary


def read_tensors(path: Path, file_format: str) -> tuple[dict[str, np.ndarray], dict[str, Any]]:
    """Read the arrays and the description of a file.

    Args:
        path: The file.
        file_format: What it must call itself.

    Raises:
        InvalidFile: If it is not a file of that format, or holds a number that is not finite.
    """
    try:
        with safe_open(path, framework="np") as file:
            description = json.loads((file.metadata() or {}).get(_METADATA, "{}"))
            tensors = {name: file.get_tensor(name) for name in file.keys()}  # noqa: SIM118 (no mapping)
    except (OSError, SafetensorError, ValueError, TypeError, AttributeError) as error:
        raise InvalidFile(path, "it is not a safetensors file, or it is damaged") from error
    if not isinstance(description, dict) or description.get("format") != file_format:
        raise InvalidFile(path, f"it is not of the format {file_format}")
    for name, tensor in tensors.items():
        if not np.all(np.isfinite(tensor)):
            raise InvalidFile(path, f"{name!r} holds a value that is not finite")
    return tensors, description
