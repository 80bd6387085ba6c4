"""The page of the shipped domain in a real browser: what is seen, and that nothing else is loaded."""

import shutil
from pathlib import Path

import pytest
from command_line import neurosym
from places import SHIPPED

from tools.benchmarks.studio.browser import BROWSERS, FLAGS, SLOW, browser_here


@pytest.fixture(scope="module")
def launch():
    """What opens a browser of this machine without a window."""
    playwright = pytest.importorskip("playwright.sync_api", reason="pip install 'neurosym-pddl[browser]'")
    found = browser_here()
    if found is None:
        pytest.skip(f"none of {', '.join(BROWSERS)} is installed")
    with playwright.sync_playwright() as running:
        yield lambda *flags: running.chromium.launch(executable_path=found, args=["--no-sandbox", *flags])


@pytest.fixture(scope="module")
def browser(launch):
    """A browser that draws plain pages."""
    opened = launch()
    yield opened
    opened.close()


@pytest.fixture(scope="module")
def browser_for_films(launch):
    """A browser that draws in three dimensions, too."""
    opened = launch(*FLAGS)
    yield opened
    opened.close()


@pytest.fixture(scope="module")
def page_file(tmp_path_factory) -> Path:
    folder = shutil.copytree(SHIPPED, tmp_path_factory.mktemp("shipped") / "tabletop")
    assert neurosym("report", folder) == 0
    return Path(folder) / "report.html"


@pytest.mark.evaluation
def test_runs_are_watched_and_turned_without_a_network(browser_for_films, page_file, tmp_path):
    with_films = tmp_path / "films.html"
    assert neurosym("report", page_file.parent, "--films", "--output", with_films) == 0
    page, said, asked = browser_for_films.new_page(), [], []
    page.on("pageerror", lambda error: said.append(str(error)))
    page.on("request", lambda request: asked.append(request.url))
    page.goto(with_films.as_uri())
    for button in page.locator("button.turn").all()[:2]:
        button.click()
        page.frame_locator("#film iframe").locator("canvas").first.wait_for(timeout=1000 * SLOW)
    page.locator("#film").get_by_role("button", name="Close").click()
    assert not page.locator("#film").is_visible()
    assert said == []
    assert [url for url in asked if not url.startswith(("data:", "blob:"))] == [with_films.as_uri()]
    print(f"{with_films.stat().st_size / 1e6:.2f} MB with films")


@pytest.mark.evaluation
@pytest.mark.parametrize("width", [360, 1200])
@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_everything_is_seen_and_nothing_else_is_loaded(browser, page_file, width, scheme):
    page = browser.new_page(viewport={"width": width, "height": 900}, color_scheme=scheme)
    said, asked = [], []
    page.on("console", lambda message: said.append(message.text))
    page.on("pageerror", lambda error: said.append(str(error)))
    page.on("request", lambda request: asked.append(request.url))
    page.goto(page_file.as_uri())
    assert said == []
    assert [url for url in asked if not url.startswith("data:")] == [page_file.as_uri()]
    sizes = page.evaluate(
        "[...document.images].map(i => [i.naturalWidth, i.naturalHeight, i.width, i.height])"
    )
    assert len(sizes) > 8
    assert all(min(size) > 0 for size in sizes)
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    charts = page.evaluate("[...document.querySelectorAll('svg')].map(s => s.getBoundingClientRect().height)")
    assert len(charts) >= 4
    assert min(charts) > 100
    ink, paper = page.evaluate(
        "(s => [s.color, s.backgroundColor].map(c => c.match(/\\d+/g).reduce((a, b) => a + +b, 0)))"
        "(getComputedStyle(document.body))"
    )
    assert (ink < paper) is (scheme == "light")
    page.close()
