"""Refusing what cannot be, where it enters: a check raises `InvalidValue`, which says what would be valid."""

import math
import operator
import os
import reprlib
import sys
import threading
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, get_type_hints

import msgspec
import numpy as np

from neurosym.errors import InvalidValue

_decoding = threading.local()  # whether this thread makes `now` what a file holds


@contextmanager
def decoding() -> Iterator[None]:
    """Make what a JSON document holds: all its fields fit their types and are finite, and are not checked."""
    before, _decoding.now = getattr(_decoding, "now", False), True
    try:
        yield
    finally:
        _decoding.now = before


def check_kind(name: str, value: object, kind: Any, valid: str) -> None:
    """Raise `InvalidValue`, with its name and what is valid, unless a value is of a kind, or of several."""
    if not isinstance(value, kind):
        given = f"{name} = {reprlib.repr(value)} is of type {type(value).__name__}"
        raise InvalidValue(f"{given}; valid: {valid}.")


def check_all(name: str, values: object, kind: type, valid: str) -> None:
    """Raise `InvalidValue` unless something is a sequence of values of a kind; see `check_kind`."""
    if isinstance(values, str | bytes) or not isinstance(values, Iterable) or not hasattr(values, "__len__"):
        check_kind(name, values, (), valid)
    for value in values:  # type: ignore[attr-defined]  # checked just now
        check_kind(f"one of {name}", value, kind, valid)


def check_callable(name: str, value: object, valid: str) -> None:
    """Raise `InvalidValue` unless something can be called."""
    if not callable(value):
        raise InvalidValue(f"{name} = {reprlib.repr(value)} cannot be called; valid: {valid}.")


def check_whole(name: str, value: object) -> None:
    """Raise `InvalidValue` unless a value is a whole number."""
    if isinstance(value, bool | np.bool_) or not hasattr(value, "__index__"):
        raise InvalidValue(f"{name} = {reprlib.repr(value)} must be a whole number.")


def check_count(name: str, value: object, least: int = 1) -> None:
    """Raise `InvalidValue` unless a value is a whole number that is large enough."""
    check_whole(name, value)
    if operator.index(value) < least:  # type: ignore[arg-type]  # checked just now
        raise InvalidValue(f"{name} = {reprlib.repr(value)} must be at least {least}.")


def check_seed(value: object, name: str = "seed") -> None:
    """Raise `InvalidValue` unless a value is a seed: a whole number of at least 0."""
    check_count(name, value, least=0)


def check_length(name: str, value: object) -> None:
    """Raise `InvalidValue` unless a value is a finite length above 0 [m]."""
    is_number = isinstance(value, int | float | np.number) and not isinstance(value, bool)
    if not (is_number and math.isfinite(value) and value > 0):  # type: ignore[arg-type, operator]
        raise InvalidValue(f"{name} = {reprlib.repr(value)} m must be a finite number above 0.")


def check_array(name: str, array: object, shape: tuple[int | None, ...], kinds: str = "fiu") -> None:
    """Raise `InvalidValue` unless something is an array of numbers of a shape, all finite.

    Args:
        name: What messages call it.
        array: The array.
        shape: Its size along each axis; None for any.
        kinds: The kinds of number that it may hold, as in `dtype.kind`.
    """
    told = f"({', '.join('any' if size is None else str(size) for size in shape)}{',' * (len(shape) == 1)})"
    if not isinstance(array, np.ndarray):
        raise InvalidValue(f"{name} is of type {type(array).__name__}; valid: a numpy array of shape {told}.")
    fits = array.ndim == len(shape) and all(
        size in (None, found) for size, found in zip(shape, array.shape, strict=True)
    )
    if not fits:
        raise InvalidValue(f"{name} has shape {array.shape}; valid: {told}.")
    if array.dtype.kind not in kinds:
        valid = "truth values" if kinds == "b" else "numbers"
        raise InvalidValue(f"{name} holds {array.dtype}; valid: {valid}.")
    if array.dtype.kind == "f" and not np.all(np.isfinite(array)):
        raise InvalidValue(f"{name} holds a value that is not finite.")


def as_path(value: object, name: str = "path") -> Path:
    """Return a path, given as one or as text; raise `InvalidValue` if it is neither."""
    if isinstance(value, str | os.PathLike) and isinstance(os.fspath(value), str):
        return Path(value)
    raise InvalidValue(f"{name} = {reprlib.repr(value)} is no path; valid: a Path, or text.")


def check_fields(document: msgspec.Struct) -> None:
    """Raise `InvalidValue` unless each field of a document fits its type, and all numbers are finite.

    What is being decoded from JSON is checked by what decodes it: in JSON all numbers are finite.
    """
    if getattr(_decoding, "now", False):
        return
    kind = type(document)
    for name, hint in _hints(kind).items():
        value = getattr(document, name)
        if value is msgspec.UNSET:
            continue
        try:
            msgspec.convert(_plain(value), hint)
        except msgspec.ValidationError as error:
            said = str(error).rstrip(".")
            raise InvalidValue(f"{kind.__name__}.{name} = {reprlib.repr(value)}: {said}.") from error
        if not _is_finite(value):
            raise InvalidValue(f"{kind.__name__}.{name} = {reprlib.repr(value)} must be finite.")


class Document(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What is stored as JSON: its fields are checked as it is made, see `check_fields`."""

    def __post_init__(self) -> None:
        check_fields(self)


@cache
def _hints(kind: type[msgspec.Struct]) -> dict[str, Any]:
    hints = get_type_hints(kind)
    return {name: hints[name] for name in kind.__struct_fields__}


def _plain(value: Any) -> Any:
    """Return the same value in Python's own numbers."""
    if isinstance(value, np.generic):
        return value.item()
    if isinstance(value, tuple | list):
        return tuple(map(_plain, value))
    return {key: _plain(entry) for key, entry in value.items()} if isinstance(value, dict) else value


def _is_finite(value: Any) -> bool:
    if isinstance(value, float):
        return math.isfinite(value)
    if isinstance(value, tuple | list):
        return all(map(_is_finite, value))
    return all(map(_is_finite, value.values())) if isinstance(value, dict) else True


# Arrays in annotations: what they hold, and along which axes, as in `Float[np.ndarray, "N 4"]`.
#
# Type checkers and tests read these as jaxtyping's. Who has not imported jaxtyping checks no shapes, and
# gets the plain type: making the others would take half as long as importing numpy.

if TYPE_CHECKING or "jaxtyping" in sys.modules:
    from jaxtyping import Bool as Bool
    from jaxtyping import Float as Float
    from jaxtyping import Int as Int
    from jaxtyping import UInt8 as UInt8
else:

    class Bool:
        """An array as its plain type."""

        def __class_getitem__(cls, told: tuple[Any, str]) -> Any:
            return told[0]

    Float = Int = UInt8 = Bool
