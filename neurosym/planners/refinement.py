"""From a problem to a plan that is believed: print PDDL, call a planner, read the plan, replay it.

A replay with exact displacements says whether the plan is true. If it is not, its steps are put in another
order, and if that does not help, it is planned again with smaller goal regions, and then on a finer grid.
"""

import dataclasses
import math
import reprlib
import textwrap
import time
from collections import Counter
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

import msgspec
import numpy as np

from neurosym.arrays import Float
from neurosym.drafts import naming
from neurosym.errors import InvalidPlan, InvalidPlanner
from neurosym.factories import one_line
from neurosym.grounding import Grounding
from neurosym.pddl.encoding_names import SAS, STRIPS, EncodingName
from neurosym.pddl.encodings import domain_text
from neurosym.pddl.numeric import STEPS as NUMERIC_STEPS
from neurosym.pddl.numeric import numeric_problem
from neurosym.pddl.plan_reading import read_answer
from neurosym.pddl.sas import sas_text
from neurosym.pddl.strips_problem import STEPS, StripsProblem, printed_cell
from neurosym.planners.aiming import aim
from neurosym.planners.around import plan_around, plan_likeliest
from neurosym.planners.by_places import MOST_LED, is_by_places, not_found, not_proved, plan_by_places
from neurosym.planners.edges import away_from_edges
from neurosym.planners.effort import UNTOLD, Effort, TimeIsUp, WorkIsUp, all_spent, within
from neurosym.planners.fast_downward import SAS_SUFFIX
from neurosym.planners.in_turns import plan_in_turns
from neurosym.planners.no_plan import Explanation, explain_clash, explain_no_plan
from neurosym.planners.one_by_one import plan_one_by_one
from neurosym.planners.ordering import mend
from neurosym.planners.planner import CEILING, ON_PAGE, Option, PddlCall, PddlProgram, Planner, Query
from neurosym.planners.result import LONGEST_REASON, PlannerAnswer, PlanResult, PlanStatus
from neurosym.planners.scratch import scratch_folder
from neurosym.problems import Problem
from neurosym.table import Table
from neurosym.tasks.steps import PlanStep
from neurosym.tasks.task import understand

ATTEMPTS = 4
"""How often a problem is solved before its replay must be right; the later half on a finer grid."""
FINER = 3
"""How many times finer that grid is."""


@dataclasses.dataclass(frozen=True, slots=True)
class _Slack:
    """How far plans must keep from the edge of what is allowed.

    Attributes:
        steps: How many steps with an object the rounding of is taken off its goal region.
        margin: How many cells at the edges of the table are not used.
        finer: How many times finer the grid is than that of the domain.
    """

    steps: int
    margin: int = 0
    finer: int = 1


_Solve = Callable[[Problem, _Slack], PlanResult]
_OffGrid = Callable[[Problem], PlanResult]


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
    solve = partial(plan_pddl, name=name, program=program)
    return Planner(name, about, solve, takes=takes, program=program, missing=missing, ceiling=ceiling)


def _answer(name: str, call: PddlCall, domain: Path, problem: Path, *, time_limit: float) -> PlannerAnswer:
    """Have a program answer, and refuse what is no answer."""
    answer: object = call(domain, problem, time_limit=time_limit)
    if not isinstance(answer, PlannerAnswer):
        kind = type(answer).__name__
        raise InvalidPlanner(name, f"gives a {kind} from call; valid: a PlannerAnswer")
    for part, kinds in (("status", PlanStatus), ("text", str), ("seconds", int | float), ("reason", str)):
        if not isinstance(getattr(answer, part), kinds):
            given = reprlib.repr(getattr(answer, part))
            raise InvalidPlanner(name, f"gives an answer with {part} = {given}; valid: see PlannerAnswer")
    return dataclasses.replace(answer, reason=one_line(answer.reason, LONGEST_REASON))


def plan_pddl(query: Query, *, name: str, program: PddlProgram) -> PlanResult:
    """Solve a problem with a PDDL planner, and believe the plan only if its exact replay is right.

    Args:
        query: What is asked.
        name: Name of the planner.
        program: What reads the files.

    Raises:
        UnknownChoice: If an object's category is unknown.
        InvalidValue: If the planner does not take the encoding.
        InvalidValue: If an object stands off the table, or its name means something else in the domain.
    """
    problem, grounding = query.problem, query.grounding
    asked = _Asked(query, program, program.encoding_for(name, query.encoding))
    if problem.is_met(problem.scene().positions):
        return PlanResult(PlanStatus.SOLVED, (), 0.0, "the goal is met at the start")
    if reason := explain_clash(problem, grounding):
        return PlanResult(PlanStatus.UNSOLVABLE, (), 0.0, reason)
    return within(query.time_limit, asked.search)


@dataclasses.dataclass(frozen=True, slots=True)
class _Asked:
    """A query to a program, in an encoding.

    Attributes:
        query: What is asked.
        program: What reads the files.
        encoding: What they are printed in, but where objects are carried to places.
    """

    query: Query
    program: PddlProgram
    encoding: EncodingName

    def search(self, deadline: float) -> PlanResult:
        """Plan until a deadline, or until the work is spent."""
        effort = Effort(self.query.work, deadline)
        try:
            found = self._any_way(effort)
        except WorkIsUp:
            found = all_spent(effort.work)
        return dataclasses.replace(found, work=effort.spent)

    def _any_way(self, effort: Effort) -> PlanResult:
        """Carry what can be carried, or lead everything over cells."""
        query, problem, grounding = self.query, self.query.problem, self.query.grounding
        takes_places = STRIPS in self.program.encodings and query.encoding in (None, STRIPS)
        if not (takes_places and is_by_places(problem, grounding)):
            return self._over_cells(problem, effort)
        carry = partial(
            self._solve,
            grounding=grounding,
            effort=effort,
            encoding=STRIPS,
            slack=_Slack(STEPS),
            carries=True,
        )
        for way in (self._in_turns, self._at_once) if query.encoding is None else (self._at_once,):
            result = way(carry, effort)
            if result.status is PlanStatus.SOLVED:
                return result
            if result.status is PlanStatus.UNSOLVABLE:
                return not_proved(result)
        if query.encoding == STRIPS:
            return result
        if len(problem.objects) > MOST_LED:
            return not_found(result)
        return not_proved(self._over_cells(problem, effort))

    def _in_turns(self, carry: Callable[[Problem], PlanResult], effort: Effort) -> PlanResult:
        """Carry and lead objects in turns, if any must be led; for all at once plans are mostly false."""
        self.query.tell("carrying objects out of the way of others that are led over cells")
        return plan_in_turns(
            self.query.problem, self.query.grounding, carry, partial(self._over_cells, effort=effort)
        )

    def _at_once(self, carry: Callable[[Problem], PlanResult], effort: Effort) -> PlanResult:
        """Plan for all objects at once, with places."""
        effort.check()
        self.query.tell("carrying all objects to places")
        return plan_by_places(self.query.problem, self.query.grounding, carry)

    def _over_cells(self, problem: Problem, effort: Effort) -> PlanResult:
        """Lead objects over cells, away from the edges of the table if that is possible."""
        self.query.tell(f"leading {', '.join(problem.unmet)} over cells")
        grounding = self.query.grounding
        if self.program.aims and not grounding.unit_costs:
            careful = away_from_edges(grounding, problem)
            result = self._attempt(problem, careful, effort)
            if result.status is PlanStatus.SOLVED:
                return dataclasses.replace(result, steps=aim(result.steps, problem, careful, effort.deadline))
        result = self._attempt(problem, grounding, effort)
        if result.status is PlanStatus.FAILED and not self._is_at_once(problem) and not grounding.unit_costs:
            # The most reliable plans are long, and long ones stand in each other's way; shorter ones may not.
            shorter = self._attempt(problem, msgspec.structs.replace(grounding, unit_costs=True), effort)
            if shorter.status is PlanStatus.SOLVED:
                return dataclasses.replace(shorter, reason=f"not the most reliable: {result.reason}")
        return result

    def _is_at_once(self, problem: Problem) -> bool:
        return self.query.whole or len(problem.objects) == 1

    def _attempt(self, problem: Problem, grounding: Grounding, effort: Effort) -> PlanResult:
        """Plan object by object, or for all at once, until a replay is right."""

        def believed(task: Problem, spending: Effort) -> PlanResult:
            def solve(task: Problem, slack: _Slack) -> PlanResult:
                found = self._solve(task, grounding, spending, self.encoding, slack)
                if found.status is PlanStatus.TIMEOUT:
                    raise TimeIsUp
                return found

            def off_grid(task: Problem) -> PlanResult:
                search = plan_likeliest if len(task.objects) == 1 else plan_around
                found = search(task, grounding, deadline=spending.deadline)
                spending.spend(found.work)
                return found

            try:
                return _believed(task, grounding, solve, off_grid if self.program.aims else None)
            except WorkIsUp:
                return all_spent(effort.work)

        if self._is_at_once(problem):
            return believed(problem, effort)
        return plan_one_by_one(problem, grounding, believed, effort)

    def _solve(
        self,
        problem: Problem,
        grounding: Grounding,
        effort: Effort,
        encoding: EncodingName,
        slack: _Slack,
        *,
        carries: bool = False,
    ) -> PlanResult:
        """Print domain and problem, in one file if in SAS+, call the planner, and read what it wrote."""
        if problem.is_met(problem.scene().positions):
            return PlanResult(PlanStatus.SOLVED, (), 0.0)
        effort.check()
        printed = _Printed(problem, grounding, encoding, slack, self.program, leads_all=not carries)
        with scratch_folder() as folder:
            domain, task = printed.write(folder)
            answer = self.program.call(domain, task, time_limit=effort.deadline - time.perf_counter())
        effort.spend(UNTOLD if answer.work is None else answer.work)
        try:
            steps = printed.read(answer.text)
        except InvalidPlan as error:
            reason = f"what the planner wrote cannot be read: {textwrap.shorten(str(error), 200)}"
            return PlanResult(PlanStatus.FAILED, (), answer.seconds, reason)
        return PlanResult(answer.status, steps, answer.seconds, answer.reason)


class _Printed:
    """What a program is given of a problem, and how its answer is read.

    Args:
        problem: The problem.
        grounding: What is believed of the domain.
        encoding: The encoding.
        slack: How far plans must keep from the edge of what is allowed.
        program: The program.
        leads_all: Whether every object with a goal is led over cells, even if it could be carried.
    """

    def __init__(
        self,
        problem: Problem,
        grounding: Grounding,
        encoding: EncodingName,
        slack: _Slack,
        program: PddlProgram,
        *,
        leads_all: bool,
    ):
        self._task, self._encoding, self._slack = understand(problem, grounding), encoding, slack
        self._costs = program.costs
        self._led = tuple(name for name in self._task.names if name in problem.goals and leads_all)
        self._led = self._led or self._task.led
        usual = printed_cell(self._task) if encoding == STRIPS else grounding.cell
        self._grid = _fitted(grounding, problem, max(usual, program.cell) / slack.finer)

    def write(self, folder: Path) -> tuple[Path, Path]:
        """Print domain and problem into a folder, in one file if in SAS+, and return the two."""
        slack, problem = self._slack, self._task.problem
        if self._encoding == SAS:
            both = folder / f"problem{SAS_SUFFIX}"
            _write(both, sas_text(problem, self._grid, steps=slack.steps, margin=slack.margin))
            return both, both
        domain, task = folder / "domain.pddl", folder / "problem.pddl"
        if self._encoding == STRIPS:
            learned, data = self._task.grounding, self._on_page(self._led, every=False).data()
        else:
            learned = self._grid
            data = numeric_problem(understand(problem, learned), steps=NUMERIC_STEPS * slack.steps)
        _write(domain, domain_text(learned, self._encoding, costs=self._costs))
        _write(task, data.text(costs=self._costs))
        return domain, task

    def read(self, text: str) -> tuple[PlanStep, ...]:
        """Read what a program wrote.

        Raises:
            InvalidPlan: If it is no plan of what was printed.
        """
        return read_answer(text, Path("its plan"), self._task, partial(self._on_page, every=True))

    def _on_page(self, led: Sequence[str], *, every: bool) -> StripsProblem:
        slack = self._slack
        return StripsProblem(
            self._task, led=led, grid=self._grid, steps=slack.steps, margin=slack.margin, every=every
        )


def _believed(
    problem: Problem, grounding: Grounding, solve: _Solve, off_grid: _OffGrid | None = None
) -> PlanResult:
    """Solve a problem until the replay of the plan is right; each time with more slack, and then finer.

    What rounds off no place, if it is given, is tried last; for one object it is quick, and tried second.
    """
    slack, said, wrong = _Slack(STEPS), "", ""
    alone = len(problem.objects) == 1
    for attempt in range(1, ATTEMPTS + 1):
        result = solve(problem, slack)
        if result.status is PlanStatus.UNSOLVABLE and (slack.steps or slack.margin):
            # What has no plan in a smaller region may have one in the whole.
            result = solve(problem, _Slack(0, 0, slack.finer))
        if result.status is PlanStatus.UNSOLVABLE:
            why = explain_no_plan(problem, grounding)
            if why.is_proved or slack.finer > 1:
                return _explained(result, why, slack.finer)
            wrong, longest, finer = "that there is none on so coarse a grid", 0, FINER
        elif result.status is not PlanStatus.SOLVED:
            return result
        else:
            steps, checked = mend(result.steps, problem, grounding)
            if checked.valid:
                return dataclasses.replace(result, steps=steps, reason=said)
            wrong = checked.reason
            longest = max(Counter(step.object for step in steps).values(), default=0)
            finer = FINER if attempt >= ATTEMPTS // 2 else slack.finer
        if off_grid and alone and attempt == 1:
            found = off_grid(problem)
            if found.status is PlanStatus.SOLVED:
                return dataclasses.replace(found, reason=f"searched for without a grid, for on it: {wrong}")
        said = f"attempt {attempt + 1}, after a replay that said: {wrong}"
        steps_reckoned = STEPS if finer > slack.finer else 2 * slack.steps
        slack = _Slack(max(steps_reckoned, longest), slack.margin + 1, finer)
    reason = f"no plan was true when replayed, in {ATTEMPTS} attempts; the last: {wrong}"
    if off_grid and not alone:
        found = off_grid(problem)
        if found.status is PlanStatus.SOLVED:
            return dataclasses.replace(found, reason=f"searched for without a grid: {reason}")
    return PlanResult(PlanStatus.FAILED, (), 0.0, reason)


def _write(file: Path, text: str) -> None:
    with naming(file):
        file.write_text(text)


def _fitted(grounding: Grounding, problem: Problem, cell: float) -> Grounding:
    """Keep only what the problem needs, on another grid, with a table that reaches to where objects stand."""
    categories = {item.category for item in problem.objects}
    kept = tuple(operator for operator in grounding.live if operator.category in categories)
    room = problem.room(grounding.table, rounded=0.0)
    (x_low, y_low), (x_high, y_high) = (edge.tolist() for edge in _edges(room))
    return msgspec.structs.replace(
        grounding,
        cell=cell,
        table=Table(x=(x_low, x_high), y=(y_low, y_high)),
        operators=msgspec.structs.replace(grounding.operators, operators=kept),
    )


def _edges(room: Float[np.ndarray, "2 M 2"]) -> tuple[Float[np.ndarray, "2"], Float[np.ndarray, "2"]]:
    return room[0].min(axis=0), room[1].max(axis=0)


def _explained(result: PlanResult, why: Explanation, finer: int) -> PlanResult:
    """Say whether a planner's "unsolvable" holds beyond its grid, and which goal is out of reach."""
    if why.is_proved:
        return dataclasses.replace(result, reason="; ".join(filter(None, (result.reason, why.reason))))
    on_grid = f"{result.reason} on a grid {finer} times finer than the domain's" if result.reason else ""
    return PlanResult(PlanStatus.NOT_FOUND, (), 0.0, "; ".join(filter(None, (on_grid, why.reason))))
