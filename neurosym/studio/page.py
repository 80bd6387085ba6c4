"""The page of a session: what is seen of it in three dimensions, and its panels.

The session says by topic what has changed, from whatever thread. One thread of the page draws it, at most
`MOST_OFTEN` times a second, so that a drag or a run is never drawn later than it happens.
"""

import threading
import time
from contextlib import suppress
from typing import Any

import numpy as np
import viser

from neurosym.problems import Problem, SceneObject
from neurosym.studio.grabbing import Grab
from neurosym.studio.messages import Seen
from neurosym.studio.overlays import Overlays
from neurosym.studio.panel import Panel
from neurosym.studio.panel_about import AboutPanel
from neurosym.studio.panel_plan import PlanPanel
from neurosym.studio.panel_run import RunPanel
from neurosym.studio.panel_symbols import SymbolsPanel
from neurosym.studio.panel_table import TablePanel
from neurosym.studio.panel_take import TakePanel
from neurosym.studio.panel_tour import TourPanel
from neurosym.studio.session import Session, Topic
from neurosym.studio.view import COLOURS, View, aim_camera, related_names
from neurosym.world import Scene

MOST_OFTEN = 30.0
"""How often a page is drawn at most [1/s]."""
WIDTH = 400
"""Of the panels [pixels]."""
DARK, LIGHT = (24, 26, 30), (245, 246, 248)


class Page:
    """The page of a session; all windows that look at it show the same.

    Args:
        server: Serves this page and no other.
        session: What it shows.
        address: Where the page is, for links to it.

    Attributes:
        selected: Name of the object that the panels are about.
        drawn: How many poses were drawn so far.
    """

    def __init__(self, server: viser.ViserServer, session: Session, address: str = ""):
        self.server, self.session, self.address = server, session, address
        self.selected = session.problem.object_names[0] if session.problem else ""
        self._grabs: dict[tuple[str, str], Grab] = {}
        self._before: dict[str, Problem] = {}
        self._topics: set[Topic] = set()
        self._lock = threading.Lock()
        self._changed, self._is_closed = threading.Event(), False
        self._rested: Scene | None = None
        self.drawn = 0
        self._set_up()
        self.view = View(server.scene, session.library, self._grabbed)
        self.overlays = Overlays(server.scene)
        about = AboutPanel(self)
        tabs = server.gui.add_tab_group()
        self.panels: list[Panel] = [about]
        for label, panel in (
            ("Table", TablePanel),
            ("Plan", PlanPanel),
            ("Run", RunPanel),
            ("Symbols", SymbolsPanel),
            ("Tour", TourPanel),
            ("Take away", TakePanel),
        ):
            with tabs.add_tab(label):
                self.panels.append(panel(self))
        session.listen(self.hear)
        for topic in ("scene", "plan", "run", "status"):
            self.hear(topic)
        self._thread = threading.Thread(target=self._draw_all, daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Stop drawing."""
        self._is_closed = True
        self._changed.set()
        self._thread.join(2.0)

    def hear(self, topic: Topic) -> None:
        """Have something drawn soon."""
        with self._lock:
            self._topics.add(topic)
        self._changed.set()

    def select(self, name: str) -> None:
        """Choose the object that the panels are about."""
        if self.session.problem and name in self.session.problem.object_names and name != self.selected:
            self.selected = name
            self.hear("scene")

    @property
    def item(self) -> SceneObject | None:
        """The object that the panels are about, if there is any."""
        problem = self.session.problem
        if problem is None:
            return None
        if self.selected not in problem.object_names:
            self.selected = problem.object_names[0]
        return problem.object_named(self.selected)

    def colour_of(self, name: str) -> tuple[int, int, int]:
        """Return the colour of an object."""
        problem = self.session.problem
        number = problem.object_names.index(name) if problem and name in problem.object_names else 0
        return COLOURS[number % len(COLOURS)]

    def set_dark(self, is_dark: bool) -> None:
        """Show the page dark or light."""
        self.server.gui.configure_theme(
            dark_mode=is_dark, show_logo=False, show_share_button=False, control_width="large"
        )
        colour = DARK if is_dark else LIGHT
        self.server.scene.set_background_image(np.full((2, 2, 3), colour, dtype=np.uint8))

    def _set_up(self) -> None:
        self.set_dark(False)
        panel = self.server.gui.main_panel
        panel.dock_right()
        panel.set_width(WIDTH)
        aim_camera(self.server, self.session.library)

    def _grabbed(self, kind: str, name: str) -> Any:
        """Return what hears of drags of an object or its goal; in order, since it is a coroutine."""

        async def drag(event: viser.SceneNodeDragEvent[Any]) -> None:
            problem = self.session.problem
            if problem is None or name not in problem.object_names:
                return
            key, eye = (kind, name), event.client.camera.position.tolist()
            if event.phase == "start":
                centre = self.session.ghosts().get(name) if kind == "goal" else self._centre(name)
                if centre is not None:
                    self._grabs[key] = Grab(eye, event.start_position, centre)
                    self._before[name] = problem
                self.select(name)
            at = self._grabs[key].to(event.end_position) if key in self._grabs else None
            if at is not None:
                self._drop(kind, name, at, is_end=event.phase == "end")
            if event.phase == "end":
                self._grabs.pop(key, None)
            if event.phase == "end" and kind == "goal":
                self.session.drop_goal(name, self._before.pop(name, None))

        return drag

    def _centre(self, name: str) -> tuple[float, float, float]:
        """Return where an object stands now [m], during a run, too."""
        rest, problem = self.session.running.rest, self.session.problem
        assert problem is not None, "what is dragged is there"
        if rest is not None and self.session.running.is_active:
            return _triple(rest.positions[problem.object_names.index(name)])
        return problem.object_named(name).position

    def _drop(self, kind: str, name: str, at: tuple[float, float], *, is_end: bool) -> None:
        if kind == "goal":
            self.session.aim(name, *at)
        elif not self.session.running.is_active or is_end:
            self.session.move(name, *at)

    def _draw_all(self) -> None:
        while not self._is_closed:
            self._changed.wait()
            self._changed.clear()
            with self._lock:
                topics, self._topics = self._topics, set()
            began = time.monotonic()
            try:
                with self.server.atomic():
                    self._draw(topics)
            except Exception as error:  # the page goes on, whatever one drawing of it does
                self.session.say(f"The page could not be drawn: {type(error).__name__}", is_bad=True)
            time.sleep(max(0.0, 1 / MOST_OFTEN - (time.monotonic() - began)))

    def _draw(self, topics: set[Topic]) -> None:
        session, problem = self.session, self.session.problem
        running = session.running
        if topics & {"scene", "run"} and problem is not None and not running.is_active:
            self._show_problem()
        if topics & {"run"} and running.scene is not None and running.is_active:
            self._show_scene()
        if "place" in topics and problem is not None and not running.is_active:
            self.view.place(problem.objects, session.ghosts(), session.complaints(), related_names(problem))
        if "pose" in topics and running.seen:
            self._show_seen(running.seen[-1])
        if "step" in topics and running.rest is not None:
            self._show_rest()
        for panel in self.panels:
            panel.refresh(topics)

    def _show_problem(self) -> None:
        """Draw the table as it is set; after a run, as the run left it."""
        problem, running = self.session.problem, self.session.running
        self._rested = None
        if problem is None:
            return
        self.view.show_problem(problem, self.session.ghosts(), self.session.complaints())
        if running.seen and running.problem is problem:
            self._show_seen(running.seen[-1])
        else:
            self.view.rest()
            self._show_rest()

    def _show_scene(self) -> None:
        """Draw the objects of a scene that is not the page's own."""
        scene = self.session.running.scene
        assert scene is not None, "asked for only then"
        rows = zip(scene.features, scene.positions, scene.orientations, strict=True)
        items = tuple(
            SceneObject(f"thing-{number}", symbol, tuple(map(float, one)), _triple(at), _four(turn))
            for (number, (one, at, turn)), symbol in zip(
                enumerate(rows, start=1), self.session.library.categorise(scene.features), strict=True
            )
        )
        self.view.show_objects(items, {})

    def _show_seen(self, seen: Seen) -> None:
        self.drawn += 1
        with suppress(KeyError):  # the table was set anew meanwhile
            self.view.show(seen)

    def _show_rest(self) -> None:
        """Put objects where they are between two steps, as after a nudge."""
        running = self.session.running
        problem, rest = running.problem, running.rest
        if problem is None or rest is None or rest is self._rested:
            return
        with suppress(KeyError):  # the table was set anew meanwhile
            rows = zip(problem.object_names, rest.positions, rest.orientations, strict=True)
            for name, position, turn in rows:
                self.view.show_object(name, position, turn)
        self._rested = rest


def _triple(row: np.ndarray) -> tuple[float, float, float]:
    x, y, z = row.tolist()
    return x, y, z


def _four(row: np.ndarray) -> tuple[float, float, float, float]:
    x, y, z, w = row.tolist()
    return x, y, z, w
