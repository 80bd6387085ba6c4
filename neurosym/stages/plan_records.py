"""How planning went, as it is written into a domain folder."""

import re
from collections.abc import Sequence
from pathlib import Path

import msgspec

from neurosym.errors import InvalidFile, InvalidValue
from neurosym.files import make_folder, remove, write_atomically, write_json
from neurosym.grounding import Grounding
from neurosym.pddl.chances import expected_success, expected_within
from neurosym.pddl.moves import Encoding
from neurosym.pddl.plan_text import (
    PlanStep,
    Steps,
    named_steps,
    primitives,
    print_ground_plan,
    print_plan,
)
from neurosym.pddl.validation import validate
from neurosym.planners import PlanStatus
from neurosym.planners.second_look import Planned
from neurosym.problems import Problem
from neurosym.reading import read_json
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import PLANS, plan_files

MORE_MOTIONS = 2
"""How many motions more than a plan has primitives are told the chance of."""
_ALTERNATIVE = r"-alt-\d+$"


class PlannedSteps(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One more plan for a problem.

    Attributes:
        file: Its file, relative to the folder.
        steps: Operator and object of each step.
        chance: The chance that all steps go as promised.
    """

    file: str
    steps: Steps
    chance: float


class PlanRecord(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """How planning went.

    Attributes:
        problem: Name of the problem.
        planner: Name of the planner.
        status: How the search ended.
        steps: Operator and object of each step; empty unless solved or nearest.
        seconds: How long it took [s].
        reason: Why there is no plan, or what is to be said about the one found.
        chance: The chance that all steps go as promised; None without a plan.
        alternatives: The next-best plans, if they were asked for.
        tolerance: How near objects had to come [m]; None if it was the problem's own tolerance.
        chance_replanned: The chance that the goal is reached with at most `MORE_MOTIONS` motions more than
            primitives, planned anew on the way; None without a plan, and if the plan is known to miss.
        misses: Where the plan goes wrong by what was rehearsed; empty if it leads to the goal.
    """

    problem: str
    planner: str
    status: PlanStatus
    steps: Steps
    seconds: float
    reason: str
    chance: float | None = None
    alternatives: tuple[PlannedSteps, ...] = ()
    tolerance: float | None = None
    chance_replanned: float | None = None
    misses: str = ""

    @property
    def solved(self) -> bool:
        """Whether there is a plan."""
        return self.status is PlanStatus.SOLVED

    @property
    def primitives(self) -> int:
        """How many primitives the plan has."""
        return primitives(PlanStep(*step) for step in self.steps)


def write_plans(
    folder: DomainFolder,
    name: str,
    planner: str,
    problem: Problem,
    grounding: Grounding,
    planned: Planned,
    encoding: Encoding,
    tolerance: float | None = None,
) -> None:
    """Write what was found for a problem: plan, next-best plans and record.

    Args:
        folder: The domain folder.
        name: What the problem is called in the folder.
        planner: Name of the planner.
        problem: The problem.
        grounding: The learned domain.
        planned: What was found.
        encoding: The encoding that plans are printed for.
        tolerance: How near objects had to come [m], if not as the problem says.
    """
    result = planned.result
    plan_file, record_file = plan_files(name, planner)
    make_folder(folder / PLANS)
    stem = plan_file.removesuffix(".plan")
    written = _write_alternatives(folder, stem, planned.alternatives, problem, grounding, encoding)
    misses = validate(result.steps, problem, grounding).reason if result.status is PlanStatus.SOLVED else ""
    leads_there = result.has_plan and not misses
    record = PlanRecord(
        problem=name,
        planner=planner,
        status=result.status,
        steps=named_steps(result.steps),
        seconds=round(result.seconds, 3),
        reason=result.reason,
        chance=_chance(result.steps, problem, grounding) if result.has_plan else None,
        alternatives=written,
        tolerance=tolerance,
        chance_replanned=_chance_replanned(result.steps, problem, grounding) if leads_there else None,
        misses=misses,
    )
    if record.solved:
        write_atomically(folder / plan_file, _plan_text(result.steps, problem, grounding, encoding))
    elif result.has_plan:
        write_atomically(folder / plan_file, print_plan(result.steps, result.reason))
    else:
        remove(folder / plan_file)
    write_json(folder / record_file, record)


def planned_tolerance(plan_file: Path) -> float | None:
    """Return the tolerance that a plan was made with [m]; None if it was the problem's own, or is not known.

    Args:
        plan_file: The plan; its record, if it has one, stands beside it.
    """
    record = plan_file.with_name(f"{re.sub(_ALTERNATIVE, '', plan_file.stem)}.json")
    try:
        return read_json(record, PlanRecord).tolerance
    except InvalidFile:
        return None


def _write_alternatives(
    folder: DomainFolder,
    stem: str,
    plans: Sequence[tuple[PlanStep, ...]],
    problem: Problem,
    grounding: Grounding,
    encoding: Encoding,
) -> tuple[PlannedSteps, ...]:
    """Write the next-best plans, in place of those of an earlier time."""
    for stale in folder.path.glob(f"{stem}-alt-*.plan"):
        remove(stale)
    written = []
    for number, steps in enumerate(plans, start=1):
        file = f"{stem}-alt-{number}.plan"
        write_atomically(folder / file, _plan_text(steps, problem, grounding, encoding))
        written.append(PlannedSteps(file, named_steps(steps), _chance(steps, problem, grounding)))
    return tuple(written)


def _chance(steps: Sequence[PlanStep], problem: Problem, grounding: Grounding) -> float:
    return round(expected_success(steps, problem, grounding), 4)


def _chance_replanned(steps: Sequence[PlanStep], problem: Problem, grounding: Grounding) -> float:
    return round(expected_within(steps, problem, grounding, primitives(steps) + MORE_MOTIONS), 4)


def _plan_text(steps: Sequence[PlanStep], problem: Problem, grounding: Grounding, encoding: Encoding) -> str:
    """Print a plan such that validators take it, or in short if a step is not in the PDDL domain."""
    try:
        return print_ground_plan(steps, problem, grounding, encoding)
    except InvalidValue:
        return print_plan(steps)
