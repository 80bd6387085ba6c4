"""The tabletop world: an arm plays with objects in PyBullet."""

from collections.abc import Container
from dataclasses import dataclass, field, replace
from typing import ClassVar

import numpy as np

from neurosym.checks import Float
from neurosym.contract import ObjectLimits, Part, PoseSink
from neurosym.errors import InvalidValue
from neurosym.sim.arm_check import check_arm, check_lift
from neurosym.sim.camera import Camera, links_at_rest, object_parts, open_window, robot_parts
from neurosym.sim.config import (
    FEATURE_NAMES,
    MOST_OBJECTS,
    Arm,
    Client,
    TabletopConfig,
    check_reach,
    pybullet,
)
from neurosym.sim.interaction import Interaction
from neurosym.sim.robot import UR10
from neurosym.sim.simulation import Simulation, sample_scene
from neurosym.world import (
    ActionBox,
    Frame,
    FrameSink,
    Outcome,
    Reference,
    ReferenceKind,
    Scene,
    Table,
    check_action,
    three_waypoints,
)

WINDOW_EVERY = 4
"""Steps of the simulation between two looks at the clock, when it is shown live."""


@dataclass(slots=True, eq=False)
class Tabletop:
    """The PyBullet world of the paper: one arm, one table, objects of several shapes.

    The simulation is built anew for each interaction, so that nothing an earlier one did can show.

    Attributes:
        config: Its options.
        name: Its name.
        feature_names: What its objects' features are.
        arm: The arm that acts in it.
        references: What actions may be relative to besides their target.
        wanted_pictures: Numbers of an interaction's pictures to draw, of one for each step of the
            simulation; if None, all are drawn that `config.frame_every` asks for (see `Sparing`).
        on_pose: Called with the poses of every motion, if set (see `Posed`).
    """

    config: TabletopConfig = field(default_factory=TabletopConfig)
    name: str = "tabletop"
    feature_names: tuple[str, ...] = FEATURE_NAMES
    arm: Arm = UR10
    references: ClassVar[tuple[ReferenceKind, ...]] = ("place", "object")
    wanted_pictures: Container[int] | None = field(default=None, init=False)
    on_pose: PoseSink | None = field(default=None, init=False)
    _client: Client | None = field(default=None, init=False)

    def __post_init__(self) -> None:
        check = check_reach if self.arm is UR10 else check_arm  # a test compares the UR10 with its file
        check(self.config, self.arm)

    @property
    def action_box(self) -> ActionBox:
        """Three waypoints, relative to the target's centre."""
        return three_waypoints()

    @property
    def table(self) -> Table:
        """The part of the table that objects must stay on."""
        return self.config.table

    @property
    def object_limits(self) -> ObjectLimits:
        """Which objects it makes."""
        return self.config.object_limits

    @property
    def lift_height(self) -> float:
        """How far the hand rises after the last waypoint [m]."""
        return self.config.lift_height

    def sample_scene(self, rng: np.random.Generator, objects: int) -> Scene:
        """Draw objects of random shape and size at rest on the table (see `World.sample_scene`)."""
        return sample_scene(self.config, rng, objects)

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
        """Perform one action on one object, from empty hand to empty hand (see `World.interact`)."""
        check_action(self, scene, action, target, reference)
        if not scene.features[:, :3].min() > 0:
            raise InvalidValue("An object of the scene has a size that is not greater than 0.")
        if len(scene) > MOST_OBJECTS:
            raise InvalidValue(
                f"The scene has {len(scene)} objects; the simulator takes at most {MOST_OBJECTS}, "
                "larger problems are symbolic only."
            )
        config = self.config if self.wanted_pictures is None else replace(self.config, frame_every=1)
        simulation = Simulation(self.client(), config, scene)
        try:
            camera = Camera(simulation, ghosts, self.wanted_pictures) if on_frame else None
            interaction = Interaction(simulation, self.arm, target, on_frame, camera, self.on_pose)
            return interaction.perform(np.asarray(action, dtype=float), put_down, reference)
        except pybullet.error as error:
            if self.client().isConnected():
                raise
            raise InvalidValue("The window was closed before the motion ended.") from error

    def try_out(self) -> None:
        """Lift a plain box once (see `check_world`).

        Raises:
            InvalidArm: If the hand does not.
        """
        check_lift(self.client(), self.config, self.arm)

    def picture(self, scene: Scene, ghosts: Float[np.ndarray, "M 3"] | None = None) -> Frame:
        """Draw a scene without the arm (see `Pictured.picture`)."""
        return Camera(Simulation(self.client(), self.config, scene), ghosts).picture()

    def robot_parts(self) -> tuple[Part, ...]:
        """Return what the arm is drawn with (see `Posed.robot_parts`)."""
        return robot_parts(self.arm)

    def robot_at_rest(self) -> Float[np.ndarray, "L 7"]:
        """Return the poses of the arm's links while it waits (see `Posed.robot_at_rest`)."""
        nothing = Scene(np.zeros((0, len(FEATURE_NAMES))), np.zeros((0, 3)), np.zeros((0, 4)))
        return links_at_rest(Simulation(self.client(), self.config, nothing), self.arm)

    def object_parts(self, features: Float[np.ndarray, "F"]) -> tuple[Part, ...]:
        """Return what an object is drawn with (see `Posed.object_parts`)."""
        return object_parts(features, self.config.wall)

    def open_window(self) -> None:
        """Show everything that happens from now on live in a window (see `Windowed.open_window`)."""
        self._client = open_window()
        self.config = replace(self.config, frame_every=WINDOW_EVERY)

    def client(self) -> Client:
        """Return this process's physics client, connecting on first use."""
        if self._client is None:
            self._client = Client()
        return self._client

    def __getstate__(self) -> tuple[TabletopConfig, str, Arm]:
        """Leave the physics client behind: another process connects to its own."""
        return self.config, self.name, self.arm

    def __setstate__(self, state: tuple[TabletopConfig, str, Arm]) -> None:
        self.config, self.name, self.arm = state
        self.feature_names, self.wanted_pictures, self.on_pose, self._client = FEATURE_NAMES, None, None, None
