"""A task: a problem and a learned domain, understood once.

What can be done with each object, with each pair and at each place follows from the two together. It is
worked out here, when it is first asked for, and kept.
"""

from collections import Counter
from collections.abc import Collection, Mapping
from dataclasses import dataclass
from functools import cached_property
from itertools import permutations, product

import msgspec
import numpy as np

from neurosym.arrays import Float
from neurosym.grounding import Grounding
from neurosym.operators import Operator
from neurosym.pair_sight import kinds_of
from neurosym.pair_states import extent
from neurosym.problems import Problem
from neurosym.promises import usable
from neurosym.related import Borne, bearers_of, loads_of, relations_of
from neurosym.relation_goals import pair_key
from neurosym.relation_operators import PairState
from neurosym.symbols import Symbol
from neurosym.tasks.carriers import Carrier, carriers_for, relational_carriers
from neurosym.tasks.footprints import footprints_apart
from neurosym.tasks.moves import Move, as_moves, moves_for, step_cost
from neurosym.tasks.places import blockers, is_at, occupants, with_places
from neurosym.tasks.puts import Put, puts_for, puts_of

Pair = tuple[str, str]
"""Names of a target and of a reference."""
Spot = tuple[float, float]
MOST_BORNE = 2
"""So many objects another one bears in a plan, unless a problem has or asks for more: each count is one more
thing for planners to look at."""


@dataclass(frozen=True, slots=True)
class PutOption:
    """What puts one object on or into another most surely, in a case.

    Attributes:
        put: The operator.
        borne: Whether the target is taken from another object.
        occupied: Whether the reference bears something already.
        laden: Whether the target takes along what rests on it.
        cost: What the step costs.
    """

    put: Put
    borne: bool
    occupied: bool
    laden: bool
    cost: int

    @property
    def state(self) -> PairState:
        """The state that the pair ends in."""
        return self.put.state

    @property
    def case(self) -> tuple[str, bool, bool, bool]:
        """What tells it from others for the same pair."""
        return self.state.name, self.borne, self.occupied, self.laden


@dataclass(frozen=True, eq=False)
class Task:
    """A problem and a learned domain together; see `understand`.

    Attributes:
        problem: The problem.
        grounding: The learned domain.
        kinds: Kinds of the pairs of objects, if the domain knows any; see `pair_key`.
        supports: What bears each object that another one bears at the start.
    """

    problem: Problem
    grounding: Grounding
    kinds: Mapping[str, Symbol]
    supports: Mapping[str, Borne]

    @cached_property
    def flat(self) -> Problem:
        """The problem with every object on the table, and with its places."""
        return with_places(_flattened(self.problem, self.supports), self.grounding)

    @cached_property
    def room(self) -> Float[np.ndarray, "2 M 2"]:
        """The least and greatest x and y that each object's centre may have in a plan [m]."""
        return self.problem.room(self.grounding.table)

    @cached_property
    def relates(self) -> bool:
        """Whether an object is borne by another one, or shall be."""
        return bool(self.supports or self.problem.related)

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
            and (name not in self.problem.goals or self.relates or self._has_goal_place(name))
        )

    def _has_goal_place(self, name: str) -> bool:
        return any(is_at(name, spot, self.flat) for spot in self.places.values())

    @cached_property
    def led(self) -> tuple[str, ...]:
        """Names of the objects that are led over cells: those with a goal that cannot be carried to it."""
        if self.relates:
            return ()
        goals = self.problem.goals
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
        found = blockers(name, spot, self.flat, self.apart)
        return tuple(other for other in found if other not in self.supports)

    @cached_property
    def carrier_facts(self) -> Mapping[str, Carrier]:
        """What was seen of stacks with each operator that carries to places, by its name."""
        return relational_carriers(self.grounding)

    def carry_cost(self, name: str, *, borne: bool = False) -> int:
        """Return what carrying an object to a place costs, by its surest operator; it may be borne before."""
        surest = self.carriers[name][0]
        if not borne:
            return step_cost(surest, self.grounding)
        return self.carrier_facts[surest.name].cost(surest, self.grounding, borne=True)

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
    def put_options(self) -> Mapping[Pair, tuple[PutOption, ...]]:
        """The surest way for each pair, state and case; pairs with none are not there."""
        found = {pair: _surest(puts, self.grounding) for pair, puts in self.puts.items()}
        return {pair: options for pair, options in found.items() if options}

    @cached_property
    def most_borne(self) -> int:
        """How many objects another one bears at most in a plan: as many as asked for, or a few."""
        wanted = Counter(reference for _, reference, _ in self.problem.related)
        at_first = (len(loads_of(name, self.supports)) for name in self.names)
        takes_more = any(put.takes_occupied for put in puts_of(self.grounding))
        return max([MOST_BORNE if takes_more else 1, *wanted.values(), *at_first])

    def state_named(self, state: str) -> PairState:
        """Return the state that a goal names by its name or symbol."""
        assert self.grounding.relations is not None, "only then are there goals by relation"
        return self.grounding.relations.state_named(state)


_REMEMBERED = 4
_latest: list[tuple[Problem, Grounding, Task]] = []


def understand(problem: Problem, grounding: Grounding) -> Task:
    """Work out what a problem and a learned domain mean together; the same again for the same two.

    Args:
        problem: The problem, with the objects as they stand now.
        grounding: The learned domain.

    Raises:
        InvalidValue: If the problem asks for relations, and the domain knows none.
    """
    for known, learned, task in _latest:
        if learned is grounding and (known is problem or known == problem):
            return task
    relations = relations_of(grounding, problem) if problem.related else grounding.relations
    kinds = kinds_of(problem, relations)
    task = Task(problem, grounding, kinds, bearers_of(problem, relations, kinds) if relations else {})
    _latest.insert(0, (problem, grounding, task))
    del _latest[_REMEMBERED:]
    return task


def _surest(puts: tuple[Put, ...], grounding: Grounding) -> tuple[PutOption, ...]:
    """Return the surest of what does the same to a pair in the same case."""
    found = dict[tuple[str, bool, bool, bool], tuple[float, PutOption]]()
    for put, borne, occupied, laden in product(puts, *((False, True),) * 3):
        takes = (put.takes_borne, put.takes_occupied, put.takes_laden)
        if any(asked and not taken for asked, taken in zip((borne, occupied, laden), takes, strict=True)):
            continue
        case = {"borne": borne, "occupied": occupied, "laden": laden}
        option = PutOption(put, **case, cost=put.cost(grounding, **case))
        chance = put.chance(**case)
        if option.case not in found or chance > found[option.case][0]:
            found[option.case] = chance, option
    return tuple(option for _, option in found.values())


def _flattened(problem: Problem, borne: Collection[str]) -> Problem:
    """Return a problem whose borne objects are as high as they are when they stand on the table."""
    scene, objects = problem.scene(), list(problem.objects)
    for row, item in enumerate(objects):
        if item.name in borne:
            low = (*item.position[:2], float(extent(scene, row)[2]) / 2)
            objects[row] = msgspec.structs.replace(item, position=low)
    return msgspec.structs.replace(problem, objects=tuple(objects))
