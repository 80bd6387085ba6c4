"""The studio in a real browser: what is dragged, planned, run, nudged and taken away there.

Skipped where no Chromium is at hand. Each test has a page of its own on one studio. The first goes the whole
way; the others take minutes where a browser draws in software, and are run by `make evaluate`.
"""

from collections.abc import Iterator

import numpy as np
import pytest
from studio_pages import chromium, shipped_library

from neurosym.planners import PlanStatus
from neurosym.studio.server import Studio
from tools.benchmarks.studio.browser import FLAGS, SLOW, Window

pytestmark = pytest.mark.filterwarnings("ignore::DeprecationWarning")


@pytest.fixture(scope="module")
def browser():
    with chromium(*FLAGS) as opened:
        yield opened


@pytest.fixture(scope="module")
def studio() -> Iterator[Studio]:
    library = shipped_library()
    opened = Studio(library, problem=library.load_problem("task-02"))
    opened.start()
    yield opened
    opened.close()


@pytest.fixture
def window(studio, browser) -> Iterator[Window]:
    opened = Window(browser, studio)
    yield opened
    opened.context.close()
    assert opened.errors == []


def test_goal_is_dragged_planned_to_and_run(window):
    session = window.page.session
    name, there = "item-01", (0.55, 0.1)
    height = window.knob(name)[2]
    for _ in range(3):  # drawn in software, a page may miss the end of a motion of the mouse
        window.drag(window.knob(name), (*there, height))
        goal = session.problem.goals[name]
        if is_near := bool(np.hypot(goal[0] - there[0], goal[1] - there[1]) < 0.01):
            break
    assert is_near
    session.aim(name, *goal[:2], session.problem.object_named(name).position[2])
    window.open("Plan")
    window.press("Plan")
    window.wait(lambda: session.plans and not session.planning)
    window.tab.get_by_text("found a plan of").wait_for(timeout=1000 * SLOW)
    window.open("Run")
    window.press("Run")
    window.wait(lambda: window.page.drawn > 20)
    window.wait(lambda: not session.running.is_active)
    window.tab.get_by_text("promised", exact=True).wait_for(timeout=1000 * SLOW)
    assert window.asked
    assert [
        url for url in window.asked if "//127.0.0.1:" not in url and not url.startswith(("data:", "blob:"))
    ] == []


@pytest.mark.evaluation
def test_keyboard_reaches_every_panel_and_number(window):
    window.open("Table")
    window.tab.get_by_role("tab", name="Table").focus()
    for label in ("Plan", "Run", "Symbols", "Tour"):
        window.tab.keyboard.press("ArrowRight")
        assert window.tab.get_by_role("tab", name=label, exact=True).get_attribute("aria-selected") == "true"
    window.open("Table")
    field = window.tab.get_by_label("Stands at x, y").first
    field.focus()
    before = window.page.session.problem.objects[0].position
    window.tab.keyboard.press("ArrowUp")
    window.wait(lambda: window.page.session.problem.objects[0].position != before)


@pytest.mark.evaluation
def test_nearest_goals_are_accepted_with_one_click(window):
    session = window.page.session
    session.aim("item-01", 0.6, 0.1, 0.45)  # higher than anything is lifted
    window.open("Plan")
    window.press("Plan")
    window.wait(lambda: session.plans and not session.planning)
    assert session.plan_shown.record.status is PlanStatus.NEAREST, session.word.text
    window.press("Accept the nearest goals")
    window.wait(lambda: session.plans and not session.planning and session.plan_shown.record.solved)
