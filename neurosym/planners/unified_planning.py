"""Problems for unified-planning, plans from it, and planning with its engines.

An engine runs in a process of its own, because the import is slow, engines write files into the current
folder, and their own time-outs leave processes behind.
"""

import sys
from pathlib import Path
from typing import TYPE_CHECKING

from neurosym.checks import check_kind
from neurosym.errors import InvalidValue
from neurosym.grounding import Grounding
from neurosym.pddl.encoding_names import STRIPS, EncodingName
from neurosym.pddl.encodings import domain_text
from neurosym.pddl.plan_reading import parse_plan
from neurosym.pddl.problem import problem_text
from neurosym.planners.external import UNSOLVABLE, Program
from neurosym.problems import Problem
from neurosym.tasks.steps import PlanStep

if TYPE_CHECKING:
    from unified_planning.model import Problem as Task
    from unified_planning.plans import Plan

_EXIT = {"UNSOLVABLE_PROVEN": 10, "UNSOLVABLE_INCOMPLETELY": 12, "TIMEOUT": 21}
"""How the process of an engine ends, as Fast Downward does, by what unified-planning says."""


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
        plan: The plan, a sequence.
        problem: The problem that `to_unified_planning` was given.
        grounding: The learned domain.

    Raises:
        InvalidValue: If it is no sequence of actions.
        InvalidPlan: If it names an operator, object or pair that does not exist.
    """
    from unified_planning.plans import SequentialPlan

    check_kind("problem", problem, Problem, "a Problem")
    check_kind("grounding", grounding, Grounding, "a Grounding")
    if not isinstance(plan, SequentialPlan):
        raise InvalidValue(
            f"A {type(plan).__name__} is no sequence of actions; valid: a SequentialPlan of unified-planning."
        )
    return parse_plan(_text(plan), Path("the plan"), grounding, problem)


def _text(plan: "Plan") -> str:
    lines = (" ".join((one.action.name, *map(str, one.actual_parameters))) for one in plan.actions)
    return "".join(f"({line})\n" for line in lines)


def engine_program(engine: str, package: str = "unified_planning") -> Program:
    """Return an engine of unified-planning as a program.

    Args:
        engine: What unified-planning calls it.
        package: The Python package that brings it.
    """
    ours = str(Path(__file__).resolve().parents[2])
    code = f"import sys; sys.path.insert(0, {ours!r}); import {__name__} as run; run.main(*sys.argv[1:])"
    command = ("{python}", "-c", code, "{domain}", "{problem}", "{plan}", engine)
    return Program(f"{engine} through unified-planning", package, command, unsolvable=UNSOLVABLE)


def main(domain: str, problem: str, plan: str, engine: str) -> None:
    """Read, solve and write the plan, or end with an exit code that says how it went.

    Args:
        domain: File of the domain.
        problem: File of the problem.
        plan: File that the plan is written to.
        engine: What unified-planning calls the engine.
    """
    from unified_planning.io import PDDLReader
    from unified_planning.plans import PlanKind
    from unified_planning.shortcuts import OneshotPlanner, get_environment

    get_environment().credits_stream = None
    task = PDDLReader().parse_problem(domain, problem)
    with OneshotPlanner(name=engine) as planner:
        result = planner.solve(task)
    if result.plan is None:
        said = result.status.name
        sys.exit(_EXIT.get(said, f"unified-planning says {said}"))
    Path(plan).write_text(_text(result.plan.convert_to(PlanKind.SEQUENTIAL_PLAN, task)))
