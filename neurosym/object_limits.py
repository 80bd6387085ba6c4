"""Which objects a world makes, where it says so."""

from dataclasses import dataclass

from neurosym.errors import InvalidValue
from neurosym.world import World

_SLACK = 1e-9
"""Numbers that were written by hand may be off by so much."""

Range = tuple[float, float]


@dataclass(frozen=True, slots=True)
class ObjectLimits:
    """Which objects a world makes; all rest on a table whose top is at height 0.

    Attributes:
        feature_names: What the features are called: sizes along x, y and z, and type.
        sizes: Least and greatest size along each axis [m].
        types: The types there are.
        most: How many one scene can be simulated with; None if there is no limit.
    """

    feature_names: tuple[str, ...]
    sizes: tuple[Range, Range, Range]
    types: tuple[float, ...]
    most: int | None = None

    def too_many(self, objects: int) -> str:
        """Say if there are more objects than can be simulated, or nothing.

        Args:
            objects: How many there are.
        """
        if self.most is None or objects <= self.most:
            return ""
        return f"there are {objects} objects; the simulator takes at most {self.most}"

    def check(self, item: str, features: tuple[float, ...]) -> None:
        """Raise `InvalidValue` unless the world makes such objects.

        Args:
            item: What the object is called.
            features: What it is.
        """
        if len(features) != len(self.feature_names):
            named = ", ".join(self.feature_names)
            raise InvalidValue(f"{item} has {len(features)} features; valid: {named}.")
        *sizes, kind = zip(self.feature_names, features, strict=True)
        for (name, size), (least, greatest) in zip(sizes, self.sizes, strict=True):
            if not least - _SLACK <= size <= greatest + _SLACK:
                raise InvalidValue(f"{item} has {name} = {size:g} m; valid: {least:g} to {greatest:g} m.")
        name, number = kind
        if number not in self.types:
            valid = ", ".join(f"{known:g}" for known in self.types)
            raise InvalidValue(f"{item} has {name} = {number:g}; valid: {valid}.")


def limits_of(world: World) -> ObjectLimits | None:
    """Return which objects a world makes (its `object_limits`), or None if it does not say.

    Args:
        world: The world.
    """
    limits = getattr(world, "object_limits", None)
    return limits if isinstance(limits, ObjectLimits) else None
