"""What a page does, without a browser: set the table, plan, run, nudge, stop, and take everything away."""

import asyncio
import shutil
import time
from pathlib import Path
from types import SimpleNamespace

import msgspec
import numpy as np
import pytest
from command_line import neurosym
from places import ROOT, SHIPPED
from studio_pages import (
    page_on,
    planned,
    ran,
    relations_library,
    session_on,
    shipped_library,
    toy_library,
    wait_for,
)
from toy_relations import LIE, REST, scene, sorting, tower, tower_at_place

from neurosym.planners import PlanStatus
from neurosym.problems import Problem
from neurosym.studio.messages import Controls, Planned, Ran, Seen, Word
from neurosym.studio.page import Page
from neurosym.studio.scene_editor import with_goal
from neurosym.studio.session import furnished_room
from neurosym.studio.studio_workers import DIED, STOPPED, Workers, draw, plan, run

CUBE = (0.05, 0.05, 0.05, 0.0)
PLAIN = Problem(
    "plain",
    scene(("cube", 0.5, -0.2), ("block", 0.6, 0.1), ("tray", 0.8, -0.1), ("cube", 0.8, 0.2)),
    {},
    0.02,
)


@pytest.fixture
def toy(tmp_path: Path, both):
    with session_on(toy_library(tmp_path / "toy"), both) as session:
        yield session


@pytest.fixture(scope="module")
def tabletop(both):
    """The shipped domain; each test puts on the table what it needs."""
    with session_on(shipped_library(), both) as session:
        yield session


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
    toy.plan("no-such-planner")
    wait_for(lambda: not toy.planning)
    assert toy.word.is_bad
    assert "no-such-planner" in toy.word.text
    toy.remove_goal("item-01")
    toy.plan("counting")
    assert "No object has a goal" in toy.word.text
    assert not toy.planning


def test_objects_are_added_where_there_is_room_and_taken_away(toy):
    while len(toy.problem.objects) < 8:
        toy.add(CUBE)
    assert toy.complaints() == {}
    toy.add(CUBE)
    assert (len(toy.problem.objects), toy.word.is_bad) == (8, True)
    toy.resize("item-01", (0.06, 0.05, 0.05, 0.0))  # without a network, it is of the likest category
    assert toy.problem.object_named("item-01").category == "00"
    assert toy.library.margins(toy.problem.objects[0].features) == ()
    assert "effect_model" in toy.library.damage[0]


def test_plans_of_two_planners_are_kept_until_the_table_changes_and_one_is_run(toy):
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
    record = toy.running.run.steps[-1]
    fell = msgspec.structs.replace(record, positions={**record.positions, "item-01": (1.2, 0.4, -0.3)})
    lost = msgspec.structs.replace(toy.running.run, steps=(*toy.running.run.steps[:-1], fell), ended="lost")
    toy.running._end(Ran(lost))  # it is asked for no step after that, and lies where it fell to
    assert toy.running.as_it_stands().object_named("item-01").position == (1.2, 0.4, -0.3)
    topics = []
    toy.listen(topics.append)
    toy.aim("item-01", 0.6, 0.08)
    assert (toy.plans, toy.running.run) == ({}, None)
    assert {"place", "plan", "run"} <= set(topics)


def waiting(session):
    """Begin a run that waits before its first step."""
    planned(session, "counting")
    session.running.steer(speed=0.0, is_paused=True)
    session.running.begin()
    wait_for(lambda: session.running.moment)
    return session


def test_goal_out_of_reach_can_be_exchanged_for_the_nearest(toy):
    toy.aim("item-01", 0.45, 0.0)
    planned(toy, "counting")
    assert toy.plan_shown.record.status is not PlanStatus.SOLVED
    toy.aim("item-01", 0.665, 0.16)
    toy.set_tolerance(0.01)
    planned(toy, "counting")
    assert toy.plan_shown.record.status is PlanStatus.NEAREST
    toy.accept_nearest()
    wait_for(lambda: not toy.planning and toy.plans)
    assert toy.plan_shown.record.status is PlanStatus.SOLVED
    assert toy.problem.goals["item-01"] == pytest.approx((0.68, 0.16, 0.025), abs=1e-6)


def test_nudge_during_a_run_calls_for_a_new_plan_with_its_reason(toy):
    waiting(toy)
    toy.move("item-01", 0.6, -0.08)
    wait_for(lambda: toy.running.moment.scene.positions[0, 1] < 0)
    assert toy.running.replannings == []
    toy.running.steer(is_paused=False)
    wait_for(lambda: not toy.running.is_active)
    run = toy.running.run
    assert run.reached
    assert [(nudge.before_step, nudge.object) for nudge in run.nudges] == [(1, "item-01")]
    assert "item-01" in toy.running.replannings[0].why


def test_run_goes_step_by_step_and_the_table_is_not_set_meanwhile(toy):
    before = waiting(toy).problem
    toy.aim("item-01", 0.5, 0.0)
    toy.add(CUBE)
    toy.move("item-01", 5.0, 0.0)
    assert "off the table" in toy.word.text
    assert (toy.problem, toy.running.records) == (before, [])
    toy.running.steer(is_paused=True, one_step=True)
    wait_for(lambda: len(toy.running.records) == 1)
    toy.running.stop()
    wait_for(lambda: not toy.running.is_active)
    assert (toy.running.run.ended, len(toy.running.run.steps)) == ("stopped", 1)


def test_planner_that_is_stopped_gives_way_to_the_next(tabletop):
    tabletop.load("task-20")
    tabletop.plan("bfs-operators")
    wait_for(lambda: tabletop.planning is None or tabletop.planning.process)
    tabletop.stop_planning()
    wait_for(lambda: not tabletop.planning)
    tabletop.load("task-02")
    planned(tabletop, "fast-downward")
    assert tabletop.plan_shown.plan_file


def test_record_is_byte_for_byte_what_the_command_line_writes(tabletop, tmp_path, monkeypatch):
    before = {path: path.stat().st_mtime_ns for path in SHIPPED.rglob("*")}
    monkeypatch.chdir(tmp_path)
    name = "task-02"
    assert neurosym("plan", "tabletop", name) in (0, 3)
    plan, run = f"plans/{name}.fast-downward.plan", f"runs/{name}.fast-downward.run.json"
    assert neurosym("execute", "tabletop", name, f"tabletop/{plan}") in (0, 3)
    tabletop.load(name)
    tabletop.save()
    assert "never written into" in tabletop.word.text
    planned(tabletop, "fast-downward")
    assert tabletop.plan_shown.plan_file == plan
    ran(tabletop)
    assert tabletop.running.seen
    for file in (plan, run):
        assert (tabletop.room / file).read_bytes() == (tmp_path / "tabletop" / file).read_bytes()
    assert {path: path.stat().st_mtime_ns for path in SHIPPED.rglob("*")} == before


@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_tries_are_counted_and_an_effect_stays_until_the_table_is_asked_for(both):
    with session_on(shipped_library(), both) as session, page_on(session) as page:
        tabletop, running, name = page.session, page.session.running, "item-01"
        tabletop.load("task-15")
        running.steer(speed=0.0)
        running.try_ten(name, tabletop.unsure(name).operator.name)
        wait_for(lambda: not running.is_active)
        kept = sum(one.keeps(running.promise) for one in running.tries)
        assert len({one.start for one in running.tries}) == 10
        assert f": {kept} of 10 as promised; promised " in tabletop.word.text
        before = tabletop.problem.object_named(name).position
        surest = tabletop.promises(name)[0]
        running.perform(name, tabletop.library.grounding.primitive_of(surest.operator).action)
        wait_for(lambda: not running.is_active)
        (tried,) = running.tries
        assert tried.keeps(surest)
        wait_for(lambda: page.view.at(name) == pytest.approx(tried.end, abs=1e-3))
        tabletop.reset()
        wait_for(lambda: page.view.at(name) == pytest.approx(before, abs=1e-3))
        assert not running.has_ended
        category = tabletop.problem.object_named(name).category
        body = page.view._objects[name].nodes[0]
        assert tuple(body.color) == page.view.palette(category)


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
        wait_for(lambda: not session.planning)
        assert session.problem == Problem.load(tmp_path / "towers" / "problems" / f"{name}.scene.json")
        session.draw(9, 4, "tower")
        assert "valid: 1 to 8" in session.word.text


def test_whoever_sees_that_something_is_over_reads_what_came_of_it(tabletop, monkeypatch):
    say = tabletop.say

    def say_late(*word: object) -> None:
        time.sleep(0.2)
        say(*word)

    monkeypatch.setattr(tabletop, "say", say_late)
    tabletop.running.steer(speed=0.0)
    tabletop.draw(1, 4, None)
    wait_for(lambda: not tabletop.planning)
    assert tabletop.word.text == "a task with 1 object is on the table"
    (name,) = tabletop.problem.object_names
    tabletop.running.try_ten(name, tabletop.unsure(name).operator.name)
    wait_for(lambda: not tabletop.running.is_active)
    assert " of 10 as promised; promised " in tabletop.word.text


def test_run_is_replayed_on_the_page(tabletop):
    running = tabletop.running
    running.steer(speed=0.0)
    running.replay("task-03.fast-downward")
    wait_for(lambda: not running.is_active)
    assert "; the record says the same" in tabletop.word.text
    assert running.seen


def test_scene_is_saved_opened_or_refused_and_a_closed_page_leaves_nothing_behind(tmp_path, both):
    with session_on(toy_library(tmp_path / "toy"), both) as toy:
        toy.aim("item-01", 0.6, 0.24)
        toy.rename("further")
        toy.save()
        assert toy.library.load_problem("further").goals == toy.problem.goals
        other = with_goal(toy.problem, "item-02", 0.5, -0.2)
        toy.open_file(msgspec.json.encode(other))
        assert toy.problem == other
        for content in (b"", b"{}", b"\xff" * 50, b"[" * 10_000, b" " * 2_000_000):
            toy.open_file(content)
            assert toy.word.is_bad
            assert toy.problem == other
        room = toy.room
        assert room.is_dir()
    assert not room.exists()


# In domains with relations and with places: ghosts are dropped on objects


@pytest.fixture
def stacks(tmp_path: Path, both):
    library = relations_library(tmp_path / "stacks", sorting(), tower(), tower_at_place())
    with session_on(library, both) as session:
        session.put(PLAIN)
        yield session


def test_goal_by_relation_is_chosen_without_a_mouse_kept_and_removed(stacks):
    goal = stacks.goals_for("item-01")[0]
    stacks.relate(*goal)
    stacks.relate("item-02", "item-01", REST)
    assert "circle" in stacks.word.text
    assert stacks.problem.relations == (goal,)
    content = msgspec.json.encode(stacks.problem)
    stacks.rename("kept")
    stacks.save()
    for bring in (lambda: stacks.load("kept"), lambda: stacks.open_file(content)):
        stacks.put(PLAIN)
        bring()
        assert stacks.problem.relations == (goal,)
    stacks.remove("item-02")  # which it is about
    assert stacks.problem.relations == ()


def test_goals_are_chosen_for_what_is_asked_in_words_and_are_by_hand_once_moved(stacks):
    stacks.ask("item-01 x=0.7.. and item-02 next-to item-01")
    assert stacks.word.text == "goals for: item-01 x=0.7.. and item-02 next-to item-01"
    assert {*stacks.problem.goals} == {"item-01", "item-02"}
    stacks.ask("item-01 beyond item-02")
    assert stacks.word.is_bad
    assert stacks.problem.conditions == ("item-01 x=0.7.. and item-02 next-to item-01",)
    stacks.aim("item-01", 0.5, 0.1)
    assert stacks.problem.conditions == ()
    stacks.ask("item-01 y=0..")
    stacks.remove("item-01")
    assert (stacks.problem.conditions, stacks.problem.goals) == ((), {})


def test_objects_are_dragged_with_what_they_bear_and_down_from_what_bears_them(stacks):
    stacks.load("sorting")
    stacks.move("item-03", 0.5, -0.1)
    assert [item.position[:2] for item in stacks.problem.objects[:3]] == [(0.5, -0.1)] * 3
    stacks.move("item-02", 0.6, 0.2)
    assert stacks.problem.object_named("item-02").position == (0.6, 0.2, 0.025)
    assert stacks.problem.object_named("item-01").position == (0.6, 0.2, 0.075)
    before = stacks.problem
    stacks.remove("item-02")
    assert stacks.word.text == "item-02 bears item-01; drag that away first."
    stacks.resize("item-02", (0.06, 0.06, 0.06, 0.0))
    assert stacks.problem == before
    stacks.resize("item-01", (0.05, 0.05, 0.03, 0.0))
    assert stacks.problem.object_named("item-01").position == pytest.approx((0.6, 0.2, 0.065))
    assert stacks.complaints() == {}


def test_goals_by_relation_are_planned_for_and_reached(stacks):
    stacks.load("tower-at-place")
    planned(stacks, "fast-downward")
    assert stacks.plan_shown.record.status is PlanStatus.SOLVED, stacks.word.text
    ran(stacks)
    assert stacks.running.run.reached, stacks.running.run.reason
    assert stacks.running.run.unmet == ()


@pytest.fixture
def page(stacks):
    with page_on(stacks) as opened:
        yield opened


def drag(page: Page, name: str, *to: tuple[float, float]) -> None:
    """Drag the ghost of an object by what is on the table below its knob, as a window tells it."""
    x, y, _ = page.session.ghosts()[name]
    camera, hear = SimpleNamespace(position=np.array([x, y, 2.0])), page._grabbed("goal", name)
    phases = ["start", *["update"] * (len(to) - 1), "end"]
    for phase, at in zip(phases, [(x, y), *to], strict=True):
        event = SimpleNamespace(client=SimpleNamespace(camera=camera), phase=phase)
        event.start_position, event.end_position = (x, y, 0.0), (*at, 0.0)
        asyncio.run(hear(event))


@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_ghost_is_dragged_from_the_table_onto_an_object_and_off_again(page):
    session = page.session
    session.add_goal("item-01")
    drag(page, "item-01", (0.55, 0.15), (0.61, 0.1))
    assert session.problem.relations == (("item-01", "item-02", REST),)
    assert session.problem.goals == {}
    assert session.word.text == "goal: item-01 on item-02"
    assert session.ghosts()["item-01"] == pytest.approx((0.6, 0.1, 0.075))
    session.add_goal("item-04")
    drag(page, "item-04", (0.65, 0.15), (0.6, 0.1))  # the ghost of item-01 is uppermost there
    assert session.problem.relations[1] == ("item-04", "item-01", REST)
    assert session.complaints() == {}
    session.remove_goal("item-04")
    drag(page, "item-01", (0.7, 0.1), (0.8, -0.1))
    assert session.problem.relations == (("item-01", "item-03", LIE),)
    drag(page, "item-01", (0.7, 0.05), (0.5, 0.2))
    assert session.problem.relations == ()
    assert session.problem.goals["item-01"] == pytest.approx((0.5, 0.2, 0.025))


@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_drop_that_nothing_leads_to_is_said_and_the_goal_is_as_before(page):
    session = page.session
    session.aim("item-03", 0.8, 0.05)
    before = session.problem
    drag(page, "item-03", (0.7, 0.1), (0.6, 0.1))
    assert session.problem == before
    assert session.word == (
        "nothing puts item-03 on or into item-02; nothing puts item-03 on or into any other object.",
        True,
    )
    session.put(PLAIN)
    session.relate("item-01", "item-02", REST)
    session.aim("item-02", 0.5, 0.2)
    drag(page, "item-02", (0.5, 0.0), (0.5, -0.2))  # on what shall rest on it
    assert session.problem.goals["item-02"] == pytest.approx((0.5, -0.2, 0.025))


# Work waits in line, shows its place, is stopped, and a process that dies takes only its own with it


@pytest.fixture
def library(tmp_path):
    return toy_library(tmp_path / "toy")


@pytest.fixture
def room(library):
    made = furnished_room(library.folder)
    yield made
    shutil.rmtree(made)


@pytest.fixture
def one_worker():
    made = Workers(1)
    yield made
    made.close()


def test_line_shows_places_and_gives_up_what_is_stopped(library, room, one_worker):
    said, given = [[] for _ in range(3)], (library.first_problem, "counting", False)
    tickets = [one_worker.submit(heard.append, plan, room, *given) for heard in said]
    assert [ticket.place for ticket in tickets] == [0, 1, 2]
    tickets[1].stop()
    assert said[1] == [Word(STOPPED, is_bad=True)]
    assert tickets[2].place <= 1
    wait_for(lambda: said[0] and said[2])
    assert isinstance(said[2][-1], Planned)


def test_crash_is_told_of_its_run_only_and_a_room_is_written_alone(one_worker):
    library, said, name = shipped_library(), [], "task-03"
    room = furnished_room(library.folder)
    try:
        assert (room / "domain.pddl").read_bytes() == (library.folder / "domain.pddl").read_bytes()
        assert (room / "problems" / "task-01.scene.json").is_symlink()
        assert not (room / "interactions.npz").exists()
        given = name, f"plans/{name}.fast-downward.plan", "fast-downward", 0, Controls(0.05)
        ticket = one_worker.submit(said.append, run, room, *given)
        wait_for(lambda: any(isinstance(one, Seen) for one in said))
        ticket._child.process.kill()
        wait_for(lambda: said[-1] == Word(DIED, is_bad=True))
        one_worker.submit(said.append, draw, room, "drawn", 1, 0, None)
        wait_for(lambda: getattr(said[-1], "name", "") == "drawn")
    finally:
        shutil.rmtree(room)
    assert (library.folder / "domain.pddl").is_file()
