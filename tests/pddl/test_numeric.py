"""The numeric encoding: goals inside the ball, steps as exact as 0.1 mm allows, and plans that are true."""

import math
import operator
import re
from collections.abc import Callable
from pathlib import Path

import msgspec
import numpy as np
import pytest
from tables import BOUNDS, grounding, item, problem
from validators import unified_planning_accepts

from neurosym.operators import Vector
from neurosym.pddl import domain_text, problem_text
from neurosym.pddl.ground_plan import print_ground_plan
from neurosym.pddl.numeric import STEPS, UNIT
from neurosym.pddl.plan_reading import parse_plan
from neurosym.pddl.plan_text import PlanStep
from neurosym.pddl.validation import validate
from neurosym.problems import Problem

OPERATIONS: dict[str, Callable[..., float]] = {
    "<=": operator.le,
    ">=": operator.ge,
    "+": operator.add,
    "and": lambda *parts: all(parts),
}


def nested(text: str) -> list:
    """An s-expression as nested lists."""
    stack: list[list] = [[]]
    for word in re.findall(r"[()]|[^\s()]+", re.sub(r";.*", "", text)):
        if word == "(":
            stack.append([])
        elif word == ")":
            stack[-2].append(stack.pop())
        else:
            stack[-1].append(word)
    return stack[0][0]


def value(expression, numbers: dict[str, int]) -> float:
    """What a condition or sum is, given what x, y and z are."""
    if isinstance(expression, str):
        return int(expression)
    head, *rest = expression
    return numbers[head] if head in numbers else OPERATIONS[head](*(value(part, numbers) for part in rest))


def goal_of(task: Problem, steps: int = 1) -> list:
    text = problem_text(task, grounding(), "numeric", steps=steps)
    return next(part for part in nested(text) if part[0] == ":goal")[1]


def accepted(goal: list, offsets: np.ndarray, at: tuple[int, int, int]) -> np.ndarray:
    """Whether the goal holds at each offset from a point, all in units."""
    spots = (offsets + at).tolist()
    return np.array([value(goal, {"x": x, "y": y, "z": z}) for x, y, z in spots])


@pytest.mark.parametrize("end", [(0.537, -0.021, 0.025), (0.5011, 0.1234, 0.225), (0.3021, -0.2987, 0.025)])
def test_goal_lies_within_the_ball_and_fills_most_of_its_disc(end: Vector):
    task = Problem("p", (item("a", 0.45123, 0.01377),), {"a": end})
    goal = goal_of(task, steps=0)
    rng = np.random.default_rng(0)
    offsets = np.concatenate([rng.integers(-520, 520, (4000, 2)), np.zeros((4000, 1), dtype=int)], axis=1)
    height = 2030 if end[2] > 0.1 else 0
    start = np.array(task.objects[0].position)
    anchor = np.rint((start[:2] - (BOUNDS.x[0], BOUNDS.y[0])) / UNIT).astype(int)
    centre = anchor + np.rint((np.array(end[:2]) - start[:2]) / UNIT).astype(int)
    inside = accepted(goal, offsets, (*centre.tolist(), height))
    exact = start + np.append((offsets[:, :2] + centre - anchor), np.full((4000, 1), height), axis=1) * UNIT
    misses = np.linalg.norm(exact - end, axis=1)
    assert misses[inside].max() <= task.tolerance + 1e-9
    in_disc = np.count_nonzero(misses <= task.tolerance)
    assert 0.85 * in_disc < np.count_nonzero(inside) <= in_disc
    assert not accepted(goal, offsets, (*centre.tolist(), height + 600)).any()


def test_more_steps_make_the_goal_smaller():
    task = Problem("p", (item("a", 0.45, 0.0),), {"a": (0.55, 0.0, 0.025)})
    offsets = np.array([[x, 0, 0] for x in range(-500, 500)])
    sizes = [accepted(goal_of(task, steps), offsets, (2500, 3000, 0)).sum() for steps in (0, 1, 3)]
    assert sizes[0] > sizes[1] > sizes[2] > 800


@pytest.mark.parametrize("end", [(0.55, 0.0, 0.4), (0.55, 0.0, -0.4), (0.55, 0.0, 0.12)])
def test_goal_at_a_height_that_nothing_can_have_holds_nowhere(end: Vector):
    task = Problem("p", (item("a", 0.45, 0.0),), {"a": end})
    heights = np.array([[0, 0, z] for z in (0, 2030)])
    assert not accepted(goal_of(task), heights, (2500, 3000, 0)).any()


def test_goal_off_the_table_is_printed_without_negative_numbers():
    task = Problem("p", (item("a", 0.31, -0.29),), {"a": (0.2, -0.4, 0.025)})
    text = problem_text(task, grounding(), "numeric")
    assert not re.search(r"[\s(]-\d", re.sub(r";.*", "", text))
    assert not accepted(goal_of(task), np.zeros((1, 3), dtype=int), (0, 0, 0)).any()


def test_plans_that_numbers_allow_are_true_when_replayed():
    """The claim of the margins: within so many steps, no plan leaves the table or misses its goal."""
    learned, rng = grounding(), np.random.default_rng(1)
    actions = {part[1]: part for part in nested(domain_text(learned, "numeric")) if part[0] == ":action"}
    pushes = [name for name, part in actions.items() if part[3][2] == "block" and name.startswith("push")]
    for _ in range(50):
        x, y = rng.uniform(0.3, 0.9), rng.uniform(-0.3, 0.3)
        start = item("a", float(x), float(y))
        now = {"x": round((x - 0.3) / UNIT), "y": round((y + 0.3) / UNIT), "z": 0}
        first, steps = dict(now), []
        for name in rng.choice(pushes, STEPS).tolist():
            conditions = [part for part in actions[name][5][1:] if part[0] in OPERATIONS]
            if not value(["and", *conditions], now):
                continue
            for change in actions[name][7][1:]:
                if change[1][0] in now:
                    sign = 1 if change[0] == "increase" else -1
                    now[change[1][0]] += sign * int(change[2])
            steps.append(PlanStep(name, "a"))
        goal = tuple(
            at + (now[axis] - first[axis]) * UNIT for axis, at in zip("xyz", start.position, strict=True)
        )
        task = Problem("p", (start,), {"a": goal}, tolerance=STEPS * UNIT / math.sqrt(2))
        checked = validate(steps, task, learned)
        assert checked.valid, checked.reason


def test_a_plan_is_valid_in_numbers_and_half_of_it_is_not(tmp_path: Path):
    task, learned = problem(), grounding()
    steps = (
        PlanStep("pull-010-tray", "item-02"),
        PlanStep("push-left-000-tray", "item-02"),
        PlanStep("push-away-001-block", "item-01"),
        PlanStep("lift-010-block", "item-01"),
    )
    domain, file = tmp_path / "domain.pddl", tmp_path / "problem.pddl"
    domain.write_text(domain_text(learned, "numeric"))
    file.write_text(problem_text(task, learned, "numeric"))
    text = print_ground_plan(steps, task, learned, "numeric")
    assert text == "".join(f"({step.operator} {step.object})\n" for step in steps)
    assert parse_plan(text, tmp_path / "plan", learned, task) == steps
    assert validate(steps, task, learned).valid
    assert unified_planning_accepts(domain, file, text)
    assert not unified_planning_accepts(domain, file, text.replace("(push-away-001-block item-01)\n", ""))


def test_put_down_brings_an_object_to_where_the_lift_would_have_left_it():
    by_name = {
        part[1]: part[7][1:] for part in nested(domain_text(grounding(), "numeric")) if part[0] == ":action"
    }
    sums = dict.fromkeys("xyz", 0)
    for name in ("lift-010-block", "put-down-lift-010-block"):
        for change in by_name[name]:
            if change[0] in ("increase", "decrease") and change[1][0] in sums:
                sums[change[1][0]] += int(change[2]) * (1 if change[0] == "increase" else -1)
    assert sums == {"x": 141, "y": -228, "z": 0}


def test_both_have_the_same_operators_whatever_the_cells():
    coarse = msgspec.structs.replace(grounding(), cell=0.1)
    for learned in (grounding(), coarse):
        numeric, stepwise = (
            set(re.findall(r"\(:action ([a-z]\S+)", domain_text(learned, name)))
            for name in ("numeric", "operators")
        )
        assert numeric == stepwise - {"reach-goal"}
