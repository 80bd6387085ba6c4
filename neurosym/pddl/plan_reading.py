"""Reading plans: what a written plan means in a domain and a problem, as steps.

A step is one primitive on one object. Planners write ground actions of the printed domain, several for one
step; they are followed from the start, and each must be possible where it stands (`strips_plan`).

Steps in short name the operator and its object, and the place or the other object if there is one. Plans of
the encodings that earlier versions had name operators, too, with cells, counts and origins behind. These are
passed over: they belong to files that are not printed any more, and the exact replay judges the steps.
"""

from collections.abc import Callable, Sequence
from pathlib import Path

from neurosym.errors import InvalidPlan, InvalidValue, UnknownChoice, shortened
from neurosym.grounding import Grounding, is_lift
from neurosym.pddl import strips
from neurosym.pddl.durative import CARRY, read_durative
from neurosym.pddl.encodings import NUMBERS, PAGE
from neurosym.pddl.grid import AXES
from neurosym.pddl.numeric import is_numeric
from neurosym.pddl.strips_plan import Misread, led_in, read
from neurosym.pddl.strips_problem import StripsProblem
from neurosym.pddl.written_plans import WrittenAction, written_plan
from neurosym.problems import Problem
from neurosym.reading import MEGABYTE, read_text
from neurosym.related import relating
from neurosym.relation_operators import RelationOperator
from neurosym.tasks.moves import PUT_DOWN
from neurosym.tasks.places import check_place
from neurosym.tasks.steps import PlanStep
from neurosym.tasks.task import Task, understand

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
    return relating(name.removesuffix(_LADEN), grounding)


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
