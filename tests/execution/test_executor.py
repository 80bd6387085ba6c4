"""Execution on the toy world, where every promise can be kept exactly or broken, and its record."""

import math
from importlib.metadata import version
from pathlib import Path

import msgspec
import pytest
import tables
from msgspec.structs import replace
from toy_domain import LEFT, WORLD, grounding, problem

from neurosym.execution.executor import execute
from neurosym.execution.record import Run, as_it_shows, this_machine
from neurosym.grounding import Grounding
from neurosym.operators import Primitive
from neurosym.problems import SceneObject
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
    primitives = tuple(Primitive(p.symbol, LEFT, 0.0) for p in true.operators.primitives)
    wrong = replace(true, operators=replace(true.operators, primitives=primitives))
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
    learned = grounding()
    operators = []
    for operator in learned.operators.operators:
        mode = replace(operator.modes[0], resting_effect=(0.0, 0.02, 0.0))  # 60 mm too little
        is_push = operator.name == PUSH_LEFT.operator
        operators.append(replace(operator, modes=(mode,)) if is_push else operator)
    table = replace(learned.operators, operators=tuple(operators))
    wrong = replace(learned, operators=table)
    (step,) = execute(WORLD, problem({"item-01": (0.6, 0.08, 0.025)}), wrong, [PUSH_LEFT]).steps
    assert (step.promised, step.happened) == ("resting", "resting")
    assert step.deviation == pytest.approx(0.06)
    assert not step.as_promised


def lying(degrees: float, axis: int = 2) -> SceneObject:
    half = math.radians(degrees) / 2
    turn = [0.0, 0.0, 0.0, math.cos(half)]
    turn[axis] = math.sin(half)
    return SceneObject("item-01", "00", (0.04, 0.1, 0.06, 0.0), (0.5, 0.0, 0.03), tuple(turn))


@pytest.mark.parametrize(
    ("degrees", "axis", "sizes"),
    [
        (0, 2, (0.04, 0.1, 0.06)),
        (10, 2, (0.04, 0.1, 0.06)),
        (90, 2, (0.1, 0.04, 0.06)),
        (-80, 2, (0.1, 0.04, 0.06)),
        (180, 2, (0.04, 0.1, 0.06)),
        (90, 0, (0.04, 0.06, 0.1)),
        (45, 2, (0.14 * math.sqrt(0.5), 0.14 * math.sqrt(0.5), 0.06)),
    ],
)
def test_sizes_are_those_of_the_box_around_the_object(degrees: float, axis: int, sizes: tuple[float, ...]):
    shown = as_it_shows(lying(degrees, axis), tables.grounding())
    assert shown.features[:3] == pytest.approx(sizes, abs=1e-6)
    assert shown.features[3] == 0.0
    assert shown.category == "00"


def test_category_is_that_of_rehearsed_objects_of_such_sizes():
    wide, deep = (0.1, 0.04, 0.06, 0.0), (0.04, 0.1, 0.06, 0.0)
    kept = {"00": (deep,), "11": (wide,)}
    table = tables.table()
    categories = tuple(replace(one, objects=kept[one.symbol]) for one in table.categories)
    learned: Grounding = replace(tables.grounding(), operators=replace(table, categories=categories))
    assert as_it_shows(lying(5), learned).category == "00"
    assert as_it_shows(lying(95), learned).category == "11"


HERE = this_machine()


def test_differences_name_both_sides():
    there = replace(HERE, processor="Other 9000", versions={**HERE.versions, "numpy": "0.1", "blas": "3"})
    assert HERE.differences(HERE) == ()
    assert HERE.differences(there) == (
        f"processor: {HERE.processor} and Other 9000",
        "blas: unknown and 3",
        f"numpy: {version('numpy')} and 0.1",
    )
