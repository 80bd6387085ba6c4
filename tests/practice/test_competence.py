"""Competence counts promises that were kept, and its rise with rehearsals is extrapolated."""

import msgspec
import numpy as np
import pytest
import rehearsed

from neurosym.operators import Operator
from neurosym.stages.rounds import HOPE, competence, expected_gain
from neurosym.tasks.promises import keeps_promises, rehearsed_objects

CATEGORY = next(one for one in rehearsed.grounding().operators.categories if one.symbol == "00")


def pushing() -> Operator:
    return next(
        one
        for one in rehearsed.grounding().operators.operators
        if one.category == CATEGORY.symbol and one.name.startswith("push-left")
    )


def disturbed(every: int, by: float) -> Operator:
    """Have some of the rehearsals end elsewhere than their neighbours say."""
    operator = pushing()
    rows = tuple(
        msgspec.structs.replace(row, resting_effect=tuple(np.add(row.resting_effect, (by, 0.0, 0.0))))
        if number % every == 1
        else row
        for number, row in enumerate(operator.rehearsals)
    )
    return msgspec.structs.replace(operator, rehearsals=rows)


def repeated(operator: Operator, times: int) -> Operator:
    """Rehearse an operator as often again, on objects a hair wider."""
    objects = [
        (row[0] + 1e-4 * turn, *row[1:])
        for turn in range(times)
        for row in rehearsed_objects(operator, CATEGORY)
    ]
    return msgspec.structs.replace(operator, objects=tuple(objects), rehearsals=operator.rehearsals * times)


def test_an_operator_whose_outcomes_follow_the_size_is_competent_and_one_that_scatters_is_not():
    sure, scattering = pushing(), disturbed(2, 0.12)
    assert competence(sure, CATEGORY) > 0.85
    assert competence(scattering, CATEGORY) < competence(sure, CATEGORY) - 0.3


def test_rehearsals_that_ended_in_another_way_keep_no_promise():
    operator = pushing()
    fallen = tuple(msgspec.structs.replace(row, kind="toppled") for row in operator.rehearsals[:5])
    operator = msgspec.structs.replace(operator, rehearsals=(*fallen, *operator.rehearsals[5:]))
    assert keeps_promises(operator, CATEGORY, 0.02)[:5] == (False,) * 5
    assert sum(keeps_promises(operator, CATEGORY, 0.02)) > 10


def test_more_is_gained_with_more_rehearsals_and_never_more_than_is_missing():
    operator = disturbed(5, 0.05)
    gains = [expected_gain(operator, CATEGORY, more) for more in (0, 10, 30, 300, 10**9)]
    assert gains == sorted(gains)
    assert gains[0] == 0 < gains[1]
    assert gains[-1] <= 1 - competence(operator, CATEGORY)


def test_hope_fades_where_many_rehearsals_brought_nothing():
    few = disturbed(5, 0.05)
    many = repeated(few, 8)
    missing = [1 - competence(one, CATEGORY) for one in (few, many)]
    hopes = [expected_gain(one, CATEGORY, len(one.rehearsals)) for one in (few, many)]
    assert hopes[1] / missing[1] < hopes[0] / missing[0] or hopes[1] == pytest.approx(HOPE * missing[1])
