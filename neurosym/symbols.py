"""Symbols: codes of bits, written as strings like "101"."""

import re
from collections.abc import Callable
from itertools import product
from typing import Annotated

import msgspec
import numpy as np

from neurosym.arrays import Float
from neurosym.checks import check_all, check_callable
from neurosym.errors import InvalidValue, shortened

_BITS = r"\A[01]{1,64}\Z"
Symbol = Annotated[str, msgspec.Meta(pattern=_BITS)]
"""A code of bits; what stands in files is checked when it is read."""
Categorise = Callable[[Float[np.ndarray, "N F"]], tuple[Symbol, ...]]
"""Gives the object symbols of features."""


def symbols_of(categorise: Categorise, features: Float[np.ndarray, "N F"]) -> tuple[Symbol, ...]:
    """Return the symbols that a function gives to objects.

    Args:
        categorise: The function.
        features: Features of the objects.

    Raises:
        InvalidValue: If it gives what are not as many symbols.
    """
    check_callable("categorise", categorise, "a function from features (N, F) to N symbols")
    symbols = categorise(features)
    check_all("the symbols that categorise gives", symbols, str, "a tuple of symbols, like '10'")
    if len(symbols) != len(features):
        raise InvalidValue(f"categorise gives {len(symbols)} symbols for {len(features)} objects.")
    for symbol in symbols:
        if not re.match(_BITS, symbol):
            raise InvalidValue(f"categorise gives the symbol {shortened(symbol)!r}; valid: bits, like '10'.")
    return tuple(symbols)


def all_symbols(bits: int) -> tuple[Symbol, ...]:
    """List the 2^K symbols of K bits in counting order."""
    return tuple("".join(code) for code in product("01", repeat=bits))


def binarize(embeddings: Float[np.ndarray, "N K"]) -> tuple[Symbol, ...]:
    """Turn embeddings into symbols by the binary step function (eq. 2): a bit is 1 where the value is > 0."""
    return tuple("".join("1" if value > 0 else "0" for value in row) for row in embeddings)


def signs(symbol: Symbol) -> Float[np.ndarray, "K"]:
    """Write a symbol in tanh's range: +1 for each 1, -1 for each 0."""
    return np.array([1.0 if bit == "1" else -1.0 for bit in symbol])
