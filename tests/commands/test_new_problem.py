"""`neurosym new-problem`: a scene by hand, and how near objects must come."""

from pathlib import Path

import msgspec
import pytest
import toy_domain
from command_line import neurosym, refusal

from neurosym.pddl import problem_text
from neurosym.problems import Problem

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
    assert "has a problem mine already; give another name" in refusal(
        capsys, "new-problem", bare, "--scene", mine
    )
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
    task = toy_domain.problem(
        AWAY
    )  # what a run saw may be a little off the table; what somebody writes may not
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
    plain, fine, coarse = (
        Problem.load(folder / f"problems/{name}.scene.json") for name in ("plain", "fine", "coarse")
    )
    assert (plain.tolerance, fine.tolerance, coarse.tolerance) == (0.05, 0.01, 0.9)
    assert plain.goals == fine.goals == coarse.goals
    assert plain.objects == fine.objects == coarse.objects
    assert "A goal is met within 10 mm" in printed(folder, "fine")[0]
    hand = ("--name", "hand", "--goal", "item-01=0.6,0.1", "--tolerance")
    assert neurosym("new-problem", folder, *hand, "0.02") == 0
    assert Problem.load(folder / "problems/hand.scene.json").tolerance == 0.02
    assert "tolerance" in refusal(capsys, "new-problem", folder, "--name", "none", "--tolerance=-1")
    assert not list((folder / "problems").glob("none*"))
