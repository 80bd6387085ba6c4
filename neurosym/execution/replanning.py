"""Replanning: whether what is left of a plan still leads to the goal, a new plan if not, and when to stop."""

import dataclasses
import math
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import msgspec
import numpy as np

from neurosym.execution.record import STRAIGHT, as_it_shows, ended_in
from neurosym.grounding import Grounding
from neurosym.operators import TOLERANCE, Category, Mode, Operator, OperatorTable, Symbol, Vector, vector
from neurosym.planners.planner import UNTOLD, Effort, PlanStatus
from neurosym.planners.registry import Replanner
from neurosym.problems import Problem, SceneObject, pair_key
from neurosym.tasks.options import PUT_DOWN, put_named
from neurosym.tasks.promises import LEAST_CHANCE, promised
from neurosym.tasks.supports import is_reached, is_relational
from neurosym.tasks.task import understand
from neurosym.tasks.transition import PlanStep, Replay, primitives, validate
from neurosym.world import Outcome, OutcomeKind

# Experience: what each object of a scene was seen to do during a run, so that the next plan reckons with
# it.
#
# Once an object has been acted upon, more is known of it: the same primitive will probably do the same to
# it again, as long as it lies the same way. So during a run an object that was acted upon becomes a
# category of its own. Its operators promise the mean of what was promised before and of what was seen, each
# weighed by how sure it is; the chance of an outcome counts what came and what did not. After two failures
# in a row, or one that was likely, an operator promises what was seen in place of what did not come, and is
# not tried again the same way. What failed with a pair twice in a row is not tried with it again, unless
# there is no plan without, and then twice more; another operator for the same is tried in its place.

KNOWN_BEFORE, KNOWN_IN_A_CROWD = 0.5, 2.0
"""As how many trials what was known before counts beside those that were seen.

Whether an operator keeps its promise is mostly the object's doing, see `docs/planning.md`, "The chance"; but
where others were in the way it may be theirs.
"""
GIVEN_UP, LAST_HOPE = 2, 4
"""After how many failures in a row what did not come is not hoped for again; with a pair, if there is no plan
otherwise."""
SLIPPERY = 3
"""An object that was missed so often, and never carried, is not tried to be carried by other operators."""
REPEATS = 0.014
"""By how much the same primitive on the same object differs from time to time, RMS of an axis [m]."""
_SUREST = 0.005  # no promise is surer than this [m]
_OF, _TO = "-of-", "to-"
_Key = tuple[str, str]


@dataclass(slots=True)
class Experience:
    """What was seen of the objects and pairs of one problem.

    Attributes:
        grounding: What was learned of their categories.
    """

    grounding: Grounding
    _seen: dict[_Key, list[Outcome]] = field(default_factory=dict)
    _forgotten: dict[_Key, list[Outcome]] = field(default_factory=dict)
    _kept: dict[_Key, list[bool]] = field(default_factory=dict)
    _patience: int = GIVEN_UP

    @property
    def says_something(self) -> bool:
        """Whether anything was seen."""
        return bool(self._seen or self._kept)

    def hoping_again(self, problem: Problem) -> "Experience":
        """Forget what was seen, but for what failed and would mostly do so again.

        What is forgotten still counts where it is to be given up. Pairs are given some more failures.

        Args:
            problem: The problem as it stands now.
        """
        every = {key: self._all(key) for key in {**self._forgotten, **self._seen}}
        kept = {
            key: every[key]
            for item in (as_it_shows(lying, self.grounding) for lying in problem.objects)
            for operator in promised(self.grounding, item, problem.tolerance).values()
            for key in [(item.name, _label(operator, self.grounding))]
            if _is_given_up(operator, _as_it_lies(item, every.get(key, [])), problem.tolerance)
        }
        forgotten = {key: rows for key, rows in every.items() if key not in kept}
        return Experience(
            self.grounding, kept, forgotten, self._kept, LAST_HOPE if self._kept else self._patience
        )

    def learn(self, step: PlanStep, outcome: Outcome) -> None:
        """Remember what a step did, by its learned name."""
        if self.grounding.relation_named(step.base):
            put = put_named(step.operator, self.grounding)
            kept = put is not None and ended_in(outcome, self.grounding) == put.state
            self._kept.setdefault((pair_key(step.object, step.place), step.operator), []).append(kept)
        else:
            label = _label(self.grounding.operator_named(step.base), self.grounding)
            self._seen.setdefault((step.object, label), []).append(outcome)

    def believed(self, problem: Problem) -> tuple[Problem, Grounding]:
        """Take objects as they show, and give those that were acted upon a category of their own.

        Nothing is foreseen of pairs with which an operator is given up.

        Args:
            problem: The problem as it stands now.

        Returns:
            The problem with these categories, and the grounding that has them.
        """
        known = {name for name, _ in self._seen}
        objects, categories, operators = [], list[Category](), list[tuple[Operator, bool]]()
        for lying in problem.objects:
            item = as_it_shows(lying, self.grounding)
            if item.name not in known:
                objects.append(item)
                continue
            own = f"{item.category}{_OF}{item.name}"
            learned = self.grounding.category(item.category)
            objects.append(msgspec.structs.replace(item, category=own))
            name = learned.name + _OF + item.name
            categories.append(msgspec.structs.replace(learned, symbol=own, name=name, objects=()))
            operators += self._operators_of(item, own, problem.tolerance)
        believed = msgspec.structs.replace(self._without_hopeless(problem), objects=tuple(objects))
        return believed, self._with(categories, operators) if categories else self.grounding

    def _without_hopeless(self, problem: Problem) -> Problem:
        """Return a problem in which nothing is foreseen of what is given up with pairs."""
        most = self._patience
        lost = [key for key, kept in self._kept.items() if len(kept) >= most and not any(kept[-most:])]
        if not lost:
            return problem
        foreseen = {pair: dict(shares) for pair, shares in problem.foreseen.items()}
        for pair, operator in lost:
            foreseen.setdefault(pair, {})[operator] = 0.0
        return msgspec.structs.replace(problem, foreseen=foreseen)

    def _with(self, categories: list[Category], operators: list[tuple[Operator, bool]]) -> Grounding:
        """Return the grounding with more categories, and their operators; those that carry are marked."""

        def extended(table: OperatorTable, *, carry: bool) -> OperatorTable:
            added = (operator for operator, carries in operators if carries is carry)
            return msgspec.structs.replace(
                table,
                categories=(*table.categories, *categories),
                operators=(*table.operators, *added),
            )

        table, places = extended(self.grounding.operators, carry=False), self.grounding.places
        if places:
            places = msgspec.structs.replace(places, operators=extended(places.operators, carry=True))
        return msgspec.structs.replace(self.grounding, operators=table, places=places)

    def _operators_of(self, item: SceneObject, own: Symbol, tolerance: float) -> list[tuple[Operator, bool]]:
        """Return what is believed of an object, and whether each carries it to places."""
        found, is_slippery = [], self._is_slippery(item)
        for operator in promised(self.grounding, item, tolerance).values():
            key = (item.name, _label(operator, self.grounding))
            outcomes, every = (_as_it_lies(item, rows) for rows in (self._seen.get(key, []), self._all(key)))
            changed, carries = operator, self.grounding.carries(operator)
            if carries and is_slippery and operator.promise:
                changed = _promising(operator, operator.promise, 0.0)
            elif _is_given_up(operator, every, tolerance):
                changed = _given_up(operator, every)
            elif outcomes:
                changed = _after(operator, outcomes, tolerance)
            named = msgspec.structs.replace(changed, name=f"{operator.name}{_OF}{item.name}", category=own)
            found.append((named, carries))
        return found

    def _is_slippery(self, item: SceneObject) -> bool:
        """Say whether an object, as it lies, was to be carried in vain, whatever with."""
        keys = [key for key in self._seen if key[0] == item.name and key[1].startswith(_TO)]
        rows = [outcome for key in keys for outcome in self._seen[key]]
        kinds = [outcome.kind for outcome in _as_it_lies(item, rows)]
        return len(kinds) >= SLIPPERY and "carried" not in kinds

    def _all(self, key: tuple[str, str]) -> list[Outcome]:
        return [*self._forgotten.get(key, []), *self._seen.get(key, [])]


def _as_it_lies(item: SceneObject, seen: list[Outcome]) -> list[Outcome]:
    """List what was done to an object while it lay as it does now."""
    lay = ((one, one.start.orientations[one.target].tolist()) for one in seen)
    return [one for one, orientation in lay if _angle(orientation, item.orientation) < STRAIGHT]


def learned_name(step: PlanStep) -> PlanStep:
    """Return a step of a plan for believed categories by the name of the operator that was learned."""
    return dataclasses.replace(step, operator=step.operator.removesuffix(_OF + step.object))


def believed_name(step: PlanStep, problem: Problem, grounding: Grounding) -> PlanStep:
    """Return a step of a plan for learned categories by the name of the operator that is believed in.

    That is the one with the same parameters and the same kind of outcome, for what the object is now. Problem
    and grounding are those that `Experience.believed` returned.
    """
    if grounding.relation_named(step.base):
        return step
    learned, item = grounding.operator_named(step.base), problem.object_named(step.object)
    label = _label(learned, grounding)
    for operator in grounding.every_operator:
        is_same = operator.category == item.category and _label(operator, grounding) == label
        if is_same and _kind(operator) == _kind(learned):
            prefix = PUT_DOWN if step.puts_down else ""
            return dataclasses.replace(step, operator=prefix + operator.name)
    return step


def _label(operator: Operator, grounding: Grounding) -> str:
    """Return which motion an operator is; those that carry to places have labels of their own."""
    return f"{_TO}{operator.label}" if grounding.carries(operator) else operator.label


def _kind(operator: Operator) -> OutcomeKind | None:
    return operator.promise.kind if operator.promise else None


def _angle(one: Sequence[float], other: Sequence[float]) -> float:
    """Return by what angle two orientations differ [rad]."""
    along = abs(float(np.dot(one, other))) / (math.hypot(*one) * math.hypot(*other))
    return 2 * math.acos(min(1.0, along))


def _after(operator: Operator, outcomes: list[Outcome], tolerance: float) -> Operator:
    """Return an operator that promises what is to be believed after some outcomes."""
    if operator.promise is None:
        return operator
    mode, kept = _weighed_mode(operator.promise, outcomes, tolerance)
    return _promising(operator, mode, _chance(operator, outcomes, kept))


def _chance(operator: Operator, outcomes: list[Outcome], kept: list[bool]) -> float:
    """Weigh how often a promise is kept against how often it was."""
    in_a_crowd = any(outcome.touched or outcome.disturbed for outcome in outcomes)
    known = KNOWN_IN_A_CROWD if in_a_crowd else KNOWN_BEFORE
    return (known * operator.successes / operator.trials + sum(kept)) / (known + len(kept))


def _is_given_up(operator: Operator, outcomes: list[Outcome], tolerance: float) -> bool:
    """Say whether what an operator promises failed the last time, and too often to be hoped for again."""
    if operator.promise is None or not outcomes:
        return False
    _, kept = _weighed_mode(operator.promise, outcomes, tolerance)
    if any(kept[-GIVEN_UP:]):
        return False
    return len(kept) >= GIVEN_UP or _chance(operator, outcomes, kept) < LEAST_CHANCE


def _weighed_mode(promise: Mode, outcomes: list[Outcome], tolerance: float) -> tuple[Mode, list[bool]]:
    """Weigh a promise against what was seen, and say which outcomes came as is promised then."""
    same = [outcome for outcome in outcomes if outcome.kind == promise.kind]
    mode = _combined(promise, same) if same else promise
    near = max(tolerance, TOLERANCE)

    def miss(outcome: Outcome) -> float:
        return math.dist(mode.outcome, outcome.effect if mode.kind == "held" else outcome.resting_effect)

    return mode, [outcome.kind == mode.kind and miss(outcome) <= near for outcome in outcomes]


def _given_up(operator: Operator, outcomes: list[Outcome]) -> Operator:
    """Promise what was seen in the place of what did not come, if it can be planned with."""
    promise, last = operator.promise, outcomes[-1]
    assert promise is not None, "it was hoped for"
    like = [one for one in outcomes if one.kind == last.kind]
    if last.kind not in ("resting", "held"):
        return _promising(operator, promise, 0.0)
    seen = msgspec.structs.replace(
        promise,
        kind=last.kind,
        effect=vector(np.mean([one.effect for one in like], axis=0)),
        spread=(REPEATS,) * 3,
        resting_effect=vector(np.mean([one.resting_effect for one in like], axis=0)),
        resting_spread=(REPEATS,) * 3,
    )
    return _promising(operator, seen, len(like) / (len(outcomes) + 1))


def _promising(operator: Operator, mode: Mode, share: float) -> Operator:
    """Return an operator that promises a mode, which it keeps in a share of its trials."""
    kept = round(share * operator.trials)
    mode = msgspec.structs.replace(
        mode, near_mean=kept, count=max(kept, 1), share=max(kept, 1) / operator.trials
    )
    others = tuple(other for other in operator.modes if other.kind != mode.kind)
    return msgspec.structs.replace(operator, modes=(mode, *others), promised=mode.kind)


def _combined(mode: Mode, outcomes: list[Outcome]) -> Mode:
    """Weigh what a mode promised against what was seen, each by how sure it is."""
    effect, spread = _weighed(mode.effect, mode.spread, np.array([one.effect for one in outcomes]))
    seen = np.array([one.resting_effect for one in outcomes])
    resting, resting_spread = _weighed(mode.resting_effect, mode.resting_spread, seen)
    return msgspec.structs.replace(
        mode, effect=effect, spread=spread, resting_effect=resting, resting_spread=resting_spread
    )


def _weighed(mean: tuple[float, ...], spread: tuple[float, ...], seen: np.ndarray) -> tuple[Vector, Vector]:
    """Weigh a mean against what was seen; it was less sure than it said if what was seen is far from it."""
    away = np.abs(seen.mean(0) - mean)
    before = 1 / np.maximum(np.maximum(np.array(spread), away), _SUREST) ** 2
    now = len(seen) / REPEATS**2
    value = (before * np.array(mean) + now * seen.mean(0)) / (before + now)
    return vector(value), vector(np.sqrt(1 / (before + now)))


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
