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
chosen.
"""

import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from neurosym.checks import Bool, Float, Int
from neurosym.errors import counted
from neurosym.grounding import Grounding, at_rest, is_lift
from neurosym.operators import Operator, Symbol, Vector
from neurosym.planners.planner import PlanResult, PlanStatus, check_time, within
from neurosym.problems import Problem, SceneObject
from neurosym.tasks.options import PUT_DOWN
from neurosym.tasks.promises import promised, usable
from neurosym.tasks.task import footprints_apart, overlapping
from neurosym.tasks.transition import PlanStep
from neurosym.world import Table

DEPTH = 3
"""How many primitives a plan may have (section IV-D)."""
MOST_SEQUENCES = 2_500_000
"""How many sequences of one length are looked at: three of 64 primitives on two objects, or of 8 on 16."""
CHUNK = 4096


@dataclass(frozen=True, slots=True, eq=False)
class Branching:
    """What each choice is predicted to do to each object of a scene.

    A choice is a primitive, or one of the outcomes that a primitive may have.

    Attributes:
        effects: Displacement at the end of the rise [m]; NaN where nothing is predicted.
        resting_effects: Displacement once put down [m]; used where the object ends held.
        held: Whether the object ends held.
        names: Name of the operator of each choice, M rows of P; empty where there is none.
    """

    effects: Float[np.ndarray, "M P 3"]
    resting_effects: Float[np.ndarray, "M P 3"]
    held: Bool[np.ndarray, "M P"]
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

    Args:
        problem: The problem whose M objects the table is for.
        grounding: The learned domain; its operators are in the order of the table of operators, and P is the
            greatest number of live ones of a category.
    """
    rows = [usable(grounding, item, problem.tolerance) for item in problem.objects]
    width = max(1, *map(len, rows))
    operators = tuple((*row, *[None] * (width - len(row))) for row in rows)
    return _branching(operators, _table(operators, grounding.displacement))


def predicted_branching(
    problem: Problem, grounding: Grounding, effects: Float[np.ndarray, "M P 3"]
) -> Branching:
    """Return what the neural model predicts as a branching table.

    The model predicts the effect at the end of the rise. Whether the object is held then, and where it comes
    to rest if so, is what the rehearsals saw. Pairs that were never rehearsed are left out.

    Args:
        problem: The problem whose M objects the table is for.
        grounding: The learned domain; its P primitives are in the order of the table of operators.
        effects: Predicted displacements [m].
    """
    symbols = grounding.operators.symbols

    def promise(item: SceneObject, symbol: Symbol) -> Operator | None:
        learned = grounding.operator_for(item.category, symbol)
        return learned and promised(grounding, item, problem.tolerance)[learned.name]

    operators = tuple(tuple(promise(item, symbol) for symbol in symbols) for item in problem.objects)
    rehearsed = np.array([[operator is not None for operator in row] for row in operators])
    return _branching(operators, np.where(rehearsed[:, :, None], effects, np.nan))


def _branching(
    operators: tuple[tuple[Operator | None, ...], ...], effects: Float[np.ndarray, "M P 3"]
) -> Branching:
    held = np.array([[operator is not None and is_lift(operator) for operator in row] for row in operators])
    names = tuple(tuple(operator.name if operator else "" for operator in row) for row in operators)
    return Branching(effects, _table(operators, _resting), held, names)


def _resting(operator: Operator) -> Vector:
    promise = operator.promise
    return at_rest(promise) if promise else (math.nan, math.nan, math.nan)


def _table(
    operators: tuple[tuple[Operator | None, ...], ...], entry: Callable[[Operator], Vector]
) -> Float[np.ndarray, "M P 3"]:
    none = (math.nan, math.nan, math.nan)
    return np.array([[entry(operator) if operator else none for operator in row] for row in operators])


@dataclass(frozen=True, slots=True, eq=False)
class _Level:
    """All children of some sequences of choices, and where they lead.

    Attributes:
        digits: The choices before the last; a choice is object * P + primitive.
        before: Centres of the objects before the last choice [m].
        lifted: Centre of the chosen object after it, in the air if lifted [m]; NaN if impossible.
        settled: The same once it is put down, for lifts only [m]; NaN if impossible.
    """

    digits: Int[np.ndarray, "n depth"]
    before: Float[np.ndarray, "n M 3"]
    lifted: Float[np.ndarray, "n M P 3"]
    settled: Float[np.ndarray, "n M P 3"]


def plan_bfs(
    problem: Problem,
    branching: Branching,
    table: Table,
    *,
    depth: int = DEPTH,
    time_limit: float = math.inf,
) -> PlanResult:
    """Find a plan with the fewest primitives, the first in breadth-first order.

    Args:
        problem: Where the objects are and shall be.
        branching: What each primitive does to each object.
        table: Where objects may stand.
        depth: How many primitives a plan may have; fewer are looked at if `depth_within` says so.
        time_limit: The user's ceiling [s].
    """
    wanted, depth = depth, depth_within(branching, depth)
    start, goals, room = problem.scene().positions, problem.goal_positions(), problem.room(table)
    if problem.is_met(start):
        return PlanResult(PlanStatus.SOLVED, (), 0.0, "the goal is met at the start")
    apart = footprints_apart(problem)

    def search(deadline: float) -> PlanResult:
        for length in range(1, depth + 1):
            for level in _levels(start, branching, room, length):
                check_time(deadline)
                for choices, ends_down in _goals(level, goals, problem.tolerance):
                    if _keeps_clear(choices, ends_down, branching, start, apart):
                        steps = _steps(choices, ends_down, branching, problem.object_names)
                        return PlanResult(PlanStatus.SOLVED, steps, 0.0)
        reason = f"{counted(depth, 'primitive')} {'does' if depth == 1 else 'do'} not suffice"
        reason += why_not_deeper(branching, wanted)
        return PlanResult(PlanStatus.NOT_FOUND, (), 0.0, reason, depth)

    return within(time_limit, search)


def depth_within(branching: Branching, depth: int = DEPTH) -> int:
    """Return how many primitives are looked ahead, such that `MOST_SEQUENCES` suffice; at least one.

    Args:
        branching: What each primitive does to each object.
        depth: How many are wanted.
    """
    fits = (length for length in range(depth, 1, -1) if branching.held.size**length <= MOST_SEQUENCES)
    return next(fits, min(depth, 1))


def why_not_deeper(branching: Branching, depth: int = DEPTH) -> str:
    """Say why no more primitives are looked ahead, to follow a remark; empty if all that are wanted are.

    Args:
        branching: What each primitive does to each object.
        depth: How many are wanted.
    """
    if (deepest := depth_within(branching, depth)) == depth:
        return ""
    count = branching.held.size ** (deepest + 1)
    return f"; {deepest + 1} would be {count:,} sequences, more than {MOST_SEQUENCES:,}"


def _levels(
    start: Float[np.ndarray, "M 3"], branching: Branching, room: Float[np.ndarray, "2 M 2"], length: int
) -> Iterator[_Level]:
    """List all sequences of a length, in order, a chunk at a time."""
    choices = branching.held.size
    total = choices ** (length - 1)
    for low in range(0, total, CHUNK):
        numbers = np.arange(low, min(low + CHUNK, total))
        powers = choices ** np.arange(length - 2, -1, -1)
        yield _expand(numbers[:, None] // powers % choices, start, branching, room)


def _expand(
    digits: Int[np.ndarray, "n depth"],
    start: Float[np.ndarray, "M 3"],
    branching: Branching,
    room: Float[np.ndarray, "2 M 2"],
) -> _Level:
    objects, primitives = branching.held.shape
    before = np.repeat(start[None], len(digits), axis=0)  # (n, M, 3)
    rows = np.arange(len(digits))
    for digit in digits.T:
        moved, primitive = digit // primitives, digit % primitives
        lifted = before[rows, moved] + branching.effects[moved, primitive]
        before[rows, moved] += branching.settled[moved, primitive]
        # A NaN never goes away again, and so it marks the whole sequence as impossible.
        possible = _inside(lifted, room[:, moved]) & _inside(before[rows, moved], room[:, moved])
        before[~possible] = np.nan
    shape = (len(digits), objects, primitives, 3)
    lifted = np.broadcast_to(before[:, :, None] + branching.effects, shape).copy()
    lifted[~_inside(lifted, room[:, :, None])] = np.nan
    settled = before[:, :, None] + branching.resting_effects
    settled[~_inside(settled, room[:, :, None]) | np.isnan(lifted[..., 0]) | ~branching.held] = np.nan
    return _Level(digits, before, lifted, settled)


def _inside(positions: Float[np.ndarray, "*n 3"], room: Float[np.ndarray, "2 *m"]) -> Bool[np.ndarray, "*n"]:
    spots = positions[..., :2]
    return np.asarray(np.all((spots >= room[0]) & (spots <= room[1]), axis=-1))


def _goals(
    level: _Level, goals: Float[np.ndarray, "M 3"], tolerance: float
) -> Iterator[tuple[tuple[int, ...], bool]]:
    """List the sequences that meet all goals, in order, and whether each ends with a put-down."""
    wrong = np.linalg.norm(level.before - goals, axis=-1) > tolerance  # (n, M), False without a goal
    wrong |= np.isnan(level.before[..., 0])
    others = wrong.sum(axis=1, keepdims=True) == wrong  # (n, M): all other objects are right

    def meets(ends: Float[np.ndarray, "n M P 3"]) -> Bool[np.ndarray, "n M P"]:
        near = np.linalg.norm(ends - goals[:, None], axis=-1) <= tolerance
        without_goal = np.isnan(goals[:, :1]) & ~np.isnan(ends[..., 0])
        return np.asarray(others[:, :, None] & (near | without_goal))

    at_once, after_put_down = meets(level.lifted), meets(level.settled)
    for hit in np.flatnonzero(at_once | after_put_down):
        row, last = divmod(int(hit), at_once[0].size)
        choices = (*map(int, level.digits[row]), last)
        if at_once.reshape(-1)[hit]:
            yield choices, False
        if after_put_down.reshape(-1)[hit]:
            yield choices, True


def _keeps_clear(
    choices: tuple[int, ...],
    ends_down: bool,
    branching: Branching,
    start: Float[np.ndarray, "M 3"],
    apart: Float[np.ndarray, "M M 2"],
) -> bool:
    """Say whether a sequence never puts an object where another stands."""
    here = start.copy()
    for position, choice in enumerate(choices, start=1):
        thing, primitive = divmod(choice, branching.held.shape[1])
        if branching.held[thing, primitive] and position == len(choices) and not ends_down:
            return True
        here[thing] += branching.settled[thing, primitive]
        if overlapping(here[thing, :2], here[:, :2], apart[thing]).any():
            return False
    return True


def _steps(
    choices: tuple[int, ...], ends_down: bool, branching: Branching, objects: Sequence[str]
) -> tuple[PlanStep, ...]:
    steps = []
    for position, choice in enumerate(choices, start=1):
        thing, primitive = divmod(choice, branching.held.shape[1])
        name = branching.names[thing][primitive]
        steps.append(PlanStep(name, objects[thing]))
        if branching.held[thing, primitive] and (position < len(choices) or ends_down):
            steps.append(PlanStep(PUT_DOWN + name, objects[thing]))
    return tuple(steps)
