"""The tabletop world: a UR10 plays with boxes in PyBullet."""

from dataclasses import dataclass, field

import numpy as np
import pybullet
from jaxtyping import Float

from neurosym.errors import InvalidValue
from neurosym.sim.config import TabletopConfig
from neurosym.sim.interaction import Interaction
from neurosym.sim.shapes import FEATURE_NAMES
from neurosym.world import ActionBox, FrameSink, Outcome, Scene, Table, check_action, three_waypoints


@dataclass(slots=True, eq=False)
class Tabletop:
    """The PyBullet world of the paper: one arm, one table, boxes.

    The simulation is built anew for each interaction, so that nothing an earlier one did can show.
    """

    config: TabletopConfig = field(default_factory=TabletopConfig)
    name: str = "tabletop"
    feature_names: tuple[str, ...] = FEATURE_NAMES
    _client: int | None = field(default=None, init=False)

    @property
    def action_box(self) -> ActionBox:
        """Three waypoints, relative to the target's centre."""
        return three_waypoints()

    @property
    def table(self) -> Table:
        """The part of the table that objects must stay on."""
        return self.config.table

    @property
    def lift_height(self) -> float:
        """How far the hand rises after the last waypoint [m]."""
        return self.config.lift_height

    def sample_scene(self, rng: np.random.Generator, objects: int) -> Scene:
        """Draw boxes of random size and type at rest on the table, not overlapping.

        Args:
            rng: Source of randomness, owned by the caller.
            objects: How many objects.

        Raises:
            InvalidValue: If so many objects do not fit.
        """
        c = self.config
        features = np.column_stack(
            [
                rng.uniform(*c.size, size=objects),
                rng.uniform(*c.size, size=objects),
                rng.uniform(*c.height, size=objects),
                (rng.random(objects) < c.hollow_share).astype(float),
            ]
        )  # (M, 4)
        places = self._sample_places(rng, features[:, :2] / 2)
        return Scene(
            features=features,
            positions=np.column_stack([places, features[:, 2] / 2]),
            orientations=np.tile([0.0, 0.0, 0.0, 1.0], (objects, 1)),
        )

    def _sample_places(
        self, rng: np.random.Generator, half_sizes: Float[np.ndarray, "M 2"]
    ) -> Float[np.ndarray, "M 2"]:
        c = self.config
        low = np.array([c.table_x[0], c.table_y[0]])
        high = np.array([c.table_x[1], c.table_y[1]])
        margins = np.full_like(half_sizes, c.spawn_margin) if len(half_sizes) <= 2 else half_sizes
        for _ in range(10_000):
            places = rng.uniform(low + margins, high - margins)
            apart = np.abs(places[:, None] - places) - (half_sizes[:, None] + half_sizes)  # (M, M, 2)
            clear = apart.max(axis=-1) >= c.spawn_gap
            if clear[np.triu_indices(len(places), 1)].all():
                return np.asarray(places)
        raise InvalidValue(f"{len(half_sizes)} objects do not fit on the table; ask for fewer.")

    def interact(
        self,
        scene: Scene,
        action: Float[np.ndarray, "A"],
        target: int,
        *,
        put_down: bool = True,
        on_frame: FrameSink | None = None,
    ) -> Outcome:
        """Perform one action on one object, from empty hand to empty hand (see `World.interact`)."""
        check_action(self, scene, action, target)
        interaction = Interaction(self.client(), self.config, scene, target, on_frame)
        return interaction.perform(np.asarray(action, dtype=float), put_down)

    def client(self) -> int:
        """Return this process's physics client, connecting on first use."""
        if self._client is None:
            self._client = pybullet.connect(pybullet.DIRECT)
        return self._client

    def __getstate__(self) -> tuple[TabletopConfig, str, tuple[str, ...]]:
        """Leave the physics client behind: another process connects to its own."""
        return self.config, self.name, self.feature_names

    def __setstate__(self, state: tuple[TabletopConfig, str, tuple[str, ...]]) -> None:
        self.config, self.name, self.feature_names = state
        self._client = None
