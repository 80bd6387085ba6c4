"""Problems go to unified-planning, its engines' plans come back, and its validator judges them."""

import warnings

import pytest
import toy_domain
import toy_places

import neurosym
from neurosym.errors import InvalidValue
from neurosym.execution.executor import execute
from neurosym.pddl.compiler import domain_text, ground_plan, problem_text
from neurosym.planners.unified_planning import PddlVerdict, validate_pddl
from neurosym.tasks.transition import PlanStep, validate


def solved(task):
    """What an engine of unified-planning plans for a problem."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # unified-planning and what it imports, not ours to mend
        from unified_planning.shortcuts import OneshotPlanner, get_environment

        get_environment().credits_stream = None
        with OneshotPlanner(name="fast-downward") as engine:
            return engine.solve(task).plan


CELLS = toy_domain.problem({"item-01": (0.68, 0.08, 0.025), "item-02": (0.8, 0.1, 0.025)})


@pytest.mark.parametrize(
    ("problem", "grounding", "encoding"),
    [(toy_places.swap(), toy_places.grounding(), "strips"), (CELLS, toy_domain.grounding(), None)],
)
def test_engine_plans_and_its_plan_comes_true(problem, grounding, encoding):
    plan = solved(neurosym.to_unified_planning(problem, grounding, encoding))
    steps = neurosym.from_unified_planning(plan, problem, grounding)
    assert validate(steps, problem, grounding).valid
    assert execute(toy_domain.WORLD, problem, grounding, steps).reached


def test_what_is_no_sequence_is_refused_in_a_sentence():
    from unified_planning.plans import PartialOrderPlan

    problem = toy_domain.problem({"item-01": (0.6, 0.16, 0.025)})
    for plan, said in (
        ("a plan", "^A str is no plan in a sequence"),
        (PartialOrderPlan({}), "^A PartialOrderPlan is no"),
    ):
        with pytest.raises(InvalidValue, match=said):
            neurosym.from_unified_planning(plan, problem, toy_domain.grounding())


TASK = toy_domain.problem({"item-01": (0.6, 0.08, 0.025)})
DOMAIN = domain_text(toy_domain.grounding())
PROBLEM = problem_text(TASK, toy_domain.grounding())


def actions() -> list[tuple[str, ...]]:
    steps = [PlanStep("push-left-001-cube", "item-01")]
    return [
        tuple(line.strip("()").split()) for line in ground_plan(steps, TASK, toy_domain.grounding()).lines
    ]


def test_first_action_that_cannot_be_performed_is_named_or_the_goal_that_is_not_met():
    push, along_x, along_y, reach = actions()
    assert validate_pddl(DOMAIN, PROBLEM, actions()) == PddlVerdict(valid=True)
    verdict = validate_pddl(DOMAIN, PROBLEM, [push, along_x, along_y, push, along_x, along_y, reach])
    assert verdict == PddlVerdict(False, f"(at-y item-01 {along_y[3]}) does not hold", 6)
    for part in (actions()[:-1], []):
        assert validate_pddl(DOMAIN, PROBLEM, part).reason == "(done item-01) does not hold in the end"
    with pytest.raises(InvalidValue, match="PDDL"):
        validate_pddl("(define", PROBLEM, actions())
