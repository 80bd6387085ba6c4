"""Replanning: whether what is left of a plan still leads to the goal, a new plan if not, and when to stop."""

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import msgspec

from neurosym.execution.experience import Experience, believed_name, learned_name
from neurosym.planners.effort import UNTOLD, Effort
from neurosym.planners.registry import Replanner
from neurosym.planners.result import PlanStatus
from neurosym.problems import Problem
from neurosym.related import is_reached, is_relational
from neurosym.tasks.steps import PlanStep, primitives
from neurosym.tasks.task import understand
from neurosym.tasks.transition import Replay, validate

PATIENCE = 10
"""After how many new plans in a row that come no nearer to the goal a run stops."""
WORK = 2_000_000
"""How much may be looked at for all new plans of a run [states], for each object and twice more."""
WORK_A_PLAN = 3_000_000
"""How much may be looked at for one new plan [states], before one for fewer goals is looked for."""
NEARER = 0.01
"""How much nearer objects must have come to their goals, in sum, to be nearer [m]."""


def usual_replans(plan: Sequence[PlanStep]) -> int:
    """Return how many new plans a run may ask for: the longer the plan, the more can go otherwise."""
    return PATIENCE + 2 * primitives(plan)


def usual_work(problem: Problem) -> int:
    """Return how much may be looked at for all new plans of a run: some 40 s for four objects [states].

    Where it is spent, a run goes on with the plan that it has.
    """
    return WORK * (2 + len(problem.objects))


@dataclass(slots=True)
class Progress:
    """How near a run has come to its goal.

    Attributes:
        left: The fewest primitives that any plan so far had left.
        miss: The least sum of the distances from the goals so far [m].
        stalled: How many new plans in a row changed neither.
    """

    left: int
    miss: float
    stalled: int = 0

    def note(self, left: int | None, miss: float) -> None:
        """Take note of how many primitives a new plan has, if there is one, and how far goals are [m]."""
        is_nearer = (left is not None and left < self.left) or miss < self.miss - NEARER
        self.stalled = 0 if is_nearer else self.stalled + 1
        self.left = self.left if left is None else min(left, self.left)
        self.miss = min(miss, self.miss)


LATER = 2
"""An object that is not at one of its last so many primitives may yet go another way; see `_can_wait`."""


def why_not_go_on(left: Sequence[PlanStep], seen: Problem, experience: Experience) -> str:
    """Say why what is left of a plan would miss the goal by what is believed and seen now, or nothing."""
    if not left and is_reached(seen, experience.grounding):
        return ""
    believed, grounding = experience.believed(seen)
    checked = validate([believed_name(step, believed, grounding) for step in left], believed, grounding)
    if checked.failed is None:
        return "" if checked.valid or _can_wait(left, checked, believed) else checked.reason
    step, why = learned_name(checked.failed[0]), checked.failed[1]
    return f"{step.operator} {step.object}: {why}"


def _can_wait(left: Sequence[PlanStep], checked: Replay, problem: Problem) -> bool:
    """Say whether a plan that would miss its goals by little is to be gone on with for now.

    Long plans mostly miss somewhat, each step another way; it is early enough to plan anew near the end of
    what is done with an object. Every step of what is left is possible.
    """
    if not left:
        return False
    primitives_left = Counter(step.object for step in left if not step.puts_down)
    missed = {
        name: miss
        for name, miss in problem.distances(checked.positions[-1]).items()
        if miss > problem.tolerance
    }
    return bool(missed) and all(
        miss <= 2 * problem.tolerance and primitives_left[name] > LATER for name, miss in missed.items()
    )


@dataclass(frozen=True, slots=True, eq=False)
class NewPlan:
    """What was answered when a new plan was asked for.

    Attributes:
        steps: The plan, by the names of learned operators; empty if there is none.
        problem: The problem as it stands now, with the places and only those goals that the plan is for.
        experience: What is to be believed from now.
        reason: Why there is no plan for all goals, or empty.
    """

    steps: tuple[PlanStep, ...]
    problem: Problem
    experience: Experience
    reason: str

    @property
    def is_found(self) -> bool:
        """Whether there is a plan for all goals."""
        return bool(self.steps) and not self.reason


def new_plan(
    replanner: Replanner, seen: Problem, experience: Experience, effort: Effort | None = None
) -> NewPlan:
    """Ask for a new plan from where things are; where experience stands against any, hope and ask again.

    If there is no plan for all goals, one is asked for that brings some objects to theirs: what is in the way
    of the others may have gone by then. What failed on an object again and again is not hoped for. Once the
    work for all new plans is spent, no more are asked for.

    Args:
        replanner: Whom to ask.
        seen: The problem as it stands now.
        experience: What the objects were seen to do.
        effort: What may be spent on all new plans of the run [states], if not everything.
    """
    reason, effort = "", effort or Effort()
    for believing in (experience, experience.hoping_again(seen))[: 1 + experience.says_something]:
        for task in (seen, *_for_fewer(seen, believing)):
            if effort.is_used_up:
                break
            result = replanner(*believing.believed(task))
            effort.spend(result.work or UNTOLD)
            if result.status is PlanStatus.SOLVED:
                steps = tuple(learned_name(step) for step in result.steps)
                return NewPlan(steps, task, believing, "" if task is seen else reason)
            reason = reason or result.reason or result.status.value
    return NewPlan((), seen, believing, reason)


def _for_fewer(problem: Problem, experience: Experience) -> Iterator[Problem]:
    """List problems with fewer goals: all that can be carried to, and then those met now and one more."""
    believed, grounding = experience.believed(problem)
    if is_relational(believed, grounding):
        return
    carried = [name for name in understand(believed, grounding).carried if name in problem.goals]
    missed = sorted(problem.unmet, key=lambda name: (name not in carried, name))
    met = problem.goals.keys() - set(missed)
    every = {*met, *carried}
    for names in (every, *({*met, name} for name in missed)):
        if met < names < set(problem.goals):
            goals = {name: goal for name, goal in problem.goals.items() if name in names}
            yield msgspec.structs.replace(problem, goals=goals)
