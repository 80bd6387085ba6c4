"""What the evaluations of planning and of learning count, and what they write before anything is measured."""

import json
from pathlib import Path

import msgspec
import pytest
from places import ROOT

from neurosym.evaluation.comparison import Attempt, TaskRecord
from neurosym.execution.performance import Execution
from neurosym.planners import PlanStatus
from neurosym.problems import Problem, SceneObject
from tools.benchmarks.domains import bench_of
from tools.benchmarks.jobs import Evaluation, pack, unpack
from tools.benchmarks.learning import evaluate as learning
from tools.benchmarks.learning import measures
from tools.benchmarks.learning.tables import page as learning_page
from tools.benchmarks.planning import summary, tables, tasks


def execution(reached: bool, **changes: object) -> Execution:
    kind = "" if reached else "a grasp failed"
    return msgspec.structs.replace(
        Execution(reached, kind, kind, {"item-01": 0.01}, 2, 1, 0, 1, 0, ()), **changes
    )


def attempt(*, valid: bool = True, blind: bool = True, replanned: bool = True, **changes: object) -> Attempt:
    found = Attempt(PlanStatus.SOLVED, "", (("push", "item-01"),), 0.2, 1, "" if valid else "elsewhere")
    runs = {"open_loop": execution(blind), "replanned": execution(replanned)}
    return msgspec.structs.replace(found, **runs, promised_miss=0.0, predicted_miss=0.0, **changes)


def record(number: int, bfs: Attempt, pddl: Attempt, **others: Attempt) -> TaskRecord[Problem]:
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
    cell = summary.table3_cell(by_seed)
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
    cell = summary.symbolic_cell(entries)
    assert cell["valid_share"] == pytest.approx(2 / 3)
    assert (cell["bfs_solves"], cell["solved_when_bfs_solves"]) == (2, 0.5)
    assert cell["solved_when_counting_solves"] == pytest.approx(2 / 3)
    assert cell["extra_steps"] == pytest.approx(2 / 3)
    assert summary.whole([cell, cell])["valid_share"] == pytest.approx(2 / 3)


@pytest.mark.parametrize("objects", [1, 6])
def test_symbolic_task_can_be_solved_and_none_of_its_objects_is_at_its_goal(objects):
    bench = bench_of(ROOT / "domains/tabletop")
    task = tasks.draw_symbolic(bench, objects, "hard", 3)
    assert task == tasks.draw_symbolic(bench, objects, "hard", 3)
    assert min(task.distances(task.scene().positions).values()) > 0.05
    assert tasks.fewest_steps(task, bench.setting.grounding)


def test_published_pages_tell_what_was_measured():
    results = ROOT / "docs/results"
    told = json.loads((results / "planning.json").read_text())
    assert tables.page(told) == (results / "planning.md").read_text()
    assert tables.scaling_page(told) == (results / "scaling.md").read_text()
    assert told["scaling"] == json.loads((results / "scaling.json").read_text())
    learned = json.loads((results / "learning.json").read_text())
    assert learning_page(learned) == (results / "learning.md").read_text()


def test_records_go_into_an_archive_and_come_back(tmp_path):
    there, back = tmp_path / "there", tmp_path / "back"
    for folder, files in ((there, {"one": "[1]\n", "other": "[2]\n"}), (back, {"other": "[3]\n"})):
        folder.mkdir()
        for name, text in files.items():
            (folder / f"{name}.json").write_text(text)
    for archive in ("a.zip", "b.zip"):
        pack(there, tmp_path / archive)
    assert (tmp_path / "a.zip").read_bytes() == (tmp_path / "b.zip").read_bytes()
    for archive in ("a.zip", "none.zip"):
        unpack(tmp_path / archive, back)
    assert {path.stem: path.read_text() for path in back.iterdir()} == {"one": "[1]\n", "other": "[3]\n"}


def test_page_says_what_is_missing_and_jobs_that_are_done_are_not_done_again(tmp_path):
    kept, asked = Evaluation("learning", tmp_path, tmp_path), []
    kept.path("one").write_text('{"a": 7}')
    kept.perform({"one": dict}, "one", lambda: asked.append(1))
    assert json.loads(kept.path("one").read_text()) == {"a": 7}
    assert not asked
    learning.write_results(kept, 1, 20)
    summary = json.loads((tmp_path / "learning.json").read_text())
    assert {"through_code_share", "table1", "table2", "command"} <= set(summary)
    count = sum(len(jobs) for jobs in learning.jobs_in_turn(Path(), 1, 20))
    assert summary["missing"] == count
    assert f"**Not finished**: {count} jobs" in (tmp_path / "learning.md").read_text()


@pytest.mark.parametrize("name", learning.VARIANTS)
def test_every_variant_can_be_learned_by(name, monkeypatch, tmp_path):
    """What teaches is the network that was kept, unless it is another one."""
    learned = []
    monkeypatch.setattr(measures, "learn", lambda *given: learned.append(given) or (None, {}))
    monkeypatch.setattr(measures.DirectModel, "load", lambda _: "kept")
    measures.variant(measures.Data(tmp_path, tmp_path, "random", 1, 10), *learning.VARIANTS[name])
    others = ("gripper values as they are", "no mirrors", "learning rate 1e-5", "everything as printed")
    assert learned[0][3] == (None if name in others else "kept")
