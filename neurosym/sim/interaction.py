"""One interaction in PyBullet, from empty hand to empty hand.

The protocol: spawn, settle, record; hand clear of every object; for each of three waypoints set the gripper,
then move there in a straight line; rise; record the effect and whether something is held; if so, lower it
until it stands, let go, rise, settle; record the resting effect.

With a reference, the third waypoint is relative to it. If the target hangs from the hand after the second and
a short rise, it is lifted clear of everything, carried over the third, lowered there until it stands, and let
go. If not, the hand rises where it is. The hand then opens no further than the target needs, since there may
be neighbours.
"""

import math
from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from neurosym.checks import Float
from neurosym.contract import CLEARANCE, GRASP_TEST, LOWERING_SPEED, TRANSIT_CLEARANCE, PoseSink
from neurosym.sim.camera import Camera, Poser
from neurosym.sim.config import Arm, pybullet
from neurosym.sim.robot import LOWEST_TOOL_POINT, Robot, hand_boxes
from neurosym.sim.shapes import OPEN_THROUGH, OPEN_TOP
from neurosym.sim.simulation import Simulation
from neurosym.world import (
    Disturbance,
    FrameSink,
    OtherObject,
    Outcome,
    Place,
    Reference,
    Scene,
    centre_of,
    heading,
    heading_to,
    turned_by,
)

PARKING_CLEARANCE, LEAST_PARKING_CLEARANCE = 0.25, 0.05
"""How far above the tallest object there can be the hand waits at first; and at least above any stack [m]."""
LEAST_DISTURBANCE = 0.005
"""A bystander that ends further away than this has been moved [m]."""
MARGIN = 0.006
"""How far each finger stays from the object that it comes down beside [m]."""
_WIDE_RELEASE = (0.005, 0.015)
"""How far each finger opens, first to let a standing object fall flat, then to leave it behind [m]."""
_NARROW_RELEASE = (0.005, 0.005)
"""The same where neighbours may stand close by [m]."""
_TOPPLED_COSINE = math.cos(math.radians(30))  # an object has toppled whose up axis has turned by more
_ROUND_CORNERS = 24
_WATCH_EVERY, _TOUCH_EVERY = 8, 4


class Interaction:
    """The steps of the protocol, performed on a target in a simulation of its own that is at rest."""

    def __init__(
        self,
        simulation: Simulation,
        arm: Arm,
        target: int,
        on_frame: FrameSink | None = None,
        camera: Camera | None = None,
        on_pose: PoseSink | None = None,
        orientations: Float[np.ndarray, "M 4"] | None = None,
    ):
        self._simulation, self._arm, self._target = simulation, arm, target
        self._phase, self._peak, self._is_narrow = "start", -math.inf, False
        self._every = range(len(simulation.bodies))
        self._lie = None if arm.wrist is None else orientations
        self._touched: set[int] = set()
        show = None if on_frame is None and on_pose is None else self._show
        self._robot = Robot(simulation, arm, visible=on_frame is not None, show=show)
        self._on_frame, self._camera = on_frame, camera
        self._poser = Poser(simulation, self._robot, on_pose) if on_pose else None
        simulation.after_step = self._watch

    def perform(
        self, action: Float[np.ndarray, "A"], put_down: bool, reference: Reference | None = None
    ) -> Outcome:
        """Run the protocol with three waypoints (x, y, z, g), the last relative to the reference, if any.

        All is turned as the target lies. What is carried is set down straight on the table, or as is asked
        for, or as another object lies that it is put on or into.
        """
        turn, release = self._turns(reference)
        waypoints = turned_by(turn, action.reshape(3, 4))
        if reference is not None:
            waypoints = np.vstack([waypoints[:2], turned_by(release, action.reshape(3, 4)[2:])])
        self._robot.turn = turn
        self._is_narrow = reference is not None
        self._park_robot()
        self._simulation.settle()
        start = self._simulation.observe()
        centre = start.positions[self._target]
        aim = centre if reference is None else centre_of(reference, start.positions)
        self._peak = float(centre[2])
        if self._camera:
            origins = np.array([centre, centre, aim])
            self._camera.mark(origins + waypoints[:, :3])
        self._approach(centre + waypoints[0, :3], bool(waypoints[0, 3] >= 0.5))
        for number, waypoint in enumerate(waypoints if reference is None else waypoints[:2], 1):
            self._phase = f"waypoint {number}"
            self._set_gripper(bool(waypoint[3] >= 0.5))
            self._robot.move_to(centre + waypoint[:3])
        carried = reference is not None and self._carry(aim + waypoints[2, :3], release)
        self._phase = "rise"
        self._rise()
        self._simulation.settle()
        lifted = self._simulation.observe()
        hanging = self._hanging()
        held = self._target in hanging
        lowers = bool(hanging) and (put_down or not held)
        if lowers:
            self._set_down(hanging)
            self._rise()
            self._simulation.settle()
        end = self._simulation.observe() if lowers else lifted
        return Outcome(
            start=start,
            lifted=lifted,
            end=end,
            target=self._target,
            held=held,
            toppled=_has_toppled(start, end, self._target),
            lost=not self._simulation.config.table.contains(end.positions[self._target]),
            peak_height=self._peak - float(centre[2]),
            touched=tuple(sorted(self._touched)),
            disturbed=tuple(self._disturbed(start, end)),
            reference=reference,
            carried=carried and not held,
            contacts=tuple(self._contacts()),
        )

    def _turns(self, reference: Reference | None) -> tuple[float, float]:
        """Return how far the hand is turned where it takes the target, and where it sets that down [rad]."""
        if self._lie is None:
            return 0.0, 0.0
        turn = heading(self._lie[self._target])
        if isinstance(reference, OtherObject):
            return turn, heading(self._lie[reference.index])
        if isinstance(reference, Place) and reference.heading is not None:
            return turn, turn + heading_to(self._lie[self._target], reference.heading)
        return turn, 0.0

    def _watch(self) -> None:
        """Look at the peak and at bystanders now and then, and show what happens."""
        ticks, simulation = self._simulation.ticks, self._simulation
        if ticks % _WATCH_EVERY == 0:
            self._peak = max(self._peak, simulation.height_of(self._target))
        if len(simulation.bodies) > 1 and ticks % _TOUCH_EVERY == 0:
            self._touched |= self._in_contact(self._robot.body) - {self._target}
        self._show()

    def _show(self) -> None:
        """Hand over pictures and poses, if it is time for one."""
        ticks, simulation = self._simulation.ticks, self._simulation
        if self._camera and self._on_frame and ticks % simulation.config.frame_every == 0:
            self._on_frame(self._camera.picture(), self._phase)
        if self._poser:
            self._poser.look(self._phase)

    def _park_robot(self) -> None:
        """Put the hand high above the table's middle, out of every object's way."""
        c = self._simulation.config
        top = max(high for _, high in self._heights())
        height = max(c.height[1] + PARKING_CLEARANCE, top + LEAST_PARKING_CLEARANCE)
        point = np.array([sum(c.table_x) / 2, sum(c.table_y) / 2, height])
        self._robot.place_at(point, self._arm.half_opening)

    def _approach(self, point: Float[np.ndarray, "3"], is_open: bool) -> None:
        """Put the hand above the first waypoint, just clear of every object.

        From there the first motion leads straight down, as a hand coming from above would.
        """
        half_opening = self._opening(point) if is_open else 0.0
        height = max(float(point[2]), LOWEST_TOOL_POINT, self._clear_height(point, half_opening))
        self._robot.place_at(np.array([point[0], point[1], height]), half_opening)

    def _clear_height(self, point: Float[np.ndarray, "3"], half_opening: float) -> float:
        """Return the least height of the tool point at which no part of the hand touches an object [m]."""
        parts = hand_boxes(self._arm, np.array([half_opening]), self._robot.turn)  # (1, 3, 3) each
        least, greatest = (corners[0, :, :2] + point[:2] for corners in parts)
        heights = [0.0]
        for low, high in map(self._simulation.around, self._every):
            is_under = (least - CLEARANCE < high[:2]) & (low[:2] < greatest + CLEARANCE)
            heights += [high[2] + CLEARANCE - bottom for bottom in parts[0][0, is_under.all(1), 2]]
        return max(heights)

    def _opening(self, point: Float[np.ndarray, "3"]) -> float:
        """Return how far each finger opens where the middle of the hand is there [m]."""
        if not self._is_narrow:
            return self._arm.half_opening
        low, high = self._along_fingers(self._robot.turn)
        middle = float(turned_by(-self._robot.turn, point)[1])
        return _grasp_opening(low - middle, high - middle, self._arm.half_opening)

    def _along_fingers(self, turn: float) -> tuple[float, float]:
        """Return from where to where the target reaches along the way in which a turned hand opens [m]."""
        if turn == 0.0:
            low, high = self._simulation.around(self._target)
            return low[1], high[1]
        scene = self._simulation.observe()
        corners = _corners(scene.features[self._target]) @ rotation(scene.orientations[self._target]).T
        along = turned_by(-turn, corners + scene.positions[self._target])[:, 1]
        return float(along.min()), float(along.max())

    def _set_gripper(self, is_open: bool) -> None:
        if is_open and not self._robot.is_open:
            self._robot.open(self._opening(self._robot.tool_point()))
        elif self._robot.is_open and not is_open:
            self._robot.close()

    def _rise(self) -> None:
        lift = np.array([0.0, 0.0, self._simulation.config.lift_height])
        self._robot.move_to(self._robot.tool_point() + lift)

    def _hanging(self) -> list[int]:
        """List the objects that the robot carries, in its hand or on one another, clear of the table."""
        bodies = self._simulation.bodies
        touching = {body: self._simulation.touched_by(body) for body in bodies}
        standing = _connected(self._simulation.table, touching)
        carried = _connected(self._robot.body, touching)
        return [index for index, body in enumerate(bodies) if body in carried - standing]

    def _carry(self, point: Float[np.ndarray, "3"], turn: float) -> bool:
        """Carry the target over a point [m], turn the hand to an angle [rad], and set the target down there.

        Returned is whether it hung so far.
        """
        if not self._simulation.touched_by(self._robot.body):
            return False
        self._phase = "carry"
        self._robot.move_to(self._robot.tool_point() + np.array([0.0, 0.0, GRASP_TEST]))
        hanging = self._hanging()
        if self._target not in hanging or self._in_contact(self._robot.body) - {self._target}:
            return False  # it hangs not, or others would be dropped on the way
        heights = self._heights()
        bottom = min(heights[index][0] for index in hanging)
        top = max((high for index, (_, high) in enumerate(heights) if index not in hanging), default=0.0)
        x, y, z = self._robot.tool_point()
        z += max(0.0, top + TRANSIT_CLEARANCE - bottom)  # to pass over all the rest
        over = np.array([point[0], point[1], z])
        arrived = self._robot.move_to(np.array([x, y, z])) and self._robot.move_to(over, turn=turn)
        hanging = self._hanging()
        if not arrived or self._target not in hanging:
            return False
        self._set_down(hanging)
        return True

    def _in_contact(self, body: int) -> set[int]:
        """Return the indices of the objects that a body touches."""
        touched = self._simulation.touched_by(body)
        return {index for index, other in enumerate(self._simulation.bodies) if other in touched}

    def _heights(self) -> list[tuple[float, float]]:
        """Return from which height to which each object reaches [m]."""
        boxes = map(self._simulation.around, self._every)
        return [(low[2], high[2]) for low, high in boxes]

    def _set_down(self, hanging: Sequence[int]) -> None:
        """Lower what hangs until it stands, such that it comes to lie under where it hangs, and let go.

        A tilted object shifts when it falls flat; on its way down the hand moves by as much the other way.
        """
        self._phase = "put down"
        heeded = self._target if self._target in hanging else hanging[0]
        tilt = rotation(self._simulation.observe().orientations[heeded])
        shift_x, shift_y = _landing_shift(self._simulation.features[heeded], tilt)
        x, y, _ = self._robot.tool_point()
        self._robot.move_to(
            np.array([x - shift_x, y - shift_y, 0.0]),
            peak_speed=LOWERING_SPEED,
            until=lambda: self._has_landed(hanging),
        )
        for opening in _NARROW_RELEASE if self._is_narrow else _WIDE_RELEASE:
            self._robot.open(self._robot.half_opening() + opening)

    def _has_landed(self, hanging: Sequence[int]) -> bool:
        simulation = self._simulation
        up = {simulation.bodies[index] for index in hanging}
        ground = {simulation.table, *simulation.bodies} - up
        return any(simulation.touched_by(body) & ground for body in up)

    def _contacts(self) -> Iterator[tuple[int, int]]:
        """List the pairs of objects that touch now."""
        for index, body in enumerate(self._simulation.bodies):
            for other in sorted(self._in_contact(body)):
                if other > index:
                    yield index, other

    def _disturbed(self, start: Scene, end: Scene) -> Iterator[tuple[int, Disturbance]]:
        """Tell which bystanders ended elsewhere, and how."""
        table = self._simulation.config.table
        for index in range(len(start)):
            if index == self._target:
                continue
            if not table.contains(end.positions[index]):
                yield index, "lost"
            elif _has_toppled(start, end, index):
                yield index, "toppled"
            elif math.dist(end.positions[index], start.positions[index]) > LEAST_DISTURBANCE:
                yield index, "moved"


def _connected(body: int, touching: Mapping[int, set[int]]) -> set[int]:
    """Return the objects that touch the table or the robot, those that touch them, and so on."""
    found: set[int] = set()
    front = {body}
    while front:
        front = {other for other, touched in touching.items() if touched & front} - found
        found |= front
    return found


def _grasp_opening(low: float, high: float, widest: float) -> float:
    """Return how far each finger opens, at most `widest`, to come down on both sides of an object [m].

    It reaches from one side of the hand's middle to the other. If it is too wide for that, one finger comes
    down beside it and the other inside or on it.
    """
    nearest, farthest = sorted((abs(low), abs(high)))
    around = farthest + MARGIN
    return float(around if around <= widest else min(nearest + MARGIN, widest))


def _has_toppled(start: Scene, end: Scene, target: int) -> bool:
    """Say whether an object of a scene lies on another face at the end."""
    before, after = (rotation(scene.orientations[target])[:, 2] for scene in (start, end))
    return bool(before @ after < _TOPPLED_COSINE)


def rotation(quaternion: Float[np.ndarray, "4"]) -> Float[np.ndarray, "3 3"]:
    """Return the matrix of an orientation."""
    return np.array(pybullet.getMatrixFromQuaternion(quaternion)).reshape(3, 3)


def _landing_shift(
    features: Float[np.ndarray, "F"], object_in_world: Float[np.ndarray, "3 3"]
) -> Float[np.ndarray, "2"]:
    """Say how far an object's centre moves over the table when it is let go standing on its lowest corner.

    It turns about that corner until the face that points down most lies flat.
    """
    corners = _corners(features) @ object_in_world.T  # (corners, 3)
    pivot = corners[np.argmin(corners[:, 2])]
    face = object_in_world[:, np.argmax(np.abs(object_in_world[2]))]
    x, y, z = face * np.sign(face[2])
    cross = np.array([[0.0, 0.0, -x], [0.0, 0.0, -y], [x, y, 0.0]])  # of the face and the vertical
    upright = np.eye(3) + cross + cross @ cross / (1 + z)  # the smallest rotation between them (Rodrigues)
    return np.asarray((pivot - upright @ pivot)[:2])


def _corners(features: Float[np.ndarray, "F"]) -> Float[np.ndarray, "corners 3"]:
    x, y, z = features[:3] / 2
    if features[3] > (OPEN_TOP + OPEN_THROUGH) / 2:
        angles = np.linspace(0, 2 * np.pi, _ROUND_CORNERS, endpoint=False)
        outline = np.column_stack([x * np.cos(angles), y * np.sin(angles)])
    else:
        outline = np.array([[x, y], [x, -y], [-x, y], [-x, -y]])
    return np.vstack([np.column_stack([outline, np.full(len(outline), side)]) for side in (-z, z)])
