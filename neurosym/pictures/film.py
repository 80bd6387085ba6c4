"""Films: the pictures of an interaction or of a whole run, and which of them tell what happened."""

import io
import time
from collections.abc import Callable, Container, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol, TypeVar, runtime_checkable

import msgspec
import numpy as np
from PIL import Image, ImageDraw, ImageFont

from neurosym.checks import UInt8
from neurosym.errors import InvalidValue, counted
from neurosym.execution.performance import nudged, perform
from neurosym.execution.record import Run, StepRecord
from neurosym.files import write_atomically
from neurosym.grounding import Grounding
from neurosym.operators import TOLERANCE, Categorise, Operator
from neurosym.pictures.motions import Motion, operator_motions, operators_of
from neurosym.problems import Problem
from neurosym.world import Frame, FrameSink, Outcome, Pictured, Scene, World

_GIF_SIZE = (480, 360)
_FRAME_MILLISECONDS, _PAUSE_MILLISECONDS = 50, 1500
STRIP_SIZE = (640, 480)
"""Size of each picture of a row [pixels]."""
_CAPTION, _GAP = 34, 8
_TEXT, _GIF_TEXT = 18, 14
_PALETTE_SAMPLES = 6
_BEFORE = "start"
"""The phase in which everything comes to rest and the hand is not yet where the motion starts."""
_WINDOW_PAUSE = 2.0  # how long a window shows how a motion ended [s]
_SAME = 0.001
"""How near every object must end to where it ended before, for a run to have gone the same way again [m]."""
_T = TypeVar("_T")


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


def _shrink(frame: Frame) -> UInt8[np.ndarray, "strip_height strip_width 3"]:
    """Bring a picture to the size that it has in a strip, smoothly."""
    return np.asarray(Image.fromarray(frame).resize(STRIP_SIZE, Image.Resampling.LANCZOS))


def save_gif(path: Path, frames: Sequence[Frame], captions: Sequence[str] = ()) -> None:
    """Write one or more pictures as a GIF that pauses on the last, each with a line at its foot if given."""
    middle, font = (_GIF_SIZE[0] / 2, _GIF_SIZE[1] - _GIF_TEXT), ImageFont.load_default(size=_GIF_TEXT)
    images = [Image.fromarray(frame).resize(_GIF_SIZE, Image.Resampling.LANCZOS) for frame in frames]
    for image, line in zip(images, captions, strict=False):
        draw = ImageDraw.Draw(image)
        draw.text(middle, line, fill="black", font=font, anchor="mm", stroke_width=2, stroke_fill="white")
    # all share 256 colours, among them those of small things like dots
    samples = images[:: max(1, len(images) // _PALETTE_SAMPLES)]
    together = Image.fromarray(np.vstack([np.asarray(image) for image in samples]))
    palette = together.quantize(256, method=Image.Quantize.FASTOCTREE)
    images = [image.quantize(palette=palette, dither=Image.Dither.NONE) for image in images]
    durations = [_FRAME_MILLISECONDS] * (len(images) - 1) + [_PAUSE_MILLISECONDS]
    buffer = io.BytesIO()
    images[0].save(buffer, "GIF", save_all=True, append_images=images[1:], duration=durations, loop=0)
    write_atomically(path, buffer.getvalue())


def save_sheet(path: Path, rows: Sequence[Row]) -> None:
    """Write rows of pictures one below the other, as a PNG."""
    (width, height), font = STRIP_SIZE, ImageFont.load_default(size=_TEXT)
    heights = [height + _CAPTION * (2 if row.title else 1) for row in rows]
    columns = max(len(row.frames) for row in rows)
    sheet = Image.new("RGB", (width * columns, sum(heights) + _GAP * (len(rows) - 1)), "white")
    draw, top = ImageDraw.Draw(sheet), 0
    for row, taken in zip(rows, heights, strict=True):
        foot = top + taken - _CAPTION
        if row.title:
            draw.text((_CAPTION / 3, top + _CAPTION / 2), row.title, fill="black", font=font, anchor="lm")
        for index, (frame, caption) in enumerate(zip(row.frames, row.captions, strict=True)):
            sheet.paste(Image.fromarray(_shrink(frame)), (index * width, foot - height))
            middle = (index * width + width / 2, foot + _CAPTION / 2)
            draw.text(middle, caption, fill="black", font=font, anchor="mm")
        top += taken + _GAP
    buffer = io.BytesIO()
    sheet.save(buffer, "PNG", optimize=True)
    write_atomically(path, buffer.getvalue())


@runtime_checkable
class Sparing(Protocol):
    """A world that can leave out pictures of an interaction that nobody will look at.

    Attributes:
        wanted_pictures: Numbers of the pictures to draw, counted from 0 in each interaction; any others
            are blank, which is cheap, so they may come more often. If it is None, all are drawn.
    """

    wanted_pictures: Container[int] | None


@runtime_checkable
class Windowed(Protocol):
    """A world that can show live what happens in it."""

    def open_window(self) -> None:
        """Show all that happens from now on in a window; raise `InvalidValue` if there is no screen."""
        ...


def _sparing(
    world: World, attempt: Callable[[FrameSink], _T], chosen: Callable[[Sequence[str]], Sequence[int]]
) -> tuple[_T, tuple[Frame, ...], tuple[str, ...]]:
    """Perform something, and return what came of it and some of its pictures, with the phase of each.

    `chosen` numbers those, from the phases of all. A world that is `Sparing` performs it twice, first to tell
    when the phases end and then drawing only these few pictures: the same interaction has the same phases
    again.
    """
    pictures: list[tuple[Frame, str]] = []

    def keep(frame: Frame, phase: str) -> None:
        pictures.append((frame, phase))

    if isinstance(world, Sparing):
        world.wanted_pictures = ()
        attempt(keep)
        world.wanted_pictures = chosen([phase for _, phase in pictures])
        pictures.clear()
    found = attempt(keep)
    if isinstance(world, Sparing):
        world.wanted_pictures = None
    _check_drawn(world, len(pictures))
    frames, phases = zip(*pictures, strict=True)
    numbers = chosen(phases)
    return found, tuple(frames[number] for number in numbers), tuple(phases[number] for number in numbers)


def _check_drawn(world: World, pictures: int) -> None:
    if not pictures:
        raise InvalidValue(f"The {world.name} world draws no pictures of motions; have it call `on_frame`.")


def _check_pictured(world: World) -> Pictured:
    """Return a world as one that draws pictures, or raise `InvalidValue`."""
    if not isinstance(world, Pictured):
        raise InvalidValue(f"The {world.name} world draws no pictures; give it a method `picture`.")
    return world


def telling(phases: Sequence[str]) -> tuple[int, ...]:
    """Number the pictures that tell most: the first with the hand in place, and the last of each phase."""
    shown = [number for number, phase in enumerate(phases) if phase != _BEFORE] or [0]
    last = {phases[number]: number for number in shown}
    return (shown[0], *last.values())


def open_window(world: World) -> None:
    """Have a world show live what happens in it, or raise `InvalidValue` if it has no window."""
    if not isinstance(world, Windowed):
        raise InvalidValue(f"The {world.name} world has no window; leave out --gui to have pictures written.")
    world.open_window()


def hold_window() -> None:
    """Let a window show for a while how a motion ended."""
    time.sleep(_WINDOW_PAUSE)


def ignore(frame: Frame, phase: str) -> None:
    """Take no picture: the motion is seen in a window."""


def _caption_of(record: StepRecord, problem: Problem) -> str:
    """Say what a step of a run did, in a line."""
    caption = f"{record.operator} {record.object}: {record.happened}"
    is_put_down = record.happened == "held" and not _ends_in_the_air(record, problem)
    return f"{caption}, put down" if is_put_down else caption


def _ends_in_the_air(record: StepRecord, problem: Problem) -> bool:
    """Say whether the object of a step hangs from the hand at its end."""
    resting_height = problem.object_named(record.object).position[2]
    return record.happened == "held" and record.positions[record.object][2] >= resting_height + TOLERANCE


class Film:
    """The pictures of a run while it happens, and where its steps end."""

    def __init__(self, world: World, problem: Problem):
        self._problem = problem
        self._frames: list[Frame] = []
        self._start = (
            [world.picture(problem.scene(), problem.goal_positions())] if isinstance(world, Pictured) else []
        )
        self._ends: list[tuple[int, str]] = []

    def add_frame(self, frame: Frame, phase: str) -> None:  # noqa: ARG002 (a `FrameSink`)
        """Keep a picture."""
        self._frames.append(_shrink(frame))

    def end_step(self, record: StepRecord) -> None:
        """Note that the last picture shows the end of a step."""
        self._ends.append((len(self._frames) - 1, _caption_of(record, self._problem)))

    def save(self, run: Run, gif: Path | None, strip: Path | None) -> bool:
        """Write the pictures that were asked for, and say whether there are any; an empty plan has none."""
        if not self._frames:
            return False
        if gif:
            save_gif(gif, self._frames)
        if strip:
            captions = [f"{self._problem.name}: start", *(caption for _, caption in self._ends)]
            captions[-1] += ", goal reached" if run.reached else ", goal missed"
            start = (self._start or self._frames)[0]
            frames = (start, *(self._frames[end] for end, _ in self._ends))
            save_sheet(strip, [Row("", frames, tuple(captions))])
        return True


def picture_motions(world: World, motions: Sequence[Motion], path: Path) -> tuple[Outcome, ...]:
    """Perform one or more motions and write their pictures: a row of a PNG for each, or one GIF of all."""
    _check_pictured(world)
    if path.suffix.lower() != ".gif":
        filmed = [film_row(world, motion) for motion in motions]
        save_sheet(path, [row for row, _ in filmed])
        return tuple(outcome for _, outcome in filmed)
    frames, captions, outcomes = list[Frame](), list[str](), list[Outcome]()
    for motion in motions:
        begun = len(frames)

        def keep(frame: Frame, phase: str, title: str = motion.title) -> None:
            if phase != _BEFORE:
                frames.append(_shrink(frame))
                captions.append(f"{title}: {phase}")

        outcomes.append(motion.perform(world, keep))
        _check_drawn(world, len(frames) - begun)
    save_gif(path, frames, captions)
    return tuple(outcomes)


def film_row(world: World, motion: Motion) -> tuple[Row, Outcome]:
    """Perform a motion, and keep the start and the end of each phase as a row; say what it did, too."""
    outcome, frames, phases = _sparing(world, lambda keep: motion.perform(world, keep), telling)
    return Row(f"{motion.title}: {tell(outcome)}", frames, (_BEFORE, *phases[1:])), outcome


def tell(outcome: Outcome) -> str:
    """Say how an object ended, and how far it moved."""
    x, y, z = (round(1000 * float(value)) + 0 for value in outcome.effect)
    return f"{outcome.kind}, effect ({x}, {y}, {z}) mm"


def show_live(world: World, motions: Sequence[Motion]) -> tuple[Outcome, ...]:
    """Perform motions in a window, in real time; raise `InvalidValue` if there is none."""
    open_window(world)
    outcomes = []
    for motion in motions:
        outcomes.append(motion.perform(world, ignore))
        hold_window()
    return tuple(outcomes)


def picture_problem(world: World, problem: Problem, path: Path) -> None:
    """Write a picture of a problem's start with its goals transparent; the ending of the path decides how."""
    frame = _check_pictured(world).picture(problem.scene(), problem.goal_positions())
    if path.suffix.lower() == ".gif":
        save_gif(path, [frame])
    else:
        save_sheet(path, [Row("", (frame,), (f"{problem.name}: start, and its goals transparently",))])


def motion_stills(
    world: World, grounding: Grounding, name: str, categorise: Categorise, *, objects: int, seed: int
) -> Row:
    """Perform an operator as it promises, or a primitive on what it serves most objects of.

    Kept are the start and the end of each phase, as in the paper's Figure 3.

    Args:
        world: The world to act in.
        grounding: The learned domain.
        name: The operator, or the primitive's action symbol or one of its labels.
        categorise: Gives the object symbols of features.
        objects: How many objects rehearsal sampled.
        seed: Where rehearsal's draws started.

    Raises:
        UnknownChoice: If there is no such primitive or operator.
        InvalidValue: If there is no object to perform it on, or the world draws no pictures.
    """

    def served(operator: Operator) -> float:
        share = grounding.category(operator.subject).share
        return -share * operator.successes / max(1, operator.trials)

    operators = [one for one in grounding.operators if one.name == name]
    for operator in operators or sorted(operators_of(grounding, name), key=served):
        motions = operator_motions(world, grounding, (operator,), categorise, objects=objects, seed=seed)
        if motions:
            return film_row(world, motions[0])[0]
    raise InvalidValue(f"Rehearsal sampled no object that {name} was tried on.")


def run_stills(world: World, grounding: Grounding, problem: Problem, run: Run) -> Row:
    """Perform the steps of a run again, and keep the start and the end of each.

    As in the paper's Figure 4, the first picture shows the goals transparently, and the last one where the
    objects stood at the start.

    Args:
        world: The world to act in.
        grounding: What the operators' names mean.
        problem: What the run was to solve.
        run: What became of the plan.

    Raises:
        InvalidValue: If it goes another way this time, or the world draws no pictures.
        UnknownChoice: If an operator or an object is unknown here.
    """
    scene, performed = problem.scene(), [step for step in run.steps if step.happened != "not performed"]
    names = {*problem.object_names}
    if any(record.object not in names or record.positions.keys() != names for record in performed):
        raise InvalidValue(f"The run is not of the objects of {problem.name}.")
    frames = [_check_pictured(world).picture(scene, problem.goal_positions())]
    captions = [f"{problem.name}: start, goal transparent"]
    start = {item.name: item.position for item in problem.objects}
    for number, record in enumerate(performed, 1):
        for nudge in (one for one in run.nudges if one.before_step == number):
            scene = nudged(scene, nudge, problem)
            captions[-1] += f"; then {nudge.object} was nudged"
        ghosts = start if number == len(performed) else {}
        ghostly = msgspec.structs.replace(problem, goals=ghosts, relations=())
        frame, scene = _perform(world, ghostly, grounding, record, scene)
        recorded = np.array([record.positions[name] for name in problem.object_names])
        if np.abs(scene.positions - recorded).max() > _SAME:
            raise InvalidValue(
                f"Step {number} of the run of {problem.name} goes another way this time: the domain, the "
                "world or the computer is not the one that it was recorded with."
            )
        frames.append(frame)
        captions.append(f"{number}. {_caption_of(record, problem)}")
    reached = f"goal {'reached' if run.reached else 'missed'}"
    captions[-1] += f", {reached}"
    told = f"{problem.name}: {reached}, {counted(len(performed), 'step')}"
    return Row(told, tuple(frames), tuple(captions))


def _perform(
    world: World, problem: Problem, grounding: Grounding, record: StepRecord, scene: Scene
) -> tuple[Frame, Scene]:
    """Perform a step again, and return its last picture and where everything is then."""
    put_down = not _ends_in_the_air(record, problem)

    def attempt(keep: FrameSink) -> Outcome | None:
        aim = record.reference
        return perform(world, problem, grounding, record.step, scene, put_down, keep, reference=aim)

    outcome, (frame,), _ = _sparing(world, attempt, lambda phases: (len(phases) - 1,))
    return frame, outcome.end if outcome else scene
