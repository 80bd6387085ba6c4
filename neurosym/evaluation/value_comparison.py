"""Comparing planners on data of a user's own: the same tasks to each; plans are replayed and performed."""

from collections.abc import Iterable, Sequence
from functools import partial

import msgspec
import numpy as np

from neurosym.errors import Progress
from neurosym.planners.planner import Planner
from neurosym.planners.registry import planner_named
from neurosym.stages import layout
from neurosym.stages.folder import DomainFolder
from neurosym.stages.value_stages import USUAL_REPLANS, domain_of, drawn_problem, prediction_of
from neurosym.values.problem import ValueTask
from neurosym.values.value_execution import Perform, execute_values
from neurosym.values.value_planning import Predict, plan_values
from neurosym.worlds.state_world import HostedStates
from neurosym.worlds.world_file import read_stepper


class ValueAttempt(msgspec.Struct, frozen=True):
    """One planner on one task; where no world performs a plan, nobody knows whether it reaches the goal."""

    steps: int | None  # of its plan; None if there is none
    seconds: float
    valid: bool = False  # whether the plan leads to the goal by the rows of the data
    blind: bool | None = None  # whether it reached the goal, followed as it is
    replanned: bool | None = None  # whether the goal was reached with new plans


def compare_values(
    folder: DomainFolder,
    planners: Sequence[str],
    seeds: Iterable[int],
    *,
    things: int = 1,
    time_limit: float | None = None,
    progress: Progress | None = None,
) -> dict[str, list[ValueAttempt]]:
    """Give tasks to planners, and return what each made of each, by planner.

    Args:
        folder: The domain folder.
        planners: Names of planners.
        seeds: A task is drawn with each, in which three actions lead to the goal.
        things: How many things there are in each.
        time_limit: The user's ceiling for each plan [s].
        progress: Called after each task.
    """
    domain, world, seeds = domain_of(folder), read_stepper(folder / layout.WORLD), [*seeds]
    chosen = [planner_named(name, folder.path) for name in planners]
    reads = any(one.reads == "network" for one in chosen) and (folder / layout.MODEL).exists()
    predict = prediction_of(folder) if reads else None
    host = HostedStates(*world, folder.path) if world else None
    found: dict[str, list[ValueAttempt]] = {name: [] for name in planners}
    try:
        for done, seed in enumerate(seeds, start=1):
            task = ValueTask(
                drawn_problem(folder, domain, f"drawn-{seed:05d}", things, 3, seed, None), domain
            )
            for name, planner in zip(planners, chosen, strict=True):
                tried = _attempt(task, planner, time_limit, predict, host.step if host else None)
                found[name].append(tried)
            if progress:
                progress(done, len(seeds))
    finally:
        if host:
            host.close()
    return found


def _attempt(
    task: ValueTask,
    planner: Planner,
    time_limit: float | None,
    predict: Predict | None,
    perform: Perform | None,
) -> ValueAttempt:
    limit = planner.ceiling if time_limit is None else time_limit
    reads = predict if planner.reads == "network" else None
    solve = partial(plan_values, planner=planner, time_limit=limit, predict=reads)
    result = solve(task)
    if not result.has_plan:
        return ValueAttempt(None, result.seconds, blind=perform and False, replanned=perform and False)
    told = len(result.steps), result.seconds, not task.strays(result.steps)
    if perform is None:
        return ValueAttempt(*told)
    blind = execute_values(task, result.steps, perform)
    replanned = execute_values(task, result.steps, perform, solve=solve, replans=USUAL_REPLANS)
    return ValueAttempt(*told, blind.reached, replanned.reached)


def rows_of(found: dict[str, list[ValueAttempt]]) -> list[list[str]]:
    """Write what planners made of the same tasks: a row for each measure, and a column for each planner."""

    def shares(field: str) -> list[str]:
        columns = ([getattr(one, field) for one in tried] for tried in found.values())
        return ["-" if None in column else f"{np.mean(column):.0%}" for column in columns]

    planned = [[one.steps for one in tried if one.steps is not None] for tried in found.values()]
    return [
        [
            "plan found",
            *(f"{len(one) / len(tried):.0%}" for one, tried in zip(planned, found.values(), strict=True)),
        ],
        ["valid by the rows of the data", *shares("valid")],
        ["reached, followed blindly", *shares("blind")],
        ["reached with replanning", *shares("replanned")],
        ["primitives, mean", *(f"{np.mean(one):.2f}" if one else "-" for one in planned)],
        [
            "planning, median [s]",
            *(f"{np.median([one.seconds for one in tried]):.3f}" for tried in found.values()),
        ],
    ]
