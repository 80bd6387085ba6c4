"""The map of symbols on a panel: the codes over two sizes, and the object at hand as a dot.

The map is drawn anew when anything but these two sizes changes. The page's script draws the dot, and writes
where it is dragged to into a field that is not seen.
"""

import numpy as np

from neurosym.contract import limits_of
from neurosym.report.drawings import chip, map_drawing, object_drawing
from neurosym.studio import words
from neurosym.studio.desk import Topic
from neurosym.studio.page import Page, Panel, heard, set_content

FIELD = "Place on the map"
"""The label of the field; the page's script knows it by that."""


class MapField(Panel):
    """The map."""

    def build(self) -> None:
        """Make it; without limits of objects there is nothing that could be dragged, and no field."""
        self._drawn: tuple[float, ...] | None = None  # what the map was drawn for
        self._map, self._dot = self.gui.add_html(""), self.gui.add_html("")
        if limits_of(self.session.library.world):
            heard(self.gui.add_text(FIELD, ""), self.take)

    def show(self, is_visible: bool) -> None:
        """Show the map, or hide it."""
        self._map.visible = self._dot.visible = is_visible

    def refresh(self, topics: set[Topic]) -> None:
        """Show where the object that is chosen lies on the map."""
        item = self.page.item
        if item is None or "scene" not in topics:
            return
        atlas, palette = self.session.library.atlas, self.page.view.palette
        others = tuple(value for number, value in enumerate(item.features) if number not in atlas.axes)
        if others != self._drawn:
            self._drawn, shown = others, atlas.map(item.features)
            told = f"Which bits an object has by its {' and '.join(axis.word for axis in shown.axes)}:"
            hint = "Drag the dot, or press anywhere: the object gets that size at once."
            drawn = map_drawing(shown, palette, title=told, name="map")
            said = words.paragraph(hint, words.DIM) if limits_of(self.session.library.world) else ""
            set_content(self._map, words.paragraph(told) + drawn + said)
        at = " ".join(f"{value:.5g}" for value in item.features)
        set_content(self._dot, f'<span hidden data-map-at="{at}"></span>')

    def take(self, told: str) -> None:
        """Give the object that is chosen the sizes of a place on the map, in whole millimetres."""
        item, axes = self.page.item, self.session.library.atlas.axes
        try:
            values = np.round([float(part) for part in told.split()], 3).tolist()
        except ValueError:
            return
        if item is not None and len(values) == len(axes):
            features = dict(enumerate(item.features)) | dict(zip(axes, values, strict=True))
            self.session.resize(item.name, tuple(features.values()))


def of_each(page: Page) -> str:
    """Draw some objects of each category, the most frequent first, as HTML."""
    library, palette = page.session.library, page.view.palette
    rows = []
    for symbol in library.atlas.shares():
        seen = (
            object_drawing(one, library.atlas.features, palette(symbol), width=58, height=48)
            for one in library.atlas.examples(symbol)
        )
        name = words.safe(words.plain_name(symbol, library.grounding))
        rows.append((f"{chip(symbol, palette)}<br>{name}", "".join(seen)))
    return words.table(("category", "some of its objects"), rows, label="objects of each category")


def category_of(page: Page) -> str:
    """Say of which category the object that is chosen is, as HTML."""
    if (item := page.item) is None:
        return ""
    name = words.plain_name(item.category, page.session.library.grounding)
    return f"<p>{chip(item.category, page.view.palette)} {words.safe(f'{item.name}: {name}')}</p>"
