"""Which objects a category holds, in words, from the means and spreads of their features."""

import math
from collections.abc import Sequence

from neurosym.operators import Category

_SIZES = {"s_x": "from back to front", "s_y": "from right to left", "d": "high"}
_TYPES = ("solid", "open at the top", "open at both ends (rings)")
_NEGLIGIBLE = 0.005


def objects_in_words(category: Category, feature_names: Sequence[str] = ()) -> tuple[str, ...]:
    """Say in sentences which objects a category holds.

    Args:
        category: The category.
        feature_names: What its features are, as the world names them; empty if nobody knows.
    """
    if not category.share:
        return ("None of the sampled objects has this symbol, so nothing is known of what is done to it.",)
    count = len(category.feature_means)
    names = feature_names if len(feature_names) == count else [f"f{i + 1}" for i in range(count)]
    measured = zip(names, category.feature_means, category.feature_spreads, strict=True)
    told = [_feature_in_words(*feature) for feature in measured]
    sizes = [text for text, is_sentence in told if not is_sentence]
    sentences = [text for text, is_sentence in told if is_sentence]
    share = f"{category.share:.0%} of the objects have this symbol"
    return (f"{share}: {', '.join(sizes)}." if sizes else f"{share}.", *sentences)


def type_shares(mean: float, spread: float) -> tuple[float, float, float] | None:
    """Work out which shares of objects are of type 0, 1 and 2, or return None if there are other types.

    Mean and spread say it exactly: mean = p1 + 2 p2 and spread^2 + mean^2 = p1 + 4 p2.

    Args:
        mean: Mean of the type.
        spread: Standard deviation of the type.
    """
    square = spread**2 + mean**2
    rings = (square - mean) / 2
    tops = 2 * mean - square
    shares = (1 - rings - tops, tops, rings)
    if all(-1e-6 <= share <= 1 + 1e-6 for share in shares):
        return shares
    return None


def _feature_in_words(name: str, mean: float, spread: float) -> tuple[str, bool]:
    """Return what is said of a feature, and whether it is a sentence of its own."""
    if name in _SIZES:
        return f"{1000 * mean:.0f} ± {1000 * spread:.0f} mm {_SIZES[name]}", False
    shares = type_shares(mean, spread) if name == "t" and math.isfinite(mean) else None
    if shares is None:
        return f"{name} {mean:.3g} ± {spread:.3g}", False
    words = [
        f"{share:.0%} are {word}"
        for share, word in sorted(zip(shares, _TYPES, strict=True), reverse=True)
        if share > _NEGLIGIBLE
    ]
    return f"Of them, {', '.join(words)}.".replace("100% are", "all are"), True
