"""A run says what ended it, and asks for new plans as long as they come nearer to the goal."""

from dataclasses import replace

from toy_domain import WORLD, grounding, problem

from neurosym.errors import InvalidValue
from neurosym.execution.executor import execute
from neurosym.execution.replanning import PATIENCE, usual_replans, usual_work
from neurosym.execution.rerun import failure
from neurosym.grounding import Grounding
from neurosym.planners import PlanResult, plan
from neurosym.problems import Problem, SceneObject
from neurosym.tasks.transition import PlanStep
from neurosym.world import Outcome, Scene

PUSH_LEFT = PlanStep("push-left-001-cube", "item-01")
LIFT, PUT_DOWN = PlanStep("lift-000-cube", "item-01"), PlanStep("put-down-lift-000-cube", "item-01")
AWAY = {"item-01": (0.6, 0.16, 0.025)}


def replanner(task: Problem, learned: Grounding) -> PlanResult:
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
        return outcome if self.idle < 0 else replace(outcome, lifted=scene, end=scene, held=False)


def test_run_goes_on_as_long_as_it_comes_nearer():
    """Eight failures in a row are no reason to stop, nor eight more after the object has moved."""
    run = execute(Stubborn(8), problem(AWAY), grounding(), [PUSH_LEFT, PUSH_LEFT], replanner=replanner)
    assert (run.reached, run.ended, run.reason) == (True, "goal", "")
    assert len(run.steps) == 10


def test_run_stops_when_new_plans_come_no_nearer():
    run = execute(Stubborn(1000), problem(AWAY), grounding(), [PUSH_LEFT] * 2, replanner=replanner)
    assert (run.reached, run.ended) == (False, "no progress")
    assert len(run.replannings) == PATIENCE
    assert usual_replans([LIFT, PUT_DOWN, PUSH_LEFT]) == PATIENCE + 4
    assert "the last new plans came no nearer to the goal, after 10" in run.reason
    assert failure(run) == "new plans came no nearer"


def test_budget_that_is_given_is_kept_to_and_named():
    run = execute(Stubborn(1000), problem(AWAY), grounding(), [PUSH_LEFT], replanner=replanner, replans=3)
    assert (run.ended, len(run.replannings)) == ("budget", 3)
    assert "all 3 new plans were used up" in run.reason
    assert failure(run) == "new plans were used up"


def test_work_for_new_plans_is_bounded_in_all_and_its_end_is_named():
    def laborious(task: Problem, learned: Grounding) -> PlanResult:
        return replace(replanner(task, learned), work=usual_work(task) // 2)

    run = execute(Stubborn(1000), problem(AWAY), grounding(), [PUSH_LEFT], replanner=laborious)
    assert (run.reached, run.ended, len(run.replannings)) == (False, "work", 2)
    assert (
        f"gave up planning anew: the budget of {usual_work(problem(AWAY)):,} states for new plans was used up"
        in run.reason
    )
    assert "after 2 new plans" in run.reason
    assert failure(run) == "new plans were used up"


def test_lost_object_is_named_as_what_ended_the_run():
    cube = SceneObject("item-01", "00", (0.05, 0.05, 0.05, 0.0), (0.6, 0.25, 0.025))
    edge = Problem("edge", (cube,), {"item-01": (0.6, 0.1, 0.025)})
    run = execute(WORLD, edge, grounding(), [PUSH_LEFT, PUSH_LEFT])
    assert (run.ended, run.reached, [step.happened for step in run.steps]) == ("lost", False, ["lost"])
    assert "step 1 threw item-01 off the table" in run.reason


def test_object_that_was_moved_out_of_reach_is_named(monkeypatch):
    def refuse(*arguments: object, **options: object) -> Outcome:
        raise InvalidValue("out of reach")

    world = Stubborn(0)
    monkeypatch.setattr(world, "interact", refuse)
    run = execute(world, problem(AWAY), grounding(), [PUSH_LEFT])
    assert (run.ended, run.steps[0].happened) == ("out of reach", "not performed")
    assert "item-01 was out of the arm's reach in step 1" in run.reason
