"""Workers perform tasks in order; whatever keeps one from starting or working is told in one sentence."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
from places import ROOT
from worker_tasks import Deadly, is_up, refused, some_tasks, unreadable

from neurosym.errors import CannotStart, InvalidFile, InvalidValue
from neurosym.worlds.processes import Child
from neurosym.worlds.toy import make_world
from neurosym.worlds.workers import Task, WorkerDied, kept_workers, perform_all, worker_pool


def test_two_workers_give_the_outcomes_of_one_in_order():
    one, two = (
        [outcome.effect for outcome in perform_all(make_world, some_tasks(30), workers)] for workers in (1, 2)
    )
    np.testing.assert_array_equal(one, two)
    assert np.any(np.array(one) != 0)


def test_workers_are_kept_for_later_work_and_then_end():
    def worker() -> int:
        with worker_pool(1) as submit:
            return submit(is_up).result()

    with kept_workers():
        kept = worker()
        with kept_workers():
            assert worker() == kept
        assert worker() == kept
    assert not is_there(kept)
    assert worker() != kept


def test_a_worker_that_dies_ends_the_run_with_a_sentence_and_an_error_reaches_the_caller():
    with pytest.raises(WorkerDied, match="start the command again"):
        list(perform_all(Deadly, some_tasks(5), 2))
    with pytest.raises(InvalidValue, match="workers = 257 must be at least 1 and at most 256"):
        list(perform_all(make_world, some_tasks(1), 257))
    task = next(some_tasks(1))
    with pytest.raises(InvalidValue, match="no object 9"):
        list(perform_all(make_world, [Task(task.scene, task.action, target=9)], 2))


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


def test_what_a_worker_cannot_do_first_is_told_by_its_sentence_and_what_it_prints_is_seen(capfd):
    with pytest.raises(InvalidFile, match="not enough memory to read it"), worker_pool(2) as submit:
        submit(refused).result()
    assert capfd.readouterr().err == ""
    with worker_pool(1) as submit:
        assert submit(is_up).result() != os.getpid()
        with pytest.raises(AttributeError, match="local object"):
            submit(unreadable).result()
    assert capfd.readouterr().err == "seen\n"


MAIN = """
from neurosym.worlds.workers import worker_pool

def double(number):
    return 2 * number

def main():
    with worker_pool(2) as submit:
        print(submit(double, 4).result())

"""


@pytest.mark.parametrize(
    ("call", "printed", "said"),
    [
        ('if __name__ == "__main__":\n    main()\n', "8\n", ""),
        ("main()\n", "", "InvalidValue: Workers import the main program; call this under `if __name__"),
    ],
)
def test_workers_know_what_the_main_program_defines(tmp_path: Path, call: str, printed: str, said: str):
    script = tmp_path / "mine.py"
    script.write_text(MAIN + call)
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    done = subprocess.run([sys.executable, script], env=environment, capture_output=True, text=True)
    assert done.stdout == printed
    assert done.stderr == "" if not said else said in done.stderr


@pytest.mark.parametrize(
    ("deed", "said"),
    [
        ("raise ImportError('libtorch.so: failed to map')", "ImportError: libtorch.so: failed to map"),
        ("import os\nos.kill(os.getpid(), 9)", "killed by SIGKILL"),
    ],
)
def test_a_process_that_does_not_come_up_is_told_of(deed: str, said: str, tmp_path: Path, monkeypatch, capfd):
    (tmp_path / "first_deed.py").write_text(deed)
    monkeypatch.syspath_prepend(tmp_path)
    child = Child("first_deed")
    with pytest.raises(CannotStart) as refusal:
        child.ask(int)
    assert str(refusal.value) == (
        f"No process can be started: {said}; allow more processes, files or memory (ulimit -a)."
    )
    child.close()
    assert capfd.readouterr().err == ""


def test_ctrl_c_while_a_process_is_started_is_heard_and_no_descriptor_is_left(monkeypatch):
    before = descriptors()
    Child().close()
    assert descriptors() == before
    real = subprocess.Popen

    def interrupted(*arguments: object, **options: object) -> object:
        os.kill(os.getpid(), signal.SIGINT)
        return real(*arguments, **options)

    monkeypatch.setattr(subprocess, "Popen", interrupted)
    heard = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        with pytest.raises(KeyboardInterrupt):
            Child()
    finally:
        signal.signal(signal.SIGINT, heard)


def descriptors() -> int:
    return len(list(Path("/proc/self/fd").iterdir()))
