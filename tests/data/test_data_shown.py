"""Data of one's own that are right: what `check` shows and notes, and what is loaded."""

import json

import numpy as np
from command_line import neurosym, refusal
from own_data import own_columns, write_data
from toy_domain import LIFT, WORLD, problem

from neurosym.data.interactions import Interactions
from neurosym.data.origin import LEAST_INTERACTIONS, training_problems


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
        "effects reach 100, but in a world every outcome counts as promised within 0.05",
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


def test_explored_data_may_hold_a_column_fixed_and_only_rows_that_are_learned_from_count():
    columns = {**own_columns(), "features": np.ones((60, 7))}
    assert len(training_problems(columns, {})) == 7
    assert training_problems(columns, EXPLORED) == []
    columns = own_columns()
    columns["effects"][LEAST_INTERACTIONS - 1 :] = 0.001
    assert training_problems(columns, {}) == []
    (said,) = training_problems(columns, {**EXPLORED, "strategy": "active"})
    assert said.startswith("of its 60 interactions, 'active' learns from few: 19 interactions are too few")


def test_what_is_too_small_to_tell_apart_is_pointed_out(tmp_path, capsys):
    columns = own_columns()
    columns["effects"] *= 0.001
    columns["actions"] *= 0.01
    write_data(tmp_path, columns, {"gripper_columns": [4]})
    assert neurosym("check", tmp_path) == 0
    said = capsys.readouterr().out
    assert "note: effects reach only 0.0001, but in a world every outcome counts" in said
    assert "the gripper value actions[:, 4] leaves the range from 0 (closed) to 1 (open), or never" in said


def test_integers_flags_as_numbers_and_bounds_of_the_box_are_valid_and_the_rest_is_filled_in(tmp_path):
    columns = own_columns()
    columns |= {"features": (100 * columns["features"]).astype(np.int16), "held": np.ones(60)}
    box = {"action_low": columns["actions"].min(0).tolist(), "action_high": [1, 1, 1, 1, 1]}
    data = Interactions.load(write_data(tmp_path, columns, box))
    assert data.held.all()
    assert data.features.dtype == np.float32
    assert data.origin == box
    assert data.resting_effects.tobytes() == data.effects.tobytes()
    assert not (data.toppled | data.lost).any()
    data.save(tmp_path / "again.npz")
    again = Interactions.load(tmp_path / "again.npz")
    assert all(again.columns[name].tobytes() == column.tobytes() for name, column in data.columns.items())
    assert again.origin == box
    assert json.loads(str(np.load(tmp_path / "again.npz")["origin"]))["format"] == "neurosym-interactions-1"


def test_rows_hold_what_each_outcome_says_of_its_target():
    scene, action = problem({}).scene(), np.array(LIFT)
    outcomes = [WORLD.interact(scene, action, target) for target in (0, 1)]
    data = Interactions.from_outcomes(outcomes, np.stack([action, action]), {})
    for row, outcome in enumerate(outcomes):
        np.testing.assert_allclose(data.features[row], scene.features[outcome.target])
        np.testing.assert_allclose(data.effects[row], outcome.effect, atol=1e-7)
        np.testing.assert_allclose(data.resting_effects[row], outcome.resting_effect, atol=1e-7)
        assert (data.held[row], data.lost[row]) == (outcome.held, outcome.lost)
        assert data.peak_heights[row] == np.float32(outcome.peak_height)
    assert data.held.all()
    assert (data.effects[:, 2] > 0.1).all()  # in the air
    assert (np.abs(data.resting_effects) < 1e-6).all()  # and back where it was
