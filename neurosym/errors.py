"""Errors that a user can cause, each with one sentence that says what would be valid.

Expected outcomes (no plan, a time-out, a failed step) are values, not errors.
"""

from collections.abc import Iterable
from difflib import get_close_matches
from pathlib import Path
from typing import Any

from neurosym.wording import quoted

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
