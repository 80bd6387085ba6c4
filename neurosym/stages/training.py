"""The stage that trains: `interactions.npz` -> the networks and how well they fit."""

from pathlib import Path

from neurosym.console import progress_bar
from neurosym.data.check import training_problems
from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidFile
from neurosym.files import write_json
from neurosym.learning.training_config import regime_named
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import DIRECT_MODEL, INTERACTIONS, MODEL, TRAINING
from neurosym.stages.manifest import Claim, Stage


def train_stage(
    folder: DomainFolder,
    *,
    seed: int,
    regime: str,
    object_bits: int | None = None,
    action_bits: int | None = None,
) -> Stage:
    """Make the final fit: `interactions.npz` -> `effect_model.safetensors` and `training.json`.

    Args:
        folder: The domain folder.
        seed: Where all random draws start.
        regime: Network and training.
        object_bits: Bits of an object symbol; the regime's if not given.
        action_bits: Bits of an action symbol; the regime's if not given.

    Raises:
        UnknownChoice: If there is no such regime.
        InvalidValue: If there can be no such symbols.
    """
    chosen = regime_named(regime)
    network = chosen.model.with_bits(object_bits, action_bits)

    def work() -> None:
        from neurosym.learning.training import train

        interactions = _trainable(folder.require(INTERACTIONS))
        with progress_bar("training") as advance:
            trained = train(
                interactions,
                config=chosen.training,
                model_config=network,
                seed=seed,
                progress=lambda stage, share: advance(round(100 * share), 100, stage),
            )
        write_json(folder / TRAINING, trained.report)
        trained.direct.save(folder / DIRECT_MODEL)
        trained.model.save(folder / MODEL)

    options = {"seed": seed, "regime": regime, **network.unusual_bits()}
    return Stage("train", (INTERACTIONS,), (MODEL, DIRECT_MODEL, TRAINING), work, options, Claim.ALONE)


def _trainable(path: Path) -> Interactions:
    """Load a data set, and refuse one that cannot be learned from."""
    interactions = Interactions.load(path)
    if problems := training_problems(interactions.columns, interactions.origin):
        raise InvalidFile(path, problems[0])
    return interactions
