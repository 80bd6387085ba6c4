"""The Python API: the whole way without a file, names at the root, and types that reach the user."""

import ast
import subprocess
import sys

import pytest
from documents import python_blocks
from places import ROOT

import neurosym

NOUNS = (
    *("World", "Scene", "Outcome", "Interactions", "Primitive", "Operator", "OperatorTable", "Grounding"),
    *("Problem", "Planner", "PlanStep", "PlanResult", "PlanStatus", "Run", "NeurosymError"),
)
THE_WHOLE_WAY = python_blocks("manual.md")[0]


def test_the_whole_way_runs_in_twenty_lines_without_a_file(tmp_path, monkeypatch, capsys):
    assert len(THE_WHOLE_WAY.splitlines()) <= 20
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    exec(compile(THE_WHOLE_WAY, "manual.md", "exec"), names)
    assert names["run"].reached
    assert list(tmp_path.iterdir()) == []
    assert capsys.readouterr().out.startswith("PlanStatus.SOLVED [")


@pytest.mark.parametrize("name", [*NOUNS, *neurosym.__all__])
def test_name_can_be_imported_from_the_root(name: str):
    assert getattr(neurosym, name).__class__ is not None
    assert name in dir(neurosym)


def test_unknown_name_is_refused():
    with pytest.raises(AttributeError, match="'neurosym' has no attribute 'divine'"):
        neurosym.divine  # noqa: B018 (it is looked up)


def test_type_checkers_are_told_of_each_name_from_where_it_comes():
    """The block for type checkers and the table of lazy imports say the same."""
    tree = ast.parse((ROOT / "neurosym/__init__.py").read_text())
    (block,) = (n for n in tree.body if isinstance(n, ast.If) and ast.unparse(n.test) == "TYPE_CHECKING")
    told = {alias.asname: node.module for node in block.body for alias in node.names}
    assert told == neurosym._HOMES


USER = """
from pathlib import Path

import numpy as np

import neurosym
from neurosym import Grounding, Interactions, NeurosymError, OperatorTable, Planner, PlannerAnswer, PlanResult
from neurosym import PlanStatus, Problem, Query, Run, World, check_world, choose, compile_domain, distill
from neurosym import draw_problem, execute, explore, pddl_planner, plan, register_planner, rehearse, tabulate
from neurosym import train
from neurosym.worlds.toy import make_world


def call(domain: Path, problem: Path, *, time_limit: float) -> PlannerAnswer:
    return PlannerAnswer(PlanStatus.FAILED, reason=f"no plan for {problem} in {time_limit} s")


def whole_way(seed: int) -> Run:
    world: World = make_world()
    check_world(world)
    data: Interactions = explore(make_world, steps=100, strategy="random", seed=seed)
    trained = train(data, seed=seed)
    candidates = distill(trained.model, data, world.action_box, seed=seed)
    primitives = choose(
        candidates,
        "lowest-error",
        predict=trained.direct.predict_outcomes,
        features=data.features,
        categorise=trained.model.object_symbols,
        world_factory=make_world,
        seed=seed,
    )
    rehearsals = rehearse(make_world, primitives, trained.model.object_symbols, seed=seed)
    table: OperatorTable = tabulate(rehearsals, world.feature_names)
    grounding: Grounding = compile_domain(
        table, name=world.name, table_bounds=world.table, lift_height=world.lift_height
    )
    problem: Problem = draw_problem(world, trained.model.object_symbols, name="p", objects=1, seed=seed)
    mine: Planner = pddl_planner("mine", "mine", call)
    register_planner(mine)
    result: PlanResult = mine.solve(Query(problem, grounding))
    try:
        result = plan(problem, grounding, "mine", time_limit=1.0)
    except NeurosymError as error:
        print(error)
    print(neurosym.__version__, np.asarray(data.effects).shape)
    return execute(world, problem, grounding, result.steps)
"""
WRONG = {
    "return execute(world, problem, grounding, result.steps)": "return execute(world, problem, grounding, 3)",
    'plan(problem, grounding, "mine", time_limit=1.0)': 'plan(problem, grounding, "mine", time_limit="1")',
    "check_world(world)": "neurosym.divine(world)",
    "train(data, seed=seed)": "train(data, sead=seed)",
}


def test_a_users_script_that_calls_every_verb_passes_a_strict_type_check_and_wrong_calls_do_not(tmp_path):
    wrong = USER
    for right, replaced in WRONG.items():
        assert right in wrong
        wrong = wrong.replace(right, replaced)
    (tmp_path / "right.py").write_text(USER)
    (tmp_path / "wrong.py").write_text(wrong)
    command = [sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(ROOT / ".mypy_cache"), "."]
    ran = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path)
    assert not ran.stderr, ran.stderr
    errors = [line.split(":")[:2] for line in ran.stdout.splitlines() if ": error:" in line]
    assert {file for file, _ in errors} == {"wrong.py"}
    assert len({line for _, line in errors}) == len(WRONG)
