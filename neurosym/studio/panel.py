"""What the panels of a page have in common."""

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

import viser

from neurosym.studio.session import Session, Topic

if TYPE_CHECKING:
    from neurosym.studio.page import Page


class Panel:
    """A part of the page beside the table.

    Args:
        page: The page.
    """

    def __init__(self, page: "Page"):
        self.page = page
        self.gui: viser.GuiApi = page.server.gui
        self.build()

    @property
    def session(self) -> Session:
        """What the page shows."""
        return self.page.session

    def build(self) -> None:
        """Make the fields and buttons."""
        raise NotImplementedError

    def refresh(self, topics: set[Topic]) -> None:
        """Show what has changed."""

    def button(
        self, label: str, act: Callable[[], object], hint: str = "", **options: Any
    ) -> viser.GuiButtonHandle:
        """Add a button.

        Args:
            label: What stands on it.
            act: What it does.
            hint: What is said when the pointer is over it.
            options: As of viser.
        """
        made = self.gui.add_button(label, hint=hint or None, **options)

        def clicked(_: Any) -> None:
            act()

        made.on_click(clicked)
        return made


def by_user(act: Callable[[Any], None]) -> Callable[[Any], None]:
    """Have something done when a user changed a field, and not when the page did.

    Args:
        act: Given the field's value.
    """

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
