"""The tabletop as a depth camera sees it: what objects are and where they stand is told from images.

Objects of its scenes have sizes as they are seen, and the numbers by which the eye tells their crops. What
only the simulator knows goes along as `Scene.unseen`, relative to where an object is seen: nothing but the
simulator reads it, and an object that is moved by hand takes it along.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field, fields, replace
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from scipy.spatial.transform import Rotation

from neurosym.checks import Float
from neurosym.contract import ObjectLimits, Part
from neurosym.errors import InvalidValue, InvalidWorld
from neurosym.perception.regions import Region, Sight, regions_of, track_all
from neurosym.perception.seen_world import TOLD, SeenWorld
from neurosym.sim.config import TabletopConfig
from neurosym.sim.depth_camera import DepthCamera
from neurosym.sim.shapes import OPEN_THROUGH, OPEN_TOP, SOLID, UNSEEN
from neurosym.sim.simulation import Simulation
from neurosym.sim.tabletop import Tabletop
from neurosym.world import Outcome, Scene

SIZES = ("s_x", "s_y", "d")
"""Features that are seen by plain geometry; networks are not shown them."""
_FEATURES, _PLACE, _TURN = slice(0, 4), slice(4, 7), slice(7, 11)  # columns of `Scene.unseen`
_COLUMNS = 11
_OFF_UNIT = 0.01  # how far from 1 the length of a quaternion may be
_LARGEST = 1.0  # no object is larger [m]


@dataclass(frozen=True, slots=True)
class CameraTableConfig(TabletopConfig):
    """The options of the tabletop and of the camera over it, as they stand in `world.toml`.

    Attributes:
        camera: The camera.
    """

    camera: DepthCamera = field(default_factory=DepthCamera)

    @property
    def object_limits(self) -> ObjectLimits | None:  # type: ignore[override]
        """Nothing: what is seen has no limits."""
        return None


class CameraWorld(SeenWorld):
    """The tabletop, whose objects are known by what a camera sees.

    What an action does to its target is told as on the tabletop; where everything stands in the end is
    looked at again. What is not told apart then counts as where it was, or where the simulator says that it
    was set down.

    Args:
        config: Its options.
        eye: File with the eye; one that learned nothing yet if None, which tells nothing.
    """

    name = "camera"
    feature_names = (*SIZES, *TOLD)
    unshown = SIZES
    table_world: Tabletop

    def __init__(self, config: CameraTableConfig | None = None, eye: Path | None = None):
        self.config = config or CameraTableConfig()
        plain = {one.name: getattr(self.config, one.name) for one in fields(TabletopConfig)}
        beneath = TabletopConfig(**plain)
        super().__init__(Tabletop(beneath, self.name), partial(Tabletop, beneath), eye)
        self.config.camera.check_sees(self.config)

    def look(self, scene: Scene) -> list[Region]:
        """Find the objects of a scene, given as the simulator knows it, before the hand comes."""
        return regions_of(self.sight_of(scene))

    def sight_of(self, scene: Scene) -> Sight:
        """Look at a scene, given as the simulator knows it, before the hand comes."""
        simulation = Simulation(self.table_world.client(), self.table_world.config, scene)
        simulation.client.removeBody(simulation.table)  # the renderer would take most of its time for it
        poses = simulation.observe()
        seed = b"".join(one.tobytes() for one in (scene.features, poses.positions, poses.orientations))
        return self.config.camera.look(self.table_world.client(), seed)

    def told(self, scene: Scene, found: Sequence[Region]) -> Scene | None:
        """Return a scene as `seen` does, in which these objects were found."""
        if len(found) != len(scene):
            return None
        spots = np.array([one.position[:2] for one in found])
        nearest = [int(np.linalg.norm(spots - at[:2], axis=1).argmin()) for at in scene.positions]
        if len({*nearest}) != len(scene):
            return None
        shown = [found[number] for number in nearest]
        features = np.array([[*one.size, *self.eye.tell(one.crop)] for one in shown])
        turns = Rotation.from_euler("z", [[one.heading] for one in shown]).as_quat(canonical=True)
        return _with_truth(Scene(features, np.array([one.position for one in shown]), turns), scene)

    def beneath(self, scene: Scene) -> Scene:
        """Return a scene as the simulator knows it (see `truth_of`)."""
        return truth_of(scene)

    def witnessed(self, scene: Scene, done: Outcome, *, is_at_rest: bool = True) -> Outcome:
        """Return an outcome on the tabletop as it is seen, where it began with a scene that was seen so.

        What is not at rest in the end is where the simulator says.
        """
        lifted = _moved(scene, done.start, done.lifted)
        end = self._seen_again(scene, done) if is_at_rest else lifted
        return replace(done, start=scene, lifted=lifted if done.held else end, end=end)

    def _seen_again(self, scene: Scene, done: Outcome) -> Scene:
        """Return where objects are seen after an interaction."""
        still = np.all(done.start.positions == done.end.positions) and np.all(
            done.start.orientations == done.end.orientations
        )
        if still:
            return scene
        positions, orientations, target = scene.positions.copy(), scene.orientations.copy(), done.target
        if done.held or done.carried:  # where the simulator says that it was set down
            way = done.end.positions[target] - done.start.positions[target]
            turns = [Rotation.from_quat(one.orientations[target]) for one in (done.start, done.end)]
            (yaw,) = Rotation.from_euler("z", [[(turns[1] * turns[0].inv()).as_euler("zyx")[0]]])
            positions[target] += way
            orientations[target] = (yaw * Rotation.from_quat(orientations[target])).as_quat(canonical=True)
        sizes = scene.features[:, : len(SIZES)]
        sight = self.sight_of(done.end)
        told = track_all(sight, sizes, positions, orientations, target)
        return _with_truth(Scene(scene.features, told.positions, told.orientations), done.end)

    def object_parts(self, features: Float[np.ndarray, "F"], *unseen: Sequence[float]) -> tuple[Part, ...]:
        """Return what an object is drawn with: as it is, or else a box of the sizes that are seen."""
        if unseen and unseen[0]:
            known = np.array(unseen[0])
            return self.table_world.object_parts(known[_FEATURES], *([known[_COLUMNS:].tolist()]))
        return self.table_world.object_parts(np.array([*features[:3], 0.0]))

    def robot_parts(self) -> tuple[Part, ...]:
        """Return what the arm is drawn with (see `Posed.robot_parts`)."""
        return self.table_world.robot_parts()

    def robot_at_rest(self) -> Float[np.ndarray, "L 7"]:
        """Return the poses of the arm's links while it waits (see `Posed.robot_at_rest`)."""
        return self.table_world.robot_at_rest()

    def __reduce__(self) -> tuple[Any, ...]:
        return CameraWorld, (self.config, self._eye_file)


def _with_truth(seen: Scene, truth: Scene) -> Scene:
    """Add to what is seen what only the simulator knows, relative to that."""
    turns = Rotation.from_quat(seen.orientations)
    places = turns.inv().apply(truth.positions - seen.positions)
    relative = (turns.inv() * Rotation.from_quat(truth.orientations)).as_quat(canonical=True)
    unseen = np.column_stack([truth.features, places, relative, truth.unseen])
    return replace(seen, unseen=unseen)


def truth_of(scene: Scene) -> Scene:
    """Return a scene as the simulator knows it.

    Raises:
        InvalidWorld: If it does not say what only the simulator knows, or what cannot be.
    """
    known, told = scene.unseen, (_COLUMNS, _COLUMNS + len(UNSEEN))
    if (found := known.shape[1]) not in told:
        raise InvalidWorld(
            CameraWorld.name,
            f"needs what it does not see: of objects there are {found} `unseen` numbers; valid: "
            f"{told[0]} or {told[1]}, as `neurosym new-problem` writes them",
        )
    for number, (row, turn) in enumerate(zip(known.tolist(), scene.orientations, strict=True), 1):
        try:
            _check_truth(f"Object {number}", row, turn)
        except InvalidValue as error:
            raise InvalidWorld(CameraWorld.name, f"refuses the scene: {str(error).rstrip('.')}") from error
    turns = Rotation.from_quat(scene.orientations)
    return Scene(
        features=known[:, _FEATURES],
        positions=scene.positions + turns.apply(known[:, _PLACE]),
        orientations=(turns * Rotation.from_quat(known[:, _TURN])).as_quat(),
        unseen=known[:, _COLUMNS:],
    )


def _check_truth(item: str, unseen: list[float], seen_turn: Float[np.ndarray, "4"]) -> None:
    """Raise `InvalidValue` unless there can be such an object; `item` is what it is called."""
    sizes, kind = unseen[:3], unseen[3]
    if not all(0 < size <= _LARGEST for size in sizes):
        told = " x ".join(f"{size:g}" for size in sizes)
        raise InvalidValue(f"{item} is in truth {told} m large; valid: over 0 and at most {_LARGEST:g} m.")
    if kind not in (kinds := (SOLID, OPEN_TOP, OPEN_THROUGH)):
        valid = ", ".join(f"{one:g}" for one in kinds)
        raise InvalidValue(f"{item} has the true type {kind:g}; valid: {valid}.")
    for turn in (seen_turn, unseen[_TURN]):
        if not abs((length := float(np.linalg.norm(turn))) - 1) < _OFF_UNIT:
            raise InvalidValue(f"{item} is turned by a quaternion of length {length:g}; valid: 1.")
    if not np.all(np.isfinite(unseen)):
        raise InvalidValue(f"{item} has `unseen` numbers that are not finite.")
    TabletopConfig().object_limits.check_unseen(item, unseen[_COLUMNS:])


def _moved(scene: Scene, start: Scene, end: Scene) -> Scene:
    """Return where objects are that were seen somewhere, after they moved from one pose to another."""
    turns = Rotation.from_quat(end.orientations) * Rotation.from_quat(start.orientations).inv()
    moved = (turns * Rotation.from_quat(scene.orientations)).as_quat(canonical=True)
    return _with_truth(Scene(scene.features, scene.positions + end.positions - start.positions, moved), end)
