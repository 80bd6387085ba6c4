"""Simple bodies as triangles, since a page draws and grabs each thing as one mesh."""

import math
from collections.abc import Sequence

import numpy as np

from neurosym.arrays import Float, Int
from neurosym.poses import Part

Mesh = tuple[Float[np.ndarray, "V 3"], Int[np.ndarray, "T 3"]]
"""Corners [m], and the numbers of the three of each triangle, counter-clockwise as seen from outside."""
SIDES = 20
"""How many sides a cylinder is drawn with."""
_RINGS = 8
_BOX = np.array([[x, y, z] for x in (-0.5, 0.5) for y in (-0.5, 0.5) for z in (-0.5, 0.5)])
_BOX_FACES = np.array(
    [
        [0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
        [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3],
    ]
)  # fmt: skip


def mesh_of(parts: Sequence[Part]) -> Mesh:
    """Return one mesh of several bodies.

    Args:
        parts: The bodies, all in one frame.
    """
    corners: list[np.ndarray] = []
    faces: list[np.ndarray] = []
    count = 0
    for part in parts:
        points, triangles = _mesh(part)
        corners.append(points @ rotation(part.orientation).T + np.array(part.position))
        faces.append(triangles + count)
        count += len(points)
    return np.concatenate(corners), np.concatenate(faces)


def rotation(quaternion: Sequence[float]) -> Float[np.ndarray, "3 3"]:
    """Return the matrix of a quaternion (x, y, z, w)."""
    x, y, z, w = np.array(quaternion) / math.hypot(*quaternion)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


def scalar_first(quaternion: Sequence[float]) -> tuple[float, float, float, float]:
    """Return a quaternion (x, y, z, w) as a page wants it: (w, x, y, z)."""
    x, y, z, w = (float(part) for part in quaternion)
    return w, x, y, z


def circle(radius: float, height: float, count: int = 48) -> Float[np.ndarray, "N 2 3"]:
    """Return a circle around the origin as lines, each from one point to the next [m]."""
    angles = np.linspace(0, 2 * math.pi, count + 1)
    points = np.column_stack([radius * np.cos(angles), radius * np.sin(angles), np.full(count + 1, height)])
    return np.stack([points[:-1], points[1:]], axis=1)


def rectangle(x: float, y: float, height: float) -> Float[np.ndarray, "4 2 3"]:
    """Return a rectangle around the origin as lines, by half its edges [m]."""
    points = np.array([[x, y, height], [-x, y, height], [-x, -y, height], [x, -y, height], [x, y, height]])
    return np.stack([points[:-1], points[1:]], axis=1)


def _mesh(part: Part) -> Mesh:
    if part.kind == "box":
        return _BOX * np.array(part.size), _BOX_FACES
    if part.kind == "cylinder":
        return _turned([(0.0, -part.size[1] / 2), *_rim(part.size), (0.0, part.size[1] / 2)])
    angles = np.linspace(-math.pi / 2, math.pi / 2, _RINGS + 1)
    radius = part.size[0]
    return _turned([(radius * math.cos(angle), radius * math.sin(angle)) for angle in angles])


def _rim(size: Sequence[float]) -> list[tuple[float, float]]:
    radius, length = size
    return [(radius, -length / 2), (radius, length / 2)]


def _turned(profile: Sequence[tuple[float, float]]) -> Mesh:
    """Turn a line of (distance from the axis, height) about the z axis."""
    angles = np.arange(SIDES) * 2 * math.pi / SIDES
    points = np.array([[r * math.cos(angle), r * math.sin(angle), z] for r, z in profile for angle in angles])
    faces = []
    for ring in range(len(profile) - 1):
        for side in range(SIDES):
            here, there = ring * SIDES + side, ring * SIDES + (side + 1) % SIDES
            faces += [[here, there, there + SIDES], [here, there + SIDES, here + SIDES]]
    return points, np.array(faces)
