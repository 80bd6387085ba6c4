"""What a network reads and writes, which is what a row of data holds."""

from dataclasses import dataclass

from neurosym.errors import InvalidValue


@dataclass(frozen=True, slots=True)
class Dimensions:
    """What the network reads and writes.

    Attributes:
        features: How many object features.
        actions: How many action parameters.
        effects: How many effect axes.
        gripper_columns: Which action parameters are gripper values.
    """

    features: int = 4
    actions: int = 12
    effects: int = 3
    gripper_columns: tuple[int, ...] = (3, 7, 11)

    def __post_init__(self) -> None:
        if min(self.features, self.actions, self.effects) < 1:
            raise InvalidValue(f"{self} must have at least one feature, action parameter and effect axis.")
        if not all(0 <= column < self.actions for column in self.gripper_columns):
            raise InvalidValue(f"gripper_columns = {self.gripper_columns} must be below {self.actions}.")
