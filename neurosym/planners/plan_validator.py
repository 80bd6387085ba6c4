"""Whether a plan is valid by the printed PDDL, as unified-planning's validator says, which is not ours."""

import warnings
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from neurosym.errors import InvalidValue
from neurosym.pddl.excerpt import Action, excerpt_for, parameters_of
from neurosym.wording import counted

if TYPE_CHECKING:
    from unified_planning.model import FNode, Parameter, State
    from unified_planning.model import Problem as Task
    from unified_planning.plans import SequentialPlan

_PLAIN = str.maketrans({"(": " ", ")": None, ",": None})


@dataclass(frozen=True, slots=True)
class PddlVerdict:
    """What a validator says of a plan.

    Attributes:
        valid: Whether it is a plan of the domain and the problem.
        reason: Why not; empty if it is.
        failed: Number of the action that cannot be performed, counted from 1; None if every one can.
    """

    valid: bool
    reason: str = ""
    failed: int | None = None


def validate_pddl(domain: str, problem: str, actions: Sequence[Action]) -> PddlVerdict:
    """Ask unified-planning's validator whether ground actions are a plan.

    Args:
        domain: The text of the domain.
        problem: The text of the problem.
        actions: The ground actions, in order.

    Raises:
        InvalidValue: If domain or problem is no PDDL that unified-planning reads.
    """
    if unknown := _unknown(domain, actions):
        return unknown
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # of what unified-planning imports, which is not ours to mend
        from unified_planning.exceptions import UPException
        from unified_planning.io import PDDLReader
        from unified_planning.plans import ActionInstance, SequentialPlan
        from unified_planning.shortcuts import get_environment

        get_environment().credits_stream = None
        part = excerpt_for(domain, problem, actions)
        try:
            task = PDDLReader().parse_problem_string(part.domain, part.problem)
        except (UPException, SyntaxError, AssertionError) as error:
            raise InvalidValue(f"unified-planning cannot read the printed PDDL: {error}.") from error
        if misfit := _misfit(task, actions):
            return misfit
        steps = [
            ActionInstance(
                task.action(name),
                tuple(task.environment.expression_manager.auto_promote(map(task.object, words))),
            )
            for name, *words in actions
        ]
        return _verdict(task, SequentialPlan(steps))


def _unknown(domain: str, actions: Sequence[Action]) -> PddlVerdict | None:
    """Say which action the domain does not have, or has with other parameters."""
    known = parameters_of(domain)
    for number, (name, *arguments) in enumerate(actions, start=1):
        if name not in known:
            return PddlVerdict(False, f"the domain has no action {name}", number)
        if known[name] != len(arguments):
            takes = f"{name} takes {counted(known[name], 'argument')}, not {len(arguments)}"
            return PddlVerdict(False, takes, number)
    return None


def _misfit(task: "Task", actions: Sequence[Action]) -> PddlVerdict | None:
    """Say which action names an object that there is not, or of another type."""
    for number, (name, *arguments) in enumerate(actions, start=1):
        for word, parameter in zip(arguments, task.action(name).parameters, strict=True):
            if not task.has_object(word):
                return PddlVerdict(False, f"the problem has no object {word}", number)
            if not parameter.type.is_compatible(task.object(word).type):
                return PddlVerdict(False, f"{word} is no {parameter.type.name}", number)
    return None


def _verdict(task: "Task", plan: "SequentialPlan") -> PddlVerdict:
    from unified_planning.engines import SequentialPlanValidator

    with SequentialPlanValidator() as validator:
        validator.skip_checks = True  # it doubts what it knows: costs that are functions of objects
        if validator.validate(task, plan):
            return PddlVerdict(True)
    return _why_not(task, plan)


def _why_not(task: "Task", plan: "SequentialPlan") -> PddlVerdict:
    """Say which action is the first that cannot be performed, or which goal is not met in the end."""
    from unified_planning.engines import UPSequentialSimulator

    with UPSequentialSimulator(task, error_on_failed_checks=False) as simulator:
        state = simulator.get_initial_state()
        for number, step in enumerate(plan.actions, start=1):
            given = dict(zip(step.action.parameters, step.actual_parameters, strict=True))
            if unmet := _unmet(task, state, step.action.preconditions, given):
                return PddlVerdict(False, f"{unmet} does not hold", number)
            then = simulator.apply(state, step)
            if then is None:
                return PddlVerdict(False, "its effects contradict each other", number)
            state = then
        return PddlVerdict(False, f"{_unmet(task, state, task.goals, {})} does not hold in the end")


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
                return f"({str(ground).translate(_PLAIN)})"
    return ""
