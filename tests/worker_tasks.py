"""Work for worker processes, of one machine or of a cluster."""

import os
from dataclasses import dataclass

import numpy as np

from neurosym.worlds.toy import ToyWorld, make_world
from neurosym.worlds.workers import Task


def some_tasks(count):
    world = make_world()
    for seed in range(count):
        rng = np.random.default_rng(seed)
        yield Task(world.sample_scene(rng, 1), world.action_box.sample(rng, 1)[0])


@dataclass
class Deadly(ToyWorld):
    """A toy world that ends every process that an interaction is tried in."""

    def __init__(self):
        super().__init__(make_world().config)

    def interact(self, *arguments, **options):  # noqa: ARG002, D102
        os._exit(1)
