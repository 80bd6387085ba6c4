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
    """How well a run agrees with its record."""

    course: Course  # whether it is the same byte for byte, the same within `ROUNDING`, or took another course
    apart: float  # the greatest difference of two lengths [m]; of another course, where that begins
    where: str  # where another course begins, or else where bytes differ first; empty if none do


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

    def be_nudged(number: int) -> None:
        for nudge in run.nudges:
            if nudge.before_step == number:
                here.be_nudged(nudge)

    for number, recorded in enumerate(run.steps, start=1):
        be_nudged(number)
        if watcher and watcher.before_step(Moment(number, here.scene, (recorded.step,))) == STOP:
            break
        records.append(here.perform(recorded.step, recorded.put_down, recorded.reference)[0])
        if on_step:
            on_step(records[-1])
        if _compare(recorded, records[-1]).course == "another":
            break
    else:
        be_nudged(len(records) + 1)
    own = run.own if len(records) == len(run.steps) else own_steps(records, run.replannings)
    return msgspec.structs.replace(run, steps=tuple(records), own=own, **here.judge())


def compare_runs(recorded: Run, again: Run) -> Agreement:
    """Compare a record with what `rerun` made of it, as far as it went."""
    pairs = enumerate(zip(recorded.steps, again.steps, strict=False), start=1)
    found = [
        _compare(*pair, f" of step {number}, {pair[0].operator} {pair[0].object}") for number, pair in pairs
    ]
    found.append(_compare(recorded, again))
    if another := next((one for one in found if one.course == "another"), None):
        return another
    first = next((one.where for one in found if one.where), "")
    return Agreement(found[-1].course, max(one.apart for one in found), first)


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
