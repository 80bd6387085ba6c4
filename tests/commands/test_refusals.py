"""The command line refuses files that are missing, damaged or of another kind, and writes nothing."""

import json

import pytest
from command_line import neurosym, refusal
from conftest import LEARN_TOY

from neurosym.grounding import Grounding, is_lift


def test_missing_folder_is_refused(tmp_path, capsys):
    assert f"no folder {tmp_path / 'nowhere'}" in refusal(capsys, "explore", tmp_path / "nowhere")


@pytest.mark.parametrize(
    ("command", "missing", "writer"),
    [
        ("explore", "world.toml", "init"),
        ("train", "interactions.npz", "explore"),
        ("distill", "effect_model.safetensors", "train"),
        ("distill", "direct_model.safetensors", "train"),
        ("compile-domain", "primitives.json", "distill"),
        ("new-problem", "grounding.json", "compile-domain"),
    ],
)
def test_stage_before_the_one_it_needs_is_refused(folder, command, missing, writer, capsys):
    (folder / missing).unlink()
    said = refusal(capsys, command, folder)
    assert missing in said
    assert f"`neurosym {writer} {folder}` writes it" in said


@pytest.mark.parametrize(
    ("command", "file"),
    [
        ("explore", "world.toml"),
        ("explore", "exploration.safetensors"),
        ("train", "interactions.npz"),
        ("distill", "effect_model.safetensors"),
        ("distill", "direct_model.safetensors"),
        ("compile-domain", "primitives.json"),
        ("compile-domain", "manifest.json"),
        ("new-problem", "grounding.json"),
    ],
)
def test_corrupt_file_is_refused_by_name_and_nothing_is_written(folder, command, file, capsys):
    (folder / file).write_bytes(b"\x00garbage")
    before = {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    options = [*LEARN_TOY, "--steps", 2048, "--seed", 3] if command == "explore" else []
    assert file in refusal(capsys, command, folder, *options)
    assert {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()} == before


@pytest.mark.parametrize(
    "options", [["--strategy", "random", "--seed", 4], ["--seed", 3, "--strategy", "active"]]
)
def test_finished_interactions_are_not_replaced_by_others_where_the_checkpoint_is_gone(
    folder, options, capsys
):
    for name in ("exploration.safetensors", "interactions.partial.npz"):
        (folder / name).unlink(missing_ok=True)
    before = (folder / "interactions.npz").read_bytes()
    said = refusal(capsys, "explore", folder, "--steps", 4096, *options)
    assert f"was explored with {options[-2].removeprefix('--')} = " in said
    assert (folder / "interactions.npz").read_bytes() == before


@pytest.mark.parametrize("file", ["problems/task-01.scene.json", "grounding.json"])
def test_foreign_json_is_refused(folder, file, capsys):
    (folder / file).write_text('{"format": "something-else"}')
    assert file in refusal(capsys, "plan", folder, "task-01")


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("(fly item-01)", "no operator 'fly'"),
        ("(OPERATOR item-09)", "no object 'item-09'; valid: item-01"),
        ("shove it", "has no steps"),
    ],
)
def test_plan_that_cannot_be_read_is_refused_with_its_line(folder, line, message, capsys):
    operator = json.loads((folder / "primitives.json").read_text())["operators"][0]["name"]
    plan = folder / "mine.plan"
    plan.write_text(f"; a comment\n{line.replace('OPERATOR', operator)}\n")
    said = refusal(capsys, "execute", folder, "task-01", plan)
    assert message in said
    assert f"{plan}, line {1 if line == 'shove it' else 2}" in said


@pytest.mark.parametrize(
    ("file", "other"),
    [
        ("direct_model.safetensors", "effect_model.safetensors"),
        ("effect_model.safetensors", "direct_model.safetensors"),
        ("direct_model.safetensors", "interactions.npz"),
    ],
)
def test_one_file_is_not_taken_for_another(folder, file, other, capsys):
    (folder / file).write_bytes((folder / other).read_bytes())
    before = (folder / "primitives.json").read_bytes()
    assert f"{folder / file} cannot be used" in refusal(capsys, "distill", folder)
    assert (folder / "primitives.json").read_bytes() == before


def test_missing_plan_file_is_refused(folder, capsys):
    assert "none.plan" in refusal(capsys, "execute", folder, "task-01", folder / "none.plan")
    for path in (folder / "problems", "/dev/null"):
        assert f"{path} cannot be used: it is no file" in refusal(capsys, "execute", folder, "task-01", path)


def test_plan_without_a_step_is_executed_with_a_note(folder, capsys):
    (folder / "empty.plan").write_text("; nothing\n")
    assert neurosym("execute", folder, "task-01", folder / "empty.plan", "--replans", 0) == 3
    assert f"note: {folder / 'empty.plan'} holds no step" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("file", "command", "remedy"),
    [
        ("grounding.json", "plan", "`neurosym compile-domain {}` writes it anew"),
        ("grounding.json", "new-problem", "`neurosym compile-domain {}` writes it anew"),
        ("world.toml", "new-problem", "`neurosym init {}` writes a new one"),
    ],
)
def test_damaged_file_is_all_that_is_told_and_what_writes_it_anew(folder, file, command, remedy, capsys):
    (folder / file).write_text((folder / file).read_text()[:-30] + "[")
    said = refusal(capsys, command, folder, *(["task-01"] if command == "plan" else []))
    assert remedy.format(folder) in said
    assert neurosym(command, folder, *(["task-01"] if command == "plan" else [])) == 2
    assert capsys.readouterr().out == ""


def test_damaged_manifest_is_refused_before_anything_is_written(folder, capsys):
    (folder / "manifest.json").write_text("{")
    before = {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()}
    assert "manifest.json" in refusal(capsys, "plan", folder, "task-01")
    assert {path: path.read_bytes() for path in folder.rglob("*") if path.is_file()} == before


def test_plan_that_the_hand_cannot_follow_is_refused(folder, capsys):
    learned = Grounding.load(folder / "grounding.json")
    category = json.loads((folder / "problems/task-01.scene.json").read_text())["objects"][0]["category"]
    lift = next(op.name for op in learned.operators.operators if op.category == category and is_lift(op))
    plan = folder / "mine.plan"
    plan.write_text(f"({lift} item-01)\n({lift} item-01)\n")
    assert "step 2" in refusal(capsys, "execute", folder, "task-01", plan)
    plan.write_text(f"(put-down-{lift} item-01)\n")
    assert "step 1" in refusal(capsys, "execute", folder, "task-01", plan)


def test_problem_without_its_scene_is_refused(folder, capsys):
    (folder / "problems/task-01.scene.json").unlink()
    said = refusal(capsys, "plan", folder, "task-01")
    assert f"`neurosym new-problem {folder} --name task-01` writes it" in said


def test_folder_that_is_no_domain_folder_is_called_so(tmp_path, capsys):
    (tmp_path / "empty.plan").write_text("")
    for arguments in (
        ["plan", tmp_path, "task-01"],
        ["execute", tmp_path, "task-01", tmp_path / "empty.plan"],
    ):
        said = refusal(capsys, *arguments)
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


def test_folder_that_cannot_be_made_is_refused(folder, capsys):
    assert "Not a directory" in refusal(capsys, "init", folder / "world.toml" / "below")


def test_init_does_not_overwrite(tmp_path, capsys):
    assert neurosym("init", tmp_path) == 0
    assert "exists already" in refusal(capsys, "init", tmp_path)
