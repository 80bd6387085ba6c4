"""Problems: a scene of named objects, and what shall become of some of them."""

import math
import re
from collections.abc import Callable, Collection, Sequence
from itertools import permutations
from pathlib import Path
from typing import Any

import msgspec
import numpy as np

from neurosym.checks import Document, Float, as_path, check_fields, check_kind
from neurosym.errors import InvalidFile, InvalidValue, UnknownChoice
from neurosym.files import decode_json, read_json, write_json
from neurosym.operators import TOLERANCE, Length, Share, Symbol, Vector
from neurosym.world import OutcomeKind, Scene, Table

RelationGoal = tuple[str, str, str]
"""Names of the target and of the reference, and the name or symbol of the state of the pair."""
FORMER_SUFFIX = "-any-pair"
"""What operators for pairs of any kind were called with in earlier versions, whose files are still read."""


def pair_key(target: str, reference: str) -> str:
    """Return what a pair of objects, by their names, is called where their kinds are kept."""
    return f"{target} {reference}"


def _check_relation_goals(
    goals: Sequence[RelationGoal], names: Sequence[str], placed: Collection[str]
) -> None:
    """Refuse goals by relation that cannot all be met at once, as far as names of objects tell."""
    over = dict[str, str]()
    for target, reference, state in goals:
        for name in (target, reference):
            if name not in names:
                listed = ", ".join(names)
                raise InvalidValue(
                    f"There is a relation of {name}, which is not in the scene; objects: {listed}."
                )
        if target == reference:
            others = ", ".join(name for name in names if name != target) or "a second object, which lacks"
            raise InvalidValue(f"{target} cannot be {state} of itself; valid references: {others}.")
        shall = dict.fromkeys(f"{meant} {other}" for one, other, meant in goals if one == target)
        if len(shall) > 1:
            raise InvalidValue(f"{target} shall be {' and '.join(shall)}; give it one of these.")
        if target in placed:
            raise InvalidValue(
                f"{target} has a goal and a relation to {reference}; give the goal to what is to stand "
                "on the table."
            )
        over[target] = reference
    for target in over:
        chain = [target]
        while (here := over.get(chain[-1])) and here not in chain:
            chain.append(here)
        if here == target:
            said = ", ".join(f"{one} with {over[one]}" for one in chain)
            raise InvalidValue(f"The relations {said} lead round in a circle; leave one of them out.")


# Spots: places whose names say where they lie, as `spot-5500-m1200` for x = 0.55 m and y = -0.12 m.
#
# A problem has few places of its own, and plans may need others. Any problem knows a spot by its name.

SPOT = re.compile(r"spot-(m?\d{1,6})-(m?\d{1,6})")
"""What spots are called; `m` is for minus, which PDDL does not know."""
_PER_METRE = 10_000  # names count tenths of a millimetre


def spot_name(x: float, y: float) -> str:
    """Return the name of the spot that is nearest to x and y [m]."""
    return f"spot-{round(x * _PER_METRE)}-{round(y * _PER_METRE)}".replace("--", "-m")


def spot_named(name: str) -> tuple[float, float] | None:
    """Return where a spot lies [m], or None if the name is not that of a spot."""
    if (found := SPOT.fullmatch(name)) is None:
        return None
    x, y = (int(word.replace("m", "-")) / _PER_METRE for word in found.groups())
    return x, y


# Problems: a scene of named objects, and where some of them shall go


LEGAL_NAME = re.compile(r"[a-z][a-z0-9-]*")  # what PDDL, and every planner we know, takes as a name
LONGEST_NAME = 100  # so many characters a name has at most: files are called by it
NEAR_TABLE = 0.1
"""How far off the table an object may stand and still be planned for, after a push or a nudge [m]."""
ROUNDED = 1e-9
"""What binary numbers make of a sum of decimal ones, at most: 0.14 + 0.04 is no more than 0.18 [m]."""


_OFF_UNIT = 0.01  # how far from 1 the length of a quaternion may be
THIS_RUN = "this run"
"""The run that a trial is of while that goes on."""


class Trial(Document, frozen=True, omit_defaults=True, cache_hash=True):
    """What became of an object when something was done to it; see `neurosym.tasks.pasts`."""

    motion: str  #: Which motion was performed, as operators are labelled
    kind: OutcomeKind  #: How the object ended
    effect: Vector  #: Its displacement at the end of the rise, as motions are turned with it [m]
    resting_effect: Vector  #: And once everything was put down [m]
    lay: tuple[float, float, float, float]  #: Its orientation before, as a quaternion (x, y, z, w)
    crowded: bool = False  #: Whether other objects were in the way
    forgotten: bool = False  #: Whether it counts only against hoping for what it shows to fail
    run: str = ""  #: The record of the run that it was seen in, or `THIS_RUN`; empty if it was tried

    def __post_init__(self) -> None:
        super().__post_init__()
        if not abs((length := math.hypot(*self.lay)) - 1) <= _OFF_UNIT:
            raise InvalidValue(f"Trial.lay has the length {length:g}; valid: a quaternion of length 1.")


class SceneObject(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One object of a scene."""

    name: str  #: What plans call it, a legal PDDL name like `item-01`
    category: Symbol  #: Its object symbol, like "10"
    features: tuple[Length, ...]  #: What it is; see `Scene`
    position: Vector  #: Its centre in the world frame [m]
    #: Its orientation in the world frame, as a quaternion (x, y, z, w)
    orientation: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 1.0)
    #: What only the world knows of it, and nothing that plans does; see `Scene`
    unseen: tuple[float, ...] | msgspec.UnsetType = msgspec.UNSET
    #: What it was seen to do, however it lay; never read from files of scenes
    past: tuple[Trial, ...] | msgspec.UnsetType = msgspec.UNSET

    def __post_init__(self) -> None:
        check_fields(self)


class Problem(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """A scene at rest, and goals for some of its objects: where they shall be, or how they shall be related.

    Files leave out what is empty, but always say the tolerance and the provenance.
    """

    name: str  #: What the problem is called, a legal PDDL name
    objects: tuple[SceneObject, ...]  #: The objects, all at rest on the table
    goals: dict[str, Vector]  #: Where the centre of an object shall come to be [m], by the object's name
    tolerance: Length = msgspec.field(default_factory=lambda: TOLERANCE)  #: How near it must come [m]
    #: How the problem came about, by a seed, or "by hand"
    provenance: str = msgspec.field(default_factory=lambda: "by hand")
    #: Where objects may be carried to, x and y of each place [m], by its name; drawn if not given
    places: dict[str, tuple[Length, Length]] = {}
    #: Which object shall stand to which other one in which state, as target, reference, state
    relations: tuple[RelationGoal, ...] = ()
    #: Kinds of the pairs of objects, by the names of target and reference with a blank between
    pairs: dict[str, Symbol] = {}
    #: How surely operators are foreseen to keep their promises with a pair, by the same names of the pair,
    #: and then of the operator; where that is not said, as surely as with its kind
    foreseen: dict[str, dict[str, Share]] = {}
    #: What shall hold, as people say it (see `neurosym.tasks.conditions`); goals and relations are chosen so
    conditions: tuple[str, ...] = ()
    #: How near conditions are to be met, where goals that were chosen for them are to be met nearer [m]
    asked_within: Length | None = None
    #: Names of the objects that shall stand upright; chosen so
    upright: tuple[str, ...] = ()
    #: How objects shall be turned at their goals, modulo half a turn [degrees], by name; chosen so
    headings: dict[str, Length] = {}
    #: Names of the objects that touch, where somebody saw that; else it is told by geometry
    touching: tuple[tuple[str, str], ...] | None = None

    def __post_init__(self) -> None:
        check_fields(self)
        names = self.object_names
        check_names((self.name, *names))
        if not self.objects:
            raise InvalidValue("A scene needs one object or more.")
        first, *others = self.objects
        for item in others:
            if (found := len(item.features)) != (wanted := len(first.features)):
                raise InvalidValue(
                    f"{item.name} has {found} features, {first.name} has {wanted}; give all as many."
                )
        for name in names:
            if names.count(name) > 1:
                raise InvalidValue(f"Two objects are called {name}; give each a name of its own.")
        for name in self.goals:
            if name not in names:
                raise InvalidValue(
                    f"There is a goal for {name}, which is not in the scene; objects: {', '.join(names)}."
                )
        if not 0 < self.tolerance < math.inf:
            raise InvalidValue(f"The tolerance is {self.tolerance} m; it must be greater than 0.")
        _check_relation_goals(self.relations, names, self.goals)

    @property
    def object_names(self) -> tuple[str, ...]:
        """Names of the M objects, in the scene's order."""
        return tuple(item.name for item in self.objects)

    def object_named(self, name: str) -> SceneObject:
        """Return the object of that name; `UnknownChoice` if there is none."""
        if found := next((item for item in self.objects if item.name == name), None):
            return found
        raise UnknownChoice("object", str(name), self.object_names)

    def place_named(self, name: str) -> tuple[float, float]:
        """Return where a place of the problem or a spot lies [m]; `UnknownChoice` if there is none."""
        if not name:
            raise InvalidValue(
                f"What carries an object needs a place to carry it to; valid: {', '.join(self.places)}."
            )
        if found := self.places.get(name) or spot_named(name):
            return found
        raise UnknownChoice("place", name, (*self.places, "spots such as spot-5500-m1200"))

    def within(self, tolerance: float | None) -> "Problem":
        """Return the problem with another tolerance [m], or as it is if that is None."""
        if tolerance is None:
            return self
        return msgspec.structs.replace(self, tolerance=tolerance, asked_within=None)

    def only(self, name: str) -> "Problem":
        """Return the problem of one object with a goal, without the others."""
        goals, objects = {name: self.goals[name]}, (self.object_named(name),)
        return msgspec.structs.replace(self, objects=objects, goals=goals, conditions=())

    def scene(self) -> Scene:
        """Return the scene that the problem starts from."""
        rows = ((one.features, one.position, one.orientation) for one in self.objects)
        unseen = [() if one.unseen is msgspec.UNSET else one.unseen for one in self.objects]
        columns = [np.array(column, dtype=float) for column in zip(*rows, strict=True)]
        known = np.zeros((len(unseen), max(map(len, unseen), default=0)))
        for row, values in zip(known, unseen, strict=True):
            row[: len(values)] = values
        return Scene(*columns, unseen=known)

    def goal_positions(self) -> Float[np.ndarray, "M 3"]:
        """Return where each object shall come to be [m], NaN for an object without a goal."""
        nowhere = (math.nan, math.nan, math.nan)
        return np.array([self.goals.get(name, nowhere) for name in self.object_names], dtype=float)

    def room(self, table: Table, *, rounded: float = ROUNDED) -> Float[np.ndarray, "2 M 2"]:
        """Return the least and greatest x and y that each object's centre may have in a plan [m].

        That is the table; for an object that stands a little off it, as far out as it stands.
        """
        low, high = np.array([table.x, table.y]).T
        spots = self.scene().positions[:, :2]
        near = np.all((spots >= low - NEAR_TABLE) & (spots <= high + NEAR_TABLE), axis=1, keepdims=True)
        lows, highs = np.minimum(low, spots), np.maximum(high, spots)
        return np.stack([np.where(near, lows, low) - rounded, np.where(near, highs, high) + rounded])

    @property
    def unmet(self) -> tuple[str, ...]:
        """Names of the objects that do not stand at their goals."""
        misses = self.distances(self.scene().positions)
        return tuple(name for name, miss in misses.items() if miss > self.tolerance)

    def distances(self, positions: Float[np.ndarray, "M 3"]) -> dict[str, float]:
        """Measure how far each object with a goal is from it, its centre at one of the positions [m]."""
        where = dict(zip(self.object_names, positions, strict=True))
        return {name: math.dist(where[name], goal) for name, goal in self.goals.items()}

    def is_met(self, positions: Float[np.ndarray, "M 3"]) -> bool:
        """Say whether every object with a goal is within the tolerance of it, with these centres [m]."""
        return all(distance <= self.tolerance for distance in self.distances(positions).values())

    def save(self, path: Path) -> None:
        """Write the problem to a file, NAME.scene.json by custom, without what its objects did before."""
        write_json(as_path(path), self._without_pasts())

    def _without_pasts(self) -> "Problem":
        if all(item.past is msgspec.UNSET for item in self.objects):
            return self
        objects = tuple(msgspec.structs.replace(item, past=msgspec.UNSET) for item in self.objects)
        return msgspec.structs.replace(self, objects=objects)

    @classmethod
    def load(cls, path: Path, change: Callable[[dict[str, Any]], dict[str, Any]] | None = None) -> "Problem":
        """Read a problem; `InvalidFile` if the file is no problem, or one that cannot be.

        What else people write in a file may be changed to what a problem has, before it is checked.
        """
        if change is None:
            problem = read_json(as_path(path), cls)
        else:
            changed = change(read_json(as_path(path), dict[str, Any]))
            problem = decode_json(as_path(path), msgspec.json.encode(changed), cls)
        problem = problem._without_pasts()
        touching, names = [pair_key(*pair) for pair in problem.touching or ()], problem.object_names
        known = {pair_key(*pair) for pair in permutations(names, 2)}
        for what, told in (("pairs", problem.pairs), ("foreseen", problem.foreseen), ("touching", touching)):
            if wrong := next((key for key in told if key not in known), None):
                valid = f"the names of two objects with a blank between, of {', '.join(names)}"
                raise InvalidFile(path, f"{what} has an entry for {wrong!r}; valid: {valid}")
        foreseen = {
            pair: {name.removesuffix(FORMER_SUFFIX): share for name, share in shares.items()}
            for pair, shares in problem.foreseen.items()
        }
        return msgspec.structs.replace(problem, foreseen=foreseen) if foreseen else problem


def goal_heights(problem: Problem, lift_height: float) -> tuple[float, float]:
    """Return the least and greatest height that a goal can have, above a table at height 0 [m]."""
    return 0.0, max(item.position[2] for item in problem.objects) + 2 * lift_height


def check_goals(problem: Problem, table: Table, z_range: tuple[float, float]) -> None:
    """Raise `InvalidValue` unless there are goals, and each on the table and at a possible height [m]."""
    if not (problem.goals or problem.relations or problem.conditions):
        raise InvalidValue(f"The problem {problem.name} has no goal; give at least one object a goal.")
    bounds = {"x": table.x, "y": table.y, "z": z_range}
    for name, goal in problem.goals.items():
        for (axis, (low, high)), value in zip(bounds.items(), goal, strict=True):
            if not low <= value <= high:
                valid = ", ".join(
                    f"{each} {least:g} to {most:g}" if math.isfinite(most) else f"{each} any"
                    for each, (least, most) in bounds.items()
                )
                raise InvalidValue(
                    f"The goal of {name} has {axis} = {value:g} m, out of reach; valid: {valid} [m]."
                )


def check_on_table(item: SceneObject, table: Table, *, off: float = 0.0) -> None:
    """Raise `InvalidValue` unless an object stands on the table, or no farther off it than so much [m]."""
    (x_low, x_high), (y_low, y_high) = table.x, table.y
    x, y, _ = item.position
    if not (x_low - off <= x <= x_high + off and y_low - off <= y <= y_high + off):
        raise InvalidValue(
            f"{item.name} stands at x = {x:g}, y = {y:g} m, off the table; valid: x {x_low:g} to "
            f"{x_high:g}, y {y_low:g} to {y_high:g} m."
        )


def check_names(names: tuple[str, ...]) -> None:
    """Raise `InvalidValue` unless problems and objects can have these names."""
    for name in names:
        check_kind("name", name, str, "text")
        if len(name) > LONGEST_NAME:
            raise InvalidValue(
                f"The name {name[:20]}... has {len(name)} characters; valid: at most {LONGEST_NAME}."
            )
        if not LEGAL_NAME.fullmatch(name):
            raise InvalidValue(
                f"{name!r} is not a legal name; valid: a lower-case letter, then a-z, 0-9 and hyphens."
            )
