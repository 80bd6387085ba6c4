"""Rehearsals on pairs: into which states operators bring them, and where others rest on them already."""

from collections import Counter
from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass

import msgspec
import numpy as np

from neurosym.naming import name_categories
from neurosym.operators import Category
from neurosym.pair_states import touching_units
from neurosym.place_operators import Kept
from neurosym.primitives.by_state import end_state
from neurosym.primitives.categories import rounded
from neurosym.primitives.performing import perform
from neurosym.primitives.rehearsal import Rehearsals
from neurosym.progress import Progress
from neurosym.relation_operators import SELDOM, PairEnd, PairStates, RelationOperator, RelationOperators
from neurosym.symbols import Categorise, Symbol, symbols_of
from neurosym.table import OtherObject
from neurosym.world import Outcome, Scene, WorldFactory
from neurosym.worlds.related import TARGET, RelatedScene, as_pair, taken
from neurosym.worlds.workers import Task

AMONG = 12
"""Rehearsals of an operator at most where something rests on target or reference, or bears the target."""
_THIRD = 2  # the object that bears, or is borne
_ALIKE = 0.3  # what moved along is off by no more [touching units]
_STREAM = 0x7061  # keeps these draws apart from those of other rehearsals


def tabulate_pairs(
    rehearsals: Rehearsals, feature_names: Sequence[str], states: PairStates
) -> RelationOperators:
    """Tell into which states each primitive brought pairs of each kind.

    Where some pairs of a kind come to bear their targets in one way and some in another, there is an operator
    for each; how often it turned out so says how sure it is.

    Args:
        rehearsals: What happened.
        feature_names: What the features of one object are.
        states: The states of pairs.
    """
    kinds = _kinds(rehearsals, feature_names)
    names = {state.symbol: state.name for state in states.states}
    operators = []
    for number, primitive in enumerate(rehearsals.primitives):
        for kind in kinds:
            if not (outcomes := rehearsals.on(kind.symbol, number)):
                continue
            ends = _ends(outcomes, states)
            usual, *others = _promised(ends, states.straight) or [""]
            for state in (usual, *others):
                name = f"{names.get(state, 'miss')}-by-{primitive.label}-{kind.name}"
                untried = Kept(name, 0, 0)
                operators.append(
                    RelationOperator(
                        name,
                        kind.symbol,
                        primitive.symbol,
                        len(outcomes),
                        ends,
                        borne=untried,
                        occupied=untried,
                        laden=untried,
                        variant=primitive.variant,
                        promised="" if state == usual else state,
                    )
                )
    return RelationOperators(states.states, states.scales, kinds, rehearsals.primitives, tuple(operators))


def rehearse_among(
    factory: WorldFactory,
    table: RelationOperators,
    rehearsals: Rehearsals,
    categorise: Categorise,
    *,
    seed: int,
    workers: int = 1,
    progress: Progress | None = None,
) -> RelationOperators:
    """Rehearse operators where a third object is borne, or bears, as earlier rehearsals left it.

    Args:
        factory: Builds the world in which actions are aimed at other objects.
        table: The operators.
        rehearsals: Those whose ends are begun from.
        categorise: Gives the kinds of pairs of features.
        seed: Where all draws start.
        workers: How many processes; their number does not change the result.
        progress: Called after each rehearsal.
    """
    states = PairStates(table.states, table.scales)
    bearing = states.bearing
    rng = np.random.default_rng([seed, _STREAM])
    ends = [
        outcome.end
        for row in rehearsals.outcomes
        for outcome in row
        if outcome is not None and len(outcome.end) > 2 and end_state(outcome, states) in bearing
    ]
    pool = _pool([ends[number] for number in rng.permutation(len(ends))], categorise)
    worthy = [
        one for one in table.operators if one.promise is not None and one.promise.state in states.straight
    ]
    tasks, owners = list[Task](), list[tuple[Symbol, str, str]]()
    for pair, label in dict.fromkeys((one.pair, one.label) for one in worthy):
        action = np.array(next(one.action for one in table.primitives if one.label == label))
        for how, scenes in pool.items():
            for scene in scenes.get(pair, [])[:AMONG]:
                tasks.append(Task(scene, action))
                owners.append((pair, label, how))
    ended = Counter[tuple[Symbol, str, str, str]]()
    for owner, outcome in zip(owners, perform(factory, tasks, workers, progress), strict=True):
        others = {index for index, _ in outcome.disturbed} - ({_THIRD} if owner[-1] == "laden" else set())
        if not others and (owner[-1] != "laden" or _went_along(outcome)):
            ended[(*owner, end_state(outcome, states))] += 1
    tried = Counter(owners)

    def kept(one: RelationOperator, how: str) -> Kept:
        if one not in worthy or one.promise is None:
            return Kept(one.name, 0, 0)
        owner = one.pair, one.label, how
        return Kept(one.name, tried[owner], ended[(*owner, one.promise.state)])

    return msgspec.structs.replace(
        table,
        operators=tuple(
            msgspec.structs.replace(one, **{how: kept(one, how) for how in pool}) for one in table.operators
        ),
    )


def _pool(ends: Sequence[Scene], categorise: Categorise) -> dict[str, dict[Symbol, list[RelatedScene]]]:
    """Gather pairs of each kind in which a third object plays a part.

    In each of the scenes the first object rests on the second; the third is a bystander.

    Args:
        ends: Such scenes.
        categorise: Gives the kinds of pairs of features.
    """
    orders = {"borne": (0, 2, 1), "occupied": (2, 1, 0), "laden": (1, 2, 0)}
    pool: dict[str, dict[Symbol, list[RelatedScene]]] = {how: {} for how in orders}
    for how, order in orders.items():
        scenes = [as_pair(taken(end, [*order, *range(3, len(end))])) for end in ends]
        if scenes:
            kinds = symbols_of(categorise, np.concatenate([scene.features for scene in scenes]))
            for kind, scene in zip(kinds, scenes, strict=True):
                pool[how].setdefault(kind, []).append(scene)
    return pool


def _went_along(outcome: Outcome) -> bool:
    """Say whether the third object stands to the target in the end as it did before."""
    before, after = (touching_units(scene, _THIRD, TARGET) for scene in (outcome.start, outcome.end))
    return bool(np.abs(after - before).max() < _ALIKE)


def _promised(ends: Sequence[PairEnd], straight: Collection[str]) -> list[str]:
    """List the states promised: the most frequent, and others in which targets are often borne straight."""
    carried = [end for end in ends if end.state]
    often = (end for end in carried[1:] if end.state in straight and end.share >= SELDOM)
    return [end.state for end in (*carried[:1], *often)]


@dataclass(frozen=True, slots=True)
class _End:
    """How one rehearsal ended."""

    state: str
    where: tuple[float, float, float]


def _ends(outcomes: Sequence[Outcome], states: PairStates) -> tuple[PairEnd, ...]:
    """Sort what happened by the state that pairs ended in; what moved others counts as a miss."""
    found = [*_found(outcomes, states)]
    counts = Counter(end.state for end in found)
    rows = {state: np.array([end.where for end in found if end.state == state]) for state in counts}
    return tuple(
        PairEnd(
            state,
            count,
            count / len(found),
            rounded(rows[state].mean(0)) if state else (0.0, 0.0, 0.0),  # type: ignore[arg-type]
            rounded(rows[state].std(0)) if state else (0.0, 0.0, 0.0),  # type: ignore[arg-type]
        )
        for state, count in sorted(counts.items(), key=lambda one: (-one[1], one[0]))
    )


def _found(outcomes: Sequence[Outcome], states: PairStates) -> Iterator[_End]:
    for outcome in outcomes:
        assert isinstance(outcome.reference, OtherObject), "aimed at another object"
        x, y, z = touching_units(outcome.end, outcome.target, outcome.reference.index).tolist()
        yield _End("" if outcome.disturbed else end_state(outcome, states), (x, y, z))


def _kinds(rehearsals: Rehearsals, feature_names: Sequence[str]) -> tuple[Category, ...]:
    """Describe the kinds of pairs; their names say what the target and the reference mostly are."""
    symbols = sorted(set(rehearsals.symbols.tolist()))
    members = [rehearsals.features[rehearsals.symbols == symbol] for symbol in symbols]
    means = np.array([np.where(_is_type(feature_names), rows >= 0.5, rows).mean(0) for rows in members])
    width, bare = len(feature_names), list(symbols)
    halves = [
        name_categories(bare, means[:, part], feature_names) for part in (slice(width), slice(width, None))
    ]
    return tuple(
        Category(
            symbol,
            f"{target.removesuffix(f'-{symbol}')}-to-{reference}",
            rehearsals.share(symbol),
            tuple(rows.mean(0).tolist()),
            tuple(rows.std(0).tolist()),
        )
        for symbol, target, reference, rows in zip(symbols, *halves, members, strict=True)
    )


def _is_type(feature_names: Sequence[str]) -> np.ndarray:
    return np.array([name == "t" for name in feature_names] * 2)
