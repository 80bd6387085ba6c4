"""A toy world whose objects stand on and in one another, exact enough to follow by hand.

Objects, actions, and what can be grasped are those of the toy world (`toy.py`). These rules are added:

1. **Resting.** An object rests on the highest thing under its footprint: on the floor of a hollow object if
   it fits between the walls, which are 0.01 m thick, on the top of any other object, or else on the table.
2. **Carrying.** What can be grasped is carried over the reference, a place or another object, and let down
   there: waypoint 3 relative to the reference brings it as far from there as it was from waypoint 2. Whatever
   rests on or in it goes along. So it does when an object is pushed.
3. **Sliding off.** An object whose centre is not over what it would rest on slides off along x, and comes to
   stand just beside that.

Nothing topples, and what is lifted without a reference is put back where it was.
"""

import dataclasses
from typing import Any

import numpy as np

from neurosym.checks import Float
from neurosym.tasks.supports import contacts_of
from neurosym.world import Outcome, ReferenceKind, Scene
from neurosym.worlds.toy import ToyWorld

WALL = 0.01
"""How thick walls and floors of hollow objects are [m]."""
_SAME, _BESIDE, _MOST_SLIDES = 1e-6, 0.001, 5


class ToyRelations(ToyWorld):
    """The toy world with relations; see the head of this file for its rules."""

    name = "toy-relations"
    references: tuple[ReferenceKind, ...] = ("place", "object")

    def interact(self, scene: Scene, action: Float[np.ndarray, "A"], target: int, **options: Any) -> Outcome:
        """Perform one action by the rules at the head of this file; see `World.interact`."""
        done = super().interact(scene, action, target, **options)
        if done.end is done.lifted and done.held:  # and is not put down
            return dataclasses.replace(done, contacts=contacts_of(done.end))
        spot = done.end.positions[target][:2]
        is_still = bool(np.array_equal(spot, scene.positions[target][:2]))
        end = scene if is_still else let_down(scene, target, spot)
        loads = () if is_still else loads_on(scene, target)
        return dataclasses.replace(
            done,
            lifted=done.lifted if done.held else end,
            end=end,
            lost=not self.table.contains(end.positions[target]),
            disturbed=tuple((load, "moved") for load in loads),
            contacts=contacts_of(end),
        )


def let_down(scene: Scene, target: int, spot: Float[np.ndarray, "2"]) -> Scene:
    """Return the scene after an object, with what rests on it, was let go with its centre over a spot [m]."""
    moved = {target, *loads_on(scene, target)}
    others = [index for index in range(len(scene)) if index not in moved]
    half = scene.features[target][:3] / 2
    there = np.array(spot, dtype=float)
    height = 0.0
    for _ in range(_MOST_SLIDES):
        tops = {index: _top(scene, index, half, there) for index in others}
        height = max([0.0, *tops.values()])
        under = [index for index in others if height and tops[index] == height]
        away = there - scene.positions[under, :2]
        if np.any(np.all(np.abs(away) <= scene.features[under, :2] / 2 + _SAME, axis=1)) or not under:
            break
        reach = half[0] + scene.features[under[0]][0] / 2 + _BESIDE
        there[0] = scene.positions[under[0]][0] + (reach if away[0, 0] >= 0 else -reach)
    positions = scene.positions.copy()
    positions[sorted(moved)] += np.array([*there, height + half[2]]) - positions[target]
    return dataclasses.replace(scene, positions=positions)


def loads_on(scene: Scene, target: int) -> tuple[int, ...]:
    """Return the indices of what rests on or in an object, also on one another."""
    found, to_look_at = set[int](), [target]
    while to_look_at:
        below = to_look_at.pop()
        above = [
            n for n in range(len(scene)) if n not in (target, below, *found) and _rests_on(scene, n, below)
        ]
        found.update(above)
        to_look_at += above
    return tuple(sorted(found))


def _rests_on(scene: Scene, index: int, below: int) -> bool:
    half, centre = scene.features[index][:3] / 2, scene.positions[index]
    bottom = centre[2] - half[2]
    return bool(bottom > _SAME and abs(_top(scene, below, half, centre[:2]) - bottom) < _SAME)


def _top(scene: Scene, index: int, half: Float[np.ndarray, "3"], spot: Float[np.ndarray, "2"]) -> float:
    """Return how high an object of half such a size rests over a spot on another one; 0 if not on it [m]."""
    size, centre = scene.features[index], scene.positions[index]
    away = np.abs(spot - centre[:2])
    if np.any(away >= half[:2] + size[:2] / 2 - _SAME):
        return 0.0
    fits = size[3] >= 0.5 and np.all(away + half[:2] <= size[:2] / 2 - WALL + _SAME)
    return float(centre[2] - size[2] / 2 + WALL if fits else centre[2] + size[2] / 2)
