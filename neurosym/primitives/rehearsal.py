"""Rehearsal: actions are performed on sampled objects of each category, to measure what they really do.

What a code does on average in the data is not what its distilled action does: plans are made with the
rehearsed effects. Outcomes that differ in kind (at rest, held, toppled, lost) are kept apart as modes and
never averaged together, since the mean of "on the table" and "in the air" is a place where no object ever is.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import compress
from typing import Any

import msgspec
import numpy as np

from neurosym.checks import Float, check_all, check_array, check_count, check_kind, check_seed, check_whole
from neurosym.contract import made
from neurosym.errors import InvalidValue, OpenBar, Progress, part, silent
from neurosym.operators import (
    TABLE_FORMAT,
    TOLERANCE,
    Categorise,
    Category,
    Effect,
    Mode,
    Operator,
    OperatorTable,
    Primitive,
    Rehearsal,
    Symbol,
    all_symbols,
    name_categories,
    name_operator,
)
from neurosym.pair_operators import Kept, PlaceOperators
from neurosym.primitives.reliability import PredictOutcomes, judge, performance
from neurosym.primitives.sampling import (
    Repertoire,
    Sample,
    perform_each,
    sample_by_category,
    shared_by_all,
    tasks_of,
)
from neurosym.tasks.promises import chances_of, rehearsed_objects
from neurosym.world import Outcome, OutcomeKind, Scene, World, WorldFactory
from neurosym.worlds.aims import AimedFactory, AimedScene, CrowdedFactory, joined

LEAST = 30
"""Objects of a category that are rehearsed on, however rare it is, if at least so many are asked for."""
_STREAM = 0x7265  # keeps rehearsal's draws apart from those of exploration
_TURN_DIGITS = 3  # of what is kept of rehearsals [rad]
_DIGITS = 5  # of lengths that are kept [m]


@dataclass(frozen=True, slots=True, eq=False)
class Rehearsals:
    """Actions performed on sampled objects of the categories that they serve.

    Attributes:
        primitives: In the order of their symbols.
        features: Features of the objects.
        symbols: Symbol of each object.
        outcomes: For each primitive, an outcome for each object; None where it was not performed.
        shares: Share of each category among objects as the world draws them; None if these are drawn so.
    """

    primitives: tuple[Primitive, ...]
    features: Float[np.ndarray, "M F"]
    symbols: np.ndarray
    outcomes: tuple[tuple[Outcome | None, ...], ...]
    shares: Mapping[Symbol, float] | None = None

    def __post_init__(self) -> None:
        check_all("primitives", self.primitives, Primitive, "a tuple of Primitive")
        check_array("features", self.features, (None, None))
        rows = len(self.features)
        if np.shape(self.symbols) != (rows,) or len(self.outcomes) != len(self.primitives):
            raise InvalidValue("Rehearsals need a symbol for each object, and outcomes for each primitive.")
        if any(len(row) != rows for row in self.outcomes):
            raise InvalidValue("Rehearsals need for each primitive an outcome for each object.")

    def share(self, symbol: Symbol) -> float:
        """Return the share of a category among objects as the world draws them."""
        return float(np.mean(self.symbols == symbol)) if self.shares is None else self.shares[symbol]

    def on(self, symbol: Symbol, number: int) -> tuple[Outcome, ...]:
        """Return what a primitive did to the objects of a category.

        Args:
            symbol: Of the category.
            number: Of the primitive, counted from 0.
        """
        row = self.outcomes[number]
        found = (row[i] for i in np.flatnonzero(self.symbols == symbol))
        return tuple(outcome for outcome in found if outcome is not None)


def rehearse(
    world_factory: WorldFactory,
    primitives: Repertoire | Sequence[Primitive],
    categorise: Categorise,
    *,
    objects: int = 100,
    seed: int,
    workers: int = 1,
    progress: Progress | None = None,
) -> Rehearsals:
    """Perform actions on sampled objects of the categories that they serve, one at a time.

    The objects of a category are the same for all actions: as many as there are among the first so many that
    the world draws, or `LEAST` if that is more.

    Args:
        world_factory: Builds the world; must survive pickling if there is more than one worker.
        primitives: What to perform, and on what; primitives alone are performed on every category.
        categorise: Gives the object symbols of features.
        objects: How many objects are sampled, not counting those that rare categories get in addition.
        seed: Where all draws start.
        workers: How many processes; their number does not change the result.
        progress: Called after each rehearsal.

    Raises:
        InvalidValue: If there is no object or no primitive to rehearse with.
    """
    repertoire = primitives if isinstance(primitives, Repertoire) else None
    if repertoire is None:
        check_all("primitives", primitives, Primitive, "primitives, as distill or choose returns them")
        repertoire = shared_by_all(primitives)  # type: ignore[arg-type]  # checked above
    check_seed(seed)
    check_whole("objects", objects)
    if objects < 1 or not repertoire.primitives:
        raise InvalidValue(
            f"Nothing can be rehearsed with {objects} objects and {len(repertoire.primitives)} primitives."
        )
    check_count("workers", workers)
    world = made(world_factory)
    for primitive in repertoire.primitives:
        if len(primitive.action) != len(world.action_box.low):
            raise InvalidValue(
                f"The primitive {primitive.label} has {len(primitive.action)} action parameters; the "
                f"{world.name} world takes {len(world.action_box.low)}."
            )
    sample = rehearsal_sample(world, categorise, objects=objects, seed=seed)
    scenes = [scene for members in sample.scenes.values() for scene in members]
    symbols = [symbol for symbol, members in sample.scenes.items() for _ in members]
    served = [
        [repertoire.serves(primitive, symbol) for symbol in symbols] for primitive in repertoire.primitives
    ]
    tasks = [
        tasks_of(primitive, compress(scenes, row))
        for primitive, row in zip(repertoire.primitives, served, strict=True)
    ]
    performed = map(iter, perform_each(world_factory, tasks, workers, progress))
    outcomes = tuple(
        tuple(next(done) if performs else None for performs in row)
        for row, done in zip(served, performed, strict=True)
    )
    features = np.concatenate([scene.features for scene in scenes])
    return Rehearsals(repertoire.primitives, features, np.array(symbols), outcomes, sample.shares)


def tabulate(
    rehearsals: Rehearsals, feature_names: Sequence[str], *, progress: Progress | None = None
) -> OperatorTable:
    """Tell what each primitive did to each category.

    If a symbol has two actions for a category, the operator of the surer one comes first.

    Args:
        rehearsals: What happened.
        feature_names: What the features are.
        progress: Called after each primitive.

    Raises:
        InvalidValue: If there are not as many names as features.
    """
    check_kind("rehearsals", rehearsals, Rehearsals, "Rehearsals, as rehearse returns them")
    check_all("feature_names", feature_names, str, "a name for each feature")
    if len(feature_names) != rehearsals.features.shape[1]:
        raise InvalidValue(
            f"There are {len(feature_names)} feature_names; objects have {rehearsals.features.shape[1]} "
            "features."
        )
    symbols = rehearsals.symbols
    shares = {str(symbol): rehearsals.share(symbol) for symbol in np.unique(symbols)}
    categories = describe_categories(rehearsals.features, symbols, feature_names, shares)
    found = []
    for number, primitive in enumerate(rehearsals.primitives):
        for category in categories:
            if outcomes := rehearsals.on(category.symbol, number):
                sureness = judge([performance(outcome) for outcome in outcomes]).sureness
                found.append((sureness, _operator(primitive, category, outcomes)))
        if progress is not None:
            progress(number + 1, len(rehearsals.primitives))
    found.sort(key=lambda one: (one[1].primitive, one[1].category, -one[0], one[1].variant))
    operators = tuple(operator for _, operator in found)
    return OperatorTable(categories, rehearsals.primitives, operators, format=TABLE_FORMAT)


def rehearsal_sample(world: World, categorise: Categorise, *, objects: int, seed: int) -> Sample:
    """Draw the objects of each category that actions are rehearsed on.

    Args:
        world: Where they come from.
        categorise: Gives the object symbols of features.
        objects: How many are sampled, not counting those that rare categories get in addition.
        seed: Where all draws start.
    """
    least = min(LEAST, objects)
    return sample_by_category(world, categorise, least=least, typical=objects, seed=seed, stream=_STREAM)


def modes_of(outcomes: Sequence[Outcome] | Sequence[Rehearsal]) -> tuple[Mode, ...]:
    """Sort outcomes of one primitive on objects of one category into modes, most frequent first."""
    return sort_into_modes(
        [outcome.kind for outcome in outcomes],
        np.array([outcome.effect for outcome in outcomes]),  # (N, 3)
        np.array([outcome.resting_effect for outcome in outcomes]),
        np.array([outcome.peak_height for outcome in outcomes]),
    )


def sort_into_modes(
    kinds: Sequence[OutcomeKind],
    effects: Float[np.ndarray, "N E"],
    resting_effects: Float[np.ndarray, "N E"],
    peak_heights: Float[np.ndarray, "N"],
) -> tuple[Mode, ...]:
    """Sort outcomes into modes, most frequent first.

    Args:
        kinds: How each outcome ended.
        effects: Displacements at the end of the rise [m].
        resting_effects: Displacements once everything is put down [m].
        peak_heights: Greatest heights on the way [m].
    """
    ended, modes = np.array(kinds), []
    for kind in dict.fromkeys(kinds):
        rows = ended == kind
        judged = (effects if kind == "held" else resting_effects)[rows]
        distances = np.linalg.norm(judged - judged.mean(0), axis=1)
        mode = Mode(
            kind=kind,
            count=int(rows.sum()),
            share=int(rows.sum()) / len(kinds),
            effect=tuple(effects[rows].mean(0).tolist()),
            spread=tuple(effects[rows].std(0).tolist()),
            resting_effect=tuple(resting_effects[rows].mean(0).tolist()),
            resting_spread=tuple(resting_effects[rows].std(0).tolist()),
            peak_height=float(peak_heights[rows].mean()),
            near_mean=int(np.sum(distances <= TOLERANCE)),
        )
        modes.append(mode)
    return tuple(sorted(modes, key=lambda mode: (-mode.count, mode.kind)))


def _operator(primitive: Primitive, category: Category, outcomes: Sequence[Outcome]) -> Operator:
    modes = modes_of(outcomes)
    return Operator(
        name=name_operator(primitive.label, category.name, modes),
        category=category.symbol,
        primitive=primitive.symbol,
        trials=len(outcomes),
        modes=modes,
        variant=primitive.variant,
        rehearsals=tuple(rehearsal_of(outcome) for outcome in outcomes),
    )


def rehearsal_of(outcome: Outcome) -> Rehearsal:
    """Keep of an outcome what operators remember.

    Args:
        outcome: What happened.
    """
    (peak_height,) = rounded(np.array([outcome.peak_height]))
    return Rehearsal(
        outcome.kind,
        rounded(outcome.effect),
        rounded(outcome.resting_effect),
        peak_height,
        round(outcome.turn, _TURN_DIGITS),
    )


def describe_categories(
    features: Float[np.ndarray, "N F"],
    symbols: np.ndarray,
    feature_names: Sequence[str],
    shares: Mapping[Symbol, float] | None = None,
) -> tuple[Category, ...]:
    """Describe and name the categories, in the order of their symbols.

    A symbol that no object has is called `unseen`: problems may meet one later, and nothing is known of it.

    Args:
        features: Features of the objects.
        symbols: Symbol of each object.
        feature_names: What the features are.
        shares: Share of each category, if these are the objects that it was rehearsed on; they are kept then.
    """
    present = sorted(set(symbols.tolist()))
    members = [features[symbols == symbol] for symbol in present]
    means = np.array([_means_for_naming(rows, feature_names) for rows in members])
    names = name_categories(present, means, feature_names)
    seen = {
        symbol: Category(
            symbol=symbol,
            name=name,
            share=len(rows) / len(features) if shares is None else shares[symbol],
            feature_means=tuple(rows.mean(0).tolist()),
            feature_spreads=tuple(rows.std(0).tolist()),
            objects=() if shares is None else tuple(rounded(row) for row in rows),
        )
        for symbol, name, rows in zip(present, names, members, strict=True)
    }
    return tuple(
        seen.get(symbol) or Category(symbol, f"unseen-{symbol}", 0.0, (), ())
        for symbol in all_symbols(len(present[0]))
    )


def _means_for_naming(rows: Float[np.ndarray, "N F"], feature_names: Sequence[str]) -> np.ndarray:
    """Average features, where a type counts as hollow or not, however it is open."""
    is_type = np.array(feature_names) == "t"
    return np.asarray(np.where(is_type, rows >= 0.5, rows).mean(0))


def rounded(values: Float[np.ndarray, "N"]) -> Effect:
    """Round to the digits that are kept, without a negative zero.

    Args:
        values: Lengths [m], or types.
    """
    return tuple(round(float(value), _DIGITS) + 0.0 for value in values)


# A search for operators: what there is to choose from, and how it goes on for what actions are aimed at


@dataclass(frozen=True, slots=True, eq=False)
class Search:
    """What operators are chosen from, and measured with.

    Attributes:
        candidates: Distilled actions.
        predict: A network without a bottleneck on the same data, which shortlists.
        features: What it can be asked about: of the objects of the data.
        categorise: Gives the object symbols of features.
        world_factory: Builds the world; must survive pickling if there is more than one worker.
        shown: Builds it as it is shown: every action in it is aimed.
        seed: Where all draws start.
        objects: How many objects each symbol is rehearsed on, not counting those added for rare categories.
        workers: How many processes; their number does not change the result.
        open_bar: Shows how far each part has come.
    """

    candidates: tuple[Primitive, ...]
    predict: PredictOutcomes
    features: Float[np.ndarray, "M F"]
    categorise: Categorise
    world_factory: WorldFactory
    shown: WorldFactory
    seed: int
    objects: int = 100
    workers: int = 1
    open_bar: OpenBar = silent


@dataclass(frozen=True, slots=True)
class Method:
    """How operators are found for what actions are aimed at.

    Attributes:
        adapt: Has every action in a world aimed so.
        choose: Chooses among the candidates.
        measure: Tells from the rehearsals of what was chosen what each operator does; rehearses it further.
    """

    adapt: Callable[[WorldFactory], WorldFactory]
    choose: Callable[[Search], Repertoire]
    measure: Callable[[Search, Rehearsals], Any]


# Rehearsing where an outcome is unsure: on more of those objects that may turn out either way.
#
# A hand of 14 cm holds what is 126 mm wide and nothing that is wider. Objects as the world draws them leave
# gaps where outcomes turn, so plans hope for what never comes. So each operator is rehearsed once more on
# objects of which its rehearsals say least, and again after that: uncertainty sampling (Lewis and Gale,
# 1994).

ROUNDS = 3
"""How often operators are rehearsed again."""
SHARE = 0.16
"""How many objects each time at most, as a share of those that every operator is rehearsed on."""
UNSURE = 0.09
"""Least variance of an outcome that is worth a rehearsal: of one that comes in 10 to 90 % of all cases."""
POOLED = 12
"""How many objects of all categories these are chosen from, for each that is rehearsed on."""
_APART = 0.5  # objects nearer than this tell much the same, in spreads of the features
_UNSURE_STREAM = 0x756E  # keeps these draws apart from those of other rehearsals


@dataclass(frozen=True, slots=True, eq=False)
class _Pool:
    """Objects of one category that operators may be rehearsed on.

    Attributes:
        category: The category.
        scenes: One of them in each.
        features: Their features.
    """

    category: Category
    scenes: tuple[Scene, ...]
    features: Float[np.ndarray, "P F"]


def rehearse_unsure(search: Search, table: OperatorTable) -> OperatorTable:
    """Rehearse operators on objects for which it is unsure whether their promise is kept.

    The other rehearsals come first, and are those that trials and modes count: their objects are drawn as
    the world draws them.

    Args:
        search: What the operators were found with.
        table: Operators, with their rehearsals.
    """
    if not (count := int(SHARE * search.objects)):
        return table
    sample = sample_by_category(
        made(search.shown),
        search.categorise,
        least=1,
        typical=POOLED * search.objects,
        seed=search.seed,
        stream=_UNSURE_STREAM,
    )
    pools = {
        one.symbol: _Pool(one, scenes, np.concatenate([scene.features for scene in scenes]))
        for one in table.categories
        if (scenes := sample.scenes.get(one.symbol))
    }
    primitives = {one.label: one for one in table.primitives}
    operators, done = list(table.operators), 0
    pool_of = {place: pools[one.category] for place, one in enumerate(operators) if one.category in pools}
    free = {place: np.ones(len(pool.scenes), dtype=bool) for place, pool in pool_of.items()}
    with search.open_bar("rehearsing what is unsure") as advance:
        for _ in range(ROUNDS):
            chosen = {
                place: _unsure(operators[place], pool, free[place], count) for place, pool in pool_of.items()
            }
            tasks = [
                tasks_of(primitives[operators[place].label], [pool_of[place].scenes[n] for n in numbers])
                for place, numbers in chosen.items()
            ]
            performed = perform_each(search.shown, tasks, search.workers, part(advance, done))
            done += sum(map(len, tasks))
            for (place, numbers), outcomes in zip(chosen.items(), performed, strict=True):
                rows = tuple(map(rehearsal_of, outcomes))
                operators[place] = _with_rows(operators[place], pool_of[place], numbers, rows)
                free[place][numbers] = False
    return msgspec.structs.replace(table, operators=tuple(operators))


def _with_rows(operator: Operator, pool: _Pool, numbers: list[int], rows: tuple[Rehearsal, ...]) -> Operator:
    """Add to an operator what was seen of some objects of a pool."""
    if not numbers:
        return operator
    known = rehearsed_objects(operator, pool.category)
    objects = (*known, *(rounded(pool.features[number]) for number in numbers))
    return msgspec.structs.replace(operator, objects=objects, rehearsals=(*operator.rehearsals, *rows))


def _unsure(operator: Operator, pool: _Pool, free: np.ndarray, count: int) -> list[int]:
    """Choose the objects that an operator's rehearsals say least of, none of them like another.

    Args:
        operator: The operator.
        pool: The objects to choose from.
        free: Which of these it was not rehearsed on.
        count: How many are chosen at most.
    """
    chances = chances_of(operator, pool.category, pool.features)
    if chances is None:
        return []
    variance = np.where(free, chances * (1 - chances), 0.0)
    scale = np.maximum(pool.features.std(0), 1e-3)
    chosen: list[int] = []
    while len(chosen) < count and variance.max() >= UNSURE:
        best = int(np.argmax(variance))
        chosen.append(best)
        apart = ((pool.features - pool.features[best]) / scale) ** 2
        variance *= 1 - 0.5 * np.exp(-apart.sum(1) / (2 * _APART**2))
        variance[best] = 0.0
    return chosen


# Rehearsing operators that carry where there are other objects: beside the target, or on the place

MARGIN = 0.06
"""How far inside the edge of the table the places of rehearsals lie, lest what is held askew be lost [m]."""
AMONG_OTHERS = 20
"""Rehearsals of an operator with another object on the place, and with others beside the target."""
GAP = 0.04
"""How far apart the target and the object on the place are at least [m]."""
_LEVEL = 0.01  # what stands higher than it did stands on something else [m]
_OTHERS_STREAM, _BESIDE = 0x6F63, 0x6273  # keep these draws apart from those of other rehearsals


def rehearse_among_others(search: Search, table: OperatorTable) -> PlaceOperators:
    """Rehearse operators with another object on the place, and with others close around the target.

    That says whether the place must be free, and whether others are left alone.

    Args:
        search: What they were found with.
        table: The operators.
    """
    factory = AimedFactory(search.world_factory, MARGIN)
    world, rng = factory(), np.random.default_rng([search.seed, _OTHERS_STREAM])
    sample = partial(sample_by_category, categorise=search.categorise, least=AMONG_OTHERS, seed=search.seed)
    drawn = {
        symbol: [_occupied(scene, world.sample_scene(rng, 1)) for scene in members]
        for symbol, members in sample(world, stream=_OTHERS_STREAM).scenes.items()
    }
    on_place = {symbol: [one for one in among if one is not None] for symbol, among in drawn.items()}
    crowded = CrowdedFactory(search.world_factory, MARGIN)
    around = sample(crowded(), stream=_BESIDE).scenes
    with search.open_bar("rehearsing on occupied places") as advance:
        occupied = _kept(factory, table, on_place, search.workers, advance)
    with search.open_bar("rehearsing among neighbours") as advance:
        beside = _kept(crowded, table, around, search.workers, advance)
    return PlaceOperators(operators=table, occupied=occupied, beside=beside)


def _kept(
    factory: WorldFactory,
    table: OperatorTable,
    scenes: Mapping[Symbol, Sequence[Scene]],
    workers: int,
    progress: Progress | None,
) -> tuple[Kept, ...]:
    """Rehearse operators that ever carry in scenes for their category, and count what went as promised."""
    primitives = {one.label: one for one in table.primitives}
    worthy = [one for one in table.operators if one.successes and scenes.get(one.category)]
    tasks = [tasks_of(primitives[one.label], scenes[one.category]) for one in worthy]
    ended = zip(worthy, perform_each(factory, tasks, workers, progress), strict=True)
    return tuple(
        Kept(one.name, len(ends), sum(_stands_there(one, end) for end in ends)) for one, ends in ended
    )


def _occupied(scene: Scene, other: Scene) -> AimedScene | None:
    """Put another object on the place that a scene is aimed at; None if it would stand in the target."""
    assert isinstance(scene, AimedScene), "drawn from a world in which actions are aimed"
    centre = np.array([[scene.reference.x, scene.reference.y, other.positions[0, 2]]])
    room = (scene.features[0, :2] + other.features[0, :2]) / 2
    if np.all(np.abs(scene.positions[0, :2] - centre[0, :2]) < room + GAP):
        return None
    every = joined([scene, Scene(other.features, centre, other.orientations)])
    return AimedScene(every.features, every.positions, every.orientations, scene.reference)


def _stands_there(operator: Operator, outcome: Outcome) -> bool:
    """Say whether a target was carried as promised, onto the table, and nothing else was moved."""
    assert operator.promise is not None, "it has successes"
    away, up = outcome.resting_effect - operator.promise.outcome, outcome.resting_effect[2]
    is_near = float(np.linalg.norm(away[:2])) <= TOLERANCE
    return outcome.kind == "carried" and is_near and abs(float(up)) <= _LEVEL and not outcome.disturbed
