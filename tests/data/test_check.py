"""Data of one's own: whatever is wrong with them is said in a sentence that names the file and the place."""

import numpy as np
import pytest
from command_line import neurosym, refusal
from own_data import own_columns, write_data
from toy_learning import BRIEF

from neurosym.data.interactions import Interactions
from neurosym.data.origin import LEAST_INTERACTIONS
from neurosym.learning.training import train


def put(array, place, value):
    array = array.astype(np.float64)
    array[place] = value
    return array


BAD_COLUMNS = [
    ({"features": lambda c: put(c, (17, 2), np.nan)}, "features[17, 2] is nan"),
    ({"effects": lambda c: put(c, (5, 1), 2e9)}, "effects[5, 1] is 2e+09; valid: finite numbers up to 1e+09"),
    ({"effects": lambda c: put(c, (slice(5, 8), 1), np.nan)}, "effects[5, 1] is nan (and 2 more like it)"),
    ({"features": lambda c: c[:, 0]}, "'features' has shape (60,); valid: (rows, columns)"),
    ({"features": lambda c: c[:0]}, "no interactions"),
    ({"actions": lambda c: c[:59]}, "'actions' has shape (59, 5); valid: (60, columns)"),
    ({"features": lambda c: c.astype(str)}, "'features' holds <U32; valid: numbers"),
    ({"actions": lambda c: c.astype(object)}, "'actions' is damaged, or holds Python objects"),
    ({"held": lambda _: np.full(60, 2)}, "held[0] is 2 (and 59 more like it); valid: true and false"),
    ({"lost": lambda _: np.zeros((60, 1))}, "'lost' has shape (60, 1); valid: (60,)"),
    ({"toppled": lambda _: np.full(60, "no")}, "'toppled' holds <U2; valid: true and false"),
    ({"resting_effects": lambda _: np.zeros((60, 3))}, "'resting_effects' has shape (60, 3); valid: (60, 2)"),
    ({"origin": lambda _: "{"}, "'origin' cannot be read"),
    ({"features": lambda c: put(c, (slice(None), 3), 0.5)}, "features[:, 3] is 0.5 in every row"),
    ({"effects": np.zeros_like}, "'effects' are the same in every row"),
    *[
        ({name: lambda _: None}, f"it has no array {name!r} (needed: features, actions, effects)")
        for name in ("features", "actions", "effects")
    ],
]
BAD_ORIGINS = [
    ({"gripper_columns": [5]}, "gripper_columns = [5]; valid: different whole numbers from 0 to 4"),
    ({"gripper_columns": [True]}, "got `bool` - at `$.gripper_columns[0]`"),
    ({"mirrors": None}, "got `null` - at `$.mirrors`"),
    ({"mirrors": [{"actions": [0]}]}, "missing required field `effects` - at `$.mirrors[0]`"),
    ({"mirrors": [{"actions": [0], "effects": [0], "why": 1}]}, "unknown field `why` - at `$.mirrors[0]`"),
    ({"mirrors": [{"actions": [5], "effects": [0]}]}, "valid: different action parameters from 0 to 4"),
    ({"mirrors": [{"actions": [0], "effects": [2]}]}, "different effect axes from 0 to 1"),
    ({"mirrors": [{"actions": [], "effects": [0]}]}, "at least one and no gripper value"),
    ({"mirrors": [{"actions": [0, 0], "effects": [0]}]}, "the mirror {'actions': [0, 0], 'effects': [0]}"),
    ({"mirrors": [{"actions": [4], "effects": [0]}], "gripper_columns": [4]}, "no gripper value"),
    ({"action_low": [-1, -1]}, "its origin has an action_low of 2 numbers; valid: 5"),
    ({"action_high": [float("nan")] * 5}, "`$.action_high[0]`"),
    ({"action_high": [2e9] * 5}, "Expected `float` <= 1000000000.0 - at `$.action_high[0]`"),
    ({"action_low": [1] * 5, "action_high": [1] * 5}, "action_low[0] = 1 and action_high[0] = 1"),
    ({"action_low": [2] * 5, "action_high": [1] * 5}, "valid: the first below the second"),
    ({"action_low": [-1, -1, 0, -1, -1], "action_high": [1] * 5}, "outside of the action box"),
    ({"feature_names": ["a"]}, "1 feature_names; valid: 7"),
    ({"feature_names": ["a"] * 7}, "valid: a list of different names"),
    ({"feature_names": ["\ud800", *"bcdefg"]}, "valid: a list of different names"),
    ({"format": "neurosym-interactions-9"}, "format 'neurosym-interactions-9'"),
]


@pytest.mark.parametrize(
    ("changes", "origin", "message"),
    [*((changes, None, message) for changes, message in BAD_COLUMNS), *(({}, *row) for row in BAD_ORIGINS)],
)
def test_bad_array_or_origin_is_refused_in_one_sentence(changes, origin, message, tmp_path, capsys):
    columns = own_columns()
    columns |= {name: change(columns.get(name)) for name, change in changes.items()}
    columns = {name: column for name, column in columns.items() if column is not None}
    path = write_data(tmp_path, columns, origin)
    said = refusal(capsys, "check", tmp_path)
    assert str(path) in said
    assert message in said


@pytest.mark.parametrize(
    ("place", "value", "origin"),
    [((17, 2), np.nan, {}), ((slice(None), 3), 0.5, {}), ((0, 0), 0.5, {"gripper_columns": [5]})],
)
def test_training_refuses_what_check_refuses_in_the_same_words(place, value, origin, tmp_path, capsys):
    columns = own_columns()
    columns["features"][place] = value
    write_data(tmp_path, columns, origin)
    assert refusal(capsys, "train", tmp_path) == refusal(capsys, "check", tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["interactions.npz"]


def test_too_few_rows_are_refused(tmp_path, capsys):
    write_data(tmp_path, own_columns(LEAST_INTERACTIONS - 1))
    for command in ("check", "train"):
        assert "19 interactions are too few to train on; at least 20" in refusal(capsys, command, tmp_path)
    enough = Interactions.load(write_data(tmp_path, own_columns(LEAST_INTERACTIONS)))
    assert neurosym("check", tmp_path) == 0
    assert train(enough, config=BRIEF, seed=0).report.held_out == 2


def test_check_lists_every_problem_in_a_line_of_its_own(tmp_path, capsys):
    columns = own_columns()
    columns["features"][:, 1] = 3.0
    columns["effects"][4, 0] = np.nan
    origin = {"gripper_columns": [9], "feature_names": ["a", "mass", *"cdefg"]}
    path = write_data(tmp_path, {**columns, "held": np.zeros(59)}, origin)
    assert neurosym("check", path) == 2
    lines = capsys.readouterr().err.strip().splitlines()
    assert len(lines) == 4
    assert all(line.startswith(f"{path} cannot be used: ") and line.endswith(".") for line in lines)
    for said in (
        "effects[4, 0]",
        "'held' has shape",
        "gripper_columns",
        "features[:, 1] (mass) is 3 in every row",
    ):
        assert sum(said in line for line in lines) == 1


def test_pickled_effects_are_the_only_fault_told_of_them_and_names_that_quote_them_are_told(tmp_path, capsys):
    columns = own_columns()
    columns |= {"resting_effects": columns["effects"], "effects": columns["effects"].astype(object)}
    path = write_data(tmp_path, columns, {"feature_names": ["effects", "effects"]})
    assert neurosym("check", path) == 2
    said = capsys.readouterr().err
    assert "'effects' is damaged, or holds Python objects" in said
    assert "its origin has feature_names = ['effects', 'effects']" in said
    assert "resting_effects" not in said
    assert "no array 'effects'" not in said
