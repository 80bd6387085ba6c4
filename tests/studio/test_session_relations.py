"""A page on domains with relations and with places, without a browser: drop ghosts, plan, run, take away."""

import asyncio
from pathlib import Path
from types import SimpleNamespace

import msgspec
import numpy as np
import pytest
import viser
from places import ROOT
from studio_pages import planned, ran, relations_library, session_on, shipped_library, workers
from toy_relations import LIE, REST, scene, sorting, tower, tower_at_place

from neurosym.planners import PlanStatus
from neurosym.problems import Problem
from neurosym.studio.page import Page

PLAIN = Problem(
    "plain",
    scene(("cube", 0.5, -0.2), ("block", 0.6, 0.1), ("tray", 0.8, -0.1), ("cube", 0.8, 0.2)),
    {},
    0.02,
)


@pytest.fixture(scope="module")
def both():
    with workers() as started:
        yield started


@pytest.fixture
def stacks(tmp_path: Path, both):
    library = relations_library(tmp_path / "stacks", sorting(), tower(), tower_at_place())
    with session_on(library, both) as session:
        session.put(PLAIN)
        yield session


def dropped(session, name: str, x: float, y: float) -> None:
    """Drag the ghost of an object in two motions, as a page does."""
    before = session.problem
    session.aim(name, (x + 0.5) / 2, y / 2)
    session.aim(name, x, y)
    session.drop_goal(name, before)


def test_ghost_that_is_dropped_on_an_object_becomes_a_goal_by_relation(stacks):
    stacks.add_goal("item-01")
    dropped(stacks, "item-01", 0.61, 0.1)
    assert stacks.problem.related == (("item-01", "item-02", REST),)
    assert stacks.problem.goals == {}
    assert stacks.word.text == f"goal: item-01 {REST} item-02"
    assert stacks.ghosts()["item-01"] == pytest.approx((0.6, 0.1, 0.075))
    stacks.add_goal("item-04")
    dropped(stacks, "item-04", 0.6, 0.1)  # the ghost of item-01 is uppermost there
    assert stacks.problem.related[1] == ("item-04", "item-01", REST)
    assert stacks.complaints() == {}


def test_drop_that_nothing_leads_to_is_said_and_the_goal_is_as_before(stacks):
    stacks.aim("item-01", 0.5, 0.2)
    dropped(stacks, "item-03", 0.6, 0.1)  # had no goal
    assert list(stacks.problem.goals) == ["item-01"]
    stacks.aim("item-03", 0.8, 0.1)
    before = stacks.problem
    dropped(stacks, "item-03", 0.6, 0.1)
    assert stacks.problem == before
    assert stacks.word.is_bad
    assert stacks.word.text == (
        "nothing puts item-03 on or into item-02; nothing puts item-03 on or into any other object."
    )
    stacks.relate("item-01", "item-02", REST)
    stacks.aim("item-02", 0.5, 0.2)
    dropped(stacks, "item-02", 0.5, -0.2)  # on what shall rest on it
    assert stacks.problem.goals["item-02"] == pytest.approx((0.5, -0.2, 0.025))


def test_goal_by_relation_is_chosen_without_a_mouse_kept_and_removed(stacks):
    goal = stacks.goals_for("item-01")[0]
    stacks.relate(*goal)
    for wrong, said in (
        (("item-02", "item-01", REST), "circle"),
        (("item-03", "item-01", REST), "nothing puts item-03"),
    ):
        stacks.relate(*wrong)
        assert said in stacks.word.text
        assert stacks.problem.related == (goal,)
    content = msgspec.json.encode(stacks.problem)
    stacks.rename("kept")
    stacks.save()
    for bring in (lambda: stacks.load("kept"), lambda: stacks.open_file(content)):
        stacks.put(PLAIN)
        bring()
        assert stacks.problem.related == (goal,)
    stacks.remove("item-02")  # which it is about
    assert stacks.problem.related == ()
    stacks.relate("item-01", "item-03", LIE)
    stacks.resize("item-03", (0.05, 0.05, 0.05, 0.0))  # no tray any more
    assert "no operator brings item-01" in stacks.complaints()["goal item-01"]
    stacks.remove_goal("item-01")
    assert stacks.problem.related == ()


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


@pytest.mark.parametrize("name", ["tower-at-place", "sorting", "dropped"])
def test_goals_by_relation_are_planned_for_and_reached(stacks, name):
    if name == "dropped":
        stacks.aim("item-02", 0.5, -0.2)
        dropped(stacks, "item-01", 0.5, -0.21)
        assert stacks.problem.related == (("item-01", "item-02", REST),)
    else:
        stacks.load(name)
    planned(stacks, "fast-downward")
    assert stacks.plan_shown.record.status is PlanStatus.SOLVED, stacks.word.text
    ran(stacks)
    assert stacks.running.run.reached, stacks.running.run.reason
    assert stacks.running.run.unmet == ()


@pytest.fixture
def page(stacks):
    """A page that nobody looks at."""
    server = viser.ViserServer("127.0.0.1", 0, verbose=False)
    opened = Page(server, stacks)
    yield opened
    opened.close()
    server.stop()


def drag(page: Page, name: str, *to: tuple[float, float]) -> None:
    """Drag the ghost of an object by what is on the table below its knob, as a window tells it."""
    x, y, _ = page.session.ghosts()[name]
    camera = SimpleNamespace(position=np.array([x, y, 2.0]))
    hear = page._grabbed("goal", name)
    phases = ["start", *["update"] * (len(to) - 1), "end"]
    for phase, at in zip(phases, [(x, y), *to], strict=True):
        event = SimpleNamespace(
            client=SimpleNamespace(camera=camera),
            phase=phase,
            start_position=(x, y, 0.0),
            end_position=(*at, 0.0),
        )
        asyncio.run(hear(event))


@pytest.mark.filterwarnings("ignore::DeprecationWarning")
def test_ghost_is_dragged_from_the_table_onto_an_object_and_off_again(page):
    session = page.session
    session.aim("item-01", 0.5, 0.2)
    drag(page, "item-01", (0.55, 0.15), (0.6, 0.1))
    assert session.problem.related == (("item-01", "item-02", REST),)
    drag(page, "item-01", (0.7, 0.1), (0.8, -0.1))
    assert session.problem.related == (("item-01", "item-03", LIE),)
    drag(page, "item-01", (0.7, 0.05), (0.5, 0.2))
    assert session.problem.related == ()
    assert session.problem.goals["item-01"] == pytest.approx((0.5, 0.2, 0.025))
    session.aim("item-03", 0.8, 0.05)
    before = session.problem
    drag(page, "item-03", (0.7, 0.1), (0.6, 0.1))
    assert session.word.is_bad
    assert session.problem == before


def test_domain_with_places_is_planned_in_and_run(both):
    with session_on(shipped_library(ROOT / "domains" / "places"), both) as session:
        session.load("anywhere-1-01")
        assert session.goals_for("item-01") == ()
        assert session.complaints() == {}
        planned(session, "fast-downward")
        assert session.plan_shown.record.status is PlanStatus.SOLVED
        assert session.plan_shown.record.steps[0][2]
        ran(session)
        assert session.running.run.reached, session.running.run.reason
        assert session.running.seen
