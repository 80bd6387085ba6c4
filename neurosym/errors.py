"""Errors that a user can cause, each with one sentence that says what would be valid; and the words of it."""

import os
import re
import shlex
import sys
import unicodedata
from collections.abc import Callable, Iterable, Sequence
from contextlib import AbstractContextManager, nullcontext
from difflib import get_close_matches
from functools import cache
from pathlib import Path
from typing import Any, Protocol

# Paths, lengths and texts of strangers as a user reads them

PIPE_WIDTH = 160
"""Columns to print in, where there is no terminal to ask."""


def quoted(path: Path | str) -> str:
    """Return a path as it is typed in a shell: in quotes if it has blanks or the like."""
    return shlex.quote(str(path))


def harmless(text: str) -> str:
    """Return a text such that a terminal does nothing but show it.

    Control characters, which may hide text or type commands, become escapes as in Python's strings. So does
    what changes the direction of writing, and what is no character at all. Line ends and tabs stay.
    """
    return text if text.isprintable() else "".join(map(_shown, text))


def _shown(sign: str) -> str:
    if sign in "\n\t" or unicodedata.category(sign) not in ("Cc", "Cf", "Cs", "Zl", "Zp"):
        return sign
    return f"\\x{ord(sign):02x}" if ord(sign) < 256 else f"\\u{ord(sign):04x}"


def in_millimetres(distance: float, allowed: float) -> str:
    """Return a distance in whole mm, with decimals where it would look allowed and is not.

    Args:
        distance: The distance [m].
        allowed: The greatest that is allowed [m].
    """
    text = ""
    for digits in range(10):
        text = f"{1000 * distance:.{digits}f}"
        if distance <= allowed or float(text) > 1000 * allowed:
            break
    return f"{text} mm"


def counted(count: int, noun: str) -> str:
    """Return a number with its noun, which takes an s if there is not exactly one."""
    return f"{count} {noun}{'' if count == 1 else 's'}"


def listed_briefly(names: Sequence[str], most: int = 16) -> str:
    """Return names with commas between, of a long list the first ones and how many more there are.

    Args:
        names: What is listed.
        most: How many are named at most.
    """
    more = len(names) - most
    return ", ".join(names[:most]) + (f" and {more} more" if more > 0 else "")


# Errors that a user can cause, each with one sentence that says what would be valid.
#
# Expected outcomes (no plan, a time-out, a failed step) are values, not errors.

_MOST_LISTED, _LONGEST_LIST = 20, 400  # names that a sentence lists whole; its characters if there are more


class NeurosymError(Exception):
    """Base of every error that bad input can cause; the command line prints it and exits with code 2."""

    def __reduce__(self) -> tuple[Any, ...]:  # so that it also survives the way from one process to another
        return _rebuild, (type(self), str(self))


def _rebuild(kind: type[NeurosymError], message: str) -> NeurosymError:
    error = kind.__new__(kind)
    error.args = (message,)
    return error


class FolderNotFound(NeurosymError):
    """A domain folder that does not exist."""

    def __init__(self, folder: Path):
        valid = (
            "name a domain folder" if folder.exists() else f"`neurosym init {quoted(folder)}` makes a new one"
        )
        problem = f"{folder} is a file" if folder.exists() else f"There is no folder {folder}"
        super().__init__(f"{problem}; {valid}.")


class StageMissing(NeurosymError):
    """A stage was asked for before the one whose file it reads."""

    def __init__(self, missing: Path, command: str, besides: str = ""):
        super().__init__(f"{missing} is missing; `{command}` writes it{besides}.")


class InvalidFile(NeurosymError):
    """A file that is corrupt, foreign, or of another version."""

    def __init__(self, path: Path, problem: str):
        super().__init__(f"{path} cannot be used: {problem}.")


class CannotWrite(NeurosymError, OSError):
    """A file that the system does not let be written: no room, no permission, no such folder."""

    def __init__(self, path: Path, error: OSError):
        self.reason = str(error.strerror or error)
        super().__init__(f"{path} cannot be written: {self.reason}.")


class OtherLibrary(NeurosymError):
    """Another library with the same import name."""

    def __init__(self, version: str, own: str):
        super().__init__(
            f"Another library called neurosym (version {version}) is installed here, and is imported by the "
            f"same name; install {own} in an environment of its own."
        )


class FolderTaken(NeurosymError):
    """A domain folder in which another process works that it cannot be shared with."""

    def __init__(self, folder: Path, holders: Iterable[int]):
        numbers = ", ".join(map(str, holders))
        said = f"Process {numbers} works" if numbers else "Another process works"
        super().__init__(f"{said} in {folder}; wait until it has ended, or name another folder.")


class CannotStart(NeurosymError):
    """The system lets no further process or thread be started; `what` names which, like `planner`."""

    def __init__(self, what: str, why: str):
        super().__init__(
            f"No {what} can be started: {why}; allow more processes, files or memory (ulimit -a)."
        )


class InvalidData(InvalidFile):
    """A data set with all its problems, a line each."""

    def __init__(self, path: Path, problems: Iterable[str]):
        NeurosymError.__init__(self, "\n".join(str(InvalidFile(path, problem)) for problem in problems))


def shortened(text: str, longest: int = 80) -> str:
    """Cut a text that a user gave, such that it can be quoted in a sentence."""
    return text if len(text) <= longest else f"{text[: longest - 3]}..."


class UnknownChoice(NeurosymError):
    """A name that is not among the valid ones; of many, the nearest are named, and where all are listed."""

    def __init__(self, kind: str, name: str, known: Iterable[str], listed: str = ""):
        choices = sorted(known)
        valid = f"valid: {', '.join(choices) or 'none'}"
        if len(choices) > _MOST_LISTED and len(valid) > _LONGEST_LIST:
            near = get_close_matches(name[:100], choices)
            places = f" that {listed} lists" if listed else ""
            such = f"near to it: {', '.join(near)}" if near else f"such as {', '.join(choices[:3])}"
            valid = f"valid: {len(choices):,}{places}, {such}"
        super().__init__(f"There is no {kind} {shortened(name)!r}; {valid}.")


class InvalidValue(NeurosymError):
    """A number or shape outside what is possible."""


class InvalidWorld(InvalidValue):
    """A world of one's own that cannot be used; `name` is `module:factory`, or the name it has itself."""

    is_placed = False
    """Whether the message says where it was."""

    def __init__(self, name: str, problem: str):
        super().__init__(f"The world {name!r} {problem}.")

    def at(self, place: str) -> "InvalidWorld":
        """Return the same error, which also says where it was, unless it does so already.

        Args:
            place: Where, like `interaction 18`.
        """
        if self.is_placed:
            return self
        error = InvalidWorld.__new__(type(self))
        error.args, error.is_placed = (f"{str(self).removesuffix('.')} (in {place}).",), True
        return error


class InvalidArm(InvalidWorld):
    """An arm that is not as its file describes it, or whose file cannot be read; `problem` names the file."""

    def __init__(self, problem: str):
        InvalidValue.__init__(self, f"The arm {problem}.")


class InvalidPlanner(InvalidValue):
    """A planner of one's own that cannot be used; `name` is `module:factory`, or the name it has itself."""

    def __init__(self, name: str, problem: str):
        super().__init__(f"The planner {name} {problem}.")


class InvalidPlan(NeurosymError):
    """A plan file that cannot be read against the domain and problem at hand."""

    def __init__(self, path: Path, line: int, problem: str):
        super().__init__(f"{path}, line {line}: {problem}.")


# How long work reports how far it has come

Progress = Callable[[int, int], None]
"""Called with how many parts are done, and how many there are."""


class Advance(Protocol):
    """Reports how far some long work has come."""

    def __call__(self, done: int, total: int, label: str | None = None) -> None:
        """Say that `done` of `total` parts are finished; a new label begins a new bar."""
        ...


Doing = Callable[[str], None]
"""Tells what a command is doing now, in a few words."""
OpenBar = Callable[[str], AbstractContextManager[Progress]]
"""Called with what is being done; gives what reports how far that has come."""


def part(progress: Progress | None, before: int, total: int | None = None) -> Progress | None:
    """Return what reports how far a part of long work has come, such that the whole is reported.

    Args:
        progress: Reports how far the whole has come, if anybody wants to know.
        before: How much was done before this part.
        total: How much there is in all; what was done before and this part, if that is not known yet.
    """
    if progress is None:
        return None
    return lambda done, of: progress(before + done, before + of if total is None else total)


def silent(_: str) -> AbstractContextManager[Progress]:
    """Report nothing."""
    return nullcontext(lambda done, total: None)  # noqa: ARG005 (a `Progress`)


# What is installed: the distribution that neurosym comes in, and the versions of others.
#
# Installers write down what they install in folders beside the packages, whose names tell name and version.
# These are read here, in a thousandth of the time that importing `importlib.metadata` takes.

NAME = "neurosym-pddl"
"""The name under which neurosym is installed; on the package index, `neurosym` is another library."""
BUILDS = {"neurosym": (NAME,), "pybullet": ("pybullet", "pybullet-arm64")}
"""Distributions that bring a package, where their name is not its own, the first that is installed."""
_COMMAND = "neurosym.commands.cli:main"
_RECORD = re.compile(r"(?P<name>[^-]+)(?:-(?P<version>[^-]+)(?:-py\d[^-]*)?)?\.(?:dist|egg)-info")


def version_of(package: str) -> str:
    """Return the version of an installed package; "unknown" if it was not installed.

    Args:
        package: What it is imported as, or its distribution.
    """
    names = BUILDS.get(package, (package,))
    recorded = _recorded(tuple(sys.path))
    return next((recorded[name] for name in map(_canonical, names) if recorded.get(name)), "unknown")


def refuse_other_library() -> None:
    """Raise `OtherLibrary` if the library that the package index calls `neurosym` is installed beside ours.

    Ours once had that name, too; it is told by its command.
    """
    if "neurosym" not in _recorded(tuple(sys.path)):
        return
    from importlib.metadata import distribution

    other = distribution("neurosym")
    if not any(entry.value == _COMMAND for entry in other.entry_points):
        raise OtherLibrary(other.version, NAME)


@cache
def _recorded(places: tuple[str, ...]) -> dict[str, str]:
    """Return the versions of what is installed, by canonical name; the first folder that holds it counts."""
    found: dict[str, str] = {}
    for place in places:
        try:
            names = os.listdir(place or ".")  # noqa: PTH208 (as many as there are packages, and no more than names)
        except OSError:  # a zip file, or a folder that is gone
            continue
        for record in filter(None, map(_RECORD.fullmatch, sorted(names))):
            found.setdefault(_canonical(record["name"]), record["version"] or "")
    return found


def _canonical(name: str) -> str:
    return re.sub(r"[-_.]+", "-", name).lower()


# Whether what the page is drawn with is installed; this module is imported without it

LEAST, BELOW = (1, 1), (2, 0)
"""The versions of viser that do: drags were dead in some before, and the next great one may differ."""
_REMEDY = "install it with: pip install 'neurosym-pddl[studio]'"


class StudioMissing(NeurosymError):
    """What draws the page is not installed, or in a version that will not do."""

    def __init__(self, found: str = ""):
        wrong = f"viser {found} will not do (valid: from 1.1, below 2)" if found else "viser is not installed"
        super().__init__(f"{wrong}; {_REMEDY}")


def check_extra() -> None:
    """Raise `StudioMissing` unless the page can be drawn."""
    from importlib.metadata import PackageNotFoundError, version  # takes longer than the rest of this

    try:
        found = version("viser")
    except PackageNotFoundError:
        raise StudioMissing from None
    numbers = tuple(int(part) for part in found.split(".")[:2] if part.isdigit())
    if not LEAST <= numbers < BELOW:
        raise StudioMissing(found)
