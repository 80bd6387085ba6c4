"""Bodies become closed meshes of their size, labels keep apart, and a drag follows the pointer."""

import numpy as np
import pytest

from neurosym.poses import Part
from neurosym.studio.grabbing import Grab, on_plane
from neurosym.studio.labels import HEIGHT, WIDTH, label_heights
from neurosym.studio.shapes import circle, mesh_of, rectangle, scalar_first

PARTS = [
    (Part("box", (0.1, 0.2, 0.3)), 0.006),
    (Part("cylinder", (0.1, 0.4)), np.pi * 0.01 * 0.4),
    (Part("sphere", (0.1,)), 4 / 3 * np.pi * 0.001),
]


@pytest.mark.parametrize(("part", "volume"), PARTS, ids=[part.kind for part, _ in PARTS])
def test_mesh_is_closed_and_encloses_the_volume_of_its_body(part, volume):
    corners, faces = mesh_of([part])
    a, b, c = (corners[faces[:, column]] for column in range(3))
    enclosed = np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6  # positive if all faces look outwards
    assert volume * 0.9 < enclosed <= volume * 1.0001


def test_parts_stand_where_they_are_put():
    half = (0.0, 0.0, np.sin(np.pi / 4), np.cos(np.pi / 4))  # a quarter turn
    corners, _ = mesh_of([Part("box", (0.2, 0.1, 0.1), (1.0, 2.0, 3.0), half)])
    assert np.allclose(corners.max(0), [1.05, 2.1, 3.05])


def test_several_parts_are_one_mesh():
    corners, faces = mesh_of([Part("box", (1.0, 1.0, 1.0)), Part("sphere", (1.0,))])
    assert faces.max() == len(corners) - 1


def test_outlines_are_closed():
    for lines in (circle(0.05, 0.0), rectangle(0.1, 0.2, 0.0)):
        assert np.allclose(lines[1:, 0], lines[:-1, 1])
        assert np.allclose(lines[0, 0], lines[-1, 1])


def test_quaternions_are_turned_around_for_the_page():
    assert scalar_first((1, 2, 3, 4)) == (4.0, 1.0, 2.0, 3.0)


@pytest.mark.parametrize("seed", range(20))
def test_labels_do_not_cover_each_other(seed):
    rng = np.random.default_rng(seed)
    spots = {
        f"item-{number:02d}": ((float(x), float(y), 0.05), 0.1)
        for number, (x, y) in enumerate(rng.uniform([0.4, -0.3], [1.0, 0.3], (8, 2)))
    }
    heights = label_heights(spots)
    seen = [(spots[name][0][1], height + 0.7 * spots[name][0][0]) for name, height in heights.items()]
    for number, (side, height) in enumerate(seen):
        for other_side, other in seen[number + 1 :]:
            assert abs(side - other_side) >= WIDTH or abs(height - other) >= HEIGHT - 1e-9


def test_label_of_a_lone_object_is_right_above_it():
    assert label_heights({"item-01": ((0.6, 0.0, 0.05), 0.1)})["item-01"] == pytest.approx(0.13)


def test_pointer_that_moves_over_the_table_moves_what_was_grabbed_by_as_much():
    eye = (1.5, 0.0, 1.0)
    grab = Grab(eye, (0.6, 0.0, 0.1), (0.58, 0.02, 0.04))
    ahead = np.array(eye) + 0.3 * (np.array([0.7, 0.1, 0.1]) - eye)  # anywhere on the line of sight
    assert grab.to(ahead) == pytest.approx((0.68, 0.12))


def test_line_of_sight_that_misses_the_plane_moves_nothing():
    assert on_plane((0, 0, 1), (1, 0, 1), 0.0) is None
    assert on_plane((0, 0, 1), (1, 0, 2), 0.0) is None
