"""Trying tasks of relations with a learned domain; geometry that a person wrote says what was reached."""

from collections.abc import Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import msgspec
import numpy as np
from jaxtyping import Float

from neurosym.evaluation.comparison import Bench, Setting, planner_of
from neurosym.execution.executor import execute
from neurosym.execution.rerun import failure
from neurosym.operators import TOLERANCE
from neurosym.planners import PlanStatus
from neurosym.problems import Problem
from neurosym.stages.folder import DomainFolder
from neurosym.stages.problem_making import sight_of_pairs
from neurosym.tasks.options import puts_for
from neurosym.tasks.supports import PairSight, with_contacts, with_pairs
from neurosym.world import Outcome, Scene, World
from neurosym.worlds.aims import Adapted
from neurosym.worlds.task_drawing import items_of
from tools.benchmarks.planning.trials import PLANNER
from tools.benchmarks.relations.tasks import Asked, Draw
from tools.benchmarks.spent import cpu_seconds

TIME_LIMIT = 60.0
"""Of one plan [s]; far more than any takes."""
Words = Mapping[str, Sequence[str]]
"""Symbols of the states that geometry calls so."""


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
    """What became of one task.

    Attributes:
        status: How the search for a plan ended; "cannot be said" where no state means what is asked for.
        reason: Why there is no plan, or why it failed.
        reached: Whether what was asked for is so in the end, with replanning.
        blind: The same of the plan followed blindly.
        believed: Whether the learned states say that it is so, with replanning.
        primitives: How many primitives were performed, with replanning.
        cpu: CPU seconds that all of it took.
    """

    status: str
    reason: str = ""
    reached: bool = False
    blind: bool = False
    believed: bool = False
    primitives: int = 0
    cpu: float = 0.0


@cache
def bench_of(folder: Path) -> tuple[Bench, PairSight | None]:
    """Load a domain folder, once in each process."""
    domain = DomainFolder(folder)
    return Bench(domain), sight_of_pairs(domain)


def try_all(folder: Path, words: Words, draw: Draw, seeds: Sequence[int]) -> list[Any]:
    """Try tasks; nothing depends on the clock, as far as plans are found in time."""
    bench, sight = bench_of(folder)
    tried = [try_task(bench, sight, words, draw(bench.setting.world, seed), f"task-{seed}") for seed in seeds]
    found: list[Any] = msgspec.to_builtins(tried)
    return found


def try_task(bench: Bench, sight: PairSight | None, words: Words, asked: Asked, name: str) -> Trial:
    """Plan for a task, and execute the plan with replanning and blindly."""
    begin = cpu_seconds()
    problem = as_problem(bench, sight, words, asked, name)
    if problem is None:
        return Trial("cannot be said")
    world, grounding = Remembering(bench.setting.world), bench.setting.grounding
    solve = planner_of(Setting(world, grounding, bench.setting.predict), PLANNER, time_limit=TIME_LIMIT)
    found = solve(problem, grounding)
    if found.status is not PlanStatus.SOLVED:
        return Trial(found.status.value, found.reason, cpu=cpu_seconds() - begin)
    run = execute(world, problem, grounding, found.steps, replanner=solve)
    reached = blind = _is_met(asked, world)
    if run.replannings:
        execute(world, problem, grounding, found.steps)
        blind = _is_met(asked, world)
    reason = "" if run.reached else f"{failure(run)}: {run.reason}"
    done = len(run.steps)
    return Trial(
        found.status.value, reason, reached, blind, run.reached, done, round(cpu_seconds() - begin, 2)
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
    heights = {target: items[target].features[2] / 2 for target in asked.places}
    goals = {names[n]: (place.x, place.y, heights[n]) for n, place in asked.places.items()}
    plain = with_contacts(Problem(name, items, goals, TOLERANCE), asked.contacts)
    plain = with_pairs(plain, relations, sight)
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


def _is_met(asked: Asked, world: Remembering) -> bool:
    return world.last is not None and asked.is_met(world.last)
