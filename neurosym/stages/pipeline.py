"""The whole way in one call, doing nothing twice."""

from typing import Any

from neurosym.data.interactions import Interactions
from neurosym.data.origin import StrategyName
from neurosym.errors import InvalidValue, counted, quoted
from neurosym.execution.record import Run
from neurosym.files import read_json
from neurosym.grounding import Grounding
from neurosym.learning.training import TrainingReport
from neurosym.pddl.compiler import CELL
from neurosym.stages.compilation import compile_stage
from neurosym.stages.console import say, say_next, show_table
from neurosym.stages.execution import execute_stage, load_run
from neurosym.stages.folder import Claim, DomainFolder, Stage
from neurosym.stages.layout import (
    GROUNDING,
    INTERACTIONS,
    PLACE_INTERACTIONS,
    PLACE_OPERATORS,
    TRAINING,
    WORLD,
    plan_files,
)
from neurosym.stages.learning import OBJECTS, TO_OBJECTS, TO_PLACES, distill_stage, explore_stage, train_stage
from neurosym.stages.plan_records import PlanRecord, written_steps
from neurosym.stages.planning import plan_stage
from neurosym.stages.problem_making import Asked, problem_stage
from neurosym.stages.verdicts import Tries, Verdict, judge_domain, judge_training, judge_tries, worst
from neurosym.world import World, references_of
from neurosym.worlds.world_file import read_world

_PLANNER = "fast-downward"
_MOST_PROBLEMS = 30
"""How many problems are drawn at most, if none of those asked for has a plan."""
_PLACES_FOR = 4
"""For so many interactions there is one more that is aimed at a place, if the user does not say how many."""
_LEAST_STEPS = 1024
"""From so few interactions nothing is learned of places, unless the user says so."""


def go_the_whole_way(
    folder: DomainFolder,
    *,
    strategy: StrategyName,
    steps: int,
    seed: int,
    regime: str,
    workers: int,
    rehearsals: int,
    choice: str,
    problems: int,
    object_bits: int | None = None,
    action_bits: int | None = None,
    places: int | None = None,
    relations: int = 0,
) -> None:
    """Explore, train, distil, compile, draw problems, plan with Fast Downward, and execute what was found.

    Args:
        folder: The domain folder, with a `world.toml`.
        strategy: How exploration chooses actions.
        steps: Interactions to make.
        seed: Where all random draws start; problem number i is drawn with seed + i.
        regime: Network and training.
        workers: Processes that simulate.
        rehearsals: Objects that each primitive is rehearsed on.
        choice: Which candidate stands for a symbol.
        problems: How many problems to draw; more, if none of them has a plan.
        object_bits: Bits of an object symbol; the regime's if not given.
        action_bits: Bits of an action symbol; the regime's if not given.
        places: Interactions to make besides that are aimed at places; 0 for none. If not given, one for
            every four others, in a world that takes places.
        relations: Interactions to make besides that are aimed at other objects.
    """
    world = read_world(folder.require(WORLD))()
    if places is None:
        places = _usual_places(folder, world, steps)
    _check_aims(folder, world, places, relations)
    fitting: dict[str, Any] = {"seed": seed, "regime": regime}
    exploring: dict[str, Any] = {"strategy": strategy, "workers": workers, **fitting}
    rehearsing: dict[str, Any] = {"seed": seed, "workers": workers}
    bits: dict[str, Any] = {"object_bits": object_bits, "action_bits": action_bits}
    stages = []
    for aim, count in ((OBJECTS, steps), (TO_PLACES, places), (TO_OBJECTS, relations)):
        if count:
            own: dict[str, Any] = bits if aim is OBJECTS else {}
            stages += [
                explore_stage(folder, aim, steps=count, **exploring, **own),
                train_stage(folder, aim, **fitting, **own),
                distill_stage(folder, aim, objects=rehearsals, choice=choice, **rehearsing),
            ]
    stages.append(
        compile_stage(folder, cell=CELL, with_places=places > 0 or None, with_relations=relations > 0 or None)
    )
    with folder.claimed(Claim.ALONE):
        for stage in stages:
            _perform(folder, stage)
        tried = [_try_problem(folder, number, seed) for number in range(1, problems + 1)]
        while problems and len(tried) < _MOST_PROBLEMS and not any(run for _, run in tried):
            tried.append(_try_problem(folder, len(tried) + 1, seed))
    runs = [run for _, run in tried if run]
    if tried:
        columns = ["problem", "objects", "plan", "primitives", "seconds", "goal", "why not"]
        title = f"{counted(len(tried), 'problem')} drawn from the world"
        show_table(title, columns, [cells for cells, _ in tried])
    say(f"everything lies in {folder.path}; {folder / 'domain.pddl'} is the domain")
    for line in _judged(folder, Tries(sum(run.reached for run in runs), len(runs), len(tried))).lines:
        say(line)
    say_next(f"neurosym plan {quoted(folder.path)} task-01 --planner bfs")


def _judged(folder: DomainFolder, tries: Tries) -> Verdict:
    """Judge the whole way by what came out worst: the bits, the domain, or the problems."""
    report = read_json(folder / TRAINING, TrainingReport)
    learned = judge_training(report, Interactions.load(folder / INTERACTIONS))
    return worst((learned, judge_domain(Grounding.load(folder / GROUNDING)), judge_tries({_PLANNER: tries})))


def _usual_places(folder: DomainFolder, world: World, steps: int) -> int:
    """Say how many interactions are aimed at places if the user does not: no fewer than there are."""
    if "place" not in references_of(world):
        return 0
    path, share = folder / PLACE_INTERACTIONS, steps // _PLACES_FOR if steps >= _LEAST_STEPS else 0
    return max(share, len(Interactions.load(path)) if path.is_file() else 0)


def _check_aims(folder: DomainFolder, world: World, places: int, relations: int) -> None:
    """Refuse interactions that nothing can be learned from, before hours are spent on others."""
    if places:
        TO_PLACES.check_takes(world)
    if relations:
        TO_OBJECTS.check_takes(world)
        if not places and not (folder / PLACE_OPERATORS).is_file():
            raise InvalidValue(
                "Relations are learned with what carries objects to places; give --places a number, "
                "like 2000."
            )


def _try_problem(folder: DomainFolder, number: int, seed: int) -> tuple[tuple[str, ...], Run | None]:
    """Draw a problem, plan it, and execute the plan if there is one; return a row for it, and the run."""
    name, objects = f"task-{number:02d}", 2 - number % 2
    _perform(folder, problem_stage(folder, name, Asked(objects, seed=seed + number)))
    _perform(folder, plan_stage(folder, name, planner=_PLANNER))
    record = read_json(folder / plan_files(name, _PLANNER)[1], PlanRecord)
    cells = (name, str(objects), record.status.value, str(record.primitives), f"{record.seconds:.2f}")
    plan_file = written_steps(folder, name, _PLANNER)
    if not (record.solved and plan_file):
        return (*cells, "-", record.reason), None
    _perform(folder, execute_stage(folder, name, folder / plan_file))
    run = load_run(folder, name, folder / plan_file)
    return (*cells, run.outcome.removeprefix("goal "), run.reason), run


def _perform(folder: DomainFolder, stage: Stage) -> None:
    done = folder.perform(stage, again=False)
    say(f"{stage.name}: {'done' if done else 'up to date'}")
