"""Breadth-first search over predicted effects: the paper's planner (section III-D).

Effects do not depend on where an object stands, so a branching table says it all: what each primitive does to
each object, by the neural model or by what the operators promise. A sequence of d choices out of P primitives
x M objects is a number with d digits, and counting through the numbers is breadth-first search. The last
digit is handled for all its values at once, and the others in chunks, so memory stays bounded. What is not
bounded is how many sequences there are: with 64 primitives and four objects, 16.8 million of three. So it
goes only as deep as `MOST_SEQUENCES` allow.

The world's rules hold here as in PDDL: what is lifted must be put down before the next primitive (free of
charge: a step of the plan, but not of the depth), a plan may end with the object held, nobody leaves the
table, and nobody is put where another stands. A pair without a prediction has the effect NaN and is never
chosen. Among objects that bear one another, what a step leads to does depend on where they are: there the
search goes from state to state.
"""

import math
import sys
from collections.abc import Callable, Hashable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np

from neurosym.checks import Bool, Float, Int
from neurosym.errors import counted
from neurosym.grounding import Grounding, at_rest, is_lift
from neurosym.operators import Operator, Symbol
from neurosym.planners.planner import MET_AT_START, PlanResult, PlanStatus, check_time, within
from neurosym.problems import Problem, SceneObject
from neurosym.tasks.options import PUT_DOWN
from neurosym.tasks.promises import promised, usable
from neurosym.tasks.task import Task, footprints_apart, is_within, overlapping, understand
from neurosym.tasks.transition import PlanStep, State, apply, missed, refusal, start
from neurosym.world import Table, heading, turned_by

DEPTH = 3
"""How many primitives a plan may have (section IV-D)."""
MOST_SEQUENCES = 2_500_000
"""How many sequences of one length are looked at: three of 64 primitives on two objects, or of 8 on 16."""
MOST_STEPS = 60_000
"""How many steps are looked at among objects that bear one another."""
CHUNK = 4096


@dataclass(frozen=True, slots=True, eq=False)
class Branching:
    """What each choice is predicted to do to each object of a scene.

    A choice is a primitive, or one of the outcomes that a primitive may have.
    """

    # displacement at the end of the rise [m]; NaN where nothing is predicted
    effects: Float[np.ndarray, "M P 3"]
    # displacement once put down [m]; used where the object ends held
    resting_effects: Float[np.ndarray, "M P 3"]
    held: Bool[np.ndarray, "M P"]  # whether the object ends held
    # name of the operator of each choice, M rows of P; empty where there is none
    names: tuple[tuple[str, ...], ...]

    @property
    def settled(self) -> Float[np.ndarray, "M P 3"]:
        """Displacement before the next primitive may begin [m]."""
        return np.where(self.held[:, :, None], self.resting_effects, self.effects)

    def usable(self, index: int) -> tuple[int, ...]:
        """Return the choices that predict something for an object."""
        predicted = np.isfinite(self.effects[index]) & np.isfinite(self.settled[index])
        return tuple(np.flatnonzero(predicted.all(axis=-1)).tolist())


def branching_of(problem: Problem, grounding: Grounding) -> Branching:
    """Return what the live operators promise as a branching table.

    They are in the order of the table of operators; P is the greatest number of live ones of a category.
    """
    return _branching([usable(grounding, item, problem.tolerance) for item in problem.objects], grounding)


def predicted_branching(
    problem: Problem, grounding: Grounding, effects: Float[np.ndarray, "M P 3"]
) -> Branching:
    """Return what the neural model predicts as a branching table; see `branching_of`.

    It predicts the effect at the end of the rise [m]. Whether the object is held then, and where it comes to
    rest if so, is what the rehearsals saw. Pairs that were never rehearsed are left out.
    """
    symbols = grounding.objects.symbols

    def promise(item: SceneObject, symbol: Symbol) -> Operator | None:
        learned = grounding.operator_for(item.category, symbol)
        return learned and promised(grounding, item, problem.tolerance)[learned.name]

    table = _branching([[promise(item, symbol) for symbol in symbols] for item in problem.objects], grounding)
    rehearsed = np.array(table.names) != ""
    if grounding.turned:
        lie = [heading(np.array(item.orientation)) for item in problem.objects]
        effects = np.array([turned_by(*row) for row in zip(lie, effects, strict=True)])
    return replace(table, effects=np.where(rehearsed[:, :, None], effects, np.nan))


def _branching(rows: Sequence[Sequence[Operator | None]], grounding: Grounding) -> Branching:
    """Return what operators promise as a branching table, a row for each object."""
    shape = len(rows), max(1, *map(len, rows))
    effects, resting_effects = np.full((2, *shape, 3), np.nan)
    held, names = np.zeros(shape, dtype=bool), np.full(shape, "", dtype=object)
    for row, operators in enumerate(rows):
        for column, operator in enumerate(operators):
            if operator is None:
                continue
            names[row, column], held[row, column] = operator.name, is_lift(operator)
            if operator.promise:
                effects[row, column] = grounding.displacement(operator)
                resting_effects[row, column] = at_rest(operator.promise)
    return Branching(effects, resting_effects, held, tuple(map(tuple, names.tolist())))


def plan_bfs(
    problem: Problem, branching: Branching, table: Table, *, depth: int = DEPTH, time_limit: float = math.inf
) -> PlanResult:
    """Find a plan with the fewest primitives, the first in breadth-first order.

    It may have so many as the depth says, or fewer if `depth_within` says so.
    """
    begin, room, deepest = problem.scene().positions, problem.room(table), depth_within(branching, depth)
    if problem.is_met(begin):
        return MET_AT_START
    width, apart = branching.held.size, footprints_apart(problem)

    def search(deadline: float) -> PlanResult:
        for length in range(1, deepest + 1):
            for low in range(0, width ** (length - 1), CHUNK):
                check_time(deadline)
                numbers = np.arange(low, min(low + CHUNK, width ** (length - 1)))
                digits = numbers[:, None] // width ** np.arange(length - 2, -1, -1) % width  # (n, length - 1)
                for choices, ends_down in _meeting(digits, problem, branching, room):
                    if steps := _steps(choices, ends_down, branching, problem, apart):
                        return PlanResult(PlanStatus.SOLVED, steps, 0.0)
        reason = f"{counted(deepest, 'primitive')} {'does' if deepest == 1 else 'do'} not suffice"
        reason += why_not_deeper(branching, depth)
        return PlanResult(PlanStatus.NOT_FOUND, (), 0.0, reason, deepest)

    return within(time_limit, search)


def depth_within(branching: Branching, depth: int = DEPTH) -> int:
    """Return how many primitives are looked ahead, such that `MOST_SEQUENCES` suffice; at least one."""
    fits = (length for length in range(depth, 1, -1) if branching.held.size**length <= MOST_SEQUENCES)
    return next(fits, min(depth, 1))


def why_not_deeper(branching: Branching, depth: int = DEPTH) -> str:
    """Say why no more primitives are looked ahead, to follow a remark; empty if all that are wanted are."""
    if (deepest := depth_within(branching, depth)) == depth:
        return ""
    count = branching.held.size ** (deepest + 1)
    return f"; {deepest + 1} would be {count:,} sequences, more than {MOST_SEQUENCES:,}"


def _meeting(
    digits: Int[np.ndarray, "n depth"],
    problem: Problem,
    branching: Branching,
    room: Float[np.ndarray, "2 M 2"],
) -> Iterator[tuple[tuple[int, ...], bool]]:
    """List the sequences that meet all goals, in order, and whether each ends with a put-down.

    A choice is object * P + primitive. Each sequence is one of those given, and any last choice.
    """
    primitives = branching.held.shape[1]
    before = np.repeat(problem.scene().positions[None], len(digits), axis=0)  # (n, M, 3)
    rows, settled = np.arange(len(digits)), branching.settled
    for digit in digits.T:
        moved, primitive = digit // primitives, digit % primitives
        lifted = before[rows, moved] + branching.effects[moved, primitive]
        before[rows, moved] += settled[moved, primitive]
        # A NaN never goes away again, and so it marks the whole sequence as impossible.
        possible = is_within(lifted, room[:, moved]) & is_within(before[rows, moved], room[:, moved])
        before[~possible] = np.nan
    goals, tolerance = problem.goal_positions(), problem.tolerance  # (M, 3), NaN without a goal
    wrong = np.linalg.norm(before - goals, axis=-1) > tolerance  # (n, M), False without a goal
    wrong |= np.isnan(before[..., 0])
    others = wrong.sum(axis=1, keepdims=True) == wrong  # (n, M): all other objects are right

    def met(effects: Float[np.ndarray, "M P 3"]) -> tuple[Bool[np.ndarray, "n M P"], ...]:
        ends = before[:, :, None] + effects  # (n, M, P, 3)
        inside = is_within(ends, room[:, :, None])
        near = np.linalg.norm(ends - goals[:, None], axis=-1) <= tolerance
        return inside, inside & others[:, :, None] & (near | np.isnan(goals[:, :1]))

    risen, at_once = met(branching.effects)
    _, resting = met(branching.resting_effects)
    put_down = resting & risen & branching.held
    for row, thing, primitive in np.argwhere(at_once | put_down).tolist():
        choices = (*digits[row].tolist(), thing * primitives + primitive)
        if at_once[row, thing, primitive]:
            yield choices, False
        if put_down[row, thing, primitive]:
            yield choices, True


def _steps(
    choices: tuple[int, ...],
    ends_down: bool,
    branching: Branching,
    problem: Problem,
    apart: Float[np.ndarray, "M M 2"],
) -> tuple[PlanStep, ...]:
    """Write a sequence as steps; none if it puts an object where another stands."""
    here, settled, steps = problem.scene().positions, branching.settled, list[PlanStep]()
    for position, choice in enumerate(choices, start=1):
        thing, primitive = divmod(choice, branching.held.shape[1])
        name, target = branching.names[thing][primitive], problem.object_names[thing]
        steps.append(PlanStep(name, target))
        if branching.held[thing, primitive]:
            if position == len(choices) and not ends_down:
                break
            steps.append(PlanStep(PUT_DOWN + name, target))
        here[thing] += settled[thing, primitive]
        if overlapping(here[thing, :2], here[:, :2], apart[thing]).any():
            return ()
    return tuple(steps)


def plan_related(
    problem: Problem, grounding: Grounding, *, time_limit: float = math.inf, most_steps: int = MOST_STEPS
) -> PlanResult:
    """Find a plan with the fewest steps for objects that bear one another, the first in breadth-first order.

    A step puts an object on or into another one, or carries it to a place. What it leads to is what its
    operator promises; with which pairs that is likely, a problem says as a network foresees it.
    """
    task = understand(problem, grounding)
    every = _every_step(task)

    def onward(now: State) -> Iterator[tuple[PlanStep, State | None]]:
        yield from ((step, None if refusal(task, now, step) else apply(task, now, step)) for step in every)

    return breadth_first(
        start(task),
        onward,
        lambda now: missed(task, now) is None,
        _key,
        time_limit=time_limit,
        most_steps=most_steps,
        otherwise="no sequence of steps leads there with the places that were drawn",
    )


_State = TypeVar("_State")


def breadth_first(
    begin: _State,
    onward: Callable[[_State], Iterable[tuple[PlanStep, _State | None]]],
    is_met: Callable[[_State], bool],
    key: Callable[[_State], Hashable],
    *,
    time_limit: float,
    most_steps: int,
    otherwise: str,
    depth: int = sys.maxsize,
) -> PlanResult:
    """Search from state to state; states that were met before are not looked at again.

    Args:
        begin: Where to begin.
        onward: Lists the steps from a state, each with where it leads, or None if it is not possible.
        is_met: Says whether a state meets the goal.
        key: Tells states apart.
        time_limit: The user's ceiling [s].
        most_steps: How many steps are looked at, possible or not.
        otherwise: Why there is no plan if all were.
        depth: How many steps a plan may have.
    """

    def search(deadline: float) -> PlanResult:
        level: list[tuple[tuple[PlanStep, ...], _State]] = [((), begin)]  # steps, and what they lead to
        met, looked, deep = {key(begin)}, 0, 0
        while level and deep < depth:
            found, deep = list[tuple[tuple[PlanStep, ...], _State]](), deep + 1
            for before, now in level:
                check_time(deadline)
                for step, then in onward(now):
                    looked += 1
                    if then is None or key(then) in met:
                        continue
                    met.add(key(then))
                    found.append(((*before, step), then))
                    if is_met(then):
                        return PlanResult(PlanStatus.SOLVED, found[-1][0], 0.0)
                if looked > most_steps:
                    reason = f"{counted(most_steps, 'step')} were looked at, {deep - 1} deep"
                    return PlanResult(PlanStatus.NOT_FOUND, (), 0.0, reason, deep - 1)
            level = found
        return PlanResult(PlanStatus.NOT_FOUND, (), 0.0, otherwise, deep)

    return within(time_limit, search)


def _every_step(task: Task) -> tuple[PlanStep, ...]:
    """List all steps there are: onto other objects first, in the order of the objects."""
    puts = [PlanStep(put.name, *pair) for pair, found in task.puts.items() for put in found]
    carriers = [(name, task.carriers[name][0].name) for name in task.names if name in task.carriers]
    return (*puts, *(PlanStep(carrier, name, place) for name, carrier in carriers for place in task.places))


def _key(now: State) -> Hashable:
    """Say what tells two ends apart: what bears what, and what stands at which place."""
    borne = ((name, one.by, one.state.symbol) for name, one in now.supports.items())
    return frozenset(borne), frozenset(now.stands.items())
