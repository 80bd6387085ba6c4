"""Performing the steps of a plan in a world, and recording them."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any, Literal, Protocol

import msgspec
import numpy as np

from neurosym.errors import InvalidValue, InvalidWorld, UnknownChoice
from neurosym.execution.record import Nudge, Replanning, StepRecord, record_step, seen_now
from neurosym.grounding import Grounding, is_lift
from neurosym.operators import vector
from neurosym.pair_operators import extent
from neurosym.problems import Problem, RelationGoal
from neurosym.tasks.supports import Contacts, touching
from neurosym.tasks.task import unmet_relations
from neurosym.tasks.transition import PlanStep
from neurosym.world import FrameSink, Outcome, Place, Reference, Scene, Table, World, relative_to

# Who watches a run: asked before every step whether to move an object, or to end the run there

Answer = Nudge | Literal["stop"] | None
"""What a watcher wants before a step: an object moved, the run ended, or nothing."""
STOP: Literal["stop"] = "stop"
"""Ends a run before its next step."""


@dataclass(frozen=True, slots=True, eq=False)
class Moment:
    """A run between two steps."""

    number: int  # number of the step that is to be next, counted from 1
    scene: Scene  # where everything is, at rest
    left: tuple[PlanStep, ...]  # what is left of the plan, the next step first


class Watcher(Protocol):
    """Watches a run while it goes on. Who only watches changes nothing, down to the bytes of the record."""

    def before_step(self, moment: Moment) -> Answer:
        """Say what shall happen before a step; asked again after each nudge, until nothing is wanted.

        A plan that is at its end is asked for once more, since a nudge may call for a new one.
        """
        ...

    def replanned(self, replanning: Replanning) -> None:
        """Hear of a new plan, or that there is none, and why the old one would not do."""
        ...


# Nudges: somebody moves an object during a run, and the plan no longer starts from where things are

LEAST, MOST = 0.03, 0.08
"""How far an object is nudged [m]."""
_STREAM = 0x6E756467  # keeps the randomness of nudges apart from that of everything else
_TRIES = 100


@dataclass(slots=True)
class Nudger:
    """Watches a run, and nudges an object once: when, which and where to follows from a seed."""

    seed: int  # same seed, same step, object and direction
    steps: int  # how many interactions the plan has; 0 if there are none, and nothing is nudged then
    problem: Problem  # what the objects are called
    table: Table  # where they may stand
    _is_done: bool = False

    def before_step(self, moment: Moment) -> Nudge | None:
        """Draw what is nudged where to, on the table and touching nothing, if there is room."""
        rng = np.random.default_rng([_STREAM, self.seed])
        if self._is_done or not self.steps or moment.number != int(rng.integers(self.steps)) + 1:
            return None
        self._is_done, scene = True, moment.scene
        radii = np.hypot(scene.features[:, 0], scene.features[:, 1]) / 2  # around footprints however turned
        for _ in range(_TRIES):
            index = int(rng.integers(len(scene)))
            angle, length = rng.uniform(0, 2 * math.pi), rng.uniform(LEAST, MOST)
            by = np.array([length * math.cos(angle), length * math.sin(angle), 0.0])
            spot = scene.positions[index] + by
            near = np.linalg.norm((scene.positions - spot)[:, :2], axis=1) < radii + radii[index]
            near[index] = False
            if self.table.contains(spot) and not near.any():
                return Nudge(moment.number, self.problem.object_names[index], vector(by))
        return None

    def replanned(self, replanning: Replanning) -> None:
        """Hear of a new plan."""


def nudged(scene: Scene, nudge: Nudge, problem: Problem) -> Scene:
    """Return a scene of a problem's objects after a nudge."""
    positions = scene.positions.copy()
    positions[problem.object_names.index(nudge.object)] += nudge.by
    return Scene(scene.features, positions, scene.orientations)


def perform(
    world: World,
    problem: Problem,
    grounding: Grounding,
    step: PlanStep,
    scene: Scene,
    put_down: bool,
    on_frame: FrameSink | None = None,
    *,
    reference: Reference | None = None,
) -> Outcome | None:
    """Perform one step of a plan.

    Args:
        world: The world to act in.
        problem: What the objects are called, and where pictures show their goals.
        grounding: What the operator's name means.
        step: The step.
        scene: Where everything is.
        put_down: Whether to put the object down if it is held.
        on_frame: Called with pictures of the motion as it happens, if given.
        reference: What the step is aimed at besides its object, if anything.

    Returns:
        What happened; None if the object was out of the arm's reach.
    """
    operator = grounding.relation_named(step.operator) or grounding.operator_named(step.operator)
    action = np.array(grounding.primitive_of(operator).action)
    target, ghosts = problem.object_names.index(step.object), problem.goal_positions()
    try:
        aim = relative_to(world, reference)
        return world.interact(
            scene, action, target, put_down=put_down, on_frame=on_frame, ghosts=ghosts, **aim
        )
    except InvalidWorld:
        raise
    except InvalidValue:  # the object has been moved out of the arm's reach
        return None


@dataclass(slots=True)
class Situation:
    """Where everything is while a plan runs, and what acts there."""

    world: World  # the world to act in
    problem: Problem  # what is to be solved
    grounding: Grounding  # what the operators' names mean
    on_frame: FrameSink | None  # called with pictures of motions as they happen, if given
    scene: Scene = field(init=False)  # where everything is
    contacts: Contacts | None = None  # pairs of objects that touch; None where nobody saw it

    def __post_init__(self) -> None:
        self.scene = self.problem.scene()
        self.contacts = None if self.problem.touching is None else touching(self.problem)

    def now(self, problem: Problem | None = None) -> Problem:
        """Return a problem, the one to be solved if none is given, with the objects as they stand now."""
        contacts = self.contacts if self.grounding.relations else None
        return seen_now(problem or self.problem, self.scene, contacts)

    def unmet(self) -> tuple[RelationGoal, ...]:
        """List the goals by relation that do not hold now."""
        return unmet_relations(self.now(), self.grounding)

    def judge(self) -> dict[str, Any]:
        """Say how near the goals are, as the record of a run does."""
        unmet, positions = self.unmet(), self.scene.positions
        return {
            "reached": self.problem.is_met(positions) and not unmet,
            "distances": self.problem.distances(positions),
            "unmet": unmet if self.problem.related else msgspec.UNSET,
        }

    def be_nudged(self, nudge: Nudge) -> None:
        """Take note that somebody moved an object."""
        self.scene, self.contacts = nudged(self.scene, nudge, self.problem), None

    def perform(
        self, step: PlanStep, put_down: bool, reference: Reference | None = None, is_shown: bool = True
    ) -> tuple[StepRecord, Outcome | None]:
        """Perform a step from here, and return its record, and what happened if its object was in reach."""
        given = self.problem, self.grounding, step, self.scene, put_down
        outcome = perform(self.world, *given, self.on_frame if is_shown else None, reference=reference)
        if outcome is None:
            return record_step(step, self.problem, self.grounding, None, scene=self.scene), None
        self.scene, self.contacts = outcome.end, outcome.contacts
        if self.grounding.relations and outcome.carried and isinstance(outcome.reference, Place):
            # What carries promises nothing of heights: what was borne counts as if it had stood on the table.
            start, positions = outcome.start, outcome.start.positions.copy()
            positions[outcome.target, 2] = extent(start, outcome.target)[2] / 2
            outcome = replace(outcome, start=Scene(start.features, positions, start.orientations))
        told = record_step(step, self.problem, self.grounding, outcome, scene=outcome.end, put_down=put_down)
        return told, outcome


def check_aims(problem: Problem, grounding: Grounding, plan: Sequence[PlanStep]) -> None:
    """Refuse steps that carry an object nowhere, off the table, or to what a problem with places has not."""
    for step in plan:
        if grounding.relation_named(step.base):
            others = [name for name in problem.object_names if name != step.object]
            if step.place not in others:
                raise UnknownChoice("other object", step.place, others)
        elif grounding.carries(grounding.operator_named(step.base)):
            grounding.table.check(step.place, *problem.place_named(step.place))
        elif step.place:
            raise InvalidValue(f"{step.operator} carries nothing, so it cannot lead to {step.place}.")


def lifts(step: PlanStep, grounding: Grounding) -> bool:
    """Say whether a step promises to end with its object held."""
    return not grounding.relation_named(step.operator) and is_lift(grounding.operator_named(step.operator))
