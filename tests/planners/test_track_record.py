"""What the catalogue says that planners solved is what the matrix of planners measured."""

import json

from places import DOCS

from neurosym.pddl.syntax import FORMER
from neurosym.planners.planner_table import TrackRecord, track_record
from tools.benchmarks.planning.planner_matrix import record_of


def test_record_in_the_package_is_that_of_the_results():
    assert track_record() == record_of(json.loads((DOCS / "results/planners.json").read_text()))


def test_encodings_that_are_gone_are_not_told():
    assert not {*FORMER} & {encoding for counts in track_record().solved.values() for encoding in counts}


def test_planner_that_fails_on_shipped_problems_is_said_to():
    record = TrackRecord(("task-01", "task-07"), 30.0, {"lpg": {"numeric": 0, "strips": 1}})
    assert record.of("lpg") == "numeric 0/2, strips 1/2"
    assert record.of("bfs") == ""


def test_what_was_not_given_to_a_planner_is_not_held_against_it():
    solved, failed = {"status": "solved"}, {"status": "timeout"}
    cells = {"lpg.numeric.task-01": failed, "lpg.strips.task-01": solved, "lpg.strips.toy-1": failed}
    record = record_of({"problems": ["toy-1", "task-01"], "time_limit": 30.0, "cells": cells})
    assert record.solved["lpg"] == {"numeric": 0, "strips": 1}
    assert record.solved["fast-downward"] == {}
