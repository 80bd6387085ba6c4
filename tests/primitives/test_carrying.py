"""Operators that carry objects to places, and the same with kinds of pairs, in worlds easily followed."""

from dataclasses import replace
from functools import cache

import msgspec
import numpy as np
import pytest
import toy_relations
from toy_learning import BRIEF, SMALL, search

from neurosym.errors import InvalidFile, InvalidValue
from neurosym.exploration.loop import ExplorationConfig, explore
from neurosym.formats import PlaceFile
from neurosym.learning.training import Trained, train
from neurosym.operators import Category, Mode, Operator, OperatorTable, Primitive
from neurosym.pair_operators import PairStates
from neurosym.primitives.ledger import Ledger
from neurosym.primitives.operator_search import CARRYING, find_operators
from neurosym.primitives.pair_rehearsal import Carriers, carriers_for_pairs, tabulate_pairs
from neurosym.primitives.rehearsal import rehearse
from neurosym.primitives.reliability import foresee_carrying
from neurosym.primitives.sampling import Repertoire
from neurosym.worlds.aims import AimedFactory, RelatedFactory
from neurosym.worlds.toy import make_world
from neurosym.worlds.toy_relations import ToyRelations


def by_type(features):
    """Hollow objects, which can all be grasped, apart from solid ones."""
    return tuple("1" if row[3] >= 0.5 else "0" for row in features)


@cache
def learned() -> tuple[Trained, object]:
    exploration = ExplorationConfig(candidates=1, block=400)
    data = explore(AimedFactory(make_world), steps=300, strategy="random", seed=0, config=exploration)
    naming = replace(BRIEF.naming, steps=300)  # so that there are actions with nearly every code
    config = replace(BRIEF, naming=naming)
    return train(data, config=config, model_config=SMALL.with_bits(1, 2), seed=0), data


def foretell(features, actions):
    """Say what the toy world would do, by its rules."""
    graspable = (features[:, 3] >= 0.5) | (features[:, 1] <= 0.08)
    carried = (graspable & (actions[:, 3] >= 0.5) & (actions[:, 7] < 0.5)).astype(float)[:, None]
    by = np.column_stack([actions[:, 8:10] - actions[:, 4:6], np.zeros(len(actions)), np.ones(len(actions))])
    return np.column_stack([carried * by, 0.2 * carried])


@cache
def found() -> OperatorTable:
    trained, data = learned()
    return find_operators(
        trained.model,
        foretell,
        data,
        make_world().action_box,
        CARRYING,
        categorise=by_type,
        world_factory=make_world,
        objects=48,
        seed=0,
        ledger=Ledger(),
    )


def test_some_operator_carries_all_that_can_be_grasped_to_where_it_promises():
    hollow = [one for one in found().operators if one.subject == "1"]
    best = max(hollow, key=lambda one: one.successes)
    assert best.name.startswith("carry-to-")
    assert best.successes == best.trials
    assert best.promise.kind == "carried"
    assert max(best.promise.resting_spread) < 1e-9
    action = next(one.action for one in found().primitives if one.label == best.label)
    by = np.array(action[8:10]) - action[4:6]
    np.testing.assert_allclose(best.promise.resting_effect[:2], by, atol=1e-6)
    solid = [one for one in found().operators if one.subject == "0"]
    (category,) = (one for one in found().categories if one.symbol == "0")
    best = max(solid, key=lambda one: one.successes)
    assert {mode.kind for mode in best.outcomes} == {"carried", "missed"}
    rows = (best.objects or category.objects)[: best.trials]
    narrow = np.mean([row[1] <= 0.08 for row in rows])  # what is wider cannot be grasped
    assert best.successes / best.trials == pytest.approx(narrow, abs=1e-9)


def test_in_a_world_where_things_pass_through_one_another_others_do_no_harm():
    sure = [one for one in found().operators if one.subject == "1" and one.successes == one.trials]
    assert sure
    for kept in (one.among(how) for one in sure for how in ("occupied", "beside")):
        assert kept.kept == kept.trials > 0


def test_same_table_comes_from_its_file(tmp_path):
    file = tmp_path / "operators.json"
    file.write_bytes(msgspec.json.encode(PlaceFile.holding(found())))
    assert PlaceFile.load(file).table() == found()
    file.write_text('{"format": "neurosym-places-9"}')
    with pytest.raises(InvalidFile, match="neurosym-places-9"):
        PlaceFile.load(file)


def test_foreseen_is_what_is_carried_and_alike():
    sure = np.tile([0.0, 0.0, 0.0, 1.0, 0.2], (6, 1))
    apart = sure + np.outer(np.linspace(-1, 1, 6), [0.05, 0, 0, 0, 0])
    never = sure * [1, 1, 1, 0, 1]
    assert foresee_carrying(sure).sureness == pytest.approx(1.0)
    assert 0.2 < foresee_carrying(apart).sureness < 0.5
    assert foresee_carrying(never).sureness == 0.0
    assert foresee_carrying(sure).kind == "carried"


# What carries objects to places is aimed at other objects, and rehearsed with each kind of pairs

STATES = PairStates(toy_relations.relations().states, toy_relations.relations().scales)
OFF = 0.03
"""How far beside the place objects end that the shifted action carries there [m]."""
CARRY = Primitive("01", toy_relations.CARRY, 0.01)
SHIFTED = Primitive("10", (*toy_relations.CARRY[:8], OFF, *toy_relations.CARRY[9:]), 0.01)


def carrier(primitive: Primitive, category: str, carried: int, off: float = 0.0) -> Operator:
    """An operator that was rehearsed to carry a category so often, and ends so far beside the place."""
    end = (off, 0.0, 0.0)
    modes = (
        Mode("carried", carried, carried / 20, end, (0.0,) * 3, end, (0.0,) * 3, 0.2, carried),
        Mode("missed", 20 - carried, 1 - carried / 20, *((0.0,) * 3,) * 4, 0.0, 0),
    )
    return Operator(f"by-{primitive.label}-{category}", category, primitive.symbol, 20, modes, frame="place")


def carriers(*operators: Operator) -> Carriers:
    """What carries a category "0" of everything, as toy relations have it."""
    everything = Category("0", "thing-0", 1.0, (0.05,) * 4, (0.0,) * 4)
    table = OperatorTable((everything,), (CARRY, SHIFTED), operators)
    return Carriers(table, lambda rows: ("0",) * len(rows), lambda actions: tuple(map(as_known, actions)))


def as_known(action: np.ndarray) -> Primitive:
    return next(one for one in (CARRY, SHIFTED) if one.action == tuple(action.tolist()))


def kinds(features: np.ndarray) -> tuple[str, ...]:
    """Tell whether the reference is hollow."""
    return tuple("1" if row[7] > 0.5 else "0" for row in features)


def found_for_pairs(known: Carriers, **options: object) -> Repertoire:
    shown = RelatedFactory(ToyRelations, aim=known)
    return carriers_for_pairs(search((), kinds, shown, objects=40, **options), known)


def test_what_carries_most_surely_is_tried_with_pairs():
    sure, unsure, never = carrier(CARRY, "0", 19), carrier(SHIFTED, "0", 12, OFF), carrier(SHIFTED, "0", 2)
    assert carriers(unsure, sure).of("0") == (CARRY, SHIFTED)
    assert carriers(sure, never).of("0") == (CARRY,)
    chosen = found_for_pairs(carriers(unsure, sure))
    assert {kind: set(labels) for kind, labels in (chosen.own or {}).items()} == {
        "0": {"01", "10"},
        "1": {"01", "10"},
    }
    with pytest.raises(InvalidValue, match="Nothing carries objects to places"):
        found_for_pairs(carriers(never))


def test_action_that_ends_beside_places_is_aimed_over_the_middle_of_others():
    known = carriers(carrier(SHIFTED, "0", 20, OFF))
    target = np.array(toy_relations.CUBE)
    np.testing.assert_allclose(known(np.array(SHIFTED.action), target), toy_relations.CARRY)
    np.testing.assert_array_equal(known(np.array(CARRY.action), target), CARRY.action)
    plain, aimed = RelatedFactory(ToyRelations)(), RelatedFactory(ToyRelations, aim=known)()
    scene = plain.sample_scene(np.random.default_rng(1), 1)
    expected = plain.interact(scene, np.array(CARRY.action), 0)
    np.testing.assert_allclose(
        aimed.interact(scene, np.array(SHIFTED.action), 0).end.positions, expected.end.positions
    )


def test_kind_whose_pairs_end_in_several_states_has_an_operator_for_each():
    known = carriers(carrier(CARRY, "0", 20))
    found = rehearse(
        RelatedFactory(ToyRelations, aim=known), found_for_pairs(known), kinds, objects=80, seed=1
    )
    table = tabulate_pairs(found, ToyRelations().feature_names, STATES)
    promised = {one.promise.kind: one for one in table.operators if one.promise and one.subject == "1"}
    assert {toy_relations.ON, toy_relations.IN} == set(promised)
    assert len({one.name for one in promised.values()}) == 2
    assert sum(one.promise.share for one in promised.values()) <= 1
