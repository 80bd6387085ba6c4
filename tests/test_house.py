"""The house stays one that a newcomer can hold: few rooms at the root, no circles, few stairs."""

import ast
from collections import Counter
from collections.abc import Collection
from functools import cache
from graphlib import TopologicalSorter
from pathlib import Path

from places import ROOT

from tools.package_imports import files_of

PACKAGE = ROOT / "neurosym"
MOST_AT_ROOT = 14
MOST_LINES = 600
MOST_LEVELS = 30
NO_NOUNS = {"own", "around", "among_others", "by_state", "in_turns", "saying", "telling", "asking"}


def modules(package: Path) -> dict[str, Path]:
    """The modules of a package by their dotted names; folders stand for what is in their `__init__.py`."""
    paths = {path: path.relative_to(package).with_suffix("").parts for _, _, path in files_of(package)}
    return {".".join(("neurosym", *parts)).removesuffix(".__init__"): path for path, parts in paths.items()}


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


@cache
def graph(package: Path) -> dict[str, set[str]]:
    """Which modules of a package each module imports; the lazy door of the root left out."""
    known = {name: path for name, path in modules(package).items() if name != "neurosym"}
    return {name: imports_of(path, known) - {name} for name, path in known.items()}


def levels(package: Path) -> int:
    """How many modules stand on one another in the longest chain of imports."""
    imports, depth = graph(package), dict[str, int]()
    for name in TopologicalSorter(imports).static_order():
        depth[name] = 1 + max((depth[other] for other in imports[name]), default=0)
    return max(depth.values())


def public_names(path: Path) -> set[str]:
    """Functions and constants that a module shows."""
    body = ast.parse(path.read_text()).body
    found = {node.name for node in body if isinstance(node, ast.FunctionDef)}
    for node in body:
        targets = node.targets if isinstance(node, ast.Assign) else [getattr(node, "target", None)]
        found |= {target.id for target in targets if isinstance(target, ast.Name)}
    return {name for name in found if not name.startswith("_")}


def test_root_holds_few_modules():
    assert len([name for name, folder, _ in files_of(PACKAGE) if not folder]) <= MOST_AT_ROOT


def test_no_module_is_long():
    long = {name: len(path.read_text().splitlines()) for name, path in modules(PACKAGE).items()}
    assert {name: lines for name, lines in long.items() if lines > MOST_LINES} == {}


def test_imports_make_no_circle_and_few_levels():
    assert levels(PACKAGE) <= MOST_LEVELS


def test_every_module_has_a_name_of_its_own_that_is_a_noun():
    names = [path.stem for path in modules(PACKAGE).values() if path.stem != "__init__"]
    assert [name for name, count in Counter(names).items() if count > 1] == []
    assert not NO_NOUNS & set(names)


def users(package: Path, others: tuple[Path, ...] = ()) -> dict[tuple[str, str], set[str]]:
    """Which files use each name that a module of a package defines, by module and name.

    Args:
        package: The folder of the package.
        others: Folders of tests and tools, whose files count as users.
    """
    known, found = modules(package), dict[tuple[str, str], set[str]]()
    files = {**known, **{str(path): path for folder in others for path in folder.rglob("*.py")}}
    for file, path in files.items():
        tree = ast.parse(path.read_text())
        rooms = {}
        for node in ast.walk(tree):
            if isinstance(node, ast.ImportFrom) and node.module:
                for alias in node.names:
                    if (room := f"{node.module}.{alias.name}") in known:
                        rooms[alias.asname or alias.name] = room
                    found.setdefault((node.module, alias.name), set()).add(file)
        for node in ast.walk(tree):
            if isinstance(node, ast.Attribute) and ast.unparse(node.value) in rooms:
                found.setdefault((rooms[ast.unparse(node.value)], node.attr), set()).add(file)
    return found


def lonely(package: Path, others: tuple[Path, ...] = ()) -> list[str]:
    """Public functions and constants that one module uses at most, in the folder where they are made."""
    used, found = users(package, others), []
    for module, path in modules(package).items():
        folder = module.rpartition(".")[0]
        for name in sorted(public_names(path)):
            homes = {user.rpartition(".")[0] for user in used.get((module, name), ())}
            if len(used.get((module, name), ())) <= 1 and homes <= {folder}:
                found.append(f"{module}.{name}")
    return found
