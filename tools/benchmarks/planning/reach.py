"""How many primitives it takes to move an object, by category and direction, if each does as it promises."""

import numpy as np
from scipy.optimize import linprog

from neurosym.cells import at_rest
from neurosym.grounding import Grounding

DIRECTIONS = ("forward", "forward left", "left", "back left", "back", "back right", "right", "forward right")
"""Counted from +x towards +y, 45 degrees apart."""
FAR = 0.15
"""How far an object is moved [m]."""


def primitives_needed(grounding: Grounding) -> dict[str, dict[str, float]]:
    """Count how many primitives move an object 15 cm at rest, if each does what it does on average.

    Fractions of primitives count, and the way may leave the table; so it is the least there can be.

    Args:
        grounding: The learned domain.

    Returns:
        By category and direction; infinite where no primitives lead.
    """
    return {
        category.symbol: {
            name: _needed(moves, FAR * np.array([np.cos(angle), np.sin(angle)]))
            for name, angle in zip(DIRECTIONS, np.arange(8) * np.pi / 4, strict=True)
        }
        for category in grounding.operators.categories
        if len(moves := _moves(grounding, category.symbol))
    }


def _moves(grounding: Grounding, category: str) -> np.ndarray:
    """List the displacements at rest that live operators promise, (K, 2) [m]."""
    live = (operator for operator in grounding.live if operator.category == category)
    return np.array([at_rest(operator.promise)[:2] for operator in live if operator.promise])


def _needed(moves: np.ndarray, way: np.ndarray) -> float:
    found = linprog(np.ones(len(moves)), A_eq=moves.T, b_eq=way)
    return float(found.fun) if found.status == 0 else np.inf
