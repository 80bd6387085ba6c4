"""Worlds and planners of somebody's own, most of them bad: copied beside the domain folder of a case."""

import subprocess
import sys
import tempfile
from dataclasses import replace

from neurosym.planners import PLANNERS
from neurosym.planners.planner import Planner
from neurosym.worlds.toy import ToyConfig, ToyWorld


class Moody(ToyWorld):
    """A toy world that fails as it is told to."""

    def __init__(self, mood: str = "good"):
        super().__init__(ToyConfig())
        self.mood = mood

    def interact(self, scene, action, target=0, *, put_down=True, **_):
        """Perform an action, or fail."""
        if self.mood == "leaves":
            sys.exit(7)
        if self.mood == "rubbish":
            return None
        if self.mood == "raises":
            raise KeyError("left")
        return super().interact(scene, action, target, put_down=put_down)


def world(mood: str = "good") -> Moody:
    """Make a world."""
    return Moody(mood)


def angry() -> Moody:
    """Make a world that raises an error."""
    return Moody("raises")


def gone() -> Moody:
    """Make a world that ends the process."""
    return Moody("leaves")


def odd() -> Moody:
    """Make a world that returns nothing."""
    return Moody("rubbish")


def _named(name: str, solve) -> Planner:
    return replace(PLANNERS["counting"], name=name, solve=solve)


def planner() -> Planner:
    """Make a good planner."""
    return _named("own-good", PLANNERS["counting"].solve)


def raising() -> Planner:
    """Make one that raises an error."""
    return _named("own-raising", lambda _: 1 // 0)


def leaving() -> Planner:
    """Make one that ends the process."""
    return _named("own-leaving", lambda _: sys.exit(7))


def rubbish() -> Planner:
    """Make one that returns something else."""
    return _named("own-rubbish", lambda _: "a plan")


def littering() -> Planner:
    """Make one that leaves a process and a file."""
    tempfile.mkdtemp(prefix="litter")
    subprocess.Popen(["sleep", "100"], start_new_session=True)
    return planner()
