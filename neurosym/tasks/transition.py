"""What a step does: the one transition model that plans are replayed, judged and searched with.

A state says where objects are, what bears what, which place each stands at, and what the hand holds. Where a
step leads is what its operator promises for the object or pair at hand, whatever kind of step it is.
"""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from statistics import NormalDist

import numpy as np

from neurosym.checks import Float, check_kind
from neurosym.errors import InvalidValue, UnknownChoice, counted, in_millimetres, shortened
from neurosym.grounding import Grounding, is_lift
from neurosym.operators import TOLERANCE, Operator
from neurosym.pair_operators import LEAST, case_of, extent
from neurosym.problems import Problem, pair_key
from neurosym.tasks.options import PUT_DOWN, Put, chance_borne, put_named, step_cost
from neurosym.tasks.promises import promised
from neurosym.tasks.supports import Borne, carried_along, chain_below, loads_of
from neurosym.tasks.task import START, Task, is_within, overlapping, understand


@dataclass(frozen=True, slots=True)
class PlanStep:
    """One step of a plan: one primitive on one object."""

    operator: str  #: Name of an operator, or `put-down-` and the name of the operator that lifted the object
    object: str  #: Name of the object
    #: Name of the place that the object is carried to, or of the other object that it is put on or into;
    #: empty if it is neither. Places and objects of a problem share no name
    place: str = ""

    def __post_init__(self) -> None:
        for name in ("operator", "object", "place"):
            check_kind(f"{name} of a step", getattr(self, name), str, "its name")

    @property
    def puts_down(self) -> bool:
        """Whether the step puts an object down."""
        return self.operator.startswith(PUT_DOWN)

    @property
    def base(self) -> str:
        """Name of the operator in the table of operators."""
        return self.operator.removeprefix(PUT_DOWN)


Steps = tuple[tuple[str, ...], ...]
"""Operator and object of each step of a plan, and the place if it has one, as records hold it."""


def named_steps(steps: Iterable[PlanStep]) -> Steps:
    """Return steps as records hold them."""
    return tuple((step.operator, step.object, *filter(None, (step.place,))) for step in steps)


def primitives(steps: Iterable[PlanStep]) -> int:
    """Count the primitives of a plan: putting down belongs to its lift, and is counted nowhere."""
    return sum(not step.puts_down for step in steps)


def print_plan(steps: Sequence[PlanStep], comment: str = "") -> str:
    """Print a plan in IPC form, one `(operator object)` a line, and a comment or how many there are."""
    lines = [f"({' '.join(words)})" for words in named_steps(steps)]
    said = comment or counted(primitives(steps), "primitive")
    return "\n".join([*lines, f"; {' '.join(said.split())}"]) + "\n"


@dataclass(frozen=True, slots=True, eq=False)
class State:
    """How the objects of a task are by now."""

    positions: Float[np.ndarray, "M 3"]  # their centres [m], in the problem's order
    supports: Mapping[str, Borne]  # what bears each object that another one bears
    # the place that each other object stands at: where it started, until it was carried
    stands: Mapping[str, str]
    held: PlanStep | None = None  # the step that lifted what the hand holds, if it holds something
    lying: frozenset[str] = frozenset()  # names of the objects that are still to be set upright


@dataclass(frozen=True, slots=True)
class Refusal:
    """Why a step is not possible."""

    sentence: str  # why not
    concerned: tuple[str, ...] = ()  # names of the other objects that this is about
    is_afterwards: bool = False  # whether it is known where the step would lead, and that is what is wrong


@dataclass(frozen=True, slots=True, eq=False)
class Replay:
    """What a plan promises, step by step."""

    # centres of the objects before the first step and after each [m]; a plan that fails ends with the step
    # that is impossible
    positions: Float[np.ndarray, "steps M 3"]
    possible: bool  # whether every step is possible
    valid: bool  # whether every step is possible and the goal is met
    reason: str  # why not; empty if valid
    failed: tuple[PlanStep, str] | None = None  # the step that is impossible, if one is, and why
    # names of the objects that the reason is about, the one that was moved first
    concerned: tuple[str, ...] = ()
    # number of the step that is impossible, counted from 1; putting down belongs to its lift
    number: int | None = None


def start(task: Task) -> State:
    """Return how the objects of a task are at first."""
    stands = {name: f"{START}{name}" for name in task.names if name not in task.supports}
    return State(task.problem.scene().positions, task.supports, stands, lying=frozenset(task.lying))


def validate(steps: Sequence[PlanStep], problem: Problem, grounding: Grounding) -> Replay:
    """Replay a plan for a problem with exact displacements, before it is believed."""
    task = understand(problem, grounding)
    now, number = start(task), 0
    positions = [now.positions]
    for step in steps:
        number = max(1, number + (not step.puts_down))
        found = refusal(task, now, step)
        if found is None or found.is_afterwards:
            now = apply(task, now, step)
            positions.append(now.positions)
        if found:
            said = f"step {number}, {step.operator} {step.object}: {found.sentence}"
            concerned = tuple(dict.fromkeys((step.object, *found.concerned)))
            failed = (step, found.sentence)
            return Replay(np.array(positions), False, False, said, failed, concerned, number)
    name, reason = missed(task, now) or ("", "")
    return Replay(np.array(positions), True, not reason, reason, concerned=(name,) if name else ())


def refusal(task: Task, state: State, step: PlanStep) -> Refusal | None:
    """Say why a step is not possible now, or None; `UnknownChoice` if there is nothing that it names."""
    return next(_refusals(task, state, step), None)


def apply(task: Task, state: State, step: PlanStep) -> State:
    """Return how the objects are after a step, whether it is possible or not; see `refusal`."""
    target, grounding, after = step.object, task.grounding, state.positions.copy()
    row = task.names.index(target)
    if grounding.operator_named(step.base).frame == "side":  # where it stands then, it counts as standing now
        return replace(state, lying=state.lying - {target})
    if not step.place:
        operator = operator_for(step, task.problem, grounding)
        by = grounding.put_down_displacement if step.puts_down else grounding.displacement
        after[row] += by(operator)
        held = step if is_lift(operator) and not step.puts_down else None
        return replace(state, positions=after, held=held)
    put, scene = _put(task, state, step), task.problem.scene()
    supports, stands = dict(state.supports), dict(state.stands)
    for there in (supports, stands):
        there.pop(target, None)
    if put:
        other = task.names.index(step.place)
        now = replace(scene, positions=state.positions)
        halves = (extent(now, row) + extent(now, other)) / 2
        spot = state.positions[other] + np.array(put.end.effect) * halves
        supports[target] = Borne(step.place, put.state)
    else:  # who carries it makes up for where it hangs from the hand
        spot = np.array([*task.flat.place_named(step.place), extent(scene, row)[2] / 2])
        stands[target] = step.place
    moved = [row, *(task.names.index(one) for one in carried_along(target, state.supports))]
    after[moved] += spot - state.positions[row]
    return State(after, supports, stands, lying=state.lying)


def missed(task: Task, state: State) -> tuple[str, str] | None:
    """Name the first object that misses its goal now, and say how; None if none does."""
    for name in sorted(state.lying):
        return name, f"{name} ends on a side, and shall stand upright"
    for target, reference, name in task.problem.relations:
        asked, borne = task.state_named(name), state.supports.get(target)
        if borne != Borne(reference, asked):
            now = f"{borne.state.name} {borne.by}" if borne else "borne by nothing"
            return target, f"{target} ends {now}, not {asked.name} {reference}"
    tolerance = task.problem.tolerance
    for name, distance in task.problem.distances(state.positions).items():
        if distance > tolerance:
            far = in_millimetres(distance, tolerance)
            return name, f"{name} ends {far} from its goal, {1000 * tolerance:g} mm are allowed"
    return None


ASKED = 8.0
"""As how many times as large the odds count that a pair comes into a relation that the goals ask for.

People ask for what fits, and a network that saw pairs at random tells that less sharply. What is hardly
foreseen stays so. Chosen with the
shipped domain on 173 tasks with boxes, towers, and one put: the Brier score of plans came from .163 to .052.
"""


def chance(task: Task, state: State, step: PlanStep) -> float:
    """Return the chance that a step goes as promised now; see `refusal`."""
    if put := _put(task, state, step):
        goal = (step.object, step.place, put.state)
        asked = ((one, other, task.state_named(name)) for one, other, name in task.problem.relations)
        odds = ASKED if put.chance > LEAST and goal in asked else 1.0
        return odds * put.chance / (1 - put.chance + odds * put.chance)
    operator = _raising(task, step) or promise_of(step, task.problem, task.grounding)
    return chance_borne(operator) if step.object in state.supports else operator.chance


def cost(task: Task, state: State, step: PlanStep) -> int:
    """Return what a step costs now, see `refusal`; putting down costs nothing."""
    if step.puts_down:
        return 0
    if put := _put(task, state, step):
        return put.cost(task.grounding)
    operator = _raising(task, step) or operator_for(step, task.problem, task.grounding)
    return step_cost(operator, task.grounding, borne=step.object in state.supports)


def _raising(task: Task, step: PlanStep) -> Operator | None:
    """Return what sets the object of a step upright as it lies at first, if that is the step."""
    operator = task.lying.get(step.object)
    return operator if operator and operator.name == step.operator else None


def operator_for(
    step: PlanStep, problem: Problem, grounding: Grounding, tolerance: float | None = None
) -> Operator:
    """Return the operator of a step as it promises for the step's object; `UnknownChoice` if there is none.

    An outcome that comes so near has kept the promise [m]; by default as near as to goals.
    """
    item = problem.object_named(step.object)
    near = problem.tolerance if tolerance is None else tolerance
    return promised(grounding, item, near).get(step.base) or grounding.operator_named(step.base)


def promise_of(step: PlanStep, problem: Problem, grounding: Grounding) -> Operator:
    """Return the same, whatever the tolerance of the goals."""
    return operator_for(step, problem, grounding, TOLERANCE)


def hand_problem(steps: Sequence[PlanStep], problem: Problem, grounding: Grounding) -> str:
    """Say which step of a plan asks the hand for what it cannot do, or nothing if none does."""
    held, is_sure, number = None, True, 0
    for step in steps:
        number = max(1, number + (not step.puts_down))
        learned, operator = grounding.operator_named(step.base), operator_for(step, problem, grounding)
        if operator.frame == "pair":
            continue
        holds = held if is_sure or step.puts_down else None
        if operator.promise and (said := _hand_refusal(step, holds, operator)):
            return f"step {number}, {step.operator} {step.object}: {said}"
        lifts = [is_lift(one) for one in (learned, operator)]  # with this object it may be no lift any more
        held, is_sure = step if any(lifts) and not step.puts_down else None, all(lifts)
    return ""


def _hand_refusal(step: PlanStep, held: PlanStep | None, operator: Operator | None) -> str:
    """Say why the hand cannot do a step; the operator is None for one on pairs."""
    if operator is not None and operator.promise is None:
        return "the operator promises nothing"
    if step.puts_down:
        lifted = held is not None and (held.operator, held.object) == (step.base, step.object)
        return "" if lifted else f"{step.object} is not held by {step.base}"
    return "" if held is None else f"the hand still holds {held.object}"


def _why_no_step(task: Task, step: PlanStep) -> str:
    """Say what a step lacks, or names too much, whatever the state is; nothing if it is whole."""
    frame = task.grounding.operator_named(step.base).frame
    if frame == "pair":
        if not step.place:
            return "it does not name the other object"
        task.problem.object_named(step.place)
        return "it names its own object as the other one" if step.place == step.object else ""
    if frame == "place":
        return "" if step.place else "it does not name the place"
    return f"it names the place {step.place}, and goes to none" if step.place else ""


def check_aims(problem: Problem, grounding: Grounding, plan: Sequence[PlanStep], free: bool = False) -> None:
    """Refuse steps that carry an object nowhere, to what is not there, or off the table unless they may."""
    for step in plan:
        frame = grounding.operator_named(step.base).frame
        if frame == "pair":
            others = [name for name in problem.object_names if name != step.object]
            if step.place not in others:
                raise UnknownChoice("other object", step.place, others)
        elif frame == "place":
            place = problem.place_named(step.place)
            if not free:
                grounding.table.check(step.place, *place)
        elif step.place:
            said = f"{step.operator} carries nothing, so it cannot lead to {shortened(step.place)}."
            raise InvalidValue(said)


def _put(task: Task, state: State, step: PlanStep) -> Put | None:
    """Return the operator on pairs of a step, as it is foreseen to turn out now; None if it is none."""
    put = put_named(step.operator, task.grounding) if step.place else None
    if put is None:
        return None
    target, supports = step.object, state.supports
    is_occupied = bool({*loads_of(step.place, supports)} - {target})
    case = case_of(target in supports, is_occupied, bool(loads_of(target, supports)))
    return replace(put.with_pair(task.problem, task.grounding, target, step.place), case=case)


def _refusals(task: Task, state: State, step: PlanStep) -> Iterator[Refusal]:
    """Say what is wrong with a step now; each thing is looked at if nothing before it is."""
    if said := _why_no_step(task, step):
        yield Refusal(said)
    put, target = _put(task, state, step), step.object
    operator = None if put else operator_for(step, task.problem, task.grounding)
    if said := _hand_refusal(step, state.held, operator):
        yield Refusal(said, (state.held.object,) if state.held and not step.puts_down else ())
    raises = task.lying[target].name if target in state.lying else ""
    if raises and step.operator != raises:
        yield Refusal(f"{target} lies on a side; {raises} is to set it upright first")
    if operator and operator.frame == "side":
        if not raises:
            yield Refusal(f"{target} need not be set upright")
    elif put:
        yield from _why_not_put(task, state, step, put)
    elif step.place:
        own = promised(task.grounding, task.problem.object_named(target), task.problem.tolerance)
        if step.operator not in own:
            yield _wrong(f"it is not for {target}")
        yield from _why_not_taken(state, target, own[step.operator])
    elif task.relates:
        yield Refusal("it neither puts its object on another nor carries it to a place")
    else:  # nobody rehearsed to push or lift what bears something or is borne
        if borne := state.supports.get(target):
            yield Refusal(f"{target} rests on {borne.by}, and is not carried", (borne.by,))
        for load in loads_of(target, state.supports):
            yield Refusal(f"{target} bears {load}, and is not carried", (load,))
    if not put:
        yield from _why_not_there(task, apply(task, state, step), target)


def _why_not_put(task: Task, state: State, step: PlanStep, put: Put) -> Iterator[Refusal]:
    target, reference = step.object, step.place
    kind = task.kinds.get(pair_key(target, reference))
    others = [one for one in loads_of(reference, state.supports) if one != target]
    if not put.operator.is_for(kind):
        yield _wrong(f"it is not for {target} with {reference}, a pair of the kind {kind}", reference)
    if target in chain_below(reference, state.supports):
        yield _wrong(f"{reference} rests on {target} itself", reference)
    if others and not put.operator.takes("occupied"):
        yield _wrong(f"{reference} bears {others[0]}, which rehearsals forbid", reference, others[0])
    if len(others) >= task.most_borne:
        said = f"{reference} bears {counted(len(others), 'object')}, and plans count no more"
        yield _wrong(said, reference)
    if loads_of(target, state.supports) and reference not in state.stands:
        yield _wrong(f"{target} bears something, and {reference} stands at no place", reference)
    yield from _why_not_taken(state, target, put.operator)


def _why_not_taken(state: State, target: str, operator: Operator) -> Iterator[Refusal]:
    borne = state.supports.get(target)
    if borne and not operator.takes("borne"):
        yield _wrong(f"{target} rests on {borne.by}, which rehearsals forbid", borne.by)
    for load in loads_of(target, state.supports):
        if not operator.takes("laden"):
            yield _wrong(f"{target} bears {load}, which rehearsals forbid", load)


def _wrong(said: str, *concerned: str) -> Refusal:
    """Refuse a step of which it is known where it would lead."""
    return Refusal(said, concerned, is_afterwards=True)


def _why_not_there(task: Task, then: State, target: str) -> Iterator[Refusal]:
    """Refuse an object to be where it was moved to, off the table or in another that stands there."""
    row = task.names.index(target)
    spot = then.positions[row, :2]
    if not is_within(spot, task.room[:, row]):
        yield _wrong(f"{target} leaves the table at x = {spot[0]:.3f}, y = {spot[1]:.3f} m")
    along = {target, *carried_along(target, then.supports)}
    over = () if then.held else np.flatnonzero(overlapping(spot, then.positions[:, :2], task.apart[row]))
    for name in (task.names[int(other)] for other in over):
        if name not in along:
            yield _wrong(f"{target} ends where {name} is", name)


# The chance that a plan, followed blindly, comes true: every step as promised, every object within its goal.
# Steps fail independently. Those that keep their promise miss it by normal errors along x, y and z, which add
# up over the steps with an object. So an object ends in the ball around its goal with the probability that a
# normal distribution gives to it. That is summed over fixed points which stand for equal shares of it.
POINTS = 1024  # that stand for a normal distribution
_PLASTIC = 1.2207440846057596  # the root of x^4 = x + 1


def expected_success(steps: Sequence[PlanStep], problem: Problem, grounding: Grounding) -> float:
    """Return the chance that a plan reaches the goal of a problem without replanning."""
    task = understand(problem, grounding)
    chances, end = _followed(task, steps)
    return math.prod(chances) * math.prod(_chance_at_goal(task, name, steps, end) for name in problem.goals)


def expected_within(steps: Sequence[PlanStep], problem: Problem, grounding: Grounding, motions: int) -> float:
    """Return the chance that the goal is reached within so many motions if it is planned anew on the way.

    A step that does not go as promised, or an object that ends beside its goal, takes a motion more, which is
    as likely to do. An object that is lost ends everything.
    """
    task = understand(problem, grounding)
    chances, end = _followed(task, steps)
    performed = [step for step in steps if not step.puts_down]
    last = {step.object: number for number, step in enumerate(performed)}
    done, again = list[float](), list[float]()
    for number, (step, kept) in enumerate(zip(performed, chances, strict=True)):
        outcomes = promise_of(step, task.problem, grounding).outcomes
        lost = math.fsum(one.share for one in outcomes if one.kind == "lost")
        if number == last[step.object] and step.object in problem.goals:
            kept *= _chance_at_goal(task, step.object, steps, end)
        done.append(kept)
        again.append(max(0.0, 1 - kept - lost))
    so_many = np.eye(1, len(done) + 1)[0]  # how likely so many steps are done
    for _ in range(motions):
        onward = so_many[:-1] * done
        so_many = so_many * [*again, 1.0]
        so_many[1:] += onward
    return float(so_many[-1])


def _followed(task: Task, steps: Sequence[PlanStep]) -> tuple[list[float], Float[np.ndarray, "M 3"]]:
    """Return the chance of each step but put-downs to go as promised, and where objects end if all do [m]."""
    now, found = start(task), list[float]()
    for step in steps:
        if not step.puts_down:
            found.append(chance(task, now, step))
        now = apply(task, now, step)
    return found, now.positions


def _chance_at_goal(task: Task, name: str, steps: Sequence[PlanStep], end: Float[np.ndarray, "M 3"]) -> float:
    """Return the chance that an object ends within its goal, by the steps that decide where that is."""
    own = [step for step in steps if step.object == name]
    miss = end[task.names.index(name)] - task.problem.goals[name]
    return chance_inside(miss, spread_of(own, task.problem, task.grounding), task.problem.tolerance)


def spread_of(steps: Sequence[PlanStep], problem: Problem, grounding: Grounding) -> Float[np.ndarray, "3"]:
    """Return the standard deviation of where the steps with an object lead [m]."""
    variance = np.zeros(3)
    for number, step in enumerate(steps, start=1):
        operator = promise_of(step, problem, grounding)
        if not step.puts_down and operator.frame != "pair" and (promise := operator.promise):
            if step.place:  # wherever the object was, it is carried to the same spot
                variance[:2] = 0
            ends_held = promise.kind == "held" and number == len(steps)
            spread = promise.spread if ends_held else (*promise.resting_spread[:2], 0.0)
            variance += np.square(spread)
    return np.asarray(np.sqrt(variance))


def chance_inside(miss: Float[np.ndarray, "3"], spread: Float[np.ndarray, "3"], tolerance: float) -> float:
    """Return the chance that an error ends in a ball of a radius, whose centre its mean misses [all m]."""
    points = miss + _points() * spread
    return float(np.mean((points**2).sum(1) <= tolerance**2))


@cache
def _points() -> Float[np.ndarray, "P 3"]:
    """Return points that stand for equal shares of a standard normal distribution.

    In the unit cube they are those of the additive recurrence R3 (Roberts, 2018), which lie evenly.
    """
    steps = _PLASTIC ** -np.arange(1.0, 4.0)
    even = (0.5 + np.arange(1, POINTS + 1)[:, None] * steps) % 1
    return np.vectorize(NormalDist().inv_cdf)(even)  # type: ignore[no-any-return]
