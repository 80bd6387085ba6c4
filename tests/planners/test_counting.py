"""Counting: as few primitives as a search that anyone can check, and valid plans."""

import itertools

import msgspec
import numpy as np
import pytest
import tables
import toy_domain

from neurosym.grounding import Grounding
from neurosym.planners import PlanStatus, fewest_steps, plan
from neurosym.planners.action_counts import _count_vector
from neurosym.planners.bfs import branching_of, plan_bfs
from neurosym.planners.plan_order import mend
from neurosym.problems import Problem, SceneObject
from neurosym.tasks.options import cost
from neurosym.tasks.transition import PlanStep, validate


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


def primitives(steps: tuple[PlanStep, ...]) -> int:
    return sum(not step.puts_down for step in steps)


def test_count_vectors_are_all_there_are():
    expected = {one for one in itertools.product(range(5), repeat=3) if sum(one) == 4}
    assert {tuple(_count_vector(3, 4, row).tolist()) for row in range(len(expected))} == expected
    with pytest.raises(IndexError):
        _count_vector(3, 4, len(expected))
    assert _count_vector(0, 0, 0).shape == (0,)


@pytest.mark.parametrize("objects", [1, 2])
def test_number_of_primitives_is_that_of_breadth_first_search(objects: int):
    learned, lengths = tables.grounding(), set()
    for seed in range(30):
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


def test_steps_are_ordered_such_that_nobody_leaves_the_table():
    learned = tables.grounding()
    start = tables.item("item-01", 0.85, 0.28, category="11", height=0.04)
    task = Problem("p", (start,), {"item-01": (0.797, 0.294, 0.02)}, tolerance=0.02)
    found = plan(task, learned, "counting")
    assert [step.operator for step in found.steps] == ["pull-010-tray", "push-left-000-tray"]
    assert validate(found.steps, task, learned).valid


def test_only_one_object_ends_held_and_comes_last():
    learned = toy_domain.grounding()
    low = {"item-01": (0.6, 0.0, 0.225), "item-02": (0.8, 0.18, 0.025)}
    found = plan(toy_domain.problem(low), learned, "counting")
    assert [step.operator for step in found.steps] == ["push-left-001-cube", "lift-000-cube"]
    both = toy_domain.problem({"item-01": (0.6, 0.0, 0.225), "item-02": (0.8, 0.18, 0.225)})
    assert fewest_steps(both, learned) is None
    assert plan(both, learned, "counting").status is PlanStatus.UNSOLVABLE


def test_objects_with_one_goal_end_beside_each_other():
    learned = tables.grounding()
    items = (tables.item("item-01", 0.4, 0.0), tables.item("item-02", 0.4, 0.12))
    spot = (0.57, 0.06, 0.025)
    task = Problem("p", items, {"item-01": spot, "item-02": spot})
    found = plan(task, learned, "counting")
    assert found.status is PlanStatus.SOLVED, found.reason
    assert validate(found.steps, task, learned).valid
    fewest = fewest_steps(task, learned)
    assert fewest is not None
    assert primitives(found.steps) >= fewest


def test_objects_that_change_places_go_in_an_order_that_works():
    learned = toy_domain.grounding()
    items = tuple(
        SceneObject(name, "00", (0.05, 0.05, 0.05, 0.0), (0.5, y, 0.025))
        for name, y in (("behind", -0.08), ("ahead", 0.0))
    )
    task = Problem("p", items, {"behind": (0.5, 0.0, 0.025), "ahead": (0.5, 0.08, 0.025)}, tolerance=0.01)
    assert [step.object for step in plan(task, learned, "counting").steps] == ["ahead", "behind"]
    jam = tuple(PlanStep("push-left-001-cube", name) for name in ("behind", "ahead"))
    ordered, checked = mend(jam, task, learned)
    assert (ordered, checked.valid) == (jam[::-1], True)


def test_goal_met_at_the_start_needs_no_primitive():
    task = Problem("p", (tables.item("item-01", 0.5, 0.0),), {"item-01": (0.51, 0.0, 0.025)})
    assert fewest_steps(task, tables.grounding()) == 0
    assert plan(task, tables.grounding(), "counting").steps == ()


def test_time_out_is_a_result():
    assert (
        plan(tables.problem(), tables.grounding(), "counting", time_limit=1e-9).status is PlanStatus.TIMEOUT
    )


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
        items.append(msgspec.structs.replace(item, features=(0.01, 0.01, 0.05, 0.0)))
        goals[item.name] = (float(place[0]), float(place[1]), float(place[2]))
    return Problem("crowd", tuple(items), goals, tolerance=0.03)


def test_sixteen_objects_far_from_their_goals_take_the_fewest_primitives():
    wide = msgspec.structs.replace(tables.grounding(), table=tables.Table(x=(-1.0, 3.0), y=(-2.0, 2.0)))
    for seed in range(3):
        task = crowd(seed, wide)
        found = plan(task, wide, "counting")
        assert found.status is PlanStatus.SOLVED, found.reason
        assert primitives(found.steps) == fewest_steps(task, wide)
        assert primitives(found.steps) > 48
