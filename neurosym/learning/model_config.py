"""How the effect model is built, apart from the network itself, so that reading it does not load torch."""

from dataclasses import dataclass, replace
from typing import Literal

from neurosym.errors import InvalidValue

PAPER_BITS = (2, 3)
"""Bits of object and action symbols in the paper (section IV-B)."""
DEFAULT_BITS = (2, 4)
"""Bits of object and action symbols of the default regime; docs/learning.md says why."""
PLACE_BITS = (2, 3)
"""Bits of object and action symbols of actions that are aimed at places."""
PAIR_BITS = (5, 3)
"""Bits of kinds of pairs, and of action symbols of actions that are aimed at other objects."""
STATE_BITS = 3
"""Bits of the state that a pair of objects is in."""
_MOST_BITS = {"object_bits": 6, "action_bits": 8}
_MOST_HIDDEN = 4096


@dataclass(frozen=True, slots=True)
class ModelConfig:
    """How the network is built.

    Attributes:
        object_bits: Bits of an object symbol.
        action_bits: Bits of an action symbol.
        hidden: Width of the hidden layers.
        dropout: Share of hidden units dropped in training (the paper does not say how many). None by default:
            what a teacher imagines never repeats itself.
        layer_norm: Whether the concatenated embeddings are layer-normalised (the paper's text). All-plus and
            all-minus then look alike to the decoder.
        gripper_sharpness: Gripper parameters g enter as open or closed, since that is all they do;
            distillation sees sigmoid(sharpness (g - 0.5)). None lets them enter as they are (the paper).
        head: "gaussian" predicts mean and log variance, "mean" the mean alone (the baselines).
    """

    object_bits: int = PAPER_BITS[0]
    action_bits: int = PAPER_BITS[1]
    hidden: int = 128
    dropout: float = 0.0
    layer_norm: bool = False
    gripper_sharpness: float | None = 15.0
    head: Literal["gaussian", "mean"] = "gaussian"

    def __post_init__(self) -> None:
        for name, most in _MOST_BITS.items():
            if not 1 <= getattr(self, name) <= most:
                raise InvalidValue(f"{name} = {getattr(self, name)} must be between 1 and {most}.")
        if not 1 <= self.hidden <= _MOST_HIDDEN:
            raise InvalidValue(f"hidden = {self.hidden} must be between 1 and {_MOST_HIDDEN}.")
        if not 0 <= self.dropout < 1:
            raise InvalidValue(f"dropout = {self.dropout} must be at least 0 and less than 1.")
        if self.head not in ("gaussian", "mean"):
            raise InvalidValue(f"head = {self.head!r} must be 'gaussian' or 'mean'.")

    def with_bits(self, object_bits: int | None = None, action_bits: int | None = None) -> "ModelConfig":
        """Return the same network with symbols of other widths.

        Args:
            object_bits: Bits of an object symbol; as they are if not given.
            action_bits: The same of an action symbol.

        Raises:
            InvalidValue: If there can be no such symbols.
        """
        return replace(
            self,
            object_bits=self.object_bits if object_bits is None else object_bits,
            action_bits=self.action_bits if action_bits is None else action_bits,
        )

    def unusual_bits(self) -> dict[str, int]:
        """Return by name the bits that are not the paper's: records without them mean those."""
        usual = dict(zip(_MOST_BITS, PAPER_BITS, strict=True))
        return {name: getattr(self, name) for name, bits in usual.items() if getattr(self, name) != bits}


EXPLORING = ModelConfig(*PAPER_BITS, dropout=0.1, layer_norm=True)
"""The network whose entropy is explored by, with dropout and LayerNorm as the paper has it."""


@dataclass(frozen=True, slots=True)
class DirectConfig:
    """How a network without a bottleneck is built.

    Attributes:
        hidden: Width of its three hidden layers.
        dropout: Share of hidden units dropped in training.
        gripper_sharpness: As in `ModelConfig`.
        peaks: Whether it also predicts the greatest height on the way, which tells carrying from pushing.
    """

    hidden: int = 256
    dropout: float = 0.1
    gripper_sharpness: float | None = 15.0
    peaks: bool = True
