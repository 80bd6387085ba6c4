"""The grounding: which operators are live, what they promise in metres and in cells, and its file."""

from pathlib import Path

import msgspec
import numpy as np
import pytest
from tables import BOUNDS, grounding, mode, table

from neurosym.errors import InvalidFile, InvalidValue, UnknownChoice
from neurosym.grounding import Grounding
from neurosym.operators import Operator
from neurosym.pddl import compile_domain


def test_only_operators_worth_planning_with_are_live():
    assert [operator.name for operator in grounding().live] == [
        "lift-010-block",
        "pull-010-tray",
        "push-away-001-block",
        "push-left-000-block",
        "push-left-000-tray",
    ]


@pytest.mark.parametrize(
    ("operator", "reason"),
    [
        (Operator("a", "00", "000", 4, (mode((0.1, 0.0, 0.0), count=4, near=4),)), "fewer than 5 rehearsals"),
        (Operator("a", "00", "000", 20, (mode((0.1, 0.0, 0.0), kind="lost"),)), "never ends at rest or held"),
        (
            Operator("a", "00", "000", 20, (mode((0.1, 0.0, 0.0), kind="toppled"),)),
            "topples more often than not",
        ),
        (Operator("a", "00", "000", 20, (mode((0.1, 0.0, 0.0), near=1),)), "keeps its promise in 1 of 20"),
        (Operator("a", "00", "000", 20, (mode((0.0024, -0.0024, 0.1)),)), "moves less than half a cell"),
        (Operator("a", "00", "000", 20, (mode((0.003, -0.003, 0.0)),)), "scatters more than it moves"),
        (Operator("a", "00", "000", 20, (mode((0.0056, 0.0, 0.0), near=2),)), None),
    ],
)
def test_every_operator_left_out_has_its_reason(operator: Operator, reason: str | None):
    found = grounding().why_left_out(operator)
    assert found is None if reason is None else found is not None and found.startswith(reason)


def test_lift_and_put_down_come_to_the_resting_effect_at_table_height():
    learned = grounding()
    assert learned.displacement(learned.operator_named("push-left-000-block")) == (0.0021, 0.0832, 0.0)
    lift = learned.operator_named("lift-010-block")
    up, down = learned.displacement(lift), learned.put_down_displacement(lift)
    assert up == (0.012, -0.021, 0.203)
    assert np.add(up, down) == pytest.approx([0.0141, -0.0228, 0.0])
    cells = np.add(learned.cells(lift), learned.put_down_cells(lift))
    assert cells.tolist() == [3, -5, 0]  # 14.1 and -22.8 mm in cells of 5 mm


def test_rounding_bounds_every_operator():
    learned = grounding()
    bound = tuple(map(max, *map(learned.rounding, learned.live)))
    for operator in learned.live:
        parts = zip(learned.displacement(operator), learned.cells(operator), bound, strict=True)
        assert all(abs(part - cells * 0.005) <= limit + 1e-12 for part, cells, limit in parts)
    assert max(bound) <= 0.0025 + 1e-12


def test_grounding_survives_its_file_and_one_of_another_version_is_refused(tmp_path: Path):
    file = tmp_path / "grounding.json"
    for form in ("neurosym-grounding-1", grounding().format):
        known = msgspec.structs.replace(grounding(), format=form)
        known.save(file)
        assert Grounding.load(file) == known
    file.write_text(file.read_text().replace(grounding().format, "neurosym-grounding-9"))
    with pytest.raises(InvalidFile, match="neurosym-grounding-9"):
        Grounding.load(file)


def test_a_pair_is_done_with_the_operator_that_comes_first():
    learned = grounding()
    first, table = learned.operators.operators[0], learned.operators
    surer = msgspec.structs.replace(first, name=f"{first.name}-a", variant="a")
    table = msgspec.structs.replace(table, operators=(surer, *table.operators))
    both = msgspec.structs.replace(learned, operators=table)
    assert both.operator_for(first.category, first.primitive) == surer


def test_unknown_names_are_refused_with_the_known_ones():
    with pytest.raises(UnknownChoice, match="valid: lift-010-block"):
        grounding().operator_named("fly")
    with pytest.raises(UnknownChoice, match="valid: 00, 11"):
        grounding().category("01")
    with pytest.raises(UnknownChoice, match="valid: 000, 001, 010, 111"):
        grounding().primitive("100")
    assert grounding().operator_for("11", "010") == grounding().operator_named("pull-010-tray")
    assert grounding().operator_for("00", "100") is None


@pytest.mark.parametrize(
    "name", ["Push", "finish-it", "put-down-x", "reach-out", "block", "pull-010-tray", "tabletop"]
)
def test_operator_name_that_is_illegal_reserved_or_taken_is_refused(name: str):
    learned = table()
    renamed = msgspec.structs.replace(learned.operators[0], name=name)
    broken = msgspec.structs.replace(learned, operators=(renamed, *learned.operators[1:]))
    with pytest.raises(InvalidValue, match=name):
        compile_domain(broken, name="tabletop", table_bounds=BOUNDS, lift_height=0.2)


@pytest.mark.parametrize("cell", [0.0, -0.01, 1.0, 1e-6, float("nan")])
def test_cell_of_no_sensible_size_is_refused(cell: float):
    with pytest.raises(InvalidValue, match="cell"):
        grounding(cell)
