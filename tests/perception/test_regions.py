"""Objects in depth images that were reckoned, not rendered."""

import math
from dataclasses import replace

import numpy as np
import pytest
from perception.boxes import Box, sight_of

from neurosym.errors import InvalidValue
from neurosym.perception.regions import CELL, CELLS, Sight, regions_of

CUBE = Box((0.6, 0.1), (0.10, 0.06, 0.08))


@pytest.mark.parametrize("turn", [0.0, 10.0, 30.0, -40.0])
@pytest.mark.parametrize("at", [(0.65, 0.0), (0.42, 0.22), (0.9, -0.28)])
def test_a_box_is_seen_where_it_stands_and_as_large_as_it_is(at: tuple[float, float], turn: float):
    (seen,) = regions_of(sight_of([CUBE._replace(at=at, turn=math.radians(turn))]))
    assert seen.position == pytest.approx([*at, 0.04], abs=0.003)
    assert seen.size == pytest.approx(CUBE.size, abs=0.006)
    assert math.degrees(seen.heading) == pytest.approx(turn, abs=2.5)
    assert seen.doubt < 0.2


def test_boxes_apart_are_told_apart_and_boxes_that_touch_are_doubted():
    other = CUBE._replace(at=(0.8, -0.2))
    assert len(regions_of(sight_of([CUBE, other]))) == 2
    corner = CUBE._replace(at=(CUBE.at[0] + 0.09, CUBE.at[1] + 0.055))
    (both,) = regions_of(sight_of([CUBE, corner]))
    (alone,) = regions_of(sight_of([CUBE]))
    assert both.doubt > alone.doubt + 0.2
    assert max(both.size) > 0.15


def test_a_crop_says_how_high_what_stands_where_in_the_frame_of_the_object():
    turned = CUBE._replace(turn=math.radians(20))
    for box in (CUBE, turned):
        (seen,) = regions_of(sight_of([box]))
        assert seen.crop.shape == (CELLS, CELLS)
        filled = seen.crop > 0.075
        assert np.ptp(np.flatnonzero(filled.any(1))) * CELL == pytest.approx(0.10, abs=2 * CELL)
        assert np.ptp(np.flatnonzero(filled.any(0))) * CELL == pytest.approx(0.06, abs=2 * CELL)
        assert seen.crop.max() == pytest.approx(0.08, abs=1e-6)
        assert not seen.crop[:4].any()


def test_walls_around_nothing_are_one_object_whose_inside_is_low():
    x, y, z, t = 0.12, 0.12, 0.06, 0.006
    walls = [Box((0.65 + s * (x - t) / 2, 0.0), (t, y, z)) for s in (-1, 1)]
    walls += [Box((0.65, s * (y - t) / 2), (x, t, z)) for s in (-1, 1)]
    (seen,) = regions_of(sight_of([*walls, Box((0.65, 0.0), (x, y, t))]))
    assert seen.size == pytest.approx([x, y, z], abs=0.006)
    assert seen.crop[CELLS // 2, CELLS // 2] == pytest.approx(t, abs=1e-6)


def test_lost_pixels_part_nothing():
    whole = sight_of([CUBE])
    rng = np.random.default_rng(0)
    holes = np.where(rng.random(whole.depths.shape) < 0.2, np.nan, whole.depths)
    (seen,) = regions_of(replace(whole, depths=holes))
    assert seen.position == pytest.approx([*CUBE.at, 0.04], abs=0.006)


def test_an_empty_table_has_no_objects():
    assert regions_of(sight_of([])) == []


def test_what_is_no_image_is_refused():
    whole = sight_of([])
    with pytest.raises(InvalidValue, match="no pixel of it has a depth"):
        regions_of(replace(whole, depths=np.full_like(whole.depths, np.nan)))
    with pytest.raises(InvalidValue, match=r"The image has shape \(3, 3\)"):
        Sight(np.zeros((3, 3)), whole.rays, whole.eye)
