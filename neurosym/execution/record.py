"""The record of a run: what each step promised and did, what was planned anew, and where everything ended."""

import math
from collections.abc import Sequence
from typing import Any, Literal

import msgspec
import numpy as np

from neurosym.execution.appearance import as_it_shows
from neurosym.execution.machine import Machine
from neurosym.grounding import Grounding
from neurosym.operators import TOLERANCE, Length, Vector, vector
from neurosym.pair_states import describe_pair, extent
from neurosym.problems import Problem
from neurosym.promises import promised
from neurosym.related import Contacts, bearers_of, relating, with_contacts
from neurosym.relation_goals import RelationGoal
from neurosym.relation_operators import PairState
from neurosym.table import OtherObject, Place, Reference
from neurosym.tasks.puts import put_named
from neurosym.tasks.steps import PlanStep, Steps, primitives
from neurosym.wording import counted
from neurosym.world import Disturbance, Outcome, OutcomeKind, Scene

StepOutcome = OutcomeKind | Literal["not performed"]
Ended = Literal[
    "goal", "plan", "lost", "out of reach", "no plan", "budget", "work", "no progress", "stopped", "unknown"
]
"""What ended a run: the goal was reached, or the plan was at its end; an object was lost, or out of reach;
there was no new plan, or none left to ask for, or no work left to make one with, or new ones came no nearer;
somebody stopped it; old records do not say."""


class StepRecord(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One step of a plan: what was promised and what happened.

    Attributes:
        operator: Name of the operator.
        object: Name of the object acted upon.
        promised: How the object was to end, and None if the operator never promised anything.
        promised_effect: How far it was to move [m].
        happened: How it ended.
        effect: How far it moved [m].
        deviation: Distance between the two displacements [m].
        as_promised: Whether it ended so, within the tolerance.
        positions: Centre of every object after the step [m], by name.
        touched: Names of the other objects that the robot itself touched.
        disturbed: How other objects ended that ended elsewhere (moved, toppled, lost), by name.
        put_down: Whether a held object was put down again at the end of the step.
        place: Name of the place that the object was to be carried to, or of the other object that it was to
            be put on, if there was one.
        aim: Where the hand aimed on the table for that, x and y [m].
        promised_state: Name of the state that it was to end in with the other object, if it was put on one.
        state: Name of the state that it ended in with that, if it was carried there.
        relations: What bears each object after the step that is borne, as state and name, if that matters.
    """

    operator: str
    object: str
    promised: StepOutcome | None
    promised_effect: Vector | None
    happened: StepOutcome
    effect: Vector
    deviation: float | None
    as_promised: bool
    positions: dict[str, Vector]
    touched: tuple[str, ...] = ()
    disturbed: dict[str, Disturbance] = {}
    put_down: bool = True
    place: str | msgspec.UnsetType = msgspec.UNSET
    aim: tuple[Length, Length] | msgspec.UnsetType = msgspec.UNSET
    promised_state: str | msgspec.UnsetType = msgspec.UNSET
    state: str | msgspec.UnsetType = msgspec.UNSET
    relations: dict[str, str] | msgspec.UnsetType = msgspec.UNSET

    @property
    def apart(self) -> float | None:
        """How far the object ended from the promise [m]; None where the two are not seen from one point.

        A promise to carry is seen from the place, and where a missed object ended from where it stood.
        """
        return self.deviation if (self.promised == "carried") == (self.happened == "carried") else None

    @property
    def step(self) -> PlanStep:
        """The step of the plan."""
        return PlanStep(self.operator, self.object, self.place or "")

    @property
    def reference(self) -> Reference | None:
        """What the step was aimed at besides its object, if anything."""
        if isinstance(self.aim, tuple):
            return Place(*self.aim)
        names = list(self.positions)
        return OtherObject(names.index(self.place)) if self.place in names else None


class Nudge(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """An object that was moved by somebody else during the run.

    Attributes:
        before_step: Number of the step that it happened before, counted from 1.
        object: Name of the object.
        by: How far it was moved along x, y and z [m].
    """

    before_step: int
    object: str
    by: Vector


class Replanning(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A new plan that was asked for during the run.

    Attributes:
        before_step: Number of the step that was to be next, counted from 1.
        why: Why the old plan would not do.
        plan: The new plan; empty if none was found.
        reason: Why none was found, or empty.
    """

    before_step: int
    why: str
    plan: Steps
    reason: str


class Run(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What became of a plan in the world.

    Attributes:
        problem: Name of the problem.
        plan: The steps that were asked for, as operator and object.
        steps: A record for each interaction that was performed.
        reached: Whether every goal was met at the end.
        distances: How far each object with a goal ended from it [m].
        reason: Why the goal was not reached, or empty.
        nudge: What was nudged on the way, if anything was.
        replannings: The new plans that were asked for.
        tolerance: How near objects had to come [m]; None if it was the problem's own tolerance.
        machine: What it was made on; None in records of earlier versions, and where nothing was written.
        ended: What ended it.
        more_nudges: What was nudged besides, in that order, if somebody did so more than once.
        unmet: The goals by relation that were not met at the end, where there were such goals.
        own: How many of the steps are the plan's own: those before the first new plan.
        replanner: Who made the new plans, where there are some and it is known.
    """

    problem: str
    plan: Steps
    steps: tuple[StepRecord, ...]
    reached: bool
    distances: dict[str, float]
    reason: str
    nudge: Nudge | None = None
    replannings: tuple[Replanning, ...] = ()
    tolerance: float | None = None
    machine: Machine | None = None
    ended: Ended = "unknown"
    more_nudges: tuple[Nudge, ...] | msgspec.UnsetType = msgspec.UNSET
    unmet: tuple[RelationGoal, ...] | msgspec.UnsetType = msgspec.UNSET
    own: int | msgspec.UnsetType = msgspec.UNSET
    replanner: str | msgspec.UnsetType = msgspec.UNSET

    @property
    def own_steps(self) -> int:
        """How many of the steps are the plan's own, also in records of earlier versions."""
        return own_steps(self.steps, self.replannings) if self.own is msgspec.UNSET else self.own

    @property
    def is_followed(self) -> bool:
        """Whether the plan was followed to its end, and nothing else."""
        asked = primitives(PlanStep(*step) for step in self.plan)
        return self.own_steps == len(self.steps) == asked

    @property
    def outcome(self) -> str:
        """Whether the goal was reached, and if so whether by the plan alone, in a few words."""
        if not self.reached:
            return "goal missed"
        if self.own_steps < len(self.steps):
            return "goal reached with new plans"
        return "goal reached" if self.is_followed else "goal reached before the plan's end"

    @property
    def credit(self) -> str:
        """How many of the steps performed are the plan's own, in words."""
        if not self.steps:
            return "no step was performed" if self.plan else "the plan has no step"
        performed = counted(len(self.steps), "step")
        if self.own_steps == len(self.steps):
            whole = "" if self.is_followed else ", which has more"
            return f"{performed} performed, all of the plan{whole}"
        by = f" of {self.replanner}" if isinstance(self.replanner, str) else ""
        return f"{performed} performed, {self.own_steps} of the plan and the rest of new plans{by}"

    @property
    def nudges(self) -> tuple[Nudge, ...]:
        """All that was nudged, in that order."""
        more = self.more_nudges if isinstance(self.more_nudges, tuple) else ()
        return (*([self.nudge] if self.nudge else []), *more)

    @property
    def replans(self) -> int:
        """How often a new plan was asked for."""
        return len(self.replannings)


def own_steps(steps: Sequence[StepRecord], replannings: Sequence[Replanning]) -> int:
    """Count the steps performed that are those of the plan that was asked for, and of no new one."""
    new = (one.before_step - 1 for one in replannings if one.plan)
    return min(len(steps), next(new, len(steps)))


def seen_now(problem: Problem, scene: Scene, contacts: Contacts | None) -> Problem:
    """Return a problem with its objects as they stand now, and with what touches if somebody saw it."""
    rows = zip(problem.objects, scene.positions, scene.orientations, strict=True)
    objects = tuple(
        msgspec.structs.replace(item, position=vector(position), orientation=tuple(orientation.tolist()))
        for item, position, orientation in rows
    )
    now = msgspec.structs.replace(problem, objects=objects, touching=None)
    return now if contacts is None else with_contacts(now, contacts)


def ended_in(outcome: Outcome, grounding: Grounding) -> PairState | None:
    """Return the state that a target ended in with its reference; None if it was not carried."""
    if not (outcome.carried and isinstance(outcome.reference, OtherObject) and grounding.relations):
        return None
    described = describe_pair(outcome.end, outcome.target, outcome.reference.index, outcome.contacts)
    return grounding.relations.state_of(described.tolist())


def record_step(
    step: PlanStep, problem: Problem, grounding: Grounding, outcome: Outcome, *, put_down: bool
) -> StepRecord:
    """Record a step that was performed, whether it puts its object on another one or not.

    Args:
        step: The step.
        problem: The problem, whose objects are those of the outcome.
        grounding: What the operator promises.
        outcome: What happened.
        put_down: Whether the object was to be put down if it was held.
    """
    is_put, names = relating(step.operator, grounding) is not None, problem.object_names
    told = (_put if is_put else _moved)(step, problem, grounding, outcome)
    promised_effect = told.pop("promised_effect")
    deviation = math.dist(told["effect"], promised_effect) if promised_effect else None
    if not is_put:
        told["as_promised"] &= deviation is not None and deviation <= TOLERANCE
    if grounding.relations and (problem.related or is_put):
        bearers = bearers_of(seen_now(problem, outcome.end, outcome.contacts), grounding.relations)
        told["relations"] = {name: f"{borne.state.name} {borne.by}" for name, borne in bearers.items()}
    return msgspec.structs.replace(
        _unpromised(step, problem, outcome.end, outcome.kind),
        promised_effect=promised_effect,
        deviation=deviation,
        touched=tuple(names[index] for index in outcome.touched),
        disturbed={names[index]: how for index, how in outcome.disturbed},
        put_down=put_down or is_put,
        place=step.place or msgspec.UNSET,
        **told,
    )


def record_refusal(step: PlanStep, problem: Problem, scene: Scene) -> StepRecord:
    """Record a step that could not be performed, because its object was out of the arm's reach."""
    return _unpromised(step, problem, scene, "not performed")


def _unpromised(step: PlanStep, problem: Problem, scene: Scene, happened: StepOutcome) -> StepRecord:
    return StepRecord(
        operator=step.operator,
        object=step.object,
        promised=None,
        promised_effect=None,
        happened=happened,
        effect=(0.0, 0.0, 0.0),
        deviation=None,
        as_promised=False,
        positions=dict(zip(problem.object_names, map(vector, scene.positions), strict=True)),
    )


def _moved(step: PlanStep, problem: Problem, grounding: Grounding, outcome: Outcome) -> dict[str, Any]:
    """Tell what the operator of a step promised for the object as it lay, and what came of it."""
    lay = tuple(outcome.start.orientations[outcome.target].tolist())
    item = as_it_shows(msgspec.structs.replace(problem.object_named(step.object), orientation=lay), grounding)
    found = promised(grounding, item, problem.tolerance).get(step.operator)
    operator = found or grounding.operator_named(step.operator)
    kind = operator.promise.kind if operator.promise else None
    return {
        "promised": kind,
        "promised_effect": grounding.displacement(operator) if operator.promise else None,
        "effect": vector(outcome.effect if outcome.held else outcome.resting_effect),
        "as_promised": kind == outcome.kind,
        "aim": (aim.x, aim.y) if isinstance(aim := outcome.reference, Place) else msgspec.UNSET,
    }


def _put(step: PlanStep, problem: Problem, grounding: Grounding, outcome: Outcome) -> dict[str, Any]:
    """Tell what was promised of the pair of a step, and what came of it."""
    put, state = put_named(step.operator, grounding), ended_in(outcome, grounding)
    target, other = outcome.target, problem.object_names.index(step.place)
    halves = (extent(outcome.end, target) + extent(outcome.end, other)) / 2
    away = outcome.end.positions[target] - outcome.end.positions[other]
    return {
        "promised": "carried" if put else None,
        "promised_effect": vector(np.array(put.end.offset) * halves) if put else None,
        "effect": vector(away if outcome.carried else outcome.resting_effect),
        "as_promised": put is not None and outcome.kind == "carried" and state == put.state,
        "promised_state": put.state.name if put else msgspec.UNSET,
        "state": state.name if state else msgspec.UNSET,
    }
