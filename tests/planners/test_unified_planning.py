"""Problems go to unified-planning, and what its engines plan comes back to be executed."""

import warnings
from fractions import Fraction
from itertools import pairwise

import pytest
import toy_domain
import toy_places

import neurosym
from neurosym.errors import InvalidValue
from neurosym.execution.executor import execute
from neurosym.tasks.transition import validate


def solved(task):
    """What an engine of unified-planning plans for a problem."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # unified-planning and what it imports, not ours to mend
        from unified_planning.shortcuts import OneshotPlanner, get_environment

        get_environment().credits_stream = None
        with OneshotPlanner(name="fast-downward") as engine:
            return engine.solve(task).plan


@pytest.mark.parametrize("encoding", [None, "strips"])
def test_engine_carries_things_to_places_and_its_plan_comes_true(encoding):
    problem, grounding = toy_places.swap(), toy_places.grounding()
    plan = solved(neurosym.to_unified_planning(problem, grounding, encoding))
    steps = neurosym.from_unified_planning(plan, problem, grounding)
    assert len(steps) == 3, "one waits while the other is carried"
    assert validate(steps, problem, grounding).valid
    assert execute(toy_domain.WORLD, problem, grounding, steps).reached


def test_engine_plans_over_cells():
    problem = toy_domain.problem({"item-01": (0.68, 0.08, 0.025), "item-02": (0.8, 0.1, 0.025)})
    grounding = toy_domain.grounding()
    plan = solved(neurosym.to_unified_planning(problem, grounding))
    steps = neurosym.from_unified_planning(plan, problem, grounding)
    assert validate(steps, problem, grounding).valid


def pushes():
    """Two pushes of a cube, as actions of unified-planning, with the problem and the domain."""
    problem = toy_domain.problem({"item-01": (0.6, 0.16, 0.025)})
    grounding = toy_domain.grounding()
    plan = solved(neurosym.to_unified_planning(problem, grounding))
    return plan.actions, problem, grounding


def test_plans_with_order_or_times_are_taken_if_they_leave_one_sequence():
    from unified_planning.plans import PartialOrderPlan, SequentialPlan, TimeTriggeredPlan

    actions, problem, grounding = pushes()
    steps = neurosym.from_unified_planning(SequentialPlan(actions), problem, grounding)
    chain = {one: [other] for one, other in pairwise(actions)}
    timed = [(Fraction(2 * number), one, Fraction(1)) for number, one in enumerate(actions)]
    for plan in (PartialOrderPlan(chain), TimeTriggeredPlan(timed[::-1])):
        assert neurosym.from_unified_planning(plan, problem, grounding) == steps


def test_plans_that_leave_the_order_open_are_refused_in_a_sentence():
    from unified_planning.plans import PartialOrderPlan, TimeTriggeredPlan

    actions, problem, grounding = pushes()
    loose = PartialOrderPlan({one: [] for one in actions})
    timed = TimeTriggeredPlan([(Fraction(number), one, Fraction(3)) for number, one in enumerate(actions)])
    for plan, said in (
        (loose, r"^The plan leaves open whether (push|move)"),
        (timed, r"^push.* overlap in the plan"),
        ("a plan", r"^A str is no plan; valid: a SequentialPlan"),
    ):
        with pytest.raises(InvalidValue, match=said):
            neurosym.from_unified_planning(plan, problem, grounding)
