"""Files that are missing, damaged or of another kind are refused; answers are JSON, or go through pipes."""

import io
import json
import shutil
import sys
from pathlib import Path

import pytest
from command_line import contents, neurosym, refusal
from conftest import LEARN_TOY

PLAN = ("task-01",)
MORE = (*LEARN_TOY, "--steps", "2048", "--seed", "3")


@pytest.mark.parametrize(
    ("file", "command", "writer"),
    [
        ("world.toml", ("explore",), "init {}"),
        ("interactions.npz", ("train",), "explore {}"),
        ("effect_model.safetensors", ("distill",), "train {}"),
        ("direct_model.safetensors", ("distill",), "train {}"),
        ("primitives.json", ("compile-domain",), "distill {}"),
        ("grounding.json", ("new-problem",), "compile-domain {}"),
        ("problems/task-01.scene.json", ("plan", *PLAN), "new-problem {} --name task-01"),
    ],
)
def test_missing_file_is_named_with_the_command_that_writes_it(folder, file, command, writer, capsys):
    (folder / file).unlink()
    said = refusal(capsys, command[0], folder, *command[1:])
    assert file.removesuffix(".scene.json").removeprefix("problems/") in said
    assert f"`neurosym {writer.format(folder)}` writes it" in said


@pytest.mark.parametrize(
    ("file", "content", "command"),
    [
        ("world.toml", None, ("explore", *MORE)),
        ("exploration.safetensors", None, ("explore", *MORE)),
        ("interactions.npz", None, ("train",)),
        ("effect_model.safetensors", None, ("distill",)),
        ("direct_model.safetensors", None, ("distill",)),
        ("direct_model.safetensors", "effect_model.safetensors", ("distill",)),
        ("effect_model.safetensors", "direct_model.safetensors", ("distill",)),
        ("direct_model.safetensors", "interactions.npz", ("distill",)),
        ("primitives.json", None, ("compile-domain",)),
        ("manifest.json", None, ("compile-domain",)),
        ("manifest.json", None, ("plan", *PLAN)),
        ("grounding.json", None, ("new-problem",)),
        ("grounding.json", "manifest.json", ("plan", *PLAN)),
        ("problems/task-01.scene.json", "manifest.json", ("plan", *PLAN)),
    ],
)
def test_damaged_file_or_another_is_refused_and_nothing_is_written(folder, file, content, command, capsys):
    (folder / file).write_bytes((folder / content).read_bytes() if content else b"\x00garbage")
    before = contents(folder)
    assert file in refusal(capsys, command[0], folder, *command[1:])
    assert contents(folder) == before


@pytest.mark.parametrize(
    "options", [["--strategy", "random", "--seed", 4], ["--seed", 3, "--strategy", "active"]]
)
def test_finished_interactions_are_not_replaced_where_the_checkpoint_is_gone(folder, options, capsys):
    for name in ("exploration.safetensors", "interactions.partial.npz"):
        (folder / name).unlink(missing_ok=True)
    before = (folder / "interactions.npz").read_bytes()
    said = refusal(capsys, "explore", folder, "--steps", 4096, *options)
    assert f"was explored with {options[-2].removeprefix('--')} = " in said
    assert (folder / "interactions.npz").read_bytes() == before


def test_plan_file_that_is_none_is_refused_and_one_without_a_step_is_noted(kept, tmp_path, capsys):
    for path in (kept / "problems", "/dev/null"):
        assert f"{path} cannot be used: it is no file" in refusal(capsys, "execute", kept, "task-01", path)
    folder, empty = shutil.copytree(kept, tmp_path / "toy"), tmp_path / "empty.plan"
    empty.write_text("; nothing\n")
    assert neurosym("execute", folder, "task-01", empty, "--replans", 0) == 3
    assert f"note: {empty} holds no step" in capsys.readouterr().out


def test_folder_that_is_no_domain_folder_is_called_so(tmp_path, capsys):
    (tmp_path / "empty.plan").write_text("")
    for command, *plan in (("plan",), ("execute", tmp_path / "empty.plan")):
        said = refusal(capsys, command, tmp_path, "task-01", *plan)
        assert f"{tmp_path} is no domain folder, it has neither world.toml nor grounding.json" in said


def test_record_that_is_none_or_of_another_domain_is_refused(folder, capsys):
    record = folder / "mine.run.json"
    assert "no record of a run" in refusal(capsys, "replay", folder, record)
    record.write_text("{}")
    assert f"{record} cannot be used" in refusal(capsys, "replay", folder, record)
    step = {"operator": "fly", "object": "item-01", "promised": None, "promised_effect": None}
    step |= {"happened": "resting", "effect": [0, 0, 0], "deviation": None, "as_promised": False}
    run = {"problem": "task-01", "plan": [], "steps": [step | {"positions": {}}], "reached": False}
    record.write_text(json.dumps(run | {"distances": {}, "reason": ""}))
    assert "no operator 'fly'" in refusal(capsys, "replay", folder, record)


def test_folder_that_is_missing_there_already_or_cannot_be_made_is_refused(folder, tmp_path, capsys):
    assert f"no folder {tmp_path / 'nowhere'}" in refusal(capsys, "explore", tmp_path / "nowhere")
    assert "Not a directory" in refusal(capsys, "init", folder / "world.toml" / "below")
    assert "exists already" in refusal(capsys, "init", folder)


PLAN_FILE = "plans/task-01.fast-downward.plan"


def answered(capsys, *arguments: object) -> object:
    """What a command printed as JSON; it printed nothing else."""
    capsys.readouterr()
    neurosym(*arguments)
    return json.loads(capsys.readouterr().out)


def test_programs_are_told_in_json_what_is_recorded(folder, capsys):
    plan = answered(capsys, "plan", folder, "task-01", "--json")
    recorded = json.loads((folder / PLAN_FILE).with_suffix(".json").read_text())
    assert plan["status"] == "solved"
    assert {**plan, "seconds": 0} == {"file": str(folder / PLAN_FILE), **recorded, "seconds": 0}
    run = answered(capsys, "execute", folder, "task-01", folder / PLAN_FILE, "--json")
    assert run["reached"] in (True, False)
    assert len(run["steps"]) >= 1
    held = answered(capsys, "check", folder, "--json")
    assert (held["interactions"], held["actions"], held["problems"]) == (1024, 12, [])
    assert answered(capsys, "explain", folder, "--json")["actions"]
    names = [one["name"] for one in answered(capsys, "planners", "--json")]
    assert {"bfs", "counting", "fast-downward"} <= {*names}


def test_quiet_commands_print_only_what_goes_wrong(folder, capsys):
    assert neurosym("--quiet", "plan", folder, "task-01") == 0
    assert neurosym("execute", folder, "task-01", folder / PLAN_FILE, "--quiet") in (0, 3)
    assert capsys.readouterr().out == ""
    assert "no problem 'task-99'" in refusal(capsys, "plan", folder, "task-99", "--quiet")
    assert neurosym("planners") == 0
    assert "Planners" in capsys.readouterr().out


def test_plans_go_through_pipes(folder, capsys, monkeypatch):
    assert neurosym("plan", folder, "task-01", "--output", "-") == 0
    text = capsys.readouterr().out
    assert text.strip() == (folder / PLAN_FILE).read_text().strip()
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(text.encode())))
    assert neurosym("execute", folder, "task-01", "-") in (0, 3)
    assert (folder / "runs" / "task-01.stdin.run.json").is_file()
    assert (folder / "plans" / "task-01.stdin.plan").read_text().strip() == text.strip()


@pytest.mark.parametrize("data", [b"rubbish\n", b"\xff\xfe", b"x" * 70_000_000])
def test_what_is_no_plan_is_refused_and_leaves_nothing(kept, capsys, monkeypatch, data):
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(data)))
    assert "standard input" in refusal(capsys, "execute", kept, "task-02", "-").lower()


def test_plan_is_written_where_it_can_be(folder, tmp_path, capsys):
    asked = ("plan", folder, "task-01", "--output")
    assert neurosym(*asked, tmp_path / "a.plan") == 0
    assert (tmp_path / "a.plan").read_text() == (folder / PLAN_FILE).read_text()
    for output, said in (
        (tmp_path / "missing/a.plan", "No plan can be written to"),
        (tmp_path, "No plan can be written to"),
        ("/dev/full", "should be a file"),
        ("/dev/null", "should be a file"),
    ):
        assert said in refusal(capsys, *asked, output)
    assert Path("/dev/null").is_char_device()
    assert "leave one of them out" in refusal(capsys, *asked, "-", "--json")
