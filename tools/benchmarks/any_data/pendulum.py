"""Gymnasium's pendulum: each interaction is a torque that is held for some steps of the environment."""

import math

import gymnasium
import numpy as np

FEATURES = ("angle", "speed")
MOVES = ("left", "none", "right")
TURN = 2 * math.pi
_TORQUE = 2.0  # as much as there is [N m]


class Pendulum:
    """The world: the angle, 0 where it stands upright [rad], and its speed [rad/s].

    Args:
        hold: For how many steps of 0.05 s a torque is held.
    """

    def __init__(self, hold: int = 4):
        self._hold = hold
        self._env = gymnasium.make("Pendulum-v1").unwrapped
        self._env.reset(seed=0)

    def step(self, state: np.ndarray, action: np.ndarray) -> np.ndarray:
        """Hold a torque."""
        self._env.state = np.array(state, dtype=float)
        for _ in range(self._hold):
            self._env.step(np.array([_TORQUE * (np.argmax(action) - 1.0)], dtype=np.float32))
        angle, speed = self._env.state
        return np.array([angle % TURN, speed])

    def reset(self, rng: np.random.Generator) -> np.ndarray:
        """Draw any state."""
        return np.array([rng.uniform(0, TURN), rng.uniform(-8, 8)])
