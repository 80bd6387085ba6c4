"""Reading plans: what a written plan means in a domain and a problem, as steps.

A step is one primitive on one object. Planners write ground actions with cells or places as further
arguments, and in most encodings several for one step; reading folds them into steps (`plan_following`), and
checks that each argument is what is true there when the plan is followed from the start.
"""

import dataclasses
import re
from pathlib import Path

from neurosym.errors import InvalidPlan, shortened
from neurosym.grounding import Grounding
from neurosym.pddl.moves import CARRIERS, REACH_GOAL, Encoding
from neurosym.pddl.place_domain import NOTES
from neurosym.pddl.plan_cells import without_part
from neurosym.pddl.plan_following import Misread, follow
from neurosym.pddl.plan_forms import FORMS
from neurosym.pddl.plan_lines import Line, WrittenAction, unread
from neurosym.pddl.plan_text import PlanStep
from neurosym.pddl.relational_domain import LADEN, LEAVE
from neurosym.pddl.written_plans import written_plan
from neurosym.problems import Problem
from neurosym.reading import MEGABYTE, read_text
from neurosym.related import relating
from neurosym.tasks.moves import PUT_DOWN

MOST_PLAN = 16 * MEGABYTE
"""Greater files are no plans [bytes]."""
LONGEST_ACTION = 200
"""So much of a ground action is quoted."""
_CELLS_OF: tuple[Encoding, ...] = ("stepwise", "operators")
"""The encodings whose ways of naming cells are tried in turn; each is that of others, too."""


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
        grounding: The learned domain, on the grid that cells in the text are of.
        problem: The problem that the plan is for.

    Raises:
        InvalidPlan: If a line cannot be read, names what does not exist, says what is not so when the plan
            is followed from the start, lacks what belongs to a step, or has no steps and does not say so.
    """
    plan, known = written_plan(text, path), _Names(grounding)
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
    return _followed(actions, path, grounding, problem)


def _followed(
    actions: tuple[WrittenAction, ...], path: Path, grounding: Grounding, problem: Problem
) -> tuple[PlanStep, ...]:
    """Follow the actions in each way of naming cells, until one goes through; or tell why none does."""
    failures = list[Misread]()
    for encoding in _CELLS_OF:
        try:
            return follow(actions, problem, grounding, encoding)
        except Misread as error:
            failures.append(error)
    farthest = max(failures, key=lambda one: one.reached)  # the first of equals
    action = actions[farthest.reached[0]]
    written = shortened(action.text, LONGEST_ACTION)
    raise InvalidPlan(path, action.line, f"{farthest} (step {farthest.step}, `{written}`)") from farthest


def _listed() -> str:
    return f"a step a line, like `{FORMS[0].example}`, or another form of `docs/other-plans.md`"


class _Names:
    """The names that actions have in a domain.

    Args:
        grounding: The learned domain.
    """

    def __init__(self, grounding: Grounding):
        self._grounding = grounding
        self._operators = {one.name for one in grounding.every_operator}

    def is_action(self, name: str) -> bool:
        """Say whether something in the domain has that name."""
        if name in (REACH_GOAL, *NOTES, *CARRIERS) or (self._grounding.relations and name.startswith(LEAVE)):
            return True
        bare = without_part(name).removeprefix(PUT_DOWN)
        if bare in self._operators or relating(name, self._grounding):
            return True
        return relating(name.removesuffix(LADEN), self._grounding) is not None

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
