"""How fast plans of relations are found, beside what they may take; prints JSON.

Fast Downward plans for towers of four of eight objects, and for five towers of three of twenty small ones on
a lattice, which no robot builds. CPU seconds of all processes count, so that others on the machine
disturb little; the seconds of the clock stand beside them.
"""

from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import Annotated, Any

import msgspec
import numpy as np
import tyro

from neurosym.grounding import Grounding
from neurosym.operators import TOLERANCE
from neurosym.problems import Problem, RelationGoal, SceneObject
from neurosym.stages.folder import DomainFolder
from neurosym.stages.problem_making import draw_any_task, sight_of_pairs, ways_of
from neurosym.tasks.options import puts_of
from neurosym.tasks.supports import PairSight, with_pairs
from neurosym.tasks.task import understand
from tools.benchmarks.carrying.bench import lattice_points, tell, timed
from tools.benchmarks.options import Output
from tools.benchmarks.planning.measures import bench_of
from tools.relearn_towers import FOLDER as SHIPPED
from tools.relearn_towers import state_called

FIRST = 930_000
"""Seed of the first task, far from those of the evaluation."""
EIGHT, TWENTY = 8, 20
MOST_SECONDS = {EIGHT: 1.0, TWENTY: 5.0}
TOWERS, HEIGHT = 5, 3
COLUMNS, ROWS = 5, 4
"""The small objects stand on a lattice of so many points along y and x."""
SMALL = 0.09
"""No wider are the small objects [m]."""


def main(
    tasks: Annotated[int, tyro.conf.arg(help="How many tasks of each kind.")] = 5, output: Output = None
) -> None:
    """Measure, and print what was found as JSON."""
    folder, seeds = DomainFolder(SHIPPED), range(FIRST, FIRST + tasks)
    bench, sight = bench_of(SHIPPED), sight_of_pairs(folder)
    assert sight is not None, "relations were learned"
    grounding, resting = bench.setting.grounding, state_called("rests-on", folder)
    eight = [
        draw_any_task(
            bench.setting.world,
            bench.categorise,
            grounding,
            "tower",
            name=f"tower-{seed}",
            objects=EIGHT,
            seed=seed,
            height=4,
            state=resting,
            tolerance=TOLERANCE,
            sight=sight,
        )
        for seed in seeds
    ]
    small = [item for task in eight for item in task.objects if max(item.features[:2]) <= SMALL]
    twenty = [towers(small, grounding, sight, resting, seed) for seed in seeds]
    parts = {
        name: _timed([with_pairs(one, grounding.relations, sight) for one in problems], grounding, limit)
        for name, problems, limit in (
            ("eight_objects", eight, MOST_SECONDS[EIGHT]),
            ("twenty_objects", twenty, MOST_SECONDS[TWENTY]),
        )
    }
    tell(parts, output)


def _timed(problems: Sequence[Problem], grounding: Grounding, limit: float) -> dict[str, Any]:
    """Time plans, and count the operators on pairs that their problems have a use for."""
    used = [
        len({put.name for puts in understand(problem, grounding).puts.values() for put in puts})
        for problem in problems
    ]
    counts = {"operators_of_domain": len(puts_of(grounding)), "operators_used": [min(used), max(used)]}
    return timed(problems, grounding, limit) | counts


def towers(
    kinds: Sequence[SceneObject], grounding: Grounding, sight: PairSight, state: str, seed: int
) -> Problem:
    """Draw twenty objects on a lattice, of which several towers shall be built."""
    rng = np.random.default_rng(seed)
    points = lattice_points(grounding.table, ROWS, COLUMNS)
    items = tuple(
        SceneObject(f"item-{number:02d}", like.category, like.features, (*points[number], like.position[2]))
        for number, like in enumerate(kinds[kind] for kind in rng.integers(len(kinds), size=TWENTY))
    )
    problem = with_pairs(Problem(f"towers-{seed}", items, {}, TOLERANCE), grounding.relations, sight)
    ways, free, goals = ways_of(problem, grounding, sight), [*problem.object_names], list[RelationGoal]()

    def carries(upper: str, lower: str) -> bool:
        return any(way.state == state for way in ways[upper, lower])

    while len(goals) < TOWERS * (HEIGHT - 1):
        chain = _chain(free, carries)
        goals += [(upper, lower, state) for upper, lower in pairwise(chain)]
        free = [name for name in free if name not in chain]
    return msgspec.structs.replace(problem, relations=tuple(goals))


def _chain(names: Sequence[str], carries: Callable[[str, str], bool]) -> list[str]:
    """Return three names of which each can be put on the next."""
    return next(
        [top, middle, base]
        for base in names
        for middle in names
        for top in names
        if len({top, middle, base}) == HEIGHT and carries(middle, base) and carries(top, middle)
    )


if __name__ == "__main__":
    tyro.cli(main)
