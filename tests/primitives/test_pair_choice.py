"""Choosing actions for kinds of pairs: what is foreseen decides who is auditioned, and auditions decide."""

import numpy as np
import toy_relations
from toy_learning import search

from neurosym.operators import Primitive
from neurosym.pair_operators import PairStates
from neurosym.primitives.pair_audition import choose_for_pairs, tabulate_pairs
from neurosym.primitives.rehearsal import rehearse
from neurosym.primitives.sampling import Repertoire
from neurosym.worlds.aims import RelatedFactory
from neurosym.worlds.toy_relations import WALL, ToyRelations

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
    promised = {one.promise.state: one for one in table.operators if one.promise and one.pair == "1"}
    assert {toy_relations.ON, toy_relations.IN} == set(promised)
    assert len({one.name for one in promised.values()}) == 2
    assert sum(one.promise.share for one in promised.values()) <= 1
