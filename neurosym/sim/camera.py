"""Pictures of the simulation, rendered without a screen, or a window that shows it live."""

import ctypes
import sys
import time
from collections.abc import Callable, Container, Sequence
from functools import cached_property

import numpy as np

from neurosym.checks import Float
from neurosym.contract import POSE_SECONDS, Part, PartKind, Pose, PoseSink
from neurosym.errors import InvalidValue
from neurosym.sim.config import Arm, Client, TabletopConfig, loaded, pybullet
from neurosym.sim.robot import Robot
from neurosym.sim.simulation import Simulation
from neurosym.world import DOT_COLOURS, Frame, Painter, draw_dots, painted

Colour = tuple[float, float, float, float]
Depths = Float[np.ndarray, "height width"]
"""A depth buffer: 0 near the camera, 1 where nothing is."""

WIDTH, HEIGHT = 640, 480
DISTANCE, YAW, PITCH = 1.3, 52.0, -30.0
"""The camera looks at the robot over the table, from its right [m, degrees, degrees]."""
WINDOW_DISTANCE = 1.0
"""Of the camera of a window [m], which has a wider view than pictures."""
LOOKS_AT_HEIGHT = 0.12
FIELD_OF_VIEW = 36.0
LIGHT_FROM = (0.5, 0.7, 1.6)
LIGHT_DISTANCE = 4.0
"""Of the light from the origin [m]: near ones take longer to cast shadows, which are grown far too large."""
BORDER_COLOUR: Colour = (0.62, 0.56, 0.48, 1.0)
BORDER_WIDTH = 0.004
"""Of the line around the table, beyond which an object is lost [m]."""
BORDER_HEIGHT, BORDER_PIECES = 0.0005, 12
"""How far it lies above the table [m], and into how many pieces each of its sides is cut."""
TABLE_COLOUR: Colour = (0.86, 0.82, 0.76, 1.0)
OPACITY = 0.45
"""Of the ghosts: objects where they shall come to be."""
DOT_RADIUS, BALL_RADIUS = WIDTH / 120, 0.007
"""Of the waypoints of an action, in pictures [pixels] and in a window [m]."""
BLANK: Frame = np.full((HEIGHT, WIDTH, 3), 255, dtype=np.uint8)
"""Stands for a picture that nobody wants to see."""
NO_SCREEN = "No window can be opened here, for want of a screen; leave out --gui to have pictures written."


class Lens:
    """Where a camera stands still, with the whole table, the hand and the arm in view, and what it draws."""

    def __init__(self, config: TabletopConfig):
        self.target = (sum(config.table_x) / 2, sum(config.table_y) / 2, LOOKS_AT_HEIGHT)
        self._view: tuple[float, ...] = pybullet.computeViewMatrixFromYawPitchRoll(
            cameraTargetPosition=self.target, distance=DISTANCE, yaw=YAW, pitch=PITCH, roll=0, upAxisIndex=2
        )
        self._projection: tuple[float, ...] = pybullet.computeProjectionMatrixFOV(
            fov=FIELD_OF_VIEW, aspect=WIDTH / HEIGHT, nearVal=0.05, farVal=5
        )

    def pixels(self, points: Float[np.ndarray, "N 3"]) -> Float[np.ndarray, "N 2"]:
        """Return where points in the world [m] lie in a picture, from its upper left corner."""
        view, projection = (np.reshape(matrix, (4, 4)).T for matrix in (self._view, self._projection))
        clip = np.column_stack([points, np.ones(len(points))]) @ (projection @ view).T  # (N, 4)
        return np.asarray((clip[:, :2] / clip[:, 3:] * [1, -1] + 1) / 2 * [WIDTH, HEIGHT])

    def draw(self, client: Client) -> tuple[Frame, Depths]:
        """Render what is in a physics client, without a screen."""
        _, _, colours, depths, _ = client.getCameraImage(
            WIDTH,
            HEIGHT,
            self._view,
            self._projection,
            lightDirection=LIGHT_FROM,
            lightDistance=LIGHT_DISTANCE,
            shadow=1,
            renderer=pybullet.ER_TINY_RENDERER,
            flags=pybullet.ER_NO_SEGMENTATION_MASK,
        )
        frame = np.array(colours, dtype=np.uint8).reshape(HEIGHT, WIDTH, 4)[:, :, :3]
        return frame, np.array(depths, dtype=float).reshape(HEIGHT, WIDTH)


class Camera:
    """A camera that looks over the table at the robot, or what a window shows of one interaction.

    Args:
        simulation: The scene.
        ghosts: Centres at which the objects are shown once more, transparently [m].
        wanted: Numbers of the pictures to draw, counted from 0; every other is blank. All, if not given.
        painter: Gives the colours of objects; by their number, if not given.
    """

    def __init__(
        self,
        simulation: Simulation,
        ghosts: Float[np.ndarray, "M 3"] | None = None,
        wanted: Container[int] | None = None,
        painter: Painter | None = None,
    ):
        self._simulation, self._client = simulation, simulation.client
        self._lens = Lens(simulation.config)
        self._wanted, self._centres = wanted, ghosts
        self._taken = 0
        self._waypoints: Float[np.ndarray, "3 3"] | None = None
        self._scene = simulation.observe()
        parts = (painted(painter, self._scene.features) / 255).tolist()
        self._colours: list[Colour] = [(red, green, blue, 1.0) for red, green, blue in parts]
        bodies, colours = (simulation.table, *simulation.bodies), (TABLE_COLOUR, *self._colours)
        for body, colour in zip(bodies, colours, strict=True):
            self._client.changeVisualShape(body, -1, rgbaColor=colour)
        _draw_border(self._client, simulation.config)
        self._is_live = self._client.getConnectionInfo()["connectionMethod"] == pybullet.GUI
        if self._is_live:
            self._began = time.monotonic() - simulation.ticks * simulation.config.time_step
            self._client.resetDebugVisualizerCamera(WINDOW_DISTANCE, YAW, PITCH, self._lens.target)
            self._add_ghosts(self._client, [(*colour[:3], OPACITY) for colour in self._colours])

    @cached_property
    def _ghosts(self) -> tuple[Frame, Depths] | None:
        """The ghosts as the camera sees them, and nothing else; drawn with the first picture that is wanted.

        TinyRenderer draws nothing transparently. So they stand in a physics client of their own, are rendered
        once, and are blended into each picture wherever nothing in it is nearer to the camera. The world that
        is pictured never holds them, so they cannot change what happens in it.
        """
        if self._centres is None:
            return None
        client = Client()
        try:
            self._add_ghosts(client, self._colours)
            return self._lens.draw(client)
        finally:
            client.disconnect()

    def _add_ghosts(self, client: Client, colours: Sequence[Colour]) -> None:
        """Add bodies that can be seen and not touched, but for objects whose centre is NaN."""
        if self._centres is None:
            return
        for index in np.flatnonzero(np.all(np.isfinite(self._centres), axis=1)).tolist():
            parts = self._simulation.shape_of(index, "visual")
            colour = [list(colours[index])] * len(parts["shapeTypes"])
            shape = client.createVisualShapeArray(**parts, rgbaColors=colour)
            pose = self._centres[index].tolist(), self._scene.orientations[index].tolist()
            client.createMultiBody(0, -1, shape, *pose)

    def mark(self, waypoints: Float[np.ndarray, "3 3"]) -> None:
        """Show waypoints [m] as dots in the pictures to come, or as small balls in a window."""
        self._waypoints = waypoints
        for place, colour in zip(waypoints.tolist() if self._is_live else (), DOT_COLOURS, strict=False):
            ball = self._client.createVisualShape(
                pybullet.GEOM_SPHERE, radius=BALL_RADIUS, rgbaColor=[*(part / 255 for part in colour), 1.0]
            )
            self._client.createMultiBody(0, -1, ball, place)

    def picture(self) -> Frame:
        """Render what the camera sees now; blank if it is not wanted, or is seen live in a window."""
        number = self._taken
        self._taken += 1
        if self._is_live:  # wait until as much time has passed as in the simulation
            due = self._began + self._simulation.ticks * self._simulation.config.time_step
            time.sleep(max(0.0, due - time.monotonic()))
            return BLANK
        if self._wanted is not None and number not in self._wanted:
            return BLANK
        frame, depths = self._lens.draw(self._client)
        if self._ghosts:
            ghosts, ghost_depths = self._ghosts
            seen = np.nonzero((ghost_depths < 1) & (ghost_depths <= depths))
            frame = frame.copy()
            frame[seen] = np.rint((1 - OPACITY) * frame[seen] + OPACITY * ghosts[seen])
        if self._waypoints is not None:
            frame = draw_dots(frame, self._lens.pixels(self._waypoints), DOT_RADIUS)
        return frame


def _draw_border(client: Client, config: TabletopConfig) -> None:
    """Draw a line around the table, that can be seen and not touched.

    The renderer looks at every pixel of the upright rectangle around a triangle. So a line that lies aslant
    in the picture is drawn as many short pieces, of which one side is seen.
    """
    sides = [(0, 0), (1, 0), (1, 1), (0, 1)]
    corners = np.array([(config.table_x[x], config.table_y[y]) for x, y in sides])
    outwards = (2 * np.array(sides) - 1) * BORDER_WIDTH / 2
    shares = np.linspace(0, 1, BORDER_PIECES, endpoint=False)[:, None]

    def rim(corners: Float[np.ndarray, "4 2"]) -> Float[np.ndarray, "P 3"]:
        ends = zip(corners, np.roll(corners, -1, axis=0), strict=True)
        points = np.concatenate([start + shares * (end - start) for start, end in ends])
        return np.column_stack([points, np.full(len(points), BORDER_HEIGHT)])

    inner, outer = rim(corners - outwards), rim(corners + outwards)
    here = np.arange(len(inner))
    there, out = np.roll(here, -1), len(inner)
    triangles = np.stack([here + out, there + out, there, here + out, there, here], axis=1)  # (P, 6)
    shape = client.createVisualShape(
        pybullet.GEOM_MESH,
        vertices=np.concatenate([inner, outer]).tolist(),
        indices=triangles.ravel().tolist(),
        normals=[(0.0, 0.0, 1.0)] * (2 * len(inner)),
        rgbaColor=BORDER_COLOUR,
    )
    client.createMultiBody(0, -1, shape, (0, 0, 0))


def open_window() -> Client:
    """Open a window and return the physics client behind it; raise `InvalidValue` if there is no screen."""
    if not _has_screen():
        raise InvalidValue(NO_SCREEN)
    try:
        client = Client(pybullet.GUI)
    except pybullet.error as error:
        raise InvalidValue(NO_SCREEN) from error
    if client.number < 0:
        raise InvalidValue(NO_SCREEN)
    for panel in (pybullet.COV_ENABLE_GUI, pybullet.COV_ENABLE_KEYBOARD_SHORTCUTS):
        client.configureDebugVisualizer(panel, 0)
    return client


def _has_screen() -> bool:
    """Say whether a window can be opened; PyBullet ends the whole process if it finds no X server."""
    if sys.platform != "linux":
        return True
    try:
        x11 = ctypes.CDLL("libX11.so.6")
    except OSError:
        return False
    x11.XOpenDisplay.restype = ctypes.c_void_p
    display = x11.XOpenDisplay(None)
    if display:
        x11.XCloseDisplay(ctypes.c_void_p(display))
    return bool(display)


# Poses of the simulation, and the simple bodies that the robot and the objects are drawn with

REST_HEIGHT = 0.35
"""How far above the tallest object there can be a hand waits that is only looked at [m]."""


class Poser:
    """Hands the poses of an interaction to a sink; it only looks, so nothing happens otherwise."""

    def __init__(self, simulation: Simulation, robot: Robot, sink: PoseSink):
        self._simulation, self._body, self._sink = simulation, robot.body, sink
        self._every = max(1, round(POSE_SECONDS / simulation.config.time_step))

    def look(self, phase: str) -> None:
        """Hand over a pose, with the phase of the motion, if it is time for one."""
        simulation = self._simulation
        if simulation.ticks % self._every == 0:
            scene, links = simulation.observe(), _links(self._body, simulation.client)
            seconds = simulation.ticks * simulation.config.time_step
            self._sink(Pose(seconds, phase, links, scene.positions, scene.orientations))


def links_at_rest(simulation: Simulation, arm: Arm) -> Float[np.ndarray, "L 7"]:
    """Return the poses of the links of an arm that waits above the near edge of the table."""
    c, robot = simulation.config, Robot(simulation, arm)
    point = np.array([c.table_x[0], sum(c.table_y) / 2, c.height[1] + REST_HEIGHT])
    robot.place_at(point, arm.half_opening)
    return _links(robot.body, simulation.client)


def _links(body: int, client: Client) -> Float[np.ndarray, "L 7"]:
    """Return where the frames of the base and of all links are."""
    base = client.getBasePositionAndOrientation(body)
    inertial = client.getDynamicsInfo(body, -1)[3:5]
    frame = pybullet.multiplyTransforms(*base, *pybullet.invertTransform(*inertial))
    states = client.getLinkStates(body, [*range(client.getNumJoints(body))])
    return np.array([[*place, *turn] for place, turn in (frame, *(state[4:6] for state in states))])


def robot_parts(arm: Arm) -> tuple[Part, ...]:
    """Return the simple bodies that the file of an arm draws it with, the base being link 0; no meshes."""
    with loaded(arm.urdf, arm.base, visible=True) as (client, body):
        found = client.getVisualShapeData(body)
    return tuple(
        Part(*_KINDS[kind](size), place, turn, link + 1, colour[:3])
        for _, link, kind, size, _, place, turn, colour, *_ in found
        if kind in _KINDS
    )


_KINDS: dict[int, Callable[[Sequence[float]], tuple[PartKind, tuple[float, ...]]]] = {
    pybullet.GEOM_BOX: lambda size: ("box", tuple(size)),
    pybullet.GEOM_CYLINDER: lambda size: ("cylinder", (size[1], size[0])),
    pybullet.GEOM_SPHERE: lambda size: ("sphere", (size[0],)),
}
"""What PyBullet's shapes are as parts; it gives a cylinder's length before its radius."""
