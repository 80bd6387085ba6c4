"""How planning went, as it is written into a domain folder."""

from collections.abc import Sequence
from contextlib import suppress
from hashlib import sha256
from pathlib import Path
from typing import Any

import msgspec

from neurosym.errors import InvalidFile, InvalidValue, UnknownChoice
from neurosym.files import digest, make_folder, read_json, remove, write_atomically, write_json
from neurosym.grounding import Grounding
from neurosym.pddl.compiler import GroundPlan, ground_plan
from neurosym.pddl.syntax import NUMERIC, STRIPS, EncodingName
from neurosym.planners.planner import PlanResult, PlanStatus
from neurosym.problems import Problem
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import PLAN, PLANS, plan_files, steps_file
from neurosym.tasks.transition import (
    PlanStep,
    Steps,
    expected_success,
    expected_within,
    named_steps,
    primitives,
    print_plan,
    validate,
)

MORE_MOTIONS = 2
"""How many motions more than a plan has primitives are told the chance of."""


class PlanRecord(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """How planning went."""

    problem: str  # name of the problem
    planner: str  # name of the planner
    status: PlanStatus  # how the search ended
    steps: Steps  # operator and object of each step; empty unless solved or nearest
    seconds: float  # how long it took [s]
    reason: str  # why there is no plan, or what is to be said about the one found
    chance: float | None = None  # the chance that all steps go as promised; None without a plan
    # the next-best plans, in files of earlier versions; no longer looked at
    alternatives: tuple[dict[str, Any], ...] = ()
    # how near objects had to come [m]; None if it was the problem's own tolerance
    tolerance: float | None = None
    # the chance that the goal is reached with at most `MORE_MOTIONS` motions more than primitives, planned
    # anew on the way; None without a plan, and if the plan is known to miss
    chance_replanned: float | None = None
    misses: str = ""  # where the plan goes wrong by what was rehearsed; empty if it leads to the goal
    encoding: str = STRIPS  # the encoding that the plan is printed for; earlier versions had others
    unprinted: str = ""  # why the steps are no plan of the printed domain and problem; empty if they are one
    digest: str = ""  # SHA-256 of the file with the steps; empty if there is none, and in earlier versions

    @property
    def solved(self) -> bool:
        """Whether there is a plan."""
        return self.status is PlanStatus.SOLVED

    @property
    def primitives(self) -> int:
        """How many primitives the plan has."""
        return primitives(PlanStep(*step) for step in self.steps)


def write_plan(
    folder: DomainFolder,
    planner: str,
    own: Problem,
    problem: Problem,
    grounding: Grounding,
    result: PlanResult,
    encoding: EncodingName,
) -> GroundPlan | None:
    """Write what was found for a problem, and return the plan, which the printed problem has to fit.

    What is no plan of the printed domain and problem is written in short, and its file is called otherwise.
    `own` is the problem as it stands in the folder, which is what is printed; `problem` has the tolerance
    that was asked for.
    """
    steps, plan, text, found = result.steps, None, None, dict[str, Any]()
    misses = validate(steps, problem, grounding).reason if result.status is PlanStatus.SOLVED else ""
    if result.has_plan:
        printed = _printed(steps, own, grounding, encoding)
        if isinstance(printed, GroundPlan):
            plan, text = printed, printed.text
        else:
            found["unprinted"], text = printed, print_plan(steps, printed)
        found["chance"] = round(expected_success(steps, problem, grounding), 4)
        if not misses:
            motions = primitives(steps) + MORE_MOTIONS
            found["chance_replanned"] = round(expected_within(steps, problem, grounding, motions), 4)
    found |= {"misses": misses, "encoding": encoding}
    if problem.tolerance != own.tolerance:
        found["tolerance"] = problem.tolerance
    put_plan(folder, own.name, planner, result, text, **found)
    return plan


def put_plan(
    folder: DomainFolder, problem: str, planner: str, result: PlanResult, text: str | None, **told: Any
) -> None:
    """Write how planning went, and the text of what was found, instead of what a planner found before.

    What else is told is as in `PlanRecord`; steps that are `unprinted` have a file of their own.
    """
    plan_file, record_file = plan_files(problem, planner)
    make_folder(folder / PLANS)
    stem = plan_file.removesuffix(PLAN)
    for former in (*folder.path.glob(f"{stem}-alt-*"), folder / plan_file, folder / steps_file(plan_file)):
        remove(former)
    if text is not None:
        write_atomically(folder / (steps_file(plan_file) if "unprinted" in told else plan_file), text)
        told["digest"] = sha256(text.encode()).hexdigest()
    steps, seconds = named_steps(result.steps), round(result.seconds, 3)
    record = PlanRecord(problem, planner, result.status, steps, seconds, result.reason, **told)
    write_json(folder / record_file, record)


def _printed(
    steps: Sequence[PlanStep], problem: Problem, grounding: Grounding, encoding: EncodingName
) -> GroundPlan | str:
    """Return steps as a plan of the printed domain, or why they are none."""
    checked = validate(steps, problem, grounding)
    try:
        return ground_plan(steps, problem, grounding, encoding) if checked.valid else checked.reason
    except InvalidValue as error:
        return str(error)


def written_steps(folder: DomainFolder, problem: str, planner: str) -> str | None:
    """Name the file of a plan, or of the steps in its place; None if a planner has neither."""
    plan_file, _ = plan_files(problem, planner)
    return next((file for file in (plan_file, steps_file(plan_file)) if (folder / file).is_file()), None)


def recorded_plans(
    folder: DomainFolder, problem: Problem, grounding: Grounding, *, besides: str = ""
) -> tuple[GroundPlan, ...]:
    """Return the plans that stand beside a problem and are still true, as far as their records can be read.

    Those of the planner `besides` are left out.
    """
    found = []
    for path in sorted((folder / PLANS).glob(f"{problem.name}.*.json")):
        with suppress(InvalidFile, InvalidValue, UnknownChoice):  # of another time, or of somebody else
            record = read_json(path, PlanRecord)
            is_there = (folder / plan_files(record.problem, record.planner)[0]).is_file()
            if is_there and path.name != f"{problem.name}.{besides}.json":
                steps = [PlanStep(*step) for step in record.steps]
                encoding: EncodingName = NUMERIC if record.encoding == NUMERIC else STRIPS
                found.append(_printed(steps, problem, grounding, encoding))
    return tuple(plan for plan in found if isinstance(plan, GroundPlan))


def record_beside(plan_file: Path) -> PlanRecord | None:
    """Return the record of how a plan was found, if the file is as it was written then.

    Args:
        plan_file: The plan, or steps that are none; its record, if it has one, stands beside it.
    """
    record = _record_beside(plan_file)
    return record if record and record.digest in ("", digest(plan_file)) else None


def planned_tolerance(plan_file: Path) -> float | None:
    """Return the tolerance that a plan was made with [m]; None if it was the problem's own, or unknown."""
    record = _record_beside(plan_file)
    return record.tolerance if record else None


def _record_beside(plan_file: Path) -> PlanRecord | None:
    try:
        return read_json(plan_file.with_suffix(".json"), PlanRecord)
    except InvalidFile:
        return None
