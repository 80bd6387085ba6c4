"""Operators are rehearsed more on objects for which it is unsure whether they keep their promise."""

import numpy as np
import pytest
from toy_learning import search

from neurosym.operators import OperatorTable, Primitive
from neurosym.primitives.rehearsal import ROUNDS, SHARE, rehearse, rehearse_unsure, tabulate
from neurosym.worlds.toy import WIDEST_GRASP, make_world

OBJECTS = 60
GRASP = Primitive("111", (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), 0.0)
LEFT = Primitive("010", (0, -0.04, 0, 1, 0, 0, 0, 1, 0, 0.04, 0, 1), 0.0)
WIDTH = 1
"""Column of the features that says whether a block can be grasped."""


def by_shape(features):
    return tuple(str(int(shape >= 0.5)) for shape in features[:, 3])


@pytest.fixture(scope="module")
def before() -> OperatorTable:
    rehearsed = rehearse(make_world, [GRASP, LEFT], by_shape, objects=OBJECTS, seed=0)
    return tabulate(rehearsed, make_world().feature_names)


@pytest.fixture(scope="module")
def after(before) -> OperatorTable:
    return rehearse_unsure(search((), by_shape, objects=OBJECTS), before)


def of(table, primitive, category="0"):
    return next(one for one in table.operators if (one.primitive, one.category) == (primitive, category))


def from_the_edge(rows) -> list[float]:
    return [abs(row[WIDTH] - WIDEST_GRASP) for row in rows]


def test_objects_near_the_edge_of_what_can_be_held_are_tried(before, after):
    was, now = of(before, "111"), of(after, "111")
    known = next(one.objects for one in before.categories if one.symbol == "0")
    new = now.objects[len(known) :]
    assert now.objects[: len(known)] == known
    assert 0 < len(new) <= ROUNDS * int(SHARE * OBJECTS)
    assert len(set(new)) == len(new)
    assert np.median(from_the_edge(new)) < np.median(from_the_edge(known)) / 2
    for row, rehearsal in zip(now.objects, now.rehearsals, strict=True):
        assert (rehearsal.kind == "held") == (row[WIDTH] <= WIDEST_GRASP) or rehearsal.kind == "lost"
    assert now.rehearsals[: was.trials] == was.rehearsals


def test_trials_count_only_objects_as_the_world_draws_them(before, after):
    assert [(one.name, one.trials, one.modes) for one in after.operators] == [
        (one.name, one.trials, one.modes) for one in before.operators
    ]
    assert after.categories == before.categories


def test_what_is_sure_is_not_rehearsed_again(before, after):
    assert of(after, "111", "1") == of(before, "111", "1")


def test_the_number_of_workers_changes_nothing(before, after):
    assert rehearse_unsure(search((), by_shape, objects=OBJECTS, workers=2), before) == after


def test_progress_counts_on_from_round_to_round(before):
    told: list[tuple[int, int]] = []
    rehearse_unsure(search((), by_shape, told=told, objects=OBJECTS), before)
    assert [done for done, _ in told] == list(range(1, len(told) + 1))
    assert all(done <= total for done, total in told)


def test_few_rehearsals_get_none_beside_them(before):
    assert rehearse_unsure(search((), by_shape, objects=3), before) == before


def test_a_category_that_is_not_met_again_is_left_as_it_is(before):
    def unlike(features):
        return tuple("0" for _ in features)

    now = rehearse_unsure(search((), unlike, objects=OBJECTS), before)
    assert of(now, "111", "1") == of(before, "111", "1")
