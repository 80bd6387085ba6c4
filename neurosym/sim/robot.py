"""The arm and its hand: straight motions that stop at resistance, and fingers that feel their way.

Motion through free air is not simulated: where the hand comes near nothing and nothing else moves, it is put
further along its way, as fast as it would be there. Time passes as if it had gone all the way.
"""

import math
from collections.abc import Callable, Sequence
from importlib.resources import files

import numpy as np

from neurosym.checks import Bool, Float
from neurosym.contract import CLEARANCE, FINGER_SPEED, PEAK_SPEED, way_seconds
from neurosym.errors import InvalidValue
from neurosym.sim.config import Arm
from neurosym.sim.simulation import Simulation
from neurosym.world import turned_by

CLOSING_FORCE, HOLDING_FORCE = 10.0, 20.0
OPENING_FORCE = 0.4
"""Force while opening [N]: too little to carry an object by spreading inside it."""
STALL_ERROR = 0.005
"""A motion stops when the hand lags this far behind its path [m]."""
LOWEST_TOOL_POINT = 0.013
"""The tool point stays this high above the table [m]."""
_CHECK_EVERY = 4
_LOOK_AHEAD_EVERY = 8
_RUN_UP = 4  # ticks of its way that the hand is simulated before it comes near something

Drive = tuple[list[float], list[float]]
"""Where joints shall be [rad, or m], and how fast."""


def hand_boxes(
    arm: Arm, half_openings: Float[np.ndarray, "T"], turn: float = 0.0
) -> tuple[Float[np.ndarray, "T 3 3"], Float[np.ndarray, "T 3 3"]]:
    """Return the least and greatest corners of the boxes around the fingers and the palm [m].

    They are seen from the tool point. There is no end to the palm above.

    Args:
        arm: Whose hand.
        half_openings: How far each finger is out [m].
        turn: How far the hand is turned about the vertical [rad].
    """
    width, thickness, length = arm.finger_half_width, arm.finger_thickness, arm.finger_length
    x, y = arm.palm_half_size
    low = np.array([[-width, 0.0, 0.0], [-width, -thickness, 0.0], [-x, -y, length]])
    high = np.array([[width, thickness, length], [width, 0.0, length], [x, y, math.inf]])
    apart = half_openings[:, None, None] * np.array([[0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 0.0]])
    low, high = low + apart, high + apart
    if turn != 0.0:
        middle, half = turned_by(turn, (low + high)[..., :2] / 2), (high - low)[..., :2] / 2
        around = np.abs(np.array([[math.cos(turn), math.sin(turn)], [math.sin(turn), math.cos(turn)]]))
        low[..., :2], high[..., :2] = middle - half @ around, middle + half @ around
    return low, high


class Robot:
    """An arm and its two-finger hand in a simulation.

    Args:
        simulation: Where it is.
        arm: What it is.
        visible: Whether it is loaded with its looks, which takes longer.
        show: Shows a tick of its way that is not simulated, if it is watched.
    """

    def __init__(
        self,
        simulation: Simulation,
        arm: Arm,
        *,
        visible: bool = False,
        show: Callable[[], None] | None = None,
    ):
        self._simulation, self._arm, self._show = simulation, arm, show
        self._time_step = simulation.config.time_step
        self._joints = simulation.joints_of(arm, visible=visible)
        self.body = self._joints.body
        self.is_open = True
        self.turn = 0.0  # how far the hand is turned about the vertical [rad]

    def place_at(self, point: Float[np.ndarray, "3"], half_opening: float) -> None:
        """Put the hand at a point [m] at once, motionless, pointing down, each finger so far out [m]."""
        positions = [*self._hold(point), half_opening, half_opening]
        self._joints.put((*self._arm.joints, *self._arm.fingers), positions, [0.0] * len(positions))
        self.is_open = half_opening > 0
        self._joints.drive_fingers(half_opening, HOLDING_FORCE if self.is_open else CLOSING_FORCE)

    def tool_point(self) -> Float[np.ndarray, "3"]:
        """Return where the tool point is in the world [m]."""
        return self._joints.tool_point()

    def half_opening(self) -> float:
        """Return how far each finger stands from the middle [m]."""
        return self._joints.half_opening()

    def move_to(
        self,
        point: Float[np.ndarray, "3"],
        *,
        peak_speed: float = PEAK_SPEED,
        until: Callable[[], bool] | None = None,
        turn: float | None = None,
    ) -> bool:
        """Move in a straight line to a point above the table [m], with a smooth start and end.

        On the way the hand turns to an angle about the vertical [rad], if one is given. Returns whether the
        motion came to its end; not if something held the hand back, or `until` came true.
        """
        start = self.tool_point()
        goal = np.array([point[0], point[1], max(point[2], LOWEST_TOOL_POINT)])
        distance = float(np.linalg.norm(goal - start))
        count = max(1, int(np.ceil(way_seconds(distance, peak_speed) / self._time_step)))
        path = start + _smooth(count)[:, None] * (goal - start)  # (T, 3)
        turns, is_turning = np.full(count, self.turn), turn is not None and turn != self.turn
        if turn is not None and is_turning:
            turns, self.turn = self.turn + _smooth(count) * (turn - self.turn), turn
        openings, drives, tick = np.array([self.half_opening()]), list[Drive](), 0
        while tick < count:
            looks = until is None and not is_turning and tick % _LOOK_AHEAD_EVERY == 0
            if looks and (free := self._free_ticks(np.vstack([self.tool_point(), path[tick:]]), openings)):
                between = self._drives(path[tick : tick + free]) if self._show else []
                tick += free
                end = self._drives(path[:tick][-2:])[-1]
                self._pass(free, self._arm.joints, end, between)
                self._joints.drive_arm(*end)
                continue
            drives = drives or self._drives(path, turns)
            self._joints.drive_arm(*drives[tick])
            self._simulation.step()
            is_over = until is not None and until()
            is_due = tick % _CHECK_EVERY == 0
            if is_over or (is_due and math.dist(self.tool_point(), path[tick]) > STALL_ERROR):
                self._hold(self.tool_point())
                return False
            tick += 1
        return True

    def _drives(
        self, path: Float[np.ndarray, "T 3"], turns: Float[np.ndarray, "T"] | None = None
    ) -> list[Drive]:
        """Return angles [rad] and velocities of the joints that lead the tool point along a path [m].

        The hand is turned as it is, or by so much at each point [rad].
        """
        joints = self._angles(path, self.turn if turns is None else turns)
        still = np.zeros_like(joints)
        velocities = np.gradient(joints, self._time_step, axis=0) if len(path) > 1 else still
        return list(zip(joints.tolist(), velocities.tolist(), strict=True))

    def _free_ticks(self, points: Float[np.ndarray, "T 3"], half_openings: Float[np.ndarray, "T"]) -> int:
        """Count the ticks of a way that need not be simulated, since the hand comes near nothing.

        Where it comes near something later, some ticks before that are simulated, too.

        Args:
            points: Where the tool point is, now and after each tick of the way [m].
            half_openings: How far each finger is out [m].
        """
        if not self._simulation.is_quiet():
            return 0
        boxes = self._simulation.boxes()  # (B, 2, 3)
        soon = _RUN_UP + 2  # what comes near in these ticks leaves none free
        if self._comes_near(boxes, points[:soon], half_openings[:soon]).any():
            return 0
        is_near = self._comes_near(boxes, points, half_openings)
        return int(np.argmax(is_near)) - 1 - _RUN_UP if is_near.any() else len(points) - 1

    def _comes_near(
        self,
        boxes: Float[np.ndarray, "B 2 3"],
        points: Float[np.ndarray, "T 3"],
        half_openings: Float[np.ndarray, "T"],
    ) -> Bool[np.ndarray, "T"]:
        """Say at which tool points the hand is near one of the boxes, whose corners are given [m]."""
        low, high = hand_boxes(self._arm, half_openings, self.turn)  # (T, 3, 3)
        low, high = low + points[:, None] - CLEARANCE, high + points[:, None] + CLEARANCE
        meets = (low[:, :, None] < boxes[:, 1]) & (boxes[:, 0] < high[:, :, None])  # (T, 3, B, 3)
        return np.asarray(meets.all(3).any((1, 2)))

    def _pass(self, ticks: int, joints: Sequence[int], end: Drive, between: Sequence[Drive]) -> None:
        """Let time pass that is not simulated, until joints are at an end; those between are only shown."""
        self._simulation.ticks += ticks - len(between)
        for drive in between:
            self._joints.put(joints, *drive)
            self._simulation.ticks += 1
            if self._show:
                self._show()
        self._joints.put(joints, *end)

    def _hold(self, point: Float[np.ndarray, "3"]) -> list[float]:
        """Stay at a point [m], and return the joint angles there [rad]."""
        angles: list[float] = self._angles(point[None], self.turn)[0].tolist()
        self._joints.drive_arm(angles, [0.0] * len(angles))
        return angles

    def _angles(
        self, points: Float[np.ndarray, "T 3"], turns: float | Float[np.ndarray, "T"]
    ) -> Float[np.ndarray, "T J"]:
        """Return the joint angles [rad] for tool points [m], with the hand turned about the vertical."""
        joints = self._arm.inverse_kinematics(points)
        if self._arm.wrist is not None and np.any(turns):
            joints[:, self._arm.wrist] -= turns
        return joints

    def close(self) -> None:
        """Close the fingers until they stop."""
        self._move_fingers(0.0, CLOSING_FORCE)
        self.is_open = False

    def open(self, half_opening: float | None = None) -> None:
        """Open each finger gently until it stops, at most so far [m], then hold it there."""
        widest = self._arm.half_opening
        half_opening = widest if half_opening is None else min(half_opening, widest)
        self._move_fingers(half_opening, OPENING_FORCE)
        self._joints.drive_fingers(self.half_opening(), HOLDING_FORCE)
        self.is_open = True

    def _move_fingers(self, target: float, force: float) -> None:
        """Move the fingers towards where each shall stand [m], until they arrive or stand still.

        They are put ahead as far as they come near nothing. Then at most the time of a full stroke and a
        little passes.
        """
        self._joints.drive_fingers(target, force)
        start = self.half_opening()
        stride = math.copysign(FINGER_SPEED * self._time_step, target - start)
        way = np.arange(start, target, stride)
        if free := self._free_ticks(np.tile(self.tool_point(), (len(way), 1)), way):
            speeds = [stride / self._time_step] * 2
            drives = [([at, at], speeds) for at in way[1 : free + 1].tolist()]
            self._pass(free, self._arm.fingers, drives[-1], drives if self._show else [])
        last, still = self.half_opening(), 0
        for _ in range(int((self._arm.half_opening / FINGER_SPEED + 0.25) / self._time_step)):
            self._simulation.step()
            now = self.half_opening()
            still = still + 1 if abs(now - last) < 0.01 * self._time_step else 0
            if abs(now - target) < 2e-4 or still * self._time_step > 0.05:
                return
            last = now


def _smooth(count: int) -> Float[np.ndarray, "T"]:
    """Return `count` path fractions ending at 1 whose speed and acceleration vanish at both ends."""
    s = np.arange(1, count + 1) / count
    return s**3 * (10 - 15 * s + 6 * s**2)


# Kinematics of the UR10 in closed form, for whole trajectories at once.
#
# Lengths follow the Denavit-Hartenberg convention; the base stands `BASE_HEIGHT` above the table, at the
# world's origin, so that the whole table is in reach also when an object is lifted. With the tool pointing
# down, joint 5 stands at a right angle, and joints 2 to 4 lie in one upright plane. Of the branches that are
# left, one is used throughout (shoulder left, elbow up): it is continuous over the whole table, so
# neighbouring points of a path get neighbouring joint angles.

D = np.array([0.1273, 0.0, 0.0, 0.163941, 0.1157, 0.0922])
"""Link offsets d_1..d_6 [m], as the manufacturer publishes them."""
A = np.array([0.0, -0.612, -0.5723, 0.0, 0.0, 0.0])
"""Link lengths a_1..a_6 [m]."""
BASE_HEIGHT = 0.25
"""Height of the arm's base above the table [m]."""
TOOL_LENGTH = 0.19
"""From the flange to the point between the fingertips [m]."""


def joints_for(points: Float[np.ndarray, "N 3"]) -> Float[np.ndarray, "N 6"]:
    """Return the joint angles that put the tool point at each point, the hand pointing down.

    Args:
        points: Tool points in the world [m].

    Raises:
        InvalidValue: If a point is out of the arm's reach.
    """
    x, y, z = points.T
    away, up = np.hypot(x, y), z + TOOL_LENGTH - BASE_HEIGHT + D[5] - D[0]
    with np.errstate(invalid="ignore"):
        q1 = np.arctan2(y, x) + np.arccos(D[3] / away) + np.pi / 2
        along = np.sqrt(away**2 - D[3] ** 2) + D[4]  # from the shoulder to joint 4, in the plane of the arm
        reach = np.hypot(along, up)
        q3 = np.arccos((reach**2 - A[1] ** 2 - A[2] ** 2) / (2 * A[1] * A[2]))
        q2 = np.arcsin(A[2] * np.sin(q3) / reach) - np.arctan2(up, along)
    q4, q5 = np.pi / 2 - q2 - q3, np.full_like(q1, np.pi / 2)  # joints 2, 3, 4 are parallel
    joints = np.stack([q1, q2, q3, q4, q5, q1 - np.pi / 2], axis=1)
    if not np.all(np.isfinite(joints)):
        x, y, z = points[int(np.argwhere(~np.isfinite(joints))[0][0])]
        raise InvalidValue(f"The point ({x:.3f}, {y:.3f}, {z:.3f}) m is out of the arm's reach.")
    has_jumps = len(joints) > 1 and np.abs(np.diff(joints, axis=0)).max() >= np.pi
    return np.unwrap(joints, axis=0) if has_jumps else joints


UR10 = Arm(
    urdf=str(files("neurosym.sim") / "ur10.urdf"),
    base=(0.0, 0.0, BASE_HEIGHT),
    joints=(0, 1, 2, 3, 4, 5),
    fingers=(7, 8),
    tool=9,
    inverse_kinematics=joints_for,
    forces=(25.0, 25.0, 18.0, 6.0, 6.0, 6.0),
    half_opening=0.07,
    finger_length=0.09,
    finger_half_width=0.011,
    finger_thickness=0.012,
    palm_half_size=(0.025, 0.075),
    wrist=5,
)
"""The paper's arm with a hand of 140 mm opening; its file scales the masses by 0.03 already."""
