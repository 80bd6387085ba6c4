"""The objects of the tabletop: built from their features (s_x, s_y, d, t), and from what no feature shows.

Boxes, open-topped boxes, planks and rings are what domains are learned with. The other shapes are there to
try what was learned on: their features say how large they are, and not that they are round or angled.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from neurosym.checks import Float
from neurosym.contract import Part, Range
from neurosym.operators import Vector, vector

FEATURE_NAMES = ("s_x", "s_y", "d", "t")
"""Size along x, size along y, height [m], and type: 0 solid, 1 open at the top, 2 open at both ends."""
SOLID, OPEN_TOP, OPEN_THROUGH = 0.0, 1.0, 2.0
LEARNED_SHAPES = {"box": SOLID, "open-box": OPEN_TOP, "plank": SOLID, "ring": OPEN_THROUGH}
"""The type of each shape that domains are learned with."""
TEST_SHAPES = {
    "cylinder": SOLID,
    "ball": SOLID,
    "torus": OPEN_THROUGH,
    "t-block": SOLID,
    "u-block": SOLID,
    "l-block": SOLID,
    "wedge": SOLID,
}
"""The type of each shape that they are tried on, in the order of their numbers, from 1."""
SHAPES = {**LEARNED_SHAPES, **TEST_SHAPES}
UNSEEN: dict[str, Range] = {
    "shape": (0, len(TEST_SHAPES)),
    "mass": (0, 20),
    "friction": (0, 5),
    "heavy_end": (-0.9, 0.9),
    "false_bottom": (0, 0.9),
}
"""What no feature shows, each with its least and greatest value: number of the shape, 0 if it is as features
say; mass [kg] and friction, 0 if as the world's; how far the centre of mass lies off the middle to +x, as
a share of the way there; and how high the floor of an open-topped box reaches, as a share of its height."""
_RING_SEGMENTS, _TORUS_SEGMENTS, _CYLINDER_BOXES, _WEDGE_STEPS = 12, 8, 6, 8  # PyBullet takes 16 boxes
_BEAM, _LEG, _WEDGE_TOP, _TUBE = 0.35, 0.25, 0.25, 0.41
"""Thickness of T and L, and of U, as shares of the lesser side; how long a wedge is at its top, as a share of
its length; and how broad a torus is at its top and bottom, as a share of its tube."""

Box = tuple[tuple[float, float, float], tuple[float, float, float], float]
"""Half extents [m], centre in the object's frame [m], and turn about the object's z axis [rad]."""


@dataclass(frozen=True, slots=True)
class Body:
    """What the simulator makes of an object."""

    # what it is built from, its frame at the middle; what is around it if it is a ball
    boxes: tuple[Box, ...]
    mass: float  # [kg]
    friction: float  # lateral
    centre_of_mass: tuple[float, float, float] = (0.0, 0.0, 0.0)  # in its frame [m]
    is_ball: bool = False

    @property
    def around(self) -> tuple[Float[np.ndarray, "B 3"], Float[np.ndarray, "B 3"]]:
        """The middles and half sizes of straight boxes around those that it is built from [m]."""
        halves, centres, turns = (np.array(column) for column in zip(*self.boxes, strict=True))
        (x, y, z), cos, sin = halves.T, np.abs(np.cos(turns)), np.abs(np.sin(turns))
        return centres, np.stack([cos * x + sin * y, sin * x + cos * y, z], axis=1)

    @property
    def parts(self) -> tuple[Part, ...]:
        """What it is drawn with."""
        if self.is_ball:
            return (Part("sphere", self.boxes[0][0][:1]),)
        return tuple(
            Part(
                "box",
                tuple(2 * edge for edge in half),
                centre,
                (0.0, 0.0, math.sin(turn / 2), math.cos(turn / 2)),
            )
            for half, centre, turn in self.boxes
        )


def body_of(
    features: Float[np.ndarray, "F"], unseen: Sequence[float], *, wall: float, mass: float, friction: float
) -> Body:
    """Say what to build an object from.

    Args:
        features: What is seen of it.
        unseen: What is not, as `UNSEEN` says; nothing if it is all 0.
        wall: Thickness of the walls and floors of open objects [m].
        mass: Mass of objects of which nothing else is said [kg].
        friction: Lateral friction of such objects.
    """
    number, own_mass, own_friction, heavy, floor = (*unseen, *[0.0] * (len(UNSEEN) - len(unseen)))
    shape = ("", *TEST_SHAPES)[round(number)]
    x, y, z = (float(size) / 2 for size in features[:3])
    own = own_mass or mass, own_friction or friction
    if shape == "ball":
        return Body((((z, z, z), (0.0, 0.0, 0.0), 0.0),), *own, (heavy * z, 0.0, 0.0), is_ball=True)
    boxes = _FORMS[shape](x, y, z) if shape else _boxes_as_seen(features, wall, floor)
    middle_x, middle_y, middle_z = _middle_of(boxes) if shape in _LOPSIDED else (0.0, 0.0, 0.0)
    middle_x += abs(heavy) * (math.copysign(x, heavy) - middle_x)
    return Body(tuple(boxes), *own, (middle_x, middle_y, middle_z))


def _boxes_as_seen(features: Float[np.ndarray, "F"], wall: float, floor: float) -> list[Box]:
    """List the boxes that an object is built from if it is what its features say."""
    x, y, z = (float(size) / 2 for size in features[:3])
    t = wall / 2
    if features[3] < (SOLID + OPEN_TOP) / 2:
        return [((x, y, z), (0.0, 0.0, 0.0), 0.0)]
    if features[3] < (OPEN_TOP + OPEN_THROUGH) / 2:
        f = max(t, floor * z)
        return [
            ((x, y, f), (0.0, 0.0, f - z), 0.0),
            ((t, y, z - t), (x - t, 0.0, t), 0.0),
            ((t, y, z - t), (t - x, 0.0, t), 0.0),
            ((x - 2 * t, t, z - t), (0.0, y - t, t), 0.0),
            ((x - 2 * t, t, z - t), (0.0, t - y, t), 0.0),
        ]
    return _around(x, y, t, z)


def _around(x: float, y: float, t: float, z: float, segments: int = _RING_SEGMENTS) -> list[Box]:
    """List boxes around an ellipse with these outer half axes, of half thickness t and half height z [m]."""
    angles = np.linspace(0, 2 * math.pi, segments + 1).tolist()
    corners = [np.array([(x - t) * math.cos(angle), (y - t) * math.sin(angle)]) for angle in angles]
    boxes: list[Box] = []
    for start, end in pairwise(corners):
        (middle_x, middle_y), along = ((start + end) / 2).tolist(), end - start
        half = float(np.linalg.norm(along)) / 2
        boxes.append(((half, t, z), (middle_x, middle_y, 0.0), math.atan2(along[1], along[0])))
    return boxes


def _cylinder(x: float, y: float, z: float) -> list[Box]:
    """List boxes that together are a prism with twice as many sides, two of them across each of x and y."""
    step = math.pi / _CYLINDER_BOXES
    half = (min(x, y), min(x, y) * math.tan(step / 2), z)
    return [(half, (0.0, 0.0, 0.0), step * number) for number in range(_CYLINDER_BOXES)]


def _torus(x: float, y: float, z: float) -> list[Box]:
    broad = _around(x, y, z, _TUBE * z, _TORUS_SEGMENTS)
    return [*broad, *(((half, _TUBE * z, z), middle, turn) for (half, _, _), middle, turn in broad)]


def _t_block(x: float, y: float, z: float) -> list[Box]:
    b = _BEAM * min(x, y)
    return [((b, y, z), (x - b, 0.0, 0.0), 0.0), ((x - b, b, z), (-b, 0.0, 0.0), 0.0)]


def _l_block(x: float, y: float, z: float) -> list[Box]:
    b = _BEAM * min(x, y)
    return [((b, y, z), (b - x, 0.0, 0.0), 0.0), ((x - b, b, z), (b, b - y, 0.0), 0.0)]


def _u_block(x: float, y: float, z: float) -> list[Box]:
    b = _LEG * min(x, y)
    legs: list[Box] = [((x - b, b, z), (b, side * (y - b), 0.0), 0.0) for side in (-1, 1)]
    return [((b, y, z), (b - x, 0.0, 0.0), 0.0), *legs]


def _wedge(x: float, y: float, z: float) -> list[Box]:
    """List layers that get shorter from step to step, all upright at -x."""
    shares = np.linspace(1, _WEDGE_TOP, _WEDGE_STEPS).tolist()
    high = z / _WEDGE_STEPS
    return [
        ((share * x, y, high), ((share - 1) * x, 0.0, (2 * number + 1) * high - z), 0.0)
        for number, share in enumerate(shares)
    ]


_FORMS = {
    "cylinder": _cylinder,
    "torus": _torus,
    "t-block": _t_block,
    "u-block": _u_block,
    "l-block": _l_block,
    "wedge": _wedge,
}
_LOPSIDED = ("t-block", "u-block", "l-block", "wedge")


def _middle_of(boxes: Sequence[Box]) -> Vector:
    """Return the centre of mass of boxes of one density that do not overlap [m]."""
    volumes = np.array([math.prod(half) for half, _, _ in boxes])
    return vector(volumes @ np.array([middle for _, middle, _ in boxes]) / volumes.sum())


def sample_objects(
    rng: np.random.Generator, objects: int, *, shapes: Mapping[str, float], size: Range, height: Range
) -> tuple[Float[np.ndarray, "{objects} 4"], Float[np.ndarray, "{objects} U"]]:
    """Draw what the objects are: s_x, s_y, d [m] and t, and what is not seen of them, if there is anything.

    Args:
        rng: Source of randomness, owned by the caller.
        objects: How many objects.
        shapes: How often an object is of each shape, relative to the others.
        size: Least and greatest s_x and s_y [m].
        height: Least and greatest d [m].
    """
    names, shares = [*shapes], np.array([*shapes.values()])
    drawn = [names[number] for number in rng.choice(len(names), size=objects, p=shares / shares.sum())]
    features = np.array([_draw(rng, shape, size, height) for shape in drawn])
    unseen = np.zeros((objects, len(UNSEEN) if any(shape in TEST_SHAPES for shape in drawn) else 0))
    if unseen.size:
        numbers = ["", *TEST_SHAPES]
        unseen[:, 0] = [numbers.index(shape) if shape in numbers else 0 for shape in drawn]
    return features, unseen


def _draw(rng: np.random.Generator, shape: str, size: Range, height: Range) -> tuple[float, ...]:
    """Draw the features of an object of some shape, from the ranges of sizes and heights [m].

    A plank is a flat solid box, one side in the upper half of the sizes and the other in the lowest quarter.
    Rings and tori are round, in the upper half of the sizes and the lower half of the heights; T, U and L
    blocks are in the upper half of the sizes.
    """

    def drawn(whole: Range, low: float = 0.0, high: float = 1.0) -> float:
        """Draw from the part of a range between two shares of its length."""
        least, greatest = whole
        return rng.uniform(least + low * (greatest - least), least + high * (greatest - least))

    kind = SHAPES[shape]
    if shape in ("ring", "torus"):
        diameter = drawn(size, 0.5)
        return diameter, diameter, drawn(height, high=0.5), kind
    if shape == "plank":
        sides = [drawn(size, 0.5), drawn(size, high=0.25)]
        if rng.random() < 0.5:
            sides.reverse()
        return *sides, drawn(height, high=0.25), kind
    if shape == "ball":
        diameter = rng.uniform(max(size[0], height[0]), min(size[1], height[1]))
        return diameter, diameter, diameter, kind
    if shape == "cylinder":
        diameter = drawn(size)
        return diameter, diameter, drawn(height), kind
    if shape.endswith("-block"):
        return drawn(size, 0.5), drawn(size, 0.5), drawn(height), kind
    return rng.uniform(*size), rng.uniform(*size), rng.uniform(*height), kind
