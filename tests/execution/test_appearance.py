"""Appearance: a turned object is as large as it shows, and of the category of such objects."""

import math

import msgspec
import pytest
import tables

from neurosym.execution.record import as_it_shows
from neurosym.grounding import Grounding
from neurosym.problems import SceneObject


def lying(degrees: float, axis: int = 2) -> SceneObject:
    half = math.radians(degrees) / 2
    turn = [0.0, 0.0, 0.0, math.cos(half)]
    turn[axis] = math.sin(half)
    return SceneObject("item-01", "00", (0.04, 0.1, 0.06, 0.0), (0.5, 0.0, 0.03), tuple(turn))


@pytest.mark.parametrize(
    ("degrees", "axis", "sizes"),
    [
        (0, 2, (0.04, 0.1, 0.06)),
        (10, 2, (0.04, 0.1, 0.06)),
        (90, 2, (0.1, 0.04, 0.06)),
        (-80, 2, (0.1, 0.04, 0.06)),
        (180, 2, (0.04, 0.1, 0.06)),
        (90, 0, (0.04, 0.06, 0.1)),
        (45, 2, (0.14 * math.sqrt(0.5), 0.14 * math.sqrt(0.5), 0.06)),
    ],
)
def test_sizes_are_those_of_the_box_around_the_object(degrees: float, axis: int, sizes: tuple[float, ...]):
    shown = as_it_shows(lying(degrees, axis), tables.grounding())
    assert shown.features[:3] == pytest.approx(sizes, abs=1e-6)
    assert shown.features[3] == 0.0
    assert shown.category == "00"


def test_category_is_that_of_rehearsed_objects_of_such_sizes():
    wide, deep = (0.1, 0.04, 0.06, 0.0), (0.04, 0.1, 0.06, 0.0)
    kept = {"00": (deep,), "11": (wide,)}
    table = tables.table()
    categories = tuple(msgspec.structs.replace(one, objects=kept[one.symbol]) for one in table.categories)
    learned: Grounding = msgspec.structs.replace(
        tables.grounding(), operators=msgspec.structs.replace(table, categories=categories)
    )
    assert as_it_shows(lying(5), learned).category == "00"
    assert as_it_shows(lying(95), learned).category == "11"
