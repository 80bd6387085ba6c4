"""Exploring and training where every action is aimed at something: at places, or at other objects.

Both are done as without an aim, in a world that is made of the usual one; data and networks are of their own.
"""

from pathlib import Path
from typing import TYPE_CHECKING, Any

from neurosym.console import progress_bar
from neurosym.data.check import training_problems
from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidFile, InvalidValue
from neurosym.files import make_folder
from neurosym.learning.training_config import Regime
from neurosym.naming import counted_axes
from neurosym.stages.layout import INTERACTIONS
from neurosym.strategies import StrategyName, own_name
from neurosym.world import World, WorldFactory, references_of

if TYPE_CHECKING:  # importing torch takes seconds
    from neurosym.learning.training import Trained


def check_takes(world: World, reference: str) -> None:
    """Raise `InvalidValue` unless actions in a world can be aimed at such references.

    Args:
        world: The world.
        reference: "place" or "object".
    """
    if reference not in references_of(world):
        what = {"place": "places", "object": "relations"}[reference]
        raise InvalidValue(
            f"The world {world.name} takes no {reference} as a reference, so nothing can be learned of "
            f"{what}; leave out --{what}."
        )


def explore_aimed(
    world: WorldFactory,
    folder: Path,
    *,
    what: str,
    regime: Regime,
    strategy: StrategyName,
    steps: int,
    seed: int,
    workers: int,
    ray: str | None,
    origin: dict[str, Any],
) -> None:
    """Explore a world in which actions are aimed; what was done of it before is not done again.

    Args:
        world: Makes it.
        folder: Where the interactions go.
        what: What actions are aimed at, in the plural.
        regime: Network and training.
        strategy: How actions are chosen.
        steps: Interactions to make.
        seed: Where all random draws start.
        workers: Processes that simulate.
        ray: Address of a cluster, if that simulates.
        origin: What the data will say of where they come from.
    """
    from neurosym.exploration.choice import ExplorationConfig
    from neurosym.exploration.curiosity import LearningConfig
    from neurosym.exploration.loop import explore

    make_folder(folder)
    learning = LearningConfig(
        learning_rate=regime.exploration_rate, loss_coefficient=regime.training.loss_coefficient
    )
    with progress_bar(f"exploring {what} ({own_name(strategy)})") as advance:
        interactions = explore(
            world,
            steps=steps,
            strategy=strategy,
            seed=seed,
            workers=workers,
            ray=ray,
            checkpoint=folder,
            config=ExplorationConfig(learning=learning),
            model_config=regime.exploration,
            origin=origin,
            progress=advance,
        )
    interactions.save(folder / INTERACTIONS)


def aimed_interactions(path: Path, axes: int) -> Interactions:
    """Read interactions to train with.

    Args:
        path: The file.
        axes: How many axes their effects shall have.

    Raises:
        InvalidFile: If nothing can be learned from them, or their effects are others.
    """
    interactions = Interactions.load(path)
    if problems := training_problems(interactions.columns, interactions.origin):
        raise InvalidFile(path, problems[0])
    if (found := interactions.effects.shape[1]) != axes:
        raise InvalidFile(path, f"its effects have {counted_axes(found)}; valid: {axes}")
    return interactions


def train_aimed(
    interactions: Interactions, *, what: str, regime: Regime, bits: tuple[int, int], seed: int
) -> "Trained":
    """Fit the networks.

    Args:
        interactions: The data.
        what: What actions are aimed at, in the plural.
        regime: Network and training.
        bits: Bits of the symbols of objects, or of pairs, and of actions.
        seed: Where all random draws start.
    """
    from neurosym.learning.training import train

    with progress_bar(f"training on {what}") as advance:
        return train(
            interactions,
            config=regime.training,
            model_config=regime.model.with_bits(*bits),
            seed=seed,
            progress=lambda stage, share: advance(round(100 * share), 100, stage),
        )
