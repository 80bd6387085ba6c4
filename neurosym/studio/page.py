"""The page of a session: what is seen of it in three dimensions, and what its panels have in common.

The session says by topic what has changed, from whatever thread. One thread of the page draws it, at most
`_MOST_OFTEN` times a second, so that a drag or a run is never drawn later than it happens.
"""

import threading
import time
from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping
from typing import Any, TypeVar

import numpy as np
import viser

from neurosym.operators import vector
from neurosym.problems import Problem, SceneObject
from neurosym.studio.desk import Topic
from neurosym.studio.session import Session
from neurosym.studio.view import Grab, Overlays, View, aim_camera, over
from neurosym.studio.words import three_numbers
from neurosym.world import Scene

_Field = TypeVar("_Field", bound=Any)
_MOST_OFTEN = 30.0  # how often a page is drawn at most [1/s]
_WIDTH = 400  # of the panels [pixels]
_DARK, _LIGHT = (24, 26, 30), (245, 246, 248)


class Page:
    """The page of a session, on a server of its own; the first of its panels stands above the tabs."""

    def __init__(
        self, server: viser.ViserServer, session: Session, panels: Mapping[str, Callable[["Page"], "Panel"]]
    ):
        self.server, self.session = server, session
        self.selected = session.problem.object_names[0] if session.problem else ""  # what panels are about
        self._topics: set[Topic] = {"scene", "plan", "run", "status"}
        self._lock, self._has_changed = threading.Lock(), threading.Event()
        self._has_changed.set()
        self._grabs: dict[tuple[str, str], tuple[Grab, Problem]] = {}
        self._is_closed, self.drawn = False, 0  # poses so far
        self._rested: Scene | None = None
        self.set_dark(False)
        server.gui.main_panel.dock_right()
        server.gui.main_panel.set_width(_WIDTH)
        aim_camera(server, session.library)
        self.view = View(server.scene, session.library, self._grabbed)
        self.overlays = Overlays(server.scene)
        (_, head), *others = panels.items()
        self.panels = [head(self)]
        tabs = server.gui.add_tab_group()
        for label, panel in others:
            with tabs.add_tab(label):
                self.panels.append(panel(self))
        session.listen(self.hear)
        self._thread = threading.Thread(target=self._draw_all, daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Stop drawing, and end what the session works on."""
        self._is_closed = True
        self._has_changed.set()
        self._thread.join(10.0)  # it may just be reading the network
        self.session.close()

    def hear(self, topic: Topic) -> None:
        """Have something drawn soon."""
        with self._lock:
            self._topics.add(topic)
        self._has_changed.set()

    def select(self, name: str) -> None:
        """Choose the object that the panels are about."""
        if self.session.problem and name in self.session.problem.object_names and name != self.selected:
            self.selected = name
            self.hear("scene")

    @property
    def item(self) -> SceneObject | None:
        """The object that the panels are about, if there is any, where it is by now."""
        problem = self.session.running.as_it_stands()
        if problem is None:
            return None
        if self.selected not in problem.object_names:
            self.selected = problem.object_names[0]
        return problem.object_named(self.selected)

    def set_dark(self, is_dark: bool) -> None:
        """Show the page dark or light."""
        self.server.gui.configure_theme(
            dark_mode=is_dark, show_logo=False, show_share_button=False, control_width="large"
        )
        colour = _DARK if is_dark else _LIGHT
        self.server.scene.set_background_image(np.full((2, 2, 3), colour, dtype=np.uint8))

    def _grabbed(self, kind: str, name: str) -> Any:
        """Return what hears of drags of an object or its goal; in order, since it is a coroutine."""

        async def drag(event: viser.SceneNodeDragEvent[Any]) -> None:
            problem = self.session.problem
            if problem is None or name not in problem.object_names:
                return
            key, eye = (kind, name), event.client.camera.position.tolist()
            if event.phase == "start":
                centre = self.session.ghosts().get(name) if kind == "goal" else self.view.at(name)
                if centre is not None:
                    self._grabs[key] = Grab(eye, event.start_position, centre), problem
                self.select(name)
            is_end = event.phase == "end"
            grab, before = self._grabs.get(key, (None, None))
            at = grab.to(event.end_position) if grab else None
            if at is not None and kind == "goal":
                self.session.aim(name, *at)
            elif at is not None and (is_end or not self.session.is_running):
                self.session.move(name, *at)
            if is_end:
                self._grabs.pop(key, None)
                if kind == "goal":
                    self.session.drop_goal(name, before)

        return drag

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
                    for panel in self.panels:
                        panel.refresh(topics)
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
        if topics & {"scene", "run", "step"}:
            self._show_tries()
        if "pose" in topics and running.seen:
            self.drawn += 1
            self.view.show(running.seen.pose)
        if "step" in topics:
            self._show_rest()

    def _show_problem(self, problem: Problem) -> None:
        """Draw the table as it is set; after a run, as the run left it."""
        self._rested, running = None, self.session.running
        if running.scene is not None:
            self._show_scene(running.scene)
        else:
            self.view.show_problem(problem, self.session.ghosts(), self.session.complaints())
        if running.seen:
            self.view.show(running.seen.pose)
        else:
            self.view.rest()
        self._show_rest()

    def _show_tries(self) -> None:
        """Draw how motions turned out, until something else is done: a dot a try, or a ghost and an arrow."""
        running, overlays = self.session.running, self.overlays
        overlays.clear("effect")
        self.view.clear_start()
        overlays.clear("tries")
        if not running.tries:
            return
        tried = running.tries[0]
        features = self.view.items[tried.target].features
        if promise := running.promise:
            overlays.clear("rehearsals")
            ends = [(over(one.end, features), one.keeps(promise)) for one in running.tries]
            overlays.dots("tries", ends, 0.012)
            said, effect = f"promised: {three_numbers(promise.effect)}", promise.effect
        else:
            self.view.show_start(tried)
            said, effect = three_numbers(tried.effect), tried.effect
        overlays.effect(over(tried.start, features), effect, said)

    def _show_scene(self, scene: Scene) -> None:
        """Draw the objects of a scene that is not the page's own."""
        symbols = self.session.library.categorise(scene.features)
        rows = zip(symbols, scene.features, scene.positions, strict=True)
        items = tuple(
            SceneObject(f"thing-{number}", symbol, tuple(features.tolist()), vector(position))
            for number, (symbol, features, position) in enumerate(rows, start=1)
        )
        self.view.show_problem(Problem("scene", items, {}), {})
        self.view.show_bodies(scene.positions, scene.orientations)

    def _show_rest(self) -> None:
        """Put objects where they are between two steps, as after a nudge."""
        running = self.session.running
        scene, is_tried = running.here, bool(running.tries and running.seen)
        if scene and scene is not self._rested and not is_tried:
            self._rested = scene
            self.view.show_bodies(scene.positions, scene.orientations)


class Panel(ABC):
    """A part of the page beside the table."""

    def __init__(self, page: Page):
        self.page, self.session = page, page.session
        self.gui: viser.GuiApi = page.server.gui
        self.build()

    @abstractmethod
    def build(self) -> None:
        """Make the fields and buttons."""

    @abstractmethod
    def refresh(self, topics: set[Topic]) -> None:
        """Show what has changed."""

    def button(self, label: str, act: Callable[[], object], **options: Any) -> viser.GuiButtonHandle:
        """Add a button that does something."""
        made = self.gui.add_button(label, **options)

        @made.on_click
        def clicked(_: Any) -> None:
            act()

        return made


def heard(field: _Field, act: Callable[[Any], None]) -> _Field:
    """Have something done with a field's value when a user changed it, and not when the page did."""

    def changed(event: Any) -> None:
        if event.client is not None:
            act(event.target.value)

    field.on_update(changed)
    return field


def set_value(field: Any, value: Any) -> None:
    """Change a field, unless it has that value already."""
    if field.value != value:
        field.value = value


def set_content(field: Any, content: str) -> None:
    """Change what is said, unless it is said already; it keeps from the edges, and scrolls if too wide."""
    if content:
        content = f'<div style="padding:0 12px;overflow-x:auto">{content}</div>'
    if field.content != content:
        field.content = content


def set_options(field: Any, options: tuple[str, ...], value: str) -> None:
    """Change what can be chosen, and what is."""
    if field.options != options:
        field.options = options
    if value in options:
        set_value(field, value)
