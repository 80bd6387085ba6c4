"""From a problem to a believed plan: replayed, mended, explained; and to unified-planning and back."""

import itertools
import sys
from collections import Counter

import pytest
import toy_domain
import toy_places
from msgspec.structs import replace
from tables import LEFT, PUSH, grounding, item, mode, problem, total_cost, with_modes
from validators import quiet

import neurosym
from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.execution.executor import execute
from neurosym.grounding import Grounding
from neurosym.pddl.compiler import domain_text, ground_plan, problem_text
from neurosym.planners import PlanResult, PlanStatus, pddl_planner, plan
from neurosym.planners.joined_plans import plan_singly
from neurosym.planners.planner import Effort, PlannerAnswer
from neurosym.planners.unified_planning import PddlVerdict, validate_pddl
from neurosym.problems import Problem
from neurosym.tasks.transition import PlanStep, validate

MODULE = sys.modules["neurosym.planners.pddl_search"]
"""The package has a function of that name, too."""


@pytest.mark.parametrize("cell", [0.005, 0.02])
def test_errand_is_solved_and_the_plan_is_true_and_costs_as_much_in_each_encoding(cell: float):
    found = [plan(problem(), grounding(cell), encoding=name) for name in ("strips", "sas")]
    for result in found:
        assert result.status is PlanStatus.SOLVED, result.reason
        assert validate(result.steps, problem(), grounding()).valid
        assert result.seconds > 0
    assert len({total_cost(result.steps) for result in found}) == 1
    assert plan(problem(), grounding(), time_limit=1e-9).status is PlanStatus.TIMEOUT
    with pytest.raises(UnknownChoice, match="valid: bfs, bfs-operators, counting"):
        plan(problem(), grounding(), "crystal-ball")


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
    crowd = replace(task, objects=(*task.objects, *more), goals=goals)
    found = plan(crowd, grounding())
    assert found.status is PlanStatus.SOLVED, found.reason
    assert validate(found.steps, crowd, grounding()).valid
    assert found.steps[-1] == PlanStep("lift-010-block", "item-01")


def test_goals_that_need_no_hand_are_met_even_if_lifting_were_cheaper_for_each():
    """Where each plan alone would end held, the problem is solved whole."""
    learned = grounding()
    lift = learned.operator_named("lift-010-block")
    low = replace(lift.outcomes[0], effect=(0.1, 0.0, 0.02), resting_effect=(0.1, 0.0, 0.0))
    operators = (replace(lift, outcomes=(low,)), *learned.objects.operators)
    table = replace(learned.objects, operators=operators[:1])
    lifting = replace(learned, objects=table, cell=0.01)
    objects = (item("item-01", 0.5, 0.0), item("item-02", 0.5, 0.15))
    goals = {thing.name: (0.6, thing.position[1], 0.03) for thing in objects}
    found = plan(Problem("p", objects, goals), lifting)
    assert [step.operator for step in found.steps][:3] == [lift.name, f"put-down-{lift.name}", lift.name]


def test_objects_are_brought_beside_each_other_and_a_bystander():
    """The cheapest plans would end in each other, and no order of steps helps."""
    spot, both = (0.57, 0.06, 0.025), (item("item-01", 0.4, 0.0), item("item-02", 0.4, 0.12))
    task = Problem("p", both, {"item-01": spot, "item-02": spot})
    for planner in ("fast-downward", "counting"):
        found = plan(task, grounding(), planner)
        assert found.status is PlanStatus.SOLVED, found.reason
        assert validate(found.steps, task, grounding()).valid
    objects = (item("item-01", 0.4, 0.0), item("item-02", 0.585, 0.06))
    task = Problem("p", objects, {"item-01": (0.57, 0.06, 0.025)})
    found = plan(task, grounding())
    assert found.status is PlanStatus.SOLVED, found.reason
    assert "ways around each other were taken" in found.reason
    assert {step.object for step in found.steps} == {"item-01"}
    assert validate(found.steps, task, grounding()).valid


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


def test_few_steps_of_a_plan_that_cells_round_are_exchanged_and_no_more_are(monkeypatch: pytest.MonkeyPatch):
    learned = with_modes("push-left-000-block", mode((0.0, 0.05, 0.0)), learned=grounding(0.02))
    learned = with_modes("push-away-001-block", mode((0.03, 0.03, 0.0)), learned=learned)
    asked = list[str]()

    def scripted(domain, task, *, time_limit: float) -> PlannerAnswer:
        asked.append(task.read_text())
        return PlannerAnswer(PlanStatus.SOLVED, "(push-left-000-block item-01)\n" * 5, 0.1)

    planner = pddl_planner("scripted", "a script", scripted, ("strips",))
    task = Problem("p", (item("item-01", 0.5, 0.0),), {"item-01": (0.53, 0.23, 0.025)}, tolerance=0.01)
    found = plan(task, learned, planner)
    assert (found.status, len(asked)) == (PlanStatus.SOLVED, 1)
    assert Counter(found.steps) == {LEFT: 4, PUSH: 1}
    assert validate(found.steps, task, learned).valid
    finer = plan(task, replace(learned, cell=0.005), planner)  # so far cells would not round
    assert finer.status is PlanStatus.FAILED
    monkeypatch.setattr("neurosym.planners.action_counts.MOST_LOOKED_AT", 1)
    assert plan(task, learned, planner).status is PlanStatus.FAILED


def test_objects_in_each_others_way_are_planned_for_without_costs_in_the_end(monkeypatch: pytest.MonkeyPatch):
    asked = []

    def singly(task: Problem, learned: Grounding, solve, effort: Effort):
        asked.append(learned.unit_costs)
        if not learned.unit_costs:
            return PlanResult(PlanStatus.FAILED, (), 0.0, "they collide")
        return plan_singly(task, learned, solve, effort)

    monkeypatch.setattr(MODULE, "plan_singly", singly)
    result = plan(problem(), grounding())
    assert asked == [False, False, True]  # away from the edges of the table, then up to them
    assert result.status is PlanStatus.SOLVED
    assert result.reason == "not the most reliable: they collide"
    assert validate(result.steps, problem(), grounding()).valid


def solved(task):
    """What an engine of unified-planning plans for a problem."""
    with quiet():
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
    for found, said in (("a plan", "^A str is no"), (PartialOrderPlan({}), "^A PartialOrderPlan is no")):
        with pytest.raises(InvalidValue, match=said):
            neurosym.from_unified_planning(found, problem, toy_domain.grounding())


TASK = toy_domain.problem({"item-01": (0.6, 0.08, 0.025)})
DOMAIN = domain_text(toy_domain.grounding())
PROBLEM = problem_text(TASK, toy_domain.grounding())


def actions() -> list[tuple[str, ...]]:
    steps = [PlanStep("push-left-001-cube", "item-01")]
    lines = ground_plan(steps, TASK, toy_domain.grounding()).lines
    return [tuple(line.strip("()").split()) for line in lines]


def test_first_action_that_cannot_be_performed_is_named_or_the_goal_that_is_not_met():
    push, along_x, along_y, reach = actions()
    assert validate_pddl(DOMAIN, PROBLEM, actions()) == PddlVerdict(valid=True)
    verdict = validate_pddl(DOMAIN, PROBLEM, [push, along_x, along_y, push, along_x, along_y, reach])
    assert verdict == PddlVerdict(False, f"(at-y item-01 {along_y[3]}) does not hold", 6)
    for part in (actions()[:-1], []):
        assert validate_pddl(DOMAIN, PROBLEM, part).reason == "(done item-01) does not hold in the end"
    with pytest.raises(InvalidValue, match="PDDL"):
        validate_pddl("(define", PROBLEM, actions())
