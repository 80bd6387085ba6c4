"""What stands in the way of what must be led is carried away first, and what is led never goes through it."""

import pytest
from toy_places import grounding, scene

from neurosym.planners import PlanResult, PlanStatus, plan
from neurosym.planners.joined_plans import plan_in_turns
from neurosym.problems import Problem
from neurosym.tasks.transition import validate


def lead_past(*cubes: tuple[float, float, float, float]) -> Problem:
    """A slab to be pushed from y = -0.16 to 0.24, and cubes, each from x, y to x, y."""
    goals = {"item-01": (0.7, 0.24, 0.025)}
    things = [("slab", 0.7, -0.16)]
    for number, (x, y, to_x, to_y) in enumerate(cubes, start=2):
        things.append(("cube", x, y))
        goals[f"item-{number:02d}"] = (to_x, to_y, 0.025)
    return Problem("past", scene(*things), goals, 0.02)


def order(problem: Problem) -> list[str]:
    learned = grounding()
    result = plan_in_turns(
        problem,
        learned,
        carry=lambda task: plan(task, learned, encoding="strips"),
        lead=lambda task: plan(task, learned, encoding="sas"),
    )
    assert result.status is PlanStatus.SOLVED, result.reason
    assert validate(result.steps, problem, learned).valid
    return list(dict.fromkeys(step.object for step in result.steps))


def test_who_has_its_goal_beside_the_way_is_carried_first():
    assert order(lead_past((0.7, 0.0, 0.45, 0.0))) == ["item-02", "item-01"]


def test_who_has_its_goal_in_the_way_is_carried_last():
    assert order(lead_past((0.45, 0.0, 0.7, 0.0))) == ["item-01", "item-02"]


def test_who_stands_in_the_way_and_goes_there_is_put_aside():
    problem = lead_past((0.7, 0.0, 0.7, -0.16))
    learned = grounding()
    steps = plan(problem, learned).steps
    assert order(problem) == ["item-02", "item-01"]
    assert validate(steps, problem, learned).valid


@pytest.mark.parametrize("encoding", ["strips", "sas"])
def test_an_encoding_that_is_asked_for_carries_what_is_carried_without(encoding: str):
    problem, learned = lead_past((0.45, 0.0, 0.7, 0.0)), grounding()
    usual, asked = plan(problem, learned), plan(problem, learned, encoding=encoding)
    assert validate(asked.steps, problem, learned).valid
    assert [step for step in asked.steps if step.place] == [step for step in usual.steps if step.place]
    assert asked.steps == usual.steps or encoding == "strips"  # which has other cells


def test_where_all_can_be_carried_there_are_no_turns():
    problem = Problem("one", scene(("cube", 0.5, 0.0)), {"item-01": (0.7, 0.0, 0.025)}, 0.02)
    result = plan_in_turns(problem, grounding(), plan, plan)
    assert result.status is PlanStatus.FAILED
    assert "everything that has a goal can be carried" in result.reason


def test_what_cannot_be_led_even_alone_is_not_tried_again():
    asked: list[Problem] = []

    def lead(task: Problem) -> PlanResult:
        asked.append(task)
        return PlanResult(PlanStatus.UNSOLVABLE, (), 0.0, "out of reach")

    result = plan_in_turns(lead_past((0.7, 0.0, 0.45, 0.0)), grounding(), plan, lead)
    assert (result.status, result.reason, len(asked)) == (PlanStatus.UNSOLVABLE, "out of reach", 1)


def test_places_without_a_plan_prove_nothing():
    def carry(_: Problem) -> PlanResult:
        return PlanResult(PlanStatus.UNSOLVABLE, (), 0.0, "not with these places")

    learned = grounding()
    result = plan_in_turns(
        lead_past((0.7, 0.0, 0.45, 0.0)),
        learned,
        carry,
        lambda task: plan(task, learned, encoding="sas"),
    )
    assert result.status is not PlanStatus.UNSOLVABLE


def test_where_all_ways_cannot_be_cleared_at_once_each_is_cleared_when_it_is_needed():
    """Two slabs, and a cube in the way of each with its goal in the other's; only one can wait elsewhere."""
    things = [("slab", 0.7, -0.16), ("slab", 0.5, -0.16), ("cube", 0.7, 0.0), ("cube", 0.5, 0.0)]
    goals = {
        "item-01": (0.7, 0.24, 0.025),
        "item-02": (0.5, 0.24, 0.025),
        "item-03": (0.5, 0.1, 0.025),
        "item-04": (0.7, 0.1, 0.025),
    }
    places = {"goal-item-03": (0.5, 0.1), "goal-item-04": (0.7, 0.1), "park-01": (0.85, 0.0)}
    led = order(Problem("crossed", scene(*things), goals, 0.02, places=places))
    assert led == ["item-03", "item-01", "item-04", "item-02"]


def test_what_is_led_goes_around_what_can_be_carried_but_has_no_room_elsewhere():
    """The cube has no place but one in the slab's way; with five objects, none is led around all others."""
    goals = {"item-01": (0.62, 0.24, 0.025), "item-02": (0.62, 0.1, 0.025)}
    corners = [("cube", x, y) for x, y in ((0.45, 0.0), (0.9, 0.25), (0.9, -0.25))]
    things = scene(("slab", 0.54, -0.16), ("cube", 0.62, 0.0), *corners)
    problem = Problem("around", things, goals, 0.02, places={"goal-item-02": (0.62, 0.1)})
    assert order(problem) == ["item-01", "item-02"]
