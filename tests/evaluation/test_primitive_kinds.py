"""The six kinds of primitive of Table II, by outcomes made for the purpose."""

import numpy as np
import pytest
from toy_learning import an_outcome

from neurosym.evaluation.paper_tables import KINDS, kind_of, kinds_found
from neurosym.operators import CARRIED, Primitive
from neurosym.primitives.rehearsal import Rehearsals

LIFT_HEIGHT = 0.2


OF_KIND = {
    "right push": an_outcome((0.0, -0.05, 0.0)),
    "left push": an_outcome((0.02, 0.05, 0.0)),
    "forward push": an_outcome((0.05, -0.02, 0.0)),
    "pull": an_outcome((-0.031, 0.0, 0.0)),
    "grasp": an_outcome((0.0, 0.0, 0.19), (0.0, 0.0, 0.0), held=True, peak_height=0.19),
    "pick and place": an_outcome((0.03, -0.03, 0.0), peak_height=0.05),
}
OF_NO_KIND = {
    "nothing": an_outcome(),
    "too short": an_outcome((0.029, 0.0, 0.0)),
    "askew": an_outcome((0.05, 0.026, 0.0)),
    "toppled": an_outcome((0.05, 0.0, 0.0), toppled=True),
    "lost": an_outcome((0.5, 0.0, -0.5), lost=True),
    "lost from the hand": an_outcome((0.0, 0.0, 0.2), (0.5, 0, -0.5), lost=True, held=True),
    "hardly lifted": an_outcome((0.0, 0.0, 0.09), (0.0, 0.0, 0.0), held=True, peak_height=0.09),
    "carried nowhere": an_outcome((0.0, 0.02, 0.0), peak_height=0.05),
}


def test_each_kind_is_recognised_and_a_push_that_rises_only_above_what_counts_as_carried():
    assert {kind: kind_of(OF_KIND[kind], LIFT_HEIGHT) for kind in KINDS} == {kind: kind for kind in KINDS}
    assert {what for what in OF_NO_KIND if kind_of(OF_NO_KIND[what], LIFT_HEIGHT)} == set()
    assert kind_of(an_outcome((0.05, 0, 0), peak_height=CARRIED), LIFT_HEIGHT) == "forward push"
    assert kind_of(an_outcome((0.05, 0, 0), peak_height=CARRIED + 1e-6), LIFT_HEIGHT) == "pick and place"
    dropped = an_outcome((0.0, 0.0, 0.02), (0.05, 0.0, 0.0))
    assert kind_of(dropped, LIFT_HEIGHT) == "forward push"  # it is judged at rest


def rehearsals(symbols, *columns):
    """Primitives 000, 001, ... that turned out so on objects of these symbols."""
    primitives = tuple(Primitive(f"{n:03b}", (0.0,) * 12, 0.0) for n in range(len(columns)))
    return Rehearsals(primitives, np.zeros((len(symbols), 4)), np.array(symbols), tuple(map(tuple, columns)))


@pytest.mark.parametrize("kind", KINDS)
def test_kind_counts_as_found_where_enough_rehearsals_were_of_it(kind):
    it, other = OF_KIND[kind], OF_NO_KIND["nothing"]
    symbols = ["00"] * 10 + ["11"] * 10
    found = kinds_found(
        rehearsals(symbols, [other] * 20, [it] * 6 + [other] * 4 + [it] * 5 + [other] * 5), LIFT_HEIGHT
    )
    assert set(found) == set(KINDS)
    assert found[kind] == (("001", "00"),)
    assert all(not pairs for name, pairs in found.items() if name != kind)


def test_kind_that_only_a_rare_object_symbol_shows_is_not_found():
    grasp, other = OF_KIND["grasp"], OF_NO_KIND["nothing"]
    for rare, is_found in ((9, False), (10, True)):
        symbols = ["1"] * rare + ["0"] * (100 - rare)
        found = kinds_found(rehearsals(symbols, [grasp] * rare + [other] * (100 - rare)), LIFT_HEIGHT)
        assert bool(found["grasp"]) == is_found
