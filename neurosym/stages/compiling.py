"""The stages that print PDDL: compiling a domain, and making problems for it."""

from collections.abc import Mapping
from typing import Any

import msgspec
import numpy as np

from neurosym.errors import InvalidValue
from neurosym.files import make_folder, remove, write_atomically
from neurosym.grounding import Grounding
from neurosym.pair_sight import with_pairs
from neurosym.pddl import compile_domain, domain_text, problem_text
from neurosym.pddl.compiler import check_axes
from neurosym.pddl.moves import BY_RELATIONS, LIFTED, PLACES, RELATIONAL, Encoding
from neurosym.pddl.place_domain import carriers_of
from neurosym.pddl.places import with_places
from neurosym.pddl.problem import check_object
from neurosym.pddl.relational import puts_of
from neurosym.pddl.relational_check import check_relations, relations_meant
from neurosym.pddl.relational_task import Task
from neurosym.place_operators import PlaceOperators
from neurosym.problems import Problem
from neurosym.related import is_relational
from neurosym.relation_goals import RelationGoal
from neurosym.relation_operators import RelationOperators
from neurosym.stages.folder import DomainFolder, load_scene
from neurosym.stages.layout import (
    DOMAIN,
    GROUNDING,
    LIFTED_DOMAIN,
    MODEL,
    NUMERIC_DOMAIN,
    OPERATORS_DOMAIN,
    PLACE_OPERATORS,
    PLACES_DOMAIN,
    PROBLEMS,
    RELATION_OPERATORS,
    RELATIONAL_DOMAIN,
    SCENE,
    TABLE_FILES,
    WORLD,
    places_file,
    problem_files,
    relation_files,
    scene_file,
)
from neurosym.stages.manifest import Claim, Stage
from neurosym.stages.other_tools import (
    write_durative_domain,
    write_durative_problem,
    write_new_problem,
    write_pictures,
)
from neurosym.stages.practising import operator_table
from neurosym.stages.task_drawing import AnyTask, draw_any_task, networks_of_pairs, sight_of_pairs
from neurosym.wording import quoted
from neurosym.worlds.relation_tasks import HEIGHT, RELATION_TASKS
from neurosym.worlds.world_file import read_world


def compile_stage(
    folder: DomainFolder,
    *,
    cell: float,
    with_places: bool | None = None,
    with_relations: bool | None = None,
    durative: bool = False,
) -> Stage:
    """Compile the domain: `primitives.json` -> a domain in each encoding, and `grounding.json`.

    After practice, the operators are those in `practice.json`. What carries objects to places stands in
    `places/operators.json`, if it was learned, or will be by then; what puts them on and into one another in
    `relations/operators.json`.
    Problems that are there already are printed again, so that they fit the new domain.
    If asked, what carries objects to places is printed with durations, too.
    """

    def work() -> None:
        table = operator_table(folder)
        check_axes(table)
        if not (folder / WORLD).exists():
            raise InvalidValue(
                f"{folder / WORLD} is missing: a domain also needs where objects may stand and how far the "
                f"hand rises; `neurosym init {quoted(folder.path)} --world module:factory` writes it."
            )
        world = read_world(folder / WORLD)()
        grounding = compile_domain(
            table,
            name=world.name,
            cell=cell,
            table_bounds=world.table,
            lift_height=world.lift_height,
            places=PlaceOperators.load(folder / PLACE_OPERATORS) if has_places else None,
            relations=RelationOperators.load(folder / RELATION_OPERATORS) if has_relations else None,
        )
        write_atomically(folder / DOMAIN, domain_text(grounding, "stepwise"))
        write_atomically(folder / OPERATORS_DOMAIN, domain_text(grounding, "operators"))
        write_atomically(folder / NUMERIC_DOMAIN, domain_text(grounding, "numeric"))
        if has_places:
            write_atomically(folder / PLACES_DOMAIN, domain_text(grounding, PLACES))
        if puts_of(grounding):
            write_atomically(folder / RELATIONAL_DOMAIN, domain_text(grounding, RELATIONAL))
            write_atomically(folder / LIFTED_DOMAIN, domain_text(grounding, LIFTED))
        write_durative_domain(folder, grounding, is_wanted=durative)
        grounding.save(folder / GROUNDING)
        problems = []
        for scene in sorted((folder / PROBLEMS).glob(f"*{SCENE}")):
            problem = _placed(load_scene(scene), grounding)
            for file, text in _printed(problem, grounding).items():
                write_atomically(folder / file, text)
            write_durative_problem(folder, problem, grounding, is_wanted=durative)
            problems.append(problem)
        write_pictures(folder, grounding, problems, durative=durative)

    has_places = (folder / PLACE_OPERATORS).exists() if with_places is None else with_places
    has_relations = (folder / RELATION_OPERATORS).exists() if with_relations is None else with_relations
    inputs = (WORLD, *TABLE_FILES, *([PLACE_OPERATORS] if has_places else []))
    inputs += (RELATION_OPERATORS,) if has_relations else ()
    outputs = (DOMAIN, OPERATORS_DOMAIN, NUMERIC_DOMAIN, GROUNDING, *([PLACES_DOMAIN] if has_places else []))
    outputs += (RELATIONAL_DOMAIN, LIFTED_DOMAIN) if has_relations else ()
    return Stage("compile-domain", inputs, outputs, work, {"cell": cell}, Claim.ALONE)


def problem_stage(
    folder: DomainFolder,
    *,
    name: str,
    objects: int,
    seed: int,
    actions: int = 1,
    goals: Mapping[str, tuple[float, ...]] | None = None,
    task: AnyTask | None = None,
    relations: tuple[RelationGoal, ...] = (),
    height: int = HEIGHT,
    state: str = "",
    like: str | None = None,
    tolerance: float | None = None,
) -> Stage:
    """Make a problem: world, model and grounding -> `problems/NAME.pddl`, `.numeric.pddl`, `.scene.json`.

    It is drawn as the paper draws tasks, unless there are goals or relations, or a task is named. Scene and
    goals do not depend on the tolerance [m]. What is asked of relations is printed as NAME.relational.pddl.
    """
    scene = scene_file(name)

    def work() -> None:
        from neurosym.learning.effect_model import EffectModel
        from neurosym.worlds.problem_drawing import draw_problem, set_problem

        world = read_world(folder.require(WORLD))()
        grounding = Grounding.load(folder.require(GROUNDING))
        categorise = EffectModel.load(folder.require(MODEL)).object_symbols
        sight = sight_of_pairs(folder)
        if task is not None:
            other = load_scene(folder / scene_file(folder.problem(like))) if like else None
            shape: dict[str, Any] = {"height": height, "state": state, "like": other}
            problem = draw_any_task(
                world,
                categorise,
                grounding,
                task,
                name=name,
                objects=objects,
                seed=seed,
                sight=sight,
                **shape,
            )
        elif goals is None and not relations:
            problem = draw_problem(world, categorise, name=name, objects=objects, actions=actions, seed=seed)
        else:
            meant = relations_meant(relations, grounding)
            problem = set_problem(
                world, categorise, goals or {}, name=name, objects=objects, seed=seed, relations=meant
            )
        problem = with_pairs(problem.within(tolerance), grounding.relations, sight)
        check_relations(problem, grounding)
        placed = _placed(problem, grounding)
        printed = _printed(placed, grounding)
        make_folder(folder / PROBLEMS)
        for file, text in printed.items():
            write_atomically(folder / file, text)
        _remove_stale(folder, name, printed)
        write_new_problem(folder, placed, grounding)
        problem.save(folder / scene)

    options = {"objects": objects, "actions": actions, "seed": seed, "goals": _plain(goals)}
    options |= {} if tolerance is None else {"tolerance": tolerance}
    options |= {} if task is None else {"task": task}
    options |= {"relations": _plain(relations)} if relations else {}
    options |= {} if height == HEIGHT else {"height": height}
    options |= {"state": state} if state else {}
    options |= {"like": like} if like else {}
    by_places = [places_file(name)] if (folder / PLACES_DOMAIN).exists() else []
    outputs = (
        *(
            relation_files(name)
            if relations or task in RELATION_TASKS
            else (*problem_files(name), *by_places)
        ),
        scene,
    )
    inputs = (WORLD, MODEL, GROUNDING, *networks_of_pairs(folder))
    return Stage(f"new-problem {name}", inputs, outputs, work, options)


def print_problem(
    folder: DomainFolder, problem: Problem, grounding: Grounding, *, only_missing: bool = False
) -> None:
    """Print a problem for other planners, in both ways.

    Args:
        folder: The domain folder.
        problem: The problem.
        grounding: The learned domain.
        only_missing: Leave what is there as it is.
    """
    problem = _placed(with_pairs(problem, grounding.relations), grounding)
    printed = _printed(problem, grounding)
    wanted = {file for file in printed if not (only_missing and (folder / file).exists())}
    for file in sorted(wanted):
        write_atomically(folder / file, printed[file])
    if not only_missing:
        _remove_stale(folder, problem.name, printed)
    if wanted:
        write_new_problem(folder, problem, grounding)


def _placed(problem: Problem, grounding: Grounding) -> Problem:
    """Return a problem with its places, which are drawn once for all that is printed of it."""
    for item in problem.objects:
        check_object(item, grounding)
    if is_relational(problem, grounding):
        return msgspec.structs.replace(problem, places=Task(problem, grounding).flat.places)
    return with_places(problem, grounding)


def _printed(problem: Problem, grounding: Grounding) -> dict[str, str]:
    """Print a problem in each way, by file; one of relations in no other."""
    if is_relational(problem, grounding):
        pairs = zip(relation_files(problem.name), BY_RELATIONS, strict=True)
        return {file: problem_text(problem, grounding, encoding) for file, encoding in pairs}
    encodings: list[Encoding] = ["stepwise", "numeric"]
    files = [*problem_files(problem.name)]
    if carriers_of(grounding):
        encodings.append(PLACES)
        files.append(places_file(problem.name))
    return {
        file: problem_text(problem, grounding, encoding)
        for file, encoding in zip(files, encodings, strict=True)
    }


def _remove_stale(folder: DomainFolder, name: str, printed: Mapping[str, str]) -> None:
    """Remove what a former problem of that name was printed as, and this one is not."""
    for file in (*problem_files(name), places_file(name), *relation_files(name)):
        if file not in printed and (folder / file).exists():
            remove(folder / file)


def _plain(value: Any) -> Any:
    if isinstance(value, Mapping):
        return {key: _plain(entry) for key, entry in value.items()}
    if isinstance(value, tuple | list):
        return [_plain(entry) for entry in value]
    return value.item() if isinstance(value, np.generic) else value
