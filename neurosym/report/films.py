"""Runs on the page whose view can be turned: what was seen of each, and one viewer for all of them."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from neurosym.report.examples import Example

Film = Callable[[Example], bytes]
"""Performs a run again and returns what was seen as one HTML file, empty if nothing moves."""
_BEGIN, _END = 'window.__VISER_EMBED_DATA__="', '"'  # what the viewer shows stands between these


@dataclass(frozen=True, slots=True)
class Films:
    """Films that share a viewer.

    Attributes:
        before: The viewer as HTML, up to what it shows.
        after: The rest of it.
        seen: What it shows, by the name of the run.
    """

    before: str
    after: str
    seen: Mapping[str, str]


def films_of(pages: Mapping[str, bytes]) -> Films | None:
    """Take films, as whole pages by run, apart that have the same viewer; None if there are none."""
    viewers, seen = dict[tuple[str, str], None](), dict[str, str]()
    for name, page in pages.items():
        before, begin, rest = page.decode().partition(_BEGIN)
        shown, end, after = rest.partition(_END)
        if begin and end:
            viewers[before + begin, end + after] = None
            seen[name] = shown
    if not seen:
        return None
    (before, after), *others = viewers
    assert not others, "all films have the same viewer"
    return Films(before, after, seen)
