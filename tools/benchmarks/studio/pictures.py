"""Pictures of the studio for the documents: `python -m tools.benchmarks.studio.pictures [FOLDER]`."""

import argparse
from pathlib import Path

import rich
from PIL import Image

from neurosym.stages.console import say
from tools.benchmarks.studio.browser import Window
from tools.benchmarks.studio.measures import window as window_on

COLOURS = 128


def take(window: Window, file: Path) -> None:
    """Write what is seen as a small PNG."""
    window.tab.wait_for_timeout(3000)
    window.tab.screenshot(path=file)
    Image.open(file).convert("RGB").quantize(COLOURS).save(file, optimize=True)
    say(f"wrote {file}")


def main() -> None:
    """Write the pictures."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", nargs="?", type=Path, default=Path("docs") / "images")
    asked = parser.parse_args()
    rich.get_console().quiet = True
    with window_on("task-17") as window:
        session = window.page.session
        session.plan("fast-downward")
        window.wait(lambda: session.plans and not session.planning)
        window.open("Run")
        session.running.begin()
        window.wait(lambda: len(session.running.records) > 0 or not session.running.is_active)
        window.tab.wait_for_timeout(800)
        session.running.steer(is_paused=True)
        take(window, asked.folder / "studio.png")
        session.running.stop()


if __name__ == "__main__":
    main()
