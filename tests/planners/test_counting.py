"""Counting, and planning by PDDL: as few primitives as searches that anyone can check, and valid plans."""

import itertools

import numpy as np
import pytest
import tables
import toy_domain
from msgspec.structs import replace

from neurosym.grounding import Grounding
from neurosym.planners import PlanStatus, fewest_steps, plan
from neurosym.planners.bfs import branching_of, plan_bfs
from neurosym.problems import Problem, SceneObject
from neurosym.tasks.options import cost
from neurosym.tasks.transition import PlanStep, primitives, validate


def random_task(seed: int, objects: int, tolerance: float = 0.05) -> Problem:
    """Draw blocks far from each other, one of which may have its goal in the air."""
    rng = np.random.default_rng(seed)
    spots = [(0.45, -0.15), (0.75, 0.15), (0.45, 0.15), (0.75, -0.15)][:objects]
    items = tuple(
        tables.item(f"item-{n}", x + float(rng.uniform(-0.05, 0.05)), y) for n, (x, y) in enumerate(spots)
    )
    goals = {}
    for item in items:
        x, y, z = item.position
        x, y = x + float(rng.uniform(-0.02, 0.16)), y + float(rng.uniform(-0.1, 0.12))
        goals[item.name] = (x, y, z + 0.2 * float(rng.random() < 0.25))
    return Problem("random", items, goals, tolerance=tolerance)


@pytest.mark.parametrize("objects", [1, 2])
def test_number_of_primitives_is_that_of_breadth_first_search(objects: int):
    learned, lengths = tables.grounding(), set()
    for seed in range(20):
        task = random_task(seed, objects)
        searched = plan_bfs(task, branching_of(task, learned), learned.table, depth=4)
        fewest = fewest_steps(task, learned)
        if searched.status is PlanStatus.SOLVED:
            assert fewest == primitives(searched.steps), seed
            found = plan(task, learned, "counting")
            assert primitives(found.steps) == fewest, found.reason
            assert validate(found.steps, task, learned).valid
            lengths.add(fewest)
        else:
            assert fewest is None or fewest > 4, seed
    assert len(lengths) > 2


def test_among_the_fewest_it_takes_the_cheapest():
    learned = tables.grounding()
    task = Problem("p", (tables.item("item-01", 0.45, 0.0),), {"item-01": (0.6, 0.13, 0.025)})
    found = plan(task, learned, "counting")
    names = [operator.name for operator in learned.live if operator.category == "00"]

    def price(steps: tuple[str, ...]) -> int:
        return sum(cost(learned.operator_named(step)) for step in steps)

    def down(steps: tuple[str, ...]) -> tuple[PlanStep, ...]:
        pairs = ([step, f"put-down-{step}"] if step.startswith("lift") else [step] for step in steps)
        return tuple(PlanStep(one, "item-01") for pair in pairs for one in pair)

    every = itertools.combinations_with_replacement(names, primitives(found.steps))
    cheapest = min(price(steps) for steps in every if validate(down(steps), task, learned).valid)
    assert price(tuple(step.operator for step in found.steps if not step.puts_down)) == cheapest


def test_objects_with_one_goal_end_beside_each_other():
    learned = tables.grounding()
    items = (tables.item("item-01", 0.4, 0.0), tables.item("item-02", 0.4, 0.12))
    spot = (0.57, 0.06, 0.025)
    task = Problem("p", items, {"item-01": spot, "item-02": spot})
    found = plan(task, learned, "counting")
    assert found.status is PlanStatus.SOLVED, found.reason
    assert validate(found.steps, task, learned).valid
    assert primitives(found.steps) >= fewest_steps(task, learned)


def crowd(seed: int, learned: Grounding) -> Problem:
    """Sixteen objects, each eight random steps from its goal."""
    rng, items, goals = np.random.default_rng(seed), [], {}
    for number in range(16):
        column, row = divmod(number, 4)
        category = "00" if number % 2 else "11"
        item = tables.item(f"item-{number:02d}", 0.37 + 0.15 * column, -0.22 + 0.15 * row, category=category)
        moves = [one for one in learned.live if one.category == category]
        place = np.array(item.position)
        while np.linalg.norm(place - item.position) < 0.25:
            place = np.array(item.position)
            for index in rng.integers(len(moves), size=8):
                place += [*learned.displacement(moves[index])[:2], 0.0]
        items.append(replace(item, features=(0.01, 0.01, 0.05, 0.0)))
        goals[item.name] = (float(place[0]), float(place[1]), float(place[2]))
    return Problem("crowd", tuple(items), goals, tolerance=0.03)


def test_sixteen_objects_far_from_their_goals_take_the_fewest_primitives():
    wide = replace(tables.grounding(), table=tables.Table(x=(-1.0, 3.0), y=(-2.0, 2.0)))
    task = crowd(0, wide)
    found = plan(task, wide, "counting")
    assert found.status is PlanStatus.SOLVED, found.reason
    assert primitives(found.steps) == fewest_steps(task, wide) > 48
    assert plan(task, wide, "counting", time_limit=1e-9).status is PlanStatus.TIMEOUT


TASKS = 24


def toy_task(seed: int) -> Problem:
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
    tasks = [task for task in map(toy_task, range(TASKS)) if len(task.objects) == objects and apart(task)]
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
    assert found > 2
    assert len(tasks) > 5
