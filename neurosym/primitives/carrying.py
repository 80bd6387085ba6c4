"""From actions that are aimed at places to operators: which of them carry what, and how surely.

Candidates are distilled as ever. Of each symbol, every category of objects gets the one that carries its
objects most surely and exactly to the place, auditioned and rehearsed as other actions are (`own.py`,
`rehearsal.py`, `unsure.py`). Auditions are among neighbours, lest an action be chosen that drags the object
through them. Rehearsals among others say how surely they are left alone, and whether a place must be free.
"""

from collections.abc import Sequence
from typing import Any

import numpy as np

from neurosym.actions import ActionBox
from neurosym.arrays import Float
from neurosym.data.interactions import Interactions
from neurosym.guarded import made
from neurosym.learning.effect_model import EffectModel
from neurosym.operators import Primitive
from neurosym.place_operators import PlaceOperators
from neurosym.primitives.among_others import MARGIN, rehearse_beside, rehearse_occupied
from neurosym.primitives.distillation import distill
from neurosym.primitives.judging import foresee_carrying
from neurosym.primitives.own import CARRYING_ROUNDS, choose_own
from neurosym.primitives.rehearsal import rehearse, tabulate
from neurosym.primitives.table import NothingDistilled
from neurosym.primitives.unsure import rehearse_unsure
from neurosym.primitives.variety import PredictOutcomes
from neurosym.progress import OpenBar, silent
from neurosym.symbols import Categorise
from neurosym.world import WorldFactory
from neurosym.worlds.aimed import AimedFactory
from neurosym.worlds.neighbours import CrowdedFactory

OBJECTS_TO_PREDICT = 200
"""Objects on which the candidates of a symbol are compared for all categories."""


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
    open_bar: OpenBar = silent,
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
    aimed = AimedFactory(world_factory, MARGIN)
    options: dict[str, Any] = {"seed": seed, "workers": workers}
    with open_bar("distilling what is aimed") as advance:
        candidates = distill(model, interactions, box, seed=seed, progress=advance)
    if not candidates:
        raise NothingDistilled
    shared = _likeliest(candidates, predict, interactions.features[:OBJECTS_TO_PREDICT])
    with open_bar("auditioning what is aimed") as advance:
        chosen = choose_own(
            CrowdedFactory(world_factory, MARGIN),
            candidates,
            shared,
            predict,
            interactions.features,
            categorise,
            foresee=foresee_carrying,
            rounds=CARRYING_ROUNDS,
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
    with open_bar("rehearsing among neighbours") as advance:
        beside = rehearse_beside(world_factory, table, categorise, **options, progress=advance)
    return PlaceOperators(operators=table, occupied=occupied, beside=beside)


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
