"""How the effect model is trained, apart from the training itself, so that reading it does not load torch."""

from dataclasses import dataclass
from typing import Literal

from neurosym.errors import InvalidValue
from neurosym.model_config import ModelConfig


@dataclass(frozen=True, slots=True)
class TrainingConfig:
    """How the final fit is made.

    Attributes:
        recipe: "joint" trains the whole network at once (the paper), "refit" then freezes the codes and fits
            the decoder to them, "teacher" first learns what the bits should say from a network without a
            bottleneck.
        epochs: How often every interaction is seen by the network (or by the teacher).
        batch: Interactions in a mini-batch.
        learning_rate: Step size of Adam.
        loss_coefficient: The coefficient lambda of eq. 9.
        temperature: The temperature tau of eq. 8.
        contrastive: Whether the contrastive loss of eq. 8 is added.
        clip_norm: Greatest norm of a gradient.
        decay: Whether the learning rate falls to zero along a half cosine.
        validation_share: Share of the interactions held out, to choose among restarts and to report.
        restarts: How many fits are made; the one that predicts best through its codes is kept.
        teacher_objects: How many objects the teacher is asked about.
        teacher_actions: How many actions the teacher labels, besides those of the data.
        encoder_epochs: How often the encoders see every label of the teacher.
        refit_epochs: How often the decoder sees every interaction through the codes.
    """

    recipe: Literal["joint", "refit", "teacher"] = "teacher"
    epochs: int = 100
    batch: int = 512
    learning_rate: float = 1e-3
    loss_coefficient: float = 1.0
    temperature: float = 0.1
    contrastive: bool = True
    clip_norm: float = 1.0
    decay: bool = True
    validation_share: float = 0.1
    restarts: int = 3
    teacher_objects: int = 48
    teacher_actions: int = 20_000
    encoder_epochs: int = 60
    refit_epochs: int = 30

    def __post_init__(self) -> None:
        for name in ("epochs", "batch", "restarts", "teacher_objects", "encoder_epochs", "refit_epochs"):
            if getattr(self, name) < 1:
                raise InvalidValue(f"{name} = {getattr(self, name)} must be at least 1.")
        for name in ("learning_rate", "loss_coefficient", "temperature", "clip_norm"):
            if not getattr(self, name) > 0:
                raise InvalidValue(f"{name} = {getattr(self, name)} must be positive.")
        if not 0 < self.validation_share < 1:
            raise InvalidValue(f"validation_share = {self.validation_share} must lie between 0 and 1.")
        if self.recipe not in ("joint", "refit", "teacher"):
            raise InvalidValue(f"recipe = {self.recipe!r} must be 'joint', 'refit' or 'teacher'.")


@dataclass(frozen=True, slots=True)
class Regime:
    """A network and the way it is trained, that belong together.

    Attributes:
        model: How the network is built.
        training: How the final fit is made.
        exploration_rate: Step size of Adam during exploration.
    """

    model: ModelConfig
    training: TrainingConfig
    exploration_rate: float


REGIMES = {
    "default": Regime(ModelConfig(), TrainingConfig(), exploration_rate=1e-3),
    "quick": Regime(
        ModelConfig(),
        TrainingConfig(restarts=1, epochs=60, teacher_actions=4000, encoder_epochs=30),
        exploration_rate=1e-3,
    ),
    "paper": Regime(
        ModelConfig(gripper_sharpness=None),
        TrainingConfig(
            recipe="joint",
            learning_rate=1e-5,
            loss_coefficient=0.01,
            decay=False,
            restarts=1,
        ),
        exploration_rate=1e-5,
    ),
}
