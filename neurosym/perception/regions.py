"""Objects as a depth image shows them: connected regions above the table, and which known object each is.

Nothing here knows what a simulator knows. A region's outline at its top gives heading, size and middle; what
is around it at each point is its crop. What was known of objects then meets what is seen now.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache

import numpy as np
from scipy import ndimage
from scipy.optimize import linear_sum_assignment
from scipy.spatial import ConvexHull
from scipy.spatial.transform import Rotation

from neurosym.checks import Float, check_array
from neurosym.errors import InvalidValue

FLOOR = 0.004
"""What is higher than this above the table belongs to an object [m]."""
CELLS, CELL = 32, 0.0065
"""A crop has so many cells a side, each of this length [m]."""
_AROUND = np.ones((3, 3))  # the pixels around one
_LEAST = 12  # pixels of a region; what is smaller is noise
_RIM = 0.004  # what is at most this much lower than the top belongs to the top [m]
_BAND = 0.3  # share of an outline around its middle where its edges are located
_LINES = 3  # pixels that this is wide, at least
_BEYOND = 1.5  # an outline that reaches so many pixels further elsewhere is no rectangle
_WIDER = 2.5  # what reaches so many pixels further than its top is no box
_STRAIGHTER = 0.97  # an outline lies turned only if its box is smaller than the straight one by this factor
_THIN = 1e-6  # an outline narrower than this has no hull [m]
_TURNS = np.radians(np.arange(-45, 45, 0.5))

FITS = 0.015
"""A region is not of an object if their extents differ by more along any axis [m]."""
_ALIKE = 0.004  # ways to lie whose extents differ by no more than this are not told apart by them [m]
_MOVED = 0.2  # how much the distance from where it was counts of what was acted upon, beside others

Crop = Float[np.ndarray, "cells cells"]
"""Heights above the table around an object's middle, 0 where it is not [m]; rows along its x axis, columns
along its y axis."""


@dataclass(frozen=True, slots=True, eq=False)
class Sight:
    """What a depth camera sees; where it is decides what that means."""

    depths: Float[np.ndarray, "height width"]  #: How far each pixel looks along its ray; NaN where it is lost
    #: Where each pixel looks, from where the camera is; one of length 1 is as long as a depth of 1 m
    rays: Float[np.ndarray, "height width 3"]
    eye: Float[np.ndarray, "3"]  #: Where the camera is [m]

    def __post_init__(self) -> None:
        check_array("The image", np.nan_to_num(self.depths), (*self.rays.shape[:2],))

    def __getitem__(self, part: tuple[slice, ...]) -> "Sight":
        return Sight(self.depths[part], self.rays[part], self.eye)

    @property
    def points(self) -> Float[np.ndarray, "height width 3"]:
        """Where in the world each pixel looks [m]."""
        return np.asarray(self.eye + self.depths[..., None] * self.rays)

    @property
    def pixel(self) -> float:
        """How far apart pixels next to each other look, 1 m below the camera, in the median [m]."""
        below = self.rays[..., :2] / -self.rays[..., 2:]
        return float(np.median(np.linalg.norm(np.diff(below, axis=1), axis=-1)))

    def at_height(self, height: float) -> Float[np.ndarray, "height width 2"]:
        """Return where the ray of each pixel meets the plane at a height [m]."""
        share = (height - self.eye[2]) / self.rays[..., 2:]
        return np.asarray(self.eye[:2] + share * self.rays[..., :2])


@dataclass(frozen=True, slots=True, eq=False)
class Region:
    """An object as it is seen."""

    position: Float[np.ndarray, "3"]  #: Its middle in the world [m]
    heading: float  #: How far it is turned about the vertical, from -pi/4 to pi/4 [rad]
    size: Float[np.ndarray, "3"]  #: Along its own x and y axes, and upwards [m]
    crop: Crop  #: What of it lies where
    #: Which share of the box around its outline is not filled: 0 of a box, more where it is round or angled,
    #: or where two objects touch
    doubt: float


@dataclass(frozen=True, slots=True, eq=False)
class KnownBox:
    """Where an object is that is known."""

    middle: Float[np.ndarray, "3"]  #: In the world [m]
    axes: Float[np.ndarray, "3 3"]  #: Its own axes, as columns
    size: Float[np.ndarray, "3"]  #: Along these [m]

    def holds(self, points: Float[np.ndarray, "*n 3"]) -> np.ndarray:
        """Say which points [m] belong to it."""
        own = np.abs((points - self.middle) @ self.axes)
        return np.asarray(np.all(own <= self.size / 2 + _RIM, axis=-1))

    @property
    def top(self) -> float:
        """How high it reaches [m]."""
        return float(np.abs(self.axes[2]) @ self.size) / 2 + float(self.middle[2])

    def top_at(self, x: float, y: float) -> float:
        """Return how high what stands on it stands at a place; 0 beside it [m]."""
        return self.top if self.holds(np.array([x, y, self.middle[2]])) else 0.0


def regions_of(sight: Sight, known: Sequence[KnownBox] = (), *, top: float | None = None) -> list[Region]:
    """Find the objects in what a camera sees.

    Args:
        sight: What it sees.
        known: Objects that are left out. What stands on one is seen from its top upwards.
        top: Only what is as high above the table as this is looked at, if given [m]: of objects that touch,
            and are not of one height, each is found so.

    Raises:
        InvalidValue: If no pixel has a depth.
    """
    points = sight.points
    heights = points[..., 2]
    if not np.isfinite(heights).any():
        raise InvalidValue("The image is empty: no pixel of it has a depth.")
    is_high = np.nan_to_num(heights, nan=-1.0) > FLOOR
    for box in known:
        is_high &= ~box.holds(points)
    if top is not None:
        is_high &= np.abs(np.nan_to_num(heights) - top) < _RIM
    labels, _ = ndimage.label(is_high | np.isnan(heights), _AROUND)  # lost pixels part nothing
    pixel = sight.pixel
    found = (
        _region(sight[box], points[box], (labels[box] == number) & is_high[box], known, pixel)
        for number, box in enumerate(ndimage.find_objects(labels), 1)
    )
    return [one for one in found if one is not None]


def _region(
    sight: Sight,
    points: Float[np.ndarray, "height width 3"],
    mask: np.ndarray,
    known: Sequence[KnownBox],
    pixel: float,
) -> Region | None:
    """Describe the object that some pixels show; None if they are too few."""
    if mask.sum() < _LEAST:
        return None
    height = float(np.percentile(points[mask][:, 2], 98))
    top = np.pad(mask & (np.nan_to_num(points[..., 2]) > height - _RIM), 1)
    outline = ndimage.binary_fill_holes(ndimage.binary_closing(top, _AROUND))[1:-1, 1:-1]
    plane, pixel = sight.at_height(height), pixel * (float(sight.eye[2]) - height)
    flat, every = plane[outline], points[mask][:, :2]
    heading = _heading_of(flat if len(flat) >= _LEAST else every)
    own, whole = _turned(flat, -heading), _turned(every, -heading)
    if len(flat) < _LEAST or np.any(np.ptp(whole, axis=0) > np.ptp(own, axis=0) + _WIDER * pixel):
        own = whole  # its top is not all of it, as that of a ball
    (low_x, high_x), (low_y, high_y) = (_edges(own, axis, pixel) for axis in (0, 1))
    x, y = _turned(np.array([(low_x + high_x) / 2, (low_y + high_y) / 2]), heading).tolist()
    below = max((box.top_at(x, y) for box in known), default=0.0)
    size = np.array([high_x - low_x, high_y - low_y, max(height - below, 0.0)])
    filled = len(own) * pixel**2 / max(size[0] * size[1], pixel**2)
    doubt = round(min(1.0, max(0.0, 1 - filled)), 3)
    middle = np.array([x, y, (below + height) / 2])
    return Region(middle, heading, size, _crop(points[mask], (x, y), heading), doubt)


def _turned(points: Float[np.ndarray, "*n 2"], angle: float) -> Float[np.ndarray, "*n 2"]:
    cosine, sine = math.cos(angle), math.sin(angle)
    return np.asarray(points @ np.array([[cosine, sine], [-sine, cosine]]))


def _heading_of(outline: Float[np.ndarray, "N 2"]) -> float:
    """Return how the smallest box around an outline is turned; 0 if a straight one is hardly larger."""
    corners = outline - outline.mean(0)
    if np.linalg.eigvalsh(np.cov(corners.T)).min() > _THIN**2:
        corners = corners[ConvexHull(corners).vertices]
    cosines, sines = np.cos(_TURNS), np.sin(_TURNS)
    x, y = corners[:, :1], corners[:, 1:]
    areas = np.ptp(x * cosines + y * sines, axis=0) * np.ptp(y * cosines - x * sines, axis=0)
    straight = areas[np.argmin(np.abs(_TURNS))]
    return float(_TURNS[areas.argmin()]) if areas.min() < _STRAIGHTER * straight else 0.0


def _edges(own: Float[np.ndarray, "N 2"], axis: int, pixel: float) -> tuple[float, float]:
    """Locate both edges of an outline along one of its own axes.

    Each line of pixels across ends somewhere within a pixel of the edge; so the mean over lines is truer than
    a pixel. Of what is no rectangle it is the outermost.
    """
    along, across = own[:, axis], own[:, 1 - axis]
    middle, reach = (across.min() + across.max()) / 2, np.ptp(across) + pixel
    band = max(_BAND * reach, _LINES * pixel)
    lines = np.floor((across - middle + band / 2) / pixel).astype(int)
    inside = (lines >= 0) & (lines < math.ceil(band / pixel))
    found = []
    for sign in (-1, 1):
        ends = np.full(math.ceil(band / pixel), -np.inf)
        np.maximum.at(ends, lines[inside], sign * along[inside])
        ends, outermost = ends[np.isfinite(ends)], float((sign * along).max())
        edge = float(ends.mean()) + pixel / 2 if len(ends) else outermost
        found.append(sign * (edge if outermost - edge < _BEYOND * pixel else outermost))
    return found[0], found[1]


def _crop(
    points: Float[np.ndarray, "N 3"], middle: tuple[float, float], heading: float
) -> Float[np.ndarray, "cells cells"]:
    """Return what lies where of an object, seen straight from above, in its own frame."""
    own = _turned(points[:, :2] - middle, -heading)
    rows, columns = np.floor(own / CELL + CELLS / 2).astype(int).T
    crop = np.zeros((CELLS, CELLS))
    inside = (rows >= 0) & (rows < CELLS) & (columns >= 0) & (columns < CELLS)
    np.maximum.at(crop, (rows[inside], columns[inside]), points[inside, 2])
    return crop


# Which region is which object: by extents, however an object lies, and by where it was


@dataclass(frozen=True, slots=True, eq=False)
class Tracked:
    """Where known objects are seen."""

    positions: Float[np.ndarray, "M 3"]  #: Their middles [m]; as they were where nothing was seen
    orientations: Float[np.ndarray, "M 4"]  #: As quaternions (x, y, z, w); likewise
    is_seen: tuple[bool, ...]  #: Which objects are told apart from all others


def track(
    found: list[Region],
    sizes: Float[np.ndarray, "M 3"],
    positions: Float[np.ndarray, "M 3"],
    orientations: Float[np.ndarray, "M 4"],
    target: int | None = None,
) -> Tracked:
    """Find objects that are known among regions.

    An object and a region belong together if their extents fit, however the object lies; of several, those
    near to where it was. Objects that touch make one region that fits none of them, and are not told apart.

    Args:
        found: What is seen.
        sizes: Sizes of objects along their own axes [m].
        positions: Where they were [m].
        orientations: How they lay.
        target: Which object was acted upon, if any; it may be far from where it was.
    """
    misfits = np.array([[_misfit(one, size) for one in found] for size in sizes]).reshape(len(sizes), -1)
    apart = np.array([[math.dist(one.position[:2], at[:2]) for one in found] for at in positions])
    apart = apart.reshape(misfits.shape)
    if target is not None:
        apart[target] *= _MOVED
    costs = np.where(misfits <= FITS, apart + misfits, 1e3)
    placed, lying = positions.copy(), orientations.copy()
    seen = [False] * len(sizes)
    for row, column in zip(*linear_sum_assignment(costs), strict=True):
        if costs[row, column] < 1e3:
            one = found[column]
            lying[row] = _lying(one, sizes[row], orientations[row])
            placed[row], seen[row] = one.position, True
    return Tracked(placed, lying, tuple(seen))


def track_all(
    sight: Sight,
    sizes: Float[np.ndarray, "M 3"],
    positions: Float[np.ndarray, "M 3"],
    orientations: Float[np.ndarray, "M 4"],
    target: int,
) -> Tracked:
    """Find known objects in what a camera sees, those that touch others, too; see `track`.

    Objects that are not told apart at first are looked for again with all that belongs to the others left
    out, and then by their heights. At last the target is looked for with the others where they were.
    """
    told = track(regions_of(sight), sizes, positions, orientations, target)
    placed, lying, seen = told.positions, told.orientations, [*told.is_seen]

    def box(number: int) -> KnownBox:
        return KnownBox(placed[number], Rotation.from_quat(lying[number]).as_matrix(), sizes[number])

    def seek(number: int, others: Sequence[int], *, by_height: bool = False) -> None:
        if seen[number]:
            return
        top, one = box(number).top if by_height else None, slice(number, number + 1)
        found = regions_of(sight, [box(other) for other in others if other != number], top=top)
        again = track(found, sizes[one], placed[one], lying[one], target=0)
        if again.is_seen[0]:
            placed[one], lying[one], seen[number] = again.positions, again.orientations, True

    every = range(len(sizes))
    for by_height in (False, True) if len(sizes) > 1 else ():
        for number in every:
            seek(number, [other for other in every if seen[other]], by_height=by_height)
    seek(target, every)
    return Tracked(placed, lying, tuple(seen))


def _misfit(region: Region, size: Float[np.ndarray, "3"]) -> float:
    """Return by how much the extents of a region differ from those of an object, however it lies [m]."""
    return float(_misfits(region, size).min())


def _misfits(region: Region, size: Float[np.ndarray, "3"]) -> Float[np.ndarray, "24"]:
    extents = np.abs(_quarters().as_matrix()) @ size  # (24, 3)
    return np.asarray(np.abs(extents - region.size).max(1))


def _lying(
    region: Region, size: Float[np.ndarray, "3"], before: Float[np.ndarray, "4"]
) -> Float[np.ndarray, "4"]:
    """Return how an object lies that is seen as a region: of all ways that fit, the one nearest to before."""
    misfits = _misfits(region, size)
    ways = Rotation.from_euler("z", region.heading) * _quarters()
    away = (ways * Rotation.from_quat(before).inv()).magnitude()
    away[misfits > misfits.min() + _ALIKE] = np.inf
    return np.asarray(ways[int(away.argmin())].as_quat(canonical=True))


@cache
def _quarters() -> Rotation:
    """All turns by quarters about any axes."""
    return Rotation.create_group("O")
