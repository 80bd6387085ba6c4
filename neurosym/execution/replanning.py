"""Replanning: whether what is left of a plan still leads to the goal, a new plan if not, and when to stop."""

from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import msgspec

from neurosym.execution.record import ended_in
from neurosym.grounding import Grounding
from neurosym.operators import Operator
from neurosym.planners.planner import UNTOLD, Effort, PlanStatus
from neurosym.planners.registry import Replanner
from neurosym.problems import THIS_RUN, Problem, Trial, pair_key
from neurosym.tasks.lying import as_it_shows, lying, righted
from neurosym.tasks.options import put_named
from neurosym.tasks.pasts import (
    GIVEN_UP,
    LEAST_CHANCE,
    as_it_lies,
    forgetting,
    is_given_up,
    motion_of,
    never_seen,
    past_of,
    trial_of,
    with_pasts,
)
from neurosym.tasks.promises import promised
from neurosym.tasks.task import is_reached, is_relational, understand, unmet_relations
from neurosym.tasks.transition import PlanStep, Replay, primitives, validate
from neurosym.world import Outcome

# Experience: what each object of a scene was seen to do during a run, so that the next plan reckons with
# it.
#
# What was seen of an object is added to its past (`neurosym.tasks.pasts`). What failed with a pair twice in a
# row is not tried with it again, unless there is no plan without, and then twice more; once is enough where
# it was only faintly foreseen. Another operator for the same is tried in its place.

LAST_HOPE = 4
"""After how many failures in a row a pair is not hoped for again, if there is no plan otherwise."""
_Key = tuple[str, str]


@dataclass(slots=True)
class Experience:
    """What was seen of the objects and pairs of one problem."""

    grounding: Grounding  # what was learned of their categories
    _seen: dict[str, list[Trial]] = field(default_factory=dict)  # of each object, by its name
    _kept: dict[_Key, list[bool]] = field(default_factory=dict)
    _hopes: bool = False  # whether what objects did before is forgotten, too
    _patience: int = GIVEN_UP
    _let_lie: Counter[_Key] = field(default_factory=Counter)  # how often an operator let an object lie

    def hoping_again(self, problem: Problem) -> "Experience":
        """Forget what was seen, but for what failed and would mostly do so again as objects lie now.

        What is forgotten still counts where it is to be given up. Pairs are given some more failures.
        """
        hopeless = set[_Key]()
        for item in problem.objects:
            shown = never_seen(as_it_shows(item, self.grounding))
            so_far = msgspec.structs.replace(item, past=tuple(self._seen.get(item.name, ())) or msgspec.UNSET)
            trials = as_it_lies(so_far, self.grounding.turned)
            for operator in promised(self.grounding, shown, problem.tolerance).values():
                rows = [one for one in trials if one.motion == motion_of(operator)]
                if is_given_up(operator, rows, problem.tolerance):
                    hopeless.add((item.name, motion_of(operator)))
        seen = {
            name: [msgspec.structs.replace(one, forgotten=(name, one.motion) not in hopeless) for one in rows]
            for name, rows in self._seen.items()
        }
        patience = LAST_HOPE if self._kept else self._patience
        return Experience(self.grounding, seen, self._kept, True, patience, self._let_lie)

    def learn(self, step: PlanStep, outcome: Outcome) -> Trial | None:
        """Remember what a step did, and return what it did to the object by itself, if it did that."""
        operator = self.grounding.operator_named(step.base)
        if operator.frame == "side":
            self._let_lie[step.object, operator.name] += righted(outcome) != "resting"
            return None
        if operator.frame == "pair":
            put = put_named(step.operator, self.grounding)
            kept = put is not None and ended_in(outcome, self.grounding) == put.state
            self._kept.setdefault((pair_key(step.object, step.place), _way(operator)), []).append(kept)
            return None
        seen = trial_of(outcome, operator, self.grounding.turned, THIS_RUN)
        self._seen.setdefault(step.object, []).append(seen)
        return seen

    def believed(self, problem: Problem) -> Problem:
        """Take objects as they show now, with what was seen of them as they lie.

        Nothing is foreseen of pairs with which an operator is given up. Of conditions only the goals are left
        that were chosen for them.
        """
        given_up = {name for (name, _), times in self._let_lie.items() if times >= GIVEN_UP}
        upright = tuple(name for name in problem.upright if name not in given_up)
        problem = msgspec.structs.replace(problem, upright=upright)
        lie = lying(problem, self.grounding)
        problem = with_pasts(forgetting(problem) if self._hopes else problem, self._seen)
        objects = [
            item if lie.get(item.name) else as_it_shows(item, self.grounding) for item in problem.objects
        ]
        foreseen, most = {pair: dict(shares) for pair, shares in problem.foreseen.items()}, self._patience
        every = self.grounding.relations.every_operator if self.grounding.relations else ()
        for (pair, way), kept in self._kept.items():
            shares, names = foreseen.setdefault(pair, {}), [one.name for one in every if _way(one) == way]
            is_faint = max((shares[name] for name in names if name in shares), default=1.0) < LEAST_CHANCE
            if not any(kept[-most:]) and (is_faint or len(kept) >= most):
                shares |= dict.fromkeys(names, 0.0)
        return msgspec.structs.replace(problem, objects=tuple(objects), foreseen=foreseen, conditions=())


def _way(operator: Operator) -> str:
    """Return which motion an operator on pairs is, and for what, whatever kind of pairs it is for."""
    return f"{operator.promise.kind if operator.promise else ''} {operator.label}"


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


LATER = 2
"""An object that is not at one of its last so many primitives may yet go another way; see `_can_wait`."""


def why_not_go_on(left: Sequence[PlanStep], seen: Problem, experience: Experience) -> str:
    """Say why what is left of a plan would miss the goal by what is believed and seen now, or nothing."""
    if not left and is_reached(seen, experience.grounding):
        return ""
    believed = experience.believed(seen)
    checked = validate(left, believed, experience.grounding)
    if checked.valid and not left:
        return "a condition does not hold, though every goal that was chosen for it is met"
    if checked.failed is None:
        return "" if checked.valid or _can_wait(left, checked, believed) else checked.reason
    step, why = checked.failed
    return f"{step.operator} {step.object}: {why}"


def _can_wait(left: Sequence[PlanStep], checked: Replay, problem: Problem) -> bool:
    """Say whether a plan that misses its goals by little, as most long ones do, is gone on with for now."""
    if not left:
        return False
    ahead = Counter(step.object for step in left if not step.puts_down)
    distances = problem.distances(checked.positions[-1])
    missed = {name: miss for name, miss in distances.items() if miss > problem.tolerance}
    near = [miss <= 2 * problem.tolerance and ahead[name] > LATER for name, miss in missed.items()]
    return bool(missed) and all(near)


@dataclass(frozen=True, slots=True, eq=False)
class NewPlan:
    """What was answered when a new plan was asked for."""

    steps: tuple[PlanStep, ...]  # empty if there is no plan
    problem: Problem  # as it stands now, with the places and only those goals that the plan is for
    experience: Experience  # what is to be believed from now
    reason: str  # why there is no plan for all goals, or empty


def new_plan(
    replanner: Replanner, seen: Problem, experience: Experience, effort: Effort | None = None
) -> NewPlan:
    """Ask for a new plan from where things are; where experience stands against any, hope and ask again.

    If there is no plan for all goals, one is asked for that brings some objects to theirs: what is in the way
    of the others may have gone by then. What failed on an object again and again is not hoped for. Once the
    effort for all new plans is spent, no more are asked for.
    """
    reason, effort = "", effort or Effort()
    is_known = experience._seen or experience._kept or any(map(past_of, seen.objects))
    hopes = [experience.hoping_again(seen)] if is_known else []
    for believing in (experience, *hopes):
        for task in (seen, *_for_fewer(seen, believing)):
            if effort.is_used_up:
                break
            result = replanner(believing.believed(task), believing.grounding)
            effort.spend(result.work or UNTOLD)
            if result.status is PlanStatus.SOLVED:
                said = "" if result.steps else "nothing that was learned is left to be tried"
                return NewPlan(result.steps, task, believing, said if task is seen else reason)
            reason = reason or result.reason or result.status.value
    return NewPlan((), seen, believing, reason)


def _for_fewer(problem: Problem, experience: Experience) -> Iterator[Problem]:
    """List problems with fewer goals: all that can be carried to, and then those met now and one more.

    Of goals by relation one is left out whose objects no other one names, so that it is tried again at last.
    """
    believed, grounding = experience.believed(problem), experience.grounding
    if is_relational(believed, grounding):
        for alone in unmet_relations(problem, grounding):
            others = tuple(one for one in problem.relations if one != alone)
            if others and not {*alone[:2]} & {name for one in others for name in one[:2]}:
                yield msgspec.structs.replace(problem, relations=others)
        return
    carried = [name for name in understand(believed, grounding).carried if name in problem.goals]
    missed = sorted(problem.unmet, key=lambda name: (name not in carried, name))
    met = problem.goals.keys() - set(missed)
    for names in ({*met, *carried}, *({*met, name} for name in missed)):
        if met < names < set(problem.goals):
            goals = {name: goal for name, goal in problem.goals.items() if name in names}
            yield msgspec.structs.replace(problem, goals=goals)
