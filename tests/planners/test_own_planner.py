"""Planners of one's own: the documented one goes wherever ours go, and what is no planner is refused."""

import importlib
import json
import os
import sys
from pathlib import Path

import pytest
from command_line import neurosym, refusal
from documents import python_blocks
from tables import grounding, problem
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
    registry,
)
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


def test_the_documented_planner_plans_and_replans_and_is_compared(here: Path, folder: Path, capsys):
    """Another of its name is not taken."""
    asked = ("--planner", "mimir_planner:make")
    assert neurosym("plan", folder, "task-01", *asked) == 0
    record = json.loads((folder / "plans/task-01.mimir.json").read_text())
    assert (record["planner"], record["status"]) == ("mimir", "solved")
    assert len(CODE.splitlines()) < 30
    plan_file = folder / "plans/task-01.mimir.plan"
    assert f"next: neurosym execute {folder} task-01 {plan_file}" in capsys.readouterr().out
    run = ("execute", folder, "task-01", plan_file, "--replanner", "mimir_planner:make", "--disturb", 3)
    assert neurosym(*run) in (0, 3)
    assert json.loads((folder / "runs/task-01.mimir.run.json").read_text())["replannings"]
    (here / "mine.py").write_text("from mimir_planner import make\n")
    before = plan_file.read_bytes()
    said = refusal(capsys, "plan", folder, "task-01", "--planner", "mine:make")
    assert "mine:make has the same name as mimir_planner:make, by which plans/task-01.mimir.plan is" in said
    assert plan_file.read_bytes() == before
    both = ("fast-downward", "mimir_planner:make")
    assert neurosym("compare", folder, "--tasks", 2, "--workers", 2, "--planners", *both) == 0
    found = json.loads((folder / "comparison/1-objects-50-mm/comparison.json").read_text())["planners"]
    assert found["mimir_planner:make"]["found"] == found["fast-downward"]["found"] > 0


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


OURS = "from neurosym import pddl_planner\ndef make(): return "


@pytest.mark.parametrize(
    ("code", "message"),
    [
        ("", "cannot be found: the module 'mine' has no 'make'"),
        ("import nothing_there", "cannot be imported: ModuleNotFoundError"),
        ("make = 3", "is no Planner but of type int; return what neurosym.pddl_planner makes"),
        ("def make(): return lambda *_: None", "is no Planner but of type function"),
        ("def make(): raise ValueError('no licence.')", "cannot be made: ValueError: no licence"),
        ("def make(size): return size", "cannot be made: TypeError"),
        (f"{OURS}pddl_planner('bfs', '', print)", "has the name 'bfs', which one of ours has"),
    ],
)
def test_what_is_no_planner_is_refused_with_what_is_missing(here, folder, code: str, message: str, capsys):
    (here / "mine.py").write_text(code + "\n")
    sys.modules.pop("mine", None)
    for command in (
        ("plan", folder, "task-01", "--planner", "mine:make"),
        ("compare", folder, "--tasks", 1, "--workers", 1, "--planners", "mine:make"),
    ):
        assert message in refusal(capsys, *command)


def test_a_domain_folder_must_not_bring_a_planner(folder: Path, monkeypatch: pytest.MonkeyPatch, capsys):
    """Nor is one in a folder that somebody stands in called missing."""
    (folder / "mine.py").write_text(CODE)
    monkeypatch.chdir(folder)
    with pytest.raises(InvalidPlanner, match="has its code in the domain folder"):
        registry.planner_named("mine:make", folder)
    monkeypatch.syspath_prepend(folder)
    said = refusal(capsys, "plan", folder, "task-01", "--planner", "mine:make")
    assert "has its code in the domain folder" in said


@pytest.mark.parametrize("reason", ["tired\ud800", "tired\x1b[31m", "tired\n" * 1000])
@pytest.mark.parametrize("encoded", [True, False])
def test_what_a_planner_says_is_one_line_and_what_it_prints_is_its_own(reason: str, encoded: bool, capsys):
    def chatty(_: object) -> PlanResult:
        print("(fly item-01)")
        os.chdir("/")
        return PlanResult(PlanStatus.FAILED, (), 0.0, reason)

    mine, folder = Planner("mine", "mine", chatty), Path.cwd()
    if encoded:
        mine = pddl_planner("mine", "mine", lambda *_, **__: PlannerAnswer(PlanStatus.FAILED, reason=reason))
    said = plan(problem(), grounding(), mine).reason
    assert said.startswith("tired")
    assert said.isprintable()
    assert len(said) <= 400
    assert (capsys.readouterr().out, Path.cwd()) == ("", folder)


def leaves(*_: object, **__: object) -> PlanResult:
    raise SystemExit(5)


def answering(answer: object) -> Planner:
    return pddl_planner("mine", "mine", lambda *_, **__: answer)


@pytest.mark.parametrize(
    ("mine", "message"),
    [
        (Planner("mine", "mine", lambda _: 1 / 0), "raises an error in solve: ZeroDivisionError"),
        (Planner("mine", "mine", lambda _: "a plan"), "gives a str from solve; valid: a PlanResult"),
        (Planner("mine", "mine", leaves), "raises an error in solve: SystemExit: 5"),
        (Planner("mine", "mine", leaves, missing=lambda: 1 / 0), "raises an error in missing: ZeroDivision"),
        (answering(None), "gives a NoneType from call; valid: a PlannerAnswer"),
        (answering("(push-left-001-cube item-01)"), "gives a str from call; valid: a PlannerAnswer"),
    ],
)
def test_a_planner_that_fails_is_named(mine: Planner, message: str):
    with pytest.raises(InvalidPlanner, match=f"The planner mine {message}"):
        plan(problem(), grounding(), mine)


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


@pytest.mark.parametrize("reads", ["operators", "network"])
@pytest.mark.parametrize("name", ["mine", "bfs"])
@pytest.mark.parametrize(
    ("step", "said"),
    [
        (PlanStep("push-forward-010-cube", "item-01"), ""),
        (PlanStep("push-left-001-cube", "item-01"), "its plan is not true when replayed: item-01 ends"),
        (PlanStep("fly", "item-01"), "its plan names what there is not: There is no operator 'fly'"),
        (PlanStep("push-left-001-cube", "moon"), "its plan names what there is not: There is no object"),
    ],
)
def test_a_plan_that_is_not_true_is_not_believed(step: PlanStep, said: str, name: str, reads: str):
    """The name of one of ours earns no trust. Who reads the network may plan what it alone foresees."""
    mine = Planner(name, "mine", lambda _: PlanResult(PlanStatus.SOLVED, (step,), 0.0), reads=reads)
    found = plan(toy_problem({"item-01": (0.68, 0.0, 0.025)}), toy_grounding(), mine)
    if reads == "network" and "replayed" in said:
        return
    assert found.reason.startswith(said)
    assert found.status is (PlanStatus.FAILED if said else PlanStatus.SOLVED)


def test_an_empty_plan_that_is_called_a_plan_fails():
    found = plan(problem(), grounding(), answering(PlannerAnswer(PlanStatus.SOLVED)))
    assert found.status is PlanStatus.FAILED
    assert "no plan was true when replayed" in found.reason


def test_a_planner_that_reads_the_network_is_shown_what_it_predicts():
    seen = []

    def solve(query):
        seen.append(query.predict)
        return PlanResult(PlanStatus.UNSOLVABLE, (), 0.0)

    for reads in ("network", "operators"):
        plan(toy_problem({}), toy_grounding(), Planner("mine", "mine", solve, reads=reads), predict=max)
    assert seen == [max, None]


def test_names_of_ours_cannot_be_taken():
    with pytest.raises(InvalidPlanner, match="counting has a name which one of ours has"):
        registry.register_planner(
            pddl_planner("counting", "", lambda *_, **__: PlannerAnswer(PlanStatus.FAILED))
        )
    assert registry.planner_named("counting").is_exact
