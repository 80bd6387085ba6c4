"""What docs/world.md claims, on small samples; `make evaluate-world` measures it in full."""

import json

import numpy as np
import pytest
from places import ROOT

RESULTS = ROOT / "docs" / "results"


def test_effects_survive_a_tenth_of_a_millimetre():
    from tools.benchmarks.world.measures import predictability

    found = predictability(60, 101, 2)
    assert found["share"] > 0.95
    assert set(found["by_shape"]) == {"solid", "plank", "open-topped", "ring"}


def test_the_object_decides_much_of_what_an_action_does():
    from tools.benchmarks.world.measures import object_matters

    found = object_matters(10, 12, 103, 2)
    assert 0.0 < found["share_of_action_alone"] < 0.8
    assert all(
        abs(sum(row.values()) - row["objects"] - 1) < 0.01 for row in found["outcomes_by_kind"].values()
    )


def test_among_eight_objects_bystanders_are_watched():
    from tools.benchmarks.world.measures import several_objects

    found = several_objects(12, 8, 106, 2)
    assert found["robot_touched_a_bystander"] > 0
    assert found["a_bystander_moved"] > 0


def test_variance_is_split_as_reckoned_by_hand():
    from tools.benchmarks.world.measures import _surviving

    first = np.array([[0.0, 0, 0], [2.0, 0, 0]])
    assert _surviving(np.array([first, first]), np.ones(2, bool)) == 1
    assert _surviving(np.array([first, first + np.array([1.0, 0, 0])]), np.ones(2, bool)) == pytest.approx(
        0.5
    )


def test_bench_tells_speed_and_memory():
    from tools.benchmarks.world.bench import bench

    found = bench(8, 8, 1 / 240)
    assert 0.3 < found["share_of_raw_stepping"] <= 1.1
    assert found["speedup_2_workers"] > 0
    assert found["memory_mb_a_worker"] > 0


def test_results_that_are_committed_are_whole_and_stand_in_the_page():
    from tools.benchmarks.world.tables import page

    found = json.loads((RESULTS / "world.json").read_text())
    assert {
        "predictability",
        "share_of_raw_stepping",
        "speedup_2_workers",
        "put_down_within_1cm",
        "hand_written",
        "machine",
        "command",
    } <= found.keys()
    assert found["command"] == "make evaluate-world"
    assert (RESULTS / "world.md").read_text() == page(found)
