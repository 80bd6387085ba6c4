"""Execution on the toy world, where every promise can be kept exactly or broken on purpose."""

from pathlib import Path

import msgspec
import pytest
from toy_domain import LEFT, WORLD, grounding, problem

from neurosym.execution.executor import execute
from neurosym.execution.record import Run
from neurosym.files import read_json, write_json
from neurosym.operators import Primitive
from neurosym.stages.layout import run_file
from neurosym.tasks.transition import PlanStep

PUSH_LEFT = PlanStep("push-left-001-cube", "item-01")
LIFT = PlanStep("lift-000-cube", "item-01")
PUT_DOWN = PlanStep("put-down-lift-000-cube", "item-01")


@pytest.mark.parametrize(
    ("has_goal", "plan", "happened", "ends"),
    [
        ({"item-01": (0.6, 0.16, 0.025)}, [PUSH_LEFT, PUSH_LEFT], ["resting"] * 2, (0.6, 0.16, 0.025)),
        ({"item-01": (0.6, 0.0, 0.225)}, [LIFT], ["held"], (0.6, 0.0, 0.225)),
        (
            {"item-01": (0.6, 0.08, 0.025)},
            [LIFT, PUT_DOWN, PUSH_LEFT],
            ["held", "resting"],
            (0.6, 0.08, 0.025),
        ),
        ({"item-01": (0.6, 0.0, 0.025)}, [LIFT, PUT_DOWN], ["held"], (0.6, 0.0, 0.025)),
        ({}, [PUSH_LEFT], ["resting"], (0.6, 0.08, 0.025)),
    ],
    ids=["pushed", "held at the end", "put down before the next step", "put down at the end", "no goals"],
)
def test_plan_that_keeps_its_promises_reaches_the_goal(has_goal, plan, happened, ends):
    run = execute(WORLD, problem({"item-01": ends} if has_goal else {}), grounding(), plan)
    assert (run.reached, run.reason) == (True, "")
    assert [(step.happened, step.as_promised) for step in run.steps] == [(how, True) for how in happened]
    assert run.steps[-1].positions["item-01"] == pytest.approx(ends)
    assert run.steps[-1].positions["item-02"] == pytest.approx((0.8, 0.1, 0.025))


def test_empty_plan_leaves_everything_where_it_was():
    run = execute(WORLD, problem({"item-01": (0.6, 0.08, 0.025)}), grounding(), [])
    assert not run.reached
    assert run.distances["item-01"] == pytest.approx(0.08)


def test_broken_promise_is_told_with_what_happened_instead():
    true = grounding()
    primitives = tuple(Primitive(p.symbol, LEFT, 0.0) for p in true.operators.primitives)
    wrong = msgspec.structs.replace(
        true, operators=msgspec.structs.replace(true.operators, primitives=primitives)
    )
    run = execute(WORLD, problem({"item-01": (0.6, 0.0, 0.225)}), wrong, [LIFT])
    assert not run.reached
    assert not run.steps[0].as_promised
    assert run.steps[0].promised == "held"
    assert run.steps[0].happened == "resting"
    assert run.steps[0].effect == pytest.approx((0.0, 0.08, 0.0))
    assert "step 1, lift-000-cube: promised held, ended resting" in run.reason


def test_each_step_is_announced_as_soon_as_it_is_done():
    seen = []
    execute(
        WORLD,
        problem({"item-01": (0.6, 0.08, 0.025)}),
        grounding(),
        [PUSH_LEFT, PUSH_LEFT],
        on_step=seen.append,
    )
    assert [record.operator for record in seen] == ["push-left-001-cube"] * 2


def test_record_reads_back_as_it_was_written(tmp_path):
    run = execute(WORLD, problem({"item-01": (0.6, 0.08, 0.025)}), grounding(), [PUSH_LEFT])
    write_json(tmp_path / "run.json", run)
    assert read_json(tmp_path / "run.json", Run) == run


def test_record_is_named_after_problem_and_plan():
    assert run_file("task-02", Path("my.plan")) == "runs/task-02.my.run.json"
    assert run_file("task-02", Path("plans/task-02.bfs.plan")) == "runs/task-02.bfs.run.json"
    assert run_file("task-02", Path("plans/task-03.bfs.plan")) == "runs/task-02.task-03.bfs.run.json"


def test_step_that_ends_far_from_its_promise_is_not_as_promised_though_it_ends_alike():
    learned = grounding()
    operators = []
    for operator in learned.operators.operators:
        mode = msgspec.structs.replace(operator.modes[0], resting_effect=(0.0, 0.02, 0.0))  # 60 mm too little
        is_push = operator.name == PUSH_LEFT.operator
        operators.append(msgspec.structs.replace(operator, modes=(mode,)) if is_push else operator)
    table = msgspec.structs.replace(learned.operators, operators=tuple(operators))
    wrong = msgspec.structs.replace(learned, operators=table)
    (step,) = execute(WORLD, problem({"item-01": (0.6, 0.08, 0.025)}), wrong, [PUSH_LEFT]).steps
    assert (step.promised, step.happened) == ("resting", "resting")
    assert step.deviation == pytest.approx(0.06)
    assert not step.as_promised
