"""Random tables, given to every planner in every encoding; each answer is judged by what knows nothing of it.

A plan is judged by `replay`, and by `ground_pddl` against the domain and problem that are printed for it. Who
says that there is no plan, or that one has the fewest primitives, is compared with all others, with the plan
that is known, and with `brute_force`.
"""

from collections import Counter, defaultdict
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field

from independent.brute_force import Search
from independent.ground_pddl import judge
from independent.random_tables import Drawn
from independent.replay import PUT_DOWN, domain_operators, replay

from neurosym.errors import InvalidValue
from neurosym.pddl.compiler import domain_text, ground_plan, problem_text
from neurosym.pddl.strips_problem import printed_cell
from neurosym.planners import PLANNERS, PlanStatus
from neurosym.planners.planner import Planner, Query
from neurosym.tasks.task import understand
from neurosym.tasks.transition import PlanStep

FEW = 3
"""Brute force counts the primitives of so many objects."""


@dataclass
class Figures:
    """What a campaign found: counts for each contender, and what must not be."""

    counts: dict[str, Counter[str]] = field(default_factory=lambda: defaultdict(Counter))
    findings: list[str] = field(default_factory=list)

    def lines(self) -> Iterable[str]:
        """List what was counted, and what was found."""
        for contender, counted in self.counts.items():
            yield f"{contender}: {', '.join(f'{word} {count}' for word, count in sorted(counted.items()))}"
        yield from (f"findings: {len(self.findings)}", *self.findings)


def run(
    tables: Iterable[Drawn],
    *,
    time_limit: float,
    chosen: Callable[[str, str | None, Drawn], bool] = lambda *_: True,
    most_states: int = 200_000,
    figures: Figures | None = None,
) -> Figures:
    """Give tables to all planners that are here and chosen, each for so long [s], and judge what they answer.

    Brute force looks at so many states. What is found is added to the figures of earlier campaigns.
    """
    figures = figures or Figures()
    here = [planner for planner in PLANNERS.values() if not planner.missing()]
    for drawn in tables:
        table = _Table(drawn, figures)
        for planner, encoding in ((one, name) for one in here for name in one.encodings or (None,)):
            if chosen(planner.name, encoding, drawn):
                table.ask(planner, encoding, time_limit)
        table.compare(most_states)
    return figures


@dataclass
class _Table:
    """A table, what is found of it and others, and what planners say of it.

    Claims say who said how it ended, what for, and how many primitives a valid plan has.
    """

    drawn: Drawn
    figures: Figures
    claims: list[tuple[str, Planner, PlanStatus, str, int | None]] = field(default_factory=list)

    def find(self, who: str, text: str) -> None:
        self.figures.findings.append(f"table {self.drawn.number} ({self.drawn.kind}), {who}: {text}")

    def ask(self, planner: Planner, encoding: str | None, time_limit: float) -> None:
        """Ask a planner, and judge its plan."""
        drawn, who = self.drawn, f"{planner.name} {encoding or ''}".strip()
        counts, fewest = self.figures.counts[who], None
        query = Query(drawn.problem, drawn.grounding, time_limit=time_limit, encoding=encoding)
        result = planner.solve(query)
        counts[result.status.value] += 1
        if result.status is PlanStatus.SOLVED:
            counts["plans"] += 1
            steps = [(step.operator, step.object) for step in result.steps]
            wrong, top = replay(drawn.domain_json, drawn.scene_json, steps)
            live = {one["name"] for one in domain_operators(drawn.domain_json)}
            if strange := {name.removeprefix(PUT_DOWN) for name, _ in steps} - live:
                self.find(who, f"{strange} not in the domain")
            if wrong:
                self.find(who, f"{wrong}: {steps}")
            else:
                fewest = top.primitives
                self.judge_printed(result.steps, who)
        self.claims.append((who, planner, result.status, result.reason, fewest))

    def judge_printed(self, steps: tuple[PlanStep, ...], who: str) -> None:
        """Judge a plan as ground actions of the page: it is one of the problem that is printed for it."""
        drawn, counts = self.drawn, self.figures.counts[who]
        if not steps or not all(map(drawn.grounding.table.contains, drawn.problem.scene().positions)):
            return
        cell = printed_cell(understand(drawn.problem, drawn.grounding))
        is_exact = drawn.is_whole and cell == drawn.grounding.cell
        try:
            plan = ground_plan(steps, drawn.problem, drawn.grounding)
        except InvalidValue as error:
            counts["led off the grid"] += 1  # which cells may be, where the table is not
            if is_exact or "off the grid" not in str(error):
                self.find(who, f"valid, but cannot be printed: {error}")
            return
        domain = domain_text(drawn.grounding)
        counts["printed"] += 1
        if wrong := judge(domain, problem_text(drawn.problem, drawn.grounding, plans=[plan]), plan.text):
            self.find(who, f"valid, but not in the problem that is printed for it: {wrong}")

    def compare(self, most_states: int) -> None:
        """Compare what planners say with each other's plans, the known one, and brute force."""
        drawn, counted = self.drawn, None
        lengths = {who: fewest for who, _, _, _, fewest in self.claims if fewest is not None}
        if drawn.known is not None:
            lengths["the known plan"] = sum(not name.startswith(PUT_DOWN) for name, _ in drawn.known)
        if len(drawn.problem.objects) <= FEW:
            counted = Search(drawn.domain_json, drawn.scene_json, most_states).solve()
            if counted.fewest is not None:
                self.figures.counts["brute force"]["plans"] += 1
                lengths["brute force"] = counted.fewest
                if wrong := replay(drawn.domain_json, drawn.scene_json, counted.steps)[0]:
                    self.find("brute force", wrong)
        shortest = min(lengths, key=lambda name: lengths[name], default=None)
        least = lengths.get(shortest, float("inf"))
        for who, planner, status, reason, fewest in self.claims:
            within = shortest is not None and planner.depth is not None and least <= planner.depth
            denies = status is PlanStatus.UNSOLVABLE and shortest is not None
            if denies or (within and status is PlanStatus.NOT_FOUND):
                self.find(who, f"says {status.value}, {reason!r}, but {shortest} needs {least} primitives")
            if fewest is None or not (planner.is_exact or planner.depth):
                continue
            if least < fewest:
                self.find(who, f"takes {fewest} primitives, and {shortest} {least}")
            if counted is not None and counted.fewest is None and fewest <= counted.depth:
                self.find(who, f"takes {fewest} primitives, and brute force finds none")
