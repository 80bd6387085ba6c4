"""Goals that meet conditions: which objects, where to, and onto what, chosen for the scene at hand.

Conditions leave choices open: which two of five, which end of the table, which side of a box. Each choice
becomes points and relations, which planners, the page of PDDL and execution know. Of the options the one is
taken that moves the fewest objects, and these the least. A goal lies so far inside of its bounds that what
comes within the tolerance of it meets the condition; where there is less room, the tolerance is smaller.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from itertools import islice, product

import msgspec
import numpy as np

from neurosym.checks import Bool, Float, check_kind
from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.problems import Problem
from neurosym.tasks import conditions
from neurosym.tasks.conditions import Clause, options_of
from neurosym.tasks.lying import as_raised, lying
from neurosym.tasks.options import Put
from neurosym.tasks.task import LEAST_GAP, drawn_spots, is_within, understand

MOST_OPTIONS = 64
"""So many ways to meet all conditions are looked at, at most."""
LEAST_TOLERANCE = 0.01
"""Where bounds leave little room, goals are to be met within this all the same [m]."""
_ROOM = 0.4  # how far inside of bounds a goal lies, as a share of their width, if not by the tolerance
_NEAR_TURNED = 0.02  # how near its goal something comes that is turned on the way [m]
_RING = 8  # spots around a point, or along each side of an object, where another one may stand
_LEVEL = 0.005  # heights that differ by less are the same, and by as much what is put ends off its height [m]


def _ring() -> Float[np.ndarray, "K 2"]:
    """Return directions all around."""
    angles = np.linspace(0, 2 * np.pi, _RING, endpoint=False)
    return np.column_stack([np.cos(angles), np.sin(angles)])


@dataclass
class _Need:
    """What one object shall come to."""

    bounds: dict[str, tuple[float, float]] = field(default_factory=dict)
    beside: list[Clause] = field(default_factory=list)  # that name what it is next to, or apart from
    off: set[str] = field(default_factory=set)  # what must not bear it
    heading: float | None = None  # how it shall be turned [degrees]

    def within(self, bounds: conditions.Bounds) -> None:
        """Ask for bounds, too; `InvalidValue` if there is no room in both."""
        for axis, (low, high) in bounds.items():
            if axis == "heading":
                if self.heading not in (None, low):
                    raise InvalidValue(f"It shall be turned by {self.heading:g} and by {low:g} degrees")
                self.heading = low
                continue
            before = self.bounds.get(axis, (-math.inf, math.inf))
            low, high = max(low, before[0]), min(high, before[1])
            if low > high:
                raise InvalidValue(f"Its {axis} shall be at least {low:g} and at most {high:g}")
            self.bounds[axis] = low, high


def with_goals(problem: Problem, grounding: Grounding) -> Problem:
    """Return a problem with goals that meet its conditions; one without conditions stays as it is.

    Raises:
        InvalidValue: If a condition cannot be read, or nothing is found that meets all of them.
        UnknownChoice: If one names what there is not.
    """
    check_kind("problem", problem, Problem, "a Problem")
    check_kind("grounding", grounding, Grounding, "a Grounding")
    if not problem.conditions:
        return problem
    asked = problem.asked_within or problem.tolerance
    bare = msgspec.structs.replace(
        problem, goals={}, relations=(), headings={}, upright=(), tolerance=asked, asked_within=None
    )
    every = [options_of(text, bare, grounding) for text in problem.conditions]
    sight, found, said = (
        conditions.Sight(bare, grounding),
        list[tuple[int, float, int, Problem]](),
        list[str](),
    )
    for number, chosen in enumerate(islice(product(*every), MOST_OPTIONS)):
        try:
            goals = _Choice(sight, grounding, [clause for option in chosen for clause in option]).problem()
        except InvalidValue as error:
            said.append(str(error))
            continue
        found.append((*_effort(goals, sight, grounding), number, goals))
    if not found:
        raise InvalidValue(said[0])
    return min(found, key=lambda one: one[:3])[-1]


def _effort(problem: Problem, sight: conditions.Sight, grounding: Grounding) -> tuple[int, float]:
    """Return how many objects are to be moved, and how far in sum."""
    far = [math.dist(problem.goals[name], sight.places[name]) for name in problem.unmet]
    unrelated = [
        one for one in problem.relations if not sight.holds(Clause((one[0],), 1, word="on", other=one[1]))
    ]
    return len(far) + len(unrelated) + len(lying(problem, grounding)), math.fsum(far)


class _Choice:
    """One way to meet clauses: an option of each condition."""

    def __init__(self, sight: conditions.Sight, grounding: Grounding, clauses: Sequence[Clause]):
        self._sight, self._grounding, self._problem = sight, grounding, sight.problem
        self._needs, self._over = dict[str, _Need](), dict[str, tuple[str, str]]()
        self._set_upright([clause for clause in clauses if clause.word == "upright"])
        self._tolerance, self._ends = self._problem.tolerance, dict[str, Float[np.ndarray, "3"]]()
        clauses = [clause for clause in clauses if clause.word != "upright"]
        fewest_first = sorted(clauses, key=lambda clause: len(clause.names) - clause.count)
        for clause in fewest_first:
            for name in self._chosen(clause):
                self._ask(name, clause)
        for name in [name for name in self._needs if name in self._over]:
            self._hand_down(name)
        for name in [name for name in self._needs if name in sight.supports and self._may_stay(name)]:
            self._stay_borne(name)
            del self._needs[name]

    def _set_upright(self, clauses: Sequence[Clause]) -> None:
        """Take objects as they will be, once those stand upright that shall."""
        if names := tuple(dict.fromkeys(name for clause in clauses for name in self._chosen(clause))):
            self._problem = msgspec.structs.replace(self._problem, upright=names)
            for name, operator in lying(self._problem, self._grounding).items():
                if operator is None:
                    raise InvalidValue(f"Nothing that was learned sets {name} upright as and where it lies.")
            self._sight = conditions.Sight(as_raised(self._problem, self._grounding), self._grounding)

    def _stay_borne(self, name: str) -> None:
        """Ask for an object to stay on what bears it, and that on what bears that, down to the table."""
        while (borne := self._sight.supports.get(name)) and name not in self._over:
            self._over[name], name = (borne.by, borne.state.name), borne.by

    def problem(self) -> Problem:
        """Return the problem with goals."""
        goals = {name: self._goal(name, spot) for name, spot in self._spots().items()}
        relations = tuple((name, other, state) for name, (other, state) in self._over.items())
        headings = {name: need.heading for name, need in self._needs.items() if need.heading is not None}
        asked = self._problem.tolerance
        tolerance = min(max(round(self._tolerance, 4), LEAST_TOLERANCE), asked)
        return msgspec.structs.replace(
            self._problem,
            goals=goals,
            relations=relations,
            headings=headings,
            tolerance=tolerance,
            asked_within=asked if tolerance < asked else None,
        )

    def _chosen(self, clause: Clause) -> list[str]:
        """Name the objects that it shall hold of: those of which it does, and then the nearest."""

        def far(name: str) -> tuple[bool, bool, float, str]:
            spot = self._sight.places[name]
            off = [
                max(low - spot["xyz".index(axis)], spot["xyz".index(axis)] - high, 0.0)
                for axis, (low, high) in clause.bounds.items()
                if axis != "heading"
            ]
            away = self._sight.gap(name, clause.other) if clause.other else math.hypot(*off)
            if clause.word == "upright":
                asked = msgspec.structs.replace(self._problem, upright=(name,))
                away = float(None in lying(asked, self._grounding).values())
            is_busy = name in self._over or name in self._needs
            return not self._sight.holds_of(name, clause), is_busy, away, name

        return sorted(clause.names, key=far)[: clause.count]

    def _ask(self, name: str, clause: Clause) -> None:
        if clause.word == "under":
            self._put(clause.other, name, "on")
            return
        if clause.word and clause.word not in (*conditions.OVER, "next-to", "apart-from"):
            self._put(name, clause.other, clause.word)
            return
        if clause.word == "on":
            self._put(name, clause.other, "on")
            return
        need = self._needs.setdefault(name, _Need())
        if clause.word == "not-on":
            need.off.add(clause.other)
        elif clause.word:
            need.beside.append(clause)
        else:
            try:
                need.within(clause.bounds)
            except InvalidValue as error:
                raise InvalidValue(f"What is asked of {name} contradicts itself: {error}.") from error

    def _put(self, name: str, other: str, word: str) -> None:
        """Ask for an object to be on another one, in the state that is surest if any will do."""
        state, before = self._state(name, other, word), self._over.get(name)
        if before and before != (other, state):
            raise InvalidValue(f"{name} shall be on {before[0]} and on {other}; ask for one of these.")
        self._over[name] = other, state

    def _state(self, name: str, other: str, word: str) -> str:
        if word != "on":
            return word
        if self._sight.holds(Clause((name,), 1, word="on", other=other)):
            return self._sight.supports[name].state.name
        if not (puts := self._puts(name, other)):
            raise InvalidValue(f"Nothing that was learned puts {name} on or into {other}.")
        return puts[-1].state.name

    def _puts(self, name: str, other: str) -> list[Put]:
        """List what puts an object on or into another one, the surest last."""
        puts = understand(self._problem, self._grounding).puts[name, other]
        return sorted(puts, key=lambda put: (put.chance, put.name))

    def _beyond(self, name: str) -> Float[np.ndarray, "2"]:
        """Return where an object ends over what shall bear it, seen from the middle of that [m]."""
        other, state = self._over[name]
        if self._sight.holds(Clause((name,), 1, word="on", other=other)):
            return np.asarray((self._sight.places[name] - self._sight.places[other])[:2])
        halves = (self._sight.sizes[name] + self._sight.sizes[other])[:2] / 2
        ends = [put.end.effect[:2] for put in self._puts(name, other) if put.state.name == state]
        return np.array(ends[-1]) * halves if ends else np.zeros(2)

    def _hand_down(self, name: str) -> None:
        """Ask of what stands on the table below an object for what was asked of that."""
        need, chain = self._needs.pop(name), [name]
        if need.heading is not None:
            raise InvalidValue(f"{name} shall be on another object, so its heading cannot be asked for.")
        beyond = np.zeros(2)
        while (over := self._over.get(chain[-1])) and over[0] not in chain:
            beyond += self._beyond(chain[-1])
            chain.append(over[0])
        if wrong := need.off & {*chain}:
            raise InvalidValue(f"{name} shall be on {min(wrong)}, and not on it; ask for one of these.")
        below = self._needs.setdefault(chain[-1], _Need())
        asked = {axis: need.bounds[axis] for axis in "xy" if axis in need.bounds}
        off = dict(zip("xy", beyond.tolist(), strict=True))
        try:
            below.within({axis: (low - off[axis], high - off[axis]) for axis, (low, high) in asked.items()})
        except InvalidValue as error:
            said = f"What is asked of {name} and of {chain[-1]}, on which it shall be, contradicts itself"
            raise InvalidValue(f"{said}: {error}.") from error
        below.beside += need.beside

    # Where things shall stand

    def _spots(self) -> dict[str, Float[np.ndarray, "2"]]:
        """Choose where each object shall stand of which something is asked, first of those that may stay."""
        found, left = dict[str, Float[np.ndarray, "2"]](), dict(self._needs)
        while left:
            waits = [name for name in left if not any(one.other in left for one in left[name].beside)]
            name = min(waits or left, key=lambda one: (not self._may_stay(one), self._height(one), one))
            others = {
                other: found.get(other, self._sight.places[other][:2])
                for other in self._problem.object_names
                if other != name and (other in found or (other not in left and other not in self._raised))
            }
            above = {one: self._sight.places[one][:2] for one in self._sight.supports if one not in left}
            need = left.pop(name)
            spot = self._spot(name, need, above | others)
            if spot is not None:
                found[name] = spot
            elif (below := self._put_near(name, need, others)) and below not in found:
                if below in self._needs:  # it is to be brought to where the object shall be
                    left[below] = self._needs[below]
                else:
                    found[below] = others[below]
        return found

    def _put_near(self, name: str, need: _Need, others: Mapping[str, Float[np.ndarray, "2"]]) -> str:
        """Ask for an object to be on another one, as it comes most surely to the height that is asked for.

        Returns:
            What stands on the table and shall bear it; nothing if that is on something itself.

        Raises:
            InvalidValue: If nothing brings it there.
        """
        middles = {one: self._ends.get(one, self._sight.places[one]) for one in (*others, *self._over)}
        for one, spot in others.items():
            if not np.array_equal(spot, middles[one][:2]):  # it shall stand elsewhere on the table
                middles[one] = np.array([*spot, self._sight.sizes[one][2] / 2])
        laden = {bearer for bearer, _ in self._over.values()}
        found = list[tuple[bool, float, str, str, Float[np.ndarray, "3"]]]()
        may_be = "z" in need.bounds and need.heading is None and self._grounding.relations
        for other in middles.keys() - need.off if may_be else ():
            reach = (self._sight.sizes[name] + self._sight.sizes[other]) / 2
            for put in self._puts(name, other):
                end = middles[other] + put.end.effect[:3] * reach
                is_free = other not in laden or put.operator.takes("occupied")
                may_move = other in others and other not in self._needs
                stays = self._is_near(end, need, "xyz")
                if is_free and (stays or (may_move and self._is_near(end, need, "z"))):
                    found.append((stays, put.chance, other, put.state.name, end))
        if not found:
            said = f"There is no room on the table for all that is asked of {name}"
            if not self._is_level(name, need):
                rests = float(self._sight.sizes[name][2]) / 2
                said += f"; its middle is {rests:.3f} m high there, and nothing brings it as high as asked"
            raise InvalidValue(f"{said}.")
        stays, _, other, state, self._ends[name] = max(found, key=lambda one: one[:4])
        self._over[name] = other, state
        self._stay_borne(other)
        if not stays:
            self._needs[name] = need
            self._hand_down(name)
        return other if other in others else ""

    def _is_near(self, end: Float[np.ndarray, "3"], need: _Need, axes: str) -> bool:
        """Say whether an end meets what is asked along axes, though it is missed by a little."""
        off = 0.0
        for axis, (low, high) in ((axis, need.bounds[axis]) for axis in axes if axis in need.bounds):
            value = float(end["xyz".index(axis)])
            if low == high:
                off = math.hypot(off, value - low)
            elif not low + (room := _LEVEL if axis == "z" else LEAST_TOLERANCE) <= value <= high - room:
                return False
        return off <= self._problem.tolerance - LEAST_TOLERANCE

    @property
    def _raised(self) -> set[str]:
        """What is, or shall be, on another object, so that it needs no room on the table."""
        return {*self._over, *self._sight.supports}

    def _may_stay(self, name: str) -> bool:
        """Say whether all that is asked of an object holds already."""
        need = self._needs[name]
        clauses = [*need.beside, *(Clause((name,), 1, word="not-on", other=other) for other in need.off)]
        clauses += [Clause((name,), 1, need.bounds)] if need.bounds else []
        if need.heading is not None and not self._sight.is_headed(name, need.heading):
            return False
        moves = any(one.other in self._needs and not self._may_stay(one.other) for one in need.beside)
        return not moves and all(self._sight.holds_of(name, one) for one in clauses)

    def _spot(
        self, name: str, need: _Need, others: dict[str, Float[np.ndarray, "2"]]
    ) -> Float[np.ndarray, "2"] | None:
        """Return the nearest spot on the table that will do, where others stand elsewhere; None if none."""
        here, size = self._sight.places[name][:2], self._sight.sizes[name][:2]
        low, high = self._inside(need)
        if self._may_stay(name):
            return here
        if is_to_turn := need.heading is not None and not self._sight.is_headed(name, need.heading):
            self._check_turns(name)
            self._tolerance = min(self._tolerance, _NEAR_TURNED)
        free = drawn_spots(size, self._grounding.table)
        spots = np.array([np.clip(here, low, high), *self._beside(name, need, others), *free])
        inside = np.all((spots >= low - 1e-9) & (spots <= high + 1e-9), axis=1)
        if is_to_turn:  # it is to be carried, so its goal must not be met where it is
            spots, inside = self._moved_aside(spots, inside, here, need)
        asked = {other: spot for other, spot in others.items() if other in self._needs or other in self._over}
        near = {one.other: others[one.other] for one in need.beside if one.other in others}
        around = () if is_to_turn else self._around(name, need)
        is_level = self._is_level(name, need)
        for kept in (others, asked | near) if is_level else (others,):
            # what nothing is asked of may be moved out of the way, unless it may bear the object
            good = inside & is_level & self._has_room(name, need, spots, kept)
            if good.any():
                return np.asarray(spots[good][np.linalg.norm(spots[good] - spots[0], axis=1).argmin()])
            for ring, left in around:
                if (good := self._has_room(name, need, ring, kept)).any():
                    self._tolerance = min(self._tolerance, left)
                    need.bounds.pop("z", None)
                    return np.asarray(ring[good][0])
        return None

    def _is_level(self, name: str, need: _Need) -> bool:
        """Say whether an object that stands on the table is as high as is asked for."""
        low, high = need.bounds.get("z", (0.0, math.inf))
        return bool(low - _LEVEL <= self._sight.sizes[name][2] / 2 <= high + _LEVEL)

    def _height(self, name: str) -> float:
        """Return how high an object shall be, if it cannot be there on the table; else zero [m]."""
        need = self._needs[name]
        return 0.0 if self._is_level(name, need) else need.bounds["z"][0]

    def _around(self, name: str, need: _Need) -> list[tuple[Float[np.ndarray, "K 2"], float]]:
        """List spots on the table around a point, the nearest first, and by how much these may be missed."""
        ends = [need.bounds.get(axis, (0.0, 1.0)) for axis in "xy"]
        if any(low != high for low, high in ends):
            return []
        table, found = np.array([self._grounding.table.x, self._grounding.table.y]).T, []
        rests, asked = self._sight.sizes[name][2] / 2, self._problem.tolerance
        low, high = need.bounds.get("z", (rests, rests))
        if low != high and not low <= rests <= high:
            return []
        for away in np.linspace(0, asked, _RING):
            spots = np.array(ends)[:, 0] + away * _ring()
            left = asked - math.hypot(away, max(low - rests, rests - high, 0.0))
            if left >= LEAST_TOLERANCE:
                found.append((spots[is_within(spots, table)], left))
        return found

    def _moved_aside(
        self,
        spots: Float[np.ndarray, "N 2"],
        inside: Bool[np.ndarray, " N"],
        here: Float[np.ndarray, "2"],
        need: _Need,
    ) -> tuple[Float[np.ndarray, "K 2"], Bool[np.ndarray, " K"]]:
        """Leave spots out where an object is already; beside a point others will do, within the tolerance."""
        aside = 1.2 * self._tolerance
        ends = (need.bounds.get(axis, (0.0, 1.0)) for axis in "xy")
        is_point = all(low == high for low, high in ends)
        if is_point and aside + self._tolerance <= self._problem.tolerance:
            spots = np.vstack([spots, spots[0] + aside * _ring()])
            inside = np.append(inside, np.ones(_RING, dtype=bool))
        return spots, inside & (np.linalg.norm(spots - here, axis=1) > aside - 1e-6)

    def _check_turns(self, name: str) -> None:
        if not self._grounding.turned or name not in understand(self._problem, self._grounding).carriers:
            raise InvalidValue(
                f"Nothing that was learned carries {name} and turns it on the way; leave its heading out."
            )

    def _has_room(
        self,
        name: str,
        need: _Need,
        spots: Float[np.ndarray, "N 2"],
        others: dict[str, Float[np.ndarray, "2"]],
    ) -> Bool[np.ndarray, " N"]:
        """Say at which spots an object stands in no other, and as far from these as is asked for."""
        good, size = np.ones(len(spots), dtype=bool), self._sight.sizes[name][:2]
        for other, spot in others.items():
            gaps = np.abs(spots - spot) - (size + self._sight.sizes[other][:2]) / 2
            apart = np.where(gaps.max(1) > 0, np.hypot(*np.maximum(gaps, 0.0).T), gaps.max(1))
            good &= apart >= LEAST_GAP
            for clause in (one for one in need.beside if one.other == other):
                if clause.word == "apart-from":
                    good &= apart >= conditions.APART + self._tolerance
                else:
                    self._tolerance = min(self._tolerance, conditions.NEXT / 2 - LEAST_GAP / 2)
                    good &= apart <= conditions.NEXT - self._tolerance + 1e-6
        return good

    def _inside(self, need: _Need) -> Float[np.ndarray, "2 2"]:
        """Return the least and greatest x and y of a goal, well inside of the table and what is asked for."""
        found = []
        for axis, edges in zip("xy", (self._grounding.table.x, self._grounding.table.y), strict=True):
            low, high = need.bounds.get(axis, edges)
            is_point = low == high
            low, high = max(low, edges[0]), min(high, edges[1])
            if low == high and not is_point:
                raise InvalidValue(f"{axis} = {low:g} m is the edge of the table; ask for some room inside.")
            if axis in need.bounds and low < high:
                room = min(self._tolerance, _ROOM * (high - low))
                self._tolerance = room
                low, high = low + room, high - room
            found.append((low, high))
        return np.array(found).T

    def _beside(
        self, name: str, need: _Need, others: dict[str, Float[np.ndarray, "2"]]
    ) -> Iterator[Float[np.ndarray, "2"]]:
        """List spots along the sides of what an object shall be next to."""
        for clause in need.beside:
            spot = others.get(clause.other, self._sight.places[clause.other][:2])
            reach = (self._sight.sizes[name] + self._sight.sizes[clause.other])[:2] / 2
            for axis, side, along in product((0, 1), (-1, 1), np.linspace(-1, 1, _RING)):
                away = np.array([along, along]) * reach
                away[axis] = side * (reach[axis] + conditions.NEXT / 2 + LEAST_GAP / 4)
                yield spot + away

    def _goal(self, name: str, spot: Float[np.ndarray, "2"]) -> tuple[float, float, float]:
        """Return a spot as a goal, as high as its object rests there or as is asked for."""
        rests = float(self._sight.sizes[name][2]) / 2
        low, high = self._needs.get(name, _Need()).bounds.get("z", (rests, rests))
        x, y = (round(float(value), 4) for value in spot)
        return (x, y, round(min(max(rests, low), high), 4))
