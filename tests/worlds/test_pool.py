"""Worker processes: whatever keeps one from starting or working is told in one sentence."""

import errno
import os
import subprocess
import sys
import time
from pathlib import Path

import pytest
from child_deeds import is_up, refused, unreadable
from places import ROOT

from neurosym.errors import InvalidFile, NeurosymError
from neurosym.worlds.toy import make_world
from neurosym.worlds.workers import crew, worker_pool


def test_what_a_worker_cannot_do_first_is_told_by_its_sentence_alone(capfd: pytest.CaptureFixture[str]):
    with (
        pytest.raises(InvalidFile, match="not enough memory to read it"),
        worker_pool(2, refused, ()) as submit,
    ):
        submit(is_up).result()
    assert capfd.readouterr().err == ""


def test_a_second_process_that_cannot_be_started_is_told_and_the_first_ended(
    monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
):
    real, started = subprocess._fork_exec, []  # what starts a process

    def once(*arguments):
        if started:
            raise BlockingIOError(errno.EAGAIN, os.strerror(errno.EAGAIN))
        started.append(real(*arguments))
        return started[0]

    monkeypatch.setattr(subprocess, "_fork_exec", once)
    begin = time.monotonic()
    with (
        pytest.raises(NeurosymError, match="No process can be started: Resource temporarily unavailable"),
        crew(make_world, 2),
    ):
        pass
    assert not Path(f"/proc/{started[0]}").exists()
    assert capfd.readouterr().err == ""
    assert time.monotonic() - begin < 5.0, "it ends by itself, and is not waited for"


def test_what_a_worker_prints_is_seen(capfd: pytest.CaptureFixture[str]):
    with worker_pool(2) as submit:
        assert submit(is_up).result() != os.getpid()
    assert capfd.readouterr().err == "seen\n"


def test_an_answer_that_cannot_be_sent_is_an_error_of_its_work():
    with pytest.raises(AttributeError, match="local object"), worker_pool(1) as submit:
        submit(unreadable).result()


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
