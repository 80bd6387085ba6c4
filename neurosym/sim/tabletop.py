"""The tabletop world: an arm plays with objects in PyBullet."""

from collections.abc import Container, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from neurosym.checks import Float
from neurosym.contract import Part, PoseSink
from neurosym.errors import InvalidValue
from neurosym.sim.arm_check import check_arm, check_lift
from neurosym.sim.camera import Camera, links_at_rest, open_window, robot_parts
from neurosym.sim.config import (
    Arm,
    Client,
    TabletopConfig,
    check_reach,
    pybullet,
)
from neurosym.sim.interaction import Interaction
from neurosym.sim.robot import UR10
from neurosym.sim.shapes import FEATURE_NAMES, body_of
from neurosym.sim.simulation import Simulation, sample_scene
from neurosym.world import (
    Frame,
    FrameSink,
    Outcome,
    Painter,
    Reference,
    ReferenceKind,
    Scene,
    check_action,
    three_waypoints,
)

WINDOW_EVERY = 4
"""Steps of the simulation between two looks at the clock, when it is shown live."""


class Tabletop:
    """The PyBullet world of the paper: one arm, one table, objects of several shapes.

    The simulation is built anew for each interaction, so that nothing an earlier one did can show.

    Args:
        config: Its options.
        name: Its name.
        arm: The arm that acts in it.

    Attributes:
        wanted_pictures: Numbers of an interaction's pictures to draw, of one for each step of the
            simulation; if None, all are drawn that `config.frame_every` asks for (see `Sparing`).
        painter: Gives the colours of objects in pictures, if set (see `Painted`).
        on_pose: Called with the poses of every motion, if set (see `Posed`).
    """

    feature_names = FEATURE_NAMES
    references: tuple[ReferenceKind, ...] = ("place", "object")

    def __init__(self, config: TabletopConfig | None = None, name: str = "tabletop", arm: Arm = UR10):
        self.config, self.name, self.arm = config or TabletopConfig(), name, arm
        self.action_box, self.lift_height = three_waypoints(), self.config.lift_height
        self.table, self.object_limits = self.config.table, self.config.object_limits
        self.turns = arm.wrist is not None
        self.wanted_pictures: Container[int] | None = None
        self.painter: Painter | None = None
        self.on_pose: PoseSink | None = None
        self._client: Client | None = None
        check = check_reach if arm == UR10 else check_arm  # a test compares the UR10 with its file
        check(self.config, arm)

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
        for unseen in scene.unseen.tolist():
            self.object_limits.check_unseen("An object of the scene", unseen)
        if (most := self.object_limits.most) and len(scene) > most:
            raise InvalidValue(
                f"The scene has {len(scene)} objects; the simulator takes at most {most}, "
                "larger problems are symbolic only."
            )
        config = self.config if self.wanted_pictures is None else replace(self.config, frame_every=1)
        simulation = self._simulated(config, scene, watched=on_frame is not None or self.on_pose is not None)
        try:
            camera = Camera(simulation, ghosts, self.wanted_pictures, self.painter) if on_frame else None
            interaction = Interaction(
                simulation, self.arm, target, on_frame, camera, self.on_pose, scene.orientations
            )
            return interaction.perform(np.asarray(action, dtype=float), put_down, reference)
        except pybullet.error as error:
            if self.client().isConnected():
                raise
            raise InvalidValue("The window was closed before the motion ended.") from error

    def _simulated(self, config: TabletopConfig, scene: Scene, *, watched: bool = False) -> Simulation:
        """Return a scene in the engine that the options name."""
        if config.engine == "pybullet":
            return Simulation(self.client(), config, scene)
        from neurosym.sim.mujoco_engine import MujocoSimulation

        return MujocoSimulation(self.client(), config, scene, self.arm, watched=watched)

    def try_out(self) -> None:
        """Lift a plain box once (see `check_world`).

        Raises:
            InvalidArm: If the hand does not.
        """
        check_lift(self._simulated, self.config, self.arm)

    def picture(self, scene: Scene, ghosts: Float[np.ndarray, "M 3"] | None = None) -> Frame:
        """Draw a scene without the arm (see `Pictured.picture`)."""
        simulation = Simulation(self.client(), self.config, scene)
        return Camera(simulation, ghosts, painter=self.painter).picture()

    def robot_parts(self) -> tuple[Part, ...]:
        """Return what the arm is drawn with (see `Posed.robot_parts`)."""
        return robot_parts(self.arm)

    def robot_at_rest(self) -> Float[np.ndarray, "L 7"]:
        """Return the poses of the arm's links while it waits (see `Posed.robot_at_rest`)."""
        nothing = Scene(np.zeros((0, len(FEATURE_NAMES))), np.zeros((0, 3)), np.zeros((0, 4)))
        return links_at_rest(Simulation(self.client(), self.config, nothing), self.arm)

    def object_parts(self, features: Float[np.ndarray, "F"], *unseen: Sequence[float]) -> tuple[Part, ...]:
        """Return what an object is drawn with (see `Posed.object_parts`)."""
        c = self.config
        return body_of(features, *(unseen or ((),)), wall=c.wall, mass=c.mass, friction=c.friction).parts

    def open_window(self) -> None:
        """Show everything that happens from now on live in a window (see `Windowed.open_window`)."""
        self._client = open_window()
        self.config = replace(self.config, frame_every=WINDOW_EVERY)

    def client(self) -> Client:
        """Return this process's physics client, connecting on first use."""
        if self._client is None:
            self._client = Client()
        return self._client

    def __reduce__(self) -> tuple[Any, ...]:
        """Leave the physics client behind: another process connects to its own."""
        return Tabletop, (self.config, self.name, self.arm)
