"""The command `neurosym report`: one page about a domain folder."""

from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Optional

from tyro.conf import arg

from neurosym.commands.options import CPUS, Folder, Workers, check_file, opened
from neurosym.console import progress_bar, say
from neurosym.files import write_atomically
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import PAGE
from neurosym.studio.extra import check_extra

if TYPE_CHECKING:
    from neurosym.report.examples import Example

_MEGABYTE = 1e6


def report(
    folder: Folder,
    output: Annotated[
        Optional[Path], arg(metavar="FILE.html", help="Write the page here and not to DIR/report.html.")
    ] = None,
    films: Annotated[
        bool, arg(help="Also let the runs that are pictured be turned and watched; needs the extra `studio`.")
    ] = False,
    workers: Workers = CPUS,
) -> int:
    """Write one HTML page about a domain: symbols, exploration, operators, plans.

    It needs no network, and without films no scripts. What is missing is said with the command that makes it.
    Pictures are made once, by performing primitives and runs again.
    """
    from neurosym.report.page import gather, render
    from neurosym.worlds.workers import check_workers

    check_workers(workers)
    domain = opened(folder)
    path = output or domain / PAGE
    check_file(path, "page", ".html")
    if films:
        check_extra()
    with progress_bar("pictures") as advance:
        page = gather(domain, advance, workers=workers, film=partial(_film, domain) if films else None)
    text = render(page)
    write_atomically(path, text)
    say(f"wrote {path} ({len(text) / _MEGABYTE:.1f} MB)")
    say(f"next: open {path} in a browser")
    return 0


def _film(domain: DomainFolder, example: "Example") -> bytes:
    """Perform a run again, and make a page of what is seen."""
    from neurosym.commands.filmed import Filmed
    from neurosym.stages.executing import Showing, replay_run

    filmed = Filmed(domain)
    run, _ = replay_run(domain, example.path, Showing(audience=filmed.onlooker))
    return filmed.page(run)
