"""The toy world's domain, exact to the letter; run this file as a program to write the golden file anew."""

import pytest
from places import GOLDEN
from toy_domain import WORLD, grounding, problem

from neurosym.execution.executor import execute
from neurosym.pddl import domain_text
from neurosym.planners import PLANNERS, PlanStatus, plan

GOLDEN = GOLDEN / "toy.pddl"


def test_domain_of_the_toy_world_is_exactly_the_golden_one():
    assert domain_text(grounding()) == GOLDEN.read_text()


@pytest.mark.parametrize("planner", ["bfs", "fast-downward"])
def test_every_planner_finds_the_shortest_way_and_it_leads_there(planner):
    assert planner in PLANNERS
    errand = problem({"item-01": (0.68, 0.16, 0.025)})
    result = plan(errand, grounding(), planner)
    assert result.status is PlanStatus.SOLVED
    operators = sorted(step.operator for step in result.steps)
    assert operators == ["push-forward-010-cube", "push-left-001-cube", "push-left-001-cube"]
    assert execute(WORLD, errand, grounding(), result.steps).reached


if __name__ == "__main__":
    GOLDEN.write_text(domain_text(grounding()))
