"""The chance that a plan, followed blindly, comes true: every step as promised, every object within its goal.

Steps fail independently. Those that keep their promise miss it by normal errors along x, y and z, which add
up over the steps with an object. So an object ends in the ball around its goal with the probability that a
normal distribution gives to it. That is summed over fixed points which stand for equal shares of it.
"""

import math
from collections.abc import Sequence
from functools import cache
from statistics import NormalDist

import numpy as np

from neurosym.checks import Float
from neurosym.grounding import Grounding
from neurosym.problems import Problem
from neurosym.tasks.task import Task, understand
from neurosym.tasks.transition import PlanStep, apply, chance, promise_of, start

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
        is_put = grounding.relation_named(step.base) is not None
        modes = () if is_put else promise_of(step, problem, grounding).modes
        lost = math.fsum(mode.share for mode in modes if mode.kind == "lost")
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
    own = [step for step in steps if step.object == name and not task.grounding.relation_named(step.base)]
    miss = end[task.names.index(name)] - task.problem.goals[name]
    return chance_inside(miss, spread_of(own, task.problem, task.grounding), task.problem.tolerance)


def spread_of(steps: Sequence[PlanStep], problem: Problem, grounding: Grounding) -> Float[np.ndarray, "3"]:
    """Return the standard deviation of where the steps with an object lead [m]."""
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
