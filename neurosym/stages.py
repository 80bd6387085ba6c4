"""The stages of the way, each from files of a domain folder to files of a domain folder: load, call, save.

The command line performs one stage at a time; `neurosym run` performs all of them, each only where its
inputs, options or outputs have changed. What is slow to import is imported where it is used.
"""

from pathlib import Path
from typing import Any

from neurosym.choosing import CHOICES, choose
from neurosym.console import progress_bar
from neurosym.data_check import model_misfit, training_problems, world_misfit
from neurosym.data_origin import box_of, is_explored
from neurosym.errors import InvalidFile, InvalidValue, UnknownChoice
from neurosym.files import write_json
from neurosym.folder import (
    DIRECT_MODEL,
    INTERACTIONS,
    MODEL,
    PRIMITIVES,
    WORLD,
    DomainFolder,
    Stage,
)
from neurosym.interactions import Interactions
from neurosym.quoting import quoted
from neurosym.strategies import own_name, strategy_named
from neurosym.training_config import REGIMES, Regime
from neurosym.workers import WorldFactory
from neurosym.world import ActionBox
from neurosym.world_file import origin_of, read_world

TRAINING = "training.json"
"""How well the model fits, on interactions held out from training."""


def explore_stage(
    folder: DomainFolder,
    *,
    strategy: str,
    steps: int,
    seed: int,
    regime: str,
    workers: int,
    ray: str | None = None,
    min_predicted_effect: float = 0.0,
) -> Stage:
    """Explore the world: `world.toml` -> `interactions.npz`, with a checkpoint after every block."""
    chosen = check_choices(strategy, regime, min_predicted_effect)
    strategy = own_name(strategy)

    def work() -> None:
        from neurosym.curiosity import LearningConfig
        from neurosym.exploration import ExplorationConfig, explore

        check_steps(folder, steps)
        factory = read_world(folder.require(WORLD))
        config = ExplorationConfig(
            min_predicted_effect=min_predicted_effect,
            learning=LearningConfig(
                learning_rate=chosen.exploration_rate, loss_coefficient=chosen.training.loss_coefficient
            ),
        )
        with progress_bar(f"exploring ({strategy})") as advance:
            interactions = explore(
                factory,
                steps=steps,
                strategy=strategy,
                seed=seed,
                workers=workers,
                ray=ray,
                checkpoint=folder.path,
                config=config,
                model_config=chosen.exploration,
                origin=origin_of(factory),
                progress=advance,
            )
        interactions.save(folder / INTERACTIONS)

    options: dict[str, Any] = {"strategy": strategy, "steps": steps, "seed": seed, "regime": regime}
    if min_predicted_effect:
        options["min_predicted_effect"] = min_predicted_effect
    return Stage("explore", (WORLD,), (INTERACTIONS,), work, options)


def train_stage(folder: DomainFolder, *, seed: int, regime: str) -> Stage:
    """Make the final fit: `interactions.npz` -> `effect_model.safetensors` and `training.json`."""
    chosen = regime_named(regime)

    def work() -> None:
        from neurosym.training import train

        interactions = _trainable(folder.require(INTERACTIONS))
        with progress_bar("training") as advance:
            trained = train(
                interactions,
                config=chosen.training,
                model_config=chosen.model,
                seed=seed,
                progress=lambda stage, share: advance(round(100 * share), 100, stage),
            )
        write_json(folder / TRAINING, trained.report)
        trained.direct.save(folder / DIRECT_MODEL)
        trained.model.save(folder / MODEL)

    options = {"seed": seed, "regime": regime}
    return Stage("train", (INTERACTIONS,), (MODEL, DIRECT_MODEL, TRAINING), work, options)


def distill_stage(
    folder: DomainFolder, *, objects: int, seed: int, workers: int, choice: str = "predictable"
) -> Stage:
    """Distil primitives and rehearse them: model, data and world -> `primitives.json`.

    Without a `world.toml`, nothing is rehearsed: effects are averaged from the data, whose origin, or else
    least and greatest values, are the action box.
    """
    for name, value in (("objects", objects), ("workers", workers)):
        if value < 1:
            raise InvalidValue(f"{name} = {value} must be at least 1.")
    if choice not in CHOICES:
        raise UnknownChoice("choice", choice, CHOICES)

    def work() -> None:
        from neurosym.averaging import average
        from neurosym.direct_model import DirectModel
        from neurosym.distillation import distill
        from neurosym.effect_model import EffectModel
        from neurosym.rehearsal import rehearse, tabulate

        factory = read_world(folder / WORLD) if (folder / WORLD).exists() else None
        model = EffectModel.load(folder.require(MODEL))
        direct = DirectModel.load(folder.require(DIRECT_MODEL))
        interactions = Interactions.load(folder.require(INTERACTIONS))
        for name, network in ((MODEL, model), (DIRECT_MODEL, direct)):
            if problem := model_misfit(network.dimensions, interactions.columns, interactions.origin):
                raise InvalidFile(folder / name, problem)
        box = _box(folder / INTERACTIONS, interactions, factory)
        with progress_bar("distilling") as advance:
            candidates = distill(model, interactions, box, seed=seed, progress=advance)
        if not candidates:
            raise InvalidFile(folder / MODEL, "no action encodes to its symbol; train again")
        categorise = model.object_symbols
        with progress_bar("auditioning") as advance:
            primitives = choose(
                candidates,
                choice,
                predict=direct.predict_outcomes,
                features=interactions.features,
                categorise=categorise,
                world_factory=factory,
                seed=seed,
                workers=workers,
                progress=advance,
            )
        if factory is None:
            averaged = average(interactions, primitives, categorise, model.action_symbols)
            write_json(folder / PRIMITIVES, averaged)
            return
        with progress_bar("rehearsing") as advance:
            rehearsals = rehearse(
                factory, primitives, categorise, objects=objects, seed=seed, workers=workers, progress=advance
            )
        write_json(folder / PRIMITIVES, tabulate(rehearsals, factory().feature_names))

    options = {"objects": objects, "seed": seed, "choice": choice}
    return Stage("distill", (WORLD, MODEL, DIRECT_MODEL, INTERACTIONS), (PRIMITIVES,), work, options)


def check_choices(strategy: str, regime: str, min_predicted_effect: float = 0.0) -> Regime:
    """Return a regime, or raise unless there are such a strategy and regime, and they can be combined."""
    strategy_named(strategy, min_predicted_effect)
    return regime_named(regime)


def regime_named(name: str) -> Regime:
    """Return a regime, or raise `UnknownChoice`."""
    if name not in REGIMES:
        raise UnknownChoice("regime", name, REGIMES)
    return REGIMES[name]


def _trainable(path: Path) -> Interactions:
    """Load a data set, and refuse one that cannot be learned from."""
    interactions = Interactions.load(path)
    if problems := training_problems(interactions.columns, interactions.origin):
        raise InvalidFile(path, problems[0])
    return interactions


def _box(path: Path, interactions: Interactions, factory: WorldFactory | None) -> ActionBox:
    """Return the action box: the world's, or where there is none, the data's."""
    if factory is None:
        low, high, is_gripper = box_of(interactions.actions, interactions.origin)
        return ActionBox(low, high, is_gripper)
    world = factory()
    features, actions = len(world.feature_names), len(world.action_box.low)
    if problem := world_misfit(world.name, features, actions, interactions.columns):
        raise InvalidFile(path, problem)
    return world.action_box


def has_own_data(folder: DomainFolder) -> bool:
    """Say whether the interactions in a folder are a user's own."""
    path = folder / INTERACTIONS
    return path.exists() and not is_explored(Interactions.load(path).origin)


def check_steps(folder: DomainFolder, steps: int) -> None:
    """Refuse to replace interactions by fewer, or a user's own by any."""
    path = folder / INTERACTIONS
    if steps <= 0 or not path.exists():
        return
    if has_own_data(folder):
        raise InvalidValue(
            f"{path} holds data which `neurosym explore` did not make; move it away first, or learn from it: "
            f"`neurosym train {quoted(folder.path)}`."
        )
    if (count := len(Interactions.load(path))) > steps:
        said = f"{path} holds {count} interactions already, more than {steps}"
        raise InvalidValue(f"{said}; remove it, or ask for more.")
