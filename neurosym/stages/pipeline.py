"""The whole way in one call, doing nothing twice."""

from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

from neurosym.checks import check_count
from neurosym.contract import made
from neurosym.data.interactions import Interactions
from neurosym.data.origin import StrategyName
from neurosym.errors import InvalidFile, InvalidValue, counted, quoted
from neurosym.files import at_once, digest, read_json, write_json
from neurosym.grounding import Grounding
from neurosym.learning.training import TrainingReport
from neurosym.operators import OperatorTable
from neurosym.pddl.compiler import CELL, compile_domain
from neurosym.stages.compilation import FORMAT, PracticeFile, compile_stage, practice_of
from neurosym.stages.console import progress_bar, say, say_next, show_table
from neurosym.stages.execution import execute_stage, load_run
from neurosym.stages.folder import Claim, DomainFolder, Stage, load_scene
from neurosym.stages.layout import (
    DIRECT_MODEL,
    GROUNDING,
    INTERACTIONS,
    MODEL,
    PLACE_INTERACTIONS,
    PLACE_OPERATORS,
    PRACTICE,
    PRIMITIVES,
    PROBLEMS,
    SCENE,
    TRAINING,
    WORLD,
    plan_files,
)
from neurosym.stages.learning import OBJECTS, TO_OBJECTS, TO_PLACES, distill_stage, explore_stage, train_stage
from neurosym.stages.plan_records import PlanRecord, written_steps
from neurosym.stages.planning import plan_stage
from neurosym.stages.problem_making import Asked, problem_stage
from neurosym.stages.rounds import Practised
from neurosym.stages.verdicts import Tries, Verdict, judge_domain, judge_training, judge_tries, worst
from neurosym.world import World, references_of
from neurosym.worlds.workers import check_workers
from neurosym.worlds.world_file import read_world

if TYPE_CHECKING:
    from neurosym.stages.practice import Workshop


PLANNER = "fast-downward"
MOST_PROBLEMS = 30
"""How many problems are drawn at most, if none of those asked for has a plan."""
PLACES_FOR = 4
"""For so many interactions there is one more that is aimed at a place, if the user does not say how many."""
LEAST_STEPS = 1024
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

    Raises:
        InvalidValue: If a number is impossible.
    """
    if problems < 0:
        raise InvalidValue(f"problems = {problems} must be at least 0.")
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
        rows = [_try_problem(folder, number, seed) for number in range(1, problems + 1)]
        while problems and len(rows) < MOST_PROBLEMS and not any(row.executed for row in rows):
            rows.append(_try_problem(folder, len(rows) + 1, seed))
    if rows:
        columns = ["problem", "objects", "plan", "primitives", "seconds", "goal", "why not"]
        show_table(
            f"{counted(len(rows), 'problem')} drawn from the world", columns, [row.cells for row in rows]
        )
    say(f"everything lies in {folder.path}; {folder / 'domain.pddl'} is the domain")
    for line in _judged(folder, rows).lines:
        say(line)
    say_next(f"neurosym plan {quoted(folder.path)} task-01 --planner bfs")


def _judged(folder: DomainFolder, rows: "list[_Row]") -> Verdict:
    """Judge the whole way by what came out worst: the bits, the domain, or the problems."""
    reached, found = sum(row.reached for row in rows), sum(row.executed for row in rows)
    report = read_json(folder / TRAINING, TrainingReport)
    return worst(
        (
            judge_training(report, Interactions.load(folder / INTERACTIONS)),
            judge_domain(Grounding.load(folder / GROUNDING)),
            judge_tries({PLANNER: Tries(reached, found, len(rows))}),
        )
    )


def _usual_places(folder: DomainFolder, world: World, steps: int) -> int:
    """Say how many interactions are aimed at places if the user does not: no fewer than there are."""
    if "place" not in references_of(world):
        return 0
    path, share = folder / PLACE_INTERACTIONS, steps // PLACES_FOR if steps >= LEAST_STEPS else 0
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


@dataclass(frozen=True, slots=True)
class _Row:
    cells: tuple[str, ...]
    executed: bool
    reached: bool = False


def _try_problem(folder: DomainFolder, number: int, seed: int) -> _Row:
    """Draw a problem, plan it, and execute the plan if there is one."""
    name, objects = f"task-{number:02d}", 2 - number % 2
    _perform(folder, problem_stage(folder, name, Asked(objects, seed=seed + number)))
    _perform(folder, plan_stage(folder, name, planner=PLANNER))
    record = read_json(folder / plan_files(name, PLANNER)[1], PlanRecord)
    cells = (name, str(objects), record.status.value, str(record.primitives), f"{record.seconds:.2f}")
    plan_file = written_steps(folder, name, PLANNER)
    if not (record.solved and plan_file):
        return _Row((*cells, "-", record.reason), executed=False)
    _perform(folder, execute_stage(folder, name, folder / plan_file))
    run = load_run(folder, name, folder / plan_file)
    outcome = run.outcome.removeprefix("goal ")
    return _Row((*cells, outcome, run.reason), executed=True, reached=run.reached)


def _perform(folder: DomainFolder, stage: Stage) -> None:
    done = folder.perform(stage, again=False)
    say(f"{stage.name}: {'done' if done else 'up to date'}")


# The stage that practises: what was learned, and `primitives.json` -> `practice.json`


def practise_stage(
    folder: DomainFolder, *, interactions: int, seed: int, workers: int, evenly: bool = False
) -> Stage:
    """Practise: networks, data, world and operators -> `practice.json`.

    What was practised before counts, so that an interrupted call goes on.

    Args:
        folder: The domain folder.
        interactions: How many in all.
        seed: Where all draws start.
        workers: How many processes; their number does not change the result.
        evenly: Rehearse all operators in turn instead.
    """
    check_count("interactions", interactions)
    check_workers(workers)

    def work() -> None:
        from neurosym.stages.practice import practise

        for scene in sorted((folder / PROBLEMS).glob(f"*{SCENE}")):
            load_scene(scene)  # it is printed anew afterwards: what cannot be used is refused now
        begun = _begun(folder, seed, evenly=evenly)
        shop = _workshop(folder, seed, workers)
        world, of = shop.world, digest(folder / PRIMITIVES)
        compiled = partial(
            compile_domain, name=world.name, table_bounds=world.table, lift_height=world.lift_height
        )

        def save(practised: Practised) -> None:
            write_json(folder / PRACTICE, PracticeFile(FORMAT, of, seed, evenly, practised))

        with progress_bar("practising") as advance:

            def on_round(practised: Practised) -> None:
                with at_once():  # a kill loses no more than the round that it comes in
                    save(practised)
                advance(min(practised.spent, interactions), interactions)

            advance(min(begun.spent, interactions), interactions)
            save(practise(shop, begun, compiled, interactions=interactions, evenly=evenly, on_round=on_round))

    options: dict[str, Any] = {"interactions": interactions, "seed": seed}
    if evenly:
        options["evenly"] = True
    inputs = (WORLD, INTERACTIONS, MODEL, DIRECT_MODEL, PRIMITIVES)
    return Stage("practise", inputs, (PRACTICE,), work, options, Claim.ALONE)


def _workshop(folder: DomainFolder, seed: int, workers: int) -> "Workshop":
    from neurosym.data.interactions import Interactions
    from neurosym.learning.network import DirectModel, EffectModel
    from neurosym.stages.practice import Workshop

    factory = read_world(folder.require(WORLD))
    return Workshop(
        factory,
        made(factory),
        EffectModel.load(folder.require(MODEL)),
        DirectModel.load(folder.require(DIRECT_MODEL)),
        Interactions.load(folder.require(INTERACTIONS)),
        seed,
        workers,
    )


def _begun(folder: DomainFolder, seed: int, *, evenly: bool) -> Practised:
    """Return what was practised so far, or the distilled operators without any practice."""
    distilled = OperatorTable.load(folder.require(PRIMITIVES))
    if not any(operator.rehearsals for operator in distilled.operators):
        raise InvalidFile(
            folder / PRIMITIVES,
            f"its rehearsals are not kept; `neurosym distill {quoted(folder.path)}` makes it anew",
        )
    found = practice_of(folder)
    if found is None:
        return Practised(distilled)
    if (found.seed, found.evenly) != (seed, evenly):
        how = "evenly, " if found.evenly else ""
        raise InvalidValue(
            f"{folder / PRACTICE} was practised {how}with seed = {found.seed}; go on so, or remove it to "
            "begin anew."
        )
    return found.practised
