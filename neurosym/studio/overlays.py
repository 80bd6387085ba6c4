"""What is drawn over the table for a while: paths of a plan, reach, arrows, waypoints, outcomes."""

from collections.abc import Callable, Sequence
from contextlib import suppress
from typing import Any

import numpy as np
import viser

from neurosym.arrays import Float
from neurosym.studio.placing import REACH_CELL

WAYPOINTS = ((62, 117, 196), (68, 158, 88), (201, 72, 76))
"""Blue the first, green the second, red the third, as in pictures."""
PUSH, LIFT = (245, 166, 35), (123, 97, 255)
_OVER = 0.004


class Overlays:
    """Layers over the table, each drawn anew as a whole.

    Args:
        scene: Where they are drawn.
    """

    def __init__(self, scene: viser.SceneApi):
        self._scene = scene
        self._layers: dict[str, list[Any]] = {}

    def clear(self, layer: str) -> None:
        """Take a layer away."""
        for node in self._layers.pop(layer, []):
            with suppress(RuntimeError, KeyError):  # it went with what it hung on
                node.remove()

    def paths(
        self, positions: Float[np.ndarray, "steps M 3"], colours: Sequence[tuple[int, int, int]]
    ) -> None:
        """Draw the way of each object through a plan, with a dot for each step.

        Args:
            positions: Centres of the objects before the first step and after each [m].
            colours: Of each object.
        """
        self.clear("paths")
        nodes = self._layers.setdefault("paths", [])
        for number in range(positions.shape[1]):
            way = positions[:, number] + [0.0, 0.0, _OVER]
            moves = np.linalg.norm(np.diff(way, axis=0), axis=1) > 1e-4
            if not moves.any():
                continue
            lines = np.stack([way[:-1][moves], way[1:][moves]], axis=1)
            colour = colours[number % len(colours)]
            nodes.append(self._scene.add_line_segments(f"/paths/{number}", lines, colour, thickness=0.006))
            nodes.append(self._cloud(f"/paths/{number}-dots", way[1:][moves], colour, 0.011))

    def _cloud(self, name: str, points: np.ndarray, colours: Any, size: float, **options: Any) -> Any:
        return self._scene.add_point_cloud(
            name, points, colours, point_size=size, point_shape="circle", precision="float32", **options
        )

    def reach(self, centres: Float[np.ndarray, "N 2"], colour: tuple[int, int, int]) -> None:
        """Draw where an object can be brought to [m], as dots on the table."""
        self.clear("reach")
        points = np.column_stack([centres, np.full(len(centres), 0.001)])
        size = REACH_CELL * 0.35
        self._layers["reach"] = [self._cloud("/reach", points, colour, size, point_shading="flat")]

    def arrows(self, start: Sequence[float], effects: Sequence[tuple[Sequence[float], bool]]) -> None:
        """Draw where operators take an object, each arrow with its number from 1.

        Args:
            start: Where the arrows begin, above the object so that they stay visible [m].
            effects: Displacement [m] of each operator, and whether it lifts.
        """
        self.clear("arrows")
        ends = np.array([np.add(start, effect) for effect, _ in effects]).reshape(-1, 3)
        points = np.stack([np.tile(np.array(start, dtype=float), (len(ends), 1)), ends], axis=1)
        colours = np.array([LIFT if lifts else PUSH for _, lifts in effects], dtype=np.uint8)
        if not len(ends):
            return
        nodes: list[Any] = [
            self._scene.add_arrows(
                "/arrows", points, colours, shaft_radius=0.002, head_radius=0.007, head_length=0.016
            )
        ]
        for number, end in enumerate(ends, start=1):
            nodes.append(
                self._scene.add_label(
                    f"/arrow-labels/{number}", str(number), position=tuple(end), font_screen_scale=0.8
                )
            )
        self._layers["arrows"] = nodes

    def dots(
        self, points: Float[np.ndarray, "N 3"], colours: Float[np.ndarray, "N 3"], layer: str = "dots"
    ) -> None:
        """Draw dots, as of rehearsals around a promise.

        Args:
            points: Where they are [m].
            colours: Of each, from 0 to 255.
            layer: Which layer they are.
        """
        self.clear(layer)
        if len(points):
            self._layers[layer] = [self._cloud(f"/{layer}", points, colours.astype(np.uint8), 0.007)]

    def waypoints(
        self,
        points: Float[np.ndarray, "3 3"],
        moved: Callable[[int, tuple[float, float, float]], None],
    ) -> None:
        """Draw the waypoints of an action, each to be dragged.

        Args:
            points: Where they are [m].
            moved: Called with the number of a waypoint, from 0, and where it was dragged to [m].
        """
        self.clear("waypoints")
        lines = np.stack([points[:-1], points[1:]], axis=1)
        nodes: list[Any] = [self._scene.add_line_segments("/way", lines, (90, 90, 90), thickness=0.003)]
        for number, point in enumerate(points):
            colour = WAYPOINTS[number % len(WAYPOINTS)]
            ball = self._scene.add_icosphere(f"/waypoints/{number}", 0.012, colour, position=tuple(point))
            handle = self._scene.add_transform_controls(
                f"/waypoint-handles/{number}",
                scale=0.07,
                disable_rotations=True,
                disable_sliders=True,
                position=tuple(point),
            )
            handle.on_update(_teller(number, moved))
            nodes += [ball, handle]
        self._layers["waypoints"] = nodes

    def follow(self, points: Float[np.ndarray, "3 3"]) -> None:
        """Put the waypoints elsewhere, while one of them is dragged [m]."""
        nodes = self._layers.get("waypoints", [])
        if nodes:
            nodes[0].points = np.stack([points[:-1], points[1:]], axis=1).astype(np.float32)
            for ball, point in zip(nodes[1::2], points, strict=True):
                ball.position = tuple(point)


def _teller(number: int, moved: Callable[[int, tuple[float, float, float]], None]) -> Callable[[Any], Any]:
    async def tell(event: Any) -> None:
        x, y, z = (float(part) for part in event.target.position)
        moved(number, (x, y, z))

    return tell
