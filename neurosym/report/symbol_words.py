"""What is said of the symbols of a domain, as values that a page, a terminal or a program can show."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

from neurosym.errors import UnknownChoice
from neurosym.operators import Category, Primitive, Symbol

_PARTS = ("actions", "carrying", "relating", "states", "pairs", "objects")


@dataclass(frozen=True, slots=True)
class EffectRow:
    """One way that an action symbol turns out on a category.

    Attributes:
        operator: Name of the operator, as in the PDDL domain.
        trials: How many rehearsals there were, or rows of the data.
        promised: How many of them ended within the tolerance of what the operator promises.
        share: Share of the rehearsals that ended so.
        ends: How the object ended.
        effect: Mean displacement as it ended, in words.
        spread: Its standard deviation on each axis, in words.
        domain: Whether the operator is in the PDDL domain, or why not; empty if nobody knows.
    """

    operator: str
    trials: int
    promised: int
    share: float
    ends: str
    effect: str
    spread: str
    domain: str


@dataclass(frozen=True, slots=True)
class SymbolExplanation:
    """What one symbol means.

    Attributes:
        symbol: Its bits.
        title: What an action symbol does to which share of the objects; the name of a category.
        about: Sentences on what the hand does, or on which objects have the symbol.
        effects: What an action symbol does, by category and mode; empty for object symbols.
    """

    symbol: Symbol
    title: str
    about: str
    effects: tuple[EffectRow, ...] = ()

    @property
    def called(self) -> frozenset[str]:
        """What it may be called by: its bits, its name, and its operators."""
        return frozenset((self.symbol, self.title, *(row.operator for row in self.effects)))


@dataclass(frozen=True, slots=True)
class Explanation:
    """What the symbols of a domain mean.

    Attributes:
        summary: How many symbols there are, and what is said of all.
        actions: The action symbols, in the order of their bits.
        objects: The object symbols, in the order of their bits.
        carrying: The symbols of actions that are aimed at a place, if these were learned.
        relating: The symbols of actions that are aimed at another object, if these were learned.
        states: The states of pairs of objects, if these were learned.
        pairs: The kinds of pairs of objects, if these were learned.
    """

    summary: tuple[str, ...]
    actions: tuple[SymbolExplanation, ...]
    objects: tuple[SymbolExplanation, ...]
    carrying: tuple[SymbolExplanation, ...] = ()
    relating: tuple[SymbolExplanation, ...] = ()
    states: tuple[SymbolExplanation, ...] = ()
    pairs: tuple[SymbolExplanation, ...] = ()

    @property
    def parts(self) -> dict[str, tuple[SymbolExplanation, ...]]:
        """What is said of each kind of symbols, as far as there are any."""
        every = {name: getattr(self, name) for name in _PARTS}
        return {name: part for name, part in every.items() if part}

    def only(self, symbol: str) -> "Explanation":
        """Keep what is said of one symbol, which may be one of actions and of objects alike.

        Raises:
            UnknownChoice: If there is none.
        """
        parts = {
            name: tuple(one for one in part if symbol in one.called) for name, part in self.parts.items()
        }
        if not any(parts.values()):
            known = dict.fromkeys(one.symbol for part in self.parts.values() for one in part)
            raise UnknownChoice("symbol", symbol, known, "`neurosym explain DIR`")
        return replace(self, summary=(), **parts)


# Points, displacements and actions in words that can be followed without a picture.
#
# Forward is +x (away from the robot), back is -x, left is +y, right is -y. Where vectors are not x, y, z,
# or action parameters not waypoints of a hand, nothing is known of what they mean, and they stay plain
# numbers.

AXES = 3
"""Vectors of this many numbers are taken for x, y, z [m]."""

_WAYPOINT = (False, False, False, True)  # x, y, z and a gripper value
_OPEN = 0.5


def displacement_in_words(vector: Sequence[float]) -> str:
    """Say how far and where to something moved: `57 mm forward, 90 mm right, 213 mm up`.

    Args:
        vector: Displacement along x, y, z [m], or along axes of another number and meaning.
    """
    if len(vector) != AXES:
        return _numbers(vector)
    return ", ".join(_parts(vector, "up", "down")) or "nowhere"


def spread_in_words(vector: Sequence[float]) -> str:
    """Say how far something scatters on each axis: `± 24, 11, 2 mm`."""
    if len(vector) != AXES:
        return f"± {_numbers(vector)}"
    return f"± {', '.join(str(_millimetres(value)) for value in vector)} mm"


def distance_in_words(distance: float, axes: int) -> str:
    """Say how long a vector of so many axes is."""
    return f"{1000 * distance:.0f} mm" if axes == AXES else f"{distance:.3g}"


def action_in_words(action: Sequence[float], gripper: Sequence[bool] = ()) -> tuple[str, ...]:
    """Say in sentences what the hand does.

    `gripper` says which parameters are gripper values; it is empty if nobody knows.
    """
    if not action or len(action) % len(_WAYPOINT) or tuple(gripper) != _WAYPOINT * (len(action) // 4):
        return (f"Its parameters are {_numbers(action)}.",)
    points = [action[i : i + AXES] for i in range(0, len(action), len(_WAYPOINT))]
    hands = ["open" if value >= _OPEN else "closed" for value in action[AXES :: len(_WAYPOINT)]]
    moves = []
    for point, before, after in zip(points[1:], hands, hands[1:], strict=False):
        turn = "opens" if after == "open" else "closes"
        told = f"Still {after}, it moves" if before == after else f"It {turn} there and moves"
        moves.append(f"{told} to {place_in_words(point, 'the centre')}.")
    travel = [end - start for start, end in zip(points[0], points[-1], strict=True)]
    start = place_in_words(points[0], "the object's centre")
    return (
        f"The hand starts {hands[0]}, {start}.",
        *moves,
        f"It rises {hands[-1]}; from start to end it has moved {displacement_in_words(travel)}.",
    )


def aimed_action_in_words(
    primitive: Primitive, gripper: Sequence[bool], reference: str = "the place"
) -> tuple[str, ...]:
    """Say what the hand does: two waypoints are relative to the object, the third to what it is aimed at."""
    told = action_in_words(primitive.action, gripper)
    if len(told) <= AXES:  # plain numbers
        return told
    spot = place_in_words(primitive.action[-4:-1], reference)
    return (*told[:2], f"What it grips then it lifts, carries to {spot}, lowers and lets go.")


def place_in_words(point: Sequence[float], what: str) -> str:
    """Say where a point lies: `42 mm back and 44 mm left of the centre, 25 mm below it`.

    The point is relative to what it is near [m].
    """
    level = " and ".join(_parts((*point[:2], 0.0)))
    (height,) = _parts((0.0, 0.0, point[2]), "above", "below") or [""]
    if not level:
        return f"{height or 'at'} {what}"
    return f"{level} of {what}" + (f", {height} it" if height else ", level with it")


def _numbers(values: Sequence[float]) -> str:
    return ", ".join(f"{value:.3g}" for value in values)


def _parts(vector: Sequence[float], up: str = "up", down: str = "down") -> list[str]:
    words = (("forward", "back"), ("left", "right"), (up, down))
    return [
        f"{abs(_millimetres(value))} mm {more if value > 0 else less}"
        for value, (more, less) in zip(vector, words, strict=True)
        if _millimetres(value)
    ]


def _millimetres(value: float) -> int:
    return round(1000 * value)


_SIZES = {"s_x": "from back to front", "s_y": "from right to left", "d": "high"}
_TYPES = ("solid", "open at the top", "open at both ends (rings)")
_NEGLIGIBLE = 0.005


def objects_in_words(category: Category, feature_names: Sequence[str] = ()) -> tuple[str, ...]:
    """Say in sentences which objects a category holds.

    `feature_names` are as the world names them, empty if nobody knows.
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
