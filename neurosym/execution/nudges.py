"""Nudges: somebody moves an object during a run, and the plan no longer starts from where things are."""

import math
from dataclasses import dataclass

import numpy as np

from neurosym.execution.record import Nudge
from neurosym.operators import vector
from neurosym.problems import Problem
from neurosym.table import Table
from neurosym.world import Scene

LEAST, MOST = 0.03, 0.08
"""How far an object is nudged [m]."""
_STREAM = 0x6E756467  # keeps the randomness of nudges apart from that of everything else
_TRIES = 100


@dataclass(frozen=True, slots=True)
class Nudger:
    """Decides when and where to an object is nudged, from a seed and the number of steps of the plan.

    Attributes:
        seed: Same seed, same step, object and direction.
        steps: How many interactions the plan has.
    """

    seed: int
    steps: int

    @property
    def before_step(self) -> int:
        """Number of the step that the nudge comes before, counted from 1; 0 for a plan without steps."""
        return int(self._rng().integers(self.steps)) + 1 if self.steps else 0

    def nudge(self, problem: Problem, scene: Scene, table: Table) -> Nudge | None:
        """Draw what is nudged where to, such that it stays on the table and touches nothing.

        Args:
            problem: What the objects are called.
            scene: Where they are, all at rest.
            table: Where they may stand.

        Returns:
            The nudge; None if there is no room for any.
        """
        rng = self._rng()
        rng.integers(self.steps)
        for _ in range(_TRIES):
            index = int(rng.integers(len(scene)))
            angle, length = rng.uniform(0, 2 * math.pi), rng.uniform(LEAST, MOST)
            by = np.array([length * math.cos(angle), length * math.sin(angle), 0.0])
            if table.contains(scene.positions[index] + by) and _is_free(scene, index, by):
                return Nudge(self.before_step, problem.object_names[index], vector(by))
        return None

    def _rng(self) -> np.random.Generator:
        return np.random.default_rng([_STREAM, self.seed])


def nudged(scene: Scene, nudge: Nudge, problem: Problem) -> Scene:
    """Return the scene after a nudge.

    Args:
        scene: The scene.
        nudge: Which object is moved, and how far.
        problem: What the objects are called.
    """
    positions = scene.positions.copy()
    positions[problem.object_names.index(nudge.object)] += nudge.by
    return Scene(scene.features, positions, scene.orientations)


def _is_free(scene: Scene, index: int, by: np.ndarray) -> bool:
    """Say whether an object can be moved so, seen as the circles around footprints of any orientation."""
    radii = np.hypot(scene.features[:, 0], scene.features[:, 1]) / 2
    apart = np.linalg.norm(scene.positions[:, :2] - (scene.positions[index] + by)[:2], axis=1)
    near = apart < radii + radii[index]
    near[index] = False
    return not near.any()
