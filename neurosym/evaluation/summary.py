"""What a comparison of planners comes to: shares of tasks, and why planners disagree."""

from collections import Counter
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

import msgspec
import numpy as np

from neurosym.errors import counted
from neurosym.evaluation.comparison import Attempt, TaskRecord
from neurosym.files import read_json
from neurosym.planners.planner import PlanStatus
from neurosym.planners.registry import planner_named
from neurosym.stages.layout import COMPARISONS


class Tally(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """How one planner did."""

    found: int  # in how many tasks it found a plan
    valid: int  # in how many one that the operators promise to reach the goal
    reached: int  # in how many the plan reached the goal, followed blindly
    reached_with_replanning: int  # in how many the goal was reached with replanning
    steps: float | None  # mean number of primitives of its plans; None without any
    seconds: float | None  # median time of planning [s]; None without any
    predicted: int  # in how many the network, too, predicts the plan to reach the goal
    replans: int  # how often it was planned again, in all
    unfound: dict[str, int]  # why there was no plan where another planner found one, with counts
    invalid: dict[str, int]  # why plans were not valid, with counts
    missed: dict[str, int]  # why plans followed blindly missed the goal, with counts
    missed_with_replanning: dict[str, int]  # why the goal was missed in spite of replanning, with counts
    performed: int = 0  # how many primitives were performed with replanning, in all; 0 in earlier versions
    own: int = 0  # how many of them were those of its plans, and of no new one


class Comparison(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What planners made of the same tasks."""

    tasks: int  # how many tasks were drawn
    met_at_start: int  # how many of them need no step; they are left out of everything else
    solved_by_none: int  # how many no planner has a plan for
    planners: dict[str, Tally]  # how each planner did
    executed: bool = True  # whether there was a world in which plans could be followed

    @property
    def counted(self) -> int:
        """How many tasks need a plan."""
        return self.tasks - self.met_at_start


def comparisons_of(folder: Path) -> dict[str, Comparison]:
    """Read what `neurosym compare` measured in a folder, by the kind of task.

    Raises:
        InvalidFile: If a file is damaged.
    """
    paths = sorted((folder / COMPARISONS).glob("*/comparison.json"))
    return {path.parent.name: read_json(path, Comparison) for path in paths}


def summarise(records: Sequence[TaskRecord[Any]], planners: Sequence[str]) -> Comparison:
    """Count what became of the tasks."""
    asked = [record for record in records if not record.met_at_start]
    plans = [attempt for record in asked for attempt in record.attempts.values() if attempt.found]
    return Comparison(
        tasks=len(records),
        met_at_start=len(records) - len(asked),
        solved_by_none=sum(not any(record.attempts[name].found for name in planners) for record in asked),
        planners={name: _tally(asked, name, planners) for name in planners},
        executed=any(one.open_loop for one in plans) or not plans,
    )


def _tally(records: Sequence[TaskRecord[Any]], name: str, planners: Sequence[str]) -> Tally:
    attempts = [record.attempts[name] for record in records]
    found = [attempt for attempt in attempts if attempt.found]
    blind = [attempt.open_loop for attempt in attempts if attempt.open_loop]
    replanned = [attempt.replanned for attempt in attempts if attempt.replanned]
    return Tally(
        found=len(found),
        valid=sum(attempt.valid for attempt in found),
        reached=sum(run.reached for run in blind),
        reached_with_replanning=sum(run.reached for run in replanned),
        steps=round(float(np.mean([attempt.primitives for attempt in found])), 3) if found else None,
        seconds=round(float(np.median([attempt.seconds for attempt in attempts])), 4) if attempts else None,
        predicted=sum(_predicts_goal(record.attempts[name], record) for record in records),
        replans=sum(run.replans for run in replanned),
        unfound=_counts(why_not_found(record, name, planners) for record in records),
        invalid=_counts(map(_why_invalid, found)),
        missed=_counts(run.kind for run in blind),
        missed_with_replanning=_counts(run.kind for run in replanned),
        performed=sum(run.interactions for run in replanned if run.own is not None),
        own=sum(run.own or 0 for run in replanned),
    )


def _counts(reasons: Iterable[str]) -> dict[str, int]:
    return dict(sorted(Counter(filter(None, reasons)).items(), key=lambda item: (-item[1], item[0])))


def _predicts_goal(attempt: Attempt, record: TaskRecord[Any]) -> bool:
    """Say whether the network predicts that a plan ends at the goal."""
    miss = attempt.predicted_miss
    return miss is not None and miss <= record.problem.tolerance


def _why_invalid(attempt: Attempt) -> str:
    """Say in a few words why a plan that was found is not valid; empty if it is."""
    reasons = {
        "impossible": "by the operators, an object leaves the table or ends in another",
        "elsewhere": "by the operators, it ends elsewhere",
    }
    return reasons.get(attempt.invalid, "")


def why_not_found(record: TaskRecord[Any], name: str, planners: Sequence[str]) -> str:
    """Say in a few words why a planner has no plan where another has; empty if it has, or none has."""
    attempt = record.attempts[name]
    others = [record.attempts[other] for other in planners if record.attempts[other].found]
    if attempt.found or not others:
        return ""
    if attempt.status is PlanStatus.TIMEOUT:
        return "its time was up"
    other = min(others, key=lambda found: (not found.valid, found.primitives))
    planner = planner_named(name)
    depth = planner.depth if attempt.depth is None else attempt.depth
    if depth is not None and other.primitives > depth:
        return f"it takes more than {counted(depth, 'primitive')}"
    if planner.reads == "network":
        if not _predicts_goal(other, record):
            return "the network predicts the other plan to end elsewhere"
        return "the network predicts that an object leaves the table or ends in another"
    if other.left_out:
        return "the other plan uses an operator that the domain leaves out"
    return _why_invalid(other).replace("it ends", "the other plan ends") or "though the other plan is valid"
