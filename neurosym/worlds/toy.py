"""A world without physics, exact enough to follow by hand, for tests and for teaching.

Objects and actions look like the robot's: four features (s_x, s_y, d, t) and three waypoints (x, y, z, g).
What an action does is decided by the first rule that fits:

1. **Lift.** The hand is open at waypoint 1 (g1 >= 0.5) and closed at waypoint 3 (g3 < 0.5), and the object
   can be grasped: it is hollow (by a wall) or at most 0.08 m wide (s_y). It hangs from the hand, 0.20 m up.
   Put down, it stands where it stood.
2. **Push.** The hand travels at least 0.02 m from waypoint 1 to waypoint 3 along x or y, whichever is more,
   and the object is at most 0.12 m long (s_x); a longer one does not budge. It slides 0.08 m along that axis:
   forward (+x), pull (-x), left (+y) or right (-y).
3. **Nothing** happens otherwise.

With a reference there is no third waypoint of the kind above, and one rule: if the hand is open at waypoint 1
and closed at waypoint 2, and the object can be grasped, it is carried. It stands where waypoint 3 relative to
the reference brings it, as far from there as it was from waypoint 2. Otherwise nothing happens.

An object whose centre leaves the table is lost. Nothing topples, and objects pass through one another. So
four kinds of object can be told apart by what happens to them (can it be grasped, can it be pushed), which is
two bits, and six kinds of action (lift, four pushes, nothing), which is three.
"""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from PIL import Image, ImageDraw

from neurosym.checks import Float
from neurosym.contract import ObjectLimits
from neurosym.errors import InvalidValue
from neurosym.world import (
    Frame,
    FrameSink,
    Outcome,
    Painter,
    Reference,
    ReferenceKind,
    Scene,
    Table,
    centre_of,
    check_action,
    draw_dots,
    painted,
    three_waypoints,
)

FEATURE_NAMES = ("s_x", "s_y", "d", "t")
OPEN = 0.5
WIDEST_GRASP = 0.08
LONGEST_PUSH = 0.12
LEAST_TRAVEL = 0.02
PUSH_LENGTH = 0.08
TABLE = Table(x=(0.4, 1.0), y=(-0.3, 0.3))
PICTURE = (640, 480)
FRAMES = 8
DOT_RADIUS = 6.0
_ATTEMPTS = 1000


@dataclass(frozen=True, slots=True)
class ToyConfig:
    """What a toy world is made of."""

    table: Table = TABLE  # where objects may stand [m]
    lift_height: float = 0.2  # how high a grasped object is lifted [m]
    sizes: tuple[float, float] = (0.03, 0.18)  # least and greatest size of an object along x and along y [m]
    heights: tuple[float, float] = (0.02, 0.10)  # least and greatest height of an object [m]
    gap: float = 0.01  # least distance between two objects of a sampled scene [m]

    def __post_init__(self) -> None:
        if self.lift_height <= 0:
            raise InvalidValue(f"lift_height = {self.lift_height} m must be positive.")
        for name, (least, greatest) in (("sizes", self.sizes), ("heights", self.heights)):
            if not 0 < least <= greatest:
                raise InvalidValue(
                    f"{name} = ({least}, {greatest}) must be two positive lengths, least first."
                )

    @property
    def object_limits(self) -> ObjectLimits:
        """Which objects the world makes: solid (type 0) and hollow (type 1) ones."""
        return ObjectLimits(FEATURE_NAMES, (self.sizes, self.sizes, self.heights), (0.0, 1.0))


class ToyWorld:
    """The toy world; see the head of this file for its rules.

    Args:
        config: What it is made of, if not as usual.

    Attributes:
        painter: Gives the colours of objects in pictures, if set (see `Painted`).
    """

    name = "toy"
    feature_names = FEATURE_NAMES
    references: tuple[ReferenceKind, ...] = ("place",)

    def __init__(self, config: ToyConfig | None = None):
        self.config = config or ToyConfig()
        self.action_box, self.table = three_waypoints(), self.config.table
        self.painter: Painter | None = None

    @property
    def object_limits(self) -> ObjectLimits:
        """Which objects it makes."""
        return self.config.object_limits

    @property
    def lift_height(self) -> float:
        """How high a grasped object is lifted [m]."""
        return self.config.lift_height

    def sample_scene(self, rng: np.random.Generator, objects: int) -> Scene:
        """Draw a scene of objects that do not overlap; see `World.sample_scene`."""
        least, greatest = self.config.sizes
        footprints = rng.uniform(least, greatest, size=(objects, 2))
        heights = rng.uniform(*self.config.heights, size=(objects, 1))
        hollow = rng.integers(0, 2, size=(objects, 1))
        places = self._sample_places(rng, footprints)
        return Scene(
            features=np.hstack([footprints, heights, hollow]),
            positions=np.hstack([places, heights / 2]),
            orientations=np.tile([0.0, 0.0, 0.0, 1.0], (objects, 1)),
        )

    def _sample_places(
        self, rng: np.random.Generator, footprints: Float[np.ndarray, "M 2"]
    ) -> Float[np.ndarray, "M 2"]:
        low, high = np.array([self.table.x, self.table.y]).T
        places = np.zeros((0, 2))
        for size in footprints:
            candidates = rng.uniform(low, high, size=(_ATTEMPTS, 2))
            room = (footprints[: len(places)] + size) / 2 + self.config.gap  # (placed, 2)
            apart = np.any(np.abs(candidates[:, None] - places) >= room, axis=2).all(axis=1)
            if not apart.any():
                raise InvalidValue(
                    f"{len(footprints)} objects do not fit on the toy table; "
                    f"{len(places)} did, so ask for fewer."
                )
            places = np.vstack([places, candidates[np.argmax(apart)]])
        return places

    def interact(
        self,
        scene: Scene,
        action: Float[np.ndarray, "A"],
        target: int,
        *,
        put_down: bool = True,
        on_frame: FrameSink | None = None,
        ghosts: Float[np.ndarray, "M 3"] | None = None,
        reference: Reference | None = None,
    ) -> Outcome:
        """Perform one action by the rules at the head of this file; see `World.interact`."""
        check_action(self, scene, action, target, reference)
        waypoints = np.asarray(action).reshape(3, 4)
        size, held, carried = scene.features[target], False, False
        centre = aim = scene.positions[target]
        if reference is not None:
            aim = centre_of(reference, scene.positions)
            carried = _is_grasped(size, waypoints[:2])
            shift = np.zeros(3)
            if carried:
                shift[:2] = aim[:2] + waypoints[2, :2] - centre[:2] - waypoints[1, :2]
        elif held := _is_grasped(size, waypoints):
            shift = np.array([0.0, 0.0, self.lift_height])
        else:
            shift = _push(size, waypoints)
        lifted = _moved(scene, target, shift)
        end = scene if held and put_down else lifted
        if on_frame is not None:
            dots = self._pixels(np.array([centre, centre, aim]) + waypoints[:, :3])
            for share in np.linspace(0, 1, FRAMES):
                moved = self.picture(_moved(scene, target, share * shift), ghosts)
                on_frame(draw_dots(moved, dots, DOT_RADIUS), "motion")
            on_frame(draw_dots(self.picture(end, ghosts), dots, DOT_RADIUS), "end")
        lost = not self.table.contains(end.positions[target])
        return Outcome(
            start=scene,
            lifted=lifted,
            end=end,
            target=target,
            held=held,
            toppled=False,
            lost=lost,
            peak_height=self.lift_height if carried else float(shift[2]),
            reference=reference,
            carried=carried,
        )

    def picture(self, scene: Scene, ghosts: Float[np.ndarray, "M 3"] | None = None) -> Frame:
        """Draw a scene from above: forward (+x) is up, left (+y) left; what is in the air casts a shadow."""
        picture = Image.new("RGB", PICTURE, (205, 205, 200))
        canvas = ImageDraw.Draw(picture)

        def draw(centre: np.ndarray, size: np.ndarray, height: float, **look: Any) -> None:
            middle = centre[:2] + np.array([0.2 * height, 0.0])  # off its shadow, if it is in the air
            corners = self._pixels(np.array([middle + size[:2] / 2, middle - size[:2] / 2]))
            canvas.rectangle(corners.ravel().tolist(), **look)

        colours = [tuple(colour) for colour in painted(self.painter, scene.features).tolist()]
        table = self._pixels(np.array([self.table.x, self.table.y]).T[::-1])
        canvas.rectangle(table.ravel().tolist(), fill=(245, 240, 228), outline=(120, 110, 90))
        for index, (size, centre) in enumerate(zip(scene.features, scene.positions, strict=True)):
            height = max(0.0, float(centre[2] - size[2] / 2))
            draw(centre, size, 0.0, fill=(200, 192, 175))
            draw(centre, size, height, fill=colours[index], outline=(40, 40, 40))
            if size[3] >= 0.5:
                draw(centre, 0.7 * size, height, fill=(250, 250, 250), outline=(40, 40, 40))
        for index, centre in enumerate([] if ghosts is None else ghosts):
            if np.all(np.isfinite(centre)):
                size = scene.features[index]
                height = max(0.0, float(centre[2] - size[2] / 2))
                draw(centre, size, height, outline=colours[index], width=3)
        return np.array(picture)

    def _pixels(self, points: Float[np.ndarray, "N D"]) -> Float[np.ndarray, "N 2"]:
        """Return where points (x, y, ...) lie in a picture from above."""
        table, size = np.array([self.table.y, self.table.x]), np.array(PICTURE)  # as pictures lie
        scale = (size / np.ptp(table, axis=1)).min() * 0.85
        return np.asarray(size / 2 - (points[:, 1::-1] - table.mean(1)) * scale)


make_world = ToyWorld
"""Makes a toy world; the factory that worker processes are given."""


def _is_grasped(size: Float[np.ndarray, "F"], waypoints: Float[np.ndarray, "N 4"]) -> bool:
    graspable = size[3] >= 0.5 or size[1] <= WIDEST_GRASP
    return bool(graspable and waypoints[0, 3] >= OPEN and waypoints[-1, 3] < OPEN)


def _push(size: Float[np.ndarray, "F"], waypoints: Float[np.ndarray, "3 4"]) -> Float[np.ndarray, "3"]:
    """Return how far an object is pushed [m]."""
    travel = waypoints[2, :2] - waypoints[0, :2]
    axis = int(np.argmax(np.abs(travel)))
    shift = np.zeros(3)
    if abs(travel[axis]) >= LEAST_TRAVEL and size[0] <= LONGEST_PUSH:
        shift[axis] = np.sign(travel[axis]) * PUSH_LENGTH
    return shift


def _moved(scene: Scene, target: int, shift: Float[np.ndarray, "3"]) -> Scene:
    positions = scene.positions.copy()
    positions[target] += shift
    return replace(scene, positions=positions)
