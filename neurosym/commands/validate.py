"""The command `neurosym validate`: whether a plan is one, without executing it."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from tyro.conf import Positional, arg

from neurosym.commands.answers import Json, answer_in
from neurosym.commands.exit_codes import NO_RESULT
from neurosym.commands.options import Folder, ProblemName, Tolerance, opened
from neurosym.commands.plan_streams import given_plan
from neurosym.console import say, say_next
from neurosym.wording import counted, quoted

if TYPE_CHECKING:
    from neurosym.stages.plan_verdict import PlanVerdict


def validate(
    folder: Folder,
    problem: ProblemName,
    plan_file: Annotated[
        Positional[Path], arg(metavar="PLAN", help="Any planner's plan; - reads it from standard input.")
    ],
    tolerance: Tolerance = None,
    json: Json = False,
) -> int:
    """Judge a plan without executing it; exit code 3 if it is none.

    unified-planning's validator says whether it is a plan of the printed domain and problem. A replay says
    whether it leads to the goal by what was rehearsed, and whether objects end in each other: PDDL does not
    see that where objects are led over cells.
    """
    from neurosym.stages.plan_verdict import judge_plan

    answer, domain = answer_in(json), opened(folder)
    name = domain.problem(problem)
    plan_file = given_plan(domain, folder, name, plan_file, must_fit=False)
    verdict = judge_plan(domain, name, plan_file, tolerance)
    _say_verdict(verdict)
    if verdict.steps:
        say_next(f"neurosym execute {quoted(folder)} {name} {quoted(plan_file)}")
    answer(verdict, valid=verdict.valid)
    return 0 if verdict.valid else NO_RESULT


def _say_verdict(verdict: "PlanVerdict") -> None:
    by = verdict.domain or "PDDL"
    whole = ", written out with cells and places" if verdict.written_out else ""
    where = "" if verdict.pddl_failed is None else f"action {verdict.pddl_failed}: "
    said = "valid" if verdict.valid_by_pddl else f"not valid; {where}{verdict.pddl_reason}"
    say(f"by {by}{whole}, as unified-planning's validator says: {said}")
    say(f"by its replay: {'valid' if verdict.valid_by_replay else f'not valid; {verdict.replay_reason}'}")
    if verdict.chance is not None:
        say(f"{verdict.chance:.0%} likely to go as promised, followed as it is")
    steps = counted(len(verdict.steps), "step")
    say(f"{verdict.plan}: {f'a plan of {steps}' if verdict.valid else 'no plan'} for {verdict.problem}")
