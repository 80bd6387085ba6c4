"""`neurosym new-problem`: a scene by hand, and how near objects must come."""

import json
from pathlib import Path

import msgspec
import pytest
import toy_domain
from command_line import neurosym, refusal

from neurosym.pddl import problem_text
from neurosym.problems import Problem

AWAY = {"item-01": (0.6, 0.16, 0.025)}


@pytest.fixture
def bare(tmp_path: Path) -> Path:
    """A folder with the toy world and a hand-written domain; no network, no problem."""
    place = tmp_path / "domain"
    place.mkdir()
    (place / "world.toml").write_text('world = "toy"\n')
    toy_domain.grounding().save(place / "grounding.json")
    return place


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


def test_scene_that_lies_in_the_folder_is_printed_where_it_is(bare, mine, capsys):
    (bare / "problems").mkdir()
    scene = bare / "problems/mine.scene.json"
    mine.rename(scene)
    assert neurosym("new-problem", bare, "--scene", scene) == 0
    assert neurosym("new-problem", bare, "--scene", scene) == 0
    assert len(list((bare / "problems").iterdir())) == 3
    assert Problem.load(scene).name == "mine"
    assert "stale" not in capsys.readouterr().out


def test_scene_that_would_replace_another_problem_is_refused_unless_it_is_named(bare, mine, capsys):
    assert neurosym("new-problem", bare, "--scene", mine) == 0
    other = msgspec.structs.replace(toy_domain.problem(AWAY), tolerance=0.03)
    other.save(mine)
    assert "has a problem mine already; give another name" in refusal(
        capsys, "new-problem", bare, "--scene", mine
    )
    assert Problem.load(bare / "problems/mine.scene.json").tolerance == 0.05
    assert neurosym("new-problem", bare, "--scene", mine, "--name", "mine") == 0
    assert f"replaced {bare}/problems/mine.pddl" in capsys.readouterr().out
    assert Problem.load(bare / "problems/mine.scene.json").tolerance == 0.03


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"goals": {"item-09": [0.6, 0.1, 0.025]}}, "item-09, which is not in the scene"),
        ({"goals": {}}, "has no goal"),
        ({"goals": {"item-01": [9.0, 0.1, 0.025]}}, "out of reach"),
        ({"tolerance": 0}, "tolerance"),
        ({"objects": []}, "needs one object or more"),
        ({"colour": "red"}, "colour"),
    ],
)
def test_scene_that_cannot_be_is_refused_and_nothing_is_written(bare, mine, capsys, change, said):
    mine.write_text(json.dumps(json.loads(mine.read_text()) | change))
    words = refusal(capsys, "new-problem", bare, "--scene", mine)
    assert str(mine) in words
    assert said in words
    assert not (bare / "problems").exists() or not list((bare / "problems").iterdir())


def test_scene_with_another_category_is_refused(bare, mine, capsys):
    mine.write_text(mine.read_text().replace('"00"', '"11"'))
    assert "no category '11'" in refusal(capsys, "new-problem", bare, "--scene", mine)


@pytest.mark.parametrize(
    "option", [("--objects", 2), ("--actions", 3), ("--seed", 1), ("--goal", "item-01=1,0")]
)
def test_scene_and_what_draws_one_are_not_given_together(bare, mine, capsys, option):
    assert "Give --scene, or" in refusal(capsys, "new-problem", bare, "--scene", mine, *option)


def test_scene_that_is_not_there_or_cannot_be_named_so_is_refused(bare, mine, capsys):
    assert "there is no such file" in refusal(capsys, "new-problem", bare, "--scene", mine.parent / "none")
    for name in ((), ("--name", "x")):
        said = refusal(capsys, "new-problem", bare, "--scene", mine.parent, *name)
        assert str(mine.parent) in said
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
    plain, fine, coarse = (
        Problem.load(folder / f"problems/{name}.scene.json") for name in ("plain", "fine", "coarse")
    )
    assert (plain.tolerance, fine.tolerance, coarse.tolerance) == (0.05, 0.01, 0.9)
    assert plain.goals == fine.goals == coarse.goals
    assert plain.objects == fine.objects == coarse.objects
    assert "A goal is met within 10 mm" in printed(folder, "fine")[0]


def test_tolerance_is_for_goals_by_hand_too(folder):
    goal = ("--goal", "item-01=0.6,0.1", "--tolerance", "0.02")
    assert neurosym("new-problem", folder, "--name", "hand", *goal) == 0
    assert Problem.load(folder / "problems/hand.scene.json").tolerance == 0.02


def test_impossible_tolerance_makes_no_problem(folder, capsys):
    assert "tolerance" in refusal(capsys, "new-problem", folder, "--name", "none", "--tolerance=-1")
    assert not list((folder / "problems").glob("none*"))


def test_scene_with_an_object_off_the_table_is_refused(bare, mine, capsys):
    """What a run saw may be a little off the table; what somebody writes may not."""
    task = toy_domain.problem(AWAY)
    off = msgspec.structs.replace(task.objects[0], position=(toy_domain.WORLD.table.x[1] + 0.01, 0.0, 0.025))
    msgspec.structs.replace(task, objects=(off, task.objects[1])).save(mine)
    assert "item-01 stands at" in (said := refusal(capsys, "new-problem", bare, "--scene", mine))
    assert "off the table; valid: x" in said
    assert not (bare / "problems").exists()
