"""A scene is changed one thing at a time, and all that was not touched stays."""

import msgspec
import numpy as np
import pytest
from toy_domain import problem
from toy_relations import LIE, REST, sorting

from neurosym.errors import InvalidValue
from neurosym.studio import scene_editor

STACK = msgspec.structs.replace(sorting(), touching=(("item-01", "item-02"), ("item-02", "item-03")))
SCENE = problem({"item-01": (0.6, 0.16, 0.025)})


def by_size(features: np.ndarray) -> tuple[str, ...]:
    return tuple("10" if row[0] > 0.1 else "00" for row in features)


def test_moved_object_keeps_its_height_and_its_goal():
    after = scene_editor.moved(SCENE, "item-02", 0.7, -0.1)
    assert after.object_named("item-02").position == (0.7, -0.1, 0.025)
    assert after.goals == SCENE.goals
    assert after.objects[0] == SCENE.objects[0]


def test_goal_keeps_its_height_unless_one_is_given():
    after = scene_editor.with_goal(
        scene_editor.with_goal(SCENE, "item-01", 0.5, 0.0, 0.2), "item-01", 0.55, 0.1
    )
    assert after.goals["item-01"] == (0.55, 0.1, 0.2)
    assert scene_editor.with_goal(SCENE, "item-02", 0.5, 0.0).goals["item-02"] == (0.5, 0.0, 0.025)


def test_resized_object_rests_on_the_table_and_shows_its_new_category():
    after = scene_editor.resized(SCENE, "item-01", (0.12, 0.05, 0.08, 0.0), by_size)
    item = after.object_named("item-01")
    assert (item.category, item.position[2]) == ("10", 0.04)
    assert after.goals["item-01"] == (0.6, 0.16, 0.04)


def test_objects_are_added_by_the_first_free_name_and_taken_away_but_the_last():
    features = (0.05, 0.05, 0.05, 0.0)
    assert scene_editor.with_object(None, features, 0.5, 0.0, by_size).object_names == ("item-01",)
    fewer = scene_editor.without_object(SCENE, "item-01")
    assert fewer.goals == {}
    assert scene_editor.with_object(fewer, features, 0.5, -0.2, by_size).object_names == (
        "item-02",
        "item-01",
    )
    with pytest.raises(InvalidValue, match="the only object"):
        scene_editor.without_object(fewer, "item-02")


def test_object_has_one_goal_on_the_table_or_by_relation():
    related = scene_editor.with_relation(SCENE, "item-01", "item-02", REST)
    assert (related.goals, related.related) == ({}, (("item-01", "item-02", REST),))
    assert scene_editor.with_relation(related, "item-01", "item-02", LIE).related == (
        ("item-01", "item-02", LIE),
    )
    again = scene_editor.with_goal(related, "item-01", 0.6, 0.16)
    assert again == scene_editor.with_goal(SCENE, "item-01", 0.6, 0.16)
    assert scene_editor.without_goal(related, "item-01") == scene_editor.without_goal(SCENE, "item-01")


def test_what_was_seen_of_contacts_and_pairs_is_forgotten_with_what_it_was_about():
    assert scene_editor.moved(STACK, "item-01", 0.6, 0.2).touching is None
    assert scene_editor.with_goal(STACK, "item-03", 0.6, 0.2).touching == STACK.touching
    assert scene_editor.without_object(STACK, "item-01").touching == (("item-02", "item-03"),)
    known = msgspec.structs.replace(STACK, pairs={"item-01 item-02": "01"})
    assert scene_editor.moved(known, "item-01", 0.6, 0.2).pairs == known.pairs
    assert scene_editor.resized(known, "item-01", (0.05, 0.05, 0.05, 0.0), by_size).pairs == {}
    assert scene_editor.with_object(known, (0.05, 0.05, 0.05, 0.0), 0.5, 0.2, by_size).pairs == {}
    left = scene_editor.without_object(known, "item-04")
    assert [goal[1] for goal in left.related] == ["item-05"]
