"""Worlds that do wrong, each in one way, whenever the first object is tall; imported by name in tests."""

import os
import signal
import sys
import time
from dataclasses import replace

import numpy as np

from neurosym.world import Outcome
from neurosym.worlds.toy import ToyConfig, ToyWorld

MENDED = "BAD_WORLDS_MENDED"
TALL = 0.09
"""Height of an object that they cannot stand [m]: one in eight is as tall."""


class Surprise(BaseException):
    """An error that cannot even say what it is."""

    def __str__(self):
        raise RuntimeError


def raising(_):
    raise ZeroDivisionError("no\nfriction")


def surprising(_):
    raise Surprise


DEEDS = {
    "raising": raising,
    "surprising": surprising,
    "leaving": lambda _: sys.exit(3),
    "gone": lambda _: os._exit(7),
    "killed": lambda _: os.kill(os.getpid(), signal.SIGKILL),
    "hanging": lambda _: time.sleep(60),
    "nothing": lambda _: None,
    "nan": lambda made: replace(made, positions=made.positions * np.nan),
    "other target": lambda made: replace(made, target=3),
    "odd kind": lambda made: replace(made, disturbed=((0, "vanished"),)),
}


class Bad(ToyWorld):
    """A toy world that does one deed in one of its methods."""

    patience = 1.0

    def __init__(self, deed, place, tall=TALL):
        super().__init__(ToyConfig())
        self.deed, self.place, self.tall = DEEDS[deed], place, tall
        if place == "init":
            self.deed(None)

    @property
    def lift_height(self):  # noqa: D102
        return self.deed(0.2) if self.place == "lift_height" else 0.2

    def done(self, place, scene, made):  # noqa: D102
        is_time = place == self.place and scene.features[0, 2] >= self.tall and MENDED not in os.environ
        return self.deed(made) if is_time else made

    def sample_scene(self, rng, objects):  # noqa: D102
        made = super().sample_scene(rng, objects)
        return self.done("sample_scene", made, made)

    def interact(self, scene, action, target, **options) -> Outcome:  # noqa: D102
        return self.done("interact", scene, super().interact(scene, action, target, **options))


def make(deed: str = "raising", place: str = "nowhere", tall: float = TALL) -> Bad:
    return Bad(deed, place, tall)
