"""Reading plans: what a written plan means in a domain and a problem, as steps.

A step is one primitive on one object. Planners write ground actions of the printed domain, several for one
step; they are followed from the start, and each must be possible where it stands (`strips_plan`).

Steps in short name the operator and its object, and the place or the other object if there is one. Plans of
the encodings that earlier versions had name operators, too, with cells, counts and origins behind. These are
passed over: they belong to files that are not printed any more, and the exact replay judges the steps.

A line holds actions, or it is passed over: a comment, or what else a log says. But a line that names an
action or an object, and cannot be read, is refused, so that no step is lost. A service's answer in JSON
holds a plan as strings, as objects, or as text. No reader of a library does this.
"""

import math
import re
from collections.abc import Callable, Collection, Iterator, Sequence
from difflib import get_close_matches
from pathlib import Path
from typing import Any, NamedTuple

from neurosym.errors import InvalidFile, InvalidPlan, InvalidValue, UnknownChoice, shortened
from neurosym.files import MEGABYTE, decode_json, read_text
from neurosym.grounding import Grounding, is_lift
from neurosym.pddl import strips
from neurosym.pddl.durative import CARRY, read_durative
from neurosym.pddl.grid import AXES
from neurosym.pddl.numeric import read_numeric
from neurosym.pddl.strips_plan import led_in, read
from neurosym.pddl.strips_problem import StripsProblem
from neurosym.pddl.syntax import Atom
from neurosym.problems import Problem
from neurosym.tasks.options import PUT_DOWN
from neurosym.tasks.promises import promised
from neurosym.tasks.task import Task, understand
from neurosym.tasks.transition import PlanStep

MOST_PLAN = 16 * MEGABYTE
"""Greater files are no plans [bytes]."""
LONGEST_LINE = 100_000
"""Longer lines are no steps."""
LONGEST_ACTION = 200
"""So much of a ground action is quoted."""
VALID = "valid: a step a line, like `(move-x item-01 dx3 x40 x43)`, or another form of docs/other-plans.md"
_NUMBER = r"(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?"
_WORDS = r"[^\W\d][\w-]*(?:[\s,]+[\w-]+)*"
_AMOUNT = rf"(?:[a-z]+\s*:\s*)?{_NUMBER}"
_MARK = re.compile(r"\s*(?:[-*+•]|(?P<time>[0-9]{1,9})[.)])\s+(?=[(\w])")
"""What items of a list begin with; their numbers order them."""
_ACTION = re.compile(
    rf"""\s*(?:(?:(?:step|time)\s*)?(?P<time>{_NUMBER})\s*:\s*)?
    (?P<text>(?P<name>[^\W\d][\w-]*)?\((?P<group>[^()]*)\)|(?P<words>{_WORDS})) \s*
    (?P<marks>(?:\(\s*{_NUMBER}\s*\)\s*)? (?:\[\s*{_AMOUNT}(?:\s*[;,]\s*{_AMOUNT})*\s*\]\s*)?) ,?\s*""",
    re.VERBOSE | re.IGNORECASE,
)
"""An action: its time, its words with or without brackets, and what it costs or how long it takes."""
_LINE = re.compile(r"(?:[^\n()]+|\([^()]*\)|[()])+")
"""A line; what stands in brackets may go over several."""
_COMMENT = re.compile(r"(\[[^\[\]\n]*\])|;.*|(?:^|(?<=\s))#.*")
"""What is no comment though it holds a semicolon, or else a comment."""
_FENCE = re.compile(r"^[ \t]*(?:```|~~~).*", re.MULTILINE)
"""What a block of Markdown stands between."""
_BEGINS = re.compile(
    r"^(?:\[[^\]\n]*\] |\w+: )?[ \t;]*(?:solution found[!:]?|found (?:legal |new )?plan(?: as follows)?:?"
    r"|(?:best plan|plan computed):|plan found: [0-9]+ steps?|(?:(?:here is )?the )?plan:"
    r"|(?:sequential|timetriggered) ?plan:|(?<=;)[ \t]*(?:better |next |new )?(?:plan|solution)"
    r" (?:no\. ?)?[0-9]+\b.*)[ \t]*$",
    re.IGNORECASE | re.MULTILINE,
)
"""What logs say before a plan; there may be several, each better than the one before."""
_NONE = re.compile(
    r";\s*(?:cost\s*=\s*0\b|0 primitives\b)|plan[- ]length\s*:\s*0\b|\bempty plan\b|\bno steps\b", re.I
)
"""What says that a plan has no steps on purpose."""
_JSON = re.compile(r'\s*(?:\{|\[\s*(?:["{\[\]]|$))')
"""How an answer in JSON begins."""
_KEYS = ("plan", "sas_plan", "actions", "steps", "result", "output", "plans", "data")
_NAMES, _ARGUMENTS = ("name", "action"), ("arguments", "args", "parameters", "params", "objects")
_TIMES = ("time", "start_time", "start")
_VALID_JSON = "valid: a list of strings like '(name argument)', or of objects with a name and arguments"
_REACHED = "reach-goal"
_LADEN, _ORIGINS = "-laden", ("from-place", "from-object")
_MOVES = tuple(f"move-{axis}" for axis in AXES)
_FORMER = {_REACHED, "look-on", "reach-place", "leave-start", "leave-place", *_MOVES}
"""Actions of earlier versions that are no step of their own; the page has some of that name, too."""
_NEAR = 0.8  # how like an action of the page a name is at least that is taken for it, misspelt
_FROM_TO = (2, 5)
"""So many arguments follow an object that is carried from one place to another, 5 in durative plans."""


class _Written(NamedTuple):
    """An action as it was written: its words in lower case, its line from 1, and when it begins, if told."""

    words: Atom
    line: int
    text: str
    time: float | None
    is_plain: bool  # nothing but words, which might be prose


def read_plan(path: Path, grounding: Grounding, problem: Problem) -> tuple[PlanStep, ...]:
    """Read a plan file that any planner wrote, in any of the forms of docs/other-plans.md; see `parse_plan`.

    Every operator of the table may occur, in the domain or not.
    """
    return parse_plan(read_text(path, MOST_PLAN), path, grounding, problem)


def read_actions(path: Path, grounding: Grounding, problem: Problem) -> tuple[Atom, ...]:
    """Read the ground actions of such a file, each with its arguments, whatever they mean."""
    return read_words(read_text(path, MOST_PLAN), path, _known(grounding, problem))


def read_words(text: str, path: Path, known: Collection[str]) -> tuple[Atom, ...]:
    """Read the ground actions of the text of a plan, as words; names that are known make a line a step."""
    return tuple(one.words for one in _written(text, path, known))


def parse_plan(
    text: str,
    path: Path,
    grounding: Grounding,
    problem: Problem,
    printed: Callable[..., StripsProblem] | None = None,
) -> tuple[PlanStep, ...]:
    """Read the text of a plan, which errors say is from the path.

    `InvalidPlan` if a line cannot be read, names what does not exist, says what is not so when the plan is
    followed from the start, lacks what belongs to a step, or has no steps and does not say so. The problem
    with some objects led over cells, with all motions, is as it is printed into a folder if not given.
    """
    task, actions = understand(problem, grounding), _written(text, path, _known(grounding, problem))
    rows = [one.words for one in actions]
    while rows and rows[-1] == (_REACHED,):  # which some planners add
        rows.pop()
    begun, found = list[PlanStep | None](), _begun(rows, task, printed)
    try:
        for step in found:
            begun.append(step)
    except (InvalidValue, UnknownChoice) as error:
        number = min(len(begun), len(rows) - 1)
        said = str(error).rstrip(".")
        said += f" (step {number + 1}, `{shortened(actions[number].text, LONGEST_ACTION)}`)"
        raise InvalidPlan(path, actions[number].line, said) from error
    return tuple(step for step in begun if step)


# Text of any planner or service, read into ground actions


def _written(text: str, path: Path, known: Collection[str]) -> list[_Written]:
    """Read the last plan that a text holds, in the order of times; of equal ones, and without, as written."""
    text = _FENCE.sub("", "\n".join(text.splitlines()))
    if _JSON.match(text):
        text = _unwrapped(text, path)
    found, line, end, is_next, is_passed = list[_Written](), 1, 0, False, False
    bare = _COMMENT.sub(r"\1", _BEGINS.sub("\f", text))
    for match in _LINE.finditer(bare):
        line, end, said = line + bare.count("\n", end, match.start()), match.start(), match[0]
        actions = _actions_in(said, line)
        if said == "\f":
            is_next = True
        elif actions and all(one.words[0] in known for one in actions if one.is_plain):
            if is_next:
                found.clear()
            found += actions
            is_next = False
        elif len(said) > LONGEST_LINE or any(_word(one) in known for one in re.findall(r"[\w-]+", said)):
            said = " ".join(said.splitlines()).strip()
            raise InvalidPlan(path, line, f"{shortened(said)!r} is not of the form of a step; {VALID}")
        else:
            is_passed = is_passed or bool(said.strip())
    if is_passed and not found and not _NONE.search(text):
        raise InvalidPlan(path, 1, f"what is written there has no steps; {VALID}")
    untimed = [one for one in found if one.time is None]
    if untimed and len(untimed) < len(found):
        said = f"{shortened(untimed[0].text)!r} has no time, and other steps have one"
        raise InvalidPlan(path, untimed[0].line, said)
    return sorted(found, key=lambda one: one.time or 0.0)


def _actions_in(text: str, line: int) -> list[_Written]:
    """Return the actions that a line without comments consists of; none if it holds anything else."""
    if len(text) > LONGEST_LINE:
        return []
    mark = _MARK.match(text)
    at, time, found = mark.end() if mark else 0, mark and mark["time"], list[_Written]()
    while at < len(text):
        match = _ACTION.match(text, at)
        if match is None:
            return []
        at, time, is_bare = match.end(), match["time"] or time, bool(match["words"])
        words = (match["words"] or f"{match['name'] or ''} {match['group']}").strip(" \t\n,")
        begins, is_prose = float(time or 0), is_bare and text.startswith("(", at)
        if is_prose or not (re.fullmatch(_WORDS, words) and math.isfinite(begins)):
            return []
        is_plain = is_bare and not (match["marks"] or time)
        said = tuple(map(_word, re.split(r"[\s,]+", words)))
        written = " ".join(match["text"].split())
        found.append(_Written(said, line, written, begins if time else None, is_plain))
    return found


def _word(word: str) -> str:
    """Return a word with hyphens for underscores, as some print them: no name has underscores."""
    return word.lower().replace("_", "-")


def _unwrapped(text: str, path: Path) -> str:
    """Return the plan that the JSON of a service holds, a step a line; these are the lines that are told."""
    try:
        return "\n".join(_steps_in(decode_json(path, text.encode(), object)))
    except InvalidFile as error:
        said = str(error).partition(": ")[2].rstrip(".")
        raise InvalidPlan(path, 1, f"it begins like JSON, and cannot be read: {said}") from error
    except InvalidValue as error:
        raise InvalidPlan(path, 1, f"{error}; {_VALID_JSON}") from error


def _steps_in(document: Any) -> Iterator[str]:
    """List the steps of a plan in JSON, each as a line: of a text, a list, an object, or what is around."""
    if isinstance(document, str):
        yield from document.splitlines()
    elif isinstance(document, list):
        for entry in document:
            yield from _steps_in(entry)
    elif not isinstance(document, dict):
        raise InvalidValue(f"a step is {shortened(repr(document))}")
    elif key := next((one for one in _KEYS if document.get(one) or document.get(one) == []), None):
        found = document[key]
        if key == "plans" and isinstance(found, list) and len(found) != 1:
            raise InvalidValue(f"the JSON has {len(found)} plans")
        yield from _steps_in(found)
    else:
        name, arguments, time = (
            next((document[key] for key in keys if key in document), None)
            for keys in (_NAMES, _ARGUMENTS, _TIMES)
        )
        words: list[Any] = [name, *(arguments if isinstance(arguments, list) else [])]
        if not (all(isinstance(word, str) for word in words) and isinstance(time, int | float | None)):
            raise InvalidValue(f"a step or the plan is {shortened(repr(document))}")
        verb = words[0].strip(" ()")
        written = f"({verb} {' '.join(words[1:])})" if words[1:] and " " not in verb else words[0]
        yield written if time is None else f"{time}: {written}"


def _known(grounding: Grounding, problem: Problem) -> set[str]:
    """Name the objects, and all actions of the domain, in short and of earlier versions."""
    names = [one.name for one in grounding.operators]
    forms = [form for name in names for form in (name, f"{PUT_DOWN}{name}", f"{name}{_LADEN}")]
    page = {action.name for action in strips.page(grounding).actions}
    return {CARRY, *page, *problem.object_names, *_notes(grounding), *forms}


def _notes(grounding: Grounding) -> set[str]:
    """Name the actions of earlier versions that are no step, but belonged to one or said what is so."""
    left = {f"leave-{one.name}" for one in (grounding.relations.states if grounding.relations else ())}
    moves = [one.name for one in grounding.operators if one.frame != "pair"]
    ends = {f"finish-{first}{name}-{axis}" for name in moves for first in ("", PUT_DOWN) for axis in AXES}
    return {*_FORMER, *left, *ends}


# Ground actions, read as steps


def _begun(
    rows: Sequence[Atom], task: Task, printed: Callable[..., StripsProblem] | None
) -> Iterator[PlanStep | None]:
    """Return an iterator over ground actions, of whichever encoding they are: the step that each begins."""
    names, page = {words[0] for words in rows}, {one.name for one in strips.page(task.grounding).actions}
    if names == {CARRY}:
        return read_durative(rows, task)
    if not names or not names <= page:
        return _in_short(rows, task, page)
    if _is_numeric(rows):
        return read_numeric(rows, task)
    led = led_in(rows, task)
    return read(rows, printed(led=led) if printed else StripsProblem(task, led=led, every=True))


def _is_numeric(actions: Sequence[Atom]) -> bool:
    """Say whether ground actions are of the page in numbers, whose motions are each for one object."""
    begun = next((words for words in actions if words[0] in ("push", "lift")), ())
    return len(begun) == 3 and begun[2].endswith(f"-{begun[1]}")


def _in_short(rows: Sequence[Atom], task: Task, page: set[str]) -> Iterator[PlanStep | None]:
    is_begun, notes, others = False, _notes(task.grounding), page - _FORMER - {"leave"}
    others_named = {words[0][:100] for words in rows} - page - notes
    misspelt = {name for name in others_named if get_close_matches(name, page, 1, _NEAR)}
    for name, *arguments in rows:
        if name in misspelt:
            raise UnknownChoice("action", name, page)
        if name in others and not misspelt:
            raise InvalidValue(f"{name} is an action of the page, and others of the plan are not")
        if not is_begun and name.startswith(("finish-", *_MOVES)):
            raise InvalidValue(f"nothing begins what {name} leads on")
        is_begun = is_begun or name not in notes
        yield None if misspelt or name in notes else _step(name, arguments, task.flat, task.grounding)


def _step(name: str, arguments: Sequence[str], problem: Problem, grounding: Grounding) -> PlanStep:
    """Read an action that names an operator as a step."""
    if not arguments:
        raise InvalidValue("it names no object; valid: (operator object), and what else belongs to it")
    thing, *others = arguments
    item = problem.object_named(thing)
    step = PlanStep(name.removesuffix(_LADEN), thing)
    operator = grounding.operator_named(step.base)
    if operator.frame == "pair":
        rest = [one for one in problem.object_names if one != thing]
        if "".join(others[:1]) not in rest:
            said = f"no other object '{others[0]}'" if others else "it names no other object"
            raise InvalidValue(f"{said}; valid: {', '.join(rest)}")
        return PlanStep(operator.name, thing, others[0])
    if operator.frame == "side":  # whether it lies on that side is for the exact replay to judge
        return step
    if operator.subject != item.category and operator.name not in promised(grounding, item):
        raise InvalidValue(
            f"{operator.name} is for objects of category {grounding.category(operator.subject).name}, "
            f"and {thing} is of category {grounding.category(item.category).name}"
        )
    if operator.frame == "place":
        from_to = len(others) in _FROM_TO and others[1] not in _ORIGINS
        to = others[1] if from_to else "".join(others[:1])
        grounding.table.check(to, *problem.place_named(to))
        return PlanStep(name, thing, to)
    if step.puts_down and not is_lift(operator):
        raise InvalidValue(f"{operator.name} does not end with the object held, so nothing can be put down")
    return step
