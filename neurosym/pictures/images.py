"""Files of pictures: an animated GIF of a motion, or a sheet with a row of captioned pictures for each."""

import io
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from neurosym.arrays import UInt8
from neurosym.errors import CannotWrite, InvalidValue
from neurosym.files import check_writable, write_atomically
from neurosym.world import Frame

ENDINGS = (".png", ".gif")
GIF_SIZE = (480, 360)
FRAME_MILLISECONDS = 50
PAUSE_MILLISECONDS = 1500
STRIP_SIZE = (640, 480)
_CAPTION, _GAP = 34, 8
_TEXT = 18
_GIF_TEXT = 14
_PALETTE_SAMPLES = 6


@dataclass(frozen=True, slots=True, eq=False)
class Row:
    """Pictures that belong together.

    Attributes:
        title: A line above them; none if empty.
        frames: The pictures, at least one.
        captions: A line under each.
    """

    title: str
    frames: tuple[Frame, ...]
    captions: tuple[str, ...]

    @property
    def height(self) -> int:
        """How much of a sheet it takes [pixels]."""
        return STRIP_SIZE[1] + _CAPTION * (2 if self.title else 1)


def check_picture_path(path: Path, endings: Sequence[str] = ENDINGS) -> None:
    """Raise `InvalidValue` unless a picture can be written to a file, whose name can end so."""
    if path.suffix.lower() not in endings:
        raise InvalidValue(
            f"No picture can be written to {path}; name a file that ends in {' or '.join(endings)}."
        )
    if path.is_dir() or not path.absolute().parent.is_dir():
        raise InvalidValue(f"No picture can be written to {path}; name a file in an existing folder.")
    try:
        check_writable(path)
    except CannotWrite as error:
        said = f"No picture can be written to {path} ({error.reason})"
        raise InvalidValue(f"{said}; name a file in a folder that can be written.") from error


def shrink(frame: Frame) -> UInt8[np.ndarray, "strip_height strip_width 3"]:
    """Bring a picture to the size that it has in a strip, smoothly."""
    return np.asarray(Image.fromarray(frame).resize(STRIP_SIZE, Image.Resampling.LANCZOS))


def save_gif(path: Path, frames: Sequence[Frame], captions: Sequence[str] = ()) -> None:
    """Write one or more pictures as a GIF that pauses on the last, each with a line at its foot if given."""
    lines = captions or [""] * len(frames)
    images = _with_one_palette([_gif_image(*pair) for pair in zip(frames, lines, strict=True)])
    durations = [FRAME_MILLISECONDS] * (len(images) - 1) + [PAUSE_MILLISECONDS]
    buffer = io.BytesIO()
    images[0].save(buffer, "GIF", save_all=True, append_images=images[1:], duration=durations, loop=0)
    write_atomically(path, buffer.getvalue())


def _with_one_palette(images: Sequence[Image.Image]) -> list[Image.Image]:
    """Reduce images to 256 colours that they share, among them those of small things like dots."""
    samples = images[:: max(1, len(images) // _PALETTE_SAMPLES)]
    together = Image.fromarray(np.vstack([np.asarray(image) for image in samples]))
    palette = together.quantize(256, method=Image.Quantize.FASTOCTREE)
    return [image.quantize(palette=palette, dither=Image.Dither.NONE) for image in images]


def save_sheet(path: Path, rows: Sequence[Row]) -> None:
    """Write rows of pictures one below the other, as a PNG."""
    width = STRIP_SIZE[0] * max(len(row.frames) for row in rows)
    sheet = Image.new("RGB", (width, sum(row.height + _GAP for row in rows) - _GAP), "white")
    top = 0
    for row in rows:
        _paste(sheet, row, top)
        top += row.height + _GAP
    buffer = io.BytesIO()
    sheet.save(buffer, "PNG", optimize=True)
    write_atomically(path, buffer.getvalue())


def _paste(sheet: Image.Image, row: Row, top: int) -> None:
    width, height = STRIP_SIZE
    draw = ImageDraw.Draw(sheet)
    font = ImageFont.load_default(size=_TEXT)
    if row.title:
        draw.text((_CAPTION / 3, top + _CAPTION / 2), row.title, fill="black", font=font, anchor="lm")
        top += _CAPTION
    for index, (frame, caption) in enumerate(zip(row.frames, row.captions, strict=True)):
        sheet.paste(Image.fromarray(shrink(frame)), (index * width, top))
        middle = (index * width + width / 2, top + height + _CAPTION / 2)
        draw.text(middle, caption, fill="black", font=font, anchor="mm")


def _gif_image(frame: Frame, caption: str) -> Image.Image:
    image = Image.fromarray(frame).resize(GIF_SIZE, Image.Resampling.LANCZOS)
    if caption:
        place = (GIF_SIZE[0] / 2, GIF_SIZE[1] - _GIF_TEXT)
        font = ImageFont.load_default(size=_GIF_TEXT)
        draw = ImageDraw.Draw(image)
        draw.text(place, caption, fill="black", font=font, anchor="mm", stroke_width=2, stroke_fill="white")
    return image
