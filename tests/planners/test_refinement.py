"""From a problem to a believed plan: replayed, mended, explained, and as cheap as the reference's."""

import dataclasses
import itertools

import msgspec
import pytest
from tables import grounding, item, problem, total_cost

from neurosym.errors import UnknownChoice
from neurosym.grounding import Grounding
from neurosym.planners import PlanResult, PlanStatus, pddl_planner, plan
from neurosym.planners import pddl_search as refinement
from neurosym.planners.planner import Effort, PlannerAnswer
from neurosym.problems import Problem
from neurosym.tasks.transition import PlanStep, validate


@pytest.mark.parametrize("cell", [0.005, 0.02])
@pytest.mark.parametrize("encoding", ["strips", "sas"])
def test_errand_is_solved_and_the_plan_is_true(encoding: str, cell: float):
    found = plan(problem(), grounding(cell), encoding=encoding)
    assert found.status is PlanStatus.SOLVED, found.reason
    assert validate(found.steps, problem(), grounding()).valid
    assert found.seconds > 0


def test_plan_is_the_cheapest_there_is():
    """Compared with all multisets of up to six pushes of one block."""
    goal = (0.665, 0.155, 0.025)
    task = Problem("p", (item("item-01", 0.4512, 0.0133),), {"item-01": goal}, tolerance=0.03)
    names = ("push-away-001-block", "push-left-000-block")
    plans = (
        tuple(PlanStep(name, "item-01") for name in combination)
        for length in range(7)
        for combination in itertools.combinations_with_replacement(names, length)
    )
    cheapest = min(total_cost(steps) for steps in plans if validate(steps, task, grounding()).valid)
    assert total_cost(plan(task, grounding()).steps) == cheapest


def test_many_objects_are_planned_one_by_one_and_the_held_one_comes_last():
    more = (item("item-03", 0.4, -0.2), item("item-04", 0.8, -0.2))
    task = problem()
    goals = {**task.goals, "item-03": (0.4, -0.117, 0.025), "item-04": (0.8, -0.117, 0.025)}
    crowd = msgspec.structs.replace(task, objects=(*task.objects, *more), goals=goals)
    found = plan(crowd, grounding())
    assert found.status is PlanStatus.SOLVED, found.reason
    assert validate(found.steps, crowd, grounding()).valid
    assert found.steps[-1] == PlanStep("lift-010-block", "item-01")


def test_two_objects_cannot_both_be_held_at_the_end():
    objects = tuple(item(f"item-0{n}", 0.4 + 0.1 * n, 0.0) for n in range(3))
    goals = {thing.name: (thing.position[0], 0.0, 0.228) for thing in objects}
    task = Problem("p", objects, goals)
    found = plan(task, grounding())
    assert found.status is PlanStatus.UNSOLVABLE
    assert "item-00 and item-01 and item-02 would have to be held" in found.reason


def test_goals_that_need_no_hand_are_met_even_if_lifting_were_cheaper_for_each():
    """Where each plan alone would end held, the problem is solved whole."""
    learned = grounding()
    lift = learned.operator_named("lift-010-block")
    low = msgspec.structs.replace(lift.modes[0], effect=(0.1, 0.0, 0.02), resting_effect=(0.1, 0.0, 0.0))
    operators = (msgspec.structs.replace(lift, modes=(low,)), *learned.operators.operators)
    table = msgspec.structs.replace(learned.operators, operators=operators[:1])
    lifting = msgspec.structs.replace(learned, operators=table, cell=0.01)
    objects = (item("item-01", 0.5, 0.0), item("item-02", 0.5, 0.15))
    goals = {thing.name: (0.6, thing.position[1], 0.03) for thing in objects}
    found = plan(Problem("p", objects, goals), lifting)
    assert [step.operator for step in found.steps][:3] == [lift.name, f"put-down-{lift.name}", lift.name]


def test_objects_with_one_goal_are_brought_beside_each_other():
    """The cheapest plans for each would end in each other, and no order of steps helps."""
    spot = (0.57, 0.06, 0.025)
    task = Problem(
        "p", (item("item-01", 0.4, 0.0), item("item-02", 0.4, 0.12)), {"item-01": spot, "item-02": spot}
    )
    found = plan(task, grounding())
    assert found.status is PlanStatus.SOLVED, found.reason
    assert validate(found.steps, task, grounding()).valid


def test_object_is_brought_beside_a_bystander():
    """The cheapest plan would end in it; nothing is to be done with the bystander."""
    objects = (item("item-01", 0.4, 0.0), item("item-02", 0.585, 0.06))
    task = Problem("p", objects, {"item-01": (0.57, 0.06, 0.025)})
    found = plan(task, grounding())
    assert found.status is PlanStatus.SOLVED, found.reason
    assert "ways around each other were taken" in found.reason
    assert {step.object for step in found.steps} == {"item-01"}
    assert validate(found.steps, task, grounding()).valid


def test_goal_met_at_the_start_needs_no_step():
    task = Problem("p", (item("item-01", 0.5, 0.0),), {"item-01": (0.51, 0.0, 0.025)})
    assert (plan(task, grounding()).status, plan(task, grounding()).steps) == (
        PlanStatus.SOLVED,
        (),
    )


@pytest.mark.parametrize("planner", ["bfs", "fast-downward"])
def test_unsolvable_says_which_object_and_how_near(planner: str):
    objects = (item("item-01", 0.5, 0.0), item("item-02", 0.7, 0.2, category="11"))
    task = Problem("p", objects, {"item-01": (0.571, -0.012, 0.025), "item-02": (0.85, 0.2, 0.02)})
    found = plan(task, grounding(), planner)
    assert found.status is PlanStatus.UNSOLVABLE
    assert (
        "item-02 cannot reach its goal: out of every primitive's reach; up to 8 primitives bring it to 150"
        in found.reason
    )


def test_plan_whose_replay_is_wrong_is_planned_again_and_given_up_in_the_end():
    texts = ["(push-left-000-block item-01)", "(push-away-001-block item-01)"]
    answers = [PlannerAnswer(PlanStatus.SOLVED, text, 0.1) for text in texts]
    asked: list[str] = []

    def scripted(domain, task, *, time_limit: float) -> PlannerAnswer:
        asked.append(task.read_text())
        return answers[min(len(asked), len(answers)) - 1]

    planner = pddl_planner("scripted", "a script", scripted, ("strips",))
    task = Problem("p", (item("item-01", 0.5, 0.0),), {"item-01": (0.571, -0.012, 0.025)})
    found = plan(task, grounding(), planner)
    assert (found.status, len(asked)) == (PlanStatus.SOLVED, 2)
    assert "attempt 2" in found.reason
    assert asked[0].count("goal-cell") > asked[1].count("goal-cell")
    answers.pop()
    gave_up = plan(task, grounding(), planner)
    assert gave_up.status is PlanStatus.FAILED
    assert "no plan was true when replayed, in 4 attempts" in gave_up.reason
    cells = [text.count("x-cell") and text.split(" - x-cell")[0].count(" x") for text in asked[-4:]]
    assert cells[2] == cells[3] > 2.9 * cells[1]  # the later half is solved on a finer grid


def test_time_out_is_a_result():
    assert plan(problem(), grounding(), time_limit=1e-9).status is PlanStatus.TIMEOUT


def test_unknown_planner_is_refused_with_the_known_ones():
    with pytest.raises(UnknownChoice, match="valid: aries, bfs, bfs-operators, counting"):
        plan(problem(), grounding(), "crystal-ball")


def test_result_cannot_be_changed():
    with pytest.raises(dataclasses.FrozenInstanceError):
        plan(problem(), grounding(), "bfs").seconds = 0.0  # type: ignore[misc]


def test_encodings_agree_on_the_cost():
    costs = {total_cost(plan(problem(), grounding(0.01), encoding=name).steps) for name in ("strips", "sas")}
    assert len(costs) == 1


def test_objects_in_each_others_way_are_planned_for_without_costs_in_the_end(monkeypatch: pytest.MonkeyPatch):
    asked, plan_one_by_one = [], refinement._plan_one_by_one

    def one_by_one(task: Problem, learned: Grounding, believed, effort: Effort):
        asked.append(learned.unit_costs)
        if not learned.unit_costs:
            return PlanResult(PlanStatus.FAILED, (), 0.0, "they collide")
        return plan_one_by_one(task, learned, believed, effort)

    monkeypatch.setattr(refinement, "_plan_one_by_one", one_by_one)
    result = plan(problem(), grounding())
    assert asked == [False, False, True]  # away from the edges of the table, then up to them
    assert result.status is PlanStatus.SOLVED
    assert result.reason == "not the most reliable: they collide"
    assert validate(result.steps, problem(), grounding()).valid


def no_way(problem: Problem, learned: Grounding, *, deadline: float) -> PlanResult:
    """Find no ways around each other."""
    del problem, learned, deadline
    return PlanResult(PlanStatus.NOT_FOUND, (), 0.0, "no ways")


def test_objects_are_counted_to_where_they_end_apart_if_there_are_no_ways_around(
    monkeypatch: pytest.MonkeyPatch,
):
    monkeypatch.setattr(refinement, "plan_around", no_way)
    objects = (item("item-01", 0.4, 0.0), item("item-02", 0.585, 0.06))
    task = Problem("p", objects, {"item-01": (0.57, 0.06, 0.025)})
    found = plan(task, grounding())
    assert "as few steps as possible were taken" in found.reason
    assert validate(found.steps, task, grounding()).valid
