"""Plans and what became of them, for the page."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

from neurosym.execution.record import Run
from neurosym.reading import read_json
from neurosym.report.examples import Example, ProblemReader, spared
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import PLANS
from neurosym.stages.plan_records import PlanRecord


@dataclass(frozen=True, slots=True)
class PlanRow:
    """What a planner made of a problem.

    Attributes:
        problem: Name of the problem.
        objects: How many objects it has.
        planner: Name of the planner.
        status: Whether there is a plan, and if not, why.
        steps: How many steps the plan has; None without one.
        seconds: How long planning took [s]; None if only the run is known.
        reached: Whether its run reached the goal; None without a run.
        own: How many of the steps performed are the plan's own, and how many there are; None without a run.
        reason: What is to be said about it.
    """

    problem: str
    objects: int
    planner: str
    status: str
    steps: int | None
    seconds: float | None
    reached: bool | None
    own: tuple[int, int] | None
    reason: str


def plan_rows(
    folder: DomainFolder, examples: Sequence[Example], read_problem: ProblemReader
) -> tuple[PlanRow, ...]:
    """List the plans of a folder, by problem and planner, with their runs, as far as they can be read.

    Args:
        folder: The domain folder.
        examples: The runs.
        read_problem: Reads the problems.
    """
    runs = {example.name: example for example in examples}
    rows = []
    for path in sorted((folder / PLANS).glob("*.json")):
        record = spared(partial(read_json, path, PlanRecord), folder.notify)
        problem = read_problem(record.problem) if record else None
        if record is None or problem is None:
            continue
        example = runs.pop(path.stem, None) if record.solved else None
        rows.append(
            PlanRow(
                problem=record.problem,
                objects=len(problem.objects),
                planner=record.planner,
                status=record.status.value,
                steps=record.primitives if record.solved else None,
                seconds=record.seconds,
                reached=example.run.reached if example else None,
                own=_own(example.run) if example else None,
                reason=_remark(example.run if example else record, record.reason),
            )
        )
    for example in runs.values():
        rows.append(
            PlanRow(
                problem=example.problem.name,
                objects=len(example.problem.objects),
                planner=example.planner,
                status="given",
                steps=len(example.run.plan),
                seconds=None,
                reached=example.run.reached,
                own=_own(example.run),
                reason=_remark(example.run),
            )
        )
    return tuple(sorted(rows, key=lambda row: (row.problem, row.planner)))


def _own(run: Run) -> tuple[int, int]:
    return run.own_steps, len(run.steps)


def _remark(record: PlanRecord | Run, otherwise: str = "") -> str:
    """Say what is to be said about a plan or its run, and by which tolerance it is judged if by its own."""
    within = "" if record.tolerance is None else f"within {1000 * record.tolerance:g} mm"
    return ": ".join(filter(None, (within, record.reason or otherwise)))


@dataclass(frozen=True, slots=True)
class PlannerSummary:
    """What a planner made of all problems; `alone` counts those reached by its plans without a new one."""

    planner: str
    problems: int
    found: int
    runs: int
    reached: int
    alone: int


def summaries(rows: tuple[PlanRow, ...]) -> tuple[PlannerSummary, ...]:
    """Count for each planner the plans it found and the runs that reached their goals."""
    planners = sorted({row.planner for row in rows})
    return tuple(_summary(planner, [row for row in rows if row.planner == planner]) for planner in planners)


def _summary(planner: str, rows: list[PlanRow]) -> PlannerSummary:
    return PlannerSummary(
        planner=planner,
        problems=len(rows),
        found=sum(row.steps is not None for row in rows),
        runs=sum(row.reached is not None for row in rows),
        reached=sum(row.reached is True for row in rows),
        alone=sum(row.reached is True and len({*(row.own or ())}) == 1 for row in rows),
    )
