"""Choosing actions for kinds of pairs: for each state, a few that together bring as many pairs there as can.

No action does the same to all pairs of a kind. A network foresees what each candidate does to each pair. The
candidate that brings most pairs into a state comes first, then the one that adds most to it, while that is
worth it: kinds that are met often get more actions than rare ones. For each of these there is a contest on
the pairs that it adds. Candidates are listed by what is foreseen of them, and auditioned on them, fewer
of them in each round; what was foreseen counts beside what was seen. The surest is left. Where nothing brings
a kind into a state, there is no operator.
"""

from collections import Counter
from collections.abc import Sequence
from typing import Any

import msgspec
import numpy as np

from neurosym.checks import Float
from neurosym.contract import made
from neurosym.data.category_names import name_categories
from neurosym.operators import (
    Categorise,
    Category,
    Company,
    Kept,
    Mode,
    Operator,
    Primitive,
    Symbol,
    symbols_of,
)
from neurosym.pair_operators import (
    SELDOM,
    PairStates,
    RelationOperators,
    pair_end,
    touching_units,
)
from neurosym.primitives.audition import moved
from neurosym.primitives.bandit import LEAST_GAIN, Contest, hold
from neurosym.primitives.rehearsal import Rehearsals, rehearsal_sample, rounded
from neurosym.primitives.reliability import Judgement, end_state, sureness, watch
from neurosym.primitives.sampling import (
    Repertoire,
    Sample,
    perform_each,
    sample_by_category,
    tasks_of,
    with_own,
)
from neurosym.primitives.search import REHEARSED, Search
from neurosym.world import OtherObject, Outcome, Scene
from neurosym.worlds.aims import TARGET, RelatedFactory, RelatedScene, as_pair, taken

CANDIDATES, PAIRS = 4, 12
"""How many actions one contest is among at most, and on how many pairs each performs at most."""
_OF_A_KIND = 64  # pairs of a kind that are looked at, to find which can be brought into a state, and by what
WORTH = 0.002
"""An action beyond the first for a kind and a state adds this share or more of all pairs, of whatever kind,
that can be brought there."""
_OF_SYMBOL = 4  # candidates of one symbol that are shortlisted for a kind of pairs and a state at most
LEAST = 0.1
"""Actions that are foreseen, or that turn out, to bring about a state less surely are left out for it."""
# What is foreseen of an action counts as much as so many performances: few tell little of rare outcomes.
_FORESEEN_COUNTS = 10
_ALONE = 0.7  # share of what is left that rehearses pairs; the rest rehearses among others
_CHOICE_STREAM = 0x7063  # keeps these draws apart from those of other auditions and rehearsals


def choose_for_pairs(search: Search, states: PairStates) -> Repertoire:
    """Choose for each kind of pairs the actions that most surely bring it into each state.

    States in which targets lean are left out. The chances of the states that bear are predicted, in their
    order.
    """
    box, candidates = made(search.shown).action_box, search.candidates
    sample = sample_by_category(
        made(search.shown), search.categorise, least=_OF_A_KIND, seed=search.seed, stream=_CHOICE_STREAM
    )
    foreseen = {}
    for kind, scenes in sample.scenes.items():
        features = np.concatenate([scene.features for scene in scenes])
        actions = np.concatenate([moved(one, len(features), box, search.seed) for one in candidates])
        chances = np.clip(search.predict(np.tile(features, (len(candidates), 1)), actions), 0.0, 1.0)
        foreseen[kind] = chances.reshape(len(candidates), len(features), -1)  # (C, N, S)
    contests: list[tuple[Symbol, str, Contest]] = []
    for state in states.straight:
        column = states.bearing.index(state)
        of_state = {kind: chances[:, :, column] for kind, chances in foreseen.items()}
        reach = sum(sample.shares[kind] * chances.max(0).mean() for kind, chances in of_state.items())
        for kind, chances in of_state.items():
            worth = float(WORTH * reach / sample.shares[kind])
            begun = _contests(candidates, chances, sample, kind, states, state, worth)
            contests += [(kind, state, contest) for contest in begun]
    contests.sort(key=lambda one: [*foreseen].index(one[0]))
    every = [contest for *_, contest in contests]
    with search.open_bar("auditioning for each kind of pairs") as advance:
        perform = search.performer(search.shown, advance)
        hold(every, perform, budget=search.for_choosing, least=LEAST_GAIN)
    chosen: dict[Symbol, list[Primitive]] = {kind: [] for kind in foreseen}
    for kind, _, contest in contests:
        for one in contest.best(1.0):
            if one not in chosen[kind] and contest.judged(one).sureness >= LEAST:
                chosen[kind].append(one)
    best: dict[str, Primitive] = {}  # of each symbol what encodes to it best; it names the others
    for one in sorted(candidates, key=lambda one: (one.symbol, one.code_error)):
        best.setdefault(one.symbol, one)
    pairs = rehearsal_sample(
        made(search.shown), search.categorise, objects=search.objects, seed=search.seed
    ).scenes
    own = [(kind, one) for kind, ones in chosen.items() for one in ones]
    seen = [len(search.ledger.recall(tasks_of(one, pairs.get(kind, [])))) for kind, one in own]
    enough = search.affordable(seen, [len(pairs.get(kind, [])) for kind, _ in own], _ALONE)
    times = {pair: max(count, enough) for pair, count in zip(own, seen, strict=True)}
    return with_own([*best.values()], chosen, times)


def _contests(
    candidates: Sequence[Primitive],
    chances: Float[np.ndarray, "C N"],
    sample: Sample,
    kind: Symbol,
    states: PairStates,
    state: str,
    worth: float,
) -> list[Contest]:
    """Begin contests for a kind and a state: on those pairs first of which most can be brought there.

    A further action adds so much to the mean chance, at least, that it is worth it.
    """
    scenes, nowhere = sample.scenes[kind], np.zeros(4)
    begun, known = list[Contest](), np.zeros(len(scenes))

    def judge(outcomes: Sequence[Outcome]) -> Judgement:
        return Judgement("carried", nowhere, sureness([watch(one, states) for one in outcomes], state))

    while True:
        gains = np.maximum(chances - known, 0.0)
        best = int(gains.mean(1).argmax())
        if begun and gains[best].mean() <= worth:
            return begun
        pairs = np.sort(np.argsort(-gains[best], kind="stable")[:PAIRS])
        mean = chances[:, pairs].mean(1)
        counts, few = Counter[Symbol](), dict[Primitive, Judgement]()
        for number in np.argsort(-mean, kind="stable").tolist():
            one = candidates[number]
            if mean[number] >= LEAST and counts[one.symbol] < _OF_SYMBOL and len(few) < CANDIDATES:
                counts[one.symbol] += 1
                few[one] = Judgement("carried", nowhere, float(mean[number]))
        share = sample.shares[kind] * float(gains[best].mean())
        some = [scenes[row] for row in pairs]
        begun.append(Contest(share, some, [[*few]], few, judge, _FORESEEN_COUNTS))
        known = np.maximum(known, chances[best])


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
    """
    kinds = _kinds(rehearsals, feature_names)
    names = {state.symbol: state.name for state in states.states}
    operators = []
    for number, primitive in enumerate(rehearsals.primitives):
        for kind in kinds:
            if not (outcomes := rehearsals.on(kind.symbol, number)):
                continue
            ends = _ends(outcomes, states)
            carried = [end for end in ends if end.is_promising]
            often = [e.kind for e in carried[1:] if e.kind in states.straight and e.share >= SELDOM]
            usual = carried[0].kind if carried else ""
            for state in (usual, *often):
                name = f"{names.get(state, 'miss')}-by-{primitive.label}-{kind.name}"
                promised = None if state == usual else state
                told = name, kind.symbol, primitive.symbol, len(outcomes), ends, promised, primitive.variant
                operators.append(Operator(*told, frame="pair"))
    return RelationOperators(states.states, states.scales, kinds, rehearsals.primitives, tuple(operators))


def rehearse_among(search: Search, table: RelationOperators, rehearsals: Rehearsals) -> RelationOperators:
    """Rehearse operators where a third object is borne, or bears, as earlier rehearsals left it.

    These begin from the ends of others.
    """
    rng = np.random.default_rng([search.seed, _STREAM])
    ends = [
        outcome.end
        for row in rehearsals.outcomes
        for outcome in row
        if outcome is not None and len(outcome.end) > 2 and end_state(outcome, table) in table.bearing
    ]
    pool = _pool([ends[number] for number in rng.permutation(len(ends))], search.categorise)
    worthy = {one.name: one for one in table.operators if one.promise and one.promise.kind in table.straight}
    primitives = {one.label: one for one in table.primitives}
    motions = dict.fromkeys((one.subject, one.label) for one in worthy.values())
    keys = [(*motion, how) for motion in motions for how in pool]
    most = min(AMONG, search.left // max(1, len(keys)))
    tasks = [tasks_of(primitives[label], pool[how].get(pair, [])[:most]) for pair, label, how in keys]
    factory = RelatedFactory(search.world_factory)
    with search.open_bar("rehearsing where pairs bear others") as advance:
        ended = perform_each(search.ledger, factory, tasks, REHEARSED, advance)
        performed = dict(zip(keys, ended, strict=True))

    def kept(one: Operator, how: Company) -> tuple[Company, Kept]:
        outcomes, asked = performed[one.subject, one.label, how], one.promise and one.promise.kind
        good = [end for end in outcomes if end_state(end, table) == asked and _left(end, how)]
        return how, Kept(one.name, len(outcomes), len(good))

    operators = (
        msgspec.structs.replace(one, company=tuple(kept(one, how) for how in pool if one.name in worthy))
        for one in table.operators
    )
    return msgspec.structs.replace(table, operators=tuple(operators))


def _left(outcome: Outcome, how: str) -> bool:
    """Say whether others were left alone, and what rested on the target stands to it as it did before."""
    if how != "laden":
        return not outcome.disturbed
    before, after = (touching_units(scene, _THIRD, TARGET) for scene in (outcome.start, outcome.end))
    goes_along = bool(np.abs(after - before).max() < _ALIKE)
    return goes_along and {index for index, _ in outcome.disturbed} <= {_THIRD}


def _pool(ends: Sequence[Scene], categorise: Categorise) -> dict[Company, dict[Symbol, list[RelatedScene]]]:
    """Gather pairs of each kind in which a third object plays a part.

    In each of the scenes the first object rests on the second; the third is a bystander.
    """
    orders: dict[Company, tuple[int, ...]] = {"borne": (0, 2, 1), "occupied": (2, 1, 0), "laden": (1, 2, 0)}
    pool: dict[Company, dict[Symbol, list[RelatedScene]]] = {how: {} for how in orders}
    for how, order in orders.items():
        scenes = [as_pair(taken(end, [*order, *range(3, len(end))])) for end in ends]
        if scenes:
            kinds = symbols_of(categorise, np.concatenate([scene.features for scene in scenes]))
            for kind, scene in zip(kinds, scenes, strict=True):
                pool[how].setdefault(kind, []).append(scene)
    return pool


def _ends(outcomes: Sequence[Outcome], states: PairStates) -> tuple[Mode, ...]:
    """Sort what happened by the state that pairs ended in; what moved others counts as a miss."""
    found: dict[str, list[np.ndarray]] = {}
    for outcome in outcomes:
        assert isinstance(outcome.reference, OtherObject), "aimed at another object"
        where = touching_units(outcome.end, outcome.target, outcome.reference.index)
        found.setdefault("" if outcome.disturbed else end_state(outcome, states), []).append(where)
    ends = []
    for state, rows in sorted(found.items(), key=lambda one: (-len(one[1]), one[0])):
        where = np.array(rows if state else np.zeros((1, 3)))
        told: Any = rounded(where.mean(0)), rounded(where.std(0))
        ends.append(pair_end(state, len(rows), len(rows) / len(outcomes), *told))
    return tuple(ends)


def _kinds(rehearsals: Rehearsals, feature_names: Sequence[str]) -> tuple[Category, ...]:
    """Describe the kinds of pairs; their names say what the target and the reference mostly are."""
    symbols = sorted(set(rehearsals.symbols.tolist()))
    members = [rehearsals.features[rehearsals.symbols == symbol] for symbol in symbols]
    width = len(feature_names)
    halves = [
        name_categories(symbols, [rows[:, part] for rows in members], feature_names)
        for part in (slice(width), slice(width, None))
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
