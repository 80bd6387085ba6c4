"""What a page does, without a browser: set the table, plan, run, nudge, stop, and take everything away."""

from pathlib import Path

import msgspec
import pytest
from command_line import neurosym
from places import ROOT, SHIPPED
from studio_pages import planned, ran, session_on, shipped_library, toy_library, wait_for, workers

from neurosym.planners import PlanStatus
from neurosym.problems import Problem
from neurosym.studio import scene_editor
from neurosym.studio.desk import promises_for


@pytest.fixture(scope="module")
def both():
    with workers() as started:
        yield started


@pytest.fixture
def toy(tmp_path: Path, both):
    with session_on(toy_library(tmp_path / "toy"), both) as session:
        yield session


@pytest.fixture(scope="module")
def tabletop(both):
    """The shipped domain; each test puts on the table what it needs."""
    with session_on(shipped_library(), both) as session:
        yield session


def test_change_of_the_table_is_told_and_what_was_planned_is_forgotten(toy):
    planned(toy, "counting")
    topics = []
    toy.listen(topics.append)
    toy.aim("item-01", 0.6, 0.08)
    assert toy.plans == {}
    assert {"place", "plan"} <= set(topics)


def test_what_cannot_be_done_is_said_and_changes_nothing(toy):
    before = toy.problem
    toy.load("no-such-problem")
    assert toy.word.is_bad
    toy.resize("item-01", (9.0, 0.05, 0.05, 0.0))
    assert "9 m" in toy.word.text
    toy.rename("<script>")
    assert toy.problem == before
    assert toy.complaints() == {}
    toy.aim("item-01", 0.6, 0.4)
    assert toy.complaints() == {"goal item-01": "the goal of item-01 is off the table"}
    toy.aim("item-01", 0.8, 0.1)
    assert "knows no goals like item-01 on item-02" in toy.complaints()["goal item-01"]


def test_objects_are_added_where_there_is_room_and_taken_away(toy):
    while len(toy.problem.objects) < 8:
        toy.add((0.05, 0.05, 0.05, 0.0))
    assert toy.complaints() == {}
    toy.add((0.05, 0.05, 0.05, 0.0))
    assert (len(toy.problem.objects), toy.word.is_bad) == (8, True)
    toy.remove("item-03")
    assert "item-03" not in toy.problem.object_names


def test_object_without_a_network_is_of_the_likest_category(toy):
    toy.resize("item-01", (0.06, 0.05, 0.05, 0.0))
    assert toy.problem.object_named("item-01").category == "00"
    assert toy.library.margins((0.06, 0.05, 0.05, 0.0)) == ()
    assert "effect_model" in toy.library.damage[0]


def test_plans_of_two_planners_are_kept_beside_each_other_and_one_is_run(toy):
    planned(toy, "counting")
    planned(toy, "fast-downward")
    assert list(toy.plans) == ["counting", "fast-downward"]
    assert toy.plan_shown.record.planner == "fast-downward"
    toy.choose("counting")
    assert toy.plan_shown.record.planner == "counting"
    assert toy.plan_shown.record.status is PlanStatus.SOLVED
    ran(toy)
    assert toy.running.run.reached
    assert [record.as_promised for record in toy.running.records] == [True, True]
    assert not toy.word.is_bad


def test_what_cannot_be_planned_is_said(toy):
    toy.plan("no-such-planner")
    wait_for(lambda: not toy.is_planning)
    assert toy.word.is_bad
    assert "no-such-planner" in toy.word.text
    toy.remove_goal("item-01")
    toy.plan("counting")
    assert "No object has a goal" in toy.word.text
    assert not toy.is_planning


def waiting(session):
    """Begin a run that waits before its first step."""
    planned(session, "counting")
    session.running.set_speed(0.0)
    session.running.pause()
    session.running.begin()
    wait_for(lambda: session.running.number == 1)
    return session


def test_goal_out_of_reach_can_be_exchanged_for_the_nearest(toy):
    toy.aim("item-01", 0.45, 0.0)
    planned(toy, "counting")
    shown = toy.plan_shown
    assert shown.record.status is not PlanStatus.SOLVED
    toy.aim("item-01", 0.665, 0.16)
    toy.set_tolerance(0.01)
    planned(toy, "counting")
    assert toy.plan_shown.record.status is PlanStatus.NEAREST
    toy.accept_nearest()
    wait_for(lambda: not toy.is_planning and toy.plans)
    assert toy.plan_shown.record.status is PlanStatus.SOLVED
    assert toy.problem.goals["item-01"] == pytest.approx((0.68, 0.16, 0.025), abs=1e-6)


def test_nudge_during_a_run_calls_for_a_new_plan_with_its_reason(toy):
    waiting(toy)
    toy.move("item-01", 0.6, -0.08)
    wait_for(lambda: toy.running.rest.positions[0, 1] < 0)
    assert toy.running.replannings == []
    toy.running.resume()
    wait_for(lambda: not toy.running.is_active)
    run = toy.running.run
    assert run.reached
    assert [(nudge.before_step, nudge.object) for nudge in run.nudges] == [(1, "item-01")]
    assert "item-01" in toy.running.replannings[0].why


def test_run_goes_step_by_step_and_the_table_is_not_set_meanwhile(toy):
    before = waiting(toy).problem
    toy.aim("item-01", 0.5, 0.0)
    toy.add((0.05, 0.05, 0.05, 0.0))
    toy.move("item-01", 5.0, 0.0)
    assert "off the table" in toy.word.text
    assert (toy.problem, toy.running.records) == (before, [])
    toy.running.one_step()
    wait_for(lambda: len(toy.running.records) == 1)
    toy.running.stop()
    wait_for(lambda: not toy.running.is_active)
    assert (toy.running.run.ended, len(toy.running.run.steps)) == ("stopped", 1)


def test_planner_that_is_stopped_gives_way_to_the_next(tabletop):
    tabletop.load("task-20")
    tabletop.plan("bfs-operators")
    wait_for(lambda: tabletop._planning is None or tabletop._planning._child is not None)
    tabletop.stop_planning()
    wait_for(lambda: not tabletop.is_planning)
    tabletop.load("task-02")
    planned(tabletop, "fast-downward")
    assert tabletop.plan_shown.plan_file


def test_record_is_byte_for_byte_what_the_command_line_writes(tabletop, tmp_path, monkeypatch):
    before = {path: path.stat().st_mtime_ns for path in SHIPPED.rglob("*")}
    monkeypatch.chdir(tmp_path)
    name = "task-02"
    assert neurosym("plan", "tabletop", name) in (0, 3)
    plan = f"tabletop/plans/{name}.fast-downward.plan"
    assert neurosym("execute", "tabletop", name, plan) in (0, 3)
    tabletop.load(name)
    tabletop.save()
    assert "never written into" in tabletop.word.text
    planned(tabletop, "fast-downward")
    assert (tabletop.room.path / tabletop.plan_shown.plan_file).read_text() == Path(plan).read_text()
    ran(tabletop)
    assert tabletop.running.seen
    record = (tabletop.room.path / tabletop.running.file).read_bytes()
    assert record == (tmp_path / f"tabletop/runs/{name}.fast-downward.run.json").read_bytes()
    assert {path: path.stat().st_mtime_ns for path in SHIPPED.rglob("*")} == before


def test_margins_say_on_which_side_of_its_flip_each_bit_is(tabletop):
    for item in tabletop.library.load_problem("task-20").objects:
        margins = tabletop.library.margins(item.features)
        assert "".join("1" if margin > 0 else "0" for margin in margins) == item.category


def test_tasks_are_drawn_as_the_command_line_draws_them(both, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    name = "drawn-tower-3-4"
    asked = ("--name", name, "--objects", 3, "--seed", 4, "--task", "tower")
    assert neurosym("new-problem", "towers", *asked) == 0
    with session_on(shipped_library(ROOT / "domains" / "towers"), both) as session:
        session.draw(3, 4, "tower")
        wait_for(lambda: session.problem.name == name)
        assert session.problem == Problem.load(tmp_path / "towers" / "problems" / f"{name}.scene.json")
        session.draw(9, 4, "tower")
        assert "valid: 1 to 8" in session.word.text


def test_motions_and_interactions_and_runs_happen_on_the_page(tabletop):
    running = tabletop.running
    running.set_speed(0.0)
    running.replay("task-03.fast-downward")
    wait_for(lambda: not running.is_active)
    assert running.course in ("same bytes", "within rounding")
    assert running.seen
    tabletop.load("task-02")
    item = tabletop.problem.objects[0]
    promise = next(one for one in promises_for(item, tabletop.library) if one.lifts)
    running.perform(item.name, tabletop.library.grounding.primitive_of(promise.operator).action)
    wait_for(lambda: not running.is_active)
    assert running.outcome.kind == "held"
    running.recall(int(tabletop.library.interactions.held.argmax()))
    wait_for(lambda: not running.is_active)
    assert running.outcome.kind == "held"
    assert tabletop.word.text.startswith("it ended held: ")
    assert "; the effect is" in tabletop.word.text


def test_scene_is_saved_opened_or_refused_and_a_closed_page_leaves_nothing_behind(tmp_path, both):
    with session_on(toy_library(tmp_path / "toy"), both) as toy:
        toy.aim("item-01", 0.6, 0.24)
        toy.rename("further")
        toy.save()
        assert toy.library.load_problem("further").goals == toy.problem.goals
        other = scene_editor.with_goal(toy.problem, "item-02", 0.5, -0.2)
        toy.open_file(msgspec.json.encode(other))
        assert toy.problem == other
        for content in (b"", b"{}", b"\xff" * 50, b"[" * 10_000, b" " * 2_000_000):
            toy.open_file(content)
            assert toy.word.is_bad
            assert toy.problem == other
        room = toy.room.path
        assert room.is_dir()
    assert not room.exists()
