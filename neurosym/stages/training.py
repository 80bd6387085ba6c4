"""The stage that trains: `interactions.npz` -> the networks and how well they fit."""

from typing import Any

from neurosym.console import progress_bar
from neurosym.data.check import training_problems
from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidFile
from neurosym.files import write_json
from neurosym.learning.training_config import regime_named
from neurosym.naming import counted_axes
from neurosym.stages.aims import OBJECTS, Aim
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import DIRECT_MODEL, INTERACTIONS, MODEL, TRAINING, WORLD
from neurosym.stages.manifest import Claim, Stage


def train_stage(
    folder: DomainFolder,
    aim: Aim = OBJECTS,
    *,
    seed: int,
    regime: str,
    object_bits: int | None = None,
    action_bits: int | None = None,
) -> Stage:
    """Make the final fit: `interactions.npz` -> `effect_model.safetensors` and `training.json`.

    Args:
        folder: The domain folder.
        aim: What the actions are aimed at.
        seed: Where all random draws start.
        regime: Network and training.
        object_bits: Bits of an object symbol; the regime's or the aim's if not given.
        action_bits: Bits of an action symbol; likewise.

    Raises:
        UnknownChoice: If there is no such regime.
        InvalidValue: If there can be no such symbols.
    """
    chosen, data = regime_named(regime), aim.file(INTERACTIONS)
    network = chosen.model.with_bits(*(aim.bits or ())).with_bits(object_bits, action_bits)
    learned = (*aim.besides, MODEL, aim.network, TRAINING)

    def work() -> None:
        from neurosym.learning.training import train

        interactions = _trainable(folder, aim)
        files: dict[str, Any] = aim.learn(folder, interactions, chosen, seed)
        with progress_bar(f"training {aim.folder}".rstrip()) as advance:
            trained = train(
                interactions,
                config=chosen.training,
                model_config=network,
                seed=seed,
                progress=lambda stage, share: advance(round(100 * share), 100, stage),
            )
        files |= {TRAINING: trained.report, DIRECT_MODEL: trained.direct, MODEL: trained.model}
        for name in learned:
            path = folder / aim.file(name)
            if path.suffix == ".json":
                write_json(path, files[name])
            else:
                files[name].save(path)

    options = {"seed": seed, "regime": regime, **({} if aim.bits else network.unusual_bits())}
    inputs = (*((WORLD,) if aim.besides else ()), data)
    return Stage(aim.stage("train"), inputs, tuple(map(aim.file, learned)), work, options, Claim.ALONE)


def _trainable(folder: DomainFolder, aim: Aim) -> Interactions:
    """Load a data set, and refuse one that cannot be learned from."""
    path = folder.require(aim.file(INTERACTIONS))
    interactions = Interactions.load(path)
    if problems := training_problems(interactions.columns, interactions.origin):
        raise InvalidFile(path, problems[0])
    if aim.axes not in (None, found := interactions.effects.shape[1]):
        raise InvalidFile(path, f"its effects have {counted_axes(found)}; valid: {aim.axes}")
    return interactions
