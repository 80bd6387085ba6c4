"""Improving an operator: it is rehearsed on more objects, or other actions for its symbol are auditioned."""

from collections.abc import Sequence
from dataclasses import dataclass

import msgspec
import numpy as np

from neurosym.data.interactions import Interactions
from neurosym.learning.direct_model import DirectModel
from neurosym.learning.effect_model import EffectModel
from neurosym.naming import name_operator
from neurosym.operators import Category, Operator, Primitive, Rehearsal
from neurosym.primitives.distillation import distill
from neurosym.primitives.judging import Judgement, judge, performance
from neurosym.primitives.own import DIFFERENT, ROUNDS, moved, shortlist_own
from neurosym.primitives.performing import perform, tasks_of
from neurosym.primitives.rehearsal import modes_of, rehearsal_of, rounded
from neurosym.primitives.sampling import MOST_DRAWS, draw_scene
from neurosym.promises import rehearsed_objects
from neurosym.symbols import symbols_of
from neurosym.world import Outcome, Scene, World, WorldFactory
from neurosym.worlds.workers import Task

_STREAM = 0x70726163  # keeps the objects of practice apart from those of rehearsal
Rows = tuple[tuple[float, ...], ...]


@dataclass(frozen=True, slots=True, eq=False)
class Workshop:
    """What operators are improved with.

    Attributes:
        world_factory: Builds the world; must survive pickling if there is more than one worker.
        world: A world that it built.
        model: Whose symbols they are.
        direct: A network without a bottleneck, which shortlists.
        interactions: The data that candidates start from.
        seed: Where all draws start.
        workers: How many processes; their number does not change the result.
    """

    world_factory: WorldFactory
    world: World
    model: EffectModel
    direct: DirectModel
    interactions: Interactions
    seed: int
    workers: int = 1

    def scenes(self, category: Category, count: int, turn: int) -> tuple[Scene, ...]:
        """Draw so many objects of a category, others each turn; fewer if it is too rare."""
        found: list[Scene] = []
        for number in range(MOST_DRAWS * count):
            scene = draw_scene(self.world, self.seed, _STREAM, turn * MOST_DRAWS * count + number)
            if symbols_of(self.model.object_symbols, scene.features) == (category.symbol,):
                found.append(scene)
            if len(found) == count:
                break
        return tuple(found)

    def rehearse(self, primitive: Primitive, scenes: Sequence[Scene]) -> tuple[Outcome, ...]:
        """Perform a primitive on each of some objects."""
        return self.perform(tasks_of(primitive, scenes))

    def perform(self, tasks: Sequence[Task]) -> tuple[Outcome, ...]:
        """Perform actions, each on the one object of a scene."""
        return tuple(perform(self.world_factory, tasks, self.workers, None))


@dataclass(frozen=True, slots=True)
class Learner:
    """An operator that is practised, the action it is performed with, and the category it is for."""

    operator: Operator
    primitive: Primitive
    category: Category


@dataclass(frozen=True, slots=True)
class Improved:
    """An operator after some practice.

    Attributes:
        operator: The operator, maybe with a new name.
        primitive: The action that it is performed with, if that is another one now; without a variant.
        interactions: How many that took.
    """

    operator: Operator
    primitive: Primitive | None
    interactions: int


def rehearse_more(shop: Workshop, learner: Learner, count: int, turn: int) -> Improved:
    """Rehearse an operator on more objects of its category, which are drawn for a turn."""
    operator = learner.operator
    scenes = shop.scenes(learner.category, count, turn)
    if not scenes:
        return Improved(operator, None, 0)
    outcomes = shop.rehearse(learner.primitive, scenes)
    known, rows = rehearsed_objects(operator, learner.category), operator.rehearsals
    counted = operator.trials
    improved = _tabulated(
        operator,
        (*known[:counted], *_features(scenes), *known[counted:]),
        (*rows[:counted], *map(rehearsal_of, outcomes), *rows[counted:]),
        counted + len(outcomes),
    )
    return Improved(renamed(improved, learner.category, operator.variant), None, len(scenes))


def audition_others(shop: Workshop, learner: Learner, turn: int) -> Improved:
    """Audition other actions of the symbol that do much the same, and take the surest in place of this one.

    They are found as in distillation, from other interactions. Those predicted to do most exactly what this
    one does are performed, moved by a millimetre; the best of them once more. If one is surer than this one,
    it is rehearsed on as many objects as this one was.
    """
    operator, (first, last) = learner.operator, ROUNDS
    scenes = shop.scenes(learner.category, first.objects + last.objects, turn)
    if len(scenes) < first.objects + last.objects:
        return Improved(operator, None, 0)
    rivals = [learner.primitive, *_rivals(shop, learner.primitive, learner.category, turn)]
    seen = _auditioned(shop, rivals, scenes[: first.objects])
    left = sorted({0, *_ranked(seen)[: last.candidates]})
    once_more = _auditioned(shop, [rivals[number] for number in left], scenes[first.objects :])
    for number, outcomes in zip(left, once_more, strict=True):
        seen[number] += outcomes
    spent = sum(map(len, seen))
    winner = next(number for number in _ranked(seen) if number in left)
    if winner == 0:
        return Improved(operator, None, spent)
    rehearsed = shop.scenes(learner.category, len(operator.rehearsals), turn + 1)
    rows = tuple(map(rehearsal_of, shop.rehearse(rivals[winner], rehearsed)))
    improved = _tabulated(operator, _features(rehearsed), rows, len(rows))
    return Improved(improved, rivals[winner], spent + len(rows))


def renamed(operator: Operator, category: Category, variant: str) -> Operator:
    """Return an operator that is performed with another action of its symbol, by the name of what it does."""
    name = name_operator(operator.primitive + variant, category.name, operator.modes)
    return msgspec.structs.replace(operator, name=name, variant=variant)


def _rivals(shop: Workshop, primitive: Primitive, category: Category, turn: int) -> list[Primitive]:
    """Distil actions for a symbol, and keep a few that are predicted to do what one of them does."""
    rows = np.flatnonzero(np.array(shop.model.action_symbols(shop.interactions.actions)) == primitive.symbol)
    box, features = shop.world.action_box, np.array(category.objects)
    found = distill(shop.model, shop.interactions[rows], box, seed=shop.seed + turn + 1)
    predicted = [
        shop.direct.predict_outcomes(features, np.tile(one.action, (len(features), 1)))[:, :3].mean(0)
        for one in (primitive, *found)
    ]
    alike = [
        one
        for one, mean in zip(found, predicted[1:], strict=True)
        if one.symbol == primitive.symbol and np.linalg.norm(mean - predicted[0]) <= DIFFERENT
    ]
    (shortlisted,) = shortlist_own(
        [alike], shop.direct.predict_outcomes, features, box, ROUNDS[0].candidates, shop.seed
    )
    return shortlisted


def _auditioned(shop: Workshop, rivals: Sequence[Primitive], scenes: Sequence[Scene]) -> list[list[Outcome]]:
    """Have each of some rivals perform on objects, their actions moved a little."""
    box, count = shop.world.action_box, len(scenes)
    tasks = [
        Task(scene, action)
        for rival in rivals
        for scene, action in zip(scenes, moved(rival, count, box, shop.seed), strict=True)
    ]
    outcomes = iter(shop.perform(tasks))
    return [[next(outcomes) for _ in scenes] for _ in rivals]


def _ranked(seen: Sequence[Sequence[Outcome]]) -> list[int]:
    """Rank rivals by how sure they are, of those that do much the same as the first."""
    judged = [judge([performance(outcome) for outcome in outcomes]) for outcomes in seen]
    alike = [number for number, one in enumerate(judged) if _is_like(one, judged[0])]
    return sorted(alike, key=lambda number: (-judged[number].sureness, number))


def _is_like(one: Judgement, other: Judgement) -> bool:
    """Say whether two do much the same; whatever ends upright does, beside what never does."""
    if other.kind is None or one is other:
        return True
    return one.kind == other.kind and bool(np.linalg.norm(one.mean[:3] - other.mean[:3]) <= DIFFERENT)


def _features(scenes: Sequence[Scene]) -> Rows:
    return tuple(rounded(scene.features[0]) for scene in scenes)


def _tabulated(operator: Operator, objects: Rows, rehearsals: tuple[Rehearsal, ...], trials: int) -> Operator:
    """Give an operator rehearsals on objects, those that are its trials sorted into modes anew."""
    modes = modes_of(rehearsals[:trials])
    return msgspec.structs.replace(
        operator, objects=objects, rehearsals=rehearsals, trials=trials, modes=modes
    )
