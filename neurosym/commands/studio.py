"""The command `neurosym studio`: see, drag, plan, watch and teach, in the browser."""

import os
import sys
import threading
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Optional

from tyro.conf import Positional, arg

from neurosym.choices import DOMAINS, shipped_domain
from neurosym.commands.arguments import opened
from neurosym.errors import InvalidValue, check_extra
from neurosym.stages.console import say
from neurosym.stages.folder import DomainFolder

if TYPE_CHECKING:
    from neurosym.studio.library import Library

_LOOK_UP = 1.0  # how long the main thread waits at a time [s]


def studio(
    folder: Annotated[
        Positional[Optional[Path]], arg(metavar="DIR", help="The domain folder; the shipped one without it.")
    ] = None,
    problem: Annotated[
        Optional[str], arg(metavar="NAME", help="The problem that pages begin with; else the first one.")
    ] = None,
    host: Annotated[
        str, arg(help="Who is heard. 0.0.0.0 lets other machines in: they can move the robot, too.")
    ] = "127.0.0.1",
    port: Annotated[int, arg(help="The port; 0 takes a free one.")] = 0,
    no_browser: Annotated[bool, arg(help="Print the address, and open no browser.")] = False,
) -> int:
    """Open a page in the browser: drag objects and goals, plan, watch the robot.

    It needs no network, and ends with Ctrl-C. Nothing is written into a shipped domain. Each browser has a
    page of its own, so that a class can share one address.
    """
    check_extra()
    import webbrowser

    import rich

    rich.get_console().quiet = True  # on which the server of pages announces itself
    library = _library(folder)
    from neurosym.studio.server import Studio

    first = library.load_problem(library.folder.problem(problem)) if problem is not None else None
    running = Studio(library, host, port, first)
    running.start()
    try:
        say(f"the studio is at {running.address}")
        if not running.front.is_local:
            say("note: anybody who can reach this machine and has the address can move the robot")
        say("Ctrl-C ends it")
        # a browser in the terminal would take it over, so one is opened only in a window
        if not no_browser and (sys.platform != "linux" or {"DISPLAY", "WAYLAND_DISPLAY"} & {*os.environ}):
            threading.Thread(target=webbrowser.open, args=(running.address,), daemon=True).start()
        never = threading.Event()
        while not never.wait(_LOOK_UP):
            pass  # a signal that comes just before a wait is heard after it
    except KeyboardInterrupt:
        say("the studio is closed")
    finally:
        running.close()
    return 0


def _library(folder: Path | None) -> "Library":
    """Read the domain: a folder, or a shipped one by its name, which is only read."""
    from neurosym.studio.library import Library

    name = folder.name if folder is not None else DOMAINS[0]
    shipped = shipped_domain(name)
    if shipped is not None and (folder is None or (len(folder.parts) == 1 and not folder.exists())):
        return Library(DomainFolder(shipped), name, is_shipped=True)
    if folder is None:
        raise InvalidValue("No domain came with this installation; name a domain folder.")
    is_shipped = shipped is not None and folder.resolve() == shipped.resolve()
    return Library(opened(folder), folder.resolve().name, is_shipped=is_shipped)
