"""Pictures of the studio for the documents: `python -m tools.benchmarks.studio.pictures [FOLDER]`.

With `--all` also what one looks at before a release: two sizes, light and dark, one object and eight.
"""

import argparse
from pathlib import Path

import rich
from PIL import Image
from playwright.sync_api import sync_playwright

from neurosym.stages.console import say
from tools.benchmarks.studio.browser import FLAGS, Window, browser_here
from tools.benchmarks.studio.measures import studio

SIZES = ((1400, 900), (900, 700))
TASKS = ("task-01", "task-20")
COLOURS = 128


def take(window: Window, file: Path) -> None:
    """Write what is seen as a small PNG, without the browser's remark that it draws in software."""
    if (remark := window.tab.locator(".mantine-Notification-closeButton")).count():
        remark.first.click()
    window.tab.wait_for_timeout(3000)
    window.tab.screenshot(path=file)
    Image.open(file).convert("RGB").quantize(COLOURS).save(file, optimize=True)
    say(f"wrote {file}")


def main() -> None:
    """Write the pictures."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", nargs="?", type=Path, default=Path("docs") / "images")
    parser.add_argument("--all", action="store_true", help="every size, light and dark")
    asked = parser.parse_args()
    rich.get_console().quiet = True
    with studio("task-17") as opened, sync_playwright() as running:
        browser = running.chromium.launch(executable_path=browser_here(), args=list(FLAGS))
        window = Window(browser, opened)
        session = window.page.session
        session.plan("fast-downward")
        window.wait(lambda: session.plans and not session.is_planning)
        window.open("Run")
        session.running.begin()
        window.wait(lambda: len(session.running.records) > 0 or not session.running.is_active)
        window.tab.wait_for_timeout(800)
        session.running.pause()
        take(window, asked.folder / "studio.png")
        session.running.stop()
        window.context.close()
        for width, height in SIZES if asked.all else ():
            for task in TASKS:
                other = Window(browser, opened, width, height)
                other.page.session.load(task)
                for is_dark in (False, True):
                    other.page.set_dark(is_dark)
                    shade = "dark" if is_dark else "light"
                    take(other, asked.folder / f"studio-{width}-{task}-{shade}.png")
                other.context.close()
        browser.close()


if __name__ == "__main__":
    main()
