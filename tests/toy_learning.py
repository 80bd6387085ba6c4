"""Data of the toy world, and trainings of it that take a moment."""

from contextlib import contextmanager
from dataclasses import replace
from functools import cache

import numpy as np

from neurosym.data.interactions import Interactions
from neurosym.exploration.loop import ExplorationConfig, explore
from neurosym.learning.training_config import (
    REGIMES,
    CodingConfig,
    DecoderConfig,
    DirectConfig,
    ModelConfig,
    NamingConfig,
    TeacherConfig,
    TrainingConfig,
)
from neurosym.primitives.ledger import Ledger
from neurosym.primitives.search import Search
from neurosym.world import Outcome, Scene
from neurosym.worlds.toy import LONGEST_PUSH, WIDEST_GRASP, ToyWorld, make_world

SMALL = ModelConfig(hidden=16)
BRIEF = TrainingConfig(
    epochs=2,
    batch=64,
    teacher=TeacherConfig(DirectConfig(hidden=16), epochs=2),
    naming=NamingConfig(
        table_actions=60, table_objects=12, table_restarts=1, actions=200, objects=100, steps=10
    ),
    coding=CodingConfig(actions=16, objects=4, steps=5),
    decoder=DecoderConfig(imagined=300, imagined_epochs=2, epochs=2),
)
"""A training that learns nearly nothing."""
TABLE = {"table_actions": 400, "table_objects": 24, "table_restarts": 3}
SHORTENED = replace(
    REGIMES["quick"],
    training=TrainingConfig(
        teacher=TeacherConfig(epochs=20),
        naming=NamingConfig(**TABLE, actions=4000, objects=400, starts=1, steps=100),
        coding=CodingConfig(steps=100),
        decoder=DecoderConfig(imagined=5000, imagined_epochs=3),
    ),
)
"""The quick regime with a training that learns enough of the toy world."""


@cache
def toy_data(count: int, strategy: str = "random") -> Interactions:
    """Random interactions with the toy world, said to be of some strategy."""
    config = ExplorationConfig(candidates=1, block=count + 1)
    return explore(make_world, steps=count, strategy=strategy, seed=0, config=config)


def search(candidates=(), categorise=None, factory=make_world, told=None, workers=1, **options) -> Search:
    """Search for operators in the toy world; what bars tell is added to a list, if given."""

    @contextmanager
    def open_bar(label):
        yield lambda *numbers: told is None or told.append(numbers)

    given = {"predict": foretell, "features": some_features(100), "seed": 0, "open_bar": open_bar}
    given["ledger"] = Ledger(workers=workers)
    return Search(
        tuple(candidates), categorise=categorise, world_factory=factory, shown=factory, **(given | options)
    )


def foretell(features, actions):
    """Say what the toy world would do, by trying it."""
    world, upright = make_world(), np.array([[0.0, 0.0, 0.0, 1.0]])
    middle = np.array([[0.7, 0.0, 0.0]])
    outcomes = [
        world.interact(Scene(row[None], middle, upright), action, 0)
        for row, action in zip(features, actions, strict=True)
    ]
    return np.array([outcome.effect for outcome in outcomes])


def some_features(count=40):
    """Features of objects of the toy world."""
    scenes = [make_world().sample_scene(np.random.default_rng([5, n]), 1) for n in range(count)]
    return np.concatenate([scene.features for scene in scenes])


class Changed(ToyWorld):
    """A toy world that in which functions change what is performed, and what is told of it."""

    def __init__(self, change=lambda _, action: action, told=lambda _, outcome: outcome):
        super().__init__(make_world().config)
        self.change, self.told = change, told

    def interact(self, scene, action, target, **options):  # noqa: D102
        return self.told(action, super().interact(scene, self.change(scene, action), target, **options))


def an_outcome(shift=(0.0, 0.0, 0.0), rest=None, **flags):
    """An outcome of one object that ends the rise so far from its start, and rests there or elsewhere."""

    def scene(offset):
        return Scene(np.ones((1, 4)), np.array([offset], dtype=float), np.array([[0.0, 0, 0, 1]]))

    flags = {"held": False, "toppled": False, "lost": False, "peak_height": 0.0, **flags}
    return Outcome(scene((0, 0, 0)), scene(shift), scene(shift if rest is None else rest), 0, **flags)


# Actions of the toy world, and categories of its objects

SHORT = (0.0, -0.005, 0.0, 0.1, 0.0, 0.0, 0.0, 0.1, 0.0, 0.005, 0.0, 0.1)  # too short to push anything
LEFT = (0.0, -0.04, 0.0, 0.1, 0.0, 0.0, 0.0, 0.1, 0.0, 0.04, 0.0, 0.1)
FORWARD = (-0.04, 0.0, 0.0, 0.1, 0.0, 0.0, 0.0, 0.1, 0.04, 0.0, 0.0, 0.1)
LIFT = (0.0, 0.0, 0.0, 0.9, 0.0, 0.0, 0.0, 0.9, 0.0, 0.0, 0.0, 0.1)


def by_affordance(features):
    """Say of objects whether they can be grasped, and whether they can be pushed."""
    graspable = (features[:, 3] >= 0.5) | (features[:, 1] <= WIDEST_GRASP)
    return tuple(f"{int(g)}{int(p)}" for g, p in zip(graspable, features[:, 0] <= LONGEST_PUSH, strict=True))


def alike(features):
    """Say that all objects are of one category."""
    return ("0",) * len(features)
