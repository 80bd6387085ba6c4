"""Showing motions and problems, in files of pictures or live in a window."""

from collections.abc import Sequence
from pathlib import Path

from neurosym.errors import InvalidValue
from neurosym.pictures.film import film, film_phases, hold_window, ignore, open_window
from neurosym.pictures.images import Row, save_gif, save_sheet
from neurosym.pictures.motions import Motion
from neurosym.problems import Problem
from neurosym.world import Outcome, Pictured, World


def picture_motions(world: World, motions: Sequence[Motion], path: Path) -> tuple[Outcome, ...]:
    """Perform one or more motions and write their pictures: a row of a PNG for each, or one GIF of all."""
    check_pictured(world)
    if path.suffix.lower() != ".gif":
        filmed = [film_row(world, motion) for motion in motions]
        save_sheet(path, [row for row, _ in filmed])
        return tuple(outcome for _, outcome in filmed)
    takes = [film(world, motion) for motion in motions]
    told = zip(motions, takes, strict=True)
    captions = [f"{motion.title}: {phase}" for motion, take in told for phase in take.phases]
    save_gif(path, [frame for take in takes for frame in take.frames], captions)
    return tuple(take.outcome for take in takes)


def film_row(world: World, motion: Motion) -> tuple[Row, Outcome]:
    """Perform a motion, and keep the start and the end of each phase as a row; say what it did, too."""
    take = film_phases(world, motion.scene, motion.action, motion.reference)
    return Row(f"{motion.title}: {tell(take.outcome)}", take.frames, take.phases), take.outcome


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
