"""Every figure of docs/studio.md: `python -m tools.benchmarks.studio.evaluate` writes docs/results/studio.*.

`--only crowd` and so on measures one part, and keeps the others as they are.
"""

import argparse
import json
from collections.abc import Callable
from datetime import date
from typing import Any

import rich

from neurosym.execution.record import this_machine
from neurosym.files import write_atomically
from neurosym.stages.console import say
from tools.benchmarks.jobs import as_text
from tools.benchmarks.options import RESULTS
from tools.benchmarks.studio.crowd import measure_crowd
from tools.benchmarks.studio.measures import (
    measure_access,
    measure_drags,
    measure_recording,
    measure_run,
    measure_start,
)
from tools.benchmarks.studio.pages import measure_pages

PARTS: dict[str, tuple[str, Callable[[], dict[str, Any]]]] = {
    "start": ("Until the page can be used", measure_start),
    "access": ("Barriers that axe-core calls serious or critical", measure_access),
    "pages": ("Reports, site and colours", measure_pages),
    "run": ("One run, as fast as in reality", measure_run),
    "drags": ("Goals dragged by mouse", measure_drags),
    "recording": ("A run as one file", measure_recording),
    "crowd": ("A class on one server", measure_crowd),
}  # what is measured, by what it is called


def summary(found: dict[str, Any]) -> dict[str, Any]:
    """Return what is asked of the whole: heights, colours, barriers, and questions once they were asked."""
    pages, answers = found.get("pages", {}), json.loads((RESULTS / "questions.json").read_text())
    told = {key: pages[key] for key in ("report_px", "least_colour_distance") if pages}
    if pages and "access" in found:
        both = found["access"] | pages
        told["axe_serious"] = sum(both[key] for key in both if key.startswith("serious"))
    return told | {"questions": {key: answers[key] for key in ("asked", "median_right")}}


def page(found: dict[str, Any]) -> str:
    """Return the results as a document."""
    tables = {title: found[part] for part, (title, _) in PARTS.items() if part in found}
    return "# Studio\n\nPrinted by `python -m tools.benchmarks.studio.evaluate`.\n\n" + "\n".join(
        f"## {title}\n\n| what | value |\n| --- | --- |\n"
        + "".join(f"| {name} | {value} |\n" for name, value in told.items())
        for title, told in tables.items()
    )


def main() -> None:
    """Measure, and write what was found."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--only", choices=PARTS, help="measure this part only")
    only = parser.parse_args().only
    rich.get_console().quiet = True  # on which the server of pages announces itself
    file, machine = RESULTS / "studio.json", f"{this_machine().processor}, {date.today().isoformat()}"
    found = json.loads(file.read_text()) if file.exists() else {}
    for part, (title, measure) in PARTS.items():
        if only in (None, part):
            say(f"measuring: {title}")
            found[part] = measure() | {"machine": machine}
            found |= summary(found)
            write_atomically(file, as_text(found))
            write_atomically(RESULTS / "studio.md", page(found))
            say(as_text(found[part]))


if __name__ == "__main__":
    main()
