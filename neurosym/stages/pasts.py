"""Pasts of objects: `pasts/NAME.json` holds what the object of that name was seen to do.

`meet` begins one, by trying things with the object; runs with it add to it, and whatever plans reads it.
"""

from collections.abc import Mapping, Sequence

import msgspec
import numpy as np

from neurosym.errors import InvalidFile, InvalidValue
from neurosym.execution.performance import perform
from neurosym.files import make_folder, remove, write_json
from neurosym.grounding import Grounding
from neurosym.operators import LegalName, Length, Versioned
from neurosym.problems import Problem, SceneObject, Trial, check_on_table
from neurosym.stages import layout
from neurosym.stages.folder import DomainFolder
from neurosym.tasks.pasts import keeps, trial_of
from neurosym.tasks.transition import PlanStep
from neurosym.tasks.tries import next_try
from neurosym.world import Table, World

MOST_TRIALS = 64
"""So many outcomes of an object are kept, the last ones."""
_FORMAT = "neurosym-past-1"
_STREAM = 0x6D656574  # keeps the randomness of tries apart from any other
_NEAR = 0.1  # nothing is carried to a place that is nearer to where it stands [m]
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
    """The tries of one object, each from where it stands in a scene, with the other objects taken aside.

    Args:
        folder: The domain folder.
        problem: The scene.
        name: Name of the object.

    Raises:
        InvalidFile: If there is a past of that name which belongs to another object.
        InvalidValue: If the object stands off the table.
    """

    def __init__(self, folder: DomainFolder, problem: Problem, name: str, world: World, grounding: Grounding):
        self._folder, self._world, self._grounding = folder, world, grounding
        item = problem.object_named(name)
        check_on_table(item, grounding.table)
        path = folder / layout.past_file(name)
        past = Past.load(path) if path.is_file() else Past(name, item.features)
        if not past.is_of(item):
            sizes = ", ".join(f"{one:g}" for one in past.features)
            raise InvalidFile(
                path,
                f"it is the past of another object, whose features are {sizes}; give {name} another name, or "
                "forget that one with --forget",
            )
        self._past = past
        self._scene = msgspec.structs.replace(problem, objects=(item,), goals={}, relations=(), conditions=())

    @property
    def item(self) -> SceneObject:
        """The object, with its past."""
        return msgspec.structs.replace(self._scene.objects[0], past=self._past.trials)

    @property
    def tries(self) -> int:
        """How many tries there were."""
        return sum(not one.run for one in self._past.trials)

    def try_next(self) -> tuple[str, Trial, bool] | None:
        """Try what tells most, and keep what came of it.

        Returned are the operator's name, what came of it, and whether that was as promised; None if nothing
        can be tried.

        Raises:
            InvalidValue: If the object is out of the arm's reach.
        """
        chosen = next_try(self.item, self._grounding)
        if chosen is None:
            return None
        operator, promise = chosen
        step, aim = PlanStep(operator.name, self.item.name), None
        if operator.frame == "place":
            x, y = self._place()
            aim = self._grounding.table.nearest(x - promise.resting_effect[0], y - promise.resting_effect[1])
        scene = self._scene.scene()
        outcome = perform(self._world, self._scene, self._grounding, step, scene, True, reference=aim)
        if outcome is None:
            raise InvalidValue(f"{self.item.name} is out of the arm's reach; move it nearer to the middle.")
        trial = trial_of(outcome, operator, self._grounding)
        self._past = _save(self._folder, self._past, (*self._past.trials, trial))
        return operator.name, trial, keeps(promise, trial)

    def _place(self) -> tuple[float, float]:
        """Draw where to carry the object, away from where it stands."""
        rng = np.random.default_rng([_STREAM, self.tries, *self.item.name.encode()])
        return _drawn(rng, self.item, self._grounding.table)


def _drawn(rng: np.random.Generator, item: SceneObject, table: Table) -> tuple[float, float]:
    (low_x, high_x), (low_y, high_y) = table.x, table.y
    half_x, half_y = (size / 2 for size in item.features[:2])
    while True:
        x, y = rng.uniform(low_x + half_x, high_x - half_x), rng.uniform(low_y + half_y, high_y - half_y)
        if np.hypot(x - item.position[0], y - item.position[1]) >= _NEAR:
            return float(x), float(y)


def _save(folder: DomainFolder, past: Past, trials: Sequence[Trial]) -> Past:
    make_folder(folder / layout.PASTS)
    kept = msgspec.structs.replace(past, trials=tuple(trials)[-MOST_TRIALS:])
    write_json(folder / layout.past_file(past.name), kept)
    return kept
