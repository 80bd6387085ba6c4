"""How objects lie: the sizes that count, the side that one lies on, and what sets it upright."""

import math
from dataclasses import replace as replaced
from pathlib import Path

import msgspec
import numpy as np
import pytest
import tables
from places import ROOT
from validators import unified_planning_accepts

from neurosym.errors import InvalidValue
from neurosym.execution.executor import execute
from neurosym.execution.replanning import Experience
from neurosym.grounding import Grounding
from neurosym.operators import Operator, OperatorTable
from neurosym.pddl.compiler import domain_text, ground_plan, problem_text
from neurosym.pddl.plan_reading import parse_plan
from neurosym.planners import plan
from neurosym.primitives.ledger import Ledger
from neurosym.primitives.uprighting import find_uprighting
from neurosym.problems import Problem, SceneObject
from neurosym.tasks.conditions import unmet_conditions
from neurosym.tasks.goal_choice import with_goals
from neurosym.tasks.lying import SIDES, as_it_shows, as_planned, as_raised, lying, side_of
from neurosym.tasks.task import is_reached, understand
from neurosym.tasks.transition import PlanStep, validate
from neurosym.world import Outcome, Scene
from neurosym.worlds.toy import ToyWorld
from neurosym.worlds.world_file import read_world

PLACES = ROOT / "domains" / "places"
LEARNED = Grounding.load(PLACES / "grounding.json")
replace = msgspec.structs.replace
SIZES = (0.04, 0.1, 0.06)


def turned(degrees: float, axis: int = 2) -> SceneObject:
    half = math.radians(degrees) / 2
    turn = [0.0, 0.0, 0.0, math.cos(half)]
    turn[axis] = math.sin(half)
    return SceneObject("item-01", "01", (*SIZES, 0.0), (0.5, 0.0, 0.03), tuple(turn))


@pytest.mark.parametrize(
    ("degrees", "axis", "sizes"),
    [
        (0, 2, SIZES),
        (10, 2, SIZES),
        (90, 2, (0.1, 0.04, 0.06)),
        (-80, 2, (0.1, 0.04, 0.06)),
        (180, 2, SIZES),
        (90, 0, (0.04, 0.06, 0.1)),
        (45, 2, (0.14 * math.sqrt(0.5), 0.14 * math.sqrt(0.5), 0.06)),
    ],
)
def test_sizes_are_those_of_the_box_around_the_object(degrees: float, axis: int, sizes: tuple[float, ...]):
    shown = as_it_shows(turned(degrees, axis), tables.grounding())
    assert shown.features[:3] == pytest.approx(sizes, abs=1e-6)
    assert shown.features[3] == 0.0
    assert shown.category == "01"


@pytest.mark.parametrize("degrees", [0, 30, 90, 150])
def test_what_shows_its_sizes_shows_them_again(degrees: float):
    lies = Problem("lies", (turned(degrees, 0),), {"item-01": (0.6, 0.1, 0.03)})
    planned = as_planned(lies, LEARNED)
    assert as_planned(planned, LEARNED) == planned


def test_category_is_that_of_rehearsed_objects_of_such_sizes():
    wide, deep = (0.1, 0.04, 0.06, 0.0), (0.04, 0.1, 0.06, 0.0)
    kept = {"00": (deep,), "11": (wide,)}
    table = tables.table()
    categories = tuple(replace(one, objects=kept[one.symbol]) for one in table.categories)
    learned = replace(tables.grounding(), objects=replace(table, categories=categories))
    assert as_it_shows(turned(5), learned).category == "01"
    assert as_it_shows(turned(95), learned).category == "11"


@pytest.mark.parametrize(
    ("degrees", "axis", "top"),
    [(90, 1, "forward"), (-90, 1, "back"), (-90, 0, "left"), (90, 0, "right"), (20, 0, None), (180, 0, "")],
)
def test_a_side_is_where_the_top_points(degrees: float, axis: int, top: str | None):
    side = side_of(np.array(turned(degrees, axis).orientation), turned=True)
    assert SIDES.get(side, "") == (top or "")
    assert bool(side) == (top is not None)


def fallen(*conditions: str, side: str = "10") -> Problem:
    """A plank that lies with its top to the left, and a box beside it."""
    axis, sign = {"00": (1, 1), "01": (1, -1), "10": (0, -1), "11": (0, 1)}[side]
    turn = [0.0, 0.0, 0.0, math.sqrt(0.5)]
    turn[axis] = sign * math.sqrt(0.5)
    sizes = (0.14, 0.05, 0.04)
    high = sizes[1] if axis == 0 else sizes[0]
    first = SceneObject("item-01", "01", (*sizes, 0.0), (0.55, 0.1, high / 2), tuple(turn))
    second = SceneObject("item-02", "01", (0.06, 0.06, 0.05, 0.0), (0.75, -0.2, 0.025))
    return Problem("fallen", (first, second), {}, conditions=conditions)


@pytest.mark.parametrize(
    ("side", "condition"),
    [
        *((side, "item-01 upright and item-01 at 0.6,-0.1") for side in ("00", "11")),
        ("00", "item-01 upright"),
    ],
)
def test_what_lies_is_set_upright_first_by_any_planner(side: str, condition: str, tmp_path: Path):
    asked = with_goals(fallen(condition, side=side), LEARNED)
    assert asked.upright == ("item-01",)
    result = plan(asked, LEARNED, "fast-downward")
    assert result.steps[0].operator == f"set-upright-{SIDES[side]}-{side}"
    assert validate(result.steps, asked, LEARNED).valid
    assert not validate(result.steps[1:], asked, LEARNED).valid
    printed = ground_plan(result.steps, asked, LEARNED)
    domain, task = tmp_path / "domain.pddl", tmp_path / "fallen.pddl"
    domain.write_text(domain_text(LEARNED))
    task.write_text(problem_text(asked, LEARNED, plans=[printed]))
    assert unified_planning_accepts(domain, task, printed.text)
    assert not unified_planning_accepts(domain, task, printed.text.partition("\n")[2])
    assert parse_plan(printed.text, tmp_path / "one.plan", LEARNED, asked) == result.steps


def test_in_the_simulator_it_stands_and_then_comes_to_its_place():
    asked = with_goals(fallen("item-01 upright and item-01 at 0.6,-0.1", side="00"), LEARNED)
    assert [*unmet_conditions(asked, LEARNED)] == [*asked.conditions]
    world = read_world(PLACES / "world.toml")()
    run = execute(
        world,
        asked,
        LEARNED,
        plan(asked, LEARNED).steps,
        replanner=lambda problem, learned: plan(problem, learned),
    )
    assert run.reached
    first = run.steps[0]
    assert (first.promised, first.happened) == ("resting", "resting")


@pytest.mark.parametrize("quarter", [0.0, 90.0, 200.0])
def test_what_will_stand_is_turned_the_shortest_way(quarter: float):
    lies, half = fallen(side="00"), math.radians(quarter) / 2
    (x, y, z, w), c, s = lies.objects[0].orientation, math.cos(half), math.sin(half)
    turn = (c * x - s * y, c * y + s * x, c * z + s * w, c * w - s * z)  # about the vertical, after it fell
    item = replace(lies.objects[0], orientation=turn)
    (stands, _) = as_raised(
        replace(lies, objects=(item, lies.objects[1]), upright=("item-01",)), LEARNED
    ).objects
    x, y, z, w = stands.orientation
    assert (x, y) == pytest.approx((0.0, 0.0), abs=1e-9)
    assert math.cos(2 * math.atan2(z, w) - 2 * half) == pytest.approx(1.0)
    assert stands.position[2] == pytest.approx(0.02)


def test_what_stands_is_not_set_upright():
    stands = replace(fallen("item-01 upright"), objects=fallen().objects[1:])
    asked = with_goals(replace(stands, conditions=("item-02 upright",)), LEARNED)
    assert lying(asked, LEARNED) == {}
    assert not [*unmet_conditions(asked, LEARNED)]
    step = PlanStep("set-upright-left-10", "item-02")
    assert validate([step], asked, LEARNED).reason.endswith("item-02 need not be set upright")


def test_what_lies_and_is_not_asked_counts_by_the_sizes_it_shows():
    asked = with_goals(fallen("item-02 at 0.5,-0.2"), LEARNED)
    task = understand(asked, LEARNED)
    assert task.problem.object_named("item-01").features[:3] == (0.14, 0.04, 0.05)
    assert "(rights" not in problem_text(asked, LEARNED)


def test_what_nothing_sets_upright_is_said():
    unknown = replace(LEARNED, upright=None)
    with pytest.raises(
        InvalidValue, match="Nothing that was learned sets item-01 upright as and where it lies"
    ):
        with_goals(fallen("item-01 upright"), unknown)
    result = plan(replace(fallen(), upright=("item-01",)), unknown)
    assert not result.has_plan
    assert result.reason == "nothing that was learned sets item-01 upright as and where it lies"


def moved(problem: Problem, **changes: object) -> Problem:
    """Return a problem whose first object is another one."""
    return replace(problem, objects=(replace(problem.objects[0], **changes), *problem.objects[1:]))


def test_it_is_promised_what_like_objects_did():
    flat, cube = (0.14, 0.05, 0.04, 0.0), (0.06, 0.06, 0.06, 0.0)
    sure, unsure = (
        lying(moved(replace(fallen(side="00"), upright=("item-01",)), features=sizes), LEARNED)["item-01"]
        for sizes in (flat, cube)
    )
    assert sure is not None
    assert sure.chance > 0.9
    asked = moved(replace(fallen(side="00"), upright=("item-01",)), features=flat)
    assert not is_reached(asked, LEARNED)
    assert is_reached(as_raised(asked, LEARNED), LEARNED)
    assert unsure is None


@pytest.mark.parametrize("spot", [(0.37, 0.1), (0.82, -0.2)])
def test_it_must_come_to_stand_on_the_table_and_in_nothing(spot: tuple[float, float]):
    asked = moved(fallen("item-01 upright", side="00"), position=(*spot, 0.03))
    with pytest.raises(InvalidValue, match="sets item-01 upright as and where it lies"):
        with_goals(asked, LEARNED)


def test_a_plan_in_short_names_what_sets_upright(tmp_path: Path):
    asked = with_goals(fallen("item-01 upright"), LEARNED)
    path, said = tmp_path / "short.plan", "(set-upright-{} {})\n"
    assert parse_plan(said.format("left-10", "item-01"), path, LEARNED, asked) == plan(asked, LEARNED).steps
    for step in (said.format("right-11", "item-01"), said.format("left-10", "item-02")):
        steps = parse_plan(step, path, LEARNED, asked)
        assert not validate(steps, asked, LEARNED).valid
    with pytest.raises(InvalidValue, match="item-02 need not be set upright"):
        ground_plan([PlanStep("set-upright-left-10", "item-02")], asked, LEARNED)


def test_what_hangs_on_the_hand_is_not_where_it_shall_be():
    asked = replace(fallen(), conditions=("item-02 at 0.75,-0.2",))
    assert not [*unmet_conditions(asked, LEARNED)]
    hangs = replace(asked.objects[1], position=(0.75, -0.2, 0.225))
    assert [*unmet_conditions(replace(asked, objects=(asked.objects[0], hangs)), LEARNED)] == [
        *asked.conditions
    ]


def test_of_some_those_are_set_upright_that_can_be():
    first, second = fallen(side="10").objects
    over = replace(second, orientation=(1.0, 0.0, 0.0, 0.0))
    asked = replace(fallen(), objects=(first, over), conditions=("1 of item-02,item-01 upright",))
    assert with_goals(asked, LEARNED).upright == ("item-01",)


class Falling(ToyWorld):
    """A world in which whatever is acted upon from above stands in the end."""

    def interact(self, scene: Scene, action: np.ndarray, target: int = 0, **_: object) -> Outcome:
        """Push, and set upright."""
        outcome = super().interact(Scene(scene.features, scene.positions, scene.orientations), action, target)
        lies = scene.orientations.copy()
        stands = np.tile([0.0, 0.0, 0.0, 1.0], (len(scene), 1))
        end = replaced(outcome.end, orientations=stands if action[2] > 0.01 else lies)
        return replaced(outcome, start=scene, end=end, held=False, lost=False)


def test_of_what_sets_things_upright_the_best_is_rehearsed_for_each_side():
    table: OperatorTable = find_uprighting(Falling, tries=40, objects=12, seed=3, ledger=Ledger())
    assert [one.subject for one in table.operators] == [*SIDES]
    operator: Operator = table.operators[0]
    assert (operator.trials, operator.promise and operator.promise.count) == (12, 12)
    assert all(one.action[2] > 0.01 for one in table.primitives)
    none = find_uprighting(ToyWorld, tries=8, objects=4, seed=3, ledger=Ledger())
    assert none.operators == ()


def test_what_does_not_come_to_stand_is_let_lie_after_two_failures():
    asked = with_goals(fallen("item-01 upright", side="00"), LEARNED)
    experience, (step,) = Experience(LEARNED), plan(asked, LEARNED).steps
    start = asked.scene()
    failed = Outcome(
        start=start, lifted=start, end=start, target=0, held=False, toppled=False, lost=False, peak_height=0.0
    )
    for upright in (("item-01",), ("item-01",), ()):
        assert experience.believed(asked).upright == upright
        experience.learn(step, failed)
    assert experience.hoping_again(asked).believed(asked).upright == ()
