"""Where there is no terminal, long work says in a line now and then how far it has come."""

import pytest

from neurosym.stages import console


@pytest.fixture
def now(monkeypatch) -> list[float]:
    """A clock that the test moves [s]."""
    time = [0.0]
    monkeypatch.setattr(console, "monotonic", lambda: time[0])
    return time


def work(now, seconds: float, parts: int = 100) -> None:
    with console.progress_bar("digging") as advance:
        for done in range(1, parts + 1):
            now[0] += seconds / parts
            advance(done, parts)


def test_a_line_for_each_tenth_says_what_is_left(now, capsys):
    work(now, 600.0)
    lines = capsys.readouterr().err.splitlines()
    assert len(lines) == 10
    assert lines[0] == "digging: 10 of 100 after 1:00 min, about 9:00 min left"
    assert lines[-1] == "digging: 100 of 100 after 10:00 min"


@pytest.mark.parametrize(("seconds", "quiet"), [(4.0, False), (600.0, True)])
def test_short_work_and_quiet_commands_say_nothing(now, capsys, seconds, quiet):
    console.be_quiet(quiet)
    try:
        work(now, seconds)
    finally:
        console.be_quiet(False)
    assert capsys.readouterr().err == ""
