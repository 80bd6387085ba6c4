"""From networks and data to the table of operators: distil, choose, and rehearse or average."""

from typing import Any

from neurosym.actions import ActionBox
from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidValue
from neurosym.guarded import made
from neurosym.learning.direct_model import DirectModel
from neurosym.learning.effect_model import EffectModel
from neurosym.operators import OperatorTable
from neurosym.primitives.audition import choose
from neurosym.primitives.averaging import average
from neurosym.primitives.distillation import distill
from neurosym.primitives.rehearsal import rehearse, tabulate
from neurosym.primitives.unsure import rehearse_unsure
from neurosym.progress import OpenBar, silent
from neurosym.world import WorldFactory


class NothingDistilled(InvalidValue):
    """A model whose symbols no action encodes to."""

    def __init__(self) -> None:
        super().__init__("No action encodes to its symbol; train again.")


def find_operators(
    model: EffectModel,
    direct: DirectModel,
    interactions: Interactions,
    box: ActionBox,
    *,
    world_factory: WorldFactory | None,
    objects: int = 100,
    choice: str = "own",
    seed: int,
    workers: int = 1,
    open_bar: OpenBar = silent,
) -> OperatorTable:
    """Distil each action symbol, choose among the candidates, and measure what each operator does.

    Args:
        model: Whose symbols are distilled.
        direct: A network without a bottleneck on the same data, which shortlists.
        interactions: The data.
        box: What parameters must stay inside.
        world_factory: Builds the world to audition and rehearse in; without one, the data are averaged.
        objects: How many objects each symbol is rehearsed on, not counting those added for rare categories.
        choice: Which candidate stands for a symbol; one of `CHOICES`.
        seed: Where all draws start.
        workers: How many processes; their number does not change the result.
        open_bar: Shows how far each part has come.

    Raises:
        NothingDistilled: If no action encodes to its symbol.
        UnknownChoice: If there is no such choice.
    """
    with open_bar("distilling") as advance:
        candidates = distill(model, interactions, box, seed=seed, progress=advance)
    if not candidates:
        raise NothingDistilled
    chosen = choose(
        candidates,
        choice,
        predict=direct.predict_outcomes,
        features=interactions.features,
        categorise=model.object_symbols,
        world_factory=world_factory,
        seed=seed,
        workers=workers,
        open_bar=open_bar,
    )
    categorise = model.object_symbols
    if world_factory is None:
        return average(interactions, chosen.primitives, categorise, model.action_symbols)
    options: Any = {"objects": objects, "seed": seed, "workers": workers}
    with open_bar("rehearsing") as advance:
        found = rehearse(world_factory, chosen, categorise, **options, progress=advance)
    with open_bar("telling the outcomes apart") as advance:
        table = tabulate(found, made(world_factory).feature_names, progress=advance)
    with open_bar("rehearsing what is unsure") as advance:
        return rehearse_unsure(world_factory, table, categorise, **options, progress=advance)
