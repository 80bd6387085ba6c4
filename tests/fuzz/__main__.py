"""The long round of `make fuzz`: cases for so many minutes, and what they found.

The folder keeps the seeds, how many cases were tried, and each finding with a case that shows it.
The same command first tries those again, and then goes on with cases that it has not tried.
"""

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


class Round:
    """A round of fuzzing in a folder."""

    def __init__(self, folder: Path, run: Runner):
        self.folder, self.run, self.count = folder, run, folder / "count"
        self.tried = int(self.count.read_text()) if self.count.exists() else 0

    def kept(self) -> list[Path]:
        """List the findings that still fail."""
        return sorted((self.folder / "failures").glob("*/case.json"))

    def try_known(self) -> None:
        """Try again what was found before, and forget what is mended."""
        for path in self.kept():
            if not judge(case := from_json(path.read_text()), self.run.run(case)):
                shutil.rmtree(path.parent)
                say(f"mended: {path.parent.name}")

    def go_on(self, until: float) -> None:
        """Try case after case."""
        seeds = read_seeds(self.folder / "toy")
        while time.monotonic() < until:
            case = drawn_case(Random(self.tried), ENDING, seeds)
            for finding in judge(case, self.run.run(case)):
                self.keep(finding, case)
            self.tried += 1
            write_atomically(self.count, str(self.tried).encode())
            if self.tried % OFTEN == 0:
                self.tell()

    def keep(self, finding: Finding, case: Case) -> None:
        """Write a finding down with the case that shows it, unless it is known."""
        name = re.sub(r"[^\w.-]+", "-", finding.key).strip("-")[:120] or "nameless"
        if (place := self.folder / "failures" / name).exists():
            return
        place.mkdir(parents=True)
        write_atomically(place / "case.json", as_json(case).encode())
        write_atomically(place / "said.txt", f"{finding.key}\n{finding.detail}".encode(errors="replace"))
        say(f"found: {finding.key}")

    def tell(self) -> None:
        """Print how much was tried, and how much was found."""
        say(f"{self.tried} inputs, {len(self.kept())} distinct findings")


def main(
    minutes: Annotated[float, tyro.conf.arg(help="For how long.")] = 60.0,
    folder: Annotated[Path, tyro.conf.arg(help="Where findings go.")] = Path("/var/tmp/neurosym-fuzz"),
) -> int:
    """Fuzz the command line; exit code 3 if there is a finding."""
    signal.signal(signal.SIGINT, signal.default_int_handler)  # which may be ignored in the background
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    folder.mkdir(parents=True, exist_ok=True)
    build(folder / "toy")
    with runner(folder / "toy") as run:
        fuzzing = Round(folder, run)
        with suppress(KeyboardInterrupt):
            fuzzing.try_known()
            fuzzing.go_on(time.monotonic() + 60 * minutes)
    fuzzing.tell()
    for path in fuzzing.kept():
        say(f"  {path.parent}")
    return 3 if fuzzing.kept() else 0


if __name__ == "__main__":
    sys.exit(tyro.cli(main))
