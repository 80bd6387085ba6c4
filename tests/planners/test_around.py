"""Ways around each other; whoever is in the way goes first; and counting, cheapest among the fewest."""

import itertools
import math

import numpy as np
import pytest
import tables
from msgspec.structs import replace
from tables import grounding, item

from neurosym.grounding import Grounding
from neurosym.operators import Operator
from neurosym.planners import PlanStatus, plan
from neurosym.planners.action_counts import mend
from neurosym.planners.joined_plans import plan_around
from neurosym.planners.planner import TimeIsUp
from neurosym.problems import Problem
from neurosym.tasks.options import cost
from neurosym.tasks.transition import PlanStep, primitives, validate
from tools.benchmarks.planning.tasks import fewest_steps

STEP = 0.06


def learned() -> Grounding:
    """Let blocks be pushed in the four directions of a compass, by a little more than they are wide."""
    known = tables.grounding()
    ways = {"away": (STEP, 0.0), "back": (-STEP, 0.0), "left": (0.0, STEP), "right": (0.0, -STEP)}
    operators = tuple(
        Operator(f"push-{way}-{symbol}-block", "00", symbol, 20, (tables.mode((*by, 0.0)),))
        for (way, by), symbol in zip(ways.items(), ("000", "001", "010", "111"), strict=True)
    )
    return replace(known, objects=replace(known.objects, operators=operators))


def task(starts: dict[str, tuple[int, int]], goals: dict[str, tuple[int, int]]) -> Problem:
    """Put blocks on a board of squares of one step."""

    def place(square: tuple[int, int]) -> tuple[float, float]:
        return 0.45 + STEP * square[0], STEP * square[1]

    items = tuple(tables.item(name, *place(square)) for name, square in starts.items())
    wanted = {name: (*place(square), 0.025) for name, square in goals.items()}
    return Problem("board", items, wanted, tolerance=0.01)


@pytest.mark.parametrize("planner", ["fast-downward", "lama-first"])
def test_two_that_change_places_make_way_for_each_other(planner: str):
    swapped = task({"item-01": (0, 0), "item-02": (1, 0)}, {"item-01": (1, 0), "item-02": (0, 0)})
    found = plan_around(swapped, learned())
    assert found.status is PlanStatus.SOLVED
    assert validate(found.steps, swapped, learned()).valid
    assert 4 <= primitives(found.steps) <= 6  # one steps aside, and goes around the other
    assert validate(plan(swapped, learned(), planner).steps, swapped, learned()).valid


def test_ways_are_as_short_as_can_be_among_footprints():
    rng, walls = np.random.default_rng(0), 0
    for _ in range(12):
        squares = rng.permutation(list(itertools.product(range(5), range(-2, 3))))
        start, goal, *others = (tuple(map(int, square)) for square in squares[:10])
        starts = {"item-01": start, **{f"wall-{n}": square for n, square in enumerate(others)}}
        asked = task(starts, {"item-01": goal})
        found = plan_around(asked, learned())
        fewest = shortest(start, goal, set(others))
        walls += fewest > abs(start[0] - goal[0]) + abs(start[1] - goal[1])
        assert (primitives(found.steps) if found.has_plan else math.inf) == fewest
        assert not found.has_plan or validate(found.steps, asked, learned()).valid
    assert walls > 2


def shortest(start: tuple[int, int], goal: tuple[int, int], walls: set[tuple[int, int]]) -> float:
    """Count the steps by breadth-first search, on the squares that are on the table."""
    seen, edge, length = {start}, [start], 0
    while edge:
        if goal in edge:
            return length
        around = [(x + dx, y + dy) for x, y in edge for dx, dy in ((1, 0), (-1, 0), (0, 1), (0, -1))]
        edge = [one for one in dict.fromkeys(around) if one not in seen | walls and is_on_table(one)]
        seen.update(edge)
        length += 1
    return math.inf


def is_on_table(square: tuple[int, int]) -> bool:
    return -2 <= square[0] <= 7 and -5 <= square[1] <= 5


def test_it_ends_with_its_work_or_with_the_time():
    walled = task(
        {"item-01": (0, 0), **{f"wall-{n}": s for n, s in enumerate([(1, 0), (-1, 0), (0, 1), (0, -1)])}},
        {"item-01": (3, 0)},
    )
    found = plan_around(walled, learned())
    assert found.status is PlanStatus.NOT_FOUND
    assert "no ways around each other" in found.reason
    with pytest.raises(TimeIsUp):
        plan_around(walled, learned(), deadline=0.0)


def test_search_is_led_by_what_is_left_to_go():
    two = task({"item-01": (0, 0), "item-02": (3, 3)}, {"item-01": (5, 1), "item-02": (0, 4)})
    found = plan_around(two, learned())
    assert len(found.steps) == 10
    assert found.work < 400, "ten times as much where nothing leads it"


def test_long_row_is_moved_from_its_front():
    """Eight blocks in a row, named from behind: only one of the 40320 orders is possible."""
    row = tuple(item(f"item-{n}", 0.35 + 0.06 * n, 0.0) for n in range(8))
    goals = {thing.name: (thing.position[0] + 0.0713, -0.0124, 0.025) for thing in row}
    steps = [PlanStep("push-away-001-block", thing.name) for thing in row]
    ordered, checked = mend(steps, Problem("row", row, goals), grounding())
    assert checked.valid, checked.reason
    assert list(ordered) == steps[::-1]


def test_among_the_fewest_it_takes_the_cheapest():
    learned = tables.grounding()
    task = Problem("p", (tables.item("item-01", 0.45, 0.0),), {"item-01": (0.6, 0.13, 0.025)})
    found = plan(task, learned, "counting")
    names = [operator.name for operator in learned.live if operator.subject == "00"]

    def price(steps: tuple[str, ...]) -> int:
        return sum(cost(learned.operator_named(step)) for step in steps)

    def down(steps: tuple[str, ...]) -> tuple[PlanStep, ...]:
        pairs = ([step, f"put-down-{step}"] if step.startswith("lift") else [step] for step in steps)
        return tuple(PlanStep(one, "item-01") for pair in pairs for one in pair)

    every = itertools.combinations_with_replacement(names, primitives(found.steps))
    cheapest = min(price(steps) for steps in every if validate(down(steps), task, learned).valid)
    assert price(tuple(step.operator for step in found.steps if not step.puts_down)) == cheapest
    assert fewest_steps(task, learned) == primitives(found.steps)
