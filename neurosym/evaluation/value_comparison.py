"""Comparing planners on data of a user's own: plans are replayed, and performed where a world can."""

from collections.abc import Sequence
from functools import partial

from neurosym.evaluation.comparison import Attempt, TaskRecord
from neurosym.execution.performance import Execution
from neurosym.planners.planner import Planner
from neurosym.planners.registry import planner_named
from neurosym.stages import layout
from neurosym.stages.folder import DomainFolder
from neurosym.stages.value_stages import USUAL_REPLANS, domain_of, drawn_problem
from neurosym.tasks.transition import named_steps
from neurosym.values.problem import ValueProblem, ValueTask
from neurosym.values.value_execution import ValueRun, execute_values
from neurosym.values.value_planning import plan_values
from neurosym.worlds.state_world import HostedStates
from neurosym.worlds.world_file import read_stepper

ACTIONS = 3
"""So many actions lead to the goal of a task."""


class ValueBench:
    """A folder with a user's own data, loaded to draw tasks from and to compare planners in; see `Bench`."""

    def __init__(self, folder: DomainFolder):
        world = read_stepper(folder / layout.WORLD)
        self._folder, self._domain = folder, domain_of(folder)
        self._perform = HostedStates(*world, folder.path).step if world else None
        self._predict = folder.network().predict_symbols if (folder / layout.MODEL).exists() else None

    @staticmethod
    def files(folder: DomainFolder) -> tuple[str, ...]:
        """Name the files that a comparison depends on."""
        before = folder.there(layout.WORLD, layout.INTERACTIONS)
        return (*before, layout.GROUNDING, *folder.there(layout.MODEL))

    def draw(self, things: int, seed: int, *_: object) -> ValueProblem:
        """Draw a task."""
        return drawn_problem(self._folder, self._domain, f"drawn-{seed:05d}", things, ACTIONS, seed, None)

    def compare(
        self, problem: ValueProblem, planners: Sequence[str], *, time_limit: float | None
    ) -> TaskRecord[ValueProblem]:
        """Have each planner plan for a task, and judge its plan."""
        task = ValueTask(problem, self._domain)
        if not task.replay(())[1]:
            return TaskRecord(problem, met_at_start=True)
        chosen = {name: planner_named(name, self._folder.path) for name in planners}
        attempts = {name: self._attempt(task, one, time_limit) for name, one in chosen.items()}
        return TaskRecord(problem, met_at_start=False, attempts=attempts)

    def _attempt(self, task: ValueTask, planner: Planner, time_limit: float | None) -> Attempt:
        predict = self._predict if planner.reads == "network" else None
        solve = partial(plan_values, planner=planner, time_limit=time_limit, predict=predict)
        result = solve(task)
        strays = task.strays(result.steps) if result.has_plan else ""
        blind, replanned = None, None
        if result.has_plan and self._perform:
            blind = _in_short(execute_values(task, result.steps, self._perform))
            run = execute_values(task, result.steps, self._perform, solve=solve, replans=USUAL_REPLANS)
            replanned = _in_short(run)
        return Attempt(
            status=result.status,
            reason=result.reason,
            steps=named_steps(result.steps),
            seconds=round(result.seconds, 4),
            primitives=len(result.steps),
            invalid="elsewhere" if strays else "",
            replayed=strays,
            depth=result.depth,
            open_loop=blind,
            replanned=replanned,
        )


def _in_short(run: ValueRun) -> Execution:
    """Keep of a run what is counted."""
    causes = (
        (run.reached, ""),
        ("nothing is known" in run.reason, "a thing left the bounds"),
        ("no plan" in run.reason, "no plan from where things ended"),
        (run.replans >= USUAL_REPLANS, "new plans were used up"),
        (not all(step.as_promised for step in run.steps), "a thing went elsewhere"),
    )
    kind = next((said for is_so, said in causes if is_so), "small errors added up")
    kept = sum(step.as_promised for step in run.steps)
    return Execution(run.reached, run.reason, kind, {}, len(run.steps), kept, run.replans, 0, 0, ())
