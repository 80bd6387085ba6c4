"""The command `neurosym train`: the final fit."""

from neurosym.commands.options import ActionBits, Folder, ObjectBits, RegimeName, Seed, opened
from neurosym.console import say, say_next
from neurosym.wording import quoted


def train(
    folder: Folder,
    seed: Seed = 0,
    regime: RegimeName = "default",
    object_bits: ObjectBits = None,
    action_bits: ActionBits = None,
) -> int:
    """Fit the model whose bits are symbols: `interactions.npz` -> `effect_model.safetensors`."""
    from neurosym.commands.tables import show_training
    from neurosym.stages.aims import TO_OBJECTS, TO_PLACES
    from neurosym.stages.layout import (
        INTERACTIONS,
        PLACE_INTERACTIONS,
        PLACE_TRAINING,
        RELATION_INTERACTIONS,
        RELATION_TRAINING,
        TRAINING,
    )
    from neurosym.stages.training import train_stage

    domain = opened(folder)
    stage = train_stage(domain, seed=seed, regime=regime, object_bits=object_bits, action_bits=action_bits)
    domain.perform(stage, again=True)
    show_training(domain / TRAINING, domain / INTERACTIONS)
    places = PLACE_INTERACTIONS, PLACE_TRAINING, TO_PLACES, "what carries objects to places:"
    pairs = RELATION_INTERACTIONS, RELATION_TRAINING, TO_OBJECTS, "what can be done with pairs:"
    for data, report, aim, about in (places, pairs):
        if (domain / data).exists():
            domain.perform(train_stage(domain, aim, seed=seed, regime=regime), again=True)
            say(about)
            show_training(domain / report, domain / data)
    say_next(f"neurosym distill {quoted(folder)}")
    return 0
