"""One interaction in PyBullet, from empty hand to empty hand.

The protocol: spawn, settle, record; hand clear of every object; for each of three waypoints set the gripper,
then move there in a straight line; rise; record the effect and whether something is held; if so, lower it
straight down until it stands, let go, rise, settle; record the resting effect.
"""

import math

import numpy as np
import pybullet
from jaxtyping import Float

from neurosym.sim.camera import Camera
from neurosym.sim.config import TabletopConfig
from neurosym.sim.robot import (
    FINGER_HALF_WIDTH,
    FINGER_LENGTH,
    FINGER_THICKNESS,
    HALF_OPENING,
    LOWEST_TOOL_POINT,
    PALM_HALF_SIZE,
    Robot,
)
from neurosym.sim.shapes import boxes_of
from neurosym.world import FrameSink, Outcome, Scene

CLEARANCE = 0.005
"""The hand starts at least this far above whatever it would otherwise touch [m]."""
RELEASE_OPENING = 0.015
"""How far each finger opens to let go of an object that stands on the table [m]."""
LOWERING_SPEED = 0.25
"""Greatest speed of a held object on its way down [m/s]."""
TOPPLED_COSINE = math.cos(math.radians(30))
"""An object has toppled when its up axis has turned by more than 30 degrees."""
REST_SPEED = 2e-3
"""Objects count as at rest below this speed [m/s]."""
REST_TIME, SETTLE_LIMIT = 0.05, 2.0
TABLE_FRICTION = 0.6
_WATCH_EVERY = 8


class Interaction:
    """A fresh simulation of one scene, and the steps of the protocol on it.

    Args:
        client: The physics client; everything in it is replaced.
        config: What the world is made of.
        scene: The objects, at rest.
        target: Index of the object acted upon.
        on_frame: Called with pictures of the motion, if given.
    """

    def __init__(
        self, client: int, config: TabletopConfig, scene: Scene, target: int, on_frame: FrameSink | None
    ):
        self._client = client
        self._config = config
        self._features = scene.features
        self._target = target
        self._on_frame = on_frame
        self._ticks = 0
        self._peak = -math.inf
        self._reset_simulation()
        self._table = self._make_table()
        self._bodies = [self._make_object(scene, index) for index in range(len(scene))]
        self._robot = Robot(client, config.time_step, self._step)
        self._camera = Camera(client, config, scene) if on_frame else None

    def perform(self, action: Float[np.ndarray, "A"], put_down: bool) -> Outcome:
        """Run the protocol with these action parameters.

        Args:
            action: Three waypoints (x, y, z, g), relative to the target's centre.
            put_down: Whether to put down an object that is held after the rise.
        """
        waypoints = action.reshape(3, 4)
        self._park_robot()
        self._settle()
        start = self._observe()
        self._peak = start.positions[self._target][2]
        centre = start.positions[self._target]
        self._approach(centre + waypoints[0, :3], bool(waypoints[0, 3] >= 0.5))
        for waypoint in waypoints:
            self._set_gripper(bool(waypoint[3] >= 0.5))
            self._robot.move_to(centre + waypoint[:3])
        self._rise()
        self._settle()
        lifted = self._observe()
        held = self._is_held()
        if held and put_down:
            self._put_down()
        end = self._observe() if held and put_down else lifted
        return Outcome(
            start=start,
            lifted=lifted,
            end=end,
            target=self._target,
            held=held,
            toppled=self._has_toppled(start, end),
            lost=not self._config.table.contains(end.positions[self._target]),
            peak_height=float(self._peak - centre[2]),
        )

    def _reset_simulation(self) -> None:
        pybullet.resetSimulation(physicsClientId=self._client)
        pybullet.setPhysicsEngineParameter(
            fixedTimeStep=self._config.time_step,
            numSolverIterations=50,
            deterministicOverlappingPairs=1,
            physicsClientId=self._client,
        )
        pybullet.setGravity(0, 0, -9.81, physicsClientId=self._client)

    def _make_table(self) -> int:
        c = self._config
        half = (np.ptp(c.table_x) / 2 + 0.25, np.ptp(c.table_y) / 2 + 0.25, 0.02)
        shape = pybullet.createCollisionShape(
            pybullet.GEOM_BOX, halfExtents=half, physicsClientId=self._client
        )
        centre = (sum(c.table_x) / 2, sum(c.table_y) / 2, -0.02)
        table = pybullet.createMultiBody(0, shape, -1, centre, physicsClientId=self._client)
        pybullet.changeDynamics(table, -1, lateralFriction=TABLE_FRICTION, physicsClientId=self._client)
        return int(table)

    def _make_object(self, scene: Scene, index: int) -> int:
        boxes = boxes_of(scene.features[index], self._config.wall)
        shape = pybullet.createCollisionShapeArray(
            shapeTypes=[pybullet.GEOM_BOX] * len(boxes),
            halfExtents=[list(half) for half, _ in boxes],
            collisionFramePositions=[list(centre) for _, centre in boxes],
            physicsClientId=self._client,
        )
        body = pybullet.createMultiBody(
            self._config.mass,
            shape,
            -1,
            scene.positions[index].tolist(),
            scene.orientations[index].tolist(),
            physicsClientId=self._client,
        )
        pybullet.changeDynamics(
            body,
            -1,
            lateralFriction=self._config.friction,
            spinningFriction=0.002,
            rollingFriction=0.0,
            physicsClientId=self._client,
        )
        return int(body)

    def _step(self) -> None:
        pybullet.stepSimulation(physicsClientId=self._client)
        self._ticks += 1
        if self._ticks % _WATCH_EVERY == 0:
            self._peak = max(self._peak, self._position(self._target)[2])
        if self._camera and self._on_frame and self._ticks % self._config.frame_every == 0:
            self._on_frame(self._camera.picture())

    def _position(self, index: int) -> tuple[float, float, float]:
        position, _ = pybullet.getBasePositionAndOrientation(
            self._bodies[index], physicsClientId=self._client
        )
        return position  # type: ignore[no-any-return]

    def _observe(self) -> Scene:
        poses = [
            pybullet.getBasePositionAndOrientation(body, physicsClientId=self._client)
            for body in self._bodies
        ]
        return Scene(
            features=self._features,
            positions=np.array([position for position, _ in poses]),
            orientations=np.array([orientation for _, orientation in poses]),
        )

    def _settle(self) -> None:
        """Step until every object has been at rest for a while."""
        quiet = 0.0
        for _ in range(int(SETTLE_LIMIT / self._config.time_step)):
            self._step()
            quiet = quiet + self._config.time_step if self._is_quiet() else 0.0
            if quiet >= REST_TIME:
                return

    def _is_quiet(self) -> bool:
        for body in self._bodies:
            linear, angular = pybullet.getBaseVelocity(body, physicsClientId=self._client)
            if max(map(abs, linear)) > REST_SPEED or max(map(abs, angular)) > 10 * REST_SPEED:
                return False
        return True

    def _park_robot(self) -> None:
        """Put the hand high above the table's middle, out of every object's way."""
        c = self._config
        point = np.array([sum(c.table_x) / 2, sum(c.table_y) / 2, 0.35])
        self._robot.place_at(point, HALF_OPENING)

    def _approach(self, point: Float[np.ndarray, "3"], is_open: bool) -> None:
        """Put the hand above the first waypoint, just clear of every object.

        From there the first motion leads straight down, as a hand coming from above would.
        """
        half_opening = HALF_OPENING if is_open else 0.0
        height = max(float(point[2]), LOWEST_TOOL_POINT, self._clear_height(point, half_opening))
        self._robot.place_at(np.array([point[0], point[1], height]), half_opening)

    def _clear_height(self, point: Float[np.ndarray, "3"], half_opening: float) -> float:
        """Return the least height of the tool point at which no part of the hand touches an object [m]."""
        offset = half_opening + FINGER_THICKNESS / 2
        finger = (FINGER_HALF_WIDTH, FINGER_THICKNESS / 2)
        parts = (
            (point[1] + offset, finger, 0.0),
            (point[1] - offset, finger, 0.0),
            (point[1], PALM_HALF_SIZE, FINGER_LENGTH),
        )
        heights = [0.0]
        for body in self._bodies:
            low, high = pybullet.getAABB(body, physicsClientId=self._client)
            for y, (half_x, half_y), above_tool_point in parts:
                if (
                    low[0] - half_x < point[0] + CLEARANCE
                    and point[0] - CLEARANCE < high[0] + half_x
                    and low[1] - half_y < y + CLEARANCE
                    and y - CLEARANCE < high[1] + half_y
                ):
                    heights.append(high[2] + CLEARANCE - above_tool_point)
        return max(heights)

    def _set_gripper(self, is_open: bool) -> None:
        if is_open != self._robot.is_open:
            self._robot.open() if is_open else self._robot.close()

    def _rise(self) -> None:
        self._robot.move_to(self._robot.tool_point() + np.array([0.0, 0.0, self._config.lift_height]))

    def _is_held(self) -> bool:
        body = self._bodies[self._target]
        others = [self._table, *(other for other in self._bodies if other != body)]
        return self._touches(self._robot.body) and not any(self._touches(other) for other in others)

    def _touches(self, other: int) -> bool:
        contacts = pybullet.getContactPoints(self._bodies[self._target], other, physicsClientId=self._client)
        return bool(contacts)

    def _put_down(self) -> None:
        """Lower the object until it stands on something, let go, and draw the hand back."""
        above = self._robot.tool_point()
        self._robot.move_to(
            np.array([above[0], above[1], 0.0]),
            peak_speed=LOWERING_SPEED,
            until=lambda: self._touches(self._table),
        )
        self._robot.open(self._robot.half_opening() + RELEASE_OPENING)
        self._rise()
        self._settle()

    def _has_toppled(self, start: Scene, end: Scene) -> bool:
        before, after = _up(start.orientations[self._target]), _up(end.orientations[self._target])
        return bool(before @ after < TOPPLED_COSINE)


def _up(quaternion: Float[np.ndarray, "4"]) -> Float[np.ndarray, "3"]:
    """Return the object's own z axis in the world."""
    return np.array(pybullet.getMatrixFromQuaternion(quaternion)).reshape(3, 3)[:, 2]
