"""panda-gym's pushing environment: each interaction is one push, from one side of the cube, so or so far."""

import numpy as np
from panda_gym.envs.panda_tasks import PandaPushEnv

FEATURES = ("x", "y")
SIDES = {"left": (0.0, 1.0), "right": (0.0, -1.0), "front": (1.0, 0.0), "back": (-1.0, 0.0)}
REACH = {"short": 0.03, "long": 0.09}  # how far the cube is pushed, about [m]
MOVES = tuple(sorted(f"{side}-{far}" for side in SIDES for far in REACH))
_BESIDE, _HEIGHT, _WIDE = 0.07, 0.02, 0.15  # the gripper before a push; where cubes are, from the middle [m]
_PACE, _STEPS = 0.12, 32  # of the gripper: so slowly that the cube does not slide on


class Pushing:
    """The world: where the cube lies on the table [m]. It lies square to the table before each push."""

    def __init__(self) -> None:
        self._env = PandaPushEnv(render_mode="rgb_array", renderer="Tiny")
        self._env.reset(seed=0)
        self._down = np.array([1.0, 0.0, 0.0, 0.0])

    def step(self, state: np.ndarray, action: np.ndarray) -> np.ndarray:
        """Bring the gripper beside the cube, and push."""
        env, (side, far) = self._env, MOVES[int(np.argmax(action))].split("-")
        cube, way = np.array([*state, _HEIGHT]), np.array([*SIDES[side], 0.0])
        env.robot.reset()
        self._put(cube - _BESIDE * way)
        env.sim.set_base_pose("object", cube, np.array([0.0, 0.0, 0.0, 1.0]))
        end = cube + (REACH[far] - 0.03) * way
        for _ in range(_STEPS):
            here = np.array(env.robot.get_ee_position())
            env.step(np.clip((end - here) / 0.05, -_PACE, _PACE))
        return np.array(env.sim.get_base_position("object")[:2])

    def _put(self, place: np.ndarray) -> None:
        """Put the gripper somewhere, closed."""
        robot = self._env.robot
        for _ in range(3):
            arm = robot.inverse_kinematics(link=robot.ee_link, position=place, orientation=self._down)[:7]
            robot.set_joint_angles(np.array([*arm, 0.0, 0.0]))

    def reset(self, rng: np.random.Generator) -> np.ndarray:
        """Draw where the cube lies."""
        return rng.uniform(-_WIDE, _WIDE, 2)
