"""The matrix of planners and encodings: single cells, the page, and the command that lists planners."""

from pathlib import Path

import pytest
import toy_relations
from command_line import neurosym
from toy_domain import grounding, problem

from neurosym.pddl.moves import BY_RELATIONS
from neurosym.planners import PLANNERS, pddl_planner
from neurosym.planners.catalogue import PROGRAMS
from tools.benchmarks.planning import planner_matrix as matrix

TASK = problem({"item-01": (0.68, 0.08, 0.025)})


def test_cell_tells_of_a_plan_and_what_its_replay_says():
    found = matrix.measure("lama-first", "stepwise", TASK, grounding(), time_limit=30.0)
    assert (found["status"], found["valid"], found["cell_mm"]) == ("solved", True, 5.0)
    assert found["steps"] >= 1
    blocked = problem({"item-01": (0.76, 0.08, 0.025)})  # where the other one stands
    found = matrix.measure("lama-first", "stepwise", blocked, grounding(), time_limit=30.0)
    assert (found["status"], found["valid"]) == ("solved", False)
    assert "item-01 ends where item-02 is" in found["words"]


@pytest.mark.parametrize("encoding", BY_RELATIONS)
def test_tower_is_asked_for_by_relations(encoding: str):
    towers = toy_relations.tower(), toy_relations.grounding()
    found = matrix.measure("lama-first", encoding, *towers, time_limit=30.0)
    assert (found["status"], found["valid"], found["cell_mm"]) == ("solved", True, None)
    assert found["steps"] == 2
    assert (encoding, "tower") in matrix._asked({"tower": towers})
    assert ("stepwise", "tower") not in matrix._asked({"tower": towers})


def test_cell_tells_in_whose_words_an_encoding_is_refused():
    found = matrix.measure("lama-first", "numeric", TASK, grounding(), time_limit=30.0)
    assert found["status"] == "failed"
    assert "Fast Downward ended with code" in found["words"]


def test_planner_that_is_not_installed_is_a_cell_too(monkeypatch: pytest.MonkeyPatch):
    absent = pddl_planner("absent", "", lambda *_: None, missing=lambda: "`pip install absent` brings it")
    monkeypatch.setitem(PLANNERS, "absent", absent)
    found = matrix.measure("absent", "stepwise", TASK, grounding(), time_limit=1.0)
    assert found == {"status": "not installed", "words": "`pip install absent` brings it"}


@pytest.mark.parametrize("encoding", ["stepwise", "operators", "numeric"])
def test_pddl_package_reads_every_encoding_and_no_rubbish(encoding: str, monkeypatch: pytest.MonkeyPatch):
    assert matrix.measure_reader("pddl", encoding, TASK, grounding()) == {"status": "parsed", "words": ""}
    monkeypatch.setattr(matrix, "domain_text", lambda *_: "(define (domain")
    assert matrix.measure_reader("pddl", encoding, TASK, grounding())["status"] == "failed"


def test_page_has_a_row_for_every_planner_and_reader(tmp_path: Path):
    solved = {"status": "solved", "cell_mm": 5.0, "seconds": 1.5, "words": "", "valid": True, "steps": 3}
    failed = {"status": "failed", "words": "Kairos ended with code 1: no | sense"}
    cells = {"kairos.stepwise.a": solved, "kairos.stepwise.b": failed, "pddl.numeric.a": {"status": "parsed"}}
    matrix._write(cells, tmp_path, {"a": None, "b": None}, 30.0, 9)
    text = (tmp_path / "planners.md").read_text()
    assert "**1/2**, 1 valid, 1.5 s, 3 steps, 5 mm; Kairos ended with code 1: no / sense" in text
    assert "1/1 parsed" in text
    assert "**Not finished**: 6 cells to do" in text
    for name in (*(planner.name for planner in PROGRAMS), *matrix.READERS):
        assert f"| {name} |" in text


def test_command_lists_every_planner(capsys: pytest.CaptureFixture[str]):
    assert neurosym("planners") == 0
    text = capsys.readouterr().out
    assert all(name in text for name in PLANNERS)
    assert "pip install 'neurosym-pddl[planners]'" in text
