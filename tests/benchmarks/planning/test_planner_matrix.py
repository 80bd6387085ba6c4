"""The matrix of planners and encodings: single cells, the page, and the command that lists planners."""

from pathlib import Path

import pytest
import toy_relations
from command_line import neurosym
from toy_domain import grounding, problem

from neurosym.planners import PLANNERS, pddl_planner
from neurosym.planners.planner_table import PROGRAMS
from tools.benchmarks.planning import planner_matrix as matrix

TASK = problem({"item-01": (0.68, 0.08, 0.025)})


@pytest.mark.parametrize(("encoding", "cell"), [("strips", 10.0), ("sas", 5.0)])
def test_cell_tells_of_a_plan_and_what_its_replay_says(encoding: str, cell: float):
    found = matrix.measure("lama-first", encoding, TASK, grounding(), time_limit=30.0)
    assert (found["status"], found["valid"], found["cell_mm"]) == ("solved", True, cell)
    assert found["steps"] >= 1
    blocked = problem({"item-01": (0.76, 0.08, 0.025)})  # where the other one stands
    found = matrix.measure("lama-first", encoding, blocked, grounding(), time_limit=30.0)
    assert (found["status"], found["valid"]) == ("solved", False)
    assert "item-01 ends where item-02 is" in found["words"]


def test_tower_is_asked_for_on_the_page_alone():
    towers = toy_relations.tower(), toy_relations.grounding()
    found = matrix.measure("lama-first", "strips", *towers, time_limit=30.0)
    assert (found["status"], found["valid"], found["cell_mm"]) == ("solved", True, None)
    assert found["steps"] == 2
    given = {**matrix._with_relations(), **matrix._toy()}
    assert [encoding for encoding, name in matrix._asked(given) if name == "relations-tower"] == ["strips"]
    assert [encoding for encoding, name in matrix._asked(given) if name == "toy-1"] == [
        "strips",
        "numeric",
        "sas",
    ]


def test_sas_is_given_only_to_who_reads_it():
    assert matrix._reads("lama-first", "sas")
    assert not matrix._reads("kairos", "sas")
    assert matrix._reads("kairos", "strips")


def test_cell_tells_in_whose_words_an_encoding_is_refused():
    found = matrix.measure("lama-first", "numeric", TASK, grounding(), time_limit=30.0)
    assert found["status"] == "failed"
    assert "Fast Downward ended with code" in found["words"]


def test_planner_that_is_not_installed_is_a_cell_too(monkeypatch: pytest.MonkeyPatch):
    absent = pddl_planner("absent", "", lambda *_: None, missing=lambda: "`pip install absent` brings it")
    monkeypatch.setitem(PLANNERS, "absent", absent)
    found = matrix.measure("absent", "strips", TASK, grounding(), time_limit=1.0)
    assert found == {"status": "not installed", "words": "`pip install absent` brings it"}


@pytest.mark.parametrize(
    ("reader", "encoding"),
    [("pddl", "numeric"), ("unified-planning", "strips"), ("unified-planning", "numeric")],
)
def test_readers_read_what_is_printed_and_no_rubbish(
    reader: str, encoding: str, monkeypatch: pytest.MonkeyPatch
):
    assert matrix.measure_reader(reader, encoding, TASK, grounding()) == {"status": "parsed", "words": ""}
    monkeypatch.setattr(matrix, "domain_text", lambda *_, **__: "(define (domain")
    assert matrix.measure_reader(reader, encoding, TASK, grounding())["status"] == "failed"


def test_reader_that_takes_prices_for_numeric_fluents_is_quoted():
    found = matrix.measure_reader("pddl", "strips", TASK, grounding())
    assert found["status"] == "failed"
    assert "numeric-fluents requirement is not specified" in found["words"]


def test_page_has_a_row_for_every_planner_and_reader(tmp_path: Path):
    solved = {"status": "solved", "cell_mm": 5.0, "seconds": 1.5, "words": "", "valid": True, "steps": 3}
    failed = {"status": "failed", "words": "Kairos ended with code 1: no | sense"}
    cells = {
        "kairos.strips.task-01": solved,
        "kairos.strips.task-02": failed,
        "kairos.strips.places-swap": failed,
        "pddl.numeric.task-01": {"status": "parsed"},
    }
    matrix._write(cells, tmp_path, {"task-01": None, "task-02": None, "places-swap": None}, 30.0, 10)
    text = (tmp_path / "planners.md").read_text()
    assert "**1/2**, 1 valid, 1.5 s, 3 steps, 5 mm; Kairos ended with code 1: no / sense" in text
    assert "| 0/1: Kairos ended" in text
    assert "1/1 parsed" in text
    assert "**Not finished**: 6 cells to do" in text
    for name in (*(planner.name for planner in PROGRAMS), *matrix.READERS):
        assert f"| {name} |" in text


def test_command_lists_every_planner(capsys: pytest.CaptureFixture[str]):
    assert neurosym("planners") == 0
    text = capsys.readouterr().out
    assert all(name in text for name in PLANNERS)
    assert "pip install 'neurosym-pddl[planners]'" in text
