"""Choosing actions for kinds of pairs: for each state, a few that together bring as many pairs there as can.

No action does the same to all pairs of a kind. A network foresees what each candidate does to each pair. The
candidate that brings most pairs into a state comes first, then the one that adds most to it, while that is
worth it: kinds that are met often get more actions than rare ones. For each of these there is a contest on
the pairs that it adds. Candidates are listed by what is foreseen of them, and auditioned on them, fewer
of them in each round; what was foreseen counts beside what was seen. The surest is left. Where nothing brings
a kind into a state, there is no operator.
"""

from collections import Counter
from collections.abc import Collection, Sequence
from dataclasses import dataclass
from functools import partial

import msgspec
import numpy as np

from neurosym.checks import Float
from neurosym.contract import made
from neurosym.operators import Categorise, Category, Primitive, Symbol, name_categories, symbols_of
from neurosym.pair_operators import (
    SELDOM,
    Kept,
    PairEnd,
    PairStates,
    RelationOperator,
    RelationOperators,
    touching_units,
)
from neurosym.primitives.audition import Contest, Round, audition_in_rounds, moved
from neurosym.primitives.rehearsal import Rehearsals, Search, rounded
from neurosym.primitives.reliability import end_state, sureness, watch
from neurosym.primitives.sampling import Repertoire, perform_each, sample_by_category, tasks_of, with_own
from neurosym.world import ActionBox, OtherObject, Outcome, Scene
from neurosym.worlds.aims import TARGET, RelatedFactory, RelatedScene, as_pair, taken

ROUNDS = Round(4, 4), Round(2, 6)
"""Auditions of one contest."""
OF_A_KIND = 64
"""Pairs of a kind that are looked at, to find which can be brought into a state, and by what."""
WORTH = 0.002
"""An action beyond the first for a kind and a state adds this share or more of all pairs, of whatever kind,
that can be brought there."""
OF_SYMBOL = 4
"""Candidates of one symbol that are shortlisted for a kind of pairs and a state at most."""
LEAST = 0.1
"""Actions that are foreseen, or that turn out, to bring about a state less surely are left out for it."""
FORESEEN_COUNTS = 10
"""What is foreseen of an action counts as much as so many performances: few tell little of rare outcomes."""
_CHOICE_STREAM = 0x7063  # keeps these draws apart from those of other auditions and rehearsals


@dataclass(slots=True, eq=False)
class _OfState(Contest):
    """The candidates for some pairs of one kind, and one state.

    Attributes:
        state: Code of the state.
        foreseen: How surely each candidate brings these pairs into the state, as foreseen.
        few: Those that are left, the surest first.
    """

    state: str
    foreseen: dict[Primitive, float]
    few: list[Primitive]

    def left(self) -> list[Primitive]:
        return self.few

    def most_left(self, candidates: int) -> int:
        return min(candidates, len(self.few))

    def close_round(self, kept: int) -> None:
        sure = {one: self._sureness(one) for one in self.few}
        ranked = sorted((one for one in self.few if sure[one] >= LEAST), key=lambda one: -sure[one])
        self.few = ranked[:kept]

    def won(self) -> list[Primitive]:
        """Return those that are left and that were seen to do it."""
        return [one for one in self.few if sureness(self.seen[one], self.state) > 0]

    def _sureness(self, one: Primitive) -> float:
        seen = self.seen[one]
        weighed = len(seen) * sureness(seen, self.state) + FORESEEN_COUNTS * self.foreseen[one]
        return weighed / (len(seen) + FORESEEN_COUNTS)


def choose_for_pairs(search: Search, states: PairStates) -> Repertoire:
    """Choose for each kind of pairs the actions that most surely bring it into each state.

    States in which targets lean are left out.

    Args:
        search: What there is to choose from; the chances of the states that bear are predicted, in their
            order.
        states: The states of pairs.
    """
    world = made(search.shown)
    sample = sample_by_category(
        world, search.categorise, least=OF_A_KIND, seed=search.seed, stream=_CHOICE_STREAM
    )
    foreseen = {kind: _foreseen(search, scenes, world.action_box) for kind, scenes in sample.scenes.items()}
    contests: dict[Symbol, list[_OfState]] = {kind: [] for kind in foreseen}
    for state in states.straight:
        column = states.bearing.index(state)
        of_state = {kind: chances[:, :, column] for kind, chances in foreseen.items()}
        reach = sum(sample.shares[kind] * chances.max(0).mean() for kind, chances in of_state.items())
        for kind, chances in of_state.items():
            worth = float(WORTH * reach / sample.shares[kind])
            contests[kind] += _contests(search.candidates, chances, sample.scenes[kind], state, worth)
    every = [contest for of_kind in contests.values() for contest in of_kind]
    with search.open_bar("auditioning for each kind of pairs") as advance:
        audition_in_rounds(search, every, ROUNDS, search.shown, partial(watch, states=states), advance)
    chosen = {
        kind: list(dict.fromkeys(one for contest in of_kind for one in contest.won()))
        for kind, of_kind in contests.items()
    }
    return with_own(_one_each(search.candidates), chosen)


def _foreseen(search: Search, scenes: Sequence[Scene], box: ActionBox) -> Float[np.ndarray, "C N S"]:
    """Foresee what each candidate does to each pair."""
    features = np.concatenate([scene.features for scene in scenes])
    actions = np.concatenate([moved(one, len(features), box, search.seed) for one in search.candidates])
    foreseen = np.clip(search.predict(np.tile(features, (len(search.candidates), 1)), actions), 0.0, 1.0)
    return foreseen.reshape(len(search.candidates), len(features), -1)


def _contests(
    candidates: Sequence[Primitive],
    chances: Float[np.ndarray, "C N"],
    scenes: Sequence[Scene],
    state: str,
    worth: float,
) -> list[_OfState]:
    """Begin contests for a kind and a state: on those pairs first of which most can be brought there.

    A further action adds so much to the mean chance, at least, that it is worth it.
    """
    begun, known = list[_OfState](), np.zeros(len(scenes))
    while True:
        gains = np.maximum(chances - known, 0.0)
        best = int(gains.mean(1).argmax())
        if begun and gains[best].mean() <= worth:
            return begun
        pairs = np.sort(np.argsort(-gains[best], kind="stable")[: sum(one.objects for one in ROUNDS)])
        mean = chances[:, pairs].mean(1)
        likely = [number for number in np.argsort(-mean, kind="stable") if mean[number] >= LEAST]
        few = _few_of_a_symbol([candidates[number] for number in likely])[: ROUNDS[0].candidates]
        of_pairs = {one: float(sure) for one, sure in zip(candidates, mean, strict=True) if one in few}
        begun.append(_OfState(tuple(scenes[row] for row in pairs), state, of_pairs, few))
        known = np.maximum(known, chances[best])


def _few_of_a_symbol(candidates: Sequence[Primitive]) -> list[Primitive]:
    """Return the first candidates of each symbol, in the same order."""
    taken = Counter[str]()
    few = []
    for one in candidates:
        taken[one.symbol] += 1
        if taken[one.symbol] <= OF_SYMBOL:
            few.append(one)
    return few


def _one_each(candidates: Sequence[Primitive]) -> list[Primitive]:
    """Return of each symbol the candidate that encodes to it best; it names the others of the symbol."""
    best: dict[str, Primitive] = {}
    for one in candidates:
        if one.symbol not in best or one.code_error < best[one.symbol].code_error:
            best[one.symbol] = one
    return [best[symbol] for symbol in sorted(best)]


# Rehearsals on pairs: into which states operators bring them, and where others rest on them already

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
    states = table
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
