"""The map of object symbols, as data: which objects have which code, over the features that matter most."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from neurosym.checks import Bool, Float, Int
from neurosym.contract import ObjectLimits, limits_of
from neurosym.errors import InvalidValue
from neurosym.operators import Categorise, Symbol, names_of_features, symbols_of
from neurosym.world import World

WORDS: Mapping[str, str] = {"s_y": "width", "s_x": "depth", "d": "height", "t": "type"}
"""What the features of our worlds are called, in the order in which the axes of a map are chosen."""
TYPES = ("solid", "open at the top", "open at both ends")
SAMPLES = 600
"""How many objects are drawn where no data are given."""
_CELLS, _HALVINGS = 40, 6
"""Cells along each axis, and how often the way between two that differ is halved to find the boundary."""
_FEW = 4  # a feature with so few values, or fewer, is a choice and not a length
_MILLIMETRES = 1000
Points = Float[np.ndarray, "P 2"]


@dataclass(frozen=True, slots=True)
class Feature:
    """One feature of objects: where it ends, or which values there are."""

    name: str  # as the world names it
    low: float
    high: float
    choices: tuple[float, ...] = ()  # every value, where there are few
    is_length: bool = False  # whether it is in metres

    @property
    def word(self) -> str:
        """What a newcomer calls it."""
        return WORDS.get(self.name, self.name)

    @property
    def unit(self) -> str:
        """Its unit as it is shown, or nothing."""
        return "mm" if self.is_length else ""

    @property
    def factor(self) -> float:
        """By what a value is multiplied to be shown."""
        return _MILLIMETRES if self.is_length else 1

    def told(self, value: float) -> str:
        """Write a value for a person: `43 mm`, `solid`, `0.31`."""
        if self.name == "t" and value in range(len(TYPES)):
            return TYPES[int(value)]
        return f"{self.factor * value:.0f} mm" if self.is_length else f"{value:.3g}"


@dataclass(frozen=True, slots=True, eq=False)
class SymbolMap:
    """The codes over one or two features, the others being what they are."""

    axes: tuple[Feature, ...]  # across, and upwards if there are two
    numbers: tuple[int, ...]  # of those among the features
    at: tuple[float, ...]  # features of all that is shown; those of the axes do not count
    #: outlines of each code's areas, across and upwards from 0 to 1; what lies in two of them is in none
    areas: dict[Symbol, tuple[Points, ...]]
    marks: dict[Symbol, tuple[float, float]]  # a place well within each code's greatest area


class Atlas:
    """Which objects of a world or of data have which code.

    Args:
        categorise: Gives the symbols of features (N, F).
        samples: Features of sampled objects (N, F), at least one.
        names: What the features are called, if somebody knows.
        limits: Which objects there are; if not given, those within the ranges of the samples.

    Attributes:
        features: What there is to know of each feature.
        matter: For each feature, the share of objects whose code another value alone changes.
        codes: The codes of the samples.
        axes: Numbers of the two features that matter most, or of the only one.
        others: Numbers of the other features, those that matter most first.
        typical: An object like most.
    """

    def __init__(
        self,
        categorise: Categorise,
        samples: Float[np.ndarray, "N F"],
        names: Sequence[str] = (),
        limits: ObjectLimits | None = None,
    ):
        if not len(samples):
            raise InvalidValue("There is no object to draw a map of symbols from.")
        self._categorise, self.samples = categorise, np.asarray(samples, dtype=float)
        self.features = _features(self.samples, names, limits)
        self.codes = symbols_of(categorise, self.samples)
        self.matter = tuple(self._share_changed(number) for number in range(len(self.features)))
        ranked = sorted(range(len(self.features)), key=lambda number: -self.matter[number])
        ranked.sort(key=lambda number: bool(self.features[number].choices))  # lengths first
        order = {name: place for place, name in enumerate(WORDS)}
        self.axes = tuple(
            sorted(ranked[:2], key=lambda n: order.get(self.features[n].name, len(order) + ranked.index(n)))
        )
        self.others = tuple(sorted(ranked[2:], key=lambda number: -self.matter[number]))
        near = zip(self.features, np.median(self.samples, axis=0).tolist(), strict=True)
        self.typical = tuple(
            one.choices[np.abs(np.array(one.choices) - value).argmin()] if one.choices else value
            for one, value in near
        )

    def _share_changed(self, number: int) -> float:
        """Give each sample the feature of another one, and say how many codes that changes."""
        changed = self.samples.copy()
        changed[:, number] = np.random.default_rng(number).permutation(changed[:, number])
        after = symbols_of(self._categorise, changed)
        return sum(one != other for one, other in zip(self.codes, after, strict=True)) / len(after)

    def symbols(self, features: Float[np.ndarray, "N F"]) -> tuple[Symbol, ...]:
        """Return the codes of objects."""
        return symbols_of(self._categorise, features)

    def settings(self, number: int) -> tuple[float, ...]:
        """Return the values of a feature worth drawing maps for: all, or a low, a middle and a high one."""
        feature = self.features[number]
        low, high = feature.low, feature.high
        return feature.choices or tuple(low + share * (high - low) for share in (1 / 6, 1 / 2, 5 / 6))

    def shares(self) -> dict[Symbol, float]:
        """Return which share of the samples has each code, the most frequent first."""
        found, counts = np.unique(np.array(self.codes), return_counts=True)
        order = np.argsort(-counts, kind="stable")
        return {str(found[one]): float(counts[one] / len(self.codes)) for one in order}

    def examples(self, symbol: Symbol, count: int = 4) -> tuple[tuple[float, ...], ...]:
        """Choose some samples of a code, from small ones to great ones; none if there are none."""
        own = self.samples[np.array(self.codes) == symbol]
        scale = np.ptp(self.samples, axis=0)
        own = own[np.argsort((own / np.where(scale > 0, scale, 1)).sum(1), kind="stable")]
        chosen = ((np.arange(count) + 0.5) / count * len(own)).astype(int)
        return tuple(tuple(one) for one in own[np.unique(chosen)].tolist()) if len(own) else ()

    def map(self, at: Sequence[float] | None = None) -> SymbolMap:
        """Draw the codes over the axes, the other features being these; `typical` if none are given."""
        where = self.typical if at is None else tuple(map(float, at))
        chosen = [self.features[number] for number in self.axes]

        def codes(points: Points) -> np.ndarray:
            features = np.tile(np.array(where), (len(points), 1))
            for column, (number, axis) in enumerate(zip(self.axes, chosen, strict=True)):
                features[:, number] = axis.low + points[:, column] * (axis.high - axis.low)
            return np.array(symbols_of(self._categorise, features))

        columns, rows = _CELLS, _CELLS if len(chosen) == 2 else 1
        middles = np.stack(
            np.meshgrid((np.arange(columns) + 0.5) / columns, (np.arange(rows) + 0.5) / rows), axis=-1
        )
        grid = codes(middles.reshape(-1, 2)).reshape(rows, columns)
        corners = _corners(grid, middles, codes)
        known = {str(code): grid == code for code in np.unique(grid)}
        areas = {code: tuple(corners[tuple(loop.T)] for loop in _loops(own)) for code, own in known.items()}
        marks = {code: _innermost(own, middles) for code, own in known.items()}
        return SymbolMap(tuple(chosen), self.axes, where, areas, marks)


def atlas_of(world: World, categorise: Categorise) -> Atlas:
    """Draw objects of a world, the same ones each time, and return which codes they have."""
    rng = np.random.default_rng(0)
    drawn = np.vstack([world.sample_scene(rng, 1).features for _ in range(SAMPLES)])
    return Atlas(categorise, drawn, world.feature_names, limits_of(world))


def _features(
    samples: Float[np.ndarray, "N F"], names: Sequence[str], limits: ObjectLimits | None
) -> tuple[Feature, ...]:
    if limits is not None:
        *sizes, kind = limits.feature_names
        lengths = [
            Feature(name, *ends, is_length=True) for name, ends in zip(sizes, limits.sizes, strict=True)
        ]
        return (*lengths, Feature(kind, min(limits.types), max(limits.types), tuple(limits.types)))
    found = list[Feature]()
    count = samples.shape[1]
    for name, column in zip(
        names_of_features(count, names if len(names) == count else ()), samples.T, strict=True
    ):
        values = tuple(np.unique(column).tolist())
        few = values if len(values) <= _FEW else ()
        high = values[-1] if len(values) > 1 else values[0] + 1
        found.append(Feature(name, values[0], high, few, is_length=name in WORDS and name != "t"))
    return tuple(found)


def _corners(
    grid: np.ndarray, middles: Float[np.ndarray, "R C 2"], codes: Callable[[Points], np.ndarray]
) -> Float[np.ndarray, "R+1 C+1 2"]:
    """Place the corners of cells, those between cells that differ upon the boundary between their middles."""
    rows, columns = grid.shape
    lines = (np.linspace(0, 1, columns + 1), np.linspace(0, 1, rows + 1))
    corners = np.stack(np.meshgrid(*lines), axis=-1)
    sums, counts = np.zeros_like(corners), np.zeros((*corners.shape[:2], 1))
    for step in ((1, 0), (0, 1)):  # to the cell above, and to the one on the right
        ones, others = grid[: rows - step[0], : columns - step[1]], grid[step[0] :, step[1] :]
        at = np.argwhere(ones != others)
        if not len(at):
            continue
        start, end = middles[tuple(at.T)], middles[tuple((at + step).T)]
        codes_there, low, high = ones[tuple(at.T)], np.zeros(len(at)), np.ones(len(at))
        for _ in range(_HALVINGS):
            half = (low + high) / 2
            is_same = codes(start + half[:, None] * (end - start)) == codes_there
            low, high = np.where(is_same, half, low), np.where(is_same, high, half)
        crossing = start + ((low + high) / 2)[:, None] * (end - start)
        for corner in (at + step, at + 1):  # the two that both cells have
            np.add.at(sums, tuple(corner.T), crossing)
            np.add.at(counts, tuple(corner.T), 1)
    moved = np.where(counts > 0, sums / np.maximum(counts, 1), corners)
    moved[[0, -1], :, 1], moved[:, [0, -1], 0] = corners[[0, -1], :, 1], corners[:, [0, -1], 0]
    return moved


def _loops(own: Bool[np.ndarray, "R C"]) -> list[Int[np.ndarray, "L 2"]]:
    """Follow the corners around all areas of cells that are set."""
    padded, ways = np.pad(own, 1), dict[tuple[int, int], list[tuple[int, int]]]()
    for row, column in np.argwhere(own).tolist():
        around = [(row, column), (row, column + 1), (row + 1, column + 1), (row + 1, column)]
        neighbours = [(row - 1, column), (row, column + 1), (row + 1, column), (row, column - 1)]
        for (start, end), (above, beside) in zip(pairwise([*around, around[0]]), neighbours, strict=True):
            if not padded[above + 1, beside + 1]:
                ways.setdefault(start, []).append(end)
    loops = []
    while ways:
        loop = [next(iter(ways))]
        while loop[-1] in ways:
            ends = ways[loop[-1]]
            loop.append(ends.pop())
            if not ends:
                del ways[loop[-2]]
        loops.append(np.array(loop[:-1]))
    return loops


def _innermost(own: Bool[np.ndarray, "R C"], middles: Float[np.ndarray, "R C 2"]) -> tuple[float, float]:
    """Find the middle of a cell that is farthest from all that are not set, and from the edges."""
    around = np.pad(own, 1)
    beside = around[:-2, 1:-1] | around[2:, 1:-1] | around[1:-1, :-2] | around[1:-1, 2:]
    inside, outside = middles[own], middles[beside & ~own]
    across = inside if len(own) > 1 else inside[:, :1]  # a single row of cells has no edge above and below
    room = np.hstack([across, 1 - across]).min(1)
    if len(outside):
        room = np.minimum(room, np.linalg.norm(inside[:, None] - outside, axis=2).min(1))
    x, y = inside[np.argmax(room)].tolist()
    return x, y
