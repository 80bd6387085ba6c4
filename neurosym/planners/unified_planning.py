"""Problems for unified-planning, plans from it, and planning with its engine that is called `fast-downward`.

The engine runs in a process of its own, because its import is slow, it writes files into the current folder,
and its own time-outs leave processes behind. This module is also the program that runs there:
`python -m neurosym.planners.unified_planning DOMAIN PROBLEM PLAN ENGINE`.
"""

import sys
import time
from collections.abc import Iterable, Sequence
from itertools import islice, pairwise
from pathlib import Path
from typing import TYPE_CHECKING

from neurosym.checks import check_kind
from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.pddl.encoding_names import STRIPS, EncodingName
from neurosym.pddl.encodings import domain_text
from neurosym.pddl.plan_reading import parse_plan
from neurosym.pddl.problem import problem_text
from neurosym.planners.process import Finished, read_text, run_limited
from neurosym.planners.result import PlannerAnswer, PlanStatus
from neurosym.planners.scratch import scratch_folder
from neurosym.problems import Problem
from neurosym.tasks.steps import PlanStep

if TYPE_CHECKING:
    from unified_planning.model import Problem as Task
    from unified_planning.plans import ActionInstance, Plan

_EXIT = {
    PlanStatus.SOLVED: 0,
    PlanStatus.FAILED: 3,
    PlanStatus.UNSOLVABLE: 10,
    PlanStatus.NOT_FOUND: 12,
    PlanStatus.TIMEOUT: 21,
}


def to_unified_planning(
    problem: Problem, grounding: Grounding, encoding: EncodingName | None = None
) -> "Task":
    """Return a problem as unified-planning has it, which any of its engines may solve.

    Args:
        problem: The problem.
        grounding: The learned domain.
        encoding: How it is encoded; by default as on the page.

    Raises:
        InvalidValue: If something is not what it should be.
        UnknownChoice: If there is no such encoding.
    """
    from unified_planning.io import PDDLReader

    check_kind("problem", problem, Problem, "a Problem")
    check_kind("grounding", grounding, Grounding, "a Grounding")
    chosen = encoding or STRIPS
    texts = domain_text(grounding, chosen), problem_text(problem, grounding, chosen)
    return PDDLReader().parse_problem_string(*texts)


def from_unified_planning(plan: "Plan", problem: Problem, grounding: Grounding) -> tuple[PlanStep, ...]:
    """Return the steps of a plan that an engine of unified-planning made, as `execute` takes them.

    Args:
        plan: The plan; one of partial order, or with times, if it leaves only one sequence.
        problem: The problem that `to_unified_planning` was given.
        grounding: The learned domain.

    Raises:
        InvalidValue: If it is no sequence of actions.
        InvalidPlan: If it names an operator, object or pair that does not exist.
    """
    check_kind("problem", problem, Problem, "a Problem")
    check_kind("grounding", grounding, Grounding, "a Grounding")
    return parse_plan(_text(_sequence(plan)), Path("the plan"), grounding, problem)


def _sequence(plan: "Plan") -> "Sequence[ActionInstance]":
    """Return the actions of a plan one after another.

    Raises:
        InvalidValue: If it is no plan, or one that leaves open which action comes first.
    """
    from unified_planning.plans import PartialOrderPlan, SequentialPlan, TimeTriggeredPlan

    if isinstance(plan, SequentialPlan):
        return list(plan.actions)
    if isinstance(plan, PartialOrderPlan):
        first, *others = islice(plan.all_sequential_plans(), 2)
        if others:
            pairs = zip(first.actions, others[0].actions, strict=True)
            one, other = next((one, other) for one, other in pairs if one != other)
            raise InvalidValue(f"The plan leaves open whether {one} or {other} comes first; order them.")
        return list(first.actions)
    if isinstance(plan, TimeTriggeredPlan):
        timed = sorted(plan.timed_actions, key=lambda row: row[0])
        for (start, one, lasts), (then, other, _) in pairwise(timed):
            if then < start + (lasts or 0) or then == start:
                raise InvalidValue(f"{one} and {other} overlap in the plan; one hand does one after another.")
        return [action for _, action, _ in timed]
    raise InvalidValue(
        f"A {type(plan).__name__} is no plan; valid: a SequentialPlan of unified-planning, or a "
        "PartialOrderPlan or TimeTriggeredPlan that leaves only one sequence."
    )


def _text(actions: "Iterable[ActionInstance]") -> str:
    lines = (" ".join((one.action.name, *map(str, one.actual_parameters))) for one in actions)
    return "".join(f"({line})\n" for line in lines)


def plan_unified_planning(
    domain: Path, problem: Path, *, time_limit: float, engine: str = "fast-downward"
) -> PlannerAnswer:
    """Solve a PDDL problem with an engine of unified-planning.

    Args:
        domain: File of the domain.
        problem: File of the problem.
        time_limit: When to give up [s].
        engine: What unified-planning calls the engine.
    """
    begin = time.perf_counter()
    with scratch_folder() as folder:
        plan = folder / "plan"
        files = (str(domain.resolve()), str(problem.resolve()), str(plan))
        command = [sys.executable, "-m", __spec__.name, *files, engine]
        package = str(Path(__file__).resolve().parents[2])
        finished = run_limited(command, folder, time_limit, environment={"PYTHONPATH": package})
        status, reason = _judge(finished)
        text = read_text(plan) if status is PlanStatus.SOLVED else ""
    return PlannerAnswer(status, text, time.perf_counter() - begin, reason)


def _judge(finished: Finished) -> tuple[PlanStatus, str]:
    if finished.code is None:
        return PlanStatus.TIMEOUT, "unified-planning found no plan in time"
    for status, code in _EXIT.items():
        if finished.code == code:
            return status, "" if status is PlanStatus.SOLVED else finished.last_words
    return PlanStatus.FAILED, f"unified-planning ended with code {finished.code}: {finished.last_words}"


def _main(domain: str, problem: str, plan: str, engine: str) -> tuple[PlanStatus, str]:
    """Read, solve, and write the plan; return how it went, and that in words."""
    from unified_planning.engines import PlanGenerationResultStatus as Status
    from unified_planning.io import PDDLReader
    from unified_planning.shortcuts import OneshotPlanner, get_environment

    get_environment().credits_stream = None
    task = PDDLReader().parse_problem(domain, problem)
    with OneshotPlanner(name=engine) as planner:
        result = planner.solve(task)
    said = f"{engine} through unified-planning says {result.status.name}"
    if result.plan is not None:
        Path(plan).write_text(_text(_sequence(result.plan)))
        return PlanStatus.SOLVED, said
    if result.status is Status.UNSOLVABLE_PROVEN:
        return PlanStatus.UNSOLVABLE, said
    if result.status is Status.UNSOLVABLE_INCOMPLETELY:
        return PlanStatus.NOT_FOUND, said
    return PlanStatus.TIMEOUT if result.status is Status.TIMEOUT else PlanStatus.FAILED, said


if __name__ == "__main__":
    status, said = _main(*sys.argv[1:])
    print(said)  # the last words become the reason, if there is no plan
    sys.exit(_EXIT[status])
