"""`explain` says in words what symbols mean, under the names that the compiler uses, and for any table."""

import re

import msgspec
import numpy as np
import pytest
from tables import table

from neurosym.errors import InvalidFile
from neurosym.files import write_json
from neurosym.operators import Category
from neurosym.report.explanation import explain, explain_folder
from neurosym.report.symbols import (
    action_in_words,
    displacement_in_words,
    type_shares,
)
from neurosym.stages.folder import DomainFolder
from neurosym.world import three_waypoints

GRIPPER = three_waypoints().gripper.tolist()


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


def test_every_mode_has_its_row_with_mean_spread_and_share():
    lift, away = said_of(explain(table()), "010").effects[:2]
    assert (lift.ends, lift.share, lift.trials, lift.promised) == ("held", 0.8, 20, 15)
    assert lift.effect == "12 mm forward, 21 mm right, 203 mm up"
    assert lift.spread == "± 4, 3, 1 mm"
    assert away.operator == lift.operator
    assert away.ends == "at rest"


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"categories": (Category("00", "block", 1.0, (0.1,), ()),)}, "spread for each mean"),
        ({"categories": table().categories[:1]}, "unknown primitive or category"),
    ],
)
def test_table_that_does_not_fit_together_is_refused(tmp_path, change, message):
    write_json(tmp_path / "primitives.json", msgspec.structs.replace(table(), **change))
    with pytest.raises(InvalidFile, match=message):
        explain_folder(DomainFolder(tmp_path))
