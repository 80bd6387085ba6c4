"""Tables say what a page shows, and nothing from outside becomes markup."""

import pytest
import toy_relations
from studio_pages import shipped_library
from toy_relations import LIE, PUT_IN, REST

from neurosym.execution.executor import execute
from neurosym.execution.record import Replanning, Run
from neurosym.files import read_json
from neurosym.planners import PlanStatus, plan
from neurosym.stages.plan_records import PlanRecord
from neurosym.studio import words
from neurosym.studio.words import (
    bits_row,
    plan_summary,
    plan_table,
    run_summary,
    run_table,
    safe,
)
from neurosym.tasks.options import put_named
from neurosym.tasks.transition import named_steps

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


def test_plan_on_pairs_is_told_with_states_and_what_third_objects_make_of_the_chance():
    learned, scene = toy_relations.grounding(), toy_relations.sorting()
    result = plan(scene, learned)
    record = PlanRecord(
        scene.name, "fast-downward", result.status, named_steps(result.steps), 0.1, "", chance=0.8
    )
    told = plan_table(record, scene, learned)
    for name, tray in (("item-01", "item-04"), ("item-02", "item-05")):
        assert f"puts it {LIE} {tray}" in told
        assert name in told
    assert "<code>11 · 01</code>" in told
    assert told.count(f"{21 / 22 * (11 / 12) / (21 / 22):.0%}") == 2  # from another object each
    cost = put_named(PUT_IN, learned).cost(learned, borne=True)
    assert told.count(f">{cost}<") == 2


def test_plan_on_pairs_tells_what_is_carried_to_places_too():
    learned, scene = toy_relations.grounding(), toy_relations.tower_at_place()
    steps = named_steps(plan(scene, learned).steps)
    told = plan_table(
        PlanRecord(scene.name, "fast-downward", PlanStatus.SOLVED, steps, 0.1, ""), scene, learned
    )
    assert "carries it to " in told
    assert told.count("puts it ") == 2


def test_run_on_pairs_is_told_with_states_seen_from_the_other_object():
    learned, scene = toy_relations.grounding(), toy_relations.tower()
    run = execute(toy_relations.WORLD, scene, learned, plan(scene, learned).steps)
    told = run_table(run.steps)
    assert told.count(REST) == 4  # promised and happened, twice
    assert "50 mm up from item-02" in told
    assert "item-03 item-02" in told


def test_goals_by_relation_are_listed_in_words():
    assert words.relation_list([]) == ""
    assert f"Goal: item-01 {REST} item-03" in words.relation_list(toy_relations.tower().related)
    assert "<img" not in words.relation_list([(EVIL, EVIL, EVIL)])


def test_every_step_of_a_run_is_told_with_its_promise():
    told = run_table(RUN.steps)
    assert told.count("as promised") == sum(step.as_promised for step in RUN.steps)
    assert "held" in told
    assert "goal reached" in run_summary(RUN)


def test_bit_that_is_near_its_flip_has_another_colour():
    assert "#e08a00" in bits_row("1", [0.5])
    assert "#e08a00" not in bits_row("1", [9.0])
    assert "bit 2" in bits_row("10", [])
