"""Problems for unified-planning, plans from it, and planning with its engines.

An engine runs in a process of its own, because the import is slow, engines write files into the current
folder, and their own time-outs leave processes behind.
"""

import warnings
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from neurosym.checks import check_kind
from neurosym.errors import InvalidValue, counted
from neurosym.grounding import Grounding
from neurosym.pddl.compiler import Action, domain_text, excerpt_for, parameters_of, problem_text
from neurosym.pddl.plan_reading import parse_plan
from neurosym.pddl.syntax import STRIPS, EncodingName
from neurosym.problems import Problem
from neurosym.tasks.transition import PlanStep

if TYPE_CHECKING:
    from unified_planning.model import FNode, Parameter, State
    from unified_planning.model import Problem as Task
    from unified_planning.plans import Plan


def to_unified_planning(
    problem: Problem, grounding: Grounding, encoding: EncodingName | None = None
) -> "Task":
    """Return a problem as unified-planning has it, which any of its engines may solve.

    Args:
        problem: The problem.
        grounding: The learned domain.
        encoding: How it is encoded; by default as on the page.

    Raises:
        InvalidValue: If something is not what it should be.
        UnknownChoice: If there is no such encoding.
    """
    from unified_planning.io import PDDLReader

    check_kind("problem", problem, Problem, "a Problem")
    check_kind("grounding", grounding, Grounding, "a Grounding")
    chosen = encoding or STRIPS
    texts = domain_text(grounding, chosen), problem_text(problem, grounding, chosen)
    return PDDLReader().parse_problem_string(*texts)


def from_unified_planning(plan: "Plan", problem: Problem, grounding: Grounding) -> tuple[PlanStep, ...]:
    """Return the steps of a plan that an engine of unified-planning made, as `execute` takes them.

    Args:
        plan: The plan, a sequence.
        problem: The problem that `to_unified_planning` was given.
        grounding: The learned domain.

    Raises:
        InvalidValue: If it is no sequence of actions.
        InvalidPlan: If it names an operator, object or pair that does not exist.
    """
    from unified_planning.plans import SequentialPlan

    check_kind("problem", problem, Problem, "a Problem")
    check_kind("grounding", grounding, Grounding, "a Grounding")
    if not isinstance(plan, SequentialPlan):
        raise InvalidValue(
            f"A {type(plan).__name__} is no plan in a sequence; valid: a SequentialPlan of unified-planning."
        )
    return parse_plan(_text(plan), Path("the plan"), grounding, problem)


def _text(plan: "Plan") -> str:
    lines = (" ".join((one.action.name, *map(str, one.actual_parameters))) for one in plan.actions)
    return "".join(f"({line})\n" for line in lines)


# Whether a plan is valid by the printed PDDL, as unified-planning's validator says, which is not ours


@dataclass(frozen=True, slots=True)
class PddlVerdict:
    """What a validator says of a plan."""

    valid: bool  # whether it is a plan of the domain and the problem
    reason: str = ""  # why not; empty if it is
    # number of the action that cannot be performed, counted from 1; None if every one can
    failed: int | None = None


def validate_pddl(domain: str, problem: str, actions: Sequence[Action]) -> PddlVerdict:
    """Ask the validator of unified-planning if actions are a plan by the texts of domain and problem."""
    known = parameters_of(domain)
    for number, (name, *arguments) in enumerate(actions, start=1):
        if name not in known:
            return PddlVerdict(False, f"the domain has no action {name}", number)
        if known[name] != len(arguments):
            takes = f"{name} takes {counted(known[name], 'argument')}, not {len(arguments)}"
            return PddlVerdict(False, takes, number)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of what unified-planning imports, which is not ours to mend
        from unified_planning.exceptions import UPException
        from unified_planning.io import PDDLReader
        from unified_planning.shortcuts import get_environment

        get_environment().credits_stream = None
        try:
            task = PDDLReader().parse_problem_string(*excerpt_for(domain, problem, actions))
        except (UPException, SyntaxError, AssertionError) as error:
            raise InvalidValue(f"unified-planning cannot read the printed PDDL: {error}.") from error
        return _verdict(task, actions)


def _verdict(task: "Task", actions: Sequence[Action]) -> PddlVerdict:
    """Say whether actions that the domain has are a plan."""
    from unified_planning.engines import SequentialPlanValidator
    from unified_planning.plans import ActionInstance, SequentialPlan

    steps = []
    for number, (name, *arguments) in enumerate(actions, start=1):
        for word, parameter in zip(arguments, task.action(name).parameters, strict=True):
            if not task.has_object(word):
                return PddlVerdict(False, f"the problem has no object {word}", number)
            if not parameter.type.is_compatible(task.object(word).type):
                return PddlVerdict(False, f"{word} is no {parameter.type.name}", number)
        objects = task.environment.expression_manager.auto_promote(map(task.object, arguments))
        steps.append(ActionInstance(task.action(name), tuple(objects)))
    with SequentialPlanValidator() as validator:
        validator.skip_checks = True  # it doubts what it knows: costs that are functions of objects
        found = validator.validate(task, SequentialPlan(steps))
    if found:
        return PddlVerdict(True)
    number, state, step = len(found.trace), found.trace[-1], found.inapplicable_action
    if step is None:
        return PddlVerdict(False, f"{_unmet(task, state, task.goals, {})} does not hold in the end")
    given = dict(zip(step.action.parameters, step.actual_parameters, strict=True))
    unmet = _unmet(task, state, step.action.preconditions, given)
    return PddlVerdict(
        False, f"{unmet} does not hold" if unmet else "its effects contradict each other", number
    )


def _unmet(
    task: "Task", state: "State", conditions: Iterable["FNode"], given: Mapping["Parameter", "FNode"]
) -> str:
    """Return the first condition that does not hold, as PDDL writes it; nothing if all do."""
    from unified_planning.model.walkers import StateEvaluator

    evaluate, put_in = StateEvaluator(task).evaluate, task.environment.substituter.substitute
    for condition in conditions:
        for part in condition.args if condition.is_and() else [condition]:
            ground = put_in(part, given)
            if not evaluate(ground, state).is_true():
                plain = str.maketrans({"(": " ", ")": None, ",": None})
                return f"({str(ground).translate(plain)})"
    return ""
