"""Rehearsal: each primitive is performed on the same sampled objects, to measure what it really does.

What a code does on average in the data is not what its distilled action does: plans are made with the
rehearsed effects. Outcomes that differ in kind (at rest, held, toppled, lost) are kept apart as modes and
never averaged together, since the mean of "on the table" and "in the air" is a place where no object ever is.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from neurosym.checks import check_all, check_array, check_count, check_kind, check_seed, check_whole
from neurosym.errors import InvalidValue
from neurosym.guarded import made, placed
from neurosym.naming import name_categories, name_operator
from neurosym.operators import Category, Mode, Operator, OperatorTable, Primitive
from neurosym.primitives.modes import sort_into_modes
from neurosym.progress import Progress
from neurosym.symbols import Categorise, all_symbols, symbols_of
from neurosym.world import Outcome, Scene, World, WorldFactory
from neurosym.worlds.workers import Task, perform_all

_STREAM = 0x7265  # keeps rehearsal's draws apart from those of exploration


@dataclass(frozen=True, slots=True, eq=False)
class Rehearsals:
    """Every primitive performed on the same objects.

    Attributes:
        primitives: In the order of their symbols.
        features: Features of the objects.
        symbols: Symbol of each object.
        outcomes: For each primitive, an outcome for each object.
    """

    primitives: tuple[Primitive, ...]
    features: Float[np.ndarray, "M F"]
    symbols: np.ndarray
    outcomes: tuple[tuple[Outcome, ...], ...]

    def __post_init__(self) -> None:
        check_all("primitives", self.primitives, Primitive, "a tuple of Primitive")
        check_array("features", self.features, (None, None))
        rows = len(self.features)
        if np.shape(self.symbols) != (rows,) or len(self.outcomes) != len(self.primitives):
            raise InvalidValue("Rehearsals need a symbol for each object, and outcomes for each primitive.")
        if any(len(row) != rows for row in self.outcomes):
            raise InvalidValue("Rehearsals need for each primitive an outcome for each object.")


def rehearse(
    world_factory: WorldFactory,
    primitives: Sequence[Primitive],
    categorise: Categorise,
    *,
    objects: int = 100,
    seed: int,
    workers: int = 1,
    progress: Progress | None = None,
) -> Rehearsals:
    """Perform each primitive on the same sampled objects, one at a time.

    Args:
        world_factory: Builds the world; must survive pickling if there is more than one worker.
        primitives: What to perform.
        categorise: Gives the object symbols of features.
        objects: How many objects are sampled.
        seed: Where all draws start.
        workers: How many processes; their number does not change the result.
        progress: Called after each rehearsal.

    Raises:
        InvalidValue: If there is no object or no primitive to rehearse with.
    """
    check_all("primitives", primitives, Primitive, "primitives, as distill or choose returns them")
    check_seed(seed)
    check_whole("objects", objects)
    if objects < 1 or not primitives:
        raise InvalidValue(
            f"Nothing can be rehearsed with {objects} objects and {len(primitives)} primitives."
        )
    check_count("workers", workers)
    world = made(world_factory)
    for primitive in primitives:
        if len(primitive.action) != len(world.action_box.low):
            raise InvalidValue(
                f"The primitive {primitive.symbol} has {len(primitive.action)} action parameters; the "
                f"{world.name} world takes {len(world.action_box.low)}."
            )
    scenes = [rehearsal_scene(world, seed, number) for number in range(objects)]
    features = np.concatenate([scene.features for scene in scenes])
    ordered = tuple(sorted(primitives, key=lambda primitive: primitive.symbol))
    outcomes = perform_on_each(world_factory, ordered, scenes, workers, progress)
    return Rehearsals(ordered, features, np.array(symbols_of(categorise, features)), outcomes)


def perform_on_each(
    world_factory: WorldFactory,
    primitives: Sequence[Primitive],
    scenes: Sequence[Scene],
    workers: int,
    progress: Progress | None,
) -> tuple[tuple[Outcome, ...], ...]:
    """Perform each primitive on the one object of each scene.

    Args:
        world_factory: Builds the world.
        primitives: What to perform.
        scenes: On what.
        workers: How many processes.
        progress: Called after each performance.

    Returns:
        For each primitive, an outcome for each scene.
    """
    tasks = [
        Task(scene, np.array(primitive.action, dtype=np.float64))
        for primitive in primitives
        for scene in scenes
    ]
    outcomes: list[Outcome] = []
    performed = perform_all(world_factory, tasks, workers)
    while len(outcomes) < len(tasks):
        with placed(f"rehearsal {len(outcomes) + 1} of {len(tasks)}"):
            outcomes.append(next(performed))
        if progress is not None:
            progress(len(outcomes), len(tasks))
    rows = range(0, len(outcomes), len(scenes))
    return tuple(tuple(outcomes[row : row + len(scenes)]) for row in rows)


def tabulate(rehearsals: Rehearsals, feature_names: Sequence[str]) -> OperatorTable:
    """Tell what each primitive did to each category.

    Args:
        rehearsals: What happened.
        feature_names: What the features are.

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
    categories = describe_categories(rehearsals.features, symbols, feature_names)
    operators = tuple(
        _operator(primitive, category, [outcomes[i] for i in np.flatnonzero(symbols == category.symbol)])
        for primitive, outcomes in zip(rehearsals.primitives, rehearsals.outcomes, strict=True)
        for category in categories
        if category.share
    )
    return OperatorTable(categories=categories, primitives=rehearsals.primitives, operators=operators)


def rehearsal_scene(world: World, seed: int, number: int) -> Scene:
    """Draw one of the objects that primitives are rehearsed on.

    Args:
        world: Where it comes from.
        seed: Where all draws start.
        number: Of the object, counted from 0.
    """
    return world.sample_scene(np.random.default_rng([seed, _STREAM, number]), 1)


def describe_categories(
    features: Float[np.ndarray, "N F"], symbols: np.ndarray, feature_names: Sequence[str]
) -> tuple[Category, ...]:
    """Describe and name the categories, in the order of their symbols.

    A symbol that no object has is called `unseen`: problems may meet one later, and nothing is known of it.

    Args:
        features: Features of the objects.
        symbols: Symbol of each object.
        feature_names: What the features are.
    """
    present = sorted(set(symbols.tolist()))
    members = [features[symbols == symbol] for symbol in present]
    means = np.array([_means_for_naming(rows, feature_names) for rows in members])
    names = name_categories(present, means, feature_names)
    seen = {
        symbol: Category(
            symbol=symbol,
            name=name,
            share=len(rows) / len(features),
            feature_means=tuple(rows.mean(0).tolist()),
            feature_spreads=tuple(rows.std(0).tolist()),
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


def modes_of(outcomes: Sequence[Outcome]) -> tuple[Mode, ...]:
    """Sort outcomes into modes, most frequent first.

    Args:
        outcomes: Outcomes of one primitive on objects of one category.
    """
    return sort_into_modes(
        [outcome.kind for outcome in outcomes],
        np.array([outcome.effect for outcome in outcomes]),  # (N, 3)
        np.array([outcome.resting_effect for outcome in outcomes]),
        np.array([outcome.peak_height for outcome in outcomes]),
    )


def _operator(primitive: Primitive, category: Category, outcomes: Sequence[Outcome]) -> Operator:
    modes = modes_of(outcomes)
    return Operator(
        name=name_operator(primitive.symbol, category.name, modes),
        category=category.symbol,
        primitive=primitive.symbol,
        trials=len(outcomes),
        modes=modes,
    )
