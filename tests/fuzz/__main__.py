"""The long round of `make fuzz`: cases for so many minutes, and what they found.

The folder keeps the seeds, how many cases were tried, and each finding with a case that shows it.
The same command first tries those again, and then goes on with cases that it has not tried.
"""

import itertools
import re
import shutil
import signal
import sys
import time
from contextlib import suppress
from pathlib import Path
from random import Random
from typing import Annotated

import tyro
from fuzz.cases import Case, as_json, build, drawn_case, from_json, read_seeds
from fuzz.lines import ENDING
from fuzz.running import Finding, Runner, judge, runner

from neurosym.files import write_atomically
from neurosym.stages.console import say

OFTEN = 50
"""After so many cases it says how far it is."""


def kept(folder: Path) -> list[Path]:
    """List the findings that still fail."""
    return sorted((folder / "failures").glob("*/case.json"))


def try_known(folder: Path, run: Runner) -> None:
    """Try again what was found before, and forget what is mended."""
    for path in kept(folder):
        if not judge(case := from_json(path.read_text()), run.run(case)):
            shutil.rmtree(path.parent)
            say(f"mended: {path.parent.name}")


def go_on(folder: Path, run: Runner, until: float) -> None:
    """Try case after case."""
    seeds, count = read_seeds(folder / "toy"), folder / "count"
    for number in itertools.count(int(count.read_text()) if count.exists() else 0):
        if time.monotonic() >= until:
            break
        case = drawn_case(Random(number), ENDING, seeds)
        for finding in judge(case, run.run(case)):
            keep(folder, finding, case)
        write_atomically(count, str(number + 1).encode())
        if (number + 1) % OFTEN == 0:
            say(f"{number + 1} inputs, {len(kept(folder))} distinct findings")


def keep(folder: Path, finding: Finding, case: Case) -> None:
    """Write a finding down with the case that shows it, unless it is known."""
    name = re.sub(r"[^\w.-]+", "-", finding.key).strip("-")[:120] or "nameless"
    if (place := folder / "failures" / name).exists():
        return
    place.mkdir(parents=True)
    write_atomically(place / "case.json", as_json(case).encode())
    write_atomically(place / "said.txt", f"{finding.key}\n{finding.detail}".encode(errors="replace"))
    say(f"found: {finding.key}")


def main(
    minutes: Annotated[float, tyro.conf.arg(help="For how long.")] = 60.0,
    folder: Annotated[Path, tyro.conf.arg(help="Where findings go.")] = Path("/var/tmp/neurosym-fuzz"),
) -> int:
    """Fuzz the command line; exit code 3 if there is a finding."""
    signal.signal(signal.SIGINT, signal.default_int_handler)  # which may be ignored in the background
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    folder.mkdir(parents=True, exist_ok=True)
    build(folder / "toy")
    with runner(folder / "toy") as run, suppress(KeyboardInterrupt):
        try_known(folder, run)
        go_on(folder, run, time.monotonic() + 60 * minutes)
    for path in kept(folder):
        say(f"  {path.parent}")
    return 3 if kept(folder) else 0


if __name__ == "__main__":
    sys.exit(tyro.cli(main))
