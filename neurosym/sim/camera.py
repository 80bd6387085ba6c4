"""Pictures of the simulation, rendered without a screen, or a window that shows it live."""

from collections.abc import Container
from functools import cached_property

import numpy as np

from neurosym.arrays import Float
from neurosym.sim.bullet import pybullet
from neurosym.sim.config import TabletopConfig
from neurosym.sim.ghosts import Colour, Ghosts, draw_ghosts
from neurosym.sim.lens import HEIGHT, WIDTH, lens_over
from neurosym.sim.simulation import Simulation
from neurosym.sim.window import Window, is_window
from neurosym.waypoint_dots import draw_dots
from neurosym.world import Frame

OBJECT_COLOURS: tuple[Colour, ...] = (
    (0.26, 0.53, 0.82, 1.0),
    (0.36, 0.70, 0.36, 1.0),
    (0.80, 0.33, 0.36, 1.0),
    (0.58, 0.42, 0.75, 1.0),
    (0.93, 0.75, 0.24, 1.0),
    (0.35, 0.73, 0.75, 1.0),
    (0.55, 0.40, 0.30, 1.0),
    (0.45, 0.47, 0.50, 1.0),
)
"""Blue, green, red, purple, yellow, turquoise, brown, grey: item-01, item-02, ..., one for each object."""
BORDER_COLOUR: Colour = (0.62, 0.56, 0.48, 1.0)
BORDER_WIDTH = 0.004
"""Of the line around the table, beyond which an object is lost [m]."""
BORDER_HEIGHT, BORDER_PIECES = 0.0005, 12
"""How far it lies above the table [m], and into how many pieces each of its sides is cut."""
TABLE_COLOUR: Colour = (0.86, 0.82, 0.76, 1.0)
DOT_RADIUS = WIDTH / 120
BLANK: Frame = np.full((HEIGHT, WIDTH, 3), 255, dtype=np.uint8)
"""Stands for a picture that nobody wants to see."""


class Camera:
    """A camera that looks over the table at the robot.

    Args:
        simulation: The scene, whose objects are coloured by their number.
        ghosts: Centres at which the objects are shown once more, transparently [m].
        wanted: Numbers of the pictures to draw, counted from 0; every other is blank. All, if not given.
    """

    def __init__(
        self,
        simulation: Simulation,
        ghosts: Float[np.ndarray, "M 3"] | None = None,
        wanted: Container[int] | None = None,
    ):
        self._client = client = simulation.client
        self._lens = lens_over(simulation.config)
        self._wanted = wanted
        self._taken = 0
        self._waypoints: Float[np.ndarray, "3 3"] | None = None
        colours = [OBJECT_COLOURS[index % len(OBJECT_COLOURS)] for index in range(len(simulation.bodies))]
        for body, colour in zip(
            (simulation.table, *simulation.bodies), (TABLE_COLOUR, *colours), strict=True
        ):
            pybullet.changeVisualShape(body, -1, rgbaColor=colour, physicsClientId=client)
        _draw_border(client, simulation.config)
        shown = None if ghosts is None else (simulation.observe(), ghosts, colours, simulation.config.wall)
        self._window = Window(simulation, self._lens, shown) if is_window(client) else None
        self._shown = shown

    @cached_property
    def _ghosts(self) -> Ghosts | None:
        """What shines through the pictures; drawn with the first that is wanted."""
        return draw_ghosts(*self._shown, self._lens) if self._shown else None

    def mark(self, waypoints: Float[np.ndarray, "3 3"]) -> None:
        """Show the waypoints of an action as dots in the pictures to come.

        Args:
            waypoints: In the world [m].
        """
        self._waypoints = waypoints
        if self._window:
            self._window.mark(waypoints)

    def picture(self) -> Frame:
        """Render what the camera sees now; blank if it is not wanted, or is seen live in a window."""
        number = self._taken
        self._taken += 1
        if self._window:
            self._window.keep_time()
            return BLANK
        if self._wanted is not None and number not in self._wanted:
            return BLANK
        frame, depths = self._lens.draw(self._client)
        if self._ghosts:
            frame = self._ghosts.over(frame, depths)
        if self._waypoints is not None:
            frame = draw_dots(frame, self._lens.pixels(self._waypoints), DOT_RADIUS)
        return frame


def _draw_border(client: int, config: TabletopConfig) -> None:
    """Draw a line around the table, that can be seen and not touched.

    The renderer looks at every pixel of the upright rectangle around a triangle. So a line that lies aslant
    in the picture is drawn as many short pieces, of which one side is seen.
    """
    (left, right), (near, far) = config.table_x, config.table_y
    corners = np.array([(left, near), (right, near), (right, far), (left, far)])
    outwards = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) * BORDER_WIDTH / 2
    shares = np.linspace(0, 1, BORDER_PIECES, endpoint=False)[:, None]
    rims = [
        np.concatenate(
            [start + shares * (end - start) for start, end in zip(rim, np.roll(rim, -1, axis=0), strict=True)]
        )
        for rim in (corners - outwards, corners + outwards)
    ]
    inner, outer = (np.column_stack([rim, np.full(len(rim), BORDER_HEIGHT)]) for rim in rims)  # (P, 3)
    here = np.arange(len(inner))
    there, out = np.roll(here, -1), len(inner)
    triangles = np.stack([here + out, there + out, there, here + out, there, here], axis=1)  # (P, 6)
    shape = pybullet.createVisualShape(
        pybullet.GEOM_MESH,
        vertices=np.concatenate([inner, outer]).tolist(),
        indices=triangles.ravel().tolist(),
        normals=[(0.0, 0.0, 1.0)] * (2 * len(inner)),
        rgbaColor=BORDER_COLOUR,
        physicsClientId=client,
    )
    pybullet.createMultiBody(0, -1, shape, (0, 0, 0), physicsClientId=client)
