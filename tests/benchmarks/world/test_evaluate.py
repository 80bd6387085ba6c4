"""What takes minutes of physics: run by `make evaluate`, each figure printed with -s."""

import pytest

from neurosym.commands.cli import main
from neurosym.files import read_json
from neurosym.sim.tabletop import Tabletop
from neurosym.stages.plan_records import PlanRecord
from neurosym.worlds.workers import perform_all
from tools.benchmarks.world import measures

pytestmark = pytest.mark.evaluation


def test_most_of_the_effect_survives_a_tenth_of_a_millimetre():
    found = measures.predictability(1000, 77, 2)
    print(found)
    assert found["share"] > 0.97


def test_held_objects_are_put_down_where_they_hung_and_object_and_hand_decide_who_is_held():
    tasks = measures.random_tasks(3000, 78)
    found = measures.random_outcomes([*perform_all(Tabletop, tasks, 2)])
    print(found)
    assert found["put_down_within_1cm"] >= 0.98
    assert found["held_by_kind"]["open, too wide"] > 10 * found["held_by_kind"]["solid, too wide"]
    assert found["below_the_table"] == 0


def test_thousand_curious_steps_lead_to_an_executed_plan(tmp_path):
    with pytest.raises(SystemExit) as ended:
        main(["run", str(tmp_path / "domain"), "--steps", "1024", "--seed", "7"])
    assert ended.value.code == 0
    records = [read_json(path, PlanRecord) for path in (tmp_path / "domain/plans").glob("*.json")]
    assert any(record.steps for record in records)
    assert list((tmp_path / "domain/runs").glob("*.run.json"))
