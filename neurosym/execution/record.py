"""The record of a run: what each step promised and did, what was planned anew, and where everything ended."""

import functools
import math
import platform
from collections.abc import Sequence
from pathlib import Path
from typing import Any, Literal

import msgspec
import numpy as np

from neurosym.errors import counted, in_millimetres, version_of
from neurosym.grounding import Grounding
from neurosym.operators import TOLERANCE, Length, Vector, vector
from neurosym.pair_operators import PairState, describe_pair, extent
from neurosym.problems import Problem, RelationGoal
from neurosym.tasks.conditions import unmet_conditions
from neurosym.tasks.lying import as_it_shows, righted, righting
from neurosym.tasks.options import put_named
from neurosym.tasks.promises import promised
from neurosym.tasks.supports import Contacts, bearers_of, with_contacts
from neurosym.tasks.transition import PlanStep, Steps, primitives
from neurosym.world import (
    Disturbance,
    OtherObject,
    Outcome,
    OutcomeKind,
    Place,
    Reference,
    Scene,
)

# The machine that a run was made on: another processor, or other versions, may round otherwise

PACKAGES = ("numpy", "pybullet")
"""The packages whose arithmetic decides how a run goes."""
_CPUINFO, _NUMBERS = Path("/proc/cpuinfo"), ("cpu family", "model", "stepping")
_UNKNOWN = "unknown"


class Machine(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What the last digits of a run may depend on besides its input."""

    processor: str  # model of the processor
    instructions: str  # the groups of vector instructions that numpy found on it
    architecture: str  # what kind of machine it is, like x86_64
    system: str  # operating system, with its C library where it has one of its own
    versions: dict[str, str]  # versions of Python and of the packages that compute, by name

    def differences(self, other: "Machine") -> tuple[str, ...]:
        """Say in what another machine differs, as "processor: this one's and the other's"."""
        here, there = ({**msgspec.structs.asdict(one), **one.versions} for one in (self, other))
        names = [*self.__struct_fields__[:-1], *sorted({*self.versions, *other.versions})]
        pairs = [(name, here.get(name, _UNKNOWN), there.get(name, _UNKNOWN)) for name in names]
        return tuple(f"{name}: {one} and {two}" for name, one, two in pairs if one != two)


@functools.cache
def this_machine() -> Machine:
    """Return the machine that this process runs on; always the same as long as nothing is installed."""
    libc = " ".join(filter(None, platform.libc_ver()))
    simd = np.show_config(mode="dicts").get("SIMD Extensions", {})
    return Machine(
        processor=_processor(),
        instructions=" ".join((*simd.get("baseline", ()), *simd.get("found", ()))),
        architecture=platform.machine() or _UNKNOWN,
        system=f"{platform.system()} {libc or platform.release()}".strip(),
        versions={"python": platform.python_version(), **{name: version_of(name) for name in PACKAGES}},
    )


def _processor() -> str:
    """Name the processor; names that clouds give are of whole families, so that its numbers are added."""
    try:
        lines = _CPUINFO.read_text(errors="replace").split("\n\n")[0].splitlines()
    except OSError:
        lines = []
    values = {name.strip(): value.strip() for name, _, value in (line.partition(":") for line in lines)}
    known = [f"{name.split()[-1]} {values[name]}" for name in _NUMBERS if values.get(name)]
    name = values.get("model name") or platform.processor() or _UNKNOWN
    return f"{name} ({', '.join(known)})" if known else name


StepOutcome = OutcomeKind | Literal["not performed"]
Ended = Literal[
    "goal", "plan", "lost", "out of reach", "no plan", "budget", "work", "no progress", "stopped", "unknown"
]
"""What ended a run: the goal was reached, or the plan was at its end; an object was lost, or out of reach;
there was no new plan, or none left to ask for, or no work left to make one with, or new ones came no nearer;
somebody stopped it; old records do not say."""


class StepRecord(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One step of a plan: what was promised, by what was known before the run, and what happened."""

    operator: str  # name of the operator
    object: str  # name of the object acted upon
    promised: StepOutcome | None  # how the object was to end; None if the operator never promised anything
    promised_effect: Vector | None  # how far it was to move [m]
    happened: StepOutcome  # how it ended
    effect: Vector  # how far it moved [m]
    deviation: float | None  # distance between the two displacements [m]
    as_promised: bool  # whether it ended so, within the tolerance
    positions: dict[str, Vector]  # centre of every object after the step [m], by name
    touched: tuple[str, ...] = ()  # names of the other objects that the robot itself touched
    disturbed: dict[str, Disturbance] = {}  # how other objects ended that ended elsewhere, by name
    put_down: bool = True  # whether a held object was put down again at the end of the step
    place: str | msgspec.UnsetType = msgspec.UNSET  # the place, or the other object, that it was to go to
    # of the hand for that: x and y [m], and the heading asked for, if one is [rad]
    aim: tuple[Length, ...] | msgspec.UnsetType = msgspec.UNSET
    promised_state: str | msgspec.UnsetType = msgspec.UNSET  # in which it was to be with the other
    state: str | msgspec.UnsetType = msgspec.UNSET  # in which it ended with that, if it was carried
    relations: dict[str, str] | msgspec.UnsetType = msgspec.UNSET  # what bears objects then, by name

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
    """An object that was moved by somebody else during the run."""

    before_step: int  # number of the step that it happened before, counted from 1
    object: str  # name of the object
    by: Vector  # how far it was moved along x, y and z [m]


class Replanning(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """A new plan that was asked for during the run."""

    before_step: int  # number of the step that was to be next, counted from 1
    why: str  # why the old plan would not do
    plan: Steps  # the new plan; empty if none was found
    reason: str  # why none was found, or empty


class Run(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What became of a plan in the world."""

    problem: str  # name of the problem
    plan: Steps  # the steps that were asked for, as operator and object
    steps: tuple[StepRecord, ...]  # a record for each interaction that was performed
    reached: bool  # whether every goal was met at the end
    distances: dict[str, float]  # how far each object with a goal ended from it [m]
    reason: str  # why the goal was not reached, or empty
    nudge: Nudge | None = None  # what was nudged on the way, if anything was
    replannings: tuple[Replanning, ...] = ()  # the new plans that were asked for
    tolerance: float | None = None  # how near objects had to come [m]; None if it was the problem's own
    machine: Machine | None = None  # what it was made on; None where nothing was written
    ended: Ended = "unknown"  # what ended it
    more_nudges: tuple[Nudge, ...] | msgspec.UnsetType = msgspec.UNSET  # those after the first
    unmet: tuple[RelationGoal, ...] | msgspec.UnsetType = msgspec.UNSET  # at the end, if there were any
    own: int | msgspec.UnsetType = msgspec.UNSET  # how many steps are the plan's, before the first new one
    replanner: str | msgspec.UnsetType = msgspec.UNSET  # who made the new plans, where it is known

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
        said = "all of the plan" + ", which has more" * (not self.is_followed)
        if self.own_steps < len(self.steps):
            by = f" of {self.replanner}" if isinstance(self.replanner, str) else ""
            said = f"{self.own_steps} of the plan and the rest of new plans{by}"
        return f"{counted(len(self.steps), 'step')} performed, {said}"

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
    return grounding.relations.of(described.tolist())


def record_step(
    step: PlanStep,
    problem: Problem,
    grounding: Grounding,
    outcome: Outcome | None,
    *,
    scene: Scene,
    put_down: bool = True,
) -> StepRecord:
    """Record a step, after which everything is as in the scene.

    There is no outcome if the object was out of the arm's reach. It may have been to be put down if held.
    """
    names, told = problem.object_names, dict[str, Any]()
    if outcome:
        frame = grounding.operator_named(step.operator).frame
        is_put, kind = frame == "pair", righted(outcome) if frame == "side" else outcome.kind
        told = (
            _put(step, problem, grounding, outcome)
            if is_put
            else _moved(step, problem, grounding, outcome, kind)
        )
        if grounding.relations and (problem.relations or is_put):
            bearers = bearers_of(seen_now(problem, scene, outcome.contacts), grounding.relations)
            told["relations"] = {name: f"{borne.state.name} {borne.by}" for name, borne in bearers.items()}
        told |= {
            "happened": kind,
            "touched": tuple(names[index] for index in outcome.touched),
            "disturbed": {names[index]: how for index, how in outcome.disturbed},
            "put_down": put_down or is_put,
            "place": step.place or msgspec.UNSET,
        }
    nothing = dict.fromkeys(("promised", "promised_effect", "deviation"))
    unmoved = {"happened": "not performed", "effect": (0.0, 0.0, 0.0), "as_promised": False}
    positions = dict(zip(names, map(vector, scene.positions), strict=True))
    told = {**nothing, **unmoved, "positions": positions, **told}
    return StepRecord(operator=step.operator, object=step.object, **told)


def _moved(
    step: PlanStep, problem: Problem, grounding: Grounding, outcome: Outcome, happened: OutcomeKind
) -> dict[str, Any]:
    """Tell what the operator of a step promised for the object as it lay, and what came of it."""
    item = seen_now(problem, outcome.start, None).object_named(step.object)
    known = promised(grounding, as_it_shows(item, grounding), problem.tolerance)
    operator = known.get(step.operator) or grounding.operator_named(step.operator)
    if operator.frame == "side":
        operator = righting(item, grounding) or operator
    kind = operator.promise.kind if operator.promise else None
    wanted = grounding.displacement(operator) if operator.promise else None
    if operator.frame == "side" and operator.promise:
        wanted = vector(np.array(operator.promise.resting_effect))
    effect = vector(outcome.effect if outcome.held else outcome.resting_effect)
    deviation = math.dist(effect, wanted) if wanted else None
    return {
        "promised": kind,
        "promised_effect": wanted,
        "effect": effect,
        "deviation": deviation,
        "as_promised": kind == happened and deviation is not None and deviation <= TOLERANCE,
        "aim": _told_of(aim) if isinstance(aim := outcome.reference, Place) else msgspec.UNSET,
    }


def _told_of(aim: Place) -> tuple[float, ...]:
    return (aim.x, aim.y) if aim.heading is None else (aim.x, aim.y, aim.heading)


def _put(step: PlanStep, problem: Problem, grounding: Grounding, outcome: Outcome) -> dict[str, Any]:
    """Tell what was promised of the pair of a step, and what came of it."""
    put, state = put_named(step.operator, grounding), ended_in(outcome, grounding)
    target, other = outcome.target, problem.object_names.index(step.place)
    halves = (extent(outcome.end, target) + extent(outcome.end, other)) / 2
    away = outcome.end.positions[target] - outcome.end.positions[other]
    wanted = vector(np.array(put.end.effect) * halves) if put else None
    effect = vector(away if outcome.carried else outcome.resting_effect)
    return {
        "promised": "carried" if put else None,
        "promised_effect": wanted,
        "effect": effect,
        "deviation": math.dist(effect, wanted) if wanted else None,
        "as_promised": put is not None and outcome.kind == "carried" and state == put.state,
        "promised_state": put.state.name if put else msgspec.UNSET,
        "state": state.name if state else msgspec.UNSET,
    }


# Why a run missed its goals, in words: which goal, what ended the run, and which step went otherwise


def why_missed(run: Run, problem: Problem, grounding: Grounding, work: int = 0) -> str:
    """Say which goals of a run were missed, and what ended it; nothing if all were reached.

    So much might be looked at for all new plans [states].
    """
    if run.reached:
        return ""
    if problem.conditions:
        false = " and ".join(map(repr, unmet_conditions(problem, grounding)))
        return f"{false} does not hold; {_what_ended(run, work)}"
    unmet = run.unmet if isinstance(run.unmet, tuple) else ()
    missed = [", ".join(_missed(goal, run.steps, grounding) for goal in unmet)] if unmet else []
    name, distance = max(run.distances.items(), key=lambda item: item[1], default=("", 0.0))
    if name and not (missed and distance <= problem.tolerance):
        allowed = f"{1000 * problem.tolerance:g} mm allowed"
        missed += [f"{name} is {in_millimetres(distance, problem.tolerance)} from its goal ({allowed})"]
    return "; ".join([*missed, _what_ended(run, work)])


def _missed(goal: RelationGoal, records: Sequence[StepRecord], grounding: Grounding) -> str:
    """Say what is so in the place of a goal by relation, and in which step that ended if it held."""
    target, reference, name = goal
    state = grounding.relations.state_named(name).name if grounding.relations else name
    wanted = f"{state} {reference}"
    told = [(one.relations if isinstance(one.relations, dict) else {}).get(target) for one in records]
    now = (told[-1] or "borne by nothing") if told else "where it was"
    said, held = f"{target} is {now}, not {wanted}", [one == wanted for one in told]
    if not any(held) or held[-1]:
        return said
    number = len(held) - held[::-1].index(True) + 1
    return f"{said} as after step {number - 1}: that ended in step {number}"


def _what_ended(run: Run, work: int) -> str:
    """Say what ended a run that missed its goals, or which step was the first not to do as promised."""
    records, count, number = run.steps, counted(run.replans, "new plan"), len(run.steps)
    last = records[-1] if records else None
    lost = [last.object] if last and last.happened == "lost" else []
    lost += [name for name, how in last.disturbed.items() if how == "lost"] if last else []
    why: dict[Ended, str] = {
        "lost": f"step {number} threw {' and '.join(lost)} off the table",
        "out of reach": f"{last and last.object} was out of the arm's reach in step {number}",
        "stopped": f"it was stopped before step {number + 1}",
        "no plan": f"no new plan after step {number}: {run.replannings[-1].reason if run.replans else ''}",
        "budget": f"all {count} were used up",
        "work": f"gave up planning anew: the budget of {work:,} states for new plans was used up after "
        f"{count}",
        "no progress": f"the last new plans came no nearer to the goal, after {run.replans}",
    }
    if run.ended in why:
        return why[run.ended]
    said = f"every step did as promised within {1000 * TOLERANCE:.0f} mm" if records else "it has no step"
    if other := next(((number, one) for number, one in enumerate(records, 1) if not one.as_promised), None):
        number, one = other
        wanted, came = one.promised_state or one.promised, one.state or one.happened
        far = "" if one.apart is None else f", {in_millimetres(one.apart, TOLERANCE)} from the promise"
        said = f"step {number}, {one.operator}: promised {wanted}, ended {came}{far}"
    return f"the plan came to its end; {said}"
