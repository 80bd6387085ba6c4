"""What is led and what is carried: in turns, out of each other's way, and the clearest first."""

import numpy as np
import pytest
from msgspec.structs import replace
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


def around() -> Problem:
    """The cube has no place but one in the slab's way; with five objects, none is led around all others."""
    goals = {"item-01": (0.62, 0.24, 0.025), "item-02": (0.62, 0.1, 0.025)}
    corners = [("cube", x, y) for x, y in ((0.45, 0.0), (0.9, 0.25), (0.9, -0.25))]
    things = scene(("slab", 0.54, -0.16), ("cube", 0.62, 0.0), *corners)
    return Problem("around", things, goals, 0.02, places={"goal-item-02": (0.62, 0.1)})


@pytest.mark.parametrize(
    ("problem", "names"),
    [
        (lead_past((0.7, 0.0, 0.45, 0.0)), ["item-02", "item-01"]),
        (lead_past((0.45, 0.0, 0.7, 0.0)), ["item-01", "item-02"]),
        (lead_past((0.7, 0.0, 0.7, -0.16)), ["item-02", "item-01"]),
        (around(), ["item-01", "item-02"]),
    ],
    ids=["goal beside the way", "goal in the way", "put aside", "led around"],
)
def test_what_is_led_and_what_is_carried_take_turns(problem: Problem, names: list[str]):
    assert order(problem) == names


def test_turns_prove_nothing_where_places_fail_and_end_with_what_cannot_be_led_even_alone():
    learned, asked = grounding(), list[Problem]()

    def hopeless(task: Problem) -> PlanResult:
        asked.append(task)
        return PlanResult(PlanStatus.UNSOLVABLE, (), 0.0, "out of reach")

    beside = lead_past((0.7, 0.0, 0.45, 0.0))
    result = plan_in_turns(beside, learned, plan, hopeless)
    assert (result.status, result.reason, len(asked)) == (PlanStatus.UNSOLVABLE, "out of reach", 1)
    result = plan_in_turns(beside, learned, hopeless, lambda task: plan(task, learned, encoding="sas"))
    assert result.status is not PlanStatus.UNSOLVABLE


def aside(problem: Problem) -> dict[str, tuple[float, ...]]:
    """Where what stands in the way is carried at first, where only that is moved."""
    learned, asked = grounding(), list[Problem]()

    def fail(task: Problem) -> PlanResult:
        asked.append(task)
        return PlanResult(PlanStatus.FAILED, (), 0.0, "tired")

    plan_in_turns(problem, learned, carry=fail, lead=lambda task: plan(task, learned, encoding="sas"))
    return asked[1].goals


def test_who_has_its_goal_in_the_way_waits_where_nobody_is_disturbed():
    """Beside the way by the hand's room, off the other cube, its goal and the edge, or at one's own place."""
    problem = lead_past((0.7, 0.0, 0.7, 0.1), (0.5, 0.0, 0.5, 0.2))
    ((name, spot),) = aside(problem).items()
    cubes = [(0.5, 0.0), (0.5, 0.2)]
    ways = [(0.7, y) for y in (-0.16, -0.08, 0.0, 0.08, 0.16, 0.24)]
    for room, others in (((0.07, 0.105), ways), ((0.1, 0.1), cubes)):
        away = np.abs(np.subtract(spot[:2], others))
        assert np.all(np.any(away >= np.array(room) - 1e-9, axis=1))
    assert (name, grounding().table.contains(np.array(spot))) == ("item-02", True)
    own = {"near": (0.76, 0.1), "shelf": (0.45, 0.1), "goal-item-02": (0.7, 0.1), "goal-item-03": (0.5, 0.2)}
    assert aside(replace(problem, places=own)) == {"item-02": (0.45, 0.1, 0.025)}
    assert aside(lead_past((0.7, 0.0, 0.45, 0.0))) == {"item-02": (0.45, 0.0, 0.025)}


def test_the_one_with_most_room_goes_first():
    """Of three cubes side by side the middle one has least; each has a place far away."""
    goals = {"item-01": (0.5, -0.2, 0.025), "item-02": (0.5, 0.0, 0.025), "item-03": (0.5, 0.2, 0.025)}
    cubes = scene(("cube", 0.8, -0.06), ("cube", 0.8, 0.0), ("cube", 0.8, 0.07))
    problem = Problem("crowd", cubes, goals, 0.02)
    result = plan(problem, grounding())
    assert result.steps[0].object == "item-03"
    assert validate(result.steps, problem, grounding()).valid
