"""The matrix of planners and encodings: single cells, the page, and the command that lists planners."""

import json
from pathlib import Path

import pytest
from toy_domain import grounding, problem

from neurosym.planners.registry import PROGRAMS
from tools.benchmarks.jobs import Evaluation
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


def test_page_has_a_row_for_every_planner_and_reader(tmp_path: Path):
    solved = {"status": "solved", "cell_mm": 5.0, "seconds": 1.5, "words": "", "valid": True, "steps": 3}
    failed = {"status": "failed", "words": "Kairos ended with code 1: no | sense"}
    cells = {
        "kairos.strips.task-01": solved,
        "kairos.strips.task-02": failed,
        "kairos.strips.places-swap": failed,
        "pddl.numeric.task-01": {"status": "parsed"},
    }
    evaluation = Evaluation("planners", tmp_path / "work", tmp_path)
    for name, cell in cells.items():
        evaluation.path(name).write_text(json.dumps(cell))
    matrix.write_results(evaluation, ["task-01", "task-02", "places-swap"], 30.0, 10)
    text = (tmp_path / "planners.md").read_text()
    assert "**1/2**, 1 valid, 1.5 s, 3 steps, 5 mm; Kairos ended with code 1: no / sense" in text
    assert "| 0/1: Kairos ended" in text
    assert "1/1 parsed" in text
    assert "**Not finished**: 6 cells to do" in text
    for name in (*(planner.name for planner in PROGRAMS), *matrix.READERS):
        assert f"| {name} |" in text
