"""A process that does not come up is told of in one sentence, and nothing that it printed."""

import os
import signal
import subprocess
from pathlib import Path

import pytest
from child_deeds import killed, never_up

from neurosym.errors import CannotStart
from neurosym.worlds import host
from neurosym.worlds.children import Child


@pytest.mark.parametrize(
    ("serve", "said"),
    [
        (never_up, "ImportError: libtorch_cpu.so: failed to map segment from shared object"),
        (killed, "killed by SIGKILL"),
    ],
)
def test_a_process_that_does_not_come_up_is_told_of(serve, said: str, capfd: pytest.CaptureFixture[str]):
    child = Child(serve)
    with pytest.raises(CannotStart) as refusal:
        child.send("anything")
    assert str(refusal.value) == (
        f"No process can be started: {said}; allow more processes, files or memory (ulimit -a)."
    )
    child.close()
    assert capfd.readouterr().err == ""


def test_ctrl_c_while_a_process_is_started_is_heard(monkeypatch: pytest.MonkeyPatch):
    real = subprocess.Popen

    def interrupted(*arguments: object, **options: object) -> object:
        os.kill(os.getpid(), signal.SIGINT)
        return real(*arguments, **options)

    monkeypatch.setattr(subprocess, "Popen", interrupted)
    heard = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        with pytest.raises(KeyboardInterrupt):
            Child(host.serve)
    finally:
        signal.signal(signal.SIGINT, heard)


def test_no_descriptor_is_left():
    before = descriptors()
    child = Child(host.serve)
    child.close()
    assert descriptors() == before


def descriptors() -> int:
    return len(list(Path("/proc/self/fd").iterdir()))
