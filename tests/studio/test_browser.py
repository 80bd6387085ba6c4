"""The studio in a real browser: what is dragged, planned, run, nudged and taken away there.

Skipped where no Chromium is at hand. Each test has a page of its own on one studio. The first goes the whole
way; the others take minutes where a browser draws in software, and are run by `make evaluate`.
"""

import shutil
import subprocess
import sys
from collections.abc import Iterator

import numpy as np
import pytest
from places import SHIPPED
from studio_pages import chromium, shipped_library

from neurosym.files import decode_json
from neurosym.planners import PlanStatus
from neurosym.problems import Problem
from neurosym.studio.server import Studio
from tools.benchmarks.studio.browser import AXE, FLAGS, SLOW, Window
from tools.benchmarks.studio.measures import barriers

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


@pytest.fixture(params=[True])
def window(studio, browser, request) -> Iterator[Window]:
    """A window; parametrized by False, it does not draw the table, which takes long in software."""
    opened = Window(browser, studio, is_drawn=request.param)
    yield opened
    opened.context.close()
    assert opened.errors == []


undrawn = pytest.mark.parametrize("window", [False], indirect=True, ids=["undrawn"])


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
    window.tab.get_by_test_id("floating-panel").get_by_text("found a plan of").wait_for(timeout=1000 * SLOW)
    window.open("Run")
    window.press("Run")
    window.wait(lambda: window.page.drawn > 20)
    window.wait(lambda: not session.running.is_active)
    window.tab.get_by_text("promised", exact=True).wait_for(timeout=1000 * SLOW)
    assert window.asked
    assert [
        url for url in window.asked if "//127.0.0.1:" not in url and not url.startswith(("data:", "blob:"))
    ] == []


@undrawn
def test_first_visit_begins_with_the_tour_under_a_title_and_the_map_resizes_the_object(window):
    tab, page = window.tab, window.page
    assert tab.title() == "neurosym studio: tabletop"
    assert tab.get_by_role("tab", name="Tour").get_attribute("aria-selected") == "true"
    window.open("Table")
    tab.locator("svg.map circle.item").wait_for()
    dot, before = tab.locator("svg.map circle.item").bounding_box(), page.item
    x, y = dot["x"] + dot["width"] / 2, dot["y"] + dot["height"] / 2
    tab.mouse.move(x, y)
    tab.mouse.down()
    tab.mouse.move(x - 40, y + 20, steps=5)
    window.wait(lambda: page.item.features[1] < before.features[1] - 0.01)
    tab.mouse.up()
    tab.mouse.move(x, y)
    field = tab.get_by_role("textbox", name="depth [mm]")
    field.fill("5000")
    tab.get_by_text("depth [mm]: from 30 to 180").wait_for()
    assert page.item.features[0] <= 0.18
    field.fill("100")
    tab.get_by_text("depth [mm]: from 30 to 180").wait_for(state="detached")
    window.wait(lambda: page.item.features[0] == 0.1)
    assert "item-01" in tab.get_by_role("img", name="A robot's arm at a table").get_attribute("aria-label")
    window.open("Tour")
    window.press("Next card")
    category = page.item.category
    window.press("Change its width until bits flip")
    tab.locator("svg.map:visible").wait_for()
    window.wait(lambda: page.item.category != category)
    window.press("Next card")
    tab.get_by_role("table", name="objects of each category").locator("visible=true").wait_for()
    window.open("Table")
    tab.reload()
    window.await_page()
    assert tab.get_by_role("tab", name="Table").get_attribute("aria-selected") == "true"


def test_panels_of_a_small_window_are_a_sheet_of_less_than_half_under_the_table(studio, browser):
    for width, height in ((390, 844), (640, 450)):
        small = Window(browser, studio, width, height)
        canvas = small.tab.locator("canvas[data-engine]").bounding_box()
        sheet = small.tab.locator(".mantine-Paper-root", has=small.tab.get_by_role("tablist")).bounding_box()
        assert sheet["width"] == canvas["width"] == width
        assert sheet["height"] <= 0.45 * height + 1
        assert canvas["height"] == pytest.approx(sheet["y"], abs=1)
        for point in ((-0.1, 0.0, 0.0), (0.1, 0.0, 1.05), (0.95, 0.3, 0.0), (0.95, -0.3, 0.0)):
            x, y = small.pixel(point)
            assert 0 < x < width
            assert 0 < y < canvas["height"]
        assert small.errors == []
        small.context.close()


@pytest.mark.evaluation
def test_no_panel_has_a_serious_barrier(studio, browser):
    if not AXE.is_file():
        pytest.skip("npm install axe-core")
    for size in ((1400, 900), (390, 844)):
        small = Window(browser, studio, *size, is_drawn=False)
        assert barriers(small) == []
        small.context.close()


@pytest.mark.evaluation
def test_windows_and_tabs_on_one_page_see_the_same_and_a_reload_and_a_nudge_do_not_end_a_run(window, browser):
    session, tabs = window.page.session, [window.tab, window.context.new_page()]
    tabs += [browser.new_context().new_page()]
    tabs[1].goto(window.tab.url.partition("/page/")[0])  # a second tab finds the page of its browser
    tabs[2].goto(window.tab.url)  # and another student the page whose address was given away
    for tab in tabs:
        tab.bring_to_front()
        tab.locator("#cover").wait_for(state="detached", timeout=1000 * SLOW)
        tab.get_by_role("tab", name="Table", exact=True).click()
    assert tabs[1].url == window.tab.url
    tabs[2].get_by_role("textbox", name="Stands at x").fill("0.5")
    for tab in tabs:
        tab.wait_for_function("document.querySelector('[aria-label=\"Stands at x\"]').value === '0.5'")
    for tab in tabs[1:]:
        tab.close()
    session.load("task-14")
    session.plan("fast-downward")
    window.wait(lambda: session.plans and not session.planning)
    window.open("Run")
    window.press("Run")
    window.wait(lambda: session.running.moment)
    session.running.steer(is_paused=True)  # a reload takes longer than a run, where it is drawn in software
    window.tab.reload()
    window.await_page()
    window.open("Run")
    window.tab.get_by_role("button", name="Go on", exact=True).wait_for()
    name, other = session.problem.objects[0].name, session.problem.objects[2]
    assert name != other.name
    window.drag(other.position, np.add(other.position, (-0.08, 0.0, 0.0)))
    session.running.steer(is_paused=False)
    window.wait(lambda: not session.running.is_active)
    assert session.running.run.nudge.object == other.name


@pytest.mark.evaluation
def test_scene_is_taken_as_a_file_and_a_replayed_run_as_a_page(window, browser, tmp_path):
    window.open("Table")
    window.press("Save and open")
    with window.tab.expect_download() as taken:
        window.press("Take the scene as a file")
    taken.value.save_as(tmp_path / "scene.json")
    assert (
        decode_json(tmp_path, (tmp_path / "scene.json").read_bytes(), Problem) == window.page.session.problem
    )
    folder = tmp_path / "tabletop"
    shutil.copytree(SHIPPED, folder)
    command = [sys.executable, "-m", "neurosym", "replay", str(folder), "task-01.fast-downward", "--page"]
    subprocess.run([*command, str(tmp_path / "run.html")], check=True, timeout=SLOW)
    film = browser.new_context().new_page()
    film.on("pageerror", lambda error: window.errors.append(str(error)))
    film.goto((tmp_path / "run.html").as_uri())
    film.get_by_label("The table").wait_for(timeout=1000 * SLOW)
    assert film.get_by_label("Play or pause").is_visible()
    assert film.get_by_label("Pace").is_visible()
    film.close()


@undrawn
@pytest.mark.evaluation
def test_keyboard_reaches_every_panel_and_number(window):
    window.open("Table")
    window.tab.get_by_role("tab", name="Table").focus()
    for label in ("Plan", "Run", "Symbols", "Tour"):
        window.tab.keyboard.press("ArrowRight")
        assert window.tab.get_by_role("tab", name=label, exact=True).get_attribute("aria-selected") == "true"
    window.open("Table")
    field = window.tab.get_by_role("textbox", name="Stands at x")
    field.focus()
    before = window.page.session.problem.objects[0].position
    window.tab.keyboard.press("ArrowUp")
    window.wait(lambda: window.page.session.problem.objects[0].position != before)


@undrawn
@pytest.mark.evaluation
def test_nearest_goals_are_accepted_with_one_click(window):
    session = window.page.session
    session.aim("item-01", 0.6, 0.1, 0.44)  # higher than anything is lifted
    window.open("Plan")
    window.press("Plan")
    window.wait(lambda: session.plans and not session.planning)
    assert session.plan_shown.record.status is PlanStatus.NEAREST, session.word.text
    window.press("Accept the nearest goals")
    window.wait(lambda: session.plans and not session.planning and session.plan_shown.record.solved)
