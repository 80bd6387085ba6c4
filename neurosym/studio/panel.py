"""What the panels of a page have in common, and what they are about."""

import threading
from collections.abc import Callable
from typing import Any

import numpy as np
import viser

from neurosym.problems import SceneObject
from neurosym.studio.desk import Topic
from neurosym.studio.overlays import Overlays
from neurosym.studio.session import Session
from neurosym.studio.view import COLOURS

DARK, LIGHT = (24, 26, 30), (245, 246, 248)


class Board:
    """What panels are about: a session, which of its objects is chosen, and what is drawn over the table.

    Args:
        server: Serves the page of this session and no other.
        session: What is shown.

    Attributes:
        overlays: Layers over the table.
        selected: Name of the object that the panels are about.
    """

    def __init__(self, server: viser.ViserServer, session: Session):
        self.server, self.session = server, session
        self.overlays = Overlays(server.scene)
        self.selected = session.problem.object_names[0] if session.problem else ""
        self._topics: set[Topic] = set()
        self._lock, self._has_changed = threading.Lock(), threading.Event()

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


class Panel:
    """A part of the page beside the table.

    Args:
        page: What it is about.
    """

    def __init__(self, page: Board):
        self.page, self.session = page, page.session
        self.gui: viser.GuiApi = page.server.gui
        self.build()

    def build(self) -> None:
        """Make the fields and buttons."""
        raise NotImplementedError

    def refresh(self, topics: set[Topic]) -> None:
        """Show what has changed."""

    def button(
        self, label: str, act: Callable[[], object], hint: str = "", **options: Any
    ) -> viser.GuiButtonHandle:
        """Add a button that does something, and says a hint when the pointer is over it."""
        made = self.gui.add_button(label, hint=hint or None, **options)

        @made.on_click
        def clicked(_: Any) -> None:
            act()

        return made


def by_user(act: Callable[[Any], None]) -> Callable[[Any], None]:
    """Have something done with a field's value when a user changed it, and not when the page did."""

    def changed(event: Any) -> None:
        if event.client is not None:
            act(event.target.value)

    return changed


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
