"""The command `neurosym run`: the whole way in one call, doing nothing twice."""

from typing import Annotated, Any, Optional

from tyro.conf import arg

from neurosym.choices import CELL, DEFAULT_STRATEGY
from neurosym.commands.arguments import CPUS, Folder, Seed, Workers, opened
from neurosym.commands.learn import (
    ActionBits,
    Choice,
    ObjectBits,
    RegimeName,
    Relations,
    Strategy,
    make_domain_folder,
)
from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidValue, counted, quoted
from neurosym.execution.record import Run
from neurosym.files import read_json
from neurosym.grounding import Grounding
from neurosym.learning.training import TrainingReport
from neurosym.learning.training_config import regime_named
from neurosym.stages import layout
from neurosym.stages.compilation import compile_stage
from neurosym.stages.console import say, say_next, show_table
from neurosym.stages.execution import execute_stage, load_run
from neurosym.stages.folder import Claim, DomainFolder, Stage
from neurosym.stages.learning import (
    AIMS,
    OBJECTS,
    TO_OBJECTS,
    TO_PLACES,
    check_steps,
    distill_stage,
    explore_stage,
    train_stage,
)
from neurosym.stages.plan_records import PlanRecord, written_steps
from neurosym.stages.planning import plan_stage
from neurosym.stages.problem_making import Asked, problem_stage
from neurosym.stages.verdicts import Tries, judge_domain, judge_training, judge_tries, worst
from neurosym.world import World, references_of
from neurosym.worlds.world_file import read_world

_PLANNER = "fast-downward"
_MOST_PROBLEMS = 30
"""How many problems are drawn at most, if none of those asked for has a plan."""
_PLACES_FOR = 4
"""For so many interactions there is one more that is aimed at a place, if the user does not say how many."""
_LEAST_STEPS = 1024
"""From so few interactions nothing is learned of places, unless the user says so."""


def run(
    folder: Folder,
    world: Annotated[
        Optional[str],
        arg(help="Which world, for a new folder: tabletop (default), toy, or your own as module:factory."),
    ] = None,
    strategy: Strategy = DEFAULT_STRATEGY,
    steps: Annotated[int, arg(help="Interactions to explore for.")] = 10_000,
    seed: Seed = 0,
    regime: RegimeName = "default",
    workers: Workers = CPUS,
    rehearsals: Annotated[int, arg(help="Objects that each primitive is rehearsed on.")] = 100,
    choice: Choice = "own",
    problems: Annotated[
        int, arg(help="Problems to draw, every second one with two objects; up to 30 if none has a plan.")
    ] = 6,
    object_bits: ObjectBits = None,
    action_bits: ActionBits = None,
    places: Annotated[
        Optional[int],
        arg(
            help="Interactions besides that are aimed at a place, to learn what carries objects there: a "
            "quarter of --steps from 1024 on, if not given."
        ),
    ] = None,
    relations: Relations = 0,
) -> int:
    """Go the whole way: explore, train, distil, compile, draw problems, plan and execute.

    Interrupt it when you like: the same command goes on. Stages that were finished are not done again, and of
    exploring it loses at most a block of 512 interactions.
    """
    bits: dict[str, Any] = {"object_bits": object_bits, "action_bits": action_bits}
    regime_named(regime).model.with_bits(**bits)
    domain = _begun(folder, world, steps)
    counts = _counts(domain, read_world(domain.require(layout.WORLD))(), steps, places, relations)
    fitting: dict[str, Any] = {"seed": seed, "regime": regime}
    stages = []
    for aim, count in zip(AIMS, counts, strict=True):
        if count:
            options = {**fitting, **(bits if aim is OBJECTS else {})}
            stages += [
                explore_stage(domain, aim, strategy=strategy, steps=count, workers=workers, **options),
                train_stage(domain, aim, **options),
                distill_stage(domain, aim, objects=rehearsals, choice=choice, seed=seed, workers=workers),
            ]
    stages.append(
        compile_stage(
            domain, cell=CELL, with_places=counts[1] > 0 or None, with_relations=relations > 0 or None
        )
    )
    with domain.claimed(Claim.ALONE):
        for stage in stages:
            _perform(domain, stage)
        tried = [_try_problem(domain, number, seed) for number in range(1, problems + 1)]
        while problems and len(tried) < _MOST_PROBLEMS and not any(run for _, run in tried):
            tried.append(_try_problem(domain, len(tried) + 1, seed))
    _conclude(domain, tried)
    say_next(f"neurosym plan {quoted(folder)} task-01 --planner bfs")
    return 0


def _begun(folder: Folder, world: str | None, steps: int) -> DomainFolder:
    """Return the domain folder, which is made if it is not there; or refuse it."""
    if folder.is_dir():
        check_steps(opened(folder), steps)
    if not (folder / layout.WORLD).exists():
        make_domain_folder(folder, world or "tabletop")
    elif world and (found := read_world(folder / layout.WORLD).args[0]) != world:
        raise InvalidValue(f"{folder} is of the world {found!r}, not {world!r}; name another folder.")
    return opened(folder)


def _counts(
    folder: DomainFolder, world: World, steps: int, places: int | None, relations: int
) -> tuple[int, int, int]:
    """Say how many interactions each aim gets; those that nothing can be learned from are refused.

    If the user does not say how many are aimed at places, there are no fewer than there were.
    """
    if places is None:
        path, usual = folder / layout.PLACE_INTERACTIONS, steps // _PLACES_FOR
        there = len(Interactions.load(path)) if path.is_file() else 0
        places = max(there, usual if steps >= _LEAST_STEPS else 0)
        places = places if "place" in references_of(world) else 0
    if places:
        TO_PLACES.check_takes(world)
    if relations:
        TO_OBJECTS.check_takes(world)
        if not places and not (folder / layout.PLACE_OPERATORS).is_file():
            raise InvalidValue(
                "Relations are learned with what carries objects to places; give --places a number, "
                "like 2000."
            )
    return steps, places, relations


def _try_problem(folder: DomainFolder, number: int, seed: int) -> tuple[list[str], Run | None]:
    """Draw a problem, plan it, and execute the plan if there is one; return a row for it, and the run."""
    name, objects = f"task-{number:02d}", 2 - number % 2
    _perform(folder, problem_stage(folder, name, Asked(objects, seed=seed + number)))
    _perform(folder, plan_stage(folder, name, planner=_PLANNER))
    record = read_json(folder / layout.plan_files(name, _PLANNER)[1], PlanRecord)
    cells = [name, str(objects), record.status.value, str(record.primitives), f"{record.seconds:.2f}"]
    plan_file = written_steps(folder, name, _PLANNER)
    if not (record.solved and plan_file):
        return [*cells, "-", record.reason], None
    _perform(folder, execute_stage(folder, name, folder / plan_file))
    run = load_run(folder, name, folder / plan_file)
    return [*cells, run.outcome.removeprefix("goal "), run.reason], run


def _conclude(folder: DomainFolder, tried: list[tuple[list[str], Run | None]]) -> None:
    """Say what became of the problems, and judge the whole way by what came out worst."""
    if tried:
        columns = ["problem", "objects", "plan", "primitives", "seconds", "goal", "why not"]
        title = f"{counted(len(tried), 'problem')} drawn from the world"
        show_table(title, columns, [cells for cells, _ in tried])
    say(f"everything lies in {folder.path}; {folder / layout.DOMAIN} is the domain")
    report = read_json(folder / layout.TRAINING, TrainingReport)
    learned = judge_training(report, Interactions.load(folder / layout.INTERACTIONS))
    runs = [run for _, run in tried if run]
    tries = Tries(sum(run.reached for run in runs), len(runs), len(tried))
    compiled = judge_domain(Grounding.load(folder / layout.GROUNDING))
    for line in worst((learned, compiled, judge_tries({_PLANNER: tries}))).lines:
        say(line)


def _perform(folder: DomainFolder, stage: Stage) -> None:
    done = folder.perform(stage, again=False)
    say(f"{stage.name}: {'done' if done else 'up to date'}")
