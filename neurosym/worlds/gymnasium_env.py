"""Any world as a Gymnasium environment, whose steps are whole interactions, from empty hand to empty hand.

Importing this module registers `neurosym/Tabletop-v0` and `neurosym/Toy-v0`. So does `import neurosym` after
`import gymnasium`, and Gymnasium itself when asked for `neurosym.worlds.gymnasium_env:neurosym/Toy-v0`; since
1.0 it loads no plug-ins unasked.
"""

from collections.abc import Callable
from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces
from gymnasium.error import ResetNeeded

from neurosym.checks import check_kind
from neurosym.contract import guarded, made
from neurosym.errors import InvalidValue, UnknownChoice
from neurosym.world import Frame, Outcome, Pictured, Reference, Scene, World, is_world, relative_to
from neurosym.worlds.world_file import make_world

Observation = dict[str, Any]
RENDER_MODES = ("rgb_array",)
RESET_OPTIONS = ("reference", "scene", "target")
MOST_STEPS = 50
"""Steps of an episode in the registered environments."""


class WorldEnv(gymnasium.Env[Observation, np.ndarray]):
    """A world to act in.

    An observation is the scene: `features` (M, F), `positions` (M, 3) [m] and `orientations` (M, 4), a
    quaternion (x, y, z, w). An action has the world's own A parameters, relative to the target's centre, in
    metres as in the paper and not normalised; a gripper value is open at 0.5 and above. The reward is how far
    the target was moved at the end of the rise [m]. An episode ends when the target is lost.

    Args:
        world: A world, a function that makes one, or a world's name as in `world.toml`.
        objects: How many objects a scene has.
        render_mode: "rgb_array" or None.

    Raises:
        UnknownChoice: If there is no such world or render mode.
        InvalidValue: If there is to be no object, or the world is none.
    """

    metadata = {"render_modes": list(RENDER_MODES), "render_fps": 4}  # noqa: RUF012  (Gymnasium's own type)

    def __init__(
        self, world: World | Callable[[], World] | str, objects: int = 1, render_mode: str | None = None
    ):
        if render_mode is not None and render_mode not in RENDER_MODES:
            raise UnknownChoice("render mode", render_mode, RENDER_MODES)
        if objects < 1:
            raise InvalidValue(f"objects = {objects} must be at least 1.")
        self.world = _made(world)
        self.objects, self.render_mode = objects, render_mode
        widths = {"features": len(self.world.feature_names), "positions": 3, "orientations": 4}
        shapes = {name: (objects, width) for name, width in widths.items()}
        self.observation_space = spaces.Dict(
            {name: spaces.Box(-np.inf, np.inf, shape, np.float64) for name, shape in shapes.items()}
        )
        box = self.world.action_box
        low, high = (side.astype(np.float64) for side in (box.low, box.high))
        self.action_space = spaces.Box(low, high, dtype=np.float64)
        self._scene: Scene | None = None
        self._target = 0
        self._reference: Reference | None = None

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[Observation, dict[str, Any]]:
        """Begin an episode with a scene drawn from the world, or with one's own.

        Args:
            seed: Where all draws of this environment start from now on, if given.
            options: `target`, the index of the object acted upon (0 if not given), `scene`, a `Scene` to
                begin with, and `reference`, a `Place` or an `OtherObject` that actions are relative to
                besides their target.

        Raises:
            UnknownChoice: If there is no such option.
            InvalidValue: If the scene has another number of objects, the target does not exist, or the
                reference is neither a `Place` nor an `OtherObject`.
        """
        super().reset(seed=seed)
        chosen = {"target": 0, "scene": None, "reference": None, **(options or {})}
        for name in chosen:
            if name not in RESET_OPTIONS:
                raise UnknownChoice("reset option", name, RESET_OPTIONS)
        target, scene, reference = chosen["target"], chosen["scene"], chosen["reference"]
        if scene is None:
            scene = self.world.sample_scene(self.np_random, self.objects)
        if len(scene) != self.objects:
            raise InvalidValue(f"The scene has {len(scene)} objects; this environment takes {self.objects}.")
        if target not in range(self.objects):
            raise InvalidValue(f"target = {target} must be one of the objects 0 to {self.objects - 1}.")
        check_kind("reference", reference, Reference | None, "a Place or an OtherObject")
        self._scene, self._target, self._reference = scene, int(target), reference
        return _observation(scene), {"target": self._target}

    def step(self, action: np.ndarray) -> tuple[Observation, float, bool, bool, dict[str, Any]]:
        """Perform one interaction on the target.

        Args:
            action: Action parameters, relative to the target's centre; see the class.

        Returns:
            The observation, the reward [m], whether the target is lost, False, and what else is known:
            `target`, `effect` and `resting_effect` [m], `kind`, `touched` (bystanders that the robot touched)
            and `peak_height` [m]; with a reference also `carried`, and the effects of
            what was carried are relative to it.
        """
        action = np.asarray(action, dtype=np.float64)
        aim = relative_to(self.world, self._reference)
        outcome = self.world.interact(self._present(), action, self._target, **aim)
        self._scene = outcome.end
        reward = float(np.linalg.norm(outcome.effect))
        return _observation(outcome.end), reward, bool(outcome.lost), False, _info(outcome)

    def render(self) -> Frame | None:
        """Return a picture of the scene as it is; None without a render mode, or if the world draws none."""
        if self.render_mode is None or not isinstance(self.world, Pictured):
            return None
        return self.world.picture(self._present())

    def _present(self) -> Scene:
        if self._scene is None:
            raise ResetNeeded("Call reset before the first step.")
        return self._scene


def _made(world: World | Callable[[], World] | str) -> World:
    if isinstance(world, str):
        return make_world(world, {})
    if is_world(world) and not isinstance(world, type):
        return guarded(world)
    return made(world)  # type: ignore[arg-type]  # no world, so it makes one


def _observation(scene: Scene) -> Observation:
    columns = {"features": scene.features, "positions": scene.positions, "orientations": scene.orientations}
    return {name: np.array(column, dtype=np.float64) for name, column in columns.items()}


def _info(outcome: Outcome) -> dict[str, Any]:
    carried = {} if outcome.reference is None else {"carried": outcome.carried}
    return {
        "target": outcome.target,
        "effect": np.array(outcome.effect, dtype=np.float64),
        "resting_effect": np.array(outcome.resting_effect, dtype=np.float64),
        "kind": outcome.kind,
        "touched": tuple(outcome.touched),
        "disturbed": dict(outcome.disturbed),
        "peak_height": float(outcome.peak_height),
        **carried,
    }


for _name, _world in (("Tabletop", "tabletop"), ("Toy", "toy")):
    gymnasium.register(
        f"neurosym/{_name}-v0",
        entry_point="neurosym.worlds.gymnasium_env:WorldEnv",
        max_episode_steps=MOST_STEPS,
        kwargs={"world": _world},
    )
