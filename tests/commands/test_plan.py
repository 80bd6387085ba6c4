"""`neurosym plan`: what its options write and say, on a domain that nobody had to learn."""

import json
import shlex
from pathlib import Path

import msgspec
import numpy as np
import pytest
import toy_domain
from command_line import neurosym, refusal

from neurosym.pddl.compiler import problem_text
from neurosym.problems import Problem
from neurosym.stages import planning


@pytest.fixture
def bare(tmp_path: Path) -> Path:
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


def test_chances_of_a_plan_are_told_and_a_record_of_it_is_kept(bare, capsys):
    (bare / "plans").mkdir(exist_ok=True)
    (bare / "plans/loose.counting-alt-1.plan").write_text("")  # of an earlier version
    assert neurosym("plan", bare, "loose", "--planner", "counting") == 0
    said = capsys.readouterr().out
    assert "95% likely to go as promised" in said
    assert "planned anew on the way, more than 99% likely to reach the goal within 3 motions" in said
    record = json.loads((bare / "plans/loose.counting.json").read_text())
    assert record["chance"] == pytest.approx(21 / 22, abs=1e-4)
    assert list((bare / "plans").glob("*-alt-*")) == []


def test_folder_with_a_blank_is_quoted_in_what_to_type_next(bare, capsys):
    folder = bare.rename(bare.parent / "my domain")
    assert neurosym("plan", folder, "easy", "--planner", "counting") == 0
    said = capsys.readouterr().out.splitlines()[-1].removeprefix("next: ")
    plan = f"{folder}/plans/easy.counting.plan"
    assert shlex.split(said) == ["neurosym", "execute", str(folder), "easy", plan]
    assert f"`neurosym init '{folder}'`" in refusal(capsys, "execute", folder, "easy", plan)
    assert f"`neurosym plan '{folder}' easy`" in refusal(capsys, "execute", folder, "easy", "none.plan")


def test_a_plan_that_is_taken_away_is_told(bare, capsys):
    file = bare / "plans/easy.counting.plan"
    assert neurosym("plan", bare, "easy", "--planner", "counting") == 0
    task = Problem.load(bare / "problems/far.scene.json")
    save(msgspec.structs.replace(task, name="easy"), bare)
    capsys.readouterr()
    assert neurosym("plan", bare, "easy", "--planner", "counting") == 3
    assert not file.exists()
    assert f"removed {file}, the plan of an earlier call" in capsys.readouterr().out


@pytest.mark.parametrize("planner", ["counting", "fast-downward"])
def test_nearest_plan_is_written_and_the_goal_still_missed(bare, capsys, planner):
    plan = bare / f"plans/far.{planner}.steps"
    assert neurosym("plan", bare, "far", "--planner", planner) == 3
    assert "out of every primitive's reach" in capsys.readouterr().out
    assert not plan.exists()
    assert neurosym("plan", bare, "far", "--planner", planner, "--nearest") == 3
    assert "at the end, item-01 180 mm from its goal" in capsys.readouterr().out
    assert plan.read_text().splitlines()[0] == "(push-left-001-cube item-02)"
    assert neurosym("plan", bare, "air", "--planner", planner, "--nearest") == 3
    assert "there is one hand" in capsys.readouterr().out
    assert "lift-000-cube" in (bare / f"plans/air.{planner}.steps").read_text()


@pytest.fixture
def idle_network(monkeypatch: pytest.MonkeyPatch) -> None:
    """A network that predicts of every primitive that it moves nothing."""

    def idle(_folder, grounding):
        return lambda features: np.zeros((len(features), len(grounding.operators.symbols), 3))

    monkeypatch.setattr(planning, "_prediction", idle)


@pytest.mark.usefixtures("idle_network")
def test_bfs_speaks_of_what_the_network_predicts_and_says_what_the_rehearsals_know(bare, capsys):
    assert neurosym("plan", bare, "easy", "--planner", "bfs") == 3
    said = capsys.readouterr().out
    assert "): by what the network predicts, item-01 cannot reach its goal" in said
    assert "by the rehearsed effects there is a plan of 2 primitives: try another planner" in said
    assert neurosym("plan", bare, "far", "--planner", "bfs") == 3
    assert "by the rehearsed effects" not in capsys.readouterr().out
    assert neurosym("plan", bare, "air", "--planner", "bfs", "--nearest") == 3
    said = capsys.readouterr().out
    assert "item-01 200 mm from its goal; up to 8 primitives with each were looked at; by what the" in said
    assert neurosym("plan", bare, "easy", "--planner", "bfs", "--nearest") == 0
    said = capsys.readouterr().out
    assert "meets the goal by the rehearsed effects; bfs, over what the network predicts, found none" in said


def test_what_cannot_be_planned_so_is_refused(bare, capsys):
    for planner, option, *value in (
        ("bfs", "--encoding", "strips"),
        ("counting", "--encoding", "sas"),
        ("bfs", "--whole"),
    ):
        said = refusal(capsys, "plan", bare, "easy", "--planner", planner, option, *value)
        told = f"The planner {planner} does not take {option.removeprefix('--')}; valid with it: "
        assert told in said
    task = Problem.load(bare / "problems/easy.scene.json")
    off = msgspec.structs.replace(task.objects[0], position=(1.05, 0.0, 0.025))
    msgspec.structs.replace(task, objects=(off, task.objects[1])).save(bare / "problems/easy.scene.json")
    for planner in ("bfs", "counting", "fast-downward"):
        said = refusal(capsys, "plan", bare, "easy", "--planner", planner)
        assert "item-01 stands at x = 1.05" in said
