"""A grid world with walls, a key and a door: each interaction is one move from anywhere."""

import numpy as np

MAP = (
    "...#..",
    "...D..",
    "k..#..",
    "...#..",
)  # rows by y, cells by x: free, wall, door, and where the key lies
FEATURES = ("x", "y", "key", "open")
MOVES = ("east", "lock", "north", "south", "take", "unlock", "west")
_WAYS = {"west": (-1, 0), "east": (1, 0), "north": (0, -1), "south": (0, 1)}


class Grid:
    """The world: where somebody stands, whether the key is carried, and whether the door is open."""

    def step(self, state: np.ndarray, action: np.ndarray) -> np.ndarray:
        """Return where a move leads."""
        x, y, key, is_open = state.round().astype(int).tolist()
        move = MOVES[int(np.argmax(action))]
        if move in _WAYS:
            across, down = x + _WAYS[move][0], y + _WAYS[move][1]
            if is_free(across, down, bool(is_open)):
                x, y = across, down
        elif move == "take":
            key = max(key, MAP[y][x] == "k")
        elif key and "D" in MAP[y][max(x - 1, 0) : x + 2] and MAP[y][x] != "D":
            is_open = int(move == "unlock")
        return np.array([x, y, key, is_open], dtype=float)

    def reset(self, rng: np.random.Generator) -> np.ndarray:
        """Draw a state that can be."""
        while True:
            x, y, key, is_open = rng.integers([6, 4, 2, 2]).tolist()
            if is_free(x, y, bool(is_open)):
                return np.array([x, y, key, is_open], dtype=float)


def is_free(x: int, y: int, is_open: bool) -> bool:
    """Say whether one can stand there."""
    return 0 <= y < len(MAP) and 0 <= x < len(MAP[0]) and MAP[y][x] in (".k" + "D" * is_open)
