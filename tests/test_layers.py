"""Folders are the steps of the flow: imports point one way, and what is heavy stays behind its fence."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest
from places import DOCS, ROOT

from tools.draw_architecture import drawing
from tools.package_imports import DOORS, arrows, files_of, imported, layer_of

PACKAGE = ROOT / "neurosym"
LAYERS = {
    "tasks": "",
    "sim": "",
    "worlds": "sim tasks",
    "data": "",
    "learning": "data tasks",
    "exploration": "worlds data learning",
    "primitives": "worlds data learning tasks",
    "pddl": "tasks",
    "planners": "tasks pddl",
    "execution": "tasks pddl planners",
    "pictures": "worlds data primitives tasks pddl execution",
    "stages": ("worlds data learning exploration primitives tasks pddl planners execution pictures"),
    "evaluation": "worlds data learning primitives tasks pddl planners execution stages",
    "report": "worlds data learning tasks pddl execution pictures stages evaluation",
    "studio": "worlds data learning tasks pddl planners execution pictures stages report",
    "commands": (
        "worlds data learning tasks pddl planners execution pictures stages evaluation report studio"
    ),
}
"""The folders in the order of the flow, each with those it may import besides the root.

The root holds the nouns that cross folders, and imports no folder.
"""
FENCES = {
    "pybullet": ("sim/config.py",),
    "pybullet_data": ("sim/config.py",),
    "pybullet_utils": ("sim/config.py",),
    "torch": ("learning/", "exploration/", "primitives/distillation.py"),
    "unified_planning": ("planners/unified_planning.py",),
    "gymnasium": ("worlds/gymnasium_env.py",),
    "trimesh": ("studio/",),
    "viser": ("studio/",),
}
"""Where each heavy or optional dependency may be imported, at the head of a file or inside a function."""
MAY_PRINT = ("commands/", "stages/")
PRINTERS = {"neurosym.stages.console", "rich"}
"""Modules that are imported for printing."""
OPENERS = (
    "open",
    "fdopen",
    "ZipFile",
    "read_text",
    "read_bytes",
    "fromfile",
    "memmap",
    "safe_open",
    "load_file",
)
LOADERS = {"np", "numpy", "torch", "json", "pickle", "marshal", "tomllib"}
OPENED_ELSEWHERE = {
    "data/archives.py": {"np.load": "what the door opened"},
    "execution/record.py": {"_CPUINFO.read_text": "the system's own"},
    "commands/ending.py": {"os.open": "the null device"},
    "stages/console.py": {"os.open": "the null device"},
    "planners/keeper.py": {"Path(f'/proc/{process}/{what}').read_bytes": "the system's own"},
    "planners/process.py": {"source_file.open": "what we wrote for the planner"},
    "sim/config.py": {"os.open": "the null device"},
    "sim/interaction.py": {"self._robot.open": "a gripper"},
}
"""What is opened past the door, `neurosym/files.py`, and why: no file that a user may have put there."""


def wrong_arrows(package: Path) -> list[str]:
    """Imports that do not point at the root, their own folder, or one of those that their layer names."""
    found = []
    for name, layer, path in files_of(package):
        if name in DOORS:
            continue
        allowed = {"", layer, *LAYERS.get(layer, "").split()}
        for module in sorted(imported(path, package)):
            if module.split(".")[0] == "neurosym" and layer_of(module, package) not in allowed:
                found.append(f"{name} -> {module}")
    return found


def without_layer(package: Path) -> list[str]:
    """Files in a folder that is no layer, or deeper than one."""
    return [
        name
        for name, layer, _ in files_of(package)
        if (layer and layer not in LAYERS) or len(name.split("/")) > 2
    ]


def breaches(package: Path, fence: str) -> list[str]:
    """Files outside its fence that import a dependency."""
    return [
        name
        for name, _, path in files_of(package)
        if any(module.split(".")[0] == fence for module in imported(path, package))
        and not name.startswith(FENCES[fence])
    ]


def printing(package: Path) -> list[str]:
    """Files that print, and may not."""
    found = []
    for name, _, path in files_of(package):
        if name.startswith(MAY_PRINT):
            continue
        body = [node for node in ast.parse(path.read_text()).body if not is_main(node)]
        nodes = [node for part in body for node in ast.walk(part)]
        streams = {ast.unparse(node) for node in nodes if isinstance(node, ast.Attribute)}
        prints = any(isinstance(node, ast.Name) and node.id == "print" for node in nodes)
        modules = {module for module in imported(path, package) if module.startswith(tuple(PRINTERS))}
        modules |= {
            node.module for node in nodes if isinstance(node, ast.ImportFrom) and node.module == "sys"
        }
        if prints or modules or streams & {"sys.stdout", "sys.stderr"}:
            found.append(name)
    return found


def past_the_door(package: Path) -> list[str]:
    """Calls that open or read a file anywhere but in the one module that bounds what comes in."""
    found = []
    for name, _, path in files_of(package):
        if name == "files.py":
            continue
        calls = [node.func for node in ast.walk(ast.parse(path.read_text())) if isinstance(node, ast.Call)]
        for call in calls:
            words = ast.unparse(call).rsplit(".", 1)
            opens = words[-1] in OPENERS and (len(words) == 2 or words[-1] == "open")
            loads = words[-1] in ("load", "loadtxt", "genfromtxt") and words[0] in LOADERS
            known = OPENED_ELSEWHERE.get(name, {})
            if (opens or loads or words[0] == "tomllib") and ast.unparse(call) not in known:
                found.append(f"{name}: {ast.unparse(call)}")
    return found


def is_main(node: ast.AST) -> bool:
    """Whether a node is what a file does when it is run as a program of its own."""
    return isinstance(node, ast.If) and ast.unparse(node.test) == "__name__ == '__main__'"


def test_every_module_lies_in_a_layer():
    assert without_layer(PACKAGE) == []
    assert {path.parent.name for path in PACKAGE.glob("*/__init__.py")} == LAYERS.keys()


def test_every_layer_names_only_layers_before_it():
    order = list(LAYERS)
    for number, folders in enumerate(LAYERS.values()):
        assert set(folders.split()) <= set(order[:number])


def test_imports_point_one_way():
    assert wrong_arrows(PACKAGE) == []


@pytest.mark.parametrize("fence", FENCES)
def test_dependency_is_imported_only_behind_its_fence(fence: str):
    assert breaches(PACKAGE, fence) == []
    assert all((PACKAGE / place).exists() for place in FENCES[fence])


def test_picture_of_the_folders_is_that_of_the_code(tmp_path: Path):
    picture = (DOCS / "images" / "architecture.svg").read_text()
    assert picture == drawing(arrows(PACKAGE)), "make architecture draws it anew"
    fewer = {folder: targets - {"planners"} for folder, targets in arrows(PACKAGE).items()}
    assert picture != drawing(fewer)


def test_only_the_command_line_prints():
    assert printing(PACKAGE) == []


def test_files_are_read_through_one_door():
    assert past_the_door(PACKAGE) == []
    for name, calls in OPENED_ELSEWHERE.items():
        assert all(call in ast.unparse(ast.parse((PACKAGE / name).read_text())) for call in calls), name


@pytest.fixture
def package(tmp_path: Path) -> Path:
    """A package with a module in `pddl` and one in `planners`, to be broken."""
    for folder in ("pddl", "planners"):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "__init__.py").write_text("")
    (tmp_path / "pddl" / "grid.py").write_text("import math\n")
    (tmp_path / "problems.py").write_text("")
    (tmp_path / "planners" / "bfs.py").write_text("from neurosym.pddl.grid import cells\n")
    assert (without_layer(tmp_path), wrong_arrows(tmp_path), printing(tmp_path)) == ([], [], [])
    return tmp_path


@pytest.mark.parametrize(
    ("name", "line"),
    [
        ("pddl/grid.py", "from neurosym.planners import plan"),
        ("pddl/grid.py", "from neurosym.planners.bfs import plan_bfs"),
        ("pddl/grid.py", "import neurosym.planners.bfs"),
        ("pddl/grid.py", "from ..planners import bfs"),
        ("pddl/grid.py", "from neurosym import planners"),
        ("pddl/grid.py", "from neurosym import plan"),
        ("pddl/grid.py", "import neurosym"),
        ("pddl/grid.py", "from importlib import import_module\nimport_module('neurosym.planners.bfs')"),
        ("pddl/grid.py", "from neurosym.gone import plan"),
        ("pddl/grid.py", "def f():\n    from neurosym.planners import plan"),
        ("problems.py", "from neurosym.pddl.grid import cells"),
        ("planners/bfs.py", "from neurosym.execution.executor import execute"),
    ],
)
def test_an_arrow_that_goes_the_wrong_way_is_noticed(package: Path, name: str, line: str):
    (package / name).write_text(line + "\n")
    assert [arrow.split(" -> ")[0] for arrow in wrong_arrows(package)] == [name]


@pytest.mark.parametrize("name", ["utils/grid.py", "pddl/deeper/grid.py"])
def test_a_module_without_a_layer_is_noticed(package: Path, name: str):
    (package / name).parent.mkdir()
    (package / name).write_text("")
    assert without_layer(package) == [name]


@pytest.mark.parametrize("fence", FENCES)
@pytest.mark.parametrize(
    "line", ["import {0}", "def f():\n    from {0}.x import y", "import {0} as other", "__import__('{0}')"]
)
def test_a_breach_of_a_fence_is_noticed(package: Path, fence: str, line: str):
    (package / "pddl" / "grid.py").write_text(line.format(fence) + "\n")
    assert breaches(package, fence) == ["pddl/grid.py"]


@pytest.mark.parametrize(
    "line",
    [
        "print('x')",
        "from neurosym.stages.console import say",
        "import sys\nsys.stdout.write('x')",
        "import rich.table",
    ],
)
def test_printing_is_noticed(package: Path, line: str):
    (package / "pddl" / "grid.py").write_text(line + "\n")
    assert printing(package) == ["pddl/grid.py"]


@pytest.mark.parametrize(
    "line",
    [
        "open('x')",
        "Path('x').read_text()",
        "np.load('x')",
        "tomllib.loads('x')",
        "torch.load('x')",
        "x.open()",
    ],
)
def test_reading_past_the_door_is_noticed(package: Path, line: str):
    (package / "pddl" / "grid.py").write_text(line + "\n")
    assert len(past_the_door(package)) == 1


def loaded_by(statement: str) -> set[str]:
    code = f"{statement}\nimport sys\nprint(' '.join(sys.modules))"
    output = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    return set(output.stdout.split())


@pytest.mark.parametrize(
    "statement",
    ["import neurosym", "import neurosym.commands.cli", "from neurosym import plan, execute"],
)
def test_import_loads_neither_torch_nor_pybullet(statement: str):
    assert not loaded_by(statement) & {"torch", "pybullet", "unified_planning"}


def test_a_module_that_loads_torch_would_be_noticed():
    assert "torch" in loaded_by("from neurosym import train")


def test_no_module_is_longer_than_600_lines():
    lengths = {path.name: len(path.read_text().splitlines()) for path in PACKAGE.rglob("*.py")}
    assert {name: length for name, length in lengths.items() if length > 600} == {}
