"""Problems: a scene of named objects, and what shall become of some of them."""

import math
import re
from collections.abc import Collection, Iterable, Sequence
from pathlib import Path

import msgspec
import numpy as np

from neurosym.checks import Float, as_path, check_fields, check_kind
from neurosym.errors import InvalidFile, InvalidValue, UnknownChoice
from neurosym.files import read_json, write_json
from neurosym.operators import TOLERANCE, Length, Share, Symbol, Vector
from neurosym.world import Scene, Table

# Goals by relation: which object shall stand to which other one in which state of pairs

RelationGoal = tuple[str, str, str]
"""Names of the target and of the reference, and the name or symbol of the state of the pair."""

FORMER_SUFFIX = "-any-pair"
"""What operators for pairs of any kind were called with in earlier versions, whose files are still read."""


def pair_key(target: str, reference: str) -> str:
    """Return what a pair of objects is called where their kinds are kept.

    Args:
        target: Name of the target.
        reference: Name of the reference.
    """
    return f"{target} {reference}"


def check_pair_keys(what: str, keys: Iterable[str], names: Sequence[str]) -> None:
    """Raise `InvalidValue` unless what is told of pairs is told of pairs of objects that there are.

    Args:
        what: What is told.
        keys: What the pairs are called there, as `pair_key` calls them.
        names: Names of the objects.
    """
    for key in keys:
        pair = key.split(" ")
        if len(pair) != 2 or pair[0] == pair[1] or not set(pair) <= set(names):
            raise InvalidValue(
                f"{what} has an entry for {key!r}; valid: the names of two objects with a blank between, of "
                f"{', '.join(names)}."
            )


def check_relation_goals(
    goals: Sequence[RelationGoal], names: Sequence[str], placed: Collection[str]
) -> None:
    """Raise `InvalidValue` unless goals by relation can all be met at once, as far as names tell.

    Args:
        goals: The goals.
        names: Names of the objects.
        placed: Names of the objects that have a goal on the table or above it.
    """
    listed = ", ".join(names)
    over, states = dict[str, str](), dict[str, str]()
    for target, reference, state in goals:
        for name in (target, reference):
            if name not in names:
                raise InvalidValue(
                    f"There is a relation of {name}, which is not in the scene; objects: {listed}."
                )
        if target == reference:
            others = ", ".join(name for name in names if name != target) or "a second object, which lacks"
            raise InvalidValue(f"{target} cannot be {state} of itself; valid references: {others}.")
        if over.setdefault(target, reference) != reference:
            raise InvalidValue(
                f"{target} shall be with {over[target]} and with {reference}; give it one reference."
            )
        if states.setdefault(target, state) != state:
            raise InvalidValue(
                f"{target} shall be {states[target]} and {state} {reference}; a pair is in one state at a "
                "time, so give it one."
            )
        if target in placed:
            raise InvalidValue(
                f"{target} has a goal and a relation to {reference}; give the goal to what is to stand "
                "on the table."
            )
    for target in over:
        _check_chain(target, over)


def _check_chain(target: str, over: dict[str, str]) -> None:
    """Refuse relations that lead from an object back to it."""
    chain, here = [target], over.get(target)
    while here is not None and here not in chain:
        chain.append(here)
        here = over.get(here)
    if here == target:
        said = ", ".join(f"{one} with {over[one]}" for one in chain)
        raise InvalidValue(f"The relations {said} lead round in a circle; leave one of them out.")


# Spots: places whose names say where they lie, as `spot-5500-m1200` for x = 0.55 m and y = -0.12 m.
#
# A problem has few places of its own, and plans may need others. Any problem knows a spot by its name.

PER_METRE = 10_000
"""Names count tenths of a millimetre."""
SPOT = re.compile(r"spot-(m?\d{1,6})-(m?\d{1,6})")
"""What spots are called; `m` is for minus, which PDDL does not know."""


def spot_name(x: float, y: float) -> str:
    """Return the name of the spot that is nearest.

    Args:
        x: Where it lies [m].
        y: The same for the other axis [m].
    """
    return "-".join(["spot", *(_word(round(value * PER_METRE)) for value in (x, y))])


def spot_named(name: str) -> tuple[float, float] | None:
    """Return where a spot lies [m], or None if the name is not that of a spot.

    Args:
        name: The name of a place.
    """
    found = SPOT.fullmatch(name)
    if found is None:
        return None
    x, y = (int(word.replace("m", "-")) / PER_METRE for word in found.groups())
    return x, y


def _word(count: int) -> str:
    return f"m{-count}" if count < 0 else str(count)


# Problems: a scene of named objects, and where some of them shall go

LEGAL_NAME = re.compile(r"[a-z][a-z0-9-]*")
"""What PDDL, and every planner we know, takes as a name."""
LONGEST_NAME = 100
"""So many characters a name has at most: files are called by it."""
NEAR_TABLE = 0.1
"""How far off the table an object may stand and still be planned for, after a push or a nudge [m]."""
ROUNDED = 1e-9
"""What binary numbers make of a sum of decimal ones, at most: 0.14 + 0.04 is no more than 0.18 [m]."""


class SceneObject(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One object of a scene.

    Attributes:
        name: What plans call it, a legal PDDL name like `item-01`.
        category: Its object symbol, like "10".
        features: What it is; see `Scene`.
        position: Its centre in the world frame [m].
        orientation: Its orientation in the world frame, as a quaternion (x, y, z, w).
    """

    name: str
    category: Symbol
    features: tuple[Length, ...]
    position: Vector
    orientation: tuple[float, float, float, float] = (0.0, 0.0, 0.0, 1.0)

    def __post_init__(self) -> None:
        check_fields(self)


class Problem(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """A scene at rest, and goals for some of its objects: where they shall be, or how they shall be related.

    Files leave out what is empty, but always say the tolerance and the provenance.

    Attributes:
        name: What the problem is called, a legal PDDL name.
        objects: The objects, all at rest on the table.
        goals: Where the centre of an object shall come to be [m], by the object's name.
        tolerance: How near it must come [m].
        provenance: How the problem came about: a seed, or "by hand".
        places: Where objects may be carried to: x and y of each place [m], by its name; drawn if not given.
        relations: Which object shall stand to which other one in which state: target, reference, state.
        pairs: Kinds of the pairs of objects, by the names of target and reference with a blank between.
        foreseen: How surely operators are foreseen to keep their promises with a pair: by the same names of
            the pair, and then of the operator; where that is not said, as surely as with its kind.
        touching: Names of the objects that touch, where somebody saw that; else it is told by geometry.
    """

    name: str
    objects: tuple[SceneObject, ...]
    goals: dict[str, Vector]
    tolerance: Length = msgspec.field(default_factory=lambda: TOLERANCE)
    provenance: str = msgspec.field(default_factory=lambda: "by hand")
    places: dict[str, tuple[Length, Length]] = {}
    relations: tuple[RelationGoal, ...] = ()
    pairs: dict[str, Symbol] = {}
    foreseen: dict[str, dict[str, Share]] = {}
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
        check_relation_goals(self.related, names, self.goals)

    @property
    def related(self) -> tuple[RelationGoal, ...]:
        """The goals by relation; none in problems that do not say."""
        return self.relations

    @property
    def object_names(self) -> tuple[str, ...]:
        """Names of the M objects, in the scene's order."""
        return tuple(item.name for item in self.objects)

    def object_named(self, name: str) -> SceneObject:
        """Return the object of that name.

        Raises:
            UnknownChoice: If there is none.
        """
        for item in self.objects:
            if item.name == name:
                return item
        raise UnknownChoice("object", str(name), self.object_names)

    def place_named(self, name: str) -> tuple[float, float]:
        """Return where a place of the problem or a spot lies [m].

        Raises:
            InvalidValue: If no name is given.
            UnknownChoice: If there is none of that name.
        """
        if not name:
            raise InvalidValue(
                f"What carries an object needs a place to carry it to; valid: {', '.join(self.places)}."
            )
        found = self.places.get(name) or spot_named(name)
        if found is None:
            raise UnknownChoice("place", name, (*self.places, "spots such as spot-5500-m1200"))
        return found

    def within(self, tolerance: float | None) -> "Problem":
        """Return the problem with another tolerance, or as it is.

        Args:
            tolerance: How near objects must come [m]; None for the problem's own.

        Raises:
            InvalidValue: If it is impossible.
        """
        return self if tolerance is None else msgspec.structs.replace(self, tolerance=tolerance)

    def only(self, name: str) -> "Problem":
        """Return the problem of one object with a goal, without the others."""
        goals = {name: self.goals[name]}
        return msgspec.structs.replace(self, objects=(self.object_named(name),), goals=goals)

    def scene(self) -> Scene:
        """Return the scene that the problem starts from."""
        return Scene(
            features=np.array([item.features for item in self.objects], dtype=float),
            positions=np.array([item.position for item in self.objects], dtype=float),
            orientations=np.array([item.orientation for item in self.objects], dtype=float),
        )

    def goal_positions(self) -> Float[np.ndarray, "M 3"]:
        """Return where each object shall come to be [m], NaN for an object without a goal."""
        nowhere = (math.nan, math.nan, math.nan)
        return np.array([self.goals.get(name, nowhere) for name in self.object_names], dtype=float)

    def room(self, table: Table, *, rounded: float = ROUNDED) -> Float[np.ndarray, "2 M 2"]:
        """Return the least and greatest x and y that each object's centre may have in a plan [m].

        That is the table; for an object that stands a little off it, as far out as it stands.

        Args:
            table: Where objects may stand.
            rounded: By how much sums of displacements may be off, and so be beyond the edge [m].
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
        """Measure how far each object with a goal is from it [m].

        Args:
            positions: Centres of the objects [m], in the problem's order.
        """
        return {
            name: math.dist(positions[self.object_names.index(name)], goal)
            for name, goal in self.goals.items()
        }

    def is_met(self, positions: Float[np.ndarray, "M 3"]) -> bool:
        """Say whether every object with a goal is within the tolerance of it.

        Args:
            positions: Centres of the objects [m], in the problem's order.
        """
        return all(distance <= self.tolerance for distance in self.distances(positions).values())

    def save(self, path: Path) -> None:
        """Write the problem to a file, NAME.scene.json by custom."""
        write_json(as_path(path), self)

    @classmethod
    def load(cls, path: Path) -> "Problem":
        """Read a problem.

        Raises:
            InvalidFile: If the file is no problem, or one that cannot be.
        """
        problem = read_json(as_path(path), cls)
        touching = [pair_key(*pair) for pair in problem.touching or ()]
        for what, told in (("pairs", problem.pairs), ("foreseen", problem.foreseen), ("touching", touching)):
            try:
                check_pair_keys(what, told, problem.object_names)
            except InvalidValue as error:
                raise InvalidFile(path, str(error).rstrip(".")) from error
        foreseen = {pair: _renamed(shares) for pair, shares in problem.foreseen.items()}
        return msgspec.structs.replace(problem, foreseen=foreseen) if foreseen else problem


def _renamed(shares: dict[str, float]) -> dict[str, float]:
    """Return what is foreseen of a pair by the names that operators have now."""
    return {name.removesuffix(FORMER_SUFFIX): share for name, share in shares.items()}


def goal_heights(problem: Problem, lift_height: float) -> tuple[float, float]:
    """Return the least and greatest height that a goal can have [m], above a table at height 0.

    Args:
        problem: The problem, whose objects are at rest.
        lift_height: How far the hand rises after the last waypoint [m].
    """
    return 0.0, max(item.position[2] for item in problem.objects) + 2 * lift_height


def check_goals(problem: Problem, table: Table, z_range: tuple[float, float]) -> None:
    """Raise `InvalidValue` unless there are goals and each lies where an object can be.

    Args:
        problem: The problem to check.
        table: Where objects may stand.
        z_range: Least and greatest height that a centre can have [m].
    """
    if not (problem.goals or problem.related):
        raise InvalidValue(f"The problem {problem.name} has no goal; give at least one object a goal.")
    for name, goal in problem.goals.items():
        for axis, value, (low, high) in zip("xyz", goal, (table.x, table.y, z_range), strict=True):
            if not low <= value <= high:
                raise InvalidValue(
                    f"The goal of {name} has {axis} = {value:g} m, out of reach; valid: "
                    f"x {_range(table.x)}, y {_range(table.y)}, z {_range(z_range)} [m]."
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


def _range(bounds: tuple[float, float]) -> str:
    return f"{bounds[0]:g} to {bounds[1]:g}" if math.isfinite(bounds[1]) else "any"
