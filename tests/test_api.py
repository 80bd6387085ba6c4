"""The Python API: the whole way without a file, names at the root, and types that reach the user."""

import ast
import subprocess
import sys

import pytest
from documents import python_blocks
from places import ROOT
from toy_learning import SHORTENED

import neurosym
from neurosym.learning.training_config import REGIMES

NOUNS = (
    *("World", "Scene", "Outcome", "Interactions", "Primitive", "Operator", "OperatorTable", "Grounding"),
    *("Problem", "Planner", "PlanStep", "PlanResult", "PlanStatus", "Run", "NeurosymError"),
)
THE_WHOLE_WAY = python_blocks("manual.md")[0]


@pytest.mark.parametrize("as_it_stands", [False, pytest.param(True, marks=pytest.mark.evaluation)])
def test_the_whole_way_runs_in_twenty_lines_without_a_file(as_it_stands, tmp_path, monkeypatch, capsys):
    assert len(THE_WHOLE_WAY.splitlines()) <= 20
    monkeypatch.chdir(tmp_path)
    names: dict[str, object] = {}
    code = THE_WHOLE_WAY
    if not as_it_stands:  # a third of the time
        monkeypatch.setitem(REGIMES, "quick", SHORTENED)
        code = code.replace("steps=1024", "steps=512").replace("objects=40", "objects=20")
    exec(compile(code, "manual.md", "exec"), names)
    assert names["run"].reached
    assert list(tmp_path.iterdir()) == []
    assert capsys.readouterr().out.startswith("PlanStatus.SOLVED [")


def test_names_can_be_imported_from_the_root_and_no_others():
    for name in (*NOUNS, *neurosym.__all__):
        assert getattr(neurosym, name).__class__ is not None
        assert name in dir(neurosym)
    with pytest.raises(AttributeError, match="'neurosym' has no attribute 'divine'"):
        neurosym.divine  # noqa: B018 (it is looked up)


def test_type_checkers_are_told_of_each_name_from_where_it_comes():
    """The block for type checkers and the table of lazy imports say the same."""
    tree = ast.parse((ROOT / "neurosym/__init__.py").read_text())
    (block,) = (n for n in tree.body if isinstance(n, ast.If) and ast.unparse(n.test) == "TYPE_CHECKING")
    told = {alias.asname: node.module for node in block.body for alias in node.names}
    assert told == neurosym._HOMES


WRONG = {
    "import choose,": "import divine, choose,",
    "seed=0)\nmodel": "sead=0)\nmodel",
    '"fast-downward")': '"fast-downward", time_limit="1")',
    "grounding, result.steps)": "grounding, 3)",
}


def test_the_whole_way_passes_a_strict_type_check_and_wrong_calls_do_not(tmp_path):
    wrong = THE_WHOLE_WAY
    for right, replaced in WRONG.items():
        assert right in wrong
        wrong = wrong.replace(right, replaced)
    (tmp_path / "right.py").write_text(THE_WHOLE_WAY)
    (tmp_path / "wrong.py").write_text(wrong)
    (tmp_path / "mypy.ini").write_text(
        "[mypy]\nstrict = True\n[mypy-torch.*,scipy.*,PIL.*,jinja2.*,rich.*]\nfollow_imports = skip\n"
    )  # what is large, and not ours, is not looked at: that takes a fifth of the time
    command = [sys.executable, "-m", "mypy", "--cache-dir", "cache", "right.py", "wrong.py"]
    ran = subprocess.run(command, capture_output=True, text=True, cwd=tmp_path)
    assert not ran.stderr, ran.stderr
    errors = [line.split(":")[:2] for line in ran.stdout.splitlines() if ": error:" in line]
    assert {file for file, _ in errors} == {"wrong.py"}
    assert len({line for _, line in errors}) == len(WRONG)
