"""Execution on the toy world: promises kept or broken, its record, who watches, and what is run again."""

from importlib.metadata import version
from pathlib import Path

import msgspec
import pytest
import tables
from msgspec.structs import replace
from toy_domain import LEFT, WORLD, grounding, problem

from neurosym.errors import UnknownChoice
from neurosym.execution.executor import execute
from neurosym.execution.performance import STOP, Answer, Moment, compare_runs, rerun
from neurosym.execution.record import Nudge, Replanning, Run, this_machine
from neurosym.operators import Primitive
from neurosym.planners import plan
from neurosym.stages.layout import run_file
from neurosym.tasks.transition import PlanStep

PUSH_LEFT = PlanStep("push-left-001-cube", "item-01")
LIFT = PlanStep("lift-000-cube", "item-01")
PUT_DOWN = PlanStep("put-down-lift-000-cube", "item-01")


@pytest.mark.parametrize(
    ("has_goal", "plan", "happened", "ends"),
    [
        (True, [PUSH_LEFT, PUSH_LEFT], ["resting"] * 2, (0.6, 0.16, 0.025)),
        (True, [LIFT], ["held"], (0.6, 0.0, 0.225)),
        (True, [LIFT, PUT_DOWN, PUSH_LEFT], ["held", "resting"], (0.6, 0.08, 0.025)),
        (True, [LIFT, PUT_DOWN], ["held"], (0.6, 0.0, 0.025)),
        (False, [PUSH_LEFT], ["resting"], (0.6, 0.08, 0.025)),
    ],
    ids=["pushed", "held at the end", "put down before the next step", "put down at the end", "no goals"],
)
def test_plan_that_keeps_its_promises_reaches_the_goal(has_goal, plan, happened, ends):
    seen, task = [], problem({"item-01": ends} if has_goal else {})
    run = execute(WORLD, task, grounding(), plan, on_step=seen.append)
    assert (run.reached, run.reason) == (True, "")
    assert tuple(seen) == run.steps
    assert msgspec.json.decode(msgspec.json.encode(run), type=Run) == run
    assert [(step.happened, step.as_promised) for step in run.steps] == [(how, True) for how in happened]
    assert run.steps[-1].positions["item-01"] == pytest.approx(ends)
    assert run.steps[-1].positions["item-02"] == pytest.approx((0.8, 0.1, 0.025))


def test_broken_promise_is_told_with_what_happened_instead():
    true = grounding()
    primitives = tuple(Primitive(p.symbol, LEFT, 0.0) for p in true.objects.primitives)
    wrong = replace(true, objects=replace(true.objects, primitives=primitives))
    run = execute(WORLD, problem({"item-01": (0.6, 0.0, 0.225)}), wrong, [LIFT])
    assert not run.reached
    assert not run.steps[0].as_promised
    assert run.steps[0].promised == "held"
    assert run.steps[0].happened == "resting"
    assert run.steps[0].effect == pytest.approx((0.0, 0.08, 0.0))
    assert "step 1, lift-000-cube: promised held, ended resting" in run.reason
    nothing = execute(WORLD, problem({"item-01": (0.6, 0.08, 0.025)}), grounding(), [])
    assert (nothing.reached, nothing.distances["item-01"]) == (False, pytest.approx(0.08))
    assert run_file("task-02", Path("plans/task-02.bfs.plan")) == "runs/task-02.bfs.run.json"
    assert run_file("task-02", Path("plans/task-03.bfs.plan")) == "runs/task-02.task-03.bfs.run.json"


def test_step_that_ends_far_from_its_promise_is_not_as_promised_though_it_ends_alike():
    (mode,) = grounding().operator_named(PUSH_LEFT.operator).outcomes
    short = replace(mode, resting_effect=(0.0, 0.02, 0.0))  # 60 mm too little
    wrong = tables.with_modes(PUSH_LEFT.operator, short, learned=grounding())
    (step,) = execute(WORLD, problem({"item-01": (0.6, 0.08, 0.025)}), wrong, [PUSH_LEFT]).steps
    assert (step.promised, step.happened) == ("resting", "resting")
    assert step.deviation == pytest.approx(0.06)
    assert not step.as_promised


HERE = this_machine()


def test_differences_name_both_sides():
    there = replace(HERE, processor="Other 9000", versions={**HERE.versions, "numpy": "0.1", "blas": "3"})
    assert HERE.differences(HERE) == ()
    assert HERE.differences(there) == (
        f"processor: {HERE.processor} and Other 9000",
        "blas: unknown and 3",
        f"numpy: {version('numpy')} and 0.1",
    )


AWAY = {"item-01": (0.6, 0.16, 0.025)}


@pytest.fixture
def run() -> Run:
    return execute(WORLD, problem(AWAY), grounding(), [PUSH_LEFT, PUSH_LEFT])


def shifted(run: Run, number: int, by: float) -> Run:
    """The record of another machine, on which an object came to rest a little farther from a step on."""
    steps = tuple(
        replace(step, positions={name: (x + by, y, z) for name, (x, y, z) in step.positions.items()})
        if at >= number
        else step
        for at, step in enumerate(run.steps, start=1)
    )
    return replace(run, steps=steps)


def again(recorded: Run) -> Run:
    return rerun(WORLD, problem(AWAY), grounding(), recorded)


@pytest.mark.parametrize("by", [3e-9, 9e-7])
def test_last_digits_of_another_processor_are_no_other_course(run, by):
    recorded = shifted(run, 1, by)
    performed = again(recorded)
    assert len(performed.steps) == 2
    found = compare_runs(recorded, performed)
    assert found.course == "within rounding"
    assert found.apart == pytest.approx(by, rel=1e-6)
    assert found.where == "positions of step 1, push-left-001-cube item-01"


@pytest.mark.parametrize("by", [1.1e-6, 1e-3])
@pytest.mark.parametrize("number", [1, 2])
def test_another_course_is_told_by_the_step_that_it_begins_with(run, by, number):
    recorded = shifted(shifted(run, 1, 3e-9), number, by)
    found = compare_runs(recorded, again(recorded))
    assert found.course == "another"
    assert found.where == f"positions of step {number}, push-left-001-cube item-01"


@pytest.mark.parametrize(("field", "value"), [("happened", "lost"), ("touched", ("a",)), ("deviation", None)])
def test_what_is_no_length_must_be_the_same(run, field, value):
    other = replace(run.steps[1], **{field: value})
    recorded = replace(run, steps=(run.steps[0], other))
    found = compare_runs(recorded, again(recorded))
    assert (found.course, found.where) == ("another", f"{field} of step 2, push-left-001-cube item-01")
    found = compare_runs(end := replace(run, distances={"item-01": 1e-3}), again(end))
    assert (found.course, found.where) == ("another", "distances")


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


def test_every_nudge_is_recorded_and_happens_again():
    first, second = Nudge(1, "item-01", (0.0, -0.08, 0.0)), Nudge(2, "item-02", (0.05, 0.0, 0.0))
    run = watched(Script(before_1=first, before_2=second), replanner=plan, replans=4)
    assert run.nudges == (first, second)
    again = rerun(WORLD, problem(AWAY), grounding(), run)
    assert compare_runs(run, again).course == "same bytes"


def test_nudge_after_the_last_step_counts_too_and_one_of_an_unknown_object_is_refused():
    run = watched(Script(before_3=Nudge(3, "item-01", (0.1, 0.0, 0.0))))
    assert (run.reached, run.distances["item-01"]) == (False, pytest.approx(0.1))
    with pytest.raises(UnknownChoice, match="cup"):
        watched(Script(before_1=Nudge(1, "cup", (0.0, 0.0, 0.0))))
    again = rerun(WORLD, problem(AWAY), grounding(), watched(Script()), watcher=Script(before_2=STOP))
    assert len(again.steps) == 1
