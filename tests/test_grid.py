"""The grid: anchored starts, shifts inside the table, and goal regions that keep their promise."""

import itertools
import math

import msgspec
import numpy as np
import pytest
from tables import grounding, item

from neurosym.errors import InvalidValue
from neurosym.pddl.grid import goal_region, grid_of

BLOCK = item("item-01", 0.4512, 0.0133)


def test_grid_covers_the_table_and_the_highest_lift():
    assert grid_of(grounding()).last == (120, 120, 41)


def test_start_is_in_the_nearest_cell():
    assert grid_of(grounding()).anchor(BLOCK.position) == (30, 63, 0)


def test_start_at_the_far_edge_is_in_the_last_cell():
    assert grid_of(grounding(0.007)).anchor((0.9, 0.3, 0.02)) == (85, 85, 0)


def test_names_of_cells_sort_like_their_indices():
    names = grid_of(grounding()).cell_names(0)
    assert list(names) == sorted(names)
    assert (names[0], names[-1]) == ("x000", "x120")


@pytest.mark.parametrize(("cells", "margin"), [(7, 0), (-7, 0), (7, 2), (-7, 2), (130, 0)])
def test_shifts_are_all_pairs_that_end_on_the_table(cells: int, margin: int):
    pairs = grid_of(grounding()).shifts(0, cells, margin)
    naive = [(a, a + cells) for a in range(121) if margin <= a + cells <= 120 - margin]
    assert list(pairs) == naive


def test_plan_into_the_region_ends_within_the_tolerance():
    """Every combination of three live operators that ends in a goal cell really ends near enough."""
    learned, rng, tried = grounding(), np.random.default_rng(0), 0
    grid = grid_of(learned)
    anchor = np.array(grid.anchor(BLOCK.position))
    live = [operator for operator in learned.live if operator.category == "00"]
    for _ in range(60):
        goal = np.array(BLOCK.position) + rng.uniform([-0.05, -0.1, 0], [0.25, 0.25, 0.2]) * [
            1,
            1,
            rng.random() < 0.3,
        ]
        region = goal_region(BLOCK, tuple(goal), 0.05, learned, steps=3)
        for plan in itertools.product(live, repeat=3):
            last = plan[-1]
            downs = [
                np.array(learned.put_down_displacement(o)) for o in plan[:-1] if o.name.startswith("lift")
            ]
            exact = sum(np.array(learned.displacement(o)) for o in plan) + sum(downs, np.zeros(3))
            down_cells = [np.array(learned.put_down_cells(o)) for o in plan[:-1] if o.name.startswith("lift")]
            cells = (
                anchor
                + sum(np.array(learned.cells(o)) for o in plan)
                + sum(down_cells, np.zeros(3, dtype=int))
            )
            if (cells[0], cells[1]) in region.xy and cells[2] in region.z:
                tried += 1
                assert math.dist(exact + BLOCK.position, goal) <= 0.05, (last.name, goal)
    assert tried > 20


def test_more_steps_shrink_the_region_and_none_is_the_whole_disc():
    learned, goal = grounding(), (0.5, 0.05, 0.025)
    sizes = [len(goal_region(BLOCK, goal, 0.05, learned, steps=steps).xy) for steps in (0, 3, 10, 1000)]
    assert sizes == sorted(sizes, reverse=True)
    assert sizes[0] == sum(
        math.hypot(x * 0.005 - 0.0488, y * 0.005 - 0.0367) <= 0.05
        for x in range(-30, 30)
        for y in range(-30, 30)
    )
    assert sizes[-1] == 1  # the goal's own cell is always left


def test_goal_in_the_air_asks_for_the_height_of_the_lift():
    region = goal_region(BLOCK, (0.5, 0.05, 0.225), 0.05, grounding(), steps=3)
    assert 41 in region.z
    assert 0 not in region.z


def test_goal_at_a_height_that_nothing_reaches_has_no_region():
    assert goal_region(BLOCK, (0.5, 0.05, 0.125), 0.05, grounding(), steps=3).z == ()


def test_tray_that_nothing_lifts_has_no_goal_in_the_air():
    tray = item("item-02", 0.6, -0.1, category="11", height=0.04)
    assert goal_region(tray, (0.6, -0.1, 0.22), 0.05, grounding(), steps=3).z == ()


def test_object_off_the_table_is_refused_with_the_valid_ranges():
    astray = msgspec.structs.replace(BLOCK, position=(0.95, 0.0, 0.025))
    with pytest.raises(InvalidValue, match=r"item-01 stands at x = 0.950.*x 0.3 to 0.9"):
        goal_region(astray, (0.5, 0.05, 0.025), 0.05, grounding(), steps=3)
