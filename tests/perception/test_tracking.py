"""Known objects meet what is seen."""

import math

import numpy as np
import pytest
from perception.boxes import Box, sight_of
from scipy.spatial.transform import Rotation

from neurosym.perception.regions import regions_of, track

LONG, CUBE = (0.12, 0.05, 0.03), (0.06, 0.06, 0.07)
UPRIGHT = np.array([0.0, 0.0, 0.0, 1.0])


def tracked(boxes: list[Box], sizes: list[tuple[float, float, float]], at: list[tuple[float, ...]], **kwargs):
    positions = np.array([[x, y, size[2] / 2] for (x, y), size in zip(at, sizes, strict=True)])
    return track(
        regions_of(sight_of(boxes)), np.array(sizes), positions, np.tile(UPRIGHT, (len(at), 1)), **kwargs
    )


def test_objects_keep_their_names_though_one_moved_far():
    boxes = [Box((0.85, -0.2), LONG, math.radians(15)), Box((0.5, 0.1), CUBE)]
    found = tracked(boxes, [LONG, CUBE], [(0.45, 0.2), (0.5, 0.1)], target=0)
    assert found.is_seen == (True, True)
    assert found.positions == pytest.approx(np.array([[0.85, -0.2, 0.015], [0.5, 0.1, 0.035]]), abs=0.004)
    turned = Rotation.from_quat(found.orientations[0]).as_euler("zyx", degrees=True)
    assert turned == pytest.approx([15, 0, 0], abs=2.5)


def test_twins_stay_where_they_were():
    boxes = [Box((0.5, 0.1), CUBE), Box((0.8, 0.1), CUBE)]
    found = tracked(boxes, [CUBE, CUBE], [(0.79, 0.1), (0.51, 0.1)])
    assert found.positions[:, 0] == pytest.approx([0.8, 0.5], abs=0.004)


def test_one_that_toppled_is_told_by_its_extents():
    found = tracked([Box((0.6, 0.0), (0.03, 0.05, 0.12))], [LONG], [(0.6, 0.05)], target=0)
    (turn,) = Rotation.from_quat(found.orientations)
    assert np.abs(turn.as_matrix()) @ LONG == pytest.approx([0.03, 0.05, 0.12], abs=1e-6)
    assert found.positions[0, 2] == pytest.approx(0.06, abs=0.002)


def test_objects_that_touch_are_not_told_apart_and_stay_where_they_were():
    boxes = [Box((0.5, 0.1), CUBE), Box((0.56, 0.1), CUBE), Box((0.8, 0.0), LONG)]
    at = [(0.5, 0.1), (0.56, 0.1), (0.8, 0.01)]
    found = tracked(boxes, [CUBE, CUBE, LONG], at)
    assert found.is_seen == (False, False, True)
    assert found.positions[:2, :2] == pytest.approx(np.array(at[:2]))


def test_nothing_seen_moves_nothing():
    found = tracked([], [CUBE], [(0.5, 0.1)])
    assert found.is_seen == (False,)
