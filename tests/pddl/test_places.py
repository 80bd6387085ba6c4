"""Tasks with places: where those are, who may be carried there, and that plans for them come true."""

import math
import sys
from itertools import product
from pathlib import Path

import msgspec
import numpy as np
import pytest
import toy_domain
from msgspec.structs import replace
from toy_domain import WORLD
from toy_places import CUBE, NAME, OFFSET, grounding, mixed, scene, swap

from neurosym.errors import InvalidPlan, InvalidValue, NeurosymError
from neurosym.execution.executor import execute
from neurosym.execution.performance import compare_runs, rerun
from neurosym.pddl.plan_reading import parse_plan
from neurosym.pddl.problem_check import check_places, check_problem
from neurosym.planners import PlanStatus, plan
from neurosym.problems import Problem
from neurosym.tasks.task import ROOM, SHARE, footprints_apart, goal_spots, occupants, with_places
from neurosym.tasks.transition import PlanStep, validate
from neurosym.worlds.aims import Aimed

MODULE = sys.modules["neurosym.planners.pddl_search"]
"""The package has a function of that name, too."""


def solved(problem: Problem) -> tuple[PlanStep, ...]:
    result = plan(problem, grounding())
    assert result.status is PlanStatus.SOLVED, result.reason
    return result.steps


@pytest.mark.parametrize(
    ("problem", "names", "carried"),
    [
        (swap(), ["item-01", "item-02", "item-01"], [True] * 3),  # by way of a third place
        (mixed(), ["item-02", "item-02", "item-01"], [False, False, True]),  # pushed out of its place first
    ],
)
def test_plans_come_true_in_the_world_and_again_from_the_record(problem, names, carried):
    world, learned, steps = toy_domain.WORLD, grounding(), solved(problem)
    assert [step.object for step in steps] in (names, ["item-02", "item-01", "item-02"])
    assert [bool(step.place) for step in steps] == carried
    assert validate(steps, with_places(problem, learned), learned).valid
    run = execute(world, problem, learned, steps)
    assert run.reached
    assert max(run.distances.values()) < 1e-9
    aims = [record.reference for record in run.steps if record.place]
    spots = [with_places(problem, learned).place_named(record.place) for record in run.steps if record.place]
    for aim, spot in zip(aims, spots, strict=True):
        np.testing.assert_allclose(aim.centre[:2], np.array(spot) - OFFSET[:2])
    again = rerun(world, problem, learned, run)
    assert compare_runs(run, again).course == "same bytes"
    assert msgspec.json.decode(msgspec.json.encode(run), type=type(run)) == run


def test_what_fails_is_not_done_again_the_same_way():
    """The hand is told to carry something that is nailed down: after that, nothing is left to try."""
    world, learned, problem = toy_domain.WORLD, grounding(), swap()

    class Nailed(Aimed):
        def interact(self, scene, action, target, **options):
            return world.interact(scene, np.zeros(12) if target == 0 else action, target, **options)

    def replanner(task, known):
        return plan(task, known)

    run = execute(Nailed(world), problem, learned, solved(problem), replanner=replanner)
    assert not run.reached
    tried = [record for record in run.steps if record.object == "item-01"]
    assert 1 <= len(tried) <= 4
    assert all(record.happened == "missed" for record in tried)
    assert run.ended == "no plan"


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("moon", "no place 'moon'; valid: goal-item-01, goal-item-02, park-01"),
        ("", "needs a place to carry it to; valid: goal-item-01, goal-item-02"),
        ("start-item-01 start-item-02", "no place 'start-item-02'; the nearest is .*; valid: goal-item-01"),
        ("spot-5500-m5200", "The place spot-5500-m5200 lies .* off the table"),
    ],
)
def test_steps_to_nowhere_are_refused_in_a_plan_and_before_anything_moves(words, said, tmp_path: Path):
    done = []
    with pytest.raises(InvalidPlan, match=f"line 1: .*{said}"):
        parse_plan(f"({NAME} item-01 {words})", tmp_path, grounding(), swap())
    steps = [*solved(swap()), PlanStep(NAME, "item-01", place=(words.split() or [""])[-1])]
    with pytest.raises(NeurosymError, match=said):
        execute(toy_domain.WORLD, swap(), grounding(), steps, on_step=done.append)
    pushed = PlanStep("push-left-001-slab", "item-01", place="park-01")
    with pytest.raises(NeurosymError, match="carries nothing, so it cannot lead to park-01"):
        execute(toy_domain.WORLD, swap(), grounding(), [pushed], on_step=done.append)
    assert not done


OWN = {"left": (0.8, 0.1), "right": (0.5, -0.1)}


def test_own_places_are_planned_with_as_they_are_written(monkeypatch):
    problem = replace(swap(), places=OWN | {"park-aside": (0.7, 0.25)})
    check_places(problem, grounding())
    places = [step.place for step in plan(problem, grounding()).steps]
    assert (places[0], {*places[1:]}) == ("park-aside", {"right", "left"})
    with pytest.raises(InvalidValue, match="nothing in this domain carries objects to places; leave out"):
        check_places(problem, replace(grounding(), places=None))
    few = replace(swap(), places=OWN)
    for most, said in ((1, "among more than 1 objects, none is led over cells"), (2, "without: ")):
        monkeypatch.setattr(MODULE, "MOST_LED", most)
        result = plan(few, grounding())
        assert result.status is PlanStatus.NOT_FOUND
        assert said in result.reason


@pytest.mark.parametrize(
    ("places", "said"),
    [
        ({"shelf": (2.0, 0.0)}, r"place shelf lies at x = 2, y = 0 m, off the table; valid: x 0\.\d+ to"),
        *(
            ({name: (0.6, 0.0)}, f"No place can be called {name}")
            for name in ("item-01", "start-item-01", "nowhere", "place", "take", "move-x", "cube")
        ),
        ({"goal-item-01": (0.4, 0.2)}, r"goal-item-01 lies at \(0.4, 0.2\) m, and the goal of item-01 at"),
        ({"Shelf": (0.6, 0.0)}, "'Shelf' is not a legal name"),
        (
            {"park-a": (0.6, 0.0), "park-b": (0.62, 0.01)},
            "park-a and park-b are too near for item-01 and item-02; valid: at least 0.050 m apart in x",
        ),
        ({"left": (0.8, 0.1), "park-a": (0.84, 0.1)}, "left and park-a are too near for item-01 and item-02"),
    ],
)
def test_own_places_that_cannot_be_are_refused_in_one_sentence(places, said):
    with pytest.raises(InvalidValue, match=said):
        check_problem(replace(swap(), places=places), grounding(), None)


def test_goal_under_what_nothing_moves_or_without_room_is_a_result_with_its_reason():
    learned, goals = grounding(), {"item-01": (0.7, 0.0, 0.025)}
    cubes = scene(("cube", 0.5, -0.2), ("cube", 0.7, 0.0))
    crowd = Problem("under", cubes, goals, 0.02, places={"goal-item-01": (0.7, 0.0)})
    result = plan(crowd, learned)
    assert result.status is PlanStatus.NOT_FOUND
    assert result.reason.startswith("no plan with the places that were drawn; without: ")
    assert [step.object for step in solved(replace(crowd, places={}))] == ["item-02", "item-01"]
    still = replace(learned, objects=replace(learned.objects, operators=()))
    slab = Problem("under", scene(("cube", 0.5, -0.2), ("slab", 0.7, 0.0)), goals, 0.02)
    result = plan(slab, still)
    assert result.status is PlanStatus.UNSOLVABLE
    assert result.reason == "item-02 stands where item-01 is to end, and no primitive moves it"


EDGE = CUBE[0]
TABLE = grounding().table
NAMES = ("item-01", "item-02")


def side_by_side(gap: float, tolerance: float = 0.05) -> Problem:
    """Two cubes whose goals lie side by side along y, so far apart [m]."""
    goals = {"item-01": (0.7, 0.0, 0.025), "item-02": (0.7, EDGE + gap, 0.025)}
    return Problem("pair", scene(("cube", 0.5, -0.2), ("cube", 0.5, 0.2)), goals, tolerance)


def test_goals_that_nearly_touch_make_room_for_the_hand_as_far_as_they_allow():
    spots = goal_spots(side_by_side(2 * ROOM[1]), TABLE, NAMES)
    assert spots["item-01"] == (0.7, 0.0)
    assert spots["item-02"] == pytest.approx((0.7, EDGE + 2 * ROOM[1]))
    spots = goal_spots(side_by_side(0.01), TABLE, NAMES)
    assert spots["item-02"][1] - spots["item-01"][1] - EDGE == pytest.approx(ROOM[1], abs=0.002)
    tight = side_by_side(0.0, tolerance=0.01)
    spots = goal_spots(tight, TABLE, NAMES)
    beside = [math.dist(spots[name], tight.goals[name][:2]) for name in NAMES]
    assert beside == pytest.approx([SHARE * 0.01] * 2, abs=1e-4)
    near = side_by_side(0.01)  # what stands at its goal stays, and the other makes room
    stands = replace(near.objects[0], position=(0.7, 0.01, 0.025))
    spots = goal_spots(replace(near, objects=(stands, near.objects[1])), TABLE, ("item-02",))
    assert spots["item-02"] == pytest.approx((0.7, EDGE + 0.01 + SHARE * 0.05), abs=1e-4)


@pytest.mark.parametrize("seed", range(4))
def test_every_spot_is_in_its_goal_and_on_the_table(seed):
    rng = np.random.default_rng(seed)
    low, high = np.array([TABLE.x, TABLE.y]).T
    goals = {f"item-{n:02d}": (*rng.uniform(low, high).tolist(), 0.025) for n in range(1, 7)}
    cubes = scene(*(("cube", 0.4 + 0.08 * n, -0.2) for n in range(6)))
    problem = Problem("many", cubes, goals, 0.05)
    spots = goal_spots(problem, TABLE, tuple(goals))
    assert spots == goal_spots(problem, TABLE, tuple(goals))
    for name, (x, y, _) in goals.items():
        there = math.dist(problem.object_named(name).position[:2], (x, y)) <= 0.05
        assert math.dist(spots[name], (x, y)) <= (1.0 if there else SHARE) * 0.05 + 1e-4
        assert TABLE.contains(np.array([*spots[name], 0.025]))


def test_run_asks_for_places_anew_when_something_stands_otherwise():
    """Who was set down beside its place is kept clear of by the next."""
    problem = side_by_side(0.0)
    off = replace(problem.objects[0], position=(0.7, 0.02, 0.025))
    problem = replace(problem, objects=(off, problem.objects[1]))
    steps = [PlanStep(NAME, "item-01", place="goal-item-01")]
    run = execute(WORLD, problem, grounding(), steps, replanner=plan)
    assert run.reached, run.reason


def test_objects_wait_on_goals_of_others_only_where_there_are_no_parks():
    """The ring: three cubes, each to go where the next one stands, and the goal of a fourth to wait at."""
    problem = with_places(swap(), grounding())
    may, names = occupants(problem, problem.object_names), problem.object_names
    assert with_places(swap(), grounding()) == problem == with_places(problem, grounding())
    assert may == {f"goal-{name}": (name,) for name in names} | {f"park-0{n}": names for n in (1, 2)}
    spots = [(0.5, -0.2), (0.5, 0.0), (0.5, 0.2), (0.8, 0.2)]
    goals = {f"item-{n + 1:02d}": (*spots[(n + 1) % 3], 0.025) for n in range(3)}
    goals["item-04"] = (0.8, -0.2, 0.025)
    places = {f"goal-{name}": goal[:2] for name, goal in goals.items()}
    ring = Problem("ring", scene(*(("cube", *spot) for spot in spots)), goals, 0.02, places=places)
    assert occupants(ring, ring.object_names)["goal-item-04"] == ring.object_names
    result = plan(ring, grounding())
    assert result.status is PlanStatus.SOLVED, result.reason
    assert all(step.place for step in result.steps)
    assert validate(result.steps, ring, grounding()).valid


@pytest.mark.parametrize("seed", range(4))
def test_no_two_that_may_stand_at_places_stand_in_each_other(seed):
    rng = np.random.default_rng(seed)
    cubes = tuple(
        replace(one, features=(*rng.uniform(0.03, 0.2, 2).tolist(), *CUBE[2:]))
        for one in scene(*(("cube", x, y) for x in (0.4, 0.6, 0.8) for y in (-0.2, 0.2)))
    )
    goals = {f"item-{n:02d}": (*rng.uniform((0.4, -0.25), (0.9, 0.25)).tolist(), 0.025) for n in (1, 3, 5)}
    problem = with_places(Problem("full", cubes, goals, 0.02), grounding())
    apart, names = footprints_apart(problem), problem.object_names
    may = occupants(problem, names)
    assert all(name in may[f"goal-{name}"] for name in goals)
    for here, mine in may.items():
        for there, its in may.items():
            away = np.abs(np.subtract(problem.place_named(here), problem.place_named(there)))
            for one, other in product(mine, its) if here != there else ():
                if one != other and np.all(away < apart[names.index(one), names.index(other)]):
                    assert (f"goal-{one}", f"goal-{other}") == (here, there)
