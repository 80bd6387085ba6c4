"""From a problem to a plan that is believed: print PDDL, call a planner, read the plan, replay it.

Where every object that has a goal can be carried, or relations are asked for, that takes one call. What is
led over cells is mended if the replay says no, or planned for again: with smaller goal regions, and on a
finer grid.
Several objects that cannot be carried are left to the joined search, unless they are asked for at once.
"""

import dataclasses
import math
import textwrap
from collections import Counter
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

import msgspec
import numpy as np

from neurosym.errors import InvalidPlan, InvalidPlanner
from neurosym.grounding import Grounding
from neurosym.pddl.numeric import STEPS as NUMERIC_STEPS
from neurosym.pddl.numeric import numeric_domain, numeric_problem
from neurosym.pddl.plan_reading import parse_plan
from neurosym.pddl.sas import sas_text
from neurosym.pddl.strips import page
from neurosym.pddl.strips_problem import STEPS, StripsProblem, printed_cell
from neurosym.pddl.syntax import NUMERIC, SAS, STRIPS, EncodingName
from neurosym.planners.action_counts import candidates, choices_of, ends_held, mend
from neurosym.planners.external import answer_to
from neurosym.planners.joined_plans import plan_in_turns, plan_singly
from neurosym.planners.no_plan import explain_clash, explain_no_plan
from neurosym.planners.planner import (
    CEILING,
    MET_AT_START,
    ON_PAGE,
    UNTOLD,
    Effort,
    Option,
    PddlCall,
    PddlProgram,
    Planner,
    PlannerAnswer,
    PlanResult,
    PlanStatus,
    Query,
    TimeIsUp,
    WorkIsUp,
    checked,
    within,
)
from neurosym.problems import Problem
from neurosym.tasks.options import step_cost
from neurosym.tasks.promises import usable
from neurosym.tasks.task import PARK, footprints_apart, is_reached, overlapping, understand, why_no_relation
from neurosym.tasks.transition import PlanStep, expected_success, operator_for, validate
from neurosym.world import Table

ATTEMPTS = 4
"""How often a problem is solved before its replay must be right; the later half on a finer grid."""
FINER = 3
"""How many times finer that grid is."""
STRIP = 0.04
"""Width of the strip at the edges of the table that is left free if it can be [m]."""
MOST_LED = 4
"""Objects that could be carried are led over cells, where no plan carries them, if there are no more.

With eight, the search for such a plan took tens of seconds, though some of them had no goal.
"""
DEARER = 1.1
"""What a way may cost beside the plan's own, to be likelier to come true."""
LONGER = 1
"""How many primitives more it may have."""
MOST_WAYS = 3000
"""How many ways of an object are judged."""
_ENOUGH = 0.08
"""Room beside an object along y, along which the fingers open, beyond which more makes no difference [m]."""
_FINGER = 0.02
"""An object that leaves so much room along x is not in the way of the fingers [m]."""
_TRIED = 3  # of the likeliest ways of an object are put into the plan, until one fits
_ANSWER = Path("its plan")


@dataclasses.dataclass(frozen=True, slots=True)
class _Slack:
    """How far plans must keep from the edge of what is allowed."""

    steps: int = STEPS  # how many steps with an object the rounding of is taken off its goal region
    margin: int = 0  # how many cells at the edges of the table are not used
    finer: int = 1  # how many times finer the grid is than that of the domain


def pddl_planner(
    name: str,
    about: str,
    call: PddlCall,
    encodings: Sequence[EncodingName] = ON_PAGE,
    cell: float = 0.0,
    missing: Callable[[], str] = str,
    ceiling: float = CEILING,
    aims: bool = False,
    costs: bool = True,
) -> Planner:
    """Return a planner that gives files of PDDL to a program, and believes only plans that come true.

    Args:
        name: What it is called: a lower-case letter, then a-z, 0-9 and hyphens.
        about: What it is, in a sentence without a full stop.
        call: Has the program read the files of domain and problem, and answer.
        encodings: Those of the domain that it takes, the one it does best with first.
        cell: Edge of the smallest cells that it is given at first, 0 for any [m].
        missing: Says what to do about what is not installed, or nothing if everything is.
        ceiling: When it gives up if the user sets no limit [s]; infinite if its budget counts work instead.
        aims: Whether its plans keep from the edges of the table, and give way to those that cost little more
            and are likelier to come true.
        costs: Whether it is told what steps cost; without, it reads the plain page.

    Raises:
        InvalidPlanner: If the name is not legal, or there is no such encoding.
    """
    if not callable(call):
        raise InvalidPlanner(name, f"has call = {call!r}; valid: a function of two files and a time limit")
    if not (isinstance(cell, int | float) and 0 <= cell < math.inf):
        raise InvalidPlanner(name, f"has cell = {cell!r}; valid: a length of at least 0 m")
    if isinstance(encodings, str) or not isinstance(encodings, Sequence):
        raise InvalidPlanner(name, f"has encodings = {encodings!r}; valid: a tuple of their names")
    program = PddlProgram(partial(_answer, name, call), tuple(encodings), cell, aims, costs)
    takes: frozenset[Option] = frozenset({"encoding", "whole", "unit-costs"})
    solve = partial(_plan_pddl, name=name, program=program)
    return Planner(name, about, solve, takes=takes, program=program, missing=missing, ceiling=ceiling)


def _answer(name: str, call: PddlCall, domain: Path, problem: Path, *, time_limit: float) -> PlannerAnswer:
    """Have a program answer, and refuse what is no answer."""
    return checked(name, call(domain, problem, time_limit=time_limit), PlannerAnswer, "call")


def _plan_pddl(query: Query, *, name: str, program: PddlProgram) -> PlanResult:
    """Solve a problem with a PDDL planner, and believe the plan only if its exact replay is right."""
    problem, grounding = query.problem, query.grounding
    encoding = program.encoding_for(name, query.encoding)
    if is_reached(problem, grounding):
        return MET_AT_START
    is_related = understand(problem, grounding).relates
    if reason := (why_no_relation if is_related else explain_clash)(problem, grounding):
        return PlanResult(PlanStatus.UNSOLVABLE, (), 0.0, reason)

    def search(deadline: float) -> PlanResult:
        effort = Effort(query.work, deadline)
        try:
            found = _Search(query, program, encoding, effort).any_way()
        except WorkIsUp:
            reason = f"the budget of {effort.work:,} states for a plan was used up"
            found = PlanResult(PlanStatus.NOT_FOUND, (), 0.0, reason)
        return dataclasses.replace(found, work=effort.spent)

    return within(query.time_limit, search)


@dataclasses.dataclass(frozen=True, slots=True)
class _Search:
    """A query to a program, the encoding of what is led over cells, and what may be spent."""

    query: Query
    program: PddlProgram
    encoding: EncodingName
    effort: Effort

    def any_way(self) -> PlanResult:
        """Carry what can be carried and relate what is to be related, or lead everything over cells."""
        query, problem, grounding = self.query, self.query.problem, self.query.grounding
        task = understand(problem, grounding)
        if task.relates:
            return self._in_one_call(problem)
        says_places = STRIPS in self.program.encodings and query.encoding != NUMERIC  # which has no places
        carries = grounding.is_refined and any(name in problem.goals for name in task.carried)
        if not (says_places and carries):
            return self._over_cells(problem)
        if task.led:
            query.tell("carrying objects out of the way of others that are led over cells")
            carry = partial(self._call, grounding=grounding, slack=_Slack(), carries=True)
            result = plan_in_turns(problem, grounding, carry, self._over_cells)
            if result.status in (PlanStatus.SOLVED, PlanStatus.UNSOLVABLE):
                return _not_proved(result)
        self.effort.check()
        query.tell("carrying all objects to places")
        result = self._in_one_call(task.flat)
        if result.status is PlanStatus.SOLVED:
            carries_all = all(step.place for step in result.steps)
            clearest = _clearest_first(result.steps, task.flat) if carries_all else result.steps
            is_true = validate(clearest, task.flat, grounding).valid
            return dataclasses.replace(result, steps=clearest) if is_true else result
        if len(problem.objects) <= MOST_LED:
            return _not_proved(self._over_cells(problem))
        none_led = f"among more than {MOST_LED} objects, none is led over cells that could be carried"
        reason = f"{result.reason}; {none_led}"
        return dataclasses.replace(result, status=PlanStatus.NOT_FOUND, reason=reason)

    def _in_one_call(self, problem: Problem) -> PlanResult:
        """Plan for all objects at once, with places and relations, and believe a plan that is true."""
        grounding = self.query.grounding
        result = self._call(problem, grounding, _Slack(), carries=True)
        if result.status is PlanStatus.UNSOLVABLE:
            reason = _why_none(problem, grounding)
            return dataclasses.replace(result, status=PlanStatus.NOT_FOUND, reason=reason)
        if not result.has_plan or (replay := validate(result.steps, problem, grounding)).valid:
            return result
        reason = f"the plan is not true when replayed: {replay.reason}"
        return PlanResult(PlanStatus.FAILED, (), result.seconds, reason)

    def _over_cells(self, problem: Problem) -> PlanResult:
        """Lead objects over cells, away from the edges of the table if that is possible."""
        self.query.tell(f"leading {', '.join(problem.unmet)} over cells")
        grounding = self.query.grounding
        if self.program.aims and not grounding.unit_costs:
            careful = _away_from_edges(grounding, problem)
            result = self._led(problem, careful)
            if result.status is PlanStatus.SOLVED:
                steps = _aim(result.steps, problem, careful, self.effort.deadline)
                return dataclasses.replace(result, steps=steps)
        result = self._led(problem, grounding)
        is_joined = len(problem.objects) > 1 and not self.query.whole
        if result.status is PlanStatus.FAILED and is_joined and not grounding.unit_costs:
            # The most reliable plans are long, and long ones stand in each other's way; shorter ones may not.
            shorter = self._led(problem, msgspec.structs.replace(grounding, unit_costs=True))
            if shorter.status is PlanStatus.SOLVED:
                return dataclasses.replace(shorter, reason=f"not the most reliable: {result.reason}")
        return result

    def _led(self, problem: Problem, grounding: Grounding) -> PlanResult:
        """Lead one object or all at once, or leave it to the joined search."""
        solve = partial(self._believed, grounding=grounding)
        if self.query.whole or len(problem.objects) == 1:
            return solve(problem)
        return plan_singly(problem, grounding, solve, self.effort)

    def _believed(self, problem: Problem, grounding: Grounding) -> PlanResult:
        """Solve a problem until the replay is right; each time with more slack, and then finer."""
        slack, said, wrong = _Slack(), "", ""
        for attempt in range(1, ATTEMPTS + 1):
            result = self._call(problem, grounding, slack)
            if result.status is PlanStatus.UNSOLVABLE and (slack.steps or slack.margin):
                # What has no plan in a smaller region may have one in the whole.
                result = self._call(problem, grounding, _Slack(0, 0, slack.finer))
            if result.status is PlanStatus.UNSOLVABLE:
                why, is_proved = explain_no_plan(problem, grounding)
                if is_proved or slack.finer > 1:
                    status = PlanStatus.UNSOLVABLE if is_proved else PlanStatus.NOT_FOUND
                    on_grid = f" on a grid {slack.finer} times finer than the domain's"
                    said = result.reason + ("" if is_proved or not result.reason else on_grid)
                    reason = "; ".join(filter(None, (said, why)))
                    return dataclasses.replace(result, status=status, reason=reason)
                wrong, longest, finer = "that there is none on so coarse a grid", 0, FINER
            elif result.status is not PlanStatus.SOLVED:
                return result
            else:
                cell = max(grounding.cell, self.program.cell)
                steps, replay = mend(result.steps, problem, grounding, cell=cell)
                if replay.valid:
                    return dataclasses.replace(result, steps=steps, reason=said)
                wrong = replay.reason
                longest = max(Counter(step.object for step in steps).values(), default=0)
                finer = FINER if attempt >= ATTEMPTS // 2 else slack.finer
            said = f"attempt {attempt + 1}, after a replay that said: {wrong}"
            reckoned = STEPS if finer > slack.finer else 2 * slack.steps
            slack = _Slack(max(reckoned, longest), slack.margin + 1, finer)
        reason = f"no plan was true when replayed, in {ATTEMPTS} attempts; the last: {wrong}"
        return PlanResult(PlanStatus.FAILED, (), 0.0, reason)

    def _call(
        self, problem: Problem, grounding: Grounding, slack: _Slack, *, carries: bool = False
    ) -> PlanResult:
        """Print a problem, call the planner, and read its answer; unless objects are carried, all is led."""
        if is_reached(problem, grounding):
            return PlanResult(PlanStatus.SOLVED, (), 0.0)
        self.effort.check()
        task, costs = understand(problem, grounding), self.program.costs
        encoding = STRIPS if carries else self.encoding
        led = task.led if carries else tuple(name for name in task.names if name in problem.goals)
        usual = printed_cell(task) if encoding == STRIPS else grounding.cell
        grid = _fitted(grounding, problem, max(usual, self.program.cell) / slack.finer)
        printed = partial(StripsProblem, task, grid=grid, steps=slack.steps, margin=slack.margin)
        if encoding == SAS:
            texts: tuple[str, ...] = (sas_text(problem, grid, steps=slack.steps, margin=slack.margin),)
        elif encoding == NUMERIC:
            data = numeric_problem(understand(problem, grid), steps=slack.steps * NUMERIC_STEPS)
            texts = numeric_domain(grid).text(costs=costs), data.text(costs=costs)
        else:
            texts = page(grounding).text(costs=costs), printed(led=led).data().text(costs=costs)
        answer = answer_to(self.program.call, texts, time_limit=self.effort.left)
        self.effort.spend(UNTOLD if answer.work is None else answer.work)
        if answer.status is PlanStatus.TIMEOUT:
            raise TimeIsUp
        try:
            steps = parse_plan(answer.text, _ANSWER, grounding, problem, partial(printed, every=True))
        except InvalidPlan as error:
            reason = f"what the planner wrote cannot be read: {textwrap.shorten(str(error), 200)}"
            return PlanResult(PlanStatus.FAILED, (), answer.seconds, reason)
        return PlanResult(answer.status, steps, answer.seconds, answer.reason)


def _why_none(problem: Problem, grounding: Grounding) -> str:
    """Say with which places there is no plan; with others there may be one."""
    parks, task = sum(name.startswith(PARK) for name in problem.places), understand(problem, grounding)
    said = f"there is no plan with the places of the problem, of which {parks} are free to park on"
    if fixed := [name for name in problem.unmet if task.relates and name not in task.carriers]:
        goals = "has a goal" if len(fixed) == 1 else "have goals"
        said += f"; {' and '.join(fixed)} {goals} on the table, and nothing carries it to places"
    return said


def _not_proved(result: PlanResult) -> PlanResult:
    """Say of what has no plan over cells that it was not found: something could have been carried."""
    if result.status is not PlanStatus.UNSOLVABLE:
        return result
    reason = f"no plan with the places that were drawn; without: {result.reason or 'unsolvable'}"
    return dataclasses.replace(result, status=PlanStatus.NOT_FOUND, reason=reason)


def _aim(
    steps: Sequence[PlanStep], problem: Problem, grounding: Grounding, deadline: float
) -> tuple[PlanStep, ...]:
    """Return a plan that costs little more and is likelier to come true, or else the plan, which is valid.

    A planner is content with any end in the goal ball, and small errors push what ends at its edge out of it.
    So for each object other ways to its goal are listed that cost little more, and judged by how likely they
    end inside, by the spreads that operators promise.
    """
    best = tuple(steps)
    likely = expected_success(best, problem, grounding)
    for name in problem.goals:
        own = [step for step in best if step.object == name]
        others = [step for step in best if step.object != name]
        if not own or ends_held(others, grounding):
            continue
        for way in _ways(own, problem, grounding, Effort(MOST_WAYS, deadline)):
            place = len(others) if ends_held(way, grounding) else best.index(own[0])
            joined = (*others[:place], *way, *others[place:])
            if not validate(joined, problem, grounding).valid:
                continue  # others are in the way
            if (found := expected_success(joined, problem, grounding)) > likely:
                best, likely = joined, found
                break
    return best


def _ways(
    own: Sequence[PlanStep], problem: Problem, grounding: Grounding, effort: Effort
) -> list[tuple[PlanStep, ...]]:
    """List the likeliest ways to bring an object to its goal that cost little more than its own steps."""
    alone = problem.only(own[0].object)
    ((name, goal),) = alone.goals.items()
    (choices,) = choices_of(alone, grounding)
    made = [operator_for(step, problem, grounding) for step in own if not step.puts_down]
    most = DEARER * sum(step_cost(operator, grounding) for operator in made)
    near = candidates(choices, goal, alone.tolerance, effort, moves=len(made) + LONGER, cost=most)
    ways = dict.fromkeys(choices.steps(name, one.moves, held=one.held) for one in near)
    return sorted(ways, key=lambda steps: -expected_success(steps, alone, grounding))[:_TRIED]


def _clearest_first(steps: Sequence[PlanStep], problem: Problem) -> tuple[PlanStep, ...]:
    """Put steps that carry in another order: first what has most room where it stands and where it goes.

    Steps with one object keep their order, and no object is carried to where another stands. If there is no
    such order, nothing is changed.
    """
    names, apart = problem.object_names, footprints_apart(problem)
    here = problem.scene().positions[:, :2].copy()
    left, ordered = list(steps), list[PlanStep]()
    while left:
        rooms: list[tuple[float, int]] = []
        for number, step in enumerate(left):
            row, there = names.index(step.object), np.array(problem.place_named(step.place))
            others = np.arange(len(names)) != row
            is_first = all(earlier.object != step.object for earlier in left[:number])
            if is_first and not overlapping(there, here[others], apart[row, others]).any():
                away = [np.abs(here[others] - spot) - apart[row, others] for spot in (here[row], there)]
                gaps = [float(room[room[:, 0] < _FINGER, 1].min(initial=_ENOUGH)) for room in away]
                rooms.append((-min(gaps), number))
        if not rooms:
            return tuple(steps)
        step = left.pop(min(rooms)[1])
        here[names.index(step.object)] = problem.place_named(step.place)
        ordered.append(step)
    return tuple(ordered)


def _away_from_edges(grounding: Grounding, problem: Problem) -> Grounding:
    """Leave a strip at the edges of the table free, but for goals there: what goes too far is lost."""
    spots = [goal[:2] for goal in problem.goals.values()]

    def kept(axis: int, bounds: tuple[float, float]) -> tuple[float, float]:
        low, high = bounds
        strip = min(STRIP, (high - low) / 4)
        wanted = [spot[axis] for spot in spots]
        return max(low, min(low + strip, *wanted)), min(high, max(high - strip, *wanted))

    table = Table(x=kept(0, grounding.table.x), y=kept(1, grounding.table.y))
    return msgspec.structs.replace(grounding, table=table)


def _fitted(grounding: Grounding, problem: Problem, cell: float) -> Grounding:
    """Keep only what the problem needs, on another grid, with a table that reaches to where objects stand."""
    used = {operator.name for item in problem.objects for operator in usable(grounding, item)}
    kept = tuple(operator for operator in grounding.live if operator.name in used)
    room = problem.room(grounding.table, rounded=0.0)
    (x_low, y_low), (x_high, y_high) = room[0].min(axis=0).tolist(), room[1].max(axis=0).tolist()
    return msgspec.structs.replace(
        grounding,
        cell=cell,
        table=Table(x=(x_low, x_high), y=(y_low, y_high)),
        objects=msgspec.structs.replace(grounding.objects, operators=kept),
    )
