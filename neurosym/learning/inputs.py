"""What networks are shown: inputs normalised, grippers open or closed, and mirror images."""

from collections.abc import Sequence

import torch
from torch import Tensor, nn

from neurosym.actions import Mirror
from neurosym.arrays import Float


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


class InputNorm(nn.BatchNorm1d):
    """Batch normalisation of what a network is shown, except for states of 0 and 1, which become -1 and 1.

    A state that hardly ever changes in the data would be divided by next to nothing, and the other state be
    something that the network has never seen the like of.

    Args:
        inputs: How many inputs there are.
        states: Which of them are states of 0 or 1.
    """

    is_state: Tensor

    def __init__(self, inputs: int, states: Sequence[int]):
        super().__init__(inputs)
        is_state = torch.zeros(inputs, dtype=torch.bool)
        is_state[list(states)] = True
        self.register_buffer("is_state", is_state, persistent=False)

    def forward(self, shown: Float[Tensor, "B I"]) -> Float[Tensor, "B I"]:
        """Normalise the inputs."""
        return torch.where(self.is_state, 2 * shown - 1, super().forward(shown))


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
