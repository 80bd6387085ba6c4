"""What the encoding `relational` is printed from: operators on pairs, what they ask, and what they cost.

What an operator asks is what its rehearsals showed. Where a third object on the reference, on the target, or
under it spoiled more than half of what goes well otherwise, that is forbidden. Else it is allowed, and costs
what it showed.
"""

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Literal

from neurosym.grounding import MIN_TRIALS, Cells, Grounding, is_lift
from neurosym.operators import TOLERANCE, Category, Operator, Symbol
from neurosym.pair_operators import (
    FAINT,
    SELDOM,
    Kept,
    PairEnd,
    PairState,
    RelationOperator,
    RelationOperators,
    pooled,
)
from neurosym.problems import Problem, SceneObject, pair_key
from neurosym.tasks.promises import LEAST_CHANCE, promised, usable
from neurosym.tasks.supports import relating

# What is done to an object by itself: every live operator as a displacement, and what it costs

PUT_DOWN = "put-down-"
"""What the name of an operator is preceded by where the object it lifted is put down again."""


@dataclass(frozen=True, slots=True)
class Move:
    """One primitive on one category, or putting down what it lifted.

    Attributes:
        name: Name of the PDDL action.
        cells: Displacement of the object.
        cost: What the step costs.
        kind: Whether the hand is empty before and after ("rest"), holds the object after ("lift"), or
            held it before ("put-down").
        operator: The operator it comes from.
    """

    name: str
    cells: Cells
    cost: int
    kind: Literal["rest", "lift", "put-down"]
    operator: Operator

    @property
    def axes(self) -> tuple[int, ...]:
        """The axes that the object moves along."""
        return tuple(axis for axis in range(3) if self.cells[axis])


def moves_for(item: SceneObject, grounding: Grounding, tolerance: float = TOLERANCE) -> tuple[Move, ...]:
    """List what the operators of a domain promise for an object, by name, each lift followed by its put-down.

    Args:
        item: The object.
        grounding: The learned domain.
        tolerance: How near an outcome must come to the promise to have kept it [m].
    """
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


def smoothed(kept: int, trials: int) -> float:
    """Return a chance from what was seen: (k + 1) / (n + 2), the rule of succession."""
    return (kept + 1) / (trials + 2)


def chance(operator: Operator) -> float:
    """Return the chance that a step goes as promised, from its rehearsals."""
    return smoothed(operator.successes, operator.trials)


def price(chance: float) -> int:
    """Return what goes as promised with a chance costs: 1 + round(-100 ln(chance))."""
    return 1 + round(-100 * math.log(chance))


def cost(operator: Operator) -> int:
    """Return what a step costs by its rehearsals."""
    return price(chance(operator))


def step_cost(operator: Operator, grounding: Grounding) -> int:
    """Return what a step costs in a domain: as much as any other if the domain has unit costs."""
    return 1 if grounding.unit_costs else cost(operator)


LEAST_SHARE = 0.5
"""Where a third object leaves less than this of what is usual, it is forbidden."""
SHARES = (0.1, 0.3, 0.5, 0.7, 0.9)
"""What is foreseen of a pair counts as the nearest of these: networks tell no finer, and so there are few
prices."""
ALIKE = 4
"""So many operators for the same are in the domain at most: which does it most surely depends on the pair."""


@dataclass(frozen=True, slots=True)
class Put:
    """An operator on pairs as it is planned with.

    Attributes:
        operator: The operator.
        end: How it promises to turn out.
        state: The state that the pair ends in.
        kind: The kind of pairs that it is for; None if it is for any of which something is foreseen.
        foreseen: In which share of the cases it is foreseen to keep its promise with the pair at hand, one of
            `SHARES`; None where nothing is foreseen, and it does as with others of their kind.
    """

    operator: RelationOperator
    end: PairEnd
    state: PairState
    kind: Category | None
    foreseen: float | None = None

    @property
    def name(self) -> str:
        """Name of the operator."""
        return self.operator.name

    @property
    def takes_borne(self) -> bool:
        """Whether the target may rest on a third object."""
        return self._keeps(self.operator.borne)

    @property
    def takes_occupied(self) -> bool:
        """Whether a third object may rest on the reference."""
        return self._keeps(self.operator.occupied)

    @property
    def takes_laden(self) -> bool:
        """Whether a third object may rest on the target, and then goes along."""
        return self._keeps(self.operator.laden)

    @property
    def case(self) -> tuple[Symbol, bool, bool, bool]:
        """What it does to its kind of pairs, and what third objects it takes."""
        return self.state.symbol, self.takes_borne, self.takes_occupied, self.takes_laden

    def sureness(self) -> tuple[float, bool, str]:
        """Return what sorts operators for the same case by how surely they keep their promises."""
        return self.chance(), self.kind is not None, self.name

    def _keeps(self, kept: Kept) -> bool:
        return bool(kept.trials) and kept.share >= LEAST_SHARE * self.end.share

    @property
    def share(self) -> float:
        """In which share of the cases it is foreseen to keep its promise."""
        return self.end.share if self.foreseen is None else self.foreseen

    @property
    def is_likely(self) -> bool:
        """Whether it keeps its promise often enough to be planned with."""
        return self.share >= LEAST_CHANCE

    def with_pair(self, problem: Problem, target: str, reference: str) -> "Put":
        """Return it as it is foreseen to turn out with a pair of objects.

        Args:
            problem: The problem, which may say what is foreseen.
            target: Name of the target.
            reference: Name of the reference.
        """
        share = problem.foreseen.get(pair_key(target, reference), {}).get(self.name)
        return self if share is None else replace(self, foreseen=nearest_share(share))

    def chance(self, *, borne: bool = False, occupied: bool = False, laden: bool = False) -> float:
        """Return the chance that a step goes as promised, by what rehearsals with third objects showed.

        Args:
            borne: Whether the target rests on a third object.
            occupied: Whether a third object rests on the reference.
            laden: Whether a third object rests on the target.
        """
        trials = self.operator.trials
        usual = smoothed(self.end.count, trials)
        found = usual if self.foreseen is None else self.foreseen
        cases = ((borne, self.operator.borne), (occupied, self.operator.occupied))
        for is_so, kept in (*cases, (laden, self.operator.laden)):
            if is_so and kept.trials:
                found *= min(1.0, smoothed(kept.kept, kept.trials) / usual)
        return found

    def cost(self, grounding: Grounding, **case: bool) -> int:
        """Return what a step costs: 1 + round(-100 ln(chance)), or 1 where all steps cost the same.

        Args:
            grounding: The learned domain.
            case: Where third objects rest; see `chance`.
        """
        return 1 if grounding.unit_costs else price(self.chance(**case))


def puts_of(grounding: Grounding) -> tuple[Put, ...]:
    """List the operators on pairs that the domain has, by name.

    Args:
        grounding: The learned domain.
    """
    return _puts(grounding.relations) if grounding.relations else ()


def puts_for(
    problem: Problem, grounding: Grounding, target: str, reference: str, kind: Symbol | None = None
) -> tuple[Put, ...]:
    """List what the domain can do with a pair of objects, as it is foreseen to turn out with them.

    Of operators for the same it is the surest with this pair. One for pairs of any kind must be foreseen, and
    more surely than what those for the kind of the pair promise. What a goal asks for is offered even if it
    is only faintly foreseen, where there is nothing likelier.

    Args:
        problem: The problem.
        grounding: The learned domain.
        target: Name of the one.
        reference: Name of the other.
        kind: The kind of the pair; as the problem says if not given.
    """
    kind = kind or problem.pairs.get(pair_key(target, reference))
    fitting = [
        put.with_pair(problem, target, reference) for put in puts_of(grounding) if put.operator.is_for(kind)
    ]
    own = dict[str, float]()
    for put in fitting:
        if put.kind:
            own[put.state.name] = max(own.get(put.state.name, 0.0), put.chance())
    at_hand = [
        put
        for put in fitting
        if put.kind or (put.foreseen is not None and put.chance() > own.get(put.state.name, 0.0))
    ]
    likely = [put for put in at_hand if put.is_likely]
    likely += _faint(at_hand, likely, problem, target, reference)
    surest = {put.case: put for put in sorted(likely, key=Put.sureness)}
    return tuple(put for put in at_hand if surest.get(put.case) is put)


def _faint(
    at_hand: Sequence[Put], likely: Sequence[Put], problem: Problem, target: str, reference: str
) -> list[Put]:
    """List what does what goals ask of a pair, faintly foreseen, where nothing is likely to do it."""
    asked = {state for one, other, state in problem.related if (one, other) == (target, reference)}
    shares = problem.foreseen.get(pair_key(target, reference), {})
    known = {put.state.symbol for put in likely}
    return [
        put
        for put in at_hand
        if asked & {put.state.name, put.state.symbol}
        and put.state.symbol not in known
        and shares.get(put.name, 0.0) >= FAINT
    ]


def put_named(name: str, grounding: Grounding) -> Put | None:
    """Return an operator on pairs that promises something, in the domain or not; None if it does not.

    Args:
        name: Name of the operator.
        grounding: The learned domain.
    """
    table, found = grounding.relations, relating(name, grounding)
    return _put(found, table) if table and found and found.promise else None


def bearing_states(grounding: Grounding) -> tuple[PairState, ...]:
    """List the states in which a reference bears its target, by symbol.

    Args:
        grounding: The learned domain.
    """
    states = grounding.relations.states if grounding.relations else ()
    return tuple(state for state in states if state.bears)


@lru_cache(maxsize=8)
def _puts(table: RelationOperators) -> tuple[Put, ...]:
    kept = [one for one in table.operators if one.name not in left_out(table)]
    kept += pooled(table)
    return tuple(_put(one, table) for one in sorted(kept, key=lambda one: one.name))


def _put(operator: RelationOperator, table: RelationOperators) -> Put:
    end = operator.promise
    assert end is not None, f"{operator.name} promises nothing"
    kind = next((one for one in table.pairs if one.symbol == operator.pair), None)
    return Put(operator, end, table.state_named(end.state), kind)


@lru_cache(maxsize=8)
def left_out(table: RelationOperators) -> Mapping[str, str]:
    """Say why operators of a table are not in the domain, by name.

    Args:
        table: What was learned of pairs.
    """
    found, alike = dict[str, str](), dict[tuple[object, ...], list[Put]]()
    for one in table.operators:
        if reason := _why_worthless(one, table):
            found[one.name] = reason
        else:
            put = _put(one, table)
            alike.setdefault((one.pair, *put.case), []).append(put)
    for puts in alike.values():
        surest, *others = sorted(puts, key=Put.sureness, reverse=True)
        found |= {one.name: f"does less surely what {surest.name} does" for one in others[ALIKE - 1 :]}
    return found


def _why_worthless(operator: RelationOperator, table: RelationOperators) -> str | None:
    if operator.trials < MIN_TRIALS:
        return f"fewer than {MIN_TRIALS} rehearsals"
    if operator.promise is None:
        return "never carries its target to the reference"
    state = table.state_named(operator.promise.state)
    if not state.bears:
        return "ends in a state in which the reference bears nothing"
    if state.leans:
        return "makes its target lean"
    if operator.promise.share < SELDOM:
        return f"keeps its promise in {operator.promise.count} of {operator.trials} rehearsals only"
    return None


def nearest_share(share: float) -> float:
    """Return the nearest of `SHARES`."""
    return min(SHARES, key=lambda one: abs(one - share))


# What carries objects to places, and how that turns out where objects rest on one another

_UNTRIED = Kept("never", 0, 0)
_NEVER = 0.01  # as how rare counts what was never seen


@lru_cache(maxsize=8)
def carriers_of(grounding: Grounding) -> tuple[Operator, ...]:
    """List the operators of the domain that carry objects to places, by name.

    Args:
        grounding: The learned domain.
    """
    if grounding.places is None:
        return ()
    every = grounding.places.operators.operators
    worthy = (one for one in every if grounding.why_left_out(one) is None)
    return tuple(sorted(worthy, key=lambda one: one.name))


def carriers_for(item: SceneObject, grounding: Grounding, tolerance: float) -> tuple[Operator, ...]:
    """List the operators that carry an object to places, as they promise for it, the surest first.

    How sure they are counts what rehearsals beside others showed, since a scene may hold others.

    Args:
        item: The object.
        grounding: The learned domain.
        tolerance: How near an outcome must come to the promise to have kept it [m].
    """
    of_item = promised(grounding, item, tolerance)
    found = [of_item[one.name] for one in carriers_of(grounding) if one.category == item.category]
    fit = [one for one in found if one.successes >= LEAST_CHANCE * one.trials and one.successes]
    beside = {one.name: one.share for one in grounding.places.beside} if grounding.places else {}
    costs = {one.name: step_cost(one, grounding) / (beside.get(one.name, 1.0) or _NEVER) for one in fit}
    return tuple(sorted(fit, key=lambda one: (costs[one.name], one.name)))


@dataclass(frozen=True, slots=True)
class Carrier:
    """What was seen of stacks with an operator that carries objects to places.

    Attributes:
        borne: How it turned out where the object rested on another one.
        laden: How it turned out where another one rested on the object.
    """

    borne: Kept
    laden: Kept

    @property
    def takes_borne(self) -> bool:
        """Whether the object may rest on another one; where that was never tried it may."""
        return self.borne.share >= LEAST_SHARE

    @property
    def takes_laden(self) -> bool:
        """Whether another object may rest on it; where that was never tried it may not."""
        return bool(self.laden.trials) and self.laden.share >= LEAST_SHARE

    def cost(self, operator: Operator, grounding: Grounding, *, borne: bool) -> int:
        """Return what a step costs.

        Args:
            operator: The operator as it promises for the object.
            grounding: The learned domain.
            borne: Whether the object rests on another one.
        """
        usual = step_cost(operator, grounding)
        if not (borne and self.borne.trials) or grounding.unit_costs:
            return usual
        kept = smoothed(self.borne.kept, self.borne.trials)
        return usual + round(max(0.0, -100 * math.log(kept / chance(operator))))


def relational_carriers(grounding: Grounding) -> Mapping[str, Carrier]:
    """Return what was seen of stacks with the operators that carry objects to places, by name."""
    if (places := grounding.places) is None:
        return {}
    borne, laden = ({one.name: one for one in table or ()} for table in (places.borne, places.laden))
    return {
        one.name: Carrier(borne.get(one.name, _UNTRIED), laden.get(one.name, _UNTRIED))
        for one in carriers_of(grounding)
    }
