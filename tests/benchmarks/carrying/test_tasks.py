"""The tasks that carrying is measured by: they can be done, and are what they are called."""

from functools import cache

import numpy as np
import pytest
from places import SHIPPED

from neurosym.evaluation.comparison_tasks import Bench
from neurosym.pddl.footprints import footprints_apart, overlapping
from neurosym.problems import Problem
from neurosym.stages.folder import DomainFolder
from tools.benchmarks.carrying import tasks
from tools.benchmarks.carrying.evaluate import cells
from tools.benchmarks.planning.anywhere import AWAY


@cache
def bench() -> Bench:
    return Bench(DomainFolder(SHIPPED))


def starts_and_goals(problem: Problem) -> tuple[np.ndarray, np.ndarray]:
    return problem.scene().positions[:, :2], problem.goal_positions()[:, :2]


def hits(problem: Problem, spots: np.ndarray) -> bool:
    apart = footprints_apart(problem)
    return any(
        overlapping(spot, np.delete(spots, row, axis=0), np.delete(apart[row], row, axis=0)).any()
        for row, spot in enumerate(spots)
    )


@pytest.mark.parametrize("draw", [tasks.swap, tasks.row, tasks.crowded])
def test_objects_can_be_grasped_and_nothing_stands_in_another(draw):
    for seed in range(3):
        problem = draw(bench(), seed)
        assert all(tasks.is_graspable(np.array(item.features)) for item in problem.objects)
        for spots in starts_and_goals(problem):
            assert not hits(problem, spots)
        assert draw(bench(), seed) == problem
        assert draw(bench(), seed + 100) != problem


def test_two_swap_four_stand_in_a_row_and_a_crowd_goes_apart():
    starts, goals = starts_and_goals(tasks.swap(bench(), 0))
    np.testing.assert_array_equal(goals, starts[::-1])
    _, goals = starts_and_goals(row := tasks.row(bench(), 0))
    assert len(set(goals[:, 0].tolist())) == 1
    widths = np.array([item.features[1] for item in row.objects])
    np.testing.assert_allclose(np.diff(goals[:, 1]), (widths[1:] + widths[:-1]) / 2 + tasks.ROW_GAP)
    starts, goals = starts_and_goals(crowd := tasks.crowded(bench(), 0))
    apart = footprints_apart(crowd)
    for row_of in range(1, 4):
        assert overlapping(starts[row_of], starts[:row_of], apart[row_of, :row_of] + tasks.CROWDED).any()
    assert np.linalg.norm(goals - starts, axis=1).min() >= AWAY


def test_far_goals_of_graspable_objects_are_drawn_until_all_can_be_grasped():
    problem = tasks.far(bench(), 4, 1, graspable=True, tolerance=0.02)
    assert problem.tolerance == 0.02
    assert all(tasks.is_graspable(np.array(item.features)) for item in problem.objects)
    drawn = [tasks.far(bench(), 4, seed, graspable=False) for seed in range(6)]
    assert not all(tasks.is_graspable(np.array(item.features)) for one in drawn for item in one.objects)


def test_every_cell_of_the_table_draws_tasks():
    for name, draw, count in cells(0.01):
        assert count == 1
        assert draw(bench(), 7).goals, name
