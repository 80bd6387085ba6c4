"""Planning with values: any program on the page, or the paper's breadth-first search over states."""

import time
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

import msgspec
import numpy as np

from neurosym.checks import Float
from neurosym.data.cells import Step
from neurosym.errors import InvalidPlan, InvalidValue, UnknownChoice, counted
from neurosym.operators import Symbol
from neurosym.pddl.plan_reading import read_words
from neurosym.planners.bfs import DEPTH, MOST_SEQUENCES, breadth_first
from neurosym.planners.external import answer_to
from neurosym.planners.planner import MET_AT_START, Planner, PlanResult, PlanStatus
from neurosym.tasks.transition import PlanStep
from neurosym.values.domain import ValueDomain, ValueOperator
from neurosym.values.problem import Cell, ValueTask
from neurosym.values.value_page import known_words, read_steps, value_page, value_problem

_ANSWER = Path("its plan")
States = tuple[Cell, ...]
"""The cells of each thing."""
Predict = Callable[[Sequence[Symbol], Sequence[Symbol]], Float[np.ndarray, "N E"]]
"""Gives the effects that a network predicts of object symbols and action symbols, pair by pair."""


def plan_values(
    task: ValueTask,
    planner: Planner,
    *,
    time_limit: float | None = None,
    predict: Predict | None = None,
) -> PlanResult:
    """Plan for a task of values; finding no plan is a result.

    Args:
        task: The task.
        planner: The planner: one that takes the page, or breadth-first search.
        time_limit: The user's ceiling [s]; the planner's own if not given.
        predict: What a network predicts, for breadth-first search over that.

    Raises:
        InvalidValue: If the planner takes no page.
    """
    begin, limit = time.perf_counter(), planner.ceiling if time_limit is None else time_limit
    if not task.replay(())[1]:
        return MET_AT_START
    if planner.program is None:
        if not planner.name.startswith("bfs"):
            raise InvalidValue(f"{planner.name} does not plan with values; valid: bfs, or a planner of PDDL.")
        over = predicted(task.domain, predict) if predict else task.domain
        result = search(ValueTask(task.problem, over), time_limit=limit)
        if result.has_plan and (said := task.replay(result.steps)[1]):
            reason = (
                f"the network predicts a plan of {counted(len(result.steps), 'step')}; by the data, {said}"
            )
            return PlanResult(PlanStatus.NOT_FOUND, (), result.seconds, reason, DEPTH)
        return result
    costs = planner.program.costs
    texts = value_page(task.domain).text(costs=costs), value_problem(task).text(costs=costs)
    answer = answer_to(planner.program.call, texts, time_limit=limit)
    seconds = time.perf_counter() - begin
    if answer.status is not PlanStatus.SOLVED:
        return PlanResult(answer.status, (), seconds, answer.reason)
    try:
        steps = read_steps(read_words(answer.text, _ANSWER, known_words(task)), task.domain)
        said = task.replay(steps)[1]
    except (InvalidPlan, InvalidValue, UnknownChoice) as error:
        steps, said = (), str(error)
    if said:
        return PlanResult(PlanStatus.FAILED, (), seconds, f"its plan is not true when replayed: {said}")
    return PlanResult(PlanStatus.SOLVED, steps, seconds)


def search(task: ValueTask, *, time_limit: float) -> PlanResult:
    """Search breadth first, `DEPTH` operators deep, as the paper does."""
    names = tuple(task.start)

    def onward(states: States) -> Iterator[tuple[PlanStep, States | None]]:
        for number, (thing, here) in enumerate(zip(names, states, strict=True)):
            for operator in task.domain.operators:
                then = None if task.refusal(thing, here, operator) else task.apply(here, operator)
                led = None if then is None else (*states[:number], then, *states[number + 1 :])
                yield PlanStep(operator.name, thing), led

    def is_met(states: States) -> bool:
        return not next(task.missed(dict(zip(names, states, strict=True))), "")

    return breadth_first(
        tuple(task.start.values()),
        onward,
        is_met,
        lambda states: states,
        time_limit=time_limit,
        most_steps=MOST_SEQUENCES,
        otherwise=f"breadth-first search found no plan of {DEPTH} operators or fewer",
        depth=DEPTH,
    )


def predicted(domain: ValueDomain, predict: Predict) -> ValueDomain:
    """Return a domain in which each operator does what a network predicts through the symbols."""
    effects = predict([one.category for one in domain.operators], [one.primitive for one in domain.operators])
    found = list[ValueOperator]()
    for operator, effect in zip(domain.operators, effects.tolist(), strict=True):
        steps = tuple(
            Step(cells.shift(value)) if by is not None or not cells.axis.is_set
            else Step(to=cells.clipped(value))
            for cells, by, value in zip(domain.cells, domain.shown, effect, strict=True)
        )  # fmt: skip
        outcome = msgspec.structs.replace(operator.outcome, steps=steps)
        found.append(msgspec.structs.replace(operator, outcome=outcome))
    return msgspec.structs.replace(domain, operators=tuple(found))
