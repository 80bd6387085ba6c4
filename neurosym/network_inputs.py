"""What networks are shown of actions: grippers open or closed, and mirror images."""

from collections.abc import Sequence

import torch
from jaxtyping import Float
from torch import Tensor

from neurosym.world import Mirror


def with_gripper_states(
    actions: Float[Tensor, "B A"], columns: Sequence[int], sharpness: float | None
) -> Float[Tensor, "B A"]:
    """Put 1 for an open gripper (g >= 0.5) and 0 for a closed one; downhill is where sigmoid says it is.

    A gripper value acts only through the threshold. Backwards the step counts as
    sigmoid(sharpness (g - 0.5)), so that distillation can still move it.

    Args:
        actions: Action parameters.
        columns: Which of them are gripper values.
        sharpness: Of the sigmoid; None leaves the values as they are (the paper).
    """
    if sharpness is None or not columns:
        return actions
    chosen = list(columns)
    state = (actions[:, chosen] >= 0.5).to(actions.dtype)
    if actions.requires_grad:
        smooth = torch.sigmoid(sharpness * (actions[:, chosen] - 0.5))
        state = state + smooth - smooth.detach()
    return actions.index_copy(1, torch.tensor(chosen), state)


def reflected(
    actions: Float[Tensor, "B A"],
    effects: Float[Tensor, "B E"],
    mirrors: Sequence[Mirror],
    generator: torch.Generator,
) -> tuple[Float[Tensor, "B A"], Float[Tensor, "B E"]]:
    """Look at each sample through each mirror or not, by the toss of a coin.

    Args:
        actions: Action parameters.
        effects: Their effects.
        mirrors: Those of the world.
        generator: Source of randomness, owned by the caller.
    """
    if not mirrors:
        return actions, effects
    action_signs, effect_signs = torch.ones_like(actions), torch.ones_like(effects)
    for mirror in mirrors:
        coin = torch.randint(2, (len(actions), 1), generator=generator) * 2.0 - 1
        action_signs[:, list(mirror.actions)] *= coin
        effect_signs[:, list(mirror.effects)] *= coin
    return actions * action_signs, effects * effect_signs
