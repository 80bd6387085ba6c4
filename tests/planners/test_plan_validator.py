"""What unified-planning's validator says of plans, in our words."""

import pytest
import toy_domain

from neurosym.errors import InvalidValue
from neurosym.pddl.compiler import domain_text, ground_plan, problem_text
from neurosym.planners.unified_planning import PddlVerdict, validate_pddl
from neurosym.tasks.transition import PlanStep

TASK = toy_domain.problem({"item-01": (0.6, 0.08, 0.025)})
DOMAIN = domain_text(toy_domain.grounding())
PROBLEM = problem_text(TASK, toy_domain.grounding())


def actions() -> list[tuple[str, ...]]:
    steps = [PlanStep("push-left-001-cube", "item-01")]
    return [
        tuple(line.strip("()").split()) for line in ground_plan(steps, TASK, toy_domain.grounding()).lines
    ]


def test_plan_is_valid():
    assert validate_pddl(DOMAIN, PROBLEM, actions()) == PddlVerdict(valid=True)


def test_first_action_that_cannot_be_performed_is_named_with_the_condition_that_does_not_hold():
    push, along_x, along_y, reach = actions()
    verdict = validate_pddl(DOMAIN, PROBLEM, [push, along_x, along_y, push, along_x, along_y, reach])
    assert verdict == PddlVerdict(False, f"(at-y item-01 {along_y[3]}) does not hold", 6)


def test_goal_that_is_not_met_in_the_end_is_named():
    assert validate_pddl(DOMAIN, PROBLEM, actions()[:-1]).reason == "(done item-01) does not hold in the end"
    assert validate_pddl(DOMAIN, PROBLEM, []).reason == "(done item-01) does not hold in the end"


@pytest.mark.parametrize(
    ("action", "reason"),
    [
        (("fly", "item-01"), "the domain has no action fly"),
        (("reach-cell", "item-01"), "reach-cell takes 3 arguments, not 1"),
        (("reach-cell", "item-77", "x00", "y00"), "the problem has no object item-77"),
        (("reach-cell", "x00", "x00", "y00"), "x00 is no thing"),
    ],
)
def test_action_that_cannot_be_is_named(action: tuple[str, ...], reason: str):
    assert validate_pddl(DOMAIN, PROBLEM, [action]) == PddlVerdict(False, reason, 1)


def test_text_that_is_no_pddl_is_refused():
    with pytest.raises(InvalidValue, match="PDDL"):
        validate_pddl("(define", PROBLEM, actions())
