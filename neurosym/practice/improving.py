"""Improving an operator: it is rehearsed on more objects, or other actions for its symbol are auditioned."""

from collections.abc import Sequence
from dataclasses import dataclass

import msgspec
import numpy as np

from neurosym.data.interactions import Interactions
from neurosym.learning.direct_model import DirectModel
from neurosym.learning.effect_model import EffectModel
from neurosym.naming import name_operator
from neurosym.operators import Category, Operator, Primitive
from neurosym.primitives.categories import rounded
from neurosym.primitives.distillation import distill
from neurosym.primitives.judging import Judgement, judge, performance
from neurosym.primitives.modes import sort_into_modes
from neurosym.primitives.own import DIFFERENT, ROUNDS, moved, shortlist_own
from neurosym.primitives.performing import perform
from neurosym.primitives.rehearsal import rehearsal_of
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
        """Draw objects of a category, others each turn; fewer if it is too rare.

        Args:
            category: The category.
            count: How many.
            turn: Number of the turn.
        """
        found: list[Scene] = []
        for number in range(MOST_DRAWS * count):
            scene = draw_scene(self.world, self.seed, _STREAM, turn * MOST_DRAWS * count + number)
            if symbols_of(self.model.object_symbols, scene.features) == (category.symbol,):
                found.append(scene)
            if len(found) == count:
                break
        return tuple(found)

    def perform(self, tasks: Sequence[Task]) -> tuple[Outcome, ...]:
        """Perform actions, each on the one object of a scene.

        Args:
            tasks: The scenes and actions.
        """
        return tuple(perform(self.world_factory, tasks, self.workers, None))


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


def rehearse_more(
    shop: Workshop, operator: Operator, primitive: Primitive, category: Category, count: int, turn: int
) -> Improved:
    """Rehearse an operator on more objects of its category.

    Args:
        shop: What it is improved with.
        operator: The operator.
        primitive: The action that it is performed with.
        category: Its category.
        count: How many objects more.
        turn: Number of the turn, for which objects are drawn.
    """
    scenes = shop.scenes(category, count, turn)
    if not scenes:
        return Improved(operator, None, 0)
    outcomes = _rehearse(shop, primitive, scenes)
    known, counted = rehearsed_objects(operator, category), operator.trials
    objects = (*known[:counted], *_features(scenes), *known[counted:])
    rows = operator.rehearsals
    rehearsals = (*rows[:counted], *map(rehearsal_of, outcomes), *rows[counted:])
    improved = msgspec.structs.replace(
        operator, objects=objects, rehearsals=rehearsals, trials=counted + len(outcomes)
    )
    improved = _tabulated(improved)
    return Improved(renamed(improved, category, operator.variant), None, len(scenes))


def audition_others(
    shop: Workshop, operator: Operator, primitive: Primitive, category: Category, turn: int
) -> Improved:
    """Audition other actions of the symbol that do much the same, and take the surest in place of this one.

    They are found as in distillation, from other interactions. Those predicted to do most exactly what this
    one does are performed, moved by a millimetre; the best of them once more. If one is surer than this one,
    it is rehearsed on as many objects as this one was.

    Args:
        shop: What it is improved with.
        operator: The operator.
        primitive: The action that it is performed with.
        category: Its category.
        turn: Number of the turn, for which candidates and objects are drawn.
    """
    first, last = ROUNDS
    scenes = shop.scenes(category, first.objects + last.objects, turn)
    if len(scenes) < first.objects + last.objects:
        return Improved(operator, None, 0)
    rivals = [primitive, *_rivals(shop, primitive, category, turn)]
    seen: list[list[Outcome]] = [[] for _ in rivals]
    _audition(shop, rivals, seen, scenes[: first.objects], range(len(rivals)))
    best = _ranked(seen)[: last.candidates]
    _audition(shop, rivals, seen, scenes[first.objects :], sorted({0, *best}))
    spent = sum(map(len, seen))
    winner = next(number for number in _ranked(seen) if number in {0, *best})
    if winner == 0:
        return Improved(operator, None, spent)
    chosen = rivals[winner]
    rehearsed = shop.scenes(category, len(operator.rehearsals), turn + 1)
    outcomes = _rehearse(shop, chosen, rehearsed)
    improved = msgspec.structs.replace(
        operator,
        objects=_features(rehearsed),
        rehearsals=tuple(map(rehearsal_of, outcomes)),
        trials=len(outcomes),
    )
    return Improved(_tabulated(improved), chosen, spent + len(outcomes))


def renamed(operator: Operator, category: Category, variant: str) -> Operator:
    """Return an operator that is performed with another action of its symbol, by the name of what it does.

    Args:
        operator: The operator, as it was rehearsed with that action.
        category: Its category.
        variant: The letter of the action.
    """
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


def _audition(
    shop: Workshop,
    rivals: Sequence[Primitive],
    seen: list[list[Outcome]],
    scenes: Sequence[Scene],
    chosen: Sequence[int],
) -> None:
    """Have some of the rivals perform on objects, their actions moved a little."""
    box = shop.world.action_box
    tasks = [
        Task(scene, action)
        for number in chosen
        for scene, action in zip(scenes, moved(rivals[number], len(scenes), box, shop.seed), strict=True)
    ]
    outcomes = iter(shop.perform(tasks))
    for number in chosen:
        seen[number] += [next(outcomes) for _ in scenes]


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


def _rehearse(shop: Workshop, primitive: Primitive, scenes: Sequence[Scene]) -> tuple[Outcome, ...]:
    return shop.perform([Task(scene, np.array(primitive.action)) for scene in scenes])


def _features(scenes: Sequence[Scene]) -> Rows:
    return tuple(rounded(scene.features[0]) for scene in scenes)


def _tabulated(operator: Operator) -> Operator:
    """Sort the rehearsals of an operator that are its trials into modes anew."""
    rows = operator.rehearsals[: operator.trials]
    modes = sort_into_modes(
        [row.kind for row in rows],
        np.array([row.effect for row in rows]),
        np.array([row.resting_effect for row in rows]),
        np.array([row.peak_height for row in rows]),
    )
    return msgspec.structs.replace(operator, modes=modes)
