"""Planning with values: any program on the page, or the paper's breadth-first search over states."""

import time
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

import msgspec
import numpy as np

from neurosym.checks import Float
from neurosym.errors import InvalidPlan, InvalidValue, UnknownChoice, counted
from neurosym.files import naming
from neurosym.operators import Symbol
from neurosym.pddl.plan_reading import read_words
from neurosym.planners.bfs import DEPTH
from neurosym.planners.external import scratch_folder
from neurosym.planners.planner import Planner, PlanResult, PlanStatus
from neurosym.tasks.transition import PlanStep
from neurosym.values.domain import Outcome, Step, ValueDomain, ValueOperator
from neurosym.values.problem import Cell, ValueTask
from neurosym.values.value_page import known_words, read_steps, value_page, value_problem

MOST_STATES = 200_000
"""So many states are looked at by breadth-first search."""
_ANSWER = Path("its plan")
Predict = Callable[[Sequence[Symbol], Sequence[Symbol]], Float[np.ndarray, "N E"]]
"""Gives the effects that a network predicts of object symbols and action symbols, pair by pair."""


def plan_values(
    task: ValueTask,
    planner: Planner,
    *,
    time_limit: float,
    predict: Predict | None = None,
) -> PlanResult:
    """Plan for a task of values; finding no plan is a result.

    Args:
        task: The task.
        planner: The planner: one that takes the page, or breadth-first search.
        time_limit: The user's ceiling [s].
        predict: What a network predicts, for breadth-first search over that.

    Raises:
        InvalidValue: If the planner takes no page.
    """
    begin = time.perf_counter()
    if not task.replay(())[1]:
        return PlanResult(PlanStatus.SOLVED, (), 0.0, "the goal is met at the start")
    if planner.program is None:
        if not planner.name.startswith("bfs"):
            raise InvalidValue(f"{planner.name} does not plan with values; valid: bfs, or a planner of PDDL.")
        over = predicted(task.domain, predict) if predict else task.domain
        status, steps, reason = search(ValueTask(task.problem, over), begin + time_limit)
        if status is PlanStatus.SOLVED and (said := task.replay(steps)[1]):
            reason = f"the network predicts a plan of {counted(len(steps), 'step')}; by the data, {said}"
            status, steps = PlanStatus.NOT_FOUND, ()
        return PlanResult(status, steps, time.perf_counter() - begin, reason, DEPTH)
    with scratch_folder() as folder:
        files = folder / "domain.pddl", folder / "problem.pddl"
        costs = planner.program.costs
        texts = value_page(task.domain).text(costs=costs), value_problem(task).text(costs=costs)
        for file, text in zip(files, texts, strict=True):
            with naming(file):
                file.write_text(text)
        answer = planner.program.call(*files, time_limit=time_limit)
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


def search(task: ValueTask, deadline: float) -> tuple[PlanStatus, tuple[PlanStep, ...], str]:
    """Search breadth first, `DEPTH` operators deep, as the paper does; see `PlanResult`."""
    frontier: list[tuple[Mapping[str, Cell], tuple[PlanStep, ...]]] = [(task.start, ())]
    seen = {tuple(task.start.values())}
    for _ in range(DEPTH):
        onward = list[tuple[Mapping[str, Cell], tuple[PlanStep, ...]]]()
        for states, steps in frontier:
            if time.perf_counter() > deadline:
                return PlanStatus.TIMEOUT, (), "the time limit cut in"
            for thing, here in states.items():
                for operator in task.domain.operators:
                    if task.refusal(thing, here, operator):
                        continue
                    then = {**states, thing: task.apply(here, operator) or ()}
                    plan = (*steps, PlanStep(operator.name, thing))
                    if not next(task.missed(then), ""):
                        return PlanStatus.SOLVED, plan, ""
                    if (key := tuple(then.values())) not in seen and len(seen) < MOST_STATES:
                        seen.add(key)
                        onward.append((then, plan))
        frontier = onward
    reason = f"breadth-first search found no plan of {DEPTH} operators or fewer"
    return PlanStatus.NOT_FOUND, (), reason


def predicted(domain: ValueDomain, predict: Predict) -> ValueDomain:
    """Return a domain in which each operator does what a network predicts through the symbols."""
    effects = predict([one.category for one in domain.operators], [one.primitive for one in domain.operators])

    def told(operator: ValueOperator, effect: np.ndarray) -> ValueOperator:
        steps = tuple(
            Step(cells.shift(float(value))) if by is not None or not cells.axis.is_set
            else Step(to=cells.clipped(float(value)))
            for cells, by, value in zip(domain.cells, domain.shown, effect, strict=True)
        )  # fmt: skip
        outcome: Outcome = msgspec.structs.replace(operator.outcome, steps=steps)
        return msgspec.structs.replace(operator, outcome=outcome)

    found = tuple(told(*pair) for pair in zip(domain.operators, effects, strict=True))
    return msgspec.structs.replace(domain, operators=found)
