"""Meeting the objects of a scene: what they do when they are tried is kept in their pasts."""

import msgspec

from neurosym.errors import InvalidFile
from neurosym.execution.tries import Tried, alone, try_once
from neurosym.grounding import Grounding
from neurosym.problems import Problem, check_on_table
from neurosym.stages import layout
from neurosym.stages.folder import DomainFolder
from neurosym.stages.past_files import Past
from neurosym.world import World


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
