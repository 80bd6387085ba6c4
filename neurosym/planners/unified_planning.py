"""Planning through unified-planning, with the engine of it that is called `fast-downward`.

The engine runs in a process of its own, because its import is slow, it writes files into the current folder,
and its own time-outs leave processes behind. This module is also the program that runs there:
`python -m neurosym.planners.unified_planning DOMAIN PROBLEM PLAN ENGINE`.
"""

import sys
import time
from pathlib import Path

from neurosym.planners.process import Finished, read_text, run_limited
from neurosym.planners.result import PlannerAnswer, PlanStatus
from neurosym.planners.scratch import scratch_folder

_EXIT = {PlanStatus.SOLVED: 0, PlanStatus.UNSOLVABLE: 10, PlanStatus.TIMEOUT: 21, PlanStatus.FAILED: 3}


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
        lines = (" ".join((a.action.name, *map(str, a.actual_parameters))) for a in result.plan.actions)
        Path(plan).write_text("".join(f"({line})\n" for line in lines))
        return PlanStatus.SOLVED, said
    if result.status in (Status.UNSOLVABLE_PROVEN, Status.UNSOLVABLE_INCOMPLETELY):
        return PlanStatus.UNSOLVABLE, said
    return PlanStatus.TIMEOUT if result.status is Status.TIMEOUT else PlanStatus.FAILED, said


if __name__ == "__main__":
    status, said = _main(*sys.argv[1:])
    print(said)  # the last words become the reason, if there is no plan
    sys.exit(_EXIT[status])
