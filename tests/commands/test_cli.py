"""The command line: what it writes, and what it says."""

import json
import re

import pytest
from command_line import neurosym
from conftest import RUN_TOY

from neurosym.errors import InvalidValue
from neurosym.operators import OperatorTable
from neurosym.stages.folder import DomainFolder


def test_run_leaves_every_file_of_the_design(toy_folder):
    for name in (
        *("world.toml", "interactions.npz", "effect_model.safetensors", "direct_model.safetensors"),
        *("training.json", "primitives.json", "domain.pddl", "domain-numeric.pddl", "grounding.json"),
        *("problems/task-01.pddl", "problems/task-02.scene.json", "plans/task-01.fast-downward.json"),
    ):
        assert (toy_folder / name).is_file(), name
    stages = DomainFolder(toy_folder).manifest().stages
    assert (stages["explore"].options["seed"], stages["explore"].options["steps"]) == (3, 1024)
    assert "domain.pddl" in stages["compile-domain"].outputs


def test_second_run_does_nothing_again(folder, capsys):
    before = {path: path.stat().st_mtime_ns for path in folder.rglob("*") if path.is_file()}
    assert neurosym("run", folder, *RUN_TOY) == 0
    said = capsys.readouterr().out
    assert ": done" not in said
    assert said[said.rindex("\nverdict: ") :].splitlines()[-1].startswith("next: ")
    assert {path: path.stat().st_mtime_ns for path in folder.rglob("*") if path.is_file()} == before
    (folder / "grounding.json").unlink()
    assert neurosym("run", folder, *RUN_TOY) == 0
    said = capsys.readouterr().out
    assert "distill: up to date" in said
    assert "compile-domain: done" in said


def test_actions_can_be_chosen_as_the_paper_does(folder):
    before = OperatorTable.load(folder / "primitives.json")
    options = ("--objects", 40, "--seed", 3, "--choice", "lowest-error")
    assert neurosym("distill", folder, *options) == 0
    after = OperatorTable.load(folder / "primitives.json")
    assert tuple(p.label for p in after.primitives) == after.symbols == before.symbols
    least = {one.symbol: one.code_error for one in after.primitives}
    assert all(least[then.symbol] <= then.code_error for then in before.primitives)
    assert after.primitives != before.primitives
    assert DomainFolder(folder).manifest().stages["distill"].options["choice"] == "lowest-error"


def test_bfs_over_the_network_finds_plans_for_drawn_tasks(folder):
    codes = set()
    for seed in range(4):
        assert neurosym("new-problem", folder, "--name", "drawn", "--seed", seed) == 0
        codes.add(neurosym("plan", folder, "drawn", "--planner", "bfs"))
    assert 0 in codes
    assert codes <= {0, 3}


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
    for seed, is_another in ((8, True), (8, False), (9, True)):
        assert neurosym("new-problem", folder, "--name", "task-01", "--seed", seed) == 0
        said = capsys.readouterr().out
        assert f"replaced {folder}/problems/task-01.pddl" in said
        note = "note: made for the former task-01, and stale now: plans/task-01.fast-downward.json"
        assert (note in said) == is_another
    (folder / "task-01.my.plan").touch()
    assert neurosym("execute", folder, "task-03", folder / "task-01.my.plan", "--replans", "0") == 3
    assert "task-01.my.plan seems to be made for task-01, not for task-03" in capsys.readouterr().out


def test_goal_out_of_reach_is_a_result_with_its_reason(folder, capsys):
    assert neurosym("new-problem", folder, "--name", "high", "--goal", "item-01=0.7,0.0,0.39") == 0
    for planner in ("bfs", "fast-downward"):
        assert neurosym("plan", folder, "high", "--planner", planner) == 3
        said = capsys.readouterr().out
        assert "no plan for high" in said
        assert re.search(r"item-01 (cannot reach|was not brought to) its goal", said)
        assert not (folder / f"plans/high.{planner}.plan").exists()


@pytest.mark.parametrize(
    ("raised", "code", "said"),
    [
        (
            KeyboardInterrupt(),
            130,
            "interrupted; the same command goes on from what is written, or begins again",
        ),
        (InvalidValue("seed = -1 must be at least 0."), 2, "seed = -1 must be at least 0."),
        (3, 3, ""),
        (FileNotFoundError(2, "No such file", "a.npz"), 2, "a.npz: No such file"),
    ],
)
def test_how_a_command_ends_decides_the_exit_code(raised, code, said, monkeypatch, capsys):
    def planners() -> int:
        if isinstance(raised, int):
            return raised
        raise raised

    monkeypatch.setattr("neurosym.commands.tasks.planners", planners)
    assert neurosym("planners") == code
    assert capsys.readouterr().err.strip() == said
