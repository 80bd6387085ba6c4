"""Data of one's own that are right: what `check` shows and notes, and what is loaded."""

import json

import numpy as np
import pytest
from command_line import neurosym, refusal
from own_data import own_columns, write_data

from neurosym.data.interactions import Interactions
from neurosym.data.origin import LEAST_INTERACTIONS, mirrors_of, training_problems
from neurosym.errors import InvalidFile
from neurosym.exploration.loop import origin_of_world
from neurosym.world import Mirror
from neurosym.worlds.toy import make_world


def test_check_shows_good_data_and_what_to_type_next(tmp_path, capsys):
    path = write_data(tmp_path, own_columns(), {"gripper_columns": [4]})
    assert neurosym("check", tmp_path) == 0
    said = capsys.readouterr().out
    for part in ("60 interactions", "features[:, 6]", "gripper 5", "e2", "above 0.01: 100%", "held 0%"):
        assert part in said
    assert "note:" not in said
    assert f"next: neurosym train {tmp_path}" in said
    elsewhere = path.rename(tmp_path / "mine.npz")
    assert neurosym("check", elsewhere) == 0
    assert f"cp {elsewhere} my-domain/interactions.npz && neurosym train my-domain" in capsys.readouterr().out


def test_check_notes_what_may_not_be_meant(tmp_path, capsys):
    columns = own_columns()
    columns["features"][:, 0] *= 1e-4
    columns["effects"][:, 1] = 0.0
    columns["effects"][:, 0] *= 1000
    columns["actions"][:, 4] *= 2
    held = np.arange(60) % 2 == 0
    origin = {"gripper_columns": [4], "feature_name": ["a"], "robot": "pusher"}
    write_data(tmp_path, {**columns, "held": held, "heights": held, "lost": np.ones(60)}, origin)
    assert neurosym("check", tmp_path) == 0
    notes = [line for line in capsys.readouterr().out.splitlines() if line.startswith("note:")]
    for said in (
        "'heights' is not read",
        "features[:, 0] varies",
        "effects[:, 1] never",
        "'resting_effects'",
        "actions[:, 4] leaves the range from 0 (closed) to 1 (open)",
        "'lost' is true in every row",
        "effects reach 100, but an outcome counts as promised within 0.05",
        "the entry 'feature_name' of the origin is not read, but 'feature_names' is",
    ):
        assert sum(said in note for note in notes) == 1
    assert len(notes) == 8


def test_check_refuses_what_is_not_there(tmp_path, capsys):
    assert "or a script of yours (docs/data.md)" in refusal(capsys, "check", tmp_path)
    assert "no such file or folder" in refusal(capsys, "check", tmp_path / "none.npz")


EXPLORED = {"world": "toy", "strategy": "random", "seed": 0} | dict.fromkeys(
    ("candidates", "block", "learning", "model")
)


def test_explored_data_may_hold_a_column_fixed():
    columns = {**own_columns(), "features": np.ones((60, 7))}
    assert len(training_problems(columns, {})) == 7
    assert training_problems(columns, EXPLORED) == []


def test_rows_that_the_strategy_does_not_learn_from_do_not_count():
    columns = own_columns()
    columns["effects"][LEAST_INTERACTIONS - 1 :] = 0.001
    assert training_problems(columns, {}) == []
    (said,) = training_problems(columns, {**EXPLORED, "strategy": "active"})
    assert said.startswith("of its 60 interactions, 'active' learns from few: 19 interactions are too few")


def test_effects_too_small_to_tell_apart_are_pointed_out(tmp_path, capsys):
    columns = own_columns()
    columns["effects"] *= 0.001
    write_data(tmp_path, columns)
    assert neurosym("check", tmp_path) == 0
    assert "note: effects reach 0.0001 only, and every outcome counts" in capsys.readouterr().out


def test_explored_data_have_no_problems(folder, capsys):
    assert neurosym("check", folder) == 0
    assert "1024 interactions" in capsys.readouterr().out


def test_integers_flags_as_numbers_and_bounds_of_the_box_are_valid(tmp_path):
    columns = own_columns()
    columns |= {"features": (100 * columns["features"]).astype(np.int16), "held": np.ones(60)}
    box = {"action_low": columns["actions"].min(0).tolist(), "action_high": [1, 1, 1, 1, 1]}
    data = Interactions.load(write_data(tmp_path, columns, box))
    assert data.held.all()
    assert data.features.dtype == np.float32
    assert data.origin == box


def test_missing_columns_are_filled_in(tmp_path):
    data = Interactions.load(write_data(tmp_path, own_columns()))
    assert data.resting_effects.tobytes() == data.effects.tobytes()
    assert not (data.held | data.toppled | data.lost).any()


def test_what_was_saved_is_loaded(tmp_path):
    data = Interactions.load(write_data(tmp_path, own_columns(), {"robot": "mine"}))
    data.save(tmp_path / "again.npz")
    again = Interactions.load(tmp_path / "again.npz")
    assert all(again.columns[name].tobytes() == column.tobytes() for name, column in data.columns.items())
    assert again.origin == {"robot": "mine"}
    assert json.loads(str(np.load(tmp_path / "again.npz")["origin"]))["format"] == "neurosym-interactions-1"


def test_load_names_the_first_problem(tmp_path):
    columns = own_columns()
    columns["effects"][4, 0] = columns["features"][9, 3] = np.nan
    with pytest.raises(InvalidFile, match=r"features\[9, 3\] is nan") as refused:
        Interactions.load(write_data(tmp_path, columns))
    assert "effects" not in str(refused.value)


def test_mirrors_of_a_data_set_are_read_and_those_of_an_exploration_are_its_worlds(tmp_path):
    given = [{"actions": [0, 2], "effects": [0]}, {"actions": [1], "effects": []}]
    data = Interactions.load(write_data(tmp_path, own_columns(), {"mirrors": given}))
    assert mirrors_of(data.origin) == (Mirror((0, 2), (0,)), Mirror((1,), ()))
    assert mirrors_of({}) == ()
    world = make_world()
    assert mirrors_of(json.loads(json.dumps(origin_of_world(world)))) == world.action_box.mirrors
