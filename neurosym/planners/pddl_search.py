"""From a problem to a plan that is believed: print PDDL, call a planner, read the plan, replay it.

A replay with exact displacements says whether the plan is true. If it is not, its steps are put in another
order, and if that does not help, it is planned again with smaller goal regions, and then on a finer grid.
"""

import dataclasses
import math
import reprlib
import textwrap
import threading
import time
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from functools import partial
from pathlib import Path

import msgspec

from neurosym.choices import one_line
from neurosym.errors import CannotStart, InvalidPlan, InvalidPlanner
from neurosym.files import naming
from neurosym.grounding import Grounding
from neurosym.pddl.compiler import NUMBERS, domain_text
from neurosym.pddl.plan_reading import read_answer
from neurosym.pddl.sas import sas_text
from neurosym.pddl.strips_problem import STEPS, StripsProblem, printed_cell
from neurosym.pddl.syntax import NUMERIC, SAS, STRIPS, EncodingName
from neurosym.planners.action_counts import candidates, choices_of, plan_counting
from neurosym.planners.external import SAS_SUFFIX
from neurosym.planners.joined_plans import (
    MOST_LED,
    is_by_places,
    not_found,
    not_proved,
    plan_by_places,
    plan_in_turns,
)
from neurosym.planners.no_plan import Explanation, explain_clash, explain_no_plan
from neurosym.planners.object_paths import plan_around
from neurosym.planners.plan_order import ends_held, mend
from neurosym.planners.planner import (
    CEILING,
    LONGEST_REASON,
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
    all_spent,
    within,
)
from neurosym.planners.process import end_calls, scratch_folder
from neurosym.problems import Problem
from neurosym.tasks.chances import expected_success
from neurosym.tasks.options import step_cost
from neurosym.tasks.task import Task, understand
from neurosym.tasks.transition import PlanStep, operator_for, validate
from neurosym.world import Table

ATTEMPTS = 4
"""How often a problem is solved before its replay must be right; the later half on a finer grid."""
FINER = 3
"""How many times finer that grid is."""
STRIP = 0.04
"""Width of the strip at the edges of the table that is left free if it can be [m]."""
NEARER = (1.0, 0.75, 0.5)
"""How near to the middle of its goal an object is to end, as shares of what is allowed."""
WORKERS = 2
"""How many objects are planned for at the same time."""
WORK_TO_COUNT = 20_000
"""How much counting looks at; see `Effort`."""
JOINED = "joined from plans of single objects"
"""What is said of a plan that was made so."""
DEARER = 1.1
"""What a way may cost beside the plan's own, to be likelier to come true."""
LONGER = 1
"""How many primitives more it may have."""
MOST_WAYS = 3000
"""How many ways of an object are judged."""
_TRIED = 3  # of the likeliest ways of an object are put into the plan, until one fits


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
    solve = partial(_plan_pddl, name=name, program=program)
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


def _plan_pddl(query: Query, *, name: str, program: PddlProgram) -> PlanResult:
    """Solve a problem with a PDDL planner, and believe the plan only if its exact replay is right."""
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
        says_places = STRIPS in self.program.encodings and query.encoding != NUMERIC  # which has no places
        if not (says_places and is_by_places(problem, grounding)):
            return self._over_cells(problem, effort)
        solve = partial(self._solve, grounding=grounding, effort=effort, encoding=STRIPS)
        carry = partial(solve, slack=_Slack(STEPS), carries=True)
        for way in (self._in_turns, self._at_once):
            result = way(carry, effort)
            if result.status is PlanStatus.SOLVED:
                return result
            if result.status is PlanStatus.UNSOLVABLE:
                return not_proved(result)
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
            careful = _away_from_edges(grounding, problem)
            result = self._attempt(problem, careful, effort)
            if result.status is PlanStatus.SOLVED:
                return dataclasses.replace(
                    result, steps=_aim(result.steps, problem, careful, effort.deadline)
                )
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
                found = _plan_likeliest(task, grounding, spending.deadline)
                spending.spend(found.work)
                return found

            try:
                is_quick = self.program.aims and len(task.objects) == 1
                return _believed(task, grounding, solve, off_grid if is_quick else None)
            except WorkIsUp:
                return all_spent(effort.work)

        if self._is_at_once(problem):
            return believed(problem, effort)
        return _plan_one_by_one(problem, grounding, believed, effort)

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
        """Print domain and problem, call the planner, and read what it wrote."""
        if problem.is_met(problem.scene().positions):
            return PlanResult(PlanStatus.SOLVED, (), 0.0)
        effort.check()
        task, program = understand(problem, grounding), self.program
        led = () if carries else tuple(name for name in task.names if name in problem.goals)
        usual = printed_cell(task) if encoding == STRIPS else grounding.cell
        grid = _fitted(grounding, problem, max(usual, program.cell) / slack.finer)
        printed = _Printed(task, led or task.led, grid, slack, program.costs)
        texts = _TEXTS[encoding](printed)
        answer = ask(program, texts, _FILES.get(encoding, FILES), effort.deadline)
        effort.spend(UNTOLD if answer.work is None else answer.work)
        return answered(answer, printed.read)


def _plan_one_by_one(
    problem: Problem, grounding: Grounding, believed: Callable[[Problem, Effort], PlanResult], effort: Effort
) -> PlanResult:
    """Solve a problem one object at a time; whole, if the hand would have to hold two in the end.

    Objects do not interact but by standing in each other's way. So each gets a plan of its own, which is
    cheap and makes every plan the cheapest; one that ends with its object held comes last. Where objects
    would end in each other, or no order of the steps leads past one, ways around each other are looked for
    (see `around`), and last the fewest primitives with which all objects end apart (see `counting`).
    """
    effort.check()
    parts = [effort.part for _ in problem.goals]
    tasks = zip(problem.goals, parts, strict=True)
    results = _plan_together([partial(believed, problem.only(name), part) for name, part in tasks])
    effort.spend(sum(part.spent for part in parts[: len(results)]))
    if results[-1].status is not PlanStatus.SOLVED:
        return results[-1]
    plans = dict(zip(problem.goals, results, strict=True))
    if sum(ends_held(plan.steps, grounding) for plan in results) > 1:
        return believed(problem, effort)
    held_last = sorted(problem.goals, key=lambda name: ends_held(plans[name].steps, grounding))
    joined = [step for name in held_last for step in plans[name].steps]
    steps, checked = mend(joined, problem, grounding)
    if checked.valid:
        said = "; ".join(dict.fromkeys((JOINED, *filter(None, (plan.reason for plan in results)))))
        return PlanResult(PlanStatus.SOLVED, steps, 0.0, said)
    for said, other in _other_ways(problem, grounding, effort):
        effort.spend(other.work)
        if other.status is PlanStatus.SOLVED:
            said = f"{JOINED}: they would have stood in each other's way, so {said}"
            return dataclasses.replace(other, reason=said)
    reason = f"no plan was true when replayed; the last: {checked.reason}"
    return PlanResult(PlanStatus.FAILED, (), 0.0, reason)


def _other_ways(problem: Problem, grounding: Grounding, effort: Effort) -> Iterator[tuple[str, PlanResult]]:
    """Plan for objects that stand in each other's way; say what that means, too."""
    yield "ways around each other were taken", plan_around(problem, grounding, deadline=effort.deadline)
    effort.check()
    yield "as few steps as possible were taken", plan_counting(problem, grounding, work=WORK_TO_COUNT)


def _plan_together(tasks: Sequence[Callable[[], PlanResult]]) -> tuple[PlanResult, ...]:
    """Make several plans at the same time; the results up to the first without a plan, in order.

    What still runs then, or when the user interrupts, is ended with all its processes.
    """
    threads: set[int] = set()

    def run(task: Callable[[], PlanResult]) -> PlanResult:
        threads.add(threading.get_ident())
        return task()

    futures: list[Future[PlanResult]] = []
    results: list[PlanResult] = []
    with ThreadPoolExecutor(WORKERS) as pool:
        try:
            for task in tasks:
                futures.append(_submitted(pool, partial(run, task)))
            for future in futures:
                results.append(future.result())
                if results[-1].status is not PlanStatus.SOLVED:
                    break
        finally:
            for future in futures:
                future.cancel()
            while not all(future.done() for future in futures):
                end_calls(threads)  # again until they give up: a portfolio starts its next search
                time.sleep(0.02)
    return tuple(results)


def _submitted(pool: ThreadPoolExecutor, task: Callable[[], PlanResult]) -> Future[PlanResult]:
    try:
        return pool.submit(task)
    except RuntimeError as error:
        raise CannotStart("planner", str(error)) from error


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
    ways = {
        steps: expected_success(steps, alone, grounding)
        for steps in (choices.steps(name, one.moves, held=one.held) for one in near)
    }
    return sorted(ways, key=lambda steps: -ways[steps])[:_TRIED]


def ask(program: PddlProgram, texts: Sequence[str], names: Sequence[str], deadline: float) -> PlannerAnswer:
    """Give domain and problem to a program.

    Args:
        program: The program.
        texts: Domain and problem.
        names: How their files are called.
        deadline: When the user's time is up, by `time.perf_counter()` [s].
    """
    with scratch_folder() as folder:
        files = [folder / name for name in names]
        for file, text in zip(files, texts, strict=True):
            with naming(file):
                file.write_text(text)
        return program.call(*files, time_limit=deadline - time.perf_counter())


def answered(answer: PlannerAnswer, read: Callable[[str], tuple[PlanStep, ...]]) -> PlanResult:
    """Return what a program says as a result.

    Args:
        answer: What it says.
        read: Reads a plan; raises `InvalidPlan` if it is none.
    """
    try:
        return PlanResult(answer.status, read(answer.text), answer.seconds, answer.reason)
    except InvalidPlan as error:
        reason = f"what the planner wrote cannot be read: {textwrap.shorten(str(error), 200)}"
        return PlanResult(PlanStatus.FAILED, (), answer.seconds, reason)


@dataclasses.dataclass(frozen=True, slots=True)
class _Printed:
    """What a program is given of a task, and how its answer is read.

    Attributes:
        task: The task.
        led: The objects that are led over cells.
        grid: The learned domain with the cells, and the table, that they are led over.
        slack: How far plans must keep from the edge of what is allowed.
        costs: Whether the program is told what steps cost.
    """

    task: Task
    led: Sequence[str]
    grid: Grounding
    slack: _Slack
    costs: bool

    def page(self) -> tuple[str, str]:
        """Print the page and its problem."""
        problem = self._on_page(self.led, every=False).data()
        return domain_text(self.task.grounding, costs=self.costs), problem.text(costs=self.costs)

    def numbers(self) -> tuple[str, str]:
        """Print the page in numbers and its problem."""
        problem = NUMBERS.problem(understand(self.task.problem, self.grid), (), self.slack.steps)
        return domain_text(self.grid, NUMERIC, costs=self.costs), problem.text(costs=self.costs)

    def sas(self) -> tuple[str, str]:
        """Print both in one in SAS+."""
        text = sas_text(self.task.problem, self.grid, steps=self.slack.steps, margin=self.slack.margin)
        return text, text

    def read(self, text: str) -> tuple[PlanStep, ...]:
        """Read a plan of what was printed."""
        return read_answer(text, Path("its plan"), self.task, partial(self._on_page, every=True))

    def _on_page(self, led: Sequence[str], *, every: bool) -> StripsProblem:
        slack = self.slack
        return StripsProblem(
            self.task, led=led, grid=self.grid, steps=slack.steps, margin=slack.margin, every=every
        )


_TEXTS = {STRIPS: _Printed.page, NUMERIC: _Printed.numbers, SAS: _Printed.sas}
"""How domain and problem are printed for a program."""
FILES = ("domain.pddl", "problem.pddl")
"""How their files are called."""
_FILES = {SAS: (f"problem{SAS_SUFFIX}",) * 2}


def _believed(
    problem: Problem, grounding: Grounding, solve: _Solve, off_grid: _OffGrid | None = None
) -> PlanResult:
    """Solve a problem until the replay of the plan is right; each time with more slack, and then finer.

    What rounds off no place, if it is given, is tried second.
    """
    slack, said, wrong = _Slack(STEPS), "", ""
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
        if off_grid and attempt == 1:
            found = off_grid(problem)
            if found.status is PlanStatus.SOLVED:
                return dataclasses.replace(found, reason=f"searched for without a grid, for on it: {wrong}")
        said = f"attempt {attempt + 1}, after a replay that said: {wrong}"
        steps_reckoned = STEPS if finer > slack.finer else 2 * slack.steps
        slack = _Slack(max(steps_reckoned, longest), slack.margin + 1, finer)
    reason = f"no plan was true when replayed, in {ATTEMPTS} attempts; the last: {wrong}"
    return PlanResult(PlanStatus.FAILED, (), 0.0, reason)


def _plan_likeliest(problem: Problem, grounding: Grounding, deadline: float) -> PlanResult:
    """Find the likeliest to come true of the cheapest and the shortest plans to ever smaller goals.

    The cheapest plan ends where it happens to, often at the edge of what is allowed.
    """
    without_costs = msgspec.structs.replace(grounding, unit_costs=True)
    results = [
        plan_around(
            msgspec.structs.replace(problem, tolerance=share * problem.tolerance), by, deadline=deadline
        )
        for share in NEARER
        for by in (grounding, without_costs)
    ]
    solved = [result for result in results if result.status is PlanStatus.SOLVED]
    best = max(solved, key=lambda one: expected_success(one.steps, problem, grounding), default=results[0])
    return dataclasses.replace(best, work=sum(result.work for result in results))


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
    categories = {item.category for item in problem.objects}
    kept = tuple(operator for operator in grounding.live if operator.category in categories)
    room = problem.room(grounding.table, rounded=0.0)
    (x_low, y_low), (x_high, y_high) = room[0].min(axis=0).tolist(), room[1].max(axis=0).tolist()
    return msgspec.structs.replace(
        grounding,
        cell=cell,
        table=Table(x=(x_low, x_high), y=(y_low, y_high)),
        operators=msgspec.structs.replace(grounding.operators, operators=kept),
    )


def _explained(result: PlanResult, why: Explanation, finer: int) -> PlanResult:
    """Say whether a planner's "unsolvable" holds beyond its grid, and which goal is out of reach."""
    if why.is_proved:
        return dataclasses.replace(result, reason="; ".join(filter(None, (result.reason, why.reason))))
    on_grid = f"{result.reason} on a grid {finer} times finer than the domain's" if result.reason else ""
    return PlanResult(PlanStatus.NOT_FOUND, (), 0.0, "; ".join(filter(None, (on_grid, why.reason))))
