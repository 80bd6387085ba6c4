"""Counting: as few primitives as searches that anyone can check, and valid plans."""

import itertools

import numpy as np
import pytest
import tables

from neurosym.planners import PlanStatus, plan
from neurosym.planners.bfs import branching_of, plan_bfs
from neurosym.problems import Problem
from neurosym.tasks.options import cost
from neurosym.tasks.transition import PlanStep, primitives, validate
from tools.benchmarks.planning.tasks import fewest_steps


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
