"""What the evaluation of planning counts, and what it writes before anything is measured."""

import json

import msgspec
import pytest
from places import ROOT

from neurosym.evaluation.comparison import Attempt, TaskRecord
from neurosym.execution.rerun import Execution
from neurosym.planners import PlanStatus
from neurosym.problems import Problem, SceneObject
from tools.benchmarks.jobs import Evaluation, pack, unpack
from tools.benchmarks.planning import evaluate, jobs, measures, tally, tasks

BOTH = ("bfs", "fast-downward")


def execution(reached: bool, **changes: object) -> Execution:
    kind = "" if reached else "a grasp failed"
    return msgspec.structs.replace(
        Execution(reached, kind, kind, {"item-01": 0.01}, 2, 1, 0, 1, 0, ()), **changes
    )


def attempt(*, valid: bool = True, blind: bool = True, replanned: bool = True, **changes: object) -> Attempt:
    found = Attempt(PlanStatus.SOLVED, "", (("push", "item-01"),), 0.2, 1, "" if valid else "elsewhere")
    runs = {"open_loop": execution(blind), "replanned": execution(replanned)}
    return msgspec.structs.replace(found, **runs, promised_miss=0.0, predicted_miss=0.0, **changes)


def record(number: int, bfs: Attempt, pddl: Attempt, **others: Attempt) -> TaskRecord:
    item = SceneObject("item-01", "00", (0.05, 0.05, 0.05, 0.0), (0.6, 0.0, 0.025))
    problem = Problem(f"drawn-{number:05d}", (item,), {"item-01": (0.7, 0.0, 0.025)})
    return TaskRecord(problem, False, {"bfs": bfs, "fast-downward": pddl, **others})


NO_PLAN = Attempt(PlanStatus.UNSOLVABLE, "too far")


def test_table3_is_the_mean_over_seeds_of_shares_of_all_tasks():
    good, bad = attempt(), attempt(valid=False, blind=False, replanned=False)
    by_seed = {
        "1": [record(0, good, good), record(1, bad, good)],
        "2": [record(0, NO_PLAN, attempt(blind=False)), record(1, bad, good)],
    }
    cell = tally.table3_cell(by_seed, BOTH)
    bfs, pddl = cell["bfs"], cell["fast-downward"]
    assert (bfs["found"], bfs["valid"], bfs["reached"]) == (0.75, 0.25, 0.25)
    assert (pddl["reached"], pddl["reached_with_replanning"]) == (0.75, 1.0)
    assert pddl["spread"]["reached"] == pytest.approx(0.25)
    assert pddl["by_seed"]["2"]["reached"] == 0.5
    assert pddl["tasks"] == 4


def test_symbolic_shares_are_of_the_tasks_that_the_other_planner_solves():
    def entry(number: int, pddl: Attempt, searched: Attempt, exact: Attempt) -> dict:
        kept = record(number, NO_PLAN, pddl, counting=exact, **{"bfs-operators": searched})
        return {"record": msgspec.to_builtins(kept), "fewest": 1}

    longer = attempt(primitives=3)
    entries = [
        entry(0, attempt(), attempt(), attempt()),
        entry(1, NO_PLAN, attempt(), attempt()),
        entry(2, longer, NO_PLAN, attempt()),
        entry(3, attempt(valid=False), NO_PLAN, NO_PLAN),
    ]
    cell = tally.symbolic_cell(entries)
    assert cell["valid_share"] == pytest.approx(2 / 3)
    assert (cell["bfs_solves"], cell["solved_when_bfs_solves"]) == (2, 0.5)
    assert cell["solved_when_counting_solves"] == pytest.approx(2 / 3)
    assert cell["extra_steps"] == pytest.approx(2 / 3)
    assert tally.whole([cell, cell])["valid_share"] == pytest.approx(2 / 3)


def test_disturbed_runs_without_a_plan_or_a_nudge_are_told_apart():
    run = msgspec.to_builtins(execution(False))
    entries = [
        {"task": "a", "solvable": False},
        {"task": "b", "solvable": True, "nudge": None, "run": run},
        {"task": "c", "solvable": True, "nudge": {"object": "item-01"}, "run": run},
        {"task": "d", "solvable": True, "nudge": {"object": "item-01"}, "run": {**run, "reached": True}},
    ]
    cell = tally.disturbed(entries)
    assert (cell["without_plan"], cell["nudged"], cell["share"]) == (1, 2, 0.5)
    assert cell["missed"] == {"a grasp failed": 1}


def test_scaling_tells_what_was_not_tried():
    solved = {"status": "solved", "seconds": 2.0, "fewest": 4, "primitives": 5, "valid": True, "reason": ""}
    rows = [solved, {"status": "timeout", "seconds": 60.0, "fewest": 4, "reason": "late"}]
    memory = {"children": 90.0, "own": 50.0}
    cell = tally.scaling_cell({"rows": [*rows, {"status": "not tried"}], "megabytes": memory})
    assert (cell["solved"], cell["seconds"], cell["over_fewest"], cell["megabytes"]) == (1, 2.0, 1.25, 90.0)
    assert cell["status"] == {"not tried": 1, "solved": 1, "timeout": 1}


def test_nothing_measured_is_written_as_nothing_and_counted(tmp_path):
    size = jobs.size_of(1, 2560)
    evaluate.write_results(Evaluation("planning", tmp_path, tmp_path), size)
    summary = json.loads((tmp_path / "planning.json").read_text())
    keys = {"valid_share", "solved_when_bfs_solves", "table3", "planners", "scaling", "command", "versions"}
    assert keys <= set(summary)
    assert summary["table3"]["curiosity"] == {"single": {}, "double": {}}
    assert summary["valid_share"] is None
    assert f"**Not finished**: {summary['missing']} jobs" in (tmp_path / "planning.md").read_text()
    assert "not measured yet" in (tmp_path / "scaling.md").read_text()
    for name in ("planning.png", "scaling.png"):
        assert (tmp_path / name).stat().st_size > 1000


@pytest.mark.parametrize("objects", [1, 6])
def test_symbolic_task_can_be_solved_and_none_of_its_objects_is_at_its_goal(objects):

    from neurosym.planners.action_counts import fewest_steps

    bench = measures.bench_of(ROOT / "domains/tabletop")
    task = tasks.draw_symbolic(bench, objects, "hard", 3)
    assert task == tasks.draw_symbolic(bench, objects, "hard", 3)
    assert min(task.distances(task.scene().positions).values()) > 0.05
    assert fewest_steps(task, bench.setting.grounding)


def test_published_pages_tell_what_was_measured():
    from tools.benchmarks.planning.scaling_tables import scaling_page
    from tools.benchmarks.planning.tables import page
    from tools.benchmarks.planning.trial_tables import trial_sections

    results = ROOT / "docs/results"
    if not (results / "planning.json").exists():
        pytest.skip("nothing is published yet")
    summary = json.loads((results / "planning.json").read_text())
    assert page(summary, trial_sections(summary)) == (results / "planning.md").read_text()
    assert scaling_page(summary) == (results / "scaling.md").read_text()
    assert summary["scaling"] == json.loads((results / "scaling.json").read_text())


def test_records_go_into_an_archive_and_come_back(tmp_path):
    there, back = tmp_path / "there", tmp_path / "back"
    there.mkdir()
    back.mkdir()
    (there / "table3-random-2-0123abcd-50mm-1-000-10.json").write_text("[1]\n")
    (there / "other.json").write_text("[2]\n")
    (back / "other.json").write_text("[3]\n")
    pack(there, tmp_path / "a.zip")
    pack(there, tmp_path / "b.zip")
    assert (tmp_path / "a.zip").read_bytes() == (tmp_path / "b.zip").read_bytes()
    unpack(tmp_path / "a.zip", back)
    unpack(tmp_path / "none.zip", back)
    assert (back / "other.json").read_text() == "[3]\n"
    assert (back / "table3-random-2-0123abcd-50mm-1-000-10.json").read_text() == "[1]\n"
