"""Film a shipped run of each domain for docs/index.md: `python -m tools.draw_films` (or `make films`).

The run is performed again, seen from further away, so that the arm is whole. A line under the picture names
each step.
"""

import io
import sys
from collections.abc import Sequence
from pathlib import Path

import numpy as np
import tyro
from PIL import Image, ImageDraw, ImageFont

from neurosym.execution.performance import rerun
from neurosym.execution.record import Run, StepRecord
from neurosym.files import read_json, write_atomically
from neurosym.grounding import Grounding
from neurosym.pictures.film import Sparing
from neurosym.problems import Problem
from neurosym.report.run_film import step_named
from neurosym.sim import camera
from neurosym.stages.console import say
from neurosym.stages.painting import painted_world
from neurosym.world import DOT_COLOURS, Frame
from tools.benchmarks.options import ROOT

IMAGES = ROOT / "docs/images"
FILMS = {
    "tabletop": ("tabletop", "task-18"),
    "tabletop-paper": ("tabletop-paper", "task-17"),
    "row": ("places", "row-4-12"),
    "camera": ("camera", "anywhere-3-08"),
    "boxes": ("towers", "boxes-6-12"),
}
"""The domain and the problem of each film, by the name of its file."""
SIZE, FOOT, TEXT = (400, 300), 26, 15  # pixels
COLOURS = 64
KILOBYTES, SECONDS = 500, 15.0
"""What a film has at most."""
FRAME, STEP_END, END = 80, 900, 1800  # how long a picture is shown [ms]
PICTURES = 120
"""How many pictures of motion a film has at most; as many fewer as its kilobytes ask for."""
Shot = tuple[Image.Image, int]
"""A picture, and how long it is shown [ms]."""


class Shooting:
    """Pictures of a run, step by step; `every` so many are drawn."""

    def __init__(self, every: int):
        self.every = every
        self.steps: list[list[Frame]] = []
        self._seen, self._taken = 0, list[Frame]()

    def add_frame(self, frame: Frame, phase: str) -> None:  # noqa: ARG002 (a `FrameSink`)
        """Keep a picture, if it was drawn."""
        if self._seen % self.every == 0:
            self._taken.append(frame)
        self._seen += 1

    def end_step(self, record: StepRecord) -> None:  # noqa: ARG002 (called with each step)
        """Begin with the pictures of the next step."""
        self.steps.append(self._taken)
        self._seen, self._taken = 0, []


def shoot(domain: Path, problem_name: str) -> tuple[Run, list[list[Frame]]]:
    """Perform a shipped run again, and return the pictures of each step."""
    run = read_json(domain / "runs" / f"{problem_name}.fast-downward.run.json", Run)
    problem = Problem.load(domain / "problems" / f"{problem_name}.scene.json")
    grounding = Grounding.load(domain / "grounding.json")
    every = 10**9  # the first time nothing is drawn, and pictures are counted
    for _ in range(2):
        world, shooting = painted_world(domain / "world.toml"), Shooting(every if every < 10**9 else 1)
        if isinstance(world, Sparing):
            world.wanted_pictures = range(0, 10**9, every)
        rerun(world, problem, grounding, run, on_frame=shooting.add_frame, on_step=shooting.end_step)
        every = max(1, sum(map(len, shooting.steps)) // PICTURES)
    return run, shooting.steps


def framed(frame: Frame, line: str) -> Image.Image:
    """Return a picture at the size of a film, with a line under it."""
    (width, height), font = SIZE, ImageFont.load_default(size=TEXT)
    image = Image.new("RGB", (width, height + FOOT), "white")
    image.paste(Image.fromarray(frame).resize(SIZE, Image.Resampling.LANCZOS))
    ImageDraw.Draw(image).text((width / 2, height + FOOT / 2), line, fill="black", font=font, anchor="mm")
    return image


def cut(run: Run, steps: Sequence[Sequence[Frame]], thin: int) -> list[Shot]:
    """Put the pictures of all steps behind one another, every `thin`th; the end of a step stands still."""
    shots = list[Shot]()
    for number, (record, frames) in enumerate(zip(run.steps, steps, strict=True), start=1):
        line = f"{number} of {len(run.steps)}: {step_named(record)}"
        shots += [(framed(frame, line), FRAME) for frame in frames[:-1:thin]]
        shots.append((framed(frames[-1], line), STEP_END))
    frame = steps[-1][-1]
    return [*shots, (framed(frame, "goal reached" if run.reached else "goal missed"), END)]


def encoded(shots: Sequence[Shot]) -> bytes:
    """Return a film as a GIF, whose pictures share few colours."""
    samples = [np.asarray(image) for image, _ in shots[:: max(1, len(shots) // 8)]]
    samples += [np.full_like(samples[0][:FOOT], colour) for colour in DOT_COLOURS]  # small, and to be seen
    palette = Image.fromarray(np.vstack(samples)).quantize(COLOURS, method=Image.Quantize.MEDIANCUT)
    images = [image.quantize(palette=palette, dither=Image.Dither.NONE) for image, _ in shots]
    file, durations = io.BytesIO(), [duration for _, duration in shots]
    images[0].save(file, "GIF", save_all=True, append_images=images[1:], duration=durations, loop=0)
    return file.getvalue()


def film(domain: Path, problem_name: str) -> tuple[bytes, float]:
    """Return a film of a shipped run that is small and short enough, and its seconds."""
    run, steps = shoot(domain, problem_name)
    for thin in range(1, PICTURES):
        shots = cut(run, steps, thin)
        file, seconds = encoded(shots), sum(duration for _, duration in shots) / 1000
        if len(file) <= KILOBYTES * 1000 and seconds <= SECONDS:
            break
    return file, seconds


def main(names: tyro.conf.Positional[tuple[str, ...]] = (*FILMS,), folder: Path = IMAGES) -> None:
    """Write films, each named as in `FILMS`."""
    if unknown := set(names) - FILMS.keys():
        sys.exit(f"There is no film {min(unknown)!r}; there are {', '.join(FILMS)}.")
    camera.DISTANCE, camera.LOOKS_AT_HEIGHT = 2.3, 0.34  # the arm whole
    for name in names:
        domain, problem = FILMS[name]
        file, seconds = film(ROOT / "domains" / domain, problem)
        write_atomically(folder / f"{name}.gif", file)
        say(f"wrote {folder / name}.gif: {seconds:.1f} s, {len(file) // 1000} kB")


if __name__ == "__main__":
    tyro.cli(main)
