"""Pasts of objects: `pasts/NAME.json` holds what the object of that name was seen to do.

`meet` begins one, by trying things with the object; runs with it add to it, and whatever plans reads it.
"""

from collections.abc import Mapping, Sequence

import msgspec
import numpy as np

from neurosym.errors import InvalidFile
from neurosym.files import locked, make_folder, remove, write_json
from neurosym.operators import LegalName, Length, Versioned
from neurosym.problems import Problem, SceneObject, Trial
from neurosym.stages import layout
from neurosym.stages.folder import DomainFolder

MOST_TRIALS = 64
"""So many outcomes of an object are kept."""
_FORMAT = "neurosym-past-1"
_SAME = 1e-6  # sizes of one object differ by less [m]


class Past(Versioned, frozen=True):
    """What the object of a name was seen to do."""

    name: LegalName
    features: tuple[Length, ...]  # what it is; see `Scene`
    trials: tuple[Trial, ...] = ()  # what came of what was done to it, the last at the end
    format: str = _FORMAT
    readable = (_FORMAT,)

    def grown(self, folder: DomainFolder, trials: Sequence[Trial], run: str = "") -> "Past":
        """Return it as it is on disk by now, with more trials, and write that.

        Those of a run take the place of what was known of an earlier one so called. Only the last are kept;
        what was seen in runs goes before what was tried.
        """
        make_folder(folder / layout.PASTS)
        path = folder / layout.past_file(self.name)
        with locked(folder / layout.PASTS):
            known = Past.load(path).trials if path.is_file() else ()
            every = [*(one for one in known if not run or one.run != run), *trials]
            for one in [*(one for one in every if one.run), *every][: max(0, len(every) - MOST_TRIALS)]:
                every.remove(one)
            kept = msgspec.structs.replace(self, trials=tuple(every))
            write_json(path, kept)
        return kept

    def is_of(self, item: SceneObject) -> bool:
        """Say whether it is that of an object of this name, and not of another one that was called so."""
        return len(self.features) == len(item.features) and np.allclose(
            self.features, item.features, atol=_SAME
        )


def load_past(folder: DomainFolder, item: SceneObject) -> Past | None:
    """Read what an object was seen to do; None if it was never met, or another one of that name was."""
    path = folder / layout.past_file(item.name)
    past = Past.load(path) if path.is_file() else None
    if past and past.name != item.name:
        raise InvalidFile(path, f"it is the past of {past.name}; valid: {item.name}, as the file is called")
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
            past.grown(folder, [msgspec.structs.replace(one, run=run) for one in trials], run)


def forget_pasts(folder: DomainFolder, names: Sequence[str]) -> list[str]:
    """Remove the pasts of objects, and return the names of those that had one."""
    found = [name for name in names if (folder / layout.past_file(name)).exists()]
    for name in found:
        remove(folder / layout.past_file(name))
    return found
