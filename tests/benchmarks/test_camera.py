"""What objects that are seen come to beside objects that are known: how it is summed up and told."""

import json

import numpy as np
import pytest
from places import ROOT

from neurosym.perception.regions import Region
from neurosym.world import Scene
from tools.benchmarks.camera.seeing import _error
from tools.benchmarks.camera.summary import page, summarise

GOAL, LOST = {"reached": True}, {"reached": False}
FOUND = {
    "seen-still": {
        "position": [0.5, 1.2],
        "size": [1.0, 3.0],
        "heading": [0.3, 20.0],
        "scenes": 4,
        "miscounted": 1,
        "look_ms": 7.0,
        "interaction_ms": 70.0,
    },
    "same-1": {
        "features": {"direct_r2": 0.7, "r2": 0.42, "share": 0.6},
        "images": {"direct_r2": 0.6, "r2": 0.3, "share": 0.5},
    },
    "learn-features-1": {"cpu": 60.0, "interactions": 100, "kinds": ["lift"], "r2": 0.4, "direct_r2": 0.7},
    "learn-images-1": {"cpu": 90.0, "interactions": 90, "kinds": ["lift"], "r2": 0.3, "direct_r2": 0.6},
    "try-images-1-single-0": [
        {"blind": GOAL, "replanned": GOAL},
        {"blind": LOST, "replanned": GOAL},
        {"status": "unsolvable"},
    ],
    "try-noisy-1-single-0": [{"blind": LOST, "replanned": GOAL}],
    "relate-images-1": {"interactions": 13_000, "words": {}},
    "tower-images-1-0": [{"status": "solved", "reached": True, "blind": True}, {"status": "unsolvable"}],
    "agree-1": [["00", "00", "01"], ["1", "1", "0"]],
    "shape-images-wedge": [True, False],
}


def test_found_is_summed_up_and_told():
    told = summarise(FOUND)
    assert told["drawn"] == {"blind": pytest.approx(1 / 3), "replanned": pytest.approx(2 / 3)}
    assert told["seen_mm"] == {"position": 0.5, "size": 1.0}
    assert (told["share"], told["direct_r2"], told["cpu_ratio"], told["noisy_replanned"]) == (
        0.5,
        0.6,
        1.5,
        1,
    )
    assert told["towers_3"] == 0.5
    assert told["anywhere"] == {"1": None, "4": None}
    assert told["agree"][0]["index"] == 1
    said = page(told)
    assert "| still | 0.5, 1.2 | 1.0, 3.0 | 0.3, 20.0 | 1 of 4 | 7.0 of 70 |" in said
    assert "| images | 1 | 0.600 | 0.300 | 0.500 |" in said
    assert "| wedge | - | 1 of 2 |" in said
    assert "| images | 2 | 50 % (9 to 91) | 50 % (9 to 91) | 13,000 |" in said
    assert "| 00 | 0 | 2 |" in said


def test_nothing_found_is_told_too():
    assert "not measured yet" in page(summarise({}))


@pytest.mark.parametrize("turn", [0.0, 1.2, 2.0])
def test_sides_of_an_object_change_places_where_it_lies_across(turn: float):
    half = turn / 2
    scene = Scene(
        np.array([[0.1, 0.05, 0.04, 0.0]]),
        np.array([[0.6, 0.0, 0.02]]),
        np.array([[0.0, 0.0, np.sin(half), np.cos(half)]]),
    )
    heading = (turn + np.pi / 4) % (np.pi / 2) - np.pi / 4
    across = np.pi / 4 < turn < 3 * np.pi / 4
    size = np.array([0.05, 0.1, 0.04] if across else [0.1, 0.05, 0.04])
    region = Region(np.array([0.603, 0.0, 0.02]), heading, size, np.zeros((32, 32)), 0.0)
    assert _error([region], scene, 0)[0] == pytest.approx((3, 0, 0), abs=1e-6)
    assert _error([], scene, 0) == []


def test_the_page_is_that_of_the_figures():
    results = ROOT / "docs" / "results"
    assert page(json.loads((results / "camera.json").read_text())) == (results / "camera.md").read_text()
