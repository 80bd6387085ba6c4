"""The grid: anchored starts, shifts inside the table, and goal regions that keep their promise."""

import math

import numpy as np
import pytest
from msgspec.structs import replace
from tables import grounding, item, mode, table

from neurosym.data.cells import Step
from neurosym.grounding import Grounding, at_rest, is_lift
from neurosym.operators import Operator, OperatorTable, Primitive
from neurosym.pddl import compile_domain
from neurosym.pddl.grid import GoalRegion, anchor, goal_region, grid_of, rounding
from neurosym.problems import Problem
from neurosym.tasks.options import PUT_DOWN, as_moves
from neurosym.tasks.transition import PlanStep, validate
from neurosym.world import Table

BLOCK = item("item-01", 0.4512, 0.0133)


def test_grid_covers_the_table_and_starts_are_in_the_nearest_cell():
    grid = grid_of(grounding())
    assert [cells.count for cells in grid] == [121, 121, 42]
    assert anchor(grid, BLOCK.position) == (30, 63, 0)
    assert anchor(grid_of(grounding(0.007)), (0.9, 0.3, 0.02)) == (85, 85, 0)
    names = grid[0].names
    assert (names[0], names[-1], list(names)) == ("x000", "x120", sorted(names))


@pytest.mark.parametrize(("cells", "margin"), [(7, 0), (-7, 0), (7, 2), (-7, 2), (130, 0)])
def test_shifts_are_all_pairs_that_end_on_the_table(cells: int, margin: int):
    pairs = grid_of(grounding())[0].leads(Step(cells), margin)
    naive = [(a, a + cells) for a in range(121) if margin <= a + cells <= 120 - margin]
    assert list(pairs) == naive


def any_grounding(rng: np.random.Generator) -> Grounding:
    """Pushes and lifts of random displacements on a wide table, with cells of a random size."""
    modes = [mode((*map(float, rng.uniform(-0.1, 0.1, 2)), 0.0)) for _ in range(3)]
    for _ in range(3):
        effect = (*map(float, rng.uniform(-0.1, 0.1, 2)), float(rng.uniform(0.19, 0.21)))
        resting = (*map(float, rng.uniform(-0.1, 0.1, 2)), 0.0003)
        modes.append(mode(effect, kind="held", resting=resting))
    operators = tuple(Operator(f"do-{n}", "00", f"{n:03b}", 20, (m,)) for n, m in enumerate(modes))
    primitives = tuple(Primitive(operator.primitive, (0.0,) * 12, 0.0) for operator in operators)
    wide = OperatorTable(table().categories, primitives, operators)
    cell = float(rng.uniform(0.002, 0.01))
    bounds = Table((0.0, 4.0), (-2.0, 2.0))
    return compile_domain(wide, name="any", cell=cell, table_bounds=bounds, lift_height=0.2)


def any_plan(learned: Grounding, rng: np.random.Generator, length: int) -> list[PlanStep]:
    """Draw so many primitives; a lift is put down again, unless it is the last and a coin says no."""
    steps = []
    for number in range(length):
        operator = learned.live[rng.integers(len(learned.live))]
        steps.append(PlanStep(operator.name, "item-01"))
        if is_lift(operator) and (number < length - 1 or rng.random() < 0.5):
            steps.append(PlanStep(PUT_DOWN + operator.name, "item-01"))
    return steps


def most_rounded(steps: list[PlanStep], learned: Grounding) -> np.ndarray:
    """Add up the remainders of the steps, each lift with its put-down counted once, at rest."""
    total = np.zeros(3)
    for step, then in zip(steps, [*steps[1:], None], strict=True):
        if step.puts_down:
            continue
        operator = learned.operator_named(step.operator)
        assert operator.promise is not None
        is_put_down = then is not None and then.puts_down
        exact = np.array(at_rest(operator.promise) if is_put_down else learned.displacement(operator))
        total += np.abs(exact - learned.cell * np.floor(np.abs(exact) / learned.cell + 0.5) * np.sign(exact))
    return total


def test_plan_into_the_region_ends_within_the_tolerance_whatever_is_rounded():
    """The bound that docs/pddl.md proves, on random displacements, cells, starts, goals and plans."""
    rng, tried, apart = np.random.default_rng(0), 0, 0.0
    for _ in range(100):
        learned, length = any_grounding(rng), int(rng.integers(1, 9))
        start = item("item-01", *rng.uniform([1.5, -0.5], [2.5, 0.5]).tolist())
        steps = any_plan(learned, rng, length)
        end = validate(steps, Problem("p", (start,), {}), learned).positions[-1, 0]
        goal = tuple((end + rng.uniform(-0.05, 0.05, 3) * rng.choice([0.1, 1.0], 3)).tolist())
        region = goal_region(start, goal, 0.05, learned, steps=length)
        moves = {move.name: np.array(move.cells) for move in as_moves(learned.live, learned)}
        grid = grid_of(learned)
        cells = np.array(anchor(grid, start.position)) + sum(moves[step.operator] for step in steps)
        in_cells = np.array(start.position) + (cells - anchor(grid, start.position)) * learned.cell
        assert np.all(np.abs(end - in_cells) <= most_rounded(steps, learned) + 1e-9)
        if region.zone.get(tuple(cells[:2]), 0) in region.zones_at(cells[2]) and len(region.zone) > 1:
            tried += 1
            apart = max(apart, math.dist(in_cells[:2], end[:2]))
            assert validate(steps, Problem("p", (start,), {"item-01": goal}), learned).valid
    assert tried > 20
    assert apart > 0.01  # rounding did add up to more than a cell


def test_every_cell_of_a_region_is_near_enough_even_if_every_step_rounds_the_wrong_way():
    rng, cells = np.random.default_rng(1), 0
    for _ in range(40):
        learned, steps = any_grounding(rng), int(rng.integers(1, 5))
        goal = (*map(float, rng.uniform(0.4, 0.6, 2)), float(rng.choice([0.0, 0.2])) + 0.025)
        goal = (goal[0], goal[1], goal[2] + float(rng.uniform(0.0, 0.02)))
        region, grid = goal_region(BLOCK, goal, 0.05, learned, steps=steps), grid_of(learned)
        begin, error = np.array(anchor(grid, BLOCK.position)), np.array(rounding(BLOCK, learned))
        for z in region.heights if len(region.zone) > 1 else ():
            errs, zones = error * [steps, steps, z > 0], region.zones_at(z)
            spots = np.array([(*xy, z) for xy, zone in region.zone.items() if zone in zones]).reshape(-1, 3)
            off = np.abs(np.array(BLOCK.position) + (spots - begin) * learned.cell - goal) + errs
            assert np.all(np.linalg.norm(off, axis=1) <= 0.05 + 1e-9)
            cells += len(spots)
    assert cells > 1000


def test_more_steps_shrink_the_region_and_none_is_the_whole_disc():
    learned, goal = grounding(), (0.5, 0.05, 0.025)
    sizes = [len(goal_region(BLOCK, goal, 0.05, learned, steps=steps).zone) for steps in (0, 3, 10, 1000)]
    assert sizes == sorted(sizes, reverse=True)
    assert sizes[0] == sum(
        math.hypot(x * 0.005 - 0.0488, y * 0.005 - 0.0367) <= 0.05
        for x in range(-30, 30)
        for y in range(-30, 30)
    )
    assert sizes[-1] == 1  # the goal's own cell is always left


def test_goal_in_the_air_takes_every_height_that_lifts_end_at_over_its_own_disc():
    def heights(*lifts: float) -> GoalRegion:
        modes = (mode((0.0, 0.0, height), kind="held", resting=(0.05, 0.0, 0.0)) for height in lifts)
        operators = tuple(Operator(f"lift-{n}", "00", f"{n:03b}", 20, (m,)) for n, m in enumerate(modes))
        learned = replace(grounding(), objects=replace(table(), operators=operators))
        return goal_region(BLOCK, (0.5, 0.05, 0.025 + 0.2), 0.05, learned, steps=1)

    assert heights(0.2, 0.22).heights == (40, 44)
    both, near = heights(0.2, 0.24), heights(0.2)
    assert (both.heights, both.zones_at(40), both.zones_at(48), both.zones_at(0)) == (
        (40, 48),
        [1, 2],
        [2],
        [],
    )
    assert both.zone.keys() == near.zone.keys()  # what is far takes nothing of what is near
    assert goal_region(BLOCK, (0.5, 0.05, 0.225), 0.05, grounding(), steps=3).heights == (41,)
    assert goal_region(BLOCK, (0.5, 0.05, 0.125), 0.05, grounding(), steps=3).heights == ()
    tray = item("item-02", 0.6, -0.1, category="11", height=0.04)  # which nothing lifts
    assert goal_region(tray, (0.6, -0.1, 0.22), 0.05, grounding(), steps=3).heights == ()
