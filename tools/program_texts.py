"""What a user reads of the program itself: messages, help, comments of domains, the page of `report`."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

_SAID = {"say", "arg", "comment"}  # functions whose texts a user reads, besides what is raised
_BLOCK = re.compile(r"</(?:p|li|h\d|td|th|figcaption|summary|caption|dd|dt)>|{%.*?%}", flags=re.S)


def program_texts(root: Path) -> dict[str, list[str]]:
    """Return the texts of each kind, a paragraph each."""
    package = root / "neurosym"
    modules = [ast.parse(path.read_text()) for path in sorted(package.rglob("*.py"))]
    commands = [ast.parse(path.read_text()) for path in sorted((package / "commands").glob("*.py"))]
    domains, pages = root.glob("domains/*/domain*.pddl"), package.glob("report/templates/*.html")
    return {
        "messages and help": [text for module in modules for text in _said(module)],
        "help of commands": [text for module in commands for text in _about_commands(module)],
        "comments of domains": [text for path in sorted(domains) for text in _comments(path.read_text())],
        "page of a domain": [text for path in sorted(pages) for text in _shown(path.read_text())],
    }


def _said(module: ast.Module) -> Iterator[str]:
    for node in ast.walk(module):
        if isinstance(node, ast.Raise) and isinstance(node.exc, ast.Call):
            yield from map(_text, node.exc.args)
        elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in _SAID:
            yield from map(_text, [*node.args, *(one.value for one in node.keywords if one.arg == "help")])


def _about_commands(module: ast.Module) -> Iterator[str]:
    for node in module.body:
        if isinstance(node, ast.FunctionDef) and not node.name.startswith("_"):
            yield from (ast.get_docstring(node) or "").split("Args:")[0].split("\n\n")


def _text(node: ast.expr) -> str:
    """Return what is written, with a word for each value that is filled in; empty if it is no text."""
    if isinstance(node, ast.JoinedStr):
        return "".join(_text(part) for part in node.values)
    if isinstance(node, ast.FormattedValue):
        return "x"
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else ""


def _comments(text: str) -> list[str]:
    """Return the comments of a domain; lines of one comment are one text, and rows of tables are none."""
    text = re.sub(r"^;   .*\n", "", text, flags=re.M)
    found = re.findall(r"(?:^[ ]*;.*\n)+", text, flags=re.M)
    return [" ".join(line.strip().lstrip("; ") for line in block.splitlines()) for block in found]


def _shown(text: str) -> list[str]:
    """Return what stands between the tags of a template, with a word for each value that is filled in."""
    text = re.sub(r"<(style|script|svg|pre).*?</\1>|{#.*?#}", "", text, flags=re.S)
    parts = _BLOCK.split(re.sub(r"{{.*?}}", "x", text, flags=re.S))
    return [" ".join(re.sub(r"<[^>]*>", " ", part).split()) for part in parts]
