"""Bodies become closed meshes of their size, labels keep apart, and a drag follows the pointer."""

from itertools import combinations
from types import SimpleNamespace

import numpy as np
import pytest

from neurosym.contract import Part
from neurosym.problems import SceneObject
from neurosym.studio.view import LABEL, Grab, View, circle, mesh_of, rectangle

PARTS = [
    (Part("box", (0.1, 0.2, 0.3)), 0.006),
    (Part("cylinder", (0.1, 0.4)), np.pi * 0.01 * 0.4),
    (Part("sphere", (0.1,)), 4 / 3 * np.pi * 0.001),
]


@pytest.mark.parametrize(("part", "volume"), PARTS, ids=[part.kind for part, _ in PARTS])
def test_mesh_is_closed_and_encloses_the_volume_of_its_body(part, volume):
    mesh = mesh_of([part])
    assert mesh.is_watertight
    assert volume * 0.9 < mesh.volume <= volume * 1.0001  # positive, since all faces look outwards


def test_parts_stand_where_they_are_put_and_are_one_mesh():
    half = (0.0, 0.0, np.sin(np.pi / 4), np.cos(np.pi / 4))  # a quarter turn
    box = Part("box", (0.2, 0.1, 0.1), (1.0, 2.0, 3.0), half)
    assert np.allclose(mesh_of([box]).bounds[1], [1.05, 2.1, 3.05])
    both = mesh_of([box, Part("sphere", (1.0,))])
    assert np.allclose(both.bounds, [[-1.0, -1.0, -1.0], [1.05, 2.1, 3.05]], atol=0.02)
    assert both.faces.max() == len(both.vertices) - 1


def test_outlines_are_closed():
    for lines in (circle(0.05, 0.0), rectangle(0.1, 0.2, 0.0)):
        assert np.allclose(lines[1:, 0], lines[:-1, 1])
        assert np.allclose(lines[0, 0], lines[-1, 1])


@pytest.mark.parametrize("seed", range(5))
def test_labels_do_not_cover_each_other(seed):
    rng = np.random.default_rng(seed)
    items = labelled(rng.uniform([0.4, -0.3], [1.0, 0.3], (8, 2)))
    seen = [(y, z + 0.7 * x) for x, y, z in items]
    for (side, height), (other_side, other) in combinations(seen, 2):
        assert abs(side - other_side) >= LABEL[0] or abs(height - other) >= LABEL[1] - 1e-9


def labelled(spots) -> list[tuple[float, float, float]]:
    """Where the labels of objects stand that are 0.1 m high [m]."""
    view = View.__new__(View)
    items = [
        SceneObject(f"item-{number}", "0", (0.1, 0.1, 0.1), (float(x), float(y), 0.05))
        for number, (x, y) in enumerate(spots)
    ]
    view._labels = {item.name: SimpleNamespace() for item in items}
    view._place_labels(items)
    return [label.position for label in view._labels.values()]


def test_pointer_that_moves_over_the_table_moves_what_was_grabbed_by_as_much():
    eye = (1.5, 0.0, 1.0)
    grab = Grab(eye, (0.6, 0.0, 0.1), (0.58, 0.02, 0.04))
    ahead = np.array(eye) + 0.3 * (np.array([0.7, 0.1, 0.1]) - eye)  # anywhere on the line of sight
    assert grab.to(ahead) == pytest.approx((0.68, 0.12))
    for point in ((1, 0, 1), (1, 0, 2)):  # lines of sight that miss the level
        assert Grab((0, 0, 1), (0, 0, 0), (0, 0, 0)).to(point) is None
