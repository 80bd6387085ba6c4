"""How one object stands to another, in numbers: hand-made scenes."""

import numpy as np
import pytest

from neurosym.pair_operators import FARTHEST, describe_pair, extent, tilt, touching_units
from neurosym.world import Scene

UPRIGHT = (0.0, 0.0, 0.0, 1.0)
CUBE, PLATE = (0.04, 0.04, 0.04, 0.0), (0.16, 0.12, 0.02, 0.0)


def scene(*rows: tuple[tuple[float, ...], tuple[float, ...], tuple[float, ...]]) -> Scene:
    """Make a scene of objects with features, position and orientation."""
    return Scene(*(np.array(column, dtype=float) for column in zip(*rows, strict=True)))


STACK = scene((CUBE, (0.5, 0.0, 0.04), UPRIGHT), (PLATE, (0.5, 0.0, 0.01), UPRIGHT))


def test_what_stands_on_another_is_one_touching_unit_above_it():
    np.testing.assert_allclose(touching_units(STACK, 0, 1), (0, 0, 1), atol=1e-9)
    np.testing.assert_allclose(describe_pair(STACK, 0, 1, ((0, 1),)), (0, 1, 1, 0, 0), atol=1e-6)
    np.testing.assert_allclose(describe_pair(STACK, 1, 0, ((0, 1),)), (0, -1, 1, 0, 0), atol=1e-6)


def test_what_is_far_away_is_no_farther_than_the_most():
    apart = scene((CUBE, (0.3, 0.3, 0.02), UPRIGHT), (CUBE, (0.9, -0.3, 0.02), UPRIGHT))
    np.testing.assert_allclose(describe_pair(apart, 0, 1, ()), (FARTHEST, 0, 0, 0, 0), atol=1e-9)


def test_sizes_are_those_along_the_axes_of_the_world():
    quarter = (0.0, 0.0, np.sqrt(0.5), np.sqrt(0.5))
    np.testing.assert_allclose(extent(scene((PLATE, (0, 0, 0), quarter)), 0), (0.12, 0.16, 0.02), atol=1e-9)


@pytest.mark.parametrize(("degrees", "expected"), [(0, 0.0), (5, 5.0), (90, 0.0), (45, 20.05)])
def test_tilt_is_counted_from_the_nearest_face_and_bounded(degrees: float, expected: float):
    half = np.radians(degrees) / 2
    leaning = scene((CUBE, (0, 0, 0), (np.sin(half), 0.0, 0.0, np.cos(half))))
    assert np.degrees(tilt(leaning, 0)) == pytest.approx(expected, abs=0.01)
