"""Rehearsing operators that carry where there are other objects: beside the target, or on the place."""

from collections.abc import Mapping, Sequence
from functools import partial

import numpy as np

from neurosym.operators import TOLERANCE, Operator, OperatorTable
from neurosym.place_operators import Kept, PlaceOperators
from neurosym.primitives.performing import perform_each, tasks_of
from neurosym.primitives.sampling import sample_by_category
from neurosym.primitives.search import Search
from neurosym.progress import Progress
from neurosym.symbols import Symbol
from neurosym.world import Outcome, Scene, WorldFactory
from neurosym.worlds.aimed import AimedFactory, AimedScene
from neurosym.worlds.neighbours import CrowdedFactory, joined

MARGIN = 0.06
"""How far inside the edge of the table the places of rehearsals lie, lest what is held askew be lost [m]."""
AMONG_OTHERS = 20
"""Rehearsals of an operator with another object on the place, and with others beside the target."""
GAP = 0.04
"""How far apart the target and the object on the place are at least [m]."""
_LEVEL = 0.01  # what stands higher than it did stands on something else [m]
_STREAM, _BESIDE = 0x6F63, 0x6273  # keep these draws apart from those of other rehearsals


def rehearse_among_others(search: Search, table: OperatorTable) -> PlaceOperators:
    """Rehearse operators with another object on the place, and with others close around the target.

    That says whether the place must be free, and whether others are left alone.

    Args:
        search: What they were found with.
        table: The operators.
    """
    factory = AimedFactory(search.world_factory, MARGIN)
    world, rng = factory(), np.random.default_rng([search.seed, _STREAM])
    sample = partial(sample_by_category, categorise=search.categorise, least=AMONG_OTHERS, seed=search.seed)
    drawn = {
        symbol: [_occupied(scene, world.sample_scene(rng, 1)) for scene in members]
        for symbol, members in sample(world, stream=_STREAM).scenes.items()
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
