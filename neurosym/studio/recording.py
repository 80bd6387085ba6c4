"""A run as one file: a page without a server, with a view that can be turned."""

import threading
from functools import cache
from typing import TYPE_CHECKING

import viser

from neurosym.studio.view import View, aim_camera

if TYPE_CHECKING:
    from neurosym.studio.session import Session

PACE = 1 / 15
"""Time between two poses that are kept, of a motion as it is [s]."""
PAUSE = 0.4
"""How long the end of a step is shown [s]."""
_LOCK = threading.Lock()


def recording_of(session: "Session", *, is_dark: bool = False) -> bytes:
    """Return the last run of a page as one HTML file that needs nothing else.

    Args:
        session: The page.
        is_dark: Whether it is shown dark.
    """
    running, problem = session.running, session.running.problem
    if not running.seen or problem is None:
        return b""
    with _LOCK:
        server = _server()
        server.scene.reset()
        server.scene.set_up_direction("+z")
        aim_camera(server, session.library)
        view = View(server.scene, session.library)
        view.show_objects(problem.objects, problem.goals)
        view.set_tolerance(problem.tolerance)
        view.place(problem.objects, problem.goals, {})
        view.show(running.seen[0])
        film = server.get_scene_serializer()
        last = -PACE
        for seen in running.seen:
            if seen.seconds < last:  # another step begins
                film.insert_sleep(PAUSE)
                last = -PACE
            if seen.seconds - last >= PACE * 0.99:
                film.insert_sleep(min(seen.seconds - last, PACE * 4) if last >= 0 else 0.0)
                view.show(seen)
                last = seen.seconds
        view.show(running.seen[-1])
        film.insert_sleep(2 * PAUSE)
        return film.as_html(dark_mode=is_dark).encode()


@cache
def _server() -> viser.ViserServer:
    """Return a server that nobody looks at, in which films are made, one after another."""
    return viser.ViserServer(host="127.0.0.1", port=0, verbose=False)
