"""Worlds and planners of somebody's own, most of them bad: copied beside the domain folder of a case."""

import subprocess
import sys
import tempfile
from dataclasses import replace
from functools import partial

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


def planner(name="own-good", solve=PLANNERS["counting"].solve):
    return replace(PLANNERS["counting"], name=name, solve=solve)


leave = partial(sys.exit, 7)
world, angry, gone, odd = (partial(Moody, do) for do in (None, {}.popitem, leave, lambda: None))
raising = partial(planner, "own-raising", lambda _: 1 // 0)
leaving = partial(planner, "own-leaving", lambda _: leave())
rubbish = partial(planner, "own-rubbish", lambda _: "a plan")


def littering():
    """Make a planner that leaves a process and a file."""
    tempfile.mkdtemp(prefix="litter")
    subprocess.Popen(["sleep", "100"], start_new_session=True)
    return planner()
