"""Plans and what became of them, for the page."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

from neurosym.execution.record import Run
from neurosym.problems import Problem
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
    """List the plans of a folder, by problem and planner, with their runs, as far as they can be read."""
    runs = {example.name: example for example in examples}
    rows = []
    for path in sorted((folder / PLANS).glob("*.json")):
        record = spared(partial(read_json, path, PlanRecord), folder.notify)
        if record and (problem := read_problem(record.problem)):
            rows.append(_row(problem, record, runs.pop(path.stem, None) if record.solved else None))
    rows += [_row(example.problem, None, example) for example in runs.values()]
    return tuple(sorted(rows, key=lambda row: (row.problem, row.planner)))


def _row(problem: Problem, record: PlanRecord | None, example: Example | None) -> PlanRow:
    """Tell of a plan with its run, or of a run alone, whose plan was given."""
    run = example.run if example else None
    if record:
        planner, status, seconds = record.planner, record.status.value, record.seconds
        steps = record.primitives if record.solved else None
    else:
        assert example, "either is there"
        planner, status, seconds, steps = example.planner, "given", None, len(example.run.plan)
    return PlanRow(
        problem=problem.name,
        objects=len(problem.objects),
        planner=planner,
        status=status,
        steps=steps,
        seconds=seconds,
        reached=run.reached if run else None,
        own=(run.own_steps, len(run.steps)) if run else None,
        reason=_remark(run or record, record.reason if record else ""),
    )


def _remark(record: PlanRecord | Run | None, otherwise: str) -> str:
    """Say what is to be said about a plan or its run, and by which tolerance it is judged if by its own."""
    assert record, "either is there"
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


def summaries(rows: Sequence[PlanRow]) -> tuple[PlannerSummary, ...]:
    """Count for each planner the plans it found and the runs that reached their goals."""
    found = []
    for planner in sorted({row.planner for row in rows}):
        own = [row for row in rows if row.planner == planner]
        reached = [row for row in own if row.reached]
        found.append(
            PlannerSummary(
                planner=planner,
                problems=len(own),
                found=sum(row.steps is not None for row in own),
                runs=sum(row.reached is not None for row in own),
                reached=len(reached),
                alone=sum(len({*(row.own or ())}) == 1 for row in reached),
            )
        )
    return tuple(found)
