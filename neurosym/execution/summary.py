"""A run in short: what is counted when many runs are compared."""

import msgspec
import numpy as np

from neurosym.execution.record import Run
from neurosym.grounding import Grounding


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
