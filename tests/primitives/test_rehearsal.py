"""Rehearsal tells what primitives really do, mode by mode."""

from dataclasses import replace

import numpy as np
import pytest

from neurosym.errors import InvalidValue
from neurosym.operators import Primitive
from neurosym.primitives.rehearsal import modes_of, rehearse, tabulate
from neurosym.world import Outcome, Scene
from neurosym.worlds.toy import LONGEST_PUSH, WIDEST_GRASP, make_world

GRASP = Primitive("111", (0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0), 0.0)
LEFT = Primitive("010", (0, -0.04, 0, 1, 0, 0, 0, 1, 0, 0.04, 0, 1), 0.0)


def categorise(features):
    graspable = (features[:, 3] >= 0.5) | (features[:, 1] <= WIDEST_GRASP)
    return tuple(f"{int(g)}{int(p)}" for g, p in zip(graspable, features[:, 0] <= LONGEST_PUSH, strict=True))


def an_outcome(shift=(0.0, 0.0, 0.0), rest=None, **flags):
    def scene(offset):
        return Scene(np.ones((1, 4)), np.array([offset], dtype=float), np.array([[0.0, 0, 0, 1]]))

    flags = {"held": False, "toppled": False, "lost": False, "peak_height": 0.0, **flags}
    return Outcome(scene((0, 0, 0)), scene(shift), scene(shift if rest is None else rest), 0, **flags)


def table_of(primitives, categorise=categorise, **options):
    return tabulate(rehearse(make_world, primitives, categorise, **options), make_world().feature_names)


def test_operators_promise_what_the_toy_world_does():
    table = table_of([GRASP, LEFT], objects=60, seed=0)
    assert [primitive.symbol for primitive in table.primitives] == ["010", "111"]
    assert [category.symbol for category in table.categories] == ["00", "01", "10", "11"]
    promised = {(o.category, o.primitive): o.promise for o in table.operators}
    assert promised["10", "111"].kind == "held"
    np.testing.assert_allclose(promised["10", "111"].effect, (0, 0, 0.2), atol=1e-9)
    np.testing.assert_allclose(promised["10", "111"].resting_effect, 0, atol=1e-9)
    np.testing.assert_allclose(promised["01", "010"].effect, (0, 0.08, 0), atol=1e-9)
    np.testing.assert_allclose(promised["00", "010"].effect, 0, atol=1e-9)


def test_counts_and_shares_add_up():
    table = table_of([GRASP, LEFT], objects=60, seed=0)
    assert sum(category.share for category in table.categories) == pytest.approx(1)
    for operator in table.operators:
        assert sum(mode.count for mode in operator.modes) == operator.trials
        assert sum(mode.share for mode in operator.modes) == pytest.approx(1)
    objects = {category.symbol: category.objects for category in table.categories}
    for operator in table.operators:
        assert len(operator.rehearsals) == operator.trials == len(objects[operator.category])


def test_categories_have_as_many_objects_as_the_first_draws_and_rare_ones_at_least_thirty():
    table = table_of([GRASP], objects=200, seed=0)
    world = make_world()
    first = [world.sample_scene(np.random.default_rng([0, 0x7265, n]), 1).features for n in range(200)]
    symbols = categorise(np.concatenate(first))
    counts = {category.symbol: len(category.objects) for category in table.categories}
    assert counts == {symbol: max(30, symbols.count(symbol)) for symbol in counts}
    assert min(map(symbols.count, counts)) < 30 < max(map(symbols.count, counts))


def test_what_is_kept_of_rehearsals_is_what_happened_to_the_objects_in_their_order():
    table = table_of([GRASP, LEFT], objects=20, seed=0)
    objects = {category.symbol: category.objects for category in table.categories}
    for operator in table.operators:
        action = np.array({"111": GRASP, "010": LEFT}[operator.primitive].action, dtype=float)
        for features, kept in zip(objects[operator.category], operator.rehearsals, strict=True):
            assert categorise(np.array([features])) == (operator.category,)
            scene = Scene(np.array([features]), np.array([[0.7, 0, 0]]), np.array([[0.0, 0, 0, 1]]))
            outcome = make_world().interact(scene, action, 0)
            assert kept.effect == pytest.approx(outcome.effect.tolist(), abs=1e-5)
            assert kept.kind in (outcome.kind, "lost")  # it may have stood at the edge of the table
            assert (kept.peak_height, kept.turn) == (pytest.approx(outcome.peak_height, abs=1e-5), 0.0)


def test_names_are_unique():
    table = table_of([GRASP, LEFT], objects=60, seed=0)
    names = [operator.name for operator in table.operators]
    assert len(set(names)) == len(names)
    assert any(name.startswith("lift-111-hollow") for name in names)


def test_two_workers_give_the_table_of_one():
    one, two = (table_of([GRASP, LEFT], objects=20, seed=1, workers=workers) for workers in (1, 2))
    assert one == two


def test_objects_lost_over_the_edge_are_a_mode_of_their_own():
    table = table_of([LEFT], objects=200, seed=0)
    kinds = {mode.kind for operator in table.operators for mode in operator.modes}
    assert kinds == {"resting", "lost"}


def test_modes_are_never_averaged_together():
    lifts = [an_outcome((0, 0, 0.2), (0, 0, 0), held=True)] * 3
    modes = modes_of([*lifts, *[an_outcome((0.1, 0, 0))] * 5])
    assert [(mode.kind, mode.count, round(mode.effect[2], 9)) for mode in modes] == [
        ("resting", 5, 0.0),
        ("held", 3, 0.2),
    ]


def test_near_mean_counts_what_lies_within_the_planning_tolerance():
    (mode,) = modes_of([*[an_outcome((0.0, 0, 0))] * 9, an_outcome((0.5, 0, 0))])
    assert mode.effect[0] == pytest.approx(0.05)
    assert mode.near_mean == 0 + 9  # those at 0 are 0.05 off the mean, the other is 0.45 off
    (close,) = modes_of([an_outcome((0.0, 0, 0)), an_outcome((0.08, 0, 0))])
    assert close.near_mean == 2


def test_held_outcomes_are_judged_in_mid_air_and_resting_ones_at_rest():
    air = [an_outcome((0, 0, z), (0, 0, 0), held=True) for z in (0.1, 0.3)]
    assert modes_of(air)[0].near_mean == 0
    assert modes_of([replace(outcome, held=False) for outcome in air])[0].near_mean == 2


@pytest.mark.parametrize(
    ("flags", "kind"),
    [
        ({}, "resting"),
        ({"held": True}, "held"),
        ({"toppled": True}, "toppled"),
        ({"lost": True, "held": True}, "lost"),
    ],
)
def test_kinds_follow_the_flags(flags, kind):
    assert an_outcome(**flags).kind == kind


def test_nothing_to_rehearse_is_refused():
    with pytest.raises(InvalidValue):
        rehearse(make_world, [], categorise, seed=0)


def test_symbol_that_no_object_has_is_a_category_of_which_nothing_is_known():
    table = table_of([GRASP], lambda features: ["10"] * len(features), objects=6, seed=0)
    assert [category.symbol for category in table.categories] == ["00", "01", "10", "11"]
    assert [category.share for category in table.categories] == [0.0, 0.0, 1.0, 0.0]
    assert table.categories[0].name == "unseen-00"
    assert {operator.category for operator in table.operators} == {"10"}
