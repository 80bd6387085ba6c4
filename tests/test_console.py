"""Where there is no terminal, long work says in a line now and then how far it has come."""

import io
import sys

import pytest

from neurosym.stages import console, terminal


@pytest.fixture
def said(monkeypatch):
    """What is printed about progress, and a clock that the test moves."""
    stream, now = io.StringIO(), [0.0]
    monkeypatch.setattr(terminal, "error_console", terminal.ErrorConsole(file=stream, soft_wrap=True))
    monkeypatch.setattr(terminal, "monotonic", lambda: now[0])
    return stream, now


def work(now, seconds: float, parts: int = 100) -> None:
    with console.progress_bar("digging") as advance:
        for done in range(1, parts + 1):
            now[0] += seconds / parts
            advance(done, parts)


def test_a_line_for_each_tenth_says_what_is_left(said):
    stream, now = said
    work(now, 600.0)
    lines = stream.getvalue().splitlines()
    assert len(lines) == 10
    assert lines[0] == "digging: 10 of 100 after 1:00 min, about 9:00 min left"
    assert lines[-1] == "digging: 100 of 100 after 10:00 min"


@pytest.mark.parametrize(("seconds", "quiet"), [(4.0, False), (600.0, True)])
def test_short_work_and_quiet_commands_say_nothing(said, seconds, quiet):
    stream, now = said
    console.be_quiet(quiet)
    try:
        work(now, seconds)
    finally:
        console.be_quiet(False)
    assert stream.getvalue() == ""


def test_program_is_called_next_as_it_was_now_if_not_found_by_name(monkeypatch, tmp_path, capsys):
    def said_next() -> str:
        console.say_next("neurosym plan 'my neurosym domain' NAME, then neurosym execute NAME")
        return capsys.readouterr().out.strip()

    program = tmp_path / "bin/neurosym"
    program.parent.mkdir()
    program.touch(mode=0o755)
    monkeypatch.setattr(sys, "argv", [str(program)])
    monkeypatch.setenv("PATH", "")
    assert said_next() == f"next: {program} plan 'my neurosym domain' NAME, then {program} execute NAME"
    monkeypatch.setenv("PATH", str(program.parent))
    assert said_next() == "next: neurosym plan 'my neurosym domain' NAME, then neurosym execute NAME"
