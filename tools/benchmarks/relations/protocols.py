"""What others asked of robots that learn relations, as near as this robot and its world come to it.

The authors of the paper draw tasks by what random actions do: up to three of them with three objects, or one
with five to ten. Their actions are given: grasp, and let go near another object. Here a person's grasp does
that. Objects have other shapes and sizes than theirs, and this simulator takes eight at most.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import permutations
from pathlib import Path

import numpy as np

from neurosym.learning.network import EffectModel
from neurosym.pair_operators import PlaceOperators, extent
from neurosym.stages.layout import MODEL, PLACE_OPERATORS, RELATION_MODEL, WORLD
from neurosym.world import OtherObject, Outcome, Place, Scene, World, relative_to
from neurosym.worlds.aims import REFERENCE, TARGET, KnownMotions, Related, as_pair
from neurosym.worlds.workers import Task, perform_all
from neurosym.worlds.world_file import read_world
from tools.benchmarks.relations.geometry import relation
from tools.benchmarks.relations.tasks import Asked, Cell, Goal, drawn
from tools.benchmarks.world.hand_written import REACH, carry_to

FEW, MOST_PUTS = 3, 3
"""How many objects there are where up to so many things are put somewhere."""
AMONG = (5, 8)
"""How many objects there are, at least and at most, where one thing is put somewhere."""
NEAR = 0.09
"""So near to where it was must each object come then [m]."""
PREDICTED, SIZES = 150, (2, 3, 4)
"""How many interactions are predicted, with so many objects each."""
_STREAM = 0x7072


@dataclass(frozen=True, slots=True, eq=False)
class Likened(Asked):
    """A task to make a scene like another one.

    Attributes:
        like: The other scene.
    """

    like: Scene

    def is_met(self, end: Outcome) -> bool:
        """Say whether each object is near where it is in the other scene."""
        return bool(np.linalg.norm(end.end.positions - self.like.positions, axis=1).max() <= NEAR)


def cells(count: int) -> tuple[Cell, ...]:
    """List what is tried."""
    return (("up to three puts of three", few, count), ("one put among 5 to 8", one_put, count))


def few(world: World, seed: int) -> Asked:
    """Draw what one to three puts with three objects lead to: whatever then stands on or in something."""

    def attempt(scene: Scene, rng: np.random.Generator) -> Asked | None:
        end, before = None, scene
        for _ in range(1 + seed % MOST_PUTS):
            end = _put(before, rng, world, off=0.0)
            if end is None or end.disturbed:
                return None
            before = end.end
        assert end is not None, "one or more were put"
        goals = tuple(
            Goal(one, other, name)
            for one, other in permutations(range(FEW), 2)
            if (name := relation(end, one, other)) in ("on", "in")
        )
        return Asked(scene, (), goals, {}, ()) if goals and _is_plain(goals) else None

    return drawn(attempt, FEW, [12], seed)


def one_put(world: World, seed: int) -> Likened:
    """Draw two consecutive states among five to eight objects: between them one is put near another one."""

    def attempt(scene: Scene, rng: np.random.Generator) -> Likened | None:
        start = _put(scene, rng, world, off=REACH)
        end = _put(start.end, rng, world, off=REACH) if start else None
        if start is None or end is None:
            return None
        moved = np.linalg.norm(end.end.positions - start.end.positions, axis=1)
        goals, places = list[Goal](), dict[int, Place]()
        for index in np.flatnonzero(moved > NEAR).tolist():
            bearing = [
                Goal(index, other, name)
                for other in range(len(moved))
                if other != index and (name := relation(end, index, other)) in ("on", "in")
            ]
            goals += bearing
            if not bearing:
                places[index] = Place(*end.end.positions[index][:2].tolist())
        if not (goals or places) or not _is_plain(goals):
            return None
        return Likened(start.end, start.contacts, tuple(goals), places, (), end.end)

    low, high = AMONG
    return drawn(attempt, low + seed % (high - low + 1), [13], seed)


def _is_plain(goals: Sequence[Goal]) -> bool:
    """Say whether nothing stands on or in two things at once, which goals cannot say."""
    return len({goal.target for goal in goals}) == len(goals)


def _put(scene: Scene, rng: np.random.Generator, world: World, *, off: float) -> Outcome | None:
    """Put some object over another one, so far off its middle at most [m]; None if nothing was carried."""
    target, reference = rng.permutation(len(scene))[:2].tolist()
    action = carry_to(scene.features[target])
    if action is None:
        return None
    action[-4:-2] += rng.uniform(-off, off, 2)
    clipped = np.clip(action, world.action_box.low, world.action_box.high)
    outcome = world.interact(scene, clipped, target, **relative_to(world, OtherObject(reference)))
    return outcome if outcome.kind == "carried" else None


def effect_errors(folder: Path, seed: int, workers: int) -> dict[str, dict[str, float]]:
    """Predict where all objects end, by the network of pairs, for actions drawn as exploring draws them.

    Returns:
        For each number of objects the mean error of an object, summed over x, y and z [cm]; the same if
        nothing moved; and the share of the interactions in which the target was carried.
    """
    plain, model = read_world(folder / WORLD), EffectModel.load(folder / RELATION_MODEL)
    categorise = EffectModel.load(folder / MODEL).object_symbols
    world = plain()
    motions = KnownMotions(PlaceOperators.load(folder / PLACE_OPERATORS), categorise, world.action_box)
    related, found = Related(world, motions), dict[str, dict[str, float]]()
    for objects in SIZES:
        rng = np.random.default_rng([seed, _STREAM, objects])
        scenes = [world.sample_scene(rng, objects) for _ in range(PREDICTED)]
        actions = [related.draw_actions(rng, as_pair(scene), 2)[0] for scene in scenes]
        tasks = [
            Task(scene, action, TARGET, reference=OtherObject(REFERENCE))
            for scene, action in zip(scenes, actions, strict=True)
        ]
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
