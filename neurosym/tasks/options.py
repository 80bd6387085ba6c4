"""What can be done with each object and each pair, and what it costs.

Where a third object on the reference, on the target, or under it spoiled more than half of what goes well
otherwise in rehearsals, that is forbidden. Else it is allowed, and costs what it showed.
"""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Literal

import msgspec

from neurosym.grounding import Cells, Grounding, is_lift
from neurosym.operators import ANY_KIND, TOLERANCE, Mode, Operator, Symbol
from neurosym.pair_operators import FAINT, LEAST, Case, PairState
from neurosym.problems import Problem, SceneObject, pair_key
from neurosym.tasks.pasts import LEAST_CHANCE, as_it_lies, keeps, motion_of
from neurosym.tasks.promises import carrying_with, promised, usable

# What is done to an object by itself: every live operator as a displacement, and what it costs

PUT_DOWN = "put-down-"
"""What the name of an operator is preceded by where the object it lifted is put down again."""


@dataclass(frozen=True, slots=True)
class Move:
    """One primitive on one category, or putting down what it lifted."""

    name: str  # name of the PDDL action
    cells: Cells  # displacement of the object
    cost: int  # what the step costs
    # whether the hand is empty before and after ("rest"), holds the object after ("lift"), or held it before
    # ("put-down")
    kind: Literal["rest", "lift", "put-down"]
    operator: Operator  # the operator it comes from

    @property
    def axes(self) -> tuple[int, ...]:
        """The axes that the object moves along."""
        return tuple(axis for axis in range(3) if self.cells[axis])


def moves_for(item: SceneObject, grounding: Grounding, tolerance: float = TOLERANCE) -> tuple[Move, ...]:
    """List what the operators of a domain promise for an object, by name; see `usable` and `as_moves`."""
    ordered = sorted(usable(grounding, item, tolerance), key=lambda operator: operator.name)
    return as_moves(ordered, grounding)


def as_moves(operators: Iterable[Operator], grounding: Grounding) -> tuple[Move, ...]:
    """Return what operators promise as moves, in cells of a grounding, each lift followed by its put-down."""
    moves: list[Move] = []
    for operator in operators:
        kind: Literal["rest", "lift"] = "lift" if is_lift(operator) else "rest"
        cells = grounding.cells(operator)
        moves.append(Move(operator.name, cells, step_cost(operator, grounding), kind, operator))
        if kind == "lift":
            back = grounding.put_down_cells(operator)
            moves.append(Move(PUT_DOWN + operator.name, back, 0, "put-down", operator))
    return tuple(moves)


def _price(chance: float) -> int:
    """Return what goes as promised with a chance costs: 1 + round(-100 ln(chance))."""
    return 1 + round(-100 * math.log(chance))


def cost(operator: Operator) -> int:
    """Return what a step costs by its rehearsals."""
    return _price(operator.chance)


def step_cost(operator: Operator, grounding: Grounding, *, borne: bool = False) -> int:
    """Return what a step costs in a domain, 1 with unit costs; its object may be borne by another one."""
    if grounding.unit_costs:
        return 1
    more = math.log(chance_borne(operator) / operator.chance) if borne else 0.0
    return _price(operator.chance) + round(-100 * more)


def chance_borne(operator: Operator) -> float:
    """Return the chance that an object is carried to a place as promised from where another one bears it."""
    return min(operator.chance, operator.among("borne").chance)


SHARES = (0.1, 0.3, 0.5, 0.7, 0.9)
"""What is foreseen of a pair counts as the nearest of these: networks tell no finer, and so there are few
prices."""
_NEVER = 0.01  # as how rare counts what was never seen


@dataclass(frozen=True, slots=True)
class Put:
    """An operator on pairs as it is planned with."""

    operator: Operator  # the operator
    end: Mode  # how it promises to turn out
    state: PairState  # the state that the pair ends in
    # in which share of the cases it is foreseen to keep its promise with the pair at hand, one of `SHARES`;
    # None where nothing is foreseen, and it does as with others of their kind
    foreseen: float | None = None
    case: Case = frozenset()  # in which company it is done
    handled: float = 1.0  # by what factor its chance is another one, by what the target was seen to do
    shown: bool = False  # whether the target was seen to be carried with its motion, as others are

    @property
    def name(self) -> str:
        """Name of the operator."""
        return self.operator.name

    @property
    def share(self) -> float:
        """In which share of the cases it is foreseen to keep its promise."""
        return min(1.0, self.handled * (self.end.share if self.foreseen is None else self.foreseen))

    def with_pair(self, problem: Problem, grounding: Grounding, target: str, reference: str) -> "Put":
        """Return it as it is foreseen to turn out with a pair of objects, by name, if the problem says so."""
        item, known = problem.object_named(target), _carrying(grounding, self.operator)
        put = replace(self, handled=_handled(grounding, known, item), shown=_shown(grounding, known, item))
        share = problem.foreseen.get(pair_key(target, reference), {}).get(self.name)
        return put if share is None else replace(put, foreseen=min(SHARES, key=lambda one: abs(one - share)))

    @property
    def chance(self) -> float:
        """The chance that a step goes as promised, by what rehearsals in company showed."""
        usual = self.operator.chance
        among = (min(1.0, kept.chance / usual) for how, kept in self.operator.company if how in self.case)
        chance = math.prod(among, start=usual if self.foreseen is None else self.foreseen)
        return min(max(SHARES), self.handled * chance) if self.handled != 1 else chance

    def cost(self, grounding: Grounding) -> int:
        """Return what a step costs in a domain; see `step_cost`."""
        return 1 if grounding.unit_costs else _price(self.chance)


@lru_cache(maxsize=8)
def puts_of(grounding: Grounding) -> tuple[Put, ...]:
    """List the operators on pairs that the domain has, by name."""
    return tuple(put for one in grounding.live_on("pair") if (put := put_named(one.name, grounding)))


def puts_for(
    problem: Problem, grounding: Grounding, target: str, reference: str, kind: Symbol | None = None
) -> tuple[Put, ...]:
    """List what the domain can do with a pair of objects, as it is foreseen to turn out with them.

    Of operators for the same it is the surest with this pair. One for pairs of any kind must be foreseen, and
    more surely than what those for the kind of the pair promise. Where something for the same is foreseen, it
    is enough that the target was seen to be carried with its motion. What a goal asks for is offered even if
    it is only faintly foreseen, where there is nothing likelier.
    The kind of the pair is what the problem says, if it is not given.
    """
    key = pair_key(target, reference)
    kind = kind or problem.pairs.get(key)
    item = problem.object_named(target)
    fitting = [
        put.with_pair(problem, grounding, target, reference)
        for put in puts_of(grounding)
        if put.operator.is_for(kind) and _is_carried_with(grounding, put.operator, item)
    ]
    ranked = sorted(fitting, key=lambda put: put.chance)
    own = {put.state.name: put.chance for put in ranked if put.operator.subject}
    shares = problem.foreseen.get(key, {})
    fits = {put.state.name for put in fitting if shares.get(put.name, 0.0) >= LEAST}

    def is_likelier(put: Put) -> bool:
        is_known = put.foreseen is not None or (put.shown and put.state.name in fits)
        return is_known and put.chance > own.get(put.state.name, 0.0)

    at_hand = [put for put in fitting if put.operator.subject or is_likelier(put)]
    likely = [put for put in at_hand if put.share >= LEAST_CHANCE]
    known = {put.state.symbol for put in likely}
    asked = {state for one, other, state in problem.relations if (one, other) == (target, reference)}
    likely += [  # what is asked for, and only faintly foreseen
        put
        for put in at_hand
        if asked & {put.state.name, put.state.symbol}
        and put.state.symbol not in known
        and shares.get(put.name, 0.0) >= FAINT
    ]
    by_sureness = sorted(likely, key=lambda put: (put.chance, put.operator.subject != ANY_KIND, put.name))
    surest = {put.operator.case: put for put in by_sureness}
    return tuple(put for put in at_hand if surest.get(put.operator.case) is put)


def _is_carried_with(grounding: Grounding, operator: Operator, item: SceneObject) -> bool:
    """Say whether an operator on pairs is performed with what carries an object, as far as that is known."""
    known = _carrying(grounding, operator)
    return not known or any(one.name in promised(grounding, item) for one in known)


def _shown(grounding: Grounding, carrying: Sequence[Operator], item: SceneObject) -> bool:
    """Say whether an object was seen to be carried as those of another category are, by what carries so."""
    borrowed = {motion_of(one): one.promise for one in carrying if one.subject != item.category}
    seen = ((one, borrowed.get(one.motion)) for one in as_it_lies(item, grounding.turned))
    return any(promise and not one.forgotten and keeps(promise, one) for one, promise in seen)


def _handled(grounding: Grounding, carrying: Sequence[Operator], item: SceneObject) -> float:
    """Return by what factor what carries so puts a target on others, by what that did before."""
    if item.past is msgspec.UNSET:
        return 1.0
    now, before = (
        promised(grounding, item),
        promised(grounding, msgspec.structs.replace(item, past=msgspec.UNSET)),
    )
    known = (one for one in carrying if one.name in now)
    return max((now[one.name].chance / before.get(one.name, one).chance for one in known), default=1.0)


def _carrying(grounding: Grounding, operator: Operator) -> tuple[Operator, ...]:
    """Return what carries to places with the motion of an operator on pairs."""
    action = grounding.primitive_of(operator).action
    return carrying_with(grounding.places, action) if grounding.places else ()


def put_named(name: str, grounding: Grounding) -> Put | None:
    """Return an operator on pairs that promises something, in the domain or not; None if it does not."""
    found = grounding.operator_named(name.removeprefix(PUT_DOWN))
    if found.frame == "pair" and found.promise and grounding.relations:
        return Put(found, found.promise, grounding.relations.state_named(found.promise.kind))
    return None


def carriers_for(item: SceneObject, grounding: Grounding, tolerance: float) -> tuple[Operator, ...]:
    """List the operators that carry an object to places, as they promise for it, the surest first.

    How sure they are counts what rehearsals beside others showed, since a scene may hold others.
    """
    of_item = promised(grounding, item, tolerance)
    found = [of_item[one.name] for one in grounding.live_on("place") if one.name in of_item]
    fit = [one for one in found if one.successes >= LEAST_CHANCE * one.trials and one.successes]

    def effort(operator: Operator) -> tuple[float, str]:
        return step_cost(operator, grounding) / (operator.among("beside").share or _NEVER), operator.name

    return tuple(sorted(fit, key=effort))
