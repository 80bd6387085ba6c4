"""neurosym: from a curious robot's interactions to a PDDL domain any planner takes, and back to motions.

The verbs of the command line are functions here, and their nouns are types. Each is imported when it is first
used, so that `import neurosym` is quick and loads neither torch nor PyBullet.
"""

import sys
from importlib import import_module

TYPE_CHECKING = False  # as of `typing`, whose import takes long
__version__: str
if TYPE_CHECKING:
    from neurosym.data.interactions import Interactions as Interactions
    from neurosym.errors import NeurosymError as NeurosymError
    from neurosym.execution.executor import execute as execute
    from neurosym.execution.record import Run as Run
    from neurosym.exploration.loop import explore as explore
    from neurosym.grounding import Grounding as Grounding
    from neurosym.learning.training import Trained as Trained
    from neurosym.learning.training import train as train
    from neurosym.operators import Category as Category
    from neurosym.operators import Operator as Operator
    from neurosym.operators import OperatorTable as OperatorTable
    from neurosym.operators import Primitive as Primitive
    from neurosym.pddl.compiler import compile_domain as compile_domain
    from neurosym.planners.pddl_search import pddl_planner as pddl_planner
    from neurosym.planners.planner import Planner as Planner
    from neurosym.planners.planner import PlannerAnswer as PlannerAnswer
    from neurosym.planners.planner import PlanResult as PlanResult
    from neurosym.planners.planner import PlanStatus as PlanStatus
    from neurosym.planners.planner import Query as Query
    from neurosym.planners.registry import plan as plan
    from neurosym.planners.registry import register_planner as register_planner
    from neurosym.planners.unified_planning import from_unified_planning as from_unified_planning
    from neurosym.planners.unified_planning import to_unified_planning as to_unified_planning
    from neurosym.primitives.audition import choose as choose
    from neurosym.primitives.distillation import distill as distill
    from neurosym.primitives.rehearsal import Rehearsals as Rehearsals
    from neurosym.primitives.rehearsal import rehearse as rehearse
    from neurosym.primitives.rehearsal import tabulate as tabulate
    from neurosym.problems import Problem as Problem
    from neurosym.problems import SceneObject as SceneObject
    from neurosym.tasks.goal_choice import with_goals as with_goals
    from neurosym.tasks.transition import PlanStep as PlanStep
    from neurosym.world import ActionBox as ActionBox
    from neurosym.world import Mirror as Mirror
    from neurosym.world import OtherObject as OtherObject
    from neurosym.world import Outcome as Outcome
    from neurosym.world import Place as Place
    from neurosym.world import Scene as Scene
    from neurosym.world import Table as Table
    from neurosym.world import World as World
    from neurosym.worlds.own_world import check_world as check_world
    from neurosym.worlds.task_drawing import draw_problem as draw_problem
    from neurosym.worlds.task_drawing import draw_task as draw_task

_PLACES = {
    "neurosym.data.interactions": ("Interactions",),
    "neurosym.errors": ("NeurosymError",),
    "neurosym.execution.executor": ("execute",),
    "neurosym.execution.record": ("Run",),
    "neurosym.exploration.loop": ("explore",),
    "neurosym.grounding": ("Grounding",),
    "neurosym.learning.training": ("Trained", "train"),
    "neurosym.operators": ("Category", "Operator", "OperatorTable", "Primitive"),
    "neurosym.pddl.compiler": ("compile_domain",),
    "neurosym.planners.pddl_search": ("pddl_planner",),
    "neurosym.planners.planner": ("PlanResult", "PlanStatus", "Planner", "PlannerAnswer", "Query"),
    "neurosym.planners.registry": ("plan", "register_planner"),
    "neurosym.planners.unified_planning": ("from_unified_planning", "to_unified_planning"),
    "neurosym.primitives.audition": ("choose",),
    "neurosym.primitives.distillation": ("distill",),
    "neurosym.primitives.rehearsal": ("Rehearsals", "rehearse", "tabulate"),
    "neurosym.problems": ("Problem", "SceneObject"),
    "neurosym.tasks.goal_choice": ("with_goals",),
    "neurosym.tasks.transition": ("PlanStep",),
    "neurosym.world": ("ActionBox", "Mirror", "OtherObject", "Outcome", "Place", "Scene", "Table", "World"),
    "neurosym.worlds.own_world": ("check_world",),
    "neurosym.worlds.task_drawing": ("draw_problem", "draw_task"),
}
"""Where each name comes from when it is first used; type checkers read the block above."""
_HOMES = {name: module for module, names in _PLACES.items() for name in names}

__all__ = ["__version__", *_HOMES]


if not TYPE_CHECKING:  # a type checker would take every name for granted

    def __getattr__(name: str) -> object:
        if name == "__version__":
            from neurosym.errors import version_of

            return version_of("neurosym")
        if name in _HOMES:
            return getattr(import_module(_HOMES[name]), name)
        raise AttributeError(f"module 'neurosym' has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted(__all__)


if "gymnasium" in sys.modules:  # whoever imports Gymnasium first expects our environments in its registry
    import_module("neurosym.worlds.gymnasium_env")
