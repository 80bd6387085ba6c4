"""How the effect model is trained, apart from the training itself, so that reading it does not load torch."""

from dataclasses import asdict, dataclass, field, fields, replace
from typing import Any, Literal

from neurosym.errors import InvalidValue, UnknownChoice

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
_MOST = {"object_bits": 6, "action_bits": 8, "hidden": 4096}


def check_positive(config: Any, *besides: str) -> None:
    """Raise `InvalidValue` unless all whole numbers of a configuration are at least 1, and others positive.

    Args:
        config: The configuration.
        besides: Names of numbers that may be anything.
    """
    for one in fields(config):
        value, is_whole = getattr(config, one.name), one.type is int
        if one.name in besides or one.type not in (int, float) or (value >= 1 if is_whole else value > 0):
            continue
        valid = "at least 1" if is_whole else "positive"
        raise InvalidValue(f"{type(config).__name__}.{one.name} = {value} must be {valid}.")


@dataclass(frozen=True, slots=True)
class ModelConfig:
    """How the network is built."""

    object_bits: int = PAPER_BITS[0]  # bits of an object symbol
    action_bits: int = PAPER_BITS[1]  # bits of an action symbol
    hidden: int = 128  # width of the hidden layers
    # share of hidden units dropped in training (the paper does not say how many). None by default: what a
    # teacher imagines never repeats itself
    dropout: float = 0.0
    # whether the concatenated embeddings are layer-normalised (the paper's text). All-plus and all-minus then
    # look alike to the decoder
    layer_norm: bool = False
    # gripper parameters g enter as open or closed, since that is all they do; distillation sees
    # sigmoid(sharpness (g - 0.5)). None lets them enter as they are (the paper)
    gripper_sharpness: float | None = 15.0
    # "gaussian" predicts mean and log variance, "mean" the mean alone (the baselines)
    head: Literal["gaussian", "mean"] = "gaussian"

    def __post_init__(self) -> None:
        for name, most in _MOST.items():
            if not 1 <= getattr(self, name) <= most:
                raise InvalidValue(f"{name} = {getattr(self, name)} must be between 1 and {most}.")
        if not 0 <= self.dropout < 1:
            raise InvalidValue(f"dropout = {self.dropout} must be at least 0 and less than 1.")
        if self.head not in ("gaussian", "mean"):
            raise InvalidValue(f"head = {self.head!r} must be 'gaussian' or 'mean'.")

    def with_bits(self, object_bits: int | None = None, action_bits: int | None = None) -> "ModelConfig":
        """Return the same network with symbols of other widths, or raise `InvalidValue`.

        Args:
            object_bits: Bits of an object symbol; as they are if not given.
            action_bits: The same of an action symbol.
        """
        given: dict[str, Any] = {"object_bits": object_bits, "action_bits": action_bits}
        return replace(self, **{name: bits for name, bits in given.items() if bits is not None})

    def unusual_bits(self) -> dict[str, int]:
        """Return by name the bits that are not the paper's: records without them mean those."""
        bits = {"object_bits": self.object_bits, "action_bits": self.action_bits}
        return {name: bits[name] for name, usual in zip(bits, PAPER_BITS, strict=True) if bits[name] != usual}


EXPLORING = ModelConfig(*PAPER_BITS, dropout=0.1, layer_norm=True)
"""The network whose entropy is explored by, with dropout and LayerNorm as the paper has it."""


@dataclass(frozen=True, slots=True)
class DirectConfig:
    """How a network without a bottleneck is built."""

    hidden: int = 256  # width of its three hidden layers
    dropout: float = 0.1  # share of hidden units dropped in training
    gripper_sharpness: float | None = 15.0  # as in `ModelConfig`
    # whether it also predicts the greatest height on the way, which tells carrying from pushing
    peaks: bool = True


@dataclass(frozen=True, slots=True)
class TeacherConfig:
    """How the network without a bottleneck is fitted, which teaches what the bits should say."""

    network: DirectConfig = field(default_factory=DirectConfig)  # how it is built
    epochs: int = 100  # how often it sees every interaction
    batch: int = 256  # interactions in its mini-batches
    rate: float = 3e-3  # step size of its optimiser, AdamW
    weight_decay: float = 1e-2  # weight decay of the same

    def __post_init__(self) -> None:
        check_positive(self, "weight_decay")


@dataclass(frozen=True, slots=True)
class NamingConfig:
    """What encoders begin with: a fit to the codes of a co-clustering of the predictions of the teacher."""

    table_actions: int = 3000  # rows of the table of predictions that is co-clustered
    table_objects: int = 96  # columns of that table
    table_restarts: int = 20  # starts of the co-clustering
    # how many more actions the teacher tells the meaning of, for the encoder to be fitted
    actions: int = 40_000
    objects: int = 4000  # the same of objects
    starts: int = 3  # from how many starts each encoder is fitted to them; the best is kept
    steps: int = 400  # steps of each of these fits; see `TrainingConfig.for_bits`
    batch: int = 1024  # how many at a time

    def __post_init__(self) -> None:
        check_positive(self)


@dataclass(frozen=True, slots=True)
class CodingConfig:
    """How both encoders are fitted end to end."""

    actions: int = 256  # actions in a step
    objects: int = 16  # objects in it: each action is imagined on each object
    steps: int = 1000  # how many steps; see `TrainingConfig.for_bits`
    rate: float = 2e-3  # greatest step size of Adam for the encoders; half of it in this fit

    def __post_init__(self) -> None:
        check_positive(self)


@dataclass(frozen=True, slots=True)
class DecoderConfig:
    """What the decoder is fitted to in the end."""

    # "imagined" fits the decoder of "taught" to actions as they come, "data" to those that were chosen
    learns_from: Literal["imagined", "data"] = "imagined"
    imagined: int = 60_000  # interactions that are imagined for it
    imagined_epochs: int = 8  # how often it sees each of them
    epochs: int = 80  # how often it sees every interaction, if it is fitted to the data

    def __post_init__(self) -> None:
        check_positive(self)


@dataclass(frozen=True, slots=True)
class TrainingConfig:
    """How the final fit is made."""

    # "joint" trains the whole network at once (the paper), "refit" then freezes the codes and fits the
    # decoder to them, "taught" lets a network without a bottleneck teach what the bits should say
    recipe: Literal["joint", "refit", "taught"] = "taught"
    epochs: int = 100  # how often every interaction is seen by the whole network
    batch: int = 512  # interactions in a mini-batch
    learning_rate: float = 1e-3  # step size of Adam
    loss_coefficient: float = 1.0  # the coefficient lambda of eq. 9
    temperature: float = 0.1  # the temperature tau of eq. 8
    contrastive: bool = True  # whether the contrastive loss of eq. 8 is added
    clip_norm: float = 1.0  # greatest norm of a gradient
    decay: bool = True  # whether the learning rate falls to zero along a half cosine
    standardise: bool = True  # whether effects are standardised inside the networks; else they stay in metres
    mirrors: bool = True  # whether interactions are also seen through the mirrors of the world
    validation_share: float = 0.1  # share of the interactions held out, to report how well they are predicted
    # how the network without a bottleneck is fitted
    teacher: TeacherConfig = field(default_factory=TeacherConfig)
    naming: NamingConfig = field(default_factory=NamingConfig)  # what the encoders of "taught" begin with
    coding: CodingConfig = field(default_factory=CodingConfig)  # how they are fitted end to end
    decoder: DecoderConfig = field(default_factory=DecoderConfig)  # what its decoder is fitted to

    def __post_init__(self) -> None:
        check_positive(self)
        if self.validation_share >= 1:
            raise InvalidValue(f"validation_share = {self.validation_share} must lie between 0 and 1.")
        if self.recipe not in ("joint", "refit", "taught"):
            raise InvalidValue(f"recipe = {self.recipe!r} must be 'joint', 'refit' or 'taught'.")

    def for_bits(self, action_bits: int, object_bits: int = 0) -> "TrainingConfig":
        """Return the same with as many steps of the encoders again for each bit of actions beyond three.

        The table that is co-clustered gets rows and columns enough for as many kinds as there are codes.
        """
        times = 1 + max(0, action_bits - _STEPS_ARE_FOR)
        naming = replace(
            self.naming,
            steps=times * self.naming.steps,
            table_actions=max(self.naming.table_actions, _OF_EACH_KIND * 2**action_bits),
            table_objects=max(self.naming.table_objects, _OF_EACH_KIND * 2**object_bits),
        )
        return replace(self, naming=naming, coding=replace(self.coding, steps=times * self.coding.steps))

    def as_stored(self) -> dict[str, Any]:
        """Return plain JSON values by the names that model files have had from the beginning."""
        flat = asdict(self) | {"restarts": 1}  # which could be chosen once
        for part, names in _STORED.items():
            flat |= {names.get(name, name): value for name, value in flat.pop(part).items()}
        return flat


_STEPS_ARE_FOR = 3  # bits of action symbols
_OF_EACH_KIND = 3  # rows or columns of the table that is co-clustered
_STORED = {
    "teacher": {
        "network": "direct",
        "epochs": "direct_epochs",
        "batch": "direct_batch",
        "rate": "direct_rate",
        "weight_decay": "direct_weight_decay",
    },
    "naming": {
        "actions": "named_actions",
        "objects": "named_objects",
        "starts": "naming_starts",
        "steps": "naming_steps",
        "batch": "naming_batch",
    },
    "coding": {
        "actions": "imagined_actions",
        "objects": "imagined_objects",
        "steps": "code_steps",
        "rate": "code_rate",
    },
    "decoder": {"learns_from": "decoder_learns_from", "epochs": "refit_epochs"},
}
"""What parts and their options are called in model files, where it is not by their own names."""


@dataclass(frozen=True, slots=True)
class Regime:
    """A network and the way it is trained, that belong together."""

    model: ModelConfig  # how the network is built
    training: TrainingConfig  # how the final fit is made
    exploration_rate: float  # step size of Adam during exploration
    exploration: ModelConfig = EXPLORING  # how the network is built whose entropy is explored by


_PRINTED = ModelConfig(*PAPER_BITS, dropout=0.1, gripper_sharpness=None, layer_norm=True)
REGIMES = {
    "default": Regime(ModelConfig(*DEFAULT_BITS), TrainingConfig(), exploration_rate=1e-3),
    "quick": Regime(
        ModelConfig(),
        TrainingConfig(
            teacher=TeacherConfig(epochs=40),
            naming=NamingConfig(
                table_actions=1000,
                table_objects=48,
                table_restarts=4,
                actions=10_000,
                objects=1000,
                starts=2,
                steps=200,
                batch=512,
            ),
            coding=CodingConfig(actions=128, steps=300),
            decoder=DecoderConfig(imagined=20_000),
        ),
        exploration_rate=1e-3,
    ),
    "paper": Regime(
        _PRINTED,
        TrainingConfig(
            recipe="joint",
            learning_rate=1e-5,
            loss_coefficient=0.01,
            decay=False,
            standardise=False,
            mirrors=False,
        ),
        exploration_rate=1e-5,
        exploration=_PRINTED,
    ),
}


def regime_named(name: str) -> Regime:
    """Return a regime, or raise `UnknownChoice`."""
    if name not in REGIMES:
        raise UnknownChoice("regime", name, REGIMES)
    return REGIMES[name]
