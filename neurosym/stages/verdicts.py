"""Verdicts: whether what a stage made is good, weak or useless, the likeliest reason, and what may help.

Each rule sets a stage's figures beside what is had for nothing: errors beside those of predictors that look
at nothing, operators beside leaving everything where it is, tasks reached beside what chance allows. The
constants are the thresholds; docs/learning.md has the rules as a table.
"""

import math
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Literal

import msgspec
import numpy as np

from neurosym.data.interactions import Interactions
from neurosym.data.origin import is_explored
from neurosym.errors import InvalidPlan, InvalidValue, counted, listed_briefly
from neurosym.files import read_text
from neurosym.grounding import Grounding
from neurosym.learning.training_report import TrainingReport
from neurosym.operators import MIN_TRIALS, TOLERANCE, Mode, Operator, OperatorTable
from neurosym.pair_operators import RelationOperators
from neurosym.pddl.compiler import Action, ground_plan, parameters_of, problem_text
from neurosym.pddl.plan_reading import read_actions, read_plan
from neurosym.pddl.syntax import ENCODINGS, NUMERIC, EncodingName
from neurosym.planners.unified_planning import PddlVerdict, validate_pddl
from neurosym.problems import Problem
from neurosym.stages.folder import DomainFolder
from neurosym.stages.layout import DOMAIN, DOMAIN_FILES, GROUNDING, printed_file
from neurosym.stages.planning import load_problem
from neurosym.stages.value_stages import actions_of, task_of
from neurosym.tasks.task import understand
from neurosym.tasks.transition import PlanStep, Steps, expected_success, named_steps, validate
from neurosym.values.domain import ValueDomain, ValueOperator
from neurosym.values.value_page import read_steps, value_page, value_problem, written

_Level = Literal["useless", "weak", "good", "unproven"]
LEVELS: tuple[_Level, ...] = ("useless", "weak", "good", "unproven")
"""The worst first; what proves nothing counts only where there is nothing else."""

USELESS_R2 = 0.1  # bits that explain less of how effects vary are useless
GOOD_R2 = 0.3  # bits that explain less are weak
LEAST_GAIN = 0.05  # errors less than this share below those of the best trivial predictor are weak
MOST = 0.5  # *most* is this share: of trials, operators, objects, and what a network without bits explains
FEW = 0.2  # fewer than this share of the operators keep their promise, or of the tasks are reached: useless
FEW_ROWS = 500  # where fewer interactions than this did not do, more of them are the likeliest remedy
LEAST_TOLD = 0.1  # if operators explain less of the mean square of effects, they tell no more than zero
FAR = 10  # effects of more tolerances than this are in too small a unit, if they are not met within one
WIDEST = 0.4  # a Wilson interval that is wider proves nothing
ENOUGH_TASKS = 21  # from so many tasks on, no Wilson interval is wider than that
_Z = 1.959964  # of 95 % of a normal distribution
_DECISIVE = "features and action parameters that decide what happens"
_MODEL = "model"  # what the errors of the trained model are called among those of trivial predictors


class Verdict(msgspec.Struct, frozen=True):
    """A judgement."""

    level: _Level  # good, weak or useless; or unproven, if the figures are too few to tell
    sentence: str  # what it is judged by
    remedy: str = ""  # the likeliest reason, and what may help; empty if it is good

    @property
    def lines(self) -> tuple[str, ...]:
        """The judgement as a command prints it."""
        remedy = (f"likeliest reason: {self.remedy}",) if self.remedy else ()
        return (f"verdict: {self.level}: {self.sentence}", *remedy)


def worst(verdicts: Iterable[Verdict]) -> Verdict:
    """Return the worst of several verdicts, of equals the first.

    Args:
        verdicts: One or more, in the order in which one thing follows from the other.
    """
    return min(verdicts, key=lambda verdict: LEVELS.index(verdict.level))


def _first(*rules: tuple[bool, str]) -> str:
    """Return the words of the first rule that applies."""
    return next(words for applies, words in rules if applies)


def judge_training(report: TrainingReport, data: Interactions) -> Verdict:
    """Judge how well effects are predicted through the bits, beside predictors that look at nothing.

    Args:
        report: What was measured after training.
        data: What was learned from. If actions are aimed at something, or the data are a user's own, effects
            are not known to be displacements, and are held to no tolerance.
    """
    r2, errors = report.r2_through_codes, report.mae.get(_MODEL, [])
    trivial = {name: sum(values) for name, values in report.mae.items() if name != _MODEL}
    best = min(trivial, key=lambda name: trivial[name], default="")
    gain = 1 - sum(errors) / trivial[best] if trivial.get(best) else 0.0
    is_aimed, is_ours = "reference" in data.origin, is_explored(data.origin)
    miss = max(errors, default=0.0) if is_ours and not is_aimed else 0.0
    sentence = f"R2 {r2:.2f} through the bits, errors {abs(gain):.0%} {'below' if gain >= 0 else 'above'} "
    sentence += f"those of {best or 'nothing'}"
    if miss > TOLERANCE:
        sentence += f"; they are {miss:.2g} on an axis, and {TOLERANCE:g} counts as promised"
    if r2 >= GOOD_R2 and gain >= LEAST_GAIN and miss <= TOLERANCE:
        return Verdict("good", sentence)
    mirrors = "" if data.origin.get("mirrors") else ", or name mirrors, if all looks the same in some"
    more, empty = f"bring more{mirrors}", report.empty_action_codes
    bits = "take another --seed, as codes stay empty" if empty else "use more --action-bits, --object-bits"
    without = f"a network without bits (R2 {report.r2_direct:.2f})"
    remedy = _first(
        (len(data) < FEW_ROWS, f"there are only {counted(len(data), 'interaction')}; {more}"),
        (report.r2_direct < GOOD_R2, f"{without} does hardly better; bring {_DECISIVE}, or {more}"),
        (r2 < MOST * report.r2_direct, f"bits lose most of {without}; {more if is_aimed else bits}"),
        (
            miss > TOLERANCE,
            f"{TOLERANCE:g} is too strict for effects so large; have goals met within a larger --tolerance",
        ),
        (True, f"little happens, or it scatters; {more}"),
    )
    return Verdict("useless" if r2 < USELESS_R2 else "weak", sentence, remedy)


def judge_operators(table: OperatorTable, usable: Collection[str] | None = None) -> Verdict:
    """Judge how surely operators keep their promise, beside leaving everything where it is.

    Args:
        table: The operators.
        usable: Names of those that can be planned with; all, if not given.
    """
    judged = [one for one in table.operators if one.promised is None]  # the others are the same, less likely
    sure = [one for one in judged if _is_mostly(one.successes, one.trials)]
    acting = {one.subject for one in sure if _acts(one) and (usable is None or one.name in usable)}
    idle = {one.name: one.share for one in table.categories if one.share and one.symbol not in acting}
    sentence = f"{len(sure)} of {counted(len(judged), 'operator')} keep their promise in most {table.trials}"
    if sure and idle:
        moves = f"{listed_briefly(list(idle))} ({sum(idle.values()):.0%} of objects)"
        sentence += f"; none of these moves {moves}"
    if not acting or len(sure) < FEW * len(judged):
        return Verdict("useless", sentence, _why_unkept(table, judged, len(sure)))
    if len(sure) < MOST * len(judged) or sum(idle.values()) > 1 - MOST:
        return Verdict("weak", sentence, _why_unkept(table, judged, len(sure)))
    return Verdict("good", sentence)


def judge_values(domain: ValueDomain) -> Verdict:
    """Judge what a domain of values can be planned with: how many operators mostly turn out as promised."""
    best = dict[tuple[str, str], ValueOperator]()
    for one in sorted(domain.operators, key=lambda one: one.outcome.count):
        best[one.category, one.label] = one
    sure = [one for one in best.values() if _is_mostly(one.outcome.count, one.trials)]
    sentence = (
        f"{len(sure)} of {counted(len(best), 'operator')} turn out as promised in most rows of the data"
    )
    if unsure := sum(3 * one.outcome.count < 2 * one.trials for one in sure):
        sentence += f", {unsure} of them in less than two thirds"
    moved = {
        cells.axis.name
        for one in sure
        for cells, step in zip(domain.cells, one.outcome.steps, strict=True)
        if not step.stays
    }
    if still := [axis.name for axis in domain.axes if axis.name not in moved]:
        sentence += f"; none of those that mostly do changes {listed_briefly(still)}"
    if len(sure) >= MOST * len(best) and sure and not still:
        return Verdict("good", sentence)
    remedy = "what has one symbol ends differently; use more bits, or bring more interactions"
    if len(sure) >= MOST * len(best):
        remedy = "what nothing surely changes needs no axis; leave it out of what actions change"
    return Verdict("weak" if sure and len(sure) >= FEW * len(best) else "useless", sentence, remedy)


def judge_domain(grounding: Grounding) -> Verdict:
    """Judge what a compiled domain can be planned with: as `judge_operators`, by the operators it has."""
    live = {operator.name for operator in grounding.live}
    found = judge_operators(grounding.objects, live)
    sentence = f"{found.sentence}; the domain has {counted(len(live), 'operator')}"
    return msgspec.structs.replace(found, sentence=sentence)


def judge_relations(table: RelationOperators) -> Verdict:
    """Judge how many pairs of objects can surely be brought into a state in which one bears the other.

    Operators that seldom do so are no flaw: each problem says with which pairs they are foreseen to.
    """
    bearing = {state.symbol for state in table.states if state.bears}
    served = {
        one.subject
        for one in table.operators
        if (end := one.promise) and end.kind in bearing and _is_mostly(end.count, one.trials)
    }
    share = sum(one.share for one in table.pairs if one.symbol in served)
    sentence = f"{share:.0%} of pairs are of a kind that an operator mostly puts on or into one another"
    if share >= MOST:
        return Verdict("good", sentence)
    remedy = "pairs of one kind end differently; bring more interactions (explore --relations)"
    return Verdict("useless" if share < FEW else "weak", sentence, remedy)


def _is_mostly(kept: int, trials: int) -> bool:
    """Say whether trials are enough to be believed, and most of them went well."""
    return trials >= MIN_TRIALS and kept >= MOST * trials


def _acts(operator: Operator) -> bool:
    """Say whether an operator promises what always zero would not have foretold within the tolerance."""
    promise = operator.promise
    return promise is not None and (
        promise.kind in ("held", "carried") or math.hypot(*promise.outcome) > TOLERANCE
    )


def _why_unkept(table: OperatorTable, judged: Collection[Operator], sure: int) -> str:
    """Say why promises are not kept, or are not worth much: the first reason that applies."""
    promises = [operator.promise for operator in judged if operator.promise]
    # what an operator does in the root mean square, whether or not that is always alike
    largest = max((math.hypot(*one.outcome, *one.scatter) for one in promises), default=0.0)
    is_of_data = table.measured == "data"  # a world is in metres
    more = "bring more interactions, or take fewer bits"
    rare, is_unsure = sum(one.trials < MIN_TRIALS for one in judged), sure < MOST * len(judged)
    is_far, within = largest > FAR * TOLERANCE, f"within {TOLERANCE:g} counts as promised; give them in a"
    is_untold = not promises or _told(promises) < LEAST_TOLD
    return _first(
        (rare > (1 - MOST) * len(judged), f"most have fewer than {MIN_TRIALS} {table.trials}; {more}"),
        (is_untold, f"what happens scatters; bring {_DECISIVE} and tell objects apart, or more interactions"),
        (is_unsure and is_of_data and is_far, f"effects of {largest:.2g} occur, and {within} larger unit"),
        (is_unsure, "what has one symbol ends differently; use more bits, or bring more interactions"),
        (largest <= TOLERANCE, f"no effect is large, and all {within} smaller unit"),
        (True, "what moves these objects was not found; explore more, or train with more --action-bits"),
    )


def _told(promises: Collection[Mode]) -> float:
    """Return the share of the mean square of effects that the means of operators explain.

    It is the R2 beside always zero. What is carried to a place ends near zero on purpose and does not count.
    """
    rows = [promise for promise in promises if promise.kind != "carried"]
    moved = sum(promise.count * float(np.square(promise.outcome).sum()) for promise in rows)
    scattered = sum(promise.count * float(np.square(promise.scatter).sum()) for promise in rows)
    return moved / (moved + scattered) if moved else float(not rows)


@dataclass(frozen=True, slots=True)
class Tries:
    """What became of tasks."""

    reached: int  # in how many the goal was reached
    found: int  # how many had a plan
    of: int  # how many there were


def judge_tries(tries: Mapping[str, Tries], *, how: str = "", tolerance: float = TOLERANCE) -> Verdict:
    """Judge how many tasks are reached, by the best planner, with what chance alone would allow.

    Doing nothing reaches none, as tasks that are met from the start do not count.

    Args:
        tries: How planners did on the same tasks.
        how: How their plans were followed, if that is worth saying.
        tolerance: How near each object had to come to its goal [m].
    """
    best = max(tries, key=lambda name: tries[name].reached)
    one = tries[best]
    if not one.of:
        sentence, remedy = "no task needed a plan", "all goals were met at the start; draw more tasks"
        return Verdict("unproven", sentence, remedy)
    low, high = wilson(one.reached, one.of)
    told = f"{best} reached {one.reached} of {counted(one.of, 'task')}{how and ' ' + how}"
    between = f"{low:.0%} to {high:.0%} with 95% confidence"
    if high - low > WIDEST:
        sentence = f"nothing is proved by {counted(one.of, 'task')}: {told}, which may be {between}"
        return Verdict("unproven", sentence, f"chance decides so few; draw {ENOUGH_TASKS} tasks or more")
    # who is proved to reach less: whose interval ends below
    behind = [name for name, other in tries.items() if wilson(other.reached, other.of)[1] < low]
    even = [name for name in tries if name not in (best, *behind)]
    sentence = f"{told}, {between}" + (f"; more than {listed_briefly(behind)}" if behind else "")
    sentence += f"; not proved to be more than {listed_briefly(even)}" if even else ""
    if low >= MOST:
        return Verdict("good", sentence)
    remedy = _first(
        (one.found < MOST * one.of, "most tasks have no plan; explore more, or take more --action-bits"),
        (tolerance < TOLERANCE, f"goals within {tolerance:g} ask too much; allow a larger --tolerance"),
        (True, "plans are found and miss; bring more interactions"),
    )
    return Verdict("useless" if high < FEW else "weak", sentence, remedy)


def wilson(reached: int, of: int) -> tuple[float, float]:
    """Return the Wilson interval of a share, at 95 % (Wilson, 1927)."""
    share, squared = reached / of, _Z**2
    middle = (share + squared / (2 * of)) / (1 + squared / of)
    half = _Z / (1 + squared / of) * math.sqrt(share * (1 - share) / of + squared / (4 * of**2))
    return max(0.0, middle - half), min(1.0, middle + half)


# Whether a plan is one: by the printed PDDL, as a validator says that is not ours, and by its replay


class PlanVerdict(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    """What is to be said of a plan without executing it."""

    problem: str  # name of the problem
    plan: str  # the plan's file
    valid_by_pddl: bool  # whether it is a plan of the printed domain and problem
    valid_by_replay: bool  # whether it leads to the goal when it is replayed with what was rehearsed
    domain: str  # the printed domain that it is judged by; empty if none has its actions
    # whether it names steps alone, and was judged with the cells and places that these imply
    written_out: bool
    pddl_reason: str  # why it is no plan by PDDL, or empty
    # number of the ground action that cannot be performed, counted from 1, if one cannot
    pddl_failed: int | None
    replay_reason: str  # why it does not lead to the goal when replayed, or empty
    replay_failed: int | None  # number of the step that is impossible, counted from 1, if one is
    steps: Steps  # its steps; empty if it cannot be read as steps of this domain
    chance: float | None  # the chance that all steps go as promised; None if it cannot be read

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
    files = {encoding: folder / DOMAIN_FILES[encoding] for encoding in ENCODINGS}
    domains = {encoding: read_text(file) for encoding, file in files.items() if file.is_file()}
    try:
        steps, unread = read_plan(plan_file, grounding, own), ""
    except InvalidPlan as error:
        if not any(_has(domain, actions) for domain in domains.values()):
            raise
        steps, unread = (), str(error)
    replay = None if unread else validate(steps, own.within(tolerance), grounding)
    by, verdict, written_out = _by_pddl(folder, domains, own, grounding, actions, steps)
    return PlanVerdict(
        problem=name,
        plan=str(plan_file),
        valid_by_pddl=verdict.valid,
        valid_by_replay=replay is not None and replay.valid,
        domain=by,
        written_out=written_out,
        pddl_reason=verdict.reason,
        pddl_failed=verdict.failed,
        replay_reason=replay.reason if replay else unread,
        replay_failed=replay.number if replay else None,
        steps=named_steps(steps),
        chance=round(expected_success(steps, own.within(tolerance), grounding), 4) if replay else None,
    )


def judge_value_plan(folder: DomainFolder, name: str, plan_file: Path) -> PlanVerdict:
    """Say whether a plan with values is valid; see `judge_plan`."""
    task = task_of(folder, name)
    actions = actions_of(task, plan_file)
    steps, is_short = read_steps(actions, task.domain), all(words[0] != "act" for words in actions)
    said = task.replay(steps)[1]
    if is_short and not said:
        actions = written(steps, task)
    replay = said or task.strays(steps)
    verdict = validate_pddl(value_page(task.domain).text(), value_problem(task).text(), actions)
    return PlanVerdict(
        problem=name,
        plan=str(plan_file),
        valid_by_pddl=verdict.valid,
        valid_by_replay=not replay,
        domain=DOMAIN,
        written_out=is_short,
        pddl_reason=verdict.reason,
        pddl_failed=verdict.failed,
        replay_reason=replay,
        replay_failed=None,
        steps=named_steps(steps),
        chance=None if replay else round(task.chance(steps), 4),
    )


def _by_pddl(
    folder: DomainFolder,
    domains: Mapping[EncodingName, str],
    problem: Problem,
    grounding: Grounding,
    actions: Sequence[Action],
    steps: Sequence[PlanStep],
) -> tuple[str, PddlVerdict, bool]:
    """Judge a plan by each printed domain that has its actions, until one takes it; or else written out.

    Returned are the file of the domain, what is said of the plan by it, and whether it was written out.
    """

    def judged(encoding: EncodingName, actions: Sequence[Action]) -> PddlVerdict:
        file = folder / printed_file(problem.name, encoding)
        text = read_text(file) if file.is_file() else problem_text(problem, grounding, encoding)
        return validate_pddl(domains[encoding], text, actions)

    relates, found = understand(problem, grounding).relates, list[tuple[str, PddlVerdict, bool]]()
    for encoding, domain in domains.items():
        if _has(domain, actions) and not (relates and encoding == NUMERIC):
            found.append((DOMAIN_FILES[encoding], judged(encoding, actions), False))
            if found[-1][1].valid:
                return found[-1]
    if found:
        return found[0]
    if not steps:
        return "", PddlVerdict(False, "no printed domain has all of its actions"), False
    try:
        plan = ground_plan(steps, problem, grounding)
    except InvalidValue as error:
        return "", PddlVerdict(False, str(error).rstrip(".")), True
    folder.require(DOMAIN_FILES[plan.encoding])
    return DOMAIN_FILES[plan.encoding], judged(plan.encoding, plan.actions), True


def _has(domain: str, actions: Sequence[Action]) -> bool:
    known = parameters_of(domain)
    return all(known.get(name) == len(arguments) for name, *arguments in actions)
