"""Rehearsing operators that carry where there are other objects: beside the target, or on the place."""

from collections.abc import Mapping, Sequence

import numpy as np

from neurosym.operators import TOLERANCE, Operator, OperatorTable
from neurosym.place_operators import Kept
from neurosym.primitives.performing import perform
from neurosym.primitives.sampling import sample_by_category
from neurosym.progress import Progress
from neurosym.symbols import Categorise, Symbol
from neurosym.world import Outcome, Scene, WorldFactory
from neurosym.worlds.aimed import AimedFactory, AimedScene
from neurosym.worlds.neighbours import CrowdedFactory
from neurosym.worlds.workers import Task

MARGIN = 0.06
"""How far inside the edge of the table the places of rehearsals lie, lest what is held askew be lost [m]."""
AMONG_OTHERS = 20
"""Rehearsals of an operator with another object on the place, and with others beside the target."""
GAP = 0.04
"""How far apart the target and the object on the place are at least [m]."""
_LEVEL = 0.01  # what stands higher than it did stands on something else [m]
_STREAM, _BESIDE = 0x6F63, 0x6273  # keep these draws apart from those of other rehearsals


def rehearse_occupied(
    world_factory: WorldFactory,
    table: OperatorTable,
    categorise: Categorise,
    *,
    seed: int,
    workers: int = 1,
    progress: Progress | None = None,
) -> tuple[Kept, ...]:
    """Rehearse operators with another object on the place, to see whether it must be free.

    Args:
        world_factory: Builds the world, which takes places.
        table: The operators.
        categorise: Gives the object symbols of features.
        seed: Where all draws start.
        workers: How many processes; their number does not change the result.
        progress: Called after each rehearsal.
    """
    world = (factory := AimedFactory(world_factory, MARGIN))()
    sample = sample_by_category(world, categorise, least=AMONG_OTHERS, seed=seed, stream=_STREAM)
    rng = np.random.default_rng([seed, _STREAM])
    drawn = {
        symbol: [_occupied(scene, world.sample_scene(rng, 1)) for scene in members]
        for symbol, members in sample.scenes.items()
    }
    scenes = {symbol: [one for one in among if one is not None] for symbol, among in drawn.items()}
    return _kept(factory, table, scenes, workers, progress)


def rehearse_beside(
    world_factory: WorldFactory,
    table: OperatorTable,
    categorise: Categorise,
    *,
    seed: int,
    workers: int = 1,
    progress: Progress | None = None,
) -> tuple[Kept, ...]:
    """Rehearse operators with other objects close around the target, to see whether these are left alone.

    Args:
        world_factory: Builds the world, which takes places.
        table: The operators.
        categorise: Gives the object symbols of features.
        seed: Where all draws start.
        workers: How many processes; their number does not change the result.
        progress: Called after each rehearsal.
    """
    factory = CrowdedFactory(world_factory, MARGIN)
    sample = sample_by_category(factory(), categorise, least=AMONG_OTHERS, seed=seed, stream=_BESIDE)
    return _kept(factory, table, sample.scenes, workers, progress)


def _kept(
    factory: WorldFactory,
    table: OperatorTable,
    scenes: Mapping[Symbol, Sequence[Scene]],
    workers: int,
    progress: Progress | None,
) -> tuple[Kept, ...]:
    """Rehearse operators that ever carry in scenes for their category, and count what went as promised."""
    actions = {one.label: np.array(one.action, dtype=np.float64) for one in table.primitives}
    worthy = [one for one in table.operators if one.successes and scenes.get(one.category)]
    tasks = [Task(scene, actions[one.label]) for one in worthy for scene in scenes[one.category]]
    outcomes = perform(factory, tasks, workers, progress)
    found = []
    for one in worthy:
        ends = [next(outcomes) for _ in scenes[one.category]]
        found.append(Kept(one.name, len(ends), sum(_stands_there(one, end) for end in ends)))
    return tuple(found)


def _occupied(scene: Scene, other: Scene) -> AimedScene | None:
    """Put another object on the place that a scene is aimed at; None if it would stand in the target."""
    assert isinstance(scene, AimedScene), "drawn from a world in which actions are aimed"
    centre = np.array([[scene.reference.x, scene.reference.y, other.positions[0, 2]]])
    room = (scene.features[0, :2] + other.features[0, :2]) / 2
    if np.all(np.abs(scene.positions[0, :2] - centre[0, :2]) < room + GAP):
        return None
    return AimedScene(
        np.concatenate([scene.features, other.features]),
        np.concatenate([scene.positions, centre]),
        np.concatenate([scene.orientations, other.orientations]),
        scene.reference,
    )


def _stands_there(operator: Operator, outcome: Outcome) -> bool:
    """Say whether a target was carried as promised, onto the table, and nothing else was moved."""
    assert operator.promise is not None, "it has successes"
    away, up = outcome.resting_effect - operator.promise.outcome, outcome.resting_effect[2]
    is_near = float(np.linalg.norm(away[:2])) <= TOLERANCE
    return outcome.kind == "carried" and is_near and abs(float(up)) <= _LEVEL and not outcome.disturbed
