"""The table of operators has one number of axes and says how it was measured; names say what was measured."""

import msgspec
import numpy as np
import pytest
from tables import table

from neurosym.data.category_names import name_categories, traits_of
from neurosym.errors import InvalidFile, InvalidValue
from neurosym.files import write_json
from neurosym.grounding import Grounding
from neurosym.operators import (
    Category,
    Mode,
    Operator,
    OperatorTable,
    Primitive,
    counted_axes,
    name_axes,
    name_operator,
    verb,
)
from neurosym.pddl import compile_domain
from neurosym.world import Table


def moved(*effect, kind="resting", peak=0.0):
    zero = (0.0,) * len(effect)
    return Mode(kind, 1, 1.0, effect, zero, effect, zero, peak, 1)


def a_table(*modes, **measured):
    operators = tuple(Operator(f"o-{n}", "0", "1", 1, (mode,)) for n, mode in enumerate(modes))
    return OperatorTable((), (Primitive("1", (0.0,), 0.0),), operators, **measured)


def test_table_of_an_unknown_version_is_refused_in_one_sentence_and_of_the_first_read_as_it_is(tmp_path):
    for known in (a_table(moved(0.1, 0.2), measured="data"), table()):
        write_json(tmp_path / "t.json", known)
        assert OperatorTable.load(tmp_path / "t.json") == known
        assert b"format" not in (tmp_path / "t.json").read_bytes()
    content = {"from": "the future", "format": "neurosym-primitives-3", **msgspec.to_builtins(table())}
    write_json(tmp_path / "t.json", content)
    known = "this version reads 'neurosym-primitives-1' and 'neurosym-primitives-2'"
    with pytest.raises(InvalidFile, match=f"the format 'neurosym-primitives-3', and {known}"):
        OperatorTable.load(tmp_path / "t.json")


def test_axes_that_do_not_agree_are_refused(tmp_path):
    with pytest.raises(InvalidValue, match="same number of axes"):
        Mode("resting", 1, 1.0, (0.0, 0.0), (0.0,), (0.0,), (0.0,), 0.0, 1)
    write_json(tmp_path / "t.json", msgspec.to_builtins(a_table(moved(0.1, 0.2))))
    text = (tmp_path / "t.json").read_text().replace("0.2", "0.2, 0.3")
    (tmp_path / "t.json").write_text(text)
    with pytest.raises(InvalidFile, match="same number of axes"):
        OperatorTable.load(tmp_path / "t.json")
    with pytest.raises(InvalidValue, match="same number of axes"):
        a_table(moved(0.1, 0.2), moved(0.1, 0.2, 0.3))


def test_effects_without_x_y_and_z_are_neither_compiled_nor_loaded(tmp_path):
    bounds, planar = Table((0.0, 1.0), (0.0, 1.0)), a_table(moved(0.1, 0.2))
    with pytest.raises(InvalidValue, match="effects of 2 axes"):
        compile_domain(planar, name="mine", table_bounds=bounds, lift_height=0.2)
    whole = compile_domain(a_table(moved(0.1, 0.2, 0.0)), name="mine", table_bounds=bounds, lift_height=0.2)
    content = {**msgspec.to_builtins(whole), "operators": msgspec.to_builtins(planar)}
    write_json(tmp_path / "grounding.json", content)
    with pytest.raises(InvalidFile, match="have 2 axes; valid: x, y and z"):
        Grounding.load(tmp_path / "grounding.json")


NAMES = ("s_x", "s_y", "d", "t")


@pytest.mark.parametrize(
    ("effect", "ended", "expected"),
    [
        ((0.1, 0.0, 0.0), {}, "push-forward"),
        ((-0.1, 0.0, 0.0), {}, "pull"),
        ((0.0, 0.1, 0.0), {}, "push-left"),
        ((0.0, -0.1, 0.0), {}, "push-right"),
        ((0.1, 0.08, 0.0), {}, "push-forward-left"),
        ((-0.1, -0.08, 0.0), {}, "pull-right"),
        ((0.1, 0.03, 0.0), {}, "push-forward"),
        ((0.005, 0.005, 0.0), {}, "stay"),
        ((0.005, 0.005, 0.2), {}, "raise"),
        ((0.0, 0.0, -0.07), {}, "lower"),
        ((0.0, 0.1, 0.2), {"kind": "held", "peak": 0.2}, "lift"),
        ((0.0, 0.1, 0.0), {"peak": 0.05}, "place-left"),
        ((-0.1, 0.0, 0.0), {"peak": 0.05}, "place-back"),
    ],
)
def test_what_happens_is_named_by_how_it_ends_and_by_direction(effect, ended, expected):
    assert verb(moved(*effect, **ended)) == expected


def test_effects_without_x_y_and_z_are_acts():
    two = moved(0.1, 0.2)
    assert name_operator("101", "kind-10", [two]) == "act-101-kind-10"
    assert name_axes(3) == ("x", "y", "z")
    assert name_axes(2) == ("e1", "e2")
    assert [counted_axes(count) for count in (1, 2)] == ["1 axis", "2 axes"]


def test_an_operator_is_named_by_its_promise_not_its_accidents():
    modes = (moved(0.0, 0.0, 0.0, kind="toppled"), moved(0.0, 0.1, 0.0))
    assert name_operator("101", "hollow-low-10", modes) == "push-left-101-hollow-low-10"
    assert name_operator("101", "any-10", modes[:1]) == "topple-101-any-10"
    assert name_operator("101", "any-10", [moved(0.0, 0.0, 0.0, kind="lost")]) == "throw-off-101-any-10"


def test_categories_are_named_by_what_sets_them_apart():
    rows = [
        [[0.1, 0.1, 0.04, 0.5]],
        [[0.1, 0.1, 0.08, 0.0]],
        [[0.04, 0.04, 0.06, 1.0], [0.04, 0.04, 0.06, 0.0]],
    ]
    members = [*map(np.array, rows)]
    assert name_categories(["00", "01", "11"], members, NAMES) == (
        "hollow-low-wide-00",
        "solid-tall-wide-01",
        "any-narrow-11",
    )
    assert name_categories(["0"], members[:1], NAMES) == ("hollow-0",)


def test_categories_of_a_users_own_are_named_by_the_names_of_features():
    rng = np.random.default_rng(0)
    hue = rng.uniform(size=50)
    members = [
        np.stack([rng.normal(mass, 0.1, 50), np.full(50, red), hue], axis=1)
        for red, mass in ((0, 1), (0, 5), (1, 1), (1, 5))
    ]
    names = name_categories(["00", "01", "10", "11"], members, ["mass", "red", "hue"])
    assert names == ("no-red-light-00", "no-red-heavy-01", "red-light-10", "red-heavy-11")
    assert name_categories(["0", "1"], members[:1] * 2, ["mass", "red", "hue"]) == ("kind-0", "kind-1")
    seen = [
        Category(symbol, name, 0.25, tuple(rows.mean(0)), tuple(rows.std(0)))
        for symbol, name, rows in zip(["00", "01", "10", "11"], names, members, strict=True)
    ]
    told = traits_of([*seen, Category("111", "unseen-111", 0.0, (), ())], ["mass", "red", "hue"])
    assert [*map(str, told["11"])] == ["red over 0.5", "mass over 3.66"]
