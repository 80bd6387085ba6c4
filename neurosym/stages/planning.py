"""The stage that plans: problem and grounding -> a plan, and how planning went."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import msgspec
import numpy as np

from neurosym.choices import is_factory
from neurosym.contract import limits_of
from neurosym.errors import InvalidPlanner, InvalidValue, StageMissing, blaming, quoted
from neurosym.grounding import Grounding
from neurosym.operators import symbols_of
from neurosym.pddl.problem_check import check_problem
from neurosym.pddl.syntax import ENCODINGS, SAS, STRIPS, EncodingName
from neurosym.planners.no_plan import look_again
from neurosym.planners.planner import PredictEffects
from neurosym.planners.registry import check_options, plan, planner_named
from neurosym.problems import Problem, check_on_table
from neurosym.stages.compilation import print_beside, print_problem
from neurosym.stages.folder import DomainFolder, Stage, load_scene
from neurosym.stages.layout import (
    GROUNDING,
    MODEL,
    PASTS,
    WORLD,
    plan_files,
    printed_file,
    scene_file,
    steps_file,
)
from neurosym.stages.past_files import with_past
from neurosym.stages.plan_records import write_plan
from neurosym.tasks.goal_choice import with_goals
from neurosym.tasks.pasts import forgetting
from neurosym.tasks.promises import is_rehearsed
from neurosym.tasks.task import is_relational, understand
from neurosym.world import World
from neurosym.worlds.world_file import read_limits


def tell_remarks(
    folder: DomainFolder, problem: Problem, grounding: Grounding, *, is_new: bool = True
) -> None:
    """Tell a user all that is to be said of a problem, and of its objects if it is new from somebody else."""
    for remark in (
        *(remarks_on_objects(folder, problem, grounding) if is_new else ()),
        *remarks_on_places(problem, grounding),
        *remarks_on_number(folder, problem),
    ):
        folder.notify(remark)


def remarks_on_places(problem: Problem, grounding: Grounding) -> Iterator[str]:
    """Name the objects that could be carried to their goals, if only there were a place."""
    if not problem.places:
        return
    here = understand(problem, grounding).carried
    anywhere = understand(msgspec.structs.replace(problem, places={}), grounding).carried
    lacking = [name for name in anywhere if name in problem.goals and name not in here]
    if lacking:
        yield (
            f'none of the "places" lies at the goal of {" and ".join(lacking)}, so nothing is carried there; '
            'name one there, or leave "places" out, and places are drawn'
        )


def remarks_on_number(folder: DomainFolder, problem: Problem) -> Iterator[str]:
    """Say if there are more objects than the world of a folder simulates; plans can be found all the same."""
    limits = folder.found(WORLD, read_limits)
    if limits and (reason := limits.too_many(len(problem.objects))):
        yield f"{reason}, so plans for this problem cannot be executed"


def remarks_on_objects(folder: DomainFolder, problem: Problem, grounding: Grounding) -> Iterator[str]:
    """Name the objects that are unlike all of their category, or seem to be of another one.

    Of other categories nothing is said if the folder has no network.
    """
    if not grounding.objects.operators:
        return
    for item in problem.objects:
        if not is_rehearsed(grounding.category(item.category), item.features):
            yield f"{item.name} is unlike all that were rehearsed: it is promised what its category is"
    if not (folder / MODEL).is_file():
        return
    seen = symbols_of(folder.network().object_symbols, np.array([item.features for item in problem.objects]))
    for item, symbol in zip(problem.objects, seen, strict=True):
        if item.category != symbol:
            yield f"{item.name} is said to be of category {item.category}; by its features it is of {symbol}"


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
    problem = with_past(folder, load_scene(scene))
    check_scene(folder, problem, scene, world)
    if problem.conditions and not (problem.goals or problem.relations):  # somebody put it there
        return with_goals(problem, Grounding.load(folder.require(GROUNDING)))
    return problem


def check_scene(folder: DomainFolder, problem: Problem, path: Path, world: World | None = None) -> None:
    """Raise `InvalidFile` unless a problem that was read from a path can be one of a folder.

    That is judged by the folder's world, if it is at hand, or else by what `world.toml` says of it; see
    `check_problem`.
    """
    grounding = folder.found(GROUNDING, Grounding.load)
    limits = limits_of(world) if world else folder.found(WORLD, read_limits)
    with blaming(path):
        check_problem(problem, grounding, limits)


def plan_stage(
    folder: DomainFolder,
    name: str,
    *,
    planner: str,
    time_limit: float | None = None,
    encoding: EncodingName | None = None,
    whole: bool = False,
    nearest: bool = False,
    tolerance: float | None = None,
) -> Stage:
    """Plan: problem and grounding (and model, for BFS) -> `plans/NAME.PLANNER.plan` and `.json`.

    Steps that are no plan of the printed domain stand in `plans/NAME.PLANNER.steps` instead. If a plan needs
    more of the printed problem than that says, it is printed anew.

    Args:
        folder: The domain folder.
        name: Name of the problem.
        planner: Name of the planner.
        time_limit: The user's ceiling [s]; the planner's own if not given.
        encoding: For PDDL planners, the encoding of the domain, if not the usual one.
        whole: For PDDL planners, plan for all objects at once.
        nearest: Whether to plan to the nearest points that can be reached, if there is no plan to the goals.
        tolerance: How near objects must come to their goals [m], if not as the problem says.

    Raises:
        UnknownChoice: If there is no such planner.
        InvalidPlanner: If it cannot be used, or has the name of another one, by which there is a plan.
        InvalidValue: If the planner does not take the encoding or an option.
    """
    chosen = planner_named(planner, folder.path)
    check_options(chosen, encoding=encoding, whole=whole, costs=True)
    plan_file, record_file = plan_files(name, chosen.name)
    stage, made_by = f"plan {name} {chosen.name}", planner if is_factory(planner) else ""
    if made_by and (folder / plan_file).exists():
        _refuse_namesake(folder, stage, made_by, plan_file)
    printed_again = tuple(printed_file(name, each) for each in ENCODINGS)
    scene = folder / scene_file(name)
    met = [f"{PASTS}/{one}.json" for one in load_scene(scene).object_names] if scene.is_file() else []
    pasts = [file for file in met if (folder / file).is_file()]
    read = (MODEL,) if chosen.reads == "network" else ()
    inputs = (scene_file(name), GROUNDING, *read, *pasts)

    def work() -> None:
        grounding = Grounding.load(folder.require(GROUNDING))
        own = load_problem(folder, name)
        if not any((folder / file).is_file() for file in printed_again):  # somebody put the scene there
            print_problem(folder, own, grounding)
        problem = own.within(tolerance)
        for item in problem.objects:
            check_on_table(item, grounding.table)
        tell_remarks(folder, problem, grounding, is_new=not folder.is_as_made(scene_file(name)))
        if nearest and is_relational(problem, grounding):
            raise InvalidValue(
                f"The problem {problem.name} is one of relations, for which there are no nearest points; "
                "leave this option out."
            )
        asked: dict[str, Any] = {"time_limit": time_limit, "encoding": encoding, "whole": whole}
        asked |= {"predict": _prediction(folder, grounding) if chosen.reads == "network" else None}
        result = plan(problem, grounding, chosen, **asked)
        if not result.has_plan and (hoping := forgetting(problem)) != problem:
            folder.notify("no plan goes by what the objects did before; planned as if they may do otherwise")
            problem, result = hoping, plan(hoping, grounding, chosen, **asked)
        result = look_again(result, problem, grounding, chosen, time_limit=time_limit, goes_near=nearest)
        printed = chosen.program.encoding_for(chosen.name, encoding) if chosen.program else STRIPS
        printed = STRIPS if printed == SAS or understand(own, grounding).relates else printed
        found = write_plan(folder, chosen.name, own, problem, grounding, result, printed)
        print_beside(folder, own, grounding, printed, found, chosen.name)

    # what is not asked for is left out, so that records of earlier versions stay up to date
    asked = {"whole": whole, "nearest": nearest, "tolerance": tolerance, "factory": made_by}
    options = {
        "time_limit": time_limit,
        "encoding": encoding,
        **{name: value for name, value in asked.items() if value},
    }
    outputs = (plan_file, record_file, steps_file(plan_file))
    return Stage(stage, inputs, outputs, work, options, renews=printed_again)


def _refuse_namesake(folder: DomainFolder, stage: str, made_by: str, plan_file: str) -> None:
    """Raise `InvalidPlanner` if a plan is there by another planner of one's own that has the same name."""
    record = folder.manifest().stages.get(stage)
    other = record.options.get("factory", made_by) if record else made_by
    if other != made_by:
        raise InvalidPlanner(
            made_by,
            f"has the same name as {other}, by which {plan_file} is; "
            "give one of them another name, or remove that file",
        )


def _prediction(folder: DomainFolder, grounding: Grounding) -> PredictEffects:
    """Return what the network of a folder predicts each primitive to do."""
    symbols, model = grounding.objects.symbols, folder.network()
    return lambda features: model.branching_table(features, symbols)
