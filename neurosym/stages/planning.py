"""The stages that use a learned domain: from a problem to a plan, and from a plan to what became of it."""

import dataclasses
from collections.abc import Sequence

import msgspec

from neurosym.errors import InvalidFile, InvalidValue, StageMissing, UnknownChoice
from neurosym.files import write_atomically, write_json
from neurosym.grounding import Grounding
from neurosym.object_limits import limits_of
from neurosym.pddl.grid import check_on_table
from neurosym.pddl.moves import Encoding
from neurosym.pddl.plan_text import PlanStep, Steps, named_steps, print_ground_plan, print_plan
from neurosym.pddl.problem_check import check_problem
from neurosym.pddl.validation import expected_success
from neurosym.planners import (
    PDDL_PLANNERS,
    Branching,
    PlanResult,
    PlanStatus,
    alternatives,
    check_options,
    plan,
    plan_counting,
    plan_nearest,
    predicted_branching,
)
from neurosym.problems import Problem
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import GROUNDING, MODEL, PLANS, WORLD, plan_files, scene_file
from neurosym.stages.manifest import Stage
from neurosym.wording import quoted
from neurosym.world import World
from neurosym.worlds.world_file import read_limits

TIME_TO_COUNT = 5.0
"""How long to look for a plan by the rehearsed effects, where the network knows none [s]."""


class PlannedSteps(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """One more plan for a problem.

    Attributes:
        file: Its file, relative to the folder.
        steps: Operator and object of each step.
        chance: The chance that all steps go as promised.
    """

    file: str
    steps: Steps
    chance: float


class PlanRecord(msgspec.Struct, frozen=True, forbid_unknown_fields=True, omit_defaults=True):
    """How planning went.

    Attributes:
        problem: Name of the problem.
        planner: Name of the planner.
        status: One of `PlanStatus`.
        steps: Operator and object of each step; empty unless solved or nearest.
        seconds: How long it took [s].
        reason: Why there is no plan, or what is to be said about the one found.
        chance: The chance that all steps go as promised; None without a plan.
        alternatives: The next-best plans, if they were asked for.
    """

    problem: str
    planner: str
    status: str
    steps: Steps
    seconds: float
    reason: str
    chance: float | None = None
    alternatives: tuple[PlannedSteps, ...] = ()

    @property
    def solved(self) -> bool:
        """Whether there is a plan."""
        return self.status == PlanStatus.SOLVED.value


def load_problem(folder: DomainFolder, name: str, world: World | None = None) -> Problem:
    """Read a problem of a folder, whose scene can be as far as the folder tells; see `check_problem`.

    Args:
        folder: The domain folder.
        name: Name of the problem, or the path of its file.
        world: The folder's world, if it is at hand; else what `world.toml` says of it.

    Raises:
        UnknownChoice: If there is no such problem.
        StageMissing: If its scene is missing.
        InvalidFile: If its scene is damaged, or one that cannot be.
    """
    scene = folder / scene_file(folder.problem(name))
    if not scene.is_file():
        raise StageMissing(scene, f"neurosym new-problem {quoted(folder.path)} --name {folder.problem(name)}")
    problem = Problem.load(scene)
    grounding = Grounding.load(folder / GROUNDING) if (folder / GROUNDING).is_file() else None
    if world:
        limits = limits_of(world)
    else:
        limits = read_limits(folder / WORLD) if (folder / WORLD).is_file() else None
    try:
        check_problem(problem, grounding, limits)
    except (InvalidValue, UnknownChoice) as error:
        raise InvalidFile(scene, str(error).rstrip(".")) from error
    return problem


def plan_stage(
    folder: DomainFolder,
    name: str,
    *,
    planner: str,
    time_limit: float,
    encoding: Encoding | None = None,
    whole: bool = False,
    unit_costs: bool = False,
    nearest: bool = False,
    more: int = 0,
) -> Stage:
    """Plan: problem and grounding (and model, for BFS) -> `plans/NAME.PLANNER.plan` and `.json`.

    Args:
        folder: The domain folder.
        name: Name of the problem.
        planner: Name of the planner.
        time_limit: When to give up [s].
        encoding: For PDDL planners, the encoding of the domain, if not the usual one.
        whole: For PDDL planners, plan for all objects at once.
        unit_costs: Whether every step costs the same.
        nearest: Whether to plan to the nearest points that can be reached, if there is no plan to the goals.
        more: How many of the next-best plans to write, too: `plans/NAME.PLANNER-alt-1.plan` and so on.

    Raises:
        UnknownChoice: If there is no such planner, or it does not take the encoding.
        InvalidValue: If the planner does not take an option, or fewer than no plans are asked for.
    """
    check_options(planner, encoding=encoding, whole=whole, costs=not unit_costs)
    if more < 0:
        raise InvalidValue(f"alternatives = {more} must be at least 0.")
    printed = "stepwise"
    if planner in PDDL_PLANNERS:
        printed = PDDL_PLANNERS[planner].encoding_for(planner, encoding)
    plan_file, record_file = plan_files(name, planner)
    inputs = (scene_file(name), GROUNDING, *((MODEL,) if planner == "bfs" else ()))

    def solve(problem: Problem, grounding: Grounding) -> PlanResult:
        branching = _branching(folder, problem, grounding) if planner == "bfs" else None
        result = plan(
            problem,
            grounding,
            planner,
            branching=branching,
            time_limit=time_limit,
            encoding=encoding,
            whole=whole,
            costs=not unit_costs,
        )
        if result.status not in (PlanStatus.UNSOLVABLE, PlanStatus.FAILED):
            return result
        if nearest:
            return _nearest(result, problem, grounding, planner, time_limit)
        if planner == "bfs" or (result.status is PlanStatus.FAILED and planner != "counting"):
            return _with_rehearsed(result, problem, grounding, time_limit)
        return result

    def work() -> None:
        grounding = Grounding.load(folder.require(GROUNDING))
        problem = load_problem(folder, name)
        for item in problem.objects:
            check_on_table(item, grounding)
        result = solve(problem, grounding)
        count = more if result.status is PlanStatus.SOLVED else 0
        others = alternatives(problem, grounding, count, besides=result.steps, time_limit=time_limit)
        _write_plans(folder, (name, planner), problem, grounding, result, others, printed)

    asked = {"whole": whole, "unit_costs": unit_costs, "nearest": nearest, "alternatives": more}
    options = {
        "time_limit": time_limit,
        "encoding": encoding,
        **{key: asked[key] for key in asked if asked[key]},
    }
    return Stage(f"plan {name} {planner}", inputs, (plan_file, record_file), work, options)


def _write_plans(
    folder: DomainFolder,
    asked: tuple[str, str],
    problem: Problem,
    grounding: Grounding,
    result: PlanResult,
    others: Sequence[tuple[PlanStep, ...]],
    encoding: Encoding,
) -> None:
    """Write what was found for a problem by a planner: plan, next-best plans and record."""
    name, planner = asked
    plan_file, record_file = plan_files(name, planner)
    (folder / PLANS).mkdir(exist_ok=True)
    stem = plan_file.removesuffix(".plan")
    written = _write_alternatives(folder, stem, others, problem, grounding, encoding)
    record = PlanRecord(
        problem=name,
        planner=planner,
        status=result.status.value,
        steps=named_steps(result.steps),
        seconds=round(result.seconds, 3),
        reason=result.reason,
        chance=_chance(result.steps, grounding) if result.has_plan else None,
        alternatives=written,
    )
    if record.solved:
        write_atomically(folder / plan_file, _plan_text(result.steps, problem, grounding, encoding))
    elif result.has_plan:
        write_atomically(folder / plan_file, print_plan(result.steps, result.reason))
    else:
        (folder / plan_file).unlink(missing_ok=True)
    write_json(folder / record_file, record)


def _write_alternatives(
    folder: DomainFolder,
    stem: str,
    plans: Sequence[tuple[PlanStep, ...]],
    problem: Problem,
    grounding: Grounding,
    encoding: Encoding,
) -> tuple[PlannedSteps, ...]:
    """Write the next-best plans, in place of those of an earlier time."""
    for stale in folder.path.glob(f"{stem}-alt-*.plan"):
        stale.unlink()
    written = []
    for number, steps in enumerate(plans, start=1):
        file = f"{stem}-alt-{number}.plan"
        write_atomically(folder / file, _plan_text(steps, problem, grounding, encoding))
        written.append(PlannedSteps(file, named_steps(steps), _chance(steps, grounding)))
    return tuple(written)


def _nearest(
    none: PlanResult, problem: Problem, grounding: Grounding, planner: str, time_limit: float
) -> PlanResult:
    """Plan as near to the goal as can be, and keep saying why the planner had no plan that comes nearer."""
    found = plan_nearest(problem, grounding, time_limit=time_limit)
    if not found.has_plan:
        reason = f"{none.reason}; {found.reason}"
        return dataclasses.replace(none, seconds=none.seconds + found.seconds, reason=reason)
    if found.status is PlanStatus.NEAREST:
        return dataclasses.replace(found, reason=f"{found.reason}; {none.reason}")
    over = ", over what the network predicts," if planner == "bfs" else ""
    said = f"it meets the goal by the rehearsed effects; {planner}{over} found none"
    return dataclasses.replace(found, reason=said)


def _with_rehearsed(
    none: PlanResult, problem: Problem, grounding: Grounding, time_limit: float
) -> PlanResult:
    """Add to what a planner has no plan for whether exact counting has one."""
    found = plan_counting(problem, grounding, time_limit=min(time_limit, TIME_TO_COUNT))
    if found.status is not PlanStatus.SOLVED:
        return none
    count = sum(not step.puts_down for step in found.steps)
    known = f"by the rehearsed effects there is a plan of {count} primitive{'' if count == 1 else 's'}"
    return dataclasses.replace(none, reason=f"{none.reason}; {known}: try another planner, say counting")


def _chance(steps: Sequence[PlanStep], grounding: Grounding) -> float:
    return round(expected_success(steps, grounding), 4)


def _plan_text(steps: Sequence[PlanStep], problem: Problem, grounding: Grounding, encoding: Encoding) -> str:
    """Print a plan such that validators take it, or in short if a step is not in the PDDL domain."""
    if any(step.base in grounding.left_out for step in steps):
        return print_plan(steps)
    return print_ground_plan(steps, problem, grounding, encoding)


def _branching(
    folder: DomainFolder, problem: Problem, grounding: Grounding
) -> tuple[Branching, tuple[tuple[str, ...], ...]]:
    from neurosym.learning.effect_model import EffectModel

    symbols = [primitive.symbol for primitive in grounding.operators.primitives]
    effects = EffectModel.load(folder.require(MODEL)).branching_table(problem.scene().features, symbols)
    return predicted_branching(problem, grounding, effects)
