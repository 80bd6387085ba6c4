"""The command line refuses bad input in one sentence, with exit code 2, and writes nothing."""

import json
from pathlib import Path

import pytest
from command_line import neurosym, refusal
from conftest import LEARN_TOY

from neurosym.pddl.grounding import Grounding, is_lift
from neurosym.planners import PlanStatus
from neurosym.planners.fast_downward import plan_fast_downward


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


@pytest.mark.parametrize("file", ["problems/task-01.scene.json", "grounding.json"])
def test_foreign_json_is_refused(folder, file, capsys):
    (folder / file).write_text('{"format": "something-else"}')
    assert file in refusal(capsys, "plan", folder, "task-01")


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("(fly item-01)", "no operator 'fly'"),
        ("(OPERATOR item-09)", "no object 'item-09'; valid: item-01"),
        ("push it", "not of the form"),
    ],
)
def test_plan_that_cannot_be_read_is_refused_with_its_line(folder, line, message, capsys):
    operator = json.loads((folder / "primitives.json").read_text())["operators"][0]["name"]
    plan = folder / "mine.plan"
    plan.write_text(f"; a comment\n{line.replace('OPERATOR', operator)}\n")
    said = refusal(capsys, "execute", folder, "task-01", plan)
    assert message in said
    assert f"{plan}, line 2" in said


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


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["new-problem", "--goal", "item-01=5,0"], "out of reach; valid: x 0.4 to 1"),
        (["new-problem", "--goal", "item-01=left"], "cannot be read; write it as item-01=0.60,0.10"),
        (["new-problem", "--goal", "item-07=0.6,0"], "item-07, which is not in the scene"),
        (["new-problem", "--name", "Bad Name"], "'Bad Name' is not a legal name"),
        (["new-problem", "--name", "a" * 300], "has 300 characters; valid: at most 100"),
        (["new-problem", "--objects", "0"], "at least one object"),
        (["new-problem", "--objects", "500"], "500 objects do not fit"),
        (["plan", "task-01", "--planner", "magic"], "no planner 'magic'; valid: aries, bfs, counting"),
        (["plan", "task-01", "--encoding", "runes"], "'runes'; valid: operators, sas, stepwise"),
        (["plan", "task-99"], "no problem 'task-99'; valid: task-01, task-02"),
        (["plan", "task-01", "--time-limit", "-1"], "time-limit"),
        (
            ["explore", "--strategy", "luck"],
            "no strategy 'luck'; valid: active, disagreement, entropy, random",
        ),
        (["explore", "--min-predicted-effect", "-0.1"], "min-predicted-effect = -0.1 m must be at least 0"),
        (["explore", "--min-predicted-effect", "nan"], "min-predicted-effect = nan m must be at least 0"),
        (
            ["explore", *LEARN_TOY, "--min-predicted-effect", "0.1"],
            "random predicts no effect that min-predicted-effect could compare; valid with it: disagreement",
        ),
        (["explore", "--regime", "big"], "no regime 'big'; valid: default, paper, quick"),
        (["explore", "--seed", "-1"], "seed = -1 must be at least 0"),
        (["train", "--seed", "-1"], "seed = -1 must be at least 0"),
        (["run", "--world", "toy", "--problems", "-1"], "problems = -1 must be at least 0"),
        (["explore", "--steps", "0"], "steps = 0 must be at least 1"),
        (
            ["explore", *LEARN_TOY, "--seed", "3", "--steps", "2048", "--workers", "0"],
            "workers = 0 must be at least 1",
        ),
        (["explore", *LEARN_TOY, "--steps", "2048", "--seed", "4"], "seed = 3, not 4"),
        (["distill", "--objects", "0"], "objects = 0 must be at least 1"),
        (["distill", "--choice", "luck"], "no choice 'luck'; valid: lowest-error, predictable"),
        (["compile-domain", "--cell", "0"], "cell"),
    ],
)
def test_impossible_request_is_refused_in_one_sentence(folder, arguments, message, capsys):
    command, *rest = arguments
    assert message in refusal(capsys, command, folder, *rest)


@pytest.mark.parametrize(
    ("typed", "said"),
    [
        (["plan", "d", "p", "--time-limit", "abc"], "plan: error parsing --time-limit: could not convert"),
        (
            ["plan", "d", "p", "--time-limit"],
            "plan: missing value for argument '--time-limit'; `neurosym plan",
        ),
        (["plan", "d"], "neurosym plan: missing: PROBLEM; `neurosym plan --help` says what there is"),
        (["plan", "d", "p", "--bogus", "3"], "neurosym plan: unrecognized options: --bogus, 3;"),
        (["plan", "d", "p", "--seed", "3"], "neurosym plan: unrecognized or misplaced options: --seed 3;"),
        (["plan", "d", "p", "x" * 300], "x" * 300),
        (["plam", "d"], "There is no command 'plam'; valid: check, compare,"),
        (["--bogus"], "neurosym: unrecognized options: --bogus; `neurosym --help` says"),
        ([], "neurosym: expected one of {run, init,"),
        (
            ["new-problem", "d", "--goal", "item-01=0.6,0", "item-02=0.7,0"],
            "item-02=0.7,0; --goal is given once for each object; `neurosym new-problem --help`",
        ),
    ],
)
def test_what_cannot_be_read_is_refused_in_one_sentence(typed, said, capsys):
    assert said in refusal(capsys, *typed)


def test_help_is_printed_and_ends_well(capsys):
    assert neurosym("plan", "--help") == 0
    assert "--time-limit" in capsys.readouterr().out


def test_fewer_steps_do_not_throw_interactions_away(folder, capsys):
    before = (folder / "interactions.npz").read_bytes()
    said = refusal(capsys, "explore", folder, *LEARN_TOY, "--seed", "3", "--steps", "600")
    assert "holds 1024 interactions already, more than 600" in said
    assert (folder / "interactions.npz").read_bytes() == before


@pytest.mark.parametrize(
    "wrong",
    [
        ["--strategy", "luck"],
        ["--regime", "big"],
        ["--rehearsals", "0"],
        ["--min-predicted-effect", "-1.0"],
        ["--strategy", "active", "--min-predicted-effect", "0.1"],
    ],
)
def test_run_checks_what_was_typed_before_it_makes_a_folder(tmp_path, wrong, capsys):
    assert wrong[1] in refusal(capsys, "run", tmp_path / "new", *wrong)
    assert not (tmp_path / "new").exists()


def test_run_refuses_another_world_than_the_folders(folder, capsys):
    assert "of the world 'toy', not 'tabletop'" in refusal(capsys, "run", folder, "--world", "tabletop")


def test_compiling_on_another_grid_prints_the_problems_again(folder):
    assert neurosym("compile-domain", folder, "--cell", "0.02") == 0
    domain, problem = folder / "domain.pddl", folder / "problems/task-01.pddl"
    answer = plan_fast_downward(domain, problem, time_limit=30.0)
    assert answer.status in (PlanStatus.SOLVED, PlanStatus.UNSOLVABLE)


def test_two_goals_for_one_object_are_refused(folder, capsys):
    goals = ("--goal", "item-01=0.6,0.1", "--goal", "item-01=0.7,0.1")
    assert "item-01=0.7,0.1; give each object one" in refusal(capsys, "new-problem", folder, *goals)


def test_each_object_can_have_its_goal(folder):
    goals = ("--goal", "item-01=0.6,0.1", "--goal", "item-02=0.7,-0.1")
    assert neurosym("new-problem", folder, "--name", "both", "--objects", 2, *goals) == 0
    scene = json.loads((folder / "problems/both.scene.json").read_text())
    assert set(scene["goals"]) == {"item-01", "item-02"}


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


def test_picture_that_cannot_be_written_is_refused(folder, capsys):
    (folder / "empty.plan").write_text("")
    for target in (folder, folder / "nowhere" / "x.gif"):
        said = refusal(capsys, "execute", folder, "task-01", folder / "empty.plan", "--gif", target)
        assert f"No picture can be written to {target}" in said


@pytest.mark.skipif(not Path("/proc/self").exists(), reason="there is no folder that nobody can write")
def test_picture_in_a_folder_that_cannot_be_written_is_refused_before_the_run(folder, capsys):
    (folder / "empty.plan").write_text("")
    said = refusal(capsys, "execute", folder, "task-01", folder / "empty.plan", "--strip", "/proc/x.png")
    assert "No picture can be written to /proc/x.png" in said
    assert not (folder / "runs/task-01.empty.run.json").exists()


def test_record_can_be_named_as_in_the_folder_of_runs(folder, capsys):
    (folder / "empty.plan").write_text("")
    neurosym("execute", folder, "task-01", folder / "empty.plan", "--replans", 0)
    assert neurosym("replay", folder, "task-01.empty") == 0
    capsys.readouterr()
    said = refusal(capsys, "replay", folder, "task-01.full")
    assert "no record of a run 'task-01.full'; valid: task-01." in said
    assert "task-01.empty" in said


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


def test_numbers_and_planners_of_a_run_are_checked(folder, capsys):
    (folder / "empty.plan").write_text("")
    run = ("execute", folder, "task-01", folder / "empty.plan")
    assert "replans = -1 must be at least 0" in refusal(capsys, *run, "--replans", "-1")
    assert "disturb = -1 must be at least 0" in refusal(capsys, *run, "--disturb", "-1")
    assert "no planner 'magic'" in refusal(capsys, *run, "--replanner", "magic")


def test_folder_that_cannot_be_made_is_refused(folder, capsys):
    assert "Not a directory" in refusal(capsys, "init", folder / "world.toml" / "below")


def test_init_refuses_an_unknown_world_and_leaves_no_folder(tmp_path, capsys):
    said = refusal(capsys, "init", tmp_path / "new", "--world", "moon")
    assert "no world 'moon'; valid: tabletop, toy" in said
    assert not (tmp_path / "new").exists()


def test_init_does_not_overwrite(tmp_path, capsys):
    assert neurosym("init", tmp_path) == 0
    assert "exists already" in refusal(capsys, "init", tmp_path)
