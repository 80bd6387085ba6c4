"""Breadth-first search over relations, on problems that can be followed by hand."""

import msgspec
import pytest
from independent.ground_pddl import judge
from toy_relations import PUT_IN, PUT_ON, REST, grounding, relations, scene, sorting, tower, tower_at_place

from neurosym.pddl.compiler import domain_text, ground_plan, problem_text
from neurosym.planners import PlanStatus, plan
from neurosym.planners.registry import _plan_breadth_first as plan_relational_bfs
from neurosym.problems import Problem
from neurosym.tasks.supports import with_pairs
from neurosym.tasks.transition import validate


@pytest.mark.parametrize("planner", ["bfs", "bfs-operators"])
@pytest.mark.parametrize("problem", [tower(), sorting(), tower_at_place()], ids=lambda one: one.name)
def test_plans_are_true_and_no_longer_than_those_of_fast_downward(problem: Problem, planner: str):
    found = plan(problem, grounding(), planner)
    assert found.status is PlanStatus.SOLVED
    assert validate(found.steps, problem, grounding()).valid
    assert len(found.steps) <= len(plan(problem, grounding()).steps)


def test_steps_are_those_one_would_take():
    steps = plan(sorting(), grounding(), "bfs").steps
    assert [(one.operator, one.object, one.place) for one in steps] == [
        (PUT_IN, "item-01", "item-04"),
        (PUT_IN, "item-02", "item-05"),
    ]


def test_search_ends_where_so_many_steps_were_looked_at():
    problem = with_pairs(tower(), relations())
    result = plan_relational_bfs(problem, grounding(), most_steps=10)
    assert (result.status, result.depth) == (PlanStatus.NOT_FOUND, 0)
    assert result.reason == "10 steps were looked at, 0 deep"


def test_goals_met_at_the_start_need_no_step_and_impossible_ones_no_search():
    met = msgspec.structs.replace(sorting(), relations=(("item-01", "item-02", REST),))
    assert plan(met, grounding(), "bfs").steps == ()
    stuck = msgspec.structs.replace(sorting(), relations=(("item-04", "item-03", REST),))
    result = plan(stuck, grounding(), "bfs")
    assert result.status is PlanStatus.UNSOLVABLE
    assert result.reason.startswith(f"no operator brings item-04 to {REST} with item-03")


def test_what_bears_something_is_put_only_on_what_stands_at_a_place():
    objects = scene(
        ("cube", 0.5, -0.2, 0.05), ("cube", 0.5, -0.2), ("cube", 0.5, 0.1, 0.05), ("block", 0.5, 0.1)
    )
    goals = (("item-02", "item-03", REST),)
    problem = with_pairs(Problem("laden", objects, {}, relations=goals), relations())
    steps = plan(problem, grounding(), "bfs").steps
    assert len(steps) > 1
    assert validate(steps, problem, grounding()).valid
    written = ground_plan(steps, problem, grounding())
    printed = problem_text(problem, grounding(), plans=[written])
    assert judge(domain_text(grounding()), printed, written.text) == ""
    assert "(put item-02 rests-on-item-03 item-03 from-spot n0 n1" in written.text


def test_there_is_an_end_to_all_sequences():
    objects = scene(("cube", 0.5, -0.2), ("block", 0.5, 0.1), ("cube", 0.7, -0.1))
    goals = (("item-01", "item-02", REST), ("item-03", "item-02", REST))
    problem = with_pairs(Problem("both", objects, {}, relations=goals), relations())
    result = plan_relational_bfs(problem, grounding())
    assert result.status is PlanStatus.NOT_FOUND
    assert result.reason.startswith("no sequence of steps leads there")
    assert PUT_ON in {one.name for one in relations().operators}
