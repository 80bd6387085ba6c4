"""Every figure of docs/studio.md: `python -m tools.benchmarks.studio.evaluate` writes docs/results/studio.*.

`--only crowd` and so on measures one part, and keeps the others as they are.
"""

import argparse
import json
from collections.abc import Callable
from datetime import date
from pathlib import Path
from typing import Any

import rich

from neurosym.execution.record import this_machine
from neurosym.files import write_atomically
from neurosym.stages.console import say
from tools.benchmarks.studio.crowd import measure_crowd
from tools.benchmarks.studio.measures import measure_drags, measure_recording, measure_run, measure_start

RESULTS = Path("docs") / "results"
PARTS: dict[str, tuple[str, Callable[[], dict[str, Any]]]] = {
    "start": ("Until the page can be used", measure_start),
    "run": ("One run, as fast as in reality", measure_run),
    "drags": ("Goals dragged by mouse", measure_drags),
    "recording": ("A run as one file", measure_recording),
    "crowd": ("A class on one server", measure_crowd),
}
"""What is measured, by what it is called."""


def page(found: dict[str, Any]) -> str:
    """Return the results as a document."""
    lines = ["# Studio", "", "Printed by `python -m tools.benchmarks.studio.evaluate`.", ""]
    for part, (title, _) in PARTS.items():
        if part in found:
            lines += [f"## {title}", "", "| what | value |", "| --- | --- |"]
            lines += [*(f"| {name} | {value} |" for name, value in found[part].items()), ""]
    return "\n".join(lines)


def main() -> None:
    """Measure, and write what was found."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--only", choices=PARTS, help="measure this part only")
    only = parser.parse_args().only
    rich.get_console().quiet = True  # on which the server of pages announces itself
    file = RESULTS / "studio.json"
    found = json.loads(file.read_text()) if file.exists() else {}
    for part, (title, measure) in PARTS.items():
        if only in (None, part):
            say(f"measuring: {title}")
            here = this_machine()
            found[part] = measure() | {"machine": f"{here.processor}, {date.today().isoformat()}"}
            write_atomically(file, json.dumps(found, indent=1) + "\n")
            write_atomically(RESULTS / "studio.md", page(found))
            say(json.dumps(found[part], indent=1))


if __name__ == "__main__":
    main()
