"""What docs/world.md claims, on small samples; `make evaluate-world` measures it in full."""

import json

import numpy as np
import pytest
from places import ROOT

from tools.benchmarks.world import measures
from tools.benchmarks.world.tables import page

RESULTS = ROOT / "docs" / "results"


@pytest.mark.evaluation
def test_the_object_decides_much_of_what_an_action_does():
    found = measures.object_matters(10, 12, 103, 2)
    assert 0.0 < found["share_of_action_alone"] < 0.8
    assert all(
        abs(sum(row.values()) - row["objects"] - 1) < 0.01 for row in found["outcomes_by_kind"].values()
    )


def test_variance_is_split_as_reckoned_by_hand():
    first, rows = np.array([[0.0, 0, 0], [2.0, 0, 0]]), np.ones(2, bool)
    assert measures._surviving(np.array([first, first]), rows) == 1
    assert measures._surviving(np.array([first, first + np.array([1.0, 0, 0])]), rows) == pytest.approx(0.5)


def test_results_that_are_committed_are_whole_and_stand_in_the_page():
    found = json.loads((RESULTS / "world.json").read_text())
    assert {"predictability", "put_down_within_1cm", "hand_written", "machine"} <= found.keys()
    assert found["command"] == "make evaluate-world"
    assert (RESULTS / "world.md").read_text() == page(found)
