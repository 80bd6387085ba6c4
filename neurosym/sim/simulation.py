"""A fresh PyBullet simulation of one scene: table, objects, and what can be seen of them."""

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from neurosym.checks import Float
from neurosym.errors import InvalidValue
from neurosym.sim.config import Client, TabletopConfig, pybullet
from neurosym.sim.shapes import UNSEEN, Body, body_of, draw_object
from neurosym.world import Scene

TABLE_FRICTION = 0.6
ROLLING_FRICTION = 0.001
"""Of balls, that would else roll for ever."""
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
        self._reset()
        self.table = self._make_table()
        self._boxes: list[tuple[np.ndarray, np.ndarray]] = []  # in the object's frame: middles, half sizes
        self._centres = np.zeros((len(scene), 3))  # of mass, in the objects' frames [m]
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
        made = built(scene, index, self.config)
        self._boxes.append(_around(made))
        self._centres[index] = made.centre_of_mass
        shape = self.client.createCollisionShapeArray(**shape_array(made, "collision"))
        pose = scene.positions[index].tolist(), scene.orientations[index].tolist()
        offset = {"baseInertialFramePosition": made.centre_of_mass} if any(made.centre_of_mass) else {}
        body = self.client.createMultiBody(made.mass, shape, -1, *pose, **offset)
        self.client.changeDynamics(
            body,
            -1,
            lateralFriction=made.friction,
            spinningFriction=0.002,
            rollingFriction=ROLLING_FRICTION if made.rolls else 0.0,
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
                quiet = quiet + _LOOK_EVERY * self.config.time_step if self.is_quiet() else 0.0
                if quiet >= REST_TIME:
                    return

    def is_quiet(self) -> bool:
        """Say whether every object is at rest."""
        velocities = map(self.client.getBaseVelocity, self.bodies)
        return all(
            max(map(abs, linear)) <= REST_SPEED and max(map(abs, angular)) <= 10 * REST_SPEED
            for linear, angular in velocities
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
        if self._centres[index].any():
            turned = np.array(pybullet.getMatrixFromQuaternion(orientation)).reshape(3, 3)
            position = (position - turned @ self._centres[index]).tolist()
        return position, orientation

    def height_of(self, index: int) -> float:
        """Return the height of an object's centre [m]."""
        return float(self._pose(index)[0][2])

    def boxes(self) -> Float[np.ndarray, "B 2 3"]:
        """Return least and greatest corners of what is around each box that objects are built from [m]."""
        found = []
        for index, (centres, halves) in enumerate(self._boxes):
            position, orientation = self._pose(index)
            turned = np.array(pybullet.getMatrixFromQuaternion(orientation)).reshape(3, 3).T
            middles, around = position + centres @ turned, halves @ np.abs(turned)
            found.append(np.stack([middles - around, middles + around], axis=1))
        return np.concatenate(found)

    def touched_by(self, body: int) -> set[int]:
        """Return the bodies that a body touches."""
        contacts = self.client.getContactPoints(body)
        return {contact[2] for contact in contacts} - {body}


def built(scene: Scene, index: int, config: TabletopConfig) -> Body:
    """Say what an object of a scene is built from in a world."""
    unseen = scene.unseen[index].tolist()
    like = {"wall": config.wall, "mass": config.mass, "friction": config.friction}
    return body_of(scene.features[index], unseen, **like)


def shape_array(body: Body, use: str) -> dict[str, Any]:
    """Return what PyBullet makes the shape of a body from, to collide with or to be seen (`visual`)."""
    kinds = {"box": pybullet.GEOM_BOX, "sphere": pybullet.GEOM_SPHERE}
    return {
        "shapeTypes": [kinds[part.kind] for part in body.parts],
        "halfExtents": [[edge / 2 for edge in (part.size * 3)[:3]] for part in body.parts],
        "radii": [part.size[0] for part in body.parts],
        f"{use}FramePositions": [list(part.position) for part in body.parts],
        f"{use}FrameOrientations": [list(part.orientation) for part in body.parts],
    }


def _around(body: Body) -> tuple[Float[np.ndarray, "B 3"], Float[np.ndarray, "B 3"]]:
    """Return middles and half sizes of boxes around the parts of a body, in its frame [m]."""
    middles, halves = [], []
    for part in body.parts:
        turned = np.abs(np.array(pybullet.getMatrixFromQuaternion(part.orientation)).reshape(3, 3))
        half = [part.size[0]] * 3 if part.kind == "sphere" else [edge / 2 for edge in part.size]
        middles.append(part.position)
        halves.append(turned @ half)
    return np.array(middles), np.array(halves)


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
        features, unseen = sample_objects(config, rng, objects)
        places = _sample_places(config, rng, features[:, :2] / 2)
        if places is not None:
            return Scene(
                features=features,
                positions=np.column_stack([places, features[:, 2] / 2]),
                orientations=np.tile([0.0, 0.0, 0.0, 1.0], (objects, 1)),
                unseen=unseen,
            )
    raise InvalidValue(f"{objects} objects do not fit on the table; ask for fewer.")


def sample_objects(
    config: TabletopConfig, rng: np.random.Generator, objects: int
) -> tuple[Float[np.ndarray, "{objects} 4"], Float[np.ndarray, "{objects} U"]]:
    """Draw what the objects are: s_x, s_y, d [m] and t, and what is not seen of them, if there is anything.

    Args:
        config: The world.
        rng: Source of randomness, owned by the caller.
        objects: How many objects.
    """
    names = list(config.shapes)
    shares = np.array([config.shapes[name] for name in names])
    drawn = rng.choice(len(names), size=objects, p=shares / shares.sum())
    rows = [draw_object(rng, names[shape], config.size, config.height) for shape in drawn]
    unseen = np.zeros((objects, len(UNSEEN) if any(number for _, number in rows) else 0))
    if unseen.size:
        unseen[:, 0] = [number for _, number in rows]
    return np.array([features for features, _ in rows]), unseen


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
