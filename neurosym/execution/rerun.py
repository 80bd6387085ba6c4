"""Running a record again: the same world, step by step, must give the same record.

On the machine that it was made on, that is byte for byte. Another processor rounds otherwise in the last
digits, a few nanometres; who compares runs must tell that from a run that took another course.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, Literal

import msgspec
import numpy as np

from neurosym.execution.performance import STOP, Moment, Situation, Watcher, check_aims
from neurosym.execution.record import Run, StepRecord, own_steps
from neurosym.grounding import Grounding
from neurosym.problems import Problem
from neurosym.tasks.task import GOAL, PARK, with_places
from neurosym.world import FrameSink, World

ROUNDING = 1e-6
"""Lengths of two runs that are no farther apart than this are taken for the same, rounded otherwise [m]."""
Course = Literal["same bytes", "within rounding", "another"]


@dataclass(frozen=True, slots=True)
class Agreement:
    """How well a run agrees with its record.

    Attributes:
        course: Whether it is the same byte for byte, the same within `ROUNDING`, or took another course.
        apart: The greatest difference of two lengths [m]; of another course, where that begins.
        where: Where another course begins, or else where bytes differ first; empty if none do.
    """

    course: Course
    apart: float
    where: str


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

    Args:
        world: The world that the run was made in.
        problem: The problem that it was made for.
        grounding: The grounding that it was made with.
        run: The record.
        on_frame: Called with pictures of the motion as it happens, if given.
        on_step: Called with each step's record as soon as it is done, if given.
        watcher: Told of each step before it begins, and may stop there, if given.

    Raises:
        UnknownChoice: If the record names an operator that the grounding does not have, or a place that
            the problem does not have.
        InvalidValue: If a step carries an object to no place, or off the table.
    """
    plan = [one.step for one in run.steps]
    known = [step for step in plan if not step.place.startswith((GOAL, PARK))]  # those of new plans are not
    check_aims(with_places(problem, grounding), grounding, known)
    here, records = Situation(world, problem, grounding, on_frame), list[StepRecord]()
    for number, recorded in enumerate(run.steps, start=1):
        _be_nudged(here, run, number)
        if watcher and watcher.before_step(Moment(number, here.scene, (recorded.step,))) == STOP:
            break
        records.append(here.perform(recorded.step, recorded.put_down, recorded.reference)[0])
        if on_step:
            on_step(records[-1])
        if _compare(recorded, records[-1]).course == "another":
            break
    else:
        _be_nudged(here, run, len(records) + 1)
    own = run.own if len(records) == len(run.steps) else own_steps(records, run.replannings)
    return msgspec.structs.replace(run, steps=tuple(records), own=own, **here.judge())


def _be_nudged(here: Situation, run: Run, number: int) -> None:
    """Nudge all that was nudged before a step."""
    for nudge in run.nudges:
        if nudge.before_step == number:
            here.be_nudged(nudge)


def compare_runs(recorded: Run, again: Run) -> Agreement:
    """Compare a record with what `rerun` made of it, as far as it went."""
    compared = []
    for number, (one, other) in enumerate(zip(recorded.steps, again.steps, strict=False), start=1):
        found = _compare(one, other, f" of step {number}, {one.operator} {one.object}")
        if found.course == "another":
            return found
        compared.append(found)
    whole = _compare(recorded, again)
    if whole.course == "another":
        return whole
    different = [found for found in compared if found.where] or [whole]
    return Agreement(whole.course, max(found.apart for found in (*compared, whole)), different[0].where)


def _compare(one: msgspec.Struct, other: msgspec.Struct, of: str = "") -> Agreement:
    """Compare two records of the same kind, field by field."""
    course: Course = "same bytes"
    greatest, first = 0.0, ""
    for field in one.__struct_fields__:
        values = getattr(one, field), getattr(other, field)
        pair = msgspec.to_builtins(tuple(None if value is msgspec.UNSET else value for value in values))
        if msgspec.json.encode(pair[0]) == msgspec.json.encode(pair[1]):
            continue
        apart = _apart(*pair)
        if not apart <= ROUNDING:
            return Agreement("another", apart, f"{field}{of}")
        course, greatest, first = "within rounding", max(greatest, apart), first or f"{field}{of}"
    return Agreement(course, greatest, first)


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
    """What became of a plan in the world, in short.

    Attributes:
        reached: Whether every goal was met at the end.
        reason: Why not, or empty.
        kind: The same in a few words, to be counted.
        distances: How far each object with a goal ended from it [m].
        interactions: How many primitives were performed.
        kept: In how many of them the object ended as promised.
        replans: How often it was planned again.
        touched: In how many the robot touched another object.
        disturbed: How many other objects were moved, toppled or lost in them.
        off_table: Names of the objects that were off the table after any of them.
        own: How many of the primitives performed are the plan's own; None in records of earlier versions.
    """

    reached: bool
    reason: str
    kind: str
    distances: dict[str, float]
    interactions: int
    kept: int
    replans: int
    touched: int
    disturbed: int
    off_table: tuple[str, ...]
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
    ends = {record.happened for record in run.steps}
    bystanders = {how for record in run.steps for how in record.disturbed.values()}
    if "lost" in ends | bystanders:
        return "an object fell off the table"
    if "not performed" in ends:
        return "out of the arm's reach"
    if "toppled" in ends | bystanders:
        return "an object toppled"
    if run.ended == "no progress":
        return "new plans came no nearer"
    if run.ended in ("budget", "work"):
        return "new plans were used up"
    if run.replannings and run.replannings[-1].reason:
        return "no plan from where things ended"
    if bystanders:
        return "another object was moved"
    if any(record.promised == "held" and record.happened != "held" for record in run.steps):
        return "a grasp failed"
    if not all(record.as_promised for record in run.steps):
        return "an object went elsewhere"
    return "small errors added up"
