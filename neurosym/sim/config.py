"""What the tabletop world is made of."""

from dataclasses import dataclass, field

from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.object_limits import ObjectLimits
from neurosym.sim.shapes import FEATURE_NAMES, SHAPES, TYPES
from neurosym.table import Table

MOST_OBJECTS = 8
"""Objects that one scene can be simulated with; larger problems are symbolic only."""


@dataclass(frozen=True, slots=True)
class TabletopConfig:
    """The options of the tabletop world, as they stand in `world.toml`; every length in metres.

    Attributes:
        table_x: Extent of the table away from the robot's base [m].
        table_y: Extent of the table to the robot's right (-) and left (+) [m].
        spawn_margin: One or two objects start at least this far inside the table's edge [m].
        spawn_gap: Objects start at least this far apart [m].
        size: Least and greatest s_x and s_y [m].
        height: Least and greatest d [m].
        shapes: How often an object is of each shape, relative to the others; see `shapes.SHAPES`.
        wall: Thickness of the walls and floors of open objects [m].
        mass: Mass of every object [kg].
        friction: Lateral friction of objects; the table's is 0.6, a finger's 0.9, and the products count.
        lift_height: How far the hand rises after the last waypoint [m].
        time_step: Step of the simulation [s].
        frame_every: Steps between two pictures, when pictures are asked for.
    """

    table_x: tuple[float, float] = (0.35, 0.95)
    table_y: tuple[float, float] = (-0.3, 0.3)
    spawn_margin: float = 0.12
    spawn_gap: float = 0.04
    size: tuple[float, float] = (0.03, 0.18)
    height: tuple[float, float] = (0.02, 0.10)
    shapes: dict[str, float] = field(default_factory=lambda: dict.fromkeys(SHAPES, 1.0))
    wall: float = 0.006
    mass: float = 0.1
    friction: float = 0.8
    lift_height: float = 0.20
    time_step: float = 1 / 240
    frame_every: int = 12

    def __post_init__(self) -> None:
        self._check_ranges()
        self._check_shapes()
        for name in ("wall", "mass", "friction", "lift_height", "time_step", "frame_every"):
            if not getattr(self, name) > 0:
                raise InvalidValue(f"{name} = {getattr(self, name)} must be greater than 0.")
        if not 1 / 2000 <= self.time_step <= 1 / 120:
            raise InvalidValue(f"time_step = {self.time_step} s must lie between 1/2000 and 1/120 s.")
        if not (self.size[0] > 2 * self.wall and self.height[0] > self.wall):
            raise InvalidValue(f"wall = {self.wall} leaves no room inside the smallest object.")

    def _check_ranges(self) -> None:
        for name in ("size", "height", "table_x", "table_y"):
            least, greatest = getattr(self, name)
            if least > greatest or (least == greatest and name.startswith("table")):
                raise InvalidValue(f"{name} = [{least}, {greatest}] is empty; put the smaller number first.")
        for name in ("size", "height"):
            if not getattr(self, name)[0] > 0:
                raise InvalidValue(f"{name} = {list(getattr(self, name))} must be greater than 0 throughout.")
        for name in ("spawn_margin", "spawn_gap"):
            if not getattr(self, name) >= 0:
                raise InvalidValue(f"{name} = {getattr(self, name)} must not be negative.")
        for name in ("table_x", "table_y"):
            least, greatest = getattr(self, name)
            needed = max(self.size[1], 2 * self.spawn_margin)
            if greatest - least < needed:
                raise InvalidValue(
                    f"{name} = [{least}, {greatest}] is shorter than the {needed} m that objects of size "
                    f"{self.size[1]} m and spawn_margin {self.spawn_margin} m need; lengths are in metres."
                )

    def _check_shapes(self) -> None:
        for name, share in self.shapes.items():
            if name not in SHAPES:
                raise UnknownChoice("shape", name, SHAPES)
            if not share >= 0:
                raise InvalidValue(f"shapes.{name} = {share} must not be negative.")
        if not sum(self.shapes.values()) > 0:
            raise InvalidValue(f"shapes must give one of {', '.join(SHAPES)} a share greater than 0.")

    @property
    def object_limits(self) -> ObjectLimits:
        """Which objects the world makes."""
        types = {TYPES[name] for name, share in self.shapes.items() if share > 0}
        sizes = self.size, self.size, self.height
        return ObjectLimits(FEATURE_NAMES, sizes, tuple(sorted(types)), MOST_OBJECTS)

    @property
    def table(self) -> Table:
        """The part of the table that objects must stay on."""
        return Table(self.table_x, self.table_y)
