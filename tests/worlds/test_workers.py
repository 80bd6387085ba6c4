"""Workers perform tasks in order, and one that fails stops the run with a sentence."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

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


HANGING = """if True:
    import sys
    sys.path.insert(0, {tests!r})
    from worker_tasks import Hanging, some_tasks
    from neurosym.worlds.workers import perform_all
    if __name__ == "__main__":
        list(perform_all(Hanging, some_tasks(5), 2))
"""


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGKILL])
def test_workers_end_with_their_parent_whatever_they_do(tmp_path: Path, number: signal.Signals):
    script = tmp_path / "hanging.py"
    script.write_text(HANGING.format(tests=str(Path(__file__).parents[1])))
    environment = {**os.environ, "NEUROSYM_TEST_STARTED": str(tmp_path / "started")}
    parent = subprocess.Popen([sys.executable, script], env=environment, stderr=subprocess.DEVNULL)
    end = time.monotonic() + 60
    while len(list(tmp_path.glob("started-*"))) < 2 and time.monotonic() < end:
        time.sleep(0.02)
    workers = [int(path.name.rpartition("-")[2]) for path in tmp_path.glob("started-*")]
    assert len(workers) == 2
    begin = time.monotonic()
    parent.send_signal(number)
    parent.wait(30)
    while any(map(is_there, workers)) and time.monotonic() < begin + 10:
        time.sleep(0.02)
    assert not any(map(is_there, workers))
    assert time.monotonic() - begin < 10


def is_there(process: int) -> bool:
    stat = Path(f"/proc/{process}/stat")
    return stat.exists() and b") Z" not in stat.read_bytes()
