"""`neurosym new-problem`: a scene by hand; and how near objects must come, said in every record."""

import json
import shutil
from pathlib import Path

import msgspec
import pytest
import toy_domain
from command_line import neurosym, refusal
from places import ROOT

from neurosym.pddl import problem_text
from neurosym.problems import Problem
from neurosym.stages.folder import DomainFolder
from neurosym.stages.plan_records import planned_tolerance

AWAY = {"item-01": (0.6, 0.16, 0.025)}


@pytest.fixture
def mine(tmp_path: Path) -> Path:
    """A scene that somebody wrote."""
    file = tmp_path / "mine.json"
    toy_domain.problem(AWAY).save(file)
    return file


def printed(folder: Path, name: str) -> tuple[str, str]:
    files = (f"problems/{name}.pddl", f"problems/{name}.numeric.pddl")
    return tuple((folder / file).read_text() for file in files)


def expected(problem: Problem) -> tuple[str, str]:
    return tuple(problem_text(problem, toy_domain.grounding(), way) for way in ("strips", "numeric"))


def test_scene_by_hand_is_copied_checked_and_printed(bare, mine, capsys):
    assert neurosym("new-problem", bare, "--scene", mine) == 0
    said = capsys.readouterr().out
    assert f"wrote {bare}/problems/mine.pddl" in said
    assert f"next: neurosym plan {bare} mine" in said
    problem = msgspec.structs.replace(toy_domain.problem(AWAY), name="mine")
    assert Problem.load(bare / "problems/mine.scene.json") == problem
    assert printed(bare, "mine") == expected(problem)
    assert neurosym("plan", bare, "mine") == 0


def test_scene_by_hand_can_have_another_name_and_tolerance(bare, mine):
    assert neurosym("new-problem", bare, "--scene", mine, "--name", "other", "--tolerance", "0.02") == 0
    problem = Problem.load(bare / "problems/other.scene.json")
    assert (problem.name, problem.tolerance) == ("other", 0.02)
    assert "A goal is met within 20 mm" in printed(bare, "other")[0]
    assert Problem.load(mine).tolerance == 0.05


def test_scene_that_would_replace_another_problem_is_refused_unless_it_is_named(bare, mine, capsys):
    assert neurosym("new-problem", bare, "--scene", mine) == 0
    other = msgspec.structs.replace(toy_domain.problem(AWAY), tolerance=0.03)
    other.save(mine)
    said = refusal(capsys, "new-problem", bare, "--scene", mine)
    assert "has a problem mine already; give another name" in said
    assert Problem.load(bare / "problems/mine.scene.json").tolerance == 0.05
    assert neurosym("new-problem", bare, "--scene", mine, "--name", "mine") == 0
    assert f"replaced {bare}/problems/mine.pddl" in capsys.readouterr().out
    assert Problem.load(bare / "problems/mine.scene.json").tolerance == 0.03


def test_options_that_do_not_go_together_and_files_that_are_no_scenes_are_refused(bare, mine, capsys):
    for option in (("--objects", 2), ("--actions", 3), ("--seed", 1), ("--goal", "item-01=1,0")):
        assert "Give --scene, or" in refusal(capsys, "new-problem", bare, "--scene", mine, *option)
    assert "there is no such file" in refusal(capsys, "new-problem", bare, "--scene", mine.parent / "none")
    for name in ((), ("--name", "x")):
        said = refusal(capsys, "new-problem", bare, "--scene", mine.parent, *name)
        assert str(mine.parent) in said
    task = toy_domain.problem(AWAY)  # what a run saw may be a little off; what somebody writes may not
    off = msgspec.structs.replace(task.objects[0], position=(toy_domain.WORLD.table.x[1] + 0.01, 0.0, 0.025))
    msgspec.structs.replace(task, objects=(off,)).save(mine)
    assert "item-01 stands at" in refusal(capsys, "new-problem", bare, "--scene", mine)
    task.save(mine)
    spaced = mine.rename(mine.parent / "My Scene.json")
    assert "not a legal name" in refusal(capsys, "new-problem", bare, "--scene", spaced)
    assert neurosym("new-problem", bare, "--scene", spaced, "--name", "mine") == 0


def test_scene_put_into_the_folder_by_hand_is_planned_and_printed(bare, mine, capsys):
    (bare / "problems").mkdir()
    mine.rename(bare / "problems/mine.scene.json")
    assert neurosym("plan", bare, "mine") == 0
    problem = msgspec.structs.replace(toy_domain.problem(AWAY), name="mine")
    assert printed(bare, "mine") == expected(problem)
    (bare / "problems/mine.pddl").write_text("; of somebody else\n")
    assert neurosym("plan", bare, "mine", "--tolerance", "0.02") == 0
    assert printed(bare, "mine") == ("; of somebody else\n", expected(problem)[1])
    assert "mine.pddl is not as it was printed, so it stays" in capsys.readouterr().out
    assert "no problem 'none'; valid: mine" in refusal(capsys, "plan", bare, "none")


def test_drawn_problem_is_the_same_at_any_tolerance(folder, capsys):
    for name, tolerance in (("plain", None), ("fine", 0.01), ("coarse", 0.9)):
        asked = () if tolerance is None else ("--tolerance", tolerance)
        assert neurosym("new-problem", folder, "--name", name, "--seed", 4, *asked) == 0
    assert "note: it is met at the start, within 900 mm" in capsys.readouterr().out
    files = (folder / f"problems/{name}.scene.json" for name in ("plain", "fine", "coarse"))
    plain, fine, coarse = map(Problem.load, files)
    assert (plain.tolerance, fine.tolerance, coarse.tolerance) == (0.05, 0.01, 0.9)
    assert plain.goals == fine.goals == coarse.goals
    assert plain.objects == fine.objects == coarse.objects
    assert "A goal is met within 10 mm" in printed(folder, "fine")[0]
    hand = ("--name", "hand", "--goal", "item-01=0.6,0.1", "--tolerance")
    assert neurosym("new-problem", folder, *hand, "0.02") == 0
    assert Problem.load(folder / "problems/hand.scene.json").tolerance == 0.02
    assert "tolerance" in refusal(capsys, "new-problem", folder, "--name", "none", "--tolerance=-1")
    assert not list((folder / "problems").glob("none*"))


NEAR = {"item-01": (0.6, 0.11, 0.025)}
"""A push of 80 mm brings it to 30 mm from its goal."""


@pytest.fixture
def near(bare: Path) -> Path:
    """The same, with a scene by hand."""
    (bare / "problems").mkdir()
    task = msgspec.structs.replace(toy_domain.problem(NEAR), name="near")
    task.save(bare / "problems/near.scene.json")
    (bare / "empty.plan").write_text("")
    return bare


def planned(folder: Path) -> dict:
    return json.loads((folder / "plans/near.counting.json").read_text())


def executed(folder: Path) -> dict:
    return json.loads((folder / "runs/near.counting.run.json").read_text())


def test_plan_comes_as_near_as_is_asked_and_its_record_says_so(near, capsys):
    scene = (near / "problems/near.scene.json").read_bytes()
    assert neurosym("plan", near, "near", "--planner", "counting") == 0
    assert "tolerance" not in planned(near)
    assert neurosym("plan", near, "near", "--planner", "counting", "--tolerance", "0.02") == 3
    assert "20 mm are allowed" in capsys.readouterr().out
    assert planned(near)["tolerance"] == 0.02
    assert neurosym("plan", near, "near", "--planner", "counting", "--tolerance", "0.2") == 0
    assert planned(near)["steps"] == []
    assert planned(near)["tolerance"] == 0.2
    options = DomainFolder(near).manifest().stages["plan near counting"].options
    assert options["tolerance"] == 0.2
    assert (near / "problems/near.scene.json").read_bytes() == scene


def test_next_command_judges_the_run_as_the_plan_was_made(near, capsys):
    neurosym("plan", near, "near", "--planner", "counting", "--tolerance", "0.2")
    assert capsys.readouterr().out.splitlines()[-1].endswith("near.counting.steps --tolerance 0.2")
    plan = near / "plans/near.counting.steps"  # no plan of the printed problem, which is stricter
    assert planned_tolerance(plan) == 0.2
    assert planned_tolerance(near / "plans/near.mine.plan") is None
    assert neurosym("execute", near, "near", plan, "--replans", 0) == 3
    assert f"note: {plan} is a plan to come within 200 mm; --tolerance 0.2" in capsys.readouterr().out
    assert neurosym("execute", near, "near", plan, "--tolerance", "0.2", "--replans", 0) == 0
    assert "is a plan to come" not in capsys.readouterr().out


def test_run_is_judged_by_the_tolerance_asked_for_and_so_is_its_replay(near, capsys):
    neurosym("plan", near, "near", "--planner", "counting")
    run = ("execute", near, "near", near / "plans/near.counting.plan", "--replans", 0)
    assert neurosym(*run) == 0
    assert executed(near)["tolerance"] is None
    assert neurosym(*run, "--tolerance", "0.02") == 3
    assert (executed(near)["tolerance"], executed(near)["reached"]) == (0.02, False)
    said = capsys.readouterr().out
    assert "goal missed: item-01 30 mm from it, 20 mm are allowed in this run" in said
    assert neurosym("replay", near, "near.counting") == 0
    assert "byte for byte; goal missed" in capsys.readouterr().out
    assert neurosym(*run, "--tolerance", "0.05") == 0
    assert executed(near)["tolerance"] is None  # it is the problem's own
    assert neurosym(*run, "--tolerance", "0.04") == 0
    Problem.load(near / "problems/near.scene.json").within(0.01).save(near / "problems/near.scene.json")
    capsys.readouterr()
    assert neurosym("replay", near, "near.counting") == 0
    assert "goal reached" in capsys.readouterr().out
    record = near / "runs/near.counting.run.json"
    record.write_text(record.read_text().replace('"tolerance": 0.04', '"tolerance": -1'))
    assert "tolerance" in refusal(capsys, "replay", near, record)


def test_new_plans_in_a_run_come_as_near_as_is_asked(near):
    run = ("execute", near, "near", near / "empty.plan", "--replanner", "counting", "--replans", 10)
    for tolerance, plans in (("0.2", 0), ("0.04", 1)):
        assert neurosym(*run, "--tolerance", tolerance) == 0
        record = json.loads((near / "runs/near.empty.run.json").read_text())
        assert len(record["replannings"]) == plans


def test_plan_to_come_nearer_is_read_in_the_cells_that_are_printed(tmp_path):
    folder = tmp_path / "tabletop"
    shutil.copytree(ROOT / "domains/tabletop", folder)
    assert neurosym("plan", folder, "task-04", "--tolerance", "0.02") == 0
    plan = folder / "plans/task-04.fast-downward.plan"
    assert neurosym("validate", folder, "task-04", plan, "--tolerance", "0.02") == 0


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"unseen": [-0.05, *[0.1] * 10]}, "Object 2 is in truth -0.05 x 0.1 x 0.1 m large; valid: over 0"),
        ({"orientation": [0, 0, 0, 0]}, "Object 2 is turned by a quaternion of length 0; valid: 1"),
    ],
)
def test_scene_that_no_camera_sees_is_refused_and_not_written(changed, said, tmp_path, capsys):
    folder, file = tmp_path / "camera", tmp_path / "odd.json"
    shutil.copytree(ROOT / "domains/camera", folder)
    scene = json.loads((folder / "problems/swap-2-06.scene.json").read_text())
    scene["objects"][1] |= changed
    file.write_text(json.dumps(scene))
    assert said in refusal(capsys, "new-problem", folder, "--scene", file)
    assert not list(folder.glob("problems/odd*"))
