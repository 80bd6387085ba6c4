"""Planners of one's own: the documented one goes wherever ours go, and what is no planner is refused."""

import importlib
import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from command_line import neurosym, refusal
from documents import python_blocks
from tables import grounding, problem
from toy_domain import WORLD
from toy_domain import grounding as toy_grounding
from toy_domain import problem as toy_problem

from neurosym.errors import InvalidPlanner
from neurosym.planners import (
    PLANNERS,
    Planner,
    PlannerAnswer,
    PlanResult,
    PlanStatus,
    pddl_planner,
    plan,
    planner_named,
    register_planner,
)
from neurosym.planners.planner import Query
from neurosym.tasks.transition import PlanStep, validate

CODE, REGISTERED = python_blocks("own-planner.md")


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """The current folder, with the documented planner."""
    (tmp_path / "mimir_planner.py").write_text(CODE)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", list(sys.path))
    before = dict(PLANNERS)
    yield tmp_path
    PLANNERS.clear()
    PLANNERS.update(before)
    for name in ("mimir_planner", "mine"):
        sys.modules.pop(name, None)


def test_the_documented_planner_is_short():
    assert len(CODE.splitlines()) < 30


def test_the_documented_planner_plans_is_compared_and_replans(here: Path, folder: Path, capsys):
    asked = ("--planner", "mimir_planner:make")
    assert neurosym("plan", folder, "task-01", *asked) == 0
    record = json.loads((folder / "plans/task-01.mimir.json").read_text())
    assert (record["planner"], record["status"]) == ("mimir", "solved")
    plan_file = folder / "plans/task-01.mimir.plan"
    assert f"next: neurosym execute {folder} task-01 {plan_file}" in capsys.readouterr().out
    run = ("execute", folder, "task-01", plan_file, "--replanner", "mimir_planner:make", "--disturb", 3)
    assert neurosym(*run) in (0, 3)
    assert json.loads((folder / "runs/task-01.mimir.run.json").read_text())["replannings"]
    both = ("fast-downward", "mimir_planner:make")
    assert neurosym("compare", folder, "--tasks", 4, "--workers", 2, "--planners", *both) == 0
    found = json.loads((folder / "comparison/1-objects-50-mm/comparison.json").read_text())["planners"]
    assert found["mimir_planner:make"]["found"] == found["fast-downward"]["found"] > 0


def test_another_planner_of_the_same_name_writes_over_no_plan(here: Path, folder: Path, capsys):
    (here / "mine.py").write_text("from mimir_planner import make\n")
    asked = ("plan", folder, "task-01", "--planner")
    for _ in range(2):
        assert neurosym(*asked, "mimir_planner:make") == 0
    plan_file = folder / "plans/task-01.mimir.plan"
    before = plan_file.read_bytes()
    said = refusal(capsys, *asked, "mine:make")
    assert "mine:make has the same name as mimir_planner:make, by which plans/task-01.mimir.plan is" in said
    assert plan_file.read_bytes() == before
    plan_file.unlink()
    assert neurosym(*asked, "mine:make") == 0


def test_a_planner_is_registered_in_one_call(here: Path, monkeypatch: pytest.MonkeyPatch):
    monkeypatch.syspath_prepend(here)
    names = {"problem": problem(), "grounding": grounding()}
    exec(REGISTERED, names)
    result = names["result"]
    assert isinstance(result, PlanResult)
    assert result.status is PlanStatus.SOLVED
    assert validate(result.steps, problem(), grounding()).valid
    value = importlib.import_module("mimir_planner").make()
    assert plan(problem(), grounding(), value).steps == result.steps


@pytest.mark.parametrize(
    ("code", "message"),
    [
        ("", "cannot be found: the module 'mine' has no 'make'"),
        ("import nothing_there", "cannot be imported: ModuleNotFoundError"),
        ("make = 3", "is no Planner but of type int; return what neurosym.pddl_planner makes"),
        ("def make(): return lambda *_: None", "is no Planner but of type function"),
        ("def make(): raise ValueError('no licence.')", "cannot be made: ValueError: no licence"),
        ("def make(size): return size", "cannot be made: TypeError"),
        (
            "from neurosym import pddl_planner\ndef make(): return pddl_planner('bfs', '', print)",
            "has the name 'bfs', which one of ours has",
        ),
        (
            "from neurosym import pddl_planner\ndef make(): return pddl_planner('Mine', '', print)",
            "'Mine' is no name; valid: a lower-case letter",
        ),
    ],
)
def test_what_is_no_planner_is_refused_with_what_is_missing(
    here: Path, folder: Path, code: str, message: str, capsys
):
    (here / "mine.py").write_text(code + "\n")
    sys.modules.pop("mine", None)
    for command in (
        ("plan", folder, "task-01", "--planner", "mine:make"),
        ("compare", folder, "--tasks", 1, "--planners", "mine:make"),
    ):
        assert message in refusal(capsys, *command)


def test_a_planner_with_a_part_that_cannot_be_is_refused(here: Path, folder: Path):
    """In a process of its own: here, types are checked before we can."""
    parts = {
        "solve": "solve = None; valid: a function of a Query",
        "missing": "missing = None; valid: a func",
    }
    for part, message in parts.items():
        code = f"Planner('a', 'a', **{{'solve': print, '{part}': None}})"
        (here / "mine.py").write_text(f"from neurosym import Planner\ndef make(): return {code}\n")
        command = [sys.executable, "-m", "neurosym", "plan", folder, "task-01", "--planner", "mine:make"]
        ran = subprocess.run(command, capture_output=True, text=True)
        assert (ran.returncode, ran.stdout) == (2, "")
        assert message in ran.stderr


def test_a_domain_folder_must_not_bring_a_planner(folder: Path, monkeypatch: pytest.MonkeyPatch, capsys):
    (folder / "mine.py").write_text(CODE)
    monkeypatch.syspath_prepend(folder)
    said = refusal(capsys, "plan", folder, "task-01", "--planner", "mine:make")
    assert "has its code in the domain folder" in said


def test_a_planner_in_a_domain_folder_that_one_stands_in_is_not_called_missing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
):
    (tmp_path / "planner_of_the_folder.py").write_text(CODE)
    monkeypatch.chdir(tmp_path)
    with pytest.raises(InvalidPlanner, match="has its code in the domain folder"):
        planner_named("planner_of_the_folder:make", tmp_path)


def test_what_a_planner_prints_is_no_part_of_the_answer(capsys: pytest.CaptureFixture[str]):
    def chatty(_: object) -> PlanResult:
        print("(fly item-01)")
        return PlanResult(PlanStatus.FAILED, (), 0.0, "tired")

    assert plan(problem(), grounding(), Planner("mine", "mine", chatty)).reason == "tired"
    assert capsys.readouterr().out == ""


@pytest.mark.parametrize("reason", ["tired\ud800", "tired\x1b[31m", "tired\n" * 1000])
@pytest.mark.parametrize("encoded", [True, False])
def test_what_a_planner_says_is_one_line_that_can_be_printed(reason: str, encoded: bool):
    if encoded:
        mine = pddl_planner("mine", "mine", lambda *_, **__: PlannerAnswer(PlanStatus.FAILED, reason=reason))
    else:
        mine = Planner("mine", "mine", lambda _: PlanResult(PlanStatus.FAILED, (), 0.0, reason))
    said = plan(problem(), grounding(), mine).reason
    assert said.startswith("tired")
    assert said.isprintable()
    assert len(said) <= 400


def raises(_: object) -> PlanResult:
    raise RuntimeError("out of ink")


def leaves(_: object) -> PlanResult:
    raise SystemExit(5)


def solved(*steps: PlanStep) -> Callable[[object], PlanResult]:
    return lambda _: PlanResult(PlanStatus.SOLVED, steps, 0.0)


@pytest.mark.parametrize(
    ("solve", "message"),
    [
        (raises, "The planner mine raises an error in solve: RuntimeError: out of ink"),
        (lambda _: "a plan", "The planner mine gives a str from solve; valid: a PlanResult"),
        (leaves, "The planner mine raises an error in solve: SystemExit: 5"),
    ],
)
def test_a_planner_that_fails_is_named(solve: Callable[..., PlanResult], message: str):
    with pytest.raises(InvalidPlanner, match=message):
        plan(problem(), grounding(), Planner("mine", "mine", solve))


@pytest.mark.parametrize(
    ("status", "reason"),
    [
        (PlanStatus.TIMEOUT, "mine found no plan in time"),
        (PlanStatus.UNSOLVABLE, "mine says that there is no plan"),
        (PlanStatus.FAILED, "mine failed, and does not say why"),
    ],
)
def test_a_planner_that_gives_no_reason_is_given_one(status: PlanStatus, reason: str):
    mute = Planner("mine", "mine", lambda _: PlanResult(status, (), 0.01))
    assert plan(problem(), grounding(), mute).reason == reason


def test_a_plan_that_is_not_true_is_not_believed():
    goals = {"item-01": (0.68, 0.0, 0.025)}
    right = solved(PlanStep("push-forward-010-cube", "item-01"))
    wrong = solved(PlanStep("push-left-001-cube", "item-01"))
    found = plan(toy_problem(goals), toy_grounding(), Planner("mine", "mine", right))
    assert found.status is PlanStatus.SOLVED
    found = plan(toy_problem(goals), toy_grounding(), Planner("mine", "mine", wrong))
    assert found.status is PlanStatus.FAILED
    assert found.reason.startswith("its plan is not true when replayed: item-01 ends")


def test_a_planner_that_reads_the_network_is_shown_what_it_predicts():
    seen = []

    def solve(query):
        seen.append(query.predict)
        return PlanResult(PlanStatus.UNSOLVABLE, (), 0.0)

    def predict(features):
        return features[:, None, :3]

    for reads in ("network", "operators"):
        mine = Planner("mine", "mine", solve, reads=reads)
        plan(toy_problem({}), toy_grounding(), mine, predict=predict)
    assert seen == [predict, None]
    assert WORLD.name == "toy"


def test_names_of_ours_cannot_be_taken():
    with pytest.raises(InvalidPlanner, match="counting has a name which one of ours has"):
        register_planner(pddl_planner("counting", "", lambda *_, **__: PlannerAnswer(PlanStatus.FAILED)))
    assert planner_named("counting").is_exact


@pytest.mark.parametrize(
    ("answer", "message"),
    [
        (lambda *_, **__: None, "gives a NoneType from call; valid: a PlannerAnswer"),
        (lambda *_, **__: "(push-left-001-cube item-01)", "gives a str from call; valid: a PlannerAnswer"),
        (leaves, "raises an error in solve: TypeError"),
    ],
)
def test_what_is_no_answer_is_refused(answer: Callable[..., PlannerAnswer], message: str):
    mine = pddl_planner("mine", "mine", answer)
    with pytest.raises(InvalidPlanner, match=f"The planner mine {message}"):
        plan(problem(), grounding(), mine)


def test_an_empty_plan_that_is_called_a_plan_fails():
    mine = pddl_planner("mine", "mine", lambda *_, **__: PlannerAnswer(PlanStatus.SOLVED))
    found = plan(problem(), grounding(), mine)
    assert found.status is PlanStatus.FAILED
    assert "no plan was true when replayed" in found.reason


def test_ours_searches_for_a_way_without_a_grid_where_plans_are_false_on_every_grid():
    def nothing(*_: object, **__: object) -> PlannerAnswer:
        return PlannerAnswer(PlanStatus.SOLVED)

    found = plan(problem(), grounding(), pddl_planner("mine", "mine", nothing, aims=True))
    assert found.status is PlanStatus.SOLVED
    assert "searched for without a grid, for on it: " in found.reason
    assert validate(found.steps, problem(), grounding()).valid


def test_a_planner_that_changes_the_current_folder_moves_nothing(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)

    def solve(query: Query) -> PlanResult:
        os.chdir("/")
        return PlanResult(PlanStatus.NOT_FOUND, (), 0.0, "gone")

    plan(problem(), grounding(), Planner("mine", "mine", solve))
    assert Path.cwd() == tmp_path


@pytest.mark.parametrize(
    ("step", "said"),
    [
        (PlanStep("fly", "item-01"), "its plan names the operator 'fly', which the domain does not have"),
        (PlanStep("push-left-001-cube", "moon"), "its plan names the object 'moon', which the problem does"),
    ],
)
def test_a_plan_of_things_that_there_are_not_fails(step: PlanStep, said: str):
    for reads in ("operators", "network"):
        mine = Planner("mine", "mine", solved(step), reads=reads)
        found = plan(toy_problem({"item-01": (0.68, 0.0, 0.025)}), toy_grounding(), mine)
        assert found.status is PlanStatus.FAILED
        assert found.reason.startswith(said)


def test_a_planner_that_cannot_say_whether_it_is_there_is_named():
    mine = Planner("mine", "mine", solved(), missing=lambda: 1 / 0)
    with pytest.raises(InvalidPlanner, match="raises an error in missing: ZeroDivisionError"):
        plan(problem(), grounding(), mine)


def test_the_name_of_one_of_ours_earns_no_trust():
    wrong = Planner("bfs", "mine", solved(PlanStep("push-left-001-cube", "item-01")))
    found = plan(toy_problem({"item-01": (0.68, 0.0, 0.025)}), toy_grounding(), wrong)
    assert found.status is PlanStatus.FAILED


def test_comparing_refuses_a_planner_that_fails(here: Path, folder: Path, capsys):
    (here / "mine.py").write_text(
        "from neurosym import Planner\ndef make(): return Planner('mine', 'mine', lambda query: 1 / 0)\n"
    )
    said = refusal(capsys, "compare", folder, "--tasks", 2, "--workers", 1, "--planners", "mine:make")
    assert "The planner mine raises an error in solve: ZeroDivisionError" in said
