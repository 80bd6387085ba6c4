"""Trying tasks of relations with a learned domain; geometry that a person wrote says what was reached.

Learned relations are compared with symbols of one object at a time: a person says what to carry where to, one
thing after another. What carries that object to places most surely, as was learned of it alone, is aimed at
the other object as if that were a place. Nothing is tried again there, as nothing that was learned of single
objects tells what rests on what.
"""

from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
from jaxtyping import Float

from neurosym.errors import InvalidValue
from neurosym.evaluation.comparison import Bench, Setting, planner_of
from neurosym.execution.executor import execute
from neurosym.execution.performance import failure
from neurosym.operators import TOLERANCE
from neurosym.planners import PlanStatus
from neurosym.problems import Problem
from neurosym.stages.folder import DomainFolder
from neurosym.stages.problem_making import sight_of_pairs
from neurosym.tasks.options import carriers_for, puts_for
from neurosym.tasks.supports import PairSight, with_contacts, with_pairs
from neurosym.tasks.transition import expected_success
from neurosym.world import Outcome, Scene, World, relative_to
from neurosym.worlds.aims import Adapted
from neurosym.worlds.task_drawing import items_of
from tools.benchmarks.domains import bench_of
from tools.benchmarks.jobs import cpu_seconds
from tools.benchmarks.planning.trials import PLANNER
from tools.benchmarks.relations.protocols import Likened
from tools.benchmarks.relations.tasks import Asked, Draw

TIME_LIMIT = 60.0  # of one plan [s]; far more than any takes
Words = Mapping[str, Sequence[str]]  # symbols of the states that geometry calls so


class Remembering(Adapted):
    """A world that remembers how its last interaction ended."""

    def __init__(self, world: World):
        super().__init__(world)
        self.last: Outcome | None = None

    def sample_scene(self, rng: np.random.Generator, objects: int) -> Scene:
        """Draw a scene; see `World.sample_scene`."""
        return self._world.sample_scene(rng, objects)

    def interact(self, scene: Scene, action: Float[np.ndarray, " A"], target: int, **options: Any) -> Outcome:
        """Perform an action; see `World.interact`."""
        self.last = self._world.interact(scene, action, target, **options)
        return self.last


class Trial(msgspec.Struct, frozen=True, omit_defaults=True):
    """What became of one task."""

    status: str  # how the search for a plan ended; "cannot be said" where no state means what is asked for
    reason: str = ""  # why there is no plan, or why it failed
    reached: bool = False  # whether what was asked for is so in the end, with replanning
    blind: bool = False  # the same of the plan followed blindly
    believed: bool = False  # whether the learned states say that it is so, with replanning
    primitives: int = 0  # how many were performed, with replanning
    chance: float | None = None  # printed with the plan: that it comes true as it is
    cpu: float = 0.0  # what all of it took [CPU s]


@cache
def _sight_of(folder: Path) -> PairSight | None:
    return sight_of_pairs(DomainFolder(folder))


def try_all(folder: Path, words: Words, draw: Draw, seeds: Sequence[int]) -> list[Any]:
    """Try tasks; nothing depends on the clock, as far as plans are found in time."""
    bench, sight = bench_of(folder), _sight_of(folder)
    tried = [_try_task(bench, sight, words, draw(bench.setting.world, n), f"task-{n}") for n in seeds]
    found: list[Any] = msgspec.to_builtins(tried)
    return found


def _try_task(bench: Bench, sight: PairSight | None, words: Words, asked: Asked, name: str) -> Trial:
    """Plan for a task, and execute the plan with replanning and blindly."""
    begin, setting = cpu_seconds(), bench.setting
    try:
        problem = as_problem(bench, sight, words, asked, name)
    except InvalidValue as error:
        return Trial("cannot be said", str(error))
    if problem is None:
        return Trial("cannot be said")
    world, grounding = Remembering(setting.world), setting.grounding
    solve = planner_of(Setting(world, grounding, setting.predict), PLANNER, time_limit=TIME_LIMIT)
    found = solve(problem, grounding)
    if found.status is not PlanStatus.SOLVED:
        return Trial(found.status.value, found.reason, cpu=cpu_seconds() - begin)
    run = execute(world, problem, grounding, found.steps, replanner=solve)
    reached = blind = world.last is not None and asked.is_met(world.last)
    if run.replannings:
        execute(world, problem, grounding, found.steps)
        blind = asked.is_met(world.last)
    return Trial(
        status=found.status.value,
        reason="" if run.reached else f"{failure(run)}: {run.reason}",
        reached=reached,
        blind=blind,
        believed=run.reached,
        primitives=len(run.steps),
        chance=round(expected_success(found.steps, problem, grounding), 4),
        cpu=round(cpu_seconds() - begin, 2),
    )


def as_problem(
    bench: Bench, sight: PairSight | None, words: Words, asked: Asked, name: str
) -> Problem | None:
    """Say what is asked for in the words of a domain; None if it has none for that.

    Of several states that mean the same, a goal gets the one that the pair is brought to most surely.
    """
    grounding = bench.setting.grounding
    relations = grounding.relations
    assert relations is not None, "relations were learned"
    items = items_of(asked.start, bench.categorise)
    names = [item.name for item in items]
    goals = {names[n]: (place.x, place.y, items[n].features[2] / 2) for n, place in asked.places.items()}
    plain = with_contacts(Problem(name, items, goals, TOLERANCE), asked.contacts)
    plain = with_pairs(plain, relations, sight)
    if isinstance(asked, Likened):
        return asked.asked_of(plain, grounding)
    wanted = []
    for goal in asked.goals:
        meant = words.get(goal.word, ())
        target, reference = names[goal.target], names[goal.reference]
        puts = [put for put in puts_for(plain, grounding, target, reference) if put.state.symbol in meant]
        best = max(puts, key=lambda put: put.share, default=None)
        if best is None and not meant:
            return None
        state = best.state if best else relations.state_named(meant[0])
        wanted.append((target, reference, state.name))
    return msgspec.structs.replace(plain, relations=tuple(wanted))


def one_by_one(folder: Path, draw: Draw, seeds: Sequence[int]) -> list[bool]:
    """Say of tasks whether they are reached with symbols of one object at a time."""
    bench = bench_of(folder)
    return [_is_reached(bench, draw(bench.setting.world, seed)) for seed in seeds]


def _is_reached(bench: Bench, asked: Asked) -> bool:
    world, grounding = bench.setting.world, bench.setting.grounding
    items = items_of(asked.start, bench.categorise)
    scene, outcome = asked.start, None
    for target, reference in asked.deeds:
        carriers = carriers_for(items[target], grounding, TOLERANCE)
        if not carriers:
            return False
        action = np.array(grounding.primitive_of(carriers[0]).action)
        try:
            outcome = world.interact(scene, action, target, **relative_to(world, reference))
        except InvalidValue:  # the step before left an object where the arm cannot reach
            return False
        scene = outcome.end
    return outcome is not None and asked.is_met(outcome)
