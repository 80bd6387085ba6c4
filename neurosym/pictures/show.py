"""Showing motions and problems, in files of pictures or live in a window."""

from collections.abc import Sequence
from pathlib import Path

from neurosym.errors import InvalidValue
from neurosym.pictures.film import Take, film, film_phases, hold_window, ignore, open_window
from neurosym.pictures.images import Row, save_gif, save_sheet
from neurosym.pictures.motions import Motion
from neurosym.problems import Problem
from neurosym.world import Outcome, Pictured, World, relative_to


def picture_motions(world: World, motions: Sequence[Motion], path: Path) -> tuple[Outcome, ...]:
    """Perform motions and write their pictures: a row of a PNG for each, or one GIF of all.

    Args:
        world: The world to act in.
        motions: What to perform, at least one.
        path: Where the file shall stand; its ending decides.

    Raises:
        InvalidValue: If the world draws no pictures.
    """
    check_pictured(world)
    if path.suffix.lower() == ".gif":
        takes = [film(world, motion.scene, motion.action, motion.reference) for motion in motions]
        captions = [
            f"{motion.title}: {phase}"
            for motion, take in zip(motions, takes, strict=True)
            for phase in take.phases
        ]
        save_gif(path, [frame for take in takes for frame in take.frames], captions)
    else:
        takes = [film_phases(world, motion.scene, motion.action, motion.reference) for motion in motions]
        save_sheet(path, [_row(motion, take) for motion, take in zip(motions, takes, strict=True)])
    return tuple(take.outcome for take in takes)


def _row(motion: Motion, take: Take) -> Row:
    return Row(f"{motion.title}: {tell(take.outcome)}", take.frames, take.phases)


def tell(outcome: Outcome) -> str:
    """Say how an object ended, and how far it moved."""
    x, y, z = (round(1000 * float(value)) + 0 for value in outcome.effect)
    return f"{outcome.kind}, effect ({x}, {y}, {z}) mm"


def show_live(world: World, motions: Sequence[Motion]) -> tuple[Outcome, ...]:
    """Perform motions in a window, in real time.

    Args:
        world: The world to act in.
        motions: What to perform.

    Raises:
        InvalidValue: If the world has no window, or there is no screen.
    """
    open_window(world)
    outcomes = []
    for motion in motions:
        aim = relative_to(world, motion.reference)
        outcomes.append(world.interact(motion.scene, motion.action, 0, on_frame=ignore, **aim))
        hold_window()
    return tuple(outcomes)


def picture_problem(world: World, problem: Problem, path: Path) -> None:
    """Write a picture of the scene that a problem starts from, with every goal drawn transparently.

    Args:
        world: The world of the scene.
        problem: The problem.
        path: Where the file shall stand; its ending decides.

    Raises:
        InvalidValue: If the world draws no pictures.
    """
    frame = check_pictured(world).picture(problem.scene(), problem.goal_positions())
    if path.suffix.lower() == ".gif":
        save_gif(path, [frame])
    else:
        save_sheet(path, [Row("", (frame,), (f"{problem.name}: start, and its goals transparently",))])


def check_pictured(world: World) -> Pictured:
    """Return a world as one that draws pictures, or raise `InvalidValue`."""
    if not isinstance(world, Pictured):
        raise InvalidValue(f"The {world.name} world draws no pictures; give it a method `picture`.")
    return world
