"""The long round of `make fuzz`: cases for so many minutes, and what they found.

The folder keeps the seeds, how far it came, and each finding with the smallest case that shows it; the same
command first tries those again, and then goes on with cases that it has not tried.
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

import msgspec
import tyro
from fuzz.cases import Case, as_json, drawn_case, from_json, read_seeds
from fuzz.lines import ENDING
from fuzz.running import Finding, Runner, judge, runner
from fuzz.seeds import build

from neurosym.files import write_atomically, write_json
from neurosym.stages.console import say

OFTEN = 50
"""After so many cases it says how far it is."""
ALONE, SIGNALS = 4, 8
"""Of a hundred cases: so many are processes of their own, and so many are sent a signal."""


class State(msgspec.Struct):
    """How far fuzzing came.

    Attributes:
        inputs: How many cases were tried; the next is drawn from this number.
        seconds: For how long.
        commands: How many cases of each command were tried.
        codes: How many ended with each exit code.
    """

    inputs: int = 0
    seconds: float = 0.0
    commands: dict[str, int] = {}
    codes: dict[str, int] = {}


class Round:
    """A round of fuzzing in a folder."""

    def __init__(self, folder: Path, run: Runner):
        self.folder, self.run = folder, run
        kept = folder / "state.json"
        self.state = msgspec.json.decode(kept.read_bytes(), type=State) if kept.exists() else State()

    def try_known(self) -> None:
        """Try again what was found before; what no longer fails is moved to `mended`."""
        for path in sorted((self.folder / "failures").glob("*/case.json")):
            if not judge(case := from_json(path.read_bytes()), self.run.run(case)):
                (self.folder / "mended").mkdir(exist_ok=True)
                shutil.rmtree(target := self.folder / "mended" / path.parent.name, ignore_errors=True)
                path.parent.rename(target)
                say(f"mended: {path.parent.name}")

    def go_on(self, until: float) -> None:
        """Try batch after batch."""
        seeds = read_seeds(self.folder / "toy")
        while time.monotonic() < until:
            draw = Random(self.state.inputs)
            self.try_one(drawn_case(draw, ENDING, seeds, alone=ALONE, signals=SIGNALS))
            if self.state.inputs % OFTEN == 0:
                self.save()
                self.tell()

    def try_one(self, case: Case) -> None:
        """Try a case, and keep what it finds."""
        start = time.monotonic()
        ending = self.run.run(case)
        state, name = self.state, next(iter(case.arguments), "")
        name = name if name in ENDING else "other"
        state.inputs += 1
        state.commands[name] = state.commands.get(name, 0) + 1
        state.codes[str(ending.code)] = state.codes.get(str(ending.code), 0) + 1
        for finding in judge(case, ending):
            self.keep(finding, case)
        state.seconds += time.monotonic() - start

    def keep(self, finding: Finding, case: Case) -> None:
        """Write a finding down with the smallest case that shows it, unless it is known."""
        place = (
            self.folder / "failures" / (re.sub(r"[^\w.-]+", "-", finding.key).strip("-")[:120] or "nameless")
        )
        if place.exists():
            return
        smallest = self.smallest(finding, case)
        place.mkdir(parents=True)
        write_atomically(place / "case.json", as_json(smallest))
        write_atomically(place / "said.txt", f"{finding.key}\n{finding.detail}".encode(errors="replace"))
        say(f"found: {finding.key}")

    def smallest(self, finding: Finding, case: Case) -> Case:
        """Leave out edits and arguments as long as the same is found."""
        shorter = True
        while shorter:
            shorter = False
            for other in _smaller(case):
                if any(again.key == finding.key for again in judge(other, self.run.run(other))):
                    case, shorter = other, True
                    break
        return case

    def save(self) -> None:
        """Write down how far it came."""
        write_json(self.folder / "state.json", self.state)

    def kept(self) -> list[str]:
        """Name the findings that still fail."""
        return sorted(path.parent.name for path in (self.folder / "failures").glob("*/case.json"))

    def tell(self) -> None:
        """Print how much was tried, and how much was found."""
        minutes = self.state.seconds / 60
        say(f"{self.state.inputs} inputs in {minutes:.0f} minutes, {len(self.kept())} distinct findings")


def _smaller(case: Case) -> list[Case]:
    replace = msgspec.structs.replace
    fewer = [replace(case, edits=case.edits[:n] + case.edits[n + 1 :]) for n in range(len(case.edits))]
    words = case.arguments
    for number, word in enumerate(words):
        if word.startswith("--"):
            length = 2 if number + 1 < len(words) and not words[number + 1].startswith("--") else 1
            fewer.append(replace(case, arguments=words[:number] + words[number + length :]))
    return fewer


def main(
    minutes: Annotated[float, tyro.conf.arg(help="For how long.")] = 60.0,
    folder: Annotated[Path, tyro.conf.arg(help="Where it keeps what it found.")] = Path(
        "/var/tmp/neurosym-fuzz"
    ),
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
        fuzzing.save()
    fuzzing.tell()
    say(f"by command: {fuzzing.state.commands}; by exit code: {fuzzing.state.codes}")
    for name in fuzzing.kept():
        say(f"  {folder / 'failures' / name}")
    return 3 if fuzzing.kept() else 0


if __name__ == "__main__":
    sys.exit(tyro.cli(main))
