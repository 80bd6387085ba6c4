"""Whether a plan is one: by the printed PDDL, as a validator says that is not ours, and by its replay."""

from collections.abc import Iterator, Sequence
from pathlib import Path

import msgspec

from neurosym.errors import InvalidPlan, InvalidValue
from neurosym.grounding import Grounding
from neurosym.pddl.chances import expected_success
from neurosym.pddl.encoding_names import ENCODINGS, NUMERIC, EncodingName
from neurosym.pddl.encodings import ground_plan
from neurosym.pddl.excerpt import Action, parameters_of
from neurosym.pddl.plan_reading import read_actions, read_plan
from neurosym.pddl.problem import problem_text
from neurosym.planners.plan_validator import PddlVerdict, validate_pddl
from neurosym.problems import Problem
from neurosym.reading import read_text
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import DOMAIN_FILES, GROUNDING, printed_file
from neurosym.stages.plan_records import planned_tolerance
from neurosym.stages.planning import load_problem
from neurosym.tasks.steps import PlanStep, Steps, named_steps
from neurosym.tasks.task import understand
from neurosym.tasks.transition import validate


class PlanVerdict(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What is to be said of a plan without executing it.

    Attributes:
        problem: Name of the problem.
        plan: The plan's file.
        valid_by_pddl: Whether it is a plan of the printed domain and problem.
        valid_by_replay: Whether it leads to the goal when it is replayed with what was rehearsed.
        domain: The printed domain that it is judged by; empty if none has its actions.
        written_out: Whether it names steps alone, and was judged with the cells and places that these imply.
        pddl_reason: Why it is no plan by PDDL, or empty.
        pddl_failed: Number of the ground action that cannot be performed, counted from 1, if one cannot.
        replay_reason: Why it does not lead to the goal when replayed, or empty.
        replay_failed: Number of the step that is impossible, counted from 1, if one is.
        steps: Its steps; empty if it cannot be read as steps of this domain.
        chance: The chance that all steps go as promised; None if it cannot be read.
    """

    problem: str
    plan: str
    valid_by_pddl: bool
    valid_by_replay: bool
    domain: str
    written_out: bool
    pddl_reason: str
    pddl_failed: int | None
    replay_reason: str
    replay_failed: int | None
    steps: Steps
    chance: float | None

    @property
    def valid(self) -> bool:
        """Whether it is a plan by both."""
        return self.valid_by_pddl and self.valid_by_replay


def judge_plan(
    folder: DomainFolder, name: str, plan_file: Path, tolerance: float | None = None
) -> PlanVerdict:
    """Say whether a plan is valid, without executing it.

    Args:
        folder: The domain folder.
        name: Name of the problem.
        plan_file: The plan, in any form that is read.
        tolerance: How near objects must come by the replay [m]; as the problem says if not given.

    Raises:
        InvalidPlan: If the file cannot be read as a plan of this domain, nor of any printed one.
        UnknownChoice: If there is no such problem.
        StageMissing: If domain or scene is missing.
    """
    grounding = Grounding.load(folder.require(GROUNDING))
    own = load_problem(folder, name)
    actions = read_actions(plan_file, grounding, own)
    try:
        steps, unread = read_plan(plan_file, grounding, own.within(planned_tolerance(plan_file))), ""
    except InvalidPlan as error:
        if not any(_has(domain, actions) for _, domain in _domains(folder)):
            raise
        steps, unread = (), str(error)
    replay = None if unread else validate(steps, own.within(tolerance), grounding)
    judged = _by_pddl(folder, own, grounding, actions, steps)
    return PlanVerdict(
        problem=name,
        plan=str(plan_file),
        valid_by_pddl=judged.verdict.valid,
        valid_by_replay=replay is not None and replay.valid,
        domain=judged.domain,
        written_out=judged.written_out,
        pddl_reason=judged.verdict.reason,
        pddl_failed=judged.verdict.failed,
        replay_reason=replay.reason if replay else unread,
        replay_failed=replay.number if replay else None,
        steps=named_steps(steps),
        chance=round(expected_success(steps, own.within(tolerance), grounding), 4) if replay else None,
    )


class _Judged(msgspec.Struct, frozen=True):
    """What was said of a plan by one of the printed domains."""

    domain: str
    verdict: PddlVerdict
    written_out: bool = False


_NONE = _Judged("", PddlVerdict(False, "no printed domain has all of its actions"))


def _by_pddl(
    folder: DomainFolder,
    problem: Problem,
    grounding: Grounding,
    actions: Sequence[Action],
    steps: Sequence[PlanStep],
) -> _Judged:
    """Judge a plan by each printed domain that has its actions, until one takes it; or else written out."""
    judged = list[_Judged]()
    relates = understand(problem, grounding).relates
    for encoding, domain in _domains(folder):
        if _has(domain, actions) and not (relates and encoding == NUMERIC):
            verdict = _judged(domain, folder, problem, grounding, encoding, actions)
            judged.append(_Judged(DOMAIN_FILES[encoding], verdict))
            if verdict.valid:
                return judged[-1]
    if judged or not steps:
        return judged[0] if judged else _NONE
    try:
        plan = ground_plan(steps, problem, grounding)
    except InvalidValue as error:
        return _Judged("", PddlVerdict(False, str(error).rstrip(".")), written_out=True)
    domain = read_text(folder.require(DOMAIN_FILES[plan.encoding]))
    verdict = _judged(domain, folder, problem, grounding, plan.encoding, plan.actions)
    return _Judged(DOMAIN_FILES[plan.encoding], verdict, written_out=True)


def _domains(folder: DomainFolder) -> Iterator[tuple[EncodingName, str]]:
    """Yield the printed domains that are there, with their encodings."""
    for encoding in ENCODINGS:
        file = folder / DOMAIN_FILES[encoding]
        if file.is_file():
            yield encoding, read_text(file)


def _has(domain: str, actions: Sequence[Action]) -> bool:
    known = parameters_of(domain)
    return all(known.get(name) == len(arguments) for name, *arguments in actions)


def _judged(
    domain: str,
    folder: DomainFolder,
    problem: Problem,
    grounding: Grounding,
    encoding: EncodingName,
    actions: Sequence[Action],
) -> PddlVerdict:
    """Judge ground actions by a domain and the problem that is printed for it, or would be."""
    file = folder / printed_file(problem.name, encoding)
    text = read_text(file) if file.is_file() else problem_text(problem, grounding, encoding)
    return validate_pddl(domain, text, actions)
