"""The command `neurosym replay`: a record of a run, run again."""

import math
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Optional

from tyro.conf import Positional, arg

from neurosym.commands.exit_codes import NO_RESULT
from neurosym.commands.options import Folder, check_file, opened
from neurosym.commands.showing import Gif, Gui, Strip, say_written, showing_of
from neurosym.console import say
from neurosym.errors import InvalidFile, UnknownChoice
from neurosym.files import write_atomically
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import RUNS
from neurosym.wording import counted

if TYPE_CHECKING:
    from neurosym.commands.filmed import Filmed
    from neurosym.execution.record import Run


def replay(
    folder: Folder,
    record: Annotated[
        Positional[Path],
        arg(metavar="RUN", help="A record that `neurosym execute` wrote: its file, or its name in DIR/runs."),
    ],
    gif: Gif = None,
    strip: Strip = None,
    gui: Gui = False,
    page: Annotated[
        Optional[Path], arg(help="Write the run here as one HTML page whose view can be turned.")
    ] = None,
) -> int:
    """Run a record again, nudge and all, and say whether the same happens (exit code 3: no).

    That is byte for byte on the machine that it was made on, and within a micrometre on another.
    """
    from neurosym.stages.executing import replay_run

    domain = opened(folder)
    if page:
        from neurosym.studio.extra import check_extra

        check_extra()
        check_file(page, "page", ".html", ".htm")
    record = _record(domain, record)
    inside = record.resolve()
    if inside.is_relative_to(domain.path.resolve()):
        for remark in domain.outdated((inside.relative_to(domain.path.resolve()).as_posix(),)):
            say(f"note: {remark}")
    film = _film(domain) if page else None
    showing = showing_of(gif, strip, gui)
    run, agreement = replay_run(domain, record, replace(showing, audience=film.onlooker if film else None))
    if film and page:
        if text := film.page(run):
            write_atomically(page, text)
        else:
            say("no page: nothing moves in this run")
    say_written(gif, strip, page)
    if agreement.course == "another":
        by = f", by {1000 * agreement.apart:.2g} mm" if math.isfinite(agreement.apart) else ""
        say(f"something else happened than {record} says, first in {agreement.where}{by}")
        say(_machines(run))
        return NO_RESULT
    steps = counted(len(run.steps), "step")
    goal = f"{run.outcome}; {run.credit}"
    if agreement.course == "same bytes":
        say(f"the same happened again in {steps}, byte for byte; {goal}")
        return 0
    by = f"lengths differ by {1000 * agreement.apart:.1g} mm at most, first in {agreement.where}"
    say(f"the same happened again in {steps}, within a micrometre; {goal}")
    say(f"not byte for byte: {by}")
    say(_machines(run))
    return 0


def _film(domain: DomainFolder) -> "Filmed":
    from neurosym.commands.filmed import Filmed

    return Filmed(domain)


def _machines(run: "Run") -> str:
    """Say on which machines a record was made and run again, as far as they differ."""
    from neurosym.execution.machine import this_machine

    here = this_machine()
    if run.machine is None:
        return f"the record does not name its machine; this one has: {here.processor}, {here.system}"
    if apart := run.machine.differences(here):
        return f"the record was made on another machine than this: {'; '.join(apart)}"
    return f"machine and versions are those of the record: {here.processor}, {here.system}"


def _record(domain: DomainFolder, typed: Path) -> Path:
    """Find the record of a run that was typed as a file, or as a name."""
    from neurosym.stages.layout import RECORD

    if typed.exists() and not typed.is_dir():
        return typed
    known = {path.name.removesuffix(RECORD): path for path in (domain / RUNS).glob(f"*{RECORD}")}
    if found := known.get(typed.name.removesuffix(RECORD)) if typed.name == str(typed) else None:
        return found
    if not known:
        raise InvalidFile(typed, "there is no such file; `neurosym execute` writes one")
    raise UnknownChoice("record of a run", str(typed), known)
