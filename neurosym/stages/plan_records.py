"""How planning went, as it is written into a domain folder."""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from hashlib import sha256
from pathlib import Path

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
from neurosym.tasks.chances import expected_success, expected_within
from neurosym.tasks.transition import PlanStep, Steps, named_steps, primitives, print_plan, validate

MORE_MOTIONS = 2
"""How many motions more than a plan has primitives are told the chance of."""
_ALTERNATIVE = r"-alt-\d+$"


class PlannedSteps(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One more plan for a problem.

    Attributes:
        file: Its file, relative to the folder.
        steps: Operator and object of each step.
        chance: The chance that all steps go as promised.
        digest: SHA-256 of the file; empty in records of earlier versions.
    """

    file: str
    steps: Steps
    chance: float
    digest: str = ""


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
        alternatives: The next-best plans, in files of earlier versions.
        tolerance: How near objects had to come [m]; None if it was the problem's own tolerance.
        chance_replanned: The chance that the goal is reached with at most `MORE_MOTIONS` motions more than
            primitives, planned anew on the way; None without a plan, and if the plan is known to miss.
        misses: Where the plan goes wrong by what was rehearsed; empty if it leads to the goal.
        encoding: The encoding that the plan is printed for; earlier versions had others.
        unprinted: Why the steps are no plan of the printed domain and problem; empty if they are one.
        digest: SHA-256 of the file with the steps; empty if there is none, and in earlier versions.
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
    encoding: str = STRIPS
    unprinted: str = ""
    digest: str = ""

    @property
    def solved(self) -> bool:
        """Whether there is a plan."""
        return self.status is PlanStatus.SOLVED

    @property
    def primitives(self) -> int:
        """How many primitives the plan has."""
        return primitives(PlanStep(*step) for step in self.steps)

    @property
    def every_plan(self) -> Iterator[tuple[str, Steps]]:
        """File and steps of the plan and of the next-best ones."""
        yield plan_files(self.problem, self.planner)[0], self.steps
        yield from ((one.file, one.steps) for one in self.alternatives)


def write_plans(
    folder: DomainFolder,
    planner: str,
    own: Problem,
    problem: Problem,
    grounding: Grounding,
    result: PlanResult,
    encoding: EncodingName,
) -> tuple[GroundPlan, ...]:
    """Write what was found for a problem: plan and record.

    What is no plan of the printed domain and problem is written in short, and its file is called otherwise.

    Args:
        folder: The domain folder.
        planner: Name of the planner.
        own: The problem as it stands in the folder, which is what is printed.
        problem: The same with the tolerance that was asked for.
        grounding: The learned domain.
        result: What was found.
        encoding: The encoding that plans are printed for.

    Returns:
        The plans that were written, which the printed problem has to fit.
    """
    plan_file, record_file = plan_files(own.name, planner)
    make_folder(folder / PLANS)
    stem = plan_file.removesuffix(PLAN)
    for former in (*folder.path.glob(f"{stem}-alt-*"), folder / plan_file, folder / steps_file(plan_file)):
        remove(former)
    write = partial(_write, folder, own, grounding, encoding)
    misses = validate(result.steps, problem, grounding).reason if result.status is PlanStatus.SOLVED else ""
    main = write(plan_file, result.steps) if result.has_plan else _File()
    leads_there = result.has_plan and not misses
    record = PlanRecord(
        problem=own.name,
        planner=planner,
        status=result.status,
        steps=named_steps(result.steps),
        seconds=round(result.seconds, 3),
        reason=result.reason,
        chance=_chance(result.steps, problem, grounding) if result.has_plan else None,
        tolerance=None if problem.tolerance == own.tolerance else problem.tolerance,
        chance_replanned=_chance_replanned(result.steps, problem, grounding) if leads_there else None,
        misses=misses,
        encoding=encoding,
        unprinted=main.why_no_plan,
        digest=main.digest,
    )
    write_json(folder / record_file, record)
    return (main.plan,) if main.plan else ()


@dataclass(frozen=True, slots=True)
class _File:
    """A file with steps: its name and digest, and the plan that they are, or why they are none."""

    name: str = ""
    digest: str = ""
    plan: GroundPlan | None = None
    why_no_plan: str = ""


def _write(
    folder: DomainFolder,
    problem: Problem,
    grounding: Grounding,
    encoding: EncodingName,
    plan_file: str,
    steps: Sequence[PlanStep],
) -> _File:
    """Write steps for a problem, as a plan of the printed domain if they are one."""
    found = _printed(steps, problem, grounding, encoding)
    if isinstance(found, GroundPlan):
        name, text, plan, why = plan_file, found.text, found, ""
    else:
        name, text, plan, why = steps_file(plan_file), print_plan(steps, found), None, found
    write_atomically(folder / name, text)
    return _File(name, sha256(text.encode()).hexdigest(), plan, why)


def _printed(
    steps: Sequence[PlanStep], problem: Problem, grounding: Grounding, encoding: EncodingName
) -> GroundPlan | str:
    """Return steps as a plan of the printed domain, or why they are none."""
    checked = validate(steps, problem, grounding)
    if not checked.valid:
        return checked.reason
    try:
        return ground_plan(steps, problem, grounding, encoding)
    except InvalidValue as error:
        return str(error)


def written_steps(folder: DomainFolder, problem: str, planner: str) -> str | None:
    """Name the file of a plan, or of the steps in its place; None if a planner has neither.

    Args:
        folder: The domain folder.
        problem: Name of the problem.
        planner: Name of the planner.
    """
    plan_file, _ = plan_files(problem, planner)
    return next((file for file in (plan_file, steps_file(plan_file)) if (folder / file).is_file()), None)


def recorded_plans(
    folder: DomainFolder, problem: Problem, grounding: Grounding, *, besides: str = ""
) -> tuple[GroundPlan, ...]:
    """Return the plans that stand beside a problem and are still true, as far as their records can be read.

    Args:
        folder: The domain folder.
        problem: The problem.
        grounding: The learned domain.
        besides: Name of a planner whose plans are left out.
    """
    found = list[GroundPlan | str]()
    for path in sorted((folder / PLANS).glob(f"{problem.name}.*.json")):
        if path.name == f"{problem.name}.{besides}.json":
            continue
        try:
            record = read_json(path, PlanRecord)
            there = [steps for file, steps in record.every_plan if (folder / file).is_file()]
            plans = (tuple(PlanStep(*step) for step in steps) for steps in there)
            found += [
                _printed(steps, problem, grounding, NUMERIC if record.encoding == NUMERIC else STRIPS)
                for steps in plans
            ]
        except (InvalidFile, InvalidValue, UnknownChoice):
            continue  # of another time, or of somebody else: it does not matter what is printed for it
    return tuple(plan for plan in found if isinstance(plan, GroundPlan))


def record_beside(plan_file: Path) -> PlanRecord | None:
    """Return the record of how a plan was found, if the file is as it was written then.

    Args:
        plan_file: The plan, or steps that are none; its record, if it has one, stands beside it.
    """
    record = _record_beside(plan_file)
    if record is None:
        return None
    digests = {record.digest, *(other.digest for other in record.alternatives)} - {""}
    return record if not digests or digest(plan_file) in digests else None


def planned_tolerance(plan_file: Path) -> float | None:
    """Return the tolerance that a plan was made with [m]; None if it was the problem's own, or is not known.

    Args:
        plan_file: The plan; its record, if it has one, stands beside it.
    """
    record = _record_beside(plan_file)
    return record.tolerance if record else None


def _record_beside(plan_file: Path) -> PlanRecord | None:
    try:
        return read_json(plan_file.with_name(f"{re.sub(_ALTERNATIVE, '', plan_file.stem)}.json"), PlanRecord)
    except InvalidFile:
        return None


def _chance(steps: Sequence[PlanStep], problem: Problem, grounding: Grounding) -> float:
    return round(expected_success(steps, problem, grounding), 4)


def _chance_replanned(steps: Sequence[PlanStep], problem: Problem, grounding: Grounding) -> float:
    return round(expected_within(steps, problem, grounding, primitives(steps) + MORE_MOTIONS), 4)
