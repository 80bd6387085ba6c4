"""Drawn tasks of relations ask for what was learned, can be solved, and are the same for the same seed."""

import msgspec
import numpy as np
import pytest
from toy_relations import KINDS, LIE, REST, WORLD, grounding, sorting

from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.execution.executor import execute
from neurosym.planners import PlanStatus, plan
from neurosym.problems import Problem
from neurosym.stages.problem_making import draw_any_task
from neurosym.tasks.supports import bearers_of, unmet_relations
from neurosym.worlds.toy_relations import ToyRelations

FEATURES = [features for _, features in KINDS.values()]


class Known(ToyRelations):
    """The toy world, with objects of the kinds that the domain was written for."""

    def sample_scene(self, rng: np.random.Generator, objects: int):
        """Draw a scene of cubes, blocks and trays."""
        kinds = np.array(FEATURES)[rng.integers(len(FEATURES), size=objects)]
        drawn = self._sample_places(rng, kinds[:, :2])
        upright = np.tile([0.0, 0.0, 0.0, 1.0], (objects, 1))
        return type(super().sample_scene(rng, 1))(kinds, np.column_stack([drawn, kinds[:, 2] / 2]), upright)


def categorise(features):
    return tuple(next(symbol for symbol, known in KINDS.values() if tuple(row) == known) for row in features)


def drawn(kind: str, objects: int = 6, seed: int = 0, **options) -> Problem:
    world = Known(WORLD.config)
    return draw_any_task(
        world, categorise, grounding(), kind, name="drawn", objects=objects, seed=seed, **options
    )


@pytest.mark.parametrize("kind", ["tower", "boxes", "unstack", "exchange"])
def test_tasks_are_solved_and_reached_in_the_world(kind):
    problem, learned = drawn(kind, seed=1), grounding()
    assert problem == drawn(kind, seed=1) != drawn(kind, seed=2)
    assert len(bearers_of(problem, learned.relations)) == (2 if kind in ("unstack", "exchange") else 0)
    assert unmet_relations(problem, learned)
    result = plan(problem, learned)
    assert result.status is PlanStatus.SOLVED, result.reason
    assert execute(WORLD, problem, learned, result.steps, replanner=plan).reached


def test_towers_are_as_high_as_asked_boxes_hold_several_and_stacks_stand_at_the_start():
    assert len(drawn("tower", height=4).related) == 3
    assert {state for *_, state in drawn("boxes").related} == {LIE}
    assert {state for *_, state in drawn("boxes", state=REST).related} == {REST}
    assert len({reference for _, reference, _ in drawn("boxes", objects=8).related}) == 4
    stacks = drawn("unstack", objects=8)
    assert max(item.position[2] for item in stacks.objects) > 0.1
    assert stacks.touching


def test_task_like_another_scene_asks_for_what_bears_what_there():
    other = msgspec.structs.replace(sorting(), relations=())
    problem = drawn("like", objects=5, like=other)
    assert set(problem.related) == {("item-01", "item-02", REST), ("item-02", "item-03", REST)}
    assert not bearers_of(problem, grounding().relations)
    assert plan(problem, grounding()).status is PlanStatus.SOLVED


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: drawn("tower", objects=2), "2 objects will not do: a tower of height 3 needs 3;"),
        (lambda: drawn("boxes", objects=1), "1 object will not do: each thing .*; valid: 2 or more"),
        (lambda: drawn("exchange", objects=3), "3 objects will not do: two change places .*; valid: 4"),
        (lambda: drawn("tower", state="floats"), "no state of a pair 'floats'"),
        (lambda: drawn("tower", state="beside"), "to the state beside-100, so no task .*; valid: rests"),
        (lambda: drawn("unstack", objects=4), "4 objects will not do: .* apart onto 2 others; valid: 5"),
        (lambda: drawn("like"), "needs one in which an object bears another"),
        (lambda: without_relations(), "has learned no relations, which the task 'tower' is made of; valid"),
    ],
)
def test_tasks_that_cannot_be_are_refused_in_one_sentence(call, said):
    with pytest.raises((InvalidValue, UnknownChoice), match=said):
        call()


def without_relations():
    learned = msgspec.structs.replace(grounding(), relations=None)
    return draw_any_task(WORLD, categorise, learned, "tower", name="drawn", objects=3, seed=0)
