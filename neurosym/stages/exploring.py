"""The stage that explores: `world.toml` -> `interactions.npz`."""

from typing import Any

from neurosym.checks import check_count
from neurosym.console import progress_bar, say
from neurosym.data.interactions import Interactions
from neurosym.data.origin import is_explored
from neurosym.errors import InvalidValue
from neurosym.learning.training_config import Regime, regime_named
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import INTERACTIONS, WORLD
from neurosym.stages.manifest import Claim, Stage
from neurosym.strategies import StrategyName, own_name, strategy_named
from neurosym.wording import quoted
from neurosym.worlds.world_file import origin_of, read_world


def explore_stage(
    folder: DomainFolder,
    *,
    strategy: StrategyName,
    steps: int,
    seed: int,
    regime: str,
    workers: int,
    ray: str | None = None,
    min_predicted_effect: float = 0.0,
    object_bits: int | None = None,
    action_bits: int | None = None,
) -> Stage:
    """Explore the world: `world.toml` -> `interactions.npz`, with a checkpoint after every block.

    Bits matter where a network with symbols is explored by: for the strategy `entropy`.
    """
    chosen = check_choices(strategy, regime, min_predicted_effect)
    name, network = own_name(strategy), chosen.exploration
    if strategy_named(strategy).curious_about == "entropy":
        network = network.with_bits(object_bits, action_bits)

    def work() -> None:
        from neurosym.exploration.choice import ExplorationConfig
        from neurosym.exploration.curiosity import LearningConfig
        from neurosym.exploration.loop import explore

        check_count("steps", steps)
        check_steps(folder, steps)
        factory = read_world(folder.require(WORLD))
        _check_begun(folder, name, seed)
        config = ExplorationConfig(
            min_predicted_effect=min_predicted_effect,
            learning=LearningConfig(
                learning_rate=chosen.exploration_rate, loss_coefficient=chosen.training.loss_coefficient
            ),
        )
        with progress_bar(f"exploring ({name})") as advance:
            interactions = explore(
                factory,
                steps=steps,
                strategy=strategy,
                seed=seed,
                workers=workers,
                ray=ray,
                checkpoint=folder.path,
                config=config,
                model_config=network,
                origin=origin_of(factory),
                progress=advance,
            )
        interactions.save(folder / INTERACTIONS)

    options: dict[str, Any] = {"strategy": name, "steps": steps, "seed": seed, "regime": regime}
    if min_predicted_effect:
        options["min_predicted_effect"] = min_predicted_effect
    options |= network.unusual_bits()
    return Stage("explore", (WORLD,), (INTERACTIONS,), work, options, Claim.ALONE)


def _check_begun(folder: DomainFolder, strategy: str, seed: int) -> None:
    """Refuse to replace finished interactions by others; the checkpoint that says so too may be gone."""
    from neurosym.exploration.loop import STATE_FILE

    path = folder / INTERACTIONS
    if not path.exists():
        return
    origin = Interactions.load(path).origin
    for name, wanted in (("strategy", strategy), ("seed", seed)):
        if (found := origin.get(name)) != wanted:
            raise InvalidValue(
                f"{path} was explored with {name} = {found!r}, not {wanted!r}; use that again, or remove it "
                "to begin anew."
            )
    if not (folder / STATE_FILE).exists():
        say(f"note: {STATE_FILE} is missing, so that exploration begins anew, and comes to the same again")


def check_choices(strategy: StrategyName, regime: str, min_predicted_effect: float = 0.0) -> Regime:
    """Return a regime, or raise unless there are such a strategy and regime, and they can be combined."""
    strategy_named(strategy, min_predicted_effect)
    return regime_named(regime)


def has_own_data(folder: DomainFolder) -> bool:
    """Say whether the interactions in a folder are a user's own."""
    path = folder / INTERACTIONS
    return path.exists() and not is_explored(Interactions.load(path).origin)


def check_steps(folder: DomainFolder, steps: int) -> None:
    """Refuse to replace interactions by fewer, or a user's own by any."""
    path = folder / INTERACTIONS
    if not path.exists():
        return
    if has_own_data(folder):
        raise InvalidValue(
            f"{path} holds data which `neurosym explore` did not make; move it away first, or learn from it: "
            f"`neurosym train {quoted(folder.path)}`."
        )
    if (count := len(Interactions.load(path))) > steps:
        said = f"{path} holds {count} interactions already, more than {steps}"
        raise InvalidValue(f"{said}; remove it, or ask for more.")
