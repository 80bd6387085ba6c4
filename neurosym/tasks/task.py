"""A task: a problem and a learned domain, understood once.

What can be done with each object, with each pair and at each place follows from the two together. It is
worked out here, when it is first asked for, and kept.
"""

import math
from collections import Counter
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import combinations, permutations, product

import msgspec
import numpy as np

from neurosym.checks import Bool, Float
from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.operators import Operator, Symbol
from neurosym.pair_operators import Case, PairState, RelationOperators, case_of, extent
from neurosym.problems import ROUNDED, Problem, RelationGoal, pair_key
from neurosym.tasks.conditions import unmet_conditions
from neurosym.tasks.lying import as_planned, lying
from neurosym.tasks.options import Move, Put, as_moves, carriers_for, moves_for, puts_for, puts_of, step_cost
from neurosym.tasks.promises import usable
from neurosym.tasks.supports import Borne, Seen, bearers_of, kinds_of, loads_of, seen_states
from neurosym.world import Table

# Footprints: how far apart objects must be, not to stand in one another


def footprints_apart(problem: Problem, borne: Collection[str] = ()) -> Float[np.ndarray, "M M 2"]:
    """Return how far apart the centres of two objects must be on x or y, not to stand in each other [m].

    Footprints count as boxes along the axes, which may touch, whatever binary numbers make of their sizes. Of
    two that stand on the table and overlap at the start already nothing is asked.
    """
    sizes = np.array([item.features[:2] for item in problem.objects], dtype=float)
    apart = (sizes[:, None] + sizes) / 2 - ROUNDED
    spots = problem.scene().positions[:, :2]
    stands = np.array([name not in borne for name in problem.object_names])
    overlap = np.all(np.abs(spots[:, None] - spots) < apart, axis=-1)
    apart[overlap & stands[:, None] & stands] = 0.0
    return np.asarray(apart)


def overlapping(
    spot: Float[np.ndarray, "2"], others: Float[np.ndarray, "M 2"], apart: Float[np.ndarray, "M 2"]
) -> Bool[np.ndarray, " M"]:
    """Say which of some objects an object would stand in; see `footprints_apart`."""
    return np.asarray(np.all(np.abs(others - spot) < apart, axis=-1))


def near_some(
    spots: Float[np.ndarray, "N 2"], others: Float[np.ndarray, "K 2"], apart: Float[np.ndarray, "K 2"]
) -> Bool[np.ndarray, " N"]:
    """Say which of some spots are nearer to some other than they must be, on both axes [all m]."""
    return np.asarray(np.any(np.all(np.abs(spots[:, None] - others) < apart, axis=-1), axis=-1))


# The places of a problem: those of the goals, and free ones to park on; and which objects may stand there.
#
# A goal is met by whatever lies within its tolerance. Where objects would nearly touch at their goals, they
# are carried a little beside them, so that the hand has room. An object may be carried to its goal. It may
# also wait on a place to park on, and where there are too few of these, on the goal of another. For that it
# must have room whatever stands at the other places: no two that stand at places stand in each other.

START, GOAL, PARK = "start-", "goal-", "park-"
"""What the names of places begin with."""
ROOM = (0.02, 0.05)
"""Room along x and y that is made between objects at their goals, if these allow it [m].

The fingers of the hand open along y, so there they need more.
"""
SHARE = 0.5  # how far beside its goal an object may be set down by choice, as a share of the tolerance
GAP, LEAST_GAP = 0.05, 0.01
"""Room that is left around places to park on, for the hand; less, if else there are few [m]."""
MOST_PARKS = 8
"""Places to park on at most: who waits is carried on before long, and planners try each for each object."""
_CANDIDATES, _ROUNDS, _DIGITS = 2000, 200, 4
_EDGE = 0.02  # how far inside the edge of the table drawn spots lie [m]


def with_places(problem: Problem, grounding: Grounding) -> Problem:
    """Return a problem with the places that its objects may be carried to, unless it has its own.

    There is one for each goal on the table, see `goal_spots`, and as many to park on as there are objects,
    though eight at most, where there is room: none overlaps an object as it stands, a goal or another one,
    whichever object stands there, or at least if a small one does. Where nothing carries objects to places,
    the problem stays as it is.
    """
    if grounding.places is None or problem.places:
        return problem
    names = tuple(
        name
        for name, goal in sorted(problem.goals.items())
        if grounding.table.contains(np.array(goal))
        and abs(goal[2] - problem.object_named(name).position[2]) <= problem.tolerance
    )
    spots = goal_spots(problem, grounding.table, names)
    goals = {f"{GOAL}{name}": _in_reach(name, spot, problem, grounding) for name, spot in spots.items()}
    parks = _parks(problem, grounding.table, goals)
    found = {f"{PARK}{number:02d}": spot for number, spot in enumerate(parks, start=1)}
    return msgspec.structs.replace(problem, places={**goals, **found})


def _in_reach(
    name: str, spot: tuple[float, float], problem: Problem, grounding: Grounding
) -> tuple[float, float]:
    """Return the spot nearest to one [m] for which what carries an object there aims on the table."""
    carriers = carriers_for(problem.object_named(name), grounding, problem.tolerance)
    if not (carriers and (promise := carriers[0].promise)):
        return spot
    (x, y), (off_x, off_y) = spot, promise.resting_effect[:2]
    aim = grounding.table.nearest(x - off_x, y - off_y)
    if (aim.x, aim.y) == (x - off_x, y - off_y):
        return spot
    return round(aim.x + off_x, _DIGITS), round(aim.y + off_y, _DIGITS)


def drawn_spots(size: Float[np.ndarray, "2"], table: Table) -> Float[np.ndarray, "N 2"]:
    """Draw spots where an object of a size may stand, the same for the same size and table [all m]."""
    low, high = np.array([table.x, table.y]).T
    inside = np.minimum(size / 2 + _EDGE, (high - low) / 2)
    drawn = np.random.default_rng(0).uniform(size=(_CANDIDATES, 2))
    return np.asarray(low + inside + drawn * (high - low - 2 * inside))


def is_within(spots: Float[np.ndarray, "*n K"], room: Float[np.ndarray, "2 *m"]) -> Bool[np.ndarray, "*n"]:
    """Say which positions have their x and y within least and greatest ones [all m]."""
    return np.asarray(np.all((spots[..., :2] >= room[0]) & (spots[..., :2] <= room[1]), axis=-1))


def _parks(
    problem: Problem, table: Table, goals: Mapping[str, tuple[float, float]]
) -> list[tuple[float, float]]:
    """Draw places to park on, the same for the same problem; smaller ones where large ones are few."""
    sizes = np.array([item.features[:2] for item in problem.objects], dtype=float)
    spots = [
        *problem.scene().positions[:, :2],
        *map(np.array, (goals.get(f"{GOAL}{name}", goal[:2]) for name, goal in problem.goals.items())),
    ]
    rooms = [*sizes, *(sizes[problem.object_names.index(name)] for name in problem.goals)]
    parks = list[tuple[float, float]]()
    largest, usual, smallest = sizes.max(0), np.median(sizes, axis=0), sizes.min(0)
    for size, gap in ((largest, GAP), (largest, LEAST_GAP), (usual, LEAST_GAP), (smallest, LEAST_GAP)):
        candidates = drawn_spots(size, table)
        free = ~near_some(candidates, np.array(spots), (np.array(rooms) + size) / 2 + gap)
        while free.any() and len(parks) < parks_wanted(problem):
            spot = candidates[free.argmax()]
            parks.append((round(float(spot[0]), _DIGITS), round(float(spot[1]), _DIGITS)))
            spots.append(spot)
            rooms.append(size)
            free &= ~near_some(candidates, spot[None], (size + gap)[None])
    return parks


def parks_wanted(problem: Problem) -> int:
    """Return how many places to park on a problem has where there is room."""
    return min(len(problem.objects), MOST_PARKS)


def is_at(name: str, spot: tuple[float, float], problem: Problem) -> bool:
    """Say whether an object with a goal would be at it with its centre over a spot of the table [m]."""
    x, y, z = problem.goals[name]
    return math.dist((*spot, problem.object_named(name).position[2]), (x, y, z)) <= problem.tolerance


def goal_spots(problem: Problem, table: Table, names: tuple[str, ...]) -> dict[str, tuple[float, float]]:
    """Return where on the table each object is to be carried, at most half the tolerance beside its goal [m].

    What stands at its goal already, or has none, stays where it is, and the others keep away from it.
    """
    if not names:
        return {}
    here = problem.scene().positions
    unmet = problem.unmet
    stays = [name not in unmet for name in problem.object_names]
    chosen = [row for row, name in enumerate(problem.object_names) if stays[row] or name in names]
    moves = np.array([not stays[row] for row in chosen], dtype=bool)  # (M,)
    goals = np.array(
        [here[row, :2] if stays[row] else problem.goals[problem.object_names[row]][:2] for row in chosen]
    )
    halves = np.array([problem.objects[row].features[:2] for row in chosen], dtype=float) / 2  # (M, 2)
    spots = _apart(goals, halves, moves, SHARE * problem.tolerance, table)
    found = {problem.object_names[row]: spot for row, spot in zip(chosen, spots.tolist(), strict=True)}
    return {name: (round(found[name][0], _DIGITS), round(found[name][1], _DIGITS)) for name in names}


def _apart(
    goals: Float[np.ndarray, "M 2"],
    halves: Float[np.ndarray, "M 2"],
    moves: Bool[np.ndarray, " M"],
    most: float,
    table: Table,
) -> Float[np.ndarray, "M 2"]:
    """Push boxes apart with less than `ROOM` between them, step by step, none too far from its goal."""
    low, high = np.array([table.x, table.y]).T
    pairs = [pair for pair in combinations(range(len(goals)), 2) if moves[[*pair]].any()]
    ones, others = np.array(pairs, dtype=int).reshape(-1, 2).T
    room = halves[ones] + halves[others]
    spots = goals.copy()
    for _ in range(_ROUNDS):
        push = np.zeros_like(spots)
        away = spots[others] - spots[ones]  # (pairs, 2)
        over = room - np.abs(away)
        lacking = over + np.array(ROOM)
        for number in np.flatnonzero((lacking > 0).all(1)):
            one, other = pairs[number]
            axis = int(over[number].argmin())
            step = np.sign(away[number, axis] or 1.0) * lacking[number, axis] / (moves[one] + moves[other])
            push[one, axis] -= step * moves[one]
            push[other, axis] += step * moves[other]
        if not push.any():
            break
        beside = spots + push / 2 - goals
        beside *= np.minimum(1.0, most / np.maximum(np.linalg.norm(beside, axis=1), 1e-12))[:, None]
        inside = np.clip(goals + beside, np.minimum(low, goals), np.maximum(high, goals))
        before, spots = spots, np.where(moves[:, None], inside, goals)
        if np.array_equal(before, spots):  # and so it would stay
            break
    return spots


def occupants(problem: Problem, carried: Sequence[str]) -> dict[str, tuple[str, ...]]:
    """Return which of the objects that can be carried may be carried to each place of a problem."""
    names, spots = list(problem.places), np.array([*problem.places.values()], dtype=float)
    sizes = {item.name: np.array(item.features[:2], dtype=float) for item in problem.objects}
    smallest = np.min([*sizes.values()], axis=0)
    owners = {  # the objects whose goals are met there
        name: [one for one in problem.goals if not name.startswith(PARK) and is_at(one, spot, problem)]
        for name, spot in problem.places.items()
    }
    rooms = np.array(  # (P, 2), what stands at each place at most [m]
        [np.max([smallest, *(sizes[one] for one in owners[name])], axis=0) for name in names]
    )
    found = {name: [one for one in carried if one in owners[name]] for name in names}
    parks = [name for name in names if name.startswith(PARK)]
    to_wait = parks if len(parks) >= parks_wanted(problem) else [*parks, *(set(names) - set(parks))]
    for name in sorted(to_wait, key=names.index):
        row = names.index(name)
        others = np.arange(len(names)) != row
        for thing in sorted(carried, key=lambda one: (tuple(sizes[one]), one)):
            apart = (sizes[thing] + rooms[others]) / 2 - ROUNDED
            if thing not in found[name] and not overlapping(spots[row], spots[others], apart).any():
                found[name].append(thing)
                rooms[row] = np.maximum(rooms[row], sizes[thing])
    return {name: tuple(sorted(things)) for name, things in found.items()}


Pair = tuple[str, str]  # names of a target and of a reference
Spot = tuple[float, float]
MOST_BORNE = 2
"""So many objects another one bears in a plan, unless a problem has or asks for more: each count is one more
thing for planners to look at."""


@dataclass(frozen=True, eq=False)
class Task:
    """A problem and a learned domain together; see `understand`."""

    problem: Problem  # the problem, with its objects as plans count them; see `as_planned`
    grounding: Grounding  # the learned domain
    kinds: Mapping[str, Symbol]  # kinds of the pairs of objects, if the domain knows any; see `pair_key`
    seen: Seen  # the states of the pairs at the start
    supports: Mapping[str, Borne]  # what bears each object that another one bears at the start
    lying: Mapping[str, Operator] = field(
        default_factory=dict
    )  # what sets those upright that are to be first

    @cached_property
    def flat(self) -> Problem:
        """The problem with every object as high as it is when it stands on the table, and with its places."""
        scene = self.problem.scene()
        objects = [
            msgspec.structs.replace(item, position=(*item.position[:2], float(extent(scene, row)[2]) / 2))
            if item.name in self.supports
            else item
            for row, item in enumerate(self.problem.objects)
        ]
        return with_places(msgspec.structs.replace(self.problem, objects=tuple(objects)), self.grounding)

    @cached_property
    def room(self) -> Float[np.ndarray, "2 M 2"]:
        """The least and greatest x and y that each object's centre may have in a plan [m]."""
        return self.problem.room(self.grounding.table)

    @cached_property
    def relates(self) -> bool:
        """Whether an object is borne by another one, or shall be."""
        return bool(self.supports or self.problem.relations)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the objects, in the problem's order."""
        return self.problem.object_names

    @property
    def places(self) -> Mapping[str, Spot]:
        """Where objects may be carried to: x and y of each place [m], by its name."""
        return self.flat.places

    def moves_on(self, grounding: Grounding, name: str) -> tuple[Move, ...]:
        """Return what is done to an object by itself, in the cells of a grounding that has others."""
        return moves_for(self.problem.object_named(name), grounding, self.problem.tolerance)

    def every_move_on(self, grounding: Grounding, name: str) -> tuple[Move, ...]:
        """Return the same, with all that the domain itself tells apart, though those cells may not."""
        item, tolerance = self.problem.object_named(name), self.problem.tolerance
        told = (*usable(self.grounding, item, tolerance), *usable(grounding, item, tolerance))
        found = {operator.name: operator for operator in told}
        return as_moves([operator for _, operator in sorted(found.items())], grounding)

    @cached_property
    def carriers(self) -> Mapping[str, tuple[Operator, ...]]:
        """What carries each object to places, the surest first, for objects that something carries."""
        return {
            item.name: found
            for item in self.flat.objects
            if (found := carriers_for(item, self.grounding, self.problem.tolerance))
        }

    @cached_property
    def carried(self) -> tuple[str, ...]:
        """Names of the objects that stand at places: what can be carried, unless no place meets its goal."""
        return tuple(
            name
            for name in self.names
            if name in self.carriers
            and (
                name not in self.problem.goals
                or self.relates
                or any(is_at(name, spot, self.flat) for spot in self.places.values())
            )
        )

    @cached_property
    def led(self) -> tuple[str, ...]:
        """Names of the objects that are led over cells: those with a goal that cannot be carried to it."""
        goals = () if self.relates else self.problem.goals
        return tuple(name for name in self.names if name in goals and name not in self.carried)

    @cached_property
    def occupants(self) -> Mapping[str, tuple[str, ...]]:
        """Which objects may be carried to each place."""
        return occupants(self.flat, self.carried) if self.places else {}

    @cached_property
    def apart(self) -> Float[np.ndarray, "M M 2"]:
        """How far apart the centres of two objects on the table must be on x or y [m]."""
        return footprints_apart(self.problem, self.supports)

    def blockers(self, name: str, spot: Spot) -> tuple[str, ...]:
        """Name the other objects on the table that stand at first where an object would come to stand."""
        row, here = self.names.index(name), self.problem.scene().positions[:, :2]
        over = np.flatnonzero(overlapping(np.array(spot), here, self.apart[row]))
        found = (self.names[other] for other in over if other != row)
        return tuple(other for other in found if other not in self.supports)

    def carry_cost(self, name: str, *, borne: bool = False) -> int:
        """Return what carrying an object to a place costs, by its surest operator; it may be borne before."""
        return step_cost(self.carriers[name][0], self.grounding, borne=borne)

    @cached_property
    def puts(self) -> Mapping[Pair, tuple[Put, ...]]:
        """What is likely to put each object on or into each other one."""
        if self.grounding.relations is None:
            return {}
        pairs = permutations(sorted(self.names), 2)
        return {
            pair: puts_for(self.problem, self.grounding, *pair, self.kinds.get(pair_key(*pair)))
            for pair in pairs
        }

    @cached_property
    def put_options(self) -> Mapping[Pair, tuple[Put, ...]]:
        """The surest way for each pair, state and case; pairs with none are not there."""
        found = {pair: _surest(puts) for pair, puts in self.puts.items()}
        return {pair: options for pair, options in found.items() if options}

    @cached_property
    def most_borne(self) -> int:
        """How many objects another one bears at most in a plan: as many as asked for, or a few."""
        wanted = Counter(reference for _, reference, _ in self.problem.relations)
        at_first = (len(loads_of(name, self.supports)) for name in self.names)
        takes_more = any(put.operator.takes("occupied") for put in puts_of(self.grounding))
        return max([MOST_BORNE if takes_more else 1, *wanted.values(), *at_first])

    def state_named(self, state: str) -> PairState:
        """Return the state that a goal names by its name or symbol."""
        assert self.grounding.relations is not None, "only then are there goals by relation"
        return self.grounding.relations.state_named(state)


_REMEMBERED = 4
_latest: list[tuple[Problem, Grounding, Task]] = []


def understand(problem: Problem, grounding: Grounding) -> Task:
    """Work out what a problem and a learned domain mean together; the same again for the same two."""
    for known, learned, task in _latest:
        if learned is grounding and (known is problem or known == problem):
            return task
    relations = relations_of(grounding, problem) if problem.relations else grounding.relations
    planned = as_planned(problem, grounding)
    kinds = kinds_of(planned, relations)
    seen = seen_states(planned, relations) if relations else {}
    supports = bearers_of(planned, relations, kinds, seen) if relations else {}
    lie = {name: operator for name, operator in lying(problem, grounding).items() if operator}
    task = Task(planned, grounding, kinds, seen, supports, lie)
    _latest.insert(0, (problem, grounding, task))
    del _latest[_REMEMBERED:]
    return task


def relations_of(grounding: Grounding, problem: Problem) -> RelationOperators:
    """Return what a domain knows of relations; `InvalidValue` if it knows nothing that the problem needs."""
    if grounding.relations is None:
        raise InvalidValue(
            f"The problem {problem.name} is one of relations, and the domain {grounding.name} has learned "
            "none; valid: a problem with goals on the table, or a domain with relations."
        )
    return grounding.relations


def unmet_relations(problem: Problem, grounding: Grounding) -> tuple[RelationGoal, ...]:
    """List the goals by relation that do not hold as the objects stand now.

    Where a goal is that an object bears another one, it must be that one itself that bears it.
    """
    if not problem.relations:
        return ()
    task, found = understand(problem, grounding), list[RelationGoal]()
    for target, reference, name in problem.relations:
        asked = task.state_named(name)
        borne, seen = task.supports.get(target), task.seen[target, reference][0]
        if borne != Borne(reference, asked) if asked.bears else seen != asked:
            found.append((target, reference, name))
    return tuple(found)


def why_no_relation(problem: Problem, grounding: Grounding) -> str:
    """Say which goal by relation nothing leads to, and what would be valid; nothing if there is none."""
    task = understand(problem, grounding)
    bearing = ", ".join(state.name for state in grounding.bearing_states) or "none was learned"
    for target, reference, name in problem.relations:
        state = task.state_named(name)
        if not state.bears:
            said = f"{target} cannot be brought to {state.name} with {reference}, in which nothing is borne"
            return f"{said}; valid states: {bearing}"
    for target, reference, name in unmet_relations(problem, grounding):
        state = task.state_named(name)
        if not any(put.state == state for put in task.puts[target, reference]):
            valid = valid_relations(problem, grounding, target)
            return f"no operator brings {target} to {state.name} with {reference}; {valid}"
    return why_too_many(problem, grounding)


def valid_relations(problem: Problem, grounding: Grounding, target: str) -> str:
    """Say what can be done with an object relative to others."""
    puts = understand(problem, grounding).puts
    others = (other for other in problem.object_names if other != target)
    known = ", ".join(dict.fromkeys(f"{put.state.name} {one}" for one in others for put in puts[target, one]))
    return f"valid for {target}: {known}" if known else f"nothing puts {target} on or into any other object"


def why_too_many(problem: Problem, grounding: Grounding) -> str:
    """Say which object should bear several and cannot, or nothing."""
    puts, wanted = understand(problem, grounding).puts, dict[str, list[str]]()
    for target, reference, _ in problem.relations:
        wanted.setdefault(reference, []).append(target)
    for reference, targets in wanted.items():
        every = (put for target in targets for put in puts[target, reference])
        if len(targets) > 1 and not any(put.operator.takes("occupied") for put in every):
            return (
                f"{reference} shall bear {' and '.join(targets)}, and rehearsals show that it bears one "
                "object at a time; leave one of the two out"
            )
    return ""


def is_reached(problem: Problem, grounding: Grounding) -> bool:
    """Say whether all goals are met as the objects stand now; or all conditions, if these are asked for."""
    if problem.conditions:
        return not any(unmet_conditions(problem, grounding))
    if lying(problem, grounding):
        return False
    return problem.is_met(problem.scene().positions) and not unmet_relations(problem, grounding)


def is_relational(problem: Problem, grounding: Grounding) -> bool:
    """Say whether a problem is one of relations: it asks for some, or begins with some."""
    return bool(problem.relations) or bool(grounding.relations and understand(problem, grounding).supports)


def _surest(puts: tuple[Put, ...]) -> tuple[Put, ...]:
    """Return the surest of what does the same to a pair in the same case, in each case that it takes."""
    found = dict[tuple[Symbol, Case], Put]()
    cases = [case_of(*flags) for flags in product((False, True), repeat=3)]
    for put, case in product(puts, cases):
        if all(map(put.operator.takes, case)):
            option, key = replace(put, case=case), (put.state.symbol, case)
            if key not in found or option.chance > found[key].chance:
                found[key] = option
    return tuple(found.values())
