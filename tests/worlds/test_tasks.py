"""Problems and tasks drawn from a world or set by hand: starts and goals on the table, apart, as called."""

import math

import msgspec
import numpy as np
import pytest
from places import SHIPPED
from toy_domain import WORLD as TOY
from toy_learning import Changed
from toy_relations import KINDS, LIE, REST, WORLD, grounding

from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.execution.executor import execute
from neurosym.learning.network import EffectModel
from neurosym.planners import PlanStatus, plan
from neurosym.problems import Problem
from neurosym.sim.tabletop import Tabletop
from neurosym.stages.problem_making import draw_any_task
from neurosym.tasks.supports import bearers_of
from neurosym.tasks.task import footprints_apart, overlapping, unmet_relations
from neurosym.world import Table
from neurosym.worlds import task_drawing
from neurosym.worlds.relation_tasks import draw_relation_task
from neurosym.worlds.toy_relations import ToyRelations


def categorise(features: np.ndarray) -> tuple[str, ...]:
    return tuple("10" if row[3] >= 0.5 else "00" for row in features)


def draw(seed: int, objects: int = 1):
    return task_drawing.draw_problem(TOY, categorise, name="task", objects=objects, seed=seed)


@pytest.mark.parametrize("objects", [1, 2])
def test_no_drawn_problem_is_met_at_its_start_and_every_goal_is_on_the_table(objects):
    problems = [draw(seed, objects) for seed in range(30)]
    assert draw(3, objects) == problems[3] != problems[4]
    for problem in problems:
        assert tuple(item.category for item in problem.objects) == categorise(problem.scene().features)
        assert not problem.is_met(problem.scene().positions)
        assert set(problem.goals) == set(problem.object_names)
        assert all(TOY.table.contains(np.array(goal)) for goal in problem.goals.values())
    heights = [goal[2] for problem in problems for goal in problem.goals.values()]
    assert max(heights) > 0.2 > 0.1 > min(heights), "some goals are in mid-air"


def test_several_actions_each_begin_at_rest_and_nothing_that_moves_is_reported():
    stuck = Changed(lambda _, action: 0 * action)
    with pytest.raises(InvalidValue, match="None of 1000 random actions"):
        task_drawing.draw_problem(stuck, categorise, name="task", objects=1, seed=0)
    problem = task_drawing.draw_problem(TOY, categorise, name="task", objects=3, actions=4, seed=5)
    assert problem.provenance.startswith("drawn with seed 5: 4 random actions on item-0")
    aloft = [
        name for name, goal in problem.goals.items() if goal[2] > problem.object_named(name).position[2] + 0.1
    ]
    assert len(aloft) <= 1
    assert all(TOY.table.contains(goal) for goal in map(np.array, problem.goals.values()))


def test_goal_set_by_hand_rests_on_the_table_unless_it_says_otherwise():
    problem = task_drawing.set_problem(
        TOY, categorise, {"item-01": (0.7, 0.1), "item-02": (0.6, 0.0, 0.2)}, name="t", objects=2, seed=0
    )
    assert problem.goals["item-01"] == (0.7, 0.1, problem.objects[0].position[2])
    assert problem.goals["item-02"] == (0.6, 0.0, 0.2)


@pytest.mark.parametrize(
    ("goals", "message"),
    [
        ({"item-01": (2.0, 0.0)}, "x = 2 m, out of reach; valid: x 0.4 to 1"),
        ({"item-09": (0.7, 0.0)}, "item-09, which is not in the scene"),
        ({}, "no goal"),
    ],
)
def test_impossible_goals_are_refused_in_one_sentence(goals, message):
    with pytest.raises(InvalidValue, match=message):
        task_drawing.set_problem(TOY, categorise, goals, name="t", objects=1, seed=0)


TABLETOP = Tabletop()
CATEGORISE = EffectModel.load(SHIPPED / "effect_model.safetensors").object_symbols


def drawn(kind, objects, seed, **options) -> Problem:
    return task_drawing.draw_task(
        TABLETOP, CATEGORISE, kind, name="drawn", objects=objects, seed=seed, **options
    )


def starts_and_goals(problem: Problem) -> tuple[np.ndarray, np.ndarray]:
    return problem.scene().positions[:, :2], problem.goal_positions()[:, :2]


@pytest.mark.parametrize(
    ("kind", "objects"), [("anywhere", 1), ("anywhere", 4), ("swap", 3), ("row", 4), ("crowded", 4)]
)
def test_starts_and_goals_are_on_the_table_and_apart(kind, objects):
    low, high = np.array([TABLETOP.table.x, TABLETOP.table.y]).T
    for seed in range(3):
        task = drawn(kind, objects, seed)
        assert task == drawn(kind, objects, seed) != drawn(kind, objects, seed + 100)
        assert list(task.goals) == list(task.object_names)
        sizes = np.array([item.features[:2] for item in task.objects])
        apart = (sizes[:, None] + sizes) / 2
        for spots in starts_and_goals(task):
            assert np.all(spots - sizes / 2 >= low)
            assert np.all(spots + sizes / 2 <= high)
            for row in range(objects):
                others = np.arange(objects) != row
                assert not overlapping(spots[row], spots[others], apart[row, others]).any()
        np.testing.assert_array_equal(task.scene().positions[:, 2], task.goal_positions()[:, 2])
        starts, ends = starts_and_goals(task)
        for row in range(objects if kind in ("anywhere", "crowded") else 0):
            assert math.dist(starts[row], ends[row]) >= task_drawing.AWAY
            later = np.arange(objects) > row
            assert not overlapping(ends[row], starts[later], footprints_apart(task)[row, later]).any()


def test_what_fits_is_as_asked_and_starts_reach_the_edges_of_the_table():
    low = drawn("anywhere", 2, 0, fits=lambda features: bool(features[2] < 0.06))
    assert all(item.features[2] < 0.06 for item in low.objects)
    many = [drawn("anywhere", 1, seed).objects[0] for seed in range(40)]
    assert any(item.features[2] >= 0.06 for item in many)
    spots, (low, high) = (
        np.array([item.position[:2] for item in many]),
        np.array([TABLETOP.table.x, TABLETOP.table.y]).T,
    )
    assert np.any(np.minimum(spots - low, high - spots) < 0.1)
    table, rng = Table((0.0, 1.0), (0.0, 1.0)), np.random.default_rng(0)
    for sizes, starts in ((np.full((2, 2), 0.8), None), (np.full((1, 2), 0.95), np.array([[0.5, 0.5]]))):
        with pytest.raises(task_drawing.NoRoom):  # for both; anywhere far enough
            task_drawing.draw_places(rng, sizes, table, starts)


def test_swaps_rows_and_crowds_are_what_they_are_called():
    for objects in (2, 3):
        starts, goals = starts_and_goals(drawn("swap", objects, 0))
        np.testing.assert_array_equal(goals, np.roll(starts, -1, axis=0))
    row = drawn("row", 4, 0)
    _, goals = starts_and_goals(row)
    assert set(goals[:, 0].tolist()) == {sum(TABLETOP.table.x) / 2}
    widths = np.array([item.features[1] for item in row.objects])
    np.testing.assert_allclose(np.diff(goals[:, 1]), (widths[1:] + widths[:-1]) / 2 + task_drawing.ROW_GAP)
    crowd = drawn("crowded", 4, 0)
    starts, _ = starts_and_goals(crowd)
    apart = footprints_apart(crowd)
    for number in range(1, 4):
        assert overlapping(
            starts[number], starts[:number], apart[number, :number] + task_drawing.CROWDED
        ).any()


@pytest.mark.parametrize(
    ("kind", "objects", "said"),
    [
        ("row", 9, "9 objects find no places on the table for the task 'row'; ask for fewer"),
        ("swap", 1, "One object has no other to change places with"),
        ("crowded", 1, "One object is no crowd"),
    ],
)
def test_tasks_that_cannot_be_are_refused_in_one_sentence(kind, objects, said, monkeypatch):
    monkeypatch.setattr("neurosym.worlds.task_drawing._DRAWS", 3)
    with pytest.raises(InvalidValue, match=said):
        drawn(kind, objects, 0)


# Tasks of relations ask for what was learned, can be solved, and are the same for the same seed

FEATURES = [features for _, features in KINDS.values()]


class Known(ToyRelations):
    """The toy world, with objects of the kinds that the domain was written for."""

    def sample_scene(self, rng: np.random.Generator, objects: int):
        """Draw a scene of cubes, blocks and trays."""
        kinds = np.array(FEATURES)[rng.integers(len(FEATURES), size=objects)]
        drawn = self._sample_places(rng, kinds[:, :2])
        upright = np.tile([0.0, 0.0, 0.0, 1.0], (objects, 1))
        return type(super().sample_scene(rng, 1))(kinds, np.column_stack([drawn, kinds[:, 2] / 2]), upright)


def kind_of(features):
    return tuple(next(symbol for symbol, known in KINDS.values() if tuple(row) == known) for row in features)


def related(kind: str, objects: int = 6, seed: int = 0, **options) -> Problem:
    world = Known(WORLD.config)
    return draw_any_task(
        world, kind_of, grounding(), kind, name="drawn", objects=objects, seed=seed, **options
    )


@pytest.mark.parametrize("kind", ["tower", "boxes", "unstack", "exchange"])
def test_tasks_are_solved_and_reached_in_the_world(kind):
    problem, learned = related(kind, seed=1), grounding()
    assert problem == related(kind, seed=1) != related(kind, seed=2)
    assert len(bearers_of(problem, learned.relations)) == (2 if kind in ("unstack", "exchange") else 0)
    assert unmet_relations(problem, learned)
    result = plan(problem, learned)
    assert result.status is PlanStatus.SOLVED, result.reason
    assert execute(WORLD, problem, learned, result.steps, replanner=plan).reached


def test_towers_are_as_high_as_asked_boxes_hold_several_and_stacks_stand_at_the_start():
    assert len(related("tower", height=4).relations) == 3
    assert {state for *_, state in related("boxes").relations} == {LIE}
    assert {state for *_, state in related("boxes", state=REST).relations} == {REST}
    assert len({reference for _, reference, _ in related("boxes", objects=8).relations}) == 4
    stacks = related("unstack", objects=8)
    assert max(item.position[2] for item in stacks.objects) > 0.1
    assert stacks.touching


@pytest.mark.parametrize(
    ("call", "said"),
    [
        (lambda: related("tower", objects=2), "2 objects will not do for the task 'tower'; valid: 3 or"),
        (lambda: related("boxes", objects=1), "1 object will not do for the task 'boxes'; valid: 2 or more"),
        (lambda: related("exchange", objects=3), "3 objects will not do for the task 'exchange'; valid: 4"),
        (lambda: related("tower", state="floats"), "no state of a pair 'floats'"),
        (lambda: related("tower", state="beside"), "to the state beside-100, so no task .*; valid: rests"),
        (lambda: related("unstack", objects=4), "4 objects will not do for the task 'unstack'; valid: 5"),
        (lambda: without_relations(), "has learned no relations, which the task 'tower' is made of; valid"),
    ],
)
def test_tasks_of_relations_that_cannot_be_are_refused_in_one_sentence(call, said):
    with pytest.raises((InvalidValue, UnknownChoice), match=said):
        call()


def without_relations():
    learned = msgspec.structs.replace(grounding(), relations=None)
    return draw_any_task(WORLD, kind_of, learned, "tower", name="drawn", objects=3, seed=0)


def test_a_task_that_no_draw_has_is_refused():
    world, known = Known(WORLD.config), grounding().relations
    with pytest.raises(InvalidValue, match=r"None of .* draws of 3 objects has a task 'tower' that"):
        draw_relation_task(world, kind_of, known, lambda _: {}, "tower", name="drawn", objects=3, seed=0)
