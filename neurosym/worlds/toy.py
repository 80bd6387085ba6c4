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

from dataclasses import dataclass

import numpy as np
from PIL import Image, ImageDraw

from neurosym.checks import Float
from neurosym.contract import ObjectLimits
from neurosym.errors import InvalidValue
from neurosym.operators import draw_dots
from neurosym.world import (
    Frame,
    FrameSink,
    Outcome,
    Reference,
    ReferenceKind,
    Scene,
    Table,
    centre_of,
    check_action,
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
COLOURS = ((214, 96, 58), (88, 122, 158), (92, 150, 92), (148, 108, 180))
FRAMES = 8
DOT_RADIUS = 6.0
_ATTEMPTS = 1000


@dataclass(frozen=True, slots=True)
class ToyConfig:
    """What a toy world is made of.

    Attributes:
        table: Where objects may stand [m].
        lift_height: How high a grasped object is lifted [m].
        sizes: Least and greatest size of an object along x and along y [m].
        heights: Least and greatest height of an object [m].
        gap: Least distance between two objects of a sampled scene [m].
    """

    table: Table = TABLE
    lift_height: float = 0.2
    sizes: tuple[float, float] = (0.03, 0.18)
    heights: tuple[float, float] = (0.02, 0.10)
    gap: float = 0.01

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


def make_world(config: ToyConfig | None = None) -> "ToyWorld":
    """Make a toy world; the factory that worker processes are given.

    Args:
        config: What it is made of.
    """
    return ToyWorld(config or ToyConfig())


class ToyWorld:
    """The toy world; see the head of this file for its rules."""

    name = "toy"
    feature_names = FEATURE_NAMES
    references: tuple[ReferenceKind, ...] = ("place",)

    def __init__(self, config: ToyConfig):
        self.config = config
        self.action_box = three_waypoints()

    @property
    def table(self) -> Table:
        """Where objects may stand."""
        return self.config.table

    @property
    def object_limits(self) -> ObjectLimits:
        """Which objects it makes."""
        return self.config.object_limits

    @property
    def lift_height(self) -> float:
        """How high a grasped object is lifted [m]."""
        return self.config.lift_height

    def sample_scene(self, rng: np.random.Generator, objects: int) -> Scene:
        """Draw a scene of objects that do not overlap.

        Args:
            rng: Source of randomness, owned by the caller.
            objects: How many objects.

        Raises:
            InvalidValue: If so many objects do not fit on the table.
        """
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
        """Perform one action on one object by the rules at the head of this file.

        Args:
            scene: The objects, at rest.
            action: Three waypoints (x, y, z, g) relative to the target's centre.
            target: Index of the object acted upon.
            put_down: Whether to put down an object that is held.
            on_frame: Called with pictures from above, if given.
            ghosts: Centres at which pictures show the objects once more, in outline [m].
            reference: Where the object is carried, if anywhere.

        Raises:
            InvalidValue: If the action has another shape, is not finite, the target does not exist, or the
                reference lies off the table.
        """
        check_action(self, scene, action, target, reference)
        waypoints = np.asarray(action).reshape(3, 4)
        size, held, carried = scene.features[target], False, False
        if reference is not None:
            carried = _is_grasped(size, waypoints[:2])
            shift = _carry(scene, target, waypoints, reference) if carried else np.zeros(3)
        elif held := _is_grasped(size, waypoints):
            shift = np.array([0.0, 0.0, self.lift_height])
        else:
            shift = _push(size, waypoints)
        lifted = _moved(scene, target, shift)
        end = scene if held and put_down else lifted
        if on_frame is not None:
            centre = scene.positions[target]
            aim = centre if reference is None else centre_of(reference, scene.positions)
            origins = np.array([centre, centre, aim])
            dots = self._pixels(origins + waypoints[:, :3])
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
        """Draw a scene from above: forward (+x) is up, left (+y) left; what is in the air casts a shadow.

        Args:
            scene: The objects.
            ghosts: Centres at which the objects are shown once more, in outline [m]; NaN for none.
        """
        picture = Image.new("RGB", PICTURE, (205, 205, 200))
        canvas = ImageDraw.Draw(picture)
        canvas.rectangle(
            self._box((self.table.x, self.table.y)), fill=(245, 240, 228), outline=(120, 110, 90)
        )
        for index, (size, centre) in enumerate(zip(scene.features, scene.positions, strict=True)):
            height = max(0.0, float(centre[2] - size[2] / 2))
            canvas.rectangle(self._box(_spans(centre, size, 0.0)), fill=(200, 192, 175))
            colour = COLOURS[index % len(COLOURS)]
            canvas.rectangle(self._box(_spans(centre, size, height)), fill=colour, outline=(40, 40, 40))
            if size[3] >= 0.5:
                hollow = _spans(centre, 0.7 * size, height)
                canvas.rectangle(self._box(hollow), fill=(250, 250, 250), outline=(40, 40, 40))
        for index, centre in enumerate([] if ghosts is None else ghosts):
            if np.all(np.isfinite(centre)):
                size = scene.features[index]
                outline = self._box(_spans(centre, size, max(0.0, float(centre[2] - size[2] / 2))))
                canvas.rectangle(outline, outline=COLOURS[index % len(COLOURS)], width=3)
        return np.array(picture)

    def _pixels(self, points: Float[np.ndarray, "N 3"]) -> Float[np.ndarray, "N 2"]:
        """Return where points lie in a picture from above."""
        return np.array([self._box(((x, x), (y, y)))[:2] for x, y, _ in points])

    def _box(self, spans: tuple[tuple[float, float], tuple[float, float]]) -> tuple[float, ...]:
        (x_low, x_high), (y_low, y_high) = spans
        table = self.table
        width, height = PICTURE
        scale = min(width / (table.y[1] - table.y[0]), height / (table.x[1] - table.x[0])) * 0.85
        middle_x, middle_y = sum(table.x) / 2, sum(table.y) / 2
        left, right = (width / 2 - (y - middle_y) * scale for y in (y_high, y_low))
        top, bottom = (height / 2 - (x - middle_x) * scale for x in (x_high, x_low))
        return left, top, right, bottom


def _is_grasped(size: Float[np.ndarray, "F"], waypoints: Float[np.ndarray, "N 4"]) -> bool:
    graspable = size[3] >= 0.5 or size[1] <= WIDEST_GRASP
    return bool(graspable and waypoints[0, 3] >= OPEN and waypoints[-1, 3] < OPEN)


def _carry(
    scene: Scene, target: int, waypoints: Float[np.ndarray, "3 4"], reference: Reference
) -> Float[np.ndarray, "3"]:
    there, here = centre_of(reference, scene.positions), scene.positions[target]
    shift = there + waypoints[2, :3] - here - waypoints[1, :3]
    return np.asarray(shift * [1.0, 1.0, 0.0])


def _push(size: Float[np.ndarray, "F"], waypoints: Float[np.ndarray, "3 4"]) -> Float[np.ndarray, "3"]:
    travel = waypoints[2, :2] - waypoints[0, :2]
    axis = int(np.argmax(np.abs(travel)))
    shift = np.zeros(3)
    if abs(travel[axis]) >= LEAST_TRAVEL and size[0] <= LONGEST_PUSH:
        shift[axis] = np.sign(travel[axis]) * PUSH_LENGTH
    return shift


def _moved(scene: Scene, target: int, shift: Float[np.ndarray, "3"]) -> Scene:
    positions = scene.positions.copy()
    positions[target] += shift
    return Scene(scene.features, positions, scene.orientations)


def _spans(
    centre: Float[np.ndarray, "3"], size: Float[np.ndarray, "F"], height: float
) -> tuple[tuple[float, float], tuple[float, float]]:
    offset = 0.2 * height  # a thing in the air is drawn a little higher up, off its shadow
    x, y = float(centre[0]) + offset, float(centre[1])
    return (x - size[0] / 2, x + size[0] / 2), (y - size[1] / 2, y + size[1] / 2)
