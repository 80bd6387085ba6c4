"""`neurosym replay` tells the same bytes, the same on another machine, and another course apart."""

import json
from pathlib import Path

import pytest
from command_line import neurosym

from neurosym.execution.record import this_machine


@pytest.fixture
def record(folder, capsys) -> Path:
    """A record of a run, made here."""
    made = next(folder.glob("runs/*.fast-downward.run.json"))
    problem = made.name.split(".")[0]
    plan = folder / f"plans/{problem}.fast-downward.plan"
    assert neurosym("execute", folder, problem, plan) in (0, 3)
    capsys.readouterr()
    return made


def change(record: Path, by: float, **machine) -> None:
    """Make of a record what another machine might have written."""
    run = json.loads(record.read_text())
    for step in run["steps"]:
        step["positions"] = {name: [x + by, y, z] for name, (x, y, z) in step["positions"].items()}
    run["machine"] = {**run["machine"], **machine} if run["machine"] else None
    record.write_text(json.dumps(run))


def test_record_names_its_machine_and_is_the_same_each_time(folder, record):
    written = record.read_bytes()
    run = json.loads(written)
    assert run["machine"]["processor"] == this_machine().processor
    assert run["machine"]["versions"] == this_machine().versions
    problem = record.name.split(".")[0]
    neurosym("execute", folder, problem, folder / f"plans/{problem}.fast-downward.plan")
    assert record.read_bytes() == written


def test_record_of_another_processor_is_the_same_within_a_micrometre(folder, record, capsys):
    change(record, 3e-9, processor="Other 9000")
    assert neurosym("replay", folder, record) == 0
    said = capsys.readouterr().out
    assert "within a micrometre; goal" in said
    assert "lengths differ by 3e-06 mm at most, first in positions of step 1" in said
    assert f"another machine than this: processor: Other 9000 and {this_machine().processor}" in said
    assert "byte for byte; goal" not in said
    change(record, 0.0, processor=this_machine().processor)
    assert neurosym("replay", folder, record) == 0
    assert "machine and versions are those of the record" in capsys.readouterr().out


def test_record_of_an_earlier_version_can_be_run_again(folder, record, capsys):
    run = json.loads(record.read_text())
    del run["machine"], run["tolerance"]
    record.write_text(json.dumps(run))
    assert neurosym("replay", folder, record) == 0
    assert "byte for byte" in capsys.readouterr().out
    run["machine"] = None
    record.write_text(json.dumps(run))
    change(record, 1e-3)
    assert neurosym("replay", folder, record) == 3
    said = capsys.readouterr().out
    for words in (
        "something else happened",
        "first in positions of step 1, ",
        ", by 1 mm",
        "the record does not name its machine",
    ):
        assert words in said
