"""The chance that a plan, followed blindly, comes true: every step as promised, every object within its goal.

Steps fail independently. Those that keep their promise miss it by normal errors along x, y and z, which add
up over the steps with an object. So an object ends in the ball around its goal with the probability that a
normal distribution gives to it. That is summed over fixed points which stand for equal shares of it.
"""

import math
from collections import Counter
from collections.abc import Sequence
from functools import cache
from statistics import NormalDist

import numpy as np

from neurosym.checks import Float
from neurosym.grounding import Grounding
from neurosym.operators import Operator
from neurosym.problems import Problem
from neurosym.tasks.task import understand
from neurosym.tasks.transition import PlanStep, apply, chance, promise_of, start, validate

POINTS = 1024
"""How many points stand for a normal distribution."""
_PLASTIC = 1.2207440846057596  # the root of x^4 = x + 1


def expected_success(steps: Sequence[PlanStep], problem: Problem, grounding: Grounding) -> float:
    """Return the chance that a plan reaches the goal of a problem without replanning.

    Args:
        steps: The plan; a put-down belongs to its lift.
        problem: The problem it is for.
        grounding: The learned domain.
    """
    ends = validate(steps, problem, grounding).positions[-1]
    kept = math.prod(_chances(steps, problem, grounding))
    inside = 1.0
    for name, goal in problem.goals.items():
        spread = spread_of(_moves(name, steps, grounding), problem, grounding)
        end = ends[problem.object_names.index(name)]
        inside *= chance_inside(end - goal, spread, problem.tolerance)
    return kept * inside


def expected_within(steps: Sequence[PlanStep], problem: Problem, grounding: Grounding, motions: int) -> float:
    """Return the chance that the goal is reached within so many motions if it is planned anew on the way.

    A step that does not go as promised, or an object that ends beside its goal, takes a motion more, which is
    as likely to do. An object that is lost ends everything.

    Args:
        steps: The plan; a put-down belongs to its lift.
        problem: The problem it is for.
        grounding: The learned domain.
        motions: How many primitives may be performed.
    """
    ends = validate(steps, problem, grounding).positions[-1]
    left = Counter(step.object for step in steps if not step.puts_down)
    stages = []
    done_with = [step for step in steps if not step.puts_down]
    for step, kept in zip(done_with, _chances(steps, problem, grounding), strict=True):
        is_put = grounding.relation_named(step.base) is not None
        lost = 0.0 if is_put else _share_lost(promise_of(step, problem, grounding))
        left[step.object] -= 1
        if not left[step.object] and step.object in problem.goals:
            spread = spread_of(_moves(step.object, steps, grounding), problem, grounding)
            miss = ends[problem.object_names.index(step.object)] - problem.goals[step.object]
            kept *= chance_inside(miss, spread, problem.tolerance)
        stages.append((kept, max(0.0, 1 - kept - lost)))
    done = np.array([kept for kept, _ in stages])
    again = np.array([*(again for _, again in stages), 1.0])
    so_many = np.zeros(len(stages) + 1)  # how likely so many steps are done
    so_many[0] = 1.0
    for _ in range(motions):
        onward = so_many[:-1] * done
        so_many = so_many * again
        so_many[1:] += onward
    return float(so_many[-1])


def _chances(steps: Sequence[PlanStep], problem: Problem, grounding: Grounding) -> tuple[float, ...]:
    """Return the chance of each step but put-downs to go as promised."""
    task = understand(problem, grounding)
    now, found = start(task), list[float]()
    for step in steps:
        if not step.puts_down:
            found.append(chance(task, now, step))
        now = apply(task, now, step)
    return tuple(found)


def spread_of(steps: Sequence[PlanStep], problem: Problem, grounding: Grounding) -> Float[np.ndarray, "3"]:
    """Return the standard deviation of where the steps with an object lead [m].

    Args:
        steps: The steps, all with one object.
        problem: The problem.
        grounding: The learned domain.
    """
    variance = np.zeros(3)
    for number, step in enumerate(steps, start=1):
        promise = promise_of(step, problem, grounding).promise
        if not step.puts_down and promise is not None:
            if step.place:  # wherever the object was, it is carried to the same spot
                variance[:2] = 0
            ends_held = promise.kind == "held" and number == len(steps)
            spread = promise.spread if ends_held else (*promise.resting_spread[:2], 0.0)
            variance += np.square(spread)
    return np.asarray(np.sqrt(variance))


def _moves(name: str, steps: Sequence[PlanStep], grounding: Grounding) -> list[PlanStep]:
    """List the steps that decide where on the table an object ends."""
    return [step for step in steps if step.object == name and not grounding.relation_named(step.base)]


def _share_lost(operator: Operator) -> float:
    return math.fsum(mode.share for mode in operator.modes if mode.kind == "lost")


def chance_inside(miss: Float[np.ndarray, "3"], spread: Float[np.ndarray, "3"], tolerance: float) -> float:
    """Return the chance that a normal error ends in a ball.

    Args:
        miss: From the ball's centre to the mean [m].
        spread: Standard deviation along each axis [m].
        tolerance: Radius of the ball [m].
    """
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
