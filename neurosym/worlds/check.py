"""Whether an object is a world, as exploration, rehearsal and execution need one, in a few interactions."""

from typing import Any

import numpy as np

from neurosym.contract import attempt, check_attributes, check_drawn, check_outcome
from neurosym.errors import InvalidWorld, NeurosymError
from neurosym.table import Place
from neurosym.world import Outcome, Scene, World, references_of, relative_to
from neurosym.worlds.mirrors import broken_mirror


def check_world(world: World) -> None:
    """Raise unless an object keeps what the protocol `World` promises; for tests of worlds of your own.

    First a world that has a method `try_out` tries itself: the hand of a `Tabletop` lifts a plain box.
    Then samples a scene and performs an interaction, another one, and the first again: a world has no memory.
    If the world takes places as references, the other one has the middle of the table as its reference.
    Then, if the action box has mirrors, performs 20 interactions and their images in each mirror.

    Args:
        world: The world.

    Raises:
        InvalidWorld: If it does not; the message says which requirement is broken.
    """
    check_attributes(world)
    if try_out := getattr(world, "try_out", None):
        attempt(world.name, "try_out", try_out, NeurosymError)
    _check_interactions(world, _checked_scene(world))
    if broken := attempt(world.name, "interact", lambda: broken_mirror(world)):
        raise InvalidWorld(world.name, f"has an action_box with {broken}; leave that mirror out")


def _checked_scene(world: World) -> Scene:
    def sample() -> Any:
        return world.sample_scene(np.random.default_rng(0), 1)

    scenes: list[Scene] = attempt(world.name, "sample_scene", lambda: [sample(), sample()])
    for scene in scenes:
        check_drawn(world, scene, 1)
    scene, again = scenes
    if _bytes_of(scene) != _bytes_of(again):
        raise InvalidWorld(world.name, "samples another scene from a generator in the same state")
    return scene


def _check_interactions(world: World, scene: Scene) -> None:
    """Perform an interaction, then another that ends in mid-air, and then the first again."""
    before = _bytes_of(scene)
    action, other = world.action_box.sample(np.random.default_rng(1), 2)

    def interact() -> Any:
        return world.interact(scene, action, 0)

    place = Place(*(sum(side) / 2 for side in (world.table.x, world.table.y)))
    reference = place if "place" in references_of(world) else None

    def interrupt() -> Any:
        aim = relative_to(world, reference)
        return world.interact(scene, other, 0, put_down=False, on_frame=None, ghosts=None, **aim)

    first, between, second = attempt(world.name, "interact", lambda: (interact(), interrupt(), interact()))
    if _bytes_of(scene) != before:
        raise InvalidWorld(world.name, "changes the scene that interact is given; it must return new ones")
    for outcome, aim in ((first, None), (between, reference), (second, None)):
        check_outcome(world, scene, 0, outcome, reference=aim)
    if _outcome_bytes(first) != _outcome_bytes(second):
        raise InvalidWorld(
            world.name, "has a memory: the same interaction came out differently the second time"
        )


def _bytes_of(scene: Scene) -> bytes:
    return b"".join(np.asarray(a).tobytes() for a in (scene.features, scene.positions, scene.orientations))


def _outcome_bytes(outcome: Outcome) -> tuple[object, ...]:
    scenes = tuple(_bytes_of(scene) for scene in (outcome.start, outcome.lifted, outcome.end))
    numbers = (outcome.held, outcome.toppled, outcome.lost, outcome.peak_height, outcome.touched)
    return (*scenes, *numbers)
