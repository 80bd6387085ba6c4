"""The stages of a domain of values: data of which there is no world, compiled, planned with and judged."""

from collections.abc import Iterator
from contextlib import closing, nullcontext, suppress
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from neurosym.data.axes import Axis, legal_name, misfit
from neurosym.data.interactions import Interactions
from neurosym.data.origin import is_explored
from neurosym.errors import InvalidFile, InvalidValue, UnknownChoice, blaming
from neurosym.files import digest, make_folder, read_json, read_text, write_atomically, write_json
from neurosym.operators import OperatorTable, names_of_features
from neurosym.pddl.plan_reading import MOST_PLAN, read_words
from neurosym.pddl.syntax import Atom
from neurosym.planners.planner import PlanStatus
from neurosym.planners.registry import planner_named
from neurosym.problems import check_names
from neurosym.stages import layout
from neurosym.stages.folder import Claim, DomainFolder, Stage
from neurosym.stages.plan_records import put_plan, record_beside
from neurosym.values.domain import ValueDomain, shown_by
from neurosym.values.outcomes import compile_values
from neurosym.values.problem import FORMAT, Goal, Thing, ValueProblem, ValueTask, goal_in_words, known_to
from neurosym.values.traces import GivenSymbols
from neurosym.values.value_execution import execute_values
from neurosym.values.value_page import (
    check_actions,
    known_words,
    read_steps,
    value_page,
    value_problem,
    written,
)
from neurosym.values.value_planning import plan_values
from neurosym.worlds.state_world import HostedStates
from neurosym.worlds.world_file import has_world, read_axes, read_stepper

if TYPE_CHECKING:
    from neurosym.learning.network import EffectModel

USUAL_REPLANS = 10
"""How many new plans are made on the way, unless the user says otherwise."""
_MOST_THINGS = 100  # of a drawn problem
_DRAWS = 50  # of things, until random operators lead them elsewhere


def is_of_values(folder: DomainFolder) -> bool:
    """Say whether a folder holds a user's own data, of which there is no world."""
    data = folder / layout.INTERACTIONS
    if has_world(folder / layout.WORLD) or not data.is_file():
        return False
    return not is_explored(Interactions.load(data).origin)


def compile_values_stage(folder: DomainFolder, *, name: str | None = None) -> Stage:
    """Compile a domain of values: data, symbols and their parameters -> `domain.pddl`, `grounding.json`.

    Args:
        folder: The domain folder.
        name: Name of the domain; that of the folder if not given.
    """
    check_names((name,) if name is not None else ())

    def work() -> None:
        given, data = symbols_of(folder), Interactions.load(folder.require(layout.INTERACTIONS))
        if isinstance(given, GivenSymbols):
            table = given.table()
        else:
            table = OperatorTable.load(folder.require(layout.PRIMITIVES))
        with blaming(folder / (layout.WORLD if (folder / layout.WORLD).is_file() else layout.INTERACTIONS)):
            domain = compile_values(
                data,
                table,
                name=name or legal_name(folder.path.resolve().name),
                object_symbols=given.object_symbols,
                action_symbols=given.action_symbols,
                axes=fitting_axes(folder, data),
            )
        write_atomically(folder / layout.DOMAIN, value_page(domain).text())
        write_json(folder / layout.GROUNDING, domain)
        for scene in sorted((folder / layout.PROBLEMS).glob(f"*{layout.SCENE}")):
            with suppress(InvalidFile, InvalidValue, UnknownChoice):  # a problem of another domain
                _put(folder, read_json(scene, ValueProblem), domain)

    learned = (layout.MODEL, layout.PRIMITIVES) if (folder / layout.MODEL).exists() else ()
    inputs = (layout.WORLD, layout.INTERACTIONS, *learned)
    options = {"name": name} if name else {}
    return Stage("compile-domain", inputs, (layout.DOMAIN, layout.GROUNDING), work, options, Claim.ALONE)


def fitting_axes(folder: DomainFolder, data: Interactions) -> tuple[Axis, ...]:
    """Read the axes of a folder; nothing if it names none.

    Raises:
        InvalidFile: If `world.toml` says of them what the data cannot be.
    """
    file = folder / layout.WORLD
    axes, given = read_axes(file), data.origin.get("feature_names", ())
    names = names_of_features(data.features.shape[1], given)
    known = [one["name"] for one in data.origin.get("axes", ())]
    if axes and known and [axis.name for axis in axes] != known:
        raise InvalidFile(
            file, f"its axes are not those of the data; valid: {', '.join(known)}, in this order"
        )
    for axis, by, effects in zip(axes, shown_by(axes, names), data.effects.T, strict=False):
        if said := misfit(axis, None if by is None else data.features[:, by], effects):
            raise InvalidFile(file, said)
    return axes


def check_own(folder: DomainFolder) -> None:
    """Refuse axes in `world.toml` that data of a user's own cannot have; other folders have none."""
    if is_of_values(folder):
        fitting_axes(folder, Interactions.load(folder / layout.INTERACTIONS))


def domain_of(folder: DomainFolder) -> ValueDomain:
    """Read the domain of values that was compiled."""
    return ValueDomain.load(folder.require(layout.GROUNDING))


def symbols_of(folder: DomainFolder) -> "EffectModel | GivenSymbols":
    """Return what gives symbols in a folder: the network, or data that are such bits already."""
    if not (folder / layout.MODEL).exists():
        with suppress(InvalidValue):
            return GivenSymbols(Interactions.load(folder.require(layout.INTERACTIONS)))
    return folder.network()


def _put(folder: DomainFolder, problem: ValueProblem, domain: ValueDomain) -> None:
    """Write a problem, as we read it and printed, with the symbols of its things in each state."""
    categorise = symbols_of(folder).object_symbols
    things = tuple(known_to(thing, domain, categorise) for thing in problem.things)
    problem = ValueProblem(FORMAT, problem.name, things, problem.goals, problem.provenance)
    task = ValueTask(problem, domain)
    make_folder(folder / layout.PROBLEMS)
    write_atomically(folder / layout.problem_file(problem.name, layout.PDDL), value_problem(task).text())
    problem.save(folder / layout.scene_file(problem.name))


def value_problem_stage(
    folder: DomainFolder,
    name: str,
    *,
    things: int = 1,
    actions: int = 1,
    seed: int = 0,
    goals: dict[str, dict[str, Goal]] | None = None,
    scene: Path | None = None,
) -> Stage:
    """Make a problem of values: domain, data and network -> `problems/NAME.pddl` and `.scene.json`.

    Args:
        folder: The domain folder.
        name: Name of the problem.
        things: How many things there are, drawn from the rows of the data.
        actions: To what so many random operators lead is the goal, if none is given.
        seed: Same seed, same problem.
        goals: What axes of things shall become.
        scene: A file that holds a whole problem, if given.
    """
    if not 1 <= things <= _MOST_THINGS:
        raise InvalidValue(f"There cannot be {things} things in a problem; valid: 1 to {_MOST_THINGS}.")

    def work() -> None:
        domain = domain_of(folder)
        if scene is not None:
            given = read_json(scene, ValueProblem)
            problem = ValueProblem(FORMAT, name, given.things, given.goals, given.provenance)
        else:
            problem = drawn_problem(folder, domain, name, things, actions, seed, goals)
        with blaming(scene) if scene else nullcontext():
            _put(folder, problem, domain)

    inputs = (layout.GROUNDING, *folder.there(layout.MODEL), layout.INTERACTIONS)
    options: dict[str, Any] = {"things": things, "actions": actions, "seed": seed, "goals": goals}
    outputs = (layout.problem_file(name, layout.PDDL), layout.scene_file(name))
    return Stage(f"new-problem {name}", inputs, outputs, work, options)


def drawn_problem(
    folder: DomainFolder,
    domain: ValueDomain,
    name: str,
    count: int,
    actions: int,
    seed: int,
    goals: dict[str, dict[str, Goal]] | None,
) -> ValueProblem:
    """Draw things from the data; random operators lead to the goal unless it is given."""
    rng = np.random.default_rng(seed)
    data = Interactions.load(folder.require(layout.INTERACTIONS))
    categorise = symbols_of(folder).object_symbols
    names = [f"thing-{number:02d}" for number in range(1, count + 1)]
    told = f"new-problem with seed {seed}" + (", goals by hand" if goals else f" and {actions} actions")
    for _ in range(_DRAWS):
        rows = rng.choice(len(data), size=count, replace=count > len(data))
        things = tuple(
            known_to(Thing(one, tuple(map(float, data.features[row]))), domain, categorise)
            for one, row in zip(names, rows.tolist(), strict=True)
        )
        asked = goals or _wandered(things, domain, actions, rng)
        if asked:
            return ValueProblem(FORMAT, name, things, asked, told)
    raise InvalidValue(
        "Nothing can be done with things of these data, as far as they were drawn; give --goal."
    )


def _wandered(
    things: tuple[Thing, ...], domain: ValueDomain, actions: int, rng: np.random.Generator
) -> dict[str, dict[str, Goal]]:
    """Return where random operators lead things, as goals; nothing if they lead to where these are."""
    anything: dict[str, Goal] = {domain.axes[0].name: domain.cells[0].centre(0)}
    task = ValueTask(ValueProblem(FORMAT, "wandered", things, {things[0].name: anything}), domain)
    states = dict(task.start)
    for _ in range(actions):
        thing = things[int(rng.integers(len(things)))].name
        possible = [one for one in domain.operators if not task.refusal(thing, states[thing], one)]
        if possible:
            chosen = possible[int(rng.integers(len(possible)))]
            states[thing] = task.apply(states[thing], chosen) or states[thing]
    return {
        thing: {
            cells.axis.name: round(cells.centre(there), 6)
            for cells, here, there in zip(domain.cells, task.start[thing], state, strict=True)
            if here != there
        }
        for thing, state in states.items()
        if state != task.start[thing]
    }


def task_of(folder: DomainFolder, name: str) -> ValueTask:
    """Read a problem of a folder, and understand it."""
    domain = domain_of(folder)
    return ValueTask.read(folder.require(layout.scene_file(folder.problem(name))), domain)


def goals_in_words(folder: DomainFolder, name: str) -> Iterator[str]:
    """Say the goals of a problem, a line each."""
    for thing, goals in task_of(folder, name).problem.goals.items():
        for axis, value in goals.items():
            yield f"  goal: {axis} of {thing}: {goal_in_words(value)}"


def actions_of(task: ValueTask, plan_file: Path) -> tuple[Atom, ...]:
    """Read the ground actions of any planner's plan.

    Raises:
        InvalidPlan: If a line cannot be read.
        InvalidFile: If an action, an operator or a thing is none of the problem.
    """
    actions = read_words(read_text(plan_file, MOST_PLAN), plan_file, known_words(task))
    with blaming(plan_file):
        check_actions(actions, task)
    return actions


def plan_values_stage(
    folder: DomainFolder, name: str, *, planner: str, time_limit: float | None = None
) -> Stage:
    """Plan with values: problem and domain (and network, for bfs) -> `plans/NAME.PLANNER.plan`, `.json`.

    The time limit is the user's ceiling [s].
    """
    chosen = planner_named(planner, folder.path)
    plan_file, record_file = layout.plan_files(name, chosen.name)
    network = folder.there(layout.MODEL) if chosen.reads == "network" else ()

    def work() -> None:
        task = task_of(folder, name)
        predict = folder.network().predict_symbols if network else None
        result = plan_values(task, chosen, time_limit=time_limit, predict=predict)
        text, found = None, dict[str, Any]()
        if result.status is PlanStatus.SOLVED:
            text = "".join(f"({' '.join(words)})\n" for words in written(result.steps, task))
            found = {"chance": round(task.chance(result.steps), 4), "misses": task.strays(result.steps)}
        put_plan(folder, task.problem.name, chosen.name, result, text, **found)

    options: dict[str, Any] = {"time_limit": time_limit}
    inputs = (layout.scene_file(name), layout.GROUNDING, *network)
    outputs = (plan_file, record_file, layout.steps_file(plan_file))
    return Stage(f"plan {name} {chosen.name}", inputs, outputs, work, options)


def execute_values_stage(
    folder: DomainFolder,
    name: str,
    plan_file: Path,
    *,
    replanner: str,
    replans: int | None = None,
    time_limit: float | None = None,
) -> Stage:
    """Execute a plan in a world of values: problem, domain, world and a plan -> `runs/PROBLEM.PLAN.run.json`.

    Args:
        folder: The domain folder.
        name: Name of the problem.
        plan_file: The plan.
        replanner: Whom to ask for new plans.
        replans: How many may be asked for; if not given `USUAL_REPLANS`, and none for a plan of others.
        time_limit: The user's ceiling for each [s].

    Raises:
        InvalidFile: If `world.toml` names nothing that performs actions.
    """
    world, chosen = read_stepper(folder / layout.WORLD), planner_named(replanner, folder.path)
    if world is None:
        said = 'it names no world that could perform a plan; valid: world = "module:factory" beside its axes'
        raise InvalidFile(folder / layout.WORLD, said)
    usual = USUAL_REPLANS if record_beside(plan_file) else 0
    many, record = usual if replans is None else replans, layout.run_file(name, plan_file)

    def work() -> None:
        task = task_of(folder, name)
        steps = read_steps(actions_of(task, plan_file), task.domain)
        solve = partial(plan_values, planner=chosen, time_limit=time_limit) if many else None
        with closing(HostedStates(*world, folder.path)) as host:
            run = execute_values(task, steps, host.step, solve=solve, replans=many)
        make_folder(folder / layout.RUNS)
        write_json(folder / record, run)

    options: dict[str, Any] = {"replanner": replanner, "replans": replans, "plan": digest(plan_file)}
    inputs = (layout.scene_file(name), layout.GROUNDING, layout.WORLD)
    return Stage(f"execute {layout.run_name(name, plan_file)}", inputs, (record,), work, options)
