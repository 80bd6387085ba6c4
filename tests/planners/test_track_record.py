"""What the catalogue says that planners solved is what the matrix of planners measured."""

import json

from places import DOCS

from neurosym.planners.track_record import track_record
from tools.benchmarks.planning.planner_matrix import record_of


def test_record_in_the_package_is_that_of_the_results():
    assert track_record() == record_of(json.loads((DOCS / "results/planners.json").read_text()))


def test_planner_that_fails_on_shipped_problems_is_said_to():
    assert track_record().of("lpg") == "numeric 0/2, stepwise 1/2, operators 1/2"
    assert track_record().of("fast-downward") == "stepwise 2/2, operators 2/2"
    assert track_record().of("bfs") == ""
