"""Rehearsing where an outcome is unsure: on more of those objects that may turn out either way.

A hand of 14 cm holds what is 126 mm wide and nothing that is wider. Objects as the world draws them leave
gaps where outcomes turn, so plans hope for what never comes. So each operator is rehearsed once more on
objects of which its rehearsals say least, and again after that: uncertainty sampling (Lewis and Gale, 1994).
"""

from dataclasses import dataclass

import msgspec
import numpy as np

from neurosym.arrays import Float
from neurosym.guarded import made
from neurosym.operators import Category, Operator, OperatorTable, Rehearsal
from neurosym.primitives.categories import rounded
from neurosym.primitives.performing import perform
from neurosym.primitives.rehearsal import rehearsal_of
from neurosym.primitives.sampling import sample_by_category
from neurosym.progress import Progress, part
from neurosym.promises import chances_of, rehearsed_objects
from neurosym.symbols import Categorise
from neurosym.world import Scene, WorldFactory
from neurosym.worlds.workers import Task

ROUNDS = 3
"""How often operators are rehearsed again."""
SHARE = 0.16
"""How many objects each time at most, as a share of those that every operator is rehearsed on."""
UNSURE = 0.09
"""Least variance of an outcome that is worth a rehearsal: of one that comes in 10 to 90 % of all cases."""
POOLED = 12
"""How many objects of all categories these are chosen from, for each that is rehearsed on."""
_APART = 0.5  # objects nearer than this tell much the same, in spreads of the features
_STREAM = 0x756E  # keeps these draws apart from those of other rehearsals


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


def rehearse_unsure(
    world_factory: WorldFactory,
    table: OperatorTable,
    categorise: Categorise,
    *,
    objects: int = 100,
    seed: int,
    workers: int = 1,
    progress: Progress | None = None,
) -> OperatorTable:
    """Rehearse operators on objects for which it is unsure whether their promise is kept.

    The other rehearsals come first, and are those that trials and modes count: their objects are drawn as
    the world draws them.

    Args:
        world_factory: Builds the world; must survive pickling if there is more than one worker.
        table: Operators, with their rehearsals.
        categorise: Gives the object symbols of features.
        objects: How many objects each operator was rehearsed on.
        seed: Where all draws start.
        workers: How many processes; their number does not change the result.
        progress: Called after each rehearsal; the total grows with each round.
    """
    if not (count := int(SHARE * objects)):
        return table
    world = made(world_factory)
    sample = sample_by_category(
        world, categorise, least=1, typical=POOLED * objects, seed=seed, stream=_STREAM
    )
    pools = {
        one.symbol: _pool(one, scenes)
        for one in table.categories
        if (scenes := sample.scenes.get(one.symbol))
    }
    actions = {one.label: np.array(one.action, dtype=np.float64) for one in table.primitives}
    operators, done = list(table.operators), 0
    met = [place for place, one in enumerate(operators) if one.category in pools]
    free = {place: np.ones(len(pools[operators[place].category].scenes), dtype=bool) for place in met}
    for _ in range(ROUNDS):
        chosen = {
            place: _unsure(operators[place], pools[operators[place].category], free[place], count)
            for place in met
        }
        tasks = [
            Task(pools[operators[place].category].scenes[number], actions[operators[place].label])
            for place, numbers in chosen.items()
            for number in numbers
        ]
        outcomes = perform(world_factory, tasks, workers, part(progress, done))
        done += len(tasks)
        for place, numbers in chosen.items():
            rows = tuple(rehearsal_of(next(outcomes)) for _ in numbers)
            operators[place] = _with_rows(operators[place], pools[operators[place].category], numbers, rows)
            free[place][numbers] = False
    return msgspec.structs.replace(table, operators=tuple(operators))


def _with_rows(operator: Operator, pool: _Pool, numbers: list[int], rows: tuple[Rehearsal, ...]) -> Operator:
    """Add to an operator what was seen of some objects of a pool."""
    if not numbers:
        return operator
    known = rehearsed_objects(operator, pool.category)
    objects = (*known, *(rounded(pool.features[number]) for number in numbers))
    return msgspec.structs.replace(operator, objects=objects, rehearsals=(*operator.rehearsals, *rows))


def _pool(category: Category, scenes: tuple[Scene, ...]) -> _Pool:
    return _Pool(category, scenes, np.concatenate([scene.features for scene in scenes]))


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
