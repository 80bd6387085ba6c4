"""How the effect model is trained, apart from the training itself, so that reading it does not load torch."""

from dataclasses import dataclass, field, replace
from typing import Literal

from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.learning.model_config import EXPLORING, DirectConfig, ModelConfig


@dataclass(frozen=True, slots=True)
class TrainingConfig:
    """How the final fit is made.

    Attributes:
        recipe: "joint" trains the whole network at once (the paper), "refit" then freezes the codes and fits
            the decoder to them, "taught" lets a network without a bottleneck teach what the bits should say.
        epochs: How often every interaction is seen by the whole network.
        batch: Interactions in a mini-batch.
        learning_rate: Step size of Adam.
        loss_coefficient: The coefficient lambda of eq. 9.
        temperature: The temperature tau of eq. 8.
        contrastive: Whether the contrastive loss of eq. 8 is added.
        clip_norm: Greatest norm of a gradient.
        decay: Whether the learning rate falls to zero along a half cosine.
        standardise: Whether effects are standardised inside the networks; else they stay in metres.
        mirrors: Whether interactions are also seen through the mirrors of the world.
        validation_share: Share of the interactions held out, to choose among restarts and to report.
        restarts: How many fits are made; the one that predicts best through its codes is kept.
        direct: How the network without a bottleneck is built.
        direct_epochs: How often it sees every interaction.
        direct_batch: Interactions in its mini-batches.
        direct_rate: Step size of its optimiser, AdamW.
        direct_weight_decay: Weight decay of the same.
        table_actions: Rows of the table of its predictions that is co-clustered.
        table_objects: Columns of that table.
        table_restarts: Starts of the co-clustering.
        named_actions: How many more actions the teacher tells the meaning of, for the encoder to be fitted.
        named_objects: The same of objects.
        naming_starts: From how many starts each encoder is fitted to them; the best is kept.
        naming_steps: Steps of each of these fits; see `for_bits`.
        naming_batch: How many at a time.
        imagined_actions: Actions in a step of the end-to-end fit of the encoders.
        imagined_objects: Objects in it: each action is imagined on each object.
        code_steps: Steps of the end-to-end fit; see `for_bits`.
        code_rate: Greatest step size of Adam for the encoders; half of it in the end-to-end fit.
        decoder_learns_from: "imagined" fits the decoder of "taught" to actions as they come, "data" to
            those that were chosen.
        imagined: Interactions that are imagined for the decoder.
        imagined_epochs: How often the decoder sees each of them.
        refit_epochs: How often the decoder sees every interaction, if it is fitted to the data.
    """

    recipe: Literal["joint", "refit", "taught"] = "taught"
    epochs: int = 100
    batch: int = 512
    learning_rate: float = 1e-3
    loss_coefficient: float = 1.0
    temperature: float = 0.1
    contrastive: bool = True
    clip_norm: float = 1.0
    decay: bool = True
    standardise: bool = True
    mirrors: bool = True
    validation_share: float = 0.1
    restarts: int = 1
    direct: DirectConfig = field(default_factory=DirectConfig)
    direct_epochs: int = 100
    direct_batch: int = 256
    direct_rate: float = 3e-3
    direct_weight_decay: float = 1e-2
    table_actions: int = 3000
    table_objects: int = 96
    table_restarts: int = 20
    named_actions: int = 40_000
    named_objects: int = 4000
    naming_starts: int = 3
    naming_steps: int = 400
    naming_batch: int = 1024
    imagined_actions: int = 256
    imagined_objects: int = 16
    code_steps: int = 1000
    code_rate: float = 2e-3
    decoder_learns_from: Literal["imagined", "data"] = "imagined"
    imagined: int = 60_000
    imagined_epochs: int = 8
    refit_epochs: int = 80

    def __post_init__(self) -> None:
        for name in _COUNTS:
            if getattr(self, name) < 1:
                raise InvalidValue(f"{name} = {getattr(self, name)} must be at least 1.")
        for name in _POSITIVE:
            if not getattr(self, name) > 0:
                raise InvalidValue(f"{name} = {getattr(self, name)} must be positive.")
        if not 0 < self.validation_share < 1:
            raise InvalidValue(f"validation_share = {self.validation_share} must lie between 0 and 1.")
        if self.recipe not in ("joint", "refit", "taught"):
            raise InvalidValue(f"recipe = {self.recipe!r} must be 'joint', 'refit' or 'taught'.")

    def for_bits(self, action_bits: int) -> "TrainingConfig":
        """Return the same with as many steps of the encoders again for each bit of actions beyond three.

        Args:
            action_bits: How many there are.
        """
        times = 1 + max(0, action_bits - _STEPS_ARE_FOR)
        return replace(self, naming_steps=times * self.naming_steps, code_steps=times * self.code_steps)


_STEPS_ARE_FOR = 3  # bits of action symbols
_COUNTS = (
    "epochs",
    "batch",
    "restarts",
    "direct_epochs",
    "direct_batch",
    "table_actions",
    "table_objects",
    "table_restarts",
    "named_actions",
    "named_objects",
    "naming_starts",
    "naming_steps",
    "naming_batch",
    "imagined_actions",
    "imagined_objects",
    "code_steps",
    "imagined",
    "imagined_epochs",
    "refit_epochs",
)
_POSITIVE = (
    "learning_rate",
    "loss_coefficient",
    "temperature",
    "clip_norm",
    "direct_rate",
    "code_rate",
)


@dataclass(frozen=True, slots=True)
class Regime:
    """A network and the way it is trained, that belong together.

    Attributes:
        model: How the network is built.
        training: How the final fit is made.
        exploration: How the network is built whose entropy is explored by.
        exploration_rate: Step size of Adam during exploration.
    """

    model: ModelConfig
    training: TrainingConfig
    exploration_rate: float
    exploration: ModelConfig = EXPLORING


REGIMES = {
    "default": Regime(ModelConfig(), TrainingConfig(), exploration_rate=1e-3),
    "quick": Regime(
        ModelConfig(),
        TrainingConfig(
            direct_epochs=40,
            table_actions=1000,
            table_objects=48,
            table_restarts=4,
            named_actions=10_000,
            named_objects=1000,
            naming_starts=2,
            naming_steps=200,
            naming_batch=512,
            imagined_actions=128,
            code_steps=300,
            imagined=20_000,
        ),
        exploration_rate=1e-3,
    ),
    "paper": Regime(
        ModelConfig(dropout=0.1, gripper_sharpness=None, layer_norm=True),
        TrainingConfig(
            recipe="joint",
            learning_rate=1e-5,
            loss_coefficient=0.01,
            decay=False,
            standardise=False,
            mirrors=False,
        ),
        exploration_rate=1e-5,
        exploration=ModelConfig(dropout=0.1, gripper_sharpness=None, layer_norm=True),
    ),
}


def regime_named(name: str) -> Regime:
    """Return a regime, or raise `UnknownChoice`."""
    if name not in REGIMES:
        raise UnknownChoice("regime", name, REGIMES)
    return REGIMES[name]
