"""The stage that explores: `world.toml` -> `interactions.npz`."""

from typing import Any

from neurosym.checks import check_count
from neurosym.console import progress_bar, say
from neurosym.data.interactions import Interactions
from neurosym.data.origin import is_explored
from neurosym.errors import InvalidValue
from neurosym.files import make_folder
from neurosym.learning.training_config import Regime, regime_named
from neurosym.stages.aims import OBJECTS, Aim
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import INTERACTIONS, WORLD
from neurosym.stages.manifest import Claim, Stage
from neurosym.strategies import StrategyName, own_name, strategy_named
from neurosym.wording import quoted
from neurosym.worlds.world_file import origin_of, read_world


def explore_stage(
    folder: DomainFolder,
    aim: Aim = OBJECTS,
    *,
    strategy: StrategyName,
    steps: int,
    seed: int,
    regime: str,
    workers: int,
    min_predicted_effect: float = 0.0,
    object_bits: int | None = None,
    action_bits: int | None = None,
) -> Stage:
    """Explore the world: `world.toml` -> `interactions.npz`, with a checkpoint after every block.

    Bits matter where a network with symbols is explored by: for the strategy `entropy`.
    """
    chosen = check_choices(strategy, regime, min_predicted_effect)
    name, network, path = own_name(strategy), chosen.exploration, folder / aim.file(INTERACTIONS)
    if strategy_named(strategy).curious_about == "entropy":
        network = network.with_bits(object_bits, action_bits)

    def work() -> None:
        from neurosym.exploration.choice import ExplorationConfig
        from neurosym.exploration.curiosity import LearningConfig
        from neurosym.exploration.loop import explore

        check_count(aim.folder or "steps", steps)
        check_steps(folder, steps, aim)
        factory = read_world(folder.require(WORLD))
        if aim.reference:
            aim.check_takes(factory())
        _check_begun(folder, aim, name, seed)
        make_folder(path.parent)
        config = ExplorationConfig(
            min_predicted_effect=min_predicted_effect,
            learning=LearningConfig(
                learning_rate=chosen.exploration_rate, loss_coefficient=chosen.training.loss_coefficient
            ),
        )
        shown = aim.adapt(folder, factory)
        with progress_bar(f"exploring {aim.folder} ({name})".replace("  ", " ")) as advance:
            interactions = explore(
                shown,
                steps=steps,
                strategy=strategy,
                seed=seed,
                workers=workers,
                checkpoint=path.parent,
                config=config,
                model_config=network,
                origin={**origin_of(factory), **aim.origin},
                progress=advance,
            )
        interactions.save(path)

    options: dict[str, Any] = {"strategy": name, "steps": steps, "seed": seed, "regime": regime}
    if min_predicted_effect:
        options["min_predicted_effect"] = min_predicted_effect
    options |= network.unusual_bits()
    inputs, outputs = (WORLD, *aim.builds_on), (aim.file(INTERACTIONS),)
    return Stage(aim.stage("explore"), inputs, outputs, work, options, Claim.ALONE)


def _check_begun(folder: DomainFolder, aim: Aim, strategy: str, seed: int) -> None:
    """Refuse to replace finished interactions by others; the checkpoint that says so too may be gone."""
    from neurosym.exploration.loop import STATE_FILE

    path = folder / aim.file(INTERACTIONS)
    if not path.exists():
        return
    origin = Interactions.load(path).origin
    for name, wanted in (("strategy", strategy), ("seed", seed)):
        if (found := origin.get(name)) != wanted:
            raise InvalidValue(
                f"{path} was explored with {name} = {found!r}, not {wanted!r}; use that again, or remove it "
                "to begin anew."
            )
    if not path.with_name(STATE_FILE).exists():
        say(f"note: {STATE_FILE} is missing, so that exploration begins anew, and comes to the same again")


def check_choices(strategy: StrategyName, regime: str, min_predicted_effect: float = 0.0) -> Regime:
    """Return a regime, or raise unless there are such a strategy and regime, and they can be combined."""
    strategy_named(strategy, min_predicted_effect)
    return regime_named(regime)


def check_steps(folder: DomainFolder, steps: int, aim: Aim = OBJECTS) -> None:
    """Refuse to replace interactions by fewer, or a user's own by any."""
    path = folder / aim.file(INTERACTIONS)
    if not path.exists():
        return
    found = Interactions.load(path)
    if not is_explored(found.origin):
        raise InvalidValue(
            f"{path} holds data which `neurosym explore` did not make; move it away first, or learn from it: "
            f"`neurosym train {quoted(folder.path)}`."
        )
    if len(found) > steps:
        said = f"{path} holds {len(found)} interactions already, more than {steps}"
        raise InvalidValue(f"{said}; remove it, or ask for more.")
