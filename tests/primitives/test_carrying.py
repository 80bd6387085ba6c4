"""Operators that carry objects to places: found in a world that can be followed by hand."""

from dataclasses import replace
from functools import cache

import msgspec
import numpy as np
import pytest
from toy_learning import BRIEF, SMALL

from neurosym.errors import InvalidFile
from neurosym.exploration.loop import ExplorationConfig, explore
from neurosym.learning.training import Trained, train
from neurosym.pair_operators import PlaceOperators
from neurosym.primitives.operator_search import CARRYING, find_operators
from neurosym.primitives.reliability import foresee_carrying, judge, performance
from neurosym.world import Outcome
from neurosym.worlds.aims import Aimed, AimedFactory
from neurosym.worlds.toy import make_world


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
def found(workers: int = 1) -> PlaceOperators:
    trained, data = learned()
    return find_operators(
        trained.model,
        foretell,
        data,
        make_world().action_box,
        CARRYING,
        categorise=by_type,
        world_factory=make_world,
        objects=20,
        seed=0,
        workers=workers,
    )


def test_some_operator_carries_all_that_can_be_grasped_to_where_it_promises():
    hollow = [one for one in found().operators.operators if one.category == "1"]
    best = max(hollow, key=lambda one: one.successes)
    assert best.name.startswith("carry-to-")
    assert best.successes == best.trials
    assert best.promise.kind == "carried"
    assert max(best.promise.resting_spread) < 1e-9
    action = next(one.action for one in found().operators.primitives if one.label == best.label)
    by = np.array(action[8:10]) - action[4:6]
    np.testing.assert_allclose(best.promise.resting_effect[:2], by, atol=1e-6)


def test_what_cannot_be_grasped_is_missed():
    solid = [one for one in found().operators.operators if one.category == "0"]
    (category,) = (one for one in found().operators.categories if one.symbol == "0")
    narrow = np.mean([row[1] <= 0.08 for row in category.objects])
    best = max(solid, key=lambda one: one.successes)
    assert {mode.kind for mode in best.modes} == {"carried", "missed"}
    assert best.successes / best.trials == pytest.approx(narrow, abs=1e-9)


def test_in_a_world_where_things_pass_through_one_another_others_do_no_harm():
    for table in (found().occupied, found().beside):
        among = {one.name: one for one in table}
        assert among
        for operator in found().operators.operators:
            if operator.category == "1" and operator.successes == operator.trials:
                assert among[operator.name].kept == among[operator.name].trials > 0


def test_same_bytes_with_any_number_of_workers():
    assert msgspec.json.encode(found(2)) == msgspec.json.encode(found())


def test_a_table_comes_back_from_its_file_and_others_are_refused(tmp_path):
    file = tmp_path / "operators.json"
    file.write_bytes(msgspec.json.encode(found()))
    assert PlaceOperators.load(file) == found()
    file.write_text('{"format": "neurosym-places-9"}')
    with pytest.raises(InvalidFile, match="neurosym-places-9"):
        PlaceOperators.load(file)


def outcomes(*actions: np.ndarray) -> list[Outcome]:
    world = Aimed(make_world())
    scenes = [world.sample_scene(np.random.default_rng(n), 1) for n in range(8)]
    for scene in scenes:
        scene.features[0] = [0.05, 0.05, 0.04, 0.0]
    return [world.interact(scene, action, 0) for scene in scenes for action in actions]


GRASP = np.array([0, 0, 0, 1.0, 0, 0, 0, 0.0, 0.02, 0, 0, 0.0])
CLOSED = np.zeros(12)


def test_what_carries_always_alike_is_sure_however_near_to_the_place():
    judged = judge([performance(one) for one in outcomes(GRASP)])
    assert (judged.kind, judged.sureness) == ("carried", pytest.approx(1.0))
    assert judge([performance(one) for one in outcomes(CLOSED)]).kind is None
    assert judge([performance(one) for one in outcomes(GRASP, CLOSED)]).sureness == pytest.approx(0.5)


def test_foreseen_is_what_is_carried_and_alike():
    sure = np.tile([0.0, 0.0, 0.0, 1.0, 0.2], (6, 1))
    apart = sure + np.outer(np.linspace(-1, 1, 6), [0.05, 0, 0, 0, 0])
    never = sure * [1, 1, 1, 0, 1]
    assert foresee_carrying(sure).sureness == pytest.approx(1.0)
    assert 0.2 < foresee_carrying(apart).sureness < 0.5
    assert foresee_carrying(never).sureness == 0.0
    assert foresee_carrying(sure).kind == "carried"
