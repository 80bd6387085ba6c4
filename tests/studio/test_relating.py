"""Which goals by relation there can be, where their ghosts stand, and what a drop means."""

import msgspec
import pytest
import toy_domain
from toy_relations import LIE, REST, grounding, scene, sorting, tower

from neurosym.pair_operators import PairEnd
from neurosym.problems import Problem
from neurosym.studio import scene_editor
from neurosym.studio.scene_editor import (
    complaints_about,
    ghost_spots,
    goals_for,
    relation_of_drop,
    under,
)
from neurosym.tasks.task import Task, understand

LEARNED = grounding()
PLAIN = Problem("plain", scene(("cube", 0.5, -0.2), ("block", 0.6, 0.1), ("tray", 0.8, -0.1)), {}, 0.02)


def task(problem: Problem, learned=LEARNED) -> Task:
    return understand(problem, learned)


def complaints(problem: Problem) -> dict[str, str]:
    return complaints_about(task(problem))


def test_goals_that_an_object_can_have_are_what_was_learned():
    assert goals_for(task(PLAIN), "item-01") == (
        ("item-01", "item-02", REST),
        ("item-01", "item-03", LIE),
    )
    assert goals_for(task(PLAIN), "item-03") == ()
    assert goals_for(task(PLAIN, toy_domain.grounding()), "item-01") == ()


def test_ghosts_stand_on_ghosts_as_operators_promise():
    spots = ghost_spots(task(tower()))
    assert list(spots) == ["item-01", "item-03"]
    assert spots["item-03"] == pytest.approx((0.5, 0.1, 0.075))
    assert spots["item-01"] == pytest.approx((0.5, 0.1, 0.125))
    placed = scene_editor.with_goal(tower(), "item-02", 0.8, 0.0)
    assert ghost_spots(task(placed))["item-01"] == pytest.approx((0.8, 0.0, 0.125))
    assert ghost_spots(task(sorting()))["item-01"] == pytest.approx((0.8, -0.15, 0.03 + 0.09 * 0.055))


def test_drop_is_on_the_highest_ghost_that_something_leads_to():
    dropped = task(scene_editor.with_goal(tower(), "item-04", 0.5, 0.1))
    assert under(dropped, "item-04", ghost_spots(dropped)) == ("item-01", "item-03", "item-02")
    assert relation_of_drop(dropped, "item-04") == ("item-04", "item-01", REST)
    beside = task(scene_editor.with_goal(tower(), "item-04", 0.6, 0.0))
    assert relation_of_drop(beside, "item-04") is None
    itself = task(scene_editor.with_goal(tower(), "item-02", 0.7, -0.1))  # where its own load is now
    assert under(itself, "item-02", ghost_spots(itself)) == ()
    assert relation_of_drop(itself, "item-02") is None


def test_drop_takes_the_state_that_the_pair_is_brought_to_most_surely():
    table = LEARNED.relations
    put = table.operators[1]
    ends = (PairEnd("001", 12, 0.6, (0.0, 0.0, 1.0), (0.0,) * 3),)
    less_sure = msgspec.structs.replace(put, name="another", ends=ends)
    for operators in ((less_sure, *table.operators), (*table.operators, less_sure)):
        relations = msgspec.structs.replace(table, operators=operators)
        learned = msgspec.structs.replace(LEARNED, relations=relations)
        dropped = task(scene_editor.with_goal(PLAIN, "item-01", 0.82, -0.1), learned)
        assert relation_of_drop(dropped, "item-01") == ("item-01", "item-03", LIE)
        assert ("item-01", "item-03", REST) in goals_for(dropped, "item-01")


FULL = scene(("tray", 0.8, 0.0), ("cube", 0.8, 0.0, 0.01), ("block", 0.5, 0.1))


@pytest.mark.parametrize(
    ("problem", "said"),
    [
        (tower(), {}),
        (sorting(), {}),
        (scene_editor.with_goal(tower(), "item-02", 0.8, 0.0), {}),
        (Problem("full", FULL, {"item-01": (0.82, 0.0, 0.03)}, 0.02), {}),
        (scene_editor.with_goal(PLAIN, "item-01", 0.6, 0.1), {}),  # something leads there
        (
            scene_editor.with_goal(PLAIN, "item-03", 0.6, 0.1),
            {"goal item-03": "the goal of item-03 is in item-02"},
        ),
        (
            scene_editor.with_goal(PLAIN, "item-01", 0.655, 0.1),
            {"goal item-01": "the goal of item-01 is in item-02"},
        ),
        # overlaps with its edge what stands on the table, and not the ghosts that stand higher
        (
            scene_editor.with_goal(tower(), "item-04", 0.5, 0.16),
            {"goal item-04": "the goal of item-04 is in item-02"},
        ),
    ],
)
def test_what_stands_on_another_is_right_where_something_leads_there_and_wrong_elsewhere(problem, said):
    assert complaints(problem) == said
