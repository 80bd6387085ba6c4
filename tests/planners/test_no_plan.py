"""No plan is an answer: what stands against one, and how near objects come, beside all there is to try."""

import itertools
from pathlib import Path

import msgspec
import numpy as np
import pytest
import tables
import toy_domain

from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.planners import PlanStatus, plan, plan_nearest
from neurosym.planners.action_counts import DEPTH, plan_counting
from neurosym.planners.no_plan import explain_no_plan
from neurosym.problems import Problem
from neurosym.tasks.transition import PlanStep, validate


def block(
    goal: tuple[float, float, float], x: float = 0.5, y: float = 0.0, tolerance: float = 0.05
) -> Problem:
    return Problem("p", (tables.item("item-01", x, y),), {"item-01": goal}, tolerance=tolerance)


@pytest.mark.parametrize("planner", ["bfs", "counting", "fast-downward"])
def test_goal_out_of_every_primitives_reach_is_said_to_be_so(planner: str):
    found = plan(block((0.35, 0.0, 0.025)), tables.grounding(), planner)  # blocks go away and left only
    assert found.status is PlanStatus.UNSOLVABLE
    assert (
        "item-01 cannot reach its goal: out of every primitive's reach; up to 8 primitives bring it to "
        "150 mm from it, 50 mm are allowed"
    ) in found.reason


def test_goal_that_is_to_be_had_only_off_the_table_is_said_to_be_so():
    reason = plan(block((0.6, 0.36, 0.025)), tables.grounding(), "counting").reason
    assert "item-01 cannot reach its goal without leaving the table" in reason


def test_goal_too_deep_for_the_planner_says_how_deep_it_is():
    task = block((0.85, 0.0, 0.025), tolerance=0.06)
    assert plan(task, tables.grounding(), "bfs").reason == (
        "too deep: item-01 6 primitives away from the goal, and only 3 are looked at"
    )
    assert plan(task, tables.grounding(), "counting").status is PlanStatus.SOLVED


def test_goals_too_deep_together_say_so():
    reason = plan(tables.problem(), tables.grounding(), "bfs").reason
    assert reason.startswith(
        "too deep: each goal can be reached alone, but together they take 4 primitives ("
    )


@pytest.mark.parametrize("planner", ["bfs", "counting", "fast-downward"])
def test_two_goals_in_the_air_are_said_to_need_two_hands(planner: str):
    task = toy_domain.problem({"item-01": (0.6, 0.0, 0.225), "item-02": (0.8, 0.1, 0.225)})
    found = plan(task, toy_domain.grounding(), planner)
    assert found.status is PlanStatus.UNSOLVABLE
    assert found.reason == "item-01 and item-02 would have to be held at the end, and there is one hand"


def crammed() -> Problem:
    """Two wide blocks that shall come to one place."""
    items = [
        msgspec.structs.replace(tables.item(name, 0.45, y), features=(0.16, 0.16, 0.05, 0.0))
        for name, y in (("item-01", -0.15), ("item-02", 0.05))
    ]
    return Problem("p", tuple(items), {item.name: (0.6, 0.1, 0.025) for item in items})


@pytest.mark.parametrize("planner", ["bfs", "counting", "fast-downward"])
def test_two_goals_without_room_for_both_are_said_to_be_so(planner: str):
    found = plan(crammed(), tables.grounding(), planner)
    assert found.status is PlanStatus.UNSOLVABLE
    assert "no room for both item-01 and item-02" in found.reason


def test_looking_for_room_where_there_is_none_ends_in_time():
    """The shipped domain knows thousands of ways to each of the goals."""
    learned = Grounding.load(Path("domains/tabletop/grounding.json"))
    items = tuple(msgspec.structs.replace(item, category="11") for item in crammed().objects)
    task = msgspec.structs.replace(crammed(), objects=items)
    assert plan_counting(task, learned, time_limit=0.5).status is PlanStatus.TIMEOUT


def test_nothing_is_said_against_what_can_be_solved():
    assert explain_no_plan(tables.problem(), tables.grounding()).reason == ""


def test_nearest_is_the_nearest_of_all_sequences():
    learned, goal = toy_domain.grounding(), (0.72, -0.1, 0.12)
    item = msgspec.structs.replace(toy_domain.problem({}).objects[0])
    task = Problem("p", (item,), {"item-01": goal})
    found = plan_nearest(task, learned)
    assert found.status is PlanStatus.NEAREST
    names, distances = [one.name for one in learned.live], []
    for length in range(4):
        for names_tried in itertools.product(names, repeat=length):
            steps = [PlanStep(name, "item-01") for name in names_tried]
            checked = validate(steps, task, learned)
            if checked.possible:
                distances.append(checked.positions[-1][0])
    best = min(float(np.linalg.norm(np.array(goal) - place)) for place in distances)
    end = validate(found.steps, task, learned).positions[-1][0]
    assert float(np.linalg.norm(end - goal)) == pytest.approx(best, abs=0.005)
    assert found.reason.startswith(f"at the end, item-01 {best * 1000:.0f} mm from its goal; up to 8")
    assert len(found.steps) <= DEPTH


def test_nearest_meets_the_other_goals_and_holds_one_object_only():
    task = toy_domain.problem({"item-01": (0.6, 0.0, 0.225), "item-02": (0.8, 0.18, 0.225)})
    found = plan_nearest(task, toy_domain.grounding())
    checked = validate(found.steps, task, toy_domain.grounding())
    assert (found.status, checked.possible) == (PlanStatus.NEAREST, True)
    assert sorted(task.distances(checked.positions[-1]).values()) == pytest.approx([0.0, 0.2])
    assert plan_nearest(tables.problem(), tables.grounding()).status is PlanStatus.SOLVED


@pytest.mark.parametrize("planner", ["bfs", "counting", "fast-downward"])
def test_object_that_was_pushed_a_little_off_the_table_is_brought_back(planner: str):
    trays = tuple(tables.item(f"item-0{n}", x, 0.2, category="11") for n, x in ((1, 0.95), (2, 0.5)))
    task = Problem("p", trays, {"item-01": (0.84, 0.11, 0.025)})
    found = plan(task, tables.grounding(), planner)
    assert found.status is PlanStatus.SOLVED, found.reason
    assert validate(found.steps, task, tables.grounding()).valid
    outwards = msgspec.structs.replace(task, goals={"item-02": (0.95, 0.2, 0.025)})
    assert plan(outwards, tables.grounding(), planner).status is PlanStatus.UNSOLVABLE
    far = msgspec.structs.replace(task, objects=(tables.item("item-01", 1.05, 0.2, category="11"),))
    with pytest.raises(InvalidValue, match="off the table"):
        plan(far, tables.grounding(), planner)
