"""Data of one's own: whatever is wrong with them is said in a sentence that names the file and the place."""

import pickle
import zipfile

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
    ({"actions": lambda c: put(c, (3, 4), np.inf)}, "actions[3, 4] is inf"),
    ({"effects": lambda c: put(c, (5, 1), -np.inf)}, "effects[5, 1] is -inf"),
    ({"effects": lambda c: put(c, (5, 1), 1e300)}, "effects[5, 1] is 1e+300"),
    ({"effects": lambda c: put(c, (5, 1), 2e9)}, "effects[5, 1] is 2e+09; valid: finite numbers up to 1e+09"),
    ({"effects": lambda c: put(c, (slice(5, 8), 1), np.nan)}, "effects[5, 1] is nan (and 2 more like it)"),
    ({"features": lambda c: c[:, 0]}, "'features' has shape (60,); valid: (rows, columns)"),
    ({"features": lambda c: c[:, :0]}, "'features' has shape (60, 0)"),
    ({"features": lambda c: c[:0]}, "no interactions"),
    ({"actions": lambda c: c[:59]}, "'actions' has shape (59, 5); valid: (60, columns)"),
    ({"effects": lambda c: c[..., None]}, "'effects' has shape (60, 2, 1)"),
    ({"features": lambda c: c.astype(str)}, "'features' holds <U32; valid: numbers"),
    ({"effects": lambda c: c.astype(complex)}, "'effects' holds complex128"),
    ({"actions": lambda c: c.astype(object)}, "'actions' is damaged, or holds Python objects"),
    ({"held": lambda _: np.full(60, 2)}, "held[0] is 2 (and 59 more like it); valid: true and false"),
    ({"lost": lambda _: np.zeros((60, 1))}, "'lost' has shape (60, 1); valid: (60,)"),
    ({"toppled": lambda _: np.full(60, "no")}, "'toppled' holds <U2; valid: true and false"),
    ({"peak_heights": lambda _: np.full(60, np.nan)}, "peak_heights[0] is nan"),
    ({"resting_effects": lambda _: np.zeros((60, 3))}, "'resting_effects' has shape (60, 3); valid: (60, 2)"),
    ({"origin": lambda _: "{"}, "'origin' cannot be read"),
    ({"origin": lambda _: np.arange(3)}, "'origin' cannot be read"),
    ({"origin": lambda _: "[1]"}, "'origin' cannot be read"),
    ({"features": lambda c: put(c, (slice(None), 3), 0.5)}, "features[:, 3] is 0.5 in every row"),
    ({"actions": lambda c: put(c, (slice(None), 0), 2)}, "actions[:, 0] is 2 in every row"),
    ({"effects": np.zeros_like}, "'effects' are the same in every row"),
]
BAD_ORIGINS = [
    ({"gripper_columns": [5]}, "gripper_columns = [5]; valid: a list of different whole numbers from 0 to 4"),
    ({"gripper_columns": [1.5]}, "gripper_columns = [1.5]"),
    ({"gripper_columns": [True]}, "gripper_columns = [True]"),
    ({"gripper_columns": [1, 1]}, "gripper_columns = [1, 1]"),
    ({"gripper_columns": 3}, "gripper_columns = 3"),
    ({"mirrors": {"actions": [0]}}, "mirrors = {'actions': [0]}; valid: a list of {"),
    ({"mirrors": None}, "mirrors = None; valid: a list of {"),
    ({"mirrors": [[0, 1]]}, "mirrors = [[0, 1]]; valid: a list of {"),
    ({"mirrors": [{"actions": [0]}]}, "valid: a list of {"),
    ({"mirrors": [{"actions": [0], "effects": [0], "why": 1}]}, "valid: a list of {"),
    ({"mirrors": [{"actions": [0], "effects": 0}]}, "valid: a list of {"),
    ({"mirrors": [{"actions": [True], "effects": [0]}]}, "valid: a list of {"),
    ({"mirrors": [{"actions": [5], "effects": [0]}]}, "valid: different action parameters from 0 to 4"),
    ({"mirrors": [{"actions": [-1], "effects": [0]}]}, "valid: different action parameters from 0 to 4"),
    ({"mirrors": [{"actions": [0], "effects": [2]}]}, "different effect axes from 0 to 1"),
    ({"mirrors": [{"actions": [], "effects": [0]}]}, "at least one and no gripper value"),
    ({"mirrors": [{"actions": [0, 0], "effects": [0]}]}, "the mirror {'actions': [0, 0], 'effects': [0]}"),
    ({"mirrors": [{"actions": [4], "effects": [0]}], "gripper_columns": [4]}, "no gripper value"),
    ({"action_low": [-1, -1]}, "action_low = [-1, -1]; valid: a list of 5 finite numbers"),
    ({"action_high": ["a"] * 5}, "action_high = ['a', 'a'"),
    ({"action_high": [float("nan")] * 5}, "action_high = [nan"),
    ({"action_high": [10**400] * 5}, "action_high = [1000"),
    ({"action_low": [1] * 5, "action_high": [1] * 5}, "action_low[0] = 1 and action_high[0] = 1"),
    ({"action_low": [2] * 5, "action_high": [1] * 5}, "valid: the first below the second"),
    ({"action_low": [-1, -1, 0, -1, -1], "action_high": [1] * 5}, "outside of the action box"),
    ({"feature_names": ["a"]}, "1 feature_names; valid: 7"),
    ({"feature_names": ["a"] * 7}, "valid: a list of different names"),
    ({"feature_names": ["\ud800", *"bcdefg"]}, "valid: a list of different names"),
    ({"format": "neurosym-interactions-9"}, "format 'neurosym-interactions-9'"),
]


@pytest.mark.parametrize(("changes", "message"), BAD_COLUMNS)
def test_bad_array_is_refused_in_one_sentence(changes, message, tmp_path, capsys):
    columns = own_columns()
    columns |= {name: change(columns.get(name)) for name, change in changes.items()}
    path = write_data(tmp_path, columns)
    said = refusal(capsys, "check", tmp_path)
    assert str(path) in said
    assert message in said


@pytest.mark.parametrize(("origin", "message"), BAD_ORIGINS)
def test_bad_origin_is_refused_in_one_sentence(origin, message, tmp_path, capsys):
    path = write_data(tmp_path, own_columns(), origin)
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


@pytest.mark.parametrize("missing", ["features", "actions", "effects"])
def test_missing_array_is_named(missing, tmp_path, capsys):
    columns = own_columns()
    del columns[missing]
    write_data(tmp_path, columns)
    assert f"it has no array {missing!r} (needed: features, actions, effects)" in refusal(
        capsys, "check", tmp_path
    )


def test_too_few_rows_are_refused(tmp_path, capsys):
    write_data(tmp_path, own_columns(LEAST_INTERACTIONS - 1))
    for command in ("check", "train"):
        assert "19 interactions are too few to train on; at least 20" in refusal(capsys, command, tmp_path)
    enough = Interactions.load(write_data(tmp_path, own_columns(LEAST_INTERACTIONS)))
    assert neurosym("check", tmp_path) == 0
    assert train(enough, config=BRIEF, seed=0).report.held_out == 2


@pytest.mark.parametrize("content", ["garbage", "pickle", "array", "zip", "empty", "truncated"])
def test_foreign_file_is_refused_and_nothing_is_unpickled(content, tmp_path, capsys):
    path = write_data(tmp_path, own_columns())
    whole = path.read_bytes()
    if content == "array":
        with path.open("wb") as file:
            np.save(file, np.zeros(3))
    elif content == "zip":
        with zipfile.ZipFile(path, "w") as archive:
            archive.writestr("word/document.xml", "<w/>")
    else:
        chosen = {
            "garbage": b"\x00garbage",
            "pickle": pickle.dumps([1]),
            "empty": b"",
            "truncated": whole[:900],
        }
        path.write_bytes(chosen[content])
    assert neurosym("check", tmp_path) == 2
    said = capsys.readouterr().err
    assert f"{path} cannot be used" in said
    assert "Traceback" not in said


def test_damaged_bytes_inside_an_archive_are_refused(tmp_path, capsys):
    path = tmp_path / "interactions.npz"
    np.savez_compressed(path, **own_columns())
    content = bytearray(path.read_bytes())
    content[200:260] = b"\xff" * 60
    path.write_bytes(bytes(content))
    assert "cannot be used" in refusal(capsys, "train", tmp_path)


def test_pickled_effects_are_the_only_fault_told(tmp_path, capsys):
    columns = own_columns()
    effects = columns["effects"].astype(object)
    write_data(tmp_path, {**columns, "resting_effects": columns["effects"], "effects": effects})
    said = refusal(capsys, "check", tmp_path)
    assert "'effects' is damaged, or holds Python objects" in said
    assert "resting_effects" not in said


def test_two_arrays_of_one_name_are_refused(tmp_path, capsys):
    path = write_data(tmp_path, own_columns())
    with pytest.warns(UserWarning, match="Duplicate name"), zipfile.ZipFile(path, "a") as archive:
        archive.writestr("features.npy", archive.read("features.npy"))
    assert "2 arrays 'features'; valid: one of each" in refusal(capsys, "train", tmp_path)


def test_check_lists_every_problem_in_a_line_of_its_own(tmp_path, capsys):
    columns = own_columns()
    columns["features"][:, 1] = 3.0
    columns["effects"][4, 0] = np.nan
    path = write_data(tmp_path, {**columns, "held": np.zeros(59)}, {"gripper_columns": [9]})
    assert neurosym("check", path) == 2
    lines = capsys.readouterr().err.strip().splitlines()
    assert len(lines) == 4
    assert all(line.startswith(f"{path} cannot be used: ") and line.endswith(".") for line in lines)
    for said in ("effects[4, 0]", "'held' has shape", "gripper_columns", "features[:, 1]"):
        assert sum(said in line for line in lines) == 1


def test_constant_feature_is_called_by_its_name(tmp_path, capsys):
    columns = own_columns()
    columns["features"][:, 1] = 3.0
    write_data(tmp_path, columns, {"feature_names": ["a", "mass", "c", "d", "e", "f", "g"]})
    assert "features[:, 1] (mass) is 3 in every row" in refusal(capsys, "check", tmp_path)


def test_a_problem_that_quotes_the_name_of_an_array_that_cannot_be_read_is_told_all_the_same(
    tmp_path, capsys
):
    """Names of features that are no valid ones, in a file whose features are Python objects."""
    columns = own_columns() | {"features": np.array([object()] * 60)}
    path = write_data(tmp_path, columns, {"feature_names": ["features", "features"]})
    neurosym("check", path)
    said = capsys.readouterr().err
    assert "'features' is damaged, or holds Python objects" in said
    assert "its origin has feature_names = ['features', 'features']" in said
    assert "no array 'features'" not in said
