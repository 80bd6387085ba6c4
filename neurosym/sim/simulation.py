"""A fresh PyBullet simulation of one scene: table, objects, and what can be seen of them."""

from collections.abc import Callable

import numpy as np

from neurosym.sim.bullet import Client, pybullet
from neurosym.sim.config import TabletopConfig
from neurosym.sim.shapes import boxes_of
from neurosym.world import Scene

TABLE_FRICTION = 0.6
REST_SPEED = 2e-3
"""Objects count as at rest below this speed [m/s]."""
REST_TIME, SETTLE_LIMIT = 0.05, 2.0
_LOOK_EVERY = 4


class Simulation:
    """One scene in a physics client, built anew so that nothing an earlier one did can show.

    Same scene, same bytes, rests on two things: everything is reset and made again in the same order, and
    PyBullet is told to sort its pairs of touching objects (`deterministicOverlappingPairs`).

    Args:
        client: The physics client; everything in it is replaced.
        config: What the world is made of.
        scene: The objects, at rest.

    Attributes:
        after_step: Called after each step, once it is set.
    """

    def __init__(self, client: Client, config: TabletopConfig, scene: Scene):
        self.client = client
        self.config = config
        self.features = scene.features
        self.after_step: Callable[[], None] | None = None
        self.ticks = 0
        self._reset()
        self.table = self._make_table()
        self.bodies = [self._make_object(scene, index) for index in range(len(scene))]

    def _reset(self) -> None:
        self.client.resetSimulation()
        self.client.setPhysicsEngineParameter(
            fixedTimeStep=self.config.time_step, numSolverIterations=50, deterministicOverlappingPairs=1
        )
        self.client.setGravity(0, 0, -9.81)

    def _make_table(self) -> int:
        c = self.config
        half = (np.ptp(c.table_x) / 2 + 0.25, np.ptp(c.table_y) / 2 + 0.25, 0.02)
        shape = self.client.createCollisionShape(pybullet.GEOM_BOX, halfExtents=half)
        centre = (sum(c.table_x) / 2, sum(c.table_y) / 2, -0.02)
        table = self.client.createMultiBody(0, shape, -1, centre)
        self.client.changeDynamics(table, -1, lateralFriction=TABLE_FRICTION)
        return int(table)

    def _make_object(self, scene: Scene, index: int) -> int:
        boxes = boxes_of(scene.features[index], self.config.wall)
        shape = self.client.createCollisionShapeArray(
            shapeTypes=[pybullet.GEOM_BOX] * len(boxes),
            halfExtents=[list(half) for half, _, _ in boxes],
            collisionFramePositions=[list(centre) for _, centre, _ in boxes],
            collisionFrameOrientations=[pybullet.getQuaternionFromEuler((0, 0, turn)) for *_, turn in boxes],
        )
        body = self.client.createMultiBody(
            self.config.mass, shape, -1, scene.positions[index].tolist(), scene.orientations[index].tolist()
        )
        self.client.changeDynamics(
            body, -1, lateralFriction=self.config.friction, spinningFriction=0.002, rollingFriction=0.0
        )
        return int(body)

    def step(self) -> None:
        """Advance time by one step."""
        self.client.stepSimulation()
        self.ticks += 1
        if self.after_step is not None:
            self.after_step()

    def settle(self) -> None:
        """Step until every object has been at rest for a while."""
        quiet = 0.0
        for tick in range(int(SETTLE_LIMIT / self.config.time_step)):
            self.step()
            if tick % _LOOK_EVERY == 0:
                quiet = quiet + _LOOK_EVERY * self.config.time_step if self._is_quiet() else 0.0
                if quiet >= REST_TIME:
                    return

    def _is_quiet(self) -> bool:
        for body in self.bodies:
            linear, angular = self.client.getBaseVelocity(body)
            if max(map(abs, linear)) > REST_SPEED or max(map(abs, angular)) > 10 * REST_SPEED:
                return False
        return True

    def observe(self) -> Scene:
        """Return where everything is now."""
        poses = [self.client.getBasePositionAndOrientation(body) for body in self.bodies]
        return Scene(
            features=self.features,
            positions=np.array([position for position, _ in poses]),
            orientations=np.array([orientation for _, orientation in poses]),
        )

    def height_of(self, index: int) -> float:
        """Return the height of an object's centre [m]."""
        position, _ = self.client.getBasePositionAndOrientation(self.bodies[index])
        return float(position[2])

    def touch(self, body: int, other: int) -> bool:
        """Say whether two bodies touch."""
        return bool(self.client.getContactPoints(body, other))

    def touched_by(self, body: int) -> set[int]:
        """Return the bodies that a body touches."""
        contacts = self.client.getContactPoints(body)
        return {contact[2] for contact in contacts} - {body}
