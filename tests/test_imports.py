"""Imports point one way, and what is slow to load is loaded only where it is used."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

PACKAGE = Path(__file__).parent.parent / "neurosym"
FENCES = {
    "pybullet": {"sim/bullet.py"},
    "torch": {
        "effect_model.py",
        "effect_network.py",
        "direct_model.py",
        "meanings.py",
        "samples.py",
        "network_inputs.py",
        "curiosity.py",
        "fitting.py",
        "recipes.py",
        "teaching.py",
        "distillation.py",
    },
    "unified_planning": {"planners/unified_planning.py"},
    "gymnasium": {"gymnasium_env.py"},
    "ray": {"ray_workers.py"},
}
EARLIER_AND_LATER = [
    (("world", "symbols", "files", "errors", "operators", "interactions"), ("sim", "effect_model", "pddl")),
    (("sim", "toy_world"), ("effect_model", "exploration", "pddl", "planners", "execution")),
    (
        ("effect_model", "direct_model", "curiosity", "training", "exploration", "distillation", "rehearsal"),
        ("pddl", "planners", "sim"),
    ),
    (("pddl",), ("planners", "execution", "effect_model", "sim")),
    (("planners",), ("execution", "effect_model", "sim")),
    (("execution",), ("effect_model", "sim", "commands")),
]


def imported(path: Path) -> set[str]:
    """Names of all modules that a file imports, anywhere in it."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module:
            found.add(node.module)
    return found


def breaches(package: Path, fence: str, allowed: set[str]) -> list[str]:
    """Files that import a fenced dependency without being allowed to."""
    files = {path.relative_to(package).as_posix(): imported(path) for path in package.rglob("*.py")}
    return [
        name
        for name, modules in files.items()
        if any(module.split(".")[0] == fence for module in modules)
        and not any(name.startswith(place) for place in allowed)
    ]


def backward(package: Path, earlier: str, later: str) -> list[str]:
    """Files of an earlier stage that import a later one."""
    files = [*package.glob(f"{earlier}.py"), *(package / earlier).glob("*.py")]
    prefix = f"neurosym.{later}"
    return [
        path.name
        for path in files
        if any(module == prefix or module.startswith(f"{prefix}.") for module in imported(path))
    ]


@pytest.mark.parametrize("fence", FENCES)
def test_dependency_is_imported_only_behind_its_fence(fence):
    assert breaches(PACKAGE, fence, FENCES[fence]) == []


def test_fence_notices_a_breach(tmp_path):
    (tmp_path / "execution.py").write_text("def f():\n    import torch\n")
    assert breaches(tmp_path, "torch", FENCES["torch"]) == ["execution.py"]


@pytest.mark.parametrize(("earlier", "later"), EARLIER_AND_LATER)
def test_no_earlier_stage_imports_a_later_one(earlier, later):
    assert [found for e in earlier for name in later if (found := backward(PACKAGE, e, name))] == []


def test_backward_import_is_noticed(tmp_path):
    (tmp_path / "pddl").mkdir()
    (tmp_path / "pddl" / "grid.py").write_text("from neurosym.planners import plan\n")
    assert backward(tmp_path, "pddl", "planners") == ["grid.py"]


def loaded_by(statement: str) -> set[str]:
    code = f"{statement}\nimport sys\nprint(' '.join(sys.modules))"
    output = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return set(output.stdout.split())


@pytest.mark.parametrize(
    "statement",
    [
        "import neurosym",
        "import neurosym.cli",
        "import neurosym.learning_commands",
        "from neurosym import plan, execute",
    ],
)
def test_import_loads_neither_torch_nor_pybullet(statement):
    assert not loaded_by(statement) & {"torch", "pybullet", "unified_planning"}


def test_a_module_that_loads_torch_would_be_noticed():
    assert "torch" in loaded_by("from neurosym import train")


def test_no_module_is_longer_than_300_lines():
    lengths = {path.name: len(path.read_text().splitlines()) for path in PACKAGE.rglob("*.py")}
    assert {name: length for name, length in lengths.items() if length > 300} == {}
