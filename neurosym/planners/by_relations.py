"""Planning with relations: objects stand at places or on and in one another; nothing is led over cells."""

import dataclasses
import textwrap
import time
from functools import partial
from pathlib import Path

import msgspec

from neurosym.drafts import naming
from neurosym.errors import InvalidPlan, InvalidValue
from neurosym.pair_sight import with_pairs
from neurosym.pddl.encoding_names import STRIPS
from neurosym.pddl.encodings import domain_text
from neurosym.pddl.plan_reading import parse_plan
from neurosym.pddl.problem import problem_text
from neurosym.planners.effort import UNTOLD, check_time, within
from neurosym.planners.planner import PddlProgram, Planner, Query
from neurosym.planners.relational_bfs import plan_relational_bfs
from neurosym.planners.result import PlannerAnswer, PlanResult, PlanStatus
from neurosym.planners.scratch import scratch_folder
from neurosym.problems import Problem
from neurosym.related import is_reached, is_relational, relations_of
from neurosym.tasks.pair_goals import why_no_relation
from neurosym.tasks.task import understand
from neurosym.tasks.transition import validate

BREADTH_FIRST = ("bfs", "bfs-operators")
"""These search themselves: the first by what a network foresees of each pair, the other by what rehearsals
showed for its kind."""


def by_relations(planner: Planner, query: Query, takers: tuple[str, ...], *, is_ours: bool) -> Planner:
    """Return a planner such that it plans with relations, if that is what is asked.

    Args:
        planner: The planner.
        query: What it is asked.
        takers: Names of the planners that can be asked for relations in PDDL.
        is_ours: Whether it is none that somebody wrote, who may do with relations what they like.

    Raises:
        InvalidValue: If it does not take relations, or the encoding does not.
    """
    problem, grounding = query.problem, query.grounding
    if not is_relational(problem, grounding):
        return planner
    relations_of(grounding, problem)
    if query.encoding not in (None, STRIPS):
        raise InvalidValue(
            f"The problem {problem.name} is one of relations, which the encoding {query.encoding} cannot "
            f"say; valid: {STRIPS}."
        )
    if planner.name in takers:
        assert planner.program is not None
        solve = partial(plan_by_relations, program=planner.program)
        return dataclasses.replace(planner, solve=solve)
    if planner.name in BREADTH_FIRST and is_ours:
        return dataclasses.replace(
            planner, solve=partial(_breadth_first, foresees=planner.reads == "network")
        )
    if planner.program is None and not is_ours:
        return planner
    raise InvalidValue(
        f"The problem {problem.name} is one of relations, which {planner.name} does not take; valid: "
        f"{', '.join(sorted((*takers, *BREADTH_FIRST)))}."
    )


def plan_by_relations(query: Query, *, program: PddlProgram) -> PlanResult:
    """Solve a problem with a PDDL planner, and believe the plan only if its replay is right.

    Args:
        query: What is asked.
        program: What reads the files.

    Raises:
        InvalidValue: If an object's name means something else in the domain.
    """
    problem = with_pairs(query.problem, query.grounding.relations)
    return _told_at_once(problem, query) or within(
        query.time_limit, partial(_search, query, problem, program)
    )


def _breadth_first(query: Query, *, foresees: bool) -> PlanResult:
    problem = with_pairs(query.problem, query.grounding.relations)
    problem = problem if foresees else msgspec.structs.replace(problem, foreseen=msgspec.UNSET)
    searched = partial(plan_relational_bfs, problem, query.grounding, time_limit=query.time_limit)
    return _told_at_once(problem, query) or searched()


def _told_at_once(problem: Problem, query: Query) -> PlanResult | None:
    """Say that there is nothing to do, or that nothing can be done; None if it takes a search to tell."""
    if is_reached(problem, query.grounding):
        return PlanResult(PlanStatus.SOLVED, (), 0.0, "the goal is met at the start")
    if reason := why_no_relation(problem, query.grounding):
        return PlanResult(PlanStatus.UNSOLVABLE, (), 0.0, reason)
    return None


def _search(query: Query, problem: Problem, program: PddlProgram, deadline: float) -> PlanResult:
    """Print domain and problem, and call the planner."""
    grounding = query.grounding
    check_time(deadline)
    costs = program.costs
    texts = domain_text(grounding, costs=costs), problem_text(problem, grounding, costs=costs)
    with scratch_folder() as folder:
        domain, task = folder / "domain.pddl", folder / "problem.pddl"
        for file, text in zip((domain, task), texts, strict=True):
            with naming(file):
                file.write_text(text)
        answer = program.call(domain, task, time_limit=deadline - time.perf_counter())
    judged = _judged(answer, problem, query)
    return dataclasses.replace(judged, work=UNTOLD if answer.work is None else answer.work)


def _judged(answer: PlannerAnswer, problem: Problem, query: Query) -> PlanResult:
    """Read what a program wrote, and replay it."""
    if answer.status is PlanStatus.UNSOLVABLE:
        reason = f"no plan with the places that were drawn{_why(problem, query)}"
        return PlanResult(PlanStatus.NOT_FOUND, (), answer.seconds, reason)
    try:
        steps = parse_plan(answer.text, Path("its plan"), query.grounding, problem)
    except InvalidPlan as error:
        said = f"what the planner wrote cannot be read: {textwrap.shorten(str(error), 200)}"
        return PlanResult(PlanStatus.FAILED, (), answer.seconds, said)
    if answer.status is not PlanStatus.SOLVED:
        return PlanResult(answer.status, (), answer.seconds, answer.reason)
    checked = validate(steps, problem, query.grounding)
    if checked.valid:
        return PlanResult(PlanStatus.SOLVED, steps, answer.seconds, answer.reason)
    said = f"the plan with relations is not true when replayed: {checked.reason}"
    return PlanResult(PlanStatus.FAILED, (), answer.seconds, said)


def _why(problem: Problem, query: Query) -> str:
    """Name the objects with a goal on the table that nothing carries there."""
    task = understand(problem, query.grounding)
    fixed = [name for name in problem.unmet if name not in task.carriers]
    if not fixed:
        return ""
    verb = "has a goal" if len(fixed) == 1 else "have goals"
    return f"; {' and '.join(fixed)} {verb} on the table, and nothing carries it to places"
