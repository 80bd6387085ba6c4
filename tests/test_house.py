"""The house stays one that a newcomer can hold: few rooms at the root, no circles, few stairs."""

import ast
from collections import Counter
from collections.abc import Collection
from graphlib import TopologicalSorter
from pathlib import Path

from places import ROOT

from tools.package_imports import files_of

PACKAGE = ROOT / "neurosym"
PATHS = [path for _, _, path in files_of(PACKAGE)]
MOST_AT_ROOT, MOST_LINES, MOST_LEVELS = 14, 600, 30
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
