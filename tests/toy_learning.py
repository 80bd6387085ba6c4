"""Data of the toy world, and trainings of it that take a moment."""

from functools import cache

from neurosym.data.interactions import Interactions
from neurosym.exploration.choice import ExplorationConfig
from neurosym.exploration.loop import explore
from neurosym.learning.model_config import DirectConfig, ModelConfig
from neurosym.learning.training_config import TrainingConfig
from neurosym.worlds.toy import make_world

SMALL = ModelConfig(hidden=16)
MOMENT = {
    "epochs": 2,
    "batch": 64,
    "direct": DirectConfig(hidden=16),
    "direct_epochs": 2,
    "table_actions": 60,
    "table_objects": 12,
    "table_restarts": 1,
    "named_actions": 200,
    "named_objects": 100,
    "naming_steps": 10,
    "imagined_actions": 16,
    "imagined_objects": 4,
    "code_steps": 5,
    "imagined": 300,
    "imagined_epochs": 2,
    "refit_epochs": 2,
}
"""Options of a training that learns nearly nothing."""
BRIEF = TrainingConfig(**MOMENT)


@cache
def toy_data(count: int, strategy: str = "random") -> Interactions:
    """Random interactions with the toy world, said to be of some strategy."""
    config = ExplorationConfig(candidates=1, block=count + 1)
    return explore(make_world, steps=count, strategy=strategy, seed=0, config=config)
