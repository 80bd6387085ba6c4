"""Replanning: a run goes on until the goal is met, from whatever is seen, and its record can be run again."""

import dataclasses

import msgspec
import pytest
import toy_places
from msgspec.structs import replace
from tables import with_modes
from toy_domain import WORLD, grounding, problem

from neurosym.errors import InvalidValue
from neurosym.execution import performance
from neurosym.execution.executor import execute
from neurosym.execution.performance import compare_runs, rerun
from neurosym.execution.record import Nudge
from neurosym.execution.replanning import PATIENCE, usual_replans, usual_work
from neurosym.grounding import Grounding
from neurosym.planners import PlanResult, PlanStatus, plan
from neurosym.problems import Problem
from neurosym.tasks.transition import PlanStep
from neurosym.world import Outcome, Scene, Table

PUSH_LEFT = PlanStep("push-left-001-cube", "item-01")
LIFT, PUT_DOWN = PlanStep("lift-000-cube", "item-01"), PlanStep("put-down-lift-000-cube", "item-01")
AWAY = {"item-01": (0.6, 0.16, 0.025)}


def replanner(task: Problem, learned: Grounding) -> PlanResult:
    return plan(task, learned, "fast-downward")


def no_plan(task: Problem, learned: Grounding) -> PlanResult:
    return PlanResult(PlanStatus.UNSOLVABLE, (), 0.0, "there is none")


def test_plan_that_misses_the_goal_is_replaced_before_it_begins():
    run = execute(WORLD, problem(AWAY), grounding(), [PUSH_LEFT], replanner=replanner)
    assert run.reached
    assert [step.operator for step in run.steps] == ["push-left-001-cube"] * 2
    assert run.replans == 1
    right = execute(WORLD, problem(AWAY), grounding(), [PUSH_LEFT] * 2, replanner=replanner)
    assert (right.reached, right.replans) == (True, 0)
    assert execute(WORLD, problem(AWAY), grounding(), [], replanner=replanner, replans=0).steps == ()
    assert run.replannings[0].before_step == 1
    assert "80 mm from its goal" in run.replannings[0].why


def test_object_held_in_vain_is_put_down_before_anything_else():
    task, (mode,) = (
        problem({"item-01": (0.68, 0.0, 0.225)}),
        grounding().operator_named(LIFT.operator).outcomes,
    )
    wrong = with_modes(LIFT.operator, replace(mode, effect=(0.08, 0.0, 0.2)), learned=grounding())
    run = execute(WORLD, task, wrong, [LIFT], replanner=replanner)
    assert run.reached
    told = [(step.happened, step.put_down) for step in run.steps]
    assert told == [("held", True), ("resting", True), ("held", False)]
    assert run.steps[0].positions["item-01"] == pytest.approx((0.6, 0.0, 0.025))
    assert compare_runs(run, rerun(WORLD, task, wrong, run)).course == "same bytes"


def test_without_a_new_plan_the_old_one_is_gone_on_with():
    run = execute(WORLD, problem(AWAY), grounding(), [PUSH_LEFT], replanner=no_plan)
    assert len(run.steps) == 1
    assert [replanning.reason for replanning in run.replannings] == ["there is none"] * 2
    assert "there is none" in run.reason


@pytest.mark.parametrize("seed", range(3))
def test_nudged_object_still_comes_to_its_goal(seed: int):
    plain = [PUSH_LEFT, PUSH_LEFT]
    run = execute(WORLD, problem(AWAY), grounding(), plain, replanner=replanner, nudge_seed=seed)
    assert run.nudge is not None
    assert run.reached
    again = rerun(WORLD, problem(AWAY), grounding(), run)
    assert msgspec.json.encode(again) == msgspec.json.encode(run)
    assert compare_runs(run, again).course == "same bytes"


def nudge_of(seed: int, table: Table = WORLD.table) -> Nudge | None:
    """What is drawn before the steps of a plan of three, which is at most one nudge."""
    moments = [performance.Moment(number, problem(AWAY).scene(), ()) for number in (1, 2, 3, 4)]
    wanted = [performance.drawn_nudge(seed, 3, moment, problem(AWAY), table) for moment in moments]
    (nudge,) = [one for one in wanted if one] or [None]
    return nudge


def test_nudges_come_from_their_seed_and_keep_objects_on_the_table():
    task = problem(AWAY)
    seen = [nudge_of(seed) for seed in range(30)]
    assert seen == [nudge_of(seed) for seed in range(30)]
    assert {nudge.before_step for nudge in seen if nudge} == {1, 2, 3}
    assert {nudge.object for nudge in seen if nudge} == {"item-01", "item-02"}
    for nudge in seen:
        assert nudge is not None
        x, y, z = nudge.by
        assert performance.LEAST <= (x**2 + y**2) ** 0.5 <= performance.MOST
        assert z == 0.0
        moved = performance.nudged(task.scene(), nudge, task).positions
        assert all(map(WORLD.table.contains, moved))
    assert nudge_of(0, Table((0.0, 0.1), (0.0, 0.1))) is None


def test_run_again_ends_with_the_first_step_that_goes_another_way():
    run = execute(WORLD, problem(AWAY), grounding(), [PUSH_LEFT, PUSH_LEFT])
    false = replace(run, steps=(*run.steps, *run.steps * 1000))
    again = rerun(WORLD, problem(AWAY), grounding(), false)
    assert len(again.steps) == 3
    assert compare_runs(false, again).where == "positions of step 3, push-left-001-cube item-01"


def test_what_can_be_brought_to_its_goal_is_where_another_cannot():
    """A slab is only pushed left and forward here, so it never comes back; the cube is carried."""
    goals = {"item-01": (0.8, 0.1, 0.025), "item-02": (0.45, -0.1, 0.025)}
    task = Problem("half", toy_places.scene(("cube", 0.5, -0.2), ("slab", 0.7, 0.0)), goals, 0.02)
    run = execute(WORLD, task, toy_places.grounding(), [], replanner=plan)
    assert [record.object for record in run.steps] == ["item-01"]
    assert run.distances["item-01"] < 0.02
    assert (run.reached, run.ended) == (False, "no plan")
    assert "item-02" in run.reason
    assert run.replannings[0].plan, "the first new plan was for the cube"
    assert run.replannings[0].reason, "and says why it is for no more"


def counting(task: Problem, learned: Grounding) -> PlanResult:
    return plan(task, learned, "counting")


class Stubborn(type(WORLD)):
    """The toy world, but nothing moves for the first so many times, or ever."""

    def __init__(self, idle: int) -> None:
        super().__init__(WORLD.config)
        self.idle = idle

    def interact(self, scene: Scene, *arguments, **options) -> Outcome:
        """Act, or find that nothing moves."""
        self.idle -= 1
        outcome = super().interact(scene, *arguments, **options)
        return outcome if self.idle < 0 else dataclasses.replace(outcome, lifted=scene, end=scene, held=False)


def test_run_goes_on_as_long_as_it_comes_nearer():
    """Eight failures in a row are no reason to stop, nor eight more after the object has moved."""
    run = execute(Stubborn(8), problem(AWAY), grounding(), [PUSH_LEFT, PUSH_LEFT], replanner=counting)
    assert (run.reached, run.ended, run.reason) == (True, "goal", "")
    assert len(run.steps) == 10


def laborious(task: Problem, learned: Grounding) -> PlanResult:
    return dataclasses.replace(counting(task, learned), work=usual_work(task) // 2)


WORK = f"the budget of {usual_work(problem(AWAY)):,} states for new plans was used up"


@pytest.mark.parametrize(
    ("planner", "replans", "ended", "count", "said", "why"),
    [
        (counting, None, "no progress", PATIENCE, "came no nearer to the goal, after 10", "came no nearer"),
        (counting, 3, "budget", 3, "all 3 new plans were used up", "were used up"),
        (laborious, None, "work", 2, f"gave up planning anew: {WORK}", "were used up"),
    ],
)
def test_run_without_progress_ends_with_its_budget_which_is_named(planner, replans, ended, count, said, why):
    options = {} if replans is None else {"replans": replans}
    run = execute(Stubborn(1000), problem(AWAY), grounding(), [PUSH_LEFT], replanner=planner, **options)
    assert (run.reached, run.ended, len(run.replannings)) == (False, ended, count)
    assert said in run.reason
    assert performance.failure(run) == f"new plans {why}"
    assert usual_replans([LIFT, PUT_DOWN, PUSH_LEFT]) == PATIENCE + 4


def test_object_that_was_moved_out_of_reach_is_named(monkeypatch):
    def refuse(*arguments: object, **options: object) -> Outcome:
        raise InvalidValue("out of reach")

    world = Stubborn(0)
    monkeypatch.setattr(world, "interact", refuse)
    run = execute(world, problem(AWAY), grounding(), [PUSH_LEFT])
    assert (run.ended, run.steps[0].happened) == ("out of reach", "not performed")
    assert "item-01 was out of the arm's reach in step 1" in run.reason
