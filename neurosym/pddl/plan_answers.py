"""Answers of planning services: JSON that holds a plan somewhere, as strings, as objects, or as text."""

import dataclasses
from pathlib import Path
from typing import Any

from neurosym.errors import InvalidFile, InvalidPlan, shortened
from neurosym.pddl.plan_lines import Line, WrittenAction, actions_in, unread
from neurosym.reading import decode_json

_PLANS = ("plan", "sas_plan", "actions", "steps")
_AROUND = ("result", "output", "plans", "data")
_NAMES, _ARGUMENTS = ("name", "action"), ("arguments", "args", "parameters", "params", "objects")
_TIMES = ("time", "start_time", "start")
_VALID = "valid: a list of strings like '(name argument)', or of objects with a name and arguments"


def is_answer(lines: list[Line]) -> bool:
    """Say whether a text is JSON by how it begins.

    Args:
        lines: Its lines.
    """
    first = next((line.text.lstrip() for line in lines if line.text.strip()), "")
    rest = first[1:].lstrip()
    return first.startswith("{") or (first.startswith("[") and (not rest or rest[0] in '"{[]'))


def plan_in_answer(lines: list[Line], path: Path) -> tuple[WrittenAction, ...] | str:
    """Return the actions of the plan that an answer holds, or the text of it.

    Args:
        lines: The lines of the answer.
        path: What errors name as its origin.

    Raises:
        InvalidPlan: If there is none in it, or more than one.
    """
    text, first = "\n".join(line.text for line in lines), lines[0].number
    try:
        document = decode_json(path, text.encode(), object)
    except InvalidFile as error:
        said = str(error).partition(": ")[2].rstrip(".")
        raise InvalidPlan(path, first, f"it begins like JSON, and cannot be read: {said}") from error
    found = _plan_in(document, path, first)
    if isinstance(found, str):
        return found
    reader = _Entries(text, first, path)
    return tuple(reader.action(entry) for entry in found)


def _plan_in(document: Any, path: Path, line: int) -> list[Any] | str:
    """Find the plan in an answer: its entries, or a text."""
    while isinstance(document, dict):
        for key in (*_PLANS, *_AROUND):
            if document.get(key):
                document = document[key]
                break
            if key in _PLANS and document.get(key) == []:
                return []
        else:
            names = ", ".join(map(repr, list(document)[:8])) or "nothing"
            raise InvalidPlan(path, line, f"the JSON has no plan, but {shortened(names)}; {_VALID}")
        if key == "plans" and isinstance(document, list):
            if len(document) != 1:
                raise InvalidPlan(path, line, f"the JSON has {len(document)} plans; valid: one")
            document = document[0]
    if not isinstance(document, list | str):
        raise InvalidPlan(path, line, f"the plan in the JSON is {shortened(repr(document))}; {_VALID}")
    return document


class _Entries:
    """Reads the entries of a list in JSON, and finds the lines that they stand in.

    Args:
        text: The JSON.
        first: The number of its first line.
        path: What errors name as its origin.
    """

    def __init__(self, text: str, first: int, path: Path):
        self._text, self._first, self._path, self._at, self._line = text, first, path, 0, first

    def action(self, entry: Any) -> WrittenAction:
        """Return the action that an entry is."""
        said, arguments, time = entry, None, None
        if isinstance(entry, dict):
            said, arguments = _first(entry, _NAMES), _first(entry, _ARGUMENTS)
            time = _first(entry, _TIMES)
        if not isinstance(said, str) or not isinstance(time, int | float | None):
            raise InvalidPlan(self._path, self._line, f"a step is {shortened(repr(entry))}; {_VALID}")
        line = Line(self._line_of(said), said)
        found = actions_in(line)
        if found is None or len(found) != 1:
            raise unread(line, self._path)
        (action,) = found
        if arguments is not None and not action.arguments:
            words = self._words(arguments)
            text = f"({' '.join((action.text, *words))})"
            action = dataclasses.replace(action, arguments=tuple(map(str.lower, words)), text=text)
        return action if time is None else dataclasses.replace(action, time=float(time))

    def _words(self, arguments: Any) -> list[str]:
        if not (isinstance(arguments, list) and all(isinstance(word, str) for word in arguments)):
            said = f"the arguments of a step are {shortened(repr(arguments))}; valid: a list of names"
            raise InvalidPlan(self._path, self._line, said)
        return arguments

    def _line_of(self, said: str) -> int:
        """Return the line in which a string stands, after those that were found before."""
        at = self._text.find(said, self._at)
        if at >= 0:
            self._line += self._text.count("\n", self._at, at)
            self._at = at
        return self._line


def _first(entry: dict[str, Any], keys: tuple[str, ...]) -> Any:
    """Return the first that an object has of some fields."""
    return next((entry[key] for key in keys if key in entry), None)
