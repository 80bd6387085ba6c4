"""Who watches a run changes nothing, unless it nudges an object or stops the run."""

import msgspec
import pytest
from toy_domain import WORLD, grounding, problem

from neurosym.errors import UnknownChoice
from neurosym.execution.executor import execute
from neurosym.execution.performance import STOP, Answer, Moment
from neurosym.execution.record import Nudge, Replanning
from neurosym.execution.rerun import compare_runs, rerun
from neurosym.planners import plan
from neurosym.tasks.transition import PlanStep

AWAY = {"item-01": (0.6, 0.16, 0.025)}
PUSH_LEFT = PlanStep("push-left-001-cube", "item-01")
PLAN = [PUSH_LEFT, PUSH_LEFT]


class Script:
    """Answers before each step what is written down, and remembers what it was told."""

    def __init__(self, **answers: Answer):
        self.answers = {int(key.removeprefix("before_")): [answer] for key, answer in answers.items()}
        self.moments: list[Moment] = []
        self.heard: list[Replanning] = []

    def before_step(self, moment: Moment) -> Answer:
        """Answer what is written down."""
        self.moments.append(moment)
        waiting = self.answers.get(moment.number, [])
        return waiting.pop() if waiting else None

    def replanned(self, replanning: Replanning) -> None:
        """Remember it."""
        self.heard.append(replanning)


def watched(script: Script, **options):
    return execute(WORLD, problem(AWAY), grounding(), PLAN, watcher=script, **options)


def test_who_only_watches_changes_no_byte():
    script = Script()
    plain = execute(WORLD, problem(AWAY), grounding(), PLAN)
    assert msgspec.json.encode(watched(script)) == msgspec.json.encode(plain)
    assert [moment.number for moment in script.moments] == [1, 2, 3]
    assert [len(moment.left) for moment in script.moments] == [2, 1, 0]


@pytest.mark.parametrize("number", [1, 2])
def test_run_that_is_stopped_says_before_which_step(number):
    run = watched(Script(**{f"before_{number}": STOP}))
    assert (len(run.steps), run.ended, run.reached) == (number - 1, "stopped", False)
    assert run.reason.endswith(f"it was stopped before step {number}")


def test_nudge_calls_for_a_new_plan_that_is_told():
    script = Script(before_2=Nudge(0, "item-01", (0.0, -0.08, 0.0)))
    run = watched(script, replanner=plan, replans=4)
    assert run.reached
    assert run.nudge == Nudge(2, "item-01", (0.0, -0.08, 0.0))
    assert run.more_nudges is msgspec.UNSET
    assert [replanning.why for replanning in script.heard] == [one.why for one in run.replannings]
    assert run.replannings


def test_nudge_after_the_last_step_counts_too():
    run = watched(Script(before_3=Nudge(3, "item-01", (0.1, 0.0, 0.0))))
    assert not run.reached
    assert run.distances["item-01"] == pytest.approx(0.1)


def test_every_nudge_is_recorded_and_happens_again():
    first, second = Nudge(1, "item-01", (0.0, -0.08, 0.0)), Nudge(2, "item-02", (0.05, 0.0, 0.0))
    run = watched(Script(before_1=first, before_2=second), replanner=plan, replans=4)
    assert run.nudges == (first, second)
    again = rerun(WORLD, problem(AWAY), grounding(), run)
    assert compare_runs(run, again).course == "same bytes"


def test_unknown_object_is_refused():
    with pytest.raises(UnknownChoice, match="cup"):
        watched(Script(before_1=Nudge(1, "cup", (0.0, 0.0, 0.0))))


def test_run_that_happens_again_can_be_stopped():
    run = watched(Script())
    again = rerun(WORLD, problem(AWAY), grounding(), run, watcher=Script(before_2=STOP))
    assert len(again.steps) == 1
