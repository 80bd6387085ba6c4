"""Breadth-first search: how deep it goes, what it knows of operators, and tasks of relations."""

import numpy as np
import pytest
import toy_relations
from independent.ground_pddl import judge
from msgspec.structs import replace
from tables import BOUNDS, grounding, problem
from toy_relations import REST, relations, scene, sorting, tower, tower_at_place

from neurosym.pddl.compiler import domain_text, ground_plan, problem_text
from neurosym.planners import PlanStatus, plan
from neurosym.planners import bfs as bfs_module
from neurosym.planners.bfs import Branching, branching_of, plan_bfs, plan_related, predicted_branching
from neurosym.problems import Problem, SceneObject
from neurosym.tasks.supports import with_pairs
from neurosym.tasks.transition import validate


def far_away(primitives: int, objects: int = 1) -> tuple[Problem, Branching]:
    """A goal that no three of so many short pushes reach."""
    spots = [(0.4, 0.05 * n - 0.2, 0.02) for n in range(objects)]
    items = tuple(SceneObject(f"item-{n}", "00", (0.02,) * 4, spot) for n, spot in enumerate(spots))
    effects = np.tile([0.01, 0.0, 0.0], (objects, primitives, 1))
    names = tuple(tuple(f"op-{p}-{n}" for p in range(primitives)) for n in range(objects))
    held = np.zeros((objects, primitives), dtype=bool)
    return Problem("far", items, {"item-0": (0.8, -0.2, 0.02)}), Branching(effects, effects, held, names)


def test_depth_time_and_number_of_sequences_end_a_search_with_its_reason(monkeypatch: pytest.MonkeyPatch):
    table = branching_of(problem(), grounding())
    found = plan_bfs(problem(), table, BOUNDS)
    assert (found.status, found.reason) == (PlanStatus.NOT_FOUND, "3 primitives do not suffice")
    assert plan_bfs(problem(), table, BOUNDS, depth=4).status is PlanStatus.SOLVED
    assert plan_bfs(problem(), table, BOUNDS, time_limit=0.0).status is PlanStatus.TIMEOUT
    found = plan_bfs(*far_away(64, 4), BOUNDS)
    said = "2 primitives do not suffice; 3 would be 16,777,216 sequences, more than 2,500,000"
    assert (found.status, found.reason, found.depth) == (PlanStatus.NOT_FOUND, said, 2)
    monkeypatch.setattr(bfs_module, "MOST_SEQUENCES", 3)
    task, short = far_away(5)  # one primitive ahead is looked at, however many there are
    found = plan_bfs(task, short, BOUNDS)
    assert found.reason == "1 primitive does not suffice; 2 would be 25 sequences, more than 3"
    near = replace(task, goals={"item-0": (0.45, -0.2, 0.02)}, tolerance=0.041)
    assert [step.operator for step in plan_bfs(near, short, BOUNDS).steps] == ["op-0-0"]
    found = plan(problem(), grounding(), "bfs-operators")
    assert found.status is PlanStatus.NOT_FOUND
    assert "only 1 is looked at; 2 would be " in found.reason


def test_operators_left_out_are_never_promised_but_may_be_predicted():
    learned = grounding()
    lift = learned.operator_named("lift-010-block")
    slip = replace(lift.outcomes[1], resting_effect=(0.04, 0.0, 0.0), count=10)
    slips = replace(lift, name="slip-010-block", outcomes=(slip,))
    both = replace(learned, objects=replace(learned.objects, operators=(*learned.objects.operators, slips)))
    table = branching_of(problem(), both)  # one primitive with two outcomes is two choices
    assert table.names[0] == ("push-left-000-block", "push-away-001-block", lift.name, slips.name)
    assert table.names[1][:2] == ("push-left-000-tray", "pull-010-tray")
    assert np.isnan(table.effects[1, 2:]).all()
    assert table.effects[0, 3].tolist() == [0.04, 0.0, 0.0]
    assert table.held.tolist() == [[False, False, True, False], [False] * 4]
    predicted = predicted_branching(problem(), both, np.full((2, 4, 3), 0.07))
    assert predicted.names[0][2:] == (lift.name, "stay-111-block")
    assert np.all(predicted.effects == 0.07)
    assert predicted.resting_effects[0, 2].tolist() == [0.0141, -0.0228, 0.0]


@pytest.mark.parametrize("planner", ["bfs", "bfs-operators"])
@pytest.mark.parametrize("problem", [tower(), sorting(), tower_at_place()], ids=lambda one: one.name)
def test_plans_are_true_and_no_longer_than_those_of_fast_downward(problem: Problem, planner: str):
    found = plan(problem, toy_relations.grounding(), planner)
    assert found.status is PlanStatus.SOLVED
    assert validate(found.steps, problem, toy_relations.grounding()).valid
    assert len(found.steps) <= len(plan(problem, toy_relations.grounding()).steps)


def test_what_bears_something_is_put_only_on_what_stands_at_a_place():
    stacks = [("cube", 0.5, -0.2, 0.05), ("cube", 0.5, -0.2), ("cube", 0.5, 0.1, 0.05), ("block", 0.5, 0.1)]
    objects = scene(*stacks)
    goals = (("item-02", "item-03", REST),)
    problem = with_pairs(Problem("laden", objects, {}, relations=goals), relations())
    steps = plan(problem, toy_relations.grounding(), "bfs").steps
    assert len(steps) > 1
    assert validate(steps, problem, toy_relations.grounding()).valid
    written = ground_plan(steps, problem, toy_relations.grounding())
    printed = problem_text(problem, toy_relations.grounding(), plans=[written])
    assert judge(domain_text(toy_relations.grounding()), printed, written.text) == ""
    assert "(put item-02 rests-on-item-03 item-03 from-spot n0 n1" in written.text


def test_search_ends_where_so_many_steps_were_looked_at_or_with_all_sequences():
    result = plan_related(with_pairs(tower(), relations()), toy_relations.grounding(), most_steps=10)
    assert (result.status, result.depth) == (PlanStatus.NOT_FOUND, 0)
    assert result.reason == "10 steps were looked at, 0 deep"
    objects = scene(("cube", 0.5, -0.2), ("block", 0.5, 0.1), ("cube", 0.7, -0.1))
    goals = (("item-01", "item-02", REST), ("item-03", "item-02", REST))
    problem = with_pairs(Problem("both", objects, {}, relations=goals), relations())
    result = plan_related(problem, toy_relations.grounding())
    assert result.status is PlanStatus.NOT_FOUND
    assert result.reason.startswith("no sequence of steps leads there")
