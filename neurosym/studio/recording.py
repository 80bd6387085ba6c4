"""A run as one file: a page without a server, with a view that can be turned."""

import threading
from collections.abc import Sequence
from functools import cache
from typing import Any

import viser

from neurosym.execution.record import StepRecord
from neurosym.problems import Problem
from neurosym.studio.library import Library
from neurosym.studio.messages import Seen
from neurosym.studio.relating import ghost_spots
from neurosym.studio.view import View, aim_camera
from neurosym.tasks.task import understand

PACE = 1 / 15
"""Time between two poses that are kept, of a motion as it is [s]."""
PAUSE = 0.4
"""How long the end of a step is shown [s]."""
ABOVE = 0.55
"""How high above the middle of the table the name of a step stands [m]."""
_LOCK = threading.Lock()


def film_of(
    library: Library,
    problem: Problem,
    seen: Sequence[Seen],
    steps: Sequence[StepRecord] = (),
    *,
    is_dark: bool = False,
) -> bytes:
    """Return what was seen of a run as one HTML file that needs nothing else.

    Args:
        library: The domain.
        problem: What the run was for.
        seen: What was seen, one pose or more.
        steps: What was done, each named while it is seen, as far as it is known at which step that was.
        is_dark: Whether it is shown dark.
    """
    with _LOCK:
        server = _server()
        server.scene.reset()
        server.scene.set_up_direction("+z")
        aim_camera(server, library)
        view = View(server.scene, library)
        view.show_problem(problem, ghost_spots(understand(library.paired(problem), library.grounding)))
        view.show(seen[0].pose)
        names = step_labels(steps)
        label = server.scene.add_label("/step", "", position=(*library.middle, ABOVE), visible=False)
        film = server.get_scene_serializer()
        last = -PACE
        for one in seen:
            if one.pose.seconds < last:  # another motion begins
                film.insert_sleep(PAUSE)
                last = -PACE
            if label.text != (name := names.get(one.step, "")):
                label.text, label.visible = name, bool(name)
            if one.pose.seconds - last >= PACE * 0.99:
                film.insert_sleep(min(one.pose.seconds - last, PACE * 4) if last >= 0 else 0.0)
                view.show(one.pose)
                last = one.pose.seconds
        view.show(seen[-1].pose)
        film.insert_sleep(2 * PAUSE)
        return film.as_html(dark_mode=is_dark).encode()


def step_labels(steps: Sequence[StepRecord]) -> dict[int, str]:
    """Return what a film shows above the table at each step, by its number.

    Args:
        steps: What was done.
    """
    return {
        number: f"{number}: {step.operator} {step.object} {step.place or ''}".rstrip()
        for number, step in enumerate(steps, start=1)
    }


class Reel:
    """A run is seen and kept, for a film of it; see `Way`."""

    def __init__(self) -> None:
        self.seen: list[Seen] = []

    def send(self, message: Any, /) -> None:
        """Keep what is seen."""
        if isinstance(message, Seen):
            self.seen.append(message)

    def poll(self, seconds: float = 0.0, /) -> bool:  # noqa: ARG002  (a `Way`)
        """Say that nobody says anything."""
        return False

    def recv(self) -> Any:
        """Return nothing."""
        return None


@cache
def _server() -> viser.ViserServer:
    """Return a server that nobody looks at, in which films are made, one after another."""
    return viser.ViserServer(host="127.0.0.1", port=0, verbose=False)
