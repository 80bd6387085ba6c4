"""Which goals by relation there can be, where their ghosts stand, and what a drop means."""

import msgspec
import numpy as np
import pytest
import toy_domain
from toy_relations import LIE, REST, grounding, scene, sorting, tower

from neurosym.pair_sight import with_pairs
from neurosym.problems import Problem
from neurosym.relation_operators import PairEnd
from neurosym.studio import setting
from neurosym.studio.placing import complaints_about, reach_of
from neurosym.studio.relating import (
    above,
    ghost_spots,
    goals_for,
    relation_of_drop,
    stacks_of,
    under,
    why_no_drop,
    why_no_goal,
    why_not_related,
)

LEARNED = grounding()
PLAIN = Problem("plain", scene(("cube", 0.5, -0.2), ("block", 0.6, 0.1), ("tray", 0.8, -0.1)), {}, 0.02)


def paired(problem: Problem) -> Problem:
    return with_pairs(problem, LEARNED.relations)


def complaints(problem: Problem, learned=LEARNED) -> dict[str, str]:
    return complaints_about(
        with_pairs(problem, learned.relations),
        learned,
        lambda name: reach_of(problem.object_named(name), learned),
    )


def test_goals_that_an_object_can_have_are_what_was_learned():
    assert goals_for(paired(PLAIN), LEARNED, "item-01") == (
        ("item-01", "item-02", REST),
        ("item-01", "item-03", LIE),
    )
    assert goals_for(paired(PLAIN), LEARNED, "item-03") == ()
    assert goals_for(PLAIN, toy_domain.grounding(), "item-01") == ()


def test_goals_that_the_others_forbid_are_left_out():
    stacked = paired(setting.with_relation(PLAIN, "item-01", "item-02", REST))
    assert [goal[1] for goal in goals_for(stacked, LEARNED, "item-02")] == ["item-03"]  # no circle
    four = Problem("four", scene(*[("cube", 0.5 + 0.1 * n, 0.0) for n in range(4)]), {}, 0.02)
    taken = paired(setting.with_relation(four, "item-01", "item-02", REST))
    assert "item-02" not in [goal[1] for goal in goals_for(taken, LEARNED, "item-03")]  # it bears one only


def test_goal_that_holds_may_be_asked_for_though_nothing_leads_to_it():
    lone = msgspec.structs.replace(LEARNED.relations, operators=())
    learned = msgspec.structs.replace(LEARNED, relations=lone)
    assert goals_for(paired(sorting()), learned, "item-01") == (("item-01", "item-02", REST),)


def test_ghosts_stand_on_ghosts_as_operators_promise():
    spots = ghost_spots(paired(tower()), LEARNED)
    assert list(spots) == ["item-01", "item-03"]
    assert spots["item-03"] == pytest.approx((0.5, 0.1, 0.075))
    assert spots["item-01"] == pytest.approx((0.5, 0.1, 0.125))
    placed = setting.with_goal(tower(), "item-02", 0.8, 0.0)
    assert ghost_spots(paired(placed), LEARNED)["item-01"] == pytest.approx((0.8, 0.0, 0.125))
    assert ghost_spots(paired(sorting()), LEARNED)["item-01"] == pytest.approx(
        (0.8, -0.15, 0.03 + 0.09 * 0.055)
    )


def test_ghosts_of_goals_on_the_table_stand_where_they_are():
    goals = {"item-01": (0.6, 0.16, 0.025)}
    assert ghost_spots(toy_domain.problem(goals), toy_domain.grounding()) == goals


def test_drop_is_on_the_highest_ghost_that_something_leads_to():
    dropped = paired(setting.with_goal(tower(), "item-04", 0.5, 0.1))
    assert under(dropped, "item-04", ghost_spots(dropped, LEARNED)) == ("item-01", "item-03", "item-02")
    assert relation_of_drop(dropped, LEARNED, "item-04") == ("item-04", "item-01", REST)
    beside = paired(setting.with_goal(tower(), "item-04", 0.6, 0.0))
    assert relation_of_drop(beside, LEARNED, "item-04") is None


def test_drop_on_what_rests_on_the_object_itself_means_nothing():
    dropped = paired(setting.with_goal(tower(), "item-02", 0.7, -0.1))  # where its own load is now
    assert under(dropped, "item-02", ghost_spots(dropped, LEARNED)) == ()
    assert relation_of_drop(dropped, LEARNED, "item-02") is None


def test_drop_takes_the_state_that_the_pair_is_brought_to_most_surely():
    table = LEARNED.relations
    put = table.operators[1]
    ends = (PairEnd("001", 12, 0.6, (0.0, 0.0, 1.0), (0.0,) * 3),)
    less_sure = msgspec.structs.replace(put, name="another", ends=ends)
    for operators in ((less_sure, *table.operators), (*table.operators, less_sure)):
        relations = msgspec.structs.replace(table, operators=operators)
        learned = msgspec.structs.replace(LEARNED, relations=relations)
        dropped = paired(setting.with_goal(PLAIN, "item-01", 0.82, -0.1))
        assert relation_of_drop(dropped, learned, "item-01") == ("item-01", "item-03", LIE)
        assert ("item-01", "item-03", REST) in goals_for(dropped, learned, "item-01")


def test_what_nothing_leads_to_is_said_with_what_would_be_valid():
    dropped = paired(setting.with_goal(PLAIN, "item-03", 0.6, 0.1))
    said = why_no_drop(dropped, LEARNED, "item-03", "item-02")
    assert said == (
        "nothing puts item-03 on or into item-02; nothing puts item-03 on or into any other object"
    )
    said = why_no_goal(paired(PLAIN), LEARNED, ("item-01", "item-02", LIE))
    assert said == (
        f"no operator brings item-01 to {LIE} with item-02; valid for item-01: {REST} item-02, {LIE} item-03"
    )


def test_goal_that_can_no_longer_be_is_said_of_its_object_alone():
    assert why_not_related(paired(tower()), LEARNED) == {}
    broken = msgspec.structs.replace(tower(), relations=(*tower().related, ("item-04", "item-01", LIE)))
    assert list(why_not_related(paired(broken), LEARNED)) == ["item-04"]
    assert "item-04" in complaints(broken)["goal item-04"]


def test_nothing_is_complained_of_where_things_stand_on_one_another():
    for problem in (tower(), sorting(), setting.with_goal(tower(), "item-02", 0.8, 0.0)):
        assert complaints(problem) == {}
    full = scene(("tray", 0.8, 0.0), ("cube", 0.8, 0.0, 0.01), ("block", 0.5, 0.1))
    carried = Problem("full", full, {"item-01": (0.82, 0.0, 0.03)}, 0.02)
    assert complaints(carried) == {}


def test_ghost_over_another_is_right_where_something_leads_there_and_wrong_elsewhere():
    assert complaints(setting.with_goal(PLAIN, "item-01", 0.6, 0.1)) == {}
    wrong = complaints(setting.with_goal(PLAIN, "item-03", 0.6, 0.1))
    assert wrong == {"goal item-03": "the goal of item-03 is in item-02"}
    beside = complaints(setting.with_goal(PLAIN, "item-01", 0.655, 0.1))
    assert beside == {"goal item-01": "the goal of item-01 is in item-02"}


def test_goal_on_the_table_is_in_no_ghost_that_stands_higher():
    goal = setting.with_goal(tower(), "item-04", 0.5, 0.16)  # overlaps item-02 only, with its edge
    assert complaints(goal) == {"goal item-04": "the goal of item-04 is in item-02"}


def test_object_that_was_dragged_into_a_tray_is_not_borne_by_it():
    inside = setting.moved(PLAIN, "item-01", 0.82, -0.1)
    assert stacks_of(paired(inside), LEARNED) == {}
    assert complaints(inside)["object item-01"] == "item-01 is in item-03"


def test_what_an_object_bears_is_named_to_the_top():
    stacks = {name: borne.by for name, borne in stacks_of(paired(sorting()), LEARNED).items()}
    assert stacks == {"item-01": "item-02", "item-02": "item-03"}
    assert set(above("item-03", stacks)) == {"item-01", "item-02"}
    moved = setting.moved(sorting(), "item-02", 0.55, 0.2, 0.025, ["item-01"])
    assert np.allclose(moved.object_named("item-01").position, (0.55, 0.2, 0.075))
    assert stacks_of(paired(moved), LEARNED)["item-01"].by == "item-02"
