"""Rehearsals on pairs: into which states operators bring them, and where others rest on them already."""

from collections.abc import Collection, Sequence

import msgspec
import numpy as np

from neurosym.naming import name_categories
from neurosym.operators import Category
from neurosym.pair_states import touching_units
from neurosym.place_operators import Kept
from neurosym.primitives.judging import end_state
from neurosym.primitives.performing import perform_each, tasks_of
from neurosym.primitives.rehearsal import Rehearsals, rounded
from neurosym.primitives.search import Search
from neurosym.relation_operators import SELDOM, PairEnd, PairStates, RelationOperator, RelationOperators
from neurosym.symbols import Categorise, Symbol, symbols_of
from neurosym.table import OtherObject
from neurosym.world import Outcome, Scene
from neurosym.worlds.related import TARGET, RelatedFactory, RelatedScene, as_pair, taken

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


def rehearse_among(search: Search, table: RelationOperators, rehearsals: Rehearsals) -> RelationOperators:
    """Rehearse operators where a third object is borne, or bears, as earlier rehearsals left it.

    Args:
        search: What they were found with.
        table: The operators.
        rehearsals: Those whose ends are begun from.
    """
    states = PairStates(table.states, table.scales)
    rng = np.random.default_rng([search.seed, _STREAM])
    ends = [
        outcome.end
        for row in rehearsals.outcomes
        for outcome in row
        if outcome is not None and len(outcome.end) > 2 and end_state(outcome, states) in states.bearing
    ]
    pool = _pool([ends[number] for number in rng.permutation(len(ends))], search.categorise)
    worthy = {
        one.name: one for one in table.operators if one.promise and one.promise.state in states.straight
    }
    primitives = {one.label: one for one in table.primitives}
    keys = [(*key, how) for key in {(one.pair, one.label): None for one in worthy.values()} for how in pool]
    tasks = [tasks_of(primitives[label], pool[how].get(pair, [])[:AMONG]) for pair, label, how in keys]
    factory = RelatedFactory(search.world_factory)
    with search.open_bar("rehearsing where pairs bear others") as advance:
        performed = dict(zip(keys, perform_each(factory, tasks, search.workers, advance), strict=True))

    def kept(one: RelationOperator, how: str) -> Kept:
        if one.name not in worthy or one.promise is None:
            return Kept(one.name, 0, 0)
        outcomes = performed[one.pair, one.label, how]
        good = [end for end in outcomes if end_state(end, states) == one.promise.state and _left(end, how)]
        return Kept(one.name, len(outcomes), len(good))

    operators = (
        msgspec.structs.replace(one, **{how: kept(one, how) for how in pool}) for one in table.operators
    )
    return msgspec.structs.replace(table, operators=tuple(operators))


def _left(outcome: Outcome, how: str) -> bool:
    """Say whether others were left alone, and what rested on the target went along."""
    if how != "laden":
        return not outcome.disturbed
    return {index for index, _ in outcome.disturbed} <= {_THIRD} and _went_along(outcome)


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


def _ends(outcomes: Sequence[Outcome], states: PairStates) -> tuple[PairEnd, ...]:
    """Sort what happened by the state that pairs ended in; what moved others counts as a miss."""
    found: dict[str, list[np.ndarray]] = {}
    for outcome in outcomes:
        assert isinstance(outcome.reference, OtherObject), "aimed at another object"
        where = touching_units(outcome.end, outcome.target, outcome.reference.index)
        found.setdefault("" if outcome.disturbed else end_state(outcome, states), []).append(where)
    nowhere = np.zeros((1, 3))
    return tuple(
        PairEnd(
            state,
            len(rows),
            len(rows) / len(outcomes),
            rounded(np.array(rows if state else nowhere).mean(0)),  # type: ignore[arg-type]
            rounded(np.array(rows if state else nowhere).std(0)),  # type: ignore[arg-type]
        )
        for state, rows in sorted(found.items(), key=lambda one: (-len(one[1]), one[0]))
    )


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
