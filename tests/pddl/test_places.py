"""Tasks with places: where those are, which can be, and that plans for them come true."""

import math
from pathlib import Path

import msgspec
import numpy as np
import pytest
import toy_domain
from toy_places import NAME, OFFSET, grounding, mixed, scene, swap

from neurosym.errors import InvalidPlan, InvalidValue, NeurosymError
from neurosym.execution.executor import execute
from neurosym.execution.rerun import compare_runs, rerun
from neurosym.pddl.plan_reading import parse_plan
from neurosym.pddl.problem_check import check_places, check_problem
from neurosym.planners import PlanStatus, plan
from neurosym.planners.planner import PlanResult
from neurosym.problems import Problem, SceneObject
from neurosym.tasks.task import GOAL, PARK, footprints_apart, overlapping, with_places
from neurosym.tasks.transition import PlanStep, validate
from neurosym.world import Place
from neurosym.worlds.aims import Aimed


def solved(problem: Problem) -> tuple[PlanStep, ...]:
    result = plan(problem, grounding())
    assert result.status is PlanStatus.SOLVED, result.reason
    return result.steps


def test_places_are_those_of_the_goals_and_free_ones_apart_from_everything():
    problem = with_places(swap(), grounding())
    names = list(problem.places)
    assert names == [f"{GOAL}item-01", f"{GOAL}item-02", f"{PARK}01", f"{PARK}02"]
    parks = np.array([problem.places[name] for name in names if name.startswith(PARK)])
    taken = np.vstack([problem.scene().positions[:, :2], parks])
    apart = footprints_apart(problem)[0, 0] + 0.04
    for row, spot in enumerate(parks, start=len(problem.objects)):
        others = np.delete(taken, row, axis=0)
        assert not overlapping(spot, others, np.tile(apart, (len(others), 1))).any()
    assert with_places(swap(), grounding()) == problem == with_places(problem, grounding())


def test_two_objects_change_places_by_way_of_a_third():
    steps = solved(swap())
    assert [step.operator for step in steps] == [NAME] * 3
    assert steps[0].place.startswith(PARK)
    assert validate(steps, with_places(swap(), grounding()), grounding()).valid


def test_a_plan_carries_one_thing_and_pushes_another_out_of_its_place_first():
    steps = solved(mixed())
    assert [step.object for step in steps] == ["item-02", "item-02", "item-01"]
    assert [bool(step.place) for step in steps] == [False, False, True]


@pytest.mark.parametrize("problem", [swap(), mixed()])
def test_plans_come_true_in_the_world_and_again_from_the_record(problem):
    world, learned = toy_domain.WORLD, grounding()
    run = execute(world, problem, learned, solved(problem))
    assert run.reached
    assert max(run.distances.values()) < 1e-9
    aims = [record.reference for record in run.steps if record.place]
    spots = [with_places(problem, learned).place_named(record.place) for record in run.steps if record.place]
    for aim, spot in zip(aims, spots, strict=True):
        np.testing.assert_allclose(aim.centre[:2], np.array(spot) - OFFSET[:2])
    again = rerun(world, problem, learned, run)
    assert compare_runs(run, again).course == "same bytes"
    assert msgspec.json.decode(msgspec.json.encode(run), type=type(run)) == run


def test_unknown_places_are_refused_in_one_sentence(tmp_path: Path):
    for words, said in (
        ("moon", "no place 'moon'; valid: goal-item-01, goal-item-02, park-01"),
        ("", "needs a place to carry it to; valid: goal-item-01, goal-item-02"),
        ("start-item-01 start-item-02", "no place 'start-item-02'; valid: goal-item-01"),
        ("spot-5500-m5200", "The place spot-5500-m5200 lies .* off the table"),
    ):
        with pytest.raises(InvalidPlan, match=f"line 1: .*{said}"):
            parse_plan(f"({NAME} item-01 {words})", tmp_path, grounding(), swap())


@pytest.mark.parametrize("name", ["place", "object", "take", "move-x", "cube", "nowhere", "start-item-01"])
def test_places_of_a_problem_have_no_names_of_the_domain(name):
    own = msgspec.structs.replace(swap(), places={name: (0.5, 0.2)})
    with pytest.raises(InvalidValue, match=f"No place can be called {name}"):
        check_places(own, grounding())


@pytest.mark.parametrize(
    ("step", "said"),
    [
        (
            PlanStep(NAME, "item-01", place="moon"),
            "no place 'moon'; valid: goal-item-01, goal-item-02, park-01",
        ),
        (PlanStep(NAME, "item-01"), "needs a place to carry it to; valid: goal-item-01"),
        (
            PlanStep("push-left-001-slab", "item-01", place="park-01"),
            "carries nothing, so it cannot lead to park-01",
        ),
    ],
)
def test_steps_to_nowhere_are_refused_before_anything_moves(step, said):
    done = []
    with pytest.raises(NeurosymError, match=said):
        execute(toy_domain.WORLD, swap(), grounding(), [*solved(swap()), step], on_step=done.append)
    assert not done


def test_what_is_led_and_what_is_carried_is_planned_in_turns_if_not_at_once(monkeypatch):
    """The slab is led past the cube's goal, and would stand in the cube if that were there already."""
    goals = {"item-01": (0.7, 0.0, 0.025), "item-02": (0.7, 0.24, 0.025)}
    problem = Problem("past", scene(("cube", 0.5, -0.2), ("slab", 0.7, -0.16)), goals, 0.02)
    learned = grounding()
    monkeypatch.setattr(
        "neurosym.planners.pddl_search.plan_by_places",
        lambda *_: PlanResult(PlanStatus.FAILED, (), 0.0, "not true when replayed"),
    )
    steps = solved(problem)
    assert [step.object for step in steps] == ["item-02"] * 5 + ["item-01"]
    assert validate(steps, problem, learned).valid


def test_what_shows_as_another_category_by_now_is_aimed_at_by_what_was_learned():
    """A tall block that lies on its side looks like a slab, which the operator of cubes is not for."""
    aside = (math.sqrt(0.5), 0.0, 0.0, math.sqrt(0.5))
    block = SceneObject("item-01", "00", (0.05, 0.05, 0.1, 0.0), (0.5, -0.2, 0.025), aside)
    problem = Problem("lying", (block,), {"item-01": (0.8, 0.1, 0.025)}, 0.02)
    table = grounding().operators
    seen = tuple(msgspec.structs.replace(one, objects=(one.feature_means,)) for one in table.categories)
    learned = msgspec.structs.replace(grounding(), operators=msgspec.structs.replace(table, categories=seen))
    run = execute(toy_domain.WORLD, problem, learned, [PlanStep(NAME, "item-01", place="goal-item-01")])
    assert [record.happened for record in run.steps] in (["missed"], ["carried"])


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


def test_place_nearest_to_a_point_lies_on_the_table():
    table = toy_domain.WORLD.table
    assert table.nearest(2.0, 0.1) == Place(table.x[1], 0.1)
    assert table.nearest(0.5, -9.0) == Place(0.5, table.y[0])


def with_own_places(**places: tuple[float, float]) -> Problem:
    """The problem of two cubes, with places that somebody wrote."""
    named = {name.replace("_", "-"): spot for name, spot in places.items()}
    return msgspec.structs.replace(swap(), places=named)


def test_own_places_are_planned_with_as_they_are_written():
    problem = with_own_places(left=(0.8, 0.1), right=(0.5, -0.1), park_aside=(0.7, 0.25))
    check_places(problem, grounding())
    result = plan(problem, grounding())
    assert [step.place for step in result.steps] in (
        ["park-aside", "right", "left"],
        ["park-aside", "left", "right"],
    )


@pytest.mark.parametrize(
    ("places", "said"),
    [
        ({"shelf": (2.0, 0.0)}, r"place shelf lies at x = 2, y = 0 m, off the table; valid: x 0\.\d+ to"),
        ({"item_01": (0.6, 0.0)}, "No place can be called item-01"),
        ({"start_item_01": (0.6, 0.0)}, "No place can be called start-item-01"),
        ({"nowhere": (0.6, 0.0)}, "No place can be called nowhere"),
        ({"goal_item_01": (0.4, 0.2)}, r"goal-item-01 lies at \(0.4, 0.2\) m, and the goal of item-01 at"),
        ({"Shelf": (0.6, 0.0)}, "'Shelf' is not a legal name"),
        (
            {"park_a": (0.6, 0.0), "park_b": (0.62, 0.01)},
            "park-a and park-b are too near for item-01 and item-02; valid: at least 0.050 m apart in x",
        ),
        ({"left": (0.8, 0.1), "park_a": (0.84, 0.1)}, "left and park-a are too near for item-01 and item-02"),
    ],
)
def test_own_places_that_cannot_be_are_refused_in_one_sentence(places, said):
    with pytest.raises(InvalidValue, match=said):
        check_problem(with_own_places(**places), grounding(), None)


def test_places_mean_nothing_to_a_domain_that_carries_nothing():
    problem = with_own_places(shelf=(0.6, 0.0))
    with pytest.raises(InvalidValue, match="nothing in this domain carries objects to places; leave out"):
        check_places(problem, msgspec.structs.replace(grounding(), places=None))


def test_goal_under_what_nothing_moves_is_a_result_with_its_reason():
    goals = {"item-01": (0.7, 0.0, 0.025)}
    problem = Problem("under", scene(("cube", 0.5, -0.2), ("slab", 0.7, 0.0)), goals, 0.02)
    still = msgspec.structs.replace(
        grounding(), operators=msgspec.structs.replace(grounding().operators, operators=())
    )
    result = plan(problem, still)
    assert result.status is PlanStatus.UNSOLVABLE
    assert result.reason == "item-02 stands where item-01 is to end, and no primitive moves it"


def test_what_only_a_hand_can_carry_away_does_not_stand_in_the_way_for_ever():
    goals = {"item-01": (0.7, 0.0, 0.025)}
    problem = Problem("under", scene(("cube", 0.5, -0.2), ("cube", 0.7, 0.0)), goals, 0.02)
    assert [step.object for step in solved(problem)] == ["item-02", "item-01"]


def test_goal_that_nothing_can_be_put_at_is_not_said_to_be_proved_out_of_reach():
    goals = {"item-01": (0.7, 0.0, 0.025)}
    crowd = with_places(
        Problem("no-room", scene(("cube", 0.5, -0.2), ("cube", 0.7, 0.0)), goals), grounding()
    )
    only = msgspec.structs.replace(crowd, places={"goal-item-01": (0.7, 0.0)})
    result = plan(only, grounding())
    assert result.status is PlanStatus.NOT_FOUND
    assert result.reason.startswith("no plan with the places that were drawn; without: ")


@pytest.mark.parametrize(
    ("most", "said"),
    [(1, "among more than 1 objects, none is led over cells that could be carried"), (2, "without: ")],
)
def test_many_objects_that_could_be_carried_are_not_led_instead(monkeypatch, most, said):
    monkeypatch.setattr("neurosym.planners.pddl_search.MOST_LED", most)
    monkeypatch.setattr("neurosym.planners.joined_plans.MOST_LED", most)
    result = plan(with_own_places(left=(0.8, 0.1), right=(0.5, -0.1)), grounding())
    assert result.status is PlanStatus.NOT_FOUND
    assert said in result.reason
