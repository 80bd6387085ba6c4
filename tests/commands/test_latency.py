"""What says which this is, what there is, or what was typed wrong, loads nothing that it does not need."""

import re
import subprocess
import sys

import pytest
from command_line import neurosym
from places import ROOT
from toy_domain import problem

from neurosym.commands.catalogue import SUMMARIES, command_named, overview

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


@pytest.mark.parametrize(
    ("typed", "absent"),
    [
        (("--version",), HEAVIER),
        (("-h", "plan"), HEAVIER),
        (("plann",), HEAVY),
        (("studio", "--nonsense"), HEAVY),
        (("plan", "somewhere", "task", "--time-limit", "soon"), HEAVY),
        (("explore", "somewhere", "--strategy", "luck"), HEAVY),
    ],
)
def test_what_needs_no_work_is_answered_without_what_the_work_needs(typed, absent):
    assert not loaded(*typed) & absent


def test_what_is_needed_is_loaded_and_no_more(bare):
    assert loaded("planners") >= {"neurosym.planners", "msgspec", "tyro", "numpy"}
    problem({"item-01": (0.68, 0.08, 0.025)}).save(bare / "easy.json")
    assert neurosym("new-problem", bare, "--scene", bare / "easy.json") == 0
    found = loaded("plan", str(bare), "easy")
    assert (bare / "plans/easy.fast-downward.plan").is_file()
    assert "neurosym.planners.external" in found
    assert not {"torch", "unified_planning", "pybullet"} & found


def test_each_command_is_told_in_its_own_first_sentence():
    told = {name: (command_named(name).__doc__ or "").partition("\n")[0] for name in SUMMARIES}
    assert told == SUMMARIES


def test_help_lists_the_commands_in_order(capsys):
    assert neurosym("--help") == 0
    assert capsys.readouterr().out.rstrip("\n") == overview(80)
    lines = overview(80).splitlines()
    assert max(map(len, lines)) <= 80
    assert [line.split()[0] for line in lines if re.match(r"  \w", line)] == list(SUMMARIES)
    assert lines[0] == "usage: neurosym COMMAND ..."
    assert neurosym("--quiet", "--help") == 0
    assert "To begin:" in capsys.readouterr().out
    assert neurosym("plan", "--help") == 0
    said = capsys.readouterr().out
    assert said.startswith("usage: neurosym plan [-h] [OPTIONS] DIR PROBLEM")
    assert "--output FILE" in said
