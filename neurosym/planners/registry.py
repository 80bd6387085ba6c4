"""Planning by name: ours, those that were registered, and anybody's own as `module:factory`.

What a planner of one's own returns is checked, and only what comes true is believed. Where relations are
asked for, objects stand at places or on and in one another, and nothing is led over cells.
"""

import dataclasses
import math
import reprlib
import sys
from collections.abc import Callable, Hashable
from contextlib import chdir, redirect_stdout
from functools import partial
from io import StringIO
from pathlib import Path

import msgspec

from neurosym.checks import check_callable, check_kind
from neurosym.choices import admit, is_factory, load_factory, one_line, told
from neurosym.errors import InvalidPlanner, InvalidValue, UnknownChoice, counted, shortened
from neurosym.grounding import Grounding
from neurosym.pddl.compiler import domain_text, problem_text
from neurosym.pddl.grid import check_on_table
from neurosym.pddl.plan_reading import parse_plan
from neurosym.pddl.syntax import STRIPS, EncodingName
from neurosym.planners.pddl_search import FILES, answered, ask
from neurosym.planners.planner import (
    LONGEST_REASON,
    UNTOLD,
    Option,
    PddlProgram,
    Planner,
    PlannerMissing,
    PlanResult,
    PlanStatus,
    PredictEffects,
    Query,
    Tell,
    check_time,
    within,
)
from neurosym.planners.planner_table import PLANNERS
from neurosym.problems import NEAR_TABLE, Problem, spot_named
from neurosym.tasks.pair_goals import why_no_relation
from neurosym.tasks.supports import is_reached, is_relational, relations_of
from neurosym.tasks.task import Task, understand, with_places
from neurosym.tasks.transition import PlanStep, State, apply, missed, refusal, start, validate

Replanner = Callable[[Problem, Grounding], PlanResult]
"""Plans from where things are now, with what is now believed of them."""
OURS = dict(PLANNERS)
MOST_STEPS = 60_000
"""How many steps are looked at."""
BREADTH_FIRST = ("bfs", "bfs-operators")
"""These search themselves: the first by what a network foresees of each pair, the other by what rehearsals
showed for its kind."""


def plan(
    problem: Problem,
    grounding: Grounding,
    planner: str | Planner = "fast-downward",
    *,
    predict: PredictEffects | None = None,
    time_limit: float | None = None,
    encoding: EncodingName | None = None,
    whole: bool = False,
    costs: bool = True,
    work: int | None = None,
    tell: Tell | None = None,
) -> PlanResult:
    """Plan with any planner; finding no plan is a result.

    Args:
        problem: The problem.
        grounding: The learned domain.
        planner: The planner, or its name; see `planner_named`.
        predict: For planners that read the network, what it predicts; what the operators promise, if not
            given.
        time_limit: The user's ceiling [s]; the planner's own if not given, and ours have none.
        encoding: For PDDL planners, the encoding of the domain; the one that the planner does best with, if
            not given.
        whole: For PDDL planners, solve for all objects at once instead of one by one.
        costs: Whether steps cost the more the rarer they keep their promise; otherwise each costs 1.
        work: How much may be looked at in all [states, see `effort`], for PDDL planners; only each search
            has a budget of its own, if not given.
        tell: Told what is tried, if given.

    Raises:
        UnknownChoice: If there is no such planner, or an object's category is unknown.
        PlannerMissing: If the planner is not installed.
        InvalidPlanner: If it is somebody's own, and fails or returns what is no result.
        InvalidValue: If the planner does not take the encoding or an option, or an object stands farther off
            the table than a push may have left it.
    """
    check_kind("problem", problem, Problem, "a Problem")
    check_kind("grounding", grounding, Grounding, "a Grounding")
    if time_limit is not None:
        check_kind("time_limit", time_limit, int | float, "a time above 0 s")
        if not time_limit > 0:
            raise InvalidValue(f"time_limit = {time_limit} s must be above 0 s.")
    if work is not None:
        check_kind("work", work, int, "a number of states")
    if tell is not None:
        check_callable("tell", tell, "a function of a text")
    if predict is not None:
        check_callable("predict", predict, "a function from features (M, F) to effects (M, P, 3)")
    chosen = planner_named(planner) if isinstance(planner, str) else planner
    _check_planner(chosen, "given")
    is_ours = OURS.get(chosen.name) is chosen
    check_options(chosen, encoding=encoding, whole=whole, costs=costs)
    for item in problem.objects:
        check_on_table(item, grounding, off=NEAR_TABLE)
    _check_installed(chosen)
    if not costs:
        grounding = msgspec.structs.replace(grounding, unit_costs=True)
    read = predict if chosen.reads == "network" else None
    ceiling = chosen.ceiling if time_limit is None else time_limit
    query = Query(problem, grounding, read, ceiling, encoding, whole, sys.maxsize if work is None else work)
    query = query if tell is None else dataclasses.replace(query, tell=tell)
    chosen = _by_relations(chosen, query, is_ours=is_ours)
    result = chosen.solve(query) if is_ours else solve_checked(chosen, query)
    if result.has_plan or result.reason:
        return result
    return dataclasses.replace(result, reason=_unexplained(chosen, result.status))


def planner_named(name: str, domain_folder: Path | None = None) -> Planner:
    """Return a planner by its name.

    Args:
        name: One of `PLANNERS`, or `module:factory` for what returns one.
        domain_folder: Where a domain lies, which must not bring code of its own; if there is one.

    Raises:
        UnknownChoice: If there is no such planner.
        InvalidPlanner: If somebody's own is not found, cannot be made, or is no `Planner`.
    """
    if not is_factory(name):
        if name not in PLANNERS:
            raise UnknownChoice("planner", name, [*PLANNERS, "your own as module:factory"])
        return PLANNERS[name]
    if domain_folder is not None:
        admit(name, domain_folder, InvalidPlanner)
    made = load_factory(name, InvalidPlanner)
    if callable(made) and not isinstance(made, Planner):
        try:
            made = made()
        except (InvalidPlanner, KeyboardInterrupt):
            raise
        except BaseException as error:
            raise InvalidPlanner(name, f"cannot be made: {told(error)}") from error
    _check_planner(made, name)
    if made.name in OURS:
        raise InvalidPlanner(name, f"has the name {made.name!r}, which one of ours has; give it another")
    return made  # type: ignore[no-any-return]


def register_planner(planner: Planner) -> None:
    """Let a planner be called by its name, in this process; on the command line it is `module:factory`.

    A second one of the same name takes the place of the first.

    Raises:
        InvalidPlanner: If it is no `Planner`, or has the name of one of ours.
    """
    _check_planner(planner, repr(planner))
    if planner.name in OURS:
        raise InvalidPlanner(planner.name, "has a name which one of ours has; give it another")
    PLANNERS[planner.name] = planner


def check_options(planner: Planner, *, encoding: EncodingName | None, whole: bool, costs: bool) -> None:
    """Refuse options that a planner does not take.

    Args:
        planner: The planner.
        encoding: The encoding asked for, if any.
        whole: Whether it is to solve for all objects at once.
        costs: Whether steps have costs.

    Raises:
        InvalidValue: If it does not take the encoding or an option.
    """
    asked: dict[Option, bool] = {"encoding": encoding is not None, "whole": whole, "unit-costs": not costs}
    for option, is_asked in asked.items():
        if is_asked and option not in planner.takes:
            takers = ", ".join(sorted(other.name for other in PLANNERS.values() if option in other.takes))
            raise InvalidValue(f"The planner {planner.name} does not take {option}; valid with it: {takers}.")
    if planner.program:
        planner.program.encoding_for(planner.name, encoding)


def solve_checked(planner: Planner, query: Query) -> PlanResult:
    """Ask somebody's own planner, and believe of what it returns only what comes true.

    Args:
        planner: The planner.
        query: What it is asked.

    Raises:
        InvalidPlanner: If it raises an error, or returns no `PlanResult`.
    """
    try:
        # What it prints is no part of our answer, and where it goes to is not where we write.
        with redirect_stdout(StringIO()), chdir(Path.cwd()):
            result = planner.solve(query)
    except (InvalidValue, KeyboardInterrupt):
        raise
    except BaseException as error:
        raise InvalidPlanner(planner.name, f"raises an error in solve: {told(error)}") from error
    _check_result(planner.name, result)
    result = dataclasses.replace(result, reason=one_line(result.reason, LONGEST_REASON))
    if unknown := _unknown(result, query):
        return PlanResult(PlanStatus.FAILED, (), result.seconds, f"its plan names {unknown}")
    if result.status is PlanStatus.SOLVED and planner.reads == "operators":
        checked = validate(result.steps, query.problem, query.grounding)
        if not checked.valid:
            reason = f"its plan is not true when replayed: {checked.reason}"
            return PlanResult(PlanStatus.FAILED, (), result.seconds, reason)
    return result


def _unexplained(planner: Planner, status: PlanStatus) -> str:
    """Say in a planner's place why it has no plan, where it says nothing."""
    ends = {PlanStatus.TIMEOUT: "found no plan in time", PlanStatus.UNSOLVABLE: "says that there is no plan"}
    return f"{planner.name} {ends.get(status, 'failed, and does not say why')}"


def _check_planner(planner: object, name: str) -> None:
    """Raise `InvalidPlanner` unless something is a planner."""
    if not isinstance(planner, Planner):
        kind = type(planner).__name__
        raise InvalidPlanner(
            name, f"is no Planner but of type {kind}; return what neurosym.pddl_planner makes"
        )


def _check_installed(planner: Planner) -> None:
    """Raise `PlannerMissing`, which says what to do, unless a planner is installed."""
    try:
        with redirect_stdout(StringIO()):
            remedy = planner.missing()
    except KeyboardInterrupt:
        raise
    except BaseException as error:
        raise InvalidPlanner(planner.name, f"raises an error in missing: {told(error)}") from error
    if not isinstance(remedy, str):
        raise InvalidPlanner(planner.name, f"gives {remedy!r} from missing; valid: text")
    if remedy:
        raise PlannerMissing(planner.name, remedy)


def _check_result(name: str, result: object) -> None:
    """Raise `InvalidPlanner` unless something is a result, part by part."""
    if not isinstance(result, PlanResult):
        raise InvalidPlanner(name, f"gives a {type(result).__name__} from solve; valid: a PlanResult")
    is_steps = isinstance(result.steps, tuple | list) and all(
        isinstance(step, PlanStep) and isinstance(step.operator, str) and isinstance(step.object, str)
        for step in result.steps
    )
    for part, is_right, valid in (
        ("status", isinstance(result.status, PlanStatus), "a PlanStatus"),
        ("steps", is_steps, "a tuple of PlanStep"),
        ("seconds", isinstance(result.seconds, int | float) and math.isfinite(result.seconds), "a number"),
        ("reason", isinstance(result.reason, str), "text"),
    ):
        if not is_right:
            given = reprlib.repr(getattr(result, part))
            raise InvalidPlanner(name, f"gives a result with {part} = {given}; valid: {valid}")


def _unknown(result: PlanResult, query: Query) -> str:
    """Name the first operator, object or place of a plan that there is not, or return nothing."""
    grounding, names = query.grounding, query.problem.object_names
    carries = {operator.name: grounding.carries(operator) for operator in grounding.every_operator}
    places = with_places(query.problem, grounding).places if any(carries.values()) else {}
    for step in result.steps:
        if grounding.relation_named(step.base):
            if unknown := [name for name in (step.object, step.place) if name not in names]:
                return f"the object {shortened(unknown[0])!r}, which the problem does not have"
            continue
        if step.base not in carries:
            return f"the operator {shortened(step.operator)!r}, which the domain does not have"
        if step.object not in names:
            return f"the object {shortened(step.object)!r}, which the problem does not have"
        known = places if carries[step.base] else {"": None}
        if step.place not in known and not (carries[step.base] and spot_named(step.place)):
            return f"the place {shortened(step.place)!r} for {step.operator}, which the problem does not have"
    return ""


def _by_relations(planner: Planner, query: Query, *, is_ours: bool) -> Planner:
    """Return a planner such that it plans with relations, if that is what is asked.

    It may be one that somebody wrote, who may do with relations what they like.
    """
    problem, grounding = query.problem, query.grounding
    if not is_relational(problem, grounding):
        return planner
    relations_of(grounding, problem)
    takers = tuple(
        one.name for one in (*PLANNERS.values(), planner) if one.program and STRIPS in one.program.encodings
    )
    if query.encoding not in (None, STRIPS):
        raise InvalidValue(
            f"The problem {problem.name} is one of relations, which the encoding {query.encoding} cannot "
            f"say; valid: {STRIPS}."
        )
    if planner.name in takers:
        assert planner.program is not None
        solve = partial(_plan_related, program=planner.program)
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


def _plan_related(query: Query, *, program: PddlProgram) -> PlanResult:
    """Solve a problem with a PDDL planner, and believe the plan only if its replay is right."""
    problem = query.problem
    return _told_at_once(problem, query) or within(
        query.time_limit, partial(_search_related, query, problem, program)
    )


def _breadth_first(query: Query, *, foresees: bool) -> PlanResult:
    problem = query.problem if foresees else msgspec.structs.replace(query.problem, foreseen={})
    searched = partial(_plan_breadth_first, problem, query.grounding, time_limit=query.time_limit)
    return _told_at_once(problem, query) or searched()


def _told_at_once(problem: Problem, query: Query) -> PlanResult | None:
    """Say that there is nothing to do, or that nothing can be done; None if it takes a search to tell."""
    if is_reached(problem, query.grounding):
        return PlanResult(PlanStatus.SOLVED, (), 0.0, "the goal is met at the start")
    if reason := why_no_relation(problem, query.grounding):
        return PlanResult(PlanStatus.UNSOLVABLE, (), 0.0, reason)
    return None


def _search_related(query: Query, problem: Problem, program: PddlProgram, deadline: float) -> PlanResult:
    """Print domain and problem, call the planner, read what it wrote, and replay it."""
    grounding = query.grounding
    check_time(deadline)
    costs = program.costs
    texts = domain_text(grounding, costs=costs), problem_text(problem, grounding, costs=costs)
    answer = ask(program, texts, FILES, deadline)
    work = UNTOLD if answer.work is None else answer.work
    if answer.status is PlanStatus.UNSOLVABLE:
        reason = f"no plan with the places that were drawn{_why_none(problem, query)}"
        return PlanResult(PlanStatus.NOT_FOUND, (), answer.seconds, reason, work=work)
    found = answered(answer, lambda text: parse_plan(text, Path("its plan"), grounding, problem))
    if found.status is PlanStatus.SOLVED:
        checked = validate(found.steps, problem, grounding)
        if not checked.valid:
            said = f"the plan with relations is not true when replayed: {checked.reason}"
            found = PlanResult(PlanStatus.FAILED, (), answer.seconds, said)
    return dataclasses.replace(found, work=work)


def _why_none(problem: Problem, query: Query) -> str:
    """Name the objects with a goal on the table that nothing carries there."""
    task = understand(problem, query.grounding)
    fixed = [name for name in problem.unmet if name not in task.carriers]
    if not fixed:
        return ""
    verb = "has a goal" if len(fixed) == 1 else "have goals"
    return f"; {' and '.join(fixed)} {verb} on the table, and nothing carries it to places"


def _plan_breadth_first(
    problem: Problem, grounding: Grounding, *, time_limit: float = math.inf, most_steps: int = MOST_STEPS
) -> PlanResult:
    """Find a plan with the fewest steps, the first in breadth-first order.

    This is the paper's planner (section III-D) for objects that bear one another. A step puts an object on or
    into another one, or carries it to a place. What it leads to is what its operator promises; with which
    pairs that is likely, a problem says as a network foresees it. Ends that were met before are not looked at
    again. Where many objects stand around, sequences of three are too many, so it stops once so many steps
    were looked at, possible or not.
    """
    task = understand(problem, grounding)
    first, steps = start(task), _every_step(task)

    def search(deadline: float) -> PlanResult:
        level: list[tuple[tuple[PlanStep, ...], State]] = [((), first)]  # steps, and what they lead to
        met, looked, depth = {_key(first)}, 0, 0
        while level:
            found, depth = list[tuple[tuple[PlanStep, ...], State]](), depth + 1
            for before, now in level:
                check_time(deadline)
                for step in steps:
                    looked += 1
                    if refusal(task, now, step):
                        continue
                    then = apply(task, now, step)
                    if _key(then) in met:
                        continue
                    met.add(_key(then))
                    found.append(((*before, step), then))
                    if missed(task, then) is None:
                        return PlanResult(PlanStatus.SOLVED, found[-1][0], 0.0)
                if looked > most_steps:
                    reason = f"{counted(most_steps, 'step')} were looked at, {depth - 1} deep"
                    return PlanResult(PlanStatus.NOT_FOUND, (), 0.0, reason, depth - 1)
            level = found
        reason = "no sequence of steps leads there with the places that were drawn"
        return PlanResult(PlanStatus.NOT_FOUND, (), 0.0, reason, depth)

    return within(time_limit, search)


def _every_step(task: Task) -> tuple[PlanStep, ...]:
    """List all steps there are: onto other objects first, in the order of the objects."""
    puts = [PlanStep(put.name, *pair) for pair, found in task.puts.items() for put in found]
    carried = [
        PlanStep(task.carriers[name][0].name, name, place)
        for name in task.names
        if name in task.carriers
        for place in task.places
    ]
    return (*puts, *carried)


def _key(now: State) -> Hashable:
    """Say what tells two ends apart: what bears what, and what stands at which place."""
    borne = ((name, one.by, one.state.symbol) for name, one in now.supports.items())
    return frozenset(borne), frozenset(now.stands.items())
