"""Stills: the few pictures that tell what a primitive or a run does, as in the paper's Figures 3 and 4."""

import msgspec
import numpy as np

from neurosym.errors import InvalidValue
from neurosym.execution.nudges import nudged
from neurosym.execution.performing import perform
from neurosym.execution.record import Run, StepRecord
from neurosym.grounding import Grounding
from neurosym.pictures.film import caption_of, ends_in_the_air, sparing
from neurosym.pictures.images import Row
from neurosym.pictures.motions import operator_motions, operators_of
from neurosym.pictures.show import check_pictured, film_row
from neurosym.problems import Problem
from neurosym.symbols import Categorise
from neurosym.wording import counted
from neurosym.world import Frame, FrameSink, Outcome, Scene, World

SAME = 0.001
"""How near every object must end to where it ended before, for a run to have gone the same way again [m]."""


def motion_stills(
    world: World, grounding: Grounding, name: str, categorise: Categorise, *, objects: int, seed: int
) -> Row:
    """Perform an operator as it promises, or a primitive as it mostly turns out.

    Kept are the start and the end of each phase.

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
    weights, operators = _weights(grounding), [one for one in grounding.every_operator if one.name == name]
    for operator in operators or sorted(
        operators_of(grounding, name), key=lambda operator: weights[operator.name], reverse=True
    ):
        motions = operator_motions(world, grounding, (operator,), categorise, objects=objects, seed=seed)
        if motions:
            return film_row(world, motions[0])[0]
    raise InvalidValue(f"Rehearsal sampled no object that {name} was tried on.")


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
    reached = f"goal {'reached' if run.reached else 'missed'}"
    captions[-1] += f", {reached}"
    told = f"{problem.name}: {reached}, {counted(len(performed), 'step')}"
    return Row(told, tuple(frames), tuple(captions))


def _perform(
    world: World, problem: Problem, grounding: Grounding, record: StepRecord, scene: Scene
) -> tuple[Frame, Scene]:
    """Perform a step again, and return its last picture and where everything is then."""
    step, put_down = record.step, not ends_in_the_air(record, problem)

    def attempt(keep: FrameSink) -> Outcome | None:
        aim = record.reference
        return perform(world, problem, grounding, step, scene, put_down, keep, reference=aim)

    outcome, ((frame, _),) = sparing(world, attempt, lambda phases: (len(phases) - 1,))
    return frame, outcome.end if outcome else scene


def _check_same(problem: Problem, record: StepRecord, scene: Scene, number: int) -> None:
    recorded = [record.positions[name] for name in problem.object_names]
    if np.abs(scene.positions - np.array(recorded)).max() > SAME:
        raise InvalidValue(
            f"Step {number} of the run of {problem.name} goes another way this time: the domain, the world "
            "or the computer is not the one that it was recorded with."
        )
