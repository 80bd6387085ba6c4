"""Written plans: text of any planner, read into ground actions by its form alone.

A line holds actions (`plan_lines`), or it is known to hold none: a comment, a note like `Plan length: 3`, or
another line of a log, whose plan begins after a line that says so. Everything else is refused. Lines that
are passed over are handed on, so that who knows the names can tell that none of them is a step.

No reader of a library does this: unified-planning's takes 2 s to import and reads one form of the many;
those of `pddl` and tarski read domains and problems, and no plans.
"""

import dataclasses
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from neurosym.errors import InvalidPlan, shortened
from neurosym.pddl.plan_answers import is_answer, plan_in_answer
from neurosym.pddl.plan_lines import NUMBER, Line, WrittenAction, actions_in, unread
from neurosym.wording import counted

LONGEST_LINE = 100_000
"""Longer lines are no steps."""
MOST_LINES = 100
"""An action goes over so many lines at most."""
_COMMENT = re.compile(r"(\[[^\[\]]*\])|;.*|(?:^|(?<=\s))#.*")
"""What is no comment though it holds a semicolon, or else a comment."""
_FENCE = re.compile(r"\s*(?:```|~~~)")
_OPEN = re.compile(r"(?:.*\))?[^()]*\([\s\w,-]*")
_STAMP = re.compile(r"\s*(?:\[t=[^\]]*\]|[0-9]{4}-[0-9]{2}-[0-9]{2} [0-9:,.]+ +[A-Z]+|(?:INFO|WARNING)\s)\s*")
"""What the lines of logs begin with, before what they say."""
_HEADING = re.compile(
    r"\s*(?:(?:plan:\s*)?(?:Sequential|TimeTriggered) ?Plan:|(?:(?:here is )?the )?plan:)\s*", re.I
)
"""What says that a plan follows, and nothing else."""
_BEGINS = re.compile(
    r"\s*(?:;*\s*solution found[!:]?|(?:.*: )?found (?:legal |new )?plan(?: as follows)?:?"
    r"|(?:best plan|plan computed):|plan found: [0-9]+ steps?)\s*",
    re.I,
)
"""What logs say before a plan."""
_AGAIN = re.compile(r"\s*;+\s*(?:better |next |new )?(?:plan|solution) (?:no\. ?)?[0-9]+\b.*", re.I)
"""What stands between plans that get better."""
_COST = re.compile(r"\s*;\s*cost\s*=\s*[0-9].*", re.I)
"""What ends a plan file, or begins it; there is one for each plan."""
_ENDED = re.compile(r"\s*solution found\.\s*", re.I)
_NOTE = re.compile(
    rf"""\s*(?:
      [^\W\d][^\d()\[\]:=]* (?:\([^()]*\)\s*)? [:=]\s* {NUMBER}\b (?!\s*:)[^:]*
    | plan\s*\(cost:\s*{NUMBER}\)\s*(?:\[{NUMBER}\])?
    | {NUMBER}\s+[a-z][^()\[\]]*
    | [-=*_]{{3,}}
    )\s*""",
    re.VERBOSE | re.IGNORECASE,
)
"""Lines that say something of a plan, and are no part of it: labels with numbers, like `cost = 3`."""
_LENGTH = re.compile(r"plan[- ]length\s*:\s*([0-9]{1,9})", re.I)
_NONE = re.compile(
    r";\s*(?:cost\s*=\s*0\b|0 primitives\b)|plan[- ]length\s*:\s*0\b|\bempty plan\b|\bno steps\b", re.I
)
"""What says that a plan has no steps on purpose."""


@dataclass(frozen=True, slots=True)
class WrittenPlan:
    """A plan as it was written.

    Attributes:
        actions: Its actions in the order of their times; of equal times, and without any, as written.
        passed: Lines that hold none.
        is_empty: Whether it is one without steps if it has no actions: it says so, or nothing at all.
    """

    actions: tuple[WrittenAction, ...]
    passed: tuple[Line, ...] = ()
    is_empty: bool = False


def written_plan(text: str, path: Path) -> WrittenPlan:
    """Read what a planner wrote.

    Args:
        text: The text.
        path: What errors name as its origin.

    Raises:
        InvalidPlan: If a line cannot be read; the message names the nearest form that is.
    """
    lines = [Line(number, raw) for number, raw in enumerate(text.splitlines(), start=1)]
    inside, outside = _unfenced(lines, path)
    plan = _of_answer(inside, path) if is_answer(inside) else _of_lines(inside, path)
    return dataclasses.replace(
        plan, actions=_in_time(plan.actions, path), passed=(*map(_bare, outside), *plan.passed)
    )


def _of_answer(lines: list[Line], path: Path) -> WrittenPlan:
    """Read the plan in an answer of a service, which may be a text in it."""
    found = plan_in_answer(lines, path)
    if not isinstance(found, str):
        return WrittenPlan(found, is_empty=True)
    return _of_lines([Line(lines[0].number, raw) for raw in found.splitlines()], path)


@dataclass(slots=True)
class _Section:
    """One plan of a text, which may be a log that holds several.

    Attributes:
        actions: Its actions.
        length: How many it is said to have, and where.
        costs: Lines that say what it costs, as files of plans do once.
        is_first: Whether no plan can stand before it.
    """

    actions: list[WrittenAction] = field(default_factory=list)
    length: tuple[int, Line] | None = None
    costs: list[Line] = field(default_factory=list)
    is_first: bool = True


def _of_lines(lines: Sequence[Line], path: Path) -> WrittenPlan:
    """Read a plan of lines: of several that a log holds the last, for planners print what gets better."""
    is_log = any(_begins(line.text) for line in lines)
    sections, passed, is_headed = [_Section()], list[Line](), False
    for line in _whole(lines, path):
        if _begins(line.text):
            is_headed = is_headed or bool(_HEADING.fullmatch(line.text))
            sections.append(_Section(is_first=len(sections) == 1))
            continue
        if _AGAIN.fullmatch(line.text):
            sections.append(_Section(is_first=False))
        if _COST.fullmatch(line.text):
            sections[-1].costs.append(line)
        bare = _bare(line)
        if length := _LENGTH.search(bare.text):
            sections[-1].length = int(length[1]), line
        may_pass = (is_log and not is_headed) or bool(_STAMP.match(line.text))
        found = None if _is_note(bare) else actions_in(bare)
        if found and not (may_pass and any(one.is_plain for one in found)):
            sections[-1].actions += found
        elif may_pass or _is_note(bare):
            passed += [bare] if bare.text.strip() else []
        else:
            raise unread(line, path)
    chosen = _last(sections, path)
    is_empty = is_headed or not (is_log or passed) or any(_NONE.search(line.text) for line in lines)
    return WrittenPlan(tuple(chosen.actions), tuple(passed), is_empty)


def _begins(text: str) -> bool:
    """Say whether a plan begins after a line."""
    said = _STAMP.sub("", text, count=1) if len(text) <= LONGEST_LINE else ""
    return not _ENDED.fullmatch(said) and bool(_BEGINS.fullmatch(said) or _HEADING.fullmatch(said))


def _bare(line: Line) -> Line:
    """Return a line without comments, and without what lines of logs begin with."""
    return Line(line.number, _COMMENT.sub(r"\1", _STAMP.sub("", line.text, count=1)))


def _is_note(line: Line) -> bool:
    """Say whether a line, without comments, is known to hold no action."""
    return not line.text.strip() or bool(_NOTE.fullmatch(line.text) or _ENDED.fullmatch(line.text))


def _last(sections: Sequence[_Section], path: Path) -> _Section:
    """Return the last plan, if it is one and as long as it is said to be, and no step stands before all."""
    first, *others = sections
    if others and others[0].is_first and first.actions:
        action = first.actions[0]
        raise InvalidPlan(
            path, action.line, f"{shortened(action.text)!r} stands before the line that a plan begins after"
        )
    chosen = next((one for one in sections[::-1] if one.actions or one.length), sections[-1])
    if chosen.length and chosen.length[0] != len(chosen.actions):
        line, read = chosen.length[1], len(chosen.actions)
        raise InvalidPlan(
            path,
            line.number,
            f"{shortened(line.text.strip())!r} is said, and {counted(read, 'step')} can be read",
        )
    if len(chosen.costs) > 1:
        line = chosen.costs[1]
        raise InvalidPlan(
            path,
            line.number,
            f"{shortened(line.text.strip())!r} is said of a second plan; valid: one plan, or what a planner "
            "printed that finds better ones",
        )
    return chosen


def _whole(lines: Sequence[Line], path: Path) -> Iterator[Line]:
    """List the lines, those joined that an action goes over."""
    at = 0
    while at < len(lines):
        if len(lines[at].text) > LONGEST_LINE:
            raise unread(lines[at], path)
        line, at = _joined(lines, at)
        yield line


def _joined(lines: Sequence[Line], at: int) -> tuple[Line, int]:
    """Return a line with those up to where its bracket closes, if it does, and the index of the next."""
    line, parts = lines[at], [_bare(lines[at]).text]
    if not _is_open(parts[0]):
        return line, at + 1
    for end, other in enumerate(lines[at + 1 : at + MOST_LINES], start=at + 2):
        more = _bare(other).text
        head, closes, _ = more.partition(")")
        if "(" in head or len(more) > LONGEST_LINE:
            break
        parts.append(more)
        if closes and not _is_open(more):
            return Line(line.number, " ".join(parts)), end
    return line, at + 1


def _is_open(text: str) -> bool:
    return len(text) <= LONGEST_LINE and text.rfind("(") > text.rfind(")") and bool(_OPEN.fullmatch(text))


def _unfenced(lines: list[Line], path: Path) -> tuple[list[Line], list[Line]]:
    """Tell the lines of a block of Markdown from those around it; without a block, all are inside."""
    blocks, outside, is_inside = list[list[Line]](), list[Line](), False
    for line in lines:
        if _FENCE.match(line.text):
            is_inside = not is_inside
            blocks += [[]] if is_inside else []
        elif is_inside:
            blocks[-1].append(line)
        elif line.text.strip():
            outside.append(line)
    if len(blocks) > 1:
        said = f"it has {len(blocks)} blocks between lines of ```; valid: one, which holds the plan"
        raise InvalidPlan(path, 1, said)
    for line in outside if blocks else ():
        found = actions_in(_bare(line)) if len(line.text) <= LONGEST_LINE else None
        if found and not found[0].is_plain:
            raise InvalidPlan(path, line.number, f"{shortened(line.text.strip())!r} stands outside the block")
    return (blocks[0], outside) if blocks else (lines, [])


def _in_time(actions: tuple[WrittenAction, ...], path: Path) -> tuple[WrittenAction, ...]:
    """Put actions in the order of their times, if they have any; of equal times as they were written."""
    timed = [one for one in actions if one.time is not None]
    if timed and len(timed) < len(actions):
        odd = next(one for one in actions if one.time is None)
        raise InvalidPlan(path, odd.line, f"{shortened(odd.text)!r} has no time, and other steps have one")
    return tuple(sorted(actions, key=lambda one: one.time or 0.0))
