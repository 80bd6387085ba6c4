"""The table of operators has one number of axes, and says how it was measured where that is unusual."""

import msgspec
import pytest
from tables import table

from neurosym.errors import InvalidFile, InvalidValue
from neurosym.files import write_json
from neurosym.grounding import Grounding
from neurosym.operators import Mode, Operator, OperatorTable, Primitive
from neurosym.pddl import compile_domain
from neurosym.world import Table


def a_mode(*effect):
    zero = (0.0,) * len(effect)
    return Mode("resting", 1, 1.0, effect, zero, effect, zero, 0.0, 1)


def a_table(*modes, **measured):
    operators = tuple(Operator(f"o-{n}", "0", "1", 1, (mode,)) for n, mode in enumerate(modes))
    return OperatorTable((), (Primitive("1", (0.0,), 0.0),), operators, **measured)


def test_table_of_an_unknown_version_is_refused_in_one_sentence_and_of_the_first_read_as_it_is(tmp_path):
    for known in (a_table(a_mode(0.1, 0.2), measured="data"), table()):
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
    write_json(tmp_path / "t.json", msgspec.to_builtins(a_table(a_mode(0.1, 0.2))))
    text = (tmp_path / "t.json").read_text().replace("0.2", "0.2, 0.3")
    (tmp_path / "t.json").write_text(text)
    with pytest.raises(InvalidFile, match="same number of axes"):
        OperatorTable.load(tmp_path / "t.json")
    with pytest.raises(InvalidValue, match="same number of axes"):
        a_table(a_mode(0.1, 0.2), a_mode(0.1, 0.2, 0.3))


def test_effects_without_x_y_and_z_are_neither_compiled_nor_loaded(tmp_path):
    bounds, planar = Table((0.0, 1.0), (0.0, 1.0)), a_table(a_mode(0.1, 0.2))
    with pytest.raises(InvalidValue, match="effects of 2 axes"):
        compile_domain(planar, name="mine", table_bounds=bounds, lift_height=0.2)
    whole = compile_domain(a_table(a_mode(0.1, 0.2, 0.0)), name="mine", table_bounds=bounds, lift_height=0.2)
    content = {**msgspec.to_builtins(whole), "operators": msgspec.to_builtins(planar)}
    write_json(tmp_path / "grounding.json", content)
    with pytest.raises(InvalidFile, match="have 2 axes; valid: x, y and z"):
        Grounding.load(tmp_path / "grounding.json")
