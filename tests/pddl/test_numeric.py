"""The numeric encoding: goals inside the ball, steps as exact as 0.1 mm allows, and plans that are true."""

import math
import operator
import re
from collections.abc import Callable
from pathlib import Path

import msgspec
import numpy as np
import pytest
from tables import BOUNDS, grounding, item, problem, table
from validators import unified_planning_accepts

from neurosym.grounding import Grounding
from neurosym.operators import Mode, Vector
from neurosym.pddl import domain_text, problem_text
from neurosym.pddl.compiler import ground_plan
from neurosym.pddl.numeric import STEPS, UNIT
from neurosym.pddl.plan_reading import parse_plan
from neurosym.problems import Problem
from neurosym.tasks.transition import PlanStep, validate

OPERATIONS: dict[str, Callable[..., float]] = {
    "<=": operator.le,
    ">=": operator.ge,
    "+": operator.add,
    "-": operator.sub,
    "and": lambda *parts: all(parts),
}
Now = dict[tuple[str, ...], int]
"""What holds: the value of each function, and 1 for each fact."""


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


def value(expression, now: Now) -> float:
    """What a condition or sum is."""
    if isinstance(expression, str):
        return int(expression)
    head, *rest = expression
    return OPERATIONS[head](*(value(part, now) for part in rest)) if head in OPERATIONS else now[head, *rest]


def bound(expression, words: dict[str, str]):
    """An expression with words for its variables."""
    if isinstance(expression, str):
        return words.get(expression, expression)
    return [bound(part, words) for part in expression]


def start_of(text: str) -> Now:
    """What holds at the start of a printed problem."""
    init = next(part for part in nested(text) if part[0] == ":init")[1:]
    values = {tuple(one[1]): int(one[2]) for one in init if one[0] == "="}
    return values | {tuple(one): 1 for one in init if one[0] != "="}


class Actions:
    """The printed actions, and what they do."""

    def __init__(self, learned: Grounding):
        parts = nested(domain_text(learned, "numeric"))
        self.by_name = {part[1]: part for part in parts if part[0] == ":action"}

    def _parts(self, line: str) -> tuple[list, list]:
        """The conditions and the effects of a ground action."""
        name, *words = line.strip("()").split()
        (_, _, _, variables, _, condition, _, effect) = self.by_name[name]
        names = [word for word in variables if word.startswith("?")]
        given = dict(zip(names, words, strict=True))
        return bound(condition, given)[1:], bound(effect, given)[1:]

    def applies(self, line: str, now: Now) -> bool:
        """Whether the conditions of a ground action hold."""
        conditions, _ = self._parts(line)
        return all(value(one, now) if one[0] in OPERATIONS else tuple(one) in now for one in conditions)

    def after(self, line: str, now: Now) -> Now:
        """What holds after a ground action; all changes are reckoned from what held before."""
        then = dict(now)
        _, effects = self._parts(line)
        for head, *rest in sorted(effects, key=lambda one: one[0] != "not"):
            match head:
                case "not":
                    del then[tuple(rest[0])]
                case "assign":
                    then[tuple(rest[0])] = value(rest[1], now)
                case "increase":
                    then[tuple(rest[0])] += value(rest[1], now)
                case _:
                    then[head, *rest] = 1
        return then


def offered(now: Now) -> list[str]:
    """All that a printed problem offers, as ground actions."""
    lifting = {fact[2]: fact[1] for fact in now if fact[0] == "lifts"}
    lines = {"pushes": "(push {} {})", "lifts": "(lift {} {})"}
    found = [lines[fact[0]].format(*fact[1:]) for fact in now if fact[0] in lines]
    downs = [fact[1:] for fact in now if fact[0] == "lowers"]
    return found + [f"(put-down {lifting[up]} {down} {up})" for down, up in downs]


def position(now: Now, name: str = "a") -> tuple[int, ...]:
    return tuple(now[axis, name] for axis in "xyz")


def goal_of(task: Problem, steps: int = 1) -> list:
    text = problem_text(task, grounding(), "numeric", steps=steps)
    return next(part for part in nested(text) if part[0] == ":goal")[1]


def accepted(goal: list, offsets: np.ndarray, at: tuple[int, int, int]) -> np.ndarray:
    """Whether the goal holds at each offset from a point, all in units."""
    spots = (offsets + at).tolist()
    return np.array([value(goal, {("x", "a"): x, ("y", "a"): y, ("z", "a"): z}) for x, y, z in spots])


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


def uneven() -> Grounding:
    """The table of operators, with displacements that are no whole numbers of 0.1 mm."""
    off = 0.4 * UNIT

    def shifted(mode: Mode) -> Mode:
        x, y, z = mode.effect
        rest_x, rest_y, rest_z = mode.resting_effect
        ends = {"effect": (x + off, y - off, z), "resting_effect": (rest_x + off, rest_y - off, rest_z)}
        return msgspec.structs.replace(mode, **ends)

    operators = tuple(
        msgspec.structs.replace(one, modes=tuple(map(shifted, one.modes))) for one in table().operators
    )
    learned = grounding()
    return msgspec.structs.replace(
        learned, operators=msgspec.structs.replace(learned.operators, operators=operators)
    )


@pytest.mark.parametrize("learned", [grounding(), uneven()], ids=["even", "uneven"])
def test_plans_that_numbers_allow_are_true_when_replayed(learned: Grounding):
    """The claim of the margins: within so many steps, no plan leaves the table or misses its goal."""
    actions, rng, used = Actions(learned), np.random.default_rng(1), set()
    for _ in range(50):
        x, y = rng.uniform(0.3, 0.9), rng.uniform(-0.3, 0.3)
        start = item("a", float(x), float(y))
        task = Problem("p", (start,), {"a": start.position}, tolerance=STEPS * UNIT / math.sqrt(2))
        first = now = start_of(problem_text(task, learned, "numeric"))
        lines = list[str]()
        while len(lines) < STEPS and (able := [one for one in offered(now) if actions.applies(one, now)]):
            lines.append(str(rng.choice(able)))
            now = actions.after(lines[-1], now)
        ways = np.subtract(position(now), position(first)) * UNIT
        goal = tuple((ways + start.position).tolist())
        task = msgspec.structs.replace(task, goals={"a": goal})
        steps = parse_plan("".join(f"{line}\n" for line in lines), Path("plan"), learned, task)
        assert len(steps) == len(lines)
        checked = validate(steps, task, learned)
        assert checked.valid, checked.reason
        used |= {line.split()[0] for line in lines}
    assert used == {"(push", "(lift", "(put-down"}


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
    text = ground_plan(steps, task, learned, "numeric").text
    assert text.splitlines() == [
        "(push item-02 m-010-item-02)",
        "(push item-02 m-000-item-02)",
        "(push item-01 m-001-item-01)",
        "(lift item-01 m-010-item-01)",
    ]
    assert parse_plan(text, tmp_path / "plan", learned, task) == steps
    assert validate(steps, task, learned).valid
    assert unified_planning_accepts(domain, file, text)
    assert not unified_planning_accepts(domain, file, text.replace("(push item-01 m-001-item-01)\n", ""))


def test_put_down_brings_an_object_to_where_the_lift_would_have_left_it():
    task, learned = problem(), grounding()
    lift, down = "(lift item-01 m-010-item-01)", "(put-down item-01 m-010-down-item-01 m-010-item-01)"
    actions, first = Actions(learned), start_of(problem_text(task, learned, "numeric"))
    assert actions.applies(lift, first)
    assert not actions.applies(down, first)
    held = actions.after(lift, first)
    assert [line for line in offered(held) if actions.applies(line, held)] == [down]
    then = actions.after(down, held)
    moved = np.subtract(position(then, "item-01"), position(first, "item-01"))
    assert moved.tolist() == [141, -228, 0]
    assert {fact for fact in then if then[fact] != first.get(fact)} == {
        ("x", "item-01"),
        ("y", "item-01"),
        ("total-cost",),
    }
    assert set(then) == set(first), "the hand is empty again"


@pytest.mark.parametrize("cell", [0.005, 0.1, 0.15])
def test_both_encodings_offer_the_same_motions_whatever_the_cells(cell: float):
    task, learned = problem(), msgspec.structs.replace(grounding(), cell=cell)
    page, numeric = (
        sorted(re.findall(r"\((pushes|lifts|lowers) (\S+) ([^\s)]+)", problem_text(task, learned, name)))
        for name in ("strips", "numeric")
    )
    motions = [(verb, thing, f"{motion}-{thing}") for verb, thing, motion in page if verb != "lowers"]
    lifted = [(thing, motion) for verb, thing, motion in page if verb == "lowers"]
    downs = [("lowers", f"{motion}-down-{thing}", f"{motion}-{thing}") for thing, motion in lifted]
    assert numeric == sorted(motions + downs)
    assert len(numeric) == len(learned.live) + len(downs)
    assert set(Actions(learned).by_name) == {"push", "lift", "put-down"}
