"""Replanning: whether what is left of a plan still leads to the goal, a new plan if not, and when to stop."""

import dataclasses
import math
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import msgspec
import numpy as np

from neurosym.checks import Float
from neurosym.execution.record import ended_in
from neurosym.grounding import Grounding
from neurosym.operators import TOLERANCE, Category, Mode, Operator, OperatorTable, Symbol, Vector, vector
from neurosym.pair_operators import rotation
from neurosym.planners.planner import UNTOLD, Effort, PlanStatus
from neurosym.planners.registry import Replanner
from neurosym.problems import Problem, SceneObject, pair_key
from neurosym.tasks.lying import STRAIGHT, as_it_shows, lying, righted
from neurosym.tasks.options import PUT_DOWN, put_named
from neurosym.tasks.promises import LEAST_CHANCE, promised
from neurosym.tasks.task import is_reached, is_relational, understand, unmet_relations
from neurosym.tasks.transition import PlanStep, Replay, primitives, validate
from neurosym.world import Outcome, OutcomeKind, heading, turned_by

# Experience: what each object of a scene was seen to do during a run, so that the next plan reckons with
# it.
#
# Once an object has been acted upon, more is known of it: the same primitive will probably do the same to
# it again, as long as it lies the same way. So during a run an object that was acted upon becomes a
# category of its own. Its operators promise the mean of what was promised before and of what was seen, each
# weighed by how sure it is; the chance of an outcome counts what came and what did not. After two failures
# in a row, or one that was likely, an operator promises what was seen in place of what did not come, and is
# not tried again the same way. What failed with a pair twice in a row is not tried with it again, unless
# there is no plan without, and then twice more; once is enough where it was only faintly foreseen. Another
# operator for the same is tried in its place.

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


@dataclass(frozen=True, slots=True, eq=False)
class _Seen:
    """What became of an object in a step."""

    kind: OutcomeKind
    effect: Float[np.ndarray, "3"]  # displacement at the end of the rise [m], seen from how the object lay
    resting_effect: Float[np.ndarray, "3"]  # and once everything was put down
    lay: Float[np.ndarray, "3 3"]  # how its axes lay, but for turns about the vertical that do not matter
    in_a_crowd: bool  # whether others were in the way


@dataclass(slots=True)
class Experience:
    """What was seen of the objects and pairs of one problem."""

    grounding: Grounding  # what was learned of their categories
    _seen: dict[_Key, list[_Seen]] = field(default_factory=dict)
    _forgotten: dict[_Key, list[_Seen]] = field(default_factory=dict)
    _kept: dict[_Key, list[bool]] = field(default_factory=dict)
    _patience: int = GIVEN_UP
    _let_lie: Counter[_Key] = field(default_factory=Counter)  # how often an operator let an object lie

    def hoping_again(self, problem: Problem) -> "Experience":
        """Forget what was seen, but for what failed and would mostly do so again as objects lie now.

        What is forgotten still counts where it is to be given up. Pairs are given some more failures.
        """
        every = {key: self._all(key) for key in {**self._forgotten, **self._seen}}
        kept = dict[_Key, list[_Seen]]()
        for item in problem.objects:
            shown = _straight(as_it_shows(item, self.grounding))
            for operator in promised(self.grounding, shown, problem.tolerance).values():
                key = (item.name, _label(operator))
                rows = every.get(key, [])
                if _is_given_up(operator, self._as_it_lies(item, rows), problem.tolerance):
                    kept[key] = rows
        forgotten = {key: rows for key, rows in every.items() if key not in kept}
        patience = LAST_HOPE if self._kept else self._patience
        return Experience(self.grounding, kept, forgotten, self._kept, patience, self._let_lie)

    def learn(self, step: PlanStep, outcome: Outcome) -> None:
        """Remember what a step did, by its learned name."""
        operator = self.grounding.operator_named(step.base)
        if operator.frame == "side":
            self._let_lie[step.object, operator.name] += righted(outcome) != "resting"
            return
        if operator.frame == "pair":
            put = put_named(step.operator, self.grounding)
            kept = put is not None and ended_in(outcome, self.grounding) == put.state
            self._kept.setdefault((pair_key(step.object, step.place), _way(operator)), []).append(kept)
        else:
            seen = self._seen_from(outcome, operator)
            self._seen.setdefault((step.object, _label(operator)), []).append(seen)

    def _seen_from(self, outcome: Outcome, operator: Operator) -> _Seen:
        """Say what was seen, in the frame in which motions are learned."""
        lay = outcome.start.orientations[outcome.target]
        turn = heading(lay) if self.grounding.turned else 0.0
        effects = outcome.effect, outcome.resting_effect
        if operator.frame == "object":
            effects = turned_by(-turn, effects[0]), turned_by(-turn, effects[1])
        return _Seen(outcome.kind, *effects, _axes(lay, turn), bool(outcome.touched or outcome.disturbed))

    def believed(self, problem: Problem) -> tuple[Problem, Grounding]:
        """Take objects as they show now, and give those that were acted upon a category of their own.

        Nothing is foreseen of pairs with which an operator is given up. Conditions name categories of old, so
        only the goals are left that were chosen for them. Returned are the problem with these categories, and
        the grounding that has them.
        """
        given_up = {name for (name, _), times in self._let_lie.items() if times >= GIVEN_UP}
        upright = tuple(name for name in problem.upright if name not in given_up)
        problem = msgspec.structs.replace(problem, upright=upright)
        known, lie = {name for name, _ in self._seen}, lying(problem, self.grounding)
        objects, categories, operators = [], list[Category](), list[Operator]()
        for lies in problem.objects:
            item = lies if lie.get(lies.name) else as_it_shows(lies, self.grounding)
            own = f"{item.category}{_OF}{item.name}" if item.name in known else item.category
            objects.append(msgspec.structs.replace(item, category=own))
            if item.name in known:
                learned = self.grounding.category(item.category)
                name = learned.name + _OF + item.name
                categories.append(msgspec.structs.replace(learned, symbol=own, name=name, objects=()))
                operators += self._operators_of(item, lies, own, problem.tolerance)
        foreseen, most = {pair: dict(shares) for pair, shares in problem.foreseen.items()}, self._patience
        every = self.grounding.relations.every_operator if self.grounding.relations else ()
        for (pair, way), kept in self._kept.items():
            shares, names = foreseen.setdefault(pair, {}), [one.name for one in every if _way(one) == way]
            is_faint = max((shares[name] for name in names if name in shares), default=1.0) < LEAST_CHANCE
            if not any(kept[-most:]) and (is_faint or len(kept) >= most):
                shares |= dict.fromkeys(names, 0.0)
        problem = msgspec.structs.replace(problem, objects=tuple(objects), foreseen=foreseen, conditions=())
        return problem, self._with(categories, operators) if categories else self.grounding

    def _with(self, categories: list[Category], operators: list[Operator]) -> Grounding:
        """Return the grounding with more categories, and their operators."""

        def extended(table: OperatorTable, frame: str) -> OperatorTable:
            added = (one for one in operators if one.frame == frame)
            return msgspec.structs.replace(
                table, categories=(*table.categories, *categories), operators=(*table.operators, *added)
            )

        objects, places = extended(self.grounding.objects, "object"), self.grounding.places
        places = places and extended(places, "place")
        return msgspec.structs.replace(self.grounding, objects=objects, places=places)

    def _operators_of(
        self, item: SceneObject, lies: SceneObject, own: Symbol, tolerance: float
    ) -> Iterator[Operator]:
        """List what is believed of an object, as it shows and as it lies."""
        rows = [rows for (name, to), rows in self._seen.items() if name == item.name and to.startswith(_TO)]
        carried = [one.kind == "carried" for outcomes in rows for one in self._as_it_lies(lies, outcomes)]
        is_slippery = len(carried) >= SLIPPERY and not any(carried)
        for operator in promised(self.grounding, _straight(item), tolerance).values():
            key, promise, changed = (item.name, _label(operator)), operator.promise, operator
            seen, known = self._seen.get(key, []), self._all(key)
            outcomes, every = (self._as_it_lies(lies, rows) for rows in (seen, known))
            if promise and operator.frame == "place" and is_slippery:
                changed = _promising(operator, promise, 0.0)
            elif promise and _is_given_up(operator, every, tolerance):
                changed = _given_up(operator, promise, every)
            elif promise and outcomes:
                mode, kept = _weighed_mode(promise, outcomes, tolerance)
                changed = _promising(operator, mode, _chance(operator, outcomes, kept))
            name = f"{operator.name}{_OF}{item.name}"
            yield msgspec.structs.replace(changed, name=name, subject=own, company=())

    def _all(self, key: _Key) -> list[_Seen]:
        return [*self._forgotten.get(key, []), *self._seen.get(key, [])]

    def _as_it_lies(self, item: SceneObject, seen: Sequence[_Seen]) -> list[_Seen]:
        """List what was done to an object while it lay as it does now."""
        lies = np.array(item.orientation)
        axes = _axes(lies, heading(lies) if self.grounding.turned else 0.0)
        between = [(float(np.trace(axes.T @ one.lay)) - 1) / 2 for one in seen]
        near = (math.acos(min(1.0, max(-1.0, cosine))) < STRAIGHT for cosine in between)
        return [one for one, is_near in zip(seen, near, strict=True) if is_near]


def _axes(orientation: Float[np.ndarray, "4"], turn: float) -> Float[np.ndarray, "3 3"]:
    """Return the axes of an object, turned back by an angle about the vertical [rad], as columns."""
    return np.asarray(turned_by(-turn, rotation(orientation).T).T)


def _straight(item: SceneObject) -> SceneObject:
    """Return an object as if it lay straight, in which frame it is learned of."""
    return msgspec.structs.replace(item, orientation=(0.0, 0.0, 0.0, 1.0))


def learned_name(step: PlanStep) -> PlanStep:
    """Return a step of a plan for believed categories by the name of the operator that was learned."""
    return dataclasses.replace(step, operator=step.operator.removesuffix(_OF + step.object))


def believed_name(step: PlanStep, problem: Problem, grounding: Grounding) -> PlanStep:
    """Return a step of a plan for learned categories by the name of the operator that is believed in.

    That is the one with the same parameters and the same kind of outcome, for what the object is now. Problem
    and grounding are those that `Experience.believed` returned.
    """

    def means(operator: Operator) -> tuple[str, ...]:
        return operator.frame, operator.label, operator.promise.kind if operator.promise else ""

    learned = means(grounding.operator_named(step.base))
    for operator in grounding.operators_on(problem.object_named(step.object).category):
        if means(operator) == learned:
            prefix = PUT_DOWN if step.puts_down else ""
            return dataclasses.replace(step, operator=prefix + operator.name)
    return step


def _way(operator: Operator) -> str:
    """Return which motion an operator on pairs is, and for what, whatever kind of pairs it is for."""
    return f"{operator.promise.kind if operator.promise else ''} {operator.label}"


def _label(operator: Operator) -> str:
    """Return which motion an operator is; those that carry to places have labels of their own."""
    return f"{_TO}{operator.label}" if operator.frame == "place" else operator.label


def _chance(operator: Operator, outcomes: list[_Seen], kept: list[bool]) -> float:
    """Weigh how often a promise is kept against how often it was."""
    in_a_crowd = any(outcome.in_a_crowd for outcome in outcomes)
    known = KNOWN_IN_A_CROWD if in_a_crowd else KNOWN_BEFORE
    return (known * operator.successes / operator.trials + sum(kept)) / (known + len(kept))


def _is_given_up(operator: Operator, outcomes: list[_Seen], tolerance: float) -> bool:
    """Say whether what an operator promises failed the last time, and too often to be hoped for again."""
    if operator.promise is None or not outcomes:
        return False
    _, kept = _weighed_mode(operator.promise, outcomes, tolerance)
    if any(kept[-GIVEN_UP:]):
        return False
    return len(kept) >= GIVEN_UP or _chance(operator, outcomes, kept) < LEAST_CHANCE


def _weighed_mode(promise: Mode, outcomes: list[_Seen], tolerance: float) -> tuple[Mode, list[bool]]:
    """Weigh a promise against what was seen, and say which outcomes came as is promised then."""
    mode, near = promise, max(tolerance, TOLERANCE)
    if same := [outcome for outcome in outcomes if outcome.kind == promise.kind]:
        effect, spread = _weighed(mode.effect, mode.spread, np.array([one.effect for one in same]))
        seen = np.array([one.resting_effect for one in same])
        resting, resting_spread = _weighed(mode.resting_effect, mode.resting_spread, seen)
        mode = msgspec.structs.replace(
            mode, effect=effect, spread=spread, resting_effect=resting, resting_spread=resting_spread
        )
    ends = [one.effect if mode.kind == "held" else one.resting_effect for one in outcomes]
    misses = [math.dist(mode.outcome, end) for end in ends]
    return mode, [one.kind == mode.kind and miss <= near for one, miss in zip(outcomes, misses, strict=True)]


def _weighed(mean: tuple[float, ...], spread: tuple[float, ...], seen: np.ndarray) -> tuple[Vector, Vector]:
    """Weigh a mean against what was seen; it was less sure than it said if what was seen is far from it."""
    away = np.abs(seen.mean(0) - mean)
    before = 1 / np.maximum(np.maximum(np.array(spread), away), _SUREST) ** 2
    now = len(seen) / REPEATS**2
    value = (before * np.array(mean) + now * seen.mean(0)) / (before + now)
    return vector(value), vector(np.sqrt(1 / (before + now)))


def _given_up(operator: Operator, promise: Mode, outcomes: list[_Seen]) -> Operator:
    """Promise what was seen in the place of what did not come, if it can be planned with."""
    kind = outcomes[-1].kind
    if kind not in ("resting", "held"):
        return _promising(operator, promise, 0.0)
    like = [one for one in outcomes if one.kind == kind]
    seen = msgspec.structs.replace(
        promise,
        kind=kind,
        effect=vector(np.mean([one.effect for one in like], axis=0)),
        spread=(REPEATS,) * 3,
        resting_effect=vector(np.mean([one.resting_effect for one in like], axis=0)),
        resting_spread=(REPEATS,) * 3,
    )
    return _promising(operator, seen, len(like) / (len(outcomes) + 1))


def _promising(operator: Operator, mode: Mode, share: float) -> Operator:
    """Return an operator that promises a mode, which it keeps in a share of its trials."""
    kept = round(share * operator.trials)
    count = max(kept, 1)
    mode = msgspec.structs.replace(mode, near_mean=kept, count=count, share=count / operator.trials)
    others = tuple(other for other in operator.outcomes if other.kind != mode.kind)
    return msgspec.structs.replace(operator, outcomes=(mode, *others), promised=mode.kind)


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
    believed, grounding = experience.believed(seen)
    checked = validate([believed_name(step, believed, grounding) for step in left], believed, grounding)
    if checked.valid and not left:
        return "a condition does not hold, though every goal that was chosen for it is met"
    if checked.failed is None:
        return "" if checked.valid or _can_wait(left, checked, believed) else checked.reason
    step, why = learned_name(checked.failed[0]), checked.failed[1]
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

    steps: tuple[PlanStep, ...]  # by the names of learned operators; empty if there is no plan
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
    hopes = [experience.hoping_again(seen)] if experience._seen or experience._kept else []
    for believing in (experience, *hopes):
        for task in (seen, *_for_fewer(seen, believing)):
            if effort.is_used_up:
                break
            result = replanner(*believing.believed(task))
            effort.spend(result.work or UNTOLD)
            if result.status is PlanStatus.SOLVED:
                steps = tuple(learned_name(step) for step in result.steps)
                said = "" if steps else "nothing that was learned is left to be tried"
                return NewPlan(steps, task, believing, said if task is seen else reason)
            reason = reason or result.reason or result.status.value
    return NewPlan((), seen, believing, reason)


def _for_fewer(problem: Problem, experience: Experience) -> Iterator[Problem]:
    """List problems with fewer goals: all that can be carried to, and then those met now and one more.

    Of goals by relation one is left out whose objects no other one names, so that it is tried again at last.
    """
    believed, grounding = experience.believed(problem)
    if is_relational(believed, grounding):
        for alone in unmet_relations(problem, experience.grounding):
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
