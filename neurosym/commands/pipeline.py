"""The command `neurosym run`: the whole way in one call, doing nothing twice.

One budget of interactions is spent in rounds, each as large as all before it. In a round the robot
explores, the networks learn from all that was performed, and the rest goes to candidates and operators where
it is worth most. So there is a domain to plan with after each round, and a better one after the next.
"""

from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import Annotated, Any, Optional

from tyro.conf import arg

from neurosym.choices import ACTED, BUDGET, DEFAULT_PLANNER, DEFAULT_STRATEGY, ENGINES, is_factory
from neurosym.commands.arguments import CPUS, Engine, Folder, Seed, Workers, opened
from neurosym.commands.learn import (
    ActionBits,
    Choice,
    ObjectBits,
    RegimeName,
    Relations,
    Strategy,
    make_domain_folder,
)
from neurosym.errors import InvalidValue, counted, quoted
from neurosym.execution.record import Run
from neurosym.files import read_json
from neurosym.grounding import Grounding
from neurosym.learning.training_config import PLACE_BITS, regime_named
from neurosym.stages import layout
from neurosym.stages.console import say, say_next, show_table
from neurosym.stages.execution import execute_stage, load_run
from neurosym.stages.folder import DomainFolder
from neurosym.stages.learning import AIMS, TO_OBJECTS, TO_PLACES, ledger_of
from neurosym.stages.plan_records import PlanRecord, written_steps
from neurosym.stages.planning import plan_stage
from neurosym.stages.problem_making import Asked, problem_stage
from neurosym.stages.rounds import (
    Recipe,
    Round,
    Share,
    acted_in,
    budget_of,
    explored_in,
    grow,
    perform,
    rounds,
)
from neurosym.stages.seeing import see_stage
from neurosym.stages.verdicts import Tries, judge_domain, judge_tries, worst
from neurosym.world import World, references_of
from neurosym.worlds.world_file import SEEING, asked_of, read_world, sees

_MOST_PROBLEMS = 30
"""How many problems are drawn at most, if none of those asked for has a plan."""


def run(
    folder: Folder,
    world: Annotated[
        Optional[str],
        arg(
            help="Which world, for a new folder: tabletop (default), camera, toy, or yours as module:factory."
        ),
    ] = None,
    strategy: Strategy = DEFAULT_STRATEGY,
    interactions: Annotated[
        Optional[int],
        arg(
            help="Interactions in all at most, whatever they are for. By default 6000, with places 10000, "
            "and with relations 15000."
        ),
    ] = None,
    steps: Annotated[
        Optional[int],
        arg(help="Explore for so many, then learn and distil once, in place of rounds."),
    ] = None,
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
            help="Interactions that explore what carries objects to places, at most; 0 for none. By default "
            "1024, and none with --steps."
        ),
    ] = None,
    relations: Relations = 0,
    engine: Engine = None,
) -> int:
    """Go the whole way: explore, train, distil, compile, draw problems, plan and execute.

    Interrupt it when you like: the same command goes on. There is a domain to plan with after the first
    round; more --interactions go on from the last. Of exploring it loses at most a block of 512 interactions.
    """
    bits: dict[str, Any] = {"object_bits": object_bits, "action_bits": action_bits}
    chosen = regime_named(regime).model.with_bits(**bits)
    if steps is not None and interactions is not None:
        raise InvalidValue("--steps explores at once, and --interactions is a budget for rounds; give one.")
    if steps is not None and (folder / layout.BUDGET).exists():
        raise InvalidValue(f"{folder} grows in rounds; give --interactions in place of --steps.")
    operators = 2 ** (chosen.object_bits + chosen.action_bits), 2 ** (chosen.object_bits + PLACE_BITS[1])
    if not (folder / layout.WORLD).exists():  # so that it is not made for nothing
        _check_relations(folder, places != 0 if steps is None else bool(places), relations > 0)
        if steps is None:
            _check_enough(interactions, world, places, relations, operators)
    domain = _begun(folder, world, engine)
    if steps is None and interactions is None and not (domain / layout.BUDGET).exists():
        steps = explored_in(domain)[layout.OBJECTS] or None
    known = read_world(domain.require(layout.WORLD))()
    plan = _plan(domain, known, interactions, steps, places, relations, operators)
    if sees(domain / layout.WORLD) and not (domain / layout.EYE).exists():
        perform(domain, see_stage(domain, seed=seed, workers=workers))
    recipe = Recipe(strategy, regime, choice, rehearsals, seed, workers, bits)
    grow(domain, plan, recipe, is_open=interactions is not None or steps is None)
    tried = [_try_problem(domain, number, seed) for number in range(1, problems + 1)]
    while problems and len(tried) < _MOST_PROBLEMS and not any(run for _, run in tried):
        tried.append(_try_problem(domain, len(tried) + 1, seed))
    _conclude(domain, tried)
    say_next(f"neurosym plan {quoted(folder)} task-01 --planner bfs")
    return 0


def _check_enough(
    interactions: int | None, world: str | None, places: int | None, relations: int, operators: Sequence[int]
) -> None:
    """Refuse too few interactions for a new folder, as far as the name of its world tells."""
    takes = places != 0 and not is_factory(world or "")
    names = [layout.OBJECTS, *[layout.PLACES] * takes, *[layout.RELATIONS] * (relations > 0)]
    least = dict(zip((layout.OBJECTS, layout.PLACES), operators, strict=True))
    rounds(interactions, names, least, {}, ACTED if world == SEEING else 0)


def _plan(
    folder: DomainFolder,
    world: World,
    interactions: int | None,
    steps: int | None,
    places: int | None,
    relations: int,
    operators: Sequence[int],
) -> list[Round]:
    """Say how much each aim gets in each round; the number of operators is that of objects, and of places."""
    if steps is not None:
        there = explored_in(folder)
        counts = steps, max(places or 0, there[layout.PLACES]), max(relations, there[layout.RELATIONS])
        _check_aims(folder, world, counts[1] > 0, counts[2] > 0)
        return [{aim.folder: Share(n, BUDGET) for aim, n in zip(AIMS, counts, strict=True) if n}]
    takes, learned = "place" in references_of(world), budget_of(folder).last
    if places == 0 and layout.PLACES in learned:
        raise InvalidValue(
            f"{folder.path} has learned of places, which go with the rest; leave out --places 0."
        )
    asked = True, takes if places is None else places > 0, relations > 0 or layout.RELATIONS in learned
    _check_aims(folder, world, asked[1], asked[2])
    aims = [aim.folder for aim, is_asked in zip(AIMS, asked, strict=True) if is_asked]
    least = dict(zip((layout.OBJECTS, layout.PLACES), operators, strict=True))
    most = {layout.PLACES: places, layout.RELATIONS: relations}
    return rounds(interactions, aims, least, most, _seen_by(folder))


def _seen_by(folder: DomainFolder) -> int:
    """Count what teaches an eye, or did."""
    is_to_see = sees(folder / layout.WORLD) and not folder.there(layout.EYE)
    return ACTED if is_to_see else acted_in(folder)


def _begun(folder: Folder, world: str | None, engine: str | None) -> DomainFolder:
    """Return the domain folder, which is made if it is not there; or refuse it."""
    if not (folder / layout.WORLD).exists():
        make_domain_folder(folder, world or "tabletop", engine)
    name, options = asked_of(read_world(folder / layout.WORLD))
    if world and name != world:
        raise InvalidValue(f"{folder} is of the world {name!r}, not {world!r}; name another folder.")
    if engine and (found := options.get("engine", ENGINES[0])) != engine:
        raise InvalidValue(f"{folder} is simulated by {found}, not {engine}; name another folder.")
    return opened(folder)


def _check_aims(folder: DomainFolder, world: World, places: bool, relations: bool) -> None:
    """Refuse what cannot be learned in a world, or not without something else."""
    if places:
        TO_PLACES.check_takes(world)
    if relations:
        TO_OBJECTS.check_takes(world)
        _check_relations(folder.path, places, relations)


def _check_relations(folder: Path, places: bool, relations: bool) -> None:
    """Refuse to learn relations where nothing is learned of places, nor was."""
    if relations and not places and not (folder / layout.PLACE_OPERATORS).is_file():
        raise InvalidValue(
            "Relations are learned with what carries objects to places; give --places a number, like 2000."
        )


def _try_problem(folder: DomainFolder, number: int, seed: int) -> tuple[list[str], Run | None]:
    """Draw a problem, plan it, and execute the plan if there is one; return a row for it, and the run."""
    name, objects = f"task-{number:02d}", 2 - number % 2
    perform(folder, problem_stage(folder, name, Asked(objects, seed=seed + number)))
    perform(folder, plan_stage(folder, name, planner=DEFAULT_PLANNER))
    record = read_json(folder / layout.plan_files(name, DEFAULT_PLANNER)[1], PlanRecord)
    cells = [name, str(objects), record.status.value, str(record.primitives), f"{record.seconds:.2f}"]
    plan_file = written_steps(folder, name, DEFAULT_PLANNER)
    if not (record.solved and plan_file):
        return [*cells, "-", record.reason], None
    perform(folder, execute_stage(folder, name, folder / plan_file))
    run = load_run(folder, name, folder / plan_file)
    return [*cells, run.outcome.removeprefix("goal "), run.reason], run


def _conclude(folder: DomainFolder, tried: list[tuple[list[str], Run | None]]) -> None:
    """Say what became of the problems, and judge domain and tasks by what came out worse."""
    if tried:
        columns = ["problem", "objects", "plan", "primitives", "seconds", "goal", "why not"]
        title = f"{counted(len(tried), 'problem')} drawn from the world"
        show_table(title, columns, [cells for cells, _ in tried])
    purposes = Counter(explored=explored_in(folder).total())
    for aim in AIMS:
        purposes += ledger_of(folder, aim).purposes
    purposes += Counter(seen=acted_in(folder))
    if purposes.total() >= (total := budget_of(folder).total):  # all is kept that was performed
        told = ", ".join(f"{count} {purpose}" for purpose, count in purposes.items())
        say(f"{counted(purposes.total(), 'interaction')}: {told}")
    else:
        say(counted(total, "interaction"))
    say(f"everything lies in {folder.path}; {folder / layout.DOMAIN} is the domain")
    runs = [run for _, run in tried if run]
    tries = Tries(sum(run.reached for run in runs), len(runs), len(tried))
    compiled = judge_domain(Grounding.load(folder / layout.GROUNDING))
    for line in worst((compiled, judge_tries({DEFAULT_PLANNER: tries}))).lines:
        say(line)
