"""Tables say what a page shows, and nothing from outside becomes markup."""

import pytest
from studio_pages import shipped_library

from neurosym.execution.record import Replanning, Run
from neurosym.files import read_json
from neurosym.planners import PlanStatus
from neurosym.stages.plan_records import PlanRecord
from neurosym.studio import words
from neurosym.studio.words import (
    plan_summary,
    plan_table,
    run_summary,
    run_table,
    safe,
)

EVIL = '<img src=x onerror="alert(1)">'
LIBRARY = shipped_library()
RUN = read_json(LIBRARY.folder / "runs" / "task-02.fast-downward.run.json", Run)
RECORD = read_json(LIBRARY.folder / "plans" / "task-02.fast-downward.json", PlanRecord)


def test_markup_and_control_characters_become_text():
    assert safe(EVIL) == "&lt;img src=x onerror=&quot;alert(1)&quot;&gt;"
    assert "\x1b" not in safe("\x1b[31m")


@pytest.mark.parametrize(
    "told",
    [
        words.replanning_list([Replanning(2, EVIL, (), EVIL)]),
        plan_summary(PlanRecord("a", EVIL, PlanStatus.FAILED, (), 0.1, EVIL)),
        words.preformatted(EVIL),
        words.table([EVIL], [], label=EVIL),
        words.coloured(EVIL, "red"),
    ],
)
def test_what_comes_from_outside_is_never_markup(told):
    assert "<img" not in told
    assert "&lt;img" in told


def test_plan_is_told_with_bits_cost_and_chance():
    told = plan_table(RECORD, LIBRARY.load_problem("task-02"), LIBRARY.grounding, at=1)
    for operator, name, *_ in RECORD.steps:
        assert operator in told
        assert name in told
    assert "01 · 0111" in told
    assert told.count('aria-current="step"') == 1
    assert "%" in told


def test_every_step_of_a_run_is_told_with_its_promise():
    told = run_table(RUN.steps)
    assert told.count("as promised") == sum(step.as_promised for step in RUN.steps)
    assert "held" in told
    assert "goal reached" in run_summary(RUN)
