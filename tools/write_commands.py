"""Writes docs/commands.md, the reference of the command line, from what the commands say of themselves.

The command is `python -m tools.write_commands`; a test says when it is to be run again.
"""

import inspect
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Annotated, Any, get_args, get_origin, get_type_hints

from neurosym.commands.catalogue import GROUPS, SUMMARIES, command_named
from neurosym.files import write_atomically
from neurosym.stages.console import say
from tools.benchmarks.tables import table

PAGE = Path("docs/commands.md")
HEAD = """# Commands

Everything about one learned domain lies in one folder, `DIR`. Each command reads what stands there and adds
its own files; [the manual](manual.md#files-of-a-domain-folder) says what they hold. `tabletop`, `places`,
`towers`, `camera` and `tabletop-paper` name the domains that come with neurosym. Such a domain is copied into
the current folder when a command first names it; all results go to the copy.

Any command takes `--help`, and `--quiet`, with which it prints only what goes wrong. `neurosym --version`
says which neurosym this is. `neurosym --tyro-print-completion bash` (or `zsh`, `tcsh`) prints a completion
script for your shell.

Exit codes: 0 done; 2 bad input, with one sentence that says what would be valid; 3 the work was done and the
answer is no (no plan, goal missed); 130 interrupted; 128 + N ended by signal N.

`python -m tools.write_commands` wrote this page."""


def main() -> None:
    """Write the page."""
    write_atomically(PAGE, page())
    say(f"wrote {PAGE}")


def page() -> str:
    """Return the page."""
    links = {title: [f"[{name}](#{name})" for name in group] for title, group in GROUPS.items()}
    groups = (f"- {title}: {', '.join(group)}" for title, group in links.items())
    sections = (section(name, command_named(name)) for name in SUMMARIES)
    return "\n\n".join([HEAD, "\n".join(groups), *sections]) + "\n"


def section(name: str, command: Callable[..., int]) -> str:
    """Write what there is to know about a command."""
    rows = [*_rows(command)]
    places = " ".join(word for word, _, default in rows if not word.startswith("--"))
    listed = table(["", "what", "default"], [[f"`{word}`", *rest] for word, *rest in rows])
    usage = f"```text\nneurosym {name} {places}".rstrip() + " [OPTIONS]\n```"
    return f"## {name}\n\n{usage}\n\n{inspect.getdoc(command)}\n\n{listed}"


def _rows(command: Callable[..., int]) -> Iterator[tuple[str, str, str]]:
    """Yield what a command takes: how it is typed, what it is, and what it is if it is not typed."""
    hints = get_type_hints(command, include_extras=True)
    for name, parameter in inspect.signature(command).parameters.items():
        kind = hints[name]
        about = [said for said in _said(kind) if hasattr(said, "help")]
        words = " ".join(said.help for said in about[:1] if said.help)
        metavar = next((said.metavar for said in about if said.metavar), name.upper())
        is_place = parameter.default is inspect.Parameter.empty or "Positional" in repr(_said(kind))
        word = metavar if is_place else f"--{name.replace('_', '-')}"
        default = "one for each core" if name == "workers" else _default(parameter.default)
        yield word, words.replace("|", "\\|"), default


def _said(kind: Any) -> list[Any]:
    """List what stands beside a type, however deep."""
    if get_origin(kind) is not Annotated:
        return []
    inner, *said = get_args(kind)
    return [*said, *_said(inner)]


def _default(value: Any) -> str:
    if value is inspect.Parameter.empty or value is None or value is False:
        return ""
    return " ".join(map(str, value)) if isinstance(value, tuple) else str(value)


if __name__ == "__main__":
    main()
