"""What the evaluation of learning writes before, and while, it is measured."""

import json
from pathlib import Path

import pytest
from places import ROOT

from tools.benchmarks.jobs import Evaluation
from tools.benchmarks.learning import evaluate, measures
from tools.benchmarks.learning.tables import page


def test_page_says_what_is_missing_and_jobs_that_are_done_are_not_done_again(monkeypatch, tmp_path):
    monkeypatch.setattr(evaluate, "CURVE", (10, 20))
    kept, asked = Evaluation("learning", tmp_path, tmp_path), []
    kept.path("one").write_text('{"a": 7}')
    kept.perform({"one": dict}, "one", lambda: asked.append(1))
    assert json.loads(kept.path("one").read_text()) == {"a": 7}
    assert not asked
    evaluate.write_results(kept, 1, 20)
    summary = json.loads((tmp_path / "learning.json").read_text())
    assert {"through_code_share", "table1", "table2", "command"} <= set(summary)
    count = sum(len(jobs) for jobs in evaluate.jobs_in_turn(Path(), 1, 20))
    assert summary["missing"] == count
    assert f"**Not finished**: {count} jobs" in (tmp_path / "learning.md").read_text()
    assert (tmp_path / "learning.png").stat().st_size > 1000


def test_published_page_tells_what_was_measured():
    results = ROOT / "docs/results"
    assert page(json.loads((results / "learning.json").read_text())) == (results / "learning.md").read_text()


@pytest.mark.parametrize("name", evaluate.VARIANTS)
def test_every_variant_can_be_learned_by(name, monkeypatch, tmp_path):
    """What teaches is the network that was kept, unless it is another one."""
    learned = []
    monkeypatch.setattr(measures, "learn", lambda *given: learned.append(given) or (None, {}))
    monkeypatch.setattr(measures.DirectModel, "load", lambda _: "kept")
    measures.variant(measures.Data(tmp_path, tmp_path, "random", 1, 10), *evaluate.VARIANTS[name])
    others = ("gripper values as they are", "no mirrors", "learning rate 1e-5", "everything as printed")
    assert learned[0][3] == (None if name in others else "kept")
