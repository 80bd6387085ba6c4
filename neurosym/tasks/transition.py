"""What a step does: the one transition model that plans are replayed, judged and searched with.

A state says where objects are, what bears what, which place each stands at, and what the hand holds. Where a
step leads is what its operator promises for the object or pair at hand, whatever kind of step it is.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from neurosym.checks import Float, check_kind
from neurosym.errors import counted, in_millimetres
from neurosym.grounding import Grounding, is_lift
from neurosym.operators import TOLERANCE, Operator
from neurosym.pair_operators import RelationOperator, case_of, extent
from neurosym.problems import Problem, pair_key
from neurosym.tasks.options import PUT_DOWN, Put, chance_borne, put_named, step_cost
from neurosym.tasks.promises import promised
from neurosym.tasks.supports import Borne, carried_along, chain_below, loads_of
from neurosym.tasks.task import START, Task, overlapping, understand
from neurosym.world import Scene

# Plans as steps, and steps as text.
#
# A step is one primitive on one object. `ground_plan` prints steps with cells and places, as the printed
# domain has them; `plan_reading` reads what planners print.


@dataclass(frozen=True, slots=True)
class PlanStep:
    """One step of a plan.

    Attributes:
        operator: Name of an operator, or `put-down-` and the name of the operator that lifted the object.
        object: Name of the object.
        place: Name of the place that the object is carried to, or of the other object that it is put on or
            into; empty if it is neither. Places and objects of a problem share no name.
    """

    operator: str
    object: str
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
    """Return the operator and the object of each step, and the place if it has one."""
    return tuple((step.operator, step.object, *filter(None, (step.place,))) for step in steps)


def primitives(steps: Iterable[PlanStep]) -> int:
    """Count the primitives of a plan: putting down belongs to its lift, and is counted nowhere."""
    return sum(not step.puts_down for step in steps)


def print_plan(steps: Sequence[PlanStep], comment: str = "") -> str:
    """Print a plan in IPC form, one `(operator object)` a line.

    Args:
        steps: The plan.
        comment: What the last line says; by default how many steps there are.
    """
    lines = [f"({' '.join(words)})" for words in named_steps(steps)]
    said = comment or counted(primitives(steps), "primitive")
    return "\n".join([*lines, f"; {' '.join(said.split())}"]) + "\n"


@dataclass(frozen=True, slots=True, eq=False)
class State:
    """How the objects of a task are by now.

    Attributes:
        positions: Their centres [m], in the problem's order.
        supports: What bears each object that another one bears.
        stands: The place that each other object stands at: where it started, until it was carried.
        held: The step that lifted what the hand holds, if it holds something.
    """

    positions: Float[np.ndarray, "M 3"]
    supports: Mapping[str, Borne]
    stands: Mapping[str, str]
    held: PlanStep | None = None


@dataclass(frozen=True, slots=True)
class Refusal:
    """Why a step is not possible.

    Attributes:
        sentence: Why not.
        concerned: Names of the other objects that this is about.
        is_afterwards: Whether it is known where the step would lead, and that is what is wrong.
    """

    sentence: str
    concerned: tuple[str, ...] = ()
    is_afterwards: bool = False


@dataclass(frozen=True, slots=True, eq=False)
class Replay:
    """What a plan promises, step by step.

    Attributes:
        positions: Centres of the objects before the first step and after each [m]; a plan that fails ends
            with the step that is impossible.
        possible: Whether every step is possible.
        valid: Whether every step is possible and the goal is met.
        reason: Why not; empty if valid.
        failed: The step that is impossible, and why, if one is.
        concerned: Names of the objects that the reason is about, the one that was moved first.
        number: Number of the step that is impossible, counted from 1; putting down belongs to its lift.
    """

    positions: Float[np.ndarray, "steps M 3"]
    possible: bool
    valid: bool
    reason: str
    failed: tuple[PlanStep, str] | None = None
    concerned: tuple[str, ...] = ()
    number: int | None = None


def start(task: Task) -> State:
    """Return how the objects of a task are at first.

    Args:
        task: The task.
    """
    stands = {name: f"{START}{name}" for name in task.names if name not in task.supports}
    return State(task.problem.scene().positions, task.supports, stands)


def validate(steps: Sequence[PlanStep], problem: Problem, grounding: Grounding) -> Replay:
    """Replay a plan with exact displacements, before it is believed.

    Args:
        steps: The plan.
        problem: The problem it is for, which has every object that the plan names.
        grounding: The learned domain.
    """
    return replay(understand(problem, grounding), steps)


def replay(task: Task, steps: Sequence[PlanStep]) -> Replay:
    """Replay a plan with what its operators promise.

    Args:
        task: The task, which has every object that the plan names.
        steps: The plan.
    """
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
    """Say why a step is not possible now; None if it is.

    Args:
        task: The task.
        state: How the objects are now.
        step: The step.

    Raises:
        UnknownChoice: If there is no such operator, object or place.
    """
    if said := _why_no_step(task, step):
        return Refusal(said)
    put = _put(task, state, step)
    operator = None if put else operator_for(step, task.problem, task.grounding)
    if said := _hand_refusal(step, state.held, operator):
        return Refusal(said, (state.held.object,) if state.held and not step.puts_down else ())
    if put:
        return _why_not_put(task, state, step, put)
    taken = _why_not_carried if step.place else _why_not_alone
    return taken(task, state, step) or _why_not_there(task, apply(task, state, step), step)


def apply(task: Task, state: State, step: PlanStep) -> State:
    """Return how the objects are after a step, whether it is possible or not.

    Args:
        task: The task.
        state: How the objects are now.
        step: The step.
    """
    target, grounding = step.object, task.grounding
    row = task.names.index(target)
    if not step.place:
        operator = operator_for(step, task.problem, grounding)
        by = grounding.put_down_displacement if step.puts_down else grounding.displacement
        after = state.positions.copy()
        after[row] += by(operator)
        held = step if is_lift(operator) and not step.puts_down else None
        return replace(state, positions=after, held=held)
    put = _put(task, state, step)
    supports, stands = dict(state.supports), dict(state.stands)
    there = _where_put(task, state, step, put) if put else _where_carried(task, step)
    moved = [row, *(task.names.index(one) for one in carried_along(target, state.supports))]
    after = state.positions.copy()
    after[moved] += there - state.positions[row]
    stands.pop(target, None)
    supports.pop(target, None)
    if put:
        supports[target] = Borne(step.place, put.state)
    else:
        stands[target] = step.place
    return State(after, supports, stands)


def missed(task: Task, state: State) -> tuple[str, str] | None:
    """Name the first object that misses its goal now, and say how; None if none does.

    Args:
        task: The task.
        state: How the objects are now.
    """
    for target, reference, name in task.problem.related:
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


def chance(task: Task, state: State, step: PlanStep) -> float:
    """Return the chance that a step goes as promised now.

    Args:
        task: The task.
        state: How the objects are now.
        step: The step.
    """
    if put := _put(task, state, step):
        return put.chance
    operator = promise_of(step, task.problem, task.grounding)
    return chance_borne(operator, task.grounding) if step.object in state.supports else operator.chance


def cost(task: Task, state: State, step: PlanStep) -> int:
    """Return what a step costs now; putting down costs nothing.

    Args:
        task: The task.
        state: How the objects are now.
        step: The step.
    """
    if step.puts_down:
        return 0
    if put := _put(task, state, step):
        return put.cost(task.grounding)
    operator = operator_for(step, task.problem, task.grounding)
    return step_cost(operator, task.grounding, borne=step.object in state.supports)


def operator_for(
    step: PlanStep, problem: Problem, grounding: Grounding, tolerance: float | None = None
) -> Operator:
    """Return the operator of a step as it promises for the step's object.

    Args:
        step: The step.
        problem: The problem, which has the object.
        grounding: The learned domain.
        tolerance: How near an outcome must come to the promise to have kept it [m]; that of the goals if not
            given.

    Raises:
        UnknownChoice: If there is no such operator or object.
    """
    item = problem.object_named(step.object)
    near = problem.tolerance if tolerance is None else tolerance
    return promised(grounding, item, near).get(step.base) or grounding.operator_named(step.base)


def promise_of(step: PlanStep, problem: Problem, grounding: Grounding) -> Operator:
    """Return the same, whatever the tolerance of the goals."""
    return operator_for(step, problem, grounding, TOLERANCE)


def hand_problem(steps: Sequence[PlanStep], grounding: Grounding) -> str:
    """Say which step of a plan asks the hand for what it cannot do, or nothing if none does.

    Args:
        steps: The plan.
        grounding: The learned domain.
    """
    held: PlanStep | None = None
    number = 0
    for step in steps:
        number = max(1, number + (not step.puts_down))
        if grounding.relation_named(step.base):
            continue
        operator = grounding.operator_named(step.base)
        if operator.promise and (problem := _hand_refusal(step, held, operator)):
            return f"step {number}, {step.operator} {step.object}: {problem}"
        held = step if is_lift(operator) and not step.puts_down else None
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
    if task.grounding.relation_named(step.base):
        if not step.place:
            return "it does not name the other object"
        task.problem.object_named(step.place)
        return "it names its own object as the other one" if step.place == step.object else ""
    carries = task.grounding.carries(task.grounding.operator_named(step.base))
    if carries and not step.place:
        return "it does not name the place"
    return f"it names the place {step.place}, and goes to none" if step.place and not carries else ""


def _put(task: Task, state: State, step: PlanStep) -> Put | None:
    """Return the operator on pairs of a step, as it is foreseen to turn out now; None if it is none."""
    put = put_named(step.operator, task.grounding) if step.place else None
    if put is None:
        return None
    target, supports = step.object, state.supports
    others = {one for one in loads_of(step.place, supports) if one != target}
    case = case_of(target in supports, bool(others), bool(loads_of(target, supports)))
    return replace(put.with_pair(task.problem, target, step.place), case=case)


def _where_put(task: Task, state: State, step: PlanStep, put: Put) -> Float[np.ndarray, "3"]:
    scene = task.problem.scene()
    now = Scene(scene.features, state.positions, scene.orientations)
    row, other = task.names.index(step.object), task.names.index(step.place)
    halves = (extent(now, row) + extent(now, other)) / 2
    return np.asarray(state.positions[other] + np.array(put.end.offset) * halves)


def _where_carried(task: Task, step: PlanStep) -> Float[np.ndarray, "3"]:
    """Return where an object stands at a place: who carries it makes up for where it hangs from the hand."""
    height = extent(task.problem.scene(), task.names.index(step.object))[2] / 2
    return np.array([*task.flat.place_named(step.place), height])


def _why_not_put(task: Task, state: State, step: PlanStep, put: Put) -> Refusal | None:
    target, reference = step.object, step.place
    kind = task.kinds.get(pair_key(target, reference))
    others = [one for one in loads_of(reference, state.supports) if one != target]
    if not put.operator.is_for(kind):
        return _wrong(f"it is not for {target} with {reference}, a pair of the kind {kind}", reference)
    if target in chain_below(reference, state.supports):
        return _wrong(f"{reference} rests on {target} itself", reference)
    if others and not put.operator.takes("occupied"):
        return _wrong(f"{reference} bears {others[0]}, which rehearsals forbid", reference, others[0])
    if len(others) >= task.most_borne:
        said = f"{reference} bears {counted(len(others), 'object')}, and plans count no more"
        return _wrong(said, reference)
    if loads_of(target, state.supports) and reference not in state.stands:
        return _wrong(f"{target} bears something, and {reference} stands at no place", reference)
    return _why_not_taken(task, state, target, put.operator)


def _why_not_carried(task: Task, state: State, step: PlanStep) -> Refusal | None:
    item, tolerance = task.problem.object_named(step.object), task.problem.tolerance
    if (operator := promised(task.grounding, item, tolerance).get(step.operator)) is None:
        return _wrong(f"it is not for {step.object}")
    return _why_not_taken(task, state, step.object, operator)


def _why_not_taken(
    task: Task, state: State, target: str, operator: Operator | RelationOperator
) -> Refusal | None:
    borne, loads = state.supports.get(target), loads_of(target, state.supports)
    if borne and not task.grounding.takes(operator, "borne"):
        return _wrong(f"{target} rests on {borne.by}, which rehearsals forbid", borne.by)
    if loads and not task.grounding.takes(operator, "laden"):
        return _wrong(f"{target} bears {loads[0]}, which rehearsals forbid", loads[0])
    return None


def _wrong(said: str, *concerned: str) -> Refusal:
    """Refuse a step of which it is known where it would lead."""
    return Refusal(said, concerned, is_afterwards=True)


def _why_not_alone(task: Task, state: State, step: PlanStep) -> Refusal | None:
    """Refuse to push or lift what bears something or is borne: nobody rehearsed that."""
    if task.relates:
        return Refusal("it neither puts its object on another nor carries it to a place")
    borne, loads = state.supports.get(step.object), loads_of(step.object, state.supports)
    if borne:
        return Refusal(f"{step.object} rests on {borne.by}, and is not carried", (borne.by,))
    if loads:
        return Refusal(f"{step.object} bears {loads[0]}, and is not carried", (loads[0],))
    return None


def _why_not_there(task: Task, then: State, step: PlanStep) -> Refusal | None:
    """Refuse an object to be where it was moved to, off the table or in another that stands there."""
    row, target = task.names.index(step.object), step.object
    spot, room = then.positions[row, :2], task.room
    if not np.all((spot >= room[0, row]) & (spot <= room[1, row])):
        return _wrong(f"{target} leaves the table at x = {spot[0]:.3f}, y = {spot[1]:.3f} m")
    if then.held:
        return None
    along = {target, *carried_along(target, then.supports)}
    for other in np.flatnonzero(overlapping(spot, then.positions[:, :2], task.apart[row])):
        name = task.names[int(other)]
        if name not in along:
            return _wrong(f"{target} ends where {name} is", name)
    return None
