"""Breadth-first search: the world's rules, and agreement with a search that anyone can check."""

import itertools

import msgspec
import numpy as np
import pytest
from tables import BOUNDS, grounding, problem

from neurosym.planners import PlanStatus, plan
from neurosym.planners import bfs as bfs_module
from neurosym.planners.bfs import Branching, branching_of, plan_bfs, predicted_branching
from neurosym.problems import Problem, SceneObject
from neurosym.tasks.transition import PlanStep

State = tuple[np.ndarray, list[PlanStep]]


def naive(task: Problem, table: Branching, names, depth: int) -> list[PlanStep] | None:
    """Breadth-first search, one state at a time."""
    objects, primitives = table.held.shape
    if task.is_met(task.scene().positions):
        return []
    level: list[State] = [(task.scene().positions, [])]
    for _ in range(depth):
        following: list[State] = []
        for positions, steps in level:
            for thing, primitive in itertools.product(range(objects), range(primitives)):
                after = positions.copy()
                after[thing] += table.effects[thing, primitive]
                step = PlanStep(names[thing][primitive], task.object_names[thing])
                if not BOUNDS.contains(after[thing]):
                    continue
                if task.is_met(after):
                    return [*steps, step]
                if table.held[thing, primitive]:
                    after = positions.copy()
                    after[thing] += table.resting_effects[thing, primitive]
                    if not BOUNDS.contains(after[thing]):
                        continue
                    steps_down = [*steps, step, PlanStep(f"put-down-{step.operator}", step.object)]
                    if task.is_met(after):
                        return steps_down
                    following.append((after, steps_down))
                else:
                    following.append((after, [*steps, step]))
        level = following
    return None


def random_task(seed: int) -> tuple[Problem, Branching, tuple[tuple[str, ...], ...]]:
    rng = np.random.default_rng(seed)
    objects, primitives = int(rng.integers(1, 4)), int(rng.integers(2, 5))
    effects = rng.uniform(-0.15, 0.15, (objects, primitives, 3)) * [1, 1, 0]
    held = rng.random((objects, primitives)) < 0.3
    resting = effects + rng.normal(0, 0.01, effects.shape) * [1, 1, 0]
    effects[held, 2] = 0.2
    effects[rng.random((objects, primitives)) < 0.1] = np.nan
    starts = rng.uniform([0.35, -0.25, 0.02], [0.85, 0.25, 0.03], (objects, 3))
    ends = starts + rng.uniform(-0.2, 0.2, (objects, 3)) * [1, 1, 0]
    ends[0, 2] += 0.2 * (rng.random() < 0.3)
    items = tuple(
        SceneObject(f"item-{i}", "00", (0.05, 0.05, 0.05, 0.0), tuple(map(float, p)))
        for i, p in enumerate(starts)
    )
    goals = {
        item.name: tuple(map(float, end)) for item, end in zip(items, ends, strict=True) if rng.random() < 0.7
    }
    names = tuple(tuple(f"op-{p}-{i}" for p in range(primitives)) for i in range(objects))
    goals = goals or {"item-0": tuple(map(float, ends[0]))}
    return Problem("random", items, goals, tolerance=0.08), Branching(effects, resting, held, names)


@pytest.mark.parametrize("chunk", [4096, 5])
def test_search_finds_what_the_naive_one_finds(monkeypatch: pytest.MonkeyPatch, chunk: int):
    monkeypatch.setattr(bfs_module, "CHUNK", chunk)
    lengths = []
    for seed in range(50):
        task, table = random_task(seed)
        expected, found = naive(task, table, table.names, 3), plan_bfs(task, table, BOUNDS)
        assert (found.status is PlanStatus.SOLVED) == (expected is not None), seed
        assert list(found.steps) == (expected or []), seed
        lengths.append(len(found.steps))
    assert {0, 1, 2, 3} < set(lengths)  # the tasks are of all kinds, also with put-downs in between


def one_object(goal: tuple[float, float, float], effects, held=None, resting=None):
    item = SceneObject("item-01", "00", (0.05, 0.05, 0.05, 0.0), (0.6, 0.0, 0.02))
    effects = np.array([effects], dtype=float)
    table = Branching(
        effects,
        np.array([resting], dtype=float) if resting else effects,
        np.array([held]) if held else np.zeros(effects.shape[:2], dtype=bool),
        (tuple(f"op-{index}" for index in range(effects.shape[1])),),
    )
    return plan_bfs(Problem("p", (item,), {"item-01": goal}), table, BOUNDS)


def test_lift_is_put_down_before_the_next_primitive():
    lift, push = (0.0, 0.0, 0.2), (0.1, 0.0, 0.0)
    found = one_object((0.8, 0.0, 0.22), [lift, push], held=[True, False], resting=[(0.0, 0.0, 0.0), push])
    assert [step.operator for step in found.steps] == ["op-1", "op-1", "op-0"]


def test_put_down_ends_a_plan_when_the_goal_is_on_the_table_and_costs_no_depth():
    found = one_object((0.9, 0.0, 0.02), [(0.1, 0.0, 0.2)], held=[True], resting=[(0.1, 0.0, 0.0)])
    assert [step.operator for step in found.steps] == ["op-0", "put-down-op-0"] * 3


def test_nobody_leaves_the_table_on_the_way():
    assert one_object((0.6, 0.2, 0.02), [(0.0, 0.4, 0.0), (0.0, -0.2, 0.0)]).steps[0].operator == "op-1"


def test_search_that_is_exhausted_says_how_deep_it_went():
    found = one_object((0.6, 0.28, 0.02), [(0.0, 0.06, 0.0)])
    assert (found.status, found.reason) == (PlanStatus.NOT_FOUND, "3 primitives do not suffice")
    table = branching_of(problem(), grounding())
    assert plan_bfs(problem(), table, BOUNDS).status is PlanStatus.NOT_FOUND
    assert plan_bfs(problem(), table, BOUNDS, depth=4).status is PlanStatus.SOLVED


def test_time_out_is_a_result():
    table = branching_of(problem(), grounding())
    assert plan_bfs(problem(), table, BOUNDS, time_limit=0.0).status is PlanStatus.TIMEOUT


def test_operators_left_out_are_never_promised_but_may_be_predicted():
    table = branching_of(problem(), grounding())
    assert table.names == (
        ("push-left-000-block", "push-away-001-block", "lift-010-block"),
        ("push-left-000-tray", "pull-010-tray", ""),
    )
    assert np.isnan(table.effects[1, 2]).all()
    assert (table.usable(0), table.usable(1)) == ((0, 1, 2), (0, 1))
    assert table.held.tolist() == [[False, False, True], [False] * 3]
    predicted = predicted_branching(problem(), grounding(), np.full((2, 4, 3), 0.07))
    assert predicted.names[0][3] == "stay-111-block"
    assert np.all(predicted.effects == 0.07)
    assert predicted.resting_effects[0, 2].tolist() == [0.0141, -0.0228, 0.0]


def test_primitive_with_two_outcomes_is_two_choices_but_one_prediction():
    learned = grounding()
    lift = learned.operator_named("lift-010-block")
    slips = msgspec.structs.replace(lift, name="slip-010-block", modes=lift.modes[1:])
    slips = msgspec.structs.replace(
        slips, modes=(msgspec.structs.replace(slips.modes[0], resting_effect=(0.04, 0.0, 0.0), count=10),)
    )
    table = msgspec.structs.replace(learned.operators, operators=(*learned.operators.operators, slips))
    both = msgspec.structs.replace(learned, operators=table)
    branching = branching_of(problem(), both)
    assert branching.names[0][2:] == ("lift-010-block", "slip-010-block")
    assert branching.effects[0, 3].tolist() == [0.04, 0.0, 0.0]
    assert branching.held[0].tolist() == [False, False, True, False]
    predicted = predicted_branching(problem(), both, np.full((2, 4, 3), 0.07))
    assert predicted.names[0][2] == "lift-010-block"


def test_object_off_the_table_may_come_back_but_go_no_further():
    off = Problem(
        "p", (SceneObject("item-01", "00", (0.05,) * 4, (0.93, 0.0, 0.02)),), {"item-01": (0.8, 0.0, 0.02)}
    )
    for step, status in ((-0.1, PlanStatus.SOLVED), (0.01, PlanStatus.NOT_FOUND)):
        effects = np.array([[(step, 0.0, 0.0), (0.01, -0.01, 0.0)]])
        table = Branching(effects, effects, np.zeros((1, 2), dtype=bool), (("op", "out"),))
        assert plan_bfs(off, table, BOUNDS).status is status


def far_away(primitives: int, objects: int = 1) -> tuple[Problem, Branching]:
    """A goal that no three of so many short pushes reach."""
    items = tuple(
        SceneObject(f"item-{n}", "00", (0.02,) * 4, (0.4, 0.05 * n - 0.2, 0.02)) for n in range(objects)
    )
    effects = np.tile([0.01, 0.0, 0.0], (objects, primitives, 1))
    names = tuple(tuple(f"op-{p}-{n}" for p in range(primitives)) for n in range(objects))
    held = np.zeros((objects, primitives), dtype=bool)
    return Problem("far", items, {"item-0": (0.8, -0.2, 0.02)}), Branching(effects, effects, held, names)


@pytest.mark.parametrize(
    ("primitives", "objects", "depth"),
    [(8, 4, 3), (8, 16, 3), (64, 1, 3), (64, 2, 3), (32, 4, 3), (64, 4, 2), (256, 4, 2), (256, 8, 1)],
)
def test_search_goes_as_deep_as_the_number_of_sequences_allows(primitives, objects, depth):
    _, table = far_away(primitives, objects)
    assert bfs_module.depth_within(table) == depth
    assert (bfs_module.why_not_deeper(table) == "") == (depth == 3)


def test_search_that_is_cut_short_says_at_which_depth_and_why():
    found = plan_bfs(*far_away(64, 4), BOUNDS)
    said = "2 primitives do not suffice; 3 would be 16,777,216 sequences, more than 2,500,000"
    assert (found.status, found.reason, found.depth) == (PlanStatus.NOT_FOUND, said, 2)


def test_search_looks_one_primitive_ahead_however_many_there_are(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr(bfs_module, "MOST_SEQUENCES", 3)
    found = plan_bfs(*far_away(5), BOUNDS)
    assert found.reason == "1 primitive does not suffice; 2 would be 25 sequences, more than 3"
    task, table = far_away(5)
    near = msgspec.structs.replace(task, goals={"item-0": (0.45, -0.2, 0.02)}, tolerance=0.041)
    assert [step.operator for step in plan_bfs(near, table, BOUNDS).steps] == ["op-0-0"]


@pytest.mark.parametrize("name", ["bfs", "bfs-operators"])
def test_both_planners_say_that_they_were_cut_short(monkeypatch: pytest.MonkeyPatch, name: str):
    monkeypatch.setattr(bfs_module, "MOST_SEQUENCES", 10)
    predict = (lambda _: predicted_effects()) if name == "bfs" else None
    found = plan(problem(), grounding(), name, predict=predict)
    assert found.status is PlanStatus.NOT_FOUND
    assert "only 1 is looked at; 2 would be " in found.reason
    assert " sequences, more than 10" in found.reason


def predicted_effects() -> np.ndarray:
    """What the network would predict if it knew what the operators promise."""
    learned = grounding()
    table = learned.operators
    effects = np.full((2, len(table.primitives), 3), np.nan)
    for row, item in enumerate(problem().objects):
        for column, primitive in enumerate(table.primitives):
            operator = learned.operator_for(item.category, primitive.symbol)
            effects[row, column] = learned.displacement(operator) if operator in learned.live else 0.0
    return effects
