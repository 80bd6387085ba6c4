"""Work for worker processes, first steps that are refused, and worlds that nobody can act in."""

import os
import sys
import time
from pathlib import Path

import numpy as np

from neurosym.errors import InvalidFile
from neurosym.worlds.toy import ToyWorld, make_world
from neurosym.worlds.workers import Task


def some_tasks(count):
    world = make_world()
    for seed in range(count):
        rng = np.random.default_rng(seed)
        yield Task(world.sample_scene(rng, 1), world.action_box.sample(rng, 1)[0])


class Deadly(ToyWorld):
    """A toy world that ends every process that an interaction is tried in."""

    def __init__(self):
        super().__init__(make_world().config)

    def interact(self, *arguments, **options):  # noqa: ARG002, D102
        os._exit(1)


class Hanging(ToyWorld):
    """A toy world in which an interaction takes a minute; it says in which process."""

    def __init__(self):
        super().__init__(make_world().config)

    def interact(self, *arguments, **options):  # noqa: ARG002, D102
        Path(f"{os.environ['NEUROSYM_TEST_STARTED']}-{os.getpid()}").touch()
        time.sleep(60)


def is_up():
    """Say something where errors are printed, and return which process this is."""
    print("seen", file=sys.stderr)
    return os.getpid()


def refused():
    """Do what a worker does first whose memory does not suffice."""
    raise InvalidFile(Path("effect_model.safetensors"), "there is not enough memory to read it")


def unreadable():
    """Return what cannot be pickled."""
    return lambda: None
