"""A comparison of planners as a picture: a group of bars for each planner."""

import io
from collections.abc import Mapping
from pathlib import Path

from PIL import Image, ImageDraw, ImageFont

from neurosym.evaluation.comparison_summary import Comparison
from neurosym.files import write_atomically

MEASURES: Mapping[str, tuple[str, tuple[int, int, int]]] = {
    "found": ("found", (188, 196, 206)),
    "valid": ("valid in the model", (124, 152, 184)),
    "reached": ("reached, followed blindly", (230, 159, 0)),
    "reached_with_replanning": ("reached with replanning", (0, 114, 110)),
}
"""What each bar shows, by the name of its count, and its colour."""
_HEIGHT, _BAR, _GAP, _EDGE, _TEXT = 320, 46, 50, 60, 16
_INK, _LINE = (40, 40, 40), (220, 220, 220)


def draw_comparison(comparison: Comparison, title: str, path: Path) -> None:
    """Draw which share of the tasks each planner solved and reached.

    Args:
        comparison: The counts.
        title: A line above.
        path: The PNG.
    """
    font = ImageFont.load_default(_TEXT)
    group = len(MEASURES) * _BAR + _GAP
    width = max(2 * _EDGE + len(comparison.planners) * group, 760)
    picture = Image.new("RGB", (width, _HEIGHT + 2 * _EDGE + 40), "white")
    pen = ImageDraw.Draw(picture)
    pen.text((_EDGE, 14), title, _INK, font)
    for share in (0.0, 0.25, 0.5, 0.75, 1.0):
        y = _EDGE + _HEIGHT * (1 - share)
        pen.line((_EDGE, y, width - _EDGE / 2, y), _LINE)
        pen.text((_EDGE - 8, y), f"{share:.0%}", _INK, font, anchor="rm")
    for number, (name, tally) in enumerate(comparison.planners.items()):
        left = _EDGE + _GAP / 2 + number * group
        for place, (measure, (_, colour)) in enumerate(MEASURES.items()):
            share = getattr(tally, measure) / max(comparison.counted, 1)
            x, top = left + place * _BAR, _EDGE + _HEIGHT * (1 - share)
            pen.rectangle((x, top, x + _BAR - 6, _EDGE + _HEIGHT), colour)
            pen.text((x + _BAR / 2 - 3, top - 4), f"{100 * share:.0f}", _INK, font, anchor="mb")
        pen.text((left + len(MEASURES) * _BAR / 2, _EDGE + _HEIGHT + 8), name, _INK, font, anchor="mt")
    x, y = _EDGE, _EDGE + _HEIGHT + 44
    for words, colour in MEASURES.values():
        pen.rectangle((x, y, x + 14, y + 14), colour)
        pen.text((x + 20, y + 7), words, _INK, font, anchor="lm")
        x += 40 + round(pen.textlength(words, font))
    buffer = io.BytesIO()
    picture.save(buffer, "PNG", optimize=True)
    write_atomically(path, buffer.getvalue())
