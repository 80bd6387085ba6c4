"""Running a record again tells the same bytes, the same but for the last digits, and another course apart."""

import json

import msgspec
import pytest
from toy_domain import WORLD, grounding, problem

from neurosym.execution.executor import execute
from neurosym.execution.record import Run
from neurosym.execution.rerun import ROUNDING, compare_runs, rerun
from neurosym.tasks.transition import PlanStep

AWAY = {"item-01": (0.6, 0.16, 0.025)}
PUSH_LEFT = PlanStep("push-left-001-cube", "item-01")


@pytest.fixture
def run() -> Run:
    return execute(WORLD, problem(AWAY), grounding(), [PUSH_LEFT, PUSH_LEFT])


def shifted(run: Run, number: int, by: float) -> Run:
    """The record of another machine, on which an object came to rest a little farther from a step on."""
    steps = tuple(
        msgspec.structs.replace(
            step, positions={name: (x + by, y, z) for name, (x, y, z) in step.positions.items()}
        )
        if at >= number
        else step
        for at, step in enumerate(run.steps, start=1)
    )
    return msgspec.structs.replace(run, steps=steps)


def again(recorded: Run) -> Run:
    return rerun(WORLD, problem(AWAY), grounding(), recorded)


def test_same_bytes_are_told(run):
    found = compare_runs(run, again(run))
    assert (found.course, found.apart, found.where) == ("same bytes", 0.0, "")


@pytest.mark.parametrize("by", [3e-9, 0.9 * ROUNDING])
def test_last_digits_of_another_processor_are_no_other_course(run, by):
    recorded = shifted(run, 1, by)
    performed = again(recorded)
    assert len(performed.steps) == 2
    found = compare_runs(recorded, performed)
    assert found.course == "within rounding"
    assert found.apart == pytest.approx(by, rel=1e-6)
    assert found.where == "positions of step 1, push-left-001-cube item-01"


@pytest.mark.parametrize("by", [1.1 * ROUNDING, 1e-3])
@pytest.mark.parametrize("number", [1, 2])
def test_another_course_is_told_by_the_step_that_it_begins_with(run, by, number):
    recorded = shifted(run, number, by)
    found = compare_runs(recorded, again(recorded))
    assert found.course == "another"
    assert found.where == f"positions of step {number}, push-left-001-cube item-01"


def test_another_course_is_told_though_digits_differ_before_it(run):
    recorded = shifted(shifted(run, 1, 3e-9), 2, 1e-3)
    found = compare_runs(recorded, again(recorded))
    assert (found.course, found.where) == ("another", "positions of step 2, push-left-001-cube item-01")


@pytest.mark.parametrize(
    ("field", "value"), [("as_promised", False), ("happened", "toppled"), ("touched", ("item-02",))]
)
def test_what_is_no_length_must_be_the_same(run, field, value):
    other = msgspec.structs.replace(run.steps[1], **{field: value})
    recorded = msgspec.structs.replace(run, steps=(run.steps[0], other))
    found = compare_runs(recorded, again(recorded))
    assert (found.course, found.where) == ("another", f"{field} of step 2, push-left-001-cube item-01")


def test_missing_deviation_is_no_length(run):
    other = msgspec.structs.replace(run.steps[1], deviation=None)
    recorded = msgspec.structs.replace(run, steps=(run.steps[0], other))
    assert compare_runs(recorded, again(recorded)).where.startswith("deviation of step 2")


def test_end_that_differs_is_told(run):
    recorded = msgspec.structs.replace(run, distances={"item-01": run.distances["item-01"] + 1e-3})
    found = compare_runs(recorded, again(recorded))
    assert (found.course, found.where) == ("another", "distances")


def test_record_without_a_machine_or_a_tolerance_can_be_read(run):
    fields = json.loads(msgspec.json.encode(run))
    for name in ("machine", "tolerance"):
        del fields[name]
    old = msgspec.json.decode(json.dumps(fields), type=Run)
    assert (old.machine, old.tolerance) == (None, None)
    assert compare_runs(old, again(old)).course == "same bytes"
