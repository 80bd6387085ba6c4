"""The page around the panels: viser's own, with a title, a style and a script of ours.

Viser is a page that builds itself. Ours covers it until the panels are there, names what viser leaves without
a name, and lays it out in small windows.
"""

import gzip
import json
import re
from collections.abc import Mapping, Sequence
from html import escape
from pathlib import Path

import viser

from neurosym.files import read_text
from neurosym.world import Table

_TEMPLATES = Path(__file__).with_name("templates")
_VISER = Path(viser.__file__).with_name("client") / "build" / "index.html"
_ICON = (
    "data:image/svg+xml,%3Csvg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 16 16'%3E"
    "%3Cpath fill='%23006b55' d='M0 0h7v16H0zM9 0h7v16H9z'/%3E%3C/svg%3E"
)
_OPENING = (
    '<h1 class="unseen">{title}</h1>'
    '<div id="cover" role="status">Opening the table; this takes a few seconds.</div>'
    '<div id="live" class="unseen" role="status" aria-live="polite"></div>'
)


def page_html(title: str, table: Table) -> bytes:
    """Return the page that a browser is given, packed by gzip.

    Args:
        title: What stands on the browser's tab, and is read out first.
        table: Within whose ends a user is told to stay while typing.
    """
    style, script = (read_text(_TEMPLATES / f"page.{kind}") for kind in ("css", "js"))
    told = json.dumps(_bounds_of(table)).replace("<", "\\u003c")
    ours = f"<style>{style}</style><script>window.neurosymBounds = {told};\n{script}</script>"
    page = _headed(read_text(_VISER), title, ours)
    opening = f'{_OPENING.format(title=escape(title))}<main id="root"></main>'
    return gzip.compress(page.replace('<div id="root"></div>', opening, 1).encode())


def _bounds_of(table: Table) -> Mapping[str, Sequence[tuple[float, float]]]:
    """Return within what the numbers of fields lie whose ends viser does not tell, by their labels."""
    ends = {"Stands at x, y": (table.x, table.y), "Goal x, y, z": (table.x, table.y)}
    return {**ends, "Tolerance [mm]": [(1, 500)], "Seed": [(0, 2**53)], "Interaction": [(0, 2**53)]}


def film_html(page: str, title: str) -> str:
    """Return a run that viser has recorded as a page, with a title and names for what it is played by."""
    return _headed(page, title, f"<script>{read_text(_TEMPLATES / 'film.js')}</script>")


def _headed(page: str, title: str, ours: str) -> str:
    """Put our title, icon and what else is ours into the head of viser's page."""
    head = f'<title>{escape(title)}</title><link rel="icon" href="{_ICON}"/>{ours}'
    page = re.sub(r'<link\s+rel="icon".*?/>|<meta name="description".*?/>', "", page, flags=re.DOTALL)
    return page.replace("<title>Viser</title>", head, 1)
