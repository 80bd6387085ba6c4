"""Chances and costs: what a plan is worth, and plans without costs or for all objects at once."""

import math
import re

import msgspec
import pytest
import tables
import toy_domain

from neurosym.pddl.compiler import problem_text
from neurosym.planners import PlanStatus, plan
from neurosym.problems import Problem
from neurosym.tasks.chances import expected_success
from neurosym.tasks.options import cost
from neurosym.tasks.transition import PlanStep, validate


def test_chance_of_a_plan_is_the_product_over_its_primitives():
    steps = (
        PlanStep("lift-000-cube", "item-01"),
        PlanStep("put-down-lift-000-cube", "item-01"),
        PlanStep("push-left-001-cube", "item-01"),
    )
    assert expected_success(steps, toy_domain.problem({}), toy_domain.grounding()) == pytest.approx(
        (21 / 22) ** 2
    )
    assert expected_success((), toy_domain.problem({}), toy_domain.grounding()) == 1.0
    lift = tables.grounding().operator_named("lift-010-block")
    assert math.exp(-(cost(lift) - 1) / 100) == pytest.approx(16 / 22, abs=0.005)


@pytest.mark.parametrize("planner", ["counting", "fast-downward"])
def test_without_costs_steps_are_few_rather_than_safe(planner: str):
    """Two safe pushes instead of one lift that fails as often as not."""
    learned = tables.grounding()
    lift = learned.operator_named("lift-010-block")
    rare = msgspec.structs.replace(
        lift.modes[0], near_mean=7, effect=(0.142, -0.02, 0.2), resting_effect=(0.142, -0.02, 0.0)
    )
    table = msgspec.structs.replace(
        learned.operators,
        operators=(*learned.operators.operators[:4], msgspec.structs.replace(lift, modes=(rare,))),
    )
    risky = msgspec.structs.replace(learned, operators=table)
    away = Problem(
        "p", (tables.item("item-01", 0.45, 0.0),), {"item-01": (0.592, -0.02, 0.025)}, tolerance=0.02
    )
    few = plan(away, risky, planner, costs=False)
    assert [step.operator for step in few.steps] == [lift.name, f"put-down-{lift.name}"]
    if planner == "fast-downward":
        safe = plan(away, risky, planner)
        assert [step.operator for step in safe.steps] == ["push-away-001-block"] * 2
        assert expected_success(safe.steps, away, risky) > expected_success(few.steps, away, risky)
    alike = problem_text(away, msgspec.structs.replace(risky, unit_costs=True))
    assert re.findall(r"\(= \(cost \S+\) \d+\)", alike) == ["(= (cost cost1) 1)"]


@pytest.mark.parametrize("whole", [False, True])
def test_whole_problem_is_solved_like_its_parts(whole: bool):
    found = plan(tables.problem(), tables.grounding(0.01), whole=whole)
    assert found.status is PlanStatus.SOLVED, found.reason
    assert validate(found.steps, tables.problem(), tables.grounding()).valid
