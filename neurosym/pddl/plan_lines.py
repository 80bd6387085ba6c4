"""A line of a written plan: the ground actions in it, or that it holds something else.

A line is read by what it is made of: times, words in brackets or before them, words alone, durations, and
commas. What a name means is no business of this module; see `plan_reading`.
"""

import math
import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from neurosym.errors import InvalidPlan, shortened
from neurosym.pddl.plan_forms import nearest_form

NUMBER = r"(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?"
_NAME = r"[^\W\d][\w-]*"
_TOKEN = re.compile(
    rf"""\s*(?:
      (?:(?:step|time)\s*)? (?P<time>{NUMBER}) \s*:
    | (?P<name>{_NAME}) \( (?P<listed>[^()]*) \)
    | \( (?P<group>[^()]*) \)
    | \[ (?P<bracket>[^\[\]()]*) \]
    | (?P<comma>,)
    | (?P<word>[^\s(),\[\]]+)
    )\s*""",
    re.VERBOSE | re.IGNORECASE,
)
_MARK = re.compile(r"\s*(?:[-*+•]|(?P<number>[0-9]{1,9})[.)])\s+(?=[(\w])")
_WORDS = re.compile(rf"{_NAME}(?:[\s,]+[\w-]+)*")
_AMOUNT = re.compile(rf"\s*{NUMBER}\s*")
_DURATION = re.compile(rf"\s*(?:[a-z]+\s*:\s*)?{NUMBER}(?:\s*[;,]\s*(?:[a-z]+\s*:\s*)?{NUMBER})*\s*", re.I)


class Line(NamedTuple):
    """A line of a text, counted from 1."""

    number: int
    text: str


@dataclass(frozen=True, slots=True)
class WrittenAction:
    """A ground action as it was written.

    Attributes:
        name: Its name, in lower case.
        arguments: Its arguments, in lower case.
        line: The line that it begins in, from 1.
        text: The action as written.
        time: When it begins, if that is said.
        is_plain: Whether nothing but words was written, which might be prose.
    """

    name: str
    arguments: tuple[str, ...]
    line: int
    text: str
    time: float | None = None
    is_plain: bool = False


def unread(line: Line, path: Path) -> InvalidPlan:
    """Say that a line cannot be read, as it was written, and what it comes nearest to.

    Args:
        line: The line.
        path: Where it stands.
    """
    form, raw = nearest_form(line.text), line.text.strip()
    return InvalidPlan(
        path,
        line.number,
        f"{shortened(raw)!r} is not of the form of a step; the nearest is {form.name}, like "
        f"`{' '.join(form.example.split())}`",
    )


def actions_in(line: Line) -> list[WrittenAction] | None:
    """Return the actions in a line, and None if it holds none, or anything else.

    Args:
        line: The line, without comments.
    """
    found, at = _Found(line), 0
    if mark := _MARK.match(line.text):
        at, found.time = mark.end(), float(mark["number"]) if mark["number"] else None
    while at < len(line.text):
        token = _TOKEN.match(line.text, at)
        if token is None or not found.takes(token):
            return None
        at = token.end()
    return found.actions if found.ends() and found.actions else None


@dataclass(slots=True)
class _Found:
    """What was found in a line so far.

    Attributes:
        line: The line.
        actions: Actions.
        words: Words without brackets, which may become one.
        time: The time that holds for what comes.
        begin: Where the words begin.
    """

    line: Line
    actions: list[WrittenAction] = field(default_factory=list)
    words: list[str] = field(default_factory=list)
    time: float | None = None
    begin: int = 0

    def takes(self, token: re.Match[str]) -> bool:
        """Take the next token, if it can stand there."""
        kind = token.lastgroup
        if kind == "word":
            self.begin = self.begin if self.words else token.start()
            self.words.append(token["word"])
            return True
        if kind == "comma":
            return bool(self.words or self.actions)
        if kind == "time":
            return self.ends(token.start()) and self._begins_at(float(token["time"]))
        if kind == "bracket":
            return bool(_DURATION.fullmatch(token["bracket"])) and self._marks_an_action(token)
        if kind == "listed":
            return not self.words and self._adds(f"{token['name']} {token['listed']}", token[0])
        if self.words or (self.actions and _AMOUNT.fullmatch(token["group"])):
            return bool(_AMOUNT.fullmatch(token["group"])) and self._marks_an_action(token)
        return self._adds(token["group"], token[0])

    def ends(self, end: int | None = None) -> bool:
        """Make an action of the words so far, if there are any; false if they can be none."""
        return self._closes(end, is_plain=self.time is None)

    def _begins_at(self, time: float) -> bool:
        self.time = time
        return math.isfinite(time)

    def _marks_an_action(self, token: re.Match[str]) -> bool:
        """Take a duration or a cost, which shows that words before it are an action."""
        return self._closes(token.start(), is_plain=False) and bool(self.actions)

    def _closes(self, end: int | None, *, is_plain: bool) -> bool:
        words, self.words = self.words, []
        return not words or self._adds(" ".join(words), self.line.text[self.begin : end], is_plain=is_plain)

    def _adds(self, words: str, text: str, *, is_plain: bool = False) -> bool:
        bare = words.strip(" \t\n,")
        if not _WORDS.fullmatch(bare):
            return False
        name, *arguments = re.split(r"[\s,]+", bare.lower())
        number, shown = self.line.number, " ".join(text.split())
        self.actions.append(WrittenAction(name, tuple(arguments), number, shown, self.time, is_plain))
        return True
