"""The page of a session: what is seen of it in three dimensions, and its panels.

The session says by topic what has changed, from whatever thread. One thread of the page draws it, at most
`_MOST_OFTEN` times a second, so that a drag or a run is never drawn later than it happens.
"""

import threading
import time
from typing import Any

import viser

from neurosym.errors import counted
from neurosym.operators import Vector, vector
from neurosym.problems import Problem, SceneObject
from neurosym.studio.desk import Topic
from neurosym.studio.messages import Seen
from neurosym.studio.panel import Board, Panel, RunPanel, TourPanel, by_user, set_content
from neurosym.studio.panels import PlanPanel, SymbolsPanel, TablePanel
from neurosym.studio.session import Session
from neurosym.studio.view import Grab, View, aim_camera
from neurosym.studio.words import BAD, GOOD, coloured, paragraph, safe
from neurosym.world import Scene

_MOST_OFTEN = 30.0
"""How often a page is drawn at most [1/s]."""
_WIDTH = 400
"""Of the panels [pixels]."""


class Page(Board):
    """The page of a session; all windows that look at it show the same.

    Args:
        server: Serves this page and no other.
        session: What it shows.

    Attributes:
        drawn: How many poses were drawn so far.
    """

    def __init__(self, server: viser.ViserServer, session: Session):
        super().__init__(server, session)
        self._grabs: dict[tuple[str, str], Grab] = {}
        self._before: dict[str, Problem] = {}
        self._is_closed, self.drawn = False, 0
        self._rested: Scene | None = None
        self.set_dark(False)
        server.gui.main_panel.dock_right()
        server.gui.main_panel.set_width(_WIDTH)
        aim_camera(server, session.library)
        self.view = View(server.scene, session.library, self._grabbed)
        self.panels: list[Panel] = [AboutPanel(self)]
        tabs = server.gui.add_tab_group()
        for label, panel in (
            ("Table", TablePanel),
            ("Plan", PlanPanel),
            ("Run", RunPanel),
            ("Symbols", SymbolsPanel),
            ("Tour", TourPanel),
        ):
            with tabs.add_tab(label):
                self.panels.append(panel(self))
        session.listen(self.hear)
        for topic in ("scene", "plan", "run", "status"):
            self.hear(topic)
        self._thread = threading.Thread(target=self._draw_all, daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Stop drawing, and end what the session works on."""
        self._is_closed = True
        self._has_changed.set()
        self._thread.join(2.0)
        self.session.close()

    def _grabbed(self, kind: str, name: str) -> Any:
        """Return what hears of drags of an object or its goal; in order, since it is a coroutine."""

        async def drag(event: viser.SceneNodeDragEvent[Any]) -> None:
            problem = self.session.problem
            if problem is None or name not in problem.object_names:
                return
            key, eye = (kind, name), event.client.camera.position.tolist()
            if event.phase == "start":
                centre = self.session.ghosts().get(name) if kind == "goal" else self._centre(problem, name)
                if centre is not None:
                    self._grabs[key] = Grab(eye, event.start_position, centre)
                    self._before[name] = problem
                self.select(name)
            is_end = event.phase == "end"
            at = self._grabs[key].to(event.end_position) if key in self._grabs else None
            if at is not None and kind == "goal":
                self.session.aim(name, *at)
            elif at is not None and (is_end or not self.session.running.is_active):
                self.session.move(name, *at)
            if is_end:
                self._grabs.pop(key, None)
                before = self._before.pop(name, None)
                if kind == "goal":
                    self.session.drop_goal(name, before)

        return drag

    def _centre(self, problem: Problem, name: str) -> Vector:
        """Return where an object stands now [m], during a run, too."""
        running = self.session.running
        if running.rest is not None and running.is_active:
            return vector(running.rest.positions[problem.object_names.index(name)])
        return problem.object_named(name).position

    def _draw_all(self) -> None:
        while not self._is_closed:
            self._has_changed.wait()
            self._has_changed.clear()
            with self._lock:
                topics, self._topics = self._topics, set()
            began = time.monotonic()
            try:
                with self.server.atomic():
                    self._draw(topics)
            except Exception as error:  # the page goes on, whatever one drawing of it does
                self.session.say(f"The page could not be drawn: {type(error).__name__}", is_bad=True)
            time.sleep(max(0.0, 1 / _MOST_OFTEN - (time.monotonic() - began)))

    def _draw(self, topics: set[Topic]) -> None:
        session, problem, running = self.session, self.session.problem, self.session.running
        if problem is not None and not running.is_active:
            if topics & {"scene", "run"}:
                self._show_problem(problem)
            if "place" in topics:
                self.view.place(problem, session.ghosts(), session.complaints())
        if "run" in topics and running.scene is not None and running.is_active:
            self._show_scene(running.scene)
        if "pose" in topics and running.seen:
            self._show_seen(running.seen[-1])
        if "step" in topics:
            self._show_rest()
        for panel in self.panels:
            panel.refresh(topics)

    def _show_problem(self, problem: Problem) -> None:
        """Draw the table as it is set; after a run, as the run left it."""
        self._rested = None
        self.view.show_problem(problem, self.session.ghosts(), self.session.complaints())
        if self.session.running.seen and self.session.running.problem is problem:
            self._show_seen(self.session.running.seen[-1])
        else:
            self.view.rest()
            self._show_rest()

    def _show_scene(self, scene: Scene) -> None:
        """Draw the objects of a scene that is not the page's own."""
        symbols = self.session.library.categorise(scene.features)
        items = tuple(
            SceneObject(f"thing-{number}", symbol, tuple(features.tolist()), vector(position))
            for number, (symbol, features, position) in enumerate(
                zip(symbols, scene.features, scene.positions, strict=True), start=1
            )
        )
        self.view.show_problem(Problem("scene", items, {}), {})
        self.view.show_bodies(scene.positions, scene.orientations)

    def _show_seen(self, seen: Seen) -> None:
        self.drawn += 1
        self.view.show(seen.pose)

    def _show_rest(self) -> None:
        """Put objects where they are between two steps, as after a nudge."""
        rest = self.session.running.rest
        if rest is not None and rest is not self._rested:
            self.view.show_bodies(rest.positions, rest.orientations)
            self._rested = rest


class AboutPanel(Panel):
    """What stands above the tabs: what the page says of itself, and what is wrong on the table."""

    def build(self) -> None:
        """Make it."""
        self._said = self.gui.add_html("")
        self.gui.add_checkbox("Dark", False).on_update(by_user(self.page.set_dark))

    def refresh(self, topics: set[Topic]) -> None:
        """Say it anew."""
        if topics - {"pose"}:
            set_content(self._said, self.text())

    def text(self) -> str:
        """Return what is said, as HTML."""
        session = self.session
        word, library = session.word, session.library
        name = session.problem.name if session.problem else "no object yet"
        lines = [paragraph(f"<b>{safe(library.name)}</b> · {safe(name)}")]
        if word.text:
            said = coloured(word.text, BAD if word.is_bad else GOOD)
            lines.append(f'<div role="status" aria-live="polite">{paragraph(said)}</div>')
        else:
            lines.append(paragraph("New here? The panel Tour shows in six cards what this robot learned."))
        for place, what in ((session.place, "plan"), (session.running.place, "run")):
            if place:
                lines.append(paragraph(safe(f"waiting in line: {counted(place, what)} with this one")))
        lines += [paragraph(coloured(why, BAD)) for why in session.complaints().values()]
        lines += [paragraph(coloured(f"damaged: {one}", BAD)) for one in library.damage]
        return "".join(lines)
