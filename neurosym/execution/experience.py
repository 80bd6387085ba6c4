"""Experience: what each object of a scene was seen to do during a run, so that the next plan reckons with it.

Once an object has been acted upon, more is known of it: the same primitive will probably do the same to it
again, as long as it lies the same way. So during a run an object that was acted upon becomes a category of
its own. Its operators promise the mean of what was promised before and of what was seen, each weighed by how
sure it is; the chance of an outcome counts what came and what did not. After two failures in a row, or one
that was likely, an operator promises what was seen in place of what did not come, and is not tried again the
same way.
"""

import dataclasses
import math
from dataclasses import dataclass, field

import msgspec
import numpy as np

from neurosym.execution.appearance import STRAIGHT, as_it_shows
from neurosym.execution.relating import PairExperience
from neurosym.execution.weighing import REPEATS, combined, mean_of, miss_of
from neurosym.grounding import Grounding
from neurosym.operators import TOLERANCE, Category, Mode, Operator, OperatorTable
from neurosym.problems import Problem, SceneObject
from neurosym.promises import LEAST_CHANCE, promised
from neurosym.related import relating
from neurosym.symbols import Symbol
from neurosym.tasks.moves import PUT_DOWN
from neurosym.tasks.steps import PlanStep
from neurosym.world import Outcome, OutcomeKind

KNOWN_BEFORE, KNOWN_IN_A_CROWD = 0.5, 2.0
"""As how many trials what was known before counts beside those that were seen.

Whether an operator keeps its promise is mostly the object's doing, see `docs/planning.md`, "The chance"; but
where others were in the way it may be theirs.
"""
GIVEN_UP = 2
"""After how many failures in a row what did not come is not hoped for again."""
SLIPPERY = 3
"""An object that was missed so often, and never carried, is not tried to be carried by other operators."""
_OF, _TO = "-of-", "to-"


@dataclass(frozen=True, slots=True, eq=False)
class _Seen:
    """What a primitive did to an object, and how the object lay before."""

    outcome: Outcome
    orientation: tuple[float, ...]


@dataclass(slots=True)
class Experience:
    """What was seen of the objects of one problem.

    Attributes:
        grounding: What was learned of their categories.
    """

    grounding: Grounding
    _seen: dict[tuple[str, str], list[_Seen]] = field(default_factory=dict)
    _forgotten: dict[tuple[str, str], list[_Seen]] = field(default_factory=dict)
    _pairs: PairExperience | None = None

    @property
    def says_something(self) -> bool:
        """Whether anything was seen."""
        return bool(self._seen or self._pairs)

    def hoping_again(self, problem: Problem) -> "Experience":
        """Forget what was seen, but for what failed and would mostly do so again.

        What is forgotten still counts where it is to be given up.

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
        pairs = self._pairs.hoping_again() if self._pairs else None
        return Experience(self.grounding, kept, forgotten, pairs)

    def learn(self, step: PlanStep, outcome: Outcome) -> None:
        """Remember what a step did.

        Args:
            step: The step, by its learned name.
            outcome: What happened.
        """
        if relating(step.base, self.grounding):
            self._pairs = self._pairs or PairExperience(self.grounding)
            self._pairs.learn(step, outcome)
            return
        label = _label(self.grounding.operator_named(step.base), self.grounding)
        lay = tuple(outcome.start.orientations[outcome.target].tolist())
        self._seen.setdefault((step.object, label), []).append(_Seen(outcome, lay))

    def believed(self, problem: Problem) -> tuple[Problem, Grounding]:
        """Take objects as they show, and give those that were acted upon a category of their own.

        Args:
            problem: The problem as it stands now.

        Returns:
            The problem with these categories, and the grounding that has them.
        """
        known = {name for name, _ in self._seen}
        problem = self._pairs.believed(problem) if self._pairs else problem
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
        believed = msgspec.structs.replace(problem, objects=tuple(objects))
        if not categories:
            return believed, self.grounding
        return believed, self._with(categories, operators)

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
        rows = [
            one
            for (name, label), seen in self._seen.items()
            if (name, label[:3]) == (item.name, _TO)
            for one in seen
        ]
        kinds = [outcome.kind for outcome in _as_it_lies(item, rows)]
        return len(kinds) >= SLIPPERY and "carried" not in kinds

    def _all(self, key: tuple[str, str]) -> list[_Seen]:
        return [*self._forgotten.get(key, []), *self._seen.get(key, [])]


def _as_it_lies(item: SceneObject, seen: list[_Seen]) -> list[Outcome]:
    """List what was done to an object while it lay as it does now."""
    return [one.outcome for one in seen if _angle(one.orientation, item.orientation) < STRAIGHT]


def learned_name(step: PlanStep) -> PlanStep:
    """Return a step of a plan for believed categories by the name of the operator that was learned."""
    return dataclasses.replace(step, operator=step.operator.removesuffix(_OF + step.object))


def believed_name(step: PlanStep, problem: Problem, grounding: Grounding) -> PlanStep:
    """Return a step of a plan for learned categories by the name of the operator that is believed in.

    That is the one with the same parameters and the same kind of outcome, for what the object is now.

    Args:
        step: The step.
        problem: A problem that `Experience.believed` returned.
        grounding: The grounding that it returned.
    """
    if relating(step.base, grounding):
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


def _angle(one: tuple[float, ...], other: tuple[float, ...]) -> float:
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
    mode = combined(promise, same) if same else promise
    near = max(tolerance, TOLERANCE)
    return mode, [outcome.kind == mode.kind and miss_of(mode, outcome) <= near for outcome in outcomes]


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
        effect=mean_of([one.effect for one in like]),
        spread=(REPEATS,) * 3,
        resting_effect=mean_of([one.resting_effect for one in like]),
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
