"""Reading plans: what a written plan means in a domain and a problem, as steps.

A step is one primitive on one object. Planners write ground actions of the printed domain, several for one
step; they are followed from the start, and each must be possible where it stands (`strips_plan`). Plans in
short, and those of earlier versions, name operators instead (`step_words`).
"""

import dataclasses
import re
from collections.abc import Callable
from pathlib import Path

from neurosym.errors import InvalidPlan, shortened
from neurosym.grounding import Grounding
from neurosym.pddl import strips
from neurosym.pddl.durative import CARRY, read_durative
from neurosym.pddl.encodings import NUMBERS, PAGE
from neurosym.pddl.numeric import is_numeric
from neurosym.pddl.plan_forms import FORMS
from neurosym.pddl.plan_lines import Line, WrittenAction, unread
from neurosym.pddl.step_words import FORMER_NOTES, Misnamed, is_step_word, read_steps
from neurosym.pddl.strips import page
from neurosym.pddl.strips_plan import Misread, led_in, read
from neurosym.pddl.strips_problem import StripsProblem
from neurosym.pddl.written_plans import written_plan
from neurosym.problems import Problem
from neurosym.reading import MEGABYTE, read_text
from neurosym.tasks.moves import PUT_DOWN
from neurosym.tasks.steps import PlanStep
from neurosym.tasks.task import Task, understand

MOST_PLAN = 16 * MEGABYTE
"""Greater files are no plans [bytes]."""
LONGEST_ACTION = 200
"""So much of a ground action is quoted."""
_REACHED = "reach-goal"
_ALIKE = frozenset(FORMER_NOTES) | {strips.LEAVE}
"""Actions of the page that earlier versions had, too."""
_NO_STEPS = {
    *FORMER_NOTES,
    *(strips.MOVE_X, strips.MOVE_Y, strips.REACH_CELL, strips.REACH_LIFTED, strips.TAKE, strips.TAKE_OFF),
    *(strips.NOTE_CLEAR, strips.LEAVE),
}


def read_plan(path: Path, grounding: Grounding, problem: Problem) -> tuple[PlanStep, ...]:
    """Read a plan file that any planner wrote.

    Args:
        path: The plan file, in any of the forms of `plan_forms`.
        grounding: The learned domain; every operator of its table may occur, in the domain or not.
        problem: The problem that the plan is for.

    Raises:
        InvalidPlan: If a line cannot be read, or says what is not so; see `parse_plan`.
        InvalidFile: If the file is far too large, or no text.
    """
    text = read_text(path, MOST_PLAN)
    return parse_plan(text, path, grounding, problem)


def read_actions(path: Path) -> tuple[tuple[str, ...], ...]:
    """Read the ground actions of a plan file, each with its arguments, whatever they mean.

    Args:
        path: The plan file, in any of the forms of `plan_forms`.

    Raises:
        InvalidPlan: If a line cannot be read.
        InvalidFile: If the file is far too large, or no text.
    """
    actions = map(_hyphenated, written_plan(read_text(path, MOST_PLAN), path).actions)
    return tuple((one.name, *one.arguments) for one in actions)


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
    plan, grounding = written_plan(text, path), task.grounding
    known = _Names(grounding)
    for line in plan.passed:
        if name := known.named_in(line.text):
            said = f"{shortened(line.text.strip())!r} names {name} and is no step in a form that is read"
            raise InvalidPlan(path, line.number, f"{said}; valid: {_listed()}")
    if not (plan.actions or plan.is_empty):
        raise InvalidPlan(path, 1, f"what is written there has no steps; valid: {_listed()}")
    actions = tuple(_hyphenated(one) for one in plan.actions)
    for action in actions:
        if action.is_plain and not known.is_action(action.name):
            raise unread(Line(action.line, action.text), path)
    rows = [(one.name, *one.arguments) for one in actions]
    while rows and rows[-1] == (_REACHED,):  # which some planners add
        rows.pop()
    try:
        return _steps(rows, task, printed)
    except (Misread, Misnamed) as error:
        action = actions[error.number]
        written = shortened(action.text, LONGEST_ACTION)
        step = _number_of(rows, error.number)
        raise InvalidPlan(path, action.line, f"{error} (step {step}, `{written}`)") from error


def _steps(
    rows: list[tuple[str, ...]],
    task: Task,
    printed: Callable[[tuple[str, ...]], StripsProblem] | None,
) -> tuple[PlanStep, ...]:
    """Read ground actions, of whichever encoding they are."""
    names = {action.name for action in page(task.grounding).actions}
    if rows and all(words[0] == CARRY for words in rows):
        return read_durative(rows, task)
    if rows and all(words[0] in names for words in rows):
        encoding = NUMBERS if is_numeric(rows) else PAGE
        if printed and encoding is PAGE:
            return read(rows, printed(led_in(rows, task)))
        return encoding.read(rows, task)
    stray = next((number for number, words in enumerate(rows) if words[0] in names - _ALIKE), None)
    if stray is not None:
        name = rows[stray][0]
        raise Misread(f"{name} is an action of the page, and others of the plan are not", stray)
    return tuple(step for _, step in read_steps(rows, task.flat, task.grounding))


def _number_of(rows: list[tuple[str, ...]], at: int) -> int:
    """Return the number of the step that an action belongs to, from 1; putting down belongs to its lift."""
    begun = [words[0] for words in rows[: at + 1] if words[0] not in _NO_STEPS]
    return max(1, sum(not name.startswith(PUT_DOWN) and name != strips.PUT_DOWN for name in begun))


def _listed() -> str:
    return f"a step a line, like `{FORMS[0].example}`, or another form of `docs/other-plans.md`"


class _Names:
    """The names that actions have in a domain.

    Args:
        grounding: The learned domain.
    """

    def __init__(self, grounding: Grounding):
        self._grounding = grounding
        self._page = {action.name for action in page(grounding).actions}

    def is_action(self, name: str) -> bool:
        """Say whether something in the domain has that name."""
        return name == CARRY or name in self._page or is_step_word(name, self._grounding)

    def named_in(self, text: str) -> str | None:
        """Return the first word of a text that names an action, if one does."""
        words = (word.lower().replace("_", "-") for word in re.findall(r"[\w-]+", text))
        return next((word for word in words if self.is_action(word)), None)


def _hyphenated(action: WrittenAction) -> WrittenAction:
    """Return an action with hyphens for underscores, as some print them: no name has underscores."""
    if "_" not in "".join((action.name, *action.arguments)):
        return action
    name, *arguments = (word.replace("_", "-") for word in (action.name, *action.arguments))
    return dataclasses.replace(action, name=name, arguments=tuple(arguments))
