"""The pieces of the evaluation with data of any kind, on a tiny budget."""

import json
from dataclasses import replace
from importlib.util import find_spec

import numpy as np
import pytest
from places import ROOT

from neurosym.data.interactions import Interactions
from tools.benchmarks.any_data import evaluate, way
from tools.benchmarks.any_data.grid import MOVES, Grid
from tools.benchmarks.any_data.sets import SETS, tasks_of, write_rows

WORLDS = [name for name, one in SETS.items() if one.world]


@pytest.mark.parametrize("name", WORLDS)
def test_rows_of_each_world_are_random_moves_from_random_states(name, tmp_path):
    if name == "pushing" and not find_spec("panda_gym"):
        pytest.skip("panda-gym is not here")
    for number in range(2):
        write_rows(SETS[name], tmp_path / f"{number}.csv", 5, seed=number)
    one, other = ((tmp_path / f"{number}.csv").read_text().splitlines() for number in range(2))
    assert one[0] == other[0]
    assert len(one) == 6
    assert one[1:] != other[1:]


def test_the_door_of_the_grid_opens_for_who_has_the_key():
    world, state = Grid(), np.array([0.0, 2, 0, 0])
    for move in ("take", "east", "east", "north", "east"):
        state = world.step(state, np.eye(len(MOVES))[MOVES.index(move)])
    assert state.tolist() == [2, 1, 1, 0]
    for move in ("unlock", "east", "east"):
        state = world.step(state, np.eye(len(MOVES))[MOVES.index(move)])
    assert state.tolist() == [4, 1, 1, 1]


def test_a_room_goes_the_whole_way(tmp_path, monkeypatch):
    monkeypatch.setitem(way.SETS, "thermostat", replace(SETS["thermostat"], rows=400, bits=(2, 3)))
    monkeypatch.setattr(way, "tasks_of", lambda *_: [((19.0, 0.0, 1.0), {"mode": 0})])
    found = way.measured("thermostat", tmp_path / "room", 1, None, "--regime", "quick")
    assert found["rows"] == 400
    assert found["r2_trivial"] < 0.1 < found["r2_direct"]
    assert 0 < found["kept"] <= found["judged"] <= found["operators"]
    (task,) = found["tasks"]
    assert task["valid"]
    assert task["replanned"]["reached"]
    told = evaluate.summary({"thermostat-1": found})
    assert told["thermostat"]["planned"] == 1
    page = evaluate.page({**told, "missing": ["deepsym-push: is not here"], "machine": {"torch": "2"}})
    assert "a room with a window and a thermostat" in page
    assert "Not measured here: deepsym-push: is not here." in page


def test_goals_without_a_world_are_what_two_rows_of_a_thing_add_up_to():
    features = np.repeat(np.eye(6)[:2], 20, axis=0).astype(np.float32)
    effects = np.tile([1.0, 0.0, 0.0], (40, 1)).astype(np.float32)
    none = np.zeros(40, dtype=bool)
    data = Interactions(
        features, np.eye(3, dtype=np.float32)[np.arange(40) % 3], effects, effects, none, none, none,
        np.zeros(40, dtype=np.float32),
    )  # fmt: skip
    tasks = tasks_of(SETS["deepsym-pairs"], data, 1)
    assert len(tasks) == 10
    assert {json.dumps(goals) for _, goals in tasks} == {'{"x": [1.9, 2.1], "y": [-0.1, 0.1]}'}


def test_what_is_missing_is_said(tmp_path, monkeypatch):
    monkeypatch.setattr(evaluate.learners, "NEEDS", ("macq", "no_such_package"))
    jobs, missing = evaluate.jobs_of(tmp_path, None)
    assert "grid-1" in jobs
    assert not [name for name in jobs if name.startswith("deepsym")]
    assert any("by --deepsym" in said for said in missing)
    assert any("needs macq, no_such_package" in said for said in missing)


def test_the_discs_of_the_guide_are_told_of_by_how_they_were_trained():
    run = {"r2_bits": 0.9, "pairs": 20, "pairs_kept": 18, "judged": 12, "kept": 11}
    errors = {"mae": {"model": 0.1, "always zero": 0.5}}
    told = evaluate.summary({"discs-1": {**run, **errors}, "discs-quick-2": {**run, **errors}})
    page = evaluate.page({**told, "missing": [], "machine": {}})
    for typed in ("train", "train --regime quick"):
        assert f"| {typed} | 20 % | 18 of 20 | 11 of 12 |" in page


def test_the_published_page_tells_what_was_measured():
    results = ROOT / "docs/results"
    told = json.loads((results / "any-data.json").read_text())
    assert evaluate.page(told) == (results / "any-data.md").read_text()
