"""Categories: described and named by the objects that fall into them."""

from collections.abc import Mapping, Sequence

import numpy as np

from neurosym.arrays import Float
from neurosym.naming import name_categories
from neurosym.operators import Category, Effect
from neurosym.symbols import Symbol, all_symbols

_DIGITS = 5  # of lengths that are kept [m]


def describe_categories(
    features: Float[np.ndarray, "N F"],
    symbols: np.ndarray,
    feature_names: Sequence[str],
    shares: Mapping[Symbol, float] | None = None,
) -> tuple[Category, ...]:
    """Describe and name the categories, in the order of their symbols.

    A symbol that no object has is called `unseen`: problems may meet one later, and nothing is known of it.

    Args:
        features: Features of the objects.
        symbols: Symbol of each object.
        feature_names: What the features are.
        shares: Share of each category, if these are the objects that it was rehearsed on; they are kept then.
    """
    present = sorted(set(symbols.tolist()))
    members = [features[symbols == symbol] for symbol in present]
    means = np.array([_means_for_naming(rows, feature_names) for rows in members])
    names = name_categories(present, means, feature_names)
    seen = {
        symbol: Category(
            symbol=symbol,
            name=name,
            share=len(rows) / len(features) if shares is None else shares[symbol],
            feature_means=tuple(rows.mean(0).tolist()),
            feature_spreads=tuple(rows.std(0).tolist()),
            objects=() if shares is None else tuple(rounded(row) for row in rows),
        )
        for symbol, name, rows in zip(present, names, members, strict=True)
    }
    return tuple(
        seen.get(symbol) or Category(symbol, f"unseen-{symbol}", 0.0, (), ())
        for symbol in all_symbols(len(present[0]))
    )


def _means_for_naming(rows: Float[np.ndarray, "N F"], feature_names: Sequence[str]) -> np.ndarray:
    """Average features, where a type counts as hollow or not, however it is open."""
    is_type = np.array(feature_names) == "t"
    return np.asarray(np.where(is_type, rows >= 0.5, rows).mean(0))


def rounded(values: Float[np.ndarray, "N"]) -> Effect:
    """Round to the digits that are kept, without a negative zero.

    Args:
        values: Lengths [m], or types.
    """
    return tuple(round(float(value), _DIGITS) + 0.0 for value in values)
