"""Performing the steps of a plan in a world, recording them, and performing a record again."""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from typing import Any, Literal, Protocol

import msgspec
import numpy as np

from neurosym.errors import InvalidValue, InvalidWorld
from neurosym.execution.record import (
    Nudge,
    Replanning,
    Run,
    StepRecord,
    own_steps,
    record_step,
    seen_now,
)
from neurosym.grounding import Grounding
from neurosym.operators import vector
from neurosym.pair_operators import extent
from neurosym.problems import Problem, RelationGoal
from neurosym.tasks.lying import as_it_shows
from neurosym.tasks.pasts import past_of
from neurosym.tasks.promises import performed_with
from neurosym.tasks.supports import Contacts, touching
from neurosym.tasks.task import GOAL, PARK, is_reached, unmet_relations, with_places
from neurosym.tasks.transition import PlanStep, check_aims
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


def drawn_nudge(seed: int | None, steps: int, moment: Moment, problem: Problem, table: Table) -> Nudge | None:
    """Draw what is nudged when and where to, on the table and touching nothing; None if not now, or no room.

    The same seed gives the same step, of so many interactions that the plan has, the same object and way.
    """
    if seed is None or not steps:
        return None
    rng, scene = np.random.default_rng([_STREAM, seed]), moment.scene
    if moment.number != int(rng.integers(steps)) + 1:
        return None
    radii = np.hypot(scene.features[:, 0], scene.features[:, 1]) / 2  # around footprints however turned
    for _ in range(_TRIES):
        index = int(rng.integers(len(scene)))
        angle, length = rng.uniform(0, 2 * math.pi), rng.uniform(LEAST, MOST)
        by = np.array([length * math.cos(angle), length * math.sin(angle), 0.0])
        spot = scene.positions[index] + by
        near = np.linalg.norm((scene.positions - spot)[:, :2], axis=1) < radii + radii[index]
        near[index] = False
        if table.contains(spot) and not near.any():
            return Nudge(moment.number, problem.object_names[index], vector(by))
    return None


def nudged(scene: Scene, nudge: Nudge, problem: Problem) -> Scene:
    """Return a scene of a problem's objects after a nudge."""
    positions = scene.positions.copy()
    positions[problem.object_names.index(nudge.object)] += nudge.by
    return replace(scene, positions=positions)


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
    """Perform one step of a plan, and return what happened; None if the object was out of the arm's reach.

    The problem says what objects are called, and where pictures show their goals. A step may be aimed at a
    reference besides its object.
    """
    target, ghosts = problem.object_names.index(step.object), problem.goal_positions()
    lying = msgspec.structs.replace(
        problem.objects[target], orientation=tuple(scene.orientations[target].tolist())
    )
    operator = grounding.operator_named(step.operator)
    action = performed_with(grounding, operator, as_it_shows(lying, grounding))
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
        reached = is_reached(self.now(), self.grounding)
        told = unmet if self.problem.relations else msgspec.UNSET
        return {"reached": reached, "distances": self.problem.distances(positions), "unmet": told}

    def be_nudged(self, nudge: Nudge) -> None:
        """Take note that somebody moved an object."""
        self.scene, self.contacts = nudged(self.scene, nudge, self.problem), None

    def perform(
        self, step: PlanStep, put_down: bool, reference: Reference | None = None, is_shown: bool = True
    ) -> tuple[StepRecord, Outcome | None]:
        """Perform a step from here, and return its record, and what happened if its object was in reach."""
        given = self.problem, self.grounding, step, self.scene, put_down
        outcome = perform(self.world, *given, self.on_frame if is_shown else None, reference=reference)
        if outcome:
            self.scene, self.contacts = outcome.end, outcome.contacts
            if self.grounding.relations and outcome.carried and isinstance(outcome.reference, Place):
                # What carries promises nothing of heights: what was borne counts as if it stood on the table.
                start, positions = outcome.start, outcome.start.positions.copy()
                positions[outcome.target, 2] = extent(start, outcome.target)[2] / 2
                outcome = replace(outcome, start=replace(start, positions=positions))
        told = record_step(step, self.problem, self.grounding, outcome, scene=self.scene, put_down=put_down)
        return told, outcome


# Running a record again: the same world, step by step, must give the same record.
#
# On the machine that it was made on, that is byte for byte. Another processor rounds otherwise in the last
# digits, a few nanometres; who compares runs must tell that from a run that took another course.
ROUNDING = 1e-6
"""Lengths of two runs that are no farther apart than this are taken for the same, rounded otherwise [m]."""


@dataclass(frozen=True, slots=True)
class Agreement:
    """How well a run agrees with its record."""

    # whether it is the same byte for byte, the same within `ROUNDING`, or took another course
    course: Literal["same bytes", "within rounding", "another"]
    apart: float  # the greatest difference of two lengths [m]; of another course, where that begins
    where: str  # where another course begins, or else where bytes differ first; empty if none do


_SAME = Agreement("same bytes", 0.0, "")
_PROMISED = ("promised", "promised_effect", "deviation", "as_promised")  # what a record says of promises


def rerun(
    world: World,
    problem: Problem,
    grounding: Grounding,
    run: Run,
    *,
    on_frame: FrameSink | None = None,
    on_step: Callable[[StepRecord], None] | None = None,
    watcher: Watcher | None = None,
) -> Run:
    """Perform the steps of a record again, with the same nudge, up to the first that takes another course.

    Pictures of motions, and each step's record, go to who wants them. A watcher may stop it before a step.
    `UnknownChoice` or `InvalidValue` if the record names what there is not, or leads off the table.
    """
    plan = [one.step for one in run.steps]
    known = [step for step in plan if not step.place.startswith((GOAL, PARK))]  # those of new plans are not
    check_aims(with_places(problem, grounding), grounding, known)
    here, records = Situation(world, problem, grounding, on_frame), list[StepRecord]()
    for number, recorded in enumerate((*run.steps, None), start=1):
        for nudge in run.nudges:
            if nudge.before_step == number:
                here.be_nudged(nudge)
        if recorded is None:
            break
        if watcher and watcher.before_step(Moment(number, here.scene, (recorded.step,))) == STOP:
            break
        told = here.perform(recorded.step, recorded.put_down, recorded.reference)[0]
        if past_of(problem.object_named(recorded.object)):  # more may be known of it than there was
            told = msgspec.structs.replace(told, **{name: getattr(recorded, name) for name in _PROMISED})
        records.append(told)
        if on_step:
            on_step(records[-1])
        if any(not apart <= ROUNDING for _, apart in _differences(recorded, records[-1])):
            break
    own = run.own if len(records) == len(run.steps) else own_steps(records, run.replannings)
    return msgspec.structs.replace(run, steps=tuple(records), own=own, **here.judge())


def compare_runs(recorded: Run, again: Run) -> Agreement:
    """Compare a record with what `rerun` made of it, as far as it went."""
    found = [
        (f"{name} of step {number}, {one.operator} {one.object}", apart)
        for number, (one, other) in enumerate(zip(recorded.steps, again.steps, strict=False), start=1)
        for name, apart in _differences(one, other)
    ]
    found += _differences(recorded, again)
    for where, apart in found:
        if not apart <= ROUNDING:
            return Agreement("another", apart, where)
    return Agreement("within rounding", max(apart for _, apart in found), found[0][0]) if found else _SAME


def _differences(one: msgspec.Struct, other: msgspec.Struct) -> Iterator[tuple[str, float]]:
    """Yield the fields whose bytes differ, each with how far lengths are apart in it [m]."""
    for name in one.__struct_fields__:
        values = getattr(one, name), getattr(other, name)
        pair = msgspec.to_builtins(tuple(None if value is msgspec.UNSET else value for value in values))
        if msgspec.json.encode(pair[0]) != msgspec.json.encode(pair[1]):
            yield name, _apart(*pair)


def _apart(one: Any, other: Any) -> float:
    """Return the greatest difference of two lengths [m]; infinite if anything else differs."""
    if isinstance(one, float) and isinstance(other, float):
        return abs(one - other)
    if isinstance(one, dict) and isinstance(other, dict) and list(one) == list(other):
        one, other = list(one.values()), list(other.values())
    if isinstance(one, list | tuple) and isinstance(other, list | tuple) and len(one) == len(other):
        return max(map(_apart, one, other), default=0.0)
    return 0.0 if one == other and type(one) is type(other) else math.inf


# A run in short: what is counted when many runs are compared


class Execution(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What became of a plan in the world, in short."""

    reached: bool  # whether every goal was met at the end
    reason: str  # why not, or empty
    kind: str  # the same in a few words, to be counted
    distances: dict[str, float]  # how far each object with a goal ended from it [m]
    interactions: int  # how many primitives were performed
    kept: int  # in how many of them the object ended as promised
    replans: int  # how often it was planned again
    touched: int  # in how many the robot touched another object
    disturbed: int  # how many other objects were moved, toppled or lost in them
    off_table: tuple[str, ...]  # names of the objects that were off the table after any of them
    # how many of the primitives performed are the plan's own; None in records of earlier versions
    own: int | None = None


def summarise_run(run: Run, grounding: Grounding) -> Execution:
    """Keep of a run what is counted; the learned domain knows the table."""
    places = ((name, place) for record in run.steps for name, place in record.positions.items())
    off = {name for name, place in places if not grounding.table.contains(np.array(place))}
    return Execution(
        reached=run.reached,
        reason=run.reason,
        kind="" if run.reached else failure(run),
        distances={name: round(distance, 6) for name, distance in run.distances.items()},
        interactions=sum(record.happened != "not performed" for record in run.steps),
        kept=sum(record.as_promised for record in run.steps),
        replans=run.replans,
        touched=sum(bool(record.touched) for record in run.steps),
        disturbed=sum(len(record.disturbed) for record in run.steps),
        off_table=tuple(sorted(off)),
        own=run.own_steps,
    )


def failure(run: Run) -> str:
    """Say in a few words why a run missed its goal: what ended it, or the worst thing that happened in it."""
    bystanders = {how for record in run.steps for how in record.disturbed.values()}
    ends = {record.happened for record in run.steps} | bystanders
    grasps = [record.happened for record in run.steps if record.promised == "held"]
    causes = (
        ("lost" in ends, "an object fell off the table"),
        ("not performed" in ends, "out of the arm's reach"),
        ("toppled" in ends, "an object toppled"),
        (run.ended == "no progress", "new plans came no nearer"),
        (run.ended in ("budget", "work"), "new plans were used up"),
        (run.replannings and run.replannings[-1].reason, "no plan from where things ended"),
        (bystanders, "another object was moved"),
        (any(how != "held" for how in grasps), "a grasp failed"),
        (not all(record.as_promised for record in run.steps), "an object went elsewhere"),
    )
    return next((said for is_so, said in causes if is_so), "small errors added up")
