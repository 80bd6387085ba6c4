"""`neurosym plan` and what its options write; `validate` judges plans, `execute` follows those of others."""

import json
import shlex
from pathlib import Path

import msgspec
import numpy as np
import pytest
import toy_domain
from command_line import neurosym, refusal

from neurosym.pddl import domain_text
from neurosym.pddl.compiler import ground_plan, problem_text
from neurosym.problems import Problem
from neurosym.stages import planning
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
    told = "as it is, to its end; neurosym did not write it: --replans 10 allows new plans"
    assert said[0] == f"follows {plan} {told}"
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


@pytest.fixture
def four(tmp_path: Path) -> Path:
    """A folder with the toy world's grounding and four problems, of all kinds."""
    learned = toy_domain.grounding()
    (tmp_path / "problems").mkdir()
    learned.save(tmp_path / "grounding.json")
    cubes = toy_domain.problem({"item-01": (0.68, 0.08, 0.025), "item-02": (0.8, 0.1, 0.025)})
    far = {"item-01": (0.42, 0.0, 0.025), "item-02": (0.8, 0.18, 0.025)}
    air = {"item-01": (0.6, 0.0, 0.225), "item-02": (0.8, 0.1, 0.225)}
    for name, goals in (("easy", cubes.goals), ("far", far), ("air", air)):
        save(msgspec.structs.replace(cubes, name=name, goals=goals), tmp_path)
    loose = {"item-01": (0.66, 0.05, 0.025), "item-02": (0.8, 0.1, 0.025)}
    save(msgspec.structs.replace(cubes, name="loose", goals=loose, tolerance=0.07), tmp_path)
    return tmp_path


def save(task: Problem, folder: Path) -> None:
    task.save(folder / f"problems/{task.name}.scene.json")
    (folder / f"problems/{task.name}.pddl").write_text(problem_text(task, toy_domain.grounding()))


def test_chances_of_a_plan_are_told_and_a_record_of_it_is_kept(four, capsys):
    (four / "plans").mkdir(exist_ok=True)
    (four / "plans/loose.counting-alt-1.plan").write_text("")  # of an earlier version
    assert neurosym("plan", four, "loose", "--planner", "counting") == 0
    said = capsys.readouterr().out
    assert "95% likely to go as promised" in said
    assert "planned anew on the way, more than 99% likely to reach the goal within 3 motions" in said
    record = json.loads((four / "plans/loose.counting.json").read_text())
    assert record["chance"] == pytest.approx(21 / 22, abs=1e-4)
    assert list((four / "plans").glob("*-alt-*")) == []


def test_folder_with_a_blank_is_quoted_in_what_to_type_next(four, capsys):
    folder = four.rename(four.parent / "my domain")
    assert neurosym("plan", folder, "easy", "--planner", "counting") == 0
    said = capsys.readouterr().out.splitlines()[-1].removeprefix("next: ")
    plan = f"{folder}/plans/easy.counting.plan"
    assert shlex.split(said) == ["neurosym", "execute", str(folder), "easy", plan]
    assert f"`neurosym init '{folder}'`" in refusal(capsys, "execute", folder, "easy", plan)
    assert f"`neurosym plan '{folder}' easy`" in refusal(capsys, "execute", folder, "easy", "none.plan")


def test_a_plan_that_is_taken_away_is_told(four, capsys):
    file = four / "plans/easy.counting.plan"
    assert neurosym("plan", four, "easy", "--planner", "counting") == 0
    task = Problem.load(four / "problems/far.scene.json")
    save(msgspec.structs.replace(task, name="easy"), four)
    capsys.readouterr()
    assert neurosym("plan", four, "easy", "--planner", "counting") == 3
    assert not file.exists()
    assert f"removed {file}, the plan of an earlier call" in capsys.readouterr().out


@pytest.mark.parametrize("planner", ["counting", "fast-downward"])
def test_nearest_plan_is_written_and_the_goal_still_missed(four, capsys, planner):
    plan = four / f"plans/far.{planner}.steps"
    assert neurosym("plan", four, "far", "--planner", planner) == 3
    assert "out of every primitive's reach" in capsys.readouterr().out
    assert not plan.exists()
    assert neurosym("plan", four, "far", "--planner", planner, "--nearest") == 3
    assert "at the end, item-01 180 mm from its goal" in capsys.readouterr().out
    assert plan.read_text().splitlines()[0] == "(push-left-001-cube item-02)"
    assert neurosym("plan", four, "air", "--planner", planner, "--nearest") == 3
    assert "there is one hand" in capsys.readouterr().out
    assert "lift-000-cube" in (four / f"plans/air.{planner}.steps").read_text()


@pytest.fixture
def idle_network(monkeypatch: pytest.MonkeyPatch) -> None:
    """A network that predicts of every primitive that it moves nothing."""

    def idle(_folder, grounding):
        return lambda features: np.zeros((len(features), len(grounding.objects.symbols), 3))

    monkeypatch.setattr(planning, "_prediction", idle)


@pytest.mark.usefixtures("idle_network")
def test_bfs_speaks_of_what_the_network_predicts_and_says_what_the_rehearsals_know(four, capsys):
    assert neurosym("plan", four, "easy", "--planner", "bfs") == 3
    said = capsys.readouterr().out
    assert "): by what the network predicts, item-01 cannot reach its goal" in said
    assert "by the rehearsed effects there is a plan of 2 primitives: try another planner" in said
    assert neurosym("plan", four, "far", "--planner", "bfs") == 3
    said = capsys.readouterr().out
    assert "by the rehearsed effects" not in said
    assert "far --planner bfs --nearest\n" in said
    assert neurosym("plan", four, "air", "--planner", "bfs", "--nearest") == 3
    said = capsys.readouterr().out
    assert "item-01 200 mm from its goal; up to 8 primitives with each were looked at; by what the" in said
    assert neurosym("plan", four, "easy", "--planner", "bfs", "--nearest") == 0
    said = capsys.readouterr().out
    assert "meets the goal by the rehearsed effects; bfs, over what the network predicts, found none" in said


def test_what_cannot_be_planned_so_is_refused(four, capsys):
    for asked in ("bfs --encoding strips", "counting --encoding sas", "bfs --whole"):
        planner, option, *value = asked.split()
        said = refusal(capsys, "plan", four, "easy", "--planner", planner, option, *value)
        assert f"The planner {planner} does not take {option.removeprefix('--')}; valid with it: " in said
    task = Problem.load(four / "problems/easy.scene.json")
    off = msgspec.structs.replace(task.objects[0], position=(1.05, 0.0, 0.025))
    msgspec.structs.replace(task, objects=(off, task.objects[1])).save(four / "problems/easy.scene.json")
    for planner in ("bfs", "counting", "fast-downward"):
        said = refusal(capsys, "plan", four, "easy", "--planner", planner)
        assert "item-01 stands at x = 1.05" in said
