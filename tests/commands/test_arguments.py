"""The command line refuses what was typed and cannot be done in one sentence, and does the rest."""

import json
from pathlib import Path
from typing import get_args, get_type_hints

import pytest
from command_line import neurosym, refusal
from conftest import LEARN_TOY

from neurosym.commands.learn import distill, explore, run, train
from neurosym.commands.tasks import plan
from neurosym.data.origin import STRATEGIES
from neurosym.learning.training_config import REGIMES
from neurosym.pddl.syntax import ENCODINGS, SAS
from neurosym.planners import PlanStatus
from neurosym.planners.external import plan_fast_downward
from neurosym.primitives.audition import CHOICES


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
        (
            ["plan", "task-01", "--planner", "magic"],
            "no planner 'magic'; valid: aries, bfs, bfs-operators, counting",
        ),
        (["plan", "task-01", "--encoding", "runes"], "no encoding 'runes'; valid: numeric, sas, strips"),
        (
            ["plan", "task-01", "--encoding", "stepwise"],
            "The encoding stepwise is gone: one page, 'strips', says what it said; valid: strips, numeric",
        ),
        (["plan", "task-99"], "no problem 'task-99'; valid: task-01, task-02"),
        (["plan", "task-01", "--time-limit", "-1"], "time-limit"),
        (
            ["explore", "--strategy", "luck"],
            "no strategy 'luck'; valid: active, curiosity, disagreement, entropy, random",
        ),
        (["explore", "--regime", "big"], "no regime 'big'; valid: default, paper, quick"),
        (["explore", "--seed", "-1"], "seed = -1 must be at least 0"),
        (["train", "--seed", "-1"], "seed = -1 must be at least 0"),
        (["train", "--object-bits", "7"], "object_bits = 7 must be between 1 and 6"),
        (["train", "--action-bits", "0"], "action_bits = 0 must be between 1 and 8"),
        (["run", "--action-bits", "9"], "action_bits = 9 must be between 1 and 8"),
        (["run", "--world", "toy", "--problems", "-1"], "problems = -1 must be at least 0"),
        (["explore", "--steps", "0"], "steps = 0 must be at least 1"),
        (
            ["explore", *LEARN_TOY, "--seed", "3", "--steps", "2048", "--workers", "0"],
            "workers = 0 must be at least 1",
        ),
        (["explore", *LEARN_TOY, "--steps", "2048", "--seed", "4"], "seed = 3, not 4"),
        (["distill", "--objects", "0"], "objects = 0 must be at least 1"),
        (["distill", "--choice", "luck"], "no choice 'luck'; valid: lowest-error, own, predictable"),
        (["compile-domain", "--cell", "0"], "cell"),
    ],
)
def test_impossible_request_is_refused_in_one_sentence(folder, arguments, message, capsys):
    command, *rest = arguments
    assert message in refusal(capsys, command, folder, *rest)


@pytest.mark.parametrize(
    ("typed", "said"),
    [
        (["plan", "d", "p", "--time-limit", "abc"], "plan: error parsing --time-limit: 'abc' is no number"),
        (
            ["plan", "d", "p", "--time-limit"],
            "plan: missing value for argument '--time-limit'; `neurosym plan",
        ),
        (["execute", "d", "p", "f", "--disturb", "x"], "error parsing --disturb: 'x' is no whole number"),
        (["plan", "d"], "neurosym plan: missing: PROBLEM; `neurosym plan --help` says what there is"),
        (["plan", "d", "p", "--bogus", "3"], "neurosym plan: unrecognized options: --bogus, 3;"),
        (["plan", "d", "p", "--seed", "3"], "neurosym plan: unrecognized options: --seed, 3;"),
        (["plan", "d", "p", "x" * 300], "x" * 300),
        (["plam", "d"], "There is no command 'plam'; the nearest is plan, and `neurosym --help` lists all."),
        (["zzz", "d"], "There is no command 'zzz'; valid: check, compare,"),
        (["plan", "d", "p", "--time-limi", "3"], "--time-limi, 3; the nearest is --time-limit; `neurosym"),
        (["--bogus"], "neurosym: unrecognized options: --bogus; `neurosym --help` says"),
        ([], "neurosym: expected one of {demo, run, plan, execute,"),
        (
            ["new-problem", "d", "--goal", "item-01=0.6,0", "item-02=0.7,0"],
            "unrecognized options: item-02=0.7,0; `neurosym new-problem --help`",
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
        ["--steps", "0"],
        ["--seed", "-1"],
        ["--workers", "0"],
        ["--workers", "257"],
        ["--problems", "-1"],
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


def test_numbers_and_planners_of_a_run_are_checked(folder, capsys):
    (folder / "empty.plan").write_text("")
    run = ("execute", folder, "task-01", folder / "empty.plan")
    assert "replans = -1 must be at least 0" in refusal(capsys, *run, "--replans", "-1")
    assert "disturb = -1 must be at least 0" in refusal(capsys, *run, "--disturb", "-1")
    assert "no planner 'magic'" in refusal(capsys, *run, "--replanner", "magic")


def test_init_refuses_an_unknown_world_and_leaves_no_folder(tmp_path, capsys):
    said = refusal(capsys, "init", tmp_path / "new", "--world", "moon")
    assert "no world 'moon'; valid: tabletop, toy" in said
    assert not (tmp_path / "new").exists()


@pytest.mark.parametrize(
    ("command", "option", "choices"),
    [
        (run, "strategy", {*STRATEGIES, "curiosity"}),
        (explore, "strategy", {*STRATEGIES, "curiosity"}),
        (run, "regime", {*REGIMES}),
        (explore, "regime", {*REGIMES}),
        (train, "regime", {*REGIMES}),
        (distill, "choice", {*CHOICES}),
        (plan, "encoding", {*ENCODINGS, SAS}),
    ],
)
def test_help_lists_the_choices_that_there_are(command, option, choices, capsys):
    hint = get_type_hints(command)[option]
    listed = {
        choice for kind in (hint, *get_args(hint)) for choice in get_args(kind) if isinstance(choice, str)
    }
    assert listed == choices
    assert neurosym(command.__name__, "--help") == 0
    said = capsys.readouterr().out
    assert all(choice in said for choice in choices)


def test_problems_are_listed_where_none_is_named(capsys):
    said = refusal(capsys, "plan", "tabletop")
    assert "missing: PROBLEM; problems of tabletop: task-01, task-02, " in said
    assert "problems of" not in refusal(capsys, "plan", "no-such-folder")
