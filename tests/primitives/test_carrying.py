"""Operators that carry objects to places, and actions for kinds of pairs, in worlds easily followed."""

from dataclasses import replace
from functools import cache

import msgspec
import numpy as np
import pytest
import toy_relations
from toy_learning import BRIEF, SMALL, search

from neurosym.errors import InvalidFile
from neurosym.exploration.loop import ExplorationConfig, explore
from neurosym.formats import PlaceFile
from neurosym.learning.training import Trained, train
from neurosym.operators import OperatorTable, Primitive
from neurosym.pair_operators import PairStates
from neurosym.primitives.ledger import Ledger
from neurosym.primitives.operator_search import CARRYING, find_operators
from neurosym.primitives.pair_audition import choose_for_pairs, tabulate_pairs
from neurosym.primitives.rehearsal import rehearse
from neurosym.primitives.reliability import foresee_carrying
from neurosym.primitives.sampling import Repertoire
from neurosym.worlds.aims import AimedFactory, RelatedFactory
from neurosym.worlds.toy import make_world
from neurosym.worlds.toy_relations import WALL, ToyRelations


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


# Actions for kinds of pairs: what is foreseen decides who is auditioned, and auditions decide

FACTORY = RelatedFactory(ToyRelations)
TABLE = toy_relations.relations()
STATES = PairStates(TABLE.states, TABLE.scales)
CARRY = Primitive("01", toy_relations.CARRY, 0.01)
NOTHING = Primitive("00", (0.0,) * 12, 0.0)


def kinds(features: np.ndarray) -> tuple[str, ...]:
    """Tell whether the reference is hollow."""
    return tuple("1" if row[7] > 0.5 else "0" for row in features)


def hopeful(features: np.ndarray, actions: np.ndarray) -> np.ndarray:
    """Foresee the best of every action: into what is hollow and wide enough, and onto anything else."""
    del actions
    fits = (features[:, 7] > 0.5) & np.all(features[:, :2] < features[:, 4:6] - 2 * WALL, axis=1)
    return np.column_stack([~fits, fits]) * 0.9


def chosen_among(candidates: list[Primitive], predict=hopeful, **options: object) -> Repertoire:
    return choose_for_pairs(search(candidates, kinds, FACTORY, predict=predict, **options), STATES)


def of_kind(chosen, kind: str) -> list[tuple[float, ...]]:
    return [one.action for one in chosen.primitives if chosen.serves(one, kind)]


def test_auditions_leave_what_really_puts_on_and_into():
    chosen, again = (chosen_among([NOTHING, CARRY], seed=0, workers=workers) for workers in (1, 2))
    assert chosen == again
    assert CARRY.action in of_kind(chosen, "0")
    assert NOTHING.action not in of_kind(chosen, "0")
    assert NOTHING.action not in of_kind(chosen, "1")
    performed = list[tuple[int, int]]()

    def nothing(features: np.ndarray, actions: np.ndarray) -> np.ndarray:
        return np.zeros((len(features), 2)) * actions[:, :1]

    assert of_kind(chosen_among([CARRY], nothing, told=performed), "0") == []
    assert performed == [], "what is foreseen to do nothing is not auditioned"


def test_kind_whose_pairs_end_in_several_states_has_an_operator_for_each():
    chosen = chosen_among([CARRY], seed=0)
    found = rehearse(FACTORY, chosen, kinds, objects=80, seed=1)
    table = tabulate_pairs(found, ToyRelations().feature_names, STATES)
    promised = {one.promise.kind: one for one in table.operators if one.promise and one.subject == "1"}
    assert {toy_relations.ON, toy_relations.IN} == set(promised)
    assert len({one.name for one in promised.values()}) == 2
    assert sum(one.promise.share for one in promised.values()) <= 1
