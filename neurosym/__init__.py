"""neurosym: from a curious robot's interactions to a PDDL domain any planner takes, and back to motions.

The verbs of the command line are functions here; each is imported when it is first used, so that
`import neurosym` is quick and loads neither torch nor PyBullet.
"""

import sys
from importlib import import_module
from importlib.metadata import version
from typing import Any

__version__ = version("neurosym")

_VERBS = {
    "explore": "neurosym.exploration.loop",
    "train": "neurosym.learning.training",
    "distill": "neurosym.primitives.distillation",
    "rehearse": "neurosym.primitives.rehearsal",
    "compile_domain": "neurosym.pddl",
    "draw_problem": "neurosym.worlds.problem_drawing",
    "plan": "neurosym.planners",
    "execute": "neurosym.execution.executor",
    "check_world": "neurosym.worlds.check",
}

__all__ = ["__version__", *_VERBS]


def __getattr__(name: str) -> Any:
    if name in _VERBS:
        return getattr(import_module(_VERBS[name]), name)
    raise AttributeError(f"module 'neurosym' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted(__all__)


if "gymnasium" in sys.modules:  # whoever imports Gymnasium first expects our environments in its registry
    import_module("neurosym.worlds.gymnasium_env")
