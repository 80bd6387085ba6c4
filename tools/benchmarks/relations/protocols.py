"""What others asked of robots that learn relations, as near as this robot and its world come to it.

The authors of the paper draw tasks by what random actions do: up to three of them with three objects, or one
with five to ten. Their actions are given: grasp, and let go near another object. Here a person's grasp does
that. Objects have other shapes and sizes than theirs, and this simulator takes eight at most.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import msgspec
import numpy as np

from neurosym.grounding import Grounding
from neurosym.learning.network import EffectModel
from neurosym.pair_operators import extent
from neurosym.problems import Problem
from neurosym.stages.layout import RELATION_MODEL, WORLD
from neurosym.tasks.goal_choice import with_goals
from neurosym.world import OtherObject, Outcome, Scene, World, relative_to
from neurosym.worlds.aims import REFERENCE, TARGET, Related, as_pair
from neurosym.worlds.workers import Task, perform_all
from neurosym.worlds.world_file import read_world
from tools.benchmarks.relations.geometry import relation
from tools.benchmarks.relations.symbols import known_motions
from tools.benchmarks.relations.tasks import Asked, Cell, Goal, Unfit, drawn
from tools.benchmarks.world.hand_written import REACH, carry_to

FEW, MOST_PUTS = 3, 3  # how many objects there are where up to so many things are put somewhere
AMONG = (5, 8)  # how many objects there are, at least and at most, where one thing is put somewhere
NEAR = 0.09  # so near to where it was must each object come then [m]
PREDICTED, SIZES = 150, (2, 3, 4)  # how many interactions are predicted, with so many objects each
_STREAM = 0x7072


@dataclass(frozen=True, slots=True, eq=False)
class Likened(Asked):
    """A task to make a scene like another one, and no more is said of it."""

    like: Scene

    def asked_of(self, problem: Problem, grounding: Grounding) -> Problem:
        """Ask for each object to be where it is in the other scene; nothing else is told."""
        points = [",".join(f"{value:.3f}" for value in point) for point in self.like.positions.tolist()]
        wanted = tuple(f"{name} at {point}" for name, point in zip(problem.object_names, points, strict=True))
        return with_goals(msgspec.structs.replace(problem, conditions=wanted, tolerance=NEAR), grounding)

    def is_met(self, end: Outcome) -> bool:
        """Say whether each object is near where it is in the other scene."""
        return bool(np.linalg.norm(end.end.positions - self.like.positions, axis=1).max() <= NEAR)


def cells(count: int) -> tuple[Cell, ...]:
    """List what is tried."""
    return (("up to three puts of three", few, count), ("one put among 5 to 8", one_put, count))


def few(world: World, seed: int) -> Asked:
    """Draw what one to three puts with three objects lead to: whatever then stands on or in something."""

    def attempt(scene: Scene, rng: np.random.Generator) -> Asked:
        before = scene
        for _ in range(1 + seed % MOST_PUTS):
            end = _put(before, rng, world, off=0.0)
            if end.disturbed:
                raise Unfit
            before = end.end
        goals = _plain(goal for one in range(FEW) for goal in _borne(end, one))
        if not goals:
            raise Unfit
        return Asked(scene, (), goals, {}, ())

    return drawn(attempt, FEW, [12], seed)


def one_put(world: World, seed: int) -> Likened:
    """Draw two consecutive states among five to eight objects: between them one is put near another one."""

    def attempt(scene: Scene, rng: np.random.Generator) -> Likened:
        start = _put(scene, rng, world, off=REACH)
        end = _put(start.end, rng, world, off=REACH)
        moved = np.linalg.norm(end.end.positions - start.end.positions, axis=1)
        far = np.flatnonzero(moved > NEAR).tolist()
        if not far:
            raise Unfit
        _plain(goal for one in far for goal in _borne(end, one))
        return Likened(start.end, start.contacts, (), {}, (), end.end)

    low, high = AMONG
    return drawn(attempt, low + seed % (high - low + 1), [13], seed)


def _borne(end: Outcome, one: int) -> list[Goal]:
    """List what an object stands on or in."""
    words = [(other, relation(end, one, other)) for other in range(len(end.end)) if other != one]
    return [Goal(one, other, word) for other, word in words if word in ("on", "in")]


def _plain(goals: Iterable[Goal]) -> tuple[Goal, ...]:
    """Return goals of which none asks that something stands on or in two things at once."""
    known = tuple(goals)
    if len({goal.target for goal in known}) < len(known):
        raise Unfit
    return known


def _put(scene: Scene, rng: np.random.Generator, world: World, *, off: float) -> Outcome:
    """Put some object over another one, so far off its middle at most [m]."""
    target, reference = rng.permutation(len(scene))[:2].tolist()
    action = carry_to(scene.features[target])
    if action is None:
        raise Unfit
    action[-4:-2] += rng.uniform(-off, off, 2)
    clipped = np.clip(action, world.action_box.low, world.action_box.high)
    outcome = world.interact(scene, clipped, target, **relative_to(world, OtherObject(reference)))
    if outcome.kind != "carried":
        raise Unfit
    return outcome


def effect_errors(folder: Path, seed: int, workers: int) -> dict[str, dict[str, float]]:
    """Predict where all objects end, by the network of pairs, for actions drawn as exploring draws them.

    Returns:
        For each number of objects the mean error of an object, summed over x, y and z [cm]; the same if
        nothing moved; and the share of the interactions in which the target was carried.
    """
    plain, model = read_world(folder / WORLD), EffectModel.load(folder / RELATION_MODEL)
    world, other = plain(), OtherObject(REFERENCE)
    related, found = Related(world, known_motions(folder, world)), dict[str, dict[str, float]]()
    for objects in SIZES:
        rng = np.random.default_rng([seed, _STREAM, objects])
        scenes = [world.sample_scene(rng, objects) for _ in range(PREDICTED)]
        actions = [related.draw_actions(rng, as_pair(scene), 2)[0] for scene in scenes]
        rows = zip(scenes, actions, strict=True)
        tasks = [Task(scene, action, TARGET, reference=other) for scene, action in rows]
        outcomes = [*perform_all(plain, tasks, workers)]
        pairs = np.concatenate([as_pair(scene).features for scene in scenes])
        effects, _ = model.predict(pairs, np.array(actions))
        ends = [_predicted(scene, effect) for scene, effect in zip(scenes, effects, strict=True)]
        found[str(objects)] = {
            "error": _off(outcomes, ends),
            "nothing_moves": _off(outcomes, [scene.positions for scene in scenes]),
            "carried": float(np.mean([outcome.carried for outcome in outcomes])),
        }
    return found


def _predicted(scene: Scene, effect: np.ndarray) -> np.ndarray:
    """Return where the objects end if the target does as the network of pairs says, and no other moves."""
    ends = scene.positions.copy()
    if effect[-1] > 0.5:
        reach = (extent(scene, TARGET) + extent(scene, REFERENCE)) / 2
        ends[TARGET] = scene.positions[REFERENCE] + effect[:3] * reach
    return ends


def _off(outcomes: list[Outcome], ends: list[np.ndarray]) -> float:
    rows = zip(outcomes, ends, strict=True)
    return 100 * float(np.mean([np.abs(outcome.end.positions - end).sum(1).mean() for outcome, end in rows]))
