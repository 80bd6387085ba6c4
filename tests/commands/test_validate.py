"""`neurosym validate` judges plans; `neurosym execute` follows those of others, and says whose steps."""

import json
import shutil
from pathlib import Path

import msgspec
import pytest
import toy_domain
from command_line import neurosym, refusal
from places import ROOT

from neurosym.pddl import domain_text
from neurosym.pddl.compiler import ground_plan
from neurosym.tasks.transition import PlanStep

LEFT, FORWARD = PlanStep("push-left-001-cube", "item-01"), PlanStep("push-forward-010-cube", "item-01")
GOAL = {"item-01": (0.6, 0.16, 0.025)}
"""Two pushes to the left."""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """A folder with the toy world, its domain, and a scene by hand, printed."""
    learned = toy_domain.grounding()
    (tmp_path / "world.toml").write_text('world = "toy"\n')
    learned.save(tmp_path / "grounding.json")
    (tmp_path / "domain.pddl").write_text(domain_text(learned))
    task = msgspec.structs.replace(toy_domain.problem(GOAL), name="two")
    task.save(tmp_path / "two.json")
    assert neurosym("new-problem", tmp_path, "--scene", tmp_path / "two.json") == 0
    return tmp_path


def written(folder: Path, *steps: PlanStep, name: str = "other") -> Path:
    task = msgspec.structs.replace(toy_domain.problem(GOAL), name="two")
    file = folder / f"{name}.plan"
    file.write_text(ground_plan(steps, task, toy_domain.grounding()).text)
    return file


def judged(folder: Path, plan: Path, capsys) -> tuple[int, dict]:
    capsys.readouterr()
    code = neurosym("validate", folder, "two", plan, "--json")
    return code, json.loads(capsys.readouterr().out)


def test_plan_is_judged_by_both(folder, capsys):
    plan = written(folder, LEFT, LEFT)
    code, said = judged(folder, plan, capsys)
    assert code == 0
    assert [said[key] for key in ("valid", "valid_by_pddl", "valid_by_replay")] == [True] * 3
    assert said["domain"] == "domain.pddl"
    assert said["chance"] == pytest.approx((21 / 22) ** 2, abs=1e-4)
    assert neurosym("validate", folder, "two", plan) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0] == "by domain.pddl, as unified-planning's validator says: valid"
    assert lines[1] == "by its replay: valid"
    assert lines[-1].startswith("next: neurosym execute")


def test_plan_that_misses_says_so_twice(folder, capsys):
    code, said = judged(folder, written(folder, LEFT), capsys)
    assert code == 3
    assert said["pddl_failed"] == 4
    assert said["pddl_reason"].startswith("(goal-cell item-01 ")
    assert said["replay_reason"] == "item-01 ends 80 mm from its goal, 50 mm are allowed"


def test_plan_that_says_what_is_not_so_is_judged_and_not_refused(folder, capsys):
    plan = written(folder, LEFT, LEFT)
    plan.write_text(plan.read_text().replace("y38", "y39", 1))
    code, said = judged(folder, plan, capsys)
    assert code == 3
    assert said["pddl_failed"] == 3
    assert "(y-sum dy8 y30 y39) does not hold there" in said["replay_reason"]
    assert said["steps"] == []
    assert said["chance"] is None


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("(fly item-01 y060)\n", "There is no operator 'fly'"),
        ("(push-left-001-cube item-09)\n", "There is no object 'item-09'"),
    ],
)
def test_plan_that_cannot_be_read_is_refused_as_execute_does(folder, capsys, text: str, said: str):
    (folder / "other.plan").write_text(text)
    assert said in refusal(capsys, "validate", folder, "two", folder / "other.plan")
    assert said in refusal(capsys, "execute", folder, "two", folder / "other.plan")


def test_steps_alone_are_written_out(folder, capsys):
    (folder / "short.plan").write_text("(push-left-001-cube item-01)\n" * 2)
    code, said = judged(folder, folder / "short.plan", capsys)
    assert (code, said["written_out"]) == (0, True)


def test_plan_without_steps_is_judged_by_the_page_where_there_are_relations(tmp_path, capsys):
    shipped = ROOT / "domains" / "towers"
    for name in ("grounding.json", "world.toml", "domain.pddl", "domain-numeric.pddl"):
        shutil.copy(shipped / name, tmp_path)
    shutil.copytree(shipped / "problems", tmp_path / "problems")
    plan = tmp_path / "empty.plan"
    plan.write_text("; nothing\n")
    assert neurosym("validate", tmp_path, "tower-2-01", plan) == 3
    assert "by domain.pddl, as unified-planning's validator says: not valid" in capsys.readouterr().out


def test_file_that_is_no_plan_is_refused(folder, capsys):
    (folder / "prose.plan").write_text("I would push it to the left, twice.\n")
    assert "prose.plan" in refusal(capsys, "validate", folder, "two", folder / "prose.plan")
    assert "There is no plan file" in refusal(capsys, "validate", folder, "two", folder / "none.plan")


def test_plan_of_another_is_followed_as_it_is_and_credited_with_what_it_did(folder, capsys):
    plan = written(folder, LEFT, FORWARD)
    assert neurosym("execute", folder, "two", plan) == 3
    said = capsys.readouterr().out.splitlines()
    assert (
        said[0]
        == f"follows {plan} as it is, to its end; neurosym did not write it: --replans 10 allows new plans"
    )
    assert any("goal missed" in line and "2 steps performed, all of the plan" in line for line in said)
    run = json.loads((folder / "runs/two.other.run.json").read_text())
    assert run["replannings"] == []
    assert (run["own"], len(run["steps"])) == (2, 2)
    assert "replanner" not in run


def test_goal_that_took_new_plans_is_not_credited_to_the_plan(folder, capsys):
    plan = written(folder, LEFT, FORWARD)
    assert neurosym("execute", folder, "two", plan, "--replans", 10, "--replanner", "counting", "--json") == 0
    said = json.loads(capsys.readouterr().out)
    assert said["outcome"] == "goal reached with new plans"
    assert said["own"] == 0  # it was replayed before its first step, and would have missed
    assert said["replanner"] == "counting"
    assert said["credit"].endswith("0 of the plan and the rest of new plans of counting")


def test_plan_of_ours_is_planned_anew_until_somebody_changes_it(folder, capsys):
    assert neurosym("plan", folder, "two") == 0
    plan = folder / "plans/two.fast-downward.plan"
    capsys.readouterr()
    assert neurosym("execute", folder, "two", plan) == 0
    said = capsys.readouterr().out
    assert "asks fast-downward for a new plan" in said.splitlines()[0]
    assert "goal reached: item-01 0 mm from it; 2 steps performed, all of the plan" in said
    plan.write_text(plan.read_text() + "; touched\n")
    assert neurosym("execute", folder, "two", plan) == 0
    assert "as it is, to its end; neurosym did not write it" in capsys.readouterr().out
