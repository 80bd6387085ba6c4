"""Worlds and planners of somebody's own, most of them bad: copied beside the domain folder of a case."""

import subprocess
import sys
import tempfile
from dataclasses import replace

from neurosym.planners import PLANNERS
from neurosym.worlds.toy import ToyConfig, ToyWorld


class Moody(ToyWorld):
    """A toy world that does something else instead of what it is asked for, if it is told to."""

    def __init__(self, instead=None):
        super().__init__(ToyConfig())
        self.instead = instead

    def interact(self, scene, action, target=0, *, put_down=True, **_):
        """Perform an action, or fail."""
        return self.instead() if self.instead else super().interact(scene, action, target, put_down=put_down)


def _leave():
    sys.exit(7)


def world():
    """Make a good world."""
    return Moody()


def angry():
    """Make a world that raises an error."""
    return Moody({}.popitem)


def gone():
    """Make a world that ends the process."""
    return Moody(_leave)


def odd():
    """Make a world that returns nothing."""
    return Moody(lambda: None)


def planner(name="own-good", solve=PLANNERS["counting"].solve):
    """Make a good planner."""
    return replace(PLANNERS["counting"], name=name, solve=solve)


def raising():
    """Make one that raises an error."""
    return planner("own-raising", lambda _: 1 // 0)


def leaving():
    """Make one that ends the process."""
    return planner("own-leaving", lambda _: _leave())


def rubbish():
    """Make one that returns something else."""
    return planner("own-rubbish", lambda _: "a plan")


def littering():
    """Make one that leaves a process and a file."""
    tempfile.mkdtemp(prefix="litter")
    subprocess.Popen(["sleep", "100"], start_new_session=True)
    return planner()
