"""Rehearsing what carries objects with pairs: into which states it brings them, alone and among others.

What carries an object to a place carries it onto or into another one, too: that stands at a place. So each
kind of pairs gets what most surely carries its targets to places, aimed such that these end over the middle
of the reference. How that turns out depends on both: they fit or do not. Rehearsals say how often a kind of
pairs ends in which state, and teach the network that foresees it of the pair at hand.
"""

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import islice
from typing import Any

import msgspec
import numpy as np

from neurosym.checks import Float
from neurosym.contract import made
from neurosym.data.category_names import name_categories
from neurosym.errors import InvalidValue
from neurosym.operators import (
    Categorise,
    Category,
    Company,
    Kept,
    Mode,
    Operator,
    OperatorTable,
    Primitive,
    Symbol,
    labelled,
    symbols_of,
)
from neurosym.pair_operators import SELDOM, PairStates, RelationOperators, pair_end, touching_units
from neurosym.primitives.rehearsal import Rehearsals, rehearsal_sample, rounded
from neurosym.primitives.reliability import end_state
from neurosym.primitives.sampling import Repertoire, perform_each, tasks_of, with_own
from neurosym.primitives.search import REHEARSED, Search
from neurosym.tasks.pasts import LEAST_CHANCE
from neurosym.tasks.promises import carrying_with, set_over
from neurosym.world import OtherObject, Outcome, Scene
from neurosym.worlds.aims import TARGET, RelatedScene, as_pair, taken
from neurosym.worlds.workers import Task

RANKS = 2
"""So many of what carries a category are tried with pairs, the surest first."""
_OF_KIND = 0.25  # a category is tried with a kind of pairs if it is so large a share of its targets
_ALONE = 0.7  # share of what is left that rehearses pairs; the rest rehearses among others


@dataclass(frozen=True)
class Carriers:
    """What carries objects to places, as it is aimed at other objects."""

    places: OperatorTable  # what carries objects to places
    categorise: Categorise  # gives the object symbols of features
    # gives actions their symbols among those that are aimed at other objects
    encode: Callable[[Float[np.ndarray, "N A"]], tuple[Primitive, ...]]

    def __call__(
        self, action: Float[np.ndarray, "A"], features: Float[np.ndarray, "F"]
    ) -> Float[np.ndarray, "A"]:
        """Aim an action over the middle of another object, for a target of these features; see `set_over`."""
        (category,) = symbols_of(self.categorise, features[None])
        return set_over(self.places, action.tolist(), category, tuple(features.tolist()))

    def fits(self, primitive: Primitive, scene: Scene) -> bool:
        """Say whether an action is known to carry the target of a pair."""
        assert isinstance(scene, RelatedScene), "drawn from a world in which actions are aimed at objects"
        (category,) = symbols_of(self.categorise, scene.whole.features[[TARGET]])
        return any(one.subject == category for one in carrying_with(self.places, primitive.action))

    def of(self, category: Symbol) -> tuple[Primitive, ...]:
        """Return what carries a category most surely, as primitives that are aimed at other objects."""
        known = [
            one
            for one in self.places.operators
            if one.subject == category
            and one.promise
            and one.promise.kind == "carried"
            and one.successes >= LEAST_CHANCE * one.trials
        ]
        surest = sorted(known, key=lambda one: (-one.chance, one.name))[:RANKS]
        actions = [labelled(self.places.primitives, one.label).action for one in surest]
        return self.encode(np.array(actions)) if actions else ()


def carriers_for_pairs(search: Search, carriers: Carriers) -> Repertoire:
    """Choose for each kind of pairs what carries its targets.

    Raises:
        InvalidValue: If nothing carries any.
    """
    pairs = rehearsal_sample(
        made(search.shown), search.categorise, objects=search.objects, seed=search.seed
    ).scenes
    chosen = dict[Symbol, list[Primitive]]()
    for kind, scenes in pairs.items():
        targets = np.array([scene.whole.features[TARGET] for scene in scenes])  # type: ignore[attr-defined]
        counts = Counter(symbols_of(carriers.categorise, targets))
        often = [one for one, count in counts.most_common() if count >= _OF_KIND * len(scenes)]
        chosen[kind] = [primitive for category in often for primitive in carriers.of(category)]
    own = [(kind, one) for kind, some in chosen.items() for one in some]
    if not own:
        raise InvalidValue("Nothing carries objects to places, so nothing can be put on others.")
    seen = [len(search.ledger.recall(tasks_of(one, pairs[kind]))) for kind, one in own]
    enough = search.affordable(seen, [len(pairs[kind]) for kind, _ in own], _ALONE)
    times = {pair: max(count, enough) for pair, count in zip(own, seen, strict=True)}
    shared: dict[Symbol, Primitive] = {}
    for _, one in own:
        shared.setdefault(one.symbol, one)
    return replace(with_own([*shared.values()], chosen, times), fits=carriers.fits)


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


def rehearse_among(
    search: Search, table: RelationOperators, rehearsals: Rehearsals, carriers: Carriers
) -> RelationOperators:
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

    def tasks_among(pair: Symbol, label: str, how: Company) -> list[Task]:
        fit = (one for one in pool[how].get(pair, []) if carriers.fits(primitives[label], one))
        return tasks_of(primitives[label], islice(fit, most))

    tasks = [tasks_among(*key) for key in keys]
    with search.open_bar("rehearsing where pairs bear others") as advance:
        ended = perform_each(search.ledger, search.shown, tasks, REHEARSED, advance)
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
