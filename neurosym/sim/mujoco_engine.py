"""The same scenes, arm and hand in MuJoCo, a second engine behind the tabletop world.

It is told of objects and of the arm what PyBullet is told, and frictions are the same products for each pair
that can touch. Contacts are soft, and motors are springs with dampers. PyBullet draws what is watched.
"""

import math
from collections.abc import Sequence
from functools import cache
from itertools import combinations, product

import mujoco
import numpy as np

from neurosym.checks import Float
from neurosym.contract import FINGER_SPEED
from neurosym.errors import InvalidArm
from neurosym.sim.config import (
    FINGER_FRICTION,
    FINGER_TWISTING_FRICTION,
    OBJECT_TWISTING_FRICTION,
    ROLLING_FRICTION,
    TABLE_FRICTION,
    Arm,
    Client,
    TabletopConfig,
    loaded,
)
from neurosym.sim.joints import Joints
from neurosym.sim.simulation import Simulation
from neurosym.world import Scene

_SOFTNESS = (0.01, 1.0)
"""Time in which contacts push apart [s], and damping beside the critical one."""
_STEP, _REACTION = TabletopConfig().time_step, 10
"""The usual step [s], and in how many a joint makes up for where it is, as motors of PyBullet do."""
_GIVES_WAY = 0.015
"""How far a joint lags behind where its motor gives the arm's force [rad]; some more, and a motion stops."""
_FINGER_STIFFNESS = 576.0
"""How hard a motor holds a finger [N/m]."""
_ARM_INERTIA, _FINGER_INERTIA = 0.2, 0.1
"""Inertia of gears [kg m2], [kg]. With less, contacts rattle, and a tenth of a millimetre decides."""
_OTHER_FRICTION, _LEAST_FRICTION = (0.5, 0.0), 1e-4
"""Friction of what PyBullet is told none of, sliding and twisting; and the least that MuJoCo takes."""
_ARM = -1
"""The arm among the bodies, as long as PyBullet does not load it."""
_Geom = tuple[str, float, float, float]  # its name, and its friction: sliding, twisting [m], rolling [m]


class MujocoSimulation(Simulation):
    """One scene in MuJoCo, with the arm in it.

    Args:
        client: Where PyBullet draws it.
        config: The world's options.
        scene: The scene.
        arm: The arm.
        watched: Whether somebody watches, so that PyBullet has to show each step.
    """

    def __init__(self, client: Client, config: TabletopConfig, scene: Scene, arm: Arm, *, watched: bool):
        self._watched, self._arm = watched, arm
        super().__init__(client, config, scene)

    def _build(self, scene: Scene) -> tuple[int, list[int]]:
        table, bodies = super()._build(scene) if self._watched else (0, [*range(1, len(scene) + 1)])
        alone, hand = _read(self._arm)
        spec = alone.copy()
        spec.option.timestep = self.config.time_step
        things = [self._add_object(spec, scene, index) for index in range(len(scene))]
        ground = self._add_table(spec)
        _add_pairs(spec, [[ground], *things], hand)
        self.model = _compiled(spec, self._arm)
        self.data = mujoco.MjData(self.model)
        mujoco.mj_forward(self.model, self.data)
        first = [self.model.joint(f"object {index}").qposadr[0] for index in range(len(scene))]
        self._places = np.array([range(at, at + 3) for at in first], dtype=int).reshape(-1, 3)
        self._turns = np.array([[at + 4, at + 5, at + 6, at + 3] for at in first], dtype=int).reshape(-1, 4)
        speeds = [self.model.joint(f"object {index}").dofadr[0] for index in range(len(scene))]
        self._speeds = np.array([range(at, at + 6) for at in speeds], dtype=int).reshape(-1, 6)
        self._owners = np.array([self._owner(geom, table, bodies) for geom in range(self.model.ngeom)])
        return table, bodies

    def _owner(self, geom: int, table: int, bodies: Sequence[int]) -> int:
        """Return to which body of the simulation a geom belongs."""
        kind, _, number = self.model.geom(geom).name.partition(" ")
        if kind == "object":
            return bodies[int(number.partition(" ")[0])]
        return table if kind == "table" else _ARM

    def _add_table(self, spec: mujoco.MjSpec) -> _Geom:
        centre, half = self.config.table_box
        box = mujoco.mjtGeom.mjGEOM_BOX
        spec.worldbody.add_geom(name="table", type=box, size=half, pos=centre, contype=0, conaffinity=0)
        return "table", TABLE_FRICTION, 0.0, 0.0

    def _add_object(self, spec: mujoco.MjSpec, scene: Scene, index: int) -> list[_Geom]:
        made, (x, y, z, w) = self._made[index], scene.orientations[index]
        centres, halves = made.around
        x_side, y_side, z_side = ((centres + halves).max(0) - (centres - halves).min(0)) ** 2
        inertia = made.mass / 12 * np.array([y_side + z_side, x_side + z_side, x_side + y_side])
        body = spec.worldbody.add_body(name=f"object {index}", pos=scene.positions[index], quat=[w, x, y, z])
        body.explicitinertial, body.ipos = True, made.centre_of_mass
        body.mass, body.inertia = made.mass, inertia
        body.add_freejoint(name=f"object {index}")
        kind = mujoco.mjtGeom.mjGEOM_SPHERE if made.is_ball else mujoco.mjtGeom.mjGEOM_BOX
        geoms: list[_Geom] = []
        for number, (half, centre, turn) in enumerate(made.boxes):
            name, quat = f"object {index} {number}", [math.cos(turn / 2), 0.0, 0.0, math.sin(turn / 2)]
            body.add_geom(name=name, type=kind, size=half, pos=centre, quat=quat, contype=0, conaffinity=0)
            geoms.append((name, made.friction, OBJECT_TWISTING_FRICTION, ROLLING_FRICTION * made.is_ball))
        return geoms

    def joints_of(self, arm: Arm, *, visible: bool) -> Joints:
        """Return the joints of the arm, which PyBullet loads with its looks if it shall be visible."""
        shown = super().joints_of(arm, visible=visible) if self._watched else None
        body = shown.body if shown else _ARM
        self._owners[self._owners == _ARM] = body
        self._joints = MujocoJoints(self.model, self.data, arm, body, shown)
        return self._joints

    def step(self) -> None:
        """Advance time by one step."""
        self._joints.lead(self.config.time_step)
        mujoco.mj_step(self.model, self.data)
        if self._watched:
            self._show()
        self._stepped()

    def _show(self) -> None:
        self._joints.show()
        for index, body in enumerate(self.bodies):
            place, turn = self._pose(index)
            centre = place + _rotated(turn, self._made[index].centre_of_mass)
            self.client.resetBasePositionAndOrientation(body, centre, turn)

    def is_quiet(self) -> bool:
        """Say whether every object is at rest."""
        return self._are_at_rest(self.data.qvel[self._speeds].tolist())

    def _pose(self, index: int) -> tuple[Sequence[float], Sequence[float]]:
        return self.data.qpos[self._places[index]].tolist(), self.data.qpos[self._turns[index]].tolist()

    def around(self, index: int) -> tuple[Sequence[float], Sequence[float]]:
        """Return least and greatest corner of a straight box around an object [m]."""
        boxes = self.boxes_of(index)
        return boxes[:, 0].min(0), boxes[:, 1].max(0)

    def touched_by(self, body: int) -> set[int]:
        """Return the bodies that a body touches."""
        pairs = self._owners[self.data.contact.geom]
        return set(pairs[(pairs == body).any(1)].ravel().tolist()) - {body}


class MujocoJoints:
    """The joints of an arm in MuJoCo (see `Joints`).

    Args:
        model: The scene.
        data: Its state.
        arm: Which arm.
        body: The arm among the bodies of the simulation.
        shown: The arm that PyBullet draws, if somebody watches.
    """

    def __init__(self, model: mujoco.MjModel, data: mujoco.MjData, arm: Arm, body: int, shown: Joints | None):
        self.body, self._model, self._data, self._arm, self._shown = body, model, data, arm, shown
        names, tool = _names(arm)
        self._driven = (*arm.joints, *arm.fingers)
        known = [model.joint(names[joint]) for joint in self._driven]
        self._at = {
            joint: (one.qposadr[0], one.dofadr[0]) for joint, one in zip(self._driven, known, strict=True)
        }
        self._tool = model.body(tool).id
        self._fingers = slice(len(arm.joints), len(self._driven))
        self._goal = self._lead = 0.0  # where each finger shall stand in the end, and where now [m]
        self._is_read = False

    def put(self, joints: Sequence[int], positions: Sequence[float], speeds: Sequence[float]) -> None:
        """Put some joints somewhere at once (see `Joints.put`)."""
        for joint, position, speed in zip(joints, positions, speeds, strict=True):
            place, way = self._at[joint]
            self._data.qpos[place], self._data.qvel[way] = position, speed
        self._is_read, self._lead = False, self.half_opening()
        if self._shown:
            self._shown.put(joints, positions, speeds)

    def show(self) -> None:
        """Put the arm that is drawn where this one is."""
        if self._shown:
            positions = [float(self._data.qpos[self._at[joint][0]]) for joint in self._driven]
            self._shown.put(self._driven, positions, [0.0] * len(positions))

    def tool_point(self) -> Float[np.ndarray, "3"]:
        """Return where the tool point is in the world [m]."""
        if not self._is_read:
            mujoco.mj_kinematics(self._model, self._data)
            self._is_read = True
        return np.array(self._data.xpos[self._tool])

    def half_opening(self) -> float:
        """Return how far each finger stands from the middle [m]."""
        return float(self._data.qpos[self._at[self._arm.fingers[0]][0]])

    def drive_arm(self, angles: Sequence[float], speeds: Sequence[float]) -> None:
        """Drive the arm's joints (see `Joints.drive_arm`)."""
        self._data.ctrl[: len(angles)] = np.asarray(angles) + _REACTION * _STEP * np.asarray(speeds)

    def drive_fingers(self, half_opening: float, force: float) -> None:
        """Drive each finger (see `Joints.drive_fingers`)."""
        beyond = force / _FINGER_STIFFNESS if half_opening == 0 else 0.0  # to press with all of it
        self._goal, self._lead = half_opening - beyond, self.half_opening()
        self._model.actuator_forcerange[self._fingers] = -force, force

    def lead(self, seconds: float) -> None:
        """Lead the fingers for a step towards where they shall stand; the arm is where it was so far."""
        self._is_read = False
        before, most = self._lead, FINGER_SPEED * seconds
        self._lead += min(max(self._goal - before, -most), most)
        self._data.ctrl[self._fingers] = self._lead + _REACTION * (self._lead - before) * (_STEP / seconds)


def _compiled(spec: mujoco.MjSpec, arm: Arm) -> mujoco.MjModel:
    """Return what MuJoCo simulates; raise `InvalidArm` if it cannot, as with meshes that it does not find."""
    try:
        return spec.compile()
    except ValueError as error:
        said = " ".join(str(error).removeprefix("Error: ").split())
        raise InvalidArm(f"of {arm.urdf} cannot be simulated by MuJoCo, which says: {said}") from error


def _rotated(turn: Sequence[float], point: Sequence[float]) -> Float[np.ndarray, "3"]:
    x, y, z, w = turn
    rotated = np.zeros(3)
    mujoco.mju_rotVecQuat(rotated, np.array(point), np.array([w, x, y, z]))
    return rotated


# The arm, read once from its file, with a motor for each joint


@cache
def _names(arm: Arm) -> tuple[dict[int, str], str]:
    """Return the names of the joints of an arm by their numbers in PyBullet's count, and that of its tool."""
    with loaded(arm.urdf) as (client, body):
        infos = [client.getJointInfo(body, index) for index in range(client.getNumJoints(body))]
    return {index: info[1].decode() for index, info in enumerate(infos)}, infos[arm.tool][12].decode()


@cache
def _read(arm: Arm) -> tuple[mujoco.MjSpec, list[_Geom]]:
    """Return a scene with nothing but the arm, to be copied, and what its hand touches with."""
    names, _ = _names(arm)
    spec = mujoco.MjSpec.from_file(arm.urdf)
    spec.compiler.fusestatic = False
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    spec.option.cone, spec.option.impratio = mujoco.mjtCone.mjCONE_ELLIPTIC, 10.0
    for body in spec.bodies[1:]:
        if body.parent == spec.worldbody:
            body.pos = np.add(body.pos, arm.base)
        body.gravcomp = 1.0  # so that it does not sag
        body.mass, body.inertia = body.mass * arm.mass_scale, body.inertia * arm.mass_scale
    for joint, force in zip(arm.joints, arm.forces, strict=True):
        _add_motor(spec, names[joint], force / _GIVES_WAY)
        spec.joint(names[joint]).armature = _ARM_INERTIA
    for finger in arm.fingers:
        motor = _add_motor(spec, names[finger], _FINGER_STIFFNESS)
        motor.forcelimited, motor.forcerange = True, (-1.0, 1.0)
        spec.joint(names[finger]).range[0], spec.joint(names[finger]).armature = 0.0, _FINGER_INERTIA
    left, right = (names[finger] for finger in arm.fingers)
    gear = spec.add_equality(type=mujoco.mjtEq.mjEQ_JOINT, name1=left, name2=right)
    gear.objtype, gear.data[:2] = mujoco.mjtObj.mjOBJ_JOINT, (0.0, 1.0)
    ends = {spec.joint(names[finger]).parent.name for finger in arm.fingers}
    hand: list[_Geom] = []
    for number, geom in enumerate(spec.geoms):
        geom.name, geom.contype, geom.conaffinity = f"arm {number}", 0, 0
        is_finger = geom.parent.name in ends
        friction = (FINGER_FRICTION, FINGER_TWISTING_FRICTION) if is_finger else _OTHER_FRICTION
        hand.append((geom.name, *friction, 0.0))
    return spec, hand


def _add_motor(spec: mujoco.MjSpec, joint: str, stiffness: float) -> mujoco.MjsActuator:
    """Add a motor that leads a joint where it shall be, and holds its speed."""
    motor = spec.add_actuator(name=joint, target=joint, trntype=mujoco.mjtTrn.mjTRN_JOINT)
    damping = stiffness * _REACTION * _STEP
    motor.gaintype, motor.gainprm[0] = mujoco.mjtGain.mjGAIN_FIXED, stiffness
    motor.biastype, motor.biasprm[:3] = mujoco.mjtBias.mjBIAS_AFFINE, (0.0, -stiffness, -damping)
    return motor


def _add_pairs(spec: mujoco.MjSpec, things: Sequence[Sequence[_Geom]], hand: Sequence[_Geom]) -> None:
    """Say what can touch, and with which friction: things each other, and the hand all of them."""
    touching = [*(combinations(things, 2)), *((thing, hand) for thing in things)]
    for first, second in touching:
        for one, other in product(first, second):
            spec.add_pair(geomname1=one[0], geomname2=other[0], solref=_SOFTNESS, **_friction(one, other))


def _friction(one: _Geom, other: _Geom) -> dict[str, object]:
    """Return the friction of a pair, combined as PyBullet does."""
    (_, sliding, twisting, rolling), (_, other_sliding, other_twisting, other_rolling) = one, other
    twists = twisting * other_sliding + other_twisting * sliding
    rolls = rolling * other_sliding + other_rolling * sliding
    slides = sliding * other_sliding
    friction = [max(value, _LEAST_FRICTION) for value in (slides, slides, twists, rolls, rolls)]
    return {"condim": 6 if rolls else 4, "friction": friction}
