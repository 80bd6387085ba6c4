"""From actions that are aimed at places to operators: which of them carry what, and how surely.

Candidates are distilled as ever. Of each symbol, every category of objects gets the one that carries its
objects most surely and exactly to the place, auditioned and rehearsed as other actions are (`own.py`,
`rehearsal.py`, `unsure.py`). Rehearsals with another object on the place say whether it must be free.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np
from jaxtyping import Float

from neurosym.actions import ActionBox
from neurosym.data.interactions import Interactions
from neurosym.guarded import made
from neurosym.learning.effect_model import EffectModel
from neurosym.operators import TOLERANCE, Operator, OperatorTable, Primitive
from neurosym.place_operators import Occupied, PlaceOperators
from neurosym.primitives.distillation import distill
from neurosym.primitives.judging import foresee_carrying
from neurosym.primitives.own import choose_own
from neurosym.primitives.performing import perform
from neurosym.primitives.rehearsal import rehearse, tabulate
from neurosym.primitives.sampling import sample_by_category
from neurosym.primitives.table import NothingDistilled, silent
from neurosym.primitives.unsure import rehearse_unsure
from neurosym.primitives.variety import PredictOutcomes
from neurosym.progress import OpenBar, Progress
from neurosym.symbols import Categorise
from neurosym.world import Outcome, Scene, WorldFactory
from neurosym.worlds.aimed import AimedFactory, AimedScene
from neurosym.worlds.workers import Task

MARGIN = 0.06
"""How far inside the edge of the table the places of rehearsals lie, lest what is held askew be lost [m]."""
ON_OCCUPIED = 20
"""Rehearsals of an operator with another object on the place."""
OBJECTS_TO_PREDICT = 200
"""Objects on which the candidates of a symbol are compared for all categories."""
GAP = 0.04
"""How far apart the target and the object on the place are at least [m]."""
_LEVEL = 0.01  # what stands higher than it did stands on something else [m]
_STREAM = 0x6F63  # keeps these draws apart from those of other rehearsals


def find_carriers(
    model: EffectModel,
    predict: PredictOutcomes,
    interactions: Interactions,
    box: ActionBox,
    categorise: Categorise,
    *,
    world_factory: WorldFactory,
    objects: int = 100,
    seed: int,
    workers: int = 1,
    open_bar: OpenBar | None = None,
) -> PlaceOperators:
    """Distil actions that are aimed at places, choose those that carry, and measure what they do.

    Args:
        model: Whose action symbols are distilled.
        predict: A network without a bottleneck on the same data, which shortlists; it predicts where objects
            end relative to the place [m], the chance that they are carried, and greatest heights [m].
        interactions: The data, each aimed at a place.
        box: What parameters must stay inside.
        categorise: Gives the object symbols of features, in the domain that the operators are for.
        world_factory: Builds the world, which takes places.
        objects: How many objects each symbol is rehearsed on, not counting those added for rare categories.
        seed: Where all draws start.
        workers: How many processes; their number does not change the result.
        open_bar: Shows how far each part has come.

    Raises:
        NothingDistilled: If no action encodes to its symbol.
    """
    open_bar = open_bar or silent
    aimed = AimedFactory(world_factory, MARGIN)
    options: dict[str, Any] = {"seed": seed, "workers": workers}
    with open_bar("distilling what is aimed") as advance:
        candidates = distill(model, interactions, box, seed=seed, progress=advance)
    if not candidates:
        raise NothingDistilled
    shared = _likeliest(candidates, predict, interactions.features[:OBJECTS_TO_PREDICT])
    with open_bar("auditioning what is aimed") as advance:
        chosen = choose_own(
            aimed,
            candidates,
            shared,
            predict,
            interactions.features,
            categorise,
            foresee=foresee_carrying,
            **options,
            progress=advance,
        )
    with open_bar("rehearsing what is aimed") as advance:
        found = rehearse(aimed, chosen, categorise, objects=objects, **options, progress=advance)
    table = tabulate(found, made(world_factory).feature_names)
    with open_bar("rehearsing what is unsure") as advance:
        table = rehearse_unsure(aimed, table, categorise, objects=objects, **options, progress=advance)
    with open_bar("rehearsing on occupied places") as advance:
        occupied = rehearse_occupied(world_factory, table, categorise, **options, progress=advance)
    return PlaceOperators(operators=table, occupied=occupied)


def _likeliest(
    candidates: Sequence[Primitive], predict: PredictOutcomes, features: Float[np.ndarray, "M F"]
) -> tuple[Primitive, ...]:
    """Return of each symbol the candidate that is predicted to carry objects of all kinds most surely."""
    best: dict[str, tuple[float, Primitive]] = {}
    for one in candidates:
        predicted = predict(features, np.tile(np.array(one.action), (len(features), 1)))
        sureness = foresee_carrying(predicted).sureness
        if one.symbol not in best or sureness > best[one.symbol][0]:
            best[one.symbol] = sureness, one
    return tuple(best[symbol][1] for symbol in sorted(best))


def rehearse_occupied(
    world_factory: WorldFactory,
    table: OperatorTable,
    categorise: Categorise,
    *,
    seed: int,
    workers: int = 1,
    progress: Progress | None = None,
) -> tuple[Occupied, ...]:
    """Rehearse operators with another object on the place, to see whether it must be free.

    Args:
        world_factory: Builds the world, which takes places.
        table: The operators.
        categorise: Gives the object symbols of features.
        seed: Where all draws start.
        workers: How many processes; their number does not change the result.
        progress: Called after each rehearsal.
    """
    world = AimedFactory(world_factory, MARGIN)()
    sample = sample_by_category(world, categorise, least=ON_OCCUPIED, seed=seed, stream=_STREAM)
    rng = np.random.default_rng([seed, _STREAM])
    scenes = {
        symbol: [_occupied(scene, world.sample_scene(rng, 1)) for scene in members]
        for symbol, members in sample.scenes.items()
    }
    actions = {one.label: np.array(one.action, dtype=np.float64) for one in table.primitives}
    worthy = [one for one in table.operators if one.successes and one.category in scenes]
    tasks = [
        Task(scene, actions[one.label])
        for one in worthy
        for scene in scenes[one.category]
        if scene is not None
    ]
    outcomes = perform(AimedFactory(world_factory, MARGIN), tasks, workers, progress)
    found = []
    for one in worthy:
        ends = [next(outcomes) for scene in scenes[one.category] if scene is not None]
        found.append(Occupied(one.name, len(ends), sum(_stands_there(one, end) for end in ends)))
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
