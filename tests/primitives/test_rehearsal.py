"""Rehearsal tells what primitives really do, mode by mode, and more of objects for which that is unsure."""

from dataclasses import replace

import numpy as np
import pytest
from toy_learning import an_outcome, by_affordance, search

from neurosym.operators import OperatorTable, Primitive
from neurosym.primitives.rehearsal import (
    ROUNDS,
    SHARE,
    modes_of,
    rehearse,
    rehearse_unsure,
    tabulate,
)
from neurosym.primitives.sampling import MOST_DRAWS, draw_scene, sample_by_category
from neurosym.world import Scene
from neurosym.worlds.toy import WIDEST_GRASP, make_world

GRASP = Primitive("111", (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), 0.0)
LEFT = Primitive("010", (0, -0.04, 0, 1, 0, 0, 0, 1, 0, 0.04, 0, 1), 0.0)


def table_of(primitives, categorise=by_affordance, **options):
    return tabulate(rehearse(make_world, primitives, categorise, **options), make_world().feature_names)


def test_operators_promise_what_the_toy_world_does():
    table = table_of([GRASP, LEFT], objects=60, seed=0)
    assert [primitive.symbol for primitive in table.primitives] == ["010", "111"]
    assert [category.symbol for category in table.categories] == ["00", "01", "10", "11"]
    promised = {(o.subject, o.primitive): o.promise for o in table.operators}
    assert promised["10", "111"].kind == "held"
    np.testing.assert_allclose(promised["10", "111"].effect, (0, 0, 0.2), atol=1e-9)
    np.testing.assert_allclose(promised["10", "111"].resting_effect, 0, atol=1e-9)
    np.testing.assert_allclose(promised["01", "010"].effect, (0, 0.08, 0), atol=1e-9)
    np.testing.assert_allclose(promised["00", "010"].effect, 0, atol=1e-9)
    assert sum(category.share for category in table.categories) == pytest.approx(1)
    objects = {category.symbol: category.objects for category in table.categories}
    for operator in table.operators:
        assert len(operator.rehearsals) == operator.trials == len(objects[operator.subject])
        assert sum(mode.count for mode in operator.outcomes) == operator.trials
        assert sum(mode.share for mode in operator.outcomes) == pytest.approx(1)
    names = [operator.name for operator in table.operators]
    assert len(set(names)) == len(names)
    assert any(name.startswith("lift-111-hollow") for name in names)
    kinds = {mode.kind for operator in table.operators for mode in operator.outcomes}
    assert kinds == {"resting", "held", "lost"}, "over the edge is a mode of its own"


def test_what_is_kept_of_rehearsals_is_what_happened_to_the_objects_in_their_order():
    table = table_of([GRASP, LEFT], objects=20, seed=0)
    objects = {category.symbol: category.objects for category in table.categories}
    for operator in table.operators:
        action = np.array({"111": GRASP, "010": LEFT}[operator.primitive].action, dtype=float)
        for features, kept in zip(objects[operator.subject], operator.rehearsals, strict=True):
            assert by_affordance(np.array([features])) == (operator.subject,)
            scene = Scene(np.array([features]), np.array([[0.7, 0, 0]]), np.array([[0.0, 0, 0, 1]]))
            outcome = make_world().interact(scene, action, 0)
            assert kept.effect == pytest.approx(outcome.effect.tolist(), abs=1e-5)
            assert kept.kind in (outcome.kind, "lost")  # it may have stood at the edge of the table
            assert (kept.peak_height, kept.turn) == (pytest.approx(outcome.peak_height, abs=1e-5), 0.0)


AIR = [an_outcome((0, 0, z), (0, 0, 0), held=True) for z in (0.1, 0.3)]


@pytest.mark.parametrize(
    ("outcomes", "modes"),
    [
        (  # never averaged together
            [*[an_outcome((0, 0, 0.2), (0, 0, 0), held=True)] * 3, *[an_outcome((0.1, 0, 0))] * 5],
            [("resting", 5, (0.1, 0, 0), 5), ("held", 3, (0, 0, 0.2), 3)],
        ),
        (
            [*[an_outcome()] * 9, an_outcome((0.5, 0, 0))],
            [("resting", 10, (0.05, 0, 0), 9)],
        ),  # 0.45 is too far
        ([an_outcome(), an_outcome((0.08, 0, 0))], [("resting", 2, (0.04, 0, 0), 2)]),
        (AIR, [("held", 2, (0, 0, 0.2), 0)]),  # judged in mid-air
        ([replace(outcome, held=False) for outcome in AIR], [("resting", 2, (0, 0, 0.2), 2)]),  # at rest
        ([an_outcome(lost=True, held=True)], [("lost", 1, (0, 0, 0), 1)]),
    ],
)
def test_modes_tell_how_outcomes_ended_and_how_many_lie_within_the_planning_tolerance(outcomes, modes):
    found = modes_of(outcomes)
    assert [(one.kind, one.count, one.near_mean) for one in found] == [(k, c, n) for k, c, _, n in modes]
    for one, (*_, effect, _) in zip(found, modes, strict=True):
        np.testing.assert_allclose(one.effect, effect, atol=1e-9)


OBJECTS = 60
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
    return next(one for one in table.operators if (one.primitive, one.subject) == (primitive, category))


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


def test_trials_count_only_objects_as_the_world_draws_them_whatever_the_workers(before, after):
    assert [(one.name, one.trials, one.outcomes) for one in after.operators] == [
        (one.name, one.trials, one.outcomes) for one in before.operators
    ]
    assert after.categories == before.categories
    assert of(after, "111", "1") == of(before, "111", "1"), "what is sure is not rehearsed again"
    told: list[tuple[int, int]] = []
    again = rehearse_unsure(search((), by_shape, told=told, objects=OBJECTS, workers=2), before)
    assert again == after
    assert [done for done, _ in told] == list(range(1, len(told) + 1))
    assert all(done <= total for done, total in told)


def test_a_category_that_is_not_met_again_is_left_as_it_is(before):
    def unlike(features):
        return tuple("0" for _ in features)

    assert rehearse_unsure(search((), by_shape, objects=3), before) == before, "too few to be worth it"
    now = rehearse_unsure(search((), unlike, objects=OBJECTS), before)
    assert of(now, "111", "1") == of(before, "111", "1")


def by_width(share):
    """Say of objects whether they are among the narrowest share of all."""
    limit = 0.03 + 0.15 * share
    return lambda features: tuple(str(int(narrow)) for narrow in features[:, 0] < limit)


def drawn(count):
    return np.concatenate([draw_scene(make_world(), 3, 7, number).features for number in range(count)])


def sample(categorise, **options):
    return sample_by_category(make_world(), categorise, seed=3, stream=7, **options)


def test_rare_categories_have_as_many_objects_as_asked_for_or_as_were_found():
    found = sample(by_width(0.1), least=12, typical=40)
    everything, symbols = drawn(600), by_width(0.1)(drawn(600))
    counts = {symbol: max(12, symbols[:40].count(symbol)) for symbol in "01"}
    assert {symbol: len(scenes) for symbol, scenes in found.scenes.items()} == counts
    for symbol, scenes in found.scenes.items():
        first = [row for row, its in zip(everything, symbols, strict=True) if its == symbol]
        assert np.array_equal([scene.features[0] for scene in scenes], first[: counts[symbol]])
    found = sample(by_width(0.008), least=9)
    symbols = by_width(0.008)(drawn(MOST_DRAWS * 9))
    assert 0 < symbols.count("1") < 9
    assert len(found.scenes["1"]) == symbols.count("1")
    assert found.shares["1"] == symbols.count("1") / len(symbols)
