"""What the page needs and takes long to make: pictures, each made once."""

import base64
import io
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import msgspec
import numpy as np
from PIL import Image

from neurosym.files import make_folder, write_atomically, write_json
from neurosym.grounding import Grounding
from neurosym.pictures.images import Row
from neurosym.pictures.stills import motion_stills, run_stills
from neurosym.reading import read_bytes, read_json
from neurosym.report.examples import Example
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import (
    GROUNDING,
    MODEL,
    REPORT_PICTURES,
    RUNS,
    WORLD,
    scene_file,
)
from neurosym.stages.manifest import Claim, Stage, rehearsal_options
from neurosym.world import Frame, World

STILL_SIZE = (480, 360)
_QUALITY = 80


class Strip(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A row of pictures in one image file.

    Attributes:
        title: What it shows.
        captions: What each picture shows, from left to right.
    """

    title: str
    captions: tuple[str, ...]


class Shown(msgspec.Struct, frozen=True):
    """A strip as a page shows it.

    Attributes:
        strip: What it shows.
        source: The image itself, as a data URI.
        width: How wide it is [pixels].
        height: How high it is [pixels].
    """

    strip: Strip
    source: str
    width: int
    height: int


Drawn = tuple[bytes, Strip]
"""An image, and what it shows."""


@dataclass(frozen=True, slots=True)
class Picture:
    """A strip that may be made by another process.

    Attributes:
        name: What its files are called, without an ending.
        inputs: The files of the folder that it is made from.
        make: Makes it; survives pickling.
        options: What else it depends on.
    """

    name: str
    inputs: tuple[str, ...]
    make: Callable[[], Drawn]
    options: dict[str, int]

    def stage(self, folder: DomainFolder, make: Callable[[], Drawn] | None = None) -> Stage:
        """Return the stage that makes the strip, or takes it if it is made elsewhere, into the folder."""
        files = image_file, about_file = (
            f"{REPORT_PICTURES}/{self.name}.webp",
            f"{REPORT_PICTURES}/{self.name}.json",
        )

        def work() -> None:
            image, strip = (make or self.make)()
            make_folder(folder / REPORT_PICTURES)
            write_atomically(folder / image_file, image)
            write_json(folder / about_file, strip)

        return Stage(f"picture {self.name}", self.inputs, files, work, self.options, Claim.NONE)


def motion_picture(folder: DomainFolder, kind: str, what: str) -> Picture:
    """Perform a primitive or an operator: world, model and grounding -> `pictures/report/KIND-NAME.webp`."""
    objects, seed = rehearsal_options(folder.manifest())
    make = partial(_draw_motion, folder.path, what, objects, seed)
    return Picture(f"{kind}-{what}", (WORLD, GROUNDING, MODEL), make, {"objects": objects, "seed": seed})


def run_picture(folder: DomainFolder, example: Example) -> Picture:
    """Perform a run again: world, grounding, problem and run -> `pictures/report/run-NAME.webp`."""
    inputs = (WORLD, GROUNDING, scene_file(example.problem.name), f"{RUNS}/{example.path.name}")
    return Picture(f"run-{example.name}", inputs, partial(_draw_run, folder.path, example), {})


def _draw_motion(path: Path, what: str, objects: int, seed: int) -> Drawn:
    from neurosym.learning.effect_model import EffectModel

    world, grounding = _learned(path)
    categorise = EffectModel.load(path / MODEL).object_symbols
    return _drawn(motion_stills(world, grounding, what, categorise, objects=objects, seed=seed))


def _draw_run(path: Path, example: Example) -> Drawn:
    return _drawn(run_stills(*_learned(path), example.problem, example.run))


def _learned(path: Path) -> tuple[World, Grounding]:
    from neurosym.worlds.world_file import read_world

    return read_world(path / WORLD)(), Grounding.load(path / GROUNDING)


def _drawn(row: Row) -> Drawn:
    return _side_by_side(row.frames), Strip(row.title, row.captions)


def _side_by_side(frames: Sequence[Frame]) -> bytes:
    """Return pictures side by side, as a WebP image."""
    small = [Image.fromarray(frame).resize(STILL_SIZE, Image.Resampling.LANCZOS) for frame in frames]
    buffer = io.BytesIO()
    Image.fromarray(np.hstack([np.asarray(image) for image in small])).save(buffer, "WEBP", quality=_QUALITY)
    return buffer.getvalue()


def shown(folder: DomainFolder, stage: Stage) -> Shown:
    """Read the strip that a stage made."""
    image_file, about_file = stage.outputs
    strip = read_json(folder / about_file, Strip)
    width, height = STILL_SIZE
    image = base64.b64encode(read_bytes(folder / image_file)).decode()
    return Shown(strip, f"data:image/webp;base64,{image}", width * len(strip.captions), height)
