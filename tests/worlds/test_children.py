"""A process that does not come up is told of in one sentence, and nothing that it printed."""

import os
import signal
import subprocess
from pathlib import Path

import pytest

from neurosym.errors import CannotStart
from neurosym.worlds.processes import Child


@pytest.mark.parametrize(
    ("deed", "said"),
    [
        (
            "raise ImportError('libtorch_cpu.so: failed to map segment from shared object')",
            "ImportError: libtorch_cpu.so: failed to map segment from shared object",
        ),
        ("import os\nos.kill(os.getpid(), 9)", "killed by SIGKILL"),
    ],
)
def test_a_process_that_does_not_come_up_is_told_of(
    deed: str, said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capfd: pytest.CaptureFixture[str]
):
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


def test_ctrl_c_while_a_process_is_started_is_heard(monkeypatch: pytest.MonkeyPatch):
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


def test_no_descriptor_is_left():
    before = descriptors()
    child = Child()
    child.close()
    assert descriptors() == before


def descriptors() -> int:
    return len(list(Path("/proc/self/fd").iterdir()))
