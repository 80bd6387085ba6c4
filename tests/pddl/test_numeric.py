"""The numeric encoding: goals inside the ball, steps as exact as 0.1 mm allows, and plans that are true."""

import copy
import math
import re
from pathlib import Path

import numpy as np
import pytest
import rehearsed
from independent.ground_pddl import Task, read_task
from msgspec.structs import replace
from tables import BOUNDS, grounding, item, problem, table

from neurosym.grounding import Grounding
from neurosym.operators import Mode, Vector
from neurosym.pddl import domain_text, problem_text
from neurosym.pddl.numeric import STEPS, UNIT
from neurosym.pddl.plan_reading import parse_plan
from neurosym.problems import Problem
from neurosym.tasks.transition import validate

AXES = (("x", "a"), ("y", "a"), ("z", "a"))


def printed(task: Problem, learned: Grounding | None = None, **options: int) -> Task:
    """The domain and a problem as they are printed, read by who knows nothing of neurosym."""
    learned = learned or grounding()
    return read_task(domain_text(learned, "numeric"), problem_text(task, learned, "numeric", **options))


def do(now: Task, line: str) -> Task | None:
    """What is so after a ground action; nothing if that is not possible."""
    then = copy.copy(now)
    return None if then.do((*line.strip("()").split(),)) else then


def offered(now: Task) -> list[str]:
    """All that a printed problem offers and that is possible, as ground actions."""
    lifting = {fact[2]: fact[1] for fact in now.facts if fact[0] == "lifts"}
    forms = {"pushes": "(push {} {})", "lifts": "(lift {} {})"}
    found = [forms[fact[0]].format(*fact[1:]) for fact in sorted(now.facts) if fact[0] in forms]
    downs = [fact[1:] for fact in sorted(now.facts) if fact[0] == "lowers"]
    found += [f"(put-down {lifting[up]} {down} {up})" for down, up in downs]
    return [line for line in found if do(now, line)]


def accepted(task: Task, spots: np.ndarray) -> np.ndarray:
    """Whether the goal holds at each place, in units, shape (places, 3)."""

    def holds(spot: list[int]) -> bool:
        task.numbers.update(zip(AXES, spot, strict=True))
        return task.holds(task.goal, {})

    return np.array([holds(spot) for spot in spots.tolist()])


@pytest.mark.parametrize("end", [(0.537, -0.021, 0.025), (0.5011, 0.1234, 0.225), (0.3021, -0.2987, 0.025)])
def test_goal_lies_within_the_ball_and_fills_most_of_its_disc(end: Vector):
    task = Problem("p", (item("a", 0.45123, 0.01377),), {"a": end})
    goal, rng = printed(task, steps=0), np.random.default_rng(0)
    start, height = np.array(task.objects[0].position), 2030 if end[2] > 0.1 else 0
    anchor = np.rint((start[:2] - (BOUNDS.x[0], BOUNDS.y[0])) / UNIT).astype(int)
    centre = anchor + np.rint((np.array(end[:2]) - start[:2]) / UNIT).astype(int)
    spots = np.insert(rng.integers(-520, 520, (2000, 2)) + centre, 2, height, axis=1)
    inside = accepted(goal, spots)
    misses = np.linalg.norm(start + (spots - [*anchor, 0]) * UNIT - end, axis=1)
    assert misses[inside].max() <= task.tolerance + 1e-9
    in_disc = np.count_nonzero(misses <= task.tolerance)
    assert 0.85 * in_disc < np.count_nonzero(inside) <= in_disc
    assert not accepted(goal, spots + np.array([0, 0, 600])).any()


def test_more_steps_make_the_goal_smaller():
    task = Problem("p", (item("a", 0.45, 0.0),), {"a": (0.55, 0.0, 0.025)})
    row = np.array([[x, 3000, 0] for x in range(2000, 3000)])
    sizes = [accepted(printed(task, steps=steps), row).sum() for steps in (0, 1, 3)]
    assert sizes[0] > sizes[1] > sizes[2] > 800


@pytest.mark.parametrize("end", [(0.55, 0.0, 0.4), (0.55, 0.0, -0.4), (0.55, 0.0, 0.12), (0.2, -0.4, 0.025)])
def test_goal_off_the_table_or_where_nothing_ends_holds_nowhere_and_has_no_negative_numbers(end: Vector):
    task = Problem("p", (item("a", 0.45, 0.0),), {"a": end})
    assert not re.search(r"[\s(]-\d", re.sub(r";.*", "", problem_text(task, grounding(), "numeric")))
    assert not accepted(printed(task), np.array([[2500, 3000, 0], [2500, 3000, 2030], [0, 0, 0]])).any()


def uneven() -> Grounding:
    """The table of operators, with displacements that are no whole numbers of 0.1 mm."""
    off = 0.4 * UNIT

    def shifted(mode: Mode) -> Mode:
        (x, y, z), (rest_x, rest_y, rest_z) = mode.effect, mode.resting_effect
        ends = {"effect": (x + off, y - off, z), "resting_effect": (rest_x + off, rest_y - off, rest_z)}
        return replace(mode, **ends)

    operators = tuple(replace(one, outcomes=tuple(map(shifted, one.outcomes))) for one in table().operators)
    learned = grounding()
    return replace(learned, objects=replace(learned.objects, operators=operators))


@pytest.mark.parametrize("learned", [grounding(), uneven(), rehearsed.grounding()])
def test_plans_that_numbers_allow_are_true_when_replayed(learned: Grounding):
    """The claim of the margins: within so many steps, no plan leaves the table or misses its goal."""
    rng, used = np.random.default_rng(1), set()
    for _ in range(30):
        start = rehearsed.item("a", *rng.uniform((0.3, -0.3, 0.036), (0.9, 0.3, 0.064)).tolist())
        task = Problem("p", (start,), {"a": start.position}, tolerance=STEPS * UNIT / math.sqrt(2))
        first = now = printed(task, learned)
        lines = list[str]()
        while len(lines) < STEPS and (able := offered(now)):
            lines.append(str(rng.choice(able)))
            now = do(now, lines[-1])
        ways = [(now.numbers[axis] - first.numbers[axis]) * UNIT for axis in AXES]
        task = replace(task, goals={"a": tuple((ways + np.array(start.position)).tolist())})
        steps = parse_plan("".join(f"{line}\n" for line in lines), Path("plan"), learned, task)
        assert len(steps) == len(lines)
        checked = validate(steps, task, learned)
        assert checked.valid, checked.reason
        used |= {line.split()[0] for line in lines}
    assert used == {"(push", "(lift", "(put-down"}


@pytest.mark.parametrize("cell", [0.005, 0.15])
def test_both_encodings_offer_the_same_motions_whatever_the_cells(cell: float):
    task, learned = problem(), replace(grounding(), cell=cell)
    page, numeric = (
        sorted(re.findall(r"\((pushes|lifts|lowers) (\S+) ([^\s)]+)", problem_text(task, learned, name)))
        for name in ("strips", "numeric")
    )
    told = [
        (verb, f"{motion}-down-{thing}" if verb == "lowers" else thing, f"{motion}-{thing}")
        for verb, thing, motion in page
    ]
    assert numeric == sorted(told)
    assert len(numeric) == len(learned.live) + sum(verb == "lowers" for verb, *_ in page)
