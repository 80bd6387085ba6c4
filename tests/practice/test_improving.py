"""Operators are rehearsed on more objects, and surer actions take the place of others."""

from dataclasses import replace

import msgspec
import numpy as np
import pytest

from neurosym.data.interactions import Interactions
from neurosym.learning.network import DirectModel, EffectModel
from neurosym.operators import OperatorTable
from neurosym.primitives.rehearsal import sort_into_modes
from neurosym.stages import practice
from neurosym.stages.practice import Learner, Workshop, audition_others, rehearse_more, renamed
from neurosym.tasks.promises import rehearsed_objects
from neurosym.worlds.toy import make_world


@pytest.fixture(scope="module")
def shop(toy_folder) -> Workshop:
    return Workshop(
        make_world,
        make_world(),
        EffectModel.load(toy_folder / "effect_model.safetensors"),
        DirectModel.load(toy_folder / "direct_model.safetensors"),
        Interactions.load(toy_folder / "interactions.npz"),
        seed=3,
    )


@pytest.fixture(scope="module")
def table(toy_folder) -> OperatorTable:
    return OperatorTable.load(toy_folder / "primitives.json")


def learner(table, operator) -> Learner:
    primitive = next(one for one in table.primitives if one.label == operator.label)
    return Learner(operator, primitive, next(c for c in table.categories if c.symbol == operator.category))


def pushes(table):
    return [one for one in table.operators if one.name.startswith("push")]


def test_more_rehearsals_are_added_and_sorted_into_modes_with_the_others(shop, table):
    operator = pushes(table)[0]
    one = learner(table, operator)
    category = one.category
    improved = rehearse_more(shop, one, 6, turn=1)
    now, before = improved.operator, operator.trials
    assert (improved.interactions, improved.primitive) == (6, None)
    assert now.rehearsals[:before] == operator.rehearsals[:before]
    assert now.rehearsals[before + 6 :] == operator.rehearsals[before:], "those that were unsure come last"
    assert now.objects[:before] == category.objects
    assert now.objects[before + 6 :] == rehearsed_objects(operator, category)[before:]
    assert len(rehearsed_objects(now, category)) == len(now.rehearsals) == len(operator.rehearsals) + 6
    assert now.trials == before + 6
    rows = now.rehearsals[: now.trials]
    columns = (np.array([getattr(row, name) for row in rows]) for name in ("effect", "resting_effect"))
    heights = np.array([row.peak_height for row in rows])
    assert now.modes == sort_into_modes([row.kind for row in rows], *columns, heights)
    assert set(shop.model.object_symbols(np.array(now.objects[before:]))) == {category.symbol}
    first, again, other = (shop.scenes(category, 4, turn) for turn in (1, 1, 2))
    features = [[tuple(scene.features[0]) for scene in scenes] for scenes in (first, again, other)]
    assert features[0] == features[1]
    assert not set(features[0]) & set(features[2])


def test_an_action_on_an_edge_gives_way_to_a_surer_one_that_does_the_same(shop, table, monkeypatch):
    operator = pushes(table)[0]
    one = learner(table, operator)
    primitive, category = one.primitive, one.category
    real = practice.moved

    def spoilt(other, count, box, seed):
        actions = real(other, count, box, seed)
        if other == primitive:
            actions[::4, 8:10] = actions[::4, :2]  # a fourth of the objects is not pushed
        return actions

    monkeypatch.setattr(practice, "moved", spoilt)
    improved = audition_others(shop, one, turn=1)
    assert improved.primitive is not None
    assert improved.primitive.symbol == primitive.symbol
    assert improved.primitive.action != primitive.action
    assert shop.model.action_symbols(np.array([improved.primitive.action])) == (primitive.symbol,)
    now = renamed(improved.operator, category, "q")
    assert now.label == primitive.symbol + "q"
    assert f"-{primitive.symbol}q-" in now.name
    was, shall = operator.promise, now.promise
    assert np.linalg.norm(np.subtract(was.outcome, shall.outcome)) < 0.06
    monkeypatch.setattr(practice, "_rivals", lambda *_: [])
    stays = audition_others(shop, one, turn=1)
    assert (stays.operator, stays.primitive) == (operator, None)


def test_a_category_that_is_not_met_is_not_practised(shop, table):
    operator = pushes(table)[0]
    one = learner(table, operator)
    nowhere = replace(one, category=msgspec.structs.replace(one.category, symbol="2"))
    for improve in (rehearse_more, audition_others):
        given = (shop, nowhere, 2) if improve is rehearse_more else (shop, nowhere)
        assert improve(*given, turn=1) == practice.Improved(operator, None, 0)
