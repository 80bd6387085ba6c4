"""The command line: what it writes and says, what it names as the next step, and what it need not load."""

import json
import re
import subprocess
import sys
from pathlib import Path

import pytest
from command_line import neurosym
from conftest import RUN_TOY
from places import ROOT
from toy_domain import problem

from neurosym.commands.catalogue import SUMMARIES, command_named, overview
from neurosym.stages.folder import DomainFolder


def test_run_makes_again_what_is_missing_and_what_comes_after(folder, capsys):
    stages = DomainFolder(folder).manifest().stages
    assert (stages["explore"].options["seed"], stages["explore"].options["steps"]) == (3, 1024)
    assert "domain.pddl" in stages["compile-domain"].outputs
    (folder / "grounding.json").unlink()
    assert neurosym("run", folder, *RUN_TOY) == 0
    said = capsys.readouterr().out
    assert "distill: up to date" in said
    assert "compile-domain: done" in said
    assert said[said.rindex("\nverdict: ") :].splitlines()[-1].startswith("next: ")


def test_goal_set_by_hand_is_planned_and_reached(folder, capsys):
    scene, plan = folder / "problems/mine.scene.json", folder / "plans/mine.fast-downward.plan"
    strip, gif = folder / "mine.png", folder / "mine.gif"
    pictures = ("--strip", strip, "--gif", gif)
    for seed in range(12):  # some objects do not budge; the first that does will do
        mine = ("new-problem", folder, "--name", "mine", "--seed", seed, "--goal")
        assert neurosym(*mine, "item-01=0.7,0") == 0
        x, y, _ = json.loads(scene.read_text())["objects"][0]["position"]
        neurosym(*mine, f"item-01={x},{y + (0.08 if y < 0 else -0.08)}")
        if neurosym("plan", folder, "mine") == 0:
            capsys.readouterr()
            if neurosym("execute", folder, "mine", plan, *pictures) == 0:
                break
    assert "goal reached" in capsys.readouterr().out
    assert strip.read_bytes().startswith(b"\x89PNG")
    assert gif.read_bytes().startswith(b"GIF")
    record = folder / "runs/mine.fast-downward.run.json"
    assert json.loads(record.read_text())["reached"]
    assert neurosym("execute", folder, "mine", plan, "--disturb", "3") in (0, 3)
    assert "was nudged by" in capsys.readouterr().out
    assert neurosym("replay", folder, record) == 0
    assert "byte for byte" in capsys.readouterr().out
    record.write_text(record.read_text().replace('"touched": []', '"touched": ["item-01"]'))
    assert neurosym("replay", folder, record) == 3
    assert "something else happened" in capsys.readouterr().out


def test_new_problem_takes_the_first_free_name_and_what_it_replaces_is_told(folder, capsys):
    before = (folder / "problems/task-01.scene.json").read_bytes()
    for name in ("task-03", "task-04"):
        assert neurosym("new-problem", folder) == 0
        assert f"wrote {folder}/problems/{name}.pddl" in capsys.readouterr().out
    assert (folder / "problems/task-01.scene.json").read_bytes() == before
    assert neurosym("new-problem", folder, "--name", "task-01", "--seed", 8) == 0
    assert f"replaced {folder}/problems/task-01.pddl" in capsys.readouterr().out


def init(folder: Path, capsys) -> str:
    """Give a folder its world, and return what is to be typed next."""
    (folder / "world.toml").unlink(missing_ok=True)
    capsys.readouterr()
    assert neurosym("init", folder, "--world", "toy") == 0
    return capsys.readouterr().out.splitlines()[-1]


def test_next_step_is_what_follows_what_is_there(folder, capsys):
    assert init(folder, capsys) == f"next: neurosym distill {folder}"
    (folder / "effect_model.safetensors").unlink()
    assert init(folder, capsys) == f"next: neurosym train {folder}"
    (folder / "interactions.npz").unlink()
    assert init(folder, capsys) == f"next: neurosym explore {folder}"


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
