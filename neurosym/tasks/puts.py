"""What the encoding `relational` is printed from: operators on pairs, what they ask, and what they cost.

What an operator asks is what its rehearsals showed. Where a third object on the reference, on the target, or
under it spoiled more than half of what goes well otherwise, that is forbidden. Else it is allowed, and costs
what it showed.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

from neurosym.grounding import MIN_TRIALS, Grounding
from neurosym.operators import Category
from neurosym.place_operators import Kept
from neurosym.pooled_puts import FAINT, pooled
from neurosym.problems import Problem
from neurosym.promises import LEAST_CHANCE
from neurosym.related import relating
from neurosym.relation_goals import pair_key
from neurosym.relation_operators import SELDOM, PairEnd, PairState, RelationOperator, RelationOperators
from neurosym.symbols import Symbol
from neurosym.tasks.moves import price, smoothed

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
