"""What is tried next: candidates are drawn, and a curious strategy picks the one it knows least about."""

from dataclasses import dataclass, field

import numpy as np

from neurosym.arrays import Float
from neurosym.errors import InvalidValue
from neurosym.exploration.curiosity import Curiosity, LearningConfig
from neurosym.learning.training_config import check_numbers
from neurosym.world import Scene, World
from neurosym.worlds.workers import Task


@dataclass(frozen=True, slots=True)
class ExplorationConfig:
    """How exploration goes on.

    Attributes:
        candidates: How many actions are drawn to choose one from.
        block: Interactions between two updates of the networks.
        min_predicted_effect: Only candidates with at least this predicted sum of absolute displacements are
            chosen from, if there are any [m]; 0 chooses from all (the paper; its authors' code: 0.1).
        learning: How the networks of a curious strategy learn.
    """

    candidates: int = 2000
    block: int = 512
    min_predicted_effect: float = 0.0
    learning: LearningConfig = field(default_factory=LearningConfig)

    def __post_init__(self) -> None:
        check_numbers("", self, counts=("candidates", "block"))
        if not 0 <= self.min_predicted_effect < np.inf:
            raise InvalidValue(
                f"min_predicted_effect = {self.min_predicted_effect} m must be at least 0, and finite."
            )


def choose_action(
    world: World, curiosity: Curiosity | None, config: ExplorationConfig, seed: int, number: int
) -> Task:
    """Draw a scene, or as many as the world says, and candidates for each, and choose among them.

    Args:
        world: Where scenes and actions come from.
        curiosity: Says which candidate is known least; without it, the first is chosen: a random action.
        config: How many candidates.
        seed: Of the exploration.
        number: Of the interaction.
    """
    rng = np.random.default_rng([seed, number])
    several = getattr(world, "scenes_to_choose_from", 1) if curiosity is not None else 1
    most, best = -np.inf, None
    for _ in range(several):
        scene = world.sample_scene(rng, 1)
        candidates = _draw(world, scene, config.candidates // several, rng)
        if curiosity is None:
            return Task(scene, candidates[0])
        features = scene.features[0]
        scores = curiosity.uncertainties(features, candidates)
        if config.min_predicted_effect > 0:
            eligible = curiosity.expected_sizes(features, candidates) >= config.min_predicted_effect
            if eligible.any():
                candidates, scores = candidates[eligible], scores[eligible]
        picked = curiosity.pick(scores, rng)
        if best is None or scores[picked] > most:
            most, best = float(scores[picked]), Task(scene, candidates[picked])
    assert best is not None, "there is a scene to choose from"
    return best


def _draw(world: World, scene: Scene, count: int, rng: np.random.Generator) -> Float[np.ndarray, "C A"]:
    """Draw candidates from the box, or as the world says, with the digits that are stored."""
    draw = getattr(world, "draw_actions", None)
    drawn: np.ndarray = draw(rng, scene, count) if draw else world.action_box.sample(rng, count)
    return drawn.astype(np.float32)
