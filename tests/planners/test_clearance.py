"""What has most room is carried first, and never to where another stands."""

import numpy as np
import pytest
from toy_places import NAME, grounding, scene, swap

from neurosym.planners import plan
from neurosym.planners.joined_plans import clearest_first
from neurosym.problems import Problem
from neurosym.tasks.task import with_places
from neurosym.tasks.transition import PlanStep, validate


def crowd() -> Problem:
    """Three cubes side by side, of which the middle one has least room, and a place for each far away."""
    goals = {"item-01": (0.5, -0.2, 0.025), "item-02": (0.5, 0.0, 0.025), "item-03": (0.5, 0.2, 0.025)}
    cubes = scene(("cube", 0.8, -0.06), ("cube", 0.8, 0.0), ("cube", 0.8, 0.07))
    return with_places(Problem("crowd", cubes, goals, 0.02), grounding())


def carried(*names: str) -> tuple[PlanStep, ...]:
    return tuple(PlanStep(NAME, name, place=f"goal-{name}") for name in names)


def test_the_one_with_most_room_goes_first():
    steps = clearest_first(carried("item-02", "item-01", "item-03"), crowd())
    assert [step.object for step in steps] == ["item-03", "item-02", "item-01"]
    assert validate(steps, crowd(), grounding()).valid
    assert plan(crowd(), grounding()).steps[0].object == "item-03"


def test_what_waits_for_another_still_waits():
    problem = with_places(swap(), grounding())
    steps = plan(swap(), grounding()).steps
    assert clearest_first(steps, problem) == steps
    assert validate(steps, problem, grounding()).valid


@pytest.mark.parametrize("seed", range(20))
def test_another_order_leads_to_the_same(seed):
    rng = np.random.default_rng(seed)
    names = rng.permutation(["item-01", "item-02", "item-03"]).tolist()
    steps = clearest_first(carried(*names), crowd())
    assert sorted(map(str, steps)) == sorted(map(str, carried(*names)))
    assert validate(steps, crowd(), grounding()).valid


def test_plan_without_such_an_order_stays_as_it_is():
    problem = with_places(swap(), grounding())
    assert clearest_first(carried("item-01", "item-02"), problem) == carried("item-01", "item-02")
