"""What was performed is kept whole, and not performed again."""

import numpy as np
import pytest

from neurosym.errors import InvalidFile
from neurosym.primitives.ledger import BLOCK, Ledger
from neurosym.sim.tabletop import Tabletop
from neurosym.world import OtherObject, Place
from neurosym.worlds.toy import ToyWorld, make_world
from neurosym.worlds.workers import Task

OF = {"world": "toy", "sizes": (1, 2)}


class Counting(ToyWorld):
    """A toy world that counts what it performs, and is interrupted at last."""

    def __init__(self, most=10**9):
        super().__init__(make_world().config)
        self.performed, self.most = 0, most

    def interact(self, *given, **options):  # noqa: D102
        if self.performed == self.most:
            raise KeyboardInterrupt
        self.performed += 1
        return super().interact(*given, **options)


def tasks(count, first=0):
    world = make_world()
    rngs = [np.random.default_rng([3, n]) for n in range(first, first + count)]
    return [Task(world.sample_scene(rng, 1), world.action_box.sample(rng, 1)[0]) for rng in rngs]


def alike(one, other):
    for scene in ("start", "lifted", "end"):
        for column in ("features", "positions", "orientations"):
            first, second = (getattr(getattr(each, scene), column) for each in (one, other))
            assert first.tobytes() == second.tobytes()
    names = ("target", "held", "toppled", "lost", "peak_height", "touched", "disturbed", "reference")
    for name in (*names, "carried", "contacts", "kind", "turn"):
        assert getattr(one, name) == getattr(other, name), name


def test_nothing_is_performed_twice_also_after_it_was_written_and_read(tmp_path):
    world, path = Counting(), tmp_path / "performed.safetensors"
    ledger = Ledger(path, OF)
    first = ledger.perform(lambda: world, [*tasks(5), *tasks(3)], "auditioned")
    assert world.performed == 5
    again = Ledger(path, OF)
    second = again.perform(lambda: world, tasks(7), "rehearsed")
    assert world.performed == 7
    assert again.purposes == {"auditioned": 5, "rehearsed": 2}
    for one, other in zip(first[:5], second, strict=False):
        alike(one, other)
    data = again.interactions({"strategy": "random"}, 6)
    assert len(data) == 6
    np.testing.assert_allclose(data.actions, [task.action for task in tasks(6)], atol=1e-6)


def test_an_interruption_loses_nothing_that_was_performed(tmp_path):
    world, path = Counting(most=BLOCK + 3), tmp_path / "performed.safetensors"
    with pytest.raises(KeyboardInterrupt):
        Ledger(path, OF).perform(lambda: world, tasks(2 * BLOCK), "rehearsed")
    assert len(Ledger(path, OF)) == BLOCK + 3


def test_the_same_is_told_with_any_number_of_workers_and_after_an_interruption(tmp_path):
    whole = Ledger(workers=2).perform(make_world, tasks(20), "rehearsed")
    world, path = Counting(most=9), tmp_path / "performed.safetensors"
    with pytest.raises(KeyboardInterrupt):
        Ledger(path, OF).perform(lambda: world, tasks(20), "rehearsed")
    told = []
    resumed = Ledger(path, OF)
    found = resumed.perform(make_world, tasks(20), "rehearsed", lambda *numbers: told.append(numbers))
    for one, other in zip(whole, found, strict=True):
        alike(one, other)
    assert told == [(n, 20) for n in range(10, 21)]
    assert resumed.spent == 20


def test_what_was_paid_for_is_free_and_recalled(tmp_path):
    path = tmp_path / "performed.safetensors"
    Ledger(path, OF).perform(make_world, tasks(8), "auditioned")
    ledger = Ledger(path, OF, free=5)
    assert len(ledger.recall(tasks(8))) == 5
    ledger.perform(make_world, tasks(10), "rehearsed")
    assert ledger.spent == 5


def test_scenes_of_several_objects_come_back_as_they_were(tmp_path):
    world, path = Tabletop(), tmp_path / "performed.safetensors"
    asked = []
    for number, aim in enumerate((None, Place(0.6, 0.1), OtherObject(1), OtherObject(2))):
        rng = np.random.default_rng(number)
        scene = world.sample_scene(rng, 3)
        asked.append(Task(scene, world.action_box.sample(rng, 1)[0], 0, reference=aim))
    first = Ledger(path, OF).perform(Tabletop, asked, "rehearsed")
    read = Ledger(path, OF)
    assert len(read) == 4
    for one, other in zip(first, read.perform(Tabletop, asked, "rehearsed"), strict=True):
        alike(one, other)


def test_outcomes_of_another_world_are_forgotten_and_a_damaged_file_is_refused(tmp_path):
    path = tmp_path / "performed.safetensors"
    Ledger(path, OF).perform(make_world, tasks(4), "auditioned")
    assert len(Ledger(path, {**OF, "versions": {"numpy": "1"}})) == 0
    path.write_bytes(path.read_bytes()[:-200])
    with pytest.raises(InvalidFile, match="damaged"):
        Ledger(path, OF)
