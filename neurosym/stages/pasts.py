"""Pasts of objects: `pasts/NAME.json` holds what the object of that name was seen to do.

`meet` begins one, by trying things with the object; runs with it add to it, and whatever plans reads it.
"""

from collections.abc import Mapping, Sequence

import msgspec
import numpy as np

from neurosym.errors import InvalidFile
from neurosym.execution.meeting import Tried, alone, try_once
from neurosym.files import make_folder, remove, write_json
from neurosym.grounding import Grounding
from neurosym.operators import LegalName, Length, Versioned
from neurosym.problems import Problem, SceneObject, Trial, check_on_table
from neurosym.stages import layout
from neurosym.stages.folder import DomainFolder
from neurosym.world import World

MOST_TRIALS = 64
"""So many outcomes of an object are kept, the last ones."""
_FORMAT = "neurosym-past-1"
_SAME = 1e-6  # sizes of one object differ by less [m]


class Past(Versioned, frozen=True):
    """What the object of a name was seen to do."""

    name: LegalName
    features: tuple[Length, ...]  # what it is; see `Scene`
    trials: tuple[Trial, ...] = ()  # what came of what was done to it, the last at the end
    format: str = _FORMAT
    readable = (_FORMAT,)

    def is_of(self, item: SceneObject) -> bool:
        """Say whether it is that of an object of this name, and not of another one that was called so."""
        return len(self.features) == len(item.features) and np.allclose(
            self.features, item.features, atol=_SAME
        )


def past_files(folder: DomainFolder) -> tuple[str, ...]:
    """Name the pasts that a folder holds."""
    return tuple(f"{layout.PASTS}/{path.name}" for path in sorted((folder / layout.PASTS).glob("*.json")))


def load_past(folder: DomainFolder, item: SceneObject) -> Past | None:
    """Read what an object was seen to do; None if it was never met, or another one of that name was."""
    path = folder / layout.past_file(item.name)
    past = Past.load(path) if path.is_file() else None
    return past if past and past.is_of(item) else None


def with_past(folder: DomainFolder, problem: Problem) -> Problem:
    """Return a problem whose objects have the pasts that a folder holds of them."""
    pasts = {item.name: load_past(folder, item) for item in problem.objects}
    objects = (
        msgspec.structs.replace(item, past=past.trials) if (past := pasts[item.name]) else item
        for item in problem.objects
    )
    return msgspec.structs.replace(problem, objects=tuple(objects)) if any(pasts.values()) else problem


def remember(folder: DomainFolder, problem: Problem, run: str, seen: Mapping[str, Sequence[Trial]]) -> None:
    """Add what objects did in a run to their pasts, in place of what was known of an earlier run so called.

    Only objects that were met have a past.
    """
    for name, trials in seen.items():
        if past := load_past(folder, problem.object_named(name)):
            others = (one for one in past.trials if one.run != run)
            new = (msgspec.structs.replace(one, run=run) for one in trials)
            _save(folder, past, (*others, *new))


def forget_pasts(folder: DomainFolder, names: Sequence[str]) -> list[str]:
    """Remove the pasts of objects, and return the names of those that had one."""
    found = [name for name in names if (folder / layout.past_file(name)).exists()]
    for name in found:
        remove(folder / layout.past_file(name))
    return found


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
            self.past = _save(self._folder, self.past, (*self.past.trials, found.trial))
        return found


def _save(folder: DomainFolder, past: Past, trials: Sequence[Trial]) -> Past:
    make_folder(folder / layout.PASTS)
    kept = msgspec.structs.replace(past, trials=tuple(trials)[-MOST_TRIALS:])
    write_json(folder / layout.past_file(past.name), kept)
    return kept
