"""Errors that a user can cause, each with one sentence that says what would be valid; and the words of it."""

import os
import re
import shlex
import sys
import unicodedata
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager, nullcontext, suppress
from difflib import get_close_matches
from functools import cache
from pathlib import Path
from typing import Any, Protocol, TypeVar

# Paths, lengths and texts of strangers as a user reads them

PIPE_WIDTH = 160  # columns to print in, where there is no terminal to ask


def quoted(path: Path | str) -> str:
    """Return a path as it is typed in a shell: in quotes if it has blanks or the like."""
    return shlex.quote(str(path))


def harmless(text: str) -> str:
    """Return a text such that a terminal does nothing but show it.

    Control characters, which may hide text or type commands, become escapes as in Python's strings. So does
    what changes the direction of writing, and what is no character at all. Line ends and tabs stay.
    """

    def shown(sign: str) -> str:
        if sign in "\n\t" or unicodedata.category(sign) not in ("Cc", "Cf", "Cs", "Zl", "Zp"):
            return sign
        return f"\\x{ord(sign):02x}" if ord(sign) < 256 else f"\\u{ord(sign):04x}"

    return text if text.isprintable() else "".join(map(shown, text))


def in_millimetres(distance: float, allowed: float) -> str:
    """Return a distance [m] in whole mm, with decimals where it would look allowed [m] and is not.

    Args:
        distance: The distance [m].
        allowed: The greatest that is allowed [m].
    """
    texts = [f"{1000 * distance:.{digits}f}" for digits in range(10)]
    plain = (text for text in texts if distance <= allowed or float(text) > 1000 * allowed)
    return f"{next(plain, texts[-1])} mm"


def counted(count: int, noun: str) -> str:
    """Return a number with its noun, which takes an s if there is not exactly one."""
    return f"{count} {noun}{'' if count == 1 else 's'}"


def listed_briefly(names: Sequence[str], most: int = 16) -> str:
    """Return names with commas between, of a long list the first ones and how many more there are."""
    more = len(names) - most
    return ", ".join(names[:most]) + (f" and {more} more" if more > 0 else "")


# Errors that a user can cause, each with one sentence that says what would be valid.
#
# Expected outcomes (no plan, a time-out, a failed step) are values, not errors.

_MOST_LISTED, _LONGEST_LIST = 20, 400  # names that a sentence lists whole; its characters if there are more
_FEW = 3  # of so many, none is said to be the nearest


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
        if folder.exists():
            super().__init__(f"{folder} is a file; name a domain folder.")
        else:
            super().__init__(
                f"There is no folder {folder}; `neurosym init {quoted(folder)}` makes a new one."
            )


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


class FolderTaken(NeurosymError):
    """A domain folder in which another process works that it cannot be shared with."""

    def __init__(self, folder: Path, holders: Iterable[int]):
        numbers = ", ".join(map(str, holders))
        said = f"Process {numbers} works" if numbers else "Another process works"
        super().__init__(f"{said} in {folder}; wait until it has ended, or name another folder.")


class CannotStart(NeurosymError):
    """The system lets no further process or thread be started; `what` names which, like `planner`."""

    def __init__(self, what: str, why: str, do: str = "allow more processes, files or memory (ulimit -a)"):
        super().__init__(f"No {what} can be started: {why}; {do}.")


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
        elif len(choices) > _FEW and (near := get_close_matches(name[:100], choices, 1)):
            valid = f"the nearest is {near[0]}; {valid}"
        super().__init__(f"There is no {kind} {shortened(name)!r}; {valid}.")


_Thing = TypeVar("_Thing")


def one_called(kind: str, name: str, among: Sequence[_Thing], by: str = "name") -> _Thing:
    """Return the first of some things whose attribute `by` is a name; `UnknownChoice` if none is."""
    found = next((one for one in among if getattr(one, by) == name), None)
    if found is None:
        raise UnknownChoice(kind, name, (getattr(one, by) for one in among))
    return found


class InvalidValue(NeurosymError):
    """A number or shape outside what is possible."""


class InvalidWorld(InvalidValue):
    """A world of one's own that cannot be used; `name` is `module:factory`, or the name it has itself."""

    is_placed = False  # whether the message says where it was

    def __init__(self, name: str, problem: str):
        super().__init__(f"The world {name!r} {problem}.")

    def at(self, place: str) -> "InvalidWorld":
        """Return the same error, which also says where it was, unless it does so already."""
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


@contextmanager
def blaming(path: Path) -> Iterator[None]:
    """Have what cannot be, where it is what a file holds, be said of the file: as `InvalidFile`."""
    try:
        yield
    except (InvalidValue, UnknownChoice) as error:
        raise InvalidFile(path, str(error).rstrip(".")) from error


# How long work reports how far it has come

Progress = Callable[[int, int], None]  # called with how many parts are done, and how many there are


class Advance(Protocol):
    """Reports how far some long work has come."""

    def __call__(self, done: int, total: int, label: str | None = None) -> None:
        """Say that `done` of `total` parts are finished; a new label begins a new bar."""


Doing = Callable[[str], None]  # tells what a command is doing now, in a few words
OpenBar = Callable[[str], AbstractContextManager[Progress]]
"""Called with what is being done; gives what reports how far that has come."""


def part(progress: Progress | None, before: int, total: int | None = None) -> Progress | None:
    """Return what reports the whole as a part advances, after so much before it; its total may be unknown."""
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
"""Distributions that bring a package, where their name is not its own."""
_RECORD = re.compile(r"(?P<name>[^-]+)(?:-(?P<version>[^-]+)(?:-py\d[^-]*)?)?\.(?:dist|egg)-info")
_VISER = ((1, 1), (2, 0))  # drags were dead in some versions before, and the next great one may differ


def version_of(package: str) -> str:
    """Return the version of an installed package; "unknown" if it was not installed.

    Args:
        package: What it is imported as, or its distribution.
    """
    recorded = _recorded(tuple(sys.path))
    found = (recorded.get(_canonical(name)) for name in BUILDS.get(package, (package,)))
    return next(filter(None, found), "unknown")


def refuse_other_library() -> None:
    """Raise unless the library that the package index calls `neurosym` is missing here."""
    if version := _recorded(tuple(sys.path)).get("neurosym"):
        raise NeurosymError(
            f"Another library called neurosym (version {version}) is installed here, and is imported by the "
            f"same name; install {NAME} in an environment of its own."
        )


def check_extra() -> None:
    """Raise `NeurosymError` unless what the page is drawn with is installed, in a version that does."""
    found = version_of("viser")
    numbers = tuple(int(part) for part in found.split(".")[:2] if part.isdigit())
    if not _VISER[0] <= numbers < _VISER[1]:
        is_known = f"viser {found} will not do (valid: from 1.1, below 2)"
        wrong = "viser is not installed" if found == "unknown" else is_known
        raise NeurosymError(f"{wrong}; install it with: pip install 'neurosym-pddl[studio]'")


@cache
def _recorded(places: tuple[str, ...]) -> dict[str, str]:
    """Return the versions of what is installed, by canonical name; the first folder that holds it counts."""
    found: dict[str, str] = {}
    for place in places:
        with suppress(OSError):  # a zip file, or a folder that is gone
            names = sorted(os.listdir(place or "."))  # noqa: PTH208 (as many as packages, and no more than names)
            for record in filter(None, map(_RECORD.fullmatch, names)):
                found.setdefault(_canonical(record["name"]), record["version"] or "")
    return found


def _canonical(name: str) -> str:
    return re.sub(r"[-_.]+", "-", name).lower()
