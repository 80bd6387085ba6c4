"""Making way: where objects are carried that stand in the way of what must be led over cells."""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field

import msgspec
import numpy as np

from neurosym.arrays import Bool, Float
from neurosym.operators import Vector
from neurosym.problems import Problem
from neurosym.table import Table
from neurosym.tasks.footprints import footprints_apart, near_some
from neurosym.tasks.places import GAP, LEAST_GAP

BESIDE = 0.02
"""Room for the hand beside the way of what is led [m]."""
_CANDIDATES = 2000
_EDGE = 0.02  # how far inside the edge of the table objects are put aside [m]

_Spots = Float[np.ndarray, "N 2"]


@dataclass(frozen=True, slots=True, eq=False)
class Way:
    """The way of what is led, among objects that can be carried out of it.

    Attributes:
        path: Where what cannot be carried stands after each step [m].
        led: Names of these objects, in the order of the path.
        now: The problem with the objects where they stand when the way is to be cleared; objects wait at its
            places, or anywhere if it has none.
        table: Where objects may stand.
    """

    path: Float[np.ndarray, "steps L 3"]
    led: Sequence[str]
    now: Problem
    table: Table
    names: tuple[str, ...] = field(init=False)
    apart: Float[np.ndarray, "M M 2"] = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "names", self.now.object_names)
        object.__setattr__(self, "apart", footprints_apart(self.now))

    def cleared(
        self, can_be: Collection[str], goals: Mapping[str, Vector], *, everything: bool
    ) -> dict[str, Vector]:
        """Return where objects are to be carried before anything is led along the way [m].

        What stands in the way goes to its goal if that is free and beside the way, and else aside, if there
        is room; the largest first.

        Args:
            can_be: Names of the objects that can be carried.
            goals: The goals of some of them [m].
            everything: Whether others are carried to their goals, too, if these are beside the way.
        """
        items, in_it = [one for one in self.now.objects if one.name in can_be], self.in_the_way(can_be)
        before = dict[str, Vector]()
        for item in sorted(items, key=lambda one: (-max(one.features[:2]), one.name)):
            is_in_it = item.name in in_it
            if not is_in_it and not everything:
                continue
            goal = goals.get(item.name)
            if goal and self._is_free(item.name, _spots(goal), before, BESIDE)[0]:
                before[item.name] = goal
            elif is_in_it and (spot := self._aside(item.name, before, goals)):
                before[item.name] = (*spot, item.position[2])
        return before

    def in_the_way(self, names: Collection[str]) -> set[str]:
        """Name those of some objects that stand in the way.

        Args:
            names: Names of the objects.
        """
        items = [item for item in self.now.objects if item.name in names]
        return {item.name for item in items if self._in_it(item.name, _spots(item.position))[0]}

    def _aside(
        self, name: str, moved: Mapping[str, Vector], goals: Mapping[str, Vector]
    ) -> tuple[float, float] | None:
        """Return a spot where an object can wait [m], off the goals of others if possible."""
        spots = self._candidates(name)
        others = [other for other in goals if other != name]
        wanted = np.array([goals[other][:2] for other in others]).reshape(-1, 2)
        rows = [self.names.index(other) for other in others]
        apart = self.apart[self.names.index(name), rows]
        for gap, keeps_off in ((GAP, True), (LEAST_GAP, True), (LEAST_GAP, False)):
            fit = self._is_free(name, spots, moved, gap)
            if keeps_off:
                fit &= ~near_some(spots, wanted, apart + gap)
            if fit.any():
                x, y = spots[fit.argmax()].tolist()
                return x, y
        return None

    def _candidates(self, name: str) -> _Spots:
        """List where an object may wait: the same spots for the same object and table."""
        if self.now.places is not msgspec.UNSET:
            return _spots(*self.now.places.values())
        half = np.array(self.now.object_named(name).features[:2], dtype=float) / 2
        low, high = np.array([self.table.x, self.table.y]).T
        inside = np.minimum(half + _EDGE, (high - low) / 2)
        drawn = np.random.default_rng(0).uniform(size=(_CANDIDATES, 2))
        return np.asarray(low + inside + drawn * (high - low - 2 * inside))

    def _is_free(
        self, name: str, spots: _Spots, moved: Mapping[str, Vector], gap: float
    ) -> Bool[np.ndarray, " N"]:
        """Say at which spots an object is out of the way and clear of others, some of which were moved."""
        others = [row for row, other in enumerate(self.names) if other != name]
        here = _spots(*(moved.get(item.name, item.position) for item in self.now.objects))
        apart = self.apart[self.names.index(name), others] + gap
        return np.asarray(~(near_some(spots, here[others], apart) | self._in_it(name, spots)))

    def _in_it(self, name: str, spots: _Spots) -> Bool[np.ndarray, " N"]:
        """Say at which spots an object would stand in the way."""
        columns = [self.names.index(one) for one in self.led]
        apart = self.apart[self.names.index(name), columns] + BESIDE
        apart = np.broadcast_to(apart, (len(self.path), *apart.shape))  # (steps, L, 2)
        return near_some(spots, self.path[..., :2].reshape(-1, 2), apart.reshape(-1, 2))


def _spots(*positions: Sequence[float]) -> _Spots:
    return np.array([position[:2] for position in positions], dtype=float).reshape(-1, 2)
