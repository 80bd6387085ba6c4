"""Names say what was measured, and are legal in PDDL."""

import re

import numpy as np
import pytest

from neurosym.operators import (
    Mode,
    counted_axes,
    name_axes,
    name_categories,
    name_operator,
    verb,
)

NAMES = ("s_x", "s_y", "d", "t")


def a_mode(effect=(0.0, 0.0, 0.0), kind="resting", peak=0.0):
    zero = (0.0, 0.0, 0.0)
    return Mode(kind, 10, 1.0, effect, zero, effect, zero, peak, 10)


@pytest.mark.parametrize(
    ("effect", "expected"),
    [
        ((0.1, 0.0, 0.0), "push-forward"),
        ((-0.1, 0.0, 0.0), "pull"),
        ((0.0, 0.1, 0.0), "push-left"),
        ((0.0, -0.1, 0.0), "push-right"),
        ((0.1, 0.08, 0.0), "push-forward-left"),
        ((-0.1, -0.08, 0.0), "pull-right"),
        ((0.1, 0.03, 0.0), "push-forward"),
        ((0.005, 0.005, 0.0), "stay"),
        ((0.005, 0.005, 0.2), "raise"),
        ((0.0, 0.0, -0.07), "lower"),
    ],
)
def test_pushes_are_named_by_direction(effect, expected):
    assert verb(a_mode(effect)) == expected


def test_what_hangs_from_the_hand_is_lifted_and_what_is_set_down_is_placed():
    assert verb(a_mode((0.0, 0.1, 0.2), kind="held", peak=0.2)) == "lift"
    assert verb(a_mode((0.0, 0.1, 0.0), peak=0.05)) == "place-left"
    assert verb(a_mode((-0.1, 0.0, 0.0), peak=0.05)) == "place-back"


def test_effects_without_x_y_and_z_are_acts():
    two = Mode("resting", 1, 1.0, (0.1, 0.2), (0.0, 0.0), (0.1, 0.2), (0.0, 0.0), 0.0, 1)
    assert name_operator("101", "kind-10", [two]) == "act-101-kind-10"
    assert name_axes(3) == ("x", "y", "z")
    assert name_axes(2) == ("e1", "e2")
    assert [counted_axes(count) for count in (1, 2)] == ["1 axis", "2 axes"]


def test_an_operator_is_named_by_its_promise_not_its_accidents():
    modes = (a_mode(kind="toppled"), a_mode((0.0, 0.1, 0.0)))
    assert name_operator("101", "hollow-low-10", modes) == "push-left-101-hollow-low-10"
    assert name_operator("101", "any-10", modes[:1]) == "topple-101-any-10"
    assert name_operator("101", "any-10", [a_mode(kind="lost")]) == "throw-off-101-any-10"


def test_categories_are_named_by_what_sets_them_apart():
    means = np.array([[0.1, 0.1, 0.04, 1.0], [0.1, 0.1, 0.08, 0.0], [0.04, 0.04, 0.06, 0.5]])
    assert name_categories(["00", "01", "11"], means, NAMES) == (
        "hollow-low-wide-00",
        "solid-tall-wide-01",
        "any-narrow-11",
    )
    assert name_categories(["0"], means[:1], NAMES) == ("hollow-0",)
    assert name_categories(["0", "1"], np.array([[1.0], [2.0]]), ["mass"]) == ("kind-0", "kind-1")


def test_all_names_are_legal_and_unique():
    rng = np.random.default_rng(0)
    symbols = ["00", "01", "10", "11"]
    categories = name_categories(symbols, rng.uniform(size=(4, 4)), NAMES)
    names = [
        name_operator(
            f"{code:03b}", category, [a_mode(tuple(rng.normal(size=3).tolist()), peak=rng.uniform(0, 0.05))]
        )
        for code in range(8)
        for category in categories
    ]
    assert len(set(names)) == 32
    assert all(re.fullmatch("[a-z][a-z0-9-]*", name) for name in [*names, *categories])
