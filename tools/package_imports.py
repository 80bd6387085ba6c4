"""Which folders of the package import which, read from the code without running it."""

import ast
from collections.abc import Iterator
from functools import cache
from pathlib import Path

DOORS = {"__init__.py", "__main__.py"}
"""Files of the root that lead into the folders: the Python API and the command line."""


def imported(path: Path, package: Path) -> set[str]:
    """Name all modules that a file of a package imports, anywhere in it, as `neurosym.folder.module`."""
    return _named(path.read_text(), ("neurosym", *path.relative_to(package).parent.parts))


@cache
def _named(text: str, here: tuple[str, ...]) -> set[str]:
    found: set[str] = set()
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import):
            found |= {alias.name for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            module = node.module or ""
            if node.level:
                module = ".".join([*here[: len(here) - node.level + 1], *filter(None, [module])])
            found |= {f"neurosym.{alias.name}" for alias in node.names} if module == "neurosym" else {module}
        elif isinstance(node, ast.Call) and ast.unparse(node.func).endswith(("import_module", "__import__")):
            found |= {str(name.value) for name in node.args[:1] if isinstance(name, ast.Constant)}
    return found


def layer_of(module: str, package: Path) -> str | None:
    """Return the folder that a module of ours lies in, "" for the root; None for one that does not exist."""
    parts = module.split(".")[1:]
    if not parts:
        return None  # the whole package, whose names are imported lazily from anywhere
    is_folder = (package / parts[0]).is_dir()
    place = package.joinpath(*parts)
    if not place.is_dir() and not place.with_suffix(".py").is_file():
        return None
    return parts[0] if is_folder else ""


def files_of(package: Path) -> Iterator[tuple[str, str, Path]]:
    """Give the name of each file of a package, its folder ("" for the root), and its path."""
    for path in sorted(package.rglob("*.py")):
        parts = path.relative_to(package).parts
        yield "/".join(parts), parts[0] if len(parts) > 1 else "", path


def arrows(package: Path) -> dict[str, set[str]]:
    """Return for each folder those that it imports, besides itself and the root."""
    found: dict[str, set[str]] = {}
    for name, folder, path in files_of(package):
        if name not in DOORS and folder:
            ours = (module for module in imported(path, package) if module.split(".")[0] == "neurosym")
            targets = {layer_of(module, package) for module in ours} - {None, "", folder}
            found.setdefault(folder, set()).update(target for target in targets if target)
    return found
