"""Alternatives: the cheapest plans of other steps, compared with all there are; chances, and unit costs."""

import itertools
import math
import re
from collections import Counter

import msgspec
import pytest
import tables
import toy_domain

from neurosym.pddl.chances import expected_success
from neurosym.pddl.problem import problem_text
from neurosym.planners import PlanStatus, alternatives, plan
from neurosym.problems import Problem
from neurosym.tasks.moves import cost
from neurosym.tasks.steps import PlanStep
from neurosym.tasks.transition import validate


def task(tolerance: float = 0.05) -> Problem:
    return Problem(
        "p", (tables.item("item-01", 0.45, 0.0),), {"item-01": (0.6, 0.07, 0.025)}, tolerance=tolerance
    )


def price(steps: tuple[PlanStep, ...]) -> int:
    return sum(cost(tables.grounding().operator_named(step.base)) for step in steps if not step.puts_down)


def test_alternatives_are_the_cheapest_of_all_other_choices_of_steps():
    learned = tables.grounding()
    names = [one.name for one in learned.live if one.category == "00"]
    fewest = len(plan(task(), learned, "counting").steps)
    good: list[tuple[int, Counter[str]]] = []
    for length in range(fewest + 3):
        for chosen in itertools.combinations_with_replacement(names, length):
            pairs = ([one, f"put-down-{one}"] if one.startswith("lift") else [one] for one in chosen)
            steps = tuple(PlanStep(one, "item-01") for pair in pairs for one in pair)
            if validate(steps, task(), learned).valid:
                good.append((price(steps), Counter(chosen)))
    good.sort(key=lambda pair: pair[0])
    expected = [price_ for price_, one in good if not any(other < one for _, other in good)]
    found = alternatives(task(), learned, 3)
    assert all(validate(steps, task(), learned).valid for steps in found)
    assert [price(steps) for steps in found] == expected[:3]
    others = alternatives(task(), learned, 2, besides=found[0])
    assert others == found[1:]


def test_alternatives_for_two_objects_are_all_ways_to_choose_one_for_each():
    """Each block comes near enough to its goal by a push to the left, or away."""
    items = tuple(tables.item(f"item-0{n}", 0.5, y) for n, y in enumerate((-0.15, 0.1)))
    goals = {item.name: (item.position[0] + 0.055, item.position[1] + 0.045, 0.025) for item in items}
    both = Problem("p", items, goals, tolerance=0.066)
    found = alternatives(both, tables.grounding(), 9)
    assert len({tuple(sorted((step.operator, step.object) for step in steps)) for steps in found}) == 4
    assert len(found) == 4
    assert all(validate(steps, both, tables.grounding()).valid for steps in found)


def test_no_alternatives_to_what_cannot_be_done():
    far = Problem("p", (tables.item("item-01", 0.5, 0.0),), {"item-01": (0.35, 0.0, 0.025)})
    assert alternatives(far, tables.grounding(), 3) == ()


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
