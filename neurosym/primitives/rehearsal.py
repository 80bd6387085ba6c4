"""Rehearsal: actions are performed on sampled objects of each category, to measure what they really do.

What a code does on average in the data is not what its distilled action does: plans are made with the
rehearsed effects. Outcomes that differ in kind (at rest, held, toppled, lost) are kept apart as modes and
never averaged together, since the mean of "on the table" and "in the air" is a place where no object ever is.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from itertools import compress

import msgspec
import numpy as np

from neurosym.checks import (
    Bool,
    Float,
    check_all,
    check_array,
    check_count,
    check_kind,
    check_seed,
    check_whole,
)
from neurosym.contract import made
from neurosym.data.category_names import name_categories
from neurosym.errors import InvalidValue, Progress, part
from neurosym.operators import (
    TABLE_FORMAT,
    TOLERANCE,
    Categorise,
    Category,
    Company,
    Effect,
    Kept,
    Mode,
    Operator,
    OperatorTable,
    Primitive,
    Rehearsal,
    Symbol,
    all_symbols,
    name_operator,
)
from neurosym.primitives.ledger import Ledger
from neurosym.primitives.reliability import judge, performance
from neurosym.primitives.sampling import (
    Repertoire,
    Sample,
    perform_each,
    sample_by_category,
    shared_by_all,
    tasks_of,
)
from neurosym.primitives.search import REHEARSED, Search
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
        """Return what a primitive did to the objects of a category."""
        return tuple(outcome for _, outcome in self._on(symbol, number))

    def served(self, symbol: Symbol, number: int) -> Float[np.ndarray, "P F"]:
        """Return the features of the objects of a category that a primitive was performed on."""
        return self.features[[row for row, _ in self._on(symbol, number)]]

    def _on(self, symbol: Symbol, number: int) -> list[tuple[int, Outcome]]:
        found = ((row, self.outcomes[number][row]) for row in np.flatnonzero(self.symbols == symbol).tolist())
        return [(row, outcome) for row, outcome in found if outcome is not None]


def rehearse(
    world_factory: WorldFactory,
    primitives: Repertoire | Sequence[Primitive],
    categorise: Categorise,
    *,
    objects: int = 100,
    seed: int,
    workers: int = 1,
    ledger: Ledger | None = None,
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
        ledger: What performs, with workers of its own, and knows what was performed before.
        progress: Called after each rehearsal.

    Raises:
        InvalidValue: If there is no object or no primitive to rehearse with.
    """
    if not isinstance(primitives, Repertoire):
        check_all("primitives", primitives, Primitive, "primitives, as distill or choose returns them")
        primitives = shared_by_all(primitives)
    check_seed(seed)
    check_whole("objects", objects)
    given = primitives.primitives
    if objects < 1 or not given:
        raise InvalidValue(f"Nothing can be rehearsed with {objects} objects and {len(given)} primitives.")
    check_count("workers", workers)
    world = made(world_factory)
    for primitive in given:
        if len(primitive.action) != len(world.action_box.low):
            raise InvalidValue(
                f"The primitive {primitive.label} has {len(primitive.action)} action parameters; the "
                f"{world.name} world takes {len(world.action_box.low)}."
            )
    sample = rehearsal_sample(world, categorise, objects=objects, seed=seed)
    drawn = [(symbol, scene) for symbol, members in sample.scenes.items() for scene in members]
    places = [place for members in sample.scenes.values() for place in range(len(members))]
    usual = max(primitives.times.values(), default=len(drawn))
    served = [
        [
            primitives.serves(one, symbol)
            and place < primitives.times.get((symbol, one.label), usual)
            and primitives.fits(one, scene)
            for (symbol, scene), place in zip(drawn, places, strict=True)
        ]
        for one in given
    ]
    scenes = [scene for _, scene in drawn]
    tasks = [tasks_of(one, compress(scenes, row)) for one, row in zip(given, served, strict=True)]
    by = Ledger(workers=workers) if ledger is None else ledger
    performed = map(iter, perform_each(by, world_factory, tasks, REHEARSED, progress))
    outcomes = tuple(
        tuple(next(done) if performs else None for performs in row)
        for row, done in zip(served, performed, strict=True)
    )
    features = np.concatenate([scene.features for scene in scenes])
    return Rehearsals(given, features, np.array([symbol for symbol, _ in drawn]), outcomes, sample.shares)


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
    shares = {str(symbol): rehearsals.share(symbol) for symbol in np.unique(rehearsals.symbols)}
    categories = describe_categories(rehearsals.features, rehearsals.symbols, feature_names, shares)
    found = []
    for number, primitive in enumerate(rehearsals.primitives):
        for category in categories:
            if not (outcomes := rehearsals.on(category.symbol, number)):
                continue
            modes, served = modes_of(outcomes), rehearsals.served(category.symbol, number)
            operator = Operator(
                name=name_operator(primitive.label, category.name, modes),
                subject=category.symbol,
                primitive=primitive.symbol,
                trials=len(outcomes),
                outcomes=modes,
                variant=primitive.variant,
                rehearsals=tuple(map(rehearsal_of, outcomes)),
                objects=() if len(served) == len(category.objects) else tuple(map(rounded, served)),
            )
            found.append((operator, judge([*map(performance, outcomes)]).sureness))
        if progress is not None:
            progress(number + 1, len(rehearsals.primitives))
    found.sort(key=lambda one: (one[0].primitive, one[0].subject, -one[1], one[0].variant))
    operators = tuple(operator for operator, _ in found)
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

    Effects are those at the end of the rise [m], resting effects those once everything is put down [m].
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


def rehearsal_of(outcome: Outcome) -> Rehearsal:
    """Keep of an outcome what operators remember."""
    (peak_height,), turn = rounded([outcome.peak_height]), round(outcome.turn, _TURN_DIGITS)
    return Rehearsal(
        outcome.kind, rounded(outcome.effect), rounded(outcome.resting_effect), peak_height, turn
    )


def describe_categories(
    features: Float[np.ndarray, "N F"],
    symbols: np.ndarray,
    feature_names: Sequence[str],
    shares: Mapping[Symbol, float] | None = None,
) -> tuple[Category, ...]:
    """Describe and name the categories, in the order of their symbols.

    A symbol that no object has is called `unseen`: problems may meet one later, and nothing is known of it.

    If the shares of categories are given, these are the objects that were rehearsed on, and are kept.
    """
    present = sorted(set(symbols.tolist()))
    members = [features[symbols == symbol] for symbol in present]
    seen = {
        symbol: Category(
            symbol=symbol,
            name=name,
            share=len(rows) / len(features) if shares is None else shares[symbol],
            feature_means=tuple(rows.mean(0).tolist()),
            feature_spreads=tuple(rows.std(0).tolist()),
            objects=() if shares is None else tuple(map(rounded, rows)),
        )
        for symbol, name, rows in zip(
            present, name_categories(present, members, feature_names), members, strict=True
        )
    }
    return tuple(
        seen.get(symbol) or Category(symbol, f"unseen-{symbol}", 0.0, (), ())
        for symbol in all_symbols(len(present[0]))
    )


def rounded(values: Iterable[float]) -> Effect:
    """Round lengths [m], or types, to the digits that are kept, without a negative zero."""
    return tuple(round(float(value), _DIGITS) + 0.0 for value in values)


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
_POOLED = 12  # how many objects of all categories these are chosen from, for each that is rehearsed on
_APART = 0.5  # objects nearer than this tell much the same, in spreads of the features
_UNSURE_STREAM = 0x756E  # keeps these draws apart from those of other rehearsals


@dataclass(slots=True, eq=False)
class _Revision:
    """An operator as it is so far, with objects of its category; it was not rehearsed on the free ones."""

    operator: Operator
    category: Category
    scenes: tuple[Scene, ...]
    features: Float[np.ndarray, "P F"]
    free: Bool[np.ndarray, "P"]

    def unsure(self, count: int) -> list[int]:
        """Choose so many objects at most that the rehearsals say least of, none of them like another."""
        chances = chances_of(self.operator, self.category, self.features)
        if chances is None:
            return []
        variance = np.where(self.free, chances * (1 - chances), 0.0)
        scale = np.maximum(self.features.std(0), 1e-3)
        chosen: list[int] = []
        while len(chosen) < count and variance.max() >= UNSURE:
            best = int(np.argmax(variance))
            chosen.append(best)
            apart = ((self.features - self.features[best]) / scale) ** 2
            variance *= 1 - 0.5 * np.exp(-apart.sum(1) / (2 * _APART**2))
            variance[best] = 0.0
        return chosen

    def remember(self, numbers: list[int], outcomes: Sequence[Outcome]) -> None:
        """Add to the operator what was seen of some objects."""
        if not numbers:
            return
        known = rehearsed_objects(self.operator, self.category)
        objects = (*known, *(rounded(self.features[number]) for number in numbers))
        rows = (*self.operator.rehearsals, *map(rehearsal_of, outcomes))
        self.operator = msgspec.structs.replace(self.operator, objects=objects, rehearsals=rows)
        self.free[numbers] = False


def rehearse_unsure(search: Search, table: OperatorTable, share: float = 1.0) -> OperatorTable:
    """Rehearse operators on objects for which it is unsure whether their promise is kept.

    The other rehearsals come first, and are those that trials and modes count: their objects are drawn as
    the world draws them.

    Args:
        search: What the operators were found with.
        table: The operators.
        share: Of what is left of the budget, that these rehearsals take at most.
    """
    most = int(SHARE * search.objects)
    if not most or not search.left:
        return table
    typical = _POOLED * search.objects
    sample = partial(sample_by_category, made(search.shown), search.categorise, least=1, typical=typical)
    pools = {
        symbol: (scenes, np.concatenate([scene.features for scene in scenes]))
        for symbol, scenes in sample(seed=search.seed, stream=_UNSURE_STREAM).scenes.items()
    }
    categories = {one.symbol: one for one in table.categories}
    actions = {one.label: one for one in table.primitives}
    revised = {
        place: _Revision(one, categories[one.subject], *pool, np.ones(len(pool[0]), dtype=bool))
        for place, one in enumerate(table.operators)
        if (pool := pools.get(one.subject))
    }
    done = 0
    with search.open_bar("rehearsing what is unsure") as advance:
        for rounds_left in range(ROUNDS, 0, -1):
            count = min(most, int(share * search.left) // (rounds_left * max(1, len(revised))))
            chosen = [(one, one.unsure(count)) for one in revised.values()]
            tasks = [
                tasks_of(actions[one.operator.label], [one.scenes[number] for number in numbers])
                for one, numbers in chosen
            ]
            performed = perform_each(search.ledger, search.shown, tasks, REHEARSED, part(advance, done))
            done += sum(map(len, tasks))
            for (one, numbers), outcomes in zip(chosen, performed, strict=True):
                one.remember(numbers, outcomes)
    operators = tuple(
        revised[place].operator if place in revised else one for place, one in enumerate(table.operators)
    )
    return msgspec.structs.replace(table, operators=operators)


# Rehearsing operators that carry where there are other objects: beside the target, or on the place

MARGIN = 0.06
"""How far inside the edge of the table the places of rehearsals lie, lest what is held askew be lost [m]."""
# Rehearsals of an operator with another object on the place, and with others beside the target.
_AMONG_OTHERS = 20
GAP = 0.04
"""How far apart the target and the object on the place are at least [m]."""
_LEVEL = 0.01  # what stands higher than it did stands on something else [m]
_OTHERS_STREAM, _BESIDE = 0x6F63, 0x6273  # keep these draws apart from those of other rehearsals


def rehearse_among_others(search: Search, table: OperatorTable) -> OperatorTable:
    """Rehearse operators with another object on the place, and with others close around the target.

    That says whether the place must be free, and whether others are left alone.
    """
    aimed, crowded = (kind(search.world_factory, MARGIN) for kind in (AimedFactory, CrowdedFactory))
    world, rng = aimed(), np.random.default_rng([search.seed, _OTHERS_STREAM])
    worthy = sum(bool(one.successes) for one in table.operators)
    least = min(_AMONG_OTHERS, search.left // (2 * worthy)) if worthy else 0
    if not least:
        return _at_places(table, {}, {})
    sample = partial(sample_by_category, categorise=search.categorise, least=least, seed=search.seed)
    on_place = {
        symbol: [one for scene in members if (one := _occupied(scene, world.sample_scene(rng, 1)))]
        for symbol, members in sample(world, stream=_OTHERS_STREAM).scenes.items()
    }
    around = sample(crowded(), stream=_BESIDE).scenes

    def kept(
        how: Company, label: str, factory: WorldFactory, scenes: Mapping[Symbol, Sequence[Scene]]
    ) -> dict[str, tuple[tuple[Company, Kept], ...]]:
        """Rehearse operators that ever carry, and count what went as promised, by their names."""
        actions = {one.label: one for one in table.primitives}
        worthy = [one for one in table.operators if one.successes and scenes.get(one.subject)]
        tasks = [tasks_of(actions[one.label], scenes[one.subject]) for one in worthy]
        with search.open_bar(label) as advance:
            ended = perform_each(search.ledger, factory, tasks, REHEARSED, advance)
        return {
            one.name: ((how, Kept(one.name, len(ends), sum(_stands_there(one, end) for end in ends))),)
            for one, ends in zip(worthy, ended, strict=True)
        }

    occupied = kept("occupied", "rehearsing on occupied places", aimed, on_place)
    beside = kept("beside", "rehearsing among neighbours", crowded, around)
    return _at_places(table, occupied, beside)


_Kept = Mapping[str, tuple[tuple[Company, Kept], ...]]


def _at_places(table: OperatorTable, occupied: _Kept, beside: _Kept) -> OperatorTable:
    """Say that operators lead to places, and how often they kept their promise among others."""
    operators = tuple(
        msgspec.structs.replace(
            one, frame="place", company=occupied.get(one.name, ()) + beside.get(one.name, ())
        )
        for one in table.operators
    )
    return msgspec.structs.replace(table, operators=operators)


def _occupied(scene: Scene, other: Scene) -> AimedScene | None:
    """Put another object on the place that a scene is aimed at; None if it would stand in the target."""
    assert isinstance(scene, AimedScene), "drawn from a world in which actions are aimed"
    centre = np.array([[scene.reference.x, scene.reference.y, other.positions[0, 2]]])
    room = (scene.features[0, :2] + other.features[0, :2]) / 2
    if np.all(np.abs(scene.positions[0, :2] - centre[0, :2]) < room + GAP):
        return None
    every = joined([scene, replace(other, positions=centre)])
    return AimedScene(
        every.features, every.positions, every.orientations, scene.reference, unseen=every.unseen
    )


def _stands_there(operator: Operator, outcome: Outcome) -> bool:
    """Say whether a target was carried as promised, onto the table, and nothing else was moved."""
    assert operator.promise is not None, "it has successes"
    away, up = outcome.resting_effect - operator.promise.outcome, outcome.resting_effect[2]
    is_near = float(np.linalg.norm(away[:2])) <= TOLERANCE
    return outcome.kind == "carried" and is_near and abs(float(up)) <= _LEVEL and not outcome.disturbed
