"""Training data as tensors, with what is known of the actions they were drawn from."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import torch
from torch import Tensor

from neurosym.actions import Mirror
from neurosym.arrays import Float, Int
from neurosym.data.dimensions import Dimensions
from neurosym.data.interactions import Interactions
from neurosym.data.origin import mirrors_of, strategy_of
from neurosym.learning.inputs import reflected
from neurosym.learning.network import tensor


@dataclass(frozen=True, slots=True, eq=False)
class Samples:
    """The training data, and where further actions may be drawn from.

    Attributes:
        features: Object features.
        actions: Action parameters.
        effects: Effects [m].
        peaks: Greatest heights on the way [m].
        low: Least value of each action parameter, if the actions were drawn from a box; else None.
        high: Greatest value of each action parameter, likewise.
        mirrors: Mirrors of the world that are made use of.
    """

    features: Float[Tensor, "N F"]
    actions: Float[Tensor, "N A"]
    effects: Float[Tensor, "N E"]
    peaks: Float[Tensor, "N"]
    low: Float[Tensor, "A"] | None
    high: Float[Tensor, "A"] | None
    mirrors: tuple[Mirror, ...] = ()

    def __len__(self) -> int:
        return len(self.features)

    @property
    def mirrored_axes(self) -> tuple[int, ...]:
        """Effect axes whose sign some mirror changes."""
        return tuple(axis for mirror in self.mirrors for axis in mirror.effects)

    def batch(
        self, rows: Int[Tensor, "B"], generator: torch.Generator
    ) -> tuple[Float[Tensor, "B F"], Float[Tensor, "B A"], Float[Tensor, "B E"]]:
        """Take rows, each seen through the mirrors at random."""
        actions, effects = reflected(self.actions[rows], self.effects[rows], self.mirrors, generator)
        return self.features[rows], actions, effects

    def outcomes(self, *, peaks: bool) -> Float[Tensor, "N O"]:
        """Put the peak heights behind the effects, or leave them out."""
        return torch.cat([self.effects, self.peaks[:, None]], dim=1) if peaks else self.effects

    def imagine(
        self, count: int, generator: torch.Generator
    ) -> tuple[Float[Tensor, "B F"], Float[Tensor, "B A"]]:
        """Draw objects and actions, for a teacher to say what would happen.

        Objects are those of the data. Actions come from the box if those of the data did, else from the data.
        """
        rows = torch.randint(len(self), (count,), generator=generator)
        if self.low is None or self.high is None:
            return self.features[rows], self.actions[torch.randint(len(self), (count,), generator=generator)]
        drawn = torch.rand(count, len(self.low), generator=generator)
        return self.features[rows], self.low + drawn * (self.high - self.low)


def samples_of(interactions: Interactions, *, mirrors: bool = True) -> Samples:
    """Turn a data set into tensors, with the box of its actions if they were drawn from it.

    So they were if a strategy explored. Actions of other origin may lie in few places of their box, and so
    do those that were proposed because they do something.

    Args:
        interactions: The data.
        mirrors: Whether to make use of the mirrors that its origin names.
    """
    origin = interactions.origin
    is_drawn = strategy_of(origin) is not None and not origin.get("proposed")
    has_box = is_drawn and "action_low" in origin and "action_high" in origin
    return Samples(
        features=tensor(interactions.features),
        actions=tensor(interactions.actions),
        effects=tensor(interactions.effects),
        peaks=tensor(interactions.peak_heights),
        low=tensor(np.asarray(origin["action_low"])) if has_box else None,
        high=tensor(np.asarray(origin["action_high"])) if has_box else None,
        mirrors=mirrors_of(origin) if mirrors else (),
    )


def dimensions_of(interactions: Interactions) -> Dimensions:
    """Read from a data set what a network for it must read and write."""
    origin: Mapping[str, Any] = interactions.origin
    return Dimensions(
        features=interactions.features.shape[1],
        actions=interactions.actions.shape[1],
        effects=interactions.effects.shape[1],
        gripper_columns=tuple(origin.get("gripper_columns", ())),
    )
