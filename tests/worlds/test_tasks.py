"""Tasks that people bring: starts and goals on the table and apart, and as they are called."""

import math

import numpy as np
import pytest
from places import SHIPPED

from neurosym.errors import InvalidValue
from neurosym.learning.network import EffectModel
from neurosym.problems import Problem
from neurosym.sim.tabletop import Tabletop
from neurosym.tasks.task import footprints_apart, overlapping
from neurosym.world import Table
from neurosym.worlds.task_drawing import AWAY, CROWDED, ROW_GAP, draw_places, draw_task

WORLD = Tabletop()
CATEGORISE = EffectModel.load(SHIPPED / "effect_model.safetensors").object_symbols


def drawn(kind, objects, seed, **options) -> Problem:
    return draw_task(WORLD, CATEGORISE, kind, name="drawn", objects=objects, seed=seed, **options)


def starts_and_goals(problem: Problem) -> tuple[np.ndarray, np.ndarray]:
    return problem.scene().positions[:, :2], problem.goal_positions()[:, :2]


@pytest.mark.parametrize(
    ("kind", "objects"),
    [("anywhere", 1), ("anywhere", 2), ("anywhere", 4), ("swap", 3), ("row", 4), ("crowded", 4)],
)
def test_starts_and_goals_are_on_the_table_and_apart(kind, objects):
    low, high = np.array([WORLD.table.x, WORLD.table.y]).T
    for seed in range(5):
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


@pytest.mark.parametrize("kind", ["anywhere", "crowded"])
def test_goals_are_far_away_and_free_of_what_is_moved_later(kind):
    for seed in range(5):
        task = drawn(kind, 4, seed)
        starts, ends = starts_and_goals(task)
        apart = footprints_apart(task)
        for row in range(4):
            assert math.dist(starts[row], ends[row]) >= AWAY
            later = np.arange(4) > row
            assert not overlapping(ends[row], starts[later], apart[row, later]).any()


def test_swaps_rows_and_crowds_are_what_they_are_called():
    for objects in (2, 3):
        starts, goals = starts_and_goals(drawn("swap", objects, 0))
        np.testing.assert_array_equal(goals, np.roll(starts, -1, axis=0))
    row = drawn("row", 4, 0)
    _, goals = starts_and_goals(row)
    assert set(goals[:, 0].tolist()) == {sum(WORLD.table.x) / 2}
    widths = np.array([item.features[1] for item in row.objects])
    np.testing.assert_allclose(np.diff(goals[:, 1]), (widths[1:] + widths[:-1]) / 2 + ROW_GAP)
    crowd = drawn("crowded", 4, 0)
    starts, _ = starts_and_goals(crowd)
    apart = footprints_apart(crowd)
    for number in range(1, 4):
        assert overlapping(starts[number], starts[:number], apart[number, :number] + CROWDED).any()


def test_places_do_not_depend_on_the_tolerance():
    wide, narrow = drawn("anywhere", 2, 7), drawn("anywhere", 2, 7, tolerance=0.02)
    assert (narrow.tolerance, narrow.goals, narrow.objects) == (0.02, wide.goals, wide.objects)


def test_only_objects_that_fit_are_drawn():
    def is_low(features):
        return bool(features[2] < 0.06)

    task = drawn("anywhere", 2, 0, fits=is_low)
    assert all(item.features[2] < 0.06 for item in task.objects)
    assert any(item.features[2] >= 0.06 for seed in range(9) for item in drawn("anywhere", 2, seed).objects)


def test_starts_reach_the_edges_of_the_table():
    spots = np.array([drawn("anywhere", 1, seed).objects[0].position[:2] for seed in range(60)])
    low, high = np.array([WORLD.table.x, WORLD.table.y]).T
    assert np.any(np.minimum(spots - low, high - spots) < 0.1)


def test_objects_without_room_are_told():
    table, rng = Table((0.0, 1.0), (0.0, 1.0)), np.random.default_rng(0)
    assert draw_places(rng, np.full((2, 2), 0.8), table) is None
    assert draw_places(rng, np.full((1, 2), 0.95), table, np.array([[0.5, 0.5]])) is None, "nowhere is far"


@pytest.mark.parametrize(
    ("kind", "objects", "said"),
    [
        ("row", 9, "9 objects find no places on the table for the task 'row'; ask for fewer"),
        ("swap", 1, "One object has no other to change places with"),
        ("crowded", 1, "One object is no crowd"),
        ("anywhere", 0, "objects = 0 must be at least 1"),
    ],
)
def test_tasks_that_cannot_be_are_refused_in_one_sentence(kind, objects, said, monkeypatch):
    monkeypatch.setattr("neurosym.worlds.task_drawing._DRAWS", 3)
    with pytest.raises(InvalidValue, match=said):
        drawn(kind, objects, 0)
