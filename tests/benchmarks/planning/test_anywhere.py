"""Tasks anywhere: starts and goals on the table, apart, and far from each other."""

import math

import numpy as np
import pytest
from places import SHIPPED

from neurosym.errors import InvalidValue
from neurosym.pddl.footprints import overlapping
from neurosym.stages.folder import DomainFolder
from neurosym.table import Table
from tools.benchmarks.planning.anywhere import AWAY, draw_anywhere, draw_places
from tools.benchmarks.planning.measures import Bench


@pytest.fixture(scope="module")
def bench():
    return Bench(DomainFolder(SHIPPED))


@pytest.mark.parametrize("objects", [1, 2, 4])
def test_starts_and_goals_are_on_the_table_apart_and_far_away(bench, objects):
    low, high = np.array([bench.setting.world.table.x, bench.setting.world.table.y]).T
    for seed in range(10):
        task = draw_anywhere(bench, objects, seed)
        assert task == draw_anywhere(bench, objects, seed)
        assert list(task.goals) == list(task.object_names)
        sizes = np.array([item.features[:2] for item in task.objects])
        starts, ends = task.scene().positions, task.goal_positions()
        apart = (sizes[:, None] + sizes) / 2
        for spots in (starts[:, :2], ends[:, :2]):
            assert np.all(spots - sizes / 2 >= low)
            assert np.all(spots + sizes / 2 <= high)
            for row in range(objects):
                others = np.arange(objects) != row
                assert not overlapping(spots[row], spots[others], apart[row, others]).any()
        for row in range(objects):
            assert math.dist(starts[row, :2], ends[row, :2]) >= AWAY
            assert starts[row, 2] == ends[row, 2]
            later = np.arange(objects) > row
            assert not overlapping(ends[row, :2], starts[later, :2], apart[row, later]).any()


def test_places_do_not_depend_on_the_tolerance_and_seeds_differ(bench):
    wide, narrow = draw_anywhere(bench, 2, 7), draw_anywhere(bench, 2, 7, 0.02)
    assert (narrow.tolerance, narrow.goals, narrow.objects) == (0.02, wide.goals, wide.objects)
    assert draw_anywhere(bench, 2, 8).goals != wide.goals


def test_starts_reach_the_edges_of_the_table(bench):
    spots = np.array([draw_anywhere(bench, 1, seed).objects[0].position[:2] for seed in range(60)])
    low, high = np.array([bench.setting.world.table.x, bench.setting.world.table.y]).T
    assert np.any(np.minimum(spots - low, high - spots) < 0.1)


def test_objects_without_room_are_told():
    table, rng = Table((0.0, 1.0), (0.0, 1.0)), np.random.default_rng(0)
    assert draw_places(rng, np.full((2, 2), 0.8), table) is None
    assert draw_places(rng, np.full((1, 2), 0.95), table, np.array([[0.5, 0.5]])) is None, "nowhere is far"


def test_too_many_objects_are_refused(bench, monkeypatch):
    monkeypatch.setattr("tools.benchmarks.planning.anywhere.draw_places", lambda *_: None)
    with pytest.raises(InvalidValue, match="2 objects do not find places"):
        draw_anywhere(bench, 2, 0)
