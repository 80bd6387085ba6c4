"""Rehearsal: actions are performed on sampled objects of each category, to measure what they really do.

What a code does on average in the data is not what its distilled action does: plans are made with the
rehearsed effects. Outcomes that differ in kind (at rest, held, toppled, lost) are kept apart as modes and
never averaged together, since the mean of "on the table" and "in the air" is a place where no object ever is.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import compress

import numpy as np

from neurosym.arrays import Float
from neurosym.checks import check_all, check_array, check_count, check_kind, check_seed, check_whole
from neurosym.errors import InvalidValue
from neurosym.guarded import made
from neurosym.naming import name_categories, name_operator
from neurosym.operators import (
    TABLE_FORMAT,
    TOLERANCE,
    Category,
    Effect,
    Mode,
    Operator,
    OperatorTable,
    Primitive,
    Rehearsal,
)
from neurosym.primitives.judging import judge, performance
from neurosym.primitives.performing import perform_each, tasks_of
from neurosym.primitives.repertoire import Repertoire, shared_by_all
from neurosym.primitives.sampling import Sample, sample_by_category
from neurosym.progress import Progress
from neurosym.symbols import Categorise, Symbol, all_symbols
from neurosym.world import Outcome, OutcomeKind, World, WorldFactory

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
