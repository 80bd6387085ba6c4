"""Putting the steps of a plan in another order: displacements commute, so the end stays the same.

What changes is where the objects are on the way: one order leads an object off the table or into another, and
the next does not. What is left to do says where everything stands, so no set of steps is looked at twice.
"""

from collections.abc import Sequence

import numpy as np

from neurosym.grounding import Grounding, is_lift
from neurosym.planners.planner import Effort
from neurosym.problems import Problem
from neurosym.tasks.task import footprints_apart, overlapping
from neurosym.tasks.transition import PlanStep, Replay, operator_for, validate

MOST_STATES = 5_000
"""How many beginnings of plans are tried."""
ENOUGH = 0.08
"""Room beside an object along y, along which the fingers open, beyond which more makes no difference [m]."""
FINGER = 0.02
"""An object that leaves so much room along x is not in the way of the fingers [m]."""


def ends_held(steps: Sequence[PlanStep], grounding: Grounding) -> bool:
    """Say whether a plan ends with an object in the hand."""
    return bool(steps) and not steps[-1].puts_down and is_lift(grounding.operator_named(steps[-1].base))


def mend(
    steps: Sequence[PlanStep], problem: Problem, grounding: Grounding, effort: Effort | None = None
) -> tuple[tuple[PlanStep, ...], Replay]:
    """Find an order of the steps in which all are possible, beginning with the one given.

    Returns the one given if none is found; and the replay. What is tried is counted as effort.
    """
    given = validate(steps, problem, grounding)
    if given.possible or not steps:
        return tuple(steps), given  # valid, or missing its goal in every order
    blocks = list[tuple[PlanStep, ...]]()  # steps that an empty hand begins, each with its put-down
    for step in steps:
        if step.puts_down and blocks:
            blocks[-1] += (step,)
        else:
            blocks.append((step,))
    last = blocks.pop() if ends_held(steps, grounding) else ()
    found = _ordered(blocks, problem, grounding, effort or Effort())
    if found and (checked := validate((*found, *last), problem, grounding)).possible:
        return (*found, *last), checked
    return tuple(steps), given


def _ordered(
    blocks: Sequence[tuple[PlanStep, ...]], problem: Problem, grounding: Grounding, effort: Effort
) -> tuple[PlanStep, ...]:
    """Search among the orders of blocks, depth first, equal blocks counted; nothing if none is found."""
    kinds = list(dict.fromkeys(blocks))
    rows = [problem.object_names.index(kind[0].object) for kind in kinds]
    shifts = list[tuple[np.ndarray, np.ndarray]]()  # after the first step, and in all [m]
    for kind in kinds:
        operator = operator_for(kind[0], problem, grounding)
        first = np.array(grounding.displacement(operator))
        down = grounding.put_down_displacement(operator) if len(kind) > 1 else (0.0, 0.0, 0.0)
        shifts.append((first, first + down))
    room, apart = problem.room(grounding.table), footprints_apart(problem)
    counts = tuple(map(blocks.count, kinds))
    seen, waiting = {counts}, [(tuple[int, ...](), counts, problem.scene().positions)]
    while waiting and len(seen) < MOST_STATES and effort.spend():
        done, left, here = waiting.pop()
        if not any(left):
            return tuple(step for number in done for step in kinds[number])
        for number in reversed(np.flatnonzero(left).tolist()):
            row, fewer = rows[number], (*left[:number], left[number] - 1, *left[number + 1 :])
            spots = np.array([here[row] + shift for shift in shifts[number]])
            stays = np.all((spots[:, :2] >= room[0, row]) & (spots[:, :2] <= room[1, row]))
            if fewer in seen or not stays or overlapping(spots[1, :2], here[:, :2], apart[row]).any():
                continue
            seen.add(fewer)
            after = here.copy()
            after[row] = spots[1]
            waiting.append(((*done, number), fewer, after))
    return ()


def clearest_first(steps: Sequence[PlanStep], problem: Problem) -> tuple[PlanStep, ...]:
    """Put steps that carry in another order: first what has most room where it stands and where it goes.

    Steps with one object keep their order, and no object is carried to where another stands. If there is no
    such order, nothing is changed.
    """
    names, apart = problem.object_names, footprints_apart(problem)
    here = problem.scene().positions[:, :2].copy()
    left, ordered = list(steps), list[PlanStep]()
    while left:
        rooms: list[tuple[float, int]] = []
        for number, step in enumerate(left):
            row, there = names.index(step.object), np.array(problem.place_named(step.place))
            others = np.arange(len(names)) != row
            is_first = all(earlier.object != step.object for earlier in left[:number])
            if is_first and not overlapping(there, here[others], apart[row, others]).any():
                away = [np.abs(here[others] - spot) - apart[row, others] for spot in (here[row], there)]
                gaps = [float(room[room[:, 0] < FINGER, 1].min(initial=ENOUGH)) for room in away]
                rooms.append((-min(gaps), number))
        if not rooms:
            return tuple(steps)
        step = left.pop(min(rooms)[1])
        here[names.index(step.object)] = problem.place_named(step.place)
        ordered.append(step)
    return tuple(ordered)
