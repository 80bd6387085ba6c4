"""What is proved to be impossible is; and what was only not found is never said to be impossible."""

import msgspec
import numpy as np
import pytest
import tables
import toy_domain

from neurosym.grounding import FORMATS, Grounding
from neurosym.operators import Mode, Operator
from neurosym.planners import PlanStatus, plan
from neurosym.planners.action_counts import MOST_VECTORS, Choices, choices_of, looked_at
from neurosym.planners.no_plan import _Reach
from neurosym.problems import Problem, SceneObject
from neurosym.tasks.transition import validate

SEARCHES = ["bfs", "bfs-operators", "counting", "fast-downward"]


def choices(moves: list[tuple[float, float, float]], lifts: int = 0) -> Choices:
    """Return moves from (0.6, 0, 0), the last of which are lifts by 20 cm."""
    settled = np.array(moves, dtype=float).reshape(-1, 3)
    held = np.arange(len(moves)) >= len(moves) - lifts
    lifted = settled + np.outer(held, [0.0, 0.0, 0.2])
    room = np.array([[0.3, -0.3], [0.9, 0.3]])
    return Choices(settled, lifted, held, np.ones(len(moves), dtype=int), np.array([0.6, 0.0, 0.0]), room)


def reach(drawn: Choices, goal: tuple[float, float, float], tolerance: float) -> _Reach:
    return _Reach("item-01", drawn, goal, tolerance)


def many_moves(count: int, length: float = 0.01) -> Grounding:
    """Return a domain in which a cube can be pushed into so many directions, a little way."""
    learned = toy_domain.grounding()
    operators = []
    for number, angle in enumerate(np.linspace(0, 2 * np.pi, count, endpoint=False)):
        effect = (float(length * np.cos(angle)), float(length * np.sin(angle)), 0.0)
        nothing = (0.0, 0.0, 0.0)
        mode = Mode("resting", 20, 1.0, effect, nothing, effect, nothing, 0.0, 20)
        symbol = f"{number:010b}"
        operators.append(Operator(f"push-{symbol}-cube", "00", symbol, 20, (mode,)))
    table = msgspec.structs.replace(learned.operators, operators=tuple(operators))
    return msgspec.structs.replace(learned, operators=table, format=FORMATS[0])  # keep alike ones


def cube(goal: tuple[float, float, float], tolerance: float = 0.02) -> Problem:
    item = SceneObject("item-01", "00", (0.05, 0.05, 0.05, 0.0), (0.6, 0.0, 0.025))
    return Problem("p", (item,), {"item-01": goal}, tolerance=tolerance)


def test_goal_behind_all_moves_is_proved_to_be_out_of_reach():
    forward = choices([(0.08, 0.0, 0.0), (0.05, 0.05, 0.0), (0.0, 0.0, 0.0)])
    assert reach(forward, (0.5, 0.0, 0.0), 0.05).is_out_of_reach()
    assert reach(forward, (0.8, -0.06, 0.0), 0.05).is_out_of_reach()
    assert not reach(forward, (0.8, 0.1, 0.0), 0.05).is_out_of_reach()
    assert reach(choices([]), (0.7, 0.0, 0.0), 0.05).is_out_of_reach()
    assert not reach(choices([]), (0.64, 0.0, 0.0), 0.05).is_out_of_reach()


def test_goal_in_the_air_is_out_of_reach_at_rest_only():
    lifting = choices([(0.08, 0.0, 0.0), (0.0, 0.0, 0.0)], lifts=1)
    assert not reach(lifting, (0.7, 0.0, 0.2), 0.05).is_out_of_reach()
    assert reach(lifting, (0.7, 0.0, 0.2), 0.05).is_out_of_reach(at_rest=True)


def test_a_proof_never_speaks_against_sums_of_moves():
    rng = np.random.default_rng(3)
    for _ in range(300):
        kinds = int(rng.integers(1, 9))
        drawn = choices([tuple(row) for row in rng.normal(0.0, 0.05, (kinds, 3))], lifts=int(rng.integers(2)))
        end = drawn.start + rng.integers(0, 30, kinds) @ drawn.settled
        last = int(rng.integers(kinds))
        goal = end + (drawn.lifted[last] if drawn.held[last] else 0.0) + rng.uniform(-0.01, 0.01, 3)
        assert not reach(drawn, (*map(float, goal),), 0.02).is_out_of_reach()


def test_goal_beyond_the_edge_is_off_the_table():
    assert reach(choices([]), (0.6, 0.36, 0.0), 0.05).is_off_table()
    assert not reach(choices([]), (0.6, 0.34, 0.0), 0.05).is_off_table()


def test_counting_that_was_cut_off_says_up_to_where_it_looked():
    """Six steps of 32 kinds are too many to be counted, and Fast Downward finds a plan of seven."""
    learned, task = many_moves(32, length=0.02), cube((0.74, 0.0, 0.025), tolerance=0.01)
    found = plan(task, learned, "fast-downward")
    assert found.status is PlanStatus.SOLVED, found.reason
    assert validate(found.steps, task, learned).valid
    counted = plan(task, learned, "counting")
    assert counted.status is PlanStatus.NOT_FOUND
    assert "item-01 was not brought to its goal by up to 5 primitives" in counted.reason
    assert "435,897 combinations looked at" in counted.reason
    assert "cannot" not in counted.reason


def test_hundreds_of_moves_are_counted_as_far_as_they_go():
    learned = many_moves(490)
    found = plan(cube((0.62, 0.0, 0.025), tolerance=0.005), learned, "counting")
    assert (found.status, len(found.steps)) == (PlanStatus.SOLVED, 2)
    far = plan(cube((0.8, 0.0, 0.025)), learned, "counting")
    assert far.status is PlanStatus.NOT_FOUND
    assert "by up to 2 primitives (120,786 combinations looked at)" in far.reason


def test_what_is_looked_at_is_as_much_as_is_said():
    task, learned = cube((0.7, 0.0, 0.025)), many_moves(5)
    (one,) = choices_of(task, learned)
    steps, vectors = looked_at(one)
    assert looked_at(one, 3) == (3, 1 + 5 + 15 + 35)
    assert vectors > MOST_VECTORS > 0
    assert steps < 60


@pytest.mark.parametrize("planner", SEARCHES)
def test_immovable_bystander_on_the_goal_is_named(planner: str):
    """Nothing is known to be done to the second object, and it stands right where the first is to end."""
    learned = tables.grounding()
    stone = msgspec.structs.replace(learned.operators.categories[0], symbol="01", name="stone")
    table = msgspec.structs.replace(learned.operators, categories=(*learned.operators.categories, stone))
    learned = msgspec.structs.replace(learned, operators=table)
    wide = msgspec.structs.replace(
        tables.item("item-02", 0.6, 0.0, category="01"), features=(0.2, 0.2, 0.05, 0.0)
    )
    task = Problem("p", (tables.item("item-01", 0.4, 0.0), wide), {"item-01": (0.6, 0.0, 0.025)})
    found = plan(task, learned, planner)
    assert found.status is PlanStatus.UNSOLVABLE
    assert found.reason == "item-02 stands where item-01 is to end, and no primitive moves it"


@pytest.mark.parametrize("planner", ["bfs-operators", "counting"])
def test_bystander_on_the_goal_that_could_be_moved_proves_nothing(planner: str):
    wide = msgspec.structs.replace(tables.item("item-02", 0.68, 0.0), features=(0.2, 0.2, 0.05, 0.0))
    task = Problem("p", (tables.item("item-01", 0.45, 0.0), wide), {"item-01": (0.68, 0.0, 0.025)})
    found = plan(task, tables.grounding(), planner)
    assert found.status is PlanStatus.NOT_FOUND, found.steps
    assert "item-02" in found.reason
    assert "cannot" not in found.reason


def test_breadth_first_search_puts_nothing_where_another_stands():
    """The first plan in its order would end in the bystander; another of the same length does not."""
    learned = toy_domain.grounding()
    items = tuple(
        SceneObject(name, "00", (0.05, 0.05, 0.05, 0.0), (x, y, 0.025))
        for name, x, y in (("item-01", 0.5, 0.0), ("item-02", 0.5, 0.08))
    )
    task = Problem("p", items, {"item-01": (0.58, 0.08, 0.025)}, tolerance=0.02)
    found = plan(task, learned, "bfs-operators")
    assert [step.operator for step in found.steps] == ["push-forward-010-cube", "push-left-001-cube"]
    assert validate(found.steps, task, learned).valid
