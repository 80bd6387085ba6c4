"""Workers perform tasks in order, and one that fails stops the run with a sentence."""

import numpy as np
import pytest
from worker_tasks import Deadly, some_tasks

from neurosym.errors import InvalidValue
from neurosym.worlds.toy import make_world
from neurosym.worlds.workers import Task, WorkerDied, crew, perform_all


def test_two_workers_give_the_outcomes_of_one_in_order():
    one = [outcome.effect for outcome in perform_all(make_world, some_tasks(30), 1)]
    two = [outcome.effect for outcome in perform_all(make_world, some_tasks(30), 2)]
    np.testing.assert_array_equal(one, two)
    assert np.any(np.array(one) != 0)


def test_a_worker_that_dies_ends_the_run_with_a_sentence():
    with pytest.raises(WorkerDied, match="start the command again"):
        list(perform_all(Deadly, some_tasks(5), 2))


def test_an_error_in_a_worker_reaches_the_caller():
    task = next(some_tasks(1))
    with pytest.raises(InvalidValue, match="no object 9"):
        list(perform_all(make_world, [Task(task.scene, task.action, target=9)], 2))


def test_tasks_are_drawn_only_a_little_ahead():
    drawn = []

    def tasks():
        for task in some_tasks(60):
            drawn.append(task)
            yield task

    with crew(make_world, 2) as perform:
        next(perform(tasks()))
        assert len(drawn) < 20
