"""A room with a window and a thermostat: each interaction is a quarter of an hour, or a hand on something."""

import numpy as np

FEATURES = ("temperature", "window", "mode")
MOVES = ("cool", "heat", "off", "wait", "window")
MODES = ("off", "heat", "cool")
OUTSIDE = 8.0
_POWER = (0.0, 1.5, -1.5)  # of each mode [degrees in a quarter of an hour]


class Room:
    """The world; what it draws is noise of a tenth of a degree."""

    def __init__(self, seed: int = 0):
        self._rng = np.random.default_rng(seed)

    def step(self, state: np.ndarray, action: np.ndarray) -> np.ndarray:
        """Return what becomes of the room."""
        (warm, window, mode), move = state, MOVES[int(np.argmax(action))]
        if move == "wait":
            leak = 0.12 if window >= 0.5 else 0.02
            warm += _POWER[round(mode)] + leak * (OUTSIDE - warm) + self._rng.normal(0, 0.1)
        elif move == "window":
            window = 1 - window
        else:
            mode = MODES.index(move)
        return np.array([warm, window, mode])

    def reset(self, rng: np.random.Generator) -> np.ndarray:
        """Draw a room."""
        return np.array([rng.uniform(5, 30), rng.integers(2), rng.integers(3)], dtype=float)
