"""Stills: the few pictures that tell what a primitive or a run does, as in the paper's Figures 3 and 4."""

from dataclasses import dataclass

import numpy as np
from jaxtyping import Float

from neurosym.errors import InvalidValue
from neurosym.film import Sparing, caption_of, ends_in_the_air, film_phases
from neurosym.folder import Manifest
from neurosym.motions import primitive_motions
from neurosym.pddl.grounding import Grounding
from neurosym.problems import Problem
from neurosym.rehearsal import Categorise
from neurosym.run_record import Run, StepRecord
from neurosym.show import check_pictured, tell
from neurosym.world import Frame, Outcome, Scene, World

SAME = 0.001
"""How near every object must end to where it ended before, for a run to have gone the same way again [m]."""


@dataclass(frozen=True, slots=True, eq=False)
class Stills:
    """Pictures that are to be seen side by side.

    Attributes:
        title: What they show.
        frames: The pictures.
        captions: A line under each.
    """

    title: str
    frames: tuple[Frame, ...]
    captions: tuple[str, ...]


def primitive_stills(
    world: World, grounding: Grounding, symbol: str, categorise: Categorise, *, objects: int, seed: int
) -> Stills:
    """Perform a primitive where its promise weighs most, and keep the start and the end of each phase.

    Args:
        world: The world to act in.
        grounding: The learned domain.
        symbol: The primitive's action symbol.
        categorise: Gives the object symbols of features.
        objects: How many objects rehearsal sampled.
        seed: Where rehearsal's draws started.

    Raises:
        UnknownChoice: If there is no such primitive.
        InvalidValue: If there is no object to perform it on, or the world draws no pictures.
    """
    motions = primitive_motions(world, grounding, symbol, categorise, objects=objects, seed=seed)
    if not motions:
        raise InvalidValue(f"Rehearsal sampled no object that the primitive {symbol} was tried on.")
    weights = _weights(grounding)
    motion = max(motions, key=lambda motion: weights.get(motion.title, 0.0))
    take = film_phases(world, motion.scene, motion.action)
    return Stills(f"{motion.title}: {tell(take.outcome)}", take.frames, take.phases)


def rehearsal_options(manifest: Manifest) -> tuple[int, int]:
    """Return how many objects rehearsal sampled, and where its draws started.

    Args:
        manifest: How the files of the domain folder came about.
    """
    distilled = manifest.stages.get("distill")
    options = distilled.options if distilled else {}
    return options.get("objects", 100), options.get("seed", 0)


def _weights(grounding: Grounding) -> dict[str, float]:
    """Say of how many of all objects each operator keeps its promise, as a share."""
    shares = {category.symbol: category.share for category in grounding.operators.categories}
    return {
        operator.name: shares[operator.category] * operator.successes / max(1, operator.trials)
        for operator in grounding.operators.operators
    }


def run_stills(world: World, problem: Problem, grounding: Grounding, run: Run) -> Stills:
    """Perform the steps of a run again, and keep the start and the end of each.

    As in the paper's Figure 4, the first picture shows the goals transparently, and the last one where the
    objects stood at the start.

    Args:
        world: The world to act in.
        problem: What the run was to solve.
        grounding: What the operators' names mean.
        run: What became of the plan.

    Raises:
        InvalidValue: If it goes another way this time, or the world draws no pictures.
        UnknownChoice: If an operator or an object is unknown here.
    """
    scene = problem.scene()
    frames = [check_pictured(world).picture(scene, problem.goal_positions())]
    captions = [f"{problem.name}: start, goal transparent"]
    performed = [record for record in run.steps if record.happened != "not performed"]
    for record in performed:
        if not {record.object, *problem.object_names} <= record.positions.keys() & {*problem.object_names}:
            raise InvalidValue(f"The run is not of the objects of {problem.name}.")
    for number, record in enumerate(performed, 1):
        ghosts = problem.scene().positions if number == len(performed) else None
        frame, outcome = _perform(world, problem, grounding, record, scene, ghosts)
        scene = outcome.end
        _check_same(problem, record, scene, number)
        frames.append(frame)
        captions.append(f"{number}. {caption_of(record, problem)}")
    captions[-1] += ", goal reached" if run.reached else ", goal missed"
    return Stills(problem.name, tuple(frames), tuple(captions))


def _perform(
    world: World,
    problem: Problem,
    grounding: Grounding,
    record: StepRecord,
    scene: Scene,
    ghosts: Float[np.ndarray, "M 3"] | None,
) -> tuple[Frame, Outcome]:
    action = np.array(grounding.primitive(grounding.operator_named(record.operator).primitive).action)
    target = problem.object_names.index(record.object)
    frames: list[Frame] = []

    def perform() -> Outcome:
        return world.interact(
            scene,
            action,
            target,
            put_down=not ends_in_the_air(record, problem),
            on_frame=lambda frame, _: frames.append(frame),
            ghosts=ghosts,
        )

    if isinstance(world, Sparing):  # the same interaction has the same pictures again
        world.wanted_pictures = ()
        perform()
        world.wanted_pictures = (len(frames) - 1,)
        outcome = perform()
        world.wanted_pictures = None
    else:
        outcome = perform()
    if not frames:
        raise InvalidValue(f"The {world.name} world draws no pictures of motions; have it call `on_frame`.")
    return frames[-1], outcome


def _check_same(problem: Problem, record: StepRecord, scene: Scene, number: int) -> None:
    recorded = [record.positions[name] for name in problem.object_names]
    if np.abs(scene.positions - np.array(recorded)).max() > SAME:
        raise InvalidValue(
            f"Step {number} of the run of {problem.name} goes another way this time: the domain, the world "
            "or the computer is not the one that it was recorded with."
        )
