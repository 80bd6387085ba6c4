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
from neurosym.primitives.performing import perform_each, tasks_of
from neurosym.primitives.rehearsal import rehearsal_of, rounded
from neurosym.primitives.sampling import sample_by_category
from neurosym.primitives.search import Search
from neurosym.progress import part
from neurosym.promises import chances_of, rehearsed_objects
from neurosym.world import Scene

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
        stream=_STREAM,
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
