"""The command `neurosym train`: the final fit."""

from neurosym.commands.options import (
    ActionBits,
    Folder,
    ObjectBits,
    RegimeName,
    Seed,
    opened,
)
from neurosym.console import say, say_next
from neurosym.wording import quoted


def train(
    folder: Folder,
    seed: Seed = 0,
    regime: RegimeName = "default",
    object_bits: ObjectBits = None,
    action_bits: ActionBits = None,
) -> int:
    """Fit the effect model whose bits are the symbols: `interactions.npz` -> `effect_model.safetensors`."""
    from neurosym.commands.tables import show_training
    from neurosym.stages.aiming import train_places_stage
    from neurosym.stages.layout import (
        INTERACTIONS,
        PLACE_INTERACTIONS,
        PLACE_TRAINING,
        RELATION_INTERACTIONS,
        RELATION_TRAINING,
        TRAINING,
    )
    from neurosym.stages.relating import train_relations_stage
    from neurosym.stages.training import train_stage

    domain = opened(folder)
    bits = {"object_bits": object_bits, "action_bits": action_bits}
    domain.perform(train_stage(domain, seed=seed, regime=regime, **bits), again=True)
    show_training(domain / TRAINING, domain / INTERACTIONS)
    if (domain / PLACE_INTERACTIONS).exists():
        domain.perform(train_places_stage(domain, seed=seed, regime=regime), again=True)
        say("what carries objects to places:")
        show_training(domain / PLACE_TRAINING, domain / PLACE_INTERACTIONS)
    if (domain / RELATION_INTERACTIONS).exists():
        domain.perform(train_relations_stage(domain, seed=seed, regime=regime), again=True)
        say("what can be done with pairs of objects:")
        show_training(domain / RELATION_TRAINING, domain / RELATION_INTERACTIONS)
    say_next(f"neurosym distill {quoted(folder)}")
    return 0
