"""The tasks that carrying is measured by: they can be done, and are what they are called."""

from functools import cache

import numpy as np
from places import SHIPPED

from neurosym.evaluation.comparison import Bench
from neurosym.stages.folder import DomainFolder
from tools.benchmarks.carrying import tasks
from tools.benchmarks.carrying.by_hand import ByHand, carry_by_hand
from tools.benchmarks.carrying.evaluate import KEPT, kept
from tools.benchmarks.domains import keep, restore


@cache
def bench() -> Bench:
    return Bench(DomainFolder(SHIPPED))


def test_far_goals_of_graspable_objects_are_drawn_until_all_can_be_grasped():
    problem = tasks.far(bench(), 4, 1, graspable=True, tolerance=0.02)
    assert problem.tolerance == 0.02
    assert all(tasks.is_graspable(np.array(item.features)) for item in problem.objects)
    drawn = [tasks.far(bench(), 4, seed, graspable=False) for seed in range(6)]
    assert not all(tasks.is_graspable(np.array(item.features)) for one in drawn for item in one.objects)


def test_what_it_takes_to_try_a_learned_domain_is_kept_and_restored(tmp_path):
    learned, archive, again = tmp_path / "learned", tmp_path / "kept.zip", tmp_path / "again"
    for name in (*KEPT, "interactions.npz"):
        path = learned / "seed-2" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(name)
    (learned / "seed-3").mkdir()
    (learned / "seed-3" / KEPT[0]).write_text("not learned yet")
    keep(learned, archive, kept)
    again.mkdir()
    restore(archive, again)
    assert sorted(path.name for path in again.glob("*/*")) == sorted(KEPT)
    assert (again / "seed-2" / KEPT[0]).read_text() == KEPT[0]
    keep(again, tmp_path / "twice.zip", kept)
    assert (tmp_path / "twice.zip").read_bytes() == archive.read_bytes()


def test_a_person_carries_one_object_and_swaps_two_without_a_planner():
    world = bench().setting.world
    one = tasks.far(bench(), 1, 5, graspable=True)
    assert carry_by_hand(one, world, 0) == ByHand(reached=True, motions=1)
    swapped = carry_by_hand(tasks.graspable("swap", 2, bench(), 5), world, 0)
    assert swapped.reached
    assert 3 <= swapped.motions <= 6
