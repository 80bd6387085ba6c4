"""A window of a real browser that looks at a page of the studio, driven as a person would."""

import os
import shutil
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from neurosym.studio.page import Page
from neurosym.studio.server import Studio

BROWSERS = ("chromium-headless-shell", "chromium", "chromium-browser", "google-chrome")
FLAGS = (
    *("--no-sandbox", "--disable-quic", "--no-first-run", "--disable-background-networking"),
    *("--disable-component-update", "--disable-sync", "--use-gl=angle", "--use-angle=swiftshader"),
    *("--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"),
)
AXE = Path(os.environ.get("AXE_CORE", "node_modules/axe-core/axe.min.js"))  # finds barriers; from npm
UNDRAWN = """for (const kind of ["Arrays", "Elements", "ArraysInstanced", "ElementsInstanced"])
  WebGL2RenderingContext.prototype[`draw${kind}`] = () => {};"""  # drawn in software, a frame takes seconds
SLOW = 180.0  # seconds for what a browser that draws in software does


def browser_here() -> str | None:
    """Return the path of a Chromium of this machine, if there is one."""
    return next(filter(None, map(shutil.which, BROWSERS)), None)


def wait_for(
    true: Callable[[], object], seconds: float = 300.0, pause: Callable[[], object] = lambda: time.sleep(0.02)
) -> None:
    """Wait until something is true; raise TimeoutError if it does not become so."""
    end = time.monotonic() + seconds
    while not true():
        if time.monotonic() > end:
            raise TimeoutError("it took too long")
        pause()


def serious_violations(tab: Any) -> list[str]:
    """Say which barriers axe-core finds on a page that are serious or critical."""
    tab.evaluate(AXE.read_text(encoding="utf-8"))
    found = tab.evaluate("async () => (await axe.run(document, {resultTypes: ['violations']})).violations")
    bad = [one for one in found if one["impact"] in ("serious", "critical")]
    return [f"{one['id']}: {node['html'][:120]}" for one in bad for node in one["nodes"]]


class Window:
    """A window of a browser that looks at a page; where the table does not matter, it is not drawn."""

    def __init__(
        self, browser: Any, studio: Studio, width: int = 1400, height: int = 900, *, is_drawn: bool = True
    ):
        self.asked: list[str] = []
        self.errors: list[str] = []
        known = set(studio.pages)
        self.context = browser.new_context(viewport={"width": width, "height": height})
        self.context.set_default_timeout(1000 * SLOW)  # a click waits for two frames, drawn in software
        if not is_drawn:
            self.context.add_init_script(UNDRAWN)
        self.tab = self.context.new_page()
        self.tab.on("request", lambda request: self.asked.append(request.url))
        self.tab.on("pageerror", lambda error: self.errors.append(str(error)))
        self.tab.goto(studio.address)
        self.page: Page = next(one for one in studio.pages if one not in known)
        self.await_page()

    def await_page(self) -> None:
        """Wait until the page can be used."""
        self.tab.locator("#cover").wait_for(state="detached", timeout=1000 * SLOW)
        wait_for(lambda: self.page.server.get_clients(), SLOW)

    def pixel(self, point: Any) -> tuple[float, float]:
        """Where a point of the table is seen [pixels]."""
        camera = next(iter(self.page.server.get_clients().values())).camera
        w, x, y, z = camera.wxyz
        ahead = Rotation.from_quat((x, y, z, w)).inv().apply(np.array(point) - camera.position)
        canvas = "(c => [c.clientWidth, c.clientHeight])(document.querySelector('canvas'))"
        width, height = self.tab.evaluate(canvas)
        focus = height / 2 / np.tan(camera.fov / 2)
        return width / 2 + focus * ahead[0] / ahead[2], height / 2 + focus * ahead[1] / ahead[2]

    def drag(self, start: Any, end: Any) -> None:
        """Drag what is seen at one point of the table to another [m]."""
        (x, y), to = self.pixel(start), self.pixel(end)
        mouse = self.tab.mouse
        mouse.move(x, y)
        self.tab.wait_for_timeout(400)
        mouse.down()
        mouse.move(x + 8, y + 4, steps=3)
        self.tab.wait_for_timeout(400)
        mouse.move(*to, steps=10)
        self.tab.wait_for_timeout(1200)
        mouse.up()
        self.tab.wait_for_timeout(600)

    def knob(self, name: str) -> tuple[float, float, float]:
        """Where the goal of an object is dragged by [m]."""
        problem = self.page.session.problem
        x, y, z = self.page.session.ghosts()[name]
        return x, y, z + problem.object_named(name).features[2] / 2 + 0.07

    def open(self, label: str) -> None:
        """Open a panel."""
        self.tab.get_by_role("tab", name=label, exact=True).click()

    def press(self, label: str) -> None:
        """Press a button."""
        self.tab.get_by_role("button", name=label, exact=True).click()

    def wait(self, true: Callable[[], object], seconds: float = SLOW) -> None:
        """Wait until something is true, while the browser goes on."""
        wait_for(true, seconds, lambda: self.tab.wait_for_timeout(50))
