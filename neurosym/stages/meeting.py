"""Meeting the objects of a scene: what they do when they are tried is kept in their pasts."""

from collections.abc import Iterator

import msgspec
import numpy as np

from neurosym.errors import InvalidFile, counted
from neurosym.execution.tries import Tried, alone, said_of, try_once
from neurosym.grounding import Grounding
from neurosym.operators import symbols_of
from neurosym.problems import Problem, SceneObject, check_on_table
from neurosym.stages import layout
from neurosym.stages.folder import DomainFolder
from neurosym.stages.past_files import Past
from neurosym.world import World


def met_in_words(folder: DomainFolder, grounding: Grounding) -> Iterator[str]:
    """Say of each object that was met, by name, what it looks like and how it is best handled."""
    paths = sorted((folder / layout.PASTS).glob("*.json"))
    pasts = [Past.load(path) for path in paths]
    if not pasts or not (folder / layout.MODEL).is_file():
        return
    symbols = symbols_of(folder.network().object_symbols, np.array([past.features for past in pasts]))
    for past, symbol in zip(pasts, symbols, strict=True):
        standing = (0.0, 0.0, past.features[2] / 2)
        item = SceneObject(past.name, symbol, past.features, standing, past=past.trials)
        yield f"{said_of(item, grounding)} (tried {counted(len(past.trials), 'time')})"


class Meeting:
    """The tries of one object of a scene, kept as they come.

    Args:
        folder: The domain folder.
        problem: The scene.
        name: Name of the object.
        world: What the object is tried in.
        grounding: What can be tried.

    Raises:
        InvalidFile: If there is a past of that name which belongs to another object.
        InvalidValue: If the object stands off the table.
    """

    def __init__(self, folder: DomainFolder, problem: Problem, name: str, world: World, grounding: Grounding):
        self._folder, self._world, self._grounding = folder, world, grounding
        self._scene = alone(problem, name)
        (item,) = self._scene.objects
        check_on_table(item, grounding.table)
        path = folder / layout.past_file(name)
        self.past = Past.load(path) if path.is_file() else Past(name, item.features)
        if not self.past.is_of(item):
            sizes = ", ".join(f"{one:g}" for one in self.past.features)
            raise InvalidFile(
                path,
                f"it is the past of another object, whose features are {sizes}; give {name} another name, or "
                "forget that one with --forget",
            )

    @property
    def tries(self) -> int:
        """How many tries there were."""
        return sum(not one.run for one in self.past.trials)

    def try_next(self) -> Tried | None:
        """Try what tells most, and keep what came of it; None if nothing can be tried.

        Raises:
            InvalidValue: If the object is out of the arm's reach.
        """
        (item,) = self._scene.objects
        known = (msgspec.structs.replace(item, past=self.past.trials),)
        scene = msgspec.structs.replace(self._scene, objects=known)
        if found := try_once(self._world, scene, self._grounding):
            self.past = self.past.grown(self._folder, (*self.past.trials, found.trial))
        return found
