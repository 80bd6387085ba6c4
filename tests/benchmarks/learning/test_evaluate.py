"""What the evaluation of learning writes before, and while, it is measured."""

import json
from pathlib import Path

import pytest
from places import ROOT

from tools.benchmarks.jobs import Evaluation
from tools.benchmarks.learning import evaluate


@pytest.fixture
def evaluation(monkeypatch):
    monkeypatch.setattr(evaluate, "CURVE", (10, 20))
    return evaluate


def test_page_says_what_is_missing_and_jobs_that_are_done_are_not_done_again(evaluation, tmp_path):
    (tmp_path / "jobs").mkdir()
    (tmp_path / "jobs/one.json").write_text('{"a": 7}')
    asked = []
    kept = Evaluation("learning", tmp_path, tmp_path)
    kept.perform({"one": dict}, "one", lambda: asked.append(1))
    assert json.loads((tmp_path / "jobs/one.json").read_text()) == {"a": 7}
    assert not asked
    evaluation.write_results(kept, 1, 20)
    summary = json.loads((tmp_path / "learning.json").read_text())
    assert {"through_code_share", "table1", "table2", "command"} <= set(summary)
    count = sum(len(jobs) for jobs in evaluation.jobs_in_turn(Path(), 1, 20))
    assert summary["missing"] == count
    assert f"**Not finished**: {count} jobs" in (tmp_path / "learning.md").read_text()
    assert (tmp_path / "learning.png").stat().st_size > 1000


def test_published_page_tells_what_was_measured(evaluation):
    from tools.benchmarks.learning.tables import page

    results = ROOT / "docs/results"
    assert page(json.loads((results / "learning.json").read_text())) == (results / "learning.md").read_text()
