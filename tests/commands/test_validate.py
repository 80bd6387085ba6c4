"""`neurosym validate` judges plans; `neurosym execute` follows those of others, and says whose steps."""

import json
from pathlib import Path

import msgspec
import pytest
import toy_domain
from command_line import neurosym, refusal

from neurosym.pddl import domain_text
from neurosym.pddl.compiler import ground_plan
from neurosym.tasks.transition import PlanStep

LEFT, FORWARD = PlanStep("push-left-001-cube", "item-01"), PlanStep("push-forward-010-cube", "item-01")
GOAL = {"item-01": (0.6, 0.16, 0.025)}
"""Two pushes to the left."""


@pytest.fixture
def folder(bare: Path) -> Path:
    """The same, with the domain and a scene by hand, printed."""
    (bare / "domain.pddl").write_text(domain_text(toy_domain.grounding()))
    msgspec.structs.replace(toy_domain.problem(GOAL), name="two").save(bare / "two.json")
    assert neurosym("new-problem", bare, "--scene", bare / "two.json") == 0
    return bare


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


def test_plan_that_misses_or_says_what_is_not_so_is_judged_and_not_refused(folder, capsys):
    code, said = judged(folder, written(folder, LEFT), capsys)
    assert (code, said["pddl_failed"]) == (3, 4)
    assert said["pddl_reason"].startswith("(goal-cell item-01 ")
    assert said["replay_reason"] == "item-01 ends 80 mm from its goal, 50 mm are allowed"
    plan = written(folder, LEFT, LEFT)
    plan.write_text(plan.read_text().replace("y38", "y39", 1))
    code, said = judged(folder, plan, capsys)
    assert (code, said["pddl_failed"], said["steps"], said["chance"]) == (3, 3, [], None)
    assert "(y-sum dy8 y30 y39) does not hold there" in said["replay_reason"]


def test_what_is_no_plan_is_refused_as_execute_does_and_steps_alone_are_written_out(folder, capsys):
    file = folder / "other.plan"
    for text, said in (
        ("(fly item-01 y060)\n", "There is no operator 'fly'"),
        ("(push-left-001-cube item-09)\n", "There is no object 'item-09'"),
        ("I would push it to the left, twice.\n", "other.plan"),
    ):
        file.write_text(text)
        for command in ("validate", "execute"):
            told = refusal(capsys, command, folder, "two", file)
            assert said in told
            assert f"{file}, line 1" in told
    assert "There is no plan file" in refusal(capsys, "validate", folder, "two", folder / "none.plan")
    file.write_text("(push-left-001-cube item-01)\n" * 2)
    code, said = judged(folder, file, capsys)
    assert (code, said["written_out"]) == (0, True)


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
