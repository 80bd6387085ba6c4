"""Stills: the few pictures that tell what a primitive or a run does, as in the paper's Figures 3 and 4."""

from collections.abc import Sequence
from dataclasses import dataclass

import msgspec
import numpy as np

from neurosym.errors import InvalidValue
from neurosym.execution.nudges import nudged
from neurosym.execution.performing import perform
from neurosym.execution.record import Run, StepRecord
from neurosym.grounding import Grounding
from neurosym.pictures.film import Sparing, caption_of, ends_in_the_air, film_phases
from neurosym.pictures.motions import Motion, operator_motions, operators_of
from neurosym.pictures.show import check_pictured, tell
from neurosym.problems import Problem
from neurosym.symbols import Categorise
from neurosym.wording import counted
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
    world: World, grounding: Grounding, label: str, categorise: Categorise, *, objects: int, seed: int
) -> Stills:
    """Perform a primitive as it mostly turns out, and keep the start and the end of each phase.

    Args:
        world: The world to act in.
        grounding: The learned domain.
        label: The primitive's action symbol, or one of its labels.
        categorise: Gives the object symbols of features.
        objects: How many objects rehearsal sampled.
        seed: Where rehearsal's draws started.

    Raises:
        UnknownChoice: If there is no such primitive.
        InvalidValue: If there is no object to perform it on, or the world draws no pictures.
    """
    weights = _weights(grounding)
    operators = operators_of(grounding, label)
    for operator in sorted(operators, key=lambda operator: weights[operator.name], reverse=True):
        motions = operator_motions(world, grounding, (operator,), categorise, objects=objects, seed=seed)
        if motions:
            return _filmed(world, motions[0])
    raise InvalidValue(f"Rehearsal sampled no object that the primitive {label} was tried on.")


def operator_stills(
    world: World, grounding: Grounding, name: str, categorise: Categorise, *, objects: int, seed: int
) -> Stills:
    """Perform an operator as it promises, and keep the start and the end of each phase.

    Args:
        world: The world to act in.
        grounding: The learned domain.
        name: The operator.
        categorise: Gives the object symbols of features.
        objects: How many objects rehearsal sampled.
        seed: Where rehearsal's draws started.

    Raises:
        UnknownChoice: If there is no such operator.
        InvalidValue: If there is no object to perform it on, or the world draws no pictures.
    """
    operators = (grounding.operator_named(name),)
    motions = operator_motions(world, grounding, operators, categorise, objects=objects, seed=seed)
    if not motions:
        raise InvalidValue(f"Rehearsal sampled no object that {name} is for.")
    return _filmed(world, motions[0])


def _filmed(world: World, motion: Motion) -> Stills:
    take = film_phases(world, motion.scene, motion.action, motion.reference)
    return Stills(f"{motion.title}: {tell(take.outcome)}", take.frames, take.phases)


def _weights(grounding: Grounding) -> dict[str, tuple[float, float]]:
    """Say for which share of objects a symbol's operators of the same verb keep promises, and each alone."""
    categories = {category.symbol: category for category in grounding.operators.categories}
    kept: dict[str, tuple[str, float]] = {}
    by_verb: dict[str, float] = {}
    for operator in grounding.operators.operators:
        category = categories[operator.category]
        verb = operator.name.removesuffix(f"-{operator.label}-{category.name}")
        share = category.share * operator.successes / max(1, operator.trials)
        kept[operator.name] = (f"{verb}-{operator.primitive}", share)
        by_verb[kept[operator.name][0]] = by_verb.get(kept[operator.name][0], 0.0) + share
    return {name: (by_verb[verb], share) for name, (verb, share) in kept.items()}


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
    scene, performed = problem.scene(), [step for step in run.steps if step.happened != "not performed"]
    _check_objects(problem, performed)
    frames = [check_pictured(world).picture(scene, problem.goal_positions())]
    captions = [f"{problem.name}: start, goal transparent"]
    start = {item.name: item.position for item in problem.objects}
    for number, record in enumerate(performed, 1):
        for nudge in (one for one in run.nudges if one.before_step == number):
            scene = nudged(scene, nudge, problem)
            captions[-1] += f"; then {nudge.object} was nudged"
        ghostly = msgspec.structs.replace(problem, goals=start if number == len(performed) else {})
        frame, scene = _perform(world, ghostly, grounding, record, scene)
        _check_same(problem, record, scene, number)
        frames.append(frame)
        captions.append(f"{number}. {caption_of(record, problem)}")
    captions[-1] += ", goal reached" if run.reached else ", goal missed"
    told = f"{problem.name}: goal {'reached' if run.reached else 'missed'}, {counted(len(performed), 'step')}"
    return Stills(told, tuple(frames), tuple(captions))


def _perform(
    world: World, problem: Problem, grounding: Grounding, record: StepRecord, scene: Scene
) -> tuple[Frame, Scene]:
    """Perform a step again, and return its last picture and where everything is then.

    A world that is `Sparing` performs it twice: the same interaction has as many pictures again, and only the
    last of them is drawn.
    """
    step, put_down = record.step, not ends_in_the_air(record, problem)
    frames: list[Frame] = []

    def attempt() -> Outcome | None:
        return perform(
            world,
            problem,
            grounding,
            step,
            scene,
            put_down,
            lambda frame, _: frames.append(frame),
            reference=record.reference,
        )

    if isinstance(world, Sparing):
        world.wanted_pictures = ()
        attempt()
        world.wanted_pictures = (len(frames) - 1,)
        outcome = attempt()
        world.wanted_pictures = None
    else:
        outcome = attempt()
    if not frames:
        raise InvalidValue(f"The {world.name} world draws no pictures of motions; have it call `on_frame`.")
    return frames[-1], outcome.end if outcome else scene


def _check_objects(problem: Problem, records: Sequence[StepRecord]) -> None:
    names = {*problem.object_names}
    if any(record.object not in names or record.positions.keys() != names for record in records):
        raise InvalidValue(f"The run is not of the objects of {problem.name}.")


def _check_same(problem: Problem, record: StepRecord, scene: Scene, number: int) -> None:
    recorded = [record.positions[name] for name in problem.object_names]
    if np.abs(scene.positions - np.array(recorded)).max() > SAME:
        raise InvalidValue(
            f"Step {number} of the run of {problem.name} goes another way this time: the domain, the world "
            "or the computer is not the one that it was recorded with."
        )
