"""The stages that run plans in the world, and that run their records again."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, Protocol

import msgspec

from neurosym.checks import check_count, check_seed
from neurosym.errors import InvalidFile, InvalidPlanner, InvalidValue, blaming
from neurosym.execution.executor import execute
from neurosym.execution.performance import Agreement, Watcher, compare_runs, rerun
from neurosym.execution.record import Run, StepRecord, this_machine
from neurosym.execution.replanning import WORK_A_PLAN
from neurosym.files import digest, make_folder, read_json, write_json
from neurosym.grounding import Grounding
from neurosym.pddl.plan_reading import read_plan
from neurosym.planners.planner import Planner, PlanResult, PlanStatus, Tell
from neurosym.planners.registry import Replanner, plan, planner_named
from neurosym.problems import Problem, Trial
from neurosym.stages.console import say, shown_doing
from neurosym.stages.folder import DomainFolder, Stage
from neurosym.stages.layout import GROUNDING, RUNS, WORLD, run_file, run_name, scene_file
from neurosym.stages.painting import painted_world
from neurosym.stages.past_files import remember
from neurosym.stages.plan_records import record_beside
from neurosym.stages.planning import load_problem, remarks_on_objects
from neurosym.tasks.transition import hand_problem
from neurosym.world import World


class Audience(Watcher, Protocol):
    """Watches a run from the making of its world to its record; who only watches changes no byte of it."""

    def begin(self, world: World, problem: Problem) -> None:
        """See the world and the problem before anything moves; a `Posed` world can be asked for its poses."""
        ...

    def end_step(self, record: StepRecord) -> None:
        """See what a step did."""
        ...


@dataclass(frozen=True, slots=True)
class Showing:
    """How a run is shown: as animated picture, as picture of each step, in a window, or to an audience."""

    gif: Path | None = None
    strip: Path | None = None
    gui: bool = False
    audience: Audience | None = None


def execute_stage(
    folder: DomainFolder,
    name: str,
    plan_file: Path,
    *,
    replanner: str = "fast-downward",
    replans: int | None = None,
    time_limit: float | None = None,
    nudge_seed: int | None = None,
    tolerance: float | None = None,
    showing: Showing = Showing(),
) -> Stage:
    """Execute a plan: problem, grounding, world and a plan -> `runs/PROBLEM.PLAN.run.json`, and pictures.

    Args:
        folder: The domain folder.
        name: Name of the problem.
        plan_file: The plan.
        replanner: Whom to ask for new plans.
        replans: How many new plans may be asked for. If not given, none for a plan that neurosym did not
            write, which is followed as it is; else the more, the longer the plan is.
        time_limit: The user's ceiling for each new plan [s]; the planner's own if not given.
        nudge_seed: Nudge an object once during the run, drawn from this seed, if given.
        tolerance: How near objects must come to their goals [m], if not as the problem says.
        showing: How the run is shown.

    Raises:
        UnknownChoice: If there is no such planner to replan with.
        InvalidValue: If a number is impossible.
    """
    asked_again = planner_named(replanner, folder.path)
    check_count("replans", replans or 0, least=0)
    check_seed(nudge_seed or 0, "disturb")
    record_file = run_file(name, plan_file)
    if replans is None and not record_beside(plan_file):
        replans = 0

    def work() -> None:
        grounding, world = Grounding.load(folder.require(GROUNDING)), painted_world(folder.require(WORLD))
        own = load_problem(folder, name, world)
        problem = own.within(tolerance)
        if not folder.is_as_made(scene_file(name)):
            for remark in remarks_on_objects(folder, own, grounding):
                folder.notify(remark)
        steps = read_plan(plan_file, grounding, own)
        if impossible := hand_problem(steps, own, grounding):
            raise InvalidFile(plan_file, impossible)
        seen = dict[str, list[Trial]]()
        with shown_doing() as tell:
            solve = None if replans == 0 else replanning(asked_again, time_limit, tell)
            how: dict[str, Any] = {"replanner": solve, "replans": replans, "nudge_seed": nudge_seed}
            how["on_trial"] = lambda name, trial: seen.setdefault(name, []).append(trial)
            perform = partial(execute, world, problem, grounding, steps, tell=tell, **how)
            run = _shown(showing, world, problem, perform)
        other = None if problem.tolerance == own.tolerance else problem.tolerance
        by = asked_again.name if run.own_steps < len(run.steps) else msgspec.UNSET
        make_folder(folder / RUNS)
        told = msgspec.structs.replace(run, tolerance=other, machine=this_machine(), replanner=by)
        write_json(folder / record_file, told)
        remember(folder, own, run_name(name, plan_file), seen)

    # what is not asked for is left out, so that records of earlier versions stay up to date
    options: dict[str, Any] = {"plan": digest(plan_file), "replans": replans}
    options |= {"replanner": replanner, "time_limit": time_limit} if replans != 0 else {}
    options |= {"disturb": nudge_seed} if nudge_seed is not None else {}
    options |= {"tolerance": tolerance} if tolerance is not None else {}
    inputs = (scene_file(name), GROUNDING, WORLD)
    return Stage(f"execute {run_name(name, plan_file)}", inputs, (record_file,), work, options)


def replanning(planner: Planner, time_limit: float | None = None, tell: Tell | None = None) -> Replanner:
    """Return a planner such that a run can ask it for a new plan.

    Args:
        planner: The planner; what it reads is what the operators promise, by what was seen.
        time_limit: The user's ceiling for each new plan [s]; the planner's own if not given.
        tell: Told what the planner tries, if given.
    """

    def told(text: str) -> None:
        if tell:
            tell(f"planning anew: {text}")

    def replan(problem: Problem, grounding: Grounding) -> PlanResult:
        try:
            return plan(problem, grounding, planner, time_limit=time_limit, work=WORK_A_PLAN, tell=told)
        except InvalidPlanner:
            raise
        except InvalidValue as error:  # things ended where no problem can begin, like off the table
            return PlanResult(PlanStatus.FAILED, (), 0.0, str(error))

    return replan


def replay_run(folder: DomainFolder, record: Path, showing: Showing = Showing()) -> tuple[Run, Agreement]:
    """Run the steps of a record again, and compare what happens with it.

    Args:
        folder: The domain folder.
        record: A file that `execute_stage` wrote.
        showing: How the run is shown.

    Returned are what the record says, and how well it agrees with what happened now.

    Raises:
        InvalidFile: If the file is no record of a run, or names what the domain does not have.
    """
    run = read_json(record, Run)
    grounding, world = Grounding.load(folder.require(GROUNDING)), painted_world(folder.require(WORLD))
    problem = load_problem(folder, run.problem, world)
    with blaming(record):
        problem = problem.within(run.tolerance)
        for step in run.steps:
            grounding.operator_named(step.operator)
        for name in (*(step.object for step in run.steps), *(nudge.object for nudge in run.nudges)):
            problem.object_named(name)
    again = _shown(showing, world, problem, partial(rerun, world, problem, grounding, run))
    return run, compare_runs(run, again)


def load_run(folder: DomainFolder, name: str, plan_file: Path) -> Run:
    """Read what became of a plan."""
    return read_json(folder / run_file(name, plan_file), Run)


def _shown(showing: Showing, world: World, problem: Problem, perform: Callable[..., Run]) -> Run:
    """Perform a run while it is shown: pictures are taken if files are asked for, or a window is opened."""
    from neurosym.pictures.film import Film, hold_window, ignore, open_window

    film = Film(world, problem) if showing.gif or showing.strip else None
    if showing.gui:
        open_window(world)
    watchers = [one for one in (film, showing.audience) if one]

    def end_step(record: StepRecord) -> None:
        for one in watchers:
            one.end_step(record)

    if showing.audience:
        showing.audience.begin(world, problem)
    on_frame = film.add_frame if film else ignore if showing.gui else None
    run = perform(on_frame=on_frame, on_step=end_step, watcher=showing.audience)
    if film and not film.save(run, showing.gif, showing.strip):
        say("no pictures: the plan has no step")
    if showing.gui:
        hold_window()
    return run
