"""Meeting the objects of a scene: what they do when they are tried is kept in their pasts."""

from collections.abc import Collection, Iterator

import msgspec
import numpy as np

from neurosym.errors import InvalidFile, counted
from neurosym.execution.tries import Tried, alone, said_of, try_once
from neurosym.grounding import Grounding
from neurosym.operators import symbols_of
from neurosym.problems import Problem, SceneObject, check_on_table
from neurosym.stages import layout
from neurosym.stages.folder import DomainFolder
from neurosym.stages.past_files import Past, load_past
from neurosym.tasks.lying import as_it_shows
from neurosym.world import World


def met_in_words(folder: DomainFolder, grounding: Grounding, names: Collection[str] = ()) -> Iterator[str]:
    """Say of objects that were met, all if none are named, what they look like and how they are best handled.

    They are taken as they lay at last. Nothing is said of such that the domain does not know the like of.
    """
    paths = sorted((folder / layout.PASTS).glob("*.json"))
    pasts = [Past.load(path) for path in paths if not names or path.stem in names]
    known = {len(row) for category in grounding.objects.categories for row in category.objects}
    pasts = [past for past in pasts if len(past.features) in known]
    if not pasts or not (folder / layout.MODEL).is_file():
        return
    symbols = symbols_of(folder.network().object_symbols, np.array([past.features for past in pasts]))
    categories = {category.symbol for category in grounding.objects.categories}
    for past, symbol in zip(pasts, symbols, strict=True):
        if symbol not in categories:
            continue
        standing = (0.0, 0.0, past.features[2] / 2)
        item = SceneObject(past.name, symbol, past.features, standing, past=past.trials)
        if past.trials:
            item = msgspec.structs.replace(item, orientation=past.trials[-1].lay)
        motions = counted(len(past.trials), "motion")
        yield f"{said_of(as_it_shows(item, grounding), grounding)} ({motions} with it so far)"


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
        path, past = folder / layout.past_file(name), load_past(folder, item)
        if past is None and path.is_file():
            sizes = ", ".join(f"{one:g}" for one in Past.load(path).features)
            raise InvalidFile(
                path,
                f"it is the past of another object, whose features are {sizes}; give {name} another name, or "
                "forget that one with --forget",
            )
        self.past = past or Past(name, item.features)

    @property
    def tries(self) -> int:
        """How many tries there were."""
        return sum(not one.run for one in self.past.trials)

    def try_next(self) -> Tried | None:
        """Try the next motion, see `try_once`, and keep what came of it; None if nothing can be tried.

        Raises:
            InvalidValue: If the object is out of the arm's reach.
        """
        (item,) = self._scene.objects
        known = (msgspec.structs.replace(item, past=self.past.trials),)
        scene = msgspec.structs.replace(self._scene, objects=known)
        if found := try_once(self._world, scene, self._grounding):
            self.past = self.past.grown(self._folder, [found.trial])
        return found
