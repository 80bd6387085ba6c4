"""What is shown of symbols, as values and in words: for studio, report, terminal and programs alike.

Forward is +x (away from the robot), back is -x, left is +y, right is -y. Where vectors are not x, y, z, or
action parameters not waypoints of a hand, nothing is known of what they mean, and they stay plain numbers.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from statistics import median

from neurosym.errors import UnknownChoice
from neurosym.grounding import Grounding, is_lift
from neurosym.operators import CARRIED, Category, Mode, Operator, Primitive, Symbol, Vector, names_of_features
from neurosym.problems import SceneObject
from neurosym.tasks.promises import usable

AXES = 3
"""Vectors of this many numbers are taken for x, y, z [m]."""
_WAYPOINT = (False, False, False, True)  # x, y, z and a gripper value
_OPEN = 0.5
_TURNED = 5  # so many degrees an outcome turns objects by, at least, to be told of
_ENDS: dict[str, str] = {
    "resting": "at rest",
    "held": "held",
    "toppled": "on another face",
    "carried": "carried to the place",
    "missed": "not carried to the place",
    "lost": "off the table",
}


@dataclass(frozen=True, slots=True)
class EffectRow:
    """One way that an action symbol turns out on a category."""

    operator: str  # its name, as in the PDDL domain
    trials: int  # how many rehearsals there were, or rows of the data
    promised: int  # how many of them ended within the tolerance of what the operator promises
    share: float  # of those that ended in this way
    ends: str  # how the object ended
    effect: str  # mean displacement as it ended, in words
    spread: str  # its standard deviation on each axis, in words
    domain: str  # whether the operator is in the PDDL domain, or why not; empty if nobody knows


@dataclass(frozen=True, slots=True)
class SymbolExplanation:
    """What one symbol means."""

    symbol: Symbol
    title: str  # what an action symbol does to which share of the objects; the name of a category
    about: str  # sentences on what the hand does, or on which objects have the symbol
    effects: tuple[EffectRow, ...] = ()  # what an action symbol does, by category and mode

    @property
    def called(self) -> frozenset[str]:
        """What it may be called by: its bits, its name, and its operators."""
        return frozenset((self.symbol, self.title, *(row.operator for row in self.effects)))


@dataclass(frozen=True, slots=True)
class Explanation:
    """What the symbols of a domain mean, in the order of their bits, as far as they were learned."""

    summary: tuple[str, ...]  # how many symbols there are, and what is said of all
    actions: tuple[SymbolExplanation, ...]
    objects: tuple[SymbolExplanation, ...]
    carrying: tuple[SymbolExplanation, ...] = ()  # actions that are aimed at a place
    relating: tuple[SymbolExplanation, ...] = ()  # actions that are aimed at another object
    states: tuple[SymbolExplanation, ...] = ()  # of pairs of objects
    pairs: tuple[SymbolExplanation, ...] = ()  # kinds of pairs of objects

    @property
    def parts(self) -> dict[str, tuple[SymbolExplanation, ...]]:
        """What is said of each kind of symbols, as far as there are any; objects come last."""
        names = [field.name for field in fields(self) if field.name not in ("summary", "objects")]
        every = {name: getattr(self, name) for name in (*names, "objects")}
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


@dataclass(frozen=True, slots=True)
class Promise:
    """What an operator promises for the object at hand, and how likely that is."""

    operator: Operator
    effect: Vector  # where it takes the object, at the end of the rise if it lifts [m]
    lifts: bool
    chance: float


def promises_for(item: SceneObject, grounding: Grounding) -> tuple[Promise, ...]:
    """List what the operators of a domain do to an object, the surest first."""
    found = [
        Promise(one, one.promise.outcome, is_lift(one), one.chance)
        for one in usable(grounding, item)
        if one.promise is not None and len(one.promise.outcome) == 3
    ]
    return tuple(sorted(found, key=lambda one: (-one.chance, one.operator.name)))


def effect_row(operator: Operator, mode: Mode | None, domain: str, *, is_aimed: bool = False) -> EffectRow:
    """Return one way that an operator turns out; without a mode, that it promises nothing.

    `domain` is as in the row; what is aimed at a place and not carried there ends elsewhere.
    """
    seen = operator.name, operator.trials, operator.successes
    if mode is None:
        return EffectRow(*seen, 0.0, "never as it could promise", "", "", domain)
    effect = "elsewhere" if is_aimed and mode.kind != "carried" else _mode_in_words(mode)
    spread = spread_in_words(mode.scatter) if mode.count > 1 else "seen once"
    return EffectRow(
        *seen, mode.share, _ENDS[mode.kind], effect + _turned_in_words(operator, mode), spread, domain
    )


def _turned_in_words(operator: Operator, mode: Mode) -> str:
    """Say by how much an outcome turns objects, in the median of rehearsals, if it does so at all."""
    turns = [row.turn for row in operator.rehearsals if row.kind == mode.kind]
    degrees = math.degrees(median(turns)) if turns else 0.0
    return f", turned by {degrees:.0f} degrees" if degrees >= _TURNED else ""


def _mode_in_words(mode: Mode) -> str:
    """Say where an object ends: relative to where it stood, or to the place that it was to be carried to."""
    away = displacement_in_words(mode.outcome)
    if mode.kind == "carried":
        return "at the place" if away == "nowhere" else f"{away} of the place"
    if mode.kind != "resting" or mode.peak_height <= CARRIED or len(mode.outcome) != AXES:
        return away
    return f"{away}, carried {distance_in_words(mode.peak_height, AXES)} high on the way"


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
    return f"± {', '.join(str(round(1000 * value)) for value in vector)} mm"


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
        moves.append(f"{told} to {_place_in_words(point, 'the centre')}.")
    travel = [end - start for start, end in zip(points[0], points[-1], strict=True)]
    start = _place_in_words(points[0], "the object's centre")
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
    spot = _place_in_words(primitive.action[-4:-1], reference)
    return (*told[:2], f"What it grips then it lifts, carries to {spot}, lowers and lets go.")


def _place_in_words(point: Sequence[float], what: str) -> str:
    """Say where a point is relative to something [m]: `42 mm back and 44 mm left of it, 25 mm below it`."""
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
        f"{abs(length)} mm {more if length > 0 else less}"
        for value, (more, less) in zip(vector, words, strict=True)
        if (length := round(1000 * value))
    ]


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
    names = names_of_features(count, feature_names if len(feature_names) == count else ())
    sizes, types = list[str](), list[str]()
    for name, mean, spread in zip(names, category.feature_means, category.feature_spreads, strict=True):
        if name in _SIZES:
            sizes.append(f"{1000 * mean:.0f} ± {1000 * spread:.0f} mm {_SIZES[name]}")
        elif name == "t" and math.isfinite(mean) and (shares := type_shares(mean, spread)):
            common = sorted(zip(shares, _TYPES, strict=True), reverse=True)
            words = [f"{share:.0%} are {word}" for share, word in common if share > _NEGLIGIBLE]
            types.append(f"Of them, {', '.join(words)}.".replace("100% are", "all are"))
        else:
            sizes.append(f"{name} {mean:.3g} ± {spread:.3g}")
    share = f"{category.share:.0%} of the objects have this symbol"
    return (f"{share}: {', '.join(sizes)}." if sizes else f"{share}.", *types)


def type_shares(mean: float, spread: float) -> tuple[float, float, float] | None:
    """Work out which shares of objects are of type 0, 1 and 2, or return None if there are other types.

    Mean and spread say it exactly: mean = p1 + 2 p2 and spread^2 + mean^2 = p1 + 4 p2.
    """
    square = spread**2 + mean**2
    rings, tops = (square - mean) / 2, 2 * mean - square
    shares = (1 - rings - tops, tops, rings)
    return shares if all(-1e-6 <= share <= 1 + 1e-6 for share in shares) else None
