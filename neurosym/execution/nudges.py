"""Nudges: somebody moves an object during a run, and the plan no longer starts from where things are."""

import math
from dataclasses import dataclass

import numpy as np

from neurosym.execution.record import Nudge, Replanning
from neurosym.execution.watching import Moment
from neurosym.operators import vector
from neurosym.problems import Problem
from neurosym.table import Table
from neurosym.world import Scene

LEAST, MOST = 0.03, 0.08
"""How far an object is nudged [m]."""
_STREAM = 0x6E756467  # keeps the randomness of nudges apart from that of everything else
_TRIES = 100


@dataclass(slots=True)
class Nudger:
    """Watches a run, and nudges an object once: when, which and where to follows from a seed.

    Attributes:
        seed: Same seed, same step, object and direction.
        steps: How many interactions the plan has; 0 if there are none, and nothing is nudged then.
        problem: What the objects are called.
        table: Where they may stand.
    """

    seed: int
    steps: int
    problem: Problem
    table: Table
    _is_done: bool = False

    def before_step(self, moment: Moment) -> Nudge | None:
        """Draw what is nudged where to, on the table and touching nothing, if there is room."""
        rng = np.random.default_rng([_STREAM, self.seed])
        if self._is_done or not self.steps or moment.number != int(rng.integers(self.steps)) + 1:
            return None
        self._is_done, scene = True, moment.scene
        for _ in range(_TRIES):
            index = int(rng.integers(len(scene)))
            angle, length = rng.uniform(0, 2 * math.pi), rng.uniform(LEAST, MOST)
            by = np.array([length * math.cos(angle), length * math.sin(angle), 0.0])
            if self.table.contains(scene.positions[index] + by) and _is_free(scene, index, by):
                return Nudge(moment.number, self.problem.object_names[index], vector(by))
        return None

    def replanned(self, replanning: Replanning) -> None:
        """Hear of a new plan."""


def nudged(scene: Scene, nudge: Nudge, problem: Problem) -> Scene:
    """Return a scene of a problem's objects after a nudge."""
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
