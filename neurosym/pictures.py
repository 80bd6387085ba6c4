"""Pictures of a run: an animated GIF of the motion, or a strip with one picture a step."""

import io
from collections.abc import Sequence
from pathlib import Path

from PIL import Image, ImageDraw, ImageFont

from neurosym.files import write_atomically
from neurosym.world import Frame

GIF_SIZE = (480, 360)
FRAME_MILLISECONDS = 50
PAUSE_MILLISECONDS = 1500
STRIP_SIZE = (640, 480)
_CAPTION = 34


def save_gif(path: Path, frames: Sequence[Frame]) -> None:
    """Write an animated GIF that pauses on its last picture.

    Args:
        path: Where the file shall stand.
        frames: The pictures, at least one.
    """
    images = [Image.fromarray(frame).resize(GIF_SIZE) for frame in frames]
    durations = [FRAME_MILLISECONDS] * (len(images) - 1) + [PAUSE_MILLISECONDS]
    buffer = io.BytesIO()
    images[0].save(buffer, "GIF", save_all=True, append_images=images[1:], duration=durations, loop=0)
    write_atomically(path, buffer.getvalue())


def save_strip(path: Path, frames: Sequence[Frame], captions: Sequence[str]) -> None:
    """Write pictures side by side, each with a caption, as a PNG.

    Args:
        path: Where the file shall stand.
        frames: The pictures, at least one.
        captions: A line under each.
    """
    width, height = STRIP_SIZE
    strip = Image.new("RGB", (width * len(frames), height + _CAPTION), "white")
    draw = ImageDraw.Draw(strip)
    font = ImageFont.load_default(size=18)
    for index, (frame, caption) in enumerate(zip(frames, captions, strict=True)):
        strip.paste(Image.fromarray(frame).resize(STRIP_SIZE), (index * width, 0))
        middle = (index * width + width / 2, height + _CAPTION / 2)
        draw.text(middle, caption, fill="black", font=font, anchor="mm")
    buffer = io.BytesIO()
    strip.save(buffer, "PNG")
    write_atomically(path, buffer.getvalue())
