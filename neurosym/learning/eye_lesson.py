"""How an eye learns: what it tells of crops is to foretell, with an action, the effect, and to redraw crops.

The first needs acting, and is what symbols are for. The second needs looking only, and keeps what few
actions showed to matter yet.
"""

from dataclasses import asdict, dataclass
from itertools import pairwise

import numpy as np
import torch
from torch import Tensor, nn
from torch.nn import functional

from neurosym.checks import Float
from neurosym.data.interactions import Interactions
from neurosym.data.origin import Dimensions
from neurosym.errors import InvalidValue
from neurosym.learning.losses import FitProgress, Samples, reproducible, run_epochs, samples_of, squared_error
from neurosym.learning.network import DirectModel, tensor
from neurosym.learning.training_config import DirectConfig, check_positive
from neurosym.perception.eye import CHANNELS, DEEP, FLAT, NUMBERS, Eye
from neurosym.perception.regions import CELLS


@dataclass(frozen=True, slots=True)
class LessonConfig:
    """How an eye learns."""

    epochs: int = 60  # how often it sees every interaction
    batch: int = 256  # interactions in a mini-batch, and as many crops to redraw
    rate: float = 3e-3  # step size of its optimiser, AdamW
    weight_decay: float = 1e-2  # weight decay of the same
    drawing: float = 1.0  # how much redrawing a crop counts beside foretelling an effect

    def __post_init__(self) -> None:
        check_positive(self)


class _Eye(nn.Module):
    """The eye while it learns."""

    def __init__(self) -> None:
        super().__init__()
        pairs = pairwise(CHANNELS)
        self.convolution = nn.ModuleList(nn.Conv2d(one, two, 3, stride=2, padding=1) for one, two in pairs)
        self.hidden = nn.Linear(CHANNELS[-1] * (CELLS >> len(self.convolution)) ** 2, FLAT)
        self.told = nn.Linear(FLAT, NUMBERS)
        self.norm = nn.BatchNorm1d(NUMBERS, affine=False)

    def forward(self, crops: Float[Tensor, "B cells cells"]) -> Float[Tensor, "B numbers"]:
        """Tell crops [m]."""
        seen = DEEP * crops[:, None]
        for convolution in self.convolution:
            seen = functional.relu(convolution(seen))
        told: Tensor = self.norm(self.told(functional.relu(self.hidden(seen.flatten(1)))))
        return told

    def weights(self) -> dict[str, np.ndarray]:
        """Return what it learned, by the names that `Eye` knows."""
        found = {name: value.numpy().astype(np.float64) for name, value in self.state_dict().items()}
        mean, variance = found.pop("norm.running_mean"), found.pop("norm.running_var")
        del found["norm.num_batches_tracked"]
        return {**found, "mean": mean, "variance": variance}


def teach(
    crops: Float[np.ndarray, "N cells cells"],
    interactions: Interactions,
    looks: Float[np.ndarray, "L cells cells"],
    *,
    seed: int,
    config: LessonConfig | None = None,
    progress: FitProgress = lambda *_: None,
) -> Eye:
    """Teach an eye; the same seed gives the same bytes.

    Args:
        crops: What the target of each interaction looked like [m].
        interactions: What was done with it, and what came of it.
        looks: Crops that were only looked at [m].
        seed: Where all draws start.
        config: How it learns.
        progress: Called with what is done and the share of it that is done.

    Raises:
        InvalidValue: If all crops look the same.
    """
    config, samples = config or LessonConfig(), samples_of(interactions)
    outcomes = torch.cat([samples.effects, samples.peaks[:, None]], dim=1)
    grippers = tuple(interactions.origin.get("gripper_columns", ()))
    sizes = Dimensions(NUMBERS, samples.actions.shape[1], samples.effects.shape[1], grippers)
    shown, drawn = tensor(crops), tensor(np.concatenate([crops, looks]))
    spread = (DEEP * drawn).var(0).mean()
    if not spread > 0:
        raise InvalidValue("All crops look the same, so that nothing can be learned from them.")
    with reproducible(seed) as generator:
        eye, foretold = _Eye(), DirectModel(sizes, DirectConfig())
        foretold.set_scale(outcomes, samples.mirrored_axes)
        redrawn = nn.Sequential(nn.Linear(NUMBERS, 128), nn.ReLU(), nn.Linear(128, CELLS**2))
        learning = nn.ModuleList([eye, foretold, redrawn])
        optimiser = torch.optim.AdamW(learning.parameters(), lr=config.rate, weight_decay=config.weight_decay)

        def loss(rows: Tensor) -> Tensor:
            seen, actions, wanted = _mirrored(shown[rows], samples, rows, outcomes, generator)
            told = squared_error(foretold, eye(seen), actions, wanted)
            some = drawn[torch.randint(len(drawn), (config.batch,), generator=generator)]
            missed = functional.mse_loss(redrawn(eye(some)), DEEP * some.flatten(1))
            return told + config.drawing * missed / spread

        run_epochs(
            loss,
            len(interactions),
            optimiser,
            generator,
            epochs=config.epochs,
            batch=config.batch,
            clip_norm=1.0,
            decay=True,
            after_epoch=lambda epoch: progress("seeing", epoch / config.epochs),
        )
    taught_by = {"config": asdict(config), "seed": seed, "interactions": len(crops), "looks": len(looks)}
    return Eye(eye.weights(), taught_by)


def _mirrored(
    crops: Float[Tensor, "B cells cells"],
    samples: Samples,
    rows: Tensor,
    outcomes: Float[Tensor, "N O"],
    generator: torch.Generator,
) -> tuple[Tensor, Tensor, Tensor]:
    """Look at samples through each mirror of the world or not, crops and all."""
    action_signs = torch.ones(len(rows), samples.actions.shape[1])
    outcome_signs = torch.ones(len(rows), outcomes.shape[1])
    for mirror in samples.mirrors:
        coin = torch.randint(2, (len(rows),), generator=generator).bool()
        for axis in (axis for axis in mirror.effects if axis < 2):  # a crop is seen from above
            crops = torch.where(coin[:, None, None], crops.flip(1 + axis), crops)
        signs = torch.where(coin, -1.0, 1.0)[:, None]
        action_signs[:, list(mirror.actions)] *= signs
        outcome_signs[:, list(mirror.effects)] *= signs
    return crops, samples.actions[rows] * action_signs, outcomes[rows] * outcome_signs
