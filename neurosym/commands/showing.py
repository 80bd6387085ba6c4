"""Options of the commands that run something in the world, on how it is shown."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Optional

from tyro.conf import arg

from neurosym.console import say
from neurosym.errors import InvalidValue

if TYPE_CHECKING:
    from neurosym.stages.executing import Showing


Gif = Annotated[Optional[Path], arg(help="Write an animated GIF of the run here.")]


Strip = Annotated[Optional[Path], arg(help="Write a PNG with a picture for each step here.")]


Gui = Annotated[bool, arg(help="Show the run live in a window instead.")]


def showing_of(gif: Path | None, strip: Path | None, gui: bool) -> "Showing":
    """Check what was asked for of pictures: files with the right endings, or a window."""
    from neurosym.pictures.images import check_picture_path
    from neurosym.stages.executing import Showing

    if gui and (gif or strip):
        raise InvalidValue("Give --gui or files for pictures, not both.")
    for picture, ending in ((gif, ".gif"), (strip, ".png")):
        if picture:
            check_picture_path(picture, [ending])
    return Showing(gif, strip, gui)


def say_written(*paths: Path | None) -> None:
    """Print which of some files were written."""
    for path in paths:
        if path and path.exists():
            say(f"wrote {path}")
