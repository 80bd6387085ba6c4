"""Tables as people have them become interactions; what cannot be learned from is refused by its column."""

from pathlib import Path

import numpy as np
import pytest
import torch
from safetensors.numpy import save_file

from neurosym.data.axes import Axis, axes_in
from neurosym.data.foreign_tables import read_interactions
from neurosym.data.origin import warnings_about
from neurosym.errors import InvalidFile, InvalidValue

ROWS = 40
RNG = np.random.default_rng(0)
STATES = RNG.uniform(0, 6, (ROWS, 2))
AFTER = (STATES + np.array([0.5, 0.0])) % np.array([6.0, 100.0])
MOVES = RNG.integers(0, 3, ROWS)
MAPPING = """
features = ["obs"]
choices = ["act"]
after = ["next"]
[names]
obs = ["angle", "speed"]
[[axes]]
name = "angle"
kind = "angle"
period = 6.0
"""


def csv(path: Path, header: str, rows) -> Path:
    path.write_text("\n".join([header, *(",".join(map(str, row)) for row in rows)]))
    return path


def test_names_of_columns_say_what_they_are(tmp_path):
    rows = [(f"{mass:.3f}", "yes" if speed > 3 else "no", "abc"[move], move * mass, 1)
            for (mass, speed), move in zip(STATES, MOVES, strict=True)]  # fmt: skip
    header = "feature.mass,feature.Door open,choice.gear,after.mass,after.Door open"
    found = read_interactions(csv(tmp_path / "a.csv", header, rows))
    assert found.origin["feature_names"] == ["mass", "Door open"]
    assert found.origin["action_names"] == ["gear=a", "gear=b", "gear=c"]
    assert axes_in(found.origin["axes"], 2) == (Axis("mass"), Axis("door-open", "flag"))
    assert found.actions.sum(1).tolist() == [1] * ROWS
    np.testing.assert_allclose(found.effects[:, 0], MOVES * STATES[:, 0] - STATES[:, 0], atol=1e-3)
    assert set(found.effects[:, 1].tolist()) == {0, 1}
    again = csv(tmp_path / "b.csv", header.replace(",", ";"), [[";".join(map(str, row))] for row in rows])
    np.testing.assert_array_equal(read_interactions(again).effects, found.effects)


def write(path: Path) -> None:
    arrays = {"obs": STATES, "next": AFTER, "act": MOVES}
    if path.suffix == ".npz":
        np.savez(path, **arrays)
    elif path.suffix == ".npy":
        kinds = [("obs", float, 2), ("next", float, 2), ("act", int)]
        np.save(path, np.array([*zip(STATES, AFTER, MOVES, strict=True)], dtype=kinds))
    elif path.suffix == ".pt":
        torch.save({name: torch.tensor(array) for name, array in arrays.items()}, path)
    else:
        save_file(arrays, path)


@pytest.mark.parametrize("suffix", [".npz", ".npy", ".pt", ".safetensors"])
def test_a_mapping_says_it_of_arrays_and_angles_come_round(tmp_path, suffix):
    table, columns = tmp_path / f"runs{suffix}", tmp_path / "columns.toml"
    write(table)
    columns.write_text(MAPPING)
    found = read_interactions(table, columns)
    assert found.effects.shape == (ROWS, 1)
    np.testing.assert_allclose(found.effects, 0.5, atol=1e-5)
    columns.write_text('features = ["obs[0:2]"]\nactions = ["act"]\neffects = ["next[1]"]\n')
    found = read_interactions(table, columns)
    assert found.origin["feature_names"] == ["obs0", "obs1"]
    np.testing.assert_allclose(found.effects[:, 0], AFTER[:, 1], rtol=1e-6)


def test_the_next_row_of_an_episode_says_what_came_of_one(tmp_path):
    table, columns = tmp_path / "runs.npz", tmp_path / "columns.toml"
    np.savez(table, obs=STATES, act=MOVES, run=np.arange(ROWS) // 10)
    columns.write_text('features = ["obs"]\nchoices = ["act"]\nepisode = "run"\n')
    found = read_interactions(table, columns)
    kept = np.flatnonzero(np.arange(ROWS) % 10 < 9)
    np.testing.assert_allclose(found.features, STATES[kept], rtol=1e-6)
    np.testing.assert_allclose(found.effects, STATES[kept + 1] - STATES[kept], atol=1e-5)
    named = csv(tmp_path / "a.csv", "feature.x,choice.a,episode", [(x, 1, x > 8) for x in range(30)])
    np.testing.assert_array_equal(read_interactions(named).effects, np.ones((28, 1)))


def test_axes_alone_leave_columns_to_their_names_and_no_column_goes_unsaid(tmp_path):
    rows = [(angle, move, 0, (angle + 0.5) % 6, int(move == 1), "left") for (angle, _), move in
            zip(STATES, MOVES, strict=True)]  # fmt: skip
    header = "feature.angle,choice.move,feature.lit,after.angle,after.lit,remark"
    table, said = csv(tmp_path / "a.csv", header, rows), list[str]()
    (tmp_path / "axes.toml").write_text('[[axes]]\nname = "angle"\nkind = "angle"\nperiod = 6\n')
    found = read_interactions(table, tmp_path / "axes.toml", said.append)
    assert axes_in(found.origin["axes"], 2) == (Axis("angle", "angle", period=6), Axis("lit", "flag"))
    np.testing.assert_allclose(found.effects[:, 0], 0.5, atol=1e-5)
    assert said == ["columns that are left out: remark"]
    turning = "angle sometimes changes by nearly all of its range; is it an angle?"
    assert turning not in warnings_about(found.columns, found.origin, ())
    back = [(angle, 0, 0, (angle - 0.5) % 6, 0, "right") for angle, _ in STATES]
    both = read_interactions(csv(tmp_path / "b.csv", header, rows + back))
    assert turning in warnings_about(both.columns, both.origin, ())
    listed = 'features = ["feature.angle", "feature.lit"]\nchoices = ["choice.move"]\nafter = ["after.lit"]\n'
    (tmp_path / "columns.toml").write_text(listed)
    found = read_interactions(table, tmp_path / "columns.toml")
    assert axes_in(found.origin["axes"], 1) == (Axis("lit", "flag"),)
    (tmp_path / "bare.toml").write_text('[[axes]]\nname = "lit"\n[[axes]]\nname = "angle"\n')
    found = read_interactions(table, tmp_path / "bare.toml")
    assert axes_in(found.origin["axes"], 2) == (Axis("angle"), Axis("lit", "flag"))


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"actions": np.zeros((40, 2))}, "actions has 40 rows, and others have 50; valid: as many"),
        ({"features": np.full((50, 2), np.inf)}, r"The column features holds inf in row 0 \(from 0\)"),
        ({"features": np.array([["left", "right"]] * 50)}, "a column of 0 and 1 for each word"),
    ],
)
def test_columns_that_do_not_fit_are_named(tmp_path, change, said):
    whole = {name: np.arange(100.0).reshape(50, 2) for name in ("features", "actions", "effects")}
    np.savez(tmp_path / "own.npz", **(whole | change))
    with pytest.raises(InvalidFile, match=said):
        read_interactions(tmp_path / "own.npz")


def test_whole_numbers_that_may_be_choices_are_told_of(tmp_path):
    rng = np.random.default_rng(0)
    columns = {"feature.mass": rng.random(60), "effect.x": rng.random(60)}
    columns["action.gear"] = rng.integers(1, 5, 60)
    np.savez(tmp_path / "own.npz", **columns)
    found = read_interactions(tmp_path / "own.npz")
    (said,) = (one for one in warnings_about(found.columns, found.origin, ()) if "choice" in one)
    assert said.startswith("gear holds only 4 whole numbers;")
    assert "name it choice.gear" in said


@pytest.mark.parametrize(
    ("mapping", "said"),
    [
        (MAPPING.replace("[names]", 'episode = "act"\n[names]'), "leave out effects and after"),
        ('features = ["obs"]\nactions = ["act"]\nepisode = "next[0]"\n', "No row follows another"),
        ('features = ["obs"]\nactions = ["act"]\n', "must name effects"),
        ('features = ["obs"]\neffects = ["next"]\n', "names no actions"),
        ('actions = ["act"]\neffects = ["next"]\n', "names no features"),
        ('features = ["nothing"]\nactions = ["act"]\neffects = ["next"]\n', "no column nothing"),
        ('features = ["obs[1:4]"]\nactions = ["act"]\neffects = ["next"]\n', "are no columns of obs"),
        ('features = ["obs"]\nchoices = ["next"]\neffects = ["next"]\n', "has 2 columns"),
        ('features = ["obs"]\nactions = ["act"]\nafter = ["act"]\n', "after has 1 columns"),
        ('features = ["obs"]\nactions = ["act"]\nafter = {x = "act"}\n', "x, which is no feature"),
        (MAPPING.replace('"angle"\nkind', '"height"\nkind'), "an axis height"),
        (MAPPING.replace("period = 6.0", ""), "no period"),
        ("features = 1\n", "Expected `array`"),
    ],
)
def test_a_mapping_that_cannot_be_is_refused(tmp_path, mapping, said):
    table, columns = tmp_path / "runs.npz", tmp_path / "columns.toml"
    write(table)
    columns.write_text(mapping)
    with pytest.raises(InvalidFile, match=said):
        read_interactions(table, columns)


def test_tables_that_cannot_be_are_refused(tmp_path):
    words = [("heavy", 1, 2)] * ROWS
    for name, header, rows, said in (
        ("words.csv", "feature.mass,action.a,effect.x", words, "mass is text, as 'heavy'"),
        ("names.csv", "mass,a,x", words, "feature.mass, action.speed"),
        ("short.csv", "feature.mass,action.a,effect.x", [(1, 2)], "row 2 has 2 entries"),
        ("twice.csv", "feature.mass,feature.mass,effect.x", words, "two columns are called feature.mass"),
        ("many.csv", "feature.mass,choice.a,effect.x", [(1, n, 3) for n in range(65)], "holds 65 choices"),
        ("part.csv", "feature.mass,choice.a,effect.x", [(1, 0.5, 3)] * ROWS, "holds 0.5; valid: whole"),
        ("table.xls", "", [], "none of the tables"),
    ):
        with pytest.raises(InvalidFile, match=said):
            read_interactions(csv(tmp_path / name, header, rows))
    torch.save({"obs": Path()}, tmp_path / "evil.pt")
    np.save(tmp_path / "objects.npy", np.array([{}], dtype=object), allow_pickle=True)
    for name in ("evil.pt", "objects.npy"):
        with pytest.raises(InvalidFile, match="unpickled"):
            read_interactions(tmp_path / name)


@pytest.mark.parametrize(
    ("axis", "said"),
    [
        ({"name": "x", "cell": 0}, "a cell of 0"),
        ({"name": "turn", "kind": "angle"}, "no period"),
        ({"name": "turn", "period": 3}, "a period, and is a length"),
        ({"name": "turn", "kind": "angle", "period": 6.0, "high": 6}, "comes round"),
        ({"name": "x", "low": 1, "high": 1}, "the first below the second"),
        ({"name": "x", "low": 0, "high": 1, "cell": 2}, "room for one cell"),
        ({"name": "x", "low": 0, "high": 1, "cell": 1e-6}, "1000000 cells"),
        ({"name": "x", "cell": 1, "tolerance": 0.1}, "under half of its cell"),
        ({"name": "turn", "kind": "angle", "period": 6.0, "cell": 4}, "a cell of 4, beyond half"),
        ({"name": "turn", "kind": "angle", "period": 6.0, "tolerance": 5}, "a tolerance of 5, beyond half"),
        ({"name": "x", "cell": "big"}, "has cell = 'big'; valid: a number"),
        ({"name": "x", "cel": 1}, "has a cel; valid: name, kind"),
        ({"unit": "m"}, "has no name"),
        ("x", "valid: a table"),
        ({"name": "open", "kind": "flag", "cell": 1}, "none of these for 0 and 1"),
        ({"name": "X y"}, "has name = 'X y'; valid: a lower-case letter"),
        ({"name": "x", "kind": "colour"}, "axis of effects"),
    ],
)  # fmt: skip
def test_axes_that_cannot_be_are_refused(axis, said):
    with pytest.raises(InvalidValue, match=said):
        axes_in([axis])
    with pytest.raises(InvalidValue, match="effects have 2 columns"):
        axes_in([{"name": "x"}], 2)
    with pytest.raises(InvalidValue, match="Two axes"):
        axes_in([{"name": "x"}, {"name": "x"}])
