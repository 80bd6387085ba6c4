"""On random tasks of the toy world: PDDL finds a plan whenever breadth-first search does, and it is true."""

import numpy as np
import pytest
import toy_domain

from neurosym.planners import PlanStatus, fewest_steps, plan
from neurosym.problems import Problem, SceneObject
from neurosym.tasks.transition import validate

TASKS = 40


def random_task(seed: int) -> Problem:
    """Draw one or two cubes, and goals that one to three primitives lead to, give or take 2 cm."""
    rng = np.random.default_rng(10_000 + seed)
    learned = toy_domain.grounding()
    pushes = [learned.displacement(learned.operator_named(one.name)) for one in learned.live]
    pushes = [push for push in pushes if push[2] == 0.0]
    items, goals, objects = [], {}, 1 + seed % 2
    for number in range(objects):
        start = (float(rng.uniform(0.45, 0.8)), float(rng.uniform(-0.28, 0.2)), 0.025)
        steps = rng.integers(2, size=rng.integers(1, 5 - objects))
        moved = np.array(start) + sum(np.array(pushes[step]) for step in steps)
        x, y = (moved[:2] + rng.uniform(-0.024, 0.024, 2)).tolist()
        z = 0.225 if number == 0 and rng.random() < 0.3 else 0.025
        name = f"item-{number + 1:02d}"
        items.append(SceneObject(name, "00", (0.05, 0.05, 0.05, 0.0), start))
        goals[name] = (x, y, z)
    return Problem("drawn", tuple(items), goals, tolerance=0.03)


def apart(task: Problem) -> bool:
    """Say whether neither starts nor goals overlap; breadth-first search knows nothing of that."""
    if len(task.objects) == 1:
        return True
    starts = task.scene().positions[:, :2]
    ends = task.goal_positions()[:, :2]
    return bool(min(np.abs(pair[0] - pair[1]).max() for pair in (starts, ends)) > 0.12)


@pytest.mark.parametrize("objects", [1, 2])
def test_pddl_finds_true_plans_whenever_breadth_first_search_does(objects: int):
    learned, found = toy_domain.grounding(), 0
    tasks = [task for task in map(random_task, range(TASKS)) if len(task.objects) == objects and apart(task)]
    for task in tasks:
        searched = plan(task, learned, "bfs")
        answer = plan(task, learned)
        if answer.status is PlanStatus.SOLVED:
            assert validate(answer.steps, task, learned).valid
            count = sum(not step.puts_down for step in answer.steps)
            assert count >= (fewest_steps(task, learned) or 0)
        if searched.status is PlanStatus.SOLVED:
            assert answer.status is PlanStatus.SOLVED, answer.reason
            found += 1
        assert (answer.status is PlanStatus.SOLVED) == (fewest_steps(task, learned) is not None)
    assert found > 4
    assert len(tasks) > 10
