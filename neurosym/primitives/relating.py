"""From actions that are aimed at other objects to operators on pairs: what brings which into which state.

Candidates are distilled as ever. Every kind of pair gets those that most surely bring it into some state
(`pair_choice.py`), auditioned and rehearsed among bystanders. More rehearsals begin as others ended. They
show whether it matters that the target rests on something, that something rests on it, or on the reference.
"""

from typing import Any

from neurosym.actions import ActionBox
from neurosym.data.interactions import Interactions
from neurosym.guarded import made
from neurosym.learning.effect_model import EffectModel
from neurosym.pair_sight import ChancesOfStates
from neurosym.primitives.distillation import distill
from neurosym.primitives.pair_choice import choose_for_pairs
from neurosym.primitives.pair_rehearsal import rehearse_among, tabulate_pairs
from neurosym.primitives.rehearsal import rehearse
from neurosym.primitives.table import NothingDistilled
from neurosym.progress import OpenBar, silent
from neurosym.relation_operators import PairStates, RelationOperators
from neurosym.world import WorldFactory
from neurosym.worlds.related import RelatedFactory


def find_relators(
    model: EffectModel,
    foresee: ChancesOfStates,
    interactions: Interactions,
    box: ActionBox,
    states: PairStates,
    *,
    world_factory: WorldFactory,
    pairs: int = 100,
    seed: int,
    workers: int = 1,
    open_bar: OpenBar = silent,
) -> RelationOperators:
    """Distil actions that are aimed at other objects, choose among them, and measure what they do.

    Args:
        model: Whose action symbols are distilled, and whose object symbols are kinds of pairs.
        foresee: Foresees the chances of the states that bear, in their order; it shortlists.
        interactions: The data, each aimed at another object.
        box: What parameters must stay inside.
        states: The states of pairs.
        world_factory: Builds the world, which takes objects as references.
        pairs: How many pairs each symbol is rehearsed on, not counting those added for rare kinds.
        seed: Where all draws start.
        workers: How many processes; their number does not change the result.
        open_bar: Shows how far each part has come.

    Raises:
        NothingDistilled: If no action encodes to its symbol.
    """
    related = RelatedFactory(world_factory)
    options: dict[str, Any] = {"seed": seed, "workers": workers}
    with open_bar("distilling what is aimed at objects") as advance:
        candidates = distill(model, interactions, box, seed=seed, progress=advance)
    if not candidates:
        raise NothingDistilled
    with open_bar("auditioning what is aimed at objects") as advance:
        chosen = choose_for_pairs(
            related, candidates, foresee, model.object_symbols, states, **options, progress=advance
        )
    with open_bar("rehearsing on pairs") as advance:
        found = rehearse(related, chosen, model.object_symbols, objects=pairs, **options, progress=advance)
    names = made(world_factory).feature_names
    table = tabulate_pairs(found, names, states)
    with open_bar("rehearsing where pairs bear others") as advance:
        return rehearse_among(related, table, found, model.object_symbols, **options, progress=advance)
