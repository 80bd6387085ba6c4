"""What was performed, kept such that nothing is performed twice.

A world has no memory, so the same action in the same scene ends alike. Whatever is to be performed is looked
up here first. So work that was interrupted goes on where it was, and whoever asks for more waits for what is
new only.
"""

import json
import pickle
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from hashlib import blake2b
from itertools import islice, takewhile
from pathlib import Path
from typing import Any, get_args

import numpy as np

from neurosym.contract import placed
from neurosym.data.archives import read_tensors, write_tensors
from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidFile, Progress
from neurosym.files import at_once
from neurosym.world import Disturbance, OtherObject, Outcome, Place, Scene, WorldFactory
from neurosym.worlds.workers import Task, perform_all

FORMAT = "neurosym-ledger-1"
BLOCK = 256
"""Outcomes between two writes of the file: as many are lost at most."""
_DISTURBED = ("", *get_args(Disturbance))
_KEY = 16  # bytes that an interaction is known by
_PLACES = 64  # objects that a scene may have, since contacts are kept as bits


@dataclass(slots=True, eq=False)
class Ledger:
    """Outcomes of what was performed in one world.

    Raises:
        InvalidFile: If the file is damaged.
    """

    path: Path | None = None  # the file; None keeps them in memory
    # what identifies the world, in plain JSON values; outcomes in another one are forgotten
    of: dict[str, Any] = field(default_factory=dict)
    workers: int = 1  # how many processes perform; their number does not change the outcomes
    free: int = 0  # so many of the first outcomes were paid for before
    _asked: set[bytes] = field(default_factory=set, init=False)
    _paid: frozenset[bytes] = field(default=frozenset(), init=False)
    _objects: list[dict[str, np.ndarray]] = field(default_factory=list, init=False)
    _rows: dict[bytes, tuple[str, np.ndarray, Outcome]] = field(default_factory=dict, init=False)

    def __post_init__(self) -> None:
        if self.path is not None and self.path.is_file():
            self._read(self.path)
        self._paid = frozenset(islice(self._rows, self.free))

    def __len__(self) -> int:
        return len(self._rows)

    @property
    def purposes(self) -> Counter[str]:
        """How much was performed, by what for."""
        return Counter(purpose for purpose, *_ in self._rows.values())

    @property
    def spent(self) -> int:
        """How much was asked for that is not free, whether or not an interrupted call performed it."""
        return len(self._asked - self._paid)

    def recall(self, tasks: Iterable[Task]) -> list[Outcome]:
        """Return the outcomes of the first tasks, as long as they are free."""
        paid = takewhile(self._paid.__contains__, map(_key, tasks))
        return [self._rows[key][2] for key in paid]

    def interactions(
        self, origin: dict[str, Any], count: int | None = None, objects: int | None = None
    ) -> Interactions:
        """Return the first so many of what was performed, or all, as a data set of that origin.

        Those are left out in which there were not so many objects, if a number is given.
        """
        rows = islice(self._rows.values(), count)
        kept = [row for row in rows if objects is None or len(row[2].start) == objects]
        return Interactions.from_outcomes(
            [outcome for *_, outcome in kept], np.array([action for _, action, _ in kept]), origin
        )

    def perform(
        self,
        world_factory: WorldFactory,
        tasks: Sequence[Task],
        purpose: str,
        progress: Progress | None = None,
    ) -> list[Outcome]:
        """Perform what was not performed yet, and give all outcomes in the order of the tasks.

        Args:
            world_factory: Builds the world.
            tasks: What to perform.
            purpose: What for, in one word.
            progress: Called after each, with how many there are.
        """
        keys = [_key(task) for task in tasks]
        self._asked.update(keys)
        new = {key: task for key, task in zip(keys, tasks, strict=True) if key not in self._rows}
        performed = perform_all(world_factory, new.values(), self.workers)
        try:
            for done, (key, task) in enumerate(new.items(), len(tasks) - len(new) + 1):
                with placed(f"performance {done} of {len(tasks)}"):
                    outcome = next(performed)
                self._rows[key] = purpose, np.asarray(task.action, dtype=np.float64), outcome
                if progress is not None:
                    progress(done, len(tasks))
                if done % BLOCK == 0:
                    self._write()
        finally:
            if new:
                self._write()
        return [self._rows[key][2] for key in keys]

    def _write(self) -> None:
        """Write all outcomes: a row for each, and a row for each object of each."""
        if self.path is None or not self._rows:
            return
        purposes, actions, outcomes = zip(*self._rows.values(), strict=True)
        names = sorted(set(purposes))
        self._objects += map(_objects, outcomes[len(self._objects) :])
        tensors = {
            "keys": np.frombuffer(b"".join(self._rows), dtype=np.uint8).reshape(-1, _KEY),
            "purposes": np.array([names.index(one) for one in purposes], dtype=np.uint8),
            "actions": np.array(actions),
            "counts": np.array([len(one.start) for one in outcomes]),
            "targets": np.array([one.target for one in outcomes]),
            "references": np.array([_reference(one) for one in outcomes]),
            "flags": np.array([[getattr(one, name) for name in _FLAGS] for one in outcomes], dtype=np.uint8),
            "peaks": np.array([one.peak_height for one in outcomes]),
            **{name: np.concatenate([one[name] for one in self._objects]) for name in _OBJECT_COLUMNS},
        }
        if most := max(one[_UNSEEN].shape[2] for one in self._objects):
            wider = [((0, 0), (0, 0), (0, most - one[_UNSEEN].shape[2])) for one in self._objects]
            rows = [np.pad(one[_UNSEEN], by) for one, by in zip(self._objects, wider, strict=True)]
            tensors[_UNSEEN] = np.concatenate(rows)
        with at_once():
            write_tensors(self.path, FORMAT, tensors, {"of": self.of, "purposes": names})

    def _read(self, path: Path) -> None:
        tensors, description = read_tensors(path, FORMAT)
        if description.get("of") != json.loads(json.dumps(self.of)):
            return
        try:
            names, ends = description["purposes"], np.cumsum(tensors["counts"])[:-1]
            nothing = np.zeros((len(tensors["features"]), len(_SCENES), 0))
            tensors = {_UNSEEN: nothing, **tensors}
            objects = {name: np.split(tensors[name], ends) for name in (*_OBJECT_COLUMNS, _UNSEEN)}
            for number, key in enumerate(tensors["keys"]):
                mine = {name: rows[number] for name, rows in objects.items()}
                outcome = _outcome({name: tensors[name][number] for name in _COLUMNS}, mine)
                purpose = names[tensors["purposes"][number]]
                self._rows[key.tobytes()] = purpose, tensors["actions"][number], outcome
        except (KeyError, IndexError, ValueError, TypeError) as error:
            raise InvalidFile(path, "its columns do not fit together; remove it to begin anew") from error


_FLAGS = "held", "toppled", "lost", "carried"
_SCENES = "start", "lifted", "end"
_COLUMNS = "targets", "references", "flags", "peaks"
_UNSEEN = "unseen"  # of each object, at each of the three moments; not written if there is nothing
_OBJECT_COLUMNS = "features", *_SCENES, "touched", "disturbed", "contacts"


def _key(task: Task) -> bytes:
    return blake2b(pickle.dumps(task, protocol=5), digest_size=_KEY).digest()


def _reference(outcome: Outcome) -> tuple[float, float, float]:
    """Write what an action was aimed at besides: which kind, and where."""
    if isinstance(outcome.reference, Place):
        return 1.0, outcome.reference.x, outcome.reference.y
    return (2.0, float(outcome.reference.index), 0.0) if outcome.reference else (0.0, 0.0, 0.0)


def _objects(outcome: Outcome) -> dict[str, np.ndarray]:
    """Write what became of each object of a scene, a row each."""
    count, disturbed = len(outcome.start), dict(outcome.disturbed)
    touching = np.zeros((count, count), dtype=np.uint8)
    touching[tuple(np.array(outcome.contacts, dtype=int).reshape(-1, 2).T)] = 1
    padded = np.zeros((count, _PLACES), dtype=np.uint8)
    padded[:, :count] = touching
    scenes = {name: getattr(outcome, name) for name in _SCENES}
    return {
        "features": outcome.start.features,
        **{name: np.hstack([one.positions, one.orientations]) for name, one in scenes.items()},
        "touched": np.isin(np.arange(count), outcome.touched).astype(np.uint8),
        "disturbed": np.array([_DISTURBED.index(disturbed.get(n, "")) for n in range(count)], dtype=np.uint8),
        "contacts": np.packbits(padded, axis=1),
        _UNSEEN: np.stack([one.unseen for one in scenes.values()], axis=1),
    }


def _outcome(row: dict[str, Any], objects: dict[str, np.ndarray]) -> Outcome:
    """Read an outcome as it was written."""
    features = objects["features"]
    kind, *where = row["references"].tolist()
    held, toppled, lost, carried = row["flags"].astype(bool).tolist()
    reference = (None, Place(*where), OtherObject(int(where[0])))[int(kind)] if kind else None
    touching = np.unpackbits(objects["contacts"], axis=1)[:, : len(features)]
    start, lifted, end = (
        Scene(features, objects[one][:, :3], objects[one][:, 3:], unseen=objects[_UNSEEN][:, number])
        for number, one in enumerate(_SCENES)
    )
    return Outcome(
        start=start,
        lifted=lifted,
        end=end,
        target=int(row["targets"]),
        held=held,
        toppled=toppled,
        lost=lost,
        carried=carried,
        peak_height=float(row["peaks"]),
        touched=tuple(np.flatnonzero(objects["touched"]).tolist()),
        disturbed=tuple((n, _DISTURBED[one]) for n, one in enumerate(objects["disturbed"].tolist()) if one),
        reference=reference,
        contacts=tuple((one, other) for one, other in np.argwhere(touching).tolist()),
    )
