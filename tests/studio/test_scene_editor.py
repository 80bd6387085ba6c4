"""A scene is changed one thing at a time; which goals there can be, and what is wrong where, is said."""

import msgspec
import numpy as np
import pytest
import toy_domain
import toy_relations
from toy_relations import LIE, REST, scene, sorting, tower

from neurosym.errors import InvalidValue
from neurosym.pair_operators import pair_end
from neurosym.problems import Problem
from neurosym.studio.scene_editor import (
    complaints_about,
    free_spot,
    ghost_spots,
    goals_for,
    moved,
    relation_of_drop,
    resized,
    why_not_there,
    with_goal,
    with_object,
    without_object,
)
from neurosym.tasks.task import Task, understand

SCENE = toy_domain.problem({"item-01": (0.6, 0.16, 0.025)})
STACK = msgspec.structs.replace(sorting(), touching=(("item-01", "item-02"), ("item-02", "item-03")))
CUBE = (0.05, 0.05, 0.05, 0.0)
TABLE = toy_domain.grounding().table
LEARNED = toy_relations.grounding()
PLAIN = Problem("plain", scene(("cube", 0.5, -0.2), ("block", 0.6, 0.1), ("tray", 0.8, -0.1)), {}, 0.02)


def by_size(features: np.ndarray) -> tuple[str, ...]:
    return tuple("10" if row[0] > 0.1 else "00" for row in features)


def task(problem: Problem, learned=LEARNED) -> Task:
    return understand(problem, learned)


def test_what_is_moved_or_resized_keeps_all_else():
    after = moved(SCENE, "item-02", 0.7, -0.1)
    assert after.object_named("item-02").position == (0.7, -0.1, 0.025)
    assert after.goals == SCENE.goals
    assert after.objects[0] == SCENE.objects[0]
    item = (larger := resized(SCENE, "item-01", (0.12, 0.05, 0.08, 0.0), by_size)).object_named("item-01")
    assert (item.category, item.position[2]) == ("10", 0.04)
    assert larger.goals["item-01"] == (0.6, 0.16, 0.04)
    for z, height in ((None, 0.2), (0.1, 0.1)):  # a goal keeps its height unless one is given
        raised = with_goal(SCENE, "item-01", 0.5, 0.0, 0.2)
        assert with_goal(raised, "item-01", 0.55, 0.1, z).goals["item-01"] == (0.55, 0.1, height)
    assert with_goal(SCENE, "item-02", 0.5, 0.0).goals["item-02"] == (0.5, 0.0, 0.025)


def test_objects_are_added_by_the_first_free_name_where_there_is_room_and_taken_away_but_the_last():
    assert with_object(None, CUBE, 0.5, 0.0, by_size).object_names == ("item-01",)
    fewer = without_object(SCENE, "item-01")
    assert fewer.goals == {}
    assert with_object(fewer, CUBE, 0.5, -0.2, by_size).object_names == ("item-02", "item-01")
    with pytest.raises(InvalidValue, match="the only object"):
        without_object(fewer, "item-02")
    for middle in ((0.6, 0.0), (0.8, 0.1)):
        x, y = free_spot(SCENE, CUBE, TABLE, middle)
        there = with_object(SCENE, CUBE, x, y, by_size)
        assert why_not_there(there, there.object_names[-1], "object", TABLE) == ""
        assert np.hypot(x - middle[0], y - middle[1]) < 0.11
    with pytest.raises(InvalidValue, match="no room"):
        free_spot(SCENE, (1.5, 1.5, 0.05, 0.0), TABLE, (0.6, 0.0))


def test_what_was_seen_of_contacts_and_pairs_is_forgotten_with_what_it_was_about():
    assert moved(STACK, "item-01", 0.6, 0.2).touching is None
    assert with_goal(STACK, "item-03", 0.6, 0.2).touching == STACK.touching
    assert without_object(STACK, "item-01").touching == (("item-02", "item-03"),)
    known = msgspec.structs.replace(STACK, pairs={"item-01 item-02": "01"})
    assert moved(known, "item-01", 0.6, 0.2).pairs == known.pairs
    assert resized(known, "item-01", CUBE, by_size).pairs == {}
    assert with_object(known, CUBE, 0.5, 0.2, by_size).pairs == {}
    assert [goal[1] for goal in without_object(known, "item-04").relations] == ["item-05"]


OFF = [(0.39, 0.0), (1.01, 0.0), (0.6, 0.31), (0.6, -0.31)]
BESIDE = moved(SCENE, "item-01", 0.79, 0.1)
ON = with_goal(SCENE, "item-01", 0.8, 0.1)


@pytest.mark.parametrize(
    ("problem", "name", "kind", "said"),
    [
        (SCENE, "item-01", "object", ""),
        (SCENE, "item-01", "goal", ""),
        *((moved(SCENE, "item-01", *at), "item-01", "object", "item-01 is off the table") for at in OFF),
        *(
            (with_goal(SCENE, "item-01", *at), "item-01", "goal", "the goal of item-01 is off the table")
            for at in OFF
        ),
        (BESIDE, "item-01", "object", "item-01 is in item-02"),
        (BESIDE, "item-02", "object", "item-02 is in item-01"),
        (ON, "item-01", "goal", "the goal of item-01 is in item-02"),
        (with_goal(ON, "item-02", 0.5, -0.2), "item-01", "goal", ""),  # it leaves
        (with_goal(SCENE, "item-01", 0.8, 0.1, 0.225), "item-01", "goal", ""),  # above it
    ],
)
def test_what_cannot_be_where_it_is_is_said(problem, name, kind, said):
    assert why_not_there(problem, name, kind, TABLE) == said


def test_goals_that_an_object_can_have_are_what_was_learned():
    assert goals_for(task(PLAIN), "item-01") == (("item-01", "item-02", REST), ("item-01", "item-03", LIE))
    assert goals_for(task(PLAIN), "item-03") == ()
    assert goals_for(task(PLAIN, toy_domain.grounding()), "item-01") == ()


def test_ghosts_stand_on_ghosts_as_operators_promise():
    spots = ghost_spots(task(tower()))
    assert list(spots) == ["item-01", "item-03"]
    assert spots["item-03"] == pytest.approx((0.5, 0.1, 0.075))
    assert spots["item-01"] == pytest.approx((0.5, 0.1, 0.125))
    placed = with_goal(tower(), "item-02", 0.8, 0.0)
    assert ghost_spots(task(placed))["item-01"] == pytest.approx((0.8, 0.0, 0.125))
    dropped = task(with_goal(tower(), "item-02", 0.7, -0.1))  # where its own load is now
    assert relation_of_drop(dropped, "item-02") is None
    assert ghost_spots(task(sorting()))["item-01"] == pytest.approx((0.8, -0.15, 0.03 + 0.09 * 0.055))


def test_drop_takes_the_state_that_the_pair_is_brought_to_most_surely():
    table = LEARNED.relations
    put = table.operators[1]
    ends = (pair_end("001", 12, 0.6, (0.0, 0.0, 1.0), (0.0,) * 3),)
    less_sure = msgspec.structs.replace(put, name="another", outcomes=ends)
    for operators in ((less_sure, *table.operators), (*table.operators, less_sure)):
        relations = msgspec.structs.replace(table, operators=operators)
        learned = msgspec.structs.replace(LEARNED, relations=relations)
        dropped = task(with_goal(PLAIN, "item-01", 0.82, -0.1), learned)
        assert relation_of_drop(dropped, "item-01") == ("item-01", "item-03", LIE)
        assert ("item-01", "item-03", REST) in goals_for(dropped, "item-01")


FULL = scene(("tray", 0.8, 0.0), ("cube", 0.8, 0.0, 0.01), ("block", 0.5, 0.1))


@pytest.mark.parametrize(
    ("problem", "wrong"),
    [
        (tower(), ""),
        (sorting(), ""),
        (with_goal(tower(), "item-02", 0.8, 0.0), ""),
        (Problem("full", FULL, {"item-01": (0.82, 0.0, 0.03)}, 0.02), ""),
        (with_goal(PLAIN, "item-01", 0.6, 0.1), ""),  # something leads there
        (with_goal(PLAIN, "item-03", 0.6, 0.1), "item-03"),
        (with_goal(PLAIN, "item-01", 0.655, 0.1), "item-01"),
        # overlaps with its edge what stands on the table, and not the ghosts that stand higher
        (with_goal(tower(), "item-04", 0.5, 0.16), "item-04"),
    ],
)
def test_what_stands_on_another_is_right_where_something_leads_there_and_wrong_elsewhere(problem, wrong):
    said = {f"goal {wrong}": f"the goal of {wrong} is in item-02"} if wrong else {}
    assert complaints_about(task(problem)) == said
