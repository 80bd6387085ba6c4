"""Simple bodies as triangles, since a page draws and grabs each thing as one mesh."""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
import trimesh
from scipy.spatial.transform import Rotation

from neurosym.arrays import Float
from neurosym.poses import Part

SIDES = 20
"""How many sides a cylinder is drawn with."""


def mesh_of(parts: Sequence[Part]) -> Any:
    """Return one closed mesh of trimesh of several bodies, all in one frame, its faces seen from outside."""
    return trimesh.util.concatenate([_mesh(part) for part in parts])


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


def _mesh(part: Part) -> Any:
    if part.kind == "box":
        mesh = trimesh.creation.box(part.size)
    elif part.kind == "cylinder":
        mesh = trimesh.creation.cylinder(part.size[0], part.size[1], sections=SIDES)
    else:
        mesh = trimesh.creation.icosphere(subdivisions=2, radius=part.size[0])
    place = np.eye(4)
    place[:3, :3] = Rotation.from_quat(part.orientation).as_matrix()
    place[:3, 3] = part.position
    return mesh.apply_transform(place)
