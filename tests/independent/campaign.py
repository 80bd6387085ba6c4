"""Random tables, given to every planner in every encoding; each answer is judged by what knows nothing of it.

A plan is judged by `replay`; what a PDDL planner wrote, by `ground_pddl` against the files that it had read.
Who says that there is no plan, or that one has the fewest primitives, is compared with all others, with the
plan that is known, and with `brute_force`.
"""

import itertools
import time
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from pathlib import Path

import msgspec
from independent.brute_force import Answer, Search
from independent.ground_pddl import judge, judge_sas
from independent.random_tables import Drawn
from independent.replay import (
    PUT_DOWN,
    displacement,
    domain_operators,
    lifts,
    promise_of,
    replay,
)

from neurosym.errors import InvalidValue
from neurosym.pddl.compiler import GroundPlan, domain_text, ground_plan, problem_text
from neurosym.pddl.numeric import numeric_problem
from neurosym.pddl.strips_problem import StripsProblem, printed_cell
from neurosym.pddl.syntax import ENCODINGS, NUMERIC, SAS, STRIPS, EncodingName
from neurosym.planners import PLANNERS, PlannerAnswer, PlanStatus, pddl_planner
from neurosym.planners.planner import PddlCall, Planner, Query
from neurosym.problems import Problem
from neurosym.tasks.task import understand
from neurosym.tasks.transition import PlanStep

FEW = 3
"""Brute force counts the primitives of so many objects."""


@dataclass
class Figures:
    """What a campaign found."""

    counts: dict[str, Counter[str]] = field(default_factory=lambda: defaultdict(Counter))
    seconds: Counter[str] = field(default_factory=Counter)
    findings: list[str] = field(default_factory=list)
    missing: dict[str, str] = field(default_factory=dict)
    tables: Counter[str] = field(default_factory=Counter)

    def lines(self) -> Iterable[str]:
        """List what was counted, and what was found."""
        yield f"tables: {sum(self.tables.values())} ({', '.join(f'{k} {n}' for k, n in self.tables.items())})"
        for contender, counted in self.counts.items():
            words = ", ".join(f"{word} {count}" for word, count in sorted(counted.items()))
            yield f"{contender}: {words}, {self.seconds[contender]:.0f} s"
        yield from (f"{name} is not installed: {why}" for name, why in self.missing.items())
        yield f"findings: {len(self.findings)}"
        yield from self.findings


@dataclass(frozen=True)
class Claim:
    """What a planner said of a table.

    Attributes:
        contender: The planner and the encoding.
        planner: The planner.
        status: How it ended.
        reason: What it said.
        fewest: How many primitives its plan has, if it has one that is valid.
    """

    contender: str
    planner: Planner
    status: PlanStatus
    reason: str
    fewest: int | None


def run(
    tables: Iterable[Drawn],
    *,
    time_limit: float,
    chosen: Callable[[str, str | None, Drawn], bool] = lambda *_: True,
    most_states: int = 200_000,
    figures: Figures | None = None,
) -> Figures:
    """Give tables to all planners, and judge what they answer.

    Args:
        tables: The tables.
        time_limit: How long each has for each [s].
        chosen: Which planner is asked, in which encoding, about which table.
        most_states: How many states brute force looks at.
        figures: What earlier campaigns found, to which this one adds.
    """
    figures = figures or Figures()
    figures.missing = {name: why for name, planner in PLANNERS.items() if (why := planner.missing())}
    for drawn in tables:
        figures.tables[drawn.kind] += 1
        claims = [
            _ask(planner, encoding, drawn, time_limit, figures)
            for planner in PLANNERS.values()
            if planner.name not in figures.missing
            for encoding in planner.encodings or (None,)
            if chosen(planner.name, encoding, drawn)
        ]
        few = len(drawn.problem.objects) <= FEW and drawn.own is None
        counted = Search(drawn.domain_json, drawn.scene_json, most_states).solve() if few else None
        _compare(claims, counted, drawn, figures)
        _judge_known(drawn, figures)
    return figures


def _ask(planner: Planner, encoding: str | None, drawn: Drawn, time_limit: float, figures: Figures) -> Claim:
    """Ask a planner, and judge its plan."""
    contender = f"{planner.name} {encoding}" if encoding else planner.name
    counts = figures.counts[contender]

    def find(text: str) -> None:
        figures.findings.append(f"table {drawn.number} ({drawn.kind}), {contender}: {text}")

    listener = _Listener(planner.program.call) if planner.program else None
    asked = _heard(planner, listener) if listener else planner
    begin = time.perf_counter()
    result = asked.solve(Query(drawn.problem, drawn.grounding, time_limit=time_limit, encoding=encoding))
    figures.seconds[contender] += time.perf_counter() - begin
    counts[result.status.value] += 1
    for domain, task, plan in listener.heard if listener else ():
        counts["answers in PDDL"] += 1
        if wrong := judge_sas(task, plan) if encoding == SAS else judge(domain, task, plan):
            find(f"its answer is wrong in what it was given: {wrong}\n{plan}")
    if result.status is not PlanStatus.SOLVED:
        return Claim(contender, planner, result.status, result.reason, None)
    steps = [(step.operator, step.object) for step in result.steps]
    wrong, top = replay(drawn.domain_json, drawn.scene_json, steps, drawn.own)
    counts["plans"] += 1
    if wrong:
        find(f"{wrong}: {steps}")
    live = {one["name"] for one in domain_operators(drawn.domain_json)}
    for name in {name.removeprefix(PUT_DOWN) for name, _ in steps}:
        if name not in live:
            find(f"{name} is not in the domain")
    if not wrong:
        _judge_printed(result.steps, drawn, find, counts)
    return Claim(contender, planner, result.status, result.reason, None if wrong else top.primitives)


class _Listener:
    """Hears what a program is given and what it answers; in several threads."""

    def __init__(self, call: PddlCall) -> None:
        self.call = call
        self.heard: list[tuple[str, str, str]] = []

    def __call__(self, domain: Path, problem: Path, *, time_limit: float) -> PlannerAnswer:
        answer = self.call(domain, problem, time_limit=time_limit)
        if answer.status is PlanStatus.SOLVED:
            self.heard.append((domain.read_text(), problem.read_text(), answer.text))
        return answer


def _heard(planner: Planner, listener: _Listener) -> Planner:
    assert planner.program is not None
    costs, cell = planner.program.costs, planner.program.cell
    return pddl_planner(planner.name, planner.about, listener, planner.encodings, cell, costs=costs)


def _judge_printed(
    steps: tuple[PlanStep, ...], drawn: Drawn, find: Callable[[str], None], counts: Counter[str]
) -> None:
    """Judge a plan as ground actions of the page: it is one of the problem that is printed for it.

    Where cells lose nothing, it is one of the problem as it is printed before anybody plans.
    """
    if not steps or _is_off_table(drawn):
        return
    try:
        plan = ground_plan(steps, drawn.problem, drawn.grounding)
    except InvalidValue as error:
        counts["led off the grid"] += 1  # which cells may be, where the table is not
        if _loses_nothing(drawn) or "off the grid" not in str(error):
            find(f"valid, but cannot be printed: {error}")
        return
    domain = domain_text(drawn.grounding)
    counts["printed"] += 1
    if wrong := judge(domain, problem_text(drawn.problem, drawn.grounding, plans=[plan]), plan.text):
        find(f"valid, but not in the problem that is printed for it: {wrong}")
    if not _loses_nothing(drawn) or any(_could_be_held(name, drawn) for name in drawn.problem.goals):
        return  # of several heights, the region may leave one out
    counts["printed with cells"] += 1
    if wrong := judge(domain, _problem(drawn.problem, drawn, STRIPS, 1, plan), plan.text):
        find(f"valid, but not in the printed problem: {wrong}")


def _loses_nothing(drawn: Drawn) -> bool:
    """Say whether all displacements and places are whole numbers of the cells that are printed."""
    return drawn.is_whole and printed_cell(understand(drawn.problem, drawn.grounding)) == drawn.grounding.cell


def _could_be_held(name: str, drawn: Drawn) -> bool:
    """Say whether a lift brings an object as high as its goal is."""
    item, goal = drawn.problem.object_named(name), drawn.problem.goals[name]
    return any(
        abs(float(displacement(one)[2]) + item.position[2] - goal[2]) <= drawn.problem.tolerance
        for one in drawn.domain_json["operators"]["operators"]
        if one["category"] == item.category and promise_of(one) is not None and lifts(one)
    )


def _problem(problem: Problem, drawn: Drawn, encoding: EncodingName, reckoned: int, plan: GroundPlan) -> str:
    """Print a problem, with the rounding of so many steps in mind, and with what a plan moves."""
    task = understand(problem, drawn.grounding)
    if encoding == NUMERIC:
        return numeric_problem(task, steps=reckoned).text()
    return StripsProblem(task, led=plan.led, steps=reckoned, kept=plan.moves).data().text()


def _judge_known(drawn: Drawn, figures: Figures) -> None:
    """Judge prefixes of the known plan by the theorem: what PDDL takes for valid meets the goal exactly.

    Goals are moved a little for each, so that the plan ends about where the tolerance does.
    """
    if drawn.known is None or _is_off_table(drawn):
        return
    steps = tuple(PlanStep(*step) for step in drawn.known)
    most = max(Counter(step.object for step in steps if not step.puts_down).values())
    for encoding, (dx, dy) in itertools.product(ENCODINGS, ((0.0, 0.0), (0.02, 0.01), (-0.03, 0.02))):
        goals = {name: (x + dx, y + dy, z) for name, (x, y, z) in drawn.problem.goals.items()}
        moved = msgspec.structs.replace(drawn.problem, goals=goals)
        try:
            plan = ground_plan(steps, moved, drawn.grounding, encoding)
        except InvalidValue:
            continue  # it leads off the grid
        text = _problem(moved, drawn, encoding, most, plan)
        if encoding == STRIPS and any(text.count(f"(goal-cell {name} ") < 2 for name in drawn.problem.goals):
            continue  # no bound vouches for a region of one cell
        figures.counts["theorem"]["plans judged"] += 1
        if judge(domain_text(drawn.grounding, encoding), text, plan.text):
            continue
        figures.counts["theorem"][f"valid in {encoding}"] += 1
        figures.counts["theorem"]["valid in PDDL"] += 1
        raw = {**drawn.scene_json, "goals": _decimals(goals)}
        if wrong := replay(drawn.domain_json, raw, drawn.known, drawn.own)[0]:
            figures.findings.append(f"table {drawn.number}, theorem, {encoding}, {dx, dy}: {wrong}")


def _decimals(goals: dict[str, tuple[float, float, float]]) -> dict:
    from independent.replay import read_text

    return read_text(msgspec.json.encode(goals).decode())


def _is_off_table(drawn: Drawn) -> bool:
    table = drawn.grounding.table
    return any(
        not low <= item.position[axis] <= high
        for item in drawn.problem.objects
        for axis, (low, high) in enumerate((table.x, table.y))
    )


def _compare(claims: list[Claim], counted: Answer | None, drawn: Drawn, figures: Figures) -> None:
    """Compare what planners say with each other's plans, the known one, and brute force."""
    lengths = {claim.contender: claim.fewest for claim in claims if claim.fewest is not None}
    if drawn.known is not None:
        lengths["the known plan"] = sum(not name.startswith(PUT_DOWN) for name, _ in drawn.known)
    if counted is not None:
        figures.counts["brute force"]["exact" if counted.is_exact else "cut off"] += 1
        if counted.fewest is not None:
            figures.counts["brute force"]["plans"] += 1
            lengths["brute force"] = counted.fewest
            if wrong := replay(drawn.domain_json, drawn.scene_json, counted.steps)[0]:
                figures.findings.append(f"table {drawn.number}, brute force: {wrong}")

    shortest = min(lengths, key=lambda name: lengths[name], default=None)
    for claim in claims:
        where = f"table {drawn.number} ({drawn.kind}), {claim.contender}"
        depth = claim.planner.depth
        within = shortest is not None and depth is not None and lengths[shortest] <= depth
        denies = claim.status is PlanStatus.UNSOLVABLE and shortest is not None
        if denies or (within and claim.status is PlanStatus.NOT_FOUND):
            figures.findings.append(
                f"{where} says {claim.status.value}, {claim.reason!r}, but {shortest} needs "
                f"{lengths[shortest]} primitives"
            )
        if claim.fewest is None or not (claim.planner.is_exact or depth):
            continue
        if shortest is not None and lengths[shortest] < claim.fewest:
            figures.findings.append(
                f"{where} takes {claim.fewest} primitives, and {shortest} {lengths[shortest]}"
            )
        if counted is not None and counted.fewest is None and claim.fewest <= counted.depth:
            figures.findings.append(f"{where} takes {claim.fewest} primitives, and brute force finds none")
