"""Lines and tables fit the terminal and break no name; long work says now and then how far it has come."""

import re
import sys
from dataclasses import replace

import pytest
from command_line import neurosym

from neurosym.commands.catalogue import SUMMARIES
from neurosym.planners.registry import PLANNERS
from neurosym.stages import console

OPERATOR = "carry-to-100-solid-low-narrow-01 item-01"


@pytest.fixture
def columns(monkeypatch):
    """Say how wide the terminal is."""

    def be(wide: int) -> None:
        monkeypatch.setattr(sys.stdout, "isatty", lambda: True)
        monkeypatch.setenv("COLUMNS", str(wide))

    return be


@pytest.mark.parametrize(("wide", "lines"), [(120, 3), (80, 4), (60, 3)])
def test_table_breaks_no_name_and_no_vector(columns, capsys, wide, lines):
    columns(wide)
    headings = ["", "step", "promised [mm]", "happened [mm]", "as promised"]
    row = ["1", OPERATOR, "resting (11, 13, 0)", "resting (-62, 10, 0)", "no"]
    console.show_table("run", headings, [row])
    title, *said = capsys.readouterr().out.splitlines()
    assert title == "run"
    assert max(map(len, said)) <= wide
    whole = " ".join(said)
    for word in (*OPERATOR.split(), "(11, 13, 0)", "(-62, 10, 0)"):
        assert word in whole
    assert ("promised [mm]: resting (11, 13, 0); happened" in re.sub(r"\s+", " ", whole)) == (wide == 60)
    assert len(said) == lines


def test_line_is_folded_between_words_and_what_is_to_be_copied_is_not(columns, capsys):
    columns(40)
    console.say(f"  ({OPERATOR})")
    console.say_next("neurosym execute a-domain a-problem a-domain/plans/a-plan.plan")
    assert capsys.readouterr().out == (
        "  (carry-to-100-solid-low-narrow-01\n  item-01)\n"
        "next: neurosym execute a-domain a-problem a-domain/plans/a-plan.plan\n"
    )


@pytest.mark.parametrize("command", ["", *SUMMARIES])
def test_help_has_at_most_80_columns(capsys, monkeypatch, command):
    for wide in ("80", "200"):
        monkeypatch.setenv("COLUMNS", wide)
        neurosym(*[command][: len(command)], "--help")
        said = capsys.readouterr().out
        assert max(map(len, said.splitlines())) <= 80
        first = SUMMARIES.get(command, "A robot plays with objects out of curiosity;")
        assert first in " ".join(said.split())


@pytest.mark.parametrize("is_there", [True, False])
def test_planners_fit_a_screen_whatever_is_installed(columns, capsys, monkeypatch, is_there):
    columns(80)
    for name, one in PLANNERS.items():
        told = "" if is_there else one.missing() or f"`pip install a-planner-{name[:2]}` brings it"
        monkeypatch.setitem(PLANNERS, name, replace(one, missing=lambda told=told: told))
    assert neurosym("planners") == 0
    lines = capsys.readouterr().out.splitlines()
    assert len(lines) <= 40
    assert max(map(len, lines)) <= 80
    assert {name for name in PLANNERS if any(line.startswith(f"{name} ") for line in lines)} == {*PLANNERS}


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


def test_what_was_done_before_does_not_hasten_what_is_left(now, capsys):
    with console.progress_bar("digging") as advance:
        advance(50, 100)
        now[0] += 60.0
        advance(60, 100)
    assert capsys.readouterr().err == "digging: 60 of 100 after 1:00 min, about 4:00 min left\n"


@pytest.mark.parametrize(("seconds", "quiet"), [(4.0, False), (600.0, True)])
def test_short_work_and_quiet_commands_say_nothing(now, capsys, seconds, quiet):
    console.be_quiet(quiet)
    try:
        work(now, seconds)
    finally:
        console.be_quiet(False)
    assert capsys.readouterr().err == ""


def test_what_works_elsewhere_hands_its_lines_to_who_shows_them(now, capsys, monkeypatch):
    monkeypatch.setattr(console, "_Output", type("Elsewhere", (console._Output,), {}))
    handed: list[str] = []
    console.show_elsewhere(handed.append)
    work(now, 600.0)
    console.say("done")
    assert capsys.readouterr() == ("", "")
    monkeypatch.undo()
    with console.shown_doing(always=True) as show:
        for line in handed:
            show(line)
    assert capsys.readouterr().err.splitlines() == handed
    assert len(handed) == 10
    assert handed[0] == "digging: 10 of 100 after 1:00 min, about 9:00 min left"
