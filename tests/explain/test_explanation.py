"""`explain` says in words what symbols mean, under the names that the compiler uses, and for any table."""

import re

import msgspec
import numpy as np
import pytest
from tables import mode, table

from neurosym.errors import InvalidValue
from neurosym.operators import Category, Operator, OperatorTable, Primitive
from neurosym.pair_operators import Kept, PlaceOperators
from neurosym.report.explanation import explain, explain_carrying, summary_of
from neurosym.report.symbol_words import (
    action_in_words,
    displacement_in_words,
    objects_in_words,
    type_shares,
)
from neurosym.world import three_waypoints

GRIPPER = three_waypoints().gripper.tolist()
FEATURES = ("s_x", "s_y", "d", "t")


def said_of(explanation, symbol):
    return next(action for action in explanation.actions if action.symbol == symbol)


def test_action_is_told_from_start_to_rise():
    action = (-0.042, 0.044, -0.025, 0.84, -0.028, 0.0, 0.0, 0.1, 0.0, 0.0, 0.01, 0.2)
    assert action_in_words(action, GRIPPER) == (
        "The hand starts open, 42 mm back and 44 mm left of the object's centre, 25 mm below it.",
        "It closes there and moves to 28 mm back of the centre, level with it.",
        "Still closed, it moves to 10 mm above the centre.",
        "It rises closed; from start to end it has moved 42 mm forward, 44 mm right, 35 mm up.",
    )


def test_words_give_the_numbers_back():
    rng = np.random.default_rng(3)
    signs = {"forward": 1, "back": -1, "left": 1, "right": -1, "up": 1, "down": -1}
    axes = {"forward": 0, "back": 0, "left": 1, "right": 1, "up": 2, "down": 2}
    for vector in rng.uniform(-0.3, 0.3, size=(100, 3)):
        read = np.zeros(3)
        for millimetres, word in re.findall(r"(\d+) mm (\w+)", displacement_in_words(vector.tolist())):
            read[axes[word]] = signs[word] * int(millimetres)
        np.testing.assert_array_equal(read, np.round(1000 * vector))


@pytest.mark.parametrize("types", [[0, 0, 1, 2], [1, 1], [0], [2, 0, 0, 0, 2], [0, 1, 1]])
def test_shares_of_types_follow_from_mean_and_spread(types):
    shares = type_shares(float(np.mean(types)), float(np.std(types)))
    np.testing.assert_allclose(shares, [types.count(kind) / len(types) for kind in range(3)], atol=1e-12)


def test_objects_are_told_by_size_and_type():
    tray = Category("11", "tray", 0.4, (0.12, 0.1, 0.04, 1.0), (0.02, 0.02, 0.01, 0.0))
    assert objects_in_words(tray, FEATURES) == (
        "40% of the objects have this symbol: 120 ± 20 mm from back to front, 100 ± 20 mm from right to "
        "left, 40 ± 10 mm high.",
        "Of them, all are open at the top.",
    )
    assert "f1 0.12 ± 0.02" in objects_in_words(tray)[0]


def test_every_mode_has_its_row_with_mean_spread_and_share():
    lift, away = said_of(explain(table()), "010").effects[:2]
    assert (lift.ends, lift.share, lift.trials, lift.promised) == ("held", 0.8, 20, 15)
    assert lift.effect == "12 mm forward, 21 mm right, 203 mm up"
    assert lift.spread == "± 4, 3, 1 mm"
    assert away.operator == lift.operator
    assert away.ends == "at rest"


def test_carrying_is_told_from_pushing_by_how_high_the_object_was():
    first, *others = table().operators
    (mode,) = first.modes
    carried = msgspec.structs.replace(first, modes=(msgspec.structs.replace(mode, peak_height=0.12),))
    placed = explain(msgspec.structs.replace(table(), operators=(carried, *others)))
    assert (
        said_of(placed, "000").effects[0].effect == "2 mm forward, 83 mm left, carried 120 mm high on the way"
    )


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"primitives": ()}, "no primitives"),
        ({"primitives": (Primitive("0x1", (), 0.0),)}, "not codes"),
        ({"categories": (Category("00", "block", 1.0, (0.1,), ()),)}, "spread for each mean"),
        ({"categories": table().categories[:1]}, "unknown primitive or category"),
    ],
)
def test_table_that_does_not_fit_together_is_refused(change, message):
    with pytest.raises(InvalidValue, match=message):
        explain(msgspec.structs.replace(table(), **change))


def carrying(*ends) -> PlaceOperators:
    """One symbol whose action was rehearsed on one category, with other objects on the place too."""
    action = (-0.03, 0.0, 0.01, 0.9, 0.0, 0.0, 0.01, 0.1, 0.02, 0.0, 0.03, 0.9)
    operator = Operator("carry-to-0-thing", "0", "0", 20, ends)
    category = Category("0", "thing", 0.5, (1.0,), (0.0,))
    table_of = OperatorTable((category,), (Primitive("0", action, 0.0),), (operator,))
    return PlaceOperators(table_of, (Kept("carry-to-0-thing", 20, 3),))


def test_carrying_is_told_with_the_third_waypoint_at_the_place():
    there = mode((0.002, 0.0, 0.0), kind="carried", count=18, near=18)
    missed = mode((0.0, 0.0, 0.0), kind="missed", count=2, near=0)
    (told,) = explain_carrying(carrying(there, missed), GRIPPER)
    assert told.title == "carries 45% of objects to a place"
    assert told.about == (
        "The hand starts open, 30 mm back of the object's centre, 10 mm above it. It closes there and moves "
        "to 10 mm above the centre. What it grips then it lifts, carries to 20 mm forward of the place, "
        "30 mm above it, lowers and lets go. With another object on the place it went as promised "
        "3 of 20 times."
    )
    assert [(row.ends, row.effect, row.domain) for row in told.effects] == [
        ("carried to the place", "2 mm forward of the place", "yes"),
        ("not carried to the place", "elsewhere", "yes"),
    ]
    assert summary_of([told]).startswith("Of 1 symbols of actions aimed at a place, 1 carry objects there")
