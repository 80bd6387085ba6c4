"""`--tolerance` of `new-problem`, `plan` and `execute`: how near objects must come, said in every record."""

import json
import shutil
from pathlib import Path

import msgspec
import pytest
import toy_domain
from command_line import neurosym, refusal
from places import ROOT

from neurosym.problems import Problem
from neurosym.stages.folder import DomainFolder
from neurosym.stages.plan_records import planned_tolerance

NEAR = {"item-01": (0.6, 0.11, 0.025)}
"""A push of 80 mm brings it to 30 mm from its goal."""


@pytest.fixture
def bare(bare: Path) -> Path:
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


def test_plan_comes_as_near_as_is_asked_and_its_record_says_so(bare, capsys):
    scene = (bare / "problems/near.scene.json").read_bytes()
    assert neurosym("plan", bare, "near", "--planner", "counting") == 0
    assert "tolerance" not in planned(bare)
    assert neurosym("plan", bare, "near", "--planner", "counting", "--tolerance", "0.02") == 3
    assert "20 mm are allowed" in capsys.readouterr().out
    assert planned(bare)["tolerance"] == 0.02
    assert neurosym("plan", bare, "near", "--planner", "counting", "--tolerance", "0.2") == 0
    assert planned(bare)["steps"] == []
    assert planned(bare)["tolerance"] == 0.2
    options = DomainFolder(bare).manifest().stages["plan near counting"].options
    assert options["tolerance"] == 0.2
    assert (bare / "problems/near.scene.json").read_bytes() == scene


def test_next_command_judges_the_run_as_the_plan_was_made(bare, capsys):
    neurosym("plan", bare, "near", "--planner", "counting", "--tolerance", "0.2")
    assert capsys.readouterr().out.splitlines()[-1].endswith("near.counting.steps --tolerance 0.2")
    plan = bare / "plans/near.counting.steps"  # no plan of the printed problem, which is stricter
    assert planned_tolerance(plan) == 0.2
    assert planned_tolerance(bare / "plans/near.mine.plan") is None
    assert neurosym("execute", bare, "near", plan, "--replans", 0) == 3
    assert f"note: {plan} is a plan to come within 200 mm; --tolerance 0.2" in capsys.readouterr().out
    assert neurosym("execute", bare, "near", plan, "--tolerance", "0.2", "--replans", 0) == 0
    assert "is a plan to come" not in capsys.readouterr().out


def test_run_is_judged_by_the_tolerance_asked_for_and_so_is_its_replay(bare, capsys):
    neurosym("plan", bare, "near", "--planner", "counting")
    run = ("execute", bare, "near", bare / "plans/near.counting.plan", "--replans", 0)
    assert neurosym(*run) == 0
    assert executed(bare)["tolerance"] is None
    assert neurosym(*run, "--tolerance", "0.02") == 3
    assert (executed(bare)["tolerance"], executed(bare)["reached"]) == (0.02, False)
    said = capsys.readouterr().out
    assert "goal missed: item-01 30 mm from it, 20 mm are allowed in this run" in said
    assert neurosym("replay", bare, "near.counting") == 0
    assert "byte for byte; goal missed" in capsys.readouterr().out
    assert neurosym(*run, "--tolerance", "0.05") == 0
    assert executed(bare)["tolerance"] is None  # it is the problem's own
    assert neurosym(*run, "--tolerance", "0.04") == 0
    Problem.load(bare / "problems/near.scene.json").within(0.01).save(bare / "problems/near.scene.json")
    capsys.readouterr()
    assert neurosym("replay", bare, "near.counting") == 0
    assert "goal reached" in capsys.readouterr().out
    record = bare / "runs/near.counting.run.json"
    record.write_text(record.read_text().replace('"tolerance": 0.04', '"tolerance": -1'))
    assert "tolerance" in refusal(capsys, "replay", bare, record)


def test_new_plans_in_a_run_come_as_near_as_is_asked(bare):
    run = ("execute", bare, "near", bare / "empty.plan", "--replanner", "counting", "--replans", 10)
    for tolerance, plans in (("0.2", 0), ("0.04", 1)):
        assert neurosym(*run, "--tolerance", tolerance) == 0
        record = json.loads((bare / "runs/near.empty.run.json").read_text())
        assert len(record["replannings"]) == plans


def test_plan_to_come_nearer_is_read_in_the_cells_that_are_printed(tmp_path):
    folder = tmp_path / "tabletop"
    shutil.copytree(ROOT / "domains/tabletop", folder)
    assert neurosym("plan", folder, "task-04", "--tolerance", "0.02") == 0
    plan = folder / "plans/task-04.fast-downward.plan"
    assert neurosym("validate", folder, "task-04", plan, "--tolerance", "0.02") == 0
