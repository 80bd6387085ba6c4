"""Refusing what cannot be, where it enters: a check raises `InvalidValue`, which says what would be valid."""

import math
import operator
import os
import reprlib
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from typing import Any, TypeVar, get_type_hints

import msgspec
import numpy as np

from neurosym.errors import InvalidValue
from neurosym.reading import is_decoding

Kind = TypeVar("Kind")


def check_kind(name: str, value: object, kind: Any, valid: str) -> None:
    """Raise unless a value is of a kind.

    Args:
        name: What messages call it.
        value: The value.
        kind: The kind, or several.
        valid: What would be valid, in words.

    Raises:
        InvalidValue: If it is of another.
    """
    if not isinstance(value, kind):
        raise InvalidValue(
            f"{name} = {reprlib.repr(value)} is of type {type(value).__name__}; valid: {valid}."
        )


def check_all(name: str, values: object, kind: type[Kind], valid: str) -> None:
    """Raise unless something is a sequence of values of a kind.

    Args:
        name: What messages call it.
        values: The values.
        kind: The kind of each.
        valid: What would be valid, in words.

    Raises:
        InvalidValue: If it is no sequence, or one of them is of another kind.
    """
    if isinstance(values, str | bytes) or not isinstance(values, Iterable) or not hasattr(values, "__len__"):
        raise InvalidValue(
            f"{name} = {reprlib.repr(values)} is of type {type(values).__name__}; valid: {valid}."
        )
    for value in values:
        check_kind(f"one of {name}", value, kind, valid)


def check_callable(name: str, value: object, valid: str) -> None:
    """Raise unless something can be called.

    Raises:
        InvalidValue: If it cannot.
    """
    if not callable(value):
        raise InvalidValue(f"{name} = {reprlib.repr(value)} cannot be called; valid: {valid}.")


def check_whole(name: str, value: object) -> None:
    """Raise unless a value is a whole number.

    Raises:
        InvalidValue: If it is not.
    """
    if isinstance(value, bool | np.bool_) or not hasattr(value, "__index__"):
        raise InvalidValue(f"{name} = {reprlib.repr(value)} must be a whole number.")


def check_count(name: str, value: object, least: int = 1) -> None:
    """Raise unless a value is a whole number that is large enough.

    Args:
        name: What messages call it.
        value: The value.
        least: The smallest that is valid.

    Raises:
        InvalidValue: If it is not.
    """
    check_whole(name, value)
    if operator.index(value) < least:  # type: ignore[arg-type]  # checked just now
        raise InvalidValue(f"{name} = {reprlib.repr(value)} must be at least {least}.")


def check_seed(value: object, name: str = "seed") -> None:
    """Raise unless a value is a seed: a whole number of at least 0.

    Raises:
        InvalidValue: If it is not.
    """
    check_count(name, value, least=0)


def check_length(name: str, value: object, unit: str = " m") -> None:
    """Raise unless a value is a finite number above 0.

    Args:
        name: What messages call it.
        value: The value.
        unit: Its unit, after a blank.

    Raises:
        InvalidValue: If it is not.
    """
    is_number = isinstance(value, int | float | np.number) and not isinstance(value, bool)
    if not (is_number and math.isfinite(value) and value > 0):  # type: ignore[arg-type, operator]
        raise InvalidValue(f"{name} = {reprlib.repr(value)}{unit} must be a finite number above 0.")


def check_array(name: str, array: object, shape: tuple[int | None, ...], kinds: str = "fiu") -> None:
    """Raise unless something is an array of numbers of a shape, all finite.

    Args:
        name: What messages call it.
        array: The array.
        shape: Its size along each axis; None for any.
        kinds: The kinds of number that it may hold, as in `dtype.kind`; by default floats and integers.

    Raises:
        InvalidValue: If it is not.
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
    """Return a path, given as one or as text.

    Raises:
        InvalidValue: If it is neither.
    """
    if isinstance(value, str | os.PathLike) and isinstance(os.fspath(value), str):
        return Path(value)
    raise InvalidValue(f"{name} = {reprlib.repr(value)} is no path; valid: a Path, or text.")


def check_fields(document: msgspec.Struct) -> None:
    """Raise unless each field of a document holds what its type says, and all numbers in it are finite.

    What is being decoded from JSON is checked by what decodes it: in JSON all numbers are finite.

    Args:
        document: The document; others in it have been checked when they were made.

    Raises:
        InvalidValue: If one does not; the message names it.
    """
    if is_decoding():
        return
    kind = type(document)
    for name, hint in _hints(kind).items():
        value = getattr(document, name)
        if value is msgspec.UNSET:
            continue
        try:
            msgspec.convert(value, hint)
        except msgspec.ValidationError:
            try:
                msgspec.convert(_plain(value), hint)
            except msgspec.ValidationError as error:
                said = str(error).rstrip(".")
                raise InvalidValue(f"{kind.__name__}.{name} = {reprlib.repr(value)}: {said}.") from error
        if not _is_finite(value):
            raise InvalidValue(f"{kind.__name__}.{name} = {reprlib.repr(value)} must be finite.")


@cache
def _hints(kind: type) -> dict[str, Any]:
    return get_type_hints(kind)


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
