"""The grounding: which operators are live, what they promise in metres and in cells, and its file."""

import json
from collections.abc import Callable
from pathlib import Path

import msgspec
import numpy as np
import pytest
from places import ROOT
from tables import BOUNDS, grounding, mode, table

from neurosym.errors import InvalidFile, InvalidValue
from neurosym.grounding import Grounding
from neurosym.operators import Operator
from neurosym.pddl import compile_domain


@pytest.mark.parametrize(
    ("trials", "effect", "seen", "reason"),
    [
        (4, (0.1, 0.0, 0.0), {"count": 4, "near": 4}, "fewer than 5 rehearsals"),
        (20, (0.1, 0.0, 0.0), {"kind": "lost"}, "never ends at rest or held"),
        (20, (0.1, 0.0, 0.0), {"kind": "toppled"}, "topples more often than not"),
        (20, (0.1, 0.0, 0.0), {"near": 1}, "keeps its promise in 1 of 20"),
        (20, (0.0024, -0.0024, 0.1), {}, "moves less than half a cell"),
        (20, (0.003, -0.003, 0.0), {}, "scatters more than it moves"),
        (20, (0.0056, 0.0, 0.0), {"near": 2}, None),
    ],
)
def test_every_operator_left_out_has_its_reason(trials, effect, seen, reason):
    found = grounding().why_left_out(Operator("a", "00", "000", trials, (mode(effect, **seen),)))
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


def test_grounding_survives_its_file_and_one_of_another_version_is_refused(tmp_path: Path):
    file = tmp_path / "grounding.json"
    for form in ("neurosym-grounding-1", grounding().format):
        known = msgspec.structs.replace(grounding(), format=form)
        known.save(file)
        assert Grounding.load(file) == known
    file.write_text(file.read_text().replace(grounding().format, "neurosym-grounding-9"))
    with pytest.raises(InvalidFile, match="neurosym-grounding-9"):
        Grounding.load(file)


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (lambda places: places["operators"]["primitives"][0]["action"].pop(), "11 and 12 numbers; valid"),
        (lambda places: places["beside"][0].update(kept=10**6), "1000000 are said to have been kept"),
    ],
)
def test_file_whose_actions_differ_in_length_or_that_kept_more_than_it_tried_is_refused(
    change: Callable[[dict], object], said: str, tmp_path: Path
):
    content = json.loads((ROOT / "domains/places/grounding.json").read_text())
    change(content["places"])
    (tmp_path / "grounding.json").write_text(json.dumps(content))
    with pytest.raises(InvalidFile, match=said):
        Grounding.load(tmp_path / "grounding.json")


@pytest.mark.parametrize("name", ["Push", "put-down", "block", "pull-010-tray", "tabletop"])
def test_operator_name_that_is_illegal_or_taken_is_refused(name: str):
    learned = table()
    renamed = msgspec.structs.replace(learned.operators[0], name=name)
    broken = msgspec.structs.replace(learned, operators=(renamed, *learned.operators[1:]))
    with pytest.raises(InvalidValue, match=name):
        compile_domain(broken, name="tabletop", table_bounds=BOUNDS, lift_height=0.2)
