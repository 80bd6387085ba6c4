"""Tasks with goals anywhere: far from where things stand, on the table, and not in each other."""

import math

import numpy as np

from neurosym.pddl.validation import footprints_apart, overlapping
from neurosym.stages.folder import DomainFolder
from tools.benchmarks.planning.anywhere import AWAY, SHIPPED, draw_anywhere
from tools.benchmarks.planning.measures import Bench


def test_goals_are_far_away_on_the_table_and_apart():
    bench = Bench(DomainFolder(SHIPPED))
    for seed in range(10):
        task = draw_anywhere(bench, 3, seed)
        assert task == draw_anywhere(bench, 3, seed)
        assert list(task.goals) == list(task.object_names)
        ends = np.array([task.goals[name][:2] for name in task.object_names])
        for row, item in enumerate(task.objects):
            goal = task.goals[item.name]
            assert math.dist(goal[:2], item.position[:2]) >= AWAY
            assert bench.setting.world.table.contains(np.array(goal))
            others = np.delete(np.arange(3), row)
            apart = footprints_apart(task)[row, others]
            assert not overlapping(ends[row], ends[others], apart).any()
