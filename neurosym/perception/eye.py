"""The eye, an image encoder: a small convolutional network that tells an object's crop in a few numbers.

Bits, promises and plans know crops by these numbers only. `neurosym.learning.eye_lesson` teaches it; what
looks needs nothing but numpy, so that a number is the same whatever else is looked at.
"""

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.lib.stride_tricks import sliding_window_view
from scipy.ndimage import zoom

from neurosym.checks import Float, check_array
from neurosym.data.archives import read_tensors, write_tensors
from neurosym.errors import InvalidFile
from neurosym.perception.regions import CELLS

NUMBERS = 5
"""An eye tells a crop in so many numbers; with the three sizes that are seen an object has eight."""
CHANNELS, FLAT = (1, 8, 16, 32), 64
"""Of its convolutions, each of which halves the picture; and the width of the layer behind them."""
DEEP = 10.0
"""Crops are shown in tenths of a metre."""
FORMAT = "neurosym-eye-1"
_DECIMALS = 4  # of what is told, so that it is read from a file as it was
_EPSILON = 1e-5  # added to a variance


def _shapes() -> dict[str, tuple[int, ...]]:
    shapes: dict[str, tuple[int, ...]] = {}
    for number in range(len(CHANNELS) - 1):
        shapes[f"convolution.{number}.weight"] = (CHANNELS[number + 1], CHANNELS[number], 3, 3)
        shapes[f"convolution.{number}.bias"] = (CHANNELS[number + 1],)
    side = CELLS >> (len(CHANNELS) - 1)
    for name, sizes in {"hidden": (FLAT, CHANNELS[-1] * side**2), "told": (NUMBERS, FLAT)}.items():
        shapes |= {f"{name}.weight": sizes, f"{name}.bias": sizes[:1]}
    return {**shapes, "mean": (NUMBERS,), "variance": (NUMBERS,)}


def as_crops(images: Float[np.ndarray, "N side side"]) -> Float[np.ndarray, "N cells cells"]:
    """Scale images to the size that an eye takes."""
    factors = (1, CELLS / images.shape[1], CELLS / images.shape[2])
    return np.asarray(zoom(images, factors, order=1, grid_mode=True, mode="nearest"))


@dataclass(frozen=True, slots=True, eq=False)
class Eye:
    """Tells crops in numbers, each of mean 0 and deviation 1 over what it learned from."""

    weights: dict[str, np.ndarray]  #: By name
    taught_by: dict[str, Any] = field(default_factory=dict)  #: What taught it, in plain JSON values

    def tell(self, crop: Float[np.ndarray, "cells cells"]) -> Float[np.ndarray, "numbers"]:
        """Tell a crop [m]; other sizes raise `InvalidValue`."""
        check_array("The crop", crop, (CELLS, CELLS))
        seen, w = DEEP * crop[None], self.weights
        for number in range(len(CHANNELS) - 1):
            seen = _convolved(seen, w[f"convolution.{number}.weight"], w[f"convolution.{number}.bias"])
        hidden = np.maximum(w["hidden.weight"] @ seen.ravel() + w["hidden.bias"], 0.0)
        told = w["told.weight"] @ hidden + w["told.bias"]
        normed: np.ndarray = (told - w["mean"]) / np.sqrt(w["variance"] + _EPSILON)
        return np.round(normed, _DECIMALS)

    def first_filters(self, crop: Float[np.ndarray, "cells cells"]) -> Float[np.ndarray, "filters side side"]:
        """Return what the first convolution answers to a crop."""
        w = self.weights
        return _convolved(DEEP * crop[None], w["convolution.0.weight"], w["convolution.0.bias"])

    def save(self, path: Path) -> None:
        """Write the eye as a safetensors file."""
        weights = {name: array.astype(np.float32) for name, array in self.weights.items()}
        write_tensors(path, FORMAT, weights, {"taught_by": self.taught_by})

    @classmethod
    def load(cls, path: Path) -> "Eye":
        """Read an eye; `InvalidFile` if the file is corrupt or foreign."""
        weights, description = read_tensors(path, FORMAT)
        if {name: array.shape for name, array in weights.items()} != _shapes():
            raise InvalidFile(path, "its weights are those of no eye")
        if (weights["variance"] < 0).any():
            raise InvalidFile(path, "it holds a variance below zero")
        taught_by = description.get("taught_by")
        if not isinstance(taught_by, dict):
            raise InvalidFile(path, "it does not say what taught it")
        return cls({name: array.astype(np.float64) for name, array in weights.items()}, taught_by)


def _convolved(
    seen: Float[np.ndarray, "in side side"], weight: Float[np.ndarray, "out in 3 3"], bias: np.ndarray
) -> Float[np.ndarray, "out half half"]:
    """Convolve in steps of two, and leave out what is negative."""
    padded = np.pad(seen, ((0, 0), (1, 1), (1, 1)))
    windows = sliding_window_view(padded, (3, 3), axis=(1, 2))[:, ::2, ::2]  # (in, half, half, 3, 3)
    found = np.tensordot(weight, windows, axes=((1, 2, 3), (0, 3, 4))) + bias[:, None, None]
    return np.asarray(np.maximum(found, 0.0))
