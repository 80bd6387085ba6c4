"""Conditions: what shall hold of objects, as people say it, and whether it does.

A condition is a line like one of these; `or` parts options, and `and` parts what belongs to one option:

    item-01 x=0.35..0.6 y=..0     within bounds [m]; a single number is met within the tolerance
    item-01 at 0.6,0.1            near a point
    item-01 heading=30            turned so [degrees], within 15, modulo half a turn; beside the others
    all 10 within-reach           every object of a category, by its bits or its name
    2 of 10 y=0..                 so many of a category, or of some objects: 2 of item-01,item-02
    item-01 next-to item-02       or apart-from, on, under, not-on, or a state that the domain knows
"""

import math
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.grounding import Grounding
from neurosym.pair_operators import RelationOperators, extent
from neurosym.problems import Problem
from neurosym.tasks.lying import side_of
from neurosym.tasks.supports import Borne, bearers_of
from neurosym.world import Table, heading_to

NEXT, APART = 0.05, 0.10
"""Footprints are next to each other if they are no farther apart than the one, and apart from each other if
they are as far apart as the other [m]."""
BESIDE = ("next-to", "apart-from")
OVER = ("on", "under", "not-on")
FORMS = (
    "x=LOW..HIGH, at X,Y or X,Y,Z, heading=DEGREES, upright, within-reach, next-to, apart-from, on, under, "
    "not-on, or a state of the domain"
)
_PLAIN = {"beside": "next-to", "apart-from": "apart-from", "lies-under": "under", "props-up": "under"}
"""What people call learned states in which nothing is borne, by what their names begin with."""
_AXES = "xyz"
_OVERLAP = 0.005  # of the boxes of two objects that count as next to each other [m]
_HANGING = 0.1  # what is higher above the table, and is borne by nothing, hangs on the hand [m]
_HEADED = math.radians(15)  # how near an object must come to a heading [rad]
_TERM = re.compile(r"([xyz]|heading)=(.*)")

Bounds = Mapping[str, tuple[float, float]]
"""Least and greatest value on axes; the same twice where it is to be met within the tolerance [m]."""


@dataclass(frozen=True)
class Clause:
    """What shall hold of so many of some objects."""

    names: tuple[str, ...]  # the objects that it may hold of
    count: int  # of how many it shall
    bounds: Bounds = field(default_factory=dict)  # where they shall be
    word: str = ""  # how they shall be to another object, or nothing
    other: str = ""  # name of that

    def __str__(self) -> str:
        who = self.names[0] if len(self.names) == 1 else f"{self.count} of {','.join(self.names)}"
        ends = (f"{low:g}" if low == high else f"{low:g}..{high:g}" for low, high in self.bounds.values())
        where = " ".join(f"{axis}={said}" for axis, said in zip(self.bounds, ends, strict=True))
        return f"{who} {where or f'{self.word} {self.other}'.strip()}".replace("-inf", "").replace("inf", "")


Option = tuple[Clause, ...]
"""What shall all hold."""


def options_of(text: str, problem: Problem, grounding: Grounding) -> tuple[Option, ...]:
    """Read a condition on the objects of a problem: one of the options shall hold.

    Raises:
        InvalidValue: If it cannot be read, or never hold; the message says what would be valid.
        UnknownChoice: If it names an object or a category that there is not.
    """
    alternatives = (option.split(" and ") for option in text.split(" or "))
    return tuple(tuple(_clause(part, problem, grounding) for part in option) for option in alternatives)


def _clause(text: str, problem: Problem, grounding: Grounding) -> Clause:
    words = text.split()
    names, count, words = _who(words, text, problem, grounding)
    if not words:
        raise InvalidValue(f"The condition {text!r} says nothing of {', '.join(names)}; valid: {FORMS}.")
    if words == ["upright"]:
        return Clause(names, count, word="upright")
    if words == ["within-reach"]:
        return Clause(names, count, _over(grounding.table))
    if words[0] == "at" and len(words) == 2:
        return Clause(names, count, _bounds(_terms_at(words[1], text), text, grounding.table))
    if all(_TERM.fullmatch(word) for word in words):
        return Clause(names, count, _bounds([*map(str, words)], text, grounding.table))
    if len(words) != 2:
        raise InvalidValue(f"The condition {text!r} cannot be read; valid: {FORMS}.")
    word, other = words
    problem.object_named(other)
    names = tuple(name for name in names if name != other)
    if not names:
        raise InvalidValue(f"{other} cannot be {word} itself; name another object.")
    if word not in BESIDE:
        if grounding.relations is None:
            raise InvalidValue(
                f"The condition {text!r} is one of relations, and this domain has learned none; valid: "
                f"bounds, {', '.join(BESIDE)}."
            )
        word = word if word in OVER else _meant(word, grounding.relations)
    return Clause(names, min(count, len(names)), word=word, other=other)


def _meant(word: str, relations: RelationOperators) -> str:
    """Return a state by its name where something is borne in it, or else what people call it."""
    state = relations.state_meant(word)
    plain = next((plain for begins, plain in _PLAIN.items() if state.name.startswith(begins)), "")
    if not (state.bears or plain):
        raise InvalidValue(f"Nothing brings pairs to {state.name}; valid: {', '.join((*BESIDE, *OVER))}.")
    return state.name if state.bears else plain


def _who(
    words: Sequence[str], text: str, problem: Problem, grounding: Grounding
) -> tuple[tuple[str, ...], int, list[str]]:
    """Return which objects are meant, how many of them, and the words behind that."""
    if words[:1] == ["all"] and len(words) > 1:
        names = _named(words[1], problem, grounding)
        return names, len(names), [*words[2:]]
    if len(words) > 2 and words[1] == "of" and words[0].isdigit():
        names, count = _named(words[2], problem, grounding), int(words[0])
        if not 1 <= count <= len(names):
            raise InvalidValue(
                f"{text!r} asks for {count} of {len(names)} objects; valid: 1 to {len(names)}."
            )
        return names, count, [*words[3:]]
    if not words:
        raise InvalidValue(f"There is an empty condition; valid: an object, and {FORMS}.")
    return (problem.object_named(words[0]).name,), 1, [*words[1:]]


def _named(said: str, problem: Problem, grounding: Grounding) -> tuple[str, ...]:
    """Return the objects of a category, by its bits or its name, or those that are named."""
    if known := next((one for one in grounding.objects.categories if said in (one.symbol, one.name)), None):
        found = tuple(item.name for item in problem.objects if item.category == known.symbol)
        if not found:
            known_here = ", ".join(sorted({item.category for item in problem.objects}))
            raise InvalidValue(f"No object of {problem.name} is of the category {said}; valid: {known_here}.")
        return found
    if set(said.split(",")) <= {*problem.object_names}:
        return tuple(dict.fromkeys(said.split(",")))
    valid = [*(one.symbol for one in grounding.objects.categories), *problem.object_names]
    raise UnknownChoice("category or object", said, valid)


def _over(table: Table) -> Bounds:
    return {"x": table.x, "y": table.y}


def _terms_at(said: str, text: str) -> list[str]:
    """Return a point as a term for each axis."""
    values = said.split(",")
    if not 2 <= len(values) <= 3:
        raise InvalidValue(f"The condition {text!r} cannot be read; write a point as at 0.6,0.1.")
    return [f"{axis}={value}" for axis, value in zip(_AXES, values, strict=False)]


def _bounds(terms: Sequence[str], text: str, table: Table) -> Bounds:
    found = dict[str, tuple[float, float]]()
    for term in terms:
        axis, _, said = term.partition("=")
        low, dots, high = said.partition("..")
        try:
            least = float(low) if low or not dots else -math.inf
            most = (float(high) if high else math.inf) if dots else least
        except ValueError:
            raise InvalidValue(
                f"The condition {text!r} cannot be read; write x=0.4, or x=0.4..0.6."
            ) from None
        if axis in found:
            raise InvalidValue(f"{text!r} says {axis} twice; say it once.")
        if dots and not (low or high):
            raise InvalidValue(f"{text!r} has no bound along {axis}; valid: {axis}=0.4.., ..0.6 or 0.4..0.6.")
        if math.isnan(least + most) or least == math.inf or most == -math.inf:
            raise InvalidValue(f"{text!r} has no number along {axis}; valid: {axis}=0.4, or {axis}=0.4..0.6.")
        if not least <= most or (dots and least == most):
            raise InvalidValue(f"{text!r} leaves no room along {axis}; give the lower bound first.")
        if axis == "heading" and (dots or not abs(least) <= 360):
            raise InvalidValue(f"{text!r} asks for no heading; valid: a number of degrees, as heading=30.")
        found[axis] = (least, most)
        low_edge, high_edge = _over(table).get(axis, (-math.inf, math.inf))
        if least > high_edge or most < low_edge:
            raise InvalidValue(f"{text!r} lies off the table; valid: {axis} {low_edge:g} to {high_edge:g} m.")
    return found


class Sight:
    """Objects as they stand now, and what holds of them.

    Attributes:
        problem: The problem.
        sizes: The sizes of each object along the axes of the world, by its name [m].
        supports: What bears each object that another one bears.
    """

    def __init__(self, problem: Problem, grounding: Grounding):
        scene, self.problem = problem.scene(), problem
        self.sizes = {name: extent(scene, row) for row, name in enumerate(problem.object_names)}
        self.places = {item.name: np.array(item.position) for item in problem.objects}
        self.lies = {item.name: np.array(item.orientation) for item in problem.objects}
        relations = grounding.relations
        self.supports: Mapping[str, Borne] = bearers_of(problem, relations) if relations else {}

    def holds(self, clause: Clause) -> bool:
        """Say whether it holds of enough objects."""
        return sum(self.holds_of(name, clause) for name in clause.names) >= clause.count

    def holds_of(self, name: str, clause: Clause) -> bool:
        """Say whether it holds of an object."""
        if clause.bounds:
            asked = {axis: ends for axis, ends in clause.bounds.items() if axis != "heading"}
            is_headed = "heading" not in clause.bounds or self.is_headed(name, clause.bounds["heading"][0])
            lowest = self.places[name][2] - self.sizes[name][2] / 2
            is_down = "z" in asked or name in self.supports or lowest < _HANGING
            return is_headed and is_down and self._is_within(self.places[name], asked)
        if clause.word == "upright":
            return not side_of(self.lies[name], turned=False)
        if clause.word in BESIDE:
            gap = self.gap(name, clause.other)
            return gap >= APART if clause.word == "apart-from" else self._is_beside(name, clause.other, gap)
        if clause.word == "under":
            return self._bears(name, clause.other)
        is_on = self._bears(clause.other, name)
        if clause.word == "not-on":
            return not is_on
        return is_on and clause.word in ("on", self.supports[name].state.name)

    def is_headed(self, name: str, wanted: float) -> bool:
        """Say whether an object is turned as is asked for [degrees]."""
        return abs(heading_to(self.lies[name], math.radians(wanted))) <= _HEADED

    def _is_within(self, spot: np.ndarray, bounds: Bounds) -> bool:
        wanted = {axis: spot[_AXES.index(axis)] for axis in bounds}
        points = [axis for axis, (low, high) in bounds.items() if low == high]
        off = math.hypot(*(wanted[axis] - bounds[axis][0] for axis in points))
        inside = (bounds[axis][0] <= wanted[axis] <= bounds[axis][1] for axis in wanted if axis not in points)
        return off <= (self.problem.asked_within or self.problem.tolerance) and all(inside)

    def gap(self, name: str, other: str, spot: np.ndarray | None = None) -> float:
        """Return how far footprints are apart, negative if they overlap, with the first at a spot [m]."""
        away = np.abs((self.places[name] if spot is None else spot) - self.places[other])[:2]
        gaps = away - (self.sizes[name] + self.sizes[other])[:2] / 2
        return float(np.hypot(*np.maximum(gaps, 0.0)) if gaps.max() > 0 else gaps.max())

    def _is_beside(self, name: str, other: str, gap: float) -> bool:
        apart = abs(self.places[name][2] - self.places[other][2])
        is_level = apart < (self.sizes[name] + self.sizes[other])[2] / 2
        return (
            -_OVERLAP <= gap <= NEXT and is_level and not self._bears(name, other) | self._bears(other, name)
        )

    def _bears(self, name: str, other: str) -> bool:
        """Say whether an object bears another one itself."""
        return other in self.supports and self.supports[other].by == name


def unmet_conditions(problem: Problem, grounding: Grounding) -> Iterator[str]:
    """List the conditions that do not hold as the objects of a problem stand now."""
    sight = Sight(problem, grounding) if problem.conditions else None
    for text in problem.conditions:
        options = options_of(text, problem, grounding)
        if sight and not any(all(map(sight.holds, option)) for option in options):
            yield text


# What people write in a scene in place of a point


def conditions_in(goals: object) -> tuple[dict[str, object], tuple[str, ...]]:
    """Return the goals of a scene that are points, and what else stands there, as conditions.

    An entry may leave out coordinates, as `[0.7, null, 0.025]`, or give bounds, as `{"x": [0.35, 0.6]}`. A
    list of goals asks for one of these.

    Raises:
        InvalidValue: If an entry is none of that.
    """
    if isinstance(goals, list):
        options = [" and ".join(_said(name, goal) for name, goal in _entries(one)) for one in goals]
        return {}, (" or ".join(options),)
    points, others = dict[str, object](), list[str]()
    for name, goal in _entries(goals):
        if isinstance(goal, dict) or (isinstance(goal, list) and (None in goal or len(goal) == 7)):
            others.append(_said(name, goal))
        else:
            points[name] = goal
    return points, tuple(others)


def _entries(goals: object) -> list[tuple[str, object]]:
    if not isinstance(goals, dict):
        raise InvalidValue(f"goals has {goals!r}; valid: an object of goals by name, or a list of such.")
    return [*goals.items()]


def _said(name: str, goal: object) -> str:
    """Write the goal of an object as a condition."""
    if isinstance(goal, list) and len(goal) == 7:
        goal = dict(zip(_AXES, goal[:3], strict=True)) | {"heading": _degrees(goal[3:])}
    if isinstance(goal, list) and len(goal) == 3:
        goal = dict(zip(_AXES, goal, strict=True))
    terms = []
    for axis, value in goal.items() if isinstance(goal, dict) else ():
        if isinstance(value, list) and len(value) == 2:
            low, high = ("" if one is None else one for one in value)
            terms.append(f"{axis}={low}..{high}")
        elif value is not None:
            terms.append(f"{axis}={value}")
    if not terms:
        raise InvalidValue(
            f'The goal of {name} is {goal!r}; valid: [x, y, z], null for any, or {{"x": [0.35, 0.6]}}.'
        )
    return f"{name} {' '.join(terms)}"


def _degrees(quaternion: Sequence[object]) -> float:
    """Return the heading that an orientation has [degrees], if it is one about the vertical."""
    if not all(isinstance(part, int | float) for part in quaternion):
        raise InvalidValue(
            f"A goal has the orientation {[*quaternion]}; valid: a quaternion of four numbers."
        )
    x, y, z, w = (float(str(part)) for part in quaternion)
    if max(abs(x), abs(y)) > 1e-3 or not abs(math.hypot(z, w) - 1) <= 0.01:
        raise InvalidValue(
            f"A goal has the orientation {[*quaternion]}, which is not upright; valid: as [0, 0, 0.26, 0.97]."
        )
    return round(math.degrees(2 * math.atan2(z, w)), 1)


def as_conditions(goals: Mapping[str, Any], relations: Iterable[Sequence[str]]) -> list[str]:
    """Write points and relations as conditions."""
    points = [f"{name} at {','.join(map(str, point))}" for name, point in goals.items()]
    return [*points, *(f"{target} {state} {reference}" for target, reference, state in relations)]
