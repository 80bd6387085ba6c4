"""Steps in words that name operators: `(operator object)`, and what earlier versions printed.

Steps in short name the operator and its object, and the place or the other object if there is one. Plans of
the encodings that earlier versions had name operators, too, with cells, counts and origins behind. These are
passed over: they belong to files that are not printed any more, and the exact replay judges the steps.
"""

from collections.abc import Iterator, Sequence

from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.grounding import Grounding, is_lift
from neurosym.pddl.grid import AXES
from neurosym.problems import Problem
from neurosym.related import relating
from neurosym.tasks.moves import PUT_DOWN
from neurosym.tasks.places import check_place
from neurosym.tasks.steps import PlanStep

FORMER_NOTES = ("reach-goal", "look-on", "reach-place", "leave-start", "move-x", "move-y", "move-z")
"""Actions of earlier versions that are no step of their own."""
_FINISH, _LEAVE = "finish-", "leave-"
"""What others of them began with: what led an object on, and what took one from where it stood."""
_MOVERS = tuple(f"move-{axis}" for axis in AXES)
_LADEN = "-laden"
_ORIGINS = ("from-place", "from-object")
_FROM_TO = (2, 5)
"""So many arguments follow an object that is carried from one place to another, 5 in durative plans."""


def is_step_word(name: str, grounding: Grounding) -> bool:
    """Say whether an action of that name is a step, or belongs to one.

    Args:
        name: The name.
        grounding: The learned domain.
    """
    if name in FORMER_NOTES or _is_part(name, grounding):
        return True
    bare = _bare(name)
    operators = {one.name for one in grounding.every_operator}
    return bare in operators or relating(bare.removesuffix(_LADEN), grounding) is not None


def read_steps(
    actions: Sequence[tuple[str, ...]], problem: Problem, grounding: Grounding
) -> Iterator[tuple[int, PlanStep]]:
    """Yield the steps that actions are, each with the number of its action, from 0.

    Args:
        actions: The ground actions.
        problem: The problem.
        grounding: The learned domain.

    Raises:
        Misnamed: If an action is no step for its object.
    """
    begun = False
    for number, (name, *arguments) in enumerate(actions):
        if not begun and name.startswith((_FINISH, *_MOVERS)):
            raise Misnamed(f"nothing begins what {name} leads on", number)
        if name in FORMER_NOTES or _is_part(name, grounding):
            continue
        begun = True
        try:
            yield number, _step(name, arguments, problem, grounding)
        except (InvalidValue, UnknownChoice) as error:
            raise Misnamed(str(error).rstrip("."), number) from error


class Misnamed(InvalidValue):
    """An action that is no step for its object.

    Attributes:
        number: The number of the action, from 0.
    """

    def __init__(self, problem: str, number: int):
        super().__init__(problem)
        self.number = number


def _is_part(name: str, grounding: Grounding) -> bool:
    """Say whether an action belonged to a step of an earlier version: it names an operator, or a relation."""
    if name.startswith(_LEAVE):
        states = grounding.relations.states if grounding.relations else ()
        return name.removeprefix(_LEAVE) in {"place", *(state.name for state in states)}
    whole, _, axis = name.removeprefix(_FINISH).rpartition("-")
    operators = {one.name for one in grounding.every_operator}
    return name.startswith(_FINISH) and axis in AXES and _bare(whole) in operators


def _bare(name: str) -> str:
    return name.removeprefix(PUT_DOWN)


def _step(name: str, arguments: Sequence[str], problem: Problem, grounding: Grounding) -> PlanStep:
    if not arguments:
        raise InvalidValue("it names no object; valid: (operator object), and what else belongs to it")
    thing, *others = arguments
    item = problem.object_named(thing)
    if put := relating(name.removesuffix(_LADEN), grounding):
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
