"""Without a world, effects are averaged over the rows of the data, kind by kind."""

import numpy as np
import pytest

from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidValue
from neurosym.operators import Primitive
from neurosym.primitives.operator_search import average, kinds_of, most_typical

PRIMITIVES = (Primitive("1", (0.5, 0.5), 0.0), Primitive("0", (-0.5, 0.5), 0.0))


def some_data(rows=200, axes=3, **origin):
    rng = np.random.default_rng(1)
    held, toppled, lost = rng.uniform(size=(3, rows)) < 0.2
    effects, resting = rng.normal(0, 0.05, size=(2, rows, axes)).astype(np.float32)
    features, actions = rng.uniform(-1, 1, size=(2, rows, 2)).astype(np.float32)
    peaks = rng.uniform(size=rows).astype(np.float32)
    return Interactions(features, actions, effects, resting, held, toppled, lost, peaks, origin)


def first_sign(values):
    return tuple("1" if value > 0 else "0" for value in values[:, 0])


def both_signs(values):
    return tuple(f"{int(a > 0)}{int(b > 0)}" for a, b in values)


@pytest.mark.parametrize("axes", [1, 3])
def test_table_agrees_with_a_naive_average(axes):
    data = some_data(axes=axes)
    first = ("lost", "held", "toppled")
    kinds = [next((one for one in first if getattr(data, one)[row]), "resting") for row in range(len(data))]
    assert kinds_of(data) == kinds
    table = average(data, PRIMITIVES, both_signs, first_sign)
    assert table.measured == "data"
    assert table.axes == axes
    assert len(table.operators) == 8
    for operator in table.operators:
        rows = [
            row
            for row in range(len(data))
            if first_sign(data.actions)[row] == operator.primitive
            and both_signs(data.features)[row] == operator.subject
        ]
        assert operator.trials == len(rows) == sum(mode.count for mode in operator.outcomes)
        for mode in operator.outcomes:
            own = [row for row in rows if kinds[row] == mode.kind]
            assert mode.count == len(own)
            for told, column in ((mode.effect, data.effects), (mode.resting_effect, data.resting_effects)):
                np.testing.assert_allclose(told, np.mean([column[row] for row in own], axis=0), atol=1e-7)
            assert mode.peak_height == pytest.approx(np.mean([data.peak_heights[row] for row in own]))


def test_pairs_and_primitives_that_no_row_has_are_left_out():
    data = some_data()
    table = average(data, PRIMITIVES, lambda rows: ("00",) * len(rows), lambda rows: ("1",) * len(rows))
    assert [(operator.subject, operator.primitive) for operator in table.operators] == [("00", "1")]
    assert [one.name for one in table.categories] == ["kind-00", "unseen-01", "unseen-10", "unseen-11"]
    with pytest.raises(InvalidValue, match="without primitives"):
        average(data, (), both_signs, first_sign)


def test_what_stands_for_a_symbol_does_what_its_rows_do_on_average():
    amounts = np.linspace(0.2, 1.0, 33, dtype=np.float32)[:, None]
    still, none = np.zeros((33, 1), dtype=np.float32), np.zeros(33, dtype=bool)
    data = Interactions(still, amounts, 5 * amounts, 5 * amounts, none, none, none, still[:, 0], {})
    candidates = [Primitive("1", (amount,), 0.0) for amount in (1.0, 0.55, 0.2)]
    chosen = most_typical(candidates, lambda _, actions: 5 * actions, data, lambda rows: ("1",) * len(rows))
    assert [one.action for one in chosen] == [(0.55,)]
