"""A fresh PyBullet simulation of one scene: table, objects, and what can be seen of them."""

from collections.abc import Callable, Iterable, Sequence
from typing import Any

import numpy as np

from neurosym.checks import Float
from neurosym.contract import FINGER_SPEED
from neurosym.errors import InvalidValue
from neurosym.sim.config import (
    FINGER_FRICTION,
    FINGER_TWISTING_FRICTION,
    OBJECT_TWISTING_FRICTION,
    ROLLING_FRICTION,
    TABLE_FRICTION,
    Arm,
    Client,
    TabletopConfig,
    pybullet,
)
from neurosym.sim.joints import Joints
from neurosym.sim.shapes import body_of, sample_objects
from neurosym.world import Scene

REST_SPEED = 2e-3
"""Objects count as at rest below this speed [m/s]."""
REST_TIME, SETTLE_LIMIT = 0.05, 2.0
_LOOK_EVERY = 4


class Simulation:
    """One scene in a physics client, built anew so that nothing an earlier one did can show.

    Same scene, same bytes, rests on two things: everything is reset and made again in the same order, and
    PyBullet is told to sort its pairs of touching objects (`deterministicOverlappingPairs`). `after_step` is
    called after each step, once it is set.
    """

    def __init__(self, client: Client, config: TabletopConfig, scene: Scene):
        self.client, self.config, self.features, self.unseen = client, config, scene.features, scene.unseen
        self.after_step: Callable[[], None] | None = None
        self.ticks = 0
        usual = {"wall": config.wall, "mass": config.mass, "friction": config.friction}
        rows = zip(scene.features, scene.unseen.tolist(), strict=True)
        self._made = [body_of(features, unseen, **usual) for features, unseen in rows]
        self.table, self.bodies = self._build(scene)

    def _build(self, scene: Scene) -> tuple[int, list[int]]:
        """Make the table and the objects, and return which bodies they are."""
        self._reset()
        return self._make_table(), [self._make_object(scene, index) for index in range(len(scene))]

    def _reset(self) -> None:
        self.client.resetSimulation()
        self.client.setPhysicsEngineParameter(
            fixedTimeStep=self.config.time_step, numSolverIterations=50, deterministicOverlappingPairs=1
        )
        self.client.setGravity(0, 0, -9.81)

    def _make_table(self) -> int:
        centre, half = self.config.table_box
        shape = self.client.createCollisionShape(pybullet.GEOM_BOX, halfExtents=half)
        table = self.client.createMultiBody(0, shape, -1, centre)
        self.client.changeDynamics(table, -1, lateralFriction=TABLE_FRICTION)
        return int(table)

    def _make_object(self, scene: Scene, index: int) -> int:
        made = self._made[index]
        shape = self.client.createCollisionShapeArray(**self.shape_of(index, "collision"))
        pose = scene.positions[index].tolist(), scene.orientations[index].tolist()
        offset = {"baseInertialFramePosition": made.centre_of_mass} if any(made.centre_of_mass) else {}
        body = self.client.createMultiBody(made.mass, shape, -1, *pose, **offset)
        self.client.changeDynamics(
            body,
            -1,
            lateralFriction=made.friction,
            spinningFriction=OBJECT_TWISTING_FRICTION,
            rollingFriction=ROLLING_FRICTION if made.is_ball else 0.0,
        )
        return int(body)

    def shape_of(self, index: int, use: str) -> dict[str, Any]:
        """Return what PyBullet makes the shape of an object from, for `collision` or `visual`."""
        made = self._made[index]
        return {
            "shapeTypes": [pybullet.GEOM_SPHERE if made.is_ball else pybullet.GEOM_BOX] * len(made.boxes),
            "halfExtents": [list(half) for half, _, _ in made.boxes],
            "radii": [half[0] for half, _, _ in made.boxes],
            f"{use}FramePositions": [list(centre) for _, centre, _ in made.boxes],
            f"{use}FrameOrientations": [
                pybullet.getQuaternionFromEuler((0, 0, turn)) for *_, turn in made.boxes
            ],
        }

    def joints_of(self, arm: Arm, *, visible: bool) -> Joints:
        """Load an arm, with its looks if it shall be visible, and return its joints."""
        return _BulletJoints(self.client, arm, visible=visible)

    def step(self) -> None:
        """Advance time by one step."""
        self.client.stepSimulation()
        self._stepped()

    def _stepped(self) -> None:
        self.ticks += 1
        if self.after_step is not None:
            self.after_step()

    def settle(self) -> None:
        """Step until every object has been at rest for a while."""
        quiet = 0.0
        for tick in range(int(SETTLE_LIMIT / self.config.time_step)):
            self.step()
            if tick % _LOOK_EVERY == 0:
                quiet = quiet + _LOOK_EVERY * self.config.time_step if self.is_quiet() else 0.0
                if quiet >= REST_TIME:
                    return

    def is_quiet(self) -> bool:
        """Say whether every object is at rest."""
        velocities = map(self.client.getBaseVelocity, self.bodies)
        return self._are_at_rest((*linear, *angular) for linear, angular in velocities)

    @staticmethod
    def _are_at_rest(velocities: Iterable[Sequence[float]]) -> bool:
        """Say whether velocities, three linear [m/s] and three angular [rad/s], are small enough."""
        return all(
            max(map(abs, both[:3])) <= REST_SPEED and max(map(abs, both[3:])) <= 10 * REST_SPEED
            for both in velocities
        )

    def observe(self) -> Scene:
        """Return where everything is now."""
        poses = [self._pose(index) for index in range(len(self.bodies))]
        return Scene(
            features=self.features,
            positions=np.array([position for position, _ in poses]),
            orientations=np.array([orientation for _, orientation in poses]),
            unseen=self.unseen,
        )

    def _pose(self, index: int) -> tuple[Sequence[float], Sequence[float]]:
        """Return where the middle of an object is [m], and its orientation; PyBullet tells of its mass."""
        position, orientation = self.client.getBasePositionAndOrientation(self.bodies[index])
        centre = self._made[index].centre_of_mass
        if any(centre):
            turned = np.array(pybullet.getMatrixFromQuaternion(orientation)).reshape(3, 3)
            position = (position - turned @ centre).tolist()
        return position, orientation

    def height_of(self, index: int) -> float:
        """Return the height of an object's centre [m]."""
        return float(self._pose(index)[0][2])

    def boxes(self) -> Float[np.ndarray, "B 2 3"]:
        """Return least and greatest corners of what is around each box that objects are built from [m]."""
        return np.concatenate([self.boxes_of(index) for index in range(len(self._made))])

    def boxes_of(self, index: int) -> Float[np.ndarray, "B 2 3"]:
        """Return least and greatest corners of what is around each box that an object is built from [m]."""
        (position, orientation), (centres, halves) = self._pose(index), self._made[index].around
        turned = np.array(pybullet.getMatrixFromQuaternion(orientation)).reshape(3, 3).T
        middles, around = position + centres @ turned, halves @ np.abs(turned)
        return np.stack([middles - around, middles + around], axis=1)

    def around(self, index: int) -> tuple[Sequence[float], Sequence[float]]:
        """Return least and greatest corner of a straight box around an object, as the engine has it [m]."""
        low, high = self.client.getAABB(self.bodies[index])
        return low, high

    def touched_by(self, body: int) -> set[int]:
        """Return the bodies that a body touches."""
        contacts = self.client.getContactPoints(body)
        return {contact[2] for contact in contacts} - {body}


class _BulletJoints:
    """The joints in PyBullet.

    Args:
        client: Where the arm is loaded.
        arm: What it is.
        visible: Whether it is loaded with its looks, which takes longer.
    """

    def __init__(self, client: Client, arm: Arm, *, visible: bool = False):
        self._client, self._arm = client, arm
        flags = pybullet.URDF_USE_INERTIA_FROM_FILE
        flags |= 0 if visible else pybullet.URDF_IGNORE_VISUAL_SHAPES
        self.body = body = client.loadURDF(arm.urdf, arm.base, useFixedBase=True, flags=flags)
        for link in range(client.getNumJoints(body) if arm.mass_scale != 1.0 else 0):
            info = client.getDynamicsInfo(body, link)
            mass, inertia = info[0] * arm.mass_scale, [arm.mass_scale * axis for axis in info[2]]
            client.changeDynamics(body, link, mass=mass, localInertiaDiagonal=inertia)
        frictions = {"lateralFriction": FINGER_FRICTION, "spinningFriction": FINGER_TWISTING_FRICTION}
        for finger in arm.fingers:
            client.changeDynamics(body, finger, jointLowerLimit=0.0, **frictions)
        left, right = arm.fingers
        axis, middle = [0, 1, 0], [0, 0, 0]
        gear = client.createConstraint(body, left, body, right, pybullet.JOINT_GEAR, axis, middle, middle)
        client.changeConstraint(gear, gearRatio=-1, maxForce=200, erp=0.5)

    def put(self, joints: Sequence[int], positions: Sequence[float], speeds: Sequence[float]) -> None:
        """Put some joints somewhere at once (see `Joints.put`)."""
        for joint, position, speed in zip(joints, positions, speeds, strict=True):
            self._client.resetJointState(self.body, joint, position, speed)

    def tool_point(self) -> Float[np.ndarray, "3"]:
        """Return where the tool point is in the world [m]."""
        state = self._client.getLinkState(self.body, self._arm.tool)
        return np.array(state[4])

    def half_opening(self) -> float:
        """Return how far each finger stands from the middle [m]."""
        return float(self._client.getJointState(self.body, self._arm.fingers[0])[0])

    def drive_arm(self, angles: Sequence[float], speeds: Sequence[float]) -> None:
        """Drive the arm's joints (see `Joints.drive_arm`)."""
        self._client.setJointMotorControlArray(
            self.body,
            self._arm.joints,
            pybullet.POSITION_CONTROL,
            targetPositions=angles,
            targetVelocities=speeds,
            forces=self._arm.forces,
        )

    def drive_fingers(self, half_opening: float, force: float) -> None:
        """Drive each finger (see `Joints.drive_fingers`)."""
        for finger in self._arm.fingers:
            self._client.setJointMotorControl2(
                self.body,
                finger,
                pybullet.POSITION_CONTROL,
                targetPosition=half_opening,
                force=force,
                maxVelocity=FINGER_SPEED,
            )


# Scenes drawn at random: objects of every shape and size, at rest and apart from one another

ROOMY = 2
"""So many objects, or fewer, keep `spawn_margin` from the table's edge, so that pushes do not lose them."""
_DRAWS = 50  # of objects, if their places cannot be found
_ATTEMPTS = 400  # to find places for given objects


def sample_scene(config: TabletopConfig, rng: np.random.Generator, objects: int) -> Scene:
    """Draw objects of random shape and size at rest on the table, not overlapping.

    Objects that find no place are drawn again, so that crowded scenes have somewhat smaller ones. Raises
    `InvalidValue` if there are none, or so many do not fit.
    """
    if objects < 1:
        raise InvalidValue(f"A scene needs at least one object, not {objects}.")
    for _ in range(_DRAWS):
        features, unseen = sample_objects(
            rng, objects, shapes=config.shapes, size=config.size, height=config.height
        )
        places = _sample_places(config, rng, features[:, :2] / 2)
        if places is not None:
            return Scene(
                features=features,
                positions=np.column_stack([places, features[:, 2] / 2]),
                orientations=np.tile([0.0, 0.0, 0.0, 1.0], (objects, 1)),
                unseen=unseen,
            )
    raise InvalidValue(f"{objects} objects do not fit on the table; ask for fewer.")


def _sample_places(
    config: TabletopConfig, rng: np.random.Generator, half_sizes: Float[np.ndarray, "M 2"]
) -> Float[np.ndarray, "M 2"] | None:
    """Find a place for each object, largest first; None if one finds none."""
    low = np.array([config.table_x[0], config.table_y[0]])
    high = np.array([config.table_x[1], config.table_y[1]])
    margins = np.maximum(half_sizes, config.spawn_margin if len(half_sizes) <= ROOMY else 0.0)
    order = np.argsort(-half_sizes.prod(axis=1), kind="stable")
    places = np.zeros_like(half_sizes)
    for number, index in enumerate(order):
        placed = order[:number]
        candidates = rng.uniform(low + margins[index], high - margins[index], size=(_ATTEMPTS, 2))
        apart = np.abs(candidates[:, None] - places[placed]) - (half_sizes[placed] + half_sizes[index])
        clear = (apart.max(axis=-1) >= config.spawn_gap).all(axis=-1)  # (_ATTEMPTS,)
        if not clear.any():
            return None
        places[index] = candidates[np.argmax(clear)]
    return places
