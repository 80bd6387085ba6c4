"""Operators that do the same as a more reliable one are left out, in groundings of newer formats."""

import msgspec
import numpy as np
import pytest
from independent.replay import domain_operators, read_text
from tables import grounding, mode

from neurosym.grounding import Grounding
from neurosym.operators import Operator

NEWER = "neurosym-grounding-2"
LEFT = (0.0021, 0.0832, 0.0)  # what push-left-000-block promises


def with_another(operator: Operator, form: str = NEWER) -> Grounding:
    learned = grounding()
    table = learned.objects
    table = msgspec.structs.replace(table, operators=(*table.operators, operator))
    return msgspec.structs.replace(learned, format=form, objects=table)


def push(name: str, effect=LEFT, *, near: int = 18, category: str = "00") -> Operator:
    return Operator(name, category, "001", 20, (mode(effect, near=near),))


@pytest.mark.parametrize(
    ("other", "reason"),
    [
        (push("push-x", near=17), "does the same as push-left-000-block, less reliably"),
        (push("push-x"), "does the same as push-left-000-block, as reliably"),
        (push("push-x", (0.0, 0.0810, 0.0), near=17), "does the same as push-left-000-block, less reliably"),
        (push("push-x", (0.0021, 0.0858, 0.0), near=17), None),  # half a cell and more
        (push("push-x", near=17, category="11"), None),
        (msgspec.structs.replace(push("push-x", near=3), trials=3), "fewer than 5 rehearsals"),
        (Operator("lift-x", "00", "001", 20, (mode(LEFT, kind="held"),)), None),
    ],
)
def test_operator_that_does_the_same_less_reliably_is_left_out(other: Operator, reason: str | None):
    learned = with_another(other)
    assert learned.why_left_out(other) == reason
    assert learned.left_out.get(other.name) == reason
    assert (other in learned.live) == (reason is None)
    assert learned.operator_named("push-left-000-block") in learned.live


def test_lifts_are_the_same_only_if_they_are_put_down_alike():
    for resting, same in (((0.0141, -0.0228, 0.0), True), ((0.0241, -0.0228, 0.0), False)):
        lifted = mode((0.012, -0.021, 0.203), kind="held", count=16, near=14, resting=resting)
        learned = with_another(Operator("lift-x", "00", "001", 20, (lifted,)))
        assert ("lift-x" in learned.left_out) == same


def test_groundings_of_the_first_format_keep_every_operator():
    other = push("push-x", near=17)
    assert other in with_another(other, "neurosym-grounding-1").live


def test_duplicates_among_hundreds_of_operators_are_found_as_by_comparing_all_pairs():
    rng = np.random.default_rng(0)
    draws = ((*rng.uniform(-0.06, 0.06, 2).tolist(), int(rng.integers(10, 21))) for _ in range(500))
    many = tuple(push(f"push-{n}", (x, y, 0.0), near=near) for n, (x, y, near) in enumerate(draws))
    table = msgspec.structs.replace(grounding().objects, operators=many)
    learned = msgspec.structs.replace(grounding(), format=NEWER, objects=table)
    kept = [one["name"] for one in domain_operators(read_text(msgspec.json.encode(learned).decode()))]
    assert 100 < len(kept) < 490
    assert {operator.name for operator in learned.live} == {*kept}
