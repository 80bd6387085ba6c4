"""Folders are the steps of the flow, and the house stays one that a newcomer can hold."""

import ast
import subprocess
import sys
from collections import Counter
from collections.abc import Callable, Collection
from functools import cache
from graphlib import TopologicalSorter
from pathlib import Path

import pytest
from places import DOCS, ROOT

from tools.draw_architecture import drawing
from tools.package_imports import DOORS, arrows, files_of, imported, layer_of

PACKAGE = ROOT / "neurosym"
LAYERS = {
    "tasks": "",
    "data": "",
    "perception": "data",
    "sim": "perception",
    "worlds": "perception sim tasks data",
    "learning": "data tasks perception",
    "exploration": "worlds data learning",
    "primitives": "worlds data learning tasks",
    "pddl": "data tasks",
    "planners": "data tasks pddl",
    "values": "data tasks pddl planners",
    "execution": "tasks pddl planners",
    "pictures": "worlds data primitives tasks pddl execution",
    "stages": "perception worlds data learning exploration primitives tasks pddl planners execution pictures "
    "values",
    "evaluation": "worlds data learning primitives tasks pddl planners values execution stages",
    "report": "worlds data learning tasks pddl values execution pictures stages evaluation",
    "studio": "worlds data learning tasks pddl planners execution pictures stages report",
    "commands": "worlds data learning tasks pddl planners values execution pictures stages evaluation report "
    "studio",
}
"""The folders in the order of the flow, each with those it may import besides the root.

The root holds the nouns that cross folders, and imports no folder.
"""
FENCES = {
    "mujoco": ("sim/mujoco_engine.py",),
    "pybullet": ("sim/config.py",),
    "pybullet_data": ("sim/config.py",),
    "pybullet_utils": ("sim/config.py",),
    "torch": ("learning/", "exploration/", "primitives/distillation.py", "data/foreign_tables.py"),
    "unified_planning": ("planners/unified_planning.py",),
    "gymnasium": ("worlds/gymnasium_env.py",),
    "trimesh": ("studio/",),
    "viser": ("studio/",),
}
"""Where each heavy or optional dependency may be imported, at the head of a file or inside a function."""
MAY_PRINT = ("commands/", "stages/")
PRINTERS = ("neurosym.stages.console", "rich")
"""Modules that are imported for printing."""
OPENERS = {"open", "fdopen", "ZipFile", "read_text", "read_bytes", "fromfile", "memmap"}
OPENERS |= {"safe_open", "load_file"}
LOADERS = {"np", "numpy", "torch", "json", "pickle", "marshal", "tomllib"}
OPENED_ELSEWHERE = {
    "data/archives.py": {"np.load": "what the door opened"},
    "data/foreign_tables.py": {"np.load": "what the door opened", "torch.load": "the same, weights only"},
    "execution/record.py": {"_CPUINFO.read_text": "the system's own"},
    "commands/ending.py": {"os.open": "the null device"},
    "stages/console.py": {"os.open": "the null device"},
    "planners/keeper.py": {"entry.read_bytes": "the system's own"},
    "planners/external.py": {"source_file.open": "what we wrote for the planner"},
    "sim/config.py": {"os.open": "the null device"},
    "sim/interaction.py": {"self._robot.open": "a gripper"},
}
"""What is opened past the door, `neurosym/files.py`, and why: no file that a user may have put there."""


def wrong_arrows(package: Path) -> list[str]:
    """Files that import more than the root, their own folder, and those that their layer names."""
    return [
        name
        for name, layer, path in files_of(package)
        for module in imported(path, package)
        if name not in DOORS and module.split(".")[0] == "neurosym"
        if layer_of(module, package) not in {"", layer, *LAYERS.get(layer, "").split()}
    ]


def without_layer(package: Path) -> list[str]:
    """Files in a folder that is no layer, or deeper than one."""
    files = ((name, layer) for name, layer, _ in files_of(package))
    return [name for name, layer in files if (layer and layer not in LAYERS) or name.count("/") > 1]


def breaches(package: Path) -> list[str]:
    """Files outside its fence that import a dependency."""
    return [
        name
        for name, _, path in files_of(package)
        for fence in {module.split(".")[0] for module in imported(path, package)} & FENCES.keys()
        if not name.startswith(FENCES[fence])
    ]


def printing(package: Path) -> list[str]:
    """Files that print, and may not; what a file does as a program of its own does not count."""
    found = []
    for name, _, path in files_of(package):
        if name.startswith(MAY_PRINT):
            continue
        body = [node for node in parsed(path).body if not ast.unparse(node).startswith("if __name__ ==")]
        nodes = [node for part in body for node in ast.walk(part)]
        words = {ast.unparse(node) for node in nodes if isinstance(node, ast.Attribute | ast.Name)}
        modules = {module for module in imported(path, package) if module.startswith(PRINTERS)}
        from_sys = any(isinstance(node, ast.ImportFrom) and node.module == "sys" for node in nodes)
        if words & {"print", "sys.stdout", "sys.stderr"} or modules or from_sys:
            found.append(name)
    return found


def past_the_door(package: Path) -> list[str]:
    """Files that open or read a file anywhere but in the one module that bounds what comes in."""
    found = []
    for name, _, path in files_of(package):
        calls = [node.func for node in ast.walk(parsed(path)) if isinstance(node, ast.Call)]
        for call in map(ast.unparse, calls if name != "files.py" else ()):
            words = call.rsplit(".", 1)
            opens = words[-1] in OPENERS and (len(words) == 2 or words[-1] == "open")
            loads = words[-1] in ("load", "loadtxt", "genfromtxt") and words[0] in LOADERS
            if (opens or loads or words[0] == "tomllib") and call not in OPENED_ELSEWHERE.get(name, {}):
                found.append(name)
    return found


def parsed(path: Path) -> ast.Module:
    return _parsed(path.read_text())


_parsed = cache(ast.parse)
CHECKS = (wrong_arrows, without_layer, breaches, printing, past_the_door)


@pytest.mark.parametrize("check", CHECKS)
def test_package_is_in_order(check: Callable[[Path], list[str]]):
    assert check(PACKAGE) == []


def test_layers_fences_and_doors_are_those_of_the_package():
    assert {path.parent.name for path in PACKAGE.glob("*/__init__.py")} == LAYERS.keys()
    order = list(LAYERS)
    for number, folders in enumerate(LAYERS.values()):
        assert set(folders.split()) <= set(order[:number]), "only layers before it"
    assert all((PACKAGE / place).exists() for places in FENCES.values() for place in places)
    for name, calls in OPENED_ELSEWHERE.items():
        assert all(call in ast.unparse(parsed(PACKAGE / name)) for call in calls), name


def test_picture_of_the_folders_is_that_of_the_code():
    picture = (DOCS / "images" / "architecture.svg").read_text()
    assert picture == drawing(arrows(PACKAGE)), "make architecture draws it anew"
    fewer = {folder: targets - {"planners"} for folder, targets in arrows(PACKAGE).items()}
    assert picture != drawing(fewer)


@pytest.mark.parametrize(
    ("check", "name", "line"),
    [
        *(
            (wrong_arrows, "pddl/grid.py", line)
            for line in (
                "from neurosym.planners import plan",
                "import neurosym.planners.bfs",
                "from ..planners import bfs",
                "from neurosym import plan",
                "import neurosym",
                "from importlib import import_module\nimport_module('neurosym.planners.bfs')",
                "def f():\n    from neurosym.planners import plan",
            )
        ),
        (wrong_arrows, "problems.py", "from neurosym.pddl.grid import cells"),
        (wrong_arrows, "planners/bfs.py", "from neurosym.execution.executor import execute"),
        (without_layer, "utils/grid.py", ""),
        (without_layer, "pddl/deeper/grid.py", ""),
        *((breaches, "pddl/grid.py", f"import {fence} as other") for fence in FENCES),
        (breaches, "pddl/grid.py", "def f():\n    from torch.x import y"),
        (breaches, "pddl/grid.py", "__import__('torch')"),
        (printing, "pddl/grid.py", "print('x')"),
        (printing, "pddl/grid.py", "from neurosym.stages.console import say"),
        (printing, "pddl/grid.py", "import sys\nsys.stdout.write('x')"),
        (printing, "pddl/grid.py", "import rich.table"),
        *((past_the_door, "pddl/grid.py", f"{call}('x')") for call in ("open", "np.load", "tomllib.loads")),
        *((past_the_door, "pddl/grid.py", f"{call}()") for call in ("Path('x').read_text", "x.open")),
    ],
)
def test_what_is_out_of_order_is_noticed(
    tmp_path: Path, check: Callable[[Path], list[str]], name: str, line: str
):
    files = dict.fromkeys(("pddl/__init__.py", "planners/__init__.py", "problems.py"), "")
    files |= {"pddl/grid.py": "import math\n", "planners/bfs.py": "from neurosym.pddl.grid import cells\n"}
    for file, text in files.items():
        (tmp_path / file).parent.mkdir(exist_ok=True)
        (tmp_path / file).write_text(text)
    assert [check(tmp_path) for check in CHECKS] == [[]] * len(CHECKS)
    (tmp_path / name).parent.mkdir(exist_ok=True)
    (tmp_path / name).write_text(line + "\n")
    assert check(tmp_path) == [name]


@pytest.mark.parametrize(
    "statement",
    [
        "import neurosym.commands.cli",
        "import neurosym.commands.pipeline, neurosym.commands.tables",
        "from neurosym import plan, execute",
        "from neurosym import train",
    ],
)
def test_import_loads_what_is_heavy_only_where_it_is_needed(statement: str):
    code = f"{statement}\nimport sys\nprint(' '.join(sys.modules))"
    output = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    heavy = {*output.stdout.split()} & {"torch", "pybullet", "mujoco", "unified_planning"}
    assert heavy == ({"torch"} if "train" in statement else set())


# Few rooms at the root, no circles, few stairs

PATHS = [path for _, _, path in files_of(PACKAGE)]
MOST_AT_ROOT, MOST_LINES, MOST_LEVELS, MOST_FOR_ONE = 14, 600, 30, 240
NO_NOUNS = {"own", "around", "among_others", "by_state", "in_turns", "saying", "telling", "asking"}


def imports_of(path: Path, known: Collection[str]) -> set[str]:
    """Which modules a file imports, anywhere in it."""
    found = set()
    for node in ast.walk(ast.parse(path.read_text())):
        if isinstance(node, ast.ImportFrom) and node.module:
            rooms = {f"{node.module}.{alias.name}" for alias in node.names} & set(known)
            found |= rooms or {node.module}
        elif isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
    return found & set(known)


def test_root_holds_few_modules_and_none_is_long():
    assert sum(path.parent == PACKAGE for path in PATHS) <= MOST_AT_ROOT
    lengths = {str(path): len(path.read_text().splitlines()) for path in PATHS}
    assert {name: lines for name, lines in lengths.items() if lines > MOST_LINES} == {}


def test_imports_make_no_circle_and_few_levels():
    """In the longest chain of imports so many modules stand on one another; the lazy door is left out."""
    named = {".".join(("neurosym", *path.relative_to(PACKAGE).with_suffix("").parts)): path for path in PATHS}
    known = {name.removesuffix(".__init__"): path for name, path in named.items()}
    del known["neurosym"]
    imports = {name: imports_of(path, known) - {name} for name, path in known.items()}
    depth = dict[str, int]()
    for name in TopologicalSorter(imports).static_order():
        depth[name] = 1 + max((depth[other] for other in imports[name]), default=0)
    assert max(depth.values()) <= MOST_LEVELS


def test_every_module_has_a_name_of_its_own_that_is_a_noun():
    names = [path.stem for path in PATHS if path.stem != "__init__"]
    assert [name for name, count in Counter(names).items() if count > 1] == []
    assert not NO_NOUNS & set(names)


def test_few_names_are_public_for_a_single_neighbour():
    """What one planner offers to the registry is public for it alone; more of that is one idea cut in two."""
    users = dict[tuple[str, str], set[Path]]()
    for path in (*PATHS, *(ROOT / "tools").rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("neurosym."):
                for alias in node.names:
                    users.setdefault((node.module or "", alias.name), set()).add(path)
    rooms = {module: ROOT.joinpath(*module.split(".")[:-1]) for module, _ in users}
    for_one = [key for key, found in users.items() if {one.parent for one in found} == {rooms[key[0]]}]
    assert sum(len(users[key]) == 1 and rooms[key[0]] != PACKAGE for key in for_one) <= MOST_FOR_ONE
