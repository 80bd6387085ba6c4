"""Films: the pictures of an interaction or of a whole run, and which of them tell what happened."""

import time
from collections.abc import Callable, Container, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol, TypeVar, runtime_checkable

import numpy as np

from neurosym.arrays import Float
from neurosym.errors import InvalidValue
from neurosym.execution.record import Run, StepRecord
from neurosym.operators import TOLERANCE
from neurosym.pictures.images import Row, save_gif, save_sheet, shrink
from neurosym.pictures.motions import Motion
from neurosym.problems import Problem
from neurosym.table import Reference
from neurosym.world import Frame, FrameSink, Outcome, Pictured, Scene, World

T = TypeVar("T")
BEFORE = "start"
"""The phase in which everything comes to rest and the hand is not yet where the motion starts."""
WINDOW_PAUSE = 2.0
"""How long a window shows how a motion ended [s]."""


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


@dataclass(frozen=True, slots=True, eq=False)
class Take:
    """The pictures of one interaction.

    Attributes:
        outcome: What the interaction did.
        frames: The pictures.
        phases: The phase of the motion that each belongs to.
    """

    outcome: Outcome
    frames: tuple[Frame, ...]
    phases: tuple[str, ...]


def film(world: World, motion: Motion) -> Take:
    """Perform a motion, and keep every picture of it."""
    pictures: list[tuple[Frame, str]] = []

    def keep(frame: Frame, phase: str) -> None:
        if phase != BEFORE:
            pictures.append((shrink(frame), phase))

    outcome = motion.perform(world, keep)
    _check_drawn(world, len(pictures))
    return Take(outcome, tuple(frame for frame, _ in pictures), tuple(phase for _, phase in pictures))


def film_phases(
    world: World, scene: Scene, action: Float[np.ndarray, "A"], reference: Reference | None = None
) -> Take:
    """Perform an action and keep how it starts, and how each phase of the motion ends.

    Args:
        world: Where it is performed.
        scene: The objects.
        action: The action parameters.
        reference: What the action is relative to besides its target, if anything.
    """
    motion = Motion("", scene, action, reference)
    outcome, pictures = sparing(world, lambda keep: motion.perform(world, keep), telling)
    return Take(outcome, tuple(frame for frame, _ in pictures), (BEFORE, *(p for _, p in pictures[1:])))


def sparing(
    world: World, attempt: Callable[[FrameSink], T], chosen: Callable[[Sequence[str]], Sequence[int]]
) -> tuple[T, tuple[tuple[Frame, str], ...]]:
    """Perform something, and keep only some of its pictures.

    A world that is `Sparing` performs it twice, first to tell when the phases end and then drawing only
    these few pictures: the same interaction has the same phases again.

    Args:
        world: Where it is performed.
        attempt: Performs it.
        chosen: Numbers the pictures to be kept, from the phase of each.

    Returns:
        What came of it, and each picture with its phase.

    Raises:
        InvalidValue: If the world draws no pictures.
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
    return found, tuple(pictures[number] for number in chosen([phase for _, phase in pictures]))


def _check_drawn(world: World, pictures: int) -> None:
    if not pictures:
        raise InvalidValue(f"The {world.name} world draws no pictures of motions; have it call `on_frame`.")


def telling(phases: Sequence[str]) -> tuple[int, ...]:
    """Number those of pictures with such phases that tell what happened.

    That is the first with the hand in place, and the last of each phase.
    """
    shown = [number for number, phase in enumerate(phases) if phase != BEFORE] or [0]
    last = {phases[number]: number for number in shown}
    return (shown[0], *last.values())


def open_window(world: World) -> None:
    """Have a world show live what happens in it, or raise `InvalidValue` if it has no window."""
    if not isinstance(world, Windowed):
        raise InvalidValue(f"The {world.name} world has no window; leave out --gui to have pictures written.")
    world.open_window()


def hold_window() -> None:
    """Let a window show for a while how a motion ended."""
    time.sleep(WINDOW_PAUSE)


def ignore(frame: Frame, phase: str) -> None:
    """Take no picture: the motion is seen in a window."""


def caption_of(record: StepRecord, problem: Problem) -> str:
    """Say what a step of a run did, in a line."""
    caption = f"{record.operator} {record.object}: {record.happened}"
    is_put_down = record.happened == "held" and not ends_in_the_air(record, problem)
    return f"{caption}, put down" if is_put_down else caption


def ends_in_the_air(record: StepRecord, problem: Problem) -> bool:
    """Say whether the object of a step hangs from the hand at its end."""
    resting_height = problem.object_named(record.object).position[2]
    return record.happened == "held" and record.positions[record.object][2] >= resting_height + TOLERANCE


class Film:
    """The pictures of a run, and where its steps end."""

    def __init__(self, world: World, problem: Problem):
        self._problem = problem
        self._start = (
            world.picture(problem.scene(), problem.goal_positions()) if isinstance(world, Pictured) else None
        )
        self._frames: list[Frame] = []
        self._ends: list[tuple[int, str]] = []

    def add_frame(self, frame: Frame, phase: str) -> None:  # noqa: ARG002 (a `FrameSink`)
        """Keep a picture."""
        self._frames.append(shrink(frame))

    def end_step(self, record: StepRecord) -> None:
        """Note that the last picture shows the end of a step."""
        self._ends.append((len(self._frames) - 1, caption_of(record, self._problem)))

    def save(self, run: Run, gif: Path | None, strip: Path | None) -> bool:
        """Write the pictures that were asked for, and say whether there are any; an empty plan has none."""
        if not self._frames:
            return False
        if gif:
            save_gif(gif, self._frames)
        if strip:
            captions = [f"{self._problem.name}: start", *(caption for _, caption in self._ends)]
            captions[-1] += ", goal reached" if run.reached else ", goal missed"
            start = self._frames[0] if self._start is None else self._start
            frames = (start, *(self._frames[end] for end, _ in self._ends))
            save_sheet(strip, [Row("", frames, tuple(captions))])
        return True
