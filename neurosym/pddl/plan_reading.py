"""Reading plans: what a written plan means in a domain and a problem, as steps.

A step is one primitive on one object. Planners write ground actions of the printed domain, several for one
step; they are followed from the start, and each must be possible where it stands (`strips_plan`).

Steps in short name the operator and its object, and the place or the other object if there is one. Plans of
the encodings that earlier versions had name operators, too, with cells, counts and origins behind. These are
passed over: they belong to files that are not printed any more, and the exact replay judges the steps.
"""

import math
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, NamedTuple

from neurosym.errors import InvalidFile, InvalidPlan, InvalidValue, UnknownChoice, counted, shortened
from neurosym.files import MEGABYTE, decode_json, read_text
from neurosym.grounding import Grounding, is_lift
from neurosym.pair_operators import RelationOperator
from neurosym.pddl import strips
from neurosym.pddl.compiler import NUMBERS, PAGE
from neurosym.pddl.durative import CARRY, read_durative
from neurosym.pddl.grid import AXES
from neurosym.pddl.numeric import is_numeric
from neurosym.pddl.strips_plan import Misread, led_in, read
from neurosym.pddl.strips_problem import StripsProblem
from neurosym.problems import Problem
from neurosym.tasks.options import PUT_DOWN
from neurosym.tasks.task import Task, check_place, understand
from neurosym.tasks.transition import PlanStep

# Written plans: text of any planner or service, read into ground actions by its form.
#
# A line holds actions, or it is passed over: a comment, or what else a log says. But a line that names an
# action or an object, and cannot be read, is refused, so that no step is lost. A service's answer in JSON
# holds a plan as strings, as objects, or as text.
#
# No reader of a library does this: unified-planning's takes 2 s to import and reads one form of the many;
# those of `pddl` and tarski read domains and problems, and no plans.

LONGEST_LINE = 100_000
"""Longer lines are no steps."""
MOST_LINES = 100
"""An action goes over so many lines at most."""
VALID = "valid: a step a line, like `(move-x item-01 dx3 x40 x43)`, or another form of docs/other-plans.md"
_NUMBER = r"(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?"
_NAME = r"[^\W\d][\w-]*"
_AMOUNT = rf"(?:[a-z]+\s*:\s*)?{_NUMBER}"
_MARK = re.compile(r"\s*(?:[-*+•]|(?P<time>[0-9]{1,9})[.)])\s+(?=[(\w])")
"""What items of a list begin with; their numbers order them."""
_ACTION = re.compile(
    rf"""\s*(?:(?:(?:step|time)\s*)?(?P<time>{_NUMBER})\s*:\s*)?
    (?P<text>(?P<name>{_NAME})?\((?P<group>[^()]*)\)|(?P<words>{_NAME}(?:[\s,]+[\w-]+)*)) \s*
    (?P<marks>(?:\(\s*{_NUMBER}\s*\)\s*)? (?:\[\s*{_AMOUNT}(?:\s*[;,]\s*{_AMOUNT})*\s*\]\s*)?) ,?\s*""",
    re.VERBOSE | re.IGNORECASE,
)
"""An action: its time, its words with or without brackets, and what it costs or how long it takes."""
_WORDS = re.compile(rf"{_NAME}(?:[\s,]+[\w-]+)*")
_COMMENT = re.compile(r"(\[[^\[\]]*\])|;.*|(?:^|(?<=\s))#.*")
"""What is no comment though it holds a semicolon, or else a comment."""
_FENCE = re.compile(r"\s*(?:```|~~~)")
_OPEN = re.compile(r"(?:.*\))?[^()]*\([\s\w,-]*")
_HEADING = re.compile(
    r"\s*(?:(?:plan:\s*)?(?:Sequential|TimeTriggered) ?Plan:|(?:(?:here is )?the )?plan:)\s*", re.I
)
"""What says that a plan follows, and nothing else."""
_BEGINS = re.compile(
    r"(?:.*[\];:] )?\s*;*\s*(?:solution found[!:]?|found (?:legal |new )?plan(?: as follows)?:?"
    r"|(?:best plan|plan computed):|plan found: [0-9]+ steps?)\s*",
    re.I,
)
"""What logs say before a plan."""
_AGAIN = re.compile(r"\s*;+\s*(?:better |next |new )?(?:plan|solution) (?:no\. ?)?[0-9]+\b.*", re.I)
"""What stands between plans that get better."""
_COST = re.compile(r"\s*;\s*cost\s*=\s*[0-9].*", re.I)
"""What ends a plan file, or begins it; there is one for each plan."""
_LENGTH = re.compile(r"plan[- ]length\s*:\s*([0-9]{1,9})", re.I)
_NONE = re.compile(
    r";\s*(?:cost\s*=\s*0\b|0 primitives\b)|plan[- ]length\s*:\s*0\b|\bempty plan\b|\bno steps\b", re.I
)
"""What says that a plan has no steps on purpose."""
_PLANS = ("plan", "sas_plan", "actions", "steps")
_AROUND = ("result", "output", "plans", "data")
_NAMES, _ARGUMENTS = ("name", "action"), ("arguments", "args", "parameters", "params", "objects")
_TIMES = ("time", "start_time", "start")
_VALID_JSON = "valid: a list of strings like '(name argument)', or of objects with a name and arguments"


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


def written_plan(text: str, path: Path, is_known: Callable[[str], bool]) -> tuple[WrittenAction, ...]:
    """Read what a planner wrote.

    Args:
        text: The text.
        path: What errors name as its origin.
        is_known: Says whether a word names an action or an object.

    Returns:
        The actions in the order of their times; of equal times, and without any, as written.

    Raises:
        InvalidPlan: If a line cannot be read that names something, or there is no plan.
    """
    lines = [Line(number, raw) for number, raw in enumerate(text.splitlines(), start=1)]
    inside = _unfenced(lines, path, is_known)
    if _is_answer(inside):
        inside = _lines_of_answer(inside, path)
    actions = _last_plan(inside, path, is_known)
    timed = [one for one in actions if one.time is not None]
    if timed and len(timed) < len(actions):
        odd = next(one for one in actions if one.time is None)
        raise InvalidPlan(path, odd.line, f"{shortened(odd.text)!r} has no time, and other steps have one")
    return tuple(sorted(actions, key=lambda one: one.time or 0.0))


def _unread(line: Line, path: Path) -> InvalidPlan:
    """Say that a line cannot be read, as it was written, and what would be valid."""
    said = f"{shortened(line.text.strip())!r} is not of the form of a step; {VALID}"
    return InvalidPlan(path, line.number, said)


def _actions_in(line: Line) -> list[WrittenAction]:
    """Return the actions that a line without comments consists of; none if it holds anything else."""
    if len(line.text) > LONGEST_LINE:
        return []
    mark = _MARK.match(line.text)
    at, time, found = mark.end() if mark else 0, mark and mark["time"], list[WrittenAction]()
    while at < len(line.text):
        match = _ACTION.match(line.text, at)
        at, time = match.end() if match else 0, (match and match["time"]) or time
        words = match and (match["words"] or f"{match['name'] or ''} {match['group']}").strip(" \t\n,")
        if not (match and words and _WORDS.fullmatch(words) and math.isfinite(float(time or 0))):
            return []
        if match["words"] and line.text.startswith("(", at):
            return []
        name, *arguments = re.split(r"[\s,]+", words.lower())
        is_plain = bool(match["words"]) and not (match["marks"] or time)
        begins, text = (float(time) if time else None), " ".join(match["text"].split())
        found.append(WrittenAction(name, tuple(arguments), line.number, text, begins, is_plain))
    return found


@dataclass(slots=True)
class _Section:
    """One plan of a text, which may be a log that holds several.

    Attributes:
        is_first: Whether no plan can stand before it.
        actions: Its actions.
        length: How many it is said to have, and where.
        costs: Lines that say what it costs, as files of plans do once.
    """

    is_first: bool
    actions: list[WrittenAction] = field(default_factory=list)
    length: tuple[int, Line] | None = None
    costs: list[Line] = field(default_factory=list)


def _last_plan(lines: Sequence[Line], path: Path, is_known: Callable[[str], bool]) -> list[WrittenAction]:
    """Read a plan of lines: of several that a log holds the last, for planners print what gets better."""
    sections, is_passed = [_Section(is_first=True)], False
    for line in _whole(lines):
        if len(line.text) > LONGEST_LINE:
            raise _unread(line, path)
        if _HEADING.fullmatch(line.text) or _BEGINS.fullmatch(line.text):
            is_passed = is_passed or not _HEADING.fullmatch(line.text)
            sections.append(_Section(is_first=len(sections) == 1))
            continue
        if _AGAIN.fullmatch(line.text):
            sections.append(_Section(is_first=False))
        if _COST.fullmatch(line.text):
            sections[-1].costs.append(line)
        bare = _bare(line)
        if length := _LENGTH.search(bare.text):
            sections[-1].length = int(length[1]), line
        found = _actions_in(bare)
        if found and all(is_known(one.name) for one in found if one.is_plain):
            sections[-1].actions += found
        elif _names(bare, is_known):
            raise _unread(line, path)
        else:
            is_passed = is_passed or bool(bare.text.strip())
    actions = _last(sections, path).actions
    if is_passed and not actions and not any(_NONE.search(line.text) for line in lines):
        raise InvalidPlan(path, 1, f"what is written there has no steps; {VALID}")
    return actions


def _names(line: Line, is_known: Callable[[str], bool]) -> bool:
    """Say whether a line names an action or an object."""
    return any(map(is_known, re.findall(r"[\w-]+", line.text.lower())))


def _bare(line: Line) -> Line:
    """Return a line without comments."""
    return Line(line.number, _COMMENT.sub(r"\1", line.text))


def _last(sections: Sequence[_Section], path: Path) -> _Section:
    """Return the last plan, if it is one and as long as it is said to be, and no step stands before all."""
    first, *others = sections
    if others and others[0].is_first and first.actions:
        action = first.actions[0]
        said = f"{shortened(action.text)!r} stands before the line that a plan begins after"
        raise InvalidPlan(path, action.line, said)
    chosen = next((one for one in sections[::-1] if one.actions or one.length), sections[-1])
    if chosen.length and chosen.length[0] != len(chosen.actions):
        line, read = chosen.length[1], counted(len(chosen.actions), "step")
        said = f"{shortened(line.text.strip())!r} is said, and {read} can be read"
        raise InvalidPlan(path, line.number, said)
    for line in chosen.costs[1:]:
        said = f"{shortened(line.text.strip())!r} is said of a second plan; valid: one plan, or what a "
        raise InvalidPlan(path, line.number, f"{said}planner printed that finds better ones")
    return chosen


def _whole(lines: Sequence[Line]) -> Iterator[Line]:
    """List the lines, those joined that an action goes over."""
    at = 0
    while at < len(lines):
        line, parts = lines[at], [_bare(lines[at]).text]
        at += 1
        if _is_open(parts[0]):
            for end, other in enumerate(lines[at : at + MOST_LINES], start=at + 1):
                more = _bare(other).text
                head, closes, _ = more.partition(")")
                if "(" in head or len(more) > LONGEST_LINE:
                    break
                parts.append(more)
                if closes and not _is_open(more):
                    line, at = Line(line.number, " ".join(parts)), end
                    break
        yield line


def _is_open(text: str) -> bool:
    return len(text) <= LONGEST_LINE and text.rfind("(") > text.rfind(")") and bool(_OPEN.fullmatch(text))


def _unfenced(lines: list[Line], path: Path, is_known: Callable[[str], bool]) -> list[Line]:
    """Return the lines of a block of Markdown; without a block, all."""
    blocks, outside, is_inside = list[list[Line]](), list[Line](), False
    for line in lines:
        if _FENCE.match(line.text):
            is_inside = not is_inside
            blocks += [[]] if is_inside else []
        else:
            (blocks[-1] if is_inside else outside).append(line)
    if len(blocks) > 1:
        said = f"it has {len(blocks)} blocks between lines of ```; valid: one, which holds the plan"
        raise InvalidPlan(path, 1, said)
    for line in outside if blocks else ():
        if _names(_bare(line), is_known):
            raise InvalidPlan(path, line.number, f"{shortened(line.text.strip())!r} stands outside the block")
    return blocks[0] if blocks else lines


def _is_answer(lines: list[Line]) -> bool:
    """Say whether a text is JSON by how it begins."""
    first = next((line.text.lstrip() for line in lines if line.text.strip()), "")
    rest = first[1:].lstrip()
    return first.startswith("{") or (first.startswith("[") and (not rest or rest[0] in '"{[]'))


def _lines_of_answer(lines: list[Line], path: Path) -> list[Line]:
    """Return the plan that the JSON of a service holds, a step a line."""
    text, first = "\n".join(line.text for line in lines), lines[0].number
    try:
        document = decode_json(path, text.encode(), object)
    except InvalidFile as error:
        said = str(error).partition(": ")[2].rstrip(".")
        raise InvalidPlan(path, first, f"it begins like JSON, and cannot be read: {said}") from error
    found, steps, at = _plan_in(document, path, first), list[Line](), 0
    if isinstance(found, str):
        return [Line(first, raw) for raw in found.splitlines()]
    for entry in found:
        said, written = _step_of(entry)
        at = max(at, text.find(said, at))
        line = Line(first + text.count("\n", 0, at), written)
        if not written:
            raise InvalidPlan(path, line.number, f"a step is {shortened(repr(entry))}; {_VALID_JSON}")
        if len(_actions_in(line)) != 1:
            raise _unread(line, path)
        steps.append(line)
    return steps


def _plan_in(document: Any, path: Path, line: int) -> list[Any] | str:
    """Find the plan in an answer: its entries, or a text."""
    while isinstance(document, dict):
        key = next(
            (
                key
                for key in (*_PLANS, *_AROUND)
                if document.get(key) or (key in _PLANS and document.get(key) == [])
            ),
            None,
        )
        if key is None:
            names = ", ".join(map(repr, list(document)[:8])) or "nothing"
            raise InvalidPlan(path, line, f"the JSON has no plan, but {shortened(names)}; {_VALID_JSON}")
        document = document[key]
        if key == "plans" and isinstance(document, list):
            if len(document) != 1:
                raise InvalidPlan(path, line, f"the JSON has {len(document)} plans; valid: one")
            document = document[0]
    if not isinstance(document, list | str):
        raise InvalidPlan(path, line, f"the plan in the JSON is {shortened(repr(document))}; {_VALID_JSON}")
    return document


def _step_of(entry: Any) -> tuple[str, str]:
    """Return what an entry calls its action, and the step as a line; no line if it is none."""
    fields = entry if isinstance(entry, dict) else {"name": entry}
    said, arguments, time = (
        next((fields[key] for key in keys if key in fields), None) for keys in (_NAMES, _ARGUMENTS, _TIMES)
    )
    words = [said, *(arguments if isinstance(arguments, list) else [])]
    if not (all(isinstance(word, str) for word in words) and isinstance(time, int | float | None)):
        return "", ""
    name, written = str(said), str(said)
    if words[1:] and len(name.strip(" ()").split()) == 1:
        written = f"({' '.join((name.strip(' ()'), *words[1:]))})"
    return name, written if time is None else f"{time}: {written}"


MOST_PLAN = 16 * MEGABYTE
"""Greater files are no plans [bytes]."""
LONGEST_ACTION = 200
"""So much of a ground action is quoted."""
_REACHED = "reach-goal"
_FORMER_NOTES = {_REACHED, "look-on", "reach-place", "leave-start", *(f"move-{axis}" for axis in AXES)}
"""Actions of earlier versions that are no step of their own; the page has some of that name, too."""
_FINISH, _LEAVE, _LADEN = "finish-", "leave-", "-laden"
"""What other actions of theirs began or ended with: what led an object on, took one away, or took a load."""
_ORIGINS = ("from-place", "from-object")
_FROM_TO = (2, 5)
"""So many arguments follow an object that is carried from one place to another, 5 in durative plans."""


def read_plan(path: Path, grounding: Grounding, problem: Problem) -> tuple[PlanStep, ...]:
    """Read a plan file that any planner wrote, in any of the forms of docs/other-plans.md.

    Args:
        path: The plan file.
        grounding: The learned domain; every operator of its table may occur, in the domain or not.
        problem: The problem that the plan is for.

    Raises:
        InvalidPlan: If a line cannot be read, or says what is not so; see `parse_plan`.
        InvalidFile: If the file is far too large, or no text.
    """
    return parse_plan(read_text(path, MOST_PLAN), path, grounding, problem)


def read_actions(path: Path, grounding: Grounding, problem: Problem) -> tuple[tuple[str, ...], ...]:
    """Read the ground actions of a plan file, each with its arguments, whatever they mean.

    Args:
        path: The plan file.
        grounding: The learned domain.
        problem: The problem that the plan is for.

    Raises:
        InvalidPlan: If a line cannot be read.
        InvalidFile: If the file is far too large, or no text.
    """
    is_known = _is_known(grounding, problem)
    return tuple(map(_words, written_plan(read_text(path, MOST_PLAN), path, is_known)))


def parse_plan(text: str, path: Path, grounding: Grounding, problem: Problem) -> tuple[PlanStep, ...]:
    """Read the text of a plan.

    Args:
        text: The text.
        path: What errors name as its origin.
        grounding: The learned domain.
        problem: The problem that the plan is for.

    Raises:
        InvalidPlan: If a line cannot be read, names what does not exist, says what is not so when the plan
            is followed from the start, lacks what belongs to a step, or has no steps and does not say so.
    """
    return read_answer(text, path, understand(problem, grounding))


def read_answer(
    text: str, path: Path, task: Task, printed: Callable[[tuple[str, ...]], StripsProblem] | None = None
) -> tuple[PlanStep, ...]:
    """Read the text of a plan of a task, as it was printed.

    Args:
        text: The text.
        path: What errors name as its origin.
        task: The task.
        printed: Returns the problem with some objects led over cells, with all motions; as it is printed
            into a folder if not given.

    Raises:
        InvalidPlan: See `parse_plan`.
    """
    actions = written_plan(text, path, _is_known(task.grounding, task.problem))
    rows = [_words(action) for action in actions]
    while rows and rows[-1] == (_REACHED,):  # which some planners add
        rows.pop()
    try:
        return _steps(rows, task, printed)
    except Misread as error:
        action = actions[error.number]
        said = f"{error} (step {error.number + 1}, `{shortened(action.text, LONGEST_ACTION)}`)"
        raise InvalidPlan(path, action.line, said) from error


def _words(action: WrittenAction) -> tuple[str, ...]:
    """Return an action with hyphens for underscores, as some print them: no name has underscores."""
    return tuple(word.replace("_", "-") for word in (action.name, *action.arguments))


def _is_known(grounding: Grounding, problem: Problem) -> Callable[[str], bool]:
    """Return what says whether a word names an object, or an action of the domain or of earlier versions."""
    names = {CARRY, *_of_page(grounding), *problem.object_names}
    names |= {one.name for one in grounding.every_operator}

    def is_known(word: str) -> bool:
        name = word.replace("_", "-")
        bare = name.removeprefix(PUT_DOWN)
        return bool({name, bare} & names) or _is_note(name, grounding) or bool(_put(bare, grounding))

    return is_known


def _put(name: str, grounding: Grounding) -> RelationOperator | None:
    """Return what puts objects in relations by that name, which may say that the object bears something."""
    return grounding.relation_named(name.removesuffix(_LADEN))


def _of_page(grounding: Grounding) -> set[str]:
    return {action.name for action in strips.page(grounding).actions}


def _steps(
    rows: Sequence[tuple[str, ...]],
    task: Task,
    printed: Callable[[tuple[str, ...]], StripsProblem] | None,
) -> tuple[PlanStep, ...]:
    """Read ground actions, of whichever encoding they are."""
    names = _of_page(task.grounding)
    if rows and all(words[0] == CARRY for words in rows):
        return read_durative(rows, task)
    if rows and all(words[0] in names for words in rows):
        encoding = NUMBERS if is_numeric(rows) else PAGE
        if printed and encoding is PAGE:
            return read(rows, printed(led_in(rows, task)))
        return encoding.read(rows, task)
    for number, (name, *_) in enumerate(rows):
        if name in names - _FORMER_NOTES - {strips.LEAVE}:
            raise Misread(f"{name} is an action of the page, and others of the plan are not", number)
    return _in_short(rows, task)


def _in_short(rows: Sequence[tuple[str, ...]], task: Task) -> tuple[PlanStep, ...]:
    """Read actions that name operators."""
    steps, grounding = list[PlanStep](), task.grounding
    for number, (name, *arguments) in enumerate(rows):
        if not steps and name.startswith((_FINISH, *(f"move-{axis}" for axis in AXES))):
            raise Misread(f"nothing begins what {name} leads on", number)
        if not _is_note(name, grounding):
            try:
                steps.append(_step(name, arguments, task.flat, grounding))
            except (InvalidValue, UnknownChoice) as error:
                raise Misread(str(error).rstrip("."), number) from error
    return tuple(steps)


def _is_note(name: str, grounding: Grounding) -> bool:
    """Say whether an action of an earlier version is no step, but belonged to one or said what is so."""
    if name.startswith(_LEAVE):
        states = grounding.relations.states if grounding.relations else ()
        return name.removeprefix(_LEAVE) in {"start", "place", *(state.name for state in states)}
    whole, _, axis = name.removeprefix(_FINISH).rpartition("-")
    led = {one.name for one in grounding.every_operator}
    is_part = name.startswith(_FINISH) and axis in AXES and whole.removeprefix(PUT_DOWN) in led
    return is_part or name in _FORMER_NOTES


def _step(name: str, arguments: Sequence[str], problem: Problem, grounding: Grounding) -> PlanStep:
    if not arguments:
        raise InvalidValue("it names no object; valid: (operator object), and what else belongs to it")
    thing, *others = arguments
    item = problem.object_named(thing)
    if put := _put(name, grounding):
        rest = [one for one in problem.object_names if one != thing]
        if "".join(others[:1]) not in rest:
            said = f"no other object '{others[0]}'" if others else "it names no other object"
            raise InvalidValue(f"{said}; valid: {', '.join(rest)}")
        return PlanStep(put.name, thing, others[0])
    step = PlanStep(name, thing)
    operator = grounding.operator_named(step.base)
    if operator.category != item.category:
        raise InvalidValue(
            f"{operator.name} is for objects of category {grounding.category(operator.category).name}, "
            f"and {thing} is of category {grounding.category(item.category).name}"
        )
    if grounding.carries(operator):
        from_to = len(others) in _FROM_TO and others[1] not in _ORIGINS
        to = others[1] if from_to else "".join(others[:1])
        check_place(to, problem, grounding)
        return PlanStep(name, thing, to)
    if step.puts_down and not is_lift(operator):
        raise InvalidValue(f"{operator.name} does not end with the object held, so nothing can be put down")
    return step
