"""What says which this is, what there is, or what was typed wrong, loads nothing that it does not need."""

import re
import subprocess
import sys

import pytest
from command_line import neurosym
from places import ROOT

from neurosym.commands.arguments import read_arguments
from neurosym.commands.catalogue import GROUPS, SUMMARIES, command_named, overview

HEAVY = {
    *("numpy", "scipy", "torch", "pybullet", "unified_planning", "safetensors", "jaxtyping"),
    *("neurosym.planners", "neurosym.pddl", "neurosym.sim", "neurosym.grounding"),
}
HEAVIER = {*HEAVY, "tyro", "rich", "msgspec", "asyncio", "importlib.metadata"}


def loaded(*typed: str) -> set[str]:
    """Modules that are loaded when a command line has ended."""
    code = (
        "import sys\nfrom neurosym.commands.cli import main\ntry:\n    main()\n"
        "except SystemExit:\n    print('loaded:', *sys.modules)"
    )
    ended = subprocess.run([sys.executable, "-c", code, *typed], capture_output=True, text=True, cwd=ROOT)
    assert "Traceback" not in ended.stderr
    return set(re.search(r"loaded: (.*)", ended.stdout)[1].split())


@pytest.mark.parametrize("typed", [("--version",), ("--help",), ("-h", "plan")])
def test_version_and_help_load_next_to_nothing(typed):
    assert not loaded(*typed) & HEAVIER


@pytest.mark.parametrize(
    "typed",
    [
        (),
        ("--foo",),
        ("plann",),
        *((name, "--nonsense") for name in SUMMARIES),
        ("plan", "somewhere"),
        ("plan", "somewhere", "task", "--time-limit", "soon"),
        ("explore", "somewhere", "--strategy", "luck"),
    ],
    ids=" ".join,
)
def test_what_cannot_be_read_is_refused_without_what_it_is_about(typed):
    assert not loaded(*typed) & HEAVY


def test_what_is_needed_is_seen_where_it_is_loaded():
    assert loaded("planners") >= {"neurosym.planners", "msgspec", "tyro", "numpy"}


@pytest.mark.parametrize("name", SUMMARIES)
def test_each_command_is_told_in_its_own_first_sentence(name):
    assert (command_named(name).__doc__ or "").partition("\n")[0] == SUMMARIES[name]


def test_help_lists_the_commands_as_wide_as_the_terminal_is(capsys):
    assert neurosym("--help") == 0
    assert capsys.readouterr().out.rstrip("\n") == overview(160)
    lines = overview(80).splitlines()
    assert max(map(len, lines)) <= 80
    assert [line.split()[0] for line in lines if re.match(r"  \w", line)] == list(SUMMARIES)
    assert lines[0] == "usage: neurosym COMMAND ..."
    assert list(SUMMARIES)[:6] == ["demo", "run", "plan", "execute", "studio", "report"]
    assert [line for line in lines if line.endswith(":") and " " not in line[:1]][-5:] == [
        f"{title}:" for title in GROUPS
    ]


def test_help_is_printed_also_where_a_command_is_to_be_quiet(capsys):
    assert neurosym("--quiet", "--help") == 0
    assert "To begin:" in capsys.readouterr().out


def test_one_command_is_read_as_among_all(capsys):
    with pytest.raises(SystemExit):
        read_arguments(["plan", "--help"])
    said = capsys.readouterr().out
    assert said.startswith("usage: neurosym plan [-h] [OPTIONS] DIR PROBLEM")
    assert "--output FILE" in said
