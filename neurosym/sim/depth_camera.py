"""A depth camera over the table: what it sees of a scene at rest."""

import hashlib
import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from neurosym.checks import Float
from neurosym.errors import InvalidValue
from neurosym.perception.regions import Sight
from neurosym.sim.config import Client, TabletopConfig, pybullet

_NEAR, _FAR = 0.2, 3.0  # of what is drawn [m]
_NOTHING = 1 - 1e-6  # what the renderer tells where nothing is, or more
_PIXELS = 12  # that the smallest object covers, at least
_SEEN_BESIDE = 0.09  # so far beyond the table's edge objects reach [m]
_EDGE = 0.01  # depths that differ by more than this between neighbours make an edge [m]


@dataclass(frozen=True)
class DepthCamera:
    """A depth camera, as it stands in `world.toml`; every length in metres.

    Attributes:
        position: Where it is.
        looks_at: The point in the middle of its picture.
        roll: By how much it is turned about its own axis [degrees]. Edges of objects that lie straight then
            cross the rows of pixels, so that they are located to less than a pixel.
        field_of_view: Of the height and the width of its square picture [degrees].
        pixels: Height and width of its picture.
        depth_step: Depths are told in multiples of this; 0 is exact.
        dropout: Which share of the pixels at edges is lost.
        offset: Standard deviation by which all depths of one picture are off.
    """

    position: tuple[float, float, float] = (0.65, 0.0, 1.3)
    looks_at: tuple[float, float, float] = (0.65, 0.0, 0.0)
    roll: float = 18.0
    field_of_view: float = 46.0
    pixels: int = 192
    depth_step: float = 0.0
    dropout: float = 0.0
    offset: float = 0.0

    def __post_init__(self) -> None:
        if not 32 <= self.pixels <= 1024:
            raise InvalidValue(f"camera.pixels = {self.pixels} must lie between 32 and 1024.")
        if not 5 <= self.field_of_view <= 120:
            raise InvalidValue(
                f"camera.field_of_view = {self.field_of_view} must lie between 5 and 120 degrees."
            )
        for name, most in (("depth_step", 0.05), ("dropout", 1.0), ("offset", 0.05)):
            if not 0 <= getattr(self, name) <= most:
                raise InvalidValue(f"camera.{name} = {getattr(self, name)} must lie between 0 and {most}.")
        if not all(map(math.isfinite, (*self.position, *self.looks_at, self.roll))):
            raise InvalidValue("camera.position, looks_at and roll must be finite numbers.")
        if math.dist(self.position, self.looks_at) < _NEAR:
            raise InvalidValue(f"camera.position = {[*self.position]} is too near to what it looks at.")

    @property
    def is_exact(self) -> bool:
        """Whether what it sees has no noise."""
        return not (self.depth_step or self.dropout or self.offset)

    @cached_property
    def _view(self) -> Sequence[float]:
        towards = np.subtract(self.looks_at, self.position)
        ahead = np.array([1.0, 0.0, 0.0] if abs(towards[0]) < max(map(abs, towards[1:])) else [0.0, 0.0, 1.0])
        across = np.cross(towards, ahead)
        upwards = np.cross(across, towards) / np.linalg.norm(towards)
        turn = math.radians(self.roll)
        up = math.cos(turn) * upwards + math.sin(turn) * across
        view: Sequence[float] = pybullet.computeViewMatrix(self.position, self.looks_at, up.tolist())
        return view

    @cached_property
    def _projection(self) -> Sequence[float]:
        projection: Sequence[float] = pybullet.computeProjectionMatrixFOV(
            self.field_of_view, 1.0, _NEAR, _FAR
        )
        return projection

    @cached_property
    def _rays(self) -> Float[np.ndarray, "height width 3"]:
        """Where each pixel looks, as far as 1 m along the camera's axis."""
        view = np.reshape(self._view, (4, 4)).T
        half = math.tan(math.radians(self.field_of_view) / 2)
        steps = 2 * np.arange(self.pixels) / self.pixels - 1  # the renderer looks at corners
        right, down = np.meshgrid(half * steps, half * (steps + 2 / self.pixels))
        return np.asarray(np.stack([right, -down, -np.ones_like(right)], axis=-1) @ view[:3, :3])

    def check_sees(self, tabletop: TabletopConfig) -> None:
        """Raise `InvalidValue` unless it sees all that can stand on a table, as high as objects are."""
        view, projection = (np.reshape(m, (4, 4)).T for m in (self._view, self._projection))
        for x in np.add(tabletop.table_x, (-_SEEN_BESIDE, _SEEN_BESIDE)):
            for y in np.add(tabletop.table_y, (-_SEEN_BESIDE, _SEEN_BESIDE)):
                for z in (0.0, tabletop.height[1]):
                    *place, depth = projection @ view @ (x, y, z, 1.0)
                    if depth <= _NEAR or max(map(abs, place)) > depth:
                        raise InvalidValue(
                            f"camera.position = {[*self.position]}, which looks at {[*self.looks_at]} with a "
                            f"field_of_view of {self.field_of_view:g} degrees, does not see the whole table; "
                            f"({x:.2f}, {y:.2f}, {z:.2f}) is out of its picture. Raise it, or widen its view."
                        )
        deepest = float((-self.position[2] / self._rays[..., 2]).max())
        if self._rays[..., 2].max() >= 0 or not deepest <= _FAR:
            raise InvalidValue(
                f"camera.position = {[*self.position]} looks past the table, further than {_FAR:g} m; let it "
                "look down more steeply."
            )
        pixel = 2 * deepest * math.tan(math.radians(self.field_of_view) / 2) / self.pixels
        if (covered := (tabletop.size[0] / pixel) ** 2) < _PIXELS:
            raise InvalidValue(
                f"camera.pixels = {self.pixels} show an object of {tabletop.size[0]:g} m in {covered:.0f} "
                f"pixels; valid: at least {_PIXELS}."
            )

    def look(self, client: Client, seed: bytes) -> Sight:
        """Return what it sees: bodies, and beyond them the table, which is not to be among these.

        Args:
            client: What is looked at.
            seed: What decides the noise, such as the poses of objects.
        """
        pixels = self.pixels
        buffer = client.getCameraImage(
            pixels,
            pixels,
            self._view,
            self._projection,
            shadow=0,
            renderer=pybullet.ER_TINY_RENDERER,
            flags=pybullet.ER_NO_SEGMENTATION_MASK,
        )[3]
        shares = np.reshape(np.asarray(buffer, dtype=float), (pixels, pixels))
        depths = _FAR * _NEAR / (_FAR - (_FAR - _NEAR) * shares)
        depths = np.where(shares < _NOTHING, depths, -self.position[2] / self._rays[..., 2])
        return Sight(self._sensed(depths, seed), self._rays, np.array(self.position))

    def _sensed(self, depths: Float[np.ndarray, "height width"], seed: bytes) -> np.ndarray:
        """Return depths as a sensor tells them: off by some, in steps, and without some at edges [m]."""
        if self.is_exact:
            return depths
        rng = np.random.default_rng([*hashlib.sha256(seed).digest()])
        down, along = (np.abs(np.diff(depths, axis=axis)) > _EDGE for axis in (0, 1))
        edges = np.zeros(depths.shape, dtype=bool)
        edges[1:] |= down
        edges[:-1] |= down
        edges[:, 1:] |= along
        edges[:, :-1] |= along
        sensed = depths + self.offset * rng.standard_normal()
        if self.depth_step:
            sensed = np.round(sensed / self.depth_step) * self.depth_step
        return np.where(edges & (rng.random(depths.shape) < self.dropout), np.nan, sensed)
