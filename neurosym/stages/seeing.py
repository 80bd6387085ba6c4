"""The stage that teaches an eye: random actions, and what their targets looked like before."""

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from neurosym.checks import check_count
from neurosym.choices import ACTED, LOOKED
from neurosym.data.foreign_tables import read_images, read_interactions
from neurosym.data.interactions import Interactions
from neurosym.data.origin import too_few
from neurosym.errors import InvalidFile, InvalidValue
from neurosym.files import digests
from neurosym.perception.eye import as_crops
from neurosym.primitives.ledger import Ledger
from neurosym.stages import layout
from neurosym.stages.console import progress_bar
from neurosym.stages.folder import Claim, DomainFolder, Stage, versions
from neurosym.world import Outcome, Scene
from neurosym.worlds.workers import Task, check_workers
from neurosym.worlds.world_file import origin_of, read_world

if TYPE_CHECKING:
    from neurosym.perception.eye import Eye
    from neurosym.perception.seen_world import Shown

_DRAWS = 50  # of a scene with one object, until the camera sees just that
_ENOUGH = 100  # objects that are looked at before it is asked whether they differ
_HIGHEST = 0.1  # images of a user's own are scaled to so much, as crops are high [m]
_STREAM = 0x736565  # keeps their draws apart from others


def seen_in(
    path: Path, columns: Path | None, note: Callable[[str], None]
) -> tuple[Interactions, "Eye | None"]:
    """Read a table of a user's own; of one with images, with what an eye tells of these, and that eye.

    The eye is taught on the table itself.

    Raises:
        InvalidFile: If the table cannot be read.
        InvalidData: If what it holds cannot be learned from.
    """
    if (images := read_images(path)) is None:
        return read_interactions(path, columns, note), None
    from neurosym.learning.eye_lesson import teach

    data = read_interactions(path, columns, lambda _: None, told=np.zeros((len(images), 1)))
    if problem := too_few(len(data)):
        raise InvalidFile(path, problem)
    crops = as_crops(images)
    crops *= _HIGHEST / (np.abs(crops).max() or 1.0)
    with progress_bar("learning to see") as advance:
        eye = teach(
            crops,
            data,
            crops[:0],
            seed=0,
            progress=lambda stage, share: advance(round(100 * share), 100, stage),
        )
    told = np.array([eye.tell(crop) for crop in crops])
    return read_interactions(path, columns, note, told=told), eye


def seen_ledger(folder: DomainFolder, workers: int = 1) -> Ledger:
    """Open what was performed for the eye of a folder to learn from; see `Ledger`."""
    blind = {**origin_of(read_world(folder.require(layout.WORLD))), "eye": None, "versions": versions()}
    return Ledger(folder / layout.SEEN_LEDGER, blind, workers)


def see_stage(
    folder: DomainFolder, *, acted: int = ACTED, looked: int = LOOKED, seed: int, workers: int
) -> Stage:
    """Teach the eye of a world that sees: `world.toml` -> `eye.safetensors` and `seen.npz`.

    The second holds what it learned from, as it sees it; other networks learn from that, too.

    Args:
        folder: The domain folder.
        acted: How many random actions it learns from.
        looked: How many objects it looks at besides.
        seed: Where all draws start.
        workers: How many processes act; their number changes nothing.
    """
    check_count("interactions", acted, 20)
    check_count("looks", looked, 0)
    check_workers(workers)

    def work() -> None:
        from neurosym.exploration.loop import origin_of_world
        from neurosym.learning.eye_lesson import teach
        from neurosym.perception.seen_world import SeenWorld

        path = folder.require(layout.WORLD)
        factory = read_world(path)
        world = factory()
        if not isinstance(world, SeenWorld):
            raise InvalidValue(
                f"{path} names a world that sees nothing; `neurosym init DIR --world camera` makes one that "
                "does, and so does a world of your own with a method images."
            )
        looks = list[tuple[Scene, "Shown"]]()
        with progress_bar("looking at objects") as advance:
            for number in range(acted + looked):
                looks.append(_drawn(world, seed, number))
                advance(number + 1, acted + looked)
                if number + 1 == min(_ENOUGH, acted) and not _differ(looks):
                    raise InvalidValue(
                        f"{number + 1} objects all look the same in the images of the world that {path} "
                        "names, so that nothing can be learned from them."
                    )
        drawn = (np.random.default_rng([seed, _STREAM, number, 1]) for number in range(acted))
        actions = np.array([world.action_box.sample(rng, 1)[0] for rng in drawn]).astype(np.float32)
        tasks = [Task(scene, action) for (scene, _), action in zip(looks, actions, strict=False)]
        ledger = seen_ledger(folder, workers)
        with progress_bar("acting to learn to see") as advance:
            outcomes = ledger.perform(world.blind, tasks, "seen", advance)
        done = Interactions.from_outcomes(outcomes, actions, origin_of_world(world.table_world))
        shown = np.array([found.crop for _, found in looks]).astype(np.float32)
        with progress_bar("learning to see") as advance:
            eye = teach(
                shown[:acted],
                done,
                shown[acted:],
                seed=seed,
                progress=lambda stage, share: advance(round(100 * share), 100, stage),
            )
        eye.save(folder / layout.EYE)
        world.eye = eye
        seen = list[Outcome]()
        with progress_bar("looking at what came of it") as advance:
            for number, ((scene, found), outcome) in enumerate(zip(looks, outcomes, strict=False), 1):
                begun = world.told(scene, [found])
                assert begun is not None, "one object is told apart from none"
                seen.append(world.witnessed(begun, outcome))
                advance(number, acted)
        known = origin_of_world(world) | origin_of(factory)
        known["eye"] = digests({"eye": folder / layout.EYE})["eye"]  # and not of the one before
        Interactions.from_outcomes(seen, actions, known).save(folder / layout.SEEN)

    options = {"interactions": acted, "looks": looked, "seed": seed}
    return Stage("see", (layout.WORLD,), (layout.EYE, layout.SEEN), work, options, Claim.ALONE)


def _differ(looks: Sequence[tuple[Scene, "Shown"]]) -> bool:
    """Say whether objects look different, so that there is something to learn to see."""
    return any(not np.array_equal(found.crop, looks[0][1].crop) for _, found in looks)


def _drawn(world: Any, seed: int, number: int) -> tuple[Scene, "Shown"]:
    """Draw an object, and look at it; one that is not seen as one object is drawn again."""
    rng = np.random.default_rng([seed, _STREAM, number])
    for _ in range(_DRAWS):
        scene = world.table_world.sample_scene(rng, 1)
        if len(found := world.look(scene)) == 1:
            return scene, found[0]
    raise InvalidValue(
        f"The camera does not tell a single object in {_DRAWS} scenes; see [options.camera] in world.toml."
    )
