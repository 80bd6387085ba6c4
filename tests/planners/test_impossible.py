"""What is proved to be impossible is, with its reason; what was only not found is never said to be."""

import itertools
from pathlib import Path

import numpy as np
import pytest
import tables
import toy_domain
from msgspec.structs import replace

from neurosym.errors import InvalidValue
from neurosym.grounding import FORMATS, Grounding
from neurosym.operators import Mode, Operator
from neurosym.planners import PlanStatus, plan
from neurosym.planners.action_counts import DEPTH, Choices, plan_counting
from neurosym.planners.no_plan import _Reach, explain_no_plan
from neurosym.problems import Problem, SceneObject
from neurosym.tasks.transition import PlanStep, validate


def choices(moves: list[tuple[float, float, float]], lifts: int = 0) -> Choices:
    """Return moves from (0.6, 0, 0), the last of which are lifts by 20 cm."""
    settled = np.array(moves, dtype=float).reshape(-1, 3)
    held = np.arange(len(moves)) >= len(moves) - lifts
    lifted = settled + np.outer(held, [0.0, 0.0, 0.2])
    room = np.array([[0.3, -0.3], [0.9, 0.3]])
    return Choices(settled, lifted, held, np.ones(len(moves), dtype=int), np.array([0.6, 0.0, 0.0]), room)


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
    table = replace(learned.objects, operators=tuple(operators))
    return replace(learned, objects=table, format=FORMATS[0])  # keep alike ones


def cube(goal: tuple[float, float, float], tolerance: float = 0.02) -> Problem:
    item = SceneObject("item-01", "00", (0.05, 0.05, 0.05, 0.0), (0.6, 0.0, 0.025))
    return Problem("p", (item,), {"item-01": goal}, tolerance=tolerance)


def test_a_proof_never_speaks_against_sums_of_moves():
    rng = np.random.default_rng(3)
    for _ in range(300):
        kinds = int(rng.integers(1, 9))
        drawn = choices([tuple(row) for row in rng.normal(0.0, 0.05, (kinds, 3))], lifts=int(rng.integers(2)))
        end = drawn.start + rng.integers(0, 30, kinds) @ drawn.settled
        last = int(rng.integers(kinds))
        goal = end + (drawn.lifted[last] if drawn.held[last] else 0.0) + rng.uniform(-0.01, 0.01, 3)
        known = _Reach("item-01", drawn, (*map(float, goal),), 0.02)
        assert not (known.must_be_held() and known.must_rest())


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
    learned = many_moves(490)  # hundreds of moves are counted as far as they go
    found = plan(cube((0.62, 0.0, 0.025), tolerance=0.005), learned, "counting")
    assert (found.status, len(found.steps)) == (PlanStatus.SOLVED, 2)
    far = plan(cube((0.8, 0.0, 0.025)), learned, "counting")
    assert far.status is PlanStatus.NOT_FOUND
    assert "by up to 2 primitives (120,786 combinations looked at)" in far.reason


@pytest.mark.parametrize("planner", ["bfs-operators", "counting"])
def test_bystander_on_the_goal_that_could_be_moved_proves_nothing(planner: str):
    wide = replace(tables.item("item-02", 0.68, 0.0), features=(0.2, 0.2, 0.05, 0.0))
    task = Problem("p", (tables.item("item-01", 0.45, 0.0), wide), {"item-01": (0.68, 0.0, 0.025)})
    found = plan(task, tables.grounding(), planner)
    assert found.status is PlanStatus.NOT_FOUND, found.steps
    assert "item-02" in found.reason
    assert "cannot" not in found.reason


def crammed() -> Problem:
    """Two wide blocks that shall come to one place."""
    items = [
        replace(tables.item(name, 0.45, y), features=(0.16, 0.16, 0.05, 0.0))
        for name, y in (("item-01", -0.15), ("item-02", 0.05))
    ]
    return Problem("p", tuple(items), {item.name: (0.6, 0.1, 0.025) for item in items})


def beside_a_stone() -> tuple[Problem, Grounding]:
    """Nothing is known to be done to the second object, and it stands right where the first is to end."""
    learned = tables.grounding()
    stone = replace(learned.objects.categories[0], symbol="01", name="stone")
    table = replace(learned.objects, categories=(*learned.objects.categories, stone))
    wide = replace(tables.item("item-02", 0.6, 0.0, category="01"), features=(0.2, 0.2, 0.05, 0.0))
    task = Problem("p", (tables.item("item-01", 0.4, 0.0), wide), {"item-01": (0.6, 0.0, 0.025)})
    return task, replace(learned, objects=table)


BLOCK = tables.item("item-01", 0.5, 0.0)
AIR = {"item-01": (0.6, 0.0, 0.225), "item-02": (0.8, 0.1, 0.225)}
DEEP = Problem("p", (BLOCK,), {"item-01": (0.85, 0.0, 0.025)}, tolerance=0.06)
OUT_OF_REACH = "up to 8 primitives bring it to 150 mm from it, 50 mm are allowed"
OUTSIDE = Problem("p", (BLOCK,), {"item-01": (0.6, 0.36, 0.025)})


@pytest.mark.parametrize("planner", ["bfs", "bfs-operators", "counting", "fast-downward"])
@pytest.mark.parametrize(
    ("task", "learned", "said"),
    [
        (Problem("p", (BLOCK,), {"item-01": (0.35, 0.0, 0.025)}), tables.grounding(), OUT_OF_REACH),
        (OUTSIDE, tables.grounding(), "item-01 cannot reach its goal without leaving the table"),
        (toy_domain.problem(AIR), toy_domain.grounding(), "held at the end, and there is one hand"),
        (crammed(), tables.grounding(), "no room for both item-01 and item-02"),
        (*beside_a_stone(), "item-02 stands where item-01 is to end, and no primitive moves it"),
    ],
    ids=["out of reach", "off the table", "two hands", "no room", "immovable"],
)
def test_what_is_proved_to_be_impossible_is_said_to_be_so(task, learned, said: str, planner: str):
    found = plan(task, learned, planner)
    assert found.status is PlanStatus.UNSOLVABLE
    assert said in found.reason


def test_goals_too_deep_for_the_planner_say_how_deep_they_are():
    deep = "too deep: item-01 6 primitives away from the goal, and only 3 are looked at"
    assert plan(DEEP, tables.grounding(), "bfs").reason == deep
    assert plan(DEEP, tables.grounding(), "counting").status is PlanStatus.SOLVED
    together = "too deep: each goal can be reached alone, but together they take 4 primitives ("
    assert plan(tables.problem(), tables.grounding(), "bfs").reason.startswith(together)
    assert explain_no_plan(tables.problem(), tables.grounding()) == ("", False)


def test_looking_for_room_where_there_is_none_ends_in_time():
    """The shipped domain knows thousands of ways to each of the goals."""
    learned = Grounding.load(Path("domains/tabletop/grounding.json"))
    items = tuple(replace(item, category="11") for item in crammed().objects)
    task = replace(crammed(), objects=items)
    assert plan_counting(task, learned, time_limit=0.5).status is PlanStatus.TIMEOUT


def test_nearest_is_the_nearest_of_all_sequences():
    learned, goal = toy_domain.grounding(), (0.72, -0.1, 0.12)
    item = replace(toy_domain.problem({}).objects[0])
    task = Problem("p", (item,), {"item-01": goal})
    found = plan_counting(task, learned, goes_near=True)
    assert found.status is PlanStatus.NEAREST
    names, distances = [one.name for one in learned.live], []
    for length in range(4):
        for names_tried in itertools.product(names, repeat=length):
            steps = [PlanStep(name, "item-01") for name in names_tried]
            checked = validate(steps, task, learned)
            if checked.possible:
                distances.append(checked.positions[-1][0])
    best = min(float(np.linalg.norm(np.array(goal) - place)) for place in distances)
    end = validate(found.steps, task, learned).positions[-1][0]
    assert float(np.linalg.norm(end - goal)) == pytest.approx(best, abs=0.005)
    assert found.reason.startswith(f"at the end, item-01 {best * 1000:.0f} mm from its goal; up to 8")
    assert len(found.steps) <= DEPTH


def test_nearest_meets_the_other_goals_and_holds_one_object_only():
    task = toy_domain.problem({"item-01": (0.6, 0.0, 0.225), "item-02": (0.8, 0.18, 0.225)})
    found = plan_counting(task, toy_domain.grounding(), goes_near=True)
    checked = validate(found.steps, task, toy_domain.grounding())
    assert (found.status, checked.possible) == (PlanStatus.NEAREST, True)
    assert sorted(task.distances(checked.positions[-1]).values()) == pytest.approx([0.0, 0.2])
    met = plan_counting(tables.problem(), tables.grounding(), goes_near=True)
    assert met.status is PlanStatus.SOLVED


@pytest.mark.parametrize("planner", ["bfs", "counting", "fast-downward"])
def test_object_that_was_pushed_a_little_off_the_table_is_brought_back(planner: str):
    trays = tuple(tables.item(f"item-0{n}", x, 0.2, category="11") for n, x in ((1, 0.95), (2, 0.5)))
    task = Problem("p", trays, {"item-01": (0.84, 0.11, 0.025)})
    found = plan(task, tables.grounding(), planner)
    assert found.status is PlanStatus.SOLVED, found.reason
    assert validate(found.steps, task, tables.grounding()).valid
    outwards = replace(task, goals={"item-02": (0.95, 0.2, 0.025)})
    assert plan(outwards, tables.grounding(), planner).status is PlanStatus.UNSOLVABLE
    far = replace(task, objects=(tables.item("item-01", 1.05, 0.2, category="11"),))
    with pytest.raises(InvalidValue, match="off the table"):
        plan(far, tables.grounding(), planner)
