"""The stage that makes a problem: drawn from the world, or with goals given by hand."""

import dataclasses
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from neurosym.choices import AnyTask
from neurosym.grounding import Grounding
from neurosym.pair_sight import with_pairs
from neurosym.problems import Problem
from neurosym.relation_goals import RelationGoal
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import GROUNDING, MODEL, WORLD, problem_files, scene_file
from neurosym.stages.manifest import Stage
from neurosym.stages.problem_printing import put_problem
from neurosym.stages.remarks import remarks_on_number
from neurosym.stages.task_drawing import draw_any_task, networks_of_pairs, sight_of_pairs
from neurosym.tasks.pair_goals import check_relations, relations_meant
from neurosym.worlds.relation_tasks import HEIGHT, RELATION_TASKS
from neurosym.worlds.world_file import read_world


@dataclass(frozen=True, slots=True)
class Asked:
    """What a problem shall be: drawn as the paper draws tasks, unless there is more than `objects`.

    Attributes:
        objects: How many objects there are.
        actions: How many random actions lead to the goal.
        seed: Same seed, same problem.
        goals: Goals by hand [m], by object.
        tolerance: How near objects must come to their goals [m]; scene and goals do not depend on it.
        task: A kind of task.
        relations: Goals by relation.
        height: How many objects a tower or a stack has.
        state: The state that a drawn task of relations asks for; any, if not given.
    """

    objects: int = 1
    actions: int = 1
    seed: int = 0
    goals: Mapping[str, tuple[float, ...]] | None = None
    tolerance: float | None = None
    task: AnyTask | None = None
    relations: tuple[RelationGoal, ...] = ()
    height: int = HEIGHT
    state: str = ""

    @property
    def is_relational(self) -> bool:
        """Whether relations are asked for."""
        return bool(self.relations) or self.task in RELATION_TASKS

    def options(self) -> dict[str, Any]:
        """Return it as a manifest keeps it; what is as usual was not always there, and is left out."""
        usual = {field.name: field.default for field in dataclasses.fields(self)}
        every = {name: getattr(self, name) for name in usual}
        always = ("objects", "actions", "seed", "goals")
        return {
            name: _plain(value) for name, value in every.items() if name in always or value != usual[name]
        }


def problem_stage(folder: DomainFolder, name: str, asked: Asked) -> Stage:
    """Make a problem: world, model and grounding -> `problems/NAME.pddl`, `.numeric.pddl`, `.scene.json`.

    What is asked of relations is not printed in numbers.

    Args:
        folder: The domain folder.
        name: Name of the problem.
        asked: What it shall be.
    """

    def work() -> None:
        grounding = Grounding.load(folder.require(GROUNDING))
        problem = _made(folder, name, asked, grounding)
        for remark in remarks_on_number(folder, problem):
            folder.notify(remark)
        put_problem(folder, problem, grounding)

    printed_as = problem_files(name)[:1] if asked.is_relational else problem_files(name)
    inputs = (WORLD, MODEL, GROUNDING, *networks_of_pairs(folder))
    return Stage(f"new-problem {name}", inputs, (*printed_as, scene_file(name)), work, asked.options())


def _made(folder: DomainFolder, name: str, asked: Asked, grounding: Grounding) -> Problem:
    """Draw a problem, or set it by hand, and check what it asks of relations."""
    from neurosym.learning.effect_model import EffectModel
    from neurosym.worlds.problem_drawing import draw_problem, set_problem

    world = read_world(folder.require(WORLD))()
    categorise = EffectModel.load(folder.require(MODEL)).object_symbols
    sight = sight_of_pairs(folder)
    named: dict[str, Any] = {"name": name, "objects": asked.objects, "seed": asked.seed}
    if asked.task is not None:
        named |= {"height": asked.height, "state": asked.state, "sight": sight}
        problem = draw_any_task(world, categorise, grounding, asked.task, **named)
    elif asked.goals is None and not asked.relations:
        problem = draw_problem(world, categorise, actions=asked.actions, **named)
    else:
        meant = relations_meant(asked.relations, grounding)
        problem = set_problem(world, categorise, asked.goals or {}, relations=meant, **named)
    problem = with_pairs(problem.within(asked.tolerance), grounding.relations, sight)
    check_relations(problem, grounding)
    return problem


def _plain(value: Any) -> Any:
    if isinstance(value, Mapping):
        return {key: _plain(entry) for key, entry in value.items()}
    if isinstance(value, tuple | list):
        return [_plain(entry) for entry in value]
    return value.item() if isinstance(value, np.generic) else value
