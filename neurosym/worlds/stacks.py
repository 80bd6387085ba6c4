"""Scenes in which objects bear one another, made in the world by the actions that do that."""

from collections.abc import Sequence

import msgspec
import numpy as np

from neurosym.arrays import Float
from neurosym.errors import InvalidValue
from neurosym.operators import vector
from neurosym.problems import Problem, SceneObject
from neurosym.symbols import Categorise, symbols_of
from neurosym.table import OtherObject
from neurosym.world import Scene, World, relative_to
from neurosym.worlds.problem_drawing import item_names
from neurosym.worlds.tasks import draw_places

Deed = tuple[tuple[str, str], Float[np.ndarray, "A"]]
"""Names of a target and of its reference, and the action."""


def stacked(problem: Problem, world: World, deeds: Sequence[Deed]) -> Problem | None:
    """Return a problem as it is after some actions, one after another; None if one of them fails.

    Args:
        problem: The problem.
        world: The world to act in.
        deeds: What is done.
    """
    scene, names = problem.scene(), problem.object_names
    contacts = tuple[tuple[int, int], ...]()
    for (target, other), action in deeds:
        aim = relative_to(world, OtherObject(names.index(other)))
        try:
            outcome = world.interact(scene, action, names.index(target), **aim)
        except InvalidValue:  # out of the arm's reach
            return None
        if outcome.kind != "carried" or outcome.disturbed:
            return None
        scene, contacts = outcome.end, outcome.contacts
    touching = tuple((names[one], names[other]) for one, other in contacts)
    return msgspec.structs.replace(problem, objects=standing(problem.objects, scene), touching=touching)


def scattered(like: Problem, world: World, rng: np.random.Generator) -> Scene | None:
    """Set the objects of another scene apart on the table; None if they find no places.

    Args:
        like: The other scene.
        world: The world, which has a table.
        rng: Source of randomness.
    """
    before = like.scene()
    spots = draw_places(rng, before.features[:, :2], world.table)
    if spots is None:
        return None
    upright = np.tile([0.0, 0.0, 0.0, 1.0], (len(before), 1))
    return Scene(before.features, np.column_stack([spots, before.features[:, 2] / 2]), upright)


def standing(items: Sequence[SceneObject], scene: Scene) -> tuple[SceneObject, ...]:
    """Return objects as they stand in a scene.

    Args:
        items: The objects.
        scene: The scene, in the same order.
    """
    rows = zip(items, scene.positions, scene.orientations, strict=True)
    return tuple(
        msgspec.structs.replace(item, position=vector(position), orientation=tuple(orientation.tolist()))
        for item, position, orientation in rows
    )


def upright_items(scene: Scene, categorise: Categorise) -> tuple[SceneObject, ...]:
    """Return the objects of a scene, called `item-01` and so on; where they stand is not said.

    Args:
        scene: The scene.
        categorise: Gives objects their symbols.
    """
    rows = zip(
        item_names(len(scene)), symbols_of(categorise, scene.features), scene.features.tolist(), strict=True
    )
    return tuple(
        SceneObject(name, symbol, tuple(features), (0.0, 0.0, 0.0)) for name, symbol, features in rows
    )
