"""Problems go to unified-planning, and what its engines plan comes back to be executed."""

import warnings

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


def test_what_is_no_sequence_is_refused_in_a_sentence():
    from unified_planning.plans import PartialOrderPlan

    problem = toy_domain.problem({"item-01": (0.6, 0.16, 0.025)})
    for plan, said in (
        ("a plan", "^A str is no sequence"),
        (PartialOrderPlan({}), "^A PartialOrderPlan is no"),
    ):
        with pytest.raises(InvalidValue, match=said):
            neurosym.from_unified_planning(plan, problem, toy_domain.grounding())
