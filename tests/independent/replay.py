"""The replay of a plan, a second time: from docs/pddl.md alone, on raw JSON, in exact decimal numbers.

Nothing of neurosym is imported here, and no numpy, so that both replays do not share a mistake.
"""

import itertools
import json
from collections.abc import Iterable
from dataclasses import dataclass, field
from decimal import Decimal
from fractions import Fraction
from typing import Any

Json = dict[str, Any]
Point = tuple[Decimal, Decimal, Decimal]
Step = tuple[str, str]

PUT_DOWN = "put-down-"
SLACK = Decimal("1e-9")
"""What binary numbers may make of a decimal one [m]."""
NEAR_TABLE = Decimal("0.1")
"""How far off the table an object may stand that is still planned for [m]."""
LEAST_TRIALS = 5
LEAST_SHARE = Decimal("0.1")


def read_text(text: str) -> Json:
    return json.loads(text, parse_float=Decimal, parse_int=Decimal)


def promise_of(operator: Json) -> Json | None:
    """Return the outcome that an operator promises: the one it is told, or the most frequent good one."""
    told = operator.get("promised")
    kinds = (told,) if told else ("resting", "held")
    return next((mode for mode in operator["modes"] if mode["kind"] in kinds), None)


def lifts(operator: Json) -> bool:
    promise = promise_of(operator)
    return promise is not None and promise["kind"] == "held"


def displacement(operator: Json) -> Point:
    """Return how an operator moves its object, up to the end of the rise if it lifts it [m]."""
    promise = promise_of(operator)
    assert promise is not None
    if promise["kind"] == "held":
        x, y, z = promise["effect"]
        return x, y, z
    return settled(operator)


def settled(operator: Json) -> Point:
    """Return how far from its start an object comes to rest, at its own height [m]."""
    promise = promise_of(operator)
    assert promise is not None
    x, y, _ = promise["resting_effect"]
    return x, y, Decimal(0)


def domain_operators(grounding: Json) -> list[Json]:
    """List the operators that the PDDL domain has, and does not leave out."""
    cell, listed = grounding["cell"], grounding["operators"]["operators"]
    worthy = [one for one in listed if _is_worth_having(one, cell)]
    if grounding["format"] == "neurosym-grounding-1":
        return worthy
    by_chance = sorted(worthy, key=lambda one: (-_chance(one), one["name"]))
    kept: list[Json] = []
    for one in by_chance:
        if not any(_do_the_same(one, other, cell / 2) for other in kept):
            kept.append(one)
    return [one for one in worthy if one in kept]


def _chance(operator: Json) -> Fraction:
    promise = promise_of(operator)
    kept = promise["near_mean"] if promise else 0
    return Fraction(kept + 1) / Fraction(operator["trials"] + 2)


def _do_the_same(one: Json, other: Json, apart: Decimal) -> bool:
    if one["category"] != other["category"] or lifts(one) != lifts(other):
        return False
    pairs = [*zip(displacement(one), displacement(other), strict=True)]
    pairs += zip(settled(one), settled(other), strict=True) if lifts(one) else ()
    return all(abs(a - b) < apart for a, b in pairs)


def _is_worth_having(operator: Json, cell: Decimal) -> bool:
    promise = promise_of(operator)
    if operator["trials"] < LEAST_TRIALS or promise is None:
        return False
    if promise["near_mean"] < LEAST_SHARE * operator["trials"]:
        return False
    moved = displacement(operator)
    if all(2 * abs(part) < cell for part in moved):
        return False
    if operator.get("rehearsals"):
        return True  # whether it scatters more than it moves is for each object to say
    scatter = promise["spread" if promise["kind"] == "held" else "resting_spread"]
    return sum(part * part for part in scatter) <= sum(part * part for part in moved)


@dataclass
class Tabletop:
    """What the replay knows of a scene: where everything is, and what the hand holds."""

    grounding: Json  # the raw `grounding.json`
    scene: Json  # the raw scene file of a problem
    places: dict[str, Point] = field(default_factory=dict)  # where the centre of each object is [m]
    held: Step | None = None  # the operator that lifted what is in the hand, and that object
    primitives: int = 0  # how many were done

    def __post_init__(self) -> None:
        self.operators = {one["name"]: one for one in self.grounding["operators"]["operators"]}
        self.items = {item["name"]: item for item in self.scene["objects"]}
        self.places = {name: tuple(item["position"]) for name, item in self.items.items()}
        pairs = itertools.permutations(self.items, 2)
        self.in_each_other = {pair for pair in pairs if self.overlap(*pair)}  # of them nothing is asked

    def do(self, step: Step) -> str:
        """Do a step and return what is wrong with it; nothing if it is possible."""
        words, name = step
        puts_down = words.startswith(PUT_DOWN)
        operator = self.operators.get(words.removeprefix(PUT_DOWN))
        if operator is None or name not in self.items:
            return f"there is no {words} or no {name}"
        if operator["category"] != self.items[name]["category"]:
            return f"{words} is not for objects like {name}"
        if promise_of(operator) is None:
            return f"{words} promises nothing"
        if puts_down and self.held != (operator["name"], name):
            return f"{words} with {self.held} in the hand"
        if not puts_down and self.held is not None:
            return f"{words} with a full hand"
        self.places[name] = self._after(operator, name, puts_down)
        self.held = (operator["name"], name) if lifts(operator) and not puts_down else None
        self.primitives += not puts_down
        return self._wrong_place(name)

    def missed(self) -> str:
        """Say which goals are farther away than allowed; nothing if none is."""
        allowed = self.scene["tolerance"] + SLACK
        misses = {name: distance(self.places[name], goal) for name, goal in self.scene["goals"].items()}
        far = [f"{name} {1000 * miss:.3f} mm" for name, miss in misses.items() if miss > allowed]
        return f"missed: {', '.join(far)}" if far else ""

    def _after(self, operator: Json, name: str, puts_down: bool) -> Point:
        here, by = self.places[name], displacement(operator)
        if puts_down:  # back to where the lift began, and from there to where it came to rest
            by = tuple(end - up for end, up in zip(settled(operator), by, strict=True))
        x, y, z = (old + new for old, new in zip(here, by, strict=True))
        return x, y, z

    def _wrong_place(self, name: str) -> str:
        spot = self.places[name]
        for axis, (low, high) in zip((0, 1), self.room(name), strict=True):
            if not low - SLACK <= spot[axis] <= high + SLACK:
                return f"{name} leaves the table"
        if self.held is not None:
            return ""
        for other in self.items:
            if other != name and (name, other) not in self.in_each_other and self.overlap(name, other):
                return f"{name} is put into {other}"
        return ""

    def room(self, name: str) -> tuple[tuple[Decimal, Decimal], tuple[Decimal, Decimal]]:
        """Return from where to where the table reaches for an object, along x and y [m]."""
        start = self.items[name]["position"]
        table = [self.grounding["table"][axis] for axis in "xy"]
        beyond = [max(low - at, at - high, Decimal(0)) for (low, high), at in zip(table, start, strict=False)]
        if max(beyond) > NEAR_TABLE:
            return tuple((low, high) for low, high in table)
        return tuple((min(low, at), max(high, at)) for (low, high), at in zip(table, start, strict=False))

    def overlap(self, one: str, other: str) -> bool:
        """Say whether the footprints of two objects, boxes along the axes, share more than an edge."""
        sizes = [self.items[name]["features"] for name in (one, other)]
        here, there = self.places[one], self.places[other]
        return all(
            2 * (abs(here[axis] - there[axis]) + SLACK) < sizes[0][axis] + sizes[1][axis] for axis in (0, 1)
        )


def replay(grounding: Json, scene: Json, steps: Iterable[Step]) -> tuple[str, Tabletop]:
    """Replay a plan.

    Returns:
        What is wrong with it, nothing if it is valid; and how everything is where the replay stopped.
    """
    top = Tabletop(grounding, scene)
    for number, step in enumerate(steps, start=1):
        if wrong := top.do(step):
            return f"step {number}: {wrong}", top
    return top.missed(), top


def distance(one: Iterable[Decimal], other: Iterable[Decimal]) -> Decimal:
    return sum(((a - b) ** 2 for a, b in zip(one, other, strict=True)), Decimal(0)).sqrt()
